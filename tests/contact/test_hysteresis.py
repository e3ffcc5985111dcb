"""Laws with a memory: what comes out returns a fixed share of what was put in, and never pulls."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq

from builders.cases import nonempty
from springback.contact.hulls.series import hull_law, in_series
from springback.contact.laws.hysteresis import (
    HystereticLoad,
    Pressing,
    hysteretic_energy,
    hysteretic_load,
    next_corner,
    next_memory,
    no_point,
)
from springback.contact.parameters import SurfaceSettings
from springback.contact.surfaces import (
    AnyExponent,
    Surface,
    elastic_energy,
    normal_force,
    power,
    steepest,
)
from springback.errors import InputError
from springback.kernels.vectors import Vec
from springback.vehicle.force_laws import REMEMBERING, HullSurface
from springback.vehicle.state import PressedPoints

PLACE, INWARD = Vec(0.1, 0.02, 0.0), Vec(1.0, 0.0, 0.0)
#: Measured: yields at 40 N, is pressed together from 10 mm on, and comes out far below.
LOADING = [[0, 0], ["2 mm", "40 N"], ["10 mm", "60 N"], ["14 mm", "400 N"]]
UNLOADING = [["3 mm", "0 N"], ["10 mm", "20 N"], ["14 mm", "400 N"]]
LAWS: dict[str, dict[str, Any]] = {
    "linear": {"law": "constant-restitution", "stiffness": 2e4, "exponent": 1.0, "restitution": 0.2},
    "hertzian": {"law": "constant-restitution", "restitution": 0.6},
    "softening": {
        "law": "constant-restitution", "stiffness": 40.0, "exponent": 0.54, "restitution": 0.9,
    },
    "foam": {
        "law": "foam", "stiffness": 2e4, "plateau_force": "50 N", "densification_depth": "12 mm",
        "restitution": 0.3,
    },
    "table": {"law": "table", "loading": LOADING, "unloading": UNLOADING},
    "one branch": {"law": "table", "loading": LOADING, "restitution": 0.5},
    "elastic table": {"law": "table", "loading": LOADING},
}  # fmt: skip


def surface(**given: Any) -> Surface:
    return SurfaceSettings.model_validate(given).surface(AnyExponent, in_scene=True)


def no_memory(points: int = 3) -> PressedPoints:
    return PressedPoints(0.0, (no_point(),) * points)


def load(of: Surface, memory: PressedPoints, depth: float, rate: float = 0.0) -> HystereticLoad:
    elastic = normal_force(of, depth, rate, 1e-5)
    return hysteretic_load(memory, elastic, Pressing(of, PLACE, INWARD, depth, rate, 1e-5))


def pressed_to(of: Surface, depth: float) -> PressedPoints:
    """Memory of a contact that was as deep as this."""
    return next_memory(no_memory(), (load(of, no_memory(), depth).point, no_point(), no_point()))


def going_in(of: Surface, depth: float) -> float:
    return load(of, no_memory(), depth).force.force


def coming_out(of: Surface, deepest: float, depth: float) -> float:
    return load(of, pressed_to(of, deepest), depth).force.force


def stored(of: Surface, memory: PressedPoints, depth: float) -> float:
    at = Pressing(of, PLACE, INWARD, depth, 0.0, 0.0)
    return hysteretic_energy(elastic_energy(of, depth), memory, at)


def work(force: Any, deepest: float) -> float:
    """Integral of a force from 0 to a depth."""
    kinks = [x for x in (1e-4, 2e-3, 2.5e-3, 1e-2, 1.2e-2, 1.4e-2) if x < deepest]
    found: float = quad(force, 0.0, deepest, points=kinks, limit=400, epsabs=1e-12)[0]
    return found


def share_returned(name: str) -> float:
    if "restitution" in LAWS[name]:
        return float(LAWS[name]["restitution"]) ** 2
    return 1.0 if name == "elastic table" else work_ratio_of_table()


def work_ratio_of_table() -> float:
    of = surface(**LAWS["table"])
    return work(lambda x: coming_out(of, 0.014, x), 0.014) / work(lambda x: going_in(of, x), 0.014)


@pytest.mark.parametrize("deepest", [1e-3, 8e-3, 2e-2])
@pytest.mark.parametrize("name", LAWS)
def test_the_same_share_of_the_work_is_returned_from_any_depth(name: str, deepest: float) -> None:
    """e² by the definition of the restitution, whatever the curve going in."""
    of = surface(**LAWS[name])
    put_in = work(lambda x: going_in(of, x), deepest)
    returned = work(lambda x: coming_out(of, deepest, x), deepest)
    assert returned / put_in == pytest.approx(share_returned(name), rel=2e-4)


@pytest.mark.parametrize("name", LAWS)
def test_coming_out_it_is_below_going_in_continuous_and_never_pulls(name: str) -> None:
    of, deepest = surface(**LAWS[name]), 0.013
    for depth in np.linspace(1e-6, deepest, 60):
        assert 0.0 <= coming_out(of, deepest, depth) <= going_in(of, depth) * (1.0 + 1e-12)
    near = coming_out(of, deepest, deepest * (1.0 - 1e-9))
    assert near == pytest.approx(going_in(of, deepest), rel=1e-6)
    deeper = load(of, pressed_to(of, deepest), 1.3 * deepest)
    assert deeper.force.force == pytest.approx(going_in(of, 1.3 * deepest), rel=1e-12)
    assert deeper.point.depth == 1.3 * deepest
    assert load(of, pressed_to(of, deepest), 5e-3, rate=-50.0).force.force >= 0.0


@pytest.mark.parametrize("name", LAWS)
def test_the_stored_energy_is_what_will_be_returned(name: str) -> None:
    """Two formulations: the closed form of the energy, and the integral of the force."""
    of, deepest = surface(**LAWS[name]), 0.011
    memory = pressed_to(of, deepest)
    for depth in (0.002, 0.006, 0.0105, deepest):
        expected = work(lambda x: coming_out(of, deepest, x), depth)
        assert stored(of, memory, depth) == pytest.approx(expected, rel=3e-4, abs=1e-7)
    assert stored(of, memory, 0.0) == 0.0


@pytest.mark.parametrize("name", LAWS)
def test_the_heat_of_a_cycle_is_the_work_that_is_not_returned(name: str) -> None:
    """In whatever steps it comes in, and goes out in between; the way out costs no more."""
    of, deepest = surface(**LAWS[name]), 0.011
    memory, heat = no_memory(), 0.0
    for depth in (1e-9, 0.004, 0.0083, 0.005, 0.0079, 0.0084, deepest, 0.002):
        found = load(of, memory, depth, rate=1.0)
        heat += found.point.lost + 1e3 * abs(found.force.loss)
        memory = next_memory(memory, (found.point, no_point(), no_point()))
    lost = (1.0 - share_returned(name)) * work(lambda x: going_in(of, x), deepest)
    assert heat == pytest.approx(lost, rel=1e-3, abs=1e-6)


@pytest.mark.parametrize("name", LAWS)
def test_a_contact_that_jumps_to_another_place_loses_nothing_by_that(name: str) -> None:
    """As between two cages that cross: its memory is lost, and what it lost was heat before."""
    assert load(surface(**LAWS[name]), no_memory(), 0.011, rate=1.0).point.lost == 0.0


@pytest.mark.parametrize("name", LAWS)
def test_steps_know_the_steepest_slope(name: str) -> None:
    """The stiffness that limits steps is at least every slope, going in and coming out."""
    of = surface(**LAWS[name])
    for deepest in (2e-4, 3e-3, 1.1e-2, 1.6e-2):
        memory = pressed_to(of, deepest)
        for depth in np.linspace(0.02 * deepest, 0.98 * deepest, 25):
            h = 1e-5 * depth
            slope = coming_out(of, deepest, depth + h) - coming_out(of, deepest, depth - h)
            known = load(of, memory, depth).force.stiffness
            assert slope / (2.0 * h) <= known * (1.0 + 1e-6), (deepest, depth)


def test_a_table_is_what_was_measured() -> None:
    of = surface(**LAWS["table"])
    for depth, force in ((0.002, 40.0), (0.010, 60.0), (0.014, 400.0)):
        assert going_in(of, depth) == pytest.approx(force, rel=1e-9)
    for depth, force in ((0.010, 20.0), (0.014, 400.0)):
        assert coming_out(of, 0.014, depth) == pytest.approx(force, rel=0.02)
    assert coming_out(of, 0.014, 0.0025) < 1.0


def test_a_foam_yields_and_is_pressed_together() -> None:
    of = surface(**LAWS["foam"])  # yields at 2.5 mm; then a hundredth of the stiffness
    assert going_in(of, 1e-3) == pytest.approx(20.0, rel=1e-9)
    assert going_in(of, 6e-3) == pytest.approx(50.0 + 200.0 * 3.5e-3, rel=1e-9)
    top = 50.0 + 200.0 * 9.5e-3
    assert going_in(of, 2e-2) == pytest.approx(top + 2e5 * 8e-3, rel=1e-9)


def test_the_next_corner_is_the_nearest_point_of_the_curve_ahead() -> None:
    """Either way, and not one that has been reached; none beyond the last, or of a power law."""
    points = [0.0, 1e-3, 4e-3, 1e-2]
    table = {"law": "table", "loading": [[x, 5e3 * x + 1e6 * x * x] for x in points]}
    [law] = surface(**table).hysteresis
    for k, at in enumerate(nonempty(points)):
        ahead, behind = points[k + 1 : k + 2] or [0.0], points[max(k - 1, 0)]
        for near in (at - 1e-13, at, at + 1e-13):
            assert next_corner(law, near, 2.0) == ahead[0]
            assert next_corner(law, near, -2.0) == behind
    assert next_corner(law, 2e-3, 1.0) == 4e-3
    assert next_corner(law, 2e-3, -1.0) == 1e-3
    assert next_corner(law, 2e-2, -1.0) == 1e-2
    [power] = surface(**LAWS["linear"]).hysteresis
    assert next_corner(power, 2e-3, 1.0) == 0.0


def test_one_mass_bounces_with_the_same_restitution_at_any_speed() -> None:
    """An integration of its own, by events: in to the turn, then out along what is remembered."""
    of, mass = surface(**LAWS["foam"]), 0.8
    for speed in (0.3, 1.0, 4.0):

        def stops(t: float, x: Any) -> float:
            return float(x[1])

        stops.terminal = True  # type: ignore[attr-defined]
        start = [1e-12, speed]
        inward = solve_ivp(
            lambda t, x: [x[1], -going_in(of, max(x[0], 1e-12)) / mass], (0.0, 1.0), start,
            events=stops, rtol=1e-8, atol=1e-12,
        )  # fmt: skip
        deepest = float(inward.y[0, -1])

        def leaves(t: float, x: Any) -> float:
            return float(x[0]) - 1e-9

        leaves.terminal = True  # type: ignore[attr-defined]
        outward = solve_ivp(
            lambda t, x, deepest=deepest: [x[1], -coming_out(of, deepest, max(x[0], 1e-12)) / mass],
            (0.0, 10.0), [deepest * (1.0 - 1e-9), 0.0], events=leaves, rtol=1e-8, atol=1e-12,
        )  # fmt: skip
        assert -outward.y[1, -1] / speed == pytest.approx(0.3, rel=2e-3)


def test_contacts_are_known_by_place_and_normal() -> None:
    of = surface(**LAWS["linear"])
    memory = pressed_to(of, 0.01)
    elastic = normal_force(of, 0.005, 0.0, 0.0)

    def deepest(place: Vec, inward: Vec) -> float:
        at = Pressing(of, place, inward, 0.005, 0.0, 0.0)
        return hysteretic_load(memory, elastic, at).point.depth

    assert deepest(PLACE, INWARD) == 0.01
    assert deepest(PLACE + Vec(0.0, 0.004, 0.0), Vec(0.96, 0.28, 0.0)) == 0.01
    assert deepest(PLACE + Vec(0.0, 0.02, 0.0), INWARD) == 0.005
    assert deepest(PLACE, Vec(0.0, 0.0, 1.0)) == 0.005


def test_the_nearest_contact_counts() -> None:
    of = surface(**LAWS["linear"])
    near = load(of, no_memory(), 0.01).point
    far = near._replace(place=PLACE + Vec(0.0, 0.006, 0.0), depth=0.02)
    for points in ((near, far), (far, near)):
        assert load(of, PressedPoints(0.0, points), 0.005).point.depth == 0.01


def test_what_is_let_go_is_forgotten_unless_it_stays_pressed() -> None:
    for recovers in (True, False):
        of = surface(**LAWS["foam"], recovers=recovers)
        after = next_memory(pressed_to(of, 0.01), (no_point(), no_point(), no_point()))
        elsewhere = Pressing(of, PLACE + Vec(0.0, 0.2, 0.0), INWARD, 1e-3, 0.0, 0.0)
        again = hysteretic_load(after, normal_force(of, 1e-3, 0.0, 0.0), elsewhere)
        assert again.point.depth == (1e-3 if recovers else 0.01)
        assert (again.force.force == pytest.approx(20.0, rel=1e-9)) == recovers
        other = surface(**LAWS["foam"])  # which recovers, and was not pressed by this part
        fresh = hysteretic_load(after, again.force, elsewhere._replace(surface=other))
        assert fresh.point.depth == 1e-3


def test_springs_with_memories_in_series_return_what_each_does() -> None:
    """By the balance of forces of two springs, each with its own memory, at the deepest depth."""
    obstacle = surface(law="constant-restitution", stiffness=3e5, restitution=0.8)
    own = HullSurface(law="constant-restitution", stiffness=1e5, restitution=0.3)
    alone = surface(law="constant-restitution", stiffness=1e5, restitution=0.3)
    both = in_series(obstacle, hull_law(own.numbers()))
    deepest = 4e-3

    def split(depth: float) -> float:
        found: float = brentq(
            lambda x: power(AnyExponent(1.5), x) * 3e5 - power(AnyExponent(1.5), depth - x) * 1e5,
            0.0, depth,
        )  # fmt: skip
        return found

    theirs = split(deepest)
    ours = deepest - theirs
    assert going_in(both, deepest) == pytest.approx(going_in(obstacle, theirs), rel=1e-9)
    returned = 0.64 * work(lambda x: going_in(obstacle, x), theirs)
    returned += 0.09 * work(lambda x: going_in(alone, x), ours)
    assert work(lambda x: coming_out(both, deepest, x), deepest) == pytest.approx(
        returned, rel=2e-4
    )


def test_a_hull_of_foam_meets_everything_by_its_own_law() -> None:
    own = HullSurface(
        law="foam", stiffness=2e4, plateau_force=50.0, densification_depth=0.012, restitution=0.3
    )
    foam = surface(**LAWS["foam"])
    hard = in_series(surface(law="hertz", stiffness=2e6, friction=0.5), hull_law(own.numbers()))
    assert hard.friction == 0.5
    for depth in (1e-3, 6e-3, 2e-2):
        assert going_in(hard, depth) == going_in(foam, depth)
        assert coming_out(hard, 0.02, depth) == coming_out(foam, 0.02, depth)
    soft = HullSurface(stiffness=40.0, exponent=0.54, in_series=False)
    alone = in_series(surface(law="hertz", stiffness=2e6), hull_law(soft.numbers()))
    assert going_in(alone, 0.02) == pytest.approx(40.0 * power(AnyExponent(0.54), 0.02), rel=1e-9)
    assert going_in(in_series(surface(**LAWS["foam"]), hull_law(soft.numbers())), 0.02) == (
        going_in(alone, 0.02)
    )
    bounces = surface(law="impulse", restitution=0.5)
    assert in_series(bounces, hull_law(own.numbers())).hysteresis == bounces.hysteresis


@pytest.mark.parametrize("n", [0.4, 0.54, 0.9])
def test_exponents_below_1_have_a_bounded_slope(n: float) -> None:
    """Beside δⁿ at depths of millimetres; its energy is the integral of the force."""
    exponent = AnyExponent(n)
    assert power(exponent, 0.0) == 0.0
    assert power(exponent, 1e-3) == pytest.approx(1e-3**n, rel=0.5 * (1.0 - n) * 0.0101)
    of = surface(law="hertz", stiffness=40.0, exponent=n)
    for depth in (1e-30, 1e-9, 3e-6, 3.3e-6, 1e-5, 1e-4, 1e-3, 2e-2):
        expected = quad(lambda x: 40.0 * power(exponent, x), 0.0, depth, points=[depth / 20])[0]
        assert elastic_energy(of, depth) == pytest.approx(expected, rel=1e-9)
        h = 1e-4 * depth
        slope = (power(exponent, depth + h) - power(exponent, depth - h)) / (2.0 * h)
        assert slope <= steepest(exponent, depth, 2.0 * h)
    assert steepest(exponent, 0.0, 0.0) == pytest.approx(1e-4 ** (n - 1.0), rel=1e-12)


@pytest.mark.parametrize("n", [0.4, 0.54, 0.9, 1.0, 1.5])
def test_coming_out_is_steep_within_bounds_from_the_very_touch_on(n: float) -> None:
    """E²/W is at most twice the largest slope so far; rounding of W made it 10¹⁴⁶, and steps 0.1 us."""
    of = surface(law="constant-restitution", stiffness=40.0, exponent=n, restitution=0.4)
    share = 1.0 / 0.4**2 - 1.0
    for depth in (1e-30, 1e-18, 1e-12, 1e-8, 1e-6, 1e-4, 1e-2):
        steepest_yet = 40.0 * steepest(AnyExponent(n), 0.0 if n < 1.0 else depth + 1e-6, 0.0)
        bound = (1.0 + 2.0 * share) * steepest_yet
        of_contact = load(of, no_memory(), depth)
        ahead = 40.0 * steepest(AnyExponent(n), depth + 1e-5, 0.0)
        assert of_contact.force.stiffness <= max(bound, ahead) * (1.0 + 1e-5)


@pytest.mark.parametrize("law", ["hunt-crossley", "hertz", "foam", "table", "constant-restitution"])
def test_a_damper_beside_any_spring(law: str) -> None:
    given = {
        "foam": LAWS["foam"], "table": LAWS["table"], "constant-restitution": LAWS["hertzian"],
        "hertz": {"law": "hertz"}, "hunt-crossley": {"dissipation": 0.2},
    }[law]  # fmt: skip
    without, damped = surface(**given), surface(**given, viscosity="30 N s/m")
    for rate in (0.5, -0.5):
        difference = load(damped, no_memory(), 5e-3, rate).force.force
        difference -= load(without, no_memory(), 5e-3, rate).force.force
        assert difference == pytest.approx(30.0 * rate, rel=1e-9)
    press = load(damped, no_memory(), 5e-3, 0.0).force.damper
    assert press - load(without, no_memory(), 5e-3, 0.0).force.damper == pytest.approx(30.0)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"law": "constant-restitution"}, "restitution: is missing; law constant-restitution"),
        (
            {**LAWS["hertzian"], "restitution": 0.05},
            "restitution: of law constant-restitution must be at least 0.1 (got 0.05)",
        ),
        (
            {**LAWS["hertzian"], "restitution_speed": "2 m/s"},
            "restitution_speed: cannot be combined with law constant-restitution",
        ),
        (
            {**LAWS["hertzian"], "dissipation": 0.3},
            "dissipation: cannot be combined with law constant-restitution",
        ),
        ({**LAWS["hertzian"], "exponent": 0.3}, "exponent: must be at least 0.4 (got 0.3)"),
        ({"law": "hertz", "plateau_force": 5}, "plateau_force: needs law foam (got law hertz)"),
        ({"law": "hertz", "loading": LOADING}, "loading: needs law table (got law hertz)"),
        ({"law": "hertz", "recovers": False}, "recovers: needs law constant-restitution or foam"),
        (
            {k: v for k, v in LAWS["foam"].items() if k != "stiffness"},
            "stiffness: is missing; law foam needs it, in N/m",
        ),
        ({"law": "foam", "stiffness": 1e4}, "plateau_force: is missing; law foam needs it"),
        (
            {**LAWS["foam"], "densification_depth": "2 mm"},
            "densification_depth: must be more than 0.0025 m, where plateau_force is reached "
            "(got 0.002 m)",
        ),
        ({"law": "table"}, "loading: is missing; law table needs it"),
        ({"law": "table", "loading": 3}, "loading: must be 2 to 64 pairs"),
        ({"law": "table", "loading": [[0, 0]]}, "loading: must be 2 to 64 pairs"),
        (
            {"law": "table", "loading": [[0, 0], [1, "5 m"]]},
            "loading[1]: has the wrong unit (got '5 m'); expected N",
        ),
        (
            {"law": "table", "loading": [[0, 0], ["2 mm", 5], ["2 mm", 6]]},
            "loading[2]: must be deeper than 0.002 m, the one before it (got 0.002 m)",
        ),
        ({"law": "table", "loading": [["1 mm", 0], [1, 5]]}, "loading[0]: must be 0 m, 0 N"),
        ({"law": "table", "loading": [[0, 0], [1, 0]]}, "loading[1]: must have a force of more"),
        ({"law": "table", "loading": [[0, 0], [1, -5]]}, "loading[1]: must be at least 0 N"),
        (
            {"law": "table", "loading": LOADING, "unloading": [[0, 0], ["14 mm", "300 N"]]},
            "unloading[1]: must be 0.014 m, 400 N, the last of loading (got 0.014 m, 300 N)",
        ),
        (
            {
                "law": "table", "loading": LOADING,
                "unloading": [[0, 0], ["10 mm", "90 N"], ["14 mm", "400 N"]],
            },
            "unloading[1]: must not be above loading, 60 N at 0.01 m",
        ),
        (
            {**LAWS["table"], "restitution": 0.5},
            "restitution: cannot be combined with unloading; give only one",
        ),
    ],
)  # fmt: skip
def test_wrong_laws_are_refused_in_one_line(given: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError) as caught:
        SurfaceSettings(**given)
    [line] = caught.value.problems
    assert line.startswith(message)


def test_all_laws_with_a_memory_are_tested_here() -> None:
    assert {one["law"] for one in LAWS.values()} == set(REMEMBERING)
