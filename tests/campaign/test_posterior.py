"""Campaigns over a posterior: whole rows, by each method, reproducibly; and values laid over."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from builders.plans import SPEED, plan
from springback.campaign.design.layout import Design, design_of, lay_out
from springback.campaign.design.plan import read_plan
from springback.campaign.design.posterior import NOTE
from springback.errors import InputError
from springback.results.parquet import write_parquet

METHODS = ("random", "latin-hypercube", "sobol")
STIFFNESS, DAMPING = "vehicle.arms.stiffness", "vehicle.arms.damping"
UNITS = {STIFFNESS: "N/m", DAMPING: "N s/m"}
#: Rows that hang together: damping follows stiffness.
ROWS = 16
DRAWS = {
    STIFFNESS: tuple(4000.0 + 100.0 * k for k in range(ROWS)),
    DAMPING: tuple(80.0 + 2.0 * k for k in range(ROWS)),
}


def posterior(folder: Path, draws: Any = DRAWS, units: Any = UNITS, note: bool = True) -> Path:
    """A file as a fit writes it."""
    path = folder / "posterior.parquet"
    columns = {name: np.array(values) for name, values in draws.items()}
    write_parquet(path, columns, units, {NOTE: "16 draws"} if note else {})
    return path


def design(**given: Any) -> Design:
    usual = {"posterior": {"draws": DRAWS}, "vary": [SPEED], "samples": ROWS, "robots": ["arq"]}
    return lay_out(plan(**usual | given))


def rows_of(made: Design) -> list[tuple[float, float]]:
    columns = made.slice(0, made.flights).columns
    return list(zip(columns["stiffness"], columns["damping"], strict=True))


@pytest.mark.parametrize("method", METHODS)
def test_rows_stay_whole_and_reach_the_scenario(method: str) -> None:
    made = design(method=method)
    known = set(zip(*DRAWS.values(), strict=True))
    assert set(rows_of(made)) <= known
    assert len(set(rows_of(made))) > ROWS // 3
    flights = made.slice(0, made.flights)
    for tables, (stiffness, damping) in zip(flights.tables, rows_of(made), strict=True):
        arms = tables["vehicle"]["arms"]
        assert (arms["stiffness"], arms["damping"]) == (stiffness, damping)
    if method != "random":  # as many samples as rows: each of them once
        assert set(rows_of(made)) == known
    assert len(set(flights.columns["speed"])) == ROWS  # the speed is drawn beside it
    assert abs(np.corrcoef(flights.columns["speed"], flights.columns["stiffness"])[0, 1]) < 0.7


@pytest.mark.parametrize("method", METHODS)
def test_rows_are_the_same_alone_and_in_company_and_after_storing(method: str) -> None:
    made = design(method=method, repeats=2, robots=["arq", "quad"])
    whole = rows_of(made)
    again = design_of(made.plan.canonical())
    assert [one.column for one in again.dimensions] == [one.column for one in made.dimensions]
    for first, last in ((0, 3), (5, 6), (17, 40)):
        part = again.slice(first, last)
        pairs = list(zip(part.columns["stiffness"], part.columns["damping"], strict=True))
        assert pairs == whole[first:last]
    samples = [whole[4 * k : 4 * k + 4] for k in range(ROWS)]
    assert all(len(set(one)) == 1 for one in nonempty(samples))  # of robots and of repeats
    assert rows_of(design(method=method, seed=4)) != rows_of(design(method=method))


def test_on_a_grid_each_flight_draws_its_row() -> None:
    made = design(method="grid", samples=None, vary=[SPEED | {"count": 5}], repeats=8)
    assert made.flights == 40
    pairs = rows_of(made)
    assert set(pairs) <= set(zip(*DRAWS.values(), strict=True))
    assert len(set(pairs)) > ROWS // 2
    assert pairs[:8] != pairs[8:16]


def test_a_file_is_read_into_the_plan_whose_digest_is_of_its_content(tmp_path: Path) -> None:
    posterior(tmp_path)
    (tmp_path / "throw.toml").write_text('vehicle = "arq"\nthrust = "hover"\n')
    path = tmp_path / "plan.toml"
    head = 'scenario = "throw.toml"\nmethod = "random"\nsamples = 5\n'
    path.write_text(head + 'posterior = "posterior.parquet"\n')
    first, source = read_plan(path)
    assert first.posterior is not None
    assert first.posterior.draws == DRAWS
    made = rows_of(lay_out(first, source))
    posterior(tmp_path, DRAWS | {DAMPING: tuple(x + 0.5 for x in DRAWS[DAMPING])})
    second, _ = read_plan(path)
    assert second.digest() != first.digest()
    (tmp_path / "posterior.parquet").unlink()
    assert rows_of(design_of(first.canonical())) == made  # as when a row is flown again
    with pytest.raises(InputError, match=r"plan.toml:4: posterior: there is no file .*posterior"):
        read_plan(path)
    posterior(tmp_path)
    path.write_text(head + f'[posterior]\nfile = "posterior.parquet"\nfields = ["{DAMPING}"]\n')
    third, source = read_plan(path)
    assert lay_out(third, source).units == {"damping": "N s/m"}


def test_plans_without_one_keep_their_digest() -> None:
    assert "posterior" in plan().model_dump()
    bare = plan().model_dump(mode="json", exclude={"name", "keep", "posterior", "overlay"})
    text = json.dumps(bare, sort_keys=True, ensure_ascii=False, allow_nan=False)
    assert plan().digest() == hashlib.sha256(text.encode()).hexdigest()


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"draws": DRAWS | {DAMPING: (90.0,)}}, "posterior.draws: must have at least one value"),
        ({"draws": {STIFFNESS: (5e3, float("nan"))}}, "posterior.draws.*finite"),
        ({"draws": DRAWS, "file": "x"}, "posterior: needs one of: file, draws"),
        ({"draws": {"vehicle.arms.stifness": (5e3,)}}, "stifness: .*did you mean stiffness"),
        ({"draws": {"vehicle.arms.cages": (1.0,)}}, "cages: is no number"),
        ({"draws": {STIFFNESS: (5e3, -1.0)}}, r"stiffness = -1: .*more than 0"),
        ({"draws": DRAWS, "units": {STIFFNESS: "kg"}}, r"stiffness: is in kg, the scenario's in N/m"),
        ({"draws": {"vehicle.preset": (1.0,)}}, "cannot be varied; name presets under robots"),
        (3, "posterior: must be the path of a file, or a table"),
    ],
)  # fmt: skip
def test_what_is_no_posterior_is_refused_in_one_line(given: Any, said: str) -> None:
    with pytest.raises(InputError, match=said) as caught:
        design(posterior=given)
    assert len(caught.value.problems) == 1


def test_a_field_is_drawn_or_varied_not_both() -> None:
    twice = [SPEED, {"field": "stiffness", "from": 4000.0, "to": 5000.0}]
    with pytest.raises(InputError, match="posterior: stiffness: is varied by entry 2 of vary, too"):
        design(vary=twice)
    named = [SPEED | {"name": "damping"}]
    with pytest.raises(InputError, match=r"posterior: 'damping' as a name of a column .*entry 1"):
        design(vary=named)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"note": False}, "is no posterior: springback identify fit did not write it"),
        ({"draws": {STIFFNESS: (5e3, float("inf"))}}, "is no posterior: .*row 1 must be finite"),
        ({"draws": {STIFFNESS: ("a", "b")}}, "its column .* holds no numbers"),
    ],
)
def test_a_file_that_is_no_posterior_is_refused_by_name(
    given: Any, said: str, tmp_path: Path
) -> None:
    path = posterior(tmp_path, **given)
    with pytest.raises(InputError, match=said):
        design(posterior=str(path))
    path.write_bytes(b"PAR1 but no more")
    with pytest.raises(InputError, match=r"posterior.parquet is no posterior: it cannot be read"):
        design(posterior=str(path))
    with pytest.raises(InputError, match=r"has no file|there is no file"):
        design(posterior=str(path) + "x")


def test_values_of_an_overlay_lie_under_overrides_and_over_the_scenario(tmp_path: Path) -> None:
    (tmp_path / "identified.toml").write_text(
        f'name = "x"\n[values]\n"{STIFFNESS}" = 4321.0\n"{DAMPING}" = 76.5\n'
    )
    (tmp_path / "throw.toml").write_text('vehicle = "arq"\nthrust = "hover"\n')
    path = tmp_path / "plan.toml"
    path.write_text(
        'scenario = "throw.toml"\noverlay = "identified.toml"\nmethod = "random"\nsamples = 5\n'
    )
    read, source = read_plan(path)
    [scenario] = lay_out(read, source).full_scenarios
    arms = scenario["vehicle"]["arms"]
    assert (arms["stiffness"], arms["damping"]) == (4321.0, 76.5)
    assert read.overlay is None  # it is in the scenario, and so in the digest
    read, source = read_plan(path, [f"scenario.{STIFFNESS}=5000"])
    [scenario] = lay_out(read, source).full_scenarios
    assert scenario["vehicle"]["arms"]["stiffness"] == 5000.0
    assert scenario["vehicle"]["arms"]["damping"] == 76.5
    (tmp_path / "identified.toml").write_text('name = "x"\n')
    with pytest.raises(InputError, match=r"plan.toml:2: overlay: .*identified.toml: is no overlay"):
        read_plan(path)
