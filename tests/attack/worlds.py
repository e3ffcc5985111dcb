"""Worlds of other programs, damaged or hostile, and what is promised for them.

A file is either read, and then its obstacles have finite numbers and are the same when they are
written as TOML and read back, or refused in lines that a terminal can show.
"""

from __future__ import annotations

import functools
import json
import math
import re
import tempfile
import tomllib
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from hypothesis import strategies as st

from builders.world_files import octomap_binary, octomap_full
from springback.errors import InputError
from springback.scenario.scenario import expand_presets
from springback.scenario.tables import WorldSettings
from springback.scenario.worlds.toml_text import read_world, world_toml

EXAMPLE = Path(__file__).parents[2] / "examples" / "warehouse.sdf"
MJCF = """<mujoco><compiler angle="radian" eulerseq="zyx" meshdir="m"/><default><geom friction="0.4"/>
<default class="post"><geom type="cylinder" size="0.1 0.5"/></default></default>
<asset><mesh name="m" file="m.stl" scale="1 1 1"/><hfield name="h" file="h.png" size="1 1 1 1"/></asset>
<worldbody><include file="post.xml"/><geom type="plane" size="1 1 1"/><body name="b" pos="1 0 0" euler="0.1 0 0">
<joint type="hinge"/><geom class="post" fromto="0 0 0 0 0 1" size="0.1"/><frame quat="1 0 0 1" childclass="post">
<geom xyaxes="1 0 0 0 1 0"/><geom type="box" size="1 2 3" zaxis="0 1 0"/></frame></body>
<geom type="mesh" mesh="m"/><geom type="hfield" hfield="h"/><geom type="ellipsoid" size="1 1 1"/></worldbody></mujoco>"""
URDF = """<robot name="r"><link name="a"><collision><origin xyz="1 0 0" rpy="0 0.1 0"/><geometry>
<box size="1 1 1"/></geometry></collision><visual/></link><link name="b"><collision><geometry>
<cylinder radius="0.1" length="1"/></geometry></collision><collision name="c"><geometry><mesh filename="package://p/a.stl"/>
</geometry></collision></link><joint name="j" type="revolute"><parent link="a"/><child link="b"/>
<origin xyz="0 0 1"/></joint><gazebo reference="b"><mu1>0.3</mu1></gazebo></robot>"""
SDF = """<sdf version="1.9"><world name="w"><include><uri>model://lost</uri></include><include merge="true">
<uri>model://crate</uri><pose relative_to="f">0 0 1 0 0 0</pose></include><frame name="f" attached_to="m"><pose degrees="true">
1 2 3 4 5 6</pose></frame><model name="m" placement_frame="l"><link name="l"><pose relative_to="__model__">0 0 0 0 0 0</pose>
<collision name="c"><pose rotation_format="quat_xyzw">0 0 0 0 0 0 1</pose><geometry><cone><radius>0.2</radius><length>1</length>
</cone></geometry></collision></link><joint name="j" type="revolute"><child>l</child></joint></model></world></sdf>"""
BLOCKS = '{"bounds": {"extents": [-1, 1, -2, 2, 0, 3]}, "blocks": [{"extents": [0, 1, 0, 1, 0, 1]}, {"extents": [2, 3, 0, 1, 0, 1e0]}]}'
CRATE = '<sdf version="1.9"><model name="crate"><link name="k"><collision name="c"><geometry><box><size>1 1 1</size></box></geometry></collision></link></model></sdf>'
#: Pieces that are put into texts.
PIECES = [
    b"-", b"nan", b"inf", b"1e999", b"1e-320", b"0", b"0 0 0", b"1e308", b"\x00", b"\xff\xfe", b"<", b"/>", b"</geom>",
    b"&amp;", b"&x;", b"<!DOCTYPE a>", b"<?x?>", b"<![CDATA[", b"-->", b"../../etc/passwd", b"w.sdf", b"file:///", b"[", b"]}",
    b'"', b"name=", b"<model/>", b"<pose>1</pose>", b"\xc2\x9b31m", b"99999999999999999999", b"true", b"\xe2\x80\xae",
]  # fmt: skip


class WorldFile(NamedTuple):
    """A file and whether its bounds are walls."""

    name: str
    data: bytes
    bounds: bool


