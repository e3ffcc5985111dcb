"""The slider tests in the report: Table III, the readings, the sweep, the energy.

The text is in ``templates/slider.toml``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any, NamedTuple

from springback.contact.parameters import PlaneSettings
from springback.interfaces.figures import flight
from springback.interfaces.output.robots import ROBOTS
from springback.interfaces.replay.scene import scene_of
from springback.interfaces.reports.page import (
    Blocks,
    Content,
    Entry,
    FigureBlock,
    Section,
    Table,
    TableCell,
    Wording,
    decimal,
    join,
    percent,
    plain,
    table,
    words_of_power,
)
from springback.interfaces.reproduction.figures import drawings, slider
from springback.paper.printed import SLIDER_SPEED, SWEEP_GAP, SWEEP_SPEEDS, TABLE_III
from springback.paper.slider import DEFAULT, Case, SliderResults
from springback.simulation.measuring.measures import MEASURES
from springback.studies.comparison import AGREEMENT, Mark, Row

WORDS = Wording.of("slider")
DRAWN = DEFAULT
"""Reading whose contact is drawn: the one with arms at an angle."""
NEAR = (AGREEMENT, 0.10)
"""Chosen: relative deviations from the printed value within which agreement is counted."""


class Quantity(NamedTuple):
    """Name and format of a compared quantity; ``scale`` converts SI to the unit."""

    name: str
    unit: str = ""
    scale: float = 1.0
    decimals: int = 3


QUANTITIES = {key: Quantity(**entry) for key, entry in WORDS.text["quantities"].items()}
PRINTED: dict[str, list[str]] = WORDS.text["printed"]
"""Printed numbers of a test, and the measures that each may be compared with."""
Run = Mapping[str, Row]
"""Rows of one flown test by quantity."""
Runs = dict[tuple[str, str, str], list[Run]]
"""Runs by robot, surface and reading; the first with Quad's c_a."""


def _ours(row: Row | None) -> TableCell:
    if row is None:
        return TableCell("–")
    quantity = QUANTITIES[row.quantity]
    number = None if row.ours is None else row.ours * quantity.scale
    return TableCell(decimal(number, quantity.decimals), row.ours, percent(row.deviation), row.mark)


def _printed_cell(row: Row, value: float | None) -> TableCell:
    return TableCell(
        plain(None if value is None else value * QUANTITIES[row.quantity].scale), value
    )


def _test_cell(row: Row) -> TableCell:
    """Number of the physical test, with its deviation from the paper's own simulation."""
    cell = _printed_cell(row, row.printed_test)
    if row.scatter is None:
        return cell
    return TableCell(cell.text, cell.value, WORDS.say("scatter", share=percent(row.scatter)))


def _c_a(run: Run | None, absent: str = "–") -> TableCell:
    """c_a of a run, the same in all its rows."""
    row = next(iter((run or {}).values()), None)
    return (
        TableCell(absent)
        if row is None
        else TableCell(decimal(row.dissipation, 3), row.dissipation)
    )


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
    """True if a printed number agrees in any of its definitions."""
    rows = [run[quantity] for quantity in PRINTED[number] if quantity in run] if run else []
    return any(row.mark is not Mark.CONTRADICTED for row in rows)


def _is_fitted(run: Run | None) -> bool:
    """True if any number of a run was fitted to."""
    return any(row.mark is Mark.FITTED for row in (run or {}).values())


def _gaps(results: SliderResults, mark: Mark | None = None) -> dict[str, Row]:
    """Rows of the gap of the sweep by reading: the prediction, or the first with a mark."""
    found: dict[str, Row] = {}
    for row in results.rows:
        if row.experiment == "Sweep" and mark in (None, row.mark):
            found.setdefault(row.reading, row)
    return found


