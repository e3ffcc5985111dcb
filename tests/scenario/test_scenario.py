"""Scenarios: units, presets, overrides, and that all ways of writing one mean the same."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

from springback.contact.laws.restitution import restitution
from springback.errors import InputError
from springback.results.flight import as_scenario, fly
from springback.scenario.warnings import scenario_warnings
from springback.simulation.measuring.measures import Outcome
from springback.vehicle.library import VEHICLES

BASE: dict[str, Any] = {
    "vehicle": "arq",
    "world": {"obstacles": [{"type": "wall", "distance": 2.75, "surface": "wall"}]},
    "start": {"position": [2.2, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0]},
}


@pytest.mark.parametrize(
    ("field", "text", "number"),
    [
        ("vehicle.arms.stiffness", "5 N/mm", 5000.0),
        ("vehicle.arms.length", "190 mm", 0.19),
        ("vehicle.arms.damping", "90 N*s/m", 90.0),
        ("vehicle.body.mass", "1204 g", 1.204),
        ("start.pitch", "45 deg", math.pi / 4),
        ("simulation.duration", "300 ms", 0.3),
        ("world.gravity", "9.81 m/s^2", 9.81),
        ("world.obstacles[0].distance", "275 cm", 2.75),
        ("world.obstacles[0].surface.slip_speed", "10 cm/s", 0.1),
    ],
)
def test_units_mean_si_numbers(field: str, text: str, number: float) -> None:
    """A value with a unit and the plain SI number give the same scenario."""
    with_unit = as_scenario(BASE, (f'{field}="{text}"',)).model_dump(mode="json")
    unquoted = as_scenario(BASE, (f"{field}={text}",)).model_dump(mode="json")
    plain = as_scenario(BASE, (f"{field}={number!r}",)).model_dump(mode="json")
    assert unquoted == with_unit

    def leaves(node: Any) -> list[Any]:
        if isinstance(node, dict):
            return [leaf for value in node.values() for leaf in leaves(value)]
        if isinstance(node, list):
            return [leaf for value in node for leaf in leaves(value)]
        return [float(f"{node:.12g}") if isinstance(node, float) else node]

    assert leaves(with_unit) == leaves(plain)


def test_overrides_apply_in_order_and_touch_nothing_else() -> None:
    """The last one wins; a preset can be replaced and then adjusted."""
    scenario = as_scenario(
        BASE, ("vehicle=quad", "vehicle.body.mass=1 kg", "vehicle.body.mass=1.5", "name=mine")
    )
    assert scenario.name == "mine"
    assert scenario.vehicle.name == "quad"
    assert scenario.vehicle.body.mass == 1.5
    assert scenario.vehicle.arms == VEHICLES["quad"].vehicle.arms
    assert BASE["vehicle"] == "arq"


def test_an_override_of_the_attitude_replaces_the_other_notation() -> None:
    """A file's angles give way to a quaternion, and a quaternion to angles; other keys remain."""
    height = {"position": [0.0, 0.0, 2.0]}
    turned = {**BASE, "start": {**height, "pitch": "10 deg", "yaw": "20 deg"}}
    level = as_scenario(turned, ("start.quaternion=[1, 0, 0, 0]",)).start
    assert level.quaternion == (1.0, 0.0, 0.0, 0.0)
    assert level.position[2] == 2.0
    upside_down = {**BASE, "start": {**height, "quaternion": [0.0, 1.0, 0.0, 0.0]}}
    nose_down = as_scenario(upside_down, ("start.pitch=15 deg",)).start
    assert nose_down.quaternion is None
    assert nose_down.pitch == pytest.approx(math.radians(15.0))
    with pytest.raises(InputError, match="cannot be combined with a pitch"):
        as_scenario(BASE, ("start.pitch=15 deg", "start.quaternion=[1, 0, 0, 0]"))


def test_a_preset_with_changes_keeps_the_rest() -> None:
    """`preset` beside other keys, in tables as in overrides."""
    tables = {**BASE, "vehicle": {"preset": "arq", "arms": {"stiffness": "6 N/mm"}}}
    arms = as_scenario(tables).vehicle.arms
    assert arms == as_scenario(BASE, ("vehicle.arms.stiffness=6000",)).vehicle.arms
    assert arms.stiffness == 6000.0
    assert arms.damping == VEHICLES["arq"].vehicle.arms.damping


def test_a_surface_preset_can_be_damped_otherwise() -> None:
    """Its restitution gives way to a dissipation, and to another restitution at its own speed."""
    word = "world.obstacles[0].surface"
    given = as_scenario(BASE, (f"{word}.dissipation=0.3",)).world.obstacles[0].surface
    assert given.dissipation_value() == 0.3
    asked = as_scenario(BASE, (f"{word}.restitution=0.4", f"{word}.restitution_speed=3 m/s"))
    c_a = asked.world.obstacles[0].surface.dissipation_value()
    assert restitution(c_a, 3.0) == pytest.approx(0.4)


