"""What the vehicle is in truth, and what is believed of it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from springback.scenario.scenario import scenario_from
from springback.simulation.flight import fly_one

BASE: dict[str, Any] = {
    "vehicle": "arq",
    "start": {"position": [0.0, 0.0, 1.0]},
    "simulation": {"duration": 0.05},
}


def test_payload_and_model_error_change_the_truth_and_not_the_belief() -> None:
    """Mass and inertia of the whole vehicle by the factors; the payload on top; thrust as believed."""
    load = {"mass": "200 g", "inertia": [1e-4, 2e-4, 3e-4]}
    error = {"mass": 1.05, "inertia": 1.1}
    plain = scenario_from({**BASE, "thrust": "hover"})
    loaded = scenario_from({**BASE, "thrust": "hover", "payload": load, "model_error": error})
    believed, true = plain.vehicle, loaded.true_vehicle()
    assert loaded.vehicle == believed
    assert loaded.flight_model().thrust == plain.flight_model().thrust
    assert true.mass == pytest.approx(1.05 * believed.mass + 0.2, rel=1e-12)
    np.testing.assert_allclose(
        true.inertia(), 1.1 * believed.inertia() + np.diag([1e-4, 2e-4, 3e-4]), rtol=1e-12
    )
    assert loaded.flight_model().airframe == true.airframe() == loaded.true_airframe()
    assert loaded.true_airframe().arms == plain.true_airframe().arms
    assert plain.true_airframe() == believed.airframe()
    # Under the believed weight's thrust it sinks with what is too much: (1 − m / m_true) g.
    flown = fly_one(loaded.flight_model(), loaded.start_state(), trace=False, executor="python")
    sinking = (1.0 - believed.mass / true.mass) * 9.81 * flown.record.stepping.time
    assert flown.motion.state.velocity.z == pytest.approx(-sinking, rel=1e-9)
