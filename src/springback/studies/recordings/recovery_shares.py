"""Shares of wall hits from which a guarded quadrotor recovers, beside its makers' simulator.

F. Chui and G. Dicker, McGill, flew 10 000 simulated hits of their robot Navi (repository
``McGill-AML/RecoveryControl-MATLABSimulator``, branch ``recovery``; no licence: nothing of it is
here but the shares).  This is code against code, no measurement.  The same initial conditions are
drawn here, the preset `navi` has their bumpers, and the pilot is springback's own with the response
``staged``, which follows theirs; their fuzzy choice of how hard to tilt away is not ported: it
tilts by 0.75 g.

There pitch is negative where the robot leans into the wall; here it is positive (FLU axes).

    python -m springback.studies.recordings.recovery_shares
"""

from __future__ import annotations

import math
import os
import sys
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from springback.batch.scenarios import Rows, fly_scenarios
from springback.errors import InputError
from springback.intervals import IntervalEstimate, share
from springback.kernels.vectors import Vec, rotation
from springback.random_streams import Purpose, stream
from springback.scenario.tables import Start
from springback.simulation.measuring.measures import Outcome
from springback.studies.recordings.command import run_study
from springback.vehicle.arms.paths import free_end_along
from springback.vehicle.hulls import hull_reach
from springback.vehicle.library import VEHICLES
from springback.vehicle.parameters import Vehicle

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Speed into the wall [m/s], and attitude: within these either way [deg]; all even, as there.
SPEEDS, PITCH, YAW, ROLL = (0.5, 2.5), 45.0, 45.0, 15.0
#: Height at which the robot hits the wall: there 5 m, and no ground [m].
HEIGHT = 5.0
#: Distance of the bumpers from the wall at the start [m]: there up to 60 mm, without a pilot; here
#: so little that the pilot cannot turn the robot before the hit.
CLEARANCE = 1e-3
#: Time flown [s]: there 3; here longer, as a robot must be at rest at a place, not only upright.
DURATION = 8.0
#: Flights, and the seed of their draws.
FLIGHTS, SEED = 3000, 21
#: Edges of the bins of pitch [deg], nose up to nose down.
EDGES = (-45.0, -30.0, -15.0, 0.0, 15.0, 30.0, 45.0)
#: Share of each bin that reached the third stage of recovery there, of some 1667 flights each.
PRINTED = (1.0, 1.0, 1.0, 1.0, 0.98, 0.54)
PRINTED_FLIGHTS = 10_000 // len(PRINTED)
#: Median loss of height there, of those that recovered [m], from nose up on.
PRINTED_LOSS = (2.0, 1.1, 0.2)


class RecoveryCase(NamedTuple):
    """What is changed of all hits."""

    name: str
    detection: dict[str, Any] = {}  # noqa: RUF012 - never changed
    propulsion: dict[str, Any] = {}  # noqa: RUF012


#: Half of g, at which their robot notices a contact [m/s²]; the default here is 20 m/s².
HALF_G = {"acceleration": {"threshold": 0.5 * 9.81}}
#: Rotors whose guard is hit stop, as recordings of guarded quadrotors show; the force and the time
#: until they turn again are chosen, as in docs/howto/hulls.md, and so is that all others follow.
FRONT_STOPS = {"stop": {"guard_force": 20.0, "restart_after": 0.15}}
ALL_STOP = {"stop": {**FRONT_STOPS["stop"], "others_after": 0.04}}
#: As before, and with what the first hits were suspected of; frozen before they were flown.
CASES = (
    RecoveryCase("default trigger, rotors turn on"),
    RecoveryCase("trigger at 0.5 g", HALF_G),
    RecoveryCase("rotors stop whose guard is hit", {}, FRONT_STOPS),
    RecoveryCase("these stop, trigger at 0.5 g", HALF_G, FRONT_STOPS),
    RecoveryCase("all rotors stop, trigger at 0.5 g", HALF_G, ALL_STOP),
)


class WallStart(NamedTuple):
    """Initial condition of one flight."""

    speed: float  # [m/s]
    roll: float  # [rad]
    pitch: float  # positive nose down, towards the wall [rad]
    yaw: float  # [rad]


def draw_hits(flights: int = FLIGHTS, seed: int = SEED) -> list[WallStart]:
    """Initial conditions, even within their bounds; each by its number and the seed alone."""
    found = []
    for k in range(flights):
        u = stream(seed, Purpose.TRIAL, k).uniform(-1.0, 1.0, 4).tolist()
        middle, half = 0.5 * (SPEEDS[0] + SPEEDS[1]), 0.5 * (SPEEDS[1] - SPEEDS[0])
        roll, pitch, yaw = (
            math.radians(bound) * x for bound, x in zip((ROLL, PITCH, YAW), u[1:], strict=True)
        )
        found.append(WallStart(middle + half * u[0], roll, pitch, yaw))
    return found


