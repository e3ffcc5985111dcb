"""What a flight is remembered by: closed forms, contacts one by one, and the trajectory itself."""

from __future__ import annotations

import math

import numpy as np
import pytest

from builders.impacts import flown, towards_wall, value
from builders.scenes import FACE, approaching, one_arm, surface
from springback.results.flight import as_scenario, fly
from springback.simulation.flight import fly_one
from springback.simulation.measuring.measures import MEASURES, Outcome, measures_of


def test_linear_spring_has_a_closed_form() -> None:
    """m on k at v: contact π√(m/k), peak v√(k/m), travel v√(m/k), impulse 2 m v, restitution 1."""
    m, k, v = 1.5, 2e4, 2.0
    spring = surface(stiffness=k, exponent=1.0)
    flight = fly_one(one_arm(FACE, spring, mass=m), approaching(v, 1e-3), executor="python")
    measured = measures_of(flight)
    root = math.sqrt(k / m)
    assert measured["touch_time"] == pytest.approx(1e-3 / v, rel=1e-9)
    assert measured["contact_time"] == pytest.approx(math.pi / root, rel=1e-6)
    assert measured["contact_duration"] == pytest.approx(math.pi / root, rel=1e-6)
    # Accelerations and forces peak between instants; what is read at instants misses the top by up
    # to (h ω / 2)² / 2.
    assert measured["peak_acceleration"] == pytest.approx(v * root, rel=1e-9)
    assert measured["travel"] == pytest.approx(v / root, rel=3e-5)
    assert measured["penetration"] == pytest.approx(v / root, rel=3e-5)
    assert measured["peak_normal_force"] == pytest.approx(m * v * root, rel=1e-9)
    middle = 1e-3 / v + math.pi / root / 2
    assert measured["peak_acceleration_time"] == pytest.approx(middle, abs=1e-8)
    assert measured["impulse_x"] == pytest.approx(-2.0 * m * v, rel=1e-7)
    for name in ("at_separation", "at_return", "of_mass_centre"):
        assert measured[f"restitution_{name}"] == pytest.approx(1.0, abs=1e-7)
    assert measured["contacts"] == measured["impacts"] == 1.0


def test_kelvin_voigt_has_a_closed_form_until_it_would_pull() -> None:
    """A damped oscillator: the force ends at tan(ω t) = 2 ζ √(1−ζ²)/(2 ζ² − 1), before the gap opens."""
    m, k, b, v = 1.5, 2e4, 60.0, 2.0
    voigt = surface(stiffness=k, exponent=1.0, viscosity=b)
    flight = fly_one(one_arm(FACE, voigt, mass=m), approaching(v, 1e-3), executor="python")
    natural = math.sqrt(k / m)
    zeta = b / (2.0 * math.sqrt(k * m))
    omega = natural * math.sqrt(1.0 - zeta**2)
    let_go = math.atan2(2.0 * zeta * math.sqrt(1.0 - zeta**2), 2.0 * zeta**2 - 1.0) / omega
    decay = math.exp(-zeta * natural * let_go)
    leaving = v * decay * (
        math.cos(omega * let_go) - zeta * natural / omega * math.sin(omega * let_go)
    )  # fmt: skip
    measured = measures_of(flight)
    # Where the force ends it has a kink; the step across it is of a lower order.
    assert measured["restitution_at_separation"] == pytest.approx(-leaving / v, abs=1e-5)
    assert abs(measured["ledger_residual"] or 0.0) < 2e-5


def test_one_cage_is_counted_for_its_own_arm() -> None:
    """Yawed by 45° to the left, the front right arm alone hits; to the right, the front left."""
    for yaw, arm in ((45.0, 2), (-45.0, 1)):
        scenario = as_scenario(towards_wall(yaw=f"{yaw} deg"))
        record = fly_one(scenario.flight_model(), scenario.start_state(), trace=False).record
        assert record.contacts.total == 1.0
        assert record.contacts.arms == tuple(1.0 if j == arm else 0.0 for j in (1, 2, 3, 4))


