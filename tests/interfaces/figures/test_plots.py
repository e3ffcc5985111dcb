"""Figures of made-up flights: units on every axis, nothing that a flight may lack brings them down.

Nothing here is flown: trajectories are formulas, measures are typed in.
"""

import hashlib
import math
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib.figure import Figure

import springback
from builders.cases import nonempty
from builders.figures import slider_figures
from builders.paper_results import LASTS, TOUCH, fake_slider_flight, fake_slider_results
from springback.errors import InputError
from springback.interfaces.figures import flight as plots
from springback.interfaces.figures import style
from springback.interfaces.figures.chart import add_share_bar, draw_shares
from springback.interfaces.reports.flight_files import write_flight
from springback.interfaces.reproduction.figures import slider
from springback.paper.printed import TABLE_III
from springback.paper.slider import (
    READINGS,
)
from springback.results.flight import fly
from springback.simulation.measuring.measures import MEASURES, Outcome


def panels(figure: Figure) -> dict[str, Any]:
    """Axes of a figure by their label."""
    return {ax.get_ylabel(): ax for ax in figure.axes}


def test_every_axis_has_its_unit() -> None:
    for name, figure in nonempty(slider_figures().items()):
        grid = figure.axes[0].get_gridspec()
        assert grid is not None
        for ax in figure.axes:
            place = ax.get_subplotspec()
            assert place is not None
            if place.is_last_row():
                assert ax.get_xlabel().endswith("]"), name
            words = [tick.get_text() for tick in ax.get_yticklabels()]
            categories = any(word[:1].isalpha() for word in words)
            if place.is_first_col() and not categories and name != "readings":
                label = ax.get_ylabel() or ax.get_title(loc="left")
                assert label.endswith("]"), name


def test_a_flight_is_shown_around_its_contact() -> None:
    figure = plots.flight_figure(fake_slider_flight(stroke=0.01))
    axes = panels(figure)
    assert list(axes) == [
        "Position [mm]", "Velocity [m/s]", "Acceleration [m/s²]", "Arm length [mm]", "Normal force [N]",
    ]  # fmt: skip
    assert figure.axes[-1].get_xlabel() == "Time from first touch [ms]"
    low, high = figure.axes[-1].get_xlim()
    assert -TOUCH * 1e3 <= low < 0.0 < LASTS * 1e3 < high < 0.17e3
    (shade,) = axes["Velocity [m/s]"].patches
    assert shade.get_x() == pytest.approx(0.0, abs=0.6)
    assert shade.get_width() == pytest.approx(1e3 * LASTS, abs=1.1)
    past = axes["Position [mm]"].lines[0]
    assert np.interp(0.0, past.get_xdata(), past.get_ydata()) == pytest.approx(0.0, abs=1e-9)


def test_hits_of_the_impulse_law_are_in_pictures_that_reach_to_what_the_title_tells(
    tmp_path: Path,
) -> None:
    """There is no force that tells of a contact: the figure ended 13 ms after the first hit."""
    wall = {"type": "wall", "distance": "1 m", "surface": {"law": "impulse", "restitution": 0.5}}
    flight = fly({
        "vehicle": "quad", "thrust": "hover", "world": {"obstacles": [wall]},
        "start": {"position": [0.74, 0, 1], "velocity": [2, 0, 0]},
        "simulation": {"duration": 0.05},
    }, executor="python")  # fmt: skip
    touch = flight.measures["touch_time"]
    assert touch is not None
    assert plots.impulse_hits(flight)[0] == pytest.approx(touch, abs=1e-9)
    assert not plots.needs_impact_figure(flight)
    late = touch + 0.03
    told = replace(
        flight, outcome=Outcome.ARM_BOTTOMED, measures=flight.measures | {"bottomed_time": late}
    )
    assert plots.needs_impact_figure(told)
    for figure, reaches in nonempty([
        (plots.flight_figure(told), True), (plots.impact_figure(told), False),
        (plots.flight_figure(flight), False),
    ]):  # fmt: skip
        low, high = figure.axes[-1].get_xlim()
        assert low < 0.0
        assert (high > 1e3 * (late - touch)) == reaches
        shown = panels(figure)["Velocity [m/s]"].lines[0]
        assert np.ptp(shown.get_ydata()) > 2.5  # from 2 m/s to −1 m/s
    write_flight(told, tmp_path)
    assert (tmp_path / "impact.png").exists()


