"""Laws of the user's own that are compiled: tried once in plain Python, errors in one line."""

from __future__ import annotations

import inspect
import re
import traceback
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple, NoReturn

from springback.contact.obstacles import in_body_frame, outward_normal, signed_distance
from springback.errors import InputError
from springback.kernels.compiler import CompilerError, Generic, user_executor
from springback.kernels.trees import leaves, rebuilt
from springback.kernels.vectors import Quat, Vec, rotation
from springback.scenario.code_files import PACKAGE, error_place, error_words

#: Longest call that an error of the compiler shows (chosen).
LONGEST = 200
#: What the compiler says of a value that it would have to count references to.
UNCOUNTED = "NRT required but not enabled"
#: What the compiler says of a function that is not marked as a kernel.
PLAIN = r"global name '(\w+)': Cannot determine Numba type of <class 'function'>"
#: Beginnings of what the compiler says of a call whose own reason follows.
NO_REASON = ("Failed in ", "No implementation of function ")


def home_of(thing: Any) -> tuple[str, int]:
    """File and line of a function, or of the method by which an object is called."""
    function = inspect.unwrap(getattr(thing, "py_func", thing))
    method = getattr(type(function), "__call__")  # noqa: B004, B009
    code = getattr(function, "__code__", None) or getattr(method, "__code__", None)
    return (code.co_filename, code.co_firstlineno) if code else (f"{thing!r}", 0)


def source_text(value: Any) -> str:
    """A value as Python source, on one line and not too long, for messages."""
    try:
        text = " ".join(repr(value).split())
    except Exception:  # in the user's own class
        text = f"a {type(value).__name__}"
    return text if len(text) <= 60 else f"{text[:57]}..."


class Law(NamedTuple):
    """Function of the user's own that is registered for a type of settings."""

    name: str
    """Of the law and its type, for errors."""
    step: Generic[..., Any]
    """Generic function with which it is registered."""
    given: tuple[Any, ...]
    """Arguments of its first call, of which the first has its type."""

    @property
    def function(self) -> Callable[..., Any]:
        """The function itself, in plain Python."""
        return self.step.dispatch(type(self.given[0]))

    @property
    def home(self) -> tuple[str, int]:
        """Its file and line."""
        return home_of(self.function)

    def refuse(self, why: str) -> NoReturn:
        """Raise an InputError, given what is wrong: a sentence without its subject."""
        file, line = self.home
        raise InputError(f"{file}:{line}: {self.name} {why}")

    def call(self) -> Any:
        """Its result for the first tick, in plain Python.

        Raises:
            InputError: If it fails, with file and line.
        """
        try:
            return self.function(*self.given)
        except (Exception, SystemExit) as error:
            place = error_place(error, *self.home)
            raise InputError(f"{place}: {self.name}: {error_words(error)}, at 0 s") from error

    def compile(self) -> None:
        """Compile it apart from any flight, uncached: a second or two.

        Raises:
            InputError: If it cannot be compiled, with file and line.
        """
        step = self.step

        def called(*given: Any) -> Any:
            return step(*given)

        with in_words([self]):
            user_executor(called, None)(*(_as_flown(tree) for tree in self.given))

    def check_output(self, tree: Any, stem: str) -> None:
        """Reject an output that is no tree of floats."""
        file, line = self.home
        check_floats(tree, f"{file}:{line}: {self.name}: {stem}")

    def check_memory(self, before: Any, after: Any) -> None:
        """Reject a memory that is no tree of floats, or of another layout than the first."""
        self.check_output(after, "memory")
        first, last = layout_text(before), layout_text(after)
        if first != last:
            self.refuse(f"must return a memory like the first, {first} (got {last})")


def _as_flown(tree: Any) -> Any:
    """A tree as a flight holds it: of floats alone."""
    return rebuilt(tree, map(float, leaves(tree))) if isinstance(tree, tuple) else tree


def law_of(step: Generic[..., Any], part: Any, seen: Any, what: str) -> Law:
    """Law of a compiled part, whose settings and memory must be trees of floats.

    Args:
        step: Generic function with which its type must be registered.
        part: With settings and memory.
        seen: What it sees at the first tick.
        what: What it should be, for errors, such as ``a pilot``.

    Raises:
        InputError: If they are not, or if the type is not registered.
    """
    check_floats(part.settings, "settings")
    check_floats(part.memory, "memory")
    kind = type(part.settings)
    law, name = step.dispatch(kind), getattr(step, "__name__", "")
    if home_of(law)[0].startswith(PACKAGE) and not kind.__module__.startswith("springback."):
        raise InputError(f"{kind.__name__} is not {what} yet: register {name} for it")
    return Law(f"{name} of {kind.__name__}", step, (part.settings, 0.0, seen, part.memory))


