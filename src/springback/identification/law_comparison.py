"""Contact laws, or other models, compared by how well each predicts impacts it was not fitted to.

Each impact is left out in turn.  What the others tell together of the free fields and of what all
share, with correlations and scatter, is the prior of the one left out, of precision P; its
predictive density is then that of its readings with fields and latents integrated out (Laplace):
ln p = ½ ln det P − ½ cost − ½ ln det JᵀJ, up to what all models share.  All models see the same
noise.  Differences of the sums have a standard error from their scatter over
the impacts (Vehtari, Gelman and Gabry, Statistics and Computing 27, 2017).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.contact.laws.restitution import dissipation_for, restitution
from springback.errors import InputError
from springback.identification.fits import FitResult, fields_of_plan
from springback.identification.observations.likelihood import ImpactProblem, JointPrior
from springback.identification.settings import FitPlan, LawName
from springback.identification.solving.fitting import ImpactFit, fit_impact
from springback.identification.solving.least_squares import jacobians, solve
from springback.identification.solving.pooled_fields import pooled_posterior
from springback.identification.unknowns import FARTHEST
from springback.progress import Progress, silent
from springback.scenario.overrides import apply_overrides, with_value
from springback.scenario.scenario import Scenario, scenario_from

#: Fewest impacts: one is left out, and two tell of the scatter between them.
FEWEST = 3
#: Standard errors, and differences of ln p, from which a model predicts worse (chosen).
CLEARLY, LEAST = 2.0, 2.0
#: Numbers of a law, and the uncertainty that each begins with.
LAW_NUMBERS: dict[LawName, dict[str, str]] = {
    "hunt-crossley": {"stiffness": "factor 5", "dissipation": "factor 5"},
    "hertz": {"stiffness": "factor 5"},
    "kelvin-voigt": {"stiffness": "factor 5", "viscosity": "factor 5"},
    "constant-restitution": {"stiffness": "factor 5", "restitution": "factor 1.5"},
}
#: Numbers of a surface that stay whatever its law.
_KEPT = (
    "friction", "friction_axes", "friction_law", "slip_speed", "shared_by", "presliding",
    "rolling_resistance",
)  # fmt: skip
#: Least restitution, and damping, with which another law begins (chosen).
_LEAST_RESTITUTION, _LEAST_DAMPING = 0.05, 1e-3


class LawPredictions(NamedTuple):
    """A model, and how well it predicts what it was not fitted to."""

    name: str
    scores: tuple[float, ...]
    """ln p of each impact, given the others; −infinite where nothing could be flown."""
    contact: float
    """Root mean square of whitened residuals in the contacts left out: 1 at best."""
    estimates: tuple[tuple[str, float, str], ...]
    """Free fields with their mean over the impacts, SI, and unit."""
    problem: str
    """Why it could not be fitted; empty if it could."""


class LawComparison(NamedTuple):
    """Models, the best one first."""

    impacts: tuple[str, ...]
    models: tuple[LawPredictions, ...]

    def behind(self, k: int) -> tuple[float, float]:
        """How much less ln p a model has than the best, and its standard error.

        Args:
            k: Number of the model.
        """
        best, one = (np.array(self.models[j].scores) for j in (0, k))
        rest = best - one
        if not np.isfinite(rest).all():
            return math.inf, math.nan
        return float(rest.sum()), float(math.sqrt(len(rest)) * rest.std(ddof=1))

    def is_worse(self, k: int) -> bool:
        """True if a model clearly predicts worse than the best, or so in every impact.

        Args:
            k: Number of the model.
        """
        less, error = self.behind(k)
        best, one = (self.models[j].scores for j in (0, k))
        each = all(a - b > LEAST for a, b in zip(best, one, strict=True))
        return not math.isfinite(less) or each or (less > LEAST and less > CLEARLY * error)

    def as_data(self) -> dict[str, Any]:
        """Plain data for JSON, without infinite numbers."""
        return {
            "impacts": list(self.impacts),
            "models": [
                {
                    "name": one.name, "problem": one.problem,
                    "scores": [_finite(score) for score in one.scores],
                    "contact": _finite(one.contact),
                    "behind": _finite(self.behind(k)[0]), "error": _finite(self.behind(k)[1]),
                    "worse": self.is_worse(k),
                    "values": {name: value for name, value, _ in one.estimates},
                }
                for k, one in enumerate(self.models)
            ],
        }  # fmt: skip

    @property
    def sentences(self) -> tuple[str, ...]:
        """Which model predicts best, and by how much."""
        count = len(self.impacts)
        said = [
            f"each of {count} impacts predicted from the others: {self.models[0].name} does it "
            f"best (residuals in the contact {self.models[0].contact:.2g} times their noise)"
        ]
        for k, one in enumerate(self.models[1:], start=1):
            if one.problem:
                said.append(f"{one.name} could not be fitted: {one.problem}")
                continue
            less, error = self.behind(k)
            how = "predicts worse" if self.is_worse(k) else "cannot be told from it"
            said.append(
                f"{one.name} {how}: ln p is less by {less:.3g} ± {error:.2g}, residuals in the "
                f"contact {one.contact:.2g} times their noise"
            )
        return tuple(said)


def _finite(number: float) -> float | None:
    return float(number) if math.isfinite(number) else None


class _Model(NamedTuple):
    """What is changed for a model."""

    name: str
    surface: dict[str, Any] | None  # in place of that of the obstacle
    change: tuple[str, ...]  # overrides
    free: dict[str, str]


def compare_laws(result: FitResult, *, progress: Progress = silent) -> LawComparison | None:
    """The laws and other models of a plan's ``compare``, beside that of the plan.

    Args:
        result: Of the plan's own model.
        progress: Called from time to time with the share done.

    Returns:
        None if the plan compares nothing.

    Raises:
        InputError: If there are too few impacts, or a model cannot be made.
    """
    plan, fits = result.plan, result.fits
    if not (plan.compare.laws or plan.compare.others):
        return None
    if len(fits) < FEWEST:
        raise InputError(
            f"compare: needs {FEWEST} impacts at least, each to be predicted from the others (got "
            f"{len(fits)})"
        )
    first = fits[0].problem
    models = [*(_of_law(plan, law, first, result) for law in plan.compare.laws), *(
        _Model(one.name, None, one.change, one.free) for one in plan.compare.others
    )]  # fmt: skip
    own = _own_name(plan, first.scenario)
    scatter = plan.scatter == "impact"
    found = [_scored(own, fits, fits, scatter=scatter)]
    for k, model in enumerate(models):
        progress((k + 1) / (len(models) + 1))
        if model.name == own:
            continue
        try:
            again = _refitted(plan, model, fits)
            found.append(_scored(model.name, again, fits, scatter=scatter))
        except InputError as error:
            scores = (-math.inf,) * len(fits)
            found.append(
                LawPredictions(model.name, scores, math.nan, (), "; ".join(error.problems))
            )
    found.sort(key=lambda one: -sum(one.scores))
    return LawComparison(tuple(fit.name for fit in fits), tuple(found))


def _own_name(plan: FitPlan, scenario: Scenario) -> str:
    """The plan's own law, if laws are compared, else ``as planned``."""
    surface = _surface(plan, scenario)
    return str(surface.law) if plan.compare.laws and surface is not None else "as planned"


