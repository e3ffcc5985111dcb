"""Laws of normal force: never adhesive, and every joule of their work accounted for."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from builders.scenes import surface
from springback.contact.surfaces import Surface, elastic_energy, normal_force, power

LAWS = {
    "Hunt-Crossley": surface(dissipation=0.65),
    "Hunt-Crossley, n = 1": surface(dissipation=0.65, exponent=1.0),
    "Hunt-Crossley, n = 2": surface(dissipation=0.65, exponent=2.0),
    "Hertz": surface(),
    "Kelvin-Voigt": surface(exponent=1.0, viscosity=120.0),
}
laws = pytest.mark.parametrize("law", LAWS.values(), ids=LAWS.keys())
depths = st.floats(1e-6, 0.05)
rates = st.floats(-6.0, 6.0)


@laws
@given(depth=depths, rate=rates)
def test_never_pulls_and_never_gains(law: Surface, depth: float, rate: float) -> None:
    """The force pushes or is zero, and what damping takes is never negative."""
    now = normal_force(law, depth, rate, 0.0)
    assert now.force >= 0.0
    assert now.loss >= 0.0


@laws
@given(rate=rates)
def test_apart_means_no_force(law: Surface, rate: float) -> None:
    """Nothing acts on a cage that does not touch, however fast it moves."""
    assert normal_force(law, 0.0, rate, 0.0) == (0.0, 0.0, 0.0, 0.0)


@laws
@given(depth=depths, rate=rates)
def test_work_is_stored_or_lost(law: Surface, depth: float, rate: float) -> None:
    """f δ̇ = d/dt (elastic energy) + loss, with the derivative taken numerically."""
    h = 1e-4 * depth
    slope = (elastic_energy(law, depth + h) - elastic_energy(law, depth - h)) / (2.0 * h)
    now = normal_force(law, depth, rate, 0.0)
    scale = slope * abs(rate) + now.loss
    assert now.force * rate == pytest.approx(slope * rate + now.loss, abs=1e-7 * scale)


@given(depth=depths, rate=st.floats(0.0, 6.0))
def test_laws_by_formula(depth: float, rate: float) -> None:
    """Pressing in: k δⁿ (1 + d δ̇), k δⁿ, and k δ + b δ̇."""
    k, d, b = 1e5, 0.65, 120.0
    for n in (1.0, 1.5, 2.0):
        crossley = surface(stiffness=k, dissipation=d, exponent=n)
        hertz = surface(stiffness=k, exponent=n)
        assert normal_force(hertz, depth, rate, 0.0).force == pytest.approx(k * depth**n)
        expected = k * depth**n * (1.0 + d * rate)
        assert normal_force(crossley, depth, rate, 0.0).force == pytest.approx(expected)
    voigt = surface(stiffness=k, exponent=1.0, viscosity=b)
    assert normal_force(voigt, depth, rate, 0.0).force == pytest.approx(k * depth + b * rate)


@given(depth=depths, faster=st.floats(1e-3, 6.0))
def test_damping_pushes_harder_going_in_than_coming_out(depth: float, faster: float) -> None:
    """The sign of the damping term; as printed it is the other way round, and feeds energy."""
    law = LAWS["Hunt-Crossley"]
    still = normal_force(law, depth, 0.0, 0.0).force
    assert normal_force(law, depth, faster, 0.0).force > still
    assert normal_force(law, depth, -faster, 0.0).force < still


@given(depth=depths)
def test_special_exponents_are_powers(depth: float) -> None:
    """The fast paths for n = 1 and n = 3/2 are the power function."""
    for n in (1.0, 1.5):
        assert power(surface(exponent=n).exponent, depth) == pytest.approx(depth**n, rel=1e-14)
