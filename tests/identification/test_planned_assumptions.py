"""What a choice of tests takes for granted is said, as a fit says it."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from builders.cases import nonempty
from builders.rigs import rig_fit
from springback.identification.design.assumptions import (
    ImpactPoint,
    planned_assumptions,
)
from springback.identification.design.experiments import plan_experiments
from springback.identification.report.assumptions import assumption_sentences, assumptions
from springback.identification.settings import read_fit_plan
from springback.interfaces.cli.identify.fitting import experiments_text

EXAMPLES = Path(__file__).parents[2] / "examples"
SLIP = "world.obstacles.0.surface.slip_speed"


def test_one_impact_relies_on_what_its_fit_relies_on() -> None:
    """The same numbers by the gradients without latents as by those with them."""
    result = rig_fit()
    [fit] = result.fits
    size = fit.problem.count
    total = np.asarray(np.linalg.inv(fit.covariance[:size, :size]), dtype=float)
    said = planned_assumptions([ImpactPoint(fit.problem, fit.point, fit.jacobian)], total)
    wanted = assumption_sentences(assumptions([fit]), result.estimates)
    assert len(wanted) > 3
    # The last names what moves nothing, in an order of its own.  Springs and dampers are moved alike:
    # which of them is named as the one moved most is a matter of the last digit.
    for ours, fits in nonempty(zip(said, wanted[:-1], strict=False)):
        field, moved = (re.split(r" more move .* by |: another", text) for text in (ours, fits))
        assert field[0] == moved[0]
        if moved[1].endswith("%"):
            numbers = [float(text.rstrip("% ")) for text in (field[1], moved[1])]
            assert numbers[0] == pytest.approx(numbers[1], abs=0.15)
    assert said[-1].startswith("what is not exact belongs in [known], as")


def test_tests_that_rely_on_an_exact_number_are_chosen_with_a_word_of_it() -> None:
    """Head-on at 3.5 m/s both cages hardly slip: the speed of regularisation decides."""
    speeds = ['candidates.speeds=["3.5 m/s"]', "candidates.pitches=[0]", "candidates.yaws=[0]"]
    plan = read_fit_plan(EXAMPLES / "fit.toml", [*speeds, "candidates.count=1"])
    found = plan_experiments(plan, EXAMPLES)
    [said] = [text for text in found.assumed if text.startswith(SLIP)]
    assert "10 % more move" in said
    assert '= "+- 10 %": the tests are then chosen without' in found.assumed[-1]
    text = experiments_text(found)
    assert "assumed to be exact, and what that does to all chosen tests together:\n" in text
    uncertain = plan.model_copy(update={"known": {**plan.known, SLIP: "+- 30 %"}})
    again = plan_experiments(uncertain, EXAMPLES)
    assert not [text for text in again.assumed if text.startswith(SLIP)]
    assert again.chosen[0].half_widths[4] > 1.2 * found.chosen[0].half_widths[4]  # damping
