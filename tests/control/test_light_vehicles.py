"""The usual gains of vehicles lighter than the paper's: as fast as Quad, and stable."""

from __future__ import annotations

from typing import Any

import pytest

from springback.control.linear import AXES, loop_eigenvalues
from springback.control.parameters import LIGHT, ControlSettings
from springback.errors import InputError
from springback.results.flight import as_scenario, fly
from springback.vehicle.library import VEHICLES

USUAL = ControlSettings()


def tables(vehicle: Any, **more: Any) -> dict[str, Any]:
    return {"vehicle": vehicle, "reference": {"type": "hold"}, **more}


def test_the_papers_robots_have_the_gains_of_before() -> None:
    assert VEHICLES["quad"].vehicle.mass == LIGHT
    for name in ("quad", "arq", "lmf2", "caged-sphere"):
        assert as_scenario(tables(name)).control == USUAL


@pytest.mark.parametrize("name", ["crazyflie", "tensegrity", "spiri", "navi"])
def test_a_lighter_one_is_as_fast_as_quad(name: str) -> None:
    """k/m, and with it every eigenvalue of the linearised loop, is that of Quad with the same lag."""
    scenario = as_scenario(tables(name))
    mass = scenario.vehicle.mass
    assert scenario.control.stiffness / mass == pytest.approx(USUAL.stiffness / LIGHT)
    for axis in AXES:
        found = loop_eigenvalues(scenario.control, axis, mass, 0.03)
        of_quad = loop_eigenvalues(USUAL, axis, LIGHT, 0.03)
        assert found == pytest.approx(of_quad, rel=1e-6)
        assert found[0].real < -1.0


def test_what_is_given_is_used_and_a_stored_scenario_is_the_same() -> None:
    given = as_scenario(tables("crazyflie", control={"stiffness": "0.5 N/m"})).control
    assert given.stiffness == 0.5
    assert given.vertical_stiffness == pytest.approx(20.0 * 0.031 / LIGHT)
    scenario = as_scenario(tables("crazyflie"))
    again = as_scenario(scenario.model_dump(mode="json"))
    assert again.control.stiffness == scenario.control.stiffness
    heavier = as_scenario(tables("crazyflie"), ("vehicle.body.mass=40 g",))
    assert heavier.control.stiffness == pytest.approx(9.25 * 0.04 / LIGHT)


def test_a_light_one_holds_its_place() -> None:
    """At the usual gains of Quad it swings away."""
    place = [0.0, 0.0, 1.0]
    given = tables("crazyflie", start={"position": place}, simulation={"duration": 3.0})
    c = fly(given).columns
    assert [c[axis][-1] for axis in "xyz"] == pytest.approx(place, abs=0.02)


def test_springbacks_pilot_needs_a_weight_to_lift() -> None:
    """Without gravity its thrust, and so its way to steer, would be none."""
    with pytest.raises(InputError) as caught:
        as_scenario(tables("arq", world={"gravity": 0.0}))
    assert list(caught.value.problems) == [
        "world.gravity: must be more than 0 m/s^2 with a reference, whose pilot steers by tilting "
        "its lift (got 0 m/s^2)"
    ]
    flight = fly(tables("quad", world={"gravity": "1.62 m/s^2"}, simulation={"duration": 0.5}))
    assert abs(flight.columns["z"][-1] - 1.0) < 0.02
