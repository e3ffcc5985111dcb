"""The summary page of a campaign in a browser: nothing sticks out of it, on a desktop or a phone."""

from __future__ import annotations

from pathlib import Path

import springback
from builders.campaign_folders import filled
from interfaces.browsing import browser, complaints, needs_browser, resized
from springback.campaign.access import Campaign
from springback.campaign.analysis.levels import field_summary
from springback.campaign.analysis.statistics import summary
from springback.campaign.analysis.worst_case import worst_cases
from springback.interfaces.reports.campaign import write_summary
from springback.interfaces.reports.measures import measure_report

pytestmark = needs_browser
VARY = [
    {"field": "vehicle.arms.stiffness", "from": 500.0, "to": 5000.0},
    {"field": "vehicle.arms.damping", "from": 5.0, "to": 50.0},
    {"field": "start.velocity.0", "from": 1.0, "to": 4.0, "name": "speed"},
]


def test_the_flights_to_replay_fit_on_the_page(tmp_path: Path) -> None:
    """Whole on a desktop, also with a long path in their commands; on a phone in a box that scrolls."""
    filled(tmp_path / "rows", parts=2, size=40, samples=80, vary=VARY)
    found = summary(Campaign(tmp_path / "rows"))
    write_summary(found, tmp_path, pairs=[("stiffness", "damping")])
    assert "95 % confidence interval (Wilson): ARQ " in (tmp_path / "summary.html").read_text(
        encoding="utf-8"
    )
    with browser(tmp_path / "profile") as driver:
        for width in (1440, 390):
            resized(driver, width, 900)
            driver.get((tmp_path / "summary.html").as_uri())
            assert driver.execute_script("return document.documentElement.scrollWidth") <= width
            tables = driver.find_elements("css selector", "#failures table")
            assert len(tables) == 2  # failures, and the hardest of all
            for table in tables:
                box = table.find_element("xpath", "..")
                assert table.size["width"] <= box.size["width"] or width < 400
                command = table.find_element("css selector", "code")
                assert command.text.split()[:2] == ["springback", "view"]
        assert complaints(driver) == []


def test_a_campaign_of_own_vehicles_fits_on_both_screens(tmp_path: Path) -> None:
    """Long names, limits with their answers, tables by field, a measure: nothing sticks out."""
    arq = springback.ARQ.vehicle.model_dump(mode="json")
    names = ["hexarotor, printed arms of 2026", "hexarotor, carbon arms"]
    own = {name: {**arq, "name": name} for name in names}
    filled(
        tmp_path / "rows", parts=2, size=400, samples=400, robots=names, vehicles=own,
        vary=[*VARY, {"field": "surface", "values": ["wall", "mat"]}],
    )  # fmt: skip
    known = Campaign(tmp_path / "rows")
    limits = [
        "impact_arm_stroke < 990 mm",
        "impact_peak_acceleration < 0.98 m/s^2",
        "not hit_ground",
    ]
    write_summary(
        summary(known), tmp_path, levels=[field_summary(known, "surface")],
        measures=[measure_report(known, "impact_arm_stroke")],
        worst_cases=worst_cases(known, limits, ["stiffness", "stiffness,surface"], share=0.9),
    )  # fmt: skip
    with browser(tmp_path / "profile") as driver:
        for width in (1440, 390):
            resized(driver, width, 844)
            driver.get((tmp_path / "summary.html").as_uri())
            assert driver.execute_script("return document.documentElement.scrollWidth") <= width
            for anchor, words in (("limits", "keeps"), ("levels", "Outcomes by surface")):
                section = driver.find_element("id", anchor)
                assert words in section.text or "closest is" in section.text
            pictures = driver.find_elements("css selector", "#limits img")
            assert len(pictures) == 2
            boxes = [image.find_element("xpath", "..").size["width"] for image in pictures]
            assert all(0 < box <= width for box in boxes)  # which scroll on a phone
            fold = driver.find_element("css selector", "#limits details summary")
            driver.execute_script("arguments[0].scrollIntoView()", fold)
            fold.click()
            assert names[1] in driver.find_element("css selector", "#limits table").text
            assert driver.execute_script("return document.documentElement.scrollWidth") <= width
        assert complaints(driver) == []
