"""The resilience envelope: what a map promises, of parameters, cells, shares and the 95 % line."""

import math

import numpy as np
import pytest

from springback.campaign import envelope_plan
from springback.campaign.analysis.envelope import (
    LEVEL,
    Axis,
    CellIndex,
    Envelope,
    EnvelopeCell,
    spans,
)
from springback.campaign.envelope_plan import (
    EnvelopePlan,
    envelope_cost,
    fly_envelope,
    plan_envelope,
)
from springback.errors import InputError
from springback.results.flight import fly
from springback.scenario.scenario import Scenario, scenario_from
from springback.simulation.measuring.measures import Outcome
from springback.studies.run_ups import WALL_DISTANCE
from springback.studies.trials import DURATION, HOME, TrialNoise, trial_tables

SMALL = {"robots": ("arq",), "trials": 2}


def flown(*words: str, **given: object) -> Envelope:
    return fly_envelope(plan_envelope(*words, **{**SMALL, **given}))


def made_up(counts: list[list[int | None]], trials: int = 1000) -> Envelope:
    """A map over x = 0, 1, 2 ... and y = 0, 10, 20 ...; None cannot be flown."""
    x = Axis("clock", "1/s", tuple(map(float, range(len(counts[0])))))
    y = Axis("seed", "-", tuple(10.0 * j for j in range(len(counts))))
    cells = {}
    for j, row in enumerate(counts):
        for i, n in enumerate(row):
            place = CellIndex("arq", i, j)
            ended = {} if n is None else {"recovered": n, "hit_ground": trials - n}
            cells[place] = EnvelopeCell(ended, "too weak" if n is None else "")
    return Envelope(x, y, ("arq",), trials, 0, (), cells)


# -- the line -------------------------------------------------------------------------------------


def test_the_line_of_a_plane_lies_where_the_plane_has_95_percent() -> None:
    """share = 1.05 - 0.04 x - 0.003 y, so the line is x = 2.5 - 0.075 y, y = (100 - 40 x)/3."""
    plane = made_up([[1050 - 40 * i - 30 * j for i in range(2, 9)] for j in range(4)], 2000)
    flat = made_up([[min(1050 - 40 * i - 30 * j, 1000) for i in range(7)] for j in range(3)])
    assert plane.shares("arq").shape == (4, 7)
    for j, y in enumerate(flat.y.values[:2]):
        [(low, high, *crossed)] = flat.along_x("arq", j)
        # Row 0 is cut off at 1 for x < 1.25, which the line at x = 2.5 does not see.
        assert (low, crossed) == (0.0, [False, True])
        assert high == pytest.approx(2.5 - 0.075 * y, abs=1e-12)
    [(low, high, *crossed)] = flat.along_y("arq", 2)
    assert (low, high, crossed) == (0.0, pytest.approx(20.0 / 3.0, abs=1e-12), [False, True])


def test_the_line_does_not_depend_on_the_direction_of_an_axis() -> None:
    values, shares = [1.0, 2.0, 4.0, 5.0], np.array([1.0, 0.9, 1.0, 0.8])
    forth = spans(values, shares)
    assert spans(values[::-1], shares[::-1]) == forth
    assert [(s.low, s.high) for s in forth] == [
        (1.0, pytest.approx(1.5)), (pytest.approx(3.0), pytest.approx(4.25)),
    ]  # fmt: skip


def test_the_line_ends_beside_what_cannot_be_flown() -> None:
    nan = math.nan
    [only] = spans([0.0, 1.0, 2.0, 3.0], np.array([nan, 1.0, 1.0, nan]))
    assert only == (1.0, 2.0, False, False)
    assert spans([0.0, 1.0], np.array([nan, 0.5])) == []
    [one] = spans([0.0, 1.0], np.array([LEVEL, nan]))
    assert one == (0.0, 0.0, False, False)


