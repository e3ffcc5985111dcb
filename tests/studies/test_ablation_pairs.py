"""Two changes at a time: what neither brings about alone."""

from __future__ import annotations

from springback.interfaces.figures.ablation import pairs_figure
from springback.studies.ablation_pairs import CHANGES, Pair, PairResults, fly_pairs, pair_sentences

NAMED = {change.cause: change for change in CHANGES}


def test_names_are_unique() -> None:
    assert len(NAMED) == len(CHANGES)


def test_noise_and_trust_lose_quad_only_together() -> None:
    results = fly_pairs(4, changes=(NAMED["pose noise"], NAMED["clipping"], NAMED["compliance"]))
    for name in ("none", "pose noise", "clipping"):
        pair = results.at(name, name, "quad")
        assert pair is not None
        assert pair.successes == 4, name
    both = results.at("clipping", "pose noise", "quad")
    assert both is not None
    assert both.successes <= 1
    locked = results.at("compliance", "compliance", "quad")
    assert locked is not None  # Quad has no arms to lock: it flies as it is
    assert locked.successes == 4
    assert len(pairs_figure(results).axes) == 2


def test_a_split_is_told_with_both_names() -> None:
    results = PairResults([
        Pair("none", "none", "arq", 10, 10), Pair("none", "none", "quad", 10, 10),
        Pair("range", "lag", "arq", 9, 10), Pair("range", "lag", "quad", 1, 10),
    ])  # fmt: skip
    (told,) = pair_sentences(results)
    assert NAMED["range"].name in told
    assert NAMED["lag"].name in told
    assert "Quad in 1 of 10" in told
    assert "no pair" in pair_sentences(PairResults(results.pairs[:2]))[0]
