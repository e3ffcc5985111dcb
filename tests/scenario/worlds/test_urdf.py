"""URDF: every collision is where MuJoCo has it; joints are at zero."""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np
import pytest

from builders.world_files import imported, named_parts, seen
from springback import InputError

HEAD = '<robot name="r"><mujoco><compiler fusestatic="false" discardvisual="false"/></mujoco>'


def origin(rng: np.random.Generator) -> str:
    place, angles = rng.uniform(-1, 1, 3), rng.uniform(-3, 3, 3)
    return '<origin xyz="{} {} {}" rpy="{} {} {}"/>'.format(*map(float, (*place, *angles)))


def link(rng: np.random.Generator, k: int) -> str:
    shapes = [
        '<box size="{} {} {}"/>'.format(*map(float, rng.uniform(0.1, 0.9, 3))),
        f'<sphere radius="{float(rng.uniform(0.1, 0.5))}"/>',
        f'<cylinder radius="{float(rng.uniform(0.1, 0.5))}" length="{float(rng.uniform(0.2, 1.0))}"/>',
    ]
    shape = shapes[int(rng.integers(3))]
    inertial = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
    return (
        f'<link name="l{k}">{inertial}<collision name="c{k}">{origin(rng)}<geometry>{shape}</geometry>'
        "</collision></link>"
    )


@pytest.mark.parametrize("seed", range(12))
def test_collisions_are_where_mujoco_has_them(tmp_path: Path, seed: int) -> None:
    """A tree of nine links, whose parent is any of those before."""
    rng = np.random.default_rng(seed)
    parts = [link(rng, k) for k in range(9)]
    moving = 0
    for k in range(1, 9):
        kind = ("fixed", "revolute", "continuous", "prismatic")[int(rng.integers(4))]
        moving += kind != "fixed"
        parts.append(
            f'<joint name="j{k}" type="{kind}"><parent link="l{int(rng.integers(k))}"/>'
            f'<child link="l{k}"/>{origin(rng)}<axis xyz="0 0 1"/>'
            '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>'
        )
    text = HEAD + "".join(parts) + "</robot>"
    world = imported(tmp_path, "r.urdf", text)
    assert len(world.remarks) == moving
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "r.urdf"))
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    places = {tuple(np.round(place, 9)): k for k, place in enumerate(data.geom_xpos)}
    found = named_parts(world)
    assert len(found) == model.ngeom == 9
    for one in map(seen, found.values()):
        near = [k for place, k in places.items() if np.allclose(place, one.centre, atol=1e-8)]
        [k] = near
        turn, size = data.geom_xmat[k].reshape(3, 3), model.geom_size[k]
        assert one.centre == pytest.approx(data.geom_xpos[k], abs=1e-9)
        if model.geom_type[k] == mujoco.mjtGeom.mjGEOM_BOX:
            assert one.axes == pytest.approx(turn.T, abs=1e-9)
            assert one.sizes == pytest.approx(2.0 * size, abs=1e-9)
        elif model.geom_type[k] == mujoco.mjtGeom.mjGEOM_CYLINDER:
            assert one.axis == pytest.approx(turn[:, 2], abs=1e-9)
            assert one.sizes == pytest.approx([size[0], 2.0 * size[1]], abs=1e-9)
        else:
            assert one.sizes == pytest.approx(size[:1], abs=1e-9)


def test_friction_visuals_and_what_is_missing(tmp_path: Path) -> None:
    text = (
        '<robot name="r"><link name="base"><visual/><visual/><collision><geometry><box size="1 1 1"/>'
        '</geometry></collision><collision name="m"><geometry><mesh filename="package://p/a.stl"/></geometry>'
        '</collision><collision name="t"><geometry><torus/></geometry></collision></link>'
        '<gazebo reference="base"><mu1>0.35</mu1></gazebo></robot>'
    )
    world = imported(tmp_path, "r.urdf", text)
    [part] = world.parts
    assert part.name == "base/collision 1"
    assert part.obstacle.surface.friction == 0.35
    assert [line.partition(":")[0] for line in world.unrepresented] == ["base/m", "base/t"]
    assert world.ignored == ("2 visual",)


WRONG = {
    "": "has no link",
    '<link name="a"/><joint type="fixed" name="j"><parent link="a"/><child link="b"/></joint>':
        r"r\.urdf:1: joint: child: there is no link 'b'",
    '<link name="a"/><link name="b"/><joint><parent link="a"/><child link="b"/></joint>'
    '<joint><parent link="b"/><child link="a"/></joint>': "lead round in a circle",
    '<link name="a"/><link name="b"/>' + '<joint><parent link="a"/><child link="b"/></joint>' * 2:
        "link 'b' has two parents",
    '<link name="a"><collision/></link>': "has no geometry",
    '<link name="a"><collision><geometry><box size="1 1 x"/></geometry></collision></link>':
        r"size \[m\]: must be numbers",
    '<xacro:macro xmlns:xacro="x"/><link name="a"/>': "expand the file with xacro first",
}  # fmt: skip


@pytest.mark.parametrize("inner", WRONG)
def test_wrong_files_name_file_and_line(tmp_path: Path, inner: str) -> None:
    with pytest.raises(InputError, match=WRONG[inner]) as refused:
        imported(tmp_path, "r.urdf", f'<robot name="r">{inner}</robot>')
    assert len(refused.value.problems) == 1
