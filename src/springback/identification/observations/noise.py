"""Noise of a channel: autoregressive, estimated before touch, and whitened."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Highest order of autoregression, and degree of the polynomial that is taken for motion (chosen:
#: fits beside noise of rotors are the best with 24 of 4, 16 and 24).
HIGHEST_ORDER, DEGREE = 24, 3
#: Fewest samples from which noise is estimated (chosen).
FEWEST = 20
#: Median deviation of normal noise over its standard deviation, and deviations beyond which a
#: sample before touch is not noise (chosen: one of a million is).
MEDIAN, WILD = 0.6745, 5.0
#: Noise of which the samples before leave less than the first share of the variance is taken to be
#: white by the second (chosen: a tenth of the deviation): it hangs on the rotors, which an impact
#: disturbs, and coefficients that predict it so well are not to be trusted through a contact.
WELL_PREDICTED, WHITE_SHARE = 0.1, 0.01
#: Variance of white noise that a filtered channel has of its own, over its variance (chosen: a
#: thousandth of the deviation; with a hundredth, intervals of slider impacts behind 30 Hz are too
#: narrow by a tenth).
OWN = 1e-6
#: Series that are whitened at once (chosen: they fit into a processor's cache).
TOGETHER = 8
#: Degrees of freedom of Student's t for motion capture, whose markers are swapped at times
#: (chosen; field's usual for robust regression: Lange, Little and Taylor, JASA 84, 1989).
STUDENT = 4.0


class ChannelNoise(NamedTuple):
    """Noise of a channel: r_k = Σ φ_i r_(k-i) + e_k."""

    coefficients: Array
    """φ, shape (order,)."""
    innovation: Array
    """Standard deviation of e of each number, shape (width,)."""
    stationary: Array
    """Standard deviation of r, shape (width,)."""
    freedom: float = np.inf
    """Degrees of freedom of its estimate; infinite if it was given."""

    def with_residuals(self, white: Array) -> ChannelNoise:
        """The noise with further residuals, by which few samples before touch are not alone.

        Args:
            white: Whitened residuals of a fit, each of deviation 1 if the noise is right.
        """
        if not np.isfinite(self.freedom):
            return self
        total = self.freedom + white.size
        scale = np.sqrt((self.freedom + float((white**2).sum())) / total)
        return ChannelNoise(
            self.coefficients, scale * self.innovation, scale * self.stationary, total
        )

    def whiten(self, residuals: Array, starts: Array) -> Array:
        """Residuals as independent numbers of standard deviation 1.

        Args:
            residuals: Shape (..., samples, width); NaN where lost, which gives zero.
            starts: True for samples that follow a gap, and for the first, shape (samples,).
        """
        order, shape = len(self.coefficients), residuals.shape
        count = shape[-2]
        lost: Any = np.isnan(residuals).any(axis=-1)
        some = bool(lost.any())
        known = np.where(lost[..., None], 0.0, residuals) if some else residuals
        since = np.arange(count) - np.maximum.accumulate(np.where(starts, np.arange(count), 0))
        fresh = since < order
        white = self._innovations(known.reshape(-1, *shape[-2:])).reshape(shape)
        white /= self.innovation
        if not some:
            white[..., fresh, :] = known[..., fresh, :] / self.stationary
            return white
        fresh = np.broadcast_to(fresh, lost.shape).copy()
        for k in range(1, order + 1):
            fresh[..., k:] |= lost[..., :-k]
        scaled = np.where(fresh[..., None], known / self.stationary, white)
        return np.where(lost[..., None], 0.0, scaled)

    def _innovations(self, known: Array) -> Array:
        """r_k - Σ φ_i r_(k-i), shape (series, samples, width)."""
        white = np.array(known, dtype=np.float64)
        scratch = np.empty_like(white[:TOGETHER])
        for begin in range(0, len(white), TOGETHER):
            part, given = white[begin : begin + TOGETHER], known[begin : begin + TOGETHER]
            room = scratch[: len(part)]
            for k, phi in enumerate(self.coefficients[: known.shape[1] - 1], start=1):
                np.multiply(given[:, :-k], phi, out=room[:, k:])
                part[:, k:] -= room[:, k:]
        return white


def residuals_in_bins(white: Array, size: int) -> Array:
    """White residuals of successive samples, some in each bin: as white, and as wide.

    Where a prediction changes within one sample by no more than some deviations of the noise, when
    it does so is not told by its slope alone (the threshold of time delay estimation: Weiss and
    Weinstein, IEEE Transactions on Acoustics, Speech, and Signal Processing 31, 1983): the cost has
    an optimum wherever noise resembles the change.  Of the mean of some samples it is smooth.

    Args:
        white: Shape (..., samples, width).
        size: Samples of a bin; the last bin may have fewer.
    """
    if size == 1:
        return white
    begins = np.arange(0, white.shape[-2], size)
    counts = np.diff(np.append(begins, white.shape[-2]))
    return np.asarray(np.add.reduceat(white, begins, axis=-2) / np.sqrt(counts)[:, None])


def white_noise(deviation: Any, width: int) -> ChannelNoise:
    """White noise of a standard deviation."""
    sigma = np.broadcast_to(np.asarray(deviation, dtype=float), (width,)).copy()
    return ChannelNoise(np.empty(0), sigma, sigma)


def filtered_noise(deviation: float, covariances: Array, width: int) -> ChannelNoise:
    """White noise behind a filter.

    Args:
        deviation: Before it, standard, at the rate of the filter.
        covariances: Behind it, of a deviation of 1, from lag 0 on.
        width: Numbers of the channel.
    """
    phi = _behind_filter(covariances)
    share = 1.0 - float(phi @ covariances[1:]) / float(covariances[0])
    sigma = np.full(width, deviation * float(covariances[0]) ** 0.5)
    return ChannelNoise(phi, sigma * max(share, OWN) ** 0.5, sigma)


def estimated_noise(
    times: Array, values: Array, floor: float, filtered: Array | None = None
) -> ChannelNoise:
    """Noise about a smooth motion.

    A cubic polynomial is taken for the motion; the order of the autoregression is that of the least
    information criterion (Schwarz, Annals of Statistics 6, 1978), its coefficients are common to
    all numbers.

    Args:
        times: Before touch [s], shape (samples,).
        values: Shape (samples, width); NaN where lost.
        floor: Least standard deviation, of what the sensor resolves.
        filtered: Autocovariances, from lag 0 on, of white noise behind the channel's low-pass, if
            it is known: the noise is taken to be that if it explains the samples better.
    """
    known = ~np.isnan(values).any(axis=1)
    t, y = times[known], values[known]
    width = values.shape[1]
    if len(t) < FEWEST:
        return white_noise(floor, width)
    middle, half = 0.5 * (t[0] + t[-1]), max(0.5 * (t[-1] - t[0]), 1e-9)
    basis = np.polynomial.legendre.legvander((t - middle) / half, DEGREE)
    rest = y - basis @ np.linalg.lstsq(basis, y, rcond=None)[0]
    usual = np.maximum(np.median(np.abs(rest), axis=0) / MEDIAN, floor)
    calm = (np.abs(rest) < WILD * usual).all(axis=1)
    if FEWEST <= calm.sum() < len(t):  # a release, a jolt: not noise
        rest = (y - basis @ np.linalg.lstsq(basis[calm], y[calm], rcond=None)[0])[calm]
        t = t[calm]
    free = len(t) - DEGREE - 1
    sigma = np.maximum(np.sqrt((rest**2).sum(axis=0) / free), floor)
    moving = sigma > floor * (1.0 + 1e-9)
    if not moving.any():
        return white_noise(sigma, width)
    scaled = rest[:, moving] / sigma[moving]
    best, least = (np.empty(0), 1.0), 0.0
    samples, highest = scaled.size, min(HIGHEST_ORDER, len(scaled) // 4)
    unpredicted = _yule_walker(scaled, highest, WHITE_SHARE)[1]
    white = WHITE_SHARE if unpredicted < WELL_PREDICTED else 0.0
    for order in range(1, highest + 1):
        phi, share = _yule_walker(scaled, order, white)
        score = samples * np.log(max(share, 1e-12)) + order * np.log(samples)
        if score < least:
            best, least = (phi, share), score
    if filtered is not None:
        phi = _behind_filter(filtered)
        share = _left(scaled, phi)
        if samples * np.log(max(share, 1e-12)) < least:
            best = phi, share
    phi, share = best
    innovation = np.maximum(sigma * np.sqrt(max(share, 1e-12)), 1e-3 * floor)
    freedom = float(free * moving.sum())
    return ChannelNoise(phi, np.where(moving, innovation, sigma), sigma, freedom)


def _behind_filter(covariances: Array) -> Array:
    """Coefficients of white noise behind a filter, with a little white noise of its own."""
    r = covariances / covariances[0]
    order = len(r) - 1
    matrix = r[np.abs(np.subtract.outer(np.arange(order), np.arange(order)))]
    return np.asarray(np.linalg.solve(matrix + OWN * np.eye(order), r[1:]), dtype=float)


def _left(values: Array, phi: Array) -> float:
    """Share of the variance that coefficients leave of values."""
    order = len(phi)
    rest = values[order:].copy()
    for k, one in enumerate(phi, start=1):
        rest -= one * values[order - k : len(values) - k]
    return float((rest**2).mean() / (values**2).mean())


def _yule_walker(values: Array, order: int, white: float) -> tuple[Array, float]:
    """Coefficients, and the innovation's share of the variance (Yule 1927, Walker 1931).

    Args:
        values: Shape (samples, width).
        order: Number of coefficients.
        white: Share of the variance by which white noise is added.
    """
    count = len(values)
    sums = [float((values[k:] * values[: count - k]).sum()) for k in range(order + 1)]
    r = np.array(sums) / sums[0]
    r[1:] += (DEGREE + 1) / count  # what the polynomial, taken out, leaves of white noise
    matrix = r[np.abs(np.subtract.outer(np.arange(order), np.arange(order)))]
    phi = np.linalg.solve(matrix + max(white, 1e-9) * np.eye(order), r[1:])
    return np.asarray(phi, dtype=float), float(1.0 + white - phi @ r[1:])
