"""Tables of settings as tables of the documentation: key, unit and range, default, meaning."""

import ast
import inspect
import itertools
import math
import textwrap
from collections.abc import Iterator
from typing import Any, Literal, get_origin

from docstrings import escaped, found
from docutils import nodes
from docutils.parsers.rst import Directive
from docutils.statemachine import StringList
from sphinx.application import Sphinx

from springback.quantities import PerArm, Quadruple, Triple
from springback.scenario.fields import TableField, fields_of
from springback.settings import Settings

#: Keys whose names say nearly all; the source has no words for them.
PLAIN = {
    "type": "Which kind of table this is.",
    "name": "As it stands in results.",
    "mass": "Mass.",
    "cage_radius": "Radius r₀ of the circle around the rotor.",
    "stiffness": "k_l of the spring.",
    "damping": "b_l of the damper.",
    "stop_stiffness": "k of the stops' force.",
    "gravity": "g, along −Z.",
    "obstacles": "What there is to hit, one table each.",
    "law": "Of the normal force.",
    "exponent": "n of the law.",
    "restitution": "e; with it c_a is solved for.",
    "restitution_speed": "Speed at which e is meant.",
    "friction": "μ.",
    "height": "Of its face above Z = 0, or of a body.",
    "thickness": "From its face to the wall behind, or of a wall.",
    "position": "Of the main body, of a centre, or a point of the face.",
    "positions": "One after another.",
    "velocity": "Of the main body, world axes.",
    "roll": "Euler angle, ZYX.",
    "pitch": "Euler angle, ZYX; positive is nose down.",
    "yaw": "Euler angle, ZYX.",
    "angular_velocity": "Body axes.",
    "centre": "Of the circle.",
    "radius": "Of the circle, or of a round body.",
    "top_radius": "At the top; 0 is a tip.",
    "tube_radius": "Of the tube.",
    "edge_radius": "By which its edges are rounded, within its size.",
    "size": "Width and height.",
    "width": "Across.",
    "steps": "Number of steps.",
    "rise": "Height of a step.",
    "tread": "Depth of a step.",
    "seed": "Of its random places.",
    "period": "Time for one round.",
    "begins": "Until then the robot waits at the first point.",
    "start": "Where it begins, at rest; in a scenario ``start.position`` unless given.",
    "rate": "Of its samples.",
    "delay": "From sample to arrival.",
    "full_scale": "Readings end at plus and minus this.",
    "bits": "Of the converter.",
    "remanence": "B_r of the magnet.",
    "magnet_radius": "Of the disc.",
    "magnet_thickness": "Of the disc.",
    "sensitivity": "Output per field.",
    "supply": "Voltage of sensor and converter.",
    "quiescent": "Output without a field.",
    "lowest": "Output, saturated.",
    "highest": "Output, saturated.",
    "initial_velocity": "Standard deviation at the start.",
    "initial_attitude": "Standard deviation at the start.",
    "initial_accelerometer_bias": "Standard deviation at the start.",
    "initial_gyroscope_bias": "Standard deviation at the start.",
    "duration": "Of the flight.",
    "free_step": "Largest step in free flight.",
    "impact_step": "Step while something touches.",
    "method": "How samples are laid out.",
    "from_": "Lower end.",
    "to": "Upper end.",
    "spacing": "Between the ends.",
    "heading": "Yaw at the start.",
    "wall_distance": "Of the wall.",
    "wall_yaw": "Turn of the wall.",
    "inertia": "True over believed.",
    "gains": "Each of five gains.",
}


POWERS = str.maketrans({"2": "²", "3": "³"})


def meanings(cls: type) -> dict[str, str]:
    """The strings below the fields of a class, and of those it inherits them from."""
    told: dict[str, str] = {}
    bases = [base for base in reversed(cls.__mro__) if issubclass(base, Settings)]
    for field, text in itertools.chain.from_iterable(map(_statements, bases)):
        is_field = isinstance(field, ast.AnnAssign) and isinstance(field.target, ast.Name)
        is_text = isinstance(text, ast.Expr) and isinstance(text.value, ast.Constant)
        if is_field and is_text and isinstance(text.value.value, str):
            told[field.target.id] = inspect.cleandoc(text.value.value)
    return told


def _statements(cls: type) -> Iterator[tuple[ast.stmt, ast.stmt]]:
    """Every statement in the body of a class with the one that follows it."""
    return itertools.pairwise(ast.parse(textwrap.dedent(inspect.getsource(cls))).body[0].body)


def _number(value: float) -> str:
    """A number, briefly."""
    return f"{value:.6g}"


