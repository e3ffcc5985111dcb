"""The interface to the compiler; no other module imports it.

Physics is written once, for one vehicle, on floats and NamedTuples of floats.  A function marked
`kernel` stays an ordinary Python function when Python calls it, and is compiled and inlined when an
`executor` calls it.  One source thus serves plain Python, one compiled flight and a batch of
flights.

The arithmetic flags let the compiler drop terms that are exactly zero (``nnan``, ``ninf``, ``nsz``)
and nothing else: no contraction, no reassociation, no approximate division.  Every operation is
then rounded as IEEE 754 says, and all executors return the same bits (docs/decisions/0003).
"""

from __future__ import annotations

import functools
import gc
import hashlib
import os
import types
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple, ParamSpec, Protocol, TypeVar, cast

import numba
import numba.extending
import platformdirs
from numba import njit
from numba.core.errors import NumbaError
from numba.core.registry import cpu_target
from numba.core.typing import templates
from numba.extending import register_jitable

from springback.kernels.kernel_cache import KernelCache
from springback.kernels.packaged.manifest import (
    Target,
    compiler_versions,
    fitting_kernels,
    status_text,
)
from springback.kernels.passes.pipeline import LISTED, LaneCompiler

#: Parts of numba without type stubs.
_overload: Any = numba.extending.overload
_templates: Any = templates
_intrinsic_template: Any = templates.make_intrinsic_template

F = TypeVar("F", bound=Callable[..., Any])
P = ParamSpec("P")
R = TypeVar("R", covariant=True)


#: Flags for code that may assume finite numbers; finiteness is checked outside
#: (simulation.executor).
FINITE = {"nnan", "ninf", "nsz"}
_COMMON: dict[str, Any] = {
    "error_model": "numpy", "no_cfunc_wrapper": True, "pipeline_class": LaneCompiler,
}  # fmt: skip
#: Kernels hold floats only: compiling them without reference counting is one seventh faster.
_UNCOUNTED: dict[str, Any] = {"forceinline": True, "_nrt": False, **_COMMON}
INLINED: dict[str, Any] = {"fastmath": FINITE, **_UNCOUNTED}
GUARDING: dict[str, Any] = {"fastmath": False, **_UNCOUNTED}
STRICT: dict[str, Any] = {"fastmath": False, **_COMMON}
CALLED: dict[str, Any] = {**INLINED, "forceinline": False}
CALLED_STRICTLY: dict[str, Any] = {**GUARDING, "forceinline": False}
#: Kernels that are called on a processor only.
INLINED_ON_GPUS: set[Callable[..., Any]] = set()

#: Exceptions that the compiler raises where it cannot translate a kernel.
CompilerError: type[Exception] = NumbaError

_SOURCES = (
    "kernels", "vehicle", "contact", "dynamics", "simulation", "sensing", "control", "recovery",
)  # fmt: skip


def kernel(function: F) -> F:
    """Mark a function as physics on floats: plain Python for Python, inlined in an executor."""
    registered: F = register_jitable(**INLINED)(function)
    return registered


def guard(function: F) -> F:
    """Mark a kernel that must handle NaN and infinity exactly."""
    registered: F = register_jitable(**GUARDING)(function)
    return registered


def rare_kernel(function: F) -> F:
    """Mark a kernel for rare events: compiled once and called, strict about NaN.

    On a GPU it is inlined.
    """
    return _called_on_processors(function, CALLED_STRICTLY)


def list_kernel(function: F) -> F:
    """Mark a kernel for rare events that holds lists, as `rare_kernel`.

    Callees inherit their caller's flags unless they set them, so reference counting, which kernels
    do without, is switched on here.
    """
    LISTED.add(cast("types.FunctionType", function))
    return _called_on_processors(function, {**CALLED_STRICTLY, "_nrt": True})


def step_kernel(function: F) -> F:
    """Mark a long part of a step that passes buffers: called, and on a GPU inlined.

    There the buffers are a thread's own, and in registers where all is inlined.
    """
    return _called_on_processors(function, CALLED)


def called_kernel(function: F) -> F:
    """Mark a long kernel: compiled once and called where others are inlined.

    A callee inherits its caller's flags unless it sets them, to be inlined among them.
    """
    registered: F = register_jitable(**CALLED)(function)
    return registered


def _called_on_processors(function: F, options: dict[str, Any]) -> F:
    INLINED_ON_GPUS.add(function)
    registered: F = register_jitable(**options)(function)
    return registered


def compiler_rule(
    function: Callable[..., Any], options: dict[str, Any] = INLINED, *, literal: bool = False
) -> Callable[[F], F]:
    """Decorator for a rule that gives the compiler an implementation of a function by types.

    The rule takes compiler types and returns a Python function, or None if the types do not fit.
    ``literal`` passes constant strings to it by value.
    """

    def teach(rule: F) -> F:
        _overload(function, jit_options=options, strict=False, prefer_literal=literal)(rule)
        return rule

    return teach


