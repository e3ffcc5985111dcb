"""Obstacles of the impact lab besides its wall: by their own words, their energies in the balance."""

# what is optional is asked for before what needs it

from typing import Any

import numpy as np
import pytest

pytest.importorskip("starlette", reason="the lab needs the extra web")

from springback.interfaces.lab.responses import OF_TWO, answer, balance, energy_series
from springback.interfaces.lab.scenarios import lab_scenario
from springback.interfaces.lab.settings import LabSettings, settings_from
from springback.results.energy_history import HELD, LOST, SUPPLIED, ledger
from springback.results.flight import fly


def setting(**words: Any) -> LabSettings:
    return settings_from((name, str(value)) for name, value in words.items())


@pytest.mark.parametrize("words", [
    {"obstacle": "ball", "speed": 3}, {"obstacle": "door", "door_mass": 2}, {"obstacle": "robot"},
])  # fmt: skip
def test_the_energy_of_what_moves_is_in_the_balance(words: dict[str, Any]) -> None:
    """The stack sums to what was put in, which the other side of the ledger tells."""
    flight = fly(lab_scenario(setting(guide="free", **words), "arq"))
    energies = ledger(flight)
    called = OF_TWO if words["obstacle"] == "robot" else {}
    found = {one.name: one.values for one in energy_series(energies, slice(None), called)}
    put_in = found.pop("put in")
    driven = max(found.pop("by the other robot", np.zeros(1)).max(), 0.0)
    assert sum(found.values()) == pytest.approx(put_in, abs=2e-3 * put_in.max())
    parts, line = balance(energies)
    scale = line["put_in"].max()
    assert sum(parts.values()) == pytest.approx(line["put_in"], abs=1e-5 * scale)
    assert min(values.min() for values in parts.values()) > -1e-6 * scale
    if words["obstacle"] == "robot":
        assert max(found["to the other robot"].max(), driven) > 0.01 * scale
        assert "moving obstacles" not in found
        return
    gained = energies["energy_obstacles"]
    assert np.ptp(found["moving obstacles"]) == pytest.approx(np.ptp(gained))
    assert np.ptp(gained) > 0.05 * scale
    assert (gained[-1] < 0.0) == (words["obstacle"] == "ball")  # it gives, a door takes


def test_what_drives_an_obstacle_is_put_in_or_taken() -> None:
    """Of a made-up ledger: work that turns from given to taken, and the sum with it."""
    names = (*HELD, *SUPPLIED, *LOST)
    energies = {name: np.zeros(4) for name in names}
    energies["energy_kinetic"] = np.array([2.0, 3.0, 1.0, 1.0])
    energies["work_driven"] = np.array([0.0, 1.5, -0.5, -0.5])
    energies["loss_obstacles"] = np.array([0.0, 0.5, 0.5, 0.5])
    parts, line = balance(energies)
    assert line["given"].tolist() == [0.0, 1.5, 0.0, 0.0]
    assert parts["taken"].tolist() == [0.0, 0.0, 0.5, 0.5]
    assert sum(parts.values()).tolist() == line["put_in"].tolist() == [2.0, 3.5, 2.0, 2.0]
    shown = [one.name for one in energy_series(energies, slice(None))]
    assert shown == [
        "motion", "lost in obstacles", "to driven obstacles", "put in", "by driven obstacles",
    ]  # fmt: skip


@pytest.mark.parametrize("name", ["ball", "door"])
def test_an_obstacle_goes_by_the_word_of_its_choice(name: str) -> None:
    """In the picture's legend, the sentence and the scenario's name; never as a wall."""
    [shown, _] = answer(setting(obstacle=name))["flights"]
    assert [one["name"] for one in shown["scene"]["obstacles"]] == [name]
    assert f"the {name} at" in shown["sentence"]
    assert f", {name}, surface of a wall" in lab_scenario(setting(obstacle=name), "arq").name
