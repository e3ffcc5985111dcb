"""Bodies and their masses in MJCF: as they are written, or from geoms, as in MuJoCo.

Source: https://mujoco.readthedocs.io/en/stable/XMLreference.html#body-inertial, #body-geom and
#compiler-inertiafromgeom.  What of that is not read is refused by name.
"""

from __future__ import annotations

import functools
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from pydantic_core import PydanticCustomError

from springback.contact.grids.mesh_files import Triangles, triangles_of
from springback.errors import InputError
from springback.scenario.masses.links import MASSLESS, LinkMass, ModelLink, symmetric
from springback.scenario.masses.solids import filled_mesh, filled_shape
from springback.scenario.worlds.content import Collector
from springback.scenario.worlds.meshes import MESHES, NO_MESHES
from springback.scenario.worlds.mjcf import (
    JOINTS,
    MAKERS,
    NOTATIONS,
    Attributes,
    MjcfReader,
    parts_of,
)
from springback.scenario.worlds.paths import file_bytes
from springback.scenario.worlds.poses import FramePose, at_origin
from springback.scenario.worlds.xml_text import XmlNode
from springback.vehicle.mass.parts import properties_of

#: Settings that change masses when a model is compiled, and the values that do not.
CHANGING = {
    "settotalmass": ("-1",), "boundmass": ("0",), "boundinertia": ("0",),
    "balanceinertia": ("false",), "exactmeshinertia": ("false",),
}  # fmt: skip
#: Density of geoms that have neither mass nor density [kg/m³], and groups that count: MuJoCo's.
DENSITY, GROUPS = "1000", "0 5"
#: What is inferred of geoms: where inertial is missing, always, never.
INFERRED = ("auto", "true", "false")
#: How the inertia of a mesh is made.
MESH_METHODS = ("legacy", "exact", "convex", "shell")
#: Of what mass is not made of.
NOT_READ = "its mass is not read; write the inertial of its body"


class _Placed(NamedTuple):
    """An element of a body, where frames put it."""

    node: XmlNode
    pose: FramePose  # of what holds it, in the body
    child_class: str  # of what names no default class


class MassSettings(NamedTuple):
    """How bodies get their mass."""

    found: Collector  # takes the files that are read
    inferred: str  # one of INFERRED
    low: float  # group from which they count
    high: float  # the last that counts


def mjcf_links(found: Collector, root: XmlNode) -> list[ModelLink]:
    """Bodies of the one robot of a file in MJCF.

    Raises:
        InputError: If there is no robot, or more than one, or it is wrong.
    """
    reader = MjcfReader(found)
    settings = reader.prepare(root)
    for key, usual in CHANGING.items():
        if settings.get(key, usual[0]).strip() not in usual:
            raise root.problem(f"compiler: {key} changes masses: not read (got {settings[key]!r})")
    inferred = settings.get("inertiafromgeom", "auto").strip()
    if inferred not in INFERRED:
        raise root.problem(
            f"compiler: inertiafromgeom: must be auto, true or false (got {inferred!r})"
        )
    low, high = root.numbers(settings.get("inertiagrouprange", GROUPS), "inertiagrouprange", 2)
    rules = MassSettings(found, inferred, low, high)
    bodies = [
        one for world in root.all("worldbody")
        for one in _placed(reader, world, at_origin(), world.get("childclass", "main"))
        if one.node.tag == "body"
    ]  # fmt: skip
    robots = [one for one in bodies if any(parts_of(one.node, *JOINTS))] or bodies
    if len(robots) != 1:
        names = ", ".join(one.node.get("name", "body") for one in robots[:20])
        what = f"has {len(robots)} bodies in the world ({names})" if robots else "has no body"
        raise InputError(f"{found.path}: {what}; mass is read from a file with one robot")
    [robot] = robots
    return list(_bodies(reader, rules, robot._replace(pose=at_origin()), True))


def _placed(
    reader: MjcfReader, holder: XmlNode, pose: FramePose, child_class: str
) -> Iterator[_Placed]:
    """All in a body, and in its frames."""
    for node in holder.nodes:
        if node.tag != "frame":
            yield _Placed(node, pose, child_class)
            continue
        there = pose @ reader.pose_of(node, node.attributes)
        yield from _placed(reader, node, there, node.get("childclass") or child_class)


def _bodies(
    reader: MjcfReader, rules: MassSettings, at: _Placed, is_fixed: bool
) -> Iterator[ModelLink]:
    """A body, whose own pose is given, and all in it."""
    body = at.node
    inner = list(_placed(reader, body, at_origin(), body.get("childclass") or at.child_class))
    mass = functools.partial(_mjcf_mass, reader, rules, body, inner)
    yield ModelLink(body.get("name", "body"), body, at.pose, is_fixed, mass)
    for one in inner:
        if one.node.tag in MAKERS:
            raise one.node.problem(f"{MAKERS[one.node.tag]}: masses of that are not read")
        if one.node.tag == "body":
            pose = at.pose @ one.pose @ reader.pose_of(one.node, one.node.attributes)
            moves = any(parts_of(one.node, *JOINTS))
            yield from _bodies(reader, rules, one._replace(pose=pose), is_fixed and not moves)


