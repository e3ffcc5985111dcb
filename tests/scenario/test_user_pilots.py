"""Pilots of the user's own: asked at every tick, compiled to the same bits, with errors that say what is wrong."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

import springback
from builders.user_pilots import SHARE, before_a_wall, pilot_file
from springback.errors import CommandWarning, InputError
from springback.scenario.user.pilots import read_pilot
from springback.simulation.flight import BEGUN, sources

SHORT = {
    "name": "own",
    "vehicle": "quad",
    "start": {"roll": "2 deg"},
    "simulation": {"duration": 0.4},
}


class Leveller(NamedTuple):
    share: float  # of the weight on each rotor [N]
    gain: float  # [N s/rad]
    fuse: float  # tick at which a division by zero occurs; negative for none


@springback.pilot_step.register(Leveller)
@springback.kernel
def levelled(
    pilot: Leveller, time: float, measurement: Any, memory: float
) -> springback.PilotOutput:
    """Damps roll and pitch; at the tick of the fuse its command is infinite."""
    w, q = measurement.inertial.angular_velocity, measurement.pose.attitude
    roll, pitch = pilot.gain * (w.x + 8.0 * q.x), pilot.gain * (w.y + 8.0 * q.y)
    share = pilot.share + 1e-300 / (pilot.fuse - memory)
    thrusts = (
        share - roll + pitch,
        share + roll + pitch,
        share + roll - pitch,
        share - roll - pitch,
    )
    return springback.PilotOutput(thrusts, memory + 1.0)


SETTINGS = Leveller(springback.QUAD.vehicle.mass * 9.81 / 4.0, 0.3, -1.0)


def plain(time: float, measurement: Any, memory: float | None) -> tuple[Any, Any]:
    said = levelled(SETTINGS, time, measurement, 0.0 if memory is None else memory)
    return said.thrust, said.memory


@pytest.fixture(scope="module")
def flight() -> springback.Flight:
    return springback.fly(SHORT, pilot=plain)


def test_plain_pilot_is_asked_at_every_tick(flight: springback.Flight) -> None:
    """Once a tick, with the time of the tick; its answer is the rotors' command."""
    asked: list[tuple[float, tuple[float, ...]]] = []

    def noting(time: float, measurement: Any, memory: Any) -> tuple[Any, Any]:
        said = plain(time, measurement, memory)
        asked.append((time, said[0]))
        return said

    noted = springback.fly(SHORT, pilot=noting)
    assert len(asked) == 400
    assert np.allclose([t for t, _ in asked], np.arange(400) * 1e-3, rtol=0.0, atol=1e-12)
    commands = np.stack([noted.telemetry[f"command{n}"] for n in (1, 2, 3, 4)], axis=1)
    assert np.array_equal(commands, [said for _, said in asked])
    assert len(np.unique(commands[:, 0])) > 100
    assert np.abs(noted.columns["wx"][-1]) < 0.2  # it damps
    assert np.array_equal(noted.columns["x"], flight.columns["x"])


def test_compiled_pilot_flies_the_same_bits(flight: springback.Flight) -> None:
    """One source, run by the interpreter outside the loop, and compiled inside it."""
    compiled = springback.fly(SHORT, pilot=springback.CompiledPilot(SETTINGS, 0.0))
    for name, values in flight.columns.items():
        assert np.array_equal(values, compiled.columns[name]), name
    for name in ("command1", "thrust4", "imu_wx", "pose_qx"):
        assert np.array_equal(flight.telemetry[name], compiled.telemetry[name]), name


def test_compiled_pilot_that_divides_by_zero_ends_as_not_finite() -> None:
    """An infinite command is not cut to the rotors' most; the last good state is kept."""
    pilot = springback.CompiledPilot(SETTINGS._replace(fuse=100.0), 0.0)
    flight = springback.fly(SHORT, pilot=pilot)
    assert flight.outcome is springback.Outcome.NOT_FINITE
    assert flight.measures["end_time"] == pytest.approx(0.1, abs=2e-3)
    assert np.isfinite(flight.columns["z"]).all()


