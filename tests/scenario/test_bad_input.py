"""Bad input: one clear line each, with file, line, field, what was given, and what is allowed."""

from __future__ import annotations

from pathlib import Path

import pytest

from builders.cases import nonempty
from springback.errors import InputError
from springback.results.flight import as_scenario
from springback.scenario.files import read_scenario
from springback.scenario.overrides import apply_overrides

GOOD = """\
name = "test"
thrust = "hover"

[vehicle]
preset = "arq"

[vehicle.body]
mass = "1.2 kg"

[vehicle.arms]
stroke = "50 mm"

[world]
gravity = 9.81

[[world.obstacles]]
type = "wall"
distance = "2.75 m"
surface = "wall"

[[world.obstacles]]
type = "ground"
surface = { preset = "mat", friction = 0.5 }

[start]
position = [2.2, 0, 1]
velocity = ["2 m/s", 0, 0]
pitch = "15 deg"

[simulation]
duration = "0.3 s"
impact_step = 1e-4
"""
MASS, STROKE, GRAVITY = 'mass = "1.2 kg"', 'stroke = "50 mm"', "gravity = 9.81"
WALL, PLACE, STEP = 'surface = "wall"', "position = [2.2, 0, 1]", "impact_step = 1e-4"
DISTANCE, KIND, THRUST = 'distance = "2.75 m"', 'type = "wall"', 'thrust = "hover"'

