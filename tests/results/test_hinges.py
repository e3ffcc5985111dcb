"""Angles and torques of hinged arms: their work is what springs, stops and dampers took."""

import numpy as np
import pytest

from builders.cases import nonempty
from springback.results.energy_history import ledger
from springback.results.flight import Flight, fly
from springback.results.joints.hinges import has_hinges, hinge_histories


def hit(vehicle: str) -> Flight:
    return fly({
        "vehicle": vehicle, "thrust": "hover",
        "world": {"obstacles": [{"type": "wall", "distance": 2.0, "surface": "wall"}]},
        "start": {"position": [1.5, 0.0, 1.0], "velocity": [1.0, 0.0, 0.0], "yaw": "20 deg"},
        "simulation": {"duration": 0.5},
    })  # fmt: skip


@pytest.fixture(scope="module")
def flight() -> Flight:
    return hit("xplorer")


def test_what_turns_the_hinges_is_stored_and_lost(flight: Flight) -> None:
    """∫ τ dθ over all hinges against the ledger, which knows of neither, at every instant."""
    hinges, books = hinge_histories(flight), ledger(flight)
    work = sum(
        np.concatenate([[0.0], np.cumsum(0.5 * (one.torque[1:] + one.torque[:-1]) * np.diff(one.angle))])
        for one in hinges
    )  # fmt: skip
    taken = sum(
        books[name] - books[name][0]
        for name in ("energy_springs", "energy_stops", "loss_arm", "loss_stop")
    )
    assert taken.max() > 1e-3
    assert work == pytest.approx(taken, abs=5e-3 * taken.max())
    assert [(one.arm, one.joint) for one in hinges] == [(j, 1) for j in range(1, 5)]


def test_an_angle_is_the_arc_over_the_radius_and_pressed_in_is_positive(flight: Flight) -> None:
    arms = flight.scenario.vehicle.airframe().arms
    for one, arm in nonempty(zip(hinge_histories(flight), arms, strict=True)):
        arc = arm.length - flight.columns[f"l{one.arm}"]
        assert one.angle == pytest.approx(arc * arm.joint.curvature)
        still = np.abs(flight.columns[f"dl{one.arm}"]) < 1e-3
        pressed = still & (np.abs(one.angle) > 0.02)
        assert np.all(one.torque[pressed] * one.angle[pressed] > 0.0)


def test_arms_that_slide_have_no_hinge() -> None:
    flight = hit("arq")
    assert not has_hinges(flight.scenario.vehicle)
    assert hinge_histories(flight) == ()
