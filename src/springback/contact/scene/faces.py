"""All solids of a world as one obstacle: the faces that a cage or a hull meets, found by a routine.

However many solids there are, and of whatever kinds, the equations of motion see `FACES` faces for
each part of a vehicle: those nearest to it.  Each half-space is one face.  All other solids
together are one shape, whose distance is the least of theirs: a ring meets it at its two lowest
points, a sphere at one, or at two that are apart.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.contact.cage import (
    NO_CAGE,
    ArmTip,
    ContactFace,
    NearestFace,
    Ring,
    Support,
    at_low_point,
    at_second_point,
    cage_gap,
    contact_faces,
    face_along_normal,
    face_of,
    lowest_gap,
    obstacles_in_body_frame,
    per_face,
    simple_face,
    support,
    touching_radius,
)
from springback.contact.obstacles import (
    InBodyFrame,
    Obstacle,
    Plane,
    obstacle_in_body_frame,
    signed_distance,
)
from springback.contact.rings import FAR, LowPoint, lowest_in_disc, lowest_on_ring, on_ring
from springback.contact.scene.nearest import (
    HALF_SPACES,
    HEADER,
    MOST_NEAR,
    SOLIDS,
    SURFACES,
    NearestSolids,
    nearest_row,
    nearest_solid,
    row_of_near,
    solids_within,
)
from springback.contact.scene.ring_views import along_ring, is_smooth, lowest_by_strides
from springback.contact.scene.sections import FARTHEST, Face, vector_at
from springback.contact.scene.solids import (
    AXES,
    BOX,
    CENTRE,
    GROUND,
    KIND,
    NET,
    ROUNDING,
    SIZES,
    SURFACE,
    WIDTH,
    solid_face,
    solid_face_within,
)
from springback.contact.surfaces import AnyExponent, Hysteresis, Surface
from springback.kernels.compiler import generic, kernel
from springback.kernels.routines import Routine, call_routine, number_at
from springback.kernels.trees import minimum, tree_map
from springback.kernels.vectors import Mat3, Vec, norm
from springback.vehicle.state import ArmPose, Propeller, Sphere

#: Faces that one part of a vehicle can meet at the same time: a corner has three.
FACES = 3
#: In flight gaps above this are lower bounds [m] (chosen: only what may soon touch is looked for).
EXACT_BELOW = 0.05
#: Two contact points of a sphere that are closer than this are one [m] (chosen).
APART = 1e-3
#: Tolerance within which a point of one solid is on the surface of all [m].
ON_SURFACE = 1e-9

#: Numbers of a surface, and the place of the address of its curve among them.
SURFACE_WIDTH, SURFACE_CURVE = 13, 11
#: Kinds of parts, by number.
RING, TIP, SPHERE, DISC = 0.0, 1.0, 2.0, 3.0
#: Gaps of a propeller above this are lower bounds [m] (chosen: only hits are looked for).
DISC_BELOW = 2e-3


class SolidScene(NamedTuple):
    """All built-in solids of a world, and the user's own shapes beside them."""

    table: float  # address of the numbers
    query: float  # address of `scene_faces`
    own: tuple[Obstacle, ...]
    exact: float  # 0: gaps above `EXACT_BELOW` may be lower bounds, 1: they are exact
    hull_query: float = 0.0  # of `springback.contact.hulls.compound.scene_hull_faces`
    rounding: float = 0.0  # of rings that are hulls [rad]
    bristles: float = 0.0  # 1 if a surface has any
    remembers: float = 0.0  # 1 if a surface remembers the deepest depth
    memory: float = 0.0  # 1: contacts have a state of their own, though no surface needs it


class SceneInBodyFrame(NamedTuple):
    """A scene, viewed from a body."""

    table: float
    query: float
    own: tuple[Obstacle, ...]  # in the body frame
    position: Vec  # of the body, world [m]
    r: Mat3  # body axes to world axes
    exact: float
    hull_query: float
    rounding: float


