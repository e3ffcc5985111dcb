"""Crazyflow (JAX, on its default device), worlds in batches, flying the given step.

Its own drone, dynamics from first principles, its own controllers for state, attitude and torque,
default rates and integrator, single precision.  A flight is scanned within compiled code, and so
are the looks for contact with floor and wall, which are asked for through MJX as `Sim.contacts`
does; what is found has no effect on the motion there.
"""

from __future__ import annotations

import contextlib
import functools
import io
from collections.abc import Callable
from typing import Any

import protocol


@functools.lru_cache(maxsize=4)
def made(count: int, look: int) -> tuple[Any, Callable[..., Any], Callable[..., Any]]:
    """Worlds at their start, a compiled second of flight, and a function that sets the target.

    Args:
        count: Worlds.
        look: Physics steps between looks for contact; 0 for none.
    """
    with contextlib.redirect_stdout(io.StringIO()):
        import crazyflow.sim.functional as functional
        import crazyflow.sim.sim as parts
        import jax
        import jax.numpy as jnp
        import mujoco
        from crazyflow.control import Control
        from crazyflow.sim import Sim

    sim = Sim(n_worlds=count, control=Control.state, device=jax.default_backend())
    wall = sim.spec.worldbody.add_geom()
    wall.name, wall.type = "wall", mujoco.mjtGeom.mjGEOM_BOX
    wall.size, wall.pos = [0.1, 5.0, 5.0], [2.85, 0.0, 0.0]
    sim.build_mjx()
    step, scene, model = sim._step, sim.mjx_data, sim.mjx_model

    @jax.jit
    def second(data: Any, hit: Any) -> Any:
        if not look:
            return step(data, n_steps=sim.freq), hit

        def between_looks(carried: Any, _: None) -> Any:
            data, hit = carried
            data = step(data, n_steps=look)
            data, seen = parts.sync_sim2mjx(data, scene, model)
            return (data, hit | (seen._impl.contact.dist < 0.0).any(-1)), None

        return jax.lax.scan(between_looks, (data, hit), length=sim.freq // look)[0]

    def aim(data: Any, place: list[float]) -> Any:
        command = jnp.zeros((count, 1, 16)).at[..., :3].set(jnp.array(place)).at[..., 12].set(1.0)
        return functional.state_control(data, command)

    return sim.data, second, aim


def fly(asked: tuple[dict[str, Any], list[tuple[float, float]]]) -> float:
    """A batch of flights; how far from its target the worst one ends [m]."""
    import numpy as np

    job, places = asked
    task, count = job["task"], len(places)
    blank, second, aim = made(count, job["look"])
    import jax.numpy as jnp

    start = jnp.array(task["start"]) + jnp.array([[*p, 0.0] for p in places])
    states = blank.states.replace(pos=start.reshape(count, 1, 3))
    data, hit = blank.replace(states=states), jnp.zeros(count, bool)
    for k in range(round(task["duration"])):  # set-points change at whole seconds here
        data, hit = second(
            aim(data, task["target"] if k >= task["step_at"] else task["start"]), hit
        )
    end = np.asarray(data.states.pos).reshape(count, 3)
    return float(np.linalg.norm(end - np.array(task["target"]), axis=-1).max())


def main() -> None:
    job = protocol.job()
    with contextlib.redirect_stdout(io.StringIO()):
        import crazyflow.sim  # noqa: F401

    imported = protocol.since(job)
    alone: Any = (job, protocol.scatter(1))
    fly(alone)
    first = protocol.since(job)
    latency = protocol.repeated(lambda: fly(alone))
    many, missed = protocol.many(job, fly)
    protocol.answer(
        versions=protocol.versions("crazyflow", "jax", "mujoco-mjx"), imported=imported,
        first=first, latency=latency, many=many, missed=missed,
        memory=protocol.peak_memory(job["threads"] if job["tries"][0][0] > 1 else 0),
    )  # fmt: skip


if __name__ == "__main__":
    main()
