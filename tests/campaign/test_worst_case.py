"""Worst cases over a field: as by hand from the rows; their ranges, sentences, figures and pages."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pytest

import springback
from builders.campaign_folders import filled
from builders.plans import PITCH, SPEED, SURFACE, WALL
from springback.campaign.access import Campaign
from springback.campaign.analysis.levels import SAME_FIELDS, field_summary, fields_of_words
from springback.campaign.analysis.statistics import summary
from springback.campaign.analysis.worst_case import (
    WorstCase,
    WorstCaseMap,
    flights_needed,
    least_share,
    worst_case,
    worst_cases,
)
from springback.errors import InputError
from springback.interfaces.figures.worst_case import worst_case_figure
from springback.interfaces.output.worst_case import (
    answer_lines,
    answer_table,
    worst_case_lines,
    worst_case_table,
)
from springback.interfaces.reports.campaign import summary_text, write_summary

STROKE, LIMIT = "impact_arm_stroke", "impact_arm_stroke < 900 mm"
LEVELS = {"field": "stiffness", "from": "1 N/mm", "to": "8 N/mm", "count": 8}
YAW = {"field": "yaw", "from": "0 deg", "to": "45 deg", "count": 4}


@pytest.fixture(scope="module")
def campaign(tmp_path_factory: pytest.TempPathFactory) -> Campaign:
    folder = tmp_path_factory.mktemp("worst")
    filled(folder, parts=4, size=200, samples=200, repeats=2, vary=[SPEED, PITCH, SURFACE, LEVELS])
    return Campaign(folder)


def flown(campaign: Campaign, robot: str) -> list[dict[str, Any]]:
    rows = campaign.query("FROM flights WHERE outcome <> 'refused'").as_dicts()
    return [row for row in rows if row["robot"] == robot]


@pytest.mark.parametrize("share", [1.0, 0.8])
@pytest.mark.parametrize("limit", [LIMIT, "impact_arm_stroke > 0.1 m", "not hit_ground"])
def test_a_worst_case_is_that_of_the_rows(campaign: Campaign, share: float, limit: str) -> None:
    found = worst_case(campaign, "stiffness", [limit], share=share)
    assert found.others == ("speed", "pitch", "surface")
    for robot, cells in found.robots.items():
        assert [cell.number for cell in cells] == list(range(8))
        for cell in cells:
            rows = [row for row in flown(campaign, robot) if row["stiffness"] == cell.low]
            assert cell.flights == len(rows) > 20
            values = sorted(row[STROKE] for row in rows)
            rank = math.ceil(share * len(rows))
            if limit == LIMIT:
                kept, worst = sum(v < 0.9 for v in values), values[rank - 1]
                assert found.keeps(cell) == (worst < 0.9)  # curve and verdict agree
            elif ">" in limit:
                kept, worst = sum(v > 0.1 for v in values), values[-rank]
                assert found.keeps(cell) == (worst > 0.1)
            else:
                kept, worst = sum(row["outcome"] != "hit_ground" for row in rows), None
            assert (cell.kept, cell.all_kept) == ((kept,), kept)
            assert cell.worst == (worst,)
            assert found.keeps(cell) == (kept >= rank)


def with_cells(kept: list[int], of: int = 50, share: float = 1.0) -> WorstCase:
    """Cells at stiffnesses of 1000, 2000, ... N/m."""
    from springback.campaign.analysis.marginals import MeasureColumn, Scale
    from springback.campaign.analysis.worst_case import WorstCaseCell, WorstCaseLimit

    edges = tuple(1000.0 * (k + 1) for k in range(len(kept) + 1))
    field = Scale("stiffness", "N/m", (), edges, False, "")
    limits = (WorstCaseLimit(LIMIT, "", MeasureColumn(STROKE, "m", ""), False, (0.9,)),)
    cells = tuple(
        WorstCaseCell(k, edges[k], edges[k + 1], of, (n,), n, (0.5 if n == of else 0.95,), (0,))
        for k, n in enumerate(kept)
    )
    return WorstCase(field, limits, share, ("yaw", "speed"), (), {"hexa": cells}, {})


def test_ranges_are_whole_cells_and_the_sentence_names_them() -> None:
    found = with_cells([49, 50, 50, 20, 50])
    assert [(part.low, part.high) for part in found.ranges("hexa")] == [(2e3, 4e3), (5e3, 6e3)]
    [answer, over] = worst_case_lines(found)
    assert answer.startswith(
        "hexa: stiffness 2000 to 4000 N/m and 5000 to 6000 N/m (to the last flown) keeps "
        f"{LIMIT} in every flight (3 of 5 cells, 50 or more flights in each: at 95 % confidence "
        "94 % of such flights or more)"
    )
    assert over == "The worst case is over all yaw, speed"
    none = with_cells([49, 20])
    assert worst_case_lines(none)[0] == (
        f"hexa: no stiffness keeps {LIMIT} in every flight; closest is 1000 to 2000 N/m, with 49 "
        "of 50 flights"
    )
    assert none.as_dict()["robots"]["hexa"]["kept"] == []
    assert with_cells([49, 20], share=0.98).ranges("hexa")[0].high == 2e3


def test_the_share_that_is_left_is_clopper_and_pearsons() -> None:
    assert least_share(50, 50) == pytest.approx(0.05 ** (1 / 50))
    assert least_share(0, 50) == 0.0
    assert least_share(45, 50) == pytest.approx(0.8012, abs=1e-3)  # tables of the binomial
    assert [flights_needed(0.95, n) for n in (1, 19, 20, 21, 100)] == [1, 19, 19, 20, 95]


def test_several_limits_hold_together_and_each_has_its_range(campaign: Campaign) -> None:
    limits = ["impact_arm_stroke < 990 mm", "impact_arm_stroke > 1 mm or no_contact"]
    found = worst_case(campaign, "stiffness", limits)
    for robot, cells in found.robots.items():
        for cell in cells:
            both = [r for r in flown(campaign, robot) if r["stiffness"] == cell.low]
            assert cell.all_kept == sum(0.001 < row[STROKE] < 0.99 for row in both)
    lines = worst_case_lines(found)
    assert sum(" alone: " in line for line in lines) == 4
    heads, rows = worst_case_table(found)
    assert heads[:3] == ["robot", "stiffness", "flights"]
    assert len(rows) == 16


def test_over_two_fields_each_cell_is_that_of_the_rows(campaign: Campaign) -> None:
    [found] = worst_cases(campaign, [LIMIT], ["stiffness,surface"])
    assert isinstance(found, WorstCaseMap)
    assert found.whole.others == ("speed", "pitch")
    for level, along in found.slices.items():
        word = found.across.labels[level]
        for robot, cells in along.robots.items():
            for cell in cells:
                mine = [
                    row for row in flown(campaign, robot)
                    if row["stiffness"] == cell.low and row["surface"] == word
                ]  # fmt: skip
                assert (cell.flights, cell.all_kept) == (
                    len(mine), sum(row[STROKE] < 0.9 for row in mine)
                )  # fmt: skip
    [loose] = worst_cases(campaign, ["impact_arm_stroke < 2 m"], ["stiffness,surface"])
    lines = answer_lines(loose)
    assert lines[0] == "arq keeps impact_arm_stroke < 2 m in every flight with"
    assert lines[1].startswith("  surface wall: stiffness 1000 to 8000 N/m (all flown), of ")
    [none] = worst_cases(campaign, ["impact_arm_stroke < 1 mm"], ["stiffness,surface"])
    assert "arq: no stiffness and surface keep impact_arm_stroke < 1 mm" in answer_lines(none)[0]
    figure: Any = campaign.plot(by=("stiffness", "surface"), limit=LIMIT)
    assert [axes.get_title(loc="left") for axes in figure.axes[:2]] == ["ARQ", "Quad"]
    assert len(answer_table(found)[1]) == 2 * 2 * 8
    assert found.as_dict()["across"] == "surface"
    with pytest.raises(InputError, match="two different fields"):
        worst_cases(campaign, [LIMIT], ["speed,speed"])
    with pytest.raises(InputError, match="give one field, or two"):
        worst_cases(campaign, [LIMIT], ["speed,pitch,surface"])


def test_what_would_keep_the_limits_more_often_is_named(campaign: Campaign) -> None:
    """Rows are made so that slow flights succeed more often, and nothing else matters."""
    found = worst_case(campaign, "stiffness", ["not hit_ground"])
    [best, *_] = found.better["arq"]
    assert (best.field.name, best.cell) == ("speed", 0)
    slow = [row for row in flown(campaign, "arq") if row["speed"] < best.field.edges[1]]
    assert (best.flights, best.kept) == (
        len(slow), sum(row["outcome"] != "hit_ground" for row in slow)
    )  # fmt: skip
    assert found.ranges("arq") == []
    [said] = [line for line in worst_case_lines(found) if line.startswith("arq: kept more often")]
    assert f"with speed 1.04 to 1.53 m/s ({100 * best.share:.0f} % of flights)" in said


def test_flights_without_the_measure_break_its_limit_and_are_told(campaign: Campaign) -> None:
    found = worst_case(campaign, "stiffness", ["recovery_time < 3 s"])
    assert found.ranges("arq") == []
    assert all(cell.worst == (None,) for cell in found.robots["arq"])
    count = len(flown(campaign, "arq"))
    assert f"arq: {count} flights have no recovery_time" in "\n".join(worst_case_lines(found))
    worst_case_figure(found)  # without a point


def test_conditions_choose_the_flights_of_everything(tmp_path: Path) -> None:
    filled(
        tmp_path, parts=1, size=64, method="grid", samples=None, vary=[SPEED | {"count": 8}, YAW]
    )
    known = Campaign(tmp_path)
    chosen = known.where("yaw = 15 deg", "speed >= 2 m/s")
    rows = chosen.query("FROM flights").as_dicts()
    assert len(rows) == 8
    assert {row["yaw"] for row in rows} == {rows[0]["yaw"]}
    assert rows[0]["yaw"] == pytest.approx(math.radians(15.0), abs=1e-9)
    assert min(row["speed"] for row in rows) >= 2.0
    assert [one.flights for one in summary(chosen).robots] == [4, 4]
    assert known.count("FROM flights") == 64  # and leaves the campaign as it was
    assert summary(known.where("robot = quad")).robots[0].robot == "quad"
    assert "only flights with: yaw = 15 deg" in summary_text(summary(chosen))
    assert summary(chosen).as_dict()["where"] == ["yaw = 15 deg", "speed >= 2 m/s"]
    twice = known.where("yaw = 15 deg").where("speed >= 2 m/s")
    assert twice.query("FROM flights").rows == chosen.query("FROM flights").rows
    with pytest.raises(InputError, match="flight 0: is not among those where yaw = 15 deg"):
        chosen.row(0)


@pytest.mark.parametrize(
    ("condition", "why"),
    [
        (
            "yaw = 20 deg",
            r"yaw = 20 deg: no flight is so; yaw is 0, 0.261799, 0.523599, 0.785398 rad",
        ),
        ("speed > 9 m/s", r"no flight is so; speed is 1, 1.25, 1.5, .*, 2.75, ... m/s"),
        ("sped > 1 m/s", r"there is no column sped; did you mean speed\?"),
        ("speed > 1", r"speed: has no unit"),
    ],
)
def test_a_wrong_condition_is_one_line(tmp_path: Path, condition: str, why: str) -> None:
    vary = [SPEED | {"count": 9}, YAW]
    filled(tmp_path, parts=1, size=72, method="grid", samples=None, vary=vary)
    with pytest.raises(InputError, match=why) as caught:
        Campaign(tmp_path).where(condition)
    assert len(caught.value.problems) == 1


def test_mistakes_are_one_line(campaign: Campaign) -> None:
    for given, why in (
        ({"by": "stiffnes", "limits": [LIMIT]}, "stiffnes: is not varied"),
        ({"by": "stiffness", "limits": ["arm_strok < 2 mm"]}, "did you mean arm_stroke?"),
        ({"by": "stiffness", "limits": [LIMIT], "share": 0.0}, "share: must be above 0"),
        ({"by": "stiffness"}, "limits: give at least one"),
    ):
        with pytest.raises(InputError, match=why.replace("?", r"\?")):
            worst_case(campaign, **given)
    assert [one.field.name for one in worst_cases(campaign, [LIMIT])] == [
        "speed", "pitch", "surface", "stiffness",
    ]  # fmt: skip


def test_a_plot_answers_with_limit_line_range_and_sentence(campaign: Campaign) -> None:
    figure: Any = campaign.plot(STROKE, by="stiffness", limit="impact_arm_stroke < 999 mm")
    [axes] = figure.axes
    assert [line.get_ydata()[0] for line in axes.get_lines() if line.get_color() == "#222222"] == [
        pytest.approx(0.999)
    ]
    assert "The worst case is over all speed, pitch, surface" in figure.texts[0].get_text().replace(
        "\n", " "
    )
    heads = figure.csv().splitlines()[0]
    assert "Worst impact arm stroke [m]" in heads
    assert "flights" in heads
    assert len(campaign.plot(STROKE, by="speed", share=0.9).axes) == 1  # without a limit
    two: Any = campaign.plot(
        "impact_peak_acceleration", by="speed", limit=[LIMIT, "not hit_ground"]
    )
    assert len([axes for axes in two.axes if axes.get_visible()]) == 3
    with pytest.raises(InputError, match="by: a limit needs the name of a field"):
        campaign.plot(STROKE, limit=LIMIT)


def test_by_a_field_of_words_rates_and_pairs_are_those_of_the_rows(tmp_path: Path) -> None:
    """On a grid the other fields match; each flight has draws of its own."""
    vary = [SPEED | {"count": 6}, SURFACE, WALL]  # the wall's angle is drawn
    filled(tmp_path, parts=1, size=48, method="grid", samples=None, repeats=2, vary=vary)
    known = Campaign(tmp_path)
    assert fields_of_words(known) == ["surface"]
    found = field_summary(known, "surface")
    rows = known.query("FROM flights").as_dicts()
    for level, robots in found.levels.items():
        word = found.field.labels[level]
        for one in robots:
            mine = [r for r in rows if r["surface"] == word and r["robot"] == one.robot]
            assert one.flights == len(mine) == 12
            assert one.successes == sum(row["success"] or 0 for row in mine)
    assert len(found.pairs) == 2
    for pair in found.pairs:
        by_key: dict[Any, dict[str, Any]] = {}
        for row in rows:
            if row["robot"] == pair.robot and row["success"] is not None:
                by_key.setdefault((row["speed"], row["repeat"]), {})[row["surface"]] = row[
                    "success"
                ]
        whole = [both for both in by_key.values() if len(both) == 2]
        assert (pair.names, pair.common) == (("wall", "mat"), SAME_FIELDS)
        assert pair.pairs == len(whole) > 5
        assert pair.first_only == sum(p["wall"] > p["mat"] for p in whole)
        assert pair.second_only == sum(p["mat"] > p["wall"] for p in whole)
        assert pair.sentence().startswith(f"{pair.robot}: wall less mat, over {len(whole)} pairs")
    text = summary_text(summary(known), levels=[found])
    assert "by surface" in text
    assert found.as_dict()["levels"][0]["level"] == "wall"


def test_levels_of_a_random_design_share_no_samples(campaign: Campaign) -> None:
    assert field_summary(campaign, "surface").pairs == ()
    along = field_summary(campaign, "speed", 4)  # without levels: in cells
    assert sum(one.flights for robots in along.levels.values() for one in robots) == 800
    assert along.pairs == ()


def test_the_page_shows_answers_levels_and_conditions(campaign: Campaign, tmp_path: Path) -> None:
    chosen = campaign.where("surface = wall")
    worst = worst_cases(chosen, [LIMIT, "not hit_ground"], ["stiffness"])
    written = write_summary(
        summary(chosen), tmp_path, levels=[field_summary(campaign, "surface")], worst_cases=worst
    )
    text = (tmp_path / "summary.html").read_text(encoding="utf-8")
    assert "Only flights with surface = wall are counted." in text
    assert 'id="limits"' in text
    assert "Outcomes by surface" in text
    assert "limits-stiffness.csv" in {path.name for path in written}
    data = json.loads((tmp_path / "summary.json").read_text(encoding="utf-8"))
    assert data["worst_cases"][0]["limits"][0] == {"limit": LIMIT, "measure": STROKE}
    assert data["by"][0]["field"] == "surface"


def test_a_notebook_says_which_flights_it_shows(campaign: Campaign) -> None:
    assert "; only touch_speed &lt; 2 m/s" in campaign.where("touch_speed < 2 m/s")._repr_html_()


def test_the_package_offers_it(campaign: Campaign) -> None:
    assert springback.Campaign.where(campaign, "surface = mat").count("FROM flights") < 800
