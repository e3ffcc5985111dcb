"""Success in words: the rows that SQL would choose, and one line for each mistake."""

from __future__ import annotations

from pathlib import Path

import pytest

from builders.campaign_folders import filled
from builders.plans import plan
from springback.campaign.access import Campaign
from springback.campaign.design.layout import lay_out
from springback.campaign.design.plan import read_plan
from springback.campaign.plan_check import check_conditions
from springback.errors import InputError


def test_conditions_in_words_choose_the_rows_that_they_name(tmp_path: Path) -> None:
    success = [
        "impact_arm_stroke < 500 mm", "surface = wall or touch_speed >= 720 m/h", "not hit_ground",
    ]  # fmt: skip
    filled(tmp_path, success=success, samples=40, parts=2, size=40)
    known = Campaign(tmp_path)
    assert known.design.rule == "; ".join(success)
    rows = known.query("FROM flights").as_dicts()
    for row in rows:
        met = (
            row["impact_arm_stroke"] is not None and row["impact_arm_stroke"] < 0.5
            and (row["surface"] == "wall" or row["touch_speed"] >= 0.2)
            and row["outcome"] != "hit_ground"
        )  # fmt: skip
        assert row["success"] == (None if row["outcome"] == "refused" else int(met))
    assert {row["success"] for row in rows} == {None, 0, 1}


def test_a_limit_of_what_did_not_happen_is_not_met(tmp_path: Path) -> None:
    filled(tmp_path, success=["recovery_time < 3 s"])
    found = Campaign(tmp_path).query(
        "SELECT DISTINCT success FROM flights WHERE outcome <> 'refused'"
    )
    assert found.rows == [(0,)]


def test_a_text_is_sql_as_before() -> None:
    assert lay_out(plan(success="touch_speed < 2")).success == "touch_speed < 2"


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("arm_strok < 20 mm", r"there is no column arm_strok; did you mean arm_stroke\?"),
        ("arm_stroke < 20", r"has no unit \(got '20'\); expected m"),
        ("arm_stroke < 20 N", r"has the wrong unit \(got '20 N'\); expected m"),
        ("arm_stroke < nan m", "must be finite"),
        ("nose_up > 400 deg", "full turn"),
        ("recoverd", r"did you mean recovered\?"),
        ("arm_stroke", "has no limit; write such as arm_stroke < 1"),
        ("surface < wall", "holds words"),
        ("success = 1", "there is no column success"),
        ("1 = 1; DROP TABLE flights", "there is no column 1"),
        ("true", "neither an outcome nor a limit"),
    ],
)
def test_a_wrong_condition_is_one_line(text: str, why: str) -> None:
    design = lay_out(plan(success=["recovered", text]))
    with pytest.raises(InputError, match=rf"^success\[1\]: .*{why}") as caught:
        check_conditions(design)
    assert len(caught.value.problems) == 1


def test_a_wrong_kind_of_success_is_one_line(tmp_path: Path) -> None:
    for given in ("[]", "[3]", "3"):
        path = tmp_path / "plan.toml"
        path.write_text(f"success = {given}\nmethod = 'random'\nsamples = 2\nscenario = {{}}\n")
        with pytest.raises(InputError, match=r"plan.toml:1: success: must be .*list of"):
            read_plan(path)
    with pytest.raises(InputError, match="give a list: success"):
        check_conditions(lay_out(plan(success="arm_stroke < 20 mm")))


def test_what_is_kept_is_named_in_the_same_words(tmp_path: Path) -> None:
    keep = {"where": ["not success", "surface = wall or touch_speed >= 720 m/h"]}
    filled(tmp_path, success=["not hit_ground"], keep=keep, samples=40, parts=2, size=40)
    known = Campaign(tmp_path)
    check_conditions(known.design)
    rows = known.query("FROM flights ORDER BY flight").as_dicts()
    kept = known.query(f"SELECT flight FROM flights WHERE {known.design.keep_condition}").rows
    assert [number for (number,) in kept] == [
        row["flight"] for row in rows
        if row["outcome"] == "hit_ground" and (row["surface"] == "wall" or row["touch_speed"] >= 0.2)
    ]  # fmt: skip
    assert 0 < len(kept) < len(rows)


@pytest.mark.parametrize(
    ("where", "why"),
    [
        (["success", "arm_strok < 20 mm"], r"^keep.where\[1\]: .*did you mean arm_stroke\?"),
        ("arm_stroke < 20 mm", "^keep.where: .*give a list: where"),
        ([], "keep.where: must be a list of at least one text"),
    ],
)
def test_a_wrong_condition_of_what_is_kept_is_one_line(where: object, why: str) -> None:
    with pytest.raises((InputError, ValueError), match=why):
        check_conditions(lay_out(plan(keep={"where": where})))
