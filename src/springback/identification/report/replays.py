"""Replays of impacts: what each channel measured, and what it would have told at the optimum."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from springback.identification.observations.channel_window import ChannelWindow
from springback.identification.solving.fitting import ImpactFit
from springback.logs.frame_turns import conjugate, product, rotation_vector
from springback.logs.recording import ANGULAR_VELOCITY, ATTITUDE, POSITION, SPECIFIC_FORCE, Array

#: Share of the range from which a sample counts as clipped (chosen).
CLIPPED = 0.999


class ChannelReplay(NamedTuple):
    """A channel of an impact, measured and predicted, from its first touch."""

    reading: ChannelWindow
    times: Array
    """From touch [s], on the clock of the inertial unit, shape (samples,)."""
    measured: Array
    """Shape (samples, width), NaN where lost; positions from where touch was predicted, attitudes
    as turns from the first of the window [rad], everything else SI."""
    predicted: Array
    """The same of the prediction."""
    residuals: Array
    """Whitened, in standard deviations of the noise."""
    clipped: Any
    """True for samples at the end of the range, shape (samples, width)."""

    @property
    def at_rest(self) -> str:
        """What the values are counted from, for a caption; empty for the channel's own zero."""
        return {POSITION: "the place at touch", ATTITUDE: "the first attitude"}.get(
            self.reading.quantity, ""
        )


def replays(fit: ImpactFit) -> list[ChannelReplay]:
    """All channels of an impact at its optimum."""
    problem, point = fit.problem, fit.point
    predictions, errors = problem.predictions(point), problem.errors(point)
    clock = problem.place.get("clock offset")
    offset = 0.0 if clock is None else float(problem.unknowns[clock].value(point[clock]))
    found = []
    for one in problem.readings:
        times = one.times + (offset if one.other_clock else 0.0) - problem.impact.touch
        measured, predicted = one.values, predictions[one.name]
        if one.quantity == POSITION:
            home = predicted[int(np.argmin(np.abs(times)))]
            measured, predicted = measured - home, predicted - home
        elif one.quantity == ATTITUDE:
            first = conjugate(predicted[0])
            measured, predicted = (
                rotation_vector(product(first, q)) for q in (measured, predicted)
            )  # fmt: skip
        clipped = np.zeros(measured.shape, dtype=bool)
        if one.quantity in (SPECIFIC_FORCE, ANGULAR_VELOCITY):
            full = problem.chain(one).full_scale
            if full is not None:
                clipped = np.abs(measured) >= CLIPPED * full
        elif one.clipped is not None:
            clipped = np.asarray(one.clipped, dtype=bool)
        found.append(ChannelReplay(
            one, times, measured, predicted[:, : measured.shape[1]], errors[one.name], clipped
        ))  # fmt: skip
    return found
