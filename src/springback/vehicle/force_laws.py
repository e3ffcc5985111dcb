"""Force laws that remember the deepest depth: user input shared by surfaces and hulls.

`constant-restitution` presses in by a power law and comes out along a steeper one; `foam` yields at
a plateau until it is pressed together; `table` is what a user has measured.  All return a fixed
share of the energy, e² of a restitution e, at any speed (`springback.contact.laws.hysteresis`).
"""

from __future__ import annotations

from itertools import pairwise
from typing import Annotated, Any, Literal, get_args

from pydantic import BeforeValidator, model_validator

from springback.errors import shown_value
from springback.quantities import Factor, Length, Unit, number_in
from springback.settings import Settings, naming, problem
from springback.vehicle.force_curves import Points, force_table

#: Laws with a memory.
REMEMBERING = ("constant-restitution", "foam", "table")
#: Least restitution of a law with a memory (chosen: below it what comes out is a hundred times as
#: stiff as what goes in, and steps as short).
LEAST_RESTITUTION = 0.1
#: Most points of a table (chosen).
MOST_POINTS = 64
#: Share of a foam's parts over which their corners are rounded (chosen).
CORNER = 0.1
#: Numbers of a hull's surface: k^(−1/n), 1.5 c_a, b, μ and v_s, the last two −1 if it is the
#: obstacle's; n; s of φ = wˢ, the address of a force curve, 1 if what is pressed in stays so, and 1
#: if it meets everything by this law alone.
HULL_SURFACE, HULL_CURVE = 10, 7
#: Numbers of a hull without a surface of its own.
RIGID = [0.0, 0.0, 0.0, -1.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0]


def _points(value: Any) -> Any:
    """Pairs of a depth and a force, as numbers."""
    if value is None:
        return None
    if not isinstance(value, list | tuple) or not 2 <= len(value) <= MOST_POINTS:
        raise problem(
            f"must be 2 to {MOST_POINTS} pairs of a depth in m and a force in N "
            f"(got {shown_value(value)})"
        )
    depths, forces, found = Unit("m", least=0.0), Unit("N", least=0.0), []
    for k, pair in enumerate(value):
        with naming(f"[{k}]"):
            if not isinstance(pair, list | tuple) or len(pair) != 2:
                raise problem(f"must be a depth in m and a force in N (got {shown_value(pair)})")
            found.append((depths.read(pair[0]), forces.read(pair[1])))
    for k, ((before, _), (after, _)) in enumerate(pairwise(found)):
        if not after > before:
            raise problem(f"must be deeper than {before:g} m, the one before it (got {after:g} m)",
                          f"[{k + 1}]")  # fmt: skip
    return tuple(found)


ForcePoints = Annotated[tuple[tuple[float, float], ...], BeforeValidator(_points)]
Force = Annotated[float, Unit("N", above=0.0)]


