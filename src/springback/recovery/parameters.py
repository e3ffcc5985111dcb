"""The table ``[recovery]``: detection and characterisation of a collision, and the response.

The paper prints only L_c; each other default names its source, or says that it is chosen.
"""

from __future__ import annotations

import math
from typing import Annotated, Literal

from pydantic import Field, model_validator

from springback.kernels.vectors import Vec
from springback.quantities import Duration, Length, Speed, Triple, Unit
from springback.recovery.characterisation import Characterisation
from springback.recovery.detection import Detection, Trigger
from springback.recovery.evaluator import Evaluator, RestEvaluator
from springback.recovery.response import Quintic, Staged, TimeOptimal
from springback.recovery.state_machine import Route
from springback.recovery.wrench import Observer
from springback.settings import Settings, problem
from springback.user_code import UserCode

Samples = Annotated[int, Field(ge=1, le=1000, strict=True)]
Bandwidth = Annotated[float, Unit("1/s", above=0.0)]

#: Share of its range within which a reading counts as unclipped (chosen: the low-pass behind the
#: converter rounds the top of a clipped peak, as for the Kalman filter).
WITHIN_RANGE = 0.9
#: Range of an accelerometer without one [m/s²]; finite, as all numbers in kernels.
NO_RANGE = 1e6


class TriggerSettings(Settings):
    """Settings that all triggers have."""

    used: bool | None = None
    """True if it raises the alarm; by default `hall` does if an arm can slide, `acceleration` if
    none can, as on the paper's robots, and none beside a detector of your own.  The signals of the
    others are recorded all the same."""
    persistence: Samples = 1
    """Consecutive samples above the threshold.  Chosen: one, as in McGill's flight code."""
    refractory: Annotated[float, Unit("s", least=0.0)] = 1.0
    """Time after an alarm in which there is no other.  Chosen, half of the 2 s of ASU's XPLORER:
    the recovery itself tilts beyond the accelerometer's threshold, for some 0.7 s."""
    cutoff: Annotated[float, Unit("1/s", least=0.0)] = 0.0
    """Corner of a first-order low-pass on the signal [Hz]; 0 for none."""

    def share(self, interval: float) -> float:
        """Share of a new sample in the low-pass, for an interval between samples [s]."""
        if self.cutoff == 0.0:
            return 1.0
        lag = 1.0 / (2.0 * math.pi * float(self.cutoff))
        return interval / (interval + lag)

    def trigger(self, used: bool, threshold: float, interval: float) -> Trigger:
        """Trigger for the kernels.

        Args:
            used: Default of the setting.
            threshold: In the unit of the signal.
            interval: Between samples [s].
        """
        on = used if self.used is None else self.used
        return Trigger(
            1.0 if on else 0.0, threshold, float(self.persistence), self.refractory,
            self.share(interval),
        )  # fmt: skip


class HallTrigger(TriggerSettings):
    """Trigger on the largest compression of an arm."""

    threshold: Length = 5e-4
    """Chosen: five times the compression of an arm of 0.05 kg by 1 g, m_a g/k_l = 0.1 mm, and
    twenty-seven counts of the sensor there."""


class AccelerationTrigger(TriggerSettings):
    """Trigger on the horizontal part of the specific force, world axes."""

    threshold: Annotated[float, Unit("m/s^2", above=0.0)] = 20.0
    """McGill-AML/Spiri_recovery, and Air Bumper: 20 m/s²."""


class WrenchTrigger(TriggerSettings):
    """Trigger on the external force less its steady part."""

    threshold: Annotated[float, Unit("N", above=0.0)] = 8.0
    """Chosen (`springback study detection`): three times the largest signal in 1000 s of circles
    and steps in gusts, 2.7 N, and yet each hit from 0.25 m/s up is detected; Tomić et al. print
    none."""


class ObserverSettings(Settings):
    """Settings of the observer of the external wrench."""

    basis: Literal["acceleration", "momentum"] = "acceleration"
    """Source of the force: the accelerometer (their hybrid form), or the estimated momentum."""
    force_bandwidth: Bandwidth = 100.0
    """K_f [1/s]. Chosen: 10 ms, the order of the rise time of a collision's force."""
    moment_bandwidth: Bandwidth = 100.0
    """K_m [1/s]. Chosen, as above."""
    steady_bandwidth: Bandwidth = 2.0
    """Bandwidth of the steady part, such as wind [1/s]. Chosen."""
    fading: Bandwidth = 5.0
    """Decay rate of the impulses from which a collision is characterised [1/s]. Chosen: contacts
    take 26 to 58 ms, and the part that a clipped accelerometer loses comes 10 to 30 ms late; little
    decays in that time."""


class DetectionSettings(Settings):
    """Settings of the triggers."""

    hall: HallTrigger = HallTrigger()
    acceleration: AccelerationTrigger = AccelerationTrigger()
    wrench: WrenchTrigger = WrenchTrigger()
    own: UserCode | None = None
    """A detector of your own: ``code`` names a `CompiledDetector`, or a function that returns one.
    It alone then raises the alarm, unless `used` of others is true."""


