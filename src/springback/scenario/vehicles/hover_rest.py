"""Where arms on joints rest while a vehicle hovers: by their springs, or on stops."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import scipy  # submodules are loaded on first use

from springback.kernels.vectors import Mat3, Vec
from springback.vehicle.arms.bent import BentArm, BentCoordinates
from springback.vehicle.arms.joints import JointedArm, joint_spring
from springback.vehicle.arms.settings import radius_of
from springback.vehicle.parameters import Vehicle
from springback.vehicle.placed.rotors import (
    NumberedMount,
    PlacedRotor,
    mount_of,
    rotor_load,
    rotor_pose,
)

#: Share of the travel to one side from which a rest at hover is worth a warning (chosen).
NEARLY = 0.9
#: Places in the travel at which a latch may let go (chosen), and rounds over the joints of an arm,
#: which move each other, until they move by less than this [m] (chosen: far more than are needed).
PLACES, ROUNDS, STILL = 60, 20, 1e-7
#: Travels beyond a stop in which it is said where the spring would hold the arm (chosen).
BEYOND = 3.0
_UPRIGHT = Mat3(Vec(1.0, 0.0, 0.0), Vec(0.0, 1.0, 0.0), Vec(0.0, 0.0, 1.0))


class JointRest(NamedTuple):
    """A joint of an arm at hover."""

    arm: int  # from 1
    joint: int  # 1, or 2 for one that the first carries
    pressed: float  # from the free position, positive pressed in [m], of a hinge [rad]
    stop: float  # end of the travel on that side, with its sign [m], of a hinge [rad]
    balance: float | None  # where the spring alone would hold it; None if nowhere near [m] or [rad]
    is_hinge: bool

    @property
    def share(self) -> float:
        """Of the travel to that side, from 0 to 1."""
        return self.pressed / self.stop if self.stop else 0.0


def hover_warnings(vehicle: Vehicle, gravity: float) -> list[str]:
    """A sentence on the joint that hover moves the most, if that is to its stop or nearly so.

    Args:
        vehicle: Any.
        gravity: g [m/s²].
    """
    worst = max(resting_joints(vehicle, gravity), key=lambda one: one.share, default=None)
    if worst is None or worst.share < NEARLY:
        return []
    unit = "rad" if worst.is_hinge else "m"
    path = "vehicle.arms.joint" + (".second" if worst.joint == 2 else "")
    words = ("turns", "about") if worst.is_hinge else ("moves", "along")
    end = _brief(worst.stop, unit)
    place = f"to its stop at {end}"
    if worst.share < 1.0:
        place = f"by {_brief(worst.pressed, unit)}, and its stop is at {end}"
    elif worst.balance is not None:
        place += f" (its spring would hold it at {_brief(worst.balance, unit)})"
    return [
        f"{path}: hover thrust {words[0]} arm {worst.arm} {words[1]} this joint {place}: arms that "
        "are free then bottom out before anything is hit, and hybrid ones as soon as a hit frees "
        "them, not because of the hit; give a stiffer spring or a longer travel"
    ]


def _brief(way: float, unit: str) -> str:
    """Size of a way [m] or an angle [rad], briefly."""
    return f"{1e3 * abs(way):.3g} mm" if unit == "m" else f"{abs(math.degrees(way)):.3g} deg"


def resting_joints(vehicle: Vehicle, gravity: float) -> Iterator[JointRest]:
    """Every joint of every compliant arm on joints, at rest under its share of the weight.

    Springs between neighbours are left out, and so are vehicles that have them.

    Args:
        vehicle: Any.
        gravity: g [m/s²].
    """
    if vehicle.arms.is_planar or vehicle.arms.neighbours is not None:
        return
    if vehicle.rotors and not any(one.lifts for one in vehicle.rotors):
        return
    airframe = vehicle.airframe()
    thrusts = vehicle.hover_thrusts(vehicle.mass * gravity)
    for j, arm in enumerate(airframe.arms):
        if not isinstance(arm, JointedArm | BentArm) or not arm.compliance > 0.0:
            continue
        if vehicle.rotors:
            known = zip(airframe.rotors.each, thrusts, strict=True)
            rotors = [(one, thrust) for one, thrust in known if one.arm == j + 1.0]
        else:
            alone = PlacedRotor(j + 1.0, Vec(0.0, 0.0, 0.0), _UPRIGHT, arm.torque_ratio, 1.0)
            rotors = [(alone, thrusts[j])]
        yield from _resting(vehicle, j, arm, rotors, gravity)


def _resting(
    vehicle: Vehicle, j: int, arm: Any, rotors: list[tuple[PlacedRotor, float]], gravity: float
) -> Iterator[JointRest]:
    """The joints of one arm, from 0, under its weight and the thrusts [N] of the rotors on it."""
    parts = (arm, arm.second) if isinstance(arm, BentArm) else (arm,)

    def pull(which: int, lengths: list[float]) -> float:
        """Force along the path of a joint that makes it longer [N]."""
        at: Any = BentCoordinates(*lengths) if len(lengths) == 2 else lengths[0]
        still: Any = BentCoordinates(0.0, 0.0) if len(lengths) == 2 else 0.0
        mount = mount_of(arm, at, still)
        weight = Vec(0.0, 0.0, -arm.mass * gravity)
        ways = (mount.direction, *(way.direction for way in mount.second))
        found = ways[which] @ weight + joint_spring(parts[which], lengths[which]).force
        for rotor, thrust in rotors:
            pose = rotor_pose(rotor, (NumberedMount(j + 1.0, mount),))
            load = rotor_load(pose, rotor, thrust)
            found += (load.along, *load.second)[which]
        return float(found)

    lengths = [part.length for part in parts]

    def balance(which: int, shortest: float, longest: float) -> float:
        """Length at which a joint rests, or the one of two ends at which it does not [m]."""
        part = parts[which]

        def alone(length: float) -> float:
            return pull(which, [*lengths[:which], length, *lengths[which + 1 :]])

        places = PLACES if part.spring.latch else 1
        return _balance(alone, part.length, shortest, longest, places)

    for _ in range(ROUNDS):
        before = list(lengths)
        for which, part in enumerate(parts):
            lengths[which] = balance(which, part.shortest, part.longest)
        if max(abs(x - y) for x, y in zip(before, lengths, strict=True)) < STILL:
            break
    for which, part in enumerate(parts):
        free, length = part.length, lengths[which]
        stop = part.shortest if length < free else part.longest
        over = 1.0 / radius_of(part.joint)
        held: float | None = None
        if length == stop != free:
            far = free + BEYOND * (stop - free)
            beyond = balance(which, min(free, far), max(free, far))
            held = None if beyond == far else (free - beyond) * over
        yield JointRest(
            j + 1, which + 1, (free - length) * over, (free - stop) * over, held,
            vehicle.arms.hinges[which],
        )  # fmt: skip


def _balance(
    pull: Callable[[float], float], free: float, shortest: float, longest: float, places: int
) -> float:
    """Length at which nothing pulls any more on the way from the free position [m]; else a stop.

    Args:
        pull: Force that makes a length longer [N].
        free: Where it begins [m].
        shortest: One stop [m].
        longest: The other [m].
        places: Number of steps to the stop, for a force that does not only fall on the way.
    """
    first = pull(free)
    stop = longest if first > 0.0 else shortest
    if first == 0.0 or stop == free:
        return free
    here = free
    for k in range(1, places + 1):
        there = free + (stop - free) * (k / places)
        if pull(there) * first <= 0.0:
            return float(scipy.optimize.brentq(pull, here, there, xtol=0.1 * STILL))
        here = there
    return stop
