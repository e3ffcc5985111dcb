"""Machine code for operations on whole trees: one instruction a leaf, made without Python source.

Source text generated leaf by leaf would be parsed, typed and lowered as any other, which takes the
compiler a hundred times as long as to emit these few instructions.  They are the same.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numba
from llvmlite import binding, ir
from numba import types
from numba.core import cgutils

_intrinsic: Any = numba.extending.intrinsic
_item_pointer: Any = cgutils.get_item_pointer
_unliteral: Any = types.unliteral
_tuple_of: Any = types.BaseTuple.from_types
_alloca_once: Any = cgutils.alloca_once


class Rarely(NamedTuple):
    """A part of a memory that is usually returned unchanged.

    Compiled code stores it in a buffer only where it is new: copying it would often cost more than
    the rest of a kernel.
    """

    new: float  # 1 if the tree may differ from the one that was read; 0 only if it does not
    tree: Any


def branches(tree: Any) -> list[Any]:
    """Types of the branches of a tree's type."""
    return [tree.types[k] for k in range(len(tree))]


def leaf_types(tree: Any) -> Iterator[Any]:
    """Types of all leaves of a tree's type, in order."""
    if not isinstance(tree, types.BaseTuple):
        yield tree
        return
    for branch in branches(tree):
        yield from leaf_types(branch)


def tree_of(tree: Any, kinds: Iterator[Any]) -> Any:
    """Type of a tree of the shape of another whose leaves have other types, consumed in order."""
    if not isinstance(tree, types.BaseTuple):
        return next(kinds)
    inner = tuple(tree_of(branch, kinds) for branch in branches(tree))
    return _tuple_of(inner, getattr(tree, "instance_class", None))


def _gather(builder: Any, tree: Any, value: Any) -> Iterator[Any]:
    """All leaves of a tree in order."""
    if not isinstance(tree, types.BaseTuple):
        yield value
        return
    for k, branch in enumerate(branches(tree)):
        yield from _gather(builder, branch, builder.extract_value(value, k))


def _build(context: Any, builder: Any, tree: Any, values: Iterator[Any]) -> Any:
    """A tree of these leaves, consumed in order."""
    if not isinstance(tree, types.BaseTuple):
        return next(values)
    inner = [_build(context, builder, branch, values) for branch in branches(tree)]
    return context.make_tuple(builder, tree, inner)


@functools.cache
def _has_slow_masks() -> bool:
    """True if a masked store is slower than a select and a store: without AVX-512."""
    return not binding.get_host_cpu_features().get("avx512f")


def _freeze(builder: Any, leaf: Any) -> Any:
    """The same number, hidden from the optimiser, which might see that it is already stored.

    Otherwise it makes one masked store out of a select and a store.
    """
    frozen = ir.instructions.Instruction(builder.block, leaf.type, "freeze", (leaf,))
    builder._insert(frozen)  # llvmlite prints this instruction, but has no method for it
    return frozen


class _Rows:
    """Rows of a buffer at one lane."""

    def __init__(
        self, context: Any, builder: Any, kind: Any, buffer: Any, start: Any, step: Any
    ) -> None:
        """Rows of a buffer of a type ``kind``; row k is at element ``start + k · step``."""
        self._context, self._builder, self._kind = context, builder, kind
        self._array = context.make_array(kind)(context, builder, buffer)
        self._start, self._step = start, step

    def pointer(self, row: int) -> Any:
        """Pointer to the element of a row; the index is unsigned."""
        builder = self._builder
        stride = builder.mul(ir.Constant(self._step.type, row), self._step)
        place = builder.add(self._start, stride)
        if self._kind.layout == "C":
            return builder.gep(self._array.data, [place], inbounds=True)
        return _item_pointer(self._context, builder, self._kind, self._array, [place])

    def tag(self, access: Any, row: int) -> Any:
        """Mark a load or store as touching one row only (LLVM: type-based alias analysis)."""
        module = self._builder.module
        root = module.add_metadata([ir.MetaDataString(module, "springback rows")])
        zero = ir.Constant(ir.IntType(64), 0)
        own = module.add_metadata([ir.MetaDataString(module, f"row {row}"), root, zero])
        access.set_metadata("tbaa", module.add_metadata([own, own, zero]))
        return access


