"""The compiler's passes for kernels: what only ever is inlined needs less than what is called.

A kernel is inlined wherever it is used, so it needs no machine code of its own, and no calling
convention that others know: trees pass from kernel to kernel in one piece, and no status with them
unless there is an error to report.  It holds neither array expressions nor, mostly, closures, so it
needs no passes over them.  The results of an entry point are, bit by bit, the same without.
"""

from __future__ import annotations

import copy
import importlib
from types import CodeType, FunctionType
from typing import Any

from llvmlite import ir as llvm
from llvmlite.binding import Linkage, create_new_module_pass_manager, set_option
from numba.core import (
    callconv,
    cgutils,
    codegen,
    compiler,
    compiler_machinery,
    cpu,
    ir,
    lowering,
    typed_passes,
    types,
    untyped_passes,
)
from numba.core.imputils import user_function

from springback.kernels.passes import shortcuts
from springback.kernels.passes.stack import bare_slots, slot

#: Parts of numba with incomplete type stubs, or none.
_register_pass: Any = compiler_machinery.register_pass
_make_function: Any = importlib.import_module("numba._dynfunc").make_function
_LowerResult: Any = compiler._LowerResult
_Compiler: Any = compiler.Compiler
_Library: Any = codegen.JITCodeLibrary
_Lower: Any = lowering.Lower
_get_or_insert: Any = cgutils.get_or_insert_function
_Convention: Any = callconv.CPUCallConv
_Context: Any = cpu.CPUContext
_NativeLowering: Any = typed_passes.NativeLowering

#: Attributes of every function, as LLVM writes them.  By default LLVM uses only half of a 512-bit
#: register on Intel processors, the earliest of which slowed down with more; and it does not align
#: the stack, so that a spilled register usually straddles two cache lines.
_FOR_LANES = ('"prefer-vector-width"="512"', '"stackrealign"')
#: Passes that change nothing in a kernel: they rewrite expressions of whole arrays, literals that
#: it asks for by name, and functions that are inlined as source.
_IDLE = {
    typed_passes.NopythonRewrites, typed_passes.InlineOverloads, untyped_passes.WithLifting,
    untyped_passes.LiteralUnroll, untyped_passes.InlineInlinables,
}  # fmt: skip

#: A kernel is not simplified by itself if it has so many bytes, nearly all of them of what it
#: calls: so many times as many as of its own.
_THICK, _THIN = 100_000, 12

#: The compiler's options to put instructions in order once more, registers allotted, and to move
#: loads past stores to other places when it does so before.
_IN_ORDER, _PAST_STORES = "-post-RA-scheduler", "-enable-aa-sched-mi"

#: Kernels that hold lists, whose references are counted.
LISTED: set[FunctionType] = set()

shortcuts.take()


class _MayRaise(BaseException):
    """Raised as a kernel is lowered that can raise; the compiler would wrap an `Exception`."""


class _WithoutErrors(_Convention):  # type: ignore[misc]
    """The compiler's own convention in code that cannot pass an error on."""

    def _give_up(self, *arguments: Any, **named: Any) -> None:
        raise _MayRaise

    return_status_propagate = return_native_none = return_optional_value = _give_up
    return_user_exc = set_static_user_exc = return_dynamic_user_exc = return_exc = _give_up
    return_stop_iteration = _give_up


class _KernelContext(_Context):  # type: ignore[misc]
    """The target as seen from within an inlined kernel."""

    @property
    def call_conv(self) -> Any:
        return _WithoutErrors(self)


def _declared(context: Any, module: Any, described: Any) -> Any:
    """An inlined kernel in a module that defines or calls it: a place for the result, and values.

    The compiler's own convention takes trees apart at every call, leaf by leaf, puts them together
    at every return and looks at a status: seven in ten of all instructions that it made of kernels.
    A result is not returned as a value: one of two trees would be chosen whole, and lanes not
    vectorised.
    """
    kinds = [context.get_value_type(kind) for kind in _passed(described, described.argtypes)]
    result = context.get_value_type(described.restype)
    whole = llvm.FunctionType(llvm.VoidType(), [result.as_pointer(), *kinds])
    function = _get_or_insert(module, whole, described.mangled_name)
    function.attributes.add("alwaysinline" if described.inline else "noinline")
    set.update(function.attributes, _FOR_LANES)  # llvmlite's own `add` refuses these
    return function


def _passed(described: Any, given: Any) -> list[Any]:
    """Those of a kernel's arguments that are not left out, or what belongs to them."""
    pairs = zip(described.argtypes, given, strict=True)
    return [value for kind, value in pairs if not isinstance(kind, types.Omitted)]


def _caller(described: Any, libraries: Any) -> Any:
    """Rule by which calls of an inlined kernel are compiled."""

    def call(context: Any, builder: Any, signature: Any, given: Any) -> Any:
        function = _declared(context, builder.module, described)
        place = slot(builder, context.get_value_type(described.restype))
        builder.call(function, [place, *_passed(described, given)])
        return builder.load(place)

    rule: Any = call
    rule.signature, rule.libs = described.argtypes, libraries
    return rule