def code_rule(function: Callable[..., Any], *, literal: bool = False) -> Callable[[F], F]:
    """Decorator for a rule that gives the compiler machine code of a function by types.

    The rule takes the compiler's typing context and the types of the arguments, and returns the
    signature and a function that emits the code where it is called, or None if the types do not
    fit.  Nothing is parsed and typed, as a Python function of `compiler_rule` would be.
    """

    def teach(rule: F) -> F:
        template = _intrinsic_template(function, rule, rule.__name__, prefer_literal=literal)
        _templates.infer(template)
        _templates.infer_global(function, numba.types.Function(template))
        return rule

    return teach


class Generic(Protocol[P, R]):
    """Function dispatched on the type of its first argument."""

    def __call__(self, *arguments: P.args, **named: P.kwargs) -> R:
        """Call the function registered for the type of the first argument."""

    def register(self, cls: type) -> Callable[[F], F]:
        """Decorator that registers a function for ``cls``."""

    def dispatch(self, cls: type) -> Callable[..., R]:
        """The function registered for ``cls``."""


#: All generic functions.
_GENERICS: list[Generic[..., Any]] = []


def implementations(cls: type) -> list[Callable[..., Any]]:
    """Implementations of every generic function for ``cls``."""
    return [known.dispatch(cls) for known in _GENERICS]


def generic(function: Callable[P, R]) -> Generic[P, R]:
    """Mark a kernel that dispatches on the type of its first argument, in Python and when compiled.

    Other types join with ``function.register(Type)``, as with `functools.singledispatch`.  The
    layout of a tree (`springback.kernels.layout.TreeLayout`) dispatches as the tree does.
    """
    by_class = functools.singledispatch(function)

    @functools.wraps(function)
    def choosing(*arguments: Any) -> Any:
        cls = getattr(arguments[0], "instance_class", None) or type(arguments[0])
        return by_class.dispatch(cls)(*arguments)

    chosen: Any = choosing
    chosen.register, chosen.dispatch = by_class.register, by_class.dispatch

    @compiler_rule(chosen)
    def by_type(*arguments: Any) -> Any:
        return chosen.dispatch(getattr(arguments[0], "instance_class", tuple))

    typed = cast("Generic[P, R]", chosen)
    _GENERICS.append(typed)
    return typed


def is_named(numba_type: Any, cls: type) -> bool:
    """True if a compiler type is the NamedTuple class ``cls``."""
    return getattr(numba_type, "instance_class", None) is cls


@functools.cache
def source_digest() -> str:
    """Digest of every source file that contributes to compiled code.

    The compiler's own cache checks the file of the entry function only, so an edit elsewhere would
    go unnoticed.
    """
    package = Path(__file__).parents[1]
    digest = hashlib.sha256()
    for chapter in ("", *_SOURCES):
        for path in sorted((package / chapter).glob("**/*.py" if chapter else "*.py")):
            digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


@functools.cache
def state_digest() -> str:
    """Digest of everything but the processor that determines compiled code.

    That is the source, the versions of interpreter and compiler, and its options.  It names the
    folder of the cache: code of another version may read its data where they no longer are.
    """
    versions = repr(sorted(compiler_versions().items()))
    return hashlib.sha256(f"{source_digest()} {versions}".encode()).hexdigest()[:16]


def compiler_target() -> Target:
    """What this process compiles for."""
    triple, name, features = cpu_target.target_context.codegen().magic_tuple()
    return triple, name, features


def packaged_kinds() -> tuple[str, ...]:
    """Kinds of flight all of whose kernels came with the package, and fit."""
    fitting = fitting_kernels(source_digest(), compiler_target())
    return () if fitting is None else fitting.kinds


def packaged_status() -> str:
    """Line on kernels that came with the package: which are used, or why none is."""
    return status_text(source_digest(), compiler_target())


def cache_folder() -> Path:
    """Folder of the compiled kernels; ``SPRINGBACK_CACHE_DIR`` overrides the user's."""
    root = os.environ.get("SPRINGBACK_CACHE_DIR") or platformdirs.user_cache_dir("springback")
    # An unknown user's ~ is left unexpanded.
    return Path(os.path.expanduser(root)) / "kernels" / state_digest()


