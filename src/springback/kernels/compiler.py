"""The compiler, named here and nowhere else.

Physics is written once, for one vehicle, on floats and NamedTuples of floats.  A function marked
`kernel` stays an ordinary Python function when Python calls it, and is compiled and inlined when an
`executor` calls it.  So one source serves plain Python, one compiled flight and many flights
abreast.

The arithmetic flags let the compiler drop terms that are exactly zero (``nnan``, ``ninf``, ``nsz``)
and nothing else: no contraction, no reassociation, no approximate division.  Every operation is
then rounded as IEEE 754 says, and all executors return the same bits (docs/decisions/0003).
"""

from __future__ import annotations

import functools
import hashlib
import os
import types
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple, ParamSpec, Protocol, TypeVar, cast

import numba
import numba.extending
import platformdirs
from numba import njit
from numba.core import compiler, compiler_machinery, lowering, typed_passes
from numba.core.errors import NumbaError
from numba.extending import register_jitable

from springback.kernels.kernel_cache import KernelCache

#: Parts of numba whose stubs know only some of their options, or that have none.
_overload: Any = numba.extending.overload
_register_pass: Any = compiler_machinery.register_pass
_Lower: Any = lowering.Lower
_NativeLowering: Any = typed_passes.NativeLowering
_Compiler: Any = compiler.Compiler

F = TypeVar("F", bound=Callable[..., Any])
P = ParamSpec("P")
R = TypeVar("R", covariant=True)


#: Attributes of every function, as LLVM writes them.  By itself LLVM fills only half of a register
#: of 512 bits on processors of Intel's, whose early ones slowed down with more; and it takes the
#: stack as it comes, where a register put aside mostly lies across two lines of the cache.
_FOR_LANES = ('"prefer-vector-width"="512"', '"stackrealign"')


class _LowerForLanes(_Lower):  # type: ignore[misc]
    def setup_function(self, fndesc: Any) -> None:
        super().setup_function(fndesc)
        set.update(self.function.attributes, _FOR_LANES)  # llvmlite's own `add` refuses these


@_register_pass(mutates_CFG=True, analysis_only=False)
class _LoweringForLanes(_NativeLowering):  # type: ignore[misc]
    _name = "lowering_for_lanes"

    @property
    def lowering_class(self) -> Any:
        return _LowerForLanes


class _CompilerForLanes(_Compiler):  # type: ignore[misc]
    def define_pipelines(self) -> list[Any]:
        pipelines: list[Any] = super().define_pipelines()
        for pipeline in pipelines:
            pipeline.passes = [
                (_LoweringForLanes if step is _NativeLowering else step, title)
                for step, title in pipeline.passes
            ]
            pipeline.finalize()
        return pipelines


#: Flags of code that may assume finite numbers; finiteness is checked outside
#: (simulation.executor).
FINITE = {"nnan", "ninf", "nsz"}
_COMMON: dict[str, Any] = {
    "error_model": "numpy", "no_cfunc_wrapper": True, "pipeline_class": _CompilerForLanes,
}  # fmt: skip
#: Kernels hold floats only: without the code that counts references they compile a seventh faster.
_UNCOUNTED: dict[str, Any] = {"forceinline": True, "_nrt": False, **_COMMON}
INLINED: dict[str, Any] = {"fastmath": FINITE, **_UNCOUNTED}
GUARDING: dict[str, Any] = {"fastmath": False, **_UNCOUNTED}
STRICT: dict[str, Any] = {"fastmath": False, **_COMMON}

#: What the compiler raises where it cannot translate a kernel.
CompilerError: type[Exception] = NumbaError

_SOURCES = (
    "kernels", "vehicle", "contact", "dynamics", "simulation", "sensing", "control", "recovery",
)  # fmt: skip


def kernel(function: F) -> F:
    """Physics on floats: plain Python for Python, inlined machine code for an executor."""
    registered: F = register_jitable(**INLINED)(function)
    return registered


def guard(function: F) -> F:
    """A kernel that must see NaN and infinity for what they are."""
    registered: F = register_jitable(**GUARDING)(function)
    return registered


def rare_kernel(function: F) -> F:
    """A kernel for rare events: compiled once and called, never inlined, strict about NaN.

    It may hold lists.  Callees inherit their caller's flags unless they set them, so the code that
    counts references, which kernels go without, is asked for here.
    """
    registered: F = register_jitable(**{**STRICT, "_nrt": True})(function)
    return registered


def compiled(
    function: Callable[..., Any], options: dict[str, Any] = INLINED, *, literal: bool = False
) -> Callable[[F], F]:
    """Decorator for a rule that tells the compiler what a function becomes for given types.

    The rule gets compiler types and returns a Python function, or None if the types do not fit.
    ``literal`` shows it the values of constant strings.
    """

    def teach(rule: F) -> F:
        _overload(function, jit_options=options, strict=False, prefer_literal=literal)(rule)
        return rule

    return teach


