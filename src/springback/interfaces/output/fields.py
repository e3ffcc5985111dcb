"""Values of a campaign's fields as text."""

from __future__ import annotations

from springback.campaign.analysis.marginals import Scale
from springback.interfaces.output.quantities import DisplayUnit, display_unit, quantity_text


def cell_text(cut: Scale, low: float, high: float) -> str:
    """Values of a cell with their unit, or its level: ``500 to 870 N/m``, ``45 deg``, ``wall``.

    Args:
        cut: Division of the field.
        low: Lower bound of the cell; for words the number of the level.
        high: Upper bound.
    """
    if cut.labels and not cut.edges:
        return cut.labels[int(low)]
    unit = display_unit(cut.unit)
    ends = dict.fromkeys(quantity_text(v * unit.factor) for v in sorted((low, high)))
    return " to ".join(ends) + unit_text(unit)


def unit_text(unit: DisplayUnit) -> str:
    """Symbol of a unit after a blank; nothing for plain numbers."""
    return "" if unit.symbol == "-" else f" {unit.symbol}"
