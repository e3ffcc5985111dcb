"""Worlds and models in SDF, Gazebo's format: links with collision shapes, frames, includes.

Source: the specification at http://sdformat.org/spec (1.4 to 1.12).  Poses are ``x y z roll pitch
yaw``, relative to the element that holds them unless ``relative_to`` names another frame.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from springback.errors import InputError
from springback.scenario.worlds.content import Collector
from springback.scenario.worlds.meshes import add_mesh, add_relief
from springback.scenario.worlds.paths import found_file
from springback.scenario.worlds.poses import (
    FramePose,
    at_origin,
    from_angles,
    turn_from_quaternion,
)
from springback.scenario.worlds.xml_text import XmlNode, xml_root

#: Most models of a world, and levels of models in models (chosen).
MOST_MODELS, MOST_LEVELS = 20_000, 30
#: Models that come with Gazebo, for worlds without its library: what they are.
OF_GAZEBO = {"sun": "light", "ground_plane": "ground"}
#: What nothing can hit.
UNTOUCHED = ("light", "plugin", "sensor", "projector", "particle_emitter", "road")
#: Joints that hold still.
STILL = ("fixed",)


@dataclass
class SdfModel:
    """A model of the file, or of an included one."""

    name: str
    node: XmlNode  # <model>
    folder: Path  # of its file
    chain: tuple[Path, ...]  # files that include one another, this one last
    pose: XmlNode | None  # of the model in what holds it
    placed_by: str  # frame of the model whose pose that is; empty: the model's own
    is_static: bool
    is_merged: bool = False
    inner: list[SdfModel] = field(default_factory=list)
    _known: dict[str, FramePose] = field(default_factory=dict)
    _open: list[str] = field(default_factory=list)

    def frame(self, name: str, asked_by: XmlNode) -> FramePose:
        """Pose of a frame of this model in the model.

        Raises:
            InputError: If there is none of this name, or it depends on itself.
        """
        if name in ("", "__model__", "__root__", "world"):
            return at_origin()
        if name in self._known:
            return self._known[name]
        if name in self._open:
            loop = " -> ".join((*self._open[self._open.index(name) :], name))
            raise asked_by.problem(f"pose: is relative to itself: {loop}")
        self._open.append(name)
        try:
            self._known[name] = self._find(name, asked_by)
        finally:
            self._open.pop()
        return self._known[name]

    def _find(self, name: str, asked_by: XmlNode) -> FramePose:
        for node in self.node.nodes:
            if node.get("name") == name and node.tag in ("link", "frame", "joint"):
                default = ""
                if node.tag == "frame":
                    default = node.get("attached_to")
                elif node.tag == "joint" and (child := node.first("child")) is not None:
                    default = child.text
                return self.pose_of(node, default)
        for model in self.inner:
            if model.name == name and not model.is_merged:
                return self.pose_of_model(model)
            if name.startswith(f"{model.name}::"):
                inner = model.frame(name.removeprefix(f"{model.name}::"), asked_by)
                return self.pose_of_model(model) @ inner
        for model in self.inner:
            if model.is_merged and model.has_frame(name):
                return self.pose_of_model(model) @ model.frame(name, asked_by)
        raise asked_by.problem(f"pose: there is no frame {name!r} to be relative to")

    def has_frame(self, name: str) -> bool:
        """True if a node of this model has a name, or one of those that are merged into it."""
        merged = (model for model in self.inner if model.is_merged)
        own = any(node.get("name") == name for node in self.node.nodes)
        return own or any(model.has_frame(name) for model in merged)

    def pose_of(self, node: XmlNode, default: str = "") -> FramePose:
        """Pose of a node in this model.

        Args:
            node: With or without ``<pose>``.
            default: Frame that it is relative to, unless it says so.
        """
        pose = node.first("pose")
        frame = default if pose is None else pose.get("relative_to", default)
        local = at_origin() if pose is None else pose_from(pose)
        return self.frame(frame, node) @ local

    def pose_of_model(self, model: SdfModel) -> FramePose:
        """Pose of a model that this one holds, in this one."""
        frame = "" if model.pose is None else model.pose.get("relative_to")
        local = at_origin() if model.pose is None else pose_from(model.pose)
        placed = self.frame(frame, model.node) @ local
        if not model.placed_by:
            return placed
        return placed @ model.frame(model.placed_by, model.node).inverse()


def pose_from(node: XmlNode) -> FramePose:
    """Pose of an element ``<pose>``."""
    text = node.text or "0 0 0 0 0 0"
    if node.get("rotation_format") == "quat_xyzw":
        x, y, z, *q = node.numbers(text, "pose", 7)
        if not math.hypot(*q) > 0.0:
            raise node.problem("must have a quaternion that is not zero")
        return FramePose(turn_from_quaternion(q[3], *q[:3]), np.array((x, y, z)))
    x, y, z, *angles = node.numbers(text, "pose", 6)
    if node.get("degrees") in ("true", "1"):
        angles = [math.radians(angle) for angle in angles]
    return from_angles((x, y, z), angles)


def _is_true(node: XmlNode | None) -> bool:
    return node is not None and node.text in ("true", "1")


class SdfReader:
    """Reads one world with all that it includes."""

    def __init__(self, collector: Collector) -> None:
        """Add what is found to a collector."""
        self._found = collector
        self._roots: dict[Path, XmlNode] = {}
        self._count = 0

    def read(self, root: XmlNode) -> None:
        """Add all of a file.

        Raises:
            InputError: If it is not SDF, or wrong.
        """
        if root.tag not in ("sdf", "gazebo"):
            raise root.problem("is not SDF, whose outermost element is sdf")
        worlds = list(root.all("world"))
        for world in worlds[1:]:
            self._found.leave_out(world.get("name", "world"), "is a second world of the file")
        for holder in worlds[:1] or [root]:
            self._world(holder)

    def world_of(self, node: XmlNode) -> SdfModel:
        """A world, or the outermost element of a file, with all its models.

        Raises:
            InputError: If it is wrong, or what it includes.
        """
        path = self._found.path
        world = SdfModel("", node, path.parent, (path.resolve(),), None, "", True)
        self._gather(world, 0)
        return world

    def _world(self, node: XmlNode) -> None:
        world = self.world_of(node)
        for other in node.nodes:
            if other.tag in ("actor", "population"):
                what = {"actor": "moves by a script", "population": "is placed at random"}
                self._found.leave_out(other.get("name", other.tag), what[other.tag])
            elif other.tag in UNTOUCHED:
                self._found.ignore(other.tag)
            elif other.tag == "state":
                self._found.remark("state", "is not applied: models are where they are defined")
        for model in world.inner:
            self._model(model, world.pose_of_model(model), model.name)

    # -- models and includes ----------------------------------------------------------------------

    def _gather(self, holder: SdfModel, level: int) -> None:
        """Find the models in a model or world, and in those."""
        if level > MOST_LEVELS:
            raise holder.node.problem(f"has models in models more than {MOST_LEVELS} deep")
        for node in holder.node.all("model", "include"):
            self._count += 1
            if self._count > MOST_MODELS:
                raise node.problem(f"is one of more than {MOST_MODELS}; no more are read")
            model = self._own(node, holder) if node.tag == "model" else self._include(node, holder)
            if model is not None:
                holder.inner.append(model)
                self._gather(model, level + 1)

    @staticmethod
    def _own(node: XmlNode, holder: SdfModel) -> SdfModel:
        static = _is_true(node.first("static")) or (holder.is_static and bool(holder.name))
        frame, name = node.get("placement_frame"), node.get("name", "model")
        return SdfModel(name, node, holder.folder, holder.chain, node.first("pose"), frame, static)

    def _include(self, node: XmlNode, holder: SdfModel) -> SdfModel | None:
        """The model that an include names; None if it is not represented."""
        uri = node.first("uri")
        if uri is None or not uri.text:
            raise node.problem("uri is missing")
        given = node.first("name")
        name = given.text if given is not None else uri.text.rstrip("/").rpartition("/")[2]
        path = found_file(uri.text, holder.folder, self._found.search)
        if isinstance(path, str):
            self._unfound(name, uri.text, path)
            return None
        if path.is_dir():
            path = _file_of_model(path)
        if path in holder.chain:
            loop = " -> ".join(one.name for one in (*holder.chain, path))
            raise node.problem(f"includes itself: {loop}")
        root = self._root(path)
        model = root.first("model") if root.tag in ("sdf", "gazebo") else None
        if model is None:
            if root.tag in ("sdf", "gazebo") and (root.first("light") or root.first("actor")):
                self._found.ignore("light")
                return None
            raise node.problem(f"{path}: has no model")
        pose, frame = node.first("pose"), node.first("placement_frame")
        static, own = node.first("static"), model.first("pose")
        # Where the include has no pose, that of the included model counts.
        return SdfModel(
            name if given is not None else model.get("name", name), model, path.parent,
            (*holder.chain, path), own if pose is None else pose,
            model.get("placement_frame") if frame is None else frame.text,
            _is_true(model.first("static") if static is None else static)
            or (holder.is_static and bool(holder.name)),
            node.get("merge") in ("true", "1"),
        )  # fmt: skip

    def _root(self, path: Path) -> XmlNode:
        if path not in self._roots:
            self._roots[path] = xml_root(path)
            self._found.files.append(path)
        return self._roots[path]

    def _unfound(self, name: str, uri: str, why: str) -> None:
        """Note an include that is not there; two of Gazebo's own are known."""
        kind = OF_GAZEBO.get(uri.removeprefix("model://").rstrip("/"))
        if kind == "light":
            self._found.ignore("light")
        elif kind == "ground":
            self._found.plane(name, at_origin(), (0.0, 0.0, 1.0))
            self._found.remark(name, "is not there; the ground at height 0 stands for it")
        else:
            self._found.leave_out(name, why)

    # -- links ------------------------------------------------------------------------------------

    def _model(self, model: SdfModel, pose: FramePose, name: str) -> None:
        """Add the shapes of a model at its pose in the world."""
        moving = [
            joint.get("name", "joint")
            for joint in model.node.all("joint")
            if joint.get("type") not in STILL
        ]
        has_shape = any(True for link in model.node.all("link") for _ in link.all("collision"))
        if moving and has_shape:
            joints = ", ".join(moving[:3]) + (", ..." if len(moving) > 3 else "")
            self._found.remark(name, f"can move there (joint {joints}), and is at rest here")
        elif not model.is_static and has_shape:
            self._found.remark(name, "can move there, and stands still here")
        for node in model.node.nodes:
            if node.tag in UNTOUCHED:
                self._found.ignore(node.tag)
            if node.tag != "link":
                continue
            link = f"{name}/{node.get('name', 'link')}"
            in_model = model.pose_of(node)
            for part in node.nodes:
                if part.tag == "collision":
                    self._collision(part, f"{link}/{part.get('name', 'collision')}", node, model,
                                    pose, in_model)  # fmt: skip
                elif part.tag == "visual":
                    self._found.ignore("visual")
                elif part.tag in UNTOUCHED:
                    self._found.ignore(part.tag)
        for inner in model.inner:
            inner_name = name if inner.is_merged else f"{name}/{inner.name}"
            self._model(inner, pose @ model.pose_of_model(inner), inner_name)

    def _collision(
        self, node: XmlNode, name: str, link: XmlNode, model: SdfModel, pose: FramePose,
        in_model: FramePose,
    ) -> None:  # fmt: skip
        own = node.first("pose")
        if own is None or not own.get("relative_to"):
            local = in_model if own is None else in_model @ pose_from(own)
        else:
            local = model.pose_of(node)
        geometry = node.first("geometry")
        shape = next(iter(geometry.nodes), None) if geometry is not None else None
        if shape is None or shape.tag == "empty":
            self._found.ignore("empty collision")
            return
        mask = node.first("surface", "contact", "collide_bitmask")
        if mask is not None and mask.text in ("0", "0x0", "0x00", "0x0000"):
            self._found.ignore("collision that meets nothing")
            return
        add_geometry(self._found, shape, name, pose @ local, friction_of(node), model.folder)


