"""The report of a fit: the answer first, everything promised on one page that needs nothing else."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from builders.cases import nonempty
from builders.rigs import rig_fit
from interfaces.browsing import browser, complaints, needs_browser, requests, resized
from interfaces.legible import complaints as illegible
from springback.identification.design.experiments import ChosenExperiment, ExperimentPlan
from springback.identification.estimates import correlations
from springback.identification.fits import FitResult
from springback.identification.report.profiles import profile_curves
from springback.identification.report.replays import replays
from springback.identification.results_files import REPORT
from springback.interfaces.figures.fits.likelihood import (
    correlations_figure,
    profiles_figure,
    short_names,
    values_figure,
)
from springback.interfaces.figures.fits.readings import impact_figure
from springback.interfaces.reports.fit_page import fit_page, write_report
from springback.interfaces.reports.fit_tables import interval_alone, value_text

SPEEDS = ("1.85 m/s", "2.5 m/s", "1.5 m/s")


@pytest.fixture(scope="module")
def alone() -> FitResult:
    return rig_fit()


@pytest.fixture(scope="module")
def several() -> FitResult:
    return rig_fit(*SPEEDS)


@pytest.fixture(scope="module")
def page(alone: FitResult) -> str:
    return fit_page(alone)


def test_the_answer_comes_first_and_every_part_after_it(alone: FitResult, page: str) -> None:
    anchors = re.findall(r'<section id="([\w-]+)"', page)
    assert anchors == [
        "overview", "warnings", "data", "misfit", "profiles", "correlations", "assumed", "next",
        "method",
    ]  # fmt: skip
    text = re.sub(r"<[^>]+>", "", page)
    answer = text.index("4 of 4 fields were learned")
    assert answer < text.index("Values with 95 % intervals") < text.index("Contents")
    for one in alone.estimates:
        assert text.count(one.unknown.name) >= 1
    for sentence in nonempty(alone.sentences):
        assert sentence[1:40] in text  # but for a capital
    assert "No channel differs from its prediction" in text
    assert "vehicle.arms.directions.0" in text[text.index("Assumed, not measured", answer) :]
    assert f"{alone.fits[0].agreeing} of 2" in text


def test_it_is_one_light_page_that_asks_for_nothing(page: str) -> None:
    assert len(page) < 700_000
    assert set(re.findall(r'src="([^",]{0,20})', page)) == {"data:image/png;base6"}
    assert "http" not in re.sub(r"base64,[^\"]+", "", page)
    pictures = re.findall(r'<img [^>]*width="(\d+)"[^>]*alt="([^"]+)"', page)
    assert len(pictures) == 3
    assert all(int(width) <= 700 for width, _ in pictures)  # whole on a phone


def test_several_impacts_are_compared_and_left_out_in_turn(several: FitResult) -> None:
    free = tuple(one.unknown for one in several.estimates if one.unknown.role == "free")
    best = ChosenExperiment("3 m/s, one arm", (0.1,) * len(free), 2.0)
    further = ExperimentPlan(free, (1.0,) * len(free), (), (best,), ())
    text = re.sub(r"<[^>]+>", "", fit_page(several, further))
    assert "rig: what 3 impacts told" in text
    assert "arms.stiffness, without it" in text
    assert text.count("Impact 2:") >= 1
    assert "triangles are at the end of the sensor" in text  # at 2.5 m/s
    assert text.index("What to measure next", 5000) < text.index("next best: 3 m/s, one arm")
    assert text.count("± 10 %") >= len(free)


def test_what_does_not_fit_is_said_before_the_values(alone: FitResult) -> None:
    wrong = alone.misfits[0]._replace(probability=1e-7, ratio=9.0)
    text = re.sub(r"<[^>]+>", "", fit_page(alone._replace(misfits=(wrong, *alone.misfits[1:]))))
    said = text.index("Read the misfits first: accelerometer")
    assert said < text.index("Values with 95 % intervals")
    assert "1 · 10⁻⁷" in text
    assert "misfit" in text[text.index("Does it fit?", said) :]


def test_figures_can_be_read_in_print(several: FitResult) -> None:
    fits = several.fits
    free = [one for one in several.estimates if one.unknown.role == "free"]
    values = [[interval_alone(fit, one.unknown.name) for fit in fits] for one in free]
    impact = fits[1].problem.impact
    figures = [
        impact_figure(replays(fits[1]), impact.release - impact.touch),
        profiles_figure([profile_curves(fits[0])]),
        profiles_figure([profile_curves(fit) for fit in fits]),
        values_figure(free, values),
    ]
    assert [illegible(figure) for figure in figures] == [[]] * 4
    series = {row["series"] for row in figures[0].rows()}
    assert {"x, measured", "x, predicted", "x, clipped", "1, measured"} <= series
    names, matrix = correlations(fits[0])
    matrix[2, 1] = matrix[1, 2] = -0.001  # is no minus zero
    drawn = correlations_figure(names, matrix)
    assert "−.00" not in [text.get_text() for text in drawn.axes[0].texts]
    rows = list(drawn.rows())
    assert len(rows) == len(names) * (len(names) - 1) // 2
    known = {(row["Row"], row["Column"]): float(row["correlation [-]"]) for row in rows}
    assert known[names[3], names[2]] == pytest.approx(matrix[2, 3], abs=1e-9)


def test_numbers_and_names_are_short() -> None:
    assert value_text(0.011, "m") == "11.0 mm"
    assert value_text(194532.0, "") == "195000"
    assert value_text(np.pi / 4.0, "rad") == "45.0 deg"
    names = ["world.obstacles.0.surface.stiffness", "world.obstacles.1.surface.stiffness"]
    assert short_names(names) == [name.removeprefix("world.") for name in names]
    assert short_names([names[0], "start position"]) == ["surface.stiffness", "start position"]


@needs_browser
def test_it_fits_on_a_phone_and_fetches_nothing(several: FitResult, tmp_path: Path) -> None:
    path = write_report(several, tmp_path)
    assert path.name == REPORT
    with browser(tmp_path / "profile") as driver:
        requests(driver)
        for width in (1440, 390):
            resized(driver, width, 844)
            driver.get(path.as_uri())
            assert driver.execute_script("return document.documentElement.scrollWidth") <= width
            for image in driver.find_elements("css selector", "img"):
                assert 0 < image.size["width"] <= width
        schemes = {url.partition(":")[0] for url in requests(driver)}
        assert schemes <= {"file", "data", "chrome", "chrome-untrusted"}
        assert complaints(driver) == []
