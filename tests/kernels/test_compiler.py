"""What is asked of the compiler reaches it."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from builders.missing import needs
from springback.kernels.compiler import kernel, source_digest, user_executor
from springback.kernels.layout import Buffer, zeros


@kernel
def halved(lanes: Buffer) -> None:
    """All lanes, one after another: the loop that the compiler is to vectorise."""
    for i in range(np.uint64(len(lanes))):
        lanes[i] = 0.5 * lanes[i]


def entry(lanes: Buffer) -> None:
    halved(lanes)


@pytest.fixture(scope="module")
def compiled_entry() -> Any:
    compiled = user_executor(entry, None)  # not kept, so that it can be looked into
    compiled(zeros(64))
    return compiled


@needs("AVX-512")
def test_whole_vector_registers_are_used(compiled_entry: Any) -> None:
    (assembly,) = compiled_entry.inspect_asm().values()
    assert "zmm" in assembly


def test_the_stack_begins_with_a_line_of_the_cache(compiled_entry: Any) -> None:
    (text,) = compiled_entry.inspect_llvm().values()
    assert '"stackrealign"' in text


def test_kernels_are_compiled_anew_after_an_edit_in_any_room(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Rooms within rooms, too: their filters and ways of recovery are compiled with the rest."""
    read: list[str] = []
    monkeypatch.setattr(Path, "read_bytes", lambda path: read.append(path.parent.name) or b"")
    source_digest.__wrapped__()
    assert {"springback", "kernels", "contact", "sensing", "kalman", "gpu"} <= set(read)
