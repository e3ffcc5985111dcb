"""The same vehicle in MuJoCo: a free body with four point masses on slides, and a wall.

Its contact is MuJoCo's own soft constraint: another law, but the work of a step is what is
compared here, not its result.  A cage is a thin disc, which is the circle of our model, or for
comparison a sphere, MuJoCo's cheapest shape, which touches elsewhere once the vehicle tilts.
"""

from __future__ import annotations

import math
import time
from typing import Any

import numpy as np

from benchmarks.job import Array
from springback.simulation.measuring.record import Model
from springback.vehicle.state import Arm, State

#: MuJoCo asks for some inertia of every moving body [kg m²].
POINT = 1e-7
#: Half the thickness of a disc [m].
THIN = 0.001
CAGES = {"disc": "cylinder", "sphere": "sphere"}


def _arm(arm: Arm, cage: str) -> str:
    reach = f"{arm.cosine * arm.length!r} {arm.sine * arm.length!r} 0"
    stroke = arm.length - arm.shortest
    return f"""
        <body pos="{reach}">
          <joint type="slide" axis="{arm.cosine!r} {arm.sine!r} 0" stiffness="{arm.stiffness!r}"
                 damping="{arm.damping!r}" limited="true" range="{-stroke!r} 0.001"/>
          <inertial pos="0 0 0" mass="{arm.mass!r}" diaginertia="{POINT} {POINT} {POINT}"/>
          <geom type="{CAGES[cage]}" size="{arm.cage_radius!r} {THIN}" contype="1"
                conaffinity="2"/>
        </body>"""


#: What our step measures besides: specific force, angular rate, velocity of the centre of mass.
SENSORS = """
      <sensor>
        <accelerometer site="thrust"/><gyro site="thrust"/><subtreelinvel body="main"/>
      </sensor>"""


def xml(
    model: Model, integrator: str, cage: str, measuring: bool, *, wall: str = "", watched: str = ""
) -> str:
    """The vehicle and its wall as an MJCF document.

    Args:
        model: Ours.
        integrator: ``implicitfast`` or ``RK4``.
        cage: ``disc`` or ``sphere``.
        measuring: With energies and sensors, as our step has its ledger and measures.
        wall: Further attributes of the wall, whose name is ``wall``.
        watched: Sensors in place of those of `measuring`.
    """
    frame = model.airframe
    body_mass = frame.mass - sum(arm.mass for arm in frame.arms)
    i = frame.inertia
    full = " ".join(repr(x) for x in (i.x.x, i.y.y, i.z.z, i.x.y, i.x.z, i.y.z))
    surface = model.world.obstacles[0].surface
    away = -model.world.obstacles[0].shape.offset * model.world.obstacles[0].shape.normal.x
    sensors = f"<sensor>{watched}</sensor>" if watched else SENSORS if measuring else ""
    arms = "".join(_arm(arm, cage) for arm in frame.arms)
    return f"""
    <mujoco>
      <option timestep="{model.timing.impact_step!r}" integrator="{integrator}"
              gravity="0 0 {-model.world.gravity!r}">
        <flag energy="{"enable" if measuring else "disable"}"/>
      </option>
      <worldbody>
        <geom name="wall" type="plane" pos="{abs(away)!r} 0 0" zaxis="-1 0 0" size="5 5 1"
              contype="2" conaffinity="1" friction="{surface.friction!r}" {wall}/>
        <body name="main" pos="0 0 0">
          <freejoint/>
          <inertial pos="0 0 0" mass="{body_mass!r}" fullinertia="{full}"/>
          <site name="thrust" pos="0 0 0"/>
          {arms}
        </body>
      </worldbody>
      <actuator><motor site="thrust" gear="0 0 1 0 0 0"/></actuator>{sensors}
    </mujoco>"""


class Rollout:
    """Many flights by ``mujoco.rollout`` on a pool of threads.

    Args:
        model: Ours.
        states: One start for each flight.
        integrator: ``implicitfast`` or ``RK4``.
        steps: Of every flight.
        threads: In the pool.
        cage: ``disc`` or ``sphere``.
        measuring: With energies and sensors.
    """

    def __init__(
        self,
        model: Model,
        states: list[State],
        integrator: str,
        steps: int,
        threads: int,
        cage: str = "disc",
        measuring: bool = False,
    ) -> None:
        """Compile the model and lay out the start states."""
        import mujoco
        from mujoco import rollout

        self.model = mujoco.MjModel.from_xml_string(xml(model, integrator, cage, measuring))
        self.data = [mujoco.MjData(self.model) for _ in range(threads)]
        self.pool: Any = rollout.Rollout(nthread=threads)
        self.steps = steps
        q_arms = np.zeros(len(model.airframe.arms))
        kind = mujoco.mjtState.mjSTATE_FULLPHYSICS
        blank = np.zeros(mujoco.mj_stateSize(self.model, kind))
        rows = []
        for s in states:
            row = blank.copy()
            pose = [*s.position, *s.attitude, *q_arms]
            twist = [*s.velocity, *s.angular_velocity, *q_arms]
            row[1 : 1 + len(pose) + len(twist)] = [*pose, *twist]  # after the time
            rows.append(row)
        self.initial: Array = np.array(rows)
        control = np.full((len(states), steps, 1), sum(model.thrust))
        self.control: Array = control
        self.output: Array = np.zeros((len(states), steps, len(blank)))
        self.measured: Array = np.zeros((len(states), steps, self.model.nsensordata))

    def run(self) -> float:
        """Steps a second, all flights together."""
        began = time.perf_counter()
        self.pool.rollout(
            self.model, self.data, self.initial, self.control,
            state=self.output, sensordata=self.measured,
        )  # fmt: skip
        seconds = time.perf_counter() - began
        if not math.isfinite(float(self.output[:, -1].sum())):
            raise RuntimeError("MuJoCo's flights are not finite")
        return len(self.initial) * self.steps / seconds

    def rebounds(self) -> int:
        """How many flights end up moving away from the wall."""
        forward = 1 + self.model.nq
        return int((self.output[:, -1, forward] < 0.0).sum())
