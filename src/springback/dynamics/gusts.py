"""Gusts: the Dryden turbulence of MIL-F-8785C, tick by tick.

MIL-F-8785C (1980), section 3.7.1.2, gives spectra over the wave number Ω along the flight path,

    Φ_u = σ_u² (2 L_u / π) / (1 + (L_u Ω)²)
    Φ_v = σ_v² (L_v / π) (1 + 3 (L_v Ω)²) / (1 + (L_v Ω)²)²        and Φ_w alike.

A frozen field in the air, crossed at a speed V, has with T = L / V the correlations

    σ² e^(−τ/T) along the wind,     σ² (1 − τ / 2T) e^(−τ/T) across it and vertically.

Sampled at every tick these are an AR(1) and an ARMA(2, 1) process with the double pole
a = e^(−h/T).  The filters here are these processes, so that variance and correlation are exact for
every tick length.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from springback.kernels.compiler import generic, kernel
from springback.kernels.vectors import Vec

FOOT = 0.3048  # [m]


class NoGusts(NamedTuple):
    """No gusts."""

    unused: float


class Longitudinal(NamedTuple):
    """Process u_k = a u_(k−1) + b n_k, of unit variance."""

    decay: float  # a
    now: float  # b


class Transverse(NamedTuple):
    """Process d_k = a d_(k−1) + n_k, y_k = a y_(k−1) + b₀ d_k + b₁ d_(k−1), y of unit variance."""

    decay: float  # a
    now: float  # b₀
    before: float  # b₁


class Dryden(NamedTuple):
    """Gusts in a horizontal mean wind: u along it, v to its left, w upwards."""

    intensity: Vec  # σ_u, σ_v, σ_w [m/s]
    along: Vec  # unit vector of the mean wind, world, horizontal
    u: Longitudinal
    v: Transverse
    w: Transverse


class Shaped(NamedTuple):
    """Memory of a transverse filter."""

    driven: float  # d
    value: float  # y


class GustMemory(NamedTuple):
    """Memory of all three filters, in units of the intensities."""

    u: float
    v: Shaped
    w: Shaped


class Gust(NamedTuple):
    """A gust and the memory for the next."""

    velocity: Vec  # world, to be added to the mean wind [m/s]
    memory: Any


def low_altitude(wind_at_6_m: float, altitude: float) -> tuple[Vec, Vec]:
    """Intensities σ [m/s] and scale lengths L [m] of u, v, w below 1000 ft.

    MIL-F-8785C, section 3.7.3.4 with figures 10 and 11, h in feet: σ_w = 0.1 W₂₀,
    σ_u = σ_v = σ_w / (0.177 + 0.000823 h)^0.4, L_w = h, L_u = L_v = h / (0.177 + 0.000823 h)^1.2.

    Args:
        wind_at_6_m: W₂₀, mean wind at 20 ft [m/s].
        altitude: Above the ground [m]; the formulas hold from 10 to 1000 ft.
    """
    factor = 0.177 + 0.000823 * altitude / FOOT
    vertical = 0.1 * wind_at_6_m
    level, length = vertical / factor**0.4, altitude / factor**1.2
    return Vec(level, level, vertical), Vec(length, length, altitude)


def longitudinal(ratio: float) -> Longitudinal:
    """Filter with the correlation e^(−|k| x), where x = h / T is the tick over the time scale."""
    return Longitudinal(math.exp(-ratio), math.sqrt(-math.expm1(-2.0 * ratio)))


def transverse(ratio: float) -> Transverse:
    """Filter with the correlation (1 − |k| x / 2) e^(−|k| x), x = h / T.

    With a = e^(−x), (1 − a z⁻¹)² y is a moving average b₀ n_k + b₁ n_(k−1).  Its spectrum at z = 1
    and z = −1 is that of y, the sum of all correlations, times (1 ∓ a)⁴; hence
    (b₀ ± b₁)² = (1 ∓ a)² (1 − a² ∓ x a).
    """
    a, x = math.exp(-ratio), ratio
    total = -math.expm1(-x) * math.sqrt(-math.expm1(-2.0 * x) - x * a)
    difference = (1.0 + a) * math.sqrt(-math.expm1(-2.0 * x) + x * a)
    return Transverse(a, 0.5 * (total + difference), 0.5 * (total - difference))


def dryden(intensity: Vec, scale: Vec, airspeed: float, tick: float, along: Vec) -> Dryden:
    """Gust filters for ticks of one length.

    Args:
        intensity: σ_u, σ_v, σ_w [m/s].
        scale: L_u, L_v, L_w [m].
        airspeed: Speed V relative to the frozen field [m/s].
        tick: Duration of a tick [s].
        along: Unit vector of the mean wind, world, horizontal.
    """
    x = [airspeed * tick / length for length in scale]
    return Dryden(intensity, along, longitudinal(x[0]), transverse(x[1]), transverse(x[2]))


@kernel
def shaped_noise(f: Transverse, noise: float, memory: Shaped) -> Shaped:
    """One tick of a transverse filter."""
    driven = f.decay * memory.driven + noise
    return Shaped(driven, f.decay * memory.value + f.now * driven + f.before * memory.driven)


@kernel
def shaped_at_first(f: Transverse, noise: float, other: float) -> Shaped:
    """Stationary state of a transverse filter, from two normal numbers.

    With V = ⟨d²⟩ = 1 / (1 − a²) the recursion gives ⟨d y⟩ = (a (a b₀ + b₁) V + b₀) V; ⟨y²⟩ = 1.
    """
    a = f.decay
    variance = 1.0 / (1.0 - a * a)
    common = (a * (a * f.now + f.before) * variance + f.now) * variance
    spread = math.sqrt(variance)
    share = common / spread
    return Shaped(spread * noise, share * noise + math.sqrt(1.0 - share * share) * other)


@kernel
def gust_velocity(weather: Dryden, memory: GustMemory) -> Vec:
    """Gust velocity in world axes [m/s]."""
    s, e = weather.intensity, weather.along
    u, v = s.x * memory.u, s.y * memory.v.value
    return Vec(u * e.x - v * e.y, u * e.y + v * e.x, s.z * memory.w.value)


@generic
def first_gust(weather: Any, noise: tuple[float, ...]) -> Gust:
    """Gust before the first tick, drawn from the stationary distribution.

    Args:
        weather: `NoGusts` or `Dryden`.
        noise: Five independent standard normal numbers.
    """
    raise TypeError(f"{type(weather).__name__} is not a model of gusts; register first_gust for it")


@first_gust.register(NoGusts)
@kernel
def _first_calm(weather: NoGusts, noise: tuple[float, ...]) -> Gust:
    return Gust(Vec(0.0, 0.0, 0.0), 0.0)


@first_gust.register(Dryden)
@kernel
def _first_of_dryden(weather: Dryden, noise: tuple[float, ...]) -> Gust:
    v = shaped_at_first(weather.v, noise[1], noise[2])
    w = shaped_at_first(weather.w, noise[3], noise[4])
    memory = GustMemory(noise[0], v, w)
    return Gust(gust_velocity(weather, memory), memory)


@generic
def gust(weather: Any, noise: tuple[float, ...], memory: Any) -> Gust:
    """Gust one tick later.

    Args:
        weather: `NoGusts` or `Dryden`.
        noise: Three independent standard normal numbers, drawn for this tick.
        memory: Memory of the previous gust.
    """
    raise TypeError(f"{type(weather).__name__} is not a model of gusts; register gust for it")


@gust.register(NoGusts)
@kernel
def _no_gust(weather: NoGusts, noise: tuple[float, ...], memory: Any) -> Gust:
    return Gust(Vec(0.0, 0.0, 0.0), memory)


@gust.register(Dryden)
@kernel
def _dryden_gust(weather: Dryden, noise: tuple[float, ...], memory: GustMemory) -> Gust:
    u = weather.u.decay * memory.u + weather.u.now * noise[0]
    v, w = shaped_noise(weather.v, noise[1], memory.v), shaped_noise(weather.w, noise[2], memory.w)
    then = GustMemory(u, v, w)
    return Gust(gust_velocity(weather, then), then)
