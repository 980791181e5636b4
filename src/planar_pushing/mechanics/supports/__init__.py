"""Supports: the pressure of the slider on the plane, one file per kind of support."""

from planar_pushing.mechanics.pressure.support_in_frames import KINDS
from planar_pushing.mechanics.supports.annulus import Annulus
from planar_pushing.mechanics.supports.composite import Composite
from planar_pushing.mechanics.supports.disc import Disc
from planar_pushing.mechanics.supports.ellipsoid import EllipsoidFit, fit_ellipsoid
from planar_pushing.mechanics.supports.even_ring import Ring
from planar_pushing.mechanics.supports.points import Points
from planar_pushing.mechanics.supports.polygon import Polygon
from planar_pushing.mechanics.supports.pressure_map import PressureMap
from planar_pushing.mechanics.supports.segment import Segment

#: Supports by their shape in scene files.
SHAPES = {
    "ring": Ring,
    "points": Points,
    "segment": Segment,
    "disc": Disc,
    "annulus": Annulus,
    "polygon": Polygon,
    "pressure_map": PressureMap,
    "composite": Composite,
}
KINDS.update(SHAPES.values())

__all__ = [
    "SHAPES",
    "Annulus",
    "Composite",
    "Disc",
    "EllipsoidFit",
    "Points",
    "Polygon",
    "PressureMap",
    "Ring",
    "Segment",
    "fit_ellipsoid",
]
