"""Laws with a memory in flight: of hulls, of moving obstacles, with bristles, in campaigns."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from builders.forms import box_file
from springback.batch.pair import fly_pair
from springback.batch.scenarios import fly_scenarios
from springback.contact.parameters import SurfaceSettings
from springback.errors import InputError
from springback.results.flight import Flight, fly
from springback.results.saved import load
from springback.scenario.scenario import scenario_from
from springback.simulation.playback import load_history

FOAM = {
    "law": "foam", "stiffness": 2e4, "plateau_force": "60 N", "densification_depth": "15 mm",
    "restitution": 0.3,
}  # fmt: skip
TABLE = {
    "law": "table", "loading": [[0, 0], ["2 mm", "60 N"], ["20 mm", "300 N"]],
    "unloading": [["1 mm", "0 N"], ["20 mm", "300 N"]],
}  # fmt: skip
CONSTANT = {"law": "constant-restitution", "stiffness": 1e5, "restitution": 0.4}
HARD = {"law": "hertz", "stiffness": 1e7}
#: A flat box under the main body, wider than its cages.
SKID = {"type": "box", "size": [0.2, 0.16, 0.04], "position": [0, 0, -0.1], "edge_radius": 0.002}


def drop(surface: Any, speed: float, duration: float = 0.3, **more: Any) -> dict[str, Any]:
    """A rigid quadrotor on a vertical rail that falls on its skid, without gravity."""
    vehicle = {"preset": "quad", "hull": False, "hulls": [{**SKID, **more.pop("skid", {})}]}
    return {
        "vehicle": vehicle,
        "world": {"gravity": 0.0, "obstacles": [{"type": "ground", "surface": surface}]},
        "start": {"position": [0, 0, 0.1205], "velocity": [0, 0, -speed]},
        "thrust": [0.0] * 4,
        "model": {"slider": [0, 0, 1]},
        "simulation": {"duration": duration},
        **more,
    }


def rebound(flight: Flight, speed: float) -> float:
    """Upward speed at the end, over that of the approach."""
    return float(flight.columns["vz"][-1]) / speed


@pytest.mark.parametrize(
    ("surface", "skid", "expected"),
    [
        (CONSTANT, {}, 0.4),
        (FOAM, {}, 0.3),
        (HARD, {"surface": {**FOAM, "exponent": 1.5}}, 0.3),
        (HARD, {"surface": {k: v for k, v in CONSTANT.items() if k != "none"}}, None),
        (TABLE, {}, None),
    ],
)
def test_the_restitution_is_the_same_at_any_speed(
    surface: Any, skid: Any, expected: float | None
) -> None:
    """Of four corners of a skid at once; the energy ledger closes."""
    found = []
    for speed in (0.4, 1.5, 4.0):
        flight = fly(drop(surface, speed, skid=skid))
        found.append(rebound(flight, speed))
        kinetic = 0.5 * flight.scenario.vehicle.mass * speed**2
        assert abs(flight.measures["ledger_residual"] or 0.0) < 1e-5 * kinetic
    assert np.ptp(found) < 1e-4
    if expected is not None:
        assert found == pytest.approx([expected] * 3, rel=1e-4)
    assert 0.05 < min(found) < max(found) < 0.95


@pytest.mark.parametrize(
    ("plateau", "restitution", "speed"),
    [("40 N", 0.3, 2.0), ("40 N", 0.9, 3.0), ("20 N", 0.6, 3.0)],
)
def test_steps_land_on_the_corners_of_a_foam(
    plateau: str, restitution: float, speed: float
) -> None:
    """A quadrotor that hits at steps of 100 µs: 9e-6 and 1.3e-5 of the energy were left, now 4e-8.

    The corner where the stiffness rises a thousandfold is 0.2 to 0.3 mm wide, as far as it goes in
    70 to 150 µs; the cubics between corners are integrated as they are.
    """
    foam = {**FOAM, "plateau_force": plateau, "restitution": restitution, "friction": 0.3}
    tables = {
        "vehicle": "quad", "thrust": [0.0] * 4,
        "world": {"gravity": 0.0, "obstacles": [{"type": "wall", "distance": 1.0, "surface": foam}]},
        "start": {
            "position": [0, 0, 1], "velocity": [speed, 0.3, 0], "yaw": 0.2, "touch_distance": 1e-3,
        },
        "simulation": {"duration": 0.06},
    }  # fmt: skip
    flight = fly(tables, executor="python")
    assert max(flight.columns[f"fn{j}"].max() for j in (1, 2)) > 60.0
    assert abs(flight.measures["ledger_residual"] or 0.0) < 1e-7


def test_its_loads_are_those_of_the_flight_when_they_are_evaluated_again(tmp_path: Path) -> None:
    """From the saved trajectory, with what each contact remembered, and the energies of a part."""
    flight = fly(drop(FOAM, 2.0, duration=0.1))
    flight.save(tmp_path / "flight", figures=False)
    again = load(tmp_path / "flight")
    places = np.arange(len(again.columns["t"]))
    history = load_history(again.scenario.flight_model(), again.columns, places)
    assert history.normal[:, -1].max() > 100.0
    assert np.abs(history.normal[:, -1] - flight.columns["fn_body"]).max() < 1e-6
    stored = history.energy["contact"]
    assert stored.max() > 0.0
    assert stored[-1] == 0.0


def test_what_has_not_recovered_loses_nothing_the_second_time() -> None:
    """Bouncing under gravity: within the depth that is crushed the foam is elastic."""
    second = []
    for recovers in (True, False):
        tables = drop({**FOAM, "restitution": 0.7, "recovers": recovers}, 1.5, duration=0.6)
        tables["world"]["gravity"] = 9.81
        c = fly(tables).columns
        ends = np.flatnonzero(np.diff((c["fn_body"] > 0.0).astype(int)))  # in, out, in, out
        assert len(ends) >= 4
        second.append(c["vz"][ends[3] + 1] / -c["vz"][ends[2]])
        assert (c["crushed_body"][-1] > 0.0) == (not recovers)
    assert second == pytest.approx([0.7, 1.0], abs=0.05)  # of a soft contact, gravity takes a share


def test_it_lies_still_on_foam_with_bristles() -> None:
    """Both memories together: on a slope of 10 degrees it comes to rest, and stays."""
    held = {**FOAM, "friction": 0.8, "friction_law": "bristle"}
    a = np.radians(10.0)
    slope = {"type": "wall", "position": [0, 0, 0], "normal": [np.sin(a), 0, np.cos(a)]}
    tables = drop(FOAM, 0.1, duration=4.0)
    tables["start"]["position"] = [0.0, 0.0, 0.15]
    del tables["model"]
    tables["world"] = {"obstacles": [{**slope, "surface": held}]}
    flight = fly(tables)
    c = flight.columns
    late = c["t"] > 3.0
    assert np.ptp(c["x"][late]) < 1e-5
    assert np.ptp(c["z"][late]) < 1e-5
    # Corners reach their deepest depth nearly together: a step that ends at the first of these kinks
    # is not yet at the next.
    assert abs(flight.measures["ledger_residual"] or 0.0) < 1e-4


def test_a_wall_of_foam_that_moves_hits_a_robot() -> None:
    """Seen from the wall it is the same impact: the rebound adds to the wall's speed."""
    wall = {"type": "wall", "position": [1.0, 0, 0], "normal": [-1, 0, 0], "surface": CONSTANT}
    moving = {**wall, "motion": {"type": "constant", "velocity": [-1.0, 0.0, 0.0]}}
    ends = []
    for obstacle, speed in ((wall, 2.0), (moving, 1.0)):
        flight = fly(
            {
                "vehicle": "quad",
                "world": {"gravity": 0.0, "obstacles": [obstacle]},
                "start": {"position": [0.5, 0, 1], "velocity": [speed, 0, 0]},
                "model": {"slider": [1, 0, 0]},
                "simulation": {"duration": 0.6},
            }
        )
        ends.append(float(flight.columns["vx"][-1]))
    assert ends[0] == pytest.approx(-0.8, rel=1e-5)
    assert ends[1] == pytest.approx(-0.8 - 1.0, rel=1e-5)


