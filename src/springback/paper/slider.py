"""The slider tests: Table III, the deflections and contact times of the text, and the speed sweep.

c_a is printed nowhere.  It is fitted to the restitution of Quad alone, by the exact relation, and
every other number follows.  How the printed parameters are to be read for ARQ is open, so every
reading is shown (docs/decisions/0005).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import scipy  # its parts are loaded when first used

from springback.contact.laws.restitution import dissipation_for
from springback.contact.library import SURFACES
from springback.errors import InputError
from springback.paper.printed import (
    DISSIPATION_RANGE,
    FREE_MASS,
    SLIDER_DISTANCE,
    SLIDER_SPEED,
    SWEEP_GAP,
    SWEEP_SPEEDS,
    TABLE_III,
    PrintedImpact,
)
from springback.progress import Progress, silent
from springback.results.flight import Flight, fly
from springback.scenario.overrides import apply_overrides
from springback.scenario.presets import vehicle_table
from springback.studies.comparison import Mark, Row, predicted_or_contradicted
from springback.vehicle.parameters import Vehicle

MAT_THICKNESS = 0.05
"""[m], not printed; thick enough that no run presses through to the wall."""
ROOM = 0.05
"""[m] of free run before the touch."""
QUANTITIES = {
    "restitution_at_separation": "",
    "restitution_at_return": "",
    "restitution_of_mass_centre": "",
    "impact_peak_acceleration": "m/s^2",
    "travel": "m",
    "contact_time": "s",
    "time_to_return": "s",
}


COUNTED = ("restitution_at_separation", "impact_peak_acceleration", "travel", "time_to_return")
"""Measures that count for the four numbers of a column of Table III, each once: COR when the cage
leaves, contact time until the body is back where it was at first touch."""


@dataclass(frozen=True)
class Interpretation:
    """A way to read the printed parameters: which masses and springs, and who shares k_c."""

    name: str
    text: str
    vehicle: str
    shared_by: int
    overrides: tuple[str, ...] = ()
    fitted: tuple[str, ...] = ()
    """Measures that a number of the reading was chosen for ..."""
    fitted_on: tuple[str, ...] = ("wall", "mat")
    """... on these surfaces; on others they are predicted."""

    @property
    def arms_mass(self) -> float:
        """Mass of all arms [kg]."""
        own = [word for word in self.overrides if word.startswith("vehicle.")]
        tables = apply_overrides({"vehicle": {"preset": self.vehicle}}, own)
        vehicle = Vehicle.model_validate(vehicle_table(tables["vehicle"]))
        return float(vehicle.mass - vehicle.body.mass)


QUAD = Interpretation("Quad", "one rigid body; k_c belongs to the whole front", "quad-slider", 2)
_PAIR = ("vehicle.arms.stiffness=1250", "vehicle.arms.damping=22.5")
_LATCHED = (
    '{type="slide", direction=[-1, 0, 0], travel=[0, 0.1], stiffness=1250, damping=18.4, '
    "latch={force=39.5, travel=0.0021}}"
)
_RING_REACH = 0.19 * 2.0**-0.5 + 0.11
"""Of the front cages along X, level: joints have the ring as contact point [m]."""
READINGS = (
    Interpretation("A", "one arm mass and one spring in series along X; k_c in total",
    "arq-lumped", 1),
    Interpretation(
        "B", "two arms at 45 deg touch, k_c/2 each: the paper's ten coordinates", "arq-slider", 2
    ),
    Interpretation("C", "two arms at 45 deg touch, k_c each", "arq-slider", 1),
    Interpretation(
        "D", "the front pair as one spring: reading B with k_l/4 and b_l/4 an arm, which along X "
        "make one k_l and one b_l, and with half of m_a, 0.1 kg, an arm", "arq-slider", 2,
        (*_PAIR, "vehicle.arms.mass=0.1"),
    ),
    Interpretation(
        "D, letter", "reading D with all of m_a, 0.2 kg, an arm: 2.682 kg in total, as Table II "
        "has it to the letter", "arq-slider", 2, (*_PAIR, "vehicle.arms.mass=0.2"),
    ),
    Interpretation(
        "D, stops", "reading D with stops at a stroke of 30 mm, fitted to the peak accelerations",
        "arq-slider", 2,
        (
            *_PAIR, "vehicle.arms.mass=0.1", "vehicle.arms.end_stops=true",
            "vehicle.arms.stroke=0.03", "vehicle.arms.stop_stiffness=1e6",
        ), ("impact_peak_acceleration",),
    ),
    Interpretation(
        "D, latch", "reading D, letter, with a latch of 39.5 N and 2.1 mm that holds each arm at "
        "its free length, and 18.4 N s/m: three numbers, fitted to ARQ's four on the wall",
        "arq-slider", 2,
        (
            f"vehicle.arms.joint={_LATCHED}", "vehicle.arms.mass=0.2",
            "vehicle.arms.end_stops=true", "model.contact_point=ring",
            f"start.position.0={SLIDER_DISTANCE - ROOM - _RING_REACH!r}",
        ), COUNTED, ("wall",),
    ),
)  # fmt: skip
QUADS = "Quad's restitution"
"""Source of c_a in tests that predict."""
DEFAULT = "B"
"""The reading that the library's vehicles and surfaces have, and every flight."""


