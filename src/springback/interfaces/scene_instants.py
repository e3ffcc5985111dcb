"""Which instants of a flight are drawn, and what the cages feel at each of them.

A trajectory has every step of the integration.  A picture needs all of them near a contact and few
elsewhere, so some are left out; what straight lines between those that stay get wrong is bounded by
`BOUNDS`, and measured.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from springback.contact.cage import Meeting, meeting
from springback.contact.hull import hull_meeting
from springback.contact.obstacles import Obstacle, World, obstacle_seen
from springback.dynamics.energy import Energy, energy
from springback.kernels.compiler import executor, kernel, own_executor
from springback.kernels.layout import Buffer, Like, read, write
from springback.kernels.trees import each, leaves, total
from springback.kernels.vectors import Mat, Quat, Vec, rotation
from springback.simulation.flight import own_types, sources
from springback.simulation.record import Model
from springback.vehicle.state import Airframe, Arm, Sphere, State, arm_pose

Array = np.ndarray[Any, np.dtype[np.float64]]
Places = np.ndarray[Any, np.dtype[np.intp]]

#: Of what the lines between the kept instants may get wrong, by unit; chosen: finer than a pixel.
BOUNDS = {"m": 2e-4, "": 2e-4, "m/s": 5e-3}
#: The same for arm lengths [m], accelerations [m/s²] and forces [N]; the last two have besides ...
ARM_BOUND, ACCELERATION_BOUND, FORCE_BOUND = 2e-5, 0.5, 0.5
#: ... this share of their peak.
SHARE = 0.01
#: Apart at most [s]: 200 instants a second.
APART = 5e-3
#: Every step is kept so long before and after a contact [s], ...
NEAR = 5e-3
#: ... as long as that makes no more than so many instants; chosen: 0.2 s at a step of 0.1 ms.
MOST_NEAR = 2000
#: Largest group of steps that may become one line; a power of 2.
GROUP = 64
#: Contact forces below this count as none [N].
NOTHING = 1e-9


def parts_of(columns: Mapping[str, Array]) -> list[str]:
    """What the columns of forces on each cage, and on the main body with a hull, end with."""
    return [name[2:] for name in columns if name.startswith("fn")]


def touching(columns: Mapping[str, Array]) -> np.ndarray[Any, np.dtype[np.bool_]]:
    """Whether anything touches anything, instant by instant."""
    felt = [columns[f"fn{k}"] + columns[f"ff{k}"] > NOTHING for k in parts_of(columns)]
    return np.asarray(np.logical_or.reduce(felt), dtype=np.bool_)


def intervals(t: Array, felt: Any, apart: float = 0.0) -> list[tuple[int, int]]:
    """First and last place of every contact; those less than ``apart`` [s] apart are one.

    Args:
        t: Instants [s].
        felt: Whether there is contact at each.
        apart: [s].
    """
    edges = np.flatnonzero(np.diff(np.concatenate([[0], np.asarray(felt, dtype=int), [0]])))
    found: list[tuple[int, int]] = []
    for first, last in zip(edges[0::2].tolist(), (edges[1::2] - 1).tolist(), strict=True):
        if found and t[first] - t[found[-1][1]] < apart:
            found[-1] = (found[-1][0], last)
        else:
            found.append((first, last))
    return found


def _bounded(columns: Mapping[str, Array], arms: int) -> tuple[Array, Array]:
    """What is drawn, shape (instants, quantities), and the bound of each."""
    names = dict.fromkeys("xyz", BOUNDS["m"])
    names |= {f"q{part}": BOUNDS[""] for part in "wxyz"}
    names |= {f"v{axis}": BOUNDS["m/s"] for axis in "xyz"}
    forces = [f"{kind}{k}" for kind in ("fn", "ff") for k in parts_of(columns)]
    peak = max((float(np.max(np.abs(columns[name]), initial=0.0)) for name in forces), default=0.0)
    hardest = max(float(np.max(np.abs(columns[f"a{axis}"]), initial=0.0)) for axis in "xyz")
    names |= {f"l{j}": ARM_BOUND for j in range(1, arms + 1)}
    names |= {f"a{axis}": max(ACCELERATION_BOUND, SHARE * hardest) for axis in "xyz"}
    names |= dict.fromkeys(forces, max(FORCE_BOUND, SHARE * peak))
    return np.stack([columns[name] for name in names], axis=1), np.array(list(names.values()))


def _departures(t: Array, values: Array, group: Places, size: int) -> Array:
    """Largest departure from the line between the ends, of each group of ``size`` steps.

    Args:
        t: Instants [s].
        values: Over their bounds, shape (instants, quantities).
        group: First places of the groups.
        size: Steps in a group.
    """
    inside = group[:, None] + np.arange(1, size)
    share = (t[inside] - t[group][:, None]) / (t[group + size] - t[group])[:, None]
    first, last = values[group][:, None, :], values[group + size][:, None, :]
    line = first + share[:, :, None] * (last - first)
    return np.asarray(np.abs(values[inside] - line).max(axis=(1, 2)))


def kept(columns: Mapping[str, Array], arms: int) -> Places:
    """Places of the instants that are drawn.

    All within `NEAR` of a contact, up to `MOST_NEAR` of them; elsewhere as few as `BOUNDS` and
    `APART` allow, found by halving groups of steps until each is near enough to a line.
    """
    t = columns["t"]
    values, bounds = _bounded(columns, arms)
    values = values / bounds
    keep = np.zeros(len(t), dtype=bool)
    keep[[0, -1]] = True
    close = 0
    for first, last in intervals(t, touching(columns)):
        begin, end = np.searchsorted(t, [t[first] - NEAR, t[last] + NEAR])
        keep[[max(first - 1, 0), first, last, min(last + 1, len(t) - 1)]] = True
        end = min(int(end), int(begin) + MOST_NEAR - close)
        if end > begin:
            keep[begin:end] = True
            close += end - int(begin)
    return np.flatnonzero(keep | _needed(t, values))


def _needed(t: Array, values: Array) -> Any:
    """Ends of the lines that are near enough to everything between."""
    keep = np.zeros(len(t), dtype=bool)
    steps = len(t) - 1
    groups = np.arange(0, steps - GROUP + 1, GROUP)
    keep[len(groups) * GROUP :] = True  # fewer than a group are left over
    size = GROUP
    while size > 1 and len(groups):
        wide = t[groups + size] - t[groups] > APART * (1.0 + 1e-9)
        coarse = wide.copy()
        coarse[~wide] = _departures(t, values, groups[~wide], size) > 1.0
        keep[groups[~coarse]] = True
        halves = groups[coarse]
        size //= 2
        groups = np.sort(np.concatenate([halves, halves + size]))
    keep[groups] = True
    return keep


def departure(columns: Mapping[str, Array], arms: int, places: Places) -> dict[str, float]:
    """What lines between the kept instants get wrong at most: m, m of arms, m/s², N, and so on."""
    t = columns["t"]

    def worst(*names: str) -> float:
        return max(
            float(np.max(np.abs(np.interp(t, t[places], columns[n][places]) - columns[n])))
            for n in names
        )

    numbers = range(1, arms + 1)
    return {
        "position": worst("x", "y", "z"),
        "attitude": worst("qw", "qx", "qy", "qz"),
        "arm_length": worst(*(f"l{j}" for j in numbers)),
        "velocity": worst("vx", "vy", "vz"),
        "acceleration": worst("ax", "ay", "az"),
        "force": worst(*(f"{kind}{k}" for kind in ("fn", "ff") for k in parts_of(columns))),
    }


# -- what the cages feel --------------------------------------------------------------------------


class Press(NamedTuple):
    """What one cage, or the hull, feels of all obstacles."""

    force: Vec  # on it, world [N]
    normal: float  # sum of the f_n [N]
    friction: Vec  # sum of the f_f, world [N]
    point: Vec  # where the normal forces act, the mean weighted with them; world [m], times N


class Instant(NamedTuple):
    """What is asked at one instant."""

    airframe: Airframe
    world: World
    contact_point: Any
    state: State


class Look(NamedTuple):
    """What is answered."""

    parts: tuple[Press, ...]  # cages, then the hull if there is one
    stored: Energy


@kernel
def _press(
    obstacle: Obstacle, contact_point: Any, radius: float, arm: Any, omega: Vec, vertical: Vec
) -> Press:
    """One cage against one obstacle, in body axes from the main body."""
    return _press_of(meeting(obstacle, contact_point, radius, arm, omega, vertical))


@kernel
def _press_of(met: Meeting) -> Press:
    f_n = met.touch.normal
    return Press(met.touch.force, f_n, met.touch.friction, f_n * met.pressing_at)


@kernel
def _on_hull(obstacle: Obstacle, hull: Sphere, velocity: Vec, omega: Vec, vertical: Vec) -> Press:
    return _press_of(hull_meeting(obstacle, 1.0, hull, velocity, omega, vertical, 0.0))


@kernel
def _arm_press(
    arm: Arm,
    length: float,
    rate: float,
    obstacles: tuple[Obstacle, ...],
    contact_point: Any,
    state: State,
    r: Mat,
) -> Press:
    omega, vertical = state.angular_velocity, Vec(r.z.x, r.z.y, r.z.z)
    pose = arm_pose(arm, length, rate, state.velocity @ r)
    felt = each(_press, (obstacles,), (contact_point, arm.cage_radius, pose, omega, vertical))
    return _in_world(total(felt), state, r)


@kernel
def _in_world(p: Press, state: State, r: Mat) -> Press:
    point = r @ p.point + p.normal * state.position
    return Press(r @ p.force, p.normal, r @ p.friction, point)


@kernel
def _hull_press(hull: Sphere, obstacles: tuple[Obstacle, ...], state: State, r: Mat) -> Press:
    omega, vertical = state.angular_velocity, Vec(r.z.x, r.z.y, r.z.z)
    felt = each(_on_hull, (obstacles,), (hull, state.velocity @ r, omega, vertical))
    return _in_world(total(felt), state, r)


@kernel
def _look(at: Instant) -> Look:
    state = at.state
    r = rotation(state.attitude)
    obstacles = each(obstacle_seen, (at.world.obstacles,), (state.position, r))
    arms = each(
        _arm_press,
        (at.airframe.arms, state.arm_length, state.arm_rate),
        (obstacles, at.contact_point, state, r),
    )
    parts = arms + each(_hull_press, (at.airframe.hull,), (obstacles, state, r))
    return Look(parts, energy(at.airframe, at.world, at.contact_point, state))


@executor(nogil=True)
def _looked(like: Like, instants: Buffer, out: Buffer) -> None:
    """`Look` at every instant; a row of each buffer is the leaves of one."""
    for i in range(instants.shape[0]):
        write(_look(read(like, instants[i], 0, 1, 0)), out[i], 0, 1, 0)


class Felt(NamedTuple):
    """Contacts and energies over time."""

    force: Array  # on each cage, then the hull, world [N], shape (instants, parts, 3)
    normal: Array  # f_n [N], shape (instants, parts)
    friction: Array  # |f_f| [N], shape (instants, parts)
    point: Array  # where it acts, world [m], shape (instants, parts, 3); NaN where nothing touches
    energy: dict[str, Array]  # `Energy` by name [J], each of shape (instants,)


def _states(columns: Mapping[str, Array], arms: int, places: Places) -> Array:
    """Leaves of `State`, a row an instant."""
    names = [*"xyz", *(f"q{p}" for p in "wxyz"), *(f"v{a}" for a in "xyz"), *("wx", "wy", "wz")]
    names += [f"{kind}{j}" for kind in ("l", "dl") for j in range(1, arms + 1)]
    return np.stack([columns[name][places] for name in names], axis=1)


def felt(model: Model, columns: Mapping[str, Array], places: Places) -> Felt:
    """What the package's own contact laws say of the instants of a trajectory.

    Args:
        model: Of the flight.
        columns: Its trajectory.
        places: Of the instants.
    """
    arms = len(model.airframe.arms)
    states = _states(columns, arms, places)
    zero, lengths = Vec(0.0, 0.0, 0.0), (0.0,) * arms
    still = State(zero, Quat(1.0, 0.0, 0.0, 0.0), zero, zero, lengths, lengths)
    asked = Instant(model.airframe, model.world, model.contact_point, still)
    constants = np.array(leaves(asked)[: -states.shape[1]])
    instants = np.concatenate(
        [np.broadcast_to(constants, (len(states), len(constants))), states], 1
    )
    parts = arms + len(model.airframe.hull)
    out = np.zeros((len(states), 10 * parts + len(Energy._fields)))
    own = own_types(asked)
    plain = getattr(_looked, "py_func", _looked)
    run = own_executor(plain, sources(own), nogil=True) if own else _looked
    run(Like(asked), np.ascontiguousarray(instants), out)
    each_part = out[:, : 10 * parts].reshape(len(out), parts, 10)
    normal = each_part[:, :, 3]
    with np.errstate(divide="ignore", invalid="ignore"):
        point = np.where(
            normal[..., None] > NOTHING, each_part[:, :, 7:] / normal[..., None], np.nan
        )
    stored = {name: out[:, 10 * parts + k] for k, name in enumerate(Energy._fields)}
    friction = np.linalg.norm(each_part[:, :, 4:7], axis=2)
    return Felt(each_part[:, :, :3], normal, friction, point, stored)
