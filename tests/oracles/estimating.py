"""Run estimators over recorded readings, compiled or in plain Python."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from springback.kernels.compiler import executor, kernel
from springback.kernels.layout import rows, write
from springback.kernels.trees import rebuilt
from springback.kernels.vectors import Quat, Vec
from springback.sensing.measurement import Estimate, Inertial, Measurement, Pose, estimator_step

ZERO = Vec(0.0, 0.0, 0.0)
NOTHING = Estimate(ZERO, Quat(1.0, 0.0, 0.0, 0.0), ZERO, ZERO)


def quat(attitude):
    return Quat(*attitude.as_quat(scalar_first=True).tolist())


def estimate_at(flown, k=0, deviations=None, generator=None):
    """The truth at a sample, with errors of given standard deviations."""
    errors = np.zeros((3, 3))
    if deviations is not None:
        errors = generator.standard_normal((3, 3)) * np.array(deviations[:3])[:, None]
    return Estimate(
        Vec(*(flown.position[k] + errors[0]).tolist()),
        quat(flown.attitude[k] * Rotation.from_rotvec(errors[2])),
        Vec(*(flown.velocity[k] + errors[1]).tolist()),
        Vec(*flown.rate[k].tolist()),
    )


def _seen(table, k):
    row = table[k]
    return Measurement(
        Inertial(Vec(row[0], row[1], row[2]), Vec(row[3], row[4], row[5]), row[6]),
        Pose(
            Vec(row[7], row[8], row[9]), Quat(row[10], row[11], row[12], row[13]), row[14], row[15]
        ),
        (0.0,),
        0.0,
        NOTHING,
    )


_compiled_seen = kernel(_seen)


def _loop(estimator, memory, table, estimates, memories, every):
    for k in range(1, table.shape[0]):
        believed = estimator_step(estimator, float(k), _compiled_seen(table, k), memory)
        memory = believed.memory
        write(believed.estimate, estimates[k], 0, 1, 0)
        if k % every == 0:
            write(memory, memories[k // every], 0, 1, 0)
    return memory


_compiled_loop = executor()(_loop)


def readings(flown, clip=None):
    """The readings of a flight as a table with a row for each sample."""
    n = len(flown.force)
    force = flown.force if clip is None else np.clip(flown.force, -clip[0], clip[0])
    spin = flown.spin if clip is None else np.clip(flown.spin, -clip[1], clip[1])
    attitude = flown.pose_attitude.as_quat(scalar_first=True)
    columns = [force, spin, np.ones(n), flown.pose_position, attitude, flown.fresh]
    return np.column_stack([*columns, np.full(n, flown.age)])


class Run:
    """Estimates of a flight, and the memory at some of its samples."""

    def __init__(self, estimates, memories, like, last, every):
        self.position, self.velocity = estimates[:, 0:3], estimates[:, 7:10]
        self.attitude = Rotation.from_quat(estimates[1:, 3:7], scalar_first=True)
        self.rate = estimates[:, 10:13]
        self._memories, self._like, self.last, self.every = memories, like, last, every

    def memory(self, k):
        """Memory at sample k, a multiple of ``every``."""
        return rebuilt(self._like, self._memories[k // self.every])

    def column(self, first, last):
        """Some leaves of the memory at every sample kept; negative numbers count from the end."""
        return self._memories[1:, first:last]

    def tilt_and_turn(self, flown):
        """Rotation vectors of the attitude's error, body axes, from sample 1 on."""
        return (self.attitude.inv() * flown.attitude[1:]).as_rotvec()


def run(estimator, memory, flown, *, clip=None, every=5, plain=False):
    """An estimator over a flight; ``clip`` are the ranges of force and rate."""
    table = readings(flown, clip)
    estimates = np.zeros((len(table), 13))
    memories = np.zeros((len(table) // every + 1, rows(memory)))
    loop = _plain_loop if plain else _compiled_loop
    last = loop(estimator, memory, table, estimates, memories, every)
    return Run(estimates, memories, memory, last, every)


def _plain_loop(estimator, memory, table, estimates, memories, every):
    values = table.tolist()
    for k in range(1, len(values)):
        believed = estimator_step(estimator, float(k), _seen(values, k), memory)
        memory = believed.memory
        write(believed.estimate, estimates[k], 0, 1, 0)
        if k % every == 0:
            write(memory, memories[k // every], 0, 1, 0)
    return memory
