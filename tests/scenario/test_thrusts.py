"""Thrusts over time without a pilot: a table in place of a number, exact at its instants."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import springback
from builders.cases import nonempty
from springback.campaign.design.plan import read_plan
from springback.errors import InputError
from springback.results.flight import Flight
from springback.scenario.files import read_scenario
from springback.scenario.scenario import scenario_from
from springback.simulation import flight as flight_module
from springback.simulation.executor import advance
from springback.simulation.flight import fly_many, fly_one
from springback.simulation.measuring.record import Model
from springback.simulation.thrusts import ThrustTable
from springback.vehicle.state import State

#: Instants between two steps, before the end, a jump, and after it.
TIME = [0.0031, 0.0203, 0.0203, 0.041]
VALUES = [[3.0, 3.0, 3.0, 3.1], [4.0, 4.5, 4.0, 4.0], [2.0, 2.0, 2.2, 2.0], [5.0, 5.0, 5.0, 5.1]]
TABLE = {"time": TIME, "values": VALUES}
SHORT = {"time": [*TIME[:3], 0.0212], "values": VALUES}
STATE = ("x", "y", "z", "qw", "qx", "qy", "qz", "vx", "vy", "vz", "wx", "wy", "wz")


def thrown(thrust: Any, *, duration: float = 0.05, **more: Any) -> dict[str, Any]:
    """A turning vehicle far from everything."""
    start = {"position": [0, 0, 1], "velocity": [0.5, 0.3, 0], "angular_velocity": [0.3, 0.2, 0.1]}
    tables = {"vehicle": "arq", "thrust": thrust, "start": start}
    return tables | {"simulation": {"duration": duration}} | more


def flown(tables: dict[str, Any]) -> Flight:
    """In plain Python, so that nothing is compiled."""
    return springback.fly(tables, executor="python")


def last(flight: Flight, names: tuple[str, ...] = STATE) -> Any:
    return np.array([flight.columns[name][-1] for name in names])


# -- the table ------------------------------------------------------------------------------------


def test_thrusts_are_linear_between_instants_and_constant_outside() -> None:
    table = ThrustTable((0.1, 0.2, 0.2, 0.4), ((1.0, 0.0), (3.0, 0.0), (5.0, 1.0), (1.0, 3.0)))
    times = [0.0, 0.1, 0.15, 0.2 - 1e-6, 0.2, 0.3, 0.4, 9.0]
    assert table.at(times)[:, 0] == pytest.approx([1, 1, 2, 3, 5, 3, 1, 1], abs=1e-4)
    assert table.at(times)[:, 1] == pytest.approx([0, 0, 0, 0, 1, 2, 3, 3], abs=1e-4)
    ends = [stretch.end for stretch in table.stretches(until=0.3)]
    assert ends == [0.1, 0.2, 0.4]


def test_the_table_is_a_column_of_the_trajectory_and_its_instants_are_steps() -> None:
    flight = flown(thrown(TABLE))
    for when in nonempty(TIME):
        assert np.abs(flight.t - when).min() <= 1e-12
    before = flight.t < 0.0203 - 1e-9
    known = np.interp(flight.t, TIME[:2], [3.0, 4.5])
    assert flight.columns["thrust2"][before] == pytest.approx(known[before], abs=1e-12)
    assert flight.columns["thrust2"][~before][0] == 2.0
    assert flight.units["thrust2"] == "N"


# -- flights --------------------------------------------------------------------------------------


def test_a_constant_table_is_the_number() -> None:
    """Bit for bit, in all columns and measures."""
    row = [3.0, 3.5, 3.0, 3.1]
    table = flown(thrown({"time": [0.01, 0.02, 0.5], "values": [row] * 3}))
    number = flown(thrown(row))
    assert table.columns.keys() == number.columns.keys()
    for name, values in number.columns.items():
        assert values.tobytes() == table.columns[name].tobytes(), name
    assert table.measures == number.measures


@pytest.mark.parametrize("arms", ["hybrid", "always-free"])
def test_a_linear_thrust_lifts_as_its_integral_does(arms: str) -> None:
    """Level and without a moment, velocity and height are polynomials, which the method knows.

    Free flight as one rigid body, and the full equations of motion.
    """
    rows = [[1.0] * 4, [4.0] * 4, [2.0] * 4]
    tables = thrown({"time": [0.0031, 0.0203, 0.041], "values": rows}, model={"arms": arms})
    tables["start"] = {"position": [0, 0, 1]}
    flight, knots = (
        flown(tables),
        [(0.0, 1.0), (0.0031, 1.0), (0.0203, 4.0), (0.041, 2.0), (0.05, 2)],
    )
    m, g, v, z = scenario_from(tables).vehicle.mass, 9.81, 0.0, 1.0
    for (begin, a), (end, b) in itertools.pairwise(knots):
        h, lift, rise = end - begin, 4.0 * a / m - g, 4.0 * (b - a) / m
        z += v * h + lift * h**2 / 2.0 + rise * h**2 / 6.0
        v += lift * h + rise * h / 2.0
    assert last(flight, ("z", "vz")) == pytest.approx([z, v], abs=1e-13)
    assert abs(flight.measures["ledger_residual"] or 0.0) < 1e-9


def test_steps_keep_their_order() -> None:
    """Halving them divides the error by 16, as there is no kink within any."""
    ends = []
    for step in (8e-3, 4e-3, 2e-3, 1e-3):
        tables = thrown(TABLE, simulation={"duration": 0.05, "free_step": step})
        ends.append(last(flown(tables)))
    errors = [float(np.abs(a - b).max()) for a, b in itertools.pairwise(ends)]
    assert errors[0] > 1e-8
    assert errors[0] / errors[1] > 12.0
    assert errors[1] / errors[2] > 12.0


def test_a_jump_is_two_flights_joined() -> None:
    first, second = [3.0, 3.0, 3.0, 3.1], [4.0, 4.5, 4.0, 4.0]
    jump = {"time": [0.0203, 0.0203], "values": [first, second]}
    whole, begin = flown(thrown(jump)), flown(thrown(first, duration=0.0203))
    q = [begin.columns[f"q{part}"][-1] for part in "wxyz"]
    start = {
        "position": [*last(begin, ("x", "y", "z"))], "velocity": [*last(begin, ("vx", "vy", "vz"))],
        "angular_velocity": [*last(begin, ("wx", "wy", "wz"))], "quaternion": q,
    }  # fmt: skip
    tables = thrown(second, duration=0.05 - 0.0203) | {"start": start}
    tables["start"] = {k: [float(x) for x in v] for k, v in start.items()}
    assert last(flown(tables)) == pytest.approx(last(whole), abs=1e-12)
    spun = np.linalg.norm(np.diff(last(whole, STATE) - last(begin, STATE)))
    assert spun > 0.1


def test_no_peak_is_interpolated_across_a_jump() -> None:
    """The largest specific force is one that was felt, in the full equations of motion."""
    jump = {
        "time": [0.02, 0.02, 0.03, 0.03],
        "values": [[1.0] * 4, [6.0] * 4, [6.0] * 4, [5.0] * 4],
    }
    tables = thrown(jump, model={"arms": "always-free"})
    tables["start"] = {"position": [0, 0, 1]}
    felt = flown(tables).measures["peak_specific_force"]
    assert felt == pytest.approx(24.0 / scenario_from(tables).vehicle.mass, rel=1e-12)


def against_wall(count: int) -> tuple[list[Model], list[State], ThrustTable]:
    """Flights that touch a wall at a jump; some end before the last instant of their table."""
    wall = {"gravity": 9.81, "obstacles": [{"type": "wall", "distance": 1.0, "surface": "wall"}]}
    models, starts = [], []
    for k in range(count):
        tables = thrown(SHORT, duration=0.021 + 0.0003 * k, world=wall)
        tables["start"] |= {"velocity": [2.0, 0.05 * k, 0.0], "touch_distance": "40.5 mm"}
        built = scenario_from(tables).build()
        models.append(built.model)
        starts.append(built.start)
    return models, starts, ThrustTable((*TIME[:3], 0.0212), tuple(map(tuple, VALUES)))


def test_lanes_fly_as_one_flight_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever their neighbours do, and wherever they end; in plain Python."""
    plain = getattr(advance, "py_func", advance)
    monkeypatch.setattr(flight_module, "entry_for", lambda model, executor="": plain)
    models, starts, table = against_wall(3)
    many = fly_many(models, starts, thrusts=table, width=2, threads=1)
    for k in range(3):
        alone = fly_one(models[k], starts[k], thrusts=table)
        assert (alone.motion, alone.record) == (many[k].motion, many[k].record)
        assert alone.record.contacts.total > 0.0
        assert alone.trace is not None
        assert alone.trace.values[-1, 0] == pytest.approx(0.021 + 0.0003 * k, abs=1e-12)


