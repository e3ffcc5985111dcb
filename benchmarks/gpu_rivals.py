"""MJX and Crazyflow on a GPU: ``python -m benchmarks.gpu_rivals``, beside ``benchmarks.gpu``.

MJX flies the impacts of `benchmarks.job` with its own law of contact at spheres, one step of it for
one of ours; Crazyflow hovers and steps 1 m ahead for 6 s, which is the task of `benchmarks.rivals`.
Both are timed warm, the best of three, single precision as they come.  One that is not installed is
left out, with the reason.
"""

from __future__ import annotations

import json
import os
import sys
import time
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any

os.environ.setdefault("SCIPY_ARRAY_API", "1")  # Crazyflow asks for it before SciPy is imported

import numpy as np

from benchmarks import mujoco_model
from benchmarks.job import reference_model, starts

STEPS = 1000


def _best(run: Callable[[], Any], rounds: int = 3) -> float:
    run()  # compiles
    best = float("inf")
    for _ in range(rounds):
        begun = time.perf_counter()
        run()
        best = min(best, time.perf_counter() - begun)
    return best


def mjx_impacts(worlds: int, integrator: str) -> dict[str, Any]:
    """RK4 or implicitfast steps a second of the five bodies before a wall."""
    import jax
    import mujoco
    from mujoco import mjx

    model = reference_model()
    there = mujoco.MjModel.from_xml_string(
        mujoco_model.xml(model, integrator, "sphere", measuring=False)
    )
    scene, blank = mjx.put_model(there), mjx.make_data(there)
    states = starts(model, 1024)
    none = [0.0] * len(model.airframe.arms)
    chosen = [states[k % len(states)] for k in range(worlds)]
    place = np.array([[*s.position, *s.attitude, *none] for s in chosen], dtype=np.float32)
    speed = np.array([[*s.velocity, *s.angular_velocity, *none] for s in chosen], dtype=np.float32)

    @jax.jit
    def fly(place: Any, speed: Any) -> Any:
        def one(q: Any, v: Any) -> Any:
            data = blank.replace(qpos=q, qvel=v, ctrl=blank.ctrl.at[0].set(sum(model.thrust)))

            def step(data: Any, _: None) -> Any:
                return mjx.step(scene, data), None

            return jax.lax.scan(step, data, length=STEPS)[0].qpos

        return jax.vmap(one)(place, speed)

    took = _best(lambda: fly(place, speed).block_until_ready())
    return {"steps/s": worlds * STEPS / took, "worlds": worlds, "integrator": integrator}


def crazyflow_flights(worlds: int, look: int) -> dict[str, Any]:
    """Flights of 6 s a second: hover, then 1 m ahead."""
    sys.path.insert(0, str(Path(__file__).parent / "rivals" / "programs"))
    import crazyflow_flights as program

    task = {"start": [0.0, 0.0, 1.0], "target": [1.0, 0.0, 1.0], "duration": 6.0, "step_at": 1.0}
    places = [(0.0, 0.0)] * worlds
    job: Any = ({"task": task, "look": look}, places)
    took = _best(lambda: program.fly(job))
    return {"flights/s": worlds / took, "worlds": worlds, "steps between looks": look}


def main() -> None:
    """Print one line a run; with words, those of which the name holds one of them."""
    runs: list[tuple[Callable[..., Any], tuple[Any, ...]]] = [
        (mjx_impacts, (8192, "implicitfast")),
        (mjx_impacts, (32_768, "implicitfast")),
        (mjx_impacts, (8192, "RK4")),
        (crazyflow_flights, (16_384, 0)),
        (crazyflow_flights, (131_072, 0)),
        (crazyflow_flights, (16_384, 5)),
    ]
    for run, given in runs:
        if sys.argv[1:] and not any(word in run.__name__ for word in sys.argv[1:]):
            continue
        try:
            answer = run(*given)
        except Exception as error:  # a rival's own trouble is no reason to stop
            traceback.print_exc(limit=2)
            answer = {"left out": f"{type(error).__name__}: {error}".partition("\n")[0]}
        print(json.dumps({"what": run.__name__, "given": given, **answer}), flush=True)


if __name__ == "__main__":
    main()
