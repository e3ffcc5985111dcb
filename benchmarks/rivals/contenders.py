"""The contenders, their options, and what could not be made equal."""

from __future__ import annotations

from typing import Any, NamedTuple

from benchmarks.rivals import impacts
from benchmarks.rivals.vehicle import quad

#: What everybody flies with a pilot: hover, then a set-point 1 m ahead.
STEP = {"start": [0.0, 0.0, 1.0], "target": [1.0, 0.0, 1.0], "step_at": 1.0, "duration": 6.0}
#: The end of a step may miss its target by so much and still count as flown [m].
MISS = 0.15

Try = tuple[int, int]
"""Processes side by side, and flights of all together."""


class Contender(NamedTuple):
    """A program in one of the ways it can be used."""

    name: str
    kind: str
    """``flight``, ``collision`` or ``impact``."""
    program: str
    environment: str
    """Name of its recipe; ours where empty."""
    tries: tuple[Try, ...]
    """The fastest of them counts, and is found before the rounds."""
    options: dict[str, Any]
    rates: str
    """Of its loop."""
    differs: str
    """What could not be made the same as for springback, or what it does besides."""


def _tries(flights: tuple[int, ...], threads: int) -> tuple[Try, ...]:
    """All numbers of flights in one process, and the same in a process on each core."""
    return tuple((p, p * n) for n in flights for p in sorted({1, threads}))


def _ours(threads: int) -> list[Contender]:
    sensing = "1 kHz all; rates, delays and noise of sensors as configured"
    made = []
    for kind, what in (("collision", "run-up, impact, recovery"), ("flight", "step")):
        for estimator in ("complementary", "kalman"):
            made.append(
                Contender(
                    name=f"springback, {what}, {estimator}",
                    kind=kind,
                    program="springback_flights",
                    environment="",
                    tries=_tries((512,), threads),
                    options={"estimator": estimator, "task": STEP},
                    rates=sensing,
                    differs="sensors with delay and noise, an estimator, and contact looked for at "
                    "every step; its time includes checking tables, setting up and reading out",
                )
            )
    return made


def _rotorpy(threads: int) -> list[Contender]:
    options = {"vehicle": quad(), "task": STEP}
    made = [
        Contender(
            name=f"RotorPy, one by one, {rate} Hz",
            kind="flight",
            program="rotorpy_flights",
            environment="rotorpy",
            tries=((threads, flights),),
            options={**options, "rate": rate},
            rates=f"{rate} Hz all" + (", its default" if rate == 100 else ""),
            differs="mass, inertia, rotors and lag as ours; measures, but its controller takes the "
            "truth; no ground; double precision",
        )
        for rate, flights in ((100, 4 * threads), (1000, threads))
    ]
    made += [
        Contender(
            name=f"RotorPy, batches, {integrator}",
            kind="flight",
            program="rotorpy_batches",
            environment="rotorpy",
            tries=_tries(flights, threads),
            options={**options, "rate": 100, "integrator": integrator},
            rates="100 Hz all",
            differs="mass, inertia, rotors and lag as ours; inertial unit only, the controller "
            "takes the truth; no ground, collision check off; double precision (PyTorch)",
        )
        for integrator, flights in (("rk4", (256, 1024)), ("dopri5", (256,)))
    ]
    return made


def _crazyflow(threads: int) -> list[Contender]:
    looks = {0: "floor only", 5: "contact flags at 100 Hz", 1: "contact flags at 500 Hz"}
    return [
        Contender(
            name=f"Crazyflow, {what}",
            kind="flight",
            program="crazyflow_flights",
            environment="crazyflow",
            tries=_tries((64, 1024, 4096), threads),
            options={"look": look, "task": STEP},
            rates="dynamics and attitude 500 Hz, position 100 Hz, its defaults",
            differs="its own Crazyflie and gains, explicit Euler, no sensors, the controller takes "
            "the truth; contact has no effect beyond clipping at the floor; single precision",
        )
        for look, what in looks.items()
    ]


def _pybullet(threads: int) -> list[Contender]:
    return [
        Contender(
            name="gym-pybullet-drones",
            kind="flight",
            program="pybullet_flights",
            environment="gym-pybullet-drones",
            tries=((threads, 8 * threads),),
            options={"rate": 48, "physics_rate": 240, "task": STEP},
            rates="physics 240 Hz, control 48 Hz, those of its examples",
            differs="its own Crazyflie and gains, no rotor lag, no sensors; Bullet's contact with "
            "the ground",
        )
    ]


def free_flight(threads: int) -> list[Contender]:
    """Everybody who flies with a pilot."""
    return [*_ours(threads), *_rotorpy(threads), *_crazyflow(threads), *_pybullet(threads)]


def our_impact(name: str, step: float) -> Contender:
    """Springback's impacts at a step [s]."""
    return Contender(
        name=f"springback, impact, {name}",
        kind="impact",
        program="springback_impacts",
        environment="",
        tries=tuple((1, n) for n in (256, 1024, 4096)),
        options={"step": step},
        rates=f"impact step {1e3 * step:g} ms, free flight {1e3 * impacts.FREE_STEP:g} ms",
        differs="energy ledger and all measures included; arms locked in free flight",
    )


def their_impact(integrator: str, step: float) -> Contender:
    """MuJoCo's impacts at a step [s]."""
    tries = tuple((1, n) for n in (64, 256))
    return Contender(
        name=f"MuJoCo rollout, {integrator}",
        kind="impact",
        program="mujoco_impacts",
        environment="mujoco",
        tries=tries,
        options={
            "document": impacts.document(integrator, step, False),
            "rows": impacts.rows(impacts.hits(max(n for _, n in tries))),
            "thrust": impacts.thrust(),
            "horizon": impacts.HORIZON,
        },
        rates=f"step {1e3 * step:g} ms",
        differs="its own contact law with constants fitted to ours; no measures, no energies; "
        "trajectories kept, as a rollout always does",
    )


def judging(integrator: str | None) -> Contender:
    """A program that judges its accuracy step by step: springback's, or MuJoCo's integrator."""
    if integrator is None:
        options: dict[str, Any] = {"steps": impacts.OUR_STEPS, "limit": impacts.OUR_LIMIT}
        options |= {"judge": True, "hits": impacts.JUDGED}
        return our_impact("accuracy", impacts.DEFAULT_STEP)._replace(options=options, tries=())
    steps = impacts.THEIR_STEPS
    options = {
        "judge": True,
        "rows": impacts.rows(impacts.hits(impacts.JUDGED)),
        "thrust": impacts.thrust(),
        "horizon": impacts.HORIZON,
        "limit": impacts.document(impacts.LIMITING, impacts.THEIR_LIMIT, True),
        "documents": [(step, impacts.document(integrator, step, True)) for step in steps],
    }
    return their_impact(integrator, impacts.DEFAULT_STEP)._replace(options=options, tries=())
