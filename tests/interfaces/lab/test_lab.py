"""The impact lab without a browser: settings, links, scenarios, answers, refusals."""

# what is optional is asked for before what needs it

import base64
import json
import math
import re
from dataclasses import replace
from pathlib import Path
from typing import Any
from urllib.parse import parse_qsl

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

pytest.importorskip("starlette", reason="the lab needs the extra web")
pytest.importorskip("uvicorn", reason="the lab needs the extra web")


from interfaces.lab.lab_served import WRONG
from springback.contact.library import SURFACES
from springback.errors import InputError
from springback.interfaces.lab.app import page
from springback.interfaces.lab.measures import sentence
from springback.interfaces.lab.queue import example_of, kind_of
from springback.interfaces.lab.responses import RESOLUTION, answer
from springback.interfaces.lab.scenarios import BEFORE, lab_scenario, lab_tables, lab_toml
from springback.interfaces.lab.settings import (
    DEFAULTS,
    FIELDS,
    ChoiceControl,
    LabSettings,
    SliderControl,
    control_of,
    controls,
    query_of,
    settings_from,
)
from springback.paper.printed import TABLE_III
from springback.paper.slider import QUAD, READINGS, fitted_dissipation, slider_tables
from springback.results.flight import fly
from springback.scenario.files import read_scenario
from springback.scenario.scenario import scenario_from
from springback.vehicle.library import ARQ

SLIDERS = {name: slider for name in FIELDS if isinstance(slider := control_of(name), SliderControl)}


def setting(**words: Any) -> LabSettings:
    return settings_from((name, str(value)) for name, value in words.items())


# -- settings and links ---------------------------------------------------------------------------


def any_settings() -> st.SearchStrategy[LabSettings]:
    parts: dict[str, Any] = {}
    for name in FIELDS:
        control = control_of(name)
        if isinstance(control, ChoiceControl):
            parts[name] = st.sampled_from(list(control.words))
        elif control.whole:
            parts[name] = st.integers(int(control.least), int(control.most)).map(float)
        else:
            numbers = st.floats(control.least, control.most)
            parts[name] = numbers.filter(lambda x: x == 0.0 or abs(x) >= 1e-28)  # as all settings
    return st.builds(LabSettings, **parts)


@given(any_settings())
@settings(max_examples=200)
def test_a_link_carries_settings_to_the_last_bit(one: LabSettings) -> None:
    query = query_of(one)
    again = settings_from(parse_qsl(query))
    assert again == one
    assert query_of(again) == query


def test_a_link_says_what_differs_and_nothing_else() -> None:
    assert query_of(DEFAULTS) == ""
    assert (
        query_of(setting(stiffness="2.6", pitch="-30", speed=DEFAULTS.speed))
        == "pitch=-30&stiffness=2.6"
    )
    assert setting(stiffness="2600 N/m").stiffness == 2.6


@pytest.mark.parametrize("name", SLIDERS)
def test_defaults_and_the_papers_values_are_in_range(name: str) -> None:
    slider = SLIDERS[name]
    assert slider.least <= getattr(DEFAULTS, name) <= slider.most
    assert all(slider.least <= mark.value <= slider.most for mark in slider.marks)
    assert setting(
        **{
            name: f"{slider.most} {slider.unit}"
            if slider.unit in ("m/s", "deg", "g")
            else slider.most
        }
    )


def test_marks_are_the_numbers_of_the_package() -> None:
    arms = ARQ.vehicle.arms
    table = {
        "stiffness": 1e-3 * arms.stiffness,
        "damping": arms.damping,
        "arm_mass": 1e3 * arms.mass,
    }  # type: ignore[operator]
    for name, value in table.items():
        assert [mark.value for mark in SLIDERS[name].marks] == [pytest.approx(value)], name
        assert getattr(DEFAULTS, name) == pytest.approx(value), name
    wall = [m.value for m in SLIDERS["dissipation"].marks if m.words.startswith("wall")]
    assert wall == [pytest.approx(SURFACES["wall"].dissipation_value(), abs=5e-4)]


