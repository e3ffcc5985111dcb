"""Hall-effect arm lengths: field of a disc, the data sheet's volts, and back to a length."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from scipy.integrate import quad

from builders.cases import nonempty
from springback.errors import InputError
from springback.kernels.vectors import Quat, Vec
from springback.sensing.hall import (
    ArmsRead,
    HallSensors,
    Magnet,
    PerfectArmLengths,
    arms_at_start,
    arms_read,
    axial_field,
    calibrated_length,
    ends,
    output,
    output_at,
    resolution,
    slope,
    word_at,
    word_of,
)
from springback.sensing.measurement import Truth, task_pace
from springback.sensing.parameters import HallSettings
from springback.vehicle.library import VEHICLES
from springback.vehicle.state import State

TICK = 1e-3
ARQ = VEHICLES["arq"].vehicle
LENGTH, STROKE = 0.19, 0.05
ZERO = Vec(0.0, 0.0, 0.0)


def sensors(**changes: float) -> HallSensors:
    device = HallSettings(**changes).device(TICK, ARQ)
    assert isinstance(device, HallSensors)
    return device


def truth(lengths: tuple[float, ...]) -> Truth:
    now = State(ZERO, Quat(1.0, 0.0, 0.0, 0.0), ZERO, ZERO, lengths, (0.0,) * len(lengths))
    return Truth(now, now, TICK, 9.81)


def read_back(device: HallSensors, length: float, volts: float = 0.0) -> float:
    span = device.spans[0]
    return calibrated_length(device, span, word_of(device, output(device, LENGTH - length) + volts))


# -- there ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("d", [0.0, 0.003, 0.02, 0.06])
def test_a_disc_is_a_stack_of_current_loops(d: float) -> None:
    """Uniform magnetisation is a sheet of current B_r/µ0 around the rim; Biot and Savart sum it."""
    magnet = Magnet(1.3, 7.5e-3, 8e-3)

    def loop(z: float) -> float:
        return 0.5 * 1.3 * magnet.radius**2 / (magnet.radius**2 + z * z) ** 1.5

    stacked = quad(loop, d, d + magnet.thickness, epsabs=1e-14, epsrel=1e-12)[0]
    assert axial_field(magnet, d) == pytest.approx(stacked, rel=1e-10)


def test_far_away_a_disc_is_a_dipole() -> None:
    magnet = Magnet(1.2, 5e-3, 3e-3)
    z = 0.5
    moment = 1.2 * math.pi * magnet.radius**2 * magnet.thickness  # µ0 times the moment
    dipole = moment / (2 * math.pi * z**3)
    assert axial_field(magnet, z - magnet.thickness / 2) == pytest.approx(dipole, rel=1e-3)


def test_volts_of_the_data_sheet() -> None:
    """1.3 mV/G on 2.5 V, saturated at 0.2 V and 4.7 V; 4.88 mV for each of 1024 counts."""
    device = sensors()
    field = axial_field(device.magnet, device.distance)
    gauss = field / 1e-4
    assert output(device, 0.0) == pytest.approx(2.5 + 1.3e-3 * gauss, rel=1e-12)
    assert word_of(device, 2.5) == 512.0
    assert word_of(device, 2.5 + 5.0 / 1024) == 513.0
    assert word_of(device, 99.0) == word_of(device, 4.7) == math.floor(4.7 / 5 * 1024)
    assert word_of(device, -99.0) == word_of(device, 0.2) == math.floor(0.2 / 5 * 1024)
    assert word_of(device._replace(highest=99.0), 99.0) == 1023.0


# -- and back -------------------------------------------------------------------------------------


def test_lengths_come_back_within_half_a_count_over_the_stroke() -> None:
    """By the mean value theorem: the slope is smallest at the farther of the two places."""
    device = sensors()
    worst = 0.0
    for length in np.linspace(LENGTH, LENGTH - STROKE, 1500).tolist():
        back = read_back(device, length)
        volts = abs(output(device, LENGTH - back) - output(device, LENGTH - length))
        at_end = back < device.spans[0].shortest + 1e-6
        assert at_end or volts <= 0.5 * 5.0 / 1024 * (1 + 1e-4)
        farther = LENGTH - min(back, length)
        assert abs(back - length) <= 0.5 * resolution(device, farther) * (1 + 1e-4)
        worst = max(worst, abs(back - length))
    assert worst < 3e-3


def test_the_calibration_inverts_the_output() -> None:
    """To the picometre, for every word that an arm between the ends of its calibration can say."""
    device = sensors()
    span = device.spans[0]
    first = word_of(device, output(device, span.free - span.shortest)) + 1.0
    last = word_of(device, output(device, span.free - span.longest)) - 1.0
    for word in nonempty(np.arange(first, last + 1.0).tolist()):
        pressed = span.free - calibrated_length(device, span, word)
        missing = (word + 0.5) / 1024 * 5.0 - output(device, pressed)
        assert abs(missing / slope(device, pressed)) < 1e-12


@pytest.mark.parametrize(
    ("compression", "millimetres", "error"),
    [(0.0, 0.018, 0.01), (0.002, 0.027, 0.015), (0.01, 0.122, 0.07), (0.02, 0.49, 0.27),
     (0.03, 1.40, 0.8), (0.04, 3.23, 1.7), (0.05, 6.47, 2.7)],
)  # fmt: skip
def test_stated_resolution_and_error(compression: float, millimetres: float, error: float) -> None:
    """The numbers that the documentation gives for the default magnet."""
    device = sensors()
    assert 1e3 * resolution(device, compression) == pytest.approx(millimetres, rel=0.02)
    near = [LENGTH - compression + x for x in np.linspace(-5e-4, 5e-4, 101).tolist()]
    assert 1e3 * max(abs(read_back(device, length) - length) for length in near) < error


def test_resolution_is_the_slope_of_the_output() -> None:
    device, h = sensors(), 1e-6
    for c in (0.0, 0.01, 0.05):
        steep = (output(device, c - h) - output(device, c + h)) / (2 * h)
        assert resolution(device, c) == pytest.approx(5.0 / 1024 / steep, rel=1e-6)


def test_pressing_in_never_reads_longer_and_never_leaves_the_calibration() -> None:
    device = sensors()
    lengths = np.linspace(LENGTH + 0.004, 0.05, 700).tolist()
    back = [read_back(device, length) for length in lengths]
    assert all(b <= a for a, b in itertools.pairwise(back))
    assert min(back) >= LENGTH - STROKE - 0.002
    assert max(back) <= LENGTH + 0.002


@pytest.mark.parametrize("name", ["xplorer", "morphy"])
def test_arms_that_open_are_read_over_all_that_their_stops_allow(name: str) -> None:
    """To half a count on either side of the free length, mirrored about it."""
    vehicle = VEHICLES[name].vehicle
    device = HallSettings(noise=0.0).device(TICK, vehicle)
    assert isinstance(device, HallSensors)
    span, free = device.spans[0], vehicle.arms.at("length", 0)
    low, high = vehicle.arms.travel(0)
    assert low < 0.0 < high

    def read(length: float) -> float:
        word = word_at(device, span, length, output_at(device, span, length))
        return calibrated_length(device, span, word)

    for length in nonempty(np.linspace(free - high, free - low, 401).tolist()):
        way = abs(length - free)
        count = resolution(device, max(way, abs(read(length) - free)), span.share)
        assert abs(read(length) - length) <= 0.5 * count * (1 + 1e-4)
        if way > 1e-6:
            mirrored = free - (length - free)
            assert read(length) - free == pytest.approx(free - read(mirrored), abs=1e-12)
    shortest, longest = ends(device, span)
    assert shortest < free - high
    assert longest > free - low
    assert read(longest + 0.01) == pytest.approx(longest, abs=1e-12)
    assert span.share * max(high, -low) <= 0.05 + 1e-12


def test_an_arm_that_only_shortens_has_one_sensor() -> None:
    device = sensors()
    span = device.spans[0]
    assert (span.opens, span.share) == (0.0, 1.0)
    assert span[1:3] == (LENGTH - STROKE - 0.002, LENGTH + 0.002)
    assert ends(device, span)[0] == pytest.approx(span.shortest, abs=1e-12)


def test_an_arm_that_opens_is_followed_through_its_free_length() -> None:
    """As in flight: sampled, converted and delivered, from pressed in to far out."""
    vehicle = VEHICLES["xplorer"].vehicle
    device = HallSettings(noise=0.0, rate=1000.0, delay=0.0).device(TICK, vehicle)
    assert isinstance(device, HallSensors)
    free, share = vehicle.arms.at("length", 0), device.spans[0].share
    memory = arms_at_start(device, truth((free - 0.06,) * 4).now)
    for tick, length in nonempty(enumerate(np.linspace(free - 0.06, free + 0.09, 60).tolist())):
        told = arms_read(device, float(tick), truth((length,) * 4), (0.0,) * 4, memory)
        memory, most = told.memory, resolution(device, abs(length - free), share)
        assert told.length[0] == pytest.approx(length, abs=0.55 * most)


def test_noise_of_the_sensor_is_below_the_converter() -> None:
    """150 µV against 4.88 mV: readings of an arm at rest take one of two neighbouring words."""
    device, rng = sensors(), np.random.default_rng(5)
    memory = arms_at_start(device, truth((0.185,) * 4).now)
    read = set()
    for tick in range(200):
        noise = tuple(rng.standard_normal(4).tolist())
        told = arms_read(device, float(tick), truth((0.185,) * 4), noise, memory)
        memory = told.memory
        read.update(told.length)
    assert len(read) <= 2
    loud = device._replace(noise=0.05)
    memory = arms_at_start(loud, truth((0.185,) * 4).now)
    for tick in range(400):
        noise = tuple(rng.standard_normal(4).tolist())
        told = arms_read(loud, float(tick), truth((0.185,) * 4), noise, memory)
        memory = told.memory
        read.update(told.length)
    assert len(read) > 20


# -- at a tick ------------------------------------------------------------------------------------


@pytest.mark.parametrize(("every", "delay"), [(1, 0), (1, 4), (5, 0), (5, 5), (5, 7), (5, 20)])
def test_lengths_arrive_exactly_late(every: int, delay: int) -> None:
    device = sensors()._replace(every=task_pace(float(every)), delay=float(delay), noise=0.0)
    memory = arms_at_start(device, truth((LENGTH,) * 4).now)

    def length(tick: int) -> float:
        return LENGTH - 3e-4 * tick

    last = memory.tree.arms[0].length
    for tick in range(40):
        now = tuple(length(tick) - 1e-3 * j for j in range(4))
        told = arms_read(device, float(tick), truth(now), (0.0,) * 4, memory)
        memory, taken = told.memory, tick - delay
        assert told.fresh == (taken >= 0 and taken % every == 0)
        if told.fresh:
            for j in range(4):
                assert told.length[j] == read_back(device, length(taken) - 1e-3 * j)
        else:
            assert told.length[0] == last
        last = told.length[0]


def test_perfect_lengths_are_exact() -> None:
    lengths = (0.19, 0.1823, 0.15, 0.1901)
    told = arms_read(PerfectArmLengths(0.0), 3.0, truth(lengths), (5.0,) * 4, None)
    assert told == ArmsRead(lengths, 1.0, None)


def test_a_magnet_too_close_is_refused() -> None:
    with pytest.raises(
        InputError, match=r"saturates the sensor: 5.69 V .* above its limit of 4.7 V"
    ):
        HallSettings(distance=4e-3)
    with pytest.raises(InputError, match="more than the overrun"):
        HallSettings(distance=1e-3)
