"""Contacts that change places at once take what they remember with them."""

from __future__ import annotations

from typing import Any

import pytest

from springback.contact.cage import (
    BodyMotion,
    ContactFace,
    FaceMotion,
    NearestFace,
    Support,
)
from springback.contact.laws.hysteresis import no_point
from springback.contact.laws.jumps import with_jumps
from springback.contact.library import WALL
from springback.contact.surfaces import AnyExponent
from springback.kernels.vectors import Mat3, Vec
from springback.vehicle.state import ArmPose, PressedPoint, PressedPoints

NONE, X = Vec(0.0, 0.0, 0.0), Vec(1.0, 0.0, 0.0)
TOP, LOW, BOTTOM = Vec(0.1, 0.0, 0.036), Vec(0.1, 0.0, -0.032), Vec(0.1, 0.0, -0.036)
AHEAD = 5e-5  # of 0.5 m/s [m]
BODY = BodyMotion(
    NONE, Mat3(X, Vec(0.0, 1.0, 0.0), Vec(0.0, 0.0, 1.0)), NONE, NONE, Vec(0.0, 0.0, 1.0), AHEAD
)
MAIN = ArmPose(X, NONE, NONE)


def face(place: Vec, depth: float, inward: Vec = X, moving: Any = ()) -> ContactFace:
    at = Support(place, place, place, 0.0)
    nearest = NearestFace(-depth, inward, at, 1.0, NONE, NONE)
    return ContactFace(nearest, WALL.surface(AnyExponent, in_scene=True), 0.0, moving)


def point(place: Vec, deepest: float) -> PressedPoint:
    return PressedPoint(place, X, deepest, 0.0)


def after(before: list[PressedPoint], *faces: ContactFace) -> list[tuple[Vec, float]]:
    """Place and deepest depth of what is remembered, in the order in which it was."""
    blank = (no_point(),) * (6 - len(before))
    out = (face(NONE, -1.0),) * (6 - len(faces))
    found = with_jumps(PressedPoints(0.0, (*before, *blank)), (*faces, *out), MAIN, BODY)
    assert found.points[len(before) :] == blank
    return [(one.place, one.depth) for one in found.points[: len(before)]]


def test_the_other_end_of_a_rod_goes_on_with_the_memory_of_the_first() -> None:
    """Between the ends the contact stays; the end that is let go is the one that the other was."""
    before = [point(LOW, 0.0099), point(BOTTOM, 0.0098)]
    found = after(before, face(LOW, 0.0082), face(TOP, 0.0081))
    assert found == [(LOW, 0.0099), (TOP, 0.0098)]


def test_of_two_contacts_beside_one_the_nearer_is_that_one() -> None:
    """The other, 4 mm away, is what was at the other end."""
    before = [point(TOP, 0.0081), point(BOTTOM, 0.0080)]
    found = after(before, face(LOW, 0.0081), face(BOTTOM, 0.0080))
    assert found == [(LOW, 0.0081), (BOTTOM, 0.0080)]


def test_contacts_that_stay_keep_what_they_remember() -> None:
    """Also where one is let go, and another slides by some millimetres."""
    before = [point(TOP, 0.003), point(BOTTOM, 0.002)]
    assert after(before, face(Vec(0.1, 0.004, 0.036), 0.001)) == [(TOP, 0.003), (BOTTOM, 0.002)]


def test_a_jump_on_the_way_in_is_known_however_shallow() -> None:
    """What was no deeper is followed: the loss of the next step counts from there."""
    assert after([point(BOTTOM, 1e-6)], face(TOP, 1e-4)) == [(TOP, 1e-6)]


def test_inside_an_edge_another_face_is_nearest_at_once() -> None:
    """The place is the same, and the depth; only the normal is another."""
    y = Vec(0.0, 1.0, 0.0)
    blank = (no_point(),) * 5
    faces = (face(TOP, 0.008, y), *(face(NONE, -1.0),) * 5)
    pressed = with_jumps(PressedPoints(0.0, (point(TOP, 0.009), *blank)), faces, MAIN, BODY)
    assert pressed.points[0].inward == y


@pytest.mark.parametrize(
    ("depth", "speed"),
    [
        (1.5 * AHEAD, 0.0),  # it may have come so deep in a step
        (0.0009, 5.0),  # likewise, the obstacle moves
    ],
)
def test_a_new_contact_remembers_nothing(depth: float, speed: float) -> None:
    motion = (FaceMotion(Vec(-speed, 0.0, 0.0), NONE, 0.0),) if speed else ()
    before = [point(BOTTOM, 0.005)]
    out = face(NONE, -1.0, moving=motion)
    faces = (face(TOP, depth, X, motion), *(out,) * 5)
    found = with_jumps(PressedPoints(0.0, (*before, *(no_point(),) * 5)), faces, MAIN, BODY)
    assert found.points[0] == before[0]
