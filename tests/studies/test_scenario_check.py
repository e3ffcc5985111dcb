"""Numbers that `springback check` derives from a scenario, against flights and formulas."""

import math
from pathlib import Path

import numpy as np
import pytest

import springback
from springback.scenario.scenario import scenario_from
from springback.scenario.warnings import scenario_warnings
from springback.studies.approach import approach_ahead
from springback.studies.scenario_check import (
    check_warnings,
    derived_numbers,
    hover_share,
    stop_speed,
)

OWN = Path(__file__).parents[2] / "examples/own_vehicle.toml"


def scenario(*overrides: str) -> springback.Scenario:
    return springback.read_scenario(OWN, overrides)


def number(name: str, *overrides: str) -> float:
    [found] = [one.value for one in derived_numbers(scenario(*overrides)) if one.name == name]
    return found


@pytest.mark.parametrize("stiffness", ["1 N/mm", "3 N/mm"])
@pytest.mark.parametrize("damping", ["10 N s/m", "60 N s/m"])  # ζ below and above 1
def test_an_arm_ahead_uses_up_its_stroke_from_the_estimated_speed_on(
    stiffness: str, damping: str
) -> None:
    words = [f"vehicle.arms.stiffness={stiffness}", f"vehicle.arms.damping={damping}"]
    words.append("simulation.duration=0.15")
    estimate = stop_speed(scenario(*words).vehicle, 0)
    below, above = (
        springback.fly(OWN, *words, f"start.velocity.0={share * estimate}", trajectory=False)
        for share in (0.92, 1.08)
    )
    assert below.outcome is springback.Outcome.SEPARATED
    assert above.outcome is springback.Outcome.ARM_BOTTOMED


def test_the_estimate_is_continuous_where_damping_is_critical() -> None:
    vehicle = scenario().vehicle
    rest = vehicle.mass - 0.04
    critical = 2.0 * math.sqrt(3000.0 * rest)
    speeds = [
        stop_speed(scenario(f"vehicle.arms.damping={critical * share}").vehicle, 0)
        for share in (1.0 - 1e-5, 1.0, 1.0 + 1e-5)
    ]
    assert speeds[0] == pytest.approx(speeds[1], rel=1e-4)
    assert speeds[2] == pytest.approx(speeds[1], rel=1e-4)
    assert speeds[1] == pytest.approx(0.035 * math.sqrt(3000.0 / rest) * math.e, rel=1e-4)


def test_numbers_of_the_arms_and_masses() -> None:
    assert number("mass") == pytest.approx(0.55 + 4 * 0.04)
    assert number("inertia about z") == pytest.approx(2.6e-3 + 4 * 0.04 * 0.16**2)
    assert number("inertia share") == pytest.approx(2.6e-3 / (0.55 * 0.25**2))
    assert number("natural frequency") == pytest.approx(math.sqrt(3000 / 0.04) / math.tau)
    assert number("damping ratio") == pytest.approx(60 / (2 * math.sqrt(3000 * 0.04)))
    assert number("hover thrust share") == pytest.approx(0.71 * 9.81 / 16.8)
    assert number("gap between cages") == pytest.approx(0.16 * math.sqrt(2.0) - 0.18)
    share = number("stroke until cages touch")  # the ends of the arms are 2 r apart
    assert (0.16 - share * 0.035) * math.sqrt(2.0) == pytest.approx(0.18)


def test_a_payload_counts_for_the_thrust() -> None:
    loaded = scenario("payload.mass=0.3")
    assert hover_share(loaded) == pytest.approx(1.01 * 9.81 / 16.8)


def test_arms_that_differ_have_their_own_numbers_and_rigid_ones_none() -> None:
    words = 'vehicle.arms.stiffness=["3 N/mm", "3 N/mm", "5 N/mm", "5 N/mm"]'
    assert number("natural frequency of arm 1, 2", words) < number(
        "natural frequency of arm 3, 4", words
    )
    names = [one.name for one in derived_numbers(scenario("vehicle.arms.compliant=false"))]
    assert not [name for name in names if "frequency" in name or "stroke" in name]


