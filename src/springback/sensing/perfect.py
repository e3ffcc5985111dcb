"""An estimator that is told the truth."""

from __future__ import annotations

from typing import NamedTuple

from springback.kernels.compiler import kernel
from springback.sensing.measurement import EstimatorStep, Measurement, estimated


class PerfectState(NamedTuple):
    """Believes what sensors reveal of the truth; they must be asked to (`Measurement.exact`)."""

    unused: float


class PerfectMemory(NamedTuple):
    """Nothing to remember."""

    unused: float


@estimated.register(PerfectState)
@kernel
def _perfect(
    estimator: PerfectState, tick: float, seen: Measurement, memory: PerfectMemory
) -> EstimatorStep:
    return EstimatorStep(seen.exact, memory)
