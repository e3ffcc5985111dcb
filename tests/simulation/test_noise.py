"""Noise: the generator against its authors' answers, and numbers that are normal."""

import math

import numpy as np
import pytest
import scipy.stats

from builders.cases import nonempty
from springback.random_streams import Purpose, stream
from springback.simulation.noise import (
    Block,
    NoiseSource,
    generate,
    noise_table,
    philox,
    plan_of,
    workspace,
)
from springback.simulation.onboard import Draw

DRAWS = (Draw(7, 5), Draw(6, 1), Draw(6, 10), Draw(4, 5), Draw(3, 0))
FULL = 0xFFFFFFFF


def words(*values: int) -> Block:
    return Block(*(np.uint64(value) for value in values))


@pytest.mark.parametrize(
    ("counter", "key", "answer"),
    [
        ((0, 0, 0, 0), (0, 0), (0x6627E8D5, 0xE169C58D, 0xBC57AC4C, 0x9B00DBD8)),
        ((FULL,) * 4, (FULL,) * 2, (0x408F276D, 0x41C83B0E, 0xA20BC7C6, 0x6D5451FD)),
        (
            (0x243F6A88, 0x85A308D3, 0x13198A2E, 0x03707344),
            (0xA4093822, 0x299F31D0),
            (0xD16CFE09, 0x94FDCCEB, 0x5001E420, 0x24126EA1),
        ),
    ],
)
def test_philox_gives_the_known_answers(
    counter: tuple[int, ...], key: tuple[int, int], answer: tuple[int, ...]
) -> None:
    """Those of the authors' Random123 library (kat_vectors, philox4x32, 10 rounds)."""
    low, high = (np.uint64(word) for word in key)
    assert philox(words(*counter), low, high) == words(*answer)


def test_numbers_are_normal_and_independent() -> None:
    table = noise_table(3, 0, 60_000, (Draw(6, 1),))
    for channel in table.T:
        assert scipy.stats.kstest(channel, "norm").pvalue > 1e-3
    together = np.corrcoef(np.vstack([table[:-1].T, table[1:].T])) - np.eye(12)
    assert np.abs(together).max() < 5.0 / math.sqrt(len(table))
    assert np.abs(table).max() == pytest.approx(4.6, abs=0.9)  # of 360 000


def test_any_stretch_for_any_lanes_is_that_of_the_flight_alone() -> None:
    lanes, stretch = 8, 25
    keys = np.arange(5, 5 + lanes, dtype=np.uint64)
    flights = np.arange(lanes, dtype=np.uint64) % 3
    alone = [noise_table(int(k), int(f), 100, DRAWS) for k, f in zip(keys, flights, strict=True)]
    words, drawn = workspace(stretch * lanes)
    for first in (0, 25, 33, 75):
        out = np.zeros((stretch, 26 * lanes))
        generate(NoiseSource(keys, flights, plan_of(DRAWS)), first, out, words, drawn)
        for lane, table in nonempty(enumerate(alone)):
            mine = out.reshape(stretch, 26, lanes)[:, :, lane]
            assert np.array_equal(mine, table[first : first + stretch])


def test_streams_of_all_purposes_are_independent_and_repeat() -> None:
    keys = [
        (seed, purpose, 9, k)
        for seed in (3, 4)
        for purpose in Purpose
        for k in ((0, 1) if purpose is not Purpose.GUST else (0,))
    ]
    drawn = np.array([stream(*key).standard_normal(4000) for key in keys])
    together = np.corrcoef(drawn) - np.eye(len(keys))
    assert len(keys) == 4 * len(Purpose) - 2  # there is one gust before a flight
    assert np.abs(together).max() < 5.0 / math.sqrt(4000)
    assert np.array_equal(drawn, [stream(*key).standard_normal(4000) for key in keys])
