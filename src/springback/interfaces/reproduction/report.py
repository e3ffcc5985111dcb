"""The reproduction report: a self-contained page, its figures, and the numbers as data.

It has a part for each reproduced part of the paper: the slider tests, features and free flight, and
collisions in flight.  This module has what they share.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from springback.files import write_csv, write_json
from springback.interfaces.figures import style
from springback.interfaces.reports.page import (
    Content,
    FigureBlock,
    Section,
    TableCell,
    Wording,
    decimal,
    join,
    page,
    percent,
)
from springback.interfaces.reproduction.figure_list import figure_rows
from springback.interfaces.reproduction.free_flight import (
    flight_data,
    flight_sections,
    flight_tables,
)
from springback.interfaces.reproduction.overview import overview
from springback.interfaces.reproduction.resilience import (
    resilience_data,
    resilience_sections,
    resilience_tables,
)
from springback.interfaces.reproduction.slider import slider_data, slider_sections, sweep_rows
from springback.paper.free_flight import FlightResults
from springback.paper.printed import PAPER
from springback.paper.resilience import ResilienceResults
from springback.paper.slider import SliderResults
from springback.studies.comparison import AGREEMENT, Row

WORDS = Wording.of("report")
Rows = Sequence[Mapping[str, Any]]

#: Line below the title.
REPRODUCTION = f"A reproduction of {PAPER}"


@dataclass(frozen=True)
class Results:
    """Results of the reproduced parts of the paper; others are None."""

    slider: SliderResults | None = None
    features: list[Row] = field(default_factory=list)
    """Table I."""
    flight: FlightResults | None = None
    resilience: ResilienceResults | None = None

    @property
    def rows(self) -> list[Row]:
        """All compared numbers."""
        slider = self.slider.rows if self.slider else []
        flight = self.flight.rows() if self.flight else []
        resilience = self.resilience.rows() if self.resilience else []
        return [*slider, *self.features, *flight, *resilience]

    @property
    def _kind(self) -> str:
        there = {
            "slider": self.slider is not None,
            "flight": self.flight is not None or bool(self.features),
            "resilience": self.resilience is not None,
        }
        kinds = [kind for kind, flown in there.items() if flown]
        return kinds[0] if len(kinds) == 1 else "several"

    @property
    def title(self) -> str:
        """Title of the page."""
        return WORDS.title(self._kind)


def write_report(results: Results, folder: Path, *, about: Mapping[str, Any]) -> list[Path]:
    """Write ``report.html``, ``figures/``, ``comparison.json``, ``comparison.csv`` and more CSV.

    The same results and ``about`` give the same files, byte for byte.

    Args:
        results: Results to report.
        folder: Folder to write into, created if it does not exist.
        about: Versions of programs, by name.

    Returns:
        The files written.
    """
    folder.mkdir(parents=True, exist_ok=True)
    tables, sections = _tables(results), report_sections(results, about)
    written = [folder / name for name in ("report.html", "comparison.json", "comparison.csv")]
    written[0].write_text(page(results.title, sections, REPRODUCTION), encoding="utf-8")
    write_json(written[1], _data(results, about))
    write_csv(written[2], [row.as_dict() for row in results.rows])
    for name, rows in tables.items():
        written.append(folder / name)
        write_csv(written[-1], rows)
    for section in sections:
        for block in section.blocks:
            if isinstance(block, FigureBlock):
                written += style.save(block.figure, folder / "figures" / block.name)
    return written


def report_sections(results: Results, about: Mapping[str, Any]) -> list[Section]:
    """Sections of the page; the first is the summary."""
    sections = list(slider_sections(results.slider)) if results.slider else []
    if results.flight is not None or results.features:
        sections += flight_sections(results.features, results.flight)
    if results.resilience is not None:
        sections += resilience_sections(results.resilience)
    parted = sum(bool(section.part) for section in sections) > 1
    drawn = [b.name for s in sections for b in s.blocks if isinstance(b, FigureBlock)]
    data = {"figures": {"figures": figure_rows(drawn)}, "data": _everything(results, about)}
    ends = WORDS.sections(data)
    if not parted:
        sections, ends = ([replace(s, part="") for s in found] for found in (sections, ends))
    return [*overview(results.rows, sections), *sections, *ends]


def _everything(results: Results, about: Mapping[str, Any]) -> Content:
    rows = [
        (
            r.experiment, r.robot, r.surface, r.reading, r.quantity, r.unit, r.ours, r.printed,
            percent(r.deviation), TableCell("", mark=r.mark), _c_a(r), r.dissipation_from,
        )
        for r in results.rows
    ]  # fmt: skip
    tables = list(_tables(results))
    curves = f", the curves and points of the figures in {join(tables)}" if tables else ""
    made_with = [(str(key), str(value)) for key, value in about.items()]
    return {"count": len(rows), "all": rows, "made_with": made_with, "curves": curves}


def _c_a(row: Row) -> TableCell | None:
    """Text of c_a of a test with a contact; empty for other numbers."""
    if not row.dissipation_from:
        return None
    return TableCell(decimal(row.dissipation, 3), row.dissipation)


def _tables(results: Results) -> dict[str, Rows]:
    """Data of the figures by CSV file name."""
    tables: dict[str, Rows] = {}
    if results.slider is not None:
        tables["sweep.csv"] = sweep_rows(results.slider)
    if results.flight is not None or results.features:
        tables |= flight_tables(results.flight)
    if results.resilience is not None:
        tables |= resilience_tables(results.resilience)
    return tables


def _data(results: Results, about: Mapping[str, Any]) -> dict[str, Any]:
    slider = slider_data(results.slider) if results.slider is not None else {}
    flight = flight_data(results.flight) if results.flight is not None else {}
    resilience = resilience_data(results.resilience) if results.resilience is not None else {}
    return {
        "about": dict(about),
        "paper": PAPER,
        "agreement": AGREEMENT,
        "rows": [row.as_dict() for row in results.rows],
        **slider,
        **flight,
        **resilience,
    }
