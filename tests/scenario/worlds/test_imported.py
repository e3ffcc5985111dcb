"""Imported worlds in a scenario: placed, with surfaces, refused, warned of, converted, flown again."""

from __future__ import annotations

import hashlib
import json
import os
import re
import time
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner, Result
from scipy.spatial.transform import Rotation

from builders.cases import nonempty
from builders.world_files import BOX, imported, named_parts, sdf, sdf_model, seen
from springback import InputError, read_scenario, read_world
from springback.campaign.design.layout import lay_out
from springback.campaign.design.plan import read_plan
from springback.contact.cage import moving_bodies
from springback.contact.moving.bodies import ABSENT
from springback.contact.scene.faces import SolidScene
from springback.interfaces.cli.app import cli
from springback.interfaces.replay.geometry import drawables
from springback.scenario.model import world_numbers
from springback.scenario.scenario import Scenario, scenario_from
from springback.scenario.warnings import scenario_warnings
from springback.scenario.worlds.imported import single_obstacles
from springback.scenario.worlds.toml_text import world_toml

EGG = "<ellipsoid><radii>1 2 3</radii></ellipsoid>"
SCENARIO = """
vehicle = "arq"
thrust = "hover"
[start]
velocity = ["2 m/s", 0, 0]
[simulation]
duration = "10 ms"
"""
IMPORT = """
[[world.obstacles]]
type = "import"
file = "w.sdf"
surface = "wall"
"""
ALL = sdf(
    sdf_model("floor", "<plane><normal>0 0 1</normal></plane>"),
    sdf_model("ramp", "<plane><normal>0 0 1</normal></plane>", "30 0 0 0 -0.4 0"),
    sdf_model("shelf_1", BOX, "6 1 1 0.1 0.2 0.3"),
    sdf_model("shelf_2", BOX, "8 1 1 0 0 0.123456789"),
    sdf_model(
        "pillar", "<cylinder><radius>0.2</radius><length>3</length></cylinder>", "5 2 1.5 0 0.1 0"
    ),
    sdf_model(
        "pipe", "<capsule><radius>0.05</radius><length>4</length></capsule>", "7 0 3 1.57 0 0"
    ),
    sdf_model("ball", "<sphere><radius>0.3</radius></sphere>", "5 -2 0.3 0 0 0"),
    sdf_model("cone", "<cone><radius>0.3</radius><length>0.7</length></cone>", "6 -2 0.35 0 0 0"),
    sdf_model("sheet", "<box><size>0.001 2 2</size></box>", "9 0 1 0 0 0"),
)


def scenario(folder: Path, world: str = ALL, more: str = IMPORT, *words: str) -> Scenario:
    (folder / "w.sdf").write_text(world)
    (folder / "s.toml").write_text(SCENARIO + more)
    return read_scenario(folder / "s.toml", words)


def table_of(obstacles: Any) -> bytes:
    """All numbers of a scene."""
    built = world_numbers(type("World", (), {"obstacles": obstacles, "gravity": 9.81})()).obstacles
    assert isinstance(built, SolidScene)
    numbers: bytes = built.table.numbers.tobytes()
    return numbers


def run(*words: str) -> Result:
    return CliRunner().invoke(cli, ["world", *words], standalone_mode=False)


def test_converted_obstacles_are_the_same_scene_bit_for_bit(tmp_path: Path) -> None:
    more = IMPORT + 'position = [0.1, 0.2, 0.3]\nyaw = "25 deg"\nsurfaces = { "shelf*" = "mat" }\n'
    whole = scenario(tmp_path, ALL, more)
    text = world_toml(whole.world.obstacles[0])  # type: ignore[arg-type]
    (tmp_path / "t.toml").write_text(SCENARIO + text)
    again = read_scenario(tmp_path / "t.toml")
    assert len(again.world.obstacles) == 9
    assert [one.type for one in again.world.obstacles] == [
        one.type for one in single_obstacles(whole.world.obstacles)
    ]
    assert table_of(whole.world.obstacles) == table_of(again.world.obstacles)
    assert "# shelf_1/link/collision" in text


