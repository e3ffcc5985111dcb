"""`springback campaign`, `query`, `summary`, `refly`: as a newcomer meets them, and killed."""

from __future__ import annotations

import csv
import json
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from builders.interrupts import heed_interrupts
from springback.campaign.access import Campaign
from springback.interfaces.cli.app import main

ROOT = Path(__file__).parents[3]
ROWS = "FROM flights ORDER BY flight"
THROWS = """
name = "throws"
seed = 5
robots = ["arq", "quad"]
method = "latin-hypercube"
samples = 150

[scenario]
vehicle = "arq"
thrust = "hover"
start = { position = ["0.6 m", 0, "1 m"], velocity = [2.0, 0, 0] }
simulation = { duration = 0.3 }
[[scenario.world.obstacles]]
type = "wall"
distance = "1 m"
surface = "wall"
[[scenario.world.obstacles]]
type = "ground"
surface = "wall"

[[vary]]
field = "start.velocity.0"
name = "speed"
from = "1 m/s"
to = "3 m/s"

[[vary]]
field = "surface"
values = ["wall", "mat"]
"""
SMALL = ("--chunk", "6", "--workers", "2", "--quiet")


def command(*words: str) -> list[str]:
    return [sys.executable, "-m", "springback", *words]


class Said(NamedTuple):
    """What a command left."""

    returncode: int
    stdout: str
    stderr: str


Here = Callable[..., Said]