def test_cells_that_cannot_be_flown_count_nowhere() -> None:
    told = made_up([[10, None, 10], [10, None, 0]], 10)
    assert np.isnan(told.shares("arq")[:, 1]).all()
    assert "at least 95 % in 3 of 4 cells that can be flown (2 cannot)" in told.sentence("arq")
    [row] = [r for r in told.rows() if r["clock [1/s]"] == 1.0 and r["seed [-]"] == 0.0]
    assert (row["trials"], row["successes"], row["share"], row["low"]) == (0, None, None, None)
    assert row["cannot_be_flown"] == "too weak"
    # The table says why, and where: a dash alone would read as the robot's failure.
    assert "\n- not flown: 2 cells, such as " in told.table("arq")
    assert told.table("arq").endswith(": too weak")
    assert told.table("arq").splitlines()[2].split() == ["10", "10", "-", "0"]


def test_intervals_are_wilsons() -> None:
    """Of n out of n it is n/(n + z²) to 1, with z = 1.959964."""
    share, low, high = made_up([[10, 10], [10, 10]], 10).cells[CellIndex("arq", 0, 0)].interval
    assert share == 1.0
    assert low == pytest.approx(10.0 / (10.0 + 1.959964**2), abs=1e-6)
    assert high == 1.0


# -- parameters -----------------------------------------------------------------------------------


def axes(*words: str, **given: object) -> EnvelopePlan:
    return plan_envelope(*words, **{**SMALL, **given})


def first(plan: EnvelopePlan, sample: int = 0) -> Scenario:
    """The scenario of the first flight of a cell."""
    return scenario_from(plan.tables(plan.flight(sample, 0)), False)


def test_units_are_read_and_angles_shown_in_degrees() -> None:
    plan = axes("speed=7.2km/hour:3:3", "pitch=-30deg:30deg:3")
    assert plan.x.values == pytest.approx((2.0, 2.5, 3.0))
    assert plan.y.values == (-30.0, 0.0, 30.0)
    assert first(plan).reference.pitch == pytest.approx(-math.pi / 6, abs=1e-12)
    assert (plan.x.label, plan.y.label) == ("speed [m/s]", "pitch [deg]")
    stiffness = axes("speed=1:2:2", "vehicle.arms.stiffness=2 N/mm:6 N/mm:3").y
    assert (stiffness.values, stiffness.label) == (
        (2e3, 4e3, 6e3),
        "vehicle.arms.stiffness [N/m]",
    )


def test_every_parameter_reaches_its_place_in_the_scenario() -> None:
    """And nothing else differs from the test without it."""
    wall = "world.obstacles.0.surface.friction"
    for name, value, reached in (
        ("control.rate_limit", 2.0, lambda s: s.control.rate_limit),
        ("recovery.response.pace", 0.3, lambda s: s.recovery.response.pace),
        ("vehicle.propulsion.time_constant", 0.05, lambda s: s.vehicle.propulsion.time_constant),
        ("vehicle.arms.stiffness", 4e3, lambda s: s.vehicle.arms.stiffness),
        ("sensors.imu.offset.2", 0.01, lambda s: s.sensors.imu.offset[2]),
        ("payload.mass", 0.1, lambda s: s.payload.mass),
        ("simulation.duration", 9.0, lambda s: s.simulation.duration),
        (wall, 0.3, lambda s: s.world.obstacles[0].surface.friction),
        ("pitch", 0.2, lambda s: s.reference.pitch),
        ("model_error.mass", 1.1, lambda s: s.model_error.mass),
    ):  # fmt: skip
        plan = axes("control.tilt_limit=1:1.2:2", f"{name}={value}:{1.05 * value}:2")
        changed = first(plan)
        mass = plan.design.slice(0, 1).columns["scatter_mass_factor"][0]
        scatter = mass if name == "model_error.mass" else 1.0
        assert reached(changed) == pytest.approx(value * scatter, rel=1e-9), name
        assert changed.control.tilt_limit == 1.0
        assert changed.reference.speed == 3.5


