"""The documentation is built without a warning, opens without a network, and says what is so."""

from __future__ import annotations

import importlib
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from html.parser import HTMLParser
from itertools import chain
from pathlib import Path
from typing import Any, get_args
from urllib.parse import unquote, urlsplit

import click
import pytest

import springback
from builders.cases import nonempty
from springback.contact.worlds import Shape
from springback.interfaces.cli.app import cli
from springback.quantities import number_in
from springback.scenario.fields import TableField, fields_of
from springback.scenario.scenario import expand_presets
from springback.scenario.tables import WorldSettings
from springback.settings import Settings

ROOT = Path(__file__).parents[1]
DOCS = ROOT / "docs"
PAGES = sorted(p for p in DOCS.rglob("*.md") if "_build" not in p.parts)
#: Tags that make a browser fetch something, and the attribute that says what.
LOADS = {"script": "src", "img": "src", "iframe": "src", "source": "src", "audio": "src"}

pytest.importorskip("sphinx", reason="the extra docs is not installed")


# -- as built -------------------------------------------------------------------------------------


class Page(HTMLParser):
    """What a built page has in it."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.path, self.ids, self.links, self.loads = path, set(), [], []
        self.headings, self.without_words, self.text, self.formulas = [], [], [], 0
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        given = {name: value or "" for name, value in attributes}
        if "id" in given:
            self.ids.add(given["id"])
        if tag == "a" and "href" in given:
            self.links.append(given["href"])
        if tag in LOADS and LOADS[tag] in given:
            self.loads.append(given[LOADS[tag]])
        if tag == "link" and given.get("rel") in ("stylesheet", "icon", "preload", "preconnect"):
            self.loads.append(given["href"])
        if tag == "img" and not given.get("alt"):
            self.without_words.append(given.get("src"))
        if re.fullmatch(r"h[1-6]", tag):
            self.headings.append(int(tag[1]))
        self.formulas += tag == "math"

    def handle_data(self, data: str) -> None:
        self.text.append(data)


# ipykernel's dispatcher, still waiting when its loop closes: says nothing of the pages, and
# whether it is said depends on how fast the process ends.
KERNEL_ENDS = re.compile(
    r"Task was destroyed but it is pending!\ntask: <Task pending .*dispatch_control.*>\n?"
)


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Page]:
    """All pages, built as `make docs` builds them."""
    out = tmp_path_factory.mktemp("docs")
    words = ["-W", "--keep-going", "-q", "-b", "html", "-d", str(out / "kept")]
    done = subprocess.run(
        [sys.executable, "-m", "sphinx", *words, str(DOCS), str(out / "html")],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert KERNEL_ENDS.sub("", done.stderr) == ""
    found = sorted((out / "html").rglob("*.html"))
    return {str(path.relative_to(out / "html")): Page(path) for path in found}


def test_every_page_is_built_and_can_be_reached(built: dict[str, Page]) -> None:
    known = {str(p.relative_to(DOCS).with_suffix(".html")) for p in PAGES}
    assert known <= built.keys()
    seen, ahead = set(), ["index.html"]
    while ahead:
        name = ahead.pop()
        if name in seen or name not in built:
            continue
        seen.add(name)
        here = built[name].path
        root = here.parents[len(Path(name).parts) - 1]
        for link in built[name].links:
            if link and not urlsplit(link).scheme and urlsplit(link).path:
                there = (here.parent / unquote(urlsplit(link).path)).resolve()
                if there.suffix == ".html" and there.is_relative_to(root):
                    ahead.append(str(there.relative_to(root)))
    assert known <= seen


def test_links_within_lead_somewhere(built: dict[str, Page]) -> None:
    by_path = {page.path.resolve(): page for page in built.values()}
    lost = []
    for name, page in built.items():
        for link in page.links:
            parts = urlsplit(link)
            if parts.scheme or link in ("", "#"):
                continue
            there = (page.path.parent / unquote(parts.path)).resolve() if parts.path else page.path
            target = by_path.get(there.resolve())
            if not there.exists() or (target and parts.fragment and not named(target, parts)):
                lost.append((name, link))
    assert lost == []


def named(page: Page, parts: Any) -> bool:
    return unquote(parts.fragment) in page.ids


def test_pages_load_nothing_from_the_network(built: dict[str, Page]) -> None:
    for name, page in nonempty(built.items()):
        for address in page.loads:
            parts = urlsplit(address)
            assert not parts.scheme or parts.scheme == "data", (name, address)
            assert not parts.netloc, (name, address)
            assert parts.scheme or (page.path.parent / unquote(parts.path)).exists(), name
    styles = built["index.html"].path.parent.rglob("*.css")
    for style in nonempty(styles):
        assert not re.search(r"url\(\s*['\"]?(https?:)?//|@import", style.read_text()), style


def test_pages_are_ready_for_readers(built: dict[str, Page]) -> None:
    for name, page in built.items():
        if name in ("genindex.html", "search.html", "py-modindex.html"):
            continue
        assert page.headings.count(1) == 1, name
        assert all(b - a <= 1 for a, b in zip(page.headings, page.headings[1:], strict=False)), name
        assert page.without_words == [], name
        assert not re.search(r"\bTODO\b|\bFIXME\b|\bXXX\b", "".join(page.text)), name
    assert sum(page.formulas for page in built.values()) > 200


def test_notebooks_are_shown_with_their_output(built: dict[str, Page]) -> None:
    """They ran, or building would have failed; every cell that ends in a value or prints shows it."""
    notebooks = sorted((DOCS / "notebooks").glob("*.md"))
    assert len(notebooks) == 3
    for path in notebooks:
        page = built[f"notebooks/{path.stem}.html"]
        html = page.path.read_text(encoding="utf-8")
        cells = path.read_text(encoding="utf-8").count("```{code-cell}")
        assert html.count('class="cell_output') == cells > 4, path.name
        assert html.count("<img") >= 2, path.name
        downloads = [link for link in page.links if link.endswith(".ipynb")]
        assert [Path(link).name for link in downloads] == [f"{path.stem}.ipynb"]
        assert '"outputs": [' in (page.path.parent / downloads[0]).read_text(encoding="utf-8")


def test_objects_are_two_clicks_from_the_first_page(built: dict[str, Page]) -> None:
    """Each with the members of its class; the page of a room is a table, not a wall."""
    linked = {Path(urlsplit(link).path).name for link in built["api/index.html"].links}
    assert "api/index.html" in built["index.html"].links
    for name, cls in {
        "flight": springback.Flight, "campaign": springback.Campaign, "vehicle": springback.Vehicle,
        "scenario": springback.Scenario, "plan": springback.Plan,
    }.items():  # fmt: skip
        assert f"{name}.html" in linked
        path = f"springback.{springback._PUBLIC[cls.__name__]}.{cls.__name__}"
        assert path in built[f"api/{name}.html"].ids
    members = {"plot", "save", "view", "animate", "resample", "columns", "outcome", "to_xarray"}
    flight = {
        id.removeprefix("springback.results.flight.Flight.") for id in built["api/flight.html"].ids
    }
    assert members <= flight
    assert not {"touch_speed", "peak_acceleration"} & flight  # a table has them
    sizes = [len("".join(page.text)) for name, page in built.items() if "/modules/" in name]
    assert len(sizes) > 150
    assert sorted(sizes)[-1] < 60_000


def test_every_public_name_has_its_entry(built: dict[str, Page]) -> None:
    ids = set().union(*(page.ids for page in built.values()))
    for name, chapter in nonempty(springback._PUBLIC.items()):
        assert f"springback.{chapter}.{name}" in ids, name


def test_every_option_of_every_command_has_its_row(built: dict[str, Page]) -> None:
    text = "".join(built["commands.html"].text)
    for name, command in nonempty(cli.commands.items()):
        assert f"springback {name}" in text
        assert name in built["commands.html"].ids
        for option in command.params:
            if isinstance(option, click.Option):
                assert all(word in text for word in option.opts), (name, option.opts)


# -- as written -----------------------------------------------------------------------------------


def resolved(path: str) -> Any:
    """The object of a dotted name; a field of settings or of a NamedTuple counts."""
    parts = path.split(".")
    for k in range(len(parts), 0, -1):
        try:
            thing: Any = importlib.import_module(".".join(parts[:k]))
        except ImportError:
            continue
        for part in parts[k:]:
            if part in getattr(thing, "model_fields", {}):
                return thing.model_fields[part]
            if part in getattr(thing, "__dataclass_fields__", {}):
                return thing.__dataclass_fields__[part]
            thing = getattr(thing, part)
        return thing
    raise AssertionError(path)


def test_names_of_springback_exist() -> None:
    names = (re.findall(r"`(springback(?:\.\w+)+)`", page.read_text()) for page in PAGES)
    for path in nonempty(chain.from_iterable(names)):
        assert resolved(path) is not None, path


def glossary() -> Iterator[tuple[str, list[str], str, list[str]]]:
    """Symbol, keys in a scenario, name in code, units."""
    row = r"^\| (.*?) \| .*? \| (.*?) \| `(.*?)` \| (.*?) \|$"
    for symbol, keys, code, units in re.findall(row, (DOCS / "glossary.md").read_text(), re.M):
        yield symbol, re.findall(r"`(.*?)`", keys), code, units.split(", ")


def fields(cls: type[Settings], path: str) -> list[TableField]:
    """The fields of that dotted path, in whichever of several tables has it."""
    first, _, rest = path.partition(".")
    field = fields_of(cls).get(first)
    if field is None or not rest:
        return [field] if field else []
    return [found for table in field.tables for found in fields(table, rest)]


def test_a_reader_of_the_checkout_is_told_what_a_directive_adds() -> None:
    """A code host shows these blocks as they are written: an empty page, but for a remark."""
    blocks = [
        (path.name, body) for path in PAGES
        for body in re.findall(r"^```\{eval-rst\}\n(.*?)^```", path.read_text("utf-8"), re.M | re.S)
        if re.match(r"(?:\.\. .*\n\n)?\.\. [\w-]+::", body)
    ]  # fmt: skip
    assert len(blocks) > 50
    assert [name for name, body in blocks if '"make docs"' not in body.partition("\n")[0]] == []


def test_glossary_leads_to_code_and_to_scenarios() -> None:
    rows = list(glossary())
    assert len(rows) > 45
    plain = str.maketrans({"²": "^2", "³": "^3"})
    for symbol, keys, code, units in rows:
        assert resolved(code) is not None, symbol
        for key in keys:
            found = fields(springback.Scenario, key)
            assert found, f"{symbol}: no scenario has {key}"
            known = {field.unit.unit for field in found if field.unit}
            wanted = {unit.translate(plain) if unit != "–" else "" for unit in units}
            # A surface's stiffness has a unit that depends on its exponent, so none in the code.
            assert known <= wanted or units == ["N/mⁿ"], (symbol, key, known, wanted)


def test_equations_have_their_place_in_the_story() -> None:
    index = (DOCS / "paper/equations.md").read_text()
    rows = re.findall(r"^\| \((\d+)\) \| \[.*?\]\(\.\./story/(\w+\.md)#(eq-\d+)\)", index, re.M)
    assert len(rows) == index.count("\n| (")
    shown = {}
    for page in (DOCS / "story").glob("*.md"):
        for numbers in re.findall(r"\\tag\{(.*?)\}", page.read_text()):
            for number in numbers.split(", "):
                assert number not in shown, f"({number}) stands in two chapters"
                shown[number] = page.name
    for number, page, anchor in rows:
        assert f"({anchor})=" in (DOCS / "story" / page).read_text()
        if number != "2":  # at rest (10) is (2)
            assert shown.pop(number) == page
    assert not shown, "an equation of a chapter is not in the index"


def test_restitution_table_is_what_the_law_gives() -> None:
    text = (DOCS / "story/contact.md").read_text()
    head = re.search(r"^\| \$c_a\$ .*$", text, re.M)
    assert head is not None
    speeds = [float(v) for v in re.findall(r"at ([\d.]+) m/s", head[0])]
    rows = re.findall(r"^\| (0\.\d+) \((\w+)\) \| (.*?) \|$", text, re.M)
    assert [name for _, name, _ in rows] == ["mat", "wall"]
    for c_a, name, cells in rows:
        surface = {"mat": springback.MAT, "wall": springback.WALL}[name]
        assert float(c_a) == pytest.approx(surface.dissipation_value(), abs=5e-4)
        for speed, cell in zip(speeds, cells.split(" | "), strict=True):
            exact = springback.restitution(surface.dissipation_value(), speed)
            assert float(cell) == pytest.approx(exact, abs=1e-3)


def test_resolution_of_arm_lengths_is_as_told() -> None:
    from springback.sensing.hall import resolution
    from springback.sensing.parameters import HallSettings

    sensors = HallSettings().device(1e-3, springback.ARQ.vehicle)
    text = (DOCS / "story/sensing.md").read_text()
    pressed = re.search(r"^\| compression \| (.*?) \|$", text, re.M)
    counts = re.search(r"^\| one count of the converter \| (.*?) \|$", text, re.M)
    assert pressed is not None
    assert counts is not None
    for at, count in zip(pressed[1].split(" | "), counts[1].split(" | "), strict=True):
        said = float(count.removesuffix(" mm"))
        exact = 1e3 * resolution(sensors, 1e-3 * float(at.removesuffix(" mm")))
        assert said == pytest.approx(exact, rel=0.05)


def test_scatter_is_as_told() -> None:
    import math

    from springback.studies.trials import Scatter

    text, s = (DOCS / "story/experiments.md").read_text(), Scatter()
    assert "| start: position, velocity, heading | 3 cm, 5 cm/s, 2° |" in text
    assert (s.position, s.velocity, round(math.degrees(s.heading), 9)) == (0.03, 0.05, 2.0)
    assert "| wall: distance, turn | 2 cm, 1° |" in text
    assert (s.wall_distance, round(math.degrees(s.wall_yaw), 9)) == (0.02, 1.0)
    assert "| true over nominal: mass, inertia | 2 %, 5 % (logarithms) |" in text
    assert (s.mass, s.inertia, s.gains) == (0.02, 0.05, 0.05)
    assert len(s.draw("arq", 0.0, 2.0, 0, 0).gains) == 5


#: Defaults that the table of built-in shapes tells in words.
IN_WORDS = {
    "up": (0.0, 0.0, 1.0),
    "along X": (1.0, 0.0, 0.0),
    "none": None,
    "origin": (0.0, 0.0, 0.0),
}


def test_built_in_shapes_are_all_on_their_page_with_their_fields_and_defaults() -> None:
    """Each type has a row and an example that is read; defaults are those of the code, with units."""
    text = (DOCS / "howto/obstacle.md").read_text(encoding="utf-8")
    rows = {m[1]: m[2] for m in re.finditer(r"^\| `(\w+)` \| (.*\|.*) \|$", text, re.M)}
    types = {cls.model_fields["type"].annotation.__args__[0]: cls for cls in get_args(Shape)}  # type: ignore[union-attr]
    [block] = re.findall(r"```toml\n(\[world\].*?)```", text, re.S)
    examples = tomllib.loads(block)["world"]["obstacles"]
    del rows["type"]  # the head of the table
    assert sorted(rows) == sorted(types)
    of_files = {"heightmap", "mesh", "occupancy"}  # their examples need a file
    assert {one["type"] for one in examples} == set(types) - of_files
    expand = expand_presets({"vehicle": "arq", "world": {"obstacles": examples}})["world"]
    assert len(WorldSettings.model_validate(expand).obstacles) == len(examples)
    groups = {"*angles*": ("roll", "pitch", "yaw"), "*edges*": ("edge_radius",)}
    assert "`roll`, `pitch` and `yaw` (0 deg)" in text
    assert re.search(r"`edge_radius`\n?\s?\(1 mm\)", text)
    for kind, cls in nonempty(types.items()):
        row, found = rows[kind], fields_of(cls)
        named = set(re.findall(r"`(\w+)`", row.split("|")[1]))
        named |= {name for word, names in groups.items() if word in row for name in names}
        if kind in of_files:  # words in quotes there are file types and what a file holds, too
            assert set(found) - {"type", "surface", "motion", "name", "content"} <= named, kind
            continue
        told_once = {"type", "surface", "motion", "name", "content"}
        assert named - {"surface", "name"} == set(found) - told_once, kind
        for name, field in found.items():
            told = re.search(rf"`{name}` \(([^)]*)\)", row)
            if told is None:
                if name in ("roll", "pitch", "yaw", "edge_radius"):
                    assert field.default == {"edge_radius": 1e-3}.get(name, 0.0), (kind, name)
                elif name not in (
                    "opening",
                    "opening_radius",
                    "type",
                    "surface",
                    "motion",
                    "content",
                    "tension",
                    "thread_stiffness",
                    "name",
                    "shapes",
                ):
                    assert field.required, (kind, name)
                continue
            if told[1] in IN_WORDS:
                assert field.default == IN_WORDS[told[1]], (kind, name)
                continue
            unit = field.unit.unit if field.unit else ""
            values = [number_in(one, unit, bare=not unit) for one in told[1].split(" × ")]
            default = field.default if isinstance(field.default, tuple) else (field.default,)
            assert values == pytest.approx(list(default)), (kind, name)


def test_the_picture_of_the_shapes_is_that_of_the_examples(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib", reason="the extra plot is not installed")
    from matplotlib.testing.compare import compare_images

    subprocess.run(
        [sys.executable, str(DOCS / "figures/shapes.py"), str(tmp_path)],
        check=True, capture_output=True,
    )  # fmt: skip
    (tmp_path / "kept.png").write_bytes((DOCS / "figures/shapes.png").read_bytes())
    drawn = str(tmp_path / "shapes.png")
    assert compare_images(str(tmp_path / "kept.png"), drawn, tol=5.0) is None


def test_the_picture_of_the_imported_world_is_that_of_the_example(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib", reason="the extra plot is not installed")
    from matplotlib.testing.compare import compare_images

    subprocess.run(
        [sys.executable, str(DOCS / "figures/imported_world.py"), str(tmp_path)],
        check=True, capture_output=True,
    )  # fmt: skip
    (tmp_path / "kept.png").write_bytes((DOCS / "figures/imported_world.png").read_bytes())
    drawn = str(tmp_path / "imported_world.png")
    assert compare_images(str(tmp_path / "kept.png"), drawn, tol=5.0) is None


def test_pictures_of_scenes_are_those_of_the_examples(tmp_path: Path) -> None:
    """Of those that fly without a pilot; the others are drawn by the same lines."""
    pytest.importorskip("matplotlib", reason="the extra plot is not installed")
    from matplotlib.testing.compare import compare_images

    names = ("window", "drop")
    subprocess.run(
        [sys.executable, str(DOCS / "figures/scenes.py"), str(tmp_path), *names],
        check=True, capture_output=True,
    )  # fmt: skip
    for name in nonempty(names):
        kept = tmp_path / f"kept_{name}.png"
        kept.write_bytes((DOCS / f"figures/{name}.png").read_bytes())
        assert compare_images(str(kept), str(tmp_path / f"{name}.png"), tol=5.0) is None, name


def test_figures_of_the_chapters_are_those_that_are_drawn(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib", reason="the extra plot is not installed")
    from matplotlib.testing.compare import compare_images

    subprocess.run(
        [sys.executable, str(DOCS / "figures/chapters.py"), str(tmp_path)],
        check=True, capture_output=True,
    )  # fmt: skip
    drawn = sorted(tmp_path.glob("*.png"))
    assert [path.name for path in drawn] == ["contact.png", "hall.png", "quintic.png"]
    for path in drawn:
        kept = tmp_path / "kept" / path.name
        kept.parent.mkdir(exist_ok=True)
        kept.write_bytes((DOCS / "figures" / path.name).read_bytes())
        assert compare_images(str(kept), str(path), tol=5.0) is None, path.name
