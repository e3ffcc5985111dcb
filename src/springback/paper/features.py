"""Table I, key features of both robots: sizes, masses, payload and hover time.

Free numbers are few.  Quad's hover time fixes the figure of merit, Quad's payload the most thrust,
and ARQ has the same rotors and battery.  The mass of the battery is printed nowhere.  The library's
was chosen so that both hover times come out, so with it ARQ's hover time is fitted, too; with any
other battery ARQ's hover time is predicted from Quad's, and hardly depends on it.
"""

from __future__ import annotations

from typing import NamedTuple

from springback.studies.comparison import Mark, Row, predicted_or_contradicted
from springback.vehicle.endurance import figure_of_merit_for, hover_time, largest_payload
from springback.vehicle.library import BATTERY, PROPULSION, SPECIFIC_ENERGY, VEHICLES
from springback.vehicle.parameters import Vehicle


class Features(NamedTuple):
    """One column of Table I."""

    arm_length: float  # [m]
    size: float  # cage tip to tip [m]
    mass: float  # without battery [kg]
    inertia: tuple[float, float, float]  # I_xx, I_yy, I_zz [kg m²]
    largest_payload: float  # [kg]
    hover_time: float  # [s]


TABLE_I = {
    "arq": Features(0.19, 0.60, 1.034, (0.0100, 0.0116, 0.0197), 1.38, 461.0),
    "quad": Features(0.19, 0.60, 0.844, (0.0092, 0.0107, 0.0179), 1.64, 573.0),
}
"""Table I."""
CAGE_RADIUS = 0.11
"""[m], section II, radius of the protective cages."""
OTHER_BATTERIES = (0.2, 0.6)
"""[kg], chosen: half and one and a half of the library's battery, about."""


def _row(
    robot: str,
    quantity: str,
    unit: str,
    ours: float,
    printed: float | None,
    mark: Mark,
    note: str = "",
    reading: str = "",
) -> Row:
    return Row(
        "Table I", robot, "", reading, quantity, unit, ours, printed, None, mark, 0.0, "", note
    )


def _sizes(robot: str, vehicle: Vehicle, printed: Features) -> list[Row]:
    length, radius = vehicle.arms.at("length", 0), vehicle.arms.at("cage_radius", 0)
    size = 2.0 * (length + radius)
    return [
        _row(robot, "arm length", "m", length, printed.arm_length, Mark.GIVEN),
        _row(robot, "cage radius", "m", radius, CAGE_RADIUS, Mark.GIVEN, "section II"),
        _row(
            robot, "size, cage tip to tip", "m", size, printed.size,
            predicted_or_contradicted(size, printed.size), "2 (L + r_0)",
        ),
    ]  # fmt: skip


def _masses(robot: str, vehicle: Vehicle, printed: Features) -> list[Row]:
    whole = "main body and arms; put in for the whole, the arms' share taken off the body"
    rows = [
        _row(
            robot, "mass without battery", "kg", vehicle.mass - BATTERY, printed.mass, Mark.GIVEN
        ),
        _row(
            robot, "mass of the battery", "kg", BATTERY, None, Mark.FITTED,
            "to the ratio of both hover times; not printed",
        ),
    ]  # fmt: skip
    inertia = vehicle.inertia()
    for k, axis in enumerate("xyz"):
        rows.append(
            _row(
                robot, f"moment of inertia I_{axis}{axis}", "kg m^2", float(inertia[k, k]),
                printed.inertia[k], Mark.GIVEN, whole,
            )
        )  # fmt: skip
    return rows


def _payload(robot: str, vehicle: Vehicle, printed: Features) -> Row:
    ours = largest_payload(vehicle)
    lifted = vehicle.mass + printed.largest_payload
    surplus = vehicle.mass + ours - lifted
    fitted = robot == "quad"
    mark = Mark.FITTED if fitted else predicted_or_contradicted(ours, printed.largest_payload)
    note = (
        "most thrust chosen so; weight and payload are what the rotors just hold"
        if fitted
        else f"with Quad's rotors; they hold {1e3 * surplus:.0f} g more, whatever the battery "
        f"weighs, than weight and printed payload, {lifted:.2f} kg with this one"
    )
    return _row(
        robot, "largest payload", "kg", ours, printed.largest_payload, mark, note, "same rotors"
    )


def with_battery(vehicle: Vehicle, mass: float, figure_of_merit: float) -> Vehicle:
    """A robot of the library with a battery of another mass and the same energy per mass.

    Args:
        vehicle: ARQ or Quad as flown.
        mass: Of the battery [kg].
        figure_of_merit: Of its rotors; above 1 none exist, but the arithmetic holds.
    """
    body = vehicle.body.with_checked(mass=vehicle.body.mass + mass - BATTERY)
    own = {"battery_energy": mass * SPECIFIC_ENERGY, "figure_of_merit": figure_of_merit}
    propulsion = PROPULSION.with_checked(**own)
    return vehicle.with_checked(body=body, propulsion=propulsion)


def predicted_hover_time(battery: float) -> float:
    """ARQ's hover time from Quad's, with the same rotors and a battery of some mass [s].

    Args:
        battery: Mass [kg].
    """
    quad = with_battery(VEHICLES["quad"].vehicle, battery, 1.0)
    merit = figure_of_merit_for(quad, TABLE_I["quad"].hover_time)
    return hover_time(with_battery(VEHICLES["arq"].vehicle, battery, merit))


def _hover_times(robot: str, vehicle: Vehicle, printed: Features) -> list[Row]:
    note = "figure of merit" if robot == "quad" else "mass of the battery"
    ours, wanted = hover_time(vehicle), printed.hover_time
    rows = [
        _row(
            robot, "hover time", "s", ours, wanted, Mark.FITTED, f"{note} chosen so",
            f"battery {BATTERY:g} kg",
        )
    ]  # fmt: skip
    for battery in OTHER_BATTERIES if robot == "arq" else ():
        ours = predicted_hover_time(battery)
        rows.append(
            _row(
                robot, "hover time", "s", ours, wanted, predicted_or_contradicted(ours, wanted),
                "figure of merit fitted to Quad's hover time with this battery",
                f"battery {battery:g} kg",
            )
        )  # fmt: skip
    return rows


def feature_rows() -> list[Row]:
    """Table I for both robots: ours beside printed, each number marked."""
    rows = []
    for robot, printed in TABLE_I.items():
        vehicle = VEHICLES[robot].vehicle
        rows += _sizes(robot, vehicle, printed)
        rows += _masses(robot, vehicle, printed)
        rows.append(_payload(robot, vehicle, printed))
        rows += _hover_times(robot, vehicle, printed)
    return rows
