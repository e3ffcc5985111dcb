"""A run that diverges says so, keeps the last good state, and never leaves a NaN behind."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

from builders.cases import nonempty
from builders.impacts import flown, towards_wall
from builders.records import record_with
from springback.errors import LedgerWarning
from springback.results.flight import Flight, as_scenario
from springback.scenario import checks
from springback.simulation.flight import fly_many, fly_one
from springback.simulation.measuring.measures import Outcome, outcome_of

DIVERGING = {
    "absurdly stiff surface": ("world.obstacles[0].surface.stiffness=1e30",),
    "speed at the edge of what is read": ("start.velocity=[1e30, 0, 0]",),
    "fast beyond meaning": ("start.velocity=[1e7, 0, 0]",),
    "spun beyond meaning": ("start.angular_velocity=[1e7, 0, 1e7]",),
}


@pytest.fixture(autouse=True)
def unbounded(monkeypatch: pytest.MonkeyPatch) -> None:
    """Numbers that scenarios refuse, as nothing that they take should diverge."""
    monkeypatch.setattr(checks, "check_magnitudes", lambda tables: None)


def is_clean(flight: Flight) -> None:
    """No NaN and no infinity in measures, summary and trajectory."""
    for value in flight.measures.values():
        assert value is None or math.isfinite(value)
    json.dumps(flight.summary(), allow_nan=False)
    for column in flight.columns.values():
        assert np.isfinite(column).all()


@pytest.mark.filterwarnings("ignore::springback.errors.LedgerWarning")  # may be said, too
@pytest.mark.parametrize("vehicle", ["arq", "quad"])
@pytest.mark.parametrize("overrides", DIVERGING.values(), ids=DIVERGING.keys())
def test_divergence_is_an_outcome(vehicle: str, overrides: tuple[str, ...]) -> None:
    """The outcome is named, the flight ends there, and every number is finite."""
    flight = flown(vehicle, *overrides)
    assert flight.outcome is Outcome.NOT_FINITE
    assert not flight.success
    assert flight.end_time < 0.25
    is_clean(flight)


def test_spun_faster_than_the_steps_can_follow_is_said() -> None:
    """Steps follow contacts, so a spin of 1e5 rad/s no longer diverges; its ledger stays open."""
    with pytest.warns(LedgerWarning, match="cannot be trusted"):
        flight = flown("quad", "start.angular_velocity=[1e5, 0, 1e5]")
    assert flight.measures["ledger_open"] == 1.0
    is_clean(flight)


def test_the_last_good_state_is_kept() -> None:
    """Up to the step that fails, the flight is the one that was flying."""
    good = flown("quad", "simulation.duration=0.045")
    bad = flown("quad", "world.obstacles[0].surface.stiffness=1e30")
    assert bad.end_time == pytest.approx(good.touch_time, abs=2e-3)
    assert bad.columns["x"][-1] == pytest.approx(0.68 + 2.0 * bad.t[-1])
    assert bad.columns["vx"][-1] == 2.0
    assert good.outcome is Outcome.IN_CONTACT
    assert bad.measures["energy_end"] == pytest.approx(bad.measures["energy_start"])


def test_diverging_in_one_lane_leaves_its_neighbours_alone() -> None:
    """Lanes share registers, not fates."""
    wild = "world.obstacles[0].surface.stiffness=1e30"
    scenarios = [
        as_scenario(towards_wall("arq", 1.5 + 0.3 * k), (wild,) if k in (1, 4) else ())
        for k in range(6)
    ]
    models = [scenario.flight_model() for scenario in scenarios]
    starts = [scenario.start_state() for scenario in scenarios]
    abreast = fly_many(models, starts, width=4)
    for k, flight in nonempty(enumerate(abreast)):
        expected = Outcome.NOT_FINITE if k in (1, 4) else Outcome.SEPARATED
        assert outcome_of(flight.record) is expected
        single = fly_one(models[k], starts[k], trace=False)
        assert flight.motion == single.motion
        # A lane is looked at once more after it has failed, and then takes no step.
        still = {"step": 0.0}
        assert record_with(flight.record, stepping=still) == record_with(
            single.record, stepping=still
        )