def test_the_page_is_made_from_the_table() -> None:
    found = re.search(r'id="data">(.*?)</script>', page().text, re.DOTALL)
    assert found
    assert json.loads(found[1])["controls"] == json.loads(json.dumps(controls()))


@pytest.mark.parametrize("query", WRONG)
def test_wrong_settings_are_told_in_one_line(query: str) -> None:
    with pytest.raises(InputError) as told:
        settings_from(parse_qsl(query, keep_blank_values=True))
    assert len(told.value.problems) == 1
    assert told.value.problems[0].startswith(WRONG[query])
    assert len(told.value.problems[0]) < 400  # it names all keys


# -- what is flown --------------------------------------------------------------------------------


@pytest.mark.parametrize(("robot", "reading"), [("arq", READINGS[1]), ("quad", QUAD)])
@pytest.mark.parametrize("surface", ["wall", "mat"])
def test_as_it_opens_it_is_the_papers_slider_test(robot: str, reading: Any, surface: str) -> None:
    ours = fly(lab_scenario(setting(surface=surface), robot), trajectory=False)
    papers = fly(
        slider_tables(reading, surface, 1.85, fitted_dissipation(surface)), trajectory=False
    )
    for name in ("restitution_at_separation", "impact_peak_acceleration", "contact_time", "travel"):
        assert ours.measures[name] == pytest.approx(papers.measures[name], rel=1e-9), name


@pytest.mark.parametrize("words", [
    {}, {"pitch": 40, "yaw": 10, "speed": 0.7}, {"pitch": -60, "yaw": -45, "speed": 6},
])  # fmt: skip
@pytest.mark.parametrize("guide", ["slider", "free"])
def test_an_impact_arrives_as_asked(guide: str, words: dict[str, Any]) -> None:
    asked = setting(guide=guide, **words)
    m = fly(lab_scenario(asked, "arq"), trajectory=False).measures
    # Steps land on a touch to within 1e-7 s, the shortest of them.
    assert m["touch_time"] == pytest.approx(BEFORE, abs=1.1e-7)
    assert m["touch_speed"] == pytest.approx(asked.speed, rel=2e-6)


SHAPES = [
    {"obstacle": "pole", "radius": 120, "offset": 60},
    {"obstacle": "pole", "pitch": 35, "speed": 3, "robot": "quad"},
    {"obstacle": "sphere", "radius": 20, "yaw": 45},
    {"obstacle": "edge", "turn": 25, "offset": -80, "surface": "mat"},
    {"obstacle": "window", "opening": 440, "surface": "own", "friction": 0.1},
    {"obstacle": "slope", "incline": 55, "pitch": -20},
]  # fmt: skip


@pytest.mark.parametrize("words", SHAPES)
def test_an_obstacle_is_hit_as_the_wall_is(words: dict[str, Any]) -> None:
    """It flies on at the speed asked for until first touch, freely, at the instant asked for."""
    asked = setting(**words)
    robot = words.get("robot", "arq")
    scenario = lab_scenario(asked, robot)
    [thing] = scenario.world.obstacles
    assert thing.type == words["obstacle"]
    assert scenario.model.slider is None  # the slider is in front of a wall alone
    flight = fly(scenario)
    touch = flight.measures["touch_time"]
    # By the pull of a tilted thrust over 25 ms, less than a millimetre, other parts may be nearer.
    assert touch == pytest.approx(BEFORE, abs=3e-4)
    at = int(np.searchsorted(flight.columns["t"], touch))
    assert flight.columns["vx"][at] == pytest.approx(asked.speed, rel=2e-3)
    assert np.hypot(flight.columns["vy"][at], flight.columns["vz"][at]) < 3e-3
    shown = answer(asked)
    one = next(found for found in shown["flights"] if found["robot"] == robot)
    assert f" hits the {words['obstacle']} at " in one["sentence"]
    drawn = [found["name"] for found in one["scene"]["obstacles"]]
    assert drawn == [words["obstacle"]]
    assert shown["printed_for"] == {"words": "", "same": False}
    assert not any(row["printed"] for row in shown["measures"])


