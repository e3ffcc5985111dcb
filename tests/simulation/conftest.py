"""Studies are not part of the package; some tests fly their draws."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[2]))
