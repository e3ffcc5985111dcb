"""Moments that no body of a mass and size has: what is refused, and what is not."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from springback.errors import InputError
from springback.kernels.tracing import Tape
from springback.results.flight import as_scenario
from springback.vehicle.library import VEHICLES
from springback.vehicle.mass.bounds import BEYOND, DENSEST, check_inertia
from springback.vehicle.parameters import Vehicle

TURN = np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]])


def tello(*moments: float, **more: Any) -> Vehicle:
    """A Tello with its guards: 80 g, 0.1 m from the middle to the edge of a guard."""
    return Vehicle.model_validate({
        "body": {"mass": 0.08, "inertia": moments},
        "arms": {"directions": [0.8, -0.8, -2.4, 2.4], "length": 0.06, "mass": 0.0,
                 "cage_radius": 0.04, "compliant": False}, **more,
    })  # fmt: skip


def rows(matrix: Any) -> tuple[tuple[float, ...], ...]:
    return tuple(map(tuple, np.asarray(matrix).tolist()))


def test_published_inertias_of_a_tello_differ_too_much_for_all_to_be_possible() -> None:
    """Sources have 4.3e-5 to 9.7e-3 kg m² for it (docs/howto/vehicle.md); 80 g cannot have both."""
    tello(4.3e-5, 4.3e-5, 7.5e-5)
    with pytest.raises(ValueError, match=r"above 0\.0072 kg m².*within 0\.3 m.*got 0\.0097 kg m²"):
        tello(9.7e-3, 9.7e-3, 9.7e-3)


def test_the_library_is_far_from_both_bounds() -> None:
    """Moments below 0.4 of the most, and above ten times the least."""
    for entry in nonempty(VEHICLES.values()):
        body, reach = entry.vehicle.body, entry.vehicle.reach()
        check_inertia(body.mass, body.inertia, reach * math.sqrt(0.4) / BEYOND)
        check_inertia(body.mass, rows(np.array(body.inertia) / 10.0), reach)


def test_all_mass_at_the_bound_is_just_possible() -> None:
    """Two points at the ends of a stick, at three times the reach: m (3 r)² across it; 1e-9 more is refused."""
    most = 0.3 * (0.2) ** 2
    stick = np.diag([1e-6, most, most])
    check_inertia(0.3, rows(stick * (1.0 - 1e-9)), 0.2 / BEYOND)
    check_inertia(0.3, rows(TURN @ stick @ TURN.T * (1.0 - 1e-9)), 0.2 / BEYOND)
    for matrix in (stick, TURN @ stick @ TURN.T):
        with pytest.raises(ValueError, match=r"no principal moment above 0\.012 kg m²"):
            check_inertia(0.3, rows(matrix * (1.0 + 1e-9)), 0.2 / BEYOND)


def test_a_ball_of_osmium_is_just_possible() -> None:
    """2/5 m a², of a ball of the densest matter; a lighter shell of the same size has more."""
    for mass in (1e-3, 0.5, 40.0):
        radius = (mass / (4.0 / 3.0 * math.pi * DENSEST)) ** (1.0 / 3.0)
        ball = 0.4 * mass * radius**2 * np.eye(3)
        check_inertia(mass, rows(ball * (1.0 + 1e-9)), 1.0)
        with pytest.raises(ValueError, match="no matter is denser"):
            check_inertia(mass, rows(ball * (1.0 - 1e-9)), 1.0)
        long = np.diag([1e-3, 1.6, 1.6]) * 0.4 * mass * radius**2  # a rod of it: small along itself
        check_inertia(mass, rows(long), 1.0)


def test_reach_is_the_farthest_of_cages_and_hulls() -> None:
    assert tello(1e-4, 1e-4, 2e-4).reach() == pytest.approx(0.1)
    leg = {"type": "sphere", "on": 1, "position": [0, 0, -0.05], "radius": 0.01}
    assert tello(1e-4, 1e-4, 2e-4, hulls=[leg]).reach() == pytest.approx(0.12)
    hull = {"offset": [0, 0, -0.05], "radius": 0.07}
    assert tello(1e-4, 1e-4, 2e-4, hull=hull).reach() == pytest.approx(0.12)


def test_numbers_of_a_campaign_are_checked_row_by_row() -> None:
    """Traced: rows hold where the first row's answer is theirs."""
    tape = Tape(np.array([[1.0, 0.01], [1.0, 5.0], [1.0, 1e-7], [2.0, 0.02]]))
    mass, moment = tape.first
    zero = 0.0
    check_inertia(
        mass, ((moment, zero, zero), (zero, moment, zero), (zero, zero, moment)), 0.2 / BEYOND
    )
    assert tape.holds.tolist() == [True, False, False, True]
    tape = Tape(np.array([[0.01], [5.0], [1e-7]]))
    [moment] = tape.first
    check_inertia(
        1.0, ((moment, 1e-9, zero), (1e-9, moment, zero), (zero, zero, moment)), 0.2 / BEYOND
    )
    assert tape.holds.tolist() == [True, False, False]


@pytest.mark.parametrize(
    ("body", "message"),
    [
        ({"inertia": [1.28, 1.6, 2.5]}, "body.inertia: must have no principal moment above 0.9752"),
        ({"inertia": ["20 kg m^2"] * 3}, "(got 20 kg m²)"),
        ({"inertia": [6.4e-6, 8e-6, 1.25e-5]}, "body.inertia: must have principal moments that add"),
        ({"mass": 60.0}, "body.inertia: must have principal moments that add"),
        ({"mass": "10 g"}, "body.inertia: must have no principal moment above"),
        (
            {"parts": [{"type": "tube", "mass": "100 g", "start": [-3, 0, 0], "end": [3, 0, 0],
                         "radius": 0.01}]},
            "body.parts: must have no principal moment above 0.081 kg m², the most of 0.1 kg within",
        ),
    ],
)  # fmt: skip
def test_what_no_body_has_is_refused_in_one_line(body: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError) as caught:
        as_scenario({"vehicle": {"preset": "arq", "body": body}})
    assert len(caught.value.problems) == 1
    assert message in caught.value.problems[0]


def test_parts_may_be_points() -> None:
    """A battery and a board as two points have nothing about their line."""
    points = [{"type": "point", "mass": 0.3, "position": [x, 0, 0]} for x in (-0.02, 0.02)]
    points.append({"type": "ball", "mass": 0.1, "radius": 0.001})
    as_scenario({"vehicle": {"preset": "arq", "body": {"parts": points}}})