def named_reading(text: str) -> Interpretation:
    """A user's reading, ``NAME: key=value key=value``: reading B with changes.

    Raises:
        InputError: If the text has another form.
    """
    name, colon, words = text.partition(":")
    if not colon or not name.strip() or not words.split():
        raise InputError(f"{text!r} is no reading; write 'NAME: key=value key=value'")
    return Interpretation(
        name.strip(), f"reading B with {words.strip()}", "arq-slider", 2, tuple(words.split())
    )


def slider_tables(
    reading: Interpretation,
    surface: str,
    speed: float,
    dissipation: float,
    mass: float | None = None,
) -> dict[str, Any]:
    """The scenario of one slider test, as plain tables.

    Args:
        reading: How to read the parameters.
        surface: ``wall`` or ``mat``.
        speed: At touch [m/s].
        dissipation: c_a [s/m].
        mass: Of the whole robot, if not that of Table II with the sliding bar [kg].
    """
    hit = {
        "preset": surface,
        "shared_by": reading.shared_by,
        "dissipation": dissipation,
        "friction_axes": "vertical",
    }
    if surface == "mat":
        obstacle = {
            "type": "mat", "distance": SLIDER_DISTANCE + MAT_THICKNESS, "thickness": MAT_THICKNESS,
            "surface": hit, "backing": {**hit, "preset": "wall"},
        }  # fmt: skip
    else:
        obstacle = {"type": "wall", "distance": SLIDER_DISTANCE, "surface": hit}
    vehicle: dict[str, Any] = {"preset": reading.vehicle}
    if mass is not None:
        vehicle["body"] = {"mass": mass - reading.arms_mass}
    reach = 0.30 if reading.vehicle == "arq-lumped" else 0.30 * 2.0**-0.5
    return {
        "name": f"{reading.name} on the slider, {surface}, {speed:g} m/s",
        "vehicle": vehicle,
        "world": {"obstacles": [obstacle]},
        "start": {
            "position": [SLIDER_DISTANCE - reach - ROOM, 0.0, 1.0],
            "velocity": [speed, 0.0, 0.0],
        },
        "model": {"contact_point": "paper", "slider": [1.0, 0.0, 0.0]},
        "simulation": {"duration": ROOM / speed + 0.2},
    }


@dataclass(frozen=True)
class Case:
    """One flown slider test."""

    robot: str
    surface: str
    reading: Interpretation
    dissipation: float
    dissipation_from: str
    flight: Flight


@dataclass
class SweepPoint:
    """Peak accelerations of both robots at one speed [m/s, m/s²]."""

    reading: str
    speed: float
    quad: float
    arq: float

    @property
    def gap(self) -> float:
        """Peak acceleration of Quad less that of ARQ [m/s²]."""
        return self.quad - self.arq


@dataclass
class SliderResults:
    """All slider tests, and their comparison with print."""

    cases: list[Case] = field(default_factory=list)
    rows: list[Row] = field(default_factory=list)
    sweep: list[SweepPoint] = field(default_factory=list)
    readings: tuple[Interpretation, ...] = READINGS

    def unique_rows(self, reading: str) -> list[Row]:
        """ARQ's rows of a reading for the printed numbers of Table III, each once.

        Args:
            reading: Name.
        """
        return [
            row
            for row in self.rows
            if (row.experiment, row.robot, row.reading) == ("Table III", "arq", reading)
            and row.quantity in COUNTED
            and row.dissipation_from == QUADS
        ]


