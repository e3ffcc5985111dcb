"""Two vehicles in MuJoCo that strike each other, with the contact between both applied by formula.

Cages of the first are rings, those of the second discs as high as `HEIGHT` with edges of `EDGE`;
main bodies are spheres.  Geometry and law are those of `oracles.solid_loads`; the opposite force acts
on the second vehicle at the same place.  MuJoCo integrates both multibody systems.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from oracles.loads import Flight, Loads, loads
from oracles.models import Placed, Scene, Solid, Start
from oracles.mujoco_flight import Vehicle, slope_of, state_at, unknowns
from oracles.solid_loads import Part, solid_force
from springback.contact.parameters import SurfaceSettings
from springback.contact.shapes import Ball, Pole

Array = NDArray[np.float64]

#: Height of a cage of the second vehicle as a disc, and radius of its edges, as the docs say [m].
HEIGHT, EDGE = 0.04, 0.012


class Side(NamedTuple):
    """One of two vehicles at an instant."""

    scene: Scene
    now: Start

    def parts(self) -> list[Part]:
        """Its cages as rings, then its main body as a sphere if that can be struck."""
        craft, now, r = self.scene.craft, self.now, self.now.rotation
        omega, found = r @ now.omega, []
        for arm, length, rate in zip(craft.arms, now.lengths, now.rates, strict=True):
            e = r @ np.array([math.cos(arm.azimuth), math.sin(arm.azimuth), 0.0])
            velocity = now.velocity + rate * e + np.cross(omega, length * e)
            end = now.position + length * e
            found.append(Part(end, velocity, omega, r, e, arm.cage_radius, "ring"))
        if craft.hull is not None:
            lever = r @ craft.hull.centre
            velocity = now.velocity + np.cross(omega, lever)
            centre = now.position + lever
            found.append(
                Part(centre, velocity, omega, r, r[:, 0], craft.hull.radius, "sphere")
            )  # fmt: skip
        return found


def solids_of(scene: Scene, surface: SurfaceSettings) -> list[Solid]:
    """What the parts of the second vehicle are, each in its own axes, in the order of `Side.parts`."""
    none, low = (0.0, 0.0, 0.0), (0.0, 0.0, -0.5 * HEIGHT)
    found = [
        Solid(Pole(type="pole", position=low, radius=arm.cage_radius, height=HEIGHT,
                   edge_radius=EDGE, surface=surface))
        for arm in scene.craft.arms
    ]  # fmt: skip
    if scene.craft.hull is not None:
        radius = scene.craft.hull.radius
        found.append(Solid(Ball(type="sphere", position=none, radius=radius, surface=surface)))
    return found


def _add(acting: Loads, which: int, force: Array, moment: Array, lever: Array) -> None:
    """Add a push on one part, about its own centre; that is ``lever`` from where loads act."""
    if which < len(acting.force):
        acting.force[which] += force
        acting.moment[which] += moment
        return
    acting.body_force[:] += force
    acting.body_moment[:] += moment + np.cross(lever, force)


def loads_of_both(first: Side, second: Side, solids: list[Solid]) -> tuple[Loads, Loads]:
    """All loads on both vehicles."""
    ours, theirs = loads(first.scene, first.now), loads(second.scene, second.now)
    for i, part in enumerate(first.parts()):
        for j, (solid, other) in enumerate(zip(solids, second.parts(), strict=True)):
            if np.linalg.norm(part.centre - other.centre) > part.radius + other.radius + 0.01:
                continue
            at = Placed(other.centre, other.turn, other.velocity, other.omega)
            force, moment = solid_force(solid, at, part)
            _add(ours, i, force, moment, part.centre - first.now.position)
            turning = moment + np.cross(part.centre - other.centre, force)
            _add(theirs, j, -force, -turning, other.centre - second.now.position)
    return ours, theirs


def fly_both(
    scenes: tuple[Scene, Scene],
    starts: tuple[Start, Start],
    surface: SurfaceSettings,
    *,
    until: float,
    step: float,
) -> tuple[Flight, Flight]:
    """Two flights at equal steps.

    Args:
        scenes: Vehicles, thrusts and gravity.
        starts: States at time 0.
        surface: Of the contact between both.
        until: Duration [s]; a whole number of steps.
        step: Of the Runge-Kutta method [s].
    """
    vehicles = [Vehicle(scene.craft, scene.gravity) for scene in scenes]
    solids = solids_of(scenes[1], surface)

    def slopes(both: list[Array]) -> list[Array]:
        sides = [Side(scene, state_at(x)) for scene, x in zip(scenes, both, strict=True)]
        acting = loads_of_both(sides[0], sides[1], solids)
        return [
            slope_of(side.now, vehicle.accelerations_under(load, side.now))
            for vehicle, load, side in zip(vehicles, acting, sides, strict=True)
        ]

    def ahead(both: list[Array], rates: list[Array], time: float) -> list[Array]:
        return [x + time * rate for x, rate in zip(both, rates, strict=True)]

    def acceleration(rates: list[Array]) -> Array:
        return np.array([np.linalg.norm(rate[7:10]) for rate in rates])

    both, peaks = [unknowns(start) for start in starts], np.zeros(2)
    for _ in range(round(until / step)):
        k1 = slopes(both)
        k2 = slopes(ahead(both, k1, 0.5 * step))
        k3 = slopes(ahead(both, k2, 0.5 * step))
        k4 = slopes(ahead(both, k3, step))
        peaks = np.maximum(peaks, acceleration(k1))
        mean = [
            (a + 2.0 * b + 2.0 * c + d) / 6.0 for a, b, c, d in zip(k1, k2, k3, k4, strict=True)
        ]
        both = ahead(both, mean, step)
        for x in both:
            x[3:7] /= np.linalg.norm(x[3:7])
    peaks = np.maximum(peaks, acceleration(slopes(both)))
    ends = [Flight(state_at(x), float(peak)) for x, peak in zip(both, peaks, strict=True)]
    return ends[0], ends[1]
