"""A long flight in the exported replay: all of it can be seen."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from interfaces.browsing import browser, complaints, needs_browser
from interfaces.replay.pages import TABLES, opened, pose
from springback.interfaces.replay.viewer import export_page, replay_of
from springback.results.flight import fly

pytestmark = needs_browser
LONG = {"position": [0.0, 0.0, 1.0], "velocity": [40.0, 0.0, 0.0]}


def test_the_view_of_the_whole_flight_shows_both_ends_of_a_long_path(tmp_path: Path) -> None:
    """Of 80 m, in windows wide and narrow; near and far planes of the camera cut nothing off."""
    ground: dict[str, Any] = {"obstacles": [{"type": "ground", "surface": "wall"}]}
    flight = fly(TABLES | {"world": ground, "start": LONG, "simulation": {"duration": 2.0}})
    assert flight.columns["x"][-1] == pytest.approx(80.0)
    path = tmp_path / "long.html"
    export_page(replay_of([flight]), path)
    for width in nonempty((1440, 500)):
        profile = tmp_path / str(width)
        profile.mkdir()
        with browser(profile, width=width) as driver:
            opened(driver, path, "#camera=free")
            [ends] = pose(driver)["seen"]
            assert np.abs(ends).max() < 1.0
            assert np.ptp(np.array(ends)[:, :2], axis=0).max() > 0.5  # nor is it a dot
            assert complaints(driver) == []