def fitted_dissipation(surface: str) -> float:
    """c_a that gives Quad's printed restitution at the printed speed, solved exactly [s/m]."""
    return dissipation_for(TABLE_III["quad", surface].restitution, SLIDER_SPEED)


def _fly(
    reading: Interpretation, surface: str, speed: float, c_a: float, mass: float | None, keep: bool
) -> Flight:
    tables = slider_tables(reading, surface, speed, c_a, mass)
    return fly(tables, *reading.overrides, trajectory=keep)


def _root(error: Callable[[float], float], low: float = 0.0, high: float = 1.5) -> float | None:
    """c_a at which ``error`` vanishes; None if it does not within the range."""
    if error(low) * error(high) > 0.0:
        return None
    return float(scipy.optimize.brentq(error, low, high, xtol=1e-6))


def _printed_of(printed: PrintedImpact, quantity: str) -> tuple[float, float | None]:
    if quantity.startswith("restitution"):
        return printed.restitution, printed.restitution_test
    if quantity == "impact_peak_acceleration":
        return printed.peak_acceleration, printed.peak_acceleration_test
    if quantity == "travel":
        return printed.travel, None
    return printed.contact_time, None


def _rows(case: Case, fitted: str | None) -> list[Row]:
    """Compared numbers of a case; ``fitted`` is the quantity that c_a was fitted to."""
    printed, rows = TABLE_III[case.robot, case.surface], []
    for quantity, unit in QUANTITIES.items():
        ours = case.flight.measures[quantity]
        number, test = _printed_of(printed, quantity)
        equal_by_fit = quantity == fitted or (
            fitted is not None and case.robot == "quad" and quantity.startswith("restitution")
        )
        own = case.reading.fitted if case.surface in case.reading.fitted_on else ()
        chosen = equal_by_fit or quantity in own
        mark = Mark.FITTED if chosen else predicted_or_contradicted(ours, number)
        rows.append(
            Row(
                "Table III", case.robot, case.surface, case.reading.name, quantity, unit,
                ours, number, test, mark, case.dissipation, case.dissipation_from,
            )
        )  # fmt: skip
    return rows


def _input_rows() -> list[Row]:
    library = SURFACES["wall"], SURFACES["mat"]
    given = [
        ("speed at touch", "m/s", SLIDER_SPEED, "section IV-A, about"),
        ("distance of the obstacle, D", "m", SLIDER_DISTANCE, "section IV-A"),
        ("exponent of the contact law, n", "", library[0].exponent, "section IV-A"),
        ("mass of Quad with bar", "kg", 1.892, "Table II, m_rigid"),
        ("mass of ARQ's body with bar", "kg", 1.882, "Table II, m_b"),
        ("mass of ARQ's arms", "kg", 0.2, "Table II, m_a, read as all arms"),
        ("arm stiffness", "N/m", 5e3, "Table II, k_l"),
        ("arm damping", "N s/m", 90.0, "Table II, b_l"),
        ("contact stiffness, wall", "N/m^1.5", library[0].stiffness, "Table II, k_c,wall"),
        ("contact stiffness, mat", "N/m^1.5", library[1].stiffness, "Table II, k_c,mat"),
        (
            "friction coefficient",
            "",
            library[0].friction,
            "Table II, mu; without effect on a slider",
        ),
    ]
    rows = [
        Row("Table II", "", "", "", name, unit, value, value, None, Mark.GIVEN, 0.0, "", note)
        for name, unit, value, note in given
    ]
    return rows + [_range_row(surface) for surface in ("wall", "mat")]


def _range_row(surface: str) -> Row:
    """Comparison of c_a, fitted to Quad's restitution, with the range that is printed for it."""
    c_a, (least, most) = fitted_dissipation(surface), DISSIPATION_RANGE
    nearest = min(max(c_a, least), most)
    return Row(
        "Section IV", "quad", surface, "Quad", "c_a, against the printed range", "s/m", c_a,
        nearest, None, predicted_or_contradicted(c_a, nearest), c_a, QUADS,
        f"printed: {least:g} to {most:g}; a value inside counts as printed itself",
    )  # fmt: skip


