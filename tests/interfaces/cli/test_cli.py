"""The command line as a newcomer meets it: files, exit codes, one clear line for each error."""

import json
import signal
import subprocess
import sys
import time
from pathlib import Path

import duckdb
import pytest
from click.testing import CliRunner

from builders.forms import box_file
from builders.interrupts import heed_interrupts
from builders.missing import needs
from springback.errors import InputError
from springback.interfaces.cli.app import cli
from springback.scenario import checks

SCENARIO = """\
name = "test flight"
vehicle = "arq"
thrust = "hover"

[[world.obstacles]]
type = "wall"
distance = "2.75 m"
surface = "wall"

[start]
position = ["2.45 m", 0, "1 m"]
velocity = ["2 m/s", 0, 0]

[simulation]
duration = "0.1 s"
"""


def run(*words: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "springback", *words],
        cwd=cwd, capture_output=True, text=True, timeout=300, check=False,
    )  # fmt: skip


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "s.toml").write_text(SCENARIO)
    return tmp_path


def refused(done: subprocess.CompletedProcess[str], *words: str) -> None:
    """Exit code 2, one line on stderr with all the words, nothing on stdout, no traceback."""
    assert done.returncode == 2, done.stderr
    lines = done.stderr.strip().splitlines()
    assert len(lines) == 1, done.stderr
    assert lines[0].startswith("error: ")
    for word in words:
        assert word in lines[0], f"{word!r} not in {lines[0]!r}"
    assert done.stdout == ""


def test_an_error_is_json_where_the_result_would_be(folder: Path) -> None:
    """One object on stdout; stderr and the exit code are as without."""
    done = run("check", "s.toml", "world.obstacles.0.type=waal", "--json", cwd=folder)
    assert done.returncode == 2
    assert done.stderr.startswith("error: override world.obstacles.0.type=waal: world.obstacles[0]")
    data = json.loads(done.stdout)
    assert data["kind"] == "error"
    [problem] = data["problems"]
    assert problem.pop("message").endswith("(got 'waal'); did you mean wall?")
    assert problem == {
        "file": None, "line": None, "override": "world.obstacles.0.type=waal",
        "field": "world.obstacles[0].type",
    }  # fmt: skip
    (folder / "t.toml").write_text(SCENARIO.replace('"wall"\ndistance', '"waal"\ndistance'))
    [problem] = json.loads(run("fly", "t.toml", "--out", "o", "--json", cwd=folder).stdout)[
        "problems"
    ]
    assert (problem["file"], problem["line"]) == ("t.toml", 6)
    assert problem["field"] == "world.obstacles[0].type"
    for words, said in (
        (("check", "none.toml", "--json"), "cannot be read (No such file or directory)"),
        (("fly", "s.toml", "--json"), "Missing option '--out'."),
    ):
        done = run(*words, cwd=folder)
        assert done.returncode == 2
        assert [one["message"] for one in json.loads(done.stdout)["problems"]] == [said]


def test_what_is_misused_is_told_in_one_line(folder: Path) -> None:
    """Warnings of a scenario are not printed before the folder is known to be one."""
    coarse = f'[[world.obstacles]]\ntype = "mesh"\nfile = "{box_file(0.04, 0.8, 0.8)}"\n'
    coarse += 'cell = 0.028\nposition = [5, 0, 1]\nsurface = "wall"\n'
    (folder / "t.toml").write_text(SCENARIO + coarse)
    assert "are coarse for a mesh" in run("check", "t.toml", cwd=folder).stderr
    for words, said in (
        (("fyl",), "No such command 'fyl'."),
        (("fly", "s.toml"), "Missing option '--out'. See "),
        (("fly", "t.toml", "--out", "s.toml"), "s.toml: is a file, not a folder"),
    ):
        done = run(*words, cwd=folder)
        assert done.returncode == 2
        assert done.stdout == ""
        [line] = done.stderr.splitlines()
        assert line.startswith("error: ")
        assert said in line


def test_fly_writes_summary_trajectory_and_figures(folder: Path) -> None:
    done = run("fly", "s.toml", "--out", "out", cwd=folder)
    assert done.returncode == 0, done.stderr
    assert "hit an obstacle and left it again" in done.stdout
    names = {path.name for path in (folder / "out").iterdir()}
    assert {"summary.json", "trajectory.parquet", "flight.png"} <= names
    summary = json.loads((folder / "out" / "summary.json").read_text())
    assert summary["outcome"] == "separated"
    assert summary["units"]["peak_acceleration"] == "m/s^2"
    assert summary["scenario"]["vehicle"]["arms"]["stiffness"] == 5000.0

    path = str(folder / "out" / "trajectory.parquet")
    database = duckdb.connect()
    table = database.sql(f"SELECT * FROM '{path}'")
    expected = ["t", "x", "y", "z", "qw", "qx", "qy", "qz", "vx", "vy", "vz", "wx", "wy", "wz"]
    assert table.columns[:14] == expected
    for stem in ("l", "dl", "fn", "ff"):
        assert {f"{stem}{j}" for j in (1, 2, 3, 4)} <= set(table.columns)
    [(keys,)] = database.execute(
        f"SELECT decode(value) FROM parquet_kv_metadata('{path}') WHERE decode(key) = 'units'"
    ).fetchall()
    assert json.loads(keys)["fn1"] == "N"
    [(peak,)] = database.execute(
        f"SELECT max(sqrt(ax*ax + ay*ay + az*az)) FROM '{path}'"
    ).fetchall()
    # A peak lies between instants.
    assert peak == pytest.approx(summary["measures"]["peak_acceleration"], rel=1e-4)


