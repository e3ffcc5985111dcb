"""Rotors that a vehicle lists: validated user input, converted to the numbers of the equations."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import BeforeValidator, model_validator

from springback.errors import shown_value
from springback.kernels.tracing import hypot, traceable  # for batch set-up
from springback.kernels.vectors import Mat3, Vec
from springback.quantities import Triple, Unit
from springback.settings import Settings, naming, problem
from springback.vehicle.arms.settings import Arms
from springback.vehicle.hulls import owner
from springback.vehicle.placed.rotors import PlacedRotor, PlacedRotors
from springback.vehicle.state import Propeller

#: Most rotors (chosen: to catch typing errors).
MOST_ROTORS = 32
#: Rotors are at most so far from what they are on, in reaches of cages and hulls (chosen: as
#: that).
FAR = 3.0
#: Rotors of springback's own pilots blow within 60° of body z (chosen: beyond, half of a thrust is
#: lost to lift, and least-norm shares hardly use it).
LIFTS = 0.5
#: Singular value of the pilots' matrix, of the largest, below which an axis cannot be commanded.
NO_RANK = 1e-6


class RotorSettings(Settings):
    """One rotor: on the main body, or at the end of an arm, with which it moves."""

    on: Annotated[str | int, BeforeValidator(owner)] = "body"
    """``body``, or the number of an arm, from 1."""
    position: Annotated[Triple, Unit("m")] | None = None
    """Position of the middle of its disc, body axes, from the centre of the main body or from the
    end of its arm, at rest; at the end of an arm it may be left out."""
    axis: Annotated[Triple, Unit("")] = (0.0, 0.0, 1.0)
    """Direction of its thrust, of any length, body axes while the arm is free."""
    spin: Literal[-1, 1] | None = None
    """Sign of its torque about that axis; alternating −, + in the order of the list by default."""
    torque_ratio: Annotated[float, Unit("m", least=0.0)] | None = None
    """c_τ; by default that of its arm, or that of arm 1 on the main body."""

    @model_validator(mode="after")
    def _has_place(self) -> RotorSettings:
        if self.position is None and self.on == "body":
            raise problem("is missing: it must be given for a rotor on the main body", "position")
        if not hypot(*self.axis) > 0.0:
            raise problem(
                "must not be zero: it is the direction of the thrust "
                f"(got {shown_value(list(self.axis))})",
                "axis",
            )
        return self

    def direction(self) -> Vec:
        """Unit vector of its thrust, in the axes of what it is on."""
        size = hypot(*self.axis)
        x, y, z = self.axis
        return Vec(x / size, y / size, z / size)

    def offset(self) -> Vec:
        """Its place from what it is on [m]."""
        return Vec(*(self.position or (0.0, 0.0, 0.0)))

    @property
    def lifts(self) -> bool:
        """True if springback's own pilots use it."""
        return bool(self.direction().z >= LIFTS)


def disc_axes(up: Vec) -> Mat3:
    """Axes of a disc across a unit vector, one a column; those of the body for body z."""
    x, y, z = up
    if z < -0.5:  # turn half about x first
        u = 1.0 / (1.0 - z)
        return Mat3(
            Vec(1.0 - u * x * x, u * x * y, x),
            Vec(-u * x * y, u * y * y - 1.0, y),
            Vec(x, -y, z),
        )
    u = 1.0 / (1.0 + z)
    return Mat3(
        Vec(1.0 - u * x * x, -u * x * y, x),
        Vec(-u * x * y, 1.0 - u * y * y, y),
        Vec(-x, -y, z),
    )


def check_rotors(rotors: Sequence[RotorSettings], arms: Arms, reach: float) -> None:
    """Reject rotors on arms that there are not, far away, or at one place.

    Args:
        rotors: The list.
        arms: Of the vehicle.
        reach: Distance of its farthest cage or hull from the centre of the main body [m].
    """
    if len(rotors) > MOST_ROTORS:
        raise problem(f"must name at most {MOST_ROTORS} rotors (got {len(rotors)})", "rotors")
    if arms.spin is not None:
        raise problem("cannot be combined with rotors, each of which has its own", "arms.spin")
    count = len(arms.directions)
    for k, one in enumerate(rotors):
        with naming(f"rotors[{k}]"):
            if one.on != "body" and int(one.on) > count:
                raise problem(f"must be body, or an arm from 1 to {count} (got {one.on})", "on")
            away = hypot(*one.offset())
            if away > FAR * reach:
                raise problem(
                    f"must be within {FAR * reach:g} m, {FAR:g} times the reach of the vehicle, of "
                    f"what it is on (got {away:.6g} m)",
                    "position",
                )
            for j, other in enumerate(rotors[:k]):
                same = (one.on, one.offset(), one.direction())
                if same == (other.on, other.offset(), other.direction()):
                    raise problem(f"is where rotors[{j}] is, and blows the same way", "position")


