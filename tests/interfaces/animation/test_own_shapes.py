"""Shapes of the user's own in films: round where they are round, filled where they are cut."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from builders.films import thrown
from builders.user_obstacles import Ball
from springback.interfaces.animation import timing
from springback.interfaces.animation.bodies import ViewPlane, section_outlines
from springback.interfaces.animation.frame import Frame
from springback.interfaces.animation.panel import SHADES, lighter
from springback.interfaces.animation.user_surfaces import cut, smooth
from springback.interfaces.replay.geometry import Drawable
from springback.interfaces.replay.scene import Scene, scene_of
from springback.kernels.vectors import Vec
from springback.results.meshes import surface_of

MIDDLE = np.array([2.9, 0.1, 1.0])
LEVEL = ViewPlane(np.array([1.0, 0, 0]), np.array([0, 1.0, 0]), MIDDLE)


@pytest.fixture(scope="module")
def flat() -> Scene:
    return scene_of(thrown())


def ball(radius: float, above: float = 0.0, reach: float = 1.2) -> Drawable:
    """A ball, or the piece of it within a box."""
    centre = Vec(*(MIDDLE + np.array([0.0, 0.0, above])))
    mesh = surface_of(Ball(centre, radius), MIDDLE - reach, MIDDLE + reach)
    return Drawable(
        "mesh", "ball", vertices=mesh.vertices, triangles=mesh.triangles, normals=mesh.normals
    )


def section_errors(thing: Drawable, radius: float) -> Any:
    [circle] = section_outlines(thing, LEVEL)
    between = 0.5 * (circle[1:] + circle[:-1])
    return np.abs(np.linalg.norm(between - LEVEL(MIDDLE), axis=1) - radius)


def test_a_round_shape_is_round_between_its_vertices() -> None:
    given = ball(0.08)
    assert section_errors(given, 0.08).max() > 2e-3  # cells of 4 cm
    assert section_errors(smooth(given), 0.08).max() < 7e-4
    assert smooth(given).vertices[: len(given.vertices)] == pytest.approx(given.vertices)


def test_edges_stay_sharp_and_faces_flat() -> None:
    """A roof of two faces at right angles, and a mesh without normals."""
    corners = np.array([[-1.0, 0, -1], [0, 0, 0], [0, 1.0, 0], [1.0, 0, -1], [1.0, 1.0, -1]])
    left, right = (np.array([side, 0.0, 1.0]) / np.sqrt(2.0) for side in (-1.0, 1.0))
    faces = np.array([[0, 1, 2], [1, 3, 2], [3, 4, 2]])
    roof = Drawable("mesh", "roof", vertices=corners, triangles=faces,
                    normals=np.array([left, left, right, right, right]))  # fmt: skip
    finer = smooth(roof)
    assert len(finer.triangles) == 16 * 3
    assert finer.vertices[:, 2] == pytest.approx(-np.abs(finer.vertices[:, 0]))
    assert smooth(roof._replace(normals=None)) == roof._replace(normals=None)


def test_what_is_cut_is_filled_unless_its_surface_ends_there() -> None:
    whole, piece = cut(ball(0.3), LEVEL), cut(ball(0.3, reach=0.25), LEVEL)
    assert (len(whole.areas), whole.lines) == (1, [])
    assert piece.areas == []
    assert len(piece.lines) > 0


def pixels_of(scene: Scene, thing: Drawable, places: Any) -> set[tuple[int, ...]]:
    """Colours of the first picture of a film, as seen from above, at places in the view [m]."""
    film = timing.timing([scene], slow=20.0, fps=5.0)
    picture = Frame([replace(scene, obstacles=(thing,))], film, (600, 540))
    image = picture.at(0)
    [_, above] = picture.panels[0]
    box = above.ax.get_window_extent().padded(-4.0)
    x, y = above.ax.transData.transform(places).T
    seen = (box.x0 < x) & (x < box.x1) & (box.y0 < y) & (y < box.y1)
    assert seen.sum() > 100
    pixels = image[(len(image) - 1 - y[seen]).astype(int), x[seen].astype(int)]
    return {tuple(one) for one in pixels.tolist()}


def rgb(code: str) -> tuple[int, ...]:
    return tuple(int(code[k : k + 2], 16) for k in (1, 3, 5))


def test_a_film_shows_the_cut_darker_than_what_is_behind_it(flat: Scene) -> None:
    """Of a ball whose middle is 20 cm above the plane of the view."""
    angles = np.linspace(0.0, np.pi, 720)  # the scale is below
    ring = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    for radius, colour in nonempty([(0.1, SHADES[0]), (0.26, lighter(SHADES[0]))]):
        places = LEVEL(MIDDLE) + radius * ring
        assert pixels_of(flat, ball(0.3, above=0.2), places) == {rgb(colour)}


def test_folds_of_an_outline_are_no_hairs(flat: Scene) -> None:
    """A sheet below the view, with a corner of its triangles that lies beyond the next."""
    side = 11
    x, y = np.meshgrid(np.linspace(-0.25, 0.25, side), np.linspace(-0.25, 0.25, side))
    corners = MIDDLE + np.stack([x.ravel(), y.ravel(), np.full(side * side, -0.1)], axis=1)
    corners[5 * side + 5, 0] += 0.09  # its neighbour is at 0.05
    cells = [
        one
        for k in (side * j + i for j in range(side - 1) for i in range(side - 1))
        for one in ((k, k + 1, k + side), (k + 1, k + side + 1, k + side))
    ]
    sheet = Drawable("mesh", "sheet", vertices=corners, triangles=np.array(cells),
                     normals=np.tile([0.0, 0.0, 1.0], (side * side, 1)))  # fmt: skip
    grid = np.stack(np.meshgrid(np.linspace(-0.2, 0.2, 200), np.linspace(-0.1, 0.1, 100)), axis=-1)
    places = LEVEL(MIDDLE) + grid.reshape(-1, 2)
    assert pixels_of(flat, sheet, places) == {rgb(lighter(SHADES[0]))}
