"""What a fit takes for granted: fields neither free nor known, and how far each moves a result.

Each is changed by what a ruler, an inclinometer or a data sheet may be wrong by.  The fitted fields
follow by δu = −C Jᵀ ∂r/∂a δa, to first order, with the latents and the priors as they were.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.errors import InputError
from springback.identification.estimates import FieldEstimate
from springback.identification.observations.likelihood import ImpactProblem
from springback.identification.solving.fitting import ImpactFit
from springback.identification.solving.least_squares import jacobians
from springback.identification.unknowns import Unknown
from springback.kernels.layout import structure
from springback.logs.recording import Array
from springback.scenario.fields import Path, fields_of
from springback.scenario.overrides import with_value
from springback.scenario.scenario import Scenario, scenario_from
from springback.settings import Settings

#: Changes that are tried (chosen), in words and in SI: angles and lengths of a vehicle, ...
_CHANGES = {"rad": ("2 deg", math.radians(2.0)), "m": ("2 mm", 2e-3)}
#: ... lengths and places of obstacles, and shares of all other numbers.
PLACE, SHARE = ("5 mm", 5e-3), 0.1
#: Units of lists that are checked as a whole, and so have none of their own.
_UNTYPED = {"directions": "rad", "inertia": "kg m^2"}
#: Change of a field to see whether the flight keeps its form, as a share.
_SLIGHT = 1e-3
#: Words of a surface that choose its laws.
_LAWS = ("law", "friction_law", "friction_axes", "shared_by")
#: Least change of a fitted field that counts, in its standard deviations (chosen).
MATTERS = 0.25
#: Most sentences on assumed fields, and names of those that move nothing (chosen).
MOST_SAID, MOST_QUIET = 8, 6


class Assumption(NamedTuple):
    """A field that was neither free nor known to some uncertainty."""

    name: str
    value: float
    unit: str
    change: str
    """That was tried, in words."""
    shifts: dict[str, float]
    """Of the number u of each free field, for that change; empty if it was not tried, as another
    value makes another law of it."""
    weight: float
    """Largest shift in standard deviations; infinite if it was not tried."""


def assumptions(fits: Sequence[ImpactFit]) -> list[Assumption]:
    """Assumed fields, those that move the result most first; those that are zero are left out.

    Args:
        fits: Of all impacts; shifts are means over them.
    """
    first = fits[0]
    candidates, fixed = assumed_fields(first.problem)
    total: dict[str, dict[str, list[float]]] = {one.name: {} for one in candidates}
    weights = dict.fromkeys(total, 0.0)
    for fit in fits if candidates else ():
        for one, shifts in zip(candidates, _shifts(fit, candidates), strict=True):
            for name, shift in shifts.items():
                total[one.name].setdefault(name, []).append(shift)
                if np.isfinite(shift):
                    weights[one.name] = max(weights[one.name], abs(shift) / fit.deviation(name))
    found = [untried_field(one) for one in fixed]
    for one in candidates:
        shifts = {name: float(np.nanmean(each)) for name, each in total[one.name].items()
                  if not np.isnan(each).all()}  # fmt: skip
        found.append(Assumption(
            one.name, one.centre, one.unit, one.uncertainty, shifts, weights[one.name]
        ))  # fmt: skip
    return sorted(found, key=lambda one: -one.weight)


def assumption_sentences(
    found: Sequence[Assumption], estimates: Sequence[FieldEstimate]
) -> list[str]:
    """Assumed fields that move a result, or whose value is part of a law; and how many do not.

    Args:
        found: From `assumptions`.
        estimates: Of the fit.
    """
    known = {one.unknown.name: one for one in estimates}
    said, quiet = list[str](), list[str]()
    for one in found:
        value = f"{one.name} = {one.value:.5g} {one.unit}".rstrip()
        if not one.change:
            said.append(f"{value}: another value makes another law")
            continue
        if one.weight < MATTERS:
            quiet.append(one.name)
            continue
        name = max(one.shifts, key=lambda key: abs(one.shifts[key]) / known[key].deviation)
        unknown = known[name].unknown
        size = unknown.deviation * one.shifts[name]
        far = f"{100.0 * math.expm1(size):+.2g} %" if unknown.logarithmic else (
            f"{size:+.2g} {unknown.unit}".rstrip()
        )  # fmt: skip
        said.append(f"{value}: {one.change} more move {name} by {far}")
    if len(said) > MOST_SAID:
        said = [*said[:MOST_SAID], f"and {len(said) - MOST_SAID} more that move a result"]
    if quiet:
        shown = ", ".join(quiet[:MOST_QUIET]) + (", ..." if len(quiet) > MOST_QUIET else "")
        said.append(
            f"moving no result by a quarter of its uncertainty: {len(quiet)} more ({shown})"
        )
    return said


def untried_field(one: Unknown) -> Assumption:
    """A field of which another value is another law."""
    return Assumption(one.name, one.centre, one.unit, "", {}, np.inf)


def _shifts(fit: ImpactFit, candidates: Sequence[Unknown]) -> Iterator[dict[str, float]]:
    """Shifts of the free fields of an impact for a change of each candidate."""
    old = fit.problem
    moved = -fit.covariance @ assumed_gradients(old, fit.point, fit.jacobian, candidates)
    free = [one.name for one in old.fields if one.role == "free"]
    for k in range(len(candidates)):
        yield {name: float(moved[old.place[name], k]) for name in free}


def assumed_gradients(
    old: ImpactProblem, at: Array, jacobian: Array, candidates: Sequence[Unknown]
) -> Array:
    """Jᵀ ∂r/∂a of assumed fields for the change that is tried of each, shape (unknowns, fields).

    Args:
        old: Likelihood of an impact.
        at: Point of its unknowns.
        jacobian: There, with the rows of the priors.
        candidates: From `assumed_fields`.
    """
    count, first, width = len(candidates), old.count, len(at)
    fields = [*old.fields, *candidates]
    problem = ImpactProblem(old.plan, old.scenario, _whole(old), fields, old.impact)
    problem.readings = old.readings  # with the noise of the fit
    point = np.concatenate([at[:first], np.zeros(count), at[first:]])
    active = np.zeros(len(point), dtype=bool)
    active[first : first + count] = True
    _, [slopes] = jacobians(problem, point[None], active)
    rows = len(slopes) - len(point)  # without those of the priors
    told = jacobian[: len(jacobian) - width].T @ slopes[:rows, first : first + count]
    return np.asarray(told, dtype=float)


def assumed_fields(problem: ImpactProblem) -> tuple[list[Unknown], list[Unknown]]:
    """Fields that can be tried, and those of which another value is another law.

    Args:
        problem: Likelihood of an impact.
    """
    scenario, taken = problem.scenario, {one.path for one in problem.fields}
    whole = _whole(problem)
    base = _form(whole)
    tried, fixed = list[Unknown](), list[Unknown]()
    for path, unit, value in _numbers(scenario):
        if value == 0.0 or any(path[: len(one)] == one for one in taken):
            continue
        one = _unknown(path, unit, value)
        try:
            moved = with_value(whole, path, value * (1.0 + _SLIGHT), one.name)
            (tried if _form(moved) == base else fixed).append(one)
        except InputError:
            continue  # it cannot be another, such as an entry of an inertia, a symmetric matrix
    return tried, fixed


def _whole(problem: ImpactProblem) -> dict[str, Any]:
    """Tables of an impact's flight with all numbers of its vehicle, also those of a preset."""
    return problem.tables | {"vehicle": problem.scenario.vehicle.model_dump(mode="json")}


