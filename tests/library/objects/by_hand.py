"""From an object's frame to a scene and back, written down once more, and random objects."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

import planar_pushing as pp

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]


def moved(support, move):
    """A support whose positions are moved."""
    if isinstance(support, pp.Points):
        return pp.Points([move(each) for each in support.positions], support.weights)
    if isinstance(support, pp.Polygon):
        return pp.Polygon([move(each) for each in support.vertices])
    if isinstance(support, pp.Composite):
        return pp.Composite([(share, moved(each, move)) for share, each in support.members])
    return replace(support, center=move(support.center))


def center(effects):
    """The center of pressure of the first support, or the center of mass."""
    supports = [each.support for each in effects if hasattr(each, "support")]
    return np.array(supports[0].center_of_pressure if supports else effects[0].center)


class Placed:
    """A push on an object as a scene: the fence's x and y, the slider's center, the body's x."""

    def __init__(self, push):
        n = push.normal
        self.push, self.fence = push, np.array([[n[1], -n[0]], n])

    def scene(self, effects, law):
        point, middle = self.push.point, center(effects)
        if self.fence[1] @ (middle - point) <= 1e-3:
            middle = point + self.push.normal
        across, up = self.fence @ (middle - point)
        self.middle, length = middle, np.hypot(across, up)
        x = (middle - point) / length
        body = np.array([x, [-x[1], x[0]]])

        def move(place):
            return tuple(body @ (np.array(place) - middle))

        turned = tuple(self._turned(each, move, effects) for each in effects)
        slider = pp.Slider(rod_length=length, rod_angle=np.arctan2(up, across))
        return pp.Scene(slider=slider, contact=law, effects=turned)

    def _turned(self, effect, move, effects):
        if isinstance(effect, pp.Load):
            place = center(effects) if effect.center is None else effect.center
            return pp.Load(force=tuple(self.fence @ effect.force), center=move(place))
        if isinstance(effect, pp.Inertia):
            return replace(effect, center=move(effect.center))
        return replace(effect, support=moved(effect.support, move))

    def solutions(self, effects, law):
        """Twists of the object's frame under the push."""
        scene = self.scene(effects, law)
        x, y = self.fence @ self.push.velocity
        for each in pp.solve(scene, np.arctan2(y, x), np.hypot(x, y)):
            v_x, v_y = self.fence.T @ each.twist[:2]
            omega = each.twist[2]
            yield np.array([v_x + omega * self.middle[1], v_y - omega * self.middle[0], omega])


def error(push, effects, twist):
    """Distance of the twist from the nearest solution, relative to its size."""
    law = pp.Coulomb(1.01 * push.friction_coefficient + 1e-9)
    found = [np.abs(each - twist).max() for each in Placed(push).solutions(effects, law)]
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
