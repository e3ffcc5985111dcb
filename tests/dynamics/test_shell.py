"""A shell that turns by itself in a gimbal: beside two formulations, in limits, and in flight."""

from __future__ import annotations

import importlib
import math
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from builders.shells import MEETINGS, SURFACES, in_a_wall, obstacles_around, struck
from oracles.models import random_inertia, unit_vector, vec
from springback.batch.scenarios import fly_scenarios
from springback.dynamics.energy import angular_momentum, energy
from springback.dynamics.limbs.shell import BEARING_SLIP
from springback.dynamics.motion import rates
from springback.errors import InputError
from springback.kernels.trees import axpy, names
from springback.results.flight import Flight, as_scenario, fly
from springback.results.pair.flying import in_a_scene, law_between
from springback.simulation.flight import model_state
from springback.simulation.measuring.record import Model
from springback.simulation.pair.flying import PairedFlight, beside_each_other
from springback.simulation.pair.solids import solids_of
from springback.simulation.playback import memory_columns
from springback.vehicle.state import Shell, Sphere, State

RADIUS, SHELL_MASS = 0.2, 0.15
INERTIA = 2.0 / 3.0 * SHELL_MASS * RADIUS**2
STATES = 20
Array = np.ndarray[Any, np.dtype[np.float64]]
OBSTACLES = obstacles_around(1.25)


def tables(
    gimbal: dict[str, Any] | None = None,
    law: str = "hunt-crossley",
    obstacle: str = "wall",
    hull: dict[str, Any] | None = None,
    **more: Any,
) -> dict[str, Any]:
    """An oblique hit at 2.3 m/s, from the touch on."""
    ball = {"type": "sphere", "radius": RADIUS, "gimbal": gimbal, **(hull or {})}
    return {
        "vehicle": {"preset": "caged-sphere", "hulls": [ball]},
        "world": {"gravity": 0, "obstacles": [{**OBSTACLES[obstacle], "surface": SURFACES[law]}]},
        "start": {
            "position": [0, 0, 1], "velocity": [2.0, 1.0, 0.5], "pitch": 0.2, "roll": 0.1,
            "touch_distance": 1e-4,
        },
        "simulation": {"duration": 0.02},
        **more,
    }  # fmt: skip


def gimbal(**more: float) -> dict[str, Any]:
    return {"shell_mass": SHELL_MASS, **more}


@pytest.fixture(scope="module")
def oracle() -> ModuleType:
    """Of two bodies, in MuJoCo and by hand."""
    pytest.importorskip("mujoco")
    return importlib.import_module("oracles.shell_mujoco")


@pytest.fixture(scope="module")
def pinocchio() -> ModuleType:
    """The same in Pinocchio, with bearings that are dry, too."""
    pytest.importorskip("mujoco")
    pytest.importorskip("pinocchio")
    return importlib.import_module("oracles.bearings_pinocchio")


# -- instants --------------------------------------------------------------------------------------


def drawn(seed: int, friction: float = 0.0) -> tuple[Model, State, Any]:
    """A random craft some millimetres in a random wall, its shell off the centre and spinning."""
    oracle = importlib.import_module("oracles.shell_mujoco")
    rng = np.random.default_rng([41, seed])
    centre = rng.uniform(-0.05, 0.05, size=3)
    damping = rng.uniform(0.0, 5e-3)
    at = vec(centre)
    shell = Shell(Sphere(at, RADIUS), at, RADIUS, INERTIA, damping, friction)
    alone = 2.0 * random_inertia(rng) + 0.01 * np.eye(3)
    mass = as_scenario(tables()).vehicle.mass - SHELL_MASS
    craft = oracle.ShellCraft(mass, alone, SHELL_MASS, INERTIA, centre, damping, 9.81)
    attitude = Rotation.random(random_state=rng).as_quat(scalar_first=True)
    pose = oracle.ShellPose(
        attitude, rng.uniform(-3, 3, size=3), rng.uniform(-10, 10, size=3),
        rng.uniform(-20, 20, size=3),
    )  # fmt: skip
    into = unit_vector(rng)
    depth = rng.uniform(1e-3, 5e-3)
    model, state = in_a_wall(tables(), shell, craft, pose, pose.spin, into, depth)
    return model, state, (craft, pose, into)