@pytest.mark.parametrize(
    "words", [{"speed": 1.5, "radius": 100}, {"speed": 4, "yaw": 45, "offset": 30}]
)
def test_a_ball_hits_the_hovering_robot_at_the_speed_asked_for(words: dict[str, Any]) -> None:
    """At its lowest point, at the instant asked for."""
    asked = setting(obstacle="ball", ball_mass=0.7, **words)
    [ball] = lab_scenario(asked, "arq").world.obstacles
    assert (ball.type, ball.motion.mass) == ("sphere", 0.7)
    flight = fly(lab_tables(asked, "arq"), "simulation.duration=0.03")
    c, touch = flight.columns, flight.measures["touch_time"]
    assert touch == pytest.approx(BEFORE, abs=1e-5)
    at = int(np.searchsorted(c["t"], touch))
    assert c["obstacle0_vx"][at] == pytest.approx(-asked.speed, rel=1e-4)
    assert abs(c["obstacle0_vz"][at]) < 1e-4 * asked.speed
    assert c["obstacle0_y"][at] == pytest.approx(1e-3 * asked.offset, abs=1e-9)
    assert abs(c["vx"][at]) < 1e-3


def test_in_flight_a_ball_is_on_its_way_for_half_a_second() -> None:
    """It would hang 60 cm before the robot, which holds its place with its heading."""
    tables = lab_tables(
        setting(obstacle="ball", mode="flight", speed=1.5, yaw=20, radius=100), "arq"
    )
    ball, ground = tables["world"]["obstacles"]
    assert ground["type"] == "ground"
    assert tables["reference"] == {
        "type": "hold", "position": tables["start"]["position"], "yaw": "20 deg"
    }  # fmt: skip
    pivot, place = ball["motion"]["pivot"], tables["start"]["position"]
    assert pivot[0] == pytest.approx(2.75 + 0.1 + 0.6)
    assert math.dist(ball["position"], pivot) == pytest.approx(1.5)
    # Its energy is that of its speed at the touch, at the height of the robot.
    about = 1.0 + 0.4 * (0.1 / 1.5) ** 2
    kinetic = 0.5 * about * (1.5 * ball["motion"]["angular_velocity"][1]) ** 2
    fall = 9.81 * (ball["position"][2] - place[2])
    assert kinetic + fall == pytest.approx(0.5 * about * 1.5**2, rel=1e-5)


def test_a_door_opens_away_from_the_robot() -> None:
    door = lab_tables(setting(obstacle="door", door_mass=12, offset=100), "arq")["world"][
        "obstacles"
    ][0]
    assert door["position"] == pytest.approx([2.75 + 0.02, 0.1, 1.0])
    motion = door["motion"]
    assert motion["pivot"] == pytest.approx([2.77, 0.55, 1.0])
    assert (motion["mass"], motion["lowest"]) == (12.0, 0.0)
    tables = lab_tables(setting(obstacle="door"), "arq")
    flight = fly(tables, "simulation.duration=0.035")
    assert flight.measures["touch_time"] == pytest.approx(BEFORE, abs=3e-4)
    assert flight.columns["obstacle0_wz"][-1] > 0.0
    assert flight.columns["obstacle0_vx"][-1] > 0.0


