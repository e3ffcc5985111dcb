"""Plans: points of designs, where values go, and what is refused before anything is flown."""

from __future__ import annotations

import json
import math
from collections import Counter
from pathlib import Path
from typing import Any

import duckdb
import numpy as np
import pytest
import scipy.stats

from builders.cases import nonempty
from builders.plans import PITCH, SPEED, SURFACE, THROW, plan
from springback.campaign.design import sampling
from springback.campaign.design.layout import Design, design_of, lay_out
from springback.campaign.design.plan import Plan, Source, plan_from, read_plan
from springback.campaign.design.sampling import POINTS, grid_point, seeds
from springback.errors import InputError
from springback.results.flight import Flight
from springback.scenario.scenario import scenario_from
from springback.simulation.measuring.measures import Outcome
from springback.studies.trials import HOME, Scatter, TrialNoise, trial_tables

ELASTIC = THROW | {
    "world": {"obstacles": [{"type": "wall", "distance": 2.75, "surface": {"law": "hertz"}}]}
}
REBOUND = {"field": "world.obstacles.0.surface.restitution", "from": 0.3, "to": 0.6}
METHODS = ("random", "latin-hypercube", "sobol")


def columns(design: Design, *names: str) -> list[np.ndarray[Any, Any]]:
    dealt = design.slice(0, design.flights)
    return [np.array(dealt.columns[name]) for name in names]


# -- points ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("method", METHODS)
def test_any_stretch_of_rows_is_that_of_the_whole(method: str) -> None:
    whole = POINTS[method](5, 64, 7, 0, 64)
    assert whole.shape == (64, 7)
    assert 0.0 <= whole.min() < 0.1
    assert 0.9 < whole.max() < 1.0
    for first, count in ((0, 1), (1, 1), (17, 20), (63, 1), (31, 33)):
        part = POINTS[method](5, 64, 7, first, count)
        assert np.array_equal(part, whole[first : first + count])
    assert not np.array_equal(POINTS[method](6, 64, 7, 0, 64), whole)


def test_every_layer_of_a_latin_hypercube_holds_one_point() -> None:
    points = POINTS["latin-hypercube"](1, 50, 4, 0, 50)
    for k in range(4):
        assert sorted(np.floor(points[:, k] * 50).astype(int)) == list(range(50))
    assert abs(np.corrcoef(points.T)[0, 1]) < 0.5


def test_sobol_points_fill_space_better_than_chance() -> None:
    told = {m: scipy.stats.qmc.discrepancy(POINTS[m](2, 256, 5, 0, 256)) for m in METHODS}
    assert told["sobol"] < 0.2 * told["random"]
    assert sampling.sobol_points(2, 1, 0, 0, 3).shape == (3, 0)


def test_a_grid_has_every_combination_once() -> None:
    sizes = (3, 1, 4)
    points = [grid_point(k, sizes) for k in range(12)]
    assert sorted(points) == sorted(set(points))
    assert points[:5] == [(0, 0, 0), (0, 0, 1), (0, 0, 2), (0, 0, 3), (1, 0, 0)]


def test_seeds_of_samples_and_repeats_differ_and_survive_json() -> None:
    found = np.concatenate([seeds(4, repeat, 0, 500) for repeat in range(3)])
    assert len(set(found.tolist())) == 1500
    assert 2**40 < found.max() < 2**53
    assert np.array_equal(seeds(4, 1, 100, 3), seeds(4, 1, 0, 500)[100:103])


# -- flights --------------------------------------------------------------------------------------


@pytest.mark.parametrize("method", METHODS)
def test_any_stretch_of_flights_is_that_of_the_whole(method: str) -> None:
    design = lay_out(plan(method=method, repeats=3, scatter="trials"))
    whole = design.slice(0, design.flights)
    assert len(whole.tables) == design.flights == 12 * 3 * 2
    for first, last in ((0, 1), (5, 6), (7, 40), (71, 72)):
        part = design.slice(first, last)
        assert part.tables == whole.tables[first:last]
        assert part.columns == {k: v[first:last] for k, v in whole.columns.items()}
    again = design_of(design.plan.canonical())
    assert again.slice(3, 9) == design.slice(3, 9)


