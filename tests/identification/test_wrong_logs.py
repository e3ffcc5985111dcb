"""Logs that a fit or a replay must refuse, or read with care: units, bodies, clocks."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import pytest

from builders.rigs import rig_fit
from identification.rigs import SPRING, problem_of, recorded, rig
from springback.errors import InputError
from springback.identification.fits import check_chain, fit, read_flights
from springback.identification.replays.errors import channel_errors, error_rows
from springback.identification.replays.replay import replay, scenario_tables
from springback.identification.settings import read_fit_plan
from springback.logs.reading import read_recording

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name in ("fit.toml", "arq_wall.toml", "impact_log.toml", "impact_log.csv"):
        (tmp_path / name).write_bytes((EXAMPLES / name).read_bytes())
    return tmp_path


def test_arm_lengths_a_thousand_times_too_long_are_refused_by_fit_and_replay(folder: Path) -> None:
    table = (folder / "impact_log.csv").read_text().splitlines()
    names = table[0].split(",")
    places = [k for k, name in enumerate(names) if name.startswith("arm_lengths")]
    lines = []
    for line in table[1:]:
        cells = line.split(",")
        for k in places:
            cells[k] = str(1e3 * float(cells[k])) if cells[k] else ""
        lines.append(",".join(cells))
    (folder / "impact_log.csv").write_text("\n".join([table[0], *lines]) + "\n")
    said = r"impact_log.csv: arm lengths: lengths are 190 m .* arm is 0\.19 m: .* probably mm$"
    with pytest.raises(InputError, match=said):
        read_flights(read_fit_plan(folder / "fit.toml"), folder)
    recordings = [read_recording(folder / "impact_log.toml")]
    with pytest.raises(InputError, match=said):
        replay(*scenario_tables(folder / "arq_wall.toml"), recordings)


def test_a_plan_names_the_vehicle_among_bodies(folder: Path) -> None:
    text = (folder / "fit.toml").read_text().replace("[free]", 'track = "vehicel"\n[free]')
    (folder / "fit.toml").write_text(text)
    plan = read_fit_plan(folder / "fit.toml")
    assert plan.flights[0].track == "vehicel"
    with pytest.raises(InputError, match="have no body 'vehicel'; did you mean vehicle"):
        read_flights(plan, folder)
    right = read_fit_plan(folder / "fit.toml", ["track=vehicle"])
    assert read_flights(right, folder)[0].impacts


@pytest.mark.parametrize(
    ("sensors", "said"),
    [
        (
            {"accelerometer": {"full_scale": 50.0}},
            r"^sensors.accelerometer.full_scale: must be at least the largest sample of rig at "
            r"0\.\d+ s: accelerometer, \d+(\.\d)? m/s\^2 \(got 50 m/s\^2\)$",
        ),
        (
            {"motion_capture": {"smoothing": 300.0}},
            r"^sensors.motion_capture.smoothing: must be below half the rate of rig at 0\.\d+ s: "
            r"vehicle.position, 100 Hz \(got 300 Hz\)$",
        ),
    ],
)
def test_a_chain_that_the_samples_contradict_is_refused(sensors: Any, said: str) -> None:
    tables = rig("arq", 1.85)
    log = recorded(tables)
    check_chain(problem_of(tables, log, {SPRING: "factor 4"}))
    with pytest.raises(InputError, match=said):
        check_chain(problem_of(tables, log, {SPRING: "factor 4"}, sensors=sensors))


def test_an_override_names_a_field_with_or_without_quotes(folder: Path) -> None:
    words = [
        """known."vehicle.body.inertia"="+- 7 %\"""", "free.vehicle.arms.damping=factor 2",
        "known.'vehicle.arms.mass' = exact", "starts=3",
    ]  # fmt: skip
    plan = read_fit_plan(folder / "fit.toml", words)
    assert plan.known["vehicle.body.inertia"] == "+- 7 %"
    assert plan.free["vehicle.arms.damping"] == "factor 2"
    assert plan.known["vehicle.arms.mass"] == "exact"
    assert plan.starts == 3
    with pytest.raises(InputError, match=r"known\.vehicle\.body\.mass: is free as well"):
        read_fit_plan(folder / "fit.toml", ["free.vehicle.body.mass=factor 2"])


def test_a_replay_that_never_touches_warns_of_no_empty_mean(folder: Path) -> None:
    tables = scenario_tables(folder / "arq_wall.toml", ["world.obstacles.0.distance=50"])
    flown = replay(*tables, [read_recording(folder / "impact_log.toml")])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        rows = error_rows(flown, channel_errors(flown))
    assert any(row.what == "peak specific force" for row in rows)


