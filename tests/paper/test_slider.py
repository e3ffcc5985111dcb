"""The paper's slider tests: printed numbers by name, and the known contradictions as contradictions."""

import runpy
from pathlib import Path

import pytest

from springback.paper.slider import (
    READINGS,
    SliderResults,
    fitted_dissipation,
    named_reading,
    slider_experiments,
)
from springback.studies.comparison import Mark


@pytest.fixture(scope="module")
def results() -> SliderResults:
    heavy_arms = named_reading("E: vehicle.arms.mass=0.1")
    return slider_experiments([heavy_arms])


def number(
    results: SliderResults, robot: str, surface: str, reading: str, quantity: str, fit: str = "Quad"
) -> float:
    found = [
        row.ours for row in results.rows
        if (row.robot, row.surface, row.reading, row.quantity) == (robot, surface, reading, quantity)
        and row.dissipation_from.startswith(fit)
    ]  # fmt: skip
    assert len(found) == 1
    assert found[0] is not None
    return found[0]


def test_quad_against_the_wall_is_reproduced_from_its_restitution_alone(
    results: SliderResults,
) -> None:
    """Table III and text: 224 m/s², 14 mm, 31 ms, with c_a fitted to 0.547."""
    assert fitted_dissipation("wall") == pytest.approx(0.432, abs=0.001)
    quad = ("quad", "wall", "Quad")
    assert number(results, *quad, "restitution_at_separation") == pytest.approx(0.547, abs=1e-6)
    assert number(results, *quad, "impact_peak_acceleration") == pytest.approx(224.0, abs=1.0)
    assert number(results, *quad, "travel") == pytest.approx(0.0140, abs=0.0001)
    assert number(results, *quad, "contact_time") == pytest.approx(0.0306, abs=0.0003)


def test_quad_against_the_mat_fits_in_all_but_the_acceleration(results: SliderResults) -> None:
    """181 m/s² where the paper prints 168: at 1.74 m/s it would be 169, so the speed may have differed."""
    quad = ("quad", "mat", "Quad")
    assert number(results, *quad, "travel") == pytest.approx(0.018, rel=0.03)
    assert number(results, *quad, "contact_time") == pytest.approx(0.037, rel=0.02)
    assert number(results, *quad, "impact_peak_acceleration") == pytest.approx(181.0, abs=1.0)


@pytest.mark.parametrize(
    ("reading", "restitution", "acceleration", "travel", "to_return"),
    [("A", 0.464, 83.2, 0.0284, 0.0703), ("B", 0.488, 142.5, 0.0185, 0.0440), ("C", 0.434, 166.5, 0.0151, 0.0385)],
)  # fmt: skip
def test_arq_against_the_wall_by_reading(
    results: SliderResults,
    reading: str,
    restitution: float,
    acceleration: float,
    travel: float,
    to_return: float,
) -> None:
    """What each reading predicts with Quad's c_a; the values agree with an independent 1-D and 45° model."""
    arq = ("arq", "wall", reading)
    assert number(results, *arq, "restitution_at_separation") == pytest.approx(
        restitution, abs=0.001
    )
    assert number(results, *arq, "impact_peak_acceleration") == pytest.approx(acceleration, abs=0.5)
    assert number(results, *arq, "travel") == pytest.approx(travel, abs=0.0002)
    assert number(results, *arq, "time_to_return") == pytest.approx(to_return, abs=0.0003)


def test_no_reading_gives_all_four_numbers_of_arq(results: SliderResults) -> None:
    """The contradiction remains; tuning it away would be noticed here."""
    four = ("restitution_at_separation", "impact_peak_acceleration", "travel", "time_to_return")
    for reading in ("A", "B", "C"):
        for source in ("Quad", "ARQ"):
            marks = [
                row.mark for row in results.rows
                if row.robot == "arq" and row.surface == "wall" and row.reading == reading
                and row.quantity in four and row.dissipation_from.startswith(source)
            ]  # fmt: skip
            assert Mark.CONTRADICTED in marks


def test_the_sweep_of_reading_c_gives_the_printed_gap(results: SliderResults) -> None:
    """493 m/s² at 6 m/s without the sliding bar: C near c_a = 0.40, B near 0.19."""
    fitted = {
        row.reading: row.dissipation
        for row in results.rows
        if row.experiment == "Sweep" and row.mark is Mark.FITTED
    }
    assert fitted["C"] == pytest.approx(0.40, abs=0.01)
    assert fitted["B"] == pytest.approx(0.19, abs=0.01)
    for reading in ("A", "B", "C"):
        gaps = [point.gap for point in results.sweep if point.reading == reading]
        assert gaps == sorted(gaps)


def test_a_users_reading_stands_beside_the_others(results: SliderResults) -> None:
    marks = {row.mark for row in results.rows if row.reading == "E"}
    assert Mark.PREDICTED in marks or Mark.CONTRADICTED in marks
    case = next(case for case in results.cases if case.reading.name == "E")
    assert case.flight.scenario.vehicle.mass == pytest.approx(1.882 + 0.4)


