"""Published vehicles whose arms or legs yield, each number with its source.

What their authors do not print is chosen, and says so; what was fitted names the recording.
"""

from __future__ import annotations

from math import cos, pi, sin
from typing import Any

from springback.vehicle.arms.joint_settings import HingeSettings, SecondHinge
from springback.vehicle.arms.settings import Arms
from springback.vehicle.force_laws import HullSurface
from springback.vehicle.hulls import CapsuleHull
from springback.vehicle.parameters import Body, Hull, Vehicle
from springback.vehicle.propulsion import Propulsion
from springback.vehicle.published import (
    CHOSEN,
    RIGID_ARMS,
    TWICE,
    Entry,
    Place,
    corners,
    rotors_at,
    thrust_for,
)

# -- Morphy ----------------------------------------------------------------------------------------

_MORPHY = "Aerial Gym's model of the robot"
#: Place of the front left hinge, length of an arm [m] and mass at its end [kg].
_HINGE, _ARM, _MOTOR = (0.04, 0.032), 0.07, 0.01625
#: Angular acceleration of an arm about its hinge: −5834 θ |θ| − 230 θ̇ [1/s², 1/s].
_QUADRATIC, _DAMPING = 5834.0, 230.0


def morphy_vehicle(body_mass: float, inertia: tuple[float, float, float], **more: Any) -> Vehicle:
    """Morphy with a main body of some mass [kg] and inertia [kg m²]."""
    signs = ((1.0, 1.0), (1.0, -1.0), (-1.0, -1.0), (-1.0, 1.0))
    reach = _ARM * cos(pi / 4)
    ends = [(x * (_HINGE[0] + reach), y * (_HINGE[1] + reach)) for x, y in signs]
    free = rotors_at(tuple(ends), 0.042, 0.01, cages=True)
    places, axes = [], []
    for (x, y), angle in zip(signs, free.directions, strict=True):
        hinge = (x * _HINGE[0], y * _HINGE[1])
        # Up: about the horizontal axis to the right of the arm, which points along (x, y).
        right = (y * sin(pi / 4), -x * cos(pi / 4))
        places.append((*_turned(hinge, -angle), 0.0))
        axes.append((*_turned(right, -angle), 0.0))
    square = _MOTOR * _ARM * _ARM
    law = {"quadratic": _QUADRATIC * square, "damping": _DAMPING * square}
    sideways = SecondHinge(
        type="hinge", position=tuple(places), axis=(0.0, 0.0, 1.0), travel=(-0.1, 0.1), **law
    )
    joint = HingeSettings(
        type="hinge", position=tuple(places), axis=tuple(axes), travel=(-0.376, 0.376),
        second=sideways, **law,
    )  # fmt: skip
    arms = Arms(
        directions=free.directions, length=free.length, mass=_MOTOR, cage_radius=0.042, joint=joint,
        torque_ratio=0.01,
    )  # fmt: skip
    return Vehicle(
        name="morphy", body=Body(mass=body_mass, inertia=inertia), arms=arms,
        propulsion=Propulsion(max_thrust=2.0, time_constant=0.02), **more,
    )  # fmt: skip


def _turned(place: Place, angle: float) -> Place:
    x, y = place
    return x * cos(angle) - y * sin(angle), x * sin(angle) + y * cos(angle)


MORPHY = Entry(
    morphy_vehicle(0.225, (4.225e-4, 4.225e-4, 8.45e-4), hull=Hull(radius=0.04)),
    "NTNU's Morphy: arms of elastomer that bend up and down, and a little to either side",
    {
        "body.mass": f"given: {_MORPHY}",
        "body.inertia": f"given: {_MORPHY}",
        "hull.radius": "chosen: 40 mm, about the core",
        "arms.directions": f"derived: {_MORPHY}, hinges at 40 mm and 32 mm, arms at 45 deg",
        "arms.length": f"derived: {_MORPHY}, arms of 70 mm from their hinges",
        "arms.mass": f"given: {_MORPHY}, at the end of an arm",
        "arms.joint": f"given: {_MORPHY}: angular acceleration −5834 θ|θ| − 230 θ̇ of the mass at "
        "the end of an arm, which its authors fitted to an arm that was let go; there ±0.25 rad "
        "about a rest position of 7.2 deg, here ±0.376 about level; to the side ±0.1 rad by the "
        "same law, about the same point, there as well with a rest of 7.2 deg, here straight",
        "arms.cage_radius": "chosen: 42 mm, of propellers of 3 inch; the robot has no guards",
        "arms.torque_ratio": f"given: {_MORPHY}, torque over thrust",
        "propulsion.max_thrust": f"given: {_MORPHY}, at most 2 N each",
        **CHOSEN,
        "propulsion.time_constant": f"derived: {_MORPHY}, 10 to 30 ms up, 5 ms down",
    },
)

# -- XPLORER ---------------------------------------------------------------------------------------

_XPLORER = "the paper of XPLORER (arXiv:2305.17217)"
_TIP = 0.06  # mass at the end of an arm [kg]
_SPAN = 0.18  # [m]

