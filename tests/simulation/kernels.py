"""A kernel that tests compile in seconds."""

from planar_pushing.simulation.legacy.base import resistance
from planar_pushing.simulation.legacy.compiled import compiled, kernel


@kernel
@compiled
def force(effects, x, y, spin):
    """Component of the force along x that sustains a twist."""
    return resistance(effects, x, y, spin, 0.0).f_x
