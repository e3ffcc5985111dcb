"""Page of a map of success; its text and order are in ``templates/map.toml``."""

from __future__ import annotations

from springback.campaign.analysis.envelope import LEVEL, CellIndex, Envelope
from springback.interfaces.figures.style import StyledFigure
from springback.interfaces.output.robots import robot_label, with_labels
from springback.interfaces.reports.page import Content, Table, TableCell, Wording, join, page

WORDS = Wording.of("map")


def map_page(envelope: Envelope, figure: StyledFigure) -> str:
    """Self-contained HTML page of a map.

    Args:
        envelope: Envelope of one or more robots.
        figure: Its figure; see `springback.interfaces.figures.envelope.map_figure`.
    """
    axes = {"x": envelope.x.label, "y": envelope.y.label}
    reasons = dict.fromkeys(
        (robot_label(place.robot), cell.reason)
        for place, cell in envelope.cells.items() if not cell.trials and cell.reason
    )  # fmt: skip
    content: dict[str, Content] = {
        "overview": {
            **axes, "robots": join(map(robot_label, envelope.robots)),
            "trials": envelope.trials, "level": 100 * LEVEL, "map": figure,
            "reaches": [with_labels(envelope.sentence(robot)) + "." for robot in envelope.robots],
        },
        "cells": {"tables": [_table(envelope, robot) for robot in envelope.robots]},
        "method": {
            "seed": envelope.seed, "reasons": list(reasons),
            "settings": "; ".join(envelope.settings) or WORDS.text["none"],
        },
    }  # fmt: skip
    return page(WORDS.say("title", **axes), WORDS.sections(content), lead=WORDS.say("lead"))


def _table(envelope: Envelope, robot: str) -> Table:
    """Table of successes, a row for each value of y, the largest on top."""
    lines = []
    for row in envelope.rows_from_top:
        cells = [envelope.cells[CellIndex(robot, i, row)] for i in range(len(envelope.x.values))]
        entries = (
            TableCell(f"{cell.successes} of {cell.trials}", cell.share)
            if cell.trials
            else TableCell("–")
            for cell in cells
        )
        lines.append((TableCell(f"{envelope.y.values[row]:g}"), *entries))
    head = (f"{envelope.y.label} over {envelope.x.label}", *(f"{v:g}" for v in envelope.x.values))
    return Table(WORDS.say("caption", robot=robot_label(robot)), head, tuple(lines))
