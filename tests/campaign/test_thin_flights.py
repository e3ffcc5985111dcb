"""Flights that came too deep into a thin obstacle: which, said how, and left out how."""

from __future__ import annotations

import html
import re
import shlex
from pathlib import Path
from typing import Any

import duckdb
import numpy as np
import pytest

from builders.campaign_folders import rows
from builders.plans import THROW, plan
from springback.campaign.access import Campaign
from springback.campaign.analysis.failures import failures
from springback.campaign.analysis.levels import field_summary
from springback.campaign.analysis.statistics import summary
from springback.campaign.analysis.thin_flights import largest_in_doubt, thin_flights
from springback.campaign.analysis.worst_case import worst_cases
from springback.campaign.design.layout import lay_out
from springback.campaign.store import open_store
from springback.errors import InputError
from springback.interfaces.output.no_contact import doubt_lines, pierced_lines
from springback.interfaces.reports.campaign import summary_text, write_summary
from springback.interfaces.reports.measures import measure_report

ROPE = {
    "type": "capsule", "name": "Bob's rope", "start": [1.0, 0.5, 3.0], "end": [1.0, 0.5, 0.8],
    "radius": "6 mm", "surface": "wall",
}  # fmt: skip
SHELF = {
    "type": "union", "name": "shelf", "position": [1.0, -1.0, 0.0], "surface": "wall",
    "shapes": [
        {"type": "box", "position": [0, 0, 0.5], "size": [0.3, 0.8, 0.04]},
        {"type": "box", "position": [0, 0, 1.0], "size": [0.3, 0.8, 0.02]},
    ],
}  # fmt: skip
NAMES = {
    "w": "world.obstacles[0], a wall", "r": "world.obstacles[2], Bob's rope",
    "s": "world.obstacles[3], shelf", "": "",
}  # fmt: skip
#: What each flight touched first, and how deep it came [mm].
FLOWN = [
    ("w", 4.0), ("w", 12.0), ("w", 20.0), ("r", 2.0), ("r", 6.5), ("s", 7.0), ("s", 11.0),
    ("s", 14.0), ("", 0.0), ("w", 1.0),
]  # fmt: skip
PEAK = "impact_peak_acceleration"


def _campaign(folder: Path, obstacles: list[dict[str, Any]] | None = None) -> Campaign:
    world = {"obstacles": [*THROW["world"]["obstacles"], ROPE, SHELF]}
    if obstacles is not None:
        world = {"obstacles": obstacles}
    vary = [{"field": "start.velocity.0", "name": "speed", "from": "1 m/s", "to": "3 m/s"}]
    design = lay_out(
        plan(samples=len(FLOWN), robots=["arq"], vary=vary, scenario={**THROW, "world": world})
    )
    columns = rows(design, 0, len(FLOWN))
    columns["outcome"] = ["separated" if k % 2 else "hit_ground" for k in range(len(FLOWN))]
    columns["problem"] = [""] * len(FLOWN)
    columns["first_obstacle"] = [NAMES[first] for first, _ in FLOWN]
    columns["penetration"] = np.array([1e-3 * depth for _, depth in FLOWN])
    columns[PEAK] = 100.0 + 10.0 * columns["penetration"] * 1e3  # the wall has the largest
    with open_store(folder, design, resume=False) as store:
        store.add(0, len(FLOWN), columns)
    return Campaign(folder)


def test_flights_count_for_the_thin_obstacle_that_they_met_first(tmp_path: Path) -> None:
    """Of ten flights 7 are deeper than the rope allows; one of these touched it first."""
    known = _campaign(tmp_path / "rows")
    found = thin_flights(known)
    assert [(one.first, one.flights) for one in found] == [(NAMES["s"], 2), (NAMES["r"], 1)]
    assert [one.deepest for one in found] == pytest.approx([0.014, 0.0065])
    shelf, rope, command = pierced_lines(known)
    assert shelf.startswith(
        "2 flights whose first obstacle was world.obstacles[3], shelf, came up to 14 mm deep, and "
        "the middle of world.obstacles[3].shapes[1], a box, is some 10 mm below its surface"
    )
    assert shelf.endswith("(penetration > 9.5 mm)")
    assert rope.startswith("1 flight whose first obstacle was world.obstacles[2], Bob's rope, came")
    assert "(penetration > 5.7 mm)" in rope
    assert rope.endswith("flights that met a thin obstacle after another one are not counted")
    assert command.startswith("without these flights: springback summary ")


def test_the_command_leaves_them_out(tmp_path: Path) -> None:
    known = _campaign(tmp_path / "a 'b'")
    [*_, last] = pierced_lines(known.where("speed < 4 m/s"))
    words = shlex.split(last.partition(": ")[2])
    assert words[:3] == ["springback", "summary", str(known.folder)]
    assert words[3::2] == ["--where"] * 3
    rest = known.where(*words[4::2])
    assert rest.conditions[0] == "speed < 4 m/s"
    assert [k for (k,) in rest.query("SELECT flight FROM flights ORDER BY flight").rows] == [
        0, 1, 2, 3, 5, 8, 9,
    ]  # fmt: skip
    assert pierced_lines(rest) == []


