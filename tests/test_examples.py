"""Examples do what they say, and what README and documentation say to type is typed here.

Each page is followed in an empty folder.  What takes minutes, needs another machine or waits for a
person is only looked at: its options must exist and its values be of the right kind.  `LOOKED_AT`
says why, and where it is run in earnest.
"""

from __future__ import annotations

import contextlib
import inspect
import re
import runpy
import shlex
import shutil
import tomllib
from pathlib import Path
from typing import Any

import click
import numpy as np
import pytest

import springback
from builders.campaign_folders import filled
from builders.plans import PITCH, SPEED, SURFACE, WALL
from builders.typed_lines import Typed, typed
from springback.campaign.design.plan import Plan, read_plan
from springback.campaign.running import run_campaign
from springback.identification.settings import FitPlan
from springback.interfaces.cli.app import cli
from springback.logs.reading import read_recording
from springback.vehicle.materials import MATERIALS
from springback.vehicle.stiffness import ring_stiffness, rod_second_moment

ROOT = Path(__file__).parents[1]
PAGES = [
    ROOT / "README.md",
    *sorted(p for p in (ROOT / "docs").rglob("*.md") if not {"_build", "decisions"} & {*p.parts}),
]
#: Commands that are not run, and why.
LOOKED_AT = {
    "reproduce": "minutes; tests/paper flies what it compares",
    "study": "minutes; tests/studies/test_ablation.py and test_detection_study.py",
    "map": "a minute; tests/interfaces/cli/test_map_command.py",
    "campaign": "thousands of flights; tests/interfaces/cli/test_campaign_commands.py",
    "refly": "needs such a campaign; tests/interfaces/cli/test_campaign_commands.py",
    "check": "thousands of ticks in plain Python; tests/test_examples.py",
    "view": "serves until it is stopped; tests/interfaces/replay/test_view.py",
    "lab": "serves until it is stopped; tests/interfaces/lab/test_lab_served.py",
    "animate": "half a minute; tests/interfaces/animation/test_animation.py",
}
#: Commands that come with other parts of the program.
AWAITED: set[str] = set()
#: Programs of others: not ours to test.
OTHERS = {"pip", "dask", "uv", "make", "git"}
#: Flights that are shorter here than on the page: 20 s and 4 s of closed loop.
SHORTER = {"steps.toml": "simulation.duration=0.2", "run_up.toml": "simulation.duration=0.2"}
#: Scenarios that are read and checked with their overrides, but not flown, and why.
READ = {
    "collision.toml": "compiles for a minute or two; tests/paper/test_resilience.py flies it",
    "pole.toml": "the same among shapes; tests/studies/test_shape_collisions.py flies such",
    "swinging_ball.toml": "compiles for minutes; tests/simulation/test_hit_while_hovering.py flies it",
}
#: Python that is not run, by a word in it, and why.
NOT_RUN = {"dask_jobqueue": "needs a Slurm cluster"}


# -- examples --------------------------------------------------------------------------------------


def test_own_obstacle_example_hits_the_pole() -> None:
    flight = runpy.run_path(str(ROOT / "examples/own_obstacle.py"))["main"]()
    assert flight.outcome is springback.Outcome.SEPARATED
    assert flight.touch_speed == pytest.approx(2.0, rel=1e-6)


def test_scenario_of_the_readme_flies_as_shown(tmp_path: Path) -> None:
    text = (ROOT / "README.md").read_text()
    scenario = re.search(r"```toml\n(.*?)```", text, re.S)
    assert scenario is not None
    path = tmp_path / "scenario.toml"
    path.write_text(scenario[1])
    plain, soft = springback.fly(path), springback.fly(path, "vehicle.arms.stiffness=2 N/mm")
    ahead = springback.fly(path, "start.yaw=45 deg")
    rigid = springback.fly(path, "vehicle.arms.compliant=false")
    assert plain.outcome is soft.outcome is rigid.outcome is springback.Outcome.SEPARATED
    told = [round(flight.impact_peak_acceleration) for flight in (ahead, plain, soft)]
    assert told == [103, 291, 288]  # friction holds two arms at 45 deg, however soft
    assert f"{told[0]} instead of {told[1]}" in text
    assert plain.impact_arm_stroke == pytest.approx(2.5e-3, abs=5e-5)
    assert ahead.impact_arm_stroke > 7.0 * plain.impact_arm_stroke
    assert plain.impact_peak_acceleration < rigid.impact_peak_acceleration
    assert len(plain.to_dataframe()) == len(plain.to_xarray()["t"]) == len(plain.t)