def test_two_robots_bounce_with_a_constant_restitution() -> None:
    """Head on, rigid and alike: each turns round with its share, momentum kept."""
    for speed in (0.5, 2.0):
        common = {
            "vehicle": "quad",
            "world": {"gravity": 0.0, "obstacles": []},
            "simulation": {"duration": 0.2 / speed},
        }
        starts = [{"position": [x, 0, 1], "velocity": [v, 0, 0]} for x, v in
                  ((0.0, speed), (0.7, -speed))]  # fmt: skip
        pair = fly_pair(
            {**common, "start": starts[0]}, {**common, "start": starts[1]},
            surface=SurfaceSettings.model_validate({**CONSTANT, "stiffness": 1e6}),
        )  # fmt: skip
        ends = [float(flight.columns["vx"][-1]) for flight in pair]
        assert ends == pytest.approx([-0.4 * speed, 0.4 * speed], rel=1e-3)


def test_laws_without_a_memory_are_asked_for_beside_what_moves_freely() -> None:
    ball = {
        "type": "sphere", "position": [2, 0, 1], "radius": 0.1, "surface": HARD,
        "motion": {"type": "free", "mass": 1.0},
    }  # fmt: skip
    tables = drop(FOAM, 1.0)
    tables["world"]["obstacles"].append(ball)
    with pytest.raises(
        InputError, match=r"world.obstacles\[0\]: must not have a surface of law foam"
    ):
        fly(tables)


