"""Checks of a user's own pilot: short flights, and its calls repeated.

All is done with the plain-Python form of a pilot; one that is compiled must then fly the same.
"""

from __future__ import annotations

import math
import pickle
import warnings
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from springback.errors import CommandWarning, InputError
from springback.kernels.trees import leaves, rebuilt
from springback.progress import Progress, silent
from springback.results.flight import Flight, as_scenario, fly
from springback.scenario.avionics import CompiledPilot, propulsion_of
from springback.scenario.build import pilot_context
from springback.scenario.scenario import Scenario
from springback.scenario.user.pilots import (
    NO_PARAMETERS,
    built_pilot,
    chosen_pilot,
    read_pilot,
)
from springback.sensing.measurement import Measurement, Pose
from springback.simulation.guided import PlainPilot
from springback.simulation.onboard import PilotOutput, pilot_step
from springback.user_code import UserCode

#: The bounds of all properties are chosen.
DURATION = 3.0  # of each flight [s]
LAST = 0.5  # in which it must have recovered [s]
REACH = 0.1  # largest distance from the start [m]
TILT, UPRIGHT = math.radians(10.0), math.radians(3.0)  # at the start, at the end
GAP_BEGINS, GAP = 1.0, 0.1  # motion capture drops out [s]
SHIFT = 16.0  # a power of two, so that differences of times are hardly rounded [s]
SAME = 1e-6  # commands that count as the same after the shift [N]
COMPILED = 1e-9  # difference of positions between compiled and plain flights [m]


class Finding(NamedTuple):
    """The result for one property."""

    name: str
    passed: bool
    sentence: str


class Call(NamedTuple):
    """One call of a pilot, and its answer."""

    time: float  # [s]
    measurement: Measurement
    thrusts: tuple[float, ...]  # [N]


Findings = list[Finding]


def check_pilot(
    pilot: PlainPilot | CompiledPilot | str,
    scenario: Scenario | Mapping[str, Any] | str | Path | None = None,
    *,
    parameters: Mapping[str, Any] = NO_PARAMETERS,
    progress: Progress = silent,
) -> Findings:
    """Check the properties that every pilot should have.

    Args:
        pilot: As for `springback.fly`: a function, a `CompiledPilot`, or ``"file.py:name"``.
        scenario: Scenario whose vehicle, sensors and start are used; at rest at its start the pilot
            must hover.  By default `quad` at [0, 0, 1] m.
        parameters: Arguments of a function that returns the pilot, in SI.
        progress: Called with the fraction of the properties done.

    Raises:
        InputError: If the scenario, or the file of the pilot, cannot be used.
    """
    word, arguments = pilot if isinstance(pilot, str) else "", _read_arguments(parameters)
    own = read_pilot(word, builds=bool(arguments)) if word else chosen_pilot(pilot)
    if own is None:
        raise InputError("pilot must be given: a function, a CompiledPilot, or 'file.py:name'")
    ready = _at_rest(as_scenario(scenario or {"name": "check", "vehicle": "quad"}, (), True))
    own = built_pilot(own, pilot_context(ready, ready.start_state()), arguments, word)
    asked = _as_plain(own)
    calls: list[Call] = []
    properties: list[Callable[[], Finding]] = [
        lambda: _hovers(asked, ready, calls),
        lambda: _commands(ready, calls),
        lambda: _repeats(asked, calls),
        lambda: _keeps_memory(asked, calls),
        lambda: _ignores_truth(asked, calls),
        lambda: _forgets_the_clock(asked, calls),
        lambda: _recovers(asked, ready),
        lambda: _bridges(asked, ready),
    ]
    if isinstance(own, CompiledPilot):
        properties.append(lambda: _compiles(own, asked, ready))
    findings = []
    for k, tried in enumerate(properties, start=1):
        with warnings.catch_warnings():  # what it commands is a finding of its own
            warnings.simplefilter("ignore", CommandWarning)
            findings.append(tried())
        progress(k / len(properties))
    return findings


def _read_arguments(parameters: Mapping[str, Any]) -> dict[str, Any]:
    """Arguments of a builder in SI, as a scenario reads them."""
    return UserCode(code="pilot.py:pilot", parameters=dict(parameters)).parameters


def _as_plain(pilot: PlainPilot | CompiledPilot) -> PlainPilot:
    """A pilot as a plain function whose memory is None at first."""
    if not isinstance(pilot, CompiledPilot):
        return pilot
    law, settings, first = pilot_step.dispatch(type(pilot.settings)), pilot.settings, pilot.memory

    def asked(time: float, measurement: Any, memory: Any) -> PilotOutput:
        said: PilotOutput = law(settings, time, measurement, first if memory is None else memory)
        return said

    asked.__wrapped__ = law  # type: ignore[attr-defined]
    return asked


