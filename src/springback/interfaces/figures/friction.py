"""Figures of what friction does to the springs, and of what clipping hides."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib import colormaps
from matplotlib.figure import Figure

from springback.interfaces.figures.style import (
    BLUE,
    GREY,
    INK,
    RED,
    SKY,
    WIDTH,
    Look,
    StyledFigure,
    styled,
)
from springback.studies.clipping import Hidden
from springback.studies.friction import PRINTED_FRICTION, FrictionResults

PANELS = (("stroke", "Stroke of an arm [mm]", 1e3), ("peak", "Peak acceleration [m/s²]", 1.0))
SHOWN = (0.2, 0.4, 0.6, 0.8, 1.0)
"""Coefficients that get a curve over the yaw."""
TURNED = (0.0, 3.0, 10.0, 45.0)
"""Yaws that get a curve over the coefficient [deg]."""
LOOKS: dict[tuple[str, str], tuple[str, Look]] = {
    ("quad", "vertical"): ("Quad", (RED, (0, (5, 1.5)))),
    ("arq", "both"): ("ARQ, friction along both tangents", (SKY, (0, (8, 2)))),
    ("arq", "vertical"): ("ARQ, friction as in the paper", (BLUE, "-")),
}
"""Name and look of a robot with an axis of friction."""


@styled
def friction_figure(results: FrictionResults) -> Figure:
    """Stroke and peak of ARQ over the yaw, for some coefficients, and over the coefficient."""
    figure = StyledFigure(figsize=(1.5 * WIDTH, 5.6), layout="constrained")
    axes = figure.subplots(2, 2, sharex="col", sharey="row")
    shades = colormaps["viridis"]
    for (left, right), (measure, label, scale) in zip(axes, PANELS, strict=True):
        frictions, yaws, free = results.grid("arq", "vertical", measure)
        _, _, held = results.grid("arq", "both", measure)
        left.plot(
            yaws, scale * free[frictions.index(PRINTED_FRICTION)], color=INK, lw=1.8,
            label="along the vertical, as in the paper, any μ",
        )  # fmt: skip
        for k, mu in enumerate(m for m in SHOWN if m in frictions):
            left.plot(
                yaws, scale * held[frictions.index(mu)], color=shades(0.9 - 0.2 * k), lw=1.2,
                ls=(0, (4, 1.2)) if k % 2 else "-", label=f"both tangents, μ = {mu:g}",
            )  # fmt: skip
        right.plot(frictions, scale * free[:, 0], color=INK, lw=1.8, label="_along e_Z, yaw 0°")
        for k, yaw in enumerate(y for y in TURNED if y in yaws):
            right.plot(
                frictions, scale * held[:, yaws.index(yaw)], color=shades(0.85 - 0.27 * k), lw=1.2,
                marker="os^D"[k % 4], ms=3.5, label=f"both tangents, yaw {yaw:g}°",
            )  # fmt: skip
        right.axvline(
            PRINTED_FRICTION, color=GREY, lw=0.9, ls=(0, (1.2, 1.2)), label="_Table II's μ"
        )
        if measure == "peak":
            quad = results.grid("quad", "vertical", measure)[2]
            left.plot(yaws, scale * quad[frictions.index(PRINTED_FRICTION)], color=RED, lw=1.2,
                      ls=(0, (5, 1.5)), label="Quad, along the vertical")  # fmt: skip
        left.set_ylabel(label)
    axes[0, 0].set_title("Over the yaw")
    axes[0, 1].set_title("Over the coefficient of friction")
    axes[1, 0].set_xlabel("Yaw against the wall [°]")
    axes[1, 1].set_xlabel("Coefficient of friction μ [-]")
    figure.align_ylabels(axes[:, 0])
    figure.legend(*axes[1, 0].get_legend_handles_labels(), loc="outside lower left")
    figure.legend(*axes[0, 1].get_legend_handles_labels(), loc="outside lower right")
    return figure


@styled
def hidden_figure(found: Sequence[Hidden]) -> Figure:
    """Velocity hidden by clipping over the speed of the impact, both robots."""
    figure = StyledFigure(figsize=(WIDTH, 2.9), layout="constrained")
    ax = figure.subplots()
    for (robot, axes), (name, (colour, line)) in LOOKS.items():
        mine = [one for one in found if (one.robot, one.axes) == (robot, axes)]
        speeds, hidden = np.array([(o.speed, o.velocity) for o in mine]).reshape(-1, 2).T
        ax.plot(speeds, hidden, color=colour, ls=line, marker="o", ms=3.5, label=name)
    for speed in (2.0, 3.5):
        ax.axvline(speed, color=GREY, lw=0.9, ls=(0, (1.2, 1.2)), label="_the paper's speed")
    ax.set_xlabel("Speed at contact [m/s]")
    ax.set_ylabel("Hidden by ±16 g [m/s]")
    ax.set_ylim(bottom=0.0)
    ax.legend(loc="upper left")
    return figure
