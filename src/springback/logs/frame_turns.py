"""Turning other programs' axes into NWU and FLU.

A turn is a rotation matrix: vectors are multiplied by that of their own axes; an attitude R, body
to world, becomes W R Bᵀ.
"""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np

Array = np.ndarray[Any, np.dtype[np.float64]]

#: World axes by name: rows give north, west and up in them.
WORLDS: dict[str, Array] = {
    "nwu": np.eye(3),
    "ned": np.diag([1.0, -1.0, -1.0]),
    "enu": np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]),
    "y-up": np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]]),
    "z-up": np.eye(3),
}
#: Body axes by name: rows give forward, left and up in them.
BODIES: dict[str, Array] = {
    "flu": np.eye(3),
    "frd": np.diag([1.0, -1.0, -1.0]),
    "rfu": np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]),
    "y-up": WORLDS["y-up"],
}


def vectors_in(turn: Array, vectors: Any) -> Array:
    """Vectors, shape (..., 3), in the axes to which a turn leads."""
    return np.asarray(np.asarray(vectors, dtype=float) @ turn.T)


def attitudes_in(world: Array, body: Array, attitudes: Any) -> Array:
    """Quaternions (w, x, y, z), shape (..., 4), between other axes of world and body.

    Each is returned with the sign that is nearest to the one before, so that a sign change of the
    program that wrote it is no jump.
    """
    left, right = matrix_quaternion(world), matrix_quaternion(body)
    turned = product(product(left, np.asarray(attitudes, dtype=float)), right * [1, -1, -1, -1])
    return continuous(turned)


def other_order(world: Array, body: Array, attitudes: Any, order: str) -> Array:
    """Quaternions (w, x, y, z), shape (..., 4), as if their file had the other order.

    Args:
        world: Turn of the world's axes with which they were read.
        body: Turn of the body's axes.
        attitudes: As they were read.
        order: In which they were read, ``wxyz`` or ``xyzw``.
    """
    given = attitudes_in(world.T, body.T, attitudes)
    return attitudes_in(world, body, np.roll(given, 1 if order == "wxyz" else -1, axis=1))


def continuous(attitudes: Array) -> Array:
    """Quaternions, shape (n, 4), with signs that make each nearest to the last one not lost."""
    known = np.flatnonzero(~np.isnan(attitudes).any(axis=1))
    if not len(known):
        return attitudes
    q = attitudes.copy()
    dots = np.einsum("ij,ij->i", q[known[1:]], q[known[:-1]])
    signs = np.cumprod(np.concatenate([[1.0], np.where(dots < 0.0, -1.0, 1.0)]))
    q[known] *= signs[:, None]
    return q if q[known[0], 0] >= 0.0 else np.asarray(-q)


def flags_in(turn: Array, flags: Any) -> Any:
    """Flags of axes, in turned axes: any that a new axis is made of.

    Args:
        turn: Rows are the new axes in the old ones, shape (3, 3).
        flags: Shape (samples, 3).
    """
    return (np.asarray(flags, dtype=float) @ (np.abs(turn) > 0.1).T) > 0.0


def product(a: Any, b: Any) -> Array:
    """Hamilton product of quaternions (w, x, y, z), shapes (..., 4)."""
    aw, ax, ay, az = np.moveaxis(np.asarray(a, dtype=float), -1, 0)
    bw, bx, by, bz = np.moveaxis(np.asarray(b, dtype=float), -1, 0)
    return np.stack(
        [
            aw * bw - ax * bx - ay * by - az * bz,
            aw * bx + ax * bw + ay * bz - az * by,
            aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw,
        ],
        axis=-1,
    )


def conjugate(q: Array) -> Array:
    """Inverse of unit quaternions, shape (..., 4)."""
    return np.asarray(q * [1.0, -1.0, -1.0, -1.0])


def world_vectors(q: Any, vectors: Any) -> Array:
    """Body vectors, shape (..., 3), in the world's axes, by attitudes, shape (..., 4)."""
    q, v = np.asarray(q, dtype=float), np.asarray(vectors, dtype=float)
    w, r = q[..., :1], q[..., 1:]
    inner = 2.0 * np.cross(r, v)
    return np.asarray(v + w * inner + np.cross(r, inner))


def matrix_quaternion(matrix: Array) -> Array:
    """Unit quaternion (w, x, y, z), w at least 0, of a rotation matrix (Shepperd's method)."""
    m = matrix
    trace = float(np.trace(m))
    choices = np.array([trace, m[0, 0], m[1, 1], m[2, 2]])
    k = int(np.argmax(choices))
    if k == 0:
        q = np.array([1.0 + trace, m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]])
    else:
        i = k - 1
        j, n = (i + 1) % 3, (i + 2) % 3
        q = np.empty(4)
        q[0] = m[n, j] - m[j, n]
        q[1 + i] = 1.0 + 2.0 * m[i, i] - trace
        q[1 + j] = m[j, i] + m[i, j]
        q[1 + n] = m[n, i] + m[i, n]
    q /= np.linalg.norm(q)
    return np.asarray(q if q[0] >= 0.0 else -q)


def rotation_vector(q: Any) -> Array:
    """Rotation vectors [rad], at most π long, of unit quaternions, shape (..., 4) to (..., 3)."""
    q = np.asarray(q, dtype=float)
    q = np.where(q[..., :1] < 0.0, -q, q)
    sine = np.linalg.norm(q[..., 1:], axis=-1)
    angle = 2.0 * np.arctan2(sine, q[..., 0])
    with np.errstate(invalid="ignore", divide="ignore"):
        factor = np.where(sine > 1e-9, angle / sine, 2.0)
    return np.asarray(factor[..., None] * q[..., 1:])


def vector_quaternion(vectors: Any) -> Array:
    """Unit quaternions of rotation vectors [rad], shape (..., 3) to (..., 4)."""
    v = np.asarray(vectors, dtype=float)
    angle = np.linalg.norm(v, axis=-1, keepdims=True)
    return np.concatenate([np.cos(0.5 * angle), 0.5 * np.sinc(0.5 * angle / np.pi) * v], axis=-1)


def axis_turns() -> list[Array]:
    """The 24 rotations that exchange axes, the identity first."""
    found = []
    for order in itertools.permutations(range(3)):
        for signs in itertools.product((1.0, -1.0), repeat=3):
            m = np.zeros((3, 3))
            m[range(3), order] = signs
            if np.linalg.det(m) > 0.0:
                found.append(m)
    return sorted(found, key=lambda m: -float(np.trace(m)))


def turn_words(turn: Array) -> str:
    """A turn of axes in words: `x = -y, y = x, z = z`, new axes by the recorded ones."""
    parts = []
    for name, row in zip("xyz", turn, strict=True):
        k = int(np.argmax(np.abs(row)))
        parts.append(f"{name} = {'-' if row[k] < 0.0 else ''}{'xyz'[k]}")
    return ", ".join(parts)
