"""Linearised loops against simulated ones with true delays and holds; settings and their messages."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from pydantic_core import PydanticCustomError

from springback.control.linear import AXES, Axis, delay, loop_eigenvalues, warnings_for
from springback.control.parameters import ControlSettings
from springback.errors import InputError
from springback.sensing.measurement import task_pace

QUAD_MASS, ARQ_MASS, ROTOR_LAG = 1.22, 1.41, 0.03


def simulated(settings: ControlSettings, axis: Axis, mass: float, h: float = 1e-4) -> np.ndarray:
    """Position (or yaw) after a small start, with loops that run and hold at their own rates.

    Written as the cascade runs, not as transfer functions: no Padé, no polynomials.
    """
    ticks = {name: round(1.0 / (getattr(settings, f"{name}_frequency") * h)) for name in
             ("position", "attitude", "rate")}  # fmt: skip
    late = round(settings.offboard_delay / h)
    tau = settings.yaw_time_constant if axis == "yaw" else settings.time_constant
    horizontal, vertical = settings.damping_for(mass)
    kp, kv = (
        (settings.vertical_stiffness, vertical)
        if axis == "vertical"
        else (settings.stiffness, horizontal)
    )
    p, v, angle, omega, felt, push = 1.0, 0.0, 1.0 if axis == "yaw" else 0.0, 0.0, 0.0, 0.0
    command, wanted, moment, queue, path = 0.0, 0.0, 0.0, [0.0] * (late + 1), []
    steady = 0.0
    for k in range(round(6.0 / h)):
        if k % ticks["position"] == 0:
            command = -(kp * p + kv * v) / mass
        queue.append(command)
        arrived = queue.pop(0)
        felt += h / settings.gyro_lag() * (omega - felt)
        if k % ticks["attitude"] == 0:
            wanted = ((0.0 if axis == "yaw" else arrived) - angle) / tau
        if k % ticks["rate"] == 0:
            steady += settings.rate_integral * (wanted - felt) * h * ticks["rate"]
            moment = settings.rate_gain * (wanted - felt) + steady
        if axis == "vertical":
            push += h / ROTOR_LAG * (arrived - push)
            v += h * push
        else:
            push += h / ROTOR_LAG * (moment - push)
            omega += h * push
            angle += h * omega
            v += h * angle  # gravity and the mass's weight cancel: m p̈ = F with the lag of the tilt
        p += h * v
        path.append(angle if axis == "yaw" else p)
    return np.array(path[:: round(1e-2 / h)])


def dominant(path: np.ndarray, order: int, step: float = 1e-2) -> complex:
    """The slowest mode in the tail of a path, by linear prediction (Prony)."""
    tail = path[100:350]
    rows = np.column_stack([tail[k : len(tail) - order + k] for k in range(order)])
    fit = np.linalg.lstsq(rows, tail[order:], rcond=None)[0]
    roots = np.roots([1.0, *(-fit[::-1])])
    poles = np.log(roots.astype(complex)) / step
    return complex(max(poles, key=lambda s: s.real))


@pytest.mark.parametrize(
    ("axis", "changes", "modes"),
    [
        # A real mode decays nearly as slowly as the swinging pair; with the integral there are two, and
        # linear prediction cannot part them: it is tried on yaw.
        ("horizontal", {"rate_integral": 0.0}, 3),
        ("horizontal", {"stiffness": 25.0, "damping": 9.0, "rate_integral": 0.0}, 3),
        ("horizontal", {"stiffness": 60.0, "damping": 12.0}, 2),
        ("vertical", {}, 2),
        ("vertical", {"vertical_stiffness": 150.0, "vertical_damping": 10.0}, 2),
        ("yaw", {}, 2),
    ],
)
def test_eigenvalues_are_those_of_the_simulated_loop(axis: Axis, changes: Any, modes: int) -> None:
    """Within 3 %: holds count as half a period of delay, which is what they are at low frequency."""
    settings = ControlSettings(**changes)
    expected = loop_eigenvalues(settings, axis, QUAD_MASS, ROTOR_LAG)[0]
    found = dominant(simulated(settings, axis, QUAD_MASS), modes)
    assert found.real == pytest.approx(expected.real, abs=0.03 * abs(expected))
    assert abs(found.imag) == pytest.approx(abs(expected.imag), abs=0.03 * abs(expected))


def test_defaults_are_stable_for_both_robots() -> None:
    for mass in (QUAD_MASS, ARQ_MASS):
        assert warnings_for(ControlSettings(), mass, ROTOR_LAG) == []
        for axis in AXES:
            assert loop_eigenvalues(ControlSettings(), axis, mass, ROTOR_LAG)[0].real < -1.0


def test_unstable_gains_are_named() -> None:
    (sentence,) = warnings_for(ControlSettings(stiffness=60.0, damping=12.0), 1.22, 0.03)
    assert sentence.startswith("gains make the linearised horizontal loop unstable: eigenvalue +")
    assert "Hz" in sentence
    undamped = warnings_for(ControlSettings(vertical_damping=0.0), 1.22, 0.03)
    assert len(undamped) == 1
    assert "vertical" in undamped[0]


def test_without_lags_the_loop_is_a_mass_on_a_spring() -> None:
    """m s² + K_v s + K_p, as all lags go to zero."""
    fast = ControlSettings(
        offboard_delay=0.0, position_frequency=1e7, attitude_frequency=1e7, rate_frequency=1e7,
        gyro_cutoff=0.0, rate_gain=1e5, rate_integral=0.0, time_constant=1e-4,
    )  # fmt: skip
    for axis, kp, kv in (("horizontal", 11.2, 7.1), ("vertical", 26.0, 10.6)):
        settings = fast.model_copy(update={"stiffness": 11.2, "damping": 7.1,
                                           "vertical_stiffness": 26.0, "vertical_damping": 10.6})  # fmt: skip
        got = loop_eigenvalues(settings, axis, QUAD_MASS, 1e-6)[:2]  # type: ignore[arg-type]
        expected = np.roots([QUAD_MASS, kv, kp])
        np.testing.assert_allclose(np.sort_complex(got), np.sort_complex(expected), rtol=2e-3)


def test_integrals_only_add_an_eigenvalue() -> None:
    """As K_i → 0 it goes to zero as −K_i/K_p, and the others stay."""
    for axis, name, ratio in (
        ("horizontal", "integral", 1.0 / ControlSettings().stiffness),
        ("yaw", "rate_integral", 1.0 / ControlSettings().rate_gain),
    ):
        without = {"integral": 0.0, "rate_integral": 0.0}
        plain = loop_eigenvalues(ControlSettings(**without), axis, 1.22, 0.03)  # type: ignore[arg-type]
        small = ControlSettings(**{**without, name: 1e-4})
        more = loop_eigenvalues(small, axis, 1.22, 0.03)  # type: ignore[arg-type]
        assert more[0] == pytest.approx(-1e-4 * ratio, rel=1e-3)
        np.testing.assert_allclose(np.sort_complex(more[1:]), np.sort_complex(plain), rtol=1e-3)


def test_delay_has_unit_gain_and_the_phase_of_a_delay() -> None:
    d = delay(0.02)
    for omega in (1.0, 10.0, 50.0):
        value = d.numerator(1j * omega) / d.denominator(1j * omega)
        assert abs(value) == pytest.approx(1.0)
        assert np.angle(value) == pytest.approx(-0.02 * omega, rel=1e-2)


def test_schedule_counts_ticks() -> None:
    """Each loop, and the delay."""
    usual = ControlSettings().schedule(1000.0)
    assert usual == (task_pace(10.0), task_pace(4.0), task_pace(1.0), 10.0)
    late = ControlSettings(offboard_delay="5 ms").schedule(2000.0)
    assert late == (task_pace(20.0), task_pace(8.0), task_pace(2.0), 10.0)


@pytest.mark.parametrize(
    ("clock", "changes", "message"),
    [
        (1000.0, {"attitude_frequency": 300.0}, "got 300 Hz); nearest: 250 Hz and 333.333 Hz"),
        (1000.0, {"rate_frequency": 4000.0}, "got 4000 Hz); nearest: 1000 Hz"),
        (800.0, {}, "must divide the clock's 800 Hz (got 250 Hz); nearest: 200 Hz and 266.667 Hz"),
    ],
)
def test_frequencies_that_do_not_divide_the_clock_are_refused(
    clock: float, changes: Any, message: str
) -> None:
    with pytest.raises(PydanticCustomError) as refused:
        ControlSettings(
            **{"rate_frequency": 800.0 if clock == 800.0 else 1000.0, **changes}
        ).schedule(clock)
    assert message in refused.value.message()


def test_settings_take_units_and_refuse_what_cannot_be() -> None:
    given = ControlSettings(rate_limit="220 deg/s", stiffness="9.25 N/m", offboard_delay="10 ms")
    assert given == ControlSettings()
    for bad, part in (
        ({"tilt_limit": "95 deg"}, "at most 89 deg"),
        ({"time_constant": 0.0}, "more than 0 s"),
        ({"yaw_weight": 1.5}, "at most 1"),
        ({"atitude": "lee"}, "did you mean attitude"),
    ):
        with pytest.raises(InputError, match=part):
            ControlSettings(**bad)