def allowed(field: TableField) -> str:
    """Unit and range, or the words to choose from."""
    if get_origin(field.annotation) is Literal:
        return ", ".join(f"``{word}``" for word in field.words)
    if unit := field.unit:
        signs = {"above": ">", "least": "≥", "most": "≤"}
        bounds = {sign: getattr(unit, name) for name, sign in signs.items()}
        limits = ", ".join(f"{s} {_number(b)}" for s, b in bounds.items() if b is not None)
        text = unit.unit.replace("^0.5", "^½").translate(POWERS).replace("^", "")
        kinds = {Triple: ", three", Quadruple: ", four", PerArm: ", or one for each arm"}
        kind = kinds.get(field.shape, "")
        return (text or "plain") + kind + (f"; {limits}" if limits else "")
    if field.tables:
        return " or ".join(
            f":py:obj:`~{cls.__module__}.{cls.__qualname__}`" for cls in field.tables
        )
    plain = {bool: "true, false", int: "whole number", str: "text"}
    kind, _ = field.entries[0]
    return plain.get(kind, "")


def default(field: TableField, unit: str) -> str:
    """What holds where nothing is given; angles in degrees, too."""
    if field.required:
        return "*needed*"
    value = field.default
    if value is None or isinstance(value, Settings) or value in ((), "", {}):
        return ""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        turn = unit.startswith("rad") and value
        return _number(value) + (f" ({math.degrees(value):.4g}°)" if turn else "")
    if isinstance(value, tuple):
        return "[" + ", ".join(_inner(part) for part in value) + "]"
    return f"``{value}``" if isinstance(value, str) else str(value)


def _inner(value: Any) -> str:
    if isinstance(value, tuple):
        return "[" + ", ".join(_inner(part) for part in value) + "]"
    return _number(value) if isinstance(value, float) else str(value)


def table(cls: type[Settings]) -> list[str]:
    """Lines of a table of all keys of some settings."""
    told: dict[str, str] = {}
    for base in reversed(cls.__mro__):
        if isinstance(base, type) and issubclass(base, Settings) and base is not Settings:
            told |= meanings(base)
    lines = [".. list-table::", "   :header-rows: 1", "   :widths: 20 25 15 40", ""]
    lines += ["   * - key", "     - unit, range", "     - default", "     - meaning"]
    for name, field in fields_of(cls).items():
        words = " ".join(escaped(told.get(name) or said(name, field)).split())
        unit = allowed(field)
        cells = [f"``{field.key}``", unit, default(field, unit), words]
        lines += [("   * - " if k == 0 else "     - ") + cell for k, cell in enumerate(cells)]
    return [*lines, ""]


def said(name: str, field: TableField) -> str:
    """What a key without words of its own is: the first sentence of its table, or the obvious."""
    if len(field.tables) == 1:
        return (inspect.getdoc(field.tables[0]) or "").split("\n\n")[0]
    return PLAIN[name]


def with_table(
    app: Sphinx, what: str, name: str, thing: Any, options: Any, lines: list[str]
) -> None:
    """The table of a settings class below its docstring."""
    is_table = what == "class" and isinstance(thing, type) and issubclass(thing, Settings)
    if is_table and thing.model_fields:
        lines += ["", *table(thing)]


def choices(cls: type[Settings]) -> set[str]:
    """Keys of some settings and of the tables below them, and the words that these take."""
    words: set[str] = set()
    for inner in [cls, *(one for _, classes in walk(cls, "") for one in classes)]:
        for key, field in fields_of(inner).items():
            words |= {key, *field.words}
    return words


class Tables(Directive):
    """`.. settings:: springback.scenario.scenario.Scenario`: all tables below it, with links."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """The rows."""
        lines = [".. list-table::", "   :header-rows: 1", "   :widths: 35 65", ""]
        lines += ["   * - table", "     - settings"]
        for path, classes in walk(found(self.arguments[0]), ""):
            links = ", ".join(
                f":py:obj:`{c.__qualname__} <{c.__module__}.{c.__qualname__}>`" for c in classes
            )
            lines += [f"   * - ``{path}``", f"     - {links}"]
        box = nodes.container()
        self.state.nested_parse(StringList(lines), 0, box)
        return box.children


def walk(cls: type[Settings], path: str) -> list[tuple[str, list[type]]]:
    """Every table below some settings, with its dotted path."""
    rows: list[tuple[str, list[type]]] = []
    for name, field in fields_of(cls).items():
        if not field.tables:
            continue
        here = f"{path}.{name}" if path else name
        rows.append((here, field.tables))
        for one in field.tables:
            rows += [row for row in walk(one, here) if row not in rows]
    return rows


def unsigned(
    app: Sphinx, what: str, name: str, thing: Any, options: Any, signature: str, returned: str
) -> tuple[str, str] | None:
    """The table says it all."""
    if what == "class" and isinstance(thing, type) and issubclass(thing, Settings):
        return "", ""
    return None


def setup(app: Sphinx) -> dict[str, Any]:
    """Listen to autodoc."""
    app.connect("autodoc-process-docstring", with_table, priority=900)
    app.connect("autodoc-process-signature", unsigned)
    app.add_directive("settings", Tables)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
