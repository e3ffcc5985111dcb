"""The reproduction report: one page that needs nothing else, its figures, and the numbers as data.

The page is made of sections, a section of blocks: paragraphs, tables, pictures.  One template lays
them out.  Every sentence with a number is generated from the results, none is typed.
"""

from __future__ import annotations

import base64
import csv
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup, escape
from matplotlib.figure import Figure

from springback.experiments.comparison import AGREEMENT, Mark, Row
from springback.experiments.paper.printed import PAPER, SLIDER_SPEED, SWEEP_GAP, SWEEP_SPEEDS
from springback.experiments.paper.slider import Case, SliderResults
from springback.interfaces import plots
from springback.interfaces.files import write_json
from springback.simulation.measures import MEASURES

# -- what a page is made of -----------------------------------------------------------------------


@dataclass(frozen=True)
class Cell:
    """A cell of a table: a text, and, if it is a number of ours or the paper's, the number."""

    text: str
    value: float | None = None
    detail: str = ""
    mark: Mark | None = None


@dataclass(frozen=True)
class Table:
    """A table; the first cell of a row names the row."""

    caption: str
    head: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]
    folded: bool = False
    """Shown only when asked for, being long."""


@dataclass(frozen=True)
class Picture:
    """A figure within the page."""

    name: str
    text: str
    figure: Figure

    @property
    def source(self) -> str:
        """The PNG file as a data URI."""
        return "data:image/png;base64," + base64.b64encode(plots.png(self.figure)).decode("ascii")

    @property
    def width(self) -> int:
        """Width on the page [CSS pixels]."""
        return round(125 * self.figure.get_figwidth())

    @property
    def height(self) -> int:
        """Height on the page [CSS pixels]."""
        return round(125 * self.figure.get_figheight())


@dataclass(frozen=True)
class Section:
    """A part of the page: paragraphs (plain text), tables and pictures in their order."""

    anchor: str
    title: str
    blocks: tuple[str | Table | Picture, ...]


class Quantity(NamedTuple):
    """How a compared quantity is shown: its scale takes SI to the unit shown."""

    name: str
    unit: str = ""
    scale: float = 1.0
    decimals: int = 3


QUANTITIES = {
    "restitution_at_separation": Quantity("COR when the cage leaves"),
    "restitution_at_return": Quantity("COR when the body is back"),
    "restitution_of_mass_centre": Quantity("COR of the centre of mass"),
    "peak_acceleration": Quantity("peak acceleration", "m/s²", 1.0, 1),
    "travel": Quantity("travel", "mm", 1e3, 1),
    "contact_time": Quantity("contact time until the cage leaves", "ms", 1e3, 1),
    "time_to_return": Quantity("contact time until the body is back", "ms", 1e3, 1),
}
PRINTED = {
    "COR": ("restitution_at_separation", "restitution_at_return", "restitution_of_mass_centre"),
    "peak acceleration": ("peak_acceleration",),
    "travel": ("travel",),
    "contact time": ("contact_time", "time_to_return"),
}
"""The four printed numbers of a test, and what of ours each may be compared with."""


def write_report(results: SliderResults, folder: Path, *, about: Mapping[str, Any]) -> list[Path]:
    """Write ``report.html``, ``figures/``, ``comparison.json``, ``comparison.csv``, ``sweep.csv``.

    The same results and ``about`` give the same files, byte for byte.

    Args:
        results: The slider tests.
        folder: Made if it is not there.
        about: What the results were made with, by name: versions of programs.

    Returns:
        The files written.
    """
    folder.mkdir(parents=True, exist_ok=True)
    sections = slider_sections(results, about)
    files = [folder / name for name in ("report.html", "comparison.json", "comparison.csv")]
    files[0].write_text(page("The slider tests", sections), encoding="utf-8")
    write_json(files[1], _data(results, about))
    _write_csv(files[2], [row.as_dict() for row in results.rows])
    if results.sweep:
        files.append(folder / "sweep.csv")
        points = [
            {
                "reading": p.reading, "speed_m_per_s": p.speed, "quad_m_per_s2": p.quad,
                "arq_m_per_s2": p.arq, "gap_m_per_s2": p.gap,
            }
            for p in results.sweep
        ]  # fmt: skip
        _write_csv(files[-1], points)
    for section in sections:
        for block in section.blocks:
            if isinstance(block, Picture):
                files += plots.save(block.figure, folder / "figures" / block.name)
    return files


