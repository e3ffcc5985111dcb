"""Trees: NamedTuples and tuples, nested, with a float at every leaf.

A vehicle, its state and everything measured on it are trees.  The operations here treat any tree
alike, so no module keeps offsets into arrays and no formula is written per arm.  Each works on
plain Python objects; when compiled, the tree's type is known and straight-line code is generated.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, TypeVar

import numpy as np
from numba import types

from springback.kernels.compiler import GUARDING, compiled

T = TypeVar("T")
R = TypeVar("R")
Buffer = np.ndarray[Any, np.dtype[np.float64]]


# -- plain Python ---------------------------------------------------------------------------------


def leaves(tree: Any) -> list[float]:
    """All floats of a tree, in order."""
    if isinstance(tree, tuple):
        return [leaf for branch in tree for leaf in leaves(branch)]
    return [tree]


def rebuilt(like: T, values: Iterable[float]) -> T:
    """A tree shaped as ``like`` with its floats replaced, in order."""
    stream = iter(values)

    def build(tree: Any) -> Any:
        if not isinstance(tree, tuple):
            return float(next(stream))
        branches = [build(branch) for branch in tree]
        return type(tree)(*branches) if hasattr(tree, "_fields") else tuple(branches)

    built: T = build(like)
    return built


def names(tree: Any, prefix: str = "") -> list[str]:
    """Dotted names of all leaves, in order: ``state.position.x``; tuple entries count from 1."""
    if not isinstance(tree, tuple):
        return [prefix]
    fields = getattr(tree, "_fields", range(1, len(tree) + 1))
    dot = f"{prefix}." if prefix else ""
    return [
        name
        for field, branch in zip(fields, tree, strict=True)
        for name in names(branch, f"{dot}{field}")
    ]


def each(
    function: Callable[..., R], zipped: tuple[Any, ...], shared: tuple[Any, ...]
) -> tuple[R, ...]:
    """``function(*one of each zipped, *shared)`` for every position of the zipped tuples."""
    return tuple(function(*some, *shared) for some in zip(*zipped, strict=True))


def column(trees: tuple[Any, ...], field: str) -> tuple[Any, ...]:
    """One field of every NamedTuple in a tuple of them."""
    return tuple(getattr(tree, field) for tree in trees)


def total(trees: tuple[T, ...]) -> T:
    """Leaf-by-leaf sum of equally shaped trees."""
    first, *others = trees
    values = leaves(first)
    for other in others:
        values = [a + b for a, b in zip(values, leaves(other), strict=True)]
    return rebuilt(first, values)


def least(values: tuple[float, ...]) -> float:
    """Smallest of some floats."""
    smallest = values[0]
    for value in values[1:]:
        smallest = value if value < smallest else smallest
    return smallest


def largest(values: tuple[float, ...]) -> float:
    """Largest of some floats."""
    greatest = values[0]
    for value in values[1:]:
        greatest = value if value > greatest else greatest
    return greatest


def along(x: T, rate: T, h: float) -> T:
    """X + h · rate, leaf by leaf."""
    pairs = zip(leaves(x), leaves(rate), strict=True)
    return rebuilt(x, [a + h * b for a, b in pairs])


def along_strictly(x: T, rate: T, h: float) -> T:
    """X + h · rate where a rate may be NaN or infinite; the result then is so too."""
    return along(x, rate, h)


def square(tree: Any) -> float:
    """Sum of the squares of all leaves; NaN or infinite where a leaf is."""
    result = 0.0
    for leaf in leaves(tree):
        result = result + leaf * leaf
    return result


def pick(claim: bool, a: T, b: T) -> T:
    """``a`` where the claim holds, else ``b``: a selection, not a branch, in compiled code."""
    return a if claim else b


def rows(like: Any) -> int:
    """Number of floats in a tree."""
    return len(leaves(like))


def read(like: T, buffer: Buffer, row: int, width: int, lane: int) -> T:
    """The tree that lies in ``buffer`` from ``row`` on, in the column ``lane`` of ``width``."""
    return rebuilt(like, [buffer[(row + k) * width + lane] for k in range(rows(like))])


def write(tree: Any, buffer: Buffer, row: int, width: int, lane: int) -> None:
    """Lay a tree into ``buffer`` from ``row`` on, in the column ``lane`` of ``width``."""
    for k, leaf in enumerate(leaves(tree)):
        buffer[(row + k) * width + lane] = leaf


# -- the same, generated for the compiler from the tree's type ------------------------------------


def _branches(tree: Any) -> list[Any]:
    return [tree.types[k] for k in range(len(tree))]


def _paths(tree: Any, stem: str) -> list[str]:
    """Source text that reaches every leaf."""
    if isinstance(tree, types.BaseTuple):
        return [
            p for k, branch in enumerate(_branches(tree)) for p in _paths(branch, f"{stem}[{k}]")
        ]
    return [stem]


def _construct(tree: Any, texts: list[str], scope: dict[str, Any]) -> str:
    """Source text that builds a tree of this type from the leaves' texts, consumed in order."""
    if not isinstance(tree, types.BaseTuple):
        return texts.pop(0)
    inner = ", ".join(_construct(branch, texts, scope) for branch in _branches(tree))
    cls = getattr(tree, "instance_class", None)
    if cls is not None:
        scope[cls.__name__] = cls
        return f"{cls.__name__}({inner})"
    return f"({inner},)" if len(tree) else "()"


