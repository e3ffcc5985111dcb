"""Latches of arms: what holds them stiffly at their free position until a load opens it."""

from __future__ import annotations

from typing import Annotated, ClassVar

from springback.quantities import PerArm, Unit
from springback.settings import Settings, problem


class _LatchSettings(Settings):
    """What latches have in common."""

    load: ClassVar[str]
    """Field of the force or torque at which it opens."""
    unit: ClassVar[str]

    def holds(self, j: int) -> float:
        """Force or torque at which that of arm ``j`` opens [N] or [N m]; 0 if it has none."""
        return self._of_arm(self.load, j)

    def opens(self, j: int) -> float:
        """Travel at which that of arm ``j`` opens [m] or [rad]."""
        return self._of_arm("travel", j)

    @property
    def differs(self) -> bool:
        """True if arms have different ones."""
        return any(isinstance(getattr(self, name), tuple) for name in (self.load, "travel"))

    def _of_arm(self, name: str, j: int) -> float:
        value = getattr(self, name)
        one: float = value[j] if isinstance(value, tuple) else value
        return one

    def check(self, count: int) -> None:
        """Reject numbers of another number of arms, and latches that hold nothing."""
        for name in (self.load, "travel"):
            value = getattr(self, name)
            if isinstance(value, tuple) and len(value) != count:
                raise problem(f"has {len(value)} entries for {count} arms", name)
        if not any(self.holds(j) > 0.0 for j in range(count)):
            raise problem(
                f"must be more than 0 {self.unit}, for at least one arm (got 0)", self.load
            )


class SlideLatch(_LatchSettings):
    """Latch of a slide: it holds the arm out until a force opens it, and closes by itself."""

    load, unit = "force", "N"

    force: Annotated[PerArm, Unit("N", least=0.0)]
    """Force at which it opens; in a list, 0 for an arm without a latch."""
    travel: Annotated[PerArm, Unit("m", above=0.0)]
    """Travel by which it yields before it opens."""


class HingeLatch(_LatchSettings):
    """Latch of a hinge, like that of a slide."""

    load, unit = "torque", "N m"

    torque: Annotated[PerArm, Unit("N m", least=0.0)]
    """Torque at which it opens; in a list, 0 for an arm without a latch."""
    travel: Annotated[PerArm, Unit("rad", above=0.0)]
    """Angle by which it yields before it opens."""