def is_writable(folder: Path) -> bool:
    """True if ``folder`` exists or can be created, and files can be written to it."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError:
        return False
    return os.access(folder, os.W_OK)


@contextmanager
def no_collection() -> Iterator[None]:
    """Context without the garbage collector, which would walk all objects for nothing."""
    running = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if running:
            gc.enable()


def _entry(function: F, folder: Path | None, options: dict[str, Any], source: str = "") -> F:
    """Compile an entry point, cached in a folder between processes, or not cached.

    Args:
        function: The undecorated entry point.
        folder: That of the cached kernels, or None.
        options: Those of the compiler.
        source: Digest of the source, if its kernels may have come with the package.
    """
    entry: Any = njit(**{**STRICT, **options})(function)
    if folder is not None:
        cache = entry._cache = KernelCache(function, folder, source)
        compile_now = entry._compiler.compile

        def compile_or_unlock(*signature: Any) -> Any:
            try:
                with no_collection():
                    return compile_now(*signature)
            except BaseException:
                cache.end_compilation()
                raise

        entry._compiler.compile = compile_or_unlock
    return cast("F", entry)


class CompiledRoutine(NamedTuple):
    """Machine code of a function that its callers reach by its address."""

    address: int
    owner: Any  # keeps the code in memory


def compile_apart(function: Callable[..., Any], signature: Any, folder: Path) -> CompiledRoutine:
    """Compile a function by itself, cached on disk, for callers that know its address only.

    Args:
        function: A kernel.
        signature: Compiler types of its arguments.
        folder: That of the cached kernels.
    """
    entry: Any = _entry(function, folder, {}, source_digest())
    return CompiledRoutine(_address(entry, signature), entry)


def code_address(entry: Any, arguments: tuple[Any, ...]) -> int:
    """Address of the machine code of an entry point for some arguments; compiled if need be."""
    return _address(entry, tuple(map(entry.typeof_pyval, arguments)))


def _address(entry: Any, signature: Any) -> int:
    entry.compile(signature)
    made = entry.overloads[signature]
    return int(made.library.get_pointer_to_function(made.fndesc.llvm_func_name))


def is_compiled_apart(function: Callable[..., Any], signature: Any, folder: Path) -> bool:
    """True if `compile_apart` would find the code in the cache, as far as can be seen."""
    return is_in_cache(_entry(function, folder, {}, source_digest()), signature)


def compile_uncached(function: Callable[..., Any], signature: Any) -> None:
    """Compile a function for some compiler types; only entry points that it calls are cached."""
    entry: Any = _entry(function, None, {"nogil": True})
    entry.compile(signature)


def is_in_cache(entry: Any, signature: Any) -> bool:
    """True if an entry point needs no compilation for some compiler types, as far as can be seen.

    Args:
        entry: An executor; of one that is never cached the answer is True.
        signature: Compiler types of its arguments.
    """
    cache = entry._cache
    if signature in entry.overloads or not isinstance(cache, KernelCache):
        return True
    return cache.holds(signature, entry.targetctx.codegen())


def executor(**options: Any) -> Callable[[F], F]:
    """Compile an entry point, cached on disk between processes.

    The undecorated function remains available as ``.py_func``: that is the plain-Python executor.
    """

    def compile_entry(function: F) -> F:
        return _entry(function, cache_folder(), options, source_digest())

    return compile_entry


def with_globals(function: F, **others: Any) -> F:
    """A copy of a function with some globals replaced: the same loop around other functions."""
    rebuilt = types.FunctionType(
        function.__code__,
        {**function.__globals__, **others},
        function.__name__,
    )
    rebuilt.__defaults__ = function.__defaults__
    rebuilt.__module__, rebuilt.__qualname__ = function.__module__, function.__qualname__
    return cast("F", rebuilt)


class Origin(NamedTuple):
    """Everything that determines the compiled code of a user's types."""

    files: tuple[str, ...]
    """Source files of the code."""
    modules: tuple[str, ...]
    """Names under which it was imported: a cached kernel finds its types by these names."""
    frozen: str
    """Digest of the values that it reads from elsewhere (`springback.kernels.frozen`)."""

    def words(self) -> list[str]:
        """Parts of the name of the folder in which its kernels are cached."""
        read = [hashlib.sha256(Path(path).read_bytes()).hexdigest() for path in self.files]
        return [*self.files, *read, *self.modules, self.frozen]


@functools.cache
def user_executor(function: F, origin: Origin | None, **options: Any) -> F:
    """Compile an entry point for a user's types, cached apart from the package's own kernels.

    A cached kernel can be read only where its types can be imported under the same names, and it
    must be recompiled when their source, or a value frozen into it, changes.  The folder's name
    therefore contains all of these; without an origin nothing is cached.

    Args:
        function: The undecorated entry point.
        origin: Origin of the user's code; None if unknown.
        **options: As for `executor`.
    """
    if origin is None:
        return _entry(function, None, options)
    digest = hashlib.sha256("\n".join((state_digest(), *origin.words())).encode())
    folder = cache_folder().parents[1] / "own" / digest.hexdigest()[:32]
    return _entry(function, folder, options)