def laws_of_shape(shape: Any, point: Vec) -> list[Law]:
    """Functions of the user's own that are registered for a shape; none of a shape of the package.

    Args:
        shape: A NamedTuple of floats and vectors.
        point: At which they are called first, world [m].
    """
    calls: tuple[tuple[Generic[..., Any], tuple[Any, ...]], ...] = (
        (signed_distance, (shape, point)),
        (outward_normal, (shape, point)),
        (in_body_frame, (shape, point, rotation(Quat(1.0, 0.0, 0.0, 0.0)))),
    )
    kind = type(shape)
    return [
        Law(f"{getattr(step, '__name__', '')} of {kind.__name__}", step, given)
        for step, given in calls
        if not home_of(step.dispatch(kind))[0].startswith(PACKAGE)
    ]


def check_floats(tree: Any, stem: str) -> None:
    """Reject anything but a tree of floats, and name the leaf."""
    if isinstance(tree, tuple):
        fields = getattr(tree, "_fields", [str(k) for k in range(1, len(tree) + 1)])
        for field, branch in zip(fields, tree, strict=True):
            check_floats(branch, f"{stem}.{field}")
    elif not isinstance(tree, float):
        kind = type(tree).__name__
        hint = f"; write {float(tree)!r}" if isinstance(tree, int) else ""
        raise InputError(
            f"{stem} must be a float, or a NamedTuple or tuple of floats, to be compiled "
            f"(got {source_text(tree)}, {kind}){hint}"
        )


def layout_text(tree: Any) -> str:
    """Types of a tree in words, such as ``Memory(float, Vec(float, float, float))``."""
    if not isinstance(tree, tuple):
        return "float"
    kind = type(tree).__name__ if hasattr(tree, "_fields") else ""
    return f"{kind}({', '.join(layout_text(branch) for branch in tree)})"


@contextmanager
def in_words(laws: Sequence[Law]) -> Iterator[None]:
    """Report errors of the compiler in one line, with the place in the user's file."""
    try:
        yield
    except Exception as error:
        if not laws or not _is_of_compiler(error):
            raise
        text = re.sub(r"\x1b\[[0-9;]*m", "", str(error))
        # The compiler reports the innermost place and reason first.
        homes = [law.home for law in laws]
        found = ((file, _first_line_in(text, file)) for file, _ in homes)
        file, at = next(((file, line) for file, line in found if line), homes[0])
        raise InputError(f"{file}:{at}: cannot be compiled: {_reason(text)}") from error


def _first_line_in(text: str, file: str) -> int:
    """First line of a file that an error of the compiler names; 0 if it names none."""
    named = re.findall(rf"(?:at|from) ({re.escape(file)}) \((\d+)\)", text)
    for near, line in named + re.findall(r'File "(.+)", line (\d+):', text):
        if Path(near).resolve() == Path(file).resolve():
            return int(line)
    return 0


def _is_of_compiler(error: Exception) -> bool:
    """True if the compiler raised an error: not all of its errors are of one class."""
    if isinstance(error, CompilerError):
        return True
    *_, (innermost, _) = traceback.walk_tb(error.__traceback__)
    return str(innermost.f_globals.get("__name__")).startswith(("numba.", "llvmlite."))


def _reason(text: str) -> str:
    """The innermost reason in an error of the compiler."""
    if UNCOUNTED in text:
        return (
            "a list, set, dictionary or text cannot be compiled here; use floats, and tuples and "
            "NamedTuples of them"
        )
    if plain := re.search(PLAIN, text):
        return f"{plain.group(1)} is plain Python; mark it with @kernel"
    messages: list[str] = re.findall(r"\w+Error: (?:Failed in .+\s+)?(.+)", text)
    reasons = [line for line in messages if not line.startswith(NO_REASON)]
    unknown = re.findall(r">>> (.+)", text)[-1:]  # the innermost call
    reasons += [f"the compiler has no {call}" for call in unknown if len(call) <= LONGEST]
    reasons += messages or text.strip().splitlines()
    return reasons[0].partition(" Raised from ")[0].strip(" .")
