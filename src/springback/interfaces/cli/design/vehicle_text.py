"""A scenario file with a vehicle of some answers, whose comments say where each number is from."""

from __future__ import annotations

import math

from springback.interfaces.cli.design.sizes import (
    BATTERY,
    DAMPING_RATIO,
    ENDS,
    FRAME,
    LIFT,
    SPECIFIC_ENERGY,
    TIP_SPEED,
    TORQUE_SHARE,
    BodyBox,
    VehicleAnswer,
    VehicleSizes,
    ratio_of_peak,
)

#: Distance of the wall [m], and of the vehicle's foremost point from it at the start [m].
WALL, AHEAD = 2.0, 0.2
#: Column of comments.
COLUMN = 37


def vehicle_text(name: str, known: dict[str, VehicleAnswer], sizes: VehicleSizes) -> str:
    """Text of the file.

    Args:
        name: Of the file, and the vehicle.
        known: Answers by the name of their question.
        sizes: What follows from them.
    """
    asked = [f"#   {key} {one.text}: {one.source}" for key, one in known.items()]
    lines = [
        f"# A vehicle with {sizes.arms} arms flies into a wall. It was made from these answers:",
        *asked,
        f"#   springback check {name}.toml",
        f"#   springback fly {name}.toml --out {name}-flight",
        "#",
        "# Comments say where a number comes from: given, derived by a formula, or chosen. Replace",
        "# chosen numbers with what you weigh and measure, above all masses and the spring.",
        '# Numbers are SI, or text with a unit: "0.6 kg", "3 N/mm", "45 deg". All keys:',
        "# springback new vehicle NAME --template.",
        f'name = "{name}"',
        *_line("thrust", '"hover"', "[N] of each rotor: its share of the weight"),
        "",
        "[vehicle]",
        f'name = "{name}"',
        "",
        *_body(known, sizes),
        *_arms(known, sizes),
        *_propulsion(known, sizes),
        *_scene(known, sizes),
    ]
    return "\n".join(lines) + "\n"


def _line(key: str, value: str, *comments: str) -> list[str]:
    """A key with its comment, which goes on below."""
    first = f"{key} = {value}".ljust(COLUMN - 1)
    return [
        f"{first if k == 0 else ' ' * (COLUMN - 1)} # {text}" if text else first.rstrip()
        for k, text in enumerate(comments or ("",))
    ]


def _text(value: float, unit: str, digits: int = 6) -> str:
    """Value in SI as text in a unit."""
    scale = {"g": 1e3, "mm": 1e3, "N/mm": 1e-3, "ms": 1e3, "Wh": 1.0 / 3600.0}.get(unit, 1.0)
    return f'"{scale * value:.{digits}g} {unit}"'


def _list(values: list[str]) -> str:
    return f"[{', '.join(values)}]"


# -- tables ----------------------------------------------------------------------------------------


def _body(known: dict[str, VehicleAnswer], s: VehicleSizes) -> list[str]:
    is_rigid = known["spring"].value is None
    ends = f"{100 * ENDS:g} % of {known['mass'].text}, chosen"
    what = "arms are part of it" if is_rigid else "all but the ends of the arms"
    lines = [
        f"# The main body, {what}: its mass and inertia follow from its parts,",
        "# by Steiner's theorem. Positions are relative to the centre of mass: heights balance.",
        *_part(
            "battery", s.battery, f"{100 * BATTERY:g} % of {known['mass'].text}, chosen",
            "that of packs of 2100 kg/m³, chosen", "below the plane of the arms",
        ),
        *_part(
            "frame and arms", s.frame, f"{100 * FRAME:g} % of {known['mass'].text}, chosen",
            f"gives the inertia of {s.arms} rods to 0.6 of an arm's length", "",
        ),
        *_part(
            "boards and wires", s.boards, "derived: what is left of the mass",
            "that of 700 kg/m³, chosen", "derived: height times mass as for the battery",
        ),
    ]  # fmt: skip
    if is_rigid:
        for j, angle in enumerate(s.directions, start=1):
            x, y, _ = _along(angle, s.length)
            lines += [
                "[[vehicle.body.parts]]",
                'type = "point"',
                f'name = "end of arm {j}"',
                *_line("mass", _text(s.end_mass, "g"), f"of {s.arms}: {ends}" if j == 1 else ""),
                *_line("position", _list([x, y, "0"])),
            ]
    return [
        *lines,
        "",
        "[vehicle.hull]",
        *_line("radius", _text(s.hull, "mm"), "derived: sphere around battery and boards,"
               , "or as far as the circles around the rotors leave room"),
        "",
    ]  # fmt: skip


def _along(angle: float, length: float) -> tuple[str, str, str]:
    """A place on an arm, as texts."""
    turn = math.radians(angle)
    x, y = length * math.cos(turn), length * math.sin(turn)
    return _text(round(x, 7) + 0.0, "mm"), _text(round(y, 7) + 0.0, "mm"), '"0 mm"'


def _part(name: str, box: BodyBox, mass: str, size: str, height: str) -> list[str]:
    lines = [
        "[[vehicle.body.parts]]",
        'type = "box"',
        f'name = "{name}"',
        *_line("mass", _text(box.mass, "g"), mass),
        *_line("size", _list([_text(side, "mm") for side in box.size]), size),
    ]
    if box.height:
        lines += _line("position", _list(["0", "0", _text(box.height, "mm")]), height)
    return lines


