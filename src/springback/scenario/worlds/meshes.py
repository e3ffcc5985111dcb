"""Meshes, height maps and occupancy grids of other programs, as obstacles that name their file."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

from springback.errors import InputError
from springback.scenario.worlds.content import LEVEL, Collector
from springback.scenario.worlds.poses import FramePose, at_origin

#: Suffixes of meshes that obstacles are made of, and of others with what to do about them.
MESHES = (".stl", ".obj", ".ply", ".glb")
NO_MESHES = {
    ".dae": "Collada is not read; convert it to OBJ or STL",
    ".gltf": "glTF of several files is not read; convert it to GLB",
    ".fbx": "FBX is not read; convert it to OBJ or STL",
    ".msh": "MuJoCo's own meshes are not read; convert it to OBJ or STL",
}
#: Suffixes of height maps.
RELIEFS = (".png", ".npy")


def add_mesh(
    found: Collector, name: str, pose: FramePose, path: Path | str, scale: Sequence[float],
    friction: float | None = None,
) -> None:  # fmt: skip
    """Add a mesh, or say why not.

    Args:
        found: Takes it.
        name: Name of the element.
        pose: Of the mesh.
        path: Its file, or why there is none.
        scale: Factors along its own x, y and z.
        friction: Of the file.
    """
    if isinstance(path, str):
        found.leave_out(name, path)
        return
    suffix = path.suffix.lower()
    if suffix not in MESHES:
        known = ", ".join(MESHES)
        found.leave_out(name, f"{path.name}: {NO_MESHES.get(suffix, f'only {known} are read')}")
        return
    if len(set(scale)) > 1 or scale[0] < 0.0:
        shown = " x ".join(f"{factor:g}" for factor in scale)
        found.leave_out(name, f"is scaled by {shown}; a mesh has one scale, above 0")
        return
    found.mesh(name, pose, path, scale[0], friction)


def add_relief(
    found: Collector, name: str, pose: FramePose, path: Path | str, size: tuple[float, float],
    height: float, depth: float | None = None, friction: float | None = None,
) -> None:  # fmt: skip
    """Add a height map, or say why not.

    Args:
        found: Takes it.
        name: Name of the element.
        pose: Of its middle, at the height of black.
        path: Its image, or why there is none.
        size: Along its own x and y [m].
        height: Of white above black, which is at the pose [m].
        depth: Of the ground below its lowest point, unless as usual [m].
        friction: Of the file.
    """
    if isinstance(path, str):
        found.leave_out(name, path)
        return
    if path.suffix.lower() not in RELIEFS:
        found.leave_out(name, f"{path.name}: only height maps in {', '.join(RELIEFS)} are read")
        return
    up = pose.turn[:, 2]
    if math.hypot(up[0], up[1]) > LEVEL or up[2] < 0.0:
        found.leave_out(name, "is a height map that is not level")
        return
    table = {
        "type": "heightmap", "file": str(path), "position": pose.place.tolist(),
        "size": list(size), "range": [0.0, height],
    }  # fmt: skip
    if depth is not None:
        table["depth"] = depth
    yaw = pose.angles()[2]
    found.files.append(path)
    found.add(name, table | ({"yaw": yaw} if yaw else {}), friction)


def read_mesh(found: Collector) -> None:
    """Add a file that is a mesh, as it is."""
    add_mesh(found, found.path.stem, at_origin(), found.path, (1.0, 1.0, 1.0))


def read_relief(found: Collector) -> None:
    """Refuse a file that is a height map: it does not say how large it is.

    Raises:
        InputError: With what to write instead.
    """
    raise InputError(
        f"{found.path}: is a height map, which does not say how large it is: use an obstacle of "
        'type = "heightmap" with its size or spacing'
    )


def read_occupancy(found: Collector) -> None:
    """Add a file that is an occupancy grid."""
    table = {"type": "occupancy", "file": str(found.path), "position": [0.0, 0.0, 0.0]}
    found.add(found.path.stem, table)
