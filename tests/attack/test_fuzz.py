"""2000 inputs as strangers write them: accepted with finite numbers, or refused in plain lines.

The same on every machine (`derandomize` in ``conftest.py``); ``make fuzz`` goes on with seeds.
"""

from __future__ import annotations

import json
import math
from typing import Any

import pytest
from hypothesis import given, settings

from attack.inputs import (
    PLAN,
    SCENARIOS,
    bounded_memory,
    override_words,
    plan_tables,
    plans,
    put,
    scenario_tables,
    scenario_text,
    scenarios,
    texts,
    timed,
)
from attack.logs import LogFile, log_file, logs
from attack.stored import (
    SUMMARY,
    Changed,
    campaign,
    campaign_files,
    ledgers,
    part_with,
    parts,
    result,
    result_files,
    results,
)
from attack.worlds import WorldFile, world_file, worlds
from springback.campaign import manifest, store
from springback.errors import InputError
from springback.results.sealed_json import with_digest
from springback.scenario import checks

#: Inputs that once brought up a traceback, a warning or a hang: path and value.
FOUND: list[tuple[tuple[str | int, ...], Any]] = [
    (("vehicle", "body", "mass"), 10**400),
    (("vehicle", "body", "mass"), 10**5000),
    (("sensors", "hall", "magnet_radius"), 1e9),
    (("reference",), {"type": "run-up", "speed": 2.0, "wall_distance": 1e308}),
    (("reference",), {"type": "run-up", "speed": 1e308}),
    (("reference",), {"type": "run-up", "speed": 1e-300}),
    (("start", "pitch"), "9**9**9 deg"),
    (("name",), "\x1b[31mred"),
    (("name",), "\ud800"),
    (("name",), "x" * 5000),
    (("world", "obstacles"), [{"type": "wall", "distance": 3.0, "surface": "wall"}] * 3000),
    (("vehicle", "arms", "directions"), [0.001 * k for k in range(3000)]),
    (("simulation", "duration"), 1e300),
    (("clock",), 1e300),
]
#: The same of a scenario with a pilot.
FOUND_ALOFT: list[tuple[tuple[str | int, ...], Any]] = [
    (("sensors",), {"hall": {"magnet_radius": 1e9}}),
    (("vehicle",), {"preset": "quad", "arms": {"stroke": 1e30}}),
]


