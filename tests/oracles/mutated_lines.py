"""Lines of the physics with one sign flipped, and the tests that should notice each.

`oracles.mutations` makes them in a copy of the package, one at a time, and runs those tests.
"""

from __future__ import annotations

from typing import NamedTuple

#: Tests of single states: files and folders below tests, and which of their tests.
QUICK = ("dynamics", "accelerations or locked_arms or textbook or power or gap or locking")
#: Of the hull, with two flights; of rings and shapes; of what bounds steps; of one instant's rules; of
#: peaks.
HULL = ("contact/test_hull.py dynamics/test_clearance.py dynamics/test_rigid.py", "not abreast")
RINGS = ("contact/test_rings.py contact/test_cages.py", "not flight")
SCENE = ("contact/test_solids.py contact/test_scene.py", "")
CHARACTER = ("recovery/test_characterisation.py", "leaning or tangent or taken")
#: Of hulls of all kinds: distances by the routine, and two surfaces in series.
HULLS = ("contact/test_hull_distances.py", "dense_samples and (box or pole or window)")
SERIES = ("contact/test_series.py", "")
STOPPED = ("simulation/test_stops_fly.py", "xplorer-constant")
REMEMBERS = ("contact/test_hysteresis.py", "")
GRIP = ("contact/test_step_bounds.py contact/test_hull.py", "bound or truth or rate")
REST = ("simulation/test_rest.py", "coulombs or creep_however or never_pull")
RULES = ("simulation/test_observed.py", "")
PEAK = ("simulation/test_peaks.py simulation/test_observed.py", "")
#: Of impulses: one at a time, and of every setting that asks for them.
IMPULSE = (
    "contact/test_hull.py dynamics/test_conservation.py simulation/test_combinations.py",
    "impulse_law_strikes or impulses or squarely or rests or routh or combination_flies and impulse",
)
#: Of what only a flight shows; these compile.
FLIGHT = (
    "simulation/test_steps.py contact/test_hull.py",
    "isolator or dashpot or travel or felt or stop",
)


#: Of moving obstacles, some milliseconds in plain Python.
MOVING = ("dynamics/test_moving_states.py", "")
PROPELLER = ("contact/test_propellers.py", "post or above")
#: How often a scene is looked at.
LOOKS = ("dynamics/test_clearance.py", "looked_at")
#: Arms on joints, beside other formulations and in single steps.
JOINT = ("dynamics/test_joints.py dynamics/test_joint_flights.py", "")
JOINT_STEPS = ("dynamics/test_joints_in_steps.py", "")
#: Bounds of an inertia, masses of model files, and sizes from answers.
BOUNDED = ("vehicle/test_mass_bounds.py", "")
WEIGHED = ("scenario/masses/test_models.py", "mujoco or by_hand")
WEIGHED_GEOMS = ("scenario/masses/test_geoms.py", "mujoco or by_hand")
ANSWERED = ("interfaces/cli/test_new_vehicle.py", "asked_for or read_and or pilot or bad_answer_is")
#: A shell beside two bodies and in Pinocchio, its power, and its bearings in flight.
TURNS = ("dynamics/test_shell.py", "two_bodies or power or momentum or dry")
IN_PINOCCHIO = ("dynamics/test_shell.py dynamics/test_spinning_ring.py", "pinocchio")
RINGED = ("dynamics/test_spinning_ring.py", "two_bodies or power or momentum")
#: Logs: turns of axes, clocks, impacts.
FRAMES, CLOCKS = ("logs/test_frames.py", ""), ("logs/test_clocks.py", "")
SEGMENTS = ("logs/test_segments.py", "")
#: Crossings and end stops, rule by rule.
CROSSINGS = ("dynamics/test_crossings.py", "")


class Mutation(NamedTuple):
    """One change of the source; ``old`` occurs exactly once in ``path``."""

    name: str
    path: str  # below src/springback
    old: str
    new: str
    tests: tuple[str, str] = QUICK  # folders or files below tests, and pytest's -k


CAGE, SURFACES, MOTION = "contact/cage.py", "contact/surfaces.py", "dynamics/motion.py"
ARMS, JOINED, JOINTS = (
    "dynamics/limbs/arms.py",
    "dynamics/limbs/jointed.py",
    "vehicle/arms/joints.py",
)
NEIGHBOURS, SHELL = "vehicle/arms/neighbours.py", "dynamics/limbs/shell.py"
LOADS = "contact/loads.py"
BRISTLES, MEMORY = "contact/laws/bristles.py", "contact/laws/memory.py"
REMEMBERING, CURVES = "contact/laws/hysteresis.py", "vehicle/force_curves.py"
STATE, ENERGY, VECTORS = "vehicle/state.py", "dynamics/energy.py", "kernels/vectors.py"
OBSTACLES, STOPS, SOLUTION = "contact/obstacles.py", "dynamics/stops.py", "dynamics/solution.py"
ROUNDED_HULLS, HULL_EDGES, SERIES_LAW = (
    "contact/hulls/rounded.py",
    "contact/hulls/edges.py",
    "contact/hulls/series.py",
)
HULL_CONTACT, HULL_STATE, TOUCHES = (
    "contact/hull_contact.py",
    "dynamics/hull_state.py",
    "dynamics/touches.py",
)
RECORD, IMPULSES, GRIPS = (
    "simulation/measuring/record.py",
    "dynamics/impulse.py",
    "contact/laws/step_bounds.py",
)
CLEARANCE, CROSSING = "dynamics/clearance.py", "dynamics/crossing.py"
PEAKS, RING = "simulation/measuring/peaks.py", "contact/rings.py"
ACTION, CHARACTERISATION = "recovery/line_of_action.py", "recovery/characterisation.py"
BODIES, MOVERS = "contact/moving/bodies.py", "dynamics/moving_obstacles.py"
SOLIDS, NEAREST, FACES = (
    "contact/scene/solids.py",
    "contact/scene/nearest.py",
    "contact/scene/faces.py",
)
WORLD_POSES, WORLD_CONTENT = "scenario/worlds/poses.py", "scenario/worlds/content.py"
SDF, MJCF, OCTOMAP = (f"scenario/worlds/{name}.py" for name in ("sdf", "mjcf", "octomap"))
IMPORTED = "scenario/worlds/imported.py"
#: Of imported worlds: by SciPy, by MuJoCo, by cells, and as a whole.
BY_SCIPY, BY_MUJOCO = ("scenario/worlds/test_sdf.py", ""), ("scenario/worlds/test_mjcf.py", "")
BY_CELLS = ("scenario/worlds/test_grids_and_blocks.py", "")
AS_A_WHOLE = ("scenario/worlds/test_imported.py", "placed_and_turned")

