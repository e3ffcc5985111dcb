"""Limits of what a vehicle bears: forces on its guards and arms, accelerations of components."""

from __future__ import annotations

from typing import Annotated, Any, NamedTuple

from pydantic import Field, model_validator

from springback.kernels.vectors import Vec
from springback.quantities import PerArm, Triple, Unit
from springback.settings import Name, Settings, problem

#: In place of a limit where there is none; nothing reaches it.
UNLIMITED = 1e30
#: Components that one compiled structure has room for; more of them are another (chosen).
PLACES = 4
#: Most components (chosen).
MOST_COMPONENTS = 32


class ComponentLimit(NamedTuple):
    """Specific force that a component bears."""

    position: Vec  # from the main body, body axes [m]
    most: float  # [m/s²]


class GuardStiffness(NamedTuple):
    """What guards have left when the force on them has passed their limit."""

    stiffness: tuple[float, ...]  # of each arm's guard, share of what it was


class JointShares(NamedTuple):
    """What the forces of both joints of an arm are multiplied by, to be held against its limit."""

    first: float  # 0 if nothing is known of what it bears
    second: float  # likewise, and of an arm of one joint


class LoadLimits(NamedTuple):
    """What the parts of a vehicle bear; `UNLIMITED` where nothing is known."""

    guards: tuple[float, ...]  # normal force on the cage and the hulls of each arm [N]
    arms: tuple[float, ...]  # force of spring, damper and stops along each arm [N]
    joints: tuple[JointShares, ...]  # of each arm
    components: tuple[ComponentLimit, ...]
    breaks: float  # 1 if a flight fails by a load beyond a limit
    broken: tuple[GuardStiffness, ...] = ()  # if guards that break lose stiffness


class PeakLoad(NamedTuple):
    """Largest load of one part so far."""

    share: float  # of its limit
    broken_time: float  # when it first passed that [s]; −1 if it did not, `NO_LIMIT` without one


class PeakLoads(NamedTuple):
    """Largest loads so far of all parts."""

    guards: tuple[PeakLoad, ...]
    arms: tuple[PeakLoad, ...]
    components: tuple[PeakLoad, ...]
    breaks: float  # 1 if a flight fails by a load beyond a limit


#: In place of the time at which a limit is passed, where there is none.
NO_LIMIT = -2.0


#: Before a flight; the same for all, whatever their limits are.
UNLOADED = PeakLoad(0.0, -1.0)


def initial_loads(limits: LoadLimits | tuple[()]) -> PeakLoads | tuple[()]:
    """Loads before a flight; empty without limits."""
    if not isinstance(limits, LoadLimits):
        return ()
    guards, arms = (UNLOADED,) * len(limits.guards), (UNLOADED,) * len(limits.arms)
    return PeakLoads(guards, arms, (UNLOADED,) * len(limits.components), 0.0)


class Component(Settings):
    """Something on the main body that bears acceleration up to a limit."""

    name: Name
    position: Annotated[Triple, Unit("m")] = (0.0, 0.0, 0.0)
    """Position from the centre of the main body, body axes."""
    specific_force: Annotated[float, Unit("m/s^2", above=0.0)]
    """Largest specific force that it bears, as an accelerometer there would measure it."""


