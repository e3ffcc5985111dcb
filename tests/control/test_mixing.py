"""Mixing: exact where it fits, within limits always, and giving way in the promised order."""

from __future__ import annotations

import numba
import numpy as np
import pytest
from scipy.optimize import linprog

from springback.control.mixing import allocation, mixer, rotor_thrusts, wrench_of
from springback.control.target import Wrench
from springback.kernels.trees import leaves
from springback.kernels.vectors import Vec
from springback.vehicle.library import VEHICLES
from springback.vehicle.parameters import Arms, Body, Vehicle
from springback.vehicle.state import Airframe

ARQ: Airframe = VEHICLES["arq"].vehicle.airframe()
LOWEST, HIGHEST = 0.2, 7.0
AIRMODE = 100.0  # [N], more than the rotors can give
FREE = (0.19,) * 4


def hexarotor() -> Airframe:
    arms = Arms(
        directions=tuple(np.deg2rad([30, 90, 150, 210, 270, 330]).tolist()),
        length=0.25,
        mass=0.05,
        cage_radius=0.1,
        torque_ratio=0.016,
    )
    return Vehicle(body=Body(mass=1.0, inertia=(0.01, 0.01, 0.02)), arms=arms).airframe()


def effectiveness(airframe: Airframe, lengths: tuple[float, ...]) -> np.ndarray:
    """B(l) from cross products, as in eq. (10)."""
    columns = []
    for arm, length in zip(airframe.arms, lengths, strict=True):
        lever = length * np.array([arm.cosine, arm.sine, 0.0])
        moment = np.add(np.cross(lever, [0.0, 0.0, 1.0]), [0.0, 0.0, arm.torque_ratio])
        columns.append([1.0, *moment])
    return np.array(columns).T


def random_lengths(rng: np.random.Generator, count: int = 4) -> tuple[float, ...]:
    return tuple(float(l) for l in rng.uniform(0.14, 0.19, count))


def random_wrench(rng: np.random.Generator, size: float) -> Wrench:
    m = rng.normal(0.0, size, 3) * [1.0, 1.0, 0.1]
    return Wrench(float(rng.uniform(0.0, 28.0)), Vec(*(float(c) for c in m)))


def test_paper_matrix() -> None:
    """Eq. (2), entry by entry, with L* = L/√2."""
    star, c = 0.19 / np.sqrt(2.0), 0.016
    printed = [[1, 1, 1, 1], [star, -star, -star, star], [-star, -star, star, star], [-c, c, -c, c]]
    for j in range(4):
        thrusts = tuple(1.0 if k == j else 0.0 for k in range(4))
        np.testing.assert_allclose(
            leaves(wrench_of(ARQ, FREE, thrusts)), np.array(printed)[:, j], atol=1e-15
        )


def test_allocation_is_the_inverse_for_any_arm_lengths() -> None:
    rng = np.random.default_rng(1)
    for _ in range(200):
        lengths, wrench = random_lengths(rng), random_wrench(rng, 1.0)
        thrusts = allocation(mixer(ARQ, lengths), wrench)
        np.testing.assert_allclose(
            thrusts,
            np.linalg.solve(effectiveness(ARQ, lengths), leaves(wrench)),
            rtol=1e-9,
            atol=1e-9,
        )
        np.testing.assert_allclose(
            leaves(wrench_of(ARQ, lengths, thrusts)), leaves(wrench), atol=1e-11
        )


def test_six_rotors_share_with_least_norm() -> None:
    rng, airframe = np.random.default_rng(2), hexarotor()
    for _ in range(100):
        lengths, wrench = random_lengths(rng, 6), random_wrench(rng, 1.0)
        expected = np.linalg.pinv(effectiveness(airframe, lengths)) @ leaves(wrench)
        np.testing.assert_allclose(
            allocation(mixer(airframe, lengths), wrench), expected, atol=1e-9
        )


def test_without_rotor_torque_yaw_is_left_out() -> None:
    """All else is still met; nothing is divided by zero."""
    arms = tuple(arm._replace(torque_ratio=0.0) for arm in ARQ.arms)
    airframe = ARQ._replace(arms=arms)
    wrench = Wrench(14.0, Vec(0.3, -0.2, 0.5))
    for thrusts in (
        allocation(mixer(airframe, FREE), wrench),
        rotor_thrusts(mixer(airframe, FREE), 0.0, 7.0, wrench, 0.0),
    ):
        np.testing.assert_allclose(
            leaves(wrench_of(airframe, FREE, thrusts)), [14.0, 0.3, -0.2, 0.0], atol=1e-12
        )


@pytest.mark.parametrize("airframe", [ARQ, hexarotor()], ids=["four", "six"])
def test_exact_where_it_fits_and_within_limits_always(airframe: Airframe) -> None:
    rng, fitting = np.random.default_rng(3), 0
    for _ in range(1000):
        lengths = random_lengths(rng, len(airframe.arms))
        wrench = random_wrench(rng, float(rng.choice([0.1, 0.5, 3.0])))
        plain = np.array(allocation(mixer(airframe, lengths), wrench))
        thrusts = np.array(
            rotor_thrusts(mixer(airframe, lengths), LOWEST, HIGHEST, wrench, AIRMODE)
        )
        assert thrusts.min() >= LOWEST
        assert thrusts.max() <= HIGHEST
        if plain.min() >= LOWEST and plain.max() <= HIGHEST:
            fitting += 1
            np.testing.assert_allclose(thrusts, plain, rtol=1e-12, atol=1e-12)
    assert 100 < fitting < 900


