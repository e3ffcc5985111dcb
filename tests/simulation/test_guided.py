"""The loop over the ticks: twins, lanes, slices, noise, and the physics of a flight with a pilot."""

import math
from typing import Any

import numpy as np
import pytest

import springback
from builders.cases import nonempty
from builders.guided_flights import (
    AT_WALL,
    GUSTY,
    HOLD,
    WALL,
    Lane,
    fly_in_lanes,
    lane,
    ready,
    same,
    tables,
)
from springback.control.mixing import mixer
from springback.control.rate import inertia_at
from springback.simulation import guided
from springback.simulation.guided import GuidedFlown, fly_guided
from springback.simulation.noise import noise_table
from springback.simulation.onboard import Draw

VARIANTS: dict[str, dict[str, Any]] = {
    "sensors and Kalman filter, into a wall": {
        "estimator": "kalman",
        "world": WALL,
        "start": AT_WALL,
        # What was sampled at one tick arrives at another at which nothing is sampled.
        "sensors": {"motion_capture": {"delay": 0.007}, "hall": {"delay": 0.007}},
    },
    "gusts and drag": {"air": GUSTY, "start": {"position": (0.0, 0.0, 1.0)}},
}


@pytest.mark.parametrize("variant", VARIANTS.values(), ids=VARIANTS.keys())
def test_plain_python_is_the_compiled_flight(variant: dict[str, Any]) -> None:
    """Motion, record, on-board systems, trajectory and telemetry, bit for bit."""
    flight = ready(tables(0.05, **variant))
    plain, compiled = fly_guided(*flight, executor="python"), fly_guided(*flight)
    assert plain.flown.record.contacts.total >= (1.0 if "world" in variant else 0.0)
    assert same(plain, compiled)
    for one, other in (
        (plain.flown.trace, compiled.flown.trace),
        (plain.telemetry, compiled.telemetry),
    ):
        assert one is not None
        assert other is not None
        assert np.array_equal(one.values, other.values)


def test_allocation_knows_the_arms_as_they_are_read() -> None:
    """Mixer and inertia are kept until a length changes, and then are those of the new lengths."""
    flight = ready(tables(0.05, "kalman", world=WALL, start=AT_WALL))
    flown = fly_guided(*flight, trace=False)
    airframe = flight.flight.avionics.systems.pilot.airframe
    lengths, built = flown.onboard.measurement.arm_length, flown.onboard.pilot.autopilot.built.tree
    assert min(lengths) < min(arm.length for arm in airframe.arms) - 5e-4
    assert built.mixer == mixer(airframe, lengths)
    assert built.inertia == inertia_at(airframe, lengths)


# -- many flights ---------------------------------------------------------------------------------


def fleet() -> list[Lane]:
    """Six flights that reach the wall one after the other, each with its own noise; two never."""
    speeds = (2.0, 1.0, 3.0, 0.0, 1.5, -0.5)
    return [
        lane(tables(0.2, world=WALL, air=GUSTY, start={**AT_WALL, "velocity": (v, 0.0, 0.0)}), k)
        for k, v in enumerate(speeds)
    ]


@pytest.fixture(scope="module")
def alone() -> list[GuidedFlown]:
    return [fly_guided(*flight.alone, trace=False) for flight in fleet()]


@pytest.mark.parametrize("options", [{"width": 1}, {"width": 4, "threads": 1}, {"width": 4}])
def test_a_flight_in_lanes_is_the_flight_alone(
    options: dict[str, int], alone: list[GuidedFlown]
) -> None:
    """Whatever flies beside it, on whatever thread, and with lanes to spare."""
    assert {flown.flown.record.contacts.total > 0.0 for flown in alone} == {True, False}
    for one, other in zip(alone, fly_in_lanes(fleet(), **options), strict=True):
        assert same(one, other)