def test_the_force_along_an_arm_is_less_by_what_friction_holds() -> None:
    ahead, aside = approach_ahead(scenario()), approach_ahead(scenario("start.yaw=0"))
    assert ahead is not None
    assert aside is not None
    assert (ahead.arm, ahead.speed) == (1, 2.0)
    assert ahead.along == pytest.approx(1.0)
    assert aside.along == pytest.approx(math.cos(math.pi / 4) * (1.0 - 0.4))


@pytest.mark.parametrize(
    ("overrides", "word"),
    [
        (["start.yaw=0"], "it hardly slides"),
        (["start.velocity.0=6"], "the stroke of arm 2 is used up, by an estimate from 4.98 m/s"),
        (["vehicle.propulsion.max_thrust=2.2"], "hover takes 79.1 %"),
        (["vehicle.body.inertia=[0.1, 0.1, 0.19]"], "is 5.53 times the mass and the square"),
        (
            ["vehicle.hulls=[{type='sphere', radius=0.05, surface={stiffness=1e4, exponent=1, "
             "viscosity=2e3, in_series=false}}]"],
            "times what is critical for its stiffness and the vehicle's mass",
        ),
        (
            ["vehicle.limits={components=[{name='camera', position=[9, 0, 0], "
             "specific_force=100}]}"],
            "vehicle.limits.components[0] is 9 m from the middle",
        ),
        (["vehicle.body.inertia=[1e-4, 1e-4, 1e-4]"], "is 0.00291 times the mass and the square"),
        (
            ["reference.type=run-up", "reference.speed=2", "start.position=[0, 0, 1]",
             "start.velocity=[0, 0, 0]"],
            "is met first, 0.75 m before that",
        ),
    ],
)  # fmt: skip
def test_a_warning_for_what_can_be_flown_and_is_seldom_meant(
    overrides: list[str], word: str
) -> None:
    assert check_warnings(scenario()) == []
    assert [line for line in check_warnings(scenario(*overrides)) if word in line]


def test_the_viscosity_that_an_overdamped_contact_is_advised_gives_no_warning() -> None:
    def told(viscosity: float) -> list[str]:
        hull = "{type='sphere', radius=0.05, surface={stiffness=1e4, exponent=1, viscosity="
        hull += f"{viscosity:g}, in_series=false}}}}"
        return check_warnings(scenario(f"vehicle.hulls=[{hull}]"))

    [line] = [line for line in told(2e3) if "do not use peak accelerations" in line]
    advised = float(line.rpartition("at most ")[2].removesuffix(" N s/m"))
    assert not [line for line in told(0.99 * advised) if "peak" in line]
    assert [line for line in told(1.02 * advised) if "peak" in line]


@pytest.mark.parametrize(
    ("hull", "radius", "passes"),
    [(0.03, 0.012, True), (0.03, 0.022, False), (0.05, 0.012, False)],
)
def test_a_rod_thinner_than_the_gap_beside_an_arm_is_told_to_pass(
    hull: float, radius: float, passes: bool
) -> None:
    """The hull ends at 30 mm and the cage of each arm begins at 70 mm, 40 mm on."""
    rod = {"type": "capsule", "name": "rope", "start": [1.5, 0, 0], "end": [1.5, 0, 2],
           "radius": radius, "surface": "wall"}  # fmt: skip
    pillar = {"type": "box", "position": [1.5, 1, 1], "size": [0.1, 0.2, 2.0], "surface": "wall"}
    tables = {
        "vehicle": {"preset": "arq", "hull": {"radius": hull},
                    "arms": {"length": 0.16, "cage_radius": 0.09}},
        "world": {"obstacles": [pillar, rod]},
    }  # fmt: skip
    told = [line for line in check_warnings(scenario_from(tables)) if "can pass between" in line]
    assert len(told) == passes
    if passes:
        assert told[0].startswith(
            "world.obstacles[1], rope (0.024 m thick) can pass between the hull and the cage of arm "
            "1, 2, 3, 4, 0.04 m apart along the arm"
        )
    skid = {"type": "capsule", "start": [0.03, 0, 0], "end": [0.07, 0, 0], "radius": 0.004}
    closed = {**tables, "vehicle": {**tables["vehicle"], "hulls": [skid]}}
    assert not [x for x in check_warnings(scenario_from(closed)) if "can pass between" in x]


