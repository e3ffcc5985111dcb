"""Two vehicles in one world: momentum, energy, and the same flight from either side."""

from __future__ import annotations

from contextlib import nullcontext
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from builders.user_pilots import before_a_wall, pilot_file
from springback.batch.pair import PairOfFlights, fly_pair
from springback.contact.parameters import SurfaceSettings
from springback.contact.scene.nearest import distance_of
from springback.contact.surfaces import AnyExponent
from springback.errors import InputError, LedgerWarning
from springback.kernels.vectors import Vec
from springback.results.flight import fly
from springback.results.measures import FlightMeasures
from springback.scenario.scenario import scenario_from
from springback.simulation.pair.solids import HEIGHT, scene_of_part, solids_of
from springback.simulation.pair.stepping import NoAvionics, pair_guide

SURFACE = SurfaceSettings(law="hunt-crossley", stiffness=7e4, dissipation=0.3, friction=0.5)


def tables(x: float, speed: float, **more: Any) -> dict[str, Any]:
    """A vehicle on the X axis, without gravity and thrust."""
    start = {"position": [x, more.pop("y", 0.0), more.pop("z", 0.0)], "velocity": [speed, 0.0, 0.0]}
    return {
        "vehicle": more.pop("vehicle", "arq"),
        "world": {"gravity": more.pop("gravity", 0.0), "obstacles": more.pop("obstacles", [])},
        "start": start | {name: more.pop(name, 0.0) for name in ("yaw", "pitch")},
        "simulation": {"duration": more.pop("duration", 0.12)},
        **more,
    }  # fmt: skip


def impulse(measures: FlightMeasures) -> Any:
    """Impulse of all contacts, world [N s]."""
    return np.array([measures[f"impulse_{axis}"] for axis in "xyz"])  # type: ignore[literal-required]


MEETINGS: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "head-on": ({"x": 0.0, "speed": 1.5}, {"x": 0.7, "speed": -1.0, "yaw": np.pi}),
    "glancing": ({"x": 0.0, "speed": 1.5}, {"x": 0.6, "speed": -1.0, "yaw": 2.6, "y": 0.22}),
    "from above": ({"x": 0.0, "speed": 0.5, "pitch": 0.1},
                   {"x": 0.55, "speed": -2.0, "yaw": 3.0, "z": 0.02, "pitch": 0.1}),
    "rigid": ({"x": 0.0, "speed": 1.5, "vehicle": "quad"},
              {"x": 0.7, "speed": -1.0, "yaw": 3.0, "vehicle": "quad"}),
}  # fmt: skip


def meeting(name: str) -> PairOfFlights:
    """Both flights of a meeting."""
    first, second = MEETINGS[name]
    return fly_pair(tables(**first), tables(**second), surface=SURFACE)


@pytest.mark.parametrize("name", MEETINGS)
def test_force_and_opposite_force_are_equal(name: str) -> None:
    """Momentum is kept to rounding at every instant, and each ledger closes."""
    first, second = meeting(name)
    assert first.measures["contacts"] >= 1.0
    assert second.measures["contacts"] >= 1.0
    pushes = [np.array([f.work[f"impulse.{axis}"] for axis in "xyz"]) for f in (first, second)]
    assert np.abs(pushes[0]).max() > 0.02
    assert np.abs(pushes[0] + pushes[1]).max() < 1e-12
    assert np.array_equal(first.t, second.t)
    for flight in nonempty((first, second)):
        assert abs(flight.measures["ledger_residual"] or 0.0) < 2e-6
    given = [flight.measures["work_driven"] or 0.0 for flight in (first, second)]
    assert given[0] == pytest.approx(-given[1], abs=1e-12)
    assert abs(given[0]) > 1e-4


