"""Optional packages, asked for when first needed."""

from __future__ import annotations

import importlib
from typing import Any

from springback.errors import InputError


def needs(module: str, extra: str) -> Any:
    """An optional module.

    Raises:
        InputError: With the command that installs it.
    """
    try:
        return importlib.import_module(module)
    except ImportError:
        raise InputError(
            f"this needs {module}, which is not installed: pip install 'springback[{extra}]'"
        ) from None
