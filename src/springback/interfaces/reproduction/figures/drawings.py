"""Drawings to scale: the robots from above, and a contact with its forces, as it was flown."""

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
    ends,
    half_plane,
    pose,
    ring,
    views,
)
from springback.interfaces.figures.style import (
    BLUE,
    GREEN,
    GREY,
    INK,
    RED,
    SHADE,
    WIDTH,
    StyledFigure,
    styled,
)
from springback.interfaces.replay.scene import ArmShape, Scene
from springback.vehicle.library import VEHICLES

NAMES = {"arq": "ARQ", "quad": "Quad"}
COLOURS = {"arq": BLUE, "quad": RED}
AXES = ViewPlane(np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0]), np.zeros(3))
"""From above, body x to the right."""
LONGEST = 0.13
"""Chosen: length of the arrow of the greatest force [m]."""


def shapes(robot: str) -> tuple[ArmShape, ...]:
    """The arms of a preset.

    Args:
        robot: Its name.
    """
    return tuple(
        ArmShape(
            (arm.cosine, arm.sine, 0.0), arm.length, arm.shortest, arm.cage_radius,
            arm.compliance > 0.0, 1 if arm.torque_ratio > 0.0 else -1,
        )
        for arm in VEHICLES[robot].vehicle.airframe().arms
    )  # fmt: skip


@styled
def robots_figure() -> Figure:
    """Both robots from above, to scale: arms with their directions, springs, cages, rotors."""
    figure = StyledFigure(figsize=(WIDTH, 2.95))
    axes = figure.subplots(1, 2, sharex=True, sharey=True)
    for ax, robot in zip(axes, ("arq", "quad"), strict=True):
        arms = shapes(robot)
        lengths = np.array([arm.length for arm in arms])
        still = np.zeros((len(arms), 3))
        now = SceneInstant(np.zeros(3), np.eye(3), lengths, lengths, still, still)
        _robot(ax, AXES, arms, now, COLOURS[robot])
        for j, (arm, tip) in enumerate(zip(arms, ends(arms, now), strict=True), start=1):
            ax.text(*(1.32 * tip[:2]), f"{j}", ha="center", va="center", weight="bold")
            if j == 1:
                _measured(ax, tip, arm)
        for axis, (x, y) in {"x": (0.30, 0.0), "y": (0.0, 0.30)}.items():
            ax.annotate("", (x, y), (0.0, 0.0), arrowprops={"arrowstyle": "->", "color": INK})
            ax.text(1.06 * x, 1.06 * y, axis, ha="center", va="center")
        kind = "springs in its arms" if arms[0].compliant else "rigid arms"
        ax.set_title(f"{NAMES[robot]}: {kind}")
        ax.set_aspect("equal")
        ax.set_xlabel("forward x [m]")
    axes[0].set_ylabel("left y [m]")
    axes[0].set_xlim(-0.34, 0.36)
    axes[0].set_ylim(-0.37, 0.36)
    return figure


def _measured(ax: Axes, tip: Any, arm: ArmShape) -> None:
    """Arm length and cage radius, in words beside the first arm."""
    ax.text(
        0.5, 0.02, f"arms {1e3 * arm.length:.0f} mm, cages {1e3 * arm.cage_radius:.0f} mm",
        ha="center", va="bottom", transform=ax.transAxes,
    )  # fmt: skip
    edge = tip[:2] + arm.cage_radius * np.array([-0.6, 0.8])
    ax.annotate("", edge, tip[:2], arrowprops={"arrowstyle": "-", "color": GREY, "lw": 0.9})


