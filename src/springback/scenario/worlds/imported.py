"""The obstacle of type ``import``: a world of another program, as built-in obstacles."""

from __future__ import annotations

import contextlib
import fnmatch
import functools
import hashlib
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextvars import ContextVar
from pathlib import Path
from typing import Annotated, Any, Literal, NamedTuple, get_args

import numpy as np
from pydantic import Field, TypeAdapter, ValidationError, model_validator

from springback.contact.grids.measured_shapes import MeshBody, OccupancyGrid
from springback.contact.library import SURFACES
from springback.contact.parameters import SurfaceSettings
from springback.contact.shapes import Place
from springback.contact.worlds import BuiltIn, ObstacleSettings
from springback.errors import InputError, excerpt, within
from springback.problems import dotted_path, problem_paths
from springback.quantities import LARGEST, Angle, Factor
from springback.scenario.fields import check_magnitudes
from springback.scenario.worlds.content import WorldContent, WorldRemark
from springback.scenario.worlds.files import world_content
from springback.scenario.worlds.paths import file_bytes
from springback.settings import Name, Settings, problem

#: Types of built-in obstacles.
KINDS = tuple(get_args(kind.model_fields["type"].annotation)[0] for kind in get_args(BuiltIn))
#: Keys of tables that are points, and those that are directions.
POINTS, DIRECTIONS = ("position", "start", "end"), ("normal", "axis")
#: Types whose form is in a file of its own.
FORMS = ("mesh", "heightmap", "occupancy")
#: Names that a message lists at most (chosen).
MOST_NAMED = 3
#: Imports that are remembered (chosen: a campaign mostly flies the same again).
LATEST = 16

_OBSTACLE: TypeAdapter[BuiltIn] = TypeAdapter(ObstacleSettings)

#: True while worlds are only listed.
_LISTED: ContextVar[bool] = ContextVar("listed", default=False)


@contextlib.contextmanager
def listing_only() -> Iterator[None]:
    """Context in which worlds are read to be listed: no distance grid is computed."""
    token = _LISTED.set(True)
    try:
        yield
    finally:
        _LISTED.reset(token)


class PlainMesh(MeshBody):
    """A mesh that is only listed: its triangles are checked, its grid is not computed."""

    def check_form(self) -> None:
        """Reject triangles that bound no body."""
        self.triangles()


class PlainOccupancy(OccupancyGrid):
    """An occupancy grid that is only listed: its cells are read, distances are not computed."""

    def check_form(self) -> None:
        """Reject cells that cannot be read."""
        self.cells()


_LISTED_KINDS: dict[str, type[MeshBody | OccupancyGrid]] = {
    "mesh": PlainMesh,
    "occupancy": PlainOccupancy,
}


def _made(table: dict[str, Any], listed: bool) -> BuiltIn:
    """A built-in obstacle of a raw one; ``listed`` says that it is to be listed alone."""
    kind = _LISTED_KINDS.get(table["type"]) if listed else None
    return _OBSTACLE.validate_python(table) if kind is None else kind.model_validate(table)


class ImportedElement(Settings):
    """An element of a file, in the frame of the file."""

    name: str
    """Name in the file, after the names of whatever contains it."""
    obstacle: dict[str, Any]
    """A built-in obstacle without its surface, in SI."""
    friction: Factor | None = None
    """Coefficient of friction in the file."""

    @model_validator(mode="after")
    def _can_be_placed(self) -> ImportedElement:
        table = self.obstacle
        if table.get("type") not in KINDS:
            raise problem(f"must be {', '.join(KINDS)}", "obstacle.type")
        if "motion" in table:
            raise problem("cannot be given: elements are at rest", "obstacle.motion")
        for key in {*POINTS, *DIRECTIONS} & table.keys():
            value = table[key]
            if not isinstance(value, list | tuple) or len(value) != 3 or not _numbers(value):
                raise problem("must be three plain numbers", f"obstacle.{key}")
        for key in {"yaw", "height"} & table.keys():
            if table[key] is not None and not _numbers([table[key]]):
                raise problem("must be a plain number", f"obstacle.{key}")
        return self