def _mjcf_mass(
    reader: MjcfReader, rules: MassSettings, body: XmlNode, inner: Sequence[_Placed]
) -> LinkMass:
    """Mass of a body; without any it is a frame without mass."""
    inertial, name = body.first("inertial"), body.get("name", "body")
    geoms = [one for one in inner if one.node.tag == "geom"]
    if rules.inferred == "true" and geoms:
        return _mass_of_geoms(reader, rules, geoms)
    if inertial is not None:
        return _written_mass(reader, inertial, name)
    if rules.inferred == "false" and geoms:
        raise body.problem(f"{name}: inertial is missing, and inertiafromgeom is false")
    return _mass_of_geoms(reader, rules, geoms)


def _written_mass(reader: MjcfReader, inertial: XmlNode, name: str) -> LinkMass:
    given = inertial.attributes
    for key in ("pos", "mass"):
        if not inertial.get(key):
            raise inertial.problem(f"{key} of body {name} is missing")
    mass = inertial.number(given["mass"], "mass [kg]", least=0.0)
    if "fullinertia" in given:
        if any(key in given for key in NOTATIONS) or "diaginertia" in given:
            raise inertial.problem("fullinertia: cannot be combined with diaginertia or a turn")
        numbers = inertial.numbers(given["fullinertia"], "fullinertia [kg m²]", 6)
        moments, products = numbers[:3], numbers[3:]
    elif "diaginertia" in given:
        moments = inertial.numbers(given["diaginertia"], "diaginertia [kg m²]", 3)
        products = [0.0, 0.0, 0.0]
    else:
        raise inertial.problem(f"diaginertia or fullinertia of body {name} is missing")
    if min(moments) < 0.0:
        raise inertial.problem(f"moments must be at least 0 kg m² (got {min(moments):g} kg m²)")
    own = LinkMass(mass, at_origin().place, symmetric(moments, products))
    return own.placed_at(reader.pose_of(inertial, given))


# -- of geoms -------------------------------------------------------------------------------------


def _mass_of_geoms(reader: MjcfReader, rules: MassSettings, geoms: Sequence[_Placed]) -> LinkMass:
    """Of those of a body together."""
    masses = []
    for one in geoms:
        given = reader.attributes_of(one.node, one.child_class)
        group = one.node.number(given.get("group", "0"), "group")
        if rules.low <= group <= rules.high:
            masses.append(_mass_of_geom(reader, rules, one.node, given).placed_at(one.pose))
    masses = [one for one in masses if one.mass > 0.0]
    if not masses:
        return MASSLESS
    known = properties_of(tuple(masses))
    return LinkMass(known.mass, np.array(known.centre), np.array(known.inertia))


def _mass_of_geom(
    reader: MjcfReader, rules: MassSettings, node: XmlNode, given: Attributes
) -> LinkMass:
    """Of one, in its body: a mass beats a density; planes have none."""
    kind = given.get("type", "sphere")
    if kind == "plane":
        return MASSLESS
    if given.get("shellinertia", "false").strip() in ("true", "1"):
        raise node.problem(f"shellinertia: {NOT_READ}")
    mass = node.number(given["mass"], "mass [kg]", least=0.0) if "mass" in given else None
    density = node.number(given.get("density", DENSITY), "density [kg/m³]", least=0.0)
    if mass == 0.0 or (mass is None and density == 0.0):
        return MASSLESS
    known = None if "mesh" in given else reader.primitive_of(node, given)
    if known is not None:
        pose, size = known
        solid = filled_shape(kind, size)
    elif kind == "mesh":
        pose, solid = reader.pose_of(node, given), _solid_of_mesh(reader, rules, node, given)
    else:
        what = "is fitted to a mesh" if "mesh" in given else f"is a {kind}"
        raise node.problem(
            f"{node.get('name', 'geom')}: {what}: its mass is not read; write the inertial"
        )
    factor = density if mass is None else mass / solid.mass
    return LinkMass(factor * solid.mass, solid.place, factor * solid.moments).placed_at(pose)


def _solid_of_mesh(
    reader: MjcfReader, rules: MassSettings, node: XmlNode, given: Attributes
) -> LinkMass:
    """What the mesh of a geom encloses, at 1 kg/m³ or, for a shell, at 1 kg/m²."""
    asset, own = reader.mesh_of(node, given)
    method = own.get("inertia", "legacy").strip()
    if method not in MESH_METHODS:
        raise asset.problem(f"inertia: must be legacy, exact, convex or shell (got {method!r})")
    for key in ("refpos", "refquat", *(("maxhullvert",) if method == "convex" else ())):
        if key in own:
            raise asset.problem(f"{key}: {NOT_READ}")
    if "file" not in own:
        raise asset.problem(f"is a mesh without a file: {NOT_READ}")
    path = reader.mesh_file(own)
    if isinstance(path, str):
        raise asset.problem(path)
    scale = reader.scale_of(asset, own)
    if path.suffix.lower() not in MESHES:
        reason = NO_MESHES.get(path.suffix.lower(), f"only {', '.join(MESHES)} are read")
        raise asset.problem(f"{path.name}: {reason}")
    rules.found.files.append(path)
    try:
        mesh = triangles_of(str(path), file_bytes(path))
        return filled_mesh(str(path), Triangles(mesh.vertices * scale, mesh.faces), method)
    except PydanticCustomError as error:
        raise asset.problem(error.message()) from None
    except InputError as error:
        raise asset.problem(error.problems[0]) from None
