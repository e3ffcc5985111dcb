"""What is built for others: all that is needed, and nothing else."""

from __future__ import annotations

import re
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

from builders.cases import nonempty
from builders.missing import needs

ROOT = Path(__file__).parents[1]
#: Files beside the modules without which commands fail.
NEEDED = ("py.typed", "interfaces/web/LICENSES.txt")


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("dist")
    words = [sys.executable, "-m", "hatchling", "build", "--directory", str(folder)]
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return folder


def tracked(folder: str) -> set[str]:
    words = ["git", "ls-files", "-z", folder]
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return {name for name in done.stdout.split("\0") if name and (ROOT / name).exists()}


@needs("a git checkout")
def test_the_wheel_holds_the_package_and_its_licence(built: Path) -> None:
    [path] = built.glob("*.whl")
    with zipfile.ZipFile(path) as wheel:
        names = set(wheel.namelist())
        [metadata] = [name for name in names if name.endswith(".dist-info/METADATA")]
        about = wheel.read(metadata).decode()
        [entry] = [name for name in names if name.endswith("entry_points.txt")]
        assert "springback = springback.command:run" in wheel.read(entry).decode()
    package = {name for name in names if ".dist-info/" not in name}
    assert package >= {name.removeprefix("src/") for name in tracked("src")}
    assert {name.partition("/")[0] for name in package} == {"springback"}
    assert not [name for name in package if "__pycache__" in name or name.endswith(".pyc")]
    assert [name for name in names if name.endswith("licenses/LICENSE")]
    assert package >= {f"springback/{name}" for name in NEEDED}
    for name in ("numba", "llvmlite"):  # whose private parts are used
        assert re.search(rf"^Requires-Dist: {name}<0\.\d+,", about, re.MULTILINE)


@needs("a git checkout")
def test_the_source_distribution_holds_no_more_than_it_says(built: Path) -> None:
    [path] = built.glob("*.tar.gz")
    with tarfile.open(path) as archive:
        names = {name.partition("/")[2] for name in archive.getnames()}
    assert {name.partition("/")[0] for name in names} == {
        "src", "README.md", "LICENSE", "CHANGELOG.md", "CITATION.cff", "pyproject.toml", "PKG-INFO",
        ".gitignore", "examples",
    }  # fmt: skip
    assert names >= tracked("src")


def test_both_ways_of_installing_check_hashes() -> None:
    for extra in ("all", "dev", "docs", "build", "uv"):
        text = (ROOT / f"tools/locked/{extra}.txt").read_text()
        pinned = [line for line in text.splitlines() if "==" in line and line[0].isalnum()]
        assert len(pinned) >= (1 if extra == "uv" else 5)
        assert all(line.endswith("\\") for line in pinned), "a version without a hash"
    way = (ROOT / "tools/environment").read_text().replace("\\\n", " ")
    lines = [line.strip() for line in way.splitlines()]
    installs = [line for line in lines if "pip install --quiet" in line or "from_pip --" in line]
    wrapper = [line for line in installs if line.endswith('pip install --quiet "$@"')]
    assert len(wrapper) == 1  # called by the others
    others = [line for line in installs if line not in wrapper]
    assert len(others) >= 4
    assert all("--require-hashes" in line or "--no-deps" in line for line in others)


def test_pip_alone_does_without_uv() -> None:
    """Where uv cannot be had, what builds the package must not ask for it again."""
    build = (ROOT / "tools/locked/build.txt").read_text()
    assert re.search("^hatchling==", build, re.MULTILINE)
    assert re.search("^editables==", build, re.MULTILINE)  # of --editable without isolation
    for extra in ("all", "dev", "docs", "build"):
        text = (ROOT / f"tools/locked/{extra}.txt").read_text()
        assert not re.search(r"^uv==", text, re.MULTILINE), extra


def test_the_locked_files_say_the_same() -> None:
    """`make lock` writes all of them; a version in one and another in the next is a slip."""
    versions: dict[str, set[str]] = {}
    for extra in ("all", "dev", "docs"):
        for line in (ROOT / f"tools/locked/{extra}.txt").read_text().splitlines():
            name, sign, rest = line.partition("==")
            if sign and name[0].isalnum():
                versions.setdefault(f"{name} {extra}", set()).add(rest.partition(" ")[0])
    for key, found in nonempty(versions.items()):
        name, _, extra = key.partition(" ")
        assert found == versions.get(f"{name} dev", found) or extra == "docs"
