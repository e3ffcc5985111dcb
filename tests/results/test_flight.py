"""A flight in Python: typed measures, events, any time base, any point, files, replay, figures."""

from __future__ import annotations

import ast
import inspect
import sys
import types
import warnings
from dataclasses import replace
from pathlib import Path
from subprocess import run
from typing import Any

import numpy as np
import pytest

import springback
from builders.forms import box_file
from builders.impacts import flown, towards_wall, value
from springback.dynamics.clearance import clearance
from springback.dynamics.motion import rates
from springback.errors import ContactWarning, InputError
from springback.interfaces.replay import viewer
from springback.kernels.vectors import Quat, Vec
from springback.results import measures
from springback.results.flight import Flight, as_scenario, fly
from springback.results.motion import angular_acceleration
from springback.results.recovery_measures import RECOVERY_MEASURES
from springback.simulation.measuring.measures import MEASURES
from springback.vehicle.state import State

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def flight() -> Flight:
    """Against the wall with an arm ahead, turning, with gravity and thrust."""
    tables = towards_wall(pitch=0.2, yaw=0.6, roll=0.1, angular_velocity=[0.5, -1.0, 2.0])
    tables["world"]["gravity"] = 9.81
    return fly({**tables, "name": "<b>&", "thrust": [2.0, 3.5, 2.5, 3.0]})


def state_at(flight: Flight, k: int) -> State:
    c = {name: float(values[k]) for name, values in flight.columns.items()}
    return State(
        Vec(c["x"], c["y"], c["z"]), Quat(c["qw"], c["qx"], c["qy"], c["qz"]),
        Vec(c["vx"], c["vy"], c["vz"]), Vec(c["wx"], c["wy"], c["wz"]),
        tuple(c[f"l{j}"] for j in range(1, 5)), tuple(c[f"dl{j}"] for j in range(1, 5)),
    )  # fmt: skip


