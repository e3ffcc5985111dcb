"""The user's own code that a flight compiles: called once before it, and compiled in words."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from springback.kernels.vectors import Vec
from springback.recovery.detection import CollisionInputs
from springback.scenario.avionics import CompiledEstimator, CompiledPilot
from springback.scenario.build import ReadyFlight
from springback.scenario.user.laws import Law, in_words, laws_of_shape
from springback.scenario.user.pilots import check_compiled_pilot
from springback.scenario.user.sensing import check_detector, check_estimator
from springback.simulation.flight import own_types
from springback.simulation.onboard import Avionics


@contextmanager
def compiling(*flights: ReadyFlight) -> Iterator[None]:
    """Context in which flights with the user's own code are compiled, and flown.

    Args:
        *flights: That are flown in it together.

    Raises:
        InputError: If code of the user's own fails at the first tick, or cannot be compiled, in one
            line with file and line.
    """
    with in_words([law for built in flights for law in check_user_code(built)]):
        yield


def compile_user_code(built: ReadyFlight) -> None:
    """Compile the user's own code in a flight, but not the flight: a second or two for each part.

    Raises:
        InputError: As `compiling`.
    """
    for law in check_user_code(built):
        law.compile()


def check_user_code(built: ReadyFlight) -> list[Law]:
    """Laws of the user's own that a flight compiles; those on board are called in plain Python.

    Those of obstacles are sampled when the flight is built.

    Raises:
        InputError: If one fails, with its file and line.
    """
    at = Vec(*built.start.position)
    laws = [law for shape, _ in built.obstacles for law in laws_of_shape(shape, at)]
    if built.built_avionics is None:
        return laws
    onboard = built.built_avionics.avionics.onboard
    for part in built.compiled:
        if not own_types(part):
            continue
        if isinstance(part, CompiledPilot):
            rotors = len(built.model.thrust)
            laws.append(check_compiled_pilot(part, onboard.measurement, rotors))
        elif isinstance(part, CompiledEstimator):
            laws.append(check_estimator(part, onboard.measurement))
        else:
            laws.append(check_detector(part, first_inputs(built.built_avionics.avionics)))
    return laws


def first_inputs(avionics: Avionics) -> CollisionInputs:
    """What the detectors of a pilot that recovers are given, before its first tick."""
    airframe, memory = avionics.systems.pilot.cascade.airframe, avionics.onboard.pilot
    at, wrench = memory.flight.estimate, memory.wrench
    return CollisionInputs(airframe, avionics.onboard.measurement, at, wrench)
