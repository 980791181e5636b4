"""The checks, by theme; importing the package registers them all."""

from planar_pushing.claims.checks import formulas, limit_curves, velocity_cones

__all__ = ["formulas", "limit_curves", "velocity_cones"]
