"""Guards that lose stiffness when the force on them passes its limit."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import springback
from builders.bodies import body
from builders.cases import nonempty
from builders.impacts import value
from springback.batch.scenarios import fly_scenarios
from springback.contact.cage import ContactFace, Support, simple_face
from springback.contact.laws.hysteresis import no_point
from springback.contact.loads import face_contact
from springback.contact.parameters import SurfaceSettings
from springback.contact.surfaces import AnyExponent
from springback.errors import InputError
from springback.kernels.trees import leaves
from springback.kernels.vectors import Vec
from springback.results.contacts.spans import contact_mask
from springback.results.flight import Flight
from springback.vehicle.state import ArmPose, PartMemory, PressedPoints

K, SPEED, LIMIT = 2e4, 1.5, 60.0
SPRING = {"law": "kelvin-voigt", "stiffness": K, "viscosity": 0.0, "friction": 0.0}


def on_a_rail(share: Any = 0.3, limit: Any = LIMIT, **surface: Any) -> dict[str, Any]:
    """A rigid robot on a rail, one guard ahead, into a wall that is a linear spring."""
    limits = {"guard_force": limit, "broken_stiffness": share}
    return {
        "vehicle": {"preset": "quad", "limits": limits if limit else False},
        "thrust": "hover",
        "model": {"slider": [1, 0, 0]},
        "world": {"obstacles": [{"type": "wall", "distance": "2 m", "surface": SPRING | surface}]},
        "start": {"position": [1.6, 0, 1], "velocity": [SPEED, 0, 0], "yaw": "45 deg"},
        "simulation": {"duration": 0.2},
    }


def first_broken(flight: Flight, part: int) -> int:
    """Row of the first instant at which a guard, numbered from 1, is not whole."""
    return int(np.flatnonzero(flight.columns[f"stiffness{part}"] < 1.0)[0])


def ahead(flight: Flight) -> int:
    """Number from 1 of the guard that the largest force acted on."""
    return int(np.argmax([flight.columns[f"fn{j}"].max() for j in range(1, 5)])) + 1


@pytest.mark.parametrize("share", [0.3, 0.9])
def test_one_mass_on_a_spring_that_breaks_obeys_its_formulas(share: float) -> None:
    """½ m v² = ½ k d² at the break; from there on s k, and (1 − s) ½ k d² is lost."""
    flight = springback.fly(on_a_rail(share))
    m, d = flight.scenario.vehicle.mass, LIMIT / K
    deepest = math.sqrt(d * d + (m * SPEED**2 - K * d * d) / (share * K))
    most = max(LIMIT, share * K * deepest)
    assert value(flight, "peak_normal_force") == pytest.approx(most, rel=1e-4)
    lost = (1.0 - share) * 0.5 * K * d * d
    assert value(flight, "loss_contact") == pytest.approx(lost, rel=2e-4)
    out = math.sqrt(1.0 - 2.0 * lost / (m * SPEED**2))
    assert value(flight, "restitution_at_separation") == pytest.approx(out, rel=2e-5)
    whole = math.asin(d / SPEED * math.sqrt(K / m)) / math.sqrt(K / m)
    since = value(flight, "broken_time") - value(flight, "touch_time")
    assert since == pytest.approx(whole, rel=1e-4)
    assert abs(value(flight, "ledger_residual")) < 1e-6


def test_what_is_whole_has_the_bits_of_a_vehicle_without_the_setting() -> None:
    """A share of 1, and a limit that is never passed."""
    plain = springback.fly(on_a_rail(limit=None))
    for given in (on_a_rail(1.0), on_a_rail(0.3, 1e4)):
        flight = springback.fly(given)
        for name, column in plain.columns.items():
            assert np.array_equal(flight.columns[name], column, equal_nan=True), name
        assert all((flight.columns[f"stiffness{j}"] == 1.0).all() for j in range(1, 5))


def test_steps_land_on_the_break_and_it_is_told() -> None:
    """The force passes the limit by 1e-4 of it at most, and one step later it is the share."""
    for step in ("0.4 ms", "0.1 ms"):
        tables = on_a_rail()
        tables["simulation"]["impact_step"] = step
        flight = springback.fly(tables)
        part = ahead(flight)
        row, normal = first_broken(flight, part), flight.columns[f"fn{part}"]
        assert normal[row - 2] <= LIMIT < normal[row - 1] < 1.0002 * LIMIT
        assert normal[row] == pytest.approx(0.3 * normal[row - 1], rel=1e-3)
        (event,) = (event for event in flight.events if event.kind == "broken")
        assert event.t == flight.t[row - 1] == value(flight, "broken_time")
        assert event.text == f"guard {part}: more than 60 N, 30 % of its stiffness is left"
        assert flight.outcome.word == "broken"
        felt = contact_mask(flight.columns)
        steps = np.diff(flight.t, append=flight.t[-1])
        assert value(flight, "contact_duration") == pytest.approx(steps[felt].sum(), rel=0.02)


def test_the_second_hit_is_softer() -> None:
    """Dropped flat on all guards: m g + √((m g)² + 4 s k m v²) from the second touch on."""
    share, tables = 0.25, on_a_rail(0.25, 40.0)
    tables["world"]["obstacles"] = [{"type": "ground", "height": 0.0, "surface": SPRING}]
    tables["model"] = {}
    tables["thrust"] = 0.0
    tables["vehicle"]["hull"] = False
    tables["start"] = {"position": [0, 0, 0.05], "velocity": [0, 0, 0]}
    tables["simulation"] = {"duration": 0.5}
    flight = springback.fly(tables)
    touches = [event.t for event in flight.events if event.kind == "touch"]
    assert len(touches) >= 2
    assert all((flight.columns[f"stiffness{j}"][-1] == share) for j in range(1, 5))
    later = flight.t >= touches[1]
    weight = 9.81 * flight.scenario.vehicle.mass
    speed = float(np.interp(touches[1], flight.t, flight.columns["vz"]))
    most = weight + math.sqrt(weight**2 + 4.0 * share * K * flight.scenario.vehicle.mass * speed**2)
    normal = sum(flight.columns[f"fn{j}"] for j in range(1, 5))
    assert normal[later].max() == pytest.approx(most, rel=1e-3)
    assert most < 0.95 * normal[~later].max()


#: A shape far away makes all of these one structure: it has a law that remembers.
FAR = {"type": "sphere", "position": [-50, 0, 0], "radius": 1.0,
       "surface": {"law": "constant-restitution", "restitution": 0.5}}  # fmt: skip
LAWS: dict[str, dict[str, Any]] = {
    "hunt-crossley": {"law": "hunt-crossley", "stiffness": 2e5, "dissipation": 0.3},
    "hertz": {"law": "hertz", "exponent": 2.0, "stiffness": 1e7},
    "kelvin-voigt": {"law": "kelvin-voigt", "stiffness": 2e4, "viscosity": 50.0},
    "softening": {"law": "hunt-crossley", "stiffness": 2e3, "exponent": 0.54, "dissipation": 0.3},
    "constant-restitution": {"law": "constant-restitution", "restitution": 0.4},
    "foam": {"law": "foam", "stiffness": 1e5, "plateau_force": "200 N",
             "densification_depth": "20 mm", "restitution": 0.3},
    "table": {"law": "table", "loading": [[0, 0], ["1 mm", "80 N"], ["10 mm", "300 N"]],
              "unloading": [["0.5 mm", 0], ["10 mm", "300 N"]], "recovers": False},
}  # fmt: skip
#: Laws of a bumper in front of each cage: a spring in series with the pole's, and others alone.
OWN: dict[str, dict[str, Any]] = {
    "in series": {"law": "power", "stiffness": 3e5, "exponent": 1.5, "dissipation": 0.3},
    **{law: {"stiffness": 2e5} | LAWS[law] for law in ("constant-restitution", "foam")},
    "table": LAWS["table"],
}
TURN = math.radians(120.0)
#: Finer than usual where the law's own kinks, of a whole guard, leave more than 1e-6 open; of the
#: foam the break itself leaves 1.9e-6 at 0.1 ms, in proportion to the step (a whole one 3e-8).
STEPS = {
    "softening": "0.05 ms", "constant-restitution": "0.02 ms", "table": "0.05 ms", "foam": "0.02 ms",
}  # fmt: skip


def at_a_pole(guard: str, law: str, **limits: Any) -> dict[str, Any]:
    """Three arms, into a pole with a cage, or the bumper in front of it; all of one structure."""
    surface = LAWS["hunt-crossley" if guard == "bumper" else law] | {"friction": 0.3}
    own = {"surface": OWN[law]} if guard == "bumper" else {}
    out = 0.127 if guard == "bumper" else 0.01  # or within the cage
    hulls = [
        {"type": "sphere", "on": 1 + k, "radius": "40 mm", **own,
         "position": [out * math.cos(k * TURN), out * math.sin(k * TURN), 0.01]} for k in range(3)
    ]  # fmt: skip
    pole = {"type": "pole", "position": [1.0, 0.02, 0.0], "radius": 0.1, "surface": surface}
    return {
        "vehicle": {"preset": "arq", "arms": {"directions": [0.0, TURN, 2.0 * TURN]},
                    "limits": {"guard_force": 50.0, **limits}, "hulls": hulls},
        "thrust": "hover",
        "world": {"obstacles": [pole, FAR]},
        "start": {"position": [0.4, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0], "pitch": "5 deg"},
        "simulation": {"duration": 0.3, "impact_step": STEPS.get(law, "0.1 ms")},
    }  # fmt: skip


@pytest.mark.parametrize(
    ("guard", "law"), [*(("cage", law) for law in LAWS), *(("bumper", law) for law in OWN)]
)
def test_under_every_law_the_energy_closes(guard: str, law: str) -> None:
    """Of cages and hulls that break at a pole; what they held is lost in contact."""
    shares = [0.4, 0.5, 0.6]
    flight = springback.fly(at_a_pole(guard, law, broken_stiffness=shares))
    whole = springback.fly(at_a_pole(guard, law, broken_stiffness=1.0))
    row = first_broken(flight, 1)
    assert flight.columns["stiffness1"][row] == shares[0]
    assert flight.columns["fn1"][row] < 0.6 * flight.columns["fn1"][row - 1]
    assert abs(value(flight, "ledger_residual")) < 1e-6
    for name in ("x", "fn1"):  # the last steps before the break land on it
        assert np.array_equal(flight.columns[name][: row - 6], whole.columns[name][: row - 6])
    assert value(flight, "penetration") > value(whole, "penetration")


@pytest.mark.parametrize("law", LAWS)
def test_all_of_a_load_is_the_share_of_that_of_a_whole_guard(law: str) -> None:
    """At the same depth and rate, going in and coming out: force, moment, friction, heat, bounds."""
    given = SurfaceSettings.model_validate(LAWS[law] | {"friction": 0.4})
    of = given.surface(AnyExponent, in_scene=True)
    arm = ArmPose(Vec(1.0, 0.0, 0.0), Vec(0.19, 0.0, 0.0), Vec(0.8, 0.3, -0.2))
    point = no_point()._replace(place=Vec(0.3, 0.0, 0.0), inward=Vec(1.0, 0.0, 0.0), depth=0.006)
    at = Support(*(Vec(0.11, 0.0, 0.0),) * 3, 0.0)
    for rate in (0.7, -0.2):
        face = ContactFace(simple_face(-0.004, Vec(1.0, 0.0, 0.0), at), of, 0.0)
        moving = body(velocity=Vec(rate, 0.3, -0.2), omega=Vec(0.3, -0.5, 0.9))
        held = (PressedPoints(0.0, (point,)),)
        whole, broken = (
            face_contact(face, 1.0, PartMemory((), held, (), share), arm, moving).touch
            for share in ((1.0,), (0.3,))
        )
        assert whole.normal > 0.0
        assert np.allclose(leaves(broken), 0.3 * np.array(leaves(whole)), rtol=1e-14, atol=0.0)


def test_many_flights_break_as_each_does_alone() -> None:
    """In lanes, in plain Python and compiled, to the bit."""
    tables = [on_a_rail(share, 40.0 + 10.0 * k) for k, share in enumerate((0.0, 0.2, 0.7, 1.0))]
    tables += [on_a_rail([0.1, 0.2, 0.3, 0.4], [50.0, 60.0, 70.0, 80.0])]
    rows = fly_scenarios(tables)
    names = ("broken_time", "loss_contact", "peak_normal_force", "end_time", "energy_kinetic")
    for k, table in enumerate(nonempty(tables)):
        table["simulation"]["duration"] = 0.2
        alone = springback.fly(table, trajectory=False).measures
        plain = springback.fly(table, trajectory=False, executor="python").measures
        assert plain == alone
        assert all(float(rows.measures[name][k]) == alone[name] for name in names)


@pytest.mark.parametrize(
    ("limits", "words"),
    [
        ({"broken_stiffness": 0.5}, ("broken_stiffness", "needs guard_force")),
        ({"guard_force": 9.0, "broken_stiffness": 1.5}, ("broken_stiffness", "at most 1")),
        ({"guard_force": 9.0, "broken_stiffness": -0.1}, ("broken_stiffness", "at least 0")),
        ({"guard_force": 9.0, "broken_stiffness": [0.1]}, ("broken_stiffness", "1 entries for 4")),
    ],
)
def test_shares_that_cannot_be_are_refused(limits: Any, words: tuple[str, ...]) -> None:
    tables = on_a_rail()
    tables["vehicle"]["limits"] = {"arm_force": 1e9, **limits} if len(limits) == 1 else limits
    tables["vehicle"]["preset"] = "arq"
    with pytest.raises(InputError) as caught:
        springback.fly(tables)
    assert all(word in str(caught.value) for word in ("vehicle.limits", *words))


def test_beside_a_second_vehicle_it_is_refused() -> None:
    """Contact of both is computed once, and would have to know what both guards have left."""
    tables = on_a_rail()
    tables["model"] = {}
    tables["second"] = {"vehicle": "quad", "start": {"position": [0.5, 0, 1]}, "thrust": "hover"}
    with pytest.raises(InputError, match=r"vehicle\.limits\.broken_stiffness: .*second vehicle"):
        springback.fly(tables)
