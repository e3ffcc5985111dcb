"""A ring that turns about its axis: beside two formulations, in limits, and in flight."""

from __future__ import annotations

import importlib
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from builders.shells import MEETINGS, SURFACES, in_a_wall, obstacles_around, struck
from oracles.models import random_inertia, unit_vector, vec
from springback.batch.scenarios import fly_scenarios
from springback.dynamics.energy import angular_momentum, energy
from springback.dynamics.motion import rates
from springback.errors import InputError
from springback.kernels.trees import axpy
from springback.results.flight import Flight, as_scenario, fly
from springback.simulation.measuring.record import Model
from springback.vehicle.state import Shell, Sphere, State

RADIUS, RING_MASS = 0.2, 0.08
INERTIA = RING_MASS * RADIUS**2
STATES = 20
Array = np.ndarray[Any, np.dtype[np.float64]]
OBSTACLES = obstacles_around(1.0)


def tables(
    bearing: dict[str, Any] | None = None,
    law: str = "hunt-crossley",
    obstacle: str = "wall",
    hull: dict[str, Any] | None = None,
    **more: Any,
) -> dict[str, Any]:
    """A hit in the plane of the ring, at 2 m/s and 1 m/s along a wall, from the touch on."""
    ring = {"type": "ring", "radius": RADIUS, "bearing": bearing, **(hull or {})}
    return {
        "vehicle": {"preset": "caged-sphere", "hulls": [ring]},
        "world": {"gravity": 0, "obstacles": [{**OBSTACLES[obstacle], "surface": SURFACES[law]}]},
        "start": {"position": [0, 0, 1], "velocity": [2.0, 1.0, 0.0], "touch_distance": 1e-4},
        "simulation": {"duration": 0.02},
        **more,
    }


def bearing(**more: float) -> dict[str, Any]:
    return {"ring_mass": RING_MASS, **more}


@pytest.fixture(scope="module")
def oracle() -> ModuleType:
    """Of two bodies, in MuJoCo and by hand."""
    pytest.importorskip("mujoco")
    return importlib.import_module("oracles.ring_bodies")


@pytest.fixture(scope="module")
def pinocchio() -> ModuleType:
    """The same in Pinocchio, with a bearing that is dry, too."""
    pytest.importorskip("mujoco")
    pytest.importorskip("pinocchio")
    return importlib.import_module("oracles.bearings_pinocchio")


# -- instants --------------------------------------------------------------------------------------


def drawn(seed: int, friction: float = 0.0) -> tuple[Model, State, Any]:
    """A random craft some millimetres in a random wall, its tilted ring off the centre, turning.

    What touches is a sphere, so that the force is at any place around the ring.
    """
    oracle = importlib.import_module("oracles.ring_bodies")
    rng = np.random.default_rng([43, seed])
    centre, axis = rng.uniform(-0.05, 0.05, size=3), unit_vector(rng)
    damping = rng.uniform(0.0, 5e-3)
    at = vec(centre)
    shell = Shell(Sphere(at, RADIUS), at, RADIUS, INERTIA, damping, friction, (vec(axis),))
    alone = 2.0 * random_inertia(rng) + 0.01 * np.eye(3)
    mass = as_scenario(tables()).vehicle.mass - RING_MASS
    craft = oracle.RingCraft(mass, alone, RING_MASS, RADIUS, centre, axis, damping)
    attitude = Rotation.random(random_state=rng).as_quat(scalar_first=True)
    pose = oracle.RingPose(
        attitude, rng.uniform(-3, 3, size=3), rng.uniform(-10, 10, size=3), rng.uniform(-40, 40)
    )
    into = unit_vector(rng)
    depth = rng.uniform(1e-3, 5e-3)
    model, state = in_a_wall(
        tables(), shell, craft, pose, pose.spin * (pose.rotation @ axis), into, depth
    )
    return model, state, (craft, pose, into)


