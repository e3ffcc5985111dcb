"""The pilot that survives, in whole flights: blind to the truth, the same compiled or not."""

from typing import Any

import numpy as np
import pytest

import springback
from springback.errors import InputError
from springback.kernels.trees import leaves, rebuilt
from springback.kernels.vectors import Vec
from springback.recovery.state_machine import (
    CRUISE,
    HOVER,
    LOOK,
    RECOVER,
    RETURN,
    on_alarm,
    on_characterisation,
)
from springback.results.flight import Flight
from springback.scenario.avionics import cascade_of
from springback.scenario.scenario import scenario_from
from springback.simulation.measuring.measures import Outcome
from springback.simulation.ticks import pilot_output
from springback.studies.run_ups import run_up_scenario

GROUND = {"type": "ground", "surface": "wall"}


def hit(
    robot: str, pitch: float, speed: float, duration: float = 8.0, **tables: Any
) -> dict[str, Any]:
    given = run_up_scenario(robot, pitch, speed, **{"recovery": {}, **tables})
    given["world"]["obstacles"].append(GROUND)
    given["simulation"] = {"duration": duration}
    return given


@pytest.fixture(scope="module")
def flight() -> Flight:
    return springback.fly(hit("arq", 0.0, 3.5, 10.0))


def test_arq_survives_the_fastest_test(flight: Flight) -> None:
    m = flight.measures
    assert flight.outcome is Outcome.RECOVERED
    assert 0.0 < m["detection_delay"] < 0.02  # type: ignore[operator]
    assert m["recovered_runs"] == m["runs"] == 1.0
    assert m["false_alarms"] == 0.0
    end = [flight.columns[axis][-1] for axis in "xyz"]
    np.testing.assert_allclose(end, (0.0, 0.0, 1.0), atol=0.1)


def test_legs_come_in_their_order(flight: Flight) -> None:
    phases = flight.telemetry["phase"]
    order = [phase for k, phase in enumerate(phases) if k == 0 or phase != phases[k - 1]]
    assert order == [CRUISE, LOOK, RECOVER, RETURN, HOVER]
    names = ("alarm_time", "planned_time", "rested_time", "home_time")
    for name, phase in zip(names, (LOOK, RECOVER, RETURN, HOVER), strict=True):
        begins = flight.telemetry["t"][np.argmax(phases == phase)]
        assert flight.measures[name] == pytest.approx(begins, abs=1e-9)


def test_the_alarm_comes_after_the_touch_and_the_goal_is_before_the_wall(flight: Flight) -> None:
    d, touch = flight.telemetry, flight.measures["touch_time"]
    noticed = np.argmax(d["phase"] == LOOK)
    assert d["t"][noticed] > touch
    gone = np.argmax(d["phase"] == RECOVER)
    goal = np.array([d[f"goal_{axis}"][gone] for axis in "xyz"])
    there = np.array([d[f"est_{axis}"][noticed] for axis in "xyz"])
    np.testing.assert_allclose(goal, there - [0.1, 0.0, 0.0], atol=5e-3)


def test_energy_of_the_hit_is_accounted_for(flight: Flight) -> None:
    assert abs(flight.measures["ledger_residual"]) < 1e-4  # type: ignore[arg-type]
    assert flight.measures["loss_contact"] > 1.0  # type: ignore[operator]


def test_the_truth_is_poison_and_nothing_changes() -> None:
    """Plain Python with an absurd `exact` in every measurement flies the compiled flight.

    So neither detection, nor characterisation, nor control reads it; and plain equals compiled.
    It is thrown at the wall, for plain Python takes its time.
    """
    tables = hit("arq", 0.0, 3.5, 0.3)
    tables["start"] = {"position": [2.35, 0.0, 1.0], "velocity": [3.0, 0.0, 0.0]}
    tables["reference"] = {**tables["reference"], "start": [0.0, 0.0, 1.0]}  # room for a run-up
    scenario = scenario_from(tables)
    own = cascade_of(scenario, scenario.flight_model(), scenario.start_state())
    absurd: list[Any] = []

    def poisoned(time: float, measurement: Any, memory: Any) -> tuple[Any, Any]:
        if not absurd:
            absurd.append(rebuilt(measurement.exact, [1e6] * len(leaves(measurement.exact))))
        seen = measurement._replace(exact=absurd[0])
        thought = own.memory if memory is None else memory
        said = pilot_output(own.settings, 1e-3, round(1e3 * time), seen, thought, 4)
        phases.append(said.memory.recovery_state.phase)
        return said.thrust, said.memory

    phases: list[float] = []
    compiled = springback.fly(tables)
    plain = springback.fly(tables, pilot=poisoned)
    assert {CRUISE, LOOK, RECOVER} <= set(phases)
    assert len(plain.t) == len(compiled.t)
    for axis in "xyz":
        apart = np.abs(plain.columns[axis] - compiled.columns[axis])
        assert apart.max() < 1e-9  # sums in another order, grown by a bounce


