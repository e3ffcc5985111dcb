"""An exported replay in a browser, driven by mouse and key."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from interfaces.browsing import requests

#: ARQ flies into a wall.
TABLES = {
    "name": "wall",
    "vehicle": "arq",
    "thrust": "hover",
    "world": {"obstacles": [{"type": "wall", "distance": 2.75, "surface": "wall"}]},
    "start": {"position": [2.3, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0], "pitch": 0.26},
    "simulation": {"duration": 0.3},
}


def pose(driver: Any) -> dict[str, Any]:
    found: dict[str, Any] = driver.execute_script("return window.springback.pose()")
    return found


def until(true: Callable[[], bool], seconds: float = 20.0) -> None:
    """Wait for what must come; how long it takes is the machine's affair."""
    end = time.monotonic() + seconds
    while not true():
        assert time.monotonic() < end
        time.sleep(0.05)


def opened(driver: Any, page: Path, fragment: str = "") -> None:
    driver.get("about:blank")
    requests(driver)
    driver.get(f"{page.as_uri()}{fragment}")
    until(lambda: driver.execute_script("return !!window.springback"))


def key(driver: Any, text: str) -> None:
    from selenium.webdriver.common.by import By

    driver.find_element(By.TAG_NAME, "body").send_keys(text)


def drag(driver: Any, element: Any, start: tuple[float, float], end: tuple[float, float]) -> None:
    """Press, move and let go, in shares of an element's width and height."""
    from selenium.webdriver.common.action_chains import ActionChains

    width, height = element.size["width"], element.size["height"]
    (a, b), (c, d) = start, end
    chain = ActionChains(driver, duration=50)
    chain.move_to_element_with_offset(element, (a - 0.5) * width, (b - 0.5) * height)
    chain.click_and_hold()
    for _ in range(2):
        chain.move_by_offset((c - a) * 0.5 * width, (d - b) * 0.5 * height)
    chain.release().perform()