def test_accelerations_are_those_of_two_bodies(oracle: ModuleType) -> None:
    """MuJoCo's ball joint, and the balance of momenta: the contact force at its point does all."""
    pressed = 0
    for seed in range(STATES):
        model, state, (craft, pose, into) = drawn(seed)
        found = rates(model, state, 1.0)
        ours = found.motion.state
        force = np.array(found.seen.contact_force)
        point = pose.rotation @ craft.centre + RADIUS * into
        pressed += bool(np.abs(force).max() > 1.0)
        for theirs in (oracle.in_mujoco, oracle.by_momenta):
            there = theirs(craft, pose, force, point)
            for mine, other in (
                (ours.velocity, there.linear),
                (ours.angular_velocity, there.angular),
                (ours.memory.hull[0].spin[0], there.spin),
            ):
                scale = max(1.0, np.abs(other).max())
                assert np.abs(np.array(mine) - other).max() < 1e-11 * scale
    assert pressed > STATES / 2


def test_accelerations_are_those_of_pinocchio(pinocchio: ModuleType) -> None:
    """A spherical joint with viscous and dry friction.  Measured: 3e-14."""
    pressed, worst = 0, 0.0
    for seed in range(100):
        model, state, (craft, pose, into) = drawn(seed, friction=2e-3)
        found = rates(model, state, 1.0)
        ours = found.motion.state
        force = np.array(found.seen.contact_force)
        point = pose.rotation @ craft.centre + RADIUS * into
        pressed += bool(np.abs(force).max() > 1.0)
        there = pinocchio.InPinocchio(craft, 2e-3).accelerations(pose, force, point)
        for mine, other in (
            (ours.velocity, there.linear),
            (ours.angular_velocity, there.angular),
            (ours.memory.hull[0].spin[0], there.spin),
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
    """Bearings only pass it on: L of body and shell together does not change."""
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
    """The impulse at its point, within the friction cone, is all that the two bodies feel."""
    struck_at_all, rolls = 0, [0, 0]
    for seed in range(4 * STATES):
        model, state, (craft, pose, into) = drawn(seed, friction=2e-3)
        r, point = pose.rotation, pose.rotation @ craft.centre + RADIUS * into

        def second(
            force: Array, craft: Any = craft, pose: Any = pose, point: Array = point
        ) -> tuple[Array, ...]:
            there = oracle.by_momenta(craft, pose, force, point)
            return there.linear, there.angular, there.spin

        def speed(*of: Array, r: Array = r, craft: Any = craft, into: Array = into) -> Array:
            v, omega, spin = of
            moves: Array = v + np.cross(r @ omega, r @ craft.centre) + np.cross(spin, RADIUS * into)
            return moves

        now = (pose.velocity, pose.omega, pose.spin)
        if speed(*now) @ into < 0.1:
            continue
        hit = struck(model, state, (0.05, 0.5)[seed % 2], second)
        then = speed(*(a + b for a, b in zip(now, hit.found, strict=True)))
        struck_at_all += 1
        rolls[seed % 2] += hit.check(into, speed(*now), then)
    assert struck_at_all > STATES
    assert rolls[0] < 10 < rolls[1], rolls


# -- flights ---------------------------------------------------------------------------------------


def flown(*arguments: Any, **named: Any) -> Flight:
    return fly(tables(*arguments, **named), executor="python")


def flown_at_a_wall(of: dict[str, Any], duration: float) -> Flight:
    """A longer flight, by the kernel that the test of executors compiles."""
    return fly(tables(of, simulation={"duration": duration}))


def end(flight: Flight, *names: str) -> np.ndarray[Any, np.dtype[np.float64]]:
    return np.array([flight.columns[name][-1] for name in names])


def test_a_free_shell_about_the_centre_of_mass_never_turns_the_body() -> None:
    """Without friction in its bearings; and friction with the wall makes it roll there.

    A point on it yields to a tangential impulse by 1/m + R²/I_s, so that the shell rolls at the end
    with a share 1 − (1/m)/(1/m + R²/I_s) of the velocity along the wall.
    """
    flight = flown(gimbal())
    assert np.abs(end(flight, "wx", "wy", "wz")).max() == 0.0
    m = as_scenario(tables()).vehicle.mass
    share = 1.0 - (1.0 / m) / (1.0 / m + RADIUS**2 / INERTIA)
    after = end(flight, "vy", "vz")
    assert after == pytest.approx(share * np.array([1.0, 0.5]), rel=2e-3)
    spin = end(flight, "shell_wx", "shell_wy", "shell_wz")
    assert spin == pytest.approx(np.array([0.0, after[1], -after[0]]) / RADIUS, rel=0.02)
    assert abs(flight.measures["ledger_residual"] or 0.0) < 1e-6


def test_bearings_that_hold_make_it_a_fixed_sphere() -> None:
    """As damping grows: the body with the shell's inertia added.  The way there goes as 1/b at least."""
    fixed = tables(None)
    inertia = np.array([0.017, 0.018, 0.028]) + INERTIA
    fixed["vehicle"] |= {"body": {"mass": 2.336, "inertia": inertia.tolist()}}
    there = end(fly(fixed, executor="python"), "wx", "wy", "wz")
    apart = [
        np.abs(end(flown_at_a_wall(gimbal(damping=b), 0.02), "wx", "wy", "wz") - there).max()
        for b in (5.0, 50.0)
    ]
    assert np.abs(there).max() > 1.0
    assert apart[1] < 0.02 * np.abs(there).max()
    assert apart[0] / apart[1] > 8.0


def test_dry_bearings_bring_a_spin_to_rest_in_the_time_of_its_torque() -> None:
    """After the hit the shell slows by M_c/I_s, and the body begins to turn."""
    dry = 5e-3
    alone, slowed = (flown_at_a_wall(of, 0.05) for of in (gimbal(), gimbal(friction=dry)))
    spins = [
        np.sqrt(sum(f.columns[f"shell_w{axis}"][-8:] ** 2 for axis in "xyz"))
        for f in (alone, slowed)
    ]
    assert np.ptp(spins[0]) == 0.0
    span = np.ptp(slowed.columns["t"][-8:])
    assert spins[1][0] - spins[1][-1] == pytest.approx(dry * span / INERTIA, rel=1e-3)
    assert spins[1][-1] > 10.0 * BEARING_SLIP
    assert np.linalg.norm(end(slowed, "wx", "wy", "wz")) > 0.0


def spun(given: dict[str, Any], spin: list[float], **start: Any) -> Flight:
    """In free flight, far from everything, from rest but for the spin."""
    given["world"] = {"gravity": 0, "obstacles": [{"type": "wall", "distance": 50.0}]}
    given["world"]["obstacles"][0]["surface"] = "wall"
    given["start"] = {"position": [0, 0, 1], "shell_spin": spin, **start}
    return fly(given | {"simulation": {"duration": 0.02}}, executor="python")


def test_a_shell_that_spins_at_the_start_is_slowed_by_its_bearings() -> None:
    """About one axis: Ω − ω falls as exp(−b (1/I_s + 1/I_z) t), and I_s Ω + I_z ω stays."""
    b, first, moment = 0.2, 30.0, 0.028
    flight = spun(tables(gimbal(damping=b)), [0.0, 0.0, first])
    spin, turning = end(flight, "shell_wz", "wz")
    assert flight.columns["shell_wz"][0] == first
    assert INERTIA * spin + moment * turning == pytest.approx(INERTIA * first, rel=1e-9)
    left = first * math.exp(-b * (1.0 / INERTIA + 1.0 / moment) * flight.t[-1])
    assert left < 0.5 * first
    assert spin - turning == pytest.approx(left, rel=1e-6)
    assert abs(flight.measures["ledger_residual"] or 0.0) < 1e-6


def test_a_spin_is_given_in_body_axes_and_stays_in_ideal_bearings() -> None:
    flight = spun(tables(gimbal()), [5.0, 0.0, 2.0], yaw="90 deg")
    for at in (0, -1):
        spin = [flight.columns[f"shell_w{axis}"][at] for axis in "xyz"]
        assert spin == pytest.approx([0.0, 5.0, 2.0], abs=1e-12)
    assert np.abs(end(flight, "wx", "wy", "wz")).max() == 0.0


def test_beside_a_second_vehicle_both_keep_their_spin() -> None:
    """Each side begins with its own, whatever else its contacts remember."""
    given = tables(gimbal(), world={"gravity": 0, "obstacles": []})
    given["start"] = {"position": [0, 0, 1], "shell_spin": [1.0, 2.0, 3.0]}
    given["second"] = {
        "vehicle": given["vehicle"], "start": {"position": [1, 0, 1], "shell_spin": [0, 0, 4.0]},
    }  # fmt: skip
    scenario = as_scenario(given)
    sides = [
        PairedFlight(in_a_scene(one, one.vehicle, one.flight_model()), one.start_state(), None, None,
                     solids_of(one.vehicle))
        for one in (scenario, scenario.beside())
    ]  # fmt: skip
    together = beside_each_other(*sides, law_between(scenario))
    spins = [list(side.start.memory.hull[0].spin[0]) for side in together]
    assert spins == [[1, 2, 3], [0, 0, 4]]


@pytest.mark.parametrize(("law", "obstacle"), MEETINGS)
def test_every_law_and_obstacle_flies(law: str, obstacle: str) -> None:
    """A shell off the centre, with viscous and dry bearings; what the ledger does not explain."""
    flight = flown(
        gimbal(damping=1e-3, friction=2e-3), law, obstacle, {"position": [0.01, 0.0, 0.02]},
        simulation={"duration": 0.004},
    )  # fmt: skip
    assert flight.measures["contacts"] == 1.0
    assert abs(flight.measures["ledger_residual"] or 0.0) < 2e-6
    assert np.abs(end(flight, "shell_wx", "shell_wy", "shell_wz")).max() > 0.1


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
    ],
    ids=["slider", "arms", "paper's point", "pilot", "own surface", "wind"],
)  # fmt: skip
def test_it_flies_with_what_else_there_is(change: dict[str, Any]) -> None:
    """Guides, arms within the shell, a pilot, a surface of its own, wind."""
    given = tables(gimbal(damping=1e-3, friction=1e-3), simulation={"duration": 0.003})
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
        tables(gimbal(damping=1e-4 * (k + 1), friction=1e-3), simulation={"duration": 0.006})
        for k in range(9)
    ]
    together = fly_scenarios(rows, threads=1).measures
    for k in (0, 5):
        plain = fly(rows[k], executor="python", trajectory=False).measures
        assert fly(rows[k], trajectory=False).measures == plain
        for name in ("impact_peak_acceleration", "loss_friction", "ledger_residual"):
            assert together[name][k] == plain[name], name


