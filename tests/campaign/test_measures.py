"""Summaries of any measure: what they count, and indices that recover a known truth."""

from __future__ import annotations

import html
import math
import shlex
from pathlib import Path
from typing import Any

import duckdb
import numpy as np
import pytest

from builders.campaign_folders import filled
from builders.plans import PITCH, SPEED, SURFACE
from springback.campaign.access import Campaign
from springback.campaign.analysis.distribution import distribution
from springback.campaign.analysis.failures import failures
from springback.campaign.analysis.marginals import field_map, fields_of, marginal, measure_column
from springback.campaign.analysis.sensitivity import first_order_indices, sensitivity
from springback.campaign.analysis.statistics import summary
from springback.errors import InputError
from springback.interfaces.figures.campaign import field_map_figure, marginals_figure
from springback.interfaces.figures.chart import share_place
from springback.interfaces.figures.measures import distribution_figure, sensitivity_figure
from springback.interfaces.reports.campaign import summary_text, write_summary
from springback.interfaces.reports.measures import measure_report

STROKE = "impact_arm_stroke"
#: First-order indices of Ishigami's function with a = 7 and b = 0.1 (Saltelli et al. 2008).
ISHIGAMI = {"x1": 0.3139, "x2": 0.4424, "x3": 0.0}


@pytest.fixture(scope="module")
def campaign(tmp_path_factory: pytest.TempPathFactory) -> Campaign:
    folder = tmp_path_factory.mktemp("measures")
    filled(folder, parts=4, size=200, samples=200, repeats=2)
    return Campaign(folder)


def of(campaign: Campaign, robot: str) -> list[dict[str, Any]]:
    rows = campaign.query("FROM flights WHERE outcome <> 'refused'").as_dicts()
    found = [row for row in rows if row["robot"] == robot]
    assert len(found) > 300
    return found


def test_a_distribution_counts_flights_with_and_without(campaign: Campaign) -> None:
    found = distribution(campaign, STROKE)
    assert (found.measure.unit, found.measure.name) == ("m", STROKE)
    for robot in ("arq", "quad"):
        wanted = np.sort([row[STROKE] for row in of(campaign, robot)])
        assert found.values[robot].tolist() == wanted.tolist()
        assert found.without(robot) == 0
        values = [quantile.value for quantile in found.quantiles(robot)]
        assert values == pytest.approx(np.quantile(wanted, (0.05, 0.5, 0.95)))
    assert distribution(campaign, "speed").measure.unit == "m/s"  # varied fields, too


def test_marginals_of_a_measure_are_medians_and_bands(campaign: Campaign) -> None:
    rows = of(campaign, "arq")
    [wall, mat] = marginal(campaign, "surface", measure=STROKE).robots["arq"]
    for cell, word in ((wall, "wall"), (mat, "mat")):
        wanted = [row[STROKE] for row in rows if row["surface"] == word]
        assert cell.flights == len(wanted)
        assert cell.estimate.value == pytest.approx(np.median(wanted))
        assert cell.band == pytest.approx(np.quantile(wanted, (0.05, 0.95)))
        assert cell.estimate.low < cell.estimate.value < cell.estimate.high
    along = marginal(campaign, "speed", 6, measure=STROKE).robots["arq"]
    assert sum(cell.flights for cell in along) == len(rows)
    assert [cell.place for cell in along] == sorted(cell.place for cell in along)


def test_maps_of_a_measure_hold_medians_and_counts(campaign: Campaign) -> None:
    rows = of(campaign, "quad")
    found = field_map(campaign, "speed", "surface", 3, measure=STROKE)
    assert found.flights["quad"].sum() == len(rows)
    edges = found.x.edges
    for j, word in enumerate(found.y.labels):
        for i in range(3):
            inside = [
                row[STROKE] for row in rows
                if row["surface"] == word and np.searchsorted(edges[1:-1], row["speed"], "right") == i
            ]  # fmt: skip
            assert found.flights["quad"][j, i] == len(inside)
            assert found.values["quad"][j, i] == pytest.approx(np.median(inside))


