"""Keys of settings for reading: unit, range, default and meaning, as their source declares them.

The documentation's tables and ``springback show --keys`` are made from these.
"""

from __future__ import annotations

import ast
import inspect
import itertools
import math
import textwrap
from functools import cache
from typing import Any, NamedTuple

from springback.errors import InputError
from springback.problems import dotted_path, key_path, nearest_name
from springback.quantities import Pair, PerArm, Quadruple, Triple
from springback.scenario.fields import TableField, fields_of
from springback.scenario.scenario import Scenario
from springback.settings import Settings

#: Keys whose names say nearly all; their sources do not describe them.
PLAIN = {
    "type": "Which kind of table this is.",
    "name": "Name in results.",
    "mass": "Mass.",
    "cage_radius": "Radius r₀ of the circle around the rotor.",
    "stiffness": "Stiffness k_l of the spring.",
    "damping": "Coefficient b_l of the damper.",
    "stop_stiffness": "Stiffness k in the stops' force.",
    "gravity": "Acceleration g of gravity, along −Z.",
    "obstacles": "Everything there is to hit, one table each.",
    "law": "Law of the normal force.",
    "exponent": "Exponent n of the law.",
    "restitution": "Coefficient of restitution e; if given, c_a is computed from it.",
    "restitution_speed": "Speed to which e applies.",
    "friction": "Coefficient of friction μ.",
    "height": "Height of its face above Z = 0, or height of a body.",
    "thickness": "Distance from its face to the wall behind, or thickness of a wall.",
    "position": "Position of the main body, of a centre, or of a point on the face.",
    "positions": "Positions, one after another.",
    "velocity": "Velocity of the main body, world axes.",
    "roll": "Euler angle, ZYX.",
    "pitch": "Euler angle, ZYX; positive is nose down.",
    "yaw": "Euler angle, ZYX.",
    "angular_velocity": "Angular velocity, body axes.",
    "centre": "Centre of the circle.",
    "radius": "Radius of the circle, or of a round body.",
    "top_radius": "Radius at the top; 0 is a tip.",
    "tube_radius": "Radius of the tube.",
    "edge_radius": "Radius of its rounded edges, within its size.",
    "size": "Width and height.",
    "width": "Width.",
    "steps": "Number of steps.",
    "rise": "Height of a step.",
    "tread": "Depth of a step.",
    "seed": "Seed of its random positions.",
    "period": "Time for one round.",
    "begins": "Time until which the robot waits at the first point.",
    "start": "Where it begins, at rest; in a scenario by default ``start.position``.",
    "rate": "Sampling rate.",
    "delay": "Time from sample to arrival.",
    "full_scale": "Readings end at plus and minus this.",
    "bits": "Resolution of the converter.",
    "remanence": "Remanence B_r of the magnet.",
    "magnet_radius": "Radius of the disc.",
    "magnet_thickness": "Thickness of the disc.",
    "sensitivity": "Output per unit of field.",
    "supply": "Supply voltage of sensor and converter.",
    "quiescent": "Output without a field.",
    "lowest": "Lowest output, at saturation.",
    "highest": "Highest output, at saturation.",
    "initial_velocity": "Standard deviation at the start.",
    "initial_attitude": "Standard deviation at the start.",
    "initial_accelerometer_bias": "Standard deviation at the start.",
    "initial_gyroscope_bias": "Standard deviation at the start.",
    "duration": "Duration of the flight.",
    "free_step": "Largest step in free flight.",
    "impact_step": "Step while anything is in contact.",
    "method": "How samples are laid out.",
    "from_": "Lower end.",
    "to": "Upper end.",
    "spacing": "Spacing between the ends.",
    "heading": "Yaw at the start.",
    "wall_distance": "Distance of the wall.",
    "wall_yaw": "Yaw of the wall.",
    "inertia": "Ratio of the true to the assumed value.",
    "gains": "Factors of the five gains.",
}

_POWERS = str.maketrans({"2": "²", "3": "³"})
_SIGNS = {"above": ">", "least": "≥", "most": "≤"}
_KINDS = {bool: "true, false", int: "whole number", str: "text"}


class KeyLine(NamedTuple):
    """A key of a table, for reading."""

    key: str
    allowed: str  # unit and range, words, or the tables that it takes
    default: str
    meaning: str


class KeyTable(NamedTuple):
    """A table that may be at a path, for reading."""

    path: str
    kind: str  # its ``type``, if it has one
    meaning: str
    keys: tuple[KeyLine, ...]