def _unknown(path: Path, unit: str, value: float) -> Unknown:
    """A number with the change that is tried as its deviation."""
    name = ".".join(map(str, path))
    if unit in _CHANGES:
        change, size = _CHANGES[unit]
        if path[0] == "world" and unit == "m":
            change, size = PLACE
        return Unknown(name, "known", value, size, False, unit, change, path=path)
    size = SHARE * abs(value)
    change = f"{100.0 * SHARE:g} %"
    return Unknown(name, "known", value, size, False, unit, change, path=path)


def _form(tables: dict[str, Any]) -> Any:
    """Types of the tree that a scenario is built into."""
    return structure(scenario_from(tables, False, advises=False).build(advises=False).model)


def _numbers(scenario: Scenario) -> Iterator[tuple[Path, str, float]]:
    """Numbers of the vehicle and its obstacles, with their paths and units; gravity is known."""
    yield from _within(scenario.vehicle, ("vehicle",), "")
    yield from _within(scenario.world.obstacles, ("world", "obstacles"), "")


def _within(node: Any, path: Path, unit: str) -> Iterator[tuple[Path, str, float]]:
    if isinstance(node, Settings):
        for key, field in fields_of(type(node)).items():
            known = field.unit
            inner = _UNTYPED.get(key, "") if known is None else known.unit
            yield from _within(getattr(node, key), (*path, key), inner)
    elif isinstance(node, tuple):
        for k, entry in enumerate(node):
            yield from _within(entry, (*path, k), unit)
    elif isinstance(node, float):
        yield path, unit, node


def words_of_laws(scenario: Scenario) -> list[str]:
    """Laws of the obstacles' surfaces, such as ``law = hunt-crossley``, a text for each."""
    found = []
    for k, obstacle in enumerate(scenario.world.obstacles):
        surface = getattr(obstacle, "surface", None)
        words = {key: getattr(surface, key, None) for key in _LAWS}
        said = [f"{key} = {value}" for key, value in words.items() if value is not None]
        found += [f"{', '.join(said)} of world.obstacles.{k}.surface"] * bool(said)
    return found