def _at_rest(scenario: Scenario) -> Scenario:
    """The scenario in which the properties are checked."""
    start = scenario.start.with_checked(velocity=(0.0, 0.0, 0.0), angular_velocity=(0.0, 0.0, 0.0))
    simulation = scenario.simulation.with_checked(duration=DURATION)
    changes = {"reference": None, "thrust": "hover", "start": start, "simulation": simulation}
    return scenario.with_checked(**changes)


# -- in flight ------------------------------------------------------------------------------------


def _farthest(flight: Flight, since: float = 0.0) -> float:
    """Largest distance from the start [m], from some time on."""
    c, start = flight.columns, flight.scenario.start.position
    offsets = np.stack([c[axis] - begin for axis, begin in zip("xyz", start, strict=True)])
    return float(np.linalg.norm(offsets, axis=0)[c["t"] >= since].max())


def _tilt(flight: Flight, since: float) -> float:
    """Largest angle between body z and the vertical [rad], from some time on."""
    c = flight.columns
    cosine = 1.0 - 2.0 * (c["qx"] ** 2 + c["qy"] ** 2)
    return float(np.arccos(np.clip(cosine, -1.0, 1.0))[c["t"] >= since].max())


def _flight_finding(name: str, judge: Callable[[], tuple[bool, str]]) -> Finding:
    """A finding from a flight, or the reason why it could not be flown."""
    try:
        return Finding(name, *judge())
    except InputError as error:
        return Finding(name, False, "; ".join(error.problems))


def _hovers(pilot: PlainPilot, scenario: Scenario, calls: list[Call]) -> Finding:
    def noting(time: float, measurement: Any, memory: Any) -> Any:
        said = pilot(time, measurement, memory)
        calls.append(Call(time, measurement, tuple(said[0])))
        return said

    def judge() -> tuple[bool, str]:
        flight = fly(scenario, pilot=_with_location(noting, pilot))
        away = _farthest(flight)
        return (
            flight.is_finite and away <= REACH,
            f"from rest it strays {100.0 * away:.2g} cm in {DURATION:g} s "
            f"(at most {100.0 * REACH:g} cm)",
        )

    return _flight_finding("hovers", judge)


def _with_location(function: Any, pilot: Any) -> Any:
    """A function in place of a pilot, whose errors name the pilot's file and line."""
    function.__wrapped__ = pilot
    return function


def _recovers(pilot: PlainPilot, scenario: Scenario) -> Finding:
    half = math.acos(math.sqrt(math.cos(TILT)))  # roll and pitch that make the tilt together
    start = scenario.start.with_checked(roll=half, pitch=half, quaternion=None)
    tilted = scenario.with_checked(start=start)

    def judge() -> tuple[bool, str]:
        flight = fly(tilted, pilot=pilot)
        away, tilt = _farthest(flight, DURATION - LAST), _tilt(flight, DURATION - LAST)
        return (
            flight.is_finite and away <= REACH and tilt <= UPRIGHT,
            f"released with a tilt of {math.degrees(TILT):g} deg it is {100.0 * away:.2g} cm away "
            f"and tilts {math.degrees(tilt):.2g} deg in the last {LAST:g} s of {DURATION:g} s (at "
            f"most {100.0 * REACH:g} cm and {math.degrees(UPRIGHT):g} deg)",
        )

    return _flight_finding("recovers from a tilt", judge)


def _bridges(pilot: PlainPilot, scenario: Scenario) -> Finding:
    held: list[tuple[float, Pose]] = []

    def blinded(time: float, measurement: Any, memory: Any) -> Any:
        if time < GAP_BEGINS or not held:
            held[:] = [(time, measurement.pose)]
        elif time < GAP_BEGINS + GAP:
            since, last = held[0]
            stale = last._replace(fresh=0.0, age=last.age + time - since)
            measurement = measurement._replace(pose=stale)
        return pilot(time, measurement, memory)

    def judge() -> tuple[bool, str]:
        flight = fly(scenario, pilot=_with_location(blinded, pilot))
        away = _farthest(flight)
        return (
            flight.is_finite and away <= REACH,
            f"without motion capture for {GAP:g} s it strays {100.0 * away:.2g} cm "
            f"(at most {100.0 * REACH:g} cm)",
        )

    return _flight_finding("bridges a gap of motion capture", judge)


