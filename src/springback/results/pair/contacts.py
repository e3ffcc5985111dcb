"""Contacts of two vehicles that flew together, evaluated again from their trajectories."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.contact.moving.bodies import ABSENT, CARRIED
from springback.contact.moving.hulls import with_hulls
from springback.contact.moving.scene import MovingScene
from springback.contact.scene.faces import SolidScene
from springback.contact.worlds import obstacles
from springback.results.pair.flying import in_a_scene, law_between
from springback.scenario.model import RING_ROUNDING
from springback.scenario.scenario import Scenario
from springback.simulation.pair.flying import PairedFlight, beside_each_other
from springback.simulation.pair.solids import solids_of
from springback.simulation.playback import LoadHistory, load_history
from springback.simulation.record import Model
from springback.vehicle.state import Airframe

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
        nothing = obstacles((), as_scene=True)
        assert isinstance(nothing, SolidScene)
        if self.model.world.obstacles.still.hull_query:
            nothing = with_hulls(nothing, RING_ROUNDING)
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
    parts = part_columns(other.true_airframe(), second)
    alone = _with_bodies(opposite, lambda k: False)
    return PairView(model._replace(world=world), {**first, **parts}, alone)


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


def part_columns(airframe: Airframe, columns: Columns) -> dict[str, Array]:
    """Pose and motion of the cages and the hull of a vehicle, as of moving obstacles from 0.

    Args:
        airframe: Of the vehicle.
        columns: Its trajectory.
    """
    c, found = columns, dict[str, Array]()
    attitude = np.stack([c[f"q{part}"] for part in "wxyz"], axis=1)
    turn = scipy.spatial.transform.Rotation.from_quat(attitude, scalar_first=True).as_matrix()
    place, velocity, spin = (
        np.stack([c[f"{stem}{axis}"] for axis in "xyz"], axis=1) for stem in ("", "v", "w")
    )
    ends = [
        (np.array([arm.cosine, arm.sine, 0.0]), c[f"l{j}"][:, None], c[f"dl{j}"][:, None])
        for j, arm in enumerate(airframe.arms, start=1)
    ]
    levers = [(length * along, rate * along) for along, length, rate in ends]
    levers += [(np.zeros((1, 3)), np.zeros((1, 3)))] * len(airframe.hull)
    for k, (lever, rate) in enumerate(levers):
        there = place + np.einsum("tij,tj->ti", turn, np.broadcast_to(lever, place.shape))
        moving = np.cross(spin, lever) + rate
        speed = velocity + np.einsum("tij,tj->ti", turn, moving)
        stem = f"obstacle{k}_"
        for name, values in (("", there), ("v", speed), ("w", spin)):
            found |= {f"{stem}{name}{axis}": values[:, i] for i, axis in enumerate("xyz")}
        found |= {f"{stem}q{part}": c[f"q{part}"] for part in "wxyz"}
    return found