def test_another_robot_is_hit_where_a_wall_would_be() -> None:
    """Both come from their sides; in flight the other holds its place by a pilot of its own."""
    asked = setting(obstacle="robot", speed=2, other_speed=1)
    flight = fly(lab_tables(asked, "arq"), "simulation.duration=0.04")
    assert flight.measures["touch_time"] == pytest.approx(BEFORE, abs=2e-6)
    assert flight.measures["touch_speed"] == pytest.approx(3.0, rel=1e-6)
    assert flight.second is not None
    assert flight.second.scenario.name == "other ARQ"
    softer = lab_tables(setting(obstacle="robot", surface="own", contact_stiffness=50), "quad")
    assert softer["second"]["surface"]["stiffness"] == 5e4
    assert softer["second"]["vehicle"] == softer["vehicle"]
    assert "velocity" not in softer["second"]["start"]
    hovers = lab_tables(setting(obstacle="robot", mode="flight", offset=100, yaw=10), "arq")
    assert [one["type"] for one in hovers["world"]["obstacles"]] == ["ground"]
    start = hovers["second"]["start"]
    assert start == {"position": [pytest.approx(2.75 + 0.2443516), 0.1, 1.0], "yaw": "170 deg"}
    assert hovers["second"]["reference"] == {"type": "hold", **start}
    assert hovers["second"]["recovery"] == hovers["recovery"]
    assert scenario_from(hovers).second is not None
    kinds = {kind_of(setting(obstacle="robot", mode=mode)).words for mode in ("impact", "flight")}
    assert kinds == {
        "impacts on another robot, free", "flights into another robot, recovery by a quintic"
    }  # fmt: skip
    assert example_of(setting(obstacle="robot", offset=7)).obstacle == "robot"


def test_what_moves_is_a_kind_of_its_own() -> None:
    """In an impact a ball and a door are one; before a ball a pilot hovers."""
    ball, door = setting(obstacle="ball"), setting(obstacle="door")
    assert kind_of(ball) == kind_of(door) != kind_of(setting(obstacle="pole"))
    assert kind_of(ball).words == "impacts on what moves, free"
    flown = [kind_of(setting(obstacle=word, mode="flight")) for word in ("ball", "door", "pole")]
    assert len(set(flown)) == 3
    assert flown[0].words == "hits on a hovering robot by a ball, recovery by a quintic"
    assert example_of(setting(obstacle="ball", radius=7)).obstacle == "ball"


def test_numbers_of_an_obstacle_are_those_of_its_controls() -> None:
    """In front of the robot stands what is asked for, as near as the wall would be."""

    def made(**words: Any) -> dict[str, Any]:
        return dict(lab_tables(setting(**words), "arq")["world"]["obstacles"][0])

    pole = made(obstacle="pole", radius=80, offset=-30)
    assert (pole["radius"], pole["position"]) == (0.08, pytest.approx([2.83, -0.03, 0.0]))
    window = made(obstacle="window", opening=600, turn=10)
    assert (window["opening"], window["size"]) == ([0.6, 0.6], pytest.approx([1.1, 1.1]))
    assert window["yaw"] == "10 deg"
    slope = made(obstacle="slope", incline=20, mode="flight", yaw=15)
    assert (slope["angle"], slope["uphill"]) == ("20 deg", "-15 deg")
    edge = made(obstacle="edge", mode="flight", yaw=15, turn=5, surface="mat")
    assert (edge["yaw"], edge["surface"]) == ("-10 deg", "mat")
    assert "normal" not in edge
    assert made(radius=80)["type"] == "wall"


def test_a_window_is_flown_through_where_there_is_room() -> None:
    """Touching nothing is what it should do there; of a pole that is passed by it is not."""
    [through] = answer(setting(obstacle="window", opening=700, robot="arq"))["flights"]
    assert through["sentence"] == "ARQ flies through the window and touches nothing."
    assert through["well"]
    [past] = answer(setting(obstacle="pole", offset=450, robot="arq"))["flights"]
    assert past["sentence"] == "ARQ touches nothing."
    assert not past["well"]


