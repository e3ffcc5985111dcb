"""The impact lab in a browser: a slider moves and everything follows, links and files carry it on.

It needs Chromium and its driver, and is skipped where one is missing.
"""

# what is optional is asked for before what needs it

import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("uvicorn", reason="the lab needs the extra web")

from interfaces.browsing import browser as a_browser
from interfaces.browsing import needs_browser, resized
from interfaces.lab.lab_served import served_lab
from springback.interfaces.lab.responses import answer
from springback.interfaces.lab.settings import settings_from
from springback.interfaces.lab.user_scenario import read_user_scenario
from springback.interfaces.lab.user_settings import user_settings

pytestmark = needs_browser
ID, CSS = "id", "css selector"
CONTROL, ENTER = "\ue009", "\ue007"  # of the WebDriver standard
PATIENCE = 60.0


@pytest.fixture(scope="module")
def lab() -> Iterator[str]:
    with served_lab() as port:
        yield f"http://127.0.0.1:{port}/"


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    with a_browser(tmp_path_factory.mktemp("browser"), 1000, 700) as driver:
        yield driver


def until(claim: Callable[[], Any], what: str) -> Any:
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        found = claim()
        if found:
            return found
        time.sleep(0.05)
    raise AssertionError(f"in vain waited for: {what}")


def opened(browser: Any, url: str) -> None:
    browser.get(url)
    until(lambda: browser.execute_script("return !!window.springback?.answer"), "the first answer")


def shown(browser: Any) -> dict[str, Any]:
    """Everything that a reader sees of the flight, in plain data."""
    return dict(
        browser.execute_script("""
        const S = window.springback;
        return {
          query: S.answer.query, settings: S.answer.settings,
          fields: Object.fromEntries([...document.querySelectorAll(".slider-control input[type=text]")].map((f) => [f.id, f.value])),
          outcomes: document.querySelector(".outcomes").innerText,
          table: document.querySelector(".measures").innerText,
          peaks: S.plots.curve("Acceleration"), energy: S.plots.curve("Energy, ARQ"),
          link: document.querySelector("#link").value,
        };""")
    )


def slide(browser: Any, name: str, share: int) -> None:
    browser.execute_script(
        "const s = document.querySelector(arguments[0]); s.value = arguments[1];"
        "for (const kind of ['input', 'change']) s.dispatchEvent(new Event(kind, {bubbles: true}));",
        f"#set-{name}-slider", share,
    )  # fmt: skip


def errors(browser: Any) -> list[str]:
    logged = [
        entry["message"] for entry in browser.get_log("browser") if entry["level"] == "SEVERE"
    ]
    return [text for text in logged if "422" not in text]


def test_a_slider_moves_curve_and_outcome_and_the_link_brings_them_back(
    browser: Any, lab: str
) -> None:
    opened(browser, lab)
    before = shown(browser)
    assert before["link"] == lab
    assert "ARQ hits the wall at 1.85 m/s" in before["outcomes"]

    slide(browser, "stiffness", 200)
    until(
        lambda: browser.execute_script("return window.springback.answer.query") != "",
        "a new answer",
    )
    after = shown(browser)
    assert after["query"].startswith("stiffness=")
    assert after["settings"]["stiffness"] < 5.0
    assert after["outcomes"] != before["outcomes"]
    assert after["table"] != before["table"]
    arq, quad = (next(c for c in after["peaks"] if c["name"] == name) for name in ("ARQ", "Quad"))
    assert arq["peak"] < before["peaks"][0]["peak"]  # a softer spring
    assert quad["peak"] == before["peaks"][1]["peak"]  # the rigid twin has none
    python = answer(settings_from([tuple(after["query"].split("="))]))  # type: ignore[list-item]
    peak = next(row for row in python["measures"] if row["name"] == "impact_peak_acceleration")[
        "values"
    ]["arq"]
    assert arq["peak"] == pytest.approx(
        peak, rel=1e-4
    )  # it lies between two of the curve's samples

    link = browser.find_element(ID, "link").get_attribute("value")
    assert link == f"{lab}?{after['query']}" == browser.current_url
    first = browser.current_window_handle
    browser.switch_to.new_window("tab")
    try:
        resized(browser, 1000, 700)
        opened(browser, link)
        assert shown(browser) == after
    finally:
        browser.close()
        browser.switch_to.window(first)

    browser.back()
    until(
        lambda: browser.execute_script("return window.springback.answer.query") == "",
        "the way back",
    )
    assert shown(browser) == before
    browser.forward()
    until(
        lambda: browser.execute_script("return window.springback.answer.query") != "",
        "the way forth",
    )
    assert shown(browser) == after
    assert errors(browser) == []


