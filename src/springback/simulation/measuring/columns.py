"""Results of flights, read from their buffers as columns: one number for each flight."""

from __future__ import annotations

from typing import Any

import numpy as np

from springback.dynamics.energy import Energy, energy
from springback.kernels.compiler import executor
from springback.kernels.layout import Buffer, TreeLayout, read, rows, write
from springback.kernels.trees import leaves
from springback.simulation.lanes import Shape

Array = np.ndarray[Any, np.dtype[np.float64]]


def tree_from(like: Any, columns: Any) -> Any:
    """A tree of the structure of ``like`` whose leaves are the columns, in order."""
    stream = iter(columns)

    def build(tree: Any) -> Any:
        if not isinstance(tree, tuple):
            return next(stream)
        branches = [build(branch) for branch in tree]
        return type(tree)(*branches) if hasattr(tree, "_fields") else tuple(branches)

    return build(like)


def as_columns(tree: Any) -> Any:
    """The tree of a single flight, with columns of one number as leaves."""
    return tree_from(tree, np.array(leaves(tree), dtype=np.float64)[:, None])


def columns_of(like: Any, buffers: Buffer, row: int, width: int, count: int) -> Any:
    """A tree of columns, read from the buffers of many flights.

    Args:
        like: A tree of the same structure.
        buffers: Shape (groups, rows x width).
        row: First row of the trees; negative from the end.
        width: Lanes in a group.
        count: Number of flights; spare lanes are not read.
    """
    lanes = buffers.reshape(len(buffers), -1, width)
    first = row if row >= 0 else lanes.shape[1] + row
    here = lanes[:, first : first + rows(like)]
    block = here.transpose(1, 0, 2).reshape(rows(like), len(buffers) * width)  # perhaps no rows
    return tree_from(like, np.ascontiguousarray(block[:, :count]))


@executor(nogil=True)
def store_energies(shape: TreeLayout, buffers: Buffer, lanes: tuple[int, ...], out: Buffer) -> None:
    """Write the energies of all flights in some buffers.

    Args:
        shape: Layout of the buffers.
        buffers: Shape (groups, rows x lanes).
        lanes: A tuple as long as a group is wide.
        out: Leaves of `Energy`, shape (groups, rows x lanes); written.
    """
    w, motion = len(lanes), rows(shape.model)
    for group in range(buffers.shape[0]):
        for i in range(w):
            model = read(shape.model, buffers[group], 0, w, i)
            state = read(shape.motion.state, buffers[group], motion, w, i)
            now = energy(model.airframe, model.world, model.contact_point, state)
            write(now, out[group], 0, w, i)


def energies(shape: Shape, buffers: Buffer, width: int, count: int) -> Any:
    """`Energy` of many flights, in columns."""
    like = Energy(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    out = np.zeros((len(buffers), rows(like) * width))
    store_energies(TreeLayout(shape), buffers, (0,) * width, out)
    return columns_of(like, out, 0, width, count)