@pytest.mark.parametrize("e", [0.01, 0.03, 0.5, 0.99])
def test_asked_restitution_is_what_the_surface_has(e: float) -> None:
    """From nearly dead to nearly elastic."""
    word = "world.obstacles[0].surface"
    asked = as_scenario(BASE, (f"{word}.restitution={e}", f"{word}.restitution_speed=2"))
    c_a = asked.world.obstacles[0].surface.dissipation_value()
    assert restitution(c_a, 2.0) == pytest.approx(e, abs=1e-9)


def test_stiffness_is_shared_by_the_front() -> None:
    """k_c belongs to the whole front; each of two cages has half."""
    model = as_scenario(BASE).flight_model()
    assert model.world.obstacles[0].surface.stiffness == 1e5
    alone = as_scenario(BASE, ("world.obstacles[0].surface.shared_by=1",)).flight_model()
    assert alone.world.obstacles[0].surface.stiffness == 2e5


def test_a_file_and_its_tables_are_one_scenario(tmp_path: Path) -> None:
    """TOML is only another way to write the tables."""
    path = tmp_path / "scenario.toml"
    path.write_text(
        'vehicle = "arq"\n'
        "[[world.obstacles]]\n"
        'type = "wall"\ndistance = "2.75 m"\nsurface = "wall"\n'
        "[start]\n"
        'position = ["2200 mm", 0, 1]\nvelocity = ["7.2 km/h", 0, 0]\n'
    )
    from_file, from_tables = as_scenario(path), as_scenario(BASE)
    assert from_file.start.velocity == pytest.approx(from_tables.start.velocity)
    assert from_file.vehicle == from_tables.vehicle
    assert from_file.world == from_tables.world


def test_wall_by_distance_and_by_position() -> None:
    """`distance` is short for a wall across X; the length of the normal does not count."""
    wall = {
        "type": "wall",
        "surface": "wall",
        "position": [2.75, 7.0, 0.0],
        "normal": [-3.0, 0.0, 0.0],
    }
    placed = as_scenario({**BASE, "world": {"obstacles": [wall]}}).flight_model()
    assert placed.world.obstacles == as_scenario(BASE).flight_model().world.obstacles


def test_hover_thrust_is_the_weight() -> None:
    """Shared by all rotors; none without gravity."""
    scenario = as_scenario(BASE, ("thrust=hover",))
    assert sum(scenario.flight_model().thrust) == pytest.approx(scenario.vehicle.mass * 9.81)
    assert (
        as_scenario(BASE, ("thrust=hover", "world.gravity=0")).flight_model().thrust == (0.0,) * 4
    )
    single = as_scenario(BASE, ('thrust=["1 N", 2, 3, "0.004 kN"]',)).flight_model().thrust
    assert single == pytest.approx((1.0, 2.0, 3.0, 4.0))


def test_an_empty_world_is_touched_nowhere() -> None:
    """No obstacle at all: the flight is a parabola, and the outcome says that nothing was hit."""
    flight = fly(BASE, "world.obstacles=[]", "simulation.duration=0.1")
    assert flight.outcome is Outcome.NO_CONTACT
    assert flight.measures["restitution_at_separation"] is None
    assert flight.columns["x"][-1] == pytest.approx(2.4)
    assert flight.columns["z"][-1] == pytest.approx(1.0 - 0.5 * 9.81 * 0.01)


def test_summary_holds_what_is_needed_to_repeat_the_flight() -> None:
    """The scenario in the summary flies to the same numbers."""
    first = fly(BASE, "simulation.duration=0.05")
    again = fly(first.summary()["scenario"])
    assert again.measures == first.measures


def test_a_flight_reads_like_its_measures() -> None:
    """Attributes, outcome and repr; an error for an unknown name lists the known ones."""
    flight = fly(BASE, "simulation.duration=0.3")
    assert flight.travel == flight.measures["travel"]
    assert flight.success
    assert flight.message in repr(flight)
    with pytest.raises(AttributeError, match="peak_acceleration"):
        _ = flight.peak_accelleration


RUN_UP: dict[str, Any] = {"vehicle": "arq", "reference": {"type": "run-up", "speed": 2.0}}


