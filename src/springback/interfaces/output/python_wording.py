"""Messages of commands, in the words of Python."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager

from springback.errors import InputError

#: Options whose argument in Python has another name, or whose value speaks for itself.
_ARGUMENTS = {"out ": "", "export ": "", "force": "force=True", "from": "begin", "to": "end"}


@contextmanager
def python_words() -> Iterator[None]:
    """Name arguments, not options of a command, in the problems of a block."""
    try:
        yield
    except InputError as error:
        raise InputError(_in_python(str(error))) from None


def _in_python(message: str) -> str:
    options = re.compile(r"(?<![\w-])--(out |export |[a-z]+\b)")
    return options.sub(lambda option: _ARGUMENTS.get(option[1], option[1]), message)
