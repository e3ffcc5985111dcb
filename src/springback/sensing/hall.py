"""Arm lengths from Hall-effect sensors: magnet, sensor, converter, and back to a length.

Each arm carries a magnet on the axis of a linear Hall-effect sensor (A1302; the paper names it).
The magnet is nearest while the arm is at its free length, and moves away as the arm is compressed,
so that the first millimetres, which reveal an impact, have the best resolution.  An arm that opens
beyond its free length has a second magnet and sensor, which mirror the first there.
"""

from __future__ import annotations

import functools
import math
from typing import Any, NamedTuple

from springback.kernels.angles import floor
from springback.kernels.compiler import generic, kernel
from springback.kernels.layout import TreeLayout, load, read, store
from springback.kernels.tree_code import Rarely
from springback.kernels.trees import field_of, maximum, select, tree_map
from springback.kernels.vectors import within
from springback.sensing.clock import draws
from springback.sensing.measurement import Pace, Truth, due
from springback.sensing.memory import Line, Nothing, arrival, constant_line, push
from springback.simulation.onboard import Draw
from springback.simulation.ticks import Group, TickNoise, state_of, truth_of
from springback.vehicle.state import State

#: Bisections of the range of lengths in the calibration, from 54 mm to 0.4 mm, after which Newton's
#: method converges to within 1 pm in this many steps.
HALVINGS, NEWTON_STEPS = 7, 3


class PerfectArmLengths(NamedTuple):
    """The exact length of every arm at every tick."""

    unused: float


class Magnet(NamedTuple):
    """A disc magnetised along its axis."""

    remanence: float  # B_r [T]
    radius: float  # R [m]
    thickness: float  # h [m]


class Span(NamedTuple):
    """Range of lengths in which one arm's sensor is calibrated."""

    free: float  # L [m]
    shortest: float  # [m]
    longest: float  # [m]
    opens: float = 0.0  # 1 for an arm that opens beyond its free length, with a second sensor there
    share: float = 1.0  # way of the magnet per way of the arm's end, less than 1 near a hinge


class HallSensors(NamedTuple):
    """One Hall-effect sensor for each arm, and the converter that samples them."""

    magnet: Magnet
    distance: float  # from the magnet's face to the sensor at the arm's free length [m]
    sensitivity: float  # [V/T]
    quiescent: float  # output without a field [V]
    lowest: float  # output, saturated [V]
    highest: float  # output, saturated [V]
    noise: float  # standard deviation of the output [V]
    supply: float  # also the converter's reference [V]
    counts: float  # of the converter, 2^bits
    every: Pace  # of its samples
    delay: float  # from sampling to arrival [ticks], at most four periods
    beyond: float  # extension of the calibration beyond the free length [m]
    spans: tuple[Span, ...]


class ArmMemory(NamedTuple):
    """Samples of one arm in transit, and the last that arrived."""

    line: Line  # of counts
    word: float  # the last that arrived
    length: float  # arm length for that count [m]
    sampled: float  # length at the last sample [m] ...
    output: float  # ... and the output there, without noise [V]


class HallMemory(NamedTuple):
    """Memory of all arms."""

    arms: tuple[ArmMemory, ...]


class ArmsRead(NamedTuple):
    """Arm lengths, and the memory of the device."""

    length: tuple[float, ...]  # [m]
    fresh: float  # 1 at the tick at which they arrive
    memory: Any


# -- forward --------------------------------------------------------------------------------------


@kernel
def axial_field(magnet: Magnet, d: float) -> float:
    """Flux density on the axis of a disc magnet [T].

    B = B_r/2 [(d + h)/√(R² + (d + h)²) − d/√(R² + d²)], the closed form for uniform axial
    magnetisation (for example Camacho and Sosa, Revista Mexicana de Física E 59, 2013).

    Args:
        magnet: B_r, R and h.
        d: Distance from the near face [m].
    """
    far, square = d + magnet.thickness, magnet.radius * magnet.radius
    there, here = far / math.sqrt(square + far * far), d / math.sqrt(square + d * d)
    return 0.5 * magnet.remanence * (there - here)


