"""Tables of springs that end before the travel of their joint does."""

from __future__ import annotations

from collections.abc import Iterator

from springback.quantities import with_unit
from springback.vehicle.arms.joint_settings import HingeSettings, SecondHinge
from springback.vehicle.force_curves import force_table, pressed_at
from springback.vehicle.parameters import Vehicle

#: Share of a travel by which a table may end early (chosen: points are written to three digits).
NEARLY = 0.01


def spring_table_warnings(vehicle: Vehicle) -> list[str]:
    """A sentence on the first table that ends before the travel of its joint, if one does.

    Args:
        vehicle: Any.
    """
    return list(_short_tables(vehicle))[:1]


def _short_tables(vehicle: Vehicle) -> Iterator[str]:
    joint = vehicle.arms.joint
    if joint is None:
        return
    for given, name in ((joint, "joint"), (joint.second, "joint.second")):
        if given is None:
            continue
        for j in range(vehicle.arm_count):
            table = given.table_of(j)
            if not table or not vehicle.arms.at("compliant", j):
                continue
            is_hinge = isinstance(given, HingeSettings | SecondHinge)
            end, most = table[-1]
            way = max(map(abs, given.travel_of(j)))
            if end < (1.0 - NEARLY) * way:
                unit, force = ("rad", "N m") if is_hinge else ("m", "N")
                there = pressed_at(force_table(table), way).force
                yield (
                    f"vehicle.arms.{name}.table: ends at {with_unit(end, unit)}, {most:.4g} "
                    f"{force}, and the travel of arm {j + 1} at {with_unit(way, unit)}: beyond its "
                    f"last point it goes on with its last slope, to {there:.4g} {force}"
                )