def test_thrust_below_nothing_is_flown_as_the_least_and_said() -> None:
    """Was: −5 N flown as 0 without a word.  Compiled pilots alike; 0 itself is fine."""

    def pulling(time: float, measurement: Any, memory: Any) -> tuple[Any, Any]:
        return (-5.0 if time >= 0.1 else 0.0, 1.0, 1.0, 1.0), None

    words = r"less than 0 N at 300 of 400 ticks, first at 0\.1 s \(-5 N\).* their minimum, 0 N"
    with pytest.warns(CommandWarning, match=words):
        flight = springback.fly(SHORT, pilot=pulling)
    assert flight.telemetry["thrust1"].min() >= 0.0
    negative = springback.CompiledPilot(SETTINGS._replace(share=-1.0), 0.0)
    with pytest.warns(CommandWarning, match="less than 0 N at 400 of 400 ticks"):
        springback.fly(SHORT, pilot=negative)
    springback.fly(
        {**SHORT, "simulation": {"duration": 0.02}},
        pilot=lambda time, measurement, memory: ((0.0,) * 4, None),
    )


# -- from files -----------------------------------------------------------------------------------

FILE = """\
from typing import NamedTuple
import springback

def three(time, measurement, memory):
    return (1.0, 2.0, 3.0), None

def divides(time, measurement, memory):
    if time > 0.0025:
        return (1.0 / 0.0,) * 4, memory
    return (3.0,) * 4, memory

def not_a_number(time, measurement, memory):
    return (3.0, float("nan"), 3.0, 3.0), memory

def silent(time, measurement, memory):
    pass

def wordy(time, measurement, memory):
    return "more", memory

def blind(time, measurement, memory):
    return (2.97733,) * 4, memory

class Gains(NamedTuple):
    share: float

@springback.pilot_step.register(Gains)
@springback.kernel
def law(pilot, time, measurement, memory):
    if memory > 5.0:
        return springback.PilotOutput((pilot.share,) * 4, (memory, memory))
    if memory > 3.0:
        return springback.PilotOutput((pilot.share,) * 3, memory)
    return springback.PilotOutput((pilot.share,) * 4, memory)

class Other(NamedTuple):
    share: float

def no_arguments():
    return (3.0,) * 4, None

class Strange(NamedTuple):
    share: float

@springback.pilot_step.register(Strange)
@springback.kernel
def short_law(pilot):
    return springback.PilotOutput((pilot.share,) * 4, 0.0)

odd = springback.CompiledPilot(Strange(3.0), 0.0)
number = 3
whole = springback.CompiledPilot(Gains(3), 0.0)
array = springback.CompiledPilot(Gains(3.0), [1.0])
few = springback.CompiledPilot(Gains(3.0), 4.0)
grows = springback.CompiledPilot(Gains(3.0), 6.0)
stranger = springback.CompiledPilot(Other(3.0), 0.0)
"""

SLIPS = {
    "three": (":4: ", "commands 3 thrusts for 4 rotors", "0 s"),
    "divides": (":9: ", "ZeroDivisionError", "0.003 s"),
    "not_a_number": (":12: ", "finite", "nan N for rotor 2"),
    "silent": (":15: ", "must return (thrusts, memory)", "None"),
    "wordy": (":18: ", "numbers in N", "'more'"),
    "number": ("number must be a function", "got 3"),
    "hoover": ("has no 'hoover'", "there are: three, divides"),
    "whole": ("settings.share", "got 3, int", "write 3.0"),
    "array": ("memory", "list"),
    "few": (":27: ", "commands 3 thrusts for 4 rotors"),
    "grows": (":27: ", "memory like the first, float", "(float, float)"),
    "no_arguments": ("slips.py:39: ", "TypeError", "no_arguments()"),
    "odd": ("slips.py:45: ", "TypeError", "short_law()"),
    "stranger": ("Other is not a pilot yet", "register pilot_step"),
}


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("pilots") / "slips.py"
    path.write_text(FILE)
    return path


