"""A fit of one impact says what it does: search, round, profiles, flights."""

from __future__ import annotations

import re
from itertools import pairwise
from pathlib import Path

import pytest
from click.testing import CliRunner

from identification.rigs import LOSS, STIFFNESS, problem_of, recorded, rig
from springback.identification.observations.likelihood import ImpactProblem
from springback.identification.solving.fitting import fit_impact
from springback.interfaces.cli.app import cli
from springback.interfaces.output import progress_lines

#: Calls for flights between two words of a fit: those of a round, and of the optimum's derivatives,
#: noise and bounds.
MOST_CALLS = 6
FREE = {STIFFNESS: "factor 4", LOSS: "factor 4"}


def test_a_fit_tells_each_round_of_its_search_and_of_its_profiles(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    told, shares, calls, gaps = list[str](), list[float](), [0], list[int]()
    flown = ImpactProblem._flown

    def counted(self, u):
        calls[0] += 1
        return flown(self, u)

    def tell(doing: str) -> None:
        told.append(doing)
        gaps.append(calls[0])
        calls[0] = 0

    monkeypatch.setattr(ImpactProblem, "_flown", counted)
    tables = rig()
    problem = problem_of(tables, recorded(tables), FREE)
    fit = fit_impact(problem, starts=3, seed=0, progress=shares.append, tell=tell)
    assert max(gaps) <= MOST_CALLS
    assert all(text.startswith(f"{fit.name}: ") for text in told)
    words = [text.removeprefix(f"{fit.name}: ") for text in told]
    assert words[0] == "search from 3 starts, 0 flights so far"
    rounds = re.findall(
        r"search from 3 starts, round (\d+) of 40 at most, (\d) not finished", str(words)
    )
    assert [int(turn) for turn, _ in rounds] == list(range(1, len(rounds) + 1))
    assert rounds[-1][1] == "0"
    assert any(text.startswith("fit of the best start, round 1 of") for text in words)
    profiles = [text for text in words if "profiles found" in text]
    assert profiles[0].startswith("0 of 2 profiles found")
    assert profiles[-1].startswith("2 of 2 profiles found")
    flights = [int(text.split()[-4]) for text in words]
    assert all(before <= after for before, after in pairwise(flights))
    assert 0 < flights[-1] <= fit.problem.flown
    assert all(before <= after for before, after in pairwise(shares))
    assert shares[-1] == 1.0


EXAMPLES = Path(__file__).parents[2] / "examples"


def test_fit_without_a_terminal_has_lines_on_stderr(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(progress_lines, "SILENCE", 0.0)
    monkeypatch.setattr(progress_lines, "LOOK", 0.02)
    words = ["identify", "fit", str(EXAMPLES / "fit.toml"), "starts=1", "--no-figures"]
    done = CliRunner().invoke(cli, [*words, "--out", str(tmp_path / "fitted")])
    assert done.exit_code == 0, done.stderr
    lines = [line for line in done.stderr.splitlines() if line.startswith("fitting: ")]
    for said in (
        r"reading the logs, after \d+ s",
        r"\d+%, .*: search from 1 start, round \d+ of 40 at most, \d not finished, \d+ flights so far",
        r"\d+%, .*: \d of 5 profiles found, round \d of 5 at most",
    ):
        assert any(re.search(rf"^fitting: {said}", line) for line in lines), (said, lines[:5])
    assert not any("flights so far" in line for line in done.stdout.splitlines())
