"""Parts of imported worlds go by their names in legends, with their kinds, and not too many."""

from pathlib import Path
from typing import Any

import numpy as np

from builders.cases import nonempty
from builders.world_files import BOX, imported, sdf, sdf_model
from springback.interfaces.replay.geometry import MOST_PARTS, drawables
from springback.interfaces.replay.part_labels import LONGEST, part_names, short_name
from springback.scenario.worlds.imported import Imported

FLOWN = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 1.0]])
NONE = np.zeros((0, 3))
PILLAR = "<cylinder><radius>0.1</radius><length>2</length></cylinder>"
SHELF = (
    '<model name="shelf"><static>true</static><pose>3 0 1 0 0 0</pose><link name="l">'
    f'<collision name="a"><geometry>{BOX}</geometry></collision>'
    f'<collision name="b"><geometry>{PILLAR}</geometry></collision></link></model>'
)


def legend(world: Imported, near: Any = NONE) -> list[str]:
    """Names that a replay shows, in order."""
    things = drawables([world], (), FLOWN, near).drawables
    return list(dict.fromkeys(one.name for one in things))


def test_a_part_goes_by_what_it_is_a_part_of_and_by_its_kind(tmp_path: Path) -> None:
    text = sdf(sdf_model("crate", BOX, "3 0 1 0 0 0"), sdf_model("pillar", PILLAR), SHELF)
    world = imported(tmp_path, "w.sdf", text)
    assert legend(world) == ["crate (box)", "pillar (pole)", "shelf (box, pole)"]
    named = world.model_copy(update={"name": "yard"})
    assert legend(named) == ["yard/crate (box)", "yard/pillar (pole)", "yard/shelf (box, pole)"]


def test_parts_of_one_thing_go_by_their_own_names(tmp_path: Path) -> None:
    assert legend(imported(tmp_path, "w.sdf", sdf(SHELF))) == [
        "shelf/l/a (box)",
        "shelf/l/b (pole)",
    ]
    alone = imported(tmp_path, "v.sdf", sdf(sdf_model("crate", BOX)))
    assert legend(alone) == ["crate (box)"]


def test_of_many_parts_the_nearest_are_named_and_the_others_go_by_their_type(
    tmp_path: Path,
) -> None:
    models = [sdf_model(f"crate {k}", BOX, f"{k} 0 1 0 0 0") for k in range(40)]
    world = imported(tmp_path, "w.sdf", sdf(*models))
    near = np.array([[30.0, 0.0, 1.0]])
    found = legend(world, near)
    assert set(found) == {"box", *(f"crate {k} (box)" for k in range(27, 34)), found[1]}
    assert found[1] in ("crate 26 (box)", "crate 34 (box)")
    assert len(found) == 1 + MOST_PARTS


def test_long_names_keep_their_ends(tmp_path: Path) -> None:
    text = sdf(sdf_model("a_cupboard_of_a_long_name_7", BOX), sdf_model("pillar", PILLAR))
    names = part_names([imported(tmp_path, "w.sdf", text)])
    for name in nonempty(list(names.values())):
        assert len(name.removesuffix(" (box)").removesuffix(" (pole)")) <= LONGEST
    assert short_name("a_cupboard_of_a_long_name_7") == "a_cupboard_o…long_name_7"
    assert short_name("crate") == "crate"
