"""The commands ``springback show``, ``springback doctor`` and ``springback world``."""

from __future__ import annotations

import math
import sys
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from springback.interfaces.cli.common import PATH, Terminal, as_lines, say, terminal_options
from springback.interfaces.cli.completion import complete_preset

if TYPE_CHECKING:
    from springback.scenario.worlds.imported import Imported, NamedObstacle


@click.command()
@click.argument("preset", required=False, shell_complete=complete_preset())
@click.option(
    "--keys",
    is_flag=True,
    help="Show the keys of a scenario instead, or of a table such as start or world.obstacles.",
)
@terminal_options("as_json")
def show(preset: str | None, keys: bool, terminal: Terminal) -> None:
    """Show a vehicle, surface, estimator or material PRESET with its sources; or all of them.

    With --keys, PRESET is a table of a scenario: unit, range, default and meaning of each key.

    \b
    springback show arq
    springback show --keys reference
    springback show --keys hulls.ring
    """
    from springback.contact.library import SOURCES, SURFACES
    from springback.scenario.scenario import preset as known_preset
    from springback.scenario.vehicles.hover_rest import hover_warnings
    from springback.sensing.library import ESTIMATORS
    from springback.sensing.library import SOURCES as ESTIMATOR_SOURCES
    from springback.vehicle.endurance import GRAVITY
    from springback.vehicle.library import VEHICLES
    from springback.vehicle.materials import MATERIALS, MaterialRange

    if keys:
        _show_keys(preset or "", terminal)
        return
    if preset is None:
        names = {name: entry.summary for name, entry in VEHICLES.items()}
        names |= {
            name: f"surface, {entry.law}, friction {entry.friction_axes}"
            for name, entry in SURFACES.items()
        }
        names |= {name: f"estimator, {entry.type}" for name, entry in ESTIMATORS.items()}
        names |= {name: f"material, {entry.summary}" for name, entry in MATERIALS.items()}
        terminal.print(names, "\n".join(f"{name:<12} {text}" for name, text in names.items()))
        return
    known = {**VEHICLES, **SURFACES, **ESTIMATORS, **MATERIALS}
    entry = known_preset("vehicle, surface, estimator or material", preset, known)
    if preset in MATERIALS:
        ranges = {
            ("young [Pa]" if name == "young" else name): {
                "low": value.low,
                "typical": value.typical,
                "high": value.high,
                "tag": value.tag,
                "source": value.source,
            }
            if isinstance(value, MaterialRange)
            else value
            for name, value in entry._asdict().items()
            if value is not None
        }
        terminal.print(ranges, as_lines(ranges))
        return
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
    if preset in VEHICLES:
        for sentence in hover_warnings(entry.vehicle, GRAVITY):
            say(f"warning: {sentence}")


def _show_keys(path: str, terminal: Terminal) -> None:
    """Print the tables that may be at a path of a scenario, and where there are others."""
    from springback.interfaces.reports.table_keys import (
        key_tables,
        table_paths,
        table_text,
        whole_path,
    )

    found = key_tables(path)
    below = table_paths(whole_path(path))
    data = {
        "tables": [
            one._asdict() | {"keys": [line._asdict() for line in one.keys]} for one in found
        ],
        "below": below,
    }
    parts = [table_text(one) for one in found]
    if below:
        lines = [f"  springback show --keys {one}" for one in below]
        parts.append("\n".join(["tables below, each with its keys:", *lines]))
    terminal.print(data, "\n\n".join(parts))


@click.command()
@click.option(
    "--compile",
    "compiles",
    is_flag=True,
    help="Compile ahead of time the kernels that scenario files need, or flights of vehicles among "
    "shapes; with neither, those of the common kinds of flight.",
)
@click.argument("flights", nargs=-1, metavar="[FILE|VEHICLE]...")
@terminal_options("as_json", "quiet")
def doctor(compiles: bool, flights: tuple[str, ...], terminal: Terminal) -> None:
    """Check this installation: versions, extras, compiler, agreement of the executors."""
    from springback.interfaces.output.diagnosis import diagnosis

    if flights and not compiles:
        raise click.UsageError("FILE and VEHICLE are compiled with --compile")
    if compiles:
        _compile(flights, terminal)
        return
    with terminal.spinner("compiling and checking"):
        found = diagnosis()
    terminal.print(found, as_lines(found))
    if not found["compiled_equals_python"]:
        say("compiled flights differ from plain Python: please report this")
        sys.exit(1)


