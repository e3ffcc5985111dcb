"""The commands ``springback campaign``, ``query``, ``summary`` and ``refly``."""

from __future__ import annotations

import contextlib
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from springback.errors import InputError
from springback.interfaces.cli.common import (
    FIRST,
    OUT,
    force_option,
    have_figures,
    json_option,
    note,
    print_result,
    quiet_option,
    spinner,
)
from springback.interfaces.output import interrupts
from springback.interfaces.output.plain_text import plain_text

if TYPE_CHECKING:
    from springback.campaign.running import CampaignProgress

FOLDER = click.Path(path_type=Path, exists=False)
WAIT = "; a kind of flight that is new is compiled first, for a minute"
BETWEEN_LINES = 10.0
"""Seconds between two lines about progress where there is no terminal to draw a bar on."""


@click.command()
@click.argument("plan", type=click.Path(path_type=Path), required=False)
@click.argument("overrides", nargs=-1, metavar="[KEY=VALUE]...")
@click.option("--out", type=OUT, help="Folder for the rows: one campaign each.")
@click.option("--resume", is_flag=True, help="Go on with what is in the folder.")
@click.option("--dry-run", is_flag=True, help="Fly a few, and say what all would take.")
@click.option("--workers", type=int, help="Processes; by default as many as there are cores.")
@click.option("--chunk", type=int, help="Flights flown and kept together; by default at most 2000.")
@click.option(
    "--scheduler", metavar="ADDRESS", help="Fly on Dask: tls://HOST:8786 of its scheduler."
)
@click.option("--tls-ca", type=click.Path(path_type=Path), help="Of the cluster: its authority.")
@click.option("--tls-cert", type=click.Path(path_type=Path), help="Certificate to show there.")
@click.option("--tls-key", type=click.Path(path_type=Path), help="Its private key.")
@click.option(
    "--device", type=click.Choice(["cpu", "gpu"]), default="cpu", show_default=True,
    help="Where flights fly; gpu is an NVIDIA GPU of this machine.",
)  # fmt: skip
@json_option
@quiet_option
def campaign(
    plan: Path | None,
    overrides: tuple[str, ...],
    out: Path | None,
    resume: bool,
    dry_run: bool,
    workers: int | None,
    chunk: int | None,
    scheduler: str | None,
    tls_ca: Path | None,
    tls_cert: Path | None,
    tls_key: Path | None,
    device: Any,
    as_json: bool,
    quiet: bool,
) -> None:
    """Fly a campaign: all flights of a PLAN file, on all cores or on a cluster.

    Rows go to Parquet files in the folder as they come. Ctrl-C, a crash or a full disk loses only
    what was in the air: the same command with --resume goes on. The rows are the same, bit for
    bit, however they are cut into chunks and wherever they fly.

    \b
    springback campaign plan.toml --dry-run
    springback campaign plan.toml --out results
    springback campaign plan.toml samples=100000 seed=7 --out more
    springback campaign plan.toml --out results --resume
    springback query results "SELECT robot, avg(success) FROM flights GROUP BY robot"
    """
    from springback.campaign.errors import CampaignError
    from springback.campaign.running import run_campaign

    if plan is None and not (resume and out):
        raise InputError("PLAN is missing: a file such as plan.toml (or --resume with --out)")
    tls = _tls(scheduler, tls_ca, tls_cert, tls_key)
    with spinner("reading the plan", quiet):
        design = _design(plan, overrides, out)
    if dry_run:
        _foretold(design, workers, as_json, quiet)
        return
    if out is None:
        raise InputError("--out is missing: the folder to write to (or --dry-run)")
    again = _again(plan, overrides, out, scheduler, tls)
    interrupts.say(f"interrupted; what was flown is kept; go on by: {again}")
    try:
        with _told(quiet) as (tell, remark):
            flown = run_campaign(
                design, out, resume=resume, workers=workers, chunk=chunk, scheduler=scheduler,
                tls=tls, device=device, progress=tell, remark=remark,
            )  # fmt: skip
    except CampaignError as error:
        note(f"error: {error}", False)
        note(f"what was flown is kept; go on by: {again}", False)
        sys.exit(1)
    _finished(flown, out, as_json, quiet)


def _tls(
    scheduler: str | None, authority: Path | None, certificate: Path | None, key: Path | None
) -> Any:
    """Certificates for a cluster, if any are given; then all are."""
    if authority is None and certificate is None and key is None:
        return None
    if scheduler is None or authority is None or certificate is None or key is None:
        raise InputError("--tls-ca, --tls-cert and --tls-key belong together, and to --scheduler")
    from springback.campaign.cluster import Tls

    return Tls(authority, certificate, key)


def _design(plan: Path | None, overrides: tuple[str, ...], out: Path | None) -> Any:
    from springback.campaign.access import check_conditions
    from springback.campaign.design.layout import lay_out
    from springback.campaign.design.plan import read_plan
    from springback.campaign.store import stored_plan

    if plan is not None:
        read, source = read_plan(plan, overrides)
        design = lay_out(read, source)
        check_conditions(design, source)
        return design
    assert out is not None
    return lay_out(stored_plan(out), tried=False)


