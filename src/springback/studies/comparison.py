"""Our numbers beside printed ones, each with its mark."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from enum import Enum
from typing import Any

#: A predicted number agrees with a printed one within this share of it.
AGREEMENT = 0.05


class Mark(Enum):
    """Kind of a compared number; the value is its explanation."""

    GIVEN = "printed, and put in"
    FITTED = "a free number was chosen to make it so"
    PREDICTED = f"computed, and within {100 * AGREEMENT:g} % of the printed value"
    CONTRADICTED = f"computed, and more than {100 * AGREEMENT:g} % off the printed value"

    @property
    def word(self) -> str:
        """Short name, as in tables."""
        return self.name.lower()


@dataclass(frozen=True)
class Row:
    """One compared number."""

    experiment: str
    robot: str
    surface: str
    reading: str
    quantity: str
    unit: str
    ours: float | None
    printed: float | None
    """Value from the paper's simulation, or its text."""
    printed_test: float | None
    """Value from the paper's physical test."""
    mark: Mark
    dissipation: float
    """c_a of the run [s/m]."""
    dissipation_from: str
    note: str = ""

    @property
    def deviation(self) -> float | None:
        """Relative deviation from the printed value."""
        if self.ours is None or not self.printed:
            return None
        return self.ours / self.printed - 1.0

    @property
    def scatter(self) -> float | None:
        """Relative deviation of the paper's physical test from its own simulation."""
        if self.printed_test is None or not self.printed:
            return None
        return self.printed_test / self.printed - 1.0

    @property
    def test_deviation(self) -> float | None:
        """Relative deviation of ours from the paper's physical test."""
        if self.ours is None or not self.printed_test:
            return None
        return self.ours / self.printed_test - 1.0

    def as_dict(self) -> dict[str, Any]:
        """Plain data, for JSON and CSV."""
        return {
            **asdict(self), "mark": self.mark.word, "deviation": self.deviation,
            "test_deviation": self.test_deviation, "printed_test_deviation": self.scatter,
        }  # fmt: skip


def predicted_or_contradicted(ours: float | None, printed: float) -> Mark:
    """The mark of a number that was computed without using its printed value."""
    if ours is None or abs(ours / printed - 1.0) > AGREEMENT:
        return Mark.CONTRADICTED
    return Mark.PREDICTED
