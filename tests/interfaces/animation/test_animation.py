"""Films: what they show is the flight, they are the same again, and wrong wishes get one line."""

import json
import math
import re
import shutil
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner, Result
from PIL import Image

from builders.cases import nonempty
from builders.films import thrown
from springback.contact.library import WALL
from springback.contact.openings import Window
from springback.errors import InputError
from springback.interfaces.animation import bodies, timing
from springback.interfaces.animation import film as animation
from springback.interfaces.animation.frame import Frame
from springback.interfaces.animation.panel import LIGHTER, SHADES, kind_of, lighter, shades_of
from springback.interfaces.cli.app import cli
from springback.interfaces.output.folders import output_folder
from springback.interfaces.replay.geometry import Drawable
from springback.interfaces.replay.hull_meshes import hull_meshes
from springback.interfaces.replay.scene import Scene, scene_of
from springback.interfaces.replay.shape_meshes import mesh_of
from springback.interfaces.replay.tracks import turned_by
from springback.interfaces.reports.flight_files import write_flight
from springback.results.flight import fly
from springback.scenario.scenario import scenario_from

SMALL = (200, 180)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("film") / "arq"
    with output_folder(out) as place:
        write_flight(thrown(), place, figures=False)
    return out


@pytest.fixture(scope="module")
def scene(folder: Path) -> Scene:
    from springback.interfaces.replay.scene import load

    return scene_of(load(folder))


def animate(*words: Any) -> Result:
    return CliRunner().invoke(cli, ["animate", *map(str, words)])


def refused(*words: Any) -> str:
    """The one line that a wrong wish gets."""
    done = animate(*words)
    assert isinstance(done.exception, InputError), done.output
    (line,) = done.exception.problems
    return line


# -- what is shown


def test_a_pose_is_the_flight(scene: Scene) -> None:
    k = int(np.argmax(np.linalg.norm(scene.force, axis=2).sum(axis=1)))
    now = bodies.pose(scene, float(scene.t[k]))
    assert now.position == pytest.approx(scene.position[k])
    assert now.lengths == pytest.approx(scene.arm_length[k])
    assert now.force == pytest.approx(scene.force[k])
    middle = bodies.pose(scene, 0.5 * float(scene.t[k] + scene.t[k + 1]))
    assert middle.position == pytest.approx(0.5 * (scene.position[k] + scene.position[k + 1]))
    assert middle.rotation @ middle.rotation.T == pytest.approx(np.eye(3))


def test_attitudes_turn_the_way_the_house_does() -> None:
    half = math.radians(15.0)
    nose_down = turned_by(np.array([math.cos(half), 0.0, math.sin(half), 0.0]))
    assert nose_down @ [1.0, 0.0, 0.0] == pytest.approx([math.cos(2 * half), 0.0, -0.5])


def test_arms_are_drawn_as_long_as_they_are(scene: Scene) -> None:
    k = int(np.argmin(scene.arm_length[:, 0]))
    assert scene.arm_length[k, 0] < scene.arms[0].length - 1e-3
    now = bodies.pose(scene, float(scene.t[k]))
    tips = bodies.ends(scene.arms, now)
    assert np.linalg.norm(tips - now.position, axis=1) == pytest.approx(scene.arm_length[k])
    for j, arm in enumerate(scene.arms):
        line = bodies.arm_line(arm, now, float(now.lengths[j]))
        assert line[-1] == pytest.approx(tips[j])
        assert line[0] == pytest.approx(now.position)
        coils = np.linalg.norm(line[1:-1] - now.position, axis=1).max()
        assert coils < scene.arm_length[k, j]