@kernel
def output(sensors: HallSensors, compression: float) -> float:
    """Voltage of a sensor at a compression L − l [m], without noise or saturation."""
    field = axial_field(sensors.magnet, sensors.distance + compression)
    return sensors.quiescent + sensors.sensitivity * field


@kernel
def output_at(sensors: HallSensors, span: Span, length: float) -> float:
    """Voltage of the sensor of an arm [V] that reads at a length [m]."""
    pressed = span.share * (span.free - length)
    return output(sensors, -pressed if _is_mirrored(span, length) else pressed)


@kernel
def _is_mirrored(span: Span, length: float) -> bool:
    """True where the second sensor of an arm reads: that of lengths beyond the free one."""
    return (span.opens > 0.5) & (length > span.free)


@kernel
def word_of(sensors: HallSensors, voltage: float) -> float:
    """Converter output for a voltage, an integer from 0 to counts − 1."""
    low = voltage if voltage > sensors.lowest else sensors.lowest
    inside = low if low < sensors.highest else sensors.highest
    word = floor(inside / sensors.supply * sensors.counts)
    top = sensors.counts - 1.0
    return word if word < top else top


@kernel
def word_at(sensors: HallSensors, span: Span, length: float, voltage: float) -> float:
    """Converter output at a length: voltages of the second sensor follow those of the first."""
    word = word_of(sensors, voltage)
    return word + sensors.counts if _is_mirrored(span, length) else word


# -- inverse -------------------------------------------------------------------------------------


@kernel
def calibrated_length(sensors: HallSensors, span: Span, word: float) -> float:
    """Arm length for a converter output [m].

    The voltage decreases monotonically with compression, and has no inverse in closed form: so the
    calibrated range is bisected a few times around the voltage in the middle of the count, and
    Newton's method continues from there, to far less than the remaining error of half a count
    (`resolution`).  Outside the range the result is clamped to its ends.
    """
    mirrored = word > sensors.counts - 0.5
    own = word - sensors.counts if mirrored else word
    voltage = (own + 0.5) / sensors.counts * sensors.supply
    farthest = span.free - (span.longest - span.free)
    low = farthest if mirrored else span.shortest
    # Of two sensors each is calibrated as far beyond the free length as noise and counts need.
    high = span.free + sensors.beyond if span.opens > 0.5 else span.longest
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        longer = output(sensors, span.share * (span.free - middle)) < voltage
        low = middle if longer else low
        high = high if longer else middle
    length = 0.5 * (low + high)
    for _ in range(NEWTON_STEPS):
        pressed = span.share * (span.free - length)
        missing = voltage - output(sensors, pressed)
        length = within(length - missing / (span.share * slope(sensors, pressed)), low, high)
    return span.free + (span.free - length) if mirrored else length


@kernel
def slope(sensors: HallSensors, compression: float) -> float:
    """Change of the output with the compression [V/m], below zero.

    From dB/dd = B_r/2 R² [(R² + (d + h)²)^−1.5 − (R² + d²)^−1.5].

    Args:
        sensors: The sensors.
        compression: L − l [m].
    """
    m, near = sensors.magnet, sensors.distance + compression
    far, square = near + m.thickness, m.radius * m.radius
    there, here = square + far * far, square + near * near
    change = 1.0 / (there * math.sqrt(there)) - 1.0 / (here * math.sqrt(here))
    return sensors.sensitivity * 0.5 * m.remanence * square * change


def resolution(sensors: HallSensors, compression: float, share: float = 1.0) -> float:
    """Change of arm length per count of the converter [m]; plain Python.

    Args:
        sensors: The sensors.
        compression: L − l [m], or l − L where the second sensor of an arm reads.
        share: As in `Span`.
    """
    slope_there = share * slope(sensors, share * compression)
    return sensors.supply / sensors.counts / abs(slope_there)


def ends(sensors: HallSensors, span: Span) -> tuple[float, float]:
    """Shortest and longest length that an arm's sensor can tell [m]; plain Python.

    It is the end of the calibration, or the length at which the output saturates before.
    """
    top = word_of(sensors, sensors.highest)
    bottom = word_of(sensors, sensors.lowest)
    low = calibrated_length(sensors, span, bottom)
    if span.opens > 0.5:
        return low, calibrated_length(sensors, span, bottom + sensors.counts)
    return low, calibrated_length(sensors, span, top)


