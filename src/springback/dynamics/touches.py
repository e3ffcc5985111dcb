"""What the contacts of one part of a vehicle, a cage or the hull, come to.

Contact of a part with all obstacles is summed up here; what it does to arms and main body is told
in `springback.dynamics.motion`.
"""

from __future__ import annotations

from typing import NamedTuple

from springback.contact.cage import LANDED, CageContact, ContactLoad, slip_velocity
from springback.contact.friction_rate import ContactStiffness
from springback.contact.obstacles import Obstacle
from springback.dynamics.crossing import Crossing, crossing
from springback.kernels.compiler import kernel
from springback.kernels.trees import maximum, tree_map, tree_sum
from springback.kernels.vectors import Vec

#: A cage at a surface of the impulse law rests there while it is slower than this along the normal
#: [m/s]: it then touches, and does not rebound (chosen: a rebound at this speed is 5 µm high).
RESTING = 1e-2


class Contact(NamedTuple):
    """What contact does to the vehicle; vectors in body axes."""

    force: Vec  # [N]
    moment: Vec  # about the main body [N m]
    contact_loss: float  # [W]
    friction_loss: float  # [W]
    on_ground: float  # number of touched grounds
    press: ContactStiffness  # of the normal forces


class Rub(NamedTuple):
    """Where and how fast a part of the vehicle slips along an obstacle."""

    inward: Vec  # unit normal into the obstacle, body
    point: Vec  # from the main body, body [m]
    per_speed: float  # 1/√(v² + v_s²); 0 where nothing rubs [s/m]


@kernel
def contact_of(touch: ContactLoad) -> Contact:
    """What the touches of one part do to the vehicle."""
    return Contact(
        touch.force, touch.moment, touch.contact_loss, touch.friction_loss, touch.on_ground,
        touch.press,
    )  # fmt: skip


@kernel
def crossing_of(met: CageContact) -> Crossing:
    """When a gap closes or opens."""
    return crossing(met.gap, met.rate)


@kernel
def touching(met: CageContact) -> float:
    """1 while pressed in, from the instant of landing on to that of leaving.

    At a surface of the impulse law: while it closes in, and while it rests.
    """
    leaving = met.impulsive * RESTING  # faster than this it has left
    closing = (met.gap <= LANDED) & (met.rate < leaving)
    pressed = (met.gap < -LANDED) & (met.impulsive == 0.0)
    return 1.0 if closing | pressed else 0.0


@kernel
def strikes(met: CageContact) -> float:
    """1 where it closes in on a surface of the impulse law."""
    closing = (met.gap <= LANDED) & (met.rate < 0.0)
    return met.impulsive if closing else 0.0


@kernel
def _normal_of(met: CageContact, nearest: float, touches: float) -> Vec:
    return met.inward * (touches if met.gap == nearest else 0.0)


@kernel
def touched_normal(met: tuple[CageContact, ...], nearest: float, engaged: tuple[float, ...]) -> Vec:
    """The normal into the nearest obstacle, if the part touches anything; else zero.

    Args:
        met: The part against each obstacle.
        nearest: The least of their gaps [m].
        engaged: 1 where it touches, obstacle by obstacle.
    """
    return tree_sum(tree_map(_normal_of, (met,), (nearest, maximum(engaged))))


@kernel
def rub_of(met: CageContact) -> Rub:
    """How a part slips along an obstacle."""
    return Rub(met.inward, met.rubbing_at, met.per_speed)


@kernel
def slip_rate(obstacle: Obstacle, rub: Rub, end: Vec, angular: Vec, vertical: Vec) -> float:
    """Square of how fast one slip changes: |v̇| / √(v² + v_s²), of main body and part [1/s²]."""
    change = end + (angular ^ rub.point)
    along = slip_velocity(obstacle.surface, change, rub.inward, vertical)
    return (along @ along) * (rub.per_speed * rub.per_speed)
