"""Obstacles that move freely: where they start."""

from __future__ import annotations

from springback.contact.moving.bodies import FREE, body_pose
from springback.contact.moving.scene import MovingScene
from springback.dynamics.moving_obstacles import ALL_FLAGS, body_touch
from springback.kernels.routines import routines_compiled
from springback.settings import problem

#: Deepest start within what is at rest [m] (chosen: more than any obstacle sinks in by its weight).
DEEPEST = 2e-3


def check_free_starts(scene: MovingScene) -> None:
    """Reject an obstacle that moves freely and starts inside what is at rest.

    It would be thrown out, by the energy of a contact so deep.

    Raises:
        The problem.
    """
    for body in scene.bodies:
        if body.kind != FREE:
            continue
        with routines_compiled():
            depth = -body_touch(body, body_pose(body, body.start), scene.still, ALL_FLAGS).gap
        if depth > DEEPEST:
            raise problem(
                f"starts {depth:.3g} m inside what is at rest; an obstacle that moves freely must "
                f"not be deeper than {1e3 * DEEPEST:g} mm",
                f"world.obstacles[{int(body.obstacle)}]",
            )
