"""Names follow docs/glossary.md, and every public module is in the API's pages."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any, get_args

from springback.campaign.design.plan import Plan
from springback.scenario.scenario import Scenario
from springback.settings import Settings

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / "src" / "springback"
DOCS = ROOT / "docs"
GLOSSARY = (DOCS / "glossary.md").read_text(encoding="utf-8")
MODULES = sorted(path for path in PACKAGE.rglob("*.py") if not path.stem.startswith("_"))


def words(name: str) -> list[str]:
    """Words of a name, by underscores and capitals: `GPUError` is gpu, error."""
    return [w.lower() for w in re.findall(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+", name)]


def section(title: str) -> str:
    """The text under a heading of the glossary."""
    [found] = re.findall(rf"^## {title}\n(.*?)(?=^## |\Z)", GLOSSARY, re.M | re.S)
    return str(found)


def rows(title: str) -> list[list[str]]:
    """Cells of a section's table, head left out."""
    lines = [line for line in section(title).splitlines() if line.startswith("| ")]
    return [[cell.strip() for cell in line.strip("|").split(" | ")] for line in lines[1:]]


def listed(text: str) -> set[str]:
    return {w for name in re.findall(r"[A-Za-z_-]+", text) for w in words(name)}


@cache
def terms() -> frozenset[str]:
    return frozenset().union(*(listed(row[0]) for row in rows("Terms")))


@cache
def plain() -> frozenset[str]:
    return frozenset(listed(section("Plain words").partition("\n\n")[2]))


@cache
def retired() -> frozenset[str]:
    return frozenset().union(*(listed(row[0]) for row in rows("Retired words")))


def singular(word: str) -> str:
    return word[:-1] if word.endswith("s") and not word.endswith("ss") else word


def is_known(word: str) -> bool:
    return bool({word, singular(word)} & (terms() | plain()))


def public_names() -> Iterator[tuple[str, str]]:
    """Of each module and each public class: where it is, and its name."""
    for path in MODULES:
        where = path.relative_to(PACKAGE)
        yield from ((str(where), part) for part in where.with_suffix("").parts)
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                yield str(where), node.name


def other_names() -> Iterator[tuple[str, str]]:
    """Functions and private classes, and keys of scenarios and plans."""
    for path in MODULES:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ClassDef) and node.name.startswith("_"):
                yield str(path.relative_to(PACKAGE)), node.name
            if isinstance(node, ast.FunctionDef) and not node.name.startswith("_"):
                yield str(path.relative_to(PACKAGE)), node.name
    yield from (("a key of a table", key) for key in keys())


def tables_of(annotation: Any) -> list[type[Settings]]:
    if isinstance(annotation, type) and issubclass(annotation, Settings):
        return [annotation]
    return [inner for part in get_args(annotation) for inner in tables_of(part)]


def keys() -> set[str]:
    """Every key that a scenario or a plan may have, in whichever of its tables."""
    found, ahead, seen = set(), [Scenario, Plan], set()
    while ahead:
        table = ahead.pop()
        if table not in seen:
            seen.add(table)
            for name, field in table.model_fields.items():
                found.add(field.alias or name)
                ahead += tables_of(field.annotation)
                ahead += [inner for one in field.metadata for inner in tables_of(one)]
    return found


def test_the_glossary_is_read() -> None:
    """Against a test that finds no names, no terms or no keys."""
    assert len(rows("Terms")) >= 40
    assert all(len(row) == 5 for row in rows("Terms"))
    assert {"kernel", "telemetry", "evaluator", "wrench"} <= terms()
    assert len(plain()) > 100
    assert len(list(public_names())) > 900
    assert len(list(other_names())) > 900
    assert {"stiffness", "kalman", "vary"} <= keys()
    assert words("GPUError") == ["gpu", "error"]
    assert words("Mat3") == ["mat"]


def test_modules_and_classes_are_named_in_the_words_of_the_glossary() -> None:
    unknown = [
        f"{where}: {name}: {word!r} is neither a term nor a plain word of docs/glossary.md"
        for where, name in public_names() for word in words(name) if not is_known(word)
    ]  # fmt: skip
    assert unknown == []


