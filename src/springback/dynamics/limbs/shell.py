"""A round shell that turns by itself about the main body: a sphere in a gimbal, or a ring.

The shell's centre stays where it is on the body, so that its mass counts there and its attitude
plays no part.  Normal forces pass through the centre of a sphere; friction turns it, and reaches
the body through the bearings only:

    I_s Ω̇ = m_c − M,   M = (b + M_c/√(|Ω − ω|² + ω_s²)) (Ω − ω)

with the moment m_c of the contacts about the centre, and M on the main body.  The idea is that of
A. Briod et al., A Collision-Resilient Flying Robot, J. Field Robotics 31 (2014).

A ring turns about its axis a only, by s = a (a · Ω), and with the main body otherwise:

    Ω = ω + a a·(s − ω),   I_s a·Ω̇ = a·(m_c − M),
    on the main body: m_c − a (a·m_c) + M − ω × I_s s,

while I_s a aᵀ is not part of its inertia.  Such is the bumper of P. Sareh et al., Rotorigami: A
Rotary Origami Protective System for Robotic Rotorcraft, Science Robotics 3 (2018).
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from springback.contact.cage import BodyMotion
from springback.contact.laws.step_bounds import InverseInertia
from springback.dynamics.touches import BodyAcceleration, Contact
from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import fold, replace
from springback.kernels.vectors import Vec, larger
from springback.vehicle.state import PartMemory, Shell

#: Below this relative speed dry friction of the bearings is viscous, ω_s [rad/s] (chosen).
BEARING_SLIP = 0.1


class ShellState(NamedTuple):
    """A shell at one instant."""

    moment: Vec  # of contacts and bearings on the main body, about it, body axes [N m]
    loss: float  # in the bearings [W]
    spin_rate: Vec  # Ω̇, of a ring ṡ, world [rad/s²]
    turning: Vec  # Ω̇, body axes; of a ring, without that of the main body across its axis [rad/s²]
    centre: Vec  # from the main body, body axes [m]
    axis: tuple[Vec, ...]  # of a ring, body axes
    mobility: float  # R²/I_s, of a point on it [1/kg]
    bearing: float  # upper bound on the bearings as a damper [N m s]
    inverse_inertia: float  # 1/I_s [1/(kg m²)]


@generic
def hull_motion(hull: Any, memory: PartMemory, body: BodyMotion) -> BodyMotion:
    """Motion of what a hull belongs to: of the main body, but for a shell that turns by itself.

    Args:
        hull: Of the main body.
        memory: Of the hull.
        body: Motion of the main body.
    """
    return body


@hull_motion.register(Shell)
@kernel
def _motion_of_shell(hull: Shell, memory: PartMemory, body: BodyMotion) -> BodyMotion:
    """As if the main body turned with it about its centre."""
    spin = whole_spin(hull, memory.spin[0] @ body.r, body.omega)
    velocity = body.velocity + ((body.omega - spin) ^ hull.centre)
    return replace(body, velocity=velocity, omega=spin)


@kernel
def whole_spin(hull: Shell, spin: Vec, omega: Vec) -> Vec:
    """Ω of a shell, body axes [rad/s].

    Args:
        hull: The shell.
        spin: Ω of a sphere, s of a ring, body axes [rad/s].
        omega: ω of the main body, body axes [rad/s].
    """
    return fold(_beside_axis, spin, hull.axis, (omega,))


@kernel
def whole_turning(hull: Shell, change: Vec, angular: Vec, omega: Vec, relative: Vec) -> Vec:
    """Ω̇ of a shell, body axes [rad/s²].

    Args:
        hull: The shell.
        change: Ω̇ of a sphere, ṡ of a ring, body axes [rad/s²].
        angular: ω̇ of the main body, body axes [rad/s²].
        omega: ω of the main body, body axes [rad/s].
        relative: Ω − ω, body axes [rad/s].
    """
    along = fold(_beside_axis, change, hull.axis, (angular,))
    return fold(_with_axis, along, hull.axis, (omega, relative))


@kernel
def _beside_axis(turned: Vec, axis: Vec, other: Vec) -> Vec:
    """A vector along an axis as it is, across it another one."""
    return other + ((turned - other) @ axis) * axis


@kernel
def _along(turned: Vec, axis: Vec) -> Vec:
    return (turned @ axis) * axis


@kernel
def _held_back(moment: Vec, axis: Vec, omega: Vec, momentum: Vec) -> Vec:
    """On the main body, which turns the axis of a ring's own angular momentum."""
    return moment - (omega ^ _along(momentum, axis))