def test_it_is_compiled_to_the_same_bits() -> None:
    [model], [start], table = against_wall(1)
    compiled = fly_one(model, start, thrusts=table)
    plain = fly_one(model, start, thrusts=table, executor="python")
    assert (compiled.motion, compiled.record) == (plain.motion, plain.record)


# -- files ----------------------------------------------------------------------------------------

HEAD = 'vehicle = "arq"\n[start]\nposition = [0, 0, 1]\n[simulation]\nduration = 0.05\n'
CSV = "thrust2,time,note,thrust1,thrust3,thrust4\n3.0,0.0,a,1,2,4\n\n3,0.02,b,2,2,2\n"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "scenario.toml").write_text(f'thrust = "thrusts.csv"\n{HEAD}', encoding="utf-8")
    (tmp_path / "thrusts.csv").write_text(CSV, encoding="utf-8")
    return tmp_path


def test_a_file_is_its_table(folder: Path) -> None:
    """Read beside the scenario, by the names of its columns, and held by what is saved."""
    scenario = read_scenario(folder / "scenario.toml")
    rows = [[1.0, 3.0, 2.0, 4.0], [2.0, 3.0, 2.0, 2.0]]
    table = {"time": [0.0, 0.02], "values": rows}
    assert scenario == scenario_from(scenario.model_dump() | {"thrust": table})
    named = str(folder / "thrusts.csv")
    assert read_scenario(folder / "scenario.toml", [f"thrust={named}"]) == scenario
    assert scenario.model_dump(mode="json")["thrust"] == table


