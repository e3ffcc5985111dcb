"""The same kernels as PTX, the assembly language of NVIDIA's GPUs.

Numba lowers an entry point to LLVM IR exactly as it does for the processor, with the same flags on
every operation; LLVM's back end for NVIDIA then writes PTX instead of machine code.  Nothing is
contracted, reassociated or approximated, so a GPU returns the same bits as the processor
(docs/decisions/0025).  Neither a GPU nor a driver is needed for this.
"""

from __future__ import annotations

import contextlib
import hashlib
import itertools
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import filelock
import numba
import numpy as np
from llvmlite import binding, ir
from numba import types
from numba.core.compiler_lock import global_compiler_lock

from springback.kernels.compiler import Origin, cache_folder
from springback.kernels.gpu.nvptx import (
    ARCHITECTURE,
    Precision,
    device_function,
    lower,
    machine,
    target_context,
)
from springback.kernels.kernel_cache import load_program, save_program
from springback.kernels.layout import TreeLayout, TreeLayoutType
from springback.kernels.tree_code import branches

_Pointer: Any = types.CPointer
_tuple_type: Any = types.BaseTuple.from_types


class PtxError(RuntimeError):
    """A kernel needs something that a GPU does not have."""


#: Registers that give a thread its index.
_PLACES = ("ctaid", "ntid", "tid")


#: Functions of the C library that are one exact instruction.
_BUILT_IN = ("ceil", "fabs", "floor", "sqrt")
#: Functions that LLVM knows as intrinsics, and leaves to the C library.
_OF_A_LIBRARY = {
    "acos", "asin", "atan", "atan2", "cos", "cosh", "exp", "exp10", "exp2", "frexp", "ldexp", "log",
    "log10", "log2", "modf", "pow", "powi", "sin", "sincos", "sinh", "tan", "tanh",
}  # fmt: skip
#: Name of an entry point within its kernel.
_INNER = "flight_of_thread"


class Kernel(NamedTuple):
    """An entry point as PTX."""

    name: str
    text: str
    precision: Precision = "double"


class Constants(NamedTuple):
    """A tree that is constant during a flight, as an argument of an entry point.

    Leaves that are the same for all flights are arguments of the launch, which cost no instruction;
    only the others are read from the flights' buffers.
    """

    like: TreeLayout
    varies: tuple[bool, ...]
    """For each leaf: True if it differs from flight to flight."""


def parameter(value: Any) -> Any:
    """Compiler type of an argument of an entry point.

    Args:
        value: A `TreeLayout`, `Constants`, an array for its memory, a number, or a NamedTuple of
            these.
    """
    if isinstance(value, TreeLayout):
        return value._numba_type_
    if isinstance(value, Constants):
        return value
    if isinstance(value, tuple):
        return type(value)(*map(parameter, value))
    if isinstance(value, np.ndarray):
        return _Pointer(numba.from_dtype(value.dtype))
    return types.int64 if isinstance(value, int) else types.float64


def _kind(p: Any) -> Any:
    """Compiler type of a parameter from `parameter`."""
    if isinstance(p, Constants):
        return p.like._numba_type_.tree
    if isinstance(p, tuple):
        return _tuple_type([_kind(one) for one in p], type(p))
    return p


class Program(NamedTuple):
    """An entry point, lowered for some types; from here a kernel takes only seconds."""

    name: str
    bitcode: bytes
    digest: str | None
    """Digest of everything it depends on; None if it must not be cached."""
    precision: Precision = "double"


def program(
    entry: Callable[..., Any],
    parameters: Sequence[Any],
    parts: Callable[[], dict[str, Any]],
    sources: Origin | None = Origin((), (), ""),  # noqa: B008
    precision: Precision = "double",
) -> Program:
    """Lower an entry point, or load it from the cache.

    Args:
        entry: Called in every thread with the arguments of the launch and, last, the number of the
            thread's flight.
        parameters: Types of all arguments but the last, see `parameter`.
        parts: Returns replacements for globals of the entry, see `device_function`.
        sources: Origin of a user's code among the types; None disables caching.
        precision: Of all floats.
    """
    kinds = [_kind(p) for p in parameters]
    versions = [numba.__version__, str(binding.llvm_version_info), ARCHITECTURE]
    said = [entry.__qualname__, precision, *versions, *map(str, kinds)]
    said += sources.words() if sources is not None else []
    digest = hashlib.sha256("\n".join(said).encode()).hexdigest()[:32]
    if sources is None:
        return Program(entry.__name__, _bitcode(entry, kinds, parts(), precision), None, precision)
    path = _folder() / f"{digest}.bc"
    bitcode = load_program(path)
    if bitcode is None:
        bitcode = _bitcode(entry, kinds, parts(), precision)
        save_program(path, bitcode)
    return Program(entry.__name__, bitcode, digest, precision)


