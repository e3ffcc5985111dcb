"""Table IV: metrics against closed forms, what is promised of our numbers, and their marks."""

from __future__ import annotations

import math
import re
import runpy
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from springback.control.parameters import ControlSettings
from springback.errors import InputError
from springback.paper.free_flight import (
    CIRCLE_TIME,
    DROP_TILTS,
    PERIODS,
    QUANTITIES,
    ROBOTS,
    TABLE_IV_CIRCLES,
    TABLE_IV_STEPS,
    FlightResults,
    flight_experiments,
    fly_steps,
)
from springback.paper.responses import (
    circle_errors,
    mean_square_error,
    rise_time,
    step_response,
)
from springback.studies.comparison import Mark
from springback.vehicle.library import VEHICLES

TIME = np.linspace(0.0, 5.0, 5001)


@pytest.fixture(scope="module")
def results() -> FlightResults:
    return flight_experiments(trials=2)


def recorded(t: np.ndarray, **columns: np.ndarray) -> Any:
    """What the metrics read of a flight."""
    return SimpleNamespace(t=t, columns=columns)


# -- metrics ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("tau", [0.1, 0.3, 0.6])
def test_first_order_response(tau: float) -> None:
    """1 − e^(−t/τ): rise τ ln 9, ∫(1 − p)² = τ/2 (1 − e^(−2T/τ)).

    Of the slowest, 0.04 % are still missing when its steady state is taken: 0.2 % of its rise.
    """
    response = 1.0 - np.exp(-TIME / tau)
    assert rise_time(TIME, response) == pytest.approx(tau * math.log(9.0), rel=2e-3)
    error = tau / 2.0 * (1.0 - math.exp(-10.0 / tau)) / 5.0
    assert mean_square_error(TIME, response) == pytest.approx(error, rel=1e-4)


@pytest.mark.parametrize("zeta", [0.5, 0.7, 0.9])
def test_second_order_response(zeta: float) -> None:
    """∫(1 − p)² = (1 + 4ζ²)/(4 ζ ω_n); the rise of ζ = 0.5, 0.7, 0.9 from tables of ω_n t_r."""
    w = 6.0
    d = w * math.sqrt(1.0 - zeta**2)
    decay = np.exp(-zeta * w * TIME)
    response = 1.0 - decay * (np.cos(d * TIME) + zeta * w / d * np.sin(d * TIME))
    assert mean_square_error(TIME, response) == pytest.approx(
        (1.0 + 4.0 * zeta**2) / (4.0 * zeta * w) / 5.0, rel=1e-4
    )
    assert w * rise_time(TIME, response) == pytest.approx(
        {0.5: 1.638, 0.7: 2.126, 0.9: 2.883}[zeta], rel=3e-3
    )


def test_rise_is_of_what_is_attained_but_error_of_what_is_wanted() -> None:
    whole = 1.0 - np.exp(-TIME / 0.3)
    assert rise_time(TIME, 0.8 * whole) == pytest.approx(rise_time(TIME, whole), rel=1e-12)
    steady = mean_square_error(TIME, np.full_like(TIME, 0.8))
    assert steady == pytest.approx(0.04, rel=1e-12)


def test_uneven_instants_change_nothing() -> None:
    uneven = 5.0 * np.linspace(0.0, 1.0, 3001) ** 2
    for measure in (rise_time, mean_square_error):
        even = measure(TIME, 1.0 - np.exp(-TIME / 0.3))
        assert measure(uneven, 1.0 - np.exp(-uneven / 0.3)) == pytest.approx(even, rel=2e-4)


def test_what_does_not_rise_is_said() -> None:
    with pytest.raises(InputError, match="does not rise"):
        rise_time(TIME, np.ones_like(TIME))


def test_a_step_is_cut_out_of_a_flight() -> None:
    t = np.linspace(0.0, 20.0, 20_001)
    flight = recorded(t, x=np.where(t < 10.0, 3.0, 3.0 + (t - 10.0)))
    since, way = step_response(flight, "x", 10.0, 5.0, 3.0)
    assert (since[0], since[-1]) == (0.0, 5.0)
    np.testing.assert_allclose(way, since, atol=1e-9)