def _beginning() -> bytes:
    """The first models of the example, and its end."""
    first, mark, _ = EXAMPLE.read_text().partition("    <!-- A rack across")
    assert mark
    return f"{first}</world></sdf>".encode()


@functools.cache
def whole_files() -> list[tuple[str, bytes]]:
    """Files that are read as they are."""
    cells = {(0, 0, 0), (1, 0, 0), (-3, 2, 1), (5, 5, 5)}
    return [
        ("w.sdf", _beginning()), ("w.sdf", SDF.encode()), ("w.world", SDF.encode()),
        ("w.xml", MJCF.encode()), ("w.urdf", URDF.encode()), ("w.json", BLOCKS.encode()),
        ("w.bt", octomap_binary(cells, 0.2)), ("w.ot", octomap_full(cells, 0.2)),
        ("w.ot", octomap_full(cells, 0.2, b"rgb")),
    ]  # fmt: skip


#: Words of a file: numbers, names, tags.
WORD = re.compile(rb"[^\s<>\"/=\[\]{},:]+")
NUMBERS = [
    b"-1",
    b"0",
    b"1e-300",
    b"1e300",
    b"nan",
    b"inf",
    b"1e9",
    b"1e-9",
    b"1 2",
    b"",
    b"x",
    b"3.14159",
    b"-0",
]


@st.composite
def exchanged_words(draw: st.DrawFn) -> WorldFile:
    """A file in which words are exchanged for others of it, or for numbers: it remains XML or JSON."""
    name, data = draw(st.sampled_from(whole_files()[:6]))
    words = [match.span() for match in WORD.finditer(data)]
    for first, last in sorted(
        draw(st.lists(st.sampled_from(words), min_size=1, max_size=4)), reverse=True
    ):
        a, b = draw(st.sampled_from(words))
        new = draw(st.one_of(st.sampled_from(NUMBERS), st.just(data[a:b])))
        data = data[:first] + new + data[last:]
    return WorldFile(name, data, name == "w.json" and draw(st.booleans()))


@st.composite
def worlds(draw: st.DrawFn) -> WorldFile:
    """A file with words exchanged; or pieces cut out, doubled or put in; or only its beginning."""
    if draw(st.integers(0, 2)):
        return draw(exchanged_words())
    name, data = draw(st.sampled_from(whole_files()))
    for _ in range(draw(st.integers(0, 4))):
        first = draw(st.integers(0, len(data)))
        last = min(len(data), first + draw(st.integers(0, 30)))
        new = draw(st.one_of(
            st.sampled_from(PIECES), st.binary(max_size=4), st.just(data[first:last] * 2), st.just(b""),
        ))  # fmt: skip
        data = data[:first] + new + data[last:]
    if draw(st.integers(0, 4)) == 0:
        data = data[: draw(st.integers(0, len(data)))]
    return WorldFile(name, data, name == "w.json" and draw(st.booleans()))


def _check_finite(value: Any) -> None:
    if isinstance(value, dict | list | tuple):
        for inner in value.values() if isinstance(value, dict) else value:
            _check_finite(inner)
    elif isinstance(value, float):
        assert math.isfinite(value)


def world_file(given: WorldFile) -> None:
    """As `springback world show` and a scenario read it.

    Raises:
        InputError: If it is refused.
    """
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / given.name
        path.write_bytes(given.data)
        crate = Path(folder) / "crate"
        crate.mkdir()
        (crate / "model.sdf").write_text(CRATE)
        (Path(folder) / "post.xml").write_text('<mujoco><geom size="0.1"/></mujoco>')
        found = read_world(path, bounds=given.bounds)
        for part in found.parts:
            _check_finite(part.obstacle.model_dump())
            for body in getattr(part.obstacle, "bodies", list)():
                assert np.isfinite(body.centre).all()
        for line in (*found.unrepresented, *found.remarks):
            assert len(line) < 2500
        again = tomllib.loads(world_toml(found))
        table = expand_presets(again)["world"] if again else {}
        assert WorldSettings.model_validate(table).obstacles == tuple(
            p.obstacle for p in found.parts
        )
        json.dumps(found.model_dump(mode="json"), allow_nan=False)
        if found.unrepresented:
            try:
                read_world(path, bounds=given.bounds, missing="refuse")
            except InputError:
                return
            raise AssertionError("what is not represented was not refused")
