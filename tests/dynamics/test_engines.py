"""The same vehicle in Pinocchio and in MuJoCo, state by state and through whole impacts.

The engines bring their own inertia, centrifugal and Coriolis terms; the loads are written down once
more in `oracles.loads`.  State by state all three agree to rounding.  In a flight the package lands its
steps on the instants of touch and separation, the oracles step over them; what is left is that
difference, a few nanometres at a step of 0.05 ms.
"""

from __future__ import annotations

import math
from dataclasses import replace
from types import ModuleType
from typing import Any, Literal

import numpy as np
import pytest

from builders.cases import nonempty
from oracles import models

pytest.importorskip("pinocchio")
pytest.importorskip("mujoco")
from oracles import mujoco_flight, pinocchio_flight  # only where the engines are

ENGINES = pytest.mark.parametrize(
    "engine", [pinocchio_flight, mujoco_flight], ids=["pinocchio", "mujoco"]
)

STATES = 120
#: Rounding; MuJoCo's point masses also carry 1e-14 kg m² of inertia each.
RELATIVE = 1e-9

STEP, DURATION = 5e-5, 0.07
POSITION = 1e-6  # [m]
ATTITUDE = 1e-5  # [rad]
PEAK = 5e-4  # of the peak: it is read at the steps, which do not coincide


def drawn(seed: int) -> tuple[models.Scene, models.Start]:
    """Unequal arms with end stops, a wall of any orientation, none to two cages in it, rotors on.

    Every fifth main body has a hull, and that is in the wall, too.
    """
    rng = np.random.default_rng([2, seed])
    craft = models.random_craft(rng, stops=True)
    start = models.random_start(rng, craft)
    scene = models.Scene(
        craft,
        models.Wall(models.unit_vector(rng), 0.0),
        thrust=tuple(rng.uniform(0.0, 12.0, size=4)),
        contact="ring" if seed % 2 else "tip",
        rounding=0.2 if seed // 2 % 2 else 0.0,
        friction_axes="both" if seed // 4 % 2 else "vertical",
    )
    scene = models.touching(scene, start, seed % 3, rng.uniform(1e-3, 15e-3))
    return (models.with_hull(scene, start, rng) if seed % 5 == 0 else scene), start


@ENGINES
def test_accelerations_are_those_of_the_engine(engine: ModuleType) -> None:
    """v̇, ω̇ and l̈ agree at random states, for both contact points and both kinds of friction."""
    for seed in range(STATES):
        scene, start = drawn(seed)
        ours = models.accelerations_of(scene, start)
        vehicle: Any = engine.Vehicle(scene.craft, scene.gravity)
        for a, b in nonempty(zip(ours, vehicle.accelerations(scene, start), strict=True)):
            assert np.abs(a - b).max() < RELATIVE * max(1.0, np.abs(b).max())


def test_accelerations_on_a_slider_obey_gauss_principle() -> None:
    """A main body that is guided along one axis and does not turn, as on the paper's testbed."""
    for seed in range(STATES):
        scene, start = drawn(seed)
        axis = models.unit_vector(np.random.default_rng(seed))
        start = replace(start, velocity=2.0 * axis, omega=np.zeros(3))
        ours = models.accelerations_of(scene, start, slider=axis)
        vehicle = pinocchio_flight.Vehicle(scene.craft, scene.gravity)
        theirs = vehicle.accelerations_on_slider(scene, start, axis)
        for a, b in nonempty(zip(ours, theirs, strict=True)):
            assert np.abs(a - b).max() < RELATIVE * max(1.0, np.abs(b).max())