def meanings(table: type[Settings]) -> dict[str, str]:
    """Strings below the fields of a table, and of those that it inherits them from."""
    told: dict[str, str] = {}
    bases = [base for base in reversed(table.__mro__) if issubclass(base, Settings)]
    for field, text in itertools.chain.from_iterable(map(_statements, bases)):
        if not isinstance(field, ast.AnnAssign) or not isinstance(field.target, ast.Name):
            continue
        words = text.value if isinstance(text, ast.Expr) else None
        if isinstance(words, ast.Constant) and isinstance(words.value, str):
            told[field.target.id] = inspect.cleandoc(words.value)
    return told


@cache
def _statements(cls: type) -> list[tuple[ast.stmt, ast.stmt]]:
    """Every statement in the body of a class with the one that follows it."""
    body = ast.parse(textwrap.dedent(inspect.getsource(cls))).body[0]
    return list(itertools.pairwise(body.body if isinstance(body, ast.ClassDef) else []))


def words_for(name: str, field: TableField) -> str:
    """Meaning of a key without words of its own: the first sentence of its table, or the obvious.

    Args:
        name: Of its attribute.
        field: As declared.
    """
    return _title(field.tables[0]) if len(field.tables) == 1 else PLAIN[name]


def _title(table: type) -> str:
    """First paragraph of what a table says of itself."""
    return (inspect.getdoc(table) or "").split("\n\n")[0]


def number_text(value: float) -> str:
    """A number, briefly."""
    return f"{value:.6g}"


def unit_text(field: TableField) -> str:
    """Unit, number and range of the numbers of a key; empty if it has none."""
    if (unit := field.unit) is None:
        return ""
    bounds = {sign: getattr(unit, name) for name, sign in _SIGNS.items()}
    limits = ", ".join(f"{s} {number_text(b)}" for s, b in bounds.items() if b is not None)
    text = unit.unit.replace("^0.5", "^½").translate(_POWERS).replace("^", "")
    return (text or "plain") + _count_text(field) + (f"; {limits}" if limits else "")


def largest_text(field: TableField) -> str:
    """Unit, number and range of a key of a scenario, with the largest magnitude of its numbers."""
    text, unit, largest = unit_text(field), field.unit, field.largest
    if unit is None or largest is None or unit.unit == "rad":  # angles are within a full turn
        return text
    signed = unit.least is None and unit.above is None
    bound = f"within ±{number_text(largest)}" if signed else f"≤ {number_text(largest)}"
    return text + (", " if ";" in text else "; ") + bound


def _count_text(field: TableField) -> str:
    """How many numbers a key takes, in words; empty for one."""
    types = {leaf for leaf, _ in field.entries}
    for kind, count in ((Pair, "two"), (Triple, "three"), (Quadruple, "four")):
        if kind in types:
            each = tuple[kind, ...] in types  # type: ignore[valid-type]
            return f", {count}" + (f", or {count} for each arm" if each else "")
    return ", or one for each arm" if field.shape is PerArm else ""


def plain_kind(field: TableField) -> str:
    """Kind of a value that is neither a number with a unit nor a table; empty if unknown."""
    kind, _ = field.entries[0]
    return _KINDS.get(kind, "")


def default_text(field: TableField) -> str:
    """Value without input, angles in degrees, too; empty if it needs no words.

    Args:
        field: As declared.
    """
    value = field.default
    if field.required or value is None or isinstance(value, Settings) or value in ((), "", {}):
        return ""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        turn = unit_text(field).startswith("rad") and value
        return number_text(value) + (f" ({math.degrees(value):.4g}°)" if turn else "")
    return _list_text(value)


def _list_text(value: Any) -> str:
    if isinstance(value, tuple):
        return "[" + ", ".join(_list_text(part) for part in value) + "]"
    return number_text(value) if isinstance(value, float) else str(value)


def tables_below(table: type[Settings], path: str = "") -> list[tuple[str, list[type[Settings]]]]:
    """Every table below some settings: its dotted path, and the types that it may have.

    Args:
        table: The settings.
        path: Of these, before all others.
    """
    rows: list[tuple[str, list[type[Settings]]]] = []
    for name, field in fields_of(table).items():
        if not field.tables:
            continue
        here = f"{path}.{name}" if path else name
        rows.append((here, field.tables))
        for one in field.tables:
            rows += [row for row in tables_below(one, here) if row not in rows]
    return rows


