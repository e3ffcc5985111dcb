"""What is warned of before and after a flight stays with it: in its files, page and notebook."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from builders.world_files import BOX, imported, sdf, sdf_model
from springback.errors import InputError, OverlapWarning
from springback.files import write_json
from springback.interfaces.replay.scene import scene_of
from springback.interfaces.reports.flight_files import write_flight
from springback.interfaces.reports.notebook import flight_html
from springback.results.flight import Flight, fly
from springback.results.saved import load
from springback.results.sealed_json import with_digest

EGG = "<ellipsoid><radii>0.2 0.2 0.3</radii></ellipsoid>"


@pytest.fixture(scope="module")
def flight(tmp_path_factory: pytest.TempPathFactory) -> Flight:
    folder = tmp_path_factory.mktemp("world")
    text = sdf(sdf_model("crate", BOX, "3 0 1 0 0 0"), sdf_model("egg", EGG, "1 2 1 0 0 0"))
    imported(folder, "w.sdf", text)
    given: dict[str, Any] = {
        "vehicle": "quad", "thrust": "hover", "clock": 0.002,
        "world": {"obstacles": [
            {"type": "import", "file": str(folder / "w.sdf"), "surface": "wall"},
        ]},
        "start": {"position": [1.0, 0, 1.0]}, "simulation": {"duration": 0.002},
    }  # fmt: skip
    return fly(given, executor="python")


def test_an_element_that_is_not_there_is_told_of_wherever_a_flight_is_shown(
    flight: Flight, tmp_path: Path
) -> None:
    [first, second] = flight.warnings
    assert "1 of 2 elements of w.sdf cannot be represented and are not there: egg" in first
    assert second.startswith("clock is not used")
    assert flight.summary()["warnings"] == [first, second]
    assert scene_of(flight).warnings == flight.warnings
    assert "not there: egg" in flight_html(flight)
    write_flight(flight, tmp_path, figures=False)
    again = load(tmp_path)
    assert again.warnings == flight.warnings  # a saved scenario has all tables, written or not
    assert scene_of(again).warnings == flight.warnings


def test_remarks_follow_once_and_those_of_a_second_vehicle_are_its_own(flight: Flight) -> None:
    first, second = (replace(flight, warned=None) for _ in range(2))
    crossed = "cages came into each other"
    first.__dict__["remarks"] = {OverlapWarning: crossed}
    assert first.warnings == (*flight.warnings, crossed)
    second.__dict__["remarks"] = {OverlapWarning: "of the other"}
    both = replace(first, second=replace(second, first=first))
    assert both.second is not None
    both.second.__dict__["remarks"] = second.__dict__["remarks"]
    both.__dict__["remarks"] = {OverlapWarning: crossed}
    assert both.second.warnings == ("of the other",)
    told = both.summary()["warnings"]
    assert told == [*first.warnings, "second: of the other"]
    read = replace(both, warned=tuple(told))
    read.__dict__["remarks"] = both.__dict__["remarks"]
    assert read.warnings == first.warnings


def test_a_pilot_of_ones_own_is_known_by_what_it_records(flight: Flight) -> None:
    """Its flight does not say that no pilot reads what it flies without."""
    nothing = flight.t * 0.0
    own = replace(flight, telemetry={"t": flight.t, "command1": nothing})
    assert not any(one.startswith("clock") for one in own.warnings)


def test_warnings_of_another_kind_are_refused(flight: Flight, tmp_path: Path) -> None:
    write_flight(flight, tmp_path, figures=False)
    path = tmp_path / "summary.json"
    data = json.loads(path.read_text(encoding="utf-8")) | {"warnings": "none"}
    data.pop("seal")
    write_json(path, with_digest(data))
    with pytest.raises(InputError, match="warnings: must be a list of texts"):
        load(tmp_path)
