"""Figures of results by formula, and the map of a plane."""

from __future__ import annotations

from matplotlib.figure import Figure

from builders.paper_results import fake_slider_flight, fake_slider_results
from springback.campaign.analysis.envelope import Axis, CellIndex, Envelope, EnvelopeCell
from springback.interfaces.figures import flight as plots
from springback.interfaces.reproduction.figures import slider


def slider_figures() -> dict[str, Figure]:
    results = fake_slider_results()
    return {
        "flight": plots.flight_figure(fake_slider_flight(stroke=0.01)),
        "no contact": plots.flight_figure(fake_slider_flight(hit=False)),
        "quad": slider.slider_figure(results, "quad"),
        "arq": slider.slider_figure(results, "arq"),
        "sweep": slider.sweep_figure(results),
        "readings": slider.readings_figure(results),
        "energy": plots.energy_figure(fake_slider_flight(), fake_slider_flight(hit=False)),
        "readme": slider.readme_figure(results),
    }


def plane_map(robots: tuple[str, ...] = ("arq", "quad")) -> Envelope:
    """share = 1.05 - 0.04 v - 0.002 θ, at most 1; the corner of fast and steep cannot be flown."""
    x = Axis("speed", "m/s", (1.0, 2.0, 3.0, 4.0, 5.0))
    y = Axis("pitch", "deg", (-45.0, -15.0, 15.0, 45.0))
    cells = {}
    for robot in robots:
        for j, pitch in enumerate(y.values):
            for i, speed in enumerate(x.values):
                won = min(1000, round(1050 - 40 * speed - 2 * pitch))
                ended = {"recovered": won, "hit_ground": 1000 - won}
                corner = (i, j) == (4, 3)
                cells[CellIndex(robot, i, j)] = EnvelopeCell({} if corner else ended)
    return Envelope(x, y, robots, 1000, 0, (), cells)