def test_a_plan_holds_the_table_of_a_file(folder: Path) -> None:
    path = folder / "plan.toml"
    path.write_text(
        'scenario = "scenario.toml"\nsamples = 4\nseed = 1\nmethod = "sobol"\n'
        '[[vary]]\nfield = "start.velocity[0]"\nfrom = 1.0\nto = 2.0\n',
        encoding="utf-8",
    )
    plan, _ = read_plan(path)
    assert isinstance(plan.scenario, dict)
    assert plan.scenario["thrust"]["time"] == [0.0, 0.02]


#: A table, and words of the message.
BAD: dict[str, tuple[Any, str]] = {
    "no rows": ({"time": [0.0]}, r"^thrust\.values: is missing"),
    "too few": ({"time": [0.0, 1.0], "values": [[1] * 4]}, r"thrust\.values: .* 2 instants .*1\)"),
    "rotors": ({"time": [0.0], "values": [[1] * 3]}, r"thrust\.values\[0\]: has 3 entries for 4"),
    "order": ({"time": [1.0, 0.5], "values": [[1] * 4] * 2}, r"thrust\.time\[1\]: .*1 s, .*0\.5 s"),
    "thrice": ({"time": [1, 1, 1], "values": [[1] * 4] * 3}, r"thrust\.time\[2\]: .* a jump"),
    "negative": ({"time": [0], "values": [[1, -1, 1, 1]]}, r"thrust\.values\[0\]\[1\]: .*0 N .*-1 N"),
    "not finite": ({"time": [0], "values": [[1, 1, 1, np.inf]]}, r"values\[0\]\[3\]: must be finite"),
    "time": ({"time": ["1 N"], "values": [[1] * 4]}, r"thrust\.time\[0\]: .*wrong unit"),
    "too much": (
        {"time": [0, 1], "values": [[1] * 4, [99] * 4]}, r"values\[1\]: must be at most 6\.99944 N, .*99 N"
    ),
    "empty": ({"time": [], "values": []}, r"thrust\.time: must be a list of 1 to"),
    "unknown": ({"times": [0], "values": [[1] * 4]}, r"thrust\.times: unknown key; did you mean time"),
}  # fmt: skip


