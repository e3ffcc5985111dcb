"""Flights on a GPU: the host's code and the threads' own, without one; and the PTX looked at.

What a thread does is run here by the interpreter, thread by thread, through the very code that
lays flights out for a GPU and takes them back.  On a GPU, ``python -m benchmarks.gpu`` compares
with the processor bit for bit.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from builders.guided_flights import AT_WALL, GUSTY, WALL, Lane, lane, same, tables
from builders.impacts import towards_wall
from springback.errors import InputError
from springback.kernels.compiler import with_globals
from springback.kernels.gpu import cuda
from springback.kernels.gpu.nvptx import Precision, device_function
from springback.kernels.gpu.private_memory import array_view
from springback.kernels.gpu.ptx import (
    Constants,
    PtxError,
    kernel_of,
    parameter,
    program,
)
from springback.kernels.layout import TreeLayout, rows
from springback.kernels.trees import leaves, rebuilt
from springback.results.flight import as_scenario
from springback.simulation.executor import advance
from springback.simulation.flight import (
    Executor,
    flight_buffers,
    flight_records,
    fly_many,
    shape_of,
)
from springback.simulation.gpu import flying
from springback.simulation.gpu import thread as threads
from springback.simulation.gpu.flying import fly_buffers_on_gpu, fly_groups_on_gpu
from springback.simulation.guided import avionics_buffers, fly_guided
from springback.simulation.noise import FlightNoise, generate
from springback.simulation.ticks import FlightBuffers, drive_rotors, sense_and_decide

WIDTH = 2


class HeldMemory:
    """In place of a GPU's memory."""

    def __init__(self, array: np.ndarray[Any, Any]) -> None:
        self.array = np.array(array)

    def read_into(self, array: np.ndarray[Any, Any]) -> None:
        array[:] = self.array

    def row(self, number: int) -> np.ndarray[Any, Any]:
        return self.array[number].copy()


class Interpreted:
    """In place of a loaded kernel: its threads one after the other, in plain Python."""

    launches = 0

    def __init__(self, entry: Any, parameters: list[Any]) -> None:
        entries = advance, sense_and_decide, drive_rotors, generate
        plain = {f.__name__: f.py_func for f in entries}
        self.entry = with_globals(entry, **plain)
        self.parameters = parameters

    def launch(self, flights: HeldMemory, *arguments: Any) -> None:
        Interpreted.launches += 1
        for flight in flights.array.tolist():
            given = list(arguments)
            values = [self.value(p, given, flight) for p in self.parameters]
            assert not given
            self.entry(*values, flight)

    def value(self, p: Any, given: list[Any], flight: int) -> Any:
        """Value of a parameter, from the launch's arguments, which are consumed in order."""
        if isinstance(p, TreeLayout):
            return p
        if isinstance(p, Constants):
            return self.tree(p, given, flight)
        if isinstance(p, tuple):
            return type(p)(*(self.value(one, given, flight) for one in p))
        one = given.pop(0)
        return one.array if isinstance(one, HeldMemory) else one

    @staticmethod
    def tree(p: Constants, given: list[Any], flight: int) -> Any:
        alike = [given.pop(0) for _ in range(p.varies.count(False))]
        memory, count = given.pop(0), given.pop(0)
        varying = list(memory.array.reshape(-1, count)[:, flight])
        picked = [varying.pop(0) if varies else alike.pop(0) for varies in p.varies]
        return rebuilt(p.like._tree, picked)