def test_nothing_is_named_by_a_retired_word() -> None:
    found = [
        (where, name)
        for names in (public_names(), other_names()) for where, name in names
        if retired() & set(words(name))
    ]  # fmt: skip
    assert found == []


#: Past participles that do not end in -ed; those that look like their imperative (`read`) are fine.
IRREGULAR = listed(
    """begun bent bought brought built caught chosen drawn dealt driven fallen felt flown found
    frozen given gone gotten grown heard held hidden kept known laid left lent lost made meant met
    paid said seen sent shown sought spoken stood struck sunk swept taken taught thought told torn
    turned understood won worn woven written"""
)
#: Words in -ed that are nouns or imperatives.
NOT_PARTICIPLES = frozenset({"embed", "exceed", "feed", "need", "proceed", "seed", "speed"})
#: Participles that may name a function, and why.
ALLOWED: dict[str, str] = {}


def public_functions() -> Iterator[tuple[str, str]]:
    """Functions of modules, and methods and properties of classes."""
    for path in MODULES:
        module = ast.parse(path.read_text(encoding="utf-8"))
        bodies = [module.body, *(n.body for n in module.body if isinstance(n, ast.ClassDef))]
        for node in (node for body in bodies for node in body):
            if isinstance(node, ast.FunctionDef) and not node.name.startswith("_"):
                yield str(path.relative_to(PACKAGE)), node.name


def is_participle(name: str) -> bool:
    return name in IRREGULAR or (
        name.endswith("ed") and "_" not in name and name not in NOT_PARTICIPLES
    )


def test_no_public_function_is_named_by_a_bare_participle() -> None:
    """A noun for what is returned, an imperative for what changes state; `limited_rates` is one."""
    functions = list(public_functions())
    assert len(functions) > 1000
    assert is_participle("limited")
    assert not is_participle("limited_rates")
    found = [
        (where, name) for where, name in functions if is_participle(name) and name not in ALLOWED
    ]
    assert found == []
    assert set(ALLOWED) <= {name for _, name in functions}


def test_no_retired_word_is_listed_and_none_is_listed_twice() -> None:
    assert not retired() & (terms() | plain())
    assert not {word for word in plain() if word in terms()}


def test_every_plain_word_is_used() -> None:
    """A list that only grows would allow every name in the end."""
    used = {form for _, name in public_names() for w in words(name) for form in (w, singular(w))}
    assert plain() - used == set()


def test_api_pages_list_every_module() -> None:
    pages = [path.read_text(encoding="utf-8") for path in (DOCS / "api/modules").glob("*.md")]
    listed = re.findall(r"^   (springback\S+)$", "\n".join(pages), re.M)
    modules = [".".join(path.relative_to(PACKAGE.parent).with_suffix("").parts) for path in MODULES]
    wanted = sorted(m for m in modules if not m.startswith("springback.interfaces.cli."))
    assert len(wanted) > 200
    assert sorted(listed) == wanted


#: Retired words that ordinary sentences do not need either, and idioms that no engineer writes.
UNIDIOMATIC = re.compile(
    r"\b(luck|lucky|aboard|cabin|diary|witness\w*|abreast|knobs?|nobody|whoever|lest|had better)\b",
    re.IGNORECASE,
)
PAGES = [
    *(ROOT / name for name in ("README.md", "CONTRIBUTING.md", "SECURITY.md")),
    *(p for p in sorted(DOCS.rglob("*.md")) if "_build" not in p.parts),
    *sorted((ROOT / "examples").iterdir()),
    ROOT / "studies/README.md",
]


def test_pages_are_written_in_the_words_of_the_glossary() -> None:
    """But for the two that name the words of old."""
    pages = [
        p for p in PAGES if p.is_file() and p.name not in ("glossary.md", "0021-rooms-and-words.md")
    ]
    assert len(pages) > 60
    found = [
        (str(page.relative_to(ROOT)), number, word)
        for page in pages
        for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), start=1)
        for word in UNIDIOMATIC.findall(line)
    ]
    assert found == []


def test_the_readme_is_as_wide_as_the_code() -> None:
    lines = (ROOT / "README.md").read_text(encoding="utf-8").splitlines()
    assert [line for line in lines if len(line) > 100 and not line.startswith("|")] == []
