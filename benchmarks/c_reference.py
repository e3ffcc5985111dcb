"""`reference.c`, compiled and called from Python threads (ctypes lets go of the interpreter)."""

from __future__ import annotations

import ctypes
import os
import shutil
import subprocess
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

from benchmarks.job import Outcome, inputs
from springback.simulation.measuring.record import Model
from springback.vehicle.state import State

SOURCE = Path(__file__).with_name("reference.c")
FLAGS = ("-O3", "-march=native", "-fno-math-errno", "-shared", "-fPIC", "-Wno-psabi")

_OBSTACLE, _SURFACE = "world.obstacles.1", "world.obstacles.1.surface"
_ARM = (
    "cosine", "sine", "mass", "inverse_mass", "stiffness", "damping", "length", "shortest",
    "stop_stiffness", "stop_dissipation", "compliance", "cage_radius", "torque_ratio",
)  # fmt: skip
_ARMS = (1, 2, 3, 4)
_STATE = (
    *(f"position.{k}" for k in "xyz"), *(f"attitude.{k}" for k in "wxyz"),
    *(f"velocity.{k}" for k in "xyz"), *(f"angular_velocity.{k}" for k in "xyz"),
    *(f"arm_length.{j}" for j in _ARMS), *(f"arm_rate.{j}" for j in _ARMS),
)  # fmt: skip

#: Rows of C's Model and State, by the names of our leaves.
INPUT = [
    "airframe.mass", "airframe.inverse_mass",
    *(f"airframe.inertia.{i}.{k}" for i in "xyz" for k in "xyz"),
    *(f"airframe.arms.{j}.{name}" for j in _ARMS for name in _ARM),
    *(f"airframe.{arms}.{k}" for arms in ("released", "locked") for k in ("xx", "yy", "xy")),
    *(f"{_OBSTACLE}.shape.normal.{k}" for k in "xyz"),
    f"{_OBSTACLE}.shape.offset",
    *(f"{_SURFACE}.{name}" for name in ("stiffness", "dissipation", "viscosity", "friction")),
    f"{_SURFACE}.slip_speed",
    f"{_OBSTACLE}.is_ground",
    "world.gravity",
    "contact_point.rounding",
    *(f"thrust.{j}" for j in _ARMS),
    *(
        f"timing.{name}"
        for name in (
            "until", "free_step", "impact_step", "settle_step",
            "arm_tolerance", "rate_tolerance", "dwell", "hybrid",
        )
    ),
    *(f"state.{name}" for name in _STATE),
]  # fmt: skip

_SAMPLE = ("acceleration", "specific_force", "normal_force")
#: Rows of C's Motion and Record.
OUTPUT = [
    *(f"motion.state.{name}" for name in _STATE),
    *(
        f"motion.work.{name}"
        for name in ("thrust", "arm", "stop", "contact", "friction", "settling", "air")
    ),
    *(f"motion.work.impulse.{k}" for k in "xyz"),
    "stepping.time", "stepping.step", "stepping.status", "stepping.phase", "stepping.request",
    "stepping.steps", "contacts.touching", "contacts.total",
    *(f"contacts.engaged.arms.{j}.1" for j in _ARMS), *(f"contacts.arms.{j}" for j in _ARMS),
    "contacts.impacts", "contacts.impact_open", "contacts.last_touch_time", "contacts.duration",
    *(f"first_impact.inward.{k}" for k in "xyz"),
    "first_impact.touch_time", "first_impact.touch_depth", "first_impact.touch_speed",
    "first_impact.touch_mass_centre_speed",
    "first_impact.separation_time", "first_impact.separation_speed",
    "first_impact.separation_mass_centre_speed",
    "first_impact.return_time", "first_impact.return_speed", "peaks.acceleration",
    "peaks.acceleration_time",
    "peaks.specific_force", "peaks.angular_rate", "peaks.normal_force", "peaks.penetration",
    "peaks.compression", "peaks.extension",
    "impact_peaks.acceleration", "impact_peaks.acceleration_time", "impact_peaks.specific_force",
    "impact_peaks.angular_rate", "impact_peaks.normal_force", "impact_peaks.penetration",
    "impact_peaks.compression", "impact_peaks.extension", "first_impact.travel",
    "contacts.bottomed_time", "contacts.ground_time",
    "recent.step",
    *(f"recent.{one}.{name}" for one in ("earlier", "latest") for name in _SAMPLE),
]  # fmt: skip

