"""Mutations of rotors: what stops them, those that a vehicle lists, and what surfaces do to them."""

from __future__ import annotations

from oracles.mutated_lines import Mutation

#: Rotors that stop: rules, and momentum in flight.
STOP = ("vehicle/test_rotor_stop.py", "")
REACTION = ("simulation/test_rotor_stop_flights.py", "struck")
#: Listed rotors, beside virtual work; as users give them; above surfaces.
LOAD = ("dynamics/test_listed_rotors.py", "not sites")
GIVEN = ("vehicle/test_listed_rotors.py", "")
ABOVE = ("dynamics/test_surface_effect.py", "not compiled")

RULES, PLACED, SETTINGS = (
    "vehicle/rotor_stop.py",
    "vehicle/placed/rotors.py",
    "vehicle/placed/settings.py",
)
IN_PLANE, ON_JOINTS, LOCKED = (
    "dynamics/limbs/arms.py",
    "dynamics/limbs/jointed.py",
    "dynamics/limbs/locked.py",
)
MIXING, EFFECT, CLEARANCE = (
    "control/mixing.py",
    "dynamics/limbs/surface_effect.py",
    "dynamics/clearance.py",
)

MUTATIONS_OF_ROTORS = (
    Mutation("weak pushes stop rotors", RULES, "seen.force >= stop.force", "seen.force < stop.force", STOP),
    Mutation("hits put a stop off", RULES, "select(stands, now, since))", "now)", STOP),
    Mutation("propellers never break", RULES, "seen.disc * stop.breaks > 0.0", "seen.disc * stop.breaks < 0.0", STOP),
    Mutation("rotors give their momentum the wrong way", RULES, "-1.0, select(rotor.torque_ratio < 0.0, 1.0", "1.0, select(rotor.torque_ratio < 0.0, -1.0", STOP),
    Mutation("the body does not feel rotors stop", "dynamics/air.py", "moment.z + reaction)", "moment.z)", REACTION),
    # that a vehicle lists
    Mutation("listed rotor, lever, sign", PLACED, "(pose.lever ^ push) + torque", "(push ^ pose.lever) + torque", LOAD),
    Mutation("listed rotor, drag, sign", PLACED, "thrust * rotor.torque_ratio)", "-thrust * rotor.torque_ratio)", LOAD),
    Mutation("listed rotor, arm has no lever", PLACED, "(mount.end ^ push) + turning", "turning", LOAD),
    Mutation("listed rotor, hinge feels no moment", PLACED, "mount.direction @ push + mount.bend @ turning", "mount.direction @ push", LOAD),
    Mutation("listed rotor, no work on its arm", PLACED, "mount.rate * along, mount.second", "0.0 * along, mount.second", LOAD),
    Mutation("listed rotor, its offset does not turn", PLACED, "mount.turn @ rotor.offset", "rotor.offset", LOAD),
    Mutation("listed rotor, its axis always turns", PLACED, "0.0, there.turn, body_mount().turn)\n    bend", "-1.0, there.turn, body_mount().turn)\n    bend", LOAD),
    Mutation("listed rotor, on every arm", PLACED, "select(rotor.arm == number, load.along", "select(rotor.arm != number, load.along", LOAD),
    Mutation("listed rotors, no torque of speed changes", PLACED, "torque * pose.up", "0.0 * pose.up", LOAD),
    Mutation("listed rotors, no moment on planar arms", IN_PLANE, "rotor_moment = fold(with_rotor_moment, rotor_moment, acts.listed, ())", "pass", LOAD),
    Mutation("listed rotors, no moment on joints", ON_JOINTS, "rotor_moment = fold(with_rotor_moment, rotor_moment, acts.listed, ())", "pass", LOAD),
    Mutation("listed rotors, no work of the push", PLACED, "power + listed.push @ velocity", "power", LOAD),
    Mutation("listed rotors, locked arms without moment", LOCKED, "whole.push, whole.moment", "whole.push, 0.0 * whole.moment", LOAD),
    Mutation("listed rotors, reach is short", SETTINGS, "away = away + hypot(*end)", "away = away + 0.5 * hypot(*end)", LOAD),
    Mutation("listed rotors, effect of drag on pilots", MIXING, "wrench.moment.y, wrench.moment.z", "wrench.moment.y, 0.0", GIVEN),
    Mutation("listed rotors, pilots use pushers", MIXING, "u = rotor.lifts", "u = 1.0", GIVEN),
    Mutation("listed rotors, tilt costs no thrust", "vehicle/parameters.py", "one.direction().z for one", "1.0 for one", GIVEN),
    Mutation("listed rotor, upside-down disc", SETTINGS, "Vec(x, -y, z),", "Vec(x, y, z),", LOAD),
    Mutation("listed rotor, disc does not tilt", CLEARANCE, "pose.mount.aim @ rotor.axes", "pose.mount.aim", GIVEN),
    Mutation("listed rotor, guards of others", PLACED, "select(here.number == wanted, here.guard", "select(here.number != wanted, here.guard", GIVEN),
    # above surfaces
    Mutation("ground effect, twice the distance", EFFECT, "(4.0 * larger(", "(8.0 * larger(", ABOVE),
    Mutation("ground effect, no cap", EFFECT, "larger(height, effect.least_height)", "height", ABOVE),
    Mutation("ground effect, of ceilings", EFFECT, "-(near.inward @ up)", "near.inward @ up", ABOVE),
    Mutation("ground effect, less thrust", EFFECT, "thrust / (1.0 - fold", "thrust / (1.0 + fold", ABOVE),
)  # fmt: skip