def _line(name: str, field: TableField, told: dict[str, str]) -> KeyLine:
    names = ", ".join(dict.fromkeys(filter(None, map(_kind, field.tables)))) or "table"
    allowed = (
        ", ".join(field.words)
        or largest_text(field)
        or (names if field.tables else plain_kind(field))
    )
    default = "needed" if field.required else default_text(field)
    words = " ".join((told.get(name) or words_for(name, field)).replace("`", "").split())
    return KeyLine(field.key, allowed, default, words)


def _kind(table: type[Settings]) -> str:
    """The ``type`` of a table; empty if it has none."""
    known = fields_of(table).get("type")
    return known.words[0] if known is not None and len(known.words) == 1 else ""


def _of_key(tables: list[type[Settings]], key: str) -> list[type[Settings]]:
    """Tables that a key of some may hold."""
    named = (f for one in tables for f in fields_of(one).values() if f.key == key)
    return list(dict.fromkeys(inner for field in named for inner in field.tables))


def _at(path: str) -> tuple[list[type[Settings]], str]:
    """Tables at a path of a scenario, none if it is unknown, and the path without types."""
    tables, above = list[type[Settings]]([Scenario]), ""
    for part in path.split(".") if path else ():
        by_key = _of_key(tables, part)
        if by_key:
            above = f"{above}.{part}" if above else part
        tables = by_key or [one for one in tables if _kind(one) == part]
    return tables, above


def key_tables(path: str = "") -> list[KeyTable]:
    """The tables that may be at a path of a scenario, with their keys.

    Args:
        path: Dotted, without numbers of entries or with them; empty for the scenario itself.  A
            part may be the ``type`` of one of several, as in ``world.obstacles.pole.surface``;
            what is before the first part may be left out where there is one such path only, as in
            ``hulls.ring``.

    Raises:
        InputError: If a scenario has no table there, with the nearest that it has.
    """
    tables, above = _at(whole_path(path))
    return [
        KeyTable(
            above,
            _kind(one),
            " ".join(_title(one).replace("`", "").split()),
            tuple(_line(name, field, meanings(one)) for name, field in fields_of(one).items()),
        )
        for one in tables
    ]


def whole_path(path: str) -> str:
    """Path of a table from the scenario on, without numbers of entries; as for `key_tables`.

    Raises:
        InputError: If a scenario has no such table, or several.
    """
    wanted = dotted_path(tuple(part for part in key_path(path) if isinstance(part, str)))
    if _at(wanted)[0]:
        return wanted
    known = [one for one in table_paths() if not one.startswith("second.")]
    ends = [one for one in known if one.endswith(f".{wanted}")]
    if len(ends) == 1:
        return ends[0]
    if ends:
        raise InputError(f"{wanted!r} is in several tables; give one of {', '.join(ends)}")
    near = nearest_name(wanted, known)
    hint = f"did you mean {near}?" if near else "springback show --keys lists them"
    raise InputError(f"a scenario has no table {wanted!r}; {hint}")


def table_paths(path: str = "") -> list[str]:
    """Dotted paths of all tables below one of a scenario, and of each type of those of several.

    Args:
        path: Of that table, from the scenario on; empty for all.
    """
    found = list[str]()

    def add(tables: list[type[Settings]], here: str) -> None:
        kinds = [kind for kind in map(_kind, tables) if kind]
        found.extend(f"{here}.{kind}" for kind in kinds if len(kinds) > 1)
        for key in dict.fromkeys(f.key for one in tables for f in fields_of(one).values()):
            if inner := _of_key(tables, key):
                below = f"{here}.{key}" if here else key
                found.append(below)
                add(inner, below)

    add(_at(path)[0], path)
    return found


def table_text(table: KeyTable) -> str:
    """A table with its keys in lines."""
    name = table.path or "a scenario"
    title = f"{name}, type = {table.kind!r}" if table.kind else name
    lines = [f"{title}: {table.meaning}"]
    for one in table.keys:
        says = one.default if one.default in ("", "needed") else f"default {one.default}"
        middle = ", ".join(filter(None, (one.allowed, says)))
        lines += [f"  {one.key}" + (f" ({middle})" if middle else "")]
        lines += textwrap.wrap(one.meaning, 96, initial_indent="      ", subsequent_indent="      ")
    return "\n".join(lines)
