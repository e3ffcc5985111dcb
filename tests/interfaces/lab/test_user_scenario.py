"""The impact lab with the user's own scenario: what it takes from the file, changes and sweeps."""

import asyncio
import math
import os
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("starlette", reason="the lab needs the extra web")

from interfaces.lab.user_files import FILE, VEHICLE, setting, table_of
from springback.contact.library import SURFACES
from springback.errors import InputError
from springback.interfaces.lab.controls import SliderControl
from springback.interfaces.lab.queue import NotReady, RequestQueue, kind_of
from springback.interfaces.lab.responses import answer
from springback.interfaces.lab.scenarios import BEFORE, lab_scenario, lab_toml, robots_of
from springback.interfaces.lab.settings import (
    DEFAULTS,
    control_of,
    query_of,
    settings_from,
)
from springback.interfaces.lab.sweeps import POINTS, sweep_answer, sweep_of
from springback.interfaces.lab.user_scenario import read_user_scenario
from springback.interfaces.lab.user_settings import user_settings
from springback.interfaces.lab.vehicles import is_balanced
from springback.results.flight import fly
from springback.scenario.files import read_scenario

RUN_UP = """
[reference]
type = "run-up"
speed = "2 m/s"
pitch = "15 deg"
[[world.obstacles]]
type = "wall"
distance = "2.75 m"
surface = "wall"
[vehicle]
preset = "arq"
"""


# -- what is taken from the file ------------------------------------------------------------------


def test_it_opens_with_the_file_to_the_last_bit(file: Path) -> None:
    table = table_of(file)
    assert query_of(table()) == ""
    assert robots_of(table()) == ("mine",)
    as_file, in_lab = fly(read_scenario(file)), fly(lab_scenario(table(), "mine"))
    assert in_lab.measures == as_file.measures
    assert in_lab.scenario == as_file.scenario


def test_a_quaternion_opens_as_angles_and_is_changed_as_angles(tmp_path: Path) -> None:
    """Nose down by 10 deg and at touch: it flies as in the file until the pitch is changed."""
    path, half = tmp_path / "own.toml", math.radians(5.0)
    words = f"quaternion = [{math.cos(half)}, 0, {math.sin(half)}, 0]\ntouch_distance = 0"
    path.write_text((FILE + VEHICLE).replace('pitch = "10 deg"', words), encoding="utf-8")
    table = table_of(path)
    assert (table().pitch, table().yaw, table().start_yaw) == (10.0, 0.0, 0.0)  # type: ignore[attr-defined]
    assert lab_scenario(table(), "mine") == read_scenario(path)
    start = lab_scenario(setting(table, pitch=20.0), "mine").start
    assert (start.quaternion, start.touch_distance) == (None, 0.0)
    assert start.angles() == pytest.approx((0.0, math.radians(20.0), 0.0), abs=1e-12)


def test_its_numbers_are_the_defaults_and_marked(file: Path) -> None:
    table = table_of(file, "vehicle.arms.length=0.6", "start.pitch=-70 deg")
    for name, value in (("length", 600.0), ("speed", 2.5), ("pitch", -70.0), ("friction", 0.4)):
        control = control_of(name, table)
        assert isinstance(control, SliderControl)
        assert getattr(table(), name) == value
        assert control.marks[0] == (value, "your file")
        assert control.least <= value <= control.most


@pytest.mark.parametrize(
    ("changes", "hovers"),
    [
        ([], True),
        (["vehicle.arms.mass=[0.04, 0.04, 0.09, 0.09]", "payload.mass=0.3"], False),
        (["model_error.mass=1.3", "world.gravity=3.7"], True),
    ],
)
def test_an_impact_of_ones_own_vehicle_arrives_as_asked(
    file: Path, changes: list[str], hovers: bool
) -> None:
    """With a true mass of its own, and with arms that equal thrusts would turn."""
    asked = setting(table_of(file, *changes), mode="impact", pitch=25, yaw=30, speed=3)
    given = lab_scenario(asked, "mine")
    assert is_balanced(given.vehicle) == hovers == (given.thrust == "hover")
    m = fly(given, trajectory=False).measures
    assert m["touch_time"] == pytest.approx(BEFORE, abs=1.1e-7)
    assert m["touch_speed"] == pytest.approx(3.0, rel=1e-5)