@pytest.mark.parametrize("period", [math.pi, 2.0 * math.pi])
def test_circle_errors_of_a_lag_in_phase(period: float) -> None:
    """A lag φ leaves 2 (1 − cos φ) of the square of the amplitude, half of it on each axis."""
    lag, radius, rate = 0.2, 1.5, 2.0 * math.pi / period
    t = np.linspace(0.0, CIRCLE_TIME, 40_001)
    angle = rate * t - lag
    flight = recorded(
        t, x=radius * np.cos(angle), y=radius * np.sin(angle),
        vx=-radius * rate * np.sin(angle), vy=radius * rate * np.cos(angle),
    )  # fmt: skip
    errors = circle_errors(flight, period, radius, 0.0, CIRCLE_TIME)
    share = (1.0 - math.cos(lag)) * radius**2
    expected = {"px": share, "py": share, "vx": share * rate**2, "vy": share * rate**2}
    assert errors == pytest.approx(expected, rel=1e-5)
    late = circle_errors(flight, period, radius, period, CIRCLE_TIME, late=lag / rate)
    assert max(late.values()) < 1e-12


# -- the experiment ---------------------------------------------------------------------------------


def test_every_cell_has_a_row_and_a_mark(results: FlightResults) -> None:
    rows = results.rows()
    assert len(rows) == 3 * 3 * 2 + 3 * 2 * 4
    told = {(row.robot, row.reading, row.quantity): row for row in rows}
    assert len(told) == len(rows)
    for row in rows:
        fitted = row.robot == "quad" and row.reading == "steps"
        assert (row.mark is Mark.FITTED) == fitted
        if not fitted:
            assert row.deviation is not None
            assert (row.mark is Mark.PREDICTED) == (abs(row.deviation) <= 0.05)
    assert told["arq", "steps", "rise time of p_y"].printed == 0.782
    assert told["arq after drops", "fast circle", "mean square error of v_x"].printed == 95.4e-3
    assert "2 trials" in rows[0].note


@pytest.mark.parametrize("axis", ["x", "y", "z"])
def test_quad_answers_as_printed(results: FlightResults, axis: Any) -> None:
    """Fitted: two numbers for six; x and y, alike for us, differ by up to 4 % in print."""
    rise, error = TABLE_IV_STEPS["quad"][axis]
    assert np.mean(results.rise("quad", axis)) == pytest.approx(rise, rel=0.03)
    assert np.mean(results.step_mse("quad", axis)) == pytest.approx(error, rel=0.06)


@pytest.mark.parametrize("robot", ["arq", "arq after drops"])
def test_arq_follows_within_a_tenth(results: FlightResults, robot: Any) -> None:
    """Predicted: every rise time and every error of steps."""
    for axis, (rise, error) in nonempty(TABLE_IV_STEPS[robot].items()):  # type: ignore[index]
        assert np.mean(results.rise(robot, axis)) == pytest.approx(rise, rel=0.10)
        assert np.mean(results.step_mse(robot, axis)) == pytest.approx(error, rel=0.10)


def test_arq_is_slower_than_quad_and_drops_change_nothing(results: FlightResults) -> None:
    """As the paper says of both; drops leave arms where they were, so only noise differs."""
    for axis in ("x", "y", "z"):
        quad, arq = results.rise("quad", axis), results.rise("arq", axis)  # type: ignore[arg-type]
        assert min(arq) > 1.05 * max(quad)
        after = results.rise("arq after drops", axis)  # type: ignore[arg-type]
        assert np.mean(after) == pytest.approx(np.mean(arq), rel=0.01)
    assert len(results.drops) == len(DROP_TILTS)
    assert max(drop.stroke for drop in results.drops) > 1e-3
    # On their hull robots still rock at the end of a fall of 3 s, touching, their arms not locked yet:
    # 1.7e-5 m then; without a hull they had come to rest, and 1e-6 m was left.
    assert results.drops[-1].left < 5e-5


def test_the_start_makes_most_of_the_errors_along_y(results: FlightResults) -> None:
    """The reference sets out along Y at full speed: 'discontinuity of desired velocities'."""
    for robot in nonempty(ROBOTS):
        whole = np.mean(results.circle_mse(robot, "slow", "vy"))
        later = np.mean(results.circle_mse(robot, "slow", "vy", first_round=False))
        assert whole > 50.0 * later
        assert whole == pytest.approx(TABLE_IV_CIRCLES[robot, "slow"][3], rel=0.12)
        for name in QUANTITIES:  # once round, both axes err alike; velocities by ω more
            rest = np.mean(results.circle_mse(robot, "fast", name, first_round=False))
            ratio = (4.0 if name[0] == "v" else 1.0) * np.mean(
                results.circle_mse(robot, "fast", "px", first_round=False)
            )
            assert rest == pytest.approx(ratio, rel=0.03)


