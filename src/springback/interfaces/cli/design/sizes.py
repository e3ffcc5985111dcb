"""Sizes and numbers of a vehicle that follow from a few answers, by formulas that a comment holds.

Shares and proportions are chosen, of vehicles of the library and of what is on sale: they are there
to be replaced by what is weighed and measured.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from springback.errors import InputError
from springback.vehicle.endurance import GRAVITY

#: Shares of the mass (chosen; of arq: ends of arms 14 %, battery 26 %).
ENDS, BATTERY, FRAME = 0.25, 0.25, 0.15
#: Damping ratio of the main body on the spring of one arm (chosen; of arq: 0.55).
DAMPING_RATIO = 0.55
#: Share of the way to its stop that an arm is to use (chosen).
USED = 0.8
#: Mean density of a lithium polymer pack, and of boards with wires and air [kg/m³] (chosen).
PACK, BOARDS = 2100.0, 700.0
#: Sides of a battery and of a stack of boards, relative to one of them (chosen).
PACK_SIDES, BOARD_SIDES = (2.2, 1.0, 0.9), (1.5, 1.0, 0.5)
#: Thrust over weight (chosen).
LIFT = 2.0
#: Thrust coefficient T/(ρ n² D⁴), largest tip speed [m/s] and torque over thrust and diameter of a
#: propeller (chosen: of five inch they give 15 N, and 13 mm).
THRUST_COEFFICIENT, TIP_SPEED, TORQUE_SHARE = 0.12, 250.0, 0.1
#: Lag of a rotor [s] up to a diameter [m], and in proportion beyond (RotorS's Hummingbird, 8 inch:
#: 12.5 ms up, 25 ms down, of which the slower).
LAG, LAG_DIAMETER = 0.025, 0.2032
#: Specific energy of a lithium polymer pack [J/kg], as of arq.
SPECIFIC_ENERGY = 140.0 * 3600.0
AIR = 1.225  # [kg/m³]
#: Gaps between guards, and between guard and body [m] (chosen).
GAP = 0.005


class SpringTarget(NamedTuple):
    """What an arm is to do at a wall."""

    stroke: float  # by which it gives in [m]
    speed: float  # of the vehicle, straight on [m/s]


class VehicleAnswer(NamedTuple):
    """An answer: its value in SI, its text, and whether it was given or is the default."""

    value: Any
    text: str
    is_given: bool

    @property
    def source(self) -> str:
        """Where the number is from, as a word for a comment."""
        return "given" if self.is_given else "chosen, as none was given"


class BodyBox(NamedTuple):
    """A part of the main body."""

    mass: float  # [kg]
    size: tuple[float, ...]  # [m]
    height: float  # of its middle [m]


class VehicleSizes(NamedTuple):
    """Numbers of a vehicle."""

    arms: int
    length: float  # of an arm [m]
    end_mass: float  # of what is at the end of each [kg]
    circle: float  # of the guard, or of the propeller [m]
    hub: float  # radius of what touches at the end of an arm without a guard [m]
    hull: float  # radius of the sphere about the body [m]
    body: float  # mass of the main body without the ends of the arms [kg]
    pushed: float  # mass that one arm has to stop: all but its end [kg]
    frequency: float  # undamped, of that mass on the spring of the arm [rad/s]; 0 for rigid arms
    stiffness: float  # [N/m]
    damping: float  # [N s/m]
    stop: float  # way to the stop [m]
    battery: BodyBox
    frame: BodyBox
    boards: BodyBox
    thrust: float  # most of one rotor [N]
    most_thrust: float  # that a propeller of this diameter gives [N]
    torque: float  # over thrust [m]
    lag: float  # [s]

    @property
    def directions(self) -> list[float]:
        """Of the arms, clockwise from the front left [deg]."""
        each = 360.0 / self.arms
        angles = [0.5 * each - k * each for k in range(self.arms)]
        return [angle + 360.0 if angle < -180.0 else angle for angle in angles]


def _stop(known: dict[str, VehicleAnswer]) -> float:
    """Way of an arm to its stop [m]; 0 for rigid arms."""
    spring = known["spring"].value
    return 0.0 if spring is None else math.ceil(1e3 * spring.stroke / USED) * 1e-3


def circle_of(known: dict[str, VehicleAnswer]) -> float:
    """Radius of the circle around a rotor: its guard, else its propeller [m]."""
    guard, propeller = known["guard"].value, 0.5 * known["propeller"].value
    if guard is None:
        return float(propeller)
    if guard < propeller:
        raise InputError(
            f"--guard: must be at least the radius of the propeller, {1e3 * propeller:.4g} mm "
            f"(got {known['guard'].text})"
        )
    return float(guard)


def _has_room(length: float, known: dict[str, VehicleAnswer]) -> bool:
    """True if circles are apart, one of them pressed in, and leave room for a body."""
    circle, stop = circle_of(known), _stop(known)
    turn = 2.0 * math.pi / known["arms"].value
    least = length - stop
    nearest = min(max(length * math.cos(turn), least), length)
    apart = math.sqrt(nearest**2 + length**2 - 2.0 * nearest * length * math.cos(turn))
    return apart >= 2.0 * circle + GAP and least - circle >= 0.4 * circle + GAP


def least_span(known: dict[str, VehicleAnswer]) -> float:
    """Least span at which guards do not meet and leave room for a body, in steps of 10 mm [m]."""
    span = 0.04
    while not _has_room(0.5 * span, known):
        span = round(span + 0.01, 3)
    return span


def _rounded(value: float, digits: int = 3) -> float:
    return float(f"{value:.{digits}g}")


def _box(mass: float, density: float, sides: tuple[float, ...], height: float = 0.0) -> BodyBox:
    """A box of some mass, density and proportions; sides in whole millimetres."""
    one = (mass / density / math.prod(sides)) ** (1.0 / 3.0)
    return BodyBox(mass, tuple(max(round(1e3 * one * side), 2) * 1e-3 for side in sides), height)


def ratio_of_peak() -> float:
    """Peak way of a damped oscillator over that of an undamped one: exp(−ζ/√(1−ζ²) arccos ζ)."""
    zeta = DAMPING_RATIO
    return math.exp(-zeta / math.sqrt(1.0 - zeta * zeta) * math.acos(zeta))


def sizes_of(known: dict[str, VehicleAnswer]) -> VehicleSizes:
    """All numbers of a vehicle.

    Args:
        known: An answer to each of `QUESTIONS`.

    Raises:
        InputError: If the answers do not fit together.
    """
    mass, count, propeller = (known[name].value for name in ("mass", "arms", "propeller"))
    length, circle, stop = 0.5 * known["span"].value, circle_of(known), _stop(known)
    if not _has_room(length, known):
        what = "guards" if known["guard"].value else "propellers"
        raise InputError(
            f"--span: must be at least {1e3 * least_span(known):.4g} mm, so that {count} {what} "
            f"of {2e3 * circle:.4g} mm diameter have room, one arm pressed in by {1e3 * stop:.4g} "
            f"mm (got {known['span'].text})"
        )
    thrust = _rounded(LIFT * mass * GRAVITY / count)
    most = THRUST_COEFFICIENT * AIR * (TIP_SPEED / math.pi) ** 2 * propeller**2
    if thrust > most:
        raise InputError(
            f"--propeller: must be larger for this mass: {known['propeller'].text} gives {most:.3g}"
            f" N at a tip speed of {TIP_SPEED:g} m/s, and twice the weight takes {thrust:.3g} N of "
            f"each of {count}"
        )
    end = _rounded(ENDS * mass / count)
    pack, frame = _rounded(BATTERY * mass), _rounded(FRAME * mass)
    rest = mass - count * end - pack - frame
    battery = _box(pack, PACK, PACK_SIDES)
    low = 0.5 * battery.size[2] + GAP
    side = round(1e3 * 0.6 * length * math.sqrt(2.0)) * 1e-3
    room = length - stop - circle - GAP
    boards = _box(rest, BOARDS, BOARD_SIDES)
    hull = min(max(0.5 * math.hypot(*box.size) for box in (battery, boards)), room)
    spring, pushed = known["spring"].value, mass - end
    frequency = 0.0 if spring is None else spring.speed / spring.stroke * ratio_of_peak()
    return VehicleSizes(
        count, length, end, circle, max(round(110.0 * propeller) * 1e-3, 2e-3),
        math.floor(1e3 * hull) * 1e-3, mass - count * end, pushed, frequency,
        _rounded(pushed * frequency**2), _rounded(2.0 * DAMPING_RATIO * pushed * frequency), stop,
        battery._replace(height=-round(1e3 * low, 1) * 1e-3),
        BodyBox(frame, (side, side, 4e-3), 0.0),
        boards._replace(height=round(1e3 * low * pack / rest, 1) * 1e-3),
        thrust, _rounded(most), _rounded(TORQUE_SHARE * propeller),
        _rounded(LAG * max(1.0, propeller / LAG_DIAMETER)),
    )  # fmt: skip
