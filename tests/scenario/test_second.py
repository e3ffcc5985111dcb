"""A second vehicle of a scenario: what it is made of, and what is refused."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from builders.cases import nonempty
from builders.forms import box_file
from builders.pairs import two, vehicle
from springback.contact.grids import measured_shapes
from springback.errors import InputError
from springback.scenario.files import read_scenario
from springback.scenario.scenario import Scenario, scenario_from
from springback.scenario.warnings import scenario_warnings

FIRST = """
vehicle = "arq"
second = "other.toml"
[[world.obstacles]]
type = "ground"
surface = "wall"
[start]
position = [0, 0, 2]
[air]
wind = [1.0, 0, 0]
rotor_drag = [0.1, 0.1, 0]
"""
OTHER = """
name = "comes"
vehicle = "robot.toml"
thrust = "hover"
clock = 500
[[world.obstacles]]
type = "ground"
surface = "mat"
[start]
position = [1, 0, 2]
velocity = [-1.5, 0, 0]
[simulation]
duration = 9
"""


def written(folder: Path, *overrides: str) -> Scenario:
    """The scenario of two files, and of one of a vehicle."""
    (folder / "other.toml").write_text(OTHER)
    (folder / "robot.toml").write_text('preset = "quad"\nname = "mine"\n')
    (folder / "first.toml").write_text(FIRST)
    return read_scenario(folder / "first.toml", overrides)


def test_world_clock_and_steps_are_those_of_the_scenario(tmp_path: Path) -> None:
    """Whatever the file of the second says of them; vehicle, start and thrust are its own."""
    scenario = written(tmp_path)
    other = scenario.beside()
    assert (other.name, other.vehicle.name) == ("comes", "mine")
    assert other.start.velocity == (-1.5, 0.0, 0.0)
    assert other.world == scenario.world
    assert (other.clock, other.simulation) == (scenario.clock, scenario.simulation)
    assert other.air == scenario.air
    assert other.second is None


def test_overrides_reach_the_second_vehicle(tmp_path: Path) -> None:
    """Of its file, of its defaults, and of its air."""
    words = (
        "second.start.velocity.0=-2 m/s",
        "second.start.angular_velocity.2=3",
        "second.air.rotor_drag=[0.2, 0.2, 0]",
    )
    scenario = written(tmp_path, *words)
    other = scenario.beside()
    assert other.start.velocity == (-2.0, 0.0, 0.0)
    assert other.start.angular_velocity == (0.0, 0.0, 3.0)
    assert (other.air.wind[0], other.air.rotor_drag[0]) == (0.0, 0.2)
    assert (scenario.air.wind[0], scenario.air.rotor_drag[0]) == (1.0, 0.1)


def test_a_scenario_of_two_is_read_back_from_its_numbers(tmp_path: Path) -> None:
    scenario = written(tmp_path)
    again = scenario_from(scenario.model_dump(mode="json"))
    assert again == scenario
    assert again.beside().seed == scenario.beside().seed


def test_each_vehicle_has_noise_of_its_own() -> None:
    """It follows from the seed of the scenario; a seed that is given is kept."""
    seeds = [scenario_from(two(seed=seed)).beside().seed for seed in (0, 1, 2)]
    assert len({0, 1, 2, *seeds}) == 6
    assert scenario_from(two()).beside().seed == seeds[0]
    assert scenario_from(two({**vehicle(0.6, -1.0), "seed": 7})).beside().seed == 7


BALL = {"type": "sphere", "position": [3.0, 0.0, 0.0], "radius": 0.1, "surface": "wall"}
TABLE = {"time": [0.0, 1.0], "values": [[1.0] * 4, [2.0] * 4]}
CORNERS = [[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1]]


def hulled(**hull: Any) -> dict[str, Any]:
    """A vehicle with one more hull, a sphere if nothing else is said."""
    sphere = {"type": "sphere", "radius": 0.03} if "type" not in hull else {}
    return {"preset": "arq", "hulls": [sphere | hull]}


WRONG: dict[str, tuple[dict[str, Any], str]] = {
    "a moving obstacle": (
        two(world={"obstacles": [BALL | {"motion": {"type": "free", "mass": 1.0}}]}),
        r"world\.obstacles\[0\]: cannot be combined with a second vehicle: it moves",
    ),
    "all that move": (
        two(world={"obstacles": [
            BALL, BALL | {"name": "door", "motion": {"type": "free", "mass": 1.0}},
            BALL | {"name": "rope", "motion": {"type": "free", "mass": 1.0}},
        ]}),
        r"world\.obstacles\[1\]: cannot be combined with a second vehicle: door moves, and so does "
        r"world\.obstacles\[2\], rope$",
    ),
    "the impulse law": (
        two(world={"obstacles": [BALL | {"surface": {"preset": "wall", "law": "impulse"}}]}),
        r"world\.obstacles\[0\]\.surface\.law: must not be impulse beside",
    ),
    "its hull of points": (
        two({**vehicle(0.6, -1.0), "vehicle": hulled(type="points", points=CORNERS)}),
        r"^second\.vehicle\.hulls\[0\]\.type: must not be points on a second vehicle",
    ),
    "springs of other exponents": (
        two(vehicle=hulled(surface={"stiffness": 1e4, "exponent": 1.0})),
        r"^vehicle\.hulls\[0\]\.surface\.exponent: must be 1\.5, that of second\.surface",
    ),
    "its springs of other exponents": (
        two({**vehicle(0.6, -1.0), "vehicle": hulled(surface={"stiffness": 1e4, "exponent": 1.0})}),
        r"^second\.vehicle\.hulls\[0\]\.surface\.exponent: must be 1\.5, that of second\.surface",
    ),
    "a start in a hull": (
        two({**vehicle(0.7, -1.0), "vehicle": hulled(radius=0.5)}),
        r"^second\.start\.position: puts a part of it 0\.\d+ m inside",
    ),
    "a hull in a start": (
        two(vehicle(0.7, -1.0), vehicle=hulled(radius=0.5)),
        r"^second\.start\.position: puts a part of it 0\.\d+ m inside",
    ),
    "thrusts over time": (
        two({**vehicle(0.6, -1.0), "thrust": TABLE}), r"^second\.thrust: must be constant",
    ),
    "its contact by the impulse law": (
        two({**vehicle(0.6, -1.0), "surface": {"preset": "wall", "law": "impulse"}}),
        r"^second\.surface\.law: must not be impulse",
    ),
    "a start in each other": (
        two(vehicle(0.3, -1.0)), r"^second\.start\.position: puts a part of it 0\.\d+ m inside",
    ),
    "a main body in a cage": (
        two(vehicle(0.0, -1.0, z=-0.16, pitch="90 deg")),
        r"^second\.start\.position: puts a part of it 0\.\d+ m inside",
    ),
    "a start in the world": (
        two(vehicle(0.6, -1.0, z=0.01), world={"obstacles": [{"type": "ground", "surface": "wall"}]},
            start={"position": [0.0, 0.0, 1.0]}),
        r"^second\.start\.position: puts the main body 0\.\d+ m inside world\.obstacles\[0\]",
    ),
    "a world of its own": (
        two({**vehicle(0.6, -1.0), "world": {"gravity": 1.0}}), r"^second\.world: unknown key",
    ),
    "a word": (two("intruder"), r"^second: must be the path of a scenario file"),  # type: ignore[arg-type]
}  # fmt: skip


@pytest.mark.parametrize("what", WRONG)
def test_what_cannot_fly_together_is_refused(what: str) -> None:
    """In one line that names the field, of which vehicle, too."""
    tables, words = WRONG[what]
    with pytest.raises(InputError, match=words) as refused:
        scenario_from(tables)
    assert len(refused.value.problems) == 1


def test_cages_may_start_beside_each_other() -> None:
    """Nose to nose they touch where two cages meet; a hand's breadth away, or above, they do not."""
    for other in nonempty(
        (vehicle(0.56, 0.0), vehicle(0.2, 0.0, z=0.06), vehicle(0.0, 0.0, z=-0.2))
    ):
        assert scenario_from(two(other)).second is not None


