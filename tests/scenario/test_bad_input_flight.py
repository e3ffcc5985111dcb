"""Bad input to flights with a pilot: one clear line, with file, line, field, value, unit, range."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import springback
from springback.errors import InputError
from springback.scenario.files import read_scenario
from springback.scenario.warnings import scenario_warnings

GOOD = """\
name = "test"
vehicle = "quad"
clock = 1000
seed = 3

[reference]
type = "run-up"
speed = "2 m/s"

[control]
stiffness = "11 N/m"

[estimator]
type = "kalman"

[estimator.kalman]
inflation = 10

[sensors.motion_capture]
rate = "200 Hz"

[sensors.imu]
rate = 1000

[sensors.imu.gyroscope]
bits = 16

[sensors.hall]
bits = 10

[air]
rotor_drag = [0.1, 0.1, 0]

[payload]
mass = "50 g"

[model_error]
mass = 1.1

[simulation]
duration = "3 s"
"""
VEHICLE, CLOCK, SEED = 'vehicle = "quad"', "clock = 1000", "seed = 3"
KIND, SPEED = 'type = "run-up"', 'speed = "2 m/s"'
GAIN, TYPE, INFLATION = 'stiffness = "11 N/m"', 'type = "kalman"', "inflation = 10"
CAMERA, IMU, GYRO, HALL = 'rate = "200 Hz"', "rate = 1000", "bits = 16", "bits = 10"
DRAG, LOAD, ERROR = "rotor_drag = [0.1, 0.1, 0]", 'mass = "50 g"', "mass = 1.1"
PROPULSION = '[vehicle]\npreset = "quad"\n[vehicle.propulsion]\n'
HEAD = 'name = "test"\nvehicle = "quad"\nclock = 1000\nseed = 3\n'
TIMES = "positions = [[0, 0, 1], [1, 0, 1]]\n"

#: Text of the file, what replaces it, the field, and words of the message.  The
#: last line of what is put there is at fault.
BAD: dict[str, tuple[str, str, str, tuple[str, ...]]] = {
    "clock that stands": (CLOCK, "clock = 0", "clock", ("more than 0 1/s", "0 1/s")),
    "clock in metres": (CLOCK, 'clock = "2 m"', "clock", ("wrong unit", "2 m", "1/s")),
    "NaN clock": (CLOCK, "clock = nan", "clock", ("finite", "nan")),
    "clock without end": (CLOCK, "clock = 1e9", "clock", ("at most 1.66667e+06 1/s", "1e+09 1/s")),
    "negative seed": (SEED, "seed = -1", "seed", ("greater than or equal to 0", "-1")),
    "half a seed": (SEED, "seed = 1.5", "seed", ("whole number", "1.5")),
    "seed in words": (SEED, 'seed = "lucky"', "seed", ("whole number", "lucky")),
    "truth as seed": (SEED, "seed = true", "seed", ("whole number", "True")),

    "unknown reference": (
        KIND, 'type = "spiral"', "reference.type", ("hold, steps, circle, waypoints or run-up", "'spiral'"),
    ),
    "key of another reference": (KIND, KIND + "\nradius = 1", "reference.radius", ("unknown key",)),
    "misspelt key": (KIND, KIND + "\nsteddy = 1", "reference.steddy", ("did you mean steady?",)),
    "run-up at rest": (SPEED, "speed = 0", "reference.speed", ("more than 0 m/s", "0 m/s")),
    "pitch beyond reason": (
        SPEED, SPEED + '\npitch = "90 deg"', "reference.pitch", ("at most 80.2141 deg", "90 deg"),
    ),
    "radius of nothing": (
        KIND + "\n" + SPEED, 'type = "circle"\nradius = 0', "reference.radius", ("more than 0 m",),
    ),
    "period backwards": (
        KIND + "\n" + SPEED, 'type = "circle"\nperiod = "-1 s"', "reference.period", ("more than 0 s",),
    ),
    "steps to nowhere": (
        KIND + "\n" + SPEED, 'type = "steps"\npositions = []', "reference.positions", ("at least one",),
    ),
    "half a position": (
        KIND + "\n" + SPEED, 'type = "hold"\nposition = [0, 1]', "reference.position",
        ("three numbers in m", "[0, 1]"),
    ),
    "times that stand still": (
        KIND + "\n" + SPEED, 'type = "waypoints"\n' + TIMES + "times = [0, 0]", "reference.times",
        ("increase from 0 s", "[0.0, 0.0] s"),
    ),

    "gain in newtons": (GAIN, 'stiffness = "5 N"', "control.stiffness", ("wrong unit", "5 N", "N/m")),
    "negative gain": (GAIN, "damping = -1", "control.damping", ("at least 0 N s/m", "-1 N s/m")),
    "misspelt gain": (GAIN, "stifness = 3", "control.stifness", ("did you mean stiffness?",)),
    "unknown law": (GAIN, 'attitude = "euler"', "control.attitude", ("'reduced', 'full' or 'lee'", "euler")),
    "frequency beside the clock": (
        GAIN, "rate_frequency = 300", "control.rate_frequency", ("1000 Hz", "got 300 Hz", "250 Hz", "333.333 Hz"),
    ),
    "faster than the clock": (
        GAIN, "attitude_frequency = 2000", "control.attitude_frequency", ("2000 Hz", "nearest: 1000 Hz"),
    ),
    "two words under way": (
        GAIN, "offboard_delay = 0.02", "control.offboard_delay",
        ("at most one period of the position loop, 0.01 s", "got 0.02 s"),
    ),
    "half a tick late": (
        GAIN, 'offboard_delay = "0.5 ms"', "control.offboard_delay", ("whole number of ticks", "0.0005 s"),
    ),
    "tilt beyond level": (
        GAIN, 'tilt_limit = "95 deg"', "control.tilt_limit", ("at most 89 deg", "95 deg"),
    ),
    "no time at all": (GAIN, "time_constant = 0", "control.time_constant", ("more than 0 s", "0 s")),
    "weight of yaw": (GAIN, "yaw_weight = 2", "control.yaw_weight", ("at most 1", "2")),
    "perhaps": (GAIN, "feed_forward = 3", "control.feed_forward", ("true or false", "3")),

    "unknown estimator": (
        TYPE, 'type = "particle"', "estimator.type", ("'kalman', 'complementary', 'perfect' or 'own'", "particle"),
    ),
    "negative inflation": (INFLATION, "inflation = -1", "estimator.kalman.inflation", ("at least 0", "-1")),
    "never predicting": (INFLATION, "every = 0", "estimator.kalman.every", ("greater than or equal to 1", "0")),
    "exact cameras": (
        INFLATION, "position_noise = 0", "estimator.kalman.position_noise", ("more than 0 m", "0 m"),
    ),
    "bandwidth of nothing": (
        "[estimator.kalman]\n" + INFLATION, "[estimator.complementary]\nbandwidth = 0",
        "estimator.complementary.bandwidth", ("more than 0 1/s",),
    ),

    "cameras beside the clock": (
        CAMERA, 'rate = "300 Hz"', "sensors.motion_capture.rate",
        ("1000 Hz", "got 300 Hz", "nearest: 250 Hz or 333.333 Hz"),
    ),
    "cameras that sleep": (
        CAMERA, "delay = 1", "sensors.motion_capture.delay", ("4 sampling periods, 0.02 s", "got 1 s"),
    ),
    "delay between ticks": (
        CAMERA, "delay = 0.0105", "sensors.motion_capture.delay", ("whole number of ticks", "0.0105 s"),
    ),
    "probability above one": (
        CAMERA, "loss_probability = 2", "sensors.motion_capture.loss_probability", ("at most 1", "2"),
    ),
    "noise below nothing": (
        CAMERA, 'attitude_noise = "-1 deg"', "sensors.motion_capture.attitude_noise", ("at least 0 deg",),
    ),
    "gyroscope beside the clock": (IMU, "rate = 300", "sensors.imu.rate", ("got 300 Hz", "250 Hz")),
    "misspelt device": (IMU, "gyro = 3", "sensors.imu.gyro", ("did you mean gyroscope?",)),
    "gyroscope without bits": (
        GYRO, "bits = 0", "sensors.imu.gyroscope.bits", ("greater than or equal to 2", "0"),
    ),
    "density in metres": (
        GYRO, 'noise = "1 m"', "sensors.imu.gyroscope.noise", ("wrong unit", "rad/s/Hz^0.5"),
    ),
    "no range": (GYRO, "full_scale = 0", "sensors.imu.gyroscope.full_scale", ("more than 0 rad/s",)),
    "converter beyond reason": (HALL, "bits = 64", "sensors.hall.bits", ("less than or equal to 32", "64")),
    "saturated": (HALL, 'distance = "3 mm"', "sensors.hall.distance", ("saturates", "0.003 m", "4.7 V")),

    "wind of two": (DRAG, "wind = [1, 0]", "air.wind", ("three numbers in m/s",)),
    "wind on nothing": (DRAG, "wind = [1, 0, 0]", "air.wind", ("has no effect without rotor_drag",)),
    "drag that pushes": (DRAG, "rotor_drag = [-1, 0, 0]", "air.rotor_drag", ("at least 0 N s/m",)),
    "gusts at no speed": (
        DRAG, DRAG + "\ngusts = { wind_at_6_m = 7 }", "air.gusts.airspeed", ("is missing",),
    ),
    "gusts in the sky": (
        DRAG, DRAG + "\nwind = [5, 0, 0]\ngusts = { wind_at_6_m = 7, altitude = 1 }", "air.gusts.altitude",
        ("at least 3.048 m", "1 m"),
    ),

    "payload that lifts": (LOAD, "mass = -1", "payload.mass", ("at least 0 kg", "-1 kg")),
    "payload aside": (LOAD, "position = [0, 0, 0.1]", "payload.position", ("[0, 0, 0] m", "0.1")),
    "payload with a weight": (LOAD, "weight = 1", "payload.weight", ("unknown key", "mass")),
    "massless in truth": (ERROR, "mass = 0", "model_error.mass", ("more than 0", "0")),
    "error in kilograms": (ERROR, 'mass = "2 kg"', "model_error.mass", ("wrong unit", "a plain number")),

    "weaker than its weight": (
        VEHICLE, PROPULSION + "max_thrust = 3", "vehicle.propulsion.max_thrust",
        ("more than 3.398 N", "true weight", "got 3 N"),
    ),
    "never down again": (
        VEHICLE, PROPULSION + "min_thrust = 4", "vehicle.propulsion.min_thrust",
        ("less than 3.398 N", "got 4 N"),
    ),
    "thrust in kilograms": (
        VEHICLE, PROPULSION + 'max_thrust = "5 kg"', "vehicle.propulsion.max_thrust", ("wrong unit", "N"),
    ),
    "lag ahead of time": (
        VEHICLE, PROPULSION + "time_constant = -1", "vehicle.propulsion.time_constant", ("at least 0 s",),
    ),
    "more than ideal": (
        VEHICLE, PROPULSION + "figure_of_merit = 2", "vehicle.propulsion.figure_of_merit", ("at most 1",),
    ),
    "misspelt rotor": (
        VEHICLE, PROPULSION + "max_trust = 3", "vehicle.propulsion.max_trust", ("did you mean max_thrust?",),
    ),

    "thrust beside a reference": (SEED, SEED + "\nthrust = 3", "thrust", ("with a reference", "3")),
    "slider beside a reference": (
        DRAG, DRAG + "\n[model]\nslider = [1, 0, 0]", "model.slider", ("with a reference",),
    ),
}  # fmt: skip

#: Reference tables that cannot be flown, and words on the limit and the difference.
BEYOND = {
    "speed": ('{ type = "run-up", speed = 20 }', ("distance of", "more than the 2.51 m", "tilt rate", "220 deg/s")),
    "tilt": ('{ type = "run-up", speed = 2, pitch = "70 deg" }', ("tilt of 70 deg, 10 deg beyond", "60 deg")),
    "thrust": ('{ type = "run-up", speed = 2, pitch = "80 deg" }', ("thrust of", "limit of 28 N")),
    "distance": ('{ type = "run-up", speed = 2, wall_distance = 0.5 }', ("distance of", "0.256 m it has")),
    "no way": ('{ type = "run-up", speed = 2, wall_distance = 0.1 }', ("wall_distance", "0.2444 m", "0.1 m")),
    "steady": (
        '{ type = "run-up", speed = 2, pitch = "45 deg", steady = 3 }', ("less than 0.204 s", "got 3 s"),
    ),
    "duration": (
        '{ type = "waypoints", positions = [[0, 0, 1], [1, 0, 1]], duration = 0.2 }',
        ("tilt rate", "limit of 220 deg/s", "thrust of 228.3 N"),
    ),
}  # fmt: skip


def problem_of(path: Path, *overrides: str, pilot: bool | None = None) -> str:
    """The one line that is said about a bad scenario."""
    with pytest.raises(InputError) as caught:
        read_scenario(path, overrides, pilot=pilot)
    text = str(caught.value)
    assert "\n" not in text, text
    return text


def written(folder: Path, text: str) -> Path:
    path = folder / "scenario.toml"
    path.write_text(text)
    return path


def test_the_scenario_itself_is_good(tmp_path: Path) -> None:
    scenario = read_scenario(written(tmp_path, GOOD))
    assert scenario.seed == 3
    assert scenario_warnings(scenario) == []


@pytest.mark.parametrize(("old", "new", "field", "words"), BAD.values(), ids=BAD.keys())
def test_file_line_field_and_range(
    tmp_path: Path, old: str, new: str, field: str, words: tuple[str, ...]
) -> None:
    """The line names the file, the line of the value, the field, the value, and what is allowed."""
    before, found, after = GOOD.partition(old)
    assert found
    moved = "[" in new and old == VEHICLE  # a table of its own goes to the end
    text = before + after + "\n" + new if moved else before + new + after
    path = written(tmp_path, text)
    said = problem_of(path)
    line = text.splitlines().index(new.splitlines()[-1]) + 1
    assert said.startswith(f"{path}:{line}: {field}: "), said
    for word in words:
        assert word in said, said


@pytest.mark.parametrize(("table", "words"), BEYOND.values(), ids=BEYOND.keys())
def test_references_beyond_the_limits_name_the_limit(
    tmp_path: Path, table: str, words: tuple[str, ...]
) -> None:
    path = written(tmp_path, f'vehicle = "quad"\nreference = {table}\n')
    said = problem_of(path)
    assert said.startswith(f"{path}:2: reference: "), said
    for word in words:
        assert word in said, said


@pytest.mark.parametrize(
    "table", ["reference", "control", "estimator", "sensors", "air", "payload", "model_error"]
)
def test_tables_must_be_tables(tmp_path: Path, table: str) -> None:
    path = written(tmp_path, f'vehicle = "quad"\n{table} = 3\n')
    assert problem_of(path).startswith(f"{path}:2: {table}: must be a table (got 3)")


def test_clock_is_blamed_where_it_alone_was_given(tmp_path: Path) -> None:
    """The rates are defaults, so they are not what the user got wrong."""
    path = written(tmp_path, 'vehicle = "quad"\nclock = 999\nreference = { type = "hold" }\n')
    said = problem_of(path)
    assert said.startswith(f"{path}:2: clock: does not suit sensors.motion_capture.rate")
    assert "199.8 Hz or 249.75 Hz" in said


def test_vehicle_without_rotors(tmp_path: Path) -> None:
    body = "mass = 1\ninertia = [0.01, 0.01, 0.02]"
    arms = "directions = [0, 2, 4]\nlength = 0.2\nmass = 0\ncompliant = false\ncage_radius = 0.1"
    text = f'reference = {{ type = "hold" }}\n[vehicle.body]\n{body}\n[vehicle.arms]\n{arms}\n'
    said = problem_of(written(tmp_path, text))
    assert "vehicle.propulsion: is missing: a vehicle that is flown by a pilot needs" in said


GUSTY = (
    'vehicle = "quad"\n[air]\nwind = [5, 0, 0]\nrotor_drag = [0.1, 0.1, 0]\n'
    "gusts = { wind_at_6_m = 7 }\n[simulation]\nduration = 0.01\n"
)


def test_gusts_need_a_pilot(tmp_path: Path) -> None:
    """In a flight without one they would be passed over in silence."""
    path = written(tmp_path, GUSTY)
    assert problem_of(path, pilot=False).startswith(f"{path}:5: air.gusts: blow only where a pilot")
    tables: dict[str, Any] = {
        "vehicle": "quad", "air": {"wind": [5, 0, 0], "rotor_drag": [1, 1, 0], "gusts": {"wind_at_6_m": 7}},
    }  # fmt: skip
    for given in (path, tables, read_scenario(path)):
        with pytest.raises(InputError, match=r"air\.gusts: blow only"):
            springback.fly(given)
    flown = springback.fly(
        path, pilot=lambda time, measurement, memory: ((3.0,) * 4, memory), executor="python"
    )
    assert flown.success


def test_own_pilots_are_checked_for_what_they_use(tmp_path: Path) -> None:
    """Sensors, clock and rotors count without a reference; gains do not."""
    path = written(tmp_path, 'vehicle = "quad"\n[sensors.imu]\nrate = 300\n')
    for pilot in (None, True):  # sensors are read without a pilot, too
        said = problem_of(path, pilot=pilot)
        assert said.startswith(f"{path}:3: sensors.imu.rate: must divide")
    assert "model.slider" in problem_of(path, "model.slider=[1,0,0]", pilot=True)
    read_scenario(path, ["sensors.imu.rate=500", "control.rate_frequency=300"], pilot=True)


def test_uneasy_scenarios_are_flown_with_a_warning(tmp_path: Path) -> None:
    """Unstable gains, a circle beyond the limits, tables that are not read."""
    path = written(tmp_path, 'vehicle = "quad"\nreference = { type = "steps" }\n')
    assert scenario_warnings(read_scenario(path)) == []
    [said] = scenario_warnings(read_scenario(path, ["control.damping=0"]))
    assert "linearised horizontal loop unstable: eigenvalue +" in said
    circle = read_scenario(path, ['reference={ type = "circle", period = 0.8 }'])
    assert any("circle needs a tilt of 80.96 deg" in said for said in scenario_warnings(circle))
    plain = read_scenario(
        written(tmp_path, 'vehicle = "quad"\nseed = 3\n[control]\nstiffness = 3\n')
    )
    assert [said.split()[0] for said in scenario_warnings(plain)] == ["control", "seed"]


def test_perfect_estimator_needs_no_asking(tmp_path: Path) -> None:
    """It believes the truth, which sensors then reveal by themselves."""
    path = written(tmp_path, 'vehicle = "quad"\nreference = { type = "hold" }\n')
    read_scenario(path, ["estimator.type=perfect", "sensors.reveal=false"])


def run(*words: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "springback", *words],
        cwd=cwd, capture_output=True, text=True, timeout=300, check=False,
    )  # fmt: skip


def test_command_line_refuses_and_warns(tmp_path: Path) -> None:
    """Exit code 2, one line, nothing written; a warning is a line on stderr, and the flight flies."""
    written(tmp_path, GOOD)
    bad = run("fly", "scenario.toml", "sensors.imu.rate=300", "--out", "a/out", cwd=tmp_path)
    assert (bad.returncode, bad.stdout) == (2, "")
    [line] = bad.stderr.strip().splitlines()
    assert line.startswith("error: override sensors.imu.rate=300: sensors.imu.rate: must divide")
    assert not (tmp_path / "a").exists()
    written(tmp_path, 'vehicle = "quad"\nreference = { type = "steps" }\n')
    words = ("control.damping=0", "simulation.duration=0.01", "--out", "b", "--no-figures")
    odd = run("fly", "scenario.toml", *words, cwd=tmp_path)
    assert odd.returncode == 0, odd.stderr
    assert odd.stderr.startswith("warning: gains make the linearised horizontal loop unstable")
