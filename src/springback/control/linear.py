"""Stability of a set of gains: the cascade linearised about hover, one axis at a time.

Axes decouple about hover, and a controller that knows the inertia commands the angular acceleration
directly; so the eigenvalues hold for x, y and z of any vehicle of the same mass and rotor lag.
"""

from __future__ import annotations

import math
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.polynomial import Polynomial

from springback.control.parameters import ControlSettings

Axis = Literal["horizontal", "vertical", "yaw"]
AXES: tuple[Axis, ...] = ("horizontal", "vertical", "yaw")
S = Polynomial([0.0, 1.0])


class Transfer(NamedTuple):
    """A transfer function in the Laplace variable s."""

    numerator: Polynomial
    denominator: Polynomial


def delay(duration: float) -> Transfer:
    """Padé's second-order approximation of e^(−s T), T = ``duration`` [s]."""
    t = S * duration
    return Transfer(12.0 - 6.0 * t + t**2, 12.0 + 6.0 * t + t**2)


def rate_loop(settings: ControlSettings, rotor_lag: float) -> Transfer:
    """Transfer from ω_sp to ω: ω̇ is (k_ω + k_i/s)(ω_sp − H ω) − d s H ω after the rotors' lag.

    H is the gyroscope filter.
    """
    k, i, d = settings.rate_gain, settings.rate_integral, settings.rate_derivative
    order = S if i > 0.0 else Polynomial([1.0])  # common factor of all but the integral's terms
    filtered = 1.0 + settings.gyro_lag() * S
    given = k * order + i
    plant = S * order * (1.0 + rotor_lag * S)
    return Transfer(given * filtered, plant * filtered + given + d * S * order)


def attitude_loop(settings: ControlSettings, rotor_lag: float, time_constant: float) -> Transfer:
    """Transfer from desired to actual angle: ω_sp is the error, held between runs, over τ."""
    rate = rate_loop(settings, rotor_lag)
    held = delay(0.5 / settings.attitude_frequency + 0.5 / settings.rate_frequency)
    forward = rate.numerator * held.numerator
    return Transfer(forward, time_constant * S * rate.denominator * held.denominator + forward)


def characteristic(
    settings: ControlSettings, axis: Axis, mass: float, rotor_lag: float
) -> Polynomial:
    """Characteristic polynomial of the closed loop of an axis.

    m s² = −(K_p + K_v s + K_i/s) e^(−s T) A(s), with A the attitude loop for x and y and the lag of
    rotors for z; T is the offboard delay plus half a period of the position loop, the mean time for
    which a command is held.
    """
    if axis == "yaw":
        tau = settings.yaw_time_constant if settings.attitude == "reduced" else None
        return attitude_loop(settings, rotor_lag, tau or settings.time_constant).denominator
    horizontal, vertical = settings.damping_for(mass)
    if axis == "vertical":
        kp, kv = settings.vertical_stiffness, vertical
        inner = Transfer(Polynomial([1.0]), 1.0 + rotor_lag * S)
    else:
        kp, kv = settings.stiffness, horizontal
        inner = attitude_loop(settings, rotor_lag, settings.time_constant)
    late = delay(settings.offboard_delay + 0.5 / settings.position_frequency)
    ki = settings.integral
    order = S if ki > 0.0 else Polynomial([1.0])
    plant = mass * S**2 * order * inner.denominator * late.denominator
    closed: Polynomial = plant + ((kp + kv * S) * order + ki) * inner.numerator * late.numerator
    return closed


def loop_eigenvalues(
    settings: ControlSettings, axis: Axis, mass: float, rotor_lag: float
) -> np.ndarray[Any, np.dtype[np.complex128]]:
    """Eigenvalues of the linearised loop of an axis, the least stable first [1/s].

    Args:
        settings: Gains, rates and delays.
        axis: ``horizontal``, ``vertical`` or ``yaw``.
        mass: Mass of the vehicle [kg].
        rotor_lag: Time constant of the rotors' thrust [s].
    """
    roots = characteristic(settings, axis, mass, rotor_lag).trim().roots().astype(np.complex128)
    ordered: np.ndarray[Any, np.dtype[np.complex128]] = roots[np.argsort(-roots.real)]
    return ordered


def warnings_for(settings: ControlSettings, mass: float, rotor_lag: float) -> list[str]:
    """A sentence for each axis whose linearised loop is unstable, if any."""
    sentences = []
    for axis in AXES:
        worst = loop_eigenvalues(settings, axis, mass, rotor_lag)[0]
        if worst.real > 0.0:
            frequency = abs(worst.imag) / (2.0 * math.pi)
            swing = f", oscillating at {frequency:.3g} Hz" * bool(worst.imag)
            sentences.append(
                f"gains make the linearised {axis} loop unstable: eigenvalue "
                f"{worst.real:+.3g} 1/s{swing} (mass {mass:g} kg, rotor lag {rotor_lag:g} s)"
            )
    return sentences
