"""The commands ``springback campaign``, ``query``, ``summary`` and ``refly``."""

from __future__ import annotations

import contextlib
import shlex
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from springback.errors import InputError
from springback.interfaces.cli.common import (
    FIRST,
    PATH,
    Output,
    output_options,
    say,
)
from springback.interfaces.cli.completion import ScenarioPath, complete_setting
from springback.interfaces.output import interrupts
from springback.interfaces.output.plain_text import plain_text
from springback.interfaces.output.progress_lines import CampaignLines

if TYPE_CHECKING:
    from springback.campaign.access import Campaign
    from springback.campaign.running import CampaignProgress


@click.command()
@click.argument("plan", type=ScenarioPath(), required=False)
@click.argument(
    "overrides", nargs=-1, metavar="[KEY=VALUE]...", shell_complete=complete_setting(plan=True)
)
@click.option(
    "--with", "overlay", type=ScenarioPath(), metavar="OVERLAY",
    help="Overlay the values of an identified.toml on the scenario.",
)  # fmt: skip
@click.option("--resume", is_flag=True, help="Continue the campaign in --out.")
@click.option("--dry-run", is_flag=True, help="Fly a few; estimate time and disk space of all.")
@click.option("--workers", type=int, help="Number of processes; by default one per core.")
@click.option("--chunk", type=int, help="Flights stored together; by default at most 2000.")
@click.option("--scheduler", metavar="ADDRESS", help="Fly on a Dask cluster, at tls://HOST:8786.")
@click.option("--tls-ca", type=PATH, help="Certificate of the cluster's CA.")
@click.option("--tls-cert", type=PATH, help="Your own certificate.")
@click.option("--tls-key", type=PATH, help="Private key of that certificate.")
@click.option(
    "--device", type=click.Choice(["cpu", "gpu"]), default="cpu", show_default=True,
    help="Device to fly on; gpu is an NVIDIA GPU in this machine.",
)  # fmt: skip
@output_options("Folder for the rows of one campaign.", "as_json", "quiet", required=False)
def campaign(
    plan: Path | None,
    overrides: tuple[str, ...],
    overlay: Path | None,
    resume: bool,
    dry_run: bool,
    workers: int | None,
    chunk: int | None,
    scheduler: str | None,
    tls_ca: Path | None,
    tls_cert: Path | None,
    tls_key: Path | None,
    device: Any,
    output: Output,
) -> None:
    """Fly a campaign: all flights of a PLAN file, on all cores or on a cluster.

    Rows are written to Parquet files as flights are completed. Ctrl-C, a crash or a full disk
    loses only unfinished chunks: the same command with --resume continues. The rows are the same,
    bit for bit, whatever the number of workers, the chunk size and the machine.

    \b
    springback campaign plan.toml --dry-run
    springback campaign plan.toml --out results
    springback campaign plan.toml samples=100000 seed=7 --out more
    springback campaign plan.toml --with fitted/identified.toml --out identified
    springback campaign plan.toml --out results --resume
    springback query results "SELECT robot, avg(success) FROM flights GROUP BY robot"
    """
    from springback.campaign.errors import CampaignError
    from springback.campaign.running import run_campaign

    out = output.out
    if plan is None and not (resume and out):
        raise InputError("PLAN is missing: a file such as plan.toml (or --resume with --out)")
    tls = _tls(scheduler, tls_ca, tls_cert, tls_key)
    laid = [] if overlay is None else _laid_over(overlay, plan)
    with output.spinner("reading the plan"):
        design = _design(plan, (*laid, *overrides), out)
    of_vehicle = [word for word in laid if word.startswith("scenario.vehicle.")]
    if of_vehicle and design.plan.robots:
        raise InputError(
            f"--with {overlay}: sets {of_vehicle[0].partition('=')[0].removeprefix('scenario.')}, "
            "but the robots of the plan bring vehicles of their own"
        )
    if dry_run:
        _print_cost(design, workers, output)
        return
    if out is None:
        raise InputError("--out is missing: the folder to write to (or --dry-run)")
    again = shlex.join(["springback", *sys.argv[1:], *([] if resume else ["--resume"])])
    interrupts.say(f"interrupted; completed flights are saved; resume with: {again}")

    try:
        with _progress(output) as (show, remark):

            def progress(now: CampaignProgress) -> None:
                saved = f"{now.done} of {now.flights} flights are saved"
                interrupts.say(f"interrupted; {saved}; resume with: {again}")
                show(now)

            flown = run_campaign(
                design, out, resume=resume, workers=workers, chunk=chunk, scheduler=scheduler,
                tls=tls, device=device, progress=progress, remark=remark,
            )  # fmt: skip
    except CampaignError as error:
        say(f"error: {error}")
        say(f"completed flights are saved; resume with: {again}")
        sys.exit(1)
    _report(flown, output)