def _compiles(own: CompiledPilot, pilot: PlainPilot, scenario: Scenario) -> Finding:
    def judge() -> tuple[bool, str]:
        plain, compiled = fly(scenario, pilot=pilot), fly(scenario, pilot=own)
        if len(plain.t) != len(compiled.t):
            return False, "compiled and plain flights take different steps"
        apart = max(float(np.abs(plain.columns[a] - compiled.columns[a]).max()) for a in "xyz")
        return (
            compiled.is_finite and apart <= COMPILED,
            f"compiled and plain flights are {apart:.2g} m apart (at most {COMPILED:g} m)",
        )

    return _flight_finding("compiles to the same flight", judge)


# -- the same calls repeated ----------------------------------------------------------------------


def _commands(scenario: Scenario, calls: list[Call]) -> Finding:
    name, rotors = "commands what rotors can", propulsion_of(scenario).rotors()
    if not calls:
        return Finding(name, False, "it was never asked, for it did not take off")
    commands = np.array([call.thrusts for call in calls])
    low, high = float(commands.min()), float(commands.max())
    return Finding(
        name,
        rotors.least <= low and high <= rotors.most,
        f"its {commands.shape[1]} thrusts in hover are {low:.3g} to {high:.3g} N "
        f"(rotors give {rotors.least:g} to {rotors.most:.3g} N)",
    )


def _again(
    pilot: PlainPilot, calls: list[Call], changed: Callable[[Call], Call]
) -> tuple[float, float]:
    """Repeat all calls of a flight, changed: largest difference [N], and time of the first [s]."""
    memory, largest, first = None, 0.0, math.nan
    for call in calls:
        asked = changed(call)
        thrusts, memory, *_ = pilot(asked.time, asked.measurement, memory)
        differences = np.abs(np.array(tuple(thrusts)) - np.array(call.thrusts))
        worst = float(np.nan_to_num(differences, nan=math.inf).max())
        first = call.time if worst > 0.0 and math.isnan(first) else first
        largest = max(largest, worst)
    return largest, first


def _repeat_finding(
    name: str,
    pilot: PlainPilot,
    calls: list[Call],
    changes: list[Callable[[Call], Call]],
    words: tuple[str, str],
    allowed: float = 0.0,
) -> Finding:
    """A finding from repeated calls; the words are for passed, and for failed."""
    if not calls:
        return Finding(name, False, "it was never asked, for it did not take off")
    try:
        largest, first = max(_again(pilot, calls, changed) for changed in changes)
    except Exception as error:
        return Finding(name, False, f"{words[1]}: it raises {type(error).__name__}: {error}")
    if largest <= allowed:
        return Finding(name, True, words[0])
    return Finding(name, False, f"{words[1]}: by up to {largest:.3g} N, first at {first:.4g} s")


def _repeats(pilot: PlainPilot, calls: list[Call]) -> Finding:
    return _repeat_finding(
        "says the same twice", pilot, calls, [lambda call: call],
        ("asked the same again it says the same",
         "asked the same again it says something else, so it remembers outside its memory"),
    )  # fmt: skip


def _ignores_truth(pilot: PlainPilot, calls: list[Call]) -> Finding:
    def poisoned(sign: float) -> Callable[[Call], Call]:
        absurd: Any = _constant_tree(calls[0].measurement.exact, sign * 1e6) if calls else None

        def changed(call: Call) -> Call:
            return call._replace(measurement=call.measurement._replace(exact=absurd))

        return changed

    return _repeat_finding(
        "does not look at the truth", pilot, calls, [poisoned(1.0), poisoned(-1.0)],
        ("an absurd measurement.exact changes nothing",
         "measurement.exact, which no robot has, changes its commands"),
    )  # fmt: skip


def _constant_tree(like: Any, number: float) -> Any:
    """A tree shaped like another, with one number everywhere."""
    return rebuilt(like, [number] * len(leaves(like)))


def _forgets_the_clock(pilot: PlainPilot, calls: list[Call]) -> Finding:
    return _repeat_finding(
        "hovers at any time", pilot, calls,
        [lambda call: call._replace(time=call.time + SHIFT)],
        (f"{SHIFT:g} s later it commands the same",
         f"{SHIFT:g} s later it commands something else, so its law depends on the time of day"),
        SAME,
    )  # fmt: skip


def _keeps_memory(pilot: PlainPilot, calls: list[Call]) -> Finding:
    name = "leaves its memory as it is"
    if not calls:
        return Finding(name, False, "it was never asked, for it did not take off")
    memory: Any = None
    for call in calls:
        try:
            before = pickle.dumps(memory)
            _, after, *_ = pilot(call.time, call.measurement, memory)
            changed = pickle.dumps(memory) != before
        except Exception as error:
            return Finding(name, False, f"memory cannot be compared: {error}")
        if changed:
            return Finding(
                name, False, f"it changes the memory it is given, at {call.time:.4g} s; return anew"
            )
        memory = after
    return Finding(name, True, "it returns its memory anew")
