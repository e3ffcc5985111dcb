"""The observer: closed forms of its lag, momentum against accelerometer, wind, impulses."""

import functools
import math
from typing import Any

import numba
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from builders.cases import nonempty
from springback.control.rate import inertia_at
from springback.kernels.trees import leaves
from springback.kernels.vectors import Quat, Vec, norm, rotation
from springback.recovery.wrench import (
    ExternalWrench,
    Observer,
    WrenchInputs,
    no_wrench,
    wrench_after,
)
from springback.sensing.measurement import Estimate, Inertial, Measurement, Pose
from springback.vehicle.library import VEHICLES

TICK, GRAVITY, GAIN = 1e-3, 9.81, 100.0
AIRFRAME = VEHICLES["arq"].vehicle.airframe()
LENGTHS = tuple(arm.length for arm in AIRFRAME.arms)
INERTIA = inertia_at(AIRFRAME, LENGTHS)
OBSERVER = Observer(
    mass=AIRFRAME.mass, gravity=GRAVITY, interval=TICK, force_gain=GAIN, moment_gain=GAIN,
    steady_gain=2.0, rotor_share=1.0, momentum=0.0, fading=5.0,
)  # fmt: skip
HOVER = (AIRFRAME.mass * GRAVITY / 4.0,) * 4
LEANING = Quat(math.cos(0.2), 0.0, math.sin(0.2), 0.0)
LEVEL = Quat(1.0, 0.0, 0.0, 0.0)


def seen(force: Vec, at: Estimate) -> Measurement:
    """What an exact accelerometer says under a hover thrust and an external force [N]."""
    r = rotation(at.attitude)
    felt = (force @ r) * (1.0 / OBSERVER.mass) + Vec(0.0, 0.0, GRAVITY)
    zero = Vec(0.0, 0.0, 0.0)
    pose = Pose(at.position, at.attitude, 1.0, 0.0)
    exact = Estimate(zero, LEVEL, zero, zero)
    return Measurement(Inertial(felt, at.angular_velocity, 1.0), pose, LENGTHS, 1.0, exact)


def inputs(measurement: Measurement, at: Estimate) -> WrenchInputs:
    return WrenchInputs(AIRFRAME, INERTIA, measurement, at, HOVER)


def pushed(
    ticks: int, force: Vec, moment: Vec, attitude: Quat = LEVEL, law: Any = wrench_after,
    **changes: float,
) -> list[ExternalWrench]:  # fmt: skip
    """The observer's words under a constant wrench, the robot held in attitude and accelerated.

    It spins up about its axes from rest; about one axis at a time the gyroscopic moment is zero.
    """
    observer, zero = OBSERVER._replace(**changes), Vec(0.0, 0.0, 0.0)
    r = rotation(attitude)
    lift = Vec(r.x.z, r.y.z, r.z.z) * (OBSERVER.mass * GRAVITY)
    rate = (force + lift - Vec(0.0, 0.0, OBSERVER.mass * GRAVITY)) * (1.0 / OBSERVER.mass)
    spin = Vec(moment.x / INERTIA.x.x, moment.y / INERTIA.y.y, moment.z / INERTIA.z.z)
    at = Estimate(zero, attitude, zero, zero)
    memory, found = no_wrench(observer, AIRFRAME, at, HOVER), []
    for k in range(1, ticks + 1):
        t = k * TICK
        at = Estimate(zero, attitude, rate * t, spin * t)
        memory = law(observer, inputs(seen(force, at), at), memory)
        found.append(memory)
    return found


FORCES = [Vec(20.0, 0.0, 0.0), Vec(0.0, -7.0, 0.0), Vec(3.0, 4.0, -5.0)]


@pytest.mark.parametrize("force", FORCES)
@pytest.mark.parametrize("attitude", [LEVEL, LEANING])
@pytest.mark.parametrize("momentum", [0.0, 1.0])
def test_a_constant_force_is_found_with_a_lag_of_first_order(
    force: Vec, attitude: Quat, momentum: float
) -> None:
    """F̂ = F (1 − e^(−K t)), in world axes, whatever the attitude; the lag is discrete."""
    told = pushed(60, force, Vec(0.0, 0.0, 0.0), attitude, momentum=momentum)
    for k, wrench in enumerate(told, start=1):
        lagged = force * (1.0 - (1.0 - GAIN * TICK) ** k)
        assert norm(wrench.force - lagged) < 1e-9 * norm(force) + 1e-9
    assert norm(told[-1].force - force) < 0.01 * norm(force)


@pytest.mark.parametrize("moment", [Vec(0.3, 0.0, 0.0), Vec(0.0, -0.2, 0.0), Vec(0.0, 0.0, 0.1)])
def test_a_constant_moment_is_found_with_the_same_lag(moment: Vec) -> None:
    told = pushed(60, Vec(0.0, 0.0, 0.0), moment)
    for k, wrench in nonempty(enumerate(told, start=1)):
        lagged = moment * (1.0 - (1.0 - GAIN * TICK) ** k)
        assert norm(wrench.moment - lagged) < 1e-9


