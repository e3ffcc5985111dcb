"""The command line: all commands, and handling of errors.

Results go to stdout, everything else to stderr; with ``--json`` errors go to both.  Exit codes: 0
done, 1 the run failed, 2 invalid input, 130 interrupted.  Heavy modules are imported by the
commands that need them.
"""

from __future__ import annotations

import errno
import gc
import json
import sys
from collections.abc import Sequence
from typing import NoReturn

import click

from springback.errors import InputError, warn_in_one_line
from springback.interfaces.cli.animate import animate
from springback.interfaces.cli.campaign import campaign, query, refly, summary
from springback.interfaces.cli.check import check, trust
from springback.interfaces.cli.common import say
from springback.interfaces.cli.envelope import map_command
from springback.interfaces.cli.examples import examples, new
from springback.interfaces.cli.fly import fly
from springback.interfaces.cli.identify.fitting import check as check_intervals
from springback.interfaces.cli.identify.fitting import fit, plan_tests
from springback.interfaces.cli.identify.logs import identify
from springback.interfaces.cli.lab import lab
from springback.interfaces.cli.reproduce import reproduce
from springback.interfaces.cli.show import doctor, show, world
from springback.interfaces.cli.study import study
from springback.interfaces.cli.view import view
from springback.interfaces.output import interrupts
from springback.version import __version__

FEW_CYCLES = 200_000
"""New objects between two garbage collections: loading modules creates many objects and no garbage,
and with Python's default of 700 collections take a tenth of the time of a short command."""


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="springback")
def cli() -> None:
    """Simulate micro aerial vehicles that survive collisions."""


for command in (
    fly, check, reproduce, show, doctor, campaign, query, refly, summary, examples, new,
    animate, lab, map_command, study, trust, view, world, identify,
):  # fmt: skip
    cli.add_command(command)
for command in (fit, check_intervals, plan_tests):
    identify.add_command(command)


def main() -> None:
    """Run the command line and exit with its code."""
    gc.set_threshold(FEW_CYCLES)
    warn_in_one_line()
    try:
        cli.main(standalone_mode=False)
    except InputError as error:
        _refuse(error.problems)
    except click.Abort as error:
        # click raises this for Ctrl-C, and also for an unexpected end of input
        if isinstance(error.__cause__, EOFError):
            raise error.__cause__ from None
        _interrupted()
    except KeyboardInterrupt:
        _interrupted()
    except click.ClickException as error:
        if type(error).__name__ == "NoArgsIsHelpError":  # no word was given: all are listed
            error.show()
            sys.exit(2)
        _refuse([" ".join(error.format_message().split()) + _where_to_look(error)])
    except Exception as error:
        if interrupts.is_interrupted():  # and any error it caused in a library
            _interrupted()
        said = environment(error)
        if said is None:
            raise
        say(f"error: {said}")
        sys.exit(1)


def _where_to_look(error: click.ClickException) -> str:
    """Command that tells what a misused one takes; empty if that is known, or wanted as JSON."""
    context = error.ctx if isinstance(error, click.UsageError) else None
    if context is None or "id you mean" in error.format_message() or _wants_json():
        return ""
    return f" See {context.command_path} --help"


def _wants_json() -> bool:
    """True if the results were wanted as JSON, so that errors are, too."""
    words = sys.argv[1:]
    return "--json" in (words[: words.index("--")] if "--" in words else words)


def _refuse(problems: Sequence[str]) -> NoReturn:
    """Exit for invalid input, with a line for each problem; as JSON on stdout, too, if wanted."""
    if _wants_json():
        from springback.interfaces.output.json_problems import problem_data

        click.echo(json.dumps(problem_data(problems), indent=2))
    for line in problems:
        say(f"error: {line}")
    sys.exit(2)


def _interrupted() -> NoReturn:
    interrupts.ignore()
    say(interrupts.message())
    sys.exit(130)


#: Errors of the system, not of the program or the user.
_OF_THE_SYSTEM = {
    getattr(errno, name) for name in
    ("ENOSPC", "EDQUOT", "EIO", "EROFS", "EFBIG", "EACCES", "EPERM", "ENAMETOOLONG", "EMFILE",
     "ENFILE", "ELOOP", "ESTALE", "ENOTDIR", "EISDIR")
    if hasattr(errno, name)
}  # fmt: skip


def environment(error: BaseException) -> str | None:
    """Message about a disk or the memory, in one line; None if the program is at fault."""
    if isinstance(error, OSError) and error.errno in _OF_THE_SYSTEM:
        where = f"{error.filename}: " if error.filename else ""
        return f"{where}{error.strerror}"
    if isinstance(error, MemoryError):
        return f"out of memory ({' '.join(str(error).split()) or 'allocation failed'})"
    if type(error).__name__ in ("IOException", "FatalException"):  # DuckDB's
        return " ".join(str(error).split())[:300]
    return None