def page(title: str, sections: Sequence[Section]) -> str:
    """The HTML page of some sections; it refers to nothing outside itself."""
    environment = Environment(
        loader=PackageLoader("springback.interfaces"), autoescape=True, undefined=StrictUndefined,
        trim_blocks=True, lstrip_blocks=True, keep_trailing_newline=True,
    )  # fmt: skip
    environment.filters["symbols"] = _symbols
    template = environment.get_template("report.html.j2")
    return template.render(title=title, paper=PAPER, sections=sections)


def _symbols(text: str) -> Markup:
    """Text, escaped, with the symbols of the paper set as such."""
    known = r"\b([acklmb])_(a|c|l|b|max)\b"
    return Markup(re.sub(known, r"<var>\1<sub>\2</sub></var>", str(escape(text))))


def _data(results: SliderResults, about: Mapping[str, Any]) -> dict[str, Any]:
    """All results as plain data."""
    return {
        "about": dict(about),
        "paper": PAPER,
        "agreement": AGREEMENT,
        "readings": [
            {
                "name": r.name, "text": r.text, "vehicle": r.vehicle, "shared_by": r.shared_by,
                "overrides": list(r.overrides),
            }
            for r in results.readings
        ],
        "rows": [row.as_dict() for row in results.rows],
        "sweep": [
            {"reading": p.reading, "speed": p.speed, "quad": p.quad, "arq": p.arq, "gap": p.gap}
            for p in results.sweep
        ],
        "cases": [
            {
                "robot": c.robot, "surface": c.surface, "reading": c.reading.name,
                "dissipation": c.dissipation, "dissipation_from": c.dissipation_from,
                "outcome": c.flight.outcome.word, "measures": c.flight.measures,
            }
            for c in results.cases
        ],
        "units": {name: unit for name, (unit, _) in MEASURES.items()},
    }  # fmt: skip


def _write_csv(path: Path, rows: Sequence[Mapping[str, Any]]) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]) if rows else [], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


# -- numbers and words ----------------------------------------------------------------------------


def _number(value: float | None, decimals: int) -> str:
    return "–" if value is None else f"{value:.{decimals}f}".replace("-", "−")


def _percent(share: float | None) -> str:
    return "" if share is None else f"{100.0 * share + 0.0:+.1f} %".replace("-", "−")


def _plain(value: float) -> str:
    """A given or printed number as people write it: no more digits than it has."""
    return f"{value:,.6g}".replace(",", " ") if abs(value) < 1e6 else f"{value:.4g}"


def _listed(words: Iterable[str]) -> str:
    """``a, b and c``."""
    *most, last = [*words] or ["none"]
    return f"{', '.join(most)} and {last}" if most else last


def _shown(row: Row, value: float | None) -> str:
    """A number of a row with its unit, for a sentence."""
    quantity = QUANTITIES.get(row.quantity, Quantity("", row.unit))
    number = None if value is None else value * quantity.scale
    return f"{_number(number, quantity.decimals)} {quantity.unit}".rstrip()


def _printed(row: Row, value: float | None) -> Cell:
    """A printed number in the unit of its table."""
    scale = QUANTITIES[row.quantity].scale if row.quantity in QUANTITIES else 1.0
    return Cell("–") if value is None else Cell(_plain(value * scale), value)


def _ours(row: Row | None) -> Cell:
    """A number of ours, with its deviation and mark."""
    if row is None:
        return Cell("–")
    quantity = QUANTITIES.get(row.quantity, Quantity(row.quantity, row.unit, 1.0, 1))
    number = None if row.ours is None else row.ours * quantity.scale
    return Cell(_number(number, quantity.decimals), row.ours, _percent(row.deviation), row.mark)


Runs = dict[tuple[str, str, str], list[dict[str, Row]]]
"""Rows of Table III by robot, surface and reading: one dictionary by quantity for each c_a, the
first of which is Quad's."""


def _runs(results: SliderResults) -> Runs:
    found: dict[tuple[str, str, str], dict[str, dict[str, Row]]] = {}
    for row in results.rows:
        if row.experiment == "Table III":
            runs = found.setdefault((row.robot, row.surface, row.reading), {})
            runs.setdefault(row.dissipation_from, {})[row.quantity] = row
    return {key: list(runs.values()) for key, runs in found.items()}


def _agrees(run: Mapping[str, Row], number: str) -> bool:
    """Whether a printed number comes out, in any of its definitions."""
    rows = [run[q] for q in PRINTED[number] if q in run]
    return any(row.mark is not Mark.CONTRADICTED for row in rows)