def _laid_over(overlay: Path, plan: Path | None) -> list[str]:
    """Overrides of a plan by which an overlay is laid over its scenario."""
    from springback.scenario.overrides import overlay_words

    if plan is None:
        raise InputError("--with: needs a PLAN; a campaign that is resumed has its values already")
    return [f"scenario.{word}" for word in overlay_words(overlay)]


def _tls(
    scheduler: str | None, authority: Path | None, certificate: Path | None, key: Path | None
) -> Any:
    """Certificates for a cluster; None if none are given."""
    if authority is None and certificate is None and key is None:
        return None
    if scheduler is None or authority is None or certificate is None or key is None:
        raise InputError("--tls-ca, --tls-cert and --tls-key belong together, with --scheduler")
    from springback.campaign.cluster import Tls

    return Tls(authority, certificate, key)


def _design(plan: Path | None, overrides: tuple[str, ...], out: Path | None) -> Any:
    from springback.campaign.design.layout import lay_out
    from springback.campaign.design.plan import read_plan
    from springback.campaign.plan_check import check_conditions
    from springback.campaign.store import stored_plan

    if plan is not None:
        read, source = read_plan(plan, overrides)
        design = lay_out(read, source)
        check_conditions(design, source)
        return design
    assert out is not None
    return lay_out(stored_plan(out), tried=False)


def _report(flown: Any, output: Output) -> None:
    from springback.interfaces.output.no_contact import (
        pierced_lines,
        pressing_line,
        untouched_line,
    )
    from springback.interfaces.output.tables import as_text

    sql = "SELECT robot, outcome, count(*) AS flights FROM flights GROUP BY ALL ORDER BY ALL"
    answer = flown.query(sql)
    data = {"folder": str(output.out), "flights": flown.done, "outcomes": answer.as_dicts()}
    output.print(data, as_text(answer.columns, answer.rows))
    for line in filter(None, (untouched_line(flown), pressing_line(flown), *pierced_lines(flown))):
        output.note(line)
    output.note(f"{flown.done} flights in {output.out}; see springback summary {output.out}")


@contextlib.contextmanager
def _progress(
    output: Output,
) -> Iterator[tuple[Callable[[CampaignProgress], None], Callable[[str], None]]]:
    """Progress as a bar on a terminal, else as lines at intervals; remarks as lines on stderr."""
    from rich.console import Console

    console = Console(stderr=True)
    if console.is_terminal and not output.quiet:
        with _bar(console) as both:
            yield both
        return
    lines = CampaignLines(output.note)
    with lines.looking():
        yield lines.show, say


@contextlib.contextmanager
def _bar(
    console: Any,
) -> Iterator[tuple[Callable[[CampaignProgress], None], Callable[[str], None]]]:
    from rich.progress import BarColumn, TextColumn, TimeElapsedColumn
    from rich.progress import Progress as Bars

    columns = (BarColumn(bar_width=24), TextColumn("{task.description}"), TimeElapsedColumn())
    with Bars(*columns, console=console, transient=True) as bars:
        task = bars.add_task("starting", total=1)

        def tell(text: str) -> None:
            bars.update(task, description=text)

        lines = CampaignLines(tell)

        def show(now: CampaignProgress) -> None:
            said = now.sentence() + lines.wait(now)
            lines.show(now)
            bars.update(task, completed=now.done, total=now.flights, description=said)

        def remark(text: str) -> None:
            console.print(plain_text(text), markup=False, highlight=False)

        with lines.looking():
            yield show, remark


def _print_cost(design: Any, workers: int | None, output: Output) -> None:
    """Print the estimated cost of a campaign."""
    from springback.campaign.cost_estimate import cost_estimate
    from springback.scenario.warnings import missing_elements

    for line in missing_elements(design.full_scenarios):
        say(f"warning: {line}")
    with output.spinner("flying a few"):
        coming = cost_estimate(design, workers, output.note)
    output.print(coming.as_dict(), coming.sentence())


