"""Mass and inertia of model files: MuJoCo's own, sums by Steiner's theorem, and what is refused."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

from oracles.mujoco_masses import by_mujoco, is_same
from springback import InputError, fly
from springback.campaign.design.layout import lay_out
from springback.campaign.design.plan import Plan, read_plan
from springback.results.flight import as_scenario
from springback.scenario.files import read_scenario
from springback.scenario.masses.models import mass_of_model
from springback.scenario.overrides import apply_overrides
from springback.scenario.presets import read_vehicle
from springback.studies.scenario_check import derived_numbers
from springback.vehicle.parameters import Body

Array = np.ndarray[Any, np.dtype[np.float64]]
COUNT = 7


class Part(NamedTuple):
    """A link of a random tree: all numbers as texts that are read back unchanged."""

    parent: int
    kind: str  # of the joint to its parent
    place: str
    angles: str
    mass: float
    inner_place: str
    inner_angles: str
    moments: tuple[float, ...]
    products: tuple[float, ...]


def random_tree(seed: int) -> list[Part]:
    rng = np.random.default_rng(seed)

    def text(numbers: Array) -> str:
        return " ".join(map(repr, numbers.tolist()))

    parts = []
    for k in range(COUNT):
        turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
        points = rng.uniform(0.2, 1.0, 3)  # second moments of mass, so that any sum is possible
        whole = turn @ np.diag(points.sum() - points) @ turn.T * 1e-3
        parts.append(
            Part(
                int(rng.integers(k)) if k else 0,
                ("fixed", "fixed", "revolute")[int(rng.integers(3))],
                text(rng.uniform(-0.2, 0.2, 3)), text(rng.uniform(-1.5, 1.5, 3)),
                float(rng.uniform(0.05, 0.5)),
                text(rng.uniform(-0.1, 0.1, 3)), text(rng.uniform(-1.5, 1.5, 3)),
                tuple(np.diag(whole).tolist()),
                (float(whole[0, 1]), float(whole[0, 2]), float(whole[1, 2])),
            )
        )  # fmt: skip
    return parts


def as_urdf(tree: Sequence[Part]) -> str:
    words = ['<robot name="r"><mujoco><compiler fusestatic="false" boundmass="0"/></mujoco>']
    for k, part in enumerate(tree):
        (xx, yy, zz), (xy, xz, yz) = part.moments, part.products
        words.append(
            f'<link name="l{k}"><inertial><origin xyz="{part.inner_place}" rpy="{part.inner_angles}"/>'
            f'<mass value="{part.mass!r}"/><inertia ixx="{xx!r}" iyy="{yy!r}" izz="{zz!r}" '
            f'ixy="{xy!r}" ixz="{xz!r}" iyz="{yz!r}"/></inertial></link>'
        )
        if k:
            words.append(
                f'<joint name="j{k}" type="{part.kind}"><parent link="l{part.parent}"/>'
                f'<child link="l{k}"/><origin xyz="{part.place}" rpy="{part.angles}"/>'
                '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>'
            )
    return "".join([*words, "</robot>"])


def as_sdf(tree: Sequence[Part]) -> str:
    words = ['<sdf version="1.9"><model name="r"><pose>1 2 3 0.1 0.2 0.3</pose>']
    for k, part in enumerate(tree):
        (xx, yy, zz), (xy, xz, yz) = part.moments, part.products
        pose = "" if not k else (
            f'<pose relative_to="l{part.parent}">{part.place} {part.angles}</pose>'
        )  # fmt: skip
        words.append(
            f'<link name="l{k}">{pose}<inertial><pose>{part.inner_place} {part.inner_angles}</pose>'
            f"<mass>{part.mass!r}</mass><inertia><ixx>{xx!r}</ixx><iyy>{yy!r}</iyy><izz>{zz!r}</izz>"
            f"<ixy>{xy!r}</ixy><ixz>{xz!r}</ixz><iyz>{yz!r}</iyz></inertia></inertial></link>"
        )
        if k:
            words.append(
                f'<joint name="j{k}" type="{part.kind}"><parent>l{part.parent}</parent>'
                f"<child>l{k}</child></joint>"
            )
    return "".join([*words, "</model></sdf>"])


def as_mjcf(tree: Sequence[Part]) -> str:
    def body(k: int) -> str:
        part = tree[k]
        (xx, yy, zz), (xy, xz, yz) = part.moments, part.products
        moves = "<freejoint/>" if not k else '<joint axis="0 0 1"/>'
        inner = "".join(body(j) for j in range(k + 1, COUNT) if tree[j].parent == k)
        full = " ".join(map(repr, (xx, yy, zz, xy, xz, yz)))
        return (
            f'<body name="l{k}" pos="{part.place}" euler="{part.angles}">'
            f"{moves if not k or part.kind != 'fixed' else ''}"
            f'<inertial pos="{part.inner_place}" mass="{part.mass!r}" fullinertia="{full}"/>'
            f'<frame pos="0.1 0 0.2" euler="0.3 0 0.1">{inner}</frame></body>'
        )

    return (
        '<mujoco><compiler angle="radian" eulerseq="XYZ"/>'
        f"<worldbody>{body(0)}</worldbody></mujoco>"
    )


def fixed_names(tree: Sequence[Part]) -> list[str]:
    """The first link and all that are fixed to it."""
    held = [0]
    for k in range(1, COUNT):
        if tree[k].kind == "fixed" and tree[k].parent in held:
            held.append(k)
    return [f"l{k}" for k in held]


@pytest.mark.parametrize("write", [as_urdf, as_sdf, as_mjcf], ids=["urdf", "sdf", "mjcf"])
@pytest.mark.parametrize("seed", range(6))
def test_masses_are_those_of_mujoco(tmp_path: Path, seed: int, write: Any) -> None:
    """Of the fixed links, of each link, and of all; SDF, which MuJoCo does not read, as URDF."""
    tree = random_tree(seed)
    path = tmp_path / "robot.xml"
    path.write_text(write(tree))
    reference = as_urdf(tree) if write is as_sdf else write(tree)
    assert is_same(mass_of_model(path), by_mujoco(reference, fixed_names(tree)))
    names = [f"l{k}" for k in range(COUNT)]
    assert is_same(mass_of_model(path, ("l*",)), by_mujoco(reference, names))
    for name in names:
        assert is_same(mass_of_model(path, (name,)), by_mujoco(reference, [name]))


def test_fixed_bodies_are_those_that_mujoco_fuses(tmp_path: Path) -> None:
    """MuJoCo's own sum: bodies without joints are fused with what holds them."""
    text = as_mjcf(random_tree(3)).replace("<compiler", '<compiler fusestatic="true"')
    path = tmp_path / "robot.xml"
    path.write_text(text)
    assert is_same(mass_of_model(path), by_mujoco(text, ["l0"]))


