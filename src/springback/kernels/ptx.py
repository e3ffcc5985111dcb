"""The same kernels as PTX, the assembly language of NVIDIA's GPUs.

Numba lowers an entry point to LLVM's language exactly as it does for the processor, with the same
flags on every operation; LLVM's own back end for NVIDIA then writes PTX instead of machine code.
Nothing is contracted, reassociated or approximated, so a GPU returns the bits that the processor
returns (docs/decisions/0025).  No GPU and no driver is needed to get this far.
"""

from __future__ import annotations

import contextlib
import functools
import hashlib
import itertools
import math
import os
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import filelock
import numba
import numpy as np
from llvmlite import binding, ir
from numba import types
from numba.core import (
    codegen,
    cpu,
    descriptors,
    dispatcher,
    fastmathpass,
    registry,
    runtime,
    target_extension,
    typing,
)
from numba.core.compiler_lock import global_compiler_lock
from numba.np import arrayobj

from springback.kernels.compiler import STRICT, Origin, cache_folder, is_writable, rebound
from springback.kernels.layout import Like, LikeType, rows
from springback.kernels.trees import branches, leaf_count

#: Parts of numba whose stubs know only some of them, or that have none.
_intrinsic: Any = numba.extending.intrinsic
_AOTLibrary: Any = codegen.AOTCodeLibrary
_AOTCodegen: Any = codegen.AOTCPUCodegen
_CPUContext: Any = cpu.CPUContext
_CPU: Any = target_extension.CPU
_Descriptor: Any = descriptors.TargetDescriptor
_AnyDispatcher: Any = dispatcher.Dispatcher
_typing: Any = typing
_runtime: Any = runtime
_fastmath: Any = fastmathpass
_override: Any = target_extension.target_override
_arrays: Any = arrayobj
_Pointer: Any = types.CPointer

_TRIPLE = "nvptx64-nvidia-cuda"
#: Architectures are compatible upwards: what is written for this one runs on all later ones.
ARCHITECTURE = "sm_70"
_NAME = "ptx"


class PtxError(RuntimeError):
    """A kernel needs what a GPU does not have."""


# -- numba's target -------------------------------------------------------------------------------


class _Ptx(_CPU):  # type: ignore[misc]
    """Whatever numba knows to lower for a processor, it lowers for this target, too."""


class _Library(_AOTLibrary):  # type: ignore[misc]
    """Lowered functions that wait for LLVM's back end."""

    def _optimize_functions(self, ll_module: Any) -> None:
        ll_module.data_layout = self._codegen._data_layout

    def _optimize_final_module(self) -> None:
        """Inline what is to be inlined; all else is done once, with everything at hand."""
        manager, builder = self._codegen._module_pass_manager(
            loop_vectorize=False, slp_vectorize=False, opt=1, cost="cheap"
        )
        manager.run(self._final_module, builder)


class _Codegen(_AOTCodegen):  # type: ignore[misc]
    _library_class = _Library

    def _init(self, llvm_module: Any) -> None:
        self._tm_features = ""
        self._tm = machine(ARCHITECTURE)
        self._data_layout = str(self._tm.target_data)
        self._target_data = self._tm.target_data
        self._loopvect, self._opt_level = False, 1

    def _create_empty_module(self, name: str) -> Any:
        module = super()._create_empty_module(name)
        module.triple = _TRIPLE
        return module


class _Context(_CPUContext):  # type: ignore[misc]
    allow_dynamic_globals = True  # addresses of functions, which nothing reads

    @global_compiler_lock  # type: ignore[untyped-decorator]
    def init(self) -> None:
        self.is32bit = False
        self._internal_codegen = _Codegen("springback.ptx")

    def load_additional_registries(self) -> None:
        _runtime.rtsys.initialize(
            registry.cpu_target.target_context
        )  # numba has one, the processor's
        super().load_additional_registries()

    def post_lowering(self, module: Any, library: Any) -> None:
        """The flags of the arithmetic; but nothing counts references here."""
        if self.fastmath:
            _fastmath.rewrite_module(module, self.fastmath)

    def get_executable(self, library: Any, fndesc: Any, env: Any) -> Any:
        return object()  # a name for what was lowered, which this process cannot call


