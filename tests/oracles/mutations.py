"""Does any test notice?  Flip one sign of the physics at a time and see which tests fail.

Run from the root of the repository (a quarter of an hour on two cores; not part of the test suite)::

    PYTHONPATH=src python tests/oracles/mutations.py            # all
    PYTHONPATH=src python tests/oracles/mutations.py damper     # those whose name has "damper"
    PYTHONPATH=src python tests/oracles/mutations.py --flights  # the tests that compile, too

Each mutation is made in a copy of the package in a temporary folder; the repository is not touched.
The tests that run are those that look at single states, in plain Python, so nothing is compiled.
Tests that fail without any mutation are not counted.  The exit status is the number of mutations
that no test noticed.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parents[2]
TESTS = ROOT / "tests" / "dynamics"
#: Tests of single states.
QUICK = "accelerations or locked_arms or textbook or power or gap or locking"


class Mutation(NamedTuple):
    """One change of the source; ``old`` occurs exactly once in ``path``."""

    name: str
    path: str  # below src/springback
    old: str
    new: str


CAGE, SURFACES, MOTION = "contact/cage.py", "contact/surfaces.py", "dynamics/motion.py"
STATE, ENERGY, VECTORS = "vehicle/state.py", "dynamics/energy.py", "kernels/vectors.py"
OBSTACLES = "contact/obstacles.py"

MUTATIONS = (
    # contact
    Mutation("contact damping, sign as printed", SURFACES, "elastic + (d * elastic", "elastic + (-d * elastic"),
    Mutation("contact loss, sign", SURFACES, "(force - elastic) * rate", "(elastic - force) * rate"),
    Mutation("contact force may pull", SURFACES, "positive_part(elastic + (d", "(elastic + (d"),
    Mutation("contact exponent 3/2 to 2", SURFACES, "depth * math.sqrt(depth)", "depth * depth"),
    Mutation("normal force pulls in", CAGE, "n * (-pressed.force)", "n * pressed.force"),
    Mutation("normal points out", CAGE, "n = -outward_normal(", "n = outward_normal("),
    Mutation("plane seen, offset", OBSTACLES, "plane.offset - plane.normal", "plane.offset + plane.normal"),
    Mutation("plane seen, turned the wrong way", OBSTACLES, "Plane(plane.normal @ r,", "Plane(r @ plane.normal,"),
    Mutation("penetration rate, sign", CAGE, "(omega ^ pressing)) @ n", "(omega ^ pressing)) @ (-n)"),
    Mutation("penetration rate, no turning", CAGE, "(arm.sliding + (omega ^ pressing)) @ n", "arm.sliding @ n"),
    Mutation("friction drives the slip", SURFACES, "Friction(slip * -grip", "Friction(slip * grip"),
    Mutation("friction loss, sign", SURFACES, "grip * square, grip)", "-grip * square, grip)"),
    Mutation("slip without turning", CAGE, "arm.sliding + (omega ^ rubbing_at), n", "arm.sliding, n"),
    Mutation("slip keeps its normal part", CAGE, "velocity - (velocity @ normal) * normal", "velocity * 1.0"),
    Mutation("vertical friction, tilt", SURFACES, "vertical - (vertical @ normal) * normal", "vertical * 1.0"),
    Mutation("contact moment, sign", CAGE, "moment = (rubbing_at ^ force)", "moment = (force ^ rubbing_at)"),
    Mutation(
        "normal moment about the friction point, sign",
        CAGE,
        "((at.normal_lever - at.friction_lever) ^ push)",
        "(push ^ (at.normal_lever - at.friction_lever))",
    ),
    Mutation("ring inset, sign", CAGE, "-eps * eps * inverse * radius", "eps * eps * inverse * radius"),
    Mutation("ring radius ignores the tilt", CAGE, "t @ t + eps * eps", "1.0 + 0.0 * (t @ t) + eps * eps"),
    Mutation("arm tip, friction at the tip", CAGE, "lever, lever * 0.0, 0.0)", "lever, lever, 0.0)"),
    # arms
    Mutation("spring, sign", MOTION, "stiffness * (arm.length - length)", "stiffness * (length - arm.length)"),
    Mutation("damper, sign as printed", MOTION, "- arm.damping * rate\n", "+ arm.damping * rate\n"),
    Mutation("damper loss, sign", MOTION, "u * (arm.damping * rate", "-u * (arm.damping * rate"),
    Mutation("end stop, side of the inner", MOTION, "Stop(force if", "Stop(-force if"),
    Mutation("end stop, side of the outer", MOTION, "low > 0.0 else -force", "low > 0.0 else force"),
    Mutation("end stop, rate of the inner", MOTION, "= -rate if low", "= rate if low"),
    Mutation("end stop, damping", MOTION, "stop_dissipation * pressing", "stop_dissipation * -pressing"),
    Mutation("end stop loss, sign", MOTION, "(force - elastic) * pressing", "(elastic - force) * pressing"),
    Mutation("arm velocity, l̇ sign", STATE, "velocity + rate * e", "velocity - rate * e"),
    Mutation("arm does not feel the contact", MOTION, "e @ touch.force + outward", "outward"),
    Mutation("arm acceleration, coupling", MOTION, "drive - known.pull.hold", "drive + known.pull.hold"),
    # inertial terms
    Mutation("centrifugal force along the arm", MOTION, "+ outward + own", "- outward + own"),
    Mutation("centrifugal, ω_z only", MOTION, "across * across + omega.z", "omega.z"),
    Mutation("centrifugal, component across", MOTION, "e.x * omega.y - e.y * omega.x", "e.x * omega.y + e.y * omega.x"),
    Mutation("ω × (ω × s), sign", MOTION, "(omega ^ (turning + a.drift + a.drift))", "(omega ^ (a.drift + a.drift - turning))"),
    Mutation("Coriolis force, sign", MOTION, "(omega ^ (turning + a.drift + a.drift))", "(omega ^ (turning - a.drift - a.drift))"),
    Mutation("Coriolis force, half", MOTION, "(omega ^ (turning + a.drift + a.drift))", "(omega ^ (turning + a.drift))"),
    Mutation("J̇ ω, sign", MOTION, "(omega ^ (inertia @ omega)) +", "(omega ^ (inertia @ omega)) -"),
    Mutation("J̇, half", MOTION, "planar_product(drift + drift, lever)", "planar_product(drift, lever)"),
    Mutation("gyroscopic moment, sign", MOTION, "spin_rate = (omega ^ (inertia @ omega))", "spin_rate = ((inertia @ omega) ^ omega)"),
    Mutation("arms' inertia, product", STATE, "Vec(second.y, -second.z, 0.0)", "Vec(second.y, second.z, 0.0)"),
    # rotors
    Mutation("thrust moment, roll", MOTION, "Vec(lever.y, -lever.x, arm", "Vec(-lever.y, -lever.x, arm"),
    Mutation("thrust moment, pitch", MOTION, "Vec(lever.y, -lever.x, arm", "Vec(lever.y, lever.x, arm"),
    Mutation("rotor torque, sign", MOTION, "-lever.x, arm.torque_ratio)", "-lever.x, -arm.torque_ratio)"),
    Mutation("thrust power, turning", MOTION, "velocity.z + a.rotor_moment", "velocity.z - a.rotor_moment"),
    # solution of the six equations
    Mutation("what the arm keeps, sign", MOTION, "- a.taken", "+ a.taken"),
    Mutation("M⁻¹, off-diagonal", MOTION, "-xy * scale", "xy * scale"),
    Mutation("Schur complement, jxx", MOTION, "j.x.x - n.zz", "j.x.x + n.zz"),
    Mutation("Schur complement, jyy", MOTION, "j.y.y - n.zz", "j.y.y + n.zz"),
    Mutation("Schur complement, jxy", MOTION, "j.x.y + n.zz", "j.x.y - n.zz"),
    Mutation("Schur complement, jzz", MOTION, "j.z.z - (n.xx", "j.z.z + (n.xx"),
    Mutation("Schur complement, jzz cross term", MOTION, "- 2.0 * n.xy", "+ 2.0 * n.xy"),
    Mutation("coupling s × a", MOTION, "system.moment - (s ^ alone)", "system.moment + (s ^ alone)"),
    Mutation("coupling α × s", MOTION, "alone - times(n, alpha ^ s)", "alone + times(n, alpha ^ s)"),
    Mutation("slider, weight", MOTION, "force - mu @ weight", "force + mu @ weight"),
    Mutation("slider, mass off-diagonal", MOTION, "u.x - slide.z * u.y", "u.x + slide.z * u.y"),
    Mutation("weight, sign", MOTION, "r @ solved.linear - Vec", "r @ solved.linear + Vec"),
    Mutation("solve, one cofactor", VECTORS, "q * r - p * f, p * r - q * d", "q * r + p * f, p * r - q * d"),
    # kinematics, energy, locking
    Mutation("quaternion rate, one term", VECTORS, "q.y * omega.z - q.z * omega.y", "q.y * omega.z + q.z * omega.y"),
    Mutation("rotation matrix, one term", VECTORS, "2.0 * (x * y - w * z)", "2.0 * (x * y + w * z)"),
    Mutation("spring energy, half", ENERGY, "springs=0.5", "springs=0.25"),
    Mutation("contact energy exponent", SURFACES, "/ (n + 1.0)", "/ (n + 2.0)"),
    Mutation("Steiner, product", ENERGY, "mass * c.x * c.y, mass * c.x * c.z", "-mass * c.x * c.y, mass * c.x * c.z"),
    Mutation("locking, place", ENERGY, "r @ (centre - new_centre)", "r @ (new_centre - centre)"),
    Mutation("locking, velocity", ENERGY, "velocity - r @ (new_omega", "velocity + r @ (new_omega"),
    Mutation("angular momentum, drift", ENERGY, "((omega ^ centre) + drift)))", "((omega ^ centre) - drift)))"),
)  # fmt: skip


def failures(source: Path, flights: bool) -> set[str]:
    """Names of the tests that fail with the package in ``source``."""
    command = [sys.executable, "-m", "pytest", "-q", "--tb=no", "-rfE", "-p", "no:cacheprovider"]
    command += [str(TESTS)] if flights else [str(TESTS), "-k", QUICK]
    paths = os.pathsep.join([str(source), str(ROOT / "tests")])
    environment = {**os.environ, "PYTHONPATH": paths, "PYTHONDONTWRITEBYTECODE": "1"}
    environment["SPRINGBACK_CACHE_DIR"] = str(source / "cache")
    done = subprocess.run(
        command, cwd=ROOT, env=environment, capture_output=True, text=True, check=False
    )
    failed = set(re.findall(r"^(?:FAILED|ERROR) \S*?(test_\w+\.py(?:::\S+)?)", done.stdout, re.M))
    if done.returncode != 0 and not failed:
        raise RuntimeError(done.stdout[-2000:] + done.stderr[-2000:])
    return failed


def mutated(package: Path, mutation: Mutation | None, flights: bool) -> set[str]:
    """Names of the tests that fail with one mutation, or with none."""
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "springback"
        shutil.copytree(package, copy)
        if mutation is not None:
            path = copy / mutation.path
            text = path.read_text(encoding="utf-8").replace(mutation.old, mutation.new)
            path.write_text(text, encoding="utf-8")
        return failures(Path(folder), flights)


def outdated(package: Path) -> list[str]:
    """Mutations whose text does not occur exactly once, or whose result is not Python."""
    complaints = []
    for mutation in MUTATIONS:
        text = (package / mutation.path).read_text(encoding="utf-8")
        if text.count(mutation.old) != 1:
            complaints.append(f"{mutation.name}: {text.count(mutation.old)} places")
        compile(text.replace(mutation.old, mutation.new), mutation.path, "exec")
    return complaints


def noticed(failed: set[str]) -> str:
    """Failed tests in words: each with the number of its cases."""
    counts = Counter(name.split("::")[-1].split("[")[0] for name in failed)
    return ", ".join(f"{name} ({count})" for name, count in sorted(counts.items()))


def main(arguments: list[str]) -> int:
    """Try the mutations whose name has one of the arguments in it; all without arguments."""
    flights = "--flights" in arguments
    wanted = [a for a in arguments if not a.startswith("--")]
    chosen = [m for m in MUTATIONS if not wanted or any(w in m.name for w in wanted)]
    unnoticed = 0
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(os.cpu_count()) as pool:
        package = Path(folder) / "springback"
        hidden = shutil.ignore_patterns("__pycache__")
        shutil.copytree(ROOT / "src" / "springback", package, ignore=hidden)
        if complaints := outdated(package):
            print("The source has changed; mend these mutations:", *complaints, sep="\n  ")
            return len(complaints)
        before = mutated(package, None, flights)
        print("without mutation:", noticed(before) or "all pass", flush=True)
        tried = pool.map(lambda m: mutated(package, m, flights), chosen)
        for mutation, failed in zip(chosen, tried, strict=True):
            print(f"{mutation.name:46s}", noticed(failed - before) or "NOBODY", flush=True)
            unnoticed += not failed - before
    print(f"{len(chosen) - unnoticed} of {len(chosen)} noticed")
    return unnoticed


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
