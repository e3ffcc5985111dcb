"""Inputs as an attacker or an accident would write them, and what is promised for every one of them.

A scenario, plan or override is either accepted, and then made ready to fly with finite numbers, or
refused by an `InputError` of lines that a terminal can show.  Nothing else is raised, warned of, or
takes long or much memory.
"""

from __future__ import annotations

import contextlib
import json
import math
import resource
import time
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from hypothesis import strategies as st

from springback.campaign.design.layout import lay_out
from springback.campaign.design.plan import Source, plan_from
from springback.errors import InputError
from springback.kernels.trees import leaves
from springback.scenario.files import checked_scenario
from springback.scenario.overrides import apply_overrides
from springback.scenario.scenario import Scenario
from springback.scenario.source_text import toml_tables

EXAMPLES = Path(__file__).parents[2] / "examples"
#: Longest that one input may take [s]: a run-up that is sought in vain takes about 1 s here.
LONGEST = 20.0
#: Most memory that one input may take beyond what the process has [bytes].
MOST_MEMORY = 3 * 2**30
#: Longest line of an error that is of use to anybody.
LONGEST_LINE = 2500

#: Values that have broken programs before.
NASTY: list[Any] = [
    0, -0.0, 1, -1, 1e-300, 1e-30, 1e-15, 1e15, 1e30, 1e300, -1e300, math.inf, -math.inf, math.nan,
    10**25, 10**400, -(10**400), 2**63, True, False, None, "", " ", "x", "nan", "inf m", "1e400 m",
    "2,75 m", "1 200 g", "9**9**9 deg", "1 ±0.1 m", "45 deg", "-60deg", "5 N/mm", "0.4 bit", "22 deg",
    "1 Hz", "60 rpm", "%s", "{0}", "$x$", "../x", "\x1b[31mred", "\u202eevil", "a\nb", "a\x00b",
    "\ud800", "\ufeff", "x" * 5000, [], [[]], [0], [0, 0, 0], [1, 2], [math.nan] * 3, ["1 m"] * 3,
    [1e300] * 3, list(range(200)), {}, {"preset": "arq"}, {"preset": "quad"}, {"preset": 3},
    {"type": "ground"}, {"x": {"y": {"z": 1}}}, "arq", "wall", "mat", "hover", "paper",
]  # fmt: skip


def _tables(name: str) -> dict[str, Any]:
    return tomllib.loads((EXAMPLES / name).read_text())


SCENARIOS: list[dict[str, Any]] = [
    _tables(name) for name in ("arq_wall.toml", "steps.toml", "run_up.toml", "collision.toml")
]
PLAN = _tables("campaign.toml")
#: A plan with what is the user's own: vehicle file, pilots, estimator, success in words.
OWN_PLAN: dict[str, Any] = {
    "method": "random",
    "samples": 5,
    "scenario": SCENARIOS[3] | {
        "estimator": {
            "type": "own", "code": "own_estimator.py:blend", "parameters": {"place": 0.2},
        }
    },
    "robots": ["arq", str(EXAMPLES / "own_vehicle.toml")],
    "pilots": [
        "springback",
        "own_pilot.py:hover",
        {"code": "own_pilot_compiled.py:hover", "parameters": {"gain": 2.0}, "name": "mine"},
    ],
    "success": ["impact_arm_stroke < 20 mm or no_contact", "touch_speed < 3.5 m/s", "recovered"],
    "keep": {"where": ["not success", "impact_peak_specific_force > 50 gn"], "most": 3},
    "vary": [
        {"field": "estimator.parameters.place", "from": 0.1, "to": 0.3},
        {"field": "recovery.settling.speed", "normal": {"mean": 0.3, "deviation": "0.01 m/s"}},
    ],
}  # fmt: skip


def _dumped(tables: dict[str, Any]) -> dict[str, Any]:
    dumped: dict[str, Any] = Scenario.model_validate(
        checked_scenario(tables, "example", "", ())
    ).model_dump(mode="json")
    return dumped