@click.command()
@click.argument("folder", type=PATH)
@click.argument("sql", required=False)
@click.option(
    "--format", "form", type=click.Choice(["table", "csv", "json", "markdown"]), default="table",
    show_default=True, help="Format of the output.",
)  # fmt: skip
@output_options(
    "Write a file instead: .parquet, .csv, .json or .md.", "force", "quiet", required=False
)
def query(folder: Path, sql: str | None, form: str, output: Output) -> None:
    """Query the campaign in FOLDER with SQL; the table is called flights.

    Without SQL all columns are listed, with units and meanings. Names with dots need double
    quotes. Values of events that did not happen, such as a touch, are NULL.

    \b
    springback query results
    springback query results "SELECT robot, avg(success), quantile_cont(recovery_time, 0.9)
                              FROM flights GROUP BY robot"
    springback query results "FROM flights WHERE NOT success" --out failures.csv
    """
    from springback.campaign.access import Campaign
    from springback.interfaces.output.tables import SUFFIXES, lines_of, write_answer

    known, out = Campaign(folder), output.out
    if out is not None and out.suffix not in SUFFIXES and (out.suffix != ".parquet" or not sql):
        raise InputError(f"--out {out}: must end in .parquet, {', '.join(SUFFIXES)}")
    if out is not None and out.exists() and not output.force:
        raise InputError(f"--out {out}: already exists; give another, or --force")
    if out is not None and sql is not None and out.suffix == ".parquet":
        output.note(f"{known.save(sql, out)} rows written to {out}")
        return

    def taken(columns: list[str], stretches: Iterator[list[Any]]) -> int:
        if out is not None:
            return write_answer(columns, stretches, out)
        # Data for a program are unchanged; a terminal must not be controlled by them.
        clean = plain_text if form == "table" or _is_terminal() else str
        for line in lines_of(columns, stretches, form):
            click.echo(clean(line))
        return 0

    if sql is None:
        count = taken(["column", "unit", "meaning"], iter([_columns(known)]))
    else:
        count = known.stream(sql, taken)
    if out is not None:
        output.note(f"{count} rows written to {out}")


def _is_terminal() -> bool:
    return sys.stdout is not None and sys.stdout.isatty()


def _columns(known: Any) -> list[tuple[Any, ...]]:
    """Name, unit and meaning of every column."""
    from springback.campaign.columns import FLIGHT, RESULT, known_columns

    meanings = known_columns(second=known.design.has_second)
    rest = [name for name in meanings if name not in FLIGHT and name not in RESULT]
    names = [*FLIGHT, *known.metadata["units"], *RESULT, *rest]
    units = known.units
    return [
        (name, units[name], meanings.get(name, ("", "varied by the plan"))[1]) for name in names
    ]


@click.command()
@click.argument("folder", type=PATH)
@click.argument("row", type=int)
@output_options("Folder for summary.json, trajectory.parquet, figures.", required=False)
def refly(folder: Path, row: int, output: Output) -> None:
    """Repeat flight ROW of the campaign in FOLDER alone, with its whole trajectory.

    Every number is compared with the row, bit for bit; the exit code is 1 if any differs.

    \b
    springback query results "SELECT flight FROM flights WHERE outcome = 'hit_ground' LIMIT 3"
    springback refly results 1711 --out flight-1711
    """
    from springback.campaign.access import Campaign
    from springback.interfaces.reports.flight_files import FLIGHT_FILES, write_flight

    known = Campaign(folder)
    with output.spinner(FIRST):
        again = known.refly(row)
    if output.out is not None:
        with output.folder(FLIGHT_FILES) as place, output.spinner("writing"):
            files = write_flight(again.flight, place, figures=output.wants_figures())
        output.note_written(files)
    data = {"flight": row, "identical": not again.differences}
    found = {"differences": list(again.differences), **again.flight.summary()}
    output.print(data | found, repr(again.flight))
    if not again.differences:
        output.note(f"identical to row {row}: every number, to the last bit")
        return
    for line in again.differences:
        say(f"differs from row {row}: {line}")
    sys.exit(1)


