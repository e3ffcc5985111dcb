"""The exported replay in a browser: from a file, without a network, by mouse, finger and key."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from builders.pairs import two
from interfaces.browsing import browser, complaints, needs_browser, requests, resized
from interfaces.replay.pages import TABLES, drag, key, opened, pose, until
from springback.interfaces.replay.viewer import export_page, replay_of
from springback.results.events import impacts_of
from springback.results.flight import Flight, fly

pytestmark = needs_browser
#: Numbers beside contact forces.
FORCES = ".force-labels span:not([hidden])"
#: Buttons of the way in which flights are compared.
COMPARE = "[aria-label=Flights] button"


@pytest.fixture(scope="module")
def flights() -> list[Flight]:
    return [fly(TABLES | {"vehicle": robot}) for robot in ("arq", "quad")]


@pytest.fixture(scope="module")
def page(flights: list[Flight], tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("pages") / "two.html"
    export_page(replay_of(flights), path)
    return path


@pytest.fixture(scope="module")
def driver(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    with browser(tmp_path_factory.mktemp("profile")) as found:
        yield found


def test_play_moves_the_robots_and_asks_nobody_for_anything(driver: Any, page: Path) -> None:
    """From file://: play, the pose changes; nothing is loaded but the file; no complaints."""
    opened(driver, page)
    before = pose(driver)
    assert not before["playing"]
    driver.find_element("css selector", "button.play").click()
    until(lambda: pose(driver)["t"] > before["t"] + 0.01)
    driver.find_element("css selector", "button.play").click()
    after = pose(driver)
    assert not after["playing"]
    for flight, earlier in zip(after["flights"], before["flights"], strict=True):
        assert flight["position"] != earlier["position"]
    assert driver.execute_script("return document.querySelectorAll('canvas').length") > 3
    assert [
        url for url in requests(driver) if not url.startswith(("file:", "data:", "blob:"))
    ] == []
    assert complaints(driver) == []


def test_the_page_shows_the_pose_of_the_flight(
    driver: Any, page: Path, flights: list[Flight]
) -> None:
    """At any time: position, quaternion and arm lengths of the trajectory; forces at the impact."""
    opened(driver, page)
    for t in (0.02, flights[0].peak_acceleration_time, 0.25):
        driver.execute_script("window.springback.player.seek(arguments[0])", t)
        for shown, flight in nonempty(zip(pose(driver)["flights"], flights, strict=True)):
            c = flight.columns
            wanted = [np.interp(shown["own"], c["t"], c[axis]) for axis in "xyz"]
            assert shown["position"] == pytest.approx(wanted, abs=1e-4)
            lengths = [np.interp(shown["own"], c["t"], c[f"l{j}"]) for j in (1, 2, 3, 4)]
            assert shown["armLengths"] == pytest.approx(lengths, abs=2e-5)
            turn = [np.interp(shown["own"], c["t"], c[f"q{part}"]) for part in "wxyz"]
            assert shown["quaternion"] == pytest.approx(turn, abs=1e-3)
            for j, contact in zip([1, 2, 3, 4, "_body"], shown["contacts"], strict=True):
                f = np.hypot(*(np.interp(shown["own"], c["t"], c[f"{k}{j}"]) for k in ("fn", "ff")))
                assert (contact["size"] if contact else 0.0) == pytest.approx(f, rel=1e-3, abs=1e-3)


