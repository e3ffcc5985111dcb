"""A campaign in Python: figures of its measures, and what a notebook shows."""

from __future__ import annotations

import pytest

from builders.campaign_folders import filled
from springback.campaign.access import Campaign
from springback.errors import InputError


@pytest.fixture(scope="module")
def campaign(tmp_path_factory: pytest.TempPathFactory) -> Campaign:
    folder = tmp_path_factory.mktemp("campaign") / "<throws>"
    filled(folder)
    return Campaign(folder)


def test_a_measure_is_drawn_alone_over_a_field_and_over_two(campaign: Campaign) -> None:
    alone = campaign.plot("touch_speed")
    assert "touch speed [m/s]" in {ax.get_xlabel() for ax in alone.axes}
    over = campaign.plot("impact_arm_stroke", by="speed")
    assert over.axes[0].get_xlabel() == "speed [m/s]"
    assert "impact arm stroke" in over.axes[0].get_ylabel()
    across = campaign.plot(by=("speed", "pitch"))
    assert across.axes[0].get_xlabel() == "speed [m/s]"
    assert across.axes[0].get_ylabel() == "pitch [deg]"


def test_bad_figures_of_a_campaign_are_refused(campaign: Campaign) -> None:
    with pytest.raises(InputError, match=r"touch_sped: is no column .* did you mean touch_speed"):
        campaign.plot("touch_sped")
    with pytest.raises(InputError, match="wind: is not varied by this campaign"):
        campaign.plot("touch_speed", by="wind")
    with pytest.raises(InputError, match="by: name the field, or two"):
        campaign.plot()
    with pytest.raises(InputError, match=r"by: must be the name of a field, or two \(got 3\)"):
        campaign.plot(by=("speed", "pitch", "speed"))  # type: ignore[arg-type]


def test_a_notebook_shows_the_outcomes_of_each_robot(campaign: Campaign) -> None:
    page = campaign._repr_html_()
    assert "&lt;throws&gt;</b>: 30 of 60 flights; continue with resume=True" in page
    counts = campaign.query("SELECT robot, outcome, count(*) FROM flights GROUP BY ALL").rows
    assert len(counts) > 4
    for robot, outcome, count in counts:
        cells = "".join(f'<td style="text-align:left">{x}</td>' for x in (robot, outcome, count))
        assert f"<tr>{cells}" in page
