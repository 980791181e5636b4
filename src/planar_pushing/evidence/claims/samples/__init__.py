"""Checks of the library itself, at points, by its mechanics; importing the package registers them."""

from planar_pushing.evidence.claims.samples import random_pushes as random_pushes
