"""What a campaign says: intervals that hold, and counts that are those of the rows."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
import scipy.stats

import springback
from builders.campaign_folders import filled
from builders.plans import PITCH, SPEED, SURFACE, THROW, plan
from springback.campaign.access import Campaign
from springback.campaign.analysis.marginals import field_map, fields_of, marginal, scale
from springback.campaign.analysis.statistics import summary
from springback.campaign.design.layout import lay_out
from springback.errors import InputError
from springback.interfaces.figures import style
from springback.interfaces.figures.campaign import (
    field_map_figure,
    marginals_figure,
    round_ticks,
    tick_label,
)
from springback.interfaces.reports.campaign import summary_text
from springback.interfaces.reports.campaign_page import words_of_map
from springback.intervals import paired_difference, quantile, ranks, share


@pytest.fixture(scope="module")
def campaign(tmp_path_factory: pytest.TempPathFactory) -> Campaign:
    folder = tmp_path_factory.mktemp("made up")
    filled(folder, parts=4, size=200, samples=200, repeats=2)
    return Campaign(folder)


@pytest.mark.parametrize(("count", "part"), [(20, 0.5), (200, 0.1), (1000, 0.9)])
def test_intervals_of_quantiles_are_conovers(count: int, part: float) -> None:
    values = np.random.default_rng(count).exponential(size=count)
    told = scipy.stats.quantile_test(values, p=part).confidence_interval(0.95)
    found = quantile(np.sort(values), part)
    assert (found.low, found.high) == (told.low, told.high)
    assert found.value == pytest.approx(np.quantile(values, part))
    low, high = ranks(count, part)
    law = scipy.stats.binom(count, part)
    assert law.cdf(high - 1) - law.cdf(low - 1) >= 0.95
    few = quantile(np.sort(values[:5]), 0.9)
    assert few.high is None


def test_intervals_of_quantiles_hold_as_often_as_they_say() -> None:
    chance = np.random.default_rng(1)
    found = [quantile(np.sort(chance.normal(size=80)), 0.5) for _ in range(1000)]
    held = sum(e.low <= 0.0 <= e.high for e in found)
    assert 940 <= held <= 985


def test_intervals_of_paired_differences_hold_as_often_as_they_say() -> None:
    chance, held = np.random.default_rng(2), 0
    for _ in range(1000):
        _, first, second, _ = chance.multinomial(150, [0.8, 0.1, 0.05, 0.05])
        found = paired_difference(first, second, 150)
        held += found.low <= 0.05 <= found.high
        assert found.value == pytest.approx((first - second) / 150)
    assert 935 <= held <= 975
    assert paired_difference(0, 0, 0).value is None
    assert share(0, 0).value is None
    assert share(8, 10).low == pytest.approx(0.4902, abs=1e-4)  # Wilson 1927, as in Newcombe 1998


def test_a_summary_counts_the_rows(campaign: Campaign) -> None:
    rows = campaign.query("FROM flights").as_dicts()
    found = summary(campaign)
    for one in found.robots:
        mine = [row for row in rows if row["robot"] == one.robot]
        flown = [row for row in mine if row["outcome"] != "refused"]
        won = sum(row["success"] for row in flown)
        assert (one.flights, one.refused, one.successes) == (400, 400 - len(flown), won)
        assert sum(one.outcomes.values()) == len(flown)
        count, quantiles = one.measures["impact_peak_acceleration"]
        assert count == len(flown)
        want = np.quantile([row["impact_peak_acceleration"] for row in flown], (0.1, 0.5, 0.9))
        assert [e.value for e in quantiles] == pytest.approx(want)
        assert "recovery_time" not in one.measures  # no flight has it
    [pair] = found.pairs
    by_pair: dict[tuple[int, int], dict[str, int | None]] = {}
    for row in rows:
        by_pair.setdefault((row["sample"], row["repeat"]), {})[row["robot"]] = row["success"]
    known = [p for p in by_pair.values() if None not in p.values()]
    assert pair.pairs == len(known) < 400
    assert pair.first_only == sum(p["arq"] > p["quad"] for p in known)
    assert pair.second_only == sum(p["arq"] < p["quad"] for p in known)
    assert pair.both + pair.neither == sum(p["arq"] == p["quad"] for p in known)
    assert pair.medians["impact_peak_acceleration"][0] == len(known)


def test_marginals_count_every_flight_once(campaign: Campaign) -> None:
    judged = dict(campaign.query("SELECT robot, count(success) FROM flights GROUP BY robot").rows)
    assert fields_of(campaign) == ["speed", "pitch", "surface", "stiffness_factor", "wall_angle"]
    for name in fields_of(campaign):
        found = marginal(campaign, name, 7)
        for robot, cells in found.robots.items():
            assert sum(cell.flights for cell in cells) == judged[robot]
            assert len(cells) <= (2 if name == "surface" else 7)
            places = [cell.place for cell in cells]
            assert places == sorted(places)
    speed = marginal(campaign, "speed", 4).robots["arq"]
    shares = [cell.estimate.value for cell in speed]
    assert shares == sorted(shares, reverse=True)  # made up so: the faster, the fewer
    edges = scale(campaign, "speed", 4).edges
    assert edges == pytest.approx((1.0, 1.5, 2.0, 2.5, 3.0), abs=0.02)
    with pytest.raises(InputError, match="sped: is not varied"):
        marginal(campaign, "sped")


def test_maps_are_what_their_marginals_are(campaign: Campaign) -> None:
    found = field_map(campaign, "speed", "surface", 5)
    along = marginal(campaign, "speed", 5)
    for robot, cells in along.robots.items():
        assert found.flights[robot].sum(axis=0).tolist() == [cell.flights for cell in cells]
        won = np.nansum(found.flights[robot] * found.values[robot], axis=0)
        shares = [cell.estimate.value for cell in cells]
        assert won / found.flights[robot].sum(axis=0) == pytest.approx(shares)
    assert np.nanmax(found.values["arq"]) <= 1.0


def test_levels_and_logarithms_have_their_own_cells(tmp_path: Path) -> None:
    vary = [
        SPEED | {"spacing": "logarithmic"}, PITCH | {"count": 3}, SURFACE,
        {"field": "friction", "from": 0.1, "to": 0.9, "count": 60},
        {"field": "yaw", "values": ["45 deg", "22.5 deg"]},
    ]  # fmt: skip
    filled(tmp_path, samples=300, parts=2, size=300, vary=vary)
    told = Campaign(tmp_path)
    edges = scale(told, "speed", 2).edges
    assert edges[1] == pytest.approx(math.sqrt(edges[0] * edges[2]))
    assert scale(told, "pitch", 9).cells == 3
    assert len(marginal(told, "pitch").robots["arq"]) == 3
    assert scale(told, "surface", 9).labels == ("wall", "mat")
    assert scale(told, "friction", 9).labels == ()
    assert scale(told, "world.obstacles[0].surface.friction", 9).name == "friction"
    yaw = scale(told, "yaw", 9)  # in order, however listed
    assert yaw.edges == pytest.approx((math.radians(22.5), math.radians(45.0)))
    for name in ("speed", "pitch", "friction"):
        assert sum(c.flights for c in marginal(told, name).robots["arq"]) == 300


def test_figures_show_every_robot_and_are_the_same_again(campaign: Campaign) -> None:
    found = [marginal(campaign, name) for name in fields_of(campaign)]
    figure = marginals_figure(found)
    assert [text.get_text() for text in figure.legends[0].get_texts()] == ["ARQ", "Quad"]
    labels = [axes.get_xlabel() for axes in figure.axes[:5]]
    assert labels == ["speed [m/s]", "pitch [deg]", "surface", "stiffness factor [-]", "wall angle [deg]"]  # fmt: skip
    assert style.png(figure) == style.png(marginals_figure(found))
    over = field_map_figure(field_map(campaign, "pitch", "surface", 6))
    assert [axes.get_title(loc="left") or axes.get_title() for axes in over.axes[:2]] == ["ARQ", "Quad"]  # fmt: skip
    assert [t.get_text() for t in over.axes[0].get_yticklabels()] == ["wall", "mat"]


def test_differences_of_shares_are_percentage_points(campaign: Campaign) -> None:
    """Of 80 % and 60 % the difference is 20 percentage points, not 20 % of anything."""
    [pair] = summary(campaign).pairs
    value = pair.difference.value
    assert value is not None
    assert f": {100.0 * value:+.2f} percentage points (" in pair.sentence()
    assert "%" not in pair.sentence()


def test_a_summary_says_why_flights_were_refused(campaign: Campaign) -> None:
    found = summary(campaign)
    refused = sum(one.refused for one in found.robots)
    assert refused > 0
    assert found.refusal == f"{refused} refused, such as flight 9 (quad): too weak"
    assert found.refusal in summary_text(found)
    assert found.as_dict()["refusal"] == found.refusal


def test_captions_call_fields_by_words() -> None:
    said = words_of_map("wall_angle", "start.position[2]")
    assert (
        said == "Success rate over wall angle and position z; n is the number of flights in a cell."
    )


@pytest.mark.parametrize(
    ("low", "high", "ticks"),
    [
        (300.0, 3000.0, [500.0, 1000.0, 2000.0]),  # not 3e+02 and 3e+03
        (2.0, 99.0, [2.0, 5.0, 10.0, 20.0, 50.0]),  # not 2, 14 and 99
        (1e-3, 1e3, [1e-3, 1e-1, 1e1, 1e3]),
        (11.0, 14.0, [11.0, 14.0]),
        (-99.0, -2.0, [-50.0, -20.0, -10.0, -5.0, -2.0]),
    ],
)
def test_logarithmic_axes_have_round_ticks(low: float, high: float, ticks: list[float]) -> None:
    assert round_ticks(low, high) == pytest.approx(ticks, rel=1e-12)


def test_ticks_are_written_out() -> None:
    values = [0.002, 0.5, 20.0, 300.0, 3000.0, 20000.0, 1e6, 2e6]
    words = ["0.002", "0.5", "20", "300", "3000", "20000", "$10^{6}$", r"$2 \cdot 10^{6}$"]
    assert [tick_label(value) for value in values] == words


def test_a_vehicle_of_ones_own_goes_by_its_name(tmp_path: Path) -> None:
    """In rows and summaries, as in the replay; without a name it is "own"."""
    arq = springback.ARQ.vehicle.model_dump(mode="json")
    for named, shown in (("hexa", "hexa"), ("", "own")):
        mine = {**arq, "name": named} if named else {k: v for k, v in arq.items() if k != "name"}
        design = lay_out(plan(scenario={**THROW, "vehicle": mine}, robots=[]))
        assert design.robots == (shown,)
    preset = {"preset": "arq", "name": "softer"}
    assert lay_out(plan(scenario={**THROW, "vehicle": preset}, robots=[])).robots == ("softer",)
    filled(tmp_path / "rows", scenario={**THROW, "vehicle": preset}, robots=[])
    assert summary(Campaign(tmp_path / "rows")).robots[0].robot == "softer"
