"""`tools/environment` behind a proxy that opens TLS: uv with the system's certificates, before pip.

uv and the Python of the environment are stand-ins that note how they were called.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from builders.missing import needs

ROOT = Path(__file__).parents[1]
UNKNOWN = "error: Failed to fetch\\n  cause: invalid peer certificate: UnknownIssuer"
#: Fails in the ways of the environment variable UV_FAILS.
UV = f"""#!/bin/sh
echo "uv $1 system certificates: ${{UV_SYSTEM_CERTS:-no}}" >> calls
case $UV_FAILS in
    certificate) [ "${{UV_SYSTEM_CERTS:-}}" = true ] || {{ printf '{UNKNOWN}\\n' >&2; exit 2; }};;
    lock) echo "error: the lockfile needs to be updated" >&2; exit 2;;
esac
"""
PYTHON = """#!/bin/sh
echo "python $2 $3 certificates: ${PIP_CERT:-own}" >> calls
if [ "$PIP_FAILS" = certificate ] && [ -z "${PIP_CERT:-}" ]; then
    echo "SSLError: certificate verify failed: unable to get local issuer certificate" >&2
    exit 1
fi
"""

pytestmark = needs("POSIX")


def program(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    path.chmod(0o755)


def made(folder: Path, uv: str = "", pip: str = "") -> tuple[list[str], str]:
    """Calls of the stand-ins, and the output, of a checkout without an environment."""
    (folder / "tools").mkdir()
    shutil.copy(ROOT / "tools/environment", folder / "tools/environment")
    for name in ("uv.lock", "pyproject.toml"):
        (folder / name).touch()
    program(folder / ".venv/bin/python", PYTHON)
    program(folder / "programs/uv", UV)
    own = {"UV_FAILS": uv, "PIP_FAILS": pip, "PYTHON": sys.executable}
    known = {k: v for k, v in os.environ.items() if not k.startswith(("UV_", "PIP_"))}
    path = f"{folder / 'programs'}:/usr/bin:/bin"
    done = subprocess.run(
        [str(folder / "tools/environment"), "all"], env={**known, **own, "PATH": path}, cwd=folder,
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert (folder / ".venv/.made-with-all").exists()
    return (folder / "calls").read_text().splitlines(), done.stderr


@pytest.mark.parametrize(("target", "extra"), [("run", "all"), ("test", "dev")])
def test_make_begins_with_it(target: str, extra: str) -> None:
    """So that what is said here holds for `make run` and `make test`."""
    rule = re.search(rf"^{target}:.*\n\t(.*)$", (ROOT / "Makefile").read_text(), re.M)
    assert rule
    assert rule[1] == f"@tools/environment {extra}"


def test_uv_alone_says_nothing(tmp_path: Path) -> None:
    calls, told = made(tmp_path)
    assert calls == ["uv sync system certificates: no"]
    assert told == ""


def test_behind_a_proxy_uv_takes_the_certificates_of_the_system(tmp_path: Path) -> None:
    """And says so in one sentence; pip, which may not know them either, is not needed."""
    calls, told = made(tmp_path, uv="certificate")
    assert calls == ["uv sync system certificates: no", "uv sync system certificates: true"]
    assert told == (
        "the certificate of the package index is not known to uv; trying again with those of the "
        "system\n"
    )


def test_where_uv_fails_for_another_reason_pip_is_used(tmp_path: Path) -> None:
    """The reason is shown: it is not the certificate."""
    calls, told = made(tmp_path, uv="lock")
    pip = "python pip install certificates: own"  # what builds, what is locked, and springback
    assert calls == ["uv sync system certificates: no", pip, pip, pip]
    assert told.splitlines() == [
        "error: the lockfile needs to be updated",
        "uv failed, as said above; using pip with the same versions",
    ]


def test_pip_takes_the_certificates_of_the_system_too(tmp_path: Path) -> None:
    calls, told = made(tmp_path, uv="lock", pip="certificate")
    assert calls[1] == "python pip install certificates: own"
    assert len(calls) == 5
    assert all(call.startswith("python pip install certificates: /") for call in calls[2:])
    assert told.splitlines()[-1].startswith(
        "the certificate of the package index is not known to pip;"
    )
