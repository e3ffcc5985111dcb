"""Memory private to one thread of a GPU, and arrays over the memory that all threads share.

In Python these are arrays; when compiled for a GPU, `MEMORY` replaces them.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numba
import numpy as np
from llvmlite import ir
from numba import types
from numba.np import arrayobj

from springback.kernels.layout import rows
from springback.kernels.trees import leaf_count

#: Parts of numba with incomplete type stubs, or none.
_intrinsic: Any = numba.extending.intrinsic
_arrays: Any = arrayobj


def private(like: Any) -> Any:
    """Uninitialised memory of one thread for a tree, shape (1, leaves)."""
    return np.full((1, rows(like)), np.nan)


def private_words(first: int, second: int) -> Any:
    """Unsigned integers of one thread, shape (first, second), constants of the source."""
    return np.zeros((first, second), dtype=np.uint64)


def private_counters(first: int, second: int) -> Any:
    """Integers of one thread, shape (first, second), constants of the source."""
    return np.zeros((first, second), dtype=np.int64)


def private_floats(first: int, second: int) -> Any:
    """Floats of one thread, shape (first, second), constants of the source."""
    return np.zeros((first, second))


def array_view(pointer: Any, first: int, second: int) -> Any:
    """Array that begins at a pointer, shape (first, second); an array is its own pointer."""
    return pointer.reshape(-1)[: first * second].reshape(first, second)


def opaque(buffer: Any) -> Any:
    """The same array of `private` memory, with its contents hidden from the optimiser.

    Otherwise the compiler would keep all of it in registers, which are too few, from one iteration
    of a loop to the next.
    """
    return buffer


def _array(context: Any, builder: Any, kind: Any, data: Any, shape: Sequence[Any]) -> Any:
    """An array over memory that it does not own."""
    array = context.make_array(kind)(context, builder)
    element = context.get_abi_sizeof(context.get_data_type(kind.dtype))
    strides = [size := ir.Constant(ir.IntType(64), element)]
    for count in reversed(shape[1:]):
        strides.insert(0, builder.mul(strides[0], count))
    _arrays.populate_array(
        array,
        data=builder.bitcast(data, array.data.type),
        shape=list(shape),
        strides=strides,
        itemsize=size,
        meminfo=None,
    )
    return array._getvalue()


def _allocation(element: Any, *counts: int) -> Any:
    """Rule that lowers to memory of one thread."""

    def lower(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        of = context.get_data_type(element)
        with builder.goto_entry_block():
            data = builder.alloca(ir.ArrayType(of, math.prod(counts)))
        shape = [ir.Constant(ir.IntType(64), count) for count in counts]
        return _array(context, builder, signature.return_type, data, shape)

    return lower


def _for_tree(*before: int) -> Any:
    """Memory of one thread for a tree: an array with the leaves as its last dimension."""

    def typed(typing_context: Any, like: Any) -> Any:
        counts = *before, leaf_count(like.tree)
        array = types.Array(types.float64, len(counts), "C")
        return array(like), _allocation(types.float64, *counts)

    return _intrinsic(typed)


def _of_constants(element: Any) -> Any:
    """Memory of one thread with its shape written in the source."""

    def typed(typing_context: Any, first: Any, second: Any) -> Any:
        counts = first.literal_value, second.literal_value
        return types.Array(element, 2, "C")(first, second), _allocation(element, *counts)

    return _intrinsic(prefer_literal=True)(typed)


@_intrinsic  # type: ignore[untyped-decorator]
def _array_view(typing_context: Any, pointer: Any, first: Any, second: Any) -> Any:
    array = types.Array(pointer.dtype, 2, "C")

    def lower(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return _array(context, builder, array, arguments[0], arguments[1:])

    return array(pointer, types.int64, types.int64), lower


#: LLVM's address space of the memory private to a thread.
_LOCAL = 5


@_intrinsic  # type: ignore[untyped-decorator]
def _opaque(typing_context: Any, buffer: Any) -> Any:
    def lower(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        array = context.make_array(buffer)(context, builder, arguments[0])
        kind = array.data.type
        local = ir.PointerType(kind.pointee, addrspace=_LOCAL)
        asm = ir.InlineAsm(
            ir.FunctionType(local, [local]), "mov.b64 $0, $1;", "=l,l,~{memory}", side_effect=True
        )
        pointer = builder.call(asm, [builder.addrspacecast(array.data, local)])
        array.data = builder.addrspacecast(pointer, kind)
        return array._getvalue()

    return buffer(buffer), lower


#: Implementations of these functions on a GPU.
MEMORY = {
    "private": _for_tree(1),
    "private_words": _of_constants(types.uint64),
    "private_counters": _of_constants(types.int64),
    "private_floats": _of_constants(types.float64),
    "array_view": _array_view,
    "opaque": _opaque,
}
