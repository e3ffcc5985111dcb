"""Rotors that stop in flight: what the body feels of it, and where it is written down."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import springback
from builders.impacts import value
from springback.batch.scenarios import fly_scenarios
from springback.vehicle.library import VEHICLES

QUAD = VEHICLES["quad"].vehicle
HOVER = QUAD.mass * 9.81 / 4.0  # [N]
J, K = 3e-5, 8e-6  # inertia of a rotor [kg m²] and thrust coefficient [N s²/rad²], chosen


def hover(time: float, measurement: Any, memory: Any) -> tuple[tuple[float, ...], None]:
    return (HOVER,) * 4, None


def onto_a_post(rotor: int = 1, **stop: Any) -> dict[str, Any]:
    """Robot that sinks onto a thin upright post, which goes through the middle of one cage."""
    arm = QUAD.airframe().arms[rotor - 1]
    x, y = arm.length * arm.cosine, arm.length * arm.sine
    post = {
        "type": "capsule", "start": [x, y, -2.0], "end": [x, y, 0.395], "radius": 0.005,
        "surface": "wall",
    }  # fmt: skip
    return {
        "vehicle": {"preset": "quad", "propulsion": {"disk_radius": 0.08, "stop": stop}},
        "world": {"obstacles": [post]},
        "start": {"position": [0.0, 0.0, 0.45], "velocity": [0.0, 0.0, -1.0]},
        "simulation": {"duration": 0.08},
    }


def into_a_wall(**stop: Any) -> dict[str, Any]:
    """Collision of the compliant robot, whose guards stop its rotors."""
    return {
        "vehicle": {"preset": "arq", "propulsion": {"disk_radius": 0.08, "stop": stop}},
        "reference": {"type": "run-up", "speed": 2.0},
        "recovery": {},
        "world": {"obstacles": [
            {"type": "wall", "distance": 2.75, "surface": "wall"},
            {"type": "ground", "surface": "wall"},
        ]},
        "simulation": {"duration": 3.0},
    }  # fmt: skip


@pytest.mark.parametrize("rotor", [1, 2])
def test_a_struck_rotor_stops_and_its_angular_momentum_goes_to_the_body(rotor: int) -> None:
    """Beside the same flight with weightless rotors, ω_z differs by J Ω / I_zz after one tick."""
    light = springback.fly(onto_a_post(rotor, spin_down=0.0), pilot=hover)
    heavy = springback.fly(
        onto_a_post(rotor, spin_down=0.0, rotor_inertia=J, thrust_coefficient=K), pilot=hover
    )
    for flight in (light, heavy):
        assert flight.measures["rotors_stopped"] == 1.0
        assert flight.measures["contacts"] == 0.0
        stop = value(flight, "rotor_stop_time")
        assert stop == pytest.approx(value(flight, "propeller_hit_time"), abs=1.1e-3)
        row = np.searchsorted(flight.telemetry["t"], stop + 1e-9)
        assert flight.telemetry[f"thrust{rotor}"][row] < 1e-12
        assert (flight.telemetry["command1"] == HOVER).all()
        (event,) = [event for event in flight.events if event.kind == "rotor"]
        assert event.t == stop
        assert event.text.startswith(f"rotor {rotor} stops")
        assert abs(value(flight, "ledger_residual")) < 1e-6
    after = stop + 1e-3
    spins = [np.interp(after, f.t, f.columns["wz"]) for f in (light, heavy)]
    sign = math.copysign(1.0, QUAD.airframe().arms[rotor - 1].torque_ratio)
    gained = -sign * J * math.sqrt(HOVER / K) / QUAD.inertia()[2, 2]
    assert spins[1] - spins[0] == pytest.approx(gained, rel=1e-3)


def test_events_name_each_rotor_that_stops() -> None:
    """The first when the measure says, whether it breaks or not, and the others after it."""
    for stop in ({"disc": "break"}, {"others_after": "10 ms"}):
        flight = springback.fly(onto_a_post(2, **stop), pilot=hover)
        told = [event for event in flight.events if event.kind == "rotor"]
        assert len(told) == flight.measures["rotors_stopped"] == (1 if "disc" in stop else 4)
        assert told[0].t == value(flight, "rotor_stop_time")
        assert told[0].text.startswith("rotor 2 stops")
        assert ("breaks" in told[0].text) == ("disc" in stop)
        later = {event.label for event in told[1:]}
        assert later == (set() if "disc" in stop else {"rotor 1", "rotor 3", "rotor 4"})
        assert all(event.t == pytest.approx(told[0].t + 0.01) for event in told[1:])


def test_accelerations_away_from_the_centre_know_of_it() -> None:
    """Angular acceleration by the equations is that of the recorded rates, in ticks of a stop."""
    given = onto_a_post(spin_down="5 ms", rotor_inertia=J, thrust_coefficient=K)
    given["simulation"] |= {"free_step": 2e-4}
    flight = springback.fly(given, pilot=hover)
    at = 0.1
    lever = flight.specific_force([at, 0.0, 0.0]) - flight.specific_force()
    t, wz, wx, wy = flight.t, *(flight.columns[f"w{axis}"] for axis in "zxy")
    stop = value(flight, "rotor_stop_time")
    inside = np.flatnonzero((t[1:-1] > stop + 2e-4) & (t[1:-1] < stop + 0.012)) + 1
    whole = np.abs(t[inside] / 1e-3 - np.round(t[inside] / 1e-3)) > 0.1  # no kink at a tick
    inside = inside[whole]
    assert len(inside) > 30
    slope = (wz[inside + 1] - wz[inside - 1]) / (t[inside + 1] - t[inside - 1])
    expected = at * (slope + wx[inside] * wy[inside])
    assert np.abs(expected).max() > 1.0
    assert lever[inside, 1] == pytest.approx(expected, abs=2e-3 * np.abs(expected).max())


def test_limits_that_nothing_reaches_change_nothing() -> None:
    """The flight is that of rotors which do not stop, to the bit."""
    given = into_a_wall(disc="ignore", guard_force="100 kN")
    plain = into_a_wall()
    plain["vehicle"]["propulsion"]["stop"] = False
    with_limits, without = springback.fly(given), springback.fly(plain)
    assert with_limits.measures["rotors_stopped"] == 0.0
    assert without.measures["rotors_stopped"] is None
    for name in ("x", "z", "qw", "vz", "wy", "l1"):
        assert np.array_equal(with_limits.columns[name], without.columns[name]), name


def test_guards_at_the_wall_stop_their_rotors_others_follow_and_all_restart() -> None:
    """The two in front stop with the hit, those behind 40 ms later; then thrust comes back."""
    flight = springback.fly(into_a_wall(
        guard_force="20 N", others_after="40 ms", restart_after="0.1 s", rotor_inertia=J,
        thrust_coefficient=K,
    ))  # fmt: skip
    touch, t = value(flight, "touch_time"), flight.telemetry["t"]
    begins = [t[np.flatnonzero(np.diff(flight.telemetry[f"stopped{j}"]) != 0)[0]] for j in (1, 3)]
    assert begins[0] - touch < 2.5e-3
    stands = [flight.telemetry[f"stopped{j}"] for j in (1, 2, 3, 4)]
    first = [float(s[s >= 0.0].min()) for s in stands]
    front, behind = sorted(first)[:2], sorted(first)[2:]
    assert max(front) - touch < 3e-3
    assert min(behind) - min(front) == pytest.approx(0.04, abs=2e-3)
    assert all(s[-1] == -1.0 for s in stands)
    assert flight.measures["rotors_stopped"] == 4.0
    assert abs(value(flight, "ledger_residual")) < 1e-6


def test_many_flights_stop_as_each_does_alone() -> None:
    """Lanes and single flights agree to the bit, and the rows have the columns."""
    stop = {"guard_force": 20.0, "restart_after": 0.2, "others_after": 0.04}
    tables = [into_a_wall(**stop) | {"seed": k, "start": {"yaw": 0.02 * k}} for k in range(6)]
    rows = fly_scenarios(tables)
    for name in ("rotors_stopped", "rotor_stop_time", "peak_acceleration", "energy_end"):
        alone = [springback.fly(table, trajectory=False).measures[name] for table in tables]
        single = [math.nan if one is None else one for one in alone]
        assert np.array_equal(rows.measures[name], single, equal_nan=True), name
    assert rows.measures["rotors_stopped"].max() >= 2.0


def test_an_impulse_hits_a_guard_whatever_its_limit() -> None:
    """The impulse law knows no force: what it strikes stops."""
    given = into_a_wall(guard_force="1 MN")
    for obstacle in given["world"]["obstacles"]:
        obstacle["surface"] = {"law": "impulse", "restitution": 0.5, "friction": 0.3}
    assert value(springback.fly(given), "rotors_stopped") >= 2.0