@pytest.mark.parametrize("obstacle", ["mesh", "box"])
@pytest.mark.parametrize("yaw", [0.2, 0.6])
def test_posts_that_lie_along_a_face_keep_what_they_remember(yaw: float, obstacle: str) -> None:
    """The contact jumps from end to end of CogniFly's rods: 7e-3 and 1.3e-2 of the energy appeared.

    What is left at the mesh is the lowest point of a rod parallel to a face: it runs along it at once.
    """
    form = {"mesh": {"file": box_file(0.3, 0.3, 0.3)}, "box": {"size": [0.3] * 3}}[obstacle]
    cube = {"type": obstacle, **form, "position": [2.0, 0.05, 1.1], "surface": "wall"}
    flight = fly({
        "vehicle": "cognifly", "thrust": "hover", "world": {"obstacles": [cube]},
        "start": {"position": [1.2, 0, 1.0], "velocity": [2.0, 0, 0], "yaw": yaw},
        "simulation": {"duration": 0.35},
    })  # fmt: skip
    assert (flight.measures["penetration"] or 0.0) > 0.007
    assert abs(flight.measures["ledger_residual"] or 0.0) < 2e-5


def test_numbers_of_a_law_vary_in_a_campaign() -> None:
    """Each flight has its own, and is what it is alone, to the bit."""
    tables = [drop({**CONSTANT, "restitution": e}, 1.0) for e in (0.2, 0.4, 0.6, 0.8)]
    together = fly_scenarios(tables, threads=1)
    found = np.asarray(together.measures["restitution_at_separation"])
    assert found == pytest.approx([0.2, 0.4, 0.6, 0.8], rel=1e-4)
    for one, e in zip(tables, found, strict=True):
        assert fly(one, trajectory=False).measures["restitution_at_separation"] == e


@pytest.mark.parametrize(
    ("tables", "message"),
    [
        (
            drop(FOAM, 1.0, skid={"surface": {"stiffness": 1e5}}),
            "vehicle.hulls[0].surface: cannot be in series with world.obstacles[0].surface, "
            "whose law is foam",
        ),
        (
            drop(HARD, 1.0, skid={"surface": {"law": "foam"}}),
            "vehicle.hulls[0].surface.stiffness: is missing",
        ),
        (
            drop(HARD, 1.0, skid={"surface": {"stiffness": 1e5, "restitution": 0.5}}),
            "vehicle.hulls[0].surface.restitution: needs law constant-restitution",
        ),
    ],
)
def test_what_cannot_be_in_series_is_refused_in_one_line(tables: Any, message: str) -> None:
    with pytest.raises(InputError) as caught:
        scenario_from(tables)
    [line] = caught.value.problems
    assert line.startswith(message)
