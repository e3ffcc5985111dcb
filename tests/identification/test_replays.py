"""Replays of recordings: of our own flights within the uncertainty, of wrong models beyond it."""

from __future__ import annotations

import csv
import json
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

from builders.recordings import GRAVITY, acceleration_at, attitude_at, rate_at, track_at
from springback.errors import InputError
from springback.identification.observations.channel_window import ChannelWindow
from springback.identification.observations.initial_state import InitialState
from springback.identification.observations.noise import white_noise
from springback.identification.replays.errors import (
    STROKE,
    TOUCH,
    ErrorRow,
    channel_errors,
    error_rows,
    verdict,
)
from springback.identification.replays.replay import Replay, ReplayOptions, replay
from springback.identification.replays.start import measured_start
from springback.identification.settings import FitSensors, StartFit
from springback.interfaces.cli.app import cli
from springback.logs.frame_turns import conjugate, product, rotation_vector, world_vectors
from springback.logs.reading import read_recording
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ATTITUDE,
    POSITION,
    ROTOR_COMMAND,
    ROTOR_SPEED,
    SPECIFIC_FORCE,
    Recording,
    SensorChain,
    log_channel,
)
from springback.logs.thrusts import lagged_thrusts, logged_thrusts
from springback.logs.writing.flight_recording import flight_recording
from springback.logs.writing.writers import write_recording
from springback.results.flight import fly
from springback.scenario.overrides import apply_overrides
from springback.scenario.scenario import scenario_from

SENSORS = {
    "imu": {"rate": "1 kHz", "accelerometer": {"noise": "0.022 m/s^2/Hz^0.5"}},
    "motion_capture": {"position_noise": "0.5 mm"},
}
WALL = {"type": "wall", "distance": "1 m", "surface": "wall"}
RIG: dict[str, Any] = {
    "name": "rig", "vehicle": "arq-slider", "model": {"slider": [1, 0, 0]}, "sensors": SENSORS,
    "start": {"position": ["0.25 m", 0, "1 m"], "velocity": ["1.85 m/s", 0, 0]},
    "world": {"obstacles": [WALL]}, "simulation": {"duration": "0.7 s"},
}  # fmt: skip
FREE: dict[str, Any] = {
    "name": "free", "vehicle": "arq", "thrust": "hover", "sensors": SENSORS,
    "start": {"position": [0, 0, "1 m"], "velocity": ["2 m/s", 0, 0], "pitch": "10 deg"},
    "world": {"obstacles": [WALL]}, "simulation": {"duration": "0.75 s"},
}  # fmt: skip


@cache
def recorded(which: str) -> Recording:
    return flight_recording(fly({"rig": RIG, "free": FREE}[which]), Path("own"))


def replayed(
    which: str, *overrides: str, log: Recording | None = None, **options: Any
) -> tuple[Replay, list[ErrorRow]]:
    tables = apply_overrides({"rig": RIG, "free": FREE}[which], overrides)
    logs = [recorded(which) if log is None else log]
    flown = replay(scenario_from(tables), tables, logs, ReplayOptions(**options))
    return flown, error_rows(flown, channel_errors(flown))


def row_of(rows: list[ErrorRow], what: str, wanted: float | None = None) -> ErrorRow:
    [found] = [row for row in rows if (row.what, row.wanted, row.part) == (what, wanted, "all")]
    return found


def test_a_flight_is_within_the_uncertainty_of_its_own_record() -> None:
    flown, rows = replayed("rig")
    assert max(row.uncertainties for row in rows) < 3.5
    assert {row.wanted for row in rows} == {None, 0.0, 0.05, 0.1, 0.2, 0.3}
    late = row_of(rows, POSITION, 0.2)
    assert late.time == pytest.approx(0.2, abs=0.003)
    assert 0.0005 < late.uncertainty < 0.002  # half a millimetre each axis
    assert row_of(rows, TOUCH).uncertainty < 0.003
    assert flown.touch == pytest.approx(0.1, abs=0.002)
    assert flown.flight_tables()["sensors"] == SENSORS