def test_time_is_chosen_by_slider_key_event_and_plot(
    driver: Any, page: Path, flights: list[Flight]
) -> None:
    opened(driver, page)
    touch = flights[0].touch_time
    driver.execute_script(
        "const s = document.querySelector('input[type=range]'); s.value = 1;"
        "s.dispatchEvent(new Event('input'))"
    )
    assert pose(driver)["t"] == pytest.approx(0.3, abs=1e-9)
    key(driver, "t")
    assert pose(driver)["t"] == pytest.approx(touch, abs=1e-9)
    steps = flights[0].columns["t"]
    key(driver, "\ue014")  # arrow to the right: the next step of the integration
    assert pose(driver)["t"] == pytest.approx(steps[steps > touch + 1e-12][0], abs=1e-9)
    key(driver, "\ue012")
    assert pose(driver)["t"] == pytest.approx(touch, abs=1e-9)
    driver.execute_script("document.querySelector('.event.peak').click()")
    peaks = [flight.peak_acceleration_time for flight in flights]
    assert min(abs(pose(driver)["t"] - peak) for peak in peaks) < 0.02
    driver.find_element("css selector", ".u-over").click()  # in its middle
    clicked = driver.execute_script("return window.springback.plots.range")
    assert pose(driver)["t"] == pytest.approx(sum(clicked) / 2, rel=0.02)
    assert complaints(driver) == []


def test_the_pace_is_slow_at_the_impact_and_as_chosen(driver: Any, page: Path) -> None:
    from selenium.webdriver.support.ui import Select

    opened(driver, page)
    key(driver, "t")
    assert "1/5" in driver.find_element("css selector", ".clock .pace").text
    Select(driver.find_element("css selector", ".player select")).select_by_value("200")
    assert pose(driver)["pace"] == "200"
    begin = pose(driver)["t"]
    driver.find_element("css selector", "button.play").click()
    time.sleep(1.0)
    driver.find_element("css selector", "button.play").click()
    assert 0.0 < pose(driver)["t"] - begin < 0.02  # a second of watching is 5 ms of flight


def test_views_of_two_flights(driver: Any, page: Path) -> None:
    """Each view can be chosen; magnified arms move the picture, not the numbers."""
    opened(driver, page, "#t=0.11&camera=impact&compare=ghost&arms=10")
    told = pose(driver)
    assert told["camera"] == "impact"
    for mode in ("follow", "free", "side", "top"):
        driver.find_element("css selector", f"button[data-value={mode}]").click()
        assert pose(driver)["camera"] == mode
    driver.find_element("css selector", "button[data-value=side]").click()
    assert pose(driver)["flights"][0]["armLengths"] == told["flights"][0]["armLengths"]
    assert complaints(driver) == []


def test_flights_can_be_swapped_without_end(driver: Any, page: Path) -> None:
    """The graphics hold as much after twenty swaps as after two."""
    opened(driver, page)
    swap = (
        "const s = window.springback.scene;"
        "for (let k = 0; k < arguments[0]; k++) { s.replace(s.flights); s.drawn?.(); }"
        "return new Promise(r => requestAnimationFrame(() => requestAnimationFrame(() => r(s.memory()))))"
    )
    few, many = driver.execute_script(swap, 2), driver.execute_script(swap, 20)
    assert few["geometries"] > 20
    assert many == few


def test_it_fits_on_a_phone(driver: Any, page: Path) -> None:
    """No wider than the screen, what one presses is large enough for a finger, plots are there."""
    resized(driver, 390, 844)
    opened(driver, page, "#t=0.11")
    assert driver.execute_script("return document.documentElement.scrollWidth") <= 390
    small = driver.execute_script(
        "return [...document.querySelectorAll('button, select')].filter(b => b.offsetParent)"
        ".map(b => [b.textContent, b.getBoundingClientRect().height]).filter(x => x[1] < 28)"
    )
    assert small == []
    widths = driver.execute_script(
        "return [...document.querySelectorAll('.uplot')].map(p => p.getBoundingClientRect().width)"
    )
    assert widths
    assert max(widths) <= 390
    assert complaints(driver) == []


#: Of every plot: the time line, whether it is hidden, its place and that of its time [px].
LINES = """
const { player } = window.springback;
return [...document.querySelectorAll('.plot-now')].map((line) => {
  const over = line.parentElement, [from, to] = window.springback.plots.range ?? [NaN, NaN];
  return [line.hidden, new DOMMatrix(getComputedStyle(line).transform).m41,
          (player.time - from) / (to - from) * over.clientWidth];
});
"""


