"""The main body's hull: a sphere that meets what cages meet."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from builders.bodies import LEVEL, body
from builders.scenes import surface
from builders.user_obstacles import Pole
from springback.batch.scenarios import fly_scenarios
from springback.contact.cage import FAR
from springback.contact.hull_contact import hull_contact, hull_faces
from springback.contact.laws.restitution import restitution
from springback.contact.loads import CageContact
from springback.contact.obstacles import Obstacle, Plane, SecondContact
from springback.control.runup import reach
from springback.errors import InputError
from springback.kernels.vectors import Vec
from springback.results.flight import Flight, fly
from springback.scenario.model import contact_point_of
from springback.scenario.scenario import scenario_from
from springback.simulation.measuring.measures import Outcome
from springback.vehicle.library import VEHICLES
from springback.vehicle.state import PartMemory, Sphere

RADIUS = 0.06
UP = Vec(0.0, 0.0, 1.0)
DROP: dict[str, Any] = {
    "vehicle": "quad",
    "world": {"obstacles": [{"type": "ground", "surface": "wall"}]},
    "start": {"position": [0.0, 0.0, 0.3], "roll": "180 deg"},
    "thrust": [0.0, 0.0, 0.0, 0.0],
    "simulation": {"duration": 1.0},
}


def value(flight: Flight, name: str) -> float:
    """A measure that there is."""
    found = flight.measures[name]
    assert found is not None
    return found


def met(shape: Any, centre: Vec, velocity: Vec, omega: Vec, radius: float = RADIUS) -> CageContact:
    """A hull against a rubber obstacle of some shape."""
    rubber = surface(stiffness=1e5, friction=0.5, slip_speed=1e-3)
    hull = Sphere(centre, radius)
    (face,) = hull_faces(hull, (Obstacle(shape, rubber, 0.0),), 1.0)
    return hull_contact(face, 1.0, PartMemory((), ()), hull, body(LEVEL, velocity, omega))


# -- one instant -----------------------------------------------------------------------------------


def test_the_gap_is_the_distance_of_the_centre_less_the_radius() -> None:
    """Exact for what is flat and for what is round, and its rate is the gap's own."""
    chance = np.random.default_rng(5)
    pole = Pole(0.2, -0.1, 0.03)
    for shape in (Plane(Vec(-1.0, 0.0, 0.0), -0.1), pole):
        for _ in range(40):
            c, v, w = (Vec(*map(float, chance.normal(size=3))) for _ in range(3))
            now = met(shape, c * 0.1, v, w)
            if isinstance(shape, Plane):
                away = 0.1 - 0.1 * c.x
            else:
                away = math.hypot(0.1 * c.x - 0.2, 0.1 * c.y + 0.1) - 0.03
            assert now.gap == pytest.approx(away - RADIUS, abs=1e-15)
            h = 1e-6
            moved = [met(shape, c * 0.1 + (v + (w ^ (c * 0.1))) * s, v, w).gap for s in (h, -h)]
            assert now.rate == pytest.approx((moved[0] - moved[1]) / (2.0 * h), abs=1e-6)


def test_it_rubs_where_it_touches() -> None:
    """A ball that rolls on a wall does not slip; one that only slides or only spins does."""
    wall = Plane(Vec(0.0, 0.0, 1.0), -0.05)  # a floor 50 mm below the centre: 10 mm pressed in
    at = Vec(0.0, 0.0, 0.0)
    slides = met(wall, at, Vec(1.0, 0.0, 0.0), Vec(0.0, 0.0, 0.0)).touch
    spins = met(wall, at, Vec(0.0, 0.0, 0.0), Vec(0.0, 1.0 / RADIUS, 0.0)).touch
    rolls = met(wall, at, Vec(1.0, 0.0, 0.0), Vec(0.0, 1.0 / RADIUS, 0.0)).touch
    assert slides.normal == pytest.approx(1e5 * 0.01**1.5)
    assert slides.friction.x == pytest.approx(-0.5 * slides.normal, rel=1e-3)
    assert spins.friction.x == pytest.approx(0.5 * slides.normal, rel=1e-3)
    assert abs(rolls.friction.x) < 1e-9 * slides.normal
    # Its moment is the force's with the radius as lever, and takes what friction loses.
    assert slides.moment.y == pytest.approx(-RADIUS * slides.friction.x)
    assert slides.friction_loss == pytest.approx(-slides.friction.x)
    assert spins.friction_loss == pytest.approx(-spins.moment.y / RADIUS)