def test_the_robots_move_when_it_plays(browser: Any, lab: str) -> None:
    opened(browser, lab)
    before = browser.execute_script("return window.springback.pose()")
    browser.find_element(CSS, ".player .play").click()
    moved = until(
        lambda: (
            (now := browser.execute_script("return window.springback.pose()"))["t"]
            > before["t"] + 1e-3
            and now
        ),
        "playing",
    )
    assert moved["flights"][0]["position"] != before["flights"][0]["position"]
    assert moved["flights"][0]["armLengths"] != before["flights"][0]["armLengths"]
    browser.execute_script("window.springback.player.pause()")


def test_nonsense_in_a_field_is_told_and_the_flight_stays(browser: Any, lab: str) -> None:
    opened(browser, lab)
    before = shown(browser)
    for text, words in (
        ("99", "must be at most 6 m/s (got 99 m/s); 0.5 to 6 m/s"),
        ("NaN", "must be finite"),
        ("../x", "is not a number (got '../x'); expected m/s"),
    ):
        field = browser.find_element(ID, "set-speed")
        field.send_keys(CONTROL, "a")
        field.send_keys(text, ENTER)
        alert = browser.find_element(CSS, ".alert")
        until(lambda alert=alert, words=words: words in alert.text, words)
        assert field.get_attribute("aria-invalid") == "true"
        assert browser.current_url == lab
        assert shown(browser)["outcomes"] == before["outcomes"]
    field.send_keys(CONTROL, "a")
    field.send_keys("2", ENTER)
    until(lambda: not alert.is_displayed(), "the message to go")
    until(
        lambda: browser.execute_script("return window.springback.answer.settings.speed") == 2,
        "2 m/s",
    )
    assert field.get_attribute("aria-invalid") == "false"


def test_a_wrong_link_is_told_and_the_lab_opens_all_the_same(browser: Any, lab: str) -> None:
    opened(browser, f"{lab}?stiffness=1e9")
    assert "stiffness: must be at most 50 N/mm" in browser.find_element(CSS, ".alert").text
    assert shown(browser)["query"] == ""


def test_numbers_from_other_units_fit_into_their_field(browser: Any, lab: str) -> None:
    """10 km/h and -0.5 rad are shown whole, not cut off at the edge."""
    opened(browser, f"{lab}?speed=10+km/h&pitch=-0.5+rad")
    for name, shows in (("speed", "2.77778"), ("pitch", "-28.6479")):
        field = browser.find_element(ID, f"set-{name}")
        assert field.get_attribute("value") == shows
        inside = "const f = arguments[0]; return f.clientWidth - f.scrollWidth"
        assert browser.execute_script(inside, field) >= 0, name


def test_a_pinned_flight_stays_beside_the_next(browser: Any, lab: str) -> None:
    opened(browser, lab)
    kept = next(c["peak"] for c in shown(browser)["peaks"] if c["name"] == "ARQ")
    browser.find_element(ID, "pin").click()
    slide(browser, "damping", 900)
    until(
        lambda: "damping" in browser.execute_script("return window.springback.answer.query"),
        "a new answer",
    )
    peaks = {curve["name"]: curve["peak"] for curve in shown(browser)["peaks"]}
    assert peaks["ARQ, pinned"] == kept != peaks["ARQ"]
    assert "pinned" in shown(browser)["table"]


def test_scenes_that_are_replaced_leave_nothing_behind(browser: Any, lab: str) -> None:
    held = "return window.springback.scene.memory().geometries"
    answers = "return window.springback.latency.length"
    opened(browser, lab)
    memory = [until(lambda: browser.execute_script(held), "the picture")]
    for share in (300, 450, 600):
        before = browser.execute_script(answers)
        slide(browser, "stiffness", share)
        until(lambda before=before: browser.execute_script(answers) > before, "a new answer")
        browser.execute_async_script(
            "requestAnimationFrame(() => requestAnimationFrame(arguments[0]))"
        )
        memory.append(until(lambda: browser.execute_script(held), "the picture"))
    assert max(memory) <= 1.5 * min(memory) + 20


