"""One way in: what a scenario's check builds is what flies."""

from __future__ import annotations

import copy
import pickle
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import springback
from springback.control.cascade import Cascade
from springback.errors import InputError
from springback.scenario import build, model
from springback.scenario.avionics import BuiltAvionics
from springback.scenario.scenario import Scenario, scenario_from
from springback.scenario.vehicles import thrusts
from springback.vehicle.parameters import Vehicle
from springback.vehicle.propulsion import Propulsion

GUIDED = {
    "vehicle": "arq",
    "reference": {"type": "hold"},
    "start": {"position": [0.0, 0.0, 1.0]},
    "simulation": {"duration": 0.01},
}
#: What one flight is built of, and where it is found.
PARTS = (
    (build, "cascade_of"), (build, "build_avionics"), (build, "flight_model"),
    (model, "true_body"), (thrusts, "hover_thrusts"), (model, "world_numbers"),
    (Vehicle, "airframe"), (Propulsion, "rotors"),
)  # fmt: skip


def counted(monkeypatch: pytest.MonkeyPatch) -> Counter[str]:
    """Calls of every part from here on."""
    calls: Counter[str] = Counter()

    def counting(name: str, function: Callable[..., Any]) -> Callable[..., Any]:
        def called(*given: Any, **named: Any) -> Any:
            calls[name] += 1
            return function(*given, **named)

        return called

    for owner, name in PARTS:
        monkeypatch.setattr(owner, name, counting(name, getattr(owner, name)))
    return calls


def test_nothing_is_built_twice(monkeypatch: pytest.MonkeyPatch) -> None:
    """Reading, checking and flying a scenario with a pilot make each of its parts once."""
    calls = counted(monkeypatch)
    springback.fly(GUIDED, executor="python", trajectory=False)
    assert calls["build_avionics"] == calls["cascade_of"] == calls["flight_model"] == 1
    assert not {name: count for name, count in calls.items() if count > 1}


def test_what_was_checked_is_what_flies() -> None:
    """The very objects."""
    scenario = scenario_from(GUIDED)
    built = scenario.build()
    assert scenario.build() is built
    assert scenario.flight_model() == built.model
    assert scenario.start_state() == built.start
    assert isinstance(built.built_avionics, BuiltAvionics)
    assert isinstance(built.built_avionics.avionics.systems.pilot, Cascade)


def test_a_changed_copy_is_built_anew() -> None:
    """Nothing of what it was built of stays where a table is another one."""
    scenario = scenario_from(GUIDED)
    heavier = scenario.model_copy(update={"vehicle": {"body": {"mass": 2.0}}})
    unchecked = scenario.with_checked(vehicle=heavier.vehicle, seed=7)
    assert scenario.build().model.airframe.mass != heavier.build().model.airframe.mass
    assert unchecked.build().model.airframe == heavier.build().model.airframe
    assert (unchecked.build().seed, scenario.build().seed) == (7, 0)


@pytest.mark.parametrize(
    "copied", [copy.copy, copy.deepcopy, lambda s: pickle.loads(pickle.dumps(s))]
)
def test_copies_are_equal_and_build_the_same(copied: Callable[[Scenario], Scenario]) -> None:
    """What was built is no part of what a scenario is."""
    scenario = scenario_from(GUIDED)
    other = copied(scenario)
    assert other == scenario == scenario_from(GUIDED)
    assert other.build().model == scenario.build().model


def test_a_pilot_of_ones_own_is_built_for(tmp_path: Path) -> None:
    """A scenario that waits for one is no flight without: its gusts are refused then."""
    gusty = {
        "vehicle": "arq",
        "air": {"gusts": {"wind_at_6_m": 7.7, "airspeed": 5.0}, "body_drag": 0.1},
        "start": {"position": [0.0, 0.0, 1.0]},
        "simulation": {"duration": 0.002},
    }
    waiting = scenario_from(gusty)
    with pytest.raises(InputError, match=r"air\.gusts"):
        springback.fly(waiting)

    def hover(time: float, measurement: Any, memory: Any) -> tuple[list[float], Any]:
        return [2.75] * 4, memory

    flight = springback.fly(waiting, pilot=hover, executor="python")
    assert len(flight.telemetry["t"]) == 2


def taken_for_upright(tables: dict[str, Any]) -> tuple[bool, ...]:
    """If the characterisation of each vehicle's pilot takes what it hits for upright."""
    scenario = scenario_from(tables)
    both = [scenario, *([] if scenario.second is None else [scenario.beside()])]
    found = [
        one.build().built_avionics.avionics.systems.pilot.characterisation.level for one in both
    ]
    return tuple(level == 1.0 for level in found)


_RECOVERING = GUIDED | {"recovery": {}}
_UPRIGHT = {"type": "wall", "distance": 3.0, "surface": "wall"}
_LEANING = {"type": "wall", "position": [3.0, 0, 0], "normal": [-1, 0, 0.2], "surface": "wall"}
_GROUND = {"type": "ground", "surface": "wall"}
_POLE = {"type": "pole", "position": [3.0, 0, 0], "radius": 0.1, "surface": "wall"}
_OTHER = {**_RECOVERING, "start": {"position": [1.0, 0.0, 1.0]}}


@pytest.mark.parametrize(
    ("obstacles", "upright"),
    [
        ([_UPRIGHT], True),
        ([_UPRIGHT, _GROUND], True),
        ([{**_LEANING, "normal": [-3, 4, 0]}, _UPRIGHT, _UPRIGHT], True),
        ([_LEANING], False),
        ([_UPRIGHT, _POLE], False),
        ([_GROUND], False),
        ([], False),
    ],
)
def test_obstacles_are_taken_for_upright_where_all_are(
    obstacles: list[dict[str, Any]], upright: bool
) -> None:
    tables = _RECOVERING | {"world": {"obstacles": obstacles}}
    assert taken_for_upright(tables) == (upright,)
    for level in (True, False):
        given = tables | {"recovery": {"characterisation": {"level": level}}}
        assert taken_for_upright(given) == (level,)


def test_another_vehicle_is_not_taken_for_upright() -> None:
    """By either of two, whatever walls are there."""
    second = {name: _OTHER[name] for name in ("vehicle", "reference", "recovery", "start")}
    tables = _RECOVERING | {"world": {"obstacles": [_UPRIGHT]}, "second": second}
    assert taken_for_upright(tables) == (False, False)
    second = second | {"recovery": {"characterisation": {"level": True}}}
    assert taken_for_upright(tables | {"second": second}) == (False, True)
