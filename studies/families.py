"""Energy ledger and step errors of random impacts.

    python studies/families.py [--preset N] [--moderate N] [--extreme N] [--out DIR]

Random impacts on one wall, in three families: the preset robots and surfaces; moderate arms and
surfaces; extreme ones, with every law of force.  Each flies at the default steps and at an eighth
of them.  Writes ``families.csv`` and prints the tables in studies/README.md.
"""

from __future__ import annotations

import argparse
import contextlib
import math
from collections.abc import Callable, Iterator, Sequence
from itertools import groupby
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from springback.contact.cage import ArmTip, Ring
from springback.contact.library import SURFACES
from springback.contact.obstacles import Forces, Obstacle, Plane, World
from springback.contact.surfaces import (
    AnyExponent,
    Surface,
    ThreeHalves,
)
from springback.dynamics.air import Still
from springback.dynamics.motion import Free
from springback.errors import InputError
from springback.files import write_csv
from springback.kernels.vectors import Quat, Vec
from springback.scenario.checks import STABLE
from springback.scenario.model import RING_ROUNDING, settle_step
from springback.scenario.tables import SimulationSettings
from springback.simulation.flight import fly_many
from springback.simulation.measuring.measures import Outcome, measures_of, outcome_of
from springback.simulation.measuring.record import Model, Timing
from springback.vehicle.library import VEHICLES
from springback.vehicle.parameters import Vehicle
from springback.vehicle.state import State

DURATION, GRAVITY, FINER = 0.3, 9.81, 8
LIMITS = (1e-6, 1e-5, 1e-4, 1e-3, 1e-2)
#: Measures that are compared between steps, and how large a value counts as small.
COMPARED = {
    "restitution_at_separation": 1e-2, "contact_time": 1e-4, "peak_acceleration": 1.0,
    "peak_normal_force": 1.0, "peak_angular_rate": 0.1, "penetration": 1e-5, "arm_stroke": 1e-4,
    "travel": 1e-4,
}  # fmt: skip


class Draw(NamedTuple):
    """One random impact."""

    model: Model
    start: State


def timing_for(vehicle: Vehicle, share: float = 1.0) -> Timing:
    """The default steps of a scenario, or a share of them."""
    s = SimulationSettings(duration=DURATION)
    return Timing(
        until=DURATION, free_step=s.free_step * share, impact_step=s.impact_step * share,
        settle_step=settle_step(s, vehicle) * share, arm_tolerance=s.arm_tolerance,
        rate_tolerance=s.rate_tolerance, dwell=s.dwell, hybrid=1.0,
    )  # fmt: skip


def unit(chance: np.random.Generator, count: int = 3) -> Any:
    """A random direction."""
    v = chance.normal(size=count)
    return v / np.linalg.norm(v)


def in_front(
    chance: np.random.Generator, vehicle: Vehicle, speeds: tuple[float, float], spin: float
) -> tuple[Plane, State]:
    """A vehicle of any attitude that flies at a wall of any direction, and that wall."""
    arms = range(vehicle.arm_count)
    reach = max(vehicle.arms.at("length", j) + vehicle.arms.at("cage_radius", j) for j in arms)
    normal, across = unit(chance), unit(chance)
    across -= (across @ normal) * normal
    speed = chance.uniform(*speeds)
    velocity = -speed * normal + chance.uniform(0.0, 1.0) * speed * across
    state = State(
        Vec(0.0, 0.0, 0.0), Quat(*map(float, unit(chance, 4))), Vec(*map(float, velocity)),
        Vec(*map(float, spin * chance.normal(size=3))), vehicle.lengths(),
        (0.0,) * vehicle.arm_count,
    )  # fmt: skip
    gap = 1.02 * reach + 0.01 * speed
    return Plane(Vec(*map(float, normal)), -gap), state


def drawn(
    chance: np.random.Generator, vehicle: Vehicle, surface: Surface, point: Any,
    speeds: tuple[float, float], spin: float, step: float = 1.0,
) -> Draw:  # fmt: skip
    """One flight from its parts."""
    wall, start = in_front(chance, vehicle, speeds, spin)
    world = World((Obstacle(wall, surface, 0.0),), Forces(0.0), GRAVITY)
    hover = vehicle.mass * GRAVITY / vehicle.arm_count if chance.random() < 0.5 else 0.0
    thrust = (hover,) * vehicle.arm_count
    timing = timing_for(vehicle, step)
    return Draw(
        Model(vehicle.airframe(), world, point, Free(0.0), Still(0.0), thrust, timing), start
    )


