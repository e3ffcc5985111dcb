"""Mats and the ground: planes put together from settings."""

from __future__ import annotations

import pytest

from builders.scenes import approaching, one_arm, surface
from springback.contact.library import MAT, WALL
from springback.contact.obstacles import Forces, Plane, World
from springback.contact.parameters import Mat, faces
from springback.contact.surfaces import ThreeHalves
from springback.contact.worlds import obstacles
from springback.kernels.vectors import Vec
from springback.results.flight import fly
from springback.simulation.flight import FlightRecord, fly_one
from springback.simulation.measuring.measures import Outcome, measures_of

NOWHERE = Plane(Vec(-1.0, 0.0, 0.0), 0.0)


def hit(mat: Mat, speed: float) -> FlightRecord:
    """A rigid vehicle of 1.5 kg into a mat whose face is at x = 0, by one cage."""
    model = one_arm(NOWHERE, surface(), until=0.06)
    built = World(obstacles((mat,)), Forces(0.0), 0.0)
    start = approaching(speed, 1e-3)
    return fly_one(model._replace(world=built), start, executor="python")


def mat_of(thickness: float) -> Mat:
    """The paper's mat with its face at x = 0, on the paper's wall."""
    return Mat(
        type="mat", distance=thickness, thickness=thickness, surface=MAT, backing=WALL
    )  # fmt: skip


def test_a_mat_is_two_faces() -> None:
    """Its own surface in front by its thickness, the wall behind where the wall is."""
    mat = Mat(type="mat", distance=2.0, thickness=0.03, surface=MAT, backing=WALL)
    (front, soft, _), (back, hard, _) = faces(mat)
    assert front == Plane(Vec(-1.0, 0.0, 0.0), -1.97)
    assert back == Plane(Vec(-1.0, 0.0, 0.0), -2.0)
    assert soft.surface(ThreeHalves).stiffness == pytest.approx(0.6e5)
    assert hard.surface(ThreeHalves).stiffness == pytest.approx(1e5)


def test_a_thick_mat_hides_the_wall_and_a_thin_one_bottoms_through() -> None:
    """Pressed deeper than its thickness, the wall pushes as well; else it might as well not be there."""
    thick, thin = hit(mat_of(0.2), 2.0), hit(mat_of(0.01), 2.0)
    assert thick.record.peaks.penetration < 0.2
    assert thin.record.peaks.penetration > 0.01
    assert thin.record.first_impact.travel < thick.record.first_impact.travel
    assert thin.record.peaks.normal_force > 1.2 * thick.record.peaks.normal_force
    for flown in (thick, thin):
        assert flown.record.contacts.total == 1.0
        assert abs(measures_of(flown)["ledger_residual"] or 0.0) < 1e-6
    # Until the thin mat is through, both feel the same.
    assert thin.trace is not None
    assert thick.trace is not None
    for flown in (thick, thin):
        assert flown.trace is not None
        shallow = flown.trace["arms.1.depth"] < 0.01
        assert shallow.sum() > 20
    force = {}
    for name, flown in (("thick", thick), ("thin", thin)):
        assert flown.trace is not None
        before = flown.trace["time"] < 3e-3
        force[name] = flown.trace["arms.1.normal"][before]
    assert force["thick"] == pytest.approx(force["thin"])


def drop(height: float, *overrides: str) -> dict[str, object]:
    """Quad let go above the ground, which its cages meet; its main body has no hull."""
    return {
        "vehicle": {"preset": "quad", "hull": False},
        "world": {"obstacles": [{"type": "ground", "surface": "wall"}]},
        "start": {"position": [0.0, 0.0, height]},
        "simulation": {"duration": 0.3},
    }


def test_a_dropped_vehicle_hits_the_ground() -> None:
    """It falls for √(2h/g), arrives at √(2gh), and the outcome says so."""
    flight = fly(drop(0.2))
    assert flight.outcome is Outcome.HIT_GROUND
    # Flat cages meet the ground half a millimetre early: the rounded corner of the ring.
    assert flight.ground_time == pytest.approx((2.0 * 0.2 / 9.81) ** 0.5, rel=2e-3)
    assert flight.touch_speed == pytest.approx((2.0 * 9.81 * 0.2) ** 0.5, rel=2e-3)
    assert flight.touch_time == pytest.approx(flight.ground_time, abs=2e-4)
    assert 0.3 < (flight.restitution_at_separation or 0.0) < 0.7
    assert flight.contacts == 1.0


def test_all_four_flat_cages_share_a_landing() -> None:
    """A level drop stays level: four equal forces, each at the centre of its cage."""
    flight = fly(drop(0.1))
    forces = [flight.columns[f"fn{j}"] for j in (1, 2, 3, 4)]
    assert forces[0].max() > 20.0
    for other in forces[1:]:
        assert other == pytest.approx(forces[0], abs=1e-9)
    assert abs(flight.columns["wy"]).max() < 1e-9


@pytest.mark.parametrize("vehicle", ["quad", "arq"])
@pytest.mark.parametrize("roll", ["3 deg", "10 deg"])
def test_the_ledger_closes_when_a_tilted_vehicle_crashes(vehicle: str, roll: str) -> None:
    """Cage after cage, through flat contact and friction that sticks, as share of the fall."""
    scenario = drop(0.5)
    flight = fly(
        {
            **scenario,
            "vehicle": {"preset": vehicle, "hull": False},
            "start": {"position": [0.0, 0.0, 0.5], "roll": roll},
        },
        "simulation.duration=0.7",
    )
    measured = flight.measures
    losses = sum(
        value or 0.0 for name, value in measured.items() if name.startswith("loss_")
    )  # fmt: skip
    start, end = measured["energy_start"] or 0.0, measured["energy_end"] or 0.0
    fallen = flight.scenario.vehicle.mass * 9.81 * 0.5
    assert abs(end - start + losses) < 1e-6 * fallen
    assert (flight.contacts or 0.0) >= 2.0
