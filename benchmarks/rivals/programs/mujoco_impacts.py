"""MuJoCo's impacts by `mujoco.rollout` on a pool of threads, models and states given as data.

Where speed is measured there are no sensors and no energies, and flights go in portions whose
trajectories, which a rollout always keeps, stay small.
"""

from __future__ import annotations

from typing import Any

import protocol

#: Flights in one call (chosen: larger portions were not faster).
PORTION = 64


class Program:
    """A model, and flights of it.

    Args:
        document: MJCF.
        rows: Positions and velocities at the start, one flight a row.
        thrust: Of all rotors [N].
        horizon: Of a flight [s].
        threads: In the pool.
    """

    def __init__(
        self, document: str, rows: list[list[float]], thrust: float, horizon: float, threads: int
    ) -> None:
        """Compile and lay out."""
        import mujoco
        import numpy as np
        from mujoco import rollout

        self.model = mujoco.MjModel.from_xml_string(document)
        self.step, kind = self.model.opt.timestep, mujoco.mjtState.mjSTATE_FULLPHYSICS
        self.steps = round(horizon / self.step)
        self.data = [mujoco.MjData(self.model) for _ in range(threads)]
        self.initial = np.zeros((len(rows), mujoco.mj_stateSize(self.model, kind)))
        self.initial[:, 1 : 1 + len(rows[0])] = rows  # after the time
        portion = min(PORTION, len(rows))
        self.control = np.full((portion, self.steps, 1), thrust)
        self.state = np.zeros((portion, self.steps, self.initial.shape[1]))
        self.seen = np.zeros((portion, self.steps, self.model.nsensordata))
        self.pool: Any = rollout.Rollout(nthread=threads)

    def run(self) -> None:
        """All flights; of the last portion the trajectories are kept."""
        for first in range(0, len(self.initial), PORTION):
            part = self.initial[first : first + PORTION]
            n = len(part)
            self.pool.rollout(
                self.model, self.data, part, self.control[:n],
                state=self.state[:n], sensordata=self.seen[:n],
            )  # fmt: skip

    def metrics(self) -> Any:
        """Restitution, peak acceleration and contact time of every hit, shape (3, hits).

        Touch and separation lie between steps: they are where the depth of two steps in contact,
        continued in a straight line, is zero.
        """
        import numpy as np

        h, at = self.step, np.arange(len(self.initial))
        velocity = self.state[:, :, 1 + self.model.nq : 4 + self.model.nq]
        began = self.initial[:, None, 1 + self.model.nq : 4 + self.model.nq]
        velocity = np.concatenate([began, velocity], axis=1)
        peak = np.linalg.norm(np.diff(velocity, axis=1) / h, axis=2).max(axis=1)
        # Sensors see the state before the step, which is the one with the same index here.
        found, depth = self.seen[:, :, 0] > 0.0, self.seen[:, :, 1]
        first, last = found.argmax(axis=1), found.shape[1] - 1 - found[:, ::-1].argmax(axis=1)
        if found[:, -1].any() or not found.any(axis=1).all():
            raise SystemExit("not every hit is over by the end")
        inwards = (depth[at, first + 1] - depth[at, first]) / h
        outwards = (depth[at, last] - depth[at, last - 1]) / h
        touch = first * h - depth[at, first] / inwards
        separation = last * h - depth[at, last] / outwards
        speeds = velocity[at, last + 1, 0] / velocity[at, first - 1, 0]
        return np.array([np.abs(speeds), peak, separation - touch])


def main() -> None:
    job = protocol.job()
    import mujoco
    import numpy as np

    imported = protocol.since(job)
    fixed = job["thrust"], job["horizon"]

    def metrics(document: str) -> Any:
        program = Program(document, job["rows"], *fixed, job["threads"])
        program.run()
        return program.metrics()

    if job["judge"]:
        limit = metrics(job["limit"])
        errors = [
            (step, np.abs(metrics(document) / limit - 1.0).max(axis=1).tolist())
            for step, document in job["documents"]
        ]
        protocol.answer(converged=limit.tolist(), errors=errors)
        return
    alone = Program(job["document"], job["rows"][:1], *fixed, 1)
    alone.run()
    first = protocol.since(job)
    latency = protocol.repeated(alone.run)
    many = []
    for _, flights in job["tries"]:
        program = Program(job["document"], job["rows"][:flights], *fixed, job["threads"])
        program.run()
        seconds = sorted(protocol.timed(program.run)[0] for _ in range(3))[1]
        many.append({"processes": 1, "flights": flights, "seconds": seconds})
    protocol.answer(
        versions={"mujoco": mujoco.__version__} | protocol.versions("numpy"), imported=imported,
        first=first, latency=latency, many=many, memory=protocol.peak_memory(), missed=None,
    )  # fmt: skip


if __name__ == "__main__":
    main()
