"""The benchmarks stand beside the package, and their programs import each other by name alone."""

from __future__ import annotations

import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
sys.path[:0] = [str(ROOT), str(ROOT / "benchmarks/rivals/programs")]