def _again(
    plan: Path | None, overrides: tuple[str, ...], out: Path, scheduler: str | None, tls: Any
) -> str:
    import shlex

    words = ["springback", "campaign", *([str(plan)] if plan else []), *overrides]
    words += ["--out", str(out), "--resume"]
    words += ["--scheduler", scheduler] if scheduler else []
    if tls is not None:
        given = {"ca": tls.authority, "cert": tls.certificate, "key": tls.key}
        words += [word for name, path in given.items() for word in (f"--tls-{name}", str(path))]
    return shlex.join(words)


def _finished(flown: Any, out: Path, as_json: bool, quiet: bool) -> None:
    sql = "SELECT robot, outcome, count(*) AS flights FROM flights GROUP BY ALL ORDER BY ALL"
    answer = flown.query(sql)
    if as_json:
        data = {"folder": str(out), "flights": flown.done, "outcomes": answer.as_dicts()}
        print_result(data, as_json)
    else:
        from springback.interfaces.output.tables import as_text

        print_result(as_text(answer.columns, answer.rows), as_json)
    note(f"{flown.done} flights in {out}; see springback summary {out}", quiet)


@contextlib.contextmanager
def _told(
    quiet: bool,
) -> Iterator[tuple[Callable[[CampaignProgress], None], Callable[[str], None]]]:
    """Progress as a bar on a terminal, else as a line now and then; remarks as lines of stderr."""
    from rich.console import Console

    console = Console(stderr=True)
    if console.is_terminal and not quiet:
        with _bar(console) as told:
            yield told
        return
    last = [-BETWEEN_LINES]

    def tell(now: CampaignProgress) -> None:
        if time.monotonic() - last[0] >= BETWEEN_LINES or now.done == now.flights:
            last[0] = time.monotonic()
            note(now.sentence() + ("" if now.rate or now.done == now.flights else WAIT), quiet)

    yield tell, lambda text: note(text, False)


@contextlib.contextmanager
def _bar(
    console: Any,
) -> Iterator[tuple[Callable[[CampaignProgress], None], Callable[[str], None]]]:
    from rich.progress import BarColumn, TextColumn, TimeElapsedColumn
    from rich.progress import Progress as Bars

    columns = (BarColumn(bar_width=24), TextColumn("{task.description}"), TimeElapsedColumn())
    with Bars(*columns, console=console, transient=True) as bars:
        task = bars.add_task(f"starting{WAIT}", total=1)

        def tell(now: CampaignProgress) -> None:
            said = now.sentence() if now.rate else None
            bars.update(task, completed=now.done, total=now.flights, description=said)

        def remark(text: str) -> None:
            console.print(plain_text(text), markup=False, highlight=False)

        yield tell, remark


def _foretold(design: Any, workers: int | None, as_json: bool, quiet: bool) -> None:
    """Say what a campaign would take."""
    from springback.campaign.cost_estimate import cost_estimate

    note("flying a few of its flights; kinds that are new are compiled first", quiet)
    with spinner("flying a few", quiet):
        coming = cost_estimate(design, workers)
    print_result(coming.as_dict() if as_json else coming.sentence(), as_json)


@click.command()
@click.argument("folder", type=FOLDER)
@click.argument("sql", required=False)
@click.option(
    "--format", "form", type=click.Choice(["table", "csv", "json", "markdown"]), default="table",
    show_default=True, help="Of what is printed.",
)  # fmt: skip
@click.option("--out", type=OUT, help="File instead: .parquet, .csv, .json or .md.")
@force_option
def query(folder: Path, sql: str | None, form: str, out: Path | None, force: bool) -> None:
    """Ask the campaign in FOLDER a question in SQL; the table is called flights.

    Without SQL all columns are listed, with units and meanings. Names with dots stand in double
    quotes. What did not happen, such as a touch, is NULL.

    \b
    springback query results
    springback query results "SELECT robot, avg(success), quantile_cont(recovery_time, 0.9)
                              FROM flights GROUP BY robot"
    springback query results "FROM flights WHERE NOT success" --out failures.csv
    """
    from springback.campaign.access import Campaign
    from springback.interfaces.output.tables import SUFFIXES, lines_of, write_answer

    known = Campaign(folder)
    if out is not None and out.suffix not in SUFFIXES and (out.suffix != ".parquet" or not sql):
        raise InputError(f"--out {out}: must end in .parquet, {', '.join(SUFFIXES)}")
    if out is not None and out.exists() and not force:
        raise InputError(f"--out {out}: already exists; give another, or --force")
    if out is not None and sql is not None and out.suffix == ".parquet":
        note(f"{known.save(sql, out)} rows written to {out}", False)
        return

    def taken(columns: list[str], stretches: Iterator[list[Any]]) -> int:
        if out is not None:
            return write_answer(columns, stretches, out)
        # Data for a program stay as they are; a terminal is not to be steered by them.
        clean = plain_text if form == "table" or _is_terminal() else str
        for line in lines_of(columns, stretches, form):
            click.echo(clean(line))
        return 0

    if sql is None:
        count = taken(["column", "unit", "meaning"], iter([_columns(known)]))
    else:
        count = known.stream(sql, taken)
    if out is not None:
        note(f"{count} rows written to {out}", False)


