"""Whole flights of arms on joints, beside MuJoCo, in closed form and in the mirror; plain Python."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace
from types import ModuleType

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from builders.cases import nonempty
from builders.joint_crafts import (
    JOINTS,
    USERS,
    impact,
    model_of,
    pose_of,
    relative_error,
    state_of,
    user_flight,
    vehicle,
)
from oracles import joint_lagrangian as lagrangian
from oracles import models
from oracles.joint_lagrangian import Between, Cloud, Craft, Pose
from springback.dynamics.ledger import ledger_balance
from springback.simulation.flight import FlightRecord, fly_one

joints = pytest.mark.parametrize("name", JOINTS)


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


@joints
def test_free_flights_are_those_of_mujoco(engines: ModuleType, name: str) -> None:
    """A spinning vehicle whose arms swing for 6 ms, rotors on; the ledger closes.

    Measured: places to 8e-10 rad, those of the main body to 2e-11 m; residuals to 2e-7.
    """
    craft, start = vehicle(name, 1)
    step = 5e-5 if name == "latched joints" else 1e-4  # a latch is steep where it opens
    flight = flown(craft, start, None, until=0.006, step=step)
    theirs = engines.InMujoco(craft).fly(start, None, until=0.006, step=0.5 * step)
    ours = pose_of(craft, flight.motion.state)
    assert np.abs(ours.bends - start.bends).max() > 0.01
    assert_same(ours, theirs, 5e-9, 1e-6)
    assert residual_of(flight) < 1e-6


@pytest.mark.parametrize(
    "name",
    [
        "oblique slides",
        "hinges about an odd axis",
        "latched joints",
        "joints with springs between",
    ],
)
def test_impacts_are_those_of_mujoco(engines: ModuleType, name: str) -> None:
    """The first 3 ms of an oblique impact with friction; the ledger closes.

    Measured: places to 8e-9 rad, those of the main body to 1e-10 m; residuals to 2e-8.
    """
    craft, start, scene = impact(name, 1)
    flight = flown(craft, start, scene, until=0.003, step=5e-5)
    theirs = engines.InMujoco(craft).fly(start, scene, until=0.003, step=1e-5)
    assert flight.record.contacts.total >= 1.0
    assert_same(pose_of(craft, flight.motion.state), theirs, 5e-8, 5e-5)
    assert residual_of(flight) < 1e-7


def swinging(name: str) -> tuple[Craft, Pose]:
    """A spinning vehicle without weight, thrust and damping, whose arms swing."""
    craft, start = vehicle(name, 2)
    limbs = tuple(replace(limb, thrust=0.0, damping=0.0) for limb in craft.limbs)
    between = replace(craft.between, damping=0.0) if craft.between else None
    return replace(craft, gravity=0.0, limbs=limbs, between=between), start


@joints
def test_free_flight_keeps_momenta_and_energy(name: str) -> None:
    """6 ms without weight, thrust and damping.  Measured: 7e-12 and, of energy, 7e-9."""
    craft, start = swinging(name)
    flight = flown(craft, start, None, until=0.006, step=1e-4)
    before, after = Cloud(craft, start), Cloud(craft, pose_of(craft, flight.motion.state))
    assert relative_error(after.momentum, before.momentum) < 1e-10
    assert relative_error(after.angular_momentum, before.angular_momentum) < 1e-10
    assert flight.after.total == pytest.approx(flight.before.total, rel=1e-8)


def test_steps_are_of_order_four() -> None:
    """Runge and Kutta's, where nothing touches.  Measured: 4.13."""
    craft, start = swinging("hinges about an odd axis")
    ends = [
        pose_of(craft, flown(craft, start, None, until=0.0096, step=step).motion.state)
        for step in (1.6e-3, 8e-4, 4e-4)
    ]
    coarse, fine = (np.abs(a.bends - b.bends).max() for a, b in nonempty(itertools.pairwise(ends)))
    assert 3.8 < math.log2(coarse / fine) < 4.4


