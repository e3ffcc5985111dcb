"""Contacts that remember the deepest depth: what comes out returns a fixed share of the energy.

Going in for the first time, the elastic force is E(δ), a power law or a curve, and W(δ) = ∫ E dδ is
put in.  Below the deepest depth it is E(δ) φ(w) with w = W(δ)/W(deepest), where φ(w) = wˢ or a
curve, 0 ≤ φ ≤ 1 = φ(1): never adhesive, continuous, and steeper coming out.  It returns W ∫ φ dw,
so one mass bounces from a rigid wall with the same restitution at any speed, e² = ∫₀¹ φ dw =
1/(1 + s).  Of the same kind are models of foams in crash simulation
(`springback.vehicle.force_curves`).

What is not returned is lost where a contact comes deeper than before: the heat of a step is the
change of (1 − e²) W(deepest), not an integral over its stages, as its power jumps there.

Each part of a vehicle remembers the contacts of the last step, by place and normal in body axes;
one that is let go is forgotten, unless its surface does not recover.  Of a contact that jumps from
one place to another see `springback.contact.laws.jumps`.
"""

from __future__ import annotations

from typing import NamedTuple

from springback.contact.cage import LANDED
from springback.contact.surfaces import (
    Hysteresis,
    NormalForce,
    Surface,
    elastic_energy,
    power,
    steepest,
)
from springback.kernels.compiler import kernel
from springback.kernels.routines import number_at
from springback.kernels.trees import field_of, fold, maximum, replace, tree_map
from springback.kernels.vectors import Vec, larger, positive_part
from springback.vehicle.force_curves import (
    COUNT_OUT,
    RETURNED,
    STEEPEST,
    Pressed,
    Returned,
    next_point,
    pressed_at,
    returned_at,
)
from springback.vehicle.state import PressedPoint, PressedPoints

#: Contacts of two steps are the same if they are this close [m], and the cosine between their
#: normals is larger than this (both chosen).
NEAR, ALIGNED = 0.01, 0.7
#: Avoids division by zero [J].
TINY = 1e-200


class Pressing(NamedTuple):
    """A contact and its motion along its normal; vectors in body axes."""

    surface: Surface
    place: Vec  # where it presses, from the main body [m]
    inward: Vec  # unit normal into the obstacle
    depth: float  # δ; 0 without contact [m]
    rate: float  # δ̇ [m/s]
    ahead: float  # stiffness and damping hold for depths up to this much larger [m]


@kernel
def is_same_contact(before: PressedPoint, place: Vec, inward: Vec) -> bool:
    """True if a contact of the last step is the one at a place, with this normal."""
    away = before.place - place
    is_near = away @ away < NEAR * NEAR
    return (before.depth > 0.0) & is_near & (before.inward @ inward > ALIGNED)


class _Nearest(NamedTuple):
    """Contact of the last step nearest to a place."""

    square: float  # of its distance [m²]
    depth: float  # its deepest depth [m]


@kernel
def _nearer(best: _Nearest, point: PressedPoint, place: Vec, inward: Vec) -> _Nearest:
    away = point.place - place
    square = away @ away
    is_nearer = (square < best.square) & is_same_contact(point, place, inward)
    return _Nearest(square if is_nearer else best.square, point.depth if is_nearer else best.depth)


@kernel
def deepest_depth(
    memory: PressedPoints, law: Hysteresis, place: Vec, inward: Vec, depth: float
) -> float:
    """Deepest depth of a contact so far [m]; at least the present one.

    Args:
        memory: Of the part.
        law: Of the surface.
        place: Where it presses, from the main body, body axes [m].
        inward: Unit normal into the obstacle, body axes.
        depth: The present depth δ > 0 [m].
    """
    return larger(_deepest_before(memory, law, place, inward), depth)


@kernel
def _deepest_before(memory: PressedPoints, law: Hysteresis, place: Vec, inward: Vec) -> float:
    """As `deepest_depth`, up to the last step; 0 of a contact that is new."""
    found = fold(_nearer, _Nearest(NEAR * NEAR, 0.0), memory.points, (place, inward))
    return larger(found.depth, memory.crushed if law.stays > 0.0 else 0.0)


@kernel
def _first_time(surface: Surface, law: Hysteresis, depth: float) -> Pressed:
    """Elastic force going in."""
    if law.curve > 0.0:
        return pressed_at(law.curve, depth)
    k, n = surface.stiffness, surface.exponent
    return Pressed(k * power(n, depth), k * steepest(n, depth, 0.0), elastic_energy(surface, depth))


@kernel
def _share_at(law: Hysteresis, w: float) -> Returned:
    """φ, and its integral, coming out."""
    if law.curve > 0.0 and number_at(law.curve, COUNT_OUT) > 0.0:
        return returned_at(law.curve, w)
    if law.shape == 0.0:
        return Returned(1.0, w)
    share = w**law.shape
    return Returned(share, share * w / (1.0 + law.shape))


@kernel
def _returned_in_all(law: Hysteresis) -> float:
    """∫₀¹ φ dw."""
    if law.curve > 0.0 and number_at(law.curve, COUNT_OUT) > 0.0:
        return number_at(law.curve, RETURNED)
    return 1.0 / (1.0 + law.shape)


