"""Write the tables and figures of README.md and of docs/paper from the experiments.

usage: python tools/readme.py [--choices FOLDER] [--only slider|flight|choices]

``--choices`` takes the hundred trials of each condition from a folder that `springback study
choices` wrote, instead of flying them again.
"""

import argparse
import json
from pathlib import Path
from statistics import mean

from springback.interfaces.figures.style import png
from springback.interfaces.output.robots import robot_label
from springback.interfaces.reproduction.figures.slider import readme_figure
from springback.paper.choices import (
    BOTH,
    CHOICES,
    EKF2,
    MEDIANS,
    OURS,
    VERTICAL,
    ChoiceResults,
    ConditionOutcome,
    fly_choices,
)
from springback.paper.choices import ROBOTS as RESILIENT
from springback.paper.free_flight import (
    QUANTITIES as CIRCLE_QUANTITIES,
)
from springback.paper.free_flight import (
    ROBOTS,
    TABLE_IV_CIRCLES,
    TABLE_IV_STEPS,
    FlightResults,
    flight_experiments,
)
from springback.paper.printed import SUCCESS, SUCCESS_WORDS
from springback.paper.slider import READINGS, SliderResults, slider_experiments
from springback.studies.comparison import Mark, Row
from springback.studies.run_ups import CONDITIONS
from springback.studies.trials import DURATION

