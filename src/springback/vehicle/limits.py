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


class LoadLimits(NamedTuple):
    """What the parts of a vehicle bear; `UNLIMITED` where nothing is known."""

    guards: tuple[float, ...]  # normal force on the cage and the hulls of each arm [N]
    arms: tuple[float, ...]  # force of spring, damper and stops along each arm [N]
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
    """Something on the main body that bears so much acceleration and no more."""

    name: Name
    position: Annotated[Triple, Unit("m")] = (0.0, 0.0, 0.0)
    """From the centre of the main body, body axes."""
    specific_force: Annotated[float, Unit("m/s^2", above=0.0)]
    """Largest magnitude that it bears of what an accelerometer there would measure."""


class LimitSettings(Settings):
    """What the parts of a vehicle bear.  At least one limit."""

    guard_force: Annotated[PerArm, Unit("N", above=0.0)] | None = None
    """Normal force on a guard, the cage and the hulls of an arm: one number, or one for each."""
    broken_stiffness: Annotated[PerArm, Unit("", least=0.0, most=1.0)] | None = None
    """Share of its stiffness that a guard keeps when ``guard_force`` has been passed: its contacts
    then press with that share of their force at the same depth and rate, whatever their law.  One
    number, or one for each.  Without it guards go on as before.
    """
    arm_force: Annotated[PerArm, Unit("N", above=0.0)] | None = None
    """Force of spring, damper and end stops along a compliant arm: one number, or one for each."""
    hinge_torque: Annotated[PerArm, Unit("N m", above=0.0)] | None = None
    """The same of an arm on a hinge, as a torque about it."""
    components: Annotated[tuple[Component, ...], Field(max_length=MOST_COMPONENTS)] = ()
    breaks: bool = True
    """True: a flight that passes a limit has the outcome ``broken``, and is no success."""

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

    def check(self, compliant: tuple[bool, ...], hinged: bool) -> None:
        """Reject lists of another length than the arms, and forces of arms that are rigid.

        Args:
            compliant: Of each arm, True if it can slide.
            hinged: Whether arms are on hinges.
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
        if self.hinge_torque is not None and not (hinged and any(compliant)):
            raise problem("needs compliant arms on hinges", "hinge_torque")
        if self.hinge_torque is not None and self.arm_force is not None:
            raise problem("cannot be combined with arm_force; give only one", "hinge_torque")

    def limits(self, compliant: tuple[bool, ...], radii: tuple[float, ...]) -> LoadLimits:
        """Numbers of the limits, given which arms can slide, and the radii of hinges [m]."""
        places = max(PLACES, len(self.components))
        found = [ComponentLimit(Vec(*one.position), one.specific_force) for one in self.components]
        found += [ComponentLimit(Vec(0.0, 0.0, 0.0), UNLIMITED)] * (places - len(found))
        forces = [
            limit if slides else UNLIMITED
            for limit, slides in zip(_each(self.arm_force, len(compliant)), compliant, strict=True)
        ]
        if self.hinge_torque is not None:
            torques = zip(_each(self.hinge_torque, len(compliant)), radii, compliant, strict=True)
            forces = [most / radius if moves else UNLIMITED for most, radius, moves in torques]
        guards = _each(self.guard_force, len(compliant))
        breaks = 1.0 if self.breaks else 0.0
        broken: tuple[GuardStiffness, ...] = ()
        if self.broken_stiffness is not None:
            broken = (GuardStiffness(tuple(_each(self.broken_stiffness, len(compliant)))),)
        return LoadLimits(tuple(guards), tuple(forces), tuple(found), breaks, broken)


def _each(limit: Any, arms: int) -> list[float]:
    """A limit of each arm, or another number of it."""
    if limit is None:
        return [UNLIMITED] * arms
    return list(limit) if isinstance(limit, tuple) else [limit] * arms


def limits_or_none(value: Any) -> Any:
    """Validate the table of limits; False removes those of a preset."""
    return None if value is False else value