def test_a_centre_off_the_main_body_has_a_lever() -> None:
    """The normal force alone turns it by p × n."""
    wall = Plane(Vec(-1.0, 0.0, 0.0), -0.05)
    touch = met(wall, Vec(0.0, 0.01, 0.02), Vec(0.0, 0.0, 0.0), Vec(0.0, 0.0, 0.0)).touch
    assert touch.force.x == pytest.approx(-1e5 * 0.01**1.5)
    assert touch.moment.y == pytest.approx(0.02 * touch.force.x)
    assert touch.moment.z == pytest.approx(-0.01 * touch.force.x)


def test_it_touches_a_shape_once() -> None:
    """The entry for the second point of a ring is no second contact of the hull."""
    pole = Pole(0.2, -0.1, 0.19)
    once, again = (met(s, Vec(0.0, 0.0, 0.0), UP, UP) for s in (pole, SecondContact(pole)))
    assert once.touch.normal > 0.0
    assert again.gap > 0.9 * FAR
    assert again.touch.normal == 0.0


# -- flights ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("robot", ["arq", "quad"])
def test_a_robot_on_its_back_rests_on_its_hull(robot: str) -> None:
    """Main body above the ground by the hull's radius less what rest and a tilt of a few degrees take."""
    tables = {**DROP, "vehicle": robot, "simulation": {"duration": 4.0}}
    tables["start"] = {**DROP["start"], "pitch": "3 deg", "angular_velocity": [0.1, 0.2, 0.05]}
    flight = fly(tables)
    assert flight.outcome is Outcome.HIT_GROUND
    assert abs(flight.columns["vz"][-1]) < 0.02
    assert 0.055 < flight.columns["z"][-1] < RADIUS
    assert flight.columns["z"].min() > 0.04
    assert value(flight, "body_contacts") > 0.0
    assert flight.columns["fn_body"][-1] > 0.0
    assert abs(value(flight, "ledger_residual")) < 1e-6

    sinks = fly({**tables, "vehicle": {"preset": robot, "hull": False}})
    assert sinks.columns["z"][-1] < 1e-3
    assert sinks.measures["body_contacts"] is None
    assert "fn_body" not in sinks.columns


def test_at_rest_it_carries_the_weight() -> None:
    """On a vertical slider nothing tips over: k δ^1.5 = m g."""
    flight = fly({**DROP, "model": {"slider": [0.0, 0.0, 1.0]}, "simulation": {"duration": 6.0}})
    vehicle, ground = flight.scenario.vehicle, flight.scenario.flight_model().world.obstacles[0]
    depth = (vehicle.mass * 9.81 / ground.surface.stiffness) ** (2.0 / 3.0)
    assert flight.columns["z"][-1] == pytest.approx(RADIUS - depth, abs=2e-5)
    assert value(flight, "energy_contact") == pytest.approx(
        0.4 * vehicle.mass * 9.81 * depth, rel=0.02
    )
    assert flight.measures["touch_time"] == pytest.approx(math.sqrt(2.0 * 0.24 / 9.81), abs=1e-6)


def flat(robot: str, **start: Any) -> dict[str, Any]:
    """A robot that flies belly first into a wall, without weight."""
    return {
        "vehicle": robot,
        "world": {"gravity": 0.0, "obstacles": [{"type": "wall", "distance": 1.0, "surface": "wall"}]},
        "start": {"position": [0.9, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0], "pitch": "90 deg", **start},
        "thrust": [0.0, 0.0, 0.0, 0.0],
        "simulation": {"duration": 0.1},
    }  # fmt: skip


@pytest.mark.parametrize("robot", ["arq", "quad"])
def test_a_flat_hit_bounces_on_the_body(robot: str) -> None:
    """With the wall's own restitution, which is exact, and no cage or arm takes part."""
    flight = fly(flat(robot))
    dissipation = flight.scenario.flight_model().world.obstacles[0].surface.dissipation
    assert value(flight, "touch_time") == pytest.approx((0.1 - RADIUS) / 2.0, abs=1e-9)
    assert value(flight, "restitution_at_separation") == pytest.approx(
        restitution(2.0, dissipation / 1.5), abs=2e-5
    )
    assert value(flight, "body_contacts") == value(flight, "contacts") == 1.0
    assert value(flight, "arm_stroke") == pytest.approx(0.0, abs=1e-12)
    # Peaks lie between instants.
    most = pytest.approx(value(flight, "peak_normal_force"), rel=1e-4)
    assert flight.columns["fn_body"].max() == most
    mass, after = flight.scenario.vehicle.mass, flight.columns["vx"][-1]
    assert value(flight, "impulse_x") == pytest.approx(mass * (after - 2.0), rel=1e-9)
    assert abs(value(flight, "ledger_residual")) < 1e-6


