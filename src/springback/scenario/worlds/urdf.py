"""Robots and fixtures in URDF: links with collision shapes, placed by joints from the root.

Source: https://wiki.ros.org/urdf/XML.  Each joint gives the pose of its child in its parent when it
is at zero, which is where all of them are here.
"""

from __future__ import annotations

from springback.scenario.worlds.content import Collector
from springback.scenario.worlds.meshes import add_mesh
from springback.scenario.worlds.paths import found_file
from springback.scenario.worlds.poses import FramePose, at_origin, from_angles
from springback.scenario.worlds.xml_text import XmlNode


def read_urdf(found: Collector, root: XmlNode) -> None:
    """Add all shapes of a robot.

    Args:
        found: Takes them.
        root: Outermost element of the file.

    Raises:
        InputError: If the file is no URDF, or wrong.
    """
    if root.tag != "robot":
        raise root.problem("is not URDF, whose outermost element is robot")
    refuse_macros(root)
    links = {node.get("name"): node for node in root.all("link")}
    if not links:
        raise root.problem("has no link")
    frictions = {
        node.get("reference"): mu.number(mu.text or mu.get("value"), "mu1", least=0.0)
        for node in root.all("gazebo")
        if (mu := node.first("mu1")) is not None
    }
    for name, pose in link_poses(found, root, links).items():
        _add_link(found, links[name], name, pose, frictions.get(name))


def refuse_macros(root: XmlNode) -> None:
    """Refuse what must be expanded by another program first.

    Raises:
        InputError: Naming the first macro.
    """
    waiting = [root]
    while waiting:
        node = waiting.pop()
        if node.tag.startswith("xacro:"):
            raise node.problem("is a macro of xacro; expand the file with xacro first")
        waiting += node.nodes


def origin_of(node: XmlNode) -> FramePose:
    """Pose of the element ``<origin>`` in a node; at the origin without one.

    Raises:
        InputError: If its numbers are wrong.
    """
    origin = node.first("origin")
    if origin is None:
        return at_origin()
    place = origin.numbers(origin.get("xyz", "0 0 0"), "xyz [m]", 3)
    return from_angles(place, origin.numbers(origin.get("rpy", "0 0 0"), "rpy [rad]", 3))


def end_of(joint: XmlNode, tag: str, links: dict[str, XmlNode]) -> str:
    """Name of the link that is the parent or child of a joint.

    Raises:
        InputError: If there is no such link.
    """
    node = joint.first(tag)
    name = "" if node is None else node.get("link")
    if name not in links:
        raise joint.problem(f"{tag}: there is no link {name!r}")
    return name


def link_poses(found: Collector, root: XmlNode, links: dict[str, XmlNode]) -> dict[str, FramePose]:
    """Pose of each link in the file's frame, in the order of the tree.

    Args:
        found: Takes a remark for each joint that moves.
        root: Outermost element of the file.
        links: All links by name.

    Raises:
        InputError: If joints lead to no link, or round in a circle.
    """
    joints: dict[str, list[tuple[XmlNode, str]]] = {}
    children: dict[str, XmlNode] = {}
    for joint in root.all("joint"):
        parent, child = end_of(joint, "parent", links), end_of(joint, "child", links)
        if child in children:
            raise joint.problem(f"child: link {child!r} has two parents")
        children[child] = joint
        joints.setdefault(parent, []).append((joint, child))
    poses = {name: at_origin() for name in links if name not in children}
    waiting = list(poses)
    while waiting:
        name = waiting.pop(0)
        for joint, child in joints.get(name, ()):
            poses[child] = poses[name] @ origin_of(joint)
            waiting.append(child)
            if joint.get("type") != "fixed":
                kind = joint.get("type", "moving")
                found.remark(child, f"is at rest: {kind} joint {joint.get('name')} does not move")
    unreached = [name for name in links if name not in poses]
    if unreached:
        raise links[unreached[0]].problem(f"{unreached[0]}: its joints lead round in a circle")
    return poses


def _add_link(
    found: Collector, link: XmlNode, name: str, pose: FramePose, friction: float | None
) -> None:
    found.ignore("visual", sum(1 for _ in link.all("visual")))
    for k, collision in enumerate(link.all("collision"), start=1):
        geometry = collision.first("geometry")
        shape = None if geometry is None else next(iter(geometry.nodes), None)
        if shape is None:
            raise collision.problem("has no geometry")
        full = f"{name}/{collision.get('name') or f'collision {k}'}"
        _add_shape(found, shape, full, pose @ origin_of(collision), friction)


def _add_shape(
    found: Collector, shape: XmlNode, name: str, pose: FramePose, friction: float | None
) -> None:
    def length(key: str) -> float:
        return shape.number(shape.get(key), f"{key} [m]", above=0.0)

    if shape.tag == "box":
        size = shape.numbers(shape.get("size"), "size [m]", 3, above=0.0)
        found.box(name, pose, size, friction)
    elif shape.tag == "sphere":
        found.sphere(name, pose, length("radius"), friction)
    elif shape.tag in ("cylinder", "capsule"):
        add = found.cylinder if shape.tag == "cylinder" else found.capsule
        add(name, pose, length("radius"), length("length"), friction)
    elif shape.tag == "mesh":
        scale = shape.numbers(shape.get("scale", "1 1 1"), "scale", 3)
        if not all(scale):
            raise shape.problem("scale: must not be zero")
        path = found_file(shape.get("filename"), found.path.parent, found.search)
        add_mesh(found, name, pose, path, scale, friction)
    else:
        found.leave_out(name, f"is a {shape.tag}")