def test_arq_is_gentler_than_quad_at_every_speed_unless_its_arms_reach_their_end(
    results: SliderResults,
) -> None:
    free = [point for point in results.sweep if point.reading not in ("D, stops", "D, latch")]
    assert all(point.arq < point.quad for point in free)
    held = [point.speed for point in results.sweep if point.reading == "D, latch" and point.gap < 0]
    assert held == [2.0]  # where the latch just opens, without the bar
    stopped = [point.gap for point in results.sweep if point.reading == "D, stops"]
    assert stopped[-1] < -900.0  # stops that mend the slider's peaks contradict the sweep


@pytest.mark.parametrize(
    ("reading", "near", "nearly", "gap"),
    [("A", 3, 4, 1016), ("B", 1, 4, 660), ("C", 2, 3, 512), ("D", 6, 6, 919),
     ("D, letter", 6, 6, 614), ("D, stops", 6, 8, -1052), ("D, latch", 8, 8, 584)],
)  # fmt: skip
def test_what_each_reading_gives_of_arqs_eight_numbers(
    results: SliderResults, reading: str, near: int, nearly: int, gap: int
) -> None:
    """As computed independently with a small model of two masses and a spring."""
    rows = results.unique_rows(reading)
    assert len(rows) == 8
    assert len({(row.surface, row.quantity) for row in rows}) == 8
    off = [abs(row.deviation or 0.0) for row in rows]
    assert sum(share <= 0.05 for share in off) == near
    assert sum(share <= 0.10 for share in off) == nearly
    assert results.sweep  # the whole robot weighs what Table I prints, however heavy its arms
    (last,) = [p.gap for p in results.sweep if p.reading == reading and p.speed == 6.0]
    assert last == pytest.approx(gap, abs=2.0)


def test_reading_d_is_one_spring_along_the_motion() -> None:
    """Two arms at 45 deg with k_l/4 each: along X, k_l, for 2 (k_l/4) / cos² 45° = k_l."""
    (pair,) = [reading for reading in READINGS if reading.name == "D"]
    assert pair.arms_mass == pytest.approx(0.4)
    words = dict(word.split("=") for word in pair.overrides)
    stiffness = float(words["vehicle.arms.stiffness"])
    assert 2.0 * stiffness / 0.5 == pytest.approx(5e3)
    assert 2.0 * float(words["vehicle.arms.damping"]) / 0.5 == pytest.approx(90.0)


def test_only_the_stops_were_fitted_to_peaks(results: SliderResults) -> None:
    for reading in ("A", "B", "C", "D", "D, letter"):
        assert Mark.FITTED not in {row.mark for row in results.unique_rows(reading)}
    fitted = [row for row in results.unique_rows("D, stops") if row.mark is Mark.FITTED]
    assert {row.quantity for row in fitted} == {"impact_peak_acceleration"}


def test_the_latch_is_fitted_on_the_wall_and_predicts_the_mat(results: SliderResults) -> None:
    """Three numbers to four; the other four follow, within 5 %."""
    rows = results.unique_rows("D, latch")
    marks = {"wall": Mark.FITTED, "mat": Mark.PREDICTED}
    assert [row.mark for row in rows] == [marks[row.surface] for row in rows]
    assert max(abs(row.deviation or 0.0) for row in rows if row.surface == "mat") < 0.05
    gap = [row for row in results.rows if (row.experiment, row.reading) == ("Sweep", "D, latch")]
    assert gap[0].mark is Mark.CONTRADICTED


def test_c_a_lies_in_the_printed_range(results: SliderResults) -> None:
    rows = [row for row in results.rows if row.experiment == "Section IV"]
    assert len(rows) == 2
    assert all(row.mark is Mark.PREDICTED and row.deviation == 0.0 for row in rows)


def test_tests_of_the_paper_scatter_about_its_own_simulation(results: SliderResults) -> None:
    (row,) = [
        row for row in results.rows
        if (row.robot, row.surface, row.quantity) == ("quad", "wall", "restitution_at_separation")
    ]  # fmt: skip
    assert row.scatter == pytest.approx(0.526 / 0.547 - 1.0)
    assert row.test_deviation == pytest.approx(0.547 / 0.526 - 1.0, abs=1e-5)


def test_the_table_of_the_reproduction_page_is_the_computed_one(results: SliderResults) -> None:
    """Written by tools/readme.py, never by hand."""
    root = Path(__file__).parents[2]
    tool = runpy.run_path(str(root / "tools/readme.py"))
    text = (root / "docs/paper/reproduction.md").read_text(encoding="utf-8")
    assert tool["with_table"](text, "reproduction", tool["table"](results)) == text
    front = (root / "README.md").read_text(encoding="utf-8")
    headline = tool["headline"](tool["table"](results))
    assert tool["with_table"](front, "headline", headline) == front
