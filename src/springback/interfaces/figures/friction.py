"""Figures of the effect of friction on the springs, and of the velocity lost to clipping."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib import colormaps
from matplotlib.figure import Figure

from springback.interfaces.figures.chart import Chart
from springback.interfaces.figures.style import WIDTH, StyledFigure, in_style
from springback.interfaces.output.robots import INK, ROBOTS, SKY, robot_label, robot_styles
from springback.studies.clipping import ClippingLoss
from springback.studies.friction import PRINTED_FRICTION, FrictionResults

PANELS = (("stroke", "Stroke of an arm [mm]", 1e3), ("peak", "Peak acceleration [m/s²]", 1.0))
SHOWN = (0.2, 0.4, 0.6, 0.8, 1.0)
"""Coefficients of the curves over yaw."""
TURNED = (0.0, 3.0, 10.0, 45.0)
"""Yaws of the curves over the coefficient [deg]."""
DOTTED = (0, (1.2, 1.2))
FRICTION = "Coefficient of friction μ [-]"
LOOKS = {
    ("quad", "vertical"): (ROBOTS["quad"].label, ROBOTS["quad"].curve),
    ("arq", "both"): ("ARQ, friction along both tangents", {"color": SKY, "ls": (0, (8, 2))}),
    ("arq", "vertical"): ("ARQ, friction as in the paper", ROBOTS["arq"].curve),
}
"""Name and look of a robot with its axes of friction."""


@in_style
def friction_figure(results: FrictionResults) -> Figure:
    """Stroke and peak of the first robot whose arms slide, over yaw and over the coefficient.

    The other robots' peaks are drawn beside it.
    """
    shown = results.sprung[0]
    name = robot_label(shown)
    others = [robot for robot in results.robots if robot != shown]
    figure = StyledFigure(figsize=(1.5 * WIDTH, 5.6), layout="constrained")
    axes = figure.subplots(2, 2, sharex="col", sharey="row")
    shades = colormaps["viridis"]
    for row, (measure, label, scale) in enumerate(PANELS):
        first = row == 0
        left = Chart(
            axes[row, 0], "Yaw against the wall [°]", label, f"{name}: over the yaw", titled=first
        )
        right = Chart(axes[row, 1], FRICTION, label, f"{name}: over the coefficient", titled=first)
        frictions, yaws, free = results.grid(shown, "vertical", measure)
        _, _, held = results.grid(shown, "both", measure)
        of_print = frictions.index(PRINTED_FRICTION)
        left.curve(
            "along the vertical, as in the paper, any μ", yaws, scale * free[of_print], color=INK,
            lw=1.8,
        )  # fmt: skip
        for k, mu in enumerate(m for m in SHOWN if m in frictions):
            left.curve(
                f"both tangents, μ = {mu:g}", yaws, scale * held[frictions.index(mu)], lw=1.2,
                color=shades(0.9 - 0.2 * k), ls=(0, (4, 1.2)) if k % 2 else "-",
            )  # fmt: skip
        right.curve(
            "along e_Z, yaw 0°", frictions, scale * free[:, 0], key=False, color=INK, lw=1.8
        )
        for k, yaw in enumerate(y for y in TURNED if y in yaws):
            right.curve(
                f"both tangents, yaw {yaw:g}°", frictions, scale * held[:, yaws.index(yaw)], lw=1.2,
                color=shades(0.85 - 0.27 * k), marker="os^D"[k % 4], ms=3.5,
            )  # fmt: skip
        right.vline("Table II's μ", PRINTED_FRICTION, ls=DOTTED)
        for robot, look in robot_styles(others if measure == "peak" else ()).items():
            peaks = results.grid(robot, "vertical", measure)[2]
            left.curve(
                f"{robot_label(robot)}, along the vertical", yaws, scale * peaks[of_print], lw=1.2,
                **look.curve,
            )  # fmt: skip
    figure.align_ylabels(axes[:, 0])
    figure.legend(*axes[1, 0].get_legend_handles_labels(), loc="outside lower left")
    figure.legend(*axes[0, 1].get_legend_handles_labels(), loc="outside lower right")
    return figure


@in_style
def clipping_figure(found: Sequence[ClippingLoss]) -> Figure:
    """Velocity lost to clipping over the speed of the impact, both robots."""
    figure = StyledFigure(figsize=(WIDTH, 2.9), layout="constrained")
    chart = Chart(figure.subplots(), "Speed at contact [m/s]", "Lost to clipping at ±16 g [m/s]")
    for (robot, axes), (name, look) in LOOKS.items():
        mine = [one for one in found if (one.robot, one.axes) == (robot, axes)]
        speeds, hidden = [one.speed for one in mine], [one.velocity for one in mine]
        chart.curve(name, speeds, hidden, marker="o", ms=3.5, **look)
    for speed in (2.0, 3.5):
        chart.vline("the paper's speed", speed, ls=DOTTED)
    chart.ax.set_ylim(bottom=0.0)
    chart.ax.legend(loc="upper left")
    return figure
