"""RotorPy's own loop, hovering the vehicle that is given: ``python -m benchmarks.rotorpy_hover``.

It needs RotorPy and NumPy only, so that it also runs in an environment of its own, which
`benchmarks.closed_loop` can report.  Reads the vehicle as JSON on standard input, writes the
seconds that each round took, and how far the robot strayed, as JSON on standard output.

RotorPy (S. Folk, J. Paulos, V. Kumar, arXiv 2306.04485): rigid body, rotor lag and geometric
controller, with one rate for everything; at each step it measures with an inertial unit and motion
capture, but its controller takes the truth and its estimator is the one that does nothing.
"""

from __future__ import annotations

import json
import sys
import time
from typing import Any


def parameters(vehicle: dict[str, Any]) -> dict[str, Any]:
    """A vehicle as RotorPy wants it.

    Thrust there is k_η Ω²; only the ratio of torque to thrust and the largest thrust matter here,
    so the largest speed of a rotor is chosen and k_η follows.
    """
    speed = 2000.0  # [rad/s], chosen
    k_eta = vehicle["max_thrust"] / speed**2
    inertia = vehicle["inertia"]
    return {
        "mass": vehicle["mass"],
        **{f"I{a}{a}": inertia[k] for k, a in enumerate("xyz")},
        "Ixy": 0.0, "Iyz": 0.0, "Ixz": 0.0,
        "c_Dx": 0.0, "c_Dy": 0.0, "c_Dz": 0.0,
        "num_rotors": 4,
        "rotor_pos": {f"r{k}": place for k, place in enumerate(vehicle["rotors"], start=1)},
        "rotor_directions": vehicle["spins"],
        "k_eta": k_eta, "k_m": k_eta * vehicle["torque_ratio"],
        "k_d": 0.0, "k_z": 0.0, "k_h": 0.0, "k_flap": 0.0,
        "tau_m": vehicle["rotor_lag"],
        "rotor_speed_min": 0.0, "rotor_speed_max": speed, "motor_noise_std": 0.0,
    }  # fmt: skip


def hover(vehicle: dict[str, Any], duration: float, rate: float) -> tuple[float, float]:
    """Seconds that a hover takes, and how far the robot strays [m]."""
    import numpy as np
    from rotorpy.controllers.quadrotor_control import SE3Control
    from rotorpy.environments import Environment
    from rotorpy.trajectories.hover_traj import HoverTraj
    from rotorpy.vehicles.multirotor import Multirotor

    quad = parameters(vehicle)
    quad["rotor_pos"] = {key: np.array(place) for key, place in quad["rotor_pos"].items()}
    quad["rotor_directions"] = np.array(quad["rotor_directions"])
    speed = np.sqrt(vehicle["mass"] * 9.81 / 4.0 / quad["k_eta"])
    zero = np.zeros(3)
    start = {
        "x": zero, "v": zero, "q": np.array([0.0, 0.0, 0.0, 1.0]), "w": zero, "wind": zero,
        "rotor_speeds": np.full(4, speed),
    }  # fmt: skip
    loop = Environment(
        vehicle=Multirotor(quad, initial_state=start, control_abstraction="cmd_motor_speeds"),
        controller=SE3Control(quad),
        trajectory=HoverTraj(),
        sim_rate=rate,
    )
    began = time.perf_counter()
    result = loop.run(t_final=duration, terminate=False)
    seconds = time.perf_counter() - began
    return seconds, float(np.abs(result["state"]["x"]).max())


def main() -> None:
    job = json.load(sys.stdin)
    rounds = [hover(job["vehicle"], job["duration"], job["rate"]) for _ in range(job["rounds"])]
    from importlib.metadata import version

    found = {
        "version": version("rotorpy"),
        "seconds": [seconds for seconds, _ in rounds],
        "strayed": max(strayed for _, strayed in rounds),
    }
    sys.stdout.write(json.dumps(found) + "\n")


if __name__ == "__main__":
    main()