class VehiclePart(NamedTuple):
    """A part of a vehicle for which faces are looked for."""

    table: float
    kind: float  # RING, TIP, SPHERE or DISC
    rounding: float  # of a ring
    radius: float  # [m]
    pose: ArmPose
    position: Vec  # of the main body, world [m]
    r: Mat3  # body axes to world axes
    exact: float  # 0: gaps above `EXACT_BELOW` may be lower bounds


class ThreeFaces(NamedTuple):
    """The faces found so far, nearest first."""

    first: ContactFace
    second: ContactFace
    third: ContactFace


@kernel
def surface_at(table: float, row: int) -> Surface:
    """Surface of the solid whose numbers begin at a position of a table."""
    k = int(number_at(table, SURFACES))
    k += SURFACE_WIDTH * int(number_at(table, row + SURFACE))
    return Surface(
        number_at(table, k), number_at(table, k + 1), number_at(table, k + 2),
        AnyExponent(number_at(table, k + 3)), number_at(table, k + 4),
        number_at(table, k + 5), number_at(table, k + 6), number_at(table, k + 7),
        number_at(table, k + 8), number_at(table, k + 9),
        (Hysteresis(number_at(table, k + 10), number_at(table, k + 11), number_at(table, k + 12)),),
    )  # fmt: skip


@kernel
def no_face() -> ContactFace:
    """A face out of reach."""
    none = Vec(0.0, 0.0, 0.0)
    surface = Surface(
        0.0, 0.0, 0.0, AnyExponent(1.5), 0.0, 0.0, 1.0, -1.0, 0.0, 0.0,
        (Hysteresis(0.0, 0.0, 0.0),),
    )  # fmt: skip
    nearest = simple_face(FAR, Vec(0.0, 0.0, 1.0), Support(none, none, none, 0.0))
    return ContactFace(nearest, surface, 0.0, ())


@kernel
def no_faces() -> ThreeFaces:
    """No face within reach."""
    return ThreeFaces(no_face(), no_face(), no_face())


@kernel
def _with_face(found: ThreeFaces, table: float, row: int, nearest: NearestFace) -> ThreeFaces:
    """Faces with one more, if it is nearer than the farthest of them."""
    gap = nearest.gap
    if gap >= found.third.nearest.gap:
        return found
    new = ContactFace(nearest, surface_at(table, row), number_at(table, row + GROUND), ())
    if gap < found.first.nearest.gap:
        return ThreeFaces(new, found.first, found.second)
    if gap < found.second.nearest.gap:
        return ThreeFaces(found.first, new, found.second)
    return ThreeFaces(found.first, found.second, new)


@kernel
def _on_plane(part: VehiclePart, plane: Plane) -> NearestFace:
    """Face of a plane in the body frame."""
    pose = part.pose
    if part.kind == RING:
        return face_along_normal(plane, Ring(part.rounding), part.radius, pose)
    if part.kind == TIP:
        return face_along_normal(plane, ArmTip(0.0), part.radius, pose)
    if part.kind == DISC:
        return face_along_normal(plane, Propeller(0.0, 0.0), part.radius, pose)
    return _of_sphere(Face(signed_distance(plane, pose.lever), plane.normal), part.radius)


@kernel
def _of_sphere(there: Face, radius: float) -> NearestFace:
    """Face that a sphere meets, by the distance and its gradient at its centre, body axes."""
    steepness, none = norm(there.normal), Vec(0.0, 0.0, 0.0)
    inward = there.normal * (-1.0 / steepness)
    lever = inward * radius
    at = Support(lever, lever, lever, 0.0)
    return NearestFace(there.gap - radius, inward, at, steepness, none, none)


@kernel
def _plane_in_body_frame(part: VehiclePart, normal: Vec, point: Vec) -> Plane:
    """Plane through a point of the world."""
    return Plane(normal @ part.r, normal @ (point - part.position))


@kernel
def _with_half_spaces(found: ThreeFaces, part: VehiclePart) -> ThreeFaces:
    table = part.table
    for k in range(int(number_at(table, HALF_SPACES))):
        row = HEADER + WIDTH * k
        normal, point = vector_at(table, row + AXES + 6), vector_at(table, row + CENTRE)
        nearest = _on_plane(part, _plane_in_body_frame(part, normal, point))
        found = _with_face(found, table, row, nearest)
    return found


