"""Rotors that stop when their guard or their disc is hit.

Recordings of guarded quadrotors show that the rotors nearest to the obstacle stop within one sample
of the hit, 33 to 65 ms, and the others often within 40 ms more (crashes of the McGill Spiri and
Navi, published with thecognifly/CrashLandingExperiments).  Here a rotor that is hit ceases to
follow its command: after a delay its thrust decays with a time constant of its own.
"""

from __future__ import annotations

import math
from typing import Annotated, Any, Literal, NamedTuple

from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import fold, select, tree_map, tree_sum
from springback.kernels.vectors import larger, smaller
from springback.quantities import Unit
from springback.settings import Settings, problem
from springback.vehicle.placed.rotors import PlacedRotors
from springback.vehicle.rotors import Lag, LagStep, Rotors, lag_over, lagged_thrust

#: A limit that nothing reaches: of a force [N], or of a time [s].
NEVER = 1e30
#: A disc this near to an obstacle is hit [m] (chosen: a search from outside ends at a surface).
AT_HIT = 1e-5
#: In place of the time of a stop: the rotor turns.
TURNING = -1.0
#: In place of the time of a stop: the propeller is broken.
BROKEN = -2.0
#: Times within this of each other are equal [s].
SAME_TIME = 1e-12


class NoStop(NamedTuple):
    """Rotors follow their commands whatever they hit."""

    unused: float


class RotorStop(NamedTuple):
    """Constants of rotors that stop when they are hit, over one tick; equal for all rotors."""

    force: float  # normal force on the guard beyond which a rotor stops [N]
    disc: float  # 1 if it stops when something is in its disc
    breaks: float  # 1 if that breaks its propeller
    delay: float  # from the hit to the stop [s]
    others: float  # from a hit until all other rotors stop [s]
    restart: float  # from the last hit until a rotor follows its command again [s]
    lag: Lag  # of the thrust of a rotor that stops, over a tick
    inertia: float  # J of a rotor about its axis [kg m²]
    per_thrust: float  # 1/k, square of the angular rate of a rotor per thrust [rad²/(s² N)]
    period: float  # of a tick [s]


class RotorHits(NamedTuple):
    """What hit a rotor since the last tick, and when it first stopped."""

    force: float  # largest normal force on its guard [N]
    disc: float  # 1 if something was in its disc
    stop_time: float  # at which it first stopped [s]; −1 if it did not


#: Nothing has hit a rotor yet.
UNHIT = RotorHits(0.0, 0.0, -1.0)


class Hits(NamedTuple):
    """Hits of all rotors since the last tick."""

    rotors: tuple[RotorHits, ...]


@generic
def hits_after(hits: Any, guards: tuple[Any, ...], gaps: tuple[tuple[float, ...], ...]) -> Any:
    """Hits of rotors after one more instant, where they are looked for.

    Args:
        hits: `Hits` before; empty where they stop no rotor.
        guards: What guards each: `springback.dynamics.motion.ArmView` of its arm, by cage and
            hulls, or `springback.vehicle.placed.rotors.Guard`.
        gaps: Between the discs of each and the nearest obstacle [m].
    """
    return hits


@hits_after.register(object)
@kernel
def _not_looked_for(hits: Any, guards: tuple[Any, ...], gaps: tuple[tuple[float, ...], ...]) -> Any:
    return hits


@hits_after.register(Hits)
@kernel
def _hits_seen(hits: Hits, guards: tuple[Any, ...], gaps: tuple[tuple[float, ...], ...]) -> Hits:
    return Hits(tree_map(_rotor_hits, (hits.rotors, guards, gaps), ()))


@kernel
def _rotor_hits(before: RotorHits, guard: Any, gaps: tuple[float, ...]) -> RotorHits:
    force = select(guard.impulsive > 0.0, NEVER, guard.normal)  # an impulse has no largest force
    in_disc = fold(smaller, NEVER, gaps, ()) < AT_HIT
    return RotorHits(
        larger(force, before.force), select(in_disc, 1.0, before.disc), before.stop_time
    )