def test_the_time_line_keeps_its_place_when_a_plot_is_zoomed(driver: Any, page: Path) -> None:
    """A new range holds from the next drawing on; the line moves then, not before."""
    opened(driver, page)
    key(driver, "t")
    plot = driver.find_element("css selector", ".u-over")
    drag(driver, plot, (0.6, 0.5), (0.9, 0.5))
    until(lambda: all(hidden for hidden, _, _ in driver.execute_script(LINES)), 3.0)
    begin, end = driver.execute_script("return window.springback.plots.range")
    middle = 0.5 * (begin + end)
    driver.execute_script("window.springback.player.seek(arguments[0])", middle)
    drag(driver, plot, (0.3, 0.5), (0.9, 0.5))

    def in_place() -> bool:
        lines = driver.execute_script(LINES)
        return all(not hidden and abs(at - due) < 1.5 for hidden, at, due in lines)

    until(in_place, 3.0)
    assert complaints(driver) == []


def test_a_zoom_by_hand_can_be_ended(driver: Any, page: Path) -> None:
    """A double click shows all; the buttons say which range is shown, and none where it is another."""
    from selenium.webdriver.common.action_chains import ActionChains

    def lit() -> list[str]:
        found = driver.find_elements(
            "css selector", "[aria-label='Plots show'] [aria-pressed=true]"
        )
        return [button.get_attribute("data-value") for button in found]

    opened(driver, page)
    assert lit() == ["impact"]
    plot = driver.find_element("css selector", ".u-over")
    drag(driver, plot, (0.2, 0.5), (0.7, 0.5))
    assert lit() == []
    ActionChains(driver).double_click(plot).perform()
    until(lambda: driver.execute_script("return window.springback.plots.range") is None, 3.0)
    assert lit() == ["all"]


def test_a_view_turned_by_hand_is_no_longer_called_by_its_name(driver: Any, page: Path) -> None:
    """Its button is the way back, so it must not look pressed; who follows still follows."""

    def lit() -> list[str]:
        found = driver.find_elements("css selector", "[aria-label=Camera] [aria-pressed=true]")
        return [button.get_attribute("data-value") for button in found]

    opened(driver, page, "#camera=impact")
    assert lit() == ["impact"]
    canvas = driver.find_element("css selector", ".stage canvas")
    drag(driver, canvas, (0.4, 0.5), (0.6, 0.55))
    assert lit() == []
    driver.find_element("css selector", "button[data-value=impact]").click()
    assert lit() == ["impact"]
    driver.find_element("css selector", "button[data-value=follow]").click()
    drag(driver, canvas, (0.4, 0.5), (0.6, 0.55))
    assert lit() == ["follow"]
    assert complaints(driver) == []


@pytest.fixture(scope="module")
def between(tmp_path_factory: pytest.TempPathFactory) -> tuple[Flight, Path]:
    """ARQ hits a wall several times; both walls have names, and the ground has none."""
    walls = [
        {"type": "wall", "name": "east wall", "distance": 2.75, "surface": "wall"},
        {"type": "wall", "name": "west <b>wall", "position": [1.6, 0, 0], "normal": [1, 0, 0],
         "surface": "wall"},
        {"type": "ground", "surface": "wall"},
    ]  # fmt: skip
    flight = fly(TABLES | {"world": {"obstacles": walls}, "simulation": {"duration": 1.2}})
    path = tmp_path_factory.mktemp("between") / "one.html"
    export_page(replay_of([flight]), path)
    return flight, path


