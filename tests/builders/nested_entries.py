"""An entry point that calls another one, for tests of the compiler."""

from __future__ import annotations

from springback.kernels.compiler import executor


@executor()
def tripled(x: float) -> float:
    """Three times a number."""
    return 3.0 * x


@executor()
def tripled_and_one(x: float) -> float:
    """Three times a number, and one."""
    return tripled(x) + 1.0


def only_tripled(x: float) -> None:
    """The part of `tripled_and_one` that another process may compile."""
    tripled(x)
