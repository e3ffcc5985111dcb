"""Bounds on the rates at which contacts act on a vehicle, which limit the step.

Friction comes first, as the stiffest part of most impacts.  Below the slip speed of a surface it is
a damper g (1 − n nᵀ) at the point p of contact.  In the coordinates q of the vehicle that is
K = Σ g Jᵀ (1 − n nᵀ) J, and a step must be short against the largest eigenvalue λ of M⁻¹ K.  It is
bounded here by parts, without solving for it: for a sum of positive semidefinite matrices, and for
the diagonal blocks of one, the largest eigenvalue of the whole is at most the sum of theirs
(R. Horn and C. Johnson, Matrix Analysis, 2013, sections 4.3 and 7.7).

Slip in the plane of the arms moves the arms, moves the vehicle in that plane, and turns it about z;
slip across the plane moves it along z and turns it about x and y.  The coordinates thus form two
blocks, coupled only by the part n_z of a normal that leans out of the plane.

The normal force is a spring of stiffness K and a damper C at p along n.  The square of its angular
frequency, and its damping rate, are at most the sums over contacts of K and C times two terms: the
mobility of the rigid vehicle at that point, 1/m + (p × n)² / J, and the largest mobility of an arm,
(e·n)² / m_a.  Of p × n only the length of p is used, for speed.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from springback.kernels.compiler import kernel
from springback.kernels.trees import field_of, maximum
from springback.kernels.vectors import Mat3, Vec, larger

#: A step is at most this many times the time in which friction stops a cage (chosen: stable up to
#: 2.785, and at 2.25 the energy ledger of hard impacts is twice as far off).
FRICTION_SHARE = 2.0
#: A step is at most this share of the time scale of contacts and end stops, 1/(ω + 2 ζ ω) ...
CONTACT_SHARE = 0.35
#: ... and of the time scale of a slip, whose friction may reverse (both chosen:
#: studies/families.py).
SLIP_SHARE = 0.25
PER_FRICTION_SHARE, PER_CONTACT_SHARE = 1.0 / FRICTION_SHARE, 1.0 / CONTACT_SHARE
PER_SLIP_SHARE = 1.0 / SLIP_SHARE


class FrictionDamping(NamedTuple):
    """Friction of one contact as a damper, or the sum over contacts; body axes."""

    damper: float  # g [N s/m]
    on_arm: float  # g (1 − (e·n)²), along the arm [N s/m]
    about_z: float  # g ((p·n)² + n_z² p²) [N m s]
    about_x: float  # g (1 − n_z²) p_y² [N m s]
    about_y: float  # g (1 − n_z²) p_x² [N m s]
    about_both: float  # g (1 − n_z²) p_x p_y [N m s]
    lean: float  # g n_z² [N s/m]
    lean_about_z: float  # g n_z² p² [N m s]
    alone: float  # the same damper, by itself, wherever it acts [N s/m]


@kernel
def friction_damping(damper: float, normal: Vec, point: Vec, arm_direction: Vec) -> FrictionDamping:
    """Friction of one contact.

    Args:
        damper: g [N s/m].
        normal: Unit normal n.
        point: p, of contact; out of the plane of the arms the bound is twice as far [m].
        arm_direction: e.
    """
    # (a + b)ᵀ(a + b) ≤ 2 aᵀa + 2 bᵀb, for the slip by p in the plane and by p_z across it.
    z = point.z
    g, flat = damper if z == 0.0 else 2.0 * damper, Vec(point.x, point.y, 0.0)
    along, out, tilt = arm_direction @ normal, normal.z * normal.z, g * (z * z)
    upright, pn, square = g * (1.0 - out), flat @ normal, flat @ flat
    return FrictionDamping(
        g, g * (1.0 - along * along), g * (pn * pn + out * square),
        upright * point.y * point.y + tilt, upright * point.x * point.x + tilt,
        upright * point.x * point.y, g * out, g * out * square, damper,
    )  # fmt: skip


class ContactStiffness(NamedTuple):
    """Normal force of one contact as a spring and a damper, or the sum over contacts."""

    stiffness: float  # K [N/m]
    damper: float  # C [N s/m]
    arm_stiffness: float  # K (e·n)², along the arm [N/m]
    arm_damper: float  # C (e·n)², along the arm [N s/m]


@kernel
def contact_stiffness(
    stiffness: float, damper: float, normal: Vec, arm_direction: Vec
) -> ContactStiffness:
    """Normal force of one contact.

    Args:
        stiffness: K [N/m].
        damper: C [N s/m].
        normal: Unit normal n.
        arm_direction: e.
    """
    along = arm_direction @ normal
    sliding = along * along
    return ContactStiffness(stiffness, damper, stiffness * sliding, damper * sliding)


class InverseInertia(NamedTuple):
    """Reciprocals of the inertia of a vehicle."""

    about_z: float  # 1/J_zz [1/(kg m²)]
    across: float  # 1/(J_xx J_yy − J_xy²) [1/(kg m²)²]
    largest: float  # at least 1/J_xx, 1/J_yy and 1/J_zz [1/(kg m²)]


@kernel
def inverse_inertia(inertia: Mat3) -> InverseInertia:
    """Reciprocals of J about the main body, body axes [kg m²], which is symmetric; one division."""
    j = inertia
    determinant = j.x.x * j.y.y - j.x.y * j.x.y
    both = 1.0 / (j.z.z * determinant)
    about_z, across = determinant * both, j.z.z * both
    upright = across * (j.x.x if j.x.x > j.y.y else j.y.y)
    return InverseInertia(about_z, across, upright if upright > about_z else about_z)


class Stiffness(NamedTuple):
    """A spring and a damper per mass: ω² and 2 ζ ω."""

    spring: float  # [1/s²]
    damper: float  # [1/s]


@kernel
def contact_rate_bound(
    press: ContactStiffness,
    slides: tuple[Stiffness, ...],
    inverse_mass: float,
    inverse: InverseInertia,
    reach: float,
) -> float:
    """Upper bound on the rate of contacts and end stops [1/s]: ω + 2 ζ ω.

    Args:
        press: Sum over all contacts.
        slides: For every arm, spring and damper along its slide.
        inverse_mass: 1/m [1/kg].
        inverse: Reciprocals of the inertia about the main body.
        reach: Upper bound on the distance of a contact from the main body [m].
    """
    as_one_body = inverse_mass + reach * reach * inverse.largest
    spring = press.stiffness * as_one_body + maximum(field_of(slides, "spring"))
    damper = press.damper * as_one_body + maximum(field_of(slides, "damper"))
    return math.sqrt(spring) + damper


class ArmFrictionRate(NamedTuple):
    """Rate at which friction brings an arm to rest along its slide [1/s]."""

    whole: float
    lean: float  # the part from normals that lean out of the plane
    any_way: float  # of an arm that moves in any direction, which is in neither of them


@kernel
def _tilt_rate_bound(grip: FrictionDamping, j: Mat3, per: float) -> float:
    """Larger eigenvalue of J⁻¹ K for rotation about x and y [1/s]."""
    x, y, both = grip.about_x, grip.about_y, grip.about_both
    half = 0.5 * per * (j.y.y * x + j.x.x * y + 2.0 * j.x.y * both)
    left = half * half - per * (x * y - both * both)
    return half + math.sqrt(left if left > 0.0 else 0.0)


@kernel
def friction_rate_bound(
    grip: FrictionDamping,
    whole: tuple[float, ...],
    lean: tuple[float, ...],
    inverse_mass: float,
    inertia: Mat3,
    inverse: InverseInertia,
) -> float:
    """Upper bound on λ [1/s], exact to a few per cent for an upright vehicle at a wall.

    Args:
        grip: Sum over all contacts.
        whole: For every arm, see `ArmFrictionRate`.
        lean: Likewise.
        inverse_mass: 1/m [1/kg].
        inertia: J about the main body, body axes [kg m²].
        inverse: Reciprocals of that inertia.
    """
    per_mass, per_turn = inverse_mass, inverse.about_z
    in_plane = grip.damper * per_mass + grip.about_z * per_turn + maximum(whole)
    lean_part = grip.lean * per_mass + grip.lean_about_z * per_turn + maximum(lean)
    across = (grip.damper - grip.lean) * per_mass + _tilt_rate_bound(grip, inertia, inverse.across)
    half = 0.5 * (in_plane - across)
    return 0.5 * (in_plane + across) + math.sqrt(half * half + lean_part * across)


@kernel
def stiffness_rate(friction_rate: float, contact_rate: float, slip_rate: float) -> float:
    """1/h of the longest step h that friction, contacts and slips allow, but at least 1 [1/s].

    Args:
        friction_rate: By `friction_rate_bound` [1/s].
        contact_rate: By `contact_rate_bound` [1/s].
        slip_rate: Of a slip, over its regularised speed [1/s].
    """
    stiff = larger(contact_rate * PER_CONTACT_SHARE, slip_rate * PER_SLIP_SHARE)
    return larger(larger(stiff, friction_rate * PER_FRICTION_SHARE), 1.0)
