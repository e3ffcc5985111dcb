"""The user's own estimators and detectors: read from a file, built, tried before a flight.

Both run within springback's pilot, so they are compiled: a `CompiledEstimator` or a
`CompiledDetector` of settings and memory, or a function of a `PilotContext`, and of the
``parameters`` that the scenario gives, which returns one.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple, TypeVar

from springback.errors import InputError
from springback.kernels.compiler import Generic
from springback.kernels.trees import leaves
from springback.kernels.vectors import ZERO, Quat, Vec
from springback.recovery.detection import CollisionInputs
from springback.recovery.detector import DetectorStep, detector_step
from springback.scenario.avionics import CompiledDetector, CompiledEstimator
from springback.scenario.code_files import read_object
from springback.scenario.user.builders import (
    CodeLabel,
    PilotContext,
    built_part,
    refuse_parameters,
    wrong_part,
)
from springback.scenario.user.laws import Law, law_of, layout_text, source_text
from springback.sensing.measurement import Estimate, EstimatorStep, Measurement, estimator_step

Part = CompiledEstimator | CompiledDetector
Step = TypeVar("Step", EstimatorStep, DetectorStep)
_WHAT: dict[type[Part], str] = {CompiledEstimator: "an estimator", CompiledDetector: "a detector"}
#: Layout of every estimate.
ESTIMATE = layout_text(Estimate(ZERO, Quat(1.0, 0.0, 0.0, 0.0), ZERO, ZERO))


class SensingCode(NamedTuple):
    """An estimator or a detector in a file, with its parameters."""

    path: str
    """Of its name in the scenario."""
    word: str
    """``FILE.py:NAME``."""
    kind: type[Part]
    found: Part | Callable[..., Any]


def read_sensing(path: str, word: str, kind: type[Part]) -> SensingCode:
    """Read an estimator or a detector from a Python file.

    Args:
        path: Of its name in the scenario, for errors.
        word: ``file.py:name``.
        kind: Class that it must be, or that a function of this name returns.

    Raises:
        InputError: If there is no such file or name, if it is neither, or if the file fails.
    """
    try:
        found = read_object(word, _WHAT[kind])
    except InputError as error:
        raise InputError(*(f"{path}: {line}" for line in error.problems)) from error
    if not isinstance(found, kind) and (not callable(found) or isinstance(found, type)):
        file, _, name = word.rpartition(":")
        raise InputError(f"{path}: {file}: {name} {_needed(kind)} (got {source_text(found)})")
    return SensingCode(path, word, kind, found)


def _needed(kind: type[Part]) -> str:
    return (
        f"must be a {kind.__name__}, or a function of a PilotContext and its parameters that "
        "returns one, as it is compiled into the pilot"
    )


def built_sensing(code: SensingCode, context: PilotContext, parameters: Mapping[str, Any]) -> Any:
    """The estimator or detector, or what its function returns for a vehicle and parameters.

    Args:
        code: From `read_sensing`.
        context: Argument of the function.
        parameters: Further arguments by name: numbers, and triples, which become vectors.

    Raises:
        InputError: If the function fails, does not take them, or returns something else.
    """
    table = code.path.rpartition(".")[0]
    make, called = code.found, CodeLabel(table, code.word, _needed(code.kind))
    if isinstance(make, code.kind):
        refuse_parameters(called, parameters)
        return make
    assert callable(make)  # read_sensing has seen to it
    built = built_part(make, called, context, parameters)
    if not isinstance(built, code.kind):
        raise wrong_part(make, f"a {code.kind.__name__}", built)
    return built


def check_estimator(own: CompiledEstimator, measurement: Measurement) -> Law:
    """Call an estimator once, as plain Python, on some measurement; returns its law.

    Raises:
        InputError: If it fails, or returns what a pilot cannot use, with file and line.
    """
    law, said = _first_step(estimator_step, own, measurement, EstimatorStep)
    law.check_output(said.estimate, "estimate")
    if layout_text(said.estimate) != ESTIMATE:
        law.refuse(
            "must return Estimate(position, attitude, velocity, angular_velocity), of Vec and Quat "
            f"(got {layout_text(said.estimate)})"
        )
    if not all(map(math.isfinite, leaves(said.estimate))):
        law.refuse(f"must return a finite estimate (got {source_text(said.estimate)})")
    law.check_memory(own.memory, said.memory)
    return law


def check_detector(own: CompiledDetector, inputs: CollisionInputs) -> Law:
    """Call a detector once, as plain Python, on some inputs; returns its law.

    Raises:
        InputError: If it fails, or returns what a pilot cannot use, with file and line.
    """
    law, said = _first_step(detector_step, own, inputs, DetectorStep)
    law.check_output(said.alarm, "alarm")
    law.check_output(said.direction, "direction")
    if isinstance(said.alarm, tuple) or not isinstance(said.direction, Vec):
        law.refuse(
            "must return 1.0 or 0.0 as alarm, and a Vec as direction, zero if unknown (got "
            f"{source_text(said.alarm)} and {source_text(said.direction)})"
        )
    if not all(map(math.isfinite, (said.alarm, *said.direction))):
        law.refuse(f"must return finite numbers (got {source_text(said)})")
    law.check_memory(own.memory, said.memory)
    return law


def _first_step(
    step: Generic[..., Any], own: Part, seen: Any, kind: type[Step]
) -> tuple[Law, Step]:
    """Law of a part, and what it returns at the first tick for what it sees."""
    law = law_of(step, own, seen, _WHAT[type(own)])
    said = law.call()
    if not isinstance(said, kind):
        form = f"{kind.__name__}({', '.join(kind._fields)})"
        law.refuse(f"must return {form} (got {source_text(said)})")
    return law, said
