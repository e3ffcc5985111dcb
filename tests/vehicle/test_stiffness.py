"""Stiffness from material and shape, against the mechanics that it stands for."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from builders.cases import nonempty
from springback.errors import InputError
from springback.vehicle.stiffness import (
    cantilever_stiffness,
    contact_modulus,
    hertz_stiffness,
    pad_stiffness,
    ring_stiffness,
    rod_second_moment,
    series_stiffness,
    shell_stiffness,
)


def test_a_ring_by_castigliano() -> None:
    """δ = ∂U/∂F of a quarter of the ring, whose moment at the load follows from its symmetry."""
    young, second, radius, force = 3e9, 2e-12, 0.11, 7.0

    def energy(f: float, m: float) -> float:
        # Moment along the quarter, from the side (angle 0) to the load: m − f r (1 − cos a)/2.
        found: float = quad(
            lambda a: (m - 0.5 * f * radius * (1.0 - math.cos(a))) ** 2, 0.0, 0.5 * math.pi
        )[0]
        return 4.0 * found * radius / (2.0 * young * second)

    def slope(m: float) -> float:  # the section at the side does not turn: ∂U/∂m = 0
        return energy(force, m + 1e-3) - energy(force, m - 1e-3)

    moment = brentq(slope, -10.0, 10.0, xtol=1e-12)
    h = 1e-3 * force
    deflection = (energy(force + h, moment) - energy(force - h, moment)) / (2.0 * h)
    assert ring_stiffness(young, second, radius) == pytest.approx(force / deflection, rel=1e-6)
    assert ring_stiffness(1.0, 1.0, 1.0) == pytest.approx(6.72, abs=0.01)


def test_a_cantilever_by_its_beam() -> None:
    """w″ = F (l − x)/EI, integrated twice."""
    young, second, length, force = 70e9, rod_second_moment(0.004, 0.003), 0.22, 3.0
    x = np.linspace(0.0, length, 20001)
    slope = np.concatenate(
        [[0.0], np.cumsum(0.5 * np.diff(x) * (2 * length - x[1:] - x[:-1]))]
    ) * force / (young * second)  # fmt: skip
    end = float(np.sum(0.5 * np.diff(x) * (slope[1:] + slope[:-1])))
    assert cantilever_stiffness(young, second, length) == pytest.approx(force / end, rel=1e-6)


def test_hertz_by_the_pressure_of_a_half_space() -> None:
    """p₀ √(1 − r²/a²) on a circle a: its force, its depth at the middle and the sphere's shape."""
    modulus, radius, depth = 2e9, 0.05, 1e-4
    a = math.sqrt(radius * depth)
    pressure = 2.0 * modulus * a / (math.pi * radius)
    middle = quad(lambda r: pressure * math.sqrt(1.0 - (r / a) ** 2) * 2.0 * math.pi * r
                  / (math.pi * modulus * r), 0.0, a)[0]  # fmt: skip
    assert middle == pytest.approx(depth, rel=1e-6)
    force = quad(lambda r: pressure * math.sqrt(1.0 - (r / a) ** 2) * 2.0 * math.pi * r, 0.0, a)[0]
    assert hertz_stiffness(modulus, radius) * depth**1.5 == pytest.approx(force, rel=1e-6)


def test_moduli_and_springs_add_as_compliances() -> None:
    assert contact_modulus(3e9, 0.35) == pytest.approx(3e9 / (1.0 - 0.35**2))
    both = contact_modulus(3e9, 0.35, 30e9, 0.2)
    assert both < contact_modulus(3e9, 0.35)
    assert contact_modulus(30e9, 0.2, 3e9, 0.35) == pytest.approx(both)
    assert series_stiffness(2e3, 2e3) == pytest.approx(1e3)
    k, n = (3e5, 1e5, 7e4), 1.5
    force = 12.0
    depth = sum((force / one) ** (1.0 / n) for one in k)
    assert series_stiffness(*k, exponent=n) == pytest.approx(force / depth**n, rel=1e-12)
    assert series_stiffness(5.0, exponent=0.7) == pytest.approx(5.0)


def test_pads_tubes_and_shells() -> None:
    assert pad_stiffness(4e6, 0.01, 0.03) == pytest.approx(4e6 * 0.01 / 0.03)
    x = np.linspace(-0.002, 0.002, 200001)
    chord = 2.0 * np.sqrt(0.002**2 - x**2) - 2.0 * np.sqrt(np.maximum(0.0015**2 - x**2, 0.0))
    assert rod_second_moment(0.004, 0.003) == pytest.approx(np.trapezoid(x**2 * chord, x), rel=1e-5)
    assert shell_stiffness(1.0, 0.0, 1.0, 1.0) == pytest.approx(2.31, abs=0.001)
    assert shell_stiffness(2e9, 0.3, 2e-3, 0.2) == pytest.approx(
        4.0 * shell_stiffness(2e9, 0.3, 1e-3, 0.2)
    )


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: hertz_stiffness(-1.0, 0.1), "modulus must be more than 0 and finite (got -1)"),
        (lambda: ring_stiffness(1e9, 1e-12, 0.0), "radius must be more than 0"),
        (lambda: shell_stiffness(1e9, 0.6, 1e-3, 0.2), "poisson must be more than -1 and at most"),
        (lambda: contact_modulus(1e9, 0.3, 0.0), "other_young must be more than 0 (got 0)"),
        (lambda: rod_second_moment(0.004, 0.004), "inner must be at least 0 and less than 0.004 m"),
        (lambda: series_stiffness(), "stiffness must be given"),
        (lambda: series_stiffness(1.0, math.nan), "stiffness 2 must be more than 0"),
    ],
)
def test_what_is_no_body_is_refused(call: object, message: str) -> None:
    with pytest.raises(InputError) as caught:
        call()  # type: ignore[operator]
    assert caught.value.problems[0].startswith(message)


def test_arguments_are_numbers_or_text_with_a_unit() -> None:
    section = rod_second_moment("4 mm", "3 mm")
    assert section == pytest.approx(rod_second_moment(0.004, 0.003), rel=1e-12)
    assert ring_stiffness("120 GPa", section, "11 cm") == pytest.approx(
        ring_stiffness(120e9, section, 0.11), rel=1e-12
    )
    assert series_stiffness("5 N/mm", 5e3) == pytest.approx(2.5e3)
    wrongs: list[tuple[Callable[[], float], str]] = [
        (
            lambda: ring_stiffness("120 N", 1e-9, 0.11),
            r"^young has the wrong unit .*; expected Pa$",
        ),
        (lambda: ring_stiffness("120", 1e-9, 0.11), r"^young has no unit .*; expected Pa$"),
        (lambda: rod_second_moment("-4 mm"), "^diameter must be more than 0"),
        (lambda: series_stiffness("5 N"), r"^stiffness 1 has the wrong unit .*expected N/m$"),
    ]
    for wrong, said in nonempty(wrongs):
        with pytest.raises(InputError, match=said):
            wrong()