def test_accelerations_are_those_of_two_bodies(oracle: ModuleType) -> None:
    """MuJoCo's hinge, and Newton and Euler for each body: the contact force at its point does all."""
    pressed = 0
    for seed in range(STATES):
        model, state, (craft, pose, into) = drawn(seed)
        found = rates(model, state, 1.0)
        ours = found.motion.state
        force = np.array(found.seen.contact_force)
        point = pose.rotation @ craft.centre + RADIUS * into
        pressed += bool(np.abs(force).max() > 1.0)
        axis = pose.rotation @ craft.axis
        swing = pose.spin * np.cross(pose.rotation @ pose.omega, axis)
        for theirs in (oracle.in_mujoco, oracle.by_joint_forces):
            there = theirs(craft, pose, force, point)
            for mine, other in (
                (ours.velocity, there.linear),
                (ours.angular_velocity, there.angular),
                (ours.memory.hull[0].spin[0], there.spin * axis + swing),
            ):
                scale = max(1.0, np.abs(other).max())
                assert np.abs(np.array(mine) - other).max() < 1e-11 * scale
    assert pressed > STATES / 2


def test_accelerations_are_those_of_pinocchio(pinocchio: ModuleType) -> None:
    """A revolute joint with viscous and dry friction.  Measured: 3e-14."""
    pressed, worst = 0, 0.0
    for seed in range(100):
        model, state, (craft, pose, into) = drawn(seed, friction=2e-3)
        found = rates(model, state, 1.0)
        ours = found.motion.state
        force = np.array(found.seen.contact_force)
        point = pose.rotation @ craft.centre + RADIUS * into
        pressed += bool(np.abs(force).max() > 1.0)
        axis = pose.rotation @ craft.axis
        swing = pose.spin * np.cross(pose.rotation @ pose.omega, axis)
        there = pinocchio.InPinocchio(craft, 2e-3).accelerations(pose, force, point)
        for mine, other in (
            (ours.velocity, there.linear),
            (ours.angular_velocity, there.angular),
            (ours.memory.hull[0].spin[0], there.spin * axis + swing),
        ):
            apart = np.abs(np.array(mine) - other).max()
            worst = max(worst, apart / max(1.0, np.abs(other).max()))
    assert pressed > 50
    assert worst < 1e-12


def test_power_balances_at_every_instant() -> None:
    """Ė = −losses, with bearings that are viscous and dry."""
    for seed in range(STATES):
        model, state, _ = drawn(seed, friction=2e-3)
        known = rates(model, state, 1.0).motion
        h = 5e-7
        e = [
            energy(model.airframe, model.world, model.contact_point, there).total
            for there in (axpy(state, known.state, h * way) for way in (1, -1, 2, -2))
        ]
        change = (8.0 * (e[0] - e[1]) - (e[2] - e[3])) / (12.0 * h)
        losses = known.work.contact + known.work.friction
        assert abs(change + losses) < 1e-8 * max(1.0, abs(change), losses)
        assert known.work.friction > 0.0


def test_away_from_walls_angular_momentum_stays() -> None:
    """The bearing, and the ring's resistance to being tilted, only pass it on."""
    for seed in range(STATES):
        model, state, _ = drawn(seed, friction=2e-3)
        far = model.world.obstacles[0]
        far = far._replace(shape=far.shape._replace(offset=-100.0))
        apart = model._replace(world=model.world._replace(obstacles=(far,)))
        known = rates(apart, state, 1.0).motion.state
        assert not any(rates(apart, state, 1.0).seen.contact_force)
        h = 1e-6
        first, second = (
            np.array(angular_momentum(apart.airframe, axpy(state, known, h * way)))
            for way in (-1, 1)
        )
        assert np.abs(known.memory.hull[0].spin[0]).max() > 1e-3
        assert np.abs(second - first).max() / (2.0 * h) < 1e-8


def test_impulses_are_those_of_two_bodies(oracle: ModuleType) -> None:
    """The impulse at its point, within the friction cone, is all that body and ring feel."""
    struck_at_all, sticks = 0, [0, 0]
    for seed in range(4 * STATES):
        model, state, (craft, pose, into) = drawn(seed, friction=2e-3)
        r, point = pose.rotation, pose.rotation @ craft.centre + RADIUS * into
        axis = r @ craft.axis

        def second(
            force: Array, craft: Any = craft, pose: Any = pose, point: Array = point,
            axis: Array = axis,
        ) -> tuple[Array, ...]:  # fmt: skip
            there = oracle.by_joint_forces(craft, pose, force, point)
            return there.linear, there.angular, there.spin * axis

        def speed(
            *of: Array, r: Array = r, craft: Any = craft, into: Array = into, axis: Array = axis
        ) -> Array:
            v, omega, spin = of
            whole = r @ omega + axis * (axis @ (spin - r @ omega))
            moves: Array = (
                v + np.cross(r @ omega, r @ craft.centre) + np.cross(whole, RADIUS * into)
            )
            return moves

        now = (pose.velocity, pose.omega, pose.spin * axis)
        if speed(*now) @ into < 0.1:
            continue
        hit = struck(model, state, (0.05, 0.5)[seed % 2], second)
        then = speed(*(a + b for a, b in zip(now, hit.found, strict=True)))
        struck_at_all += 1
        sticks[seed % 2] += hit.check(into, speed(*now), then)
    assert struck_at_all > STATES
    assert sticks[0] < 10 < sticks[1], sticks


