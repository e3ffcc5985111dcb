"""The reproduction report: one page that needs nothing else, its figures, and the numbers as data.

A page is made of sections, a section of blocks: paragraphs, tables, pictures; one template lays
them out.  The words on the slider tests are in ``templates/slider.toml``; numbers come in by name.
"""

from __future__ import annotations

import base64
import csv
import re
import tomllib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass
from importlib.resources import files
from pathlib import Path
from typing import Any, NamedTuple

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup, escape
from matplotlib.figure import Figure

from springback.experiments.comparison import AGREEMENT, Mark, Row
from springback.experiments.paper.printed import PAPER, SLIDER_SPEED, SWEEP_GAP, SWEEP_SPEEDS
from springback.experiments.paper.slider import Case, SliderResults
from springback.interfaces import canvas, plots
from springback.interfaces.files import write_json
from springback.simulation.measures import MEASURES

TEXT: dict[str, Any] = tomllib.loads(
    (files("springback.interfaces") / "templates" / "slider.toml").read_text("utf-8")
)


@dataclass(frozen=True)
class Cell:
    """A cell of a table: a text and, if it stands for a number, the number itself."""

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
        return "data:image/png;base64," + base64.b64encode(canvas.png(self.figure)).decode("ascii")

    @property
    def size(self) -> tuple[int, int]:
        """Width and height on the page [CSS pixels]."""
        width, height = self.figure.get_size_inches()
        return round(125 * width), round(125 * height)


Blocks = tuple[str | Table | Picture, ...]


@dataclass(frozen=True)
class Section:
    """A part of the page: paragraphs (plain text), tables and pictures, in their order."""

    anchor: str
    title: str
    blocks: Blocks


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
    known = r"\b([abcklmv])_(a|b|c|l|n|max|rigid)\b"
    return Markup(re.sub(known, r"<var>\1<sub>\2</sub></var>", str(escape(text))))


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
    names = ("report.html", "comparison.json", "comparison.csv", "sweep.csv")
    written = [folder / name for name in names]
    written[0].write_text(page("The slider tests", sections), encoding="utf-8")
    write_json(written[1], _data(results, about))
    _write_csv(written[2], [row.as_dict() for row in results.rows])
    head = ("reading", "speed [m/s]", "quad [m/s^2]", "arq [m/s^2]", "gap [m/s^2]")
    points = [(p.reading, p.speed, p.quad, p.arq, p.gap) for p in results.sweep]
    _write_csv(written[3], [dict(zip(head, point, strict=True)) for point in points])
    for section in sections:
        for block in section.blocks:
            if isinstance(block, Picture):
                written += canvas.save(block.figure, folder / "figures" / block.name)
    return written


def _data(results: SliderResults, about: Mapping[str, Any]) -> dict[str, Any]:
    cases = [
        {
            "robot": c.robot, "surface": c.surface, "reading": c.reading.name,
            "dissipation": c.dissipation, "dissipation_from": c.dissipation_from,
            "outcome": c.flight.outcome.word, "measures": c.flight.measures,
        }
        for c in results.cases
    ]  # fmt: skip
    return {
        "about": dict(about),
        "paper": PAPER,
        "agreement": AGREEMENT,
        "readings": [asdict(reading) for reading in results.readings],
        "rows": [row.as_dict() for row in results.rows],
        "sweep": [{**asdict(point), "gap": point.gap} for point in results.sweep],
        "cases": cases,
        "units": {name: unit for name, (unit, _) in MEASURES.items()},
    }


def _write_csv(path: Path, rows: Sequence[Mapping[str, Any]]) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]) if rows else [], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


class Quantity(NamedTuple):
    """How a compared quantity is shown; the scale takes SI to the unit."""

    name: str
    unit: str = ""
    scale: float = 1.0
    decimals: int = 3


QUANTITIES = {key: Quantity(**entry) for key, entry in TEXT["quantities"].items()}
PRINTED: dict[str, list[str]] = TEXT["printed"]
"""The printed numbers of a test, and what of ours each may be compared with."""
Run = Mapping[str, Row]
"""Rows of one flown test by quantity."""
Runs = dict[tuple[str, str, str], list[Run]]
"""Runs by robot, surface and reading: the first with Quad's c_a."""


def _say(key: str, **values: Any) -> str:
    words: str = TEXT[key]
    return words.strip("\n").replace("\n", " ").format(**values)


def _head(key: str) -> tuple[str, ...]:
    return tuple(TEXT["heads"][key])


def _number(value: float | None, decimals: int) -> str:
    return "–" if value is None else f"{value:.{decimals}f}".replace("-", "−")