def _compile(flights: tuple[str, ...], terminal: Terminal) -> None:
    """Compile the kernels of scenario files and of vehicles, or of the common kinds of flight."""
    from springback.campaign.common_flights import COMMON, compile_ahead, flights_of
    from springback.campaign.compiler_times import TYPICAL
    from springback.errors import InputError
    from springback.kernels.compiler import cache_folder
    from springback.problems import nearest_name
    from springback.results.flight import as_scenario
    from springback.vehicle.library import VEHICLES

    named: dict[str, Any] = {}
    for word in flights:
        if Path(word).exists() or Path(word).suffix:
            named[word] = as_scenario(Path(word)).model_dump(exclude_unset=True)
        elif word in VEHICLES:
            named |= flights_of(word)
        else:
            near = nearest_name(word, VEHICLES)
            hint = f"did you mean {near}?" if near else f"vehicles: {', '.join(VEHICLES)}"
            raise InputError(f"{word}: is neither a file nor a vehicle of the library; {hint}")
    chosen = named or COMMON
    terminal.note(
        f"compiling {len(chosen)} kinds of flight, each alone and in campaigns, unless they are in "
        f"the cache: about {TYPICAL[False]:.0f} s of processor time each"
    )
    times: dict[str, float] = {}
    for done in compile_ahead(chosen):
        times[done.name] = round(done.seconds, 1)
        if done.seconds > 0.0:
            terminal.note(f"{done.name}: {done.seconds:.0f} s ({len(times)} of {2 * len(chosen)})")
    data = {"folder": str(cache_folder()), "seconds": times}
    new = sum(1 for seconds in times.values() if seconds > 0.0)
    kept = "" if new == len(times) else f", {len(times) - new} of them already compiled before"
    terminal.print(data, f"kernels of {len(times)} kinds of flight are in {cache_folder()}{kept}")


# -- worlds of other programs ---------------------------------------------------------------------

#: Keys of obstacles that are shown, in this order.
SHOWN = (
    "position", "start", "end", "normal", "axis", "height", "size", "radius", "roll", "pitch",
    "yaw", "file", "scale",
)  # fmt: skip

_OPTIONS = (
    click.argument("file", type=PATH),
    click.option("--search", multiple=True, type=PATH,
                 help="Further folder to search for what FILE includes; may be repeated."),
    click.option("--surface", default="wall", show_default=True,
                 help="Preset of the surface of all elements."),
    click.option("--surface-of", "surfaces", multiple=True, metavar="PATTERN=PRESET",
                 help="Surface of elements whose names match, such as 'shelf*=mat'."),
    click.option("--bounds", is_flag=True, help="Turn the bounds of RotorPy's worlds into walls."),
)  # fmt: skip


def _world_options(command: Callable[..., None]) -> Callable[..., None]:
    for option in reversed(_OPTIONS):
        command = option(command)
    return command


@click.group()
def world() -> None:
    """Worlds of other programs: show what is in a file, or write it as obstacles in TOML.

    FILE is a world or model in SDF (Gazebo), MJCF (MuJoCo) or URDF, a world of RotorPy (.json), an
    OctoMap (.bt, .ot), a mesh, a height map or an occupancy grid. A scenario imports it with an
    obstacle of type import.
    """


@world.command("show")
@_world_options
@terminal_options("as_json", "quiet")
def show_world(
    file: Path, search: tuple[Path, ...], surface: str, surfaces: tuple[str, ...], bounds: bool,
    terminal: Terminal,
) -> None:  # fmt: skip
    """Show what is in FILE: each element, what it becomes, and what cannot be represented.

    \b
    springback world show warehouse.sdf
    springback world show iris.world --search ../models
    """
    from springback.scenario.worlds.imported import listing_only
    from springback.scenario.worlds.mesh_check import size_words

    with listing_only(), terminal.spinner("reading the world"):
        found = _read(file, search, surface, surfaces, bounds)
        parts = found.parts
        data = {
            "elements": [_element(part) for part in parts],
            "not_represented": found.unrepresented,
            "remarks": found.remarks,
            "ignored": found.ignored,
        }
        lines, said = _lines(found), _summary(found)
        large = {part.name: size_words(part.obstacle) for part in parts}
    terminal.print(data, "\n".join(lines))
    for name, words in large.items():
        if words:
            say(f"warning: {name} is a mesh{words}")
    terminal.note(said)


def _element(part: NamedObstacle) -> dict[str, Any]:
    """An element as plain data: its own name, its obstacle, and how large its mesh is [m]."""
    table = part.obstacle.model_dump(mode="json", exclude_none=True)
    extent = _extent(part.obstacle)
    return {**table, "name": part.name, **({"extent": extent} if extent else {})}


def _extent(obstacle: Any) -> list[float]:
    """Lengths of a mesh along its own axes [m]; empty for other obstacles."""
    return list(obstacle.extent()) if obstacle.type == "mesh" else []


