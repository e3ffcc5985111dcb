"""Build a wheel that carries compiled kernels of the common kinds of flight (docs/decisions/0039).

For each level of processor that this machine can execute, a process of its own compiles for that
level instead of this processor, by flying.  The wheel is for this platform and version of Python; a
wheel or an archive of the source that is built otherwise has no kernels.

usage: python tools/wheel.py [--out dist] [--level NAME]... [--scenario FILE]... [--vehicle NAME]...
"""

from __future__ import annotations

import argparse
import os
import platform
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
#: Features of x86-64-v3 beyond the first level, and of x86-64-v4 beyond those, as LLVM calls them
#: (x86-64 psABI, table 3.1; OSXSAVE is the system's, which LLVM looks at before it names AVX).
V3 = (
    "cx16", "popcnt", "sahf", "sse3", "ssse3", "sse4.1", "sse4.2",
    "avx", "avx2", "bmi", "bmi2", "f16c", "fma", "lzcnt", "movbe", "xsave",
)  # fmt: skip
V4 = (*V3, "avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl")
#: Levels by machine: LLVM's name of the processor, and features that it has beyond all others.
#: Every 64-bit ARM has what "generic" uses.
LEVELS: dict[str, dict[str, tuple[str, ...]]] = {
    "x86_64": {"x86-64-v3": V3, "x86-64-v4": V4},
    "aarch64": {"generic": ()},
}
#: Examples that are compiled beside the kinds of flight of `springback doctor --compile`.
EXAMPLES = ("arq_wall.toml", "collision.toml", "run_up.toml", "steps.toml")
#: Plan whose first flights are compiled, too.
PLAN = "campaign.toml"
#: Oldest C library of the tag, that of the wheels of SciPy and Numba; kernels find its functions by
#: name when they are loaded, and need none that is newer.
LIBRARY = "manylinux_2_28"


def main() -> None:
    """Read the arguments and build."""
    from springback.vehicle.library import VEHICLES

    parser = argparse.ArgumentParser(description="Build a wheel that carries compiled kernels.")
    parser.add_argument("--out", type=Path, default=ROOT / "dist", help="folder of the wheel")
    parser.add_argument("--level", action="append", help="only this level; may be repeated")
    parser.add_argument("--scenario", type=Path, action="append", help="only the kinds of these")
    parser.add_argument(
        "--vehicle",
        action="append",
        default=[],
        choices=tuple(VEHICLES),
        metavar="NAME",
        help="also those of a vehicle of the library",
    )
    parser.add_argument("--compile", type=Path, help=argparse.SUPPRESS)  # by the process of a level
    given = parser.parse_args()
    if given.compile is not None:
        compile_level(given.level[0], given.compile, given.scenario, given.vehicle)
        return
    levels = chosen_levels(given.level)
    with tempfile.TemporaryDirectory() as folder:
        for level in levels:
            start_compiling(level, Path(folder), given.scenario or (), given.vehicle)
        print(build(Path(folder) / "kernels", given.out))


def machine_levels() -> dict[str, tuple[str, ...]]:
    """Levels of this machine's kind."""
    machine = platform.machine().lower()
    return LEVELS.get({"amd64": "x86_64", "arm64": "aarch64"}.get(machine, machine), {})


def chosen_levels(wanted: Iterable[str] | None) -> list[str]:
    """Levels to compile: those wanted, or all that this processor can execute."""
    from llvmlite import binding

    has, known = binding.get_host_cpu_features(), machine_levels()
    possible = [name for name, needs in known.items() if all(has.get(one) for one in needs)]
    for name in wanted or known:
        if name not in possible:
            line = f"{name}: this processor cannot execute it"
            sys.exit(line) if wanted else print(f"{line}; left out", file=sys.stderr)
    if not possible:
        sys.exit(f"{platform.machine()}: no level of processor is known that can be compiled for")
    return list(wanted or possible)


