"""Materials of obstacles and guards, as ranges: what is known of them is a range, not a number.

Moduli are for `springback.vehicle.stiffness`; restitutions are those of a hard guard at 1 to 3 m/s,
frictions those against hard plastic or carbon.  Each range says where it is from: ``measured``,
``derived`` or ``from memory``.  Most are from memory, as handbooks and experience have them: a
result that depends on one is as sure as that.
"""

from __future__ import annotations

from typing import NamedTuple


class MaterialRange(NamedTuple):
    """A quantity between two bounds."""

    low: float
    high: float
    source: str

    @property
    def tag(self) -> str:
        """How it is known: ``measured``, ``derived`` or ``from memory``."""
        return self.source.partition(";")[0].partition(":")[0]

    @property
    def typical(self) -> float:
        """Geometric mean of the bounds; of bounds from 0, their mean."""
        if self.low > 0.0:
            return float((self.low * self.high) ** 0.5)
        return 0.5 * (self.low + self.high)


class Material(NamedTuple):
    """A material, and what is known of it."""

    summary: str
    young: MaterialRange | None = None  # E [Pa]
    poisson: float | None = None  # ν, from memory
    restitution: MaterialRange | None = None  # None: the guard alone decides
    friction: MaterialRange | None = None


_MEMORY = "from memory"
_GPA, _MPA, _KPA = 1e9, 1e6, 1e3


def _young(low: float, high: float, unit: float, source: str = _MEMORY) -> MaterialRange:
    return MaterialRange(low * unit, high * unit, source)


def _range(low: float, high: float, source: str = _MEMORY) -> MaterialRange:
    return MaterialRange(low, high, source)


MATERIALS = {
    "concrete": Material(
        "as rigid", _young(25, 35, _GPA), 0.2, friction=_range(0.5, 0.7)
    ),
    "steel": Material("as rigid", _young(190, 210, _GPA), 0.3, friction=_range(0.2, 0.4)),
    "glass": Material("as rigid, until it breaks", _young(60, 80, _GPA), 0.22,
                      friction=_range(0.2, 0.4)),
    "plywood": Material(
        "plywood or fibreboard; a panel bends besides", _young(6, 10, _GPA), 0.3,
        _range(0.45, 0.6, "from memory; measured: 0.526 of a guarded robot at 1.85 m/s"),
        _range(0.3, 0.5),
    ),
    "drywall": Material(
        "plasterboard between studs; dents above some 100 N", _young(1.5, 2.5, _GPA), 0.3,
        _range(0.3, 0.5), _range(0.4, 0.6),
    ),
    "bark": Material(
        "a trunk, across its grain; crushes", _young(0.5, 1.0, _GPA), None, _range(0.2, 0.4),
        _range(0.5, 0.8),
    ),
    "green-wood": Material("a branch, along its grain", _young(5, 10, _GPA), None,
                           friction=_range(0.4, 0.6)),
    "carbon": Material("carbon fibre, tube or plate", _young(70, 130, _GPA), None,
                       friction=_range(0.2, 0.35)),
    "nylon": Material("PA66", _young(2, 4.1, _GPA, "from memory; 4.1 GPa in a simulator"), None,
                      friction=_range(0.25, 0.4)),
    "pla": Material("printed", _young(2.5, 3.5, _GPA), 0.35, _range(0.4, 0.6), _range(0.3, 0.4)),
    "abs": Material("printed", _young(1.7, 2.3, _GPA), 0.35, _range(0.4, 0.6), _range(0.3, 0.4)),
    "tpu": Material(
        "TPU 95A, printed; two to three times as stiff in an impact", _young(30, 70, _MPA), 0.45,
        _range(0.2, 0.5, "from memory; measured: 0.19 to 0.22 of a whole frame"),
        _range(0.5, 0.9),
    ),
    "eps": Material(
        "expanded polystyrene of 15 to 29 kg/m³; crushes for good",
        _young(2.5, 7.5, _MPA, "derived: stress at 1 % strain of manufacturers' tables"), None,
        _range(0.2, 0.4), _range(0.4, 0.6),
    ),
    "epp": Material("expanded polypropylene; recovers", None, None, _range(0.4, 0.6),
                    _range(0.4, 0.6)),
    "pu-foam": Material(
        "soft foam, a gym mat", _young(50, 200, _KPA), None,
        _range(0.3, 0.65, "from memory; measured: 0.603 of a guarded robot at 1.85 m/s"),
        _range(0.6, 0.9),
    ),
    "rubber": Material("natural or synthetic", _young(2, 10, _MPA), 0.49, _range(0.6, 0.8),
                       _range(0.7, 1.0)),
    "net": Material("net, curtain, foliage; damping from air and friction", None, None,
                    _range(0.0, 0.1), _range(0.25, 0.35)),
}  # fmt: skip
