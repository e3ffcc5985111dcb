"""The program ``springback``: the command line, and its message when it is interrupted.

Loaded before anything that takes time, so that Ctrl-C is handled from the start: this module and
the package import nothing that Python has not loaded already.
"""

from __future__ import annotations

import os
import sys

#: Exceptions that ended the program. They hold what was in use when they came: if that were freed,
#: a library might unload what its threads still run.
_ENDED: list[BaseException] = []


def run() -> None:
    """Run the command line and exit without finalisation.

    All files are closed by then; unloading all modules would take longer than most flights.
    """
    code: object = 1
    try:
        from springback.interfaces.output import interrupts

        try:
            interrupts.install_handler()
            from springback.interfaces.cli.app import main

            main()
            code = 0
        except SystemExit as done:
            _ENDED.append(done)
            code = done.code
        except BaseException as error:
            _ENDED.append(error)
            if not interrupts.is_interrupted():
                raise
            interrupts.ignore()
            _last(interrupts.message())
            code = 130
    except KeyboardInterrupt as again:  # while loading, or while handling another one
        _ENDED.append(again)
        _last("interrupted; nothing was written")
        code = 130
    except BaseException:
        import traceback

        traceback.print_exc()
    for stream in (sys.stdout, sys.stderr):
        try:
            if stream is not None:
                stream.flush()
        except BrokenPipeError:  # the reader has ended, too
            code = code or 1
        except (OSError, ValueError) as error:
            if stream is sys.stdout and not code:  # else an error was reported
                _last(f"error: stdout: {getattr(error, 'strerror', None) or error}")
            code = code or 1
    os._exit(code if isinstance(code, int) else 0 if code is None else 1)


def _last(words: str) -> None:
    """Write a line to stderr if that is still possible."""
    try:
        sys.stderr.write(words + "\n")
        sys.stderr.flush()
    except (OSError, ValueError, AttributeError):
        return
