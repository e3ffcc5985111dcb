"""Impacts on poles, spheres, boxes and edges beside MuJoCo, with the forces applied by formula.

MuJoCo integrates the main body and its four sliding arms; what acts on them is written down once more
in `oracles.loads` and `oracles.solid_loads`, whose distances share nothing with the package's.  Both
take small steps: what is left are instants of touch, on which the package's steps land.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from oracles import models
from oracles.solid_loads import in_front
from springback.contact.moving.parameters import ConstantMotion, SineMotion
from springback.contact.parameters import SurfaceSettings
from springback.contact.shapes import Ball, Box, Capsule, Edge, Pole

pytest.importorskip("mujoco")
from oracles import mujoco_flight  # only where the engine is

STEP, DURATION = 5e-5, 0.02
#: Way to the touch, some 2 ms [m].
GAP = 5e-3
#: A hundredth of the promise, 0.1 mm [m], and what that turns an arm of 0.3 m by [rad].
POSITION, ATTITUDE = 1e-6, 1e-5
#: Half of the promise, of the peak: it is read at steps that do not coincide.
PEAK = 5e-4
#: Where a ring dips through a face at two places, the damper of the second one appears at once as the
#: way between them comes out of the face; the peak is the jump's upper end, which falls by 1 % within
#: 0.1 ms, and no step of the engine lands on it.  State by state both agree there, too.
JUMPS = {"capped pole from above": 5e-3}
#: State by state: a minimum that is found to 1e-8 rad has a normal to 1e-6 on an edge of 1 mm.
RELATIVE = 1e-5

RUBBER = SurfaceSettings(stiffness=1e5, dissipation=0.3, friction=0.8, slip_speed=0.1)
SLICK = SurfaceSettings(stiffness=1e5, dissipation=0.3, friction=0.3, slip_speed=0.05)
NOWHERE = models.Wall(np.array([0.0, 0.0, 1.0]), -1e3)

SHAPES: dict[str, Any] = {
    "pole": Pole(type="pole", position=(0.34, 0.16, 0.0), radius=0.05, surface=RUBBER),
    "thin pole, inclined": Pole(
        type="pole", position=(0.31, 0.1, 0.0), axis=(0.3, -0.4, 1.0), radius=0.015, surface=RUBBER
    ),
    "pole, glancing": Pole(type="pole", position=(0.1, 0.325, 0.0), radius=0.08, surface=RUBBER),
    "capped pole from above": Pole(
        type="pole", position=(0.36, 0.02, -0.9), radius=0.1, height=0.84, edge_radius=0.01,
        surface=RUBBER,
    ),
    "sphere": Ball(type="sphere", position=(0.40, -0.05, 0.05), radius=0.15, surface=SLICK),
    "small sphere": Ball(type="sphere", position=(0.29, 0.14, -0.02), radius=0.03, surface=RUBBER),
    "box, corner first": Box(
        type="box", position=(0.5, 0.12, 0.0), size=(0.3, 0.3, 0.3), roll=0.5, pitch=0.6, yaw=0.7,
        edge_radius=0.01, surface=RUBBER,
    ),
    "box, face": Box(
        type="box", position=(0.5, 0.12, 0.0), size=(0.3, 0.6, 0.6), yaw=0.2, surface=SLICK
    ),
    "edge": Edge(type="edge", position=(0.29, 0.12, 0.0), yaw=0.1, pitch=0.2, surface=RUBBER),
    "rail": Capsule(
        type="capsule", start=(0.32, -0.6, 0.06), end=(0.30, 0.6, -0.02), radius=0.02, surface=SLICK
    ),
}  # fmt: skip


def impact(
    name: str, contact: str = "ring", hull: models.Ball | None = None
) -> tuple[models.Scene, models.Start]:
    """An oblique, spinning hit of the compliant vehicle at some 2.5 m/s, rotors on."""
    products = np.array([[0.0, 3e-4, -5e-4], [3e-4, 0.0, 4e-4], [-5e-4, 4e-4, 0.0]])
    craft = models.compliant_craft()
    craft = replace(craft, inertia=craft.inertia + products, hull=hull)
    start = models.Start(
        position=np.zeros(3),
        attitude=models.quaternion(0.15, -0.2, 0.1),
        velocity=np.array([2.4, 0.5, -0.3]),
        omega=np.array([1.5, -3.0, 4.0]),
        lengths=np.full(4, 0.19),
        rates=np.zeros(4),
    )
    solid = models.Solid(SHAPES[name])
    thrust = (5.0, 6.0, 4.5, 5.5)
    scene = models.Scene(craft, NOWHERE, thrust, contact=contact, solids=(solid,))  # type: ignore[arg-type]
    return scene, in_front(solid, start, craft, GAP)


def agree(scene: models.Scene, start: models.Start, peak: float = PEAK) -> Any:
    """Both flights; places, attitudes, arms and peaks agree."""
    flown = models.fly(scene, start, until=DURATION, impact_step=STEP)
    record, ours = flown.record, models.start_of(flown.motion.state)
    theirs = mujoco_flight.fly(scene, start, until=DURATION, step=STEP)
    assert record.peaks.acceleration > 20.0
    assert np.abs(ours.position - theirs.end.position).max() < POSITION
    assert np.abs(ours.rotation - theirs.end.rotation).max() < ATTITUDE
    assert np.abs(ours.lengths - theirs.end.lengths).max() < POSITION
    assert record.peaks.acceleration == pytest.approx(theirs.peak_acceleration, rel=peak)
    return record


@pytest.mark.parametrize("name", SHAPES)
def test_accelerations_are_those_of_the_engine(name: str) -> None:
    """v̇, ω̇ and l̈ at random states up to 12 mm deep, run by Python."""
    scene, before = impact(name)
    vehicle = mujoco_flight.Vehicle(scene.craft, scene.gravity)
    free = models.accelerations_of(replace(scene, solids=()), before)
    rng, touched = np.random.default_rng(11), 0
    for _ in range(8):
        way = (GAP + rng.uniform(0.0, 0.012)) * before.velocity / np.linalg.norm(before.velocity)
        now = replace(
            before,
            position=before.position + way,
            velocity=before.velocity + rng.uniform(-2.0, 2.0, size=3),
            omega=rng.uniform(-8.0, 8.0, size=3),
            rates=rng.uniform(-0.5, 0.5, size=4),
        )
        ours, theirs = models.accelerations_of(scene, now), vehicle.accelerations(scene, now)
        for a, b in zip(ours, theirs, strict=True):
            assert np.abs(a - b).max() < RELATIVE * max(1.0, np.abs(b).max())
        touched += bool(np.abs(ours.linear - free.linear).max() > 1.0)
    assert touched >= 3


@pytest.mark.parametrize("name", SHAPES)
def test_impacts_on_shapes_are_those_of_the_engine(name: str) -> None:
    """From before the touch, mostly until after the separation: compliant arms, friction, spin."""
    record = agree(*impact(name), peak=JUMPS.get(name, PEAK))
    assert sum(count > 0 for count in record.contacts.arms) >= 1
    assert record.first_impact.touch_time > 0.0


def test_the_papers_contact_point_meets_a_pole_as_in_the_engine() -> None:
    """Eq. (13) beside a pole ahead of an arm: its normal force acts at the tip, friction at the end."""
    scene, start = impact("pole", "tip")
    pole = Pole(type="pole", position=(0.34, 0.07, 0.0), radius=0.05, surface=RUBBER)
    solid, start = models.Solid(pole), replace(start, attitude=models.quaternion(0.15, -0.2, -0.65))
    start = in_front(solid, start, scene.craft, GAP)
    record = agree(replace(scene, solids=(solid,)), start)
    assert record.contacts.arms[0] == 1.0


def test_the_main_body_meets_a_sphere_as_in_the_engine() -> None:
    """Belly first, beside the cages."""
    scene, start = impact("sphere", hull=models.Ball(np.array([0.004, -0.003, 0.01]), 0.06))
    start = replace(start, attitude=models.quaternion(0.1, 0.5 * math.pi - 0.2, 0.0))
    ball = Ball(type="sphere", position=(0.22, 0.0, 0.0), radius=0.1, surface=SLICK)
    solid = models.Solid(ball)
    start = in_front(solid, start, scene.craft, GAP)
    record = agree(replace(scene, solids=(solid,)), start)
    assert record.contacts.hull[0] > 0.0


def test_locked_arms_meet_an_edge_as_in_the_engine() -> None:
    """A rigid vehicle is one whose springs are a thousand times as stiff: here, against an edge."""
    scene, start = impact("edge")
    craft = replace(
        scene.craft,
        arms=tuple(replace(arm, stiffness=5e4, damping=900.0) for arm in scene.craft.arms),
    )
    agree(replace(scene, craft=craft), start)


# -- shapes that move ------------------------------------------------------------------------------


class Given(NamedTuple):
    """A prescribed motion by the tests' own formulas: a displacement and an angle about an axis."""

    about: tuple[float, float, float]
    axis: tuple[float, float, float]
    place: Callable[[float], tuple[Any, Any]]  # displacement [m] and its rate [m/s]
    angle: Callable[[float], tuple[float, float]]  # [rad] and its rate [rad/s]

    def __call__(self, time: float) -> models.Placed:
        """Where the shape is."""
        (moved, velocity), (angle, rate) = self.place(time), self.angle(time)
        axis = np.array(self.axis) / np.linalg.norm(self.axis)
        turn = Rotation.from_rotvec(angle * axis).as_matrix()
        lever = -turn @ np.array(self.about)
        position = np.array(self.about) + moved + lever
        return models.Placed(
            position, turn, velocity + np.cross(rate * axis, lever), rate * axis
        )  # fmt: skip


