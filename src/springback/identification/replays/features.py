"""Numbers that are read off a channel: when the force rises at touch, and its peak."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from springback.identification.observations.channel_window import ChannelWindow
from springback.logs.recording import Array

#: Share of the recorded peak at which touch is read off (chosen: below it is the slow rise of a
#: soft contact), and multiple of the noise that it is at least.
SHARE, NOISES = 0.1, 5.0
#: Part about the recorded contact in which the peak is, before and after it at least [s] (chosen).
BEFORE, AFTER = 0.03, 0.03
#: Part before touch that is rest [s] (chosen).
CLEAR = 0.01


class ForceRise(NamedTuple):
    """How touch and peak are read off a specific force, the same way for every curve."""

    times: Array
    """Of the samples [s]."""
    near: Any
    """Samples about the contact."""
    early: Any
    """Samples before touch."""
    level: float
    """Change of the specific force that counts as touch [m/s²]."""

    @classmethod
    def of_recorded(cls, one: ChannelWindow, touch: float, contact: float) -> ForceRise:
        """By a recorded channel.

        Args:
            one: Specific force.
            touch: As found in the log [s].
            contact: Its duration [s].
        """
        near = (one.times > touch - BEFORE) & (one.times < touch + contact + max(contact, AFTER))
        early = one.times < touch - CLEAR
        if not early.any():
            early = one.times <= one.times[0]
        found = cls(one.times, near, early, 0.0)
        noise = float(np.linalg.norm(one.noise.stationary))
        return found._replace(level=max(SHARE * found.peak(one.values), NOISES * noise))

    def change(self, values: Array) -> Array:
        """Size of the change since before touch [m/s²], shapes (..., samples, 3) to (samples,)."""
        rest = np.nanmedian(values[..., self.early, :], axis=-2, keepdims=True)
        return np.asarray(np.linalg.norm(values - rest, axis=-1))

    def peak(self, values: Array) -> float:
        """Largest change in the contact [m/s²]."""
        inside = self.change(values)[self.near]
        return float(np.nanmax(inside)) if inside.size and not np.isnan(inside).all() else np.nan

    def time(self, values: Array) -> float:
        """Instant at which the change rises to its peak through the level [s]; NaN if never."""
        change = self.change(values)
        if np.isnan(change[self.near]).all():
            return np.nan
        k = int(np.nanargmax(np.where(self.near, change, -np.inf)))
        if not change[k] > self.level:
            return np.nan
        while k > 0 and change[k - 1] > self.level:
            k -= 1
        if k == 0:
            return float(self.times[0])
        low, high = change[k - 1], change[k]
        if np.isnan(low):
            return float(self.times[k])
        share = (self.level - low) / (high - low)
        return float(self.times[k - 1] + share * (self.times[k] - self.times[k - 1]))
