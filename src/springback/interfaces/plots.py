"""Figures of flights and of the paper's experiments, in one house style.

Nothing here computes physics: every number shown is a measure, a trajectory column or a printed
value.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from springback.experiments.comparison import AGREEMENT
from springback.experiments.paper.printed import SLIDER_SPEED, SWEEP_GAP, SWEEP_SPEEDS, TABLE_III
from springback.experiments.result import Flight
from springback.interfaces.canvas import (
    BLUE,
    GREEN,
    GREY,
    INK,
    LOOKS,
    ORANGE,
    PINK,
    RED,
    SHADE,
    SKY,
    WIDTH,
    HouseFigure,
    Look,
    styled,
)

if TYPE_CHECKING:
    from springback.experiments.paper.slider import Case, SliderResults

Array = np.ndarray[Any, np.dtype[np.float64]]
ROBOTS = {"quad": "Quad", "arq": "ARQ"}
ROBOT_LOOKS: dict[str, Look] = {"quad": (RED, (0, (5, 1.5))), "arq": (BLUE, "-")}
SURFACES = ("wall", "mat")


@styled
def flight_figure(flight: Flight) -> Figure:
    """Main body, arms and contact forces over time, contacts shaded.

    A flight that touches something is shown around its contacts, with time and position counted
    from the first touch; one that touches nothing is shown whole.  Arm lengths appear if an arm
    slides.

    Args:
        flight: With a trajectory.

    Raises:
        ValueError: If the flight kept no trajectory.
    """
    if not flight.columns:
        raise ValueError("this flight kept no trajectory: fly it with trajectory=True")
    c, touch = flight.columns, flight.measures.get("touch_time")
    t, inside = _around_contact(flight)
    first = {} if touch is None else {a: np.interp(touch, c["t"], c[a]) for a in "xyz"}
    size, unit = (1.0, "m") if touch is None else (1e3, "mm")
    panels = [
        (f"Position [{unit}]", [(axis, size * (c[axis] - first.get(axis, 0.0))) for axis in "xyz"]),
        ("Velocity [m/s]", [(f"v{axis}", c[f"v{axis}"]) for axis in "xyz"]),
        ("Acceleration [m/s²]", [(f"a{axis}", c[f"a{axis}"]) for axis in "xyz"]),
    ]
    arms = _arms(c)
    if any(np.ptp(c[f"l{j}"]) > 1e-9 for j in arms):
        panels.append(("Arm length [mm]", _alike("arm", [(j, 1e3 * c[f"l{j}"]) for j in arms])))
    touched = [j for j in arms if np.any(c[f"fn{j}"] > 0.0)]
    if touched:
        least = 1e-3 * max(float(np.max(c[f"fn{j}"])) for j in touched)
        rubbed = [j for j in touched if np.max(c[f"ff{j}"]) > least]
        forces = _alike("arm", [(j, c[f"fn{j}"]) for j in touched])
        friction = _alike("friction", [(j, c[f"ff{j}"]) for j in rubbed])
        panels.append(("Contact force [N]", forces + friction))

    figure = HouseFigure(figsize=(WIDTH, 0.45 + 1.4 * len(panels)))
    axes = list(figure.subplots(len(panels), 1, sharex=True, squeeze=False)[:, 0])
    for ax, (label, curves) in zip(axes, panels, strict=True):
        for start, end in _contacts(c, arms):
            ax.axvspan(t(start), t(end), color=SHADE, lw=0.0, zorder=0.1)
        for (name, values), (colour, line) in zip(curves, LOOKS * len(curves), strict=False):
            ax.plot(t(c["t"][inside]), values[inside], color=colour, ls=line, label=name)
        low, high = ax.get_ylim()
        if high - low < 1e-6:  # nothing but rounding: a flat line, not a magnified one
            ax.set_ylim(low - 1.0, high + 1.0)
        ax.set_ylabel(label)
        ax.legend(
            loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=4, borderpad=0.0,
            borderaxespad=0.3, columnspacing=1.0, handletextpad=0.5, handlelength=2.0,
        )  # fmt: skip
    if touched:
        axes[0].text(0.0, 1.03, "contact shaded", transform=axes[0].transAxes, fontsize=8)
    axes[-1].set_xlabel("Time [s]" if touch is None else "Time from first touch [ms]")
    shown = t(c["t"][inside])
    axes[-1].set_xlim(shown[0], shown[-1] if shown[-1] > shown[0] else shown[0] + 1.0)
    figure.align_ylabels(axes)
    return figure


def _around_contact(flight: Flight) -> tuple[Callable[[Any], Any], Any]:
    """How time is shown, and which instants are: all, or those around the contacts."""
    t, touch = flight.columns["t"], flight.measures.get("touch_time")
    if touch is None:
        return lambda instant: instant, slice(None)
    ends = [end for _, end in _contacts(flight.columns, _arms(flight.columns))]
    last = max(*ends, flight.measures.get("return_time") or touch, touch + 0.01)
    room = 0.35 * (last - touch)
    return lambda instant: 1e3 * (instant - touch), (t >= touch - room) & (t <= last + room)


def _arms(columns: dict[str, Array]) -> list[int]:
    return sorted(int(name[2:]) for name in columns if name.startswith("fn"))


def _contacts(columns: dict[str, Array], arms: Iterable[int]) -> list[tuple[float, float]]:
    """Intervals of time in which any cage touches anything [s]."""
    t = columns["t"]
    touching = np.zeros(len(t) + 2, dtype=int)
    for j in arms:
        touching[1:-1] |= columns[f"fn{j}"] > 0.0
    starts, ends = (np.flatnonzero(np.diff(touching) == change) for change in (1, -1))
    last = len(t) - 1
    return [(float(t[i]), float(t[min(int(k), last)])) for i, k in zip(starts, ends, strict=True)]


def _alike(what: str, curves: list[tuple[int, Array]]) -> list[tuple[str, Array]]:
    """Curves of arms with equal ones as one, so that no curve hides behind another."""
    groups: list[tuple[list[int], Array]] = []
    for arm, values in curves:
        scale = 1e-6 * float(np.max(np.abs(values), initial=0.0))
        twin = next((g for g in groups if np.allclose(g[1], values, rtol=0.0, atol=scale)), None)
        if twin is None:
            groups.append(([arm], values))
        else:
            twin[0].append(arm)
    return [(f"{what} {', '.join(map(str, names))}", values) for names, values in groups]


def predictions(results: SliderResults, robot: str, surface: str) -> list[Case]:
    """The first case of every reading: the one flown with Quad's c_a."""
    found: dict[str, Case] = {}
    for case in results.cases:
        if (case.robot, case.surface) == (robot, surface):
            found.setdefault(case.reading.name, case)
    return list(found.values())