def test_tumbling_freely_is_no_moment() -> None:
    """Euler's equations J ω̇ = −ω × J ω, by SciPy: nothing but its own spin turns the robot."""
    matrix, zero = np.array(INERTIA), Vec(0.0, 0.0, 0.0)

    def rate(_: float, omega: Any) -> Any:
        return np.linalg.solve(matrix, -np.cross(omega, matrix @ omega))

    times = np.arange(200) * TICK
    way = solve_ivp(rate, (0.0, times[-1]), [4.0, 3.0, 5.0], t_eval=times, rtol=1e-10, atol=1e-10)
    at = Estimate(zero, LEVEL, zero, Vec(*way.y[:, 0].tolist()))
    memory = no_wrench(OBSERVER, AIRFRAME, at, HOVER)
    for omega in way.y.T[1:].tolist():
        at = Estimate(zero, LEVEL, zero, Vec(*omega))
        memory = wrench_after(OBSERVER, inputs(seen(zero, at), at), memory)
    gyroscopic = np.linalg.norm(np.cross(way.y[:, 0], matrix @ way.y[:, 0]))
    assert gyroscopic > 0.1
    assert norm(memory.moment) < 0.02 * gyroscopic


def test_momentum_and_acceleration_agree_in_the_steady_state() -> None:
    force = Vec(3.0, 4.0, -5.0)
    by = [pushed(200, force, Vec(0.0, 0.0, 0.0), momentum=m)[-1].force for m in (0.0, 1.0)]
    assert norm(by[0] - by[1]) < 1e-8


def test_wind_becomes_steady_and_is_then_no_push() -> None:
    wind = Vec(2.0, -1.0, 0.0)
    told = pushed(3000, wind, Vec(0.0, 0.0, 0.0))
    begun, after = told[100], told[-1]
    assert norm(begun.force - begun.steady) > 0.7 * norm(wind)
    assert norm(after.force - after.steady) < 0.01 * norm(wind)
    # Nor is it an impulse: of 6 N s in 3 s less than that of a touch at 0.1 m/s is left.
    assert norm(after.recent.impulse) < 0.1 * OBSERVER.mass


def test_impulses_are_force_and_moment_times_time() -> None:
    """Less what fades, 5/s, and what counts as steady, 2/s: F t (1 − (5 + 2) t/2) to first order."""
    force, moment, ticks = Vec(50.0, -20.0, 0.0), Vec(0.0, 0.0, 2.0), 20
    blow = pushed(ticks, force, moment)[-1].recent
    left = ticks * TICK * (1.0 - 7.0 * ticks * TICK / 2.0)
    assert norm(blow.impulse - force * left) < 0.01 * norm(force) * left
    assert blow.turning.z == pytest.approx(2.0 * left, rel=0.01)
    # Force and moment fade alike, so that the lever arm is exact.
    assert blow.turning.z / norm(blow.impulse) == pytest.approx(2.0 / norm(force), rel=1e-9)


def test_the_carried_impulse_is_in_the_axes_of_its_time() -> None:
    force = Vec(10.0, 0.0, 0.0)
    quarter = Quat(math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5))  # body x is world Y
    blow = pushed(20, force, Vec(0.0, 0.0, 0.0), quarter)[-1].recent
    assert blow.carried.y == pytest.approx(-blow.impulse.x, rel=1e-9)
    assert abs(blow.carried.x) < 1e-9


def test_between_samples_the_estimate_stands() -> None:
    told = pushed(5, Vec(5.0, 0.0, 0.0), Vec(0.0, 0.0, 0.0))[-1]
    at = Estimate(Vec(0.0, 0.0, 0.0), LEVEL, Vec(1.0, 0.0, 0.0), Vec(0.0, 0.0, 0.0))
    stale = seen(Vec(90.0, 0.0, 0.0), at)
    stale = stale._replace(inertial=stale.inertial._replace(fresh=0.0))
    after = wrench_after(OBSERVER, inputs(stale, at), told)
    assert after == told


def test_plain_and_compiled_observers_are_twins() -> None:
    force, moment = Vec(3.0, 4.0, -5.0), Vec(0.1, 0.0, 0.0)
    plain = pushed(20, force, moment, LEANING)[-1]
    compiled = pushed(20, force, moment, LEANING, law=_twin())[-1]
    np.testing.assert_allclose(leaves(compiled), leaves(plain), rtol=0.0, atol=1e-13)


@functools.cache
def _twin() -> Any:
    @numba.njit
    def law(a: Any, b: Any, c: Any) -> Any:
        return wrench_after(a, b, c)

    return law