def test_two_cages_together_are_one_contact_each() -> None:
    """Head-on both front cages touch at once: one contact of the vehicle, one of each cage."""
    scenario = as_scenario(towards_wall())
    record = fly_one(scenario.flight_model(), scenario.start_state(), trace=False).record
    assert record.contacts.arms == (1.0, 1.0, 0.0, 0.0)
    assert (record.contacts.total, record.contacts.impacts) == (1.0, 1.0)


def touches(forces: np.ndarray) -> int:
    """Number of times that a force begins."""
    on = forces > 0.0
    return int(on[0]) + int(np.count_nonzero(on[1:] & ~on[:-1]))


@pytest.mark.parametrize("tilt", ["-50 deg", "-35 deg", "45 deg", "60 deg"])
def test_repeated_contacts_are_counted_one_by_one(tilt: str) -> None:
    """A tilted vehicle chatters on the wall; the trajectory's own count is the record's."""
    flight = flown("arq", speed=3.0, position=[0.6, 0.0, 0.0], pitch=tilt, yaw="20 deg")
    pressed = np.stack([flight.columns[f"fn{part}"] for part in (1, 2, 3, 4, "_body")])
    assert value(flight, "contacts") == touches(pressed.max(axis=0))
    assert value(flight, "contacts") >= 2.0
    assert 1.0 <= value(flight, "impacts") <= value(flight, "contacts")


def test_contacts_within_the_dwell_time_are_one_impact() -> None:
    """The same flight has fewer impacts when the dwell time is long."""
    tables = towards_wall("quad", 3.0, position=[0.6, 0.0, 0.0], pitch="45 deg", yaw="20 deg")
    short, long = fly(tables, "simulation.dwell=0.1 ms"), fly(tables, "simulation.dwell=1 s")
    assert value(long, "impacts") == 1.0
    assert value(short, "impacts") > 1.0
    assert short.contacts == long.contacts


def test_restitution_is_named_where_it_is_read() -> None:
    """At separation, at return, and of the mass centre: three readings of one trajectory."""
    flight = flown("arq", yaw="45 deg")
    t, x, vx = flight.t, flight.columns["x"], flight.columns["vx"]

    def at(instant: float, column: np.ndarray) -> float:
        return float(column[np.argmin(np.abs(t - instant))])

    speed = value(flight, "touch_speed")
    assert speed == pytest.approx(2.0)
    left, back = value(flight, "separation_time"), value(flight, "return_time")
    assert -at(left, vx) / speed == pytest.approx(value(flight, "restitution_at_separation"))
    assert -at(back, vx) / speed == pytest.approx(value(flight, "restitution_at_return"))
    assert at(back, x) == pytest.approx(at(value(flight, "touch_time"), x), abs=1e-6)
    # No force acts on the whole after separation, so its mass centre keeps this speed for good.
    of_all = -value(flight, "impulse_x") / flight.scenario.vehicle.mass - speed
    assert value(flight, "restitution_of_mass_centre") == pytest.approx(of_all / speed, rel=1e-6)
    readings = {
        round(value(flight, f"restitution_{name}"), 6)
        for name in ("at_separation", "at_return", "of_mass_centre")
    }
    assert len(readings) == 3


def test_a_slow_return_is_still_a_return() -> None:
    """The main body may need longer to come back than the dwell time."""
    flight = flown("quad", "simulation.duration=0.5", "simulation.dwell=2 ms", pitch="26 deg")
    assert value(flight, "contacts") == 1.0
    assert value(flight, "return_time") > value(flight, "separation_time") + 0.01
    assert 0.0 < value(flight, "restitution_at_return") < 1.0