class Generic(Protocol[P, R]):
    """A function chosen by the type of its first argument."""

    def __call__(self, *arguments: P.args, **named: P.kwargs) -> R:
        """Call the function registered for the type of the first argument."""

    def register(self, cls: type) -> Callable[[F], F]:
        """Decorator that makes a function the one for ``cls``."""

    def dispatch(self, cls: type) -> Callable[..., R]:
        """The function for ``cls``."""


#: Every generic function there is.
_GENERICS: list[Generic[..., Any]] = []


def registered(cls: type) -> list[Callable[..., Any]]:
    """What each generic function does for ``cls``."""
    return [known.dispatch(cls) for known in _GENERICS]


def generic(function: Callable[P, R]) -> Generic[P, R]:
    """A kernel that is chosen by the type of its first argument, in Python and when compiled.

    Other types join with ``function.register(Type)``, exactly as for `functools.singledispatch`.
    What is like a tree (`springback.kernels.layout.TreeLayout`) counts for the tree.
    """
    by_class = functools.singledispatch(function)

    @functools.wraps(function)
    def choosing(*arguments: Any) -> Any:
        cls = getattr(arguments[0], "instance_class", None) or type(arguments[0])
        return by_class.dispatch(cls)(*arguments)

    chosen: Any = choosing
    chosen.register, chosen.dispatch = by_class.register, by_class.dispatch

    @compiled(chosen)
    def by_type(*arguments: Any) -> Any:
        return chosen.dispatch(arguments[0].instance_class)

    typed = cast("Generic[P, R]", chosen)
    _GENERICS.append(typed)
    return typed


def is_named(numba_type: Any, cls: type) -> bool:
    """Whether a compiler type is the NamedTuple class ``cls``."""
    return getattr(numba_type, "instance_class", None) is cls


@functools.cache
def source_digest() -> str:
    """Digest of every source file that ends up in compiled code.

    The compiler's own cache looks at the file of the entry function only; an edit or an upgrade
    elsewhere would go unseen.  So the digest names the cache folder.
    """
    package = Path(__file__).parents[1]
    digest = hashlib.sha256()
    for chapter in ("", *_SOURCES):
        for path in sorted((package / chapter).glob("*.py")):
            digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


def cache_folder() -> Path:
    """Folder of the compiled kernels; ``SPRINGBACK_CACHE_DIR`` overrides the user's."""
    root = os.environ.get("SPRINGBACK_CACHE_DIR") or platformdirs.user_cache_dir("springback")
    # An unknown user's ~ stays as it is.
    return Path(os.path.expanduser(root)) / "kernels" / source_digest()


def is_writable(folder: Path) -> bool:
    """Whether ``folder`` exists or can be made, and takes files."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError:
        return False
    return os.access(folder, os.W_OK)


def _entry(function: F, folder: Path | None, options: dict[str, Any]) -> F:
    """Compile an entry point, kept in a folder between processes, or not kept."""
    entry: Any = njit(**{**STRICT, **options})(function)
    if folder is not None:
        entry._cache = KernelCache(function, folder)
    return cast("F", entry)


def executor(**options: Any) -> Callable[[F], F]:
    """Compile an entry point, kept on disk between processes.

    The undecorated function stays reachable as ``.py_func``: that is the plain-Python executor.
    """

    def compile_entry(function: F) -> F:
        return _entry(function, cache_folder(), options)

    return compile_entry


def rebound(function: F, **others: Any) -> F:
    """A function whose globals of some names are others: the same loop around other functions."""
    rebuilt = types.FunctionType(
        function.__code__,
        {**function.__globals__, **others},
        function.__name__,
    )
    rebuilt.__defaults__ = function.__defaults__
    rebuilt.__module__, rebuilt.__qualname__ = function.__module__, function.__qualname__
    return cast("F", rebuilt)


class Origin(NamedTuple):
    """All that decides what the code of a user's types becomes."""

    files: tuple[str, ...]
    """Of the code."""
    modules: tuple[str, ...]
    """Under which it was imported: a kept kernel finds its types by these names."""
    frozen: str
    """Digest of the values that it takes from elsewhere (`springback.kernels.frozen`)."""

    def words(self) -> list[str]:
        """What names a place where its kernels are kept."""
        read = [hashlib.sha256(Path(path).read_bytes()).hexdigest() for path in self.files]
        return [*self.files, *read, *self.modules, self.frozen]


@functools.cache
def own_executor(function: F, origin: Origin | None, **options: Any) -> F:
    """An entry point for models that hold a user's types, apart from the package's own kernels.

    A kept kernel can be read only where its types can be imported under the same names, and must
    follow edits of their source and of the values frozen into it.  So these are kept in a folder
    named after all of that, or not at all.

    Args:
        function: The undecorated entry point.
        origin: Of the user's code; None if there is none to be relied on.
        **options: As for `executor`.
    """
    if origin is None:
        return _entry(function, None, options)
    digest = hashlib.sha256("\n".join((source_digest(), *origin.words())).encode())
    folder = cache_folder().parents[1] / "own" / digest.hexdigest()[:32]
    return _entry(function, folder, options)
