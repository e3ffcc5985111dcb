"""Small scenes for tests: one arm, or the vehicles of the library, in front of a face."""

from __future__ import annotations

from typing import Any

from springback.contact.cage import ArmTip, Ring
from springback.contact.obstacles import Forces, Obstacle, Plane, World
from springback.contact.surfaces import AnyExponent, Surface, ThreeHalves
from springback.dynamics.air import Still
from springback.dynamics.motion import Free, Slider
from springback.kernels.vectors import Mat3, Vec
from springback.simulation.flight import still_state
from springback.simulation.measuring.record import Model, Timing
from springback.vehicle.state import Arm, State, build_airframe

LENGTH, CAGE = 0.19, 0.11
#: Outcome of every scene with a wall: the face that a nose pointing along +X meets at x = 0.
FACE = Plane(Vec(-1.0, 0.0, 0.0), 0.0)


def surface(
    *,
    stiffness: float = 1e5,
    dissipation: float = 0.0,
    viscosity: float = 0.0,
    exponent: float = 1.5,
    friction: float = 0.0,
    vertical_only: bool = False,
    slip_speed: float = 0.1,
    restitution: float = -1.0,
) -> Surface:
    """A surface by its numbers; `dissipation` is d = 1.5 c_a."""
    law = ThreeHalves(exponent) if exponent == 1.5 else AnyExponent(exponent)
    axes = 1.0 if vertical_only else 0.0
    return Surface(stiffness, dissipation, viscosity, law, friction, axes, slip_speed, restitution)


def one_arm(
    shape: Any,
    material: Surface,
    *,
    mass: float = 1.5,
    guide: Any = None,
    contact_point: Any = None,
    step: float = 1e-4,
    until: float = 0.2,
    compliant: bool = False,
) -> Model:
    """A vehicle with a single arm that points along body x, far from gravity."""
    free_arm = Arm(
        cosine=1.0, sine=0.0, mass=0.05, inverse_mass=20.0 if compliant else 0.0, stiffness=5e3,
        damping=90.0, length=LENGTH, shortest=0.15, stop_stiffness=2e5, stop_dissipation=0.5,
        compliance=1.0 if compliant else 0.0, cage_radius=CAGE, torque_ratio=0.0,
    )  # fmt: skip
    inertia = Mat3(Vec(0.006, 0.0, 0.0), Vec(0.0, 0.008, 0.0), Vec(0.0, 0.0, 0.012))
    timing = Timing(
        until=until, free_step=1e-3, impact_step=step, settle_step=step, arm_tolerance=1e-5,
        rate_tolerance=1e-3, dwell=0.02, hybrid=1.0,
    )  # fmt: skip
    return Model(
        airframe=build_airframe(mass, inertia, (free_arm,)),
        world=World((Obstacle(shape, material, 0.0),), Forces(0.0), 0.0),
        contact_point=ArmTip(0.0) if contact_point is None else contact_point,
        guide=Slider(Vec(1.0, 0.0, 0.0)) if guide is None else guide,
        air=Still(0.0),
        thrust=(0.0,),
        timing=timing,
    )


def approaching(speed: float, gap: float) -> State:
    """Level, nose along +X, its foremost point `gap` in front of x = 0 [m], at some speed [m/s]."""
    return still_state((LENGTH,))._replace(
        position=Vec(-(LENGTH + CAGE + gap), 0.0, 0.0), velocity=Vec(speed, 0.0, 0.0)
    )


__all__ = ["CAGE", "FACE", "LENGTH", "Free", "Ring", "approaching", "one_arm", "surface"]
