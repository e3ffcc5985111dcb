"""Kernels that come with the package, compiled when it was built, and whether they fit here.

A wheel may hold one folder beside this module for each level of processor, with files as
`springback.kernels.kernel_cache` writes them and a manifest (`tools/wheel.py`).  They are used only
where this processor has every feature of the level, and source, interpreter, compiler and its
options are those of the build; else kernels are compiled as if there were none.  A checkout has
none.  The result is the same to the last bit (docs/decisions/0039).
"""

from __future__ import annotations

import functools
import json
import os
import platform
import sys
from collections.abc import Mapping
from importlib import metadata
from pathlib import Path
from typing import Any, NamedTuple

from numba.core import config

from springback.files import json_text, write_atomically

#: Environment variable that leaves packaged kernels aside if it is 0.
VARIABLE = "SPRINGBACK_PACKAGED_KERNELS"
#: Name of a manifest.
MANIFEST = "manifest.json"
#: Folder of the levels in an installed package.
FOLDER = Path(__file__).parent

#: Options of the compiler that change code, by the names of its settings.
_OPTIONS = (
    "OPT", "LOOP_VECTORIZE", "SLP_VECTORIZE", "USING_SVML", "BOUNDSCHECK", "DEBUGINFO_DEFAULT",
)  # fmt: skip

#: What code is compiled for: triple, name of the processor, and its features, as LLVM calls them.
Target = tuple[str, str, str]


class PackagedKernels(NamedTuple):
    """Kernels compiled for one level of processor."""

    folder: Path
    """Where their files are."""
    target: Target
    """What they were compiled for."""
    needs: tuple[str, ...]
    """Features of the processor that their code uses, as LLVM calls them."""
    source: str
    """Digest of the source that they were compiled from."""
    versions: Mapping[str, str]
    """Those of the build (`compiler_versions`)."""
    kinds: tuple[str, ...]
    """Kinds of flight that need no other kernels (`springback.campaign.compiler_times`)."""

    def misfit(self, source: str, target: Target) -> str:
        """Reason why they cannot be used here; empty if they can.

        Args:
            source: Digest of the source of this process.
            target: What this process compiles for.
        """
        name = self.target[1]
        triple, _, features = target
        if target != self.target:
            if triple != self.target[0]:
                return f"{name}: compiled for {self.target[0]}, this is {triple}"
            lacking = [one for one in self.needs if f"+{one}" not in features.split(",")]
            if lacking:
                more = f" and {len(lacking) - 1} more" if len(lacking) > 1 else ""
                return f"{name}: this processor lacks {lacking[0]}{more}"
        here = compiler_versions()
        for what in sorted({*here, *self.versions}):
            built, mine = self.versions.get(what, "unknown"), here.get(what, "unknown")
            if built != mine:
                return f"{name}: compiled with {what} {built}, this is {mine}"
        return "" if source == self.source else f"{name}: compiled from another source"

    def files(self) -> list[Path]:
        """Their files."""
        return sorted(self.folder.glob("*.kernel"))


@functools.cache
def compiler_versions() -> dict[str, str]:
    """Everything but source and processor that determines compiled code: versions and options.

    Of NumPy the minor version counts, by which the compiler chooses its rules.
    """
    options = {f"option {name}": _setting(name) for name in _OPTIONS}
    return options | {
        "Python": f"{platform.python_implementation()} {sys.version_info[0]}.{sys.version_info[1]}",
        "numba": metadata.version("numba"),
        "llvmlite": metadata.version("llvmlite"),
        "NumPy": ".".join(metadata.version("numpy").split(".")[:2]),
    }


def _setting(name: str) -> str:
    """An option of the compiler; that of optimisation is a number, or that and the word max."""
    value = getattr(config, name, None)
    return f"{int(value or 0)}{' max' if getattr(value, 'is_opt_max', False) else ''}"


def write_manifest(given: PackagedKernels) -> None:
    """Write the manifest into the folder of its kernels."""
    content = {
        "target": given.target, "needs": given.needs, "source": given.source,
        "versions": dict(given.versions), "kinds": given.kinds,
    }  # fmt: skip
    write_atomically(given.folder / MANIFEST, json_text(content))


@functools.cache
def packaged_kernels() -> tuple[PackagedKernels, ...]:
    """What the package brings, those for the most capable processors first.

    Manifests that cannot be read are passed over: they say nothing that can be believed.
    """
    found = [_read(path) for path in sorted(FOLDER.glob(f"*/{MANIFEST}"))]
    return tuple(sorted((one for one in found if one), key=lambda one: -len(one.needs)))


def _read(path: Path) -> PackagedKernels | None:
    try:
        given = json.loads(path.read_text(encoding="utf-8"))
        triple, name, features = (str(word) for word in given["target"])
        return PackagedKernels(
            path.parent, (triple, name, features), _words(given["needs"]), str(given["source"]),
            {str(key): str(value) for key, value in dict(given["versions"]).items()},
            _words(given["kinds"]),
        )  # fmt: skip
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return None


def _words(given: Any) -> tuple[str, ...]:
    return tuple(str(word) for word in given)


def are_wanted() -> bool:
    """False if the environment says that packaged kernels are to be left aside."""
    return os.environ.get(VARIABLE, "") != "0"


def fitting_kernels(source: str, target: Target) -> PackagedKernels | None:
    """The packaged kernels to be used here; None if there are none that fit.

    Args:
        source: Digest of the source of this process.
        target: What this process compiles for.
    """
    if not are_wanted():
        return None
    return next((one for one in packaged_kernels() if not one.misfit(source, target)), None)


def status_text(source: str, target: Target) -> str:
    """Line on the packaged kernels: which are used, or why none is.

    Args:
        source: Digest of the source of this process.
        target: What this process compiles for.
    """
    known = packaged_kernels()
    if not known:
        return "none in this installation"
    if not are_wanted():
        return f"not used: {VARIABLE} is 0"
    used = fitting_kernels(source, target)
    if used is None:
        reasons = [one.misfit(source, target) for one in known]
        return f"not used: {'; '.join(reasons)}"
    return f"{len(used.files())} for {used.target[1]}, used"