def test_a_clock_that_jumps_is_refused_by_a_fit_and_a_replay(folder: Path) -> None:
    table = (folder / "impact_log.csv").read_text().splitlines()
    place = table[0].split(",").index("t2")
    lines = []
    for line in table[1:]:
        cells = line.split(",")
        if cells[place] and float(cells[place]) > 0.45:
            cells[place] = str(float(cells[place]) + 0.5)
        lines.append(",".join(cells))
    (folder / "impact_log.csv").write_text("\n".join([table[0], *lines]) + "\n")
    mapping = (folder / "impact_log.toml").read_text()
    assert 'time = "t2"' in mapping
    said = r"impact_log.csv: \S+: its clock jumps ahead by 500 ms at 0\.4\d+ s: "
    with pytest.raises(InputError, match=said):
        read_flights(read_fit_plan(folder / "fit.toml"), folder)
    with pytest.raises(InputError, match=said):
        replay(
            *scenario_tables(folder / "arq_wall.toml"), [read_recording(folder / "impact_log.toml")]
        )


def test_axes_given_to_a_mapping_are_refused(folder: Path) -> None:
    text = (folder / "fit.toml").read_text()
    text = text.replace('logs = ["impact_log.toml"]', "").replace("[free]", "[free]", 1)
    flight = '\n[[flights]]\nlogs = ["impact_log.toml"]\nworld = "ned"\n'
    (folder / "fit.toml").write_text(text + flight)
    with pytest.raises(InputError, match=r"^--world: is not read for .*impact_log.csv, whose"):
        read_flights(read_fit_plan(folder / "fit.toml"), folder)


def test_a_log_in_wrong_axes_is_refused_by_a_fit(folder: Path) -> None:
    """As by `segment`, with the line to write; it searched for minutes, and said so at its end."""
    mapping = (folder / "impact_log.toml").read_text().replace('"nwu"', '"ned"')
    (folder / "impact_log.toml").write_text(mapping.replace('"flu"', '"frd"'))
    with pytest.raises(InputError, match=r'all findings pass with .*world = "nwu" body = "flu"'):
        read_flights(read_fit_plan(folder / "fit.toml"), folder)
    [flight] = read_flights(read_fit_plan(folder / "fit.toml", ["no_check=true"]), folder)
    assert any("impact_log" in text for text in flight.warnings)


def test_the_mass_of_a_body_of_parts_is_not_a_field(folder: Path) -> None:
    """It was flown, and refused there, with a hint at obstacles and frames."""
    part = '{type = "box", mass = "1 kg", size = ["0.1 m", "0.1 m", "0.1 m"]}'
    scenario = (folder / "arq_wall.toml").read_text()
    scenario = scenario.replace(
        'vehicle = "arq"', f'vehicle = {{preset = "arq", body = {{parts = [{part}]}}}}'
    )
    (folder / "arq_wall.toml").write_text(scenario)
    plan = read_fit_plan(folder / "fit.toml")
    with pytest.raises(InputError, match=r'known\."vehicle\.body\.mass": follows from the parts'):
        fit(plan, folder)


def test_values_that_are_not_settled_are_not_called_learned() -> None:
    """However narrow their intervals."""
    [one, *_] = rig_fit().estimates
    assert one.verdict == "learned"
    assert one._replace(settled=False).verdict == "not settled"


def test_a_known_mass_that_the_scenario_cannot_have_is_named(folder: Path) -> None:
    """Once only the moments of inertia were, which the plan does not give."""
    plan = read_fit_plan(folder / "fit.toml", ["known.vehicle.body.mass=1005 kg +- 1 %"])
    said = r"^known\.vehicle\.body\.mass: .* \(got '1005 kg \+- 1 %'\): vehicle\.body\.inertia: "
    with pytest.raises(InputError, match=said):
        fit(plan, folder)


def test_an_impact_at_the_end_of_a_log_says_what_would_be_enough(folder: Path) -> None:
    table = (folder / "impact_log.csv").read_text().splitlines()
    (folder / "impact_log.csv").write_text("\n".join(table[:180]) + "\n")
    with pytest.raises(
        InputError, match=r"has 0\.375 s before it and 0\.000 s after it; 0\.150 s "
    ):
        read_flights(read_fit_plan(folder / "fit.toml"), folder)