@pytest.fixture
def interpreted(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Kernels are run by the interpreter."""
    monkeypatch.setattr(flying, "Memory", HeldMemory)
    monkeypatch.setattr(flying, "_kinds", lambda kinds={}: kinds)
    monkeypatch.setattr(
        flying._KernelKind,
        "kernel",
        lambda kind, *masks: Interpreted(kind._entry, kind._parameters(*masks)),
    )
    Interpreted.launches = 0
    yield
    assert Interpreted.launches > 0


def scene(speed: float, mass: float) -> tuple[Any, Any]:
    """A short impact of a vehicle of some mass."""
    changed = (
        "simulation.duration=0.03", "simulation.impact_step=4e-4", f"vehicle.body.mass={mass}",
        "world.obstacles[0].surface.slip_speed=1",
    )  # fmt: skip
    given = towards_wall("arq", speed, position=[0.697, 0.0, 0.0], pitch=0.2, yaw=0.4)
    scenario = as_scenario(given, changed)
    return scenario.flight_model(), scenario.start_state()


@pytest.mark.usefixtures("interpreted")
def test_threads_fly_impacts_as_the_processor_does(monkeypatch: pytest.MonkeyPatch) -> None:
    """Motion and record bit for bit; masses differ, all else is alike; a launch ends early."""
    monkeypatch.setattr(flying, "SLICE", 20)
    made = [scene(speed, mass) for speed, mass in ((2.0, 1.0), (1.5, 1.1), (2.5, 1.2))]
    models, starts = [model for model, _ in made], [start for _, start in made]
    shape = shape_of(models[0], starts[0])
    buffers = flight_buffers(shape, models, starts, WIDTH)
    shares: list[float] = []
    fly_buffers_on_gpu(shape, buffers, WIDTH, progress=shares.append)
    flown = flight_records(shape, models, starts, buffers, WIDTH)
    there = fly_many(models, starts)
    assert len({one.record.peaks.acceleration for one in there}) == len(made)
    assert all(one.record.contacts.total > 0.0 for one in there)
    for one, other in zip(flown, there, strict=True):
        assert leaves(one.motion) == leaves(other.motion)
        assert leaves(one.record) == leaves(other.record)
    assert Interpreted.launches > 1
    assert shares[-1] == 1.0
    assert shares == sorted(shares)


STOP = {"guard_force": 5.0, "restart_after": 0.004, "rotor_inertia": 2e-5,
        "thrust_coefficient": 8e-6}  # fmt: skip
#: What a tick sets in the model: thrusts alone; winds and reactions of rotors that stop, too.
SET_AT_TICKS = {
    "thrusts": {"vehicle": "arq"},
    "winds and reactions": {
        "air": GUSTY, "vehicle": {"preset": "arq", "propulsion": {"stop": STOP}},
    },
}  # fmt: skip


@pytest.mark.parametrize("name", SET_AT_TICKS)
@pytest.mark.usefixtures("interpreted")
def test_threads_fly_with_a_pilot_as_the_processor_does(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Motion, record and on-board systems, from launch to launch, with each flight's own noise."""
    monkeypatch.setattr(flying, "TICKS", 17)
    monkeypatch.setattr(flying, "FEW_TICKS", 3)
    monkeypatch.setattr(flying, "SLICE", 5)
    given = {"estimator": "complementary", "world": WALL, **SET_AT_TICKS[name]}
    flights: list[Lane] = [
        lane(tables(0.03, start={**AT_WALL, "velocity": (speed, 0.1, 0.0)}, **given), flight)
        for flight, speed in enumerate((2.0, 1.0, 3.0))
    ]
    ready = [one.alone for one in flights]
    first = ready[0].flight
    shape = shape_of(first.model, first.start)
    models = [one.flight.model for one in ready]
    starts = [one.flight.start for one in ready]
    buffers = flight_buffers(shape, models, starts, WIDTH)
    onboard = avionics_buffers([one.flight.avionics for one in ready], WIDTH)
    seeds, numbers = [one.seed for one in flights], [one.flight for one in flights]
    noise = FlightNoise(flights[0].draws, seeds, numbers)
    fly_groups_on_gpu(first, FlightBuffers(buffers, onboard, (0,) * WIDTH), noise)
    flown = flight_records(shape, models, starts, buffers, WIDTH)
    memories = onboard.reshape(len(buffers), -1, WIDTH)
    after, touched = rows(first.avionics.systems), set()
    for k, (one, alone) in enumerate(zip(flown, ready, strict=True)):
        # Compiled or not, the bits are the same; the second kind is not worth a compilation.
        executor: Executor = "compiled" if name == "thrusts" else "python"
        there = fly_guided(*alone, trace=False, executor=executor)
        inside = rebuilt(first.avionics.onboard, memories[k // WIDTH, after:, k % WIDTH])
        assert same(there._replace(flown=one, onboard=inside), there)
        touched.add(there.flown.record.contacts.total > 0.0)
    assert touched == {True, False}
    assert Interpreted.launches > 10  # those of full steps between those of ticks


def test_a_kernel_that_is_there_serves_flights_of_which_less_varies() -> None:
    """Another one is compiled only where a leaf varies that it takes for constant."""
    kind = flying._KernelKind(None, None, None, None)
    wide: Any = (True, False, True), (True,)
    kind._loaded = {wide: object(), ((True, True, True), (True,)): object()}  # type: ignore[dict-item]
    model = np.array([[1.0, 2.0], [3.0, 3.0], [4.0, 4.0]])
    assert kind.masks(model, np.array([[1.0, 1.0]])) == wide
    assert kind.masks(model[::-1].copy()[[0, 2, 1]], np.array([[0.0, -0.0]])) == (
        (True, True, True), (True,),
    )  # fmt: skip
    kind._loaded = {}
    assert kind.masks(model, np.array([[0.0, -0.0]])) == ((True, False, False), (True,))


def ptx_of_impacts(precision: Precision) -> str:
    """The kernel of impacts of which the mass alone varies."""
    model, start = scene(2.0, 1.0)
    shape = shape_of(model, start)
    kind = flying._impacts(shape, precision)
    mask = tuple(k == 0 for k in range(rows(shape.model)))
    types = [parameter(p) for p in kind._parameters(mask)]
    given = kind._entry, types, kind._parts, kind._files, precision
    return kernel_of(program(*given), types).text


@pytest.fixture(scope="module")
def impact_ptx() -> str:
    """The kernel of impacts in double precision."""
    return ptx_of_impacts("double")


def test_nothing_is_contracted_or_approximated(impact_ptx: str) -> None:
    """Each operation is rounded to nearest as written: no fused one, no approximate one."""
    assert len(re.findall(r"(?:add|sub|mul)\.rn\.f64", impact_ptx)) > 2000
    assert re.search(r"sqrt\.rn\.f64", impact_ptx)
    assert re.search(r"div\.rn\.f64|rcp\.rn\.f64", impact_ptx)
    assert not re.search(r"\bfma|\bmad\.\w+\.f|approx|\.ftz|\.f32", impact_ptx)
    assert not re.search(r"(?:add|sub|mul|div|sqrt)\.f64", impact_ptx)


def test_single_precision_is_single_throughout(impact_ptx: str) -> None:
    """The same instructions, each of them on floats; memory, constants and launch included."""
    single = ptx_of_impacts("single")
    counts = [len(re.findall(r"\.f(?:32|64)\b", text)) for text in (single, impact_ptx)]
    assert counts[0] == pytest.approx(counts[1], rel=0.01)
    assert "f64" not in single
    assert not re.search(r"\bfma|\bmad\.\w+\.f|approx|\.ftz", single)


@pytest.mark.usefixtures("interpreted")
def test_a_gpu_gets_single_precision_where_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    """Flights are laid out as floats of 32 bits, and come back as doubles."""
    kinds: set[Any] = set()

    def held(array: np.ndarray[Any, Any]) -> HeldMemory:
        if array.dtype != np.int64:  # numbers of flights
            kinds.add(array.dtype)
        return HeldMemory(array)

    monkeypatch.setattr(flying, "Memory", held)
    model, start = scene(2.0, 1.0)
    shape = shape_of(model, start)
    buffers = [flight_buffers(shape, [model], [start], WIDTH) for _ in range(2)]
    fly_buffers_on_gpu(shape, buffers[0], WIDTH, precision="single")
    assert kinds == {np.dtype(np.float32)}
    fly_buffers_on_gpu(shape, buffers[1], WIDTH)
    rough, fine = (flight_records(shape, [model], [start], each, WIDTH)[0] for each in buffers)
    assert leaves(rough.record) != leaves(fine.record)
    speeds = [one.record.first_impact.separation_speed for one in (rough, fine)]
    assert speeds[0] == pytest.approx(speeds[1], rel=1e-3)


def test_a_flight_lives_in_registers(impact_ptx: str) -> None:
    """No memory of a thread's own is asked for; what is alike comes with the launch."""
    assert ".local" not in impact_ptx
    assert not re.search(r"\bcall\b", impact_ptx)
    model, start = scene(2.0, 1.0)
    alike = rows(shape_of(model, start).model) - 1
    assert len(re.findall(r"\.param \.b64 fly_impact_param|\.param \.f64", impact_ptx)) >= alike


def _powers(data: Any, count: int, thread: int) -> None:
    values = array_view(data, 1, count)
    values[0, thread] = values[0, thread] ** 2.7


def test_what_a_gpu_does_not_have_is_said() -> None:
    """A power of any exponent calls the C library on a processor; a GPU has none."""
    types = [parameter(np.zeros(1)), parameter(1)]
    with pytest.raises(PtxError, match="there is no pow on a GPU"):
        kernel_of(program(_powers, types, dict, None), types)


def test_parts_of_an_entry_point_are_named() -> None:
    """All that an entry point calls by name is given to it; else the processor's would be used."""
    at_ticks = {"sense_and_decide", "drive_rotors", "generate"}
    for entry, expected in (
        (threads.fly_impact, {"advance"}),
        (threads.fly_to_tick, {"advance"}),
        (threads.fly_ticks, at_ticks),
    ):
        called = {advance, sense_and_decide, drive_rotors, generate} & {
            threads.__dict__.get(name) for name in entry.__code__.co_names
        }
        assert {one.__name__ for one in called} == expected
    assert device_function(advance).py_func.__name__ == "advance"


def test_without_a_gpu_it_says_so_in_a_line(monkeypatch: pytest.MonkeyPatch) -> None:
    """No driver, or none of its devices: one sentence, and nothing is flown."""

    def refuse(name: str, *_: Any) -> Any:
        raise cuda.GpuError(f"{name}: no CUDA-capable device is detected")

    cuda.device.cache_clear()
    monkeypatch.setattr(cuda, "_call", refuse)
    with pytest.raises(InputError, match="device gpu: no NVIDIA GPU can be used here: cuInit"):
        cuda.device()
    cuda.device.cache_clear()