class _LowerForLanes(_Lower):  # type: ignore[misc]
    def setup_function(self, fndesc: Any) -> None:
        self.library.function = fndesc.mangled_name
        super().setup_function(fndesc)
        set.update(self.function.attributes, _FOR_LANES)
        if getattr(self.library, "is_called", False):
            self.function.attributes.add("noinline")

    def storevar(self, value: Any, name: str, argidx: int | None = None) -> None:
        """Set a variable; one without references is not read first, to drop them."""
        kind = self.typeof(name)
        if name in self._singly_assigned_vars or self._is_counted(kind):
            super().storevar(value, name, argidx)
            return
        self._alloca_var(name, kind)
        self.builder.store(value, self.getvar(name))

    def delvar(self, name: str) -> None:
        """End the life of a variable; one without references is not read and cleared."""
        if self._is_counted(self.typeof(name)):
            super().delvar(name)
        elif name not in self._blk_local_varmap:
            self._singly_assigned_vars.discard(name)

    def _is_counted(self, kind: Any) -> bool:
        """True if values of a type hold references that are counted."""
        model = self.context.data_model_manager[kind]
        return bool(self.context.enable_nrt and model.contains_nrt_meminfo())


class _LowerInlined(_LowerForLanes):
    """Lowering of kernels that are inlined and raise no error."""

    def setup_function(self, fndesc: Any) -> None:
        self.library.function = fndesc.mangled_name
        self.function = _declared(self.context, self.module, fndesc)
        self.entry_block = self.function.append_basic_block("entry")
        self.builder = llvm.IRBuilder(self.entry_block)
        self.call_helper = None
        self.function.args[0].add_attribute("noalias")

    def extract_function_arguments(self) -> Any:
        passed = iter(self.function.args[1:])
        self.fnargs = [
            None if isinstance(kind, types.Omitted) else next(passed)
            for kind in self.fndesc.argtypes
        ]
        return self.fnargs

    def lower_inst(self, inst: Any) -> None:
        if not isinstance(inst, ir.Return):
            super().lower_inst(inst)
            return
        self.builder.store(self.loadvar(inst.value.name), self.function.args[0])
        self.builder.ret_void()


class _KernelLibrary(_Library):  # type: ignore[misc]
    """Optimised code of a kernel, to link into its callers; no machine code is made of it."""

    def __init__(self, codegen: Any, name: str, is_called: bool) -> None:
        super().__init__(codegen, name)
        #: True if the kernel stays a function in the entry point that calls it.
        self.is_called, self.function = is_called, ""
        #: Libraries of the called kernels beneath this one, each after one that calls it.
        self.called: dict[_KernelLibrary, None] = {}
        #: Bytes of its code.
        self.size = 0

    def add_llvm_module(self, ll_module: Any) -> None:
        """Take the kernel's own code, which `finalize` simplifies."""
        ll_module.data_layout = self._codegen._data_layout
        self._final_module.link_in(ll_module)

    def finalize(self) -> None:
        """Inline what the kernel calls, simplify it, and let any number of callers link it.

        Entry points are optimised as a whole: of a kernel, only what its callers would repeat.
        One that does little beside calling a long kernel is left to its caller.
        """
        own, linked = len(self._final_module.as_bitcode()), 0
        for library in dict.fromkeys(self._linking_libraries):
            self._reload_init.update(library._reload_init)
            self.called.update(_called(library))
            if library not in self.called:
                self._final_module.link_in(library._get_module_for_linking(), preserve=True)
                linked += getattr(library, "size", 0)
        self.size = own + linked
        if self.size < _THICK or own * _THIN > linked:
            self._simplify()
        self._finalize_dynamic_globals()
        for function in self._final_module.functions:
            if not function.is_declaration and function.linkage == Linkage.external:
                function.linkage = "linkonce_odr"
        self._shared_module, self._finalized = self._final_module, True

    def _simplify(self) -> None:
        passes = create_new_module_pass_manager()
        passes.add_always_inliner_pass()
        passes.add_sroa_pass()
        passes.add_instruction_combine_pass()
        passes.add_simplify_cfg_pass()
        passes.add_global_dead_code_eliminate_pass()
        passes.run(self._final_module, self._codegen._pass_builder())
        self.size = len(self._final_module.as_bitcode())


def _called(library: Any) -> dict[_KernelLibrary, None]:
    """Libraries of called kernels that an entry point needs for what is in a library."""
    if not isinstance(library, _KernelLibrary):
        return {}
    return {library: None, **library.called} if library.is_called else library.called


