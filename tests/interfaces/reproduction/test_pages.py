"""Pages that springback writes: complete, readable without colours, and no wider than a phone."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from matplotlib.figure import Figure

from builders.campaign_folders import filled
from builders.cases import nonempty
from builders.figures import plane_map
from builders.pages import Page
from builders.paper_results import fake_free_flight_results, fake_slider_results
from interfaces.browsing import browser as a_browser
from interfaces.browsing import needs_browser, resized
from springback.campaign.access import Campaign
from springback.campaign.analysis.statistics import summary
from springback.interfaces.figures import flight, style
from springback.interfaces.figures.envelope import map_figure
from springback.interfaces.reports.campaign import write_summary
from springback.interfaces.reports.envelope import map_page
from springback.interfaces.reports.page import page
from springback.interfaces.reproduction import overview, report
from springback.interfaces.reproduction.figures import drawings, free_flight, slider
from springback.interfaces.reproduction.report import Results
from springback.paper.printed import printed_success
from springback.studies.comparison import Mark, Row

#: Attributes that load something, and what they may hold.
LOADS = ("src", "href", "srcset", "data", "poster", "action")


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """Report, summary of a campaign, and map, as they are written."""
    place = tmp_path_factory.mktemp("pages")
    told = Results(slider=fake_slider_results(), flight=fake_free_flight_results())
    with pytest.MonkeyPatch.context() as patch:  # pictures as large as they are, but empty
        for module in (flight, drawings, free_flight, slider):
            for name in [name for name in dir(module) if name.endswith("_figure")]:
                wide = 8.0 if name == "readme_figure" else style.WIDTH
                patch.setattr(module, name, lambda *_, wide=wide: Figure(figsize=(wide, 3.0)))
        text = page(
            told.title, report.report_sections(told, {"springback": "x"}), report.REPRODUCTION
        )
    (place / "report.html").write_text(text, encoding="utf-8")
    filled(place / "campaign")
    write_summary(summary(Campaign(place / "campaign")), place)
    drawn = map_page(plane_map(), map_figure(plane_map(), printed_success))
    (place / "map.html").write_text(drawn, encoding="utf-8")
    return {name: place / f"{name}.html" for name in ("report", "summary", "map")}


def test_pages_load_nothing(pages: dict[str, Path]) -> None:
    for name, path in nonempty(pages.items()):
        text = path.read_text("utf-8")
        for tag, attributes in Page(text).tags:
            assert tag not in {"link", "script", "iframe", "object", "embed", "base"}, name
            for key in LOADS:
                value = attributes.get(key)
                assert value is None or value.startswith(("data:image/png;base64,", "#")), name
        for word in ("http://", "https://", "url(", "@import", "@font-face"):
            assert word not in text, (name, word)


def test_headings_go_down_step_by_step_and_pictures_have_words(pages: dict[str, Path]) -> None:
    for name, path in nonempty(pages.items()):
        page_read = Page(path.read_text("utf-8"))
        assert page_read.levels.count(1) == 1, name
        assert page_read.levels[0] == 1
        for one, other in zip(page_read.levels, page_read.levels[1:], strict=False):
            assert other <= one + 1, name
        pictures = [attributes for tag, attributes in page_read.tags if tag == "img"]
        assert pictures
        assert all((one["alt"] or "").strip() and one["width"] and one["height"] for one in pictures)  # fmt: skip
        named = [attributes["id"] for _, attributes in page_read.tags if attributes.get("id")]
        assert len(named) == len(set(named)), name
        assert {a["href"] for tag, a in page_read.tags if tag == "a"} <= {f"#{i}" for i in named}


def test_the_answer_and_a_picture_stand_before_the_contents(pages: dict[str, Path]) -> None:
    for name, path in nonempty(pages.items()):
        tags = [tag for tag, _ in Page(path.read_text("utf-8")).tags]
        assert tags.index("img") < tags.index("nav") < tags.index("main"), name


def test_tables_and_wide_pictures_scroll_within_themselves(pages: dict[str, Path]) -> None:
    for path in nonempty(pages.values()):
        text = path.read_text("utf-8")
        assert len(re.findall(r"<table>", text)) == len(re.findall(r'<div class="box"[^>]*><table>', text))  # fmt: skip
        assert len(re.findall(r"<img ", text)) == len(re.findall(r'<div class="box"[^>]*><img ', text))  # fmt: skip
        assert re.search(r"\.box \{[^}]*overflow-x: auto", text)
        assert "prefers-color-scheme: dark" in text
        assert "@media print" in text


# -- what the summary counts


def row(ours: float, printed: float, mark: Mark, **more: Any) -> Row:
    given: dict[str, Any] = {
        "experiment": "Table IV", "robot": "arq", "surface": "", "reading": "steps",
        "quantity": f"q{ours}", "unit": "m", "ours": ours, "printed": printed, "printed_test": None,
        "mark": mark, "dissipation": 0.0, "dissipation_from": "",
    }  # fmt: skip
    return Row(**given | more)


def test_the_verdict_counts_what_nothing_was_fitted_to() -> None:
    rows = [
        row(1.01, 1.0, Mark.PREDICTED), row(1.08, 1.0, Mark.CONTRADICTED),
        row(0.80, 1.0, Mark.CONTRADICTED), row(3.00, 1.0, Mark.CONTRADICTED),
        row(1.00, 1.0, Mark.FITTED), row(1.00, 1.0, Mark.GIVEN),
        row(1.00, 1.0, Mark.PREDICTED, experiment="Table III", reading="A",
            dissipation_from="ARQ's own restitution"),
        row(1.00, 0.0, Mark.CONTRADICTED, experiment="Resilience", reading=""),
    ]  # fmt: skip
    (section,) = overview.overview(rows)
    assert section.summary
    assert section.answer == (
        "Of 5 printed numbers to which nothing was fitted, each counted once, 1 agree within 5 % "
        "with the default choices and 1 in at least one reading (2 within 10 %)."
    )
    words = " ".join(block for block in section.blocks if isinstance(block, str))
    assert "1 further numbers were used as inputs and 1 fitted" in words
    (worse,) = overview.overview([*rows, row(9.0, 1.0, Mark.CONTRADICTED)])
    assert worse.answer.startswith("Of 6 printed numbers")
    assert "Nothing was compared" in str(overview.overview([])[0].blocks[0])


def test_every_number_that_nothing_was_fitted_to_is_in_one_part() -> None:
    rows = [*fake_slider_results().rows, *fake_free_flight_results().rows()]
    parts = overview.groups(rows)
    found = [id(one) for group in parts.values() for one in group]
    assert sorted(found) == sorted(id(one) for one in overview.unfitted_rows(rows))


# -- in a browser


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    with a_browser(tmp_path_factory.mktemp("profile")) as driver:
        yield driver


@needs_browser
@pytest.mark.parametrize("width", [390, 1440])
def test_no_page_is_wider_than_the_screen(browser: Any, pages: dict[str, Path], width: int) -> None:
    resized(browser, width, 844)
    for name, path in nonempty(pages.items()):
        browser.get(path.as_uri())
        assert browser.execute_script("return document.documentElement.scrollWidth") <= width, name
        clipped = browser.execute_script(
            "return [...document.querySelectorAll('p, h1, h2, h3, li, figcaption, summary')]"
            ".filter(e => e.getBoundingClientRect().right > innerWidth + 1).map(e => e.textContent)"
        )
        assert clipped == [], name


@needs_browser
def test_pages_can_be_read_in_the_dark(browser: Any, pages: dict[str, Path]) -> None:
    dark = {"features": [{"name": "prefers-color-scheme", "value": "dark"}]}
    try:
        browser.execute_cdp_cmd("Emulation.setEmulatedMedia", dark)
        for path in nonempty(pages.values()):
            browser.get(path.as_uri())
            ground = browser.execute_script(
                "return getComputedStyle(document.body).backgroundColor"
            )
            for word in ("p", "th", "td", "a", "figcaption"):
                ink = browser.execute_script(
                    f"return getComputedStyle(document.querySelector('{word}')).color"
                )
                assert contrast(ink, ground) > 4.5, word
    finally:
        browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})


def contrast(one: str, other: str) -> float:
    """Ratio of luminances, as the Web Content Accessibility Guidelines define it."""
    levels = []
    for colour in (one, other):
        parts = [int(part) / 255.0 for part in re.findall(r"\d+", colour)[:3]]
        linear = [p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts]
        levels.append(sum(w * p for w, p in zip((0.2126, 0.7152, 0.0722), linear, strict=True)))
    return (max(levels) + 0.05) / (min(levels) + 0.05)
