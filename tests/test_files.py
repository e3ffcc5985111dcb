"""Files written whole or not at all, and the forms of JSON and CSV."""

import csv
import json
import os
import sys
from pathlib import Path

import pytest

from springback.files import atomic_file, csv_text, json_text, write_atomically, write_csv


def test_rows_come_back_from_csv(tmp_path: Path) -> None:
    rows = [{"name": 'a "b", c', "x [m]": 0.1}, {"name": "−", "x [m]": None}]
    write_csv(tmp_path / "rows.csv", rows)
    with (tmp_path / "rows.csv").open(encoding="utf-8", newline="") as file:
        assert list(csv.DictReader(file)) == [
            {"name": 'a "b", c', "x [m]": "0.1"}, {"name": "−", "x [m]": ""},
        ]  # fmt: skip
    write_csv(tmp_path / "none.csv", [])
    assert (tmp_path / "none.csv").read_text() == "\n"
    assert csv_text([("a", None), (1, 2.5)]) == "a,\n1,2.5\n"


def test_json_holds_no_number_that_is_none() -> None:
    assert json.loads(json_text({"ω": [1.5, None]})) == {"ω": [1.5, None]}
    with pytest.raises(ValueError, match="not JSON compliant"):
        json_text({"x": float("nan")})


def test_a_file_is_replaced_whole_or_not_at_all(tmp_path: Path) -> None:
    path = tmp_path / "file.txt"
    write_atomically(path, "before ω")
    assert path.read_text(encoding="utf-8") == "before ω"

    def half() -> None:
        with atomic_file(path) as draft:
            draft.write_text("half")
            raise RuntimeError

    with pytest.raises(RuntimeError):
        half()
    assert path.read_text(encoding="utf-8") == "before ω"
    assert list(tmp_path.iterdir()) == [path]
    write_atomically(path, b"after", durable=True)
    assert path.read_bytes() == b"after"


@pytest.mark.skipif(sys.platform == "win32", reason="permissions of POSIX")
def test_others_cannot_write_where_the_mode_says_so(tmp_path: Path) -> None:
    mask = os.umask(0)
    try:
        write_atomically(tmp_path / "private", b"", mode=0o644)
        write_atomically(tmp_path / "shared", b"")
    finally:
        os.umask(mask)
    modes = [(tmp_path / name).stat().st_mode & 0o777 for name in ("private", "shared")]
    assert modes == [0o644, 0o666]
