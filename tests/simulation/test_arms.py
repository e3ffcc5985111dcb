"""Arms in a flight: hybrid and always free, end stops, bottoming out, rigid and compliant."""

from __future__ import annotations

import numpy as np
import pytest

from builders.impacts import flown, value
from springback.results.flight import as_scenario, fly
from springback.simulation.flight import fly_one
from springback.simulation.measuring.measures import Outcome

COMPARED = (
    "restitution_at_separation", "restitution_at_return", "peak_acceleration", "contact_time",
    "travel", "arm_stroke", "loss_contact", "loss_friction",
)  # fmt: skip


@pytest.mark.parametrize("yaw", ["0 deg", "20 deg", "45 deg"])
def test_locked_arms_in_free_flight_change_nothing_of_an_impact(yaw: str) -> None:
    """Hybrid and always-free are the same impact, to the tolerances at which arms count as settled."""
    hybrid = flown("arq", yaw=yaw)
    free = flown("arq", "model.arms=always-free", yaw=yaw)
    for name in COMPARED:
        assert value(hybrid, name) == pytest.approx(value(free, name), rel=1e-5, abs=1e-9)
    for column, tolerance in (("x", 1e-5), ("vx", 1e-4), ("wz", 1e-3)):
        end = hybrid.columns[column][-1]
        assert end == pytest.approx(free.columns[column][-1], abs=tolerance)
    assert value(hybrid, "steps") < value(free, "steps")
    assert abs(value(hybrid, "loss_settling")) < 1e-5 * value(hybrid, "energy_start")


@pytest.mark.parametrize("damping", [2.0, 90.0])
@pytest.mark.parametrize("yaw", ["0 deg", "45 deg"])
def test_an_arm_cannot_extend_past_its_free_length(damping: float, yaw: str) -> None:
    """But for the give of the stop itself, half a millimetre at these speeds."""
    flight = flown("arq", f"vehicle.arms.damping={damping}", yaw=yaw)
    assert value(flight, "arm_extension") < 5e-4
    assert flight.bottomed_time is None
    loose = flown("arq", f"vehicle.arms.damping={damping}", "vehicle.arms.end_stops=false", yaw=yaw)
    if damping < 10.0:
        assert value(loose, "arm_extension") > 1e-3


def test_bottoming_out_is_an_event_and_an_outcome() -> None:
    """With a short stroke; the stop takes over, and the time is that at which it is reached."""
    flight = flown("arq", "vehicle.arms.stroke=10 mm", yaw="45 deg")
    assert flight.outcome is Outcome.ARM_BOTTOMED
    assert 0.010 < value(flight, "arm_stroke") < 0.0125
    pressed = np.flatnonzero(flight.columns["l2"] < 0.18 + 1e-9)
    assert value(flight, "bottomed_time") == flight.t[pressed[0]]
    assert value(flight, "loss_stop") > 0.0
    enough = flown("arq", "vehicle.arms.stroke=25 mm", yaw="45 deg")
    assert enough.outcome is Outcome.SEPARATED
    assert enough.bottomed_time is None
    assert value(flight, "peak_acceleration") > 1.3 * value(enough, "peak_acceleration")


def test_bottoming_out_comes_with_speed() -> None:
    """The paper's stroke is enough at 2 m/s and not at 7 m/s; without stops nothing bottoms out."""
    assert flown("arq", yaw="45 deg").outcome is Outcome.SEPARATED
    assert flown("arq", speed=7.0, yaw="45 deg").outcome is Outcome.ARM_BOTTOMED
    endless = flown("arq", "vehicle.arms.end_stops=false", speed=7.0, yaw="45 deg")
    assert endless.outcome is Outcome.SEPARATED
    assert value(endless, "arm_stroke") > 0.05