def _robot(
    ax: Axes, view: ViewPlane, arms: tuple[ArmShape, ...], now: SceneInstant, colour: str
) -> None:
    """Arms, cages and main body; names are for data alone."""
    tips = ends(arms, now)
    for j, arm in enumerate(arms, start=1):
        cage = view(ring(tips[j - 1], arm.cage_radius, now.rotation))
        ax.plot(*cage.T, color=INK, lw=1.2, label=f"_cage {j}", zorder=3)
        line = view(arm_line(arm, now, float(now.lengths[j - 1])))
        width = 1.0 if arm.compliant else 2.6
        ax.plot(*line.T, color=colour, lw=width, label=f"_arm {j}", zorder=4)
        ax.plot(*view(tips[j - 1]), "o", color=GREEN, ms=3.5, label=f"_rotor {j}", zorder=5)
    outline = view(body_outline(now)[0])
    ax.fill(*outline.T, fc=colour, ec=INK, lw=0.8, zorder=5)


@styled
def contact_figure(scene: Scene) -> Figure:
    """A contact from above at the instant of the greatest force, with the force on each cage.

    Args:
        scene: Of a flight that hits something.
    """
    k = int(np.argmax(np.linalg.norm(scene.force, axis=2).sum(axis=1)))
    now, (_, view) = pose(scene, float(scene.t[k])), views(scene)
    figure = StyledFigure(figsize=(WIDTH, 3.5))
    ax = figure.subplots()
    _matter(ax, scene, view)
    free = SceneInstant(now.position, now.rotation, _free(scene), now.thrust, now.force, now.point)
    for j, tip in enumerate(ends(scene.arms, free)):
        rest = view(ring(tip, scene.arms[j].cage_radius, now.rotation))
        name = "cage, arm at its free length" if j == 0 else f"_free cage {j + 1}"
        ax.plot(*rest.T, color=GREY, lw=0.9, ls=(0, (2, 2)), label=name, zorder=2)
    _robot(ax, view, scene.arms, now, BLUE if scene.arms[0].compliant else RED)
    _forces(ax, scene, view, now)
    middle = view(now.position)
    ax.set_xlim(middle[0] - 0.30, middle[0] + 0.42)
    ax.set_ylim(middle[1] - 0.31, middle[1] + 0.31)
    ax.set_aspect("equal")
    ax.set_xlabel("x [m]")
    ax.set_ylabel("y [m]")
    after = 1e3 * (scene.t[k] - scene.impacts[0][0])
    ax.set_title(f"{scene.label}, {after:.1f} ms after first touch")
    figure.legend(*ax.get_legend_handles_labels(), loc="outside upper center", ncols=3)
    return figure


def _free(scene: Scene) -> Any:
    return np.array([arm.length for arm in scene.arms])


def _matter(ax: Axes, scene: Scene, view: ViewPlane) -> None:
    for thing in scene.obstacles:
        area = half_plane(thing, view, 0.0, 5.0) if thing.normal else None
        if area is not None:
            ax.add_patch(Polygon(area, fc=SHADE, ec=GREY, hatch="///", lw=0.9, zorder=0.5))


def _forces(ax: Axes, scene: Scene, view: ViewPlane, now: SceneInstant) -> None:
    """Normal force and friction on each cage that touches, with their sizes."""
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
            shown = name if j == np.flatnonzero(pressing > 0.0)[0] else f"_{name}"
            ax.plot(*line.T, color=colour, lw=2.2, label=shown, zorder=7)
            turn = float(np.degrees(np.arctan2(*(line[1] - line[0])[::-1])))
            ax.plot(*line[1], marker=(3, 0, turn - 90.0), color=colour, ms=7, zorder=7,
                    label=f"_{name}, tip")  # fmt: skip
            label = {"normal force": "normal", "friction": "friction"}[name]
            foot, side = view(at), (0.025 if name == "normal force" else 0.075)
            up = 1.0 if foot[1] > view(now.position)[1] else -1.0
            ax.text(
                foot[0] + 0.02, foot[1] + up * side - 0.012, f"{label} {size:.0f} N",
                color=colour, weight="bold", zorder=8,
                bbox={"facecolor": "white", "alpha": 0.85, "lw": 0.0, "pad": 1.0},
            )  # fmt: skip