class _Target(_Descriptor):  # type: ignore[misc]
    options = cpu.CPUTargetOptions

    @functools.cached_property
    def _contexts(self) -> tuple[Any, Any]:
        known = _typing.Context()
        return known, _Context(known, _NAME)

    @property
    def typing_context(self) -> Any:
        return self._contexts[0]

    @property
    def target_context(self) -> Any:
        return self._contexts[1]


class _Dispatcher(_AnyDispatcher):  # type: ignore[misc]
    targetdescr = _Target(_NAME)

    def add_overload(self, cres: Any) -> None:
        self.overloads[tuple(cres.signature.args)] = cres


def _decorated(function: Any = None, **options: Any) -> Any:
    """What stands for `numba.njit` while code for a GPU is compiled."""
    if function is None:
        return lambda function: _decorated(function, **options)
    for name in ("pipeline_class", "nopython", "cache", "nogil"):
        options.pop(name, None)
    options |= {"_nrt": False, "no_cpython_wrapper": True, "no_cfunc_wrapper": True}
    return _Dispatcher(function, targetoptions={"nopython": True, **options})


target_extension.target_registry[_NAME] = _Ptx
target_extension.dispatcher_registry[_Ptx] = _Dispatcher
target_extension.jit_registry[_Ptx] = _decorated


def machine(architecture: str) -> Any:
    """LLVM's back end for NVIDIA's GPUs."""
    binding.initialize_all_targets()
    binding.initialize_all_asmprinters()
    target = binding.Target.from_triple(_TRIPLE)
    return target.create_target_machine(cpu=architecture, features="+ptx81", opt=3)


def device_function(function: Callable[..., Any], **others: Any) -> Any:
    """A function for entry points to call on a GPU; ``others`` replace globals of these names."""
    plain = getattr(function, "py_func", function)
    return _decorated(rebound(plain, **_MEMORY, **others), forceinline=True, **STRICT)


# -- memory ---------------------------------------------------------------------------------------


def private(like: Any) -> Any:
    """Memory of one thread for a tree, shape (1, leaves); what lies there is not known."""
    return np.full((1, rows(like)), np.nan)


def private_words(first: int, second: int) -> Any:
    """Unsigned whole numbers of one thread, shape (first, second), constants of the source."""
    return np.zeros((first, second), dtype=np.uint64)


def private_counters(first: int, second: int) -> Any:
    """Whole numbers of one thread, shape (first, second), constants of the source."""
    return np.zeros((first, second), dtype=np.int64)


def private_floats(first: int, second: int) -> Any:
    """Floats of one thread, shape (first, second), constants of the source."""
    return np.zeros((first, second))


def reached_over(pointer: Any, first: int, second: int) -> Any:
    """The array that begins at a pointer, shape (first, second); an array is its own pointer."""
    return pointer.reshape(-1)[: first * second].reshape(first, second)


def remembered(buffer: Any) -> Any:
    """The same array of `private` memory, of which nothing is known any more.

    Else the compiler would keep all of it in registers, which are too few, from one turn of a loop
    to the next.
    """
    return buffer


