"""Likelihood of an impact: residuals of all readings, and of the priors, at many points at once."""

from __future__ import annotations

import copy
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.batch.sampled import StateSamples, sampled_flights
from springback.batch.templates import KnownFormulas
from springback.batch.workers import own_threads
from springback.errors import InputError
from springback.identification.observations.channel_window import ChannelWindow
from springback.identification.observations.noise import STUDENT, residuals_in_bins
from springback.identification.observations.sensor_chain import (
    ChannelChain,
    Interpolator,
    attitude_errors,
    channel_output,
    fine_grid,
    inertial_means,
    mean_rates,
    smooth,
)
from springback.identification.observations.windows import (
    CLEAR,
    ImpactWindow,
    WindowPlan,
)
from springback.identification.settings import InertialChannel
from springback.identification.unknowns import (
    FARTHEST,
    Unknown,
    latent,
    with_lists,
    with_values,
)
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ARM_LENGTH,
    ATTITUDE,
    POSITION,
    SPECIFIC_FORCE,
    VELOCITY,
    Array,
)
from springback.scenario.scenario import Scenario, scenario_from
from springback.sensing.hall import HallSensors, resolution

#: Scale of Student's t at which normal noise of deviation 1 has equal score variance and
#: curvature, so that intervals keep their cover (solved numerically, for 4 degrees of freedom).
STUDENT_SCALE = 0.8977
#: Factor of the start's uncertainties where no track tells them (chosen).
UNTRACKED = 3.0
#: Time after release from which residuals tell of noise [s], and deviations beyond which a sample
#: is an outlier (chosen).
SETTLED, OUTLIER = 0.02, 5.0
_AXES = "xyz"
#: Latents of an accelerometer's calibration.
SCALE, TURN = "accelerometer scale", "accelerometer misalignment"
#: Distance from their balance [m] and rate [m/s] below which arms are locked (chosen).  What they
#: still move is lost at once, which an accelerometer sees in the one sample that it falls into: by
#: default 0.9 of its noise, and another sample for numbers that differ in the last digit; the cost
#: then jumps by 2, and has several optima.
STILL_ARM, STILL_RATE = 1e-8, 1e-6
#: Samples of an accelerometer that are compared by their mean, at most, and bins of a contact at
#: least (chosen: of sets of examples/fit.toml, samples alone leave two optima in five of 14, means
#: of four in one of 16; of 60 sets, 95 % intervals of five fields have the truth in 95, 86, 90, 95
#: and 83 % with samples alone, in 93, 92, 93, 92 and 90 % with means of three, which make standard
#: errors wider by 4 to 24 %, as in three sets).
BINNED, BINS = 3, 6
#: Latents of the corner of a low-pass.
CORNER = {
    SPECIFIC_FORCE: "accelerometer low-pass", ANGULAR_VELOCITY: "gyroscope low-pass",
}  # fmt: skip


class JointPrior(NamedTuple):
    """Normal prior of some unknowns with their correlations; that of the others stays."""

    which: Any  # places of the unknowns, shape (some,)
    mean: Array  # u, shape (some,)
    root: Array  # L of their covariance L Lᵀ, shape (some, some)

    def residuals(self, u: Array) -> Array:
        """Residuals of the prior of all unknowns at some points, shape as given."""
        found = u.copy()
        found[:, self.which] = np.linalg.solve(self.root, (u[:, self.which] - self.mean).T).T
        return found

    @property
    def precision(self) -> float:
        """Logarithm of the determinant of their precision."""
        return -2.0 * float(np.log(np.diag(self.root)).sum())


