"""The compiler's passes for kernels: what only ever is inlined needs less than what is called.

A kernel is inlined wherever it is used, so it needs no machine code of its own, and no calling
convention that others know: trees pass from kernel to kernel in one piece, and no status with them
unless there is an error to report.  It holds neither array expressions nor, mostly, closures, so it
needs no passes over them.  The results of an entry point are, bit by bit, the same without.
"""

from __future__ import annotations

import contextlib
import copy
import importlib
from types import CodeType, FunctionType, SimpleNamespace
from typing import Any

from llvmlite import ir as llvm
from llvmlite.binding import Linkage, create_new_module_pass_manager
from numba.core import (
    analysis,
    base,
    callconv,
    cgutils,
    codegen,
    compiler,
    compiler_machinery,
    config,
    cpu,
    dispatcher,
    errors,
    event,
    ir,
    lowering,
    postproc,
    target_extension,
    targetconfig,
    transforms,
    typed_passes,
    types,
    untyped_passes,
    utils,
)
from numba.core import typing as typing_rules
from numba.core.imputils import user_function
from numba.core.typing import npydecl

#: Parts of numba with incomplete type stubs, or none.
_register_pass: Any = compiler_machinery.register_pass
_make_function: Any = importlib.import_module("numba._dynfunc").make_function
_LowerResult: Any = compiler._LowerResult
_Compiler: Any = compiler.Compiler
_Library: Any = codegen.JITCodeLibrary
_Lower: Any = lowering.Lower
_get_or_insert: Any = cgutils.get_or_insert_function
_alloca_once: Any = cgutils.alloca_once
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


#: In which process a type's hash was computed: one that is read from a file has another's.
_HERE = object()


def _hash_once(kind: Any) -> int:
    """Hash of a type of tuples, which numba computes again, branch by branch, at every look-up."""
    known: tuple[object, int] | None = kind.__dict__.get("_hashed")
    if known is None or known[0] is not _HERE:
        known = kind._hashed = (_HERE, hash(kind.key))
    return known[1]


def _is_same(kind: Any, other: Any) -> bool:
    """Equality of types of tuples, of which there mostly is one object each."""
    return kind is other or (kind.__class__ is other.__class__ and kind.key == other.key)


_TUPLES: Any = (types.Tuple, types.UniTuple, types.NamedTuple, types.NamedUniTuple)
for _kind in _TUPLES:
    _kind.__hash__, _kind.__eq__ = _hash_once, _is_same  # a tenth of the time to compile


def _untimed(kind: str, callback: Any) -> Any:
    """No timer for a kernel that is compiled, which would be told of every call of LLVM."""
    return contextlib.nullcontext()


def _heard(told: Any) -> Any:
    """An event of the compiler that is made if somebody listens."""

    def tell(kind: str, *given: Any, **named: Any) -> None:
        if _LISTENERS.get(kind):
            told(kind, *given, **named)

    return tell


def _same_flags(flags: Any, other: Any) -> Any:
    """Equality of the compiler's flags; mostly the same are set to the same."""
    if flags is other:
        return True
    if type(flags) is type(other) and flags._values == other._values:
        return True
    return _compare_flags(flags, other)


def _hash_of_flags(flags: Any) -> int:
    """Hash of the compiler's flags: as numba's own, the same for all of a class."""
    return hash(type(flags))


def _array_operator(rule: Any, arguments: Any, named: Any) -> Any:
    """Type of an operation on arrays; numba looks through NumPy's first if there is one."""
    if any(isinstance(kind, _ARRAYS) for kind in arguments):
        return _type_of_operation(rule, arguments, named)
    return None


def _asks_for_place(function: Any) -> bool:
    """True if a function has an argument ``loc``; numba makes its whole signature to look."""
    if type(function) is not FunctionType or hasattr(function, "__wrapped__"):
        asks: bool = _asks(function)
        return asks
    code = function.__code__
    return "loc" in code.co_varnames[: code.co_argcount + code.co_kwonlyargcount]


def _variables(statement: Any, value: Any) -> list[Any]:
    """Variables within a part of a statement, as numba's own, with fewer calls."""
    kind = type(value)
    if kind is not dict:
        found: list[Any] = _list_variables(statement, value)
        return found
    listed = []
    for part in value.values():
        if type(part) is ir.Var:
            listed.append(part)
        elif type(part) not in _PLAIN:
            listed.extend(_list_variables(statement, part))
    return listed