def test_example_scenario_flies() -> None:
    flight = springback.fly(ROOT / "examples/arq_wall.toml")
    assert "hit an obstacle" in repr(flight)


def test_the_hexarotor_bears_with_its_springs_what_it_does_not_without() -> None:
    """And what its comments derive from materials of the library is that."""
    soft = springback.fly(ROOT / "examples/hexarotor.toml")
    rigid = springback.fly(ROOT / "examples/hexarotor.toml", "vehicle.arms.compliant=false")
    assert soft.scenario.vehicle.mass == pytest.approx(0.6)
    assert soft.outcome is springback.Outcome.SEPARATED
    assert rigid.outcome is springback.Outcome.BROKEN
    assert soft.impact_arm_stroke == pytest.approx(0.025, rel=0.05)
    assert soft.impact_peak_acceleration < 0.4 * rigid.impact_peak_acceleration
    [wall] = soft.scenario.world.obstacles
    young, drywall = MATERIALS["carbon"].young, MATERIALS["drywall"]
    assert young is not None
    assert drywall.restitution is not None
    assert drywall.friction is not None
    ring = ring_stiffness(young.typical, rod_second_moment(3e-3), 0.07)
    assert wall.surface.stiffness == pytest.approx(ring, rel=1e-3)
    assert wall.surface.restitution == pytest.approx(drywall.restitution.typical, abs=1e-3)
    assert wall.surface.friction == pytest.approx(drywall.friction.typical, abs=1e-3)


def test_steps_and_run_up_fly_from_an_empty_folder(tmp_path: Path) -> None:
    for name in ("steps", "run_up"):
        shutil.copy(ROOT / f"examples/{name}.toml", tmp_path)
    steps = springback.fly(tmp_path / "steps.toml")
    last = [steps.columns[axis][-1] for axis in "xyz"]
    assert last == pytest.approx([1.0, 1.0, 2.0], abs=0.02)
    run_up = springback.fly(tmp_path / "run_up.toml")
    # The rotors' lag, sensors and gains leave this much of the 2 m/s to chance.
    assert run_up.touch_speed == pytest.approx(2.0, abs=0.05)


def test_the_two_vehicles_of_the_example_meet_and_the_first_recovers() -> None:
    first = springback.fly(ROOT / "examples/pair.toml")
    second = first.second
    assert second is not None
    assert first.outcome is springback.Outcome.RECOVERED
    assert first.touch_speed == pytest.approx(1.46, abs=0.01)
    assert second.measures["contacts"] >= 1.0


@pytest.mark.parametrize(("aside", "outcome"), [(0.0, "no_contact"), (0.1, "separated")])
def test_the_pilot_gets_through_the_doorway_of_the_example(aside: float, outcome: str) -> None:
    """Beside its way by more than the 5.5 cm that are to spare, with contact."""
    flight = springback.fly(
        ROOT / "examples/doorway.toml", f"world.obstacles.0.position=[3, {aside}, 0]"
    )
    assert flight.outcome.word == outcome
    assert flight.columns["x"][-1] > 3.5


