"""Checks of the library itself, by its mechanics at points; importing the package registers them."""

from planar_pushing.evidence.claims.samples import random_pushes as random_pushes