@pytest.mark.parametrize("width", [390, 1440])
def test_nothing_sticks_out_of_the_page(browser: Any, lab: str, width: int) -> None:
    resized(browser, width, 844)
    try:
        opened(browser, f"{lab}?surface=own")
        assert browser.execute_script("return document.documentElement.scrollWidth") <= width
        drawer = browser.find_element(ID, "drawer")
        assert drawer.is_displayed() == (width < 500)
        if width < 500:
            drawer.click()
            until(lambda: browser.find_element(ID, "set-speed").is_displayed(), "the drawer")
    finally:
        resized(browser, 1000, 700)


def test_another_obstacle_is_chosen_hit_and_drawn(browser: Any, lab: str) -> None:
    """Its controls come, the slider's goes; the link brings it back, at the same numbers."""
    opened(browser, lab)
    assert not browser.find_element(ID, "set-radius").is_displayed()
    browser.find_element(CSS, "#set-obstacle option[value=pole]").click()
    until(lambda: "ARQ hits the pole" in shown(browser)["outcomes"], "a pole")
    assert browser.find_element(ID, "set-radius").is_displayed()
    assert browser.find_element(ID, "set-offset").is_displayed()
    assert not browser.find_element(CSS, "[data-name=guide]").is_displayed()
    assert not browser.find_element(ID, "set-opening").is_displayed()
    assert "pole" in browser.find_element(CSS, ".scene-legend").text.split("\n")
    slide(browser, "offset", 560)
    until(lambda: shown(browser)["query"] == "obstacle=pole&offset=60", "an offset")
    moved = shown(browser)
    opened(browser, moved["link"])
    assert shown(browser) == moved
    apart = """
        const places = window.springback.answer.flights.map((one) => one.scene.obstacles.map((o) => o.name));
        return places.flat();"""
    assert browser.execute_script(apart) == ["pole", "pole"]
    assert [text for text in errors(browser) if "503" not in text] == []


#: The lab's server as one that compiles for doors without end, and answers all else after 0.4 s.
BUSY = """
const fetched = window.fetch;
window.fetch = async (query, ...more) => {
  if (query.includes("obstacle=door")) {
    const preparing = { what: "impacts on a door, free", about: 30, waited: 3 };
    return { ok: false, status: 503, json: async () => ({ errors: [], preparing }) };
  }
  const found = await fetched(query, ...more);
  await new Promise((done) => setTimeout(done, 400));
  return found;
};"""
#: Settings of a page's address, as where one goes back to it.
BACK = "history.pushState(null, '', arguments[0]); dispatchEvent(new PopStateEvent('popstate'));"


def test_what_was_chosen_stays_chosen_while_it_compiles(browser: Any, lab: str) -> None:
    """An answer to an earlier setting comes in between, and is drawn, and changes no choice."""
    chosen = "return document.querySelector('#set-obstacle').value"
    opened(browser, lab)
    browser.execute_script(BUSY)
    slide(browser, "speed", 500)
    browser.find_element(CSS, "#set-obstacle option[value=door]").click()
    until(lambda: "speed=" in shown(browser)["query"], "the speed, flown into the wall")
    until(lambda: browser.find_element(CSS, ".preparing").is_displayed(), "a word on compiling")
    assert browser.execute_script(chosen) == "door"
    assert "Compiling for impacts on a door" in browser.find_element(CSS, ".preparing").text
    time.sleep(1.5)  # it is asked for again, and nothing else is
    assert browser.execute_script(chosen) == "door"
    assert browser.find_element(ID, "set-door_mass").is_displayed()
    browser.find_element(CSS, "#set-obstacle option[value=wall]").click()
    until(lambda: not browser.find_element(CSS, ".preparing").is_displayed(), "the wall")
    browser.execute_script(BACK, "?obstacle=door&door_mass=12")
    assert browser.execute_script(chosen) == "door"  # before anything is answered
    assert browser.find_element(ID, "set-door_mass").get_attribute("value") == "12"
    assert [text for text in errors(browser) if "503" not in text] == []


