"""Whole flights of arms on two joints: beside MuJoCo, in closed form, in the mirror; plain Python."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace
from types import ModuleType

import numpy as np
import pytest

from builders import joint_crafts
from builders.bent_crafts import impact, model_of, pose_of, state_of, vehicle
from builders.cases import nonempty
from builders.joint_crafts import relative_error
from oracles import joint_lagrangian as lagrangian
from oracles import models
from oracles.bent_limbs import PAIRS
from oracles.joint_lagrangian import Cloud, Craft, Limb, Pose
from springback.dynamics.ledger import ledger_balance
from springback.simulation.flight import FlightRecord, fly_one

pairs = pytest.mark.parametrize("name", PAIRS)


def flown(
    craft: Craft, start: Pose, scene: models.Scene | None, *, until: float, step: float
) -> FlightRecord:
    """A flight with arms that always move, by the interpreter, at equal steps without contact."""
    model = model_of(craft, scene, until=until, step=step)
    return fly_one(model, state_of(craft, start), trace=False, executor="python")


def residual_of(flight: FlightRecord) -> float:
    """Energy that is not accounted for, as a share of the largest."""
    work = flight.motion.work
    return float(abs(ledger_balance(work, flight.before, flight.after).residual))


def assert_same(a: Pose, b: Pose, places: float, speeds: float) -> None:
    """Two states agree, by places and angles [m, rad] and by speeds [m/s, rad/s]."""
    for name in ("position", "rotation", "bends"):
        np.testing.assert_allclose(getattr(a, name), getattr(b, name), rtol=0, atol=places)
    for name in ("velocity", "omega", "rates"):
        np.testing.assert_allclose(getattr(a, name), getattr(b, name), rtol=0, atol=speeds)


@pairs
def test_free_flights_are_those_of_mujoco(engines: ModuleType, name: str) -> None:
    """A spinning vehicle whose arms swing both ways for 4 ms, rotors on; the ledger closes."""
    craft, start = vehicle(name, 1)
    flight = flown(craft, start, None, until=0.004, step=1e-4)
    theirs = engines.InMujoco(craft).fly(start, None, until=0.004, step=5e-5)
    ours = pose_of(craft, flight.motion.state)
    assert np.abs(ours.bends - start.bends).max(axis=0).min() > 1e-4
    assert_same(ours, theirs, 5e-9, 2e-6)
    assert residual_of(flight) < 1e-6


@pytest.mark.parametrize("name", ["universal joints", "hinges on slides"])
def test_impacts_are_those_of_mujoco(engines: ModuleType, name: str) -> None:
    """The first 3 ms of an oblique impact with friction; the ledger closes."""
    craft, start, scene = impact(name, 1)
    flight = flown(craft, start, scene, until=0.003, step=5e-5)
    theirs = engines.InMujoco(craft).fly(start, scene, until=0.003, step=1e-5)
    assert flight.record.contacts.total >= 1.0
    assert_same(pose_of(craft, flight.motion.state), theirs, 5e-8, 5e-5)
    assert residual_of(flight) < 1e-6


def swinging(name: str) -> tuple[Craft, Pose]:
    """A spinning vehicle without weight, thrust and damping, whose arms swing."""
    craft, start = vehicle(name, 2)
    limbs = tuple(
        replace(limb, thrust=0.0, damping=0.0, second=replace(limb.chain[1], damping=0.0))  # type: ignore[call-arg]
        for limb in craft.limbs
    )
    return replace(craft, gravity=0.0, limbs=limbs), start


@pairs
def test_free_flight_keeps_momenta_and_energy(name: str) -> None:
    """4 ms without weight, thrust and damping."""
    craft, start = swinging(name)
    flight = flown(craft, start, None, until=0.004, step=1e-4)
    before, after = Cloud(craft, start), Cloud(craft, pose_of(craft, flight.motion.state))
    assert relative_error(after.momentum, before.momentum) < 1e-10
    assert relative_error(after.angular_momentum, before.angular_momentum) < 1e-10
    assert flight.after.total == pytest.approx(flight.before.total, rel=1e-7)


def test_steps_are_of_order_four() -> None:
    """Runge and Kutta's, where nothing touches."""
    craft, start = swinging("hinges apart")
    ends = [
        pose_of(craft, flown(craft, start, None, until=0.0096, step=step).motion.state)
        for step in (1.6e-3, 8e-4, 4e-4)
    ]
    coarse, fine = (np.abs(a.bends - b.bends).max() for a, b in nonempty(itertools.pairwise(ends)))
    assert 3.7 < math.log2(coarse / fine) < 4.5


