"""Results of the paper's experiments by formula: nothing is flown, measures are typed in."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from springback.frames import attitude_from_euler
from springback.paper.free_flight import (
    CIRCLE_TIME,
    PERIODS,
    ROBOTS,
    STEP_BEGINS,
    STEP_FROM,
    TABLE_IV_CIRCLES,
    TABLE_IV_STEPS,
    CircleRun,
    Drop,
    FlightResults,
    Response,
    circle_tables,
    step_tables,
)
from springback.paper.free_flight import (
    QUANTITIES as FLIGHT_QUANTITIES,
)
from springback.paper.printed import SWEEP_SPEEDS, TABLE_III
from springback.paper.resilience import ResilienceResults
from springback.paper.slider import (
    QUAD,
    QUANTITIES,
    READINGS,
    Case,
    Interpretation,
    SliderResults,
    SweepPoint,
    slider_tables,
)
from springback.results.flight import Flight
from springback.results.recovery_measures import RECOVERY_MEASURES
from springback.scenario.scenario import scenario_from
from springback.simulation.measuring.measures import MEASURES, Outcome
from springback.studies.comparison import Mark, Row
from springback.studies.trials import Trial

#: First touch, and how long it lasts [s].
TOUCH, LASTS = 0.03, 0.04
#: Measures of every slider test that hits.
KNOWN = {
    "touch_time": TOUCH, "return_time": TOUCH + LASTS, "contact_time": LASTS, "time_to_return": LASTS,
    "touch_speed": 1.85, "impact_peak_acceleration": 100.0, "impact_peak_acceleration_time": TOUCH + LASTS / 2,
    "restitution_at_separation": 0.5, "restitution_at_return": 0.5, "restitution_of_mass_centre": 0.5,
    "travel": 0.02, "energy_start": 3.0, "loss_contact": 2.0, "energy_kinetic": 1.0, "steps": 500.0,
    "ledger_residual": -4e-8, "work_thrust": 0.0, "energy_gravity": 0.0,
}  # fmt: skip


def fake_slider_flight(
    reading: Interpretation = QUAD,
    surface: str = "wall",
    *,
    arms: int = 4,
    stroke: float = 0.0,
    hit: bool = True,
) -> Flight:
    """A body that meets a wall, or does not; the front arms, 1 and 2, do the same."""
    t = np.linspace(0.0, 0.2, 401)
    phase = np.clip((t - TOUCH) / LASTS, 0.0, 1.0)
    bump = np.where((phase > 0.0) & (phase < 1.0), np.sin(np.pi * phase), 0.0) * float(hit)
    zero = np.zeros_like(t)
    columns = {
        "t": t,
        "x": 0.7 + 1.85 * t,
        "y": zero,
        "z": zero + 1.0,
        "vx": 1.85 - 2.7 * phase * hit,
    }
    columns |= {"vy": zero, "vz": zero, "ax": -100.0 * bump, "ay": zero, "az": zero}
    columns |= {"qw": zero + 1.0} | dict.fromkeys(("qx", "qy", "qz", "wx", "wy", "wz"), zero)
    for j in range(1, arms + 1):
        front = float(j <= 2)
        columns |= {
            f"l{j}": 0.19 - stroke * front * bump,
            f"dl{j}": zero,
            f"fn{j}": 150.0 * front * bump,
            f"ff{j}": zero,
        }
    measures: dict[str, float | None] = dict.fromkeys(MEASURES)
    measures |= KNOWN if hit else {"energy_start": 3.0, "energy_kinetic": 3.0}
    scenario = scenario_from(slider_tables(reading, surface, 1.85, 0.4))
    outcome = Outcome.SEPARATED if hit else Outcome.NO_CONTACT
    return Flight(scenario, outcome, measures, columns, dict.fromkeys(columns, ""))


def fake_slider_results(readings: tuple[Interpretation, ...] = READINGS) -> SliderResults:
    """Results with the numbers 0.9, 1.0, 1.1 ... of what is printed, reading by reading."""
    results = SliderResults(readings=readings)
    results.rows.append(
        Row(
            "Table II",
            "",
            "",
            "",
            "arm stiffness",
            "N/m",
            5e3,
            5e3,
            None,
            Mark.GIVEN,
            0.0,
            "",
            "k_l",
        )
    )
    for (robot, surface), printed in TABLE_III.items():
        for k, reading in enumerate([QUAD] if robot == "quad" else readings):
            flight = fake_slider_flight(reading, surface, stroke=0.0 if robot == "quad" else 0.01)
            for source in ("Quad's restitution", "ARQ's own restitution")[: 1 + (robot == "arq")]:
                results.cases.append(Case(robot, surface, reading, 0.4, source, flight))
                for quantity, unit in QUANTITIES.items():
                    stem = "restitution" if quantity.startswith("restitution") else quantity
                    stem = stem.removeprefix("impact_").replace("time_to_return", "contact_time")
                    number = getattr(printed, stem)
                    ours = (1.0 if robot == "quad" else 0.9 + 0.1 * k) * number / 1.001
                    mark = Mark.PREDICTED if abs(ours / number - 1.0) < 0.05 else Mark.CONTRADICTED
                    results.rows.append(
                        Row("Table III", robot, surface, reading.name, quantity, unit, ours, number,
                            None, mark, 0.4 + k / 7.0, source)
                    )  # fmt: skip
    for k, reading in enumerate(readings):
        for speed in SWEEP_SPEEDS:
            results.sweep.append(
                SweepPoint(reading.name, speed, 200.0 * speed, (100.0 + k) * speed)
            )
        results.rows.append(
            Row("Sweep", "quad - arq", "wall", reading.name, "gap of peak accelerations at 6 m/s",
                "m/s^2", 600.0 - 6.0 * k, 493.0, None, Mark.CONTRADICTED, 0.4, "Quad's restitution")
        )  # fmt: skip
    return results


#: Time constant of the response to a step [s], and the pitch of every flight [rad].
LAG = {"quad": 0.30, "arq": 0.35, "arq after drops": 0.35}
PITCH = 0.4


def fake_guided_flight(tables: dict[str, Any], t: Any, wanted: Any, flown: Any) -> Flight:
    """A flight with a telemetry; the estimate is 3, 4 and 0 mm off, the pitch 0.4 rad."""
    columns, telemetry = {"t": t}, {"t": t}
    rates = {a: np.gradient(flown[a], t) for a in "xyz"}
    columns |= {a: flown[a] for a in "xyz"} | {f"v{a}": rates[a] for a in "xyz"}
    columns |= {f"w{a}": 0.0 * t for a in "xyz"} | {f"a{a}": 0.0 * t for a in "xyz"}
    attitude = dict(zip("wxyz", attitude_from_euler(0.0, PITCH, 0.0), strict=True))
    columns |= {f"q{part}": value + 0.0 * t for part, value in attitude.items()}
    for j in range(1, 5):
        columns |= {f"l{j}": 0.19 + 0.0 * t, f"fn{j}": 0.0 * t, f"ff{j}": 0.0 * t}
        telemetry |= {f"thrust{j}": 3.0 + 0.1 * j + 0.0 * t, f"command{j}": 3.0 + 0.0 * t}
    telemetry |= {f"ref_{a}": wanted[a] for a in "xyz"}
    telemetry |= {f"ref_v{a}": wanted.get(f"v{a}", 0.0 * t) for a in "xyz"}
    telemetry |= {f"aim_q{part}": value + 0.0 * t for part, value in attitude.items()}
    telemetry |= {
        f"est_{a}": flown[a] + off for a, off in zip("xyz", (3e-3, 4e-3, 0.0), strict=True)
    }
    measures: dict[str, float | None] = dict.fromkeys(MEASURES)
    units = dict.fromkeys(columns | telemetry, "") | {"est_x": "m"}
    scenario = scenario_from(tables)
    return Flight(scenario, Outcome.NO_CONTACT, measures, columns, units, telemetry)


def fake_steps_flight(robot: str) -> Flight:
    t = np.arange(0.0, 20.0, 0.01)
    wanted = {a: STEP_FROM[a] + 1.0 * (t >= STEP_BEGINS[a] - 1e-9) for a in ("x", "y", "z")}
    flown = {
        a: STEP_FROM[a] + 1.0 - np.exp(-np.clip(t - STEP_BEGINS[a], 0.0, None) / LAG[robot])
        for a in ("x", "y", "z")
    }
    return fake_guided_flight(step_tables(robot.split()[0], 0), t, wanted, flown)


def fake_circle_flight(robot: str, pace: Any) -> Flight:
    t = np.arange(0.0, CIRCLE_TIME, 0.01)
    turn = 2.0 * math.pi / PERIODS[pace]
    wanted = {"x": np.cos(turn * t), "y": np.sin(turn * t), "z": 1.0 + 0.0 * t}
    wanted |= {"vx": -turn * wanted["y"], "vy": turn * wanted["x"]}
    flown = {"x": 1.1 * wanted["x"], "y": 1.1 * wanted["y"], "z": wanted["z"]}
    return fake_guided_flight(circle_tables(robot.split()[0], pace, 0), t, wanted, flown)


def fake_free_flight_results(trials: int = 2) -> FlightResults:
    """Quad 1 % off print in all steps; ARQ 2 % in rise times, 20 % in errors; circles at half."""
    arms = (0.19,) * 4
    results = FlightResults(trials, drops=[Drop(0.0, 0.0, 0.005, 100.0, arms, 6e-13)])
    for robot in ROBOTS:
        for trial in range(trials):
            spread = 1.0 + 1e-3 * (trial - 0.5 * (trials - 1))
            off = (1.01, 1.01) if robot == "quad" else (1.02, 1.2)
            prints = TABLE_IV_STEPS[robot]
            rise = {axis: off[0] * spread * prints[axis][0] for axis in prints}
            mse = {axis: off[1] * spread * prints[axis][1] for axis in prints}
            flight = fake_steps_flight(robot) if trial == 0 else None
            results.responses.append(Response(robot, trial, rise, mse, flight))
            for pace in PERIODS:
                numbers = zip(FLIGHT_QUANTITIES, TABLE_IV_CIRCLES[robot, pace], strict=True)
                errors = {name: 0.5 * spread * number for name, number in numbers}
                later = {name: 0.1 * error for name, error in errors.items()}
                kept = fake_circle_flight(robot, pace) if trial == 0 else None
                results.circles.append(CircleRun(robot, pace, trial, errors, later, kept))
    return results


def with_contact(flight: Flight) -> Flight:
    """The same flight with a contact of two arms between 2.0 and 2.1 s."""
    t = flight.t
    force = np.where((t > 2.0) & (t < 2.1), 100.0, 0.0)
    measures = {
        **flight.measures, "touch_time": 2.0, "separation_time": 2.1, "return_time": 2.1,
    }  # fmt: skip
    columns = {**flight.columns, "fn1": force, "fn2": 0.5 * force}
    rates = [f"dl{j}" for j in (1, 2, 3, 4)]
    columns |= dict.fromkeys(rates, 0.0 * t)
    units = {**flight.units, **dict.fromkeys(rates, "m/s")}
    return replace(flight, columns=columns, measures=measures, units=units)


def fake_trials(lost: Outcome = Outcome.RECOVERED) -> ResilienceResults:
    """Ten trials of each robot at 3.5 m/s; ARQ recovers, Quad ends as is asked for."""
    measures = dict.fromkeys([*MEASURES, *RECOVERY_MEASURES], 1.0)
    ends = {"arq": Outcome.RECOVERED, "quad": lost}
    return ResilienceResults(10, flown=[
        Trial(robot, 0.0, 3.5, k, end, measures) for robot, end in ends.items() for k in range(10)
    ])  # fmt: skip