def test_robots_are_dealt_the_same_and_repeats_new_luck() -> None:
    design = lay_out(plan(repeats=2, scatter="trials"))
    flight, sample, repeat, robot = columns(design, "flight", "sample", "repeat", "robot")
    assert flight.tolist() == list(range(48))
    assert sample.tolist() == [k // 4 for k in range(48)]
    assert repeat.tolist() == [0, 0, 1, 1] * 12
    assert robot.tolist() == ["arq", "quad"] * 24
    for name in ("seed", "speed", "surface", "scatter_heading", "scatter_mass_factor"):
        [values] = columns(design, name)
        pairs = values.reshape(12, 2, 2)
        assert np.array_equal(pairs[..., 0], pairs[..., 1]), name  # robots
        varied = name in ("speed", "surface")
        assert np.array_equal(pairs[:, 0], pairs[:, 1]) == varied, name  # repeats


def test_tables_that_are_alike_are_the_same_object() -> None:
    design = lay_out(plan(repeats=2, vary=[SURFACE, {"field": "stiffness", "values": [5e3, 6e3]}]))
    tables = design.slice(0, design.flights).tables
    assert len({id(one["vehicle"]) for one in tables}) <= 4
    assert len({id(one["world"]) for one in tables}) == 2
    assert len({id(one["start"]) for one in tables}) == 1
    ground = {id(one["world"]["obstacles"][1]) for one in tables}
    assert len(ground) == 1


def test_values_arrive_in_the_scenario() -> None:
    design = lay_out(plan(method="sobol", samples=8))
    dealt = design.slice(0, design.flights)
    for k, tables in nonempty(enumerate(dealt.tables)):
        scenario = scenario_from(tables)
        row = {name: values[k] for name, values in dealt.columns.items()}
        assert scenario.start.velocity == (row["speed"], 0.0, 0.0)
        assert scenario.start.pitch == row["pitch"]
        assert scenario.seed == row["seed"]
        own = scenario_from(THROW | {"vehicle": row["robot"]})
        stiffness = own.vehicle.arms.stiffness * row["stiffness_factor"]
        assert scenario.vehicle.arms.stiffness == stiffness
        wall = scenario.world.obstacles[0]
        assert wall.position == (1.0, 0.0, 0.0)
        angle = row["wall_angle"]
        assert wall.normal == pytest.approx((-math.cos(angle), -math.sin(angle), 0.0), abs=1e-15)
        assert (wall.surface.stiffness == own.world.obstacles[0].surface.stiffness) == (
            row["surface"] == "wall"
        )


def test_a_table_does_not_wipe_out_what_is_varied_within_it() -> None:
    vary = [
        {"field": "wall angle", "values": [0.1]},
        {"field": "friction", "values": [0.77]},
        SURFACE,
    ]
    design = lay_out(plan(method="grid", samples=None, robots=[], vary=vary))
    assert list(design.units) == ["wall_angle", "friction", "surface"]
    walls = [scenario_from(one).world.obstacles[0] for one in design.slice(0, 2).tables]
    assert [wall.surface.friction for wall in walls] == [0.77, 0.77]
    assert walls[0].surface.stiffness != walls[1].surface.stiffness
    assert [wall.normal[1] for wall in walls] == [-math.sin(0.1)] * 2


def test_scatter_is_that_of_trials() -> None:
    """The tables of a trial whose random numbers are those of a row."""
    base = trial_tables("arq", 0.0, 2.0, TrialNoise(HOME, (0.0,) * 3, 0.0, 2.75, 0.0, 1.0, 1.0, (1.0,) * 5, 0))  # fmt: skip
    base["world"]["obstacles"][0] = {"type": "wall", "distance": 2.75, "surface": "wall"}
    design = lay_out(plan(scenario=base, robots=[], vary=[], scatter="trials", samples=3))
    dealt = design.slice(0, 3)
    row = {name: values[1] for name, values in dealt.columns.items()}
    axes = [("position", HOME), ("velocity", (0.0,) * 3)]
    place, velocity = (
        tuple(h + row[f"scatter_{name}_{axis}"] for h, axis in zip(middle, "xyz", strict=True))
        for name, middle in axes
    )
    gains = ("stiffness", "vertical_stiffness", "damping_ratio", "time_constant", "rate_gain")
    noise_stream = TrialNoise(
        place, velocity, row["scatter_heading"], 2.75 + row["scatter_wall_distance"],
        row["scatter_wall_yaw"], row["scatter_mass_factor"], row["scatter_inertia_factor"],
        tuple(row[f"scatter_{name}_factor"] for name in gains), row["seed"],
    )  # fmt: skip
    ours, theirs = (
        scenario_from(dealt.tables[1]),
        scenario_from(trial_tables("arq", 0.0, 2.0, noise_stream)),
    )
    assert ours.start_state() == theirs.start_state()
    assert ours.reference == theirs.reference
    assert ours.control == theirs.control
    assert ours.model_error == theirs.model_error
    for one, other in zip(ours.world.obstacles[:1], theirs.world.obstacles[:1], strict=True):
        assert one.position[0] == other.position[0]
        assert one.normal == pytest.approx(other.normal, abs=1e-16)


def test_scatter_has_the_deviations_it_says() -> None:
    dealt = Scatter(position=0.5, mass=0.1, wall_yaw=0.0)
    scatter = {k: v for k, v in dealt._asdict().items() if k in ("position", "mass")}
    design = lay_out(plan(samples=4000, robots=[], vary=[], scatter=scatter))
    x, z, mass = columns(
        design, "scatter_position_x", "scatter_position_z", "scatter_mass_factor"
    )  # fmt: skip
    assert np.std(x) == pytest.approx(0.5, rel=0.05)
    assert abs(np.corrcoef(x, z)[0, 1]) < 0.05
    assert np.std(np.log(mass)) == pytest.approx(0.1, rel=0.05)
    assert "scatter_wall_yaw" not in design.units


def test_laws_give_what_they_say() -> None:
    vary = [
        SPEED | {"spacing": "logarithmic"},
        {"field": "control.stiffness", "normal": {"deviation": "1 N/m"}},
        {"field": "control.rate_gain", "factor": {"from": 0.5, "to": 1.5}},
        {"field": "friction", "from": 0.2, "to": 0.6, "step": 0.2},
        {"field": "start.yaw", "normal": {"mean": "90 deg", "deviation": "2 deg"}},
    ]
    design = lay_out(plan(method="latin-hypercube", samples=2000, robots=[], vary=vary))
    speed, stiffness, gain, friction, yaw = columns(
        design, "speed", "control.stiffness", "control.rate_gain_factor", "friction", "yaw"
    )
    assert np.median(speed) == pytest.approx(math.sqrt(3.0), rel=1e-3)
    assert (np.mean(stiffness), np.std(stiffness)) == pytest.approx((9.25, 1.0), rel=1e-2)
    assert (gain.min(), gain.max(), gain.mean()) == pytest.approx((0.5, 1.5, 1.0), rel=1e-2)
    assert Counter(friction.tolist()).keys() == {0.2, 0.4, 0.6}
    assert np.degrees([np.mean(yaw), np.std(yaw)]) == pytest.approx([90.0, 2.0], rel=1e-2)
    assert design.units == {
        "speed": "m/s", "control.stiffness": "N/m", "control.rate_gain_factor": "",
        "friction": "", "yaw": "rad",
    }  # fmt: skip


def test_a_grid_counts_its_points_and_draws_what_has_no_levels() -> None:
    vary = [SPEED | {"count": 3}, SURFACE, {"field": "stiffness", "factor": {"deviation": 0.1}}]
    design = lay_out(plan(method="grid", samples=None, repeats=5, vary=vary))
    assert (design.samples, design.flights) == (6, 60)
    speed, surface, factor = columns(design, "speed", "surface", "stiffness_factor")
    points = Counter(zip(speed.tolist(), surface.tolist(), strict=True))
    assert points == {(v, s): 10 for v in (1.0, 2.0, 3.0) for s in ("wall", "mat")}
    assert len(set(factor.tolist())) == 30


def test_a_speed_needs_a_run_up_and_says_so() -> None:
    with pytest.raises(
        InputError,
        match=r"'speed' needs a reference of type run-up; for a throw vary start\.velocity\.0",
    ):
        lay_out(plan(vary=[{"field": "speed", "from": 1.0, "to": 2.0}]))


def test_robots_replace_a_vehicle_of_the_users_own() -> None:
    """All of it; the changes to a preset are kept for each."""
    own = scenario_from({"vehicle": "arq"}).vehicle.model_dump() | {"name": "mine"}
    base = {**THROW, "vehicle": own}
    design = lay_out(plan(scenario=base, robots=["arq", "quad"], samples=2))
    assert [base["vehicle"]["preset"] for base in design.bases] == ["arq", "quad"]
    changed = {**THROW, "vehicle": {"preset": "arq", "body": {"mass": 0.9}}}
    design = lay_out(plan(scenario=changed, robots=["arq", "quad"], samples=2))
    assert [base["vehicle"]["body"]["mass"] for base in design.bases] == [0.9, 0.9]


def test_own_values_are_each_robots() -> None:
    vary = [{"field": "mass", "normal": {"deviation": "10 g"}}]
    design = lay_out(plan(vary=vary))
    robot, mass = columns(design, "robot", "mass")
    own = {
        name: scenario_from(THROW | {"vehicle": name}).vehicle.body.mass for name in design.robots
    }
    assert own["arq"] != own["quad"]
    off = mass - np.array([own[name] for name in robot])
    assert off[0::2] == pytest.approx(off[1::2], abs=1e-12)
    assert 0.0 < np.abs(off).max() < 0.05


# -- the plan itself ------------------------------------------------------------------------------


@pytest.mark.parametrize("recovery", [False, True])
def test_success_means_the_same_of_a_flight_and_of_its_row(recovery: bool) -> None:
    """Whatever the outcome: without recovery, to end on the ground is none of either."""
    pilot = {"reference": {"type": "hold"}, "recovery": {}} if recovery else {}
    tables = {key: value for key, value in THROW.items() if not (recovery and key == "thrust")}
    rule = lay_out(plan(scenario=tables | pilot)).success
    scenario = scenario_from(tables | pilot)
    measures: dict[str, float | None] = {"runs": 1.0} if recovery else {}
    found = {}
    for outcome in Outcome:
        row = f"SELECT {rule} FROM (SELECT '{outcome.word}' AS outcome)"
        [(found[outcome],)] = duckdb.sql(row).fetchall()
        assert Flight(scenario, outcome, measures, {}, {}).success is found[outcome], outcome
    assert not found[Outcome.HIT_GROUND]
    assert found[Outcome.RECOVERED]
    assert found[Outcome.SEPARATED] is not recovery


def test_the_hash_is_of_all_that_decides_the_rows() -> None:
    base = plan()
    assert plan().digest() == base.digest()
    assert plan(name="other", keep={"where": "true"}).digest() == base.digest()
    for given in ({"seed": 4}, {"samples": 13}, {"repeats": 2}, {"scatter": "trials"}, {"robots": ["arq"]}):  # fmt: skip
        assert plan(**given).digest() != base.digest()
    again = plan_from(json.loads(base.canonical()))
    assert again == base
    assert again.canonical() == base.canonical()


def test_a_plan_file_names_its_scenario_and_takes_overrides(tmp_path: Path) -> None:
    (tmp_path / "throw.toml").write_text('vehicle = "arq"\nthrust = "hover"\n')
    path = tmp_path / "plan.toml"
    path.write_text('scenario = "throw.toml"\nmethod = "random"\nsamples = 5\n')
    read, _ = read_plan(path, ("samples=7", "robots=[quad]".replace("quad", '"quad"')))
    assert (read.samples, read.robots, read.scenario) == (7, ("quad",), {"vehicle": "arq", "thrust": "hover"})  # fmt: skip
    path.write_text('scenario = "thrw.toml"\nmethod = "random"\nsamples = 5\n')
    with pytest.raises(InputError, match=r"plan.toml:1: scenario: there is no file .*thrw.toml"):
        read_plan(path)


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"vary": [{"field": "sped", "values": [1]}]}, r"vary\[0\].field: unknown .*speed"),
        ({"vary": [SPEED | {"from": "1 kg"}]}, r"vary\[0\].from: has the wrong unit .*m/s"),
        ({"method": "grid"}, "samples: cannot be given"),
        ({"method": "grid", "samples": None, "vary": [PITCH]}, r"vary\[0\]: needs count or step"),
        ({"samples": None}, "samples: is missing"),
        ({"robots": ["arq", "qad"]}, r"robots\[1\]: unknown .*did you mean quad"),
        ({"robots": ["arq", "arq"]}, "robots: names one twice"),
        ({"vary": [SPEED, PITCH, SPEED]}, r"vary\[2\].field: is varied by entry 1 already"),
        ({"vary": [SPEED, PITCH | {"name": "speed"}]}, r"vary\[1\].name: 'speed' .*entry 1"),
        ({"vary": [SPEED | {"name": "Outcome"}]}, r"vary\[0\].name: 'Outcome' .*is reserved"),
        ({"vary": [SURFACE | {"values": ["wal"]}]}, r"vary\[0\].values: surface = wal: .*unknown"),
        ({"vary": [SURFACE | {"values": ["mat", "mat"]}]}, r"vary\[0\].values: has one twice"),
        ({"vary": [{"field": "seed", "values": [1, 2]}]}, "cannot be varied"),
        ({"vary": [{"field": "vehicle", "values": ["arq"]}]}, "under robots"),
        ({"vary": [SPEED | {"values": [1.0]}]}, "needs one of"),
        ({"vary": [SPEED | {"step": "0.3 m/s"}]}, r"vary\[0\].step: does not lead"),
        ({"vary": [PITCH | {"spacing": "logarithmic"}]}, r"vary\[0\].spacing: .*same sign"),
        ({"vary": [{"field": "friction", "values": [0.5, -1.0]}]}, r"friction = -1.*at least 0"),
        ({"vary": [{"field": "world.obstacles.0.distance", "from": 0.7, "to": 2}]}, "puts the cage"),
        ({"vary": [{"field": "control.damping", "factor": {"deviation": 0.1}}]}, "has no number"),
        ({"scatter": {"position": "1 kg"}}, r"scatter.position: has the wrong unit"),
        ({"scatter": "trial"}, r"scatter.preset: must be trials"),
        ({"scenario": THROW | {"world": {}}, "scatter": "trials", "vary": []}, "needs a wall"),
        ({"scenario": THROW | {"thrust": "hoover"}}, "scenario: thrust: .*hoover"),
        ({"scenario": ELASTIC, "vary": [REBOUND]}, r"vary\[0\].field: law hertz does not use it"),
        ({"samples": 10**9}, "samples: "),
        ({"repeats": 10**8}, "too many"),
    ],
)  # fmt: skip
def test_a_plan_that_cannot_be_flown_is_refused_in_one_line(
    given: dict[str, Any], told: str
) -> None:
    with pytest.raises(InputError, match=told) as caught:
        lay_out(plan(**given))
    assert len(caught.value.problems) == 1


