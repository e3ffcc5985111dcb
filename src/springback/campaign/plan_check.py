"""Check of a plan's conditions, before anything is flown."""

from __future__ import annotations

from typing import Any

from springback.campaign.access import in_words
from springback.campaign.design.layout import Design
from springback.campaign.design.plan import Source
from springback.campaign.store import empty_rows, rows_of
from springback.errors import InputError
from springback.results.database import in_database, one_expression

#: Advice on a condition that is no SQL.
WITH_UNITS = '; with units, give a list: {} = ["arm_stroke < 20 mm"]'


def check_conditions(design: Design, source: Source | None = None) -> None:
    """Reject conditions of a plan that are not valid SQL, before anything is flown.

    Args:
        design: Design of the plan.
        source: Origin of the plan.

    Raises:
        InputError: If a condition is invalid; it names the entry.
    """
    problem_line = (source or Source()).problem_line
    keep = design.plan.keep
    given = {"success": design.plan.success, "keep.where": keep.where if keep else None}
    for entry, texts in given.items():
        for k, text in enumerate(texts if isinstance(texts, tuple) else ()):
            try:
                design.condition(text, judged=entry == "keep.where")
            except InputError as error:
                raise InputError(problem_line((*entry.split("."), k), str(error))) from None
    conditions = {"success": design.success, "keep.where": design.keep_condition}
    for entry, text in conditions.items():
        try:
            one_expression(text)
        except InputError as error:
            more = WITH_UNITS.format(entry.rpartition(".")[2])
            raise InputError(problem_line(entry.split("."), f"{error}{more}")) from None
    kept = one_expression(conditions["keep.where"])
    statements = {
        "success": f"CREATE TABLE flights AS {rows_of(design)}",
        "keep.where": f"SELECT flight FROM flights WHERE {kept}",
    }

    def check(connection: Any) -> None:
        connection.register("given", empty_rows(design))
        for entry, statement in statements.items():
            with in_words(problem_line(entry.split("."), "").rstrip(": ")):
                connection.execute(statement)

    in_database(check)
