"""Slides of arms that lead out of the vehicle, against their stops, or through its middle."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from springback.quantities import with_unit
from springback.settings import problem
from springback.vehicle.arms.joint_settings import SecondSlide, SlideSettings
from springback.vehicle.arms.settings import Arms
from springback.vehicle.parameters import Vehicle

#: Share of a slide's way along its arm from which it is mainly along it (chosen: within 45 deg;
#: legs that yield upward and a little outward are not).
MAINLY = 0.7


class _Slide(NamedTuple):
    """A slide of a compliant arm."""

    path: str  # of its table
    arm: int  # from 1
    direction: tuple[float, float, float]  # as given, in the arm's axes
    inward: float  # share of its way, pressed in, that leads along the arm to the vehicle's middle
    travel: tuple[float, float]  # [m]
    length: float  # of the arm [m]


def _slides(arms: Arms) -> Iterator[_Slide]:
    """Slides of compliant arms, of first joints and of those that they carry."""
    if arms.joint is None:
        return
    for j in range(len(arms.directions)):
        for given, name in ((arms.joint, "joint"), (arms.joint.second, "joint.second")):
            if not isinstance(given, SlideSettings | SecondSlide) or not arms.at("compliant", j):
                continue
            second = arms.second_joint(j) if given is arms.joint.second else None
            longer = (arms.joint_of(j) if second is None else second.joint).direction
            end = arms.end(j)
            length = arms.at("length", j)
            inward = (longer.x * end.x + longer.y * end.y) / length
            vector: Any = given.direction
            vector = vector[j] if isinstance(vector[0], tuple) else vector
            travel = given.travel_of(j)
            yield _Slide(f"vehicle.arms.{name}", j + 1, vector, inward, travel, length)


def check_slides(arms: Arms) -> None:
    """Reject slides along arms whose travel leads beyond the vehicle's middle.

    Of two joints each is looked at while the other is free.

    Args:
        arms: Of any vehicle.

    Raises:
        The problem of the travel, with where it must end.
    """
    for one in _slides(arms):
        for way, bound in zip(one.travel, ("more", "less"), strict=True):
            if (one.inward > MAINLY or one.inward < -MAINLY) and way * one.inward >= one.length:
                raise problem(
                    f"must be {bound} than {one.length / one.inward:.6g} m, where the end of arm "
                    f"{one.arm} comes to the vehicle's middle (got {way:g} m)",
                    f"{one.path}.travel",
                )


def slide_warnings(vehicle: Vehicle) -> list[str]:
    """A sentence on the first slide whose travel leads out of the vehicle alone, if one does.

    Args:
        vehicle: Any.
    """
    if not vehicle.arms.end_stops:
        return []
    for one in _slides(vehicle.arms):
        low, high = one.travel
        if one.inward > -MAINLY or low < 0.0:
            continue
        x, y, z = one.direction
        return [
            f"{one.path}.direction: [{x:g}, {y:g}, {z:g}] leads outward, and travel, "
            f"{with_unit(low, 'm')} to {with_unit(high, 'm')}, not inward: what meets the "
            f"{vehicle.guard_word} of arm {one.arm} from outside presses it against its stop, and "
            f"its spring does not act; [{-x:g}, {y:g}, {z:g}] leads inward, or travel from below "
            "0 m"
        ]
    return []
