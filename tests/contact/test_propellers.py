"""Propellers as discs: what reaches into one is known to hit it, though no force is there."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import springback
from builders.impacts import value
from oracles import distances, geometry
from oracles.distances import Field
from springback.batch.scenarios import fly_scenarios
from springback.dynamics.clearance import AT_HIT

Array = NDArray[np.float64]
WORLDS = geometry.worlds()
#: Shapes that a disc can reach around, or into: the nearest point may be another one.
HOLLOW = ("hoop", "window", "round", "doorway", "stairs", "forest", "edge")
POSES = 150


def least_in_discs(field: Field, poses: geometry.Poses) -> Array:
    """Least distance within discs, by samples that close in on it."""
    found = np.empty(len(poses.centre))
    angle = np.linspace(0.0, 2.0 * np.pi, 96, endpoint=False)
    share = np.sqrt(np.linspace(0.0, 1.0, 33))
    ring = share[:, None, None] * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    start = geometry.RADIUS * ring.reshape(-1, 2)
    around = np.stack(np.meshgrid(*[np.linspace(-1.0, 1.0, 9)] * 2), axis=-1).reshape(-1, 2)
    for k, (centre, turn) in enumerate(zip(poses.centre, poses.turn, strict=True)):

        def gaps(flat: Array, centre: Array = centre, turn: Array = turn) -> Array:
            return field(centre + flat @ turn[:, :2].T)

        there = gaps(start)
        best, width = start[np.argsort(there)[:4]], 0.02
        least = there.min()
        for _ in range(9):
            near = (best[:, None] + width * around).reshape(-1, 2)
            away = np.linalg.norm(near, axis=1, keepdims=True)
            near = near * np.minimum(1.0, geometry.RADIUS / np.maximum(away, 1e-12))
            there = gaps(near)
            best, least = near[np.argsort(there)[:4]], min(least, there.min())
            width *= 0.35
        found[k] = least
    return found


@pytest.mark.parametrize("name", WORLDS)
def test_gap_of_a_disc_is_that_of_samples(name: str) -> None:
    """Hits are seen; gaps are 2 mm too large at most, beside hollow shapes they may be larger."""
    bodies = geometry.bodies_of(WORLDS[name])
    world: Any = geometry.obstacles((WORLDS[name],), as_scene=True)
    poses = geometry._drawn(np.random.default_rng(5), "ring", bodies)
    more = geometry._drawn(np.random.default_rng(6), "ring", bodies)
    both = [np.concatenate(pair)[:POSES] for pair in zip(poses, more, strict=True)]
    poses = geometry.Poses(*both)
    true = least_in_discs(distances.least(bodies), poses)
    ours = geometry.package_faces(world, "disc", poses).gap
    assert np.all(ours > true - 1e-5), name
    hit = true < -1e-3
    assert hit.sum() > 10
    assert np.all(ours[hit] < AT_HIT), name
    if name not in HOLLOW:
        assert np.abs(ours - true)[true > 0.0].max(initial=0.0) < 2e-3, name
    in_flight = geometry.package_faces(world, "disc", poses, exact=False).gap
    assert np.all(in_flight < ours + 1e-12)
    assert np.array_equal(in_flight < AT_HIT, ours < AT_HIT)


def over_a_post(**changes: Any) -> dict[str, Any]:
    """Robot that falls onto a thin upright post below the middle of its first propeller."""
    aside = 0.19 * math.cos(math.pi / 4.0)
    post = {
        "type": "capsule", "start": [aside, aside, -2.0], "end": [aside, aside, 0.395],
        "radius": 0.005, "surface": "wall",
    }  # fmt: skip
    return {
        "vehicle": {"preset": "quad", **changes.pop("vehicle", {})},
        "world": {"obstacles": [post, *changes.pop("obstacles", [])]},
        "start": {"position": [0.0, 0.0, 0.5]},
        "simulation": {"duration": 0.2},
        **changes,
    }


def test_a_post_within_a_cage_hits_the_propeller_and_nothing_else() -> None:
    """It is hit when it has fallen by 0.1 m, to within a step; the fall goes on without a force."""
    flight = springback.fly(over_a_post())
    assert flight.measures["propellers_hit"] == 1.0
    fallen = math.sqrt(2.0 * 0.1 / 9.81)
    assert value(flight, "propeller_hit_time") == pytest.approx(fallen, abs=1.1e-3)
    assert flight.measures["contacts"] == 0.0
    (event,) = [event for event in flight.events if event.kind == "propeller"]
    assert event.t == value(flight, "propeller_hit_time")


def test_a_propeller_above_the_cage_is_hit_later() -> None:
    """By the height of its disc; and one of unknown size is not looked at."""
    raised = over_a_post(vehicle={"propulsion": {"disk_height": 0.03}})
    late = value(springback.fly(raised), "propeller_hit_time")
    assert late == pytest.approx(math.sqrt(2.0 * 0.13 / 9.81), abs=1.1e-3)
    unknown = springback.fly(over_a_post(vehicle={"propulsion": {"disk_radius": None}}))
    assert unknown.measures["propellers_hit"] is None
    assert unknown.measures["propeller_hit_time"] is None


def test_a_robot_on_its_back_hits_its_propellers_if_they_are_high() -> None:
    """On plain ground, where cage and hull carry it: discs 5 cm up are hit, those at 0 are not."""
    for height, hits in ((0.0, False), (0.05, True)):
        fallen = {
            "vehicle": {"preset": "quad", "propulsion": {"disk_height": height}},
            "world": {"obstacles": [{"type": "ground", "surface": "wall"}]},
            "start": {"position": [0.0, 0.0, 0.3], "roll": "180 deg"},
            "simulation": {"duration": 1.0},
        }
        assert (value(springback.fly(fallen), "propellers_hit") > 0.0) is hits, height


def test_many_flights_tell_what_one_tells() -> None:
    """Hits of flights in lanes are those of each alone, to the bit."""
    tables = [over_a_post(start={"position": [0.01 * k, -0.004 * k, 0.5]}) for k in range(12)]
    rows = fly_scenarios(tables)
    names = ("propellers_hit", "propeller_hit_time")
    alone = [springback.fly(table).measures for table in tables]
    for name in names:
        single = [math.nan if m[name] is None else m[name] for m in alone]
        assert np.array_equal(rows.measures[name], single, equal_nan=True), name
    assert 0.0 < rows.measures["propellers_hit"].sum() < 12.0
