"""Effect of open assumptions on the collisions in flight, and the limits of both robots.

The text is in ``templates/resilience.toml``.
"""

from __future__ import annotations

from collections.abc import Sequence

from springback.interfaces.figures import envelope as plots_map
from springback.interfaces.output.robots import ROBOTS as LOOKS
from springback.interfaces.reports.page import Content, Entry, TableCell, Wording, number, plain
from springback.interfaces.reproduction.figures import choices
from springback.interfaces.reproduction.figures.choices import ORDER, signed_angle
from springback.paper.choices import EKF2, OURS, PLAUSIBLE, PRINTED_TRIALS
from springback.paper.choices import ConditionOutcome as Chosen
from springback.paper.printed import printed_success
from springback.paper.resilience import ROBOTS, ResilienceResults

WORDS = Wording.of("resilience")


def condition(pitch: float, speed: float) -> str:
    """Label of a condition."""
    return f"{signed_angle(pitch)}°, {plain(speed)} m/s"


def choices_content(results: ResilienceResults) -> Content:
    """Content on the table under each set of choices, and its agreement with print."""
    found = results.choices
    if found is None or not found.cells:
        return {}
    sets = [
        (
            one.choice.name, TableCell(f"{one.close} of {one.numbers}", one.close),
            TableCell(f"{one.plausible} of {one.numbers}", one.plausible),
            TableCell(f"{one.words} of {one.phrases}", one.words),
        )
        for one in (found.agreement(*flown) for flown in found.combinations)
    ]  # fmt: skip
    best = found.best()
    columns = [one for one in found.combinations if one[0].friction == best.choice.friction]
    fates: list[Sequence[Entry]] = [("", *(choice.estimator for choice, _ in columns))]
    for of in ((robot, *test) for robot in ROBOTS for test in ORDER):
        outcomes = (_fate(found.table(*one).get(of)) for one in columns)
        fates.append((f"{LOOKS[of[0]].label}, {condition(*of[1:])}", *outcomes))
    return {
        "theirs": EKF2, "ours": OURS, "trials": found.trials, "duration": best.duration,
        "best": best.choice.name, "met": best.total, "all": best.numbers + best.phrases,
        "chance": 100 * PLAUSIBLE, "printed_trials": PRINTED_TRIALS, "agreement": sets,
        "fates": fates, "friction": best.choice.friction, "choices": choices.choices_figure(found),
    }  # fmt: skip


def _fate(cell: Chosen | None) -> TableCell | None:
    """Recovered trials; medians of height loss, distance and time."""
    if cell is None:
        return None
    loss, far, time = (
        "–" if (value := cell.medians.get(name)) is None else number(value, 2)
        for name in ("height_loss", "excursion", "recovery_time")
    )
    detail = WORDS.say("fate", loss=loss, far=far, time=time)
    return TableCell(f"{cell.successes} of {cell.trials}", cell.share, detail)


def map_content(results: ResilienceResults) -> Content:
    """Content on the recoveries of each robot over speed and pitch."""
    envelope = results.envelope
    if envelope is None:
        return {}
    figure = plots_map.map_figure(envelope, printed_success)
    return {"theirs": EKF2, "trials": envelope.trials, "map": figure}