def test_parts_apart_add_up_by_hand(tmp_path: Path) -> None:
    """Two balls of 0.1 kg on a stick of 0.4 m: 2 m r² across, each 2/5 m a² more."""
    own = 0.4 * 0.1 * 0.02**2
    text = '<sdf version="1.7"><model name="dumbbell">'
    for k, x in enumerate((0.1, 0.5)):
        text += (
            f'<link name="ball{k}"><pose>{x} 0 0.3 0 0 1.1</pose><inertial><mass>0.1</mass><inertia>'
            f"<ixx>{own}</ixx><iyy>{own}</iyy><izz>{own}</izz></inertia></inertial></link>"
        )
    text += '<joint name="j" type="fixed"><parent>ball0</parent><child>ball1</child></joint>'
    path = tmp_path / "dumbbell.sdf"
    path.write_text(text + "</model></sdf>")
    found = mass_of_model(path)
    s, c = np.sin(1.1), np.cos(1.1)
    assert found.mass == pytest.approx(0.2)
    assert found.centre == pytest.approx((0.2 * c, -0.2 * s, 0.0))  # in the axes of the first ball
    along = np.array([c, -s, 0.0])
    expected = 2.0 * own * np.eye(3) + 2.0 * 0.1 * 0.2**2 * (np.eye(3) - np.outer(along, along))
    assert np.array(found.inertia) == pytest.approx(expected)


