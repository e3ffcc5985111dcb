"""Does any test notice?  Flip one sign of the physics at a time and see which tests fail.

A quarter of an hour on two cores; `make test` tries a sample of them (tests/test_mutations.py)::

    make mutations                        # all
    make mutations MUTATIONS=damper       # those whose name has "damper"
    make mutations MUTATIONS=--flights    # all tests of the files named
    make mutations MUTATIONS=--first      # no more once one has noticed

Each mutation is made in a copy of the package in a temporary folder; the repository is not touched.
The tests that run are those named beside it in mutated_lines.py, most of which look at single states in plain Python,
so nothing is compiled.  Tests that fail without any mutation are not counted.  The exit status is
the number of mutations that no test noticed.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

if not __package__:  # as a program
    sys.path.insert(0, str(Path(__file__).parents[1]))
from oracles.mutated_lines import MUTATED_LINES, Mutation
from oracles.mutations_of_bent_arms import MUTATIONS_OF_BENT_ARMS
from oracles.mutations_of_rotors import MUTATIONS_OF_ROTORS

MUTATIONS = (*MUTATED_LINES, *MUTATIONS_OF_ROTORS, *MUTATIONS_OF_BENT_ARMS)
ROOT = Path(__file__).parents[2]
#: Tests that take longer have noticed: a flight does not end [s].
PATIENCE = 600.0
#: Mutations tried at a time.
WORKERS = int(os.environ.get("WORKERS", os.cpu_count() or 1))


def failures(source: Path, tests: tuple[str, str], first: bool) -> set[str]:
    """Names of those of some tests, or of the first, that fail with the package in ``source``."""
    command = [sys.executable, "-m", "pytest", "-q", "--tb=no", "-rfE", "-p", "no:cacheprovider"]
    command += [*(str(ROOT / "tests" / place) for place in tests[0].split()), "-k", tests[1]]
    command += ["-x"] if first else []
    paths = os.pathsep.join([str(source), str(ROOT / "tests")])
    environment = {**os.environ, "PYTHONPATH": paths, "PYTHONDONTWRITEBYTECODE": "1"}
    environment["SPRINGBACK_CACHE_DIR"] = str(source / "cache")
    try:
        done = subprocess.run(
            command, cwd=ROOT, env=environment, capture_output=True, text=True, timeout=PATIENCE
        )
    except subprocess.TimeoutExpired:
        return {"no end"}
    failed = set(re.findall(r"^(?:FAILED|ERROR) \S*?(test_\w+\.py(?:::\S+)?)", done.stdout, re.M))
    if done.returncode != 0 and not failed:
        raise RuntimeError(done.stdout[-2000:] + done.stderr[-2000:])
    return failed


def mutated(
    package: Path, mutation: Mutation | None, tests: tuple[str, str], first: bool
) -> set[str]:
    """Names of those of some tests, or of the first, that fail with one mutation, or with none."""
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "springback"
        shutil.copytree(package, copy)
        if mutation is not None:
            path = copy / mutation.path
            text = path.read_text(encoding="utf-8").replace(mutation.old, mutation.new)
            path.write_text(text, encoding="utf-8")
        return failures(Path(folder), tests, first)


def outdated(package: Path) -> list[str]:
    """Mutations whose text does not occur exactly once, or whose result is not Python."""
    complaints = []
    for mutation in MUTATIONS:
        text = (package / mutation.path).read_text(encoding="utf-8")
        if text.count(mutation.old) != 1:
            complaints.append(f"{mutation.name}: {text.count(mutation.old)} places")
        compile(text.replace(mutation.old, mutation.new), mutation.path, "exec")
    return complaints


def noticed(failed: set[str]) -> str:
    """Failed tests in words: each with the number of its cases."""
    counts = Counter(name.split("::")[-1].split("[")[0] for name in failed)
    return ", ".join(f"{name} ({count})" for name, count in sorted(counts.items()))


def main(arguments: list[str]) -> int:
    """Try the mutations whose name has one of the arguments in it; all without arguments."""
    flights = "--flights" in arguments
    wanted = [a for a in arguments if not a.startswith("--")]
    chosen = [m for m in MUTATIONS if not wanted or any(w in m.name for w in wanted)]
    unnoticed = 0

    def tests_of(mutation: Mutation) -> tuple[str, str]:
        """All there are in its folders with ``--flights``."""
        return (mutation.tests[0], "") if flights else mutation.tests

    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(WORKERS) as pool:
        package = Path(folder) / "springback"
        hidden = shutil.ignore_patterns("__pycache__")
        shutil.copytree(ROOT / "src" / "springback", package, ignore=hidden)
        if complaints := outdated(package):
            print("The source has changed; mend these mutations:", *complaints, sep="\n  ")
            return len(complaints)
        kinds = list(dict.fromkeys(map(tests_of, chosen)))
        before = dict(
            zip(kinds, pool.map(lambda k: mutated(package, None, k, False), kinds), strict=True)
        )
        for tests in kinds:
            print(
                "without mutation,",
                tests[0] + ":",
                noticed(before[tests]) or "all pass",
                flush=True,
            )
        # Where a test fails anyhow, the first to fail says nothing.
        first = "--first" in arguments and not any(before.values())
        tried = pool.map(lambda m: mutated(package, m, tests_of(m), first), chosen)
        for mutation, failed in zip(chosen, tried, strict=True):
            found = failed - before[tests_of(mutation)]
            print(f"{mutation.name:46s}", noticed(found) or "NOBODY", flush=True)
            unnoticed += not found
    print(f"{len(chosen) - unnoticed} of {len(chosen)} noticed")
    return unnoticed


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
