"""Misfits: probabilities are those of noise, lost samples are none, means of samples accuse none."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import scipy

from identification.rigs import DAMPER, LOSS, SPRING, STIFFNESS, problem_of, recorded, rig
from springback.identification import misfit
from springback.identification.misfit import UNLIKELY, misfits
from springback.identification.solving.fitting import ImpactFit, fit_impact
from springback.logs.recording import POSITION, SPECIFIC_FORCE, Recording

FREE = {STIFFNESS: "factor 4", LOSS: "factor 4"}


def fitted(speed: float, seed: int, *, lost: float = 0.0, free: dict[str, str] = FREE) -> ImpactFit:
    vehicle = "quad" if free is FREE else "arq"
    tables = rig(vehicle, speed) | {"seed": seed}
    recording = recorded(tables)
    if lost:
        recording = _with_lost_frames(recording, lost)
    return fit_impact(problem_of(tables, recording, free), starts=1, seed=0, profiles=False)


def _with_lost_frames(recording: Recording, share: float) -> Recording:
    generator, channels = np.random.default_rng(1), []
    for one in recording.channels:
        if one.quantity == POSITION:
            lost = generator.random(len(one.times)) < share
            one = replace(one, values=np.where(lost[:, None], np.nan, one.values))
        channels.append(one)
    return replace(recording, channels=tuple(channels))


@pytest.mark.parametrize("count", [17, 29, 60])
def test_numbers_that_are_independent_hang_together_as_seldom_as_said(count: int) -> None:
    """Of one contact in a hundred at 1 %; χ² says four times as many."""
    generator, sets = np.random.default_rng(count), 4000
    told = np.array([misfit._ljung_box(generator.standard_normal((count, 3))) for _ in range(sets)])
    for level in (0.01, 0.04):
        error = (level / sets) ** 0.5
        assert float((told < level).mean()) == pytest.approx(level, abs=4.0 * error)
    by_law = scipy.stats.chi2.sf(misfit._correlation(generator.standard_normal((sets, count))), 8)
    assert float((by_law < 0.01 / 3.0).mean()) > 2.0 * 0.01 / 3.0


def test_numbers_that_hang_together_are_found() -> None:
    generator, white = np.random.default_rng(0), np.zeros((60, 3))
    for k in range(1, 60):
        white[k] = 0.7 * white[k - 1] + generator.standard_normal(3)
    assert misfit._ljung_box(white) < UNLIKELY


def test_frames_that_were_lost_are_no_perfect_predictions() -> None:
    """With half of them lost, their ratio was one half."""
    whole, found = fitted(1.85, 3), fitted(1.85, 3, lost=0.5)
    [all_told] = [x for x in misfits(whole) if (x.channel[-8:], x.part) == ("position", "all")]
    [told] = [x for x in misfits(found) if (x.channel[-8:], x.part) == ("position", "all")]
    assert told.samples == pytest.approx(0.5 * all_told.samples, rel=0.25)
    assert told.ratio == pytest.approx(1.0, abs=0.25)


def test_a_rise_between_samples_whose_mean_is_fitted_is_no_misfit() -> None:
    """At 3.5 m/s the force rises by 60 deviations a sample: the mean of three has no timing."""
    found = fitted(3.5, 2, free=FREE | {SPRING: "factor 4", DAMPER: "factor 4"})
    by_means = misfit._misfits_at(found, found.point)
    assert [(x.channel, x.part) for x in by_means if x.is_misfit] == [("accelerometer", "contact")]
    assert not [x for x in misfits(found) if x.is_misfit]


def test_samples_do_not_excuse_an_error_of_the_model() -> None:
    """An accelerometer of 3 % too much."""
    free = FREE | {SPRING: "factor 4", DAMPER: "factor 4"}
    tables = rig("arq")
    recording = recorded(tables)
    channels = tuple(
        replace(one, values=1.03 * one.values) if one.quantity == SPECIFIC_FORCE else one
        for one in recording.channels
    )
    problem = problem_of(tables, replace(recording, channels=channels), free)
    wrong = fit_impact(problem, starts=1, seed=0, profiles=False)
    assert any(x.is_misfit for x in misfits(wrong))