def test_settings_hold_in_all_trials_and_axes_go_on_top() -> None:
    plan = axes(
        "control.stiffness=8:10:2",
        "speed=2:3:2",
        settings=("control.rate_limit=200 deg/s", "pitch=15deg", "recovery.response.way=set-point"),
    )
    scenario, noise = first(plan, 2), plan.design.slice(4, 5).columns
    assert scenario.control.stiffness == 10.0 * noise["scatter_stiffness_factor"][0]
    assert noise["control.stiffness"] == [10.0]
    assert scenario.control.rate_limit == pytest.approx(math.radians(200.0))
    assert scenario.recovery.response.way == "set-point"
    assert (scenario.reference.speed, math.degrees(scenario.reference.pitch)) == (
        2.0,
        pytest.approx(15.0),
    )


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("sped=1:5:9",), "did you mean speed?"),
        (("control.time_constan=0.1:0.2:3",), "did you mean time_constant?"),
        (("speed=1:5",), "name=from:to:count"),
        (("speed",), "name=from:to:count"),
        (("speed=one:5:9",), "speed"),
        (("speed=:5:9",), "is not a number"),
        (("speed=1:5:1",), "whole number from 2"),
        (("speed=1:5:x",), "whole number from 2"),
        (("speed=2:2:3",), "must differ"),
        (("speed=1kg:5kg:3",), "wrong unit"),
        (("speed=nan:5:3",), "finite"),
        (("speed=-1:5:3",), "speed: must be more than 0 m/s"),
        (("pitch=-60:60:9",), "within a full turn"),
        (("speed=1:2:2", "speed=1:2:2"), "speed: is varied by entry 1 already"),
        (("speed=1:2:2", "reference.speed=1:2:2"), "speed: is varied by entry 1 already"),
        (("recovery.runs=1:2:3",), "not whole"),
        (("recovery.response.way=0:1:2",), "not a single number"),
        (("seed=0:1:2",), "--seed"),
        (("vehicle=0:1:2",), "--robot"),
        (("air.wind.3=0:1:2",), "the scenario has no air.wind[3]"),
    ],
)
def test_bad_axes_are_refused_in_one_line(words: tuple[str, ...], told: str) -> None:
    with pytest.raises(InputError) as raised:
        axes(*words)
    [line] = raised.value.problems
    assert told in line


def test_a_whole_number_is_an_axis_where_its_values_are_whole() -> None:
    plan = axes("recovery.runs=1:3:3", "wall angle=-20deg:20deg:2")
    assert (plan.x.values, plan.x.label) == ((1.0, 2.0, 3.0), "recovery.runs [-]")
    assert (plan.y.values, plan.y.label) == ((-20.0, 20.0), "wall_angle [deg]")
    assert first(plan, 5).recovery.runs == 3


def test_bad_words_beside_the_axes_are_refused() -> None:
    for given, told in (
        ({"robots": ("arqq",)}, "did you mean arq?"),
        ({"robots": ("arq-slider",)}, "propulsion"),
        ({"trials": 0}, "--trials"),
        ({"seed": -1}, "--seed"),
        ({"settings": ("speed=2",)}, "on an axis already"),
        ({"settings": ("control",)}, "key=value"),
        ({"settings": ("recovery.response.way=back",)}, "recovery.response.way"),
        ({"settings": ("recovery.response.pace=1 kg",)}, "wrong unit"),
    ):
        with pytest.raises(InputError) as raised:
            axes(**given)
        [line] = raised.value.problems
        assert told in line


# -- flown ----------------------------------------------------------------------------------------


def test_a_gentle_collision_is_survived_and_an_absurd_one_is_not() -> None:
    """8 m/s in 2.75 m cannot be flown; 3 m/s with rotors a second late ends on the ground."""
    told = flown("vehicle.propulsion.time_constant=0.02:1:2", "speed=2:8:2")
    gentle, late = told.cells[CellIndex("arq", 0, 0)], told.cells[CellIndex("arq", 1, 0)]
    assert (gentle.successes, gentle.trials) == (2, 2)
    assert (late.successes, late.trials) == (0, 2)
    for column in (0, 1):
        fast = told.cells[CellIndex("arq", column, 1)]
        assert fast.trials == 0
        assert "distance" in fast.reason
    assert told.along_x("arq", 0)[0].high == pytest.approx(0.02 + 0.05 * 0.98)


