"""MJCF: every geom is where MuJoCo has it, whatever notation gives its pose."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pytest

from builders.world_files import imported, named_parts, seen
from springback import InputError, read_world

HEAD = '<mujoco model="m"><compiler angle="{angle}" eulerseq="{sequence}"/><default>{classes}</default><worldbody>'
TAIL = "</worldbody></mujoco>"


def numbers(*values: float) -> str:
    return " ".join(f"{float(value)!r}" for value in values)


def attitude(rng: np.random.Generator, degrees: bool) -> str:
    """An attitude in one of the notations, at random."""
    turn = 180.0 if degrees else np.pi
    kinds = [
        f'quat="{numbers(*rng.normal(size=4))}"',
        f'axisangle="{numbers(*rng.normal(size=3), rng.uniform(-turn, turn))}"',
        f'euler="{numbers(*rng.uniform(-turn, turn, 3))}"',
        f'xyaxes="{numbers(*rng.normal(size=6))}"',
        f'zaxis="{numbers(*rng.normal(size=3))}"',
        "",
    ]
    return kinds[int(rng.integers(len(kinds)))]


def geom(rng: np.random.Generator, name: str, degrees: bool) -> str:
    kind = ("box", "sphere", "capsule", "cylinder")[int(rng.integers(4))]
    size = numbers(*rng.uniform(0.05, 0.5, {"box": 3, "sphere": 1}.get(kind, 2)))
    if kind != "sphere" and rng.uniform() < 0.3:
        size = numbers(*rng.uniform(0.05, 0.5, 2 if kind == "box" else 1))
        return f'<geom name="{name}" type="{kind}" size="{size}" fromto="{numbers(*rng.uniform(-1, 1, 6))}"/>'
    place = f'pos="{numbers(*rng.uniform(-1, 1, 3))}"'
    return f'<geom name="{name}" type="{kind}" size="{size}" {place} {attitude(rng, degrees)}/>'


def body(rng: np.random.Generator, depth: int, count: list[int], degrees: bool) -> str:
    """Geoms, and bodies and frames with geoms, nested."""
    parts = []
    for _ in range(2):
        count[0] += 1
        parts.append(geom(rng, f"g{count[0]}", degrees))
    for _ in range(2 if depth else 0):
        tag = "body" if rng.uniform() < 0.7 else "frame"
        place = f'pos="{numbers(*rng.uniform(-1, 1, 3))}"'
        inner = body(rng, depth - 1, count, degrees)
        joint = '<joint type="hinge"/>' if tag == "body" and rng.uniform() < 0.3 else ""
        parts.append(f"<{tag} {place} {attitude(rng, degrees)}>{joint}{inner}</{tag}>")
    return "".join(parts)


def check_against_mujoco(path: Path, parts: dict[str, Any]) -> int:
    """Compare places, axes and sizes of all geoms that are represented; the number of them."""
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    by_name = {name.rpartition("/")[2]: seen(one) for name, one in parts.items()}
    assert len(by_name) == len(parts)
    for name, found in by_name.items():
        k = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_GEOM, name)
        assert k >= 0
        turn = data.geom_xmat[k].reshape(3, 3)
        assert found.centre == pytest.approx(data.geom_xpos[k], abs=1e-9)
        size = model.geom_size[k]
        if model.geom_type[k] == mujoco.mjtGeom.mjGEOM_BOX:
            assert found.axes == pytest.approx(turn.T, abs=1e-9)
            assert found.sizes == pytest.approx(2.0 * size, abs=1e-9)
        elif model.geom_type[k] == mujoco.mjtGeom.mjGEOM_SPHERE:
            assert found.sizes == pytest.approx(size[:1], abs=1e-9)
        else:
            assert found.axis == pytest.approx(turn[:, 2], abs=1e-9)
            assert found.sizes == pytest.approx([size[0], 2.0 * size[1]], abs=1e-9)
    return len(by_name)


@pytest.mark.parametrize("seed", range(24))
def test_geoms_are_where_mujoco_has_them(tmp_path: Path, seed: int) -> None:
    rng = np.random.default_rng(seed)
    degrees = bool(rng.integers(2))
    sequence = ["xyz", "XYZ", "zyx", "ZXy", "xyx"][int(rng.integers(5))]
    head = HEAD.format(angle="degree" if degrees else "radian", sequence=sequence, classes="")
    text = head + body(rng, 3, [0], degrees) + TAIL
    world = imported(tmp_path, "m.xml", text)
    assert check_against_mujoco(tmp_path / "m.xml", named_parts(world)) == 30
    assert world.unrepresented == ()


def test_default_classes_are_inherited_as_in_mujoco(tmp_path: Path) -> None:
    classes = """
      <geom type="box" size="0.1 0.2 0.3" friction="0.7" euler="0 0 30"/>
      <default class="post"><geom type="cylinder" size="0.05 0.6" quat="1 0 1 0"/>
        <default class="thick"><geom size="0.15 0.4" axisangle="1 0 0 40"/></default></default>
      <default class="ghost"><geom contype="0" conaffinity="0"/></default>"""
    inner = """
      <geom name="a"/><geom name="b" class="post" pos="1 0 0"/>
      <geom name="h" class="ghost"/>
      <body childclass="thick" pos="0 1 0"><geom name="c"/><geom name="d" zaxis="1 1 0"/>
        <body><geom name="e" pos="0 0 1" friction="0.2 0.1 0.1"/><geom name="f" class="main"/></body>
        <frame childclass="post" pos="0 0 2" euler="90 0 0"><geom name="g" quat="1 2 3 4"/></frame>
      </body>"""
    text = HEAD.format(angle="degree", sequence="xyz", classes=classes) + inner + TAIL
    world = imported(tmp_path, "m.xml", text)
    assert check_against_mujoco(tmp_path / "m.xml", named_parts(world)) == 7
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "m.xml"))
    for name, one in named_parts(world).items():
        k = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_GEOM, name.rpartition("/")[2])
        assert one.surface.friction == pytest.approx(model.geom_friction[k, 0])
    assert world.ignored == ("1 visual",)


def test_a_friction_that_is_not_given_is_the_surface_s(tmp_path: Path) -> None:
    text = HEAD.format(angle="degree", sequence="xyz", classes="") + '<geom size="0.1"/>' + TAIL
    [part] = imported(tmp_path, "m.xml", text).parts
    assert part.obstacle.surface.friction == 0.8
    assert part.name == "geom 0"


def test_includes_are_put_in_their_place(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "post.xml").write_text(
        '<mujocoinclude><geom name="p" size="0.1 1" type="capsule"/></mujocoinclude>'
    )
    (tmp_path / "common.xml").write_text(
        '<mujoco><compiler angle="radian"/><default><geom euler="0.3 0 0"/></default></mujoco>'
    )
    text = '<mujoco><include file="common.xml"/><worldbody><body pos="1 2 3" euler="0 0 1"><include file="parts/post.xml"/></body></worldbody></mujoco>'
    world = imported(tmp_path, "m.xml", text)
    assert check_against_mujoco(tmp_path / "m.xml", named_parts(world)) == 1
    (tmp_path / "common.xml").write_text('<mujoco><include file="m.xml"/></mujoco>')
    with pytest.raises(InputError, match=r"includes itself: m\.xml -> common\.xml -> m\.xml"):
        read_world(tmp_path / "m.xml")
    (tmp_path / "common.xml").unlink()
    with pytest.raises(InputError, match=r"m\.xml:1: include: there is no common\.xml in"):
        read_world(tmp_path / "m.xml")


def test_what_is_not_represented_is_listed_by_name(tmp_path: Path) -> None:
    tetra = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    stl = (
        bytes(80)
        + struct.pack("<I", 4)
        + b"".join(
            struct.pack("<12fH", 0, 0, 0, *(x for k in face for x in tetra[k]), 0) for face in faces
        )
    )
    (tmp_path / "t.stl").write_bytes(stl)
    text = """<mujoco><asset><mesh name="t" file="t.stl"/><mesh name="v" vertex="0 0 0 1 0 0 0 1 0 0 0 1"/>
      <mesh name="gone" file="gone.stl"/><hfield name="h" nrow="2" ncol="2" size="1 1 1 1"/></asset><worldbody>
      <geom name="egg" type="ellipsoid" size="1 2 3"/><geom name="ball" type="ellipsoid" size="0.5 0.5 0.5"/>
      <geom name="fit" type="box" mesh="t"/><geom name="inline" type="mesh" mesh="v"/>
      <geom name="lost" type="mesh" mesh="gone"/><geom name="hill" type="hfield" hfield="h"/>
      <replicate count="3" offset="1 0 0"><geom size="0.1"/></replicate>
      <body name="swing" pos="0 0 2"><joint type="ball"/><geom name="bob" size="0.2"/><light/><site name="s"/></body>
      </worldbody></mujoco>"""
    world = imported(tmp_path, "m.xml", text)
    named = [line.partition(":")[0] for line in world.unrepresented]
    assert named == ["egg", "fit", "inline", "lost", "hill", "replicate 6"]
    assert [part.name for part in world.parts] == ["ball", "swing/bob"]
    assert world.remarks == ("swing: can move there (ball joint), and is at rest here",)
    assert world.ignored == ("1 light", "1 site")


WRONG = {
    '<geom type="box" size="1 2"/>': r"m\.xml:1: geom: size \[m\]: must be 3 numbers",
    '<geom type="box" size="1 -2 1"/>': r"size: must be above 0 m \(got -2 m\)",
    '<geom type="capsule" size="1" fromto="0 0 0 0 0 0"/>': r"fromto: must be two points apart",
    '<geom size="1" quat="0 0 0 0"/>': r"quat: must not be zero",
    '<geom size="1" xyaxes="1 0 0 2 0 0"/>': r"xyaxes: must not be zero",
    '<geom size="1" pos="0 0 inf"/>': r"pos \[m\]: must be finite",
    '<geom size="1" class="nope"/>': r"there is no default class 'nope'",
    '<geom type="mesh" mesh="nope"/>': r"there is no mesh 'nope'",
    '<geom size="1" friction="-1"/>': r"friction: must be at least 0 \(got -1\)",
}  # fmt: skip


@pytest.mark.parametrize("inner", WRONG)
def test_wrong_numbers_name_file_and_line(tmp_path: Path, inner: str) -> None:
    text = HEAD.format(angle="degree", sequence="xyz", classes="") + inner + TAIL
    with pytest.raises(InputError, match=WRONG[inner]) as refused:
        imported(tmp_path, "m.xml", text)
    assert len(refused.value.problems) == 1


def test_a_model_that_is_no_model(tmp_path: Path) -> None:
    for text, said in (
        ('<mujoco><compiler eulerseq="xyw"/></mujoco>', "eulerseq: must be three of x, y, z"),
        ('<mujoco><compiler coordinate="global"/></mujoco>', "coordinate: must be local"),
        ("<house/>", "is neither SDF"),
    ):
        with pytest.raises(InputError, match=said):
            imported(tmp_path, "m.xml", text)