@pytest.mark.parametrize(("path", "value"), FOUND_ALOFT)
def test_what_was_found_aloft(
    path: tuple[str | int, ...], value: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The output of a sensor that does not change has no inverse: a division by zero.

    Such numbers are refused for their size already.
    """
    monkeypatch.setattr(checks, "check_magnitudes", lambda tables: None)
    with pytest.raises(InputError, match=r"distance: leaves an output that does not change"):
        scenario_tables(put(SCENARIOS[1], path, value))


@pytest.mark.parametrize("lag", [-43067.0, -0.31])
def test_a_lag_far_from_its_sample_is_refused(lag: float) -> None:
    """Was a filter that remembers 8.6 million poses, in 22 GB."""
    path = ("estimator", "kalman", "inertial_lag")
    refused = pytest.raises(InputError, match=r"kalman\.inertial_lag: must be above -0\.305 s")
    with bounded_memory(), refused:
        scenario_tables(put(SCENARIOS[3], path, lag))
    assert timed(scenario_tables, put(SCENARIOS[3], path, -0.304))


def test_a_run_up_without_gravity_is_refused() -> None:
    """Was a warning of 0/0, and then any run-up."""
    with pytest.raises(
        InputError,
        match=r"world\.gravity: must be more than 0",
    ):
        scenario_tables(put(SCENARIOS[3], ("world", "gravity"), 0.0))


@pytest.mark.parametrize(
    ("path", "value"), FOUND, ids=[".".join(map(str, path)) for path, _ in FOUND]
)
def test_what_was_found_before(path: tuple[str | int, ...], value: Any) -> None:
    tables = {
        key: entry
        for key, entry in SCENARIOS[0].items()
        if path != ("reference",) or key != "thrust"
    }
    timed(scenario_tables, put(tables, path, value))


@pytest.mark.parametrize(
    "change",
    [
        {"scenario": "x" * 5000},
        {"scenario": "a\x00b"},
        {"vary": [{"field": "start.pitch", "from": 0, "to": 1, "step": 1e-13}], "method": "grid"},
        {"vary": [{"field": "start.pitch", "from": 0, "to": 1, "step": 5e-324}], "method": "grid"},
        {
            "vary": [{"field": "start.pitch", "from": 0, "to": 1, "count": 100_000_000}],
            "method": "grid",
        },
        {"vary": [{"field": "start.pitch", "values": [0.1]}] * 3000},
        {"vary": [{"field": "start.pitch", "from": math.nan, "to": 1}]},
        {"vary": [{"field": "vehicle.name", "values": [[[1]], {"a": 1}]}]},
    ],
)
def test_plans_that_were_found_before(change: dict[str, Any]) -> None:
    tables = PLAN | {"scenario": SCENARIOS[0], "samples": 5} | change
    if tables["method"] == "grid":
        del tables["samples"]
    assert not timed(plan_tables, tables)


@settings(max_examples=800)
@given(scenarios())
def test_scenarios(tables: dict[str, Any]) -> None:
    timed(scenario_tables, tables)


@settings(max_examples=300)
@given(texts())
def test_files(text: str) -> None:
    timed(scenario_text, text)


@settings(max_examples=300)
@given(override_words())
def test_overrides(words: tuple[str, ...]) -> None:
    timed(scenario_tables, SCENARIOS[0], words)


@settings(max_examples=320)
@given(plans())
def test_plans(tables: dict[str, Any]) -> None:
    timed(plan_tables, tables)


def test_stored_data_without_what_is_needed_is_refused_by_name() -> None:
    """Were a KeyError of `contacts` and one of `name`, though their digests fit."""
    summary = json.loads(result()[1][SUMMARY])
    del summary["measures"]["contacts"]
    with pytest.raises(InputError, match=r"measures\.contacts: is missing"):
        result_files(Changed([], {SUMMARY: json.dumps(with_digest(summary)).encode()}))
    for path, value, said in (
        (("arms", "directions"), [0.8, -0.8, 3.0], "with 4 arms; that of the scenario has 3"),
        (("hull",), False, "with a hull; that of the scenario has none"),
    ):
        summary = json.loads(result()[1][SUMMARY])
        summary = put(summary, ("scenario", "vehicle", *path), value)
        with pytest.raises(InputError, match=said):
            result_files(Changed([], {SUMMARY: json.dumps(with_digest(summary)).encode()}))
    about = json.loads(campaign()[1][store.METADATA])
    for name in store._NEEDED:
        less = {key: value for key, value in about.items() if key != name}
        with pytest.raises(InputError, match=f"{name}: is missing"):
            campaign_files(Changed([], {store.METADATA: json.dumps(with_digest(less)).encode()}))


def test_a_manifest_that_tells_fewer_flights_than_its_part_has_rows_is_refused() -> None:
    """Was believed, though its digest fits: `query` gave rows that the manifest did not know."""
    lines = [json.loads(line) for line in campaign()[1][manifest.NAME].splitlines()]
    first = with_digest({**lines[0], "last": 1})
    text = b"\n".join(json.dumps(line).encode() for line in [first, *lines[1:]]) + b"\n"
    with pytest.raises(InputError, match=r"has \d+ rows; manifest.jsonl says 1"):
        campaign_files(Changed([], {manifest.NAME: text}))


@settings(max_examples=500)
@given(worlds())
def test_worlds(given_file: WorldFile) -> None:
    timed(world_file, given_file)


@settings(max_examples=400)
@given(logs())
def test_logs(given_file: LogFile) -> None:
    timed(log_file, given_file)


@settings(max_examples=120)
@given(results())
def test_results(changed: Changed) -> None:
    timed(result_files, changed)


@settings(max_examples=80)
@given(ledgers())
def test_ledgers(changed: Changed) -> None:
    timed(campaign_files, changed)


@settings(max_examples=80)
@given(parts())
def test_parts(changed: Changed) -> None:
    timed(campaign_files, changed)


def test_a_summary_of_rows_that_no_flight_has_is_refused() -> None:
    """Was a warning from within NumPy's quantiles, though all digests fit."""
    changed = part_with({"excursion": math.inf})
    with pytest.raises(InputError, match="column excursion: must be finite numbers below"):
        campaign_files(changed, summed=True)
