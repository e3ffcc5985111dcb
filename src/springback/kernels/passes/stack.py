"""Places on the stack for values of kernels, without what numba does for references.

numba fills each place with zeros, reads a variable before it is set anew and clears it when its
life ends, so that references can be dropped.  LLVM takes the zeros of a tree of hundreds of numbers
apart, leaf by leaf: more than half of all time that it took to simplify kernels.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from llvmlite import ir
from numba.core import cgutils

#: Parts of numba without type stubs, and its own step.
_places: Any = cgutils
_filled: Any = cgutils.alloca_once


@contextmanager
def bare_slots() -> Iterator[None]:
    """Context in which places that hold no address are not filled."""
    before, _places.alloca_once = _places.alloca_once, slot
    try:
        yield
    finally:
        _places.alloca_once = before


def slot(builder: Any, kind: Any, size: Any = None, name: str = "", zfill: bool = False) -> Any:
    """Place on the stack for a value of a machine type, as ``alloca_once`` of numba."""
    if zfill or size is not None or _holds_addresses(kind):
        return _filled(builder, kind, size, name, zfill)
    with builder.goto_entry_block():
        return builder.alloca(kind, name=name)


def _holds_addresses(kind: Any) -> bool:
    """True if an address is anywhere in values of a machine type."""
    if isinstance(kind, ir.ArrayType):
        return kind.count > 0 and _holds_addresses(kind.element)
    if isinstance(kind, ir.BaseStructType):
        return any(_holds_addresses(part) for part in kind.elements)
    return not isinstance(kind, (ir.IntType, ir.DoubleType, ir.FloatType))
