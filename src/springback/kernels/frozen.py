"""Values that a user's compiled code reads from outside its file, and that are frozen into it.

A compiled kernel holds the values that its globals had when it was compiled.  They may come from
anywhere: a file of gains, the environment, a module on another path.  A cached kernel is therefore
named after all of them, and is not cached where one of them has no digest.
"""

from __future__ import annotations

import dis
import enum
import functools
import hashlib
import sys
import types
from collections.abc import Iterable
from typing import Any

import numpy as np

#: Packages whose functions the compiler replaces by its own: their version identifies them.
_LIBRARIES = {"numpy", "numba", "scipy", "llvmlite"}
_PLAIN = (bool, int, float, complex, str, bytes, type(None), type(Ellipsis))
_BUILT_IN = (
    types.BuiltinFunctionType,
    types.MethodDescriptorType,
    types.WrapperDescriptorType,
    np.ufunc,
)


class UnsupportedGlobal(Exception):
    """A value without a digest."""


def frozen_digest(functions: Iterable[Any]) -> str | None:
    """Digest of all values that some functions, and their callees, read from outside.

    Args:
        functions: The user's functions; those of this package are skipped.

    Returns:
            SHA-256, hexadecimal; None if a value is not made of numbers, text, arrays, tuples,
        types and functions.
    """
    walk = _Walk()
    try:
        for function in functions:
            walk.value(function)
    except (UnsupportedGlobal, RecursionError):
        return None
    return walk.digest.hexdigest()


class _Walk:
    """Walk through functions and their globals, visiting each value once."""

    def __init__(self) -> None:
        self.digest = hashlib.sha256()
        self._seen: dict[int, Any] = {}
        """Visited values by identity; holding them prevents reuse of an id."""

    def value(self, value: Any) -> None:
        """Add a value."""
        if isinstance(value, enum.Enum):
            self._add("enum", type(value).__module__, type(value).__qualname__, value.name)
            self.value(value.value)
        elif isinstance(value, _PLAIN):
            self._add(type(value).__name__, repr(value))
        elif isinstance(value, np.ndarray | np.generic):
            array = np.asarray(value)
            if array.dtype.hasobject:
                raise UnsupportedGlobal
            self._add("array", array.dtype.str, str(array.shape))
            self.digest.update(array.tobytes())
        elif id(value) in self._seen:
            self._add("again", str(list(self._seen).index(id(value))))
        else:
            self._seen[id(value)] = value
            self._compound(value)

    def _compound(self, value: Any) -> None:
        if isinstance(value, tuple | list):
            self._add(type(value).__module__, type(value).__qualname__, str(len(value)))
            for entry in value:
                self.value(entry)
        elif isinstance(value, dict):
            self._add("dict", str(len(value)))
            for key, entry in value.items():
                self.value(key)
                self.value(entry)
        elif isinstance(value, type):
            self._type(value)
        elif isinstance(value, types.FunctionType):
            self._function(value)
        elif isinstance(function := getattr(value, "py_func", None), types.FunctionType):
            self._function(function)
        elif isinstance(value, types.MethodType):
            self.value(value.__self__)
            self.value(value.__func__)
        elif isinstance(value, _BUILT_IN):
            self._add("built in", str(getattr(value, "__module__", "")), value.__name__)
        else:
            raise UnsupportedGlobal

    def _type(self, cls: type) -> None:
        self._add("type", cls.__module__, cls.__qualname__)
        if _is_ours_or_known(cls.__module__):
            return
        for name, entry in sorted(vars(cls).items()):
            if isinstance(entry, property):
                entry = entry.fget
            elif isinstance(entry, staticmethod | classmethod):
                entry = entry.__func__
            if isinstance(entry, types.FunctionType) and entry.__module__ == cls.__module__:
                self._add(name)
                self.value(entry)
        self.value(getattr(cls, "_field_defaults", {}))

    def _function(self, function: types.FunctionType) -> None:
        self._add("function", str(function.__module__), function.__qualname__)
        if _is_ours_or_known(str(function.__module__)):
            root = str(function.__module__).partition(".")[0]
            self._add(str(getattr(sys.modules.get(root), "__version__", "")))
            return
        self.value(function.__defaults__)
        self.value(tuple((function.__kwdefaults__ or {}).items()))
        for cell in function.__closure__ or ():
            self.value(cell.cell_contents)
        self._code(function.__code__, function.__globals__)

    def _code(self, code: types.CodeType, scope: dict[str, Any]) -> None:
        self._add("code", ",".join(code.co_names), ",".join(code.co_varnames))
        self.digest.update(code.co_code)
        for constant in code.co_consts:
            if isinstance(constant, types.CodeType):
                self._code(constant, scope)
            else:
                self._constant(constant)
        for name in _globals_of(code):
            if name in scope:
                self._named(name, scope[name], code.co_names)

    def _constant(self, constant: Any) -> None:
        if isinstance(constant, frozenset):
            self._add("set", *sorted(map(repr, constant)))
        else:
            self.value(constant)

    def _named(self, name: str, value: Any, names: tuple[str, ...]) -> None:
        """Add a global; of a module, those of its entries that the code may refer to."""
        self._add("name", name)
        if not isinstance(value, types.ModuleType):
            self.value(value)
            return
        self._add("module", value.__name__)
        if _is_ours_or_known(value.__name__) or id(value) in self._seen:
            return
        self._seen[id(value)] = value
        for entry in names:
            if entry in vars(value):
                self._named(entry, vars(value)[entry], names)
        del self._seen[id(value)]

    def _add(self, *words: str) -> None:
        for word in words:
            self.digest.update(f"{len(word)}:{word}".encode(errors="surrogatepass"))


@functools.lru_cache(maxsize=1024)
def _globals_of(code: types.CodeType) -> tuple[str, ...]:
    """Names of the globals that code reads; attribute names are among them."""
    read = {
        step.argval
        for step in dis.get_instructions(code)
        if step.opname in ("LOAD_GLOBAL", "LOAD_NAME")
    }
    return tuple(sorted(read))


def _is_ours_or_known(module: str) -> bool:
    """True for modules of this package, whose source names the cache, and of known libraries."""
    root = module.partition(".")[0]
    return root == "springback" or root in _LIBRARIES or root in sys.stdlib_module_names
