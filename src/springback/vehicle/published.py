"""Collision-tolerant vehicles of other papers and simulators, each number with its source.

They are rigid, and touch by hulls.  What their authors do not print is chosen, and says so; nothing
here was fitted.  Thrusts are rarely published: those are chosen, twice the weight.
"""

from __future__ import annotations

from math import atan2, cos, hypot, radians, sin
from typing import Any, NamedTuple

from springback.vehicle.endurance import GRAVITY
from springback.vehicle.force_laws import HullSurface
from springback.vehicle.hulls import CapsuleHull, RingHull, SphereHull
from springback.vehicle.mass.bearings import Gimbal
from springback.vehicle.parameters import Arms, Body, Hull, Vehicle
from springback.vehicle.propulsion import Propulsion

Place = tuple[float, float]


class Entry(NamedTuple):
    """A vehicle of the library, and the sources of its numbers by field.

    ``given`` is printed there, ``derived`` follows from printed numbers, ``chosen`` is our choice
    where the source gives none; ``fitted`` numbers name what they were fitted to.
    """

    vehicle: Vehicle
    summary: str
    sources: dict[str, str]


#: Of all that have no other source.
CHOSEN = {
    "propulsion.time_constant": "chosen: 25 ms, as of arq",
    "propulsion.min_thrust": "chosen: rotors do not turn backwards",
    "propulsion.stop": "chosen: none; add [vehicle.propulsion.stop]",
    "propulsion.surface_effect": "chosen: none; add [vehicle.propulsion.surface_effect]",
    "limits": "chosen: none",
}
TWICE = "chosen: twice the weight in all"
#: Of arms that do not slide.
RIGID_ARMS = {"arms.mass": "derived: rigid arms are part of the body"}


def rotors_at(places: tuple[Place, ...], radius: float, torque_ratio: float, cages: bool) -> Arms:
    """Rigid arms to rotors at some places (x, y) of the body [m]."""
    return Arms(
        directions=tuple(atan2(y, x) for x, y in places),
        length=tuple(hypot(x, y) for x, y in places),
        mass=0.0,
        cage_radius=radius,
        cages=cages,
        compliant=False,
        torque_ratio=torque_ratio,
    )


def thrust_for(mass: float, over_weight: float = 2.0, **more: Any) -> Propulsion:
    """Four rotors that lift some multiple of the weight."""
    return Propulsion(max_thrust=over_weight * mass * GRAVITY / 4.0, **more)


def corners(x: float, y: float) -> tuple[Place, ...]:
    """Front left, front right, rear right, rear left."""
    return ((x, y), (x, -y), (-x, -y), (-x, y))


# -- bumpers of McGill's robots --------------------------------------------------------------------


def _tilted_rings(
    places: tuple[Place, ...], radius: float, height: float, tilt: float, surface: HullSurface
) -> tuple[RingHull, ...]:
    """A ring on each arm above its end, its upper side tilted towards the middle [m], [rad]."""
    rings = []
    for j, (x, y) in enumerate(places, start=1):
        out = hypot(x, y)
        axis = (-sin(tilt) * x / out, -sin(tilt) * y / out, cos(tilt))
        rings.append(
            RingHull(
                type="ring", on=j, position=(0.0, 0.0, height), axis=axis, radius=radius,
                surface=surface,
            )
        )  # fmt: skip
    return tuple(rings)


def _bumper(stiffness: float, exponent: float, friction: float) -> HullSurface:
    return HullSurface(
        law="constant-restitution", stiffness=stiffness, exponent=exponent, restitution=0.9,
        friction=friction, in_series=False,
    )  # fmt: skip


