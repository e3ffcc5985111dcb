"""Mutations of arms on two joints."""

from __future__ import annotations

from oracles.mutated_lines import Mutation

#: Beside the Lagrangian and by what is conserved; bounds of steps; rotors; a second vehicle.
BESIDE = ("dynamics/test_bent_arms.py", "lagrangian and apart")
POWER = ("dynamics/test_bent_arms.py", "power")
CLOUD = ("dynamics/test_bent_arms.py", "cloud or locking or locked")
BOUNDS = ("dynamics/test_bent_arms.py", "bounds or one_body")
LISTED = ("dynamics/test_bent_arms.py", "listed or power")
PARTS = ("dynamics/test_bent_arms.py", "parts_move")
GIVEN = ("vehicle/test_bent_settings.py", "refused or hinges or axes_of or preload")

POSE, LIMB, ENERGY = "vehicle/arms/bent.py", "dynamics/limbs/bent.py", "dynamics/energy.py"
SETTINGS, ROTORS = "vehicle/arms/settings.py", "vehicle/placed/rotors.py"

MUTATIONS_OF_BENT_ARMS = (
    Mutation("two joints, lever of the first", POSE, "first = tangent + (about ^ out)", "first = tangent - (about ^ out)", BESIDE),
    Mutation("two joints, Coriolis between them", POSE, "(2.0 * s * u) * (about ^ second)", "(s * u) * (about ^ second)", BESIDE),
    Mutation("two joints, curvature of the second", POSE, "(u * u) * (turned @ bend)", "(u * u) * bend", BESIDE),
    Mutation("two joints, the second does not turn", POSE, "turned @ turn_about(other,", "turned @ turn_about(-other,", BESIDE),
    Mutation("two joints, their products", POSE, "-xy * scale)", "xy * scale)", BESIDE),
    Mutation("two joints, moment about the second", LIMB, "f @ acts + there.about_second @ about_end", "f @ acts - there.about_second @ about_end", BESIDE),
    Mutation("two joints, what the arm takes", LIMB, "u * (drive.first * e + drive.second * f)", "u * (drive.first * e - drive.second * f)", BESIDE),
    Mutation("two joints, coupled inertia", LIMB, "outer(end ^ g1, swing1) + outer(end ^ g2, swing2)", "outer(end ^ g1, swing1) - outer(end ^ g2, swing2)", BESIDE),
    Mutation("two joints, rotor's work on the second", LIMB, "blown @ v + there.spin @ torque", "blown @ v - there.spin @ torque", POWER),
    Mutation("two joints, loss of the second damper", LIMB, "+ arm.second.damping * rate.second * rate.second", "- arm.second.damping * rate.second * rate.second", POWER),
    Mutation("two joints, loss of the second stop", LIMB, "inner_stop.loss + outer_stop.loss", "inner_stop.loss - outer_stop.loss", POWER),
    Mutation("two joints, energy of the second stop", ENERGY, "in_end_stops(arm, length.first) + in_end_stops", "in_end_stops(arm, length.first) - in_end_stops", POWER),
    Mutation("two joints, energy of the second spring", ENERGY, "joint_spring(arm, length.first).energy + joint", "joint_spring(arm, length.first).energy - joint", POWER),
    Mutation("two joints, the second is not locked", ENERGY, "Bend(bend.way, 0.0)", "Bend(bend.way, bend.rate)", CLOUD),
    Mutation("two joints, bound of contacts", LIMB, "own + 2.0 * inverse.xy * first * second", "own - 2.0 * inverse.xy * first * second", BOUNDS),
    Mutation("two joints, end as one body", LIMB, "second.first * there.about_first + second.second", "second.first * there.about_first - second.second", BOUNDS),
    Mutation("two joints, pull of a listed rotor", ROTORS, "along * way.pull + second * way.own_pull", "along * way.pull - second * way.own_pull", LISTED),
    Mutation("two joints, work of a listed rotor", ROTORS, "so_far + way.rate * _along_second", "so_far - way.rate * _along_second", LISTED),
    Mutation("two joints, spin changes its axis", "simulation/pair/parts.py", "(speed.first * speed.second) * (there.about_first", "(-speed.first * speed.second) * (there.about_first", PARTS),
    Mutation("two joints, travel of the second", SETTINGS, "shortest=-high, longest=-low,", "shortest=low, longest=high,", GIVEN),
    Mutation("two joints, any angle between them", SETTINGS, "share < LEAST_INDEPENDENCE", "share < 0.0", GIVEN),
)  # fmt: skip
