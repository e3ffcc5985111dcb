"""Part of a channel of a log that belongs to an impact."""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.identification.observations.noise import ChannelNoise
from springback.logs.recording import Array, SensorChain


class ChannelWindow(NamedTuple):
    """One channel of an impact."""

    quantity: str
    name: str
    times: Array  # [s] from the start of the window, shape (samples,)
    values: Array  # SI, shape (samples, width); NaN where lost
    noise: ChannelNoise
    starts: Any  # True for samples that follow a gap, and for the first
    chain: SensorChain
    other_clock: bool
    clipped: Any = None  # lengths of arms at the ends of their sensors' ranges, as values; or None