def test_the_whole_is_placed_and_turned(tmp_path: Path) -> None:
    here = named_parts(imported(tmp_path, "w.sdf", ALL))
    there = named_parts(read_world(tmp_path / "w.sdf", position=["1 m", -2, 0.5], yaw="40 deg"))
    turn, moved = Rotation.from_euler("z", 40.0, degrees=True), np.array([1.0, -2.0, 0.5])
    for name in ("shelf_1", "pillar", "pipe", "ball", "cone"):
        a, b = (seen(parts[f"{name}/link/collision"]) for parts in (here, there))
        assert b.centre == pytest.approx(turn.apply(a.centre) + moved, abs=1e-12)
        assert b.sizes == pytest.approx(a.sizes, abs=1e-12)
        if name in ("pillar", "pipe", "cone"):
            assert b.axis == pytest.approx(turn.apply(a.axis), abs=1e-12)
    box, turned = here["shelf_1/link/collision"], there["shelf_1/link/collision"]
    assert turned.axes() == pytest.approx(turn.apply(box.axes()), abs=1e-12)
    assert there["floor/link/collision"].height == 0.5
    ramp = there["ramp/link/collision"]
    assert ramp.normal == pytest.approx(turn.apply(here["ramp/link/collision"].normal), abs=1e-12)


def test_the_first_pattern_that_fits_counts(tmp_path: Path) -> None:
    surfaces = {"shelf_1": {"preset": "wall", "friction": 0.1}, "shelf*/link/*": "mat"}
    world = imported(tmp_path, "w.sdf", ALL, surfaces=surfaces)
    parts = named_parts(world)
    assert parts["shelf_1/link/collision"].surface.friction == 0.1
    assert parts["shelf_2/link/collision"].surface == world.surfaces["shelf*/link/*"]
    assert parts["pillar/link/collision"].surface == world.surface
    with pytest.raises(
        InputError,
        match=r"surfaces\.shelv\*: fits the name of no element of w\.sdf; there are floor",
    ):
        read_world(tmp_path / "w.sdf", surfaces={"shelv*": "mat"})
    with pytest.raises(InputError, match="did you mean mat"):
        read_world(tmp_path / "w.sdf", surfaces={"shelf*": "matt"})


def test_thin_things_have_thin_edges(tmp_path: Path) -> None:
    assert (
        named_parts(imported(tmp_path, "w.sdf", ALL))["sheet/link/collision"].edge_radius == 0.00025
    )


# -- in scenarios ---------------------------------------------------------------------------------


def test_overrides_reach_the_import(tmp_path: Path) -> None:
    read = scenario(
        tmp_path,
        ALL,
        IMPORT,
        "world.obstacles.0.surface.friction=0.33",
        "world.obstacles.0.yaw=10 deg",
    )
    [one] = read.world.obstacles
    assert {part.obstacle.surface.friction for part in nonempty(one.parts)} == {0.33}  # type: ignore[union-attr]
    assert one.yaw == pytest.approx(np.radians(10.0))  # type: ignore[union-attr]


def test_what_is_not_represented_is_warned_of_or_refused(tmp_path: Path) -> None:
    world = sdf(sdf_model("egg", EGG), sdf_model("a", BOX, "5 0 0 0 0 0"))
    read = scenario(tmp_path, world)
    [warning] = scenario_warnings(read)
    assert warning.startswith(
        "world.obstacles[0]: 1 of 2 elements of w.sdf cannot be represented and are not there: "
        "egg/link/collision: is an ellipsoid of radii 1 x 2 x 3 m; all are listed by: springback world show "
    )
    with pytest.raises(InputError) as refused:
        scenario(tmp_path, world, IMPORT + 'missing = "refuse"\n')
    [line] = refused.value.problems
    assert (
        "s.toml:11: world.obstacles[0].file: has 1 element that cannot be represented: egg" in line
    )


def test_errors_name_the_line_of_the_scenario_and_of_the_world(tmp_path: Path) -> None:
    with pytest.raises(InputError) as refused:
        scenario(tmp_path, sdf(sdf_model("a", "<box><size>1 1</size></box>")))
    [line] = refused.value.problems
    assert "s.toml:11: world.obstacles[0].file: " in line
    assert "w.sdf:2: size [m]: must be 3 numbers (got '1 1')" in line
    with pytest.raises(
        InputError, match=r"world\.obstacles\[0\]\.file: .*no\.sdf: cannot be read \(No such file"
    ):
        scenario(tmp_path, ALL, IMPORT, "world.obstacles.0.file=no.sdf")
    with pytest.raises(InputError, match=r"world\.obstacles\[0\]\.file: is missing"):
        scenario(tmp_path, ALL, '[[world.obstacles]]\ntype = "import"\nsurface = "wall"\n')
    with pytest.raises(
        InputError, match=r"world\.obstacles\[0\]\.fil: unknown key; did you mean file"
    ):
        scenario(tmp_path, ALL, IMPORT + 'fil = "a"\n')