def _surface(plan: FitPlan, scenario: Scenario) -> Any:
    obstacles = scenario.world.obstacles
    k = plan.compare.obstacle
    return getattr(obstacles[k], "surface", None) if k < len(obstacles) else None


def _of_law(plan: FitPlan, law: LawName, problem: ImpactProblem, result: FitResult) -> _Model:
    """A model with another law of the obstacle, equal to the present one at the speed of touch."""
    k, surface = plan.compare.obstacle, _surface(plan, problem.scenario)
    at = f"world.obstacles.{k}.surface"
    if surface is None:
        raise InputError(f"compare.obstacle: the scenario has no {at}")
    if surface.law not in LAW_NUMBERS:
        raise InputError(
            f"compare.laws: {at} has law {surface.law}, to which no other is made equal; give "
            "[[compare.others]]"
        )
    values = {
        one.unknown.name.removeprefix(f"{at}."): one.value for one in result.estimates
        if one.unknown.name.startswith(f"{at}.")
    }  # fmt: skip
    speed = float(np.linalg.norm(problem.impact.start.velocity))
    numbers = equal_numbers(law, surface, values, problem.scenario.vehicle.mass, speed)
    kept = {key: getattr(surface, key) for key in _KEPT if key in surface.model_fields_set}
    free = {
        name: text for name, text in plan.free.items()
        if not name.startswith(f"{at}.") or name.removeprefix(f"{at}.") in _KEPT
    }  # fmt: skip
    free |= {f"{at}.{key}": text for key, text in LAW_NUMBERS[law].items()}
    return _Model(law, {**kept, "law": law, **numbers}, (), free)


