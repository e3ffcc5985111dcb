"""Rotors with lag and saturation.

One law for every rotor: its thrust follows the command, limited to its bounds, with one time
constant τ.  Between two ticks the command is constant, so the response is known exactly.
"""

from __future__ import annotations

from typing import NamedTuple

from springback.kernels.compiler import kernel
from springback.kernels.exponentials import exponential
from springback.kernels.trees import field_of, select, tree_map

#: [s] Chosen: shorter time constants count as zero, so that h/τ stays finite for every duration h.
INSTANT = 1e-9
#: Chosen: for smaller h/τ the mean's share is summed as a series, exact there to 1e-14.
SHORT = 1e-3


class Rotors(NamedTuple):
    """Constants of the rotors of a vehicle, which are identical."""

    least: float  # thrust of one rotor [N]
    most: float  # thrust of one rotor [N]
    time_constant: float  # τ [s]; 0 follows immediately


class LagStep(NamedTuple):
    """Thrust of one rotor after some time under a constant command."""

    thrust: float  # at the end [N]; pass it back as the memory
    mean: float  # over the time [N]; the equations of motion use it


class Thrusts(NamedTuple):
    """Result of `lagged_thrust` for all rotors, in the order of the arms."""

    thrust: tuple[float, ...]  # at the end [N]; pass it back as the memory
    mean: tuple[float, ...]  # over the time [N]; the equations of motion use it


class Lag(NamedTuple):
    """Fractions of the initial value left after a time; equal for all ticks, computed once."""

    end: float  # e^(−x), x = h/τ
    mean: float  # (1 − e^(−x))/x


@kernel
def limited_command(rotors: Rotors, command: float) -> float:
    """Command [N], limited to the minimum and maximum thrust of one rotor."""
    above = select(command > rotors.least, command, rotors.least)
    return select(above < rotors.most, above, rotors.most)


@kernel
def lag_over(time_constant: float, duration: float) -> Lag:
    """Weights of the initial value in the final value and in the mean of a first-order lag.

    Args:
        time_constant: τ [s].
        duration: h [s]; 0 leaves the initial value unchanged, if τ is not 0.
    """
    instant = time_constant < INSTANT
    x = duration / select(instant, 1.0, time_constant)
    end = exponential(-x)
    series = 1.0 - x * (0.5 - x * (1.0 / 6.0 - x * (1.0 / 24.0)))
    mean = select(x < SHORT, series, (1.0 - end) / select(x < SHORT, 1.0, x))
    return Lag(select(instant, 0.0, end), select(instant, 0.0, mean))


@kernel
def lagged_thrust(thrust: float, command: float, rotors: Rotors, lag: Lag) -> LagStep:
    """Exact response of one rotor to a constant command u: τ Ṫ = u − T.

    T(h) = u + (T_0 − u) e^(−h/τ), and its mean over h is u + (T_0 − u) (1 − e^(−h/τ)) τ/h.  The
    rotor's torque about body z is ``Arm.torque_ratio`` times the thrust, so its mean follows as
    well.

    Args:
        thrust: T_0, at the start [N].
        command: Commanded thrust u [N]; limited to the bounds.
        rotors: Their bounds.
        lag: `lag_over` τ and h.
    """
    u = limited_command(rotors, command)
    return LagStep(u + (thrust - u) * lag.end, u + (thrust - u) * lag.mean)


@kernel
def lagged_thrusts(
    rotors: Rotors,
    thrusts: tuple[float, ...],
    commands: tuple[float, ...],
    lag: Lag,
) -> Thrusts:
    """Apply `lagged_thrust` to every rotor, in the order of the arms [N]."""
    results = tree_map(lagged_thrust, (thrusts, commands), (rotors, lag))
    return Thrusts(field_of(results, "thrust"), field_of(results, "mean"))
