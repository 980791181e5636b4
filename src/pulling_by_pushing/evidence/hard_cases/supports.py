"""Hard cases of supports, lines 8 to 12 of the table: feet, edges, rims, segments, thin shapes."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

import numpy as np
from flint import fmpq

from planar_pushing.mechanics.contact import PerfectlyRough
from planar_pushing.mechanics.effects import SupportFriction
from planar_pushing.mechanics.force.cones import motion_angle
from planar_pushing.mechanics.force.force_motion import motion_of_force
from planar_pushing.mechanics.force.wrench import potential, wrench
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.slider import Slider
from planar_pushing.mechanics.supports import SHAPES
from pulling_by_pushing.evidence.hard_cases import references
from pulling_by_pushing.evidence.hard_cases.case import PSI, QUARTER, Case, Function, spin_of_stick
from pulling_by_pushing.evidence.hard_cases.references import direction, slider
from pulling_by_pushing.oracle.balls import Number
from pulling_by_pushing.oracle.shapes import SupportEntry

#: Feet of a tripod; the first one is on the rod's line.
FEET = ((1.0, 0.0), (-0.5, 0.75), (-0.5, -0.875))
SUPPORTS: dict[str, SupportEntry] = {
    "tripod": {"shape": "points", "positions": FEET, "weights": (1.0, 1.0, 1.0)},
    "heavy foot": {"shape": "points", "positions": FEET, "weights": (1.0, 1e-9, 1e-9)},
    "quadruped": {
        "shape": "points",
        "positions": ((1.0, 0.5), (-1.0, 0.5), (-1.0, -0.5), (1.0, -0.5)),
        "weights": (4.0, 3.0, 2.0, 1.0),
    },
    "plate": {"shape": "polygon", "vertices": ((-1.0, -0.5), (1.0, -0.5), (1.0, 0.5), (-1.0, 0.5))},
    "triangle": {"shape": "polygon", "vertices": ((-1.0, -0.75), (1.0, -0.5), (0.25, 1.0))},
    "thin plate": {
        "shape": "polygon",
        "vertices": ((-1.0, -1e-6), (1.0, -1e-6), (1.0, 1e-6), (-1.0, 1e-6)),
    },
    "disc": {"shape": "disc", "radius": 1.0, "center": (0.25, 0.5)},
    "annulus": {"shape": "annulus", "inner": 0.5, "outer": 1.0},
    "thin annulus": {"shape": "annulus", "inner": 0.999, "outer": 1.0},
    "ring": {"shape": "ring", "radius": 1.0, "center": (0.25, 0.5)},
    "segment": {"shape": "segment", "start": (-1.0, 0.0), "end": (1.0, 0.0)},
    "skew segment": {"shape": "segment", "start": (-0.75, -0.5), "end": (0.5, 1.0)},
}
UP = 1 + 2.0**-52
BOTH = ("motion_angle", "force")
ALL = ("mean_distance", "force", "torque")
#: Line, support, center of rotation with its name, and quantities.
CENTERS: tuple[tuple[int, str, str, tuple[float, float], tuple[str, ...]], ...] = (
    (8, "tripod", "at a foot", (1.0, 0.0), ALL),
    (8, "tripod", "1e-12 beside a foot", (1 + 1e-12, 0.0), ALL),
    (8, "heavy foot", "at the foot", (1.0, 0.0), ALL[:1]),
    (8, "heavy foot", "1e-8 beside the foot", (1.0, 1e-8), ALL),
    (8, "quadruped", "1e-12 beside a foot", (-1.0, 0.5 - 1e-12), ALL[1:]),
    (9, "plate", "on an edge", (0.25, 0.5), ALL),
    (9, "plate", "in a corner", (1.0, 0.5), ALL),
    (9, "plate", "on the line of an edge", (3.0, 0.5), ("torque",)),
    (9, "plate", "far away", (1e8, 3e7), ALL),
    (9, "triangle", "an ulp off an edge", (0.0, -0.625 * UP), ALL),
    (9, "triangle", "in a corner", (0.25, 1.0), ("torque",)),
    (10, "disc", "on the rim", (1.25, 0.5), ALL),
    (10, "disc", "an ulp off the rim", (1.25 * UP, 0.5), ALL),
    (10, "annulus", "on the inner rim", (0.5, 0.0), ALL),
    (10, "ring", "on it", (1.25, 0.5), ALL),
    (10, "ring", "an ulp off it", (1.25 * UP, 0.5), ALL),
    (11, "segment", "on it", (0.25, 0.0), ALL),
    (11, "segment", "1e-300 off it", (0.25, 1e-300), ("force",)),
    (11, "segment", "at its end", (1.0, 0.0), ("force",)),
    (11, "skew segment", "an ulp off it", (-0.125 * UP, 0.25), ALL),
    (11, "skew segment", "at its end", (0.5, 1.0), ("torque",)),
    (11, "skew segment", "far along it", (5e7, 6e7), ("torque",)),
    (12, "thin plate", "inside", (-0.125, 0.0), ALL),
    (12, "thin plate", "beside it", (-0.125, 4e-6), ALL),
    (12, "thin annulus", "between its rims", (0.9995, 0.0), ALL),
)
#: Line, support, name, length and angle of the rod with the angle of force or pusher, and quantities.
MOTIONS: tuple[tuple[int, str, str, tuple[float, float, float], tuple[str, ...]], ...] = (
    (8, "tripod", "barely a pivot", (2.0, PSI, 1.7872294552924546), BOTH),
    (8, "tripod", "barely no pivot", (2.0, PSI, 1.7872294551824546), BOTH),
    (8, "heavy foot", "a pivot", (2.0, PSI, 2.0), BOTH),
    (8, "heavy foot", "pusher across the rod", (2.0, QUARTER, 0.0), ("spin_ratio",)),
    (8, "heavy foot", "pusher 1e-9 off", (2.0, QUARTER, 1e-9), ("spin_ratio",)),
    (9, "plate", "force 1e-9 off the rod", (2.0, PSI, PSI + 1e-9), ("motion_angle",)),
    (9, "plate", "contact on its edge", (1.0, PSI, 0.2), ("motion_angle",)),
    (9, "triangle", "rod of 1e4", (1e4, PSI, 0.2), ("motion_angle",)),
    (10, "disc", "contact on its rim", (0.75, PSI, 0.2), ("motion_angle",)),
    (10, "annulus", "contact on its rim", (1.0, PSI, 0.2), ("motion_angle",)),
    (11, "segment", "contact at its end", (1.0, PSI, 0.2), ("motion_angle",)),
    (11, "segment", "contact on it, pusher across", (0.5, QUARTER, 0.0), ("spin_ratio",)),
    (11, "segment", "pusher across", (2.0, QUARTER, 0.0), ("spin_ratio",)),
    (11, "segment", "pusher 1e-9 off", (2.0, QUARTER, 1e-9), ("spin_ratio",)),
    (11, "segment", "force 1e-6 off across", (2.0, QUARTER, 1e-6), ("motion_angle",)),
    (11, "segment", "force 1e-9 off along", (2.0, PSI, PSI + 1e-9), ("motion_angle",)),
    (11, "skew segment", "pusher off the rod", (2.0, PSI, 0.2), ("spin_ratio",)),
    (12, "thin plate", "contact at its end", (1.0, PSI, 0.2), BOTH),
    (12, "thin plate", "pusher across", (2.0, QUARTER, 0.0), ("spin_ratio",)),
    (12, "thin annulus", "contact on its rim", (1.0, PSI, 0.2), BOTH),
)


def _effect(entry: SupportEntry) -> SupportFriction:
    shape = {key: value for key, value in entry.items() if key != "shape"}
    return SupportFriction(support=SHAPES[entry["shape"]](**shape))


def _rotation(part: int, entry: SupportEntry, x: float, y: float) -> float:
    effect, twist = _effect(entry), [y, -x, 1.0]
    if part == 0:
        return float(potential(effect, twist))
    f_x, f_y, torque = wrench(effect, twist)
    return float(np.hypot(f_x, f_y) if part == 1 else torque)


def _scene(entry: SupportEntry, length: float, psi: float) -> Scene:
    rod = Slider(rod_length=length, rod_angle=psi, radius=1.0)
    return Scene(slider=rod, contact=PerfectlyRough(), effects=(_effect(entry),))


def _push(quantity: str, entry: SupportEntry, length: float, psi: float, angle: float) -> float:
    scene = _scene(entry, length, psi)
    if quantity == "spin_ratio":
        return spin_of_stick(scene, angle)
    if quantity == "force":
        return float(np.hypot(*motion_of_force(scene, angle).force))
    return float(motion_angle(scene, angle))


#: Which motion a quantity describes, and how.
ROUTES: dict[str, tuple[Callable[..., Number], references.Measure]] = {
    "motion_angle": (references.under_force, references.turn),
    "force": (references.under_force, references.force_size),
    "spin_ratio": (references.sticking_value, references.spin),
}


def _exact_push(quantity: str, entry: SupportEntry, length: fmpq, psi: fmpq, angle: fmpq) -> Number:
    motion, measure = ROUTES[quantity]
    return motion(measure, slider(length, psi, 0.0, entry=entry), direction(angle))


def rotations() -> Iterator[Case]:
    """Cases of rotations about centers."""
    for line, name, center_name, center, quantities in CENTERS:
        for quantity in quantities:
            part, entry = ALL.index(quantity), SUPPORTS[name]
            routes = partial(_rotation, part, entry), partial(references.rotation, part, entry)
            label = f"{quantity.replace('_', ' ')}, {name}, center {center_name}"
            yield Case(label, line, Function(quantity, *routes), center)


def motions() -> Iterator[Case]:
    """Cases of motions under a force or a pusher."""
    for line, name, push, rod, quantities in MOTIONS:
        for quantity in quantities:
            entry = SUPPORTS[name]
            routes = partial(_push, quantity, entry), partial(_exact_push, quantity, entry)
            label = f"{quantity.replace('_', ' ')}, {name}, {push}"
            yield Case(label, line, Function(quantity, *routes), rod)
