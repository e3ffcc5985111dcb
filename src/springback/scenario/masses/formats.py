"""Links and their masses in SDF and URDF, and the format of a file; MJCF is in `mjcf`.

Sources: http://sdformat.org/spec and https://wiki.ros.org/urdf/XML/link.  What a program would make
of a mass that is not written there, from shapes and densities or by default, is refused.
"""

from __future__ import annotations

import functools
from collections.abc import Iterator
from pathlib import Path

from springback.errors import InputError
from springback.scenario.masses.links import MASSLESS, LinkMass, ModelLink, symmetric
from springback.scenario.masses.mjcf import mjcf_links
from springback.scenario.worlds.content import Collector
from springback.scenario.worlds.poses import FramePose, at_origin
from springback.scenario.worlds.sdf import STILL, SdfModel, SdfReader, pose_from
from springback.scenario.worlds.urdf import end_of, link_poses, origin_of, refuse_macros
from springback.scenario.worlds.xml_text import XmlNode

MOMENTS, PRODUCTS = ("ixx", "iyy", "izz"), ("ixy", "ixz", "iyz")


# -- SDF ------------------------------------------------------------------------------------------


def sdf_links(found: Collector, root: XmlNode) -> list[ModelLink]:
    """Links of the one robot of a file in SDF, those of models in it with its name: ``arm::tip``.

    Raises:
        InputError: If there is no model that can move, or more than one, or one is wrong.
    """
    worlds = list(root.all("world"))
    world = SdfReader(found).world_of(worlds[0] if worlds else root)
    for one in found.content().missing:
        raise InputError(f"{found.path}: {one.name}: {one.reason}")
    models = [model for model in world.inner if not model.is_static]
    models = models or world.inner
    if len(models) != 1:
        names = ", ".join(model.name for model in models[:20])
        what = f"has {len(models)} models ({names})" if models else "has no model"
        raise InputError(f"{found.path}: {what}; mass is read from a file with one")
    [robot] = models
    together = _fixed_together(robot)
    return [
        ModelLink(name, node, pose, name in together, functools.partial(_sdf_mass, node))
        for name, node, pose in _links_of(robot, "", at_origin())
    ]


def _links_of(
    model: SdfModel, prefix: str, pose: FramePose
) -> Iterator[tuple[str, XmlNode, FramePose]]:
    """Links of a model at a pose, by full name."""
    for link in model.node.all("link"):
        yield prefix + link.get("name"), link, pose @ model.pose_of(link)
    for inner in model.inner:
        yield from _links_of(inner, _inner(inner, prefix), pose @ model.pose_of_model(inner))


def _inner(model: SdfModel, prefix: str) -> str:
    return prefix if model.is_merged else f"{prefix}{model.name}::"


def _first_link(model: SdfModel, prefix: str) -> str | None:
    """Full name of a model's canonical link: the one that it names, else its first."""
    named = model.node.get("canonical_link")
    if named:
        return prefix + named
    links = _links_of(model, prefix, at_origin())
    return next((name for name, _, _ in links), None)


def _link_at(model: SdfModel, prefix: str, word: str, asked_by: XmlNode) -> str | None:
    """Full name of the link that a joint's parent or child is, or is attached to; None: the world.

    Raises:
        InputError: If there is none.
    """
    if word == "world":
        return None
    for _ in range(len(model.node.nodes) + 1):
        if word in ("", "__model__"):
            return _first_link(model, prefix)
        node = next((n for n in model.node.all("link", "frame") if n.get("name") == word), None)
        if node is None:
            break
        if node.tag == "link":
            return prefix + word
        word = node.get("attached_to")
    for inner in model.inner:
        name = _inner(inner, prefix)
        if word == inner.name and not inner.is_merged:
            return _first_link(inner, name)
        if inner.is_merged and inner.has_frame(word):
            return _link_at(inner, name, word, asked_by)
        if not inner.is_merged and word.startswith(f"{inner.name}::"):
            return _link_at(inner, name, word.removeprefix(f"{inner.name}::"), asked_by)
    raise asked_by.problem(f"{asked_by.get('name')}: there is no link {word!r}")


def _pairs(model: SdfModel, prefix: str) -> Iterator[tuple[str, str]]:
    """Links that fixed joints hold together."""
    for joint in model.node.all("joint"):
        if joint.get("type") in STILL:
            ends = [_child(joint, tag) for tag in ("parent", "child")]
            first, second = (_link_at(model, prefix, end.text, joint) for end in ends)
            if first is not None and second is not None:
                yield first, second
    for inner in model.inner:
        yield from _pairs(inner, _inner(inner, prefix))