def _reading_looks(results: SliderResults) -> dict[str, Look]:
    """Looks of the readings; B, the default, gets the first."""
    order = (LOOKS[1], LOOKS[0], *LOOKS[2:])
    return {r.name: order[k % len(order)] for k, r in enumerate(results.readings)}


@styled
def slider_figure(results: SliderResults, robot: str) -> Figure:
    """A robot hits wall and mat: position, velocity, acceleration, and arm length if arms slide.

    Dash-dotted lines mark what the paper prints for its simulation; a diamond its contact time.

    Args:
        results: The slider tests.
        robot: ``quad`` or ``arq``.
    """
    flown = {surface: predictions(results, robot, surface) for surface in SURFACES}
    flights = [case.flight for cases in flown.values() for case in cases]
    labels = ["Position [mm]", "Velocity [m/s]", "Acceleration [m/s²]"]
    if any(np.ptp(f.columns[f"l{_front(f)}"]) > 1e-9 for f in flights):
        labels.append("Arm length [mm]")
    figure = HouseFigure(figsize=(WIDTH, 0.9 + 1.3 * len(labels)))
    axes = figure.subplots(len(labels), 2, sharex="col", sharey="row", squeeze=False)
    looks = _reading_looks(results)
    for column, (surface, cases) in zip(axes.T, flown.items(), strict=True):
        span = _slider_times(robot, surface, cases)
        for case in cases:
            _slider_curves(column, case, looks.get(case.reading.name, LOOKS[0]), span)
        _slider_print(column, robot, surface)
        column[0].set_title(f"{ROBOTS[robot]} on the {surface}")
        column[-1].set_xlabel("Time from first touch [ms]")
        column[-1].set_xlim(*span)
    for ax, label in zip(axes[:, 0], labels, strict=True):
        ax.set_ylabel(label)
        ax.yaxis.set_major_locator(MaxNLocator(5, steps=[1, 2, 5, 10]))
    figure.align_ylabels(axes[:, 0])
    legends = [axes[row, 0].get_legend_handles_labels() for row in (0, 1)]
    handles, names = (a + b for a, b in zip(*legends, strict=True))
    figure.legend(handles, names, loc="outside upper center", ncols=3)
    return figure