def test_frequency_and_damping_are_said_to_be_of_one_arm() -> None:
    about = {one.name: one.about for one in derived_numbers(scenario())}
    for name in ("natural frequency", "damping ratio"):
        assert about[name].startswith("of one arm on its spring, the body held")


def test_numbers_of_one_arm_are_said_to_leave_out_springs_to_its_neighbours() -> None:
    names = {"natural frequency", "damping ratio", "speed that uses up the stroke"}
    for words in ((), ("vehicle.arms.neighbours.stiffness=1 N/mm",)):
        about = {one.name: one.about for one in derived_numbers(scenario(*words))}
        told = {name for name, text in about.items() if "neighbouring arms are left out" in text}
        assert told == (names if words else set())


@pytest.mark.parametrize("pitch", [0.0, -0.5])
def test_a_run_up_meets_the_wall_at_the_yaw_that_it_holds(pitch: float) -> None:
    """Not at that of the start, from which it turns away."""
    words = [
        "reference.type=run-up", "reference.speed=2", "start.position=[0, 0, 1]",
        "start.velocity=[0, 0, 0]", f"reference.pitch={pitch}",
    ]  # fmt: skip
    turned, straight = (
        approach_ahead(scenario(*words, *more)) for more in (["reference.yaw=45 deg"], [])
    )
    assert turned is not None
    assert straight is not None
    assert (turned.arm, turned.speed) == (1, 2.0)
    assert straight.angle == pytest.approx(math.pi / 4)
    # Tilted, body x leans back from the wall and body y does not.
    leaning = math.atan(1.0 / math.cos(pitch)) - math.pi / 4
    assert turned.angle == pytest.approx(leaning, abs=1e-9)
    assert turned.along > 0.9 > straight.along


def test_three_rotors_turn_no_vehicle_about_its_axis() -> None:
    """It is flown, and spins; without torques nothing turns it."""
    arms = {"directions": ["0 deg", "120 deg", "240 deg"], "torque_ratio": 0.016}
    tables = {
        "vehicle": {"preset": "arq", "arms": arms, "propulsion": {"max_thrust": 20.0}},
        "reference": {"type": "hold"},
    }
    [said] = scenario_warnings(scenario_from(tables))
    assert said.startswith("the 3 rotors cannot give lift, roll, pitch and yaw independently")
    tables["vehicle"]["arms"] = arms | {"torque_ratio": 0.0}
    assert scenario_warnings(scenario_from(tables)) == []
    tables["vehicle"] = "arq"
    assert scenario_warnings(scenario_from(tables)) == []


@pytest.mark.parametrize("directions", [["0 deg"], ["0 deg", "180 deg"]])
def test_one_or_two_rotors_give_no_roll_or_pitch(directions: list[str]) -> None:
    """A row without numbers ended the check in the linear algebra."""
    arms = {"directions": directions, "torque_ratio": 0.016}
    vehicle = {"preset": "arq", "arms": arms, "propulsion": {"max_thrust": 40.0}}
    said = scenario_warnings(scenario_from({"vehicle": vehicle, "reference": {"type": "hold"}}))
    assert any("cannot give lift, roll and pitch independently" in one for one in said)


