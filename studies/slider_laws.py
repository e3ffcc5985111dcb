"""Test which arms and laws explain ARQ's rows of Table III, by the whole program.

    python studies/slider_laws.py

Prints the table of docs/paper/slider_laws.md.

Reading B has the arms as printed, D the front pair as one spring; neither has all four numbers of a
row (docs/decisions/0005).  Each try here adds one thing that arms or surfaces can have.  Its
numbers are fitted to ARQ's four on the wall alone (COR at separation, peak acceleration, travel,
time to return), or to those on the mat if it is a law of mats; with Quad's c_a.  The other row, and
the gap of the peaks at 6 m/s without the bar, are then predictions.

Arms are slides along themselves, which fly as those of the plane do (tests/paper).
"""

from __future__ import annotations

import copy
import math
import warnings
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
import scipy  # its parts are loaded when first used

from springback.paper.printed import FREE_MASS, SLIDER_DISTANCE, SLIDER_SPEED, SWEEP_GAP, TABLE_III
from springback.paper.slider import (
    COUNTED,
    QUAD,
    ROOM,
    Interpretation,
    fitted_dissipation,
    slider_tables,
)
from springback.results.flight import fly

SURFACES = ("wall", "mat")
FAST = 6.0
"""Of the sweep's end [m/s]."""
REACH = 0.19 * math.sqrt(0.5) + 0.11
"""Of the front cages from the main body, level, arms at 45 deg [m]."""
STROKE = 0.1
"""Travel of the slides, longer than any test needs [m]."""
EVALUATIONS = 300
"""Chosen, most of a fit."""
NOTHING = 1e-4
"""Share of its start below which a fitted number is none."""
RESTITUTION_OF_FOAM = 0.6
"""Chosen, near Quad's on the mat."""


class Base(NamedTuple):
    """Arms of a reading of `springback.paper.slider`."""

    mass: float  # of an arm [kg]
    stiffness: float  # [N/m]
    damping: float  # [N s/m]


BASES = {
    "B": Base(0.05, 5e3, 90.0), "D": Base(0.1, 1250.0, 22.5), "D, letter": Base(0.2, 1250.0, 22.5)
}  # fmt: skip


class FittedNumber(NamedTuple):
    """A number of a try, with where it is in the tables."""

    path: str  # of `JOINT`, `HIT` or the scenario, dotted
    name: str
    unit: str  # as printed
    scale: float  # printed per SI
    start: float  # SI, above 0; the search is over its logarithm


class SliderTry(NamedTuple):
    """A reading with something more."""

    name: str
    base: str
    joint: Mapping[str, Any] = {}
    """Keys of the slide."""
    hit: Mapping[str, Any] = {}
    """Keys of the surface that is hit."""
    fitted: tuple[FittedNumber, ...] = ()
    fitted_to: tuple[str, ...] = ("wall",)
    """Rows of Table III that the numbers are fitted to."""
    one_stop: bool = True
    """Whether arms rest against a stop at their free length, or swing to both sides of it."""
    no_dissipation: bool = False
    """Whether the law has no c_a."""


def _joint(path: str, name: str, unit: str, scale: float, start: float) -> FittedNumber:
    return FittedNumber(f"joint.{path}", name, unit, scale, start)


FORCE = _joint("latch.force", "F", "N", 1.0, 40.0)
OPENS = _joint("latch.travel", "d", "mm", 1e3, 2e-3)
SPRING = _joint("stiffness", "k_l", "N/m", 1.0, 1100.0)
DAMPER = _joint("damping", "b_l", "N s/m", 1.0, 16.0)
PRELOAD = _joint("preload", "F_0", "N", 1.0, 20.0)
PLAY = _joint("play", "play", "mm", 1e3, 1e-3)
QUADRATIC = _joint("quadratic", "k_2", "kN/m^2", 1e-3, 5e4)
PLATEAU = FittedNumber("hit.plateau_force", "plateau", "N", 1.0, 250.0)
FRICTION = FittedNumber("hit.friction", "mu", "", 1.0, 0.3)
OTHER_SIDE = _joint("stiffness.1", "k_l, right", "N/m", 1.0, 2500.0)
LATCH: dict[str, Any] = {"latch": {"force": 40.0, "travel": 2e-3}}
BOTH_AXES: dict[str, Any] = {"friction_axes": "both"}
BRISTLES: dict[str, Any] = {**BOTH_AXES, "friction_law": "bristle"}
FOAM: dict[str, Any] = {
    "law": "foam", "restitution": RESTITUTION_OF_FOAM, "stiffness": 4e4, "plateau_force": 250.0,
    "densification_depth": 0.03,
}  # fmt: skip

