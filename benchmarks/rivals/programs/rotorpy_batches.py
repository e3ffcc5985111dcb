"""RotorPy's batched loop (PyTorch), flying the given step.

Its batched loop has an inertial unit, but neither motion capture nor an estimator; its own batched
trajectories go through the flights one by one in Python, so it is given one that does not.
"""

from __future__ import annotations

from typing import Any

import protocol
from rotorpy_flights import LONG, parameters


def _doubles(count: int, rows: int, values: list[float] | None = None) -> Any:
    import torch

    if values is None:
        return torch.zeros(count, rows, dtype=torch.double)
    return torch.tensor(values, dtype=torch.double).repeat(count, 1)


class Steps:
    """A set-point that jumps once, for all flights, as RotorPy's batched trajectories speak."""

    def __init__(self, task: dict[str, Any], count: int) -> None:
        """From and to where, and when."""
        import torch

        self.when = task["step_at"]
        self.before = _doubles(count, 3, task["start"])
        self.after = _doubles(count, 3, task["target"])
        derivatives = ("x_dot", "x_ddot", "x_dddot", "x_ddddot")
        self.still = {name: _doubles(count, 3) for name in derivatives}
        yaw = torch.zeros(count, dtype=torch.double)
        self.still |= dict.fromkeys(("yaw", "yaw_dot", "yaw_ddot"), yaw)

    def update(self, times: Any) -> dict[str, Any]:
        """The flat outputs at a time, the same for all [s]."""
        return {"x": self.after if times[0] >= self.when else self.before, **self.still}


def fly(asked: tuple[dict[str, Any], list[tuple[float, float]]]) -> float:
    """A batch of flights; how far from its target the worst one ends [m]."""
    import numpy as np
    import torch
    from rotorpy.controllers.quadrotor_control import BatchedSE3Control
    from rotorpy.sensors.imu import BatchedImu
    from rotorpy.simulate import simulate_batch
    from rotorpy.vehicles.multirotor import BatchedMultirotor, BatchedMultirotorParams
    from rotorpy.wind.default_winds import BatchedNoWind
    from rotorpy.world import World

    job, places = asked
    count = len(places)
    if not count:
        return 0.0
    torch.set_num_threads(job["torch_threads"])
    task, device, quad = job["task"], torch.device("cpu"), parameters(job["vehicle"])
    speed = float(np.sqrt(quad["mass"] * 9.81 / 4.0 / quad["k_eta"]))
    batch = BatchedMultirotorParams([quad] * count, count, device)
    start = _doubles(count, 3, task["start"])
    start[:, :2] += torch.tensor(places, dtype=torch.double)
    states = {
        "x": start, "v": _doubles(count, 3), "q": _doubles(count, 4, [0.0, 0.0, 0.0, 1.0]),
        "w": _doubles(count, 3), "wind": _doubles(count, 3),
        "rotor_speeds": _doubles(count, 4, [speed] * 4),
    }  # fmt: skip
    vehicles = BatchedMultirotor(
        batch, count, states, device, control_abstraction="cmd_motor_speeds",
        integrator=job["integrator"],
    )  # fmt: skip
    found = simulate_batch(
        World.empty((-5.0, 5.0, -5.0, 5.0, -5.0, 5.0)), states, vehicles,
        BatchedSE3Control(batch, count, device), Steps(task, count), BatchedNoWind(count),
        BatchedImu(count, device=device), np.full(count, task["duration"]), 1.0 / job["rate"],
        0.25, terminate=False, check_collisions=False,
    )  # fmt: skip
    end = found[1]["x"][-1]
    return float(np.linalg.norm(np.asarray(end) - np.array(task["target"]), axis=-1).max())


def main() -> None:
    job = protocol.job()
    import rotorpy.simulate  # noqa: F401

    imported = protocol.since(job)
    job["torch_threads"] = job["threads"]
    alone: Any = (job, protocol.scatter(1))
    seconds, _ = protocol.timed(lambda: fly(alone))
    first = protocol.since(job)
    latency = [seconds]  # nothing compiles, so the first counts
    if seconds < LONG:
        latency += protocol.repeated(lambda: fly(alone), most=2)
    found, missed = [], 0.0
    for processes, flights in job["tries"]:
        one_try = {**job, "tries": [[processes, flights]]}
        one_try["torch_threads"] = max(1, job["threads"] // processes)
        seconds_of, misses = protocol.many(one_try, fly, first=False)
        found, missed = [*found, *seconds_of], max(missed, misses)
    protocol.answer(
        versions=protocol.versions("rotorpy", "torch", "torchdiffeq"), imported=imported,
        first=first, latency=latency, many=found, missed=missed,
        memory=protocol.peak_memory(job["threads"] if job["tries"][0][0] > 1 else 0),
    )  # fmt: skip


if __name__ == "__main__":
    main()