def test_under_the_impulse_law_all_executors_fly_the_same() -> None:
    """Compiled alone and in lanes: the jump of the spin is part of both."""
    rows = [tables(gimbal(friction=1e-3 * k), "impulse") for k in range(1, 10)]
    together = fly_scenarios(rows, threads=1).measures
    plain, compiled = (fly(rows[0], executor=of) for of in ("python", "compiled"))
    assert compiled.measures == plain.measures
    assert together["loss_friction"][0] == plain.measures["loss_friction"]
    assert (end(compiled, "shell_wx", "shell_wz") == end(plain, "shell_wx", "shell_wz")).all()


def test_a_stored_trajectory_gives_back_energy_and_spin() -> None:
    flight = flown(gimbal(damping=1e-3))
    speed = np.sqrt(sum(flight.columns[f"shell_w{axis}"] ** 2 for axis in "xyz"))
    assert speed[0] == 0.0
    assert speed[-1] > 1.0
    assert math.isfinite(flight.measures["loss_friction"] or math.nan)


@pytest.mark.parametrize("law", SURFACES)
def test_columns_of_a_memory_are_its_leaves_in_their_order(law: str) -> None:
    """Playback puts them together again, also where a surface remembers, too."""
    given = tables(gimbal(), law)
    given["vehicle"]["limits"] = {"guard_force": 100.0, "broken_stiffness": 0.5}
    memory = model_state(as_scenario(given).flight_model()).memory
    sources = [source for source, _ in memory_columns(memory).values()]
    assert sources == names(memory, "state.memory")


