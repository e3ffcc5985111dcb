"""XML of strangers: refused in one line where it is damaged, hostile, or too large."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from builders.cases import nonempty
from builders.world_files import BOX, imported, sdf, sdf_model
from springback import InputError, read_world
from springback.scenario.worlds import paths, xml_text
from springback.scenario.worlds.xml_text import xml_root

LAUGHS = (
    '<!DOCTYPE sdf [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;">'
    + "".join(
        f'<!ENTITY {n} "{f"&{m};" * 10}">' for m, n in zip("bcdefghi", "cdefghij", strict=True)
    )
    + "]><sdf>&j;</sdf>"
)
HOSTILE = {
    LAUGHS: r"w\.sdf:1: has a document type \(DOCTYPE\), which is not read",
    '<!DOCTYPE sdf SYSTEM "file:///etc/passwd"><sdf/>': "has a document type",
    '<?xml version="1.0"?>\n<!DOCTYPE s [<!ENTITY x SYSTEM "/etc/passwd">]><sdf>&x;</sdf>': r"w\.sdf:2: has a",
    "": "is not XML: no element found",
    "<sdf><world>": "is not XML: no element found",
    "<sdf></world>": r"w\.sdf:1: is not XML: mismatched tag",
    "<sdf a='1' a='2'/>": "is not XML: duplicate attribute",
    "<sdf>&nbsp;</sdf>": "is not XML: undefined entity",
    '<?xml version="1.0" encoding="ebcdic-x"?><sdf/>': "is not XML: unknown encoding",
    "<a>" * 300 + "</a>" * 300: "a: is nested more than 200 deep",
    "\x00\x01": "is not XML",
}


@pytest.mark.parametrize("text", HOSTILE, ids=range(len(HOSTILE)))
def test_hostile_files_are_refused_in_a_line(tmp_path: Path, text: str) -> None:
    with pytest.raises(InputError, match=HOSTILE[text]) as refused:
        imported(tmp_path, "w.sdf", text)
    assert len(refused.value.problems) == 1


def test_any_beginning_of_a_file_is_refused(tmp_path: Path) -> None:
    text = sdf(sdf_model("a", BOX))
    for end in nonempty(range(0, len(text), 7)):
        with pytest.raises(InputError, match=r"w\.sdf:\d+: is not XML"):
            imported(tmp_path, "w.sdf", text[:end])


def test_files_that_are_none_or_too_large(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(InputError, match=r"none\.sdf: cannot be read \(No such file"):
        read_world(tmp_path / "none.sdf")
    with pytest.raises(InputError, match=r"is not in a format that is read: \.sdf, \.world"):
        read_world(tmp_path / "none.blend")
    (tmp_path / "d.sdf").mkdir()
    with pytest.raises(InputError, match="is not a regular file") as refused:
        read_world(tmp_path / "d.sdf")
    assert str(refused.value).count("d.sdf") == 1
    with open(tmp_path / "hole.sdf", "wb") as file:
        file.truncate(paths.MOST_BYTES + 1)
    with pytest.raises(
        InputError, match="is too large, 64 MB; a file of at most 64 MB is read"
    ) as refused:
        read_world(tmp_path / "hole.sdf")
    assert str(refused.value).count("hole.sdf") == 1
    os.mkfifo(tmp_path / "pipe.sdf")
    with pytest.raises(InputError, match="is not a regular file"):
        read_world(tmp_path / "pipe.sdf")
    monkeypatch.setattr(xml_text, "MOST_NODES", 5)
    with pytest.raises(InputError, match="is one of more than 5 elements"):
        imported(tmp_path, "w.sdf", sdf(sdf_model("a", BOX)))


def test_lines_are_those_of_the_file(tmp_path: Path) -> None:
    path = tmp_path / "a.xml"
    path.write_text("<a>\n\n  <b/>\n  <c\n  d='1'/>\n</a>")
    root = xml_root(path)
    assert [(node.tag, node.line) for node in (root, *root.nodes)] == [("a", 1), ("b", 3), ("c", 4)]


def test_encodings_are_read_as_declared(tmp_path: Path) -> None:
    text = sdf(sdf_model("kühl", BOX)).replace('version="1.0"', 'version="1.0" encoding="latin-1"')
    [part] = imported(tmp_path, "w.sdf", text.encode("latin-1")).parts
    assert part.name == "kühl/link/collision"


def test_a_name_cannot_control_a_terminal(tmp_path: Path) -> None:
    world = imported(tmp_path, "w.sdf", sdf(sdf_model("a&#x9b;31m", "<torus/>")))
    with pytest.raises(InputError) as refused:
        read_world(tmp_path / "w.sdf", missing="refuse")
    assert world.unrepresented
    assert refused.value.problems[0].isprintable()
