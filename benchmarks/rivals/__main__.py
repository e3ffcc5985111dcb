"""springback beside what users would pick instead, side by side in one run."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

from benchmarks.rivals.environments import RECIPES, VARIABLE, folder
from benchmarks.rivals.figure import contest_figure
from benchmarks.rivals.report import machine, markdown, summarised
from benchmarks.rivals.rounds import Settings, contest
from springback.interfaces.figures.style import save


def _source(text: str) -> tuple[str, str]:
    name, _, where = text.partition("=")
    if name not in RECIPES or not RECIPES[name].bare or not where:
        able = ", ".join(key for key, recipe in RECIPES.items() if recipe.bare)
        raise argparse.ArgumentTypeError(f"must be NAME=PLACE with NAME one of {able}")
    return name, where


def _positive(text: str) -> int:
    if not text.isdigit() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"must be a whole number of at least 1 (got {text})")
    return int(text)


def main() -> None:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.rivals",
        description=__doc__,
        epilog=f"Rivals are installed into {folder()}; {VARIABLE} names another folder.",
    )
    parser.add_argument("--rounds", type=_positive, default=5, help="default 5")
    parser.add_argument("--threads", type=_positive, default=2, help="cores to use, default 2")
    parser.add_argument(
        "--only", nargs="+", default=[], metavar="NAME", help="parts of names of contenders"
    )
    parser.add_argument("--quick", action="store_true", help="tiny, to see that all works")
    parser.add_argument(
        "--source", type=_source, action="append", default=[], metavar="NAME=PLACE",
        help="install a rival from here, as pip takes it (gym-pybullet-drones has no package)",
    )  # fmt: skip
    parser.add_argument("--out", type=Path, default=Path("rivals"), help="folder, default rivals")
    given = parser.parse_args()
    settings = Settings(
        1 if given.quick else given.rounds, given.threads, tuple(given.only), given.quick,
        tuple(given.source),
    )  # fmt: skip
    described = machine(given.threads)
    found = contest(settings, lambda text: print(text, file=sys.stderr, flush=True))
    report = {"machine": described, **summarised(found)}
    given.out.mkdir(parents=True, exist_ok=True)
    (given.out / "rivals.json").write_text(json.dumps(report, indent=2) + "\n")
    (given.out / "rivals.md").write_text(markdown(report))
    if report["contenders"]:
        save(contest_figure(report), given.out / "rivals")
    print(markdown(report))


if __name__ == "__main__":
    main()
