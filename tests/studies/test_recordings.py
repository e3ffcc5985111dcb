"""Recordings of others: reading them, and the impulse law beside them.

The recordings themselves have no licence: these tests write files of the same form.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from scipy.io import savemat

from springback.errors import InputError
from springback.interfaces.cli.app import cli
from springback.studies.recordings.impulse_predictions import (
    FROZEN,
    errors_of,
    fit_law,
    impact_sentences,
    misfit,
    predict_impacts,
    velocities_after,
)
from springback.studies.recordings.planar_impacts import (
    GYRATION,
    MODELS,
    PlanarImpacts,
    at_contact,
    read_planar_impacts,
    spin_by_impulse,
    unexplained_spin,
)

COUNT, RESTITUTION, FRICTION = 40, 0.6, 0.15


def drawn(count: int = COUNT, restitution: float = RESTITUTION, friction: float = FRICTION) -> Any:
    """Impacts of an ellipse of semi-axes 35 and 25 mm, as the law itself makes them."""
    chance = np.random.default_rng(2)
    angle = chance.uniform(-np.pi, np.pi, count)
    height = np.hypot(0.035 * np.sin(angle), 0.025 * np.cos(angle))
    aside = -(0.035**2 - 0.025**2) * np.sin(angle) * np.cos(angle) / height
    before = np.column_stack(
        [chance.normal(0, 0.5, count), -chance.uniform(2, 3, count), chance.normal(0, 4, count)]
    )
    lever = np.column_stack([aside, -height])
    models = np.zeros((count, len(MODELS), 3))
    one = PlanarImpacts(before, before, lever, models)
    return one._replace(after=velocities_after(one, restitution, friction))


def written(folder: Path, impacts: PlanarImpacts, **others: Any) -> Path:
    """The files of the recordings, with ẋ as it is there."""
    count = len(impacts.before)
    turned = np.array([-1.0, 1.0, 1.0])
    place = np.zeros((count, 3))
    ones, none = np.ones(count), np.zeros(count)
    data = {
        "states_i": np.hstack([place, impacts.before * turned]),
        "states_f": np.hstack([place, impacts.after * turned]),
        "n": np.column_stack([none, ones, impacts.lever[:, 0]]),
        "d": np.column_stack([ones, none, -impacts.lever[:, 1]]),
        **others,
    }
    inside = folder / "processed_data"
    inside.mkdir(parents=True)
    savemat(inside / "data_ellipse.mat", {"data": data})
    models = (impacts.models * turned).reshape(count, -1)
    savemat(inside / "v_models.mat", {"v_models": models})
    return folder


def test_impacts_come_back_as_they_were_written(tmp_path: Path) -> None:
    impacts = drawn()
    read = read_planar_impacts(written(tmp_path / "copy", impacts))
    for ours, theirs in zip(read, impacts, strict=True):
        assert np.allclose(ours, theirs, atol=1e-15)
    inside = read_planar_impacts(tmp_path / "copy" / "processed_data")
    assert np.array_equal(inside.before, read.before)


def test_the_law_keeps_momentum_and_bounces_as_it_should() -> None:
    """The impulse acts at the contact point, within the cone of friction, and takes energy."""
    impacts = drawn()
    assert unexplained_spin(impacts) < 1e-9
    assert np.allclose(spin_by_impulse(impacts), impacts.after[:, 2], atol=1e-9)
    gain = impacts.after - impacts.before
    assert (np.abs(gain[:, 0]) <= FRICTION * gain[:, 1] + 1e-9).all()
    weighed = np.array([1.0, 1.0, GYRATION])
    energies = [np.sum((v * weighed) ** 2, axis=1) for v in (impacts.before, impacts.after)]
    assert (energies[1] < energies[0]).all()
    frictionless = velocities_after(impacts, RESTITUTION, 0.0)
    into, out = (at_contact(v, impacts.lever)[:, 1] for v in (impacts.before, frictionless))
    assert np.allclose(out, -RESTITUTION * into, rtol=1e-6)
    # With ẋ of the wrong sign the same impacts would contradict themselves.
    turned = np.array([-1.0, 1.0, 1.0])
    mirrored = impacts._replace(before=impacts.before * turned, after=impacts.after * turned)
    assert unexplained_spin(mirrored) > 0.5


def test_the_numbers_that_made_impacts_are_found_again() -> None:
    law = fit_law(drawn())
    assert law.restitution == pytest.approx(RESTITUTION, abs=2e-3)
    assert law.friction == pytest.approx(FRICTION, abs=2e-3)
    assert law.misfit < 1e-3


def test_predictions_are_those_of_numbers_fitted_on_the_first_fifth() -> None:
    impacts = drawn()
    # What comes later follows another law, which must not leak into the fit.
    other = drawn(restitution=0.3)
    after = np.where(np.arange(COUNT)[:, None] < COUNT // 5, impacts.after, other.after)
    found = predict_impacts(impacts._replace(after=after))
    assert found.law.impacts == COUNT // 5
    assert found.law.restitution == pytest.approx(RESTITUTION, abs=5e-3)
    ours = found.rest[0]
    assert ours.at_contact[0] == pytest.approx(0.6 / 0.3 - 1.0, rel=0.2)
    assert [row.model for row in found.rest[1:-1]] == list(MODELS)
    assert predict_impacts(impacts, FROZEN).law is FROZEN
    assert "restitution 0.589" in impact_sentences(predict_impacts(impacts, FROZEN))[0]


def test_errors_are_of_what_was_measured() -> None:
    impacts = drawn()
    told = errors_of("twice", 2.0 * impacts.after, impacts)
    assert told.normal == pytest.approx((1.0, 1.0))
    assert told.spin == pytest.approx((1.0, 1.0))
    assert errors_of("same", impacts.after, impacts).misfit == (0.0, 0.0)
    off = impacts.after + np.array([0.0, 0.0, 1.0])
    speeds = np.linalg.norm(impacts.before * [1.0, 1.0, GYRATION], axis=1)
    assert misfit(off, impacts) == pytest.approx(GYRATION / speeds)


def test_the_command_writes_numbers_and_a_figure(tmp_path: Path) -> None:
    copy = written(tmp_path / "copy", drawn())
    out = tmp_path / "out"
    ran = CliRunner().invoke(cli, ["study", "impacts", str(copy), "--out", str(out)])
    assert ran.exit_code == 0, ran.output
    assert "restitution 0.6" in ran.output
    names = {path.name for path in out.iterdir()}
    assert {"impacts.json", "impacts.csv", "predicted.png", "predicted.csv"} <= names


@pytest.mark.parametrize(
    ("others", "words"),
    [
        ({"states_i": np.zeros((COUNT, 5))}, r"data\.states_i: must have 6 columns \(got 40 x 5\)"),
        ({"n": np.full((COUNT, 3), np.nan)}, r"data\.n: must be finite"),
        ({"d": np.zeros((3, 3))}, "must have 40 rows and 18 columns"),
    ],
)
def test_files_of_another_form_are_refused(
    tmp_path: Path, others: dict[str, Any], words: str
) -> None:
    with pytest.raises(InputError, match=words):
        read_planar_impacts(written(tmp_path / "copy", drawn(), **others))


def test_a_folder_without_recordings_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"has no data_ellipse\.mat; name a copy of github"):
        read_planar_impacts(tmp_path)
    (tmp_path / "data_ellipse.mat").write_text(
        "no MATLAB file, but long enough to be read as one" * 9
    )
    with pytest.raises(InputError, match="is no MATLAB file that can be read"):
        read_planar_impacts(tmp_path)
    ran = CliRunner().invoke(cli, ["study", "impacts", str(tmp_path), "--out", str(tmp_path / "o")])
    assert isinstance(ran.exception, InputError)
    assert not (tmp_path / "o").exists()
