"""Springs between the ends of neighbouring arms, as soft frames and rings of tendons have them.

Two ends a distance d apart, whose spring is free at D, pull each other with k (d − D) + b ḋ along
the line between them.  Both forces are internal: they move arms, never the vehicle as a whole.
"""

from __future__ import annotations

from typing import Annotated, Any, NamedTuple

from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import tree_map, tree_sum
from springback.kernels.vectors import Vec, larger, norm
from springback.quantities import Unit
from springback.settings import Settings
from springback.vehicle.state import arm_pose

#: Ends that meet have no direction between them [m].
TOGETHER = 1e-9


class NeighbourSettings(Settings):
    """Springs and dampers from each arm's end to the next, all around; unstressed at rest."""

    stiffness: Annotated[float, Unit("N/m", above=0.0)]
    damping: Annotated[float, Unit("N s/m", least=0.0)] = 0.0


class NeighbourSpring(NamedTuple):
    """Spring and damper between the ends of two arms."""

    stiffness: float  # k [N/m]
    damping: float  # b [N s/m]
    distance: float  # D, between the ends where it is free [m]


class NeighbourSprings(NamedTuple):
    """Springs of all arms."""

    springs: tuple[NeighbourSpring, ...]  # of each arm to the next, of the last to the first


class EndMotion(NamedTuple):
    """End of an arm relative to the main body, body axes."""

    place: Vec  # [m]
    velocity: Vec  # as seen from the body [m/s]


class NeighbourLoad(NamedTuple):
    """What springs between arms do to them."""

    pulls: tuple[tuple[Vec, ...], ...]  # force on the end of each arm, body axes [N]; mostly none
    loss: float  # in their dampers [W]


class _Tension(NamedTuple):
    """Of one spring."""

    pull: Vec  # on the first end, towards the second [N]
    loss: float  # [W]


def next_of(values: tuple[Any, ...]) -> tuple[Any, ...]:
    """Of each arm, the value of the next; of the last, that of the first."""
    return values[1:] + values[:1]


@kernel
def _end_motion(arm: Any, length: float, rate: float) -> EndMotion:
    pose = arm_pose(arm, length, rate, Vec(0.0, 0.0, 0.0))
    return EndMotion(pose.lever, pose.sliding)


@kernel
def _tension(spring: NeighbourSpring, first: EndMotion, second: EndMotion) -> _Tension:
    between = second.place - first.place
    distance = norm(between)
    along = between * (1.0 / larger(distance, TOGETHER))
    rate = along @ (second.velocity - first.velocity)
    damped = spring.damping * rate
    return _Tension(
        (spring.stiffness * (distance - spring.distance) + damped) * along, damped * rate
    )


@kernel
def _both_pulls(ahead: _Tension, behind: _Tension) -> tuple[Vec]:
    return (ahead.pull - behind.pull,)


@kernel
def _no_pull(arm: Any) -> tuple[()]:
    return ()


@kernel
def _loss_of(tension: _Tension) -> float:
    return tension.loss


@generic
def neighbour_load(
    neighbours: Any, arms: tuple[Any, ...], lengths: tuple[float, ...], rates: tuple[float, ...]
) -> NeighbourLoad:
    """What springs between the ends of arms do to them; mostly there are none.

    Args:
        neighbours: `NeighbourSprings`, or an empty tuple.
        arms: Constants of all arms.
        lengths: l_j [m].
        rates: l̇_j [m/s].
    """
    return NeighbourLoad(tree_map(_no_pull, (arms,), ()), 0.0)


@neighbour_load.register(NeighbourSprings)
@kernel
def _load_of_springs(
    neighbours: NeighbourSprings,
    arms: tuple[Any, ...],
    lengths: tuple[float, ...],
    rates: tuple[float, ...],
) -> NeighbourLoad:
    ends = tree_map(_end_motion, (arms, lengths, rates), ())
    ahead = tree_map(_tension, (neighbours.springs, ends, ends[1:] + ends[:1]), ())
    pulls = tree_map(_both_pulls, (ahead, ahead[-1:] + ahead[:-1]), ())
    return NeighbourLoad(pulls, tree_sum(tree_map(_loss_of, (ahead,), ())))


@kernel
def _stretch_energy(spring: NeighbourSpring, first: EndMotion, second: EndMotion) -> float:
    stretch = norm(second.place - first.place) - spring.distance
    return 0.5 * spring.stiffness * stretch * stretch


@generic
def neighbour_energy(
    neighbours: Any, arms: tuple[Any, ...], lengths: tuple[float, ...], rates: tuple[float, ...]
) -> float:
    """Energy in the springs between arms [J]; arguments as for `neighbour_load`."""
    return 0.0


@neighbour_energy.register(NeighbourSprings)
@kernel
def _energy_of_springs(
    neighbours: NeighbourSprings,
    arms: tuple[Any, ...],
    lengths: tuple[float, ...],
    rates: tuple[float, ...],
) -> float:
    ends = tree_map(_end_motion, (arms, lengths, rates), ())
    return tree_sum(tree_map(_stretch_energy, (neighbours.springs, ends, ends[1:] + ends[:1]), ()))


@kernel
def with_pull(so_far: float, pull: Vec, direction: Vec) -> float:
    """Force on an arm along the path of its end, with that of a pull on that end [N]."""
    return so_far + pull @ direction