# -- in a scenario ---------------------------------------------------------------------------------

ROBOT = """<robot name="r">
<link name="base">
<inertial><origin xyz="0 0 0.01"/><mass value="0.9"/>
<inertia ixx="0.004" iyy="0.005" izz="0.008" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="camera"><inertial><mass value="0.1"/>
<inertia ixx="1e-5" iyy="1e-5" izz="1e-5" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="rotor_0"><inertial><mass value="0.02"/>
<inertia ixx="1e-5" iyy="1e-5" izz="2e-5" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="mount" type="fixed"><parent link="base"/><child link="camera"/></joint>
<joint name="motor" type="continuous"><parent link="base"/><child link="rotor_0"/></joint>
</robot>
"""
SCENARIO = """name = "modelled"
[vehicle]
preset = "arq"
[vehicle.body]
model = "models/robot.urdf"
"""


@pytest.fixture
def scenario(tmp_path: Path) -> Path:
    """A scenario with a model in a folder beside it."""
    (tmp_path / "models").mkdir()
    (tmp_path / "models/robot.urdf").write_text(ROBOT)
    path = tmp_path / "modelled.toml"
    path.write_text(SCENARIO)
    return path


def test_a_scenario_takes_the_mass_of_its_model_and_is_stored_with_it(scenario: Path) -> None:
    """Fixed links alone; arms keep theirs; without the file the stored one is the same."""
    read = read_scenario(scenario)
    body = read.vehicle.body
    assert body.mass == pytest.approx(1.0)
    assert body.measured is not None
    assert body.measured.centre == pytest.approx((0.0, 0.0, 0.009))
    assert read.vehicle.mass == pytest.approx(1.2)
    assert body.inertia[2][2] == pytest.approx(0.00801)
    (scenario.parent / "models/robot.urdf").unlink()
    assert as_scenario(read.model_dump(mode="json")) == read


def test_what_was_stored_is_read_anew_where_its_model_or_links_change(scenario: Path) -> None:
    """Else the masses of another file would be taken without a word."""
    stored = read_scenario(scenario).model_dump(mode="json")
    other = scenario.parent / "models/other.urdf"
    other.write_text(ROBOT.replace('"0.9"', '"0.7"'))
    changed = apply_overrides(stored, [f"vehicle.body.model={other}"])
    assert as_scenario(changed).vehicle.body.mass == pytest.approx(0.8)
    changed = apply_overrides(stored, ['vehicle.body.links=["base"]'])
    assert as_scenario(changed).vehicle.body.mass == pytest.approx(0.9)
    with pytest.raises(InputError, match="model: is read with the vehicle of a scenario"):
        as_scenario(stored).vehicle.body.model_copy(update={"model": str(other)})
    with pytest.raises(InputError, match="model: is read with the vehicle of a scenario"):
        Body(model=str(other))


def test_the_check_tells_where_the_centre_of_mass_is(scenario: Path) -> None:
    """Arms and hulls are placed from there, the model from its first link."""
    told = {number.name: number for number in derived_numbers(read_scenario(scenario))}
    assert told["centre of mass along z"].value == pytest.approx(0.009)
    assert told["centre of mass along x"].unit == "m"


def test_links_are_chosen_by_name_and_pattern(scenario: Path) -> None:
    words = ['vehicle.body.links=["base", "rotor_*"]']
    assert read_scenario(scenario, words).vehicle.body.mass == pytest.approx(0.92)
    assert read_scenario(scenario, ["vehicle.body.links=base"]).vehicle.body.mass == 0.9


