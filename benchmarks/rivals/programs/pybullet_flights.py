"""gym-pybullet-drones, one flight at a time on every core, flying the given step.

Its own Crazyflie and its own controller, whose gains are made for that vehicle, at the rates of
its own examples.  Bullet looks for contacts at every step; there is the ground.
"""

from __future__ import annotations

import contextlib
import io
import warnings
from typing import Any

import protocol

warnings.simplefilter("ignore")


def fly(asked: tuple[dict[str, Any], list[tuple[float, float]]]) -> float:
    """Flights one after another; how far from its target the worst one ends [m]."""
    import numpy as np

    with contextlib.redirect_stdout(io.StringIO()):
        from gym_pybullet_drones.control.DSLPIDControl import DSLPIDControl
        from gym_pybullet_drones.envs.CtrlAviary import CtrlAviary
        from gym_pybullet_drones.utils.enums import DroneModel, Physics

    job, places = asked
    task, missed, level = job["task"], 0.0, np.zeros(3)
    for beside in places:
        start = np.add(task["start"], [*beside, 0.0])
        with contextlib.redirect_stdout(io.StringIO()):
            world = CtrlAviary(
                drone_model=DroneModel.CF2X, num_drones=1, initial_xyzs=start.reshape(1, 3),
                initial_rpys=np.zeros((1, 3)), physics=Physics.PYB, pyb_freq=job["physics_rate"],
                ctrl_freq=job["rate"], gui=False, record=False, obstacles=False,
            )  # fmt: skip
        pilot, action = DSLPIDControl(drone_model=DroneModel.CF2X), np.zeros((1, 4))
        for k in range(round(task["duration"] * job["rate"])):
            seen, *_ = world.step(action)
            late = k >= task["step_at"] * job["rate"]
            place = np.array(task["target"]) if late else np.array(task["start"])
            action[0], _, _ = pilot.computeControlFromState(
                control_timestep=world.CTRL_TIMESTEP, state=seen[0], target_pos=place,
                target_rpy=level,
            )  # fmt: skip
        missed = max(missed, float(np.linalg.norm(seen[0][:3] - np.array(task["target"]))))
        world.close()
    return missed


def main() -> None:
    job = protocol.job()
    with contextlib.redirect_stdout(io.StringIO()):
        import gym_pybullet_drones.envs.CtrlAviary  # noqa: F401

    imported = protocol.since(job)
    alone: Any = (job, protocol.scatter(1))
    seconds, _ = protocol.timed(lambda: fly(alone))
    first = protocol.since(job)
    latency = [seconds, *protocol.repeated(lambda: fly(alone), most=3)]
    many, missed = protocol.many(job, fly, first=False)
    protocol.answer(
        versions=protocol.versions("gym-pybullet-drones", "pybullet", "numpy"), imported=imported,
        first=first, latency=latency, many=many, missed=missed,
        memory=protocol.peak_memory(job["threads"]),
    )  # fmt: skip


if __name__ == "__main__":
    main()
