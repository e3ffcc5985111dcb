"""Obstacles of a form that a file holds: height maps, meshes and occupancy grids; user input."""

from __future__ import annotations

import json
from abc import abstractmethod
from functools import lru_cache
from typing import Annotated, Any, Literal, NamedTuple

import numpy as np
from pydantic import Field, model_validator

from springback.contact.grids.closed_meshes import closed_mesh
from springback.contact.grids.data_files import checked_content, file_bytes
from springback.contact.grids.distance_grids import (
    DistanceGrid,
    fitting_cell,
    grid_of_cells,
    grid_of_mesh,
)
from springback.contact.grids.height_maps import HeightForm, height_form, read_heights
from springback.contact.grids.mesh_files import Triangles, triangles_of
from springback.contact.grids.occupancy import Cells, read_cells
from springback.contact.grids.stored_forms import stored_grid
from springback.contact.scene.solids import GRID, HEIGHTS
from springback.contact.shapes import AttitudeShape, Place, SolidShape, Widths
from springback.kernels.routines import NumberTable
from springback.quantities import Length, Pair, Unit
from springback.settings import problem

#: Forms that are remembered (chosen: a large one has 128 MB).
LATEST = 8
#: Suffixes of files that hold a form, besides those of meshes.
FORM_FILES = (".npy", ".npz", ".png")

Heights = Annotated[Pair, Unit("m")]


class FormShape(AttitudeShape):
    """A shape whose form is in a file; it is known by the file's content."""

    type: str
    file: Annotated[str, Field(min_length=1, max_length=4096)]
    """Path of the file, relative to the scenario's file."""
    content: Annotated[str, Field(pattern=r"^(|[0-9a-f]{64})$")] = ""
    """SHA-256 of the file.  One with other content is refused; none: the file's own is recorded."""
    position: Place

    @model_validator(mode="after")
    def _is_read(self) -> FormShape:
        """Note the content, and reject a form that cannot be."""
        self.__dict__["content"] = checked_content(self.file, self.content)
        self.check_form()
        return self

    def check_form(self) -> None:
        """Reject a form that cannot be."""
        self.bodies()


class HeightMap(FormShape):
    """Ground with a height at each point of a regular grid, and a smooth spline between them."""

    type: Literal["heightmap"]
    position: Place
    """Middle of its rectangle, at height zero."""
    size: Widths | None = None
    """Full lengths along its own x and y, from the first to the last point ..."""
    spacing: Length | None = None
    """... or the distance between two points."""
    range: Heights | None = None
    """Heights of black and white in an image; ``.npy`` holds metres."""
    depth: Length = 0.5
    """Depth from its lowest point to the level bottom of the body."""

    def check_form(self) -> None:
        """Reject a form that cannot be."""
        if (self.size is None) == (self.spacing is None):
            both = "" if self.size is None else ", not both"
            raise problem(f"needs either size or spacing{both}")
        self.bodies()

    def form(self) -> HeightForm:
        """Its numbers."""
        return _height_form(
            self.file, self.content, self.range, self.size, self.spacing, self.depth
        )

    def bodies(self) -> list[SolidShape]:
        """Its solids."""
        form, axes = self.form(), self.axes()
        centre = np.array(self.position) + form.middle * axes[2]
        sizes = (*form.half, form.table, form.share, form.reach)
        return [SolidShape(HEIGHTS, centre, axes, sizes, 0.0)]


class GridForm(NamedTuple):
    """Numbers of a distance grid."""

    centre: Any  # of its box [m], shape (3,)
    half: tuple[float, float, float]  # half lengths of the box [m]
    table: NumberTable
    cell: float  # [m]
    nodes: int
    error: float  # root of the mean square at the surface; NaN if unknown [m]
    largest: float  # the same, largest [m]
    deepest: float  # distance of its innermost node from the surface [m]
    thinnest: float  # thickness of its thinnest parts; NaN if unknown [m]
    holds_to: float  # depth of contacts to which forces on them hold [m]


def _grid_form(grid: DistanceGrid) -> GridForm:
    x, y, z = grid.half.tolist()
    rms, largest = grid.error.tolist()
    nodes, deepest = grid.values.size, -float(grid.values.min())
    return GridForm(
        grid.centre, (x, y, z), grid.table(), grid.cell, nodes, rms, largest, deepest,
        grid.thinnest, grid.holds_to,
    )  # fmt: skip


