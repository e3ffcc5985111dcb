"""The impact lab with the user's own scenario: what it takes from the file, changes and sweeps."""

import asyncio
import math
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("starlette", reason="the lab needs the extra web")

from builders.cases import nonempty
from springback.contact.library import SURFACES
from springback.errors import InputError
from springback.interfaces.lab.app import page
from springback.interfaces.lab.controls import NoControl, SliderControl
from springback.interfaces.lab.queue import NotReady, RequestQueue, kind_of
from springback.interfaces.lab.responses import answer
from springback.interfaces.lab.scenarios import BEFORE, lab_scenario, lab_toml, robots_of
from springback.interfaces.lab.settings import (
    DEFAULTS,
    LabSettings,
    control_of,
    query_of,
    settings_from,
)
from springback.interfaces.lab.sweeps import POINTS, sweep_answer, sweep_choices, sweep_of
from springback.interfaces.lab.user_scenario import read_user_scenario
from springback.interfaces.lab.user_settings import user_settings
from springback.interfaces.lab.vehicle_controls import VEHICLE_FIELDS
from springback.interfaces.lab.vehicles import is_balanced
from springback.quantities import number_in, si_number
from springback.results.flight import fly
from springback.scenario.fields import fields_of
from springback.scenario.files import read_scenario
from springback.vehicle.parameters import Arms, Body

VEHICLE = """
[vehicle]
name = "Mine"
hull = {radius = "50 mm"}
[vehicle.body]
mass = "1.1 kg"
inertia = [9e-3, 9.5e-3, 1.6e-2]
[vehicle.arms]
directions = ["45 deg", "-45 deg", "-135 deg", "135 deg"]
length = "0.22 m"
mass = "40 g"
stiffness = "4 N/mm"
damping = "60 N s/m"
stroke = "30 mm"
cage_radius = "0.1 m"
torque_ratio = 0.016
"""
FILE = """
name = "own"
thrust = "hover"
[[world.obstacles]]
type = "wall"
distance = "2.75 m"
surface = {preset = "wall", friction = 0.4}
[start]
position = ["2.3 m", 0, "1 m"]
velocity = ["2.5 m/s", 0, 0]
pitch = "10 deg"
[simulation]
duration = "0.2 s"
"""
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


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "own.toml"
    path.write_text(FILE + VEHICLE, encoding="utf-8")
    return path


def table_of(path: Path, *overrides: str) -> type[LabSettings]:
    return user_settings(read_user_scenario(path, overrides))


def setting(table: type[LabSettings], **words: Any) -> LabSettings:
    return settings_from(((name, str(value)) for name, value in words.items()), table)


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
    assert (table().pitch, table().yaw) == (10.0, 0.0)
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
    assert "hits the obstacle at" in shown["sentence"]
    assert [one["name"] for one in shown["scene"]["obstacles"]] == ["pole"]
    assert fly(lab_scenario(table(), "mine")).measures == fly(read_scenario(path)).measures


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


# -- controls -------------------------------------------------------------------------------------


def test_sliders_have_units_and_ranges_that_the_registry_of_fields_allows() -> None:
    tables = {"arms": Arms, "body": Body}
    for name, field in nonempty(VEHICLE_FIELDS.items()):
        known = fields_of(tables[field.path[0]])[field.name].unit
        assert known is not None
        for end in (field.slider.least, field.slider.most):
            value = number_in(f"{end} {field.slider.unit}", known.unit)
            assert known.read(value) == value, name


CHANGES = {
    "body_mass": 2.0, "length": 300.0, "cage_radius": 90.0, "arm_mass": 55.0, "stiffness": 2.6,
    "damping": 33.0, "stroke": 20.0, "stop_stiffness": 150.0, "stop_dissipation": 0.7,
}  # fmt: skip


@pytest.mark.parametrize("name", VEHICLE_FIELDS)
def test_a_control_changes_its_field_and_no_other(name: str, file: Path) -> None:
    table, field = table_of(file), VEHICLE_FIELDS[name]
    before = lab_scenario(table(), "mine").model_dump()
    after = lab_scenario(setting(table, **{name: CHANGES[name]}), "mine").model_dump()
    found = after["vehicle"][field.path[0]].pop(field.name)
    before["vehicle"][field.path[0]].pop(field.name)
    assert after.pop("name") == "Mine, own, changed"
    before.pop("name")
    assert after == before
    unit = fields_of({"arms": Arms, "body": Body}[field.path[0]])[field.name].unit
    assert unit is not None
    assert found == si_number(f"{CHANGES[name]} {field.slider.unit}", unit.unit)


