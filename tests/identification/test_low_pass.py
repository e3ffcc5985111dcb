"""Low-passes of autopilots: of second order, at a corner that need not be known."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from identification.rigs import LOSS, STIFFNESS, TRUE, problem_of, recorded, rig
from springback.errors import InputError
from springback.identification.fits import FitResult, result_of
from springback.identification.observations.likelihood import CORNER
from springback.identification.observations.noise import estimated_noise
from springback.identification.observations.sensor_chain import (
    ChannelChain,
    low_passed,
    noise_covariances,
)
from springback.identification.settings import FitPlan, read_fit_plan
from springback.identification.solving.fitting import ImpactFit, fit_impact
from springback.logs.recording import SPECIFIC_FORCE, Recording

FREE = {STIFFNESS: "factor 4", LOSS: "factor 4"}


def px4(values: Any, corner: float, rate: float) -> Any:
    """Direct form of PX4's LowPassFilter2p, settled on the first value."""
    ohm = math.tan(math.pi * corner / rate)
    c = 1.0 + 2.0 * math.cos(math.pi / 4.0) * ohm + ohm * ohm
    b0 = ohm * ohm / c
    a1, a2 = (
        2.0 * (ohm * ohm - 1.0) / c,
        (1.0 - 2.0 * math.cos(math.pi / 4.0) * ohm + ohm * ohm) / c,
    )
    one = two = values[0] / (1.0 + a1 + a2)
    found = []
    for x in values:
        zero = x - one * a1 - two * a2
        found.append(b0 * (zero + 2.0 * one + two))
        one, two = zero, one
    return np.array(found)


def told(fit: ImpactFit) -> FitResult:
    """What an impact tells."""
    assert isinstance(fit.problem.plan, FitPlan)
    return result_of(fit.problem.plan, [fit])


def behind(read: Recording, corner: float, chain: dict[str, Any]) -> Recording:
    """A recording whose accelerometer went through an autopilot's filter, too."""
    channels = []
    for one in read.channels:
        if one.quantity == SPECIFIC_FORCE:
            values = px4(one.values, corner, one.rate)
            one = replace(one, values=values, clipped=None, chain=replace(one.chain, **chain))
        channels.append(one)
    return replace(read, channels=tuple(channels))


def test_the_second_order_is_that_of_px4_at_the_rate_of_the_sensor() -> None:
    values = np.random.default_rng(0).standard_normal((2, 300, 3))
    found = low_passed(values, 30.0, 2, np.full(300, 1e-3))
    for one, wanted in zip(found, values, strict=True):
        np.testing.assert_allclose(one, px4(wanted, 30.0, 1000.0), atol=1e-10)
    # Beyond half the rate the autopilot leaves it out.
    assert low_passed(values, 600.0, 2, np.full(300, 1e-3)) is values


def test_unequal_steps_give_the_same_as_equal_ones() -> None:
    """A push of 20 ms, its means over steps of 1 ms and over uneven parts of them."""

    def behind_filter(grid: Any) -> Any:
        phase = np.clip((grid - 0.05) * np.pi / 0.02, 0.0, np.pi)
        means = -np.diff(np.cos(phase)) / np.diff(grid) * 100.0 * 0.02 / np.pi
        return low_passed(means[None, :, None], 30.0, 2, np.diff(grid))[0, :, 0]

    grid = np.linspace(0.0, 0.2, 201)
    equal = behind_filter(grid)
    uneven = behind_filter(np.sort(np.concatenate([grid, grid[:-1] + 0.4e-3])))[1::2]
    assert equal.max() > 40.0
    assert np.abs(equal - uneven).max() < 0.05 * equal.max()
    # Means over shorter steps come less late, by a quarter of a step: that is the difference.
    assert np.abs(equal - uneven).max() < 0.3 * np.abs(np.diff(equal)).max()


def test_a_filter_of_second_order_is_no_filter_of_first_order() -> None:
    """Told as first order, the wall is wrong by 8 % and a misfit says why; told right, it is not."""
    tables = rig("quad")
    log = behind(recorded(tables), 30.0, {"low_pass": 30.0})
    wrong = fit_impact(problem_of(tables, log, FREE), starts=2, seed=0)
    found = told(wrong)
    low = found.estimates[0].low
    assert found.estimates[0].value < 0.95 * TRUE[STIFFNESS]
    assert low > 0.9 * TRUE[STIFFNESS]  # and said to be known by far better
    [said] = [text for text in found.sentences if "accelerometer may be its low-pass" in text]
    assert "first order at 30 Hz exactly" in said
    assert "sensors.accelerometer.low_pass_order is 1 or 2" in said
    log = behind(recorded(tables), 30.0, {"low_pass": 30.0, "low_pass_order": 2})
    right = fit_impact(problem_of(tables, log, FREE), starts=2, seed=0)
    chain = right.problem.chain(right.problem.readings[0])
    assert (chain.low_pass, chain.order, chain.device) == (30.0, 2, 218.1)  # the scenario's own
    found = told(right)
    for one in found.estimates:
        assert one.low <= TRUE[one.unknown.name] <= one.high
    assert not [text for text in found.sentences if "low-pass" in text]
    assert not [one for one in found.misfits if one.channel == "accelerometer" and one.is_misfit]