class HystereticSettings(Settings):
    """Keys of the laws that remember the deepest depth."""

    plateau_force: Force | None = None
    """Foam: force at which it begins to yield."""
    plateau_stiffness: Annotated[float, Unit("N/m", least=0.0)] | None = None
    """Foam: stiffness while it yields; by default a hundredth of `stiffness`."""
    densification_depth: Length | None = None
    """Foam: depth from which it densifies."""
    densification_stiffness: Annotated[float, Unit("N/m", above=0.0)] | None = None
    """Foam: stiffness beyond that depth; by default ten times `stiffness`."""
    loading: ForcePoints | None = None
    """Table: depths and forces going in, from (0, 0)."""
    unloading: ForcePoints | None = None
    """Table: depths and forces coming out, from force 0 to the last point of `loading`; without
    them the way out follows `restitution`, or is elastic."""
    recovers: bool = True
    """False: what a part of a vehicle has pressed in stays so in later contacts of that part."""

    @model_validator(mode="before")
    @classmethod
    def _stiffness_with_unit(cls, given: Any) -> Any:
        """A stiffness given as text, in N/mⁿ of the law's exponent n."""
        text = given.get("stiffness") if isinstance(given, dict) else None
        if not isinstance(text, str):
            return given
        laws = cls.model_fields["law"]
        if given.get("law", laws.default) not in get_args(laws.annotation):
            return {key: value for key, value in given.items() if key != "stiffness"}  # no unit
        linear = given.get("law") in ("kelvin-voigt", "foam")
        n = 1.0 if linear else given.get("exponent", cls.model_fields["exponent"].default)
        unit = f"N/m^{n:g}" if isinstance(n, int | float) and n != 1.0 else "N/m"
        with naming("stiffness"):
            return given | {"stiffness": number_in(text, unit, bare=True)}

    def check_memory(self, law: str, restitution: float | None) -> None:
        """Reject keys of another law, and those that are missing.

        Raises:
            The problem.
        """
        own = {
            "foam": ("plateau_force", "plateau_stiffness", "densification_depth",
                     "densification_stiffness"),
            "table": ("loading", "unloading"),
        }  # fmt: skip
        for name, keys in own.items():
            for key in keys:
                if law != name and getattr(self, key) is not None:
                    raise problem(f"needs law {name} (got law {law})", key)
        if law not in REMEMBERING:
            if not self.recovers:
                raise problem(f"needs law {' or '.join(REMEMBERING)} (got law {law})", "recovers")
            return
        needed = {"foam": ("plateau_force", "densification_depth"), "table": ("loading",)}
        for key in needed.get(law, ()):
            if getattr(self, key) is None:
                raise problem(f"is missing; law {law} needs it", key)
        if law == "table":
            self._check_table(restitution)
        elif restitution is None:
            raise problem(f"is missing; law {law} needs it", "restitution")
        if restitution is not None and restitution < LEAST_RESTITUTION:
            raise problem(
                f"of law {law} must be at least {LEAST_RESTITUTION:g} (got {restitution:g})",
                "restitution",
            )

    def _check_table(self, restitution: float | None) -> None:
        assert self.loading is not None
        if self.loading[0] != (0.0, 0.0):
            depth, force = self.loading[0]
            raise problem(f"must be 0 m, 0 N (got {depth:g} m, {force:g} N)", "loading[0]")
        for k, (_, force) in enumerate(self.loading[1:], start=1):
            if not force > 0.0:
                raise problem("must have a force of more than 0 N", f"loading[{k}]")
        if self.unloading is None:
            return
        if restitution is not None:
            raise problem("cannot be combined with unloading; give only one", "restitution")
        (_, force), last = self.unloading[0], self.unloading[-1]
        if force != 0.0:
            raise problem(f"must have a force of 0 N (got {force:g} N)", "unloading[0]")
        if last != self.loading[-1]:
            depth, force = self.loading[-1]
            raise problem(
                f"must be {depth:g} m, {force:g} N, the last of loading "
                f"(got {last[0]:g} m, {last[1]:g} N)",
                f"unloading[{len(self.unloading) - 1}]",
            )
        for k, (depth, force) in enumerate(self.unloading):
            most = _on_lines(self.loading, depth)
            if force > most * (1.0 + 1e-9):
                raise problem(
                    f"must not be above loading, {most:g} N at {depth:g} m: it would return more "
                    f"than was put in (got {force:g} N)",
                    f"unloading[{k}]",
                )

    def curve(self, law: str, stiffness: float, shared_by: int = 1) -> float:
        """Address of the force curve of a law as a table; 0 for a power law.

        Args:
            law: Of the contact.
            stiffness: Of a foam before it yields [N/m].
            shared_by: Number of parts that share all forces.
        """
        if law == "foam":
            return force_table(_shared(self._foam(stiffness), shared_by))
        if law == "table" and self.loading is not None:
            out = None if self.unloading is None else _shared(self.unloading, shared_by)
            return force_table(_shared(self.loading, shared_by), out)
        return 0.0

    def _foam(self, stiffness: float) -> Points:
        """Points of three straight parts whose corners are rounded."""
        assert self.plateau_force is not None
        assert self.densification_depth is not None
        yields = self.plateau_force / stiffness
        if not yields < self.densification_depth:
            raise problem(
                f"must be more than {yields:g} m, where plateau_force is reached "
                f"(got {self.densification_depth:g} m)",
                "densification_depth",
            )
        flat = self.plateau_stiffness
        slope = 0.01 * stiffness if flat is None else flat
        steep = self.densification_stiffness or 10.0 * stiffness
        length = self.densification_depth - yields
        top = self.plateau_force + slope * length
        corner = CORNER * min(yields, length)
        away = (corner, 1.5 * corner)  # from both ends of each part, so that it is straight between
        rises = [0.0, *(yields - x for x in reversed(away))]
        flat_ends = [*(yields + x for x in away)]
        flat_ends += [self.densification_depth - x for x in reversed(away)]
        beyond = [*away, 3.0 * corner]
        return (
            *((x, stiffness * x) for x in rises),
            *((x, self.plateau_force + slope * (x - yields)) for x in flat_ends),
            *((self.densification_depth + x, top + steep * x) for x in beyond),
        )


