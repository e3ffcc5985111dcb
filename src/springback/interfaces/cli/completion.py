"""Completion with the tab key: presets, keys of overrides and their values, files by kind.

The shell asks the program, as click describes; everything heavy is imported only then.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, get_origin

import click
from click.shell_completion import CompletionItem

if TYPE_CHECKING:
    from springback.settings import Settings

Complete = Callable[[click.Context, click.Parameter, str], list[CompletionItem]]
#: Files offered at most, and levels of folders below the one that is typed (chosen).
MOST_FILES, LEVELS = 200, 2
#: Kinds of tables that a key may name by a preset.
PRESETS = {
    "vehicle": "vehicle",
    "surface": "surface",
    "backing": "surface",
    "estimator": "estimator",
}


def _items(words: Iterator[str] | list[str], incomplete: str) -> list[CompletionItem]:
    """Completions among some words."""
    return [CompletionItem(word) for word in words if word.startswith(incomplete)]


# -- files ----------------------------------------------------------------------------------------


def files_below(incomplete: str, suffix: str) -> list[str]:
    """Files of a kind that a path may become, in its folder and the next levels.

    Args:
        incomplete: Path typed so far.
        suffix: Of the files' names, such as ``.toml``.
    """
    head, slash, tail = incomplete.rpartition("/")
    folder = Path(head + slash) if slash else Path()
    found: list[str] = []

    def look(here: Path, shown: str, levels: int) -> None:
        try:
            entries = sorted(here.iterdir(), key=lambda path: (path.is_dir(), path.name))
        except OSError:
            return
        for path in entries:
            first = levels == LEVELS
            if path.name.startswith(".") or (first and not path.name.startswith(tail)):
                continue
            if path.is_file() and path.suffix == suffix and len(found) < MOST_FILES:
                found.append(shown + path.name)
            elif path.is_dir() and levels:
                look(path, f"{shown}{path.name}/", levels - 1)

    look(folder, head + slash, LEVELS)
    return found


class ScenarioPath(click.Path):
    """Path of a scenario or a plan, completed to files in TOML."""

    def __init__(self) -> None:
        """A path of any kind: what is wrong with it is said when it is read."""
        super().__init__(path_type=Path)

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        """Files in TOML."""
        return _items(files_below(incomplete, ".toml"), incomplete)


def complete_code(
    ctx: click.Context, param: click.Parameter, incomplete: str
) -> list[CompletionItem]:
    """Names in Python files, ``FILE.py:NAME``; the files are read, not run."""
    file = incomplete.partition(":")[0]
    return _items([f"{path}:{name}" for path in files_below(file, ".py") for name in _names(path)],
                  incomplete)  # fmt: skip


def _names(path: str) -> Iterator[str]:
    """Public functions, classes and variables of a Python file."""
    try:
        body = ast.parse(Path(path).read_text(encoding="utf-8")).body
    except (OSError, ValueError, SyntaxError):
        return
    for one in body:
        names = [one.name] if isinstance(one, ast.FunctionDef | ast.ClassDef) else []
        if isinstance(one, ast.Assign):
            names = [target.id for target in one.targets if isinstance(target, ast.Name)]
        yield from (name for name in names if not name.startswith("_"))


def complete_checked(
    ctx: click.Context, param: click.Parameter, incomplete: str
) -> list[CompletionItem]:
    """What can be checked: files in TOML, and names in Python files."""
    files = _items(files_below(incomplete, ".toml"), incomplete)
    return files + complete_code(ctx, param, incomplete)


# -- presets --------------------------------------------------------------------------------------


def presets(kind: str = "") -> list[str]:
    """Names of presets of a kind (vehicle, surface, estimator, material), or of all."""
    from springback.contact.library import SURFACES
    from springback.sensing.library import ESTIMATORS
    from springback.vehicle.library import VEHICLES
    from springback.vehicle.materials import MATERIALS

    known = {
        "vehicle": [*VEHICLES], "surface": [*SURFACES], "estimator": [*ESTIMATORS],
        "material": [*MATERIALS],
    }  # fmt: skip
    return [name for key in known if kind in ("", key) for name in known[key]]


def complete_preset(kind: str = "") -> Complete:
    """Completion of the names of presets of a kind, or of all."""
    return lambda ctx, param, incomplete: _items(presets(kind), incomplete)


def complete_vehicle(
    ctx: click.Context, param: click.Parameter, incomplete: str
) -> list[CompletionItem]:
    """Presets of vehicles, and files in TOML."""
    return _items([*presets("vehicle"), *files_below(incomplete, ".toml")], incomplete)


# -- overrides ------------------------------------------------------------------------------------


def setting_keys(table: type[Settings], stem: str = "") -> Iterator[tuple[str, tuple[str, ...]]]:
    """Dotted keys of a table and of those below it, and the words that each may be."""
    from springback.scenario.fields import fields_of

    for field in fields_of(table).values():
        key, below = stem + field.key.removesuffix("_"), field.tables
        kinds = {kind for kind, _ in field.leaves}
        words = ("true", "false") if bool in kinds else field.words
        words += tuple(presets(PRESETS[field.key])) if field.key in PRESETS else ()
        if words or not below:
            yield key, words
        inner = key + (".0." if kinds.isdisjoint(below) and not _is_one_of(field) else ".")
        if any(get_origin(kind) is dict for kind in kinds):
            continue  # its keys are the user's
        for other in below:
            yield from setting_keys(other, inner)


def _is_one_of(field: Any) -> bool:
    """True if a field is one table of several kinds, and no list of tables."""
    return all(isinstance(kind, type) for kind, _ in field.leaves)


def complete_setting(plan: bool = False) -> Complete:
    """Completion of ``KEY=VALUE``: keys of scenarios, or of plans, and values that are words.

    Shells differ in what they call a word: some split it at the sign.
    """

    def complete(
        ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        from springback.campaign.design.plan import Plan
        from springback.scenario.scenario import Scenario

        known: dict[str, tuple[str, ...]] = {}
        for key, words in setting_keys(Plan if plan else Scenario):
            known[key] = tuple(dict.fromkeys((*known.get(key, ()), *words)))
        key, sign, begun = incomplete.partition("=")
        if sign:
            return [CompletionItem(f"{key}={w}") for w in known.get(key, ()) if w.startswith(begun)]
        before = [word for word in ctx.params.get(str(param.name)) or () if word != "="]
        if before and before[-1] in known:  # bash: the sign was a word of its own
            return _items([*known[before[-1]]], incomplete)
        return _items([f"{key}=" for key in known], incomplete)

    return complete
