"""A test that asserts only in loops has cases: literals, a fixed count, or `builders.cases.nonempty`."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest

from builders.cases import nonempty

HERE = Path(__file__).parent
#: Tests whose loops may be empty, and why that is no loss.
EXCEPTIONS: dict[str, str] = {}
#: Calls that have as many cases as what they are given.
KEEP = {
    "enumerate",
    "sorted",
    "list",
    "tuple",
    "reversed",
    "set",
    "iter",
    "items",
    "keys",
    "values",
}
#: Calls with a fixed number of cases, and the place of that number.
COUNTED = {"linspace": 2, "random_attitudes": 0, "uniform": 2}


def name_of(call: ast.Call) -> str:
    function = call.func
    return function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")


def is_fixed(node: ast.expr, known: set[str]) -> bool:
    """Whether a number, or a shape, is written in the source."""
    parts = node.elts if isinstance(node, ast.Tuple) else [node]
    return all(
        isinstance(part, ast.Constant | ast.UnaryOp) or has_cases(part, known) for part in parts
    )


def has_cases(node: ast.expr, known: set[str]) -> bool:
    """Whether something looped over is not empty as it is written; `known` are names of such things."""
    match node:
        case ast.Constant(value=value):
            return bool(value)
        case ast.List(elts=parts) | ast.Tuple(elts=parts) | ast.Set(elts=parts):
            return any(
                has_cases(p.value, known) if isinstance(p, ast.Starred) else True for p in parts
            )
        case ast.Dict(keys=keys):
            return any(key is not None for key in keys)
        case ast.Name(id=name):
            return name in known
        case ast.BinOp(left=left, op=ast.Add() | ast.BitOr(), right=right):
            return has_cases(left, known) or has_cases(right, known)
        case ast.ListComp() | ast.SetComp() | ast.DictComp() | ast.GeneratorExp():
            return all(has_cases(g.iter, known) and not g.ifs for g in node.generators)
        case ast.Call(func=function, args=args):
            name = name_of(node)
            if name in KEEP:
                of = args[0] if args else getattr(function, "value", None)
                return of is not None and has_cases(of, known)
            if name in COUNTED:
                return len(args) > COUNTED[name] and is_fixed(args[COUNTED[name]], known)
            if name in ("zip", "product"):
                return bool(args) and all(has_cases(one, known) for one in args)
            if name == "range" and all(isinstance(one, ast.Constant) for one in args):
                return bool(range(*map(ast.literal_eval, args)))
            return name == "nonempty" or (
                name == "range" and all(is_fixed(one, known) for one in args)
            )
    return False


def with_cases(body: Iterable[ast.stmt], known: set[str]) -> set[str]:
    """Names that are given to something with cases, beside those known before."""
    given, found = {}, set(known)
    nodes = [node for statement in body for node in ast.walk(statement)]
    for node in nodes:
        if isinstance(node, ast.Assign | ast.AnnAssign) and node.value is not None:
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            given |= {id(target): node.value for target in targets}
    names = [n for n in nodes if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)]
    for name in sorted(names, key=lambda name: name.lineno):
        value = given.get(id(name))
        (found.add if value is not None and has_cases(value, found) else found.discard)(name.id)
    return found


def assertions(node: ast.AST, known: set[str], empty: str = "") -> Iterator[str]:
    """For each assertion the loop around it that may have no case, or an empty string."""
    if isinstance(node, ast.Assert) or (
        isinstance(node, ast.Call) and name_of(node).startswith(("raises", "warns", "assert"))
    ):
        yield empty
    for child in ast.iter_child_nodes(node):
        within = empty
        if isinstance(node, ast.For) and child in node.body and not has_cases(node.iter, known):
            within = empty or f"line {node.lineno}: {ast.unparse(node.iter)}"
        yield from assertions(child, known, within)


def idle(tree: ast.Module) -> dict[str, str]:
    """Tests of a file that may assert nothing: each with a loop that may have no case."""
    outside = [node for node in tree.body if not isinstance(node, ast.FunctionDef | ast.ClassDef)]
    known = with_cases(outside, set())
    found = {}
    for test in ast.walk(tree):
        if isinstance(test, ast.FunctionDef) and test.name.startswith("test_"):
            loops = list(assertions(test, with_cases(test.body, known)))
            if loops and all(loops):
                found[test.name] = loops[0]
    return found


def test_tests_that_assert_in_loops_have_cases() -> None:
    found = {
        f"{path.relative_to(HERE)}::{name}": loop
        for path in nonempty(HERE.rglob("test_*.py"))
        for name, loop in idle(ast.parse(path.read_text("utf-8"))).items()
    }
    assert {name: loop for name, loop in found.items() if name not in EXCEPTIONS} == {}
    assert set(EXCEPTIONS) <= set(found)
    assert all(EXCEPTIONS.values())


@pytest.mark.parametrize(
    ("loop", "may_be_empty"),
    [
        ("for x in (1, 2): assert x", False),
        ("for x in range(3): assert x", False),
        ("for x in range(0, 3): assert x", False),
        ("for x in range(0): assert x", True),
        ("for x in range(count): assert x", True),
        ("count = 3\n for x in range(count): assert x", False),
        ("xs = (1, 2)\n for x in xs: assert x", False),
        ("xs = (1, 2)\n xs = found()\n for x in xs: assert x", True),
        ("for x in np.linspace(0.0, 1.0, 3): assert x", False),
        ("for x in (): assert x", True),
        ("for x in found(): assert x", True),
        ("for x in nonempty(found()): assert x", False),
        ("for k, x in enumerate(found()): assert x", True),
        ("for x in (1, 2):\n  for y in found(x): assert y", True),
        ("for x in nonempty(found()):\n  for y in 'xyz': assert y", False),
        ("for x in [y for y in (1, 2) if y > 3]: assert x", True),
        ("for x in found():\n  with pytest.raises(ValueError): x()", True),
        ("for x in found(): assert x\n assert found()", False),
        ("for x in CASES.items(): assert x", False),
        ("for x in IMPORTED.items(): assert x", True),
    ],
)
def test_loops_that_may_be_empty_are_found(loop: str, may_be_empty: bool) -> None:
    text = f"from elsewhere import IMPORTED\nCASES = {{1: 2}}\ndef test_it():\n {loop}\n"
    assert bool(idle(ast.parse(text))) == may_be_empty


def test_no_case_is_no_test() -> None:
    with pytest.raises(AssertionError, match="no case"):
        nonempty(())
    assert nonempty(iter("ab")) == ["a", "b"]


def imported(node: ast.AST) -> list[str]:
    """Modules that a statement imports, or a script that it runs."""
    match node:
        case ast.Import(names=names):
            return [name.name for name in names]
        case ast.ImportFrom(module=str() as module):
            return [module]
        case ast.Call() if name_of(node) == "run_path":
            return [ast.unparse(node)]
    return []


def test_no_test_imports_another() -> None:
    """What several tests share is in `builders`."""
    for path in nonempty(HERE.rglob("*.py")):
        names = [
            name for node in ast.walk(ast.parse(path.read_text("utf-8"))) for name in imported(node)
        ]
        assert [name for name in names if re.search(r"\btest_", name)] == [], path