def _giving(runs: Runs, results: SliderResults, surface: str, number: str) -> list[str]:
    """The readings of ARQ that give a printed number with Quad's c_a."""
    return [
        r.name
        for r in results.readings
        if (own := runs.get(("arq", surface, r.name))) and _agrees(own[0], number)
    ]


# -- the sections ---------------------------------------------------------------------------------


def slider_sections(results: SliderResults, about: Mapping[str, Any]) -> list[Section]:
    """The page of the slider tests, section by section."""
    runs = _runs(results)
    return [
        _answer(results, runs),
        _table_iii(results, runs),
        _over_time(results),
        _disagreement(results, runs),
        _speed_sweep(results),
        _energy(results),
        _method(results),
        _given(results),
        _everything(results, about),
    ]


def _answer(results: SliderResults, runs: Runs) -> Section:
    asked = (
        f"The paper lets two robots slide into a wall and a mat at about {_plain(SLIDER_SPEED)} m/s: "
        "Quad, which is rigid, and ARQ, whose arms give way. It prints restitution (COR), peak "
        "acceleration, travel and contact time. Does its model give these numbers from its printed "
        "parameters, when the contact damping c_a, which it does not print, is fitted to Quad's "
        "COR and to nothing else?"
    )
    answers = [
        sentence for surface in plots.SURFACES for sentence in _quad_sentences(runs, surface)
    ] + _arq_sentences(results, runs)
    blocks: list[str | Table | Picture] = [asked, " ".join(answers)]
    if results.cases:
        blocks.append(
            Picture(
                "answer",
                "Velocity and acceleration of the main body in a collision with the wall, computed.",
                plots.readme_figure(results),
            )
        )
    blocks.append(_tally(results))
    return Section("answer", "Question and answer", tuple(blocks))


def _quad_sentences(runs: Runs, surface: str) -> list[str]:
    run = next(iter(runs.get(("quad", surface, "Quad"), [])), None)
    if run is None:
        return []
    free = {n: run[PRINTED[n][0]] for n in PRINTED if n != "COR" and PRINTED[n][0] in run}
    off = [n for n in free if not _agrees(run, n)]
    numbers = _listed(
        f"{n} {_shown(row, row.ours)} (printed {_shown(row, row.printed)})"
        for n, row in free.items()
    )
    c_a = next(iter(run.values())).dissipation
    verdict = (
        "all agree"
        if not off
        else f"all but {_listed(off)} agree"
        if len(off) < len(free)
        else "none agrees"
    )
    return [f"Quad on the {surface}, with c_a = {_number(c_a, 3)} s/m: {numbers}; {verdict}."]


def _arq_sentences(results: SliderResults, runs: Runs) -> list[str]:
    sentences = []
    complete = [
        f"{r.name} on the {surface}"
        for r in results.readings
        for surface in plots.SURFACES
        if all(r.name in _giving(runs, results, surface, number) for number in PRINTED)
    ]
    if any(robot == "arq" for robot, _, _ in runs):
        sentences.append(
            f"All {len(PRINTED)} numbers of ARQ at once come out for reading {_listed(complete)}."
            if complete
            else f"For ARQ, none of the {len(results.readings)} readings of its parameters gives "
            f"all {len(PRINTED)} printed numbers at once, on either surface."
        )
    gaps = _gap_rows(results)
    if gaps:
        listed = _listed(f"{r.reading} {_number(r.ours, 0)} m/s²" for r in gaps)
        sentences.append(
            f"The difference of the peak accelerations at {_plain(SWEEP_SPEEDS[-1])} m/s, printed as "
            f"{_plain(SWEEP_GAP)} m/s², comes out as {listed}."
        )
    return sentences


def _gap_rows(results: SliderResults) -> list[Row]:
    """The predicted gap of every reading."""
    first: dict[str, Row] = {}
    for row in results.rows:
        if row.experiment == "Sweep":
            first.setdefault(row.reading, row)
    return list(first.values())


def _tally(results: SliderResults) -> Table:
    rows = []
    for mark in Mark:
        count = sum(row.mark is mark for row in results.rows)
        rows.append((Cell(mark.word, mark=mark), Cell(str(count), float(count)), Cell(mark.value)))
    return Table(
        f"What the marks mean, and how many of the {len(results.rows)} compared numbers have each",
        ("mark", "numbers", "meaning"), tuple(rows),
    )  # fmt: skip


