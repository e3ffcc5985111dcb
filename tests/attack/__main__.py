"""The table of attacks on results, stores, caches and commands: `make attack`.

Counts of cases are arguments; the seeds are fixed, so that a table can be made again.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import warnings
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

from attack.campaigns import CONDITIONS, ESCAPES, all_said
from attack.damage import cut_off, one_byte
from attack.interrupting import command, removed, timed, tried
from experiments.campaign.made_up import filled
from experiments.campaign.plans import THROW, plan
from springback.errors import InputError
from springback.experiments.campaign import ledger, store
from springback.experiments.campaign.design import laid_out
from springback.experiments.campaign.reading import Campaign, check_conditions
from springback.experiments.result import fly
from springback.interfaces.flight_files import write_flight
from springback.interfaces.saved import read_result

ROOT = Path(__file__).parents[2]
CAMPAIGN = """
name = "throws"
seed = 5
robots = ["arq", "quad"]
method = "latin-hypercube"
samples = {samples}
[scenario]
vehicle = "arq"
thrust = "hover"
world.obstacles = [{{ type = "wall", distance = "1 m", surface = "wall" }}]
start = {{ position = ["0.6 m", 0, "1 m"], velocity = [2.0, 0, 0] }}
simulation.duration = 0.3
[[vary]]
field = "start.velocity.0"
name = "speed"
from = "1 m/s"
to = "3 m/s"
"""


class Row(NamedTuple):
    """One line of the table."""

    what: str
    tried: int
    tracebacks: int = 0
    hangs: int = 0
    wrong: int = 0
    remark: str = ""


def of(what: str, found: Counter[str], remark: str = "") -> Row:
    """A line of what was said of damage."""
    told = ", ".join(f"{count} {word}" for word, count in sorted(found.items()))
    wrong = found["wrong"] + found["several lines"]
    return Row(what, found.total(), found["traceback"], 0, wrong, remark or told)


# -- files ----------------------------------------------------------------------------------------


def damaged_campaigns(folder: Path, cases: int) -> Iterator[Row]:
    filled(folder / "c")
    part = ledger.file_of(10)
    for name in (part, ledger.NAME, store.ABOUT, store.PLAN):
        what = "a part" if name == part else name
        yield of(f"one byte of {what} changed", one_byte(folder / "c", name, all_said, cases))
    for name in (part, store.ABOUT, store.PLAN):
        what = "a part" if name == part else name
        yield of(f"{what} cut off", cut_off(folder / "c", name, all_said, cases // 4))


def damaged_results(folder: Path, cases: int) -> Iterator[Row]:
    (folder / "f").mkdir()
    flight = fly({**THROW, "reference": {"type": "hold"}, "simulation": {"duration": 0.2}})
    write_flight(flight, folder / "f", figures=False)

    def said(place: Path) -> Any:
        read = read_result(place)
        columns = {name: values.tobytes() for name, values in (read.columns | read.diary).items()}
        return read.scenario, read.outcome, read.measures, read.units, columns

    for name in ("summary.json", "trajectory.parquet", "diary.parquet"):
        yield of(f"one byte of {name} changed", one_byte(folder / "f", name, said, cases))
        yield of(f"{name} cut off", cut_off(folder / "f", name, said, cases // 4))


# -- SQL ------------------------------------------------------------------------------------------


def questions(folder: Path) -> Iterator[Row]:
    for name in "ab":
        filled(folder / name)
    (folder / "secret").write_text("x\n1\n")
    files = {
        "secret": folder / "secret", "target": folder / "target",
        "part": folder / "a" / ledger.file_of(0), "other": folder / "b" / ledger.file_of(0),
    }  # fmt: skip
    names = {name: str(path) for name, path in files.items()}
    before = contents(folder)
    campaign = Campaign(folder / "a")
    asks: list[Callable[[str], Any]] = [
        campaign.query, campaign.arrays, campaign.count,
        lambda sql: campaign.save(sql, folder / "out.parquet"),
        lambda sql: campaign.stream(sql, lambda _, rows: list(rows)),
    ]  # fmt: skip
    yield refused("SQL that reaches outside", folder, before, [
        (ask, sql.format_map(names)) for ask in asks for sql in ESCAPES
    ])  # fmt: skip
    given: list[tuple[Callable[[Any], Any], Any]] = []
    for text in CONDITIONS:
        condition = text.format_map(names)
        for entry in ({"success": condition}, {"keep": {"where": condition, "most": 1}}):
            given.append((lambda entry: check_conditions(laid_out(plan(**entry))), entry))
    yield refused("conditions that reach outside", folder, before, given)


def contents(folder: Path) -> dict[Path, bytes]:
    return {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def refused(
    what: str,
    folder: Path,
    before: dict[Path, bytes],
    cases: list[tuple[Callable[[Any], Any], Any]],
) -> Row:
    tracebacks = wrong = 0
    for ask, given in cases:
        try:
            ask(given)
            wrong += 1
            print("answered", given)
        except InputError:
            pass
        except Exception as error:
            tracebacks += 1
            print("traceback", given, error)
        if contents(folder) != before:
            wrong += 1
            print("written", given)
    return Row(what, len(cases), tracebacks, 0, wrong, "all refused" if not wrong else "")


# -- caches and homes -----------------------------------------------------------------------------


def caches(folder: Path) -> Row:
    """States of the kernel cache and of HOME, each met by `springback fly`."""
    scenario = folder / "s.toml"
    scenario.write_text((ROOT / "examples/arq_wall.toml").read_text())
    home = folder / "home"
    words = ["fly", "s.toml", "--out", "o", "--no-figures", "--force"]

    def flown(**environment: str) -> subprocess.CompletedProcess[str]:
        given = {**os.environ, "HOME": str(home), **environment}
        given = {name: value for name, value in given.items() if value != "unset"}
        given.setdefault("XDG_CACHE_HOME", "")
        return subprocess.run(
            command(*words), cwd=folder, env=given, capture_output=True, text=True, check=False,
            timeout=600,
        )  # fmt: skip

    home.mkdir()
    before = os.environ.pop("SPRINGBACK_CACHE_DIR", None)
    first = flown()
    assert first.returncode == 0, first.stderr
    kept = sorted(home.rglob("*.kernel"))
    original = {path: path.read_bytes() for path in kept}
    bad: list[str] = []
    count = 0

    def meet(name: str, **environment: str) -> None:
        nonlocal count
        count += 1
        done = flown(**environment)
        print(f"{name}: {done.returncode}", file=sys.stderr, flush=True)
        lines = [line for line in done.stderr.splitlines() if line]
        if done.returncode or done.stdout != first.stdout or "Traceback" in done.stderr:
            bad.append(name)
            print("cache", name, done.returncode, done.stderr[-400:])
        elif len([line for line in lines if line.startswith("warning")]) > len(kept) + 1:
            bad.append(name)
            print("cache", name, "says too much", lines)

    def mended() -> None:
        for path, data in original.items():
            if path.is_dir() and not path.is_symlink():
                shutil.rmtree(path)
            path.unlink(missing_ok=True)
            path.write_bytes(data)
            path.chmod(0o644)

    luck = random.Random(3)
    harms: dict[str, Callable[[Path, bytes], Any]] = {
        "empty": lambda path, _: path.write_bytes(b""),
        "one byte": lambda path, _: path.write_bytes(b"\0"),
        "cut off": lambda path, data: path.write_bytes(data[: len(data) // 2]),
        "garbage": lambda path, data: path.write_bytes(luck.randbytes(len(data))),
        "garbage at the end": lambda path, data: path.write_bytes(data[:-100] + bytes(100)),
        "a bit of the code": lambda path, data: path.write_bytes(
            data[: len(data) // 2] + bytes([data[len(data) // 2] ^ 1]) + data[len(data) // 2 + 1 :]
        ),
        "missing": lambda path, _: path.unlink(),
        "a folder": lambda path, _: (path.unlink(), path.mkdir()),
        "a dangling link": lambda path, _: (path.unlink(), path.symlink_to("nowhere")),
        "writable by all": lambda path, _: path.chmod(0o666),
    }  # fmt: skip
    if os.getuid() == 0:
        harms["another's"] = lambda path, _: os.chown(path, 65534, 65534)
    else:
        harms["not readable"] = lambda path, _: path.chmod(0)
    for name, harm in harms.items():
        for path, data in original.items():
            harm(path, data)
        meet(name)
        mended()
    folders = {"kernels": kept[0].parent.parent, "springback": kept[0].parents[2]}
    for name, path in folders.items():
        aside = path.with_name("aside")
        path.rename(aside)
        path.write_text("a file in the way")
        meet(f"a file in place of {name}")
        path.unlink()
        aside.rename(path)
    meet("a cache that is a device", SPRINGBACK_CACHE_DIR="/dev/null")
    meet("a cache with ~", SPRINGBACK_CACHE_DIR="~/other")
    meet("a cache with ~ of nobody", SPRINGBACK_CACHE_DIR=str(folder / "~nobody"))
    meet("an empty name of a cache", SPRINGBACK_CACHE_DIR="")
    meet("a cache that is full", SPRINGBACK_CACHE_DIR="/proc")
    for name, value in {
        "HOME missing": str(folder / "nohome"), "HOME a device": "/dev/null", "HOME unset": "unset",
        "HOME empty": "", "HOME a file": str(scenario), "HOME not writable": "/proc",
        "HOME not a path": "\x01",
    }.items():  # fmt: skip
        meet(name, HOME=value, SPRINGBACK_CACHE_DIR=str(folders["springback"]))
    if before is not None:
        os.environ["SPRINGBACK_CACHE_DIR"] = before
    return Row(
        "states of caches and HOME", count, len(bad), 0, 0, f"{count - len(bad)} of {count} fine"
    )


# -- commands that are ended ----------------------------------------------------------------------


def interrupts(folder: Path, times: int) -> Iterator[Row]:
    (folder / "s.toml").write_text((ROOT / "examples/arq_wall.toml").read_text())
    (folder / "plan.toml").write_text(CAMPAIGN.format(samples=400))
    for words in (
        ["fly", "s.toml", "--out", "A", "-q"],
        ["campaign", "plan.toml", "--out", "w", "-q"],
    ):
        timed(words, folder)
    tries = {
        "fly": (["fly", "s.toml", "--out", "out"], "out"),
        "campaign": (["campaign", "plan.toml", "--out", "c", "--chunk", "40"], "c"),
        "query": (["query", "w", "FROM flights", "--out", "q.csv"], "q.csv"),
        "summary": (["summary", "w", "--out", "out"], "out"),
        "view": (["view", "A", "--export", "v.html"], "v.html"),
    }
    for name, (words, out) in tries.items():
        found = tried(words, folder, out, times, seed=len(name))
        faults = found.total() - found["interrupted"] - found["done"]
        told = ", ".join(f"{count} {word}" for word, count in sorted(found.items()))
        yield Row(f"Ctrl-C at any instant: {name}", found.total(), found["traceback"], 0,
                  faults - found["traceback"], told)  # fmt: skip


def kills(folder: Path, times: int) -> Row:
    """kill -9 at any instant; what is resumed is what would have been flown."""
    (folder / "plan.toml").write_text(CAMPAIGN.format(samples=400))
    words = ["campaign", "plan.toml", "--workers", "2", "--chunk", "40", "-q", "--out"]
    whole = timed([*words, "whole"], folder)
    rows, luck, wrong = (
        Campaign(folder / "whole").query("FROM flights ORDER BY flight"),
        random.Random(9),
        0,
    )
    for _ in range(times):
        with subprocess.Popen(
            command(*words, "c"), cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            start_new_session=True,
        ) as process:  # fmt: skip
            with contextlib.suppress(subprocess.TimeoutExpired):
                process.wait(luck.uniform(0.2, 1.0) * whole)
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
        done = subprocess.run(
            command(*words, "c", "--resume"),
            cwd=folder,
            capture_output=True,
            text=True,
            check=False,
        )
        again = Campaign(folder / "c")
        if done.returncode or again.query("FROM flights ORDER BY flight") != rows:
            wrong += 1
            print("kill", done.stderr[-400:])
        wrong += any("draft" in path.name for path in (folder / "c").rglob("*"))
        removed(folder / "c")
    return Row("kill -9 of a campaign, resumed", times, 0, 0, wrong, f"{len(rows.rows)} rows each")


def bits(folder: Path) -> Row:
    """The same rows on other processors, in other chunks, by other numbers of workers."""
    (folder / "plan.toml").write_text(CAMPAIGN.format(samples=100))
    settings: dict[str, tuple[dict[str, str], list[str]]] = {
        "as it is": ({}, []), "one worker": ({}, ["--workers", "1"]),
        "chunks of 7": ({}, ["--chunk", "7"]), "chunks of 199": ({}, ["--chunk", "199"]),
        "generic processor": ({"NUMBA_CPU_NAME": "generic", "NUMBA_CPU_FEATURES": ""}, []),
    }  # fmt: skip
    found = []
    for k, (environment, words) in enumerate(settings.values()):
        out = f"b{k}"
        given = {**os.environ, **environment}
        done = subprocess.run(
            command("campaign", "plan.toml", "--out", out, "-q", *words), cwd=folder, env=given,
            capture_output=True, text=True, check=True,
        )  # fmt: skip
        assert done.returncode == 0
        found.append(Campaign(folder / out).query("FROM flights ORDER BY flight"))
    different = sum(
        mine != first
        for other in found
        for mine, first in zip(other.rows, found[0].rows, strict=True)
    )
    count = len(found) * len(found[0].rows)
    return Row("the same rows in other settings", count, 0, 0, different, f"{len(found)} settings")


def fuzzed() -> str:
    """What `make fuzz` says, where there is such a target."""
    done = subprocess.run(
        ["make", "--no-print-directory", "fuzz"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    if "No rule to make target" in done.stderr:
        return "make fuzz: there is no such target here"
    return f"make fuzz: exit code {done.returncode}\n{done.stdout.strip()}"


def main() -> None:
    """Print the table; leave with 1 if anything is not as it should be."""
    parser = argparse.ArgumentParser(prog="make attack", description=__doc__)
    parser.add_argument("--cases", type=int, default=400, help="bytes of each file")
    parser.add_argument("--times", type=int, default=40, help="Ctrl-C for each of five commands")
    parser.add_argument("--kills", type=int, default=10)
    parser.add_argument("--only", help="part of a line's name")
    parser.add_argument("--no-fuzz", action="store_true")
    given = parser.parse_args()
    warnings.simplefilter("ignore")
    begun, rows = time.monotonic(), list[Row]()
    sections: dict[str, Callable[[Path], Any]] = {
        "campaigns damaged": lambda folder: damaged_campaigns(folder, given.cases),
        "results damaged": lambda folder: damaged_results(folder, given.cases),
        "questions": questions,
        "caches": lambda folder: [caches(folder)],
        "interrupts": lambda folder: interrupts(folder, given.times),
        "kills": lambda folder: [kills(folder, given.kills)],
        "bits": lambda folder: [bits(folder)],
    }
    head = f"{'what':<44}{'tried':>7}{'tracebacks':>12}{'hangs':>7}{'wrong':>7}  remark"
    print(head, flush=True)
    for name, section in sections.items():
        if given.only and given.only not in name:
            continue
        with tempfile.TemporaryDirectory() as folder:
            said = io.StringIO()
            with contextlib.redirect_stdout(said):
                found = list(section(Path(folder)))
        rows += found
        for row in found:
            print(
                f"{row.what:<44}{row.tried:>7}{row.tracebacks:>12}{row.hangs:>7}{row.wrong:>7}  "
                f"{row.remark}",
                flush=True,
            )
        if said.getvalue():
            print(said.getvalue(), file=sys.stderr)
    if not given.no_fuzz and not given.only:
        print(fuzzed())
    print(f"{sum(row.tried for row in rows)} cases in {time.monotonic() - begun:.0f} s")
    sys.exit(any(row.tracebacks or row.hangs or row.wrong for row in rows))


if __name__ == "__main__":
    main()
