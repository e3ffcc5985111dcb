"""Drops of a flexible frame predicted from higher up, and of its rigid twin without a fit.

The frame is the preset `cognifly`: a rigid body on four upright rods that yield by the law of
constant restitution.  Two numbers are fitted, at 50 cm alone: stiffness and restitution.  What they
predict at 100 and 150 cm is read as the recordings are, by `drop_measures`.

The stiffness of the rigid twin is not fitted: it fell on its battery holder, a printed box, whose
stiffness follows from its material and shape.

    python -m springback.studies.recordings.drop_predictions [FOLDER]
"""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from springback.results.flight import Flight, fly
from springback.studies.recordings.command import run_study
from springback.studies.recordings.frame_drops import (
    CASES,
    PERIOD,
    RECORDED,
    DropCase,
    DropMeasures,
    DropStatistics,
    drop_measures,
    fall_time,
    read_drops,
    statistics_of,
)
from springback.vehicle.endurance import GRAVITY
from springback.vehicle.library import VEHICLES
from springback.vehicle.materials import MATERIALS
from springback.vehicle.stiffness import pad_stiffness

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Stiffness of the frame when it is pressed slowly, as its authors measured it [N/m].
STATIC = 7040.0
#: Flights are read from each of so many instants within a period, and the median is taken.
PHASES = 10
#: Time flown after the first touch [s] (chosen: the second touch is within it); and of the block,
#: of which only the first contact is asked.
AFTER, FIRST = 0.6, 0.02
#: Longest step in a contact [s], and that times the square root of stiffness over mass (chosen: the
#: ledgers then close to 1e-6).
IMPACT_STEP, FINE = 1e-4, 0.03
#: Bounds of the restitution of a fit, and how often they are halved.
RESTITUTIONS, HALVED = (0.05, 0.6), 14
#: Highest drop recorded [m], once, on a table of pine, and its largest reading [g], close to the
#: end of the sensor's range.
HIGHEST, AT_LEAST = 2.62, 189.0


class FrameLaw(NamedTuple):
    """What was fitted, or derived, of a frame."""

    stiffness: float  # of its four rods together [N/m]
    restitution: float  # of the law, the same at any speed


#: The printed box: the part ``Battery_holder_magnetic_main`` of ``thecognifly/CogniFly-STL`` has
#: 6849 mm³ of material and is 20.5 mm high; it is of PLA or ABS, here of PLA, filled.
BLOCK_VOLUME, BLOCK_HEIGHT = 6849e-9, 20.5e-3


def block_law() -> FrameLaw:
    """The printed box, pressed along its height; modulus and restitution are typical of PLA."""
    pla = MATERIALS["pla"]
    assert pla.young is not None
    assert pla.restitution is not None
    area = BLOCK_VOLUME / BLOCK_HEIGHT
    return FrameLaw(pad_stiffness(pla.young.typical, area, BLOCK_HEIGHT), pla.restitution.typical)


def drop_flight(law: FrameLaw, case: DropCase, after: float = AFTER) -> Flight:
    """Let the vehicle go, level and with its rotors off, above hard ground.

    Args:
        law: Of its frame.
        case: Vehicle and height.
        after: Time flown after the first touch [s].
    """
    vehicle = VEHICLES[case.vehicle].vehicle
    tables, rate = vehicle.model_dump(), math.sqrt(law.stiffness / vehicle.mass)
    lowest = 0.0
    for hull in tables["hulls"]:
        hull["surface"] |= {
            "stiffness": law.stiffness / len(tables["hulls"]), "restitution": law.restitution,
        }  # fmt: skip
        lowest = min(lowest, hull["start"][2] - hull["radius"], hull["end"][2] - hull["radius"])
    return fly(
        {
            "vehicle": tables,
            "thrust": 0.0,
            "world": {"obstacles": [{"type": "ground", "surface": "wall"}]},
            "start": {"position": [0.0, 0.0, case.height - lowest]},
            "simulation": {
                "duration": fall_time(case.height) + after,
                "impact_step": min(IMPACT_STEP, FINE / rate),
            },
        }
    )


def specific_force(flight: Flight) -> Array:
    """Size of the specific force of the main body at each recorded time [g]."""
    c = flight.columns
    return np.asarray(np.sqrt(c["ax"] ** 2 + c["ay"] ** 2 + (c["az"] + GRAVITY) ** 2) / GRAVITY)


