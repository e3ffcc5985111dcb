"""`.. preset:: arq`: the numbers of a preset with their sources, as `springback show` has them."""

from typing import Any

from docstrings import escaped
from docutils import nodes
from docutils.parsers.rst import Directive
from docutils.statemachine import StringList
from sphinx.application import Sphinx

from springback.contact.library import SOURCES, SURFACES
from springback.vehicle.library import VEHICLES


def shown(value: Any) -> str:
    """A value of a field, briefly."""
    if isinstance(value, float):
        return f"{value:.5g}"
    if isinstance(value, tuple):
        rows = all(isinstance(row, tuple) for row in value)
        diagonal = rows and all(
            value[i][j] == 0.0 for i in range(len(value)) for j in range(len(value)) if i != j
        )
        if diagonal:
            return "diag(" + ", ".join(shown(value[i][i]) for i in range(len(value))) + ")"
        return "(" + ", ".join(shown(part) for part in value) + ")"
    return str(value).lower() if isinstance(value, bool) else str(value)


def rows(name: str) -> list[tuple[str, str, str]]:
    """Field, value and source of everything that a preset says."""
    if name in VEHICLES:
        entry = VEHICLES[name]
        thing, sources = entry.vehicle, entry.sources
    else:
        thing, sources = SURFACES[name], SOURCES[name]
    found = []
    for path, source in sources.items():
        value: Any = thing
        for part in path.split("."):
            value = getattr(value, part)
        value = f"{len(value)} in all" if path == "hulls" else value
        found.append((path, shown(value), source))
    return found


class Preset(Directive):
    """A table of a vehicle or a surface of the library."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """The table."""
        name = self.arguments[0]
        lines = [".. list-table::", "   :header-rows: 1", "   :widths: 25 20 55", ""]
        lines += [f"   * - ``{name}``", "     - SI", "     - source"]
        for path, value, source in rows(name):
            lines += [f"   * - ``{path}``", f"     - {value}", f"     - {escaped(source)}"]
        box = nodes.container()
        self.state.nested_parse(StringList(lines), 0, box)
        return box.children


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the directive."""
    app.add_directive("preset", Preset)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