def _axes(chance: np.random.Generator) -> float:
    return 0.0 if chance.random() < 0.5 else 1.0


def _point(chance: np.random.Generator) -> Ring | ArmTip:
    return Ring(RING_ROUNDING) if chance.random() < 0.5 else ArmTip(0.0)


def preset(chance: np.random.Generator) -> Draw:
    """ARQ or Quad against wall or mat, 0.5 to 5 m/s, any attitude, some spin; stops or none."""
    vehicle = VEHICLES[("arq", "quad")[chance.integers(2)]].vehicle
    stops = bool(chance.integers(2))
    vehicle = vehicle.model_copy(
        update={"arms": vehicle.arms.model_copy(update={"end_stops": stops})}
    )
    surface = SURFACES[("wall", "mat")[chance.integers(2)]].surface(ThreeHalves)
    surface = surface._replace(vertical=_axes(chance))
    return drawn(chance, vehicle, surface, _point(chance), (0.5, 5.0), 3.0)


def _log(chance: np.random.Generator, low: float, high: float) -> float:
    return float(math.exp(chance.uniform(math.log(low), math.log(high))))


def moderate(chance: np.random.Generator) -> Draw:
    """ARQ with other arms (20 to 150 g) on other surfaces of exponent 3/2, 0.5 to 6 m/s."""
    arq = VEHICLES["arq"].vehicle
    arms = {
        "mass": chance.uniform(0.02, 0.15), "stiffness": _log(chance, 1e3, 3e4),
        "damping": _log(chance, 5.0, 150.0),
    }  # fmt: skip
    vehicle = arq.model_copy(update={"arms": arq.arms.model_copy(update=arms)})
    surface = Surface(
        _log(chance, 3e4, 3e5), 1.5 * chance.uniform(0.0, 0.6), 0.0, ThreeHalves(1.5),
        chance.uniform(0.0, 1.0), _axes(chance), 0.03, -1.0,
    )  # fmt: skip
    return drawn(chance, vehicle, surface, _point(chance), (0.5, 6.0), 3.0)


def extreme(chance: np.random.Generator) -> Draw:
    """What no one would build: 15 m/s, 50 rad/s, arms of a gram, surfaces of 10 to 1e7 N/m^n."""
    arq = VEHICLES["arq"].vehicle
    arms = {
        "mass": _log(chance, 1e-3, 0.5), "stiffness": _log(chance, 10.0, 1e7),
        "damping": chance.choice([0.0, _log(chance, 0.1, 1e4)]),
        "cage_radius": _log(chance, 0.01, 0.5), "end_stops": bool(chance.integers(2)),
    }  # fmt: skip
    vehicle = arq.model_copy(update={"arms": arq.arms.model_copy(update=arms)})
    law, n = chance.integers(3), float(chance.choice([1.0, 1.5, 2.0, 3.0]))
    viscosity = _log(chance, 0.1, 1e3) if law == 2 else 0.0
    exponent = 1.0 if law == 2 else n
    surface = Surface(
        _log(chance, 10.0, 1e7), _log(chance, 0.01, 10.0) if law == 0 else 0.0, viscosity,
        AnyExponent(exponent), chance.uniform(0.0, 3.0), 0.0, 0.03, -1.0,
    )  # fmt: skip
    finest = 0.98 * STABLE / max(vehicle.fastest_arm_rate(), 1.0)
    default = max(timing_for(vehicle)[2:4])
    point = Ring(RING_ROUNDING)
    return drawn(chance, vehicle, surface, point, (0.5, 15.0), 20.0, min(1.0, finest / default))


class Found(NamedTuple):
    """What came of a flight."""

    outcome: Outcome
    measures: dict[str, float | None]


def finer(draw: Draw) -> Draw:
    """The same flight at an eighth of the steps."""
    t = draw.model.timing
    steps = {n: getattr(t, n) / FINER for n in ("free_step", "impact_step", "settle_step")}
    return draw._replace(model=draw.model._replace(timing=t._replace(**steps)))


