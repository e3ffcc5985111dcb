"""Attack for as long as one likes: ``make fuzz``, or ``python -m attack.fuzz --cases 100000``.

Each round of 1000 inputs of a kind has a seed of its own, which is printed with what was found, so
that the round can be run again: ``python -m attack.fuzz --seed 17 --kind plans --cases 1000``.
What is found goes into the lists of ``test_fuzz.py`` by hand, together with its cure.
"""

from __future__ import annotations

import argparse
import itertools
import os
import sys
import time
import traceback
import warnings
from collections import Counter
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from typing import Any, NamedTuple

from hypothesis import HealthCheck, given, seed, settings

from attack import inputs, logs, stored, worlds

KINDS: dict[str, tuple[Any, Callable[..., Any]]] = {
    "scenarios": (inputs.scenarios(), inputs.scenario_tables),
    "files": (inputs.texts(), inputs.scenario_text),
    "overrides": (
        inputs.override_words(),
        lambda words: inputs.scenario_tables(inputs.SCENARIOS[0], words),
    ),
    "plans": (inputs.plans(), inputs.plan_tables),
    "results": (stored.results(), stored.result_files),
    "ledgers": (stored.ledgers(), stored.campaign_files),
    "parts": (stored.parts(), stored.campaign_files),
    "worlds": (worlds.worlds(), worlds.world_file),
    "logs": (logs.logs(), logs.log_file),
}
ROUND = 1000


class Round(NamedTuple):
    """Result of a round."""

    found: str  # empty if nothing was
    tally: Counter[str]


def attack(kind: str, number: int, cases: int) -> Round:
    """One round, in any process."""
    warnings.simplefilter("error")
    strategy, check = KINDS[kind]
    tally = Counter[str]()

    @seed(number)
    @settings(
        max_examples=cases, deadline=None, database=None, derandomize=False,
        suppress_health_check=list(HealthCheck), print_blob=False,
    )  # fmt: skip
    @given(strategy)
    def each(given_input: Any) -> None:
        tally["accepted" if inputs.timed(check, given_input) else "refused"] += 1

    try:
        each()
    except Exception as error:
        each_found = error.exceptions if isinstance(error, ExceptionGroup) else (error,)
        said = [f"{kind}, seed {number}:\n"]
        for one in each_found:
            notes = "\n".join(getattr(one, "__notes__", []))
            said.append("".join(traceback.format_exception(one)[-6:]) + notes + "\n")
        return Round("".join(said), tally)
    return Round("", tally)


def main() -> int:
    """The number of rounds that found something is the exit status, 1 at most."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cases", type=int, default=100_000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kind", choices=KINDS, action="append")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    asked = parser.parse_args()
    begun, tally, found = time.monotonic(), Counter[str](), 0
    kinds = itertools.cycle(asked.kind or KINDS)
    starts = range(0, asked.cases, ROUND)
    with ProcessPoolExecutor(asked.jobs) as pool:
        rounds = pool.map(
            attack,
            [next(kinds) for _ in starts],
            [asked.seed + k for k in range(len(starts))],
            [min(ROUND, asked.cases - first) for first in starts],
        )
        for one in rounds:
            tally += one.tally
            if one.found:
                found += 1
                print(one.found, file=sys.stderr)
    took = time.monotonic() - begun
    rate = 3600.0 * tally.total() / took
    print(f"{dict(tally)} in {took:.0f} s, {rate:.3g} an hour; {found} rounds found something")
    return min(found, 1)


if __name__ == "__main__":
    sys.exit(main())
