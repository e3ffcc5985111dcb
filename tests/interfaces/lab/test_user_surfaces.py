"""The surface of the impact lab for the user's own scenario: whatever its obstacles are."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("starlette", reason="the lab needs the extra web")

from builders.cases import nonempty
from interfaces.lab.user_files import setting, table_of
from springback.contact.library import SURFACES
from springback.interfaces.lab.controls import ChoiceControl
from springback.interfaces.lab.scenarios import lab_scenario, lab_tables, lab_toml
from springback.interfaces.lab.settings import control_of, controls
from springback.scenario.files import read_scenario

BOX = 'type = "box", position = [2.85, 0, 1], size = [0.2, 1, 1]'
NET = '{type = "net", position = [2.75, 0, 1], tension = 100}'
GROUND = '{type = "ground", surface = "mat"}'


def world(*obstacles: str) -> str:
    return f"world.obstacles=[{', '.join(obstacles)}]"


def obstacles_of(settings: Any) -> tuple[Any, ...]:
    return lab_scenario(settings, "mine").world.obstacles


@pytest.mark.parametrize(
    "obstacle",
    [
        f'{{{BOX}, surface = "mat"}}',
        f'{{{BOX}, surface = {{preset = "wall", stiffness = 5e4}}}}',
        '{type = "sphere", position = [2.8, 0, 1], radius = 0.05, surface = "mat"}',
        '{type = "slope", position = [2.8, 0, 1], angle = "45 deg", surface = "mat"}',
        '{type = "wall", distance = 2.75, surface = "mat"}',
        GROUND,
    ],
)
def test_it_opens_with_the_surface_of_the_file_and_each_choice_is_put_on_it(
    file: Path, obstacle: str
) -> None:
    table = table_of(file, world(obstacle))
    given = read_scenario(file, [world(obstacle)])
    assert table().surface == "file"
    assert lab_scenario(table(), "mine") == given
    for chosen in nonempty(("wall", "mat")):
        same = read_scenario(file, [world(obstacle), f"world.obstacles.0.surface={chosen}"])
        assert obstacles_of(setting(table, surface=chosen)) == same.world.obstacles
    [own] = obstacles_of(setting(table, surface="own", contact_stiffness=77, friction=0.15))
    assert (own.surface.stiffness, own.surface.friction) == (77e3, 0.15)
    assert own.type == given.world.obstacles[0].type


def test_numbers_of_a_surface_of_ones_own_begin_with_those_of_the_file(file: Path) -> None:
    table = table_of(file, world(f'{{{BOX}, surface = {{preset = "wall", stiffness = 5e4}}}}'))
    assert (table().contact_stiffness, table().friction) == (50.0, SURFACES["wall"].friction)
    [own] = obstacles_of(setting(table, surface="own"))
    assert own.surface.stiffness == 5e4


def test_numbers_that_no_control_shows_change_nothing(file: Path) -> None:
    """A link may hold the friction of a surface that is no longer chosen."""
    table = table_of(file)
    assert lab_scenario(setting(table, friction=0.9), "mine") == read_scenario(file)


def test_ground_and_nets_keep_what_they_have(file: Path) -> None:
    table = table_of(file, world(GROUND, NET, f'{{{BOX}, surface = "mat"}}'))
    before, after = obstacles_of(table()), obstacles_of(setting(table, surface="wall"))
    assert after[:2] == before[:2]
    assert after[2].surface == SURFACES["wall"] != before[2].surface


def test_every_part_of_a_union_and_of_an_import_gets_the_surface(
    file: Path, tmp_path: Path
) -> None:
    """Also those parts to which the file gives another, or of which the world has a friction."""
    (tmp_path / "w.sdf").write_text(
        '<sdf version="1.9"><world name="w"><model name="crate"><static>true</static>'
        '<pose>2.9 0 1 0 0 0</pose><link name="l"><collision name="c"><geometry><box><size>0.2 1 1'
        "</size></box></geometry><surface><friction><ode><mu>0.05</mu></ode></friction></surface>"
        "</collision></link></model></world></sdf>",
        encoding="utf-8",
    )
    parts = f'[{{{BOX}}}, {{{BOX.replace("2.85", "2.95")}, surface = "wall"}}, {NET}]'
    union = f'{{type = "union", surface = "wall", shapes = {parts}}}'
    read = (
        f'{{type = "import", file = "{tmp_path / "w.sdf"}", surface = "wall", '
        'surfaces = {"crate*" = "wall"}}'
    )
    table = table_of(file, world(union, read))
    assert table().surface == "file"
    one, other = obstacles_of(setting(table, surface="mat"))
    assert [shape.law() == SURFACES["mat"] for shape in one.shapes] == [True, True, False]
    assert [part.obstacle.surface for part in other.parts] == [SURFACES["mat"]]


def test_the_control_is_not_shown_where_it_has_no_effect(file: Path) -> None:
    for obstacles in nonempty(((NET,), ())):
        table = table_of(file, world(*obstacles))
        shown = {one["name"]: one["when"].get("mode") for one in controls(table)}
        for name in nonempty(("surface", "contact_stiffness", "dissipation", "friction")):
            assert shown[name] == ("impact", "flight")
        assert obstacles_of(setting(table, surface="mat")) == obstacles_of(table())


def test_words_of_the_control_are_of_what_is_in_the_file(file: Path) -> None:
    def word(*obstacles: str) -> str:
        control = control_of("surface", table_of(file, world(*obstacles)))
        assert isinstance(control, ChoiceControl)
        return control.words["file"]

    wall, box = '{type = "wall", distance = 2.75, surface = "mat"}', f'{{{BOX}, surface = "mat"}}'
    assert word(wall, GROUND) == "Your wall"
    assert word(box) == word(wall, box) == "As in file"


def test_an_impact_and_a_flight_have_the_surface_of_a_file_without_walls(file: Path) -> None:
    table = table_of(
        file, world(GROUND, f'{{{BOX}, surface = {{preset = "wall", friction = 0.2}}}}')
    )
    for mode in nonempty(("impact", "flight")):
        ahead = lab_tables(setting(table, mode=mode), "mine")["world"]["obstacles"][0]
        assert (ahead["type"], ahead["surface"]["friction"]) == ("wall", 0.2)
    assert "surface of the file" in lab_toml(setting(table, mode="impact"), "mine")


def test_a_mat_of_the_file_keeps_its_face_where_a_turned_robot_expects_it(file: Path) -> None:
    """Its face is on the robot's way 2.75 m ahead, with the turn of the obstacle and without."""
    mat = '{type = "mat", distance = 3, thickness = 0.2, surface = "mat", backing = "wall"}'
    table = table_of(file, world(mat))
    straight, turned = (
        lab_tables(setting(table, mode="flight", yaw=yaw), "mine")["world"]["obstacles"][0]
        for yaw in (0, 30)
    )
    back, face = np.array(turned["position"]), np.array(turned["normal"])
    assert straight["distance"] - straight["thickness"] == pytest.approx(2.75)
    assert (back + 0.2 * face) @ face / face[0] == pytest.approx(2.75)
