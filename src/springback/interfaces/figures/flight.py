"""Figures of flights.

No physics is computed here: every number is a measure or a column of the trajectory.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from textwrap import fill
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from springback.contact.worlds import surfaces_of
from springback.errors import InputError
from springback.interfaces.figures.chart import HIGH, LOW, Chart
from springback.interfaces.figures.guided import guided_panels
from springback.interfaces.figures.panels import (
    ROUNDING,
    Array,
    Curve,
    Panel,
    alike,
    arms_of,
    body_curves,
    contacts,
    hinge_curves,
    short,
    stacked_panels,
)
from springback.interfaces.figures.style import WIDTH, StyledFigure, escape, in_style
from springback.interfaces.output.robots import BLUE, GREEN, GREY, INK, ORANGE, PINK, RED, SKY
from springback.results.flight import Flight
from springback.results.result import NAMED
from springback.scenario.worlds.imported import single_obstacles
from springback.simulation.measuring.measures import Outcome

#: Longest name of a scenario in a title, and longest lines of that and below it [characters]; room
#: for the legend below those [points] (chosen).
LONGEST_NAME, TITLE, TOUCHED, ABOVE = 50, 52, 58, 16.0
#: An arm that gives less than this is drawn as a flat line [mm] (chosen: the width of that line).
STIFF = 0.02
#: Measure with the instant that an outcome tells of.
TOLD = {
    Outcome.BROKEN: "broken_time",
    Outcome.HIT_GROUND: "ground_time",
    Outcome.ARM_BOTTOMED: "bottomed_time",
}
#: A figure that is longer than this, over the impact, is not the impact's (chosen).
WIDER = 1.35
#: Change of velocity that is a jump [m/s], beside this multiple of what the acceleration gives.
JUMP, SMOOTH = 1e-3, 2.0


@in_style
def flight_figure(flight: Flight) -> Figure:
    """A flight over time.

    With a pilot: motion and reference, attitude, thrusts, and the error of the estimate; without
    one: the motion around the contacts, as in `impact_figure`, up to what the title tells of and to
    the last hit of the impulse law.

    Args:
        flight: With a trajectory.

    Raises:
        InputError: If the flight has no trajectory.
    """
    if not flight.columns:
        raise InputError("this flight has no trajectory: fly it with trajectory=True")
    if flight.is_piloted:
        shades = contacts(flight.columns)
        figure = stacked_panels(guided_panels(flight), "Time [s]", shades, height=1.15)
        return with_title(figure, flight)
    return _motion(flight, _last_told(flight))


@in_style
def impact_figure(flight: Flight) -> Figure:
    """Main body, arms, normal forces and friction over time, contacts shaded.

    A flight with contacts is shown around them (with a pilot around the first impact), with time
    and position relative to the first touch; a flight without contacts is shown completely.  Arm
    lengths are shown if an arm slides.

    Args:
        flight: With a trajectory.
    """
    return _motion(flight)


def needs_impact_figure(flight: Flight) -> bool:
    """True if `flight_figure` shows more than the impact.

    Args:
        flight: With a trajectory.
    """
    touch = flight.measures.get("touch_time")
    if touch is None:
        return False
    return flight.is_piloted or _last_told(flight) > touch + WIDER * (_last_touch(flight) - touch)


def _last_told(flight: Flight) -> float:
    """When the last of what a title tells of was, and the last hit of the impulse law [s]."""
    told = flight.measures.get(TOLD.get(flight.outcome, ""))
    return max([0.0 if told is None else told, *impulse_hits(flight)])


def impulse_hits(flight: Flight) -> list[float]:
    """Instants at which the impulse law changes the main body's velocity at once [s].

    Args:
        flight: With a trajectory, which has no force of that law.
    """
    obstacles = single_obstacles(flight.scenario.world.obstacles)
    laws = [surface.law for one in obstacles if one.type != "own" for surface in surfaces_of(one)]
    if "impulse" not in laws:
        return []
    c = flight.columns
    moves, pulls = (np.stack([c[f"{kind}{axis}"] for axis in "xyz"], axis=1) for kind in "va")
    change = np.linalg.norm(np.diff(moves, axis=0), axis=1)
    pull = np.linalg.norm(pulls, axis=1)
    smooth = np.diff(c["t"]) * np.maximum(pull[1:], pull[:-1])
    return [float(t) for t in c["t"][1:][change > JUMP + SMOOTH * smooth]]


def _motion(flight: Flight, until: float = 0.0) -> Figure:
    c, touch = flight.columns, flight.measures.get("touch_time")
    t, inside = _around_contact(flight, until)
    first = {} if touch is None else {a: np.interp(touch, c["t"], c[a]) for a in "xyz"}
    size, unit = (1.0, "m") if touch is None else (1e3, "mm")

    def panel(label: str, curves: list[tuple[str, Array]], flat: float = ROUNDING) -> Panel:
        shown = [Curve(name, t(c["t"][inside]), values[inside]) for name, values in curves]
        return Panel(label, shown, flat=flat)

    panels = [
        panel(
            f"Position [{unit}]",
            [(axis, size * (c[axis] - first.get(axis, 0.0))) for axis in "xyz"],
        ),
        panel("Velocity [m/s]", [(f"v{axis}", c[f"v{axis}"]) for axis in "xyz"]),
        panel("Acceleration [m/s²]", [(f"a{axis}", c[f"a{axis}"]) for axis in "xyz"]),
    ]
    arms = arms_of(c)
    if any(np.ptp(c[f"l{j}"]) > 1e-9 for j in arms):
        lengths = alike("arm", [(j, 1e3 * c[f"l{j}"]) for j in arms])
        panels.append(panel("Arm length [mm]", lengths, STIFF))
    if "bend1" in c:
        bends = alike("arm", [(j, 1e3 * c[f"bend{j}"]) for j in arms])
        panels.append(panel("2nd joint [mm]", bends, STIFF))
    panels += [panel(label, curves) for label, curves in hinge_curves(flight)]
    panels += [
        panel(f"{what} [N]", curves)
        for what, curves in (("Normal force", _forces(c, "fn")), ("Friction", _forces(c, "ff")))
        if curves
    ]
    shades = [(t(start), t(end)) for start, end in contacts(c)]
    time = "Time [s]" if touch is None else "Time from first touch [ms]"
    return with_title(stacked_panels(panels, time, shades), flight)


def with_title(figure: Figure, flight: Flight) -> Figure:
    """A figure with the name of the scenario, the outcome, what was touched and broke above it."""
    name = short(flight.scenario.name, LONGEST_NAME)
    said = fill(f"{name}: {flight.message}", TITLE)
    figure.suptitle(escape(said), x=0.01, ha="left", weight="bold")
    met = [one.obstacle for one in flight.obstacle_contacts]
    lists = {"touched": met, "broken": flight.broken_parts}
    lines = [fill(f"{name}: {_first_of(some)}", TOUCHED) for name, some in lists.items() if some]
    if lines:
        figure.axes[0].set_title(escape("\n".join(lines)), weight="normal", pad=ABOVE)
    return figure


def _first_of(names: Sequence[str]) -> str:
    """The first few of some names."""
    more = f"; and {len(names) - NAMED} more" if len(names) > NAMED else ""
    return f"{'; '.join(names[:NAMED])}{more}"


def _forces(columns: Mapping[str, Array], kind: str) -> list[tuple[str, Array]]:
    """Forces on what was touched: normal, ``fn``, or friction, ``ff``, if there is any to speak of.

    Friction has the looks that its arms have among normal forces.
    """
    c = columns
    touched = [j for j in arms_of(c) if np.any(c[f"fn{j}"] > 0.0)]
    curves = alike("arm", [(j, c[f"{kind}{j}"]) for j in touched])
    curves += body_curves(c, {kind: "body"})
    largest = max((float(np.max(values)) for _, values in curves), default=0.0)
    pressed = max((float(np.max(c[f"fn{j}"])) for j in touched), default=0.0)
    return curves if largest > 1e-3 * pressed else []


def _last_touch(flight: Flight) -> float:
    """End of what `impact_figure` shows, without room beside it [s].

    With a pilot, who may keep pushing, only the first impact is shown.
    """
    measures = flight.measures
    touch = measures.get("touch_time") or 0.0
    ends = [end for _, end in contacts(flight.columns)]
    if flight.is_piloted or not ends:
        ends = [measures.get("separation_time") or max(ends, default=touch)]
    return max(*ends, measures.get("return_time") or touch, touch + 0.01)


def _around_contact(flight: Flight, until: float) -> tuple[Callable[[Any], Any], Any]:
    """Time scale and mask of the instants shown: all, or those around the contacts.

    Args:
        flight: With a trajectory.
        until: To be shown at least [s].
    """
    t, touch = flight.columns["t"], flight.measures.get("touch_time")
    if touch is None:
        return lambda instant: instant, slice(None)
    last = max(_last_touch(flight), until)
    room = 0.35 * (last - touch)
    return lambda instant: 1e3 * (instant - touch), (t >= touch - room) & (t <= last + room)


@in_style
def energy_figure(*flights: Flight) -> Figure:
    """Energy balance of flights: input, losses and remainder.

    Percentages refer to the input: initial energy, work of the rotors, loss of height, and what
    wind and moving obstacles give.

    Args:
        *flights: One panel each, on one scale.
    """
    steps = [_energy_steps(flight) for flight in flights]
    scale = max(abs(value) for each in steps for _, value, _ in each) or 1.0
    shown = [
        name
        for k, (name, _, _) in enumerate(steps[0])
        if any(abs(each[k][1]) > 1e-3 * scale for each in steps)
    ]
    figure = StyledFigure(figsize=(WIDTH, (0.6 + 0.26 * len(shown)) * len(flights) + 0.35))
    axes = list(figure.subplots(len(flights), 1, sharex=True, squeeze=False)[:, 0])
    for ax, each, flight in zip(axes, steps, flights, strict=True):
        chart = Chart(ax, "Energy [J]", "category", short(flight.scenario.name, 50))
        _waterfall(chart, [step for step in each if step[0] in shown])
    longest = max(ax.dataLim.x1 for ax in axes) if shown else 1.0
    lowest = min(0.0, *(ax.dataLim.x0 for ax in axes)) if shown else 0.0
    axes[-1].set_xlim(1.05 * lowest, longest + 0.55 * (longest - lowest))  # room for the numbers
    return figure


def _waterfall(chart: Chart, steps: list[tuple[str, float, str]]) -> None:
    """Draw a bar for each step from the end of the last one; the remainder starts at zero."""
    put_in = sum(value for name, value, _ in steps if value > 0.0 and not name.startswith("left"))
    ax, level, leaving = chart.ax, 0.0, False
    for y, (name, value, colour) in enumerate(steps):
        if name.startswith("left") and not leaving:
            level, leaving = 0.0, True
        ax.barh(y, value, 0.72, left=level, color=colour)
        low, high = sorted((level, level + value))
        bar = {chart.y: name, chart.x: value, chart.x + LOW: low, chart.x + HIGH: high}
        chart.record("", bar)
        share = f" ({100.0 * abs(value) / put_in:.1f} %)" if put_in > 0.0 else ""
        sign = "−" if value < 0.0 else ""
        ax.annotate(
            f"{sign}{abs(value):.3g} J{share}", (max(level, level + value), y), (4, 0),
            textcoords="offset points", va="center", fontsize=9,
        )  # fmt: skip
        level += value
    ax.set_yticks(range(len(steps)), [name for name, _, _ in steps])
    ax.set_ylim(len(steps) - 0.4, -0.6)
    ax.grid(visible=False, axis="y")


def _energy_steps(flight: Flight) -> list[tuple[str, float, str]]:
    """Name, energy [J] and colour of every step: inputs, losses, remainder."""
    m = {name: value or 0.0 for name, value in flight.measures.items()}
    rotors, height = m["work_thrust"], m["energy_gravity"]
    driven, moving = m["work_driven"], m["energy_obstacles"]
    return [
        ("at the start", m["energy_start"], INK),
        ("work of rotors", max(rotors, 0.0), GREY),
        ("loss of height", max(-height, 0.0), GREY),
        ("work of wind", max(-m["loss_air"], 0.0), GREY),
        ("work of driven obstacles", max(driven, 0.0), GREY),
        ("given by moving obstacles", max(-moving, 0.0), GREY),
        ("absorbed by rotors", min(rotors, 0.0), SKY),
        ("absorbed by driven obstacles", min(driven, 0.0), SKY),
        ("contact damping", -m["loss_contact"], RED),
        ("arm dampers", -m["loss_arm"], BLUE),
        ("friction", -m["loss_friction"], ORANGE),
        ("end stops", -m["loss_stop"], PINK),
        ("air", -max(m["loss_air"], 0.0), SKY),
        ("locking the arms", -m["loss_settling"], GREY),
        ("lost in moving obstacles", -m["loss_obstacles"], PINK),
        ("left in motion", m["energy_kinetic"], GREEN),
        ("left in arm springs", m["energy_springs"], GREEN),
        ("left in contacts", m["energy_contact"], GREEN),
        ("left in end stops", m["energy_stops"], GREEN),
        ("left in height", max(height, 0.0), GREEN),
        ("left in moving obstacles", max(moving, 0.0), GREEN),
    ]
