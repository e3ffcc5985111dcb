"""Masses of bodies without an inertial in MJCF: those that MuJoCo makes of their geoms."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from oracles.mujoco_masses import by_mujoco, is_same
from springback.contact.grids.mesh_files import Triangles
from springback.errors import InputError
from springback.results.flight import as_scenario
from springback.scenario.masses.models import mass_of_model
from springback.scenario.masses.solids import filled_mesh, filled_shape

CLASSES = """<default><geom density="700"/>
<default class="heavy"><geom type="box" size="0.1 0.02 0.03" mass="0.3"/>
<default class="pin"><geom type="capsule" size="0.01 0.05" density="2000"/></default></default>
</default>"""
SIZES = {"sphere": 1, "capsule": 2, "cylinder": 2, "box": 3, "ellipsoid": 3}


def random_geom(rng: np.random.Generator) -> str:
    """Of any kind, place and turn, its mass written, of a density, or of its class."""

    def text(numbers: Any) -> str:
        return " ".join(map(repr, numbers.tolist()))

    kind = list(SIZES)[int(rng.integers(5))]
    words = f'type="{kind}" size="{text(rng.uniform(0.02, 0.1, SIZES[kind]))}"'
    words += ('', f' mass="{rng.uniform(0.1, 1.0)!r}"', f' density="{rng.uniform(1e2, 3e3)!r}"',
              ' mass="0.2" density="9"')[int(rng.integers(4))]  # fmt: skip
    words += ("", ' class="heavy"', ' class="pin"', ' class="main"')[int(rng.integers(4))]
    if kind != "sphere" and rng.integers(3) == 0:
        words += f' fromto="{text(rng.uniform(-0.2, 0.2, 6))}"'
    else:
        words += f' pos="{text(rng.uniform(-0.2, 0.2, 3))}" euler="{text(rng.uniform(-2, 2, 3))}"'
    return f'<geom {words} group="{rng.integers(6)}"/>'


def random_robot(seed: int, settings: str = "") -> str:
    """Two bodies, with geoms in frames and default classes that are passed on."""
    rng = np.random.default_rng([41, seed])
    some = ["".join(random_geom(rng) for _ in range(3)) for _ in range(4)]
    return (
        f'<mujoco><compiler angle="radian" eulerseq="XYZ" {settings}/>{CLASSES}<worldbody>'
        '<frame childclass="heavy"><body name="base" pos="1 2 3" euler="0.1 0.2 0.3"><freejoint/>'
        f'<geom pos="0.1 0 0" group="2"/>{some[0]}<frame pos="0.1 0 0.2" euler="0.3 0 0.1" childclass="pin">'
        f'<geom pos="0 0 0.3"/>{some[1]}</frame>'
        f'<body name="tail" pos="-0.3 0 0.1" euler="0.2 0 1" childclass="pin"><geom group="2"/>{some[2]}'
        f'</body><body name="arm" pos="0.1 0 0"><joint/>'
        '<inertial pos="0 0 0.1" mass="0.2" diaginertia="2e-3 3e-3 4e-3"/>'
        f"{some[3]}</body></body></frame></worldbody></mujoco>"
    )


@pytest.mark.parametrize("seed", range(8))
def test_masses_of_geoms_are_those_of_mujoco(tmp_path: Path, seed: int) -> None:
    """What is written goes first, unless all is inferred; only groups in the range count."""
    path = tmp_path / "robot.xml"
    for settings in ("", 'inertiafromgeom="true"', 'inertiagrouprange="1 4"'):
        text = random_robot(seed, settings)
        path.write_text(text)
        assert is_same(mass_of_model(path), by_mujoco(text, ["base", "tail"]))
        for name in ("base", "tail", "arm"):
            assert is_same(mass_of_model(path, (name,)), by_mujoco(text, [name]))


# -- meshes ---------------------------------------------------------------------------------------


def angle_piece() -> Triangles:
    """An L of 2 x 3 x 0.5, limbs 1 wide: closed and not convex."""
    outline = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 3.0), (0.0, 3.0)]
    vertices = [(x, y, z) for z in (0.0, 0.5) for x, y in outline]
    faces = []
    for a, b, c in ((0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5)):
        faces += [(a, c, b), (a + 6, b + 6, c + 6)]
    for k in range(6):
        m = (k + 1) % 6
        faces += [(k, m, m + 6), (k, m + 6, k + 6)]
    return Triangles(np.array(vertices), np.array(faces))


def as_obj(mesh: Triangles) -> str:
    words = [f"v {x} {y} {z}" for x, y, z in mesh.vertices.tolist()]
    return "\n".join([*words, *(f"f {a + 1} {b + 1} {c + 1}" for a, b, c in mesh.faces.tolist())])


@pytest.mark.parametrize("scale", ["0.1 0.1 0.1", "0.1 -0.2 0.05"])
@pytest.mark.parametrize("method", ["", "legacy", "exact", "convex", "shell"])
def test_meshes_weigh_what_they_do_in_mujoco(tmp_path: Path, method: str, scale: str) -> None:
    """MuJoCo keeps vertices in single precision."""
    word = f' inertia="{method}"' if method else ""
    text = (
        '<mujoco><compiler meshdir="parts"/><asset>'
        f'<mesh name="m" file="angle.obj" scale="{scale}"{word}/></asset>'
        '<worldbody><body name="base"><freejoint/><geom type="mesh" mesh="m" pos="0.1 0 0.2" '
        'euler="10 20 30" density="300"/><geom type="mesh" mesh="m" mass="0.7"/></body>'
        "</worldbody></mujoco>"
    )
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts/angle.obj").write_text(as_obj(angle_piece()))
    path = tmp_path / "robot.xml"
    path.write_text(text)
    expected = by_mujoco(text, ["base"], {"parts/angle.obj": as_obj(angle_piece()).encode()})
    found = mass_of_model(path)
    assert found.mass == pytest.approx(expected.mass, rel=1e-6)
    assert found.centre == pytest.approx(expected.centre, abs=1e-7)
    assert np.array(found.inertia) == pytest.approx(np.array(expected.inertia), rel=1e-5, abs=1e-8)


def test_an_angle_piece_adds_up_by_hand() -> None:
    """Two boxes: 2 x 1 at (1, 0.5) and 1 x 2 at (0.5, 2), each of volume 1."""
    solid = filled_mesh("angle.obj", angle_piece(), "exact")
    assert solid.mass == pytest.approx(2.0, rel=1e-14)
    assert solid.place == pytest.approx([0.75, 1.25, 0.25], rel=1e-14)
    away = 0.25**2 + 0.75**2
    assert solid.moments[2, 2] == pytest.approx(2.0 * ((4.0 + 1.0) / 12.0 + away), rel=1e-13)


def test_shapes_are_integrals_over_what_they_fill() -> None:
    """Of fine columns; a capsule without a straight part is a ball."""
    x = (np.arange(200) + 0.5) / 100.0 - 1.0
    points = np.stack(np.meshgrid(x, x, x, indexing="ij"), axis=-1).reshape(-1, 3)
    across = np.hypot(points[:, 0], points[:, 1])
    beyond = np.maximum(np.abs(points[:, 2]) - 0.4, 0.0)
    filled = {
        ("capsule", (0.5, 0.4)): np.hypot(across, beyond) < 0.5,
        ("cylinder", (0.5, 0.8)): (across < 0.5) & (np.abs(points[:, 2]) < 0.8),
        ("box", (0.5, 0.7, 0.9)): (np.abs(points) < [0.5, 0.7, 0.9]).all(axis=1),
        ("ellipsoid", (0.5, 0.7, 0.9)): ((points / [0.5, 0.7, 0.9]) ** 2).sum(axis=1) < 1.0,
        ("sphere", (0.8,)): np.linalg.norm(points, axis=1) < 0.8,
    }
    for (kind, size), of in nonempty(filled.items()):
        solid, inside = filled_shape(kind, size), points[of]
        assert solid.mass == pytest.approx(len(inside) * 1e-6, rel=5e-3)
        squares = (inside**2).sum(axis=0) * 1e-6
        assert np.diag(solid.moments) == pytest.approx(squares.sum() - squares, rel=1e-2)
    ball, capsule = filled_shape("sphere", (0.3,)), filled_shape("capsule", (0.3, 1e-9))
    assert np.diag(capsule.moments) == pytest.approx(np.diag(ball.moments), rel=1e-7)
    assert ball.mass == pytest.approx(4.0 / 3.0 * math.pi * 0.027)


# -- what is refused ------------------------------------------------------------------------------

ROBOT = """<mujoco><asset>
<mesh name="m" file="angle.obj"/>
</asset><worldbody><body name="base"><freejoint/>
<geom name="trunk" size="0.1"/>
</body></worldbody></mujoco>
"""
BAD: dict[str, tuple[str, str, str]] = {
    "shell": ('size="0.1"', 'size="0.1" shellinertia="true"', ":4: geom: shellinertia: its mass is not"),
    "height field": ('size="0.1"', 'type="hfield"', ":4: geom: trunk: is a hfield: its mass is not"),
    "fitted": ('size="0.1"', 'type="box" mesh="m"', ":4: geom: trunk: is fitted to a mesh: its mass"),
    "no such mesh": ('size="0.1"', 'type="mesh" mesh="n"', ":4: geom: mesh: there is no mesh 'n'"),
    "no such class": ('size="0.1"', 'size="0.1" class="c"', ":4: geom: class: there is no default class"),
    "no size": ('size="0.1"', 'type="box"', ":4: geom: size [m]: must be 3 numbers"),
    "negative mass": ('size="0.1"', 'size="0.1" mass="-1"', ":4: geom: mass [kg]: must be at least 0"),
    "negative density": (
        'size="0.1"', 'size="0.1" density="-1"', ":4: geom: density [kg/m³]: must be at least 0"),
    "never inferred": ("<asset>", '<compiler inertiafromgeom="false"/><asset>',
                       ":3: body: base: inertial is missing, and inertiafromgeom is false"),
    "perhaps inferred": ("<asset>", '<compiler inertiafromgeom="yes"/><asset>',
                         "compiler: inertiafromgeom: must be auto, true or false (got 'yes')"),
    "massless": ('size="0.1"', 'size="0.1" mass="0"', "mass of base is 0 kg; must be more than 0 kg"),
    "of another group": ("<asset>", '<compiler inertiagrouprange="1 2"/><asset>',
                         "mass of base is 0 kg; must be more than 0 kg"),
    "no file": ('size="0.1"', 'type="mesh" mesh="m"', ":2: mesh: there is no angle.obj in"),
    "own frame": ('file="angle.obj"/>', 'file="angle.obj" refpos="1 0 0"/>', ":2: mesh: refpos: its mass"),
    "method": ('file="angle.obj"/>', 'file="angle.obj" inertia="mine"/>',
               ":2: mesh: inertia: must be legacy, exact, convex or shell (got 'mine')"),
    "format": ('file="angle.obj"/>', 'file="angle.dae"/>', ":2: mesh: angle.dae: Collada is not read"),
    "open": ('file="angle.obj"/>', 'file="open.obj" inertia="exact"/>', "open.obj: is open: 3 of 30 edges"),
    "flat": ('file="angle.obj"/>', 'file="flat.obj"/>', "flat.obj: encloses no volume"),
    "flat hull": ('file="angle.obj"/>', 'file="flat.obj" inertia="convex"/>', "is flat: it has no convex"),
}  # fmt: skip


@pytest.mark.parametrize("name", BAD)
def test_what_is_not_read_of_geoms_is_one_line(tmp_path: Path, name: str) -> None:
    old, new, message = BAD[name]
    assert old in ROBOT
    mesh = angle_piece()
    (tmp_path / "angle.dae").write_text("")
    (tmp_path / "open.obj").write_text(as_obj(Triangles(mesh.vertices, mesh.faces[:-1])))
    (tmp_path / "flat.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 3 4\n")
    path = tmp_path / "robot.xml"
    text = ROBOT.replace(old, new)
    path.write_text(text.replace('size="0.1"', 'type="mesh" mesh="m"') if "file=" in old else text)
    with pytest.raises(InputError) as caught:
        as_scenario({"vehicle": {"preset": "arq", "body": {"model": str(path)}}})
    assert len(caught.value.problems) == 1
    assert caught.value.problems[0].startswith("vehicle.body.model: ")
    assert message in caught.value.problems[0]


def test_a_mesh_that_changes_is_read_again(tmp_path: Path) -> None:
    """Its file is part of the model."""
    path, mesh = tmp_path / "robot.xml", angle_piece()
    path.write_text(ROBOT.replace('size="0.1"', 'type="mesh" mesh="m" density="1"'))
    (tmp_path / "angle.obj").write_text(as_obj(mesh))
    before = mass_of_model(path).mass
    (tmp_path / "angle.obj").write_text(as_obj(Triangles(0.5 * mesh.vertices, mesh.faces)))
    assert mass_of_model(path).mass == pytest.approx(before / 8.0)
