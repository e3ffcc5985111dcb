"""Kernels compiled once, apart from their callers, and tables of numbers, both by address.

An inlined kernel is compiled again by everything that uses it.  One that is long, and rarely needed
by several lanes at once, is compiled by itself, as a `Routine`, and called: its callers compile as
if it were not there, and are the same for whatever it does.  Routines read what has no fixed size,
such as a world of many obstacles, from a `NumberTable`.

Compiled code knows both by their address in memory, which a tree holds as a float: an address is
below 2⁵³, so it is kept exactly.
"""

from __future__ import annotations

import hashlib
import weakref
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Any, Self, TypeVar

import numba
import numpy as np
from llvmlite import ir
from numba import types

from springback.kernels.compiler import (
    cache_folder,
    compile_apart,
    compiler_rule,
    is_compiled_apart,
)
from springback.kernels.trees import leaves, rebuilt

T = TypeVar("T")

_intrinsic: Any = numba.extending.intrinsic
_typeof: Any = numba.typeof
_unliteral: Any = types.unliteral

Numbers = np.ndarray[Any, np.dtype[np.float64]]


class _SharedNumbers(np.ndarray[Any, Any]):
    """Numbers of a table, which hold the tables whose addresses are among them."""

    parts: tuple[NumberTable, ...]


class NumberTable(float):
    """Address of an array of floats, which lives at least as long as this object."""

    numbers: Numbers
    parts: Mapping[int, NumberTable]

    def __new__(cls, numbers: Numbers, parts: Mapping[int, NumberTable] | None = None) -> Self:
        """A table of these numbers, which are copied; the same numbers are at the same address.

        Args:
            numbers: The numbers.
            parts: Other tables, by the place at which their address is written among the numbers:
                several tables can share one that is large.
        """
        copied = np.array(numbers, dtype=np.float64).ravel().view(_SharedNumbers)
        for place, part in (parts or {}).items():
            copied[place] = float(part)
        copied.parts = tuple((parts or {}).values())
        content = hashlib.sha256(copied.tobytes()).digest()
        kept = _BY_CONTENT.setdefault(content, copied)
        kept.setflags(write=False)
        table = super().__new__(cls, kept.ctypes.data)
        table.numbers, table.parts = kept, dict(parts or {})
        _TABLES[float(table)] = kept
        table.hold()
        return table

    def hold(self) -> None:
        """Let `tables_held` hold this table, which may have been made before."""
        for keeper in _KEEPERS:
            keeper.append(self.numbers)

    def __reduce__(self) -> Any:
        """Pickle the numbers, not their address, and the tables that they name."""
        return NumberTable, (np.asarray(self.numbers), self.parts)


#: Arrays of all tables by address, and by digest, while anyone holds them.
_TABLES: weakref.WeakValueDictionary[float, Numbers] = weakref.WeakValueDictionary()
_BY_CONTENT: weakref.WeakValueDictionary[bytes, Numbers] = weakref.WeakValueDictionary()
#: Lists that hold every table that is made.
_KEEPERS: list[list[Numbers]] = []


@contextmanager
def tables_held() -> Iterator[None]:
    """Context that holds all tables made or asked for within it (`NumberTable.hold`).

    Buffers know them by their addresses only.
    """
    keeper: list[Numbers] = []
    _KEEPERS.append(keeper)
    try:
        yield
    finally:
        _KEEPERS.remove(keeper)


def numbers_of(table: float) -> Numbers:
    """All numbers of a table, in plain Python."""
    return _TABLES[table]


def number_at(table: float, k: int) -> float:
    """Number ``k`` of a table."""
    return float(_TABLES[table][k])


def number_pointer(context: Any, builder: Any, address: Any, k: Any) -> Any:
    """Pointer to number ``k`` of a table, in code of the compiler."""
    whole = builder.fptoui(address, ir.IntType(64))
    base = builder.inttoptr(whole, ir.DoubleType().as_pointer())
    return builder.gep(base, [k])


@_intrinsic  # type: ignore[untyped-decorator]
def _load_number(typing_context: Any, table: Any, k: Any) -> Any:
    def lower(context: Any, builder: Any, signature: Any, given: Any) -> Any:
        return builder.load(number_pointer(context, builder, *given))

    return types.float64(types.float64, types.int64), lower


@compiler_rule(number_at)
def _number_at(table: Any, k: Any) -> Any:
    return lambda table, k: _load_number(table, k)