def test_all_shapes_are_one_kind_to_compile_and_the_wall_is_another() -> None:
    kinds = {kind_of(setting(**words)) for word in ("pole", "edge", "window", "slope")
             for words in ({"obstacle": word}, {"obstacle": word, "guide": "free", "surface": "mat"})}  # fmt: skip
    assert len(kinds) == 1
    [kind] = kinds
    assert kind.words == "impacts on poles, windows and the like, free"
    assert kind not in {kind_of(DEFAULTS), kind_of(setting(guide="free"))}
    example = example_of(setting(obstacle="window", opening=100))
    assert kind_of(example) == kind
    assert example.obstacle == "pole"


def test_in_flight_a_yaw_turns_the_wall_about_the_vertical() -> None:
    wall = lab_tables(setting(mode="flight", yaw=30), "arq")["world"]["obstacles"][0]
    assert wall["normal"] == pytest.approx([-math.cos(math.pi / 6), 0.5, 0.0])
    face = lab_tables(setting(mode="flight", yaw=30, surface="mat"), "arq")["world"]["obstacles"][0]
    backing = -face["normal"][0] * (face["position"][0] - wall["position"][0])
    assert backing == pytest.approx(face["thickness"])


ODD = [
    {"robot": "arq", "stiffness": 1 / 0.3, "damping": 33.3, "arm_mass": 70.1, "speed": 2.345678901234567},
    {"robot": "quad", "guide": "free", "surface": "own", "dissipation": 0.2, "contact_stiffness": 77.7, "pitch": 12.34, "yaw": -7},
    {"robot": "arq", "mode": "flight", "speed": 2.2, "recovery": "set-point"},
]  # fmt: skip


@pytest.mark.parametrize("words", ODD)
def test_the_downloaded_scenario_flies_to_the_same_bits(
    words: dict[str, Any], tmp_path: Path
) -> None:
    asked, robot = setting(**words), words["robot"]
    file = tmp_path / "lab.toml"
    file.write_text(lab_toml(asked, robot), encoding="utf-8")
    flight = fly(read_scenario(file))
    shown = answer(asked)
    for row in shown["measures"]:
        measure = flight.measures.get(row["name"])
        if measure is not None and row["unit"] in ("", "m/s", "m/s²", "N", "s"):
            assert row["values"][robot] == measure, row["name"]
    assert shown["flights"][0]["outcome"] == flight.outcome.word
    assert shown["flights"][0]["scene"]["t"]["shape"][0] > 100


# -- answers --------------------------------------------------------------------------------------


def unpacked(packed: dict[str, Any]) -> Any:
    kind = {"f4": "<f4", "f8": "<f8", "i4": "<i4"}[packed["type"]]
    return np.frombuffer(base64.b64decode(packed["data"]), kind).reshape(packed["shape"])


def test_an_answer_has_curves_energy_and_print_beside_it() -> None:
    told = answer(DEFAULTS)
    flights = {one["robot"]: one for one in told["flights"]}
    for robot, one in flights.items():
        series = {(s["panel"], s["name"]): unpacked(s["values"]) for s in one["scene"]["series"]}
        rows = {row["name"]: row for row in told["measures"]}
        curve = series["Acceleration", "main body"]
        assert curve.max() == pytest.approx(
            rows["impact_peak_acceleration"]["values"][robot],
            rel=1e-4,  # between instants
        )
        pressed = series["Arm compression", "most compressed arm"].max()
        assert pressed == pytest.approx(rows["impact_arm_stroke"]["values"][robot], abs=0.02)
        energy = sum(values for (panel, _), values in series.items() if panel == "Energy")
        assert energy == pytest.approx(energy[0], rel=1e-3)  # nothing puts energy in on a slider
        assert {name for panel, name in series if panel == "Energy"} >= {
            "motion",
            "contact",
            "lost in contact",
        }
        printed = TABLE_III[robot, "wall"]
        words = f"{printed.restitution:.3g} ({printed.restitution_test:.3g})"
        assert rows["restitution_at_separation"]["printed"][robot] == words
        assert one["well"]
        assert one["sentence"].startswith(one["label"] + " hits the wall at 1.85 m/s, leaves it at")
    assert told["printed_for"]["same"]
    assert not answer(setting(speed=2))["printed_for"]["same"]


