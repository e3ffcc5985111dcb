"""Campaigns with code and vehicles of the user's own: same rows, nothing unnoticed, nothing run."""

from __future__ import annotations

import contextlib
import shutil
from pathlib import Path
from typing import Any

import pytest

import springback
from builders.cases import nonempty
from builders.user_pilots import before_a_wall, pilot_file
from springback.campaign.access import Campaign
from springback.campaign.analysis.statistics import summary
from springback.campaign.cost_estimate import cost_estimate
from springback.campaign.design.layout import lay_out
from springback.campaign.design.plan import Plan, read_plan
from springback.campaign.envelope_plan import plan_envelope
from springback.campaign.errors import CampaignError
from springback.campaign.flying import fly_chunk, try_code
from springback.campaign.running import run_campaign
from springback.campaign.store import open_store, stored_plan
from springback.errors import InputError
from springback.scenario.code_files import with_absolute_names

EXAMPLES = Path(__file__).parents[2] / "examples"
CODE = """
from pathlib import Path
from springback import Vec
from springback.contact.obstacles import Plane

Path(__file__).with_name("ran").touch()


def wall(x):
    return Plane(Vec(-1.0, 0.0, 0.0), -x)


def hover(time, measurement, memory):
    if measurement.pose.position.x > 0.55:
        raise RuntimeError("too far ahead")
    return [0.8] * 4, memory
"""
SCENARIO = """
vehicle = "arq"
thrust = "hover"
[[world.obstacles]]
type = "own"
shape = "mine.py:wall"
parameters = { x = 2.75 }
surface = "wall"
[start]
position = [2.3, 0.0, 1.0]
velocity = [2.0, 0.0, 0.0]
"""
PLAN = """
method = "grid"
scenario = "flight.toml"
robots = ["arq", "heavy.toml"]
[[vary]]
field = "world.obstacles.0.parameters.x"
from = 2.72
to = 2.78
count = 12
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("SPRINGBACK_TRUST", str(tmp_path))
    (tmp_path / "mine.py").write_text(CODE)
    (tmp_path / "flight.toml").write_text(SCENARIO)
    (tmp_path / "heavy.toml").write_text('preset = "arq"\nbody = { mass = 0.9 }\n')
    (tmp_path / "plan.toml").write_text(PLAN)
    return tmp_path


def _plan(folder: Path) -> Plan:
    return read_plan(folder / "plan.toml")[0]


def test_rows_are_those_of_flights(folder: Path) -> None:
    campaign = run_campaign(_plan(folder), folder / "out", workers=1)
    rows = campaign.query("SELECT * FROM flights ORDER BY flight").as_dicts()
    assert [row["robot"] for row in rows[:2]] == ["arq", "heavy"]
    for row, vehicle in zip(rows[4:6], ("arq", "heavy.toml"), strict=True):
        word = f"world.obstacles.0.parameters.x={row['world.obstacles[0].parameters.x']!r}"
        flight = springback.fly(
            folder / "flight.toml",
            word,
            f"vehicle={folder / vehicle if '.' in vehicle else vehicle}",
        )
        for name, value in flight.measures.items():
            assert row[name] == value
    assert rows[4]["impact_peak_acceleration"] != rows[5]["impact_peak_acceleration"]


def test_a_stranger_s_folder_runs_nothing(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    out = folder / "out"
    run_campaign(_plan(folder), out, workers=1)
    (folder / "ran").unlink()
    monkeypatch.setenv("SPRINGBACK_TRUST", str(out))
    known = Campaign(out)
    assert known.query("SELECT count(*) FROM flights").rows == [(24,)]
    lay_out(stored_plan(out), tried=False)
    for work in (
        lambda: known.refly(3),
        lambda: run_campaign(stored_plan(out), out, resume=True),
        lambda: run_campaign(_plan(folder), folder / "more"),
        lambda: cost_estimate(lay_out(_plan(folder))),
    ):
        with pytest.raises(
            InputError, match=r"mine.py:wall is code, and its folder is not trusted"
        ):
            work()
    assert not (folder / "ran").exists()
    monkeypatch.setenv("SPRINGBACK_TRUST", str(folder))
    assert not known.refly(3).differences
    (folder / "mine.py").write_text(CODE + "\n")
    with pytest.raises(InputError, match=r"mine.py: has changed since the campaign was flown"):
        Campaign(out).refly(3)


def test_a_campaign_goes_on_with_the_same_code_only(folder: Path) -> None:
    design = lay_out(_plan(folder))
    with open_store(folder / "out", design, resume=False) as store:
        one = fly_chunk(design.plan.canonical(), (0, 8))
        store.add(*one.chunk, one.columns)
    (folder / "mine.py").write_text(CODE.replace("-x)", "-x - 0.01)"))
    with pytest.raises(InputError, match=r"another campaign: .*mine.py has changed since it began"):
        run_campaign(_plan(folder), folder / "out", resume=True, workers=1)
    (folder / "mine.py").write_text(CODE)
    assert run_campaign(_plan(folder), folder / "out", resume=True, workers=1).complete
    (folder / "heavy.toml").write_text('preset = "arq"\nbody = { mass = 0.8 }\n')
    with pytest.raises(InputError, match="its plan differs in vehicles"):
        run_campaign(_plan(folder), folder / "out", resume=True, workers=1)


def test_code_that_changes_meanwhile_is_noticed(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plan = _plan(folder)
    design = lay_out(plan)
    assert [*design.code] == [str(folder / "mine.py")]

    def changed(*_: Any, **__: Any) -> dict[str, Any]:
        (folder / "mine.py").write_text(CODE + "\n")
        return {}

    monkeypatch.setattr("springback.campaign.flying.rows", changed)
    with pytest.raises(InputError, match=r"mine.py: was changed during the flights"):
        fly_chunk(plan.canonical(), (0, 8))
    with pytest.raises(CampaignError, match=r"mine.py: differs between this process"):
        run_campaign(design, folder / "out", workers=1)


@pytest.mark.parametrize(
    "own",
    [
        {"pilot": "mine.py:hover"},
        {"estimator": {"type": "own", "code": "mine.py:hover"}},
        {"recovery": {"detection": {"own": {"code": "mine.py:hover"}}}},
        {"world": {"obstacles": [{"type": "own", "shape": "mine.py:wall", "surface": "wall"}]}},
    ],
    ids=("pilot", "estimator", "detector", "obstacle"),
)
def test_a_gpu_refuses_code_before_it_is_looked_for(folder: Path, own: dict[str, Any]) -> None:
    given = {"vehicle": "quad", "reference": {"type": "hold"}} | own
    if "pilot" in own:
        del given["reference"]
    vary = ({"field": "start.position.0", "from": 0.3, "to": 0.7, "count": 2},)
    plan = Plan(scenario=with_absolute_names(given, folder), method="grid", vary=vary)
    with pytest.raises(InputError) as found:
        run_campaign(plan, folder / "out", workers=1, device="gpu")
    assert found.value.problems == ("--device gpu: cannot fly code of your own; use cpu",)
    assert not (folder / "out").exists()


def test_a_pilot_that_fails_ends_its_own_row(folder: Path) -> None:
    plan = Plan(
        scenario={
            "vehicle": "quad", "pilot": f"{folder}/mine.py:hover", "simulation": {"duration": 0.05},
        },
        method="grid", vary=({"field": "start.position.0", "from": 0.3, "to": 0.7, "count": 5},),
    )  # fmt: skip
    rows = run_campaign(plan, folder / "out", workers=1).query("FROM flights ORDER BY flight")
    outcomes = [row["outcome"] for row in rows.as_dicts()]
    assert outcomes == ["no_contact"] * 3 + ["refused"] * 2
    assert "mine.py:15: RuntimeError: too far ahead, at 0 s" in rows.as_dicts()[4]["problem"]


def test_a_pilot_that_fails_in_flight_4711_ends_that_row_and_no_other(folder: Path) -> None:
    (folder / "fails.py").write_text(
        "def pilot(context, number):\n"
        "    def hover(time, measurement, memory):\n"
        "        if number == 4711 and time > 0.005:\n"
        "            raise ValueError('as asked')\n"
        "        return [3.0] * 4, memory\n"
        "    return hover\n"
    )
    pilot = {"code": f"{folder}/fails.py:pilot", "parameters": {"number": 0.0}}
    plan = Plan(
        scenario={"vehicle": "quad", "pilot": pilot, "simulation": {"duration": 0.01}},
        method="grid",
        vary=({"field": "pilot.parameters.number", "from": 0.0, "to": 4999.0, "count": 5000},),
    )
    rows = fly_chunk(plan.canonical(), (4706, 4718)).columns
    assert rows["flight"] == [*range(4706, 4718)]
    assert rows["outcome"] == ["no_contact"] * 5 + ["refused"] + ["no_contact"] * 6
    assert rows["problem"][5] == f"{folder}/fails.py:4: ValueError: as asked, at 0.006 s"
    assert [*filter(None, rows["problem"])] == [rows["problem"][5]]


def test_own_sensing_flies_in_lanes_as_alone(folder: Path) -> None:
    """Built by one pass for all flights, and compiled; alone here in plain Python: the same bits."""
    for name in ("own_detector.py", "own_estimator.py"):
        shutil.copy(EXAMPLES / name, folder)
    jolt = {"code": f"{folder}/own_detector.py:jolt", "parameters": {"threshold": 20.0}}
    scenario = {
        "vehicle": "quad",
        "reference": {"type": "hold", "position": [0.6, 0.0, 1.0]},
        "estimator": {"type": "own", "code": f"{folder}/own_estimator.py:blend"},
        "recovery": {"detection": {"own": jolt}},
        "world": {"obstacles": [{"type": "wall", "distance": 1.0, "surface": "wall"}]},
        "start": {"position": [0.746, 0.0, 1.0], "velocity": [2.0, 0.2, 0.0]},
        "simulation": {"duration": 0.03, "impact_step": 5e-4},
    }
    field = "recovery.detection.own.parameters.threshold"
    plan = Plan(
        scenario=scenario, method="grid",
        vary=({"field": field, "from": 20.0, "to": 240.0, "count": 9},),
    )  # fmt: skip
    assert {Path(path).name for path in lay_out(plan).code} == {
        "own_detector.py", "own_estimator.py",
    }  # fmt: skip
    campaign = run_campaign(plan, folder / "out", workers=1)
    rows = campaign.query("FROM flights ORDER BY flight").as_dicts()
    assert rows[0]["alarm_time"] < rows[4]["alarm_time"]
    assert [row["outcome"] for row in (rows[0], rows[8])] == ["not_settled", "not_detected"]
    for k in (0, 4):
        [tables], row = lay_out(plan).slice(k, k + 1).tables, rows[k]
        flight = springback.fly(tables, executor="python")
        assert flight.outcome.word == row["outcome"]
        for name, value in nonempty(flight.measures.items()):
            assert row[name] == value, name
    text = (folder / "own_detector.py").read_text()
    (folder / "own_detector.py").write_text(text.replace("-level", "level"))
    with pytest.raises(InputError, match=r"own_detector.py: has changed since"):
        campaign.refly(0)


def _guards(folder: Path, **others: Any) -> Plan:
    """Two parameters of one compiled pilot, and springback's, from 0.3 to 0.65 m/s into a wall."""
    code = f"{pilot_file(folder)}:guard"
    reference = {"type": "hold", "position": [0.7, 0.0, 1.0]}
    given: dict[str, Any] = {
        "method": "random", "samples": 12, "seed": 3,
        "scenario": before_a_wall(code, reference=reference),
        "pilots": [{"code": code, "parameters": {"threshold": x}} for x in (3.0, 8.0)],
        "vary": ({"field": "start.velocity.0", "from": 0.3, "to": 0.65},),
        "scatter": {"mass": 0.05},
    }  # fmt: skip
    return Plan(**given | others)