def _table_iii(results: SliderResults, runs: Runs) -> Section:
    blocks: list[str | Table | Picture] = [
        "Each cell of ours shows the number, its deviation from the printed simulation, and its "
        "mark. A printed COR and contact time can be read in more than one way, so each way has "
        "its row. c_a is that of Quad throughout: for ARQ everything is predicted."
    ]
    blocks += [
        _comparison(runs, "quad", surface, {"Quad": "Quad"}, 0)
        for surface in plots.SURFACES
        if ("quad", surface, "Quad") in runs
    ]
    names = {r.name: f"ARQ, {r.name}" for r in results.readings}
    present = [s for s in plots.SURFACES if any(key[:2] == ("arq", s) for key in runs)]
    blocks += [_comparison(runs, "arq", surface, names, 0) for surface in present]
    if present:
        blocks.append(
            "The same with c_a fitted to ARQ's own COR instead, for every reading by itself: what "
            "it would take, and what it does to the other numbers."
        )
        blocks += [_comparison(runs, "arq", surface, names, 1) for surface in present]
    return Section("table", "The paper's Table III, side by side", tuple(blocks))


def _comparison(
    runs: Runs, robot: str, surface: str, names: Mapping[str, str], which: int
) -> Table:
    """A table of one robot and surface, a column for each reading."""
    chosen = {}
    for name in names:
        own = runs.get((robot, surface, name), [])
        chosen[name] = own[which] if which < len(own) else {}
    rows = [
        (Cell("c_a [s/m]"), Cell("–"), Cell("–"), *(_dissipation(run) for run in chosen.values()))
    ]
    for key, quantity in QUANTITIES.items():
        row = next(
            (
                run[key]
                for own in chosen
                for run in runs.get((robot, surface, own), [])
                if key in run
            ),
            None,
        )
        if row is None:
            continue
        label = f"{quantity.name} [{quantity.unit}]" if quantity.unit else quantity.name
        printed = (_printed(row, row.printed), _printed(row, row.printed_test))
        rows.append((Cell(label), *printed, *(_ours(run.get(key)) for run in chosen.values())))
    source = "Quad's c_a" if not which else "c_a from ARQ's own COR"
    return Table(
        f"{plots.ROBOTS[robot]} on the {surface}" + (f", {source}" if robot == "arq" else ""),
        ("", "printed, simulation", "printed, test", *(names[name] for name in chosen)),
        tuple(rows),
    )


def _dissipation(run: Mapping[str, Row]) -> Cell:
    row = next(iter(run.values()), None)
    if row is None:
        return Cell("–", detail="no c_a gives this COR")
    return Cell(_number(row.dissipation, 3), row.dissipation, f"from {row.dissipation_from}")


def _over_time(results: SliderResults) -> Section:
    robots = [r for r in plots.ROBOTS if any(case.robot == r for case in results.cases)]
    pictures = [
        Picture(
            f"slider_{robot}",
            f"{plots.ROBOTS[robot]} hits wall and mat, in the manner of the paper's figure. Position is "
            "that of the main body past its place at first touch.",
            plots.slider_figure(results, robot),
        )
        for robot in robots
    ]
    return Section("time", "Over time", tuple(pictures))


def _disagreement(results: SliderResults, runs: Runs) -> Section:
    head = ("printed number of ARQ", *(f"given on the {s} by" for s in plots.SURFACES))
    rows = [
        (Cell(number), *(Cell(_listed(_giving(runs, results, s, number))) for s in plots.SURFACES))
        for number in PRINTED
    ]
    if gaps := _gap_rows(results):
        good = [row.reading for row in gaps if row.mark is not Mark.CONTRADICTED]
        rows.append((Cell("gap of the speed sweep"), Cell(_listed(good)), Cell("–")))
    return Section(
        "disagreement",
        "What does not agree, and why",
        (
            "The printed parameters of ARQ can be read in more than one way. Each reading gives "
            "some of its printed numbers, to within "
            f"{100 * AGREEMENT:.0f} % and in any definition, with Quad's c_a:",
            Table("Who gives what", head, tuple(rows)),
            Picture(
                "readings",
                "Every reading against the four printed numbers of ARQ. Filled: when the cage "
                "leaves. Open: when the main body is back where it was at first touch.",
                plots.readings_figure(results),
            ),
            "Why they pull apart: an arm that slides along its own direction, oblique to the wall, "
            "yields only to the part of the contact force along it; the rest reaches the main body "
            "at once, and that is what sets a high peak acceleration. One spring in series along X "
            "passes nothing on directly, so the body travels further, stops more softly and stays "
            "longer. Peak acceleration asks for the first picture, travel and contact time for the "
            "second.",
            "c_a would also have to differ from number to number. If it were one property of the "
            "surface, the entries of a row of this table would be equal:",
            _wanted_dissipation(results, runs),
        ),
    )