class GridShape(FormShape):
    """A shape of which a grid holds the distance."""

    @abstractmethod
    def form(self) -> GridForm:
        """Its numbers."""

    def middle_depth(self) -> float:
        """Depth to which forces on its thinnest parts hold [m]."""
        return self.form().holds_to

    def bodies(self) -> list[SolidShape]:
        """Its solids."""
        form, axes = self.form(), self.axes()
        centre = np.array(self.position) + form.centre @ axes
        return [SolidShape(GRID, centre, axes, (*form.half, form.table), 0.0)]


class MeshBody(GridShape):
    """A body bounded by the triangles of a closed mesh; its distance is read from a grid."""

    type: Literal["mesh"]
    position: Place = (0.0, 0.0, 0.0)
    """Position of the mesh's own origin."""
    scale: Annotated[float, Unit("", above=0.0)] = 1.0
    """Metres in one unit of the file: 0.001 for millimetres."""
    cell: Length | None = None
    """Length of the grid's cells; by default such that the grid has some 400 000 nodes, or
    up to 3 million if parts are thin."""

    def form(self) -> GridForm:
        """Its numbers."""
        return _mesh_form(self.file, self.content, self.scale, self.cell)

    def triangles(self) -> Triangles:
        """Its surface, in its own axes [m]."""
        return _triangles(self.file, self.content, self.scale)

    def extent(self) -> tuple[float, float, float]:
        """Its lengths along its own axes [m]."""
        x, y, z = np.ptp(self.triangles().vertices, axis=0).tolist()
        return x, y, z


class OccupancyGrid(GridShape):
    """Cells that are occupied or free, as in a map; its distance is that from the occupied ones."""

    type: Literal["occupancy"]
    position: Place = (0.0, 0.0, 0.0)
    """Position of the grid's own origin: lower corner of its first cell, or as in the file."""
    cell: Length | None = None
    """Length of a cell; ``.npz`` files may hold it."""
    threshold: Annotated[float, Unit("", least=0.0, most=1.0)] = 0.5
    """A cell is occupied if its probability is at least this."""
    unknown: Literal["free", "occupied"] = "free"
    """State of cells whose probability is not a number, or negative."""

    def form(self) -> GridForm:
        """Its numbers."""
        return _grid_form_of_cells(
            self.file, self.content, self.cell, self.threshold, self.unknown == "occupied"
        )

    def cells(self) -> Cells:
        """Its cells."""
        return _cells(
            self.file, self.content, self.cell, self.threshold, self.unknown == "occupied"
        )


@lru_cache(maxsize=LATEST)
def _height_form(
    file: str,
    content: str,
    heights: tuple[float, float] | None,
    size: tuple[float, float] | None,
    spacing: float | None,
    depth: float,
) -> HeightForm:
    found = read_heights(file, file_bytes(file, content), heights)
    nodes = np.array(found.shape) - 1
    apart = np.array(size) / nodes if size is not None else np.full(2, spacing)
    return height_form(found, apart, depth)


@lru_cache(maxsize=LATEST)
def _triangles(file: str, content: str, scale: float) -> Triangles:
    found = closed_mesh(file, triangles_of(file, file_bytes(file, content)))
    return Triangles(found.vertices * scale, found.faces)


@lru_cache(maxsize=LATEST)
def _mesh_form(file: str, content: str, scale: float, cell: float | None) -> GridForm:
    def make() -> DistanceGrid:
        mesh = _triangles(file, content, scale)
        return grid_of_mesh(mesh, fitting_cell(mesh) if cell is None else cell)

    key = json.dumps(["mesh", content, scale, cell])
    return _grid_form(stored_grid(key, make))


@lru_cache(maxsize=LATEST)
def _cells(file: str, content: str, cell: float | None, threshold: float, unknown: bool) -> Cells:
    return read_cells(file, file_bytes(file, content), cell, threshold, unknown)


@lru_cache(maxsize=LATEST)
def _grid_form_of_cells(
    file: str, content: str, cell: float | None, threshold: float, unknown: bool
) -> GridForm:
    def make() -> DistanceGrid:
        found = _cells(file, content, cell, threshold, unknown)
        return grid_of_cells(found.occupied, found.cell, found.low)

    key = json.dumps(["occupancy", content, cell, threshold, unknown])
    return _grid_form(stored_grid(key, make))