@pytest.mark.parametrize(("name", "words"), SLIPS.items(), ids=SLIPS.keys())
def test_slips_are_told_in_one_line(file: Path, name: str, words: tuple[str, ...]) -> None:
    """With the file, the line where there is one, and what was given."""
    with pytest.raises(InputError) as caught:
        springback.fly(SHORT, pilot=f"{file}:{name}")
    said = str(caught.value)
    assert "\n" not in said
    for word in words:
        assert word in said, said


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("def f(:\n", (":1: ", "is not Python")),
        ("import math\nmath.nothing\n", (":2: ", "AttributeError")),
        ("\nimport no_such_module\n", (":2: ", "no_such_module")),
    ],
)
def test_files_that_cannot_be_run(tmp_path: Path, text: str, words: tuple[str, ...]) -> None:
    (tmp_path / "pilot.py").write_text(text)
    with pytest.raises(InputError) as caught:
        read_pilot(f"{tmp_path / 'pilot.py'}:f")
    assert all(word in str(caught.value) for word in words), str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("word", "said"),
    [
        ("none.py:f", "no such file"), ("none.py", "file.py:name"), ("none.py:", "file.py:name"),
        (":f", "file.py:name"),
    ],
)  # fmt: skip
def test_words_that_are_no_pilots(word: str, said: str) -> None:
    with pytest.raises(InputError, match=said):
        read_pilot(word)


def test_kernels_are_kept_only_for_files_that_stand(tmp_path: Path) -> None:
    """What a pilot imports from its folder counts; what may have changed since is not kept."""
    (tmp_path / "gains_of_mine.py").write_text("SHARE = 3.0\n")
    path = tmp_path / "kept.py"
    path.write_text("from gains_of_mine import SHARE\n" + FILE)
    for entry in tmp_path.glob("*.py"):
        os.utime(entry, (BEGUN - 100.0, BEGUN - 100.0))
    pilot = read_pilot(f"{path}:few")
    assert isinstance(pilot, springback.CompiledPilot)
    types = {type(pilot.settings)}
    files = sources(types)  # generic functions of other test modules count, too, once loaded
    assert files is not None
    assert {str(tmp_path / "gains_of_mine.py"), str(path)} <= set(files.files)
    os.utime(tmp_path / "gains_of_mine.py", (time.time() + 5.0, time.time() + 5.0))
    assert sources(types) is None


# -- parameters, and a detector within ------------------------------------------------------------


def guarded(folder: Path, name: str, **parameters: Any) -> springback.Flight:
    pilot = {"code": f"{pilot_file(folder)}:{name}", "parameters": parameters}
    return springback.fly(before_a_wall(pilot), executor="python")


@pytest.fixture
def trusted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("SPRINGBACK_TRUST", str(tmp_path))
    return tmp_path


@pytest.mark.parametrize("name", ["guard", "plain_guard"])
def test_parameters_reach_the_function_that_builds_a_pilot(trusted: Path, name: str) -> None:
    """Numbers, and three of them as a vector; a plain pilot and a compiled one alike."""
    flight = guarded(trusted, name, threshold=4.0, offset=[0.0, 0.0, 0.25])
    assert flight.telemetry["command1"] == pytest.approx(1.25 * SHARE)
    early, late = (guarded(trusted, name, threshold=x).detection_delay for x in (1.0, 8.0))
    assert early is not None
    assert late is not None
    assert 0.0 < early < late < 0.02
    assert guarded(trusted, name, threshold=1e3).detection_delay is None


def test_both_forms_report_the_same_alarms(trusted: Path) -> None:
    """At the tick at which they say so: in telemetry, in the replay's events and in measures."""
    plain, compiled = (guarded(trusted, name, threshold=4.0) for name in ("plain_guard", "guard"))
    for flight in (plain, compiled):
        reported = flight.telemetry["alarm"]
        felt = flight.telemetry["imu_ax"] < -4.0
        assert np.array_equal(reported, felt.astype(float))
        assert 0.0 < reported.mean() < 1.0
        [event, *_] = [event for event in flight.events if event.kind == "alarm"]
        assert event.text == "your pilot reports a collision"
        assert event.t == flight.telemetry["t"][felt.argmax()]
        assert flight.alarm_time == event.t
        assert flight.detection_delay == pytest.approx(event.t - flight.touch_time, abs=1e-12)
        assert (flight.false_alarms, flight.position_error, flight.hall_delay) == (0.0, None, None)
    assert plain.measures == compiled.measures
    for name, values in plain.telemetry.items():
        assert np.array_equal(values, compiled.telemetry[name]), name