def placed_rotors(
    rotors: Sequence[RotorSettings], arms: Arms, disc: tuple[Propeller, ...]
) -> PlacedRotors | tuple[()]:
    """Numbers for the equations of motion; empty without a list.

    Args:
        rotors: The list.
        arms: Of the vehicle.
        disc: Of each rotor, if its size is known; its height is along the axis of the rotor.
    """
    if not rotors:
        return ()
    found, farthest = [], 0.0
    for k, one in enumerate(rotors):
        number = 0 if one.on == "body" else int(one.on)
        given = one.torque_ratio
        ratio = arms.at("torque_ratio", max(number - 1, 0)) if given is None else given
        spin = one.spin or (-1 if k % 2 == 0 else 1)
        found.append(
            PlacedRotor(
                float(number), one.offset(), disc_axes(one.direction()), spin * ratio,
                1.0 if one.lifts else 0.0, disc,
            )
        )  # fmt: skip
        away = hypot(*one.offset()) + sum(hypot(ring.radius, ring.height) for ring in disc)
        if number:
            end, travel = arms.end(number - 1), arms.travel(number - 1)
            away = away + hypot(*end) + max(abs(travel[0]), abs(travel[1]))
            away = away + arms.second_travel(number - 1)
        farthest = max(farthest, away)
    numbers = tuple(float(j + 1) for j in range(len(arms.directions)))
    return PlacedRotors(tuple(found), numbers, farthest)


def wrench_matrix(
    rotors: Sequence[RotorSettings], arms: Arms
) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Force and moment about the main body per thrust of each rotor, arms free.

    Returns:
        Shape (6, rotors), rows: force along body x, y, z [1], moment about them [m].
    """
    placed = placed_rotors(rotors, arms, ())
    columns = []
    for one in placed.each if placed else ():
        up = np.array([one.axes.x.z, one.axes.y.z, one.axes.z.z])
        end = np.array(arms.end(int(one.arm) - 1)) if one.arm else np.zeros(3)
        turn = np.cross(end + np.array(one.offset), up) + one.torque_ratio * up
        columns.append(np.concatenate([up, turn]))
    return np.array(columns).reshape(-1, 6).T


@traceable
def check_allocation(rotors: Sequence[RotorSettings], arms: Arms, least: float) -> None:
    """Reject rotors among which springback's own pilots cannot share lift and three moments.

    Args:
        rotors: The list; empty: nothing is checked.
        arms: Of the vehicle.
        least: Thrust that a rotor gives at least [N].
    """
    if not rotors:
        return
    lifting = [one.lifts for one in rotors]
    if least > 0.0 and not all(lifting):
        raise problem(
            f"must be 0 N with rotors that springback's pilots leave still, whose axes are more "
            f"than 60 deg from body z: vehicle.rotors[{lifting.index(False)}] (got {least:g} N)",
            "vehicle.propulsion.min_thrust",
        )
    b = wrench_matrix(rotors, arms)[2:] * np.array(lifting, dtype=float)
    reach = float(np.abs(b[1:]).max(initial=0.0)) or 1.0
    scaled = b / np.array([1.0, reach, reach, reach])[:, None]
    u, sizes, _ = np.linalg.svd(scaled)
    rank = int((sizes > NO_RANK * sizes[0]).sum()) if sizes.size and sizes[0] > 0.0 else 0
    if rank == 4:
        shares = np.linalg.pinv(scaled)[:, 0]
        for k in np.flatnonzero(np.array(lifting) & (shares <= NO_RANK)):
            raise problem(
                f"cannot be used by springback's pilots: to hover with the others it would have to "
                f"pull down, by {abs(shares[k]):.3g} of the weight",
                f"vehicle.rotors[{k}]",
            )
        return
    lacking = np.abs(u[:, rank:]).max(axis=1) if rank else np.ones(4)
    names = ["lift", "roll", "pitch", "yaw"]
    words = " or ".join(name for name, share in zip(names, lacking, strict=True) if share > 0.5)
    raise problem(
        f"must give lift, roll, pitch and yaw independently of each other, with a pilot: those "
        f"{sum(lifting)} whose axes are within {math.degrees(math.acos(LIFTS)):.0f} deg of body z "
        f"leave {words or 'one of them'} without command (rank {rank} of 4)",
        "vehicle.rotors",
    )