class Routine:
    """A kernel that is compiled once for all its callers, and called by its address."""

    def __init__(self, function: Callable[[Any], Any], arguments: Any) -> None:
        """A routine; it is compiled, or read from the cache, when its address is first asked for.

        Args:
            function: Of one tree, returning a tree; a kernel.
            arguments: A tree of the shape of the argument.
        """
        self.function = function
        self._arguments = arguments
        self._address: float | None = None
        self._compiled: Any = None

    @property
    def address(self) -> float:
        """Address of the code, as a float; in `routines_deferred` 0 if it is not compiled."""
        if self._address is None:
            signature = (_typeof(self._arguments),)
            asked = _DEFERRED.get()
            if asked is not None and not is_compiled_apart(
                self.function, signature, cache_folder()
            ):
                asked.append(self)
                return 0.0
            self._compiled = compile_apart(self.function, signature, cache_folder())
            self._address = float(self._compiled.address)
            _ROUTINES[self._address] = self
        return self._address

    def call_compiled(self, argument: Any) -> Any:
        """Result of the compiled code, in plain Python."""
        return self._compiled.owner(rebuilt(self._arguments, leaves(argument)))


#: Routines by address; none is ever unloaded.
_ROUTINES: dict[float, Routine] = {}


#: Routines asked for but not compiled, within `routines_deferred`; other threads are outside.
_DEFERRED: ContextVar[list[Routine] | None] = ContextVar("_DEFERRED", default=None)


@contextmanager
def routines_deferred() -> Iterator[list[Routine]]:
    """Context in which no routine is compiled: trees that name one have types, but cannot be flown.

    Yields:
        Routines that are still to be compiled, as they are asked for.
    """
    asked: list[Routine] = []
    before = _DEFERRED.set(asked)
    try:
        yield asked
    finally:
        _DEFERRED.reset(before)


def call_routine(address: float, argument: Any, like: T) -> T:
    """Result of the routine at an address.

    Args:
        address: `Routine.address`.
        argument: A tree of floats, of the shape that the routine was made for.
        like: A tree of the shape of the result.
    """
    routine = _ROUTINES[address]
    result: T = (routine.call_compiled if _COMPILED else routine.function)(argument)
    return result


#: Not empty while plain Python calls compiled routines.
_COMPILED: list[bool] = []


@contextmanager
def routines_compiled() -> Iterator[None]:
    """Context in which plain Python calls the compiled routines, a hundred times as fast.

    Set-up uses it; a flight in plain Python does not, as it shows that all executors agree.
    """
    _COMPILED.append(True)
    try:
        yield
    finally:
        _COMPILED.pop()


@_intrinsic  # type: ignore[untyped-decorator]
def _call_at(typing_context: Any, address: Any, argument: Any, like: Any) -> Any:
    result = _floats(like)

    def lower(context: Any, builder: Any, signature: Any, given: Any) -> Any:
        kinds = (_floats(signature.args[1]),)
        wanted = context.call_conv.get_function_type(result, kinds).as_pointer()
        whole = builder.fptoui(given[0], ir.IntType(64))
        callee = builder.inttoptr(whole, wanted)
        value = context.cast(builder, given[1], signature.args[1], kinds[0])
        _, found = context.call_conv.call_function(builder, callee, result, kinds, [value])
        return found

    return result(types.float64, argument, like), lower


@_intrinsic  # type: ignore[untyped-decorator]
def run_at(typing_context: Any, address: Any, arguments: Any) -> Any:
    """Run an entry point without a result, in compiled code.

    Args:
        typing_context: The compiler's.
        address: `springback.kernels.compiler.code_address`.
        arguments: A tuple of those for whose types it is.
    """
    kinds = tuple(map(_unliteral, arguments))

    def lower(context: Any, builder: Any, signature: Any, given: Any) -> Any:
        wanted = context.call_conv.get_function_type(types.none, kinds).as_pointer()
        callee = builder.inttoptr(given[0], wanted)
        values = [
            context.cast(builder, builder.extract_value(given[1], k), arguments[k], kinds[k])
            for k in range(len(kinds))
        ]
        context.call_conv.call_function(builder, callee, types.none, kinds, values)
        return context.get_dummy_value()

    return types.none(types.int64, arguments), lower


def _floats(tree: Any) -> Any:
    """Type of a tree with literals taken as the floats that they are."""
    return _unliteral(tree)


@compiler_rule(call_routine)
def _call_routine(address: Any, argument: Any, like: Any) -> Any:
    return lambda address, argument, like: _call_at(address, argument, like)
