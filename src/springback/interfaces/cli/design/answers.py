"""Questions about a vehicle that is to be, and their answers as numbers."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any, NamedTuple

from pydantic_core import PydanticCustomError

from springback.errors import InputError, shown_value
from springback.interfaces.cli.design.sizes import SpringTarget, VehicleAnswer, least_span
from springback.quantities import si_number

#: Numbers of arms: even, so that the torques of the rotors cancel (chosen: at most 12).
COUNTS = (4, 6, 8, 10, 12)
#: What stands for no guard and no spring.
NONE = "none"


class Question(NamedTuple):
    """A question about a vehicle."""

    text: str
    help: str
    default: Callable[[dict[str, VehicleAnswer]], str]  # from the answers so far
    read: Callable[[str], Any]  # raises the problem of a wrong answer


def _number(unit: str, least: float, most: float) -> Callable[[str], float]:
    return lambda text: si_number(text, unit, least=least, most=most)


def _count(text: str) -> int:
    if text.strip() not in map(str, COUNTS):
        raise InputError(
            f"must be {', '.join(map(str, COUNTS[:-1]))} or {COUNTS[-1]}: an even number, so that "
            f"the torques of the rotors cancel (got {shown_value(text)})"
        )
    return int(text)


def _guard(text: str) -> float | None:
    return None if text.strip() == NONE else si_number(text, "m", least=0.01, most=1.0)


def _spring(text: str) -> SpringTarget | None:
    if text.strip() == NONE:
        return None
    found = re.fullmatch(r"(.*\S)\s+at\s+(\S.*)", text.strip())
    if found is None:
        raise InputError(
            f"must be a way and a speed, such as 25 mm at 2 m/s, or none (got {shown_value(text)})"
        )
    return SpringTarget(
        si_number(found[1], "m", least=1e-3, most=0.5),
        si_number(found[2], "m/s", least=0.1, most=20.0),
    )


def _usual_guard(known: dict[str, VehicleAnswer]) -> str:
    """10 mm of air and guard around a propeller of five inch, in proportion."""
    radius = 0.5 * known["propeller"].value
    return f"{1e3 * radius + 10.0 * radius / 0.0635:.3g} mm"


def _usual_span(known: dict[str, VehicleAnswer]) -> str:
    return f"{1e3 * least_span(known):.4g} mm"


QUESTIONS: dict[str, Question] = {
    "mass": Question(
        "Mass, ready to fly", "Mass, ready to fly, such as 600g.",
        lambda known: "600 g", _number("kg", 0.02, 30.0),
    ),
    "arms": Question(
        "Arms, each with a propeller (4, 6, 8, 10 or 12)", "Arms, each with a propeller.",
        lambda known: "4", _count,
    ),
    "propeller": Question(
        "Diameter of a propeller", "Diameter of a propeller, such as 5in.",
        lambda known: "5 in", _number("m", 0.02, 1.0),
    ),
    "guard": Question(
        "Radius of the guard around each, or none", "Radius of the guard around each, or none.",
        _usual_guard, _guard,
    ),
    "spring": Question(
        "How far an arm gives way when it hits a wall, and at what speed; or none, for rigid arms",
        'How far an arm gives way at a wall: "25mm at 2m/s", or none.',
        lambda known: "25 mm at 2 m/s", _spring,
    ),
    "span": Question(
        "Span, between the axes of opposite propellers", "Between opposite propellers, axis to "
        "axis.", _usual_span, _number("m", 0.04, 5.0),
    ),
}  # fmt: skip
"""In the order in which they are asked: defaults of later ones follow from earlier ones."""


def answer_to(name: str, text: str | None, known: dict[str, VehicleAnswer]) -> VehicleAnswer:
    """The answer to a question.

    Args:
        name: Of the question.
        text: What was said; None for the default.
        known: Answers to the questions before.

    Raises:
        InputError: One line with the value, its unit and the allowed range.
    """
    question = QUESTIONS[name]
    said = question.default(known) if text is None else text
    try:
        value = question.read(said)
    except PydanticCustomError as error:
        raise InputError(f"--{name}: {error.message()}") from None
    except InputError as error:
        raise InputError(f"--{name}: {error.problems[0]}") from None
    return VehicleAnswer(value, said, text is not None)
