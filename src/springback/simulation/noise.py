"""Noise: the normal numbers of a flight, a pure function of seed, flight, tick and channel.

Philox4x32-10 (Salmon, Moraes, Dror, Shaw: Parallel random numbers: as easy as 1, 2, 3, SC 2011)
turns a counter and a key into four words, and the method of Box and Muller (Annals of Mathematical
Statistics 29, 1958) turns two words into two normal numbers.  There is no sequence to keep: any
ticks of any flight can be drawn by themselves, and many flights side by side in lanes.

All other random numbers, drawn once for a flight, a trial or a plan, come from
`springback.random_streams.stream`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.kernels.angles import sine_cosine
from springback.kernels.compiler import executor, kernel
from springback.kernels.exponentials import logarithm
from springback.kernels.layout import Buffer, zeros
from springback.simulation.onboard import Draw

Words = np.ndarray[Any, np.dtype[np.uint64]]

#: Multipliers and increments of the key of Philox4x32, and its rounds.
_M0, _M1 = np.uint64(0xD2511F53), np.uint64(0xCD9E8D57)
_K0, _K1 = np.uint64(0x9E3779B9), np.uint64(0xBB67AE85)
ROUNDS = 10
_LOW, _HALF = np.uint64(0xFFFFFFFF), np.uint64(32)
#: Scale from a word to the unit interval.
_PART = 2.0**-32
#: Streams for each channel; the blocks of four of a device take those of its first channel.
STREAMS = 16


class Block(NamedTuple):
    """Four words of 32 bits."""

    a: Any
    b: Any
    c: Any
    d: Any


class Normals(NamedTuple):
    """Two independent standard normal numbers."""

    first: float
    second: float


@kernel
def philox(counter: Block, low: Any, high: Any) -> Block:
    """Philox4x32-10.

    Args:
        counter: Words, as 64-bit numbers below 2³².
        low: Lower word of the key.
        high: Its upper word.
    """
    a, b, c, d = counter.a, counter.b, counter.c, counter.d
    for _ in range(ROUNDS):
        p, q = _M0 * a, _M1 * c
        a, b, c, d = (q >> _HALF) ^ b ^ low, q & _LOW, (p >> _HALF) ^ d ^ high, p & _LOW
        low, high = (low + _K0) & _LOW, (high + _K1) & _LOW
    return Block(a, b, c, d)


@kernel
def normals(word: Any, other: Any) -> Normals:
    """√(−2 ln u) (cos 2πv, sin 2πv) with u = (word + 1) 2⁻³² and v = other 2⁻³²."""
    size = math.sqrt(-2.0 * logarithm((1.0 * word + 1.0) * _PART))
    turn = sine_cosine(2.0 * math.pi * _PART * other)
    return Normals(size * turn.cosine, size * turn.sine)


@kernel
def fill_words(n: int, keys: Words, flights: Words, ticks: Words, stream: Any, words: Any) -> None:
    """Write four words each for n keys, flights and ticks of one stream."""
    a, b, c, d = words
    for i in range(np.uint64(n)):  # never below zero, so the compiler need not ask
        key, flight = keys[i], flights[i]
        counter = Block(ticks[i] & _LOW, stream & _LOW, flight & _LOW, flight >> _HALF)
        drawn = philox(counter, key & _LOW, key >> _HALF)
        a[i], b[i], c[i], d[i] = drawn.a, drawn.b, drawn.c, drawn.d


@kernel
def fill_normals(n: int, a: Words, b: Words, first: Buffer, second: Buffer) -> None:
    """Write two normal numbers for every two words."""
    for i in range(np.uint64(n)):
        two = normals(a[i], b[i])
        second[i] = two.second
        first[i] = two.first


@kernel
def place_channel(
    out: Buffer, channel: int, w: int, begins: int, every: int, times: int, drawn: Buffer
) -> None:
    """Write the numbers of one channel, tick by tick and lane by lane, to their places."""
    lanes, place = np.uint64(w), np.uint64(channel * w)
    for k in range(np.uint64(times)):
        row = out[np.uint64(begins) + k * np.uint64(every)]
        for i in range(lanes):
            row[place + i] = drawn[k * lanes + i]


class NoiseSource(NamedTuple):
    """Keys of the normal numbers of some flights."""

    keys: Any  # seed of each lane, shape ([groups,] lanes), unsigned
    flights: Any  # number of each lane's flight, likewise
    plan: Any  # of `plan_of`


@executor(nogil=True)
def generate(source: NoiseSource, first: int, out: Buffer, words: Words, drawn: Buffer) -> None:
    """Generate the normal numbers of a group of flights over some ticks.

    Args:
        source: Of the group.
        first: Number of the first tick.
        out: Shape (ticks, channels x lanes), channel by channel, lane by lane.  Numbers that are
            not drawn at a tick are left as they are.
        words: Workspace, shape (7, ticks x lanes).
        drawn: Workspace, shape (2, ticks x lanes).
    """
    keys, flights, draws = source
    w, ticks = len(keys), out.shape[0]
    key, flight, tick = words[4], words[5], words[6]
    four, one, other = (words[0], words[1], words[2], words[3]), drawn[0], drawn[1]
    for device in range(draws.shape[0]):
        channel, count, every = draws[device, 0], draws[device, 1], draws[device, 2]
        begins = -first % max(every, 1)
        times = (ticks - begins + every - 1) // every if every > 0 and begins < ticks else 0
        for k in range(times):
            now = np.uint64(first + begins + k * every)
            for i in range(w):
                key[k * w + i], flight[k * w + i], tick[k * w + i] = keys[i], flights[i], now
        end, n = channel + count, times * w
        for block in range((count + 3) // 4):
            fill_words(n, key, flight, tick, np.uint64(STREAMS * channel + block), four)
            for pair in range(2):
                at = channel + 4 * block + 2 * pair
                if at < end:
                    fill_normals(n, words[2 * pair], words[2 * pair + 1], one, other)
                    place_channel(out, at, w, begins, every, times, one)
                if at + 1 < end:
                    place_channel(out, at + 1, w, begins, every, times, other)


def plan_of(draws: Sequence[Draw]) -> Any:
    """First channel, number of channels and period of each device, shape (devices, 3), int64.

    The period is in ticks; a device of period 0 draws nothing.
    """
    first, lines = 0, []
    for channels, every in draws:
        lines.append((first, channels, every))
        first += channels
    return np.array(lines, dtype=np.int64)


def key_of(seed: int) -> int:
    """A seed as 64 bits; NumPy's SeedSequence hashes larger ones."""
    if seed < 2**64:
        return seed
    return int(np.random.SeedSequence(seed).generate_state(1, np.uint64)[0])


