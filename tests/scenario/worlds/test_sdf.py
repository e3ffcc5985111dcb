"""SDF: frames nested and named, includes, shapes, and what is not represented."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from builders.cases import nonempty
from builders.world_files import BOX, imported, named_parts, sdf, sdf_model, seen
from springback import InputError, read_world


class Frame:
    """A pose by SciPy: an oracle of another road."""

    def __init__(self, numbers: list[float]) -> None:
        self.r, self.t = Rotation.from_euler("xyz", numbers[3:]), np.array(numbers[:3])

    def then(self, inner: Frame) -> Frame:
        found = Frame([0.0] * 6)
        found.r, found.t = self.r * inner.r, self.r.apply(inner.t) + self.t
        return found

    def back(self) -> Frame:
        found = Frame([0.0] * 6)
        found.r = self.r.inv()
        found.t = -found.r.apply(self.t)
        return found


def text(numbers: list[float]) -> str:
    return " ".join(map(repr, numbers))


def check_box(obstacle: object, frame: Frame) -> None:
    found = seen(obstacle)
    assert found.centre == pytest.approx(frame.t, abs=1e-9)
    assert found.axes == pytest.approx(frame.r.as_matrix().T, abs=1e-9)


@pytest.mark.parametrize("seed", range(20))
def test_poses_nest(tmp_path: Path, seed: int) -> None:
    """World, model, nested model, link, collision, each with a pose, one of a frame beside it."""
    rng = np.random.default_rng(seed)
    model, inner, link, collision, frame, far = (
        [float(x) for x in (*rng.uniform(-3, 3, 3), *rng.uniform(-3.1, 3.1, 3))] for _ in range(6)
    )
    text_of_world = sdf(
        f'<model name="m"><static>1</static><pose>{text(model)}</pose>'
        f'<frame name="f"><pose>{text(frame)}</pose></frame>'
        f'<model name="n"><pose relative_to="f">{text(inner)}</pose>'
        f'<link name="l"><pose>{text(link)}</pose><collision name="c"><pose>{text(collision)}</pose>'
        f"<geometry>{BOX}</geometry></collision>"
        f'<collision name="d"><pose relative_to="__model__">{text(far)}</pose>'
        f"<geometry>{BOX}</geometry></collision></link></model>"
        f'<link name="k"><pose relative_to="n::l">{text(far)}</pose>'
        f'<collision name="c"><geometry>{BOX}</geometry></collision></link></model>'
    )
    parts = named_parts(imported(tmp_path, "w.sdf", text_of_world))
    nested = Frame(model).then(Frame(frame)).then(Frame(inner))
    check_box(parts["m/n/l/c"], nested.then(Frame(link)).then(Frame(collision)))
    check_box(parts["m/n/l/d"], nested.then(Frame(far)))
    check_box(parts["m/k/c"], nested.then(Frame(link)).then(Frame(far)))


def test_frames_follow_what_they_are_attached_to(tmp_path: Path) -> None:
    a, b, c = (
        [1.0, 2.0, 3.0, 0.1, 0.2, 0.3],
        [0.5, 0.0, 0.0, 0.0, 0.4, 0.0],
        [0.0, 1.0, 0.0, 0.7, 0.0, 0.0],
    )
    model = (
        f'<model name="m"><static>true</static><link name="l"><pose>{text(a)}</pose></link>'
        f'<frame name="f" attached_to="l"><pose>{text(b)}</pose></frame>'
        f'<joint name="j" type="fixed"><parent>l</parent><child>k</child><pose>{text(c)}</pose></joint>'
        f'<link name="k"><pose relative_to="f">{text(c)}</pose><collision name="c"><geometry>{BOX}'
        f'</geometry></collision></link><link name="i"><pose relative_to="j"/><collision name="c">'
        f"<geometry>{BOX}</geometry></collision></link></model>"
    )
    parts = named_parts(imported(tmp_path, "w.sdf", sdf(model)))
    k = Frame(a).then(Frame(b)).then(Frame(c))
    check_box(parts["m/k/c"], k)
    check_box(parts["m/i/c"], k.then(Frame(c)))  # a joint is in its child


def test_a_model_is_placed_by_one_of_its_frames(tmp_path: Path) -> None:
    pose, frame = [3.0, 1.0, 0.5, 0.3, -0.2, 1.0], [0.2, 0.4, 0.6, 0.5, 0.1, -0.3]
    model = (
        f'<model name="m" placement_frame="f"><static>true</static><pose>{text(pose)}</pose>'
        f'<frame name="f"><pose>{text(frame)}</pose></frame><link name="l"><collision name="c">'
        f"<geometry>{BOX}</geometry></collision></link></model>"
    )
    parts = named_parts(imported(tmp_path, "w.sdf", sdf(model)))
    check_box(parts["m/l/c"], Frame(pose).then(Frame(frame).back()))


def test_degrees_and_quaternions(tmp_path: Path) -> None:
    q = Rotation.from_euler("xyz", [0.4, -0.3, 2.0]).as_quat()
    models = [
        sdf_model("a", BOX).replace("<pose>0 0 0 0 0 0", '<pose degrees="true">1 2 3 10 20 30'),
        sdf_model("b", BOX).replace(
            "<pose>0 0 0 0 0 0",
            f'<pose rotation_format="quat_xyzw">1 2 3 {" ".join(str(2.0 * x) for x in q)}',
        ),
    ]
    parts = named_parts(imported(tmp_path, "w.sdf", sdf(*models)))
    check_box(parts["a/link/collision"], Frame([1.0, 2.0, 3.0, *np.radians([10.0, 20.0, 30.0])]))
    check_box(parts["b/link/collision"], Frame([1.0, 2.0, 3.0, 0.4, -0.3, 2.0]))


@pytest.mark.parametrize("pitch", [0.5 * np.pi, -0.5 * np.pi, 0.5 * np.pi - 1e-7, 1.5])
def test_what_stands_on_its_nose_is_exact(tmp_path: Path, pitch: float) -> None:
    pose = [1.0, 0.0, 0.0, 0.7, pitch, -2.0]
    parts = named_parts(imported(tmp_path, "w.sdf", sdf(sdf_model("a", BOX, text(pose)))))
    check_box(parts["a/link/collision"], Frame(pose))


def test_every_shape(tmp_path: Path) -> None:
    pose = [1.0, -2.0, 3.0, 0.4, 0.5, 0.6]
    shapes = {
        "sphere": "<sphere><radius>0.3</radius></sphere>",
        "cylinder": "<cylinder><radius>0.2</radius><length>1.5</length></cylinder>",
        "capsule": "<capsule><radius>0.1</radius><length>0.8</length></capsule>",
        "cone": "<cone><radius>0.4</radius><length>0.9</length></cone>",
        "ball": "<ellipsoid><radii>0.25 0.25 0.25</radii></ellipsoid>",
    }
    models = [sdf_model(name, shape, text(pose)) for name, shape in shapes.items()]
    parts = named_parts(imported(tmp_path, "w.sdf", sdf(*models)))
    kinds = {name.partition("/")[0]: one.type for name, one in parts.items()}
    assert kinds == {"sphere": "sphere", "cylinder": "pole", "capsule": "capsule", "cone": "cone", "ball": "sphere"}  # fmt: skip
    sizes = {"sphere": [0.3], "cylinder": [0.2, 1.5], "capsule": [0.1, 0.8], "cone": [0.4, 0.9], "ball": [0.25]}  # fmt: skip
    for name, size in sizes.items():
        found = seen(parts[f"{name}/link/collision"])
        assert found.centre == pytest.approx(pose[:3], abs=1e-12)
        assert found.sizes == pytest.approx(size, abs=1e-12)
        if len(size) == 2:
            assert found.axis == pytest.approx(Frame(pose).r.apply([0.0, 0.0, 1.0]), abs=1e-12)


def test_planes_are_the_ground_or_walls(tmp_path: Path) -> None:
    plane = "<plane><normal>0 0 2</normal><size>1 1</size></plane>"
    upside = "<plane><normal>0 0 -1</normal></plane>"
    world = imported(tmp_path, "w.sdf", sdf(
        sdf_model("floor", plane, "1 2 0.25 0 0 0.5"), sdf_model("ramp", plane, "1 2 3 0.3 0 0"),
        sdf_model("ceiling", upside, "0 0 4 0 0 0"),
    ))  # fmt: skip
    floor, ramp, ceiling = (part.obstacle for part in world.parts)
    assert (floor.type, floor.height) == ("ground", 0.25)
    assert ramp.position == (1.0, 2.0, 3.0)
    assert ramp.normal == pytest.approx([0.0, -np.sin(0.3), np.cos(0.3)])
    assert ceiling.normal == pytest.approx([0.0, 0.0, -1.0])
    assert world.unrepresented == ()


def test_friction_is_taken_over_unless_a_surface_is_named(tmp_path: Path) -> None:
    def with_friction(name: str, mu: str) -> str:
        law = f"<surface><friction><ode><mu>{mu}</mu></ode></friction></surface></collision>"
        return sdf_model(name, BOX).replace("</collision>", law)

    models = sdf(with_friction("a", "0.3"), sdf_model("b", BOX), with_friction("c", "100"),
                 with_friction("shelf_1", "0.4"))  # fmt: skip
    world = imported(tmp_path, "w.sdf", models, surface="wall", surfaces={"shelf*": "mat"})
    frictions = [part.obstacle.surface.friction for part in world.parts]
    plain = read_world(tmp_path / "w.sdf", friction="surface")
    wall = plain.surface.friction
    assert frictions[:3] == [0.3, wall, 2.0]
    assert world.parts[3].obstacle.surface == world.surfaces["shelf*"]
    assert [part.obstacle.surface.friction for part in plain.parts] == [wall] * 4
    assert world.remarks == ("c/link/collision: friction 100 of the file is taken as 2",)


# -- includes -------------------------------------------------------------------------------------


def library(folder: Path) -> Path:
    """A library of two models: a crate, and a stack of two crates in which the upper is moved."""
    crate, stack = folder / "models" / "crate", folder / "models" / "stack"
    for one in (crate, stack):
        one.mkdir(parents=True)
    crate_text = '<sdf version="1.7"><model name="crate"><pose>0 0 0.5 0 0 0</pose><link name="l"><collision name="c"><geometry><box><size>1 1 1</size></box></geometry></collision></link></model></sdf>'  # fmt: skip
    (crate / "model-1_7.sdf").write_text(crate_text)
    (crate / "model.sdf").write_text(crate_text.replace("1 1 1", "9 9 9"))
    (crate / "model.config").write_text(
        '<model><sdf version="1.5">model.sdf</sdf><sdf version="1.10">model-1_7.sdf</sdf></model>'
    )
    (stack / "model.sdf").write_text(
        '<sdf version="1.9"><model name="stack"><include><uri>model://crate</uri><name>low</name></include>'
        "<include><uri>model://crate</uri><name>high</name><pose>0.1 0 1.5 0 0 0.3</pose></include></model></sdf>"
    )
    return folder / "models"


def test_includes_are_found_along_the_search_path(tmp_path: Path) -> None:
    models = library(tmp_path)
    (tmp_path / "worlds").mkdir()
    world = sdf(
        "<include><uri>model://crate</uri><static>true</static></include>",
        "<include><uri>model://stack</uri><name>s</name><pose>2 0 0 0 0 1</pose></include>",
        "<include><uri>model://sun</uri></include>",
        "<include><uri>model://ground_plane</uri></include>",
    )
    found = imported(tmp_path / "worlds", "w.world", world, search=[models])
    parts = named_parts(found)
    assert parts["crate/l/c"].position == (
        0.0,
        0.0,
        0.5,
    )  # its own pose, where the include has none
    assert parts["crate/l/c"].size == (1.0, 1.0, 1.0)  # the newest of model.config
    check_box(parts["s/low/l/c"], Frame([2, 0, 0, 0, 0, 1]).then(Frame([0, 0, 0.5, 0, 0, 0])))
    check_box(parts["s/high/l/c"], Frame([2, 0, 0, 0, 0, 1]).then(Frame([0.1, 0, 1.5, 0, 0, 0.3])))
    assert parts["ground_plane"].type == "ground"
    assert found.ignored == ("1 light",)
    alone = read_world(tmp_path / "worlds" / "w.world")
    assert len(alone.unrepresented) == 2
    assert all("there is no model://" in line for line in alone.unrepresented)
    with pytest.raises(
        InputError, match="has 2 elements that cannot be represented: crate: there is"
    ):
        read_world(tmp_path / "worlds" / "w.world", missing="refuse")


def test_merged_models_share_their_frames(tmp_path: Path) -> None:
    models = library(tmp_path)
    outer = models / "outer"
    outer.mkdir()
    (outer / "model.sdf").write_text(
        '<sdf version="1.9"><model name="outer"><include merge="true"><uri>model://crate</uri></include>'
        '<link name="k"><pose relative_to="l">0 0 2 0 0 0</pose><collision name="c"><geometry><sphere>'
        "<radius>0.1</radius></sphere></geometry></collision></link></model></sdf>"
    )
    parts = named_parts(read_world(outer / "model.sdf", search=[models]))
    assert parts["outer/k/c"].position == (0.0, 0.0, 2.5)
    assert set(parts) == {"outer/k/c", "outer/l/c"}


def test_includes_that_cannot_be_followed(tmp_path: Path) -> None:
    models = library(tmp_path)
    (models / "crate" / "model-1_7.sdf").write_text(
        '<sdf version="1.9"><model name="crate"><include><uri>model://stack</uri></include></model></sdf>'
    )
    world = tmp_path / "w.sdf"
    world.write_text(sdf("<include><uri>model://stack</uri></include>"))
    with pytest.raises(
        InputError, match=r"includes itself: w\.sdf -> model\.sdf -> model-1_7\.sdf -> model\.sdf"
    ):
        read_world(world, search=[models])
    secret = tmp_path / "secret.sdf"
    secret.write_text(sdf(sdf_model("a", BOX)))
    inside = tmp_path / "inside"
    inside.mkdir()
    for uri in ("../secret.sdf", f"file://{secret}", "model://../secret.sdf", str(secret)):
        world = inside / "w.sdf"
        world.write_text(sdf(f"<include><uri>{uri}</uri></include>"))
        [line] = read_world(world).unrepresented
        assert "outside" in line or "there is no" in line
        assert read_world(world).parts == ()
    (inside / "link.sdf").symlink_to(secret)
    (inside / "w.sdf").write_text(sdf("<include><uri>link.sdf</uri></include>"))
    [line] = read_world(inside / "w.sdf").unrepresented
    assert "outside the folder" in line


def test_a_graph_of_includes_that_grows_is_refused(tmp_path: Path) -> None:
    """Two includes of a file of two includes ...: 2²⁵ models without a single shape."""
    for k in range(25):
        name = f"<include><uri>m{k + 1}.sdf</uri></include>" * 2
        (tmp_path / f"m{k}.sdf").write_text(
            f'<sdf version="1.9"><model name="m">{name}</model></sdf>'
        )
    (tmp_path / "m25.sdf").write_text('<sdf version="1.9"><model name="m"/></sdf>')
    (tmp_path / "w.sdf").write_text(sdf("<include><uri>m0.sdf</uri></include>"))
    with pytest.raises(InputError, match="is one of more than 20000"):
        read_world(tmp_path / "w.sdf")


# -- what is not there ----------------------------------------------------------------------------


def test_what_is_not_represented_is_listed_by_name(tmp_path: Path) -> None:
    shapes = {
        "egg": "<ellipsoid><radii>1 2 3</radii></ellipsoid>",
        "room": "<polyline><point>0 0</point><height>1</height></polyline>",
        "hill": "<heightmap><uri>hill.tif</uri></heightmap>",
        "statue": "<mesh><uri>model://statue/mesh.dae</uri></mesh>",
        "part": "<mesh><uri>a.stl</uri><submesh><name>p</name></submesh></mesh>",
        "image": "<image><uri>a.png</uri></image>",
    }
    (tmp_path / "hill.tif").write_bytes(b"x")
    models = [sdf_model(name, shape) for name, shape in shapes.items()]
    others = [
        '<actor name="walker"/>',
        '<population name="crowd"/>',
        '<light name="lamp"/>',
        "<plugin/>",
    ]
    found = imported(tmp_path, "w.sdf", sdf(*models, *others))
    named = [line.partition(":")[0].partition("/")[0] for line in found.unrepresented]
    assert sorted(named) == sorted([*shapes, "walker", "crowd"])
    assert found.parts == ()
    assert found.ignored == ("1 light", "1 plugin")


def test_what_moves_is_at_rest_and_said(tmp_path: Path) -> None:
    model = (
        sdf_model("door", BOX)
        .replace("<static>true</static>", "<static>false</static>")
        .replace(
            "</model>",
            '<joint name="hinge" type="revolute"><parent>world</parent><child>link</child></joint></model>',
        )
    )
    found = imported(tmp_path, "w.sdf", sdf(model))
    assert len(found.parts) == 1
    assert found.remarks == ("door: can move there (joint hinge), and is at rest here",)


WRONG = {
    "<box><size>0.4 -1 2</size></box>": r"w\.sdf:2: size \[m\]: must be above 0 \(got -1\)",
    "<box><size>0.4 1</size></box>": r"must be 3 numbers \(got '0\.4 1'\)",
    "<box><size>0.4 nan 2</size></box>": r"must be finite, at most 1e\+09 in size \(got nan\)",
    "<box><size>0.4 1e300 2</size></box>": r"must be finite, at most 1e\+09",
    "<box><size>0.4 wide 2</size></box>": r"must be numbers \(got '0\.4 wide 2'\)",
    "<box/>": r"w\.sdf:2: box: size is missing",
    "<sphere><radius>0</radius></sphere>": r"radius \[m\]: must be above 0 \(got 0\)",
    "<sphere><radius>1e-300</radius></sphere>": r"a/link/collision: radius: must be 0, or at least 1e-30 m",
    "<cylinder><radius>1</radius></cylinder>": r"cylinder: length is missing",
    "<plane><normal>0 0 0</normal></plane>": r"normal: must not be zero",
    "<mesh><uri>a.stl</uri><scale>1 0 1</scale></mesh>": r"scale: must not be zero",
}  # fmt: skip


@pytest.mark.parametrize("geometry", WRONG)
def test_wrong_numbers_name_file_and_line(tmp_path: Path, geometry: str) -> None:
    with pytest.raises(InputError, match=WRONG[geometry]) as refused:
        imported(tmp_path, "w.sdf", sdf(sdf_model("a", geometry)))
    assert len(refused.value.problems) == 1


def test_frames_that_are_not_there_or_go_round(tmp_path: Path) -> None:
    pose = '<link name="link"><pose relative_to="{}"/>'
    for name, said in (
        ("g", "there is no frame 'g'"),
        ("f", "is relative to itself: f -> link -> f"),
    ):
        frame = '<frame name="f"><pose relative_to="link"/></frame>'
        model = sdf_model("a", BOX, extra=frame).replace('<link name="link">', pose.format(name))
        with pytest.raises(InputError, match=said):
            imported(tmp_path, "w.sdf", sdf(model))
    chain = "".join(
        f'<frame name="f{k}"><pose relative_to="f{k + 1}"/></frame>' for k in range(3000)
    )
    model = sdf_model("a", BOX, extra=chain).replace('<link name="link">', pose.format("f0"))
    with pytest.raises(InputError, match="depend on too many others"):
        imported(tmp_path, "w.sdf", sdf(model))


def test_ten_thousand_boxes_are_the_most(tmp_path: Path) -> None:
    collision = f'<collision name="c"><geometry>{BOX}</geometry></collision>'
    many = f'<model name="m"><static>1</static><link name="l">{collision * 10_000}</link></model>'
    assert len(imported(tmp_path, "w.sdf", sdf(many)).parts) == 10_000
    with pytest.raises(InputError, match="has more than 10000 elements"):
        imported(tmp_path, "v.sdf", sdf(many.replace("</link>", f"{collision}</link>")))


def test_names_are_told_apart(tmp_path: Path) -> None:
    found = imported(tmp_path, "w.sdf", sdf(sdf_model("a", BOX), sdf_model("a", BOX)))
    names = [part.name for part in nonempty(found.parts)]
    assert names == ["a/link/collision", "a/link/collision (2)"]
