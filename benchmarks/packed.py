"""Are the lane loops packed?  Floating-point instructions of the compiled executor, counted.

``python -m benchmarks.packed [WIDTH]`` compiles without a cache: machine code that comes from
one cannot be looked at.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tempfile
from typing import NamedTuple

_ARITHMETIC = re.compile(r"\s+v?(?:add|sub|mul|div|sqrt|max|min|fn?m\w+?)(?:\d{3})?(pd|sd)\s")
_LABEL = re.compile(r"(\.?L\w+):")
_JUMP = re.compile(r"\s+j\w+\s+(\.?L\w+)\s*$")


class Loop(NamedTuple):
    """A loop of the machine code that does arithmetic and holds no other such loop."""

    packed: int
    scalar: int


def loops(assembly: str, *, least: int = 100) -> list[Loop]:
    """Innermost loops with at least ``least`` floating-point instructions, in order."""
    lines = assembly.split("\n")
    labels = {m.group(1): k for k, line in enumerate(lines) if (m := _LABEL.match(line))}
    found: dict[tuple[int, int], Loop] = {}
    for end, line in enumerate(lines):
        jump = _JUMP.match(line)
        begin = labels.get(jump.group(1)) if jump else None
        if begin is None or begin >= end:
            continue
        kinds = [m.group(1) for text in lines[begin:end] if (m := _ARITHMETIC.match(text))]
        if len(kinds) >= least:
            found[begin, end] = Loop(kinds.count("pd"), kinds.count("sd"))
    return [
        loop
        for (a, b), loop in sorted(found.items())
        if not any((c, d) != (a, b) and a <= c and d <= b for c, d in found)
    ]


def total(assembly: str) -> Loop:
    """All floating-point instructions of the machine code."""
    kinds = _ARITHMETIC.findall(assembly)
    return Loop(kinds.count("pd"), kinds.count("sd"))


def _print_counts(width: int) -> None:
    from benchmarks.job import Lanes, reference_model, starts
    from springback.simulation.executor import advance

    model = reference_model(until=1e-3)
    Lanes(model, starts(model, width), width).run(1)
    (assembly,) = advance.inspect_asm().values()  # type: ignore[attr-defined]
    print(json.dumps({"total": total(assembly), "loops": loops(assembly)}))


def counts(width: int) -> tuple[Loop, list[Loop]]:
    """Counts for lanes of some width, from a fresh process: all code, and its innermost loops."""
    with tempfile.TemporaryDirectory() as folder:
        said = subprocess.run(
            [sys.executable, "-m", "benchmarks.packed", str(width)],
            env={**os.environ, "SPRINGBACK_CACHE_DIR": folder},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
    known = json.loads(said.splitlines()[-1])
    return Loop(*known["total"]), [Loop(*loop) for loop in known["loops"]]


if __name__ == "__main__":
    _print_counts(int(sys.argv[1]) if len(sys.argv) > 1 else 8)