@pytest.mark.parametrize("name", ["latched joints", "joints with springs between"])
def test_steps_with_latches_and_springs_between_are_of_order_four(name: str) -> None:
    """Where nothing touches and no force has a kink.  Measured: 4.22 and 3.97.

    Latches are three times as long as drawn: those are so steep that these steps gain faster.
    """
    craft, start = swinging(name)
    limbs = tuple(
        replace(limb, quadratic=0.0, latch=(limb.latch[0], 3.0 * limb.latch[1]))
        for limb in craft.limbs
    )
    craft = replace(craft, limbs=limbs)
    ends = [
        pose_of(craft, flown(craft, start, None, until=0.0048, step=step).motion.state)
        for step in (4e-4, 2e-4, 1e-4)
    ]
    assert all(np.abs(end.bends - start.bends).max() > 0.005 for end in nonempty(ends))
    coarse, fine = (np.abs(a.bends - b.bends).max() for a, b in nonempty(itertools.pairwise(ends)))
    assert 3.8 < math.log2(coarse / fine) < 4.4


@pytest.mark.parametrize("name", ["oblique slides", "hinges about an odd axis"])
def test_stiff_springs_are_rigid(name: str) -> None:
    """The way to the flight with locked arms goes as 1/k.  Measured: 10.3 to 11.0 for tenfold k."""
    craft, start = swinging(name)
    start, apart = replace(start, bends=0.0 * start.bends), []
    model, state = model_of(craft, until=4e-3), state_of(craft, start)
    arms = tuple(arm._replace(compliance=0.0, inverse_mass=0.0) for arm in model.airframe.arms)
    locked = model._replace(airframe=model.airframe._replace(arms=arms))
    rigid = pose_of(craft, fly_one(locked, state, trace=False, executor="python").motion.state)
    assert not rigid.bends.any()
    for factor in (1e2, 1e3):
        limbs = []
        for limb in craft.limbs:
            k = factor * limb.stiffness
            damping = limb.radius * math.sqrt(k * limb.mass)  # half of critical
            limbs.append(replace(limb, stiffness=k, damping=damping))
        stiff = replace(craft, limbs=tuple(limbs))
        flight = flown(stiff, start, None, until=4e-3, step=5e-5)
        there = pose_of(craft, flight.motion.state)
        apart.append([np.abs(there.rotation - rigid.rotation).max(), np.abs(there.bends).max()])
    softer, stiffer = np.array(apart)
    assert 9.5 < (softer / stiffer).min() <= (softer / stiffer).max() < 11.5


def held(craft: Craft, by: str, k: float) -> Craft:
    """Arms that latches hold, or springs between three of them, as stiffly as ``k`` [N/m].

    Damped to some 15 % of critical, so that it rings down within a millisecond.
    """
    if by == "springs between":
        ends = [limb.end for limb in craft.limbs]
        free = tuple(
            float(np.linalg.norm(b - a))
            for a, b in zip(ends, [*ends[1:], ends[0]], strict=True)
        )  # fmt: skip
        return replace(craft, between=Between(k, 0.3 * math.sqrt(0.05 * k), free))
    limbs = []
    for limb in craft.limbs:
        along, travel = limb.radius**2 * k, limb.latch[1]
        damping = 0.3 * limb.radius**2 * math.sqrt(k * limb.mass)
        latch = (9.0 / 16.0 * along * travel, travel)  # of that slope where it holds
        limbs.append(replace(limb, latch=latch, damping=damping))
    return replace(craft, limbs=tuple(limbs))


