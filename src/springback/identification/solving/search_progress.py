"""How far the fit of an impact is: the share that is done, and what it does, in words."""

from __future__ import annotations

from collections.abc import Callable

from springback.progress import Progress, silent

Tell = Callable[[str], None]
"""Function called with what a task is doing, in words."""
Watch = Callable[[int, int], None]
"""Function called after each round of a solver, with its number and the problems still open."""
#: Shares of a fit at which the search, and the fit of its best point, end (chosen: the rest are the
#: profiles).
SEARCHED, POLISHED = 0.5, 0.6


def ignore_words(doing: str) -> None:
    """Ignore what is being done."""


def ignore_round(turn: int, left: int) -> None:
    """Ignore a round."""


class SearchProgress:
    """Progress of a fit, whose share never falls."""

    def __init__(
        self,
        name: str,
        flown: Callable[[], int],
        *,
        progress: Progress = silent,
        tell: Tell = ignore_words,
    ) -> None:
        """Begin a fit.

        Args:
            name: Of the impact.
            flown: Number of flights so far.
            progress: Called with the share done.
            tell: Called with what is being done.
        """
        self.name, self.flown, self.progress, self.tell = name, flown, progress, tell
        self.share = 0.0

    def say(self, doing: str, share: float) -> None:
        """Say what is being done, and how far the fit is."""
        self.share = max(self.share, share)
        self.tell(f"{self.name}: {doing}, {self.flown()} flights so far")
        self.progress(self.share)

    def searching(self, starts: int, most: int, before: int = 0) -> Watch:
        """Watch of the search from some starts.

        Args:
            starts: Number of them.
            most: Most rounds.
            before: Number of starts all of which ended far from the data.
        """
        further = "further " if before else ""
        of = f"search from {starts} {further}start{'s' if starts > 1 else ''}"
        self.say(of, 0.0)

        def watch(turn: int, left: int) -> None:
            done = max(1.0 - left / starts, turn / most)
            self.say(f"{of}, round {turn} of {most} at most, {left} not finished", SEARCHED * done)

        return watch

    def polishing(self, most: int) -> Watch:
        """Watch of the fit of the best point.

        Args:
            most: Most rounds.
        """
        self.say("fit of the best start", SEARCHED)

        def watch(turn: int, left: int) -> None:
            share = SEARCHED + (POLISHED - SEARCHED) * turn / most
            self.say(f"fit of the best start, round {turn} of {most} at most", share)

        return watch

    def profiling(self, fields: int, most: int, again: int = 0) -> ProfileWatch:
        """Watch of the profiles.

        Args:
            fields: Number of them.
            most: Most rounds.
            again: Times that a better optimum was found on the way.
        """
        after = f", after a better optimum ({again})" if again else ""
        of = f"of {fields} profile{'s' if fields > 1 else ''}"
        self.say(f"0 {of} found{after}", POLISHED)

        def watch(turn: int, found: int, step: int) -> None:
            done = max(found / fields, (turn - 1) / most)
            at = f", step {step}" if step else ""
            self.say(
                f"{found} {of} found, round {turn} of {most} at most{at}{after}",
                POLISHED + (1.0 - POLISHED) * done,
            )

        return watch


ProfileWatch = Callable[[int, int, int], None]
"""Function called within profiles: the round, the profiles that are found, and the step in the
round, 0 at its end."""


def ignore_profile_step(turn: int, found: int, step: int) -> None:
    """Ignore a step of profiles."""
