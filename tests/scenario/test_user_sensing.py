"""Estimators and detectors of the user's own within the paper's pilot, and the verdict on pilots.

Flights are some hundredths of a second in plain Python, the source that is compiled elsewhere.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import springback
from builders.cases import nonempty
from springback import InputError, Outcome, Vec
from springback.results.flight import ready_flight
from springback.scenario.files import read_scenario
from springback.scenario.scenario import scenario_from
from springback.scenario.warnings import scenario_warnings

FILE = '''
from typing import NamedTuple
from springback import (
    CompiledDetector, CompiledEstimator, DetectorStep, Estimate, EstimatorStep, PilotOutput, Vec,
    detector_step, estimator_step, kernel,
)
from springback.contact.obstacles import Plane


class Late(NamedTuple):
    """Reports a collision from the first push on, and its direction a while after that."""
    after: float
    direction: Vec

@detector_step.register(Late)
@kernel
def late_step(detector, time, inputs, memory):
    force = inputs.measurement.inertial.specific_force
    since = time if memory < 0.0 and force.x < -5.0 else memory
    known = since >= 0.0 and time - since > detector.after - 1e-9
    zero = Vec(0.0, 0.0, 0.0)
    return DetectorStep(1.0 if since >= 0.0 else 0.0, detector.direction if known else zero, since)

def late(context, after=0.005, direction=Vec(0.0, 0.0, 0.0)):
    return CompiledDetector(Late(after, direction), -1.0)

LATE = CompiledDetector(Late(0.0, Vec(1.0, 0.0, 0.0)), -1.0)


class Shifted(NamedTuple):
    """Knows the state, but for a shift."""
    shift: Vec

@estimator_step.register(Shifted)
@kernel
def shifted_step(estimator, tick, seen, memory):
    at = seen.exact
    now = Estimate(at.position + estimator.shift, at.attitude, at.velocity, at.angular_velocity)
    return EstimatorStep(now, memory + 1.0)

def shifted(context, shift=Vec(0.0, 0.0, 0.0)):
    return CompiledEstimator(Shifted(shift), 0.0)


class Bad(NamedTuple):
    kind: float

@detector_step.register(Bad)
@kernel
def bad_step(detector, time, inputs, memory):
    if detector.kind == 0.0:
        return DetectorStep(1.0 / detector.kind, Vec(0.0, 0.0, 0.0), memory)
    if detector.kind == 1.0:
        return 1.0
    if detector.kind == 2.0:
        return DetectorStep(1.0, 0.0, memory)
    if detector.kind == 3.0:
        return DetectorStep(1, Vec(0.0, 0.0, 0.0), memory)
    return DetectorStep(0.0, Vec(0.0, 0.0, 0.0), (memory, memory))

@estimator_step.register(Bad)
@kernel
def bad_estimate(estimator, tick, seen, memory):
    if estimator.kind == 0.0:
        return seen.pose
    if estimator.kind == 1.0:
        return EstimatorStep(seen.pose, memory)
    return EstimatorStep(seen.exact, [memory])

class Unregistered(NamedTuple):
    kind: float

def bad(context, kind):
    return CompiledDetector(Bad(kind), 0.0)

def bad_estimator(context, kind):
    return CompiledEstimator(Bad(kind), 0.0)

def raises(context):
    raise ValueError("as asked")

def plain(time, inputs, memory):
    return DetectorStep(0.0, Vec(0.0, 0.0, 0.0), memory)

UNREGISTERED = CompiledDetector(Unregistered(1.0), 0.0)
WHOLE = CompiledDetector(Late(1, Vec(1.0, 0.0, 0.0)), -1.0)


def wall(x):
    return Plane(Vec(-1.0, 0.0, 0.0), -x)

def hover(time, measurement, memory):
    return [measurement.inertial.fresh * 0.0 + 3.0] * 4, memory
'''
WALL = {"type": "wall", "distance": 1.0, "surface": "wall"}


@pytest.fixture
def file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("SPRINGBACK_TRUST", str(tmp_path))
    (tmp_path / "mine.py").write_text(FILE)
    return tmp_path / "mine.py"


def tables(**others: Any) -> dict[str, Any]:
    """Quad 10 mm before a wall, at 2 m/s."""
    return {
        "vehicle": "quad",
        "reference": {"type": "hold", "position": (0.6, 0.0, 1.0)},
        "estimator": {"type": "perfect"},
        "world": {"obstacles": [WALL]},
        "start": {"position": (0.746, 0.0, 1.0), "velocity": (2.0, 0.2, 0.0)},
        "simulation": {"duration": 0.025, "impact_step": 5e-4},
    } | others


def flown(given: dict[str, Any]) -> springback.Flight:
    return springback.fly(given, executor="python")


def own(file: Path, name: str, **parameters: Any) -> dict[str, Any]:
    return {"code": f"{file}:{name}", "parameters": parameters}


def direction(flight: springback.Flight) -> Any:
    return np.array([flight.telemetry[f"hit_{axis}"][-1] for axis in "xyz"])


# -- detectors ------------------------------------------------------------------------------------


def test_a_detector_raises_the_alarm_alone_or_beside_triggers(file: Path) -> None:
    detector = own(file, "late")
    for triggers, wanted in ({}, 0.0), ({"acceleration": {"used": True}}, 1.0):
        flight = flown(tables(recovery={"detection": {"own": detector} | triggers}))
        assert flight.alarm_time is not None
        assert flight.alarm_time > flight.touch_time
        [alarm] = [event for event in flight.events if event.kind == "alarm"]
        assert ("your detector" in alarm.text) or wanted
        pilot = read_scenario_pilot(tables(recovery={"detection": {"own": detector} | triggers}))
        assert pilot.detection.acceleration.used == wanted
        assert pilot.detection.hall.used == 0.0


def read_scenario_pilot(given: dict[str, Any]) -> Any:
    return scenario_from(given).build().built_avionics.avionics.systems.pilot


def test_one_collision_is_one_alarm_however_long_it_is_reported(file: Path) -> None:
    """It reports without end, and yet the response begins once, after one observation window."""
    flight = flown(tables(recovery={"detection": {"own": own(file, "late")}}))
    assert [event.label for event in flight.events if event.kind == "alarm"] == ["detected"]
    assert flight.planned_time - flight.alarm_time == pytest.approx(0.012, abs=1.1e-3)


@pytest.mark.parametrize("after", [0.0, 0.005, 0.1])
def test_a_direction_counts_until_the_observation_window_ends(file: Path, after: float) -> None:
    given = own(file, "late", after=after, direction=[0.0, -3.0, 4.0])
    flight = flown(tables(recovery={"detection": {"own": given}}))
    if after < 0.1:
        assert direction(flight) == pytest.approx([0.0, -1.0, 0.0])  # level, as walls are
    else:
        assert direction(flight)[0] > 0.9  # springback's own: it came too late
    steep = {"detection": {"own": given}, "characterisation": {"level": False}}
    if after == 0.0:
        assert direction(flown(tables(recovery=steep))) == pytest.approx([0.0, -0.6, 0.8])


# -- combinations ---------------------------------------------------------------------------------

DETECTORS: dict[str, dict[str, Any]] = {
    "hall": {}, "acceleration": {"acceleration": {"used": True}},
    "wrench": {"wrench": {"used": True}, "acceleration": {"used": False}}, "own": {},
}  # fmt: skip
LAWS = ("pre-impact", "time-optimal", "staged")
TABLE = [
    *(("perfect", "own", law) for law in LAWS),
    *(("own", detector, "pre-impact") for detector in DETECTORS),
    *(("kalman", "own", "pre-impact"), ("complementary", "own", "staged")),
]


@pytest.mark.parametrize(("estimator", "detector", "law"), TABLE)
def test_each_goes_with_each(file: Path, estimator: str, detector: str, law: str) -> None:
    detection = dict(DETECTORS[detector])
    if detector == "own":
        detection["own"] = own(file, "late")
    given = tables(recovery={"detection": detection, "response": {"way": law}})
    if detector == "hall":  # of arms that slide
        given |= {"vehicle": "arq", "simulation": {"duration": 0.035}}
    if estimator == "own":
        given |= {
            "estimator": {"type": "own", **own(file, "shifted", shift=[0.25, 0.0, 0.0])},
            "sensors": {"reveal": True},
        }
    else:
        given["estimator"] = {"type": estimator}
    flight = flown(given)
    assert flight.alarm_time is not None
    assert flight.planned_time is not None
    phases = {event.label for event in flight.events if event.kind == "phase"}
    assert phases & ({"stages"} if law == "staged" else {"way back"})
    shift = flight.telemetry["est_x"][-1] - flight.columns["x"][-1]
    assert shift == pytest.approx(0.25 if estimator == "own" else 0.0, abs=0.03)


def test_an_own_pilot_goes_with_an_own_obstacle(file: Path) -> None:
    """At 0.3 m/s off the wall it is at rest, where it is slow for long enough and nowhere else."""
    obstacle = {"type": "own", "shape": f"{file}:wall", "parameters": {"x": 1.0}, "surface": "wall"}
    start = {"position": (0.755, 0.0, 1.0), "velocity": (0.4, 0.0, 0.0)}
    simulation = {"duration": 0.12, "impact_step": 5e-4}
    for dwell, speed, outcome in nonempty([
        (0.02, 0.5, Outcome.RECOVERED),
        (0.02, 0.01, Outcome.NOT_SETTLED),
        (0.3, 0.5, Outcome.NOT_SETTLED),
    ]):  # fmt: skip
        settling = {"dwell": dwell, "speed": speed}
        given = {
            "vehicle": "quad", "pilot": f"{file}:hover", "world": {"obstacles": [obstacle]},
            "start": start, "simulation": simulation, "recovery": {"settling": settling},
        }  # fmt: skip
        flight = flown(given)
        assert flight.outcome is outcome, (dwell, speed)
        assert (flight.runs, flight.alarm_time) == (1.0, None)
        assert flight.success is (outcome is Outcome.RECOVERED)
        if outcome is Outcome.RECOVERED:
            touching = flight.separation_time - flight.touch_time
            assert flight.recovery_time == pytest.approx(touching, abs=1.1e-3)
        assert scenario_warnings(scenario_from(given), own=True) == []


# -- bad input ------------------------------------------------------------------------------------

DETECTOR_SLIPS = {
    "nix": ("recovery.detection.own.code", "has no 'nix'"),
    "WALL": ("has no 'WALL'",),
    "FILE.py": ("must be FILE.py:NAME",),
    "raises": ("mine.py:", "ValueError: as asked"),
    "plain": ("mine.py:", "plain does not take a PilotContext", "must be a CompiledDetector"),
    "shifted": ("must return a CompiledDetector",),
    "UNREGISTERED": ("Unregistered is not a detector yet: register detector_step",),
    "WHOLE": ("settings.after must be a float", "write 1.0"),
    "bad0": ("mine.py:", "detector_step of Bad: ZeroDivisionError", "at 0 s"),
    "bad1": ("detector_step of Bad must return DetectorStep(alarm, direction, memory) (got 1.0)",),
    "bad2": ("detector_step of Bad must return 1.0 or 0.0 as alarm, and a Vec",),
    "bad3": ("detector_step of Bad: alarm must be a float", "write 1.0"),
    "bad4": ("must return a memory like the first, float (got (float, float))",),
}
ESTIMATOR_SLIPS = {
    "bad_estimator0": ("must return EstimatorStep(estimate, memory)",),
    "bad_estimator1": ("must return Estimate(position, attitude, velocity, angular_velocity)",),
    "bad_estimator2": ("estimator_step of Bad: memory must be a float",),
    "late": ("must return a CompiledEstimator",),
    "LATE": ("must be a CompiledEstimator, or a function of a PilotContext",),
}


@pytest.mark.parametrize(
    ("table", "name", "words"),
    [
        *(("detector", name, words) for name, words in DETECTOR_SLIPS.items()),
        *(("estimator", name, words) for name, words in ESTIMATOR_SLIPS.items()),
    ],
)
def test_what_is_none_is_refused_in_one_line(
    file: Path, table: str, name: str, words: tuple[str, ...]
) -> None:
    stem, digit = (name[:-1], name[-1]) if name[-1].isdigit() else (name, "")
    given = own(file, stem, **({"kind": float(digit)} if digit else {}))
    if "." in name:
        given["code"] = name
    named = {
        "detector": {"recovery": {"detection": {"own": given}}},
        "estimator": {"estimator": {"type": "own"} | given},
    }
    with pytest.raises(InputError) as caught:  # as `springback check` and `fly` do
        ready_flight(scenario_from(tables(**named[table]), advises=False))
    said = str(caught.value)
    assert "\n" not in said
    for word in nonempty(words):
        assert word in said, said


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"estimator": {"type": "own"}}, "estimator.code: is missing: FILE.py:NAME"),
        ({"estimator": {"code": "mine.py:shifted"}}, 'estimator.type: must be "own"'),
        (
            {"estimator": {"type": "own", "code": "mine.py:shifted", "parameters": {"shift": "a"}}},
            "estimator.parameters.shift",
        ),
        (
            {"estimator": {"type": "own", "code": "mine.py:shifted", "parameters": {"at": 1.0}}},
            r"mine.py:\d+: shifted does not take a PilotContext, at \(got an unexpected",
        ),
        (
            {"recovery": {"detection": {"own": {"code": "mine.py:LATE", "parameters": {"a": 1}}}}},
            "recovery.detection.own.parameters: .*mine.py:LATE is no function, and takes none",
        ),
        ({"recovery": {"detection": {"own": {}}}}, "recovery.detection.own.code: "),
    ],
)
def test_a_bad_table_names_its_field(file: Path, given: dict[str, Any], said: str) -> None:
    text = tables(**given)
    for table in (text.get("estimator", {}), text.get("recovery", {}).get("detection", {})):
        part = table.get("own", table)
        if "code" in part:
            part["code"] = f"{file.parent}/{part['code']}"
    with pytest.raises(InputError, match=said):
        flown(text)


def test_code_is_found_beside_the_scenario_and_runs_in_trusted_folders_only(
    file: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = file.with_name("flight.toml")
    path.write_text(
        'vehicle = "quad"\nreference = { type = "hold" }\n'
        '[estimator]\ntype = "own"\ncode = "mine.py:shifted"\n'
        '[recovery.detection.own]\ncode = "mine.py:late"\nparameters = { after = 0.0 }\n'
    )
    scenario = read_scenario(path, ["recovery.detection.own.parameters.after=0.02"])
    assert scenario.code == [
        ("estimator.code", f"{file}:shifted"), ("recovery.detection.own.code", f"{file}:late"),
    ]  # fmt: skip
    pilot = scenario.build().built_avionics.avionics.systems.pilot
    assert pilot.detector.after == 0.02
    assert pilot.cascade.estimator.shift == Vec(0.0, 0.0, 0.0)
    monkeypatch.delenv("SPRINGBACK_TRUST")
    with pytest.raises(InputError, match=r"estimator.code: .*mine.py:shifted is code, and its"):
        read_scenario(path).build()
