"""Drag and wind: power, terminal speed, Galilei, the ledger, and what a user may write."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numba
import numpy as np
import pytest

from oracles import models
from springback.dynamics.air import Air, AirSettings, Still, aerodynamics, in_wind
from springback.dynamics.gusts import NoGusts, first_gust, gust
from springback.dynamics.impulse import apply_impulses
from springback.dynamics.motion import Motion, rates
from springback.errors import InputError
from springback.kernels.trees import leaves
from springback.kernels.vectors import Vec, rotation
from springback.results.flight import as_scenario
from springback.scenario.scenario import scenario_from
from springback.simulation.flight import FlightRecord, fly_one, still_work
from springback.simulation.measuring.measures import measures_of
from springback.simulation.measuring.record import FINISHED
from springback.simulation.request import settled_motion

ZERO = Vec(0.0, 0.0, 0.0)
#: Of the order of a half-kilogram quadrotor's; all parts at work and none alike.
DRAG = Air(Vec(3.0, -2.0, 0.5), Vec(0.3, 0.2, 0.1), 0.02, Vec(0.01, 0.02, 0.03))


def random_instant(seed: int) -> tuple[models.Scene, models.Start]:
    """A craft far from the wall, turning, arms sliding, rotors on."""
    rng = np.random.default_rng([20, seed])
    craft = models.random_craft(rng)
    thrust = tuple(rng.uniform(1.0, 5.0, len(craft.arms)).tolist())
    wall = models.Wall(np.array([-1.0, 0.0, 0.0]), -models.FAR)
    return models.Scene(craft, wall, thrust), models.random_start(rng, craft)


def rates_in(air: Any, scene: models.Scene, start: models.Start) -> Any:
    """Rates of all that is integrated, arms free, in some air."""
    return rates(models.model_of(scene, until=1.0)._replace(air=air), models.state_of(start), 1.0)


def flown_in(air: Any, scene: models.Scene, start: models.Start, **how: Any) -> FlightRecord:
    """A flight of plain Python in some air."""
    model = models.model_of(scene, **how)._replace(air=air)
    flown = fly_one(model, models.state_of(start), trace=False, executor="python")
    assert flown.record.stepping.status == FINISHED
    return flown


# -- drag ------------------------------------------------------------------------------------------


def test_drag_is_the_formula() -> None:
    """−(D + T K + c |u|) u along the body axes, written with arrays."""
    for seed in range(20):
        scene, start = random_instant(seed)
        r = rotation(models.state_of(start).attitude)
        u = start.rotation.T @ (start.velocity - np.array(DRAG.wind))
        thrust = sum(scene.thrust)
        d = np.diag(np.array(DRAG.rotor_drag) + thrust * np.array(DRAG.thrust_drag))
        expected = -d @ u - DRAG.body_drag * np.linalg.norm(u) * u
        got = aerodynamics(DRAG, Vec(*start.velocity) @ r, r, thrust)
        np.testing.assert_allclose(got.force, expected, rtol=1e-12, atol=1e-14)
        power = expected @ (start.rotation.T @ start.velocity)
        assert got.loss == pytest.approx(-power, rel=1e-12)


def test_drag_in_still_air_always_takes_energy() -> None:
    """Whatever the direction: all coefficients are dissipative, so rising wind speeds only matter."""
    air = in_wind(DRAG, ZERO)
    for seed in range(50):
        scene, start = random_instant(seed)
        r = rotation(models.state_of(start).attitude)
        assert aerodynamics(air, Vec(*start.velocity) @ r, r, sum(scene.thrust)).loss > 0.0


def test_wind_blows_a_hovering_vehicle_along() -> None:
    """Released at rest it accelerates downwind, and the air gives energy once it moves."""
    air = Air(Vec(4.0, 0.0, 0.0), Vec(0.3, 0.3, 0.3), 0.0, ZERO)
    start = replace(random_instant(0)[1], velocity=np.zeros(3), omega=np.zeros(3))
    start = replace(start, attitude=models.quaternion(0.0, 0.0, 0.0))
    scene = random_instant(0)[0]
    still, blown = rates_in(Still(0.0), scene, start), rates_in(air, scene, start)
    assert blown.motion.state.velocity.x > still.motion.state.velocity.x
    moving = replace(start, velocity=np.array([1.0, 0.0, 0.0]))
    assert rates_in(air, scene, moving).motion.work.air < 0.0


@pytest.mark.parametrize("slides", [True, False])
def test_power_balance_at_an_instant(slides: bool) -> None:
    """Σ of all masses' power under the accelerations is the rotors' less all that is booked.

    d/dt of kinetic, potential and spring energy, by a difference along the rates.
    """
    for seed in range(20):
        scene, start = random_instant(seed)
        if not slides:
            craft = models.random_craft(np.random.default_rng([21, seed]), slides=False)
            scene = replace(scene, craft=craft, thrust=scene.thrust[:1] * len(craft.arms))
            rng = np.random.default_rng([22, seed])
            start = models.random_start(rng, craft, still_arms=True)
        known = rates_in(DRAG, scene, start).motion
        x, v = np.array(leaves(models.state_of(start))), np.array(leaves(known.state))
        h = 1e-5
        ends = []
        for sign in (1.0, -1.0):
            y = x + sign * h * v
            n = len(scene.craft.arms)
            moved = models.Start(y[:3], y[3:7], y[7:10], y[10:13], y[13 : 13 + n], y[13 + n :])
            ends.append(models.energy_of(scene, moved).total)
        rate = (ends[0] - ends[1]) / (2.0 * h)
        work = known.work
        booked = work.thrust - work.arm - work.stop - work.contact - work.friction - work.air
        # The error of the difference is h² times third derivatives, of arms at 400 rad/s.
        assert rate == pytest.approx(booked, abs=1e-5 * (abs(work.thrust) + abs(work.arm) + 1.0))


def test_terminal_velocity() -> None:
    """Falling for long, rotors off and level: D v + c v² = m g, approached from both sides."""
    for faster in (0.5, 1.5):
        craft = models.compliant_craft(slides=False)
        wall = models.Wall(np.array([-1.0, 0.0, 0.0]), -models.FAR)
        scene = models.Scene(craft, wall, (0.0,) * len(craft.arms))
        d, c, weight = 4.0, 0.5, craft.mass * 9.81
        terminal = (math.sqrt(d * d + 4.0 * c * weight) - d) / (2.0 * c)
        start = models.Start(
            np.zeros(3), models.quaternion(0.0, 0.0, 0.0), np.array([0.0, 0.0, -faster * terminal]),
            np.zeros(3), np.full(4, 0.19), np.zeros(4),
        )  # fmt: skip
        air = Air(ZERO, Vec(0.3, 0.4, d), c, ZERO)
        # Time constant m / (D + 2 c v) is 0.28 s; e^−18 of the difference is left at the end.
        flown = flown_in(air, scene, start, until=5.0, impact_step=2e-2, hybrid=True)
        assert flown.motion.state.velocity.z == pytest.approx(-terminal, rel=1e-7)
        assert flown.motion.state.velocity.x == pytest.approx(0.0, abs=1e-12)
        assert abs(measures_of(flown)["ledger_residual"] or 0.0) < 1e-6


def test_linear_drag_slows_down_exponentially() -> None:
    """Level and without weight: v = v₀ e^(−D t / m), each axis with its own D."""
    craft = models.compliant_craft(slides=False)
    wall = models.Wall(np.array([-1.0, 0.0, 0.0]), -models.FAR)
    scene = models.Scene(craft, wall, (0.0,) * len(craft.arms), gravity=0.0)
    start = models.Start(
        np.zeros(3), models.quaternion(0.0, 0.0, 0.0), np.array([2.0, -1.0, 0.5]),
        np.zeros(3), np.full(4, 0.19), np.zeros(4),
    )  # fmt: skip
    d = np.array([0.3, 0.5, 0.7])
    flown = flown_in(Air(ZERO, models.vec(d), 0.0, ZERO), scene, start, until=1.0, impact_step=1e-2)
    expected = start.velocity * np.exp(-d / craft.mass)
    np.testing.assert_allclose(flown.motion.state.velocity, expected, rtol=1e-9)
    assert flown.motion.work.air == pytest.approx(
        0.5 * craft.mass * (start.velocity @ start.velocity - expected @ expected), rel=1e-9
    )


def test_wind_is_a_moving_frame() -> None:
    """Galilei: flight in wind w is flight in still air seen from a frame that moves with −w."""
    for seed in range(2):
        scene, start = random_instant(seed)
        wind = np.array(DRAG.wind)
        how: dict[str, Any] = {"until": 0.01, "impact_step": 1e-4}
        calm = flown_in(in_wind(DRAG, ZERO), scene, start, **how)
        windy = flown_in(DRAG, scene, replace(start, velocity=start.velocity + wind), **how)
        a, b = calm.motion.state, windy.motion.state
        # RK4 is the same in both frames but for the rounding of larger numbers.
        np.testing.assert_allclose(np.array(b.velocity) - wind, a.velocity, rtol=0, atol=1e-11)
        np.testing.assert_allclose(
            np.array(b.position) - 0.01 * wind, a.position, rtol=0, atol=1e-11
        )
        np.testing.assert_allclose(leaves(b.attitude), leaves(a.attitude), rtol=0, atol=1e-11)
        np.testing.assert_allclose(b.arm_length, a.arm_length, rtol=0, atol=1e-11)
        assert windy.motion.work.air != pytest.approx(calm.motion.work.air, rel=1e-3)


def test_air_without_drag_is_still_air_to_the_bit() -> None:
    """Whatever the wind."""
    nothing = Air(DRAG.wind, ZERO, 0.0, ZERO)
    for seed in range(5):
        scene, start = random_instant(seed)
        a, b = rates_in(Still(0.0), scene, start), rates_in(nothing, scene, start)
        assert leaves(a) == leaves(b)
    assert in_wind(Still(0.0), DRAG.wind) == Still(0.0)


def test_on_a_slider_only_drag_along_it_counts() -> None:
    """A gust across the rail moves nothing."""
    model, start = windy_impact("model.slider=[1.0, 0.0, 0.0]")
    seen = []
    for wind in (Vec(2.0, 0.0, 0.0), Vec(2.0, 7.0, 0.0)):
        air = Air(wind, Vec(0.3, 0.3, 0.3), 0.0, ZERO)
        known = rates(model._replace(air=air), start, 0.0)
        seen.append(known.motion.state.velocity)
    assert seen[0].x == pytest.approx(seen[1].x, rel=1e-12)
    assert seen[0].x == pytest.approx(0.3 * (2.0 - start.velocity.x) / model.airframe.mass)
    assert seen[0].y == seen[1].y == 0.0


# -- flights of scenarios --------------------------------------------------------------------------

WINDY = {
    "wind": [-3.0, 2.0, 0.5],
    "rotor_drag": [0.3, 0.2, 0.1],
    "thrust_drag": [0.01, 0.01, 0.0],
    "body_drag": 0.02,
}


def windy_impact(*overrides: str) -> tuple[Any, Any]:
    """Model and start of an impact in wind."""
    scenario = as_scenario(
        {
            "vehicle": "arq",
            "world": {"obstacles": [{"type": "wall", "distance": 1.0, "surface": "wall"}]},
            "start": {"position": [0.68, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0]},
            "thrust": "hover",
            "air": WINDY,
            "simulation": {"duration": 0.1, "impact_step": 2e-4},
        },
        overrides,
    )
    return scenario.flight_model(), scenario.start_state()


def test_the_ledger_closes_with_air() -> None:
    """Through an impact, with a share of the air that would be missed."""
    model, start = windy_impact("start.pitch=0.1", "start.yaw=0.3")
    measures = measures_of(fly_one(model, start, trace=False, executor="python"))
    loss, energy = measures["loss_air"], measures["energy_start"]
    assert loss is not None
    assert energy is not None
    assert measures["contacts"]
    assert abs(loss) > 1e-2 * energy
    assert abs(measures["ledger_residual"] or 0.0) < 1e-6


def test_rare_events_keep_what_the_air_took() -> None:
    """Arms that are locked, and impulses of a wall, book nothing of the air's."""
    model, start = windy_impact(
        'world.obstacles[0].surface={law="impulse", restitution=0.5}',
        "vehicle.arms.compliant=false",
    )
    known = Motion(start, still_work()._replace(air=3.0))
    assert settled_motion(model, known).work.air == 3.0
    at_the_wall = start._replace(position=Vec(0.7557, 0.0, 1.0))
    hit = apply_impulses(
        model.airframe, model.world, model.contact_point, model.guide,
        known._replace(state=at_the_wall),
    )  # fmt: skip
    assert hit.work.contact > 0.1
    assert hit.work.air == 3.0