def _numbers(values: Sequence[Any]) -> bool:
    """True for finite numbers."""
    return all(type(x) in (int, float) and abs(x) <= LARGEST for x in values)


class NamedObstacle(NamedTuple):
    """A built-in obstacle with the name of the element that it was made of."""

    name: str
    obstacle: BuiltIn


class Imported(Settings):
    """A world of another program: SDF (Gazebo), MJCF, URDF, RotorPy, OctoMap, a mesh or a grid."""

    type: Literal["import"]
    name: Name = ""
    """Name for messages and drawings, put before the names of its elements."""
    file: str
    """Path of the world, relative to the scenario; its suffix tells the format.  A mesh is read as
    it is, z-up and in metres: one to be scaled or turned is an obstacle of type ``mesh``, which has
    ``scale``, ``roll`` and ``pitch``."""
    search: tuple[str, ...] = ()
    """Further folders to search for what it includes (``model://``, ``package://``, meshes)."""
    surface: SurfaceSettings
    """Surface of all elements but those named in ``surfaces``."""
    surfaces: dict[str, SurfaceSettings] = Field(default_factory=dict)
    """Surfaces by pattern of name, such as ``"shelf*"``; the first that matches counts."""
    friction: Literal["file", "surface"] = "file"
    """`file`: coefficients of friction in the file replace that of ``surface``."""
    position: Place = (0.0, 0.0, 0.0)
    """Position of the origin of the file."""
    yaw: Angle = 0.0
    """Yaw of the x axis of the file."""
    bounds: bool = False
    """True if the bounds of a world of RotorPy are walls."""
    missing: Literal["warn", "refuse"] = "warn"
    """What happens if the file has something that cannot be represented."""
    elements: tuple[ImportedElement, ...] = ()
    """Content of the file; if this is given, the file is not read again."""
    unrepresented: tuple[str, ...] = ()
    """What else the file has, each as ``name: reason``."""
    remarks: tuple[str, ...] = ()
    """What is represented differently from how the file has it, likewise."""
    ignored: tuple[str, ...] = ()
    """What nothing can hit, by kind: pictures, lights, plugins."""
    content: Annotated[str, Field(pattern=r"^(|[0-9a-f]{64})$")] = ""
    """SHA-256 of the file, which is refused if its content is different."""

    @model_validator(mode="before")
    @classmethod
    def _is_neither_scaled_nor_tilted(cls, given: Any) -> Any:
        for key in ("scale", "roll", "pitch"):
            if isinstance(given, Mapping) and key in given:
                raise problem(
                    "is no key of an import: an obstacle of type mesh has it, and the elements of "
                    "a world have the scale and the pose of their file",
                    key,
                )
        return given

    @model_validator(mode="after")
    def _representable(self) -> Imported:
        if self.missing == "refuse" and self.unrepresented:
            what = "; ".join(self.unrepresented[:MOST_NAMED])
            count = len(self.unrepresented)
            more = f"; and {count - MOST_NAMED} more" if count > MOST_NAMED else ""
            raise problem(
                f"has {_elements(count)} that cannot be represented: {what}{more}", "file"
            )
        for pattern in self.surfaces:
            if self.elements and not any(_fits(one.name, pattern) for one in self.elements):
                names = ", ".join(one.name for one in self.elements[:MOST_NAMED])
                raise problem(
                    f"fits the name of no element of {Path(self.file).name}; there are {names}"
                    f"{', ...' if len(self.elements) > MOST_NAMED else ''}",
                    f"surfaces.{excerpt(pattern)}",
                )
        _parts_of(self)  # its problems are those of this table
        return self

    def __hash__(self) -> int:
        """By what mostly tells two of them apart."""
        return hash((self.file, len(self.elements), self.surface, self.position, self.yaw))

    @property
    def parts(self) -> tuple[NamedObstacle, ...]:
        """Its elements as built-in obstacles, placed and with their surfaces."""
        return _parts_of(self)

    def surface_of(self, element: ImportedElement) -> SurfaceSettings:
        """Surface of an element: by its name, else with the file's friction."""
        for pattern, surface in self.surfaces.items():
            if _fits(element.name, pattern):
                return surface
        if element.friction is None or self.friction == "surface":
            return self.surface
        return _with_friction(self.surface, element.friction)


