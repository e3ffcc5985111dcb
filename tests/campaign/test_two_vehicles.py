"""Campaigns of two vehicles: rows of both, the same as flown alone, stopped and resumed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from builders.cases import nonempty
from builders.pairs import two, vehicle
from springback.batch.pair import fly_pair
from springback.campaign.access import Campaign
from springback.campaign.design.layout import lay_out
from springback.campaign.design.plan import Plan, read_plan
from springback.campaign.flying import fly_chunk, rows, try_code
from springback.campaign.running import run_campaign
from springback.campaign.store import open_store
from springback.errors import InputError
from springback.scenario.scenario import scenario_from


def plan(**given: Any) -> Plan:
    """Meetings at different speeds of the second, one of them in the first vehicle."""
    speed = {"field": "second.start.velocity.0", "name": "approach", "values": [-1.0, -1.4]}
    aside = {"field": "second.start.position.1", "name": "aside", "values": [0.22, 0.1]}
    values = {"scenario": two(), "method": "grid", "vary": [speed, aside]}
    return Plan.model_validate(values | given)


@pytest.fixture(scope="module")
def campaign(tmp_path_factory: pytest.TempPathFactory) -> Campaign:
    return run_campaign(plan(), tmp_path_factory.mktemp("pairs") / "all", workers=1)


def test_a_row_is_the_flight_of_both_flown_alone(campaign: Campaign) -> None:
    """Every measure of both, to the last bit."""
    row = campaign.row(2)
    scenario = scenario_from(campaign.design.slice(2, 3).tables[0])
    assert scenario.beside().start.velocity[0] == -1.4 == row["approach"]
    first, second = fly_pair(scenario.model_copy(update={"second": None}), scenario.beside())
    assert row["contacts"] >= 1.0
    for prefix, flight in nonempty((("", first), ("second_", second))):
        assert row[f"{prefix}outcome"] == flight.outcome.word
        for name, value in nonempty(flight.measures.items()):
            assert row[prefix + name] == value, name
    assert campaign.refly(2).differences == ()


def test_momentum_given_is_momentum_taken(campaign: Campaign) -> None:
    """In every row."""
    sums = campaign.arrays(
        "SELECT impulse_x + second_impulse_x AS x, impulse_y + second_impulse_y AS y, "
        "abs(impulse_x) AS size, work_driven + second_work_driven AS w FROM flights"
    )
    assert len(sums["x"]) == 4
    assert sums["size"].min() > 0.01
    assert max(abs(sums[name]).max() for name in "xyw") < 1e-12


def test_it_is_resumed_to_the_same_rows(campaign: Campaign, tmp_path: Path) -> None:
    """After two of four flights."""
    design = lay_out(plan())
    with open_store(tmp_path / "part", design, resume=False) as store:
        store.add(0, 2, rows(design, (0, 2)))
    again = run_campaign(plan(), tmp_path / "part", resume=True, workers=1)
    everything = "SELECT * FROM flights ORDER BY flight"
    assert again.query(everything).rows == campaign.query(everything).rows


def test_each_flight_has_its_own_noise_for_the_second() -> None:
    """A seed in the scenario of the second does not make that of all flights the same."""
    second = {**vehicle(0.6, -1.0, yaw=2.6, y=0.22), "seed": 5}
    design = lay_out(plan(scenario=two(second)))
    tables = design.slice(0, 4).tables
    assert len({scenario_from(one).beside().seed for one in tables}) == 4


def test_conditions_speak_of_both() -> None:
    """Success and what is kept, in words; columns of one vehicle only are not offered."""
    words = ["second_touch_speed < 3 m/s", "second_outcome = separated"]
    design = lay_out(plan(success=words))
    assert "second_touch_speed" in design.success
    assert "\"second_outcome\" = 'separated'" in design.success.replace("  ", " ")


def test_columns_of_a_second_are_only_there_with_one(campaign: Campaign) -> None:
    assert campaign.units["second_touch_speed"] == "m/s"
    alone = lay_out(plan(scenario={k: v for k, v in two().items() if k != "second"}, vary=[]))
    assert not any(name.startswith("second_") for name in rows(alone, (0, 1)))


def test_a_meeting_that_cannot_be_is_a_refused_row() -> None:
    """The others are flown."""
    place = {
        "field": "second.start.position.0",
        "name": "x",
        "normal": {"mean": 0.6, "deviation": 0.4},
    }
    design = lay_out(plan(vary=[place], method="random", samples=6))
    found = fly_chunk(design.plan.canonical(), (0, 6)).columns
    refused = [word == "refused" for word in found["outcome"]]
    assert any(refused)
    assert not all(refused)
    for k in nonempty(range(6)):
        assert ("second.start.position" in found["problem"][k]) == refused[k]
        assert (found["second_outcome"][k] == "") == refused[k]


def test_a_file_of_the_second_goes_into_the_stored_plan(tmp_path: Path) -> None:
    """So that the folder needs no other file."""
    (tmp_path / "other.toml").write_text(
        'vehicle = "quad"\nseed = 3\n[start]\nposition = [0.7, 0, 2]\n'
    )
    (tmp_path / "first.toml").write_text(
        'vehicle = "arq"\nsecond = "other.toml"\n[start]\nposition = [0, 0, 2]\n'
    )
    (tmp_path / "plan.toml").write_text('scenario = "first.toml"\nmethod = "grid"\n')
    read, _ = read_plan(tmp_path / "plan.toml")
    assert isinstance(read.scenario, dict)
    assert read.scenario["second"] == {"vehicle": "quad", "start": {"position": [0.7, 0, 2]}}


WRONG = {
    "second.start.speed": "'speed' needs",
    "second.seed": "cannot be varied",
    "second.world.gravity": "unknown parameter 'world'",
}


@pytest.mark.parametrize("field", WRONG)
def test_fields_that_it_lacks_are_refused(field: str) -> None:
    with pytest.raises(InputError, match=WRONG[field]):
        lay_out(plan(vary=[{"field": field, "values": [1.0]}]))


def test_a_gpu_flies_one_vehicle_only() -> None:
    with pytest.raises(InputError, match="--device gpu: cannot fly two vehicles"):
        try_code(lay_out(plan()), "gpu")
