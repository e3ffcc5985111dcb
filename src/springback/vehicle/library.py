"""Vehicles of the paper, each number with its table and row, and all of the library.

``given`` is printed there, ``derived`` follows from printed numbers, ``chosen`` is our choice where
the source gives none; ``fitted`` numbers name what they were fitted to.
"""

from __future__ import annotations

from math import pi

from springback.vehicle.endurance import GRAVITY
from springback.vehicle.folding import FOLDING
from springback.vehicle.parameters import Arms, Body, Hull, Vehicle
from springback.vehicle.propulsion import Propulsion
from springback.vehicle.published import PUBLISHED, Entry

#: Directions of the X layout in the paper's order: front left, front right, rear right, rear left.
X_LAYOUT = (pi / 4, -pi / 4, -3 * pi / 4, 3 * pi / 4)
LENGTH, CAGE_RADIUS = 0.19, 0.11
BATTERY = 0.37  # [kg] from the printed hover times, docs/paper/errata.md
ARM_MASS = 0.05  # four arms make the printed 0.2 kg
C_TAU = 0.016  # [m]
PAYLOAD = 1.64  # [kg] Table I, Quad
SPECIFIC_ENERGY = 140.0 * 3600.0  # [J/kg] of a lithium polymer pack
FIGURE_OF_MERIT = 0.4659  # from Quad's printed hover time, 573 s, tests/vehicle/test_endurance.py


def _arms(*, compliant: bool | tuple[bool, ...], mass: float, end_stops: bool) -> Arms:
    return Arms(
        directions=X_LAYOUT,
        length=LENGTH,
        mass=mass,
        cage_radius=CAGE_RADIUS,
        compliant=compliant,
        stiffness=5e3,
        damping=90.0,
        stroke=0.05,
        end_stops=end_stops,
        torque_ratio=C_TAU,
    )


def _principal(xx: float, yy: float, zz: float) -> tuple[tuple[float, ...], ...]:
    return ((xx, 0.0, 0.0), (0.0, yy, 0.0), (0.0, 0.0, zz))


#: For both robots: a sphere around the electronics, between the cages, which leave 80 mm.
HULL = Hull(radius=0.06)
#: For both robots: Table I gives them different masses, not different motors.
PROPULSION = Propulsion(
    max_thrust=(0.844 + BATTERY + PAYLOAD) * GRAVITY / 4.0,
    figure_of_merit=FIGURE_OF_MERIT,
    disk_radius=0.0635,
    battery_energy=BATTERY * SPECIFIC_ENERGY,
    electronics_power=10.0,
)

# Table I prints the inertia of the whole vehicle; four point masses at L in the X layout add
# 2 m_a L² about x and y and 4 m_a L² about z.
_ARM_SHARE = 2.0 * ARM_MASS * LENGTH**2
ARQ_BODY_INERTIA = _principal(0.0100 - _ARM_SHARE, 0.0116 - _ARM_SHARE, 0.0197 - 2.0 * _ARM_SHARE)
QUAD_INERTIA = _principal(0.0092, 0.0107, 0.0179)