def _stored(buffer: Any, mark: int | None) -> Any:
    """Type of the numbers in a buffer; those of marked rows are float64, also on a GPU."""
    return buffer.dtype if mark is None else types.float64


class Stored(NamedTuple):
    """Where a tree is in a buffer, as the compiler knows it."""

    row: int | None  # of the first leaf; None if it is an argument
    mark: int | None  # row that it is known by, if all rows of its buffer are known
    piece: int | None = None  # of a tuple of buffers


def _rows_of(
    context: Any, builder: Any, stored: Stored, kinds: tuple[Any, ...], given: Any
) -> _Rows:
    """Rows of a buffer from the arguments buffer, (row,) width and lane.

    Indices are unsigned, so that the compiler need not check for one that counts from the end.  A
    single flight is in lane 0, which the compiler cannot see in a loop that may have no iteration.
    """
    kind, buffer, (*before, width, lane) = kinds[0], given[0], given[1:]
    if stored.piece is not None:
        kind, buffer = kind.types[stored.piece], builder.extract_value(buffer, stored.piece)
    wide, one, none = types.uint64, *(ir.Constant(ir.IntType(64), k) for k in (1, 0))
    *before, step, start = (
        context.cast(builder, value, _unliteral(kind), wide)
        for value, kind in zip((*before, width, lane), kinds[1:], strict=True)
    )
    start = builder.select(builder.icmp_unsigned("==", step, one), none, start)
    if before:
        start = builder.add(builder.mul(before[0], step), start)
    return _Rows(context, builder, kind, buffer, start, step)


def load_code(like: Any, stored: Stored, kinds: tuple[Any, ...]) -> Any:
    """Signature and code of loading a tree: arguments like, buffer, (row,) width and lane.

    Args:
        like: Layout of the tree.
        stored: Where it is.
        kinds: Types of the arguments after ``like``.
    """
    count = sum(1 for _ in leaf_types(like.tree))
    buffer = kinds[0] if stored.piece is None else kinds[0].types[stored.piece]
    first, known = stored.row or 0, stored.mark
    result = tree_of(like.tree, iter([_stored(buffer, known)] * count))

    def lower(context: Any, builder: Any, signature: Any, given: Any) -> Any:
        places = _rows_of(context, builder, stored, kinds, given[1:])

        def leaf(k: int) -> Any:
            value = builder.load(places.pointer(first + k))
            return value if known is None else places.tag(value, known + k)

        # By way of the stack, which the optimiser takes apart leaf by leaf: of two trees that are
        # read, one would be chosen as a whole, and a loop over lanes that does so not vectorised.
        value = _build(context, builder, result, map(leaf, range(count)))
        place = _alloca_once(builder, value.type)
        builder.store(value, place)
        return builder.load(place)

    return result(like, *kinds), lower


def store_code(tree: Any, like: tuple[Any, ...], stored: Stored, kinds: tuple[Any, ...]) -> Any:
    """Signature and code of storing a tree: arguments tree, (like,) buffer, (row,) width and lane.

    A `Rarely` is stored only where it is new.

    Args:
        tree: Its type.
        like: Its layout, if that is an argument.
        stored: Where it will be.
        kinds: Types of the arguments from the buffer on.
    """
    first, known = stored.row or 0, stored.mark
    buffer = kinds[0] if stored.piece is None else kinds[0].types[stored.piece]

    def lower(context: Any, builder: Any, signature: Any, given: Any) -> Any:
        places = _rows_of(context, builder, stored, kinds, given[1 + len(like) :])

        def put(value: Any, kind: Any, k: int) -> None:
            leaf = context.cast(builder, value, _unliteral(kind), _stored(buffer, known))
            pointer = places.pointer(first + k)
            if known is None:
                builder.store(leaf, pointer)
            else:
                leaf = _freeze(builder, leaf) if _has_slow_masks() else leaf
                places.tag(builder.store(leaf, pointer), known + k)

        def lay(branch: Any, value: Any, k: int) -> int:
            if not isinstance(branch, types.BaseTuple):
                put(value, branch, k)
                return k + 1
            inner = [builder.extract_value(value, n) for n in range(len(branch))]
            if getattr(branch, "instance_class", None) is not Rarely:
                for kind, part in zip(branches(branch), inner, strict=True):
                    k = lay(kind, part, k)
                return k
            rare = branches(branch)
            k = lay(rare[0], inner[0], k)
            half = ir.Constant(inner[0].type, 0.5)
            with builder.if_then(builder.fcmp_ordered(">", inner[0], half)):
                return lay(rare[1], inner[1], k)

        lay(signature.args[0], given[0], 0)
        return context.get_dummy_value()

    return types.void(tree, *like, *kinds), lower