TRIES = (
    SliderTry("as read", "B", one_stop=False),
    SliderTry("as read", "D", one_stop=False),
    SliderTry("as read", "D, letter", one_stop=False),
    SliderTry("spring and damper fitted", "D", fitted=(SPRING, DAMPER), one_stop=False),
    SliderTry("one-sided springs", "B", {"one_sided": True}),
    SliderTry("one-sided springs", "D", {"one_sided": True}),
    SliderTry("free play", "B", fitted=(PLAY,), one_stop=False),
    SliderTry("free play", "D", fitted=(PLAY,), one_stop=False),
    SliderTry("preload", "B", fitted=(PRELOAD,)),
    SliderTry("preload", "D", fitted=(PRELOAD,)),
    SliderTry("preload, spring, damper", "D", fitted=(PRELOAD, SPRING, DAMPER)),
    SliderTry("quadratic spring beside", "D", fitted=(QUADRATIC,), one_stop=False),
    SliderTry("quadratic spring alone", "B", {"stiffness": 0.0}, fitted=(QUADRATIC,),
              one_stop=False),
    SliderTry("table, steep for 2 mm", "D", {"stiffness": 0.0,
              "table": [[0.0, 0.0], [0.002, 40.0], [STROKE, 40.0 + 1250.0 * STROKE]]},
              fitted=(_joint("table.1.1", "force", "N", 1.0, 30.0),), one_stop=False),
    SliderTry("right arms of another spring", "B", {"stiffness": [5e3] * 4},
              fitted=(OTHER_SIDE,), one_stop=False),
    SliderTry("right arms of another spring", "D", {"stiffness": [1250.0] * 4},
              fitted=(OTHER_SIDE,), one_stop=False),
    SliderTry("latch", "B", LATCH, fitted=(FORCE, OPENS)),
    SliderTry("latch", "D", LATCH, fitted=(FORCE, OPENS)),
    SliderTry("latch, damper", "D", LATCH, fitted=(FORCE, OPENS, DAMPER)),
    SliderTry("latch", "D, letter", LATCH, fitted=(FORCE, OPENS)),
    SliderTry("latch, damper", "D, letter", LATCH, fitted=(FORCE, OPENS, DAMPER)),
    SliderTry("latch, spring, damper", "D", LATCH, fitted=(FORCE, OPENS, SPRING, DAMPER)),
    SliderTry("latch, spring, damper", "B", LATCH, fitted=(FORCE, OPENS, SPRING, DAMPER)),
    SliderTry("latch, spring, damper", "D, letter", LATCH, fitted=(FORCE, OPENS, SPRING, DAMPER)),
    SliderTry("latch, spring, damper, to both rows", "D", LATCH,
              fitted=(FORCE, OPENS, SPRING, DAMPER), fitted_to=SURFACES),
    SliderTry("constant restitution", "B", hit={"law": "constant-restitution"}, one_stop=False,
              no_dissipation=True),
    SliderTry("constant restitution", "D", hit={"law": "constant-restitution"}, one_stop=False,
              no_dissipation=True),
    SliderTry("mat of foam", "B", hit=FOAM, fitted=(PLATEAU,), fitted_to=("mat",),
              one_stop=False, no_dissipation=True),
    SliderTry("mat of foam", "D", hit=FOAM, fitted=(PLATEAU,), fitted_to=("mat",),
              one_stop=False, no_dissipation=True),
    SliderTry("friction along the wall, too", "B", hit=BOTH_AXES, one_stop=False),
    SliderTry("friction along the wall, too", "D", hit=BOTH_AXES, one_stop=False),
    SliderTry("its coefficient fitted", "D", hit=BOTH_AXES, fitted=(FRICTION,), one_stop=False),
    SliderTry("bristles along the wall", "B", hit=BRISTLES, one_stop=False),
    SliderTry("bristles along the wall", "D", hit=BRISTLES, one_stop=False),
    SliderTry("their coefficient fitted", "D", hit=BRISTLES, fitted=(FRICTION,), one_stop=False),
)  # fmt: skip
"""What is tried.  The latch was tried first with other starts; what it found is where its search
starts here, and arms "to the letter" were added once it agreed."""