def _fixed_together(model: SdfModel) -> set[str]:
    """Names of a model's canonical link and of all that fixed joints hold to it."""
    first, pairs = _first_link(model, ""), list(_pairs(model, ""))
    held, waiting = set[str](), [] if first is None else [first]
    while waiting:
        name = waiting.pop()
        if name not in held:
            held.add(name)
            waiting += [b for a, b in pairs if a == name] + [a for a, b in pairs if b == name]
    return held


def _sdf_mass(link: XmlNode) -> LinkMass:
    inertial = link.first("inertial")
    name = link.get("name")
    if inertial is None:
        raise link.problem(f"{name}: inertial is missing; Gazebo then assumes 1 kg and 1 kg m²")
    if inertial.get("auto") in ("true", "1"):
        raise inertial.problem(f"of link {name} is automatic, from shapes and densities: not read")
    pose = inertial.first("pose")
    mass = _child(inertial, "mass", name)
    inertia = _child(inertial, "inertia", name)
    moments = [_child(inertia, key, name) for key in MOMENTS]
    products = [inertia.first(key) for key in PRODUCTS]
    own = LinkMass(
        mass.number(mass.text, "mass [kg]", least=0.0),
        at_origin().place,
        symmetric(
            [one.number(one.text, f"{one.tag} [kg m²]", least=0.0) for one in moments],
            [0.0 if n is None else n.number(n.text, f"{n.tag} [kg m²]") for n in products],
        ),
    )
    return own.placed_at(at_origin() if pose is None else pose_from(pose))


def _child(node: XmlNode, tag: str, link: str = "") -> XmlNode:
    found = node.first(tag)
    if found is None:
        raise node.problem(f"{tag} of link {link} is missing" if link else f"{tag} is missing")
    return found


# -- URDF -----------------------------------------------------------------------------------------


def urdf_links(found: Collector, root: XmlNode) -> list[ModelLink]:
    """Links of a robot in URDF.

    Raises:
        InputError: If it has no link, or is wrong.
    """
    refuse_macros(root)
    links = {node.get("name"): node for node in root.all("link")}
    if not links:
        raise root.problem("has no link")
    poses = link_poses(found, root, links)
    moving = {end_of(j, "child", links) for j in root.all("joint") if j.get("type") != "fixed"}
    parents = {end_of(j, "child", links): end_of(j, "parent", links) for j in root.all("joint")}
    first = next(iter(poses))
    held = {first}
    for name in poses:  # parents come before their children
        if parents.get(name) in held and name not in moving:
            held.add(name)
    return [
        ModelLink(name, links[name], pose, name in held,
                  functools.partial(_urdf_mass, links[name]))
        for name, pose in poses.items()
    ]  # fmt: skip


def _urdf_mass(link: XmlNode) -> LinkMass:
    """Mass of a link; without the element it is a frame without mass."""
    inertial, name = link.first("inertial"), link.get("name")
    if inertial is None:
        return MASSLESS
    mass, inertia = _child(inertial, "mass", name), _child(inertial, "inertia", name)
    for key in (*MOMENTS, *PRODUCTS):
        if not inertia.get(key):
            raise inertia.problem(f"{key} of link {name} is missing")
    own = LinkMass(
        mass.number(mass.get("value"), "value [kg]", least=0.0),
        at_origin().place,
        symmetric(
            [inertia.number(inertia.get(key), f"{key} [kg m²]", least=0.0) for key in MOMENTS],
            [inertia.number(inertia.get(key), f"{key} [kg m²]") for key in PRODUCTS],
        ),
    )
    return own.placed_at(origin_of(inertial))


def links_of(path: Path, root: XmlNode) -> tuple[list[ModelLink], Collector]:
    """Links of a model, and what knows the files that are read for it.

    Args:
        path: Of the file.
        root: Its outermost element, which tells the format.

    Raises:
        InputError: One line, if it is of no format that is read, or wrong.
    """
    readers = {"sdf": sdf_links, "gazebo": sdf_links, "robot": urdf_links, "mujoco": mjcf_links}
    if root.tag not in readers:
        raise root.problem("is neither SDF (sdf), MJCF (mujoco) nor URDF (robot)")
    found = Collector(path, (), ())
    return readers[root.tag](found, root), found
