"""The report: one page that needs nothing else, and the same numbers in all its forms."""

import csv
import json
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from matplotlib.figure import Figure

from builders.cases import nonempty
from builders.pages import ABOUT, Page
from builders.paper_results import fake_slider_results, fake_trials
from springback.interfaces.figures import flight
from springback.interfaces.reports import page as report_page
from springback.interfaces.reproduction import report, resilience
from springback.interfaces.reproduction import slider as report_slider
from springback.interfaces.reproduction.figures import drawings, slider
from springback.interfaces.reproduction.overview import groups
from springback.interfaces.reproduction.report import Results
from springback.paper.resilience import ResilienceResults
from springback.paper.slider import READINGS, SliderResults
from springback.simulation.measuring.measures import Outcome
from springback.studies.comparison import Mark

HOSTILE = "<script>alert('x')</script> & \"x\""


@pytest.fixture(scope="module")
def results() -> SliderResults:
    return fake_slider_results((*READINGS, replace(READINGS[1], name=HOSTILE)))


@pytest.fixture(scope="module")
def folder(results: SliderResults, tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("report") / "new" / "folder"
    written = report.write_report(Results(results), made, about=ABOUT)
    assert sorted(written) == sorted(path for path in made.rglob("*") if path.is_file())
    return made


@pytest.fixture(scope="module")
def page(folder: Path) -> Page:
    return Page((folder / "report.html").read_text(encoding="utf-8"))


def test_the_files_are_there(folder: Path) -> None:
    names = {str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file()}
    figures = (
        "overview", "answer", "slider_quad", "slider_arq", "readings", "sweep", "energy",
        "robots_drawn", "contact_drawn",
    )  # fmt: skip
    assert names == {"report.html", "comparison.json", "comparison.csv", "sweep.csv"} | {
        f"figures/{name}.{kind}" for name in figures for kind in ("png", "pdf", "csv")
    }


def test_the_page_needs_nothing_else(page: Page, folder: Path) -> None:
    assert not page._open
    assert {"link", "script", "iframe", "object"}.isdisjoint(tag for tag, _ in page.tags)
    for tag, attributes in page.tags:
        for name in ("src", "href", "srcset", "data"):
            value = attributes.get(name)
            assert value is None or value.startswith(("data:image/png;base64,", "#")), (tag, value)
        assert not [name for name in attributes if name.startswith("on")]
        if tag == "img":
            assert attributes["alt"]
    text = (folder / "report.html").read_text(encoding="utf-8")
    assert "http://" not in text
    assert "https://" not in text
    assert "url(" not in text


def test_links_lead_to_sections(page: Page) -> None:
    anchors = {
        tag: {f"#{a['id']}" for t, a in page.tags if t == tag} for tag in ("section", "figure")
    }
    links = {attributes["href"] for tag, attributes in page.tags if tag == "a"}
    assert anchors["section"] <= links <= anchors["section"] | anchors["figure"]


def test_hostile_names_are_text(page: Page, folder: Path) -> None:
    text = (folder / "report.html").read_text(encoding="utf-8")
    assert "<script" not in text
    assert "&lt;script&gt;alert(" in text
    assert HOSTILE in page.words


def test_every_row_is_on_the_page_with_the_number_of_the_json(page: Page, folder: Path) -> None:
    rows = json.loads((folder / "comparison.json").read_text(encoding="utf-8"))["rows"]
    (shown,) = [table[1:] for caption, table in page.tables.items() if caption.startswith("All ")]
    assert len(shown) == len(rows)
    for cells, row in zip(shown, rows, strict=True):
        assert [cells[6]["value"], cells[7]["value"]] == [row["ours"], row["printed"]]
        assert cells[3]["text"] == row["reading"]
        assert cells[4]["text"] == row["quantity"]
        assert cells[9]["text"] == row["mark"]
        hit = bool(row["dissipation_from"])
        assert cells[10]["value"] == (row["dissipation"] if hit else None)


def test_numbers_of_the_tables_are_those_of_the_json(page: Page, folder: Path) -> None:
    data = json.loads((folder / "comparison.json").read_text(encoding="utf-8"))
    names = [reading["name"] for reading in data["readings"]]
    for surface in ("wall", "mat"):
        table = page.tables[f"ARQ on the {surface}, with Quad's ca"]
        assert [cell["text"] for cell in table[0][2:-1]] == [f"ARQ, {name}" for name in names]
        for quantity, cells in zip(report_slider.QUANTITIES, table[2:], strict=True):
            for name, cell in zip(names, cells[2:-1], strict=True):
                (row,) = [
                    row
                    for row in data["rows"]
                    if row["robot"] == "arq" and row["dissipation_from"].startswith("Quad")
                    and (row["surface"], row["reading"], row["quantity"]) == (surface, name, quantity)
                ]  # fmt: skip
                assert cell["value"] == row["ours"]
                assert row["mark"] in cell["text"]
                assert cells[1]["value"] == row["printed"]


def test_csv_holds_the_same_numbers(folder: Path) -> None:
    data = json.loads((folder / "comparison.json").read_text(encoding="utf-8"))
    with (folder / "comparison.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["ours"]) for row in rows] == [row["ours"] for row in data["rows"]]
    assert [row["reading"] for row in rows] == [row["reading"] for row in data["rows"]]
    with (folder / "sweep.csv").open(encoding="utf-8", newline="") as file:
        points = list(csv.DictReader(file))
    assert [float(point["gap [m/s^2]"]) for point in points] == [p["gap"] for p in data["sweep"]]


def test_the_same_results_give_the_same_bytes(
    results: SliderResults, folder: Path, tmp_path: Path
) -> None:
    for path in nonempty(report.write_report(Results(results), tmp_path, about=ABOUT)):
        assert path.read_bytes() == (folder / path.relative_to(tmp_path)).read_bytes(), path.name


def test_marks_are_words_as_well_as_colours(results: SliderResults, folder: Path) -> None:
    text = (folder / "report.html").read_text(encoding="utf-8")
    marks = re.findall(r'<span class="mark (\w+)">(\w+)</span>', text)
    assert all(colour == word for colour, word in marks)
    in_table_iii = sum(row.experiment == "Table III" for row in results.rows)
    parts = len(groups(results.rows))  # each tells what is farthest off
    assert len(marks) == len(Mark) + parts + in_table_iii + len(results.rows)


@pytest.fixture
def undrawn(monkeypatch: pytest.MonkeyPatch) -> None:
    """Empty figures, for tests of words."""
    for name in ("slider", "sweep", "readings", "readme"):
        monkeypatch.setattr(slider, f"{name}_figure", lambda *_: Figure(figsize=(1, 1)))
    monkeypatch.setattr(flight, "energy_figure", lambda *_: Figure(figsize=(1, 1)))
    for name in ("robots", "contact"):
        monkeypatch.setattr(drawings, f"{name}_figure", lambda *_: Figure(figsize=(1, 1)))


@pytest.mark.usefixtures("undrawn")
def test_the_verdict_follows_the_results(results: SliderResults) -> None:
    def verdict(of: SliderResults) -> str:
        return report_slider.slider_sections(of)[0].answer

    # Made up: Quad agrees throughout; of ARQ's readings only B, at the printed values, does.
    assert verdict(results) == (
        "For Quad, 6 of its 6 other printed numbers agree within 5 %. For ARQ, all 4 printed numbers of "
        "a test agree for reading B on the wall and reading B on the mat."
    )
    worse = replace(results, rows=[
        replace(row, mark=Mark.CONTRADICTED) if row.quantity == "travel" else row for row in results.rows
    ])  # fmt: skip
    assert verdict(worse) == (
        "For Quad, 4 of its 6 other printed numbers agree within 5 %. For ARQ, none of the 8 readings of "
        "its parameters gives the 4 printed numbers of a test together."
    )


def test_the_verdict_on_collisions_follows_the_trials() -> None:
    def said(of: ResilienceResults) -> str:
        return " ".join(
            block
            for section in resilience.resilience_sections(of)
            for block in section.blocks
            if isinstance(block, str)
        )

    against = said(fake_trials())
    assert "ARQ recovers in 10 of 10 trials; printed are 100 %. Quad at 3.5 m/s" in against
    assert "contradicts the paper" in against
    assert "study why" in against
    assert "None of the 20 trials failed" in against
    as_printed = said(fake_trials(Outcome.HIT_GROUND))
    assert "Quad at 3.5 m/s recovers in 0 of 10 trials, as printed." in as_printed
    assert "contradicts the paper" not in as_printed
    assert "10 of 20 failed trials ended: touched the ground (10)" in as_printed


def written_words(text: dict[str, Any]) -> list[str]:
    """Phrases of a part, and the paragraphs, captions and heads of its sections."""
    words = [entry for entry in text.values() if isinstance(entry, str)]
    for section in text["sections"]:
        for block in section["blocks"]:
            given = {"text": block} if isinstance(block, str) else block
            words += [given.get("text", ""), given.get("caption", ""), *given.get("head", ())]
    return words


def test_words_carry_no_typed_numbers() -> None:
    for name in ("report", "slider", "flight", "resilience", "overview", "campaign"):
        words = written_words(report_page.Wording.of(name).text)
        assert any("{" in word for word in words), name
        for word in words:
            law = word.replace("1 + 1.5 c_a", "")  # the law itself
            assert not re.search(r"\d", re.sub(r"{[^}]*}", "", law)), (name, word)


def test_a_part_is_laid_out_as_its_file_says_and_what_is_missing_is_left_out() -> None:
    words = report_page.Wording({"part": "A part", "sections": [
        {"anchor": "unflown", "title": "Unflown", "blocks": ["never"]},
        {"anchor": "flown", "title": "Flown", "answers": True, "blocks": [
            "{count} flights, {share:.1f} % {name.text}, {none}",
            {"when": "count", "text": "{share}"}, {"when": "absent", "text": "no"},
            {"table": "rows", "caption": "of {count}", "head": ["", "{share} %"]},
            {"table": "headed", "caption": "c"}, {"table": "empty", "caption": "c"},
            {"blocks": "made"},
        ]},
    ]})  # fmt: skip
    (section,) = words.sections({"unflown": {}, "flown": {
        "count": 2_000_000, "share": -12.3456789, "name": report_page.TableCell("won"),
        "none": None, "rows": [("a", 1.5), ("b", None)], "headed": [("h",), ("x",)], "empty": [],
        "made": ("a paragraph",),
    }})  # fmt: skip
    assert (section.part, section.title, section.answers) == ("A part", "Flown", True)
    assert section.blocks == (
        "2000000 flights, −12.3 % won, –", "-12.3457",
        report_page.Table("of 2000000", ("", "-12.3457 %"), (
            (report_page.TableCell("a"), report_page.TableCell("1.5", 1.5)),
            (report_page.TableCell("b"), report_page.TableCell("–")),
        )),
        report_page.Table("c", ("h",), ((report_page.TableCell("x"),),)), "a paragraph",
    )  # fmt: skip


def test_numbers_are_rounded_and_signed_like_print() -> None:
    assert report_page.decimal(-0.04321, 3) == "−0.043"
    assert report_page.decimal(None, 1) == "–"
    assert report_page.percent(-1e-9) == "+0.0 %"
    assert report_page.percent(-0.0506) == "−5.1 %"
    assert report_page.plain(2e5) == "200000"
    assert report_page.plain(0.014 * 1e3) == "14"
    assert report_page.join([]) == "none"
    assert report_page.join("abc") == "a, b and c"


def test_parts_that_were_not_flown_are_left_out(tmp_path: Path) -> None:
    report.write_report(Results(SliderResults()), tmp_path, about={})
    page = Page((tmp_path / "report.html").read_text(encoding="utf-8"))
    assert not [tag for tag, _ in page.tags if tag == "img"]
    assert json.loads((tmp_path / "comparison.json").read_text(encoding="utf-8"))["rows"] == []


@pytest.mark.usefixtures("undrawn")
def test_a_reading_that_no_c_a_can_fit_is_said_so(results: SliderResults) -> None:
    kept = [
        row for row in results.rows
        if not (row.reading == "A" and row.dissipation_from.startswith("ARQ"))
    ]  # fmt: skip
    sections = report_slider.slider_sections(replace(results, rows=kept))
    text = report_page.page("x", sections, "lead")
    assert "no <var>c<sub>a</sub></var> gives this COR" in text
    assert "none does" in text
