"""Numbers printed in the paper, with their places; nothing here is ours."""

from __future__ import annotations

from typing import NamedTuple

PAPER = (
    "Z. Liu and K. Karydis, Dynamic Modeling and Analysis of Impact-resilient MAVs Undergoing "
    "High-speed and Large-angle Collisions with the Environment"
)

SLIDER_SPEED = 1.85
"""[m/s], section IV-A, 'about 1.85 m/s right before collision'."""
SLIDER_DISTANCE = 1.0
"""[m], section IV-A, D."""
DISSIPATION_RANGE = (0.01, 0.5)
"""[s/m], section IV-A, of c_a: "usually between"."""
FREE_MASS = {"quad": 0.844, "arq": 1.034}
"""[kg], Table I, without battery: 'only the masses of the robots' in the sweep."""
SWEEP_GAP = 493.0
"""[m/s²], section IV-A, difference of the peak accelerations at 6 m/s."""
SWEEP_SPEEDS = (1.0, 2.0, 3.0, 4.0, 5.0, 6.0)
"""[m/s], figure of the sweep."""


class PrintedImpact(NamedTuple):
    """One column of Table III with what the text adds."""

    restitution: float
    restitution_test: float
    peak_acceleration: float  # [m/s²]
    peak_acceleration_test: float  # [m/s²]
    travel: float  # δ [m]
    contact_time: float  # dt [s]


TABLE_III = {
    ("quad", "wall"): PrintedImpact(0.547, 0.526, 224.0, 235.0, 0.014, 0.031),
    ("quad", "mat"): PrintedImpact(0.598, 0.603, 168.0, 177.0, 0.018, 0.037),
    ("arq", "wall"): PrintedImpact(0.444, 0.451, 144.0, 146.0, 0.029, 0.079),
    ("arq", "mat"): PrintedImpact(0.498, 0.504, 137.0, 142.0, 0.033, 0.083),
}
"""Table III and the text of section IV-A: simulation and physical test."""

SUCCESS = {
    ("arq", 0.0, 2.0): 1.0, ("arq", 0.0, 3.5): 1.0, ("arq", -45.0, 2.0): 1.0,
    ("arq", -30.0, 2.0): 1.0, ("arq", 30.0, 2.0): 1.0, ("arq", -15.0, 2.0): 1.0,
    ("arq", 15.0, 2.0): 1.0, ("quad", 0.0, 3.5): 0.0,
}  # fmt: skip
"""Share of recovered collisions by robot, pitch [deg] and speed [m/s], section Impact Resilience:
ARQ '100% success rates for all collision tests'; Quad at 3.5 m/s 'fails ... in all trials'."""
SUCCESS_WORDS = {
    ("quad", 0.0, 2.0): "fairly good", ("quad", -30.0, 2.0): "fairly good",
    ("quad", 30.0, 2.0): "fairly good", ("quad", -15.0, 2.0): "fairly good",
    ("quad", 15.0, 2.0): "fairly good", ("quad", -45.0, 2.0): "drops",
}  # fmt: skip
"""The same where the paper has words and no number."""
#: How these words are quoted.
_QUOTED = {"fairly good": "“fairly good”", "drops": "success rate “drops”"}
RECOVERY_PITCH = (-66.0, 49.0)
"""[deg], largest nose up and nose down of a recovery from 3.5 m/s, section Impact Resilience."""
WALL_DISTANCE = 2.75
"""[m], section Impact Resilience, D."""
RECOVERY_DISTANCE = 0.1
"""[m], section on recovery, L_c."""
COLLISIONS_IN_A_ROW = 10
"""Recoveries of ARQ at -45 deg, 2 m/s, 'without landing', section Impact Resilience."""


def printed_success(robot: str, pitch: float, speed: float) -> str:
    """Printed success of a test, in words; empty if nothing is printed.

    Args:
        robot: Preset.
        pitch: Positive nose down [deg].
        speed: At contact [m/s].
    """
    share = SUCCESS.get((robot, pitch, speed))
    if share is not None:
        return "all succeed" if share == 1.0 else "none succeed"
    return _QUOTED.get(SUCCESS_WORDS.get((robot, pitch, speed), ""), "")
