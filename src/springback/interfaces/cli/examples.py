"""The command ``springback examples``."""

from __future__ import annotations

import shutil
from pathlib import Path

import click

from springback.interfaces.cli.common import OUT, force_option, note, quiet_option

#: The package, and the checkout that it may be installed from as it stands.
PACKAGE = Path(__file__).parents[2]
PLACES = (PACKAGE / "examples", PACKAGE.parents[1] / "examples")


@click.command()
@click.option(
    "--out", type=OUT, default=Path("examples"), show_default=True, help="Folder to write them to."
)
@force_option
@quiet_option
def examples(out: Path, force: bool, quiet: bool) -> None:
    """Write the examples that the documentation refers to into a folder.

    \b
    springback examples
    springback fly examples/collision.toml --out collision
    """
    from springback.errors import InputError
    from springback.interfaces.output.folders import output_folder

    source = next((place for place in PLACES if place.is_dir()), None)
    if source is None:
        raise InputError(f"the examples are missing from this installation, in {PLACES[0]}")
    files = sorted(path for path in source.iterdir() if path.suffix in (".toml", ".py"))
    with output_folder(out, force=force) as folder:
        for path in files:
            shutil.copy(path, folder)
    note(f"written to {out}: {', '.join(path.name for path in files)}", quiet)