def test_plain_python_is_the_compiled_air() -> None:
    """Force, power and gusts, to the bit."""

    def both(air: Any, weather: Any, noise: Any, more: Any, velocity: Any, r: Any) -> Any:
        begun = first_gust(weather, noise)
        then = gust(weather, more, begun.memory)
        blowing = in_wind(air, then.velocity)
        return then.velocity, aerodynamics(blowing, velocity, r, 12.0)

    compiled = numba.njit(both)
    rng = np.random.default_rng(23)
    settings = AirSettings(**WINDY, gusts={"wind_at_6_m": 7.7})
    for air, weather in (
        (settings.air(), settings.turbulence(0.002)),
        (Still(0.0), NoGusts(0.0)),
        (DRAG, NoGusts(0.0)),
    ):
        for seed in range(5):
            start = random_instant(seed)[1]
            r = rotation(models.state_of(start).attitude)
            given = (
                tuple(map(float, rng.normal(size=5))), tuple(map(float, rng.normal(size=3))),
                models.vec(start.velocity), r,
            )  # fmt: skip
            assert leaves(both(air, weather, *given)) == leaves(compiled(air, weather, *given))


# -- what a user writes ----------------------------------------------------------------------------

BASE: dict[str, Any] = {"vehicle": "arq", "start": {"position": [0.0, 0.0, 1.0]}}


