"""Thrust above surfaces, beside a source and its image in closed form; in plain Python."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import springback
from builders.listed_rotors import canted, vehicle_with
from oracles import models
from springback.contact.hull_contact import body_sight
from springback.dynamics.limbs.surface_effect import image_flow, rotors_far, rotors_near
from springback.dynamics.motion import rates
from springback.errors import InputError
from springback.results.flight import fly
from springback.scenario.model import bodies_at_start
from springback.scenario.scenario import Scenario
from springback.simulation.flight import still_state
from springback.simulation.measuring.record import Model
from springback.vehicle.parameters import Vehicle
from springback.vehicle.propulsion import SurfaceEffect

Array = NDArray[np.float64]

RADIUS = 0.0635
GROUND: dict[str, Any] = {"type": "ground", "surface": springback.WALL}
EFFECT = SurfaceEffect(RADIUS, 0.0, 0.5 * RADIUS)


def with_effect(rotors: list[dict[str, Any]] | None = None, **effect: Any) -> Vehicle:
    given = vehicle_with(rotors or [])
    given["propulsion"]["surface_effect"] = effect or True
    return Vehicle.model_validate(given)


def by_image(place: Array, up: Array, normal: Array, offset: float) -> float:
    """T/T∞ by the source of strength R² v/4 and its image in a plane, at the same power T v."""
    height = float(normal @ place - offset)
    away = place - (place - 2.0 * height * normal)  # from the image
    blown = RADIUS**2 / 4.0 * away / np.linalg.norm(away) ** 3  # velocity there, for v = 1
    return 1.0 / (1.0 - max(float(blown @ up), 0.0))


def factors(
    vehicle: Vehicle, obstacles: list[Any], state: Any, start: Any = (0.0, 0.0, 1.0)
) -> Array:
    """Thrust near obstacles, for each newton far from all; scenarios start elsewhere."""
    world, there = {"obstacles": obstacles}, {"position": list(start)}
    model = Scenario(vehicle=vehicle, world=world, start=there).flight_model()
    return factors_of(model, state)


def factors_of(model: Model, state: Any) -> Array:
    state = state._replace(bodies=bodies_at_start(model.world))
    around = body_sight(model.world.obstacles, state, 0.0)
    (effect,) = model.surface_effect
    ones = (1.0,) * len(model.thrust)
    far = rotors_far(ones)
    near = rotors_near(far, effect, model.airframe, state.arm_length, around.obstacles)
    return np.array(near.thrust)


def test_the_published_formula_and_its_cap() -> None:
    """1/(1 − (R/4z)²): a third more at half a radius, and no more than that below it."""
    for share, gain in ((0.5, 4.0 / 3.0), (1.0, 16.0 / 15.0), (2.0, 64.0 / 63.0)):
        flow = image_flow(EFFECT, share * RADIUS, 1.0)
        assert 1.0 / (1.0 - flow) == pytest.approx(gain, rel=1e-12)
    for height in (0.4 * RADIUS, 0.0, -1.0):
        assert image_flow(EFFECT, height, 1.0) == image_flow(EFFECT, 0.5 * RADIUS, 1.0)
    assert image_flow(EFFECT, RADIUS, 0.5) == 0.5 * image_flow(EFFECT, RADIUS, 1.0)
    assert image_flow(EFFECT, RADIUS, 0.0) == image_flow(EFFECT, RADIUS, -1.0) == 0.0


@pytest.mark.parametrize("listed", [False, True], ids=["arms", "listed"])
def test_a_plane_of_any_tilt_is_its_image(listed: bool) -> None:
    """At random attitudes: of upright rotors of arms, and of canted ones."""
    vehicle = with_effect(canted(0.35) if listed else None)
    ups = np.array([one.get("axis") for one in canted(0.35 if listed else 0.0)])
    ends = np.array([vehicle.arms.end(j) for j in range(6)])
    raised = 0
    for seed in range(30):
        rng = np.random.default_rng([61, seed])
        normal = models.unit_vector(rng)
        position = rng.uniform(-1.0, 1.0, size=3)
        turn = rng.normal(size=4)
        state = still_state(vehicle.lengths())._replace(
            position=models.vec(position), attitude=type(still_state([0.0]).attitude)(
                *(turn / np.linalg.norm(turn)).tolist()
            ),
        )  # fmt: skip
        offset = float(normal @ position) - rng.uniform(0.2, 0.3)
        wall = {
            "type": "wall", "normal": normal.tolist(), "position": (offset * normal).tolist(),
            "surface": springback.WALL,
        }  # fmt: skip
        found = factors(vehicle, [wall], state, (position + 3.0 * normal).tolist())
        r = models.start_of(state).rotation
        wanted = [
            by_image(position + r @ end, r @ up, normal, offset)
            for end, up in zip(ends, ups, strict=True)
        ]
        assert found == pytest.approx(wanted, rel=1e-12)
        raised += int((found > 1.0 + 1e-9).sum())
    assert raised > 30


def test_any_obstacle_below_counts_and_none_beside_or_above() -> None:
    """The top of a box, a slope, a moving floor; a wall and a ceiling change nothing."""
    vehicle = with_effect()
    state = still_state(vehicle.lengths())._replace(position=models.vec(np.array([0.0, 0.0, 0.1])))
    on_ground = factors(vehicle, [GROUND], state)
    assert on_ground == pytest.approx(1.0 / (1.0 - (RADIUS / 0.4) ** 2))
    box = {"type": "box", "position": [0, 0, -0.5], "size": [2, 2, 1], "surface": springback.WALL}
    assert factors(vehicle, [box], state) == pytest.approx(on_ground)
    assert factors(vehicle, [box, GROUND], state) == pytest.approx(on_ground)
    wall = {"type": "wall", "distance": 0.3, "surface": springback.WALL}
    assert factors(vehicle, [wall], state) == pytest.approx(np.ones(6), abs=1e-15)
    assert factors(vehicle, [wall, GROUND], state) == pytest.approx(on_ground)
    ceiling = {"type": "wall", "normal": [0, 0, -1], "position": [0, 0, 0.2],
               "surface": springback.WALL}  # fmt: skip
    assert (factors(vehicle, [ceiling], state, (0.0, 0.0, -1.0)) == 1.0).all()
    moving = box | {"motion": {"type": "constant", "velocity": [0, 0, 0.1]}}
    assert factors(vehicle, [moving, wall], state) == pytest.approx(on_ground)


def hover_height() -> float:
    """Height at which rotors with 98 % of the weight hover."""
    return RADIUS / (4.0 * math.sqrt(1.0 - 0.98))


def scenario(share: float, height: float, **more: Any) -> dict[str, Any]:
    """Over the ground, with some share of the hover thrust."""
    vehicle = vehicle_with([])
    vehicle["propulsion"]["surface_effect"] = True
    weight = Vehicle.model_validate(vehicle).mass * 9.81
    return {
        "vehicle": vehicle, "thrust": share * weight / 6.0, "world": {"obstacles": [GROUND]},
        "start": {"position": [0.0, 0.0, height]}, "simulation": {"duration": 0.2},
        **more,
    }  # fmt: skip


def test_the_ground_carries_a_vehicle_with_too_little_thrust() -> None:
    """It hovers where the gain makes up for the rest, falls above and rises below that height."""
    rises = {}
    for name, height in (("at", hover_height()), ("above", 0.13), ("below", 0.09)):
        flight = fly(scenario(0.98, height), executor="python")
        rises[name] = float(flight.columns["vz"][-1])
        assert name == "at" or abs(flight.measures["ledger_residual"] or 0.0) < 1e-6
    assert abs(rises["at"]) < 1e-12
    assert rises["above"] < -1e-3
    assert rises["below"] > 1e-3


def test_its_work_is_that_of_the_larger_thrust_and_steps_are_of_fourth_order() -> None:
    """Vertical fall: v̇ = (T/m)/(1 − (R/4z)²) − g, integrated in closed steps beside it."""
    given = scenario(0.9, 0.2, start={"position": [0.0, 0.0, 0.2], "velocity": [0.0, 0.0, -0.3]})
    mass = Vehicle.model_validate(given["vehicle"]).mass
    x, h = np.array([0.2, -0.3, 0.0]), 1e-5
    lift = 0.9 * 9.81

    def slope(at: Array) -> Array:
        force = lift / (1.0 - (RADIUS / (4.0 * at[0])) ** 2)
        return np.array([at[1], force - 9.81, mass * force * at[1]])

    for _ in range(20000):
        k1 = slope(x)
        k2 = slope(x + 0.5 * h * k1)
        k3 = slope(x + 0.5 * h * k2)
        x = axpy_array(x, k1, k2, k3, slope(x + h * k3), h)
    flight = fly(given, executor="python")
    assert flight.columns["z"][-1] == pytest.approx(x[0], rel=1e-10)
    assert flight.columns["vz"][-1] == pytest.approx(x[1], rel=1e-9)
    assert flight.measures["work_thrust"] == pytest.approx(x[2], rel=1e-9)


def axpy_array(x: Array, k1: Array, k2: Array, k3: Array, k4: Array, h: float) -> Array:
    return x + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)


@pytest.mark.parametrize("listed", [False, True], ids=["arms", "listed"])
def test_a_wall_beside_draws_by_its_line(listed: bool) -> None:
    """Force and moment of six rotors at a tilted wall, in closed form; none of it along an axis."""
    vehicle = with_effect(canted(0.35) if listed else None, wall_suction=0.2, wall_reach=6.0)
    ups = np.array([one.get("axis") for one in canted(0.35 if listed else 0.0)])
    ends = np.array([vehicle.arms.end(j) for j in range(6)])
    normal = np.array([-0.96, 0.0, 0.28])
    wall = {"type": "wall", "normal": normal.tolist(), "position": (-0.4 * normal).tolist(),
            "surface": springback.WALL}  # fmt: skip
    thrust = 2.0
    model = Scenario(
        vehicle=vehicle, world={"gravity": 0, "obstacles": [wall]}, thrust=thrust,
        start={"position": [0, 0, 0]},
    ).flight_model()  # fmt: skip
    plain = Scenario(
        vehicle=with_effect(canted(0.35) if listed else None),
        world={"gravity": 0, "obstacles": [wall]}, thrust=thrust, start={"position": [0, 0, 0]},
    ).flight_model()  # fmt: skip
    state = still_state(vehicle.lengths())
    drawn, still = (rates(one, state, 0.0).motion.state for one in (model, plain))
    force, moment, felt = np.zeros(3), np.zeros(3), 0
    for end, up in zip(ends, ups, strict=True):
        share = max(0.0, 1.0 - (normal @ end + 0.4) / (6.0 * RADIUS))
        pull = 0.2 * thrust * share * (-normal + (normal @ up) * up)
        force, moment, felt = force + pull, moment + np.cross(end, pull), felt + (share > 0.0)
    assert 0 < felt < 6
    assert np.array(drawn.velocity) - np.array(still.velocity) == pytest.approx(
        force / vehicle.mass, rel=1e-9, abs=1e-12
    )
    inertia = np.array(model.airframe.inertia)
    for end, arm in zip(ends, model.airframe.arms, strict=True):
        inertia = inertia + arm.mass * (end @ end * np.eye(3) - np.outer(end, end))
    turned = np.array(drawn.angular_velocity) - np.array(still.angular_velocity)
    assert inertia @ turned == pytest.approx(moment, rel=1e-9, abs=1e-12)


def test_the_work_of_suction_is_in_the_ledger() -> None:
    """A hovering vehicle drifts to the wall; without suction it stays."""
    vehicle = vehicle_with([])
    vehicle["propulsion"]["surface_effect"] = {"wall_suction": 0.1}
    wall = {"type": "wall", "distance": 0.5, "surface": springback.WALL}
    given = scenario(
        1.0, 1.0, vehicle=vehicle, world={"obstacles": [wall]},
        start={"position": [0.18, 0.0, 1.0]}, simulation={"duration": 1.5, "impact_step": 1e-5},
    )  # fmt: skip
    flight = fly(given)
    assert flight.columns["vx"].max() > 0.1
    assert (flight.measures["contacts"] or 0.0) >= 1.0
    assert flight.measures["work_thrust"] > 1e-3
    assert abs(flight.measures["ledger_residual"] or 0.0) < 1e-6


def test_without_the_option_nothing_changes() -> None:
    model = Scenario(**scenario(1.0, 0.1)).flight_model()
    assert len(model.surface_effect) == 1
    plain = vehicle_with([])
    assert Scenario(vehicle=plain).flight_model().surface_effect == ()
    plain["propulsion"]["surface_effect"] = False
    assert Scenario(vehicle=plain).flight_model().surface_effect == ()


def test_compiled_it_is_the_same_flight() -> None:
    """Bit for bit, with tilted rotors that are drawn, too, on the way to the ground and onto it."""
    vehicle = vehicle_with(canted(0.3))
    vehicle["propulsion"]["surface_effect"] = {"least_height": 0.6, "wall_suction": 0.1}
    given = scenario(
        0.8, 0.05, vehicle=vehicle,
        start={"position": [0.0, 0.0, 0.12], "velocity": [0.1, 0.0, -0.8], "roll": 0.1},
    )  # fmt: skip
    compiled, plain = fly(given), fly(given, executor="python")
    assert compiled.measures == plain.measures
    assert (compiled.measures["contacts"] or 0.0) >= 1.0
    assert abs(compiled.measures["ledger_residual"] or 0.0) < 1e-6
    away = compiled.specific_force([0.1, 0.0, 0.0]) - compiled.specific_force()
    assert np.isfinite(away).all()


@pytest.mark.parametrize(
    ("propulsion", "words"),
    [
        ({"surface_effect": True}, ("propulsion.surface_effect", "needs propulsion.disk_radius")),
        (
            {"surface_effect": {"least_height": 0.2}, "disk_radius": 0.06},
            ("propulsion.surface_effect.least_height", "must be at least 0.3 (got 0.2)"),
        ),
        (
            {"surface_effect": {"height": 0.2}, "disk_radius": 0.06},
            ("propulsion.surface_effect.height", "unknown key"),
        ),
        ({"surface_effect": "yes", "disk_radius": 0.06}, ("propulsion.surface_effect", "'yes'")),
    ],
)  # fmt: skip
def test_bad_input_is_one_line(propulsion: dict[str, Any], words: tuple[str, ...]) -> None:
    with pytest.raises(InputError) as caught:
        Vehicle(**vehicle_with([], propulsion={"max_thrust": 2.0, **propulsion}))
    (line,) = caught.value.problems
    assert all(word in line for word in words), line
