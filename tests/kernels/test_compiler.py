"""What is asked of the compiler reaches it."""

import numpy as np
import pytest
from llvmlite import binding

from springback.kernels.compiler import executor, kernel
from springback.kernels.layout import Buffer, zeros


@kernel
def halved(lanes: Buffer) -> None:
    """All lanes, one after another: what the compiler is to lay abreast."""
    for i in range(np.uint64(len(lanes))):
        lanes[i] = 0.5 * lanes[i]


def test_whole_vector_registers_are_used() -> None:
    if not binding.get_host_cpu_features().get("avx512f"):
        pytest.skip("there are no registers of 512 bits")

    @executor()
    def entry(lanes: Buffer) -> None:
        halved(lanes)

    lanes = zeros(64)
    entry(lanes)
    (assembly,) = entry.inspect_asm().values()
    assert "zmm" in assembly


def test_registers_are_put_aside_within_lines_of_the_cache() -> None:
    @executor()
    def entry(lanes: Buffer) -> None:
        halved(lanes)

    entry(zeros(64))
    (text,) = entry.inspect_llvm().values()
    assert '"stackrealign"' in text
