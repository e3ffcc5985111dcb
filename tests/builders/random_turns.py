"""Random attitudes, and rotation matrices by another road than the package's."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from springback.kernels.vectors import Quat, Vec


def random_attitudes(count: int, seed: int) -> list[Quat]:
    return [as_quat(r) for r in Rotation.random(count, random_state=np.random.default_rng(seed))]


def as_quat(r: Rotation) -> Quat:
    x, y, z, w = (float(c) for c in r.as_quat())
    return Quat(w, x, y, z)


def as_rotation(q: Quat) -> Rotation:
    return Rotation.from_quat([q.x, q.y, q.z, q.w])


def random_vec(rng: np.random.Generator, size: float) -> Vec:
    return Vec(*(float(c) for c in rng.uniform(-size, size, 3)))
