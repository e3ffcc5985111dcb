"""springback's impacts: many flights in lanes, states laid out beforehand."""

from __future__ import annotations

from typing import Any

import protocol


def metrics(values: dict[str, Any]) -> Any:
    """Restitution, peak acceleration [m/s²] and contact time [s] of every hit, shape (3, hits)."""
    import numpy as np

    if (values["impacts"] != 1.0).any() or (values["touching"] > 0.0).any():
        raise SystemExit("not every hit is one impact, over by the end")
    return np.array(
        [
            np.abs(values["separation_speed"] / values["touch_speed"]),
            values["peak_acceleration"],
            values["separation_time"] - values["touch_time"],
        ]
    )


def judged(job: dict[str, Any]) -> dict[str, Any]:
    """Worst errors of every step against the finest one."""
    import numpy as np
    from benchmarks.job import Lanes
    from benchmarks.rivals.impacts import hits, model

    from springback.simulation.flight import LANES

    states = hits(job["hits"])

    def at(step: float) -> Any:
        return metrics(Lanes(model(step), states, LANES).run(job["threads"]).values)

    limit = at(job["limit"])
    errors = [(step, np.abs(at(step) / limit - 1.0).max(axis=1).tolist()) for step in job["steps"]]
    return {"converged": limit.tolist(), "errors": errors}


def main() -> None:
    job = protocol.job()
    from benchmarks.job import Lanes
    from benchmarks.rivals.impacts import hits, model

    from springback.simulation.flight import LANES
    from springback.version import __version__

    if job["judge"]:
        protocol.answer(**judged(job))
        return
    imported = protocol.since(job)
    numbers = model(job["step"])
    alone = Lanes(numbers, hits(1), 1)
    alone.run(1)
    first = protocol.since(job)
    latency = protocol.repeated(lambda: alone.run(1))
    many = []
    for _, flights in job["tries"]:
        lanes = Lanes(numbers, hits(flights), LANES)
        lanes.run(job["threads"])
        seconds = sorted(lanes.run(job["threads"]).seconds for _ in range(3))[1]
        many.append({"processes": 1, "flights": flights, "seconds": seconds})
    protocol.answer(
        versions=protocol.versions("numba", "numpy") | {"springback": __version__},
        imported=imported, first=first, latency=latency, many=many,
        memory=protocol.peak_memory(), missed=None,
    )  # fmt: skip


if __name__ == "__main__":
    main()
