"""Directives for modules and their public names.

`.. public:: Flight fly` documents names of the package, `.. chapter-module::` everything else that
a module defines, `.. internal-modules::` lists modules, `.. public-names::` names of the package.
"""

import importlib
import inspect
import re
from typing import Any

from docstrings import escaped
from docutils import nodes
from docutils.parsers.rst import Directive
from docutils.statemachine import StringList
from sphinx.application import Sphinx
from sphinx.pycode import ModuleAnalyzer

import springback
from springback.results.measures import FlightMeasures
from springback.results.result import FlightResult
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


def entry(path: str, thing: Any) -> list[str]:
    """Lines that document a class or a function."""
    if not inspect.isclass(thing):
        if hasattr(thing, "register") and not hasattr(thing, "registry"):
            thing.registry = {}  # Sphinx takes our generic functions for functools' own
        return [f".. autofunction:: {path}", ""]
    lines = [f".. autoclass:: {path}", "   :members:"]
    if issubclass(thing, Settings):
        hidden = ", ".join([*thing.model_fields, "model_config"])
        lines += [f"   :exclude-members: {hidden}"]
    elif issubclass(thing, BaseException) or issubclass(thing, tuple):
        lines += ["   :exclude-members: __new__"]
    elif issubclass(thing, FlightResult):
        measures = ", ".join(inspect.get_annotations(FlightMeasures))  # a table has them
        lines += ["   :inherited-members:", f"   :exclude-members: {measures}"]
    return [*lines, ""]


def analysis(module: str) -> ModuleAnalyzer:
    """Source of a module with its comments."""
    analyzer = ModuleAnalyzer.for_module(module)
    analyzer.analyze()
    return analyzer


def entries(name: str) -> list[str]:
    """Lines that document a module's public names in the order of its source.

    Those that have their place on the page of an object lead there.
    """
    module, analyzer = importlib.import_module(name), analysis(name)
    documented = {key for owner, key in analyzer.attr_docs if not owner}
    lines: list[str] = []
    order = analyzer.tagorder
    names = sorted(
        (n for n in vars(module) if not n.startswith("_")), key=lambda n: order.get(n, 10**6)
    )
    for member in names:
        thing, path = getattr(module, member), f"{name}.{member}"
        if springback._PUBLIC.get(member) == name.removeprefix("springback."):
            lines += [f"* :py:obj:`springback.{member} <{path}>`: {said(path)}", ""]
        elif (inspect.isclass(thing) or inspect.isroutine(thing)) and _is_own(thing, name):
            lines += entry(path, thing)
        elif member in documented:
            lines += [f".. autodata:: {path}", "   :no-value:", ""]
    return lines


def members(path: str, thing: type) -> list[str]:
    """Lines of a table of a class's own and inherited members, each with its first sentence."""
    rows: dict[str, str] = {}
    for cls in reversed(thing.__mro__[:-1]):
        if cls is FlightMeasures:
            continue
        docs = analysis(cls.__module__).attr_docs if cls.__module__ != "builtins" else {}
        for name, value in {
            **dict.fromkeys(inspect.get_annotations(cls)),
            **vars(cls),
        }.items():
            about = docs.get((cls.__qualname__, name)) or [inspect.getdoc(value) or ""]
            if not name.startswith("_") and (value is not None or (cls.__qualname__, name) in docs):
                rows[name] = escaped(re.split(r"(?<=\.) |\n\n", " ".join(about))[0])
    lines = [".. list-table::", "   :widths: 30 70", ""]
    for name, about in rows.items():
        lines += [f"   * - :py:obj:`{name} <{path}.{name}>`", f"     - {about}"]
    return [*lines, ""]


class PublicEntry(Directive):
    """Names of the package, documented in full; of a class first a table of what it has."""

    required_arguments = 1
    final_argument_whitespace = True

    def run(self) -> list[nodes.Node]:
        """The entries."""
        lines: list[str] = []
        for name in self.arguments[0].split():
            thing, path = getattr(springback, name), f"springback.{springback._PUBLIC[name]}.{name}"
            if name in ABOUT:
                lines += [f".. py:data:: {path}", "", f"   {ABOUT[name]}", ""]
            elif inspect.isclass(thing) or inspect.isroutine(thing):
                lines += members(path, thing) if name in ("Flight", "Campaign") else []
                lines += entry(path, thing)
            else:
                lines += [f".. autodata:: {path}", "   :no-value:", ""]
        box = nodes.container()
        self.state.nested_parse(StringList(lines), 0, box)
        return box.children


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
    """A table of the names of the package in its content."""

    has_content = True

    def run(self) -> list[nodes.Node]:
        """Name and first sentence."""
        lines = [".. list-table::", "   :widths: 25 75", ""]
        for name in " ".join(self.content).split():
            path = f"springback.{springback._PUBLIC[name]}.{name}"
            lines += [f"   * - :py:obj:`{name} <{path}>`", f"     - {said(path)}"]
        box = nodes.container()
        self.state.nested_parse(StringList(lines), 0, box)
        return box.children


def said(path: str) -> str:
    """The first line of what documents a name."""
    module, _, name = path.rpartition(".")
    thing = getattr(importlib.import_module(module), name)
    comment = analysis(module).attr_docs.get(("", name))
    if comment:
        return escaped(" ".join(part for part in comment if part))
    if not (inspect.isclass(thing) or inspect.isroutine(thing)):
        return ABOUT[name]
    return escaped((inspect.getdoc(thing) or "").split("\n\n")[0].replace("\n", " "))


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the directives."""
    app.add_directive("public-names", PublicNames)
    app.add_directive("chapter-module", ChapterModule)
    app.add_directive("public", PublicEntry)
    app.add_directive("internal-modules", InternalModules)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