def slider_sections(results: SliderResults) -> list[Section]:
    """Sections on the slider tests; parts that were not flown are left out."""
    runs = _runs(results)
    given = [
        (r.quantity, r.ours, r.unit or None, r.note) for r in results.rows if r.mark is Mark.GIVEN
    ]
    return WORDS.sections({
        "answer": _answer(results, runs),
        "table": _table_iii(results, runs),
        "time": {"pictures": _over_time(results)} if results.cases else {},
        "disagreement": _disagreement(results, runs),
        "sweep": _sweep(results),
        "energy": _energy(results),
        "method": _method(results),
        "given": {"given": given} if given else {},
    })  # fmt: skip


def _over_time(results: SliderResults) -> Blocks:
    return tuple(
        FigureBlock(
            f"slider_{robot}",
            WORDS.say("time_picture", robot=ROBOTS[robot].label),
            slider.slider_figure(results, robot),
        )
        for robot in dict.fromkeys(case.robot for case in results.cases)
    )


def _answer(results: SliderResults, runs: Runs) -> Content:
    details, met, free = [], 0, [n for n in PRINTED if n != "COR"]
    quads = {s: run for s in slider.SURFACES if (run := _nth(runs, "quad", s, "Quad", 0))}
    for surface, run in quads.items():
        met += sum(_agrees(run, number) for number in free)
        numbers = join(_quad_number(number, run) for number in free)
        details.append(WORDS.say("quad", surface=surface, c_a=_c_a(run), numbers=numbers))
    verdict = ""
    if quads:
        counted = {"met": met, "all": len(free) * len(quads), "agreement": 100 * AGREEMENT}
        verdict = WORDS.say("verdict_quad", **counted)
    if names := [r.name for r in results.readings if ("arq", "wall", r.name) in runs]:
        complete = [
            f"reading {name} on the {surface}"
            for name in names
            for surface in slider.SURFACES
            if all(_agrees(_nth(runs, "arq", surface, name, 0), number) for number in PRINTED)
            and not _is_fitted(_nth(runs, "arq", surface, name, 0))
        ]
        key = "verdict_arq_some" if complete else "verdict_arq_none"
        verdict += WORDS.say(key, all=len(PRINTED), readings=len(names), complete=join(complete))
    return {
        **_gap_words(results), "speed": SLIDER_SPEED, "fastest": SWEEP_SPEEDS[-1],
        "verdict": verdict, "details": details,
        "answer": slider.readme_figure(results) if results.cases else None,
    }  # fmt: skip


def _quad_number(number: str, run: Run) -> str:
    row = run[PRINTED[number][0]]
    printed, unit = _printed_cell(row, row.printed), QUANTITIES[row.quantity].unit
    return WORDS.say(
        "quad_number", name=number, row=row, ours=_ours(row), printed=printed, unit=unit
    )


def _table_iii(results: SliderResults, runs: Runs) -> Content:
    def comparison(robot: str, surface: str, caption: str, n: int) -> list[Table]:
        own = {name: f"ARQ, {name}" for name in (r.name for r in results.readings)}
        names = {"Quad": "Quad"} if robot == "quad" else own
        chosen = {name: _nth(runs, robot, surface, name, n) or {} for name in names}
        example = next((run for run in chosen.values() if run), None)
        if example is None:
            return []
        damping = [_c_a(run, WORDS.say("no_dissipation")) for run in chosen.values()]
        rows: list[Sequence[Entry]] = [("c_a [s/m]", None, *damping, None)]
        for key, row in example.items():
            quantity = QUANTITIES[key]
            label = f"{quantity.name} [{quantity.unit}]" if quantity.unit else quantity.name
            ours = (_ours(run.get(key)) for run in chosen.values())
            rows.append((label, _printed_cell(row, row.printed), *ours, _test_cell(row)))
        title = WORDS.say(caption, robot=ROBOTS[robot].label, surface=surface)
        return [table(title, ["", "printed, simulation", *names.values(), "printed, test"], rows)]

    def both(robot: str, caption: str, n: int = 0) -> list[Table]:
        return [t for s in slider.SURFACES for t in comparison(robot, s, caption, n)]

    predicted = both("quad", "table_caption") + both("arq", "table_caption_predicted")
    own = both("arq", "table_caption_own", 1)
    return {"predicted": predicted, "own": own, **_differences()} if predicted else {}


