"""The checks, by theme; importing the package registers them all."""

from planar_pushing.evidence.claims.checks import (
    acceleration_centers,
    contact_laws,
    dynamics,
    findings,
    formulas,
    infinite_friction,
    limit_curves,
    velocity_cones,
)

__all__ = [
    "acceleration_centers",
    "contact_laws",
    "dynamics",
    "findings",
    "formulas",
    "infinite_friction",
    "limit_curves",
    "velocity_cones",
]
