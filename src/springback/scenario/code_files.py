"""Code of the user's own, named in a scenario as ``FILE.py:NAME``: import, digests, errors.

Reading and checking a scenario never imports such a file; building a flight does.
"""

from __future__ import annotations

import hashlib
import importlib.machinery
import importlib.util
import os
import sys
import traceback
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from types import CodeType, ModuleType
from typing import Any

from springback.errors import InputError, shown_value
from springback.user_code import CODE_FORM

#: Folder of the package: its frames are not the user's.
PACKAGE = str(Path(__file__).parents[1]) + os.sep
#: Tables and keys of a scenario that name code; a ``*`` is any entry of a list.
_OF_A_VEHICLE = (
    ("pilot",), ("pilot", "code"), ("estimator", "code"), ("recovery", "detection", "own", "code"),
)  # fmt: skip
_FILES_OF_A_VEHICLE = (("vehicle",), ("vehicle", "preset"), ("thrust",))
NAMED_AT: tuple[tuple[str, ...], ...] = (
    *_OF_A_VEHICLE, *(("second", *path) for path in _OF_A_VEHICLE),
    ("world", "obstacles", "*", "shape"),
)  # fmt: skip
#: Where a scenario may name the file of a vehicle, of thrusts, or of a second vehicle.
FILES_AT: tuple[tuple[str, ...], ...] = (
    *_FILES_OF_A_VEHICLE, *(("second", *path) for path in _FILES_OF_A_VEHICLE),
    ("second",), ("second", "preset"),
)  # fmt: skip
#: Where a scenario may name the files of models, of obstacles, and folders with what these name.
WORLDS_AT: tuple[tuple[str, ...], ...] = (
    ("vehicle", "body", "model"), ("second", "vehicle", "body", "model"),
    ("world", "obstacles", "*", "file"), ("world", "obstacles", "*", "search", "*"),
    ("world", "obstacles", "*", "shapes", "*", "file"),
)  # fmt: skip


# -- names in raw tables --------------------------------------------------------------------------


def with_absolute_names(given: Mapping[str, Any], folder: Path) -> dict[str, Any]:
    """Raw tables of a scenario whose relative names of code and other files are made absolute.

    Args:
        given: Raw tables.
        folder: Folder that the names are relative to.
    """
    result: Any = given
    for path in NAMED_AT:
        result = _change_at(result, path, lambda word: absolute_code(word, folder))
    for path in FILES_AT:
        result = _change_at(result, path, lambda word: _absolute_file(word, folder))
    for path in WORLDS_AT:
        result = _change_at(result, path, lambda word: _absolute_world(word, folder))
    return dict(result)


def _absolute_world(word: Any, folder: Path) -> Any:
    """Name of a file or folder of another program, made absolute."""
    is_name = isinstance(word, str) and word and "\x00" not in word
    return os.path.abspath(folder / word) if is_name else word


def _absolute_file(word: Any, folder: Path) -> Any:
    is_file = isinstance(word, str) and word.endswith((".toml", ".csv"))
    return os.path.abspath(folder / word) if is_file else word


def absolute_code(word: Any, folder: Path) -> Any:
    """Name of code, relative to a folder, as an absolute one; anything else as it is."""
    found = CODE_FORM.match(word) if isinstance(word, str) else None
    if found is None:
        return word
    return f"{os.path.abspath(folder / found['file'])}:{found['name']}"


def _change_at(node: Any, path: tuple[str, ...], change: Callable[[Any], Any]) -> Any:
    """Raw tables with the values at a path changed, where there are any."""
    if not path:
        return change(node)
    if path[0] == "*":
        entries = node if isinstance(node, list | tuple) else ()
        return [_change_at(entry, path[1:], change) for entry in entries] if entries else node
    if not isinstance(node, Mapping) or path[0] not in node:
        return node
    return {**node, path[0]: _change_at(node[path[0]], path[1:], change)}


def code_names(given: Mapping[str, Any]) -> list[str]:
    """Names of code in raw tables of a scenario."""
    found: list[str] = []

    def note(word: Any) -> Any:
        if isinstance(word, str):
            found.append(word)
        return word

    for path in NAMED_AT:
        _change_at(given, path, note)
    return found


# -- import ---------------------------------------------------------------------------------------

#: Imported modules, with the digest of their file.
_IMPORTED: dict[Path, tuple[str, ModuleType]] = {}


def read_object(word: str, what: str, *, anew: bool = False) -> Any:
    """Object of a Python file, which is imported once as long as it does not change.

    Args:
        word: ``file.py:name``.
        what: What it should be, for errors, such as ``a pilot``.
        anew: Run the file again, so that it has no memory of earlier flights.

    Raises:
        InputError: If there is no such file or name, or if the file fails.
    """
    found = CODE_FORM.match(word)
    if found is None:
        raise InputError(f"{shown_value(word)} is not {what}; write file.py:name")
    file = Path(found["file"])
    if file.suffix != ".py":  # the name of a module, perhaps
        meant = Path(f"{file}.py")
        hint = f"; did you mean {meant}:{found['name']}?" if meant.is_file() else ""
        raise InputError(f"{shown_value(word)}: must be FILE.py:NAME{hint}")
    module = _module(found["file"], anew)
    if not hasattr(module, found["name"]):
        mine = [key for key, value in vars(module).items() if _may_be_meant(value, module)]
        known = f"; there are: {', '.join(mine)}" if mine else ""
        raise InputError(f"{found['file']}: has no {found['name']!r}{known}")
    return getattr(module, found["name"])