def in_contact(flight: Flight, count: int) -> list[int]:
    felt = np.flatnonzero(sum(flight.columns[f"fn{j}"] for j in range(1, 5)) > 1.0)
    return [int(k) for k in felt[:: len(felt) // count]]


# -- typed measures -------------------------------------------------------------------------------


def test_the_typed_measures_are_those_of_the_registries() -> None:
    [cls] = [n for n in ast.parse(inspect.getsource(measures)).body if isinstance(n, ast.ClassDef)]
    lines = [node for node in cls.body if isinstance(node, ast.AnnAssign)]
    texts = [
        " ".join(node.value.value.split())
        for node in cls.body[1:]
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
        and isinstance(node.value.value, str)
    ]  # fmt: skip
    known = MEASURES | RECOVERY_MEASURES
    assert [ast.unparse(node.target) for node in lines] == list(known)
    assert {ast.unparse(node.annotation) for node in lines} == {"float | None"}
    assert texts == [f"{meaning} [{unit}]" if unit else meaning for unit, meaning in known.values()]


def test_a_misspelt_measure_is_an_error_of_mypy(tmp_path: Path) -> None:
    script = tmp_path / "script.py"
    script.write_text(
        "import springback\n"
        'flight = springback.fly("scenario.toml")\n'
        "right: float | None = flight.impact_peak_acceleration\n"
        "wrong = flight.impact_peak_acceleraton\n"
    )
    words = [sys.executable, "-m", "mypy", "--strict", str(script)]
    done = run(words, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 1, done.stdout + done.stderr
    [line] = [line for line in done.stdout.splitlines() if "error" in line and "Found" not in line]
    assert 'script.py:4: error: "Flight" has no attribute "impact_peak_acceleraton"' in line


def test_a_flight_lists_its_measures(flight: Flight) -> None:
    assert set(MEASURES) | {"save", "events", "columns"} <= set(dir(flight))
    assert not set(RECOVERY_MEASURES) & set(dir(flight))
    assert flight.touch_speed == flight.measures["touch_speed"]
    misspelt = "touch_sped"
    with pytest.raises(AttributeError, match="touch_sped"):
        getattr(flight, misspelt)


# -- events ---------------------------------------------------------------------------------------


def test_events_are_where_measures_and_columns_say(flight: Flight) -> None:
    events = flight.events
    assert [e.t for e in events] == sorted(e.t for e in events)
    first = {e.kind: e for e in reversed(events)}
    assert first["touch"].t == flight.touch_time
    assert first["separation"].t == flight.separation_time
    assert first["separation"].value == pytest.approx(flight.contact_time, abs=1e-12)
    assert (first["peak"].t, first["peak"].value) == (
        flight.peak_acceleration_time, flight.peak_acceleration,
    )  # fmt: skip
    assert first["contact"].t == pytest.approx(flight.touch_time, abs=1e-9)
    by_arm = {j: [e for e in events if e.arm == j and e.kind == "contact"] for j in range(1, 5)}
    touched = {j for j in by_arm if flight.columns[f"fn{j}"].max() > 0.0}
    assert touched == {j for j, found in by_arm.items() if found} != set()
    for e in (e for e in events if e.kind == "release"):
        assert flight.columns[f"fn{e.arm}"][np.searchsorted(flight.t, e.t)] == 0.0
    assert first["settled"].t > value(flight, "separation_time")
    assert (events[-1].kind, events[-1].t) == ("end", flight.t[-1])
    assert "stop" not in first


def test_the_end_of_the_force_and_the_separation_are_told_apart(flight: Flight) -> None:
    """A viscous surface comes back slower than a vehicle leaves it: two ends, and why."""
    said = {e.kind: e.text for e in flight.events}
    assert said["release"].startswith("cage ")
    assert " is without force after " in said["release"]
    assert "without force" not in said["separation"]
    later = replace(flight, measures=flight.measures | {
        "separation_time": value(flight, "separation_time") + 0.01,
    })  # fmt: skip
    [separation] = [e for e in later.events if e.kind == "separation"]
    last = 1e3 * (separation.t - max(e.t for e in later.events if e.kind == "release"))
    assert last == pytest.approx(10.0, abs=0.1)
    assert separation.text.endswith(
        f"the last {last:.1f} ms of them without force, still within the obstacle's undeformed "
        "surface"
    )


def test_end_stops_are_events_of_their_arms() -> None:
    flight = flown("arq", speed=6.0, yaw=0.78)
    stops = [e for e in flight.events if e.kind == "stop"]
    # A step ends at the stop, to within rounding, and the record tells of that instant.
    assert value(flight, "bottomed_time") == stops[0].t
    assert max(e.value or 0.0 for e in stops) == pytest.approx(
        value(flight, "arm_stroke"), rel=1e-3
    )
    assert [e.t for e in flight.events if e.kind == "bottomed"] == [flight.bottomed_time]


# -- any time base --------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def spun() -> Flight:
    """Far from everything, turning about its vertical axis at 8 rad/s."""
    return fly(towards_wall(position=[-9.0, 0.0, 0.0], angular_velocity=[0.0, 0.0, 8.0]))


def test_instants_between_are_linear_and_attitudes_turn_evenly(spun: Flight) -> None:
    few = replace(spun, columns={name: values[::50] for name, values in spun.columns.items()})
    even = few.resample(2e-3)
    assert np.diff(even["t"]) == pytest.approx(2e-3)
    assert even["t"][-1] == pytest.approx(0.25)
    assert even["x"] == pytest.approx(-9.0 + 2.0 * even["t"], abs=1e-9)
    assert even["qw"] == pytest.approx(np.cos(4.0 * even["t"]), abs=1e-6)
    assert even["qz"] == pytest.approx(np.sin(4.0 * even["t"]), abs=1e-6)
    flipped = {**few.columns, **{f"q{p}": -few.columns[f"q{p}"] for p in "wxyz"}}
    assert (replace(few, columns=flipped).resample(2e-3)["qw"] == -even["qw"]).all()


def test_telemetry_keeps_the_last_tick_and_recorded_instants_stay(flight: Flight) -> None:
    with_pilot = replace(
        flight, telemetry={"t": np.array([0.0, 0.1]), "phase": np.array([0.0, 3.0])}
    )
    assert with_pilot.resample(times=[0.0, 0.0999, 0.1, 0.2])["phase"].tolist() == [0, 0, 3, 3]
    same = flight.resample(times=flight.t)
    assert list(same) == list(flight.columns)
    for name, values in flight.columns.items():
        assert same[name] == pytest.approx(values, abs=1e-12), name


@pytest.mark.parametrize(
    ("given", "said"),
    [({}, "give either"), ({"step": 0.0}, "step: must be from"), ({"step": 9.0}, "step: must be"),
     ({"times": [0.1, 0.3]}, "times: must be instants from 0 s to 0.25 s")],
)  # fmt: skip
def test_instants_outside_are_refused(flight: Flight, given: dict[str, Any], said: str) -> None:
    with pytest.raises(InputError, match=said):
        flight.resample(**given)


# -- any point ------------------------------------------------------------------------------------


def test_angular_acceleration_is_that_of_the_equations_of_motion(flight: Flight) -> None:
    model, found = flight.scenario.flight_model(), angular_acceleration(flight)
    for k in in_contact(flight, 8):
        alpha = rates(model, state_at(flight, k), 1.0).motion.state.angular_velocity
        assert found[k] == pytest.approx(tuple(alpha), rel=1e-9, abs=1e-7), k
    assert np.abs(found).max() > 100.0


def test_specific_force_is_the_change_of_the_velocity_of_the_point(flight: Flight) -> None:
    from scipy.spatial.transform import Rotation

    c, t, r = flight.columns, flight.t, np.array([0.08, -0.03, 0.02])
    turn = Rotation.from_quat(np.stack([c[f"q{p}"] for p in "wxyz"], 1), scalar_first=True)
    spin = np.stack([c[f"w{a}"] for a in "xyz"], 1)
    v = np.stack([c[f"v{a}"] for a in "xyz"], 1) + turn.apply(np.cross(spin, r))
    felt = turn.apply(flight.specific_force(r.tolist())) - [0.0, 0.0, 9.81]
    step = np.diff(t)[:, None]
    inside = (np.diff(t) < 1.5e-4) & (t[1:] < value(flight, "separation_time"))
    error = np.diff(v, axis=0) / step - 0.5 * (felt[1:] + felt[:-1])
    # 1.2 % by the trapezoidal rule in the longest step beside a stop, a quarter in steps of half.
    assert np.abs(error[inside]).max() < 0.015 * np.abs(felt).max()
    centre = turn.apply(flight.specific_force()) - [0.0, 0.0, 9.81]
    assert centre == pytest.approx(np.stack([c[f"a{a}"] for a in "xyz"], 1), abs=1e-9)
    assert np.abs(felt - centre).max() > 5.0


def test_a_point_of_a_turning_body_feels_the_centripetal_acceleration(spun: Flight) -> None:
    felt = spun.specific_force((0.1, -0.05, 0.3))
    assert felt == pytest.approx(np.tile([-6.4, 3.2, 0.0], (len(spun.t), 1)), abs=1e-9)


def test_a_vehicle_on_a_rail_does_not_turn(flight: Flight) -> None:
    slider = as_scenario(towards_wall("arq-slider"), ("model.slider=[1, 0, 0]",))
    assert not angular_acceleration(replace(flight, scenario=slider)).any()


# -- distances ------------------------------------------------------------------------------------


def test_gaps_are_those_of_the_contact_laws(flight: Flight) -> None:
    gap, model = flight.gap(), flight.scenario.flight_model()
    assert gap.shape == (len(flight.t), 5)
    assert gap.min() == pytest.approx(-value(flight, "penetration"), rel=1e-12)
    at_touch = int(np.searchsorted(flight.t, value(flight, "touch_time")))
    assert abs(gap[at_touch].min()) < 1e-8
    for k in (0, *in_contact(flight, 4), len(flight.t) - 1):
        nearest = clearance(model.airframe, model.world, model.contact_point, state_at(flight, k))
        assert gap[k].min() == pytest.approx(nearest, abs=1e-12)
    assert (flight.gap(0) == gap).all()
    with pytest.raises(InputError, match=r"obstacle: must be from 0 to 0 \(got 1\)"):
        flight.gap(1)


# -- files, replay, films -------------------------------------------------------------------------


def test_a_saved_flight_is_loaded_as_it_was(flight: Flight, tmp_path: Path) -> None:
    files = flight.save(tmp_path / "a", figures=False)
    assert sorted(p.name for p in files) == ["summary.json", "trajectory.parquet"]
    again = springback.load(tmp_path / "a")
    assert again.summary() == flight.summary()
    assert all((again.columns[name] == flight.columns[name]).all() for name in flight.columns)
    assert (again.gap() == flight.gap()).all()
    with pytest.raises(InputError) as problem:
        flight.save(tmp_path / "a")
    assert str(problem.value) == (
        f"{tmp_path / 'a'}: is not empty; give another folder, or force=True to replace results"
    )
    (tmp_path / "a/flight.png").write_bytes(b"of another flight")
    flight.save(tmp_path / "a", figures=False, force=True)
    assert not (tmp_path / "a/flight.png").exists()


def test_a_view_is_a_page_a_frame_or_a_server(
    flight: Flight, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    served: list[dict[str, Any]] = []
    monkeypatch.setattr(viewer, "serve", lambda app, **options: served.append(options))
    page = flight.view(flight, export=tmp_path / "a.html")
    assert (tmp_path / "a.html").read_text(encoding="utf-8") == page.text
    assert page._repr_html_().startswith('<iframe srcdoc="&lt;!doctype html')
    with pytest.raises(InputError, match=r"^\S+a\.html: already exists; force=True replaces it$"):
        flight.view(export=tmp_path / "a.html")
    assert served == []
    flight.view(browser=False)
    assert [one["browser"] for one in served] == [False]
    shell = types.SimpleNamespace(kernel=object())
    ipython = types.SimpleNamespace(get_ipython=lambda: shell, version_info=(9, 0))
    monkeypatch.setitem(sys.modules, "IPython", ipython)
    saved = flight.save(tmp_path / "b", figures=False)[0].parent
    assert flight.view().text == springback.load(saved).view().text
    assert len(served) == 1


def test_a_film_is_written_once(flight: Flight, tmp_path: Path) -> None:
    path = tmp_path / "films/a.gif"
    short: dict[str, Any] = {"begin": -0.002, "end": 0.004, "fps": 5.0, "size": (160, 160)}
    assert flight.animate(path, **short) == path
    assert path.read_bytes()[:6] == b"GIF89a"
    with pytest.raises(InputError, match=r"a\.gif: already exists; give another, or force=True$"):
        flight.animate(path, **short)
    with pytest.raises(InputError, match=r"^begin 0.1 s must be before end 0.05 s$"):
        flight.animate(tmp_path / "b.gif", begin=0.1, end=0.05)
    with pytest.raises(InputError, match=r"^a film shows one flight or two \(got 3\)$"):
        flight.animate(tmp_path / "b.gif", flight, flight)


# -- figures and notebooks ------------------------------------------------------------------------


def test_columns_are_drawn_as_wide_as_a_column_of_a_paper(flight: Flight) -> None:
    figure = flight.plot(["x", "z", "vx", "fn2"])
    assert figure.get_figwidth() * 25.4 == pytest.approx(88.0)
    assert [ax.get_ylabel() for ax in figure.axes] == [
        "Position [m]", "Velocity [m/s]", "Normal force [N]",
    ]  # fmt: skip
    assert figure.axes[-1].get_xlabel() == "Time [s]"
    assert {text.get_fontsize() for ax in figure.axes for text in ax.texts} == {7.0}
    wide = flight.plot([["x"], ["z"]], width="two columns", height="60 mm", window=(0.0, 0.05))
    assert (wide.get_figwidth() * 25.4, wide.get_figheight() * 25.4) == pytest.approx((180.0, 60.0))
    assert [ax.get_xlim() for ax in wide.axes] == [(0.0, 0.05)] * 2
    assert [len(ax.lines) for ax in wide.axes] == [1, 1]
    assert len(flight.plot().axes) > 3


@pytest.mark.parametrize(
    ("columns", "given", "said"),
    [("xx", {}, "there is no column 'xx'; there are ax, ay"), ([], {}, "name at least one"),
     ([["x", "vx"]], {}, "x, vx have different units: m, m/s"), ([[]], {}, "must have at least one"),
     ("x", {"width": "wide"}, "width: must be 'one column', 'two columns', a number in m"),
     ("x", {"width": 88.0}, r"width: must be from 0.03 to 1.0 m \(got 88 m\)"),
     ("x", {"height": "1 s"}, "height: must be"), ("x", {"window": (1.0, 2.0)}, "window: must be")],
)  # fmt: skip
def test_bad_figures_are_refused(flight: Flight, columns: Any, given: Any, said: str) -> None:
    with pytest.raises(InputError, match=said):
        flight.plot(columns, **given)


def test_a_notebook_shows_outcome_measures_and_path(flight: Flight) -> None:
    page = flight._repr_html_()
    assert "&lt;b&gt;&amp;" in page
    assert "<b>separated</b>, hit an obstacle and left it again" in page
    assert all(f">{name}<" in page for name in MEASURES)
    assert 'src="data:image/png;base64,' in page
    short = fly(towards_wall(), trajectory=False)
    assert "<img" not in short._repr_html_()


def test_without_a_trajectory_it_is_said() -> None:
    short = fly(towards_wall(), trajectory=False)
    for asked in (short.plot, short.gap, short.specific_force, short.view, lambda: short.events):
        with pytest.raises(InputError, match="this flight has no trajectory"):
            asked()


@pytest.mark.parametrize(("thick", "pierced"), [(0.01, True), (0.2, False)])
def test_a_plate_of_a_mesh_that_is_pierced_is_told(thick: float, pierced: bool) -> None:
    """Deeper than its middle a contact is nearer to the other side; forces hold less deep."""
    plate = {"type": "mesh", "file": box_file(thick, 1.0, 1.0), "surface": "wall",
             "position": [2.75 + 0.5 * thick, 0.0, 1.0], "cell": thick / 5.0}  # fmt: skip
    tables = {
        "vehicle": "arq", "thrust": "hover", "world": {"obstacles": [plate]},
        "start": {"position": [2.4, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0]},
        "simulation": {"duration": 0.15},
    }  # fmt: skip
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        fly(tables)
    told = [str(one.message) for one in caught if one.category is ContactWarning]
    assert bool(told) == pierced
    said = (
        "of world.obstacles[0], a mesh with cells of 2 mm, hold to some 2 mm: beyond that they are"
    )
    assert not told or said in told[0]


def at_a_plate(thick: float, **changes: Any) -> dict[str, Any]:
    """Robot that meets the edge of a level plate at 2 m/s."""
    plate = {"type": "box", "position": [3.35, 0.0, 1.0], "size": [1.2, 0.8, thick],
             "surface": "wall"}  # fmt: skip
    return {
        "vehicle": "quad", "thrust": "hover", "world": {"obstacles": [plate | changes]},
        "start": {"position": [2.4, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0], "yaw": "45 deg"},
        "simulation": {"duration": 0.15},
    }  # fmt: skip


@pytest.mark.parametrize(
    ("rebound", "kept", "words"),
    [
        (0.5, "all", None), (1.0 + 5e-7, "all", None), (1.0 + 2e-6, "none", "; above 1: "),
        (-0.1, "all", "; below 0: it left past what it hit"),
        (1.2, "none", "; above 1: it left faster along the normal of its first touch than it came; "),
        (1.2, "two cages", " contacts (cage 1, cage 2) are one impact, measured along the normal of "),
    ],
)  # fmt: skip
def test_a_restitution_beyond_0_to_1_is_explained(
    flight: Flight, rebound: float, kept: str, words: str | None
) -> None:
    """With the contacts that the first impact joins, if the trajectory tells them."""
    measured = flight.measures | {"restitution_at_separation": rebound}
    c = flight.columns
    columns = {"all": c, "none": {}, "two cages": c | {"fn1": c["fn2"], "ff1": c["ff2"]}}[kept]
    told = replace(flight, measures=measured, columns=columns)
    line = next(one for one in repr(told).splitlines() if "restitution_at_separation" in one)
    assert words in line if words else line.endswith(f" {rebound:.5g}")


@pytest.mark.filterwarnings("ignore::springback.errors.LedgerWarning")
def test_a_plate_that_is_pushed_through_is_told_and_nothing_bounces() -> None:
    """Of 3 cm: half its thickness is the depth of contact; a stiffer or thicker one bounces."""
    with pytest.warns(ContactWarning, match=r"obstacles\[0\], a box, is some 15 mm"):
        through = fly(at_a_plate(0.03))
    restitution = through.measures["restitution_at_separation"]
    left = np.searchsorted(through.t, through.measures["separation_time"])
    assert restitution is not None
    assert restitution < 0.0
    assert through.columns["vx"][left] == pytest.approx(-2.0 * restitution, rel=1e-2)
    stiff = {"surface": {"preset": "wall", "stiffness": 5e6}}
    with warnings.catch_warnings():
        warnings.simplefilter("error", ContactWarning)
        for table in (at_a_plate(0.03, **stiff), at_a_plate(0.1)):
            bounced = fly(table).measures["restitution_at_separation"]
            assert bounced is not None
            assert bounced > 0.4


def test_a_thin_obstacle_far_from_the_flight_is_not_blamed() -> None:
    """Deep contact with a thick one, and a thin pole a metre away."""
    given = at_a_plate(0.1)
    given["world"]["obstacles"].append(
        {"type": "pole", "position": [2.4, 2.0, 0.0], "radius": 0.005, "surface": "wall"}
    )
    with warnings.catch_warnings():
        warnings.simplefilter("error", ContactWarning)
        fly(given)