def _call_type(function: Any, context: Any, arguments: Any, named: Any) -> Any:
    """Signature of a call; numba tries each template twice, and describes why it does not match."""
    plain = tuple(map(types.unliteral, arguments))
    if named or any(isinstance(kind, types.Poison) for kind in plain):
        return _type_of_call(function, context, arguments, named)
    literal = any(a is not b for a, b in zip(plain, arguments, strict=True))
    target = _local_target(context)
    for template in _by_target(target, function.templates, function.key[0]):
        tried = template(context)
        choices = (plain, arguments) if literal else (arguments,)
        for given in reversed(choices) if tried.prefer_literal else choices:
            with contextlib.suppress(errors.NumbaError):
                signature = tried.apply(given, named)
                if signature is not None:
                    function._impl_keys[signature.args] = tried.get_impl_key(signature)
                    return signature
    return _type_of_call(function, context, arguments, named)  # which says why none matches


def _by_target(target: Any, templates: Any, fnkey: str = "") -> Any:
    """Templates that a target can use, the most specific first."""
    key = (target, *templates)
    if key not in _ORDERS:
        _ORDERS[key] = _order_by_target(target, templates, fnkey)
    return _ORDERS[key]


def _options(flags: Any) -> dict[str, Any]:
    """Values of all the compiler's flags."""
    kind = type(flags)
    if kind not in _DEFAULTS:
        _DEFAULTS[kind] = {name: option.default for name, option in kind.options.items()}
    return {**_DEFAULTS[kind], **flags._values}


def _run_pass(manager: Any, index: int, step: Any, state: Any) -> None:
    """A pass; numba first writes the types of all arguments out, for who may listen."""
    if _LISTENERS.get("numba:run_pass") or _PRINTED:
        _run_pass_heard(manager, index, step, state)
        return
    step.analysis = manager._analysis
    with _errors.new_error_context("Pass {name}", name=step.name()):
        mutated = step.run_initialization(state)
        mutated |= step.run_pass(state)
        mutated |= step.run_finalizer(state)
    if mutated and _registry_of_passes.get(type(step)).mutates_CFG:
        _postproc.PostProcessor(state.func_ir).run()


def _post_process(processor: Any, emit_dels: bool = False, extend_lifetimes: bool = False) -> None:
    """Put blocks in order; which variables live on between them is known when that is asked for."""
    code = processor.func_ir
    if code.is_generator:
        _post_process_all(processor, emit_dels, extend_lifetimes)
        return
    code.blocks = _canonical(code.blocks)
    code.variable_lifetime = _postproc.VariableLifetime(code.blocks)
    code.block_entry_vars, code.generator_info = {}, None
    if emit_dels:
        processor._insert_var_dels(extend_lifetimes=extend_lifetimes)


def _entry_variables(code: Any, block: Any) -> Any:
    """Variables that may live at the beginning of a block."""
    if block not in code.block_entry_vars:
        lives = code.variable_lifetime
        found = _live_variables(
            lives.cfg, code.blocks, lives.usedefs.defmap, lives.deadmaps.combined
        )
        code.block_entry_vars.update((one, found[at]) for at, one in code.blocks.items())
    return code.block_entry_vars[block]


def _load_registries(context: Any) -> None:
    """What other modules teach the compiler; numba imports them all again each time."""
    if not _REGISTRIES:
        _load_all_registries(context)
        _REGISTRIES.extend(context._registries)
        return
    _start_runtime(context)
    for registry in _REGISTRIES:
        context.install_registry(registry)


#: What numba does for each kernel that it compiles, a thousand times for a flight, is done with
#: fewer steps here: a fifth of the time to compile.  Results are the same.
_LISTENERS: Any = event._registered
_ARRAYS: Any = (types.ArrayCompatible, types.Optional)
_PLAIN = {str, int, ir.Loc, type(None), bool}
_compare_flags: Any = compiler.Flags.__eq__
_type_of_operation: Any = npydecl.NumpyRulesArrayOperator.generic
_list_variables: Any = ir.Inst._rec_list_vars
_asks: Any = base._has_loc
_patched: Any = compiler.Flags
_patched.__eq__, _patched.__hash__ = _same_flags, _hash_of_flags
_patched = npydecl.NumpyRulesArrayOperator
_patched.generic = _array_operator
_patched = ir.Inst
_patched._rec_list_vars = _variables
_patched = base
_patched._has_loc = _asks_for_place
_patched = event
_patched.start_event, _patched.end_event = _heard(event.start_event), _heard(event.end_event)
_type_of_call: Any = types.BaseFunction.get_call_type
_local_target: Any = target_extension.get_local_target
_order_by_target: Any = utils.order_by_target_specificity
_run_pass_heard: Any = compiler_machinery.PassManager._runPass
_post_process_all: Any = postproc.PostProcessor.run
_load_all_registries: Any = cpu.CPUContext.load_additional_registries
_start_runtime: Any = importlib.import_module("numba.core.runtime").rtsys.initialize
_ORDERS: dict[Any, Any] = {}
_DEFAULTS: dict[type, dict[str, Any]] = {}
_REGISTRIES: list[Any] = []
_live_variables: Any = analysis.compute_live_variables
_canonical: Any = transforms.canonicalize_cfg
_postproc: Any = postproc
_registry_of_passes: Any = compiler_machinery._pass_registry
#: Passes before or after which the code is printed, as whoever debugs the compiler asks.
_WHEN = ("BEFORE", "AFTER", "WRAP")
_PRINTED = {getattr(config, f"DEBUG_PRINT_{when}") for when in _WHEN} - {"none"}
_errors: Any = errors
_patched = types.BaseFunction
_patched.get_call_type = _call_type
for _patched in (utils, typing_rules.context):
    _patched.order_by_target_specificity = _by_target
