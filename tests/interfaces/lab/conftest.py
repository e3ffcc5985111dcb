"""What tests of the lab begin with."""

from pathlib import Path

import pytest

from interfaces.lab.user_files import FILE, VEHICLE


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "own.toml"
    path.write_text(FILE + VEHICLE, encoding="utf-8")
    return path