def test_ones_own_vehicle_hits_other_obstacles_with_the_surface_of_its_file(file: Path) -> None:
    """An impact on a pole with the friction of the file's wall; as in the file the wall is hit."""
    table = table_of(file)
    asked = setting(table, mode="impact", obstacle="pole", radius=70)
    scenario = lab_scenario(asked, "mine")
    [pole] = scenario.world.obstacles
    assert (pole.type, pole.surface.friction) == ("pole", 0.4)
    assert scenario.vehicle == lab_scenario(table(), "mine").vehicle
    m = fly(scenario, trajectory=False).measures
    assert m["touch_time"] == pytest.approx(BEFORE, abs=3e-4)
    as_is = setting(table, obstacle="pole")  # it has no effect on what is in the file
    assert lab_scenario(as_is, "mine").world == read_scenario(file).world
    assert kind_of(as_is) == kind_of(table())


def test_a_file_with_a_shape_opens_and_is_flown_as_it_is(tmp_path: Path) -> None:
    path = tmp_path / "pole.toml"
    wall = 'type = "wall"\ndistance = "2.75 m"\nsurface = {preset = "wall", friction = 0.4}'
    pole = 'type = "pole"\nposition = [2.75, 0, 0]\nradius = 0.05\nsurface = "wall"'
    assert wall in FILE
    path.write_text(FILE.replace(wall, pole) + VEHICLE, encoding="utf-8")
    table = table_of(path)
    [shown] = answer(table())["flights"]
    assert "hits the pole at" in shown["sentence"]
    assert [one["name"] for one in shown["scene"]["obstacles"]] == ["pole"]
    assert fly(lab_scenario(table(), "mine")).measures == fly(read_scenario(path)).measures


@pytest.mark.parametrize(
    ("distance", "word"), [(2.75, "the wall"), (5.0, "the pole"), (2.71, "the wall")]
)
def test_of_several_obstacles_the_one_that_is_touched_first_is_named(
    file: Path, distance: float, word: str
) -> None:
    """A pole whose front is at 2.72 m, and a wall before, behind or far behind it."""
    there = f'{{type = "wall", distance = {distance}, surface = "wall"}}'
    pole = '{type = "pole", position = [2.82, 0.25, 0], radius = 0.05, surface = "wall"}'
    [shown] = answer(table_of(file, f"world.obstacles=[{there}, {pole}]")())["flights"]
    assert f"Mine hits {word} at" in shown["sentence"]


def test_a_hull_that_sticks_out_touches_first(file: Path) -> None:
    asked = setting(table_of(file, "vehicle.hull.radius=0.4"), mode="impact")
    m = fly(lab_scenario(asked, "mine"), trajectory=False).measures
    assert m["touch_time"] == pytest.approx(BEFORE, abs=1.1e-7)


def test_of_several_walls_an_impact_takes_the_one_ahead(file: Path) -> None:
    behind = '{type = "wall", position = [-3, 0, 0], normal = [1, 0, 0], surface = "wall"}'
    mat = '{type = "mat", distance = 2.75, thickness = "30 mm", surface = "mat", backing = "wall"}'
    far = '{type = "wall", distance = 4, surface = "wall"}'
    user = read_user_scenario(file, [f"world.obstacles=[{behind}, {far}, {mat}]"])
    assert user.target is user.scenario.world.obstacles[2]
    obstacle = lab_scenario(setting(user_settings(user), mode="impact"), "mine").world.obstacles[0]
    assert (obstacle.type, obstacle.thickness) == ("mat", 0.03)  # type: ignore[union-attr]
    turned = read_user_scenario(
        file,
        [f"world.obstacles=[{behind}, {mat}]", "start.velocity=[-2, 0, 0]", "start.yaw=200 deg"],
    )
    assert turned.target is turned.scenario.world.obstacles[0]
    assert turned.yaw == pytest.approx(20.0)


