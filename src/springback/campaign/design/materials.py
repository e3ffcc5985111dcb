"""Fields of a plan that are drawn from what is known: of a material, or of a guard made of it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any, Literal

from pydantic import Field, ValidationError
from pydantic_core import PydanticCustomError

from springback.errors import InputError, shown_value
from springback.problems import dotted_path, nearest_name, problem_paths
from springback.quantities import Length, Unit
from springback.settings import Settings, problem
from springback.vehicle.materials import MATERIALS, Material
from springback.vehicle.stiffness import (
    cantilever_stiffness,
    contact_modulus,
    hertz_stiffness,
    pad_stiffness,
    ring_stiffness,
    rod_second_moment,
    shell_stiffness,
)

#: Keys of a field that a range of its own goes without.
_BESIDE = ("field", "count", "step")
#: Keys of entries whose fields are drawn from what is known.
_KEYS = ("material", "guard")


class GuardSettings(Settings):
    """What meets an obstacle, made of one material: its stiffness is derived from its shape."""

    material: str
    """Name of a material whose modulus is known."""


class GuardOfRod(GuardSettings):
    """A guard that is made of a rod or tube."""

    rod: Length
    """Outer diameter of the rod."""
    inner: Annotated[float, Unit("m", least=0.0)] = 0.0
    """Inner diameter of a tube."""

    def section(self) -> float:
        """Second moment of area of its cross section [m⁴]."""
        return rod_second_moment(self.rod, self.inner)


class RingGuard(GuardOfRod):
    """A ring of a rod or tube, pressed across a diameter."""

    type: Literal["ring"]
    radius: Length
    """Radius of the ring, to the middle of the rod."""

    def of(self, young: float, poisson: float) -> float:
        """Stiffness for a modulus [Pa] and Poisson's ratio [N/m]."""
        return ring_stiffness(young, self.section(), self.radius)


class CantileverGuard(GuardOfRod):
    """A rod or tube that is clamped at one end and pressed at the other."""

    type: Literal["cantilever"]
    length: Length
    """Length from the clamp to the free end."""

    def of(self, young: float, poisson: float) -> float:
        """Stiffness for a modulus [Pa] and Poisson's ratio [N/m]."""
        return cantilever_stiffness(young, self.section(), self.length)


class ShellGuard(GuardSettings):
    """A thin spherical shell under a point load."""

    type: Literal["shell"]
    thickness: Length
    """Thickness of the shell; for a lattice, that of an equivalent shell."""
    radius: Length
    """Radius of the sphere."""

    def of(self, young: float, poisson: float) -> float:
        """Stiffness for a modulus [Pa] and Poisson's ratio [N/m]."""
        return shell_stiffness(young, poisson, self.thickness, self.radius)


class PadGuard(GuardSettings):
    """A pad that is pressed over its whole face."""

    type: Literal["pad"]
    area: Annotated[float, Unit("m^2", above=0.0)]
    """Area of the face."""
    thickness: Length
    """Thickness of the pad."""

    def of(self, young: float, poisson: float) -> float:
        """Stiffness for a modulus [Pa] and Poisson's ratio [N/m]."""
        return pad_stiffness(young, self.area, self.thickness)


class SphereGuard(GuardSettings):
    """A solid sphere, by Hertz."""

    type: Literal["sphere"]
    radius: Length
    """Radius of the sphere where it touches."""

    def of(self, young: float, poisson: float) -> float:
        """Stiffness for a modulus [Pa] and Poisson's ratio [N/m^1.5]."""
        return hertz_stiffness(contact_modulus(young, poisson), self.radius)


AnyGuard = Annotated[
    RingGuard | CantileverGuard | ShellGuard | PadGuard | SphereGuard, Field(discriminator="type")
]


class GuardField(Settings):
    """The key of a field of a plan that draws a guard's stiffness."""

    guard: AnyGuard
    """The guard."""


