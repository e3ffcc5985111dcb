"""Measures of a flight as typed attributes, so that editors complete them and mypy knows them.

The registries are `springback.simulation.measuring.measures.MEASURES` and
`springback.results.recovery_measures.RECOVERY_MEASURES`; a test compares this class with them.
"""

from __future__ import annotations


class FlightMeasures:
    """Every measure, in SI units; None for an event that did not happen.

    Those of a recovery exist only in flights with one.
    """

    restitution_at_separation: float | None
    """v_n of the main body, out at last separation / in at touch"""
    restitution_at_return: float | None
    """the same, when it is back where it was at first touch"""
    restitution_of_mass_centre: float | None
    """the same for the centre of mass, last separation"""
    touch_time: float | None
    """first touch [s]"""
    touch_speed: float | None
    """speed of the main body into the obstacle at first touch, along its normal, relative to it
    [m/s]"""
    touch_x: float | None
    """where it is touched first, world X; unknown on another vehicle [m]"""
    touch_y: float | None
    """the same, world Y [m]"""
    touch_z: float | None
    """the same, world Z [m]"""
    separation_time: float | None
    """last separation of the first impact [s]"""
    return_time: float | None
    """main body back where it was at first touch [s]"""
    contact_time: float | None
    """first touch to last separation of the first impact; impulses have none [s]"""
    time_to_return: float | None
    """first touch to the main body's return [s]"""
    travel: float | None
    """way of the main body into the obstacle, from its place at first touch until last separation;
    0 if it is driven back from there on [m]"""
    impact_peak_acceleration: float | None
    """first impact: largest |dv/dt| of the main body; an impulse has none, nor force [m/s^2]"""
    impact_peak_acceleration_time: float | None
    """time of it [s]"""
    impact_peak_specific_force: float | None
    """first impact: largest specific force of the main body, gravity included [m/s^2]"""
    impact_peak_angular_rate: float | None
    """first impact: largest angular rate [rad/s]"""
    impact_peak_normal_force: float | None
    """first impact: largest normal force of one guard, or of the main body [N]"""
    impact_penetration: float | None
    """first impact: deepest penetration of a guard, or the main body [m]"""
    impact_arm_stroke: float | None
    """first impact: largest compression of an arm [m]"""
    impact_arm_extension: float | None
    """first impact: largest extension of an arm past its free length [m]"""
    contact_duration: float | None
    """whole flight: total time in contact, all contacts [s]"""
    peak_acceleration: float | None
    """whole flight: largest |dv/dt| of the main body; none if all contacts are impulses [m/s^2]"""
    peak_acceleration_time: float | None
    """time of it [s]"""
    peak_specific_force: float | None
    """whole flight: largest specific force of the main body, gravity included [m/s^2]"""
    peak_angular_rate: float | None
    """whole flight: largest angular rate [rad/s]"""
    peak_normal_force: float | None
    """whole flight: largest normal force of one guard, or of the main body [N]"""
    penetration: float | None
    """whole flight: deepest penetration of a guard, or the main body [m]"""
    arm_stroke: float | None
    """whole flight: largest compression of an arm [m]"""
    arm_extension: float | None
    """whole flight: largest extension of an arm past its free length [m]"""
    impulse_x: float | None
    """whole flight: impulse of all contact forces on the vehicle, world X [N s]"""
    impulse_y: float | None
    """the same, world Y [N s]"""
    impulse_z: float | None
    """the same, world Z [N s]"""
    contacts: float | None
    """number of times that the vehicle came into contact"""
    body_contacts: float | None
    """number of times that the main body came into contact; needs a hull"""
    impacts: float | None
    """number of impacts: contacts closer together than the dwell time are one"""
    bottomed_time: float | None
    """an arm reached the end of its stroke [s]"""
    ground_time: float | None
    """a guard or the main body touched the ground [s]"""
    propeller_hit_time: float | None
    """a propeller was hit; needs propulsion.disk_radius [s]"""
    propellers_hit: float | None
    """number of propellers that were hit; likewise"""
    rotor_stop_time: float | None
    """a rotor stopped, hit; needs propulsion.stop [s]"""
    rotors_stopped: float | None
    """number of rotors that stopped at least once; likewise"""
    guard_margin: float | None
    """what the most loaded guard could still bear, over its limit; needs vehicle.limits"""
    arm_margin: float | None
    """the same for the force along an arm"""
    component_margin: float | None
    """the same for the specific force at a component"""
    broken_time: float | None
    """a part was loaded beyond its limit [s]"""
    end_time: float | None
    """end of the simulation [s]"""
    steps: float | None
    """Runge-Kutta steps taken"""
    energy_start: float | None
    """kinetic and stored energy, gravity above the start [J]"""
    energy_end: float | None
    """the same at the end [J]"""
    energy_kinetic: float | None
    """kinetic energy at the end [J]"""
    energy_gravity: float | None
    """gravitational energy at the end, above the start [J]"""
    energy_springs: float | None
    """in arm springs at the end [J]"""
    energy_stops: float | None
    """in end stops at the end [J]"""
    energy_contact: float | None
    """in contacts at the end [J]"""
    energy_obstacles: float | None
    """gained since the start by obstacles that move by themselves [J]"""
    work_thrust: float | None
    """done by the rotors [J]"""
    work_driven: float | None
    """done by what moves obstacles as prescribed [J]"""
    loss_arm: float | None
    """dissipated by arm dampers [J]"""
    loss_stop: float | None
    """dissipated by end stops [J]"""
    loss_contact: float | None
    """dissipated by contact damping, and when guards lose stiffness [J]"""
    loss_friction: float | None
    """dissipated by friction [J]"""
    loss_settling: float | None
    """lost when settled arms are locked again [J]"""
    loss_air: float | None
    """lost to the air; negative where wind does work [J]"""
    loss_obstacles: float | None
    """dissipated in joints of obstacles, and at their own contacts [J]"""
    ledger_residual: float | None
    """unaccounted energy, as a share of the largest energy"""
    ledger_open: float | None
    """1 if that is more than 1e-4 and 1e-9 J: the flight cannot be trusted"""
    runs: float | None
    """collisions, each with its recovery"""
    recovered_runs: float | None
    """recoveries that ended at rest, at p_r or at home"""
    false_alarms: float | None
    """alarms without a contact"""
    alarm_time: float | None
    """time of the last alarm that belongs to a collision [s]"""
    planned_time: float | None
    """time at which the return was planned, in the last run [s]"""
    rested_time: float | None
    """time at which the pilot assumed rest at p_r, or timed out [s]"""
    home_time: float | None
    """time at which the pilot assumed to be home [s]"""
    detection_delay: float | None
    """first alarm after first touch [s]"""
    hall_delay: float | None
    """first firing of the arms' trigger, after first touch [s]"""
    acceleration_delay: float | None
    """the same for the accelerometer's trigger [s]"""
    wrench_delay: float | None
    """the same for the external wrench's trigger [s]"""
    recovery_time: float | None
    """first touch to rest at p_r, or at home if it leaned on the wall [s]"""
    height_loss: float | None
    """below the height at touch, until rest [m]"""
    lowest_height: float | None
    """lowest height of the main body in the whole flight [m]"""
    excursion: float | None
    """largest horizontal distance from the point of touch, until rest [m]"""
    path: float | None
    """path length from touch until rest [m]"""
    nose_up: float | None
    """largest pitch nose up after touch, as a negative pitch [rad]"""
    nose_down: float | None
    """largest pitch nose down after touch [rad]"""
    position_error: float | None
    """error of p_c, the main body at the last alarm [m]"""
    direction_error: float | None
    """horizontal angle from the obstacle's normal to the f_c0 in use [rad]"""
    arms_direction_error: float | None
    """the same, f_c0 from the arms [rad]"""
    acceleration_direction_error: float | None
    """the same, f_c0 from the accelerometer [rad]"""
    wrench_direction_error: float | None
    """the same, f_c0 from the external wrench [rad]"""
    intensity: float | None
    """largest estimated external force [N]"""
