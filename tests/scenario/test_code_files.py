"""Code named in a scenario: found beside the file, run when a flight is built and never before."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import springback
from springback.batch.scenarios import fly_scenarios
from springback.errors import InputError
from springback.scenario.code_files import changed_files, code_digests, read_object
from springback.scenario.files import read_scenario
from springback.scenario.user.trust import trust, trusted_folders

FILE = '''
"""A pilot, a wall of one's own, and a note that this file was run."""
import math
from pathlib import Path
from typing import NamedTuple
import neighbour
from springback import PilotOutput, Vec, kernel, outward_normal, signed_distance
from springback.contact.obstacles import Plane

Path(__file__).with_name("ran").touch()
calls = 0


def share(time, measurement, memory):
    global calls
    calls += 1
    return [neighbour.SHARE + 1e-3 * calls] * 4, None


def fails(time, measurement, memory):
    if time > 0.05:
        raise ZeroDivisionError("as asked")
    return [1.0] * 4, None


def for_vehicle(context):
    each = context.vehicle.mass * context.gravity / context.vehicle.arm_count
    return lambda time, measurement, memory: ([each] * context.vehicle.arm_count, memory)


def wall(x, tilt=Vec(-1.0, 0.0, 0.0)):
    return Plane(tilt, -x)


WALL = wall(2.75)
'''
START = {"position": [2.3, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0], "pitch": "15 deg"}
OWN = {"type": "own", "surface": "wall"}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("SPRINGBACK_TRUST", str(tmp_path))
    (tmp_path / "mine.py").write_text(FILE)
    (tmp_path / "neighbour.py").write_text("SHARE = 0.7\n")
    return tmp_path


def _file(folder: Path, *lines: str) -> Path:
    path = folder / "flight.toml"
    text = ['vehicle = "quad"', *lines, "[simulation]", "duration = 0.1"]
    path.write_text("\n".join(text) + "\n")
    return path


def _same(a: springback.Flight, b: springback.Flight) -> bool:
    return a.measures == b.measures and all(
        x.tobytes() == b.columns[name].tobytes() for name, x in a.columns.items()
    )


def test_a_pilot_is_found_beside_the_scenario(folder: Path) -> None:
    named = springback.fly(_file(folder, 'pilot = "mine.py:share"'))
    given = springback.fly(_file(folder), pilot=f"{folder}/mine.py:share")
    assert _same(named, given)
    assert named.telemetry["command1"][0] == pytest.approx(0.701)
    again = springback.fly(_file(folder, 'pilot = "mine.py:share"'))  # not counted on
    assert _same(named, again)
    given = springback.fly(
        _file(folder, 'pilot = "mine.py:fails"'), pilot=f"{folder}/mine.py:share"
    )
    assert _same(named, given)  # an argument goes before the file


def test_a_pilot_can_be_built_for_the_vehicle(folder: Path) -> None:
    flight = springback.fly(_file(folder, f'pilot = "{folder}/mine.py:for_vehicle"'))
    share = springback.QUAD.vehicle.mass * 9.81 / 4.0
    assert flight.telemetry["command3"] == pytest.approx(share)


def test_a_shape_of_ones_own_is_a_wall_like_ours(folder: Path) -> None:
    wall = {"type": "wall", "distance": 2.75, "surface": "wall"}
    tables: dict[str, Any] = {"vehicle": "arq", "thrust": "hover", "start": START}
    ours = springback.fly({**tables, "world": {"obstacles": [wall]}})
    assert ours.contacts
    word = f"{folder}/mine.py"
    for entry in (
        OWN | {"shape": f"{word}:WALL"},
        OWN | {"shape": f"{word}:wall", "parameters": {"x": 2.75}},
        OWN | {"shape": f"{word}:wall", "parameters": {"x": "2.75", "tilt": [-1, 0.0, 0.0]}},
    ):
        own = springback.fly({**tables, "world": {"obstacles": [entry]}})
        assert _same(ours, own)
        assert own.own[0][1] == springback.WALL


def test_reading_runs_nothing(folder: Path) -> None:
    path = _file(folder, 'pilot = "mine.py:share"')
    scenario = read_scenario(path)
    assert scenario.code == [("pilot", f"{folder}/mine.py:share")]
    assert not (folder / "ran").exists()
    springback.fly(path)
    assert (folder / "ran").exists()


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        (('pilot = "mine.py"',), r"flight.toml:2: pilot: must be FILE.py:NAME \(got 'mine.py'\)"),
        (
            ('pilot = "mine:share"',),
            r"flight.toml:2: pilot: must be FILE.py:NAME \(got '.*/mine:s",
        ),
        (('pilot = "none.py:hover"',), r"none.py: there is no such file"),
        (('pilot = "mine.py:hover"',), r"mine.py: has no 'hover'; there are: .*share"),
        (('pilot = "mine.py:WALL"',), r"WALL must be a function \(time, measurement, memory\)"),
        (('pilot = "mine.py:fails"',), r"mine.py:2\d: ZeroDivisionError: as asked, at 0.05"),
    ],
)
def test_a_pilot_that_is_none_is_refused(folder: Path, lines: tuple[str], said: str) -> None:
    with pytest.raises(InputError, match=said):
        springback.fly(_file(folder, *lines))


def test_the_name_of_a_module_is_told_the_form_that_is_wanted(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(folder)
    with pytest.raises(InputError) as refused:
        read_object("mine:share", "code of your own")
    assert str(refused.value) == ("'mine:share': must be FILE.py:NAME; did you mean mine.py:share?")
    with pytest.raises(InputError, match=r"^'other:share': must be FILE.py:NAME$"):
        read_object("other:share", "code of your own")


@pytest.mark.parametrize(
    ("entry", "said"),
    [
        ({"shape": "mine.py:nix"}, r"world.obstacles\[0\].shape: .*mine.py: has no 'nix'"),
        ({"shape": "mine.py:wall"}, r"obstacles\[0\].parameters: .* missing 1 required .*'x'"),
        ({"shape": "mine.py:wall", "parameters": {"y": 1.0}}, "unexpected keyword argument 'y'"),
        ({"shape": "mine.py:WALL", "parameters": {"x": 1.0}}, "is a shape, not its type"),
        ({"shape": "mine.py:wall", "parameters": {"x": "3 m"}}, "parameters.x: .*plain number"),
        ({"shape": "mine.py:wall", "parameters": {"x": True}}, "must be a plain number"),
        ({"shape": "mine.py:share"}, r"share cannot be made without any: TypeError"),
        ({"shape": "mine.py:calls"}, r"must be a shape, a NamedTuple"),
        ({"shape": "mine.py:wall", "parameters": {"x": 2.3}}, "start.position: puts the"),
        (
            {"shape": "mine.py:wall", "parameters": {"x": 2.75, "tilt": [-2.0, 0.0, 0.0]}},
            "outward_normal at .* 2 long",
        ),
    ],
)
def test_a_shape_that_is_none_is_refused(folder: Path, entry: dict[str, Any], said: str) -> None:
    entry["shape"] = f"{folder}/{entry['shape']}"
    tables = {"vehicle": "arq", "start": START, "world": {"obstacles": [OWN | entry]}}
    with pytest.raises(InputError, match=said):
        springback.fly(tables)


def test_batches_fly_what_flights_fly(folder: Path) -> None:
    """Shapes with numbers of their own in lanes, plain pilots one by one; a failure ends one row."""
    walls = [
        {
            "vehicle": "arq",
            "start": START,
            "world": {
                "obstacles": [OWN | {"shape": f"{folder}/mine.py:wall", "parameters": {"x": x}}]
            },
        }
        for x in (2.7 + 0.01 * k for k in range(20))
    ]
    pilots = [
        {"vehicle": "quad", "pilot": f"{folder}/mine.py:{name}", "simulation": {"duration": 0.1}}
        for name in ("share", "fails", "share", "for_vehicle")
    ]
    rows = fly_scenarios([*walls, *pilots])
    for k, tables in enumerate([*walls, *pilots]):
        if k == len(walls) + 1:
            assert rows.outcomes[k] == "refused"
            assert "ZeroDivisionError: as asked, at 0.05" in rows.problems[k]
            continue
        flight = springback.fly(tables)
        assert rows.outcomes[k] == flight.outcome.word
        for name, value in flight.measures.items():
            assert value is None or value == rows.measures[name][k]
    assert len({*rows.measures["touch_time"][: len(walls)]}) == len(walls)


def test_digests_know_neighbours(folder: Path) -> None:
    digests = code_digests([f"{folder}/mine.py:share", f"{folder}/mine.py:WALL"])
    assert {Path(path).name for path in digests} == {"mine.py", "neighbour.py"}
    assert changed_files(digests) == []
    (folder / "neighbour.py").write_text("SHARE = 0.8\n")
    (folder / "mine.py").unlink()
    assert changed_files(digests) == [f"{folder}/mine.py", f"{folder}/neighbour.py"]


def test_a_changed_file_is_read_again(folder: Path) -> None:
    path = folder / "other.py"
    path.write_text("A = 1\n")
    assert read_object(f"{path}:A", "a number") == 1
    path.write_text("A = 2\n")
    assert read_object(f"{path}:A", "a number") == 2


def test_code_runs_in_trusted_folders_only(
    folder: Path, tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path_factory.mktemp("config")))
    monkeypatch.delenv("SPRINGBACK_TRUST")
    path = _file(folder, 'pilot = "mine.py:share"')
    wall = OWN | {"shape": f"{folder}/mine.py:WALL"}
    for scenario in (path, {"vehicle": "arq", "start": START, "world": {"obstacles": [wall]}}):
        with pytest.raises(
            InputError, match=rf"not trusted; .* type once: springback trust {folder}"
        ):
            springback.fly(scenario)
    assert not (folder / "ran").exists()
    assert trust(folder.parent) == [folder.parent]
    springback.fly(path)
    springback.fly(_file(folder), pilot=f"{folder}/mine.py:share")
    listed = next((tmp_path_factory.getbasetemp()).glob("config*/springback/trusted.json"))
    assert listed.stat().st_mode & 0o777 == 0o600
    listed.chmod(0o666)  # anyone could have written it
    assert trusted_folders() == []
    listed.chmod(0o600)
    assert trust(folder.parent, ends=True) == []
    with pytest.raises(InputError, match="not trusted"):
        springback.fly(_file(folder, 'pilot = "mine.py:share"'))
    springback.fly(_file(folder), pilot=f"{folder}/mine.py:share")  # named by the user himself
    with pytest.raises(InputError, match="there is no such folder"):
        trust(folder / "none")


def test_a_vehicle_is_read_from_its_file(folder: Path) -> None:
    (folder / "heavy.toml").write_text('preset = "arq"\n[body]\nmass = "0.9 kg"\n')
    (folder / "in_table.toml").write_text('[vehicle]\npreset = "arq"\nbody = { mass = 0.9 }\n')
    for word in ("heavy", "in_table"):
        path = folder / "flight.toml"
        path.write_text(f'vehicle = "{word}.toml"\n')
        vehicle = read_scenario(path, ["vehicle.body.inertia=[1e-2, 1e-2, 1e-2]"]).vehicle
        assert (vehicle.name, vehicle.body.mass) == (word, 0.9)
        assert vehicle.body.inertia[0][0] == 0.01
    (folder / "in_table.toml").write_text('preset = "heavy.toml"\n[arms]\ncompliant = false\n')
    changed = read_scenario(folder / "flight.toml").vehicle
    assert (changed.name, changed.body.mass, changed.arms.compliant) == ("in_table", 0.9, False)
    for text, said in (
        ('preset = "in_table.toml"', "must not name a file that names this one, in_table.toml"),
        ('preset = "missing.toml"', "missing.toml"),
        ("vehicle = 3", r"vehicle: must be a table \(got 3\)"),
        ('preset = "nix"', "unknown vehicle preset 'nix'"),
        ("a = ", "Invalid value"),
    ):
        (folder / "in_table.toml").write_text(text + "\n")
        with pytest.raises(InputError, match=said):
            read_scenario(folder / "flight.toml")


def test_an_error_of_an_own_obstacle_names_its_entry_and_the_file(folder: Path) -> None:
    """Counted from 0 as everywhere, with the line of the scenario, or the override at fault."""
    (folder / "bad.py").write_text(FILE.replace("Vec(-1.0, 0.0, 0.0)", "Vec(-2.0, 0.0, 0.0)"))
    path = _file(
        folder,
        "[[world.obstacles]]", 'type = "ground"', 'surface = "wall"',
        "[[world.obstacles]]", 'type = "own"', 'surface = "wall"', 'shape = "bad.py:wall"',
        "parameters = { x = 2.75 }", "[start]", "position = [2, 0, 1]",
    )  # fmt: skip
    with pytest.raises(InputError) as refused:
        springback.fly(path)
    [line] = refused.value.problems
    assert line.startswith(f"{path}:8: world.obstacles[1].shape, Plane: outward_normal at ")
    with pytest.raises(
        InputError, match=r"^override world.obstacles.1.parameters.y=3: .*\[1\]\.par"
    ):
        springback.fly(path, "world.obstacles.1.parameters.y=3")
    near = "world.obstacles.1.parameters={ x = 2.1 }"
    with pytest.raises(InputError) as refused:
        springback.fly(path, f"world.obstacles.1.shape={folder}/mine.py:wall", near)
    [line] = refused.value.problems
    assert line.startswith(f"override {near}: start.position: puts the cage of arm ")
    assert "inside world.obstacles[1], a Plane (got [2.0, 0.0, 1.0] m)" in line