class _EntryLibrary(_Library):  # type: ignore[misc]
    """Machine code of an entry point, and of all that it calls.

    Called kernels are linked here, once each, and are its own: the compiler then knows all their
    callers, such as the number of lanes with which they are called.
    """

    #: True if many flights in lanes are flown, whose speed is worth more than quick compiling.
    in_lanes = True

    def finalize(self) -> None:
        """Link what is called, optimise the whole, and make machine code of it."""
        for library in list(self._linking_libraries):
            self._linking_libraries.extend(_called(library))
        super().finalize()

    def _optimize_final_module(self) -> None:
        libraries = self._linking_libraries
        kernels = {one.function for one in libraries if isinstance(one, _KernelLibrary)}
        for function in self._final_module.functions:
            if function.name in kernels and not function.is_declaration:
                function.linkage = "internal"
        super()._optimize_final_module()

    def _finalize_specific(self) -> None:
        """Make machine code, its instructions put in order with more effort for lanes only.

        Lanes are 5 to 7 % slower without each of both, single flights no slower, and they wait.
        """
        _set_ordering(once_more=self.in_lanes, past_stores=self.in_lanes)
        try:
            super()._finalize_specific()
        finally:
            _set_ordering(once_more=True, past_stores=False)


def _set_ordering(*, once_more: bool, past_stores: bool) -> None:
    for option, wanted in ((_IN_ORDER, once_more), (_PAST_STORES, past_stores)):
        set_option("springback", f"{option}={str(wanted).lower()}")


@_register_pass(mutates_CFG=True, analysis_only=False)
class _LoweringForLanes(_NativeLowering):  # type: ignore[misc]
    _name = "lowering_for_lanes"
    _lowering: type[_LowerForLanes] = _LowerForLanes

    @property
    def lowering_class(self) -> Any:
        return self._lowering

    def run_pass(self, state: Any) -> bool:
        with bare_slots():
            return self._run_pass(state)

    def _run_pass(self, state: Any) -> bool:
        self._lowering = _LowerForLanes  # one instance serves all compilations
        is_listed = state.func_id.func in LISTED
        if state.flags.nrt and not is_listed:  # an entry point
            state.library = _EntryLibrary(state.targetctx.codegen(), state.func_id.func_qualname)
            state.library.in_lanes = any(_is_lanes(kind) for kind in state.args)
            state.library.enable_object_caching()
            return bool(super().run_pass(state))
        context, state.flags.no_compile = state.targetctx, True
        try:
            if is_listed or isinstance(state.return_type, types.Optional):
                raise _MayRaise  # the status tells a value from none, and of an index out of range
            library = self._lower(state, _LowerInlined)
            calls = _caller
        except _MayRaise:
            library = self._lower(state, _LowerForLanes)
            calls = user_function
        made = state["cr"]
        described = made.fndesc
        name, module = described.qualname.split(".")[-1], described.lookup_module()
        entry = _make_function(module, name, "", 0, made.env, (library,))  # without an address
        context._defns[entry].append(calls(described, (library,)), described.argtypes)
        state["cr"] = _LowerResult(described, made.call_helper, cfunc=entry, env=made.env)
        return True

    def _lower(self, state: Any, lowering: Any) -> Any:
        """Lower a kernel by a class; returns its library.

        Raises:
            _MayRaise: If that class cannot: the kernel can raise an error.
        """
        context = state.targetctx
        self._lowering = lowering
        name, is_called = state.func_id.func_qualname, not state.flags.forceinline
        state.library = _KernelLibrary(context.codegen(), name, is_called)
        if lowering is _LowerInlined:
            state.targetctx = copy.copy(context)
            state.targetctx.__class__ = _KernelContext
        try:
            super().run_pass(state)
        finally:
            state.targetctx = context
        return state.library


def _is_lanes(kind: Any) -> bool:
    """True of the type of `springback.simulation.lanes.lanes_of` several flights."""
    is_tuple = isinstance(kind, types.UniTuple) and isinstance(kind.dtype, types.Integer)
    return is_tuple and kind.count > 1


def _is_idle(step: Any, state: Any) -> bool:
    """True if a pass leaves a kernel unchanged."""
    if step is untyped_passes.InlineClosureLikes:
        return not _has_closures(state)
    return step in _IDLE


def _has_closures(state: Any) -> bool:
    constants = state.func_id.func.__code__.co_consts
    return any(isinstance(constant, CodeType) for constant in constants)


class LaneCompiler(_Compiler):  # type: ignore[misc]
    """The compiler of kernels and of entry points."""

    def define_pipelines(self) -> list[Any]:
        """Its passes, which hold nothing of what they compile: they are made once of a kind."""
        flags = self.state.flags
        kind = (
            flags.forceinline and not _has_closures(self.state), flags.forceinline,
            flags.no_rewrites, flags.force_pyobject, flags.auto_parallel.enabled,
        )  # fmt: skip
        if kind not in _PIPELINES:
            pipelines: list[Any] = super().define_pipelines()
            for pipeline in pipelines:
                pipeline.passes = [
                    (_LoweringForLanes if step is _NativeLowering else step, title)
                    for step, title in pipeline.passes
                    if not (flags.forceinline and _is_idle(step, self.state))
                ]
                pipeline.finalize()
            _PIPELINES[kind] = pipelines
        return _PIPELINES[kind]


_PIPELINES: dict[tuple[Any, ...], list[Any]] = {}
