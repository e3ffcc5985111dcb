"""What is read of a recovery, from memories made by hand."""

from __future__ import annotations

import math
import re
from typing import Any

import numpy as np
import pytest

from builders.records import record_of, record_with
from springback.kernels.vectors import Vec
from springback.recovery.evaluator import evaluator_at_start
from springback.results.flight import Flight
from springback.results.recovery_measures import (
    RECOVERY_MEASURES,
    recovery_columns,
    recovery_outcomes,
)
from springback.results.result import FlightResult
from springback.scenario.avionics import build_avionics
from springback.scenario.scenario import scenario_from
from springback.simulation.measuring.columns import as_columns
from springback.simulation.measuring.measures import MEASURES, Outcome, scalars_of
from springback.simulation.measuring.record import NOT_FINITE


def memories() -> tuple[Any, Any, Any]:
    """Of a flight in which nothing has happened yet."""
    given = {"vehicle": "arq", "reference": {"type": "hold"}, "recovery": {}}
    scenario = scenario_from(given)
    built_avionics = build_avionics(scenario, scenario.flight_model(), scenario.start_state())
    return (
        record_of(4),
        evaluator_at_start(Vec(0.0, 0.0, 1.0)),
        built_avionics.avionics.onboard.pilot,
    )


def read(record: Any, seen: Any, memory: Any) -> dict[str, float | None]:
    return scalars_of(recovery_columns(*(as_columns(tree) for tree in (record, seen, memory))))


def test_nothing_has_happened() -> None:
    told = read(*memories())
    assert list(told) == list(RECOVERY_MEASURES)
    known = {name for name, value in told.items() if value is not None}
    assert known == {"runs", "recovered_runs", "false_alarms", "lowest_height"}


@pytest.mark.parametrize(("runs", "delay"), [(1.0, 0.0099), (2.0, 0.009)])
def test_delays_count_from_the_exact_first_touch_or_the_tick_of_a_later_one(
    runs: float, delay: float
) -> None:
    record, seen, memory = memories()
    record = record_with(record, first_impact={"touch_time": 0.1001, "inward": Vec(1.0, 0.0, 0.0)})
    seen = seen._replace(runs=runs, run=seen.run._replace(touch=0.101, alarm=0.11, settled=0.9))
    hit = memory.collision._replace(
        direction=Vec(1.0, 1.0, 7.0), position=Vec(0.0, 3.0, 5.0), intensity=12.0
    )
    told = read(record, seen, memory._replace(collision=hit))
    assert told["detection_delay"] == pytest.approx(delay)
    assert told["recovery_time"] == pytest.approx(0.79 + delay)
    assert told["direction_error"] == pytest.approx(math.pi / 4.0)  # level parts only
    assert told["arms_direction_error"] is None
    assert told["position_error"] == pytest.approx(5.0)  # from (0, 0, 1) to (0, 3, 5)
    assert told["intensity"] == 12.0


def test_outcomes_in_their_order() -> None:
    record, seen, memory = memories()
    touched, ran = record_with(record, contacts={"total": 1.0}), seen._replace(runs=1.0)
    grounded = record_with(touched, contacts={"ground_time": 0.2})
    alarmed = ran._replace(run=ran.run._replace(alarm=0.1))
    cases = [
        (record, seen, Outcome.NO_CONTACT),
        (touched, seen, Outcome.SEPARATED),
        (touched, ran, Outcome.NOT_DETECTED),
        (touched, alarmed, Outcome.NOT_SETTLED),
        (touched, alarmed._replace(recovered=1.0), Outcome.RECOVERED),
        (grounded, alarmed._replace(recovered=1.0), Outcome.HIT_GROUND),
        (
            record_with(grounded, stepping={"status": NOT_FINITE}),
            alarmed,
            Outcome.NOT_FINITE,
        ),
        (record_with(touched, contacts={"bottomed_time": 0.1}), alarmed, Outcome.NOT_SETTLED),
    ]
    for one, judged, wanted in cases:
        trees = [as_columns(tree) for tree in (one, judged, memory)]
        assert recovery_outcomes(*trees) == [wanted]