class ImpactProblem:
    """Residuals of an impact as a function of its unknowns."""

    def __init__(
        self,
        plan: WindowPlan,
        scenario: Scenario,
        tables: Mapping[str, Any],
        fields: Sequence[Unknown],
        impact: ImpactWindow,
    ) -> None:
        """Prepare the unknowns and the instants.

        Args:
            plan: Of the fit.
            scenario: Of this flight.
            tables: The same as plain tables.
            fields: Free and known fields.
            impact: Readings.
        """
        self.plan, self.scenario, self.impact = plan, scenario, impact
        self.tables = with_lists(open_loop(tables, impact), fields, scenario)
        self.slider = scenario.model.slider
        self.readings = [
            one for one in impact.readings
            if self.slider is None or one.quantity not in (ANGULAR_VELOCITY, ATTITUDE)
        ]  # fmt: skip
        self.fields = list(fields)
        self.unknowns: list[Unknown] = [*fields, *self._latents()]
        self.place = {unknown.name: k for k, unknown in enumerate(self.unknowns)}
        self.flies = np.array([one.flies for one in self.unknowns])
        inertial = [
            one.times for one in self.readings
            if one.quantity in (SPECIFIC_FORCE, ANGULAR_VELOCITY)
        ]  # fmt: skip
        every = np.concatenate([*inertial, [impact.until]])
        self.grid = fine_grid(every, impact.until)
        self.count = len(self.fields)
        #: What is known of the unknowns together, in place of the prior of each.
        self.together: JointPrior | None = None
        #: Flights flown so far.
        self.flown = 0
        self._width, self._formulas, self._binned = 0, KnownFormulas(), BINNED

    def of_samples(self) -> ImpactProblem:
        """The same with the samples of an accelerometer one by one, not means of some."""
        found = copy.copy(self)
        found._width, found._binned = 0, 1
        return found

    # -- unknowns ---------------------------------------------------------------------------------

    def _latents(self) -> list[Unknown]:
        plan, found = self.plan, list[Unknown]()
        start, s = self.impact.start, plan.start
        wide = 1.0 if start.tracked or start.fallen else UNTRACKED
        fall = self.scenario.world.gravity * s.height / start.fallen if start.fallen else 0.0
        if self.slider is None:
            for name, uncertainty, unit in (
                ("position", s.position, "m"), ("velocity", s.velocity, "m/s"),
                ("attitude", s.attitude, "rad"), ("angular velocity", s.angular_velocity, "rad/s"),
            ):  # fmt: skip
                found += [
                    latent(
                        f"start {name} {a}",
                        fall if fall and (name, a) == ("velocity", "z") else wide * uncertainty,
                        unit,
                    )
                    for a in _AXES
                ]
            found.append(latent("thrust factor", plan.thrust, "", centre=1.0))
        else:
            found.append(latent("start position", wide * s.position, "m"))
            found.append(latent("start velocity", fall or wide * s.velocity, "m/s"))
        names = {one.quantity: one for one in self.readings}
        sensors = plan.sensors
        for quantity, uncertainty, word, unit in (
            (SPECIFIC_FORCE, sensors.accelerometer.bias, "accelerometer bias", "m/s^2"),
            (ANGULAR_VELOCITY, sensors.gyroscope.bias, "gyroscope bias", "rad/s"),
            (POSITION, sensors.motion_capture.offset, "motion capture offset", "m"),
        ):
            if quantity in names:
                found += [latent(f"{word} {a}", uncertainty, unit, flies=False) for a in _AXES]
        if SPECIFIC_FORCE in names:
            part = sensors.accelerometer
            if part.scale is not None:
                found.append(latent(SCALE, part.scale, "", centre=1.0, flies=False, of_device=True))
            if part.misalignment is not None:
                found += [
                    latent(f"{TURN} {a}", part.misalignment, "rad", flies=False, of_device=True)
                    for a in _AXES
                ]
        found += self._corners()
        if any(one.other_clock for one in self.readings):
            found.append(latent("clock offset", self.impact.clock_uncertainty, "s", flies=False))
        return found

    def _corners(self) -> list[Unknown]:
        """Corners of low-passes that are known to some uncertainty."""
        found = []
        for one in self.readings:
            if one.quantity not in CORNER:
                continue
            word = "accelerometer" if one.quantity == SPECIFIC_FORCE else "gyroscope"
            part: InertialChannel = getattr(self.plan.sensors, word)
            if (share := part.low_pass_uncertainty) is None:
                continue
            corner = self.chain(one).low_pass
            if corner is None:
                raise InputError(
                    f"sensors.{word}.low_pass_uncertainty: needs a corner, which neither plan, log "
                    f"nor scenario tells; give low_pass = '30 Hz +- {100.0 * share:g} %'"
                )
            text = f"{corner:g} Hz +- {100.0 * share:g} %"
            found.append(Unknown(
                CORNER[one.quantity], "latent", float(np.log(corner)), share, True, "Hz", text,
                flies=False, of_device=True,
            ))  # fmt: skip
        return found

    def _columns(self, u: Array, *names: str) -> Array:
        """Values of unknowns at some points, shape (points, names)."""
        return np.stack(
            [np.asarray(self.unknowns[self.place[name]].value(u[:, self.place[name]]))
             for name in names], axis=1,
        )  # fmt: skip

    # -- flights ----------------------------------------------------------------------------------

    def _flown(self, u: Array) -> tuple[StateSamples, Any]:
        """Flights of some points, and the number of the flight of each point."""
        moving = u[:, self.flies]
        _, firsts, which = np.unique(moving, axis=0, return_index=True, return_inverse=True)
        tables = self._tables(u[firsts])
        factors = None
        if "thrust factor" in self.place:
            factors = self._columns(u[firsts], "thrust factor")[:, 0]
        self.flown += len(tables)
        samples = sampled_flights(
            tables, self.grid, thrust_factors=factors, threads=own_threads(), known=self._formulas
        )
        return samples, which.reshape(-1)

    def flight_tables(self, u: Array) -> dict[str, Any]:
        """Scenario of the flight at a point, without avionics, as plain tables."""
        return self._tables(u[None])[0]

    def _tables(self, u: Array) -> list[dict[str, Any]]:
        """Scenarios of the flights at some points."""
        found = [with_values(self.tables, self.fields, row) for row in u[:, : self.count].tolist()]
        turns = () if self.slider is None else ("roll", "pitch", "yaw", "quaternion")
        for tables, start in zip(found, self._starts(u), strict=True):
            given = tables.get("start", {})
            tables["start"] = {key: given[key] for key in turns if key in given} | start
        return found

    def _starts(self, u: Array) -> list[dict[str, Any]]:
        """What latents tell of their starts."""
        start = self.impact.start
        if self.slider is None:
            names = [
                f"start {name} {a}"
                for name in ("position", "velocity", "attitude", "angular velocity") for a in _AXES
            ]  # fmt: skip
            moved = start.displace(self._columns(u, *names))
            given = zip(
                moved.position.tolist(), moved.velocity.tolist(), moved.attitude.tolist(),
                moved.angular_velocity.tolist(), strict=True,
            )  # fmt: skip
            keys = ("position", "velocity", "quaternion", "angular_velocity")
            return [dict(zip(keys, one, strict=True)) for one in given]
        axis = np.array(self.slider) / np.linalg.norm(self.slider)
        return [
            {
                "position": (start.position + way * axis).tolist(),
                "velocity": (start.velocity + speed * axis).tolist(),
            }
            for way, speed in self._columns(u, "start position", "start velocity")
        ]

    def refusal(self, u: Array) -> str:
        """Why a flight cannot be flown; empty if it can."""
        try:
            scenario_from(self.flight_tables(u), False, advises=False).build(advises=False)
        except InputError as error:
            return "; ".join(error.problems)
        return ""

    # -- residuals --------------------------------------------------------------------------------

    def __call__(self, u: Array) -> Array:
        """Residuals at some points, shape (points, unknowns) to (points, rows)."""
        try:
            samples, which = self._flown(u)
        except InputError:
            if not self._width:
                raise
            return np.full((len(u), self._width), np.nan)
        parts = [self._channel_rows(one, samples, which, u) for one in self.readings]
        prior = u if self.together is None else self.together.residuals(u)
        found = np.concatenate([*parts, prior], axis=1)
        self._width = found.shape[1]
        lost: Any = np.isnan(samples.values).any(axis=(1, 2))
        found[lost[which]] = np.nan
        return found

    def refine_noise(self, u: Array) -> None:
        """Estimate noise again, by the residuals outside the contact at a point, too."""
        errors, impact, better = self.errors(u), self.impact, list[ChannelWindow]()
        for one in self.readings:
            white = errors[one.name]
            outside = (one.times < impact.touch - CLEAR) | (one.times > impact.release + SETTLED)
            outside &= (np.abs(white) < OUTLIER).all(axis=1) & (white != 0.0).any(axis=1)
            better.append(one._replace(noise=one.noise.with_residuals(white[outside])))
        self.readings = better

    def errors(self, u: Array) -> dict[str, Array]:
        """Whitened residuals of each channel at a point, before Student's t, by its name."""
        samples, which = self._flown(u[None])
        return {one.name: self._white(one, samples, which, u[None])[0] for one in self.readings}

    def predictions(self, u: Array) -> dict[str, Array]:
        """What each channel would have told, by its name.

        Args:
            u: A point, or several, shape (..., unknowns).

        Returns:
            Shape (..., samples, width); NaN where a flight was refused or diverged.
        """
        points = np.atleast_2d(u)
        samples, which = self._flown(points)
        found = {one.name: self._predicted(one, samples, which, points) for one in self.readings}
        return {name: values if u.ndim > 1 else values[0] for name, values in found.items()}

    def _channel_rows(
        self, one: ChannelWindow, samples: StateSamples, which: Any, u: Array
    ) -> Array:
        white = self._white(one, samples, which, u)
        if one.quantity in (POSITION, ATTITUDE):
            square = (white / STUDENT_SCALE) ** 2
            white = np.sign(white) * np.sqrt((STUDENT + 1.0) * np.log1p(square / STUDENT))
        if one.quantity == SPECIFIC_FORCE:
            white = residuals_in_bins(white, self._bin_size(one.times))
        return white.reshape(len(u), -1)

    def _bin_size(self, times: Array) -> int:
        """Samples that are compared by their mean."""
        touch, release = self.impact.touch, self.impact.release
        within = int(((times >= touch) & (times <= release)).sum())
        return min(max(within // BINS, 1), self._binned)

    def _white(self, one: ChannelWindow, samples: StateSamples, which: Any, u: Array) -> Array:
        predicted = self._predicted(one, samples, which, u)
        if one.quantity == ATTITUDE:
            rest = attitude_errors(predicted, one.values)
        else:
            rest = one.values - predicted
        if one.quantity == ARM_LENGTH:
            sigma = np.hypot(one.noise.stationary, self.resolution(one))
            return np.where(np.isnan(rest), 0.0, rest / sigma)
        return one.noise.whiten(rest, one.starts)

    def _predicted(self, one: ChannelWindow, samples: StateSamples, which: Any, u: Array) -> Array:
        if one.quantity in (SPECIFIC_FORCE, ANGULAR_VELOCITY):
            return self._inertial(one, samples, which, u)
        times = np.broadcast_to(one.times, (len(u), len(one.times)))
        if one.other_clock:
            times = times + self._columns(u, "clock offset")
        between = Interpolator(samples, which, times)
        if one.quantity == ATTITUDE:
            return between.attitudes()
        if one.quantity == ARM_LENGTH:
            width = min(one.values.shape[1], len(self.scenario.start_state().arm_length))
            arms = range(1, width + 1)
            lengths = samples.of(*(f"arm_length.{j}" for j in arms))
            rates = samples.of(*(f"arm_rate.{j}" for j in arms))
            # Of before, as readings are.
            found = between.positions(lengths - lengths[:, :1], rates)
            return found if one.clipped is None else _at_ends(found, one, width)
        if one.quantity == VELOCITY:
            return between.linear(samples.vectors("velocity"))
        place = between.positions(samples.vectors("position"), samples.vectors("velocity"))
        names = [f"motion capture offset {a}" for a in _AXES]
        place = place + self._columns(u, *names)[:, None]
        corner = self.plan.sensors.motion_capture.smoothing
        if corner is not None and len(one.times) > 3:
            place = smooth(place, 1.0 / float(np.median(np.diff(one.times))), corner)
        return place

    def _inertial(self, one: ChannelWindow, samples: StateSamples, which: Any, u: Array) -> Array:
        is_force = one.quantity == SPECIFIC_FORCE
        word = "accelerometer bias" if is_force else "gyroscope bias"
        if is_force:
            place = self.plan.sensors.place or self.scenario.sensors.imu.offset
            gravity = self.scenario.world.gravity
            true = inertial_means(samples, np.array(place), gravity).specific_force
        else:
            true = mean_rates(samples)
        bias = self._columns(u, *(f"{word} {a}" for a in _AXES))
        felt = self._calibrated(true[which], u) if is_force else true[which]
        corner, corners = CORNER[one.quantity], None
        if corner in self.place:
            corners = self._columns(u, corner)[:, 0]
        return channel_output(felt, bias, self.chain(one), samples.times, one.times, corners)

    def _calibrated(self, true: Array, u: Array) -> Array:
        """Specific forces as an accelerometer of another scale, turned a little, has them."""
        if f"{TURN} x" in self.place:
            turn = self._columns(u, *(f"{TURN} {a}" for a in _AXES))
            true = true - np.cross(turn[:, None, :], true)
        if SCALE in self.place:
            true = true * self._columns(u, SCALE)[:, None, :]
        return true

    def chain(self, one: ChannelWindow) -> ChannelChain:
        """Chain of an inertial channel: as the plan has it, else the log, else the scenario."""
        is_force = one.quantity == SPECIFIC_FORCE
        sensors, told = self.plan.sensors, one.chain
        given: InertialChannel = sensors.accelerometer if is_force else sensors.gyroscope
        full: float | None = getattr(given, "full_scale", None)
        low, average = given.low_pass, given.average
        full = told.full_scale if full is None else full
        low = told.low_pass if low is None else low
        order = 1 if low is None else told.low_pass_order or 1  # a scenario's is of first order
        order = given.low_pass_order or order
        device = given.device_low_pass
        average = told.average if average is None else average
        imu = self.scenario.sensors.imu
        if has_sensors(self.scenario) and not imu.perfect:
            part = imu.accelerometer if is_force else imu.gyroscope
            full = part.full_scale if full is None else full
            if device is None and low is not None and order == 2:  # of the autopilot, behind it
                device = part.bandwidth
            low = part.bandwidth if low is None else low
        return ChannelChain(full, low, average, order, device)

    def resolution(self, one: ChannelWindow) -> Any:
        """Standard deviation of a count of the converter at each arm length [m]."""
        s = self.scenario
        if not has_sensors(s) or s.sensors.hall.perfect:
            return 0.0
        device = s.sensors.devices(1.0 / s.clock, s.vehicle).arm_length
        assert isinstance(device, HallSensors)
        pressed = -np.nan_to_num(one.values)
        spans = [*device.spans, *(device.spans[-1],) * max(0, pressed.shape[1] - len(device.spans))]
        found = [
            [resolution(device, abs(x) if span.opens else max(x, 0.0), span.share)
             for x, span in zip(row, spans, strict=False)] for row in pressed.tolist()
        ]  # fmt: skip
        return np.array(found) / np.sqrt(12.0)

    @property
    def farthest(self) -> float:
        """Bound of every number."""
        return FARTHEST


def _at_ends(lengths: Array, one: ChannelWindow, width: int) -> Array:
    """Lengths of arms as their sensors tell them where a reading is at the end of its range.

    Args:
        lengths: Predicted, of before, shape (points, samples, arms).
        one: Readings.
        width: Number of arms.
    """
    read, clipped = one.values[:, :width], np.asarray(one.clipped)[:, :width]
    beyond = np.where(read > 0.0, lengths > read, lengths < read)
    return np.where(clipped & beyond, read, lengths)


def has_sensors(scenario: Scenario) -> bool:
    """True if a scenario's flights have sensors: those it gives, or the usual ones of a pilot."""
    given = scenario.reference is not None or scenario.pilot is not None
    return given or "sensors" in scenario.model_fields_set


def open_loop(tables: Mapping[str, Any], impact: ImpactWindow) -> dict[str, Any]:
    """Tables of a flight without avionics, under the thrusts that were logged, or hovering."""
    left_out = ("reference", "pilot", "recovery", "control", "estimator", "second", "sensors")
    kept = {key: value for key, value in tables.items() if key not in left_out}
    piloted = any(tables.get(key) is not None for key in ("reference", "pilot"))
    if impact.thrust is not None:
        kept["thrust"] = impact.thrust
    elif piloted:
        kept["thrust"] = "hover"
    settling = {"arm_tolerance": STILL_ARM, "rate_tolerance": STILL_RATE}
    simulation = {**kept.get("simulation", {}), **settling, "duration": impact.until + 1e-3}
    return kept | {"simulation": simulation}
