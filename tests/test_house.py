"""Rules of the house that no tool checks."""

import ast
import importlib
import re
from pathlib import Path

import pytest

import springback
from builders.cases import nonempty

ROOT = Path(__file__).parents[1]
SOURCE = sorted((ROOT / "src" / "springback").rglob("*.py"))
#: Most of a module.
LINES = 500
#: Everything else that is read as code.
OTHER = [
    path
    for room in ("tests", "studies", "benchmarks", "examples", "tools")
    for path in sorted((ROOT / room).rglob("*.py"))
]


def test_every_public_name_exists() -> None:
    for name in nonempty(springback.__all__):
        assert getattr(springback, name) is not None


@pytest.mark.parametrize("path", SOURCE, ids=lambda p: str(p.relative_to(ROOT)))
def test_modules_stay_small_and_silent(path: Path) -> None:
    text = path.read_text()
    assert len(text.splitlines()) <= LINES
    if "interfaces" not in path.parts:
        assert not [
            node for node in ast.walk(ast.parse(text))
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "print"
        ]  # fmt: skip


def test_tests_and_studies_stay_small() -> None:
    for path in nonempty(OTHER):
        assert len(path.read_text().splitlines()) <= LINES, path.relative_to(ROOT)


def index() -> list[tuple[str, str, str]]:
    rows = re.findall(
        r"^\| \((\d+)\) \|.*?\| `(.*?)` \| `(.*?)` \|$",
        (ROOT / "docs/paper/equations.md").read_text(),
        re.M,
    )
    assert len(rows) >= 12
    return rows


@pytest.mark.parametrize(("number", "function", "test"), index())
def test_equation_index_leads_to_functions_and_tests(number: str, function: str, test: str) -> None:
    module, _, name = function.rpartition(".")
    assert callable(getattr(importlib.import_module(module), name))
    assert (ROOT / test).is_file()


def found_in_source(pattern: str) -> list[tuple[str, ...]]:
    """Every match: its file and its groups."""
    return [
        (str(path), *match.groups())
        for path in SOURCE
        for match in re.finditer(pattern, path.read_text())
    ]


def test_equations_named_in_the_source_stand_in_the_index() -> None:
    known = {int(number) for number, _, _ in index()}
    for path, first, last in nonempty(found_in_source(r"[Ee]qs?\. \((\d+)\)(?:-\((\d+)\))?")):
        assert set(range(int(first), int(last or first) + 1)) <= known, path


def test_pages_that_the_source_points_to_exist() -> None:
    for path, page in nonempty(
        found_in_source(r"\b((?:docs|tests|studies)/[\w/.-]+\.(?:md|py))\b")
    ):
        assert (ROOT / page).is_file(), f"{path}: {page}"
    for path, number in nonempty(found_in_source(r"docs/decisions/(\d{4})")):
        pages = (ROOT / "docs/decisions").glob(f"{number}-*.md")
        assert list(pages), f"{path}: decision {number}"


def test_random_numbers_have_one_owner() -> None:
    """Generators are made in one module, the key of noise in another (docs/decisions/0010)."""
    makers = re.compile(
        r"\b(?:default_rng|SeedSequence|RandomState|PCG64|SFC64|Philox)\(|import random"
    )
    found = {path.stem for path in SOURCE if makers.search(path.read_text())}
    assert found == {"noise", "random_streams"}