def measures_of(flight: Flight, height: float) -> DropMeasures:
    """What the recordings' sensor would have read: medians over `PHASES`."""
    force, found = specific_force(flight), []
    for phase in range(PHASES):
        times = np.arange(PERIOD * phase / PHASES, flight.t[-1], PERIOD)
        found.append(drop_measures(np.interp(times, flight.t, force), height))
    peak, rise, restitution = np.median(np.array(found), axis=0).tolist()
    return DropMeasures(peak, rise, restitution)


def predict_drop(law: FrameLaw, case: DropCase) -> DropMeasures:
    """Measures of one drop."""
    return measures_of(drop_flight(law, case), case.height)


def fit_law(case: DropCase = CASES[0], recorded: DropStatistics | None = None) -> FrameLaw:
    """Stiffness and restitution with which a drop has the recorded median peak and restitution.

    Args:
        case: The height that is fitted to.
        recorded: What was recorded there; by default what is kept of it here.
    """
    wanted = RECORDED[case.folder] if recorded is None else recorded
    law = FrameLaw(STATIC, wanted.restitution.median)
    low, high = RESTITUTIONS
    for _ in range(HALVED):
        found = predict_drop(law, case)
        # One that hardly rebounds is not read to fly at all.
        if found.restitution >= wanted.restitution.median:
            high = law.restitution
        else:
            low = law.restitution
        stiffness = law.stiffness * (wanted.peak.median / found.peak) ** 2
        law = FrameLaw(stiffness, 0.5 * (low + high))
    return law


#: Fitted at 50 cm by `fit_law`, to the median peak and restitution, before anything else was flown.
FROZEN = FrameLaw(stiffness=18907.0, restitution=0.2182)
#: The twin's peak should be predicted within this factor.
WANTED = 1.5


def drop_lines(folder: Path | None) -> Iterator[str]:
    """What is predicted of each case, beside what was recorded.

    Args:
        folder: Of the user's own copy, from which medians and quartiles are computed; None: those
            that are kept here are used.
    """
    recorded = RECORDED if folder is None else {
        case.folder: statistics_of(read_drops(folder, case)) for case in CASES
    }  # fmt: skip
    yield (
        f"cognifly: {FROZEN.stiffness:.0f} N/m, {FROZEN.stiffness / STATIC:.2f} times as much as "
        f"when pressed slowly, restitution {FROZEN.restitution:.3f}; fitted at 50 cm"
    )
    block = block_law()
    yield (
        f"cognifly-rigid: {block.stiffness / 1e6:.1f} MN/m, restitution {block.restitution:.2f}, "
        "of its printed box; not fitted"
    )
    for case in CASES:
        there = recorded[case.folder]
        name = f"{case.vehicle}, {1e2 * case.height:.0f} cm"
        if case.vehicle != "cognifly":
            flight = drop_flight(block, case, FIRST)
            highest = float(specific_force(flight).max())
            factor = max(highest / there.peak.median, there.peak.median / highest)
            yield (
                f"{name}: peak {highest:.0f} g, recorded {there.peak.median:.0f} g: a factor of "
                f"{factor:.1f} ({WANTED:g} wanted); contact for {contact_time(flight):.2g} ms"
            )
            continue
        found = predict_drop(FROZEN, case)
        for what, value, spread, scale, unit in (
            ("peak", found.peak, there.peak, 1.0, " g"),
            ("time to peak", found.rise, there.rise, 1e3, " ms"),
            ("restitution", found.restitution, there.restitution, 1.0, ""),
        ):
            inside = "within" if spread.holds(value) else "outside"
            yield (
                f"{name}: {what} {value * scale:.3g}{unit}, recorded {spread.median * scale:.3g}"
                f"{unit}, quartiles {spread.low * scale:.3g} to {spread.high * scale:.3g}: {inside}"
                f" ({there.drops} drops)"
            )
    once = predict_drop(FROZEN, DropCase("", "cognifly", HIGHEST))
    yield (
        f"cognifly, {1e2 * HIGHEST:.0f} cm: peak {once.peak:.0f} g, recorded once, at least "
        f"{AT_LEAST:.0f} g"
    )


def contact_time(flight: Flight) -> float:
    """Duration of the first contact [ms]; NaN if it does not end."""
    m = flight.measures
    touch, left = m["touch_time"], m["separation_time"]
    return float("nan") if touch is None or left is None else 1e3 * (left - touch)


if __name__ == "__main__":
    sys.exit(run_study(drop_lines, sys.argv[1:]))