def test_the_view_of_the_impact_goes_to_the_next_one(
    driver: Any, between: tuple[Flight, Path]
) -> None:
    """It stays where an impact began until the next begins, and shows the robot then."""
    flight, page = between
    (first, _), (second, _), *_ = impacts_of(flight)

    def target(t: float) -> Any:
        opened(driver, page, f"#t={t}&camera=impact")
        return np.array(pose(driver)["target"])

    def place(t: float) -> Any:
        return np.array([np.interp(t, flight.t, flight.columns[axis]) for axis in "xyz"])

    assert np.linalg.norm(place(second) - place(first)) > 0.05  # else nothing is told
    assert target(0.0) == pytest.approx(place(first), abs=2e-3)
    assert target(second - 1e-3) == pytest.approx(place(first), abs=2e-3)
    assert target(second + 1e-3) == pytest.approx(place(second), abs=2e-3)
    driver.execute_script("window.springback.player.seek(arguments[0])", first + 0.01)
    assert pose(driver)["target"] == pytest.approx(place(first), abs=2e-3)
    assert complaints(driver) == []


def test_the_legend_calls_obstacles_by_their_names(
    driver: Any, between: tuple[Flight, Path]
) -> None:
    opened(driver, between[1])
    keys = driver.find_elements("css selector", ".scene-legend .obstacle")
    assert [one.text for one in keys] == ["east wall", "west <b>wall", "ground"]
    colours = [one.get_attribute("style") for one in keys]
    assert colours[0] == colours[1] != colours[2]


def test_sum_and_parts_of_contact_forces_go_by_different_names(driver: Any, page: Path) -> None:
    """Arrows are of single cages with friction; the number beside them is their sum as vectors."""
    opened(driver, page, "#camera=impact")
    driver.execute_script("document.querySelector('.event.peak').click()")
    assert (
        "contact force, each at its point"
        in driver.find_element("css selector", ".scene-legend").text
    )
    rows = driver.find_elements("css selector", ".readouts tbody tr")
    [cells] = [
        row.text for row in rows if row.text.startswith("contact force, sum of all contacts")
    ]
    forces = [c["force"] for c in pose(driver)["flights"][0]["contacts"] if c]
    assert len(forces) == 2
    whole, parts = np.linalg.norm(np.sum(forces, axis=0)), np.linalg.norm(forces, axis=1)
    assert whole < 0.95 * parts.sum()  # friction of one cancels that of the other
    assert f"{whole:.0f}" in cells


def test_flat_curves_have_ticks_that_differ_and_what_is_rigid_has_no_unit(
    driver: Any, flights: list[Flight], tmp_path: Path
) -> None:
    """A constant thrust had the ticks 3.443 and 3.443, a rigid robot a compression of rigid mm."""
    path = tmp_path / "quad.html"
    export_page(replay_of(flights[1:]), path)
    opened(driver, path, "#plots=Thrust")
    [plot] = driver.execute_script("return window.springback.plots.shown()")
    assert len(set(plot["ticks"])) == len(plot["ticks"]) >= 2
    assert plot["limits"][0] < 0.95 * float(plot["values"]["rotor 1, 2, 3, 4"])
    rows = driver.find_elements("css selector", ".readouts tbody tr")
    assert [row.text for row in rows if row.text.startswith("compression")] == [
        "compression, largest rigid"
    ]
    touched = driver.find_element("css selector", ".touched p").text
    assert touched.startswith("world.obstacles[0], a wall: by cage")


BODIES = [
    {"type": "window", "position": [2.75, 0.0, 1.0], "size": [1.2, 1.0], "opening": [0.7, 0.4]},
    {"type": "pole", "position": [2.7, 0.4, 0.0], "radius": 0.05},
    {"type": "pole", "position": [2.7, -0.4, 0.0], "radius": 0.05},
    {"type": "slope", "position": [3.0, 0.0, 0.0], "angle": "40 deg"},
    {"type": "ground"},
]