def _may_be_meant(value: Any, module: ModuleType) -> bool:
    written = getattr(value, "__module__", None) == module.__name__
    is_function = callable(value) and getattr(value, "__name__", "_") != "_"
    is_tree = isinstance(value, tuple) and hasattr(value, "_fields")
    return is_tree or (written and is_function)


def _module(file: str, anew: bool) -> ModuleType:
    """Module of a file."""
    path = Path(file)
    try:
        data = path.read_bytes() if path.is_file() else None
    except OSError as error:
        raise InputError(f"{file}: cannot be read ({error.strerror})") from None
    except ValueError as error:  # an impossible file name
        raise InputError(f"{shown_value(file)}: cannot be read ({error})") from None
    if data is None:
        raise InputError(f"{file}: there is no such file")
    path, digest = path.resolve(), hashlib.sha256(data).hexdigest()
    known = _IMPORTED.get(path)
    if known is None or known[0] != digest or anew:
        _IMPORTED[path] = digest, _import_file(path, file)
    return _IMPORTED[path][1]


class _SourceLoader(importlib.machinery.SourceFileLoader):
    """Loader that compiles the file as it is: cached byte code knows its second and size only."""

    def get_code(self, fullname: str) -> CodeType:
        return self.source_to_code(self.get_data(self.path), self.path)


def _import_file(path: Path, shown: str) -> ModuleType:
    """Import a file as a module; its folder is searched for its imports.

    Its name depends on its path only, so that cached kernels find its types.
    """
    name = f"springback_user_{hashlib.sha256(str(path).encode()).hexdigest()[:8]}_{path.stem}"
    is_python = path.suffix == ".py"
    loader = _SourceLoader(name, str(path)) if is_python else None
    spec = importlib.util.spec_from_file_location(name, path, loader=loader)
    if spec is None or spec.loader is None:
        raise InputError(f"{shown}: is not a Python file; its name must end in .py")
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    _search(path.parent)
    try:
        spec.loader.exec_module(module)
    except SyntaxError as error:
        raise InputError(f"{error.filename}:{error.lineno}: is not Python: {error.msg}") from error
    except SystemExit as error:
        raise InputError(
            f"{error_place(error, str(path))}: leaves the program (sys.exit) when it is imported; "
            'put what it does as a script under if __name__ == "__main__":'
        ) from error
    except Exception as error:
        raise InputError(f"{error_place(error, str(path))}: {error_words(error)}") from error
    return module


def _search(folder: Path) -> None:
    """Let imports find a folder's modules first, and none of the same name of another's."""
    for path in folder.glob("*.py"):
        known = getattr(sys.modules.get(path.stem), "__file__", None)
        if known and Path(known).parent in {other.parent for other in _IMPORTED} - {folder}:
            del sys.modules[path.stem]
    if str(folder) in sys.path:
        sys.path.remove(str(folder))
    sys.path.insert(0, str(folder))


# -- digests --------------------------------------------------------------------------------------


def code_digests(words: Iterable[str]) -> dict[str, str]:
    """SHA-256 of the files of some objects, and of the modules beside them that they import.

    Args:
        words: Names such as ``file.py:name``; their files are imported.

    Raises:
        InputError: As `read_object`.
    """
    files: set[Path] = set()
    for word in words:
        found = CODE_FORM.match(word)
        if found is not None:
            module = _module(found["file"], False)
            files.update(_files_of(module, Path(found["file"]).resolve().parent, set()))
    return file_digests(files)


def file_digests(files: Iterable[Path]) -> dict[str, str]:
    """SHA-256 of some files, by path."""
    paths = sorted(set(files))
    return {str(path): hashlib.sha256(path.read_bytes()).hexdigest() for path in paths}


def changed_files(digests: Mapping[str, str]) -> list[str]:
    """Files that differ from their SHA-256, or are missing."""

    def differs(path: str) -> bool:
        try:
            return hashlib.sha256(Path(path).read_bytes()).hexdigest() != digests[path]
        except OSError:
            return True

    return [path for path in digests if differs(path)]


def _files_of(module: ModuleType, folder: Path, seen: set[str]) -> Iterator[Path]:
    """Files of a module, and of those that its names come from, in a folder or below."""
    file = getattr(module, "__file__", None)
    if file is None or module.__name__ in seen:
        return
    seen.add(module.__name__)
    path = Path(file).resolve()
    installed = str(path).startswith((sys.prefix + os.sep, sys.base_prefix + os.sep, PACKAGE))
    if installed or not path.is_relative_to(folder):
        return
    yield path
    for value in list(vars(module).values()):
        home = value if isinstance(value, ModuleType) else sys.modules.get(_home_name(value))
        if home is not None:
            yield from _files_of(home, folder, seen)


def _home_name(value: Any) -> str:
    name = getattr(value, "__module__", None) or getattr(type(value), "__module__", None)
    return name if isinstance(name, str) else ""


# -- errors, in one line --------------------------------------------------------------------------


def error_words(error: BaseException) -> str:
    """An error in one line."""
    return " ".join(f"{type(error).__name__}: {error}".split())


def error_place(error: BaseException, file: str = "", line: int = 1) -> str:
    """File and line of an error: the last that is in a file, else the last of the user's.

    Args:
        error: Error that was raised.
        file: File of the user.
        line: Line of the called function, for an error that was raised before it was entered.
    """
    frames = traceback.extract_tb(error.__traceback__)
    mine = [frame for frame in frames if frame.filename == file]
    others = [frame for frame in frames if not frame.filename.startswith((PACKAGE, "<"))]
    if not mine and not others:  # it was not even entered: its signature is wrong
        return f"{file}:{line}"
    last = (mine or others)[-1]
    return f"{last.filename}:{last.lineno}"
