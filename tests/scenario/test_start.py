"""The state at time 0: its attitude as a quaternion, and its place at, or before, first touch."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest

import springback
from builders.cases import nonempty
from builders.impacts import towards_wall
from builders.user_obstacles import Ball, Box, Pole
from springback.contact.library import WALL
from springback.contact.parameters import SurfaceSettings
from springback.dynamics.clearance import clearance
from springback.errors import InputError
from springback.frames import attitude_from_euler
from springback.kernels.vectors import Vec
from springback.scenario.model import start_state
from springback.scenario.overrides import apply_overrides
from springback.scenario.scenario import scenario_from
from springback.simulation.measuring.record import Model
from springback.vehicle.state import State

SHORT = {"duration": 0.02}
OWN_SURFACE = SurfaceSettings.model_validate(WALL)


def thrown(**start: Any) -> dict[str, Any]:
    tables = towards_wall()
    tables["start"] = {"position": [0.0, 0.1, 1.0], "velocity": [2.0, 0.3, -0.4], **start}
    return tables | {"simulation": SHORT}


def gap_of(model: Model, state: State) -> float:
    """Distance of the nearest part from the nearest obstacle [m]."""
    return float(clearance(model.airframe, model.world, model.contact_point, state))


# -- quaternion -----------------------------------------------------------------------------------


def test_the_quaternion_of_euler_angles_flies_the_same_flight() -> None:
    angles = {"roll": 0.1, "pitch": -0.2, "yaw": 0.3, "touch_distance": 0.01}
    q = attitude_from_euler(0.1, -0.2, 0.3)
    by_angles = springback.fly(thrown(**angles))
    by_quaternion = springback.fly(thrown(quaternion=[*q], touch_distance=0.01))
    for name in ("x", "qw", "qx", "qy", "qz", "vx", "wy", "ax"):
        last = [flight.columns[name][-1] for flight in (by_angles, by_quaternion)]
        assert last[0] == pytest.approx(last[1], rel=1e-9, abs=1e-9), name
    assert by_angles.touch_speed == pytest.approx(by_quaternion.touch_speed, rel=1e-12)
    assert scenario_from(thrown(quaternion=[*q])).start.angles() == pytest.approx((0.1, -0.2, 0.3))


def test_a_quaternion_of_length_one_is_taken_to_the_last_bit() -> None:
    q = (0.5, -0.5, 0.5, 0.5)
    assert scenario_from(thrown(quaternion=[*q])).start_state().attitude == q


def test_four_decimals_are_enough() -> None:
    state = scenario_from(thrown(quaternion=[0.7071, 0, 0.7071, 0])).start_state()
    assert state.attitude == pytest.approx((math.sqrt(0.5), 0.0, math.sqrt(0.5), 0.0), abs=1e-15)


def test_a_quaternion_survives_a_file() -> None:
    """Saved and read again, the same bits fly."""
    scenario = scenario_from(thrown(quaternion=[0.7071, 0, 0.7071, 0], touch_distance=0.0))
    again = scenario_from(json.loads(scenario.model_dump_json()))
    assert again.start_state() == scenario.start_state()


# -- at touch -------------------------------------------------------------------------------------

#: Changes of the tables: parts and planes of every kind.
PLANES: dict[str, dict[str, Any]] = {
    "rings": {"start": {"roll": 0.3, "pitch": -0.4, "yaw": 0.2}},
    "arm tips": {"model": {"contact_point": "paper"}, "start": {"yaw": 0.7}},
    "hull": {"vehicle": {"preset": "quad", "hull": {"radius": 0.5}}, "start": {"pitch": 1.0}},
    "back from within": {"start": {"position": [9.0, 0.0, 1.0]}},
    "grazing": {"start": {"velocity": [0.01, 5.0, 0.0]}},
    "impulse law": {
        "world": {
            "obstacles": [
                {"type": "wall", "distance": 1.0,
                 "surface": {"preset": "wall", "law": "impulse", "restitution": 0.4}}
            ]
        }
    },
    "corner": {
        "world": {
            "obstacles": [
                {"type": "ground", "surface": "wall"},
                {"type": "mat", "distance": 5.0, "thickness": 0.2, "surface": "mat",
                 "backing": "wall"},
            ]
        }
    },
}  # fmt: skip


@pytest.mark.parametrize("case", PLANES)
def test_the_foremost_part_begins_in_touch(case: str) -> None:
    """Its gap is 0, it touches at once, and its velocity is that of the start."""
    change = PLANES[case]
    tables = thrown(touch_distance=0.0) | {k: v for k, v in change.items() if k != "start"}
    tables["start"] = tables["start"] | change.get("start", {})
    scenario = scenario_from(tables)
    state = scenario.start_state()
    path = np.subtract(state.position, tables["start"]["position"])
    v = np.array(tables["start"]["velocity"])
    assert np.cross(path, v) == pytest.approx(np.zeros(3), abs=1e-9)
    assert abs(gap_of(scenario.flight_model(), state)) <= 1e-12
    assert [*state.velocity] == [*v]
    flight = springback.fly(tables | {"simulation": {"duration": 5e-4}}, executor="python")
    assert flight.touch_time == 0.0
    assert flight.touch_speed > 0.0


SHAPES: dict[str, Any] = {
    "pole": Pole(2.0, 0.35, 0.02),
    "ball": Ball(Vec(2.0, 0.3, 0.7), 0.1),
    "box": Box(Vec(0.1, 0.2, 0.1), Vec(3.0, 0.6, 0.5)),
}


@pytest.mark.parametrize("case", SHAPES)
@pytest.mark.parametrize("point", ["ring", "paper"])
def test_it_touches_shapes_of_ones_own(case: str, point: str) -> None:
    """And nothing of the way to them is inside."""
    tables = thrown(touch_distance=0.0, yaw=0.4, pitch=0.2) | {"world": {"obstacles": []}}
    scenario = scenario_from(tables | {"model": {"contact_point": point}})
    own = [(SHAPES[case], OWN_SURFACE)]
    model = scenario.flight_model(own)
    begins, before = start_state(scenario.start, scenario.vehicle, model), scenario.start.place()
    assert abs(gap_of(model, begins)) <= 1e-12
    for share in nonempty(np.linspace(0.0, 0.999, 50).tolist()):
        place = before + share * (begins.position - before)
        assert gap_of(model, begins._replace(position=place)) > 0.0


def test_a_distance_is_flown_before_the_touch() -> None:
    """Without gravity and thrust, after distance over speed."""
    tables = thrown(touch_distance="30 mm")
    tables["world"]["gravity"] = 0.0
    flight = springback.fly(tables | {"thrust": 0.0})
    touching = springback.fly(tables | {"thrust": 0.0}, "start.touch_distance=0")
    assert touching.gap()[0].min() == pytest.approx(0.0, abs=1e-12)
    assert flight.touch_time == pytest.approx(0.03 / math.hypot(2.0, 0.3, 0.4), rel=1e-9)


#: Changes of the start, and words of the message.
BAD: dict[str, tuple[dict[str, Any], str]] = {
    "away": ({"velocity": [-1.0, 0.0, 0.0]}, r"touch_distance: .* meets no obstacle"),
    "along": ({"velocity": [0.0, 1.0, 0.0]}, r"touch_distance: .* meets no obstacle"),
    "at rest": ({"velocity": [0.0, 0.0, 0.0]}, r"start\.velocity: must not be zero"),
    "negative": ({"touch_distance": -0.1}, r"touch_distance: must be at least 0 m"),
    "three": ({"quaternion": [1, 0, 0]}, r"quaternion: must be four plain numbers"),
    "length": ({"quaternion": [1, 0, 0, 0.1]}, r"quaternion: must be of length 1 .*1\.00499"),
    "zero": ({"quaternion": [0, 0, 0, 0]}, r"quaternion: must be of length 1"),
    "both": (
        {"quaternion": [1, 0, 0, 0], "yaw": 0.1},
        r"cannot be combined with a yaw .*0\.1 rad.*5\.72958 deg",
    ),
}


@pytest.mark.parametrize("case", BAD)
def test_a_start_that_cannot_be_is_refused_in_one_line(case: str) -> None:
    change, words = BAD[case]
    with pytest.raises(InputError, match=words) as caught:
        scenario_from(thrown(**({"touch_distance": 0.0} | change)))
    assert len(caught.value.problems) == 1


def test_a_reference_begins_at_its_place() -> None:
    tables = {"vehicle": "arq", "reference": {"type": "hold"}}
    with pytest.raises(InputError, match=r"touch_distance: cannot be combined with a reference"):
        scenario_from(tables | {"start": {"velocity": [1, 0, 0], "touch_distance": 0.0}})


def test_to_hold_is_to_stay_where_it_starts() -> None:
    """Without a position of its own, in a second vehicle too; 1 m above the origin without a start."""
    hold = {"vehicle": "arq", "reference": {"type": "hold"}}
    high = {"position": [0.2, 0.1, "1.5 m"]}
    other = hold | {"start": {"position": [2.0, 0.0, 1.2]}}
    both = scenario_from(hold | {"start": high, "second": other})
    kept = scenario_from(
        {**hold, "reference": {"type": "hold", "position": [0, 0, 1]}, "start": high}
    )
    bare = scenario_from(hold | {"start": {"pitch": 0.1}})
    moved = scenario_from(apply_overrides(hold | {"start": high}, ["start.position.2=1.7"]))
    raised = scenario_from(apply_overrides(hold | {"start": high}, ["reference.position.2=2"]))
    assert both.second is not None
    held = [one.reference for one in (both, both.second, kept, bare, moved, raised)]
    assert [one.position for one in nonempty(held)] == [
        (0.2, 0.1, 1.5), (2.0, 0.0, 1.2), (0.0, 0.0, 1.0), (0.0, 0.0, 1.0), (0.2, 0.1, 1.7),
        (0.2, 0.1, 2.0),
    ]  # fmt: skip


def test_to_hold_is_to_keep_the_yaw_of_the_start() -> None:
    """A robot that starts turned by 180° does not turn back at once, unless its reference says so."""
    hold = {"vehicle": "arq", "reference": {"type": "hold"}}
    turned = hold | {"start": {"position": [0, 0, 1], "yaw": "180 deg"}}
    told = turned | {"reference": {"type": "hold", "yaw": 0.1}}
    other = scenario_from(
        hold | {"second": turned | {"start": {"position": [2, 0, 1], "yaw": "90 deg"}}}
    )
    assert other.second is not None
    held = [scenario_from(one).reference for one in (hold, turned, told)] + [other.second.reference]
    assert [one.yaw for one in nonempty(held)] == [0.0, np.pi, 0.1, np.pi / 2]
    with pytest.raises(InputError, match=r"start\.yaw: "):
        scenario_from(hold | {"start": {"yaw": "1 m"}})


# -- of obstacles ----------------------------------------------------------------------------------


def beside_a_free_box(height: float) -> dict[str, Any]:
    """ARQ above the ground, and a box of 20 cm that moves freely, its centre at a height [m]."""
    box = {
        "type": "box", "position": [2.0, 0.0, height], "size": [0.2, 0.2, 0.2], "surface": "wall",
        "motion": {"type": "free", "mass": 1.0},
    }  # fmt: skip
    obstacles = [{"type": "ground", "surface": "wall"}, box]
    return {"vehicle": "arq", "world": {"obstacles": obstacles}, "simulation": SHORT,
            "start": {"position": [0.0, 0.0, 1.0]}, "thrust": "hover"}  # fmt: skip


def test_a_free_obstacle_may_lie_on_the_ground_not_in_it() -> None:
    scenario_from(beside_a_free_box(0.1))
    scenario_from(beside_a_free_box(0.0985))
    with pytest.raises(InputError, match=r"^world\.obstacles\[1\]: starts 0\.05 m inside what is"):
        scenario_from(beside_a_free_box(0.05))


def test_the_motion_of_a_wall_is_refused_with_those_that_it_can_have() -> None:
    wall = {"type": "wall", "distance": 2.0, "surface": "wall", "motion": {"type": "free"}}
    given = beside_a_free_box(0.1) | {"world": {"obstacles": [wall]}}
    said = r"type: must be constant, sine or table \(got 'free'\); free is a motion of an obstacle"
    with pytest.raises(InputError, match=said):
        scenario_from(given)