def _shared(points: Points, by: int) -> Points:
    return tuple((depth, force / by) for depth, force in points)


def _on_lines(points: Points, depth: float) -> float:
    """Force at a depth on straight lines between points [N]."""
    for (x, low), (y, high) in pairwise(points):
        if depth <= y:
            return low + (high - low) * (depth - x) / (y - x)
    return points[-1][1]


def shape_of(law: str, restitution: float | None) -> float:
    """Exponent s of the energy's share in what comes out, 1/e² − 1; 0 for an elastic law."""
    if law not in REMEMBERING or restitution is None:
        return 0.0
    return 1.0 / (restitution * restitution) - 1.0


class HullSurface(HystereticSettings):
    """Surface of a hull: a spring and a damper in series with those of what it touches.

    Contact laws combine like springs in series: k^(−1/n) of both add up, for the same exponent n.
    A hull of law `foam` or `table`, or with ``in_series`` false, follows its own law alone in every
    contact, as if what it touches were rigid.
    """

    law: Literal["power", "constant-restitution", "foam", "table"] = "power"
    """`power` is k δⁿ; the others are those of an obstacle's surface."""
    stiffness: Annotated[float, Unit("", above=0.0)] | None = None
    """k [N/mⁿ] of the hull alone, against something rigid; or text such as ``"10 N/mm"`` if n is 1,
    or ``"200 kN/m^1.5"``."""
    restitution: Annotated[float, Unit("", above=0.0, most=1.0)] | None = None
    """Restitution of the laws that have the same at any speed."""
    exponent: Annotated[float, Unit("", least=0.4, most=4.0)] = 1.5
    """n; it must be that of the obstacles, or the springs cannot be combined."""
    in_series: bool = True
    """False: obstacles count as rigid, and may have any law, of which only friction is used."""
    dissipation: Annotated[float, Unit("s/m", least=0.0)] = 0.0
    """c_a in b_c = 1.5 c_a k, as for an obstacle's surface."""
    viscosity: Annotated[float, Unit("N s/m", least=0.0)] = 0.0
    """b of a damper beside a linear spring."""
    friction: Factor | None = None
    """μ; with the obstacle's it makes √(μ μ').  Without it, the obstacle's alone counts."""
    slip_speed: Annotated[float, Unit("m/s", above=0.0)] | None = None
    """Slip speed below which friction fades to zero; the larger one of both surfaces counts."""

    @model_validator(mode="after")
    def _has_a_law(self) -> HullSurface:
        if self.stiffness is None and self.law != "table":
            raise problem("is missing", "stiffness")
        if self.restitution is not None and self.law == "power":
            raise problem("needs law constant-restitution, foam or table", "restitution")
        self.check_memory(self.law, self.restitution)
        self._curve()
        return self

    @property
    def is_alone(self) -> bool:
        """True if it meets everything by this law alone."""
        return not self.in_series or self.law in ("foam", "table")

    def _curve(self) -> float:
        return self.curve(self.law, self.stiffness or 1.0)

    @model_validator(mode="after")
    def _is_linear(self) -> HullSurface:
        if self.viscosity > 0.0 and self.exponent != 1.0:
            raise problem(
                f"needs exponent = 1, a linear spring (got an exponent of {self.exponent:g})",
                "viscosity",
            )
        return self

    def numbers(self) -> list[float]:
        """Its numbers in a table."""
        n = self.exponent
        friction = -1.0 if self.friction is None else self.friction
        slip_speed = -1.0 if self.slip_speed is None else self.slip_speed
        compliance = 0.0 if self.stiffness is None else self.stiffness ** (-1.0 / n)
        return [
            compliance, 1.5 * self.dissipation, self.viscosity, friction, slip_speed, n,
            shape_of(self.law, self.restitution), self._curve(), 0.0 if self.recovers else 1.0,
            1.0 if self.is_alone else 0.0,
        ]  # fmt: skip
