"""An estimator that knows the exact state."""

from __future__ import annotations

from typing import NamedTuple

from springback.kernels.compiler import kernel
from springback.sensing.measurement import EstimatorStep, Measurement, estimator_step


class PerfectState(NamedTuple):
    """Estimator that uses the exact state, which the sensors must reveal (`Measurement.exact`)."""

    unused: float


class PerfectMemory(NamedTuple):
    """Empty memory."""

    unused: float


@estimator_step.register(PerfectState)
@kernel
def _perfect(
    estimator: PerfectState, tick: float, seen: Measurement, memory: PerfectMemory
) -> EstimatorStep:
    return EstimatorStep(seen.exact, memory)
