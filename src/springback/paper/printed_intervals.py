"""Table III as data: every printed number is an interval, that of its rounding.

The speed is printed as "about 1.85 m/s".  Quad's restitution and that speed, each within half a
unit of its last digit, give an interval of c_a; what a reading predicts for ARQ over that interval
is compared with what is printed within its rounding.  A number passes if the two intervals meet.

The second question asks less: is there any c_a, and any speed within 5 % of the printed one, with
which a reading gives all four numbers of a column?  `nearest` seeks them, and tells the largest
deviation that is left.

    python -m springback.paper.printed_intervals
"""

from __future__ import annotations

import itertools
import sys
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.contact.laws.restitution import dissipation_for
from springback.paper.printed import SLIDER_SPEED, TABLE_III
from springback.paper.slider import COUNTED, QUAD, READINGS, Interpretation, slider_tables
from springback.results.flight import fly

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Half a unit of the last printed digit of each number, in SI.
ROUNDED = {
    "restitution_at_separation": 5e-4, "impact_peak_acceleration": 0.5, "travel": 5e-4,
    "time_to_return": 5e-4,
}  # fmt: skip
#: The same of the speed [m/s], and how far it may be from it in `nearest`, as a share (chosen).
ROUNDED_SPEED, NEAR = 5e-3, 0.05
#: Largest c_a that is tried [s/m], and grid over it and the speed from which a search begins.
MOST, GRID = 1.2, (9, 5)
#: Steps of such a search at most (chosen).
EVALUATIONS = 120
SURFACES = ("wall", "mat")
#: Names of the four numbers in the table.
SHORT = dict(zip(COUNTED, ("COR", "peak", "travel", "time"), strict=True))
#: Readings without a number that was fitted to ARQ's.
UNFITTED = tuple(one for one in READINGS if not one.fitted)


class PrintedInterval(NamedTuple):
    """A number between two ends."""

    low: float
    high: float

    def meets(self, other: PrintedInterval) -> bool:
        """True if they have a number in common."""
        return self.low <= other.high and other.low <= self.high


class ColumnNumber(NamedTuple):
    """One number of a column of Table III, printed and predicted."""

    quantity: str  # of `COUNTED`
    printed: PrintedInterval
    predicted: PrintedInterval

    @property
    def passes(self) -> bool:
        """True if prediction and print meet."""
        return self.printed.meets(self.predicted)


class NearestColumn(NamedTuple):
    """The c_a and the speed with which a reading is closest to a column."""

    dissipation: float  # c_a [s/m]
    speed: float  # [m/s]
    worst: str  # quantity that is farthest from print there
    deviation: float  # of it, relative


def printed_column(robot: str, surface: str) -> dict[str, PrintedInterval]:
    """Printed numbers of a column within their rounding, by quantity.

    Args:
        robot: ``quad`` or ``arq``.
        surface: ``wall`` or ``mat``.
    """
    printed = TABLE_III[robot, surface]
    values = (printed.restitution, printed.peak_acceleration, printed.travel, printed.contact_time)
    return {
        quantity: PrintedInterval(value - ROUNDED[quantity], value + ROUNDED[quantity])
        for quantity, value in zip(COUNTED, values, strict=True)
    }


def conditions(surface: str) -> list[tuple[float, float]]:
    """Speeds [m/s] and the c_a [s/m] that give Quad's restitution at them, to the rounding's ends.

    Args:
        surface: ``wall`` or ``mat``.
    """
    restitution = printed_column("quad", surface)[COUNTED[0]]
    speeds = SLIDER_SPEED - ROUNDED_SPEED, SLIDER_SPEED + ROUNDED_SPEED
    return [(v, dissipation_for(e, v)) for v, e in itertools.product(speeds, restitution)]


def dissipation_interval(surface: str) -> PrintedInterval:
    """c_a that Quad's printed restitution allows [s/m].

    Args:
        surface: ``wall`` or ``mat``.
    """
    found = [c_a for _, c_a in conditions(surface)]
    return PrintedInterval(min(found), max(found))


def slider_numbers(reading: Interpretation, surface: str, speed: float, c_a: float) -> Array:
    """The four numbers of a slider test [1, m/s², m, s], in the order of `COUNTED`.

    Args:
        reading: Of the printed parameters.
        surface: ``wall`` or ``mat``.
        speed: At touch [m/s].
        c_a: [s/m].
    """
    flight = fly(slider_tables(reading, surface, speed, c_a), *reading.overrides, trajectory=False)
    return np.array([flight.measures[one] for one in COUNTED], dtype=float)