def test_cells_hold_value_and_count_and_the_scale_parts_0_9_from_1(campaign: Campaign) -> None:
    figure = field_map_figure(field_map(campaign, "speed", "surface", 4))
    [value, count] = figure.axes[0].texts[0].get_text().split("\n")
    assert 0.0 <= float(value) <= 1.0
    assert count.startswith("n = ")
    assert len(figure.axes[0].texts) == 8
    assert share_place(1.0) - share_place(0.9) >= 0.25
    many = field_map_figure(field_map(campaign, "speed", "pitch", 9))
    assert not many.axes[0].texts
    assert "flights in a cell" in many.axes[0].get_title(loc="right")


def test_measures_are_refused_by_name(campaign: Campaign) -> None:
    for name, why in (
        ("impact_arm_strok", "did you mean impact_arm_stroke?"),
        ("surface", "holds words"),
        ("outcome", "holds words"),
        ('a" FROM flights; DROP TABLE x; --', "is no column"),
    ):
        with pytest.raises(InputError, match=f"{why}".replace("?", r"\?")):
            measure_column(campaign, name)
    with pytest.raises(InputError, match="recovery_time: no flight of this campaign has it"):
        distribution(campaign, "recovery_time")


def ishigami(count: int, repeats: int = 1) -> tuple[dict[str, Any], Any, Any]:
    """Fields, values and samples of Ishigami's function, each sample flown several times."""
    x = np.random.default_rng(count).uniform(-math.pi, math.pi, (count, 3)).repeat(repeats, axis=0)
    y = np.sin(x[:, 0]) + 7.0 * np.sin(x[:, 1]) ** 2 + 0.1 * x[:, 2] ** 4 * np.sin(x[:, 0])
    return dict(zip(ISHIGAMI, x.T, strict=True)), y, np.arange(count).repeat(repeats)


@pytest.mark.parametrize(("count", "width"), [(512, 0.2), (8192, 0.06)])
def test_indices_recover_a_known_truth(count: int, width: float) -> None:
    found = first_order_indices(*ishigami(count))
    for name, truth in ISHIGAMI.items():
        index = found[name]
        assert index.low <= truth <= index.high
        assert index.high - index.low < width
        assert abs(index.value - truth) < 0.5 * width


def test_a_field_of_levels_that_explains_all_has_index_one() -> None:
    chance = np.random.default_rng(4)
    levels, other = chance.integers(0, 3, 400).astype(float), chance.random(400)
    found = first_order_indices({"levels": levels, "other": other}, levels**2, np.arange(400.0))
    assert found["levels"].value == pytest.approx(1.0)
    assert found["other"].value < 0.1


def test_repeats_of_a_sample_are_no_further_samples() -> None:
    """Flying each sample four times over adds nothing, so the interval must not shrink."""
    once, often = (first_order_indices(*ishigami(256, n))["x1"] for n in (1, 4))
    assert often.high - often.low > 0.8 * (once.high - once.low)


def test_sensitivity_of_success_names_the_field_that_decides(campaign: Campaign) -> None:
    found = sensitivity(campaign, "success", fields_of(campaign))
    assert found.refusal == ""
    assert found.ranking()[0] == "speed"  # made up so
    assert found.robots["arq"]["speed"].value > found.robots["arq"]["pitch"].high
    assert found.robots["arq"]["surface"].high < 0.1  # of words


def test_sensitivity_says_why_it_cannot_be_had(tmp_path: Path, campaign: Campaign) -> None:
    vary = [SPEED | {"count": 6}, PITCH | {"count": 5}, SURFACE]
    filled(tmp_path / "grid", method="grid", samples=None, vary=vary)
    filled(tmp_path / "few", samples=15)
    for name, why in (("grid", "a grid has levels"), ("few", "at least 128 are needed")):
        one = Campaign(tmp_path / name)
        found = sensitivity(one, STROKE, fields_of(one))
        assert why in found.refusal
        assert found.robots == {}
    assert "no sensitivity: " in summary_text(summary(one), [measure_report(one, STROKE)])


def test_figures_of_a_measure_have_their_numbers_in_tables(campaign: Campaign) -> None:
    report = measure_report(campaign, STROKE)
    assert report.distribution is not None
    heads = {
        "distribution": distribution_figure(report.distribution).csv(),
        "marginals": marginals_figure(report.marginals).csv(),
        "sensitivity": sensitivity_figure(report.sensitivity).csv(),
    }
    assert "impact arm stroke [m]" in heads["distribution"].splitlines()[0]
    assert "5 to 95 % of flights" in heads["marginals"]
    assert heads["sensitivity"].count("speed") == 2