def test_the_observer_waits_for_a_sample() -> None:
    """Of the external wrench only the rotors' thrust goes on between inertial samples."""
    scenario = scenario_from(hit("arq", 0.0, 3.5, 0.002))
    own = cascade_of(scenario, scenario.flight_model(), scenario.start_state())
    told: list[Any] = []

    def noting(time: float, measurement: Any, memory: Any) -> tuple[Any, Any]:
        told.append(measurement)
        said = pilot_output(own.settings, 1e-3, 0, measurement, own.memory, 4)
        return said.thrust, said.memory

    springback.fly(scenario, pilot=noting)
    inertial = told[-1].inertial
    before = own.memory.wrench
    after = {}
    for fresh in (0.0, 1.0):
        felt = inertial._replace(fresh=fresh, specific_force=Vec(5.0, 0.0, 0.0))
        seen = told[-1]._replace(inertial=felt)
        after[fresh] = pilot_output(own.settings, 1e-3, 0, seen, own.memory, 4).memory.wrench
    assert after[0.0]._replace(thrust=before.thrust) == before
    assert after[1.0].force.x > before.force.x + 0.1
    assert after[1.0].thrust == after[0.0].thrust


@pytest.mark.parametrize("way", ["pre-impact", "staged"])
def test_a_second_alarm_keeps_what_the_pilot_steers_to(way: str) -> None:
    """While it characterises the next collision, not to the run-up, whose end is behind the wall."""
    scenario = scenario_from(hit("arq", 0.0, 3.5, 0.002, recovery={"response": {"way": way}}))
    own = cascade_of(scenario, scenario.flight_model(), scenario.start_state())
    told: list[Any] = []

    def noting(time: float, measurement: Any, memory: Any) -> tuple[Any, Any]:
        told.append(measurement)
        return pilot_output(own.settings, 1e-3, 0, measurement, own.memory, 4).thrust, memory

    springback.fly(scenario, pilot=noting)
    tick, late = 5000, 5.0  # by then the run-up is over
    estimate = own.memory.flight.estimate
    route, hit_ = own.settings.route, own.memory.collision._replace(direction=Vec(1.0, 0.0, 0.0))
    looking = on_alarm(own.memory.recovery_state, late - 0.01)
    gone = on_characterisation(route, looking, hit_, estimate, late - 0.005, 0.0)
    wanted = {}
    for name, state in (("recovers", gone), ("looks", on_alarm(gone, late))):
        memory = own.memory._replace(recovery_state=state, collision=hit_)
        said = pilot_output(own.settings, 1e-3, tick, told[-1], memory, 4).memory
        assert said.recovery_state.phase == state.phase
        wanted[name] = said.flight.offboard
    if way == "staged":  # which has no reference: the last command stays
        assert wanted["looks"] == own.memory.flight.offboard
        assert wanted["recovers"].word != wanted["looks"].word
    else:
        assert wanted["looks"] == wanted["recovers"]
        assert abs(wanted["looks"].wanted.position.x) < 1.0


def test_two_runs_without_landing() -> None:
    flight = springback.fly(hit("arq", 0.0, 2.0, 20.0, recovery={"runs": 2}))
    assert flight.outcome is Outcome.RECOVERED
    assert flight.measures["runs"] == flight.measures["recovered_runs"] == 2.0
    assert flight.telemetry["phase"][-1] == HOVER


def test_nothing_to_hit_is_no_alarm() -> None:
    tables = hit("arq", 0.0, 2.0, 6.0)
    tables["world"]["obstacles"][0]["distance"] = 50.0
    flight = springback.fly(tables)
    assert flight.outcome is Outcome.NO_CONTACT
    assert flight.measures["false_alarms"] == 0.0
    assert set(flight.telemetry["phase"]) == {CRUISE}


def test_without_detection_the_collision_is_missed() -> None:
    deaf = {"detection": {"hall": {"threshold": "40 mm"}}}
    flight = springback.fly(hit("arq", 0.0, 2.0, 5.0, recovery=deaf))
    assert flight.outcome in (Outcome.NOT_DETECTED, Outcome.HIT_GROUND)
    assert flight.measures["detection_delay"] is None


@pytest.mark.parametrize(
    ("recovery", "words"),
    [
        ({"response": {"way": "sideways"}}, ("recovery.response.way", "pre-impact")),
        ({"response": {"distance": "10 deg"}}, ("recovery.response.distance", "wrong unit", "expected m")),
        ({"response": {"pace": -1.0}}, ("recovery.response.pace", "at least 0")),
        ({"detection": {"hall": {"threshold": 0.0}}}, ("recovery.detection.hall.threshold", "more than 0 m")),
        ({"detection": {"hall": {"persistence": 0}}}, ("recovery.detection.hall.persistence",)),
        ({"detection": {"hal": {}}}, ("recovery.detection.hal", "hall")),
        ({"detection": {"acceleration": {"used": False}}}, ("recovery.detection", "no trigger")),
        ({"detection": {"hall": {"used": True}}}, ("recovery.detection.hall.used", "no arm can slide")),
        ({"observer": {"force_bandwidth": 2000.0}}, ("recovery.observer.force_bandwidth", "at most 1000")),
        ({"settling": {"stay": 0.1}}, ("recovery.settling.stay", "at least dwell")),
        ({"runs": 0}, ("recovery.runs",)),
        ({"characterisation": {"source": "nose"}}, ("recovery.characterisation.source",)),
    ],
)  # fmt: skip
def test_bad_input_is_named(recovery: dict[str, Any], words: tuple[str, ...]) -> None:
    with pytest.raises(InputError) as caught:
        scenario_from(hit("quad", 0.0, 2.0, recovery=recovery))
    told = "; ".join(caught.value.problems)
    for word in words:
        assert word in told