@kernel
def _ring_on_box(part: VehiclePart, row: int, centre: Vec) -> NearestFace:
    """Face of a box or net over which the whole of a ring is; `FAR` if there is none."""
    table, half, radius = part.table, vector_at(part.table, row + SIZES), part.radius
    relative = centre - vector_at(table, row + CENTRE)
    ex, ey = vector_at(table, row + AXES), vector_at(table, row + AXES + 3)
    ez, edge = vector_at(table, row + AXES + 6), number_at(table, row + ROUNDING)
    q = Vec(ex @ relative, ey @ relative, ez @ relative)
    u = Vec(abs(q.x) - half.x, abs(q.y) - half.y, abs(q.z) - half.z)
    over_x, over_y, over_z = u.x <= -radius, u.y <= -radius, u.z <= -radius
    if number_at(table, row + KIND) == BOX:
        if over_x & over_y & (u.z >= u.x) & (u.z >= u.y):
            n = ez if q.z > 0.0 else -ez
            return _on_face(part, row, n, half.z + edge)
        if over_x & over_z & (u.y >= u.x) & (u.y >= u.z):
            n = ey if q.y > 0.0 else -ey
            return _on_face(part, row, n, half.y + edge)
        if over_y & over_z & (u.x >= u.y) & (u.x >= u.z):
            n = ex if q.x > 0.0 else -ex
            return _on_face(part, row, n, half.x + edge)
    if (number_at(table, row + KIND) == NET) & over_x & over_y:
        # All of the ring is nearer to the face than to the sides, and not yet through.
        low, aside = q.z - radius, u.x if u.x > u.y else u.y
        if (low > -half.z) & (low >= aside + radius):
            return _on_face(part, row, ez, 0.0)
    return no_face().nearest


@kernel
def _on_face(part: VehiclePart, row: int, normal: Vec, height: float) -> NearestFace:
    """Face of a solid at some height above its centre [m], as part of a plane."""
    point = vector_at(part.table, row + CENTRE) + height * normal
    return _on_plane(part, _plane_in_body_frame(part, normal, point))


@kernel
def _with_ring(
    found: ThreeFaces, part: VehiclePart, near: NearestSolids, centre: Vec
) -> ThreeFaces:
    """Faces with those that a ring meets on solids."""
    if near.number == 1:
        row = row_of_near(near, 0)
        whole = _ring_on_box(part, row, centre)
        if whole.gap < FAR:
            return _with_face(found, part.table, row, whole)
        along, middle = along_ring(part.table, row, centre, part.r), Vec(0.0, 0.0, 0.0)
        lowest = (
            lowest_by_strides(along, part.radius, part.pose.direction)
            if is_smooth(along.form)
            else lowest_on_ring(along, middle, part.radius, part.pose.direction)
        )
        if lowest.second.gap < FAR:
            found = _with_face(found, part.table, row, at_second_point(part.radius, lowest))
        return _with_face(found, part.table, row, at_low_point(part.radius, lowest.first))
    view = InBodyFrame(near, part.position, part.r)
    low = lowest_on_ring(view, part.pose.lever, part.radius, part.pose.direction)
    if low.second.gap < FAR:
        row = _row_at(part, near, low.second)
        found = _with_face(found, part.table, row, at_second_point(part.radius, low))
    row = _row_at(part, near, low.first)
    return _with_face(found, part.table, row, at_low_point(part.radius, low.first))


@kernel
def _row_at(part: VehiclePart, near: NearestSolids, low: LowPoint) -> int:
    """Position of the numbers of the solid that is nearest to a point of a ring."""
    at = on_ring(part.pose.lever, part.radius, low.towards)
    return nearest_row(near, part.position + part.r @ at)


@kernel
def _tip_on_solid(part: VehiclePart, row: int, centre: Vec) -> NearestFace:
    """Face of one solid that the paper's contact point meets."""
    table, pose, position, r = part.table, part.pose, part.position, part.r
    slope = solid_face(table, row, centre).normal @ r
    n = slope * (-1.0 / norm(slope))
    at = support(ArmTip(0.0), n, pose.direction, part.radius)
    point = position + r @ (pose.lever + at.point)
    return simple_face(solid_face(table, row, point).gap, n, at)