def _array(context: Any, builder: Any, kind: Any, data: Any, shape: Sequence[Any]) -> Any:
    """An array over memory that nobody owns."""
    array = context.make_array(kind)(context, builder)
    strides = [size := ir.Constant(ir.IntType(64), 8)]
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
    """How to lower memory of one thread."""

    def lower(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        of = context.get_data_type(element)
        with builder.goto_entry_block():
            data = builder.alloca(ir.ArrayType(of, math.prod(counts)))
        shape = [ir.Constant(ir.IntType(64), count) for count in counts]
        return _array(context, builder, signature.return_type, data, shape)

    return lower


def _for_tree(*before: int) -> Any:
    """Memory of one thread for a tree: an array whose last dimension are its leaves."""

    def typed(typing_context: Any, like: Any) -> Any:
        counts = *before, leaf_count(like.tree)
        array = types.Array(types.float64, len(counts), "C")
        return array(like), _allocation(types.float64, *counts)

    return _intrinsic(typed)


def _of_constants(element: Any) -> Any:
    """Memory of one thread, its shape written in the source."""

    def typed(typing_context: Any, first: Any, second: Any) -> Any:
        counts = first.literal_value, second.literal_value
        return types.Array(element, 2, "C")(first, second), _allocation(element, *counts)

    return _intrinsic(prefer_literal=True)(typed)


@_intrinsic  # type: ignore[untyped-decorator]
def _reached_over(typing_context: Any, pointer: Any, first: Any, second: Any) -> Any:
    array = types.Array(pointer.dtype, 2, "C")

    def lower(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return _array(context, builder, array, arguments[0], arguments[1:])

    return array(pointer, types.int64, types.int64), lower


#: Of LLVM: the memory of a thread alone.
_LOCAL = 5


@_intrinsic  # type: ignore[untyped-decorator]
def _remembered(typing_context: Any, buffer: Any) -> Any:
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


#: What these functions are on a GPU.
_MEMORY = {
    "private": _for_tree(1),
    "private_words": _of_constants(types.uint64),
    "private_counters": _of_constants(types.int64),
    "private_floats": _of_constants(types.float64),
    "reached_over": _reached_over,
    "remembered": _remembered,
}


# -- from an entry point to text ------------------------------------------------------------------

#: Registers that tell a thread its place.
_PLACES = ("ctaid", "ntid", "tid")


#: Functions of the C library that are one exact instruction.
_BUILT_IN = ("ceil", "fabs", "floor", "sqrt")
#: Functions that LLVM knows by name, and leaves to the C library.
_OF_A_LIBRARY = {
    "acos", "asin", "atan", "atan2", "cos", "cosh", "exp", "exp10", "exp2", "frexp", "ldexp", "log",
    "log10", "log2", "modf", "pow", "powi", "sin", "sincos", "sinh", "tan", "tanh",
}  # fmt: skip
#: What an entry point is called within its kernel.
_INNER = "flight_of_thread"


class Kernel(NamedTuple):
    """An entry point as PTX."""

    name: str
    text: str


class Constants(NamedTuple):
    """A tree that does not change during a flight, as an argument of an entry point.

    What is the same for all flights is an argument of the launch, which costs an instruction
    nothing; only the rest is read out of their buffers.
    """

    like: Like
    varies: tuple[bool, ...]
    """Of each leaf: whether it differs from flight to flight."""


def parameter(value: Any) -> Any:
    """Compiler type of an argument of an entry point.

    Args:
        value: A `Like`, `Constants`, an array for its memory, or a number.
    """
    if isinstance(value, Like):
        return value._numba_type_
    if isinstance(value, Constants):
        return value
    if isinstance(value, np.ndarray):
        return _Pointer(numba.from_dtype(value.dtype))
    return types.int64 if isinstance(value, int) else types.float64


class Program(NamedTuple):
    """An entry point, lowered for some types: from here on a kernel takes seconds."""

    name: str
    bitcode: bytes
    digest: str | None
    """Of all that it depends on; None for what is not to be kept."""


def program(
    entry: Callable[..., Any],
    parameters: Sequence[Any],
    parts: Callable[[], dict[str, Any]],
    sources: Origin | None = Origin((), (), ""),  # noqa: B008
) -> Program:
    """Lower an entry point, or take what is kept of it.

    Args:
        entry: Called in every thread with the arguments of the launch and, last, the number of the
            thread.
        parameters: Of all arguments but the last, see `parameter`.
        parts: Gives what stands for globals of the entry, see `device_function`.
        sources: Where a user's code among the types comes from; None keeps nothing.
    """
    kinds = [p.like._numba_type_.tree if isinstance(p, Constants) else p for p in parameters]
    said = [entry.__qualname__, numba.__version__, ARCHITECTURE, *map(str, kinds)]
    said += sources.words() if sources is not None else []
    digest = hashlib.sha256("\n".join(said).encode()).hexdigest()[:32]
    path = _kept(digest, "bc")
    if sources is not None and path.exists():
        return Program(entry.__name__, path.read_bytes(), digest)
    bitcode = _lowered(entry, kinds, parts())
    if sources is None:
        return Program(entry.__name__, bitcode, None)
    _keep(path, bitcode)
    return Program(entry.__name__, bitcode, digest)


def one_at_a_time() -> Any:
    """A lock among all processes: what one of them compiles the others then find."""
    folder = cache_folder() / "ptx"
    return filelock.FileLock(folder / "lock") if is_writable(folder) else contextlib.nullcontext()


def _kept(digest: str, ending: str) -> Path:
    return cache_folder() / "ptx" / f"{digest}.{ending}"


def _keep(path: Path, content: bytes) -> None:
    """Keep a file for other processes; not to be able to is no error."""
    if not is_writable(path.parent):
        return
    with contextlib.suppress(OSError):
        with tempfile.NamedTemporaryFile(dir=path.parent, delete=False) as draft:
            draft.write(content)
        os.replace(draft.name, path)


@global_compiler_lock  # type: ignore[untyped-decorator]
def _lowered(entry: Callable[..., Any], kinds: Sequence[Any], parts: dict[str, Any]) -> bytes:
    """Bitcode of an entry point and all that it calls, under the name of the entry point."""
    with _override(_NAME):
        result = device_function(entry, **parts)._compiler.compile((*kinds, types.int64), None)
    result.library._ensure_finalized()
    module = binding.parse_assembly(str(result.library._final_module))
    _define_built_in(module)
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
    """A program as PTX, for what varies from flight to flight.

    A launch takes, in the order of the parameters: for `Constants` the leaves that do not vary,
    the memory of those that do, shape (varying leaves, flights), and the number of flights; for
    arrays their memory; for numbers themselves; for a `Like` nothing.

    Args:
        program: Of `program`.
        parameters: The same as there.

    Raises:
        PtxError: If it calls what is not there on a GPU.
    """
    masks = repr([p.varies for p in parameters if isinstance(p, Constants)])
    mask = hashlib.sha256(masks.encode()).hexdigest()[:16]
    path = _kept(f"{program.digest}-{mask}", "ptx")
    if program.digest and path.exists():
        return Kernel(program.name, path.read_text())
    module = binding.parse_bitcode(program.bitcode)
    module.link_in(binding.parse_assembly(_entry_text(program.name, parameters)))
    module.get_function(_INNER).linkage = "internal"
    _optimise(module)
    _check_calls(module)
    text = machine(ARCHITECTURE).emit_assembly(module)
    if program.digest:
        _keep(path, text.encode())
    return Kernel(program.name, text)


def _check_calls(module: Any) -> None:
    """LLVM ends the process where its back end meets what it cannot write."""
    for function in module.functions:
        first, _, rest = function.name.partition(".")
        name = rest.partition(".")[0] if first == "llvm" else function.name
        if function.is_declaration and (first != "llvm" or name in _OF_A_LIBRARY):
            raise PtxError(f"there is no {name} on a GPU")


def _define_built_in(module: Any) -> None:
    """Give functions of the C library the GPU's instructions, which round as they do."""
    declared = {function.name for function in module.functions if function.is_declaration}
    for name in declared.intersection(_BUILT_IN):
        text = (
            f"define double @{name}(double %x) alwaysinline {{\n"
            f"%y = call double @llvm.{name}.f64(double %x)\nret double %y\n}}\n"
            f"declare double @llvm.{name}.f64(double)\n"
        )
        module.link_in(binding.parse_assembly(text))


def _arguments_of(context: Any, p: Any) -> list[Any]:
    """What a launch passes for a parameter."""
    if isinstance(p, LikeType):
        return []
    if isinstance(p, Constants):
        number = ir.DoubleType()
        fixed = [number] * p.varies.count(False)
        return [*fixed, number.as_pointer(), ir.IntType(64)]
    return [context.get_value_type(p)]


def _entry_text(name: str, parameters: Sequence[Any]) -> str:
    """A kernel that calls a lowered entry point once in every thread."""
    context = _Dispatcher.targetdescr.target_context
    module = context.codegen()._create_empty_module("entry")
    passed = [_arguments_of(context, p) for p in parameters]
    kind = ir.FunctionType(ir.VoidType(), list(itertools.chain.from_iterable(passed)))
    kernel = ir.Function(module, kind, name)
    kernel.calling_convention = "ptx_kernel"
    builder = ir.IRBuilder(kernel.append_basic_block())
    word = ir.IntType(32)
    block, size, thread = (
        builder.call(
            ir.Function(module, ir.FunctionType(word, []), f"llvm.nvvm.read.ptx.sreg.{place}.x"), []
        )
        for place in _PLACES
    )
    number = builder.zext(builder.add(builder.mul(block, size), thread), ir.IntType(64))
    given, arguments = list(kernel.args), []
    for p, taken in zip(parameters, passed, strict=True):
        mine, given = given[: len(taken)], given[len(taken) :]
        if isinstance(p, LikeType):
            arguments.append(context.get_dummy_value())
        elif isinstance(p, Constants):
            values = _constants(builder, p, mine, number)
            arguments.append(_tree(context, builder, p.like._numba_type_.tree, values))
        else:
            arguments += mine
    kinds = [p.like._numba_type_.tree if isinstance(p, Constants) else p for p in parameters]
    kinds.append(types.int64)
    inner = ir.Function(module, context.call_conv.get_function_type(types.none, kinds), _INNER)
    context.call_conv.call_function(builder, inner, types.none, kinds, [*arguments, number])
    builder.ret_void()
    return str(module)


def _constants(builder: Any, p: Constants, given: Sequence[Any], thread: Any) -> list[Any]:
    """All leaves of settings, in order: arguments, or read for the flight of a thread."""
    *fixed, pointer, count = given
    inside = builder.icmp_signed("<", thread, count)
    lane = builder.select(inside, thread, builder.sub(count, ir.Constant(ir.IntType(64), 1)))
    values, row = [], 0
    for varies in p.varies:
        if varies:
            place = builder.add(builder.mul(ir.Constant(ir.IntType(64), row), count), lane)
            values.append(builder.load(builder.gep(pointer, [place])))
            row += 1
        else:
            values.append(fixed.pop(0))
    return values


def _tree(context: Any, builder: Any, kind: Any, values: list[Any]) -> Any:
    """A tree of a type from its leaves, which are taken in order."""
    if not isinstance(kind, types.BaseTuple):
        return values.pop(0)
    tree = ir.Constant(context.get_value_type(kind), ir.Undefined)
    for k, branch in enumerate(branches(kind)):
        tree = builder.insert_value(tree, _tree(context, builder, branch, values), k)
    return tree


def _optimise(module: Any) -> None:
    """What LLVM does at its third level, for a GPU."""
    back_end = machine(ARCHITECTURE)
    options = binding.create_pipeline_tuning_options(speed_level=3)
    options.loop_vectorization = options.slp_vectorization = False
    builder = binding.create_pass_builder(back_end, options)
    builder.getModulePassManager().run(module, builder)
