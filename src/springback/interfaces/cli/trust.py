"""The command ``springback trust``."""

from __future__ import annotations

from pathlib import Path

import click

from springback.interfaces.cli.common import Terminal, terminal_options


@click.command()
@click.argument("folder", type=click.Path(path_type=Path), required=False)
@click.option("--remove", is_flag=True, help="Trust FOLDER no longer.")
@terminal_options("as_json", "quiet")
def trust(folder: Path | None, remove: bool, terminal: Terminal) -> None:
    """Let scenarios run Python code in FOLDER and below; without FOLDER, list the trusted ones.

    A scenario or plan that names a pilot or an obstacle of your own (FILE.py:NAME) runs that file
    with all your rights. It does so only in folders that you trust: those in this list, and those
    in the environment variable SPRINGBACK_TRUST.

    \b
    springback trust .
    springback trust --remove .
    """
    from springback.errors import InputError
    from springback.scenario.trust import trust as trust_folder
    from springback.scenario.trust import trusted_folders

    if folder is None and remove:
        raise InputError("FOLDER is missing: the folder to trust no longer")
    if folder is not None:
        trust_folder(folder, ends=remove)
    names = [str(one) for one in trusted_folders()]
    terminal.print(names, "\n".join(names) or "no folder is trusted")