def _implementation(context: Any, function: Any, given: Any, signature: Any) -> Any:
    """Code of calling a function, for the target of a context.

    The compiler remembers of a function and its types the implementation for one target, that of
    which it was last asked: it is asked again after another one, such as a GPU.

    Args:
        context: Of the target.
        function: Type of the function.
        given: Types of the arguments.
        signature: As resolved for them.
    """
    if function.get_impl_key(signature) not in context._defns:
        context.typing_context.resolve_function_type(function, given, {})
    return context.get_function(function, signature)


def map_code(typing: Any, function: Any, zipped: Any, shared: Any) -> Any:
    """Signature and code of calling a function for every position of several tuples.

    Args:
        typing: The compiler's typing context.
        function: Type of the function.
        zipped: Type of a tuple of tuples of the same length.
        shared: Type of the tuple of the arguments after those.
    """
    others, rows = branches(shared), list(zip(*map(branches, branches(zipped)), strict=True))
    kinds = [(*row, *others) for row in rows]
    called = [typing.resolve_function_type(function, one, {}) for one in kinds]
    if any(one is None for one in called):
        return None
    result = _tuple_of(tuple(one.return_type for one in called))

    def lower(context: Any, builder: Any, signature: Any, given: Any) -> Any:
        columns = [builder.extract_value(given[1], k) for k in range(len(zipped))]
        last = [builder.extract_value(given[2], k) for k in range(len(shared))]

        def value(k: int) -> Any:
            row = [*(builder.extract_value(column, k) for column in columns), *last]
            wanted = called[k].args
            cast = [
                context.cast(builder, x, a, b)
                for x, a, b in zip(row, kinds[k], wanted, strict=True)
            ]
            return _implementation(context, function, kinds[k], called[k])(builder, cast)

        return context.make_tuple(builder, result, [value(k) for k in range(len(called))])

    return result(function, zipped, shared), lower


def _leafwise(
    trees: tuple[Any, ...], others: tuple[Any, ...], kinds: list[Any], emit: Callable[..., Any]
) -> Any:
    """Signature and code of an operation on each leaf of some trees.

    Args:
        trees: Their types; the first gives the shape.
        others: Types of the arguments after the trees.
        kinds: Types of the leaves of the result, to which those of the trees are cast.
        emit: Gives an instruction for a leaf: builder, leaves, other arguments.
    """
    result = tree_of(trees[0], iter(kinds))

    def lower(context: Any, builder: Any, signature: Any, given: Any) -> Any:
        columns = []
        for tree, value in zip(trees, given, strict=False):
            found = zip(_gather(builder, tree, value), leaf_types(tree), kinds, strict=True)
            columns.append([context.cast(builder, x, _unliteral(a), b) for x, a, b in found])
        last = given[len(trees) :]
        values = (emit(context, builder, row, last) for row in zip(*columns, strict=True))
        return _build(context, builder, result, values)

    return result(*trees, *others), lower


@_intrinsic  # type: ignore[untyped-decorator]
def select_tree(typing_context: Any, a: Any, b: Any, claim: Any) -> Any:
    """Leaf by leaf a where a claim holds, else b."""
    pairs = zip(leaf_types(a), leaf_types(b), strict=True)
    kinds = [typing_context.unify_types(*map(_unliteral, pair)) for pair in pairs]

    def choose(context: Any, builder: Any, row: Any, last: Any) -> Any:
        known = context.cast(builder, last[0], _unliteral(claim), types.boolean)
        return builder.select(known, *row)

    return _leafwise((a, b), (claim,), kinds, choose)


@_intrinsic  # type: ignore[untyped-decorator]
def axpy_tree(typing_context: Any, x: Any, rate: Any, h: Any) -> Any:
    """Leaf by leaf x + h · rate, of float64."""

    def along(context: Any, builder: Any, row: Any, last: Any) -> Any:
        return builder.fadd(row[0], builder.fmul(last[0], row[1]))

    kinds = [types.float64 for _ in leaf_types(x)]
    return _leafwise((x, rate), (h,), kinds, along)