def paths_of(node: Any, before: tuple[str | int, ...] = ()) -> list[tuple[str | int, ...]]:
    """Every path of plain tables, of tables and of what is in them."""
    inner = (
        node.items()
        if isinstance(node, dict)
        else enumerate(node)
        if isinstance(node, list)
        else ()
    )
    found = [before] if before else []
    for key, value in inner:
        found += paths_of(value, (*before, key))
    return found


#: Every setting, written out.
WHOLE: list[dict[str, Any]] = [_dumped(tables) for tables in SCENARIOS]
PATHS = sorted({path for tables in (*WHOLE, *SCENARIOS) for path in paths_of(tables)}, key=str)
PLAN_PATHS = sorted({("vary", 0, key) for key in (
    "field", "name", "from", "to", "count", "step", "spacing", "values", "normal", "factor",
)} | set(paths_of(PLAN)) | set(paths_of(OWN_PLAN)), key=str)  # fmt: skip

numbers_with_units = st.builds(
    "{}{}{}".format,
    st.one_of(st.integers(-1000, 1000), st.floats(), st.text("0123456789.,eE+-_' ", max_size=12)),
    st.sampled_from(["", " ", "  ", "\t", "*", "/"]),
    st.one_of(
        st.sampled_from(
            ["m", "mm", "deg", "kg", "N/mm", "s", "1/s", "Hz", "m/s^2", "kg m^2", "%", "°"]
        ),
        st.text("mksNgradHz/^*· 0123456789()√²", max_size=10),
    ),
)
plain_values = st.one_of(
    st.sampled_from(NASTY), numbers_with_units, st.floats(), st.integers(), st.text(max_size=20)
)
values = st.one_of(
    plain_values,
    plain_values,
    st.lists(plain_values, max_size=4),
    st.dictionaries(st.text(max_size=8), plain_values, max_size=3),
)


def put(node: Any, path: tuple[str | int, ...], value: Any) -> Any:
    """A copy of plain tables with a value at a path, as far as there is one."""
    if not path:
        return value
    head, *rest = path
    if isinstance(head, int):
        entries = list(node) if isinstance(node, list) else []
        while len(entries) <= head:
            entries.append({})
        entries[head] = put(entries[head], tuple(rest), value)
        return entries
    table = dict(node) if isinstance(node, dict) else {}
    table[head] = put(table.get(head, {}), tuple(rest), value)
    return table


def value_at(node: Any, path: tuple[str | int, ...]) -> Any:
    """The value at a path of plain tables; None if there is none."""
    for key in path:
        if not isinstance(node, dict | list) or (isinstance(node, dict) and key not in node):
            return None
        node = node[key]
    return node


#: Numbers of every setting written out.
NUMBERS = [
    sorted((p for p in paths_of(tables) if type(value_at(tables, p)) in (int, float)), key=str)
    for tables in WHOLE
]


@st.composite
def scenarios(draw: st.DrawFn) -> dict[str, Any]:
    """An example, or one written out, with up to three values exchanged, or numbers scaled."""
    if draw(st.booleans()):
        k = draw(st.sampled_from(range(len(WHOLE))))
        tables = WHOLE[k]
        for _ in range(draw(st.integers(1, 3))):
            path = draw(st.sampled_from(NUMBERS[k]))
            number = value_at(tables, path) or draw(st.sampled_from([1e-6, 1e-3, 1.0, -1.0]))
            factor = 10.0 ** draw(st.floats(-4.0, 4.0))
            tables = put(tables, path, number * factor)
        return tables
    tables = draw(st.sampled_from([*SCENARIOS[:1] * 4, *WHOLE, *SCENARIOS]))
    for _ in range(draw(st.integers(1, 3))):
        tables = put(tables, draw(st.sampled_from(PATHS)), draw(values))
    return tables


@st.composite
def texts(draw: st.DrawFn) -> str:
    """The text of an example with pieces cut out, doubled, exchanged or put in."""
    text = (EXAMPLES / draw(st.sampled_from(["arq_wall.toml", "steps.toml"]))).read_text()
    for _ in range(draw(st.integers(1, 4))):
        first = draw(st.integers(0, len(text)))
        last = min(len(text), first + draw(st.integers(0, 12)))
        new = draw(st.one_of(
            st.text(max_size=6), st.sampled_from(["=", "[", "]]", '"', "\n", "1e999", ",", "#", "'''", "{", "."]),
            st.just(text[first:last] * 2),
        ))  # fmt: skip
        text = text[:first] + new + text[last:]
    return text


