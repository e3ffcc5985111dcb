"""Surfaces drawn by material: ranges with their sources, from a plan to the summary."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

from builders.cases import nonempty
from springback.batch.scenarios import fly_scenarios
from springback.campaign.design.layout import lay_out
from springback.campaign.design.plan import Plan, plan_from, read_plan
from springback.campaign.running import run_campaign
from springback.errors import InputError
from springback.interfaces.cli.app import cli
from springback.interfaces.reports.outcomes import drawn_ranges
from springback.vehicle.materials import MATERIALS
from springback.vehicle.stiffness import (
    cantilever_stiffness,
    contact_modulus,
    hertz_stiffness,
    pad_stiffness,
    ring_stiffness,
    rod_second_moment,
    shell_stiffness,
)

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


ENTRIES = """\
method = "random"
samples = 8
[scenario]
vehicle = "quad"
start = { velocity = [2, 0, 0], position = [0, 0, 1], touch_distance = 0.001 }
[[scenario.world.obstacles]]
type = "wall"
distance = 1
surface = { preset = "wall"SPEED }
[[vary]]
field = "surface"
material = "drywall"
[[vary]]
field = "FIELD"
from = "1 m/s"
to = "3 m/s"
[[vary]]
field = "start.velocity.0"
from = "1 m/s"
to = "2 m/s"
"""


@pytest.mark.parametrize(
    ("field", "speed", "words"),
    [
        ("speed", ', restitution_speed = "2 m/s"', r":14: vary\[1\]\.field: 'speed' needs"),
        (
            "start.velocity[0]",
            ', restitution_speed = "2 m/s"',
            r":18: vary\[2\]\.field: is varied by entry 2 already",
        ),
        ("start.velocity.1", "", r":12: vary\[0\]\.material: .*restitution_speed: is missing"),
    ],
)
def test_problems_name_entries_as_they_are_written(
    field: str, speed: str, words: str, tmp_path: Path
) -> None:
    """A material is two fields: the second entry was the third, without a line."""
    text = ENTRIES.replace("FIELD", field).replace("SPEED", speed)
    (tmp_path / "plan.toml").write_text(text)
    with pytest.raises(InputError, match=rf"plan\.toml{words}"):
        lay_out(*read_plan(tmp_path / "plan.toml"))


def test_a_table_that_is_not_given_is_not_added_by_what_varies() -> None:
    """A plan of a throw was warned that its control is not used."""
    surface = {"field": "surface", "material": "drywall"}
    [base] = lay_out(plan_from(plan(surface))).bases
    assert base.keys() == {*SCENARIO}
    [base] = lay_out(plan_from(plan(surface, scatter={"mass": 0.05}))).bases
    assert base.keys() == {*SCENARIO, "model_error"}


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


GUARDS: dict[str, tuple[dict[str, Any], float, float]] = {
    "ring": ({"rod": "4 mm", "inner": "3 mm", "radius": "11 cm"}, 1.0, ring_stiffness(
        1.0, rod_second_moment(0.004, 0.003), 0.11)),
    "cantilever": ({"rod": "4 mm", "length": "10 cm"}, 1.0, cantilever_stiffness(
        1.0, rod_second_moment(0.004), 0.1)),
    "shell": ({"thickness": "1 mm", "radius": "15 cm"}, 1.0, shell_stiffness(1.0, 0.45, 1e-3, 0.15)),
    "pad": ({"area": "4 cm^2", "thickness": "1 cm"}, 1.0, pad_stiffness(1.0, 4e-4, 0.01)),
    "sphere": ({"radius": "3 cm"}, 1.5, hertz_stiffness(contact_modulus(1.0, 0.45), 0.03)),
}  # fmt: skip


@pytest.mark.parametrize("shape", GUARDS)
def test_the_stiffness_of_a_guard_is_drawn_by_its_material(shape: str) -> None:
    """Between those of the lowest and the highest modulus that are known of it."""
    keys, exponent, per_modulus = GUARDS[shape]
    guard = {"type": shape, "material": "tpu", **keys}
    stiffness, power = plan_from(plan({"field": "vehicle.hulls.0.surface", "guard": guard})).vary
    young = MATERIALS["tpu"].young
    assert young is not None
    assert (stiffness.field, power.field) == (
        "vehicle.hulls.0.surface.stiffness", "vehicle.hulls.0.surface.exponent",
    )  # fmt: skip
    assert stiffness.from_ == pytest.approx(young.low * per_modulus, rel=1e-12)
    assert stiffness.to == pytest.approx(young.high * per_modulus, rel=1e-12)
    assert power.values == (exponent,)
    assert stiffness.source is not None
    assert f"a {shape} of tpu, derived; its modulus from memory" in stiffness.source


def test_derived_ends_of_a_range_are_told_in_five_digits() -> None:
    """10178.976517282323 stood on the page."""
    guard = {"type": "ring", "material": "carbon", "rod": "4 mm", "inner": "3 mm",
             "radius": "73.5 mm"}  # fmt: skip
    given = plan_from(plan({"field": "vehicle.hulls.0.surface", "guard": guard}))
    said = drawn_ranges(SimpleNamespace(design=SimpleNamespace(plan=given)))  # type: ignore[arg-type]
    assert said[0].startswith("vehicle.hulls.0.surface.stiffness 10179 to 18904 (")


def test_a_guard_flies_with_its_stiffness() -> None:
    """A softer guard feels less: peaks fall with the stiffness that was drawn."""
    hull = {"type": "sphere", "radius": 0.4, "surface": {
        "stiffness": 1e4, "exponent": 1.0, "in_series": False, "viscosity": 5.0}}  # fmt: skip
    guard = {
        "type": "ring",
        "material": "carbon",
        "rod": "4 mm",
        "inner": "3 mm",
        "radius": "11 cm",
    }
    given = plan({"field": "vehicle.hulls.0.surface", "guard": guard}, samples=6)
    vehicle = {"preset": "quad", "hulls": [hull]}
    given["scenario"] = SCENARIO | {"vehicle": vehicle, "simulation": {"duration": 0.15}}
    tables = lay_out(plan_from(given)).slice(0, 6).tables
    peaks = fly_scenarios(tables).measures["impact_peak_acceleration"]
    drawn = [one["vehicle"]["hulls"][0]["surface"]["stiffness"] for one in tables]
    order = np.argsort(drawn)
    assert np.all(np.diff(np.asarray(peaks)[order]) > 0.0)


@pytest.mark.parametrize(
    ("guard", "message"),
    [
        (
            {"type": "hook", "material": "tpu"},
            "vary[0].guard.type: must be ring, cantilever, shell, pad or sphere (got 'hook')",
        ),
        ({"type": "ring", "material": "tpu", "rod": "4 mm"}, "vary[0].guard.radius: is missing"),
        (
            {"type": "ring", "material": "tpu", "rod": "4 N", "radius": 0.1},
            "vary[0].guard.rod: has the wrong unit",
        ),
        (
            {"type": "ring", "material": "tpu", "rod": "4 mm", "inner": "5 mm", "radius": 0.1},
            "vary[0].guard: inner must be at least 0 and less than 0.004 m",
        ),
        (
            {"type": "pad", "material": "epp", "area": 1e-3, "thickness": 0.01},
            "vary[0].guard.material: must have a modulus",
        ),
        (
            {"type": "sphere", "material": "carbon", "radius": 0.01},
            "vary[0].guard.material: must have a Poisson",
        ),
        (
            {"type": "pad", "material": "tpuu", "area": 1e-3, "thickness": 0.01},
            "vary[0].guard.material: must be a material, did you mean tpu?",
        ),
    ],
)
def test_wrong_guards_are_refused_in_one_line(guard: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError) as caught:
        plan_from(plan({"field": "vehicle.hulls.0.surface", "guard": guard}))
    [line] = caught.value.problems
    assert message in line