@click.command()
@click.argument("folder", type=PATH)
@click.option(
    "--map", "pairs", multiple=True, metavar="X,Y",
    help="Fields of a map of success; by default all pairs of the first four.",
)  # fmt: skip
@click.option(
    "--measure", "measures", multiple=True, metavar="COLUMN",
    help="Also show a measure in detail: distribution, over each field, sensitivity, maps.",
)  # fmt: skip
@click.option(
    "--limit", "limits", multiple=True, metavar="WORDS",
    help="Limit that values of --by must keep in the worst case, such as "
    '"impact_peak_acceleration < 300 m/s^2".',
)  # fmt: skip
@click.option(
    "--by", "fields", multiple=True, metavar="FIELD",
    help="Field whose values --limit asks about, or two separated by a comma. Without --limit: "
    "outcomes and measures for each of its levels; outcome and first_obstacle, what was touched "
    "first, are allowed, too.",
)  # fmt: skip
@click.option(
    "--share", type=float,
    help="Share of flights that must keep the limits; by default 1, all; 0.95 forgives one in 20.",
)  # fmt: skip
@click.option(
    "--where", "conditions", multiple=True, metavar="WORDS",
    help='Count only flights that meet a condition, such as "speed < 4 m/s" or "surface = wall".',
)  # fmt: skip
@click.option(
    "--cells", type=click.IntRange(2, 64),
    help="Cells along each field in maps and limits; by default as many as the flights allow.",
)  # fmt: skip
@click.option("--scatter", is_flag=True, help="Show success over the scattered parameters, too.")
@output_options("Folder for summary.html, summary.json and figures.", required=False)
def summary(
    folder: Path,
    pairs: tuple[str, ...],
    measures: tuple[str, ...],
    limits: tuple[str, ...],
    fields: tuple[str, ...],
    share: float | None,
    conditions: tuple[str, ...],
    cells: int | None,
    scatter: bool,
    output: Output,
) -> None:
    """Summarise the campaign in FOLDER: success, outcomes, quantiles, comparison of robots.

    Shares have Wilson intervals. Robots flew the same samples with the same noise, so they are
    compared in pairs; so are surfaces, pilots and other fields whose values are words, where they
    share samples, or the other fields of a grid. An unfinished campaign can be summarised, too. A
    measure is any numeric column that springback query FOLDER lists.

    --limit, which may be repeated, asks which values of a field keep the limits whatever the other
    fields are. Limits and conditions are written in words, like success in a plan: not
    arm_bottomed.

    \b
    springback summary results
    springback summary results --out page --map speed,pitch
    springback summary results --out page --measure impact_peak_acceleration
    springback summary results --by stiffness --limit "impact_peak_acceleration < 300 m/s^2"
    springback summary results --by surface --where "speed > 3 m/s"
    springback summary results --by first_obstacle
    """
    from springback.campaign.access import Campaign
    from springback.campaign.analysis.levels import field_summary, fields_of_words
    from springback.campaign.analysis.marginals import SUCCESS, measure_column, scale
    from springback.campaign.analysis.statistics import summary as summed_up
    from springback.campaign.analysis.worst_case import worst_cases
    from springback.interfaces.reports.campaign import summary_text, write_summary
    from springback.interfaces.reports.measures import measure_report

    known = _where(Campaign(folder), conditions)
    asked = []
    for text in pairs:
        x, sign, y = (part.strip() for part in text.partition(","))
        if not sign or not y or x == y:
            raise InputError(f"--map {text}: give two fields, such as speed,pitch")
        asked.append((scale(known, x, 2).name, scale(known, y, 2).name))
    for option, given in (("--map", pairs), ("--cells", None if limits else cells)):
        if given and output.out is None:
            raise InputError(f"{option} needs --out: the folder for the figures")
    checks: list[tuple[str, Callable[[str], Any], list[str]]] = [
        ("--measure", lambda name: measure_column(known, name), [*measures]),
        ("--limit", lambda text: known.design.condition(text, judged=True), [*limits]),
        ("--by", lambda name: scale(known, name.strip(), 2), ",".join(fields).split(",")),
    ]
    for option, check, given_words in checks:
        for word in filter(None, given_words):
            try:
                check(word)
            except InputError as error:
                raise InputError(f"{option} {error}") from None
    if share is not None and not 0.0 < share <= 1.0:
        raise InputError(f"--share: must be above 0 and at most 1 (got {share:g})")
    if share is not None and not limits:
        raise InputError("--share needs --limit: what that share of flights must keep")
    if any("," in text for text in fields) and not limits:
        raise InputError("--by: two fields need --limit, whose values they keep")
    with output.spinner("summing up"):
        found = summed_up(known)
        names = [name for name in dict.fromkeys(measures) if name != SUCCESS]
        reports = [measure_report(known, name, scatter=scatter) for name in names]
        by = dict.fromkeys([*fields_of_words(known), *(() if limits else fields)])
        levels = [field_summary(known, name) for name in by]
        worst = (
            worst_cases(known, limits, fields, share=share or 1.0, cells=cells) if limits else []
        )
    if output.out is not None:
        figures = output.wants_figures()
        with output.folder() as place, output.spinner("drawing"):
            files = write_summary(
                found, place, measures=reports, levels=levels, worst_cases=worst, pairs=asked,
                cells=cells, scatter=scatter, figures=figures,
            )  # fmt: skip
    data = found.as_dict() | {
        "measures": {one.name: one.as_dict() for one in reports},
        "by": [one.as_dict() for one in levels], "worst_cases": [one.as_dict() for one in worst],
    }  # fmt: skip
    text = summary_text(found, reports, levels=levels, worst_cases=worst)
    output.print(data, text)
    if output.out is not None:
        output.note_written(path for path in files if path.suffix in (".html", ".json"))


def _where(known: Campaign, conditions: tuple[str, ...]) -> Campaign:
    """The flights of a campaign that satisfy conditions in words."""
    try:
        return known.where(*conditions) if conditions else known
    except InputError as error:
        raise InputError(f"--where {error}") from None