@functools.lru_cache(maxsize=1024)
def _with_friction(surface: SurfaceSettings, friction: float) -> SurfaceSettings:
    return surface.with_checked(friction=friction)


def _parts_of(imported: Imported) -> tuple[NamedObstacle, ...]:
    """Parts; an element that is no valid obstacle is a problem that names it."""
    return _made_parts(imported, _LISTED.get())


@functools.lru_cache(maxsize=LATEST)
def _made_parts(imported: Imported, listed: bool) -> tuple[NamedObstacle, ...]:
    found: list[NamedObstacle] = []
    for one in imported.elements:
        table = placed_table(one.obstacle, imported.position, imported.yaw)
        try:
            obstacle = _made({**table, "surface": imported.surface_of(one)}, listed)
        except ValidationError as error:
            path, what = problem_paths(error)[0]
            keys = dotted_path(tuple(key for key in path if key != table["type"]))
            raise problem(f"{one.name}: {keys}: {what}", "file") from None
        found.append(NamedObstacle(one.name, obstacle))
    return tuple(found)


def check_imported(obstacles: Iterable[Any]) -> None:
    """Reject elements of imported worlds with absurdly large numbers; see `check_magnitudes`."""
    for k, entry in enumerate(obstacles):
        for j, part in enumerate(entry.parts if isinstance(entry, Imported) else ()):
            check_magnitudes(part.obstacle, ("world", "obstacles", k, "elements", j))


def _elements(count: int) -> str:
    return "1 element" if count == 1 else f"{count} elements"


def _fits(name: str, pattern: str) -> bool:
    """True if a pattern fits a name, or that of something it is in."""
    parts = name.split("/")
    return any(fnmatch.fnmatchcase("/".join(parts[:k]), pattern) for k in range(1, len(parts) + 1))


def placed_table(table: dict[str, Any], position: Sequence[float], yaw: float) -> dict[str, Any]:
    """A raw obstacle in the world.

    Args:
        table: In the frame of the file.
        position: Of the file's origin [m].
        yaw: Of the file's x axis [rad].
    """
    if not any(position) and not yaw:
        return table
    s, c = math.sin(yaw), math.cos(yaw)
    turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    found = dict(table)
    for key in POINTS:
        if key in table:
            found[key] = (turn @ np.array(table[key]) + np.array(position)).tolist()
    for key in DIRECTIONS:
        if key in table:
            found[key] = (turn @ np.array(table[key])).tolist()
    if table["type"] == "ground":
        found["height"] = table.get("height", 0.0) + position[2]
    elif yaw and table["type"] in TURNED:
        found["yaw"] = math.remainder(table.get("yaw", 0.0) + yaw, math.tau)
    return found


#: Types with a yaw of their own.
TURNED = tuple(
    kind
    for kind, settings in zip(KINDS, get_args(BuiltIn), strict=True)
    if "yaw" in settings.model_fields
)


def single_obstacles(obstacles: Iterable[Any]) -> tuple[Any, ...]:
    """Obstacles of a scenario, the elements of imported worlds one by one in their place."""
    found: list[Any] = []
    for one in obstacles:
        found += [part.obstacle for part in one.parts] if isinstance(one, Imported) else [one]
    return tuple(found)


def named_obstacles(obstacles: Sequence[Any]) -> Iterator[tuple[str, Any]]:
    """Obstacles as of `single_obstacles`, each with its name in a sentence."""
    for k, entry in enumerate(obstacles):
        if isinstance(entry, Imported):
            for part in entry.parts:
                yield (
                    f"{part_words(k, entry, part)}, {with_article(part.obstacle.type)}",
                    part.obstacle,
                )
        else:
            yield obstacle_words(k, entry), entry


#: What an obstacle of that type is called without a name.
GROUND = "the ground"


def with_article(word: str) -> str:
    """A type of obstacles in a sentence."""
    article = "an" if word[0].lower() in "aeiou" and word != "union" else "a"
    return GROUND if word == "ground" else f"{article} {word}"