def test_a_run_up_begins_where_the_vehicle_does_unless_it_has_a_start_of_its_own() -> None:
    high = as_scenario(RUN_UP, ("start.position.2=3 m",))
    assert high.reference.start == high.start.position == (0.0, 0.0, 3.0)
    assert as_scenario(RUN_UP).reference.start == (0.0, 0.0, 1.0)
    assert scenario_warnings(high) == []
    own = as_scenario(RUN_UP, ("start.position.2=3 m", "reference.start=[0, 0, 2]"))
    assert own.reference.start == (0.0, 0.0, 2.0)
    assert "reference.start is 1 m from start.position" in scenario_warnings(own)[0]


def test_a_run_up_has_time_to_arrive_unless_told_how_long() -> None:
    """Half a second is for a throw; the run-up alone takes longer."""
    assert as_scenario(RUN_UP).simulation.duration == 6.0
    assert as_scenario({**RUN_UP, "simulation": {"free_step": 2e-3}}).simulation.duration == 6.0
    assert as_scenario(RUN_UP, ("simulation.duration=0.3 s",)).simulation.duration == 0.3
    assert as_scenario({"vehicle": "arq"}).simulation.duration == 0.5


def test_a_run_up_that_arrives_after_the_end_is_warned_of() -> None:
    """And one after which the recovery has no time to settle."""
    slow = ("reference.speed=1 m/s", "simulation.duration=5 s")
    [said] = scenario_warnings(as_scenario(RUN_UP, slow))
    assert said.endswith(
        "reaches the wall at 5.63 s and the flight ends at 5 s, so that nothing is hit"
    )
    recovers = {**RUN_UP, "recovery": {}}
    [said] = scenario_warnings(as_scenario(recovers, (slow[0],)))
    assert "reaches the wall at 5.63 s and the flight ends at 6 s; a recovery settles" in said
    assert scenario_warnings(as_scenario(RUN_UP, (slow[0],))) == []
    assert scenario_warnings(as_scenario(recovers, ("reference.speed=2 m/s",))) == []


def test_a_recovery_from_a_jump_of_velocity_is_warned_of() -> None:
    """The impulse law moves no arm, which the trigger waits for."""
    jump = {"type": "wall", "distance": 2.75, "surface": {"law": "impulse", "restitution": 0.5}}
    there = {**RUN_UP, "world": {"obstacles": [jump]}}
    [said] = scenario_warnings(as_scenario({**there, "recovery": {}}))
    assert said.startswith("world.obstacles[0]: its impulse law changes velocities at once")
    assert scenario_warnings(as_scenario(there)) == []


def test_a_run_up_turns_away_from_a_yaw_at_the_start_and_says_so() -> None:
    turned = as_scenario(RUN_UP, ("start.yaw=45deg",))
    [said] = scenario_warnings(turned)
    assert "start.yaw is 45 deg, and the run-up turns the vehicle to 0 deg on its way" in said
    assert scenario_warnings(as_scenario(RUN_UP, ("start.yaw=5deg",))) == []
    both = ("start.yaw=-175deg", "reference.yaw=180deg")
    assert scenario_warnings(as_scenario(RUN_UP, both)) == []
    assert scenario_warnings(as_scenario(RUN_UP, both[1:]))
    same = ("start.yaw=45deg", "reference.yaw=45deg")
    assert scenario_warnings(as_scenario(RUN_UP, same)) == []


def test_an_offset_moves_the_vehicle_and_not_its_run_up() -> None:
    aside = as_scenario(RUN_UP, ("start.offset=[0, 0.05, 0]",))
    assert aside.reference.start == (0.0, 0.0, 1.0)
    assert aside.start_state().position == (0.0, 0.05, 1.0)


def test_a_bad_position_is_one_problem_although_a_run_up_begins_there() -> None:
    with pytest.raises(InputError) as caught:
        as_scenario(RUN_UP, ('start.position=[0, 0, "3 kg"]',))
    [problem] = caught.value.problems
    assert "start.position: has the wrong unit (got '3 kg')" in problem


def test_suction_without_a_wall_is_warned_of() -> None:
    ground = {"type": "ground", "surface": "wall"}
    wall = {"type": "wall", "distance": 3.0, "surface": "wall"}
    said = "wall_suction: there is no wall that could draw a rotor, as the scenario has no obsta"
    for suction, obstacles, count in (
        (0.09, [], 1), (0.09, [ground], 1), (0.09, [ground, wall], 0), (0.0, [ground], 0),
    ):  # fmt: skip
        effect = {"wall_suction": suction}
        given = {
            "vehicle": {"preset": "arq", "propulsion": {"surface_effect": effect}},
            "start": {"position": [0, 0, 1]}, "world": {"obstacles": obstacles},
        }  # fmt: skip
        found = scenario_warnings(as_scenario(given))
        assert len(found) == count
        assert all(said in line for line in found)