def test_the_energy_of_a_door_is_stacked_below_what_was_put_in(browser: Any, lab: str) -> None:
    opened(browser, f"{lab}?obstacle=door&robot=arq&door_mass=2")
    energy = shown(browser)["energy"]
    names = [one["name"] for one in energy]
    assert {"moving obstacles", "lost in obstacles"} < set(names)
    assert names[-1] == "put in"
    stack, line = energy[-2], energy[-1]
    assert stack["peak"] == pytest.approx(line["peak"], rel=2e-3)


def test_a_file_can_be_taken_away(browser: Any, lab: str) -> None:
    opened(browser, f"{lab}?stiffness=2.6")
    links = [a.get_attribute("href") for a in browser.find_elements(CSS, ".files a")]
    assert links == [f"{lab}scenario.toml?stiffness=2.6&of={robot}" for robot in ("arq", "quad")]
    assert Path(links[0].split("?")[0]).name == "scenario.toml"


MINE = """
vehicle = {preset = "quad", name = "Mine", arms = {length = "0.24 m"}}
thrust = "hover"
start = {position = ["2.3 m", 0, "1 m"], velocity = ["2 m/s", 0, 0]}
simulation = {duration = "0.2 s"}
[[world.obstacles]]
type = "wall"
distance = "2.75 m"
surface = "wall"
"""


def test_a_scenario_of_ones_own_is_changed_swept_and_refused(browser: Any, tmp_path: Path) -> None:
    """One page: the user's vehicle, the present point on its curve, a reason beside its control."""
    path = tmp_path / "mine.toml"
    path.write_text(MINE, encoding="utf-8")
    state = "return window.springback.sweep.state()"
    with served_lab(user_settings(read_user_scenario(path))) as port:
        opened(browser, f"http://127.0.0.1:{port}/#sweep=cage_radius,impact_peak_acceleration")
        assert shown(browser)["outcomes"].startswith("Mine hits the wall at 2.00 m/s")
        assert "mine.toml" in browser.find_element(CSS, "h1").text
        until(lambda: browser.execute_script(state)["curve"], "the sweep")
        before = browser.execute_script(state)
        [point] = before["points"]
        assert (point["x"], point["label"]) == (110, "Mine")
        curve = before["curve"]["measures"]["impact_peak_acceleration"]["mine"]
        near = min(range(len(curve)), key=lambda k: abs(before["curve"]["at"][k] - 110))
        assert point["y"] == pytest.approx(curve[near], rel=0.05)
        dot = browser.find_element(CSS, ".sweep-point").rect
        box = browser.find_element(CSS, ".sweep .u-over").rect
        assert dot["x"] + 5 - box["x"] == pytest.approx(box["width"] * (110 - 20) / 230, abs=2)

        slide(browser, "cage_radius", 300)
        until(lambda: "cage" in shown(browser)["query"], "a smaller cage")
        after = browser.execute_script(state)
        assert after["points"][0]["x"] == 89
        assert after["curve"] == before["curve"]  # it depends on all other settings only
        assert after["bounds"] == before["bounds"]
        assert shown(browser)["link"].endswith(
            "?cage_radius=89#sweep=cage_radius,impact_peak_acceleration"
        )

        browser.find_element(ID, "lock").click()
        scale = "return window.springback.plots.bounds('Acceleration')"
        locked = browser.execute_script(scale)
        slide(browser, "speed", 1000)
        until(lambda: "speed" in shown(browser)["query"], "a faster flight")
        assert max(one["peak"] for one in shown(browser)["peaks"]) > locked[1]
        assert browser.execute_script(scale) == locked

        browser.find_element(ID, "lock").click()
        grown = until(lambda: (now := browser.execute_script(scale)) != locked and now, "a scale")
        move = "const s = document.querySelector('#set-speed-slider'); s.value = 0; s.dispatchEvent(new Event(arguments[0], {bubbles: true}))"
        browser.execute_script(move, "input")
        until(
            lambda: "speed=0.5" in browser.execute_script("return window.springback.answer.query"),
            "a slow flight",
        )
        assert browser.execute_script(scale) == grown  # while the slider is held
        browser.execute_script(move, "change")
        until(lambda: browser.execute_script(scale)[1] < grown[1], "the scale of a slow flight")

        browser.find_element(ID, "set-beside").click()
        browser.find_element(CSS, "#set-beside option[value=twin]").click()
        names = "return [...document.querySelectorAll(arguments[0])].map((one) => one.textContent)"
        both = ["Mine", "Mine, rigid"]
        for place in (".scene-legend .robot", ".measures thead th:not(:empty)", ".outcome b"):
            until(lambda place=place: browser.execute_script(names, place) == both, place)
        for width in (390, 1440):
            resized(browser, width, 844)
            browser.find_element(CSS, ".tool-full").click()
            leave = "[aria-label='Leave full screen']"
            until(lambda leave=leave: browser.find_elements(CSS, leave), "full screen")
            tall = "return document.querySelector('.middle').clientHeight"
            until(lambda tall=tall: browser.execute_script(tall) == 844, "all of the screen")
            assert browser.find_element(CSS, ".player").is_displayed()
            browser.find_element(CSS, leave).click()
            until(lambda leave=leave: not browser.find_elements(CSS, leave), "the way back")
        resized(browser, 1000, 700)

        slide(browser, "cage_radius", 1000)
        control = browser.find_element(CSS, "[data-name=cage_radius]")
        until(lambda: "cages overlap" in control.text, "the reason")
        assert "The previous flight is shown" in browser.find_element(CSS, ".alert").text
        assert shown(browser)["settings"]["cage_radius"] == 89
        assert (
            "no arm of your vehicle is compliant"
            in browser.find_element(CSS, "[data-name=stiffness]").text
        )
        assert [text for text in errors(browser) if "503" not in text] == []


