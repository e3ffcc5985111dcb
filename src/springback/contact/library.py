"""Surfaces of the literature, each number with its source."""

from __future__ import annotations

from springback.contact.parameters import SurfaceSettings

#: c_a fitted to the restitution of Quad alone (Table III, simulation) at 1.85 m/s by the exact
#: relation; the paper prints only a range, 0.01 to 0.5 (docs/decisions/0004).
QUAD_SPEED = 1.85
QUAD_RESTITUTION = {"wall": 0.547, "mat": 0.598}

_FRONT = "for the whole front of two cages, as the Quad rows of Table III demand"

WALL = SurfaceSettings(
    stiffness=2e5, shared_by=2, exponent=1.5, friction=0.8,
    restitution=QUAD_RESTITUTION["wall"], restitution_speed=QUAD_SPEED,
)  # fmt: skip
MAT = SurfaceSettings(
    stiffness=1.2e5, shared_by=2, exponent=1.5, friction=0.8,
    restitution=QUAD_RESTITUTION["mat"], restitution_speed=QUAD_SPEED,
)  # fmt: skip

#: The same surfaces with the friction of the paper's equations, along the vertical only.
PAPER_WALL = WALL.model_copy(update={"friction_axes": "vertical"})
PAPER_MAT = MAT.model_copy(update={"friction_axes": "vertical"})

SURFACES = {"wall": WALL, "mat": MAT, "paper-wall": PAPER_WALL, "paper-mat": PAPER_MAT}

SOURCES = {
    "wall": {
        "stiffness": f"given: Table II, k_c,wall = 2e5 N/m, {_FRONT}",
        "shared_by": "chosen: see stiffness (docs/decisions/0005)",
        "exponent": "given: section IV-A, n = 1.5",
        "friction": "given: Table II, mu = 0.8",
        "restitution": "fitted: Table III, Quad, simulation, wall",
        "restitution_speed": "given: section IV-A, about 1.85 m/s",
        "slip_speed": "chosen: convergence study (studies/convergence.py)",
    },
    "mat": {
        "stiffness": f"given: Table II, k_c,mat = 1.2e5 N/m, {_FRONT}",
        "shared_by": "chosen: see stiffness (docs/decisions/0005)",
        "exponent": "given: section IV-A, n = 1.5",
        "friction": "given: Table II, mu = 0.8",
        "restitution": "fitted: Table III, Quad, simulation, mat",
        "restitution_speed": "given: section IV-A, about 1.85 m/s",
        "slip_speed": "chosen: convergence study (studies/convergence.py)",
    },
}

_AXES = {
    "friction_axes": "given: equations (13) and (14) have friction along e_Z alone; with friction "
    "along both tangents arms at 45 degrees hardly slide (docs/decisions/0017)"
}
SOURCES |= {f"paper-{name}": {**SOURCES[name], **_AXES} for name in ("wall", "mat")}