def reach(vehicle: Vehicle, start: Start) -> float:
    """Distance of the foremost point along world x, at the start's attitude [m]."""
    r = rotation(start.attitude())
    ahead = Vec(r.x.x, r.x.y, r.x.z)  # world x in body axes
    airframe = vehicle.airframe()
    points = [hull_reach(hull, ahead) for hull in airframe.hull]
    for arm in airframe.arms:
        along = free_end_along(arm, ahead)
        points += [along + hull_reach(hull, ahead) for hull in arm.hull]
    return max(points)


def hit_tables(hit: WallStart, seed: int, case: RecoveryCase = CASES[0]) -> dict[str, Any]:
    """The scenario of one hit, rotors at hover thrust, 5 m above the ground."""
    start = {
        "position": (0.0, 0.0, HEIGHT),
        "velocity": (hit.speed, 0.0, 0.0),
        "roll": hit.roll,
        "pitch": hit.pitch,
        "yaw": hit.yaw,
    }
    distance = reach(VEHICLES["navi"].vehicle, Start.model_validate(start)) + CLEARANCE
    return {
        "vehicle": {"preset": "navi", "propulsion": case.propulsion},
        "reference": {"type": "hold", "position": [0.0, 0.0, HEIGHT]},
        "recovery": {
            "response": {"way": "staged"},
            "returns": False,
            "detection": case.detection,
        },
        "world": {
            "obstacles": [
                {"type": "wall", "distance": distance, "surface": "wall"},
                {"type": "ground", "surface": "wall"},
            ]
        },
        "start": start,
        "seed": seed,
        "simulation": {"duration": DURATION},
    }


class RecoveryShare(NamedTuple):
    """Of the hits with a pitch between two bounds."""

    low: float  # [deg]
    high: float
    recovered: IntervalEstimate  # with Wilson's interval
    printed: IntervalEstimate
    flights: int
    height_loss: float  # median of those that recovered [m]


def shares_of(hits: list[WallStart], rows: Rows) -> list[RecoveryShare]:
    """Shares by pitch, from nose up to nose down."""
    pitch = np.degrees([hit.pitch for hit in hits])
    good = np.array([outcome == Outcome.RECOVERED.word for outcome in rows.outcomes])
    found = []
    for (low, high), printed in zip(pairwise(EDGES), PRINTED, strict=True):
        here = (pitch >= low) & (pitch < high)
        loss = rows.measures["height_loss"][here & good]
        found.append(
            RecoveryShare(
                low, high, share(int((here & good).sum()), int(here.sum())),
                share(round(printed * PRINTED_FLIGHTS), PRINTED_FLIGHTS), int(here.sum()),
                float(np.median(loss)) if len(loss) else math.nan,
            )
        )  # fmt: skip
    return found


def in_order(shares: list[RecoveryShare]) -> bool:
    """True if bins that differ there come in the same order here."""
    return all(
        (a.recovered.value or 0.0) > (b.recovered.value or 0.0)
        for a in shares for b in shares
        if (a.printed.value or 0.0) > (b.printed.value or 0.0)
    )  # fmt: skip


def fly_hits(hits: list[WallStart], case: RecoveryCase = CASES[0]) -> Rows:
    """Fly all hits, side by side; the seed of the noise of each is its number."""
    tables = [hit_tables(hit, k, case) for k, hit in enumerate(hits)]
    return fly_scenarios(tables, threads=os.cpu_count() or 1)


def _percent(one: IntervalEstimate) -> str:
    value, low, high = (100.0 * (x or 0.0) for x in one)
    return f"{value:.1f} % ({low:.1f} to {high:.1f})"


def _meet(a: IntervalEstimate, b: IntervalEstimate) -> bool:
    return (a.low or 0.0) <= (b.high or 0.0) and (b.low or 0.0) <= (a.high or 0.0)


def _lines_of(hits: list[WallStart], rows: Rows) -> Iterator[str]:
    shares = shares_of(hits, rows)
    for one in shares:
        meets = "overlap" if _meet(one.recovered, one.printed) else "do not overlap"
        yield (
            f"pitch {one.low:g} to {one.high:g} deg: {_percent(one.recovered)} of {one.flights} "
            f"recovered, there {_percent(one.printed)}: intervals {meets}; median loss of height "
            f"{one.height_loss:.2f} m"
        )
    yield f"bins that differ there are in that order here: {'yes' if in_order(shares) else 'no'}"
    counts = {word: rows.outcomes.count(word) for word in dict.fromkeys(rows.outcomes)}
    yield "outcomes: " + ", ".join(f"{word} {count}" for word, count in counts.items())


def share_lines(folder: Path | None = None, flights: int = FLIGHTS) -> Iterator[str]:
    """Fly all hits in each case, and say what share recovered.

    Raises:
        InputError: If a folder is named: there is none to read.
    """
    if folder is not None:
        raise InputError(f"{folder}: this study reads no recordings; name nothing")
    hits = draw_hits(flights)
    for case in CASES:
        yield f"{case.name}:"
        yield from _lines_of(hits, fly_hits(hits, case))


if __name__ == "__main__":
    sys.exit(run_study(share_lines, sys.argv[1:]))
