"""The energy ledger over time: it closes at every instant, and agrees with the package's own laws."""

import numpy as np
import pytest

from springback.dynamics.energy import energy
from springback.kernels.vectors import Quat, Vec
from springback.results.energy_history import HELD, LOST, ledger
from springback.results.flight import Flight, fly
from springback.vehicle.state import State

FREE = {
    "vehicle": "arq", "thrust": "hover",
    "world": {"obstacles": [{"type": "wall", "distance": 2.75, "surface": "wall"}]},
    "start": {"position": [2.3, 0.0, 1.0], "velocity": [3.0, 0.0, 0.0], "pitch": "20 deg", "yaw": "15 deg"},
    "simulation": {"duration": 0.3},
}  # fmt: skip


@pytest.fixture(scope="module")
def flight() -> Flight:
    return fly(FREE)


def state_at(flight: Flight, k: int) -> State:
    c = {name: float(values[k]) for name, values in flight.columns.items()}
    return State(
        Vec(c["x"], c["y"], c["z"]), Quat(c["qw"], c["qx"], c["qy"], c["qz"]),
        Vec(c["vx"], c["vy"], c["vz"]), Vec(c["wx"], c["wy"], c["wz"]),
        tuple(c[f"l{j}"] for j in range(1, 5)), tuple(c[f"dl{j}"] for j in range(1, 5)),
    )  # fmt: skip


def test_every_part_held_is_what_the_laws_say(flight: Flight) -> None:
    books, model = ledger(flight.scenario), flight.scenario.flight_model()
    touching = np.flatnonzero(flight.columns["fn1"] + flight.columns["fn2"] > 0.0)
    start = energy(model.airframe, model.world, model.contact_point, state_at(flight, 0))
    scale = start.kinetic
    for k in [0, *touching[:: len(touching) // 12].tolist(), len(flight.t) - 1]:
        now = energy(model.airframe, model.world, model.contact_point, state_at(flight, k))
        told = {name: books[f"energy_{name}"][k] for name in now._fields}
        wanted = now._replace(gravity=now.gravity - start.gravity)._asdict()
        assert told == pytest.approx(wanted, abs=1e-6 * scale), k
    assert books["energy_contact"].max() > 0.1 * scale
    assert books["energy_springs"].max() > 0.02 * scale


def test_what_is_held_and_lost_is_what_was_there_and_put_in(flight: Flight) -> None:
    books = ledger(flight.scenario)
    held, lost = (sum(books[name] for name in names) for names in (HELD, LOST))
    left = held + lost - books["work_thrust"] - held[0]
    assert np.abs(left).max() < 1e-6 * held[0]
    for name in ("loss_arm", "loss_contact", "loss_friction"):
        assert np.diff(books[name]).min() >= 0.0, f"{name} gives back"


@pytest.mark.parametrize("piloted", [False, True])
def test_it_has_the_instants_of_the_trajectory_and_ends_as_measures_say(piloted: bool) -> None:
    tables = FREE
    if piloted:
        wall = {"type": "wall", "distance": 2.75, "surface": "wall"}
        tables = {
            "vehicle": "arq", "recovery": {}, "reference": {"type": "run-up", "speed": 3.5},
            "world": {"obstacles": [wall, {"type": "ground", "surface": "wall"}]},
            "simulation": {"duration": 2.0}, "seed": 3,
        }  # fmt: skip
    flight = fly(tables)
    books = ledger(flight.scenario)
    assert books["t"].tobytes() == flight.t.tobytes()
    for name in (*HELD, "work_thrust", *LOST):
        assert books[name][-1] == pytest.approx(flight.measures[name], rel=1e-9, abs=2e-6), name


def test_a_flight_knows_what_its_scenario_flown_again_tells(flight: Flight) -> None:
    known, again = ledger(flight), ledger(flight.scenario)
    assert list(known) == list(again)
    assert all((known[name] == again[name]).all() for name in known)
