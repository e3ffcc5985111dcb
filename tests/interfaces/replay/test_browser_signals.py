"""The replay of several flights in a browser: signals, values, zoom, link, pictures, keys."""

from __future__ import annotations

import base64
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys

from builders.cases import nonempty
from interfaces.browsing import browser, complaints, needs_browser, requests, resized
from interfaces.replay.pages import TABLES, drag, key, opened, pose, until
from springback.interfaces.replay.viewer import export_page, replay_of
from springback.results.flight import Flight, fly

pytestmark = needs_browser
EXAMPLES = Path(__file__).parents[3] / "examples"
NAMES = ["recovery", "stiff", "slow", "soft", "slower"]


@pytest.fixture(scope="module")
def flights() -> list[Flight]:
    recovery = fly(
        EXAMPLES / "collision.toml",
        "name=recovery",
        "reference.speed=2 m/s",
        "simulation.duration=6 s",
    )
    changes = (
        "vehicle.arms.stiffness=20 N/mm", "start.velocity=[1.5, 0, 0]",
        "vehicle.arms.stiffness=1 N/mm", "start.velocity=[1, 0, 0]",
    )  # fmt: skip
    own = zip(NAMES[1:], changes, strict=True)
    return [recovery, *(fly(TABLES, f"name={name}", change) for name, change in own)]


