"""What several tests of dynamics begin with."""

from __future__ import annotations

import importlib
from types import ModuleType

import pytest


@pytest.fixture(scope="module")
def engines() -> ModuleType:
    """MuJoCo and Pinocchio, only where they are."""
    pytest.importorskip("pinocchio")
    pytest.importorskip("mujoco")
    return importlib.import_module("oracles.joint_engines")