def test_cages_and_forces_are_at_the_wall(scene: Scene) -> None:
    side, above = bodies.views(scene)
    touch = bodies.pose(scene, scene.impacts[0][0])
    tips = bodies.ends(scene.arms, touch)
    reach = max(
        float(above(bodies.ring(tip, arm.cage_radius, touch.rotation))[:, 0].max())
        for tip, arm in zip(tips, scene.arms, strict=True)
    )
    (wall,) = scene.obstacles
    area = bodies.half_plane(wall, above, 0.0, 5.0)
    assert area is not None
    face = float(area[:2, 0].mean())
    assert face == pytest.approx(2.75)
    assert reach == pytest.approx(face, abs=1e-3)
    assert area[2:, 0].min() > face  # matter is behind it
    k = int(np.argmax(np.linalg.norm(scene.force, axis=2).sum(axis=1)))
    for force, point in zip(scene.force[k], scene.point[k], strict=True):
        if np.linalg.norm(force) > 0.0:
            assert side(force)[0] < 0.0
            assert side(point)[0] == pytest.approx(face, abs=0.03)


def test_the_obstacle_that_is_hit_stands_on_the_right() -> None:
    assert bodies.views(scene_of(thrown()))[0].right == pytest.approx([1.0, 0.0, 0.0])
    turned = thrown(position=[2.9, 0, 0], normal=[-1, -1, 0])
    side, above = bodies.views(scene_of(turned))
    for view in (side, above):
        assert view.right == pytest.approx([math.sqrt(0.5), math.sqrt(0.5), 0.0])
    assert above.up == pytest.approx([-math.sqrt(0.5), math.sqrt(0.5), 0.0])


def test_a_mesh_is_cut_where_it_meets_the_view() -> None:
    corners = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    thing = Drawable("mesh", "tetrahedron", vertices=corners, triangles=faces)
    view = bodies.ViewPlane(np.array([1.0, 0, 0]), np.array([0, 1.0, 0]), np.array([0, 0, 0.5]))
    pieces = bodies.plane_section(thing, view).reshape(-1, 2)
    assert {tuple(np.round(p, 9)) for p in pieces} == {(0.0, 0.0), (0.5, 0.0), (0.0, 0.5)}


def drawn_window(**fields: Any) -> Drawable:
    window = Window(
        type="window", position=(2.7, 0.0, 1.0), size=(2.4, 1.8), surface=WALL, **fields
    )
    mesh = mesh_of(window)
    return Drawable("mesh", "window", vertices=mesh.vertices, triangles=mesh.triangles, key="w")


