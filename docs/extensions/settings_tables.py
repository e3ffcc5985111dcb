"""Tables of settings as tables of the documentation: key, unit and range, default, meaning."""

from typing import Any, Literal, get_origin

from docstrings import escaped, found
from docutils import nodes
from docutils.parsers.rst import Directive
from docutils.statemachine import StringList
from sphinx.application import Sphinx

from springback.interfaces.reports.table_keys import (
    default_text,
    meanings,
    plain_kind,
    tables_below,
    unit_text,
    words_for,
)
from springback.scenario.fields import TableField, fields_of
from springback.settings import Settings


def allowed(field: TableField) -> str:
    """Unit and range, or the words to choose from."""
    if get_origin(field.annotation) is Literal:
        return ", ".join(f"``{word}``" for word in field.words)
    if text := unit_text(field):
        return text
    if field.tables:
        return " or ".join(
            f":py:obj:`~{cls.__module__}.{cls.__qualname__}`" for cls in field.tables
        )
    return plain_kind(field)


def default(field: TableField) -> str:
    """What holds where nothing is given; angles in degrees, too."""
    if field.required:
        return "*needed*"
    text = default_text(field)
    return f"``{text}``" if text and isinstance(field.default, str) else text


def table(cls: type[Settings]) -> list[str]:
    """Lines of a table of all keys of some settings."""
    told: dict[str, str] = {}
    for base in reversed(cls.__mro__):
        if isinstance(base, type) and issubclass(base, Settings) and base is not Settings:
            told |= meanings(base)
    lines = [".. list-table::", "   :header-rows: 1", "   :widths: 20 25 15 40", ""]
    lines += ["   * - key", "     - unit, range", "     - default", "     - meaning"]
    for name, field in fields_of(cls).items():
        words = " ".join(escaped(told.get(name) or words_for(name, field)).split())
        unit = allowed(field)
        cells = [f"``{field.key}``", unit, default(field), words]
        lines += [("   * - " if k == 0 else "     - ") + cell for k, cell in enumerate(cells)]
    return [*lines, ""]


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
    for inner in [cls, *(one for _, classes in tables_below(cls) for one in classes)]:
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
        for path, classes in tables_below(found(self.arguments[0])):
            links = ", ".join(
                f":py:obj:`{c.__qualname__} <{c.__module__}.{c.__qualname__}>`" for c in classes
            )
            lines += [f"   * - ``{path}``", f"     - {links}"]
        box = nodes.container()
        self.state.nested_parse(StringList(lines), 0, box)
        return box.children


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