def _function(arguments: str, lines: list[str], scope: dict[str, Any]) -> Callable[..., Any]:
    body = "\n".join(f"    {line}" for line in lines)
    exec(f"def generated({arguments}):\n{body}\n", scope)
    generated: Callable[..., Any] = scope["generated"]
    return generated


@compiled(each)
def _each(function: Any, zipped: Any, shared: Any) -> Any:
    calls = []
    for j in range(len(zipped[0])):
        given = [f"zipped[{k}][{j}]" for k in range(len(zipped))]
        given += [f"shared[{k}]" for k in range(len(shared))]
        calls.append(f"function({', '.join(given)})")
    return _function("function, zipped, shared", [f"return ({', '.join(calls)},)"], {})


@compiled(column, literal=True)
def _column(trees: Any, field: Any) -> Any:
    if not isinstance(field, types.StringLiteral):
        return None
    fields = [f"trees[{j}].{field.literal_value}" for j in range(len(trees))]
    return _function("trees, field", [f"return ({', '.join(fields)},)"], {})


@compiled(total)
def _total(trees: Any) -> Any:
    columns = zip(*(_paths(trees[j], f"trees[{j}]") for j in range(len(trees))), strict=True)
    scope: dict[str, Any] = {}
    text = _construct(trees[0], [" + ".join(column) for column in columns], scope)
    return _function("trees", [f"return {text}"], scope)


def _fold(sign: str) -> Callable[[Any], Any]:
    def typed(values: Any) -> Any:
        lines = ["best = values[0]"]
        for k in range(1, len(values)):
            lines.append(f"best = values[{k}] if values[{k}] {sign} best else best")
        return _function("values", [*lines, "return best"], {})

    return typed


compiled(least)(_fold("<"))
compiled(largest)(_fold(">"))


@compiled(along_strictly, GUARDING)
@compiled(along)
def _along(x: Any, rate: Any, h: Any) -> Any:
    texts = [f"{a} + h * {b}" for a, b in zip(_paths(x, "x"), _paths(rate, "rate"), strict=True)]
    scope: dict[str, Any] = {}
    text = _construct(x, texts, scope)
    return _function("x, rate, h", [f"return {text}"], scope)


@compiled(square, GUARDING)
def _square(tree: Any) -> Any:
    terms = " + ".join(["0.0", *(f"{leaf} * {leaf}" for leaf in _paths(tree, "tree"))])
    return _function("tree", [f"return {terms}"], {})


@compiled(pick)
def _pick(claim: Any, a: Any, b: Any) -> Any:
    pairs = zip(_paths(a, "a"), _paths(b, "b"), strict=True)
    texts = [f"({x} if claim else {y})" for x, y in pairs]
    scope: dict[str, Any] = {}
    text = _construct(a, texts, scope)
    return _function("claim, a, b", [f"return {text}"], scope)


@compiled(rows)
def _rows(like: Any) -> Any:
    count = len(_paths(like, "like"))
    return _function("like", [f"return {count}"], {})


@compiled(read)
def _read(like: Any, buffer: Any, row: Any, width: Any, lane: Any) -> Any:
    texts = [f"buffer[(row + {k}) * width + lane]" for k in range(len(_paths(like, "like")))]
    scope: dict[str, Any] = {}
    text = _construct(like, texts, scope)
    return _function("like, buffer, row, width, lane", [f"return {text}"], scope)


@compiled(write)
def _write(tree: Any, buffer: Any, row: Any, width: Any, lane: Any) -> Any:
    lines = [
        f"buffer[(row + {k}) * width + lane] = {leaf}"
        for k, leaf in enumerate(_paths(tree, "tree"))
    ]
    return _function("tree, buffer, row, width, lane", [*lines, "return None"], {})