@pytest.mark.parametrize("key", ["scale", "roll", "pitch"])
def test_an_import_says_what_is_scaled_and_tilted_instead(tmp_path: Path, key: str) -> None:
    with pytest.raises(InputError) as refused:
        scenario(tmp_path, ALL, IMPORT + f"{key} = 0.001\n")
    [line] = refused.value.problems
    said = f"world.obstacles[0].{key}: is no key of an import: an obstacle of type mesh has it"
    assert said in line
    assert re.search(r"s\.toml:\d+: ", line)


def test_a_start_inside_names_the_element(tmp_path: Path) -> None:
    said = r"puts the .* inside world\.obstacles\[0\], shelf_1/link/collision, a box \(got \[6\.0"
    with pytest.raises(InputError, match=said):
        scenario(tmp_path, ALL, IMPORT, "start.position=[6, 1, 1]")


def test_a_dumped_scenario_needs_the_file_no_more(tmp_path: Path) -> None:
    whole = scenario(tmp_path)
    dumped = json.loads(json.dumps(whole.model_dump(mode="json")))
    (tmp_path / "w.sdf").unlink()
    again = scenario_from(dumped)
    assert table_of(again.world.obstacles) == table_of(whole.world.obstacles)


@pytest.mark.parametrize(
    ("element", "said"),
    [
        ({"type": "import"}, "must be wall, ground"),
        ({"type": "box", "position": [0, 0], "size": [1, 1, 1]}, "must be three plain numbers"),
        ({"type": "box", "position": [0, 0, "1 m"], "size": [1, 1, 1]}, "must be three plain numbers"),
        ({"type": "ground", "height": "a"}, "must be a plain number"),
        ({"type": "box", "position": [0, 0, 0], "size": [1, 1, -1]}, "a: size: must be more than 0 m"),
        ({"type": [1]}, "must be wall, ground"),
    ],
)  # fmt: skip
def test_elements_of_a_stranger_are_checked(element: dict[str, Any], said: str) -> None:
    entry = {"type": "import", "file": "x", "surface": "wall", "yaw": 0.3,
             "elements": [{"name": "a", "obstacle": element}]}  # fmt: skip
    with pytest.raises(InputError, match=said):
        scenario_from({"vehicle": "arq", "world": {"obstacles": [entry]}})


def test_a_changed_file_is_read_again(tmp_path: Path) -> None:
    assert len(imported(tmp_path, "w.sdf", ALL).parts) == 9
    path = tmp_path / "w.sdf"
    path.write_text(sdf(sdf_model("a", BOX)))
    os.utime(path, ns=(1, 1))
    assert [part.name for part in read_world(path).parts] == ["a/link/collision"]


def test_the_replay_draws_each_element(tmp_path: Path) -> None:
    whole = scenario(tmp_path)
    flown = np.array([[4.0, 0.0, 1.0], [5.0, 0.0, 1.0]])
    things = drawables(
        single_obstacles(whole.world.obstacles), (), flown, np.zeros((0, 3))
    ).drawables
    assert sorted(thing.name for thing in things) == [
        "box", "capsule", "cone", "ground", "pole", "sphere", "wall",
    ]  # fmt: skip


def test_a_campaign_flies_into_an_import(tmp_path: Path) -> None:
    """The design reads it, varies its numbers, and knows the digest of its files."""
    scenario(tmp_path)
    (tmp_path / "plan.toml").write_text(
        'scenario = "s.toml"\nmethod = "grid"\n[[vary]]\nfield = "world.obstacles.0.surface.friction"\n'
        'values = [0.1, 0.2]\n[[vary]]\nfield = "world.obstacles.0.position.2"\nvalues = [-0.5, 0.0]\n'
    )
    design = lay_out(*read_plan(tmp_path / "plan.toml"))
    assert design.flights == 4
    assert str(tmp_path / "w.sdf") in design.code
    flown = [scenario_from(table, False) for table in design.slice(0, 4).tables]
    parts = [named_parts(one.world.obstacles[0])["shelf_1/link/collision"] for one in flown]  # type: ignore[arg-type]
    assert {part.surface.friction for part in parts} == {0.1, 0.2}
    assert {part.position[2] for part in parts} == {0.5, 1.0}


def test_ten_thousand_boxes_in_some_seconds(tmp_path: Path) -> None:
    models = [
        sdf_model(f"b{k}", BOX, f"{5 + k % 100} {k // 100} 1 0 0 {k / 5000}") for k in range(9990)
    ]
    (tmp_path / "w.sdf").write_text(sdf(*models))
    begun = time.process_time()
    world = read_world(tmp_path / "w.sdf")
    assert len(world.parts) == 9990
    assert time.process_time() - begun < 10.0  # some 1.1 s on one of two shared cores


# -- commands -------------------------------------------------------------------------------------


