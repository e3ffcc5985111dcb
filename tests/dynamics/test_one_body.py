"""A locked vehicle far from everything is one rigid body: the short way to the same motion."""

from __future__ import annotations

from types import ModuleType
from typing import Any

import numpy as np
import pytest

from springback.dynamics import clearance
from springback.dynamics.air import Air, Still
from springback.dynamics.energy import energy
from springback.dynamics.motion import rates
from springback.dynamics.rigid import (
    RigidState,
    flight_rates,
    rigid_body,
    rigid_step,
    runge_kutta_step,
)
from springback.kernels.trees import leaves
from springback.kernels.vectors import Quat, Vec
from springback.scenario.scenario import scenario_from
from springback.simulation import executor, stages
from springback.simulation.flight import fly_one
from springback.vehicle.state import State

WIND = Air(Vec(2.0, -1.0, 0.5), Vec(0.3, 0.2, 0.1), 0.05, Vec(0.01, 0.02, 0.0))


def scenario(**changes: object) -> dict[str, object]:
    return {
        "vehicle": "arq", "thrust": [3.0, 3.6, 3.3, 3.5],
        "start": {"velocity": [1.0, 0.5, 0.2], "angular_velocity": [0.5, -1.0, 2.0], "pitch": 0.3},
        "simulation": {"duration": 0.4}, **changes,
    }  # fmt: skip


@pytest.mark.parametrize("air", [Still(0.0), WIND], ids=["still", "wind"])
def test_one_body_has_the_rates_of_the_locked_vehicle(air: Still | Air) -> None:
    rng = np.random.default_rng(5)
    model = scenario_from(scenario()).flight_model()._replace(air=air)
    for _ in range(50):
        q = rng.normal(size=4)
        state = (
            scenario_from(scenario())
            .start_state()
            ._replace(
                attitude=Quat(*(float(x) for x in q / np.linalg.norm(q))),
                velocity=Vec(*map(float, rng.normal(size=3))),
                angular_velocity=Vec(*map(float, 5.0 * rng.normal(size=3))),
                arm_length=tuple(float(x) for x in rng.uniform(0.15, 0.19, 4)),
            )
        )
        whole = rates(model._replace(air=air), state, 0.0)
        body = rigid_body(model.airframe, state.arm_length, model.thrust, ())
        x = RigidState(
            state.position, state.attitude, state.velocity, state.angular_velocity, 0.0, 0.0
        )
        short = flight_rates(body, model.guide, air, model.world.gravity, x)
        s, w = whole.motion.state, whole.motion.work
        expected = [*s.position, *s.attitude, *s.velocity, *s.angular_velocity, w.thrust, w.air]
        np.testing.assert_allclose(leaves(short.flight), expected, rtol=1e-12, atol=1e-12)
        np.testing.assert_allclose(short.specific_force, whole.seen.specific_force, atol=1e-12)
        np.testing.assert_allclose(
            short.mass_centre_velocity, whole.seen.mass_centre_velocity, atol=1e-13
        )


def flown(step: Any, air: Still | Air, h: float) -> RigidState:
    """A fifth of a second under uneven thrusts, arms of uneven lengths: its mass centre is off."""
    ready = scenario_from(scenario())
    model, s = ready.flight_model(), ready.start_state()
    body = rigid_body(model.airframe, (0.15, 0.17, 0.19, 0.16), model.thrust, ())
    x = RigidState(s.position, s.attitude, s.velocity, s.angular_velocity, 0.0, 0.0)
    for _ in range(round(0.2 / h)):
        x = step(model.guide, air, body, model.world.gravity, x, h).flight
    return x


def test_a_step_about_the_mass_centre_is_one_of_fourth_order_to_the_same_end() -> None:
    """Against the general step, an order of magnitude finer: sixteenfold at twice the step."""
    air = Still(0.0)
    truth = np.array(leaves(flown(runge_kutta_step, air, 2e-4)))
    for step in (rigid_step, runge_kutta_step):
        off = [np.abs(np.array(leaves(flown(step, air, h))) - truth).max() for h in (4e-3, 2e-3)]
        assert off[0] < 1e-8
        assert off[0] / off[1] == pytest.approx(16.0, rel=0.1)


@pytest.mark.parametrize("air", [Still(0.0), WIND], ids=["still", "wind"])
def test_a_step_begins_with_what_is_seen(air: Still | Air) -> None:
    ready = scenario_from(scenario())
    model, s = ready.flight_model(), ready.start_state()
    body = rigid_body(model.airframe, (0.15, 0.17, 0.19, 0.16), model.thrust, ())
    x = RigidState(s.position, s.attitude, s.velocity, s.angular_velocity, 0.3, 0.2)
    known = rigid_step(model.guide, air, body, model.world.gravity, x, 1e-3).known
    expected = flight_rates(body, model.guide, air, model.world.gravity, x)
    np.testing.assert_allclose(leaves(known), leaves(expected), rtol=1e-12, atol=1e-12)


