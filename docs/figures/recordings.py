"""Pictures of docs/recordings.md: predictions beside what was recorded, or flown by others.

python docs/figures/recordings.py [FOLDER [joint_step.csv]]

The release of an arm is drawn from a copy of its recording; of drops only the medians and quartiles
are drawn that the package keeps.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np

mpl.use("Agg")
import matplotlib.pyplot as plt

from springback.interfaces.figures.style import STYLE as STYLES
from springback.studies.recordings.arm_release import COMPARED, predict_release, read_release
from springback.studies.recordings.drop_predictions import (
    AT_LEAST,
    FROZEN,
    HIGHEST,
    predict_drop,
)
from springback.studies.recordings.frame_drops import CASES, RECORDED, DropCase, fall_time
from springback.studies.recordings.recovery_shares import draw_hits, fly_hits, shares_of
from springback.vehicle.endurance import GRAVITY

HERE = Path(__file__).parent
STYLE = STYLES[-1]
BLUE, ORANGE, GREY = "#0072b2", "#d55e00", "#777777"
#: Heights of the curves of predictions [m].
HEIGHTS = np.geomspace(0.2, HIGHEST, 24)


def speed(height: float) -> float:
    """Of a fall [m/s]."""
    return GRAVITY * fall_time(height)


def drops() -> Any:
    """Peak, time to peak and restitution over the speed at touch."""
    figure, axes = plt.subplots(1, 3, figsize=(9.0, 2.9))
    found = [predict_drop(FROZEN, DropCase("", "cognifly", float(h))) for h in HEIGHTS]
    speeds = [speed(h) for h in HEIGHTS]
    soft = [case for case in CASES if case.vehicle == "cognifly"]
    for ax, name, scale, label in zip(
        axes, ("peak", "rise", "restitution"), (1.0, 1e3, 1.0),
        ("Peak [g]", "Time to peak [ms]", "Restitution [–]"), strict=True,
    ):  # fmt: skip
        ax.plot(speeds, [scale * getattr(one, name) for one in found], color=BLUE,
                label="predicted")  # fmt: skip
        for k, case in enumerate(soft):
            spread = getattr(RECORDED[case.folder], name)
            middle = scale * spread.median
            bars = [[middle - scale * spread.low], [scale * spread.high - middle]]
            fitted = k == 0
            ax.errorbar(
                speed(case.height), middle, bars, fmt="s" if fitted else "o", capsize=3,
                color=GREY if fitted else ORANGE, mfc="white" if fitted else ORANGE,
                label="recorded, fitted to" if fitted else "recorded" if k == 1 else None,
            )  # fmt: skip
        ax.set(xlabel="Speed at touch [m/s]", ylabel=label, ylim=(0.0, None), xlim=(1.5, 7.5))
    axes[0].plot(speed(HIGHEST), AT_LEAST, "^", color=ORANGE, label="once, at least")
    axes[0].legend()
    return figure


def recoveries() -> Any:
    """Shares of recovered hits by pitch, with Wilson's intervals, and the simulator's."""
    hits = draw_hits()
    shares = shares_of(hits, fly_hits(hits))
    figure, ax = plt.subplots(figsize=(5.0, 2.9))
    for shift, colour, mark, label in (
        (-1.2, BLUE, "o", "springback"), (1.2, ORANGE, "s", "the makers' simulator"),
    ):  # fmt: skip
        for k, one in enumerate(shares):
            told = one.recovered if colour == BLUE else one.printed
            assert told.value is not None
            assert told.low is not None
            assert told.high is not None
            bars = [[100 * (told.value - told.low)], [100 * (told.high - told.value)]]
            ax.errorbar(
                0.5 * (one.low + one.high) + shift, 100 * told.value, bars, fmt=mark, color=colour,
                capsize=3, label=label if k == 0 else None,
            )  # fmt: skip
    ax.set(xlabel="Pitch, positive: leaning into the wall [deg]", ylabel="Recovered [%]",
           ylim=(0.0, 105.0), xticks=range(-45, 46, 15))  # fmt: skip
    ax.legend(loc="lower left")
    return figure


def release(path: Path) -> Any:
    """Angle of the arm, recorded and predicted."""
    recorded = read_release(path)
    here = predict_release(recorded)
    figure, axes = plt.subplots(1, 2, figsize=(7.0, 2.7), sharey=True)
    for ax, end in zip(axes, (0.1, COMPARED), strict=True):
        seen, flown = recorded.time <= end, here.time <= end
        ax.plot(recorded.time[seen], np.degrees(recorded.angle[seen]), ".", ms=3, color=ORANGE,
                label="recorded")  # fmt: skip
        ax.plot(here.time[flown], np.degrees(here.angle[flown]), color=BLUE, label="predicted")
        ax.set(xlabel="Time since the release [s]")
    axes[0].set(ylabel="Elevation [deg]")
    axes[0].legend()
    return figure


def main() -> None:
    """Write the pictures into a folder, by default beside this file."""
    words = sys.argv[1:]
    folder = Path(words[0]) if words else HERE
    with plt.style.context(STYLE):
        drawn = {"frame_drops": drops, "recovery_shares": recoveries}
        for name, draw in drawn.items():
            draw().savefig(folder / f"{name}.png", dpi=120)
        if len(words) > 1:
            release(Path(words[1])).savefig(folder / "arm_release.png", dpi=120)


if __name__ == "__main__":
    main()
