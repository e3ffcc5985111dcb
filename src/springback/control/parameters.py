"""Controllers: validated user input, converted to the numbers of the laws.

The paper prints no gains.  One rule serves both of its robots: the same stiffness, a force per
metre, and the damping ratio of a Bessel filter.  A heavier robot is then slower, as ARQ's steps are
in Table IV.  Two stiffnesses are fitted to the steps of Quad, and those of ARQ follow
(studies/gains.py).
"""

from __future__ import annotations

import math
from typing import Annotated, Any, Literal, NamedTuple, Self

from springback.control.attitude import FullQuaternion, LeeSO3, Reduced
from springback.control.position import PositionLaw
from springback.control.rate import RateLaw
from springback.kernels.tracing import sqrt  # for batch set-up
from springback.kernels.vectors import Vec
from springback.quantities import Duration, Factor, Unit
from springback.sensing.measurement import Pace, task_pace
from springback.settings import Settings, problem

#: Fraction of the weight that the position loop always lifts, so that the direction of thrust is
#: defined (chosen: nearly free fall is still allowed).
LEAST_LIFT = 0.05
#: Mass of Quad [kg]; a lighter robot with its stiffness would be too fast for its attitude loop.
LIGHT = 1.214
#: Unreachable thrust [N], for a position loop without limit.
FAR_BEYOND = 1e9
#: Rate error at which the rate loop's integral stops growing: 400 deg/s, PX4's RateControl.
INTEGRAL_FADE = math.radians(400.0)
#: Tolerance for a product of clock and period to be a whole number: rounding of decimals.
WHOLE = 1e-6

#: Damping ratio of a two-pole Bessel filter, which delays all frequencies equally (Thomson 1949).
BESSEL = math.sqrt(0.75)

AttitudeLaw = FullQuaternion | Reduced | LeeSO3


class Schedule(NamedTuple):
    """Periods of the loops on the clock."""

    position: Pace
    attitude: Pace
    rate: Pace
    delay: float  # of position commands, in ticks


