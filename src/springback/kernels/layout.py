"""Trees in flat buffers: number of rows, positions of the parts, reading and writing.

A buffer holds a batch of flights: leaf k of the tree of one lane is at ``(row + k) * width +
lane``.  A `TreeLayout` describes the positions.  It has the type of a tree and none of its numbers,
so that passing it from function to function is free.  It also knows the row at which its tree
begins, so that `load` and `store` reach any branch by name.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numba
import numpy as np
from numba import types
from numba.core.typing import templates

from springback.kernels.compiler import code_rule, compiler_rule, is_named
from springback.kernels.tree_code import Stored, load_code, store_code
from springback.kernels.trees import (
    function_of,
    leaf_count,
    leaves,
    rebuilt,
)

#: numba.extending, with incomplete type stubs.
_numba: Any = numba.extending
_typeof: Any = numba.typeof
_AttributeTemplate: Any = templates.AttributeTemplate

Buffer = np.ndarray[Any, np.dtype[np.float64]]

#: Bytes of a cache line.
_LINE = 64


def zeros(*shape: int) -> Buffer:
    """Zeros, aligned to a cache line: no row of eight lanes straddles two."""
    size = 8 * math.prod(shape)
    raw = np.zeros(size + _LINE, dtype=np.uint8)
    start = -raw.ctypes.data % _LINE
    return raw[start : start + size].view(np.float64).reshape(shape)


def structure(tree: Any) -> Any:
    """The types in a tree, nested alike; equal for trees that differ in numbers only.

    The address of a table is a number to the compiler, whether there is a table or not.
    """
    if not isinstance(tree, tuple):
        return float if isinstance(tree, float) else type(tree)
    inner = [
        float if isinstance(branch, float)
        else structure(branch) if isinstance(branch, tuple) else type(branch)
        for branch in tree
    ]  # fmt: skip
    return (type(tree), *inner)


class TreeLayout:
    """Layout of a tree, without numbers: its parts are reached by name, and are layouts again."""

    __slots__ = ("_parts", "_row", "_tree", "_type")  # underscored, as fields may have these names

    def __init__(self, tree: Any, row: int = 0) -> None:
        """Layout of a tree that begins at some row of a buffer."""
        self._tree = tree
        self._row = row
        self._parts: dict[str, TreeLayout] = {}
        self._type: Any = None

    @property
    def instance_class(self) -> type:
        """Class of the tree, on which generic functions dispatch."""
        return type(self._tree)

    @property
    def _numba_type_(self) -> Any:
        """Type for the compiler."""
        if self._type is None:
            self._type = _like_type(structure(self._tree), self._row, self._tree)
        return self._type

    def __getattr__(self, name: str) -> TreeLayout:
        if name not in self._parts:
            first = self._row + row_of(self._tree, name)
            self._parts[name] = TreeLayout(getattr(self._tree, name), first)
        return self._parts[name]


_LIKE_TYPES: dict[Any, Any] = {}


def _like_type(nested: Any, row: int, tree: Any) -> Any:
    """Compiler type of a structure, cached: typing a large tree takes the compiler long."""
    if (nested, row) not in _LIKE_TYPES:
        _LIKE_TYPES[nested, row] = TreeLayoutType(_typeof(tree), row)
    return _LIKE_TYPES[nested, row]


def rows(like: Any) -> int:
    """Number of floats in a tree, or in a `TreeLayout`."""
    return len(leaves(like._tree if isinstance(like, TreeLayout) else like))


def row_of(like: Any, field: str) -> int:
    """Number of floats before one of the fields of a tree, or of a `TreeLayout`."""
    tree = like._tree if isinstance(like, TreeLayout) else like
    return sum(len(leaves(branch)) for branch in tree[: tree._fields.index(field)])


def read(like: TreeLayout, buffer: Buffer, row: int, width: int, lane: int) -> Any:
    """The tree stored in ``buffer`` from ``row`` on, in the column ``lane`` of ``width``."""
    return rebuilt(like._tree, [buffer[(row + k) * width + lane] for k in range(rows(like))])


def write(tree: Any, buffer: Buffer, row: int, width: int, lane: int) -> None:
    """Store a tree in ``buffer`` from ``row`` on, in the column ``lane`` of ``width``."""
    for k, leaf in enumerate(leaves(tree)):
        buffer[(row + k) * width + lane] = leaf


class SplitBuffer(NamedTuple):
    """A buffer in two pieces: `load` and `store` find the one that holds a tree."""

    like: TreeLayout  # layout of the first
    first: Buffer
    second: Buffer


def load(like: TreeLayout, buffer: Buffer | SplitBuffer, width: int, lane: int) -> Any:
    """The tree in the column ``lane`` of ``width``, at the position given by ``like``."""
    return read(like, *_piece(like, buffer), width, lane)


def store(tree: Any, like: TreeLayout, buffer: Buffer | SplitBuffer, width: int, lane: int) -> None:
    """Store a tree in the column ``lane`` of ``width``, at the position given by ``like``."""
    write(tree, *_piece(like, buffer), width, lane)


def _piece(like: TreeLayout, buffer: Buffer | SplitBuffer) -> tuple[Buffer, int]:
    """The buffer that holds a tree, and its first row there."""
    if not isinstance(buffer, SplitBuffer):
        return buffer, like._row
    before = rows(buffer.like)
    inside = like._row < before
    return (buffer.first, like._row) if inside else (buffer.second, like._row - before)


# -- the same for the compiler --------------------------------------------------------------------


class TreeLayoutType(types.Opaque):
    """Compiler type of a `TreeLayout`."""

    def __init__(self, tree: Any, row: int = 0) -> None:
        """Type of the layout of a tree's type, at a row."""
        self.tree = tree
        self.row = row
        super().__init__(name=f"Like({row}, {tree})")

    @property
    def key(self) -> Any:
        """Key for equality: names alone would confuse classes of the same name."""
        return self.row, self.tree

    @property
    def instance_class(self) -> Any:
        """NamedTuple class of the tree, on which generic functions dispatch."""
        return getattr(self.tree, "instance_class", object)