def start_compiling(
    level: str, folder: Path, scenarios: Iterable[Path], vehicles: Iterable[str]
) -> None:
    """Compile for a level in a process of its own, which takes no settings of the user's."""
    words = [sys.executable, __file__, "--level", level, "--compile", str(folder / "kernels")]
    for scenario in scenarios:
        words += ["--scenario", str(scenario.resolve())]
    for vehicle in vehicles:
        words += ["--vehicle", vehicle]
    kept = {key: value for key, value in os.environ.items() if not key.startswith("NUMBA_")}
    settings = {
        # Without features of its own a level would have those of this processor.
        "NUMBA_CPU_NAME": level, "NUMBA_CPU_FEATURES": "", "NUMBA_DISABLE_INTEL_SVML": "1",
        "SPRINGBACK_CACHE_DIR": str(folder / level), "SPRINGBACK_PACKAGED_KERNELS": "0",
        "PYTHONPATH": str(ROOT / "src"),
    }  # fmt: skip
    work = folder / "work"  # where no settings of the compiler are
    work.mkdir(exist_ok=True)
    subprocess.run(words, env=kept | settings, cwd=work, check=True)


def compile_level(
    level: str, folder: Path, files: Iterable[Path] | None, vehicles: Iterable[str] = ()
) -> None:
    """Fly each kind of flight, and put the kernels into the folder of the level.

    Args:
        level: Name of the level, for which this process compiles.
        folder: Folder for one folder of each level.
        files: Scenarios; by default those of the common kinds, and some examples.
        vehicles: Of the library, whose flights among shapes are compiled as well.
    """
    from springback.campaign.common_flights import COMMON, flights_of, kinds_of
    from springback.campaign.compiler_times import compile_kind
    from springback.campaign.design.layout import lay_out
    from springback.campaign.design.plan import read_plan
    from springback.interfaces.output.diagnosis import diagnosis
    from springback.kernels.compiler import cache_folder, compiler_target, source_digest
    from springback.kernels.kernel_cache import pack_kernel
    from springback.kernels.packaged.manifest import (
        PackagedKernels,
        compiler_versions,
        write_manifest,
    )
    from springback.results.flight import as_scenario

    chosen = files or [ROOT / "examples" / name for name in EXAMPLES]
    scenarios: dict[str, Mapping[str, Any]] = {} if files else dict(COMMON)
    scenarios |= {path.name: as_scenario(path).model_dump(exclude_unset=True) for path in chosen}
    if not files:
        design = lay_out(*read_plan(ROOT / "examples" / PLAN))
        first = design.slice(0, len(design.robots)).tables
        scenarios |= {
            f"{PLAN}, {robot}": one for robot, one in zip(design.robots, first, strict=True)
        }
    for vehicle in vehicles:
        scenarios |= flights_of(vehicle)
    kinds = kinds_of(scenarios)
    for name, kind in kinds:
        begun = time.monotonic()
        compile_kind(kind, {})
        print(f"{level}, {name}: {time.monotonic() - begun:.0f} s", file=sys.stderr)
    if not files:
        diagnosis()  # of `springback doctor`
    target = compiler_target()
    if target[1:] != (level, ""):
        raise SystemExit(f"compiled for {target[1]} with features {target[2]!r}, not for {level}")
    into = folder / level
    for path in sorted(cache_folder().glob("*.kernel")):
        pack_kernel(path, into)
    keys = tuple(sorted(one.kind.key for one in kinds))
    needs = machine_levels()[level]
    write_manifest(PackagedKernels(into, target, needs, source_digest(), compiler_versions(), keys))


def build(kernels: Path, out: Path) -> Path:
    """Build the wheel around a folder of kernels; returns its path."""
    version = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    out.mkdir(parents=True, exist_ok=True)
    tag = f"{version}-{version}-{platform_tag()}"
    settings = {
        "HATCH_BUILD_HOOK_ENABLE_CUSTOM": "true",
        "SPRINGBACK_WHEEL_KERNELS": str(kernels),
        "SPRINGBACK_WHEEL_TAG": tag,
    }
    words = [sys.executable, "-m", "hatchling", "build", "--target", "wheel", "--directory"]
    done = subprocess.run(
        [*words, str(out.resolve())], env=os.environ | settings, cwd=ROOT, check=False,
        capture_output=True, text=True,
    )  # fmt: skip
    if done.returncode:
        sys.exit(done.stderr)
    return max(out.glob(f"*-{tag}.whl"), key=lambda path: path.stat().st_mtime)


def platform_tag() -> str:
    """Tag of this platform."""
    from packaging.tags import platform_tags

    if platform.libc_ver()[0] == "glibc":
        return f"{LIBRARY}_{platform.machine()}"
    return next(iter(platform_tags()))


if __name__ == "__main__":
    main()
