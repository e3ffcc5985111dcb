"""Mutations of the physics are made of the source as it is, and tests notice some of each room's."""

from __future__ import annotations

from pathlib import Path

import pytest

from builders.cases import nonempty
from oracles import mutations

HERE = Path(__file__).parent
PACKAGE = HERE.parent / "src" / "springback"
#: A mutation of each room that single states show; `make mutations` tries all.
SAMPLE = (
    "normal points out",
    "spring, sign",
    "arm velocity, l̇ sign",
    "quaternion rate, one term",
    "impact never settles",
)
#: Tests in plain Python, one for each sort: of contacts, of one instant, of a step's rules.
TESTS = (
    "contact/test_cages.py dynamics/test_conservation.py simulation/test_observed.py",
    "gap_changes_at_its_rate or power_balances or settled_arms",
)


def test_every_mutation_applies() -> None:
    """Each changes one place and leaves Python behind; code that moves takes its mutations along."""
    assert mutations.outdated(PACKAGE) == []


def test_mutations_have_names_of_their_own() -> None:
    names = [mutation.name for mutation in mutations.MUTATIONS]
    assert len(set(names)) == len(names)


def test_mutations_name_tests_that_exist() -> None:
    for mutation in nonempty(mutations.MUTATIONS):
        for place in nonempty(mutation.tests[0].split()):
            assert (HERE / place).exists(), mutation.name


@pytest.fixture(scope="module")
def unmutated() -> set[str]:
    return mutations.mutated(PACKAGE, None, TESTS, first=True)


@pytest.mark.parametrize("name", SAMPLE)
def test_a_flipped_sign_is_noticed(name: str, unmutated: set[str]) -> None:
    [mutation] = [one for one in mutations.MUTATIONS if one.name == name]
    assert unmutated == set()
    assert mutations.mutated(PACKAGE, mutation, TESTS, first=True)


def test_the_sample_is_of_different_rooms() -> None:
    rooms = [one.path.partition("/")[0] for one in mutations.MUTATIONS if one.name in SAMPLE]
    assert sorted(rooms) == ["contact", "dynamics", "kernels", "simulation", "vehicle"]
