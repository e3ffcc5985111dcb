"""What the report of a fit adds: profiles, replays, and what is assumed."""

from __future__ import annotations

import math

import numpy as np
import pytest

from builders.rigs import rig_fit
from springback.identification.fits import FitResult
from springback.identification.observations.likelihood import ImpactProblem
from springback.identification.report.assumptions import assumptions
from springback.identification.report.profiles import profile_curves
from springback.identification.report.replays import replays
from springback.identification.solving.fitting import fit_impact
from springback.identification.solving.profiles import PRECISE, PROFILE_RISE
from springback.scenario.overrides import with_value

FRONT = ("vehicle.arms.directions.0", "vehicle.arms.directions.1")


@pytest.fixture(scope="module")
def found() -> FitResult:
    return rig_fit()


def test_profiles_rise_to_the_ends_of_the_intervals(found: FitResult) -> None:
    [fit] = found.fits
    curves = profile_curves(fit)
    assert [one.unknown.name for one in curves] == list(found.plan.free)
    for one in curves:
        assert np.all(np.diff(one.values) > 0.0)
        middle = int(np.argmin(one.rise))
        assert one.rise[middle] == one.laplace[middle] == 0.0
        assert np.all(np.diff(one.rise[middle:]) > 0.0)
        assert np.all(np.diff(one.rise[: middle + 1]) < 0.0)
        profile = fit.profiles[one.unknown.name]
        for end in (profile.low, profile.high):
            at = int(np.argmin(np.abs(one.values - one.unknown.value(end))))
            assert math.sqrt(one.rise[at] / PROFILE_RISE) == pytest.approx(1.0, abs=2.0 * PRECISE)
        share = one.rise[one.rise > 0.0] / one.laplace[one.rise > 0.0]
        assert np.all((share > 0.7) & (share < 1.3))  # nearly a parabola here
        assert np.all(one.before < 0.1)  # the prior hardly says anything


def test_replays_are_what_was_fitted(found: FitResult) -> None:
    [fit] = found.fits
    channels = {one.reading.name: one for one in replays(fit)}
    errors = fit.problem.errors(fit.point)
    assert list(channels) == [one.name for one in fit.problem.readings]
    for name, one in channels.items():
        assert np.array_equal(one.residuals, errors[name])
        assert one.measured.shape == one.predicted.shape == one.residuals.shape
    force = channels["accelerometer"]
    rest = force.measured - force.predicted
    assert np.nanstd(rest[:, 0]) < 2.0 * force.reading.noise.stationary[0]
    peak = int(np.nanargmin(force.measured[:, 0]))
    assert 0.0 < force.times[peak] < 0.02  # it pushes back, after touch
    assert not force.clipped.any()
    position = channels["vehicle.position"].predicted[:, 0]
    assert abs(position[np.argmin(np.abs(channels["vehicle.position"].times))]) < 1e-12
    assert 5e-3 < position.max() < 0.05  # into the wall by the travel of arms and cage


def test_clipped_samples_are_marked() -> None:
    [fit] = rig_fit("3.5 m/s").fits
    [force] = [one for one in replays(fit) if one.reading.name == "accelerometer"]
    full = fit.problem.chain(force.reading).full_scale
    assert full is not None
    assert 5 < force.clipped[:, 0].sum() < 60
    assert np.all(np.abs(force.measured[force.clipped]) > 0.99 * full)
    assert not force.clipped[force.times < 0.0].any()


def test_what_is_assumed_moves_the_result_as_a_further_fit_does(found: FitResult) -> None:
    """Both arms that touch, 2 degrees more to the outside: to first order, and fitted anew."""
    [fit] = found.fits
    told = {one.name: one for one in assumptions(found.fits)}
    assert told["world.obstacles.0.surface.exponent"].shifts == {}
    assert told["vehicle.body.inertia.2.2"].weight < 0.01  # it cannot turn
    for name in ("vehicle.arms.length", "world.obstacles.0.distance"):
        assert told[name].weight < 0.01  # the start follows
    assert "vehicle.body.mass" not in told  # it is known to some uncertainty
    left, right = (told[name] for name in FRONT)
    for name, shift in left.shifts.items():
        assert shift == pytest.approx(-right.shifts[name], rel=0.02)
    old, outside = fit.problem, {FRONT[0]: left.value, FRONT[1]: right.value}
    tables = old.tables | {"vehicle": old.scenario.vehicle.model_dump(mode="json")}
    for k, (name, value) in enumerate(outside.items()):
        wider = value + math.copysign(math.radians(2.0), value)
        tables = with_value(tables, ("vehicle", "arms", "directions", k), wider, name)
    changed = ImpactProblem(old.plan, old.scenario, tables, old.fields, old.impact)
    again = fit_impact(changed, starts=1, seed=0, profiles=False)
    for name in left.shifts:
        place = old.place[name]
        moved = float(again.point[place] - fit.point[place])
        wanted = left.shifts[name] - right.shifts[name]  # the one to the left, the other right
        assert abs(moved) > 3.0 * fit.deviation(name)
        assert moved == pytest.approx(wanted, rel=0.2)