def test_a_speed_of_departure_below_0_is_explained_as_by_fly() -> None:
    flight = fly(lab_scenario(DEFAULTS, "arq"))
    past = replace(flight, measures=flight.measures | {"restitution_at_separation": -0.1})
    said = sentence(DEFAULTS, "arq", past)
    assert ", leaves it at -0.19 m/s after" in said
    assert said.endswith(". Its restitution is below 0: it left past what it hit.")
    assert "below 0: it left past what it hit" in repr(past)
    assert "restitution" not in sentence(DEFAULTS, "arq", flight)


def test_the_sentence_tells_the_peak_of_the_first_impact() -> None:
    """A harder hit later on, such as on the ground, is not the wall's."""
    flight = fly(lab_scenario(DEFAULTS, "arq"), trajectory=False)
    later = replace(flight, measures=flight.measures | {"peak_acceleration": 999.0})
    said = sentence(DEFAULTS, "arq", later)
    assert f"peaks at {flight.impact_peak_acceleration:.0f} m/s²" in said
    assert said == sentence(DEFAULTS, "arq", flight)


def test_what_a_page_gets_is_small_and_keeps_touch_and_peak() -> None:
    told = answer(DEFAULTS)
    assert len(json.dumps(told)) < 250_000
    t = unpacked(told["flights"][0]["scene"]["t"])
    assert t.size < 0.325 / RESOLUTION
    assert abs(t - BEFORE).min() < 1e-9


@pytest.mark.parametrize(
    ("typed", "kept", "query"),
    [
        ({"speed": "10 km/h"}, 2.77778, "speed=2.77778"),
        ({"pitch": "0.5 rad"}, 28.6479, "pitch=28.6479"),
        ({"speed": "2.7777777777777777"}, 2.7777777777777777, "speed=2.7777777777777777"),
    ],
)
def test_numbers_from_other_units_are_as_short_as_the_field(
    typed: dict[str, str], kept: float, query: str
) -> None:
    """Field, link, file and flight have the same number: the one that can be read."""
    (name,) = typed
    settings = settings_from(typed.items())
    assert getattr(settings, name) == kept
    assert query_of(settings) == query
    assert settings_from([tuple(query.split("="))]) == settings  # type: ignore[list-item]


@pytest.mark.parametrize(("robot", "yaw", "cages"), [("quad", 20, 1), ("arq", 0, 2)])
def test_the_force_of_the_lab_is_the_sum_of_the_forces_that_it_draws(
    robot: str, yaw: int, cages: int
) -> None:
    """As vectors: friction has a part in it on one cage, and cancels on two that hold each other."""
    settings = setting(yaw=yaw, guide="free", robot=robot)
    [told] = answer(settings)["flights"]
    scene = told["scene"]
    force, at = (numbers(scene["force"][part]) for part in ("of", "at"))
    [curve] = [one for one in scene["series"] if one["panel"] == "Contact force"]
    drawn = np.zeros(scene["t"]["shape"][0])
    parts = force.reshape(len(at), -1, 3)
    drawn[at.astype(int)] = np.linalg.norm(parts.sum(axis=1), axis=1)
    sizes = np.linalg.norm(parts, axis=2)[np.argmax(drawn[at.astype(int)])]
    assert np.count_nonzero(sizes) == cages
    assert (drawn.max() < 0.95 * sizes.sum()) == (cages == 2)
    assert curve["name"] == "sum of all contacts"
    assert drawn.max() > 100.0
    assert numbers(curve["values"]) == pytest.approx(drawn, rel=1e-5, abs=1e-3)


def numbers(packed: dict[str, Any]) -> Any:
    """The numbers of a packed array."""
    return np.frombuffer(base64.b64decode(packed["data"]), np.dtype(f"<{packed['type']}"))