HEXAROTOR = """
name = "hexarotor"
thrust = "hover"
[vehicle]
name = "Hexarotor of 600 g"
[vehicle.body]
mass = "0.42 kg"
inertia = [2e-3, 2e-3, 3.5e-3]
[vehicle.arms]
directions = ["0 deg", "60 deg", "120 deg", "180 deg", "-120 deg", "-60 deg"]
length = "0.18 m"
mass = "30 g"
cage_radius = "0.07 m"
stiffness = "3 N/mm"
damping = "30 N s/m"
stroke = "25 mm"
spin = [1, -1, 1, -1, 1, -1]
[start]
position = ["2.3 m", 0, "1 m"]
velocity = ["2 m/s", 0, 0]
[simulation]
duration = "0.2 s"
[[world.obstacles]]
type = "wall"
distance = "2.75 m"
surface = "wall"
"""


def test_a_hexarotor_of_ones_own_is_flown_and_swept_on_both_screens(
    browser: Any, tmp_path: Path
) -> None:
    path = tmp_path / "hexarotor.toml"
    path.write_text(HEXAROTOR, encoding="utf-8")
    state = "return window.springback.sweep.state()"
    with served_lab(user_settings(read_user_scenario(path))) as port:
        try:
            for width, height in ((1440, 900), (390, 844)):
                resized(browser, width, height)
                of = "sweep=stiffness,impact_peak_acceleration"
                browser.get("about:blank")
                opened(browser, f"http://127.0.0.1:{port}/#{of}")
                assert shown(browser)["outcomes"].startswith("Hexarotor of 600 g hits the wall")
                assert shown(browser)["settings"]["arm_count"] == 6
                fits = "return document.documentElement.scrollWidth"
                assert browser.execute_script(fits) <= width
                until(lambda: browser.execute_script(state)["curve"], "the sweep")
                [before] = browser.execute_script(state)["points"]
                if width < 600:
                    browser.find_element(ID, "drawer").click()
                control = until(
                    lambda: browser.find_element(ID, "set-stiffness").is_displayed(), "a control"
                )
                assert control
                pane = browser.find_element(CSS, ".settings").rect
                buttons = browser.find_elements(CSS, ".settings .choice button")
                boxes = [button.rect for button in buttons if button.is_displayed()]
                assert len(boxes) >= 6
                for box in boxes:  # names may be long
                    assert box["width"] >= 30
                    assert box["x"] + box["width"] <= pane["x"] + pane["width"] - 12
                slide(browser, "stiffness", 800)
                until(lambda: "stiffness=" in shown(browser)["query"], "a stiffer one")
                [after] = browser.execute_script(state)["points"]
                assert after["x"] > before["x"]
                assert browser.execute_script(fits) <= width
                assert errors(browser) == []
        finally:
            resized(browser, 1000, 700)
