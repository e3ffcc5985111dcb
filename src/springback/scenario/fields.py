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
from springback.kernels.tracing import Traced, holds  # for batch set-up
from springback.problems import dotted_path, nearest_name
from springback.quantities import (
    FULL_TURN,
    PerArm,
    Quadruple,
    Triple,
    Unit,
    number_in,
    si_number,
    with_unit,
)
from springback.settings import Settings, problem
from springback.vehicle.force_laws import HystereticSettings

Path = tuple[str | int, ...]

#: Largest magnitude of the numbers of a scenario, by their unit, where a field declares none
#: (chosen: far beyond any vehicle, and flights still end with finite numbers; measured: a surface
#: of 1e15 N/m, 1e5 m/s and places 1e7 m away leave the ledger open, or diverge).
LARGEST_BY_UNIT = {
    "m": 1e6, "m/s": 1e4, "m/s^2": 1e6, "rad": FULL_TURN, "rad/s": 1e5, "rad/s^2": 1e9,
    "s": 1e9, "1/s": 1e9, "1/s^2": 1e12, "Hz": 1e12, "s/m": 1e6, "s^2/m": 1e6, "1/m^2": 1e6,
    "kg": 1e9, "kg m^2": 1e12, "kg/m": 1e6, "kg/m^3": 1e6,
    "N": 1e6, "N/m": 1e12, "N/m^2": 1e12, "N s/m": 1e9, "N/(m s)": 1e9, "N s^2/rad^2": 1e6,
    "N m": 1e6, "N m/rad": 1e12, "N m/rad^2": 1e12, "N m s/rad": 1e9,
    "J": 1e12, "W": 1e9, "T": 1e3, "V": 1e6, "V/T": 1e9,
    "m/s^2/Hz^0.5": 1e6, "m/s^3/Hz^0.5": 1e6, "rad/s/Hz^0.5": 1e5, "rad/s^2/Hz^0.5": 1e5,
    "": 1e6,
}  # fmt: skip
#: The same by key: plain numbers of which less is absurd (measured: a friction of 1000 leaves the
#: ledger open), or whose unit depends on the law, and what is read in a way of its own.
LARGEST_BY_KEY = {
    "friction": 100.0, "stiffness": 1e12, "every": 1e6, "shared_by": 1e6,
    "loading": 1e9, "unloading": 1e9, "table": 1e9, "points": 1e6,
}  # fmt: skip
_PLAIN = LARGEST_BY_UNIT[""]


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
    def largest(self) -> float | None:
        """Largest magnitude that its numbers may have; None if they are none, or bounded already.

        SI; a range that the field declares holds besides.
        """
        unit = self.unit
        if unit is None:
            return LARGEST_BY_KEY.get(self.key)
        if unit.most is not None and not (unit.least is None and unit.above is None):
            return None
        return LARGEST_BY_UNIT[unit.unit] if unit.unit else LARGEST_BY_KEY.get(self.key, _PLAIN)

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


# -- magnitudes -----------------------------------------------------------------------------------


def check_magnitudes(node: Any, path: Path = ()) -> None:
    """Reject numbers of a table, and of those in it, that are absurdly large.

    Args:
        node: The table, or several of them; anything else has none.
        path: Of it in the scenario.

    Raises:
        The problem of the first one, with its path, unit and range.
    """
    if isinstance(node, tuple | Mapping):
        entries = node.items() if isinstance(node, Mapping) else enumerate(node)
        for key, entry in entries:
            check_magnitudes(entry, (*path, key))
    if not isinstance(node, Settings):
        return
    given = node.model_fields_set  # defaults are no larger
    for name, key, largest, has_tables in _bounded(type(node)):
        if name not in given:
            continue
        value = getattr(node, name)
        if has_tables:
            check_magnitudes(value, (*path, key))
        if largest is not None:
            _check_numbers(value, largest, node, (*path, key))


@functools.cache
def _bounded(table: type[Settings]) -> tuple[tuple[str, str, float | None, bool], ...]:
    """Attributes with numbers or tables: each name, key, `TableField.largest`, and if tables."""
    fields = fields_of(table).items()
    rows = ((name, one.key, one.largest, bool(one.tables)) for name, one in fields)
    return tuple(row for row in rows if row[2] is not None or row[3])


def _check_numbers(value: Any, largest: float, holder: Settings, path: Path) -> None:
    """Reject numbers beyond a magnitude, in lists of any depth."""
    if isinstance(value, tuple):
        for k, entry in enumerate(value):
            _check_numbers(entry, largest, holder, (*path, k))
        return
    is_number = isinstance(value, float | int | Traced) and not isinstance(value, bool)
    if is_number and not holds(lambda x: abs(x) <= largest, value):
        raise _too_large(value, largest, holder, path)


def _too_large(value: float, largest: float, holder: Settings, path: Path) -> PydanticCustomError:
    """Problem of a number of a table beyond a magnitude."""
    key = next(word for word in reversed(path) if isinstance(word, str))
    field = next(one for one in fields_of(type(holder)).values() if one.key == key)
    declared = field.unit or Unit("")
    unit = declared.unit or _unit_by_law((key,), holder)
    signed = declared.least is None and declared.above is None
    bound = with_unit(largest, unit)
    wanted = f"from -{bound} to {bound}" if signed else f"at most {bound}"
    return problem(f"must be {wanted} (got {with_unit(value, unit)})", dotted_path(path))


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