_SIMULATOR = "McGill's simulator of the robot"
_BUMPER_SOURCES = {
    "hulls": f"given: {_SIMULATOR}: radius, height above the centre of mass, tilt (its sense is "
    "chosen: the upper side inward), stiffness, exponent, friction; restitution 0.9 at any speed: "
    "there the damping follows from the speed at touch",
    "arms.cages": "derived: the rings are tilted, so they are hulls",
    "arms.torque_ratio": f"given: {_SIMULATOR}, torque over thrust",
    "hull.radius": "chosen: 60 mm, about the electronics",
    "propulsion.max_thrust": TWICE,
    **RIGID_ARMS,
    **CHOSEN,
}
_SPIRI_ROTORS = ((0.132, 0.1265), (0.132, -0.1265), (-0.121, -0.1265), (-0.121, 0.1265))
_DIAGONAL = 0.192 / 2.0**0.5

SPIRI = Entry(
    Vehicle(
        name="spiri",
        body=Body(mass=0.933, inertia=(0.008737, 0.008988, 0.017143)),
        hull=Hull(radius=0.06),
        hulls=_tilted_rings(_SPIRI_ROTORS, 0.11, 0.024, radians(11.0), _bumper(40.0, 0.54, 0.15)),
        arms=rotors_at(_SPIRI_ROTORS, 0.11, 0.1, cages=False),
        propulsion=thrust_for(0.933),
    ),
    "McGill's Spiri: rigid, tilted plastic bumpers above the centre of mass",
    {
        "body.mass": f"given: {_SIMULATOR}",
        "body.inertia": f"given: {_SIMULATOR}",
        "arms.directions": f"given: {_SIMULATOR}, places of the rotors",
        "arms.length": f"given: {_SIMULATOR}, places of the rotors",
        "arms.cage_radius": f"given: {_SIMULATOR}, radius of a bumper",
        **_BUMPER_SOURCES,
    },
)

NAVI = Entry(
    Vehicle(
        name="navi",
        body=Body(mass=1.095, inertia=(0.01122, 0.01123, 0.02108)),
        hull=Hull(radius=0.06),
        hulls=_tilted_rings(
            corners(_DIAGONAL, _DIAGONAL), 0.125, 0.0245, radians(5.0), _bumper(372.0, 0.66, 0.3)
        ),
        arms=rotors_at(corners(_DIAGONAL, _DIAGONAL), 0.125, 0.1, cages=False),
        propulsion=thrust_for(1.095),
    ),
    "McGill's Navi: rigid, tilted plastic bumpers above the centre of mass",
    {
        "body.mass": f"given: {_SIMULATOR}",
        "body.inertia": f"given: {_SIMULATOR}",
        "arms.directions": "chosen: an X, as drawn",
        "arms.length": f"given: {_SIMULATOR}, 0.192 m from the middle to the centre of a bumper",
        "arms.cage_radius": f"given: {_SIMULATOR}, radius of a bumper",
        **_BUMPER_SOURCES,
        "hulls": _BUMPER_SOURCES["hulls"]
        + "; two files of the simulator have heights of 21 and 28 "
        "mm, of which this is the mean",
    },
)

# -- in a cage -------------------------------------------------------------------------------------

_SUBT = "the model COSTAR Gagarin of DARPA's SubT simulator (osrf/subt)"

_SPHERE, _SHELL_MASS = 0.2, 0.15  # [m], [kg]
_SHELL_INERTIA = 2.0 / 3.0 * _SHELL_MASS * _SPHERE**2


def _in_a_sphere(name: str, moments: tuple[float, ...], gimbal: Gimbal | None) -> Vehicle:
    """A quadrotor in a sphere, by the moments of inertia of what does not turn by itself."""
    return Vehicle(
        name=name,
        body=Body(mass=2.336, inertia=moments),
        hulls=(SphereHull(type="sphere", radius=_SPHERE, gimbal=gimbal),),
        arms=rotors_at(corners(0.1, 0.1), 0.055, 0.016, cages=False),
        propulsion=thrust_for(2.336),
    )


