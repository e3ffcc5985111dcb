"""Flights and campaigns in a notebook: tables, and a small picture."""

from __future__ import annotations

import base64
import html
from collections.abc import Iterable
from importlib.util import find_spec

from springback.campaign.access import Campaign
from springback.results.flight import Flight

MEANING_OF_IMPULSE = "of forces at contacts; weight, rotors and air are not in it"
_LEFT = ' style="text-align:left"'


def flight_html(flight: Flight) -> str:
    """Outcome, principal measures, path, and all measures folded away."""
    mark = "✓" if flight.success else "✗"
    head = (
        f"<p><b>{html.escape(flight.scenario.name)}</b>: {mark} <b>{flight.outcome.word}</b>, "
        f"{html.escape(flight.message)}</p>"
    )
    warned = "".join(f"<p>warning: {html.escape(one)}</p>" for one in flight.warnings)
    principal = flight.readable_measures()
    every = flight.readable_measures(all_of_them=True)
    rows = [(line.name, line.text, line.meaning) for line in every]
    short = [(line.name, line.text, line.meaning) for line in principal]
    if flight.impulse_text:
        short.append(("impulse", flight.impulse_text, MEANING_OF_IMPULSE))
    return (
        f"<div>{head}{warned}{_picture(flight)}"
        f"{_table(short)}"
        f"<details><summary>all {len(rows)} measures</summary>{_table(rows)}</details></div>"
    )


def _table(rows: Iterable[tuple[str, ...]], heads: tuple[str, ...] = ()) -> str:
    lines = [f"<tr>{''.join(f'<th{_LEFT}>{html.escape(head)}</th>' for head in heads)}</tr>"]
    lines = lines if heads else []
    for row in rows:
        cells = "".join(f"<td{_LEFT}>{html.escape(cell)}</td>" for cell in row)
        lines.append(f"<tr>{cells}</tr>")
    return f"<table>{''.join(lines)}</table>"


def _picture(flight: Flight) -> str:
    """Path of the main body, if it was recorded and matplotlib is installed."""
    if not flight.columns or find_spec("matplotlib") is None:
        return ""
    from springback.interfaces.figures.columns import path_figure
    from springback.interfaces.figures.style import png

    data = base64.b64encode(png(path_figure(flight))).decode("ascii")
    return f'<img alt="path of the main body" width="480" src="data:image/png;base64,{data}">'


def campaign_html(campaign: Campaign) -> str:
    """State of a campaign, and its outcomes by robot."""
    flights = int(campaign.metadata["flights"])
    head = (
        f"<p><b>{html.escape(campaign.folder.name)}</b>: {campaign.done} of {flights} flights"
        f"{'' if campaign.complete else '; continue with resume=True'}"
        f"{''.join(f'; only {html.escape(text)}' for text in campaign.conditions)}</p>"
    )
    found = campaign.query(
        "SELECT robot, outcome, count(*) AS n, 100.0 * n / sum(n) OVER (PARTITION BY robot)"
        " FROM flights GROUP BY robot, outcome ORDER BY robot, n DESC, outcome"
    ).rows
    rows = [(str(robot), str(word), str(n), f"{share:.3g} %") for robot, word, n, share in found]
    return f"<div>{head}{_table(rows, ('robot', 'outcome', 'flights', 'share'))}</div>"