def test_arms_that_can_fold_into_each_other_are_told() -> None:
    """The gap is the smallest of all places of both, here of a fine grid of angles."""
    joint = {"type": "hinge", "position": [0.06, 0, 0], "axis": [0, 0, 1], "stiffness": 1.0}
    for most, meets in ((0.1, False), (0.6, True)):
        arms = {"joint": joint | {"travel": [-most, most]}}
        folding = scenario_from({"vehicle": {"preset": "arq", "arms": arms}, "thrust": "hover"})
        turns = np.linspace(-most, most, 200)
        ends = 0.06 + 0.13 * np.exp(1j * turns)
        own = folding.vehicle.arms
        apart = np.abs(ends[:, None] - np.exp(0.5j * np.pi) * ends[None]).min()
        gap = apart - 2.0 * own.at("cage_radius", 0)
        [found] = [
            x.value for x in derived_numbers(folding) if x.name == "gap between cages that move"
        ]
        assert found == pytest.approx(gap, abs=1e-3)
        assert (found < 0.0) is meets
        told = [line for line in check_warnings(folding) if "arms can fold until" in line]
        assert bool(told) is meets


RAISED = ("vehicle.arms.cage_radius=0.12", "vehicle.arms.height=[0, 0.03, 0, 0.03]")


@pytest.mark.parametrize("height", [0.03, 0.05])
@pytest.mark.parametrize("length", [0.16, 0.18])  # over each other seen from above, and aside
def test_cages_at_different_heights_are_as_far_apart_as_their_circles(
    height: float, length: float
) -> None:
    words = (
        "vehicle.arms.cage_radius=0.12", f"vehicle.arms.height=[0, {height}, 0, {height}]",
        f"vehicle.arms.length={length}", "start.position=[1, 0, 1]",
    )  # fmt: skip
    turns = np.linspace(0.0, math.tau, 2000)
    circle = 0.12 * np.stack([np.cos(turns), np.sin(turns), 0.0 * turns], axis=1)
    other = circle + np.array([length * math.sqrt(2.0), 0.0, height])
    gap = min(np.linalg.norm(other - point, axis=1).min() for point in circle)
    assert number("gap between cages", *words) == pytest.approx(gap, abs=1e-5)


def test_arms_that_slide_past_each_other_at_their_heights_are_not_told_to_meet() -> None:
    assert number("gap between cages that move", *RAISED) == pytest.approx(0.01)  # opposite arms
    assert not [line for line in check_warnings(scenario(*RAISED)) if "arms can fold" in line]
    level = ("vehicle.arms.height=[0, 0.0005, 0, 0.0005]", "vehicle.arms.stroke=0.05")
    assert [line for line in check_warnings(scenario(*level)) if "arms can fold" in line]


def test_arms_that_rise_into_the_height_of_others_meet_there() -> None:
    joint = {"type": "slide", "direction": [0, 0, 1], "travel": [0, 0.15], "stiffness": 500.0}
    arms = {"height": [0.0, 0.2, 0.0, 0.2], "length": 0.16, "cage_radius": 0.12, "joint": joint}
    for travel, meets in ((0.15, False), (0.25, True)):
        joint["travel"] = [[0, travel], [0, 0.05], [0, travel], [0, 0.05]]
        given = scenario_from({"vehicle": {"preset": "arq", "hull": False, "arms": arms}})
        [found] = [
            x.value for x in derived_numbers(given) if x.name == "gap between cages that move"
        ]
        if meets:
            assert found == pytest.approx(0.16 * math.sqrt(2.0) - 0.24)
        else:
            assert found == pytest.approx(0.05)


def test_cages_that_tilt_as_they_fold_are_taken_as_balls() -> None:
    joint = {"type": "hinge", "axis": [0, -1, 0], "travel": [0, 0.6], "stiffness": 1.0}
    given = scenario_from({"vehicle": {"preset": "arq", "hull": False, "arms": {"joint": joint}}})
    [found] = [x.value for x in derived_numbers(given) if x.name == "gap between cages that move"]
    assert found == pytest.approx(0.19 * math.cos(0.6) * math.sqrt(2.0) - 0.22, abs=1e-3)