XPLORER = Entry(
    Vehicle(
        name="xplorer",
        body=Body(
            mass=1.174 - 4.0 * _TIP,
            inertia=(
                0.01116 - 2.0 * _TIP * _SPAN**2,
                0.01126 - 2.0 * _TIP * _SPAN**2,
                0.01854 - 4.0 * _TIP * _SPAN**2,
            ),
        ),
        hull=Hull(radius=0.06),
        arms=Arms(
            directions=(pi / 4, -pi / 4, -3 * pi / 4, 3 * pi / 4), length=_SPAN, mass=_TIP,
            cage_radius=0.09, torque_ratio=0.016,
            joint=HingeSettings(
                type="hinge", position=(0.06, 0.0, 0.0), axis=(0.0, 0.0, 1.0),
                travel=(-pi / 3, pi / 3), stiffness=1.0, damping=0.01,
            ),
        ),
        propulsion=thrust_for(1.174),
    ),
    "ASU's XPLORER: arms that fold about vertical hinges with torsion springs",
    {
        "body.mass": f"given: {_XPLORER}, 1.174 kg in all, less four arms",
        "body.inertia": f"given: {_XPLORER}, of the whole vehicle, less four arms",
        "hull.radius": "chosen: 60 mm, as of arq",
        "arms.directions": "chosen: an X",
        "arms.length": "chosen: 180 mm; none is printed",
        "arms.mass": "chosen: 60 g, motor and propeller",
        "arms.joint": "chosen: hinges 60 mm out, 1 N m/rad, 0.01 N m s/rad, 60 deg to either side; "
        "that the arms fold about vertical hinges against torsion springs is given",
        "arms.cage_radius": "chosen: 90 mm",
        "arms.torque_ratio": "chosen: 16 mm, as of arq",
        "propulsion.max_thrust": TWICE,
        **CHOSEN,
    },
)  # fmt: skip

# -- CogniFly --------------------------------------------------------------------------------------

_COGNIFLY = "the paper of CogniFly (arXiv:2103.04423)"
_DROPS = "recorded drops (thecognifly/CrashLandingExperiments)"
_SIDE, _TALL = 0.195, 0.072  # [m]


def _posts(stiffness: float, restitution: float) -> tuple[CapsuleHull, ...]:
    """Four upright rods at the corners of a square frame, which share a stiffness [N/m]."""
    surface = HullSurface(
        law="constant-restitution", stiffness=stiffness / 4.0, exponent=1.0,
        restitution=restitution, in_series=False,
    )  # fmt: skip
    return tuple(
        CapsuleHull(
            type="capsule", start=(x, y, -0.5 * _TALL), end=(x, y, 0.5 * _TALL), radius=0.0015,
            surface=surface,
        )
        for x, y in corners(0.5 * _SIDE, 0.5 * _SIDE)
    )  # fmt: skip


def _cognifly(name: str, mass: float, stiffness: float, restitution: float) -> Vehicle:
    frame, core = 0.073, 0.05
    flat = frame * _SIDE**2 / 12.0 + (mass - frame) * (core**2 + 0.03**2) / 12.0
    about_z = frame * _SIDE**2 / 6.0 + (mass - frame) * core**2 / 6.0
    return Vehicle(
        name=name,
        body=Body(mass=mass, inertia=(flat, flat, about_z)),
        hulls=_posts(stiffness, restitution),
        arms=rotors_at(corners(0.0686, 0.0686), 0.042, 0.01, cages=False),
        propulsion=thrust_for(mass),
    )


_COGNIFLY_SOURCES = {
    "body.mass": f"given: {_COGNIFLY}",
    "body.inertia": "derived: a square frame of 73 g (given) and a core of 50 x 50 x 30 mm "
    "(chosen); none is printed",
    "arms.directions": "chosen: an X",
    "arms.length": "derived: arms of 97 mm (given) from the middle",
    "arms.cage_radius": "chosen: 42 mm, of propellers of 3 inch (given)",
    "arms.cages": "derived: the frame touches",
    "arms.torque_ratio": "chosen: 10 mm",
    "propulsion.max_thrust": TWICE,
    **RIGID_ARMS,
    **CHOSEN,
}

COGNIFLY = Entry(
    _cognifly("cognifly", 0.241, 19e3, 0.19),
    "CogniFly: a flexible frame of printed joints and carbon rods",
    {
        "hulls": f"given: {_COGNIFLY}, a frame of rods of 195 mm and 72 mm, here its four upright "
        f"rods; fitted: 19 kN/m in all and a restitution of 0.19, to 101 {_DROPS} from 50 cm: "
        "the frame yields as a whole, and static 7.04 kN/m (given) gives two thirds of the peaks",
        **_COGNIFLY_SOURCES,
    },
)
COGNIFLY_RIGID = Entry(
    _cognifly("cognifly-rigid", 0.239, 1e5, 0.23),
    "The rigid twin of CogniFly",
    {
        "hulls": f"fitted: 100 kN/m in all and a restitution of 0.23, to 88 {_DROPS} from 30 cm, "
        "160 g at 2.43 m/s; a stiffness from its printed block would be some 500 times as large, "
        "its peak 22 times (docs/recordings.md)",
        **_COGNIFLY_SOURCES,
    },
)

FOLDING = (MORPHY, XPLORER, COGNIFLY, COGNIFLY_RIGID)