def area(outlines: list[np.ndarray]) -> float:
    """With sign: openings wind the other way."""
    after = [np.roll(one, -1, axis=0) for one in outlines]
    pairs = zip(outlines, after, strict=True)
    return sum(0.5 * float((a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum()) for a, b in pairs)


AHEAD = bodies.ViewPlane(np.array([0, -1.0, 0]), np.array([0, 0, 1.0]), np.array([2.7, 0, 1.0]))
BESIDE = bodies.ViewPlane(np.array([1.0, 0, 0]), np.array([0, 0, 1.0]), np.array([2.0, 0, 1.1]))


@pytest.mark.parametrize(
    ("opening", "hole"),
    [({"opening": (0.7, 0.5)}, 0.35), ({"opening_radius": 0.4}, math.pi * 0.16)],
)
def test_an_opening_is_open_in_section_and_silhouette(opening: Any, hole: float) -> None:
    """From in front the wall without its hole; cut through its middle, what is above and below."""
    thing = drawn_window(**opening)
    outline = bodies.silhouette(thing, AHEAD)
    assert len(outline) == 2
    assert area(outline) == pytest.approx(2.4 * 1.8 - hole, rel=0.01)
    assert area(bodies.section_outlines(thing, AHEAD)) == pytest.approx(2.4 * 1.8 - hole, rel=0.01)
    pieces = bodies.section_outlines(thing, BESIDE)
    high = opening["opening"][1] if "opening" in opening else 0.8
    assert len(pieces) == 2
    assert area(pieces) == pytest.approx(0.1 * (1.8 - high), rel=0.02)
    overlap = 0.1 * (1.8 + high)  # the far side of the opening is behind the near side of the wall
    assert area(bodies.silhouette(thing, BESIDE)) == pytest.approx(overlap, rel=0.02)
    far = BESIDE._replace(through=np.array([2.0, 3.0, 1.1]))
    assert bodies.silhouette(thing, far) == []
    assert bodies.section_outlines(thing, far) == []


def test_a_pole_is_seen_from_the_side_along_the_way_flown() -> None:
    """Whatever part of it a cage touches; it is filled, as the wall of another flight is."""
    flight = fly(scenario_from({
        "vehicle": "arq", "thrust": "hover", "simulation": {"duration": "0.2 s"},
        "world": {"obstacles": [{"type": "pole", "position": [2.7, 0.1, 0], "radius": "5 cm",
                                 "surface": "wall"}]},
        "start": {"position": ["2.2 m", 0, "1 m"], "velocity": ["2 m/s", 0, 0]},
    }))  # fmt: skip
    scene = scene_of(flight)
    side, above = bodies.views(scene)
    assert side.right == pytest.approx([1.0, 0.0, 0.0], abs=1e-3)
    [pole] = scene.obstacles
    [circle] = bodies.section_outlines(pole, above)
    assert area([circle]) == pytest.approx(math.pi * 0.05**2, rel=0.02)
    k = int(np.argmax(np.linalg.norm(scene.force, axis=2).sum(axis=1)))
    for force, point in zip(scene.force[k], above(scene.point[k]), strict=True):
        if np.linalg.norm(force) > 0.0:
            away = np.linalg.norm(point - circle.mean(axis=0))
            assert away == pytest.approx(0.05, abs=0.015)
            assert above(force) @ (point - circle.mean(axis=0)) > 0.0


def test_a_shape_of_ones_own_is_in_the_picture(scene: Scene) -> None:
    """A robot that turns back in front of nothing would say something else."""
    corners = np.array([[3.0, y, z] for y in (-1.0, 1.0) for z in (0.0, 2.0)])
    faces, ahead = np.array([[0, 1, 2], [1, 3, 2]]), np.tile([-1.0, 0.0, 0.0], (4, 1))
    wall = Drawable("mesh", "own", vertices=corners, triangles=faces, normals=ahead)
    when = timing.timing([scene], slow=20.0, fps=25.0)
    without, within = (
        Frame([replace(scene, obstacles=things)], when, (400, 360)).at(0)
        for things in (scene.obstacles, (*scene.obstacles, wall))
    )
    assert not np.array_equal(without, within)


def test_the_force_beside_a_picture_is_the_sum_of_those_in_it(scene: Scene) -> None:
    """As vectors, and called so: each arrow is the force on one cage."""
    k = int(np.argmax(np.linalg.norm(scene.force, axis=2).sum(axis=1)))
    picture = Frame([scene], timing.timing([scene], slow=20.0, fps=500.0), (400, 360))
    picture.at(int(np.argmin(np.abs(picture.timing.t - scene.t[k] + scene.impacts[0][0]))))
    said = picture.said[0][0].get_text().split(", arms")[0]
    found = re.fullmatch(r"contact, sum (\d+) N", said)
    assert found, said
    parts = np.linalg.norm(scene.force[k], axis=1)
    assert np.count_nonzero(parts) == 2
    whole = np.linalg.norm(scene.force[k].sum(axis=0))
    assert whole < 0.95 * parts.sum()  # friction of one cage cancels that of the other
    assert float(found[1]) == pytest.approx(whole, rel=0.02)


def test_words_cover_neither_robots_nor_obstacles(scene: Scene) -> None:
    """Names and numbers are above the views: an obstacle at the right edge was behind them."""
    for scenes, size in nonempty([([scene], (400, 360)), ([scene, scene], (720, 540))]):
        picture = Frame(scenes, timing.timing(scenes, slow=20.0, fps=25.0), size)
        picture.at(0)
        top = max(upper.ax.get_window_extent().y1 for upper, _ in picture.panels)
        lines = [line for said in picture.said for line in said]
        written = [text for text in picture.figure.texts if text.get_text()]
        assert set(lines) < set(written)
        boxes = [text.get_window_extent() for text in written]
        assert min(box.y0 for box in boxes) >= top
        for k, box in enumerate(boxes):
            assert box.x0 >= 0.0
            assert box.x1 <= size[0]
            assert not any(box.overlaps(other) for other in boxes[:k])


def test_obstacles_of_different_kinds_are_told_apart_and_walls_are_as_ever() -> None:
    """A box at rest and one that moves are two kinds; ground and mat have their own colours."""
    mesh: dict[str, Any] = {"vertices": np.zeros((3, 3)), "triangles": np.array([[0, 1, 2]])}
    things = [
        Drawable("mesh", "box", **mesh), Drawable("mesh", "pole", **mesh),
        Drawable("wall", "wall", normal=(1.0, 0.0, 0.0)), Drawable("mesh", "box", track=0, **mesh),
        Drawable("ground", "ground", normal=(0.0, 0.0, 1.0)), Drawable("mesh", "box", **mesh),
    ]  # fmt: skip
    shades = shades_of(things)
    found = [shades[kind_of(one)] for one in things]
    assert len(set(found)) == 5
    assert found[0] == found[5]
    assert shades["wall"] == SHADES[0]
    assert len(set(SHADES)) == len(SHADES)
    red, green, blue = (int(lighter("#000000")[k : k + 2], 16) / 255.0 for k in (1, 3, 5))
    assert red == green == blue == pytest.approx(LIGHTER, abs=0.01)


def test_a_picture_changes_where_something_moves_and_nowhere_else(scene: Scene) -> None:
    when = timing.timing([scene], slow=20.0, fps=25.0)
    picture = Frame([scene], when, (400, 360))
    first, same, other = picture.at(0), picture.at(0), picture.at(len(when.t) // 2)
    assert first.shape == (360, 400, 3)
    assert np.array_equal(first, same)
    assert not np.array_equal(first, other)
    foot = slice(int(360 * 0.97), None)  # below the curve
    assert np.array_equal(first[foot], other[foot])


def test_the_acceleration_is_drawn_over_the_whole_film(scene: Scene) -> None:
    for begin, end in ((None, None), (-0.02, 0.1)):
        when = timing.timing([scene], slow=20.0, fps=25.0, begin=begin, end=end)
        picture = Frame([scene], when, SMALL)
        assert picture.curve.ax.get_xlim() == pytest.approx((1e3 * when.begin, 1e3 * when.end))
        picture.at(len(when.t) - 1)
        line, dot, _, _ = picture.curve.curves[0]
        now = float(np.asarray(dot.get_xdata())[0])
        assert now == np.asarray(line.get_xdata())[-1] == pytest.approx(1e3 * when.t[-1])
        assert now >= 1e3 * (when.end - (when.t[-1] - when.t[-2]))


@pytest.mark.parametrize("corner", [0.0, 0.1], ids=["ball", "rounded box"])
def test_round_hulls_are_drawn_round(corner: float) -> None:
    """Seen from anywhere an outline is beside the true one by a 200th of its radius at most."""
    low, high = np.array([-corner, -corner, -0.5 * corner]), np.array([corner, 0.0, corner])
    points = [np.where([k & 1, k & 2, k & 4], high, low) for k in range(8 if corner else 1)]
    hull: dict[str, Any] = {
        "type": "points",
        "points": [point.tolist() for point in points],
        "radius": 0.1,
    }
    if not corner:
        hull = {"type": "sphere", "position": [0, 0, 0], "radius": 0.1}
    vehicle = scenario_from({"vehicle": {"preset": "arq", "hulls": [hull]}}).vehicle
    (mesh,) = hull_meshes(vehicle, "body")
    for way in nonempty(list(np.random.default_rng(1).normal(size=(200, 3)))):
        way /= np.linalg.norm(way)
        true = max(float(point @ way) for point in points) + 0.1
        assert true - 5e-4 <= float((mesh.vertices @ way).max()) <= true + 1e-12


# -- timing


def test_impacts_are_slow_and_the_rest_is_not(scene: Scene) -> None:
    when = timing.timing([scene], slow=40.0, fps=25.0, begin=-0.1, end=0.15)
    steps = np.diff(when.t)
    assert np.all(steps > 0.0)
    a, b = scene.impacts[0]
    hit = (when.t[:-1] > 0.0) & (when.t[1:] < b - a)
    assert steps[hit] == pytest.approx(1.0 / (25.0 * 40.0), rel=0.02)
    assert steps[0] == pytest.approx(1.0 / (25.0 * timing.LIFE), rel=0.02)
    assert when.slowness.min() == pytest.approx(timing.LIFE)
    assert when.slowness.max() == pytest.approx(40.0)
    assert (when.t[0], when.begin) == pytest.approx((-0.1, -0.1))


def test_two_flights_touch_at_the_same_time(scene: Scene) -> None:
    later = replace(
        scene, t=scene.t + 1.0, impacts=tuple((a + 1.0, b + 1.0) for a, b in scene.impacts)
    )
    assert timing.origin(later) == pytest.approx(timing.origin(scene) + 1.0)
    alone = timing.timing([scene], slow=20.0, fps=20.0)
    both = timing.timing([scene, later], slow=20.0, fps=20.0)
    assert both.t == pytest.approx(alone.t, abs=1e-9)


def test_a_flight_that_touches_nothing_is_shown_whole(scene: Scene) -> None:
    free = replace(scene, impacts=(), force=0.0 * scene.force)
    when = timing.timing([free], slow=20.0, fps=10.0)
    assert (when.begin, when.end) == (0.0, pytest.approx(float(scene.t[-1])))
    assert when.slow == ()
    assert Frame([free], when, SMALL).at(0).shape == (180, 200, 3)


# -- files


def frames_of(path: Path) -> tuple[int, float]:
    """Frames and duration [s]."""
    with Image.open(path) as film:
        durations = []
        for k in range(film.n_frames):  # type: ignore[attr-defined]
            film.seek(k)
            film.load()
            durations.append(film.info["duration"])
        assert film.info.get("loop") == 0
        return len(durations), 1e-3 * sum(durations)


@pytest.mark.parametrize("suffix", [".gif", ".webp"])
def test_the_same_flight_gives_the_same_bytes(folder: Path, tmp_path: Path, suffix: str) -> None:
    words = ("--size", "200x180", "--from", "-0.02", "--to", "0.04", "--fps", "20")
    made = [tmp_path / f"{name}{suffix}" for name in "ab"]
    for path in made:
        done = animate(folder, "--out", path, *words)
        assert done.exit_code == 0, done.output
    assert made[0].read_bytes() == made[1].read_bytes()
    count, lasts = frames_of(made[0])
    assert f"{count} frames" in done.output
    assert lasts == pytest.approx((count - 1) / 20.0 + 0.05 + animation.HOLD, abs=0.06)
    assert sorted(p.name for p in tmp_path.iterdir()) == sorted(p.name for p in made)


def test_two_flights_and_mp4(folder: Path, tmp_path: Path) -> None:
    av = pytest.importorskip("av", reason="mp4 needs the extra video")
    words = ("--size", "200x180", "--from", "-0.01", "--to", "0.02", "--fps", "20", "-q")
    made = [tmp_path / name for name in ("a.mp4", "b.mp4")]
    for path in made:
        assert animate(folder, folder, "--out", path, *words).exit_code == 0
    header = made[0].read_bytes()
    movie = header.index(b"mvhd") + 8  # after version and flags, the time of creation
    assert header[movie : movie + 4] == b"\0\0\0\0"
    assert b"Lavf" not in header  # nor by whom
    films = []
    for path in made:
        with av.open(str(path)) as film:
            films.append([frame.to_ndarray(format="rgb24") for frame in film.decode(video=0)])
    # Not the bytes: in one run, on a busy machine, the encoder coded the same pictures otherwise.
    assert np.array_equal(*films)
    pictures = films[0]
    assert pictures[0].shape == (180, 200, 3)
    assert not np.array_equal(pictures[0], pictures[-1])


def test_two_flights_of_one_robot_go_by_their_folders(folder: Path, tmp_path: Path) -> None:
    """Above their panels and in the legend; the command says in which settings they differ."""
    other = tmp_path / "softer"
    with output_folder(other) as place:
        tables = json.loads((folder / "summary.json").read_text())["scenario"]
        soft = scenario_from(tables).vehicle.model_copy(update={"arms": {"stiffness": "2 N/mm"}})
        write_flight(fly(scenario_from(tables | {"vehicle": soft})), place, figures=False)
    out = tmp_path / "film.gif"
    words = ("--size", "200x180", "--from", "0", "--to", "0.01", "--fps", "20")
    done = animate(folder, other, "--out", out, *words)
    assert done.exit_code == 0, done.output
    assert "ARQ (softer): differs from ARQ (arq) in vehicle.arms.stiffness (2000" in done.output
    labels = enumerate(("ARQ (arq)", "ARQ (softer)"))
    scenes = [replace(scene_of(thrown()), label=label, world=k) for k, label in labels]
    picture = Frame(scenes, timing.timing(scenes, slow=20.0, fps=25.0), (400, 360))
    titles = [text.get_text() for text in picture.figure.texts]
    legend = picture.curve.ax.get_legend()
    assert legend is not None
    keys = [text.get_text() for text in legend.get_texts()]
    assert set(keys) == {"ARQ (arq)", "ARQ (softer)"} <= set(titles)


def test_durations_add_up_to_the_time_that_is_shown() -> None:
    for fps in (7.0, 24.0, 25.0, 30.0):
        stays = animation._durations(100, fps)
        assert sum(stays) == pytest.approx(1e3 * (100 / fps + animation.HOLD), abs=10.0)
        assert all(stay % 10 == 0 for stay in stays)


# -- wrong wishes


def test_what_cannot_be_gets_one_line_and_leaves_nothing(folder: Path, tmp_path: Path) -> None:
    out = tmp_path / "film.gif"
    assert "must end in .gif, .webp, .mp4" in refused(folder, "--out", tmp_path / "film.avi")
    assert "--from 1 s must be before --to 0.5 s" in refused(folder, "--out", out, "--from", "1", "--to", "0.5")  # fmt: skip
    assert "the flight is from" in refused(folder, "--out", out, "--from", "50", "--to", "60")
    assert "must be WIDTHxHEIGHT" in refused(folder, "--out", out, "--size", "big")
    assert "99999 px must be from" in refused(folder, "--out", out, "--size", "99999x200")
    assert "even width" in refused(folder, "--out", tmp_path / "a.mp4", "--size", "201x180")
    assert "--fps 0.5: must be from 1" in refused(folder, "--out", out, "--fps", "0.5")
    assert "finite" in refused(folder, "--out", out, "--from", "nan")
    assert "frames is too long" in refused(folder, "--out", out, "--slow", "1000")
    assert "no such folder" in refused(tmp_path / "none", "--out", out)
    assert "summary.json" in refused(tmp_path, "--out", out)
    assert "one folder, or two" in refused("--out", out)
    assert "one folder, or two" in refused(folder, folder, folder, "--out", out)
    out.write_text("mine")
    assert "already exists" in refused(folder, "--out", out)
    assert out.read_text() == "mine"
    assert [path.name for path in tmp_path.iterdir()] == ["film.gif"]


def test_the_command_tells_of_later_impacts_where_it_chose_the_end(
    folder: Path, tmp_path: Path, scene: Scene, monkeypatch: pytest.MonkeyPatch
) -> None:
    (begin, end), *_ = scene.impacts
    hit_again = replace(scene, impacts=((begin, end), (begin + 1.0, end + 1.0)))
    monkeypatch.setattr("springback.interfaces.replay.labels.scenes_of", lambda *_: [hit_again])
    small = ("--fps", 2, "--size", "160x160", "--force", "--out", tmp_path / "film.gif")
    assert "a later impact, 1 s after the first touch" in animate(folder, *small).output
    assert "later" not in animate(folder, *small, "--to", 0.05).output
    flat = " ".join(animate("--help").output.split())
    assert "[default: -0.3;" in flat
    assert "[default: 0.8;" in flat
    assert (timing.BEFORE, timing.AFTER) == (0.3, 0.8)


def test_a_missing_extra_is_named(folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:  # fmt: skip
    monkeypatch.setitem(sys.modules, "av", None)
    assert "[video]" in refused(folder, "--out", tmp_path / "a.mp4")


def test_a_flight_without_its_trajectory_says_so(folder: Path, tmp_path: Path) -> None:
    torn = tmp_path / "torn"
    shutil.copytree(folder, torn)
    (torn / "trajectory.parquet").unlink()
    assert "trajectory.parquet" in refused(torn, "--out", tmp_path / "a.gif")