def test_json_is_the_summary_and_quiet_is_quiet(folder: Path) -> None:
    done = run("fly", "s.toml", "--out", "out", "--no-figures", "--json", "--quiet", cwd=folder)
    assert json.loads(done.stdout) == json.loads((folder / "out" / "summary.json").read_text())
    assert done.stderr == ""


def test_overrides_reach_the_flight(folder: Path) -> None:
    words = (
        "vehicle.arms.compliant=false",
        'start.velocity=["1 m/s",0,0]',
        "world.obstacles.0.distance=2.7 m",
    )
    done = run("fly", "s.toml", *words, "--out", "out", "--no-figures", "--json", cwd=folder)
    assert done.returncode == 0, done.stderr
    summary = json.loads(done.stdout)
    assert summary["measures"]["arm_stroke"] == 0.0
    assert summary["scenario"]["start"]["velocity"] == [1.0, 0.0, 0.0]
    assert summary["scenario"]["world"]["obstacles"][0]["distance"] == 2.7


def test_results_are_kept_unless_forced(folder: Path) -> None:
    (folder / "out").mkdir()
    (folder / "out" / "summary.json").write_text("precious")
    (folder / "out" / "notes.txt").write_text("mine")
    refused(run("fly", "s.toml", "--out", "out", "--no-figures", cwd=folder), "--out", "--force")
    assert (folder / "out" / "summary.json").read_text() == "precious"
    done = run("fly", "s.toml", "--out", "out", "--no-figures", "--force", cwd=folder)
    assert done.returncode == 0, done.stderr
    assert (folder / "out" / "summary.json").read_text() != "precious"
    assert (folder / "out" / "notes.txt").read_text() == "mine"


def test_bad_input_leaves_nothing_behind(folder: Path) -> None:
    before = sorted(folder.rglob("*"))
    refused(run("fly", "s.toml", "vehicle.body.mass=-1 kg", "--out", "a/b/out", cwd=folder),
            "vehicle.body.mass", "more than 0 kg", "-1 kg")  # fmt: skip
    refused(
        run("fly", "nothing.toml", "--out", "out", cwd=folder), "nothing.toml", "cannot be read"
    )
    refused(
        run("fly", "s.toml", "vehicle=arqq", "--out", "out", cwd=folder),
        "arqq",
        "did you mean arq?",
    )
    assert sorted(folder.rglob("*")) == before


def test_errors_name_file_and_line(folder: Path) -> None:
    (folder / "s.toml").write_text(SCENARIO.replace('"2.75 m"', '"2.75 kg"'))
    refused(run("fly", "s.toml", "--out", "out", cwd=folder),
            "s.toml:7:", "world.obstacles[0].distance", "2.75 kg", "expected m")  # fmt: skip


def test_out_must_be_a_folder_that_can_be_written(folder: Path) -> None:
    (folder / "file").write_text("")
    refused(run("fly", "s.toml", "--out", "file", cwd=folder), "is a file")
    refused(run("fly", "s.toml", "--out", "file/inside", cwd=folder), "--out")
    refused(run("fly", "s.toml", "--out", "/proc/springback", cwd=folder), "cannot be written")


def test_wrong_usage_exits_with_2(folder: Path) -> None:
    for words in (
        ("fly", "s.toml"),
        ("flyy",),
        ("fly", "s.toml", "--outt", "x"),
        ("reproduce", "moon", "--out", "x"),
    ):
        done = run(*words, cwd=folder)
        assert done.returncode == 2
        assert "Traceback" not in done.stderr