def test_built_in_bodies_are_seen_and_an_opening_is_open(driver: Any, tmp_path: Path) -> None:
    """Seen from in front: wall beside the opening, not in it; two poles; names in the legend."""
    world = {"obstacles": [{**one, "surface": "wall"} for one in BODIES]}
    flown = fly(TABLES | {"world": world, "simulation": {"duration": 0.15}})
    assert flown.contacts == 0
    path = tmp_path / "bodies.html"
    export_page(replay_of([flown]), path)
    resized(driver, 1440, 900)
    opened(driver, path, "#t=0&camera=front")
    legend = driver.find_element("css selector", ".scene-legend").text.split("\n")
    assert {"window", "pole", "slope", "ground"} <= set(legend)
    differences = """
        const S = window.springback.scene, canvas = document.createElement("canvas");
        const shot = () => {
          const from = S.canvas();
          [canvas.width, canvas.height] = [from.width, from.height];
          const pen = canvas.getContext("2d", { willReadFrequently: true });
          pen.drawImage(from, 0, 0);
          return pen.getImageData(0, 0, from.width, from.height);
        };
        const flights = S.flights;
        const without = (names) => {
          S.replace(flights.map((f) => ({ ...f, obstacles: f.obstacles.filter((o) => !names.includes(o.name)) })));
          return shot();
        };
        const whole = without([]);
        return arguments[0].map((names) => {
          const less = without(names);
          const columns = new Set();
          let middle = 0;
          for (let y = 0; y < whole.height; y++) for (let x = 0; x < whole.width; x++) {
            const at = 4 * (y * whole.width + x);
            if (Math.abs(whole.data[at] - less.data[at]) < 8) continue;
            columns.add(Math.floor((10 * x) / whole.width));
            const [u, v] = [x / whole.width - 0.5, y / whole.height - 0.5];
            if (Math.abs(u) < 0.04 && v < -0.06 && v > -0.12) middle += 1;
          }
          return { columns: [...columns].sort(), middle };
        });"""
    window, pole = driver.execute_script(differences, [["window"], ["pole"]])
    assert window["middle"] == 0  # above the robot the opening shows what is behind
    assert len(window["columns"]) > 3
    assert min(pole["columns"]) < 4.5 < max(pole["columns"])  # one on either side
    assert not {4, 5} & set(pole["columns"])
    assert complaints(driver) == []


def test_what_is_above_the_ground_casts_a_shadow_and_kinds_are_told_apart(
    driver: Any, tmp_path: Path
) -> None:
    """Straight below, as wide as it is; that of a ball on a rod goes with it."""
    ball = {
        "type": "sphere", "position": [3.6, 1.0, 1.0], "radius": 0.3, "surface": "wall",
        "motion": {"type": "pendulum", "mass": 1.0, "pivot": [3.6, 0.5, 2.5]},
    }  # fmt: skip
    box = {"type": "box", "position": [2.9, -0.6, 1.2], "size": [0.4, 0.8, 0.2], "surface": "wall"}
    ground = {"type": "ground", "surface": "wall", "height": 0.1}
    flight = fly(TABLES | {"world": {"obstacles": [ball, box, ground]}})
    path = tmp_path / "yard.html"
    export_page(replay_of([flight]), path)
    opened(driver, path)
    for t in (0.0, 0.3):
        driver.execute_script("window.springback.player.seek(arguments[0])", t)
        of_box, of_ball = driver.execute_script("return window.springback.scene.shadows()")
        assert of_box == pytest.approx([2.7, -1.0, 0.102, 3.1, -0.2, 0.102], abs=1e-3)
        x, y = (float(np.interp(t, flight.t, flight.columns[f"obstacle0_{a}"])) for a in "xy")
        around = [x - 0.3, y - 0.3, 0.102, x + 0.3, y + 0.3, 0.102]
        assert of_ball == pytest.approx(around, abs=6e-3)  # of a sphere of triangles
    assert abs(y - 1.0) > 0.05
    shades = dict(
        driver.execute_script(
            "return [...document.querySelectorAll('.scene-legend .obstacle')]"
            ".map((one) => [one.textContent, one.style.getPropertyValue('--colour')])"
        )
    )
    assert set(shades) == {"ground", "box", "sphere, moving"}
    assert len(set(shades.values())) == 3
    assert complaints(driver) == []