@world.command()
@_world_options
@click.option("--out", type=PATH, required=True, help="File of obstacles in TOML to write.")
@click.option("--missing", type=click.Choice(["warn", "refuse"]), default="warn",
              show_default=True, help="What to do if something cannot be represented.")  # fmt: skip
@terminal_options("force", "quiet")
def convert(
    file: Path, search: tuple[Path, ...], surface: str, surfaces: tuple[str, ...], bounds: bool,
    out: Path, missing: str, force: bool, terminal: Terminal,
) -> None:  # fmt: skip
    """Write FILE as obstacles of a scenario in TOML, each with its name as a comment.

    An OctoMap can also be written as an occupancy grid: give --out a file that ends in .npz.

    \b
    springback world convert warehouse.sdf --out obstacles.toml --surface-of 'shelf*=mat'
    springback world convert lab.bt --out lab.npz
    """
    from springback.errors import InputError
    from springback.files import write_atomically
    from springback.scenario.worlds.toml_text import world_toml

    if out.exists() and not force:
        raise InputError(f"{out}: exists; give --force to replace it")
    if out.suffix == ".npz":
        _write_cells(file, out)
        terminal.note(f"written to {out}, for an obstacle of type occupancy")
        return
    found = _read(file, search, surface, surfaces, bounds, missing)
    write_atomically(out, world_toml(found, out.absolute().parent))
    for line in found.unrepresented:
        say(f"warning: not represented: {line}")
    for line in found.remarks:
        say(f"represented differently: {line}")
    terminal.note(f"{_summary(found)}; written to {out}")


def _write_cells(file: Path, out: Path) -> None:
    """Write an OctoMap as an occupancy grid."""
    import io

    import numpy as np

    from springback.errors import InputError
    from springback.files import write_atomically
    from springback.scenario.worlds.octomap import occupancy_arrays

    if file.suffix.lower() not in (".bt", ".ot"):
        raise InputError(f"{out}: only an OctoMap (.bt, .ot) becomes an occupancy grid")
    held = io.BytesIO()
    np.savez_compressed(held, **occupancy_arrays(file))
    write_atomically(out, held.getvalue())


def _read(
    file: Path, search: tuple[Path, ...], surface: str, surfaces: tuple[str, ...], bounds: bool,
    missing: str = "warn",
) -> Imported:  # fmt: skip
    from springback.errors import InputError
    from springback.scenario.worlds.toml_text import read_world

    named: dict[str, Any] = {}
    for word in surfaces:
        pattern, sign, preset = word.rpartition("=")
        if not sign or not pattern:
            raise InputError(f"--surface-of {word!r}: must be PATTERN=PRESET, such as 'shelf*=mat'")
        named[pattern] = preset
    return read_world(
        file, surface=surface, surfaces=named, search=search, bounds=bounds, missing=missing
    )


def _lines(found: Imported) -> list[str]:
    """Elements and what is wrong with others, a line each."""
    width = max((len(part.name) for part in found.parts), default=0)
    lines = [
        f"{part.name:<{width}}  {part.obstacle.type:<8}  {_numbers(part)}".rstrip()
        for part in found.parts
    ]
    for title, words in (
        ("not represented:", found.unrepresented),
        ("represented differently:", found.remarks),
    ):
        if words:
            lines += [*([""] if lines else []), title, *(f"  {word}" for word in words)]
    if found.ignored:
        lines += ["", f"nothing can hit: {', '.join(found.ignored)}"]
    return lines


def _numbers(part: NamedObstacle) -> str:
    """Place and sizes of an obstacle in words [m]."""
    words = []
    for key in SHOWN:
        value = getattr(part.obstacle, key, None)
        if value is None or (key in ("roll", "pitch", "yaw") and not value):
            continue
        shown = value if isinstance(value, str) else _number_text(value)
        if key in ("roll", "pitch", "yaw"):
            shown = f"{math.degrees(value):.5g} deg"
        words.append(f"{key} {shown}")
    if extent := _extent(part.obstacle):
        words.append(f"{' x '.join(f'{length:.4g}' for length in extent)} m")
    friction = getattr(getattr(part.obstacle, "surface", None), "friction", None)
    return ", ".join(words + ([] if friction is None else [f"friction {friction:g}"]))


def _number_text(value: Any) -> str:
    if isinstance(value, tuple | list):
        return f"({' '.join(f'{x:.5g}' for x in value)})"
    return f"{value:.5g}"


def _summary(found: Imported) -> str:
    """Counts in a sentence."""
    kinds = Counter(part.obstacle.type for part in found.parts)
    shown = ", ".join(f"{count} {kind}" for kind, count in kinds.items())
    count, missing = len(found.parts), len(found.unrepresented)
    elements = "1 element" if count == 1 else f"{count} elements"
    return f"{elements}{f' ({shown})' if shown else ''}, {missing} not represented"