def test_the_order_does_not_matter(alone: list[GuidedFlown]) -> None:
    order = [3, 5, 0, 4, 1, 2]
    flights = fleet()
    for k, flown in nonempty(
        zip(order, fly_in_lanes([flights[k] for k in order], width=4), strict=True)
    ):
        assert same(flown, alone[k])


# -- slices, logs and noise -----------------------------------------------------------------------


def test_interrupted_and_continued_is_the_same_flight(monkeypatch: pytest.MonkeyPatch) -> None:
    """A full log, or a look at the keyboard, in the middle of a tick or between ticks."""
    flight = ready(tables(0.1, world=WALL, start=AT_WALL))
    whole, untraced = fly_guided(*flight), fly_guided(*flight, trace=False)
    assert same(whole, untraced)
    for rows, ticks in ((7, 2_000), (4_096, 3), (5, 4)):
        monkeypatch.setattr(guided, "LOG_ROWS", rows)
        monkeypatch.setattr(guided, "TICKS", ticks)
        pieces = fly_guided(*flight)
        assert same(whole, pieces)
        assert whole.flown.trace is not None
        assert pieces.flown.trace is not None
        assert np.array_equal(whole.flown.trace.values, pieces.flown.trace.values)
        assert whole.telemetry is not None
        assert pieces.telemetry is not None
        assert np.array_equal(whole.telemetry.values, pieces.telemetry.values)


def test_luck_depends_on_seed_and_flight_alone() -> None:
    """The same again; another for another seed or flight; not on how long the flight is."""
    draws = (Draw(7, 1), Draw(19, 1))
    table = noise_table(4, 2, 300, draws)
    assert np.array_equal(table, noise_table(4, 2, 300, draws))
    assert np.array_equal(table[:101], noise_table(4, 2, 101, draws))
    others = [noise_table(*key, 300, draws) for key in ((5, 2), (4, 3), (2, 4))]
    for other in others:
        assert abs(np.corrcoef(table.ravel(), other.ravel())[0, 1]) < 4.0 / math.sqrt(table.size)
    assert abs(table.mean()) < 4.0 / math.sqrt(table.size)
    assert table.std() == pytest.approx(1.0, abs=4.0 / math.sqrt(2.0 * table.size))


def test_each_device_has_its_own_luck_at_its_own_pace() -> None:
    """A number is drawn when it is taken, whatever other devices there are."""
    table = noise_table(4, 2, 302, (Draw(3, 5), Draw(4, 1), Draw(2, 0)))
    quiet = np.arange(302) % 5 > 0
    assert not table[quiet, :3].any()
    assert table[~quiet, :3].all()
    assert table[:, 3:7].all()
    assert not table[:, 7:].any()
    without = noise_table(4, 2, 302, (Draw(3, 0), Draw(4, 1), Draw(2, 1)))
    assert np.array_equal(table[:, 3:7], without[:, 3:7])
    shared = np.corrcoef(table[~quiet, :7].T)[:3, 3:]
    assert np.abs(shared).max() < 4.0 / math.sqrt(len(table[~quiet]))


@pytest.mark.parametrize("perfect", ["motion_capture", "imu", "hall"])
def test_numbers_that_are_not_drawn_are_not_taken(perfect: str) -> None:
    """A flight is the same with other numbers in place of the zeros."""
    sensors = {"motion_capture": {"rate": 100}, "imu": {"rate": 500}, "hall": {"rate": 50}}
    sensors[perfect] |= {"perfect": True}
    given = ready(tables(0.06, "kalman", sensors=sensors))
    full = np.where(given.noise == 0.0, 3.0, given.noise)
    assert np.count_nonzero(full - given.noise) > 100
    flights = [
        fly_guided(given.flight, noise, trace=False, executor="python")
        for noise in (given.noise, full)
    ]
    assert same(*flights)


def test_biases_and_first_gust_depend_on_seed_and_flight_alone() -> None:
    """Not on the length of the flight; a campaign's flight 17 is that flight by itself."""
    long, short = (ready(tables(t, air=GUSTY), 17).flight.avionics for t in (2.0, 0.1))
    assert long == short
    other = ready(tables(0.1, air=GUSTY), 16).flight.avionics
    assert other.systems.sensors != short.systems.sensors


