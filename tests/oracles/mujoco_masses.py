"""Masses of models as MuJoCo has them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import mujoco
import numpy as np
import pytest

from springback.vehicle.mass.parts import MassOfParts


def by_mujoco(
    text: str, names: Sequence[str], assets: Mapping[str, bytes] | None = None
) -> MassOfParts:
    """Bodies where MuJoCo has them at the start, added by Steiner's theorem, in the first's axes."""
    model = mujoco.MjModel.from_xml_string(text, dict(assets or {}))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    at = [mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, name) for name in names]
    mass = sum(model.body_mass[k] for k in at)
    middle = sum(model.body_mass[k] * data.xipos[k] for k in at) / mass
    whole = np.zeros((3, 3))
    for k in at:
        turn, away = data.ximat[k].reshape(3, 3), data.xipos[k] - middle
        whole += turn @ np.diag(model.body_inertia[k]) @ turn.T
        whole += model.body_mass[k] * (away @ away * np.eye(3) - np.outer(away, away))
    axes = data.xmat[at[0]].reshape(3, 3)
    centre = axes.T @ (middle - data.xpos[at[0]])
    return MassOfParts(float(mass), tuple(centre), tuple(map(tuple, axes.T @ whole @ axes)))


def is_same(found: MassOfParts, expected: MassOfParts) -> bool:
    assert found.mass == pytest.approx(expected.mass, rel=1e-12)
    assert found.centre == pytest.approx(expected.centre, abs=1e-12)
    assert np.array(found.inertia) == pytest.approx(np.array(expected.inertia), abs=1e-9)
    return True
