"""Run-ups arrive at the wall with the speed and pitch that were asked for."""

import math

import numpy as np
import pytest

import springback
from springback.control.parameters import ControlSettings
from springback.control.position import heading
from springback.errors import InputError
from springback.kernels.vectors import Quat, Vec, rotation
from springback.studies.run_ups import (
    CONDITIONS,
    Arrival,
    arrivals_table,
    run_up_errors,
    run_up_scenario,
)

#: What was asked of a run-up.
SPEED, PITCH = 0.1, math.radians(2.0)  # [m/s], [rad]
PERFECT = {"type": "perfect"}


def arrival(vehicle: str, pitch: float, speed: float, **tables: object) -> Arrival:
    scenario = run_up_scenario(vehicle, pitch, speed, **{"estimator": PERFECT, **tables})
    return run_up_errors(springback.fly(scenario))


@pytest.mark.parametrize("vehicle", ["arq", "quad"])
@pytest.mark.parametrize(("pitch", "speed"), CONDITIONS)
def test_a_run_up_arrives_as_asked(vehicle: str, pitch: float, speed: float) -> None:
    """Perfect estimates: what is left is what the controller's own lags leave."""
    was = arrival(vehicle, pitch, speed)
    assert was.speed == pytest.approx(speed + was.speed_error)
    assert abs(was.speed_error) < SPEED
    assert abs(was.pitch_error) < PITCH
    assert abs(was.height_error) < 0.03


@pytest.mark.parametrize(("pitch", "speed"), [(0.0, 2.0), (-30.0, 2.0)])
@pytest.mark.parametrize("start", ["45 deg", 0.0])
def test_a_run_up_meets_the_wall_with_the_yaw_that_it_holds(
    pitch: float, speed: float, start: str | float
) -> None:
    """With one arm straight ahead, which is pressed alone; the recovery keeps the yaw."""
    scenario = run_up_scenario("arq", pitch, speed, estimator=PERFECT, recovery={})
    scenario["reference"]["yaw"] = "45 deg"
    scenario["start"] = {**scenario.get("start", {}), "yaw": start}
    scenario["simulation"]["duration"] = 6.0
    flight = springback.fly(scenario)
    touch = flight.touch_time
    assert touch is not None
    k = int(np.searchsorted(flight.t, touch)) - 1
    at = [flight.columns[f"q{part}"][k] for part in "wxyz"]
    ahead = rotation(Quat(*map(float, at))).x  # world X in body axes
    tilt = Vec(math.sin(math.radians(pitch)), 0.0, math.cos(math.radians(pitch)))
    wanted = heading(tilt, math.pi / 4).axes.x
    assert math.acos(min(1.0, ahead @ wanted)) < 1.5 * PITCH  # pitch and yaw together
    assert flight.columns["vx"][k] == pytest.approx(speed, abs=SPEED)
    forces = [float(flight.columns[f"fn{j}"][: k + 40].max()) for j in (1, 2, 3, 4)]
    assert [j for j, force in enumerate(forces, start=1) if force > 1.0] == [2]
    assert flight.outcome is springback.Outcome.RECOVERED
    w, z = (float(flight.columns[f"q{part}"][-1]) for part in "wz")
    assert math.degrees(2.0 * math.atan2(z, w)) == pytest.approx(45.0, abs=3.0)


@pytest.mark.parametrize("vehicle", ["arq", "quad"])
@pytest.mark.parametrize(("pitch", "speed"), CONDITIONS)
def test_a_run_up_arrives_as_asked_with_sensors_and_filter(
    vehicle: str, pitch: float, speed: float
) -> None:
    """The sensors' noise and delays add less than 0.02 m/s and 0.5 deg to what the controller leaves."""
    was = arrival(vehicle, pitch, speed, estimator={"type": "kalman"}, seed=3)
    assert abs(was.speed_error) < SPEED + 0.02
    assert abs(was.pitch_error) < PITCH + math.radians(0.5)


def test_without_feed_forward_it_does_not() -> None:
    """So the bounds above are no accident of a slow run-up: the loops lag far behind a fast one."""
    was = arrival("quad", -45.0, 2.0, control={"feed_forward": False})
    assert abs(was.speed_error) > 10.0 * SPEED
    assert abs(was.pitch_error) > 10.0 * PITCH


@pytest.mark.parametrize(
    "leads", [(0.0, 0.0), ("tilt_lead", "tilt_lead")], ids=["neither", "tilt only"]
)
def test_both_leads_are_needed(
    leads: tuple[object, object], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without one of them the hardest run-up arrives worse; without either it misses by far."""

    def badness() -> float:
        was = arrival("arq", -45.0, 2.0, control={"rate_integral": 0.0})
        return max(abs(was.speed_error) / SPEED, abs(was.pitch_error) / PITCH)

    with_both = badness()
    tilt = ControlSettings.tilt_lead
    for name, lead in zip(("tilt_lead", "rate_lead"), leads, strict=True):
        law = tilt if isinstance(lead, str) else lambda settings: 0.0
        monkeypatch.setattr(ControlSettings, name, law)
    assert badness() > (1.2 * with_both if "tilt_lead" in leads else 1.3)


def test_leads_are_those_of_the_loops() -> None:
    """Delay and half of two holds; then 1/k_ω less the filter's 5.3 ms; nothing where nothing is fed."""
    settings = ControlSettings(
        offboard_delay=0.01,
        attitude_frequency=250.0,
        rate_gain=25.0,
        gyro_cutoff=30.0,
        rate_integral=0.0,
    )
    law = settings.model_copy(update={"feed_forward": True}).position_law(1.0, 9.81)
    assert law.tilt_lead == pytest.approx(0.017)
    assert law.rate_lead == pytest.approx(0.017 + 0.04 - 0.005305, abs=1e-6)
    held = settings.model_copy(update={"feed_forward": True, "rate_integral": 50.0})
    assert held.position_law(1.0, 9.81).rate_lead == pytest.approx(0.017)
    still = settings.position_law(1.0, 9.81)
    assert still.tilt_lead == still.rate_lead == 0.0


def test_feed_forward_is_for_run_ups_only_unless_asked_for() -> None:
    """Steps give neither jerk nor acceleration: with and without, the same flight bit for bit."""
    scenario = {
        "vehicle": "quad",
        "reference": {"type": "steps"},
        "estimator": PERFECT,
        "simulation": {"duration": 1.0},
    }
    ends = [
        springback.fly({**scenario, "control": control}).measures
        for control in ({}, {"feed_forward": False}, {"feed_forward": True})
    ]
    assert ends[0] == ends[1] == ends[2]


def test_arrivals_are_asked_of_run_ups_that_arrive() -> None:
    flight = springback.fly(
        {"vehicle": "quad", "thrust": "hover", "simulation": {"duration": 0.01}}
    )
    with pytest.raises(InputError, match="run-up"):
        run_up_errors(flight)
    short = run_up_scenario("quad", 0.0, 2.0, simulation={"duration": 0.1}, estimator=PERFECT)
    with pytest.raises(InputError, match="touched nothing"):
        run_up_errors(springback.fly(short))


def test_the_table_tells_degrees_and_signs() -> None:
    was = Arrival(2.05, math.radians(-44.0), 0.05, math.radians(1.0), 0.5, -0.01, 1.0)
    assert "| ARQ | 2.050 | +0.050 | -44.00 | +1.00 | +29 | -0.010 |" in arrivals_table(
        [("ARQ", was)]
    )
