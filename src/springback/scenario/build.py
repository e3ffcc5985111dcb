"""Build a flight from a scenario, which is checked while it is built."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import NamedTuple

from springback.contact.parameters import Own
from springback.dynamics.motion import rates
from springback.kernels.memo import Build, plain_build
from springback.scenario.avionics import BuiltAvionics, CompiledPilot, build_avionics, cascade_of
from springback.scenario.checks import (
    blaming_the_clock,
    check_clock,
    check_start,
    check_tables,
    check_without_pilot,
)
from springback.scenario.model import flight_model, hover_thrusts, start_state
from springback.scenario.tables import ScenarioTables
from springback.settings import problem
from springback.simulation.onboard import Relay
from springback.simulation.record import Model
from springback.vehicle.state import State

#: In place of a compiled pilot: one in plain Python commands the rotors from outside.
PLAIN_PYTHON = "plain Python"


class ReadyFlight(NamedTuple):
    """A built flight; without a pilot it has no avionics."""

    seed: int
    model: Model
    start: State
    built_avionics: BuiltAvionics | None


def build_flight(
    scenario: ScenarioTables,
    own: Sequence[Own] = (),
    pilot: CompiledPilot | str | None = None,
    build: Build = plain_build,
    normals: Sequence[float] | None = None,
    advises: bool = True,
) -> ReadyFlight:
    """Check a scenario across its tables, and build its flight.

    Args:
        scenario: Tables validated one by one.
        own: The user's own obstacles besides the scenario's, with their surfaces.
        pilot: Pilot in place of the paper's; `PLAIN_PYTHON` for one that runs outside.
        build: Builder of the parts.
        normals: `normals_at_start` of its seed, if already known.
        advises: Suggest a feasible distance if a run-up cannot be flown; slow.

    Raises:
        The first problem, with its key.
    """
    s = scenario
    check_tables(s, build)
    model, start = build(flight_model, s, own, build), build(start_state, s.start, s.vehicle)
    check_start(s, model, start)
    if own:
        _check_start_beside(model, start)
    if s.reference is None and pilot is None:
        check_without_pilot(s)
        return ReadyFlight(s.seed, model, start, None)
    if pilot is not None and s.model.slider is not None:
        raise problem("cannot be given to a pilot: no pilot flies on a slider", "model.slider")
    check_clock(s)
    if s.reference is None and not any(model.thrust):
        model = model._replace(thrust=build(hover_thrusts, s.vehicle, s.world.gravity))
    with blaming_the_clock(s):
        if pilot == PLAIN_PYTHON:
            pilot = CompiledPilot(Relay(0.0), model.thrust)
        makes = partial(cascade_of, advises=advises)
        flown_by = pilot if isinstance(pilot, CompiledPilot) else makes
        avionics = build_avionics(s, model, start, flown_by, normals, build)
    return ReadyFlight(s.seed, model, start, avionics)


def _check_start_beside(model: Model, start: State) -> None:
    """Reject a start inside an obstacle of the user's own."""
    seen = rates(model, start, 0.0).seen
    gaps = [(f"cage of arm {j}", arm.gap) for j, arm in enumerate(seen.arms, start=1)]
    gaps += [("main body", hull.gap) for hull in seen.hull]
    for part, gap in gaps:
        if gap < 0.0:
            raise problem(f"puts the {part} {-gap:.3g} m inside", "start.position")