#: Text of the file, what replaces it, the field, and words of the message.
BAD: dict[str, tuple[str, str, str, tuple[str, ...]]] = {
    "negative mass": (MASS, 'mass = "-1.2 kg"', "vehicle.body.mass", ("more than 0 kg", "-1.2 kg")),
    "no mass": (MASS, "mass = 0", "vehicle.body.mass", ("more than 0 kg", "got 0 kg")),
    "infinite mass": (MASS, "mass = inf", "vehicle.body.mass", ("finite", "inf kg")),
    "NaN mass": (MASS, "mass = nan", "vehicle.body.mass", ("finite", "nan kg")),
    "NaN with a unit": (MASS, 'mass = "nan kg"', "vehicle.body.mass", ("finite",)),
    "too large to hold": (MASS, 'mass = "1e400 kg"', "vehicle.body.mass", ("finite",)),
    "wrong unit of mass": (MASS, 'mass = "1.2 m"', "vehicle.body.mass", ("wrong unit", "1.2 m", "kg")),
    "unknown unit": (MASS, 'mass = "2 bananas"', "vehicle.body.mass", ("2 bananas", "kg")),
    "no number": (MASS, 'mass = "heavy"', "vehicle.body.mass", ("heavy", "kg")),
    "empty text": (MASS, 'mass = ""', "vehicle.body.mass", ("not a number", "kg")),
    "truth as mass": (MASS, "mass = true", "vehicle.body.mass", ("True", "kg")),
    "list as mass": (MASS, "mass = [1]", "vehicle.body.mass", ("[1]", "kg")),
    "zero inertia": (MASS, "inertia = [0, 1, 1]", "vehicle.body.inertia", ("more than 0 kg m^2",)),
    "inertia not symmetric": (
        MASS, "inertia = [[1, 0.1, 0], [0, 1, 0], [0, 0, 1]]", "vehicle.body.inertia", ("symmetric",),
    ),
    "inertia not positive": (
        MASS, "inertia = [[1, 2, 0], [2, 1, 0], [0, 0, 1]]", "vehicle.body.inertia", ("positive",),
    ),
    "moments of a matrix not positive": (
        MASS, "inertia = [[1, 0, 0], [0, 1, 0], [0, 0, -1]]", "vehicle.body.inertia", ("positive",),
    ),
    "inertia of no body": (
        MASS, "inertia = [1e-3, 1e-3, 5e-3]", "vehicle.body.inertia", ("0.005 kg m²", "0.002 kg m²"),
    ),
    "matrix of no body": (
        MASS, "inertia = [[1, 0, 0], [0, 1e-6, 0], [0, 0, 1e-6]]", "vehicle.body.inertia",
        ("no body", "at most the sum"),
    ),
    "payload of no body": (
        "[simulation]", "[payload]\ninertia = [0, 0, 1e-3]\n[simulation]", "payload.inertia", ("no body",),
    ),
    "payload of no size": (
        THRUST, "payload = { mass = 0.1, inertia = [1e-9, 1e-9, 1e-9] }",
        "payload.inertia", ("as of a ball of osmium of 0.1 kg", "3e-09 kg m²"),
    ),
    "payload as large as a room": (
        THRUST, "payload = { mass = 0.1, inertia = [1, 1, 1] }",
        "payload.inertia", ("above 0.081 kg m²", "0.1 kg within 0.9 m", "got 1 kg m²"),
    ),
    "payload without mass": (
        THRUST, "payload = { inertia = [1e-4, 1e-4, 1e-4] }",
        "payload.inertia", ("0 kg m^2 each of a payload without mass", "0.0001"),
    ),
    "all arms in one direction": (
        STROKE, "directions = [0, 0, 0, 0]", "vehicle.arms.directions", ("arms 1 and 2", "differ"),
    ),
    "the same direction, a turn on": (
        STROKE, 'directions = [0, 2, 4, "360 deg"]', "vehicle.arms.directions", ("arms 1 and 4",),
    ),
    "cages that overlap": (
        STROKE, 'cage_radius = "30 cm"', "vehicle.arms.cage_radius",
        ("arms 1 and 2", "0.6 m", "0.268701 m"),
    ),
    "arm pressed into its neighbour": (
        STROKE, 'stroke = "90 mm"', "vehicle.arms.stroke", ("arm 1", "arm 2", "0.22 m", "0.09 m"),
    ),
    "decimal comma": (MASS, 'mass = "1,2 kg"', "vehicle.body.mass", ("1,2 kg", "decimal point")),
    "two numbers": (MASS, 'mass = "1 200 g"', "vehicle.body.mass", ("more than one number", "kg")),
    "whole number of 400 digits": (MASS, f"mass = 1{'0' * 400}", "vehicle.body.mass", ("finite", "inf kg")),
    "degrees without a word": ('pitch = "15 deg"', "pitch = 15", "start.pitch", ("full turn", '"15 deg"')),
    "direction in plain degrees": (
        STROKE, "directions = [45, 135, 225, 315]", "vehicle.arms.directions", ("radians", '"45 deg"'),
    ),
    "friction as an angle": (
        WALL, 'surface = { preset = "wall", friction = "22 deg" }', "world.obstacles[0].surface.friction",
        ("wrong unit", "a plain number"),
    ),
    "inertia of two": (MASS, "inertia = [1, 2]", "vehicle.body.inertia", ("3 x 3", "kg m²")),
    "rest length 0": (STROKE, "length = 0", "vehicle.arms.length", ("more than 0 m", "got 0 m")),
    "stroke longer than the arm": (
        STROKE, 'stroke = "30 cm"', "vehicle.arms.stroke", ("less than the length", "0.19 m", "0.3 m"),
    ),
    "massless sliding arm": (STROKE, "mass = 0", "vehicle.arms.mass", ("more than 0 kg", "arm 1")),
    "too few entries": (STROKE, "length = [0.1, 0.2]", "vehicle.arms.length", ("2 entries", "4 arms")),
    "wrong unit of stiffness": (
        STROKE, 'stiffness = "5 N"', "vehicle.arms.stiffness", ("wrong unit", "5 N", "N/m"),
    ),
    "negative damping": (STROKE, "damping = -1", "vehicle.arms.damping", ("at least 0 N s/m",)),
    "no arms": (STROKE, "directions = []", "vehicle.arms.directions", ("at least one arm",)),
    "one direction": (STROKE, "directions = 3", "vehicle.arms.directions", ("list", "3")),
    "direction in metres": (
        STROKE, 'directions = ["1 m", 0, 0, 0]', "vehicle.arms.directions", ("1 m", "rad"),
    ),
    "perhaps compliant": (
        STROKE, 'compliant = "perhaps"', "vehicle.arms.compliant", ("true or false", "perhaps"),
    ),
    "spin of two": (STROKE, "spin = [1, 2, -1, 1]", "vehicle.arms.spin", ("-1", "2")),
    "unknown key": (STROKE, "stifness = 5e3", "vehicle.arms.stifness", ("did you mean stiffness?",)),
    "key like no other": (MASS, "xyzzy = 2", "vehicle.body.xyzzy", ("known keys: mass, inertia",)),
    "unknown table": ("[start]", "[strat]", "strat", ("did you mean start?",)),
    "unknown vehicle": (
        'preset = "arq"', 'preset = "arqq"', "vehicle.preset", ("arqq", "did you mean arq?"),
    ),
    "unknown surface": (
        WALL, 'surface = "wal"', "world.obstacles[0].surface", ("'wal'", "did you mean wall?"),
    ),
    "unknown law": (
        WALL, 'surface = { preset = "wall", law = "hunt" }', "world.obstacles[0].surface.law",
        ("hunt-crossley", "'hunt'", "did you mean hunt-crossley?"),
    ),
    "misspelt law of a stiffness with its unit": (
        WALL, 'surface = { law = "foams", stiffness = "20 N/mm" }',
        "world.obstacles[0].surface.law", ("'foams'", "did you mean foam?"),
    ),
    "misspelt obstacle": (
        KIND, 'type = "waal"', "world.obstacles[0].type", ("'waal'", "did you mean wall?"),
    ),
    "misspelt motion": (
        'type = "wall"\ndistance = "2.75 m"',
        'type = "sphere"\nposition = [2.75, 0, 1]\nradius = 0.2\nmotion = { type = "sinus" }',
        "world.obstacles[0].motion.type", ("'sinus'", "did you mean sine?"),
    ),
    "misspelt hull": (
        STROKE, 'stroke = "50 mm"\n[[vehicle.hulls]]\ntype = "spher"', "vehicle.hulls[0].type",
        ("'spher'", "did you mean sphere?"),
    ),
    "misspelt reference": (
        "[simulation]", '[reference]\ntype = "runup"\n[simulation]', "reference.type",
        ("'runup'", "did you mean run-up?"),
    ),
    "misspelt choice": (
        "[simulation]", '[model]\narms = "hybird"\n[simulation]', "model.arms",
        ("'hybird'", "did you mean hybrid?"),
    ),
    "sticky surface": (
        WALL, 'surface = { preset = "wall", friction = -1 }', "world.obstacles[0].surface.friction",
        ("at least 0",),
    ),
    "restitution above 1": (
        WALL, 'surface = { preset = "wall", restitution = 1.5 }',
        "world.obstacles[0].surface.restitution", ("at most 1", "1.5"),
    ),
    "two dampings": (
        WALL, 'surface = { restitution = 0.5, restitution_speed = 2, dissipation = 0.4 }',
        "world.obstacles[0].surface.dissipation", ("with restitution",),
    ),
    "surface of wrong type": (WALL, "surface = 3", "world.obstacles[0].surface", ("table", "3")),
    "unknown obstacle": (KIND, 'type = "pillar"', "world.obstacles[0].type", ("wall", "ground", "pillar")),
    "wall across nothing": (
        DISTANCE, "position = [3, 0, 0]\nnormal = [0, 0, 0]", "world.obstacles[0].normal", ("zero",),
    ),
    "negative gravity": (GRAVITY, "gravity = -9.81", "world.gravity", ("at least 0 m/s^2",)),
    "start inside the wall": (
        PLACE, "position = [2.6, 0, 1]", "start.position", ("inside world.obstacles[0], a wall", "2.6"),
    ),
    "start under the ground": (
        PLACE, "position = [2, 0, -1]", "start.position", ("inside world.obstacles[1], the ground",),
    ),
    "two coordinates": (PLACE, "position = [2.2, 0]", "start.position", ("three numbers in m",)),
    "NaN position": (PLACE, "position = [2.2, nan, 1]", "start.position", ("finite", "nan m")),
    "pitch in metres": ('pitch = "15 deg"', 'pitch = "15 m"', "start.pitch", ("wrong unit", "rad")),
    "zero step": (STEP, "impact_step = 0", "simulation.impact_step", ("more than 0 s", "got 0 s")),
    "negative step": (STEP, "impact_step = -1e-4", "simulation.impact_step", ("more than 0 s",)),
    "step that cannot resolve the arms": (
        STEP, "impact_step = 0.01", "simulation.impact_step", ("at most", "0.01 s"),
    ),
    "step without end": (STEP, "impact_step = 1e-30", "simulation.impact_step", ("at least", "1e-30 s")),
    "zero duration": ('duration = "0.3 s"', "duration = 0", "simulation.duration", ("more than 0 s",)),
    "thrust in words": (THRUST, 'thrust = "full"', "thrust", ("full", "N")),
    "negative thrust": (THRUST, "thrust = -1", "thrust", ("at least 0 N", "-1 N")),
    "thrust of two rotors": (THRUST, "thrust = [1, 2]", "thrust", ("2 entries", "4 rotors")),
    "name of wrong type": ('name = "test"', "name = 3", "name", ("string", "3")),
    "unknown model": (
        "[simulation]", '[model]\ncontact_point = "rin"\n[simulation]', "model.contact_point",
        ("ring", "'rin'"),
    ),
    "slider nowhere": (
        "[simulation]", "[model]\nslider = [0, 0, 0]\n[simulation]", "model.slider", ("zero",),
    ),
}  # fmt: skip