def test_a_flight_is_printed_in_degrees_and_measured_in_radians() -> None:
    """As summary and lab print it; what is computed with stays in SI."""
    told = read(*memories()) | {"nose_up": math.radians(-28.6), "nose_down": None}
    measures = dict.fromkeys(MEASURES) | told
    scenario = scenario_from({"vehicle": "arq", "reference": {"type": "hold"}, "recovery": {}})
    flight = Flight(scenario, Outcome.RECOVERED, measures, {}, {})
    assert re.search(r"^  nose_up +-28\.6 deg$", repr(flight), re.M)
    assert re.search(r"^  nose_down +-$", repr(flight), re.M)
    assert flight.nose_up == math.radians(-28.6)
    assert flight.summary()["units"]["nose_up"] == "rad"


def test_a_later_peak_and_a_bottomed_arm_are_explained() -> None:
    """A large peak beside a small one of the first impact says when it was; otherwise nothing."""
    scenario = scenario_from({"vehicle": "arq"})
    measures = dict.fromkeys(MEASURES) | {
        "impact_peak_acceleration": 148.0, "peak_acceleration": 1525.0,
        "separation_time": 0.3, "peak_acceleration_time": 0.8, "bottomed_time": 0.79,
    }  # fmt: skip
    later = repr(Flight(scenario, Outcome.SEPARATED, measures, {}, {}))
    assert re.search(
        r"^  peak_acceleration +1525 m/s², at 0\.8 s: after the first impact", later, re.M
    )
    assert "an arm reached the end of its stroke at 0.79 s" in later
    within = measures | {"peak_acceleration_time": 0.2, "bottomed_time": None}
    same = repr(Flight(scenario, Outcome.SEPARATED, within, {}, {}))
    assert "after the first impact" not in same
    assert "stroke at" not in same
    settling = measures | {"peak_acceleration": 148.0}  # the first impact's, while arms settle
    resting = measures | {"impact_peak_acceleration": None, "peak_acceleration": 1.6e-13}
    for known in (settling, resting):
        told = repr(Flight(scenario, Outcome.SEPARATED, known, {}, {}))
        assert "after the first impact" not in told


def test_a_peak_at_the_end_of_a_flight_is_said_to_be_unfinished() -> None:
    """A flight that ends while it is pressed harder and harder; one that ends later does not."""
    scenario = scenario_from({"vehicle": "arq", "simulation": {"duration": 0.3}})
    measures = dict.fromkeys(MEASURES) | {"impact_peak_acceleration": 28.0}
    for when, is_told in ((0.3, True), (0.29, False)):
        told = measures | {"impact_peak_acceleration_time": when}
        printed = repr(Flight(scenario, Outcome.IN_CONTACT, told, {}, {}))
        assert ("28 m/s², as the flight ends" in printed) == is_told


def test_a_first_peak_that_no_contact_makes_is_explained() -> None:
    """As an arm comes back to its stop; neither while it is pressed nor in a fall."""
    scenario = scenario_from({"vehicle": "arq"})
    columns = {"t": np.array([0.1, 0.2]), "fn1": np.array([400.0, 5.0]), "z": np.ones(2)}
    for peak, when, is_told in ((368.0, 0.2, True), (368.0, 0.1, False), (9.81, 0.2, False)):
        measures = dict.fromkeys(MEASURES) | {
            "impact_peak_acceleration": peak, "impact_peak_acceleration_time": when,
        }  # fmt: skip
        told = repr(FlightResult(scenario, Outcome.SEPARATED, measures, columns, {}))
        assert ("m/s², at 0.2 s with 5 N of contact: arms that" in told) == is_told


def test_a_flight_that_falls_where_there_is_no_ground_says_so() -> None:
    """Below zero height, without a ground; not if it stays above, or a ground is there."""
    ground = {"type": "ground", "surface": "wall"}
    measures = dict.fromkeys(MEASURES) | read(*memories()) | {"height_loss": 5.5}
    fallen, kept = (np.array([1.0, lowest]) for lowest in (-4.5, 0.2))
    cases = [(fallen, [], True), (kept, [], False), (fallen, [ground], False)]
    for heights, obstacles, is_told in cases:
        scenario = scenario_from({"vehicle": "arq", "world": {"obstacles": obstacles}})
        told = repr(Flight(scenario, Outcome.NO_CONTACT, measures, {"z": heights}, {}))
        assert ("5.5 m, down to z = -4.5 m: the world has no ground" in told) == is_told
