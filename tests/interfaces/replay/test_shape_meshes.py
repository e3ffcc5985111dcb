"""Meshes of built-in shapes are those shapes: on the surface, closed, outward, of their volume."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from builders.shapes import SHAPES
from springback.contact.forest import Forest
from springback.contact.library import WALL
from springback.contact.openings import Doorway, Window
from springback.contact.scene.solids import solid_face
from springback.contact.shapes import (
    Ball,
    Box,
    Capsule,
    Hoop,
    Pole,
    ShapeSettings,
    Stairs,
    solids_of,
)
from springback.interfaces.replay.shape_meshes import EndSpan, ShapeMesh, mesh_of, trunks
from springback.kernels.routines import NumberTable
from springback.kernels.vectors import Vec

SPAN = EndSpan(-0.7, 0.4)
S: dict[str, Any] = {"surface": WALL}
SHARP = {
    f"sharp {name}": shape.model_copy(update={"edge_radius": 0.0})
    for name, shape in SHAPES.items()
    if "edge_radius" in type(shape).model_fields
}
THICK = {
    "half a box of edge": Box(type="box", position=(0, 0, 0), size=(0.2, 0.3, 0.4), edge_radius=0.1, **S),
    "thick stairs": Stairs(type="stairs", position=(0, 0, 0), steps=4, rise=0.2, tread=0.3,
                           edge_radius=0.05, **S),
    "high window": Window(type="window", position=(0, 0, 0), size=(2.0, 1.5), opening=(0.2, 0.1),
                          opening_height=0.6, **S),
    "narrow frame": Window(type="window", position=(0, 0, 0), size=(1.0, 1.0), edge_radius=0.0,
                           opening=(0.98, 0.5), opening_height=0.2, **S),
    "wide round": Window(type="window", position=(0, 0, 0), size=(3.0, 1.0), opening_radius=0.49,
                         edge_radius=0.004, **S),
}  # fmt: skip
ALL = {k: v for k, v in {**SHAPES, **SHARP, **THICK}.items() if k != "slope"}


def distances(shape: ShapeSettings, points: np.ndarray) -> np.ndarray:
    """Signed distance of points from the surface, by the kernel in plain Python."""
    tables = [NumberTable(np.array(solid.row())) for solid in solids_of(shape, 0, 0)]
    return np.array(
        [min(solid_face(t, 0, Vec(*p)).gap for t in tables) for p in points.tolist()]
    )  # fmt: skip


def volume(mesh: ShapeMesh) -> float:
    a, b, c = (mesh.vertices[mesh.triangles[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6.0)


def is_closed(mesh: ShapeMesh) -> bool:
    """Each edge is there once in either direction."""
    ways = np.concatenate([mesh.triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    assert len(np.unique(ways, axis=0)) == len(ways)
    return bool(np.array_equal(np.unique(ways, axis=0), np.unique(ways[:, ::-1], axis=0)))


@pytest.mark.parametrize("name", ALL)
def test_vertices_are_on_the_surface_and_faces_look_outwards(name: str) -> None:
    """Within 2 mm; a little before each face is nothing, a little behind it the body."""
    mesh = mesh_of(ALL[name], SPAN)
    assert np.abs(distances(ALL[name], mesh.vertices)).max() < 2e-3
    assert is_closed(mesh)
    assert volume(mesh) > 0.0
    assert np.unique(mesh.triangles).tolist() == list(range(len(mesh.vertices)))
    a, b, c = (mesh.vertices[mesh.triangles[:, k]] for k in range(3))
    out = np.cross(b - a, c - a)
    size = np.linalg.norm(out, axis=1)
    large = size > 1e-6  # of slivers at rounded edges the middle is too near another face
    middle, step = (a + b + c) / 3.0, 4e-3 * out / size[:, None]
    before, behind = (distances(ALL[name], middle + k * step)[large] for k in (1.0, -1.0))
    cut_off = np.zeros(large.sum(), dtype=bool)
    if "endless" in name:
        axis = ALL[name].bodies()[0].axes[2]
        cut_off = (np.abs(out @ axis) > 0.99 * size)[large]
    assert (before > behind)[~cut_off].all()
    assert (~cut_off).sum() > 8


@pytest.mark.parametrize("name", ALL)
def test_faces_follow_the_surface_between_vertices(name: str) -> None:
    """The middle of each triangle is within 2 mm of the surface: no face spans an opening."""
    mesh = mesh_of(ALL[name], SPAN)
    middle = mesh.vertices[mesh.triangles].mean(axis=1)
    if "endless" in name:  # its ends are cuts
        [body] = ALL[name].bodies()
        along = (middle - body.centre) @ body.axes[2]
        middle = middle[(along > SPAN.low + 1e-6) & (along < SPAN.high - 1e-6)]
    assert np.abs(distances(ALL[name], middle)).max() < 2e-3


EXACT: dict[str, tuple[ShapeSettings, float]] = {
    "box": (Box(type="box", position=(1, 2, 3), size=(0.4, 0.3, 0.2), yaw=0.3, edge_radius=0.0, **S), 0.024),
    "pole": (Pole(type="pole", position=(1, 0, 0), radius=0.2, height=1.5, axis=(1, 2, 0), **S),
             math.pi * 0.04 * 1.5),
    "sphere": (Ball(type="sphere", position=(0, 1, 0), radius=0.5, **S), 4 / 3 * math.pi * 0.125),
    "capsule": (Capsule(type="capsule", start=(0, 1, 0), end=(0.3, 1.4, 0.0), radius=0.2, **S),
                math.pi * 0.04 * 0.5 + 4 / 3 * math.pi * 0.008),
    "hoop": (Hoop(type="hoop", position=(0, 1, 0), radius=0.8, tube_radius=0.1, **S),
             2 * math.pi**2 * 0.8 * 0.01),
    "window": (Window(type="window", position=(0, 1, 0), size=(2.0, 1.5), opening=(0.7, 0.4), thickness=0.2,
                      opening_height=0.3, pitch=0.2, **S), 0.2 * (3.0 - 0.28)),
    "round window": (Window(type="window", position=(0, 1, 0), size=(2.0, 1.5), opening_radius=0.6,
                            thickness=0.2, **S), 0.2 * (3.0 - math.pi * 0.36)),
    "doorway": (Doorway(type="doorway", position=(0, 1, 0), size=(3.0, 2.5), thickness=0.15, **S),
                0.15 * (7.5 - 0.9 * 2.0)),
    "stairs": (Stairs(type="stairs", position=(0, 1, 0), steps=3, rise=0.2, tread=0.3, width=0.8, **S),
               0.8 * 0.2 * 0.3 * 6),
}  # fmt: skip


@pytest.mark.parametrize("name", EXACT)
def test_volumes_are_those_of_the_formulas(name: str) -> None:
    """Within 1.5 %, what chords and the rounding of 1 mm take away."""
    shape, wanted = EXACT[name]
    assert volume(mesh_of(shape)) == pytest.approx(wanted, rel=0.015)


def test_trunks_as_one_mesh_are_the_trunks() -> None:
    """Each vertex is on the bark of the nearest trunk, and each trunk has its share."""
    forest = Forest(
        type="forest", density=0.2, size=(10, 10), radius_spread=0.5, position=(1, 2, 3), **S
    )
    bodies = forest.bodies()
    mesh = trunks(bodies, EndSpan(-0.5, 1.5), 12)
    assert is_closed(mesh)
    assert np.abs(distances(forest, mesh.vertices)).max() < 1e-9
    assert mesh.vertices[:, 2].min() == 2.5
    assert mesh.vertices[:, 2].max() == 4.5
    area = sum(body.sizes[1] ** 2 for body in bodies) * 6.0 * math.sin(math.tau / 12)
    assert volume(mesh) == pytest.approx(2.0 * area, rel=1e-9)
