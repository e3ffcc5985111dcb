"""What the rotors could not give of a moment, which keeps the integral of the rate loop from growing."""

from __future__ import annotations

import pytest

from springback.control.mixing import wrench_of
from springback.control.rate import turn
from springback.kernels.vectors import ZERO, Vec, norm
from springback.scenario.avionics import build_avionics
from springback.scenario.scenario import scenario_from
from springback.sensing.sensors import noise_count
from springback.simulation.onboard import Truth, sensor_step
from springback.simulation.ticks import pilot_output


@pytest.mark.parametrize(("roll_rate", "is_too_much"), [(0.2, False), (40.0, True)])
def test_unmet_is_what_was_asked_less_what_is_given(roll_rate: float, is_too_much: bool) -> None:
    scenario = scenario_from({"vehicle": "quad", "reference": {"type": "hold"}})
    model, start = scenario.flight_model(), scenario.start_state()
    avionics = build_avionics(scenario, model, start).avionics
    systems, memory = avionics.systems, avionics.onboard.pilot
    pilot, truth = systems.pilot, Truth(start, start, systems.period, model.world.gravity)
    silent = (0.0,) * noise_count(4)
    seen = sensor_step(systems.sensors, 0.0, truth, silent, avionics.onboard.sensors).measurement
    setpoint = Vec(roll_rate, 0.0, 0.0)
    before = memory.autopilot._replace(setpoint=setpoint)
    after = pilot_output(
        pilot, avionics.systems.period, 1, seen, memory._replace(autopilot=before), 4
    )
    own = after.memory.autopilot
    inertia, omega = own.built.tree.inertia, after.memory.estimate.angular_velocity
    asked = turn(pilot.rate, inertia, setpoint, omega, ZERO, before.rate).moment
    given = wrench_of(pilot.airframe, seen.arm_length, after.thrust).moment
    assert own.unmet == pytest.approx(asked - given, abs=1e-12)
    assert (norm(own.unmet) > 0.1) == is_too_much
