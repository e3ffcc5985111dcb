"""Table I: what is put in comes out, what is predicted agrees, what contradicts is shown as such."""

from __future__ import annotations

import pytest

from springback.paper.features import (
    TABLE_I,
    feature_rows,
    predicted_hover_time,
)
from springback.studies.comparison import Mark, Row


def row(robot: str, quantity: str, reading: str | None = None) -> Row:
    """The one row of a quantity."""
    found = [
        row for row in feature_rows()
        if (row.robot, row.quantity) == (robot, quantity) and reading in (None, row.reading)
    ]  # fmt: skip
    assert len(found) == 1
    return found[0]


@pytest.mark.parametrize("robot", ["arq", "quad"])
def test_given_numbers_are_those_printed(robot: str) -> None:
    """Sizes, masses and moments, the latter of body and arms together, to rounding."""
    given = [row for row in feature_rows() if row.robot == robot and row.mark is Mark.GIVEN]
    assert len(given) == 6
    for one in given:
        assert one.ours == pytest.approx(one.printed, rel=1e-12)
    assert row(robot, "size, cage tip to tip").ours == pytest.approx(0.60)


def test_quad_is_fitted() -> None:
    """Two numbers of Quad were used: 573 s and 1.64 kg."""
    for quantity, printed in (("hover time", 573.0), ("largest payload", 1.64)):
        one = row("quad", quantity)
        assert one.mark is Mark.FITTED
        assert one.printed == printed
        assert one.ours == pytest.approx(printed, rel=1e-3)


def test_hover_time_of_arq_hardly_depends_on_the_unknown_battery() -> None:
    """461 s printed; within 5 % from Quad's 573 s alone, for every battery of 0.1 to 0.6 kg."""
    for battery in (0.1, 0.2, 0.3, 0.37, 0.5, 0.6):
        assert predicted_hover_time(battery) == pytest.approx(461.0, rel=0.05)
    for reading in ("battery 0.2 kg", "battery 0.6 kg"):
        assert row("arq", "hover time", reading).mark is Mark.PREDICTED
    assert predicted_hover_time(0.2) < 461.0 < predicted_hover_time(0.6)


def test_hover_time_with_the_librarys_battery_is_called_fitted() -> None:
    """Its mass came from both printed hover times, so agreement proves nothing."""
    one = row("arq", "hover time", "battery 0.37 kg")
    assert one.mark is Mark.FITTED
    assert one.ours == pytest.approx(464.2, abs=0.1)


def test_without_electronics_the_battery_follows_from_both_hover_times() -> None:
    """(m_arq + b)/(m_quad + b) = (573/461)^(2/3) gives 0.37 kg: power goes with mass^1.5."""
    ratio = (TABLE_I["quad"].hover_time / TABLE_I["arq"].hover_time) ** (2.0 / 3.0)
    battery = (TABLE_I["arq"].mass - ratio * TABLE_I["quad"].mass) / (ratio - 1.0)
    assert battery == pytest.approx(0.37, abs=0.005)


def test_payloads_differ_by_70_grams_more_than_the_masses() -> None:
    """One propulsion cannot hold both: 1.45 kg of ours against 1.38 kg, just over 5 % apart."""
    one = row("arq", "largest payload")
    assert one.mark is Mark.CONTRADICTED
    assert one.ours == pytest.approx(0.844 + 1.64 - 1.034)
    assert one.deviation == pytest.approx(0.0507, abs=1e-4)
    assert "70 g more" in one.note
