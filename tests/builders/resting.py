"""The memory of a recovering pilot at rest at home."""

import functools

from springback.recovery.pilot import RecoveryPilotMemory
from springback.scenario.avionics import cascade_of
from springback.scenario.scenario import scenario_from
from springback.studies.run_ups import run_up_scenario


@functools.cache
def resting_memory() -> RecoveryPilotMemory:
    scenario = scenario_from(run_up_scenario("arq", 0.0, 2.0, recovery={}))
    memory: RecoveryPilotMemory = cascade_of(
        scenario, scenario.flight_model(), scenario.start_state()
    ).memory
    return memory
