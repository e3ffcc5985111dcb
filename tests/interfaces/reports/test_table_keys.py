"""The keys of a scenario can be read without building the documentation."""

from __future__ import annotations

import json

import pytest
from click.testing import CliRunner

from builders.cases import nonempty
from springback.errors import InputError
from springback.interfaces.cli.app import cli
from springback.interfaces.reports.table_keys import key_tables, table_paths, table_text
from springback.scenario.fields import fields_of
from springback.scenario.tables import Start


def test_every_key_of_every_table_has_words() -> None:
    """A new key without a meaning fails here, and in the documentation."""
    for path in nonempty(["", *table_paths()]):
        for table in nonempty(key_tables(path)):
            assert table.meaning, path
            for line in nonempty(table.keys):
                assert line.meaning, f"{path}.{line.key}"
                assert "`" not in line.meaning, f"{path}.{line.key}"


def test_a_table_is_printed_with_unit_range_default_and_meaning() -> None:
    (start,) = key_tables("start")
    assert [line.key for line in start.keys] == [one.key for one in fields_of(Start).values()]
    text = table_text(start)
    assert "  position (m, three, default [0, 0, 1])\n      Of the main body, less offset;" in text
    assert "  touch_distance (m; ≥ 0)\n      Distance from the start to the first touch" in text


def test_one_of_several_is_named_by_its_type() -> None:
    kinds = [table.kind for table in key_tables("world.obstacles[2]")]
    assert {"wall", "pole", "mesh", "import"} <= set(kinds)
    (pole,) = key_tables("world.obstacles.pole")
    assert {line.key: line.default for line in pole.keys}["radius"] == "needed"
    assert table_text(pole).startswith("world.obstacles, type = 'pole': A round pole")


def test_the_command_prints_them_and_what_is_below() -> None:
    done = CliRunner().invoke(cli, ["show", "--keys", "vehicle.arms", "--json"])
    found = json.loads(done.stdout)
    keys = {line["key"]: line for line in found["tables"][0]["keys"]}
    assert keys["stiffness"]["allowed"].startswith("N/m")
    assert all(one.startswith("vehicle.arms.") for one in nonempty(found["below"]))
    listed = CliRunner().invoke(cli, ["show", "--keys"]).stdout
    assert "  springback show --keys world.obstacles\n" in listed
    with pytest.raises(InputError, match=r"no table 'strat'; did you mean start\?"):
        key_tables("strat")