def test_show_lists_every_element_and_what_is_missing(tmp_path: Path) -> None:
    path = tmp_path / "w.sdf"
    path.write_text(ALL.replace("</world>", sdf_model("egg", EGG) + "<light/></world>"))
    done = run("show", str(path), "--surface-of", "shelf*=mat")
    for name in ("floor", "ramp", "shelf_1", "pillar", "pipe", "ball", "cone", "sheet"):
        assert f"{name}/link/collision" in done.stdout
    assert (
        "not represented:\n  egg/link/collision: is an ellipsoid of radii 1 x 2 x 3 m"
        in done.stdout
    )
    assert "nothing can hit: 1 light" in done.stdout
    assert (
        "9 elements (1 ground, 1 wall, 3 box, 1 pole, 1 capsule, 1 sphere, 1 cone), 1 not"
        in done.stderr
    )
    data = json.loads(run("show", str(path), "--json", "--quiet").stdout)
    assert len(data["elements"]) == 9
    assert data["not_represented"] == ["egg/link/collision: is an ellipsoid of radii 1 x 2 x 3 m"]


def test_a_file_of_nothing_that_can_be_shown_is_counted_in_plain_words(tmp_path: Path) -> None:
    path = tmp_path / "w.sdf"
    path.write_text(sdf(sdf_model("egg", EGG)))
    done = run("show", str(path))
    assert done.stdout.startswith("not represented:\n  egg/link/collision")
    assert "0 elements, 1 not represented" in done.stderr


def test_convert_writes_obstacles_and_warns(tmp_path: Path) -> None:
    path, out = tmp_path / "w.sdf", tmp_path / "o.toml"
    path.write_text(ALL.replace("</world>", sdf_model("egg", EGG) + "</world>"))
    done = run("convert", str(path), "--out", str(out), "--surface-of", "shelf*=mat")
    assert "warning: not represented: egg/link/collision" in done.stderr
    tables = tomllib.loads(out.read_text())["world"]["obstacles"]
    assert [one["surface"] for one in tables].count("mat") == 2
    for words, said in (
        ((), "exists; give --force"),
        (("--force", "--missing", "refuse"), "has 1 element that cannot be represented"),
        (("--force", "--surface-of", "mat"), "must be PATTERN=PRESET"),
    ):
        with pytest.raises(InputError, match=said):
            raise run("convert", str(path), "--out", str(out), *words).exception or AssertionError


def test_convert_tells_what_is_represented_differently(tmp_path: Path) -> None:
    """Was: told by show alone."""
    path = tmp_path / "w.sdf"
    free = sdf_model("crate", "<box><size>1 1 1</size></box>").replace("<static>true</static>", "")
    path.write_text(sdf(free))
    [line] = read_world(path).remarks
    done = run("convert", str(path), "--out", str(tmp_path / "o.toml"))
    assert f"represented differently: {line}" in done.stderr


def test_a_file_of_another_content_than_noted_is_refused(tmp_path: Path) -> None:
    whole = IMPORT + f'content = "{hashlib.sha256(ALL.encode()).hexdigest()}"\n'
    assert len(scenario(tmp_path, ALL, whole).world.obstacles[0].parts) == 9  # type: ignore[union-attr]
    with pytest.raises(InputError, match=r"w\.sdf: was changed: it has another content than"):
        scenario(tmp_path, ALL + " ", whole)


def test_moving_obstacles_keep_their_numbers_beside_an_import(tmp_path: Path) -> None:
    ball = '\n[[world.obstacles]]\ntype = "sphere"\nposition = [9, 0, 5]\nradius = 0.2\nsurface = "wall"\n'
    moved = ball + 'motion = { type = "constant", velocity = [0, 0, 1] }\n'
    model = scenario(tmp_path, ALL, IMPORT + moved).flight_model()
    bodies = [body for body in moving_bodies(model.world.obstacles) if body.kind != ABSENT]
    assert [body.obstacle for body in nonempty(bodies)] == [1.0]


def test_an_element_at_an_absurd_place_is_refused_by_its_number(tmp_path: Path) -> None:
    models = sdf(sdf_model("a", BOX, "3 0 1 0 0 0"), sdf_model("b", BOX, "5e7 0 0 0 0 0"))
    (tmp_path / "w.sdf").write_text(models)
    entry = {"type": "import", "file": str(tmp_path / "w.sdf"), "surface": {"preset": "wall"}}
    with pytest.raises(
        InputError, match=r"elements\[1\]\.position\[0\]: must be from -1e\+06 m to"
    ):
        scenario_from({"vehicle": "arq", "world": {"obstacles": [entry]}})