# -- wrong input -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"hull": {"on": 1}}, "vehicle.hulls[0].gimbal: needs a sphere on the body"),
        (
            {"gimbal": {"shell_mass": 3}},
            "shell_mass: must be less than the mass of the body, 2.336",
        ),
        ({"gimbal": {"shell_mass": 0}}, "shell_mass: must be more than 0 kg"),
        ({"gimbal": {"shell_mass": 0.1, "friction": "2 N"}}, "friction: has the wrong unit"),
        ({"gimbal": {"shell_mass": 0.1, "damping": -1}}, "damping: must be at least 0 N m s/rad"),
    ],
    ids=["arm", "heavy", "massless", "unit", "negative"],
)
def test_wrong_gimbals_are_refused(change: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError) as caught:
        as_scenario(tables(**{"gimbal": gimbal(), **change}))
    assert any(message in line for line in caught.value.problems), caught.value.problems


def test_what_does_not_turn_by_itself_has_no_spin() -> None:
    given = tables(None)
    given["start"] |= {"shell_spin": [0, 0, 1.0]}
    with pytest.raises(InputError, match=r"start\.shell_spin: needs a hull that turns by itself"):
        as_scenario(given)


def test_what_a_shell_cannot_be_combined_with_is_said() -> None:
    crowded = tables(gimbal())
    crowded["vehicle"]["hulls"].append({"type": "sphere", "radius": 0.05})
    for given, message in (
        (crowded, "vehicle.hulls[0].gimbal: needs a sphere that is the only hull of the main"),
    ):
        with pytest.raises(InputError) as caught:
            as_scenario(given)
        assert any(message in line for line in caught.value.problems), caught.value.problems