def test_an_oblique_flat_hit_turns_and_closes_its_ledger() -> None:
    """Friction with the radius as lever: J ω = ρ Δp across it, about the main body's centre."""
    flight = fly(flat("quad", velocity=[2.0, 1.0, 0.0]))
    vehicle = flight.scenario.vehicle
    push = value(flight, "impulse_y")
    assert push < -0.1
    after = flight.columns["vy"][-1]
    assert push == pytest.approx(vehicle.mass * (after - 1.0), rel=1e-9)
    # World Y is body y, and the wall lies along −z of the body: the moment is about body x.
    spin = flight.columns["wx"][-1] * vehicle.inertia()[0, 0]
    assert spin == pytest.approx(-RADIUS * push * math.copysign(1.0, spin * -push), rel=0.02)
    assert value(flight, "loss_friction") > 0.01
    assert abs(value(flight, "ledger_residual")) < 1e-6


@pytest.mark.parametrize("restitution", [0.0, 0.4, 1.0])
def test_the_impulse_law_strikes_it(restitution: float) -> None:
    """A flat hit is central: v⁺ = −e v⁻."""
    tables = flat("quad")
    wall = {"law": "impulse", "restitution": restitution}
    tables["world"]["obstacles"][0]["surface"] = wall
    flight = fly(tables)
    assert flight.columns["vx"][-1] == pytest.approx(-2.0 * restitution, abs=1e-9)
    assert value(flight, "impulse_x") == pytest.approx(
        -2.0 * (1.0 + restitution) * flight.scenario.vehicle.mass, rel=1e-9
    )
    assert value(flight, "body_contacts") == 1.0
    # At the very touch: it does not sink in until the cages, 60 mm behind, meet the wall.
    assert value(flight, "touch_time") == pytest.approx((0.1 - RADIUS) / 2.0, abs=1e-9)
    assert flight.columns["x"].max() == pytest.approx(1.0 - RADIUS, abs=1e-9)


def test_it_is_felt_at_the_very_touch() -> None:
    """A dashpot pushes with b v from the instant of landing on: contact is decided as for cages."""
    tables = flat("quad")
    wall = {"law": "kelvin-voigt", "stiffness": 2e4, "viscosity": 50.0}
    tables["world"] = {
        "gravity": 0.0,
        "obstacles": [{"type": "wall", "distance": 1.0, "surface": wall}],
    }
    flight = fly(tables)
    pressed = flight.columns["fn_body"]
    assert pressed[np.flatnonzero(pressed)[0]] == pytest.approx(100.0, rel=1e-6)
    assert flight.touch_speed == pytest.approx(2.0, abs=1e-12)


def test_flights_abreast_are_the_flight_alone() -> None:
    """Whatever neighbours do: bodies that hit and bodies that do not share a group of lanes."""
    tables = [
        flat(
            ("arq", "quad")[k % 2], pitch=f"{90 - 4 * k} deg", yaw=f"{3 * k} deg",
            position=[0.75, 0.0, 1.0], velocity=[3.0, 0.0, 0.0],
        )
        for k in range(12)
    ]  # fmt: skip
    together = fly_scenarios(tables, threads=1)
    hit = together.measures["body_contacts"]
    assert 2 <= np.count_nonzero(hit) <= 10
    for k, one in enumerate(tables):
        for name, number in fly(one, trajectory=False).measures.items():
            column = together.measures[name][k]
            assert np.isnan(column) if number is None else column == number, (k, name)


def test_plain_python_flies_it_to_the_same_bits() -> None:
    """With a touch of body and cages."""
    tables = flat("arq", pitch="80 deg", position=[0.93, 0.0, 1.0])
    tables["simulation"] = {"duration": 0.012}
    plain = fly(tables, executor="python", trajectory=False).measures
    assert plain["body_contacts"] == 1.0
    assert fly(tables, trajectory=False).measures == plain


# -- settings --------------------------------------------------------------------------------------


def test_a_run_up_ends_where_the_hull_touches() -> None:
    """A robot that arrives nearly flat touches with its body before its cages."""
    airframe = VEHICLES["quad"].vehicle.airframe()
    point = contact_point_of(scenario_from(DROP).model)
    steep, front = math.radians(85.0), 0.19 / math.sqrt(2.0) + 0.11
    assert reach(airframe, point, steep) == pytest.approx(RADIUS)
    assert reach(airframe, point, 0.0) == pytest.approx(front, rel=1e-4)
    assert reach(airframe._replace(hull=()), point, steep) < 0.5 * RADIUS