# -- at a tick ------------------------------------------------------------------------------------


@generic
def arms_read(
    device: Any, tick: float, truth: Truth, noise: tuple[float, ...], memory: Any
) -> ArmsRead:
    """Arm lengths measured at a tick.

    Args:
        device: `HallSensors` or `PerfectArmLengths`.
        tick: Number of the tick, from 0.
        truth: The motion over the last tick.
        noise: Independent standard normal numbers, one for each arm.
        memory: Memory of the device.
    """
    raise TypeError(
        f"{type(device).__name__} is not an arm-length sensor; register arms_read for it"
    )


@arms_read.register(PerfectArmLengths)
@kernel
def _perfect(
    device: PerfectArmLengths,
    tick: float,
    truth: Truth,
    noise: tuple[float, ...],
    memory: Nothing,
) -> ArmsRead:
    return ArmsRead(truth.now.arm_length, 1.0, memory)


@kernel
def _sample(span: Span, m: ArmMemory, length: float, sensors: HallSensors) -> ArmMemory:
    """One arm with the voltage for its present length."""
    return ArmMemory(m.line, m.word, m.length, length, output_at(sensors, span, length))


@kernel
def _convert(span: Span, m: ArmMemory, normal: float, sensors: HallSensors) -> ArmMemory:
    """One arm with the converter's output for that voltage in transit."""
    word = word_at(sensors, span, m.sampled, m.output + sensors.noise * normal)
    return ArmMemory(push(m.line, word), m.word, m.length, m.sampled, m.output)


@kernel
def _has_moved(m: ArmMemory, length: float) -> float:
    """Flag, 1 if the length of an arm has changed since its last sample."""
    return select(m.sampled == length, 0.0, 1.0)


@kernel
def _deliver(span: Span, m: ArmMemory, sensors: HallSensors) -> ArmMemory:
    """One arm at a tick at which a sample arrives."""
    word = arrival(m.line, sensors.delay, sensors.every.ticks)
    # The search takes longer than all else here, and an arm at rest repeats its output.
    length = m.length if word == m.word else calibrated_length(sensors, span, word)
    return ArmMemory(m.line, word, length, m.sampled, m.output)


@kernel
def _is_new(m: ArmMemory, sensors: HallSensors) -> float:
    """Flag, 1 if the arriving sample differs from the last."""
    return select(arrival(m.line, sensors.delay, sensors.every.ticks) == m.word, 0.0, 1.0)


@kernel
def _is_sample_due(sensors: HallSensors, tick: float) -> bool:
    return due(tick, sensors.every)


@kernel
def _is_delivery_due(sensors: HallSensors, tick: float) -> bool:
    since = tick - sensors.delay
    return (since > -0.5) & due(since, sensors.every)


@arms_read.register(HallSensors)
@kernel
def _arms_read(
    sensors: HallSensors,
    tick: float,
    truth: Truth,
    noise: tuple[float, ...],
    memory: Rarely,
) -> ArmsRead:
    arms, sampling, fresh = (
        memory.tree.arms,
        _is_sample_due(sensors, tick),
        _is_delivery_due(sensors, tick),
    )
    if sampling:
        arms = tree_map(_sample, (sensors.spans, arms, truth.now.arm_length), (sensors,))
        arms = tree_map(_convert, (sensors.spans, arms, noise), (sensors,))
    if fresh:
        arms = tree_map(_deliver, (sensors.spans, arms), (sensors,))
    flag, new = 1.0 if fresh else 0.0, 1.0 if sampling | fresh else 0.0
    return ArmsRead(field_of(arms, "length"), flag, Rarely(new, HallMemory(arms)))


@generic
def read_arms(device: TreeLayout, group: Group, noise: TickNoise) -> None:
    """Arm-length sensors of all lanes; arguments as for `springback.simulation.ticks.look`."""
    _read_arms_one_by_one(device, group, noise)