@kernel
def is_hit(seen: RotorHits, stop: RotorStop) -> float:
    """1 if what hit a rotor stops it."""
    return 1.0 if (seen.force >= stop.force) | (seen.disc * stop.disc > 0.0) else 0.0


@kernel
def stopped_since(
    since: float, seen: RotorHits, any_hit: float, stop: RotorStop, now: float
) -> float:
    """When a rotor stops or has stopped, after a tick: a time [s], `TURNING` or `BROKEN`.

    Args:
        since: The same before the tick.
        seen: What hit it since the tick before.
        any_hit: 1 if any rotor is hit.
        stop: Constants.
        now: Time of the tick [s].
    """
    hit, turns = is_hit(seen, stop) > 0.0, since == TURNING
    stands = (since >= 0.0) & (since <= now + SAME_TIME)
    over = stands & (now - since >= stop.restart - SAME_TIME)
    # A hit while it stands counts its rest anew; one before the stop is due changes nothing.
    after_hit = select(turns, now + stop.delay, select(stands, now, since))
    with_others = (any_hit > 0.0) & turns & (stop.others < NEVER)
    unhit = select(with_others, now + stop.others, select(over, TURNING, since))
    broken = seen.disc * stop.breaks > 0.0  # one that is broken stays so by itself
    return select(broken, BROKEN, select(hit, after_hit, unhit))


@kernel
def is_stopped(since: float, now: float) -> float:
    """1 if a rotor stands, or its propeller is broken, at a time [s]."""
    stands = (since >= 0.0) & (since <= now + SAME_TIME)
    return 1.0 if stands | (since == BROKEN) else 0.0


@kernel
def forgotten(seen: RotorHits, stopped: float, now: float) -> RotorHits:
    """Hits at the beginning of a tick: none, and the time of the first stop [s]."""
    first = (stopped > 0.0) & (seen.stop_time < 0.0)
    return RotorHits(0.0, 0.0, select(first, now, seen.stop_time))


@kernel
def rotor_step(
    thrust: float, command: float, stopped: float, rotors: Rotors, lag: Lag, stop: RotorStop
) -> LagStep:
    """Thrust of one rotor over a tick: it follows its command, or decays if it has stopped.

    Args:
        thrust: At the start [N].
        command: Commanded thrust [N].
        stopped: 1 if it has stopped.
        rotors: Their bounds.
        lag: `lag_over` a tick while it turns.
        stop: Constants.
    """
    follows = lagged_thrust(thrust, command, rotors, lag)
    decays = LagStep(thrust * stop.lag.end, thrust * stop.lag.mean)
    return select(stopped > 0.0, decays, follows)


@kernel
def reaction(rotor: Any, before: float, after: float, stop: RotorStop) -> float:
    """Mean moment of a rotor about its axis, on the body, by its change of speed over a tick [N m].

    That of the rotor of an arm is taken as about body z, also where it leans.

    A rotor turns against the torque that its drag puts on the body.  What brakes it takes its
    angular momentum J Ω, Ω² = T/k, and gives it to the body.

    Args:
        rotor: Its arm, or the rotor of a list, with the sign of the torque.
        before: Thrust at the beginning of the tick [N].
        after: At its end [N].
        stop: Constants.
    """
    slower = math.sqrt(before * stop.per_thrust) - math.sqrt(after * stop.per_thrust)
    size = stop.inertia * slower / stop.period
    along = select(rotor.torque_ratio > 0.0, -1.0, select(rotor.torque_ratio < 0.0, 1.0, 0.0))
    return along * size


@generic
def reactions_of(
    rotors: Any,
    arms: tuple[Any, ...],
    before: tuple[float, ...],
    after: tuple[float, ...],
    stop: RotorStop,
) -> tuple[Any, ...]:
    """Moments of rotors that change speed [N m], as `springback.dynamics.solution.Plant` has them.

    Args:
        rotors: `PlacedRotors`; empty for one at the end of each arm.
        arms: Constants of the arms.
        before: Thrusts at the beginning of a tick [N].
        after: At its end [N].
        stop: Constants.
    """
    return (tree_sum(tree_map(reaction, (arms, before, after), (stop,))),)