@pytest.mark.parametrize(
    ("tables", "said"),
    [
        ({"air": {"wind": [1, 0, 0]}}, "air.wind: has no effect without rotor_drag"),
        ({"air": {"rotor_drag": [0.1, -0.1, 0]}}, "air.rotor_drag: must be at least 0 N s/m each"),
        ({"air": {"body_drag": "-1 g/cm"}}, "air.body_drag: must be at least 0 kg/m"),
        (
            {"air": {"body_drag": 0.1, "gusts": {"wind_at_6_m": 5}}},
            "air.gusts.airspeed: is missing; without mean wind",
        ),
        (
            {"air": {"wind": [5, 0, 0], "gusts": {"wind_at_6_m": 5, "altitude": 1}}},
            "air.gusts.altitude: must be at least 3.048 m (got 1 m)",
        ),
        ({"payload": {"mass": 0.2, "position": [0, 0, -0.1]}}, "payload.position: must be [0, 0, 0]"),
        ({"model_error": {"mass": 0.1}}, "model_error.mass: must be more than 0.142"),
        ({"model_error": {"inertia": 0.1}}, "model_error.inertia: must leave the main body"),
        ({"air": {"rotor_drag": [1e4, 0, 0]}}, "simulation.free_step: must be at most"),
    ],
)  # fmt: skip
def test_bad_air_is_refused_in_one_line(tables: dict[str, Any], said: str) -> None:
    with pytest.raises(InputError) as caught:
        scenario_from({**BASE, **tables})
    assert said in str(caught.value)


def test_without_words_on_air_it_is_still() -> None:
    """The paper's assumption 1."""
    assert scenario_from(BASE).flight_model().air == Still(0.0)
    assert AirSettings().turbulence(0.01) == NoGusts(0.0)
    model, _ = windy_impact()
    assert model.air == Air(Vec(-3.0, 2.0, 0.5), Vec(0.3, 0.2, 0.1), 0.02, Vec(0.01, 0.01, 0.0))
