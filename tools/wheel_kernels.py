"""Part of the build of a wheel that carries compiled kernels; `tools/wheel.py` asks for it."""

from __future__ import annotations

import os
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

#: Environment variables: folder of the kernels by level, and tag of the wheel.
FOLDER, TAG = "SPRINGBACK_WHEEL_KERNELS", "SPRINGBACK_WHEEL_TAG"


class KernelHook(BuildHookInterface):
    """Adds kernels to a wheel, which is then one for a platform and a version of Python."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Add them before the wheel is written."""
        build_data["pure_python"] = False
        build_data["tag"] = os.environ[TAG]
        build_data["force_include"][os.environ[FOLDER]] = "springback/kernels/packaged"