def test_own_pilots_are_judged_in_lanes_as_alone(folder: Path) -> None:
    """Eight at a time, compiled; alone in plain Python: verdicts, alarms and parameters the same.

    One that cannot be built is refused, and no other.
    """
    pilot = {"code": f"{pilot_file(folder)}:guard", "parameters": {"threshold": 5.0}}
    plan = Plan(
        method="random", samples=24, seed=3, scenario=before_a_wall(pilot),
        vary=(
            {"field": "pilot.parameters.threshold", "values": [3.0, 4.0, 5.0, 6.0, 8.0, 2e4]},
            {"field": "start.velocity.0", "from": -0.1, "to": 0.65},
        ),
    )  # fmt: skip
    campaign = run_campaign(plan, folder / "out", workers=1, chunk=24)
    rows = campaign.query("FROM flights ORDER BY flight").as_dicts()
    assert {row["outcome"] for row in rows} == {
        "recovered", "not_settled", "no_contact", "refused",
    }  # fmt: skip
    assert len({row["detection_delay"] for row in rows}) > 3
    flying = [row for row in rows if row["outcome"] != "refused"]
    for row, tables in zip(rows, lay_out(plan).slice(0, 24).tables, strict=True):
        assert tables["pilot"]["parameters"]["threshold"] == row["pilot.parameters.threshold"]
        assert (row["outcome"] == "refused") == (row["pilot.parameters.threshold"] == 2e4)
        if row["outcome"] == "refused":
            assert "ValueError: a threshold of 20000" in row["problem"]
            continue
        flight = springback.fly(tables, executor="python")
        assert flight.outcome.word == row["outcome"]
        for name, value in nonempty(flight.measures.items()):
            assert row[name] == value, name
    assert not campaign.refly(rows.index(flying[-1])).differences