def _arms(known: dict[str, VehicleAnswer], s: VehicleSizes) -> list[str]:
    guard, spring = known["guard"], known["spring"].value
    angles = _list([f'"{angle:g} deg"' for angle in s.directions])
    lines = ["[vehicle.arms]", "# chosen: evenly around, clockwise from the front left"]
    lines.append(f"directions = {angles}")
    lines += _line(
        "length", _text(s.length, "mm"), f"derived: half of the span, {known['span'].text}"
    )
    if guard.value is None:
        lines += _line(
            "cage_radius",
            _text(s.circle, "mm"),
            "derived: that of the propeller, as there is no guard",
        )
        lines += _line("cages", "false", "so that hulls touch, and the circle does not")
    else:
        lines += _line("cage_radius", _text(s.circle, "mm"), f"{guard.source}: that of the guard")
    if spring is None:
        lines += _line("mass", "0.0", "derived: rigid arms are part of the body")
        lines += _line("compliant", "false", "given: no spring")
    else:
        lines += [
            *_line("mass", _text(s.end_mass, "g"), f"of what slides, {100 * ENDS:g} % of "
                   f"{known['mass'].text} over {s.arms}:", "motor, propeller, guard; chosen"),
            *_line("compliant", "true"),
            "# derived: one arm stops the rest of the vehicle, m, from speed v in a distance s:",
            "#   its frequency w = (v/s) exp(-z/sqrt(1 - z^2) arccos z) with the damping ratio",
            f"#   z = {DAMPING_RATIO:g} (chosen, as of arq): {ratio_of_peak():.3g} v/s of",
            f"#   v = {spring.speed:g} m/s, s = {1e3 * spring.stroke:g} mm, m = "
            f"{1e3 * s.pushed:.6g} g",
            *_line("stiffness", _text(s.stiffness, "N/mm"), "derived: m w^2"),
            *_line("damping", _text(s.damping, "N s/m"), "derived: 2 z m w"),
            *_line("stroke", _text(s.stop, "mm"), "derived: to the stop; s is at most 80 % of it"),
        ]  # fmt: skip
    lines += _line("torque_ratio", _text(s.torque, "mm"), f"derived: {TORQUE_SHARE:g} of the "
                   "propeller's diameter,", "chosen: C_P/(2 pi C_T), as usual")  # fmt: skip
    if guard.value is None:
        for j in range(1, s.arms + 1):
            lines += [
                "", "[[vehicle.hulls]]", 'type = "sphere"', f"on = {j}",
                *_line("radius", _text(s.hub, "mm"), "chosen: that of a motor" if j == 1 else ""),
            ]  # fmt: skip
    return [*lines, ""]


def _propulsion(known: dict[str, VehicleAnswer], s: VehicleSizes) -> list[str]:
    propeller = known["propeller"]
    energy = s.battery.mass * SPECIFIC_ENERGY
    radius = 0.5 * propeller.value
    return [
        "[vehicle.propulsion]",
        *_line("max_thrust", _text(s.thrust, "N"), f"derived: {LIFT:g} times the weight over "
               f"{s.arms}, chosen;", f"the propeller gives {s.most_thrust:g} N at a tip speed of "
               f"{TIP_SPEED:g} m/s"),
        *_line("time_constant", _text(s.lag, "ms"), "chosen: that of RotorS's Hummingbird, 8 inch;",
               "for larger propellers in proportion"),
        *_line("disk_radius", _text(radius, "mm"), f"{propeller.source}: half of {propeller.text}"),
        *_line("figure_of_merit", "0.45", "chosen: 0.47 follows from Quad's printed hover time"),
        *_line("battery_energy", _text(energy, "Wh", 3), "derived: 140 Wh/kg, lithium polymer"),
        *_line("electronics_power", '"5 W"', "chosen"),
        "",
    ]  # fmt: skip


def _scene(known: dict[str, VehicleAnswer], s: VehicleSizes) -> list[str]:
    spring = known["spring"].value
    speed = 2.0 if spring is None else spring.speed
    front = s.length + (s.circle if known["guard"].value else max(s.circle, s.hub))
    return [
        "[[world.obstacles]]",
        'type = "wall"',
        *_line("distance", _text(WALL, "m"), "of its face from the origin along X"),
        *_line("surface", '"wall"', "the paper's wooden wall; see docs/howto/surface.md"),
        "",
        "[start]",
        *_line("position", _list([_text(WALL - front - AHEAD, "m", 4), "0", '"1 m"']),
               f"derived: {1e3 * AHEAD:g} mm before the wall"),
        *_line("velocity", _list([_text(speed, "m/s"), "0", "0"]),
               "chosen" if spring is None else f"{known['spring'].source}"),
        *_line("yaw", f'"{-s.directions[0]:g} deg"', "so that one arm points straight ahead"),
        "",
        "[simulation]",
        'duration = "0.4 s"',
        "",
        "# With a pilot that hits the wall, recovers and returns: delete thrust, [start] and",
        '# [simulation] above, and take the "#~ " off these lines.',
        "#~ [reference]",
        '#~ type = "run-up"',
        f'#~ speed = "{speed:g} m/s"',
        f'#~ wall_distance = "{WALL:g} m"',
        f'#~ yaw = "{-s.directions[0]:g} deg"',
        "#~ [start]",
        f'#~ yaw = "{-s.directions[0]:g} deg"',
        "#~ [recovery]",
        "#~ [[world.obstacles]]",
        '#~ type = "ground"',
        '#~ surface = "wall"',
        "#~ [simulation]",
        '#~ duration = "9 s"',
    ]  # fmt: skip
