"""Drawings to scale: the robots from above, and a simulated contact with its forces."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Polygon

from springback.interfaces.animation.bodies import (
    SceneInstant,
    ViewPlane,
    arm_line,
    body_outline,
    end_places,
    ends,
    half_plane,
    is_hinged,
    pose,
    ring,
    views,
)
from springback.interfaces.figures.chart import Chart
from springback.interfaces.figures.style import WIDTH, StyledFigure, in_style
from springback.interfaces.output.robots import BLUE, GREEN, GREY, INK, RED, ROBOTS, SHADE
from springback.interfaces.replay.scene import ArmShape, Scene, arm_shapes
from springback.vehicle.library import VEHICLES

AXES = ViewPlane(np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0]), np.zeros(3))
"""Axis labels of a view from above, body x to the right."""
LONGEST = 0.13
"""Chosen: length of the arrow of the largest force [m]."""


@in_style
def robots_figure() -> Figure:
    """Both robots from above, to scale: arms with their directions, springs, cages, rotors."""
    figure = StyledFigure(figsize=(WIDTH, 2.95))
    axes = figure.subplots(1, 2, sharex=True, sharey=True)
    for ax, (robot, look) in zip(axes, ROBOTS.items(), strict=True):
        arms = arm_shapes(VEHICLES[robot].vehicle.airframe(), VEHICLES[robot].vehicle)
        kind = "springs in its arms" if arms[0].compliant else "rigid arms"
        chart = Chart(ax, "forward x [m]", "left y [m]", f"{look.label}: {kind}")
        lengths = np.array([arm.length for arm in arms])
        still = np.zeros((len(arms), 3))
        now = SceneInstant(np.zeros(3), np.eye(3), lengths, lengths, still, still, ())
        _robot(chart, AXES, arms, now, look.colour)
        for j, (arm, tip) in enumerate(zip(arms, ends(arms, now), strict=True), start=1):
            ax.text(*(1.32 * tip[:2]), f"{j}", ha="center", va="center", weight="bold")
            if j == 1:
                _annotate_lengths(ax, tip, arm)
        for axis, (x, y) in {"x": (0.30, 0.0), "y": (0.0, 0.30)}.items():
            ax.annotate("", (x, y), (0.0, 0.0), arrowprops={"arrowstyle": "->", "color": INK})
            ax.text(1.06 * x, 1.06 * y, axis, ha="center", va="center")
        ax.set_aspect("equal")
    axes[0].set_xlim(-0.34, 0.36)
    axes[0].set_ylim(-0.37, 0.36)
    return figure


def _annotate_lengths(ax: Axes, tip: Any, arm: ArmShape) -> None:
    """Annotate arm length and cage radius at the first arm."""
    ax.text(
        0.5, 0.02, f"arms {1e3 * arm.length:.0f} mm, cages {1e3 * arm.cage_radius:.0f} mm",
        ha="center", va="bottom", transform=ax.transAxes,
    )  # fmt: skip
    edge = tip[:2] + arm.cage_radius * np.array([-0.6, 0.8])
    ax.annotate("", edge, tip[:2], arrowprops={"arrowstyle": "-", "color": GREY, "lw": 0.9})


def _robot(
    chart: Chart, view: ViewPlane, arms: tuple[ArmShape, ...], now: SceneInstant, colour: str
) -> None:
    """Draw arms, cages and main body; names are for the table only."""
    places = end_places(arms, now)
    for j, (arm, tip) in enumerate(zip(arms, places, strict=True), start=1):
        cage = view(ring(tip.position, arm.cage_radius, tip.rotation))
        chart.curve(f"cage {j}", *cage.T, key=False, color=INK, lw=1.2, zorder=3)
        line = view(arm_line(arm, now, float(now.lengths[j - 1]), now.bend(j - 1)))
        width = 1.0 if arm.compliant and not is_hinged(arm) else 2.6
        chart.curve(f"arm {j}", *line.T, key=False, color=colour, lw=width, zorder=4)
        rotor: dict[str, Any] = {"color": GREEN, "marker": "o", "ms": 3.5, "zorder": 5}
        chart.curve(f"rotor {j}", *view(tip.position), key=False, **rotor)
    chart.ax.fill(*view(body_outline(now)[0]).T, fc=colour, ec=INK, lw=0.8, zorder=5)


@in_style
def contact_figure(scene: Scene) -> Figure:
    """A contact from above at the instant of the largest force, with the force on each cage.

    Args:
        scene: Scene of a flight with a contact.
    """
    k = int(np.argmax(np.linalg.norm(scene.force, axis=2).sum(axis=1)))
    now, (_, view) = pose(scene, float(scene.t[k])), views(scene)
    figure = StyledFigure(figsize=(WIDTH, 3.5))
    ax = figure.subplots()
    after = 1e3 * (scene.t[k] - scene.impacts[0][0])
    chart = Chart(ax, "x [m]", "y [m]", f"{scene.label}, {after:.1f} ms after first touch")
    _matter(ax, scene, view)
    free = now._replace(lengths=_free(scene))
    for j, tip in enumerate(end_places(scene.arms, free)):
        rest = view(ring(tip.position, scene.arms[j].cage_radius, tip.rotation))
        name = "cage, arm at its free length" if j == 0 else f"free cage {j + 1}"
        look: dict[str, Any] = {"color": GREY, "lw": 0.9, "ls": (0, (2, 2)), "zorder": 2}
        chart.curve(name, *rest.T, key=j == 0, **look)
    _robot(chart, view, scene.arms, now, BLUE if scene.arms[0].compliant else RED)
    _forces(chart, scene, view, now)
    middle = view(now.position)
    ax.set_xlim(middle[0] - 0.30, middle[0] + 0.42)
    ax.set_ylim(middle[1] - 0.31, middle[1] + 0.31)
    ax.set_aspect("equal")
    figure.legend(*ax.get_legend_handles_labels(), loc="outside upper center", ncols=3)
    return figure


def _free(scene: Scene) -> Any:
    return np.array([arm.length for arm in scene.arms])


def _matter(ax: Axes, scene: Scene, view: ViewPlane) -> None:
    for thing in scene.obstacles:
        area = half_plane(thing, view, 0.0, 5.0) if thing.normal else None
        if area is not None:
            ax.add_patch(Polygon(area, fc=SHADE, ec=GREY, hatch="///", lw=0.9, zorder=0.5))


def _forces(chart: Chart, scene: Scene, view: ViewPlane, now: SceneInstant) -> None:
    """Draw normal force and friction on each cage in contact, with their magnitudes."""
    face = next(thing for thing in scene.obstacles if thing.normal)
    normal = np.array(face.normal)
    pressing = now.force @ normal
    rubbing = now.force - np.outer(pressing, normal)
    metres = LONGEST / max(float(pressing.max()), 1e-9)
    for j in np.flatnonzero(pressing > 0.0):
        at = now.point[j]
        for name, force, colour in (
            ("normal force", pressing[j] * normal, RED), ("friction", rubbing[j], GREEN),
        ):  # fmt: skip
            line, size = view(np.array([at, at + metres * force])), float(np.linalg.norm(force))
            if size * metres < 0.004:
                continue
            first = bool(j == np.flatnonzero(pressing > 0.0)[0])
            chart.curve(name, *line.T, key=first, color=colour, lw=2.2, zorder=7)
            turn = float(np.degrees(np.arctan2(*(line[1] - line[0])[::-1])))
            chart.ax.plot(*line[1], marker=(3, 0, turn - 90.0), color=colour, ms=7, zorder=7)
            label = {"normal force": "normal", "friction": "friction"}[name]
            foot, side = view(at), (0.025 if name == "normal force" else 0.075)
            up = 1.0 if foot[1] > view(now.position)[1] else -1.0
            chart.ax.text(
                foot[0] + 0.02, foot[1] + up * side - 0.012, f"{label} {size:.0f} N",
                color=colour, weight="bold", zorder=8,
                bbox={"facecolor": "white", "alpha": 0.85, "lw": 0.0, "pad": 1.0},
            )  # fmt: skip
