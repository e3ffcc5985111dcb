"""The summary page of a campaign in a browser: nothing sticks out of it, on a desktop or a phone."""

from __future__ import annotations

from pathlib import Path

from builders.campaign_folders import filled
from interfaces.browsing import browser, complaints, needs_browser, resized
from springback.campaign.access import Campaign
from springback.campaign.analysis.statistics import summary
from springback.interfaces.reports.campaign import write_summary

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
    assert "confidence: ARQ " in (tmp_path / "summary.html").read_text(encoding="utf-8")
    with browser(tmp_path / "profile") as driver:
        for width in (1440, 390):
            resized(driver, width, 900)
            driver.get((tmp_path / "summary.html").as_uri())
            assert driver.execute_script("return document.documentElement.scrollWidth") <= width
            [table] = driver.find_elements("css selector", "#failures table")
            box = table.find_element("xpath", "..")
            assert table.size["width"] <= box.size["width"] or width < 400
            command = table.find_element("css selector", "code")
            assert command.text.split()[:2] == ["springback", "view"]
        assert complaints(driver) == []
