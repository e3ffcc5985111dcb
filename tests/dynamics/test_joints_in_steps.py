"""What steps need to know of arms on joints: accelerations at their ends, bounds, settling."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from builders.joint_crafts import BODY, JOINTS, at_wall, drawn, model_of, state_of
from oracles import models
from springback.contact.hull_contact import body_sight
from springback.contact.laws.memory import arm_memory
from springback.dynamics.limbs.arms import ArmMotion, Surroundings, acceleration_at_end, arm_state
from springback.dynamics.motion import rates
from springback.dynamics.touches import BodyAcceleration
from springback.results.flight import as_scenario
from springback.simulation.flight import fly_one
from springback.simulation.measuring.record import FREE_FLIGHT

STATES = 25
joints = pytest.mark.parametrize("name", JOINTS)


@joints
def test_what_is_at_the_end_accelerates_as_one_body(name: str) -> None:
    """Any point of it: main body, angular acceleration and joint, from rest.  Measured: 2e-15."""
    for seed in range(STATES):
        craft, pose = drawn(name, seed)
        rng = np.random.default_rng([35, seed])
        model, state = model_of(craft), state_of(craft, pose)
        a, alpha, up, at = rng.uniform(-9.0, 9.0, size=(4, 3))
        for j, (limb, c) in enumerate(nonempty(zip(craft.limbs, pose.bends, strict=True))):
            second, turn = rng.uniform(-50.0, 50.0), limb.turn(c)
            point = limb.place(c) + turn @ at
            swing = limb.axis if limb.kind == "slide" else np.cross(limb.axis, point - limb.point)
            expected = turn.T @ (a + np.cross(alpha, point) + second * swing)
            moves = ArmMotion(state.arm_length[j], 0.0, -limb.radius * second)
            body = BodyAcceleration(models.vec(a), models.vec(alpha), models.vec(up))
            found = acceleration_at_end(model.airframe.arms[j], moves, body)
            there = np.array(found.linear) + np.cross(found.angular, turn.T @ point)
            np.testing.assert_allclose(there, expected, rtol=0, atol=1e-11)
            np.testing.assert_allclose(found.vertical, turn.T @ up, rtol=0, atol=1e-13)


@joints
def test_contacts_are_springs_along_the_path(name: str) -> None:
    """Stiffness and damper by the square of the depth's derivative; friction by what is across."""
    seen = 0
    for seed in range(STATES):
        craft, pose = drawn(name, seed)
        scene = replace(at_wall(craft, pose, seed), rounding=0.0)
        model, state = model_of(craft, scene), state_of(craft, pose)
        around = Surroundings(
            body_sight(model.world.obstacles, state, 0.0), model.contact_point, 1.0
        )
        memory = arm_memory(state.memory, model.airframe.arms)
        into, r = -scene.wall.normal, pose.rotation
        for j, (arm, limb) in enumerate(zip(model.airframe.arms, craft.limbs, strict=True)):
            length, rate, c = state.arm_length[j], state.arm_rate[j], pose.bends[j]
            known = arm_state(arm, length, rate, limb.thrust, (1.0,), (), (), memory[j], around)
            if known.share.contact.press.stiffness == 0.0:
                continue
            seen += 1
            axes, inward = limb.turn(c), r.T @ into
            flat = axes.T @ inward * [1.0, 1.0, 0.0]
            point = limb.place(c) + axes @ flat * (limb.cage_radius / np.linalg.norm(flat))
            swing = limb.axis if limb.kind == "slide" else np.cross(limb.axis, point - limb.point)
            moves = swing / limb.radius
            along = (moves @ inward) ** 2
            press, slides = known.share.contact.press, known.slide
            assert slides.spring == pytest.approx(press.stiffness * along / limb.mass, rel=1e-9)
            assert slides.damper == pytest.approx(press.damper * along / limb.mass, rel=1e-9)
            grip = known.share.grip.alone * (moves @ moves - along) / limb.mass
            assert known.grip.any_way == pytest.approx(grip, rel=1e-9)
    assert seen >= STATES / 2


SPRINGS: dict[str, dict[str, Any]] = {
    "linear": {"stiffness": "5 N/mm"},
    "quadratic": {"quadratic": 4e5},
    "a table": {"table": [[0.0, 0.0], ["10 mm", 50.0], ["20 mm", 150.0]]},
}


@pytest.mark.parametrize("spring", SPRINGS)
def test_arms_that_come_to_rest_are_locked_again(spring: str) -> None:
    """Bent by 1 mm and damped, they settle within 0.4 s, whatever tells the force."""
    joint = {"type": "slide", "direction": [-1, 0, 1], "travel": ["0 mm", "20 mm"], "damping": 30.0}
    arms = {
        "directions": ["45 deg", "135 deg", "-135 deg", "-45 deg"], "length": 0.19, "mass": 0.05,
        "cage_radius": 0.11, "joint": {**joint, **SPRINGS[spring]},
    }  # fmt: skip
    world = {"obstacles": [{"type": "wall", "distance": 5.0, "surface": "wall"}]}
    scenario = {"vehicle": {"body": BODY, "arms": arms}, "world": world}
    built = as_scenario({**scenario, "simulation": {"duration": 0.4}}, (), False).build()
    bent = built.start._replace(arm_length=(0.19 - 1e-3,) * 4)
    assert rates(built.model, bent, 1.0).seen.arms[0].compression == pytest.approx(1e-3)
    flight = fly_one(built.model, bent, trace=False, executor="python")
    assert flight.record.stepping.phase == FREE_FLIGHT
    assert flight.motion.work.settling > 0.0