class LimitSettings(Settings):
    """What the parts of a vehicle bear.  At least one limit is given."""

    guard_force: Annotated[PerArm, Unit("N", above=0.0)] | None = None
    """Normal force on a guard (cage and hulls of an arm): one number, or one for each."""
    broken_stiffness: Annotated[PerArm, Unit("", least=0.0, most=1.0)] | None = None
    """Share of its stiffness that a guard keeps once ``guard_force`` has been exceeded: its
    contacts then press with that share of their force at the same depth and rate, whatever their
    law.  One number, or one for each.  Without it, guards go on as before."""
    arm_force: Annotated[PerArm, Unit("N", above=0.0)] | None = None
    """Force of spring, damper and end stops along a compliant arm: one number, or one for each.
    For an arm on two joints it is that along the path of either, except for a hinge with
    ``hinge_torque``."""
    hinge_torque: Annotated[PerArm, Unit("N m", above=0.0)] | None = None
    """The same for hinges, as a torque about them."""
    components: Annotated[tuple[Component, ...], Field(max_length=MOST_COMPONENTS)] = ()
    breaks: bool = True
    """True: a flight that exceeds a limit has the outcome ``broken``, and is not a success."""

    @model_validator(mode="after")
    def _limits_something(self) -> LimitSettings:
        forces = (self.guard_force, self.arm_force, self.hinge_torque)
        if all(force is None for force in forces) and not self.components:
            raise problem("limits nothing: give guard_force, arm_force, hinge_torque or components")
        names = [one.name for one in self.components]
        for k, name in enumerate(names):
            if name in names[:k]:
                raise problem("must not be that of another component", f"components[{k}].name")
        return self

    def check(self, compliant: tuple[bool, ...], hinges: tuple[bool, ...]) -> None:
        """Reject lists of another length than the arms, and forces of arms that are rigid.

        Args:
            compliant: Of each arm, True if it can slide.
            hinges: Of each joint of an arm, True if it is a hinge.
        """
        for name in ("guard_force", "broken_stiffness", "arm_force", "hinge_torque"):
            given = getattr(self, name)
            if isinstance(given, tuple) and len(given) != len(compliant):
                raise problem(f"has {len(given)} entries for {len(compliant)} arms", name)
        if self.broken_stiffness is not None and self.guard_force is None:
            raise problem("needs guard_force, beyond which a guard breaks", "broken_stiffness")
        if self.arm_force is not None and not any(compliant):
            raise problem("needs a compliant arm: the force within a rigid one is not known",
                          "arm_force")  # fmt: skip
        if self.hinge_torque is not None and not (any(hinges) and any(compliant)):
            raise problem("needs compliant arms on hinges", "hinge_torque")
        if self.hinge_torque is not None and self.arm_force is not None and all(hinges):
            what = "cannot be combined with arm_force, as arms have no slides; give only one"
            raise problem(what, "hinge_torque")

    def limits(
        self, compliant: tuple[bool, ...], radii: tuple[tuple[float, ...], ...]
    ) -> LoadLimits:
        """Numbers of the limits.

        Args:
            compliant: Of each arm, True if it can slide.
            radii: Of the paths of each joint of each arm [m]; 0 for a slide.
        """
        places = max(PLACES, len(self.components))
        found = [ComponentLimit(Vec(*one.position), one.specific_force) for one in self.components]
        found += [ComponentLimit(Vec(0.0, 0.0, 0.0), UNLIMITED)] * (places - len(found))
        count = len(compliant)
        forces, torques = _each(self.arm_force, count), _each(self.hinge_torque, count)
        known = [
            _of_joints([_along(force, torque, radius if moves else None) for radius in of_arm])
            for force, torque, moves, of_arm in zip(forces, torques, compliant, radii, strict=True)
        ]
        guards = _each(self.guard_force, count)
        breaks = 1.0 if self.breaks else 0.0
        broken: tuple[GuardStiffness, ...] = ()
        if self.broken_stiffness is not None:
            broken = (GuardStiffness(tuple(_each(self.broken_stiffness, count))),)
        arms, shares = zip(*known, strict=True)
        return LoadLimits(tuple(guards), arms, shares, tuple(found), breaks, broken)


def _along(force: float, torque: float, radius: float | None) -> float:
    """What a joint bears along its path [N]: of a hinge by its torque, if that is known."""
    if radius is None:
        return UNLIMITED
    return torque / radius if radius > 0.0 and torque < UNLIMITED else force


def _of_joints(most: list[float]) -> tuple[float, JointShares]:
    """Limit of an arm [N], from those of its joints, and their shares of it."""
    limit = next((one for one in most if one < UNLIMITED), UNLIMITED)
    first, second = ([limit / one if one < UNLIMITED else 0.0 for one in most] + [0.0])[:2]
    return limit, JointShares(first, second)


def _each(limit: Any, arms: int) -> list[float]:
    """A limit of each arm, or another number of it."""
    if limit is None:
        return [UNLIMITED] * arms
    return list(limit) if isinstance(limit, tuple) else [limit] * arms
