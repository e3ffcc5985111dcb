"""Single instructions that Python does not offer: the bits of floats, and selection."""

from __future__ import annotations

import struct
from typing import Any

import numba
import numpy as np
from numba import types

from springback.kernels.compiler import compiler_rule

_intrinsic: Any = numba.extending.intrinsic


def bits_of(x: float) -> Any:
    """The 64 bits of a float (IEEE 754 binary64) as an unsigned integer."""
    return np.uint64(struct.unpack("<Q", struct.pack("<d", x))[0])


def float_of(bits: Any) -> float:
    """The float with these 64 bits."""
    value: float = struct.unpack("<d", struct.pack("<Q", int(bits)))[0]
    return value


@_intrinsic  # type: ignore[untyped-decorator]
def _as_bits(context: Any, x: Any) -> Any:
    def cast(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.bitcast(arguments[0], context.get_value_type(types.uint64))

    return types.uint64(types.float64), cast


@_intrinsic  # type: ignore[untyped-decorator]
def _as_float(context: Any, bits: Any) -> Any:
    def cast(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.bitcast(arguments[0], context.get_value_type(types.float64))

    return types.float64(types.uint64), cast


@_intrinsic  # type: ignore[untyped-decorator]
def select_scalar(context: Any, claim: Any, a: Any, b: Any) -> Any:
    """The number a where ``claim`` holds, else b, of one type; compiled code only."""
    kind = context.unify_types(a, b)

    def choose(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        known = context.cast(builder, arguments[0], signature.args[0], types.boolean)
        return builder.select(known, arguments[1], arguments[2])

    return kind(claim, kind, kind), choose


@compiler_rule(bits_of)
def _bits_of(x: Any) -> Any:
    return lambda x: _as_bits(x)


@compiler_rule(float_of)
def _float_of(bits: Any) -> Any:
    return lambda bits: _as_float(bits)