def test_arms_twice_as_stiff_are_pressed_less_than_recorded_beyond_the_uncertainty() -> None:
    stiffness = 2.0 * float(scenario_from(RIG).vehicle.arms.stiffness)  # type: ignore[arg-type]
    _, rows = replayed("rig", f"vehicle.arms.stiffness={stiffness}")
    stroke = row_of(rows, STROKE)
    assert stroke.error < -5.0 * stroke.uncertainty
    assert row_of(rows, POSITION, 0.2).is_beyond
    assert "beyond twice the uncertainty" in verdict(rows)


def test_a_log_of_another_format_tells_the_same(tmp_path: Path) -> None:
    write_recording(recorded("rig"), tmp_path / "own.ulg")
    flown, rows = replayed("rig", log=read_recording(tmp_path / "own.ulg"))
    _, own = replayed("rig")
    assert max(row.uncertainties for row in rows) < 3.5
    for what, wanted in ((POSITION, 0.05), (POSITION, 0.2)):
        a, b = row_of(rows, what, wanted), row_of(own, what, wanted)
        assert a.error == pytest.approx(b.error, abs=2e-4)
    force = flown.of(SPECIFIC_FORCE)
    assert force is not None
    assert force.name == "sensor_accel"


def test_an_obstacle_elsewhere_is_seen_in_the_touch_and_aligned() -> None:
    far = "world.obstacles.0.distance=1.02"
    _, rows = replayed("rig", far)
    late = row_of(rows, TOUCH)
    assert late.error == pytest.approx(0.02 / 1.85, rel=0.1)
    assert late.is_beyond
    flown, rows = replayed("rig", far, align=True)
    assert abs(row_of(rows, TOUCH).error) < 1e-4
    assert flown.told[-1].startswith("start moved by 2")
    assert "ahead along its velocity" in flown.told[-1]
    assert row_of(rows, POSITION, 0.2).uncertainties < 3.5


def test_a_free_flight_under_logged_thrusts_is_within_the_uncertainty() -> None:
    own, scenario = recorded("free"), scenario_from(FREE)
    t = np.arange(0.0, 0.75, 0.005)
    hover = scenario.flight_model().thrust
    speeds = log_channel("own", "esc", ROTOR_SPEED, t, np.tile(np.sqrt(hover) * 500.0, (len(t), 1)))
    flown, rows = replayed("free", log=replace(own, channels=(*own.channels, speeds)))
    assert max(row.uncertainties for row in rows if row.part == "all") < 3.5
    assert {row.what for row in rows} >= {POSITION, ATTITUDE, ANGULAR_VELOCITY}
    thrust = flown.problem.impact.thrust
    assert thrust is not None
    # the weight, as an accelerometer with noise and bias says of it
    assert np.array(thrust["values"]) == pytest.approx(
        np.tile(hover, (len(thrust["time"]), 1)), rel=0.03
    )
    assert "squares of esc" in flown.told[1]
    assert flown.problem.impact.start.attitude == pytest.approx(
        [np.cos(np.radians(5.0)), 0.0, np.sin(np.radians(5.0)), 0.0], abs=0.01
    )


def test_the_pilot_is_left_out_and_said() -> None:
    flown, _ = replayed("free", "thrust=0", "reference={type='hold'}")
    assert "the scenario's pilot is left out: the replay is open loop" in flown.told
    assert flown.flight_tables().get("reference") is None
    assert flown.flight_tables()["thrust"] == "hover"


# -- start and thrusts ----------------------------------------------------------------------------