def _differences() -> dict[str, str]:
    """Differences of restitution between the surfaces in the paper's own numbers."""
    gaps = {}
    for robot in slider.FLOWN:
        wall, mat = (TABLE_III[robot, surface] for surface in slider.SURFACES)
        gaps[robot] = decimal(mat.restitution - wall.restitution, 3)
        gaps[f"{robot}_test"] = decimal(mat.restitution_test - wall.restitution_test, 3)
    return gaps


def _disagreement(results: SliderResults, runs: Runs) -> Content:
    names = [r.name for r in results.readings if ("arq", "wall", r.name) in runs]
    if not names:
        return {}
    who: list[Sequence[Entry]] = [
        ("printed number of ARQ", *(f"given on the {s} by" for s in slider.SURFACES))
    ]
    for number in PRINTED:
        giving = (
            join(n for n in names if _agrees(_nth(runs, "arq", surface, n, 0), number))
            for surface in slider.SURFACES
        )
        who.append((number, *giving))
    gaps, fitted = _gaps(results), _gaps(results, Mark.FITTED)
    good = [name for name, row in gaps.items() if row.mark is not Mark.CONTRADICTED]
    who.append(("gap of the speed sweep", join(good), None))
    wanted: list[Sequence[Entry]] = [
        ("printed number", "Quad", *(f"ARQ, {name}" for name in names))
    ]
    for surface in slider.SURFACES:
        quad = _c_a(_nth(runs, "quad", surface, "Quad", 0))
        own = (_c_a(_nth(runs, "arq", surface, name, 1), "none does") for name in names)
        wanted.append((f"COR on the {surface}", quad, *own))
    gap = (_c_a({"gap": fitted[n]} if n in fitted else None, "none does") for n in names)
    wanted.append(("gap of the sweep, on the wall", None, *gap))
    return {
        "default": DEFAULT, "near": 100 * NEAR[0], "wider": 100 * NEAR[1], "printed": SWEEP_GAP,
        "counts": _counts(results, names), "who": who, "wanted": wanted,
        "readings": slider.readings_figure(results),
    }  # fmt: skip


def _counts(results: SliderResults, names: Sequence[str]) -> list[Sequence[Entry]]:
    """Rows of counts of ARQ's numbers that each reading gives, and the gap of the sweep."""
    gaps, lines = _gaps(results), list[Sequence[Entry]]()
    for reading in (r for r in results.readings if r.name in names):
        rows = results.unique_rows(reading.name)
        known = [abs(row.deviation) for row in rows if row.deviation is not None]
        near = (sum(deviation <= share for deviation in known) for share in NEAR)
        gap = gaps.get(reading.name)
        lines.append((
            TableCell(reading.name, detail=reading.text),
            *(TableCell(f"{count} of {len(rows)}", count) for count in near),
            sum(row.mark is Mark.FITTED for row in rows),
            percent(max(known)).lstrip("+") if known else None,
            None if gap is None else TableCell(decimal(gap.ours, 0), gap.ours),
        ))  # fmt: skip
    return lines


def _sweep(results: SliderResults) -> Content:
    if not results.sweep:
        return {}
    names = list(dict.fromkeys(point.reading for point in results.sweep))
    points = {(point.reading, point.speed): point for point in results.sweep}
    columns = (word for name in names for word in (f"ARQ, {name}", f"gap, {name}"))
    rows: list[Sequence[Entry]] = [("speed [m/s]", "Quad", *columns)]
    for speed in sorted({point.speed for point in results.sweep}):
        here = [points[name, speed] for name in names]
        values = [here[0].quad, *(value for p in here for value in (p.arq, p.gap))]
        rows.append((speed, *(TableCell(decimal(v, 0), v) for v in values)))
    return {
        **_gap_words(results), "fastest": SWEEP_SPEEDS[-1], "points": rows,
        "sweep": slider.sweep_figure(results),
    }  # fmt: skip


def _gap_words(results: SliderResults) -> Content:
    """Content on the gap of the sweep in each reading, if flown."""
    gaps = [
        WORDS.say("sweep_gap", row=row, deviation=percent(row.deviation))
        for row in _gaps(results).values()
    ]
    return {"printed": SWEEP_GAP, "gaps": join(gaps) if gaps else ""}