@st.composite
def override_words(draw: st.DrawFn) -> tuple[str, ...]:
    """Words as they are given on the command line."""
    words = []
    for _ in range(draw(st.integers(1, 3))):
        path = draw(st.sampled_from(PATHS))
        key = (
            ".".join(map(str, path))
            if draw(st.booleans())
            else draw(st.text(".[]= abz019²", max_size=12))
        )
        value = draw(values)
        words.append(f"{key}={value if isinstance(value, str) else _short(value)}")
    return tuple(words)


def _short(value: Any) -> str:
    return "1" + "0" * 400 if isinstance(value, int) and abs(value) > 10**300 else str(value)


@st.composite
def plans(draw: st.DrawFn) -> dict[str, Any]:
    """The example of a plan, or one of the user's own, with up to three values changed."""
    own = draw(st.booleans())
    scenario = OWN_PLAN["scenario"] if own else draw(st.sampled_from([SCENARIOS[2], WHOLE[2]]))
    tables = (OWN_PLAN if own else PLAN) | {"scenario": scenario, "samples": 5}
    if tables["method"] == "grid":
        del tables["samples"]
    for _ in range(draw(st.integers(1, 3))):
        if draw(st.integers(0, 4)):
            tables = put(tables, draw(st.sampled_from(PLAN_PATHS)), draw(values))
        else:
            path = draw(st.sampled_from(PATHS))
            tables = put(tables, ("scenario", *path), draw(values))
    return tables


# -- what is promised -----------------------------------------------------------------------------


def check_lines(error: InputError) -> None:
    """Lines that say something, that a terminal shows, and that can be encoded."""
    assert error.problems
    for line in error.problems:
        assert line.strip()
        assert line.isprintable(), repr(line)
        assert len(line) <= LONGEST_LINE, len(line)
        line.encode()


def check_ready(scenario: Scenario) -> None:
    """An accepted scenario has finite numbers, and what is saved of it is read again as it was."""
    numbers = [*leaves(scenario.flight_model()), *leaves(scenario.start_state())]
    assert all(math.isfinite(number) for number in numbers)
    saved = json.loads(json.dumps(scenario.model_dump(mode="json"), allow_nan=False))
    again = checked_scenario(saved, "saved", "", ())
    assert again.model_dump(mode="json") == saved


@contextlib.contextmanager
def bounded_memory() -> Iterator[None]:
    """Raise a MemoryError for what asks for more than `MOST_MEMORY`, instead of a killed process."""
    before = resource.getrlimit(resource.RLIMIT_AS)
    held = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (held + MOST_MEMORY, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_AS, before)


def timed(check: Any, *given: Any) -> bool:
    """Whether an input is accepted; what is promised for it is asserted."""
    begun = time.perf_counter()
    try:
        with bounded_memory():
            check(*given)
    except InputError as error:
        check_lines(error)
        return False
    finally:
        assert time.perf_counter() - begun < LONGEST
    return True


def scenario_tables(tables: dict[str, Any], words: tuple[str, ...] = ()) -> None:
    """As `springback fly` does before it flies."""
    check_ready(
        checked_scenario(apply_overrides(tables, words), "scenario.toml", "", words, pilot=False)
    )


def scenario_text(text: str) -> None:
    """As a file is read."""
    check_ready(checked_scenario(toml_tables(text, "scenario.toml"), "scenario.toml", text, ()))


def plan_tables(tables: dict[str, Any]) -> None:
    """As `springback campaign --dry-run` does before it asks the database."""
    plan = plan_from(tables, Source("plan.toml", "", ()))
    design = lay_out(plan)
    plan.digest()
    assert isinstance(design.success + design.keep_condition, str)  # conditions in words are read
    dealt = design.slice(0, min(4, design.flights))
    assert len(dealt.tables) == min(4, design.flights)