def test_bodies_of_two_flights_stand_apart_or_are_one(driver: Any, tmp_path: Path) -> None:
    """Side by side as far apart as they are wide, one over the other once; wide ones always so."""
    apart = """
        const S = window.springback.scene;
        S.canvas();
        return S.memory().geometries;"""
    counts, legends, marked, usable = {}, {}, {}, {}
    for name, one in (
        ("hoop", {"radius": 0.7, "tube_radius": 0.03, "position": [2.7, 0, 1]}),
        ("doorway", {"position": [2.7, 0, 0]}),
    ):
        world = {"obstacles": [{"type": name, "surface": "wall", **one}]}
        flights = [fly(TABLES | {"world": world, "vehicle": robot}) for robot in ("arq", "quad")]
        path = tmp_path / f"{name}.html"
        export_page(replay_of(flights), path)
        for mode in ("side", "ghost"):
            opened(driver, path, f"#compare={mode}&t=0")
            counts[name, mode] = driver.execute_script(apart)
            legends[name, mode] = driver.find_element("css selector", ".scene-legend").text
            [button] = driver.find_elements("css selector", f"{COMPARE}[aria-pressed=true]")
            marked[name, mode] = button.get_attribute("data-value")
            side = driver.find_element("css selector", f"{COMPARE}[data-value=side]")
            usable[name, mode] = side.is_enabled()
    assert counts["hoop", "side"] > counts["hoop", "ghost"]
    assert counts["doorway", "side"] == counts["doorway", "ghost"]
    assert {case for case, text in legends.items() if "overlaid" in text} == {("doorway", "side")}
    assert all((one == "ghost") == (case != ("hoop", "side")) for case, one in marked.items())
    assert all(one == (case[0] == "hoop") for case, one in usable.items())
    assert complaints(driver) == []


def test_forces_of_both_flights_are_labelled_where_one_lies_over_the_other(
    driver: Any, flights: list[Flight], page: Path
) -> None:
    """Each in the colour of its flight: those of the second had no number."""
    touch = flights[0].measures["touch_time"]
    assert touch is not None
    opened(driver, page, f"#compare=ghost&camera=impact&t={touch + 0.004}")
    assert all(any(one["contacts"]) for one in pose(driver)["flights"])
    until(lambda: len(driver.find_elements("css selector", FORCES)) >= 2)
    labels = driver.find_elements("css selector", FORCES)
    assert len({one.value_of_css_property("color") for one in labels}) == 2
    assert complaints(driver) == []


def test_two_vehicles_of_one_world_meet_in_one_place(driver: Any, tmp_path: Path) -> None:
    """Not side by side: at the touch they are as far apart as they flew, with forces on both."""
    flight = fly(two())
    export_page(replay_of([flight]), tmp_path / "pair.html")
    opened(driver, tmp_path / "pair.html")
    words = driver.find_element("css selector", ".views").text
    assert "overlaid" not in words
    touch = flight.measures["touch_time"]
    assert touch is not None
    driver.execute_script("window.springback.player.seek(arguments[0])", touch + 0.01)
    apart = np.linalg.norm(np.subtract(*pose(driver)["places"]))
    assert flight.second is not None
    flown = [
        [np.interp(touch + 0.01, one.t, one.columns[axis]) for axis in "xyz"]
        for one in (flight, flight.second)
    ]
    assert apart == pytest.approx(np.linalg.norm(np.subtract(*flown)), abs=1e-3)
    there = pose(driver)["flights"]
    for one in nonempty(there):
        assert any(contact and contact["size"] > 1.0 for contact in one["contacts"])
    assert complaints(driver) == []
