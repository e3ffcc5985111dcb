"""Convert this project's docstrings to reStructuredText.

Fields of a NamedTuple are documented by the comments beside them, indented lines are kept as they
are, and a name in single backticks is a link where it has a page and code where it has none; a name
that does not exist is an error.
"""

import builtins
import importlib
import inspect
import io
import re
import tokenize
from collections import defaultdict
from functools import cache
from types import NoneType
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.nodes import make_refnode

import springback

ALIAS = re.compile(r"Alias for field number \d+")
SECTION = re.compile(r"(Args|Returns|Raises|Yields|Attributes|Example|Note):$")
RAISED = re.compile(r"    \w+: ")
CODE = re.compile(r"(``.+?``|`.+?`)")


@cache
def comments(cls: type) -> dict[str, str]:
    """Comments beside the fields of a class."""
    source, _ = inspect.getsourcelines(cls)
    tokens = tokenize.generate_tokens(io.StringIO("".join(source)).readline)
    beside = {t.start[0]: t.string for t in tokens if t.type == tokenize.COMMENT}
    found = {}
    for number, line in enumerate(source, start=1):
        field = re.match(r"    (\w+):", line)
        if field and number in beside:
            found[field[1]] = beside[number].removeprefix("#").strip()
    return found


def escaped(line: str) -> str:
    """A line whose bars, stars and trailing underscores mean themselves."""
    parts = CODE.split(line)
    for k in range(0, len(parts), 2):
        parts[k] = re.sub(r"(?<=\w)_(?![\w`])", r"\\_", parts[k].replace("|", r"\|"))
        parts[k] = re.sub(r"\*", r"\\*", parts[k])
    return "".join(parts)


def kept(lines: list[str]) -> list[str]:
    """The lines with indented blocks of the free text marked as such, and the rest escaped."""
    made: list[str] = []
    in_section = in_block = unnamed = returns = False
    for k, line in enumerate(lines):
        indented = line.startswith("    ")
        if line and not indented:
            in_section, in_block = bool(SECTION.match(line)), False
            returns = line == "Returns:"
            if line == "Raises:" and not RAISED.match(lines[k + 1] if k + 1 < len(lines) else ""):
                made += ["**Raises.**"]
                in_section = unnamed = True
                continue
            unnamed = False
        begins = indented and not in_section and not in_block and k > 0 and not lines[k - 1]
        if begins:
            in_block = True
            before = next((text for text in reversed(made) if text), "")
            if not before.endswith("::"):
                made += ["::", ""]
        if unnamed:
            line = line.strip()
        if (
            in_section
            and not returns
            and re.match(r"    \w", line)
            and not re.match(r"    [\w*]+: ", line)
        ):
            line = f"    {line}"  # goes on from the line before
        made.append(line if in_block and indented else escaped(line))
    return made


#: Lines of attributes, kept from napoleon, which takes words before a colon for a type.
_aside: list[str] = []


def processed(
    app: Sphinx, what: str, name: str, thing: Any, options: Any, lines: list[str]
) -> None:
    """Replace a docstring's lines."""
    if len(lines) >= 1 and ALIAS.fullmatch(lines[0]):
        owner, _, field = name.rpartition(".")
        lines[:] = [escaped(comments(found(owner)).get(field, ""))]
    else:
        lines[:] = kept(lines)
    if what in ("attribute", "data", "property"):
        _aside[:] = lines
        lines[:] = [""]


def put_back(app: Sphinx, what: str, name: str, thing: Any, options: Any, lines: list[str]) -> None:
    """After napoleon."""
    if what in ("attribute", "data", "property"):
        lines[:] = _aside


def found(path: str) -> Any:
    """What a dotted path names, `NoneType` if that is None; None if it names nothing."""
    parts = path.strip(".").split(".")
    if not parts[0]:
        return None
    for k in range(len(parts), 0, -1):
        try:
            thing = importlib.import_module(".".join(parts[:k]))
        except ImportError:
            continue
        for part in parts[k:]:
            fields = getattr(thing, "model_fields", {})
            annotated = getattr(thing, "__annotations__", {})
            if part in fields or part in annotated:
                thing = getattr(thing, part, fields)
            elif hasattr(thing, part):
                thing = getattr(thing, part)
            else:
                return None
        return NoneType if thing is None else thing
    return None


def exists(target: str, module: str, owner: str) -> bool:
    """Whether a name means something where it is written."""
    if hasattr(builtins, target) or target in words():
        return True
    places = [f"{module}.{owner}.", f"{module}.", "springback.", ""]
    return any(found(place + target) is not None for place in places)


@cache
def words() -> set[str]:
    """Words that settings take: ``ring``, ``kalman``, ``arq`` ..."""
    from settings_tables import choices

    from springback.contact.library import SURFACES
    from springback.scenario.scenario import Scenario
    from springback.vehicle.library import VEHICLES

    return {*VEHICLES, *SURFACES, *choices(Scenario)}


@cache
def ending(domain: Any, count: int) -> dict[str, list[str]]:
    """All documented names by their last part; ``count`` of them."""
    known: dict[str, list[str]] = defaultdict(list)
    for path in domain.objects:
        known[path.rpartition(".")[2]].append(path)
    return known


def also_at(target: str) -> list[str]:
    """Full path of a public name, and of the settings that a field belongs to."""
    first, _, rest = target.removeprefix("springback.").partition(".")
    chapter = springback._PUBLIC.get(first)
    path = f"springback.{chapter}.{first}" + (f".{rest}" if rest else "") if chapter else target
    owner, _, field = path.rpartition(".")
    is_key = field in getattr(found(owner), "model_fields", {})
    return [path, owner] if is_key else [path]


def resolved(app: Sphinx, env: Any, node: Any, content: nodes.Node) -> nodes.Node | None:
    """A link to the only thing of that name, else code; what does not exist stays an error."""
    if node.get("refdomain") != "py":
        return None
    target = node["reftarget"]
    domain = env.domains.python_domain
    for path in also_at(target):
        if path in domain.objects:
            known = domain.objects[path]
            return make_refnode(app.builder, node["refdoc"], known.docname, known.node_id, content)
    last = target.rpartition(".")[2]
    named = [p for p in ending(domain, len(domain.objects))[last] if p.endswith(f".{target}")]
    if len(named) == 1:
        known = domain.objects[named[0]]
        return make_refnode(app.builder, node["refdoc"], known.docname, known.node_id, content)
    module, owner = node.get("py:module") or "", node.get("py:class") or ""
    if named or not re.fullmatch(r"[\w.-]+", target) or exists(target, module, owner):
        return nodes.literal("", "", nodes.Text(content.astext()))
    return None


def setup(app: Sphinx) -> dict[str, Any]:
    """Listen to autodoc."""
    app.connect("autodoc-process-docstring", processed, priority=400)
    app.connect("autodoc-process-docstring", put_back, priority=600)
    app.connect("missing-reference", resolved)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