_numba.register_model(TreeLayoutType)(_numba.models.OpaqueModel)


@_numba.unbox(TreeLayoutType)  # type: ignore[untyped-decorator]
def _unbox(typ: Any, value: Any, c: Any) -> Any:
    return _numba.NativeValue(c.context.get_dummy_value())


@_numba.infer_getattr
class _LikeParts(_AttributeTemplate):  # type: ignore[misc]
    key = TreeLayoutType

    def generic_resolve(self, typ: TreeLayoutType, attr: str) -> Any:
        fields = getattr(typ.tree, "fields", ())
        if attr not in fields:
            return None
        place = fields.index(attr)
        first = typ.row + sum(leaf_count(typ.tree.types[k]) for k in range(place))
        return TreeLayoutType(typ.tree.types[place], first)


@_numba.lower_getattr_generic(TreeLayoutType)  # type: ignore[untyped-decorator]
def _like_part(context: Any, builder: Any, typ: Any, value: Any, attr: str) -> Any:
    return context.get_dummy_value()


def _tree_of(like: Any) -> Any:
    return like.tree if isinstance(like, TreeLayoutType) else like


@compiler_rule(rows)
def _rows(like: Any) -> Any:
    return function_of("like", [f"return {leaf_count(_tree_of(like))}"], {})


@compiler_rule(row_of, literal=True)
def _row_of(like: Any, field: Any) -> Any:
    tree = _tree_of(like)
    place = tree.fields.index(field.literal_value)
    before = sum(leaf_count(tree.types[k]) for k in range(place))
    return function_of("like, field", [f"return {before}"], {})


def _compiled_piece(like: Any, buffer: Any) -> Stored:
    """`_piece` when compiled: a row is known at compile time, and no two rows alias."""
    if not is_named(buffer, SplitBuffer):
        return Stored(like.row, like.row)
    before = leaf_count(buffer.types[0].tree)
    inside = like.row < before
    return Stored(like.row, like.row, 1) if inside else Stored(like.row - before, like.row, 2)


@code_rule(read)
def _read(typing: Any, like: Any, buffer: Any, row: Any, width: Any, lane: Any) -> Any:
    return load_code(like, Stored(None, None), (buffer, row, width, lane))


@code_rule(load)
def _load(typing: Any, like: Any, buffer: Any, width: Any, lane: Any) -> Any:
    return load_code(like, _compiled_piece(like, buffer), (buffer, width, lane))


@code_rule(write)
def _write(typing: Any, tree: Any, buffer: Any, row: Any, width: Any, lane: Any) -> Any:
    return store_code(tree, (), Stored(None, None), (buffer, row, width, lane))


@code_rule(store)
def _store(typing: Any, tree: Any, like: Any, buffer: Any, width: Any, lane: Any) -> Any:
    return store_code(tree, (like,), _compiled_piece(like, buffer), (buffer, width, lane))
