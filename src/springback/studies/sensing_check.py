"""Check of a user's own estimator or detector: one flight of the paper's pilot with it."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Mapping
from typing import Any

from springback.errors import InputError
from springback.recovery.detector import DetectorStep
from springback.recovery.parameters import RecoverySettings
from springback.results.estimate_errors import estimate_errors
from springback.results.flight import Flight, guided_flight
from springback.scenario.avionics import CompiledDetector, CompiledEstimator
from springback.scenario.build import UserParts, pilot_context
from springback.scenario.scenario import Scenario, scenario_from
from springback.scenario.user.compiled import first_inputs
from springback.scenario.user.laws import home_of
from springback.scenario.user.sensing import Part, read_sensing
from springback.sensing.estimation import EstimatorSettings
from springback.sensing.measurement import Estimate, EstimatorStep
from springback.simulation.measuring.measures import Outcome
from springback.studies.pilot_check import Finding
from springback.studies.run_ups import run_up_scenario
from springback.user_code import UserCode

#: The flights and the bounds of all properties are chosen.
HOVER = {
    "name": "check", "vehicle": "quad", "reference": {"type": "hold"},
    "start": {"position": [0.0, 0.0, 1.0], "roll": "10 deg"}, "simulation": {"duration": 3.0},
}  # fmt: skip
COLLISION = run_up_scenario("quad", 0.0, 2.0, recovery={}, simulation={"duration": 8.0})
POSITION, VELOCITY, ATTITUDE = 0.05, 0.3, math.radians(5.0)  # errors of an estimate
DELAY, DIRECTION = 0.05, math.radians(20.0)  # of a detected collision [s, rad]


def sensing_kind(found: Any, parameters: Mapping[str, Any]) -> type[Part] | None:
    """Class of the estimator or detector that an object of a user's file is, or builds.

    Args:
        found: The object.
        parameters: Arguments for a function that builds one.

    Returns:
        None if it is neither.
    """
    if callable(found) and not isinstance(found, type):
        try:
            hover = scenario_from(HOVER)
            found = found(pilot_context(hover, hover.start_state()), **parameters)
        except Exception:  # whatever it is, it is none of these
            return None
    kinds: tuple[type[Part], ...] = (CompiledEstimator, CompiledDetector)
    return next((kind for kind in kinds if isinstance(found, kind)), None)


def refuse_plain_sensing(found: Any, word: str) -> None:
    """Reject a function that is an estimator or a detector itself, in plain Python.

    Args:
        found: The object of a user's file.
        word: Its name, ``file.py:name``.

    Raises:
        InputError: If it is one, by its annotations or by what it returns, with file and line.
    """
    if not callable(found) or isinstance(found, type):
        return
    what = next((word for word, kinds in _RETURNED.items() if _returns(found, kinds)), None)
    if what is not None:
        file, line = home_of(found)
        step = f"{what.rpartition(' ')[2]}_step"
        raise InputError(
            f"{file}:{line}: {word.rpartition(':')[2]} is {what} in plain Python; it runs within "
            f"springback's pilot, so it must be compiled: register {step} for a type of settings, "
            f"and name a {_COMPILED[what]}, as springback new {what.rpartition(' ')[2]} writes one"
        )


#: What a step of each returns, and the class to be named instead.
_RETURNED = {"an estimator": (EstimatorStep, Estimate), "a detector": (DetectorStep,)}
_COMPILED = {"an estimator": "CompiledEstimator", "a detector": "CompiledDetector"}


def _returns(found: Any, kinds: tuple[type[Any], ...]) -> bool:
    """True if a function says that it returns one of some types, or does so in hover."""
    said = getattr(found, "__annotations__", {}).get("return")
    named = said.rpartition(".")[2] if isinstance(said, str) else getattr(said, "__name__", "")
    if named in {kind.__name__ for kind in kinds}:
        return True
    built = scenario_from({**HOVER, "recovery": {}}).build().built_avionics
    assert built is not None  # it has a reference
    inputs = first_inputs(built.avionics)
    for seen in (inputs.measurement, inputs):
        with contextlib.suppress(Exception, SystemExit):  # whatever it is, it is none of these
            if isinstance(found(0.0, seen, None), kinds):
                return True
    return False


def check_sensing(
    kind: type[Part], word: str, parameters: Mapping[str, Any], scenario: Scenario | None = None
) -> list[Finding]:
    """Check an estimator or a detector by one flight with it.

    Args:
        kind: `CompiledEstimator` or `CompiledDetector`.
        word: ``file.py:name`` of one, or of a function that returns one.
        parameters: Arguments of the function, in SI.
        scenario: To be flown, with a reference.  By default `quad` hovers by the estimator, or
            flies into a wall at 2 m/s with the detector, and recovers.

    Raises:
        InputError: If it cannot be used, or the scenario cannot be flown with it.
    """
    estimates = kind is CompiledEstimator
    chosen = scenario or scenario_from(HOVER if estimates else COLLISION)
    if chosen.reference is None or chosen.pilot is not None:
        raise InputError("the scenario must have a [reference] and no pilot of your own")
    named = {"code": word, "parameters": parameters}
    if estimates:
        parts = UserParts(estimator=read_sensing("estimator.code", word, kind))
        ready = chosen.model_copy(update={"estimator": EstimatorSettings(type="own", **named)})
        return _estimator_findings(guided_flight(ready, ready.build(parts)))
    recovery = chosen.recovery or RecoverySettings()
    detection = recovery.detection.with_checked(own=UserCode(**named))
    parts = UserParts(detector=read_sensing("recovery.detection.own.code", word, kind))
    ready = chosen.with_checked(recovery=recovery.with_checked(detection=detection))
    return _detector_findings(guided_flight(ready, ready.build(parts)))


def _estimator_findings(flight: Flight) -> list[Finding]:
    errors = estimate_errors(flight)
    findings = [Finding("flies", flight.is_finite, f"{flight.outcome.word}: {flight.message}")]
    for name, unit, values, most in (
        ("position", "m", errors.position, POSITION),
        ("velocity", "m/s", errors.velocity, VELOCITY),
        ("attitude", "rad", errors.attitude, ATTITUDE),
    ):
        worst, when = float(values.max()), float(errors.time[values.argmax()])
        sentence = f"it is wrong by up to {worst:.2g} {unit}, at {when:.3g} s (at most {most:.2g})"
        findings.append(Finding(f"estimates the {name}", worst <= most, sentence))
    return findings


def _detector_findings(flight: Flight) -> list[Finding]:
    m = flight.measures
    delay, error, false = m["detection_delay"], m["direction_error"], m["false_alarms"]
    late = "there is none" if delay is None else f"it came {1e3 * delay:.3g} ms after first touch"
    off = "there is none" if error is None else f"{math.degrees(error):.3g} deg"
    return [
        Finding(
            "detects the collision", delay is not None and delay <= DELAY,
            f"the first alarm: {late} (at most {1e3 * DELAY:g} ms)",
        ),
        Finding(
            "knows the direction", error is not None and error <= DIRECTION,
            f"error of f_c0: {off} (at most {math.degrees(DIRECTION):g} deg)",
        ),
        Finding("raises no false alarm", false == 0.0, f"false alarms: {false:g}"),
        Finding(
            "leads to a recovery", flight.outcome is Outcome.RECOVERED,
            f"{flight.outcome.word}: {flight.message}",
        ),
    ]  # fmt: skip
