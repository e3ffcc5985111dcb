"""The commands `springback identify ...`."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

from builders.recordings import files, whole
from springback.errors import InputError
from springback.identification.design import coverage, experiments
from springback.identification.design.coverage import Coverage, FieldCoverage
from springback.identification.design.experiments import ChosenExperiment, ExperimentPlan
from springback.identification.unknowns import Unknown
from springback.interfaces.cli.app import cli
from springback.logs.reading import read_recording
from springback.logs.writing.writers import write_recording

AT_REST = Path(__file__).parents[2] / "logs" / "px4_at_rest.ulg"
EXAMPLE = Path(__file__).parents[3] / "examples" / "impact_log.toml"


def said(*words: str) -> str:
    done = CliRunner().invoke(cli, ["identify", *words], catch_exceptions=False)
    assert done.exit_code == 0, done.output
    return done.stdout


def run(*words: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "springback", "identify", *words],
        cwd=cwd, capture_output=True, text=True, check=False,
    )  # fmt: skip


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    shutil.copy(AT_REST, tmp_path / "rest.ulg")
    write_recording(whole(), tmp_path / "hit.ulg")
    return tmp_path


def test_inspect_begins_with_the_answer(folder: Path) -> None:
    shown = said("inspect", str(folder / "rest.ulg"))
    assert shown.startswith("no impact, and this log could not have shown one: ")
    for words in ("204.6 Hz", "161 ms at 20.327 s", "mean over 4.89 ms", "missing for an impact",
                  "pass  sensor_combined.accelerometer: +9.62 m/s^2 along z at rest"):  # fmt: skip
        assert words in shown


def test_inspect_gives_all_of_it_as_json(folder: Path) -> None:
    data = json.loads(said("inspect", str(folder / "hit.ulg"), "--json"))
    assert data["verdict"] == "1 impact"
    force = next(one for one in data["channels"] if one["quantity"] == "specific force")
    assert (force["samples"], force["unit"]) == (4000, "m/s^2")
    assert all(one["passed"] for one in data["findings"])
    [impact] = data["impacts"]
    assert impact["refused"] == ""


def test_segment_shows_the_impacts(folder: Path) -> None:
    shown = said("segment", str(folder / "hit.ulg")).splitlines()
    assert shown[0] == "1 impact"
    assert shown[1].startswith("at 2.00")
    assert "change of velocity [-3.01, +0.42, +0.21] m/s" in shown[1]
    assert "by specific force and " in shown[1]


def test_segment_without_an_impact_exits_with_2_and_the_reason(folder: Path) -> None:
    done = run("segment", "rest.ulg", cwd=folder)
    assert (done.returncode, done.stdout) == (2, "")
    [line] = done.stderr.splitlines()
    assert line.startswith("error: rest.ulg: no impact, and this log could not have shown one: ")
    done = run("segment", "rest.ulg", "--json", cwd=folder)
    assert "could not have shown one" in json.loads(done.stdout)["problems"][0]["message"]


@pytest.mark.parametrize("name", sorted(set(files()) - {"table.csv", "rows.parquet"}))
def test_a_truncated_log_gives_at_most_one_line(folder: Path, name: str) -> None:
    data = files()[name]
    for cut in (1, len(data) // 3, len(data) - 5):
        (folder / name).write_bytes(data[:cut])
        (folder / "table.csv").write_bytes(files()["table.csv"])
        done = CliRunner().invoke(cli, ["identify", "inspect", str(folder / name)])
        assert done.exception is None or isinstance(done.exception, InputError), name
        if isinstance(done.exception, InputError):
            assert all(name in line or "table.csv" in line for line in done.exception.problems)
            assert len(done.exception.problems) == 1 or name == "table.toml"  # two keys missing
            assert done.stdout == ""


def test_logs_of_one_flight_are_compared(folder: Path) -> None:
    write_recording(whole(), folder / "take.csv", "motive")
    shown = said("inspect", str(folder / "hit.ulg"), str(folder / "take.csv"))
    assert "pass  vehicle.attitude and sensor_gyro: rates of turn agree (1.000)" in shown


def test_wrong_axes_are_answered_with_options_that_work(folder: Path) -> None:
    write_recording(whole(), folder / "take.csv", "motive")
    logs = [str(folder / "hit.ulg"), str(folder / "take.csv")]
    wrong = said("inspect", *logs, "--world", "z-up", "--body", "flu")
    assert "FAIL" in wrong
    options = wrong.splitlines()[-1].removeprefix("all findings pass with ").split()
    assert options == ["--world", "y-up", "--body", "y-up"]
    assert "FAIL" not in said("inspect", *logs, *options)


@pytest.mark.parametrize("out", ["flight.mcap", "flight.csv", "other.ulg", "take.tsv"])
def test_convert_writes_what_is_read_back(folder: Path, out: str) -> None:
    CliRunner().invoke(
        cli, ["identify", "convert", str(folder / "hit.ulg"), "--out", str(folder / out)],
        catch_exceptions=False,
    )  # fmt: skip
    path = folder / ("flight.toml" if out.endswith(".csv") else out)
    back = read_recording(path)
    assert len(back.channels) == (2 if out.endswith(".tsv") else 6)


def test_convert_replaces_nothing_without_force(folder: Path) -> None:
    words = ["identify", "convert", str(folder / "hit.ulg"), "--out", str(folder / "flight.csv")]
    (folder / "flight.toml").write_text("mine")
    refused = CliRunner().invoke(cli, words).exception
    assert isinstance(refused, InputError)
    assert "flight.toml: exists; give --force to replace it" in str(refused)
    assert (folder / "flight.toml").read_text() == "mine"
    assert not (folder / "flight.csv").exists()
    assert CliRunner().invoke(cli, [*words, "--force"]).exit_code == 0
    same = [
        "identify",
        "convert",
        str(folder / "hit.ulg"),
        "--out",
        str(folder / "hit.ulg"),
        "--force",
    ]
    assert "is the log itself" in str(CliRunner().invoke(cli, same).exception)


def test_inspect_says_which_samples_were_out_of_order(tmp_path: Path) -> None:
    (tmp_path / "log.csv").write_text("t,x,y,z\n0,0,0,1\n0.02,0,0,1\n0.01,0,0,1\n0.03,0,0,1\n")
    (tmp_path / "log.toml").write_text(
        'file = "log.csv"\naxes = { world = "nwu", body = "flu" }\n[[channels]]\nname = "body"\n'
        'quantity = "position"\ncolumns = ["x", "y", "z"]\nunit = "m"\ntime = "t"\n'
    )
    words = "log.csv: body: 1 sample comes after a later one, by up to 10 ms; sorted by their times"
    assert words in said("inspect", str(tmp_path / "log.toml"))


def test_the_example_shows_its_impact() -> None:
    shown = said("segment", str(EXAMPLE))
    assert shown.startswith("1 impact\nat ")
    assert "FAIL" not in said("inspect", str(EXAMPLE))


def wrong_table(folder: Path, *changes: tuple[str, str]) -> str:
    """A mapping file of a whole flight, with some of its words changed."""
    write_recording(whole(), folder / "mine.csv")
    text = (folder / "mine.toml").read_text()
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    (folder / "mine.toml").write_text(text)
    return str(folder / "mine.toml")


WRONG = {
    "body": (('body = "flu"', 'body = "frd"'), 'world = "nwu" body = "flu"'),
    "world": (('world = "nwu"', 'world = "ned"'), 'world = "nwu" body = "flu"'),
    "order": (('quantity = "attitude"\n', 'quantity = "attitude"\norder = "xyzw"\n'),
              'order = "wxyz" of vehicle.attitude in the mapping file of mine.csv'),
}  # fmt: skip


@pytest.mark.parametrize("mistake", WRONG)
def test_a_log_in_wrong_axes_is_refused_by_segment_and_replay_as_inspect_says(
    folder: Path, mistake: str
) -> None:
    """They went on with exit code 0, and blamed speeds, the start or the obstacle."""
    change, mend = WRONG[mistake]
    log = wrong_table(folder, change)
    shown = said("inspect", log)
    failed = [line.removeprefix("  FAIL  ") for line in shown.splitlines() if "  FAIL  " in line]
    assert f"all findings pass with {shown.splitlines()[-1].split('pass with ')[1]}" in shown
    scenario = str(EXAMPLE.parent / "arq_wall.toml")
    out = str(folder / "replayed")
    for words in (
        ["identify", "segment", log],
        ["fly", scenario, "--against", log, "--out", out],
    ):
        refused = CliRunner().invoke(cli, words).exception
        assert isinstance(refused, InputError)
        assert any(
            refused.problems[0].startswith(f"{folder / 'mine.csv'}: {one}") for one in failed
        )
        assert mend in refused.problems[0]
        assert not Path(out).exists()
    done = CliRunner().invoke(cli, ["identify", "segment", log, "--no-check"])
    assert done.exit_code == 0
    assert "warning: " in done.stderr
    assert failed[0] in done.stderr


def test_times_in_another_unit_are_refused_by_every_command(folder: Path) -> None:
    """The gyroscope or the positions were blamed, whose units were right."""
    log = wrong_table(folder, ("[[channels]]\n", '[[channels]]\ntime_unit = "ms"\n'))
    scenario = str(EXAMPLE.parent / "arq_wall.toml")
    for words in (
        ["identify", "inspect", log],
        ["identify", "segment", log],
        ["fly", scenario, "--against", log, "--out", str(folder / "replayed")],
    ):
        refused = CliRunner().invoke(cli, words).exception
        assert isinstance(refused, InputError)
        assert "mine.csv: accelerometer, gyroscope" in refused.problems[0]
        assert "their times are probably in s, not in ms: " in refused.problems[0]


def test_a_log_that_is_cut_off_is_read_with_a_warning_that_says_where(folder: Path) -> None:
    data = (folder / "hit.ulg").read_bytes()
    place = r"cut\.ulg: the log ends within a message, at byte \d+, \d\.\d{3} s by its clock"
    for share, exits in ((0.9, 0), (0.3, 2)):  # after the impact, and before it
        (folder / "cut.ulg").write_bytes(data[: int(share * len(data)) + 5])
        done = run("inspect", "cut.ulg", cwd=folder)
        assert done.returncode == 0
        assert re.search(rf"^warning: {place}: it was cut off$", done.stderr, re.M)
        found = run("segment", "cut.ulg", cwd=folder)
        assert found.returncode == exits
        assert re.search(place, found.stderr)
    (folder / "cut.ulg").write_bytes(data[:10])
    for command in ("inspect", "segment"):
        done = run(command, "cut.ulg", cwd=folder)
        assert done.returncode == 2
        assert done.stderr == "error: cut.ulg: is cut off after 10 of the 16 bytes of its head\n"


CHECKED = Coverage(
    (FieldCoverage("vehicle.arms.stiffness", 10, 9, 0.6, 0.98, 0.1, 1.0, 0.02, True, "N/m"),),
    10, (), 1, 20.0, {},
)  # fmt: skip


def test_check_writes_its_table_and_replaces_nothing_without_force(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It had no --out, and click proposed --quiet."""
    flown = []

    def stub(*given: object, **more: object) -> Coverage:
        flown.append(given)
        return CHECKED

    monkeypatch.setattr(coverage, "check_coverage", stub)
    plan, out = EXAMPLE.parent / "fit.toml", tmp_path / "checked"
    words = ["identify", "check", str(plan), "--sets", "10", "--out", str(out)]
    done = CliRunner().invoke(cli, words, catch_exceptions=False)
    assert done.exit_code == 0
    assert "vehicle.arms.stiffness: 90.0 % contain the truth" in done.stdout
    assert "written to" in done.stderr
    data = json.loads((out / "check.json").read_text())
    assert (data["sets"], data["alarms"], data["fields"][0]["share"]) == (10, 1, 0.9)
    head, row = (out / "check.csv").read_text().splitlines()
    assert head == "name,sets,covered,low,high,bias,spread,half_width,relative,unit,share"
    assert row == "vehicle.arms.stiffness,10,9,0.6,0.98,0.1,1.0,0.02,True,N/m,0.9"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["checked"]
    assert sorted(path.name for path in out.iterdir()) == ["check.csv", "check.json"]
    refused = CliRunner().invoke(cli, words)
    assert "is not empty; give another folder, or --force" in str(refused.exception)
    assert len(flown) == 1  # before anything is flown
    assert CliRunner().invoke(cli, [*words, "--force"]).exit_code == 0
    assert CliRunner().invoke(cli, words[:5], catch_exceptions=False).exit_code == 0


