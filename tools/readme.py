"""Write the reproduction tables and the figure of README.md from the experiments themselves.

usage: python tools/readme.py
"""

from pathlib import Path
from statistics import mean

from springback.experiments.comparison import Mark
from springback.experiments.paper.flight import (
    QUANTITIES as CIRCLE_QUANTITIES,
)
from springback.experiments.paper.flight import (
    ROBOTS,
    TABLE_IV_CIRCLES,
    TABLE_IV_STEPS,
    FlightResults,
    flight_experiments,
)
from springback.experiments.paper.printed import SUCCESS, SUCCESS_WORDS
from springback.experiments.paper.resilience import ROBOTS as RESILIENT
from springback.experiments.paper.resilience import ResilienceResults, resilience_experiments
from springback.experiments.paper.slider import SliderResults, slider_experiments
from springback.experiments.run_ups import CONDITIONS
from springback.interfaces.canvas import png
from springback.interfaces.plots_slider import readme_figure

README = Path(__file__).parents[1] / "README.md"
FIGURE = README.parent / "docs/figures/slider.png"
BEGIN = "<!-- {name}: written by tools/readme.py -->\n"
END = "<!-- end of {name} -->"
SIGNS = {Mark.FITTED: " *f*", Mark.PREDICTED: " ✓", Mark.CONTRADICTED: " ✗", Mark.GIVEN: ""}
QUANTITIES = {
    "restitution_at_separation": ("restitution", 1.0, ".3f"),
    "impact_peak_acceleration": ("peak acceleration [m/s²]", 1.0, ".1f"),
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


def flight_table(results: FlightResults) -> str:
    """Table IV in Markdown: ours, and in brackets the printed value."""
    lines = ["| | Quad | ARQ | ARQ after drops |", "|---|---|---|---|"]
    for axis in ("x", "y", "z"):
        for k, (label, form) in enumerate((("rise time [s]", ".3f"), ("MSE [m²]", ".3f"))):
            cells = []
            for robot in ROBOTS:
                values = results.step_mse(robot, axis) if k else results.rise(robot, axis)
                cells.append(f"{mean(values):{form}} ({TABLE_IV_STEPS[robot][axis][k]:{form}})")
            lines.append(f"| step in {axis}: {label} | {' | '.join(cells)} |")
    for pace in ("slow", "fast"):
        for k, quantity in enumerate(CIRCLE_QUANTITIES):
            cells = []
            for robot in ROBOTS:
                ours = 1e3 * mean(results.circle_mse(robot, pace, quantity))
                cells.append(f"{ours:.2f} ({1e3 * TABLE_IV_CIRCLES[robot, pace][k]:.2f})")
            name = f"{quantity[0]}_{quantity[1]}"
            lines.append(f"| {pace} circle: MSE of {name} [1e-3] | {' | '.join(cells)} |")
    return "\n".join(lines) + "\n"


def resilience_table(results: ResilienceResults) -> str:
    """Recovered trials in Markdown, with Wilson's intervals, and what is printed."""
    lines = ["| pitch, speed | ARQ | printed | Quad | printed |", "|---|---|---|---|---|"]
    tallies = {(t.robot, t.pitch, t.speed): t for t in results.tallies()}
    for pitch, speed in CONDITIONS:
        cells = []
        for robot in RESILIENT:
            of = (robot, pitch, speed)
            tally, share = tallies[of], SUCCESS.get(of)
            ours = f"{tally.successes} of {tally.trials} ({tally.low:.0%} to {tally.high:.0%})"
            cells += [ours, SUCCESS_WORDS.get(of, "") if share is None else f"{share:.0%}"]
        lines.append(f"| {pitch:g}°, {speed:g} m/s | {' | '.join(cells)} |")
    return "\n".join(lines) + "\n"


def with_table(text: str, name: str, table: str) -> str:
    """README with what stands between a table's marks replaced."""
    begin, end = BEGIN.format(name=name), END.format(name=name)
    before, rest = text.split(begin)
    return before + begin + table + end + rest.split(end)[1]


if __name__ == "__main__":
    results = slider_experiments()
    text = with_table(README.read_text(encoding="utf-8"), "reproduction", table(results))
    text = with_table(text, "flight", flight_table(flight_experiments()))
    text = with_table(text, "resilience", resilience_table(resilience_experiments(repeats=0)))
    README.write_text(text, encoding="utf-8")
    FIGURE.write_bytes(png(readme_figure(results)))