@kernel
def _with_tip(found: ThreeFaces, part: VehiclePart, near: NearestSolids, centre: Vec) -> ThreeFaces:
    """Faces with the one that the paper's contact point meets on solids: the lowest of all."""
    row = nearest_row(near, centre)
    lowest = _tip_on_solid(part, row, centre)
    for k in range(near.number if near.number <= MOST_NEAR else 0):
        other = _tip_on_solid(part, row_of_near(near, k), centre)
        if other.gap < lowest.gap:
            lowest, row = other, row_of_near(near, k)
    return _with_face(found, part.table, row, lowest)


@kernel
def is_exposed(near: NearestSolids, row: int, point: Vec) -> bool:
    """True if a point on the surface of a solid is inside no other one."""
    exposed = True
    for k in range(near.number):
        other = row_of_near(near, k)
        if other != row and solid_face(near.table, other, point).gap < -ON_SURFACE:
            exposed = False
    return exposed


@kernel
def _with_sphere(
    found: ThreeFaces, part: VehiclePart, near: NearestSolids, centre: Vec
) -> ThreeFaces:
    """Faces with those that a sphere meets: the nearest solid, and the next one apart from it."""
    table = part.table
    nearest = nearest_row(near, centre)
    first = solid_face(table, nearest, centre)
    touched = centre - first.gap * first.normal
    in_body = Face(first.gap, first.normal @ part.r)
    found = _with_face(found, table, nearest, _of_sphere(in_body, part.radius))
    second, second_row = first, -1
    for k in range(near.number if near.number <= MOST_NEAR else 0):
        row = row_of_near(near, k)
        if row == nearest:
            continue
        there = solid_face(table, row, centre)
        point = centre - there.gap * there.normal
        apart = point - touched
        nearer = second_row < 0 or there.gap < second.gap
        is_apart = apart @ apart > APART * APART
        if nearer and is_apart and is_exposed(near, row, point):
            second, second_row = there, row
    if second_row >= 0:
        in_body = Face(second.gap, second.normal @ part.r)
        found = _with_face(found, table, second_row, _of_sphere(in_body, part.radius))
    return found


@kernel
def _with_disc(found: ThreeFaces, part: VehiclePart, near: NearestSolids, row: int) -> ThreeFaces:
    """Faces with one as near as solids are to a propeller's disc."""
    view = InBodyFrame(near, part.position, part.r)
    gap = lowest_in_disc(view, part.pose.lever, part.radius)
    in_body = Face(gap + part.radius, Vec(0.0, 0.0, 1.0))
    return _with_face(found, part.table, row, _of_sphere(in_body, part.radius))


@kernel
def scene_faces(part: VehiclePart) -> ThreeFaces:
    """The faces that a part of a vehicle meets, or is next to, in body axes."""
    table = part.table
    if part.radius < 0.0:  # it is no cage
        return no_faces()
    found = _with_half_spaces(no_faces(), part)
    if number_at(table, SOLIDS) > 0.0:
        centre = part.position + part.r @ part.pose.lever
        known = DISC_BELOW if part.kind == DISC else EXACT_BELOW
        within = part.radius + known if part.exact == 0.0 else FARTHEST
        nearest = nearest_solid(table, centre, within)
        if (part.exact == 0.0) & (nearest.gap >= within):
            there = solid_face_within(table, nearest.row, centre, within)
            in_body = Face(there.gap, there.normal @ part.r)
            return _with_face(found, table, nearest.row, _of_sphere(in_body, part.radius))
        near = solids_within(table, centre, nearest, 2.0 * part.radius)
        if part.kind == RING:
            return _with_ring(found, part, near, centre)
        if part.kind == TIP:
            return _with_tip(found, part, near, centre)
        if part.kind == DISC:
            return _with_disc(found, part, near, nearest.row)
        return _with_sphere(found, part, near, centre)
    return found