def test_an_alarm_in_free_flight_is_false(trusted: Path) -> None:
    pilot = f"{pilot_file(trusted)}:guard"
    given = before_a_wall({"code": pilot, "parameters": {"threshold": -1.0}})  # at any time
    given["start"]["position"] = [0.74, 0.0, 1.0]  # touches after 40 ms
    flight = springback.fly(given, executor="python")
    assert (flight.false_alarms, flight.alarm_time) == (1.0, None)
    silent = springback.fly(before_a_wall(f"{pilot_file(trusted)}:mute"), executor="python")
    assert (silent.false_alarms, silent.alarm_time) == (0.0, None)
    assert not silent.telemetry["alarm"].any()


def test_the_short_form_the_table_and_an_override_are_one(trusted: Path) -> None:
    path = trusted / "flight.toml"
    pilot_file(trusted)
    path.write_text('vehicle = "quad"\npilot = "guards.py:guard"\n')
    short = springback.read_scenario(path)
    path.write_text('vehicle = "quad"\n[pilot]\ncode = "guards.py:guard"\n')
    assert springback.read_scenario(path).pilot == short.pilot
    changed = springback.read_scenario(path, ["pilot.parameters.threshold=7"]).pilot
    path.write_text('vehicle = "quad"\npilot = "guards.py:guard"\n')
    assert springback.read_scenario(path, ["pilot.parameters.threshold=7"]).pilot == changed
    assert changed is not None
    assert (changed.code, changed.parameters) == (f"{trusted}/guards.py:guard", {"threshold": 7.0})
    other = springback.read_scenario(path, [f"pilot={trusted}/guards.py:mute"]).pilot
    assert other is not None
    assert (other.code, other.parameters) == (f"{trusted}/guards.py:mute", {})
    again = springback.Scenario(**short.model_dump(mode="json"))  # as in a result folder
    assert again.pilot == short.pilot


def test_a_pilot_given_to_fly_has_no_parameters_of_the_scenarios(trusted: Path) -> None:
    named = {"code": f"{pilot_file(trusted)}:guard", "parameters": {"threshold": 4.0}}

    def other(time: float, measurement: Any, memory: Any) -> tuple[Any, Any]:
        return (0.5,) * 4, memory

    flight = springback.fly(before_a_wall(named), pilot=other, executor="python")
    assert set(flight.telemetry["command1"]) == {0.5}


@pytest.mark.parametrize(
    ("pilot", "said"),
    [
        ({}, "pilot.code: is missing"),
        ("guard", r"pilot: must be FILE.py:NAME \(got 'guard'\)"),
        (3, r"pilot: must be a table \(got 3\)"),
        ({"code": "guard"}, r"pilot.code: must be FILE.py:NAME \(got 'guard'\)"),
        ({"code": "FILE:guard", "parameter": {}}, "pilot.parameter: unknown key; did you mean"),
        ({"code": "FILE:guard", "parameters": {"threshold": "x"}}, "pilot.parameters.threshold: "),
        (
            {"code": "FILE:guard", "parameters": {"gain": 1.0}},
            r"guards.py:\d+: guard does not take a PilotContext, gain \(got an unexpected keyword "
            r"argument 'gain'\); it must be a function of a PilotContext and its parameters",
        ),
        ("FILE:plain_guard", r"plain_guard does not take a PilotContext \(missing a required arg"),
        (
            {"code": "FILE:hover", "parameters": {"gain": 1.0}},
            r"guards.py:\d+: hover does not take a PilotContext, gain \(missing a required",
        ),
    ],
)
def test_a_bad_table_of_a_pilot_is_refused_in_one_line(
    trusted: Path, pilot: Any, said: str
) -> None:
    file = str(pilot_file(trusted))
    given = {**pilot} if isinstance(pilot, dict) else pilot
    if isinstance(given, dict) and "code" in given:
        given["code"] = given["code"].replace("FILE", file)
    given = given.replace("FILE", file) if isinstance(given, str) else given
    with pytest.raises(InputError, match=said) as caught:
        springback.fly(before_a_wall(given))
    assert len(caught.value.problems) == 1


