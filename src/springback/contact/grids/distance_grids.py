"""Grids of signed distances: made once for a mesh or an occupancy grid, and kept on disk."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.contact.grids.closed_meshes import inside
from springback.contact.grids.mesh_distance import SurfacePoints
from springback.contact.grids.mesh_files import Triangles
from springback.contact.grids.thickness import thinnest_part
from springback.contact.grids.union_surfaces import union_surface
from springback.contact.scene.grid_face import COEFFICIENTS
from springback.kernels.routines import NumberTable
from springback.random_streams import Purpose, stream
from springback.settings import problem

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Most nodes of a grid: 8 B each, so 128 MB (chosen).
MOST_NODES = 16_000_000
#: Nodes of the grid of a mesh unless the length of its cells is given: so many, or up to the second
#: number for so many cells across the thinnest part (chosen: it takes seconds; forces on it are
#: right to 2 % up to 0.6 of the depth of its middle).
NODES, NODES_IF_THIN, ACROSS = 400_000, 3_000_000, 8.0
#: Cells around the body (chosen: the spline's coefficients then do not feel the border).
ROOM = 4
#: Nodes by which values are continued: the coefficients then do not feel their end (chosen).
BEYOND = 12
#: Fewest cells across the thinnest part for a smooth spline; with fewer, as in walls of one cell of
#: a map, it would leave too little of the part (chosen: of a board four cells thick forces are 27 %
#: too low with it, up to 25 % too high without).
FEWEST_ACROSS = 4.5
#: Cells before the middle of a mesh's part in which forces are wrong (chosen: peaks that end there
#: are 1 to 2 % too low on a smooth spline; with fewer than three cells across none can be trusted:
#: on edges of boards of 1.4 to 2.5 cells peaks are 10 % too high to 37 % too low).
ROUNDED = 1.5
#: Points of the surface at which the error of a grid is measured (chosen).
PROBES = 2000


class DistanceGrid(NamedTuple):
    """Signed distances at the nodes of a grid, as they are kept."""

    low: Array  # the first node [m], shape (3,)
    cell: float  # [m]
    values: Array  # [m], shape (nodes along x, y, z)
    error: Array  # near the surface: root of the mean square, and largest of some points [m]
    thinnest: float  # thickness of the thinnest parts; NaN if unknown [m]

    @property
    def half(self) -> Array:
        """Half lengths of the box of its nodes [m]."""
        return np.asarray(0.5 * self.cell * (np.array(self.values.shape) - 1))

    @property
    def centre(self) -> Array:
        """Centre of that box [m]."""
        return np.asarray(self.low + self.half)

    @property
    def is_smooth(self) -> bool:
        """True if its parts are thick enough for a spline that does not ripple."""
        return self.thinnest >= FEWEST_ACROSS * self.cell

    def coefficients(self) -> Array:
        """Coefficients of its spline."""
        return smooth_coefficients(self.values) if self.is_smooth else coefficients(self.values)

    @property
    def holds_to(self) -> float:
        """Depth of contacts to which forces on its thinnest parts hold [m]; 0 if to none."""
        if not math.isfinite(self.thinnest):
            return -float(self.values.min())
        return max(0.0, 0.5 * self.thinnest - ROUNDED * self.cell)

    def table(self) -> NumberTable:
        """Its numbers for `springback.contact.scene.grid_face`."""
        head = np.zeros(COEFFICIENTS)
        head[:3], head[3], head[4] = self.values.shape, self.cell, 1.0 / self.cell
        return NumberTable(np.concatenate([head, self.coefficients().ravel()]))


def smooth_coefficients(values: Array) -> Array:
    """Coefficients of a cubic B-spline along values at nodes: the values, and one on each side.

    The spline is a mean of the values around, and its slope one of theirs: beneath edges it does
    not ripple, as one through the values does, and of a convex body it stays convex, so no part
    meets it at several points within a cell.  Instead it is a little too high: by 0.3 of a cell at
    a right edge, by a third of the square of a cell over the radius at a ball, and by a third of a
    cell in the middle of a plate.  I. J. Schoenberg, "On spline functions", in: Inequalities
    (1967).

    Beyond the nodes the values go on turned about the last one, so that a slope goes on, too.
    """
    return np.pad(values, 1, mode="reflect", reflect_type="odd")


def coefficients(values: Array) -> Array:
    """Coefficients of the cubic B-spline through values at nodes, with one more on each side.

    Beyond the nodes the values go on turned about the last one, so that a slope goes on, too.
    """
    room = [min(BEYOND, n - 1) for n in values.shape]
    wide = np.pad(values, [(k, k) for k in room], mode="reflect", reflect_type="odd")
    found = scipy.ndimage.spline_filter(wide, order=3, output=np.float64, mode="mirror")
    return np.ascontiguousarray(found[tuple(slice(k - 1, 1 - k or None) for k in room)])


def spline_values(spline: Array, places: Any) -> Array:
    """Values of a spline by its `coefficients`; places are counted in nodes from the first."""
    shifted = [np.asarray(one) + 1.0 for one in places]
    return np.asarray(scipy.ndimage.map_coordinates(spline, shifted, order=3, prefilter=False))


def cell_of(mesh: Triangles, nodes: int = NODES) -> float:
    """Length of the cells of which a grid around a mesh has about so many nodes [m]."""
    extent = np.ptp(mesh.vertices, axis=0)
    cell = float((extent.prod() / nodes) ** (1.0 / 3.0))
    for _ in range(20):  # the room around the body counts, too
        cell = float(((extent + 2.0 * ROOM * cell).prod() / nodes) ** (1.0 / 3.0))
    return cell


def fitting_cell(mesh: Triangles) -> float:
    """Length of the cells of a mesh's grid, unless it is given [m]: smaller for thin parts."""
    usual = cell_of(mesh)
    thin = thinnest_part(union_surface(mesh, usual), 0.5 * usual) / ACROSS
    return max(min(usual, thin), cell_of(mesh, NODES_IF_THIN))