def _wanted_dissipation(results: SliderResults, runs: Runs) -> Table:
    def wanted(run: Mapping[str, Row] | None) -> Cell:
        row = next(iter((run or {}).values()), None)
        return (
            Cell("none does") if row is None else Cell(_number(row.dissipation, 3), row.dissipation)
        )

    names, rows = [r.name for r in results.readings], []
    for surface in plots.SURFACES:
        own = [runs.get(("arq", surface, name), []) for name in names]
        quad = next(iter(runs.get(("quad", surface, "Quad"), [])), None)
        rows.append(
            (
                Cell(f"COR on the {surface}"),
                wanted(quad),
                *(wanted(next(iter(r[1:]), None)) for r in own),
            )
        )
    fitted = {
        r.reading: r for r in results.rows if r.experiment == "Sweep" and r.mark is Mark.FITTED
    }
    gap = [wanted({"gap": fitted[n]} if n in fitted else None) for n in names]
    rows.append((Cell("gap of the sweep, wall"), Cell("–"), *gap))
    head = ("c_a [s/m] that gives the printed", "Quad", *(f"ARQ, {name}" for name in names))
    return Table("c_a that each printed number asks for", head, tuple(rows))


def _speed_sweep(results: SliderResults) -> Section:
    if not results.sweep:
        return Section("sweep", "Faster", ())
    names = list(dict.fromkeys(p.reading for p in results.sweep))
    points = {(p.reading, p.speed): p for p in results.sweep}
    rows = []
    for speed in sorted({p.speed for p in results.sweep}):
        here = [points[n, speed] for n in names if (n, speed) in points]
        cells = [Cell(_number(v, 0), v) for p in here for v in (p.arq, p.gap)]
        rows.append(
            (Cell(_plain(speed), speed), Cell(_number(here[0].quad, 0), here[0].quad), *cells)
        )
    head = ["speed [m/s]", "Quad"]
    for name in names:
        head += [f"ARQ, {name}", f"less by, {name}"]
    gaps = [
        f"{row.reading} {_number(row.ours, 0)} m/s² ({_percent(row.deviation)}, {row.mark.word})"
        for row in _gap_rows(results)
    ]
    return Section(
        "sweep",
        "Faster: the speed sweep",
        (
            "The paper repeats the collision with the wall in simulation, without the mass of the "
            f"sliding bar, and prints that at {_plain(SWEEP_SPEEDS[-1])} m/s the peak acceleration of "
            f"ARQ is {_plain(SWEEP_GAP)} m/s² below that of Quad. With Quad's c_a the readings give: "
            f"{_listed(gaps)}.",
            Picture(
                "sweep",
                "Peak accelerations, and how much less ARQ's is; the line is what is printed.",
                plots.sweep_figure(results),
            ),
            Table("Peak accelerations [m/s²]", tuple(head), tuple(rows)),
        ),
    )


def _energy(results: SliderResults) -> Section:
    cases = [
        case
        for robot in plots.ROBOTS
        for surface in plots.SURFACES
        for case in plots.predictions(results, robot, surface)
    ]
    on_wall = [case.flight for case in cases if case.surface == "wall"]
    if not on_wall:
        return Section("energy", "Where the energy goes", ())
    worst = max(abs(case.flight.measures["ledger_residual"] or 0.0) for case in cases)
    return Section(
        "energy",
        "Where the energy goes",
        (
            "Kinetic energy before the collision is taken by damping in the contact and in the "
            "arms; the rest is what the robot leaves with. The ledger closes: at worst "
            f"{worst:.0e} of the energy is unaccounted for.".replace("e-0", "e-").replace(
                "e-", " · 10^-"
            ),
            Picture("energy", "Collisions with the wall.", plots.energy_figure(*on_wall)),
            Table(
                "Shares of the energy at the start",
                ("", "energy [J]", "contact damping", "arm dampers", "left in motion"),
                tuple(_energy_row(case) for case in cases),
            ),
        ),
    )


