"""The keys of a scenario can be read without building the documentation."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any, get_args

import pytest
from click.testing import CliRunner
from pydantic import BaseModel

from builders.cases import nonempty
from springback.errors import InputError
from springback.interfaces.cli.app import cli
from springback.interfaces.reports.table_keys import key_tables, table_paths, table_text
from springback.scenario.fields import fields_of
from springback.scenario.scenario import Scenario
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
    assert (
        "  position (m, three; within ±1e+06, default [0, 0, 1])\n"
        "      Position of the main body, without offset;" in text
    )
    assert (
        "  touch_distance (m; ≥ 0, ≤ 1e+06)\n      Distance from the start to the first touch"
        in text
    )


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


def holders(table: type[BaseModel], path: str) -> Iterator[tuple[str, str, str]]:
    """Path, kind and key of all that a file may hold, from the models of pydantic alone."""
    kinds = get_args(table.model_fields["type"].annotation) if "type" in table.model_fields else ()
    kind = kinds[0] if len(kinds) == 1 else ""
    for name, info in table.model_fields.items():
        key = info.alias or name
        yield path, kind, key
        below = f"{path}.{key}" if path else key
        for inner in models((info.annotation, info.metadata)):
            yield from holders(inner, below)


def models(annotation: Any) -> Iterator[type[BaseModel]]:
    """Models anywhere within an annotation."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield annotation
    parts = annotation if isinstance(annotation, tuple | list) else get_args(annotation)
    for part in parts:
        yield from models(part)


def test_every_key_that_a_file_may_hold_is_printed_by_a_path_that_is_listed() -> None:
    """With the types of hulls, joints and obstacles, each at a path of its own."""
    listed = ["", *table_paths()]
    assert {"vehicle.hulls.ring", "vehicle.arms.joint.hinge", "reference.run-up"} <= set(listed)
    printed = {
        (table.path, table.kind, line.key)
        for path in nonempty(listed)
        for table in key_tables(path)
        for line in table.keys
    }
    wanted = set(holders(Scenario, ""))
    assert len(wanted) > 1000
    assert wanted <= printed
    for path in nonempty([one for one in listed if one.endswith(".hinge")]):
        assert [table.kind for table in key_tables(path)] == ["hinge"]


def test_a_type_may_be_within_a_path_and_the_beginning_left_out() -> None:
    (ring,) = key_tables("hulls.ring")
    assert (ring.path, ring.kind) == ("vehicle.hulls", "ring")
    assert [one.path for one in key_tables("world.obstacles.mat.backing")] == [
        "world.obstacles.backing"
    ]
    assert table_paths("vehicle.hulls.ring") == [
        "vehicle.hulls.ring.surface", "vehicle.hulls.ring.bearing"
    ]  # fmt: skip
    with pytest.raises(InputError, match=r"in several tables; give one of vehicle\.hulls\.surface"):
        key_tables("surface")
    with pytest.raises(InputError, match=r"no table 'hulls.rung'; did you mean vehicle.hulls.ring"):
        key_tables("hulls.rung")


def test_vectors_and_pairs_are_counted() -> None:
    (hinge,), (window,) = key_tables("joint.hinge"), key_tables("obstacles.window")
    allowed = {line.key: line.allowed for line in (*hinge.keys, *window.keys)}
    assert allowed["travel"] == "rad, two, or two for each arm"
    assert allowed["axis"] == "plain, three, or three for each arm; within ±1e+06"
    assert allowed["size"] == "m, two; > 0, ≤ 1e+06"