def test_speed_pitch_and_yaw_change_the_start_as_far_as_they_differ(file: Path) -> None:
    """Yaw is against the wall, which may face anywhere."""
    wall = 'world.obstacles=[{type = "wall", position = [0, 3, 0], normal = [0, -1, 0], surface = "wall"}]'
    changes = ["start.velocity=[0.6, 0.8, 0]", "start.yaw=100 deg", "start.position=[0, 0, 1]"]
    table = table_of(file, wall, *changes)
    assert (table().speed, table().yaw) == (1.0, 10.0)
    start = lab_scenario(setting(table, speed=2, pitch=-5, yaw=25), "mine").start
    assert start.velocity == pytest.approx((1.2, 1.6, 0.0))
    assert math.degrees(start.pitch) == pytest.approx(-5.0)
    assert math.degrees(start.yaw) == pytest.approx(115.0)
    assert start.position == (0.0, 0.0, 1.0)


def test_a_name_cannot_leave_its_place_in_the_page(file: Path) -> None:
    table = table_of(file, "vehicle.name=</script><b>x")
    assert "</script><b>" not in page(table).text
    assert table.user is not None
    assert table.user.label == "</script><b>x"


def test_another_number_of_arms_is_evenly_spaced_in_the_same_sense(file: Path) -> None:
    listed = 'vehicle.arms.mass=["40 g", "40 g", "40 g", "40 g"]'
    table = table_of(file, listed, "vehicle.arms.spin=[1, -1, 1, -1]")
    six = lab_scenario(setting(table, arm_count=6, length=260, arm_angle=30), "mine").vehicle.arms
    assert [round(math.degrees(angle)) for angle in six.directions] == [30, -30, -90, -150, 150, 90]
    assert (six.mass, six.spin) == (0.04, (1, -1, 1, -1, 1, -1))
    turned = lab_scenario(setting(table, arm_angle=0), "mine").vehicle.arms
    assert [round(math.degrees(angle)) for angle in turned.directions] == [0, -90, -180, 90]
    with pytest.raises(
        InputError, match=r"^arm_count: must be a whole number \(got 4.5\); 2 to 12"
    ):
        setting(table, arm_count=4.5)


def test_the_inertia_of_the_body_is_kept_or_follows_its_mass(file: Path) -> None:
    table = table_of(file)
    before = table.user.vehicle.body.inertia  # type: ignore[union-attr]
    kept = lab_scenario(setting(table, body_mass=2.2), "mine").vehicle.body.inertia
    scaled = lab_scenario(setting(table, body_mass=2.2, inertia="scale"), "mine").vehicle.body
    assert kept == before
    for row, was in zip(scaled.inertia, before, strict=True):
        assert row == pytest.approx([2.0 * entry for entry in was])


def test_arms_that_differ_are_not_set_by_one_number(file: Path) -> None:
    table = table_of(file, 'vehicle.arms.length=["0.22 m", "0.22 m", "0.3 m", "0.3 m"]')
    assert isinstance(control_of("length", table), NoControl)
    for name, why in (
        ("length", "length: cannot be set: arms differ, 220 to 300 mm; kept as in the file"),
        ("arm_count", "arm_count: cannot be set: arms differ in length"),
    ):
        with pytest.raises(InputError, match=why):
            setting(table, **{name: 5})
    assert "length" not in {one["name"] for one in sweep_choices(table)["controls"]}
    arms = lab_scenario(setting(table, cage_radius=90), "mine").vehicle.arms
    assert arms.length == (0.22, 0.22, 0.3, 0.3)


def test_what_cannot_be_built_is_refused_by_the_checks_of_the_scenario(file: Path) -> None:
    for mode in ("file", "impact"):
        asked = setting(table_of(file), cage_radius=200, mode=mode)
        with pytest.raises(InputError, match=r"^vehicle\.arms\.cage_radius: .* cages overlap"):
            lab_scenario(asked, "mine")


def test_without_a_file_arms_and_bodies_of_arq_and_quad_change_alike() -> None:
    asked = settings_from([("length", "230"), ("body_mass", "1.504"), ("stiffness", "3")])
    arq, quad = (lab_scenario(asked, robot).vehicle for robot in ("arq", "quad"))
    plain = [lab_scenario(DEFAULTS, robot).vehicle for robot in ("arq", "quad")]
    for changed, before in zip((arq, quad), plain, strict=True):
        assert changed.arms.length == 0.23
        assert changed.body.mass == pytest.approx(before.body.mass + 0.3, abs=1e-12)
    assert (arq.arms.stiffness, quad.arms.stiffness) == (3000.0, plain[1].arms.stiffness)