MASS_BOUNDS, MODELS = "vehicle/mass/bounds.py", "scenario/masses/models.py"
MODEL_FORMATS, MODEL_LINKS = "scenario/masses/formats.py", "scenario/masses/links.py"
MODEL_GEOMS, MODEL_SOLIDS = "scenario/masses/mjcf.py", "scenario/masses/solids.py"
NEW_SIZES = "interfaces/cli/design/sizes.py"

MUTATED_LINES = (
    # rotors that stop
    # contact
    Mutation("contact damping, sign as printed", SURFACES, "elastic + (d * elastic", "elastic + (-d * elastic"),
    Mutation("contact loss, sign", SURFACES, "(force - elastic) * rate", "(elastic - force) * rate"),
    Mutation("contact force may pull", SURFACES, "positive_part(elastic + (d", "(elastic + (d"),
    Mutation("contact exponent 3/2 to 2", SURFACES, "depth * math.sqrt(depth)", "depth * depth"),
    Mutation("normal force pulls in", LOADS, "n * (-f_n)", "n * f_n"),
    Mutation("normal points out", CAGE, "n = -outward_normal(", "n = outward_normal("),
    Mutation("plane seen, offset", OBSTACLES, "plane.offset - plane.normal", "plane.offset + plane.normal"),
    Mutation("plane seen, turned the wrong way", OBSTACLES, "Plane(plane.normal @ r,", "Plane(r @ plane.normal,"),
    Mutation("penetration rate, sign", LOADS, "(omega ^ pressing)) @ n", "(omega ^ pressing)) @ (-n)"),
    Mutation("penetration rate, no turning", LOADS, "(sliding + (omega ^ pressing)) @ n", "sliding @ n"),
    Mutation("friction drives the slip", SURFACES, "Friction(slip * -grip", "Friction(slip * grip"),
    Mutation("friction loss, sign", SURFACES, "grip * square, grip, per_speed", "-grip * square, grip, per_speed"),
    Mutation("slip without turning", LOADS, "sliding + (omega ^ rubbing_at), n", "sliding, n"),
    Mutation("slip keeps its normal part", SURFACES, "velocity - (velocity @ normal) * normal", "velocity * 1.0"),
    # laws that remember
    Mutation("what comes out, its integral", REMEMBERING, "share * w / (1.0 + law.shape)", "share * w", REMEMBERS),
    Mutation("all is returned", REMEMBERING, "return 1.0 / (1.0 + law.shape)", "return 1.0", REMEMBERS),
    Mutation("coming deeper costs what is returned", REMEMBERING, "renewed * (1.0 - _returned", "renewed * (_returned", REMEMBERS),
    Mutation("coming deeper heats, sign", MEMORY, "so_far + point.lost", "so_far - point.lost", STOPPED),
    Mutation("steps do not know what comes out", REMEMBERING, "_steepest_share(law) * there.force", "0.0 * there.force", REMEMBERS),
    Mutation("the deepest contact, not the nearest", REMEMBERING, "(square < best.square)", "(point.depth > best.depth)", REMEMBERS),
    Mutation("normals do not tell contacts apart", REMEMBERING, "NEAR, ALIGNED = 0.01, 0.7", "NEAR, ALIGNED = 0.01, -1.0", REMEMBERS),
    Mutation("everything stays pressed", REMEMBERING, "memory.crushed if law.stays > 0.0 else 0.0", "memory.crushed", REMEMBERS),
    Mutation("a curve's energy", CURVES, "t * d / 4.0", "t * d / 3.0", REMEMBERS),
    Mutation("what was measured coming out", CURVES, "w[1:] * energy[-1]", "w[1:] ** 2 * energy[-1]", REMEMBERS),
    Mutation("two memories in series, mixed up", SERIES_LAW, "share / (1.0 + ours.shape) + (1.0 - share)", "(1.0 - share) / (1.0 + ours.shape) + share", REMEMBERS),
    Mutation("soft springs without a bound", SURFACES, "TOE = 1e-4", "TOE = 1e-7", REMEMBERS),
    Mutation("bristles pull along", BRISTLES, "BristleLoad(u * -share", "BristleLoad(u * share", REST),
    Mutation("bristles unbounded", BRISTLES, "share = 1.0 / larger(size, 1.0)", "share = 1.0", REST),
    Mutation("bristles creep", BRISTLES, "ELASTIC_SHARE = 0.7", "ELASTIC_SHARE = 0.0", REST),
    Mutation("bristles do not let go", BRISTLES, "slides * speed * per_most", "0.0 * speed * per_most", REST),
    Mutation("vertical friction, tilt", SURFACES, "vertical - (vertical @ normal) * normal", "vertical * 1.0"),
    Mutation("contact moment, sign", LOADS, "moment = (rubbing_at ^ force)", "moment = (force ^ rubbing_at)"),
    Mutation(
        "normal moment about the friction point, sign",
        LOADS,
        "((at.normal_lever - at.friction_lever) ^ push)",
        "(push ^ (at.normal_lever - at.friction_lever))",
    ),
    Mutation("ring inset, sign", CAGE, "-eps * eps * inverse * radius", "eps * eps * inverse * radius"),
    Mutation("ring radius ignores the tilt", CAGE, "t @ t + eps * eps", "1.0 + 0.0 * (t @ t) + eps * eps"),
    Mutation("arm tip, friction at the tip", CAGE, "lever, lever * 0.0, 0.0)", "lever, lever, 0.0)"),
    # arms
    Mutation("spring, sign", ARMS, "stiffness * (arm.length - length)", "stiffness * (length - arm.length)"),
    Mutation("joints, Coriolis force", JOINED, "2.0 * (omega ^ moving)", "-2.0 * (omega ^ moving)", JOINT),
    Mutation("joints, bend of the path", JOINED, "(rate * rate) * there.bend", "0.0 * there.bend", JOINT),
    Mutation("joints, moment about the hinge", JOINED, "+ k * (there.axis @ about_end)", "- k * (there.axis @ about_end)", JOINT),
    Mutation("joints, turning of the body", JOINED, "(there.end ^ e) @ alpha", "(e ^ there.end) @ alpha", JOINT),
    Mutation("joints, moment that an arm takes", JOINED, "- a.taken_moment", "+ a.taken_moment", JOINT),
    Mutation("joints, power of rotors", JOINED, "+ a.power_on_arm", "- a.power_on_arm", JOINT),
    Mutation("joints, energy of a preload", JOINTS, "+ spring.preload * x", "- spring.preload * x", JOINT),
    Mutation("latch, pulls", JOINTS, "(16.0 * latch.force)", "(-16.0 * latch.force)", JOINT),
    Mutation("latch, energy", JOINTS, "so_far.energy + held.energy", "so_far.energy", JOINT),
    Mutation("neighbours, push", NEIGHBOURS, "ahead.pull - behind.pull", "behind.pull - ahead.pull", JOINT),
    Mutation("neighbours, one side only", NEIGHBOURS, "ahead.pull - behind.pull", "ahead.pull", JOINT),
    Mutation("neighbours, damper drives", NEIGHBOURS, "damped = spring.damping", "damped = -spring.damping", JOINT),
    Mutation("neighbours, loss unbooked", MOTION, "a.arm_loss + between.loss", "a.arm_loss", JOINT),
    Mutation("neighbours, energy unbooked", ENERGY, "springs = a.springs + neighbour_energy(", "springs = a.springs + 0.0 * neighbour_energy(", JOINT),
    Mutation("joints, velocity of what turns", HULL_CONTACT, "rate * there.direction - (spin ^", "rate * there.direction + (spin ^", JOINT),
    Mutation("joints, friction across the path", JOINED, "across = moves @ moves - squared", "across = 0.0 * squared", JOINT_STEPS),
    Mutation("damper, sign as printed", ARMS, "- arm.damping * rate\n", "+ arm.damping * rate\n"),
    Mutation("damper loss, sign", ARMS, "u * (arm.damping * rate", "-u * (arm.damping * rate"),
    Mutation("end stop, side", STOPS, "within - length  #", "length - within  #"),
    Mutation("end stop, only the inner", STOPS, "larger(arm.shortest, smaller(length, longest))", "larger(arm.shortest, length)"),
    Mutation("end stop, rate of the inner", STOPS, "= -rate if shift", "= rate if shift"),
    Mutation("end stop, damping", STOPS, "stop_dissipation * pressing", "stop_dissipation * -pressing"),
    Mutation("end stop loss, sign", STOPS, "(elastic - force) * rate", "(force - elastic) * rate"),
    Mutation("arm velocity, l̇ sign", STATE, "velocity + rate * e", "velocity - rate * e"),
    Mutation("arm does not feel the contact", ARMS, "e @ touch.force + outward", "outward"),
    Mutation("arm acceleration, coupling", ARMS, "drive - known.pull.hold", "drive + known.pull.hold"),
    # inertial terms
    Mutation("centrifugal force along the arm", ARMS, "+ outward + own", "- outward + own"),
    Mutation("centrifugal, ω_z only", ARMS, "across * across + omega.z", "omega.z"),
    Mutation("centrifugal, component across", ARMS, "e.x * omega.y - e.y * omega.x", "e.x * omega.y + e.y * omega.x"),
    Mutation("ω × (ω × s), sign", ARMS, "(omega ^ (turning + a.drift + a.drift))", "(omega ^ (a.drift + a.drift - turning))"),
    Mutation("Coriolis force, sign", ARMS, "(omega ^ (turning + a.drift + a.drift))", "(omega ^ (turning - a.drift - a.drift))"),
    Mutation("Coriolis force, half", ARMS, "(omega ^ (turning + a.drift + a.drift))", "(omega ^ (turning + a.drift))"),
    Mutation("J̇ ω, sign", ARMS, "(omega ^ (inertia @ omega)) +", "(omega ^ (inertia @ omega)) -"),
    Mutation("J̇, half", ARMS, "arms_inertia(a.half_inertia_rate + a.half_inertia_rate)", "arms_inertia(a.half_inertia_rate)"),
    Mutation("gyroscopic moment, sign", ARMS, "spin_rate = (omega ^ (inertia @ omega))", "spin_rate = ((inertia @ omega) ^ omega)"),
    Mutation("arms' inertia, product", STATE, "Vec(second.y, -second.z, 0.0)", "Vec(second.y, second.z, 0.0)"),
    # rotors
    Mutation("thrust moment, roll", ARMS, "Vec(lever.y, -lever.x, arm", "Vec(-lever.y, -lever.x, arm"),
    Mutation("thrust moment, pitch", ARMS, "Vec(lever.y, -lever.x, arm", "Vec(lever.y, lever.x, arm"),
    Mutation("rotor torque, sign", ARMS, "-lever.x, arm.torque_ratio)", "-lever.x, -arm.torque_ratio)"),
    Mutation("thrust power, turning", ARMS, "velocity.z + rotor_moment", "velocity.z - rotor_moment"),
    # solution of the six equations
    Mutation("what the arm keeps, sign", ARMS, "- a.taken", "+ a.taken"),
    Mutation("M⁻¹, off-diagonal", STATE, "-xy * scale", "xy * scale"),
    Mutation("M⁻¹, arms locked or not", ARMS, "released > 0.0, airframe", "released < 1.0, airframe"),
    Mutation("Schur complement, jxx", SOLUTION, "j.x.x - n.zz", "j.x.x + n.zz"),
    Mutation("Schur complement, jyy", SOLUTION, "j.y.y - n.zz", "j.y.y + n.zz"),
    Mutation("Schur complement, jxy", SOLUTION, "j.x.y + n.zz", "j.x.y - n.zz"),
    Mutation("Schur complement, jzz", SOLUTION, "j.z.z - (n.xx", "j.z.z + (n.xx"),
    Mutation("Schur complement, jzz cross term", SOLUTION, "- 2.0 * n.xy", "+ 2.0 * n.xy"),
    Mutation("coupling s × a", SOLUTION, "system.moment - (s ^ alone)", "system.moment + (s ^ alone)"),
    Mutation("coupling α × s", SOLUTION, "alone - times(n, alpha ^ s)", "alone + times(n, alpha ^ s)"),
    Mutation("slider, weight", SOLUTION, "force - mu @ weight", "force + mu @ weight"),
    Mutation("slider, mass off-diagonal", SOLUTION, "u.x - slide.z * u.y", "u.x + slide.z * u.y"),
    Mutation("weight, sign", MOTION, "r @ solved.linear - Vec", "r @ solved.linear + Vec"),
    Mutation("solve, one cofactor", VECTORS, "q * r - p * f, p * r - q * d", "q * r + p * f, p * r - q * d"),
    # kinematics, energy, locking
    Mutation("quaternion rate, one term", VECTORS, "q.y * z - q.z * y", "q.y * z + q.z * y"),
    Mutation("rotation matrix, one term", VECTORS, "xy - wz", "xy + wz"),
    Mutation("spring energy, half", ENERGY, "return 0.5 * arm.compliance * arm.stiffness", "return 0.25 * arm.compliance * arm.stiffness"),
    Mutation("contact energy exponent", SURFACES, "depth) * depth / (n + 1.0)", "depth) * depth / (n + 2.0)"),
    Mutation("Steiner, product", ENERGY, "mass * c.x * c.y, mass * c.x * c.z", "-mass * c.x * c.y, mass * c.x * c.z"),
    Mutation("locking, velocity", ENERGY, "velocity - r @ (new_omega", "velocity + r @ (new_omega"),
    Mutation("angular momentum, drift", ENERGY, "((omega ^ centre) + drift)))", "((omega ^ centre) - drift)))"),
    # the hull
    Mutation("hull, gap without its radius", CAGE, "signed_distance(shape, arm.lever) - radius", "signed_distance(shape, arm.lever)", HULL),
    Mutation("hull, gap with its radius added", CAGE, "arm.lever) - radius", "arm.lever) + radius", HULL),
    Mutation("hull, touches on the far side", CAGE, "lever = radius * inward", "lever = -radius * inward", HULL),
    Mutation("hull, rubs at its centre", CAGE, "    return Support(lever, lever, lever, 0.0)", "    return Support(lever, lever, lever * 0.0, 0.0)", HULL),
    Mutation("hull, normal out", CAGE, "inward = -outward", "inward = outward", HULL),
    Mutation("hull, about the main body", HULL_CONTACT, "Vec(0.0, 0.0, 0.0), hull.centre, velocity", "Vec(0.0, 0.0, 0.0), hull.centre * 0.0, velocity", HULL),
    Mutation("hull, touches a shape twice", CAGE, "simple_face(FAR, inward", "simple_face(gap, inward", HULL),
    Mutation("hull, its force left out", MOTION, "fold(_together, a.contact, field_of(hull, \"contact\"), ())", "a.contact", HULL),
    Mutation("hull, its energy left out", ENERGY, "tree_sum((tree_sum(at_arms),) + at_hull)", "tree_sum(at_arms)", HULL),
    Mutation("hull, its energy, sign", ENERGY, "return tree_sum(tree_map(_contact_energy", "return -tree_sum(tree_map(_contact_energy", HULL),
    Mutation("hull, not in the clearance", CLEARANCE, "cages + tree_map(hull_gap, (airframe.hull,), (around.obstacles,))", "cages", HULL),
    Mutation("hull, friction unbounded", HULL_STATE, "alone = rate + hull.damper", "alone = rate + 0.0 * hull.damper", GRIP),
    Mutation("shell, bearing drives", SHELL, "(turned - bearing)", "(turned + bearing)", TURNS),
    Mutation("shell, dry bearing drives", SHELL, "(hull.damping + dry)", "(hull.damping - dry)", IN_PINOCCHIO),
    Mutation("shell, nothing on the body", SHELL, "(about_centre - turned) + bearing", "(about_centre - turned)", TURNS),
    Mutation("shell, moment of its centre", SHELL, "hull.centre ^ contact.force", "contact.force ^ hull.centre", TURNS),
    Mutation("shell, turns with the body", SHELL, "((body.omega - spin) ^ hull.centre)", "((spin - body.omega) ^ hull.centre)", TURNS),
    Mutation("shell, without its stages", SHELL, "    return 1.0", "    return 0.0", TURNS),
    Mutation("ring, gyroscope, sign", SHELL, "moment - (omega ^ _along", "moment + (omega ^ _along", RINGED),
    Mutation("ring, turns the other way", SHELL, "((turned - other) @ axis)", "((other - turned) @ axis)", RINGED),
    Mutation("ring, its axis stands still", SHELL, "rate + (omega ^ _along(spin, axis))", "rate + 0.0 * spin", RINGED),
    Mutation("ring, held and free", STATE, "inertia - about_axis", "inertia + about_axis", RINGED),
    Mutation("shell, energy unbooked", ENERGY, "0.5 * shell.inertia * (spin @ spin)", "0.4 * shell.inertia * (spin @ spin)", TURNS),
    Mutation("hull, friction bound without turning", HULL_STATE, "hull.farthest * inverse.largest", "0.0 * hull.farthest", GRIP),
    Mutation("hull, no slip rate", MOTION, "cage_slips + hull_slips", "cage_slips", GRIP),
    Mutation("hull, contact rate of cages only", MOTION, "        contact.press, field_of", "        a.contact.press, field_of", GRIP),
    Mutation("hull, gaps left out of steps", RECORD, "field_of(view.arms, \"gap\") + field_of(view.hull, \"gap\") + discs", "field_of(view.arms, \"gap\") + discs", RULES),
    Mutation("hull, crossings left out of steps", RECORD, "field_of(view.arms, \"crossing\") + field_of(view.hull, \"crossing\")", "field_of(view.arms, \"crossing\")", RULES),
    Mutation("hull, touch is no touch", RECORD, "maximum(arm_touching + hull_touching)", "maximum(arm_touching)", RULES),
    Mutation("hull, its normal left out", MOTION, "field_of(arms, \"touched\") + field_of(hull, \"touched\")", "field_of(arms, \"touched\")", RULES),
    Mutation("hull, no impulse", RECORD, "maximum(field_of(view.arms, \"impulsive\") + field_of(view.hull, \"impulsive\"))", "maximum(field_of(view.arms, \"impulsive\"))", RULES),
    Mutation("hull, its contacts uncounted", RECORD, "(before.hull, at.hull,", "(before.hull, before.hull,", RULES),
    Mutation("hull, not struck", IMPULSES, "of_cages + tree_map(_hits_of_hull, (airframe.hull,), (around.obstacles, body))", "of_cages", IMPULSE),
    # hulls of all kinds
    Mutation("hulls, rounding on the far side", ROUNDED_HULLS, "lever = low.point + radius * inward", "lever = low.point - radius * inward", HULLS),
    Mutation("hulls, without their radius", ROUNDED_HULLS, "NearestFace(low.gap - radius, inward, at", "NearestFace(low.gap, inward, at", HULLS),
    Mutation("hulls, a deeper edge is less deep", ROUNDED_HULLS, "gap = given - (root - SHARED)", "gap = given + (root - SHARED)", HULLS),
    Mutation("hulls, slope along an edge, sign", HULL_EDGES, "slope = near_face(shape, a + share * along).normal @ along", "slope = -(near_face(shape, a + share * along).normal @ along)", HULLS),
    Mutation("hulls, in parallel", SERIES_LAW, "_Springs(_stiffness(both, n), d", "_Springs(k + law.compliance ** (-n), d", SERIES),
    Mutation("hulls, dampers share alike", SERIES_LAW, "d = here * here * d + there * there * law.dissipation", "d = here * d + there * law.dissipation", SERIES),
    # contact on or off
    Mutation("contact on within a step", LOADS, "touches & (engaged > 0.0)", "touches", FLIGHT),
    Mutation("contact never on", LOADS, "touches & (engaged > 0.0)", "touches & (engaged > 2.0)", QUICK),
    Mutation("law not felt at the touch", LOADS, "(gap < -AT_TOUCH) | ((gap <= LANDED) & (rate > 0.0))", "gap < -AT_TOUCH", FLIGHT),
    Mutation("crossing, sign of the rate", CROSSING, "value * rate < 0.0", "value * rate > 0.0", CROSSINGS),
    Mutation("crossing, the later one", CROSSING, "a.distance * b.speed < b.distance", "a.distance * b.speed > b.distance", RULES),
    Mutation("crossing, speed over distance", CROSSING, "c.distance / c.speed", "c.speed / c.distance", RULES),
    Mutation("the other stop is next", STOPS, "growing if rate > 0.0 else shrinking", "shrinking if rate > 0.0 else growing", CROSSINGS),
    Mutation("leaving at once", TOUCHES, "(met.gap < -LANDED) & (met.impulsive == 0.0)", "(met.gap < -LANDED) & (met.rate < 0.0)", FLIGHT),
    Mutation("impulse where it leaves", TOUCHES, "closing = (met.gap <= LANDED) & (met.rate < 0.0)", "closing = (met.gap <= LANDED) & (met.rate > 0.0)", IMPULSE),
    # steps
    Mutation("stops are no contact", RECORD, "larger(hits, maximum(field_of(view.arms, \"stopped\")))", "hits", RULES),
    Mutation("settling steps in contact", RECORD, "select(pressed, timing.impact_step, timing.settle_step)", "select(pressed, timing.settle_step, timing.impact_step)", RULES),
    Mutation("crossings from afar met at once", RECORD, "time_to_crossing - 0.5 * timing.impact_step,", "time_to_crossing,", RULES),
    Mutation("crossings passed", RECORD, "step = smaller(step, larger(time_to_crossing, SHORTEST", "step = larger(step, larger(time_to_crossing, SHORTEST", RULES),
    Mutation("friction leaves steps alone", GRIPS, "larger(stiff, friction_rate * PER_FRICTION_SHARE)", "stiff", RULES),
    Mutation("contact leaves steps alone", GRIPS, "larger(contact_rate * PER_CONTACT_SHARE, slip_rate * PER_SLIP_SHARE)", "slip_rate * PER_SLIP_SHARE", RULES),
    Mutation("slips leave steps alone", GRIPS, "larger(contact_rate * PER_CONTACT_SHARE, slip_rate * PER_SLIP_SHARE)", "contact_rate * PER_CONTACT_SHARE", RULES),
    Mutation("steps pass what is near", RECORD, "smaller(step, larger(near * (stiff", "larger(step, larger(near * (stiff", RULES),
    Mutation("haste without arms", STATE, "fastest + maximum(tree_map(fastest_of_arm, (airframe.arms, arm_rates), ()))", "fastest", RULES),
    Mutation("haste without turning", STATE, "norm(velocity) + reach(airframe) * norm(angular_velocity)", "norm(velocity)", RULES),
    Mutation("steps pass the end", RECORD, "smaller(step, left)", "step", RULES),
    Mutation("impulse again and again", RECORD, " & (now.request != APPLY_IMPULSE)", "", RULES),
    # when an impact is over, and its measures
    Mutation("impact never settles", RECORD, "select(unsettled > 0.0, now.phase, FREE_FLIGHT)", "now.phase", RULES),
    Mutation("arms settle while away", RECORD, "arm.compliance if away | moving", "arm.compliance if moving", RULES),
    Mutation("arms settle while moving", RECORD, "arm.compliance if away | moving", "arm.compliance if away", RULES),
    Mutation("settled at the free length only", RECORD, "abs(view.unbalance) >", "abs(view.compression) >", RULES),
    Mutation("dwell begins at the first touch", RECORD, "now.time - last_touch > timing.dwell", "now.time - m.first_impact.touch_time > timing.dwell", RULES),
    Mutation("travel goes on", RECORD, "of_first & ((at.touching > 0.0) | at.ended)", "of_first", RULES),
    Mutation("travel stops before the last instant", RECORD, "(at.touching > 0.0) | at.ended", "at.touching > 0.0", RULES),
    Mutation("first-impact peaks of all impacts", RECORD, "within = (at.impacts == 1.0) & (at.phase == IMPACT)", "within = at.phase == IMPACT", RULES),
    Mutation("first-impact peaks of contact only", RECORD, "within = (at.impacts == 1.0) & (at.phase == IMPACT)", "within = (at.impacts == 1.0) & (at.touching > 0.0)", RULES),
    Mutation("separation of any impact", RECORD, "leaves = at.ended & of_first", "leaves = at.ended", RULES),
    Mutation("return while going in", RECORD, "(depth - touch_depth <= LANDED) & (speed < 0.0)", "(depth - touch_depth <= LANDED) & (speed > 0.0)", RULES),
    Mutation("return not landed on", RECORD, "select(ahead, speed, 0.0))", "0.0)", RULES),
    # peaks between instants
    Mutation("peak, slope at the wrong end", PEAKS, "rise * (t.after * t.after) + fall * (t.before * t.before)", "rise * (t.before * t.before) + fall * (t.after * t.after)", PEAK),
    Mutation("peak, below the largest sample", PEAKS, "second - 0.5 * slope * half", "second + 0.5 * slope * half", PEAK),
    Mutation("peak, time mirrored", PEAKS, "-half * t.volume - t.after", "half * t.volume - t.after", PEAK),
    Mutation("peak, across a jump", PEAKS, "usable = smooth & (recent.step > ALIKE * step)", "usable = (recent.step > ALIKE * step)", PEAK),
    Mutation("peak, across a short step", PEAKS, "& (recent.step > ALIKE * step) & (step > ALIKE * recent.step)", "& (recent.step > 0.0)", PEAK),
    Mutation("peak, across a touch", RECORD, "smooth = (now.step > 0.0) & (not jumped)", "smooth = now.step > 0.0", PEAK),
    Mutation("peak, of stale instants", RECORD, "Recent(select(smooth, now.step, 0.0), m.recent.latest, sample)", "Recent(select(smooth, now.step, 0.0), sample, m.recent.latest)", PEAK),
    # stops, as steps see them
    Mutation("stop ahead unseen", STOPS, "(shift != 0.0) | soon", "shift != 0.0", CROSSINGS),
    Mutation("stop's damper, sign", STOPS, "damper = arm.stop_dissipation * arm", "damper = -arm.stop_dissipation * arm", CROSSINGS),
    # bounds of friction
    Mutation("grip, about z", GRIPS, "g * (pn * pn + out * square)", "g * (out * square)", GRIP),
    Mutation("grip, about x", GRIPS, "upright * point.y * point.y", "upright * point.x * point.x", GRIP),
    Mutation("grip, coupling left out", GRIPS, "math.sqrt(half * half + lean_part * across)", "math.sqrt(half * half)", GRIP),
    # rings against shapes
    Mutation("ring, slope of the other sign", RING, "n.y * towards.x - n.x * towards.y", "n.x * towards.y - n.y * towards.x", RINGS),
    Mutation("ring, search away from the minimum", RING, "if slope < 0.0:", "if slope > 0.0:", RINGS),
    Mutation("ring, second point is the first", CAGE, "at_second_point(radius, found)", "at_low_point(radius, found.first)", RINGS),
    Mutation("ring, edge counts in full", LOADS, "rate = steepness * (", "rate = 1.0 * (", RINGS),
    Mutation("ring, force of an edge in full", LOADS, "f_n = pressed.force * steepness", "f_n = pressed.force", RINGS),
    Mutation("ring, saddle's rate, sign", LOADS, "rate -= (sliding", "rate += (sliding", RINGS),
    Mutation("ring, saddle without reaction", LOADS, "back = at_saddle * pressed.force", "back = at_saddle * 0.0", RINGS),
    Mutation("ring, second as deep as it is", CAGE, "face.gap - saddle.gap", "face.gap", RINGS),
    Mutation("ring, the higher way", RING, "one if one.gap < other.gap else other", "other if one.gap < other.gap else one", RINGS),
    Mutation("ring, normals of an edge changed over", RING, "before * n_low + after * n_high", "after * n_low + before * n_high", RINGS),
    # solids
    Mutation("box, face outside", SOLIDS, "sx * out.x * inverse", "-sx * out.x * inverse", SCENE),
    Mutation("frustum, leans the other way", SOLIDS, "nx, nz = dz * inverse, -dx * inverse", "nx, nz = dz * inverse, dx * inverse", SCENE),
    Mutation("window, filled", SOLIDS, "return outline if outline.gap > inside.gap else inside", "return outline", SCENE),
    Mutation("doorway, foot of a jamb leans away", SOLIDS, "a * outline.x + b * inside.x", "a * outline.x - b * inside.x", SCENE),
    Mutation("edges not rounded", SOLIDS, "found.gap - s.rounding", "found.gap", SCENE),
    Mutation("axes of a solid, transposed", SOLIDS, "ex * n.x + ey * n.y + ez * n.z", "Vec(ex @ n, ey @ n, ez @ n)", SCENE),
    Mutation("tree, far half left out", NEAREST, "elif previous != far and", "elif previous == far and", SCENE),
    Mutation("tree, boxes too near", NEAREST, "square < gap * gap", "square < 0.5 * gap * gap", SCENE),
    Mutation("scene, ring sees half", FACES, "nearest, 2.0 * part.radius", "nearest, 0.0", SCENE),
    Mutation("scene, inner corner is one face", FACES, "if low.second.gap < FAR:", "if low.second.gap < -FAR:", SCENE),
    Mutation("scene, flush solids touch twice", FACES, "apart @ apart > APART * APART", "apart @ apart >= 0.0", SCENE),
    Mutation("scene, clearance overstated", FACES, "within = part.radius + known", "within = known - part.radius", SCENE),
    # what a robot makes of a collision
    Mutation("normal leans the other way", ACTION, "Vec(t.x * along, t.y * along, force.z)", "Vec(t.x * along, t.y * along, -force.z)", CHARACTER),
    Mutation("a pole has a common tangent", CHARACTERISATION, "tangent_normal(line.span, ahead), ahead)", "tangent_normal(line.span, ahead), tangent_normal(line.span, ahead))", CHARACTER),
    # moving obstacles
    Mutation("mover, closer pushes", BODIES, "-body.closer * away - body.damping", "body.closer * away - body.damping", MOVING),
    Mutation("mover, closer's damper drives", BODIES, "away - body.damping * turning", "away + body.damping * turning", MOVING),
    Mutation("mover, pendulum falls up", MOVERS, "Vec(0.0, 0.0, -gravity * body.mass)", "Vec(0.0, 0.0, gravity * body.mass)", MOVING),
    Mutation("mover, reaction pulls", MOVERS, "-(at.r @ reaction.force), -(at.r", "at.r @ reaction.force, -(at.r", MOVING),
    Mutation("mover, reaction's moment, sign", MOVERS, "-(at.r @ reaction.moment)", "at.r @ reaction.moment", MOVING),
    Mutation("mover, reaction without lever", MOVERS, "((at.position - pose.position) ^ force)", "(0.0 * at.position ^ force)", MOVING),
    Mutation("mover, driven work, sign", MOVERS, "given = reaction.force @ motion.velocity", "given = -reaction.force @ motion.velocity", MOVING),
    Mutation("mover, surface at rest", LOADS, "return velocity - moving.velocity", "return velocity - 0.0 * moving.velocity", MOVING),
    Mutation("mover, surface does not turn", LOADS, "return omega - moving.spin", "return omega - 0.0 * moving.spin", MOVING),
    # impulses
    Mutation("impulse, pulls", IMPULSES, "impulse = n * part[k] + rub[k]", "impulse = -n * part[k] + rub[k]", IMPULSE),
    Mutation("impulse, friction drives", IMPULSES, "t * -(limit if", "t * (limit if", IMPULSE),
    Mutation("impulse, turns the other way", IMPULSES, "(1.0 / mass), turn)", "(1.0 / mass), -turn)", IMPULSE),
    Mutation("impulse, gives e of the work back", IMPULSES, "e * e * taken[k]", "e * taken[k]", IMPULSE),
    Mutation("impulse, friction unbounded", IMPULSES, "limit if speed > limit * yields else speed / yields", "speed / yields", IMPULSE),
    Mutation("impulse, its loss unbooked", IMPULSES, "work.contact + lost - rubbed_off", "work.contact", IMPULSE),
    Mutation("impulse, friction's share, sign", IMPULSES, "rubbed_off -= share", "rubbed_off += share", IMPULSE),
    Mutation("impulse, rests never", IMPULSES, "rebound[k] = hit.surface.restitution if closing > RESTING else 0.0\n                tolerated", "rebound[k] = hit.surface.restitution\n                tolerated", IMPULSE),
    Mutation("impulse, is not put back", IMPULSES, "state.position + sunk,", "state.position,", IMPULSE),
    # scenes, looked at as seldom as is safe
    Mutation("propeller, hits unnoticed", CLEARANCE, "(gap < AT_HIT)", "(gap < -1.0)", PROPELLER),
    Mutation("propeller, below the arms", CLEARANCE, "0.0, disc.height", "0.0, -disc.height", PROPELLER),
    Mutation("scene, room is not used up", CLEARANCE, "left = room - HASTE", "left = room - 0.0", LOOKS),
    Mutation("scene, half the steps ahead", CLEARANCE, "ROOMY_STEPS = 8.0", "ROOMY_STEPS = 4.0", LOOKS),
    # imported worlds
    Mutation("imported pose, order", WORLD_POSES, "self.turn @ inner.turn", "inner.turn @ self.turn", BY_SCIPY),
    Mutation("imported pose, inverse", WORLD_POSES, "-self.turn.T @ self.place", "self.turn.T @ self.place", BY_SCIPY),
    Mutation("imported pose, roll read back", WORLD_POSES, "s * r[0][2] - c * r[1][2]", "s * r[0][2] + c * r[1][2]", BY_SCIPY),
    Mutation("imported axis between two points", MJCF, "turn_to((a - b)", "turn_to((b - a)", BY_MUJOCO),
    Mutation("imported Euler angles, fixed axes", WORLD_POSES, "else turn @ found", "else found @ turn", BY_MUJOCO),
    Mutation("imported size, halves", MJCF, "[2.0 * half for half in size]", "[1.0 * half for half in size]", BY_MUJOCO),
    Mutation("imported cylinder, foot", WORLD_CONTENT, '"pole", "position": pose.point(0.0, 0.0, -0.5', '"pole", "position": pose.point(0.0, 0.0, 0.5', BY_SCIPY),
    Mutation("imported joint is in its child", SDF, "default = child.text", "pass", BY_SCIPY),
    Mutation("imported model by its frame", SDF, "model.node).inverse()", "model.node)", BY_SCIPY),
    Mutation("imported cells, order of children", OCTOMAP, "half * (k >> 1 & 1), z + half * (k >> 2)", "half * (k >> 2), z + half * (k >> 1 & 1)", BY_CELLS),
    Mutation("imported cells, free for occupied", OCTOMAP, "if state == 2:", "if state == 1:", BY_CELLS),
    Mutation("imported whole, turned the wrong way", IMPORTED, "[[c, -s, 0.0], [s, c, 0.0]", "[[c, s, 0.0], [-s, c, 0.0]", AS_A_WHOLE),
    Mutation("imported whole, yaw", IMPORTED, 'table.get("yaw", 0.0) + yaw', 'table.get("yaw", 0.0) - yaw', AS_A_WHOLE),
    Mutation("possible inertia, most of no mass", MASS_BOUNDS, "most = mass * within * within", "most = within * within", BOUNDED),
    Mutation("possible inertia, least is the most", MASS_BOUNDS, "total * total * total < _LEAST", "total * total * total > _LEAST", BOUNDED),
    Mutation("possible inertia, ball is a shell", MASS_BOUNDS, "_LEAST = 1.2**3", "_LEAST = 2.0**3", BOUNDED),
    Mutation("weighed model, axes of the wrong frame", MODELS, "chosen[0].pose.inverse()", "chosen[0].pose", WEIGHED),
    Mutation("weighed model, inertia turned back", MODEL_LINKS, "pose.turn @ self.moments @ pose.turn.T", "pose.turn.T @ self.moments @ pose.turn", WEIGHED),
    Mutation("weighed model, links that move count", MODEL_FORMATS, "in held and name not in moving", "in held", WEIGHED),
    Mutation("weighed model, inner frames are left out", MODEL_FORMATS, "return own.placed_at(origin_of(inertial))", "return own", WEIGHED),
    Mutation("weighed geoms, class of the body is lost", MODEL_GEOMS, 'body.get("childclass") or at.child_class', 'body.get("childclass") or "main"', WEIGHED_GEOMS),
    Mutation("weighed geoms, density beats mass", MODEL_GEOMS, "factor = density if mass is None else", "factor = density if density > 0.0 else", WEIGHED_GEOMS),
    Mutation("weighed geoms, caps without their lever", MODEL_SOLIDS, "0.75 * r * h", "0.0 * r * h", WEIGHED_GEOMS),
    Mutation("weighed geoms, pyramids inside out", MODEL_SOLIDS, 'if method == "legacy" else volumes', 'if method == "exact" else volumes', WEIGHED_GEOMS),
    Mutation("answers, heights do not balance", NEW_SIZES, "low * pack / rest", "-low * pack / rest", ANSWERED),
    Mutation("answers, arms point elsewhere", NEW_SIZES, "0.5 * each - k * each", "0.4 * each - k * each", ANSWERED),
    # logs of real flights
    Mutation("bodies of logs are turned the wrong way", "logs/frame_turns.py", "right * [1, -1, -1, -1]", "right * [1, 1, 1, 1]", FRAMES),
    Mutation("NED is up", "logs/frame_turns.py", '"ned": np.diag([1.0, -1.0, -1.0])', '"ned": np.diag([1.0, -1.0, 1.0])', FRAMES),
    Mutation("clocks of logs, sign of the offset", "logs/frame_check.py", "at = accelerometer.times - offset", "at = accelerometer.times + offset", CLOCKS),
    Mutation("an impact of a log keeps its weight", "logs/segments.py", "values - [0.0, 0.0, GRAVITY]", "values + [0.0, 0.0, GRAVITY]", SEGMENTS),
    Mutation("the best turn is the worst", "logs/frame_check.py", "best = int(np.argmax(scores))\n    if scores[best] < AGREED:", "best = int(np.argmin(scores))\n    if scores[best] < AGREED:", FRAMES),
)  # fmt: skip
