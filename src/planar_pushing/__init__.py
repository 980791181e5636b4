"""Planar pushing: pulling by pushing, slip with infinite friction, and the mechanics behind them."""

from planar_pushing.mechanics.angles import AngleInterval
from planar_pushing.mechanics.centers import conservative_motion_cone, motion_centers
from planar_pushing.mechanics.cones import (
    can_pull,
    friction_cone,
    motion_angle,
    motion_cone,
    slips_while_pushing,
    spin_ratio,
)
from planar_pushing.mechanics.contact import (
    ContactMode,
    Coulomb,
    InfiniteFriction,
    Outcome,
    PerfectlyRough,
)
from planar_pushing.mechanics.effects import Inertia, RingFriction
from planar_pushing.mechanics.errors import InvalidFile, InvalidValue, PlanarPushingError
from planar_pushing.mechanics.limit_curve import LimitCurve, limit_curve
from planar_pushing.mechanics.scene import Scene, Slider
from planar_pushing.mechanics.solve import Solution, Solutions, solve

__all__ = [
    "AngleInterval",
    "ContactMode",
    "Coulomb",
    "Inertia",
    "InfiniteFriction",
    "InvalidFile",
    "InvalidValue",
    "LimitCurve",
    "Outcome",
    "PerfectlyRough",
    "PlanarPushingError",
    "RingFriction",
    "Scene",
    "Slider",
    "Solution",
    "Solutions",
    "can_pull",
    "conservative_motion_cone",
    "friction_cone",
    "limit_curve",
    "motion_angle",
    "motion_centers",
    "motion_cone",
    "slips_while_pushing",
    "solve",
    "spin_ratio",
]