def test_the_rotors_work_is_the_energy_gained() -> None:
    ready = scenario_from(scenario())
    model, s = ready.flight_model(), ready.start_state()
    lengths = (0.15, 0.17, 0.19, 0.16)
    m = model.airframe
    locked = m._replace(
        arms=tuple(a._replace(length=x) for a, x in zip(m.arms, lengths, strict=True))
    )
    after = flown(rigid_step, Still(0.0), 1e-3)

    def total(x: RigidState | State) -> float:
        state = State(
            x.position, x.attitude, x.velocity, x.angular_velocity, lengths, (0.0,) * len(lengths)
        )
        e = energy(locked, model.world, model.contact_point, state)
        return float(e.kinetic + e.gravity + e.springs + e.stops)

    assert after.thrust_work > 1.0
    assert total(after) - total(s) == pytest.approx(after.thrust_work, rel=1e-9)


def test_a_flight_that_never_cruises_is_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    """Room for ever against no room at all: what differs is rounding."""
    ready = scenario_from(scenario())
    model, start = ready.flight_model(), ready.start_state()
    short = fly_one(model, start, executor="python")
    assert short.record.stepping.room != 0.0
    monkeypatch.setattr(clearance, "ROOM", 1e30)
    long = fly_one(model, start, executor="python")
    assert long.record.stepping.steps == short.record.stepping.steps
    np.testing.assert_allclose(leaves(short.motion), leaves(long.motion), rtol=1e-10, atol=1e-12)
    for name in ("acceleration", "specific_force", "angular_rate"):
        other = getattr(long.record.peaks, name)
        assert getattr(short.record.peaks, name) == pytest.approx(other, rel=1e-12)
    assert short.trace is not None
    assert long.trace is not None
    assert short.trace.values.shape == long.trace.values.shape


def test_a_flight_out_of_room_looks_about_and_cruises_on(monkeypatch: pytest.MonkeyPatch) -> None:
    """A look costs no step; only where something is near, or slides, is the flight steered."""
    told = {"clearance_check": 0, "record_with_loads": 0, "rates_within": 0}
    rooms = (executor, executor, stages)

    def counted(room: ModuleType, name: str) -> None:
        original = getattr(room, name)

        def counting(*given: object) -> object:
            told[name] += 1
            return original(*given)

        monkeypatch.setattr(room, name, counting)

    for room, name in zip(rooms, tuple(told), strict=True):
        counted(room, name)
    ground = {"type": "ground", "height": -1.0, "surface": "wall"}
    tables = scenario(world={"gravity": 0.0, "obstacles": [ground]}, thrust=0.0)
    ready = scenario_from({**tables, "start": {"velocity": [4.0, 0.0, 0.0]}})
    flown = fly_one(ready.flight_model(), ready.start_state(), executor="python")
    # It looks at first, and when twice its way is the gap of some 2 m; it is measured at its end.
    assert told["clearance_check"] == 2
    assert (told["record_with_loads"], told["rates_within"]) == (1, 4)  # one step, of four stages
    assert flown.record.stepping.steps == 400
    assert flown.motion.state.position.x == pytest.approx(1.6, rel=1e-12)


def test_the_last_steps_before_a_wall_are_taken_with_open_eyes() -> None:
    """However far away the flight begins, it meets the wall at the same speed, to the step."""
    hits = []
    for distance in (0.05, 1.0, 4.0):
        wall = {"type": "wall", "distance": distance + 0.3, "surface": "wall"}
        flown = fly_one(
            *(
                lambda ready: (ready.flight_model(), ready.start_state())
            )(
                scenario_from(
                    {
                        "vehicle": "quad", "thrust": 0.0,
                        "world": {"gravity": 0.0, "obstacles": [wall]},
                        "start": {"velocity": [2.0, 0.0, 0.0]},
                        "simulation": {"duration": distance / 2.0 + 0.1},
                    }
                )
            )
        )  # fmt: skip
        hits.append(flown.record)
    assert {h.contacts.total for h in hits} == {1.0}
    for other in hits[1:]:
        assert other.peaks.penetration == pytest.approx(hits[0].peaks.penetration, rel=1e-9)
        assert other.first_impact.separation_speed == pytest.approx(
            hits[0].first_impact.separation_speed, rel=1e-9
        )


def test_room_shrinks_no_slower_than_the_gap() -> None:
    """The room that a cruising flight counts on never exceeds the true distance of its cages."""
    ready = scenario_from(
        scenario(world={"obstacles": [{"type": "wall", "distance": 2.0, "surface": "wall"}]})
    )
    model, start = ready.flight_model(), ready.start_state()
    flown = fly_one(model, start)
    assert flown.trace is not None
    trace = flown.trace
    for k in range(0, len(trace.values), 20):
        row = dict(zip(trace.columns, map(float, trace.values[k]), strict=True))
        state = State(
            Vec(*(row[f"state.position.{a}"] for a in "xyz")),
            Quat(*(row[f"state.attitude.{a}"] for a in "wxyz")),
            Vec(*(row[f"state.velocity.{a}"] for a in "xyz")),
            Vec(*(row[f"state.angular_velocity.{a}"] for a in "xyz")),
            start.arm_length,
            start.arm_rate,
        )
        seen = rates(model, state, 0.0).seen
        told = min(row[f"arms.{j}.gap"] for j in range(1, 5))
        assert 0.0 < told <= min(arm.gap for arm in seen.arms) + 1e-12