class Numbers(NamedTuple):
    """The four numbers of a row, `springback.paper.slider.COUNTED`."""

    restitution: float
    peak: float  # [m/s²]
    travel: float  # [m]
    back: float  # time until the body is back [s]


def tables_of(
    tried: SliderTry,
    surface: str,
    values: tuple[float, ...],
    *,
    speed: float = SLIDER_SPEED,
    mass: float | None = None,
) -> dict[str, Any]:
    """The scenario of a try.

    Args:
        tried: The try.
        surface: ``wall`` or ``mat``.
        values: Of its fitted numbers, SI.
        speed: At touch [m/s].
        mass: Of the whole robot, if not that with the sliding bar [kg].
    """
    base = BASES[tried.base]
    joint = {
        "type": "slide", "direction": [-1.0, 0.0, 0.0], "stiffness": base.stiffness,
        "travel": [0.0 if tried.one_stop else -STROKE, STROKE], "damping": base.damping,
        **copy.deepcopy(dict(tried.joint)),
    }  # fmt: skip
    hit = copy.deepcopy(dict(tried.hit))
    roots = {"joint": joint, "hit": hit}
    for number, value in zip(tried.fitted, values, strict=True):
        _put(roots, number.path.split("."), value)
    reading = Interpretation(tried.name, "", "arq-slider", 2)
    c_a = fitted_dissipation(surface)
    tables = slider_tables(reading, surface, speed, c_a)
    tables["model"]["contact_point"] = "ring"  # as good as the paper's while level
    tables["start"]["position"][0] = SLIDER_DISTANCE - REACH - ROOM
    tables["vehicle"]["arms"] = {"joint": joint, "mass": base.mass, "end_stops": True}
    if mass is not None:
        tables["vehicle"]["body"] = {"mass": mass - 4.0 * base.mass}
    if hit and surface in (tried.fitted_to if hit.get("law") == "foam" else SURFACES):
        [obstacle] = tables["world"]["obstacles"]
        faces = [obstacle["surface"], *([obstacle["backing"]] if "backing" in obstacle else [])]
        for face in faces[: 1 if hit.get("law") == "foam" else 2]:
            if tried.no_dissipation:
                del face["dissipation"]
            if hit.get("law") == "constant-restitution":
                face["restitution"] = TABLE_III["quad", surface].restitution
            if hit.get("law") == "foam":
                del face["preset"]
                face["friction"] = 0.8
            face.update(hit)
    return tables


def _put(roots: Any, path: list[str], value: float) -> None:
    """Set a number of nested tables and lists."""
    node = roots
    for key in path[:-1]:
        node = node[int(key)] if isinstance(node, list) else node[key]
    last = path[-1]
    if isinstance(node, list):  # of arms: right ones are 1 and 2; of a table: force, and beyond
        if len(node) == 4:
            node[1] = node[2] = value
        else:
            node[int(last)] = value
        return
    node[last] = value


def flown(tried: SliderTry, surface: str, values: tuple[float, ...]) -> Numbers:
    """The four numbers of a try on a surface."""
    with warnings.catch_warnings():  # of ledgers, where a search goes astray
        warnings.simplefilter("ignore")
        m = fly(tables_of(tried, surface, values), trajectory=False).measures
    return Numbers(*(math.nan if m[name] is None else float(m[name]) for name in COUNTED))


def deviations(tried: SliderTry, surface: str, values: tuple[float, ...]) -> list[float]:
    """Of the four numbers of a row from print, relative."""
    p = TABLE_III["arq", surface]
    printed = (p.restitution, p.peak_acceleration, p.travel, p.contact_time)
    ours = flown(tried, surface, values)
    return [a / b - 1.0 for a, b in zip(ours, printed, strict=True)]


