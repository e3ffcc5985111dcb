"""The commands ``springback examples`` and ``springback new``."""

from __future__ import annotations

import keyword
import re
import shlex
import shutil
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import click

from springback.interfaces.cli.common import (
    PATH,
    Command,
    Output,
    Terminal,
    output_options,
    say,
    terminal_options,
)

if TYPE_CHECKING:
    from springback.interfaces.cli.design.sizes import VehicleAnswer

#: The package, and possible folders of the examples: in the package, or in a checkout.
PACKAGE = Path(__file__).parents[2]
PLACES = (PACKAGE / "examples", PACKAGE.parents[1] / "examples")
#: Suffixes of examples, and of what they name.
SUFFIXES = (".toml", ".py", ".sdf", ".csv")


def examples_folder() -> Path:
    """Folder of the examples.

    Raises:
        InputError: If the installation lacks them.
    """
    from springback.errors import InputError

    source = next((place for place in PLACES if place.is_dir()), None)
    if source is None:
        raise InputError(f"the examples are missing from this installation, in {PLACES[0]}")
    return source


@click.command()
@output_options("Folder to write them to.", "force", "quiet", default=Path("examples"))
def examples(output: Output) -> None:
    """Write the examples of the documentation into a folder.

    \b
    springback examples
    springback fly examples/collision.toml --out collision
    """
    files = sorted(path for path in examples_folder().iterdir() if path.suffix in SUFFIXES)
    with output.folder() as folder:
        for path in files:
            shutil.copy(path, folder)
    output.note_written(files)


# -- files of one's own ---------------------------------------------------------------------------


class TemplateFiles(NamedTuple):
    """Files that ``springback new`` writes for one kind of thing."""

    files: dict[str, str]
    """Suffix of the written file's name, after its stem, and the example that it comes from."""
    next: tuple[str, ...]
    """Commands to type next, with ``{stem}`` of the file's path and its ``{folder}``."""


TEMPLATES = {
    "vehicle": TemplateFiles(
        {".toml": "own_vehicle.toml"},
        (
            "springback check {stem}.toml",
            "springback fly {stem}.toml --out {stem}-flight",
            "springback view {stem}-flight",
            "springback lab {stem}.toml",
            "springback map speed=1:4:4 pitch=-30deg:30deg:3 --robot {stem}.toml --trials 2 "
            "--out {stem}-map",
        ),
    ),
    "pilot": TemplateFiles(
        {".py": "own_pilot.py", ".toml": "own_pilot.toml"},
        (
            "springback check {stem}.py:hover",
            "springback trust {folder}",
            "springback fly {stem}.toml --out {stem}-flight",
            "python {stem}.py",
        ),
    ),
    "obstacle": TemplateFiles(
        {".py": "own_obstacle.py", ".toml": "own_obstacle.toml"},
        (
            "springback check {stem}.py:POLE",
            "springback trust {folder}",
            "springback fly {stem}.toml --out {stem}-flight",
            "python {stem}.py",
        ),
    ),
    "estimator": TemplateFiles(
        {".py": "own_estimator.py", ".toml": "own_estimator.toml"},
        (
            "springback check {stem}.py:blend",
            "springback trust {folder}",
            "springback fly {stem}.toml --out {stem}-flight",
            "python {stem}.py",
        ),
    ),
    "detector": TemplateFiles(
        {".py": "own_detector.py", ".toml": "own_detector.toml"},
        (
            "springback check {stem}.py:jolt",
            "springback trust {folder}",
            "springback fly {stem}.toml --out {stem}-flight",
            "python {stem}.py",
        ),
    ),
    "campaign": TemplateFiles(
        {".toml": "own_campaign.toml", "_vehicle.toml": "own_vehicle.toml"},
        (
            "springback check {stem}.toml",
            "springback campaign {stem}.toml --dry-run",
            "springback campaign {stem}.toml --out {stem}-results",
            "springback summary {stem}-results --out {stem}-page --by stiffness,damping "
            '--limit "impact_peak_acceleration < 200 m/s^2" --limit "not arm_bottomed"',
        ),
    ),
}
"""What ``springback new`` knows, by kind."""


