"""Numba target for NVIDIA GPUs, and LLVM's back end for them.

Whatever numba can lower for the processor it lowers for this target with the same flags on every
operation; LLVM, which comes with llvmlite, writes PTX.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any, Literal

from llvmlite import binding, ir
from numba.core import (
    codegen,
    cpu,
    datamodel,
    descriptors,
    dispatcher,
    fastmathpass,
    registry,
    runtime,
    target_extension,
    types,
    typing,
)
from numba.core.compiler_lock import global_compiler_lock
from numba.core.datamodel import models

from springback.kernels.compiler import INLINED_ON_GPUS, STRICT, with_globals
from springback.kernels.gpu.private_memory import MEMORY

#: Parts of numba with incomplete type stubs, or none.
_AOTLibrary: Any = codegen.AOTCodeLibrary
_AOTCodegen: Any = codegen.AOTCPUCodegen
_CPUContext: Any = cpu.CPUContext
_CPU: Any = target_extension.CPU
_Descriptor: Any = descriptors.TargetDescriptor
_AnyDispatcher: Any = dispatcher.Dispatcher
_typing: Any = typing
_models: Any = models
_datamodel: Any = datamodel
_runtime: Any = runtime
_fastmath: Any = fastmathpass
_override: Any = target_extension.target_override

Precision = Literal["double", "single"]
"""Of all floats of a kernel."""
_TRIPLE = "nvptx64-nvidia-cuda"
#: Architectures are upward compatible: PTX for this one runs on all later ones.
ARCHITECTURE = "sm_70"
_NAMES: dict[Precision, str] = {"double": "ptx", "single": "ptx-single"}


class _Ptx(_CPU):  # type: ignore[misc]
    """Target that lowers whatever numba can lower for a processor."""


class _SinglePtx(_Ptx):
    """The same with all floats in single precision."""


class _Library(_AOTLibrary):  # type: ignore[misc]
    """Lowered functions for LLVM's back end."""

    def _optimize_functions(self, ll_module: Any) -> None:
        ll_module.data_layout = self._codegen._data_layout

    def _optimize_final_module(self) -> None:
        """Inline what is to be inlined; the other passes run once, on the complete module."""
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
    allow_dynamic_globals = True  # addresses of functions, which are never read

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
        """Set the arithmetic flags, without reference counting."""
        if self.fastmath:
            _fastmath.rewrite_module(module, self.fastmath)

    def get_executable(self, library: Any, fndesc: Any, env: Any) -> Any:
        return object()  # a placeholder for lowered code, which this process cannot call


class _SingleFloat(_models.PrimitiveModel):  # type: ignore[misc]
    """What numba types as float64, in single precision."""

    def __init__(self, manager: Any, float_type: Any) -> None:
        super().__init__(manager, float_type, ir.FloatType())


class _SingleContext(_Context):
    def init(self) -> None:
        super().init()
        manager = _datamodel.default_manager.copy()
        manager.register(types.Float, _SingleFloat)
        self.data_model_manager = manager


class _Target(_Descriptor):  # type: ignore[misc]
    options = cpu.CPUTargetOptions

    def __init__(self, precision: Precision) -> None:
        super().__init__(_NAMES[precision])
        self._context = _SingleContext if precision == "single" else _Context

    @functools.cached_property
    def _contexts(self) -> tuple[Any, Any]:
        known = _typing.Context()
        return known, self._context(known, self._target_name)

    @property
    def typing_context(self) -> Any:
        return self._contexts[0]

    @property
    def target_context(self) -> Any:
        return self._contexts[1]


class _Dispatcher(_AnyDispatcher):  # type: ignore[misc]
    targetdescr = _Target("double")

    def add_overload(self, cres: Any) -> None:
        self.overloads[tuple(cres.signature.args)] = cres


class _SingleDispatcher(_Dispatcher):
    targetdescr = _Target("single")


_DISPATCHERS: dict[Precision, Any] = {"double": _Dispatcher, "single": _SingleDispatcher}


def _device_decorator(dispatcher: Any, function: Any = None, **options: Any) -> Any:
    """Substitute for `numba.njit` while code for a GPU is compiled."""
    if function is None:
        return functools.partial(_device_decorator, dispatcher, **options)
    for name in ("pipeline_class", "nopython", "cache", "nogil"):
        options.pop(name, None)
    options |= {"_nrt": False, "no_cpython_wrapper": True, "no_cfunc_wrapper": True}
    if function in INLINED_ON_GPUS:
        options["forceinline"] = True
    return dispatcher(function, targetoptions={"nopython": True, **options})


def _register(precision: Precision, kind: type) -> None:
    """Tell numba of a target."""
    dispatcher = _DISPATCHERS[precision]
    target_extension.target_registry[_NAMES[precision]] = kind
    target_extension.dispatcher_registry[kind] = dispatcher
    target_extension.jit_registry[kind] = functools.partial(_device_decorator, dispatcher)


_register("double", _Ptx)
_register("single", _SinglePtx)


def machine(architecture: str) -> Any:
    """LLVM's back end for NVIDIA GPUs."""
    binding.initialize_all_targets()
    binding.initialize_all_asmprinters()
    target = binding.Target.from_triple(_TRIPLE)
    return target.create_target_machine(cpu=architecture, features="+ptx81", opt=3)


def device_function(
    function: Callable[..., Any], precision: Precision = "double", **others: Any
) -> Any:
    """A function that entry points call on a GPU; ``others`` replace globals of these names."""
    plain = getattr(function, "py_func", function)
    decorated = with_globals(plain, **MEMORY, **others)
    return _device_decorator(_DISPATCHERS[precision], decorated, forceinline=True, **STRICT)


def target_context(precision: Precision) -> Any:
    """Numba's context for lowering to this target."""
    return _DISPATCHERS[precision].targetdescr.target_context


def lower(function: Any, precision: Precision, arguments: tuple[Any, ...]) -> Any:
    """A device function, typed and lowered for the given argument types."""
    with _override(_NAMES[precision]):
        result = function._compiler.compile(arguments, None)
    result.library._ensure_finalized()
    return result
