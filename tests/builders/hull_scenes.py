"""A hull of every kind as a vehicle's nose, ahead of its cages."""

from __future__ import annotations

from typing import Any

#: Kinds of hulls, about the point at which they are placed; each reaches some 5 cm ahead of it.
NOSES: dict[str, dict[str, Any]] = {
    "sphere": {"type": "sphere", "radius": 0.05},
    "ring": {"type": "ring", "radius": 0.05, "axis": [0.2, 0.3, 1.0]},
    "capsule": {"type": "capsule", "start": [-0.02, -0.01, 0.0], "end": [0.03, 0.01, 0.02],
                "radius": 0.02},
    "box": {"type": "box", "size": [0.1, 0.06, 0.05], "edge_radius": 0.004, "pitch": 0.2, "yaw": 0.3},
    "points": {"type": "points", "radius": 0.003,
               "points": [[0.05, 0.0, 0.01], [-0.03, 0.03, -0.02], [-0.03, -0.03, -0.02],
                          [-0.02, 0.0, 0.04]]},
}  # fmt: skip
#: Where the end of arm 1 is, from the middle of the main body [m].
_ARM = 0.1343502884254441


def nose(kind: str, on: str, aside: float = 0.0) -> dict[str, Any]:
    """A hull whose middle is some 25 cm ahead of the main body, fixed to it or to an arm.

    Args:
        kind: As in `NOSES`.
        on: ``body`` or ``arm``, which is the first, ahead to the left.
        aside: To the left of the main body's middle [m].
    """
    ahead = 0.25 if aside == 0.0 else 0.235  # within the reach of an arm with its cage
    place = [ahead, aside, 0.0] if on == "body" else [ahead - _ARM, aside - _ARM, 0.0]
    form = NOSES[kind]
    moved = {
        name: [a + b for a, b in zip(form[name], place, strict=True)]
        for name in ("start", "end")
        if name in form
    }
    if kind == "points":
        moved["points"] = [[a + b for a, b in zip(p, place, strict=True)] for p in form["points"]]
    elif kind != "capsule":
        moved["position"] = place
    return {**form, **moved, "on": "body" if on == "body" else 1}
