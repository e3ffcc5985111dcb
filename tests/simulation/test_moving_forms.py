"""Forms from files, nets and unions that move."""

from __future__ import annotations

from typing import Any

import pytest

from builders.cases import nonempty
from builders.forms import box_file, cells_file, hills_file
from springback.errors import InputError
from springback.results.flight import Flight, fly
from springback.scenario.scenario import scenario_from

SURFACE = {"law": "hunt-crossley", "stiffness": 4e5, "dissipation": 0.3, "friction": 0.5}
OTHER = {**SURFACE, "stiffness": 1e5, "friction": 0.2}
FORMS: dict[str, dict[str, Any]] = {
    "mesh": {"type": "mesh", "file": box_file(0.2, 0.3, 0.4), "position": [0.43, 0.05, 0.05], "yaw": 0.3},
    "cells": {"type": "occupancy", "file": cells_file(), "position": [0.32, -0.3, -0.3]},
    "heightmap": {"type": "heightmap", "file": hills_file(), "spacing": 0.1,
                  "position": [0.42, 0.0, 0.0], "pitch": "-90 deg"},
    "net": {"type": "net", "position": [0.3, 0.0, 0.0], "tension": "40 N/m"},
    "union": {"type": "union", "position": [0.4, 0.0, 0.0], "shapes": [
        {"type": "box", "position": [0.0, 0.1, 0.0], "size": [0.2, 0.3, 0.4], "edge_radius": 0.02,
         "surface": SURFACE},
        {"type": "sphere", "position": [0.0, -0.1, 0.0], "radius": 0.12, "surface": OTHER},
    ]},
}  # fmt: skip
MOTIONS: dict[str, dict[str, Any]] = {
    "constant": {"type": "constant", "velocity": [-2.0, 0.0, 0.3], "turning": 3.0},
    "sine": {"type": "sine", "amplitude": [-0.1, 0.0, 0.0], "frequency": 6.0, "swing": 0.4},
    "table": {"type": "table", "time": [0.0, 0.05, 0.2],
              "position": [[0.0, 0.0, 0.0], [-0.15, 0.0, 0.0], [-0.15, 0.1, 0.0]],
              "angle": [0.0, 0.2, 0.0]},
}  # fmt: skip


def obstacle(name: str, **motion: Any) -> dict[str, Any]:
    """One of them, with a surface if it has none of its own, and a motion if one is given."""
    form = FORMS[name] | ({} if name in ("net", "union") else {"surface": SURFACE})
    return form | ({"motion": motion} if motion else {})


def flown(*obstacles: dict[str, Any], velocity: Any, duration: float = 0.12) -> Flight:
    """ARQ without gravity or thrust, from the origin."""
    return fly(
        {
            "vehicle": "arq",
            "world": {"obstacles": list(obstacles), "gravity": 0.0},
            "start": {"position": [0.0, 0.0, 0.0], "velocity": list(velocity)},
            "simulation": {"duration": duration},
        }
    )


@pytest.mark.parametrize("name", FORMS)
def test_it_follows_every_prescribed_motion(name: str) -> None:
    """It touches, and the ledger of vehicle and what drives it closes."""
    for motion in nonempty(MOTIONS):
        flight = flown(obstacle(name, **MOTIONS[motion]), velocity=(0.8, 0.0, 0.0))
        assert flight.measures["contacts"] >= 1.0, motion
        assert abs(flight.measures["ledger_residual"] or 1.0) < 5e-5, motion
        assert abs(flight.measures["work_driven"] or 0.0) > 1e-3, motion


@pytest.mark.parametrize("name", FORMS)
def test_it_is_one_at_rest_in_the_moving_frame(name: str) -> None:
    """All positions relative to it are the same."""
    drift = [-1.5, 0.4, 0.2]
    moving = flown(obstacle(name, type="constant", velocity=drift), velocity=(0.5, 0.0, 0.0))
    still = flown(obstacle(name), velocity=(2.0, -0.4, -0.2))
    assert still.measures["contacts"] >= 1.0
    for k, axis in enumerate("xyz"):
        end = still.columns[axis][-1] + drift[k] * moving.t[-1]
        assert moving.columns[axis][-1] == pytest.approx(end, abs=1e-7), axis
    assert moving.touch_speed == pytest.approx(still.touch_speed, rel=1e-7)


def test_each_part_of_a_union_that_moves_has_its_surface() -> None:
    """The soft sphere of the union is hit, and it is as soft as one that moves alone."""
    motion = {"type": "constant", "velocity": [-1.0, 0.0, 0.0]}
    shapes = FORMS["union"]["shapes"]
    ball = {**shapes[1], "position": [0.4, -0.1, 0.0], "motion": motion}
    union = FORMS["union"] | {"shapes": [shapes[0] | {"position": [0.0, 2.0, 0.0]}, shapes[1]]}
    one, other = (
        flown(entry, velocity=(1.0, 0.0, 0.0)) for entry in (ball, {**union, "motion": motion})
    )
    assert one.impact_peak_acceleration == pytest.approx(other.impact_peak_acceleration, rel=1e-9)


def test_a_union_is_thrown_as_the_body_that_it_is() -> None:
    """Two halves of a box, thrown: mass, centre and inertia are those of the whole one.

    They meet in a groove of two round edges, into which a circle reaches a little: hence 1e-4.
    """
    free = {"type": "free", "mass": 0.4, "velocity": [-2.0, 0.0, 0.0]}
    whole = {
        "type": "box",
        "position": [0.43, 0.05, 0.0],
        "size": [0.2, 0.4, 0.3],
        "surface": SURFACE,
    }
    half = {"type": "box", "size": [0.2, 0.2, 0.3], "surface": SURFACE}
    halves = {"type": "union", "position": [0.43, 0.05, 0.0], "shapes": [
        {**half, "position": [0.0, y, 0.0]} for y in (-0.1, 0.1)
    ]}  # fmt: skip
    one, other = (
        flown({**entry, "motion": free}, velocity=(0.5, 0.0, 0.0)) for entry in (whole, halves)
    )
    assert one.measures["contacts"] >= 1.0
    for name in nonempty(("impulse_x", "impulse_y", "touch_time", "impact_peak_acceleration")):
        assert one.measures[name] == pytest.approx(other.measures[name], rel=1e-4), name  # type: ignore[literal-required]


@pytest.mark.parametrize("name", ["mesh", "cells", "heightmap"])
def test_a_form_from_a_file_cannot_be_thrown(name: str) -> None:
    """What it would touch the world with is not known; the line says what can be."""
    thrown = obstacle(name, type="free", mass=1.0, inertia=[0.01, 0.01, 0.01])
    with pytest.raises(
        InputError, match=r"world\.obstacles\[0\]\.motion\.type: must be constant, sine"
    ):
        scenario_from({"vehicle": "arq", "world": {"obstacles": [thrown]}})