@kernel
def _steepest_share(law: Hysteresis) -> float:
    """Largest |dφ/dw| w, or of a curve |dφ/dw|."""
    if law.curve > 0.0 and number_at(law.curve, COUNT_OUT) > 0.0:
        return number_at(law.curve, STEEPEST)
    return law.shape


@kernel
def _slope_coming_out(law: Hysteresis, there: Pressed) -> float:
    """Upper bound on the slope coming out from a depth [N/m]: E′ + |dφ/dw| E²/W."""
    return there.slope + _steepest_share(law) * there.force * there.force / (there.energy + TINY)


class HystereticLoad(NamedTuple):
    """Normal force of a contact with its memory, and what it will remember."""

    force: NormalForce
    point: PressedPoint


@kernel
def _remembering(law: Hysteresis, memory: PressedPoints, at: Pressing) -> HystereticLoad:
    """Load of a contact that is pressed in."""
    d, b, rate = at.surface.dissipation, at.surface.viscosity, at.rate
    before = _deepest_before(memory, law, at.place, at.inward)
    deepest = larger(before, at.depth)
    now = _first_time(at.surface, law, at.depth)
    most = _first_time(at.surface, law, deepest)
    # A contact begins at no depth; one of which nothing is known is taken over as it is.
    known = most.energy if before == 0.0 else _first_time(at.surface, law, before).energy
    renewed = most.energy - known
    soon = _first_time(at.surface, law, deepest + at.ahead)
    # A step ends where it was deepest, to within rounding: then it goes in for the first time.
    is_first = at.depth >= deepest - (LANDED if rate > 0.0 else 0.0)
    share = 1.0 if is_first else _share_at(law, now.energy / (most.energy + TINY)).share
    elastic = now.force * share
    force = positive_part(elastic + (d * elastic + b) * rate)
    steep = larger(_slope_coming_out(law, now), _slope_coming_out(law, most))
    steep = larger(steep, soon.slope)
    pressed = NormalForce(
        force,
        (force - elastic) * rate,
        steep * (1.0 + d * positive_part(rate)),
        d * soon.force + b,
    )
    crushed = deepest if law.stays > 0.0 else 0.0
    lost = renewed * (1.0 - _returned_in_all(law))
    return HystereticLoad(pressed, PressedPoint(at.place, at.inward, deepest, crushed, lost))


@kernel
def next_corner(law: Hysteresis, depth: float, rate: float) -> float:
    """Depth at which the next corner of a curve is [m]; 0 if there is none ahead.

    Args:
        law: Of the surface.
        depth: The present depth [m].
        rate: Of the depth [m/s].
    """
    if law.curve > 0.0:
        return next_point(law.curve, depth, rate, LANDED)
    return 0.0


@kernel
def no_point() -> PressedPoint:
    """No contact to remember."""
    none = Vec(0.0, 0.0, 0.0)
    return PressedPoint(none, none, 0.0, 0.0, 0.0)


@kernel
def _by_law(
    so_far: HystereticLoad, law: Hysteresis, memory: PressedPoints, at: Pressing
) -> HystereticLoad:
    if (at.depth > 0.0) & ((law.shape > 0.0) | (law.curve > 0.0)):
        return _remembering(law, memory, at)
    return so_far


@kernel
def hysteretic_load(memory: PressedPoints, elastic: NormalForce, at: Pressing) -> HystereticLoad:
    """Normal force of a contact, by its memory where the surface has one.

    Args:
        memory: Of the part.
        elastic: Its force without one.
        at: The contact.
    """
    start = HystereticLoad(elastic, no_point())
    return fold(_by_law, start, at.surface.hysteresis, (memory, at))


@kernel
def force_of(so_far: NormalForce, load: HystereticLoad) -> NormalForce:
    """Normal force of a contact whose part has a memory; for `fold`."""
    return load.force


@kernel
def _share_of_point(point: PressedPoint, share: float) -> PressedPoint:
    return replace(point, lost=share * point.lost)


@kernel
def share_of_loss(points: tuple[PressedPoint, ...], share: float) -> tuple[PressedPoint, ...]:
    """Contacts of a part that has a share of its stiffness left; for `fold`."""
    return tree_map(_share_of_point, (points,), (share,))


@kernel
def next_memory(before: PressedPoints, points: tuple[PressedPoint, ...]) -> PressedPoints:
    """What a part remembers after an instant.

    Args:
        before: What it remembered.
        points: Of the faces that it meets now.
    """
    return PressedPoints(larger(before.crushed, maximum(field_of(points, "crushed"))), points)


@kernel
def _stored_by_law(
    elastic: float, law: Hysteresis, memory: PressedPoints, surface: Surface, at: Pressing
) -> float:
    if (at.depth > 0.0) & ((law.shape > 0.0) | (law.curve > 0.0)):
        deepest = deepest_depth(memory, law, at.place, at.inward, at.depth)
        now, most = _first_time(surface, law, at.depth), _first_time(surface, law, deepest)
        if at.depth >= deepest:
            return most.energy * _returned_in_all(law)
        return most.energy * _share_at(law, now.energy / (most.energy + TINY)).energy
    return elastic


@kernel
def hysteretic_energy(elastic: float, memory: PressedPoints, at: Pressing) -> float:
    """Energy that a contact will give back [J]; for `fold`.

    Args:
        elastic: That of a contact without memory.
        memory: Of the part.
        at: The contact.
    """
    return fold(_stored_by_law, elastic, at.surface.hysteresis, (memory, at.surface, at))