def test_the_start_is_met_to_its_uncertainty() -> None:
    """Over noise the errors have the deviation that is told, of a flight that turns."""
    generator, touch, at = np.random.default_rng(5), 0.3, 0.15
    sigma = {POSITION: 1e-3, ATTITUDE: 2e-3, ANGULAR_VELOCITY: 0.02, SPECIFIC_FORCE: 0.5}
    t, fast = np.arange(0.0, 0.4, 0.005) + 1.0, np.arange(0.0, 0.4, 0.001) + 1.0
    truth = {
        POSITION: track_at(t, touch=9.0),
        ATTITUDE: attitude_at(t),
        ANGULAR_VELOCITY: rate_at(fast),
    }
    push = acceleration_at(fast, touch=9.0) + GRAVITY
    truth[SPECIFIC_FORCE] = world_vectors(conjugate(attitude_at(fast)), push)
    home = InitialState(np.zeros(3), np.zeros(3), np.array([1.0, 0, 0, 0]), np.zeros(3), False)
    middle = np.array([1.0 + at - 1e-4, 1.0 + at, 1.0 + at + 1e-4])
    place = track_at(middle, touch=9.0)
    scores = []
    for _ in range(40):
        readings = []
        for name, values in truth.items():
            times = (t if len(values) == len(t) else fast) - 1.0
            noisy = values + sigma[name] * generator.standard_normal(values.shape)
            if name == ATTITUDE:
                small = sigma[name] * generator.standard_normal((len(t), 3))
                noisy = product(values, np.concatenate([np.ones((len(t), 1)), 0.5 * small], axis=1))
            noise = white_noise(sigma[name], 3)
            first = np.arange(len(times)) == 0
            readings.append(
                ChannelWindow(name, name, times, noisy, noise, first, SensorChain(), False)
            )
        found = measured_start(readings, at, touch, home, StartFit(), FitSensors())
        turn = product(conjugate(attitude_at(middle[1:2])[0]), found.guess.attitude)
        error = np.concatenate([
            found.guess.position - place[1], found.guess.velocity - (place[2] - place[0]) / 2e-4,
            rotation_vector(turn), found.guess.angular_velocity - rate_at(middle[1:2])[0],
        ])  # fmt: skip
        scores.append(error / np.sqrt((found.changes**2).sum(axis=0)))
    deviations = np.sqrt((np.array(scores) ** 2).mean(axis=0))
    assert deviations == pytest.approx(np.ones(12), abs=0.45)


def test_thrusts_follow_commands_by_the_lag() -> None:
    t = np.arange(0.0, 0.1, 0.002)
    found = lagged_thrusts(t, np.where(t < 0.019, 0.0, 2.0)[:, None], 0.025)
    assert found[:, 0] == pytest.approx(
        np.where(t < 0.0199, 0.0, -2.0 * np.expm1(-(t - 0.02) / 0.025)), abs=1e-12
    )


def test_commands_are_shares_in_the_order_that_is_given() -> None:
    scenario, t = scenario_from(FREE), np.arange(0.0, 1.0, 0.01)
    most = scenario.vehicle.propulsion.max_thrust  # type: ignore[union-attr]
    force = log_channel("x", "accel", SPECIFIC_FORCE, t, np.tile([0.0, 0.0, 9.80665], (100, 1)))
    share = log_channel("x", "motors", ROTOR_COMMAND, t, np.tile([0.1, 0.2, 0.3, 0.4], (100, 1)))
    logs = [Recording(Path("x"), "made", (force, share))]
    found = logged_thrusts(scenario, logs, (0.5, 0.7), 0.6, (2, 1, 4, 3))
    assert found is not None
    assert (found.table["time"][0], found.table["time"][-1]) == pytest.approx((0.0, 0.2))
    assert found.table["values"][3] == pytest.approx(
        [0.2 * most, 0.1 * most, 0.4 * most, 0.3 * most]
    )
    assert found.carried == pytest.approx(most / (scenario.vehicle.mass * 9.80665))
    with pytest.raises(InputError, match="--rotors: names rotor 7, but the log has 4 rotors"):
        logged_thrusts(scenario, logs, (0.5, 0.7), 0.6, (2, 1, 4, 7))


def test_pulses_of_a_driver_are_no_thrusts() -> None:
    t = np.arange(0.0, 1.0, 0.01)
    pulses = log_channel("x", "RCOU", ROTOR_COMMAND, t, np.full((100, 4), 1500.0))
    log = Recording(Path("x"), "made", (pulses,))
    assert logged_thrusts(scenario_from(FREE), [log], (0.5, 0.7), 0.6) is None
    own = recorded("free")
    flown, _ = replayed("free", log=replace(own, channels=(*own.channels, pulses)))
    assert (
        "the logged commands are not shares of the largest thrust, and are not used"
        in flown.warnings
    )


# -- what is refused -------------------------------------------------------------------------------


