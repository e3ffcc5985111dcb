"""Arms as a flight begins: at rest, or pressed in on their joints, as far as these allow."""

from __future__ import annotations

from springback.quantities import PerArm
from springback.settings import problem
from springback.vehicle.arms.joints import preload_strain
from springback.vehicle.arms.settings import Arms
from springback.vehicle.state import Bend


def bends_at_start(arms: Arms, pressed: PerArm) -> tuple[Bend, ...]:
    """Second coordinates of arms that are pressed in on their second joints.

    From rest, where they are free but for a preload, which presses the stop; empty for arms on one
    joint.

    Args:
        arms: The arms.
        pressed: By which they are pressed in, one for all or each [m].
    """
    joints, found = [arms.second_joint(j) for j in range(len(arms.directions))], []
    for j, one in enumerate(joints):
        if one is None:
            continue
        strained = one.compliance > 0.0 and one.spring.preload > 0.0
        given = (one.spring, one.stiffness, one.stop_stiffness)
        rest = preload_strain(*given) if strained else 0.0
        found.append(Bend(rest - _of_arm(pressed, j), 0.0))
    return tuple(found)


def check_compression(arms: Arms, first: PerArm, second: PerArm) -> None:
    """Reject arms that begin beyond their travel, and rigid ones that do not begin free.

    Args:
        arms: The arms.
        first: By which they are pressed in, on their first joint if they have two [m].
        second: The same of the second joint [m].
    """
    for key, given in (("compression", first), ("second_compression", second)):
        count, field = len(arms.directions), f"start.{key}"
        if isinstance(given, tuple) and len(given) != count:
            raise problem(f"has {len(given)} entries for {count} arms", field)
        for j in range(count):
            pressed = _of_arm(given, j)
            low, high = arms.travel(j)
            if key == "second_compression":
                joint = arms.second_joint(j)
                if joint is None:
                    if pressed != 0.0:
                        raise problem(
                            f"needs arms on two joints: a second one, vehicle.arms.joint.second "
                            f"(got {pressed:g} m)",
                            field,
                        )
                    continue
                low, high = -joint.longest, -joint.shortest
            low, high = (low, high) if arms.at("compliant", j) else (0.0, 0.0)
            if not low <= pressed <= high:
                what = "travel" if arms.at("compliant", j) else "travel, as it is rigid"
                raise problem(
                    f"of arm {j + 1} must be within its {what}, {low:.6g} to {high:.6g} m "
                    f"(got {pressed:g} m)",
                    field,
                )


def _of_arm(given: PerArm, j: int) -> float:
    return given[j] if isinstance(given, tuple) else given