def node_counts(extent: Array, cell: float) -> Array:
    """Nodes along x, y and z of the grid around a body, as whole floating-point numbers.

    Args:
        extent: Of the body [m], shape (3,).
        cell: Length of a cell [m].
    """
    return np.asarray(np.ceil(extent / cell) + 1.0 + 2.0 * ROOM)


def least_cell(extent: Array) -> float:
    """Smallest cells of a grid that is not too large, rounded up to three digits [m].

    Args:
        extent: Of the body that it is around [m], shape (3,).
    """
    high = float(np.max(extent))
    low = 1e-9 * high
    for _ in range(60):  # in equal ratios, to rounding
        middle = math.sqrt(low * high)
        fits = node_counts(extent, middle).prod() <= MOST_NODES
        low, high = (low, middle) if fits else (middle, high)
    near = float(f"{high:.3g}")
    return (
        near if near >= high else float(f"{near + 10.0 ** (math.floor(math.log10(high)) - 2):.3g}")
    )


def check_nodes(extent: Array, cell: float, field: str) -> None:
    """Reject a grid that is too large.

    Args:
        extent: Of the body that it is around [m], shape (3,).
        cell: Length of its cells [m].
        field: What sets the number, for the message.
    """
    counts = node_counts(extent, cell)
    nodes = float(counts.prod())
    if nodes > MOST_NODES:
        raise problem(
            f"gives a grid of {' x '.join(f'{n:.8g}' for n in counts)} nodes, "
            f"{8e-6 * nodes:.4g} MB; the most is {8e-6 * MOST_NODES:g} MB: cells of "
            f"{least_cell(extent):.3g} m or more (got {cell:.3g} m)",
            field,
        )


def grid_of_mesh(mesh: Triangles, cell: float) -> DistanceGrid:
    """Grid of a closed mesh: of bodies that overlap, of their union.

    Args:
        mesh: In metres, faces anticlockwise from outside.
        cell: Length of a cell [m].

    Raises:
        The problem, if it has too many nodes.
    """
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    check_nodes(high - low, cell, "cell")
    counts = node_counts(high - low, cell).astype(int)
    first = 0.5 * (low + high) - 0.5 * cell * (counts - 1)
    axes = tuple(first[k] + cell * np.arange(counts[k]) for k in range(3))
    nodes = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
    outer = union_surface(mesh, cell)
    surface = SurfacePoints(outer, cell)
    within = inside(mesh, (axes[0], axes[1], axes[2]))
    # From outside the nearest of all triangles is never one within another body.
    away = SurfacePoints(mesh, cell).grid_distances(nodes, cell)
    if outer is not mesh:
        away[within] = surface.distances(nodes[within], cell)
    values = np.where(within, -away, away)
    grid = DistanceGrid(first, cell, values, np.zeros(2), thinnest_part(outer, 0.5 * cell))
    return grid._replace(error=_error(grid, surface))


def _error(grid: DistanceGrid, surface: SurfacePoints) -> Array:
    """Error at points of the surface: root of the mean square, and largest."""
    random = stream(0, Purpose.POINTS)
    points = surface.tree.data
    chosen = points[random.integers(len(points), size=PROBES)]
    found = spline_values(grid.coefficients(), (chosen - grid.low).T / grid.cell)
    return np.array([math.sqrt(float((found * found).mean())), float(np.abs(found).max())])


def grid_of_cells(occupied: Any, cell: float, low: Array) -> DistanceGrid:
    """Grid of occupied cells: its nodes are their centres.

    The distance is that to the nearest cell of the other kind, as a box.

    Args:
        occupied: True or false, shape (cells along x, y, z).
        cell: Length of a cell [m].
        low: Lower corner of the first cell [m].

    Raises:
        The problem, if it has too many nodes, or no cell is occupied.
    """
    if not occupied.any():
        raise problem("has no occupied cell", "file")
    check_nodes(cell * (np.array(occupied.shape) - 1.0), cell, "file")
    whole = np.pad(occupied, ROOM)
    values = np.where(whole, -_to_cells(whole), _to_cells(~whole)) * cell
    first = np.asarray(low, dtype=np.float64) + cell * (0.5 - ROOM)
    return DistanceGrid(first, cell, values, np.array([math.nan, 0.5 * cell]), math.nan)


def _to_cells(away: Any) -> Array:
    """Distance of the centres of some cells from the nearest of the others, in cells."""
    nearest = scipy.ndimage.distance_transform_edt(
        away, return_distances=False, return_indices=True
    )
    steps = np.abs(nearest - np.indices(away.shape))
    return np.asarray(np.sqrt((np.maximum(steps - 0.5, 0.0) ** 2).sum(axis=0)))