def test_the_file_of_a_second_vehicle_is_named(tmp_path: Path) -> None:
    """If it is not there."""
    (tmp_path / "first.toml").write_text(FIRST)
    with pytest.raises(InputError, match=r"other\.toml"):
        read_scenario(tmp_path / "first.toml")


def test_warnings_tell_of_which_vehicle_they_are() -> None:
    """A table that only a pilot reads, of a second vehicle without one; none of its clock."""
    assert scenario_warnings(scenario_from(two())) == []
    [said] = scenario_warnings(scenario_from(two({**vehicle(0.6, -1.0), "control": {}})))
    assert said.startswith("second: control is not used")


def test_an_obstacle_that_moves_is_refused_before_grids_are_made(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """They take minutes, and the refusal does not need them."""
    made = list[str]()
    monkeypatch.setattr(measured_shapes, "stored_grid", lambda key, make: made.append(key))
    table = {"type": "mesh", "file": box_file(0.41, 0.31, 0.21), "position": [3.0, 0.0, 0.0],
             "surface": "wall"}  # fmt: skip
    moving = BALL | {"motion": {"type": "free", "mass": 1.0}}
    with pytest.raises(InputError, match="cannot be combined with a second vehicle: it moves"):
        scenario_from(two(world={"obstacles": [table, moving]}))
    assert made == []
