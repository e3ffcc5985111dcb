"""Models in MJCF, MuJoCo's format: geoms of bodies, with default classes, frames and includes.

Source: https://mujoco.readthedocs.io/en/stable/XMLreference.html.  Sizes are halves, angles are in
degrees unless the compiler says otherwise, and bodies are where they are at the start.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from pathlib import Path

import numpy as np

from springback.scenario.worlds.content import Collector
from springback.scenario.worlds.meshes import add_mesh, add_relief
from springback.scenario.worlds.paths import found_file
from springback.scenario.worlds.poses import (
    Array,
    FramePose,
    at_origin,
    turn_about,
    turn_from_axes,
    turn_from_quaternion,
    turn_in_sequence,
    turn_to,
)
from springback.scenario.worlds.xml_text import XmlNode, xml_root

Attributes = Mapping[str, str]

#: Most files that are included (chosen), and notations of an attitude.
MOST_INCLUDES = 1000
NOTATIONS = ("quat", "axisangle", "xyaxes", "zaxis", "euler")
#: Elements of a body that make others: not represented.
MAKERS = {
    "replicate": "repeats what it holds",
    "composite": "makes bodies by a rule",
    "flexcomp": "is deformable",
    "attach": "attaches a part of another model",
}
#: Elements of a body that let it move.
JOINTS = ("joint", "freejoint")
#: Elements of a body that nothing can hit.
UNTOUCHED = ("light", "site", "camera", "plugin")


class MjcfReader:
    """Reads one model with all that it includes."""

    def __init__(self, collector: Collector) -> None:
        """Add what is found to a collector."""
        self._found = collector
        self._includes = 0
        self._settings: dict[str, str] = {}  # of <compiler>
        self._classes: dict[str, dict[str, dict[str, str]]] = {}
        self._meshes: dict[str, XmlNode] = {}
        self._reliefs: dict[str, XmlNode] = {}

    def read(self, root: XmlNode) -> None:
        """Add all of a file.

        Raises:
            InputError: If it is not MJCF, or wrong.
        """
        self.prepare(root)
        for node in root.all("worldbody"):
            self._body(node, at_origin(), "", "main")

    def prepare(self, root: XmlNode) -> Attributes:
        """Read what is included, settings, default classes and assets; returns the settings.

        Raises:
            InputError: If the file is not MJCF, or wrong.
        """
        if root.tag != "mujoco":
            raise root.problem("is not MJCF, whose outermost element is mujoco")
        self._expand(root, (self._found.path.resolve(),))
        for node in root.all("compiler"):
            self._settings.update(node.attributes)
        if self._settings.get("coordinate", "local") != "local":
            raise root.problem("compiler: coordinate: must be local")
        sequence = self._settings.get("eulerseq", "xyz")
        if len(sequence) != 3 or not set(sequence.lower()) <= set("xyz"):
            raise root.problem(f"compiler: eulerseq: must be three of x, y, z (got {sequence!r})")
        for node in root.all("default"):
            self._add_class(node, {}, "main")
        for assets in root.all("asset"):
            for node in assets.nodes:
                name = node.get("name") or Path(node.get("file")).stem
                if node.tag in ("mesh", "hfield"):
                    (self._meshes if node.tag == "mesh" else self._reliefs)[name] = node
        for node in root.all("deformable"):
            for one in node.nodes:
                self._found.leave_out(one.get("name", one.tag), "is deformable")
        return self._settings

    def _expand(self, node: XmlNode, chain: tuple[Path, ...]) -> None:
        """Put what is included in the place of ``<include>``."""
        nodes: list[XmlNode] = []
        for inner in node.nodes:
            if inner.tag != "include":
                self._expand(inner, chain)
                nodes.append(inner)
                continue
            self._includes += 1
            if self._includes > MOST_INCLUDES:
                raise inner.problem(f"is one of more than {MOST_INCLUDES}; no more are read")
            path = found_file(inner.get("file"), chain[0].parent, self._found.search)
            if isinstance(path, str):
                beside = found_file(inner.get("file"), chain[-1].parent, self._found.search)
                path = path if isinstance(beside, str) else beside
            if isinstance(path, str):
                raise inner.problem(path)
            if path in chain:
                loop = " -> ".join(one.name for one in (*chain, path))
                raise inner.problem(f"includes itself: {loop}")
            root = xml_root(path)
            self._found.files.append(path)
            self._expand(root, (*chain, path))
            nodes += root.nodes
        node.nodes = nodes

    # -- default classes --------------------------------------------------------------------------

    def _add_class(self, node: XmlNode, base: dict[str, dict[str, str]], name: str) -> None:
        """Attributes of a default class by tag, those of its parents included."""
        known = self._classes.get(name, base) if name == "main" else base
        own = {tag: dict(values) for tag, values in known.items()}
        for inner in node.nodes:
            if inner.tag != "default":
                own[inner.tag] = _merge(own.get(inner.tag, {}), inner.attributes)
        self._classes[name] = own
        for inner in node.all("default"):
            if not inner.get("class"):
                raise inner.problem("class is missing")
            self._add_class(inner, own, inner.get("class"))

    def attributes_of(self, node: XmlNode, child_class: str) -> Attributes:
        """Attributes of a node, those of its class included.

        Args:
            node: A geom or an asset.
            child_class: Default class of what names none.

        Raises:
            InputError: If there is no such class.
        """
        name = node.get("class") or child_class
        if name != "main" and name not in self._classes:
            raise node.problem(f"class: there is no default class {name!r}")
        return _merge(self._classes.get(name, {}).get(node.tag, {}), node.attributes)

    # -- poses ------------------------------------------------------------------------------------

    def _turn(self, node: XmlNode, given: Attributes) -> Array:
        """Rotation of a body, frame or geom."""
        degrees = self._settings.get("angle", "degree") != "radian"
        unit = math.pi / 180.0 if degrees else 1.0
        if "axisangle" in given:
            *axis, angle = node.numbers(given["axisangle"], "axisangle", 4)
            _check_direction(node, "axisangle", axis)
            return turn_about(axis, unit * angle)
        if "xyaxes" in given:
            axes = node.numbers(given["xyaxes"], "xyaxes", 6)
            _check_direction(node, "xyaxes", axes[:3])
            _check_direction(node, "xyaxes", np.cross(axes[:3], axes[3:]).tolist())
            return turn_from_axes(axes[:3], axes[3:])
        if "zaxis" in given:
            axis = node.numbers(given["zaxis"], "zaxis", 3)
            _check_direction(node, "zaxis", axis)
            return turn_to(axis)
        if "euler" in given:
            angles = node.numbers(given["euler"], "euler", 3)
            sequence = self._settings.get("eulerseq", "xyz")
            return turn_in_sequence(sequence, [unit * angle for angle in angles])
        if "quat" in given:
            q = node.numbers(given["quat"], "quat", 4)
            _check_direction(node, "quat", q)
            return turn_from_quaternion(*q)
        return np.eye(3)

    def pose_of(self, node: XmlNode, given: Attributes) -> FramePose:
        """Pose of a body, frame, geom or inertial in what holds it.

        Args:
            node: The element, for errors.
            given: Its attributes.

        Raises:
            InputError: If its numbers are wrong.
        """
        place = node.numbers(given.get("pos", "0 0 0"), "pos [m]", 3)
        return FramePose(self._turn(node, given), np.array(place))

    # -- bodies and geoms -------------------------------------------------------------------------

    def _body(self, body: XmlNode, pose: FramePose, name: str, child_class: str) -> None:
        """Add what is in a body or frame.

        Args:
            body: The element.
            pose: Its pose in the world.
            name: Path of the bodies that it is in.
            child_class: Default class of what names none.
        """
        child_class = body.get("childclass") or child_class
        for k, node in enumerate(body.nodes):
            if node.tag == "geom":
                self._geom(node, pose, _join(name, node.get("name") or f"geom {k}"), child_class)
            elif node.tag in ("body", "frame"):
                inner = name
                if node.tag == "body":
                    inner = _join(name, node.get("name") or f"body {k}")
                    self._note_motion(node, inner)
                self._body(node, pose @ self.pose_of(node, node.attributes), inner, child_class)
            elif node.tag in MAKERS:
                full = _join(name, node.get("name") or node.get("prefix") or f"{node.tag} {k}")
                self._found.leave_out(full, MAKERS[node.tag])
            elif node.tag in UNTOUCHED:
                self._found.ignore(node.tag)

    def _note_motion(self, body: XmlNode, name: str) -> None:
        """Note that a body can move."""
        joints = parts_of(body, *JOINTS)
        kinds = ["free" if j.tag == "freejoint" else j.get("type", "hinge") for j in joints]
        if kinds:
            what = ", ".join(dict.fromkeys(kinds))
            self._found.remark(name, f"can move there ({what} joint), and is at rest here")
        elif body.get("mocap") in ("true", "1"):
            self._found.remark(name, "is moved from outside there, and is at rest here")

    def _geom(self, node: XmlNode, outer: FramePose, name: str, child_class: str) -> None:
        given = self.attributes_of(node, child_class)
        if all(_is_zero(given.get(key, "1")) for key in ("contype", "conaffinity")):
            self._found.ignore("visual")
            return
        kind = given.get("type", "sphere")
        friction = None
        if "friction" in given:
            friction = node.numbers(given["friction"], "friction", range(1, 4))[0]
            if friction < 0.0:
                raise node.problem(f"friction: must be at least 0 (got {friction:g})")
        if kind in ("mesh", "sdf") or "mesh" in given:
            self._mesh(node, given, outer @ self.pose_of(node, given), name, friction)
            return
        if kind == "hfield":
            self._relief(node, given, outer @ self.pose_of(node, given), name, friction)
            return
        if kind == "plane":
            self._found.plane(name, outer @ self.pose_of(node, given), (0.0, 0.0, 1.0), friction)
            return
        self._primitive(node, given, outer, name, friction)

    def _primitive(
        self, node: XmlNode, given: Attributes, outer: FramePose, name: str,
        friction: float | None,
    ) -> None:  # fmt: skip
        kind, known = given.get("type", "sphere"), self.primitive_of(node, given)
        if known is None:
            self._found.leave_out(name, f"is a {kind}")
            return
        local, size = known
        pose, found = outer @ local, self._found
        if kind == "sphere":
            found.sphere(name, pose, size[0], friction)
        elif kind == "box":
            found.box(name, pose, [2.0 * half for half in size], friction)
        elif kind == "ellipsoid":
            found.ellipsoid(name, pose, size, friction)
        else:
            add = found.capsule if kind == "capsule" else found.cylinder
            add(name, pose, size[0], 2.0 * size[1], friction)

    def primitive_of(
        self, node: XmlNode, given: Attributes
    ) -> tuple[FramePose, list[float]] | None:
        """Pose in its body and half sizes [m] of a geom; None if it is of another type.

        Args:
            node: The geom, for errors.
            given: Its attributes, those of its class included.

        Raises:
            InputError: If its numbers are wrong.
        """
        kind = given.get("type", "sphere")
        counts = {"sphere": 1, "capsule": 2, "cylinder": 2, "box": 3, "ellipsoid": 3}
        if kind not in counts:
            return None
        count, text = counts[kind], given.get("size", "")
        if "fromto" in given and count > 1:
            line = node.numbers(given["fromto"], "fromto [m]", 6)
            local, length = self._between(node, line)
            across = node.numbers(text, "size [m]", range(1, 4))[0]
            size = [across] * (count - 1) + [0.5 * length]  # a box is as wide as it is deep
        else:
            local = self.pose_of(node, given)
            size = node.numbers(text, "size [m]", range(count, 4))[:count]
        for value in size:
            if not value > 0.0:
                raise node.problem(f"size: must be above 0 m (got {value:g} m)")
        return local, size

    @staticmethod
    def _between(node: XmlNode, line: list[float]) -> tuple[FramePose, float]:
        """Pose in the middle of two points, third axis from the second to the first; length [m]."""
        a, b = np.array(line[:3]), np.array(line[3:])
        length = float(np.linalg.norm(b - a))
        if not length > 0.0:
            raise node.problem("fromto: must be two points apart")
        return FramePose(turn_to((a - b).tolist()), 0.5 * (a + b)), length

    # -- files ------------------------------------------------------------------------------------

    def _asset(self, word: str, key: str) -> Path | str:
        """File of a mesh or height map, or why there is none."""
        if self._settings.get("strippath") == "true":
            word = word.replace("\\", "/").rpartition("/")[2]
        folder = self._settings.get(key) or self._settings.get("assetdir") or ""
        return found_file(f"{folder}/{word}" if folder else word, self._found.path.parent,
                          self._found.search)  # fmt: skip

    def _mesh(
        self, node: XmlNode, given: Attributes, pose: FramePose, name: str, friction: float | None
    ) -> None:
        kind = given.get("type", "sphere")
        if kind != "mesh":
            what = "is a signed distance of a plugin" if kind == "sdf" else "is fitted to a mesh"
            self._found.leave_out(name, what)
            return
        asset, own = self.mesh_of(node, given)
        if "file" not in own:
            self._found.leave_out(name, "is a mesh without a file")
            return
        if "refpos" in own or "refquat" in own:
            self._found.leave_out(name, "is a mesh with a reference frame of its own")
            return
        scale, path = self.scale_of(asset, own), self.mesh_file(own)
        add_mesh(self._found, name, pose, path, scale, friction)
        if not isinstance(path, str):
            self._found.remark(name, "is hit as it is; MuJoCo hits its convex hull")

    def mesh_of(self, node: XmlNode, given: Attributes) -> tuple[XmlNode, Attributes]:
        """The mesh that a geom names, and its attributes, those of its class included.

        Args:
            node: The geom, for errors.
            given: Its attributes.

        Raises:
            InputError: If there is none.
        """
        asset = self._meshes.get(given.get("mesh", ""))
        if asset is None:
            raise node.problem(f"mesh: there is no mesh {given.get('mesh', '')!r}")
        return asset, self.attributes_of(asset, "main")

    @staticmethod
    def scale_of(asset: XmlNode, own: Attributes) -> list[float]:
        """Factors of a mesh along its own axes.

        Args:
            asset: The mesh, for errors.
            own: Its attributes.

        Raises:
            InputError: If one is zero.
        """
        scale = asset.numbers(own.get("scale", "1 1 1"), "scale", 3)
        if not all(scale):
            raise asset.problem("scale: must not be zero")
        return scale

    def mesh_file(self, own: Attributes) -> Path | str:
        """The file of a mesh that has one, or why there is none.

        Args:
            own: Attributes of the mesh.
        """
        return self._asset(own["file"], "meshdir")

    def _relief(
        self, node: XmlNode, given: Attributes, pose: FramePose, name: str, friction: float | None
    ) -> None:
        asset = self._reliefs.get(given.get("hfield", ""))
        if asset is None:
            raise node.problem(f"hfield: there is no height field {given.get('hfield', '')!r}")
        if not asset.get("file"):
            self._found.leave_out(name, "is a height field without a file")
            return
        x, y, height, base = asset.numbers(asset.get("size"), "size [m]", 4, above=0.0)
        path = self._asset(asset.get("file"), "assetdir")
        add_relief(
            self._found, name, pose, path, (2.0 * x, 2.0 * y), height, base, friction=friction
        )
        if not isinstance(path, str):
            what = "black and white are its lowest and highest; MuJoCo takes the image's own range"
            self._found.remark(name, what)


def _merge(base: Attributes, own: Attributes) -> dict[str, str]:
    """Attributes over those of a class; another notation of the attitude replaces the class's."""
    if any(key in own for key in NOTATIONS):
        base = {key: value for key, value in base.items() if key not in NOTATIONS}
    return {**base, **own}


def parts_of(body: XmlNode, *tags: str) -> Iterator[XmlNode]:
    """Elements of a body with one of some tags, those in its frames included."""
    for node in body.nodes:
        if node.tag in tags:
            yield node
        elif node.tag == "frame":
            yield from parts_of(node, *tags)


def _join(outer: str, inner: str) -> str:
    return f"{outer}/{inner}" if outer else inner


def _is_zero(text: str) -> bool:
    return text.strip() in ("0", "0.0", "00")


def _check_direction(node: XmlNode, what: str, direction: list[float]) -> None:
    if not math.hypot(*direction) > 1e-12:
        raise node.problem(f"{what}: must not be zero")
