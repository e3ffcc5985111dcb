"""Plans and folders of strangers, and damaged ones: nothing runs, nothing is believed unchecked."""

from __future__ import annotations

import json
import os
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from attack.campaigns import CONDITIONS, ESCAPES, all_said
from attack.damage import one_byte
from builders.campaign_folders import filled, rows
from builders.plans import plan
from springback.campaign import manifest, store
from springback.campaign.access import Campaign
from springback.campaign.design.layout import lay_out
from springback.campaign.manifest import Part
from springback.campaign.plan_check import check_conditions
from springback.campaign.store import open_store
from springback.errors import InputError
from springback.files import atomic_file
from springback.results.database import in_database, sandbox
from springback.results.sealed_json import with_digest

# -- SQL ------------------------------------------------------------------------------------------

secret_of_python = {"x": [1.0]}


@pytest.fixture(scope="module")
def pair(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two campaigns and a secret."""
    folder = tmp_path_factory.mktemp("pair")
    filled(folder / "a")
    filled(folder / "b")
    (folder / "secret").write_text("x\n1\n")
    return folder


@pytest.mark.parametrize("sql", ESCAPES)
@pytest.mark.parametrize("way", ["query", "save", "arrays", "stream"])
def test_questions_reach_nothing_but_the_rows(pair: Path, sql: str, way: str) -> None:
    tmp_path = pair
    before = {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}
    part = "parts/part-0000000000.parquet"
    names = {
        "secret": tmp_path / "secret", "target": tmp_path / "target",
        "part": tmp_path / "a" / part, "other": tmp_path / "b" / part,
    }  # fmt: skip
    asked = sql.format_map({name: str(path) for name, path in names.items()})
    campaign = Campaign(tmp_path / "a")
    ask: dict[str, Callable[[], Any]] = {
        "query": lambda: campaign.query(asked),
        "save": lambda: campaign.save(asked, tmp_path / "out.parquet"),
        "arrays": lambda: campaign.arrays(asked),
        "stream": lambda: campaign.stream(asked, lambda _, rows: list(rows)),
    }
    with pytest.raises(InputError) as told:
        ask[way]()
    assert "\n" not in str(told.value)
    assert before == {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}


GOOD = [
    "FROM flights", "SELECT count(*) FROM flights;", "WITH a AS (FROM flights) SELECT * FROM a",
    "SELECT 1 -- a remark", "DESCRIBE flights", "SELECT ';'",
]  # fmt: skip


@pytest.mark.parametrize("sql", GOOD)
def test_ordinary_questions_are_answered_and_saved(pair: Path, tmp_path: Path, sql: str) -> None:
    campaign = Campaign(pair / "a")
    found = campaign.query(sql)
    streamed = campaign.stream(
        sql, lambda names, rows: (names, [row for some in rows for row in some])
    )
    assert (found.columns, found.rows) == streamed
    if not sql.startswith("DESCRIBE"):
        assert campaign.count(sql) == len(found.rows)
        assert campaign.save(sql, tmp_path / "out.parquet") == len(found.rows)


@pytest.mark.parametrize("condition", CONDITIONS)
@pytest.mark.parametrize("entry", ["success", "keep"])
def test_conditions_are_one_expression_over_the_columns(
    tmp_path: Path, condition: str, entry: str
) -> None:
    (tmp_path / "secret").write_text("x")
    text = condition.format(target=tmp_path / "target", secret=tmp_path / "secret")
    given = {"success": text} if entry == "success" else {"keep": {"where": text, "most": 1}}
    with pytest.raises(InputError, match=entry):
        check_conditions(lay_out(plan(**given)))
    assert [path.name for path in tmp_path.iterdir()] == ["secret"]


def test_a_foreign_folders_condition_is_not_run(tmp_path: Path) -> None:
    """Unchecked before: the folder comes as it is, its digests made to fit."""
    text = f"true); COPY (SELECT 1) TO '{tmp_path / 'target'}'; SELECT (true"
    for parts in (0, 1):
        folder = tmp_path / f"a{parts}"
        filled(folder, parts=parts)
        given = json.loads((folder / store.PLAN).read_text())
        given |= {"success": text, "keep": {"where": text, "most": 3}}
        from springback.campaign.design.plan import plan_from

        data = json.dumps(given).encode()
        (folder / store.PLAN).write_bytes(data)
        about = json.loads((folder / store.METADATA).read_text())
        about["plan_sha256"] = plan_from(given).digest()
        about["plan_file_sha256"] = store.hashlib.sha256(data).hexdigest()
        (folder / store.METADATA).write_text(json.dumps(with_digest(about)))
        campaign = Campaign(folder)
        if not parts:
            with pytest.raises(InputError, match="success: must be one condition"):
                campaign.query("FROM flights")
        else:
            campaign.query("FROM flights")
        with pytest.raises(InputError, match="must be one condition"):
            campaign.keep(print)
    assert not (tmp_path / "target").exists()


def test_the_lock_holds_for_what_is_written_too(tmp_path: Path) -> None:
    connection = sandbox(folders=[tmp_path / "a"])
    (tmp_path / "a").mkdir()

    def write(opened: Any) -> None:
        opened.execute(f"COPY (SELECT 1) TO '{tmp_path / 'a/x.parquet'}'")
        opened.execute(f"COPY (SELECT 1) TO '{tmp_path / 'x.parquet'}'")

    with pytest.raises(Exception, match="disabled by configuration"):
        in_database(write, connection)
    assert (tmp_path / "a/x.parquet").exists()
    assert not (tmp_path / "x.parquet").exists()


# -- names ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(("name", "also"), [("res[1]", "res1"), ("a*b", "aXXb"), ("a?b", "aXb")])
def test_names_of_folders_are_not_patterns(tmp_path: Path, name: str, also: str) -> None:
    filled(tmp_path / name, parts=2)
    filled(tmp_path / also, parts=3)
    campaign = Campaign(tmp_path / name)
    assert campaign.query("SELECT count(*) FROM flights").rows == [(20,)]
    assert campaign.save("FROM flights", tmp_path / name / "out.parquet") == 20


# -- ledgers --------------------------------------------------------------------------------------


def entered(folder: Path, part: Part) -> None:
    manifest.append(folder / manifest.NAME, part)


@pytest.mark.parametrize(
    "file", ["/elsewhere/thesis.txt", "../../thesis.txt", "parts/../../thesis.txt", "plan.json", "parts/part-0000000007.parquet"]
)  # fmt: skip
def test_a_ledger_names_only_parts(tmp_path: Path, file: str) -> None:
    design = filled(tmp_path / "d")
    (tmp_path / "thesis.txt").write_text("years of work")
    entered(tmp_path / "d", Part(30, 40, file, 13, ""))
    for ask in (
        lambda: Campaign(tmp_path / "d"),
        lambda: open_store(tmp_path / "d", design, resume=True).__enter__(),
    ):
        with pytest.raises(InputError, match=r"manifest.jsonl:4: is not a line of a manifest"):
            ask()
    assert (tmp_path / "thesis.txt").read_text() == "years of work"


@pytest.mark.parametrize(("first", "last"), [("0", 10), (0.0, 10), (-5, 10), (10, 10), (True, 10)])
def test_a_ledgers_numbers_are_numbers(tmp_path: Path, first: Any, last: Any) -> None:
    filled(tmp_path)
    data = {
        **manifest.asdict(Part(0, 10, "parts/part-0000000000.parquet", 1, "")),
        "first": first,
        "last": last,
    }
    with (tmp_path / manifest.NAME).open("a") as file:
        file.write(json.dumps(with_digest(data)) + "\n")
    with pytest.raises(InputError, match=r":4: is not a line of a manifest"):
        Campaign(tmp_path)


def test_flights_that_two_parts_hold_are_refused(tmp_path: Path) -> None:
    """Was: 40 of 60 flights with ten counted twice."""
    design = filled(tmp_path)
    path = tmp_path / manifest.file_of(25)
    store.write_rows(path, rows(design, 25, 35), design)
    entered(
        tmp_path,
        Part(25, 35, manifest.file_of(25), path.stat().st_size, manifest.file_digest(path)),
    )
    with pytest.raises(InputError, match=r"holds flights from 25 on, which .* holds up to 29"):
        Campaign(tmp_path)


def test_flights_beyond_the_campaign_are_refused(tmp_path: Path) -> None:
    filled(tmp_path, parts=1, samples=5, robots=["arq"], repeats=2)
    entered(tmp_path, Part(10, 20, manifest.file_of(10), 1, ""))
    with pytest.raises(InputError, match="holds flights up to 19, and the campaign has 10"):
        Campaign(tmp_path)


def test_drafts_have_no_foreseeable_name_and_follow_no_link(tmp_path: Path) -> None:
    victim = tmp_path / "victim"
    victim.write_text("precious")
    for name in (".x.csv.draft", ".plan.json.draft"):
        (tmp_path / name).symlink_to(victim)
    names = set()
    for _ in range(2):
        with atomic_file(tmp_path / "x.csv") as draft:
            names.add(draft.name)
            draft.write_text("new")
    assert len(names) == 2
    assert (tmp_path / "x.csv").read_text() == "new"
    assert victim.read_text() == "precious"
    with pytest.raises(OSError, match="directory"), atomic_file(tmp_path / "x.csv") as draft:
        draft.with_name("nowhere").joinpath("x").write_text("half")
    assert (tmp_path / "x.csv").read_text() == "new"
    assert not [
        path for path in tmp_path.iterdir() if path.suffix == ".draft" and not path.is_symlink()
    ]


# -- damage ---------------------------------------------------------------------------------------

TORN = {
    "a list": "[1, 2]", "a number": "5", "deep": "[" * 200_000, "nothing": "", "empty": "{}",
    "deep objects": '{"a":' * 100_000, "binary": "\xff",
}  # fmt: skip


@pytest.mark.parametrize("name", [store.PLAN, store.METADATA, manifest.NAME])
@pytest.mark.parametrize("kind", TORN)
def test_a_file_that_is_something_else_is_said_in_one_line(
    tmp_path: Path, name: str, kind: str
) -> None:
    design = filled(tmp_path)
    (tmp_path / name).write_bytes(TORN[kind].encode("latin1") + b"\n" * (kind != "nothing"))
    if name == manifest.NAME and kind == "nothing":
        return  # it may have been torn at once: all is flown again
    with pytest.raises(InputError, match=name) as told:
        all_said(tmp_path)
    assert "\n" not in str(told.value)
    with pytest.raises(InputError, match=name), open_store(tmp_path, design, resume=True):
        store.stored_plan(tmp_path)


#: Cases for each file; `make attack` takes more.
CASES = int(os.environ.get("SPRINGBACK_DAMAGE", "25"))


@pytest.mark.parametrize("name", ["part", store.PLAN, store.METADATA, manifest.NAME])
def test_one_byte_anywhere_is_noticed_or_without_effect(tmp_path: Path, name: str) -> None:
    """Was: 369 of 600 changes of a part gave other numbers without a word."""
    filled(tmp_path)
    file = "parts/part-0000000010.parquet" if name == "part" else name
    found = one_byte(tmp_path, file, all_said, CASES)
    assert not found - Counter({"noticed": CASES, "without effect": CASES}), found
    if name == "part":
        assert found == {"noticed": CASES}
