"""Random objects, and the way back from a push to its twist."""

from __future__ import annotations

import warnings

import numpy as np

import planar_pushing as pp

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]


def error(push, effects, twist):
    """Distance of the twist from the nearest solution of the push, relative to its size."""
    law = pp.Coulomb(1.01 * push.friction_coefficient + 1e-9)
    # A rotation can need more friction than any contact has.
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "friction_coefficient", pp.SceneWarning)
        scene = pp.scene_at(push.point, push.normal, effects=effects, contact=law)
    x, y = scene.to_fence(push.velocity, "vector")
    found = [
        np.abs(scene.to_object(each.twist, "twist") - twist).max()
        for each in pp.solve(scene, np.arctan2(y, x), np.hypot(x, y))
    ]
    return min(found) / np.abs(twist).max()


def star(rng, count=7, size=1.0, at=(0.0, 0.0)):
    """Corners of a star-shaped polygon, clockwise or not."""
    angles = np.linspace(0, 2 * np.pi, count, endpoint=False) + rng.uniform(0, 0.6, count)
    away = size * rng.uniform(0.4, 1.3, count)
    corners = np.column_stack([away * np.cos(angles), away * np.sin(angles)]) + at
    return corners[:: rng.choice([1, -1])]


def support(rng, kind, at=(0.0, 0.0)):
    """A random support."""
    at = np.array(at)
    if kind == "points":
        return pp.Points(rng.normal(size=(4, 2)) + at, rng.uniform(0.2, 1, 4))
    if kind == "polygon":
        return pp.Polygon(star(rng, 5, 0.8, at))
    if kind == "disc":
        return pp.Disc(rng.uniform(0.3, 1), tuple(at))
    members = [(1.0, support(rng, "points", at)), (2.0, support(rng, "disc", at))]
    return pp.Composite(members)
