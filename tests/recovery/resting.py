"""The memory of a recovering pilot at rest at home."""

import functools

from springback.experiments.guidance import cascade_of
from springback.experiments.run_ups import run_up_scenario
from springback.experiments.scenario import scenario_from
from springback.recovery.pilot import ResilientMemory


@functools.cache
def resting_memory() -> ResilientMemory:
    scenario = scenario_from(run_up_scenario("arq", 0.0, 2.0, recovery={}))
    memory: ResilientMemory = cascade_of(
        scenario, scenario.flight_model(), scenario.start_state()
    ).memory
    return memory
