"""Write the reproduction table and the figure of README.md from the slider tests themselves.

usage: python tools/readme.py
"""

from pathlib import Path

from springback.experiments.comparison import Mark
from springback.experiments.paper.slider import SliderResults, slider_experiments
from springback.interfaces.canvas import png
from springback.interfaces.plots_slider import readme_figure

README = Path(__file__).parents[1] / "README.md"
FIGURE = README.parent / "docs/figures/slider.png"
BEGIN = "<!-- reproduction: written by tools/readme.py -->\n"
END = "<!-- end of reproduction -->"
SIGNS = {Mark.FITTED: " *f*", Mark.PREDICTED: " ✓", Mark.CONTRADICTED: " ✗", Mark.GIVEN: ""}
QUANTITIES = {
    "restitution_at_separation": ("restitution", 1.0, ".3f"),
    "peak_acceleration": ("peak acceleration [m/s²]", 1.0, ".1f"),
    "travel": ("travel [mm]", 1e3, ".1f"),
    "contact_time": ("contact time [ms]", 1e3, ".1f"),
    "time_to_return": ("time to return [ms]", 1e3, ".1f"),
}


def table(results: SliderResults) -> str:
    """The table in Markdown, with Quad's c_a throughout."""
    rows = {
        (row.robot, row.surface, row.reading, row.quantity): row
        for row in results.rows
        if row.experiment == "Table III" and row.dissipation_from.startswith("Quad")
    }
    readings = ["Quad", "A", "B", "C"]
    lines = [
        "| | printed | printed, test | Quad | ARQ, A | ARQ, B | ARQ, C |",
        "|---|---|---|---|---|---|---|",
    ]
    for robot in ("quad", "arq"):
        for surface in ("wall", "mat"):
            for quantity, (label, scale, form) in QUANTITIES.items():
                cells = []
                for reading in readings:
                    row = rows.get((robot, surface, reading, quantity))
                    cells.append(
                        ""
                        if row is None or row.ours is None
                        else f"{row.ours * scale:{form}}{SIGNS[row.mark]}"
                    )
                found = next(
                    row
                    for key, row in rows.items()
                    if key[0] == robot and key[1] == surface and key[3] == quantity
                )
                test = "" if found.printed_test is None else f"{found.printed_test * scale:{form}}"
                printed = f"{(found.printed or 0.0) * scale:{form}}"
                name = "Quad" if robot == "quad" else "ARQ"
                lines.append(
                    f"| {name}, {surface}: {label} | {printed} | {test} | {' | '.join(cells)} |"
                )
    return "\n".join(lines) + "\n"


def between(text: str) -> tuple[str, str, str]:
    """README before, within and after the table's marks."""
    before, rest = text.split(BEGIN)
    within, after = rest.split(END)
    return before + BEGIN, within, END + after


if __name__ == "__main__":
    results = slider_experiments()
    before, _, after = between(README.read_text(encoding="utf-8"))
    README.write_text(before + table(results) + after, encoding="utf-8")
    FIGURE.write_bytes(png(readme_figure(results)))