@kernel
def _with_axis(rate: Vec, axis: Vec, omega: Vec, spin: Vec) -> Vec:
    """Rate of a vector that turns with an axis."""
    return rate + (omega ^ _along(spin, axis))


@generic
def shells_of(
    hull: Any, memory: PartMemory, contact: Contact, body: BodyMotion
) -> tuple[ShellState, ...]:
    """State of the shell, if the hull is one.

    Args:
        hull: Of the main body.
        memory: Of the hull.
        contact: Effect of its contacts, as if it were fixed to the main body.
        body: Motion of the main body.
    """
    return ()


@shells_of.register(Shell)
@kernel
def _shell_state(
    hull: Shell, memory: PartMemory, contact: Contact, body: BodyMotion
) -> tuple[ShellState]:
    spin = whole_spin(hull, memory.spin[0] @ body.r, body.omega)
    relative = spin - body.omega
    dry = hull.friction / math.sqrt(relative @ relative + BEARING_SLIP * BEARING_SLIP)
    bearing = (hull.damping + dry) * relative
    through_centre = hull.centre ^ contact.force
    about_centre = contact.moment - through_centre
    turned = fold(_along, about_centre, hull.axis, ())
    inverse = 1.0 / hull.inertia
    turning = inverse * (turned - bearing)
    passed = through_centre + (about_centre - turned) + bearing
    return (
        ShellState(
            fold(_held_back, passed, hull.axis, (body.omega, hull.inertia * spin)),
            bearing @ relative,
            body.r @ fold(_with_axis, turning, hull.axis, (body.omega, spin)),
            fold(_with_axis, turning, hull.axis, (body.omega, relative)),
            hull.centre,
            hull.axis,
            hull.radius * hull.radius * inverse,
            hull.damping + hull.friction * (1.0 / BEARING_SLIP),
            inverse,
        ),
    )


@generic
def turns_by_itself(hull: Any) -> float:
    """1 for a hull that acts on the vehicle even where it touches nothing: a shell, else 0."""
    return 0.0


@turns_by_itself.register(Shell)
@kernel
def _shell_turns(hull: Shell) -> float:
    return 1.0


@kernel
def or_turns(so_far: float, hull: Any) -> float:
    """1 if one of several hulls is a shell, for `fold`."""
    return larger(so_far, turns_by_itself(hull))


@kernel
def with_shell(contact: Contact, shell: ShellState) -> Contact:
    """Effect of contact on the main body, of a hull that is a shell."""
    loss = contact.friction_loss + shell.loss
    return replace(contact, moment=shell.moment, friction_loss=loss)


@kernel
def spin_of(shell: ShellState) -> Vec:
    """Ω̇ of a shell, ṡ of a ring, world axes [rad/s²]."""
    return shell.spin_rate


@kernel
def as_shell(body: BodyAcceleration, shell: ShellState) -> BodyAcceleration:
    """Acceleration of the main body as if it turned with the shell about its centre."""
    turning = fold(_also_across, shell.turning, shell.axis, (body.angular,))
    linear = body.linear + ((body.angular - turning) ^ shell.centre)
    return replace(body, linear=linear, angular=turning)


@kernel
def _also_across(turning: Vec, axis: Vec, angular: Vec) -> Vec:
    return turning + angular - _along(angular, axis)


@kernel
def friction_rate_with_shell(
    rate: float, shell: ShellState, damper: float, inverse: InverseInertia
) -> float:
    """Upper bound on the rate at which friction stops a part, with a shell [1/s].

    Args:
        rate: Bound without it [1/s].
        shell: State of the shell.
        damper: Friction of its contacts as a damper [N s/m].
        inverse: Reciprocals of the inertia about the main body.
    """
    return (
        rate + damper * shell.mobility + shell.bearing * (shell.inverse_inertia + inverse.largest)
    )