_GAGARIN = (0.017, 0.018, 0.028)
CAGED_SPHERE = Entry(
    _in_a_sphere("caged-sphere", _GAGARIN, None),
    "A quadrotor in a sphere, of the mass and size of a Flyability Elios 2",
    {
        "body.mass": f"given: {_SUBT}, 2.316 kg and four rotors of 5 g",
        "body.inertia": f"given: {_SUBT}",
        "hulls": "chosen: a sphere of 0.2 m about the centre of mass, without a spring; the "
        "Elios 2 is less than 0.40 m wide (from memory)",
        "arms.directions": f"given: {_SUBT}, rotors at 0.10 m ahead and aside",
        "arms.length": f"given: {_SUBT}, rotors at 0.10 m ahead and aside",
        "arms.cage_radius": "chosen: 55 mm, what fits into the sphere",
        "arms.cages": "derived: the sphere alone touches",
        "arms.torque_ratio": "chosen: 16 mm, as of arq",
        "propulsion.max_thrust": TWICE,
        **RIGID_ARMS,
        **CHOSEN,
    },
)

CAGED_SPHERE_GIMBAL = Entry(
    _in_a_sphere(
        "caged-sphere-gimbal",
        tuple(round(moment - _SHELL_INERTIA, 9) for moment in _GAGARIN),
        Gimbal(shell_mass=_SHELL_MASS, damping=1e-4, friction=1e-3),
    ),
    "caged-sphere with its sphere in a gimbal, as of Briod's GimBall: it rolls along what it hits",
    {
        **CAGED_SPHERE.sources,
        "body.inertia": "derived: that of caged-sphere less the shell's 2/3 m r^2, 4.0e-3 kg m^2, "
        "so that with the shell held both are one vehicle",
        "hulls": CAGED_SPHERE.sources["hulls"]
        + "; chosen: a thin shell of 150 g, 6 % of the mass, in bearings of 0.1 mN m s/rad and "
        "1 mN m of dry friction, which slow it from 10 to 5 rad/s in 12 s (derived); of no such "
        "robot are these numbers known to us",
    },
)

_ROD = 0.22  # [m]
_TENSEGRITY = "the simulator of a tactile tensegrity drone (arXiv:2410.14249)"


def _rods() -> tuple[CapsuleHull, ...]:
    """Six rods in three parallel pairs, half a rod apart: the expanded octahedron."""
    surface = HullSurface(stiffness=1e4, exponent=1.0, viscosity=2e3, in_series=False)
    apart, half, found = 0.25 * _ROD, 0.5 * _ROD, []
    for at in (-apart, apart):
        for start, end in (
            ((0.0, at, -half), (0.0, at, half)),
            ((at, -half, 0.0), (at, half, 0.0)),
            ((-half, 0.0, at), (half, 0.0, at)),
        ):
            found.append(
                CapsuleHull(type="capsule", start=start, end=end, radius=0.004, surface=surface)
            )
    return tuple(found)


TENSEGRITY = Entry(
    Vehicle(
        name="tensegrity",
        body=Body(mass=0.315, inertia=(6.21e-4, 9.62e-4, 9.22e-4)),
        hulls=_rods(),
        arms=rotors_at(corners(0.0525, 0.04), 0.038, 0.009975, cages=False),
        propulsion=thrust_for(0.315),
    ),
    "A drone within an icosahedron of six rods, as one rigid body",
    {
        "body.mass": f"given: {_TENSEGRITY}; 0.361 kg where it was identified",
        "body.inertia": f"given: {_TENSEGRITY}",
        "hulls": f"given: {_TENSEGRITY}: rods of 0.22 m, 10 kN/m and 2 kN s/m, here of "
        "each contact (there shared by the nodes that touch), tubes of 4 mm; derived: their "
        "places, of an expanded octahedron; strings touch nothing",
        "arms.directions": f"given: {_TENSEGRITY}, rotors at 52.5 mm ahead and 40 mm aside",
        "arms.length": f"given: {_TENSEGRITY}, rotors at 52.5 mm ahead and 40 mm aside",
        "arms.cage_radius": "chosen: 38 mm, of propellers of 2.5 inch with 6 mm of air",
        "arms.cages": "derived: the rods alone touch",
        "arms.torque_ratio": f"given: {_TENSEGRITY}, torque over thrust",
        "propulsion.max_thrust": TWICE,
        **RIGID_ARMS,
        **CHOSEN,
    },
)  # fmt: skip