@pytest.mark.parametrize("name", MEETINGS)
def test_energy_of_both_together_is_kept_but_for_the_losses(name: str) -> None:
    """What both had is what both have and what was lost; neither ledger hides the other's."""
    both = meeting(name)

    def total(measure: str) -> float:
        return sum(flight.measures[measure] or 0.0 for flight in both)  # type: ignore[literal-required]

    lost = sum(
        total(measure)
        for measure in ("loss_arm", "loss_contact", "loss_friction", "loss_stop", "loss_settling")
    )
    assert lost > 0.03
    speeds = [start["speed"] for start in MEETINGS[name]]
    before = sum(
        0.5 * flight.scenario.vehicle.mass * speed**2
        for flight, speed in zip(both, speeds, strict=True)
    )
    assert total("energy_end") + lost == pytest.approx(before, rel=1e-6)


@pytest.mark.parametrize("name", MEETINGS)
def test_both_report_the_same_touch(name: str) -> None:
    """When, how fast along the normal, how deep and for how long: it is one contact."""
    first, second = meeting(name)
    for measure in nonempty(("touch_time", "touch_speed", "penetration", "contact_duration")):
        one, other = (flight.measures[measure] for flight in (first, second))  # type: ignore[literal-required]
        assert one == pytest.approx(other, rel=1e-12), measure
    assert first.measures["contacts"] == second.measures["contacts"]
    begun = [event.text for event in second.events if event.text.startswith("first touch")]
    assert begun == [
        f"first touch, at {second.touch_speed:.2f} m/s along the normal, relative to it, "
        "on the first vehicle"
    ]


def test_both_see_the_same_in_the_frame_of_the_other() -> None:
    """Adding one velocity to both changes nothing that they feel."""
    first, second = MEETINGS["head-on"]
    still = fly_pair(tables(**first), tables(**second), surface=SURFACE)
    moved = fly_pair(
        tables(**{**first, "speed": 2.5}), tables(**{**second, "speed": 0.0}), surface=SURFACE
    )
    for one, other in nonempty(zip(still, moved, strict=True)):
        for name in ("impact_peak_acceleration", "impulse_x", "touch_time", "touch_speed"):
            assert one.measures[name] == pytest.approx(other.measures[name], rel=1e-6), name


def test_apart_they_fly_alone() -> None:
    """Two vehicles that do not meet fly as each would by itself, with pilots and noise."""
    common: dict[str, Any] = {"gravity": 9.81, "duration": 0.1, "reference": {"type": "hold"}}
    tables_of = [tables(x, 0.0, z=2.0, seed=k, **common) for k, x in enumerate((0.0, 5.0))]
    together = fly_pair(*tables_of)
    for flight, each in nonempty(zip(together, tables_of, strict=True)):
        alone = fly(each)
        for axis in "xyz":  # steps as one rigid body alone, full ones together
            assert flight.columns[axis][-1] == pytest.approx(alone.columns[axis][-1], abs=1e-9)
        assert flight.telemetry["command1"].shape == alone.telemetry["command1"].shape


def test_a_hovering_robot_is_hit_and_both_meet_the_ground() -> None:
    """With pilot and recovery against one without: the alarm is raised, and its world is there."""
    floor = {"type": "ground", "surface": "wall"}
    common: dict[str, Any] = {"gravity": 9.81, "obstacles": [floor], "duration": 0.9, "z": 1.0}
    hovers = tables(0.0, 0.0, reference={"type": "hold"}, recovery={}, **common)
    comes = tables(0.8, -1.5, yaw=np.pi, **common)  # without thrust, it falls
    comes["start"]["velocity"] = [-1.5, 0.0, 1.2]
    first, second = fly_pair(hovers, comes)
    assert first.telemetry["phase"].max() > 0.0
    assert (second.measures["ground_time"] or 0.0) > (second.measures["touch_time"] or 9.0)
    assert abs(first.measures["ledger_residual"] or 0.0) < 1e-4


WRONG: dict[str, tuple[dict[str, Any], str]] = {
    "another world": ({"gravity": 1.0}, "world.gravity: must be the same"),
    "another duration": ({"duration": 0.3}, "simulation.duration: must be the same"),
    "thrusts over time": ({"thrust": {"time": [0.0, 1.0], "values": [[1.0] * 4, [2.0] * 4]}}, "second.thrust"),
}  # fmt: skip