def test_trajectory_columns_and_units() -> None:
    """t, position, attitude, velocities, arms, acceleration, forces of each cage and the body."""
    flight = flown("arq")
    axes, arms = "xyz", range(1, 5)
    expected = ["t", *axes, *(f"q{c}" for c in "wxyz"), *(f"v{c}" for c in axes)]
    expected += [*(f"w{c}" for c in axes), *(f"l{j}" for j in arms), *(f"dl{j}" for j in arms)]
    expected += [*(f"a{c}" for c in axes)]
    columns = list(flight.columns)
    assert columns[: len(expected)] == expected
    parts = [*arms, "_body"]
    assert {f"{kind}{k}" for kind in ("fn", "ff") for k in parts} == set(columns[len(expected) :])
    assert set(flight.units) == set(columns)
    units = {"t": "s", "x": "m", "vx": "m/s", "wz": "rad/s", "l1": "m", "dl1": "m/s", "fn1": "N"}
    assert {name: flight.units[name] for name in units} == units
    assert all(len(values) == len(flight.t) for values in flight.columns.values())
    assert np.all(np.diff(flight.t) > 0.0)


def test_trajectory_and_measures_cannot_disagree() -> None:
    """Every peak is the peak of its column, or lies between two of its instants."""
    flight = flown("arq", yaw="30 deg", pitch="20 deg", angular_velocity=[1.0, -2.0, 3.0])
    c = flight.columns

    def size(stem: str) -> np.ndarray:
        return np.asarray(np.linalg.norm([c[f"{stem}{axis}"] for axis in "xyz"], axis=0))

    arms = (1, 2, 3, 4)
    at_touch = np.argmin(np.abs(flight.t - value(flight, "touch_time")))
    lengths = np.stack([c[f"l{j}"] for j in arms])
    a, normal = size("a"), np.stack([c[f"fn{j}"] for j in arms]).max(axis=0)
    for values, name in ((a, "peak_acceleration"), (normal, "peak_normal_force")):
        top = values.argmax()
        below = values[top] - values[top - 1 : top + 2].min()
        assert 0.0 <= value(flight, name) - values[top] <= below / 8
    assert abs(value(flight, "peak_acceleration_time") - flight.t[a.argmax()]) <= 5e-5
    assert value(flight, "peak_angular_rate") == size("w").max()
    assert value(flight, "arm_stroke") == (0.19 - lengths).max()
    assert value(flight, "arm_extension") == max((lengths - 0.19).max(), 0.0)
    assert value(flight, "end_time") == flight.t[-1]
    assert value(flight, "steps") == len(flight.t) - 1
    if flight.impacts == 1.0:
        assert value(flight, "travel") == pytest.approx((c["x"] - c["x"][at_touch]).max())
    norm = sum(c[f"q{part}"] ** 2 for part in "wxyz")
    assert norm == pytest.approx(1.0, abs=1e-12)


def test_impulse_is_the_change_of_momentum() -> None:
    """m Δv of the mass centre equals the recorded impulse, in all directions."""
    flight = flown("quad", pitch="20 deg", yaw="10 deg")
    mass = flight.scenario.vehicle.mass
    for axis in "xyz":
        change = flight.columns[f"v{axis}"][-1] - flight.columns[f"v{axis}"][0]
        assert mass * change == pytest.approx(value(flight, f"impulse_{axis}"), abs=1e-9)


def test_every_measure_has_a_unit_and_a_meaning() -> None:
    """And each is a number or absent."""
    flight = flown("arq", "simulation.duration=0.01")
    assert list(flight.measures) == list(MEASURES)
    assert all(meaning for _, meaning in MEASURES.values())
    assert flight.outcome is Outcome.NO_CONTACT or flight.outcome is Outcome.IN_CONTACT


@pytest.mark.parametrize(
    ("duration", "outcome"),
    [(0.005, Outcome.NO_CONTACT), (0.045, Outcome.IN_CONTACT), (0.2, Outcome.SEPARATED)],
)
def test_outcome_follows_the_flight(duration: float, outcome: Outcome) -> None:
    """Before, during and after the impact."""
    assert flown("arq", f"simulation.duration={duration}").outcome is outcome
