"""A craft whose arms do not slide, put together as one rigid body."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from oracles import models

Array = NDArray[np.float64]


class Rigid(NamedTuple):
    """Mass properties of a craft whose arms do not slide."""

    mass: float
    centre: Array  # of mass, from the main body, body axes [m]
    inertia: Array  # about the centre of mass, body axes [kg m²]


def rigid(craft: models.Craft, lengths: Array) -> Rigid:
    """Main body and point masses put together about their centre of mass."""
    masses = np.array([craft.body_mass, *(arm.mass for arm in craft.arms)])
    places = [np.zeros(3)]
    for arm, length in zip(craft.arms, lengths, strict=True):
        places.append(length * np.array([math.cos(arm.azimuth), math.sin(arm.azimuth), 0.0]))
    centre = masses @ np.array(places) / masses.sum()
    inertia = craft.inertia.copy()
    for mass, place in zip(masses, np.array(places) - centre, strict=True):
        inertia += mass * (place @ place * np.eye(3) - np.outer(place, place))
    return Rigid(float(masses.sum()), centre, inertia)