def test_noise_behind_a_filter_is_whitened_by_what_is_known_of_it() -> None:
    """A push of 20 ms, fitted in 200 draws of filtered noise: as uncertain as it is said to be.

    Estimated from the samples alone, with a hundredth of its variance white, it is so, too; what is
    told is then less.
    """
    rng, rate = np.random.default_rng(1), 1000.0
    covariances = noise_covariances(ChannelChain(None, 30.0, None, 2, 218.1), rate)
    assert covariances is not None
    t = np.arange(800) / rate
    push = np.where((t > 0.6) & (t < 0.62), np.sin((t - 0.6) * np.pi / 0.02), 0.0)
    steps = np.full(800, 1.0 / rate)
    push = low_passed(push[None, :, None], 30.0, 2, steps)[0]
    starts = np.arange(800) == 0
    off: dict[bool, list[float]] = {True: [], False: []}
    for _ in range(200):
        noise = 0.5 * rng.standard_normal((1, 800, 1))
        noise = low_passed(low_passed(noise, 218.1, 1, steps), 30.0, 2, steps)[0]
        for known in off:
            told = estimated_noise(t[:500], noise[:500], 1e-4, covariances if known else None)
            a, b = told.whiten(push, starts), told.whiten(noise, starts)
            off[known].append(float((a * b).sum() / np.sqrt((a * a).sum())))
    assert np.sqrt(np.mean(np.square(off[True]))) == pytest.approx(1.0, abs=0.15)
    assert np.sqrt(np.mean(np.square(off[False]))) == pytest.approx(1.0, abs=0.15)


def test_a_corner_that_is_not_certain_is_fitted() -> None:
    """35 Hz ± 20 % of a filter of 30 Hz: found, and the wall with it."""
    tables = rig("quad")
    log = behind(recorded(tables), 30.0, {"low_pass": None})
    sensors = {"accelerometer": {"low_pass": "35 Hz +- 20 %", "low_pass_order": 2}}
    fit = fit_impact(problem_of(tables, log, FREE, sensors=sensors), starts=2, seed=0)
    k = fit.problem.place[CORNER[SPECIFIC_FORCE]]
    unknown = fit.problem.unknowns[k]
    assert unknown.is_shared
    deviation = unknown.deviation * fit.deviation(unknown.name)
    assert deviation < 0.02
    assert math.log(unknown.value(fit.point[k]) / 30.0) == pytest.approx(0.0, abs=3.0 * deviation)
    for one in told(fit).estimates:
        assert one.low <= TRUE[one.unknown.name] <= one.high


def plan_with(tmp_path: Path, *lines: str) -> Any:
    path = tmp_path / "fit.toml"
    text = ['scenario = "s.toml"', "[free]", f'"{STIFFNESS}" = "factor 3"']
    path.write_text("\n".join([*text, "[sensors.accelerometer]", *lines]), encoding="utf-8")
    return read_fit_plan(path).sensors.accelerometer


@pytest.mark.parametrize(
    ("line", "corner", "share"),
    [
        ('low_pass = "30 Hz"', 30.0, None), ('low_pass = "30 Hz +- 20 %"', 30.0, 0.2),
        ('low_pass = "0.04 kHz +- 2 Hz"', 40.0, 0.05), ("low_pass = 25", 25.0, None),
        ('low_pass_uncertainty = "10 %"', None, 0.1),
    ],
)  # fmt: skip
def test_a_corner_is_written_with_its_uncertainty(
    tmp_path: Path, line: str, corner: float | None, share: float | None
) -> None:
    given = plan_with(tmp_path, line)
    assert given.low_pass == corner
    assert given.low_pass_uncertainty == (None if share is None else pytest.approx(share))


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        (('low_pass = "30 m +- 20 %"',), "low_pass"),
        (('low_pass = "30 Hz +- 5 m"',), "low_pass_uncertainty"),
        (('low_pass = "30 Hz +- 20 %"', "low_pass_uncertainty = 0.1"), "as well"),
        (("low_pass_order = 3",), "low_pass_order"),
    ],
)
def test_a_mistake_in_a_corner_is_named_with_its_line(
    tmp_path: Path, lines: tuple[str, ...], said: str
) -> None:
    with pytest.raises(InputError) as error:
        plan_with(tmp_path, *lines)
    [line] = error.value.problems
    assert said in line
    assert line.startswith(f"{tmp_path / 'fit.toml'}:")


def test_a_corner_that_nobody_tells_cannot_be_uncertain() -> None:
    tables = rig("quad")
    log = behind(recorded(tables), 30.0, {"low_pass": None})
    bare = {key: value for key, value in tables.items() if key != "sensors"}
    sensors = {"accelerometer": {"low_pass_uncertainty": 0.2}}
    with pytest.raises(InputError, match=r"sensors\.accelerometer\.low_pass_uncertainty: needs a"):
        problem_of(bare, log, FREE, sensors=sensors)