def problem_of(path: Path, *overrides: str) -> str:
    """The one line that is said about a bad scenario."""
    with pytest.raises(InputError) as caught:
        read_scenario(path, overrides)
    text = str(caught.value)
    assert "\n" not in text
    return text


def test_the_scenario_itself_is_good(tmp_path: Path) -> None:
    """Before anything is broken."""
    path = tmp_path / "scenario.toml"
    path.write_text(GOOD)
    assert read_scenario(path).vehicle.body.mass == 1.2


@pytest.mark.parametrize(("old", "new", "field", "words"), BAD.values(), ids=BAD.keys())
def test_file_line_field_and_range(
    tmp_path: Path, old: str, new: str, field: str, words: tuple[str, ...]
) -> None:
    """The line names the file, the line of the value, the field, the value, and what is allowed."""
    path = tmp_path / "scenario.toml"
    text = GOOD.replace(old, new)
    assert text != GOOD
    path.write_text(text)
    said = problem_of(path)
    # The last line of the replacement is the culprit, but for whole tables put in before another.
    culprit = new.splitlines()[1 if "[simulation]" in new else -1]
    line = text.splitlines().index(culprit) + 1
    assert said.startswith(f"{path}:{line}: {field}: " if field else f"{path}:{line}: ")
    for word in words:
        assert word in said


