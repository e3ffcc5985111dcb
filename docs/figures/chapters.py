"""Small figures of the chapters, from the laws and devices themselves.

python docs/figures/chapters.py
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np

mpl.use("Agg")
import matplotlib.pyplot as plt

import springback
from springback.contact.surfaces import AnyExponent, normal_force
from springback.interfaces.figures.style import STYLE as STYLES
from springback.recovery.response import Quintic, recovery_plan
from springback.sensing.hall import output, resolution
from springback.sensing.parameters import HallSettings

HERE = Path(__file__).parent
STYLE = STYLES[-1]
BLUE, ORANGE, GREEN, GREY = "#0072b2", "#d55e00", "#009e73", "#777777"


def loops() -> Any:
    """Force over penetration, in and out, of three laws: one mass of 1.9 kg at 1.85 m/s."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(7.0, 2.6))
    linear = {"law": "kelvin-voigt", "stiffness": 3e4, "viscosity": 90.0}
    laws = {
        "hertz": ({"law": "hertz"}, GREY, ":"),
        "hunt-crossley, wall": ({"dissipation": 0.432}, BLUE, "-"),
        "kelvin-voigt": (linear, ORANGE, "--"),
    }
    for name, (given, colour, style) in laws.items():
        settings = springback.SurfaceSettings.model_validate(given)
        depth, force = _bounce(settings.surface(AnyExponent), 1.9, 1.85)
        left.plot(1e3 * depth, force, style, color=colour, label=name)
    left.set(xlabel="Penetration δ [mm]", ylabel="Normal force [N]")
    left.legend()
    speeds = np.linspace(0.05, 6.0, 60)
    for name, c_a, colour, style in (("wall", 0.432, BLUE, "-"), ("mat", 0.354, GREEN, "-.")):
        e = [springback.restitution(c_a, float(v)) for v in speeds]
        right.plot(speeds, e, style, color=colour, label=f"{name}, exact")
    right.plot(speeds, 1.0 - 0.432 * speeds, ":", color=GREY, label="wall, textbook 1 − c_a v₀")
    right.set(xlabel="Speed at touch [m/s]", ylabel="Restitution e [–]", ylim=(0.0, 1.0))
    right.legend()
    return figure


def _bounce(surface: Any, mass: float, speed: float) -> tuple[Any, Any]:
    """Penetration [m] and force [N] of one mass until it leaves, by small steps."""
    h, depth, v = 1e-6, 0.0, speed
    depths, forces = [0.0], [0.0]
    while depth >= 0.0:
        force = normal_force(surface, depth, v, 0.0).force
        v -= force / mass * h
        depth += v * h
        depths.append(max(depth, 0.0))
        forces.append(force)
    return np.array(depths), np.array(forces)


def hall() -> Any:
    """What the Hall-effect sensor says, and how fine it is."""
    sensors = HallSettings().device(1e-3, springback.ARQ.vehicle)
    pressed = np.linspace(0.0, 50.0, 200)
    figure, (left, right) = plt.subplots(1, 2, figsize=(7.0, 2.4))
    left.plot(pressed, [output(sensors, 1e-3 * float(x)) for x in pressed], color=BLUE)
    left.set(xlabel="Compression L − l [mm]", ylabel="Output [V]")
    right.semilogy(
        pressed, [1e3 * resolution(sensors, 1e-3 * float(x)) for x in pressed], color=BLUE
    )
    right.set(xlabel="Compression L − l [mm]", ylabel="One count [mm]")
    right.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
    return figure


def quintic() -> Any:
    """What the way back asks for after 3.5 m/s: position and pitch."""
    from springback import Quat, Vec
    from springback.control.target import target
    from springback.recovery.characterisation import Collision
    from springback.sensing.measurement import Estimate

    none = Vec(0.0, 0.0, 0.0)
    hit = Collision(
        none, Vec(3.5, 0.0, 0.0), Vec(1.0, 0.0, 0.0), none, none, none, none, none, (0.0,) * 4, 0.0
    )
    still = Estimate(none, Quat(1.0, 0.0, 0.0, 0.0), none, none)
    figure, (left, right) = plt.subplots(1, 2, figsize=(7.0, 2.4))
    for pace, colour, style in ((0.15, GREY, ":"), (0.19, BLUE, "-"), (0.25, ORANGE, "--")):
        way = recovery_plan(Quintic(1.0, 0.0, pace, 0.2), hit, Vec(-0.1, 0.0, 0.0), still, 0.0, 0.0)
        times = np.linspace(0.0, float(way.ends), 200)
        asked = [target(way.reference, float(t)) for t in times]
        label = f"{pace:g} s²/m"
        left.plot(times, [one.position.x for one in asked], style, color=colour, label=label)
        pitch = [math.degrees(math.atan2(one.acceleration.x, 9.81)) for one in asked]
        right.plot(times, pitch, style, color=colour, label=label)
    left.set(xlabel="Time after the plan [s]", ylabel="x − p_c [m]")
    right.set(xlabel="Time after the plan [s]", ylabel="Pitch asked for [°]")
    for value in (-66.0, 49.0):
        right.axhline(value, color=GREY, linewidth=0.6)
        right.annotate("printed", (0.88, value + 3.0), color=GREY, ha="right", fontsize=8.0)
    left.legend()
    return figure


FIGURES: dict[str, Callable[[], Any]] = {"contact": loops, "hall": hall, "quintic": quintic}


def drawn(folder: Path) -> list[Path]:
    """All figures as PNG."""
    written = []
    with plt.style.context(STYLE):
        for name, draw in FIGURES.items():
            figure = draw()
            path = folder / f"{name}.png"
            figure.savefig(path, dpi=130, metadata={"Software": None})
            plt.close(figure)
            written.append(path)
    return written


if __name__ == "__main__":
    for path in drawn(Path(sys.argv[1]) if len(sys.argv) > 1 else HERE):
        print(path)
