"""The commands ``springback show`` and ``springback doctor``."""

from __future__ import annotations

import sys
from typing import Any

import click

from springback.interfaces.cli.common import (
    as_lines,
    json_option,
    note,
    print_result,
    quiet_option,
    spinner,
)


@click.command()
@click.argument("preset", required=False)
@json_option
def show(preset: str | None, as_json: bool) -> None:
    """Show a vehicle, surface or estimator PRESET, each number with its source; or all presets."""
    from springback.contact.library import SOURCES, SURFACES
    from springback.scenario.scenario import preset as known_preset
    from springback.sensing.library import ESTIMATORS
    from springback.sensing.library import SOURCES as ESTIMATOR_SOURCES
    from springback.vehicle.library import VEHICLES

    if preset is None:
        names = {name: entry.summary for name, entry in VEHICLES.items()}
        names |= {
            name: f"surface, {entry.law}, friction {entry.friction_axes}"
            for name, entry in SURFACES.items()
        }
        names |= {name: f"estimator, {entry.type}" for name, entry in ESTIMATORS.items()}
        print_result(
            names if as_json else "\n".join(f"{name:<12} {text}" for name, text in names.items()),
            as_json,
        )
        return
    known = {**VEHICLES, **SURFACES, **ESTIMATORS}
    entry = known_preset("vehicle, surface or estimator", preset, known)
    extra: dict[str, Any] = {}
    if preset in VEHICLES:
        settings, sources, summary = entry.vehicle, entry.sources, entry.summary
        extra = {"mass": entry.vehicle.mass, "inertia": entry.vehicle.inertia().tolist()}
    elif preset in ESTIMATORS:
        settings, sources, summary = entry, ESTIMATOR_SOURCES[preset], f"estimator {preset}"
    else:
        settings, sources, summary = entry, SOURCES[preset], f"surface {preset}"
        extra = {"dissipation": entry.dissipation_value()}
    data = {
        "summary": summary,
        "settings": settings.model_dump(),
        "sources": sources,
        "derived": extra,
    }
    print_result(data if as_json else as_lines(data), as_json)


@click.command()
@json_option
@quiet_option
def doctor(as_json: bool, quiet: bool) -> None:
    """Check this installation: versions, extras, compiler, agreement of the executors."""
    from springback.interfaces.cli.diagnosis import diagnosis

    with spinner("compiling and checking", quiet):
        found = diagnosis()
    print_result(found if as_json else as_lines(found), as_json)
    if not found["compiled_equals_python"]:
        note("compiled flights differ from plain Python: please report this", False)
        sys.exit(1)