_HULL_SOURCES = {
    "hull.radius": "chosen: 60 mm, about the 83 x 58 mm of the Odroid XU4 of section II, half of "
    "whose diagonal is 51 mm, and within the 80 mm from the centre to the cages; none is printed",
}
_ARM_SOURCES = {
    "arms.directions": "given: section III, e_1 and e_2, X configuration; e_3, e_4 from eq. (2)",
    "arms.length": "given: Table I, row Arm length",
    "arms.cage_radius": "given: section II, radius of the protective cages",
    "arms.torque_ratio": "chosen: that of RotorS's Hummingbird; the paper prints no c_tau",
}
_PROPULSION_SOURCES = {
    "propulsion.max_thrust": "derived: fitted to Quad's Maximum payload, 1.64 kg in Table I, read "
    "as what the rotors just hold; ARQ's 1.38 kg would be 2.5 % less thrust",
    "propulsion.min_thrust": "chosen: rotors do not turn backwards",
    "propulsion.time_constant": "chosen: 25 ms, the slower of RotorS's Hummingbird (12.5 ms up, 25 "
    "ms down); JSK's aerial_robot assumes 90 ms; the paper prints none",
    "propulsion.figure_of_merit": "derived: fitted to Quad's Flight Time (Hover), 573 s in Table I,"
    " with the chosen numbers below; only its product with radius and energy is determined",
    "propulsion.disk_radius": "chosen: 5 inch propellers; the cages of 0.11 m leave room for 8 inch"
    ", which would take a figure of merit below 0.3",
    "propulsion.disk_height": "chosen: in the plane of the cages, which protect the propellers",
    "propulsion.stop": "chosen: none; the paper reports no rotor that stopped",
    "propulsion.surface_effect": "chosen: none; the paper models no effect of surfaces on thrust",
    "limits": "chosen: none; the paper reports nothing that broke",
    "propulsion.battery_energy": "chosen: 140 Wh/kg for the 0.37 kg of battery, as lithium polymer "
    "packs have (3 cells of 8.4 Ah weigh 0.65 kg: 143 Wh/kg)",
    "propulsion.usable_share": "chosen: 80 %, the usual rule for lithium polymer",
    "propulsion.electronics_power": "chosen: 10 W; the Odroid XU4 of section II takes 5.5 to 8.5 W "
    "with all cores busy at 0.5 to 1.4 GHz (sbc-bench), and there is an autopilot",
    "propulsion.air_density": "chosen: standard atmosphere at sea level, ISO 2533",
}
_COMPLIANT_SOURCES = {
    "arms.mass": "derived: Table II, m_a = 0.2 kg read as all four arms (docs/paper/errata.md)",
    "arms.stiffness": "given: Table II, k_l",
    "arms.damping": "given: Table II, b_l",
    "arms.stroke": "chosen: 50 mm; the paper prints none, its runs need about 15 to 40 mm",
    "arms.stop_stiffness": "chosen: stiff against k_l; the paper has no end stops",
    "arms.stop_dissipation": "chosen: end stops rebound softly; the paper has none",
}

ARQ = Entry(
    Vehicle(
        name="arq",
        body=Body(mass=1.034 + BATTERY - 4.0 * ARM_MASS, inertia=ARQ_BODY_INERTIA),
        hull=HULL,
        arms=_arms(compliant=True, mass=ARM_MASS, end_stops=True),
        propulsion=PROPULSION,
    ),
    "ARQ as flown: compliant arms, with battery",
    {
        "body.mass": "derived: Table I, 1.034 kg, + 0.37 kg of battery (docs/paper/errata.md), "
        "- 0.2 kg of arms",
        "body.inertia": "derived: Table I, rows Moments of inertia, less the arms' m_a L^2",
        **_HULL_SOURCES,
        **_ARM_SOURCES,
        **_COMPLIANT_SOURCES,
        **_PROPULSION_SOURCES,
    },
)

QUAD = Entry(
    Vehicle(
        name="quad",
        body=Body(mass=0.844 + BATTERY, inertia=QUAD_INERTIA),
        hull=HULL,
        arms=_arms(compliant=False, mass=0.0, end_stops=True),
        propulsion=PROPULSION,
    ),
    "Quad as flown: the rigid twin, with battery",
    {
        "body.mass": "derived: Table I, 0.844 kg, + 0.37 kg of battery (docs/paper/errata.md)",
        "body.inertia": "given: Table I, rows Moments of inertia",
        **_HULL_SOURCES,
        "arms.mass": "derived: rigid arms are part of the body",
        **_ARM_SOURCES,
        **_PROPULSION_SOURCES,
    },
)

