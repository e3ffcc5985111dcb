"""Trees: NamedTuples and tuples, nested, with a float at every leaf.

A vehicle, its state and everything measured on it are trees.  The operations here accept any tree,
so no module computes offsets into arrays and no formula is written per arm.  In Python they work
on plain objects; when compiled, the tree's type is known and straight-line code is generated.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, TypeVar

from numba import types

from springback.kernels.compiler import GUARDING, code_rule, compiler_rule
from springback.kernels.tree_code import (
    axpy_tree,
    branches,
    leaf_types,
    map_code,
    select_tree,
)

T = TypeVar("T")
R = TypeVar("R")


# -- plain Python ---------------------------------------------------------------------------------


def leaves(tree: Any) -> list[float]:
    """All floats of a tree, in order."""
    if not isinstance(tree, tuple):
        return [tree]
    found: list[float] = []
    _gather(tree, found)
    return found


def _gather(tree: tuple[Any, ...], found: list[float]) -> None:
    for branch in tree:
        if isinstance(branch, tuple):
            _gather(branch, found)
        else:
            found.append(branch)


def rebuilt(like: T, values: Iterable[float]) -> T:
    """A tree of the shape of ``like`` with its floats replaced, in order."""
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


def tree_map(
    function: Callable[..., R], zipped: tuple[Any, ...], shared: tuple[Any, ...]
) -> tuple[R, ...]:
    """Tuple of ``function(*one of tree_map zipped, *shared)`` for every position of the tuples."""
    return tuple(function(*some, *shared) for some in zip(*zipped, strict=True))


def tree_map_sum(
    function: Callable[..., R], field: str, zipped: tuple[Any, ...], shared: tuple[Any, ...]
) -> tuple[tuple[R, ...], Any]:
    """Results of `tree_map`, and the `tree_sum` of one of their fields.

    When compiled, every result is added as soon as it is known: one that is only summed needs no
    storage, and more of the rest fits in the vector registers.
    """
    results = tree_map(function, zipped, shared)
    return results, tree_sum(field_of(results, field))


def fold(
    function: Callable[..., R], start: R, values: tuple[Any, ...], shared: tuple[Any, ...]
) -> R:
    """Left fold, ``function(so_far, value, *shared)`` from a start through all values."""
    result = start
    for value in values:
        result = function(result, value, *shared)
    return result


def field_of(trees: tuple[Any, ...], field: str) -> tuple[Any, ...]:
    """One field of every NamedTuple in a tuple of them."""
    return tuple(getattr(tree, field) for tree in trees)


def one_tuple(tuples: tuple[tuple[T, ...], ...]) -> tuple[T, ...]:
    """The entries of several tuples in one."""
    return tuple(entry for one in tuples for entry in one)


def tree_sum(trees: tuple[T, ...]) -> T:
    """Leaf-by-leaf sum of trees of the same shape."""
    first, *others = trees
    values = leaves(first)
    for other in others:
        values = [a + b for a, b in zip(values, leaves(other), strict=True)]
    return rebuilt(first, values)


def minimum(values: tuple[float, ...]) -> float:
    """Smallest of several floats."""
    smallest = values[0]
    for value in values[1:]:
        smallest = value if value < smallest else smallest
    return smallest


def maximum(values: tuple[float, ...]) -> float:
    """Largest of several floats."""
    greatest = values[0]
    for value in values[1:]:
        greatest = value if value > greatest else greatest
    return greatest


def axpy(x: T, rate: T, h: float) -> T:
    """Leaf-by-leaf x + h · rate."""
    pairs = zip(leaves(x), leaves(rate), strict=True)
    return rebuilt(x, [a + h * b for a, b in pairs])


def axpy_strictly(x: T, rate: T, h: float) -> T:
    """Leaf-by-leaf x + h · rate that propagates NaN and infinity of the rates."""
    return axpy(x, rate, h)


def square(tree: Any) -> float:
    """Sum of the squares of all leaves; NaN or infinite if a leaf is."""
    result = 0.0
    for leaf in leaves(tree):
        result = result + leaf * leaf
    return result


def replace(tree: T, **fields: Any) -> T:
    """A NamedTuple with some of its fields replaced, by name.

    Raises:
        ValueError: If it has no such field; compiled, the compiler's error.
    """
    changed: T = tree._replace(**fields)  # type: ignore[attr-defined]
    return changed


def select(claim: bool, a: T, b: T) -> T:
    """``a`` if the claim holds, else ``b``: a selection, not a branch, in compiled code."""
    return a if claim else b


# -- the same, generated for the compiler from the tree's type ------------------------------------


def leaf_sources(tree: Any, stem: str, lines: list[str]) -> list[str]:
    """Source text of every leaf, after lines that give each branch a name.

    A branch is extracted from its parent once: the compiler copies whatever is extracted, and
    extracting every leaf from the root would copy most of the tree for each.
    """
    texts = []
    for k, branch in enumerate(branches(tree)):
        if isinstance(branch, types.BaseTuple):
            lines.append(f"{stem}_{k} = {stem}[{k}]")
            texts += leaf_sources(branch, f"{stem}_{k}", lines)
        else:
            texts.append(f"{stem}[{k}]")
    return texts


def leaf_count(tree: Any) -> int:
    """Number of leaves."""
    return sum(map(leaf_count, branches(tree))) if isinstance(tree, types.BaseTuple) else 1


def construct(tree: Any, texts: list[str], scope: dict[str, Any]) -> str:
    """Source text that builds a tree of this type from the leaves' texts, consumed in order."""
    if not isinstance(tree, types.BaseTuple):
        return texts.pop(0)
    inner = ", ".join(construct(branch, texts, scope) for branch in branches(tree))
    cls = getattr(tree, "instance_class", None)
    if cls is not None:
        scope[cls.__name__] = cls
        return f"{cls.__name__}({inner})"
    return f"({inner},)" if len(tree) else "()"