#: Measures that must agree, each with the size of a value that counts as small.
COMPARED = {
    "stepping.steps": 1.0, "contacts.total": 1.0, "first_impact.touch_speed": 1.0,
    "first_impact.separation_speed": 1.0,
    "contacts.duration": 1e-2, "peaks.acceleration": 1.0, "peaks.normal_force": 1.0,
    "first_impact.travel": 1e-2,
    "peaks.compression": 1e-2, "impact_peaks.acceleration": 1.0, "impact_peaks.extension": 1e-2,
    "impact_peaks.normal_force": 1.0, "motion.work.contact": 1.0, "motion.work.friction": 1.0,
    "motion.work.arm": 1.0, "motion.work.settling": 1.0, "motion.work.thrust": 1.0,
    "motion.state.velocity.x": 1.0, "motion.state.angular_velocity.y": 1.0,
}  # fmt: skip


def compiler() -> str | None:
    """The C compiler, if there is one."""
    return shutil.which("gcc")


class Reference:
    """The C program for some number of lanes.

    Args:
        lanes: Flights in one vector.
        folder: Where to put the library.
        model: Of all flights.
        states: One for each flight.
    """

    def __init__(self, lanes: int, folder: Path, model: Model, states: list[State]) -> None:
        """Compile, load, and lay out the flights."""
        library = folder / f"reference{lanes}.so"
        command = [compiler() or "gcc", *FLAGS, f"-DLANES={lanes}", str(SOURCE), "-o", str(library)]
        if not library.exists():
            subprocess.run([*command, "-lm"], check=True)
        self.library, self.lanes = ctypes.CDLL(str(library)), lanes
        self.library.fly.argtypes = [ctypes.c_void_p, ctypes.c_void_p, *(ctypes.c_long,) * 3]
        self.library.fly.restype = None
        self.input = np.ascontiguousarray(inputs(model, states, INPUT))
        self.output = np.zeros((len(states), len(OUTPUT)))
        if (self.library.input_rows(), self.library.output_rows()) != (len(INPUT), len(OUTPUT)):
            raise RuntimeError("reference.c and c_reference.py disagree on rows")

    def run(self, threads: int) -> Outcome:
        """Fly all; only the flying is timed."""
        count = len(self.input)
        chunk = max(1, -(-count // (8 * threads * self.lanes))) * self.lanes

        def part(first: int) -> None:
            last = min(first + chunk, count)
            self.library.fly(self.input.ctypes.data, self.output.ctypes.data, first, last, 10**9)

        self.output[:] = np.nan
        began = time.perf_counter()
        with ThreadPoolExecutor(threads) as pool:
            list(pool.map(part, range(0, count, chunk)))
        seconds = time.perf_counter() - began
        return Outcome(seconds, dict(zip(OUTPUT, self.output.T.copy(), strict=True)))


def disagreement(ours: Outcome, theirs: Outcome) -> tuple[float, str]:
    """Largest relative difference over all compared measures and flights, and which it is."""
    worst, where = 0.0, "none"
    for name, small in COMPARED.items():
        a, b = ours.values[name], theirs.values[name]
        error = np.abs(a - b) / np.maximum(np.maximum(np.abs(a), np.abs(b)), small)
        largest = float(np.max(np.where(np.isfinite(error), error, np.inf)))
        if largest > worst:
            worst, where = largest, f"{name}, flight {int(np.argmax(error))}"
    return worst, where


def version() -> str:
    """First line of what the compiler says of itself."""
    said = subprocess.run(["gcc", "--version"], capture_output=True, text=True, check=True).stdout
    return said.splitlines()[0] if said else os.fspath(compiler() or "")
