"""Directives for modules and their public names.

`.. chapter-module:: springback.contact.surfaces` documents everything public that a module defines,
`.. internal-modules::` lists modules with their first lines, `.. public-names::` what
`import springback` provides.
"""

import importlib
import inspect
from typing import Any

from docstrings import escaped
from docutils import nodes
from docutils.parsers.rst import Directive
from docutils.statemachine import StringList
from sphinx.application import Sphinx
from sphinx.pycode import ModuleAnalyzer

import springback
from springback.settings import Settings

#: Names whose values have no docstring.
ABOUT = {
    "ARQ": "The compliant quadrotor as flown, with the source of every number.",
    "QUAD": "The rigid twin as flown.",
    "VEHICLES": "All vehicles of the library by name.",
    "WALL": "Surface of the paper's wall.",
    "MAT": "Surface of the paper's mat.",
}


def _is_own(thing: Any, module: str) -> bool:
    return getattr(thing, "__module__", None) == module


def entries(name: str) -> list[str]:
    """Lines that document a module's public names in the order of its source."""
    module = importlib.import_module(name)
    analyzer = ModuleAnalyzer.for_module(name)
    analyzer.analyze()
    documented = {key for owner, key in analyzer.attr_docs if not owner}
    lines: list[str] = []
    order = analyzer.tagorder
    names = sorted(
        (n for n in vars(module) if not n.startswith("_")), key=lambda n: order.get(n, 10**6)
    )
    for member in names:
        thing, path = getattr(module, member), f"{name}.{member}"
        if inspect.isclass(thing) and _is_own(thing, name):
            lines += [f".. autoclass:: {path}", "   :members:"]
            if issubclass(thing, Settings):
                hidden = ", ".join([*thing.model_fields, "model_config"])
                lines += [f"   :exclude-members: {hidden}"]
            elif issubclass(thing, BaseException) or issubclass(thing, tuple):
                lines += ["   :exclude-members: __new__"]
            lines += [""]
        elif inspect.isroutine(thing) and _is_own(thing, name):
            if hasattr(thing, "register") and not hasattr(thing, "registry"):
                thing.registry = {}  # Sphinx takes our generic functions for functools' own
            lines += [f".. autofunction:: {path}", ""]
        elif member in ABOUT:
            lines += [f".. py:data:: {member}", "", f"   {ABOUT[member]}", ""]
        elif member in documented:
            lines += [f".. autodata:: {path}", "   :no-value:", ""]
    return lines


class ChapterModule(Directive):
    """A module: what it is about, and its public names."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """The section's nodes."""
        name = self.arguments[0]
        lines = [f".. automodule:: {name}", "", *entries(name)]
        box = nodes.container()
        self.state.nested_parse(StringList(lines, source=name), 0, box)
        return box.children


class InternalModules(Directive):
    """A table of the modules that the content names, each with its first line."""

    has_content = True

    def run(self) -> list[nodes.Node]:
        """The table."""
        lines = [".. list-table::", "   :header-rows: 1", "   :widths: 40 60", ""]
        lines += ["   * - module", "     - subject"]
        for name in self.content:
            about = inspect.getdoc(importlib.import_module(name)) or ""
            lines += [f"   * - ``{name}``", f"     - {escaped(about.splitlines()[0])}"]
        box = nodes.container()
        self.state.nested_parse(StringList(lines), 0, box)
        return box.children


class PublicNames(Directive):
    """A table of what the package itself gives."""

    def run(self) -> list[nodes.Node]:
        """Name, where it lives, and its first sentence."""
        lines = [".. list-table::", "   :header-rows: 1", "   :widths: 25 75", ""]
        lines += ["   * - name", "     - what"]
        for name, chapter in springback._PUBLIC.items():
            path = f"springback.{chapter}.{name}"
            lines += [f"   * - :py:obj:`{name} <{path}>`", f"     - {said(path)}"]
        box = nodes.container()
        self.state.nested_parse(StringList(lines), 0, box)
        return box.children


def said(path: str) -> str:
    """The first line of what documents a name."""
    module, _, name = path.rpartition(".")
    thing = getattr(importlib.import_module(module), name)
    analyzer = ModuleAnalyzer.for_module(module)
    analyzer.analyze()
    comment = analyzer.attr_docs.get(("", name))
    if comment:
        return escaped(" ".join(part for part in comment if part))
    if not (inspect.isclass(thing) or inspect.isroutine(thing)):
        return ABOUT[name]
    return escaped((inspect.getdoc(thing) or "").split("\n\n")[0].replace("\n", " "))


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the directives."""
    app.add_directive("public-names", PublicNames)
    app.add_directive("chapter-module", ChapterModule)
    app.add_directive("internal-modules", InternalModules)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