# -- flights ---------------------------------------------------------------------------------------


def flown(*arguments: Any, **named: Any) -> Flight:
    return fly(tables(*arguments, **named), executor="python")


def end(flight: Flight, *names: str) -> np.ndarray[Any, np.dtype[np.float64]]:
    return np.array([flight.columns[name][-1] for name in names])


def test_a_free_ring_takes_all_of_a_hit_in_its_plane() -> None:
    """The body does not turn at all; friction with the wall makes the ring roll there.

    A point on it yields to a tangential impulse by 1/m + R²/I_s, so that the ring rolls at the end
    with a share 1 − (1/m)/(1/m + R²/I_s) of the velocity along the wall.
    """
    flight = flown(bearing())
    assert np.abs(end(flight, "wx", "wy", "wz")).max() == 0.0
    m = as_scenario(tables()).vehicle.mass
    share = 1.0 - (1.0 / m) / (1.0 / m + RADIUS**2 / INERTIA)
    along = end(flight, "vy")[0]
    assert along == pytest.approx(share, rel=2e-3)
    spin = end(flight, "shell_wx", "shell_wy", "shell_wz")
    assert np.abs(spin[:2]).max() == 0.0
    assert spin[2] == pytest.approx(-along / RADIUS, rel=0.02)
    assert abs(flight.measures["ledger_residual"] or 0.0) < 1e-6


def test_a_bearing_that_holds_makes_it_a_fixed_ring() -> None:
    """As damping grows, the same body without a bearing; the way there goes as 1/b at least."""
    there = end(flown(None, hull={"axis": [0.2, 0.1, 1.0]}), "wx", "wy", "wz")
    apart = [
        np.abs(
            end(flown(bearing(damping=b), hull={"axis": [0.2, 0.1, 1.0]}), "wx", "wy", "wz") - there
        ).max()
        for b in (5.0, 50.0)
    ]
    assert np.abs(there).max() > 1.0
    assert apart[1] < 0.02 * np.abs(there).max()
    assert apart[0] / apart[1] > 8.0


@pytest.mark.parametrize(("law", "obstacle"), MEETINGS)
def test_every_law_and_obstacle_flies(law: str, obstacle: str) -> None:
    """A tilted ring off the centre, with a bearing viscous and dry; what the ledger leaves open."""
    flight = flown(
        bearing(damping=1e-3, friction=2e-3), law, obstacle,
        {"position": [0.01, 0.0, 0.02], "axis": [0.15, -0.1, 1.0]},
        simulation={"duration": 0.004},
    )  # fmt: skip
    assert flight.measures["contacts"] == 1.0
    assert abs(flight.measures["ledger_residual"] or 0.0) < 2e-6
    spin = end(flight, "shell_wx", "shell_wy", "shell_wz")
    assert np.abs(spin).max() > 0.1


@pytest.mark.parametrize(
    "change",
    [
        {"model": {"slider": [1, 0, 0]}, "start.velocity": [2, 0, 0]},
        {"vehicle.arms": {"compliant": True, "mass": 0.02, "neighbours": {"stiffness": 500}}},
        {"model": {"contact_point": "paper"}},
        {"reference": {"type": "hold"}, "start.touch_distance": None, "start.position": [0.795, 0, 1],
         "world.gravity": 9.81},
        {"vehicle.hulls.0.surface": {"stiffness": 1e4, "friction": 0.6}},
        {"air": {"wind": [1, 0, 0], "body_drag": 0.1}},
        {"payload": {"mass": 0.2, "inertia": [1e-3, 1e-3, 1e-3]}},
    ],
    ids=["slider", "arms", "paper's point", "pilot", "own surface", "wind", "payload"],
)  # fmt: skip
def test_it_flies_with_what_else_there_is(change: dict[str, Any]) -> None:
    """Guides, arms within the ring, a pilot, a surface of its own, wind, a payload."""
    given = tables(bearing(damping=1e-3, friction=1e-3), simulation={"duration": 0.003})
    for path, value in change.items():
        *outer, last = path.split(".")
        table: Any = given
        for key in outer:
            table = table[int(key) if key.isdigit() else key]
        table[last] = value
    m = fly(given, executor="python", trajectory=False).measures
    assert m["contacts"] == 1.0
    assert abs(m["ledger_residual"] or 0.0) < 1e-6