def test_pilots_of_a_plan_are_compared_pair_by_pair(folder: Path) -> None:
    """In a random design, with the same samples, scatter and noise for each of them."""
    campaign = run_campaign(_guards(folder), folder / "out", workers=1)
    names = ["quad with guard threshold 3", "quad with guard threshold 8"]
    rows = campaign.query("FROM flights ORDER BY flight").as_dicts()
    assert [row["robot"] for row in rows] == names * 12
    for first, second in nonempty(zip(rows[::2], rows[1::2], strict=True)):
        for shared in ("sample", "seed", "start.velocity[0]", "scatter_mass_factor", "touch_time"):
            assert first[shared] == second[shared], shared
        assert first["detection_delay"] < second["detection_delay"]
    assert len({row["seed"] for row in rows}) == 12
    [pair] = summary(campaign).pairs
    assert (pair.names, pair.pairs) == (tuple(names), 12)
    count, median = pair.medians["detection_delay"]
    assert count == 12
    assert median.value is not None
    assert median.value < 0.0
    assert not campaign.refly(23).differences


def test_each_vehicle_flies_with_each_pilot(folder: Path) -> None:
    pilot_file(folder)
    (folder / "flight.toml").write_text(
        'vehicle = "arq"\n[reference]\ntype = "hold"\n[recovery]\nhome = [0, 0, 1]\n'
    )
    (folder / "plan.toml").write_text(
        'method = "sobol"\nsamples = 4\nscenario = "flight.toml"\nrobots = ["arq", "heavy.toml"]\n'
        'pilots = ["springback", "guards.py:mute", { code = "guards.py:guard", name = "mine" }]\n'
        '[[vary]]\nfield = "world.gravity"\nfrom = 9.7\nto = 9.9\n'
    )
    design = lay_out(_plan(folder))
    assert design.robots == (
        "arq with springback", "arq with mute", "arq with mine",
        "heavy with springback", "heavy with mute", "heavy with mine",
    )  # fmt: skip
    tables = design.slice(0, 6).tables
    assert [("pilot" in one, one["vehicle"].get("name")) for one in tables[::3]] == [
        (False, None), (False, "heavy"),
    ]  # fmt: skip
    assert [one["pilot"]["code"] for one in tables[1:3]] == [
        f"{folder}/guards.py:mute", f"{folder}/guards.py:guard",
    ]  # fmt: skip
    assert len({one["world"]["gravity"] for one in tables}) == 1
    assert len({one["seed"] for one in tables}) == 1
    assert [*design.code] == [str(folder / "guards.py")]
    try_code(design)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"pilots": ["springback"]}, r"pilots\[0\]: springback's pilot needs a \[reference\]"),
        ({"pilots": ["nix"]}, r"pilots\[0\].code: must be FILE.py:NAME \(got 'nix'\)"),
        ({"pilots": [{"parameters": {"a": 1}}]}, r"pilots\[0\].parameters: belong to a pilot of"),
        (
            {"pilots": ["mine.py:hover", "guards.py:hover"]},
            r"pilots\[1\].name: is that of another pilot, 'hover'; give another",
        ),
        ({"pilots": ["none.py:hover"]}, r"none.py: there is no such file"),
        ({"vary": [{"field": "pilot", "values": ["mine.py:hover"]}]}, "name pilots under pilots"),
        (
            {"pilots": [{"code": "guards.py:guard", "parameters": {"threshold": 1}},
                        "guards.py:mute"],
             "vary": [{"field": "pilot.parameters.threshold", "from": 1, "to": 2, "count": 2}]},
            r"vary\[0\].field: unknown parameter 'threshold'; the code is given none",
        ),
    ],
)  # fmt: skip
def test_pilots_that_are_none_are_refused(folder: Path, changes: dict[str, Any], said: str) -> None:
    pilot_file(folder)
    given = {"method": "grid", "scenario": str(folder / "flight.toml"), **changes}
    with pytest.raises(InputError, match=said), contextlib.chdir(folder):
        run_campaign(Plan(**given), folder / "out")
    assert not (folder / "out").exists()