def _folder() -> Path:
    return cache_folder() / "ptx"


@contextlib.contextmanager
def one_at_a_time() -> Iterator[None]:
    """Lock shared by all processes: one of them compiles, the others then read the cache."""
    with contextlib.ExitStack() as held:
        with contextlib.suppress(OSError, NotImplementedError):  # no writable cache, or no locks
            _folder().mkdir(parents=True, exist_ok=True)
            held.enter_context(filelock.FileLock(_folder() / "lock"))
        yield


@global_compiler_lock  # type: ignore[untyped-decorator]
def _bitcode(
    entry: Callable[..., Any], kinds: Sequence[Any], parts: dict[str, Any], precision: Precision
) -> bytes:
    """Bitcode of an entry point and its callees, under the name of the entry point."""
    function = device_function(entry, precision, **parts)
    result = lower(function, precision, (*kinds, types.int64))
    module = binding.parse_assembly(str(result.library._final_module))
    _define_built_in(module, precision)
    for number, each in enumerate(module.functions):
        if each.name == result.fndesc.llvm_func_name:
            each.name = _INNER
        elif not each.is_declaration:
            each.linkage, each.name = "internal", f"part_{number}"
    for each in module.global_variables:
        each.linkage = "internal"
    bitcode: bytes = module.as_bitcode()
    return bitcode


@global_compiler_lock  # type: ignore[untyped-decorator]
def kernel_of(program: Program, parameters: Sequence[Any]) -> Kernel:
    """PTX of a program, given which values vary from flight to flight.

    A launch takes the memory of the numbers of the flights, one for each thread, and the number of
    threads. Then, in the order of all parameters: for `Constants` the leaves that do not vary, the
    memory of those that do, shape (varying leaves, flights), and the number of flights; for arrays
    their memory; for numbers themselves; for a `TreeLayout` nothing.

    Args:
        program: From `program`.
        parameters: The same as for `program`.

    Raises:
        PtxError: If it calls a function that a GPU does not have.
    """
    masks = repr([p.varies for p in flat(parameters) if isinstance(p, Constants)])
    mask = hashlib.sha256(masks.encode()).hexdigest()[:16]
    path = _folder() / f"{program.digest}-{mask}.ptx"
    known = load_program(path) if program.digest else None
    if known is not None:
        return Kernel(program.name, known.decode(), program.precision)
    module = binding.parse_bitcode(program.bitcode)
    module.link_in(binding.parse_assembly(_entry_text(program, parameters)))
    module.get_function(_INNER).linkage = "internal"
    _optimise(module)
    _check_calls(module)
    text = machine(ARCHITECTURE).emit_assembly(module)
    if program.digest:
        save_program(path, text.encode())
    return Kernel(program.name, text, program.precision)


def flat(parameters: Iterable[Any]) -> Iterator[Any]:
    """Parameters of an entry point one by one, those of NamedTuples included."""
    for p in parameters:
        if isinstance(p, tuple) and not isinstance(p, Constants):
            yield from flat(p)
        else:
            yield p


def _check_calls(module: Any) -> None:
    """Refuse calls that LLVM's back end cannot write: it would end the process."""
    for function in module.functions:
        first, _, rest = function.name.partition(".")
        name = rest.partition(".")[0] if first == "llvm" else function.name
        if function.is_declaration and (first != "llvm" or name in _OF_A_LIBRARY):
            raise PtxError(f"there is no {name} on a GPU")


