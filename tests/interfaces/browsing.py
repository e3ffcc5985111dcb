"""A browser without a window, for tests of pages; tests that need it are skipped where there is none."""

from __future__ import annotations

import json
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from builders.missing import needs

PROGRAMS = {name: shutil.which(name) for name in ("chromium", "chromedriver")}
needs_browser = needs("chromium", "chromedriver")
SWITCHES = (
    "--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
    "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist",
)  # fmt: skip


@contextmanager
def browser(folder: Path, width: int = 1440, height: int = 900) -> Iterator[Any]:
    """Chromium that reaches nothing but this machine.

    Args:
        folder: Empty, for its profile.
        width: Of its window, in pixels; below 600 it is a phone.
        height: The same.
    """
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service

    options = webdriver.ChromeOptions()
    options.binary_location = str(PROGRAMS["chromium"])
    offline = "--host-resolver-rules=MAP * ~NOTFOUND , EXCLUDE 127.0.0.1 , EXCLUDE localhost"
    for switch in (*SWITCHES, offline, f"--user-data-dir={folder}"):
        options.add_argument(switch)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    driver = webdriver.Chrome(options=options, service=Service(str(PROGRAMS["chromedriver"])))
    try:
        resized(driver, width, height)
        yield driver
    finally:
        driver.quit()


def resized(driver: Any, width: int, height: int) -> None:
    """Another screen, in pixels; below 600 it is a phone's."""
    size = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 600}
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)


def complaints(driver: Any) -> list[str]:
    """What the page wrote to the console as an error or a warning, since last asked.

    That pictures are drawn by software is Chromium's own remark.
    """
    entries = driver.get_log("browser")
    serious = [entry["message"] for entry in entries if entry["level"] in ("SEVERE", "WARNING")]
    return [text for text in serious if "GPU stall" not in text and "GL Driver" not in text]


def requests(driver: Any) -> list[str]:
    """Addresses that the page asked for, since last asked."""
    messages = [json.loads(entry["message"])["message"] for entry in driver.get_log("performance")]
    sent = [m["params"] for m in messages if m["method"] == "Network.requestWillBeSent"]
    return [params["request"]["url"] for params in sent]