# -- small, and square -----------------------------------------------------------------------------

_GUARDS = 0.004  # [kg]

CRAZYFLIE = Entry(
    Vehicle(
        name="crazyflie",
        body=Body(mass=0.027 + _GUARDS, inertia=(1.4e-5, 1.4e-5, 2.17e-5)),
        hull=Hull(radius=0.02),
        arms=rotors_at(
            corners(0.0397 / 2.0**0.5, 0.0397 / 2.0**0.5), 0.0275, 7.94e-12 / 3.16e-10, cages=True
        ),
        propulsion=thrust_for(0.027, 2.25, disk_radius=0.0235),
    ),
    "Bitcraze's Crazyflie 2 with a guard around each propeller",
    {
        "body.mass": "given: 27 g, gym-pybullet-drones' model; chosen: 4 g of guards",
        "body.inertia": "given: gym-pybullet-drones' model, without guards",
        "hull.radius": "chosen: 20 mm, about the board and the battery",
        "arms.directions": "given: an X",
        "arms.length": "given: 39.7 mm, gym-pybullet-drones' model",
        "arms.cage_radius": "chosen: 27.5 mm, about propellers of 47 mm",
        "arms.torque_ratio": "derived: 7.94e-12 over 3.16e-10, torque over thrust",
        "propulsion.max_thrust": "given: 2.25 times the weight without guards",
        "propulsion.disk_radius": "chosen: propellers of 47 mm",
        "propulsion.disk_height": "chosen: in the plane of the guards",
        **RIGID_ARMS,
        **CHOSEN,
    },
)

_FLAP = HullSurface(
    law="constant-restitution", stiffness=2e3, exponent=1.0, restitution=0.4, in_series=False
)
_HALF = 0.19  # [m]


def _flaps() -> tuple[CapsuleHull, ...]:
    """Four soft edges of a square."""
    places = corners(_HALF, _HALF)
    return tuple(
        CapsuleHull(
            type="capsule", start=(*places[k], 0.0), end=(*places[(k + 1) % 4], 0.0),
            radius=0.012, surface=_FLAP,
        )
        for k in range(4)
    )  # fmt: skip


_AERIAL_GYM = "the model lmf2 of the Aerial Gym simulator"

LMF2 = Entry(
    Vehicle(
        name="lmf2",
        body=Body(mass=1.24, inertia=(0.013, 0.014, 0.013)),
        hull=Hull(radius=0.06),
        hulls=_flaps(),
        arms=rotors_at(corners(0.09, 0.09), 0.085, 0.016, cages=False),
        propulsion=Propulsion(max_thrust=10.0),
    ),
    "A square frame with soft flaps around it, of the kind of RMF-Owl and LMF2",
    {
        "body.mass": f"given: {_AERIAL_GYM}, 1.2 kg and 40 g",
        "body.inertia": f"given: {_AERIAL_GYM}",
        "hull.radius": "chosen: 60 mm, about the electronics",
        "hulls": "chosen: rods of 24 mm around a square of 0.38 m (from memory), 2 kN/m and a "
        "restitution of 0.4; no impact of it was published",
        "arms.directions": "chosen: an X",
        "arms.length": "chosen: rotors within the square",
        "arms.cage_radius": "chosen: 85 mm, what is left in the square",
        "arms.cages": "derived: the flaps alone touch",
        "arms.torque_ratio": "chosen: 16 mm, as of arq",
        "propulsion.max_thrust": f"given: {_AERIAL_GYM}, at most 10 N each",
        **RIGID_ARMS,
        **CHOSEN,
    },
)

PUBLISHED = (SPIRI, NAVI, CAGED_SPHERE, CAGED_SPHERE_GIMBAL, TENSEGRITY, CRAZYFLIE, LMF2)