def test_a_file_that_changes_is_read_again(scenario: Path) -> None:
    assert read_scenario(scenario).vehicle.body.mass == pytest.approx(1.0)
    path = scenario.parent / "models/robot.urdf"
    path.write_text(ROBOT.replace('"0.9"', '"0.80"'))
    assert read_scenario(scenario).vehicle.body.mass == pytest.approx(0.9)


def test_a_vehicle_in_a_file_of_its_own_finds_its_model_beside_it(scenario: Path) -> None:
    folder = scenario.parent / "models"
    (folder / "mine.toml").write_text('preset = "arq"\n[body]\nmodel = "robot.urdf"\n')
    scenario.write_text('vehicle = "models/mine.toml"\n')
    assert read_scenario(scenario).vehicle.body.mass == pytest.approx(1.0)
    assert read_vehicle(folder / "mine.toml")["body"]["mass"] == pytest.approx(1.0)
    changed = ['vehicle.body.links="base"']
    assert read_scenario(scenario, changed).vehicle.body.mass == pytest.approx(0.9)
    parts = ['vehicle.body.parts=[{type="ball", mass="0.7 kg", radius="60 mm"}]']
    assert read_scenario(scenario, parts).vehicle.body.mass == pytest.approx(0.7)


def test_a_campaign_varies_the_mass_that_was_read(scenario: Path) -> None:
    """The plan holds the numbers, not the file."""
    plan = scenario.with_name("plan.toml")
    plan.write_text(
        'scenario = "modelled.toml"\nmethod = "grid"\n'
        '[[vary]]\nfield = "vehicle.body.mass"\nvalues = [1.0, 1.2]\n'
    )
    read, source = read_plan(plan)
    (scenario.parent / "models/robot.urdf").unlink()
    assert isinstance(read, Plan)
    assert lay_out(read, source).flights == 2


def test_it_flies(scenario: Path) -> None:
    flight = fly(scenario, "simulation.duration=0.01", "thrust=0.0", executor="python")
    assert flight.scenario.vehicle.body.model.endswith("robot.urdf")


# -- what is refused -------------------------------------------------------------------------------

SDF = """<sdf version="1.9"><model name="r">
<link name="base">
<inertial><mass>0.9</mass><inertia><ixx>0.004</ixx><iyy>0.005</iyy><izz>0.008</izz></inertia></inertial>
</link></model></sdf>
"""
MJCF = """<mujoco><worldbody><body name="base"><freejoint/>
<inertial pos="0 0 0" mass="0.9" diaginertia="0.004 0.005 0.008"/><geom size="0.1"/>
</body></worldbody></mujoco>
"""
BAD: dict[str, tuple[str, str, str, str]] = {
    "negative mass": (ROBOT, 'value="0.9"', 'value="-0.9"',
                      ":3: mass: value [kg]: must be at least 0 (got -0.9)"),
    "no number": (ROBOT, 'value="0.9"', 'value="heavy"', ":3: mass: value [kg]: must be numbers"),
    "no mass": (ROBOT, '<mass value="0.9"/>', "", ":3: inertial: mass of link base is missing"),
    "no moment": (ROBOT, ' izz="0.008"', "", ":4: inertia: izz of link base is missing"),
    "of no body": (ROBOT, 'izz="0.008"', 'izz="0.08"', "inertia of base, camera is that of no body"),
    "massless": (ROBOT, 'value="0.', 'value="0.0', ""),
    "macro": (ROBOT, "<link name=\"camera\">", "<xacro:if/><link name=\"camera\">", "is a macro"),
    "no inertial": (SDF, re.findall(r"<inertial>.*</inertial>", SDF)[0], "",
                    ":2: link: base: inertial is missing; Gazebo then assumes 1 kg and 1 kg m²"),
    "automatic": (SDF, "<inertial>", '<inertial auto="true">', "inertial: of link base is automatic"),
    "no mass in SDF": (SDF, "<mass>0.9</mass>", "", ":3: inertial: mass of link base is missing"),
    "no moment in SDF": (SDF, "<iyy>0.005</iyy>", "", ":3: inertia: iyy of link base is missing"),
    "mass of Gazebo": (SDF, "0.9", "0.9 kg", ":3: mass [kg]: must be numbers (got '0.9 kg')"),
    "two robots": (SDF, "</sdf>", '<model name="s"/></sdf>', "has 2 models (r, s); mass is read"),
    "a part that is not there": (SDF, "</model>", "<include><uri>model://camera</uri></include></model>",
                                 "camera: there is no model://camera in"),
    "a joint to nothing": (SDF, "</model>", '<joint name="j" type="fixed"><parent>base</parent>'
                           "<child>tail</child></joint></model>", "j: there is no link 'tail'"),
    "no diagonal": (MJCF, ' diaginertia="0.004 0.005 0.008"', "",
                    ":2: inertial: diaginertia or fullinertia of body base is missing"),
    "changed when compiled": (MJCF, "<worldbody>", '<compiler settotalmass="2"/><worldbody>',
                              "compiler: settotalmass changes masses: not read (got '2')"),
    "two in a world": (MJCF, "</worldbody>", '<body name="other"><freejoint/></body></worldbody>',
                       "has 2 bodies in the world (base, other); mass is read"),
    "a replica": (MJCF, "<freejoint/>", '<freejoint/><replicate count="2"/>', "repeats what it holds"),
    "no format": ("<world/>", "", "", "is neither SDF (sdf), MJCF (mujoco) nor URDF (robot)"),
    "no XML": ("mass = 1", "", "", ":1: is not XML"),
}  # fmt: skip