def test_a_diverging_flight_ends_with_1_and_its_last_good_state(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Numbers with which one does are refused, so that this one is flown as if they were not."""
    monkeypatch.setattr(checks, "check_magnitudes", lambda tables: None)
    words = (
        "world.obstacles.0.surface.stiffness=1e30",
        "world.obstacles.0.surface.dissipation=1e9",
    )
    out = folder / "out"
    given = ["fly", str(folder / "s.toml"), *words, "--out", str(out), "--no-figures", "--json"]
    done = CliRunner().invoke(cli, given)
    assert done.exit_code == 1
    assert json.loads(done.stdout)["outcome"] == "not_finite"
    assert "NaN" not in (out / "summary.json").read_text()


def test_show_names_the_source_of_every_number(folder: Path) -> None:
    listed = run("show", cwd=folder).stdout
    assert "arq" in listed
    assert "mat" in listed
    shown = json.loads(run("show", "quad-slider", "--json", cwd=folder).stdout)
    assert shown["settings"]["body"]["mass"] == 1.892
    assert "Table II" in shown["sources"]["body.mass"]
    refused(run("show", "quod", cwd=folder), "did you mean quad?")


def test_help_is_quick_and_imports_nothing_heavy(folder: Path) -> None:
    code = (
        "import sys; from springback.interfaces.cli.app import cli; "
        "heavy = {'numba', 'scipy', 'numpy', 'matplotlib', 'duckdb', 'pydantic', 'rich'} & set(sys.modules); "
        "sys.exit(', '.join(heavy) or 0)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "fly" in run("--help", cwd=folder).stdout


def test_what_flies_loads_nothing_that_few_flights_need() -> None:
    """Hulls of points, tables and pictures are rare; their libraries take as long as a flight."""
    code = (
        "import sys, springback; springback.fly; "
        "wall = {'type': 'wall', 'distance': 2.75, 'surface': 'wall'}; "
        "table = {'vehicle': 'arq', 'world': {'obstacles': [wall]}, "
        "'reference': {'type': 'run-up', 'speed': 2.0}, 'recovery': {}}; "
        "from springback.scenario.scenario import scenario_from; scenario_from(table); "
        "heavy = {'scipy.spatial', 'scipy.interpolate', 'matplotlib', 'duckdb'} & set(sys.modules); "
        "sys.exit(', '.join(heavy) or 0)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_a_throw_loads_nothing_that_identifies(folder: Path) -> None:
    """Its statistics take as long to load as all else; an overlay is read without them."""
    code = (
        "import sys; from springback.interfaces.cli.app import cli; "
        "cli(['fly', 's.toml', '--out', 'out'], standalone_mode=False); "
        "heavy = [name for name in sys.modules if name.startswith('scipy.stats') "
        "or name.startswith('springback.identification')]; "
        "sys.exit(', '.join(heavy) or 0)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=folder, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("listens", [True, False])
def test_a_flight_is_told_before_its_files_are_written(folder: Path, listens: bool) -> None:
    """They take longer than it; a reader that has ended loses none of them."""
    words, out = ["fly", "s.toml", "--out", "out"], folder / "out"
    with subprocess.Popen(
        [sys.executable, "-m", "springback", *words],
        cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
    ) as process:  # fmt: skip
        assert process.stdout is not None
        if listens:
            assert process.stdout.readline().startswith("Flight 'test flight'")
            assert not out.exists()
        process.stdout.close()
        assert process.wait(300) == (0 if listens else 1)
    assert {"summary.json", "flight.png"} <= {path.name for path in out.iterdir()}


@needs("POSIX")
def test_interrupt_exits_with_130_and_leaves_nothing(folder: Path) -> None:
    slow = "import time\n\ndef slow(now, seen, memory):\n    time.sleep(0.01)\n    return [3.0] * 4, memory\n"
    (folder / "p.py").write_text(slow)
    words = ["fly", "s.toml", "--pilot", "p.py:slow", "simulation.duration=60 s", "--out", "out"]
    words += ["--no-figures"]
    with subprocess.Popen(
        [sys.executable, "-m", "springback", *words],
        cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        preexec_fn=heed_interrupts,
    ) as process:  # fmt: skip
        try:
            time.sleep(4.0)
            process.send_signal(signal.SIGINT)
            _, errors = process.communicate(timeout=60)
        finally:
            process.kill()
    assert process.returncode == 130, errors
    assert "Traceback" not in errors
    left = sorted(path.name for path in folder.iterdir() if path.name != "__pycache__")
    assert left == ["p.py", "s.toml"]


def test_an_interrupted_command_ends_before_what_it_used_is_freed() -> None:
    """Else a library can crash in threads that still use it: exit code -11 instead of 130."""
    source = """
import sys
from springback import command
from springback.interfaces.cli import app

class Library:
    def __del__(self):
        print("freed")

class Group:
    def main(self, standalone_mode):
        used = Library()
        raise KeyboardInterrupt

app.cli = Group()
command.run()
"""
    done = subprocess.run([sys.executable, "-c", source], capture_output=True, text=True)
    assert done.returncode == 130
    assert "interrupted" in done.stderr
    assert "freed" not in done.stdout


def test_readings_belong_to_the_slider_tests(tmp_path: Path) -> None:
    for part in ("flight", "resilience"):
        words = ["reproduce", part, "--reading", "X: a=1", "--out", str(tmp_path / "out")]
        assert isinstance(CliRunner().invoke(cli, words).exception, InputError)
        assert not (tmp_path / "out").exists()


def test_every_command_says_that_a_required_option_is_missing() -> None:
    """With its arguments and nothing else, none of them goes on, or down."""
    asked = 0
    for name, command in cli.commands.items():
        required = [p for p in command.params if p.required and p.param_type_name == "option"]
        if required:
            asked += 1
            given = [p for p in command.params if p.param_type_name == "argument"]
            words = ["x.toml" for p in given if p.required or p.nargs == -1]
            done = CliRunner().invoke(cli, [name, *words])
            assert done.exit_code == 2, (name, done.output)
            assert f"Missing option '{required[0].opts[0]}'" in done.output, (name, done.output)
    assert asked >= 3