@pytest.mark.parametrize(
    ("robots", "said"),
    [
        (["heavy.toml", "other.toml"], "has the name of another vehicle, 'heavy'"),
        (["arq.toml"], "has the name of another vehicle, 'arq'"),
        (["none.toml"], r"plan.toml:4: robots\[0\]: .*none.toml: cannot be read"),
        (["nix"], "unknown vehicle preset 'nix'"),
    ],
)
def test_vehicles_that_are_none_are_refused(folder: Path, robots: list[str], said: str) -> None:
    (folder / "other.toml").write_text('preset = "quad"\nname = "heavy"\n')
    (folder / "arq.toml").write_text('preset = "arq"\n')
    (folder / "plan.toml").write_text(PLAN.replace('["arq", "heavy.toml"]', repr(robots)))
    with pytest.raises(InputError, match=said):
        lay_out(_plan(folder))


def test_a_map_takes_vehicle_files_and_pilots(folder: Path) -> None:
    plan = plan_envelope(
        "speed=2:3:2", robots=["quad", str(folder / "heavy.toml")],
        settings=[f"pilot={folder}/mine.py:hover"],
    )  # fmt: skip
    assert plan.design.robots == ("quad", "heavy")
    assert plan.corners[1]["vehicle"]["body"]["mass"] == 0.9
    for name in ("own_detector.py", "own_estimator.py"):
        shutil.copy(EXAMPLES / name, folder)
    own = plan_envelope("speed=2:3:2", settings=[
        "estimator.type=own", f"estimator.code={folder}/own_estimator.py:blend",
        f"recovery.detection.own.code={folder}/own_detector.py:jolt",
    ]).design  # fmt: skip
    try_code(own)
    assert {Path(path).name for path in own.code} == {"own_detector.py", "own_estimator.py"}
    settings = [f"pilot={pilot_file(folder)}:guard", "pilot.parameters={ threshold = 5.0 }"]
    over = plan_envelope("pilot.parameters.threshold=2:8:3", "speed=2:3:2", settings=settings)
    pilots = [over.tables(over.flight(sample, 0))["pilot"] for sample in (0, 2, 4)]
    assert [pilot["parameters"]["threshold"] for pilot in pilots] == [2.0, 5.0, 8.0]
    assert {pilot["code"] for pilot in pilots} == {f"{folder}/guards.py:guard"}
    with pytest.raises(InputError, match=r"mine.py: has no 'nix'"):
        plan_envelope("speed=2:3:2", settings=[f"pilot={folder}/mine.py:nix"])
    with pytest.raises(InputError, match=r"none.toml: cannot be read"):
        plan_envelope("speed=2:3:2", robots=["none.toml"])
