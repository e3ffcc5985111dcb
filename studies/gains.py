"""Which force gains answer steps as Quad does in Table IV?  And how does ARQ answer with the same?

    python studies/gains.py [--out DIR]

A planar model of the default cascade: position loop with hold and offboard delay, attitude and rate
loop, rotor lag.  Two gains are fitted to two printed numbers for each kind of axis.  Writes
``gains.csv`` and prints the table that stands in studies/README.md.
"""

from __future__ import annotations

import argparse
import csv
import math
from pathlib import Path
from typing import NamedTuple

import numpy as np
from scipy.optimize import least_squares

from springback.control.parameters import ControlSettings

#: Table IV, Quad: rise time 10 to 90 % [s] and mean of (1 − p)² over 5 s; x and y as their mean.
QUAD = {"horizontal": ((0.649 + 0.662) / 2.0, (0.090 + 0.094) / 2.0), "vertical": (0.625, 0.059)}
#: Table IV, ARQ before collisions.
ARQ = {"horizontal": ((0.760 + 0.782) / 2.0, (0.098 + 0.107) / 2.0), "vertical": (0.627, 0.064)}
#: [kg] with the battery that the printed hover times give, and without: Quad, ARQ.
MASSES = {"with battery": (1.22, 1.41), "without": (0.844, 1.034)}
GRAVITY, ROTOR_LAG, STEP, DWELL = 9.81, 0.03, 1e-3, 5.0  # SI; rotor lag as in the fit's source
SETTINGS = ControlSettings()


class Answer(NamedTuple):
    """Measures of a step response."""

    rise: float
    mse: float
    overshoot: float


def step(kind: str, k_p: float, k_v: float, mass: float) -> np.ndarray:
    """Position over the dwell after a unit step along x or z, every millisecond."""
    c = SETTINGS
    every = round(1.0 / (c.position_frequency * STEP))
    late = round(c.offboard_delay / STEP)
    p = v = angle = omega = push = 0.0  # push: angular acceleration (x), force per mass (z)
    force, queue, path = 0.0, [0.0] * (late + 1), []
    for k in range(round(DWELL / STEP)):
        if k % every == 0:
            asked = (k_p * (1.0 - p) - k_v * v) / mass
            force = max(-c.feedback_acceleration, min(c.feedback_acceleration, asked))
        queue = [*queue[1:], force]
        if kind == "horizontal":
            error = math.atan2(queue[0], GRAVITY) - angle
            limit = c.rate_limit
            wanted = max(-limit, min(limit, 2.0 * math.sin(error / 2.0) / c.time_constant))
            push += STEP / ROTOR_LAG * (c.rate_gain * (wanted - omega) - push)
            omega += STEP * push
            angle += STEP * omega
            acceleration = GRAVITY * math.tan(angle)  # height is held
        else:
            push += STEP / ROTOR_LAG * (queue[0] - push)
            acceleration = push
        v += STEP * acceleration
        p += STEP * v
        path.append(p)
    return np.array(path)


def measured(path: np.ndarray) -> Answer:
    """Rise time from 10 to 90 % of where the path settles, mean square error, overshoot."""
    settled = path[-round(0.5 / STEP) :].mean()
    times = []
    for level in (0.1 * settled, 0.9 * settled):
        k = int(np.argmax(path >= level))
        times.append(k - (path[k] - level) / (path[k] - path[k - 1]))
    mse = float(np.mean((1.0 - path) ** 2))
    return Answer(STEP * (times[1] - times[0]), mse, float(path.max() / settled - 1.0))


def fitted(kind: str, mass: float, start: tuple[float, float]) -> tuple[float, float]:
    """K_p [N/m] and K_v [N s/m] with Quad's rise time and mean square error."""
    rise, mse = QUAD[kind]

    def residual(gains: np.ndarray) -> list[float]:
        answer = measured(step(kind, *gains, mass))
        return [answer.rise / rise - 1.0, answer.mse / mse - 1.0]

    found = least_squares(residual, start, bounds=(0.5, 100.0), diff_step=1e-3, x_scale=start)
    return float(found.x[0]), float(found.x[1])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=Path())
    out = parser.parse_args().out
    rows = []
    print(
        "| masses | axis | K_p [N/m] | K_v [N s/m] | robot | "
        "rise [s], printed | MSE, printed | over |"
    )
    print("|---|---|---:|---:|---|---:|---:|---:|")
    for label, (quad, arq) in MASSES.items():
        for kind, start in (("horizontal", (8.6, 5.3)), ("vertical", (15.0, 6.4))):
            k_p, k_v = fitted(kind, quad, (start[0] * quad, start[1] * quad))
            for robot, mass, printed in (("Quad", quad, QUAD[kind]), ("ARQ", arq, ARQ[kind])):
                a = measured(step(kind, k_p, k_v, mass))
                rows.append([label, kind, k_p, k_v, robot, *a, *printed])
                print(
                    f"| {label} | {kind} | {k_p:.2f} | {k_v:.2f} | {robot} | {a.rise:.3f}, "
                    f"{printed[0]:.3f} | {a.mse:.4f}, {printed[1]:.4f} | {a.overshoot:.1%} |"
                )
    out.mkdir(parents=True, exist_ok=True)
    with (out / "gains.csv").open("w", newline="") as file:
        csv.writer(file).writerows(rows)


if __name__ == "__main__":
    main()
