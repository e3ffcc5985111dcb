"""Lengths of arms at the end of what their sensors can tell: clipped, and no errors."""

from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from identification.rigs import SPRING, TRUE, problem_of, recorded, rig
from springback.identification.replays.errors import channel_errors, error_rows, remarks
from springback.identification.replays.replay import replay
from springback.identification.solving.fitting import fit_impact
from springback.logs.recording import ARM_LENGTH, Recording
from springback.logs.writing.flight_recording import flight_recording
from springback.results.flight import fly
from springback.scenario.scenario import scenario_from

#: Of ARQ's rig, which presses its arms by 18 mm from 190 mm.
SHORTEST = 0.18
OPENING: dict[str, Any] = {
    "name": "opening", "vehicle": "xplorer", "thrust": "hover",
    "sensors": {"imu": {"rate": "1 kHz", "accelerometer": {"noise": "0.022 m/s^2/Hz^0.5"}}},
    "start": {"position": ["0.5 m", 0, "1 m"], "velocity": ["2 m/s", 0, 0]},
    "world": {"obstacles": [{"type": "wall", "distance": "1.5 m", "surface": "wall"}]},
    "simulation": {"duration": "0.8 s"},
}  # fmt: skip


def of_arms(recording: Recording) -> Any:
    return recording.best(ARM_LENGTH)


def with_end(recording: Recording, shortest: float, *, told: bool) -> Recording:
    """As sensors of the arms would have it that can tell no shorter length."""
    channels = []
    for one in recording.channels:
        if one.quantity == ARM_LENGTH:
            flags = one.values <= shortest if told else None
            one = replace(one, values=np.maximum(one.values, shortest), clipped=flags)
        channels.append(one)
    return replace(recording, channels=tuple(channels))


@cache
def opening() -> Recording:
    return flight_recording(fly(scenario_from(OPENING)), Path("own"))


@cache
def arq() -> Recording:
    return recorded(rig("arq"), arms=True)


def test_hinged_arms_that_open_are_replayed_within_the_uncertainty() -> None:
    """Before, a sensor ended 2 mm beyond the free length: 62 mm of error, 36 uncertainties."""
    arms = of_arms(opening())
    assert arms.values.max() > 0.18 + 0.04
    assert not arms.clipped.any()
    flown = replay(scenario_from(OPENING), OPENING, [opening()])
    rows = error_rows(flown, channel_errors(flown))
    beyond = [row for row in rows if row.what == ARM_LENGTH and row.part == "all" and row.is_beyond]
    assert [row.wanted for row in rows if row.what == ARM_LENGTH and row.part == "all"]
    assert not beyond


@pytest.mark.parametrize("told", [True, False])
def test_a_replay_takes_readings_at_the_end_as_clipped(told: bool) -> None:
    tables = rig("arq")
    log = with_end(arq(), SHORTEST, told=told)
    flown = replay(scenario_from(tables), tables, [log])
    rows = error_rows(flown, channel_errors(flown))
    [stroke] = [row for row in rows if row.what.startswith("largest compression")]
    said = [text for text in remarks(flown, rows) if "end of their range" in text]
    assert stroke.is_beyond != told
    assert bool(said) == told
    if told:
        assert stroke.recorded == pytest.approx(0.01, abs=2e-3)


def test_a_fit_takes_readings_at_the_end_as_clipped() -> None:
    """Of the log or of the plan; taken as lengths they make the springs stiffer than they are."""
    found = {}
    free = {SPRING: "factor 4"}
    for how in ("log", "plan", "ignored"):
        told = {"sensors": {"arm_length": {"shortest": SHORTEST}}} if how == "plan" else {}
        log = with_end(arq(), SHORTEST, told=how == "log")
        fit = fit_impact(problem_of(rig("arq"), log, free, **told), starts=2, seed=0)
        [estimate] = [one for one in fit.problem.fields if one.name == SPRING]
        found[how] = float(estimate.value(fit.point[0])) / TRUE[SPRING]
    assert found["log"] == pytest.approx(1.0, abs=1e-3)
    assert found["plan"] == pytest.approx(found["log"], rel=1e-6)
    assert abs(found["ignored"] - 1.0) > 3e-3
