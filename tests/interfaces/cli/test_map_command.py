"""`springback map` as a newcomer meets it: files, figure, one clear line for each error."""

import csv
import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from matplotlib.contour import QuadContourSet
from matplotlib.patches import Rectangle

from builders.figures import plane_map
from springback.campaign.analysis.envelope import LEVEL, Axis, Envelope, EnvelopeCell
from springback.interfaces.figures import style
from springback.interfaces.figures.envelope import PRINTED_MARKS, edges, map_figure
from springback.paper.printed import SUCCESS, SUCCESS_WORDS, printed_success
from springback.studies.run_ups import CONDITIONS


def run(*words: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "springback", "map", *words],
        cwd=cwd, capture_output=True, text=True, timeout=300, check=False,
    )  # fmt: skip


def test_a_small_map_end_to_end(tmp_path: Path) -> None:
    """2 x 2 x 2 trials of one robot, one column of which cannot be flown."""
    words = ("speed=2:8:2", "pitch=-15deg:0deg:2", "--robot", "arq", "--trials", "2")
    done = run(*words, "--out", "out", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    out = tmp_path / "out"
    assert {path.name for path in out.iterdir()} == {
        "map.html", "map.json", "map.csv", "map.png", "map.pdf"
    }  # fmt: skip
    assert "arq: at least 95 % in 2 of 2 cells that can be flown (2 cannot)" in done.stdout
    assert "pitch [deg]" in done.stdout
    assert "speed [m/s]" in done.stdout

    told = json.loads((out / "map.json").read_text())
    assert told["axes"]["y"] == {"parameter": "pitch", "unit": "deg", "values": [-15.0, 0.0]}
    slow, fast = ([c for c in told["cells"] if c["speed [m/s]"] == speed] for speed in (2.0, 8.0))
    assert [(c["trials"], c["successes"], c["recovered"]) for c in slow] == [(2, 2, 2)] * 2
    assert [(c["trials"], c["successes"], c["share"]) for c in fast] == [(0, None, None)] * 2
    assert all("distance" in c["cannot_be_flown"] for c in fast)
    with (out / "map.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["share"] for row in rows] == ["1.0", "", "1.0", ""]
    assert (out / "map.png").read_bytes().startswith(b"\x89PNG")
    assert (out / "map.pdf").read_bytes().startswith(b"%PDF")

    again = run(*words, "--out", "more", "--json", "--quiet", "--no-figures", cwd=tmp_path)
    assert json.loads(again.stdout) == told
    assert again.stderr == ""
    assert sorted(p.name for p in (tmp_path / "more").iterdir()) == ["map.csv", "map.json"]


def test_a_dry_run_flies_and_writes_nothing(tmp_path: Path) -> None:
    done = run("--dry-run", "--out", "out", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "162 cells, at most 1620 flights of 11 s, 1 kind of flight" in done.stdout
    assert list(tmp_path.iterdir()) == []
    told = json.loads(run("--dry-run", "--json", "--trials", "3", cwd=tmp_path).stdout)
    assert (told["cells"], told["flights"]) == (162, 486)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("sped=1:5:9", "--out", "out"), "did you mean speed?"),
        (("speed=1:5", "--out", "out"), "from:to:count"),
        (("speed=1 kg:2 kg:3", "--out", "a/b"), "wrong unit"),
        (("speed=1:1:3", "--out", "out"), "must differ"),
        (("speed=1:5:1", "--out", "out"), "count"),
        (("--robot", "arqq", "--out", "out"), "did you mean arq?"),
        (("--set", "recovery.response.pace=fast", "--out", "out"), "recovery.response.pace"),
        ((), "--out is missing"),
    ],
)
def test_bad_input_is_one_line_and_leaves_nothing(
    words: tuple[str, ...], told: str, tmp_path: Path
) -> None:
    done = run(*words, cwd=tmp_path)
    assert done.returncode == 2, done.stderr
    [line] = done.stderr.strip().splitlines()
    assert line.startswith("error: ")
    assert told in line
    assert done.stdout == ""
    assert list(tmp_path.iterdir()) == []


# -- the figure -----------------------------------------------------------------------------------


def test_the_drawn_line_lies_on_the_plane_and_what_cannot_be_flown_is_hatched() -> None:
    figure = map_figure(plane_map(), printed_success)
    for ax in figure.axes[:2]:
        [contour] = [c for c in ax.collections if isinstance(c, QuadContourSet)]
        points = np.concatenate([path.vertices for path in contour.get_paths()])
        steep = points[points[:, 1] >= -15.0]  # further down the plane is cut off at 1
        assert len(steep) >= 3
        assert 1.05 - 0.04 * steep[:, 0] - 0.002 * steep[:, 1] == pytest.approx(LEVEL, abs=1e-9)
        [hatched] = [p for p in ax.patches if isinstance(p, Rectangle)]
        assert hatched.get_hatch()
        assert hatched.get_bbox().bounds == pytest.approx((4.5, 30.0, 1.0, 30.0))
    texts = {text.get_text() for text in figure.legends[0].get_texts()}
    assert {"95 % succeed", "not flown", "paper: all succeed"} <= texts
    assert figure.axes[0].get_xlabel().endswith("[m/s]")
    assert "[deg]" in figure.axes[0].get_ylabel()


def test_a_map_of_one_colour_and_of_other_parameters_draws() -> None:
    told = plane_map(("arq",))
    other = Axis("air.wind[0]", "m/s", (0.0, -1.0, -2.0, -3.0))
    full = dict.fromkeys(told.cells, EnvelopeCell({"recovered": 1000}))
    figure = map_figure(Envelope(told.x, other, ("arq",), 1000, 0, (), full), printed_success)
    assert not [c for c in figure.axes[0].collections if isinstance(c, QuadContourSet)]
    assert not [t for t in figure.legends[0].get_texts() if "paper" in t.get_text()]
    assert style.png(figure) == style.png(
        map_figure(Envelope(told.x, other, ("arq",), 1000, 0, (), full), printed_success)
    )


def test_every_printed_test_has_its_mark() -> None:
    for robot in ("arq", "quad"):
        for pitch, speed in CONDITIONS:
            assert printed_success(robot, pitch, speed) in PRINTED_MARKS
    assert set(SUCCESS) | set(SUCCESS_WORDS) == {
        (r, *c) for r in ("arq", "quad") for c in CONDITIONS
    }
    assert printed_success("quad", 0.0, 3.5) == "none succeed"
    assert printed_success("quad", -45.0, 2.0) != printed_success("quad", -30.0, 2.0)
    assert printed_success("arq-lumped", 0.0, 2.0) == ""


def test_cells_end_halfway_between_their_centres() -> None:
    assert edges((1.0, 2.0, 3.0)) == pytest.approx([0.5, 1.5, 2.5, 3.5])
    assert edges((2.0, 0.0)) == pytest.approx([3.0, 1.0, -1.0])
