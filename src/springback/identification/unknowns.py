"""Unknowns of a fit: fields of a scenario that are free or known to some uncertainty, and latents.

Inside, each is a number u with a standard normal prior: value = centre + deviation u, or of its
logarithm for what is known to a factor or a share.
"""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Mapping, Sequence
from typing import Any, Literal, NamedTuple

import numpy as np
from pydantic_core import PydanticCustomError

from springback.errors import InputError, shown_value
from springback.problems import key_path
from springback.quantities import number_in, si_number
from springback.scenario.fields import Parameter, Path, number_at, refuse_unread
from springback.scenario.overrides import apply_overrides, with_value
from springback.scenario.scenario import Scenario, scenario_from

Array = np.ndarray[Any, np.dtype[np.float64]]
Role = Literal["free", "known", "latent"]
#: Bounds of u: no posterior is beyond them unless the data contradict the prior (chosen).
FARTHEST = 6.0
#: Share of a normal distribution within two deviations: "factor 5" is ln 5 = two deviations.
TWO_DEVIATIONS = 2.0
#: Lists of numbers: directions of arms, and moments of inertia, as a matrix.
DIRECTIONS: Path = ("vehicle", "arms", "directions")
INERTIA: Path = ("vehicle", "body", "inertia")
_UNCERTAINTY = re.compile(r"^\s*(?P<centre>.*?)\s*(?:\+-|\+/-|±)\s*(?P<uncertainty>.+?)\s*$")
_FACTOR = re.compile(r"^\s*(?:(?P<centre>.*\S)\s+)?factor\s+(?P<factor>\S+)\s*$")


class Unknown(NamedTuple):
    """One unknown."""

    name: str
    """Path of a field, or what a latent is."""
    role: Role
    centre: float
    """Of the prior: a value, or its logarithm."""
    deviation: float
    """Of the prior."""
    logarithmic: bool
    unit: str
    """SI; empty for plain numbers."""
    uncertainty: str
    """The prior in words."""
    flies: bool = True
    """False if the motion does not depend on it, only what a sensor tells of it."""
    path: Path = ()
    of_device: bool = False
    """True for a latent that is the same in every impact, of a sensor."""

    @property
    def is_shared(self) -> bool:
        """True if it is one number of all impacts, and known to some uncertainty."""
        return self.role == "known" or self.of_device

    def value(self, u: Any) -> Any:
        """Value in SI, of a number u or an array."""
        there = self.centre + self.deviation * u
        return np.exp(there) if self.logarithmic else there

    def coordinate(self, value: float) -> float:
        """The number u of a value in SI."""
        there = math.log(value) if self.logarithmic else value
        return (there - self.centre) / self.deviation

    def relative(self, deviation: float) -> float:
        """Standard deviation of the value, as a share of it if logarithmic, of one of u."""
        return self.deviation * deviation


def field_unknown(name: str, text: str, role: Role, scenario: Scenario) -> Unknown:
    """Unknown field of a scenario.

    Args:
        name: Dotted path of a number; of a list with a number for each arm it is one number of all
            arms.
        text: Its uncertainty: ``factor 5`` (95 % within that factor), ``+- 2 %``, ``+- 5 deg`` or
            ``1.88 kg +- 0.5 %`` (one standard deviation).
        role: ``free`` or ``known``.
        scenario: That has it.

    Raises:
        InputError: If there is no such number, the text is no uncertainty of it, or arms differ.
    """
    path = tuple(key_path(name))
    found = number_at(name, path, scenario, ()) if path else None
    if path[:-1] == DIRECTIONS:
        found = Parameter(name, path, "rad")
    elif path[:3] == INERTIA and len(path) in (4, 5) and len(set(path[3:])) == 1:
        path = (
            *INERTIA,
            path[3],
            path[3],
        )  # a principal moment, as the table has it or as a matrix
        found = Parameter(name, path, "kg m^2")
    if found is None or found.whole:
        raise InputError(f"{name}: is no number that can be fitted")
    current, each = number_of_all(scenario, path)
    if current is None and each:
        theirs = f"{', '.join(f'{one:g}' for one in each)} {found.unit}".rstrip()
        raise InputError(
            f"{name}: is one number of all arms, and theirs differ (got {theirs}); give "
            f"{name}.0 to {name}.{len(each) - 1}, each with its uncertainty"
        )
    if current is None and path[:3] in (DIRECTIONS, INERTIA):
        raise InputError(f"{name}: the vehicle has no such number")
    try:
        refuse_unread(path, scenario, ())
    except InputError as error:
        raise InputError(f"{name}: {error}") from None
    try:
        centre, deviation, logarithmic = _prior(found, text, current)
    except PydanticCustomError as error:
        raise InputError(f"{name}: {error.message()}") from None
    if not (math.isfinite(deviation) and deviation > 0.0):
        raise InputError(f"{name}: an uncertainty must be above zero (got {shown_value(text)})")
    return Unknown(name, role, centre, deviation, logarithmic, found.unit, text, path=path)


def number_of_all(scenario: Scenario, path: Path) -> tuple[float | None, tuple[float, ...]]:
    """Number that a scenario has at a path, or that all entries of a list there have.

    Args:
        scenario: The scenario.
        path: Keys and indices.

    Returns:
        The number; None if there is none, or if entries differ.  And the entries, if it is a list.
    """
    node: Any = scenario
    for key in path:
        try:
            node = node[key] if isinstance(key, int) else getattr(node, key)
        except (TypeError, IndexError, AttributeError):
            return None, ()
    if isinstance(node, tuple) and node and all(isinstance(one, int | float) for one in node):
        each = tuple(map(float, node))
        return (each[0] if len(set(each)) == 1 else None), each
    return (float(node) if isinstance(node, int | float) else None), ()