def test_a_log_without_a_track_needs_a_start() -> None:
    own = recorded("rig")
    blind = replace(own, channels=tuple(c for c in own.channels if c.clock == "log"))
    with pytest.raises(InputError, match="own: has no track before touch, and the scenario has no"):
        replayed("rig", "start.velocity=[0, 0, 0]", log=blind)
    flown, rows = replayed("rig", log=blind)
    assert flown.told[0].endswith("from the scenario")
    assert row_of(rows, TOUCH).uncertainties < 2.0
    assert not any(row.what == POSITION for row in rows)


def test_two_vehicles_are_refused() -> None:
    other = {"vehicle": "arq", "start": {"position": [-3, 0, 1]}, "name": "other"}
    tables = FREE | {"second": other}
    scenario = scenario_from(tables)
    with pytest.raises(InputError, match="second: must not be given with --against"):
        replay(scenario, tables, [recorded("free")])


RIG_TEXT = """
name = "rig"
vehicle = "arq-slider"
[start]
position = ["0.25 m", 0, "1 m"]
velocity = ["1.85 m/s", 0, 0]
[model]
slider = [1, 0, 0]
[[world.obstacles]]
type = "wall"
distance = "1 m"
surface = "wall"
[simulation]
duration = "0.7 s"
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "rig.toml").write_text(RIG_TEXT)
    write_recording(recorded("rig"), tmp_path / "own.ulg")
    (tmp_path / "found.toml").write_text('[values]\n"vehicle.arms.stiffness" = 9000.0\n')
    return tmp_path


def run(*words: str) -> Any:
    return CliRunner().invoke(cli, ["fly", *words], catch_exceptions=True)


def test_the_command_writes_a_flight_and_its_errors(folder: Path) -> None:
    done = run("rig.toml", "--against", "own.ulg", "--with", "found.toml", "--out", "r")
    assert done.exit_code == 0, done.output
    assert done.stdout.startswith("against own.ulg at ")
    assert "beyond twice the uncertainty of the measurement" in done.stdout  # arms twice as stiff
    names = {path.name for path in (folder / "r").iterdir()}
    assert names >= {"summary.json", "trajectory.parquet", "against.json", "against.csv",
                     "against.png", "against_curves.csv"}  # fmt: skip
    data = json.loads((folder / "r" / "against.json").read_text())
    rows = list(csv.DictReader((folder / "r" / "against.csv").read_text().splitlines()))
    assert len(rows) == len(data["errors"]) > 20
    assert float(rows[0]["uncertainties"]) == pytest.approx(data["errors"][0]["uncertainties"])
    summary = json.loads((folder / "r" / "summary.json").read_text())
    assert summary["scenario"]["vehicle"]["arms"]["stiffness"] == 9000.0
    assert summary["scenario"]["start"]["velocity"][0] == pytest.approx(1.85, abs=0.02)
    curves = (folder / "r" / "against_curves.csv").read_text().splitlines()
    panels = {row["series"] for row in csv.DictReader(curves)}
    assert {"recorded x", "predicted x", "difference x", "twice the uncertainty x"} <= panels


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (
            ("--against", "own.ulg", "--impact", "3"),
            "--impact: own.ulg has no impact at 3 s; found: 0.2",
        ),
        (("--against", "own.ulg", "--before", "-1"), "--before: must be above 0 s and at most 5 s"),
        (("--against", "own.ulg", "--rotors", "1,2"), "--rotors: must name 4 logged rotors"),
        (("--against", "own.ulg", "--rotors", "x"), "--rotors: must be numbers such as 1,3,2,4"),
        (
            ("--against", "own.ulg", "--pilot", "a.py:b"),
            "--pilot: cannot be combined with --against",
        ),
        (("--against", "own.ulg", "--until", "0.1"), "no impact was found"),
        (("--against", "no.ulg"), "no.ulg: there is no such file"),
        (("--impact", "3"), "--impact: needs --against"),
        (("--from", "3"), "--from: needs --against"),
        (("--with", "rig.toml"), "rig.toml: is no overlay"),
    ],
)
def test_wrong_input_is_refused_in_one_line(
    folder: Path, words: tuple[str, ...], message: str
) -> None:
    done = run("rig.toml", *words, "--out", "r")
    assert isinstance(done.exception, InputError)
    [line] = done.exception.problems
    assert message in line
    assert not (folder / "r").exists()