def _energy(results: SliderResults) -> Content:
    cases = [
        case
        for robot in slider.FLOWN
        for surface in slider.SURFACES
        for case in slider.predictions(results, robot, surface)
    ]
    on_wall = [case.flight for case in cases if case.surface == "wall"]
    if not on_wall:
        return {}
    worst = max(abs(case.flight.measures["ledger_residual"] or 0.0) for case in cases)
    return {
        "residual": words_of_power(worst),
        "energy": flight.energy_figure(*on_wall),
        "shares": [_energy_row(case) for case in cases],
    }


def _energy_row(case: Case) -> tuple[Entry, ...]:
    measures = case.flight.measures
    start = measures["energy_start"] or 0.0
    parts = [measures[key] or 0.0 for key in ("loss_contact", "loss_arm", "energy_kinetic")]
    shares = (TableCell(f"{100.0 * part / start:.1f} %" if start else "–", part) for part in parts)
    robot = ROBOTS[case.robot].label + ("" if case.robot == "quad" else f", {case.reading.name}")
    return (f"{robot} on the {case.surface}", TableCell(decimal(start, 2), start), *shares)


def _method(results: SliderResults) -> Content:
    content: dict[str, Any] = {
        "readings": [
            (r.name, r.text, r.vehicle, str(r.shared_by), " ".join(r.overrides) or None)
            for r in results.readings
        ],
        "definitions": [(quantity.name, MEASURES[key][1]) for key, quantity in QUANTITIES.items()],
    }
    if results.cases:
        scenario = results.cases[0].flight.scenario
        wall = scenario.world.obstacles[0]
        assert isinstance(wall, PlaneSettings)
        surface = wall.surface
        steps = [int(case.flight.measures["steps"] or 0) for case in results.cases]
        content |= {
            "arms": WORDS.say(scenario.model.arms), "point": scenario.model.contact_point,
            "law": surface.law.title().replace("-", "–"), "exponent": surface.exponent,
            "step": 1e3 * scenario.simulation.impact_step, "fewest": min(steps),
            "most": max(steps), "robots_drawn": drawings.robots_figure(),
            "contact": _contact(results),
        }  # fmt: skip
    return content


def _contact(results: SliderResults) -> Blocks:
    """Figure of ARQ hitting the wall in the default reading."""
    for case in slider.predictions(results, "arq", "wall"):
        hit = case.flight
        if case.reading.name == DRAWN and hit.measures["touch_time"] is not None:
            words = WORDS.say("contact_picture", reading=DRAWN)
            if hit.scenario.model.contact_point == "paper":
                words += " " + WORDS.say("contact_along_arm")
            figure = drawings.contact_figure(scene_of(hit, label=ROBOTS["arq"].label))
            return (FigureBlock("contact_drawn", words, figure),)
    return ()


def slider_data(results: SliderResults) -> dict[str, Any]:
    """Slider tests without the compared numbers, as plain data."""
    cases = [
        {
            "robot": c.robot, "surface": c.surface, "reading": c.reading.name,
            "dissipation": c.dissipation, "dissipation_from": c.dissipation_from,
            "outcome": c.flight.outcome.word, "measures": c.flight.measures,
        }
        for c in results.cases
    ]  # fmt: skip
    return {
        "readings": [asdict(reading) for reading in results.readings],
        "sweep": [{**asdict(point), "gap": point.gap} for point in results.sweep],
        "cases": cases,
        "units": {name: unit for name, (unit, _) in MEASURES.items()},
    }


def sweep_rows(results: SliderResults) -> list[dict[str, Any]]:
    """Rows of the points of the sweep, for CSV."""
    return [
        {
            "reading": p.reading, "speed [m/s]": p.speed, "quad [m/s^2]": p.quad,
            "arq [m/s^2]": p.arq, "gap [m/s^2]": p.gap,
        }
        for p in results.sweep
    ]  # fmt: skip