def _short(name: str, most: int = 24) -> str:
    """A name that fits into a legend."""
    return name if len(name) <= most else name[: most - 1] + "…"


def _front(flight: Flight) -> int:
    """The arm that is pressed hardest."""
    return max(_arms(flight.columns), key=lambda j: float(np.max(flight.columns[f"fn{j}"])))


def _since_touch(flight: Flight) -> tuple[Array, float]:
    """Time from first touch [ms], and the instant of it [s]."""
    touch = flight.measures.get("touch_time") or 0.0
    return 1e3 * (flight.columns["t"] - touch), touch


def _slider_times(robot: str, surface: str, cases: Sequence[Case]) -> tuple[float, float]:
    shown = [TABLE_III[robot, surface].contact_time]
    for case in cases:
        measures = case.flight.measures
        shown += [measures.get("time_to_return") or 0.0, measures.get("contact_time") or 0.0]
    return -0.15e3 * max(shown), 1.3e3 * max(shown)


def _slider_curves(
    column: Sequence[Axes], case: Case, look: Look, span: tuple[float, float]
) -> None:
    c, (t, touch) = case.flight.columns, _since_touch(case.flight)
    past = c["x"] - np.interp(touch, c["t"], c["x"])
    curves = [1e3 * past, c["vx"], c["ax"], 1e3 * c[f"l{_front(case.flight)}"]]
    inside = (t > 1.1 * span[0]) & (t < 1.02 * span[1])  # the rest would only stretch the scales
    for ax, values in zip(column, curves, strict=False):
        ax.plot(t[inside], values[inside], color=look[0], ls=look[1])
    name = "computed" if case.robot == "quad" else f"reading {case.reading.name}"
    column[0].lines[-1].set_label(_short(name))
    left = case.flight.measures.get("contact_time")
    if left is not None:
        speed = float(np.interp(touch + left, c["t"], c["vx"]))
        column[1].plot(1e3 * left, speed, "o", color=look[0], mec="white", ms=5, zorder=3)


def _slider_print(column: Sequence[Axes], robot: str, surface: str) -> None:
    """What the paper prints, and where contact begins."""
    printed = TABLE_III[robot, surface]
    after = -printed.restitution * SLIDER_SPEED
    line: dict[str, Any] = {"color": INK, "lw": 0.9, "ls": (0, (6, 2, 1, 2))}
    for ax in column:
        ax.axvline(0.0, color=GREY, lw=0.9, ls=(0, (3, 2)), zorder=1.5)
    column[0].axhline(0.0, color=GREY, lw=0.9, ls=(0, (3, 2)), zorder=1.5, label="contact begins")
    column[0].axhline(1e3 * printed.travel, **line, label="printed value")
    column[1].axhline(after, **line)
    column[1].margins(y=0.12)
    column[1].plot([], [], "o", color=GREY, mec="white", ms=5, label="end of contact")
    column[1].plot(
        1e3 * printed.contact_time, after, "D", color=INK, mfc="none", mew=1.3, ms=7, ls="none",
        zorder=4, label="end of contact, printed",
    )  # fmt: skip
    column[2].axhline(-printed.peak_acceleration, **line)