def _is_terminal() -> bool:
    return sys.stdout is not None and sys.stdout.isatty()


def _columns(known: Any) -> list[tuple[Any, ...]]:
    """Name, unit and meaning of every column."""
    from springback.campaign.columns import FLIGHT, RESULT, known_columns

    meanings = known_columns()
    rest = [name for name in meanings if name not in FLIGHT and name not in RESULT]
    names = [*FLIGHT, *known.about["units"], *RESULT, *rest]
    units = known.units
    return [
        (name, units[name], meanings.get(name, ("", "varied by the plan"))[1]) for name in names
    ]


@click.command()
@click.argument("folder", type=FOLDER)
@click.argument("row", type=int)
@click.option("--out", type=OUT, help="Folder for summary.json, trajectory.parquet, figures.")
@click.option("--no-figures", is_flag=True, help="Write no figures.")
@force_option
@json_option
@quiet_option
def refly(
    folder: Path,
    row: int,
    out: Path | None,
    no_figures: bool,
    force: bool,
    as_json: bool,
    quiet: bool,
) -> None:
    """Fly flight ROW of the campaign in FOLDER again, alone, with its whole trajectory.

    Every number is compared with the row, to the last bit; exit code 1 if any differs.

    \b
    springback query results "SELECT flight FROM flights WHERE outcome = 'hit_ground' LIMIT 3"
    springback refly results 1711 --out flight-1711
    """
    from springback.campaign.access import Campaign
    from springback.interfaces.output.folders import output_folder
    from springback.interfaces.reports.flight_files import FLIGHT_FILES, write_flight

    known = Campaign(folder)
    with spinner(FIRST, quiet):
        again = known.refly(row)
    if out is not None:
        with (
            output_folder(out, force=force, replaces=FLIGHT_FILES) as place,
            spinner("writing", quiet),
        ):
            figures = not no_figures and have_figures(quiet)
            names = [path.name for path in write_flight(again.flight, place, figures=figures)]
        note(f"written to {out}: {', '.join(names)}", quiet)
    if as_json:
        data = {"flight": row, "identical": not again.differences}
        found = {"differences": list(again.differences), **again.flight.summary()}
        print_result(data | found, as_json)
    else:
        print_result(repr(again.flight), as_json)
    if not again.differences:
        note(f"identical to row {row}: every number, to the last bit", quiet)
        return
    for line in again.differences:
        note(f"not as in row {row}: {line}", False)
    sys.exit(1)


@click.command()
@click.argument("folder", type=FOLDER)
@click.option("--out", type=OUT, help="Folder for summary.html, summary.json and figures.")
@click.option(
    "--map", "pairs", multiple=True, metavar="X,Y",
    help="Fields to draw success over; by default all pairs of the first four.",
)  # fmt: skip
@click.option("--scatter", is_flag=True, help="Success along what luck deals out, too.")
@click.option("--no-figures", is_flag=True, help="Write no figures and no page.")
@force_option
@json_option
@quiet_option
def summary(
    folder: Path,
    out: Path | None,
    pairs: tuple[str, ...],
    scatter: bool,
    no_figures: bool,
    force: bool,
    as_json: bool,
    quiet: bool,
) -> None:
    """Sum up the campaign in FOLDER: success, outcomes, quantiles, robot against robot.

    Shares have Wilson's intervals. Robots were dealt the same samples and luck, so they are
    compared pair by pair. A campaign that is still flying can be summed up, too.

    \b
    springback summary results
    springback summary results --out page --map speed,pitch
    """
    from springback.campaign.access import Campaign
    from springback.campaign.analysis.marginals import scale
    from springback.campaign.analysis.statistics import summary as summed_up
    from springback.interfaces.output.folders import output_folder
    from springback.interfaces.reports.campaign import summary_text, write_summary

    known = Campaign(folder)
    asked = []
    for text in pairs:
        x, sign, y = (part.strip() for part in text.partition(","))
        if not sign or not y or x == y:
            raise InputError(f"--map {text}: give two fields, such as speed,pitch")
        asked.append((scale(known, x, 2).name, scale(known, y, 2).name))
    if pairs and out is None:
        raise InputError("--map needs --out: the folder for the figures")
    with spinner("summing up", quiet):
        found = summed_up(known)
    if out is not None:
        figures = not no_figures and have_figures(quiet)
        with output_folder(out, force=force) as place, spinner("drawing", quiet):
            files = write_summary(found, place, pairs=asked, scatter=scatter, figures=figures)
            names = [path.name for path in files]
    print_result(found.as_dict() if as_json else summary_text(found), as_json)
    if out is not None:
        note(f"written to {out}: {', '.join(names)}", quiet)