def equal_numbers(
    law: LawName, surface: Any, values: Mapping[str, float], mass: float, speed: float
) -> dict[str, float]:
    """Numbers of a law with the depth and the restitution of another, for one mass at one speed.

    Args:
        law: Wanted.
        surface: Settings of the present law.
        values: Fitted in place of its numbers [SI].
        mass: [kg].
        speed: At touch [m/s].
    """
    stiffness = values.get("stiffness", surface.stiffness)
    n = values.get("exponent", surface.exponent_value())
    energy = 0.5 * mass * speed**2
    depth = ((n + 1.0) * energy / stiffness) ** (1.0 / (n + 1.0))
    if surface.law == "hunt-crossley":
        e = restitution(values.get("dissipation", surface.dissipation_value()), speed)
    elif surface.law == "constant-restitution":
        e = values.get("restitution", surface.restitution)
    elif surface.law == "kelvin-voigt":
        ratio = 0.5 * values.get("viscosity", surface.viscosity) / math.sqrt(stiffness * mass)
        e = math.exp(-math.pi * ratio / math.sqrt(max(1.0 - ratio**2, 0.01)))
    else:
        e = 1.0
    e = min(max(e, _LEAST_RESTITUTION), 1.0)
    if law == "kelvin-voigt":
        k = 2.0 * energy / depth**2
        ratio = -math.log(e) / math.hypot(math.pi, math.log(e))
        return {"stiffness": k, "viscosity": 2.0 * max(ratio, _LEAST_DAMPING) * math.sqrt(k * mass)}
    found = {"stiffness": 2.5 * energy / depth**2.5, "exponent": 1.5}
    if law == "hunt-crossley":
        found["dissipation"] = max(float(dissipation_for(e, speed)), _LEAST_DAMPING)
    if law == "constant-restitution":
        found["restitution"] = e
    return found


def _refitted(plan: FitPlan, model: _Model, fits: Sequence[ImpactFit]) -> list[ImpactFit]:
    """Fits of all impacts by another model."""
    free = model.free or plan.free
    known = {name: text for name, text in plan.known.items() if name not in free}
    changed = plan.model_copy(update={"free": free, "known": known})
    found = []
    for fit in fits:
        tables: Any = fit.problem.tables
        if model.surface is not None:
            at = ("world", "obstacles", plan.compare.obstacle, "surface")
            tables = with_value(tables, at, model.surface, "compare.laws")
        tables = apply_overrides(dict(tables), model.change)
        scenario = scenario_from(tables, False, advises=False)
        fields = fields_of_plan(changed, scenario)
        problem = ImpactProblem(plan, scenario, tables, fields, fit.problem.impact)
        found.append(fit_impact(problem, starts=plan.starts, seed=plan.seed, profiles=False))
    return found


def _scored(
    name: str, fits: Sequence[ImpactFit], own: Sequence[ImpactFit], *, scatter: bool
) -> LawPredictions:
    """Score of a model by the impacts left out.

    Args:
        name: Of the model.
        fits: Of all impacts, by it.
        own: The same by the plan's model, whose noise is that of all models.
        scatter: True: free fields may differ from impact to impact.
    """
    scores, squares, samples = [], 0.0, 0
    for k, fit in enumerate(fits):
        rest = [one for j, one in enumerate(fits) if j != k]
        problem = left_out_problem(fit, rest, scatter=scatter)
        problem.readings = own[k].problem.readings
        prior = problem.together
        assert prior is not None
        start = fit.point.copy()
        start[prior.which] = prior.mean
        found = solve(problem, start[None], farthest=FARTHEST)
        point = found.points[0]
        residuals, [slopes] = jacobians(problem, point[None], np.ones(len(point), dtype=bool))
        determinant = float(np.linalg.slogdet(slopes.T @ slopes)[1])
        square = float((residuals[0] ** 2).sum())
        score = 0.5 * (prior.precision - square - determinant)
        scores.append(score if math.isfinite(score) else -math.inf)
        impact = problem.impact
        for reading in problem.readings:
            inside = (reading.times >= impact.touch) & (reading.times <= impact.release)
            white = problem.errors(point)[reading.name][inside]
            squares, samples = squares + float((white**2).sum()), samples + white.size
    estimates = tuple(
        (one.name, float(np.mean([one.value(fit.point[k]) for fit in fits])), one.unit)
        for k, one in enumerate(fits[0].problem.fields) if one.role == "free"
    )  # fmt: skip
    contact = math.sqrt(squares / samples) if samples else math.nan
    return LawPredictions(name, tuple(scores), contact, estimates, "")


def left_out_problem(fit: ImpactFit, rest: Sequence[ImpactFit], *, scatter: bool) -> ImpactProblem:
    """Problem of an impact whose prior is what the others tell, correlations and scatter included.

    Args:
        fit: Of the impact that is left out.
        rest: Of the others, at least two.
        scatter: True: free fields may differ from impact to impact.
    """
    old = fit.problem
    problem = ImpactProblem(old.plan, old.scenario, old.tables, old.fields, old.impact)
    told = pooled_posterior(rest, scatter=scatter)
    which = np.array([problem.place[name] for name in told.names])
    root = np.linalg.cholesky(told.covariance + told.scatter)
    problem.together = JointPrior(which, told.mean, np.asarray(root, dtype=float))
    return problem