def blank_part() -> VehiclePart:
    """A part of the type that routines are made for."""
    none = Vec(0.0, 0.0, 0.0)
    pose = ArmPose(none, none, none)
    return VehiclePart(0.0, 0.0, 0.0, 0.0, pose, none, Mat3(none, none, none), 0.0)


#: `scene_faces`, compiled once for all vehicles and worlds.
SCENE_FACES = Routine(scene_faces, blank_part())


@generic
def part_numbers(contact_point: Any) -> tuple[float, float]:
    """Kind of a part of a vehicle as a number, and the rounding of a ring."""
    raise TypeError(f"{type(contact_point).__name__} is not a contact point model")


@part_numbers.register(Ring)
@kernel
def _ring_numbers(ring: Ring) -> tuple[float, float]:
    return RING, ring.rounding


@part_numbers.register(ArmTip)
@kernel
def _tip_numbers(tip: ArmTip) -> tuple[float, float]:
    return TIP, 0.0


@part_numbers.register(Sphere)
@kernel
def _sphere_numbers(hull: Sphere) -> tuple[float, float]:
    return SPHERE, 0.0


@part_numbers.register(Propeller)
@kernel
def _disc_numbers(disc: Propeller) -> tuple[float, float]:
    return DISC, 0.0


@kernel
def part_of(
    scene: SceneInBodyFrame, contact_point: Any, radius: float, arm: ArmPose
) -> VehiclePart:
    """A part of a vehicle, for a search in a scene; arguments as for `contact_faces`."""
    kind, rounding = part_numbers(contact_point)
    at, r = scene.position, scene.r
    return VehiclePart(scene.table, kind, rounding, radius, arm, at, r, scene.exact)


@kernel
def _found_faces(
    scene: SceneInBodyFrame, contact_point: Any, radius: float, arm: ArmPose
) -> ThreeFaces:
    return call_routine(scene.query, part_of(scene, contact_point, radius, arm), no_faces())


@obstacles_in_body_frame.register(SolidScene)
@kernel
def _scene_in_body_frame(scene: SolidScene, position: Vec, r: Mat3) -> SceneInBodyFrame:
    own = tree_map(obstacle_in_body_frame, (scene.own,), (position, r))
    exact, hulls, rounding = scene.exact, scene.hull_query, scene.rounding
    return SceneInBodyFrame(scene.table, scene.query, own, position, r, exact, hulls, rounding)


@contact_faces.register(SceneInBodyFrame)
@kernel
def _scene_contact_faces(
    scene: SceneInBodyFrame, contact_point: Any, radius: float, arm: ArmPose, engaged: float
) -> tuple[ContactFace, ...]:
    found = no_faces()
    if engaged > 0.0:
        found = _found_faces(scene, contact_point, radius, arm)
    own = tree_map(face_of, (scene.own,), (contact_point, radius, arm))
    return (found.first, found.second, found.third) + own  # noqa: RUF005


@touching_radius.register(SceneInBodyFrame)
@kernel
def radius_in_scene(scene: Any, radius: float, caged: float) -> float:
    """Radius of the circle that touches a scene [m]; arguments as for `touching_radius`."""
    return radius if caged > 0.0 else NO_CAGE


@lowest_gap.register(SceneInBodyFrame)
@kernel
def _scene_gap(scene: SceneInBodyFrame, contact_point: Any, radius: float, arm: ArmPose) -> float:
    found = _found_faces(scene, contact_point, radius, arm)
    own = tree_map(cage_gap, (scene.own,), (contact_point, radius, arm))
    return minimum((found.first.nearest.gap,) + own)  # noqa: RUF005


@per_face.register(SolidScene)
@kernel
def _per_scene_face(scene: SolidScene, value: float) -> tuple[float, ...]:
    return (value, value, value) + per_face(scene.own, value)  # noqa: RUF005


@per_face.register(SceneInBodyFrame)
@kernel
def _per_face_in_body_frame(scene: SceneInBodyFrame, value: float) -> tuple[float, ...]:
    return (value, value, value) + per_face(scene.own, value)  # noqa: RUF005