@reactions_of.register(PlacedRotors)
@kernel
def _about_their_axes(
    rotors: PlacedRotors,
    arms: tuple[Any, ...],
    before: tuple[float, ...],
    after: tuple[float, ...],
    stop: RotorStop,
) -> tuple[tuple[float, ...]]:
    return (tree_map(reaction, (rotors.each, before, after), (stop,)),)


class StopSettings(Settings):
    """Rotors stop when they are hit: at their guard (the arm's cage and hulls) or in their disc.

    Nothing guards a listed rotor on the main body: only hits in its disc stop it.
    """

    guard_force: Annotated[float, Unit("N", above=0.0)] | None = None
    """Normal force on a guard beyond which its rotor stops; without it, guards stop nothing."""
    disc: Literal["ignore", "stop", "break"] | None = None
    """What something in its disc does to a rotor; by default it stops it where ``disk_radius`` is
    known.  A broken propeller gives no thrust for the rest of the flight.
    """
    delay: Annotated[float, Unit("s", least=0.0)] = 0.0
    """Time from the hit until the rotor ceases to follow its command."""
    spin_down: Annotated[float, Unit("s", least=0.0)] = 0.01
    """Time constant of the thrust of a rotor that stops.  Chosen: recordings show less than their
    sampling time, 33 ms.
    """
    others_after: Annotated[float, Unit("s", least=0.0)] | None = None
    """Time from a hit until all other rotors stop; without it, they keep turning."""
    restart_after: Annotated[float, Unit("s", least=0.0)] | None = None
    """Time from the last hit until a rotor that has stopped follows its command again; without it,
    it never does."""
    rotor_inertia: Annotated[float, Unit("kg m^2", least=0.0)] = 0.0
    """J of a rotor about its axis: propeller and the part of the motor that turns.  With it the
    body receives the angular momentum of rotors that stop or change their speed.
    """
    thrust_coefficient: Annotated[float, Unit("N s^2/rad^2", above=0.0)] | None = None
    """k of the thrust k Ω² of a rotor at the angular rate Ω; needed with ``rotor_inertia``."""

    def stop(self, tick: float, disc_known: bool) -> RotorStop:
        """Numbers for the equations of motion.

        Args:
            tick: Period of the clock [s].
            disc_known: True if the size of the discs is known.
        """
        disc = self.disc or ("stop" if disc_known else "ignore")
        acts = 0.0 if disc == "ignore" else 1.0
        never = [NEVER if time is None else time for time in (self.others_after,
                                                              self.restart_after)]  # fmt: skip
        k = self.thrust_coefficient
        return RotorStop(
            force=NEVER * 2.0 if self.guard_force is None else self.guard_force,
            disc=acts,
            breaks=1.0 if disc == "break" else 0.0,
            delay=self.delay,
            others=never[0],
            restart=never[1],
            lag=lag_over(self.spin_down, tick),
            inertia=self.rotor_inertia,
            per_thrust=0.0 if k is None else 1.0 / k,
            period=tick,
        )

    def check(self, disc_known: bool) -> None:
        """Reject what can never stop a rotor, and an inertia without a speed."""
        if self.disc in ("stop", "break") and not disc_known:
            raise problem("needs propulsion.disk_radius, the size of the discs", "disc")
        ignores = self.disc == "ignore" or not disc_known
        if self.guard_force is None and ignores:
            raise problem(
                "is missing: nothing stops a rotor without it, unless propulsion.disk_radius is "
                "given and disc is not ignore",
                "guard_force",
            )
        if self.rotor_inertia > 0.0 and self.thrust_coefficient is None:
            raise problem("is missing: rotor_inertia needs it", "thrust_coefficient")
