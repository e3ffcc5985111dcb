"""The command ``springback examples``."""

from __future__ import annotations

import shutil
from pathlib import Path

import click

from springback.interfaces.cli.common import Output, output_options

#: The package, and possible folders of the examples: in the package, or in a checkout.
PACKAGE = Path(__file__).parents[2]
PLACES = (PACKAGE / "examples", PACKAGE.parents[1] / "examples")


@click.command()
@output_options("Folder to write them to.", "force", "quiet", default=Path("examples"))
def examples(output: Output) -> None:
    """Write the examples of the documentation into a folder.

    \b
    springback examples
    springback fly examples/collision.toml --out collision
    """
    from springback.errors import InputError

    source = next((place for place in PLACES if place.is_dir()), None)
    if source is None:
        raise InputError(f"the examples are missing from this installation, in {PLACES[0]}")
    files = sorted(path for path in source.iterdir() if path.suffix in (".toml", ".py"))
    with output.folder() as folder:
        for path in files:
            shutil.copy(path, folder)
    output.note_written(files)
