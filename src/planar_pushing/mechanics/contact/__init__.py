"""Contact laws, contact modes, and outcomes."""

from planar_pushing.mechanics.contact.laws import (
    ContactLaw,
    Coulomb,
    InfiniteFriction,
    PerfectlyRough,
)
from planar_pushing.mechanics.status import ContactMode, Outcome, Status

__all__ = [
    "ContactLaw",
    "ContactMode",
    "Coulomb",
    "InfiniteFriction",
    "Outcome",
    "PerfectlyRough",
    "Status",
]