def slider_experiments(
    extra_readings: Sequence[Interpretation] = (), progress: Progress = silent
) -> SliderResults:
    """Fly all slider tests: Quad and ARQ, wall and mat, every reading, and the sweep.

    ARQ is flown twice for each reading: with Quad's c_a, which predicts, and with the c_a that
    gives ARQ's own printed restitution, which shows what that would take.
    """
    results = SliderResults(readings=(*READINGS, *extra_readings))
    taken = [QUAD.name, *(reading.name for reading in results.readings)]
    twice = {name for name in taken if taken.count(name) > 1}
    if twice:
        raise InputError(f"reading {', '.join(sorted(twice))} is named twice; names must differ")
    results.rows += _input_rows()
    total = 2 + 4 * len(results.readings) + len(SWEEP_SPEEDS) * len(results.readings)
    done = 0

    def tick() -> None:
        nonlocal done
        done += 1
        progress(done / total)

    for surface in ("wall", "mat"):
        c_a = fitted_dissipation(surface)
        flight = _fly(QUAD, surface, SLIDER_SPEED, c_a, None, True)
        case = Case("quad", surface, QUAD, c_a, QUADS, flight)
        results.cases.append(case)
        results.rows += _rows(case, "restitution_at_separation")
        tick()
    for reading in results.readings:
        for surface in ("wall", "mat"):
            results.cases += (cases := list(_arq_cases(reading, surface)))
            results.rows += _rows(cases[0], None)
            for case in cases[1:]:
                results.rows += _rows(case, "restitution_at_separation")
            tick()
            tick()
        _sweep(reading, results, tick)
    return results


def _arq_cases(reading: Interpretation, surface: str) -> list[Case]:
    c_a = fitted_dissipation(surface)
    flight = _fly(reading, surface, SLIDER_SPEED, c_a, None, True)
    cases = [Case("arq", surface, reading, c_a, QUADS, flight)]
    wanted = TABLE_III["arq", surface].restitution

    def error(trial: float) -> float:
        flown = _fly(reading, surface, SLIDER_SPEED, trial, None, False)
        return (flown.measures["restitution_at_separation"] or 0.0) - wanted

    own = _root(error)
    if own is not None:
        flight = _fly(reading, surface, SLIDER_SPEED, own, None, True)
        cases.append(Case("arq", surface, reading, own, "ARQ's own restitution", flight))
    return cases


def _peak(reading: Interpretation, robot: str, speed: float, c_a: float) -> float:
    flight = _fly(reading, "wall", speed, c_a, FREE_MASS[robot], False)
    return flight.measures["impact_peak_acceleration"] or 0.0


def _sweep(reading: Interpretation, results: SliderResults, tick: Callable[[], None]) -> None:
    """Peak accelerations from 1 to 6 m/s without the bar, and the c_a the printed gap takes."""
    c_a, fastest = fitted_dissipation("wall"), SWEEP_SPEEDS[-1]
    for speed in SWEEP_SPEEDS:
        quad, arq = _peak(QUAD, "quad", speed, c_a), _peak(reading, "arq", speed, c_a)
        results.sweep.append(SweepPoint(reading.name, speed, quad, arq))
        tick()

    def gap(trial: float) -> float:
        return _peak(QUAD, "quad", fastest, trial) - _peak(reading, "arq", fastest, trial)

    def row(ours: float | None, mark: Mark, used: float, source: str, note: str) -> Row:
        return Row(
            "Sweep", "quad - arq", "wall", reading.name, "gap of peak accelerations at 6 m/s",
            "m/s^2", ours, SWEEP_GAP, None, mark, used, source, note,
        )  # fmt: skip

    ours = results.sweep[-1].gap
    results.rows.append(row(ours, predicted_or_contradicted(ours, SWEEP_GAP), c_a, QUADS, ""))
    own = _root(lambda trial: gap(trial) - SWEEP_GAP)
    if own is not None:
        results.rows.append(
            row(
                gap(own),
                Mark.FITTED,
                own,
                "the printed gap",
                "Quad's restitution asks for another c_a",
            )
        )