#: Questions about a vehicle, in their order, and the help of their options.
ABOUT_A_VEHICLE = {
    "mass": "Mass of the vehicle, ready to fly: 600g.",
    "arms": "Number of arms, each with a propeller: 4, 6, 8, 10 or 12.",
    "propeller": "Diameter of a propeller: 5in.",
    "guard": "Radius of the guard around each propeller: 70mm; or none.",
    "spring": 'How far an arm gives way at a wall: "25mm at 2m/s"; or none.',
    "span": "Distance between opposite propellers, axis to axis: 300mm.",
}
#: Wrong answers to a question after which no more are asked (chosen).
MOST_WRONG = 3


def _vehicle_options(command: Command) -> Command:
    """An option for each question."""
    for name, text in reversed(ABOUT_A_VEHICLE.items()):
        command = click.option(f"--{name}", metavar="TEXT", help=text)(command)
    return command


@click.command()
@click.argument("kind", type=click.Choice(list(TEMPLATES)))
@click.argument("name", required=False)
@click.option("--compiled", is_flag=True, help="Write a pilot that is compiled.")
@_vehicle_options
@click.option("--template", is_flag=True, help="Write a vehicle with every key; ask nothing.")
@click.option("--out", type=PATH, metavar="FILE", help="File to write; by default NAME.")
@terminal_options("force", "quiet")
def new(
    kind: str, name: str | None, compiled: bool, template: bool, out: Path | None, force: bool,
    terminal: Terminal, **answers: str | None,
) -> None:  # fmt: skip
    """Write a commented, working file to start from: a vehicle, a pilot, ...

    \b
    vehicle    a scenario with a [vehicle]. At a terminal, or with any of the options --mass to
               --span, the vehicle follows from your answers, and comments say what was given, what
               is derived from it and what is chosen; otherwise, or with --template, it has four
               compliant arms and every key, with its unit, its range and how to find its value
    pilot      a pilot in plain Python, or a compiled one (--compiled), and a scenario for it
    estimator  an estimator for springback's pilot, and a scenario that hovers on its estimates
    detector   a collision detector for springback's pilot, and a scenario that flies into a wall
    obstacle   a shape in Python, and a scenario that flies into it
    campaign   a plan, here of a design study, and a scenario with a vehicle for it

    \b
    springback new vehicle hexa --mass 600g --arms 6 --propeller 5in
    springback new pilot hover --compiled
    """
    from springback.errors import InputError
    from springback.files import write_atomically

    files = TEMPLATES[kind]
    if compiled and kind != "pilot":
        raise InputError(f"--compiled belongs to a pilot, not to a {kind}")
    given = {key: text for key, text in answers.items() if text is not None}
    if (given or template) and kind != "vehicle":
        raise InputError(f"--{next(iter(given), 'template')} belongs to a vehicle, not to a {kind}")
    if given and template:
        raise InputError(f"--template and --{next(iter(given))}: give only one")
    if name is not None and out is not None:
        raise InputError(f"NAME {name} and --out {out}: give only one")
    suffix = next(iter(files.files))
    path = out or Path(f"{(name or f'own_{kind}').removesuffix(suffix)}{suffix}")
    if path.suffix != suffix:
        raise InputError(f"--out {path}: must end in {suffix}")
    _check_name(path.stem, "--out" if out else "NAME", is_module=suffix == ".py")
    names = {path.with_name(path.stem + end): source for end, source in files.files.items()}
    there = [str(one) for one in names if one.exists() or one.is_symlink()]
    if there and not force:
        raise InputError(f"{there[0]}: already exists; give another name, or --force")
    asks = kind == "vehicle" and not template and is_asking()
    if given or asks:
        written = {path: _vehicle_of_answers(path.stem, given, asks=asks)}
    else:
        written = {
            one: _renamed(source, kind, path.stem, compiled) for one, source in names.items()
        }
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        for one, text in written.items():
            write_atomically(one, text)
    except OSError as error:
        raise InputError(f"{path}: cannot be written ({error.strerror})") from None
    stem, folder = shlex.quote(str(path.with_suffix(""))), shlex.quote(str(path.parent))
    terminal.print(
        {"files": [str(one) for one in written]}, f"written: {', '.join(map(str, written))}"
    )
    terminal.note(
        "next:\n" + "\n".join(f"  {line.format(stem=stem, folder=folder)}" for line in files.next)
    )


