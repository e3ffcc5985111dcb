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
from interfaces.legible import axis_label, complaints
from springback.campaign.access import Campaign
from springback.campaign.analysis.marginals import (
    SUCCESS,
    FieldMap,
    Marginal,
    MarginalCell,
    MeasureColumn,
    Scale,
    field_map,
    fields_of,
    marginal,
)
from springback.campaign.analysis.sensitivity import Sensitivity
from springback.interfaces.figures import ablation, campaign, envelope, style
from springback.interfaces.figures import flight as plots
from springback.interfaces.figures.chart import Chart
from springback.interfaces.figures.fits.likelihood import correlations_figure
from springback.interfaces.figures.measures import sensitivity_figure
from springback.interfaces.figures.style import StyledFigure
from springback.interfaces.output import robots
from springback.interfaces.reports.page import FigureBlock
from springback.interfaces.reproduction import figure_list, report
from springback.interfaces.reproduction import overview as report_overview
from springback.interfaces.reproduction.figures import drawings, free_flight, overview
from springback.interfaces.reproduction.report import Results
from springback.intervals import IntervalEstimate
from springback.paper.printed import printed_success
from springback.studies.ablation import RANGES, ROBOTS, VARIANTS, AblationOutcome, WhyResults
from springback.studies.run_ups import CONDITIONS


def why_results() -> WhyResults:
    """Every variant and range, with successes that differ."""

    def cell(
        cause: str, name: str, robot: str, pitch: float, speed: float, k: int
    ) -> AblationOutcome:
        return AblationOutcome(robot, pitch, speed, 10, k % 11, {}, {}, cause, name)

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


def campaign_figures(folder: Path) -> dict[str, StyledFigure]:
    filled(folder)
    told = Campaign(folder)
    found = [marginal(told, name) for name in fields_of(told)]
    over = field_map(told, "pitch", "surface", 6)
    return {
        "marginals": campaign.marginals_figure(found),
        "field map": campaign.field_map_figure(over),
    }


#: Fields as materials and guards draw them, with long paths; and those of a fit with all that is
#: known of a vehicle.
LONG = {
    "vehicle.hulls[0].surface.stiffness": "N/m", "vehicle.hulls[0].surface.dissipation": "s/m",
    "world.obstacles[0].surface.restitution": "", "friction": "",
    "start.velocity[0]": "m/s",
}  # fmt: skip
FITTED = [
    *(f"world.obstacles.0.surface.{name}" for name in ("stiffness", "dissipation", "friction")),
    *(f"vehicle.arms.{name}" for name in ("stiffness", "damping", "mass")), "vehicle.body.mass",
    *(f"vehicle.arms.directions.{k}" for k in range(4)),
    *(f"vehicle.body.inertia.{k}" for k in range(3)),
]  # fmt: skip


def long_figures() -> dict[str, StyledFigure]:
    """Figures of fields with long names, and of many of them."""
    edges = tuple(np.linspace(10000.0, 20000.0, 5))
    scales = [Scale(name, unit, (), edges, False, "") for name, unit in LONG.items()]
    cells = tuple(MarginalCell(at, 9, IntervalEstimate(0.5, 0.3, 0.7)) for at in edges)
    success = MeasureColumn(SUCCESS, "", "")
    found = [Marginal(success, one, {"arq": cells}) for one in scales]
    over = FieldMap(
        success, scales[0], scales[2], {"arq": np.full((4, 4), 9)}, {"arq": np.full((4, 4), 0.5)}
    )
    indices = {name: IntervalEstimate(0.3, 0.2, 0.4) for name in LONG}
    rest = np.random.default_rng(1).normal(size=(len(FITTED), 20))
    return {
        "long marginals": campaign.marginals_figure(found),
        "long map": campaign.field_map_figure(over),
        "long indices": sensitivity_figure(Sensitivity(success, {"arq": indices}, {"arq": 9})),
        "many correlations": correlations_figure(FITTED, np.corrcoef(rest)),
    }


@pytest.fixture(scope="module")
def figures(tmp_path_factory: pytest.TempPathFactory) -> dict[str, StyledFigure]:
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
        **long_figures(),
        **campaign_figures(tmp_path_factory.mktemp("campaign") / "c"),
    }


@pytest.fixture(scope="module")
def tabled(figures: dict[str, StyledFigure]) -> dict[str, StyledFigure]:
    """All but the map, whose table is that of the command."""
    return {name: figure for name, figure in figures.items() if name != "map"}


def test_nobody_can_complain_about_a_figure(figures: dict[str, StyledFigure]) -> None:
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


