"""Why a field is not told: nothing depends on it, hardly anything does, or another does the same.

Sensitivities are those of whitened residuals to the number u of a field, whose prior has a standard
deviation of 1: a sum of squares of 1 narrows the prior by a factor of √2, were all else known.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from springback.identification.unknowns import Unknown
from springback.logs.recording import Array
from springback.scenario.scenario import Scenario

#: Sum of squares of a field's slopes below which nothing depends on it (chosen: rounding leaves
#: 1e-10), and below which even alone it would hardly be told.
NO_EFFECT, HARDLY = 1e-6, 1.0
#: Share of the depth below which an obstacle is said to be hidden behind a hull (chosen).
HIDDEN = 0.1
#: Numbers of a surface that act along its tangent, or are the hull's and the obstacle's together.
_TANGENTIAL = ("friction", "slip_speed", "presliding", "rolling_resistance")


class FieldSensitivity(NamedTuple):
    """What a test or an impact tells of a field."""

    told: float
    """Sum of squares of its slopes, without the prior."""
    rival: str
    """Unknown that does most nearly the same; empty if it is alone."""
    correlation: float
    """With that one."""


def field_sensitivities(
    unknowns: list[Unknown], slopes: Array, count: int
) -> list[FieldSensitivity]:
    """Sensitivities of the first unknowns.

    Args:
        unknowns: Fields, then latents.
        slopes: Of all residuals, those of the priors included, shape (rows, unknowns).
        count: How many are fields.
    """
    square = slopes.T @ slopes
    covariance = np.linalg.inv(square + 1e-12 * np.eye(len(square)))
    scale = 1.0 / np.sqrt(np.diag(covariance))
    matrix = covariance * scale[:, None] * scale[None]
    np.fill_diagonal(matrix, 0.0)
    found = []
    for k in range(count):
        other = int(np.abs(matrix[k]).argmax())
        rho = float(matrix[k, other])
        name = unknowns[other].name if rho else ""
        found.append(FieldSensitivity(max(float(square[k, k]) - 1.0, 0.0), name, rho))
    return found


def reason_untold(field: Unknown, told: FieldSensitivity, scenario: Scenario) -> str:
    """Why a field is not told, in words.

    Args:
        field: That is not told.
        told: The most that an impact, or a test, tells of it.
        scenario: That is flown.
    """
    structural = hidden_behind(field.path, scenario)
    if told.told < NO_EFFECT:
        return f"nothing that is flown depends on it: {structural or 'no contact or force has it'}"
    if told.told < HARDLY:
        narrowed = 100.0 / np.sqrt(1.0 + told.told)
        said = (
            f"the sensors hardly see it: were all else known, {narrowed:.0f} % of its uncertainty "
            "would be left"
        )
        return f"{said}; {structural}" if structural else said
    return (
        f"what it does to the sensors is nearly what {told.rival} does (correlation "
        f"{told.correlation:+.2f})"
    )


def hidden_behind(path: Any, scenario: Scenario) -> str:
    """Why the surface of an obstacle does not matter to the vehicle's hulls; empty if it may.

    Args:
        path: Of a field.
        scenario: That has it.
    """
    if path[:2] != ("world", "obstacles") or "surface" not in path or path[-1] in _TANGENTIAL:
        return ""
    for k, hull in enumerate(scenario.vehicle.hulls):
        surface = hull.surface
        if surface is None:
            continue
        name = f"vehicle.hulls.{k}.surface"
        if surface.is_alone:
            how = "in_series = false" if surface.law not in ("foam", "table") else (
                f"law = {surface.law}"
            )  # fmt: skip
            return (
                f"the vehicle's hulls meet everything by their own law, as if it were rigid "
                f"({name} has {how}): free {name}.stiffness in its place"
            )
        share = _share(path, scenario, surface)
        if share is not None and share < HIDDEN:
            return (
                f"the hull in series with it ({name}) is so much softer that the obstacle takes "
                f"{100.0 * share:.2g} % of the depth: free {name}.stiffness as well"
            )
    return ""


def _share(path: Any, scenario: Scenario, hull: Any) -> float | None:
    """Share of the depth that an obstacle takes in series with a hull; None if not known."""
    theirs = getattr(scenario.world.obstacles[path[2]], "surface", None)
    stiffness = getattr(theirs, "stiffness", None)
    if not stiffness or not hull.stiffness:
        return None
    there, own = (k ** (-1.0 / hull.exponent) for k in (float(stiffness), hull.stiffness))
    return float(there / (there + own))
