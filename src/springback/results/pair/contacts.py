"""Contacts of two vehicles that flew together, evaluated again from their trajectories."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np

from springback.contact.moving.bodies import ABSENT, CARRIED
from springback.contact.moving.hulls import with_hulls
from springback.contact.moving.scene import MovingScene
from springback.contact.scene.faces import SolidScene
from springback.contact.worlds import obstacles
from springback.kernels.compiler import executor, kernel
from springback.kernels.layout import Buffer, TreeLayout, read, write
from springback.kernels.trees import leaves
from springback.results.pair.flying import in_a_scene, law_between
from springback.scenario.model import RING_ROUNDING
from springback.scenario.scenario import Scenario
from springback.simulation.flight import model_state
from springback.simulation.measuring.record import Model
from springback.simulation.pair.flying import PairedFlight, beside_each_other
from springback.simulation.pair.parts import parts_of
from springback.simulation.pair.solids import solids_of
from springback.simulation.playback import LoadHistory, load_history, states_at
from springback.vehicle.state import Airframe, BodyState, State

Array = np.ndarray[Any, np.dtype[np.float64]]
Places = np.ndarray[Any, np.dtype[np.intp]]
Columns = Mapping[str, Array]


def loads_on_first(
    scenario: Scenario, first: Columns, second: Columns, places: Places
) -> LoadHistory:
    """Contacts of the first of two vehicles, with the world and with the second.

    Args:
        scenario: Of both.
        first: Trajectory of the first vehicle.
        second: That of the second, at the same instants.
        places: Rows of the instants.
    """
    seen = pair_view(scenario, first, second)
    return load_history(seen.model, seen.columns, places)


def loads_on_second(
    scenario: Scenario, first: Columns, second: Columns, places: Places
) -> LoadHistory:
    """Contacts of the second of two vehicles: with the world, and the opposite of the first's.

    Elastic energy of the contact between both is the first's.  Arguments as for `loads_on_first`.
    """
    seen = pair_view(scenario, first, second)
    world = load_history(seen.other, second, places)
    found = [(world.part, world.force, world.point)]
    normal, rubbing = world.normal.copy(), world.rubbing.copy()
    for k in range(normal.shape[1]):
        met = load_history(seen.of_part(k), seen.columns, places)
        found.append(((k,) * len(met.part), -met.force, met.point))
        normal[:, k] += met.normal.sum(axis=1)
        rubbing[:, k] -= met.rubbing.sum(axis=1)
    part = tuple(number for parts, _, _ in found for number in parts)
    force, point = (np.concatenate([one[i] for one in found], axis=1) for i in (1, 2))
    acts = np.abs(force).max(axis=(0, 2), initial=0.0) > 0.0
    acts[: len(world.part)] = True
    part = tuple(number for number, there in zip(part, acts, strict=True) if there)
    return LoadHistory(part, force[:, acts], point[:, acts], normal, rubbing, world.energy)


class PairView(NamedTuple):
    """The first of two vehicles, to which the parts of the second are moving obstacles."""

    model: Model
    columns: dict[str, Array]
    """Its trajectory, and that of these obstacles: ``obstacle0_x`` and so on."""
    other: Model
    """The second vehicle in the world at rest."""

    def of_part(self, number: int) -> Model:
        """Model in a world of one part of the second vehicle alone."""
        nothing = _nothing(self.model)._replace(
            remembers=self.model.world.obstacles.still.remembers
        )
        return _with_bodies(self.model, lambda k: k == number, nothing)


def pair_view(scenario: Scenario, first: Columns, second: Columns) -> PairView:
    """The first of two vehicles that flew together, for its contacts to be evaluated again.

    Args:
        scenario: Of both.
        first: Trajectory of the first vehicle.
        second: That of the second, at the same instants.
    """
    other = scenario.beside()
    one, two = (
        PairedFlight(
            in_a_scene(each, each.vehicle, each.flight_model()),
            each.start_state(),
            None,
            None,
            solids_of(each.vehicle),
        )
        for each in (scenario, other)
    )
    model, opposite = (x.model for x in beside_each_other(one, two, law_between(scenario)))
    scene = model.world.obstacles
    assert isinstance(scene, MovingScene)
    numbered = tuple(
        body._replace(obstacle=float(k)) if body.kind == CARRIED else body
        for k, body in enumerate(scene.bodies)
    )
    world = model.world._replace(obstacles=scene._replace(bodies=numbered))
    parts = part_columns(opposite, second)
    alone = _with_bodies(opposite, lambda k: False)
    return PairView(model._replace(world=world), {**first, **parts}, alone)


def _nothing(model: Model) -> SolidScene:
    """A world without anything, which a vehicle with hulls can be asked about as well."""
    nothing = obstacles((), as_scene=True)
    assert isinstance(nothing, SolidScene)
    return with_hulls(nothing, RING_ROUNDING) if model.world.obstacles.still.hull_query else nothing


def _with_bodies(
    model: Model, there: Callable[[int], bool], still: SolidScene | None = None
) -> Model:
    """A model in whose world only some moving obstacles are left, and other solids if given."""
    scene = model.world.obstacles
    assert isinstance(scene, MovingScene)
    bodies = tuple(
        one if there(k) else one._replace(kind=ABSENT) for k, one in enumerate(scene.bodies)
    )
    scene = scene._replace(still=scene.still if still is None else still, bodies=bodies)
    return model._replace(world=model.world._replace(obstacles=scene))


def part_columns(model: Model, columns: Columns) -> dict[str, Array]:
    """Pose and motion of the cages and the hull of a vehicle, as of moving obstacles from 0.

    Args:
        model: Of the vehicle.
        columns: Its trajectory.
    """
    alone = model._replace(world=model.world._replace(obstacles=_nothing(model)))
    like = _Vehicle(alone.airframe, model_state(alone))
    states = states_at(alone, columns, slice(None))
    constants = np.array(leaves(alone.airframe))
    given = np.hstack([np.broadcast_to(constants, (len(states), len(constants))), states])
    still = _parts(like)
    names = [f"{stem}{part}" for stem, parts in _OF_BODY for part in parts]
    out = np.zeros((len(states), len(leaves(still))))
    _all_parts(TreeLayout(like), np.ascontiguousarray(given), out)
    return {
        f"obstacle{k}_{name}": out[:, k * len(names) + i]
        for k in range(len(still))
        for i, name in enumerate(names)
    }


#: Columns of a moving obstacle, as `springback.vehicle.state.BodyState` has them.
_OF_BODY = (("", "xyz"), ("q", "wxyz"), ("v", "xyz"), ("w", "xyz"))


class _Vehicle(NamedTuple):
    """A vehicle at one instant."""

    airframe: Airframe
    state: State


@kernel
def _parts(at: _Vehicle) -> tuple[BodyState, ...]:
    return parts_of(at.airframe, at.state)


@executor(nogil=True)
def _all_parts(like: TreeLayout, instants: Buffer, out: Buffer) -> None:
    """Write `_parts` for each instant; the rows of the buffers hold the leaves."""
    for i in range(instants.shape[0]):
        write(_parts(read(like, instants[i], 0, 1, 0)), out[i], 0, 1, 0)