OVERRIDES = {
    "vehicle.body.mass=-1 kg": ("vehicle.body.mass", "more than 0 kg"),
    "vehicle.body.mass=1,2 kg": ("vehicle.body.mass", "decimal point"),
    "world.obstacles.0.surface.friction=0,4": (
        "world.obstacles[0].surface.friction",
        "decimal point",
    ),
    "start.pitch=1,5": ("start.pitch", "decimal point"),
    "start.yaw=45": ("start.yaw", "45 deg"),
    "start.pitch=9**9**9 deg": ("start.pitch", "more than one number"),
    "vehicle.body.mass=nan": ("vehicle.body.mass", "finite"),
    "vehicle.body.inertia=[0, 1, 1]": ("vehicle.body.inertia", "more than 0 kg m^2"),
    "vehicle.arms.length=0": ("vehicle.arms.length", "more than 0 m"),
    "vehicle.arms.stroke=0.3 m": ("vehicle.arms.stroke", "0.19 m"),
    "vehicle.arms.stiffness=5 N": ("vehicle.arms.stiffness", "N/m"),
    "vehicle.arms.stifness=3": ("vehicle.arms.stifness", "did you mean stiffness?"),
    "vehicle=arqq": ("vehicle.preset", "did you mean arq?"),
    "world.obstacles[0].surface=wal": (
        "world.obstacles[0].surface",
        "did you mean wall?",
    ),
    "world.obstacles[0].surface.frction=1": ("world.obstacles[0].surface.frction", "friction"),
    "world.obstacles[0].type=pillar": ("world.obstacles[0].type", "wall"),
    "world.obstacles=3": ("world.obstacles", "list"),
    "start=3": ("start", "table"),
    "start.position[0]=2.6": ("start.position", "inside world.obstacles[0]"),
    "start.velocity=[1, inf, 0]": ("start.velocity", "finite"),
    "simulation.impact_step=0": ("simulation.impact_step", "more than 0 s"),
    "thrust=hoover": ("thrust", "hoover"),
    "thrust=inf": ("thrust", "finite"),
}


@pytest.mark.parametrize(("word", "expected"), OVERRIDES.items(), ids=OVERRIDES.keys())
def test_overrides_are_blamed_for_what_they_set(
    tmp_path: Path, word: str, expected: tuple[str, str]
) -> None:
    """The line names the override, not the file, where the override is at fault."""
    path = tmp_path / "scenario.toml"
    path.write_text(GOOD)
    field, said_of_it = expected
    said = problem_of(path, "vehicle.name=other", word)
    assert said.startswith(f"override {word}: {field}: " if field else f"override {word}: ")
    assert said_of_it in said