class ControlSettings(Settings):
    """The cascade of position, attitude and rate control."""

    stiffness: Annotated[float, Unit("N/m", least=0.0)] = 9.25
    """K_p, horizontal.  Fitted to Quad's steps in Table IV (studies/gains.py); by default reduced
    in proportion for a lighter robot, which is then as fast as Quad; so is `vertical_stiffness`."""
    vertical_stiffness: Annotated[float, Unit("N/m", least=0.0)] = 20.0
    """K_p, vertical. Fitted, as above."""
    damping_ratio: Annotated[float, Unit("", least=0.0)] = BESSEL
    """ζ, from which K_v = 2 ζ √(K_p m) where none is given.  Chosen from the textbook's √½, √¾ and
    1: no other agrees with the steps of Table IV (studies/gains.py).
    """
    damping: Annotated[float, Unit("N s/m", least=0.0)] | None = None
    """K_v, horizontal, instead of the one from the damping ratio."""
    vertical_damping: Annotated[float, Unit("N s/m", least=0.0)] | None = None
    """K_v, vertical, instead of the one from the damping ratio."""
    integral: Annotated[float, Unit("N/(m s)", least=0.0)] = 0.0
    """K_i of all three axes; the paper's laws have none."""
    integral_limit: Annotated[float, Unit("N", least=0.0)] = 2.0
    """Largest force of the integral along each axis. Chosen: a sixth of the weight."""
    feedback_acceleration: Annotated[float, Unit("m/s^2", above=0.0)] = 12.0
    """Limit for position and velocity errors. Chosen: nearly the reserve of the rotors, 1.34 g;
    with the 9 of mavros_controllers (max_fb_acc) Quad's steps in z miss the MSE of Table IV
    (studies/gains.py).
    """
    horizontal_margin: Annotated[float, Unit("", least=0.0, most=1.0)] = 0.3
    """Fraction of a limited force that is reserved for the horizontal. PX4's MPC_THR_XY_MARG."""
    feed_forward: bool | None = None
    """Feed forward the angular velocity from jerk and yaw rate, and the tilt in advance by the
    known delays of the loops. By default for run-ups only; the paper's other references define no
    jerk.
    """
    tilt_limit: Annotated[float, Unit("rad", above=0.0, most=math.radians(89.0))] = math.radians(
        85.0
    )
    """Largest commanded tilt. Chosen: beyond the 66 deg that the paper reports, below 90 deg."""

    attitude: Literal["reduced", "full", "lee"] = "reduced"
    """Brescianini with tilt before yaw, as in PX4; or with all axes equal; or Lee's on SO(3)."""
    time_constant: Duration = 1.0 / 6.5
    """τ of tilt errors, and of yaw in `full` and `lee`. PX4's MC_ROLL_P = MC_PITCH_P = 6.5 1/s."""
    yaw_time_constant: Duration = 1.0 / 2.8
    """τ of yaw errors in `reduced`. PX4's MC_YAW_P = 2.8 1/s."""
    yaw_weight: Annotated[float, Unit("", least=0.0, most=1.0)] = 0.4
    """p of `reduced`. Brescianini et al. found 0.4 best; PX4's MC_YAW_WEIGHT."""
    rate_limit: Annotated[float, Unit("rad/s", above=0.0)] = math.radians(220.0)
    """Limit for roll and pitch. PX4's MC_ROLLRATE_MAX = MC_PITCHRATE_MAX = 220 deg/s."""
    yaw_rate_limit: Annotated[float, Unit("rad/s", above=0.0)] = math.radians(200.0)
    """PX4's MC_YAWRATE_MAX = 200 deg/s."""

    rate_gain: Annotated[float, Unit("1/s", above=0.0)] = 40.0
    """k_ω of all three axes. PX4's MC_ROLLRATE_P = MC_PITCHRATE_P = 0.15 of the full roll or pitch
    of its mixer, 4 T √½ L √½ with T = 7.0 N and L = 0.19 m, is 0.40 N m s: 43 and 37 1/s by Quad's
    moments of inertia about x and y."""
    rate_integral: Annotated[float, Unit("1/s^2", least=0.0)] = 0.0
    """Chosen: none; the modelled robots have no steady torque to compensate.  The 0.2/0.15 1/s of
    PX4's MC_PITCHRATE_I over MC_PITCHRATE_P would make it 53: run-ups then overshoot.
    """
    rate_integral_limit: Annotated[float, Unit("rad/s^2", least=0.0)] = 80.0
    """k_ω times PX4's MC_PR_INT_LIM/MC_PITCHRATE_P = 0.30/0.15 rad/s."""
    rate_derivative: Factor = 0.0
    """Gain on the filtered angular acceleration. Chosen: none."""
    gyro_cutoff: Annotated[float, Unit("1/s", least=0.0)] = 30.0
    """Cut-off of the first-order gyroscope filter [Hz]; 0 disables it.

    PX4's IMU_GYRO_CUTOFF since 1.9 (pull request 11950).
    """
    gyroscopic: bool = True
    """Add ω × J ω. Brescianini et al. 2013, inner loop."""

    lift_share: Annotated[float, Unit("", least=0.0, most=1.0)] = 0.12
    """Fraction of the maximum collective thrust to which roll and pitch may raise a smaller one; 1
    is PX4's airmode.  PX4's MPC_THR_MIN = 0.12 with its default MC_AIRMODE off.
    """

    position_frequency: Annotated[float, Unit("1/s", above=0.0)] = 100.0
    """[Hz] mavros_controllers, main loop."""
    attitude_frequency: Annotated[float, Unit("1/s", above=0.0)] = 250.0
    """[Hz] PX4."""
    rate_frequency: Annotated[float, Unit("1/s", above=0.0)] = 1000.0
    """[Hz] PX4, driven by the gyroscope."""
    offboard_delay: Annotated[float, Unit("s", least=0.0)] = 0.01
    """Delay from the position loop to the autopilot. Chosen: one period of the position loop."""

    def for_mass(self, mass: float) -> Self:
        """These settings, the stiffnesses that are not given being those for a mass [kg]."""
        usual = {"stiffness", "vertical_stiffness"} - self.model_fields_set
        if mass >= LIGHT or not usual:
            return self
        defaults = type(self).model_fields
        return self.model_copy(
            update={name: float(defaults[name].default) * mass / LIGHT for name in usual}
        )

    def damping_for(self, mass: float) -> tuple[float, float]:
        """K_v, horizontal and vertical [N s/m]: as given, else 2 ζ √(K_p m) for a mass m [kg]."""
        springs = (self.stiffness, self.damping), (self.vertical_stiffness, self.vertical_damping)
        ratio = self.damping_ratio
        horizontal, vertical = (
            2.0 * ratio * sqrt(kp * mass) if kv is None else kv for kp, kv in springs
        )
        return horizontal, vertical

    def position_law(
        self, mass: float, gravity: float, max_thrust: float = math.inf
    ) -> PositionLaw:
        """Settings of the position loop, for its model of the vehicle.

        Args:
            mass: Mass [kg].
            gravity: g [m/s²].
            max_thrust: Maximum collective thrust [N].
        """
        kp, ki = self.stiffness, self.integral
        kv, vertical = self.damping_for(mass)
        return PositionLaw(
            stiffness=Vec(kp, kp, self.vertical_stiffness),
            damping=Vec(kv, kv, vertical),
            integral=Vec(ki, ki, ki),
            integral_limit=self.integral_limit,
            feedback_limit=mass * self.feedback_acceleration,
            mass=mass,
            gravity=gravity,
            slope=math.tan(self.tilt_limit),
            min_lift=LEAST_LIFT * mass * gravity,
            max_thrust=min(max_thrust, FAR_BEYOND),
            margin=self.horizontal_margin,
            feed_forward=1.0 if self.feed_forward else 0.0,
            tilt_lead=self.tilt_lead() if self.feed_forward else 0.0,
            rate_lead=self.rate_lead() if self.feed_forward else 0.0,
            period=1.0 / self.position_frequency,
        )

    def tilt_lead(self) -> float:
        """Time by which the tilt of a reference is commanded ahead [s].

        The offboard delay, and half a period each for which commands of the position and attitude
        loops are held.
        """
        holds: float = 0.5 / self.position_frequency + 0.5 / self.attitude_frequency
        lead: float = self.offboard_delay + holds
        return lead

    def rate_lead(self) -> float:
        """Time by which the angular velocity of a reference is commanded ahead [s].

        The lead of the tilt, plus the lag 1/k_ω − τ_f of the rate loop.  The filter τ_f in its
        feedback makes it faster: ω/ω_wanted = 1/(F + s (1 + τ s)/k_ω), F = 1/(1 + τ_f s), to first
        order in s.  The rotors' τ is of second order.  An integral eliminates that lag.
        """
        if self.rate_integral > 0.0:
            return self.tilt_lead()
        lag: float = 1.0 / self.rate_gain - self.gyro_lag()
        return self.tilt_lead() + max(lag, 0.0)

    def attitude_law(self) -> AttitudeLaw:
        """Settings of the attitude loop; their type is the law."""
        tilt, yaw = 1.0 / self.time_constant, 1.0 / self.yaw_time_constant
        limit = Vec(self.rate_limit, self.rate_limit, self.yaw_rate_limit)
        if self.attitude == "full":
            return FullQuaternion(Vec(tilt, tilt, tilt), limit)
        if self.attitude == "lee":
            return LeeSO3(Vec(tilt, tilt, tilt), limit)
        p = self.yaw_weight
        return Reduced(Vec(tilt, tilt, yaw / p if p > 0.0 else 0.0), p, limit)

    def rate_law(self) -> RateLaw:
        """Settings of the rate loop."""
        k, i, d = self.rate_gain, self.rate_integral, self.rate_derivative
        period = 1.0 / self.rate_frequency
        return RateLaw(
            gain=Vec(k, k, k),
            integral=Vec(i, i, i),
            derivative=Vec(d, d, d),
            integral_limit=self.rate_integral_limit,
            integral_fade=INTEGRAL_FADE,
            filter_share=period / (period + self.gyro_lag()),
            gyroscopic=1.0 if self.gyroscopic else 0.0,
            period=period,
        )

    def gyro_lag(self) -> float:
        """Time constant of the gyroscope filter [s]: 1/(2π f)."""
        return 1.0 / (2.0 * math.pi * self.gyro_cutoff) if self.gyro_cutoff > 0.0 else 0.0

    def schedule(self, clock: float) -> Schedule:
        """Periods of the loops on a clock of given rate [Hz].

        Raises:
            The problem of a frequency that does not divide the clock's, with the nearest that do.
        """
        position = self._every("position_frequency", clock)
        return Schedule(
            task_pace(position),
            task_pace(self._every("attitude_frequency", clock)),
            task_pace(self._every("rate_frequency", clock)),
            self._delay(position, clock),
        )

    def _delay(self, position: float, clock: float) -> float:
        """Offboard delay in ticks: at most one command of the position loop is in transit."""
        ticks, delay = self.offboard_delay * clock, self.offboard_delay
        if abs(ticks - round(ticks)) > WHOLE * max(ticks, 1.0):
            raise problem(
                f"must be a whole number of ticks of {1.0 / clock:.6g} s (got {delay:.6g} s)",
                "offboard_delay",
            )
        if round(ticks) > position:
            raise problem(
                f"must be at most one period of the position loop, {position / clock:.6g} s "
                f"(got {delay:.6g} s)",
                "offboard_delay",
            )
        return float(round(ticks))

    def _every(self, name: str, clock: float) -> float:
        wanted: Any = getattr(self, name)
        ticks = clock / wanted
        if ticks >= 1.0 - WHOLE and abs(ticks - round(ticks)) <= WHOLE * ticks:
            return float(round(ticks))
        fewest = max(math.floor(ticks), 1)
        nearest = [clock / n for n in (fewest + 1, fewest) if ticks > 1.0 or n == 1]
        raise problem(
            f"must divide the clock's {clock:g} Hz (got {wanted:g} Hz); nearest: "
            + " and ".join(f"{value:g} Hz" for value in nearest),
            name,
        )
