"""Triggers: persistence, refractory time, re-arming, filter; and the same judged afterwards."""

import math
from typing import Any

import numba
import numpy as np
import pytest

from springback.kernels.vectors import Vec
from springback.recovery.detection import (
    NOT_TRIGGERED,
    Trigger,
    TriggerMemory,
    compressions,
    horizontal,
    trigger_step,
)
from springback.recovery.parameters import HallTrigger, TriggerSettings
from springback.studies.roc import TriggerSignal, alarms, curve, delay, false_alarms
from springback.vehicle.library import VEHICLES

TICK = 1e-3


def trigger(**changes: float) -> Trigger:
    plain = Trigger(used=1.0, threshold=1.0, persistence=1.0, refractory=0.0, share=1.0)
    return plain._replace(**changes)


def run(
    settings: Trigger, signal: Any, fresh: Any = None, law: Any = trigger_step
) -> tuple[list[int], TriggerMemory]:
    """Ticks of the alarms, and the memory at the end."""
    memory, raised = NOT_TRIGGERED, []
    for k, value in enumerate(signal):
        new = 1.0 if fresh is None else float(fresh[k])
        said = law(settings, k * TICK, float(value), new, memory)
        memory = said.memory
        if said.alarm > 0.5:
            raised.append(k)
    return raised, memory


def test_it_goes_off_once_and_arms_again_only_below() -> None:
    signal = [0.0, 2.0, 2.0, 2.0, 0.5, 2.0, 2.0]
    raised, memory = run(trigger(), signal)
    assert raised == [1, 5]
    assert memory.alarms == 2.0
    assert memory.first == pytest.approx(1 * TICK)
    assert memory.last == pytest.approx(5 * TICK)


def test_the_threshold_itself_is_not_above_it() -> None:
    assert run(trigger(), [0.0, 1.0, 1.0])[0] == []


@pytest.mark.parametrize("persistence", [2, 3, 5])
def test_persistence_waits_for_samples_in_a_row(persistence: int) -> None:
    broken = ([2.0] * (persistence - 1) + [0.0]) * 4
    assert run(trigger(persistence=float(persistence)), broken)[0] == []
    assert run(trigger(persistence=float(persistence)), [2.0] * 9)[0] == [persistence - 1]


def test_persistence_counts_samples_and_not_ticks() -> None:
    fresh = [k % 5 == 0 for k in range(30)]
    raised, _ = run(trigger(persistence=3.0), [2.0] * 30, fresh)
    assert raised == [10]


def test_nothing_is_noticed_in_the_refractory_time() -> None:
    signal = [2.0 if k % 10 < 5 else 0.0 for k in range(100)]
    raised, memory = run(trigger(refractory=0.025), signal)
    assert raised == [0, 30, 60, 90]
    assert memory.alarms == 4.0


def test_the_filter_is_a_first_order_low_pass() -> None:
    """A step of height 1 crosses 1 − 1/e one time constant later."""
    cutoff = 10.0
    share = TriggerSettings(cutoff=cutoff).share(TICK)
    raised, _ = run(trigger(share=share, threshold=1.0 - math.exp(-1.0)), [1.0] * 200)
    constant = 1.0 / (2.0 * math.pi * cutoff)
    assert raised[0] * TICK == pytest.approx(constant, rel=0.1)
    assert TriggerSettings().share(TICK) == 1.0


def test_a_stale_sample_changes_nothing() -> None:
    memory = run(trigger(share=0.3), [0.8, 0.4])[1]
    assert (
        trigger_step(trigger(share=0.3), 1.0, 50.0, 0.0, memory).memory.filtered == memory.filtered
    )


def test_unused_triggers_are_watched_all_the_same() -> None:
    assert run(trigger(used=0.0), [2.0])[0] == [0]
    assert HallTrigger(used=False).trigger(True, 5e-4, TICK).used == 0.0


def test_compression_is_positive_when_pressed_in_and_the_vertical_is_no_jolt() -> None:
    arms = VEHICLES["arq"].vehicle.airframe().arms
    pressed = compressions(arms, tuple(arm.length - 1e-3 for arm in arms))
    assert pressed == pytest.approx((1e-3,) * 4)
    assert horizontal(Vec(3.0, -4.0, 9.81)) == Vec(3.0, -4.0, 0.0)


@pytest.mark.parametrize("every", [1, 5])
@pytest.mark.parametrize("persistence", [1, 3])
def test_judging_afterwards_is_the_trigger_itself(every: int, persistence: int) -> None:
    noise_stream = np.random.default_rng(7)
    samples = noise_stream.normal(size=400)
    signal = np.repeat(samples, every)
    settings = trigger(persistence=float(persistence), threshold=0.4, refractory=0.0495)
    fresh = [k % every == 0 for k in range(len(signal))]
    raised, _ = run(settings, signal, fresh)
    judged = TriggerSignal(signal, TICK, every)
    found = alarms(judged, 0.4, persistence, 0.0495)
    assert raised
    assert found == raised


def test_delay_of_a_ramp_and_a_curve_that_falls() -> None:
    """A signal that grows by 1 each 10 ms from touch on reaches θ after 10 θ ms, rounded up."""
    touch, ticks = 0.1, np.arange(300) * TICK
    hit = TriggerSignal(np.clip((ticks - touch) / 0.01, 0.0, None), TICK, 1)
    assert delay(hit, touch, 1.45, 1, 0.1) == pytest.approx(0.015)
    assert delay(hit, touch, 5.0, 1, 0.03) is None
    noise_stream = np.random.default_rng(3)
    free = TriggerSignal(noise_stream.exponential(size=100_000), TICK, 1)
    thresholds = [0.5, 2.0, 2.5, 8.0, 20.0]
    points = curve(false_alarms([free], thresholds, refractory=0.01), [(hit, touch)], thresholds)
    false = [p.false_alarms for p in points]
    assert false == sorted(false, reverse=True)
    assert [p.probability for p in points] == [1.0, 1.0, 1.0, 0.0, 0.0]
    assert points[-1].false_alarms == 0
    assert points[-1].bound == pytest.approx(-math.log(0.05) / (100.0 / 3600.0), rel=1e-3)


def test_plain_and_compiled_triggers_are_twins() -> None:
    signal = np.abs(np.random.default_rng(1).normal(size=200))
    settings = trigger(share=0.37, persistence=2.0, refractory=0.01)
    assert run(settings, signal) == run(settings, signal, law=numba.njit(_twin))


def _twin(a: Any, b: Any, c: Any, d: Any, e: Any) -> Any:
    return trigger_step(a, b, c, d, e)