def test_a_flight_is_titled_by_its_outcome_and_what_it_touched(tmp_path: Path) -> None:
    """In flight.png as in impact.png; a name with a dollar sign is drawn as it is written."""
    tables = {
        "vehicle": "xplorer", "name": "a $very$ long name of a scenario " * 2, "thrust": "hover",
        "world": {"obstacles": [
            {"type": "pole", "position": [2.0, 0.05, 0.0], "radius": 0.05, "surface": "wall"},
        ]},
        "start": {"position": [1.5, 0.0, 1.0], "velocity": [1.0, 0.0, 0.0]},
        "simulation": {"duration": 0.4},
    }  # fmt: skip
    flight = fly(tables)
    assert flight.obstacle_contacts
    for figure in nonempty([plots.flight_figure(flight), plots.impact_figure(flight)]):
        title = " ".join(figure.get_suptitle().split())
        assert title.startswith("a \\$very\\$ long name")
        assert title.endswith(f": {flight.message}")
        assert figure.axes[0].get_title(loc="left") == "touched: world.obstacles[0], a pole"
        shown = list(panels(figure))
        assert {"Hinge [deg]", "Hinge [N m]"} < set(shown)
        assert "2nd hinge [deg]" not in shown
        wide = figure.get_window_extent().width
        for words in (figure._suptitle, figure.axes[0]._left_title):  # type: ignore[attr-defined]
            assert words.get_window_extent().x1 <= wide
    limits = {"components": [{"name": "lens", "specific_force": "1 m/s^2"}]}
    fragile = {**tables, "vehicle": {"preset": "xplorer", "limits": limits}}
    fragile["simulation"] = {"duration": 0.005}
    broken = plots.flight_figure(fly(fragile, executor="python"))
    assert broken.axes[0].get_title(loc="left") == "broken: lens at 0 s: more than 1 m/s²"
    missed = plots.flight_figure(fake_slider_flight(hit=False))
    assert missed.axes[0].get_title(loc="left") == ""
    assert not [name for name in panels(missed) if "inge" in name]


def test_arms_that_do_the_same_share_a_curve() -> None:
    axes = panels(plots.flight_figure(fake_slider_flight(stroke=0.01)))
    names = [line.get_label() for line in axes["Arm length [mm]"].lines]
    assert names == ["arm 1, 2", "arm 3, 4"]
    assert [line.get_label() for line in axes["Normal force [N]"].lines] == ["arm 1, 2"]


def test_an_arm_that_hardly_gives_is_flat_and_its_ticks_are_lengths() -> None:
    """Of 0.2 µm there was a panel of "+1.899e2"; 50 µm are worth one, in whole numbers of mm."""
    for stroke, least in ((2e-7, 1.0), (5e-5, 0.05)):
        figure = plots.flight_figure(fake_slider_flight(stroke=stroke))
        ax = panels(figure)["Arm length [mm]"]
        low, high = ax.get_ylim()
        assert high - low >= least
        assert not ax.yaxis.get_offset_text().get_text()
        assert {len(label.get_text()) <= 7 for label in ax.get_yticklabels()} == {True}


def test_the_bar_of_shares_says_that_it_is_not_linear() -> None:
    figure = style.StyledFigure()
    ax = figure.subplots()
    mesh = draw_shares(ax, [0.0, 1.0, 2.0], [0.0, 1.0], [[0.2, 1.0]])
    bar = add_share_bar(figure, mesh, ax, "Success rate [-]")
    assert bar.get_ylabel() == "Success rate [-],\ncolours finer above 0.8"


def test_a_flight_without_contact_arms_or_motion_is_shown_too() -> None:
    free = plots.flight_figure(fake_slider_flight(hit=False))
    assert list(panels(free)) == ["Position [m]", "Velocity [m/s]", "Acceleration [m/s²]"]
    assert free.axes[-1].get_xlabel() == "Time [s]"
    assert not [patch for ax in free.axes for patch in ax.patches]
    rounding = fake_slider_flight(hit=False)
    rounding.columns["ax"] = 1e-14 * rounding.columns["t"]
    limits = panels(plots.flight_figure(rounding))["Acceleration [m/s²]"].get_ylim()
    assert limits == pytest.approx((-1.0, 1.0), abs=0.1)
    armless = plots.flight_figure(fake_slider_flight(arms=0, hit=False))
    assert len(armless.axes) == 3
    rigid = plots.flight_figure(fake_slider_flight(stroke=0.0))
    assert "Arm length [mm]" not in panels(rigid)