def test_of_a_run_up_an_impact_takes_speed_and_pitch_at_the_wall(tmp_path: Path) -> None:
    path = tmp_path / "run.toml"
    path.write_text(RUN_UP, encoding="utf-8")
    table = table_of(path)
    opens = table()
    assert (opens.mode, opens.speed, opens.pitch) == ("impact", 2.0, 15.0)
    given = lab_scenario(setting(table, mode="file", speed=2.2), "mine")
    assert (given.reference.speed, given.reference.pitch) == (2.2, math.radians(15))  # type: ignore[union-attr]
    with pytest.raises(InputError, match="not swept here; a campaign can"):
        sweep_of(setting(table, mode="file"), "stiffness")
    assert table.user is not None
    assert table.user.label == "My ARQ"


OWN_CODE = """
vehicle = {preset = "frame.toml", body = {mass = "1.3 kg"}, propulsion = {max_thrust = 8}}
pilot = { code = "pilots.py:mine", parameters = { gain = 2.0 } }
estimator = {type = "own", code = "sensing.py:estimator"}
[recovery.detection.own]
code = "sensing.py:detector"
[[world.obstacles]]
type = "own"
shape = "shapes.py:pole"
surface = "wall"
[[world.obstacles]]
type = "wall"
distance = 2.75
surface = "mat"
"""


def test_code_and_a_vehicle_file_of_ones_own_are_found_beside_the_scenario(tmp_path: Path) -> None:
    """The vehicle is read once, so that a move shows no change of the file; no code is run."""
    path, frame = tmp_path / "own.toml", tmp_path / "frame.toml"
    path.write_text(OWN_CODE, encoding="utf-8")
    frame.write_text(VEHICLE.replace('name = "Mine"', ""), encoding="utf-8")
    table = table_of(path)
    frame.unlink()
    assert table.user is not None
    assert (table().mode, table().body_mass, table.user.label) == ("impact", 1.3, "frame")
    assert table.user.target is table.user.scenario.world.obstacles[1]
    as_file = lab_scenario(setting(table, mode="file", length=230, surface="wall"), "mine")
    assert as_file.pilot is not None
    assert as_file.pilot.code == f"{tmp_path / 'pilots.py'}:mine"
    assert as_file.pilot.parameters == {"gain": 2.0}
    assert as_file.estimator.code == f"{tmp_path / 'sensing.py'}:estimator"
    assert as_file.recovery is not None
    assert as_file.recovery.detection.own is not None
    assert as_file.recovery.detection.own.code == f"{tmp_path / 'sensing.py'}:detector"
    assert as_file.vehicle.arms.length == 0.23
    own, wall = as_file.world.obstacles
    assert own.shape == f"{tmp_path / 'shapes.py'}:pole"  # type: ignore[union-attr]
    assert wall.surface.friction == SURFACES["wall"].friction
    impact = lab_scenario(table(), "mine")
    assert impact.pilot is None
    assert [one.type for one in impact.world.obstacles] == ["wall"]


# -- what is shown --------------------------------------------------------------------------------


def test_the_downloaded_file_flies_to_the_numbers_of_the_page(file: Path, tmp_path: Path) -> None:
    asked = setting(table_of(file), length=231.7, body_mass=1.37, inertia="scale", speed=3.1,
                    start_yaw=7.3, surface="own", friction=0.3, beside="twin")  # fmt: skip
    shown = answer(asked)
    assert [one["label"] for one in shown["flights"]] == ["Mine", "Mine, rigid"]
    for robot in ("mine", "twin"):
        saved = tmp_path / f"{robot}.toml"
        saved.write_text(lab_toml(asked, robot), encoding="utf-8")
        flight = fly(read_scenario(saved))
        for row in shown["measures"]:
            if row["unit"] in ("", "m/s", "m/s²", "N"):
                assert row["values"][robot] == flight.measures[row["name"]], row["name"]
    assert flight.measures["impact_arm_stroke"] == 0.0  # of the twin, whose arms are locked
    assert (
        settings_from([tuple(part.split("=")) for part in query_of(asked).split("&")], type(asked))
        == asked
    )  # type: ignore[misc]


