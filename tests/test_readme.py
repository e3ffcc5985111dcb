"""README from top to bottom, as a newcomer types it: in an empty folder, line by line, as written.

Only what belongs into the checkout is left out: `make` and the installation itself.
"""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import time
import tomllib
import urllib.request
from pathlib import Path

import pytest

from builders.cases import nonempty
from builders.interrupts import heed_interrupts
from builders.typed_lines import Typed, typed
from springback.extras import packages
from springback.interfaces.cli.common import FIRST

ROOT = Path(__file__).parents[1]
README = ROOT / "README.md"
#: Programs that are run in the checkout; what they do is tested by running the tests at all.
IN_THE_CHECKOUT = ("make", "pip")
#: Commands that serve a page until they are stopped.
SERVES = ("view", "lab")
#: Commands in sentences that can be typed as they stand.
IN_SENTENCES = ("show", "doctor")
#: What `make run` does first, for some minutes.
COMPILES_ALL = "springback doctor --compile"
#: Programs that fly many kinds of flight, and compile each.
MANY_KINDS = "springback study "
#: Of one line; compiling on a busy machine included [s].
PATIENCE = 1500.0


def lines() -> list[Typed]:
    """What a reader types, in order."""
    found = []
    for this in typed(README):
        words = this.text.split()
        if this.kind == "shell" and words[0] in IN_THE_CHECKOUT:
            continue
        if (this.kind == "words" and words[1] not in IN_SENTENCES) or this.text == COMPILES_ALL:
            continue
        found.append(this)
    return found


def environment() -> dict[str, str]:
    """With springback on the path, and a browser that opens nothing."""
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    return {**os.environ, "PATH": path, "BROWSER": "true"}


def served(command: str, folder: Path) -> None:
    """Start a command that serves, look at its page, and end it as a user does."""
    process = subprocess.Popen(
        ["bash", "-c", f"exec {command}"], cwd=folder, env=environment(), text=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, preexec_fn=heed_interrupts,
    )  # fmt: skip
    told = []
    try:
        assert process.stdout is not None
        for line in process.stdout:
            told.append(line)
            address = re.search(r"http://127\.0\.0\.1:\d+\S*", line)
            if address:
                break
        else:
            raise AssertionError(f"{command}: {''.join(told)}")
        with urllib.request.urlopen(address[0], timeout=60.0) as page:
            assert page.status == 200
            assert b"springback" in page.read()
        time.sleep(0.2)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60.0)
        assert process.returncode in (0, 130), process.returncode
    finally:
        process.kill()
        process.wait()


def followed(this: Typed, folder: Path) -> None:
    """Do what one line says."""
    if this.kind == "toml":
        (folder / this.saved_as).write_text(this.text)
        return
    if this.kind == "shell" and this.text.split()[1] in SERVES:
        served(this.text.partition(" #")[0].strip(), folder)
        return
    command = (
        [sys.executable, "-c", this.text] if this.kind == "python" else ["bash", "-c", this.text]
    )
    done = subprocess.run(
        command, cwd=folder, env=environment(), capture_output=True, text=True, timeout=PATIENCE,
        check=False,
    )  # fmt: skip
    assert done.returncode == 0, f"README.md:{this.line}: {this.text}\n{done.stdout}{done.stderr}"
    assert "Traceback" not in done.stderr, done.stderr


@pytest.mark.timeout(3 * PATIENCE)
def test_readme_runs_from_top_to_bottom_in_an_empty_folder(tmp_path: Path) -> None:
    """Every line but studies, in order, with the files that the lines before it left."""
    todo = [this for this in lines() if not this.text.startswith(MANY_KINDS)]
    commands = [this.text.split()[1] for this in todo if this.kind == "shell"]
    assert {"examples", "fly", "map", "view", "animate", "lab"} <= set(commands)
    assert {"campaign", "query", "summary", "refly"} <= set(commands)
    assert sum(this.kind == "python" for this in todo) == 1
    for this in todo:
        followed(this, tmp_path)
    for file in ("results/summary.json", "collision.gif", "many/plan.json", "page/summary.html"):
        assert (tmp_path / file).is_file(), file


@pytest.mark.timeout(3 * PATIENCE)
def test_studies_of_the_readme_run_in_an_empty_folder(tmp_path: Path) -> None:
    """Each line, which needs no file of another."""
    todo = nonempty(this for this in lines() if this.text.startswith(MANY_KINDS))
    for this in todo:
        followed(this, tmp_path)
        assert (tmp_path / this.text.partition(" --out ")[2].split()[0]).is_dir()


@pytest.mark.parametrize("page", ["README.md", "docs/start.md"])
def test_no_two_lines_of_a_page_write_to_the_same_place(page: str) -> None:
    """A campaign refuses a folder with a flight in it, so whoever types them all would be stuck."""
    places = [
        place for this in typed(ROOT / page) if this.kind == "shell"
        for place in re.findall(r" --out (\S+)", this.text)
    ]  # fmt: skip
    assert len(places) > 5
    assert sorted(places) == sorted(set(places))


def test_one_line_installs_all_that_follows() -> None:
    """It comes before the first command that needs it, and its extra holds all others."""
    text = README.read_text()
    [line] = re.findall(r"^    (pip install .*)$", text, re.M)
    assert line == "pip install '.[all]'"
    assert text.index(line) < text.index("    springback ")
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"][
        "optional-dependencies"
    ]
    assert extras["all"] == [f"springback[{','.join(x for x in extras if x in packages())}]"]


def test_pages_and_spinner_tell_the_same_of_compiling() -> None:
    """A pilot takes longer, which whoever waits for it has to know: 10.9 and 19 s on two cores."""
    pages = [(ROOT / page).read_text() for page in ("README.md", "docs/start.md")]
    for text in (*pages, FIRST):
        [said] = re.findall(r"[^.]*\b10 s\b[^.]*", " ".join(text.split()))
        assert "with a pilot" in said
        assert "20 s to a minute" in said


@pytest.mark.parametrize("name", ["toml", "py"])
def test_examples_are_written_whole(tmp_path: Path, name: str) -> None:
    """All that the repository has, byte for byte; never over a folder that is there already."""
    words = [sys.executable, "-m", "springback", "examples"]
    done = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    shipped = sorted((ROOT / "examples").glob(f"*.{name}"))
    written = sorted((tmp_path / "examples").glob(f"*.{name}"))
    assert [path.name for path in written] == [path.name for path in shipped]
    for here, there in zip(written, shipped, strict=True):
        assert here.read_bytes() == there.read_bytes()
    again = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert again.returncode == 2
    assert "is not empty" in again.stderr