@pytest.mark.parametrize(
    ("hull", "said"),
    [
        ({"radius": 0.0}, "vehicle.hull.radius: must be more than 0 m (got 0 m)"),
        ({"radius": "6 kg"}, "vehicle.hull.radius: "),
        ({"radius": 0.05, "offset": [0.0, 0.3, 0.0]}, "within the length of the longest arm, 0.19 m"),
        ({"radius": 0.05, "centre": [0.0, 0.3, 0.0]}, "unknown key"),
        (True, "vehicle.hull: "),
    ],
)  # fmt: skip
def test_hulls_that_cannot_be_are_refused(hull: Any, said: str) -> None:
    """In one line that names the field, its value and its range."""
    with pytest.raises(InputError) as told:
        scenario_from({**DROP, "vehicle": {"preset": "quad", "hull": hull}})
    assert said in str(told.value)


def test_a_start_with_the_body_in_a_wall_is_refused() -> None:
    """The cages of a flat robot are clear of the wall."""
    with pytest.raises(InputError, match=r"puts the main body 0\.01 m inside"):
        scenario_from(flat("quad", position=[0.95, 0.0, 1.0]))


def test_a_hull_can_be_changed_by_one_number() -> None:
    """As all settings of a preset can."""
    scenario = scenario_from({**DROP, "vehicle": {"preset": "quad", "hull": {"radius": "40 mm"}}})
    assert scenario.vehicle.hull is not None
    assert scenario.vehicle.hull.radius == 0.04
    lowered = fly(DROP, "vehicle.hull.offset=[0, 0, 0.02]", trajectory=False)
    assert value(lowered, "touch_time") == pytest.approx(math.sqrt(2.0 * 0.22 / 9.81), abs=1e-6)


def test_a_campaign_varies_the_hull() -> None:
    """Flights alike but for its radius are made ready by one pass, and are the flights alone."""
    tables = [
        {**flat("quad"), "vehicle": {"preset": "quad", "hull": {"radius": 0.04 + 2e-3 * k}}}
        for k in range(12)
    ]
    together = fly_scenarios(tables, threads=1)
    expected = [(0.1 - 0.04 - 2e-3 * k) / 2.0 for k in range(12)]
    assert together.measures["touch_time"] == pytest.approx(expected, abs=1e-9)
    alone = fly(tables[7], trajectory=False).measures
    assert alone["separation_time"] == together.measures["separation_time"][7]


def rough(chance: np.random.Generator, robot: str, hull: bool) -> dict[str, Any]:
    """A robot of any attitude and spin that falls into the corner of a wall and the ground."""
    return {
        "vehicle": {"preset": robot, "hull": hull and {"radius": RADIUS}},
        "world": {
            "obstacles": [
                {"type": "wall", "distance": 1.0, "surface": "wall"},
                {"type": "ground", "height": -0.4, "surface": "wall"},
            ]
        },
        "start": {
            "position": [0.55, 0.0, 0.3],
            "velocity": [chance.uniform(0.5, 6.0), *chance.uniform(-1.0, 1.0, 2).tolist()],
            "roll": chance.uniform(-3.0, 3.0), "pitch": chance.uniform(-1.5, 1.5),
            "yaw": chance.uniform(-3.0, 3.0),
            "angular_velocity": chance.normal(0.0, 3.0, 3).tolist(),
        },
        "simulation": {"duration": 0.5},
    }  # fmt: skip


def test_random_flights_close_their_ledgers_and_only_bodies_that_hit_change_anything() -> None:
    """Of 80 about half hit with their bodies; the others are what they are without a hull."""
    measured = []
    for hull in (True, False):
        chance = np.random.default_rng(4)
        tables = [rough(chance, ("arq", "quad")[k % 2], hull) for k in range(80)]
        measured.append(fly_scenarios(tables, threads=1).measures)
    ours, bare = measured
    hit = np.asarray(ours["body_contacts"]) > 0.0
    assert 20 < hit.sum() < 60
    assert np.abs(ours["ledger_residual"]).max() < 1e-6
    # A step may end a little earlier for a hull that comes near: all but rounding stays.
    for name in ("peak_acceleration", "travel", "impulse_x", "impulse_z", "end_time", "contacts"):
        with_hull, without = (np.asarray(column[name])[~hit] for column in (ours, bare))
        assert with_hull == pytest.approx(without, rel=1e-11, abs=1e-12), name
    assert (np.asarray(ours["impulse_z"]) != np.asarray(bare["impulse_z"]))[hit].all()