def is_asking() -> bool:
    """True at a terminal, where questions can be answered."""
    streams = (sys.stdin, sys.stderr)
    return all(stream is not None and stream.isatty() for stream in streams)


def _vehicle_of_answers(name: str, given: Mapping[str, str], *, asks: bool) -> str:
    """Text of a scenario with a vehicle of some answers; what is not given is asked or usual."""
    from springback.errors import InputError
    from springback.interfaces.cli.design.answers import QUESTIONS, answer_to
    from springback.interfaces.cli.design.sizes import sizes_of
    from springback.interfaces.cli.design.vehicle_text import vehicle_text
    from springback.scenario.scenario import scenario_from
    from springback.scenario.source_text import toml_tables

    known: dict[str, VehicleAnswer] = {}
    if asks and len(given) < len(QUESTIONS):
        say("Give numbers with a unit; Enter takes the answer in brackets.")
    for key in QUESTIONS:
        if key in given or not asks:
            known[key] = answer_to(key, given.get(key), known)
        else:
            known[key] = _asked(key, known)
    text = vehicle_text(name, known, sizes_of(known))
    try:
        scenario_from(toml_tables(text, name))
    except InputError as error:
        raise InputError(f"these answers do not fit together: {error.problems[0]}") from None
    return text


def _asked(key: str, known: dict[str, VehicleAnswer]) -> VehicleAnswer:
    """Answer to a question at a terminal; a wrong one is asked for again."""
    from springback.errors import InputError
    from springback.interfaces.cli.design.answers import QUESTIONS, answer_to

    usual = answer_to(key, None, known)
    for wrong in range(1, MOST_WRONG + 1):
        said = click.prompt(QUESTIONS[key].text, default=usual.text, err=True)
        try:
            return usual if said == usual.text else answer_to(key, said, known)
        except InputError as error:
            if wrong == MOST_WRONG:
                raise
            say(error.problems[0])
    raise AssertionError


def _renamed(example: str, kind: str, name: str, compiled: bool) -> str:
    """Text of an example under another name."""
    source = "own_pilot_compiled.py" if compiled and example == "own_pilot.py" else example
    text = (examples_folder() / source).read_text(encoding="utf-8")
    beside = f"{name}_vehicle" if kind == "campaign" else name
    text = text.replace("own_vehicle", beside).replace('"own vehicle"', f'"{beside}"')
    return re.sub(rf"own_{kind}(_compiled)?|(?<=\")own {kind}(?=\")", name, text)


def _check_name(name: str, word: str, *, is_module: bool) -> None:
    """Reject a name that is hard to type or, of a module, that hides one of Python's."""
    from springback.errors import InputError

    if not re.fullmatch(r"[A-Za-z_][A-Za-z0-9_-]*", name):
        raise InputError(
            f"{word} {name!r}: must be letters, digits, - and _, and not begin with a digit"
        )
    if is_module and not name.isidentifier():
        raise InputError(f"{word} {name!r}: must be a Python name, without -")
    if is_module and (keyword.iskeyword(name) or name in {*sys.stdlib_module_names, "springback"}):
        raise InputError(f"{word} {name!r}: is a name of Python's own, or springback; give another")