def test_the_same_seed_gives_the_same_map_however_it_is_cut(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    words = ("speed=2:3.5:2", "control.time_constant=0.15:0.6:2")
    whole = flown(*words, robots=("arq", "quad"))
    monkeypatch.setattr(envelope_plan, "FLIGHTS_AT_ONCE", 5)
    seen: list[float] = []
    cut = fly_envelope(plan_envelope(*words, robots=("arq", "quad"), trials=2), seen.append)
    assert cut.as_dict() == whole.as_dict()
    assert seen == sorted(seen)
    assert seen[-1] == 1.0


def test_a_cell_is_what_its_trials_are() -> None:
    """The map counts how trials end that are flown alone, with the noise of the map's rows."""
    plan = axes("recovery.response.pace=0.05:0.2:2", "control.time_constant=0.15:0.7:2")
    told = fly_envelope(plan)
    gains = ("stiffness", "vertical_stiffness", "damping_ratio", "time_constant", "rate_gain")
    for column, row in ((0, 0), (1, 1)):
        flight = plan.flight(2 * column + row, 0)
        columns = plan.design.slice(flight, flight + 2).columns
        won = 0
        for k in range(2):
            noise = {name: values[k] for name, values in columns.items()}
            place, velocity = (
                tuple(noise[f"scatter_{name}_{axis}"] for axis in "xyz")
                for name in ("position", "velocity")
            )
            drawn = TrialNoise(
                tuple(h + p for h, p in zip(HOME, place, strict=True)), velocity,
                noise["scatter_heading"], WALL_DISTANCE + noise["scatter_wall_distance"],
                noise["scatter_wall_yaw"], noise["scatter_mass_factor"],
                noise["scatter_inertia_factor"],
                tuple(noise[f"scatter_{name}_factor"] for name in gains), noise["seed"],
            )  # fmt: skip
            changes = {
                "recovery": {"response": {"pace": noise["recovery.response.pace"]}},
                "control": {"time_constant": noise["control.time_constant"]},
            }
            alone = fly(trial_tables("arq", 0.0, 3.5, drawn, changes), trajectory=False)
            won += alone.outcome is Outcome.RECOVERED
        cell = told.cells[CellIndex("arq", column, row)]
        assert (cell.successes, cell.trials) == (won, 2)


def test_all_robots_fly_with_the_same_noise() -> None:
    columns = axes("speed=2:3:2", robots=("arq", "quad")).design.slice(0, 8).columns
    assert columns["robot"] == ["arq", "quad"] * 4
    noise = [name for name in columns if name == "seed" or name.startswith("scatter_")]
    assert len(noise) == 17
    for name in noise:
        assert columns[name][::2] == columns[name][1::2]
        assert len(set(columns[name])) == 4


def test_where_luck_weighs_too_much_the_cell_cannot_be_flown() -> None:
    """Rotors that lift 1 % more than the believed weight: of ten drawn masses some are too much."""
    share = 1.404 * 9.81 / 4.0
    words = (f"vehicle.propulsion.max_thrust={0.9 * share}:{1.01 * share}:2", "speed=1:1.1:2")
    told = flown(*words, trials=10)
    assert all(cell.trials == 0 and cell.reason for cell in told.cells.values())


def test_the_outlook_counts_and_flies_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(envelope_plan, "rows", None)
    coming = envelope_cost(axes("speed=1:3:3", "pitch=-15deg:15deg:2", robots=("arq", "quad")))
    assert (coming.cells, coming.flights, coming.duration, coming.kinds) == (12, 24, DURATION, 1)
    two = axes("estimator.kalman.offset.0=0:0.01:2", settings=("estimator.type=perfect",))
    assert envelope_cost(two).kinds == 1