def _file_of_model(folder: Path) -> Path:
    """File of a folder with a model: that of the newest version that ``model.config`` names."""
    config = folder / "model.config"
    if config.is_file():
        root = xml_root(config)
        named = [node for node in root.all("sdf") if node.text]

        def version(node: XmlNode) -> list[int]:
            parts = node.get("version", "0").split(".")
            return [int(part) if part.isdigit() else 0 for part in parts]

        if named:
            best = max(named, key=version)
            path = found_file(best.text, folder, ())
            if isinstance(path, str):
                raise best.problem(path)
            return path
    if not (folder / "model.sdf").is_file():
        raise InputError(f"{folder}: is a model without model.sdf")
    return (folder / "model.sdf").resolve()


def friction_of(collision: XmlNode) -> float | None:
    """Coefficient of friction of a collision; None if it gives none."""
    for path in (("ode", "mu"), ("bullet", "friction")):
        node = collision.first("surface", "friction", *path)
        if node is not None and node.text:
            return node.number(node.text, "friction", least=0.0)
    return None


def _child(shape: XmlNode, tag: str) -> XmlNode:
    node = shape.first(tag)
    if node is None:
        raise shape.problem(f"{tag} is missing")
    return node


def _length(shape: XmlNode, tag: str) -> float:
    node = _child(shape, tag)
    return node.number(node.text, f"{tag} [m]", above=0.0)