@pytest.mark.parametrize("name", BAD)
def test_a_wrong_model_is_one_line_with_file_and_element(tmp_path: Path, name: str) -> None:
    text, old, new, message = BAD[name]
    assert old in text
    path = tmp_path / "robot.xml"
    path.write_text(text.replace(old, new) if old else text)
    if not message:
        path.write_text(re.sub(r'mass value="[\d.]+"', 'mass value="0"', text))
        message = "mass of base, camera is 0 kg; must be more than 0 kg"
    with pytest.raises(InputError) as caught:
        as_scenario({"vehicle": {"preset": "arq", "body": {"model": str(path)}}})
    assert len(caught.value.problems) == 1
    assert caught.value.problems[0].startswith("vehicle.body.model: ")
    assert "robot.xml" in caught.value.problems[0]
    assert message in caught.value.problems[0]


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"model": "no.urdf"}, "vehicle.body.model: no.urdf: cannot be read"),
        ({"model": 3}, "vehicle.body.model: must be the path of a file (got 3)"),
        ({"links": ["tail"]}, "has no link 'tail'; there are: base, camera, rotor_0"),
        ({"links": 3}, "vehicle.body.links: must be names of links (got 3)"),
        ({"mass": 1.0}, "vehicle.body.mass: follows from model; leave it out"),
        ({"inertia": [1, 1, 1]}, "vehicle.body.inertia: follows from model; leave it out"),
        ({"parts": [{"type": "ball", "mass": 1, "radius": 0.1}]}, "cannot be combined with parts"),
        (
            {"model": "", "mass": 1, "inertia": [0.01] * 3, "links": ["base"]},
            "links: needs a model",
        ),
    ],
)
def test_what_cannot_be_beside_a_model(
    scenario: Path, changes: dict[str, Any], message: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(scenario.parent)
    body = {"model": "models/robot.urdf", **changes}
    with pytest.raises(InputError) as caught:
        as_scenario({"vehicle": {"preset": "arq", "body": body}})
    assert message in caught.value.problems[0]


def test_a_model_too_small_for_its_mass_is_refused(scenario: Path) -> None:
    """In millimetres and grams, as CAD may write it."""
    (scenario.parent / "models/robot.urdf").write_text(ROBOT.replace('"0.9"', '"900"'))
    with pytest.raises(
        InputError, match=r"modelled.toml:5: vehicle.body.model: must have principal"
    ):
        read_scenario(scenario)