def fit(tried: SliderTry) -> tuple[float, ...]:
    """The numbers of a try that make its root mean square deviation least, SI."""
    starts = np.array([number.start for number in tried.fitted])
    if not len(starts):
        return ()

    def error(logarithms: Any) -> float:
        values = tuple((starts * np.exp(logarithms)).tolist())
        try:
            off = np.array([deviations(tried, one, values) for one in tried.fitted_to])
        except ValueError:  # out of what the settings allow
            return 1e3
        return float(np.sqrt(np.mean(np.nan_to_num(off, nan=1.0) ** 2)))

    count = len(starts)
    corners = np.vstack([np.zeros(count), 0.3 * np.eye(count)])
    found = scipy.optimize.minimize(
        error, np.zeros(count), method="Nelder-Mead",
        options={"maxfev": EVALUATIONS, "initial_simplex": corners, "xatol": 1e-3, "fatol": 1e-5},
    )  # fmt: skip
    return tuple((starts * np.exp(found.x)).tolist())


class Found(NamedTuple):
    """A try, as it came out."""

    tried: SliderTry
    values: tuple[float, ...]  # of its fitted numbers, SI
    off: tuple[float, ...]  # of the wall's four numbers and the mat's, relative
    gap: float  # of the peaks at 6 m/s, Quad less ARQ [m/s²]

    def agree(self, within: float, *, predicted: bool = False) -> int:
        """How many of the eight are within a share: of all, or of those not fitted to."""
        rows = [
            surface for surface in SURFACES
            if not (predicted and self.tried.fitted and surface in self.tried.fitted_to)
        ]  # fmt: skip
        return sum(
            abs(one) <= within
            for k, one in enumerate(self.off)
            if SURFACES[k // len(COUNTED)] in rows
        )


def gap(tried: SliderTry, values: tuple[float, ...]) -> float:
    """Peak of Quad less that of ARQ at 6 m/s on the wall, without the bar [m/s²]."""
    quad = slider_tables(QUAD, "wall", FAST, fitted_dissipation("wall"), FREE_MASS["quad"])
    arq = tables_of(tried, "wall", values, speed=FAST, mass=FREE_MASS["arq"])
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        peaks = [fly(one, trajectory=False).measures for one in (quad, arq)]
    first, second = (one["impact_peak_acceleration"] or math.nan for one in peaks)
    return float(first - second)


def run(tried: SliderTry) -> Found:
    """Fit a try and fly it."""
    values = fit(tried)
    off = [one for surface in SURFACES for one in deviations(tried, surface, values)]
    return Found(tried, values, tuple(off), gap(tried, values))


def _shown(number: FittedNumber, value: float) -> str:
    """A fitted number as printed; one that the search has taken away is 0."""
    return f"{number.scale * value:.3g}" if value > NOTHING * number.start else "0"


def row(found: Found) -> str:
    """A line of the table."""
    tried = found.tried
    numbers = ", ".join(
        f"{number.name} {_shown(number, value)} {number.unit}".strip()
        for number, value in zip(tried.fitted, found.values, strict=True)
    )
    cells = [
        f"{100 * one:+.0f} %" + (" *f*" if tried.fitted and surface in tried.fitted_to else "")
        for surface, one in zip(np.repeat(SURFACES, len(COUNTED)), found.off, strict=True)
    ]
    counts = [str(found.agree(share)) for share in (0.05, 0.10)]
    words = [f"{tried.base}: {tried.name}", numbers or "–", *cells, *counts, f"{found.gap:.0f}"]
    return f"| {' | '.join(words)} |"


def main() -> None:
    """Fit and fly all of them."""
    heads = [f"{what}, {surface}" for surface in SURFACES
             for what in ("COR", "peak", "travel", "time")]  # fmt: skip
    print(f"| | fitted | {' | '.join(heads)} | within 5 % | within 10 % | gap, {SWEEP_GAP:.0f} |")
    print("|:---|:---|" + "---:|" * 11)
    for tried in TRIES:
        print(row(run(tried)), flush=True)


if __name__ == "__main__":
    main()