PUSH = np.array([-0.6, 0.2, 0.1])
SWING, OFTEN = np.array([0.004, 0.0, 0.0]), 2.0 * math.pi * 12.0
MOVING: dict[str, tuple[Any, Given]] = {
    "box that comes and turns": (
        SHAPES["box, corner first"].model_copy(
            update={
                "motion": ConstantMotion(
                    type="constant", velocity=tuple(PUSH), turning=2.5, axis=(1.0, -1.0, 2.0)
                )
            }
        ),
        Given(
            (0.5, 0.12, 0.0), (1.0, -1.0, 2.0), lambda t: (PUSH * t, PUSH), lambda t: (2.5 * t, 2.5)
        ),
    ),
    "ball that swings": (
        SHAPES["sphere"].model_copy(
            update={
                "motion": SineMotion(
                    type="sine", amplitude=tuple(SWING), swing=0.3, frequency=12.0, phase=0.4
                )
            }
        ),
        Given(
            (0.40, -0.05, 0.05), (0.0, 0.0, 1.0),
            lambda t: (SWING * math.sin(OFTEN * t + 0.4), SWING * OFTEN * math.cos(OFTEN * t + 0.4)),
            lambda t: (0.3 * math.sin(OFTEN * t + 0.4), 0.3 * OFTEN * math.cos(OFTEN * t + 0.4)),
        ),
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", MOVING)
def test_impacts_on_shapes_that_move_are_those_of_the_engine(name: str) -> None:
    """Gaps, dampers and friction by the velocity relative to the surface."""
    shape, motion = MOVING[name]
    scene, start = impact("box, corner first" if "box" in name else "sphere")
    # With friction, so that the surface's own velocity along itself counts.
    shape = shape.model_copy(update={"surface": RUBBER})
    record = agree(replace(scene, solids=(models.Solid(shape, motion),)), start)
    assert sum(count > 0 for count in record.contacts.arms) >= 1
    still = models.fly(scene, start, until=DURATION, impact_step=STEP)
    assert abs(still.record.peaks.acceleration - record.peaks.acceleration) > 1.0