ARQ_ON_SLIDER = Entry(
    Vehicle(
        name="arq-slider",
        body=Body(mass=1.882, inertia=ARQ_BODY_INERTIA),
        arms=_arms(compliant=True, mass=ARM_MASS, end_stops=False),
    ),
    "ARQ on the slider of section IV-A, with its bar; no end stops, as in the paper",
    {
        "body.mass": "given: Table II, m_b",
        "body.inertia": "as flown; without effect on a slider",
        "arms.end_stops": "given: the paper's equations have none",
        **_ARM_SOURCES,
        **_COMPLIANT_SOURCES,
    },
)

QUAD_ON_SLIDER = Entry(
    Vehicle(
        name="quad-slider",
        body=Body(mass=1.892, inertia=QUAD_INERTIA),
        arms=_arms(compliant=False, mass=0.0, end_stops=False),
    ),
    "Quad on the slider of section IV-A, sliding bar included",
    {
        "body.mass": "given: Table II, m_rigid",
        "body.inertia": "as flown; without effect on a slider",
        "arms.mass": "derived: rigid arms are part of the body",
        **_ARM_SOURCES,
    },
)

ARQ_LUMPED = Entry(
    Vehicle(
        name="arq-lumped",
        body=Body(mass=1.882, inertia=ARQ_BODY_INERTIA),
        arms=Arms(
            directions=(0.0,), length=LENGTH, mass=0.2, cage_radius=CAGE_RADIUS, compliant=True,
            stiffness=5e3, damping=90.0, stroke=0.05, end_stops=False,
        ),
    ),
    "Reading A of the slider tests: one mass of 0.2 kg and one spring in series along X",
    {
        "body.mass": "given: Table II, m_b",
        "arms.directions": "chosen: reading A, the spring lies along the motion",
        "arms.mass": "given: Table II, m_a, read as one lumped mass",
        "arms.stiffness": "given: Table II, k_l",
        "arms.damping": "given: Table II, b_l",
        "arms.end_stops": "given: the paper's equations have none",
    },
)  # fmt: skip

# -- the same authors' next robot ------------------------------------------------------------------

_S_ARQ = "the paper of s-ARQ (arXiv:2305.14680)"
_MORE = 1.04  # weight over that of its rigid frame

S_ARQ = Entry(
    Vehicle(
        name="s-arq",
        body=Body(
            mass=_MORE * 0.844 + BATTERY - 4.0 * ARM_MASS,
            inertia=_principal(
                _MORE * 0.0092 - _ARM_SHARE,
                _MORE * 0.0107 - _ARM_SHARE,
                _MORE * 0.0179 - 2.0 * _ARM_SHARE,
            ),
        ),
        hull=HULL,
        arms=_arms(compliant=(True, False, False, False), mass=ARM_MASS, end_stops=True),
        propulsion=PROPULSION,
    ),
    "A frame like Quad's of which one arm yields, after s-ARQ",
    {
        "body.mass": f"derived: Quad's 0.844 kg and 4 % (given: {_S_ARQ}, weight over its rigid "
        "frame, whose own is not known here), + 0.37 kg of battery, - 0.2 kg of arms' ends",
        "body.inertia": "derived: Quad's and 4 %, less the arms' m_a L^2",
        **_HULL_SOURCES,
        **_ARM_SOURCES,
        **_COMPLIANT_SOURCES,
        "arms.mass": "chosen: as of arq, at the ends of the rigid arms, too, for balance",
        "arms.compliant": f"given: {_S_ARQ}, one arm yields; chosen: the front left",
        "arms.length": "chosen: as of Quad",
        "arms.cage_radius": "chosen: as of Quad",
        "arms.stiffness": "chosen: as of arq",
        "arms.damping": "chosen: as of arq",
        **_PROPULSION_SOURCES,
        "propulsion.max_thrust": "chosen: as of Quad",
    },
)

_OF_THE_PAPER = (ARQ, QUAD, ARQ_ON_SLIDER, QUAD_ON_SLIDER, ARQ_LUMPED)
#: Vehicles of other papers and simulators.
OF_OTHERS = (S_ARQ, *PUBLISHED, *FOLDING)
VEHICLES = {entry.vehicle.name: entry for entry in (*_OF_THE_PAPER, *OF_OTHERS)}