def test_an_override_that_moves_an_obstacle_onto_the_start_is_blamed(tmp_path: Path) -> None:
    """The field is the start's, which nobody changed: the obstacle and the override are named."""
    path = tmp_path / "scenario.toml"
    path.write_text(GOOD)
    word = "world.obstacles.0.distance=2.3"
    said = problem_of(path, "vehicle.name=other", word)
    assert said.startswith(f"override {word}: start.position: puts the cage of arm ")
    assert "inside world.obstacles[0], a wall (got [2.2, 0.0, 1.0] m)" in said
    here = "start.position.0=2.6"  # the start's own override is at fault first
    assert problem_of(path, here, "world.obstacles.0.surface=mat").startswith(f"override {here}: ")


@pytest.mark.parametrize(
    "word",
    ["novalue", "=3", "world.obstacles[5].distance=3", "world.gravity.x=3", "start.position[7]=2"],
)
def test_words_that_are_no_overrides(tmp_path: Path, word: str) -> None:
    """The word is quoted."""
    path = tmp_path / "scenario.toml"
    path.write_text(GOOD)
    assert word in problem_of(path, word)


@pytest.mark.parametrize(
    ("data", "expected"),
    [
        (b"[start", "is not TOML"),
        (b"1, 2", "is not TOML"),
        (b"a = 1\na = 2", "is not TOML"),
        (b"\xff\xfe\x00", "is not text in UTF-8"),
        (b"", "vehicle: is missing"),
        (b'vehicle = "arq"\nworld = 3', "2: world: must be a table"),
    ],
)
def test_files_that_are_no_scenarios(tmp_path: Path, data: bytes, expected: str) -> None:
    """What is not TOML, not text, or empty."""
    path = tmp_path / "scenario.toml"
    path.write_bytes(data)
    said = problem_of(path)
    assert said.startswith(str(path))
    assert expected in said


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    """No such file, and a folder."""
    assert "No such file" in problem_of(tmp_path / "none.toml")
    assert "directory" in problem_of(tmp_path)


def test_missing_parts_are_named(tmp_path: Path) -> None:
    """A wall without a surface or a type, and half a position."""
    path = tmp_path / "scenario.toml"
    header = GOOD.splitlines().index("[[world.obstacles]]") + 1
    for old, field in ((WALL, "world.obstacles[0].surface"), (KIND, "world.obstacles[0].type")):
        path.write_text(GOOD.replace(old + "\n", "", 1))
        assert problem_of(path).startswith(f"{path}:{header}: {field}: is missing")
    for half in (DISTANCE + "\nposition = [3, 0, 0]", "position = [3, 0, 0]"):
        path.write_text(GOOD.replace(DISTANCE, half))
        assert "either distance, or position and normal" in problem_of(path)


def test_several_problems_are_several_lines(tmp_path: Path) -> None:
    """All are reported at once, one plain line each."""
    path = tmp_path / "scenario.toml"
    path.write_text(GOOD.replace(MASS, "mass = -1").replace(STEP, "impact_step = 0"))
    with pytest.raises(InputError) as caught:
        read_scenario(path)
    assert len(caught.value.problems) == 2
    assert "vehicle.body.mass" in caught.value.problems[0]
    assert "simulation.impact_step" in caught.value.problems[1]


# -- the right line and the right field --------------------------------------------------------------


def test_an_unknown_preset_is_blamed_on_its_own_line(tmp_path: Path) -> None:
    """Not on the first line that has the same word in it."""
    path = tmp_path / "hexa.toml"
    text = GOOD.replace('name = "test"', 'name = "hexa, concrete"').replace(
        WALL, 'surface = "concrete"'
    )
    path.write_text(text)
    line = text.splitlines().index('surface = "concrete"') + 1
    said = problem_of(path)
    assert said.startswith(f"{path}:{line}: world.obstacles[0].surface: unknown surface preset")


def test_an_unknown_preset_in_tables_names_its_key() -> None:
    """There is no file, so the path alone."""
    wall = {"type": "wall", "distance": 1.0, "surface": {"preset": "concrete"}}
    with pytest.raises(
        InputError, match=r"^world\.obstacles\[0\]\.surface\.preset: unknown surface"
    ):
        as_scenario({"vehicle": "arq", "world": {"obstacles": [wall]}})