@pytest.fixture
def here(place: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Here:
    """Commands in this process, in the folder of the plan."""
    monkeypatch.chdir(place)

    def said(*words: str) -> Said:
        monkeypatch.setattr(sys, "argv", ["springback", *words])
        code: Any = 0
        capsys.readouterr()
        try:
            main()
        except SystemExit as done:
            code = done.code
        return Said(int(code or 0), *capsys.readouterr())

    return said


def run(*words: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        command(*words), cwd=cwd, capture_output=True, text=True, timeout=300, check=False
    )


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a plan, and its campaign flown in one go, in ``whole``."""
    folder = tmp_path_factory.mktemp("place")
    (folder / "plan.toml").write_text(THROWS)
    done = run("campaign", "plan.toml", "--out", "whole", "--workers", "1", cwd=folder)
    assert done.returncode == 0, done.stderr
    assert "300 of 300 flights (100.0 %)" in done.stderr
    assert "springback summary whole" in done.stderr
    return folder


def started(*words: str, cwd: Path) -> subprocess.Popen[str]:
    """A running campaign, of low priority so that it is not done before the test looks at it."""
    return subprocess.Popen(
        ["nice", "-n", "19", *command(*words)], cwd=cwd, stdout=subprocess.PIPE,
        stderr=subprocess.PIPE, text=True, start_new_session=True, preexec_fn=heed_interrupts,
    )  # fmt: skip


def parts(folder: Path) -> int:
    path = folder / "manifest.jsonl"
    return path.read_bytes().count(b"\n") if path.exists() else 0


def wait_for(reached: Any, process: subprocess.Popen[str]) -> None:
    end = time.monotonic() + 200.0
    while not reached():
        assert process.poll() is None, process.stderr and process.stderr.read()
        assert time.monotonic() < end
        time.sleep(0.002)


def workers_of(pid: int) -> list[int]:
    """Processes that are workers of a campaign, by what the system says."""
    found = []
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            if int(path.read_text().rpartition(")")[2].split()[1]) == pid:
                found.append(int(path.parent.name))
        except OSError:
            continue
    return found


def alive(pid: int) -> bool:
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def test_killed_three_times_and_resumed_the_rows_are_those_of_one_go(place: Path) -> None:
    chance = random.Random(1)
    words = ("campaign", "plan.toml", "--out", "killed", *SMALL, "--resume")
    children: list[int] = []
    for _ in range(3):
        process = started(*words, cwd=place)
        target = parts(place / "killed") + chance.randint(1, 8)
        wait_for(lambda target=target: parts(place / "killed") >= target, process)
        time.sleep(chance.random() * 0.03)
        children += workers_of(process.pid)
        process.kill()
        process.communicate()
    killed = Campaign(place / "killed")
    assert 0 < killed.done < 300
    done = run(*words, cwd=place)
    assert done.returncode == 0, done.stderr
    assert Campaign(place / "killed").query(ROWS) == Campaign(place / "whole").query(ROWS)
    names = [path.name for path in (place / "killed/parts").iterdir()]
    assert len(names) == 50
    assert not [name for name in names if "draft" in name]
    assert not [pid for pid in children if alive(pid)], "workers outlive their parent"


def test_ctrl_c_leaves_a_campaign_to_go_on_with(place: Path) -> None:
    words = ("campaign", "plan.toml", "--out", "broken off", *SMALL)
    process = started(*words, cwd=place)
    wait_for(lambda: parts(place / "broken off") >= 2, process)
    os.killpg(process.pid, signal.SIGSTOP)  # not done before the next one asks
    second = run(*words, "--resume", cwd=place)
    assert second.returncode == 2
    assert f"in use by process {process.pid} on " in second.stderr
    begun = time.monotonic()
    os.killpg(process.pid, signal.SIGINT)  # as a terminal does: parent and workers
    os.killpg(process.pid, signal.SIGCONT)
    _, said = process.communicate(timeout=60)
    assert time.monotonic() - begun < 20.0
    assert process.returncode == 130, said
    assert "Traceback" not in said
    kept = Campaign(place / "broken off").done
    told = re.fullmatch(
        r"interrupted; (\d+) of 300 flights are saved; resume with: springback campaign plan\.toml "
        r"--out 'broken off' --chunk 6 --workers 2 --quiet --resume",
        said.splitlines()[-1],
    )
    assert told is not None, said
    assert kept - 12 <= int(told[1]) <= kept  # a part of each worker may have come meanwhile
    assert 12 <= kept < 300
    again = run(*words, cwd=place)
    assert (again.returncode, Campaign(place / "broken off").done) == (2, kept)
    assert "--resume" in again.stderr
    done = run("campaign", "--out", "broken off", "--resume", "--json", "--quiet", cwd=place)
    told = json.loads(done.stdout)
    assert told["flights"] == sum(row["flights"] for row in told["outcomes"]) == 300
    assert Campaign(place / "broken off").query(ROWS) == Campaign(place / "whole").query(ROWS)


def test_questions_and_answers(place: Path, here: Here) -> None:
    sql = "SELECT robot, count(*) AS n, avg(success) AS won FROM flights GROUP BY robot ORDER BY 1"
    shown = here("query", "whole", sql)
    assert shown.stdout.splitlines()[0].split() == ["robot", "n", "won"]
    rows = json.loads(here("query", "whole", sql, "--format", "json").stdout)
    assert [row["n"] for row in rows] == [150, 150]
    marked = here("query", "whole", sql, "--format", "markdown").stdout.splitlines()
    assert marked[:2] == ["| robot | n | won |", "| --- | --- | --- |"]
    listed = here("query", "whole").stdout
    assert "varied by the plan" in listed
    assert "largest |dv/dt| of the main body" in listed
    assert re.search(r"^nose_up +rad ", listed, re.M)  # summary and `fly` print degrees

    done = here("query", "whole", "FROM flights WHERE NOT success", "--out", "a.csv")
    assert done.returncode == 0, done.stderr
    with (place / "a.csv").open(newline="") as file:
        failures = list(csv.DictReader(file))
    assert f"{len(failures)} rows" in done.stderr
    assert {row["outcome"] for row in failures} <= {"hit_ground", "arm_bottomed"}
    assert here("query", "whole", sql, "--out", "a.csv").returncode == 2
    assert here("query", "whole", sql, "--out", "a.parquet").returncode == 0
    import duckdb

    assert len(duckdb.execute("FROM read_parquet(?)", [str(place / "a.parquet")]).fetchall()) == 2


def test_a_summary_with_its_page(place: Path, here: Here) -> None:
    done = here("summary", "whole", "--out", "page")
    assert done.returncode == 0, done.stderr
    assert "arq less quad, over 150 pairs with the same noise" in done.stdout
    names = {path.name for path in (place / "page").iterdir()}
    assert names == {
        "summary.json", "summary.html", "marginals.png", "marginals.pdf", "marginals.csv",
        "map-speed-surface.png", "map-speed-surface.pdf", "map-speed-surface.csv",
    }  # fmt: skip
    shown = here("summary", "whole", "--measure", "impact_arm_stroke")
    assert "impact_arm_stroke [mm]: first impact: largest compression of an arm" in shown.stdout
    assert "share of the variance of impact_arm_stroke that a field alone explains" in shown.stdout
    told = json.loads((place / "page/summary.json").read_text())
    assert [robot["flights"] for robot in told["robots"]] == [150, 150]
    assert [one["field"] for one in told["marginals"]] == ["speed", "surface"]
    page = (place / "page/summary.html").read_text()
    assert "throws" in page
    assert "A reproduction" not in page
    wrong = here("summary", "whole", "--map", "speed,sped", "--out", "other")
    assert (wrong.returncode, (place / "other").exists()) == (2, False)


def test_a_row_flown_again(place: Path, here: Here) -> None:
    done = here("refly", "whole", "17", "--out", "alone")
    assert done.returncode == 0, done.stderr
    assert "identical to row 17: every number, to the last bit" in done.stderr
    assert (place / "alone/trajectory.parquet").exists()
    told = json.loads(here("refly", "whole", "17", "--json", "--quiet").stdout)
    assert told["identical"] is True
    assert told["outcome"]


def test_a_row_replayed(place: Path, here: Here) -> None:
    done = here("view", "whole", "17", "16", "--export", "two.html")
    assert done.returncode == 0, done.stderr
    for row in (16, 17):
        assert f"identical to row {row}: every number, to the last bit" in done.stderr
    assert (place / "two.html").stat().st_size > 100_000
    (place / "whole/alone").mkdir()
    for words, said in (
        (("whole",), "holds a campaign of flights 0 to 299; name one: springback view whole "),
        (("whole", "300"), "flight 300: must be from 0 to 299"),
        (("whole", "1", "--twin"), "--twin: needs a single SCENARIO.toml"),
        (("whole/alone",), "whole/alone/summary.json: is missing"),
    ):
        refused = here("view", *words, "--export", "no.html")
        assert refused.returncode == 2, refused.stderr
        [line] = refused.stderr.strip().splitlines()
        assert said in line
    (place / "whole/kept").mkdir()
    (place / "whole/kept/flight-0000000012.json").write_text("{}")
    for inside in ("whole/kept", "whole/kept/flight-0000000012.json"):
        line = here("view", inside).stderr
        assert "holds the kept flights 12; replay one: springback view whole 12" in line


def test_limits_conditions_and_levels_are_summed_up(place: Path, here: Here) -> None:
    limit = "impact_peak_acceleration < 300 m/s^2"
    words = ("--by", "speed", "--limit", limit, "--limit", "not hit_ground")
    done = here("summary", "whole", *words, "--where", "robot = arq", "--json")
    assert done.returncode == 0, done.stderr
    told = json.loads(done.stdout)
    assert told["where"] == ["robot = arq"]
    [worst] = told["worst_cases"]
    assert list(worst["robots"]) == ["arq"]
    for cell in worst["robots"]["arq"]["cells"]:
        assert (cell["worst"][0] < 300.0) == (cell["keep"][0] == cell["flights"])
    assert [one["field"] for one in told["by"]] == ["surface"]
    text = here("summary", "whole", *words, "--where", "speed < 1.2 m/s").stdout
    assert f"keeps {limit} and not hit_ground in every flight" in text
    assert "only flights with: speed < 1.2 m/s" in text
    assert "by surface" in text
    pairs = here("summary", "whole", "--by", "speed,surface", "--limit", limit)
    assert "The worst case is over all repeats" in pairs.stdout, pairs.stderr


def test_a_dry_run_leaves_nothing(place: Path, here: Here) -> None:
    before = sorted(place.iterdir())
    done = here("campaign", "plan.toml", "samples=1000000", "--dry-run")
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("2000000 flights: 1000000 samples of 2 dimensions")
    assert "flights/s on one core, measured on 64 flights just flown" in done.stdout
    assert sorted(place.iterdir()) == before


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("campaign", "plan.toml"), "--out is missing"),
        (("campaign", "--out", "new"), "PLAN is missing"),
        (("campaign", "--out", "new", "--resume"), "new: there is no such folder"),
        (("campaign", "paln.toml", "--out", "new"), "paln.toml: cannot be read"),
        (("campaign", "plan.toml", "sampels=3", "--out", "new"), "did you mean samples?"),
        (("campaign", "plan.toml", "samples=-3", "--out", "new"), "override samples=-3"),
        (("campaign", "plan.toml", "--out", "new", "--workers", "0"), "--workers"),
        (("campaign", "plan.toml", "--out", "whole", "seed=6", "--resume"), "its seed is 5, not 6"),
        (("campaign", "plan.toml", "success='touch_sped < 2'", "--out", "new"), "touch_sped"),
        (("query", "new"), "new: there is no such folder"),
        (("query", "whole", "SELECT speeed FROM flights"), 'SQL: Binder Error: .*"speeed"'),
        (
            ("query", "whole", "SELECT offset FROM flights"),
            'SQL: Parser Error: .*double quotes, such as "offset"',
        ),
        (("query", "whole", "SELECT 1", "--out", "x.xlsx"), "must end in"),
        (("summary", "new"), "new: there is no such folder"),
        (("refly", "whole", "300"), "from 0 to 299"),
        (("summary", "whole", "--map", "speed"), "give two fields"),
        (("summary", "whole", "--limit", "arm_strok < 2 mm"), "--limit .*did you mean arm_stroke"),
        (("summary", "whole", "--limit", "recovered", "--by", "sped"), "--by sped: is not varied"),
        (("summary", "whole", "--by", "speed,surface"), "two fields need --limit"),
        (
            ("summary", "whole", "--where", "speed > 9 m/s"),
            "--where speed > 9 m/s: no flight is so",
        ),
        (("summary", "whole", "--share", "0"), "--share: must be above 0 and at most 1"),
        (("summary", "whole", "--share", "0.9"), "--share needs --limit"),
        (("summary", "whole", "--cells", "4"), "--cells needs --out"),
        (("summary", "whole", "--measure", "contact_tim"), "--measure .*did you mean contact_time"),
        (("campaign", "plan.toml", "success=['speed < 2 N']", "--out", "new"), "wrong unit"),
    ],
)
def test_bad_input_is_one_line(words: tuple[str, ...], told: str, place: Path, here: Here) -> None:
    done = here(*words)
    assert done.returncode == 2, done.stderr
    [line] = done.stderr.strip().splitlines()
    assert re.search(rf"^error: .*{told}", line), line
    assert not (place / "new").exists()


def test_the_example_of_the_guide_flies(tmp_path: Path) -> None:
    for name in ("campaign", "collision"):
        shutil.copy(ROOT / f"examples/{name}.toml", tmp_path)
    small = ("samples=2", 'robots=["arq"]', "keep.where='false'", "--workers", "1")
    done = run("campaign", "campaign.toml", *small, "--out", "out", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    campaign = Campaign(tmp_path / "out")
    assert campaign.complete
    assert campaign.units["wall_angle"] == "rad"
    assert set(campaign.design.units) >= {"speed", "pitch", "surface", "stiffness_factor"}
