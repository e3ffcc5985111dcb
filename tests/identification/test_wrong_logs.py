"""Logs that a fit or a replay must refuse, or read with care: units, bodies, clocks."""

from __future__ import annotations

from pathlib import Path

import pytest

from springback.errors import InputError
from springback.identification.fits import read_flights
from springback.identification.replays.replay import replay, scenario_tables
from springback.identification.settings import read_fit_plan
from springback.logs.reading import read_recording

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name in ("fit.toml", "arq_wall.toml", "impact_log.toml", "impact_log.csv"):
        (tmp_path / name).write_bytes((EXAMPLES / name).read_bytes())
    return tmp_path


def test_arm_lengths_a_thousand_times_too_long_are_refused_by_fit_and_replay(folder: Path) -> None:
    table = (folder / "impact_log.csv").read_text().splitlines()
    names = table[0].split(",")
    places = [k for k, name in enumerate(names) if name.startswith("arm_lengths")]
    lines = []
    for line in table[1:]:
        cells = line.split(",")
        for k in places:
            cells[k] = str(1e3 * float(cells[k])) if cells[k] else ""
        lines.append(",".join(cells))
    (folder / "impact_log.csv").write_text("\n".join([table[0], *lines]) + "\n")
    said = r"impact_log.csv: arm lengths: lengths are 190 m .* arm is 0\.19 m: .* probably mm$"
    with pytest.raises(InputError, match=said):
        read_flights(read_fit_plan(folder / "fit.toml"), folder)
    recordings = [read_recording(folder / "impact_log.toml")]
    with pytest.raises(InputError, match=said):
        replay(*scenario_tables(folder / "arq_wall.toml"), recordings)


def test_a_plan_names_the_vehicle_among_bodies(folder: Path) -> None:
    text = (folder / "fit.toml").read_text().replace("[free]", 'track = "vehicel"\n[free]')
    (folder / "fit.toml").write_text(text)
    plan = read_fit_plan(folder / "fit.toml")
    assert plan.flights[0].track == "vehicel"
    with pytest.raises(InputError, match="have no body 'vehicel'; did you mean vehicle"):
        read_flights(plan, folder)
    right = read_fit_plan(folder / "fit.toml", ["track=vehicle"])
    assert read_flights(right, folder)[0].impacts