def test_rigid_is_one_parameter() -> None:
    """`compliant=false` is the vehicle whose arms belong to its body."""
    smooth = "world.obstacles[0].surface.friction=0"
    rigid = flown("arq", "vehicle.arms.compliant=false", smooth, pitch="10 deg", yaw="20 deg")
    whole = as_scenario({"vehicle": "arq"}).vehicle
    body = f"vehicle.body.inertia={np.round(whole.inertia(), 15).tolist()}"
    lumped = flown(
        "arq", "vehicle.arms.compliant=false", "vehicle.arms.mass=0",
        f"vehicle.body.mass={whole.mass}", body, smooth, pitch="10 deg", yaw="20 deg",
    )  # fmt: skip
    for name in ("peak_acceleration", "travel", "restitution_at_separation", "peak_angular_rate"):
        assert value(rigid, name) == pytest.approx(value(lumped, name), rel=1e-9)
    assert value(rigid, "arm_stroke") == 0.0
    assert value(rigid, "loss_arm") == 0.0


def test_stiff_arms_are_rigid_arms() -> None:
    """The stiffer the arms, the nearer the rigid vehicle: the difference falls as 1/k.

    Without friction, which makes sliding arms creep below its slip speed however stiff they are.
    """
    smooth = "world.obstacles[0].surface.friction=0"
    rigid = flown("arq", "vehicle.arms.compliant=false", smooth)
    gaps = []
    for k in (2e5, 8e5):
        stiff = flown(
            "arq",
            smooth,
            f"vehicle.arms.stiffness={k}",
            "simulation.impact_step=2e-5",
            "simulation.settle_step=2e-5",
        )
        gaps.append(abs(value(stiff, "travel") - value(rigid, "travel")))
    assert gaps[1] < gaps[0] / 3.0
    assert gaps[1] < 1e-4


def test_compliance_softens_the_blow() -> None:
    """At one and the same mass: less acceleration, longer contact, less rebound."""
    soft, hard = (
        fly_result
        for fly_result in (
            flown("arq", yaw="45 deg"),
            flown("arq", "vehicle.arms.compliant=false", yaw="45 deg"),
        )
    )
    assert value(soft, "peak_acceleration") < 0.6 * value(hard, "peak_acceleration")
    assert value(soft, "contact_time") > 1.5 * value(hard, "contact_time")
    assert value(soft, "loss_arm") > 0.0


def test_three_and_six_arms_fly() -> None:
    """Any number of arms in any direction, in plain Python; the ledger closes for each."""
    for count in (3, 6):
        directions = [f"{360.0 * j / count} deg" for j in range(count)]
        scenario = {
            "vehicle": {
                "body": {"mass": 1.0, "inertia": [0.01, 0.01, 0.02]},
                "arms": {
                    "directions": directions, "length": 0.19, "mass": 0.05, "cage_radius": 0.08,
                    "stiffness": "5 N/mm", "damping": 90.0,
                },
            },
            "world": {"obstacles": [{"type": "wall", "distance": 1.0, "surface": "wall"}]},
            "start": {"position": [0.7295, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0]},
            "simulation": {"duration": 0.02, "impact_step": 2e-4},
        }  # fmt: skip
        flight = fly(scenario, executor="python")
        assert flight.outcome is Outcome.IN_CONTACT
        assert value(flight, "contacts") == 1.0
        assert value(flight, "arm_stroke") > 1e-3
        assert abs(value(flight, "ledger_residual")) < 1e-6
        assert f"l{count}" in flight.columns
        assert f"l{count + 1}" not in flight.columns


@pytest.mark.parametrize("mode", ["hybrid", "always-free"])
def test_arms_that_start_bent_and_moving_are_in_the_ledger(mode: str) -> None:
    """No energy appears when a flight begins with compressed, moving arms, whatever the model."""
    scenario = as_scenario(
        {
            "vehicle": "arq",
            "model": {"arms": mode},
            "simulation": {"duration": 0.2, "settle_step": 5e-5},  # resolves the fast first swing
        },
    )
    start = scenario.start_state()
    start = start._replace(arm_length=(0.18,) * 4, arm_rate=(0.1, 0.0, 0.0, 0.0))
    flown = fly_one(scenario.flight_model(), start)
    work = flown.motion.work
    lost = work.arm + work.stop + work.settling
    assert flown.before.total - flown.after.total == pytest.approx(lost, abs=1e-6)
    assert flown.motion.state.arm_length == pytest.approx((0.19,) * 4, abs=2e-5)
