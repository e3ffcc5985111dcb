"""The vehicles of the paper against its tables, and what follows from them."""

from __future__ import annotations

import math

import numpy as np
import pytest

from builders.cases import nonempty
from springback.vehicle.library import VEHICLES
from springback.vehicle.parameters import Arms, Body, Vehicle

BATTERY = 0.37  # [kg] from the printed hover times
#: Table I: weight without battery [kg]; I_xx, I_yy, I_zz [kg m²].
TABLE_1 = {"arq": (1.034, (0.0100, 0.0116, 0.0197)), "quad": (0.844, (0.0092, 0.0107, 0.0179))}


def vehicle(name: str) -> Vehicle:
    """A vehicle of the library."""
    return VEHICLES[name].vehicle


@pytest.mark.parametrize("name", ["arq", "quad"])
def test_weight_of_table_1(name: str) -> None:
    """Printed weight without battery, plus the battery."""
    assert vehicle(name).mass == pytest.approx(TABLE_1[name][0] + BATTERY)


@pytest.mark.parametrize("name", ["arq", "quad"])
def test_inertia_of_table_1(name: str) -> None:
    """With the arms at rest length, the printed moments of the whole vehicle."""
    assert np.allclose(vehicle(name).inertia(), np.diag(TABLE_1[name][1]), atol=1e-12)


def test_flying_masses() -> None:
    """1.41 and 1.22 kg in the notes on the hover time, to their two decimals."""
    assert vehicle("arq").mass == pytest.approx(1.41, abs=0.01)
    assert vehicle("quad").mass == pytest.approx(1.22, abs=0.01)


@pytest.mark.parametrize("name", ["arq", "quad", "arq-slider", "quad-slider", "arq-lumped"])
def test_geometry_of_table_1(name: str) -> None:
    """L = 0.19 m, and cage tips 0.60 m apart."""
    arms = vehicle(name).arms
    assert arms.at("length", 0) == 0.19
    assert 2.0 * (arms.at("length", 0) + arms.at("cage_radius", 0)) == pytest.approx(0.60)


def test_table_2() -> None:
    """m_b, m_a, m_rigid, k_l and b_l of the slider tests."""
    arq, quad = vehicle("arq-slider"), vehicle("quad-slider")
    assert arq.body.mass == 1.882
    assert sum(arq.arms.at("mass", j) for j in range(4)) == pytest.approx(0.2)
    assert arq.mass == pytest.approx(2.082)
    assert quad.mass == 1.892
    assert (arq.arms.stiffness, arq.arms.damping) == (5e3, 90.0)
    assert arq.is_compliant
    assert not quad.is_compliant
    assert not arq.arms.end_stops
    # What the slider adds is the same for both robots: m_b + 4 m_a - m_rigid is their difference.
    assert arq.mass - quad.mass == pytest.approx(1.034 - 0.844)


def test_reading_a_is_one_mass_of_200_grams() -> None:
    """One lumped mass on one spring along X."""
    lumped = vehicle("arq-lumped")
    assert lumped.arm_count == 1
    assert lumped.arms.directions == (0.0,)
    assert (lumped.body.mass, lumped.arms.at("mass", 0)) == (1.882, 0.2)


def test_layout_is_that_of_section_3() -> None:
    """e_1 = (1, 1)/√2 and e_2 = (1, −1)/√2, the others opposite."""
    directions = [(arm.cosine, arm.sine) for arm in vehicle("arq").airframe().arms]
    s = math.sqrt(0.5)
    assert np.allclose(directions, [(s, s), (s, -s), (-s, -s), (-s, s)])


def test_every_number_has_a_source() -> None:
    """Each source says whether it is given, derived, fitted or chosen."""
    for entry in nonempty(VEHICLES.values()):
        assert "body.mass" in entry.sources
        for text in entry.sources.values():
            assert (
                text.split(":")[0] in {"given", "derived", "fitted", "chosen"} or "as flown" in text
            )


def many_arms(count: int) -> Vehicle:
    """A regular vehicle of some arms."""
    directions = tuple(2.0 * math.pi * j / count for j in range(count))
    body = Body(mass=1.0, inertia=(0.01, 0.011, 0.02))
    return Vehicle(
        body=body, arms=Arms(directions=directions, length=0.2, mass=0.05, cage_radius=0.08)
    )


@pytest.mark.parametrize("count", [1, 3, 6])
def test_inertia_is_the_sum_over_point_masses(count: int) -> None:
    """inertia(l) = I + Σ m l² (1 − e eᵀ), for any number of arms and any lengths."""
    craft = many_arms(count)
    lengths = tuple(0.15 + 0.01 * j for j in range(count))
    expected = np.diag([0.01, 0.011, 0.02])
    for angle, length in zip(craft.arms.directions, lengths, strict=True):
        r = length * np.array([math.cos(angle), math.sin(angle), 0.0])
        expected += 0.05 * (r @ r * np.eye(3) - np.outer(r, r))
    assert np.allclose(craft.inertia(lengths), expected, atol=1e-15)
    assert craft.mass == pytest.approx(1.0 + 0.05 * count)


@pytest.mark.parametrize("count", [3, 6])
def test_regular_arms_add_no_preferred_direction(count: int) -> None:
    """Three or more equal arms add ½ n m L² about x and y, and n m L² about z."""
    share = many_arms(count).inertia() - np.diag([0.01, 0.011, 0.02])
    expected = count * 0.05 * 0.2**2 * np.diag([0.5, 0.5, 1.0])
    assert np.allclose(share, expected, atol=1e-15)


def test_one_entry_for_each_arm() -> None:
    """Numbers may differ from arm to arm, and land on the right arm."""
    arms = Arms(
        directions=(0.0, 2.0, 4.0), length=(0.19, 0.2, 0.21), mass=(0.05, 0.06, 0.0), cage_radius=0.1,
        compliant=(True, True, False), stiffness=(1e3, 2e3, 3e3), stroke=(0.02, 0.03, 0.04),
        torque_ratio=0.016,
    )  # fmt: skip
    built = Vehicle(body=Body(mass=1.0, inertia=(0.01, 0.01, 0.02)), arms=arms).airframe()
    assert [arm.length for arm in built.arms] == [0.19, 0.2, 0.21]
    assert [arm.stiffness for arm in built.arms] == [1e3, 2e3, 3e3]
    assert [arm.compliance for arm in built.arms] == [1.0, 1.0, 0.0]
    assert [arm.shortest for arm in built.arms] == pytest.approx([0.17, 0.17, 0.17])
    assert [arm.torque_ratio for arm in built.arms] == [-0.016, 0.016, -0.016]
    assert built.mass == pytest.approx(1.11)


def test_end_stops_are_one_switch() -> None:
    """Off, the stops have no stiffness at all."""
    arq = vehicle("arq")
    loose = arq.model_copy(update={"arms": arq.arms.model_copy(update={"end_stops": False})})
    assert all(arm.stop_stiffness == 0.0 for arm in loose.airframe().arms)
    assert all(arm.stop_stiffness > 0.0 for arm in arq.airframe().arms)
