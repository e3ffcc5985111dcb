"""Promises of every figure: units, type that can be read in print, nothing clipped, and its data.

All figures that springback draws are walked, from made-up results; nothing is flown.
"""

import csv
import io
import math
from collections.abc import Iterator
from itertools import combinations
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from builders.campaign_folders import filled
from builders.cases import nonempty
from builders.figures import plane_map, slider_figures
from builders.paper_results import (
    fake_free_flight_results,
    fake_slider_flight,
    fake_slider_results,
    fake_steps_flight,
    with_contact,
)
from interfaces.legible import complaints
from springback.campaign.access import Campaign
from springback.campaign.analysis.marginals import field_map, fields_of, marginal
from springback.interfaces.figures import ablation, campaign, envelope, style
from springback.interfaces.figures import flight as plots
from springback.interfaces.figures.data import CATEGORY, as_table, axis_label, csv_of
from springback.interfaces.reports.page import FigureBlock
from springback.interfaces.reproduction import figure_list, report
from springback.interfaces.reproduction import overview as report_overview
from springback.interfaces.reproduction.figures import drawings, free_flight, overview
from springback.interfaces.reproduction.report import Results
from springback.paper.printed import printed_success
from springback.studies.ablation import RANGES, ROBOTS, VARIANTS, AblationOutcome, WhyResults
from springback.studies.run_ups import CONDITIONS


def why_results() -> WhyResults:
    """Every variant and range, with successes that differ."""

    def cell(
        cause: str, name: str, robot: str, pitch: float, speed: float, k: int
    ) -> AblationOutcome:
        return AblationOutcome(
            cause, name, robot, pitch, speed, k % 11, 10, {}, 0.5, 0.1, -0.1, 1.0
        )

    cells = [
        cell(v.cause, v.name, robot, *test, i + j)
        for i, v in enumerate(VARIANTS) for robot in v.robots for j, test in enumerate(CONDITIONS)
    ]  # fmt: skip
    ranges = [
        cell(one.name, f"{value:g}", robot, *test, i)
        for one in RANGES for i, value in enumerate(one.values) for robot in ROBOTS
        for test in CONDITIONS
    ]  # fmt: skip
    return WhyResults(cells, ranges)


def campaign_figures(folder: Path) -> dict[str, Figure]:
    filled(folder)
    told = Campaign(folder)
    found = [marginal(told, name) for name in fields_of(told)]
    over = field_map(told, "pitch", "surface", 6)
    return {
        "marginals": campaign.marginals_figure(found),
        "field map": campaign.field_map_figure(over),
    }


@pytest.fixture(scope="module")
def figures(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Figure]:
    """Every figure; those of collisions in flight and of detection are in tests of their own, and the
    one for a front page names peaks that are one where both robots are made up alike."""
    results, slider = fake_free_flight_results(), fake_slider_results()
    rows = [*slider.rows, *results.rows()]
    flight = fake_steps_flight("quad")
    return {
        **{name: made for name, made in slider_figures().items() if name != "readme"},
        "steps": free_flight.steps_figure(results),
        "circles": free_flight.circles_figure(results),
        "table iv": free_flight.table_iv_figure(results),
        "endurance": free_flight.endurance_figure(),
        "guided": plots.flight_figure(flight),
        "touching": plots.flight_figure(with_contact(flight)),
        "overview": overview.overview_figure(report_overview.groups(rows)),
        "robots drawn": drawings.robots_figure(),
        "map": envelope.map_figure(plane_map(), printed_success),
        "ablation": ablation.ablation_figure(why_results()),
        "ranges": ablation.ranges_figure(why_results()),
        **campaign_figures(tmp_path_factory.mktemp("campaign") / "c"),
    }


def test_nobody_can_complain_about_a_figure(figures: dict[str, Figure]) -> None:
    found = {name: complaints(figure) for name, figure in figures.items()}
    assert {name: words for name, words in found.items() if words} == {}


def test_complaints_are_made_where_they_should_be() -> None:
    figure = Figure(figsize=(style.WIDTH, 2.0))
    ax = figure.subplots()
    ax.plot([0, 1], [0, 1])
    ax.set_xlabel("time")
    ax.text(0.5, 0.5, "one word", fontsize=9)
    ax.text(0.5, 0.52, "another", fontsize=9)
    ax.text(0.5, 0.1, "tiny", fontsize=5)
    ax.text(0.95, 0.8, "far too long to fit into this figure", fontsize=9)
    words = " ".join(complaints(figure))
    assert "'one word' lies on 'another'" in words
    assert "'tiny' is 3.65 pt" in words
    assert "fit into this figure' is cut off" in words
    assert "has no unit: 'time'" in words


# -- the same as data


def shown_lines(figure: Figure) -> Iterator[tuple[Any, Line2D]]:
    for ax in figure.axes:
        parts = {id(c.lines[0]) for c in ax.containers if hasattr(c, "lines")}
        caps = {id(p) for c in ax.containers if hasattr(c, "lines") for p in c.lines[1]}
        for line in ax.lines:
            across, up = line.get_transform().contains_branch_seperately(ax.transData)  # type: ignore[attr-defined]
            if id(line) not in parts | caps and across and up:
                yield ax, line