def test_stored_flights_are_listed(campaign: Campaign) -> None:
    found = failures(campaign)
    lost = campaign.query(
        """SELECT flight FROM flights WHERE success = 0
           ORDER BY impact_peak_acceleration DESC NULLS LAST, flight"""
    ).rows
    assert found.failed == len(lost)
    assert [row["flight"] for row in found.rows] == [flight for (flight,) in lost[:20]]
    assert found.kept == ()
    (campaign.folder / "kept").mkdir()
    last = lost[-1][0]
    (campaign.folder / f"kept/flight-{last:010d}.json").write_text("{}")
    (campaign.folder / "kept/flight-9999999999.json").write_text("{}")  # of no flight
    [first] = failures(campaign).kept
    assert (first["flight"], first["kept"]) == (last, True)


def test_a_page_shows_measures_and_commands(tmp_path: Path) -> None:
    filled(tmp_path / "a 'b'", samples=15, vary=[SPEED, SURFACE])
    known = Campaign(tmp_path / "a 'b'")
    written = write_summary(
        summary(known), tmp_path, measures=[measure_report(known, STROKE)], cells=3
    )
    text = html.unescape((tmp_path / "summary.html").read_text())
    folder = shlex.quote(str(known.folder))
    assert f"<code>springback view {folder} {failures(known).rows[0]['flight']}</code>" in text
    assert "95 % interval of the median" in text
    assert text.count("Indices are missing: ARQ has it in 1") == 2
    assert {path.name for path in written if path.suffix == ".csv"} == {
        "marginals.csv", "map-speed-surface.csv", f"distribution-{STROKE}.csv",
        f"marginals-{STROKE}.csv", f"map-{STROKE}-speed-surface.csv",
    }  # fmt: skip


def test_files_of_a_page_have_plain_names(tmp_path: Path) -> None:
    vary = [
        SPEED,
        {"field": "start.position.1", "from": "-1 cm", "to": "1 cm"},
        {"field": "start.position.2", "name": "start.position.1", "from": "1 m", "to": "1.1 m"},
        {"field": "surface", "name": "fläche", "values": ["wall", "mat"]},
    ]
    filled(tmp_path / "c", samples=15, vary=vary)
    (tmp_path / "page").mkdir()
    write_summary(summary(Campaign(tmp_path / "c")), tmp_path / "page", cells=3)
    names = sorted(path.name for path in (tmp_path / "page").glob("map-*.png"))
    assert names == [
        "map-speed-fl_che.png", "map-speed-start.position.1-2.png",
        "map-speed-start.position.1.png", "map-start.position.1-fl_che-2.png",
        "map-start.position.1-fl_che.png", "map-start.position.1-start.position.1.png",
    ]  # fmt: skip
    text = (tmp_path / "page" / "summary.html").read_text()
    for name in names:
        assert text.count(f'id="figure-{Path(name).stem}"') == 1


def test_rows_that_no_flight_made_are_read_or_refused(tmp_path: Path) -> None:
    """Parts forged so that all digests fit: none of these may raise anything else."""
    filled(tmp_path / "c", samples=20, parts=1, size=40)
    known = Campaign(tmp_path / "c")
    part, new = known.folder / known.parts[0].file, tmp_path / "new.parquet"
    own = part.read_bytes()
    refused = set()
    for forged in (
        "'abc' AS impact_arm_stroke", "'inf'::DOUBLE AS impact_arm_stroke", "'other' AS robot",
        "'tree' AS surface", "NULL::DOUBLE AS speed", "'NaN'::DOUBLE AS speed", "-5 AS success",
        "0.0 AS stiffness_factor",
    ):  # fmt: skip
        part.write_bytes(own)
        rows = f"SELECT * REPLACE ({forged}) FROM read_parquet('{part}')"
        with duckdb.connect() as database:
            database.execute(f"COPY ({rows}) TO '{new}' (FORMAT parquet)")
        part.write_bytes(new.read_bytes())
        try:
            summary(known)
            measure_report(known)
            measure_report(known, STROKE)
            failures(known)
            field_map(known, "stiffness_factor", "surface", measure=STROKE)
        except InputError:
            refused.add(forged.rpartition(" ")[2])
    assert refused == {STROKE, "robot", "success"}
