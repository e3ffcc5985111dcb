"""While routines compile, another process compiles the very kernels that the flight then runs."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numba
import pytest

from springback.contact.hulls.compound import SCENE_HULL_FACES
from springback.contact.scene.faces import SCENE_FACES
from springback.errors import InputError
from springback.kernels import routines
from springback.kernels.compiler import is_in_cache
from springback.kernels.routines import Routine, routines_deferred
from springback.results.flight import fly
from springback.scenario import flight_kernels
from springback.scenario.files import read_scenario
from springback.scenario.scenario import scenario_from
from springback.simulation.executor import advance, to_tick
from springback.simulation.flight import SLICE, fly_to_end
from springback.simulation.guided import fly_between_ticks

ROOT = Path(__file__).parents[2]
THROWN: dict[str, Any] = {
    "vehicle": "navi", "thrust": "hover",
    "world": {"obstacles": [{"type": "wall", "distance": "2.75 m", "surface": "wall"}]},
    "start": {"position": ["2.3 m", 0, "1 m"], "velocity": ["2 m/s", 0, 0]},
    "simulation": {"duration": "0.1 s"},
}  # fmt: skip
GUIDED: dict[str, Any] = {
    "vehicle": "arq",
    "reference": {"type": "run-up", "speed": "2 m/s"},
    "world": {"obstacles": [{"type": "pole", "position": ["2.85 m", 0, 0], "radius": "10 cm",
                             "surface": "wall"}]},
    "simulation": {"duration": "0.1 s"},
}  # fmt: skip


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> list[tuple[Callable[..., None], Any]]:
    """What another process is asked to compile, where no routine has been compiled."""
    calls: list[tuple[Callable[..., None], Any]] = []

    @contextmanager
    def meanwhile(part: Callable[..., None], arguments: tuple[Any, ...]) -> Iterator[None]:
        calls.append((part, tuple(map(numba.typeof, arguments))))
        yield

    monkeypatch.setattr(flight_kernels, "compiled_meanwhile", meanwhile)
    monkeypatch.setattr(routines, "is_compiled_apart", lambda *_: False)
    monkeypatch.setattr(SCENE_FACES, "_address", None)
    monkeypatch.setattr(SCENE_HULL_FACES, "_address", None)
    return calls


def test_a_throw_is_compiled_for_the_types_with_which_it_is_flown(asked: list[Any]) -> None:
    fly(THROWN)
    [(part, types)] = asked
    assert part is fly_to_end
    assert is_in_cache(advance, types)


def test_so_is_the_physics_of_a_pilots_flight(asked: list[Any]) -> None:
    """With a hull; of other vehicles the pilot takes longer, and two processes compile then."""
    fly(GUIDED)
    assert not asked
    fly({**GUIDED, "vehicle": "navi"})
    [(part, (*types, budget, early))] = asked
    assert part is fly_between_ticks
    assert budget == numba.int64  # the callee knows its value
    assert is_in_cache(to_tick, (*types, numba.types.literal(SLICE), early))


def test_the_flight_is_that_of_a_scenario_read_before(asked: list[Any]) -> None:
    """No address of a routine that was not compiled is kept."""
    early, late = fly(THROWN), fly(scenario_from(THROWN))
    assert len(asked) == 1
    assert early.measures == late.measures


def test_a_scenario_that_is_only_read_is_not_compiled(asked: list[Any]) -> None:
    scenario_from(THROWN)
    read_scenario(ROOT / "examples/pole.toml")
    assert not asked


def test_only_the_first_scenario_of_a_flight_is_compiled(asked: list[Any]) -> None:
    with flight_kernels.flights_compiled_early():
        scenario_from(THROWN)
        scenario_from(GUIDED)
    assert len(asked) == 1


def test_a_touch_distance_is_not_sought_before_there_are_routines(asked: list[Any]) -> None:
    start = {"touch_distance": "2 cm", "position": [0, 0, "1 m"], "velocity": ["2 m/s", 0, 0]}
    fly({**THROWN, "start": start})
    assert len(asked) == 1


def test_the_first_problem_is_the_same(asked: list[Any]) -> None:
    wrong = {**THROWN, "start": {"position": ["2.74 m", 0, "1 m"], "velocity": ["2 m/s", 0, 0]}}
    with pytest.raises(InputError) as read:
        scenario_from(wrong)
    with pytest.raises(InputError) as flown:
        fly(wrong)
    assert str(read.value) == str(flown.value)


def test_other_threads_get_real_addresses(asked: list[Any]) -> None:
    """A scenario that is read beside one that is deferred, as in the lab, can be flown."""
    routine = Routine(_doubled, 0.0)
    with routines_deferred() as missing, ThreadPoolExecutor(1) as pool:
        assert routine.address == 0.0
        assert missing == [routine]
        assert pool.submit(lambda: routine.address).result() > 0.0
    assert routine.call_compiled(2.0) == 4.0


def _doubled(number: float) -> float:
    return 2.0 * number
