"""The benchmarks' own arithmetic, tables and figures; no rival is needed here, and nothing timed."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from pathlib import Path
from typing import Any

import protocol
import pytest
import springback_flights
from benchmarks import growth
from benchmarks.rivals import environments, impacts
from benchmarks.rivals.contenders import STEP, Contender, free_flight
from benchmarks.rivals.figure import contest_figure
from benchmarks.rivals.report import markdown, ratios, summarised
from benchmarks.rivals.rounds import Failed, Field, Settings, run

from springback.interfaces.figures.style import png
from springback.scenario.scenario import scenario_from

OURS = "springback, run-up, impact, recovery, complementary"
ROTORPY, CRAZYFLOW = "RotorPy, one by one, 100 Hz", "Crazyflow, contact flags at 100 Hz"


def row(kind: str, rates: list[float]) -> dict[str, Any]:
    """A contender that flew so many flights a second in each round."""
    fixed = {"latency": 0.01, "import": 0.5, "first flight": 1.5, "memory": 300.0}
    return {
        "kind": kind, "rates": "1 kHz", "differs": "nothing", "versions": {"thing": "1.0"},
        "best": [2, 64], "sweep": [], "missed": 0.01, "outcomes": {"recovered": 3},
        "rounds": [{"flights per second": rate, **fixed} for rate in rates],
    }  # fmt: skip


def report(**contenders: dict[str, Any]) -> dict[str, Any]:
    """A contest that was held."""
    found = {
        "rounds": 3, "threads": 2, "quick": False, "contenders": contenders, "accuracy": {},
        "skipped": {"Absent": "cannot be installed here: no such package"}, "installed": {},
        "cold start": {OURS: {"import": 0.1, "first flight": 60.0}},
    }  # fmt: skip
    return {"machine": {"processor": "A Machine, 2 cores, 2 used"}, **summarised(found)}


def contest() -> dict[str, Any]:
    return report(
        **{
            OURS: row("collision", [1500.0, 3000.0, 900.0]),
            ROTORPY: row("flight", [1.0, 1.5, 0.5]),
            CRAZYFLOW: row("flight", [700.0, 600.0, 650.0]),
            "springback, impact, coarsest step within 1 %": row("impact", [12e3, 11e3, 13e3]),
            "MuJoCo rollout, RK4": row("impact", [100.0, 120.0, 110.0]),
        }
    )


def test_ratios_are_medians_of_those_within_a_round() -> None:
    """1500, 2000 and 1800 within rounds; the ratio of the medians would be 1500."""
    found = {r["theirs"]: r for r in contest()["ratios"]}
    assert found[ROTORPY]["median"] == pytest.approx(1800.0)
    assert found[ROTORPY]["reached"] is True
    assert found["MuJoCo rollout, RK4"]["median"] == pytest.approx(118.2, rel=1e-3)


def test_ratios_compare_seconds_of_flight_not_flights() -> None:
    """An impact lasts 0.15 s, a flight with a pilot 6 s."""
    name = "springback, impact, default step"
    held = report(**{name: row("impact", [40.0]), "MuJoCo rollout, RK4": row("flight", [1.0])})
    assert ratios(held["contenders"])[0]["median"] == pytest.approx(1.0)
    assert horizon_of(held, name) == pytest.approx(40.0 * impacts.HORIZON)


def horizon_of(held: dict[str, Any], name: str) -> float:
    figures = held["contenders"][name]["figures"]
    return float(figures["flight-seconds per second"]["median"])


def test_the_fastest_of_a_rivals_ways_is_the_one_compared_with() -> None:
    slow, fast = row("flight", [1.0]), row("flight", [5.0])
    names = {"Crazyflow, contact flags at 500 Hz": slow, CRAZYFLOW: fast}
    held = report(**{OURS: row("collision", [10.0]), **names})
    assert [(r["theirs"], r["median"]) for r in held["ratios"]] == [(CRAZYFLOW, 2.0)]


def test_a_missed_target_is_called_missed() -> None:
    held = report(**{OURS: row("collision", [10.0]), ROTORPY: row("flight", [1.0])})
    assert "**missed**" in markdown(held)
    assert "**missed**" not in markdown(contest())


def test_report_names_machine_everybody_and_who_is_absent() -> None:
    text = markdown(contest())
    for said in ("A Machine, 2 cores", OURS, ROTORPY, "Absent", "no such package", "3 recovered"):
        assert said in text
    assert json.loads(json.dumps(contest())) == contest()


def test_figure_has_a_bar_for_everybody() -> None:
    figure = contest_figure(contest())
    labels = [tick.get_text() for axes in figure.axes for tick in axes.get_yticklabels()]
    assert sorted(labels) == sorted(contest()["contenders"])
    assert png(figure).startswith(b"\x89PNG")


def test_the_coarsest_step_whose_worst_error_is_small_is_chosen() -> None:
    errors = [[1e-3, [0.0, 0.02, 0.0]], [1e-4, [0.0, 0.001, 0.0]], [5e-4, [0.009, 0.0, 0.0]]]
    assert impacts.chosen({"errors": errors})[0] == 5e-4
    with pytest.raises(ValueError, match="no step"):
        impacts.chosen({"errors": errors[:1]})


def test_contenders_have_names_of_their_own_and_tries_that_can_be_shared_out() -> None:
    everybody = free_flight(2)
    assert len({c.name for c in everybody}) == len(everybody)
    assert all(flights % processes == 0 for c in everybody for processes, flights in c.tries)
    assert {c.environment for c in everybody} - {""} <= set(environments.RECIPES)


def test_a_rival_that_cannot_be_installed_leaves_nothing_and_says_why(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuses(command: Any, **_: Any) -> None:
        said = "Collecting thing\nERROR: No matching distribution found for thing==9\n"
        raise subprocess.CalledProcessError(1, command, "", said)

    monkeypatch.setenv(environments.VARIABLE, str(tmp_path))
    monkeypatch.setattr(environments.subprocess, "run", refuses)
    monkeypatch.setattr(environments.venv, "create", lambda home, with_pip: home.mkdir())
    with pytest.raises(environments.Missing, match="No matching distribution found for thing==9"):
        environments.made(environments.Recipe("thing", ("thing==9",)), lambda _: None)
    assert list(tmp_path.iterdir()) == []


def _program(folder: Path, monkeypatch: pytest.MonkeyPatch, text: str) -> Contender:
    (folder / "theirs.py").write_text(text)
    monkeypatch.setattr("benchmarks.rivals.rounds.PROGRAMS", folder)
    return Contender("Theirs", "flight", "theirs", "", ((1, 1),), {"task": STEP}, "", "")


def test_a_program_that_fails_is_left_out_with_its_last_words(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    theirs = _program(tmp_path, monkeypatch, "raise SystemExit('no wings')")
    field = Field(Settings(1, 2), lambda _: None)
    field.enter(theirs)
    assert field.skipped == {"Theirs": "no wings"}
    assert field.rows == {}


def test_a_flight_that_does_not_reach_its_target_does_not_count(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    theirs = _program(tmp_path, monkeypatch, 'print("""{"missed": 0.8, "many": []}""")')
    with pytest.raises(Failed, match=r"0\.80 m from its target"):
        run(theirs, sys.executable, 2, [])


def test_a_crew_shares_out_tasks_in_order_and_many_flies_all_places() -> None:
    crew = protocol.Crew(2, math.sqrt)
    assert crew.each([4.0, 9.0]) == [2.0, 3.0]
    crew.close()
    flown: list[int] = []

    def work(asked: Any) -> float:
        flown.append(len(asked[1]))
        return 0.5

    found, missed = protocol.many({"tries": [[1, 5]]}, work)
    assert flown == [5, 5]  # once before the clock runs
    assert found[0]["flights"] == 5
    assert missed == 0.5


def test_flights_start_at_places_of_their_own_not_far_away() -> None:
    places = protocol.scatter(100)
    assert len(set(places)) == 100
    assert max(math.hypot(*place) for place in places) <= 0.1


@pytest.mark.parametrize(("arms", "obstacles"), [(3, 1), (6, 4), (8, 8)])
def test_growing_scenarios_have_as_many_arms_and_obstacles_as_asked(
    arms: int, obstacles: int
) -> None:
    job = {"task": {**STEP, "duration": 1.0}, "estimator": "complementary"}
    asked = {**job, "arms": arms, "obstacles": obstacles}
    first, second = springback_flights.collision_tables(asked, 2)
    scenario = scenario_from(first)
    assert scenario.vehicle.arm_count == arms
    assert len(scenario.world.obstacles) == obstacles
    assert first["vehicle"] is second["vehicle"]
    assert first["seed"] != second["seed"]


def test_growth_varies_one_thing_at_a_time_and_draws_all_of_them() -> None:
    made = growth.points(growth.GROWTH)
    for point in made:
        others = {n: v for n, v in point._asdict().items() if n not in ("varied", point.varied)}
        assert others == {n: v for n, v in growth.USUAL.items() if n != point.varied}
    spread = {"median": 2.0, "lowest": 1.0, "highest": 4.0}
    held = {
        "machine": {"processor": "A Machine"}, "rounds": 3, "usual": growth.USUAL,
        "estimator": "complementary",
        "points": [{**p._asdict(), "ms per flight-second": spread, "MiB": spread} for p in made],
    }  # fmt: skip
    assert len(growth.growth_figure(held).axes) == 2 * len(growth.GROWTH)
    assert "| duration | 30 | 2 (1 to 4) | 500 | 2 MiB |" in growth.markdown(held)
