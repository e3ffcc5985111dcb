"""Summary of a campaign as text and as files."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from springback.campaign.analysis.marginals import fields_of, marginal
from springback.campaign.analysis.statistics import Summary
from springback.files import write_json
from springback.interfaces.output.tables import as_text
from springback.interfaces.reports.outcomes import outcome_table, quantile_table


def summary_text(found: Summary) -> str:
    """Summary for a terminal."""
    about = found.campaign.about
    done, of = found.campaign.done, about["flights"]
    state = "complete" if done == of else f"{100.0 * done / of:.1f} %, continue with --resume"
    lines = [
        f"{about['name']}: {done} of {of} flights ({state})",
        f"success: {found.campaign.design.success}",
        "",
        as_text(*outcome_table(found.robots)),
        *([found.refusal] * bool(found.refusal)),
        "",
        "10 %, 50 % and 90 % quantiles of flights",
        as_text(*quantile_table(found.robots)),
    ]
    return "\n".join(
        [*lines, *(["", *(pair.sentence() for pair in found.pairs)] * bool(found.pairs))]
    )


def write_summary(
    found: Summary,
    folder: Path,
    *,
    pairs: Sequence[tuple[str, str]] = (),
    scatter: bool = False,
    figures: bool = True,
) -> list[Path]:
    """Write ``summary.json`` and, with ``figures``, figures and the page ``summary.html``.

    Args:
        found: The summary.
        folder: Folder to write into.
        pairs: Pairs of fields to map; by default all pairs of the first four.
        scatter: Show success over the scattered parameters, too.
        figures: Write figures and the page.

    Returns:
        The files written.
    """
    campaign = found.campaign
    fields = fields_of(campaign, scatter=scatter)
    marginals = [marginal(campaign, name) for name in fields]
    data = found.as_dict() | {"marginals": [one.as_dict() for one in marginals]}
    write_json(folder / "summary.json", data)
    written = [folder / "summary.json"]
    if not figures:
        return written
    from springback.interfaces.reports.campaign_page import write_page

    return written + write_page(found, marginals, folder, pairs)
