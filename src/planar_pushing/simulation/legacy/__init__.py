"""Formulas of the mechanics as the simulation compiles them, apart from those of the mechanics."""

from planar_pushing.simulation.legacy import any_support, base, load, mass, own_ring

base.KINDS.update(
    {
        mass.Mass: mass,
        own_ring.RingSupport: own_ring,
        any_support.Support: any_support,
        any_support.Supports: any_support,
        load.Wrench: load,
    }
)