@pytest.mark.parametrize(
    ("name", "by"), [("latched joints", "latch"), ("oblique slides", "springs between")]
)
def test_impacts_of_arms_that_are_held_stiffly_are_rigid(name: str, by: str) -> None:
    """Latches that stay closed; a triangle of springs, the arms' own as soft as ever.

    The way to the impact of locked arms goes as 1/k, the lag of the dampers faster.  Measured: 8.7
    to 11.2 for tenfold k, the last of which turn 0.005 rad/s of 3 otherwise.
    """
    craft, start, scene = impact(name, 2)
    model, state = model_of(craft, scene, until=2e-3, step=2e-5), state_of(craft, start)
    arms = tuple(arm._replace(compliance=0.0, inverse_mass=0.0) for arm in model.airframe.arms)
    locked = model._replace(airframe=model.airframe._replace(arms=arms))
    flight = fly_one(locked, state, trace=False, executor="python")
    assert flight.record.contacts.total >= 1.0
    rigid, apart = pose_of(craft, flight.motion.state), []
    for k, step in ((1e6, 2e-5), (1e7, 1e-5)):
        stiff = held(craft, by, k)
        there = pose_of(craft, flown(stiff, start, scene, until=2e-3, step=step).motion.state)
        if by == "latch":
            for bend, limb in nonempty(list(zip(there.bends, stiff.limbs, strict=True))):
                assert abs(bend) < 0.01 * limb.latch[1]
        names = ("position", "rotation", "velocity", "omega", "bends")
        apart.append([np.abs(getattr(there, at) - getattr(rigid, at)).max() for at in names])
    assert np.abs(rigid.omega - start.omega).max() > 0.2
    softer, stiffer = np.array(apart)
    assert 8.0 < (softer / stiffer).min() <= (softer / stiffer).max() < 12.0


@pytest.mark.parametrize(
    "name",
    [
        "oblique slides",
        "hinges about an odd axis",
        "latched joints",
        "joints with springs between",
    ],
)
def test_mirrored_and_turned_impacts(name: str) -> None:
    """y → −y; a quarter turn of vehicle and wall; other body axes.  Latches are short: some open.

    Measured: places to 1e-11, arms' rates to 2e-8 rad/s; in the mirror, bit by bit.
    """
    craft, start, scene = impact(name, 2)
    limbs = [replace(limb, latch=(limb.latch[0], 0.02 * limb.latch[1])) for limb in craft.limbs]
    craft = replace(craft, limbs=tuple(limbs))
    quarter, wall = Rotation.from_euler("z", 90, degrees=True), scene.wall
    mirror = replace(scene, wall=replace(wall, normal=wall.normal * lagrangian.ACROSS))
    around = replace(scene, wall=replace(wall, normal=quarter.apply(wall.normal)))

    def end_of(craft: Craft, start: Pose, scene: models.Scene) -> Pose:
        flight = flown(craft, start, scene, until=0.002, step=1e-4)
        assert flight.record.contacts.total >= 1.0
        return pose_of(craft, flight.motion.state)

    end = end_of(craft, start, scene)
    travels = np.array([limb.latch[1] for limb in limbs])
    assert name != "latched joints" or (np.abs(end.bends) > travels).any()
    seen = end_of(*lagrangian.mirrored(craft, start), mirror)
    assert_same(seen, lagrangian.mirrored(craft, end)[1], 1e-12, 1e-10)
    seen = end_of(craft, lagrangian.turned(start, quarter), around)
    assert_same(seen, lagrangian.turned(end, quarter), 1e-10, 1e-7)
    seen = end_of(*lagrangian.renamed(craft, start, quarter), scene)
    assert_same(seen, lagrangian.renamed(craft, end, quarter)[1], 1e-10, 1e-7)


@pytest.mark.parametrize("name", USERS)
def test_the_ledger_of_an_impact_closes(name: str) -> None:
    """With stops, preload, play and tables, from a flight as one rigid body.  Measured: 4e-8."""
    found = user_flight({"joint": USERS[name], "torque_ratio": 0.016}).measures
    residual, friction, stop = (
        found[key] or 0.0 for key in ("ledger_residual", "loss_friction", "loss_stop")
    )
    assert abs(residual) < 1e-7
    assert friction > 1e-3
    assert (stop > 1e-8) == (name != "folding")


def test_a_slide_inwards_flies_as_a_planar_arm() -> None:
    """A whole impact.  Measured: to 7e-16."""
    slide = USERS["slide"]
    ours = user_flight({"joint": slide})
    planar = {"stiffness": slide["stiffness"], "damping": slide["damping"], "stroke": "1.9 mm"}
    theirs = user_flight(planar)
    for name in ("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz", "l1", "dl1"):
        there = theirs.columns[name][-1]
        assert ours.columns[name][-1] == pytest.approx(there, rel=1e-12, abs=1e-12)