def test_picture_and_data_agree(figures: dict[str, Figure]) -> None:
    """Each point that is drawn is in a row, under the labels of its own axes."""
    for name, figure in nonempty(figures.items()):
        heads, *rows = list(csv.reader(io.StringIO(csv_of(figure))))
        assert heads[:2] == ["panel", "series"], name
        assert rows, name
        for ax, line in shown_lines(figure):
            labels = [axis_label(ax, which) or CATEGORY for which in "xy"]
            under = [heads.index(label) for label in labels]
            worded = any(row[k] and not _number(row[k]) for k in under for row in rows)
            drawn = np.array([line.get_xdata(), line.get_ydata()], float).T
            drawn = drawn[np.isfinite(drawn).all(axis=1)]
            if worded or not len(drawn):  # places on an axis of words are told by the words
                continue
            told = np.array([[row[k] for k in under] for row in rows if all(row[k] for k in under)])
            for point in drawn[:: max(1, len(drawn) // 7)]:
                near = np.isclose(told.astype(float), point, rtol=1e-8, atol=1e-12)
                assert near.all(axis=1).any(), (name, heads[under[0]], heads[under[1]], point)


def _number(text: str) -> bool:
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


def test_heads_have_units(figures: dict[str, Figure]) -> None:
    for name, figure in nonempty(figures.items()):
        heads, rows = as_table(figure)
        for k, head in nonempty(enumerate(heads[2:], start=2)):
            numbers = any(isinstance(row[k], float) for row in rows)
            assert not numbers or "]" in head, (name, head)


def test_a_bar_a_band_a_cell_and_a_word_are_told_as_what_they_are() -> None:
    figure = Figure()
    one, two, three = figure.subplots(1, 3)
    one.bar([0.8, 1.8], [3.0, -4.0], 0.4, label="robot")
    one.set_xticks([1, 2], ["1", "2"])
    one.set(xlabel="Speed [m/s]", ylabel="Force [N]")
    two.fill_between([0.0, 1.0, 2.0], [1.0, 2.0, 3.0], [2.0, 4.0, 6.0], label="_band")
    two.errorbar([1.0], [5.0], yerr=[[0.5], [1.0]], label="point")
    two.axvline(1.5, label="_limit")
    two.set(xlabel="Time [s]", ylabel="Height [m]")
    three.pcolormesh([0, 1, 2], [0, 1], [[7.0, 8.0]])
    three.set_yticks([0.5], ["ground"])
    three.set(xlabel="Time [s]")
    for ax, name in zip((one, two, three), "abc", strict=True):
        ax.set_title(name, loc="left")
    heads, rows = as_table(figure)
    told = [{h: v for h, v in zip(heads, row, strict=True) if v is not None} for row in rows]
    assert {"panel": "a", "series": "robot", "Speed [m/s]": 2.0, "Force [N]": -4.0} in told
    band = {"panel": "b", "series": "band", "Time [s]": 1.0}
    assert band | {"Height [m], low": 2.0, "Height [m], high": 4.0} in told
    point = {"panel": "b", "series": "point", "Time [s]": 1.0, "Height [m]": 5.0}
    assert point | {"Height [m], low": 4.5, "Height [m], high": 6.0} in told
    assert {"panel": "b", "series": "limit", "Time [s]": 1.5} in told
    cell = {"panel": "c", "series": "", "Time [s]": 1.5, "category": "ground", "value [-]": 8.0}
    assert cell in told


def test_data_are_written_beside_the_picture_and_say_the_same_again(tmp_path: Path) -> None:
    figure = plots.energy_figure(fake_slider_flight())
    files = style.save(figure, tmp_path / "energy")
    assert files[-1].read_text(encoding="utf-8") == csv_of(figure)
    assert [file.suffix for file in style.save(figure, tmp_path / "b", numbers=False)] == [".png", ".pdf"]  # fmt: skip
    with mpl.rc_context({"text.usetex": True, "font.size": 30.0}):
        assert csv_of(plots.energy_figure(fake_slider_flight())) == csv_of(figure)


# -- looks


def test_curves_of_a_panel_differ_in_grey_by_more_than_colour() -> None:
    styles = [str(line) for _, line in style.LOOKS]
    assert len(set(styles)) == len(styles)


def test_colours_are_told_apart_by_the_colour_blind() -> None:
    """Okabe and Ito's colours as deuteranopes see them (Machado and others, 2009, full severity)."""
    seen = np.array([
        [0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881],
    ])  # fmt: skip
    colours = [np.array(to_rgb(colour)) for colour in (style.BLUE, style.RED, style.ORANGE, style.GREEN)]  # fmt: skip
    for one, other in nonempty(combinations(colours, 2)):
        assert np.linalg.norm(seen @ one**2.2 - seen @ other**2.2) > 0.08


# -- figures of the paper


def test_every_figure_of_the_paper_has_its_counterpart_or_says_why_not() -> None:
    assert [figure.name for figure in figure_list.PAPER_FIGURES] == [
        f"Fig. {k}" for k in range(1, 12)
    ]
    known = set(figure_list.WORDS.text["ours"])
    for figure in figure_list.PAPER_FIGURES:
        assert figure.ours or figure.note
        assert set(figure.ours) <= known
    source = "".join(path.read_text("utf-8") for path in Path(report.__file__).parent.glob("*.py"))  # fmt: skip
    for name in known - {"slider_quad", "slider_arq"}:
        assert f'"{name}"' in source, name
    assert 'f"slider_{robot}"' in source


def test_the_table_leads_to_figures_that_are_there() -> None:
    told = Results(slider=fake_slider_results())
    sections = report.report_sections(told, {})
    drawn = {b.anchor for s in sections for b in s.blocks if isinstance(b, FigureBlock)}
    (section,) = [s for s in sections if s.anchor == "figures"]
    links = [link for row in section.blocks[0].rows for cell in row for link in cell.links]  # type: ignore[union-attr]
    assert {anchor for _, anchor in links} <= drawn
    assert "figure-contact_drawn" in drawn
    missing = [row[0].text for row in section.blocks[0].rows if "not in this report" in row[2].text]  # type: ignore[union-attr]
    assert missing == ["Fig. 1", "Fig. 9", "Fig. 10", "Fig. 11"]
