"""Luck: the normal numbers of a flight, a pure function of seed, flight, tick and channel.

Philox4x32-10 (Salmon, Moraes, Dror, Shaw: Parallel random numbers: as easy as 1, 2, 3, SC 2011)
turns a counter and a key into four words, and Box and Muller (Annals of Mathematical Statistics 29,
1958) turn two words into two normal numbers.  Nothing is stored and nothing drawn in order: any
stretch of any flight's luck can be dealt alone, and that of many flights abreast.

All other random numbers come from `stream`: what is drawn once for a flight, a trial or a plan.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from enum import IntEnum
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
#: A word as a part of one.
_PART = 2.0**-32
#: Streams of a flight beside those of its devices, which are numbered by their channels.
STREAMS = 16


class Purpose(IntEnum):
    """What random numbers that are drawn once are for; part of the key of each stream."""

    POINTS = 0
    """Of a random design."""
    JITTER = 1
    """Of the points of a Latin hypercube within their layers."""
    SCRAMBLE = 2
    """Of a Sobol' sequence."""
    SEEDS = 3
    """Of a campaign's flights."""
    SCATTER = 4
    """Of a campaign's flights."""
    DRAWN = 5
    """Values of fields that a grid has no levels of."""
    SHUFFLE = 6
    """Of the layers of a Latin hypercube."""
    TURN_ON = 7
    """Biases of a flight's sensors."""
    GUST = 8
    """Of the wind before a flight's first tick."""
    TRIAL = 9
    """Scatter and seed of a trial."""


def stream(seed: int, purpose: Purpose, *which: int) -> np.random.Generator:
    """Random numbers of one purpose, independent of all others.

    Generator and key of each purpose are those with which published results were flown.

    Args:
        seed: Of a flight, of trials or of a plan.
        purpose: What they are for.
        *which: Which of that purpose: the number of a flight, a repeat, a dimension.
    """
    kind: Any = np.random.Philox
    key: tuple[int, ...] = (purpose, *which)
    if purpose is Purpose.TURN_ON:
        kind, key = np.random.SFC64, (*which, 2)
    elif purpose is Purpose.GUST:
        kind, key = np.random.SFC64, (0, 1)
    elif purpose is Purpose.TRIAL:
        kind, key = np.random.PCG64, which
    elif purpose in (Purpose.SCRAMBLE, Purpose.SHUFFLE):
        kind = np.random.PCG64
    return np.random.Generator(kind(np.random.SeedSequence(seed, spawn_key=key)))


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
def shuffle(n: int, keys: Words, flights: Words, ticks: Words, stream: Any, words: Any) -> None:
    """Four words each for n keys, flights and ticks in one stream."""
    a, b, c, d = words
    for i in range(np.uint64(n)):  # never below zero, so the compiler need not ask
        key, flight = keys[i], flights[i]
        counter = Block(ticks[i] & _LOW, stream & _LOW, flight & _LOW, flight >> _HALF)
        drawn = philox(counter, key & _LOW, key >> _HALF)
        a[i], b[i], c[i], d[i] = drawn.a, drawn.b, drawn.c, drawn.d


@kernel
def pair_up(n: int, a: Words, b: Words, first: Buffer, second: Buffer) -> None:
    """Two normal numbers of every two words."""
    for i in range(np.uint64(n)):
        two = normals(a[i], b[i])
        second[i] = two.second
        first[i] = two.first


@kernel
def sort_in(
    out: Buffer, channel: int, w: int, begins: int, every: int, times: int, drawn: Buffer
) -> None:
    """Lay the numbers of one channel, tick by tick, lane by lane, where they belong."""
    lanes, place = np.uint64(w), np.uint64(channel * w)
    for k in range(np.uint64(times)):
        row = out[np.uint64(begins) + k * np.uint64(every)]
        for i in range(lanes):
            row[place + i] = drawn[k * lanes + i]