def test_own_pilots_hover_alike_plain_and_compiled(tmp_path: Path) -> None:
    flights = []
    for name in ("own_pilot", "own_pilot_compiled"):
        shutil.copy(ROOT / f"examples/{name}.py", tmp_path)
        flights.append(runpy.run_path(str(tmp_path / f"{name}.py"))["main"]())
    for flight in flights:
        last = [flight.columns[axis][-1] for axis in "xyz"]
        assert last == pytest.approx([0.0, 0.0, 1.0], abs=0.01)
    # NumPy sums in another order than the formulas do: a few rounding errors, which feedback damps.
    for axis in "xyz":
        assert np.abs(flights[0].columns[axis] - flights[1].columns[axis]).max() < 1e-9


def test_own_pilots_keep_to_what_every_pilot_should() -> None:
    findings = springback.check_pilot(f"{ROOT / 'examples/own_pilot_compiled.py'}:hover")
    assert [finding.name for finding in findings if not finding.passed] == []
    assert findings[-1].name == "compiles to the same flight"


# -- pages -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("page", ["README.md", "docs/howto/campaigns.md"])
def test_the_row_to_be_flown_again_is_one_of_the_example(page: str) -> None:
    plan, _ = read_plan(ROOT / "examples/campaign.toml")
    rows = re.findall(r"springback refly \w+ (\d+)", (ROOT / page).read_text())
    assert rows
    assert max(map(int, rows)) < plan.samples * plan.repeats * len(plan.robots)


def options_exist(words: list[str]) -> None:
    """Parse a command line as the program would, and leave it at that."""
    group: Any = cli
    context = click.Context(cli, info_name="springback")
    while isinstance(group, click.Group):
        name, group, words = group.resolve_command(context, words)
        if isinstance(group, click.Group):
            context = group.make_context(name, words[:0], parent=context, resilient_parsing=True)
    group.make_context(name, list(words), parent=context)