def test_rows_that_do_not_name_the_first_obstacle_count_as_before(tmp_path: Path) -> None:
    known = _campaign(tmp_path / "rows")
    part, new = known.folder / known.parts[0].file, tmp_path / "new.parquet"
    with duckdb.connect() as database:
        older = f"SELECT * EXCLUDE first_obstacle FROM read_parquet('{part}')"
        database.execute(f"COPY ({older}) TO '{new}' (FORMAT parquet)")
    part.write_bytes(new.read_bytes())
    line, command = pierced_lines(known)
    assert line.startswith("6 flights came up to 20 mm deep, and the middle of world.obstacles[2]")
    assert command.endswith('--where "not (penetration > 5.7 mm)"')
    with pytest.raises(InputError, match=r"first_obstacle: the rows of .* do not have this column"):
        field_summary(known, "first_obstacle")
    alone = _campaign(tmp_path / "alone", [ROPE])
    assert pierced_lines(alone)[0].startswith("6 flights came up to 20 mm deep")
    assert pierced_lines(_campaign(tmp_path / "wall", THROW["world"]["obstacles"])) == []


def test_the_largest_value_is_marked_where_it_is_in_doubt(tmp_path: Path) -> None:
    known = _campaign(tmp_path / "rows")
    assert largest_in_doubt(known, PEAK) == {}  # it is of flight 2, of the wall
    chosen = known.where("penetration < 15 mm")
    assert largest_in_doubt(chosen, PEAK) == {"arq": 7}
    [line] = doubt_lines(chosen, PEAK)
    assert line.startswith(f"the largest {PEAK} of arq is not to be trusted: flight 7 came deeper")
    report = measure_report(chosen, PEAK)
    worst = worst_cases(chosen, [f"{PEAK} < 200 m/s^2"], ["first_obstacle"])
    assert summary_text(summary(chosen), [report], worst_cases=worst).count(line) == 2
    write_summary(summary(chosen), tmp_path, measures=[report], worst_cases=worst)
    page = html.unescape((tmp_path / "summary.html").read_text(encoding="utf-8"))
    assert page.count("peak acceleration of ARQ is not to be trusted: flight 7 came deeper") == 2
    command = pierced_lines(chosen)[-1].partition(": ")[2]
    assert f"{command}</p>" in page.replace("<wbr>", "")  # to be typed as it is shown
    answer = page.index("confidence interval (Wilson)")
    assert answer < page.index("whose first obstacle was")  # which is no answer
    assert "first_obstacle = 'world.obstacles[3], shelf'" in command


def test_flights_to_replay_are_the_hardest(tmp_path: Path) -> None:
    known = _campaign(tmp_path / "rows")
    found = failures(known)
    assert [row["flight"] for row in found.rows] == [2, 6, 4, 0, 8]
    assert [row["flight"] for row in found.hardest] == [2, 7, 1, 6, 5, 4, 0, 3, 9, 8]
    assert [row["flight"] for row in found.hardest if row["in_doubt"]] == [7, 6, 4]
    assert found.kept == ()
    assert found.sentence() == (
        f"5 flights without success; replay the one with the largest {PEAK}: springback view "
        f"{known.folder} 2"
    )
    write_summary(summary(known), tmp_path)
    page = (tmp_path / "summary.html").read_text(encoding="utf-8")
    assert "Flights without success with the largest impact peak acceleration" in page
    assert "Flights with the largest impact peak acceleration of all" in page
    assert "to be trusted</th>" in page


@pytest.mark.parametrize("name", ["first_obstacle", "outcome"])
def test_flights_are_grouped_by_what_they_did(tmp_path: Path, name: str) -> None:
    known = _campaign(tmp_path / "rows")
    found = field_summary(known, name)
    every = known.query("FROM flights").as_dicts()
    words = {row[name] for row in every}
    assert {label.replace("nothing", "") for label in found.field.labels} == words
    counts = []
    for level, [one] in found.levels.items():
        word = found.field.labels[level].replace("nothing", "")
        mine = [row for row in every if row[name] == word]
        counts.append(one.flights)
        assert (one.flights, one.successes) == (len(mine), sum(row["success"] for row in mine))
        median = one.measures[PEAK][1][1].value
        assert median == pytest.approx(np.median([row[PEAK] for row in mine]))
    assert counts == sorted(counts, reverse=True)
    assert found.pairs == ()  # flights of another outcome are no pair
    text = summary_text(summary(known), levels=[found])
    assert f"by {name}" in text
    label = found.field.labels[0]
    assert re.search(rf"{PEAK} \[m/s²\] +{re.escape(label)} +arq +{counts[0]} ", text)


def test_the_least_frequent_words_are_one_group(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("springback.campaign.analysis.marginals.MOST_LEVELS", 3)
    found = field_summary(_campaign(tmp_path / "rows"), "first_obstacle")
    assert found.field.labels == (NAMES["w"], NAMES["s"], "others")
    assert [one.flights for [one] in found.levels.values()] == [4, 3, 3]
