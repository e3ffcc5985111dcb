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


def judged(told: dict[str, Any]) -> dict[str, Any]:
    """Worst errors of every step against the finest one."""
    import numpy as np
    from benchmarks.job import Lanes
    from benchmarks.rivals.impacts import hits, model

    from springback.simulation.flight import LANES

    states = hits(told["hits"])

    def at(step: float) -> Any:
        return metrics(Lanes(model(step), states, LANES).run(told["threads"]).values)

    limit = at(told["limit"])
    errors = [(step, np.abs(at(step) / limit - 1.0).max(axis=1).tolist()) for step in told["steps"]]
    return {"converged": limit.tolist(), "errors": errors}


def main() -> None:
    told = protocol.job()
    from benchmarks.job import Lanes
    from benchmarks.rivals.impacts import hits, model

    from springback.simulation.flight import LANES
    from springback.version import __version__

    if told["judge"]:
        protocol.answer(**judged(told))
        return
    imported = protocol.since(told)
    numbers = model(told["step"])
    alone = Lanes(numbers, hits(1), 1)
    alone.run(1)
    first = protocol.since(told)
    latency = protocol.repeated(lambda: alone.run(1))
    many = []
    for _, flights in told["tries"]:
        lanes = Lanes(numbers, hits(flights), LANES)
        lanes.run(told["threads"])
        seconds = sorted(lanes.run(told["threads"]).seconds for _ in range(3))[1]
        many.append({"processes": 1, "flights": flights, "seconds": seconds})
    protocol.answer(
        versions=protocol.versions("numba", "numpy") | {"springback": __version__},
        imported=imported, first=first, latency=latency, many=many,
        memory=protocol.peak_memory(), missed=None,
    )  # fmt: skip


if __name__ == "__main__":
    main()
