"""How kernels are called, when compiled: trees in one piece, errors where there are any."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
import pytest
from numba import njit, typeof
from numba.core import cgutils
from numba.core.compiler_lock import global_compiler_lock

from builders.cases import nonempty
from springback.kernels.compiler import (
    STRICT,
    called_kernel,
    executor,
    generic,
    kernel,
    list_kernel,
    rare_kernel,
)
from springback.kernels.gpu.nvptx import device_function, lower
from springback.kernels.passes import pipeline
from springback.kernels.passes.pipeline import _KernelLibrary
from springback.kernels.trees import select, tree_map
from springback.simulation.lanes import lanes_of


class Pair(NamedTuple):
    """A tree with a branch."""

    a: float
    inner: tuple[float, float]
    claim: bool


@kernel
def _made(x: float, scale: float = 2.0) -> Pair:
    """Two returns, and an argument that is left out."""
    if x > 1.0:
        return Pair(x * scale, (x, -x), True)
    return Pair(-x, (0.0, x), False)


@kernel
def _mixed(one: Pair, other: Pair) -> Pair:
    """A tree of two others, one of which is chosen."""
    chosen = select(one.a > other.a, one, other)
    return Pair(chosen.a, (one.inner[1], other.inner[0]), chosen.claim)


@kernel
def _checked(x: float) -> Pair:
    """A kernel that can raise."""
    if x > 5.0:
        raise ValueError("beyond 5")
    return _made(x)


@kernel
def _through(x: float) -> Pair:
    """A kernel that calls one that can raise."""
    return _mixed(_checked(x), _made(x, 3.0))


@kernel
def _perhaps(x: float) -> float | None:
    """A number, or none."""
    return x if x > 1.0 else None


@kernel
def _put(out: np.ndarray, k: int, pair: Pair) -> None:
    """A kernel without a result."""
    out[k] = pair.a
    out[k + 1] = pair.inner[0] - 10.0 * pair.inner[1] + (100.0 if pair.claim else 0.0)


@executor()
def _fill(x: float, out: np.ndarray) -> None:
    _put(out, 0, _mixed(_made(x), _made(x - 1.0, 7.0)))
    _put(out, 2, _through(x))
    number = _perhaps(x)
    if number is not None:
        out[4] = number


#: The compiled entry point, with what the compiler adds to it.
_run: Any = _fill


@pytest.mark.parametrize("x", [-0.5, 0.5, 1.5, 2.5, 4.75])
def test_kernels_give_compiled_what_they_give_in_python(x: float) -> None:
    compiled, plain = np.zeros(5), np.zeros(5)
    _run(x, compiled)
    _run.py_func(x, plain)
    assert compiled.tobytes() == plain.tobytes()
    assert np.any(plain)


def test_an_error_passes_through_kernels_that_are_inlined() -> None:
    with pytest.raises(ValueError, match="beyond 5"):
        _run(5.5, np.zeros(5))


def test_no_kernel_remains_to_be_called() -> None:
    # Code read from the cache cannot be looked at: this copy is compiled here, whoever ran before.
    entry: Any = njit(**STRICT)(_run.py_func)
    entry(0.0, np.zeros(5))
    for text in nonempty(entry.inspect_llvm().values()):
        assert "_mixed" not in "".join(
            line for line in text.splitlines() if line.startswith(("define", "declare"))
        )


@kernel
def _turned(x: float, count: int) -> Pair:
    """A variable that is set anew: numba would read and clear it, too."""
    turned = _made(x)
    for _ in range(count):
        turned = _mixed(turned, _made(x + turned.a))
    return turned


@executor()
def _fill_turned(x: float, out: np.ndarray) -> None:
    _put(out, 0, _turned(x, len(out)))


_turn: Any = _fill_turned


def test_places_of_trees_are_not_filled_with_zeros(monkeypatch: pytest.MonkeyPatch) -> None:
    """LLVM takes zeros of hundreds of numbers apart; code that others compile has them as ever."""
    texts = []
    take = _KernelLibrary.add_llvm_module

    def listen(library: Any, module: Any) -> None:
        texts.append(str(module))
        take(library, module)

    monkeypatch.setattr(_KernelLibrary, "add_llvm_module", listen)
    entry: Any = njit(**STRICT)(_turn.py_func)
    compiled, plain = np.zeros(2), np.zeros(2)
    entry(0.7, compiled)
    entry.py_func(0.7, plain)
    assert compiled.tobytes() == plain.tobytes()
    (turned,) = (
        text for text in texts if "6_mixed" in text and "5_made" in text and "fcmp" not in text
    )
    trees = [line for line in turned.splitlines() if "{ double" in line]
    assert any("alloca" in line for line in trees)
    assert not any("zeroinitializer" in line for line in trees)
    assert cgutils.alloca_once.__module__ == "numba.core.cgutils"


@pytest.mark.parametrize(("most", "simplified"), [(0.1, []), (20.0, ["wrapped"])])
def test_a_kernel_that_wraps_a_long_one_is_simplified_with_its_caller(
    most: float, simplified: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """By itself, it would repeat what was done for the long one."""
    found = []
    simplify = _KernelLibrary._simplify

    def listen(library: Any) -> None:
        found.append(library.name.split(".")[-1])
        simplify(library)

    @kernel
    def wrapped(x: float, count: int) -> Pair:
        return _turned(x, count)

    def fill(x: float, out: np.ndarray) -> None:
        _put(out, 0, wrapped(x, len(out)))

    compiled, plain = np.zeros(2), np.zeros(2)
    fill(0.7, plain)
    njit(**STRICT)(_turn.py_func)(0.7, compiled)  # what it wraps is compiled before
    monkeypatch.setattr(_KernelLibrary, "_simplify", listen)
    monkeypatch.setattr(pipeline, "_THICK", 1000)
    monkeypatch.setattr(pipeline, "_THIN", most)
    entry: Any = njit(**STRICT)(fill)
    entry(0.7, compiled)
    assert compiled.tobytes() == plain.tobytes()
    assert [one for one in found if one == "wrapped"] == simplified


@called_kernel
def _deep(x: float) -> float:
    """A called kernel beneath a rare one."""
    total = 0.0
    for k in range(7):
        total += math.sin(k * x)
    return total


@rare_kernel
def _rare(x: float) -> float:
    """Exact about what is no number, as an inlined kernel is not."""
    return 0.0 if math.isnan(x) else _deep(x) - _deep(-2.0 * x)


@list_kernel
def _listed(x: float, count: int) -> float:
    values = [0.0] * count
    for k in range(count):
        values[k] = _rare(k - x)
    return values[0] - 3.0 * values[count - 1]


@kernel
def _often(x: float) -> float:
    return _rare(x) + _rare(x * x) + _deep(0.5 * x)


@executor()
def _fill_rarely(x: float, out: np.ndarray) -> None:
    out[0], out[1], out[2] = _often(x), _often(x + 1.0), _listed(x, len(out))


_rarely: Any = _fill_rarely


def _functions(entry: Any, name: str) -> tuple[int, int]:
    """How often a kernel is defined in the code of an entry point, and how often called."""
    lines = [line for text in entry.inspect_llvm().values() for line in text.splitlines()]
    named = [line for line in lines if name in line]
    defined = [line for line in named if line.startswith("define")]
    return len(defined), sum(" call " in line for line in named)


def test_instructions_are_put_in_order_once_more_for_lanes_only(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Of what flies several flights; whatever was compiled, the compiler is then as it was."""
    told: list[str] = []
    monkeypatch.setattr(pipeline, "set_option", lambda _, option: told.append(option))

    def over_lanes(lanes: tuple[int, ...], x: float) -> float:
        return len(lanes) * x

    in_lanes: Any = njit(**STRICT)(over_lanes)
    assert in_lanes(lanes_of(1), 2.0) == 2.0
    assert in_lanes(lanes_of(8), 2.0) == 16.0
    order, past = "-post-RA-scheduler", "-enable-aa-sched-mi"
    alone, together = [f"{order}=false", f"{past}=false"], [f"{order}=true", f"{past}=true"]
    as_it_was = [f"{order}=true", f"{past}=false"]
    assert told == [*alone, *as_it_was, *together, *as_it_was]