@kernel
def _read_arms_one_by_one(device: TreeLayout, group: Group, noise: TickNoise) -> None:
    avionics, g, w, _, tick = group.lanes
    memory, seen = avionics.onboard.sensors.arm_length, avionics.onboard.measurement
    for i in range(w):
        drawn = read(noise.channels, noise.drawn, noise.first, w, i)
        truth, before = truth_of(group, i), load(memory, g, w, i)
        read_now = arms_read(load(device, g, w, i), tick, truth, drawn, before)
        store(read_now.length, seen.arm_length, g, w, i)
        store(read_now.fresh, seen.arm_length_fresh, g, w, i)
        store(read_now.memory, memory, g, w, i)


@read_arms.register(HallSensors)
@kernel
def _read_hall_sensors(device: TreeLayout, group: Group, noise: TickNoise) -> None:
    """Batch version of `arms_read`; the calibration is searched only where a sample has changed."""
    avionics, g, w, once, tick = group.lanes
    memory, seen = avionics.onboard.sensors.arm_length.tree.arms, avionics.onboard.measurement
    sampling, moved, delivering, renewed = 0, 0, 0, 0
    for i in range(w * once):
        sensors = load(device, g, w, i)
        fresh = _is_delivery_due(sensors, tick)
        sampling += 1 if _is_sample_due(sensors, tick) else 0
        delivering += 1 if fresh else 0
        store(select(fresh, 1.0, 0.0), seen.arm_length_fresh, g, w, i)
    for i in range(w * once if sampling > 0 else 0):
        arms, lengths = load(memory, g, w, i), state_of(group, i).arm_length
        moved += 1 if maximum(tree_map(_has_moved, (arms, lengths), ())) > 0.5 else 0
    for i in range(w * once if moved > 0 else 0):  # roots are expensive, and arms seldom move
        sensors, arms = load(device, g, w, i), load(memory, g, w, i)
        lengths = state_of(group, i).arm_length
        now = tree_map(_sample, (sensors.spans, arms, lengths), (sensors,))
        store(select(_is_sample_due(sensors, tick), now, arms), memory, g, w, i)
    for i in range(w * once if sampling > 0 else 0):
        sensors, arms = load(device, g, w, i), load(memory, g, w, i)
        drawn = read(noise.channels, noise.drawn, noise.first, w, i)
        now = tree_map(_convert, (sensors.spans, arms, drawn), (sensors,))
        store(select(_is_sample_due(sensors, tick), now, arms), memory, g, w, i)
    for i in range(w * once if delivering > 0 else 0):
        sensors, arms = load(device, g, w, i), load(memory, g, w, i)
        changed = maximum(tree_map(_is_new, (arms,), (sensors,)))
        renewed += 1 if _is_delivery_due(sensors, tick) & (changed > 0.5) else 0
    for i in range(w * once if tick < 0.5 else 0):
        store(field_of(load(memory, g, w, i), "length"), seen.arm_length, g, w, i)
    for i in range(w if renewed > 0 else 0):
        sensors, arms = load(device, g, w, i), load(memory, g, w, i)
        changed = maximum(tree_map(_is_new, (arms,), (sensors,)))
        if _is_delivery_due(sensors, tick) and changed > 0.5:
            arms = tree_map(_deliver, (sensors.spans, arms), (sensors,))
            store(arms, memory, g, w, i)
            store(field_of(arms, "length"), seen.arm_length, g, w, i)


@draws.register
def _(device: PerfectArmLengths, channels: int) -> tuple[Draw, ...]:
    return (Draw(channels, 0),)


@draws.register
def _(device: HallSensors, channels: int) -> tuple[Draw, ...]:
    return (Draw(channels, round(device.every.ticks)),)


@functools.singledispatch
def arms_at_start(device: Any, start: State) -> Any:
    """Memory of arm-length sensors before their first tick, settled at the start's lengths.

    Plain Python.

    Args:
        device: `HallSensors` or `PerfectArmLengths`.
        start: State at tick 0.
    """
    return Nothing(0.0)


@arms_at_start.register
def _(device: HallSensors, start: State) -> Rarely:
    arms = []
    for span, length in zip(device.spans, start.arm_length, strict=True):
        voltage = output_at(device, span, length)
        word = word_at(device, span, length, voltage)
        known = calibrated_length(device, span, word)
        arms.append(ArmMemory(constant_line(word), word, known, length, voltage))
    return Rarely(0.0, HallMemory(tuple(arms)))
