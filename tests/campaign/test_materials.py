"""Surfaces drawn by material: ranges with their sources, from a plan to the summary."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

from builders.cases import nonempty
from springback.campaign.design.layout import lay_out
from springback.campaign.design.plan import Plan, plan_from
from springback.campaign.running import run_campaign
from springback.errors import InputError
from springback.interfaces.cli.app import cli
from springback.vehicle.materials import MATERIALS

SURFACE = {"restitution": 0.5, "restitution_speed": "2 m/s", "friction": 0.4}
SCENARIO = {
    "vehicle": "quad",
    "world": {"obstacles": [{"type": "wall", "distance": 1.0, "surface": SURFACE}]},
    "start": {"velocity": [2.0, 0, 0], "position": [0, 0, 1], "touch_distance": 0.001},
    "simulation": {"duration": 0.05},
}


def plan(*vary: dict[str, Any], **more: Any) -> dict[str, Any]:
    return {"scenario": SCENARIO, "method": "random", "samples": 8, "vary": list(vary), **more}


def test_a_material_is_its_ranges() -> None:
    found = plan_from(plan({"field": "surface", "material": "drywall"})).vary
    assert [one.field for one in found] == [
        "world.obstacles.0.surface.restitution", "world.obstacles.0.surface.friction",
    ]  # fmt: skip
    known = MATERIALS["drywall"]
    for one, span in zip(found, (known.restitution, known.friction), strict=True):
        assert span is not None
        assert (one.from_, one.to) == (span.low, span.high)
        assert one.source is not None
        assert span.source in one.source
    [friction] = plan_from(plan({"field": "surface", "material": "steel"})).vary
    assert friction.field.endswith("friction")  # a hard guard's restitution is the guard's


def test_stored_and_read_again_it_is_the_same() -> None:
    first = plan_from(plan({"field": "world.obstacles.0.surface", "material": "bark"}))
    again = Plan.model_validate_json(first.canonical())
    assert again == first
    assert again.digest() == first.digest()


@pytest.mark.parametrize("speed", [{}, {"restitution_speed": "2 m/s"}], ids=["without", "with"])
def test_beside_a_preset_a_drawn_restitution_needs_its_speed(speed: dict[str, str]) -> None:
    """That of the preset is of its own restitution; the line says what is missing, and where."""
    wall = {"type": "wall", "distance": 1.0, "surface": {"preset": "wall", **speed}}
    given = plan({"field": "surface", "material": "drywall"})
    given["scenario"] = SCENARIO | {"world": {"obstacles": [wall]}}
    if not speed:
        with pytest.raises(
            InputError, match=r"obstacles\[0\]\.surface\.restitution_speed: is miss"
        ):
            lay_out(plan_from(given))
        return
    (drawn,) = lay_out(plan_from(given)).slice(0, 1).tables[0]["world"]["obstacles"]
    assert drawn["surface"]["restitution_speed"] == "2 m/s"
    assert 0.3 <= drawn["surface"]["restitution"] <= 0.5


def test_flights_are_within_the_ranges_and_the_summary_says_so(tmp_path: Path) -> None:
    given = plan({"field": "surface", "material": "drywall"}, seed=3)
    campaign = run_campaign(plan_from(given), tmp_path / "walls")
    table = campaign.to_dataframe()
    known = MATERIALS["drywall"]
    for span, column in ((known.restitution, "restitution"), (known.friction, "friction")):
        assert span is not None
        [name] = [one for one in table.columns if one.endswith(f"surface.{column}")
                  or one == column or one.endswith(f"surface_{column}")]  # fmt: skip
        values = np.asarray(table[name], dtype=float)
        assert values.min() >= span.low
        assert values.max() <= span.high
        assert np.ptp(values) > 0.2 * (span.high - span.low)
    said = CliRunner().invoke(cli, ["summary", str(tmp_path / "walls")])
    assert said.exit_code == 0
    assert "drawn: world.obstacles.0.surface.restitution 0.3 to 0.5" in said.output
    assert "from memory" in said.output


@pytest.mark.parametrize(
    ("field", "message"),
    [
        (
            {"field": "surface", "material": "drywal"},
            "vary[0].material: must be a material, did you",
        ),
        ({"field": "surface", "material": 3}, "vary[0].material: must be a material"),
        ({"field": "speed", "material": "drywall"}, "vary[0].field: must be a surface"),
        ({"material": "drywall"}, "vary[0].field: must be a surface"),
        (
            {"field": "surface", "material": "drywall", "from": 0.2, "to": 0.3},
            "vary[0].material: has a range of its own",
        ),
    ],
)
def test_wrong_materials_are_refused_in_one_line(field: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError) as caught:
        plan_from(plan(field))
    [line] = caught.value.problems
    assert line.startswith(message)


def test_every_range_says_where_it_is_from() -> None:
    for name, one in nonempty(MATERIALS.items()):
        spans = [span for span in (one.young, one.restitution, one.friction) if span is not None]
        assert spans, name
        for span in spans:
            assert 0.0 <= span.low < span.high
            assert span.low <= span.typical <= span.high
            assert span.source.split(" ")[0].rstrip(":") in ("measured", "derived", "from"), name


def test_show_lists_them() -> None:
    said = CliRunner().invoke(cli, ["show", "drywall"])
    assert said.exit_code == 0
    assert "from memory" in said.output
    assert "drywall" in CliRunner().invoke(cli, ["show"]).output