def _plain(value: float | None) -> str:
    """A given or printed number with no more digits than it has."""
    return "–" if value is None else f"{value:.6g}".replace("e+0", "e")


def _percent(share: float | None) -> str:
    if share is None:
        return ""
    return f"{round(100.0 * share, 1) + 0.0:+.1f} %".replace("-", "−")


def _listed(words: Iterable[str]) -> str:
    *most, last = [*words] or ["none"]
    return f"{', '.join(most)} and {last}" if most else last


def _ours(row: Row | None) -> Cell:
    if row is None:
        return Cell("–")
    quantity = QUANTITIES[row.quantity]
    number = None if row.ours is None else row.ours * quantity.scale
    return Cell(_number(number, quantity.decimals), row.ours, _percent(row.deviation), row.mark)


def _printed(row: Row, value: float | None) -> Cell:
    return Cell(_plain(None if value is None else value * QUANTITIES[row.quantity].scale), value)


def _c_a(run: Run | None, absent: str = "–") -> Cell:
    """c_a of a run, the same in all its rows."""
    row = next(iter((run or {}).values()), None)
    return Cell(absent) if row is None else Cell(_number(row.dissipation, 3), row.dissipation)


def _runs(results: SliderResults) -> Runs:
    found: dict[tuple[str, str, str], dict[str, dict[str, Row]]] = {}
    for row in results.rows:
        if row.experiment == "Table III" and row.quantity in QUANTITIES:
            runs = found.setdefault((row.robot, row.surface, row.reading), {})
            runs.setdefault(row.dissipation_from, {})[row.quantity] = row
    return {key: list(runs.values()) for key, runs in found.items()}


def _nth(runs: Runs, robot: str, surface: str, reading: str, n: int) -> Run | None:
    return next(iter(runs.get((robot, surface, reading), [])[n : n + 1]), None)


def _agrees(run: Run | None, number: str) -> bool:
    """Whether a printed number comes out, in any of its definitions."""
    rows = [run[quantity] for quantity in PRINTED[number] if quantity in run] if run else []
    return any(row.mark is not Mark.CONTRADICTED for row in rows)


def _gaps(results: SliderResults, mark: Mark | None = None) -> dict[str, Row]:
    """Rows of the gap of the sweep by reading: the prediction, or the first with a mark."""
    found: dict[str, Row] = {}
    for row in results.rows:
        if row.experiment == "Sweep" and mark in (None, row.mark):
            found.setdefault(row.reading, row)
    return found


def slider_sections(results: SliderResults, about: Mapping[str, Any]) -> list[Section]:
    """The page of the slider tests, section by section; what was not flown is left out."""
    runs = _runs(results)
    blocks: dict[str, Blocks] = {
        "answer": _answer(results, runs),
        "table": _table_iii(results, runs),
        "time": _over_time(results),
        "disagreement": _disagreement(results, runs),
        "sweep": _sweep(results),
        "energy": _energy(results),
        "method": _method(results),
        "given": _given(results),
        "data": _everything(results, about),
    }
    return [Section(key, TEXT["titles"][key], found) for key, found in blocks.items() if found]


def _over_time(results: SliderResults) -> Blocks:
    flown = {case.robot: plots.ROBOTS[case.robot] for case in results.cases}
    return tuple(
        Picture(
            f"slider_{robot}", _say("time_picture", robot=name), plots.slider_figure(results, robot)
        )
        for robot, name in flown.items()
    )


def _answer(results: SliderResults, runs: Runs) -> Blocks:
    details, met, free = [], 0, [n for n in PRINTED if n != "COR"]
    quads = {s: run for s in plots.SURFACES if (run := _nth(runs, "quad", s, "Quad", 0))}
    for surface, run in quads.items():
        met += sum(_agrees(run, number) for number in free)
        numbers = _listed(_quad_number(number, run) for number in free)
        c_a = _number(next(iter(run.values())).dissipation, 3)
        details.append(_say("quad", surface=surface, c_a=c_a, numbers=numbers))
    verdict, within = "", _plain(100 * AGREEMENT)
    if quads:
        verdict = _say("verdict_quad", met=met, all=len(free) * len(quads), agreement=within)
    if names := [r.name for r in results.readings if ("arq", "wall", r.name) in runs]:
        complete = [
            f"reading {name} on the {surface}"
            for name in names
            for surface in plots.SURFACES
            if all(_agrees(_nth(runs, "arq", surface, name, 0), number) for number in PRINTED)
        ]
        key = "verdict_arq_some" if complete else "verdict_arq_none"
        verdict += _say(key, all=len(PRINTED), readings=len(names), complete=_listed(complete))
    if _gaps(results):
        details.append(_say("gap", **_gap_words(results)))
    blocks: list[str | Table | Picture] = [_say("asked", speed=_plain(SLIDER_SPEED)), verdict]
    if results.cases:
        blocks.append(Picture("answer", _say("answer_picture"), plots.readme_figure(results)))
    counts = {mark: sum(row.mark is mark for row in results.rows) for mark in Mark}
    marks = [(Cell("", mark=m), Cell(str(n), n), Cell(m.value)) for m, n in counts.items()]
    table = Table(_say("marks", count=len(results.rows)), _head("marks"), tuple(marks))
    return (*blocks, *details, table)


