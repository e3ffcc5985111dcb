"""The commands ``springback show`` and ``springback doctor``."""

from __future__ import annotations

import sys
from typing import Any

import click

from springback.interfaces.cli.common import Terminal, as_lines, say, terminal_options
from springback.interfaces.cli.completion import complete_preset


@click.command()
@click.argument("preset", required=False, shell_complete=complete_preset())
@terminal_options("as_json")
def show(preset: str | None, terminal: Terminal) -> None:
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
        terminal.print(names, "\n".join(f"{name:<12} {text}" for name, text in names.items()))
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
    terminal.print(data, as_lines(data))


@click.command()
@terminal_options("as_json", "quiet")
def doctor(terminal: Terminal) -> None:
    """Check this installation: versions, extras, compiler, agreement of the executors."""
    from springback.interfaces.cli.diagnosis import diagnosis

    with terminal.spinner("compiling and checking"):
        found = diagnosis()
    terminal.print(found, as_lines(found))
    if not found["compiled_equals_python"]:
        say("compiled flights differ from plain Python: please report this")
        sys.exit(1)
