"""Sensors without a pilot: what an inertial unit and the others would have measured in a throw."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import springback
from builders.cases import nonempty
from builders.impacts import towards_wall
from springback.errors import InputError
from springback.interfaces.figures.flight import flight_figure
from springback.results.flight import Flight
from springback.scenario.scenario import scenario_from
from springback.scenario.warnings import scenario_warnings

PERFECT = {name: {"perfect": True} for name in ("imu", "motion_capture", "hall")}


def thrown(sensors: Any = None, **more: Any) -> dict[str, Any]:
    """A turning vehicle that touches the wall after some milliseconds, with sensors or without."""
    start = {"touch_distance": "5 mm", "yaw": 0.7, "angular_velocity": [0.5, -1.0, 2.0]}
    tables = towards_wall(**start) | {"simulation": {"duration": 0.03}} | more
    return tables if sensors is None else tables | {"sensors": sensors}


@pytest.fixture(scope="module")
def flight() -> Flight:
    return springback.fly(thrown({}, seed=3))


def test_perfect_sensors_measure_the_truth() -> None:
    """Rates, pose and lengths at the ticks; the mean specific force over the tick before."""
    flight = springback.fly(thrown(PERFECT))
    c, d, t = flight.columns, flight.telemetry, flight.telemetry["t"]
    assert t == pytest.approx(np.arange(30) * 1e-3, abs=1e-12)
    pairs = [(f"imu_w{axis}", f"w{axis}", 1e-12) for axis in "xyz"]
    pairs += [(f"pose_{axis}", axis, 1e-7) for axis in "xyz"]
    pairs += [(f"hall{j}", f"l{j}", 1e-6) for j in range(1, 5)]
    for measured, true, error in nonempty(pairs):
        assert d[measured] == pytest.approx(np.interp(t, c["t"], c[true]), abs=error), measured
    felt = flight.specific_force()
    assert np.abs(felt).max() > 50.0
    for k, axis in enumerate("xyz"):
        spent = np.concatenate([[0.0], np.cumsum(np.diff(c["t"]) * (felt[1:, k] + felt[:-1, k]))])
        mean = np.diff(np.interp(t, c["t"], 0.5 * spent)) / 1e-3
        assert d[f"imu_a{axis}"][1:] == pytest.approx(mean, abs=0.4), axis


def test_a_pilot_with_constant_thrust_measures_the_same(flight: Flight) -> None:
    """Noise, biases, gaps and delays included: the same numbers to one count of the converter."""
    short = thrown({}, seed=3, simulation={"duration": 0.01})
    guided = springback.fly(
        short | {"thrust": 0.0}, pilot=lambda time, measurement, memory: ([0.0] * 4, memory),
        executor="python",
    )  # fmt: skip
    assert flight.telemetry.keys() < guided.telemetry.keys()
    count = 9.81 * 32.0 / 65536.0
    for name, values in flight.telemetry.items():
        least = 1.01 * count if name.startswith("imu_") else 1e-6
        assert values[:10] == pytest.approx(guided.telemetry[name], abs=least), name
        assert flight.units[name] == guided.units[name]


def test_readings_depend_on_the_seed_alone_and_change_no_flight(flight: Flight) -> None:
    again, other = springback.fly(thrown({}, seed=3)), springback.fly(thrown({}, seed=4))
    bare = springback.fly(thrown())
    assert not bare.telemetry
    for name, values in flight.telemetry.items():
        assert values.tobytes() == again.telemetry[name].tobytes(), name
    assert (flight.telemetry["imu_ax"] != other.telemetry["imu_ax"]).any()
    for name, values in bare.columns.items():
        assert values.tobytes() == flight.columns[name].tobytes(), name


def test_the_range_of_an_accelerometer_clips_an_impact() -> None:
    narrow = {"imu": {"accelerometer": {"full_scale": "2 g_0", "noise": 0.0, "bandwidth": "1 MHz"}}}
    measured = springback.fly(thrown(narrow)).telemetry["imu_ax"]
    assert measured.min() == pytest.approx(-2.0 * 9.80665, rel=1e-9)


def test_a_slow_clock_has_fewer_ticks() -> None:
    flight = springback.fly(thrown(PERFECT, clock=500.0))
    assert len(flight.telemetry["t"]) == 15
    assert flight.telemetry["pose_x"][-1] == pytest.approx(
        np.interp(0.028, flight.t, flight.columns["x"]), abs=1e-6
    )


def test_files_and_figures_hold_them(flight: Flight, tmp_path: Path) -> None:
    """As of a flight without a pilot."""
    flight.save(tmp_path / "saved", figures=False)
    loaded = springback.load(tmp_path / "saved")
    assert loaded.telemetry.keys() == flight.telemetry.keys()
    assert not loaded.is_piloted
    even = loaded.resample(1e-3)
    assert even["imu_ax"][:30] == pytest.approx(flight.telemetry["imu_ax"], abs=0.0)
    labels = [axes.get_ylabel() for axes in flight_figure(flight).axes]
    assert labels[:1] == ["Position [mm]"]
    assert flight.plot("imu_ax") is not None


def test_sensors_that_do_not_fit_the_clock_are_refused_in_one_line() -> None:
    with pytest.raises(InputError, match=r"^sensors\.imu\.rate: must divide the clock's rate") as e:
        scenario_from(thrown({"imu": {"rate": 700.0}}))
    assert len(e.value.problems) == 1


def test_nothing_of_the_sensors_is_called_unused() -> None:
    said = scenario_warnings(scenario_from(thrown({}, seed=3, clock=500.0, control={})))
    assert len(said) == 1
    assert said[0].startswith("control is not used")
    assert len(scenario_warnings(scenario_from(thrown(seed=3, clock=500.0)))) == 2