def greatest_share(lengths: tuple[float, ...], wrench: Wrench) -> tuple[float, float, float]:
    """By linear programming: most of the tilting moment at zero yaw, and the collectives for it."""
    b = effectiveness(ARQ, lengths)
    m = wrench.moment
    # Unknowns: four thrusts, share s. Moments: roll and pitch s M, yaw none.
    equal = np.column_stack([b[1:], [-m.x, -m.y, 0.0]])
    bounds = [(LOWEST, HIGHEST)] * 4 + [(0.0, 1.0)]
    best = linprog([0, 0, 0, 0, -1], A_eq=equal, b_eq=np.zeros(3), bounds=bounds)
    share = -best.fun
    fixed = equal[:, 4] * share
    ends = [
        sign
        * linprog(
            sign * b[0], A_eq=b[1:], b_eq=-fixed, bounds=[(LOWEST - 1e-9, HIGHEST + 1e-9)] * 4
        ).fun
        for sign in (1.0, -1.0)
    ]
    return share, ends[0], ends[1]


def test_yaw_gives_way_first_then_collective_and_roll_and_pitch_last() -> None:
    """Direction kept; no more lost than must be; collective shifted no further than must be."""
    rng, shrunk, shifted, turned = np.random.default_rng(4), 0, 0, 0
    for _ in range(80):
        lengths, wrench = random_lengths(rng), random_wrench(rng, 1.0)
        plain = allocation(mixer(ARQ, lengths), wrench)
        if min(plain) >= LOWEST and max(plain) <= HIGHEST:
            continue
        given = wrench_of(
            ARQ, lengths, rotor_thrusts(mixer(ARQ, lengths), LOWEST, HIGHEST, wrench, AIRMODE)
        )
        share, low, high = greatest_share(lengths, wrench)
        m, got = wrench.moment, given.moment
        np.testing.assert_allclose([got.x, got.y], [share * m.x, share * m.y], atol=1e-7)
        assert given.thrust == pytest.approx(float(np.clip(wrench.thrust, low, high)), abs=1e-5)
        part = got.z / m.z
        assert -1e-7 <= part <= 1.0 + 1e-7
        shrunk += share < 1.0 - 1e-9
        shifted += share == pytest.approx(1.0) and abs(given.thrust - wrench.thrust) > 1e-6
        turned += abs(given.thrust - wrench.thrust) < 1e-9 and 0.01 < part < 0.99
    assert min(shrunk, shifted, turned) > 5


def test_no_worse_than_clipping_where_roll_and_pitch_are_within_reach() -> None:
    """Clipping each rotor bends the moment; mixing meets it, or at least keeps its direction."""
    rng, better = np.random.default_rng(5), 0
    for _ in range(80):
        wrench = random_wrench(rng, 0.7)
        clipped = tuple(min(max(t, LOWEST), HIGHEST) for t in allocation(mixer(ARQ, FREE), wrench))
        given = wrench_of(
            ARQ, FREE, rotor_thrusts(mixer(ARQ, FREE), LOWEST, HIGHEST, wrench, AIRMODE)
        ).moment
        bent = wrench_of(ARQ, FREE, clipped).moment
        m = wrench.moment
        share, _, _ = greatest_share(FREE, wrench)
        error = np.hypot(given.x - m.x, given.y - m.y)
        if share >= 1.0 - 1e-12:
            assert error < 1e-9
            better += np.hypot(bent.x - m.x, bent.y - m.y) > 1e-3
        assert abs(given.x * m.y - given.y * m.x) < 1e-9
    assert better > 10


def test_without_airmode_roll_and_pitch_never_raise_the_thrust_beyond_the_lift() -> None:
    """By linear programming: most of the moment under a collective of at most what is allowed."""
    rng, tight = np.random.default_rng(7), 0
    for lift in (0.0, 2.0, 6.0):
        for _ in range(60):
            lengths, wrench = random_lengths(rng), random_wrench(rng, 1.0)
            wrench = wrench._replace(thrust=float(rng.uniform(1.5, 4.0)))
            most = max(wrench.thrust, lift)
            given = wrench_of(
                ARQ, lengths, rotor_thrusts(mixer(ARQ, lengths), LOWEST, HIGHEST, wrench, lift)
            )
            assert given.thrust <= most + 1e-9
            b, m = effectiveness(ARQ, lengths), wrench.moment
            equal = np.column_stack([b[1:], [-m.x, -m.y, 0.0]])
            best = linprog(
                [0, 0, 0, 0, -1], A_eq=equal, b_eq=np.zeros(3), A_ub=[[*b[0], 0.0]], b_ub=[most],
                bounds=[(LOWEST, HIGHEST)] * 4 + [(0.0, 1.0)],
            )  # fmt: skip
            np.testing.assert_allclose([given.moment.x, given.moment.y],
                                       [-best.fun * m.x, -best.fun * m.y], atol=1e-7)  # fmt: skip
            tight += -best.fun < 1.0 - 1e-9
    assert tight > 30


def test_plain_python_is_the_compiled_mixing() -> None:
    @numba.njit
    def compiled(airframe, lengths, wrench):  # type: ignore[no-untyped-def]
        return rotor_thrusts(mixer(airframe, lengths), LOWEST, HIGHEST, wrench, AIRMODE)

    rng = np.random.default_rng(6)
    for _ in range(200):
        lengths, wrench = random_lengths(rng), random_wrench(rng, 1.0)
        assert compiled(ARQ, lengths, wrench) == rotor_thrusts(
            mixer(ARQ, lengths), LOWEST, HIGHEST, wrench, AIRMODE
        )