def _vector(shape: XmlNode, tag: str, default: str, *, above: float | None = None) -> list[float]:
    node = shape.first(tag)
    asked = shape if node is None else node
    text = default if node is None else node.text
    return asked.numbers(text, f"{tag} [m]", len(default.split()), above=above)


def add_geometry(
    found: Collector, shape: XmlNode, name: str, pose: FramePose, friction: float | None,
    folder: Path,
) -> None:  # fmt: skip
    """Add the shape in a ``<geometry>``.

    Args:
        found: Takes it.
        shape: The element of the shape.
        name: Name of the collision.
        pose: Of the collision in the world.
        friction: Of the file.
        folder: Of the file.

    Raises:
        InputError: If its numbers are wrong.
    """
    kind = shape.tag
    if kind == "box":
        size = _child(shape, "size")
        found.box(name, pose, size.numbers(size.text, "size [m]", 3, above=0.0), friction)
    elif kind == "sphere":
        found.sphere(name, pose, _length(shape, "radius"), friction)
    elif kind in ("cylinder", "capsule", "cone"):
        add = {"cylinder": found.cylinder, "capsule": found.capsule, "cone": found.cone}[kind]
        add(name, pose, _length(shape, "radius"), _length(shape, "length"), friction)
    elif kind == "ellipsoid":
        radii = _vector(shape, "radii", "1 1 1", above=0.0)
        found.ellipsoid(name, pose, radii, friction)
    elif kind == "plane":
        normal = _vector(shape, "normal", "0 0 1")
        if not math.hypot(*normal) > 0.0:
            raise shape.problem("normal: must not be zero")
        found.plane(name, pose, normal, friction)
    elif kind == "mesh":
        _add_mesh(found, shape, name, pose, friction, folder)
    elif kind == "heightmap":
        uri = _child(shape, "uri")
        across = _vector(shape, "size", "1 1 1", above=0.0)
        moved = pose @ from_angles(_vector(shape, "pos", "0 0 0"), (0.0, 0.0, 0.0))
        path = found_file(uri.text, folder, found.search)
        add_relief(found, name, moved, path, (across[0], across[1]), across[2], friction=friction)
    else:
        found.leave_out(name, f"is of shape {kind}")


def _add_mesh(
    found: Collector, shape: XmlNode, name: str, pose: FramePose, friction: float | None,
    folder: Path,
) -> None:  # fmt: skip
    uri, submesh = _child(shape, "uri"), shape.first("submesh")
    if submesh is not None and submesh.first("name") is not None:
        found.leave_out(name, f"is a part of a mesh, {uri.text}")
        return
    scale = _vector(shape, "scale", "1 1 1")
    if not all(scale):
        raise shape.problem("scale: must not be zero")
    add_mesh(found, name, pose, found_file(uri.text, folder, found.search), scale, friction)
