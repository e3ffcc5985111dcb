"""The compiler's passes for kernels: what only ever is inlined needs less than what is called.

A kernel is inlined wherever it is used, so it needs no machine code of its own; and it holds
neither array expressions nor, mostly, closures, so it needs no passes over them.  The code of an
entry point, and each of its bits, is the same without.
"""

from __future__ import annotations

import importlib
import types
from typing import Any

from llvmlite.binding import Linkage
from numba.core import codegen, compiler, compiler_machinery, lowering, typed_passes, untyped_passes

#: Parts of numba with incomplete type stubs, or none.
_register_pass: Any = compiler_machinery.register_pass
_make_function: Any = importlib.import_module("numba._dynfunc").make_function
_LowerResult: Any = compiler._LowerResult
_Compiler: Any = compiler.Compiler
_Library: Any = codegen.JITCodeLibrary
_Lower: Any = lowering.Lower
_NativeLowering: Any = typed_passes.NativeLowering

#: Attributes of every function, as LLVM writes them.  By default LLVM uses only half of a 512-bit
#: register on Intel processors, the earliest of which slowed down with more; and it does not align
#: the stack, so that a spilled register usually straddles two cache lines.
_FOR_LANES = ('"prefer-vector-width"="512"', '"stackrealign"')
#: Passes that change nothing in a kernel: they rewrite expressions of whole arrays, and literals
#: that it asks for by name.
_IDLE = {typed_passes.NopythonRewrites, untyped_passes.WithLifting}


class _LowerForLanes(_Lower):  # type: ignore[misc]
    def setup_function(self, fndesc: Any) -> None:
        super().setup_function(fndesc)
        set.update(self.function.attributes, _FOR_LANES)  # llvmlite's own `add` refuses these


class _InlinedLibrary(_Library):  # type: ignore[misc]
    """Optimised code of a kernel, to link into its callers; no machine code is made of it."""

    def finalize(self) -> None:
        """Link what the kernel calls, optimise it, and let any number of callers link it."""
        for library in dict.fromkeys(self._linking_libraries):
            self._reload_init.update(library._reload_init)
            self._final_module.link_in(library._get_module_for_linking(), preserve=True)
        self._optimize_final_module()
        self._finalize_dynamic_globals()
        for function in self._final_module.functions:
            if not function.is_declaration and function.linkage == Linkage.external:
                function.linkage = "linkonce_odr"
        self._shared_module, self._finalized = self._final_module, True


@_register_pass(mutates_CFG=True, analysis_only=False)
class _LoweringForLanes(_NativeLowering):  # type: ignore[misc]
    _name = "lowering_for_lanes"

    @property
    def lowering_class(self) -> Any:
        return _LowerForLanes

    def run_pass(self, state: Any) -> bool:
        if not state.flags.forceinline:
            return bool(super().run_pass(state))
        library = _InlinedLibrary(state.targetctx.codegen(), state.func_id.func_qualname)
        state.library, state.flags.no_compile = library, True
        super().run_pass(state)
        made = state["cr"]
        described, context = made.fndesc, state.targetctx
        name, module = described.qualname.split(".")[-1], described.lookup_module()
        entry = _make_function(module, name, "", 0, made.env, (library,))  # without an address
        context.insert_user_function(entry, described, [library])
        state["cr"] = _LowerResult(described, made.call_helper, cfunc=entry, env=made.env)
        return True


def _is_idle(step: Any, state: Any) -> bool:
    """True if a pass leaves a kernel unchanged."""
    if step is untyped_passes.InlineClosureLikes:
        constants = state.func_id.func.__code__.co_consts
        return not any(isinstance(constant, types.CodeType) for constant in constants)
    return step in _IDLE


class LaneCompiler(_Compiler):  # type: ignore[misc]
    """The compiler of kernels and of entry points."""

    def define_pipelines(self) -> list[Any]:
        """Its passes."""
        inlined = self.state.flags.forceinline
        pipelines: list[Any] = super().define_pipelines()
        for pipeline in pipelines:
            pipeline.passes = [
                (_LoweringForLanes if step is _NativeLowering else step, title)
                for step, title in pipeline.passes
                if not (inlined and _is_idle(step, self.state))
            ]
            pipeline.finalize()
        return pipelines