def noise_table(seed: int, flight: int, ticks: int, draws: tuple[Draw, ...]) -> Buffer:
    """Standard normal numbers of one flight, shape (ticks, channels); zeros where none are drawn.

    They depend only on the seed, the number of the flight and the period of each device.  So
    flight 17 of a campaign has the same noise when flown by itself, and a device the same when
    another device is replaced.

    Args:
        seed: Of a campaign, or of a flight flown alone.
        flight: Its number in the campaign.
        ticks: Number of ticks of the flight.
        draws: Of each device, in the order of their channels.
    """
    table = np.zeros((ticks, sum(draw.channels for draw in draws)))
    keys, numbers = (np.array([k], dtype=np.uint64) for k in (key_of(seed), flight))
    words, drawn = workspace(min(ticks, STRETCH))
    source = NoiseSource(keys, numbers, plan_of(draws))
    for first in range(0, ticks, STRETCH):
        generate(source, first, table[first : first + STRETCH], words, drawn)
    return table


#: Ticks of a single flight that are drawn at once (chosen: they fit the cache).
STRETCH = 512


def workspace(numbers: int) -> tuple[Words, Buffer]:
    """Workspace of `generate`, for a number of ticks times lanes."""
    return zeros(7, numbers).view(np.uint64), zeros(2, numbers)


class NoiseStream(NamedTuple):
    """Normal numbers of some groups of flights: those in memory, and the source of more."""

    source: NoiseSource
    noise: Any  # in memory, shape (groups, ticks, channels x lanes)
    words: Words  # workspace
    drawn: Buffer  # workspace


def stored_stream(noise: Buffer) -> NoiseStream:
    """Stream of a single flight with all numbers in memory, shape (ticks, channels)."""
    none = np.zeros((1, 1), dtype=np.uint64)
    source = NoiseSource(none, none, np.zeros((0, 3), dtype=np.int64))
    return NoiseStream(source, np.ascontiguousarray(noise)[None], *workspace(0))


class FlightNoise(NamedTuple):
    """Noise of some flights: devices that draw numbers, and seed and number of each flight."""

    draws: Sequence[Draw]
    seeds: Sequence[int]
    flights: Sequence[int]  # their numbers in a campaign

    def part(self, flights: slice) -> FlightNoise:
        """Noise of some of these flights."""
        return FlightNoise(self.draws, self.seeds[flights], self.flights[flights])

    def source(self, count: int) -> NoiseSource:
        """Source for a number of lanes; spare ones draw the noise of the last flight."""
        keys = [key_of(seed) for seed in self.seeds]
        spare = count - len(keys)
        numbers = [*self.flights, *[self.flights[-1]] * spare]
        return NoiseSource(
            np.array(keys + keys[-1:] * spare, dtype=np.uint64),
            np.array(numbers, dtype=np.uint64),
            plan_of(self.draws),
        )


def drawn_stream(noise: FlightNoise, width: int, stretch: int) -> NoiseStream:
    """Stream of some groups that draws its numbers some ticks at a time.

    Args:
        noise: Of the flights.
        width: Lanes of a group.
        stretch: Number of ticks in memory.
    """
    shape = -(-len(noise.seeds) // width), width
    keys, flights, plan = noise.source(shape[0] * width)
    source = NoiseSource(keys.reshape(shape), flights.reshape(shape), plan)
    channels = sum(draw.channels for draw in noise.draws)
    table = zeros(shape[0], stretch, channels * width)
    return NoiseStream(source, table, *workspace(stretch * width))