def test_a_single_instant_can_be_shown() -> None:
    flight = fake_slider_flight(hit=False)
    short = replace(flight, columns={name: values[:1] for name, values in flight.columns.items()})
    assert style.png(plots.flight_figure(short))


def test_a_flight_without_trajectory_says_so() -> None:
    with pytest.raises(ValueError, match="trajectory=True"):
        plots.flight_figure(replace(fake_slider_flight(), columns={}))


def test_slider_figures_mark_what_is_printed() -> None:
    for robot, rows in (("quad", 3), ("arq", 4)):
        figure = slider.slider_figure(fake_slider_results(), robot)
        assert len(figure.axes) == 2 * rows
        for column, surface in enumerate(("wall", "mat")):
            printed = TABLE_III[robot, surface]
            heights = [
                [
                    float(np.asarray(line.get_ydata())[0])
                    for line in ax.lines
                    if len(np.asarray(line.get_ydata()))
                ]
                for ax in figure.axes[column::2]
            ]
            assert 1e3 * printed.travel in heights[0]
            assert -1.85 * printed.restitution in heights[1]
            assert -printed.peak_acceleration in heights[2]


def test_readings_are_told_apart_by_more_than_colour() -> None:
    figure = slider.slider_figure(fake_slider_results(), "arq")
    lines = [line for line in figure.axes[0].lines if str(line.get_label()).startswith("reading")]
    assert len({(line.get_linestyle(), line._dash_pattern[1] and tuple(line._dash_pattern[1])) for line in lines}) == len(READINGS)  # type: ignore[attr-defined]  # fmt: skip
    assert len({line.get_color() for line in lines}) == len(READINGS)


def test_any_number_of_readings_with_any_names() -> None:
    names = ("<script>", "$\\frac$", "_hidden", "{brace}", "long " * 30, "%s", "G", "H")
    extra = tuple(replace(READINGS[1], name=name) for name in names)
    results = fake_slider_results((*READINGS, *extra))
    for figure in (
        slider.slider_figure(results, "arq"), slider.sweep_figure(results), slider.readings_figure(results),
    ):  # fmt: skip
        assert style.png(figure)
    legend = slider.readings_figure(results).legends[0]
    words = [text.get_text() for text in legend.get_texts()]
    assert "reading \\$\\frac\\$" in words  # drawn as it is
    assert "reading _hidden" in words
    assert all(len(word) <= 24 for word in words)


def test_energy_bars_begin_where_the_last_one_ended() -> None:
    (ax,) = plots.energy_figure(fake_slider_flight()).axes
    bars = {
        tick.get_text(): bar for tick, bar in zip(ax.get_yticklabels(), ax.patches, strict=True)
    }
    assert list(bars) == ["at the start", "contact damping", "left in motion"]
    ends = {
        name: sorted((bar.get_x(), bar.get_x() + bar.get_width())) for name, bar in bars.items()
    }
    assert ends["at the start"] == [0.0, 3.0]
    assert ends["contact damping"] == [1.0, 3.0]
    assert ends["left in motion"] == [0.0, 1.0]
    assert [text.get_text() for text in ax.texts] == [
        "3 J (100.0 %)", "−2 J (66.7 %)", "1 J (33.3 %)",
    ]  # fmt: skip


def test_energy_counts_a_fall_as_put_in_and_copes_with_nothing() -> None:
    fallen = fake_slider_flight()
    fallen.measures.update(
        {
            "energy_start": 0.0,
            "energy_gravity": -5.0,
            "loss_contact": 4.0,
            "work_thrust": -0.5,
            "energy_kinetic": 0.5,
        }
    )
    (ax,) = plots.energy_figure(fallen).axes
    names = [tick.get_text() for tick in ax.get_yticklabels()]
    assert names == ["loss of height", "absorbed by rotors", "contact damping", "left in motion"]
    fallen.measures.update(dict.fromkeys(MEASURES))
    assert style.png(plots.energy_figure(fallen))