@styled
def sweep_figure(results: SliderResults) -> Figure:
    """Peak acceleration against speed, without the sliding bar, and how much less ARQ's is."""
    names = [r.name for r in results.readings if any(p.reading == r.name for p in results.sweep)]
    looks, points = _reading_looks(results), {(p.reading, p.speed): p for p in results.sweep}
    speeds = sorted({p.speed for p in results.sweep})
    figure = HouseFigure(figsize=(WIDTH, 4.4))
    upper, lower = figure.subplots(2, 1, sharex=True)
    bars = [("Quad", RED, [points[names[0], v].quad for v in speeds])] if names else []
    for n in names:
        bars.append((_short(f"ARQ, reading {n}"), looks[n][0], [points[n, v].arq for v in speeds]))
    _bars(upper, speeds, bars)
    gaps = [("", looks[n][0], [points[n, v].gap for v in speeds]) for n in names]
    _bars(lower, speeds, gaps, first=1)
    last = SWEEP_SPEEDS[-1]
    lower.hlines(
        SWEEP_GAP, last - 0.5, last + 0.5, color=INK, lw=1.6,
        label=f"printed at {last:g} m/s: {SWEEP_GAP:.0f} m/s²",
    )  # fmt: skip
    upper.set_ylabel("Peak acceleration [m/s²]")
    lower.set_ylabel("Quad less ARQ [m/s²]")
    lower.set_xlabel("Speed at touch [m/s]")
    lower.set_xticks(speeds, [f"{v:g}" for v in speeds])
    figure.align_ylabels([upper, lower])
    upper.legend(loc="upper left", ncols=1 + len(names) // 4)
    lower.legend(loc="upper left")
    return figure


def _bars(
    ax: Axes, speeds: Sequence[float], bars: list[tuple[str, str, list[float]]], first: int = 0
) -> None:
    """Groups of bars; ``first`` bars are left out on the left, to line up with the panel above."""
    hatches = ("", "//", "", "\\\\", "..", "xx", "--")
    width = 0.84 / max(len(bars) + first, 1)
    for k, (name, colour, heights) in enumerate(bars, first):
        left = [v - 0.42 + (k + 0.5) * width for v in speeds]
        ax.bar(
            left, heights, 0.92 * width, color=colour, label=name, hatch=hatches[k % len(hatches)],
            edgecolor="white", linewidth=0.0,
        )  # fmt: skip
    ax.grid(visible=False, axis="x")


@styled
def readings_figure(results: SliderResults) -> Figure:
    """Every reading against the four printed numbers of ARQ: ours over print, 1 is agreement."""
    rows = {
        (row.surface, row.reading, row.quantity): row.deviation
        for row in reversed(results.rows)  # so that the first of several, the prediction, stays
        if row.experiment == "Table III" and row.robot == "arq"
    }
    lines = [
        ("COR", "restitution_at_separation", "restitution_at_return"),
        ("peak\nacceleration", "peak_acceleration", ""),
        ("travel", "travel", ""),
        ("contact\ntime", "contact_time", "time_to_return"),
    ]
    figure = HouseFigure(figsize=(WIDTH, 2.9))
    axes = figure.subplots(1, 2, sharey=True, sharex=True)
    marks = ("s", "o", "^", "D", "v", "P")
    names, looks = [r.name for r in results.readings], _reading_looks(results)
    for ax, surface in zip(axes, SURFACES, strict=True):
        ax.axvspan(
            1 - AGREEMENT, 1 + AGREEMENT, color=SHADE, lw=0.0, zorder=0.1,
            label=f"within {100 * AGREEMENT:.0f} % of print",
        )  # fmt: skip
        ax.axvline(1.0, color=INK, lw=0.9)
        for k, name in enumerate(names):
            shift = 0.5 * (k / max(len(names) - 1, 1) - 0.5)
            colour, look = looks[name][0], marks[k % len(marks)]
            for which, face in ((2, "white"), (1, colour)):
                found = [
                    (rows.get((surface, name, line[which])), y) for y, line in enumerate(lines)
                ]
                known = [(1.0 + share, y + shift) for share, y in found if share is not None]
                ax.plot(
                    [x for x, _ in known], [y for _, y in known], look, ms=6, mew=1.2, color=colour,
                    mfc=face, label=None if which == 2 else _short(f"reading {name}"),
                )  # fmt: skip
        ax.set_title(f"ARQ on the {surface}")
        ax.set_xlabel("ours / printed [-]")
        ax.xaxis.set_major_locator(MaxNLocator(5))
    axes[0].set_yticks(range(len(lines)), [line[0] for line in lines])
    axes[0].set_ylim(len(lines) - 0.5, -0.5)
    axes[0].plot([], [], "o", color=GREY, mfc="white", mew=1.2, ms=6, label="open: at return")
    figure.legend(
        *axes[0].get_legend_handles_labels(), loc="outside upper center", ncols=3, handlelength=1.4
    )
    return figure


@styled
def energy_figure(*flights: Flight) -> Figure:
    """Where the energy went: what was put in, what each loss took, what was left.

    Shares are of what was put in: the energy at the start, the work of the rotors, and the fall.

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
    figure = HouseFigure(figsize=(WIDTH, (0.6 + 0.26 * len(shown)) * len(flights) + 0.35))
    axes = list(figure.subplots(len(flights), 1, sharex=True, squeeze=False)[:, 0])
    for ax, each, flight in zip(axes, steps, flights, strict=True):
        _waterfall(ax, [step for step in each if step[0] in shown])
        ax.set_title(_short(flight.scenario.name, 50))
    longest = max(ax.dataLim.x1 for ax in axes) if shown else 1.0
    axes[-1].set_xlim(0.0, 1.42 * longest)  # room for the numbers
    axes[-1].set_xlabel("Energy [J]")
    return figure


def _waterfall(ax: Axes, steps: list[tuple[str, float, str]]) -> None:
    """A bar for each step, each beginning where the last one ended; what is left begins at zero."""
    put_in = sum(value for name, value, _ in steps if value > 0.0 and not name.startswith("left"))
    level, leaving = 0.0, False
    for y, (name, value, colour) in enumerate(steps):
        if name.startswith("left") and not leaving:
            level, leaving = 0.0, True
        ax.barh(y, value, 0.72, left=level, color=colour)
        share = f" ({100.0 * abs(value) / put_in:.1f} %)" if put_in > 0.0 else ""
        sign = "−" if value < 0.0 else ""
        ax.annotate(
            f"{sign}{abs(value):.3g} J{share}", (max(level, level + value), y), (4, 0),
            textcoords="offset points", va="center", fontsize=8,
        )  # fmt: skip
        level += value
    ax.set_yticks(range(len(steps)), [name for name, _, _ in steps])
    ax.set_ylim(len(steps) - 0.4, -0.6)
    ax.grid(visible=False, axis="y")


def _energy_steps(flight: Flight) -> list[tuple[str, float, str]]:
    """Name, size and colour of every step: what put energy in, what took it, what is left."""
    m = {name: value or 0.0 for name, value in flight.measures.items()}
    rotors, height = m["work_thrust"], m["energy_gravity"]
    return [
        ("at the start", m["energy_start"], INK),
        ("rotors put in", max(rotors, 0.0), GREY),
        ("fall put in", max(-height, 0.0), GREY),
        ("rotors took", min(rotors, 0.0), SKY),
        ("contact damping", -m["loss_contact"], RED),
        ("arm dampers", -m["loss_arm"], BLUE),
        ("friction", -m["loss_friction"], ORANGE),
        ("end stops", -m["loss_stop"], PINK),
        ("locking the arms", -m["loss_settling"], GREY),
        ("left in motion", m["energy_kinetic"], GREEN),
        ("left in arm springs", m["energy_springs"], GREEN),
        ("left in contacts", m["energy_contact"], GREEN),
        ("left in end stops", m["energy_stops"], GREEN),
        ("left in height", max(height, 0.0), GREEN),
    ]


@styled
def readme_figure(results: SliderResults, reading: str = "B") -> Figure:
    """ARQ and Quad hit the wall on the slider: velocity and acceleration, for a front page."""
    cases = predictions(results, "quad", "wall") + [
        case for case in predictions(results, "arq", "wall") if case.reading.name == reading
    ]
    figure = HouseFigure(figsize=(8.0, 3.0))
    left, right = figure.subplots(1, 2)
    for case in cases:
        (t, touch), (colour, line) = _since_touch(case.flight), ROBOT_LOOKS[case.robot]
        c, m, name = case.flight.columns, case.flight.measures, ROBOTS[case.robot]
        kind = f"{name}, {'rigid' if case.robot == 'quad' else 'compliant'} arms"
        for ax, column in ((left, "vx"), (right, "ax")):
            ax.plot(t, c[column], color=colour, ls=line, lw=2.4, label=kind)
        peak, when = m["peak_acceleration"], m["peak_acceleration_time"]
        if peak is not None and when is not None:
            at = 1e3 * (when - touch)
            right.plot(at, -peak, "o", color=colour, ms=5)
            right.annotate(
                f"{name}: {peak:.0f} m/s²", (at, -peak), (48, 0), textcoords="offset points",
                color=colour, weight="bold", fontsize=10, va="center",
                arrowprops={"arrowstyle": "-", "color": colour, "lw": 1.0},
            )  # fmt: skip
    for ax, label in ((left, "Velocity [m/s]"), (right, "Acceleration [m/s²]")):
        ax.axvline(0.0, color=GREY, lw=0.9, ls=(0, (3, 2)), zorder=1.5)
        ax.set_xlim(-8.0, 52.0)
        ax.set_xlabel("Time from first touch [ms]")
        ax.set_title(label)
    left.legend(loc="upper right", fontsize=10)
    return figure