class CharacterisationSettings(Settings):
    """Settings of the characterisation of a collision."""

    source: Literal["arms", "acceleration", "wrench", "fused"] = "fused"
    """Source of the direction f_c⁰. Chosen (`springback study detection`): `arms` reveals only
    along which arm the robot was pressed, `acceleration` and `wrench` the direction of the contact
    force with its friction, and `fused`, from force and moment, the obstacle's normal."""
    window: Annotated[float, Unit("s", least=0.0)] = 0.012
    """Observation window after the alarm.  Chosen: direction errors of both robots are then below 5
    degrees (`springback study detection`), and no trial of the paper's tests fails because of the
    delay."""
    longer: Annotated[float, Unit("s", least=0.0)] = 0.0175
    """Least time after a clipped reading, if one rigid arm was hit. Chosen: motion capture, which
    measures the velocity change that was lost, is 10 ms late and comes every 5 ms."""
    share: Annotated[float, Unit("", above=0.0, most=1.0)] = 0.1
    """An arm in front was hit if its compression is at least this share of the largest.  Chosen."""
    level: bool | None = None
    """True if obstacles are upright faces, as all of the paper's are, so that f_c⁰ is level; false
    for poles, edges, balls and leaning faces, where friction deflects it (`springback study
    shapes`). By default true if the world has only upright walls, upright mats and level ground;
    else false."""


class ResponseSettings(Settings):
    """Settings of the response."""

    way: Literal["pre-impact", "post-impact", "set-point", "time-optimal", "staged"] = "pre-impact"
    """`pre-impact`: quintic from the position at the alarm with the velocity before it, which gives
    the paper's pitch of −66° and +49°; `post-impact`: quintic from the present position and
    velocity; `set-point`: p_r at once; `time-optimal`: bounded acceleration; `staged`: McGill's."""
    distance: Annotated[float, Unit("m", least=0.0)] = 0.1
    """δ = L_c. Paper, section Impact Resilience."""
    pace: Annotated[float, Unit("s^2/m", least=0.0)] = 0.19
    """Duration of a quintic per speed before the collision: with it a quintic from 3.5 m/s needs a
    pitch of −66° and +49.6°, as printed (inferred, not printed)."""
    shortest: Duration = 0.2
    """Least duration of a quintic. Chosen: a little more than a time constant of the attitude
    loop."""
    acceleration: Annotated[float, Unit("m/s^2", above=0.0)] = 12.0
    """`time-optimal`: bound along X and along Y. Chosen: the limit of the position loop."""
    vertical_acceleration: Annotated[float, Unit("m/s^2", above=0.0)] = 4.0
    """`time-optimal`: bound along Z. Chosen: a third of the former, as tilting costs lift."""
    away: Annotated[float, Unit("m/s^2", above=0.0)] = 0.75 * 9.81
    """`staged`: acceleration, 0.75 g. McGill-AML/Spiri_recovery, as are the numbers below."""
    damping: Annotated[float, Unit("1/s", least=0.0)] = 5.0
    """`staged`: damping of the vertical speed."""
    stage_tilt: Annotated[float, Unit("rad", above=0.0)] = 0.15
    """`staged`: tilt error at which the first stage is over."""
    stage_level: Annotated[float, Unit("rad", above=0.0)] = 0.2
    """`staged`: tilt at which the second is over."""
    stage_rate: Annotated[float, Unit("rad/s", above=0.0)] = 2.0
    """`staged`: angular rate below which either is over."""
    stage_climb: Annotated[float, Unit("m/s", above=0.0)] = 0.5
    """`staged`: vertical speed at which the third is over."""

    def response(self) -> Quintic | TimeOptimal | Staged:
        """Response for the kernels; its type is the way."""
        if self.way == "time-optimal":
            return TimeOptimal(self.acceleration, self.vertical_acceleration)
        if self.way == "staged":
            return Staged(
                self.away, self.damping, self.stage_tilt, self.stage_level, self.stage_rate,
                self.stage_climb,
            )  # fmt: skip
        if self.way == "set-point":
            return Quintic(0.0, 0.0, 0.0, AT_ONCE)
        late = self.way == "post-impact"
        return Quintic(0.0 if late else 1.0, 1.0 if late else 0.0, self.pace, self.shortest)


#: Duration of a jump of the set-point [s], chosen: one tick.
AT_ONCE = 1e-3


class SettlingSettings(Settings):
    """Bounds within which the robot has settled."""

    tolerance: Length = 0.1
    """Distance from the goal. Chosen: the paper's L_c."""
    speed: Speed = 0.3
    """Speed. Chosen."""
    dwell: Duration = 0.3
    """Time within both, for the evaluator. Chosen."""
    stay: Duration = 0.5
    """Time within both before the pilot goes on, at p_r and at home. Chosen; at least `dwell`."""
    patience: Duration = 2.0
    """Time after the end of a reference when the pilot goes on anyway, for example if the robot
    leans on the wall and cannot get away. Chosen: more than the 1.5 s in which it settles."""

    @model_validator(mode="after")
    def _check_stay(self) -> SettlingSettings:
        if self.stay < self.dwell:
            raise problem(f"must be at least dwell, {self.dwell:g} s (got {self.stay:g} s)", "stay")
        return self