def obstacle_words(number: int, entry: Any) -> str:
    """An obstacle in a sentence: its place in the scenario, and its name or its type.

    Args:
        number: Its index in the scenario.
        entry: Its settings.
    """
    return f"world.obstacles[{number}], {entry.name or with_article(entry.type)}"


def part_words(number: int, entry: Imported, part: NamedObstacle) -> str:
    """An element of an imported world in a sentence; arguments as for `obstacle_words`."""
    return f"world.obstacles[{number}], {entry.name}{'/' if entry.name else ''}{part.name}"


#: Tables of contents, by identity and whether they were only listed.
_TABLES: list[tuple[WorldContent, bool, dict[str, Any]]] = []


def content_table(content: WorldContent) -> dict[str, Any]:
    """Content of a file as keys of `Imported`: the same objects for the same content.

    Raises:
        InputError: If the file is itself a mesh or an occupancy grid that cannot be one.
    """
    listed = _LISTED.get()
    for known, of_list, table in _TABLES:
        if known is content and of_list == listed:
            return table
    elements, missing = list[ImportedElement](), list(content.missing)
    for one in content.elements:
        table, why = _with_form(one.table)
        file = str(content.files[0])
        if why and one.table["file"] == file:
            raise InputError(why if file in why else f"{file}: {why}", path=("file",))
        if why:
            missing.append(WorldRemark(one.name, why))
            continue
        elements.append(
            ImportedElement.model_construct(name=one.name, obstacle=table, friction=one.friction)
        )
    found: dict[str, Any] = {
        "elements": tuple(elements),
        "unrepresented": tuple(f"{one.name}: {one.reason}" for one in missing),
        "remarks": tuple(f"{one.name}: {one.reason}" for one in content.remarks),
        "ignored": tuple(f"{count} {kind}" for kind, count in content.ignored if count),
    }
    _TABLES.append((content, listed, found))
    del _TABLES[:-LATEST]
    return found


def _with_form(table: dict[str, Any]) -> tuple[dict[str, Any], str]:
    """A raw obstacle with the digest of the file of its form, and why it cannot be, if so."""
    if table["type"] not in FORMS:
        return table, ""
    try:
        made = _made({**table, "surface": SURFACES["wall"]}, _LISTED.get())
    except ValidationError as error:
        return table, problem_paths(error)[0][1]
    except InputError as error:  # of a package that is not installed
        return table, error.problems[0]
    return {**table, "content": getattr(made, "content", "")}, ""


def read_import(given: dict[str, Any]) -> dict[str, Any]:
    """A raw table of type ``import`` with the content of its file.

    Args:
        given: The table; with ``elements`` it is returned as it is.

    Raises:
        InputError: If the file cannot be read or is wrong.
    """
    content = None if "elements" in given else _content_of(given)
    return given if content is None else {**given, **content_table(content)}


def world_files(given: Mapping[str, Any]) -> tuple[Path, ...]:
    """Files that the imported worlds of a raw scenario are read from.

    Raises:
        InputError: If one cannot be read or is wrong.
    """
    world = given.get("world")
    entries = world.get("obstacles", ()) if isinstance(world, Mapping) else ()
    tables = [one for one in entries if isinstance(one, Mapping) and one.get("type") == "import"]
    contents = [_content_of(one) for one in tables if "elements" not in one]
    return tuple(path for content in contents if content for path in content.files)


def _content_of(given: Mapping[str, Any]) -> WorldContent | None:
    """Content of the file of a raw table; None if what is wrong is said when it is validated."""
    file, search = given.get("file"), given.get("search", ())
    is_readable = isinstance(file, str) and isinstance(search, list | tuple)
    if not is_readable or not all(isinstance(word, str) for word in search):
        return None
    if not file:
        raise InputError("must be the path of a file", path=("file",))
    folders = [Path(word) for word in search]
    with within("file"):
        found = world_content(Path(file), folders, KINDS, bounds=given.get("bounds") is True)
        noted = given.get("content")
        if noted and hashlib.sha256(file_bytes(Path(file))).hexdigest() != noted:
            raise InputError(f"{file}: was changed: it has another content than {noted[:12]}…")
    return found