def _tuple(texts: list[str]) -> str:
    """Source text of a tuple of several texts, possibly none."""
    return f"({', '.join(texts)},)" if texts else "()"


def function_of(arguments: str, lines: list[str], scope: dict[str, Any]) -> Callable[..., Any]:
    """A function with a generated body; ``scope`` holds the names that it uses."""
    scope["__name__"] = __name__  # a cached kernel looks for the modules of its callees
    body = "\n".join(f"    {line}" for line in lines)
    exec(f"def generated({arguments}):\n{body}\n", scope)
    generated: Callable[..., Any] = scope["generated"]
    return generated


@code_rule(tree_map)
def _each(typing: Any, function: Any, zipped: Any, shared: Any) -> Any:
    return map_code(typing, function, zipped, shared)


@compiler_rule(tree_map_sum, literal=True)
def _map_sum(function: Any, field: Any, zipped: Any, shared: Any) -> Any:
    if not isinstance(field, types.StringLiteral):
        return None
    name, count, lines = field.literal_value, len(zipped[0]), []
    for j in range(count):
        given = [f"zipped[{k}][{j}]" for k in range(len(zipped))]
        given += [f"shared[{k}]" for k in range(len(shared))]
        lines.append(f"r{j} = function({', '.join(given)})")
        lines.append(f"sum{j} = " + (f"total((sum{j - 1}, r{j}.{name}))" if j else f"r0.{name}"))
    lines.append(f"return ({', '.join(f'r{j}' for j in range(count))},), sum{count - 1}")
    return function_of("function, field, zipped, shared", lines, {"total": tree_sum})


@compiler_rule(fold)
def _fold_source(function: Any, start: Any, values: Any, shared: Any) -> Any:
    given = ", ".join(f"shared[{k}]" for k in range(len(shared)))
    lines = ["r = start"]
    lines += [f"r = function(r, values[{k}], {given})" for k in range(len(values))]
    return function_of("function, start, values, shared", [*lines, "return r"], {})


@compiler_rule(field_of, literal=True)
def _column(trees: Any, field: Any) -> Any:
    if not isinstance(field, types.StringLiteral):
        return None
    fields = [f"trees[{j}].{field.literal_value}" for j in range(len(trees))]
    return function_of("trees, field", [f"return {_tuple(fields)}"], {})


@compiler_rule(one_tuple)
def _joined_source(tuples: Any) -> Any:
    lines = [f"t{j} = tuples[{j}]" for j in range(len(tuples))]
    entries = [f"t{j}[{k}]" for j in range(len(tuples)) for k in range(len(tuples[j]))]
    return function_of("tuples", [*lines, f"return {_tuple(entries)}"], {})


@compiler_rule(tree_sum)
def _total(trees: Any) -> Any:
    if not isinstance(trees[0], types.BaseTuple):
        return function_of(
            "trees", [f"return {' + '.join(f'trees[{j}]' for j in range(len(trees)))}"], {}
        )
    lines = [f"t{j} = trees[{j}]" for j in range(len(trees))]
    columns = zip(*(leaf_sources(trees[j], f"t{j}", lines) for j in range(len(trees))), strict=True)
    scope: dict[str, Any] = {}
    text = construct(trees[0], [" + ".join(column) for column in columns], scope)
    return function_of("trees", [*lines, f"return {text}"], scope)


@compiler_rule(replace)
def _replace_fields(tree: Any, **fields: Any) -> Any:
    cls = getattr(tree, "instance_class", None)
    if cls is None or not fields.keys() <= set(cls._fields):
        return None
    parts = [name if name in fields else f"tree.{name}" for name in cls._fields]
    built = f"return {cls.__name__}({', '.join(parts)})"
    # The compiler tells implementations by the types of all arguments, not by their names: those
    # that are left out must count, or one call would get the function of another.
    arguments = ["tree", *(f"{name}=None" for name in cls._fields)]
    return function_of(", ".join(arguments), [built], {cls.__name__: cls})


@compiler_rule(select)
def _pick(claim: Any, a: Any, b: Any) -> Any:
    """Select leaf by leaf: a branch between trees would compile to one between addresses."""
    return lambda claim, a, b: select_tree(a, b, claim)


def _fold(sign: str) -> Callable[[Any], Any]:
    def typed(values: Any) -> Any:
        lines = ["best = values[0]"]
        for k in range(1, len(values)):
            lines.append(f"best = values[{k}] if values[{k}] {sign} best else best")
        return function_of("values", [*lines, "return best"], {})

    return typed


compiler_rule(minimum)(_fold("<"))
compiler_rule(maximum)(_fold(">"))


@compiler_rule(axpy_strictly, GUARDING)
@compiler_rule(axpy)
def _along(x: Any, rate: Any, h: Any) -> Any:
    if {h, *leaf_types(x), *leaf_types(rate)} == {types.float64}:
        return lambda x, rate, h: axpy_tree(x, rate, h)
    lines: list[str] = []
    pairs = zip(leaf_sources(x, "x", lines), leaf_sources(rate, "rate", lines), strict=True)
    scope: dict[str, Any] = {}
    text = construct(x, [f"{a} + h * {b}" for a, b in pairs], scope)
    return function_of("x, rate, h", [*lines, f"return {text}"], scope)


@compiler_rule(square, GUARDING)
def _square(tree: Any) -> Any:
    lines: list[str] = []
    terms = ["0.0", *(f"{leaf} * {leaf}" for leaf in leaf_sources(tree, "tree", lines))]
    return function_of("tree", [*lines, f"return {' + '.join(terms)}"], {})