def _kind(draw: Draw) -> str:
    """Properties that the flights of a batch must share."""
    m = draw.model
    surface = m.world.obstacles[0].surface
    return f"{type(m.contact_point).__name__} {surface.vertical}"


def flown(draws: Sequence[Draw], threads: int | None = None) -> list[Found]:
    """All flights, in lanes."""
    numbers = sorted(range(len(draws)), key=lambda k: _kind(draws[k]))
    found: dict[int, Found] = {}
    for _, some in groupby(numbers, key=lambda k: _kind(draws[k])):
        mine = list(some)
        models, starts = [draws[k].model for k in mine], [draws[k].start for k in mine]
        for k, one in zip(mine, fly_many(models, starts, threads=threads), strict=True):
            found[k] = Found(outcome_of(one.record), measures_of(one))
    return [found[k] for k in range(len(draws))]


def family(build: Callable[[np.random.Generator], Draw], count: int, seed: int) -> list[Draw]:
    """So many draws; some fewer where settings refuse vehicles that cannot be."""
    chance = np.random.default_rng(seed)
    draws = []
    for _ in range(count):
        with contextlib.suppress(InputError):
            draws.append(build(chance))
    return draws


def residuals(found: Sequence[Found]) -> Any:
    """|ledger residual| of every flight; infinite where it diverged, shape (flights,)."""
    values = [
        math.inf if f.outcome is Outcome.NOT_FINITE else abs(f.measures["ledger_residual"] or 0.0)
        for f in found
    ]
    return np.array(values)


def differences(coarse: Sequence[Found], fine: Sequence[Found]) -> dict[str, Any]:
    """Relative difference of every compared measure, flight by flight; 0 where neither happened."""
    differ: dict[str, Any] = {}
    for name, small in COMPARED.items():
        pairs = [(a.measures[name], b.measures[name]) for a, b in zip(coarse, fine, strict=True)]
        differ[name] = np.array([_differ(a, b, small) for a, b in pairs])
    return differ


def _differ(a: float | None, b: float | None, small: float) -> float:
    if a is None or b is None:
        return 0.0 if a is b else math.inf
    return abs(a - b) / max(abs(b), small)


def report(name: str, coarse: Sequence[Found], fine: Sequence[Found] | None) -> Iterator[str]:
    """Lines of the tables."""
    off = residuals(coarse)
    steps = np.array([f.measures["steps"] for f in coarse])
    shares = " | ".join(f"{np.mean(off > limit):.2%}" for limit in LIMITS)
    diverged = sum(f.outcome is Outcome.NOT_FINITE for f in coarse)
    yield f"| {name} | {len(off)} | {shares} | {diverged} | {off.max():.1e} | {steps.mean():.0f} |"
    if fine is not None:
        off = residuals(fine)
        shares = " | ".join(f"{np.mean(off > limit):.2%}" for limit in LIMITS)
        yield f"| {name}, step/8 | {len(off)} | {shares} | | {off.max():.1e} | |"
        for measure, differ in differences(coarse, fine).items():
            yield (
                f"    {measure}: {np.mean(differ > 1e-3):.2%} beyond 0.1 %, "
                f"{np.mean(differ > 1e-2):.2%} beyond 1 %, worst {differ.max():.1e}"
            )


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    for name, count in (("preset", 3000), ("moderate", 2000), ("extreme", 10_000)):
        parser.add_argument(f"--{name}", type=int, default=count)
    parser.add_argument("--out", type=Path, default=Path("out/families"))
    given = parser.parse_args(arguments)
    given.out.mkdir(parents=True, exist_ok=True)
    makers = {"preset": preset, "moderate": moderate, "extreme": extreme}
    rows: list[dict[str, Any]] = []
    for name, build in makers.items():
        count = getattr(given, name)
        if count:
            draws = family(build, count, 7)
            coarse = flown(draws)
            fine = flown([finer(d) for d in draws]) if build is not extreme else None
            print(f"{name}: {count - len(draws)} of {count} refused by the settings")
            print(*report(name, coarse, fine), sep="\n", flush=True)
            for k, one in enumerate(coarse):
                rows.append(
                    {"family": name, "draw": k, "outcome": one.outcome.word, **one.measures}
                )
    write_csv(given.out / "families.csv", rows)


if __name__ == "__main__":
    main()