@pytest.fixture(scope="module")
def page(flights: list[Flight], tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("pages") / "five.html"
    export_page(replay_of(flights, NAMES), path)
    return path


@pytest.fixture(scope="module")
def driver(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    with browser(tmp_path_factory.mktemp("profile"), 1000, 720) as found:
        yield found


@pytest.fixture
def clean(driver: Any, page: Path) -> Iterator[Any]:
    """The page as it is at first; no choice of plots is left behind."""
    opened(driver, page)
    yield driver
    driver.execute_script("localStorage.clear()")


@pytest.fixture
def loaded(driver: Any, page: Path) -> Any:
    """The page in whatever state: loading takes longer than most tests."""
    if not driver.execute_script("return !!window.springback"):
        opened(driver, page)
    return driver


def shown(driver: Any) -> dict[str, dict[str, Any]]:
    """Plots by name."""
    found = driver.execute_script("return window.springback.plots.shown()")
    return {plot["name"]: plot for plot in found}


def value_of(key: Any) -> Any:
    """Number in the legend of a plot."""
    return key.find_element("css selector", "b")


def picture_of(blob: str) -> str:
    """JavaScript that stores the next file handed to the user as base64 in `window.saved`."""
    return f"""
    window.saved = null;
    const original = URL.createObjectURL;
    HTMLAnchorElement.prototype.click = function () {{ window.name_of = this.download; }};
    URL.createObjectURL = (blob) => {{
      const reader = new FileReader();
      reader.onload = () => (window.saved = reader.result);
      reader.readAsDataURL(blob);
      return original.call(URL, blob);
    }};
    {blob}
    """


def test_any_signal_can_be_plotted_and_is_remembered(
    clean: Any, page: Path, flights: list[Flight]
) -> None:
    """Found by search, one plot for each unit, values of the telemetry; kept in link and storage."""
    driver = clean
    driver.find_element("css selector", ".adding").click()
    for words, names in (("est m", ["est_x", "est_vx"]), ("phase", ["phase"])):
        search = driver.find_element("css selector", ".chooser input[type=search]")
        search.clear()
        search.send_keys(words)
        visible = [
            box.get_attribute("value")
            for box in driver.find_elements("css selector", ".chooser input[type=checkbox]")
            if box.is_displayed()
        ]
        assert set(names) <= set(visible)
        assert "imu_ax" not in visible
        for name in names:
            driver.find_element("css selector", f".chooser input[value={name}]").click()
    assert "3 signals in 3 plots" in driver.find_element("css selector", ".chooser .count").text
    driver.find_element("css selector", ".chooser .main").click()
    telemetry = flights[0].telemetry
    k = int(np.flatnonzero(np.diff(telemetry["phase"]))[0])  # held until the next tick
    driver.execute_script("window.springback.player.seek(arguments[0])", telemetry["t"][k] + 9e-4)

    def seems_right() -> None:
        plots = shown(driver)
        for name in ("est_x", "est_vx"):
            [value] = plots[name]["values"].values()
            assert float(value) == pytest.approx(telemetry[name][k], abs=6e-3), name
        assert list(plots["phase"]["values"].values()) == ["cruise"]
        assert (plots["est_x"]["unit"], plots["est_vx"]["unit"]) == ("m", "m/s")

    seems_right()
    link = driver.execute_script("return window.springback.link.address()")
    assert "est_x;est_vx;phase" in link
    opened(driver, page)  # the link is gone, the choice is stored
    assert "est_vx" in shown(driver)
    driver.execute_script("localStorage.clear()")
    opened(driver, page, link[link.index("#") :])
    seems_right()
    driver.find_element("css selector", "[aria-label^='Remove this plot: est_x']").click()
    assert "est_x" not in shown(driver)
    driver.find_element("css selector", "[aria-label^='Change the signals: est_vx']").click()
    driver.find_element("css selector", ".chooser input[value=ref_vx]").click()
    driver.find_element("css selector", ".chooser .main").click()
    assert len(shown(driver)["est_vx, ref_vx"]["values"]) == 2
    assert complaints(driver) == []
    assert [url for url in requests(driver) if not url.startswith(("file:", "data:"))] == []


def test_a_scale_has_two_numbers_at_least(clean: Any) -> None:
    """One alone says nothing of the size of a curve; uPlot's rounding left 0 alone at -4.5 to 4.5."""
    driver = clean
    driver.execute_script("window.springback.plots.choose([['x']])")
    for top in nonempty([0.9, 1.3, 2.2, 3.1, 4.5, 4.9]):
        heights = f"heights: {{x: [{-top}, {top}]}}"
        driver.execute_script(f"window.springback.plots.restore({{range: [0, 0.1], {heights}}})")
        wait = (
            "return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
        )
        driver.execute_script(wait)
        [plot] = shown(driver).values()
        assert plot["limits"] == [-top, top]
        assert len(plot["ticks"]) >= 2, (top, plot["ticks"])


def test_values_under_the_cursor_and_zooms_that_can_be_undone(
    clean: Any, flights: list[Flight]
) -> None:
    driver = clean
    driver.execute_script("window.springback.plots.choose([['x']])")
    plot = driver.find_element("css selector", ".u-over")
    width = plot.size["width"]
    ActionChains(driver, duration=0).move_to_element_with_offset(plot, 0.2 * width, 5).perform()
    flag = driver.find_element("css selector", ".plot-flag")
    t = float(flag.text.removesuffix(" s"))
    begin, end = driver.execute_script("return window.springback.plots.range")
    assert t == pytest.approx(begin + 0.7 * (end - begin), abs=0.01 * (end - begin))
    shifts = driver.execute_script("return window.springback.scene.all.map((one) => one.shift)")
    values = shown(driver)["x"]["values"]
    assert len(values) == len(flights)
    for name, flight, shift in nonempty(zip(NAMES, flights, shifts, strict=True)):
        own = np.clip(t - shift, 0.0, flight.columns["t"][-1])
        wanted = np.interp(own, flight.columns["t"], flight.columns["x"])
        assert float(values[name]) == pytest.approx(wanted, abs=5e-4)
    # A drag along the values leaves the times; one along both changes both; each can be undone.
    states = [driver.execute_script("return window.springback.plots.zoomed")]
    for start, stop in (((0.5, 0.2), (0.5, 0.6)), ((0.2, 0.2), (0.6, 0.8))):
        drag(driver, plot, start, stop)
        states.append(driver.execute_script("return window.springback.plots.zoomed"))
    assert states[1]["range"] == states[0]["range"]
    low, high = states[1]["heights"]["x"]
    assert high > low
    until(lambda: shown(driver)["x"]["limits"] == states[2]["heights"]["x"], 3.0)
    inner = states[2]["range"]
    assert begin < inner[0] < inner[1] < end
    key(driver, Keys.ESCAPE)
    assert driver.execute_script("return window.springback.plots.zoomed") == states[1]
    driver.find_element("css selector", ".undo").click()
    assert driver.execute_script("return window.springback.plots.zoomed") == states[0]
    assert not driver.find_element("css selector", ".undo").is_enabled()
    assert complaints(driver) == []


def test_five_flights_have_names_and_can_be_hidden(clean: Any, flights: list[Flight]) -> None:
    """Side by side in order, all touching at one time; a hidden one leaves scene, plots, numbers."""
    driver = clean
    buttons = driver.find_elements("css selector", ".outcome .flight")
    assert [button.text.split("(")[-1].rstrip(")") for button in buttons] == NAMES
    colours = {button.value_of_css_property("border-left-color") for button in buttons}
    assert len(colours) == len(flights)
    assert driver.find_element("css selector", "h1").text == driver.title.split(" – ")[0]
    assert driver.title == "5 flights – springback"
    key(driver, "t")
    now = pose(driver)
    for flight, one in nonempty(zip(flights, now["flights"], strict=True)):
        assert one["own"] == pytest.approx(flight.touch_time, abs=5e-3)
    legend = driver.find_element("css selector", ".scene-legend")
    assert "contact force" in legend.text
    forces, path = driver.find_elements("css selector", "[aria-label=Show] button")[:2]
    forces.click()
    path.click()
    assert "contact force" not in legend.text
    assert "layers=forces%2Cpath" in driver.execute_script(
        "return window.springback.link.address()"
    ).replace(",", "%2C")
    forces.click()
    assert "contact force" in legend.text
    resized(driver, 390, 844)
    names = driver.find_elements("css selector", ".scene-legend .robot")
    assert [name.text for name in names if name.is_displayed()] == NAMES
    driver.find_element("css selector", ".tool-full").click()
    until(lambda: driver.find_element("css selector", ".left").size["height"] == 844)
    stage, player = (
        driver.find_element("css selector", one).size["height"] for one in (".stage", ".player")
    )
    assert stage + player == pytest.approx(844, abs=2)  # no empty stripe
    leave = "[aria-label='Leave full screen']"
    until(lambda: bool(driver.find_elements("css selector", leave)))
    driver.find_element("css selector", leave).click()
    until(lambda: driver.execute_script("return !document.fullscreenElement"))
    resized(driver, 1000, 720)
    driver.execute_script("window.springback.plots.choose([['l1']])")
    keys = driver.find_elements("css selector", ".plot-key")
    assert [key.text.split()[0] for key in keys] == NAMES
    assert len({value_of(key).value_of_css_property("color") for key in keys}) == len(flights)
    length = shown(driver)["l1"]
    assert length["unit"] == "mm"
    for name, flight in nonempty(zip(NAMES, flights, strict=True)):
        wanted = 1e3 * np.interp(flight.touch_time, flight.columns["t"], flight.columns["l1"])
        assert float(length["values"][name]) == pytest.approx(wanted, abs=0.06)
        assert len(length["values"][name].partition(".")[2]) == 1
    driver.execute_script("window.springback.plots.choose(null)")
    buttons[1].click()
    assert [b.get_attribute("aria-pressed") for b in buttons] == [
        "true", "false", "true", "true", "true",
    ]  # fmt: skip
    assert len(pose(driver)["flights"]) == 4
    assert len(shown(driver)["Acceleration"]["values"]) == 4
    heads = driver.find_elements("css selector", ".numbers thead th[scope=col]")
    assert [head.text for head in heads] == [name for name in NAMES if name != "stiff"]
    for k in (0, 2, 3, 4):
        buttons[k].click()
    assert len(pose(driver)["flights"]) == 1  # the last one stays
    assert complaints(driver) == []


@pytest.mark.parametrize(("width", "height"), [(1440, 900), (390, 844)])
def test_five_flights_with_added_signals_fit_on_the_screen(
    clean: Any, flights: list[Flight], width: int, height: int
) -> None:
    driver = clean
    resized(driver, width, height)
    try:
        choice = [["l1"], ["est_vx", "ref_vx", "vx"], ["fn1"], ["imu_ax"], ["phase"]]
        driver.execute_script("window.springback.plots.choose(arguments[0])", choice)
        key(driver, "t")
        assert driver.execute_script("return document.documentElement.scrollWidth") <= width
        plots = driver.find_elements("css selector", ".plots .uplot")
        assert len(plots) == len(choice)
        for plot in plots:
            box = plot.rect
            assert 0 <= box["x"] <= box["x"] + box["width"] <= width
        keys = [one for one in driver.find_elements("css selector", ".plot-key") if one.text]
        assert len(keys) == 5 + 7 + 5 + 1 + 1
        for one in keys:
            driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", one)
            assert 0 <= one.rect["x"] <= one.rect["x"] + one.rect["width"] <= width
        heads = driver.find_elements("css selector", ".numbers thead th[scope=col]")
        assert [head.text for head in heads] == NAMES  # no word is broken
        lines = "return arguments[0].clientHeight"
        assert max(driver.execute_script(lines, head) for head in heads) < 30
        values = shown(driver)["fn1"]["values"]
        assert set(values) == set(NAMES)
        assert complaints(driver) == []
    finally:
        resized(driver, 1000, 720)


def test_keys_choose_the_view_and_the_link_brings_it_back(clean: Any, page: Path) -> None:
    driver = clean
    for name, mode in zip(
        "1234560", ("front", "side", "top", "follow", "free", "impact", "follow"), strict=True
    ):
        key(driver, name)
        assert pose(driver)["camera"] == mode
    driver.execute_script("window.springback.player.seek(1.234)")
    key(driver, "3")
    driver.find_element("css selector", "[data-value=ghost]").click()
    driver.find_elements("css selector", ".outcome .flight")[1].click()
    key(driver, "e")
    link = driver.execute_script("return window.springback.link.address()")
    fragment = link[link.index("#") :]
    assert "t=1.234" in fragment
    opened(driver, page, fragment)
    now = pose(driver)
    assert (now["t"], now["camera"]) == (pytest.approx(1.234), "top")
    assert (len(now["flights"]), len(now["estimates"])) == (4, 4)
    assert driver.execute_script("return window.springback.link.address()") == link
    odd = "plots=nothing;__proto__&layers=constructor&hide=y&zoom=0,Infinity&speed=x"
    driver.execute_script(f"location.hash = '#t=0.5&camera=impact&{odd}'")
    until(lambda: pose(driver)["t"] == 0.5, 3.0)
    assert pose(driver)["camera"] == "impact"
    assert driver.execute_script("return window.springback.plots.range[1]") < 10.0
    assert complaints(driver) == []


def test_the_estimated_pose_is_that_of_the_telemetry(clean: Any, flights: list[Flight]) -> None:
    driver, telemetry = clean, flights[0].telemetry
    assert pose(driver)["estimates"] == []
    key(driver, "e")
    k = int(np.searchsorted(telemetry["t"], flights[0].touch_time)) + 5
    driver.execute_script("window.springback.player.seek(arguments[0])", telemetry["t"][k] + 1e-4)
    [estimate, *others] = pose(driver)["estimates"]
    assert others == [None] * 4  # without a pilot there is none
    wanted = [telemetry[f"est_{axis}"][k] for axis in "xyz"]
    assert estimate["position"] == pytest.approx(wanted, abs=2e-4)
    q = [telemetry[f"est_q{part}"][k] for part in "wxyz"]
    assert abs(np.dot(estimate["quaternion"], q)) == pytest.approx(1.0, abs=1e-6)
    assert "estimated pose" in driver.find_element("css selector", ".scene-legend").text


def test_picture_and_film(loaded: Any) -> None:
    """A PNG of the view; a WebM; without a recorder the command that makes films is named."""
    driver = loaded
    key(driver, "t")
    driver.execute_script(picture_of("document.querySelector('.tool-picture').click()"))
    until(lambda: driver.execute_script("return window.saved !== null"))
    kind, data = driver.execute_script("return window.saved").split(",")
    assert kind == "data:image/png;base64"
    picture = base64.b64decode(data)
    assert picture[:4] == b"\x89PNG"
    width, height = (int.from_bytes(picture[k : k + 4], "big") for k in (16, 20))
    stage = driver.find_element("css selector", ".stage").size
    assert (width, height) == (
        pytest.approx(stage["width"], abs=2),
        pytest.approx(stage["height"], abs=2),
    )
    assert len(picture) > 20_000  # an empty one has a few kB
    assert driver.execute_script("return window.name_of").endswith(".png")
    driver.execute_script(picture_of("document.querySelector('.tool-film').click()"))
    before = pose(driver)["t"]
    until(lambda: pose(driver)["t"] > before + 1e-3)
    driver.find_element("css selector", ".tool-film").click()
    until(lambda: driver.execute_script("return window.saved !== null"))
    kind, data = driver.execute_script("return window.saved").split(";", 1)
    assert kind == "data:video/webm"
    assert base64.b64decode(data.split(",")[-1])[:4] == b"\x1aE\xdf\xa3"
    assert not pose(driver)["playing"]
    driver.execute_script(
        "window.MediaRecorder = undefined; document.querySelector('.tool-film').click()"
    )
    assert "springback animate" in driver.find_element("css selector", ".remark").text
    assert complaints(driver) == []


def test_a_slow_picture_has_fewer_pixels_until_it_rests(loaded: Any) -> None:
    """Frames of 150 ms, as of graphics in software: coarser in motion, sharp when still."""
    driver = loaded
    driver.execute_script("""
    const { player } = window.springback;
    let left = 8;
    window.frames_left = () => left;
    const frame = () => {
      player.seek(player.time + 1e-3);
      for (const end = performance.now() + 150; performance.now() < end; );
      if (--left) requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
    """)
    until(lambda: driver.execute_script("return window.frames_left()") == 0)
    coarse = pose(driver)["pixels"]
    assert coarse < 1.0
    stage = driver.find_element("css selector", ".stage").size["width"]
    sharp = "return document.querySelector('.stage canvas').width"
    until(lambda: driver.execute_script(sharp) == pytest.approx(stage, abs=2))


def test_every_button_has_a_name_and_dialogs_close_with_escape(loaded: Any) -> None:
    driver = loaded
    nameless = driver.execute_script(
        "return [...document.querySelectorAll('button, input, select')].filter((one) =>"
        " !(one.textContent.trim() || one.getAttribute('aria-label') || one.labels?.length)).map((one) => one.outerHTML)"
    )
    assert nameless == []
    driver.execute_script("window.springback.plots.zoom(0, 1)")
    for opener, box in ((".adding", ".chooser"), (".tool-help", ".keys")):
        driver.find_element("css selector", opener).click()
        dialog = driver.find_element("css selector", f"dialog{box}")
        assert dialog.is_displayed()
        ActionChains(driver).send_keys(Keys.ESCAPE).perform()
        assert not dialog.is_displayed()
    assert driver.execute_script("return window.springback.plots.range") == [0, 1]
    resized(driver, 390, 844)
    driver.find_element("css selector", ".adding").click()
    assert driver.execute_script("return document.documentElement.scrollWidth") <= 390
    assert driver.find_element("css selector", ".chooser").size["width"] <= 390
    resized(driver, 1000, 720)
    assert complaints(driver) == []