def ranges_of(given: Any) -> list[Any]:
    """Fields of a plan for one of its entries: of a material's surface, or a guard's, all of them.

    Args:
        given: The raw entry; any other is left as it is.

    Raises:
        The problem.
    """
    for key, ranges in zip(_KEYS, (_of_material, _of_guard), strict=True):
        if isinstance(given, dict) and key in given:
            return _drawn(given, key, ranges)
    return [given]


def written_fields(given: Any) -> list[tuple[int, str]]:
    """For each field of a raw plan after `ranges_of`: its entry's number, from 0, and its key.

    Args:
        given: The raw entries of ``vary``.

    Returns:
        The key is ``material`` or ``guard``, or empty for an entry with a range of its own; nothing
        if an entry is wrong.
    """
    found: list[tuple[int, str]] = []
    try:
        for k, one in enumerate(given if isinstance(given, list | tuple) else ()):
            key = next((key for key in _KEYS if isinstance(one, dict) and key in one), "")
            found += [(k, key)] * len(ranges_of(one))
    except PydanticCustomError:
        return []
    return found


def _drawn(given: dict[str, Any], key: str, ranges: Callable[[Any], list[Any]]) -> list[Any]:
    rest = {name: value for name, value in given.items() if name not in ("field", key)}
    field = given.get("field")
    if not isinstance(field, str) or field.rpartition(".")[2] not in ("surface", "backing"):
        raise problem(
            f"must be a surface, such as world.obstacles.0.surface (got {shown_value(field)})",
            "field",
        )
    if not rest.keys() <= set(_BESIDE):
        raise problem("has a range of its own; besides it only count and step", key)
    path = "world.obstacles.0.surface" if field == "surface" else field
    return [
        {"field": f"{path}.{what}", **span, **({} if "values" in span else rest)}
        for what, span in ranges(given[key])
    ]


def _of_material(name: Any) -> list[Any]:
    """Restitution and friction of a material."""
    known = _material(name)
    drawn = {"restitution": known.restitution, "friction": known.friction}
    return [
        (what, {
            "from": span.low, "to": span.high, "source": f"{what} of {name}, {span.source}",
        })
        for what, span in drawn.items() if span is not None
    ]  # fmt: skip


def _of_guard(table: Any) -> list[Any]:
    """Stiffness of a guard, between those of its material's moduli, and the exponent of its law."""
    try:
        guard = GuardField.model_validate({"guard": table}).guard
    except ValidationError as error:
        [(path, what), *_] = problem_paths(error)
        raise problem(what, dotted_path(path)) from None
    known, key = _material(guard.material, "guard.material"), "guard.material"
    if known.young is None:
        raise problem(f"must have a modulus, which is not known of {guard.material}", key)
    poisson = known.poisson
    if poisson is None and isinstance(guard, ShellGuard | SphereGuard):
        raise problem(f"must have a Poisson's ratio, which is not known of {guard.material}", key)
    try:
        low, high = (guard.of(young, poisson or 0.0) for young in known.young[:2])
    except InputError as error:
        raise problem(error.problems[0], "guard") from None
    words = f"stiffness of a {guard.type} of {guard.material}, derived; its modulus "
    span = {"from": low, "to": high, "source": words + known.young.source}
    return [("stiffness", span), ("exponent", {"values": [exponent_of(guard)]})]


def exponent_of(guard: AnyGuard) -> float:
    """Exponent of the contact of a guard: that of Hertz for a sphere, else 1."""
    return 1.5 if isinstance(guard, SphereGuard) else 1.0


def _material(name: Any, key: str = "material") -> Material:
    known = MATERIALS.get(name) if isinstance(name, str) else None
    if known is None:
        near = nearest_name(str(name), MATERIALS)
        hint = f"did you mean {near}?" if near else f"known: {', '.join(MATERIALS)}"
        raise problem(f"must be a material, {hint} (got {shown_value(name)})", key)
    return known
