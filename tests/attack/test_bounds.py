"""What a file, a name, a pilot or a flight may be: bounds, each with one line that names it."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from springback import fly
from springback.campaign.design.plan import read_plan
from springback.errors import LONGEST_LINE, InputError, plain, shown_value
from springback.scenario.files import read_scenario
from springback.scenario.source_text import MOST_BYTES
from springback.scenario.user.pilots import read_pilot, wrong
from springback.simulation import trajectory

GOOD = 'vehicle = "arq"\nthrust = "hover"\n'


def said(path: Path, *words: str) -> str:
    with pytest.raises(InputError) as caught:
        read_scenario(path, words)
    line = str(caught.value)
    assert "\n" not in line
    return line


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("vehicle = 1" + "0" * 5000, "is not TOML: Exceeds the limit"),
        ("x = " + "[" * 5000 + "]" * 5000, "more than 32 deep"),
        (".".join(["a"] * 5000) + " = 1", "more than 32 deep"),
        (GOOD + "[start]\nposition = " + "[" * 40 + "]" * 40, "more than 32 deep"),
        (GOOD + f'name = "{"x" * 5000}"', "at most 200 characters (got 5000)"),
        (GOOD + 'name = "\\u001b[31mred"', "printable"),
        (GOOD + 'name = "\\u202eevil"', "printable"),
        (GOOD + '"\\u001b[31m" = 3', "unknown key"),
        (
            "world = { obstacles = [" + '{ type = "ground", surface = "mat" },' * 65 + "] }",
            "at most 64",
        ),
    ],
)
def test_files(tmp_path: Path, text: str, expected: str) -> None:
    """Of thousands of digits, levels and letters, and with escape sequences."""
    path = tmp_path / "scenario.toml"
    path.write_text(GOOD + text if "vehicle" not in text else text)
    line = said(path)
    assert expected in line
    assert line.isprintable()
    assert len(line) <= LONGEST_LINE


def test_the_mark_before_a_text_is_read_over(tmp_path: Path) -> None:
    """As editors on Windows write it."""
    path = tmp_path / "scenario.toml"
    path.write_bytes(b"\xef\xbb\xbf" + GOOD.encode())
    assert read_scenario(path).vehicle.name == "arq"


def test_what_is_no_file_of_text(tmp_path: Path) -> None:
    """A device without end, a pipe without a writer, gigabytes, a name of 300 letters."""
    assert "not a regular file" in said(Path("/dev/zero"))
    pipe = tmp_path / "pipe.toml"
    os.mkfifo(pipe)
    assert "not a regular file" in said(pipe)
    assert said(pipe).count(str(pipe)) == 1
    large = tmp_path / "large.toml"
    with large.open("wb") as file:
        file.truncate(MOST_BYTES + 1)
    assert "too large, 8 MB" in said(large)
    assert said(large).count(str(large)) == 1
    assert "cannot be read" in said(tmp_path / ("x" * 300))
    assert "cannot be read" in said(Path("a\0b"))


@pytest.mark.parametrize(
    "word",
    [
        ".".join(["a"] * 3000) + "=1",
        "start.position=" + "[" * 3000,
        "vehicle.body.mass=1" + "0" * 5000,
        "start.position.²=1",
        "start.position.99999999999999999999=1",
        "name=\udcff\udcfe",
        "name=\x1b[31mred",
        "x" * 5000,
        "x" * 5000 + "=1",
        "vehicle=" + "x" * 5000,
        'name="a"\nvehicle="quad"\nname="b',
    ],
)
def test_overrides(tmp_path: Path, word: str) -> None:
    path = tmp_path / "scenario.toml"
    path.write_text(GOOD)
    line = said(path, word)
    assert line.isprintable()
    line.encode()
    assert len(line) <= LONGEST_LINE


@pytest.mark.parametrize(
    "text", ["[1, 2]", "5", '"x"', "[" * 100_000, "{", '{"a": 1' + "0" * 5000 + "}"]
)
def test_plans_in_json(tmp_path: Path, text: str) -> None:
    path = tmp_path / "plan.json"
    path.write_text(text)
    with pytest.raises(InputError, match=r"plan\.json(:1)?: "):
        read_plan(path)


# -- pilots ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("import sys\nsys.exit(0)\n", "leaves the program"),
        ("raise SystemExit\n", "leaves the program"),
        ("import collections\nthing = collections.Counter()\n", "has no 'fly'"),
        ("import numpy\nthing = numpy.float64(3.0)\ndef mine(t, m, s): ...\n", "there are: mine"),
        ("class A:\n    def __call__(self): ...\nthing = A()\n", "has no 'fly'"),
    ],
)
def test_files_of_pilots(tmp_path: Path, text: str, word: str) -> None:
    """A script without a guard ended the program with 0, and nothing was flown."""
    path = tmp_path / "pilot.py"
    path.write_text(text)
    with pytest.raises(InputError) as caught:
        read_pilot(f"{path}:fly")
    assert word in str(caught.value)


class Odd:
    def __repr__(self) -> str:
        raise ValueError("no words")


@pytest.mark.parametrize(
    "thrusts",
    [
        {1.0: 1, 2.0: 2, 3.0: 3, 4.0: 4},
        {1.0, 2.0, 3.0, 4.0},
        "1234",
        ["1", "2", "3", "4"],
        [True, False, True, False],
        (x for x in (1.0, 2.0, 3.0, 4.0)),
        [10**400] * 4,
        3.0,
        None,
        Odd(),
    ],
)
def test_commands_that_are_no_list_of_numbers(thrusts: Any) -> None:
    """Keys of a dict were flown as thrusts, as were texts, truths and what can be read only once."""
    assert "numbers in N" in wrong((thrusts, None), 4)
    assert wrong(([1.0, 2.0, 3, 4.0], None), 4) == ""


def test_a_pilot_that_leaves_in_flight_is_told(tmp_path: Path) -> None:
    def leaving(time: float, measurement: Any, memory: Any) -> Any:
        raise SystemExit(0)

    with pytest.raises(InputError, match=r"test_bounds\.py:\d+: SystemExit: 0, at 0 s"):
        fly({"vehicle": "quad", "simulation": {"duration": 0.01}}, pilot=leaving, executor="python")


# -- flights --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("tables", "expected"),
    [
        ({"duration": 1e9}, "simulation.duration: must be at most 1e+04 s with impact_step"),
        (
            {"duration": 10.0, "impact_step": 1e-8},
            "simulation.impact_step: must be at least 1e-07 s",
        ),
        ({"duration": 2000.0}, "a trajectory has at most 1000000 instants"),
    ],
)
def test_time_and_memory_are_foreseen(tables: dict[str, float], expected: str) -> None:
    """The field at fault is named, at once."""
    with pytest.raises(InputError) as caught:
        fly({"vehicle": "arq", "thrust": "hover", "simulation": tables}, executor="python")
    assert expected in str(caught.value)


def test_ticks_are_foreseen() -> None:
    """Of clock and duration the one that was given."""
    piloted = {"vehicle": "arq", "reference": {"type": "hold"}}
    for tables, field in (
        ({"simulation": {"duration": 6000.0}}, "simulation.duration"),
        ({"clock": 1e8}, "clock"),
    ):
        with pytest.raises(InputError, match=rf"^{field}: must be at most"):
            fly(piloted | tables)


def test_trajectories_end_before_memory_does(monkeypatch: pytest.MonkeyPatch) -> None:
    """What could not be foreseen is noticed on the way; without a trajectory it is flown."""
    monkeypatch.setattr(trajectory, "MOST_INSTANTS", 30)
    scenario = {
        "vehicle": "quad",
        "world": {"obstacles": [{"type": "wall", "distance": 2.5, "surface": "wall"}]},
        "start": {"position": [2.245, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0]},
        "simulation": {"duration": 0.02},
    }
    with pytest.raises(InputError, match=r"keep fewer of them with simulation\.record_interval"):
        fly(scenario, executor="python")
    assert fly(scenario, executor="python", trajectory=False).success


# -- words ----------------------------------------------------------------------------------------


def test_messages_do_nothing_to_a_terminal() -> None:
    """Escapes, marks of direction, halves of characters and newlines are written out."""
    told = InputError("a\x1b[31mb\u202ec\ud800d\ne", "x" * 10_000)
    assert told.problems[0] == "a\\x1b[31mb\\u202ec\\ud800d\\ne"
    assert len(told.problems[1]) == LONGEST_LINE
    assert plain("Hunt–Crossley, 5 µs, °") == "Hunt–Crossley, 5 µs, °"


class Deep(NamedTuple):
    inner: Any


def test_any_value_is_shown_shortly() -> None:
    nest: Any = []
    for _ in range(100_000):
        nest = [nest]
    for value in (10**5000, "x" * 5000, nest, list(range(10_000)), Deep(10**5000), None, 3.5):
        assert len(shown_value(value)) < 120
    while nest:  # taken apart by hand: so deep a list cannot be thrown away at once everywhere
        nest = nest[0]