def test_a_restitution_is_drawn_where_a_law_that_is_drawn_as_well_has_it() -> None:
    """Hertz alone does not read it; the draw of surfaces brings one that does."""
    surfaces = {"field": "world.obstacles.0.surface", "values": [{"law": "hertz"}, "wall"]}
    assert lay_out(plan(scenario=ELASTIC, vary=[surfaces, REBOUND])).flights > 0


def test_all_problems_of_a_plan_are_told_at_once() -> None:
    vary = [{"field": "sped", "values": [1]}, SPEED | {"from": "1 kg"}, PITCH]
    with pytest.raises(InputError) as caught:
        lay_out(plan(vary=vary))
    assert len(caught.value.problems) == 2


def test_problems_stand_on_their_lines() -> None:
    text = 'method = "random"\nsamples = 3\n[[vary]]\nfield = "speed"\n[[vary]]\nfield = "x"\nfrom = 1\n'
    source = Source("plan.toml", text, ("samples=oops",))
    assert (
        source.problem_line(("vary", 1, "from_"), "is bad") == "plan.toml:7: vary[1].from: is bad"
    )
    assert source.problem_line(("samples",), "is bad") == "override samples=oops: samples: is bad"
    assert Source().problem_line(("vary", 0), "is bad") == "vary[0]: is bad"


