"""All that a campaign's folder says, and questions that are to reach nothing else."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from springback.campaign.access import Campaign
from springback.campaign.analysis.statistics import summary


def all_said(folder: Path, *, summed: bool = True) -> Any:
    """Rows, columns, units, progress, plan and, which takes longest, the summary."""
    campaign = Campaign(folder)
    rows = campaign.query("FROM flights ORDER BY flight")
    refused = sum(part.refused for part in campaign.parts)
    about = {key: campaign.metadata[key] for key in ("flights", "robots", "seed", "units")}
    return (
        rows,
        refused,
        campaign.units,
        about,
        campaign.design.plan,
        summed and summary(campaign).as_dict(),
    )


#: To be filled in: a secret file, a file to write, a part of this campaign and one of another's.
ESCAPES = [
    "SELECT * FROM read_csv('/etc/hostname')",
    "SELECT * FROM read_text('{secret}')",
    "SELECT * FROM '{secret}'",
    "SELECT * FROM glob('/etc/*')",
    "SELECT * FROM sniff_csv('{secret}')",
    "SELECT * FROM parquet_metadata('{other}')",
    "SELECT * FROM read_parquet('{other}')",
    "SELECT (SELECT count(*) FROM read_text('{secret}')) FROM flights",
    "SELECT * FROM query('COPY flights TO ''{target}''')",
    "SELECT * FROM query_table('{secret}')",
    "FROM flights; COPY flights TO '{target}'",
    "COPY flights TO '{target}'",
    "COPY (SELECT 1) TO '{part}'",
    "ATTACH '{target}'",
    "EXPORT DATABASE '{target}'",
    "INSTALL httpfs",
    "LOAD httpfs",
    "DROP VIEW flights",
    "CREATE TABLE t AS FROM flights",
    "SET enable_external_access = true",
    "RESET lock_configuration",
    "PRAGMA enable_profiling",
    "CALL pragma_version()",
    "CHECKPOINT",
    "SELECT * FROM secret_of_python",
    "SELECT getenv('HOME')",
    "SELECT 1) TO '{target}'; --",
    "SELECT 1\n) TO '{target}' (FORMAT csv); --",
    "",
    ";",
    "SELECT '\udcff'",
    "SELECT '\0'",
]
#: The same for conditions of plans.
CONDITIONS = [
    "true); COPY (SELECT 1) TO '{target}'; SELECT (true",
    "true; COPY (SELECT 1) TO '{target}'",
    "(SELECT count(*) FROM read_text('{secret}')) > 0",
    "1 = 1 THEN true END)::TINYINT AS success FROM read_text('{secret}') --",
    "speed > 1, 2",
    "speed > 1 --\n) FROM flights --",
    "",
    "\udcff",
]