def test_a_sweep_passes_through_the_flights_of_the_page(file: Path) -> None:
    asked = setting(table_of(file), stiffness=7)
    swept = sweep_answer(sweep_of(asked, "stiffness"))
    assert len(swept["at"]) == POINTS
    assert (swept["at"][0], swept["at"][-1]) == (0.5, 50.0)
    peaks = swept["measures"]["impact_peak_acceleration"]["mine"]
    for k in (0, 13, POINTS - 1):
        alone = fly(lab_scenario(setting(type(asked), stiffness=swept["at"][k]), "mine"))
        assert peaks[k] == alone.measures["impact_peak_acceleration"]
    assert len(set(peaks)) > 20


def test_points_of_a_sweep_that_cannot_be_flown_are_gaps_with_the_reason(file: Path) -> None:
    swept = sweep_answer(sweep_of(setting(table_of(file), mode="impact"), "cage_radius"))
    peaks = swept["measures"]["impact_peak_acceleration"]["mine"]
    [refusal] = swept["refusals"]
    assert 0 < refusal["count"] == peaks.count(None) < POINTS
    assert refusal["robot"] == "mine"
    assert refusal["from"] == swept["at"][-refusal["count"]]
    assert refusal["to"] == swept["at"][-1]
    assert "lets its cage meet that of arm 2" in refusal["why"]
    assert peaks[-1] is None is not peaks[0]


@pytest.mark.parametrize("of", ["", "stifness", "arm_count", "surface", "../x"])
def test_only_numbers_can_be_swept(of: str) -> None:
    with pytest.raises(InputError, match=r"^of: cannot be swept"):
        sweep_of(DEFAULTS, of)


# -- compiling, and the command -------------------------------------------------------------------


def test_another_number_of_arms_is_compiled_and_nonsense_is_refused_before(file: Path) -> None:
    table, flown = table_of(file), []
    queue = RequestQueue(lambda one: flown.append(one) or {}, threads=1, prepared=())
    six = setting(table, arm_count=6, length=260)
    assert kind_of(six) != kind_of(table())
    assert kind_of(six).words == "your scenario, six arms"
    with pytest.raises(NotReady):
        asyncio.run(queue.ask(six))
    with pytest.raises(InputError, match="cages overlap"):
        asyncio.run(queue.ask(setting(table, arm_count=12)))
    queue.start()
    assert queue.wait(six, 5.0)
    assert flown == [six]


@pytest.mark.parametrize(
    ("change", "line"),
    [
        (("0.22 m", "-1 m"), "vehicle.arms.length: must be more than 0 m (got '-1 m')"),
        (('"hover"', '"hover'), "own.toml"),
        (
            ('type = "wall"\ndistance = "2.75 m"', 'type = "own"\nshape = "s.py:pole"'),
            "s.py:pole is code, and its folder is not trusted",
        ),
    ],
)
def test_a_bad_file_is_refused_in_one_line(file: Path, change: tuple[str, str], line: str) -> None:
    file.write_text(file.read_text(encoding="utf-8").replace(*change), encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "-m", "springback", "lab", str(file), "--no-browser"],
        capture_output=True, text=True, timeout=60, check=False, cwd="/",
        env={**os.environ, "SPRINGBACK_TRUST": ""},
    )  # fmt: skip
    assert (done.returncode, done.stdout) == (2, "")
    assert line in done.stderr
    assert len(done.stderr.strip().splitlines()) == 1