def _energy_row(case: Case) -> tuple[Cell, ...]:
    measures = case.flight.measures
    start = measures["energy_start"]
    cells = [Cell(_case_name(case)), Cell(_number(start, 2), start)]
    for key in ("loss_contact", "loss_arm", "energy_kinetic"):
        value = measures[key]
        known = start and value is not None
        cells.append(Cell(f"{100.0 * value / start:.1f} %", value) if known else Cell("–"))
    return tuple(cells)


def _case_name(case: Case) -> str:
    reading = "" if case.robot == "quad" else f", {case.reading.name}"
    return f"{plots.ROBOTS[case.robot]}{reading} on the {case.surface}"


def _method(results: SliderResults) -> Section:
    blocks: list[str | Table | Picture] = []
    if results.cases:
        s = results.cases[0].flight.scenario
        surface = s.world.obstacles[0].surface
        step, steps = (
            s.simulation.impact_step,
            [c.flight.measures["steps"] or 0 for c in results.cases],
        )
        arms = {
            "hybrid": "one rigid body in free flight, and with sliding arms from first touch until "
            "they have settled",
            "always-free": "with sliding arms throughout",
        }[s.model.arms]
        blocks.append(
            "The robot is a main body with arms that slide along their own directions on a spring "
            f"and a damper; it is simulated as {arms}. A slider lets it move along X only. Cages "
            f"touch by the {s.model.contact_point} contact point, under the {surface.law} law "
            f"f = k_c δⁿ (1 + 1.5 c_a δ̇), never pulling, with n = {_plain(surface.exponent)}. The "
            "equations are integrated by the classical Runge–Kutta method in steps of "
            f"{_plain(1e3 * step)} ms during the impact, landing on the instants of touch and "
            f"separation: {int(min(steps))} to {int(max(steps))} steps for a test."
        )
    blocks += [
        "c_a is fitted by the exact relation between restitution, c_a and speed of one mass on a "
        "Hunt–Crossley contact, which holds for any mass, stiffness and exponent.",
        Table(
            "Readings of the printed parameters of ARQ",
            ("reading", "what it is", "vehicle", "cages that share k_c", "changes"),
            tuple(
                (
                    Cell(r.name), Cell(r.text), Cell(r.vehicle), Cell(str(r.shared_by)),
                    Cell(" ".join(r.overrides) or "none"),
                )
                for r in results.readings
            ),
        ),
        Table(
            "What each compared number is",
            ("number", "definition", "unit shown"),
            tuple(
                (Cell(q.name), Cell(MEASURES[key][1]), Cell(q.unit or "–"))
                for key, q in QUANTITIES.items()
            ),
        ),
    ]  # fmt: skip
    return Section("method", "How it was computed", tuple(blocks))


def _given(results: SliderResults) -> Section:
    rows = tuple(
        (Cell(row.quantity), Cell("–" if row.ours is None else _plain(row.ours), row.ours), Cell(row.unit or "–"),
         Cell(row.note))
        for row in results.rows
        if row.mark is Mark.GIVEN
    )  # fmt: skip
    table = Table("Printed, and put in", ("parameter", "value", "unit", "place in the paper"), rows)
    return Section("given", "Given parameters", (table,))


def _everything(results: SliderResults, about: Mapping[str, Any]) -> Section:
    rows = tuple(
        (
            Cell(row.experiment), Cell(plots.ROBOTS.get(row.robot, row.robot)), Cell(row.surface),
            Cell(row.reading), Cell(row.quantity),
            Cell("–" if row.ours is None else f"{row.ours:.6g}", row.ours),
            Cell("–" if row.printed is None else f"{row.printed:.6g}", row.printed),
            Cell(row.unit or "–"), Cell(_percent(row.deviation)), Cell("", mark=row.mark),
            Cell(_number(row.dissipation, 4), row.dissipation), Cell(row.dissipation_from),
        )
        for row in results.rows
    )  # fmt: skip
    head = (
        "experiment", "robot", "surface", "reading", "quantity", "ours", "printed", "unit",
        "deviation", "mark", "c_a [s/m]", "c_a from",
    )  # fmt: skip
    versions = tuple((Cell(str(key)), Cell(str(value))) for key, value in about.items())
    return Section(
        "data",
        "All numbers, and what made them",
        (
            Table(f"All {len(rows)} compared numbers, in SI units", head, rows, folded=True),
            Table("Made with", ("", "version"), versions),
            "The same numbers stand beside this page in comparison.json, comparison.csv and "
            "sweep.csv, the figures in figures/ as PNG and PDF.",
        ),
    )