def test_compiled_and_in_a_campaigns_lanes_it_is_the_same_flight() -> None:
    """Bit for bit what plain Python flies, with a number that differs in each row."""
    rows = [
        tables(bearing(damping=1e-4 * (k + 1), friction=1e-3), simulation={"duration": 0.006})
        for k in range(9)
    ]
    together = fly_scenarios(rows, threads=1).measures
    for k in (0, 5):
        plain = fly(rows[k], executor="python", trajectory=False).measures
        assert fly(rows[k], trajectory=False).measures == plain
        for name in ("impact_peak_acceleration", "loss_friction", "ledger_residual"):
            assert together[name][k] == plain[name], name


# -- wrong input -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"hull": {"on": 1}}, "vehicle.hulls[0].bearing: needs a ring on the body"),
        ({"bearing": {"ring_mass": 3}}, "ring_mass: must be less than the mass of the body, 2.336"),
        (
            {"bearing": {"ring_mass": 1.0}},
            "ring_mass: must be less than 0.7 kg: a ring of 0.2 m of that mass has all of",
        ),
        ({"bearing": {"ring_mass": 0}}, "ring_mass: must be more than 0 kg"),
        ({"bearing": {"ring_mass": 0.1, "friction": "2 N"}}, "friction: has the wrong unit"),
        ({"hull": {"type": "sphere"}}, "vehicle.hulls[0].bearing: unknown"),
    ],
    ids=["arm", "heavy", "no inertia left", "massless", "unit", "sphere"],
)
def test_wrong_bearings_are_refused(change: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError) as caught:
        as_scenario(tables(**{"bearing": bearing(), **change}))
    assert any(message in line for line in caught.value.problems), caught.value.problems


def test_what_a_turning_ring_cannot_be_combined_with_is_said() -> None:
    crowded = tables(bearing())
    crowded["vehicle"]["hulls"].append({"type": "sphere", "radius": 0.05})
    for given, message in (
        (crowded, "vehicle.hulls[0].bearing: needs a ring that is the only hull of the main"),
    ):
        with pytest.raises(InputError) as caught:
            as_scenario(given)
        assert any(message in line for line in caught.value.problems), caught.value.problems


def test_a_ring_that_spins_at_the_start_resists_being_tilted() -> None:
    """In ideal bearings it keeps its spin about its axis, and gives the body its gyroscopic moment.

    With the ring at s about z and the body turning about x: I_y ω̇_y = I_s s ω_x at first.
    """
    spin, turn, inertia = 200.0, 0.1, [0.017, 0.018, 0.028]
    given = tables(bearing(), world={"gravity": 0, "obstacles": []})
    given["start"] = {"position": [0, 0, 1], "shell_spin": [0, 0, spin],
                      "angular_velocity": [turn, 0, 0]}  # fmt: skip
    flight = fly(given | {"simulation": {"duration": 0.004}}, executor="python")
    along = np.linalg.norm([flight.columns[f"shell_w{axis}"] for axis in "xyz"], axis=0)
    assert np.abs(along - spin).max() < 1e-6
    nutation = INERTIA * spin / np.sqrt(inertia[0] * inertia[1])  # rad/s, of a fast symmetric top
    expected = turn * np.sqrt(inertia[0] / inertia[1]) * np.sin(nutation * flight.t[-1])
    assert end(flight, "wy")[0] == pytest.approx(expected, rel=2e-2)


def test_a_spin_across_the_axis_is_refused() -> None:
    given = tables(bearing())
    given["start"] |= {"shell_spin": [0, 1.0, 1.0]}
    with pytest.raises(InputError, match=r"start\.shell_spin: must be along the ring's axis"):
        as_scenario(given)
