"""Structures that the compiler sees: one for all scenes of built-in shapes at rest, few in all."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any

import pytest

from builders.cases import nonempty
from builders.forms import box_file, cells_file, hills_file
from builders.shape_scenes import SHAPES
from springback.campaign.common_flights import COMMON, flights_of, kinds_of
from springback.campaign.compiler_times import flight_kinds
from springback.results.flight import as_scenario

EXAMPLES = Path(__file__).parents[2] / "examples"
HERE = [2.7, 0.02, 1.0]
ALL: dict[str, dict[str, Any]] = {
    **SHAPES,
    "heightmap": {"file": hills_file(), "spacing": 0.1, "position": HERE, "roll": "90 deg"},
    "mesh": {"file": box_file(1.0, 1.0, 1.0), "position": [3.25, 0.0, 1.0]},
    "occupancy": {"file": cells_file(), "position": [2.7, -0.3, 0.7]},
    "net": {"position": HERE, "tension": 200.0},
    "union": {"position": HERE, "shapes": [{"type": "pole", "position": [0, 0, 0], "radius": 0.05}]},
}  # fmt: skip
LAWS: tuple[dict[str, Any], ...] = (
    {"law": "hunt-crossley", "dissipation": 0.3},
    {"law": "hertz", "exponent": 2.0, "stiffness": 1e7},
    {"law": "kelvin-voigt", "stiffness": 2e4, "viscosity": 50.0},
    {"law": "impulse", "restitution": 0.4},
    {"law": "hertz", "friction_axes": "vertical"},
)
REMEMBERING: tuple[dict[str, Any], ...] = (
    {"friction_law": "bristle"},
    {"law": "hertz", "exponent": 2.0, "stiffness": 1e7, "friction_law": "bristle"},
    {"law": "constant-restitution", "restitution": 0.5},
    {"law": "foam", "stiffness": 3e4, "plateau_force": "150 N", "densification_depth": "30 mm",
     "restitution": 0.3},
    {"law": "table", "loading": [[0.0, 0.0], [0.01, 50.0], [0.02, 200.0]], "restitution": 0.3},
)  # fmt: skip
PLANE: dict[str, Any] = {"type": "wall", "distance": 20.0, "surface": "wall"}


def obstacle(name: str, **surface: Any) -> dict[str, Any]:
    """A built-in shape, by name."""
    own = {} if name == "net" else {"surface": {"preset": "wall", **surface}}
    return {"type": name, **ALL[name], **own}


def throw(*obstacles: dict[str, Any], **more: Any) -> dict[str, Any]:
    """A throw, or with a pilot a flight, in a world of these obstacles."""
    start = {"start": {"position": [-1.0, 0.0, 1.0]}, "thrust": "hover"}
    return {"vehicle": "arq", "world": {"obstacles": list(obstacles)}, **start, **more}


def structures(flights: list[dict[str, Any]]) -> set[str]:
    """Kinds of these flights; each is flown."""
    for one in nonempty(flights):
        assert flight_kinds([one]), f"cannot be flown: {one}"
    return {kind.key for kind in flight_kinds(flights)}


def test_all_worlds_of_shapes_at_rest_are_one_structure() -> None:
    """Each shape with each other, each with each law, many, and planes beside them."""
    flights = [throw(obstacle(a), obstacle(b)) for a, b in itertools.combinations(ALL, 2)]
    flights += [throw(obstacle("pole", **law)) for law in LAWS]
    flights += [throw(obstacle(name), PLANE) for name in ALL]
    many = [{**obstacle("pole"), "position": [5.0 + 0.5 * k, 0.0, 0.0]} for k in range(300)]
    flights += [throw(*many), throw(obstacle("box"), obstacle("pole"), PLANE, PLANE)]
    assert len(structures(flights)) == 1


def test_contacts_with_a_memory_are_a_second_one() -> None:
    """Bristles and laws that remember the deepest depth, whatever has them, a plane included."""
    flights = [throw(obstacle(name, **law)) for name in ("pole", "mesh") for law in REMEMBERING]
    flights += [
        throw({**PLANE, "surface": {"preset": "wall", **law}}, obstacle("box", **other))
        for law in REMEMBERING
        for other in REMEMBERING
    ]
    assert len(structures(flights)) == 1
    assert len(structures([*flights, throw(obstacle("pole"))])) == 2


@pytest.mark.parametrize(
    "vehicle",
    ["arq", "quad", {"preset": "arq", "hull": False},
     {"preset": "arq", "hulls": [{"type": "box", "size": [0.1, 0.1, 0.05]}]}],
)  # fmt: skip
def test_a_vehicle_has_one_each(vehicle: Any) -> None:
    """Which arms and which hulls it has counts, not their sizes, nor which hulls."""
    flights = [throw(obstacle(name), vehicle=vehicle) for name in ("pole", "net", "stairs")]
    assert len(structures(flights)) == 1


def test_hulls_of_any_kind_are_one() -> None:
    """However many, on whatever part: all of one part are one hull."""
    kinds: list[list[dict[str, Any]]] = [
        [{"type": "box", "size": [0.1, 0.1, 0.05]}],
        [{"type": "sphere", "radius": 0.05}, {"type": "ring", "radius": 0.08}],
        [{"type": "capsule", "start": [-0.1, 0, 0], "end": [0.1, 0, 0], "radius": 0.01}],
    ]
    flights = [
        throw(obstacle("pole"), vehicle={"preset": "arq", "hulls": hulls}) for hulls in kinds
    ]
    assert len(structures(flights)) == 1


def test_planes_alone_are_two_and_then_a_scene() -> None:
    """One and two faces, whatever friction opposes; a mat is two.  Other laws make scenes."""
    mat = {"type": "mat", "distance": 20.0, "surface": "mat", "backing": "wall"}
    upright = {**PLANE, "surface": {"preset": "wall", "friction_axes": "vertical"}}
    planes = [throw(*[PLANE] * count) for count in (0, 1, 2)]
    assert len(structures(planes)) == 2
    assert structures([throw(mat), throw(upright), throw(PLANE, upright)]) <= structures(planes)
    scene = structures([throw(obstacle("pole"))])
    assert structures([throw(*[PLANE] * 3), throw(mat, PLANE), throw(*[PLANE] * 9)]) == scene
    others = LAWS[1:4]
    assert (
        structures([throw({**PLANE, "surface": {"preset": "wall", **law}}) for law in others])
        == scene
    )


def moving(count: int) -> list[dict[str, Any]]:
    """Poles that slide along."""
    motion = {"type": "constant", "velocity": [1.0, 0.0, 0.0]}
    return [
        {**obstacle("pole"), "position": [5.0 + k, 0, 0], "motion": motion} for k in range(count)
    ]


def test_what_moves_is_two_structures() -> None:
    """Up to two obstacles, and up to eight; other shapes, motions and laws are the same.

    Where a contact has a memory, few are as many.
    """
    few = [throw(*moving(1)), throw(*moving(2), PLANE), throw(*moving(1), obstacle("stairs"))]
    many = [throw(*moving(count)) for count in (3, 5, 8)]
    many += [throw(*moving(1), obstacle("box", **law)) for law in REMEMBERING]
    assert len(structures(few)) == len(structures(many)) == 1
    assert len(structures([*few, *many])) == 2


def test_what_is_compiled_ahead_serves_every_scene_of_the_presets() -> None:
    """With `springback doctor --compile` no scene of built-in shapes has to be compiled again."""
    ahead = {one.kind.key for one in kinds_of(COMMON)}
    assert len(ahead) == 2 * len(COMMON)
    pilot, recovers = (
        COMMON[name] for name in ("a pilot's flight among shapes", "a recovery among shapes")
    )
    ground = {"type": "ground", "surface": "wall"}
    worlds = [[obstacle(name)] for name in ALL]
    laws = (*LAWS, *REMEMBERING)
    worlds += [[{**PLANE, "surface": {"preset": "wall", **law}}] for law in laws]
    worlds += [[*moving(count), obstacle("box", **law)] for law in REMEMBERING for count in (1, 2)]
    worlds += [[*moving(count), obstacle("stairs")] for count in range(3, 9)]
    worlds += [[PLANE, ground], [PLANE, PLANE, ground], [*moving(1), ground], [*moving(2), PLANE]]
    for world in nonempty(worlds):
        there = {"world": {"obstacles": world}}
        for alone in (True, False):
            for flown in (throw(*world), {**pilot, **there}, {**recovers, **there}):
                [kind] = flight_kinds([flown], alone=alone)
                assert kind.key in ahead, world


def test_flights_of_a_vehicle_are_compiled_ahead_once_for_its_structure() -> None:
    """Whatever stands in the world; and a second vehicle of the structure needs nothing more."""
    ground = {"type": "ground", "surface": "wall"}
    worlds = [[obstacle(name)] for name in ALL] + [[PLANE], [PLANE, ground]]
    twins = (("arq", "crazyflie"), ("spiri", "navi"), ("caged-sphere", "tensegrity"))
    for first, second in nonempty((*twins, ("lmf2", "cognifly"), ("cognifly", "cognifly-rigid"))):
        ahead = {one.kind.key for one in kinds_of(flights_of(first))}
        assert {one.kind.key for one in kinds_of(flights_of(second))} == ahead
        if first == "spiri":  # has a hull: planes are solids as well
            for world in nonempty(worlds):
                [kind] = flight_kinds([{**throw(*world), "vehicle": second}], alone=True)
                assert kind.key in ahead, world


REFERENCES: tuple[dict[str, Any], ...] = (
    {"type": "hold"},
    {"type": "steps"},
    {"type": "steps", "positions": [[0.1 * k, 0.0, 1.0] for k in range(12)]},
    {"type": "waypoints", "positions": [[0.5 * k, 0.0, 1.0] for k in range(13)], "duration": 30.0},
    {"type": "run-up", "speed": "2 m/s", "pitch": "-20 deg", "begins": "1 s"},
)


@pytest.mark.parametrize("reference", REFERENCES, ids=lambda one: one["type"])
def test_a_pilot_compiles_nothing_for_another_reference(reference: dict[str, Any]) -> None:
    """In whatever world, up to twelve set-points or segments; a circle is one of its own."""
    ahead = {one.kind.key for one in kinds_of(COMMON)}
    worlds = [[], [PLANE], [obstacle("pole")], [*moving(1)], [*moving(4)]]
    for world in nonempty(worlds):
        flown = {"vehicle": "arq", "reference": reference, "world": {"obstacles": world}}
        for more in ({}, {"recovery": {}}):
            for alone in (True, False):
                [kind] = flight_kinds([{**flown, **more}], alone=alone)
                assert kind.key in ahead, world


def test_examples_among_shapes_are_compiled_ahead() -> None:
    """With their pilots, recoveries and settings of these, if the vehicle's hull is a preset's."""
    ahead = {one.kind.key for one in kinds_of(COMMON)}
    for name in (
        "arq_wall", "collision", "run_up", "steps", "drop", "pole", "window", "doorway", "forest",
        "imported_world", "door", "swinging_ball",
    ):  # fmt: skip
        tables = as_scenario(EXAMPLES / f"{name}.toml").model_dump(exclude_unset=True)
        [kind] = flight_kinds([tables], alone=True)
        assert kind.key in ahead, name