def compared_column(reading: Interpretation, surface: str) -> list[ColumnNumber]:
    """A column of Table III, printed and predicted over what Quad's rounding allows.

    Args:
        reading: Of the printed parameters; Quad's for its own columns.
        surface: ``wall`` or ``mat``.
    """
    robot = "quad" if reading is QUAD else "arq"
    told = np.array([
        slider_numbers(reading, surface, v, c_a) for v, c_a in conditions(surface)
    ])  # fmt: skip
    printed = printed_column(robot, surface)
    return [
        ColumnNumber(quantity, printed[quantity], PrintedInterval(low, high))
        for quantity, low, high in zip(
            COUNTED, told.min(axis=0).tolist(), told.max(axis=0).tolist(), strict=True
        )
    ]


def nearest(reading: Interpretation, surface: str) -> NearestColumn:
    """The c_a and the speed with which the farthest of ARQ's four numbers is nearest to print.

    Args:
        reading: Of the printed parameters.
        surface: ``wall`` or ``mat``.
    """
    wanted = np.array([0.5 * sum(one) for one in printed_column("arq", surface).values()])
    slowest, fastest = (1.0 - NEAR) * SLIDER_SPEED, (1.0 + NEAR) * SLIDER_SPEED

    def deviations(point: Sequence[float] | Array) -> Array:
        c_a, speed = np.clip(point, (0.0, slowest), (MOST, fastest)).tolist()
        told = slider_numbers(reading, surface, speed, c_a) / wanted - 1.0
        return np.where(np.isnan(told), 1.0, told)

    def worst(point: Sequence[float] | Array) -> float:
        return float(np.abs(deviations(point)).max())

    grid = itertools.product(
        np.linspace(0.0, MOST, GRID[0]).tolist(), np.linspace(slowest, fastest, GRID[1]).tolist()
    )
    found = scipy.optimize.minimize(
        worst, min(grid, key=worst), method="Nelder-Mead",
        options={"maxfev": EVALUATIONS, "xatol": 1e-4, "fatol": 1e-5},
    )  # fmt: skip
    rest = deviations(found.x)
    k = int(np.abs(rest).argmax())
    c_a, speed = np.clip(found.x, (0.0, slowest), (MOST, fastest)).tolist()
    return NearestColumn(c_a, speed, COUNTED[k], float(rest[k]))


def interval_lines() -> Iterator[str]:
    """Lines of the table of docs/paper/table_iii.md."""
    for surface in SURFACES:
        low, high = dissipation_interval(surface)
        yield f"c_a of the {surface}: {low:.4f} to {high:.4f} s/m"
    yield ""
    numbers = "COR | peak [m/s²] | travel [mm] | time [ms]"
    yield f"| | {numbers} | pass | closest with any c_a and speed |"
    yield "|---|---|---|---|---|---|---|"
    scales, decimals = (1.0, 1.0, 1e3, 1e3), (4, 1, 2, 2)
    for robot, readings in (("quad", (QUAD,)), ("arq", UNFITTED)):
        for surface in SURFACES:
            printed = printed_column(robot, surface).values()
            cells = [
                f"{one.low * by:.{n}f} to {one.high * by:.{n}f}"
                for one, by, n in zip(printed, scales, decimals, strict=True)
            ]
            name = "Quad" if robot == "quad" else "ARQ"
            yield f"| **{name}, {surface}, printed** | {' | '.join(cells)} | | |"
            for reading in readings:
                column = compared_column(reading, surface)
                cells = [
                    f"{one.predicted.low * by:.{n}f} to {one.predicted.high * by:.{n}f} "
                    + ("✓" if one.passes else "✗")
                    for one, by, n in zip(column, scales, decimals, strict=True)
                ]
                best = ""
                if robot == "arq":
                    near = nearest(reading, surface)
                    best = (
                        f"{near.dissipation:.2f} s/m, {near.speed:.2f} m/s: "
                        f"{SHORT[near.worst]} {100.0 * near.deviation:+.0f} %"
                    )
                passed = sum(one.passes for one in column)
                yield f"| {reading.name} | {' | '.join(cells)} | {passed} of 4 | {best} |"


if __name__ == "__main__":
    for line in interval_lines():
        sys.stdout.write(line + "\n")