def test_energy_bars_of_a_flight_among_moving_obstacles_balance() -> None:
    """What is put in, less what is lost, is what is left: with all that moves."""
    ball = {"type": "sphere", "position": [0.55, 0, 1.0], "radius": 0.1, "surface": "wall"}
    flight = fly({
        "vehicle": "arq", "thrust": "hover",
        "start": {"position": [0, 0, 1.0], "velocity": [2.0, 0, 0]},
        "world": {"obstacles": [
            {**ball, "motion": {"type": "pendulum", "mass": 0.5, "pivot": [0.55, 0, 2.0]}},
            {**ball, "position": [-0.6, 0, 1.0],
             "motion": {"type": "constant", "velocity": [3.0, 0, 0]}},
        ]},
        "simulation": {"duration": 0.3},
    })  # fmt: skip
    assert abs(flight.work_driven) > 0.1 < abs(flight.energy_obstacles)
    (ax,) = plots.energy_figure(flight).axes
    bars = zip(ax.get_yticklabels(), ax.patches, strict=True)
    steps = {tick.get_text(): bar.get_width() for tick, bar in bars}
    assert "work of driven obstacles" in steps
    left = sum(value for name, value in steps.items() if name.startswith("left"))
    most = max(map(abs, steps.values()))
    assert sum(steps.values()) - left == pytest.approx(left, abs=5e-3 * most)


def test_the_users_own_style_is_neither_used_nor_changed() -> None:
    plain = style.png(plots.energy_figure(fake_slider_flight()))
    with mpl.rc_context({"font.size": 30.0, "axes.grid": False, "text.usetex": True}):
        before = dict(mpl.rcParams)
        assert style.png(plots.energy_figure(fake_slider_flight())) == plain
        assert dict(mpl.rcParams) == before


def test_files_are_the_same_every_time_and_carry_no_date(tmp_path: Path) -> None:
    files = style.save(plots.energy_figure(fake_slider_flight()), tmp_path / "a" / "energy.v1")
    assert [file.name for file in files] == ["energy.v1.png", "energy.v1.pdf", "energy.v1.csv"]
    png, pdf, _ = files
    assert b"Date" not in pdf.read_bytes()
    assert b"tEXt" not in png.read_bytes()
    assert b"/FontFile2" in pdf.read_bytes()  # TrueType, embedded
    assert png.read_bytes()[16:20] == math.ceil(style.WIDTH * style.RESOLUTION).to_bytes(4)
    program = (
        "import sys, hashlib, pathlib\n"
        "from builders.paper_results import fake_slider_flight\n"
        "from springback.interfaces.figures import flight as plots, style\n"
        "files = style.save(plots.energy_figure(fake_slider_flight()), pathlib.Path(sys.argv[1]))\n"
        "assert 'matplotlib.pyplot' not in sys.modules\n"
        "print(*(hashlib.sha256(f.read_bytes()).hexdigest() for f in files))\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", program, str(tmp_path / "b")],
        capture_output=True, text=True, check=True, env={"PYTHONHASHSEED": "7", "PYTHONPATH": ":".join(sys.path)},
    )  # fmt: skip
    assert done.stdout.split() == [hashlib.sha256(f.read_bytes()).hexdigest() for f in files]


def test_a_flight_is_plotted_in_one_call() -> None:
    flight = fake_slider_flight()
    shown = style.png(springback.plot(flight))
    assert shown == style.png(plots.flight_figure(flight))


def test_what_cannot_be_plotted_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    flight = fake_slider_flight()
    with pytest.raises(InputError, match="trajectory=True"):
        springback.plot(replace(flight, columns={}))
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(InputError, match=r"this needs matplotlib.*plot"):
        springback.plot(flight)


def test_notebooks_show_figures() -> None:
    figure = plots.energy_figure(fake_slider_flight())
    assert figure._repr_png_().startswith(b"\x89PNG")  # type: ignore[attr-defined]


def test_readme_figure_has_the_size_of_its_place() -> None:
    data = style.png(slider.readme_figure(fake_slider_results()))
    assert (int.from_bytes(data[16:20]), int.from_bytes(data[20:24])) == (1600, 600)
    assert len(data) < 200_000


def test_names_are_drawn_as_they_are_written() -> None:
    """A dollar sign begins no formula, which this one would be no right one of."""
    name = r"a $\foo$ b"
    scenario = {"name": name, "vehicle": "quad", "simulation": {"duration": 0.01}}
    figure = plots.energy_figure(fly(scenario, executor="python"))
    figure.draw_without_rendering()
    (axes,) = figure.axes
    assert axes.get_title(loc="left").replace(r"\$", "$") == name