README = Path(__file__).parents[1] / "README.md"
PAGE = README.parent / "docs/paper/reproduction.md"
CHOICES_PAGE = PAGE.with_name("choices.md")
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
    readings = ["Quad", *(reading.name for reading in READINGS)]
    lines = [
        f"| | printed | printed, test | Quad | ARQ: {' | '.join(readings[1:])} |",
        "|---" * (3 + len(readings)) + "|",
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
                test = ""
                if found.printed_test is not None and found.scatter is not None:
                    test = f"{found.printed_test * scale:{form}} ({found.scatter:+.0%})"
                printed = f"{(found.printed or 0.0) * scale:{form}}"
                name = "Quad" if robot == "quad" else "ARQ"
                lines.append(
                    f"| {name}, {surface}: {label} | {printed} | {test} | {' | '.join(cells)} |"
                )
    for share in (0.05, 0.10):
        cells = []
        for reading in READINGS:
            rows_of = results.unique_rows(reading.name)
            near = sum(abs(row.deviation or 0.0) <= share for row in rows_of)
            fitted = sum(row.mark is Mark.FITTED for row in rows_of)
            cells.append(f"{near} of {len(rows_of)}" + (f", {fitted} *f*" if fitted else ""))
        lines.append(f"| ARQ's eight numbers within {share:.0%} | | | | {' | '.join(cells)} |")
    gaps = {
        row.reading: row for row in reversed(results.rows)
        if row.experiment == "Sweep"
    }  # fmt: skip
    shown = (
        f"{gaps[reading.name].ours or 0.0:.0f}{SIGNS[gaps[reading.name].mark]}"
        for reading in READINGS
    )
    lines.append(
        f"| Quad less ARQ, peak at 6 m/s [m/s²] | {found_gap(gaps)} | | | {' | '.join(shown)} |"
    )
    return "\n".join(lines) + "\n"


def headline(table: str) -> str:
    """The rows of both robots on the wall, with the readings B and D of ARQ, for README.md."""
    lines = [
        "| slider, wall, 1.85 m/s | printed | Quad | ARQ, B (default) | ARQ, D |",
        "|---|---|---|---|---|",
    ]
    columns = [name.strip().removeprefix("ARQ: ") for name in table.split("\n")[0].split("|")[1:-1]]
    shown = [columns.index(name) for name in ("", "printed", "Quad", "B", "D")]
    for line in table.splitlines():
        cells = [cell.strip() for cell in line.split("|")[1:-1]]
        if ", wall: " in cells[0]:
            lines.append(f"| {' | '.join(cells[k] for k in shown)} |")
    return "\n".join(lines).replace(", wall: ", ": ") + "\n"


def found_gap(gaps: dict[str, Row]) -> str:
    """The printed gap of the sweep."""
    return f"{next(iter(gaps.values())).printed:.0f}"


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


def _percent(cell: ConditionOutcome) -> str:
    low, high = cell.interval
    return f"{cell.share:.0%} ({low:.0%} to {high:.0%})"


def _printed(robot: str, pitch: float, speed: float) -> str:
    of = (robot, pitch, speed)
    return f"{SUCCESS[of]:.0%}" if of in SUCCESS else SUCCESS_WORDS[of]


def resilience_table(results: ChoiceResults) -> str:
    """Recovered trials with the paper's friction and both estimators, and what is printed."""
    lines = [
        "| pitch, speed | ARQ, printed | ARQ | ARQ, EKF2 | Quad, printed | Quad | Quad, EKF2 |",
        "|---" * 7 + "|",
    ]
    tables = [results.table(choice, DURATION) for choice in CHOICES if choice.friction == VERTICAL]
    for pitch, speed in CONDITIONS:
        cells = []
        for robot in RESILIENT:
            cells.append(_printed(robot, pitch, speed))
            cells += [_percent(table[robot, pitch, speed]) for table in tables]
        lines.append(f"| {pitch:g}°, {speed:g} m/s | {' | '.join(cells)} |")
    return "\n".join(lines) + "\n"


def agreement_table(results: ChoiceResults) -> str:
    """How much of the printed table each set of choices gives, and what it makes of 3.5 m/s."""
    lines = [
        "| friction | estimator | time of a trial | ARQ, 3.5 m/s | Quad, 3.5 m/s | shares within 5 "
        "points | compatible shares | phrases | together |",
        "|---" * 9 + "|",
    ]
    for choice, duration in results.combinations:
        one, table = results.agreement(choice, duration), results.table(choice, duration)
        fast = (f"{table[robot, 0.0, 3.5].successes}" for robot in RESILIENT)
        lines.append(
            f"| {choice.friction.removeprefix('friction ')} | {choice.estimator} | {duration:g} s "
            f"| {' | '.join(fast)} | {one.close} of {one.numbers} | {one.plausible} of "
            f"{one.numbers} | {one.words} of {one.phrases} | {one.total} of "
            f"{one.numbers + one.phrases} |"
        )
    return "\n".join(lines) + "\n"


def fate_table(results: ChoiceResults, friction: str, estimator: str) -> str:
    """Every condition under a friction and an estimator: outcomes, height, distance, time."""
    (choice,) = [c for c in CHOICES if (c.friction, c.estimator) == (friction, estimator)]
    durations = [duration for one, duration in results.combinations if one == choice]
    heads = " | ".join(f"{duration:g} s" for duration in durations)
    lines = [
        f"| robot, pitch, speed | recovered: {heads} | at {durations[-1]:g} s: not settled | hit "
        "the ground | not noticed | height lost [m] | farthest [m] | time to rest [s] | stroke "
        "[mm] | peak [m/s²] |",
        "|---" * (9 + len(durations)) + "|",
    ]
    for robot in RESILIENT:
        for pitch, speed in CONDITIONS:
            cells = [results.table(choice, d)[robot, pitch, speed] for d in durations]
            last = cells[-1]
            ends = (last.outcomes.get(w, 0) for w in ("not_settled", "hit_ground", "not_detected"))
            scales = {"impact_arm_stroke": 1e3}
            forms = {"impact_arm_stroke": ".1f", "impact_peak_acceleration": ".0f"}
            shown = []
            for name in MEDIANS:
                if name != "lowest_height":
                    value = last.medians.get(name)
                    scaled = None if value is None else scales.get(name, 1.0) * value
                    shown.append("–" if scaled is None else f"{scaled:{forms.get(name, '.2f')}}")
            words = [*(str(c.successes) for c in cells), *map(str, ends), *shown]
            name = f"{robot_label(robot)}, {pitch:g}°, {speed:g} m/s"
            lines.append(f"| {name} | {' | '.join(words)} |")
    return "\n".join(lines) + "\n"


def read_choices(folder: Path) -> ChoiceResults:
    """The results that `springback study choices` left in a folder."""
    data = json.loads((folder / "choices.json").read_text(encoding="utf-8"))
    known = {(choice.friction, choice.estimator): choice for choice in CHOICES}
    results = ChoiceResults(data["trials"], data["seed"])
    for row in data["cells"]:
        outcomes = {
            key.removeprefix("ended_"): value for key, value in row.items()
            if key.startswith("ended_") and value
        }  # fmt: skip
        medians = {name: row[f"median_{name}"] for name in MEDIANS}
        results.cells.append(
            ConditionOutcome(
                row["robot"], row["pitch_deg"], row["speed"], row["trials"], row["successes"],
                outcomes, medians, known[row["friction"], row["estimator"]], row["duration"],
            )
        )  # fmt: skip
    return results


def with_table(text: str, name: str, table: str) -> str:
    """A page with the text between a table's marks replaced."""
    begin, end = BEGIN.format(name=name), END.format(name=name)
    before, rest = text.split(begin)
    return before + begin + table + end + rest.split(end)[1]


def main() -> None:
    """Write what is asked for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--choices", type=Path, help="a folder of `springback study choices`")
    parser.add_argument("--only", choices=("slider", "flight", "choices"), help="one part")
    asked = parser.parse_args()
    text = PAGE.read_text(encoding="utf-8")
    if asked.only in (None, "slider"):
        results = slider_experiments()
        slider = table(results)
        text = with_table(text, "reproduction", slider)
        front = README.read_text(encoding="utf-8")
        README.write_text(with_table(front, "headline", headline(slider)), encoding="utf-8")
        FIGURE.write_bytes(png(readme_figure(results)))
    if asked.only in (None, "flight"):
        text = with_table(text, "flight", flight_table(flight_experiments()))
    if asked.only in (None, "choices"):
        chosen = read_choices(asked.choices) if asked.choices else fly_choices()
        text = with_table(text, "resilience", resilience_table(chosen))
        page = CHOICES_PAGE.read_text(encoding="utf-8")
        page = with_table(page, "agreement", agreement_table(chosen))
        for friction in (VERTICAL, BOTH):
            for estimator in (OURS, EKF2):
                name = f"{friction}, {estimator}"
                page = with_table(page, name, fate_table(chosen, friction, estimator))
        CHOICES_PAGE.write_text(page, encoding="utf-8")
    PAGE.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