def test_picture_and_data_agree(tabled: dict[str, StyledFigure]) -> None:
    """Each point that is drawn stands in a row, under the labels of its own axes."""
    compared = 0
    for name, figure in nonempty(tabled.items()):
        heads, *rows = list(csv.reader(io.StringIO(figure.csv())))
        assert rows, name
        for ax, line in shown_lines(figure):
            drawn = np.array([line.get_xdata(), line.get_ydata()], float).T
            drawn = drawn[np.isfinite(drawn).all(axis=1)]
            labels = [axis_label(ax, which) for which in "xy"]
            if not all(labels) or not len(drawn):  # places on an axis of words are given by words
                continue
            under = [heads.index(label) for label in labels]
            pairs = [[row[k] for k in under] for row in rows if all(row[k] for k in under)]
            if not all(_number(word) for pair in pairs for word in pair):
                continue
            told = np.array(pairs).astype(float)
            for point in drawn[:: max(1, len(drawn) // 7)]:
                near = np.isclose(told, point, rtol=1e-8, atol=1e-12)
                assert near.all(axis=1).any(), (name, labels, point)
                compared += 1
    assert compared > 500


def _number(text: str) -> bool:
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


def test_every_series_of_a_legend_is_in_the_table(tabled: dict[str, StyledFigure]) -> None:
    """Keys of colours and marks, which stand for no series of their own, aside."""
    keys = {
        "within 5 %", "farther off", "off the scale", "open: at return", "end of contact",
        "largest payload, printed", "hover time, printed",
    }  # fmt: skip
    for name, figure in nonempty(tabled.items()):
        legends = [*figure.legends, *(ax.get_legend() for ax in figure.axes)]
        legends += [legend for part in figure.subfigs for legend in part.legends]
        shown = {text.get_text() for legend in legends if legend for text in legend.get_texts()}
        series = {str(row["series"]) for row in figure.rows()}
        assert {" ".join(word.split()) for word in shown} - keys <= series, name


def test_heads_have_units(tabled: dict[str, StyledFigure]) -> None:
    for name, figure in nonempty(tabled.items()):
        for row in nonempty([row for block in figure.table for row in block.items()]):
            numbers = np.issubdtype(np.asarray(row[1]).dtype, np.number)
            assert not numbers or "]" in row[0], (name, row[0])


def test_a_cell_a_band_a_bound_and_a_word_stand_in_the_table_as_what_they_are() -> None:
    figure = StyledFigure()
    one, two = figure.subplots(1, 2)
    robots = Chart(one, "Speed [m/s]", "robot", "a")
    robots.heat_map("Won [%]", [[0.5, np.nan]], [["1", ""]], ["ARQ"], ["2", "3.5"])
    heights = Chart(two, "Time [s]", "Height [m]", "b")
    heights.band("band", [0.0, 1.0], [1.0, 2.0], [2.0, 4.0])
    heights.errorbars("point", [1.0], [5.0], [4.5], [6.0])
    heights.vline("limit", 1.5)
    heights.curve("flown", [0.0, 1.0], [3.0, np.nan], columns={"Time [s]": ["first", "last"]})
    assert list(figure.rows()) == [
        {"panel": "a", "series": "", "Speed [m/s]": "2", "robot": "ARQ", "Won [%]": "50"},
        {"panel": "b", "series": "band", "Time [s]": "0", "Height [m], low": "1",
         "Height [m], high": "2"},
        {"panel": "b", "series": "band", "Time [s]": "1", "Height [m], low": "2",
         "Height [m], high": "4"},
        {"panel": "b", "series": "point", "Time [s]": "1", "Height [m]": "5",
         "Height [m], low": "4.5", "Height [m], high": "6"},
        {"panel": "b", "series": "limit", "Time [s]": "1.5"},
        {"panel": "b", "series": "flown", "Time [s]": "first", "Height [m]": "3"},
    ]  # fmt: skip
    assert figure.csv().splitlines()[0] == (
        'panel,series,Speed [m/s],robot,Won [%],Time [s],"Height [m], low","Height [m], high",Height [m]'
    )


def test_data_are_written_beside_the_picture_and_say_the_same_again(tmp_path: Path) -> None:
    figure = plots.energy_figure(fake_slider_flight())
    files = style.save(figure, tmp_path / "energy")
    assert files[-1].read_text(encoding="utf-8") == figure.csv()
    assert [file.suffix for file in style.save(figure, tmp_path / "b", numbers=False)] == [".png", ".pdf"]  # fmt: skip
    with mpl.rc_context({"text.usetex": True, "font.size": 30.0}):
        assert plots.energy_figure(fake_slider_flight()).csv() == figure.csv()


# -- looks


def test_curves_of_a_panel_differ_in_grey_by_more_than_colour() -> None:
    styles = [str(look["ls"]) for look in style.LOOKS]
    assert len(set(styles)) == len(styles)


def test_colours_are_told_apart_by_the_colour_blind() -> None:
    """Okabe and Ito's colours as deuteranopes see them (Machado and others, 2009, full severity)."""
    seen = np.array([
        [0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881],
    ])  # fmt: skip
    colours = [np.array(to_rgb(colour)) for colour in (robots.BLUE, robots.RED, robots.ORANGE, robots.GREEN)]  # fmt: skip
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