@executor(nogil=True)
def generate(
    keys: Words, flights: Words, draws: Any, first: int, out: Buffer, words: Words, drawn: Buffer
) -> None:
    """Normal numbers of a group of flights over some ticks.

    Args:
        keys: Seed of every lane, shape (lanes,).
        flights: Number of every lane's flight, shape (lanes,).
        draws: First channel, number of channels and period [ticks] of every device, shape
            (devices, 3); period 0 draws nothing.
        first: Number of the first tick.
        out: Shape (ticks, channels x lanes), channel by channel, lane by lane.  What is not drawn
            at a tick is left as it is.
        words: To work in, shape (7, ticks x lanes).
        drawn: To work in, shape (2, ticks x lanes).
    """
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
            shuffle(n, key, flight, tick, np.uint64(STREAMS * channel + block), four)
            for pair in range(2):
                at = channel + 4 * block + 2 * pair
                if at < end:
                    pair_up(n, words[2 * pair], words[2 * pair + 1], one, other)
                    sort_in(out, at, w, begins, every, times, one)
                if at + 1 < end:
                    sort_in(out, at + 1, w, begins, every, times, other)


def plan_of(draws: Sequence[Draw]) -> Any:
    """First channel, number of channels and period of every device, shape (devices, 3), int64."""
    first, lines = 0, []
    for channels, every in draws:
        lines.append((first, channels, every))
        first += channels
    return np.array(lines, dtype=np.int64)


def key_of(seed: int) -> int:
    """A seed as 64 bits; larger ones are hashed by NumPy's SeedSequence."""
    if seed < 2**64:
        return seed
    return int(np.random.SeedSequence(seed).generate_state(1, np.uint64)[0])


def noise_table(seed: int, flight: int, ticks: int, draws: tuple[Draw, ...]) -> Buffer:
    """Standard normal numbers of one flight, shape (ticks, channels); zeros where none are taken.

    They depend on the seed, the number of the flight and the pace of each device alone.  So flight
    17 of a campaign meets the same luck when flown by itself, and a device the same when another
    one is exchanged.

    Args:
        seed: Of a campaign, or of a flight flown alone.
        flight: Its number in the campaign.
        ticks: Of the clock.
        draws: Of every device, in the order of their channels.
    """
    table = np.zeros((ticks, sum(draw.channels for draw in draws)))
    keys, numbers = (np.array([k], dtype=np.uint64) for k in (key_of(seed), flight))
    words, drawn = workplace(min(ticks, STRETCH))
    plan = plan_of(draws)
    for first in range(0, ticks, STRETCH):
        generate(keys, numbers, plan, first, table[first : first + STRETCH], words, drawn)
    return table


#: Ticks of a single flight that are dealt at once (chosen: they fit the cache).
STRETCH = 512


def workplace(numbers: int) -> tuple[Words, Buffer]:
    """Memory that `generate` works in, for a number of ticks times lanes."""
    return zeros(7, numbers).view(np.uint64), zeros(2, numbers)


class NoiseStream(NamedTuple):
    """Normal numbers for some groups of flights: at hand, and how to come by more."""

    keys: Words  # seeds, shape (groups, lanes)
    flights: Words  # their numbers, likewise
    plan: Any  # of `plan_of`
    noise: Any  # at hand, shape (groups, ticks, channels x lanes)
    words: Words  # to work in
    drawn: Buffer  # to work in


def pregenerated(noise: Buffer) -> NoiseStream:
    """Of a single flight, all numbers from its first tick to its last, shape (ticks, channels)."""
    words, drawn = workplace(0)
    none = np.zeros((1, 1), dtype=np.uint64)
    plan = np.zeros((0, 3), dtype=np.int64)
    return NoiseStream(none, none, plan, np.ascontiguousarray(noise)[None], words, drawn)


def on_the_fly(
    seeds: Sequence[int], flights: Sequence[int], draws: Sequence[Draw], width: int, stretch: int
) -> NoiseStream:
    """Of some groups, a stretch after the other; spare lanes share the luck of the last flight.

    Args:
        seeds: One for each flight.
        flights: Their numbers.
        draws: Of every device.
        width: Lanes of a group.
        stretch: Ticks at hand at a time.
    """
    groups = -(-len(seeds) // width)
    spare = groups * width - len(seeds)
    keys = np.array([key_of(s) for s in seeds] + [key_of(seeds[-1])] * spare, dtype=np.uint64)
    numbers = np.array([*flights] + [flights[-1]] * spare, dtype=np.uint64)
    channels = sum(draw.channels for draw in draws)
    noise = zeros(groups, stretch, channels * width)
    shape = (groups, width)
    places = workplace(stretch * width)
    return NoiseStream(keys.reshape(shape), numbers.reshape(shape), plan_of(draws), noise, *places)