def test_circles_are_within_a_factor_of_what_is_printed(results: FlightResults) -> None:
    """Fast ones within 2.5; slow positions are tracked better here than in print, up to 6 times."""
    for (robot, pace), printed in nonempty(TABLE_IV_CIRCLES.items()):
        for name, wanted in nonempty(zip(QUANTITIES, printed, strict=True)):
            ratio = np.mean(results.circle_mse(robot, pace, name)) / wanted
            assert ratio < 1.6
            assert ratio > (0.4 if pace == "fast" else 0.1)


def test_one_flight_is_kept_for_each_figure(results: FlightResults) -> None:
    for robot in ROBOTS:
        kept = results.response(robot).flight
        assert kept is not None
        assert kept.columns["z"][-1] == pytest.approx(2.0, abs=0.02)
        for pace in PERIODS:
            assert results.circle(robot, pace).flight is not None
    assert sum(trial.flight is not None for trial in results.responses) == len(ROBOTS)


def test_trials_are_their_seeds(results: FlightResults) -> None:
    """The same seed gives the same bits; no two trials share one, or their numbers."""
    first = results.response("quad")
    again = fly_steps("quad", {"preset": "quad"}, first.seed)
    assert (again.rise, again.mse) == (first.rise, first.mse)
    assert len({trial.seed for trial in results.responses}) == len(results.responses)
    assert len({trial.rise["x"] for trial in results.responses}) == len(results.responses)


# -- the rule ---------------------------------------------------------------------------------------


def test_damping_keeps_its_ratio_on_any_mass() -> None:
    """ζ = K_v/(2 √(K_p m)); a given damping is a force and stays."""
    settings = ControlSettings(damping_ratio=0.7)
    for mass in (0.5, 1.2, 3.0):
        horizontal, vertical = settings.damping_for(mass)
        for k_v, k_p in ((horizontal, settings.stiffness), (vertical, settings.vertical_stiffness)):
            assert k_v / (2.0 * math.sqrt(k_p * mass)) == pytest.approx(0.7, rel=1e-12)
        assert settings.position_law(mass, 9.81).damping == (horizontal, horizontal, vertical)
    own = ControlSettings(damping="5 N s/m")
    assert (own.damping_for(1.0)[0], own.damping_for(2.0)[0]) == (5.0, 5.0)
    assert own.damping_for(1.0)[1] == ControlSettings().damping_for(1.0)[1]


def test_rate_gain_is_that_of_the_autopilot() -> None:
    """0.15 of the full moment of four rotors in X, by Quad's inertia, between roll's and pitch's."""
    quad = VEHICLES["quad"].vehicle
    assert quad.propulsion is not None
    half = math.sqrt(0.5)
    moment = 0.15 * 4.0 * quad.propulsion.max_thrust * half * quad.lengths()[0] * half
    roll, pitch = moment / quad.inertia()[0, 0], moment / quad.inertia()[1, 1]
    assert pitch < ControlSettings().rate_gain < roll
    assert ControlSettings().rate_gain == pytest.approx((roll + pitch) / 2.0, rel=0.02)


def test_the_table_of_the_reproduction_page_is_the_computed_one(results: FlightResults) -> None:
    """Written by tools/readme.py from five trials; two trials differ in the last digits only."""
    root = Path(__file__).parents[2]
    tool = runpy.run_path(str(root / "tools/readme.py"))
    text = (root / "docs/paper/reproduction.md").read_text(encoding="utf-8")
    number = re.compile(r"[-\d.]+(?:e-3)?")
    wanted = tool["flight_table"](results)
    within = text.split("<!-- flight: written by tools/readme.py -->\n")[1]
    within = within.split("<!-- end of flight -->")[0]
    assert number.sub("", within) == number.sub("", wanted)
    ours, shown = (
        [float(x) for x in re.findall(r"\| (\d[\d.]*) \(", part)] for part in (wanted, within)
    )
    assert len(shown) == 42
    assert shown == pytest.approx(ours, rel=0.03, abs=0.02)
