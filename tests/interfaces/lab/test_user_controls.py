"""Controls of the impact lab for the user's own scenario: each changes its field and no other."""

import math
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("starlette", reason="the lab needs the extra web")

from builders.cases import nonempty
from interfaces.lab.user_files import FILE, setting, table_of
from springback.errors import InputError
from springback.interfaces.lab.app import page
from springback.interfaces.lab.controls import NoControl
from springback.interfaces.lab.responses import answer
from springback.interfaces.lab.scenarios import lab_scenario, lab_toml
from springback.interfaces.lab.settings import (
    DEFAULTS,
    control_of,
    settings_from,
)
from springback.interfaces.lab.sweeps import sweep_choices
from springback.interfaces.lab.vehicle_controls import VEHICLE_FIELDS
from springback.quantities import number_in, si_number
from springback.results.flight import fly
from springback.scenario.fields import fields_of
from springback.scenario.files import read_scenario
from springback.vehicle.parameters import Arms, Body


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
    """As in the file the yaw is that of the world, whatever way a wall faces."""
    wall = 'world.obstacles=[{type = "wall", position = [0, 3, 0], normal = [0, -1, 0], surface = "wall"}]'
    changes = ["start.velocity=[0.6, 0.8, 0]", "start.yaw=100 deg", "start.position=[0, 0, 1]"]
    table = table_of(file, wall, *changes)
    opens: Any = table()
    assert (opens.speed, opens.start_yaw, opens.yaw) == (1.0, 100.0, 10.0)
    start = lab_scenario(setting(table, speed=2, pitch=-5, start_yaw=115), "mine").start
    assert start.velocity == pytest.approx((1.2, 1.6, 0.0))
    assert math.degrees(start.pitch) == pytest.approx(-5.0)
    assert math.degrees(start.yaw) == pytest.approx(115.0)
    assert start.position == (0.0, 0.0, 1.0)


@pytest.mark.parametrize("yaw", ["0", "37.5 deg", "-90 deg", "200 deg"])
def test_the_yaw_of_a_file_comes_back_as_it_was(file: Path, tmp_path: Path, yaw: str) -> None:
    """From the file into the lab, to another yaw and back, and into a file: to the last bit."""
    wall = 'world.obstacles=[{type = "wall", position = [0, 3, 0], normal = [0, -1, 0], surface = "wall"}]'
    table = table_of(file, wall, f"start.yaw={yaw}", "start.velocity=[0, 1, 0]")
    opens: Any = table()
    given = table.user.scenario if table.user else None
    assert given is not None
    there = math.remainder(math.degrees(given.start.yaw), 360.0)
    assert opens.start_yaw == pytest.approx(there, abs=1e-4)
    assert control_of("start_yaw", table).when == {"mode": ("file",)}
    assert "file" not in control_of("yaw", table).when["mode"]
    back = setting(table, start_yaw=opens.start_yaw)
    saved = tmp_path / "back.toml"
    saved.write_text(lab_toml(back, "mine"), encoding="utf-8")
    assert read_scenario(saved).start == given.start
    turned = lab_scenario(setting(table, start_yaw=12), "mine").start
    assert math.degrees(turned.yaw) == pytest.approx(12.0)
    again = setting(table_of(saved), start_yaw=12)
    assert lab_scenario(again, "mine").start == turned


def test_a_pilot_who_begins_by_himself_has_no_yaw_to_set(file: Path) -> None:
    holds = 'reference={type = "hold", position = [0, 0, 1]}'
    file.write_text(f'vehicle = "quad"\n{FILE}'.replace('thrust = "hover"', ""), encoding="utf-8")
    table = table_of(file, holds)
    assert "start_yaw" not in fields_of(table)


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


# -- a second vehicle ------------------------------------------------------------------------------


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
    hovers = (
        'reference={ type = "hold", position = [0, 0, 1] }', "start.position=[0, 0, 1]",
        "world.gravity=9.81",
    )  # fmt: skip
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
