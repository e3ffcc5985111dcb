"""Rules of the rooms: what a folder holds, and who may import whom.

Every kind of import counts: at the top of a module, inside a function, for type checkers only, and
by a string that names a module.
"""

from __future__ import annotations

import ast
import itertools
import re
import tomllib
from collections import Counter, defaultdict
from collections.abc import Iterator
from functools import cache
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

SRC = Path(__file__).parents[1] / "src"
PACKAGE = SRC / "springback"
FOLDERS = sorted({path.parent for path in PACKAGE.rglob("*.py")})
#: Modules of a folder at most.
MOST = 15


def name_of(path: Path) -> str:
    parts = path.relative_to(SRC).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


MODULES = {name_of(path): path for path in sorted(PACKAGE.rglob("*.py"))}


@cache
def tree_of(module: str) -> ast.Module:
    return ast.parse(MODULES[module].read_text())


def modules_in(folder: Path) -> list[str]:
    return [path.stem for path in folder.glob("*.py") if not path.stem.startswith("__")]


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda f: str(f.relative_to(SRC)))
def test_a_folder_is_seen_at_a_glance(folder: Path) -> None:
    assert len(modules_in(folder)) <= MOST


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda f: str(f.relative_to(SRC)))
def test_a_prefix_that_three_files_share_is_a_folder(folder: Path) -> None:
    shared = Counter(stem.partition("_")[0] for stem in modules_in(folder))
    assert {prefix: count for prefix, count in shared.items() if count >= 3} == {}


# -- imports --------------------------------------------------------------------------------------


def named(full: str) -> str | None:
    """The module that a dotted name is, or is in."""
    while full and full not in MODULES:
        full = full.rpartition(".")[0]
    return full or None


def imports(module: str) -> Iterator[tuple[str, str]]:
    """Modules that a module imports, each with the name that it takes from there."""
    for node in ast.walk(tree_of(module)):
        if isinstance(node, ast.Import):
            names = [(alias.name, "") for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{module}: line {node.lineno}: a relative import"
            names = [(f"{node.module}.{alias.name}", alias.name) for alias in node.names]
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            names = [(node.value, "")] if node.value in MODULES else []
            names = [] if node.value == "springback" else names
        else:
            continue
        for full, name in names:
            if full.partition(".")[0] == "springback" and (found := named(full)):
                yield found, name


def is_private(name: str) -> bool:
    return name.startswith("_") and not name.startswith("__")


def test_nobody_imports_in_a_circle() -> None:
    # The package itself names all that it gives, each loaded when first used; of it modules may
    # import nothing, and so it is above all.
    graph = {m: {other for other, _ in imports(m) if other != m} for m in MODULES}
    assert sum(map(len, graph.values())) > 800
    assert [m for m, others in graph.items() if "springback" in others and m != "springback"] == []
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        pytest.fail(" -> ".join(error.args[1]))


def test_nobody_takes_a_private_name_from_another_module() -> None:
    taken = []
    for module in MODULES:
        local = {
            alias.asname or alias.name
            for node in ast.walk(tree_of(module)) if isinstance(node, ast.ImportFrom)
            for alias in node.names if f"{node.module}.{alias.name}" in MODULES
        }  # fmt: skip
        taken += [(module, name) for _, name in imports(module) if is_private(name)]
        taken += [
            (module, ast.unparse(node)) for node in ast.walk(tree_of(module))
            if isinstance(node, ast.Attribute) and is_private(node.attr)
            and isinstance(node.value, ast.Name) and node.value.id in local
        ]  # fmt: skip
    assert taken == []


def test_a_class_has_its_name_alone() -> None:
    places = defaultdict(list)
    for module in MODULES:
        for node in ast.walk(tree_of(module)):
            if isinstance(node, ast.ClassDef):
                places[node.name].append(module)
    assert len(places) > 400
    assert {name: where for name, where in places.items() if len(where) > 1} == {}


#: Who may know the paper: its experiments, the report on them, the lab that shows its numbers,
#: and what hands them all out.
KNOW_THE_PAPER = re.compile(r"springback(\.(paper|interfaces\.(reproduction|lab|cli))(\..*)?)?")


def test_only_those_about_the_paper_know_it() -> None:
    found = [
        (module, other)
        for module in MODULES if not KNOW_THE_PAPER.fullmatch(module)
        for other, _ in imports(module)
        if other.startswith(("springback.paper", "springback.interfaces.reproduction"))
    ]  # fmt: skip
    assert found == []


# -- what is written about them -------------------------------------------------------------------


def test_contributing_names_every_room_in_their_order() -> None:
    """The table's rows are the packages, each below those that it imports from."""
    written = (SRC.parent / "CONTRIBUTING.md").read_text(encoding="utf-8")
    rooms = re.findall(r"^\| `(\w+)` \| ", written, re.M)
    assert set(rooms) == {path.parent.name for path in PACKAGE.glob("*/__init__.py")}
    contracts = tomllib.loads((SRC.parent / "pyproject.toml").read_text(encoding="utf-8"))
    layers = contracts["tool"]["importlinter"]["contracts"][0]["layers"][::-1]
    depth = {room: k for k, layer in enumerate(layers) for room in layer.split(" | ")}
    assert all(depth[a] <= depth[b] for a, b in itertools.pairwise(rooms))


def test_a_newcomers_questions_have_files_for_answers() -> None:
    """Twenty and more; what is asked of a file is in it or beside it by name."""
    written = (SRC.parent / "CONTRIBUTING.md").read_text(encoding="utf-8")
    table = written.split("| where is … | file |")[1].split("\n\n")[0]
    answers = [re.findall(r"`([\w/]+\.py)`", line) for line in table.splitlines()[2:]]
    assert len(answers) >= 20
    assert all(answers)
    assert [name for names in answers for name in names if not (PACKAGE / name).is_file()] == []


def returned_names(node: ast.FunctionDef) -> set[str]:
    return (
        {n.id for n in ast.walk(node.returns) if isinstance(n, ast.Name)} if node.returns else set()
    )


def test_no_kernel_returns_arrays() -> None:
    """A kernel counts no references: its caller would free an array that it returns."""
    nodes = [node for module in MODULES for node in ast.walk(tree_of(module))]
    fields = {
        node.name: {n.id for f in node.body if isinstance(f, ast.AnnAssign)
                    for n in ast.walk(f.annotation) if isinstance(n, ast.Name)}
        for node in nodes if isinstance(node, ast.ClassDef)
    }  # fmt: skip
    arrays = {"Buffer", "Words", "Array"}
    while more := {name for name, held in fields.items() if held & arrays} - arrays:
        arrays |= more
    assert {"FlightBuffers", "Lanes", "Group", "NoiseStream"} <= arrays
    marks = {"kernel", "guard", "rare_kernel", "generic"}
    kernels = [
        node for node in nodes if isinstance(node, ast.FunctionDef)
        and any(isinstance(d, ast.Name) and d.id in marks for d in node.decorator_list)
    ]  # fmt: skip
    assert len(kernels) > 300
    assert [node.name for node in kernels if returned_names(node) & arrays] == []