STIFFNESS = Unknown("vehicle.arms.stiffness", "free", 8.5, 0.5, True, "N/m", "factor 3")
PLANNED = ExperimentPlan(
    (STIFFNESS,), (0.5,), (("1 m/s", (0.1,)), ("3 m/s", (0.04,))),
    (ChosenExperiment("3 m/s", (0.04,), 2.5),), (("9 m/s", "breaks an arm"),),
)  # fmt: skip


def test_plan_writes_its_table_and_replaces_nothing_without_force(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It had no --out, unlike `fit` and `check`."""
    weighed = []

    def stub(*given: object, **more: object) -> ExperimentPlan:
        weighed.append(given)
        return PLANNED

    monkeypatch.setattr(experiments, "plan_experiments", stub)
    for name in ("fit.toml", "arq_wall.toml"):
        shutil.copy(EXAMPLE.parent / name, tmp_path)
    plan, out = tmp_path / "fit.toml", tmp_path / "planned"
    plan.write_text(plan.read_text().replace('logs = ["impact_log.toml"]', ""))
    words = ["identify", "plan", str(plan), "--out", str(out)]
    done = CliRunner().invoke(cli, words, catch_exceptions=False)
    assert done.exit_code == 0
    assert PLANNED.sentence in done.stdout
    assert "written to" in done.stderr
    data = json.loads((out / "plan.json").read_text())
    assert data["fields"] == [STIFFNESS.name]
    assert data["chosen"] == [{"name": "3 m/s", "half_widths": [0.04], "gain": 2.5}]
    head, *rows = (out / "plan.csv").read_text().splitlines()
    assert head == "step,test,field,half_width,relative,unit"
    assert [row.partition(",vehicle.arms.stiffness,")[::2] for row in rows] == [
        ("now,", "0.5,True,N/m"), ("alone,1 m/s", "0.1,True,N/m"),
        ("alone,3 m/s", "0.04,True,N/m"), ("chosen 1,3 m/s", "0.04,True,N/m"),
    ]  # fmt: skip
    assert sorted(path.name for path in out.iterdir()) == ["plan.csv", "plan.json"]
    refused = CliRunner().invoke(cli, words)
    assert "is not empty; give another folder, or --force" in str(refused.exception)
    assert len(weighed) == 1  # before anything is weighed
    assert CliRunner().invoke(cli, [*words, "--force"]).exit_code == 0
    assert CliRunner().invoke(cli, words[:3], catch_exceptions=False).exit_code == 0