def test_what_the_file_does_not_mention_has_no_line(tmp_path: Path) -> None:
    """A line that says something else is worse than none."""
    path = tmp_path / "scenario.toml"
    path.write_text('name = "no vehicle"\n')
    assert problem_of(path) == f"{path}: vehicle: is missing"


def test_a_flight_too_long_is_blamed_on_its_duration(tmp_path: Path) -> None:
    """The step is a default, which the user has never heard of."""
    path = tmp_path / "scenario.toml"
    path.write_text('vehicle = "arq"\n[simulation]\nduration = 1e9\n')
    assert problem_of(path).startswith(f"{path}:3: simulation.duration: must be at most ")
    assert "got 1e+09 s" in problem_of(path)
    path.write_text('vehicle = "arq"\n')
    word = "simulation.duration=1e9"
    assert problem_of(path, word).startswith(f"override {word}: simulation.duration: ")
    # With a pilot there are too many ticks: here, too, no clock was given.
    said = problem_of(path, "reference.type=hold", "simulation.duration=1e4")
    assert said.startswith("override simulation.duration=1e4: simulation.duration: must be at most")


# -- entries of lists that are not given ------------------------------------------------------------


def test_entries_of_defaults_can_be_overridden(tmp_path: Path) -> None:
    """The file leaves the start and the arms to default and preset; one entry is changed."""
    path = tmp_path / "scenario.toml"
    path.write_text('vehicle = "arq"\n')
    plain = read_scenario(path)
    moved = read_scenario(path, ["start.position.2=3", "start.position[0]=1 m"])
    assert moved.start.position == (1.0, 0.0, 3.0)
    turned = read_scenario(path, ["vehicle.arms.directions.1=-48 deg"]).vehicle.arms.directions
    before = plain.vehicle.arms.directions
    assert turned[1] == pytest.approx(-0.8377580409572782)
    assert (turned[0], *turned[2:]) == (before[0], *before[2:])


def test_entries_that_are_not_there_are_counted(tmp_path: Path) -> None:
    """How many there are."""
    path = tmp_path / "scenario.toml"
    path.write_text('vehicle = "arq"\n')
    assert "there is no entry 3; entries are 0 to 2" in problem_of(path, "start.position.3=1")
    word = "world.obstacles.0.distance=1"
    assert "there is no entry 0; the list is empty" in problem_of(path, word)
    assert "it is not a list" in problem_of(path, "vehicle.arms.length.0=0.2")
    said = problem_of(path, "start.velocty.0=2")
    assert said.endswith("unknown key 'velocty'; did you mean velocity?"), said
    assert "unknown key 'zzz'; known here: " in problem_of(path, "start.zzz.0=2")


def test_an_obstacle_that_is_named_in_an_override_is_told_its_number(tmp_path: Path) -> None:
    """The words before it are those of any other override at fault."""
    path = tmp_path / "scenario.toml"
    entries = "".join(
        f'[[world.obstacles]]\ntype = "wall"\nname = "{name}"\ndistance = {k + 3}\nsurface = "wall"\n'
        for k, name in enumerate(("door", "column", "table"))
    )
    path.write_text(f'vehicle = "arq"\n{entries}[start]\nvelocity = [1, 0, 0]\n')
    said = problem_of(path, "world.obstacles.column.distance=5")
    assert said == (
        "override world.obstacles.column.distance=5: entries of world.obstacles go by number, "
        "0 to 2: column is number 1"
    )
    said = problem_of(path, "world.obstacles.tabel.distance=5")
    assert said.endswith("number, 0 to 2, not by 'tabel'; did you mean table, number 2?"), said
    assert problem_of(path, "start.velocity.x=5") == (
        "override start.velocity.x=5: entries of start.velocity go by number, 0 to 2"
    )
    assert problem_of(path, "world.obstacles.7.distance=5") == (
        "override world.obstacles.7.distance=5: there is no entry 7; entries are 0 to 2"
    )


def test_a_number_may_begin_or_end_with_its_point(tmp_path: Path) -> None:
    """In an override; TOML itself wants a digit on both sides."""
    given = {"start": {"position": [0.0, 0.0, 1.0]}}
    for text, value in nonempty({"-.22": -0.22, ".5e-1": 0.05, "+2.": 2.0}.items()):
        found = apply_overrides(given, [f"start.position.1={text}"])
        assert found["start"]["position"][1] == value
