"""The tab key: what is offered is what the command takes."""

from pathlib import Path

import pytest
from click.shell_completion import ShellComplete, get_completion_class

from springback.errors import InputError
from springback.interfaces.cli.app import cli
from springback.interfaces.cli.completion import presets, setting_keys
from springback.problems import key_path
from springback.scenario.fields import number_at
from springback.scenario.scenario import Scenario, scenario_from


def offered(*words: str) -> list[str]:
    """What is offered for the last word."""
    found = ShellComplete(cli, {}, "springback", "_SPRINGBACK_COMPLETE").get_completions(
        list(words[:-1]), words[-1]
    )
    return [item.value for item in found]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    for name in ("a.toml", "b.py", "deep/c.toml", "deep/deeper/d.toml", ".hidden.toml", "note.txt"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("")
    (tmp_path / "b.py").write_text(
        "def hover(): ...\ndef _secret(): ...\nPOLE = 1\nclass Pole: ...\n"
    )
    (tmp_path / "bad.py").write_text("def (")
    return tmp_path


def test_files_are_offered_by_kind(folder: Path) -> None:
    assert offered("fly", "") == ["a.toml", "deep/c.toml", "deep/deeper/d.toml"]
    assert offered("campaign", "de") == ["deep/c.toml", "deep/deeper/d.toml"]
    assert offered("fly", "deep/d") == ["deep/deeper/d.toml"]
    assert offered("fly", f"{folder}/a") == [f"{folder}/a.toml"]
    assert offered("fly", "none/") == []


def test_names_in_python_files_are_offered_without_running_them(folder: Path) -> None:
    assert offered("fly", "a.toml", "--pilot", "b") == ["b.py:hover", "b.py:POLE", "b.py:Pole"]
    assert offered("check", "b.py:h") == ["b.py:hover"]
    assert offered("check", "") == [
        "a.toml", "deep/c.toml", "deep/deeper/d.toml", "b.py:hover", "b.py:POLE", "b.py:Pole",
    ]  # fmt: skip


def test_presets_are_offered() -> None:
    assert offered("show", "ar") == ["arq", "arq-slider", "arq-lumped"]
    assert offered("map", "--robot", "q") == ["quad", "quad-slider"]
    assert {"wall", "px4-ekf2", "arq"} <= set(presets())


def test_keys_and_words_of_overrides_are_offered() -> None:
    assert offered("fly", "a.toml", "vehicle.arms.st") == [
        "vehicle.arms.stiffness=", "vehicle.arms.stroke=", "vehicle.arms.stop_stiffness=",
        "vehicle.arms.stop_dissipation=",
    ]  # fmt: skip
    assert offered("fly", "a.toml", "control.attitude=l") == ["control.attitude=lee"]
    assert offered("fly", "a.toml", "vehicle=arq-") == ["vehicle=arq-slider", "vehicle=arq-lumped"]
    assert offered("fly", "a.toml", "reference.type=") == [
        f"reference.type={kind}" for kind in ("hold", "steps", "circle", "waypoints", "run-up")
    ]
    assert offered("campaign", "a.toml", "method=s") == ["method=sobol"]
    assert offered("campaign", "a.toml", "sam") == ["samples="]


def test_a_shell_that_splits_at_the_sign_gets_the_value_alone() -> None:
    """bash: `control.attitude=l` comes as three words."""
    assert offered("fly", "a.toml", "control.attitude", "=", "l") == ["lee"]
    assert offered("fly", "a.toml", "control.attitude", "=") == ["reduced", "full", "lee"]


def test_every_key_offered_is_one_of_a_scenario() -> None:
    surface = {"preset": "wall"}
    entry = {"type": "mat", "distance": 9.0, "surface": surface, "backing": surface}
    one = {"vehicle": "arq", "reference": {"type": "hold"}, "recovery": {}, "air": {}}
    other = one | {"start": {"position": [3.0, 0.0, 1.0]}, "surface": surface}
    full = scenario_from(one | {"world": {"obstacles": [entry]}, "second": other})
    strange = []
    keys = [key for key, _ in setting_keys(Scenario)]
    for key in keys:
        try:
            number_at(key, key_path(key), full, ())
        except InputError:
            strange.append(key)
    assert len(keys) - len(strange) > 200
    # of another kind of reference or obstacle than that of this scenario,
    # or of a hull, a component, a joint, a part of the body or a rotor listed: it has none
    keys = [key.removeprefix("second.") for key in strange]
    lists = (
        "vehicle.hulls.", "vehicle.limits.components.", "vehicle.arms.joint.",
        "vehicle.body.parts.", "vehicle.rotors.", "vehicle.propulsion.surface_effect.",
    )  # fmt: skip
    others = [key for key in keys if not key.startswith(lists)]
    assert {key.partition(".")[0] for key in others} <= {"reference", "world"}


def test_the_shell_gets_a_script_that_asks_the_program() -> None:
    for shell in ("bash", "zsh", "fish"):
        found = get_completion_class(shell)
        assert found is not None
        script = found(cli, {}, "springback", "_SPRINGBACK_COMPLETE").source()
        assert "_SPRINGBACK_COMPLETE" in script