def refuse_twice(names: Collection[str]) -> None:
    """Refuse a number of one arm beside that of all arms.

    Args:
        names: Of all fields.

    Raises:
        InputError: With both.
    """
    for name in names:
        whole, _, last = name.rpartition(".")
        if last.isdecimal() and whole in names:
            raise InputError(f"{name}: is part of {whole}, which is given as well")


def _prior(field: Parameter, text: str, current: float | None) -> tuple[float, float, bool]:
    """Centre and deviation of a prior, and whether they are of the logarithm."""
    if match := _FACTOR.match(text):
        centre = _centre(field, match["centre"] or "", current, text)
        factor = si_number(number_in(match["factor"], "", bare=True), "", above=1.0)
        _positive(field, centre, text)
        return math.log(centre), math.log(factor) / TWO_DEVIATIONS, True
    if not (match := _UNCERTAINTY.match(text)):
        raise InputError(
            f"{field.name}: {shown_value(text)} is no uncertainty; write 'factor 5', '+- 2 %' or "
            f"'+- 0.1{' ' if field.unit else ''}{field.unit}'"
        )
    centre, uncertainty = _centre(field, match["centre"], current, text), match["uncertainty"]
    if uncertainty.endswith("%"):
        share = number_in(uncertainty, "")
        _positive(field, centre, text)
        return math.log(centre), share, True
    bare = field.by_law or not field.unit
    return centre, number_in(uncertainty, field.unit, bare=bare), False


def _centre(field: Parameter, middle: str, current: float | None, text: str) -> float:
    if middle:
        return field.read(middle)
    if current is None:
        example = f"{f'1 {field.unit}'.strip()} {text.strip()}"
        raise InputError(
            f"{field.name}: the scenario has no single number there; give the middle, too, as "
            f"in {example!r}"
        )
    return current


def _positive(field: Parameter, centre: float, text: str) -> None:
    if not centre > 0.0:
        raise InputError(
            f"{field.name}: a factor or a share needs a value above zero (got {centre:g} "
            f"{field.unit}, {shown_value(text)}); write '+- 0.1 {field.unit}'"
        )


def latent(
    name: str,
    deviation: float,
    unit: str,
    *,
    centre: float = 0.0,
    flies: bool = True,
    of_device: bool = False,
) -> Unknown:
    """A latent of an impact, or of a sensor."""
    text = f"+- {deviation:.3g} {unit}".strip()
    return Unknown(name, "latent", centre, deviation, False, unit, text, flies, of_device=of_device)


def with_values(
    tables: Mapping[str, Any], unknowns: Sequence[Unknown], u: Sequence[float]
) -> dict[str, Any]:
    """Tables of a scenario with its unknown fields at a point; latents are left out."""
    result: Any = dict(tables)
    for unknown, at in zip(unknowns, u, strict=True):
        if unknown.path:
            value = float(unknown.value(at))
            result = with_value(result, unknown.path, value, f"{unknown.name}={value!r}")
    return dict(result)


def with_lists(
    tables: Mapping[str, Any], unknowns: Sequence[Unknown], scenario: Scenario
) -> dict[str, Any]:
    """Tables in which the lists are written out that some fields are entries of.

    Args:
        tables: Plain tables of the scenario.
        unknowns: The fields.
        scenario: The scenario.
    """
    words = [
        f"{one.name}={float(one.value(0.0))!r}"
        for one in unknowns
        if any(isinstance(key, int) for key in one.path) and one.path[:3] != INERTIA
    ]
    found: Any = apply_overrides(dict(tables), words)
    if any(one.path[:3] == INERTIA for one in unknowns):
        moments = [list(row) for row in scenario.vehicle.body.inertia]
        found = with_value(found, INERTIA, moments, "vehicle.body.inertia")
    return dict(found)


def at_centres(
    tables: Mapping[str, Any], fields: Sequence[Unknown], scenario: Scenario
) -> dict[str, Any]:
    """Tables whose fields have the middles of their priors, which a plan may give by itself.

    Args:
        tables: Of the scenario, plain.
        fields: Of the plan.
        scenario: The same scenario.
    """
    whole = with_lists(tables, fields, scenario)
    return with_values(whole, fields, [0.0] * len(fields))


def refuse_centres(
    tables: Mapping[str, Any], fields: Sequence[Unknown], scenario: Scenario
) -> None:
    """Refuse middles of priors with which the scenario is none, and name those that alone are why.

    Args:
        tables: Of the scenario, plain.
        fields: Of the plan.
        scenario: The same scenario.

    Raises:
        InputError: With the field and its uncertainty, and why.
    """
    together = _why_refused(tables, fields, scenario)
    if not together:
        return
    problems = [
        f"{one.role}.{one.name}: the scenario cannot have its middle "
        f"(got {shown_value(one.uncertainty)}): {why}"
        for one in fields if (why := _why_refused(tables, [one], scenario))
    ]  # fmt: skip
    problems = problems or [
        f"the middles of all free and known fields make no scenario: {together}"
    ]
    raise InputError(*problems)


def _why_refused(tables: Mapping[str, Any], fields: Sequence[Unknown], scenario: Scenario) -> str:
    """Why a scenario cannot have the middles of some priors; empty if it can."""
    try:
        scenario_from(at_centres(tables, fields, scenario), advises=False)
    except InputError as error:
        return "; ".join(error.problems)
    return ""