# -- what a pilot may know ------------------------------------------------------------------------


@pytest.mark.parametrize("estimator", ["kalman", "complementary"])
def test_the_truth_beside_the_measurements_changes_nothing(
    estimator: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Neither estimator nor controller peeps: with zeros in place of the truth, the same flight.

    Was: the start of the first flight of a process, where that one was shown the truth.
    """
    monkeypatch.setattr("springback.simulation.guided._UNREAD", {})
    shown, blind = (
        fly_guided(*ready(tables(0.3, estimator, sensors={"reveal": reveal})))
        for reveal in (True, False)
    )
    assert blind.onboard.measurement.exact.position == (0.0, 0.0, 0.0)
    assert shown.onboard.measurement.exact.position != (0.0, 0.0, 0.0)
    assert blind.flown.motion == shown.flown.motion
    assert blind.onboard.pilot == shown.onboard.pilot
    assert blind.onboard.command == shown.onboard.command


# -- physics --------------------------------------------------------------------------------------


def test_energy_balances_through_a_guided_impact() -> None:
    """Rotors put work in tick by tick, the wall and the arms take some: the ledger closes."""
    flight = springback.fly(tables(0.5, "kalman", world=WALL, start=AT_WALL))
    assert flight.contacts is not None
    assert flight.contacts >= 1.0
    residual, work = flight.measures["ledger_residual"], flight.measures["work_thrust"]
    assert residual is not None
    assert work is not None
    assert abs(residual) < 1e-6
    assert abs(work) > 0.1


@pytest.mark.parametrize("vehicle", ["arq", "quad"])
def test_a_perfect_hover_stays_put(vehicle: str) -> None:
    """To 1 mm and 0.01 deg over ten seconds: nothing pushes it."""
    place = (0.3, -0.2, 1.5)
    given = tables(10.0, reference={**HOLD, "position": place}, vehicle=vehicle)
    flight = springback.fly(given | {"start": {"position": place}})
    for axis, at in zip("xyz", place, strict=True):
        assert np.abs(flight.columns[axis] - at).max() < 1e-3
    assert flight.columns["qw"].min() > math.cos(0.5 * math.radians(0.01))


def test_a_hover_with_sensors_stays_near() -> None:
    """What the sensors leave is a few millimetres, and not nothing."""
    given = tables(5.0, "kalman", reference={**HOLD, "position": (0.0, 0.0, 1.0)})
    flight = springback.fly(given | {"start": {"position": (0.0, 0.0, 1.0)}})
    away = np.sqrt(sum((flight.columns[a] - b) ** 2 for a, b in zip("xyz", (0, 0, 1), strict=True)))
    assert 1e-4 < away.max() < 0.02


def test_a_mirrored_flight_is_the_mirrored_flight() -> None:
    """Y and −Y are alike to robot, wall and pilot: nothing in the loop knows left from right.

    Quad, whose inertia is diagonal; mixing and quaternions round differently, so not to the last
    bit, and an impact multiplies roundings.
    """
    ends = []
    for sign in (1.0, -1.0):
        start = {
            "position": (0.69, 0.0, 1.0),
            "velocity": (1.5, 0.4 * sign, 0.1),
            "roll": -0.1 * sign,
        }
        aim = {"type": "hold", "position": (0.2, 0.3 * sign, 1.1)}
        ends.append(
            springback.fly(tables(0.6, vehicle="quad", world=WALL, start=start, reference=aim))
        )
    one, other = ends
    assert one.contacts is not None
    assert one.contacts >= 1.0
    for name in ("x", "vx", "z", "vz", "wy"):
        assert one.columns[name][-1] == pytest.approx(other.columns[name][-1], abs=1e-7)
    for name in ("y", "vy", "wx", "wz"):
        assert one.columns[name][-1] == pytest.approx(-other.columns[name][-1], abs=1e-7)