def test_kernels_for_rare_events_are_called_not_copied() -> None:
    """Inlined where they are called, they would be most of the code, and most of the compiling."""
    entry: Any = njit(**STRICT)(_rarely.py_func)
    compiled, plain = np.zeros(3), np.zeros(3)
    entry(0.7, compiled)
    entry.py_func(0.7, plain)
    assert compiled.tobytes() == plain.tobytes()
    assert np.all(plain != 0.0)
    for name in ("5_rareB", "5_deepB"):
        defined, called = _functions(entry, name)
        assert 1 <= defined < called


def test_kernels_for_rare_events_know_what_is_no_number() -> None:
    out = np.full(3, np.nan)
    _rarely(np.nan, out)
    assert out[2] == 0.0


@generic
def _size(one: Pair) -> float:
    """Dispatched by type, as the laws of contacts are."""
    raise TypeError


@_size.register(Pair)
@kernel
def _size_of_pair(one: Pair) -> float:
    return one.a + one.inner[0]


def test_a_processor_compiles_after_a_gpu_has() -> None:
    """And the other way round: numba keeps one implementation of a function for all targets."""
    pairs = (_made(0.5), _made(2.0))

    def sizes(pairs: tuple[Pair, ...]) -> tuple[float, ...]:
        return tree_map(_size, (pairs,), ())

    def doubled(pairs: tuple[Pair, ...]) -> tuple[float, ...]:
        return tree_map(_size, (pairs,), ()) + tree_map(_size, (pairs,), ())

    expected, kinds = tuple(one.a + one.inner[0] for one in pairs), (typeof(pairs),)
    for function, times in ((sizes, 1), (doubled, 2)):
        assert njit(**STRICT)(function)(pairs) == times * expected
        with global_compiler_lock:
            assert lower(device_function(function), "double", kinds).library is not None