@pytest.mark.parametrize("alarm", [2.0, "yes", float("nan"), None, np.ones(2)], ids=str)
def test_an_alarm_is_one_or_zero(alarm: Any) -> None:
    def loud(time: float, measurement: Any, memory: Any) -> tuple[Any, Any, Any]:
        return (3.0,) * 4, memory, alarm

    with pytest.raises(InputError, match=r"the pilot must return 1 or 0 as alarm \(got .*, at 0 s"):
        springback.fly(SHORT, pilot=loud)


def test_what_the_compiler_lacks_is_named(trusted: Path) -> None:
    """Was: Failed in nopython mode pipeline."""
    path = pilot_file(trusted)
    path.write_text(path.read_text().replace("(lift, lift, lift, lift)", "(lift,) * 4"))
    lines = path.read_text().splitlines()
    [line] = [k for k, text in enumerate(lines, start=1) if "(lift,) * 4" in text]
    with pytest.raises(InputError) as caught:
        springback.fly(before_a_wall(f"{path}:guard"))
    wanted = f"{path}:{line}: cannot be compiled: the compiler has no mul(UniTuple(float64 x 1), "
    assert str(caught.value).startswith(wanted)


# -- the check ------------------------------------------------------------------------------------

EXAMPLE = Path(__file__).parents[2] / "examples" / "own_pilot.py"
KEPT = [
    "hovers", "commands what rotors can", "says the same twice", "leaves its memory as it is",
    "does not look at the truth", "hovers at any time", "recovers from a tilt",
    "bridges a gap of motion capture",
]  # fmt: skip


def test_check_finds_every_vice() -> None:
    """A pilot that hovers well, but remembers aside, changes its memory, looks at truth and clock."""
    good: Any = read_pilot(f"{EXAMPLE}:hover")
    count = [0]

    def vicious(time: float, measurement: Any, memory: Any) -> tuple[Any, Any]:
        count[0] += 1
        memory = [None, 0] if memory is None else memory
        thrusts, memory[0] = good(time, measurement, memory[0])
        memory[1] += 1
        aside = 1e-4 * (count[0] % 7) + 1e-9 * measurement.exact.position.z
        return thrusts + aside + 1e-3 * np.sin(time), memory

    findings = {f.name: f for f in springback.check_pilot(vicious)}
    assert list(findings) == KEPT
    failed = {name for name, finding in findings.items() if not finding.passed}
    assert failed == set(KEPT[2:6])
    assert all(finding.sentence for finding in findings.values())


def test_check_of_a_pilot_that_falls() -> None:
    """It keeps the rules and does not fly; one that asks for too much does not hover, either."""

    def falls(time: float, measurement: Any, memory: Any) -> tuple[Any, Any]:
        return (1.0, 1.0, 1.0, 40.0), memory

    failed = {f.name for f in springback.check_pilot(falls) if not f.passed}
    assert failed == {KEPT[0], KEPT[1], KEPT[6], KEPT[7]}


def run(*words: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "springback", *words],
        cwd=cwd, capture_output=True, text=True, timeout=300, check=False,
    )  # fmt: skip


def test_command_line(tmp_path: Path) -> None:
    """A pilot that fails a property is 1, bad input 2, and nothing is written."""
    (tmp_path / "p.py").write_text(EXAMPLE.read_text() + FILE)
    (tmp_path / "s.toml").write_text('vehicle = "quad"\n[simulation]\nduration = 0.01\n')
    blind = run("check", "p.py:blind", "s.toml", cwd=tmp_path)
    assert (blind.returncode, blind.stdout.count("FAIL")) == (1, 1), blind.stderr + blind.stdout
    assert "FAIL  recovers from a tilt: released with a tilt of 10 deg" in blind.stdout
    bad = run("fly", "s.toml", "--pilot", "p.py:three", "--out", "o", "--no-figures", cwd=tmp_path)
    assert bad.returncode == 2
    assert bad.stderr.startswith(f"error: {tmp_path / 'p.py'}:")
    assert not (tmp_path / "o").exists()
    flown = run(
        "fly", "s.toml", "--pilot", "p.py:hover", "--out", "o", "--no-figures", cwd=tmp_path
    )
    assert flown.returncode == 0, flown.stderr
    assert (tmp_path / "o" / "telemetry.parquet").exists()