def _quad_number(number: str, run: Run) -> str:
    row = run[PRINTED[number][0]]
    printed, unit = _printed(row, row.printed), QUANTITIES[row.quantity].unit
    return _say("quad_number", name=number, row=row, ours=_ours(row), printed=printed, unit=unit)


def _table_iii(results: SliderResults, runs: Runs) -> Blocks:
    def comparison(robot: str, surface: str, caption: str, n: int) -> list[Table]:
        own = {name: f"ARQ, {name}" for name in (r.name for r in results.readings)}
        names = {"Quad": "Quad"} if robot == "quad" else own
        chosen = {name: _nth(runs, robot, surface, name, n) or {} for name in names}
        example = next((run for run in chosen.values() if run), None)
        if example is None:
            return []
        damping = [_c_a(run, _say("no_dissipation")) for run in chosen.values()]
        rows = [(Cell("c_a [s/m]"), Cell("–"), *damping, Cell("–"))]
        for key, row in example.items():
            quantity = QUANTITIES[key]
            label = f"{quantity.name} [{quantity.unit}]" if quantity.unit else quantity.name
            simulated, tested = _printed(row, row.printed), _printed(row, row.printed_test)
            ours = (_ours(run.get(key)) for run in chosen.values())
            rows.append((Cell(label), simulated, *ours, tested))
        title = _say(caption, robot=plots.ROBOTS[robot], surface=surface)
        head = ("", "printed, simulation", *names.values(), "printed, test")
        return [Table(title, head, tuple(rows))]

    def both(robot: str, caption: str, n: int = 0) -> list[Table]:
        return [t for s in plots.SURFACES for t in comparison(robot, s, caption, n)]

    predicted = both("quad", "table_caption") + both("arq", "table_caption_predicted")
    own = both("arq", "table_caption_own", 1)
    if not predicted:
        return ()
    return (_say("table"), *predicted, *([_say("table_own")] if own else []), *own)


def _disagreement(results: SliderResults, runs: Runs) -> Blocks:
    names = [r.name for r in results.readings if ("arq", "wall", r.name) in runs]
    if not names:
        return ()

    def giving(number: str, surface: str) -> Cell:
        found = [n for n in names if _agrees(_nth(runs, "arq", surface, n, 0), number)]
        return Cell(_listed(found))

    who = [(Cell(n), *(giving(n, surface) for surface in plots.SURFACES)) for n in PRINTED]
    gaps, fitted = _gaps(results), _gaps(results, Mark.FITTED)
    good = [name for name, row in gaps.items() if row.mark is not Mark.CONTRADICTED]
    who.append((Cell("gap of the speed sweep"), Cell(_listed(good)), Cell("–")))
    wanted = [
        (
            Cell(f"COR on the {surface}"),
            _c_a(_nth(runs, "quad", surface, "Quad", 0)),
            *(_c_a(_nth(runs, "arq", surface, name, 1), "none does") for name in names),
        )
        for surface in plots.SURFACES
    ]
    own = ({"gap": fitted[name]} if name in fitted else None for name in names)
    cells = (_c_a(run, "none does") for run in own)
    wanted.append((Cell("gap of the sweep, on the wall"), Cell("–"), *cells))
    head = ("printed number of ARQ", *(f"given on the {s} by" for s in plots.SURFACES))
    columns = ("printed number", "Quad", *(f"ARQ, {name}" for name in names))
    return (
        _say("disagreement", agreement=_plain(100 * AGREEMENT)),
        Table(_say("who"), head, tuple(who)),
        Picture("readings", _say("readings_picture"), plots.readings_figure(results)),
        _say("why"),
        _say("wanted"),
        Table(_say("wanted_caption"), columns, tuple(wanted)),
    )


