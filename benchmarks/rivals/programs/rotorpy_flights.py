"""RotorPy's loop, one flight at a time on every core, flying the given step.

RotorPy (S. Folk, J. Paulos, V. Kumar, arXiv 2306.04485): rigid body, rotor lag and geometric
controller, with one rate for everything; at each step it measures with an inertial unit and motion
capture, but its controller takes the truth and its estimator is the one that does nothing.
"""

from __future__ import annotations

from typing import Any

import protocol

#: A flight that takes longer than this is not flown alone again [s].
LONG = 5.0


def parameters(vehicle: dict[str, Any]) -> dict[str, Any]:
    """A vehicle as RotorPy wants it.

    Thrust there is k_η Ω²; only the ratio of torque to thrust and the largest thrust matter here,
    so the largest speed of a rotor is chosen and k_η follows.
    """
    import numpy as np

    speed = 2000.0  # [rad/s], chosen
    k_eta = vehicle["max_thrust"] / speed**2
    return {
        "mass": vehicle["mass"],
        **{f"I{a}{a}": vehicle["inertia"][k] for k, a in enumerate("xyz")},
        "Ixy": 0.0, "Iyz": 0.0, "Ixz": 0.0,
        "c_Dx": 0.0, "c_Dy": 0.0, "c_Dz": 0.0,
        "num_rotors": 4,
        "rotor_pos": {f"r{k}": np.array(at) for k, at in enumerate(vehicle["rotors"], start=1)},
        "rotor_directions": np.array(vehicle["spins"]),
        "k_eta": k_eta, "k_m": k_eta * vehicle["torque_ratio"],
        "k_d": 0.0, "k_z": 0.0, "k_h": 0.0, "k_flap": 0.0,
        "tau_m": vehicle["rotor_lag"],
        "rotor_speed_min": 0.0, "rotor_speed_max": speed, "motor_noise_std": 0.0,
        "kp_att": 310.0, "kd_att": 57.0,  # defaults of the loop for one flight
    }  # fmt: skip


class Step:
    """A set-point that jumps once, as RotorPy's trajectories speak."""

    def __init__(self, task: dict[str, Any]) -> None:
        """From and to where, and when."""
        import numpy as np

        self.before, self.after = np.array(task["start"]), np.array(task["target"])
        self.when, self.zero = task["step_at"], np.zeros(3)

    def update(self, t: float) -> dict[str, Any]:
        """The flat outputs at a time [s]."""
        still = dict.fromkeys(("x_dot", "x_ddot", "x_dddot", "x_ddddot"), self.zero)
        place = self.after if t >= self.when else self.before
        return {"x": place, **still, "yaw": 0.0, "yaw_dot": 0.0, "yaw_ddot": 0.0}


def fly(asked: tuple[dict[str, Any], list[tuple[float, float]]]) -> float:
    """Flights one after another; how far from its target the worst one ends [m]."""
    import numpy as np
    from rotorpy.controllers.quadrotor_control import SE3Control
    from rotorpy.environments import Environment
    from rotorpy.vehicles.multirotor import Multirotor

    job, places = asked
    task, quad, missed = job["task"], parameters(job["vehicle"]), 0.0
    speed = np.sqrt(quad["mass"] * 9.81 / 4.0 / quad["k_eta"])
    for beside in places:
        start = {
            "x": np.add(task["start"], [*beside, 0.0]), "v": np.zeros(3),
            "q": np.array([0.0, 0.0, 0.0, 1.0]), "w": np.zeros(3), "wind": np.zeros(3),
            "rotor_speeds": np.full(4, speed),
        }  # fmt: skip
        loop = Environment(
            vehicle=Multirotor(quad, initial_state=start, control_abstraction="cmd_motor_speeds"),
            controller=SE3Control(quad),
            trajectory=Step(task),
            sim_rate=job["rate"],
        )
        result = loop.run(t_final=task["duration"], terminate=False)
        end = result["state"]["x"][-1]
        missed = max(missed, float(np.linalg.norm(end - np.array(task["target"]))))
    return missed


def main() -> None:
    job = protocol.job()
    import rotorpy.environments  # noqa: F401

    imported = protocol.since(job)
    alone: Any = (job, protocol.scatter(1))
    seconds, _ = protocol.timed(lambda: fly(alone))
    first = protocol.since(job)
    latency = [seconds]  # nothing compiles, so the first counts
    if seconds < LONG:
        latency += protocol.repeated(lambda: fly(alone), most=3)
    many, missed = protocol.many(job, fly, first=False)
    protocol.answer(
        versions=protocol.versions("rotorpy", "numpy", "scipy"), imported=imported, first=first,
        latency=latency, many=many, missed=missed, memory=protocol.peak_memory(job["threads"]),
    )  # fmt: skip


if __name__ == "__main__":
    main()
