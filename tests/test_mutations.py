"""Mutations of the physics are made of the source as it stands."""

from __future__ import annotations

from pathlib import Path

from oracles import mutations


def test_every_mutation_applies() -> None:
    """Each changes one place and leaves Python behind; code that moves takes its mutations along."""
    assert mutations.outdated(Path(__file__).parents[1] / "src" / "springback") == []


def test_mutations_have_names_of_their_own() -> None:
    names = [mutation.name for mutation in mutations.MUTATIONS]
    assert len(set(names)) == len(names)


def test_the_tests_beside_them_exist() -> None:
    """A file that moved would be no test at all."""
    tests = Path(__file__).parent
    named = {name for mutation in mutations.MUTATIONS for name in mutation.tests[0].split()}
    assert named
    assert [name for name in named if not (tests / name).exists()] == []