def _define_built_in(module: Any, precision: Precision) -> None:
    """Implement functions of the C library by GPU instructions, which round identically."""
    kind, suffix = ("float", "f32") if precision == "single" else ("double", "f64")
    declared = {function.name for function in module.functions if function.is_declaration}
    for name in declared.intersection(_BUILT_IN):
        text = (
            f"define {kind} @{name}({kind} %x) alwaysinline {{\n"
            f"%y = call {kind} @llvm.{name}.{suffix}({kind} %x)\nret {kind} %y\n}}\n"
            f"declare {kind} @llvm.{name}.{suffix}({kind})\n"
        )
        module.link_in(binding.parse_assembly(text))


def _arguments_of(context: Any, p: Any) -> list[Any]:
    """Arguments of a launch for one parameter."""
    if isinstance(p, TreeLayoutType):
        return []
    if isinstance(p, Constants):
        number = context.get_value_type(types.float64)
        fixed = [number] * p.varies.count(False)
        return [*fixed, number.as_pointer(), ir.IntType(64)]
    return [context.get_value_type(p)]


def _entry_text(program: Program, parameters: Sequence[Any]) -> str:
    """Text of a kernel that calls a lowered entry point once in every thread that has a flight."""
    context = target_context(program.precision)
    module = context.codegen()._create_empty_module("entry")
    passed = [_arguments_of(context, p) for p in flat(parameters)]
    long = ir.IntType(64)
    kind = ir.FunctionType(ir.VoidType(), [long.as_pointer(), long, *itertools.chain(*passed)])
    kernel = ir.Function(module, kind, program.name)
    kernel.calling_convention = "ptx_kernel"
    builder = ir.IRBuilder(kernel.append_basic_block())
    word = ir.IntType(32)
    block, size, thread = (
        builder.call(
            ir.Function(module, ir.FunctionType(word, []), f"llvm.nvvm.read.ptx.sreg.{place}.x"), []
        )
        for place in _PLACES
    )
    place = builder.zext(builder.add(builder.mul(block, size), thread), long)
    flights, threads, *given = kernel.args
    with builder.if_then(builder.icmp_signed(">=", place, threads)):
        builder.ret_void()
    number, values = builder.load(builder.gep(flights, [place])), []
    for p, taken in zip(flat(parameters), passed, strict=True):
        mine, given = given[: len(taken)], given[len(taken) :]
        if isinstance(p, TreeLayoutType):
            values.append(context.get_dummy_value())
        elif isinstance(p, Constants):
            values += _constants(builder, p, mine, number)
        else:
            values += mine
    kinds = [*map(_kind, parameters), types.int64]
    arguments = [_tree(context, builder, kind, values) for kind in kinds[:-1]]
    inner = ir.Function(module, context.call_conv.get_function_type(types.none, kinds), _INNER)
    context.call_conv.call_function(builder, inner, types.none, kinds, [*arguments, number])
    builder.ret_void()
    return str(module)


def _constants(builder: Any, p: Constants, given: Sequence[Any], flight: Any) -> list[Any]:
    """All leaves of the settings, in order: arguments, or read for the flight of a thread."""
    *fixed, pointer, count = given
    values, row = [], 0
    for varies in p.varies:
        if varies:
            place = builder.add(builder.mul(ir.Constant(ir.IntType(64), row), count), flight)
            values.append(builder.load(builder.gep(pointer, [place])))
            row += 1
        else:
            values.append(fixed.pop(0))
    return values


def _tree(context: Any, builder: Any, kind: Any, values: list[Any]) -> Any:
    """A value of a type from its leaves, consumed in order."""
    if not isinstance(kind, types.BaseTuple):
        return values.pop(0)
    tree = ir.Constant(context.get_value_type(kind), ir.Undefined)
    for k, branch in enumerate(branches(kind)):
        tree = builder.insert_value(tree, _tree(context, builder, branch, values), k)
    return tree


def _optimise(module: Any) -> None:
    """Run LLVM's optimisation level 3 for a GPU."""
    back_end = machine(ARCHITECTURE)
    options = binding.create_pipeline_tuning_options(speed_level=3)
    options.loop_vectorization = options.slp_vectorization = False
    builder = binding.create_pass_builder(back_end, options)
    builder.getModulePassManager().run(module, builder)
