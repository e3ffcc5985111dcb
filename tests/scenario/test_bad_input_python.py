"""Slips in Python are told as those in files are: one line, no traceback from inside."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

import springback
from springback.errors import InputError
from springback.results.flight import as_scenario, fly
from springback.scenario.files import read_scenario

CALLS = {
    "executor": (lambda: fly({"vehicle": "arq"}, executor="gpu"), "executor must be 'compiled'"),
    "pilot": (lambda: fly({"vehicle": "arq"}, pilot=3), r"pilot must be a function .*\(got 3\)"),
    "scenario": (lambda: fly(3), r"scenario must be a Scenario, tables, or .* \(got 3\)"),
    "plan": (
        lambda: springback.Plan(scenario={"vehicle": "arq"}, method="sobool"),
        r"^method: must be .*'sobol'.*\(got 'sobool'\); did you mean sobol\?$",
    ),
    "wall": (
        lambda: springback.Wall(type="wall", distance=1.0, surface=3), r"^surface: must be a table",
    ),
    "override": (lambda: fly({"vehicle": "arq"}, 3), "3 is not an override"),
    "overrides": (lambda: read_scenario("s.toml", "start.pitch=3"), "must be a list of words"),
    "file": (lambda: read_scenario(3), r"path of a TOML file \(got 3\)"),
    "campaign": (lambda: springback.run_campaign(3, "x"), r"must be a springback.Plan \(got 3\)"),
    "pilot to check": (lambda: springback.check_pilot(3), r"pilot must be a function .*\(got 3\)"),
    "no pilot to check": (lambda: springback.check_pilot(None), "pilot must be given"),
    "restitution": (lambda: springback.restitution(-1.0, 2.0), r"at least 0 s/m \(got -1 s/m\)"),
    "restitution at speed": (lambda: springback.restitution(0.4, -2.0), "at least 0 m/s"),
    "changed inside": (
        lambda: springback.ARQ.vehicle.model_copy(update={"arms": {"length": "2 kg"}}),
        r"^arms\.length: has the wrong unit \(got '2 kg'\)",
    ),
    "changed wrongly": (
        lambda: springback.ARQ.vehicle.arms.model_copy(update={"stifness": 2e3}),
        r"^stifness: unknown key; did you mean stiffness\?$",
    ),
    "changed too far": (
        lambda: springback.ARQ.vehicle.body.model_copy(update={"mass": -1.0}),
        r"^mass: must be more than 0 kg \(got -1 kg\)$",
    ),
}  # fmt: skip


@pytest.mark.parametrize(("call", "said"), CALLS.values(), ids=CALLS.keys())
def test_slips_in_python_are_told_in_one_line(call: Callable[[], object], said: str) -> None:
    """As those in a file: an `InputError`, no traceback from inside, no address of a web page."""
    with pytest.raises(InputError, match=said) as caught:
        call()
    assert len(str(caught.value).splitlines()) == 1
    assert "http" not in str(caught.value)


def test_changed_copies_are_read_as_files_are() -> None:
    """Units are understood; the rest stays as it was."""
    arms = springback.ARQ.vehicle.arms
    softer = arms.model_copy(update={"stiffness": "2 N/mm"})
    assert softer.stiffness == 2000.0
    assert softer.model_copy(update={"stiffness": arms.stiffness}) == arms


def test_a_copy_changes_the_keys_of_an_inner_table_that_are_named() -> None:
    """As a file laid over a preset does: what is not named stays, and is not set to its default."""
    arq = springback.ARQ.vehicle
    softer = arq.model_copy(update={"arms": {"stiffness": "2 N/mm"}})
    assert softer.arms.stiffness == 2000.0
    assert softer == arq.model_copy(update={"arms": softer.arms})
    assert softer.arms.model_copy(update={"stiffness": arq.arms.stiffness}) == arq.arms


@pytest.mark.parametrize(
    "ask", [springback.plot, springback.Flight.to_dataframe, springback.Flight.to_xarray]
)
def test_a_flight_without_its_trajectory_says_so(ask: Callable[[Any], Any]) -> None:
    tables = {"vehicle": "arq", "simulation": {"duration": 2e-3}}
    flight = fly(tables, trajectory=False, executor="python")
    with pytest.raises(InputError, match="has no trajectory: fly it with trajectory=True"):
        ask(flight)


def test_tables_in_python_are_checked_alike() -> None:
    """Plain tables have no file, so only the path is given."""
    tables = {"vehicle": {"preset": "arq", "body": {"mass": -1.0}}}
    with pytest.raises(InputError, match=r"^vehicle\.body\.mass: must be more than 0 kg"):
        as_scenario(tables)
    with pytest.raises(InputError, match=r"override vehicle\.body\.mass=-2"):
        fly({"vehicle": "arq"}, "vehicle.body.mass=-2")


def test_a_ready_scenario_takes_no_overrides() -> None:
    """It has been checked; a changed copy would not be."""
    with pytest.raises(InputError, match="overrides"):
        fly(as_scenario({"vehicle": "arq"}), "vehicle.body.mass=2")
