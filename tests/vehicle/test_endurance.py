"""Hover power, hover time and payload: momentum theory in its limits and proportions."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from springback.errors import InputError
from springback.vehicle.endurance import (
    GRAVITY,
    endurance_curve,
    figure_of_merit_for,
    hover_power,
    hover_time,
    induced_power,
    largest_payload,
)
from springback.vehicle.library import FIGURE_OF_MERIT, VEHICLES
from springback.vehicle.parameters import Arms, Body, Vehicle
from springback.vehicle.propulsion import Propulsion

ENGINE: dict[str, Any] = {
    "max_thrust": 8.0, "figure_of_merit": 0.5, "disk_radius": 0.1, "battery_energy": 2e5,
    "usable_share": 0.75, "electronics_power": 0.0,
}  # fmt: skip


def craft(mass: float = 1.0, count: int = 4, **changes: Any) -> Vehicle:
    """A vehicle of some arms that weigh nothing."""
    directions = tuple(2.0 * math.pi * j / count for j in range(count))
    return Vehicle(
        body=Body(mass=mass, inertia=(0.01, 0.01, 0.02)),
        arms=Arms(directions=directions, length=0.2, mass=0.0, cage_radius=0.03, compliant=False),
        propulsion=Propulsion(**{**ENGINE, **changes}),
    )


def test_induced_power_is_work_on_the_wake() -> None:
    """Independent: the wake of mass flow ρ A v leaves with w = 2 v; force ṁ w and power ½ ṁ w² follow."""
    radius, density, v = 0.09, 1.2, 6.0
    flow = density * math.pi * radius**2 * v
    assert induced_power(flow * 2.0 * v, radius, density) == pytest.approx(
        0.5 * flow * (2.0 * v) ** 2
    )


def test_hover_power_of_a_helicopter() -> None:
    """One rotor of 1 m² in air of 0.5 kg/m³ under 9.81 N: √(2ρA) = 1, so 9.81^1.5 W ideally."""
    one = craft(
        count=1, disk_radius=math.pi**-0.5, air_density=0.5, max_thrust=20.0, figure_of_merit=1.0
    )
    assert hover_power(one) == pytest.approx(9.81**1.5)
    assert hover_power(craft(electronics_power=7.0)) == pytest.approx(hover_power(craft()) + 7.0)


def test_proportions() -> None:
    """P ∝ m^1.5/(FM r √ρ); more disks of the same size share the load, P ∝ n^-0.5."""
    power = hover_power(craft())
    assert hover_power(craft(mass=2.0)) == pytest.approx(power * 2.0**1.5)
    assert hover_power(craft(), payload=1.0) == pytest.approx(power * 2.0**1.5)
    assert hover_power(craft(figure_of_merit=0.25)) == pytest.approx(power * 2.0)
    assert hover_power(craft(disk_radius=0.2)) == pytest.approx(power / 2.0)
    assert hover_power(craft(air_density=4.9)) == pytest.approx(power / 2.0)
    assert hover_power(craft(count=16)) == pytest.approx(power / 2.0)


def test_energy_is_spent_exactly() -> None:
    """Hover time times hover power is the usable energy."""
    loaded = craft(electronics_power=20.0)
    for payload in (0.0, 0.5, 2.0):
        spent = hover_time(loaded, payload) * hover_power(loaded, payload)
        assert spent == pytest.approx(0.75 * 2e5)


def test_best_battery_weighs_twice_the_rest() -> None:
    """Known optimum: with energy in proportion to the battery's mass b, b/(m + b)^1.5 peaks at 2 m."""
    masses = np.linspace(0.5, 4.0, 701)
    times = [
        hover_time(craft(mass=1.0 + b, battery_energy=b * 5e5, max_thrust=50.0)) for b in masses
    ]
    assert masses[int(np.argmax(times))] == pytest.approx(2.0, abs=0.006)


def test_largest_payload_is_where_thrust_just_holds() -> None:
    """There hover takes exactly the most thrust; a gram more and it is refused."""
    payload = largest_payload(craft())
    assert (1.0 + payload) * GRAVITY == pytest.approx(32.0)
    assert hover_time(craft(), payload) > 0.0
    with pytest.raises(InputError, match=r"cannot hover: it takes 8.00245 N .*max_thrust is 8 N"):
        hover_power(craft(), payload + 0.001)
    reserve = largest_payload(craft(), thrust_to_weight=2.0)
    assert 2.0 * (1.0 + reserve) == pytest.approx(1.0 + payload)


def test_curve_falls_and_is_the_hover_time() -> None:
    payloads = [0.0, 0.3, 1.0]
    curve = endurance_curve(craft(), payloads)
    assert curve.shape == (3,)
    assert np.all(np.diff(curve) < 0.0)
    assert list(curve) == [hover_time(craft(), payload) for payload in payloads]
    with pytest.raises(InputError, match="cannot hover"):
        endurance_curve(craft(), [0.0, 5.0])


def test_figure_of_merit_comes_back_from_a_hover_time() -> None:
    """Recovery of truth, with electronics and payload, and without reading the vehicle's own."""
    known = craft(figure_of_merit=0.43, electronics_power=12.0)
    blank = craft(figure_of_merit=None, electronics_power=12.0)
    assert figure_of_merit_for(blank, hover_time(known, 0.4), 0.4) == pytest.approx(0.43)


def test_library_holds_the_fit_to_quad() -> None:
    """Four digits of the figure of merit that gives Quad's printed 573 s."""
    fitted = figure_of_merit_for(VEHICLES["quad"].vehicle, 573.0)
    assert pytest.approx(fitted, abs=5e-5) == FIGURE_OF_MERIT


@pytest.mark.parametrize("name", ["figure_of_merit", "disk_radius", "battery_energy"])
def test_missing_number_is_named(name: str) -> None:
    with pytest.raises(InputError, match=f"propulsion.{name} is missing"):
        hover_time(craft(**{name: None}))


def test_bad_input_is_one_clear_line() -> None:
    with pytest.raises(InputError, match="arq-slider has no propulsion"):
        hover_time(VEHICLES["arq-slider"].vehicle)
    for payload in (-0.1, math.nan, math.inf):
        with pytest.raises(InputError, match="at least 0 kg"):
            hover_power(craft(), payload)
    with pytest.raises(InputError, match="cannot lift itself"):
        largest_payload(craft(mass=5.0))
    with pytest.raises(InputError, match="at least 1"):
        largest_payload(craft(), 0.5)
    with pytest.raises(InputError, match="more than 0 s"):
        figure_of_merit_for(craft(), 0.0)
    with pytest.raises(InputError, match="electronics alone"):
        figure_of_merit_for(craft(electronics_power=500.0), 1e3)
