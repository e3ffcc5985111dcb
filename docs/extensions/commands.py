"""`.. commands::`: every command with its arguments, options and examples, from click itself."""

import inspect
import re
from collections.abc import Iterator
from typing import Any

import click
from docstrings import escaped
from docutils import nodes
from docutils.parsers.rst import Directive
from docutils.statemachine import StringList
from sphinx.application import Sphinx

from springback.interfaces.cli.app import cli


def paragraphs(text: str) -> Iterator[str]:
    """Lines of a help text; a block that click prints as it is stays as it is."""
    for block in inspect.cleandoc(text).split("\n\n"):
        if block.startswith("\b"):
            yield from ("::", "", *(f"   {line}" for line in block.splitlines()[1:]), "")
        else:
            yield re.sub(r"(?<!\S)--[\w-]+", r"``\g<0>``", escaped(" ".join(block.split())))
            yield ""


def defaults(option: click.Option, context: click.Context) -> str:
    """What holds where an option is not given."""
    extra = option.get_help_extra(context)
    parts = [extra[key] for key in ("default", "range") if extra.get(key)]
    return ", ".join([*parts, *(["needed"] if option.required else [])])


def commands_of(
    group: click.Group, outer: click.Context, before: str = ""
) -> Iterator[tuple[str, click.Command, click.Context]]:
    """Commands in the order of the alphabet, those of a group after it: name, command, context."""
    for name, command in sorted(group.commands.items()):
        context = click.Context(command, parent=outer, info_name=name)
        yield before + name, command, context
        if isinstance(command, click.Group):
            yield from commands_of(command, context, f"{before}{name} ")


def command_lines(name: str, command: click.Command, context: click.Context) -> list[str]:
    """Lines of a command's section below its title."""
    usage = " ".join(command.collect_usage_pieces(context))
    lines = ["::", "", f"   springback {name} {usage}", "", *paragraphs(command.help or "")]
    lines += [".. list-table::", "   :header-rows: 1", "   :widths: 38 47 15", ""]
    lines += ["   * - option", "     - meaning", "     - default"]
    for option in command.get_params(context):
        record = option.get_help_record(context)
        if isinstance(option, click.Option) and record and option.name != "help":
            words = escaped(" ".join((option.help or "").split()))
            lines += [f"   * - ``{record[0]}``", f"     - {words}"]
            lines += [f"     - {escaped(defaults(option, context))}"]
    return [*lines, ""]


class Commands(Directive):
    """A section for each command, in the order of the alphabet."""

    def run(self) -> list[nodes.Node]:
        """The sections."""
        made: list[nodes.Node] = []
        outer = click.Context(cli, info_name="springback")
        for name, command, context in commands_of(cli, outer):
            section = nodes.section(ids=[name.replace(" ", "-")], names=[name])
            section += nodes.title("", "", nodes.literal("", f"springback {name}"))
            lines = StringList(command_lines(name, command, context))
            self.state.nested_parse(lines, 0, section)
            self.state.document.note_explicit_target(section)
            made.append(section)
        return made


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the directive."""
    app.add_directive("commands", Commands)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
