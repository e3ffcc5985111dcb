"""Success in words: the rows that SQL would choose, and one line for each mistake."""

from __future__ import annotations

import re
from pathlib import Path

import duckdb
import pytest

from builders.campaign_folders import filled
from builders.plans import plan
from springback.campaign.access import Campaign
from springback.campaign.design.layout import lay_out
from springback.campaign.design.plan import read_plan
from springback.campaign.design.success import (
    alternatives,
    condition_in_words,
    upper_limit,
    word_literal,
)
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


@pytest.mark.parametrize(
    ("text", "sql"),
    [
        ("not (surface = 'wall' and touch_speed >= 0.2 m/s)", "NOT (w AND f)"),
        ("not touch_speed >= 0.2 m/s", "NOT f"),
        ("not(surface = wall)and(touch_speed >= 0.2 m/s or hit_ground)", "NOT w AND (f OR g)"),
        ("hit_ground or surface = wall and touch_speed >= 0.2 m/s", "g OR (w AND f)"),
        ('not ((surface = "wall")) or not hit_ground', "NOT w OR NOT g"),
    ],
)
def test_conditions_are_combined_as_written(tmp_path: Path, text: str, sql: str) -> None:
    filled(tmp_path, samples=40, parts=2, size=40)
    known = Campaign(tmp_path)
    for name, one in {
        "w": "surface = 'wall'", "f": "coalesce(touch_speed >= 0.2, false)",
        "g": "outcome = 'hit_ground'",
    }.items():  # fmt: skip
        sql = re.sub(rf"\b{name}\b", f"({one})", sql)
    wanted = known.query(f"SELECT flight FROM flights WHERE {sql} ORDER BY flight").rows
    found = known.where(text).query("SELECT flight FROM flights ORDER BY flight").rows
    assert found == wanted
    assert 0 < len(found) < known.done


@pytest.mark.parametrize(
    "name", ["world.obstacles[1], a (long) rod and mat or so", "Bob's 'own' pole", '3/4" pipe']
)
def test_words_in_quotes_may_contain_anything(name: str) -> None:
    text = f"not (first_obstacle = {word_literal(name)} and penetration > 5 mm)"
    sql = condition_in_words(text, {})
    with duckdb.connect() as database:
        rows = "(VALUES (?, 6e-3), (?, 4e-3), ('other', 6e-3)) t(first_obstacle, penetration)"
        sql = f"SELECT first_obstacle, penetration > 5e-3 FROM {rows} WHERE {sql}"
        kept = database.execute(sql, [name, name]).fetchall()
    assert kept == [(name, False), ("other", True)]


def test_a_condition_that_is_no_list_of_limits_has_no_alternatives() -> None:
    assert len(alternatives("arm_stroke < 2 mm or not hit_ground", {})) == 2
    for text in ("hit_ground and recovered", "not arm_stroke < 2 mm", "(hit_ground)"):
        assert alternatives(text, {}) == ()
    assert upper_limit("arm_stroke < 2 mm and recovered") is None


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
        ("(hit_ground", "must be a limit such as"),
        ("not (arm_strok < 2 mm and hit_ground)", r"did you mean arm_stroke\?"),
        ("(" * 600 + "hit_ground" + ")" * 600, "more than 50 parentheses"),
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
