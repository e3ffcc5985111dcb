"""Fields of settings as their tables declare them: unit, range, default, and where each is.

What campaigns vary, what the lab's page sets and what the documentation lists is read here.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from types import UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic_core import PydanticCustomError

from springback.errors import InputError
from springback.problems import dotted_path, nearest_name
from springback.quantities import PerArm, Quadruple, Triple, Unit, number_in, si_number
from springback.settings import Settings
from springback.vehicle.force_laws import HystereticSettings

Path = tuple[str | int, ...]


@dataclass(frozen=True)
class TableField:
    """A key of a table of settings."""

    key: str
    annotation: Any
    metadata: tuple[Any, ...]
    """Metadata of `typing.Annotated`."""
    default: Any
    required: bool

    @property
    def leaves(self) -> list[tuple[Any, tuple[Any, ...]]]:
        """Possible types of a value, each with its metadata of `typing.Annotated`."""
        return list(_leaves(self.annotation, self.metadata))

    @property
    def entries(self) -> list[tuple[Any, tuple[Any, ...]]]:
        """`leaves`, for a list those of its entries."""
        return list(_leaves(self.annotation, self.metadata, lists=True))

    @property
    def unit(self) -> Unit | None:
        """Unit and range of its number or numbers; None for anything else."""
        notes = (note for _, metadata in self.entries for note in metadata)
        return next((note for note in notes if isinstance(note, Unit)), None)

    @property
    def shape(self) -> Any:
        """Type of its numbers: float, `Triple`, `Quadruple` or `PerArm`."""
        types = {leaf for leaf, _ in self.entries}
        vectors = [kind for kind in (Triple, Quadruple) if kind in types]
        return vectors[0] if vectors else float if types <= {float, type(None)} else PerArm

    @property
    def words(self) -> tuple[str, ...]:
        """Allowed words; empty if it is not a choice."""
        choices = (get_args(leaf) for leaf, _ in self.leaves if get_origin(leaf) is Literal)
        return tuple(word for words in choices for word in words if isinstance(word, str))

    @property
    def tables(self) -> list[type[Settings]]:
        """Tables that it holds, at any depth of lists."""
        found = [*_settings_in(self.annotation)]
        return found + [table for note in self.metadata for table in _settings_in(note)]

    @property
    def table(self) -> type[Settings] | None:
        """The first table that it may be."""
        types = (leaf for leaf, _ in self.leaves if isinstance(leaf, type))
        return next((leaf for leaf in types if issubclass(leaf, Settings)), None)


@functools.cache
def fields_of(table: type[Settings]) -> dict[str, TableField]:
    """The fields of a table by the name of their attribute, in their order."""
    return {
        name: TableField(
            info.alias or name,
            info.annotation,
            tuple(info.metadata),
            None if info.is_required() else info.get_default(call_default_factory=True),
            info.is_required(),
        )
        for name, info in table.model_fields.items()
    }


def _leaves(
    annotation: Any, notes: tuple[Any, ...] = (), lists: bool = False
) -> Iterator[tuple[Any, tuple[Any, ...]]]:
    args = get_args(annotation)
    if get_origin(annotation) is Annotated:
        yield from _leaves(args[0], (*notes, *args[1:]), lists)
    elif get_origin(annotation) in (Union, UnionType):
        for branch in args:
            yield from _leaves(branch, notes, lists)
    elif lists and not notes and args[1:] == (...,):
        yield from _leaves(args[0], notes, lists)
    else:
        yield annotation, notes


def _settings_in(annotation: Any) -> Iterator[type[Settings]]:
    if isinstance(annotation, type) and issubclass(annotation, Settings):
        yield annotation
    for part in get_args(annotation):
        yield from _settings_in(part)


# -- numbers of a scenario ------------------------------------------------------------------------


@dataclass(frozen=True)
class Parameter:
    """A number of a scenario."""

    name: str
    path: Path
    unit: str
    """SI; empty for plain numbers."""
    whole: bool = False
    """True if it must be an integer."""
    others: tuple[float, ...] = ()
    """All numbers of the vector that this is a component of, if any."""
    by_law: bool = False
    """True if a law decides the unit, so that texts without one are accepted everywhere."""

    def read(self, text: str) -> float:
        """The SI value of a text such as ``0.1``, ``5 N/mm`` or ``-60deg``."""
        try:
            value = si_number(number_in(text, self.unit, bare=True), self.unit)
        except PydanticCustomError as error:
            raise InputError(f"{self.name}: {error.message()}") from None
        if self.whole and value != round(value):
            raise InputError(f"{self.name}: must be a whole number (got {value:g})")
        return value


def degrees(angle: float) -> float:
    """Angle in degrees, rounded to remove rounding errors."""
    return round(math.degrees(angle), 9) + 0.0


#: A number, or three, among the arguments of a user's own code.
ARGUMENT = TableField("", float | Triple, (Unit(""),), None, True)


def _known_arguments(given: Mapping[str, Any]) -> str:
    return f"known here: {', '.join(given)}" if given else "the code is given none"


def refuse_unread(path: Path, scenario: Settings, others: Iterable[Path]) -> None:
    """Refuse a number of a surface that its law does not read: to vary it would change nothing.

    Args:
        path: Of the number.
        scenario: That has it.
        others: Paths that vary as well; a law, or a whole surface, may bring another that does.

    Raises:
        InputError: With the law.
    """
    node: Any = scenario
    for key in path[:-1]:
        try:
            node = node[key] if isinstance(key, int) else getattr(node, key)
        except (TypeError, IndexError, AttributeError):
            return
    unread = getattr(node, "unread", None)
    if unread is None or path[-1] not in unread():
        return
    law = (*path[:-1], "law")
    if not any(one == law[: len(one)] for one in others):
        raise InputError(
            f"law {node.law} does not use it, so it would change nothing; give a law that has it "
            f"({dotted_path(law)})"
        )


def _unit_by_law(path: Path, holder: Any) -> str:
    """Unit of the stiffness of a surface, N/mⁿ by its law; empty for other plain numbers."""
    kind = holder if isinstance(holder, type) else type(holder)
    if path[-1] != "stiffness" or not issubclass(kind, HystereticSettings):
        return ""
    is_linear = getattr(holder, "law", None) in ("kelvin-voigt", "foam")
    declared = fields_of(kind)["exponent"].default
    n = 1.0 if is_linear else getattr(holder, "exponent", declared)
    return "N/m" if n == 1.0 else f"N/m^{n:g}"


def number_at(
    name: str, path: Path, scenario: Settings, known: tuple[str, ...]
) -> Parameter | None:
    """The number at a path of a scenario; None if what is there is no single number.

    A table that is not there is looked up in its class.

    Args:
        name: That it goes by.
        path: Keys and indices, at least one.
        scenario: That has it.
        known: Further names, one of which may have been meant.

    Raises:
        InputError: If there is nothing of this path.
    """
    field: TableField | None = None
    node: Any = scenario
    holder: Any = scenario
    others: tuple[Any, ...] = ()
    for depth, key in enumerate(path):
        if isinstance(key, int):
            if not isinstance(node, tuple) or key >= len(node):
                missing = dotted_path(path[: depth + 1])
                raise InputError(f"{name}: the scenario has no {missing}")
            others, node = node, node[key]
            continue
        if isinstance(node, Mapping):  # arguments of a user's own code
            if key not in node:
                raise InputError(f"{name}: unknown parameter {key!r}; {_known_arguments(node)}")
            field, others, node = ARGUMENT, (), node[key]
            continue
        kind = node if isinstance(node, type) else type(node)
        if not issubclass(kind, Settings):
            raise InputError(f"{name}: unknown parameter; {key!r} is not inside a table")
        fields = fields_of(kind)
        if key not in fields:
            near = nearest_name(key, [*fields, *known])
            if near == key:  # a short name that needs more than this scenario has
                other = "start.velocity.0" if key == "speed" else "start.pitch"
                raise InputError(
                    f"{name}: {key!r} needs a reference of type run-up; for a throw vary {other}"
                )
            hint = f"did you mean {near}?" if near else f"known here: {', '.join(fields)}"
            raise InputError(f"{name}: unknown parameter {key!r}; {hint}")
        field, others, holder = fields[key], (), node
        node = field.default if isinstance(node, type) else getattr(node, key)
        node = field.table if node is None else node
    if field is None or any(not isinstance(entry, float | int) for entry in others):
        return None
    inside = isinstance(path[-1], int)
    for leaf, notes in field.leaves:
        unit = next((note.unit for note in notes if isinstance(note, Unit)), None)
        if unit is not None and (leaf is float or (inside and get_origin(leaf) is tuple)):
            by_law = "" if unit else _unit_by_law(path, holder)
            return Parameter(name, path, unit or by_law, False, others, bool(by_law))
    whole = any(leaf is int for leaf, _ in field.leaves)
    return Parameter(name, path, "", True, others) if whole else None
