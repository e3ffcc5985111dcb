"""Sensitivity of a measure to the fields of a campaign: first-order indices of its variance."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt
import scipy  # submodules are loaded on first use

from springback.campaign.access import Campaign
from springback.campaign.analysis.marginals import MeasureColumn, measure_column, scale
from springback.campaign.analysis.statistics import ordered_values
from springback.intervals import CONFIDENCE, IntervalEstimate, Values
from springback.random_streams import Purpose, stream
from springback.results.database import identifier

#: Fewest samples for which indices are given (chosen: below, intervals reach ± 0.2 and more).
LEAST = 128
#: Relative deviation up to which values are the same but for rounding (chosen).
ALIKE = 1e-12
#: Number of draws of the bootstrap, and most groups of samples that are drawn (chosen).
DRAWS, GROUPS = 1000, 1000
#: Fewest samples in a class of a continuous field, and most classes (chosen).
EACH, MOST_CLASSES = 8, 48
#: Number of the stream of random numbers; a Latin hypercube shuffles with those below.
BOOTSTRAP = 2**31
Classes = npt.NDArray[np.intp]


@dataclass(frozen=True)
class Sensitivity:
    """First-order indices of a measure: the share of its variance that a field alone explains."""

    measure: MeasureColumn
    robots: dict[str, dict[str, IntervalEstimate]]
    """Index of each field, by robot; empty where it cannot be estimated."""
    flights: dict[str, int]
    """Number of flights that have the measure, by robot."""
    refusal: str = ""
    """Sentence on why indices are missing; empty if none are."""

    def ranking(self) -> list[str]:
        """Fields by their largest index over the robots, the largest first."""
        found: dict[str, float] = {}
        for indices in self.robots.values():
            for name, (value, _, _) in indices.items():
                found[name] = max(found.get(name, 0.0), value or 0.0)
        return sorted(found, key=lambda name: -found[name])

    def as_dict(self) -> dict[str, Any]:
        """Plain data."""
        indices = {
            robot: {name: index._asdict() for name, index in found.items()}
            for robot, found in self.robots.items()
        }
        return {"flights": self.flights, "first_order": indices, "refusal": self.refusal}


def sensitivity(campaign: Campaign, name: str, fields: Sequence[str]) -> Sensitivity:
    """First-order indices of a measure with respect to fields.

    They need samples drawn independently along all fields, which a grid does not have.

    Args:
        campaign: Any.
        name: Name of the measure's column.
        fields: Names of varied fields.

    Raises:
        InputError: If a field was not varied, or there is no such measure.
    """
    what, others = measure_column(campaign, name), [field for field in fields if field != name]
    if campaign.design.plan.method == "grid":
        why = (
            "a grid has levels instead of a distribution of its fields; "
            'use method = "sobol", "latin-hypercube" or "random"'
        )
        return Sensitivity(what, {}, {}, why)
    found: dict[str, dict[str, IntervalEstimate]] = {}
    flights: dict[str, int] = {}
    reasons = []
    for robot in campaign.robots:
        rows = _rows(campaign, what, others, robot)
        values, samples = rows.pop("value"), rows.pop("sample")
        flights[robot], count = len(values), len(np.unique(samples))
        if count < LEAST:
            reasons.append(f"{robot} has it in {count} samples, and at least {LEAST} are needed")
        elif not values.std() > ALIKE * np.abs(values).max():
            reasons.append(f"it is the same in all flights of {robot}")
        else:
            found[robot] = first_order_indices(
                dict(zip(others, rows.values(), strict=True)), values, samples
            )
    return Sensitivity(what, found, flights, "; ".join(reasons))


def _rows(
    campaign: Campaign, what: MeasureColumn, fields: Sequence[str], robot: str
) -> dict[str, Values]:
    """Measure, sample and fields of the flights that have them; levels of words as numbers."""
    words = {one.column for one in campaign.design.dimensions if one.text}
    values = (
        scale(campaign, name, 2).cell if name in words else identifier(name) for name in fields
    )
    columns = [f"({value})::DOUBLE AS field{k}" for k, value in enumerate(values)]
    listed = ", ".join([f"{identifier(what.name)}::DOUBLE AS value", "sample", *columns])
    sql = f"SELECT {listed} FROM flights WHERE robot = ? AND outcome <> 'refused' ORDER BY flight"
    found = campaign.arrays(sql, [robot])
    ordered_values(campaign, {what.name: found["value"]})
    known = np.isfinite(np.array(list(found.values()))).all(axis=0)
    return {name: values[known] for name, values in found.items()}


def class_count(samples: int) -> int:
    """Number of classes of a continuous field.

    Of Ishigami's function with 128 samples, eight in a class give indices within 0.06; the four
    classes that Plischke's rule (as in SALib) gives miss its second field, of four waves, wholly.
    """
    return min(samples // EACH, MOST_CLASSES)


def first_order_indices(
    fields: Mapping[str, Values], values: Values, samples: Values
) -> dict[str, IntervalEstimate]:
    """First-order indices of given data, with intervals by bootstrap.

    The index of a field, Var(E[y | x]) / Var(y), is the correlation ratio of y between classes of
    x (Plischke, Borgonovo and Smith 2013, *European Journal of Operational Research* 226, 536-550),
    here without the bias of few flights in a class (Kelley 1935, *Proceedings of the National
    Academy of Sciences* 21, 554-559).  The bootstrap (Efron 1979) draws whole samples with all
    their repeats, or random groups of samples if there are more than `GROUPS`; the interval is
    normal around the estimate.  Values and bounds are within 0 and 1.

    Args:
        fields: Values of each field, shape (flights,).
        values: Measure, shape (flights,), not all equal.
        samples: Number of the sample of each flight; equal numbers are drawn together.
    """
    chance = stream(0, Purpose.SHUFFLE, BOOTSTRAP)  # the same intervals every time
    groups, count = _groups(samples, chance)
    drawn = chance.multinomial(count, np.full(count, 1.0 / count), size=DRAWS)
    weights = np.vstack([np.ones(count), drawn]).astype(np.float64)
    centred = (values - values.mean()) / values.std()
    squares = weights @ np.bincount(groups, centred**2, count)
    reach = float(scipy.stats.norm.ppf(0.5 * (1.0 + CONFIDENCE)))
    found = {}
    for name, x in fields.items():
        classes = _classes(x, class_count(len(np.unique(samples))))
        value, *others = _explained_share(weights, squares, groups, classes, centred).tolist()
        estimate, error = min(1.0, max(0.0, value)), reach * float(np.std(others, ddof=1))
        bounds = (estimate, estimate - error, estimate + error)
        found[name] = IntervalEstimate(*(min(1.0, max(0.0, bound)) for bound in bounds))
    return found


def _groups(samples: Values, chance: np.random.Generator) -> tuple[Classes, int]:
    """Group of each flight, and the number of groups."""
    _, groups = np.unique(samples, return_inverse=True)
    count = int(groups.max()) + 1
    if count <= GROUPS:
        return groups, count
    return (chance.permutation(count) % GROUPS)[groups], GROUPS


def _classes(x: Values, count: int) -> Classes:
    """Class of each value: its level if there are few, else one of equal probability."""
    levels, numbers = np.unique(x, return_inverse=True)
    if len(levels) <= count:
        return numbers
    ranks = np.empty(len(x), np.intp)
    ranks[np.argsort(x, kind="stable")] = np.arange(len(x))
    return ranks * count // len(x)


def _explained_share(
    weights: Values, squares: Values, groups: Classes, classes: Classes, y: Values
) -> Values:
    """Share of the variance between classes, for each row of weights of the groups."""
    shape = (weights.shape[1], int(classes.max()) + 1)
    cells = groups * shape[1] + classes
    size = shape[0] * shape[1]
    counts = weights @ np.bincount(cells, minlength=size).reshape(shape)
    sums = weights @ np.bincount(cells, y, size).reshape(shape)
    n, total, used = counts.sum(axis=1), sums.sum(axis=1), (counts > 0.0).sum(axis=1)
    between = (sums**2 / np.maximum(counts, 1.0)).sum(axis=1) - total**2 / n
    ratio = between / np.maximum(squares - total**2 / n, np.finfo(float).tiny)
    return np.asarray(1.0 - (1.0 - ratio) * (n - 1.0) / np.maximum(n - used, 1.0), np.float64)
