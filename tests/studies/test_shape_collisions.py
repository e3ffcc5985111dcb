"""What robots make of other shapes than a wall."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

from builders.cases import nonempty
from springback.interfaces.cli.app import cli
from springback.scenario.scenario import scenario_from
from springback.studies.collisions import shape_collisions as study
from springback.studies.collisions.shape_collisions import (
    SHAPES,
    ShapeCollision,
    fly_shape_collision,
    shape_errors,
    shape_sentences,
    shape_tables,
)
from springback.studies.detection import Approach
from springback.studies.run_ups import study_vehicles

(ARQ,) = study_vehicles(["arq"])


def approach(trial: int = 0, speed: float = 2.0) -> Approach:
    return Approach("arq", speed, 0.0, 0.0, trial)


def test_every_shape_stands_where_the_wall_was() -> None:
    """Offset by the same chance for both settings, and by another for each trial."""
    for shape in nonempty(SHAPES):
        level, free, other = (
            shape_tables(shape, approach(trial), ARQ, 0, level)
            for trial, level in ((0, True), (0, False), (1, True))
        )
        assert scenario_from(level).recovery is not None
        assert level["world"] == free["world"]
        assert level["world"] != other["world"]
        assert free["recovery"]["characterisation"]["level"] is False


def test_an_upright_wall_is_known_and_a_pole_between_two_arms_is_not_a_wall() -> None:
    """The normal of a wall to a tenth of a degree; a pole's within what friction deflects."""
    wall = fly_shape_collision("wall", approach(), ARQ, 0, level=True)
    assert wall.touched
    assert wall.noticed
    assert not wall.body
    assert math.degrees(wall.directions["fused"]) < 0.5
    assert wall.contact_point < 0.01
    leaning = fly_shape_collision("wall leaning back 20 deg", approach(), ARQ, 0, level=True)
    assert math.degrees(leaning.used) == pytest.approx(20.0, abs=0.5)
    pole = fly_shape_collision("pole, radius 0.10 m", approach(), ARQ, 0, level=False)
    assert pole.noticed
    assert math.degrees(pole.used) < 20.0


def hit(angle: float, noticed: bool = True, body: bool = False) -> ShapeCollision:
    said = dict.fromkeys(study.SOURCES, angle if noticed else math.nan)
    used = angle if noticed else math.nan
    return ShapeCollision(
        "arq", "wall", 2.0, True, True, noticed, said, used, 0.01 * angle, 1, body
    )


def test_errors_are_medians_of_those_noticed() -> None:
    hits = [hit(0.1), hit(0.2, body=True), hit(0.3), hit(0.0, noticed=False)]
    (row,) = shape_errors(hits)
    assert (row.hits, row.missed, row.body) == (4, 1, 1)
    assert row.used[0] == pytest.approx(math.degrees(0.2))
    assert row.used[1] == pytest.approx(math.degrees(np.quantile([0.1, 0.2, 0.3], 0.95)))
    assert "1 of 4 not noticed" in shape_sentences([row])[0]


def test_the_command_writes_its_table(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(study, "shape_collisions", lambda *_, **__: [hit(0.1), hit(0.2)])
    out = tmp_path / "out"
    ran = CliRunner().invoke(cli, ["study", "shapes", "--flights", "1", "--out", str(out)])
    assert ran.exit_code == 0, ran.output
    assert {"shapes.json", "shapes.csv"} <= {path.name for path in out.iterdir()}