# -- what is shown --------------------------------------------------------------------------------


def test_the_downloaded_file_flies_to_the_numbers_of_the_page(file: Path, tmp_path: Path) -> None:
    asked = setting(table_of(file), length=231.7, body_mass=1.37, inertia="scale", speed=3.1,
                    yaw=7.3, surface="own", friction=0.3, beside="twin")  # fmt: skip
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


def test_a_second_vehicle_flies_along_and_is_shown(tmp_path: Path) -> None:
    """From a file of its own, which the downloaded scenario holds; both in one world."""
    (tmp_path / "other.toml").write_text(
        'name = "comes"\nvehicle = "arq"\n[start]\nposition = [0.6, 0.22, 0]\n'
        'velocity = [-1.0, 0, 0]\nyaw = "149 deg"\n'
    )
    path = tmp_path / "first.toml"
    path.write_text(
        'name = "waits"\nvehicle = "arq"\nsecond = "other.toml"\n[world]\ngravity = 0\n'
        "[start]\nposition = [0, 0, 0]\nvelocity = [1.5, 0, 0]\n[simulation]\nduration = 0.08\n"
    )
    table = table_of(path)
    assert "other.toml" not in lab_toml(table(), "mine")
    [shown] = answer(table())["flights"]
    as_file = fly(read_scenario(path))
    assert shown["outcome"] == as_file.outcome.word
    assert shown["second"]["label"] == "comes"
    assert shown["scene"]["world"] == shown["second"]["world"]
    assert shown["scene"]["first_touch"] == shown["second"]["first_touch"]
    assert as_file.second is not None
    in_lab = fly(lab_scenario(table(), "mine"))
    assert in_lab.second is not None
    assert in_lab.second.measures == as_file.second.measures


def test_sliders_move_and_soften_the_second_vehicle(tmp_path: Path) -> None:
    """Its start and springs, with the file's numbers as defaults; the first one stays as it is."""
    path = tmp_path / "pair.toml"
    path.write_text(
        'name = "waits"\nvehicle = "arq"\n[world]\ngravity = 0\n[start]\nposition = [0, 0, 0]\n'
        '[second]\nname = "comes"\nvehicle = "arq"\n[second.start]\nposition = [0.7, 0.22, 0]\n'
        'velocity = [-0.6, 0.8, 0]\nyaw = "149 deg"\n'
    )
    table = table_of(path)
    names = [name for name in fields_of(table) if name.startswith("second_")]
    assert names == [f"second_{one}" for one in ("speed", "x", "y", "z", "yaw", "stiffness")]
    assert [getattr(table(), name) for name in names] == [1.0, 0.7, 0.22, 0.0, 149.0, 5.0]
    for name in nonempty(names):
        control = control_of(name, table)
        assert control.group == "Second vehicle, comes"
        assert control.when == {"mode": ("file",)}
    assert lab_scenario(table(), "mine") == read_scenario(path)
    moved = setting(
        table, second_speed=2.0, second_y=0.3, second_yaw=-90.0, second_stiffness="3 N/mm"
    )
    found, given = lab_scenario(moved, "mine"), read_scenario(path)
    hovers = ('reference={ type = "hold", position = [0, 0, 1] }', "start.position=[0, 0, 1]")
    assert table_of(path, *hovers)().mode == "file"  # an impact would have one vehicle
    assert (found.vehicle, found.start, found.world) == (given.vehicle, given.start, given.world)
    assert found.name.endswith("waits, changed")
    assert found.second is not None
    assert found.second.name == "comes"
    assert found.second.start.velocity == pytest.approx((-1.2, 1.6, 0.0))
    assert found.second.start.position == (0.7, 0.3, 0.0)
    assert found.second.start.yaw == pytest.approx(-math.pi / 2)
    assert found.second.vehicle.arms.stiffness == 3000.0
    with pytest.raises(InputError, match=r"second_z: must be at most 2 m"):
        setting(table, second_z=9.0)


def test_without_a_second_vehicle_there_are_no_sliders_for_it(file: Path) -> None:
    assert not [name for name in fields_of(table_of(file)) if name.startswith("second_")]