def test_a_plan_of_python_is_one_of_a_file() -> None:
    made = Plan(scenario=THROW, method="random", samples=3)
    assert lay_out(made).flights == 3
    assert lay_out(made).robots == ("arq",)


def test_a_value_of_the_scenario_can_be_overridden_where_it_is_in_a_file(tmp_path: Path) -> None:
    """`scenario` names a file; what is in it is read, and changed."""
    (tmp_path / "throw.toml").write_text(
        'vehicle = "arq"\nthrust = "hover"\n[start]\nposition = [0.6, 0, 1]\n'
    )
    path = tmp_path / "plan.toml"
    path.write_text('scenario = "throw.toml"\nmethod = "random"\nsamples = 2\n')
    plain, _ = read_plan(path)
    moved, source = read_plan(path, ["scenario.start.position.2=3", "scenario.vehicle=quad"])
    assert plain.scenario["start"]["position"] == [0.6, 0, 1]
    assert moved.scenario["start"]["position"] == [0.6, 0, 3]
    assert lay_out(moved, source).robots == ("quad",)


def test_a_run_up_begins_at_the_varied_start_and_not_at_the_scattered_one() -> None:
    """At every height the robot runs up level, whatever displaces it at first."""
    base = {
        "vehicle": "arq",
        "reference": {"type": "run-up", "speed": 2.0},
        "world": {"obstacles": [{"type": "wall", "distance": 2.75, "surface": "wall"}]},
    }
    heights = {"field": "start.position.2", "values": [1.0, "3 m"]}
    design = lay_out(plan(
        method="grid", samples=None, scenario=base, robots=[], vary=[heights],
        scatter={"position": "3 cm"},
    ))  # fmt: skip
    dealt = design.slice(0, 2)
    for k, height in enumerate((1.0, 3.0)):
        scenario = scenario_from(dealt.tables[k])
        assert scenario.reference.start == (0.0, 0.0, height)
        assert scenario.start_state().position.z == height + dealt.columns["scatter_position_z"][k]
    given = {**base, "reference": {**base["reference"], "start": [0.0, 0.0, 2.0]}}
    design = lay_out(plan(method="grid", samples=None, scenario=given, robots=[], vary=[heights]))
    starts = [scenario_from(one).reference.start for one in design.slice(0, 2).tables]
    assert starts == [(0.0, 0.0, 2.0)] * 2