class RecoverySettings(Settings):
    """Settings of a pilot that recovers from collisions; its run-up is the scenario's reference."""

    detection: DetectionSettings = DetectionSettings()
    observer: ObserverSettings = ObserverSettings()
    characterisation: CharacterisationSettings = CharacterisationSettings()
    response: ResponseSettings = ResponseSettings()
    settling: SettlingSettings = SettlingSettings()
    returns: bool = True
    """True if the robot flies home from p_r; else it stays there."""
    home: Annotated[Triple, Unit("m")] | None = None
    """Position to return to; by default the scenario's start."""
    home_speed: Speed = 1.0
    """Largest speed of the return. Chosen."""
    runs: Annotated[int, Field(ge=1, le=1000, strict=True)] = 1
    """Number of collisions, one run-up after another, without landing."""

    def triggers(self, compliant: bool, inertial: float, hall: float) -> Detection:
        """Triggers for the kernels.

        Args:
            compliant: True if an arm can slide.
            inertial: Interval between inertial samples [s].
            hall: Interval between samples of the Hall sensors [s].
        """
        d = self.detection
        alone = d.own is None
        triggers = Detection(
            d.hall.trigger(alone and compliant, d.hall.threshold, hall),
            d.acceleration.trigger(alone and not compliant, d.acceleration.threshold, inertial),
            d.wrench.trigger(False, d.wrench.threshold, inertial),
        )
        if alone and not any(trigger.used for trigger in triggers):
            raise problem("uses no trigger, so no collision would be detected", "detection")
        if triggers.hall.used and not compliant and d.hall.used is not None:
            raise problem("must be false if no arm can slide", "detection.hall.used")
        return triggers

    def wrench_observer(
        self, mass: float, gravity: float, lag: float, tick: float, interval: float
    ) -> Observer:
        """Observer for the kernels.

        Args:
            mass: Of the whole vehicle in the pilot's model [kg].
            gravity: g [m/s²].
            lag: Time constant of the rotors in the pilot's model [s].
            tick: Of the clock [s].
            interval: Between inertial samples [s].
        """
        o = self.observer
        for name in ("force_bandwidth", "moment_bandwidth", "steady_bandwidth", "fading"):
            if getattr(o, name) * interval > 1.0:
                raise problem(
                    f"must be at most {1.0 / interval:g} 1/s, the rate of the inertial samples "
                    f"(got {getattr(o, name):g} 1/s)",
                    f"observer.{name}",
                )
        return Observer(
            mass=mass,
            gravity=gravity,
            interval=interval,
            force_gain=o.force_bandwidth,
            moment_gain=o.moment_bandwidth,
            steady_gain=o.steady_bandwidth,
            rotor_share=1.0 - math.exp(-tick / lag) if lag > 0.0 else 1.0,
            momentum=1.0 if o.basis == "momentum" else 0.0,
            fading=o.fading,
        )

    def among(self, *, upright: bool) -> RecoverySettings:
        """The same among obstacles that all are upright or not, if nothing else is said of them."""
        look = self.characterisation
        if look.level is not None:
            return self
        return self.with_checked(characterisation=look.with_checked(level=upright))

    def collision_characterisation(self, full_scale: float) -> Characterisation:
        """Characterisation for the kernels, given the accelerometer's range [m/s²]."""
        look = self.characterisation
        return Characterisation(
            window=look.window,
            longer=look.longer,
            arms=1.0 if look.source == "arms" else 0.0,
            acceleration=1.0 if look.source == "acceleration" else 0.0,
            wrench=1.0 if look.source == "wrench" else 0.0,
            fused=1.0 if look.source == "fused" else 0.0,
            share=look.share,
            level=0.0 if look.level is False else 1.0,
            limit=min(WITHIN_RANGE * full_scale, NO_RANGE),
        )

    def route(self, start: Vec) -> Route:
        """Phases of the recovery for the kernels, given the start [m]."""
        s = self.settling
        return Route(
            response=self.response.response(),
            distance=self.response.distance,
            tolerance=s.tolerance,
            slow=s.speed,
            dwell=s.stay,
            patience=s.patience,
            returns=1.0 if self.returns else 0.0,
            home=start if self.home is None else Vec(*self.home),
            speed=self.home_speed,
            runs=float(self.runs),
        )

    def rest_evaluator(self) -> RestEvaluator:
        """Evaluator of a pilot of the user's own, with the same bounds, for any place."""
        return RestEvaluator(self.settling.speed, self.settling.dwell)

    def evaluator(self) -> Evaluator:
        """Evaluator for the kernels, with the same bounds for the true motion."""
        s = self.settling
        return Evaluator(s.tolerance, s.speed, s.dwell)
