"""Nets and curtains: a held rectangle that yields, with a law of its own.

**Tight.** A membrane under a tension T [N/m], held on a circle of radius a and pressed by a disc of
radius r with the force P, obeys T ∇²w = 0 between them, so it sinks by δ = P ln(a/r) / (2 π T)
below the disc: linear, with k = 2 π T / ln(a/r).  For a rectangle a is half its shorter side, the
circle within it.

**Slack.** Threads without tension, of stiffness E A each, s apart, of length 2a between the sides,
are lengthened by δ²/(2a²) when their middles are drawn aside by δ ≪ a, and pull with 2 E A δ/a
times that.  A disc of radius r is crossed by 2r/s threads in each of two directions, so with
S = E A / s [N/m], the stiffness of the net in its plane per width, P = 4 r S δ³/a³.  Threads that
the disc does not touch are left out: a lower bound.

**Numbers** (from memory, to be measured for your own net): a curtain 5 to 20 N/m under its own
weight, a sports net 50 to 500 N/m; S of a net of 2 mm polyamide thread (E of 2 to 4 GPa) every 5 cm
1.3e5 to 2.5e5 N/m.  Nearly all energy is lost in air and friction: restitution 0 to 0.1, friction
0.3.

**Limits.** The dip δ is small against a; each part of a vehicle sinks in as if it were alone; the
net has no mass of its own and no holes; it yields at its sides as it does in the middle; what comes
from behind or from the side meets a body as deep as ``depth``, and what is pressed in deeper than
that is through: the net lets go at once, and the energy it held is missing in the ledger.
"""

from __future__ import annotations

import math
from typing import Annotated, Literal

import numpy as np
from pydantic import model_validator

from springback.contact.parameters import SurfaceSettings
from springback.contact.scene.solids import NET
from springback.contact.shapes import AttitudeSettings, Place, ShapeSettings, SolidShape, Widths
from springback.quantities import Factor, Length, Speed, Unit
from springback.settings import problem

PerLength = Annotated[float, Unit("N/m", above=0.0)]


class Net(AttitudeSettings, ShapeSettings):
    """A net or a curtain: it yields, and gives little back."""

    type: Literal["net"]
    position: Place
    """Middle of its face, which faces along its own −x."""
    size: Widths = (2.0, 2.0)
    """Width and height."""
    depth: Length = 0.5
    """Depth of the body behind its face: a part pressed in deeper than this has gone through."""
    tension: PerLength | None = None
    """Force per width with which it is stretched: contact force grows with the dip ..."""
    thread_stiffness: PerLength | None = None
    """... or, for a slack net, stiffness in its plane per width: with the cube of the dip."""
    contact_radius: Length = 0.1
    """Radius of the disc that stands for a part of the vehicle as it presses."""
    restitution: Annotated[float, Unit("", least=0.01, most=1.0)] = 0.05
    """Share of the speed that is returned at ``restitution_speed``."""
    restitution_speed: Speed = 2.0
    friction: Factor = 0.3

    @model_validator(mode="after")
    def _is_held(self) -> Net:
        if (self.tension is None) == (self.thread_stiffness is None):
            both = "" if self.tension is None else ", not both"
            raise problem(f"needs either tension or thread_stiffness{both}")
        if self.contact_radius >= 0.5 * min(self.size):
            raise problem(
                f"must be less than {0.5 * min(self.size):g} m, half of its shorter side (got "
                f"{self.contact_radius:g} m)",
                "contact_radius",
            )
        return self

    def law(self) -> SurfaceSettings:
        """Its surface, by its own numbers."""
        a, r = 0.5 * min(self.size), self.contact_radius
        if self.tension is not None:
            exponent, stiffness = 1.0, 2.0 * math.pi * self.tension / math.log(a / r)
        else:
            exponent, stiffness = 3.0, 4.0 * r * (self.thread_stiffness or 0.0) / a**3
        return SurfaceSettings(
            law="hunt-crossley", stiffness=stiffness, exponent=exponent, friction=self.friction,
            restitution=self.restitution, restitution_speed=self.restitution_speed,
        )  # fmt: skip

    def bodies(self) -> list[SolidShape]:
        """Its solids."""
        x, y, z = self.axes()
        width, height = self.size
        sizes = (0.5 * width, 0.5 * height, self.depth)
        return [SolidShape(NET, np.array(self.position), np.array([-y, z, -x]), sizes, 0.0)]