def _sweep(results: SliderResults) -> Blocks:
    if not results.sweep:
        return ()
    names = list(dict.fromkeys(point.reading for point in results.sweep))
    points = {(point.reading, point.speed): point for point in results.sweep}
    rows = []
    for speed in sorted({point.speed for point in results.sweep}):
        here = [points[name, speed] for name in names]
        values = [here[0].quad, *(value for p in here for value in (p.arq, p.gap))]
        rows.append((Cell(_plain(speed), speed), *(Cell(_number(v, 0), v) for v in values)))
    columns = (word for name in names for word in (f"ARQ, {name}", f"gap, {name}"))
    return (
        _say("sweep", **_gap_words(results)),
        Picture("sweep", _say("sweep_picture"), plots.sweep_figure(results)),
        Table(_say("sweep_caption"), ("speed [m/s]", "Quad", *columns), tuple(rows)),
    )


def _gap_words(results: SliderResults) -> dict[str, str]:
    gaps = [
        _say("sweep_gap", row=row, ours=_number(row.ours, 0), deviation=_percent(row.deviation))
        for row in _gaps(results).values()
    ]
    speed, printed = _plain(SWEEP_SPEEDS[-1]), _plain(SWEEP_GAP)
    return {"speed": speed, "printed": printed, "gaps": _listed(gaps)}


def _energy(results: SliderResults) -> Blocks:
    cases = [
        case
        for robot in plots.ROBOTS
        for surface in plots.SURFACES
        for case in plots.predictions(results, robot, surface)
    ]
    on_wall = [case.flight for case in cases if case.surface == "wall"]
    if not on_wall:
        return ()
    worst = max(abs(case.flight.measures["ledger_residual"] or 0.0) for case in cases)
    digit, power = f"{max(worst, 1e-16):.0e}".split("e")
    residual = f"{digit} · 10" + str(int(power)).translate(
        str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
    )
    return (
        _say("energy", residual=residual),
        Picture("energy", _say("energy_picture"), plots.energy_figure(*on_wall)),
        Table(_say("energy_caption"), _head("energy"), tuple(_energy_row(case) for case in cases)),
    )


def _energy_row(case: Case) -> tuple[Cell, ...]:
    measures = case.flight.measures
    start = measures["energy_start"] or 0.0
    parts = [measures[key] or 0.0 for key in ("loss_contact", "loss_arm", "energy_kinetic")]
    shares = (Cell(f"{100.0 * part / start:.1f} %" if start else "–", part) for part in parts)
    robot = plots.ROBOTS[case.robot] + ("" if case.robot == "quad" else f", {case.reading.name}")
    return (Cell(f"{robot} on the {case.surface}"), Cell(_number(start, 2), start), *shares)


def _method(results: SliderResults) -> Blocks:
    first: list[str] = []
    if results.cases:
        scenario = results.cases[0].flight.scenario
        surface = scenario.world.obstacles[0].surface
        steps = [int(case.flight.measures["steps"] or 0) for case in results.cases]
        first.append(
            _say(
                "method", arms=_say(scenario.model.arms), point=scenario.model.contact_point,
                law=surface.law.title().replace("-", "–"), exponent=_plain(surface.exponent),
                step=_plain(1e3 * scenario.simulation.impact_step), fewest=min(steps),
                most=max(steps),
            )
        )  # fmt: skip
    readings = tuple(
        tuple(
            map(Cell, (r.name, r.text, r.vehicle, str(r.shared_by), " ".join(r.overrides) or "–"))
        )
        for r in results.readings
    )
    definitions = tuple(
        (Cell(quantity.name), Cell(MEASURES[key][1])) for key, quantity in QUANTITIES.items()
    )
    return (
        *first,
        _say("fit"),
        Table(_say("readings_caption"), _head("readings"), readings),
        Table(_say("definitions"), _head("definitions"), definitions),
    )


def _given(results: SliderResults) -> Blocks:
    rows = tuple(
        (Cell(r.quantity), Cell(_plain(r.ours), r.ours), Cell(r.unit or "–"), Cell(r.note))
        for r in results.rows
        if r.mark is Mark.GIVEN
    )
    return (Table(_say("given_caption"), _head("given"), rows),) if rows else ()


def _everything(results: SliderResults, about: Mapping[str, Any]) -> Blocks:
    rows = tuple(
        (
            *map(Cell, (r.experiment, r.robot, r.surface, r.reading, r.quantity, r.unit)),
            *(Cell(_plain(value), value) for value in (r.ours, r.printed)),
            Cell(_percent(r.deviation)), Cell("", mark=r.mark), _c_a({"": r}),
            Cell(r.dissipation_from),
        )
        for r in results.rows
    )  # fmt: skip
    made_with = tuple((Cell(str(key)), Cell(str(value))) for key, value in about.items())
    return (
        Table(_say("all_caption", count=len(rows)), _head("all"), rows, folded=True),
        Table(_say("made_with"), _head("made_with"), made_with),
        _say("files"),
    )
