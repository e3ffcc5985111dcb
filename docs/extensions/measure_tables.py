"""`.. measures::`, `.. outcomes::`: names, units and meanings as the code has them."""

from typing import Any

from docstrings import escaped
from docutils import nodes
from docutils.parsers.rst import Directive
from docutils.statemachine import StringList
from sphinx.application import Sphinx

from springback.results.recovery_measures import RECOVERY_MEASURES
from springback.simulation.measuring.measures import MEASURES, Outcome


def table(head: list[str], widths: str, rows: list[list[str]]) -> list[str]:
    """Lines of a table."""
    lines = [".. list-table::", "   :header-rows: 1", f"   :widths: {widths}", ""]
    for row in [head, *rows]:
        lines += [("   * - " if k == 0 else "     - ") + cell for k, cell in enumerate(row)]
    return lines


class Measures(Directive):
    """All measures of a flight, or those of a recovery."""

    optional_arguments = 1

    def run(self) -> list[nodes.Node]:
        """The table."""
        known = RECOVERY_MEASURES if self.arguments else MEASURES
        rows = [[f"``{name}``", unit, escaped(what)] for name, (unit, what) in known.items()]
        box = nodes.container()
        lines = table(["measure", "unit", "what"], "35 15 50", rows)
        self.state.nested_parse(StringList(lines), 0, box)
        return box.children


class Outcomes(Directive):
    """All outcomes."""

    def run(self) -> list[nodes.Node]:
        """The table."""
        rows = [[f"``{one.word}``", one.value] for one in Outcome]
        box = nodes.container()
        self.state.nested_parse(StringList(table(["outcome", "what"], "30 70", rows)), 0, box)
        return box.children


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the directives."""
    app.add_directive("measures", Measures)
    app.add_directive("outcomes", Outcomes)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
