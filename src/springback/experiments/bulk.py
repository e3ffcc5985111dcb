"""Flights by the thousand: outcomes and measures of many scenarios, flown abreast."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.errors import InputError
from springback.experiments.guidance import Board, board_of
from springback.experiments.recovery_measures import (
    RECOVERY_MEASURES,
    judged,
    recovery_measures,
    recovery_outcome,
)
from springback.experiments.scenario import Scenario, scenario_from
from springback.simulation.abreast import fly_guided_many
from springback.simulation.flight import Flown, fly_many
from springback.simulation.guided import GuidedFlown, noise_table, ticks_of
from springback.simulation.measures import MEASURES, measures_of, outcome_of
from springback.simulation.record import Model
from springback.vehicle.state import State

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Outcome of a flight that was not flown, because its scenario cannot be.
REFUSED = "refused"


class Rows(NamedTuple):
    """What is kept of many flights, in their order."""

    outcomes: list[str]
    """Words of `springback.simulation.measures.Outcome`, or `REFUSED`."""
    measures: dict[str, Array]
    """Of each flight, all of `MEASURES` and `RECOVERY_MEASURES`; NaN for what did not happen."""
    problems: list[str]
    """Why a flight was refused; empty for those that were not."""


class _Ready(NamedTuple):
    """A flight made ready; without a pilot it has no board."""

    scenario: Scenario
    model: Model
    start: State
    board: Board | None


def fly_scenarios(
    tables: Sequence[Mapping[str, Any]],
    *,
    threads: int = 1,
    progress: Callable[[float], None] | None = None,
) -> Rows:
    """Fly many scenarios; each flight's numbers depend on its own tables alone.

    Args:
        tables: Whole scenarios, as plain tables.
        threads: That fly at a time.
        progress: Called now and then with the share done.
    """
    outcomes, problems = [REFUSED] * len(tables), [""] * len(tables)
    measures = {name: np.full(len(tables), math.nan) for name in (MEASURES | RECOVERY_MEASURES)}
    kinds: dict[Any, list[tuple[int, _Ready]]] = {}
    for k, table in enumerate(tables):
        try:
            one = _made_ready(table)
        except InputError as error:
            problems[k] = "; ".join(error.problems)
            continue
        kinds.setdefault(_kind(one), []).append((k, one))
    done = 0
    for members in kinds.values():
        flown = _flown([one for _, one in members], threads)
        for (k, _), (word, values) in zip(members, flown, strict=True):
            outcomes[k] = word
            for name, value in values.items():
                measures[name][k] = math.nan if value is None else value
        done += len(members)
        if progress is not None:
            progress(done / len(tables))
    return Rows(outcomes, measures, problems)


def _made_ready(table: Mapping[str, Any]) -> _Ready:
    scenario = scenario_from(table, False)
    model, start = scenario.flight_model(), scenario.start_state()
    aloft = scenario.reference is not None
    return _Ready(scenario, model, start, board_of(scenario, model, start) if aloft else None)


def _kind(one: _Ready) -> Any:
    """Flights of one kind can fly abreast."""
    cabin = one.board.cabin if one.board else None
    pace = cabin.guidance.period if cabin else None
    return _types(one.model), _types(cabin), one.model.timing.until, pace


def _types(tree: Any) -> Any:
    if not isinstance(tree, tuple):
        return None
    return (type(tree).__name__, *(_types(branch) for branch in tree))


def _flown(flights: list[_Ready], threads: int) -> list[tuple[str, dict[str, float | None]]]:
    models, starts = [one.model for one in flights], [one.start for one in flights]
    boards = [one.board for one in flights if one.board]
    if not boards:
        return [_plain(one) for one in fly_many(models, starts, threads=threads)]
    ticks = ticks_of(models[0].timing.until, boards[0].cabin.guidance.period)
    noises = [
        noise_table(one.scenario.seed, 0, ticks, board.noise)
        for one, board in zip(flights, boards, strict=True)
    ]
    cabins = [board.cabin for board in boards]
    flown = fly_guided_many(models, starts, cabins, noises, threads=threads)
    return [_judged(one) for one in flown]


def _plain(flown: Flown) -> tuple[str, dict[str, float | None]]:
    return outcome_of(flown.record).word, measures_of(flown)


def _judged(guided: GuidedFlown) -> tuple[str, dict[str, float | None]]:
    if not judged(guided):
        return _plain(guided.flown)
    return recovery_outcome(guided).word, measures_of(guided.flown) | recovery_measures(guided)
