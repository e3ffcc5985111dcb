"""Tables of the page of a fit; their heads are in ``templates/fit.toml``."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from springback.identification.design.experiments import ExperimentPlan, width_text
from springback.identification.estimates import FieldEstimate
from springback.identification.fits import FitResult
from springback.identification.law_comparison import LawComparison
from springback.identification.misfit import ChannelMisfit
from springback.identification.observations.sensor_chain import ChannelChain
from springback.identification.observations.windows import ImpactWindow
from springback.identification.report.assumptions import MATTERS, Assumption
from springback.identification.solving.fitting import ImpactFit
from springback.identification.unknowns import Unknown
from springback.interfaces.output.field_labels import short_names
from springback.interfaces.output.quantities import (
    decimals,
    display_unit,
    estimate_text,
    interval_text,
    number_text,
)
from springback.interfaces.reports.page import Entry, TableCell, percent, words_of_power
from springback.intervals import IntervalEstimate
from springback.logs.recording import QUANTITIES, Array
from springback.studies.comparison import Mark

#: Share by which an interval must get narrower to be worth a line (chosen).
WORTH = 0.1
Rows = list[Sequence[Entry]]


def finite_or_none(value: float) -> float | None:
    """A number, or None where there is none."""
    return float(value) if np.isfinite(value) else None


def with_unit(text: str, symbol: str) -> str:
    """Number with the symbol of its unit; plain numbers have none."""
    return text if symbol == "-" else f"{text} {symbol}"


def three_digits(value: float) -> str:
    """Number rounded to three digits, without an exponent."""
    return number_text(value, decimals(value, value))


def value_text(value: float, unit: str) -> str:
    """Number of three digits with its unit."""
    shown = display_unit(unit, [value])
    scaled = shown.factor * value
    plain = 1e-3 <= abs(scaled) < 1e6 or not scaled
    return with_unit(three_digits(scaled) if plain else f"{scaled:.3g}", shown.symbol)


def interval_of(one: FieldEstimate) -> IntervalEstimate:
    """Value and interval of a field."""
    return IntervalEstimate(one.value, finite_or_none(one.low), finite_or_none(one.high))


def estimate_cells(unknown: Unknown, found: IntervalEstimate) -> tuple[TableCell, TableCell]:
    """Value and interval, with the digits that the interval allows, and its ends in per cent."""
    unit = display_unit(unknown.unit, [found.value])
    value = with_unit(estimate_text(found, unit.factor), unit.symbol)
    detail = ""
    if found.low is not None and found.high is not None:
        ends = with_unit(interval_text(found, unit.factor), unit.symbol)
        if found.value:
            shares = ((end - found.value) / abs(found.value) for end in (found.low, found.high))
            detail = " to ".join(map(_end_share, shares))
    elif found.low is not None:
        ends = f"at least {value_text(found.low, unknown.unit)}"
    elif found.high is not None:
        ends = f"at most {value_text(found.high, unknown.unit)}"
    else:
        ends = "none"
    return TableCell(value, found.value), TableCell(ends, detail=detail)


def _end_share(share: float) -> str:
    """End of an interval against the value; narrow ones with a digit that is not zero."""
    small = 0.0 < abs(share) < 5e-4
    return f"{100.0 * share:+.1g} %".replace("-", "−") if small else percent(share)


def source_words(result: FitResult) -> str:
    """Where the intervals of free fields are from."""
    count = len(result.fits)
    if count == 1:
        return "profiles of the likelihood"
    return f"{count} impacts, {'with' if result.plan.scatter == 'impact' else 'without'} scatter"


def field_rows(result: FitResult) -> Rows:
    """Values, intervals, priors and verdicts of all fields."""
    rows: Rows = []
    for one in result.estimates:
        low, high = one.prior
        unit = display_unit(one.unknown.unit, [low, high])
        ends = " to ".join(three_digits(unit.factor * end) for end in (low, high))
        prior = TableCell(with_unit(ends, unit.symbol), detail=one.unknown.uncertainty)
        learned = TableCell(
            one.verdict, detail=f"{_share(100.0 * one.deviation)} % of the uncertainty",
            mark=Mark.FITTED if one.unknown.role == "free" else Mark.GIVEN,
        )  # fmt: skip
        rows.append([
            TableCell(one.unknown.name, code=True),
            *estimate_cells(one.unknown, interval_of(one)), prior, learned,
        ])  # fmt: skip
    return rows


def _share(percent: float) -> str:
    return f"{percent:.0f}" if percent >= 10.0 else f"{percent:.2g}"


def probability_text(value: float) -> str:
    """A probability; a dash where it was not tested."""
    if not np.isfinite(value):
        return "–"
    return words_of_power(value) if value < 1e-3 else f"{value:.2g}"


def misfit_rows(found: Sequence[ChannelMisfit]) -> Rows:
    """Tests of the channels of one impact."""
    return [
        [
            one.channel, "contact" if one.part == "contact" else "whole window", one.samples,
            TableCell(f"{np.sqrt(one.ratio):.2f}", float(np.sqrt(one.ratio))),
            probability_text(one.probability), probability_text(one.correlated), one.outliers,
            TableCell("misfit" if one.is_misfit else "fits"),
        ]
        for one in found
    ]  # fmt: skip


def impact_rows(
    estimates: Sequence[FieldEstimate], alone: Sequence[Sequence[IntervalEstimate]]
) -> Rows:
    """Value of each impact alone, and of all others without it.

    Args:
        estimates: Of the free fields, pooled.
        alone: Value of each field in each impact, with its interval.
    """
    rows: Rows = []
    for k in range(len(alone[0])):
        cells: list[Entry] = [str(k + 1)]
        for one, found in zip(estimates, alone, strict=True):
            assert one.pooled is not None
            value, ends = estimate_cells(one.unknown, found[k])
            without = float(one.unknown.value(one.pooled.without[k]))
            cells.append(TableCell(value.text, found[k].value, detail=ends.detail or ends.text))
            share = percent(without / one.value - 1.0) if one.value else ""
            unit = display_unit(one.unknown.unit, [without])
            text = estimate_text(interval_of(one)._replace(value=without), unit.factor)
            cells.append(TableCell(with_unit(text, unit.symbol), without, detail=share))
        rows.append(cells)
    return rows


def impact_head(estimates: Sequence[FieldEstimate]) -> list[str]:
    """Head of `impact_rows`."""
    names = short_names([one.unknown.name for one in estimates])
    return ["impact", *(word for name in names for word in (name, f"{name}, without it"))]


def interval_alone(fit: ImpactFit, name: str) -> IntervalEstimate:
    """Value of a free field in one impact, with its profile interval."""
    k = fit.problem.place[name]
    unknown, profile = fit.problem.unknowns[k], fit.profiles.get(name)
    ends = (-np.inf, np.inf) if profile is None else (profile.low, profile.high)
    low, high = (float(unknown.value(u)) if np.isfinite(u) else None for u in ends)
    return IntervalEstimate(float(unknown.value(fit.point[k])), low, high)


def assumption_rows(found: Sequence[Assumption], estimates: Sequence[FieldEstimate]) -> Rows:
    """Assumed fields, and what they move."""
    known = {one.unknown.name: one for one in estimates if one.unknown.role == "free"}
    short = dict(zip(known, short_names(list(known)), strict=True))
    rows: Rows = []
    for one in found:
        moved = list[str]()
        for name, shift in sorted(one.shifts.items(), key=lambda item: -abs(item[1])):
            unknown = known[name].unknown
            if moved and abs(shift) < MATTERS * known[name].deviation:
                continue
            size = unknown.deviation * shift
            far = percent(np.expm1(size)) if unknown.logarithmic else value_text(size, unknown.unit)
            moved.append(f"{short[name]} {far}")
        rows.append([
            TableCell(one.name, code=True), value_text(one.value, one.unit), one.change or "–",
            "; ".join(moved) or "not tried: another number is another law",
        ])  # fmt: skip
    return rows


def narrower_rows(estimates: Sequence[FieldEstimate], names: Sequence[str], matrix: Array) -> Rows:
    """How much narrower free fields would be, were a known one known exactly: √(1 − ρ²)."""
    rows = list[tuple[float, Sequence[Entry]]]()
    for one in estimates:
        if one.unknown.role != "known":
            continue
        row, said = matrix[names.index(one.unknown.name)], []
        for other in estimates:
            rho = float(row[names.index(other.unknown.name)])
            share = 1.0 - float(np.sqrt(max(1.0 - rho**2, 0.0)))
            if other.unknown.role == "free" and share > WORTH:
                said.append((share, f"{other.unknown.name} by {100.0 * share:.0f} %"))
        if said:
            text = "; ".join(words for _, words in sorted(said, reverse=True))
            best = max(share for share, _ in said)
            name = TableCell(one.unknown.name, code=True)
            rows.append((best, [name, one.unknown.uncertainty, text]))
    return [cells for _, cells in sorted(rows, key=lambda entry: -entry[0])]


def law_rows(compared: LawComparison) -> Rows:
    """Models with what each predicts of impacts left out, and its values."""
    rows: Rows = []
    for k, one in enumerate(compared.models):
        less, error = compared.behind(k)
        names = short_names([name for name, _, _ in one.estimates])
        values = "; ".join(
            f"{name} {value_text(value, unit)}"
            for name, (_, value, unit) in zip(names, one.estimates, strict=True)
        )
        if one.problem:
            rows.append([one.name, None, None, one.problem])
            continue
        behind = "best" if k == 0 else f"{less:.3g} ± {error:.2g}"
        rows.append([one.name, behind, f"{one.contact:.2g}", values])
    return rows


def experiment_rows(further: ExperimentPlan) -> Rows:
    """Half widths of 95 % intervals now, and after each of the chosen tests."""
    named = [("now", further.before)]
    named += [(f"{k}. {one.name}", one.half_widths)
              for k, one in enumerate(further.chosen, start=1)]  # fmt: skip
    return [
        [name, *(f"± {width_text(f, w)}" for f, w in zip(further.fields, widths, strict=True))]
        for name, widths in named
    ]


def _contact(impact: ImpactWindow) -> str:
    """Duration of a contact; a track alone tells none."""
    duration = impact.release - impact.touch
    return f"{1e3 * duration:.0f} ms" if duration > 0.0 else "–"


def search_rows(fits: Sequence[ImpactFit]) -> Rows:
    """How each impact was searched."""
    return [
        [
            f"{k}: {fit.name}",
            _contact(fit.problem.impact),
            f"{fit.agreeing} of {fit.starts}", len(fit.jacobian) - len(fit.point),
            fit.problem.flown, f"{fit.seconds:.1f} s",
        ]
        for k, fit in enumerate(fits, start=1)
    ]  # fmt: skip


def channel_rows(fit: ImpactFit) -> Rows:
    """Channels of an impact: noise, and what the sensor was taken to do."""
    rows: Rows = []
    for one in fit.problem.readings:
        unit, noise = QUANTITIES[one.quantity].unit or "rad", one.noise.stationary
        chain = fit.problem.chain(one) if unit in ("m/s^2", "rad/s") else None
        rate = 1.0 / float(np.median(np.diff(one.times)))
        low, high = (value_text(float(end), unit) for end in (noise.min(), noise.max()))
        order = len(one.noise.coefficients)
        rows.append([
            one.name, len(one.times), f"{rate:.0f} Hz", low if low == high else f"{low} to {high}",
            f"over {order} sample{'s' if order > 1 else ''}" if order else "no",
            _of(chain and chain.full_scale, unit), _low_pass(chain),
            _of(chain and chain.average, "s"),
        ])  # fmt: skip
    return rows


def _low_pass(chain: ChannelChain | None) -> str:
    if chain is None or chain.low_pass is None:
        return _of(None, "Hz")
    return f"{_of(chain.low_pass, 'Hz')}, {'second' if chain.order == 2 else 'first'} order"


def _of(value: float | None, unit: str) -> str:
    return "–" if value is None else value_text(value, unit)


def latent_rows(fit: ImpactFit) -> Rows:
    """Latents of an impact, before and after the data."""
    rows: Rows = []
    for unknown, u in zip(fit.problem.unknowns, fit.point, strict=True):
        if unknown.role == "latent":
            before, after = unknown.deviation, unknown.deviation * fit.deviation(unknown.name)
            value = float(unknown.value(u))
            if unknown.logarithmic:
                before, after = value * before, value * after
            texts = (value_text(x, unknown.unit) for x in (value, before, after))
            rows.append([unknown.name, *texts])
    return rows
