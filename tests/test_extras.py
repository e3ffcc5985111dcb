"""Extras: each is known to `doctor`, and its hint is a line that can be typed where springback is."""

from __future__ import annotations

import json
import re
import shlex
import sys
import tomllib
from importlib import metadata
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from click.testing import CliRunner

from springback import extras
from springback.errors import InputError
from springback.extras import OF_DEVELOPERS, install_line, needs, packages
from springback.interfaces.cli.app import cli
from springback.interfaces.output.diagnosis import MISSING, extras_found

ROOT = Path(__file__).parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
#: As pip writes it down for an installation from a folder.
FOLDER = {"url": f"file://{ROOT}", "dir_info": {}}


def installed_from(monkeypatch: pytest.MonkeyPatch, origin: Any) -> None:
    """Let springback have been installed from somewhere; None as from a package registry."""
    text = None if origin is None else json.dumps(origin)
    monkeypatch.setattr(
        metadata, "distribution", lambda name: SimpleNamespace(read_text=lambda _: text)
    )


def names_of(lines: list[str]) -> set[str]:
    return {re.match(r"[\w.-]+", line)[0] for line in lines}  # type: ignore[index]


def test_every_extra_of_the_project_is_listed() -> None:
    """All that a user may install, with all packages: so none that a command needs is left out."""
    listed = packages()
    wanted = {"all", *OF_DEVELOPERS} ^ PROJECT["optional-dependencies"].keys()
    assert listed.keys() - {""} == wanted
    assert {"web", "video", "cluster"} <= wanted
    for extra in wanted:
        assert set(listed[extra]) == names_of(PROJECT["optional-dependencies"][extra])
    assert set(listed[""]) == names_of(PROJECT["dependencies"])


def test_all_holds_every_extra_of_users() -> None:
    [line] = PROJECT["optional-dependencies"]["all"]
    assert set(line.partition("[")[2].strip("]").split(",")) == packages().keys() - {""}


def test_doctor_names_what_is_missing_and_how_to_install_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    known = metadata.version

    def without_uvicorn(name: str) -> str:
        if name == "uvicorn":
            raise metadata.PackageNotFoundError(name)
        return known(name)

    monkeypatch.setattr(metadata, "version", without_uvicorn)
    found = extras_found()
    assert found["web"]["uvicorn"] == MISSING
    assert found["web"]["to install"] == install_line("web")
    assert all("to install" not in versions for extra, versions in found.items() if extra != "web")
    done = CliRunner().invoke(cli, ["doctor"])
    assert done.exit_code == 0, done.output
    assert "uvicorn: missing" in done.stdout
    assert "[web]" in done.stdout


ORIGINS = [FOLDER, {**FOLDER, "dir_info": {"editable": True}}]


@pytest.mark.parametrize("origin", ORIGINS, ids=["wheel", "editable"])
def test_the_hint_leads_back_to_the_checkout(monkeypatch: pytest.MonkeyPatch, origin: Any) -> None:
    """springback is on no registry: `pip install 'springback[web]'` would lead nowhere, or worse."""
    installed_from(monkeypatch, origin)
    words = shlex.split(install_line("web"))
    assert words[:4] == [sys.executable, "-m", "pip", "install"]
    assert words[-1] == f"{ROOT}[web]"
    assert ("-e" in words) == bool(origin["dir_info"])


def test_the_hint_of_a_repository_names_the_repository(monkeypatch: pytest.MonkeyPatch) -> None:
    url = "https://example.org/springback.git"
    installed_from(monkeypatch, {"url": url, "vcs_info": {"vcs": "git", "commit_id": "0"}})
    assert shlex.split(install_line("web"))[-1] == f"springback[web] @ git+{url}"


@pytest.mark.parametrize("origin", [None, {"url": "file:///is/not/there"}], ids=["unknown", "gone"])
def test_without_a_checkout_the_hint_says_that_it_takes_one(
    monkeypatch: pytest.MonkeyPatch, origin: Any
) -> None:
    installed_from(monkeypatch, origin)
    assert install_line("web").endswith("install '.[web]' in the checkout of springback")


def test_a_missing_module_is_told_with_its_hint(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "uvicorn", None)
    with pytest.raises(InputError) as caught:
        needs("uvicorn", "web")
    assert str(caught.value) == f"this needs uvicorn, which is not installed: {install_line('web')}"


def test_nothing_tells_to_install_from_a_registry() -> None:
    """No package of that name is known there."""
    pages = [ROOT / "README.md", *(ROOT / "docs").rglob("*.md"), *(ROOT / "src").rglob("*.py")]
    for page in pages:
        if "_build" not in page.parts:
            assert not re.search(r"pip install ['\"]?springback", page.read_text()), page
    assert extras.EVERYTHING in PROJECT["optional-dependencies"]
