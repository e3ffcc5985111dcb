"""The table of attacks on results, stores, caches and commands: `make attack`.

Counts of cases are arguments; the seeds are fixed, so that a table can be made again.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
import warnings
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from attack.caches import caches
from attack.campaigns import CONDITIONS, ESCAPES, all_said
from attack.corners import IMPACT, PILOTED, corners, is_flown
from attack.damage import cut_off, one_byte
from attack.interrupting import COMMANDS, command, prepared, removed, timed, tried
from attack.table import Row
from builders.campaign_folders import filled
from builders.plans import THROW, plan
from springback.campaign import manifest, store
from springback.campaign.access import Campaign
from springback.campaign.design.layout import lay_out
from springback.campaign.plan_check import check_conditions
from springback.errors import InputError
from springback.interfaces.reports.flight_files import write_flight
from springback.results.flight import fly
from springback.results.saved import load

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


def of(what: str, found: Counter[str], remark: str = "") -> Row:
    """A line of what was said of damage."""
    told = ", ".join(f"{count} {word}" for word, count in sorted(found.items()))
    wrong = found["wrong"] + found["several lines"]
    return Row(what, found.total(), found["traceback"], 0, wrong, remark or told)


# -- files ----------------------------------------------------------------------------------------


def damaged_campaigns(folder: Path, cases: int) -> Iterator[Row]:
    filled(folder / "c")
    part = manifest.file_of(10)
    for name in (part, manifest.NAME, store.METADATA, store.PLAN):
        what = "a part" if name == part else name
        yield of(f"one byte of {what} changed", one_byte(folder / "c", name, all_said, cases))
    for name in (part, store.METADATA, store.PLAN):
        what = "a part" if name == part else name
        yield of(f"{what} cut off", cut_off(folder / "c", name, all_said, cases // 4))


def damaged_results(folder: Path, cases: int) -> Iterator[Row]:
    (folder / "f").mkdir()
    flight = fly({**THROW, "reference": {"type": "hold"}, "simulation": {"duration": 0.2}})
    write_flight(flight, folder / "f", figures=False)

    def said(place: Path) -> Any:
        read = load(place)
        columns = {
            name: values.tobytes() for name, values in (read.columns | read.telemetry).items()
        }
        return read.scenario, read.outcome, read.measures, read.units, columns

    for name in ("summary.json", "trajectory.parquet", "telemetry.parquet"):
        yield of(f"one byte of {name} changed", one_byte(folder / "f", name, said, cases))
        yield of(f"{name} cut off", cut_off(folder / "f", name, said, cases // 4))


# -- SQL ------------------------------------------------------------------------------------------


def questions(folder: Path) -> Iterator[Row]:
    for name in "ab":
        filled(folder / name)
    (folder / "secret").write_text("x\n1\n")
    files = {
        "secret": folder / "secret", "target": folder / "target",
        "part": folder / "a" / manifest.file_of(0), "other": folder / "b" / manifest.file_of(0),
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
            given.append((lambda entry: check_conditions(lay_out(plan(**entry))), entry))
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


# -- commands that are ended ----------------------------------------------------------------------


def interrupts(folder: Path, times: int, only: str) -> Iterator[Row]:
    prepared(folder, CAMPAIGN.format(samples=400))
    for name, given in COMMANDS.items():
        if only not in ("", name):
            continue
        found = tried(given, folder, times, seed=len(name))
        faults = found.total() - found["interrupted"] - found["done"]
        told = ", ".join(f"{count} {word}" for word, count in sorted(found.items()))
        yield Row(f"Ctrl-C at any instant: {name}", found.total(), found["traceback"], found["hang"],
                  faults - found["traceback"] - found["hang"], told)  # fmt: skip


def all_corners() -> Row:
    """Every number of a scenario at zero, a thousand times larger and at 1e30, flown."""
    tracebacks = count = 0
    for tables in (IMPACT, PILOTED):
        for corner in corners(tables):
            count += 1
            try:
                with warnings.catch_warnings():
                    warnings.simplefilter("error")
                    is_flown(tables, corner)
            except Exception as error:
                tracebacks += 1
                print("corner", corner, type(error).__name__, error)
    return Row("corners of every setting flown", count, tracebacks)


def kills(folder: Path, times: int) -> Row:
    """kill -9 at any instant; what is resumed is what would have been flown."""
    (folder / "plan.toml").write_text(CAMPAIGN.format(samples=400))
    words = ("campaign", "plan.toml", "--workers", "2", "--chunk", "40", "-q", "--out")
    whole = timed((*words, "whole"), folder)
    rows, noise_stream, wrong = (
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
                process.wait(noise_stream.uniform(0.2, 1.0) * whole)
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
    parser.add_argument("--times", type=int, default=200, help="Ctrl-C for each command")
    parser.add_argument("--kills", type=int, default=10)
    parser.add_argument("--only", help="part of a section's name")
    parser.add_argument("--command", default="", help="the only one to interrupt")
    parser.add_argument("--no-fuzz", action="store_true")
    given = parser.parse_args()
    warnings.simplefilter("ignore")
    begun, rows = time.monotonic(), list[Row]()
    sections: dict[str, Callable[[Path], Any]] = {
        "campaigns damaged": lambda folder: damaged_campaigns(folder, given.cases),
        "results damaged": lambda folder: damaged_results(folder, given.cases),
        "questions": questions,
        "caches": lambda folder: [caches(folder)],
        "interrupts": lambda folder: interrupts(folder, given.times, given.command),
        "kills": lambda folder: [kills(folder, given.kills)],
        "bits": lambda folder: [bits(folder)],
        "corners": lambda _: [all_corners()],
    }
    head = f"{'what':<44}{'tried':>7}{'tracebacks':>12}{'hangs':>7}{'wrong':>7}  remark"
    print(head, flush=True)
    for name, section in sections.items():
        if given.only and given.only not in name:
            continue
        said = io.StringIO()
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(said):
            for row in section(Path(folder)):
                rows.append(row)
                print(
                    f"{row.what:<44}{row.tried:>7}{row.tracebacks:>12}{row.hangs:>7}"
                    f"{row.wrong:>7}  {row.remark}",
                    file=sys.__stdout__,
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