def impact(
    cages: Literal[1, 2], contact: Literal["ring", "tip"]
) -> tuple[models.Scene, models.Start]:
    """An oblique, spinning impact at 2.3 m/s on a tilted wall, rotors on, products of inertia."""
    tilt, turn = 0.25, 0.35
    outward = -np.array(
        [math.cos(tilt) * math.cos(turn), math.cos(tilt) * math.sin(turn), math.sin(tilt)]
    )
    craft = models.compliant_craft()
    products = np.array([[0.0, 3e-4, -5e-4], [3e-4, 0.0, 4e-4], [-5e-4, 4e-4, 0.0]])
    start = models.Start(
        position=np.zeros(3),
        attitude=models.quaternion(0.15, -0.3, turn + (0.1 if cages == 2 else 0.7)),
        velocity=np.array([2.0, 1.2 if cages == 2 else -0.4, -0.5]),
        omega=np.array([1.5, -3.0, 4.0]),
        lengths=np.full(4, 0.19),
        rates=np.zeros(4),
    )
    scene = models.Scene(
        replace(craft, inertia=craft.inertia + products),
        models.Wall(outward, 0.0),
        thrust=(5.0, 6.0, 4.5, 5.5),
        contact=contact,
        friction_axes="both" if contact == "ring" else "vertical",
    )
    return models.touching(scene, start, 0, 0.01), start


@ENGINES
@pytest.mark.parametrize("contact", ["ring", "tip"])
@pytest.mark.parametrize("cages", [1, 2])
def test_whole_impacts_are_those_of_the_engine(
    engine: ModuleType, cages: Literal[1, 2], contact: Literal["ring", "tip"]
) -> None:
    """From before the touch until after the separation: place, attitude, arms, peak acceleration."""
    scene, start = impact(cages, contact)
    flown = models.fly(scene, start, until=DURATION, impact_step=STEP)
    record, ours = flown.record, models.start_of(flown.motion.state)
    theirs = engine.fly(scene, start, until=DURATION, step=STEP)

    assert sum(count > 0 for count in record.contacts.arms) == cages
    assert 0.0 < record.first_impact.touch_time < record.first_impact.separation_time < DURATION
    assert np.abs(ours.position - theirs.end.position).max() < POSITION
    assert np.abs(ours.rotation - theirs.end.rotation).max() < ATTITUDE
    assert np.abs(ours.lengths - theirs.end.lengths).max() < POSITION
    assert record.peaks.acceleration == pytest.approx(theirs.peak_acceleration, rel=PEAK)


def body_impact(lean: float) -> tuple[models.Scene, models.Start]:
    """The main body first into a wall that the rotor plane leans from by an angle [rad], spinning."""
    scene, start = impact(2, "ring")
    hull = models.Ball(np.array([0.004, -0.003, 0.01]), 0.06)
    wall = replace(scene.wall, normal=np.array([-1.0, 0.0, 0.0]), friction=0.4)
    start = replace(
        start,
        attitude=models.quaternion(0.1, 0.5 * math.pi - lean, 0.0),
        velocity=np.array([2.0, 0.3, -0.4]),
    )
    face = start.rotation[0] @ hull.centre + hull.radius + 0.01
    scene = replace(
        scene, craft=replace(scene.craft, hull=hull), wall=replace(wall, offset=float(-face))
    )
    return scene, start


@ENGINES
@pytest.mark.parametrize(("lean", "cages"), [(0.1, 1), (0.3, 2)])
def test_the_main_body_hits_the_wall_as_in_the_engine(
    engine: ModuleType, lean: float, cages: int
) -> None:
    """The hull, and one or two cages before or after it."""
    scene, start = body_impact(lean)
    flown = models.fly(scene, start, until=DURATION, impact_step=STEP)
    record, ours = flown.record, models.start_of(flown.motion.state)
    theirs = engine.fly(scene, start, until=DURATION, step=STEP)

    assert record.contacts.hull[0] > 0.0
    assert sum(count > 0 for count in record.contacts.arms) == cages
    assert np.abs(ours.position - theirs.end.position).max() < POSITION
    assert np.abs(ours.rotation - theirs.end.rotation).max() < ATTITUDE
    assert np.abs(ours.lengths - theirs.end.lengths).max() < POSITION
    assert record.peaks.acceleration == pytest.approx(theirs.peak_acceleration, rel=PEAK)