_patched = targetconfig.TargetConfig
_patched.values = _options
_patched = compiler_machinery.PassManager
_patched._runPass = _run_pass
_patched = postproc.PostProcessor
_patched.run = _post_process
_patched = ir.FunctionIR
_patched.get_block_entry_vars = _entry_variables
_patched = cpu.CPUContext
_patched.load_additional_registries = _load_registries
_patched = dispatcher
_patched.ev = SimpleNamespace(install_timer=_untimed, trigger_event=event.trigger_event)


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
        place = _alloca_once(builder, context.get_value_type(described.restype))
        builder.call(function, [place, *_passed(described, given)])
        return builder.load(place)

    rule: Any = call
    rule.signature, rule.libs = described.argtypes, libraries
    return rule


class _LowerForLanes(_Lower):  # type: ignore[misc]
    def setup_function(self, fndesc: Any) -> None:
        super().setup_function(fndesc)
        set.update(self.function.attributes, _FOR_LANES)


class _LowerInlined(_LowerForLanes):
    """Lowering of kernels that are inlined and raise no error."""

    def setup_function(self, fndesc: Any) -> None:
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


class _InlinedLibrary(_Library):  # type: ignore[misc]
    """Optimised code of a kernel, to link into its callers; no machine code is made of it."""

    def add_llvm_module(self, ll_module: Any) -> None:
        """Take the kernel's own code, which `finalize` simplifies."""
        ll_module.data_layout = self._codegen._data_layout
        self._final_module.link_in(ll_module)

    def finalize(self) -> None:
        """Inline what the kernel calls, simplify it, and let any number of callers link it.

        Entry points are optimised as a whole: of a kernel, only what its callers would repeat.
        """
        for library in dict.fromkeys(self._linking_libraries):
            self._reload_init.update(library._reload_init)
            self._final_module.link_in(library._get_module_for_linking(), preserve=True)
        passes = create_new_module_pass_manager()
        passes.add_always_inliner_pass()
        passes.add_sroa_pass()
        passes.add_instruction_combine_pass()
        passes.add_simplify_cfg_pass()
        passes.add_global_dead_code_eliminate_pass()
        passes.run(self._final_module, self._codegen._pass_builder())
        self._finalize_dynamic_globals()
        for function in self._final_module.functions:
            if not function.is_declaration and function.linkage == Linkage.external:
                function.linkage = "linkonce_odr"
        self._shared_module, self._finalized = self._final_module, True


@_register_pass(mutates_CFG=True, analysis_only=False)
class _LoweringForLanes(_NativeLowering):  # type: ignore[misc]
    _name = "lowering_for_lanes"
    _lowering: type[_LowerForLanes] = _LowerForLanes

    @property
    def lowering_class(self) -> Any:
        return self._lowering

    def run_pass(self, state: Any) -> bool:
        self._lowering = _LowerForLanes  # one instance serves all compilations
        if state.flags.nrt:  # an entry point, or a kernel for rare events
            return bool(super().run_pass(state))
        context, state.flags.no_compile = state.targetctx, True
        try:
            if isinstance(state.return_type, types.Optional):
                raise _MayRaise  # its status tells a value from none
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
        state.library = _InlinedLibrary(context.codegen(), state.func_id.func_qualname)
        if lowering is _LowerInlined:
            state.targetctx = copy.copy(context)
            state.targetctx.__class__ = _KernelContext
        try:
            super().run_pass(state)
        finally:
            state.targetctx = context
        return state.library


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
