"""Rotors that a vehicle lists, on the page of a replay."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from builders.cases import nonempty
from builders.listed_rotors import canted, vehicle_with
from interfaces.browsing import browser, complaints, needs_browser
from interfaces.replay.pages import opened, pose
from springback.interfaces.animation import bodies
from springback.interfaces.replay.scene import scene_of
from springback.interfaces.replay.viewer import export_page, replay_of
from springback.results.flight import fly


@needs_browser
def test_the_page_draws_tilted_rotors_along_their_axes(tmp_path: Path) -> None:
    rotors = [*canted(math.radians(30.0))[:5], {"on": "body", "position": [0.0, 0.05, 0.04]}]
    flight = fly(
        {
            "vehicle": vehicle_with(rotors), "thrust": "hover",
            "start": {"angular_velocity": [3.0, 1.0, 2.0]}, "simulation": {"duration": 0.1},
        },
        executor="python",
    )  # fmt: skip
    page, scene = tmp_path / "listed.html", scene_of(flight)
    export_page(replay_of([flight]), page)
    k = len(scene.t) // 2
    now = bodies.pose(scene, float(scene.t[k]))
    places = bodies.rotor_places(scene.rotors, bodies.end_places(scene.arms, now), now)
    with browser(tmp_path / "profile") as driver:
        opened(driver, page, f"#t={float(scene.t[k])}")
        (shown,) = pose(driver)["ends"]
        for drawn, place in nonempty(zip(shown[:5], places[:5], strict=True)):
            assert drawn["thrust"] == pytest.approx(place.thrust, abs=1e-5)
        assert shown[5]["thrust"] is None  # an arm without a rotor
        assert complaints(driver) == []
    assert np.ptp([place.thrust[2] for place in places]) > 0.1