@pytest.fixture(scope="module")
def campaign(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of rows that no flight made, with all columns of a campaign."""
    folder = tmp_path_factory.mktemp("campaign") / "results"
    stiffness = {"field": "stiffness", "from": "1 N/mm", "to": "9 N/mm"}
    damping = {"field": "damping", "from": "5 N s/m", "to": "50 N s/m"}
    filled(folder, parts=2, size=8, vary=[SPEED, PITCH, SURFACE, stiffness, damping, WALL])
    return folder


class Reader:
    """Somebody who follows a page."""

    def __init__(self, folder: Path, campaign: Path) -> None:
        self.folder, self.campaign = folder, campaign
        self.names: dict[str, Any] = {"__name__": "__main__"}
        shutil.copytree(ROOT / "examples", folder / "examples")
        for example in (ROOT / "examples").iterdir():
            if example.is_file():
                shutil.copy(example, folder)

    def run(self, this: Typed) -> None:
        getattr(self, this.kind)(this)

    def toml(self, this: Typed) -> None:
        """A plan, a scenario, or a part of one, which is laid over the plan before or a plain scenario."""
        plan = self.folder / "campaign.toml"
        more = re.match(r"success =", this.text)
        if more or "[[vary]]" in this.text:
            plan.write_text(f"{this.text}\n{plan.read_text()}" if more else this.text)
            read_plan(plan)
            return
        tables = tomllib.loads(this.text)
        if tables.keys() & {
            "free",
            "known",
            "compare",
            "experiment",
        } or "accelerometer" in tables.get("sensors", {}):
            FitPlan.model_validate(
                {"scenario": "a.toml", "free": {"start.roll": "+- 1 deg"}} | tables
            )
            return
        if re.search(
            r"^(pilots|posterior|overlay) =|^\[posterior", this.text, re.M
        ):  # of the reader's own; they are not on the page
            assert tomllib.loads(this.text).keys() <= Plan.model_fields.keys()
            return
        if "[[channels]]" in this.text:  # of a mapping file
            (self.folder / this.saved_as).write_text(this.text)
            read_recording(self.folder / this.saved_as)
            return
        whole = re.search(r"^vehicle =|^\[vehicle\]", this.text, re.M)
        path = self.folder / (this.saved_as or "scenario.toml")
        path.write_text(this.text if whole else f'vehicle = "arq"\n{this.text}')
        springback.read_scenario(path)

    def text(self, this: Typed) -> None:
        """What the page says that a flight of its scenario says."""
        assert repr(springback.fly("scenario.toml")) == this.text

    def python(self, this: Typed) -> None:
        if any(word in this.text for word in NOT_RUN):
            compile(this.text, "page", "exec")
            return
        path = self.folder / f"line_{this.line}.py"
        path.write_text(this.text)
        exec(compile(this.text, str(path), "exec"), self.names)

    def words(self, this: Typed) -> None:
        """A command in a sentence; capitals and dots stand for something else."""
        if not re.search(r"[A-Z…]{2}|…|\.\.\.", this.text):
            with contextlib.suppress(click.MissingParameter):
                self.look_at(shlex.split(this.text, comments=True)[1:])

    def look_at(self, words: list[str]) -> None:
        if words[0] in AWAITED and words[0] not in cli.commands:
            return
        options_exist(words)

    def shell(self, this: Typed) -> None:
        words = shlex.split(this.text, comments=True)
        if not words:
            return
        if words[:2] == ["python", "-m"]:
            places = [root / words[2].replace(".", "/") for root in (ROOT, ROOT / "src")]
            found = [one for one in places if one.with_suffix(".py").is_file() or one.is_dir()]
            assert found, this.text
            return
        if words[0] == "python":
            assert (ROOT / words[1]).is_file(), this.text
            return
        if words[0] == "make":
            assert re.search(rf"^{words[1]}:", (ROOT / "Makefile").read_text(), re.M), this.text
        if words[0] in OTHERS:
            return
        assert words[0] == "springback", f"line {this.line}: {this.text}"
        if words[1] == "examples":
            words += ["--force"]  # they are here already
        if words[1] in LOOKED_AT:
            self.look_at(words[1:])
            return
        if words[1] in ("query", "summary"):
            words[2] = str(self.campaign)
            words += ["--no-figures"] if words[1] == "summary" else []
        if words[1] == "fly" and Path(words[2]).name in READ:
            self.look_at(words[1:])
            overrides = [word for word in words[3:] if re.match(r"[\w.]+=", word)]
            springback.read_scenario(words[2], overrides)
            return
        if words[1] == "fly":
            words += ["--no-figures", "--force"]
            words += [SHORTER[Path(words[2]).name]] if Path(words[2]).name in SHORTER else []
        cli.main(words[1:], prog_name="springback", standalone_mode=False)


@pytest.mark.parametrize("page", PAGES, ids=lambda p: str(p.relative_to(ROOT)))
def test_what_a_page_says_to_type_works(
    page: Path, tmp_path: Path, campaign: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    reader = Reader(tmp_path, campaign)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))  # `trust` is not for good
    monkeypatch.setattr(springback, "run_campaign", looked_at_campaign(campaign))
    for this in typed(page):
        try:
            reader.run(this)
        except Exception as error:
            raise AssertionError(f"{page.name}, line {this.line}: {this.text}") from error


def looked_at_campaign(folder: Path) -> Any:
    """In place of `run_campaign`, which flies for minutes: the plan is checked, rows are there."""

    def stands_in(*arguments: Any, **named: Any) -> springback.Campaign:
        given = inspect.signature(run_campaign).bind(*arguments, **named)
        assert isinstance(given.arguments["plan"], springback.Plan)
        return springback.Campaign(folder)

    return stands_in


def test_pages_do_say_something_to_type() -> None:
    """Against a reader that overlooks everything."""
    found = [this for page in PAGES for this in typed(page)]
    assert sum(this.kind == "shell" for this in found) > 60
    assert sum(this.kind == "python" for this in found) >= 10
    assert sum(this.kind == "toml" for this in found) > 6
    assert sum(this.text.startswith("springback fly") for this in found) > 15