@pytest.mark.parametrize("case", BAD)
def test_a_table_that_cannot_be_flown_is_refused_in_one_line(case: str) -> None:
    table, words = BAD[case]
    with pytest.raises(InputError, match=words) as caught:
        scenario_from(thrown(table))
    assert len(caught.value.problems) == 1


#: Text of the file, and words of the message.
BAD_FILES = {
    "no file": (None, r"thrusts\.csv: cannot be read"),
    "empty": ("", r"thrusts\.csv:1: has no column time"),
    "no time": (
        "thrust1,thrust2\n1,2\n",
        r"thrusts\.csv:1: has no column time; there are: thrust1",
    ),
    "no thrust": ("time,a\n1,2\n", r"thrusts\.csv:1: has no column thrust1"),
    "words": ("time,thrust1\n0,1\n1,much\n", r"thrusts\.csv:3: must have numbers .*1,much"),
    "short": ("time,thrust1\n0\n", r"thrusts\.csv:2: must have numbers"),
    "rotors": ("time,thrust1\n0,1\n", r"thrust\.values\[0\]: has 1 entries for 4 rotors"),
}


@pytest.mark.parametrize("case", BAD_FILES)
def test_a_file_that_holds_no_table_is_refused_in_one_line(folder: Path, case: str) -> None:
    text, words = BAD_FILES[case]
    (folder / "thrusts.csv").unlink()
    if text is not None:
        (folder / "thrusts.csv").write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=words) as caught:
        read_scenario(folder / "scenario.toml")
    [line] = caught.value.problems
    assert "scenario.toml:1: thrust" in line


def test_no_pilot_is_given_a_table() -> None:
    def hover(time: float, measurement: Any, memory: Any) -> tuple[list[float], Any]:
        return [3.0] * 4, memory

    with pytest.raises(InputError, match="thrust: must not be a table where a pilot flies"):
        springback.fly(thrown(TABLE), pilot=hover)
    with pytest.raises(InputError, match=r"thrust: cannot be combined .*got a table"):
        scenario_from(thrown(TABLE) | {"reference": {"type": "hold"}})


@pytest.mark.parametrize(
    ("thrust", "field"),
    [(100, "thrust"), ("7.1 N", "thrust"), ([3, 3, 8, 3], r"thrust\[2\]"), (1e30, "thrust"),
     ({"time": [0, 1], "values": [[1] * 4, [1, 1, 1, 9]]}, r"thrust\.values\[1\]")],
)  # fmt: skip
def test_no_rotor_is_given_more_than_its_largest_thrust(thrust: Any, field: str) -> None:
    """Nor by a constant: ARQ gives 7 N a rotor."""
    with pytest.raises(InputError, match=rf"^{field}: must be at most 6\.99944 N, the largest th"):
        scenario_from(thrown(thrust))
    assert scenario_from(thrown(6.99)).flight_model().thrust == (6.99,) * 4


def test_a_vehicle_too_weak_to_hover_cannot_be_told_to() -> None:
    weak = {"preset": "arq", "propulsion": {"max_thrust": "3 N"}}
    with pytest.raises(InputError, match=r"^thrust: hover takes 3\.44331 N of a rotor, .* 3 N$"):
        scenario_from(thrown("hover") | {"vehicle": weak})
    assert scenario_from(thrown(2.9) | {"vehicle": weak}).flight_model().thrust == (2.9,) * 4


def test_thrusts_without_a_limit_of_the_rotors_have_a_wide_one() -> None:
    bare = {"preset": "arq", "propulsion": None}
    with pytest.raises(InputError, match=r"^thrust: must be at most 1e\+06 N \(got 1e\+09 N\)$"):
        scenario_from(thrown(1e9) | {"vehicle": bare})
    assert scenario_from(thrown(100.0) | {"vehicle": bare}).flight_model().thrust == (100.0,) * 4
