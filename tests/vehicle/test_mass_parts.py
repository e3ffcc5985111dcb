"""Mass and inertia of a main body from its parts: sums of many points, and what is refused."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from springback.errors import InputError
from springback.results.flight import as_scenario
from springback.vehicle.mass.parts import properties_of
from springback.vehicle.parameters import Body

TUBE = {
    "type": "tube", "mass": "30 g", "start": ["-0.1 m", 0.05, 0.0], "end": [0.1, -0.02, 0.03],
    "radius": "8 mm", "inner_radius": "5 mm",
}  # fmt: skip
BOX = {
    "type": "box", "mass": 0.2, "size": ["80 mm", "40 mm", "25 mm"], "position": [0.0, 0.01, 0.02],
    "roll": "20 deg", "pitch": "-35 deg", "yaw": "50 deg",
}  # fmt: skip
BALL = {"type": "ball", "mass": 0.1, "radius": "30 mm", "position": [0.02, 0.0, -0.05]}
POINT = {"type": "point", "mass": "20 g", "position": ["-50 mm", 0.0, 0.0]}


def body(*parts: dict[str, Any], **more: Any) -> dict[str, Any]:
    """Parts, and as much again on the other side, so that they are balanced."""
    others = []
    for part in parts:
        turned = {**part}
        for key in ("position", "start", "end"):
            if key in part:
                values = [v if isinstance(v, float) else float(v.split()[0]) for v in part[key]]
                scaled = [v * (1e-3 if isinstance(g, str) and "mm" in g else 1.0)
                          for v, g in zip(values, part[key], strict=True)]  # fmt: skip
                turned[key] = [-v for v in scaled]
        others.append(turned)
    return {"parts": [*parts, *others], **more}


def points_of(part: Any, count: int = 200_000) -> np.ndarray:
    """Random points of a part, evenly spread, shape (count, 3) [m]."""
    chance = np.random.default_rng(5)
    if part.type == "ball":
        way = chance.normal(size=(count, 3))
        way /= np.linalg.norm(way, axis=1)[:, None]
        return part.centre() + way * part.radius * chance.uniform(size=(count, 1)) ** (1.0 / 3.0)
    if part.type == "box":
        from scipy.spatial.transform import Rotation

        turn = Rotation.from_euler("ZYX", [part.yaw, part.pitch, part.roll]).as_matrix()
        return part.centre() + (chance.uniform(-0.5, 0.5, (count, 3)) * part.size) @ turn.T
    along = np.array(part.end) - np.array(part.start)
    x = np.cross(along, [0.0, 0.0, 1.0])
    x /= np.linalg.norm(x)
    y = np.cross(along / np.linalg.norm(along), x)
    angle, share = chance.uniform(0.0, 2.0 * np.pi, count), chance.uniform(size=(count, 1))
    squares = chance.uniform(part.inner_radius**2, part.radius**2, count)
    ring = np.sqrt(squares)[:, None] * (np.outer(np.cos(angle), x) + np.outer(np.sin(angle), y))
    return np.array(part.start) + share * along + ring


@pytest.mark.parametrize("part", [TUBE, BOX, BALL], ids=["tube", "box", "ball"])
def test_a_solid_is_many_points(part: dict[str, Any]) -> None:
    """Two formulations: closed form, and a sum over random points."""
    [one, _] = Body(**body(part)).parts
    away = points_of(one) - one.centre()
    squares = (away**2).sum(axis=1)
    expected = one.mass * (squares.mean() * np.eye(3) - away.T @ away / len(away))
    assert one.own_inertia() == pytest.approx(expected, abs=0.01 * np.abs(expected).max())


def test_parts_add_up_about_their_centre_of_mass() -> None:
    """The same as of all their points together."""
    whole = Body(**body(TUBE, BOX, BALL, POINT))
    assert whole.mass == pytest.approx(0.7)
    mass, expected = 0.0, np.zeros((3, 3))
    for part in whole.parts:
        away = part.centre()[None] if part.type == "point" else points_of(part, 50_000)
        squares = (away**2).sum(axis=1)
        expected += part.mass * (squares.mean() * np.eye(3) - away.T @ away / len(away))
        mass += part.mass
    assert np.array(whole.inertia) == pytest.approx(expected, abs=0.01 * np.abs(expected).max())
    assert mass == pytest.approx(whole.mass)


def test_two_points_on_a_stick() -> None:
    """2 m r² across, nothing along."""
    parts = [{**POINT, "position": [x, 0.0, 0.0]} for x in (-0.1, 0.1)]
    known = properties_of(Body(parts=[*parts, {"type": "ball", "mass": 0.1, "radius": 0.02}]).parts)
    ball = 0.4 * 0.1 * 0.02**2
    diagonal = [ball, ball + 2.0 * 0.02 * 0.01, ball + 2.0 * 0.02 * 0.01]
    assert np.array(known.inertia) == pytest.approx(np.diag(diagonal))
    assert known.centre == pytest.approx((0.0, 0.0, 0.0))


def test_a_preset_takes_parts_and_a_stored_scenario_is_the_same() -> None:
    given = {"vehicle": {"preset": "arq", "body": body(BOX, BALL)}}
    first = as_scenario(given)
    assert first.vehicle.body.mass == pytest.approx(0.6)
    assert as_scenario(first.model_dump(mode="json")) == first


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"parts": [POINT, BALL]}, "body.parts: have their centre of mass at [8.333, 0, -41.67] mm"),
        (body(BOX, mass=1.0), "body.mass: follows from parts; leave it out"),
        (body(BOX, inertia=[1e-3, 1e-3, 1e-3]), "body.inertia: follows from parts; leave it out"),
        (body({**BOX, "size": [0.1, 0.0, 0.1]}), "body.parts[0].size: must be more than 0 m"),
        (body({**BOX, "mass": "80 N"}), "body.parts[0].mass: has the wrong unit (got '80 N')"),
        (body({**TUBE, "inner_radius": 1}), "body.parts[0].inner_radius: must be at most the outer"),
        (body({**TUBE, "end": TUBE["start"]}), "body.parts[0].end: must not be that of start"),
        (body({**BALL, "type": "bal"}), "body.parts[0].type: must be point, ball, box or tube"),
        ({"parts": [{"type": "point"}]}, "body.parts[0].mass: is missing"),
    ],
)  # fmt: skip
def test_wrong_parts_are_refused_in_one_line(given: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError) as caught:
        as_scenario({"vehicle": {"preset": "quad", "body": given}})
    assert f"vehicle.{message}" in caught.value.problems[0]