@pytest.mark.parametrize("what", WRONG)
def test_what_cannot_fly_together_is_refused(what: str) -> None:
    """In one line that names the field."""
    changes, words = WRONG[what]
    with pytest.raises(InputError, match=words):
        fly_pair(tables(0.0, 1.0), tables(0.7, 0.0, **changes))


def test_an_own_pilot_beside_another_vehicle_is_not_cached_with_the_package(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Else a changed file would fly as it was compiled first."""
    monkeypatch.setenv("SPRINGBACK_TRUST", str(tmp_path))
    built = scenario_from(before_a_wall(f"{pilot_file(tmp_path)}:guard")).build()
    assert built.built_avionics is not None
    own = pair_guide(built.built_avionics.avionics, NoAvionics(1e-3))
    package = pair_guide(NoAvionics(1e-3), NoAvionics(1e-3))
    assert own is not package
    assert own._cache.cache_path != package._cache.cache_path


def test_far_apart_each_flies_as_if_it_were_alone() -> None:
    """Steps as one rigid body, near or far from the ground, are those of a single vehicle."""
    floor = [{"type": "ground", "surface": "wall"}]
    each = [
        tables(x, speed, z=0.8, gravity=9.81, obstacles=floor, duration=0.3, thrust="hover")
        for x, speed in ((0.0, 1.5), (60.0, -1.0))
    ]
    both = fly_pair(*each)
    for flight, given in nonempty(zip(both, each, strict=True)):
        alone = fly(given)
        assert np.array_equal(flight.t, alone.t)
        for name in nonempty(("x", "y", "z", "qw", "qx", "qy", "qz", "vx", "vz", "wy", "wz")):
            assert np.abs(flight.columns[name] - alone.columns[name]).max() < 1e-14, name


def test_two_that_come_fast_from_afar_touch_in_time() -> None:
    """Steps of free flight would take them through each other."""
    gap = 2.0 * (0.19 * np.sqrt(0.5) + 0.11) + 3.0
    first, second = (tables(x, v, duration=0.0765) for x, v in ((0.0, 20.0), (gap, -20.0)))
    flights = fly_pair(first, second, surface=SURFACE)
    for flight in nonempty(flights):
        assert flight.measures["touch_time"] == pytest.approx(3.0 / 40.0, abs=1e-6)


@pytest.mark.parametrize("deep", [0.004, 0.2])
def test_a_start_in_each_other_is_refused(deep: float) -> None:
    """Cages that overlap, and one vehicle in the middle of the other."""
    reach = 2.0 * (0.19 * np.sqrt(0.5) + 0.11)
    with pytest.raises(
        InputError, match=r"second\.start\.position: puts a part of it 0\.\d+ m inside"
    ):
        fly_pair(tables(0.0, 1.0), tables(reach - deep, 0.0, yaw=np.pi))
    beside = [tables(x, 0.0, yaw=yaw, duration=1e-3) for x, yaw in ((0.0, 0.0), (reach, np.pi))]
    assert fly_pair(*beside).first.measures["end_time"] == pytest.approx(1e-3)


def test_a_moving_obstacle_is_not_struck_by_two() -> None:
    """The world of two vehicles is at rest."""
    ball = {"type": "sphere", "position": [3.0, 0.0, 0.0], "radius": 0.1, "surface": "wall",
            "motion": {"type": "free", "mass": 1.0}}  # fmt: skip
    with pytest.raises(InputError, match=r"world.obstacles\[0\]"):
        fly_pair(tables(0.0, 1.0, obstacles=[ball]), tables(0.7, 0.0, obstacles=[ball]))


#: Hulls on the main body, in front of the cages.
HULLS: dict[str, dict[str, Any]] = {
    "sphere": {"type": "sphere", "radius": 0.05, "position": [0.22, 0.0, 0.02]},
    "ring": {"type": "ring", "radius": 0.1, "position": [0.18, 0.0, 0.0], "axis": [0, 1, 0]},
    "capsule": {"type": "capsule", "start": [0.25, -0.1, 0.03], "end": [0.25, 0.1, 0.0],
                "radius": 0.02},
    "box": {"type": "box", "size": [0.4, 0.2, 0.1], "position": [0.1, 0.0, 0.02], "yaw": 0.1,
            "edge_radius": 0.005},
    "points": {"type": "points", "points": [[0.28, 0, 0], [0.1, 0.1, 0], [0.1, -0.1, 0],
               [0.1, 0, 0.1]], "radius": 0.01},
}  # fmt: skip


def hulled(name: str) -> dict[str, Any]:
    """An ARQ with one more hull."""
    return {"preset": "arq", "hulls": [HULLS[name]]}


#: Meetings in which contacts of a hull join or part in the midst of a step, so that its work is not
#: all booked, and by how much; such flights warn (docs/howto/hulls.md).
OPEN = {("capsule", "box"): 3e-3}


@pytest.mark.parametrize("its", [name for name in HULLS if name != "points"])
@pytest.mark.parametrize("own", HULLS)
def test_every_hull_meets_every_hull_of_the_other(own: str, its: str) -> None:
    """Where both have one: both know of one touch, momentum is kept, each ledger closes."""
    left = OPEN.get((own, its))
    with pytest.warns(LedgerWarning) if left else nullcontext():
        first, second = fly_pair(
            tables(0.0, 0.25, vehicle=hulled(own), duration=0.5),
            tables(0.65, -0.2, vehicle=hulled(its), yaw=3.0, z=0.01, y=0.01, duration=0.5),
            surface=SURFACE,
        )
    assert first.measures["body_contacts"] or second.measures["body_contacts"]
    for name in nonempty(("touch_time", "touch_speed")):
        one, other = (flight.measures[name] for flight in (first, second))  # type: ignore[literal-required]
        assert one is not None
        assert one == pytest.approx(other, abs=1e-9)
    pushes = [np.array([f.work[f"impulse.{axis}"] for axis in "xyz"]) for f in (first, second)]
    assert np.abs(pushes[0]).max() > 0.02
    assert np.abs(pushes[0] + pushes[1]).max() < 1e-12
    for flight in nonempty((first, second)):
        assert abs(flight.measures["ledger_residual"] or 0.0) < (left or 2e-5)


def test_a_soft_hull_is_in_series_with_the_contact() -> None:
    """Whichever of both has it: the same touch, and the same softer push."""
    soft = {**HULLS["sphere"], "surface": {"stiffness": 2e4}}

    def peak(own: dict[str, Any], its: dict[str, Any]) -> float:
        given = ({"preset": "quad", "hulls": [hull]} for hull in (own, its))
        first, _ = fly_pair(
            tables(0.0, 0.8, vehicle=next(given)),
            tables(0.7, -0.7, vehicle=next(given), yaw=np.pi),
            surface=SURFACE,
        )
        return first.measures["peak_normal_force"] or 0.0

    stiff = peak(HULLS["sphere"], HULLS["sphere"])
    mine, its = peak(soft, HULLS["sphere"]), peak(HULLS["sphere"], soft)
    assert mine == pytest.approx(its, rel=1e-6)
    assert 0.1 * stiff < mine < 0.5 * stiff


@pytest.mark.parametrize("radius", [0.11, 0.02, 0.005])
def test_a_cage_of_any_size_is_a_disc_as_large(radius: float) -> None:
    """Also where it is smaller than the rounding of the edges: its rim is where the circle is."""
    vehicle = scenario_from(
        {"vehicle": {"preset": "quad", "arms": {"cage_radius": radius}}, "thrust": "hover"}
    ).vehicle
    law = SURFACE.surface(AnyExponent, in_scene=True)
    scene = scene_of_part(solids_of(vehicle)[0], law)
    for x in nonempty((radius, 2.0 * radius, 3.0)):
        assert distance_of(scene, Vec(x, 0.0, 0.0)) == pytest.approx(x - radius, abs=1e-12)
    assert distance_of(scene, Vec(0.0, 0.0, 0.1)) == pytest.approx(0.1 - 0.5 * HEIGHT, abs=1e-12)