def stiff(limb: Limb, which: int, factor: float) -> Limb:
    """An arm, one of its joints stiffer and critically damped by half."""
    one = limb.chain[which]
    k = factor * one.stiffness
    change = {"stiffness": k, "damping": one.radius * math.sqrt(k * limb.mass)}
    if which == 0:
        return replace(limb, **change)  # type: ignore[arg-type]
    return replace(limb, second=replace(one, **change))  # type: ignore[call-arg, arg-type]


@pytest.mark.parametrize(
    ("name", "which"), [("universal joints", 0), ("hinges apart", 0), ("hinges apart", 1)]
)
def test_a_stiff_joint_leaves_an_arm_on_the_other(name: str, which: int) -> None:
    """The way to the flight of arms on one joint goes as 1/k.  Measured: 9.8 to 10.8 for tenfold."""
    craft, start = swinging(name)
    held = start.bends * (np.arange(2) != which)
    start = replace(start, bends=held)
    chains = [limb.chain[1 - which] for limb in craft.limbs]
    limbs = tuple(
        replace(
            one, end=limb.end, mass=limb.mass, thrust=0.0, torque_ratio=limb.torque_ratio,
            follows=limb.follows, cage_radius=limb.cage_radius,
        )
        for one, limb in zip(chains, craft.limbs, strict=True)
    )  # fmt: skip
    limbs = tuple(
        Limb(**{key: getattr(one, key) for key in Limb.__dataclass_fields__}) for one in limbs
    )
    alone, alone_start = (
        replace(craft, limbs=limbs),
        replace(start, bends=held[:, 1 - which], rates=0.0 * held[:, 0]),
    )
    model = joint_crafts.model_of(alone, until=3e-3, step=5e-5)
    there = fly_one(
        model, joint_crafts.state_of(alone, alone_start), trace=False, executor="python"
    )
    single, apart = joint_crafts.pose_of(alone, there.motion.state), []
    for factor in (1e3, 1e4):
        limbs = tuple(stiff(limb, which, factor) for limb in craft.limbs)
        flight = flown(replace(craft, limbs=limbs), start, None, until=3e-3, step=5e-5)
        ours = pose_of(craft, flight.motion.state)
        apart.append([
            np.abs(ours.rotation - single.rotation).max(),
            np.abs(ours.bends[:, 1 - which] - single.bends).max(),
        ])  # fmt: skip
    assert np.abs(single.bends - held[:, 1 - which]).max() > 1e-3
    assert 9.0 < min(np.divide(*apart)) <= max(np.divide(*apart)) < 11.5


def test_mirrored_impacts() -> None:
    """y → −y, bit by bit."""
    craft, start, scene = impact("hinges apart", 2)
    mirror = replace(scene, wall=replace(scene.wall, normal=scene.wall.normal * lagrangian.ACROSS))

    def end_of(craft: Craft, start: Pose, scene: models.Scene) -> Pose:
        flight = flown(craft, start, scene, until=0.002, step=1e-4)
        assert flight.record.contacts.total >= 1.0
        return pose_of(craft, flight.motion.state)

    end = end_of(craft, start, scene)
    seen = end_of(*lagrangian.mirrored(craft, start), mirror)
    assert_same(seen, lagrangian.mirrored(craft, end)[1], 1e-12, 1e-10)
