"""Random pushes of shapes with arcs and corners: no pusher is ever inside the object.

The distance is an own one. It comes from the drawn shape, without chains, pieces, or contacts: a polygon
that is shrunk by the radius of its rounded corners, a circle, or the parameter of an ellipse.
"""

from __future__ import annotations

import numpy as np
import pytest
from simulation.runs import run
from simulation.scenes import METHODS

import planar_pushing as pp

#: Random finger radii and supports are not those of real objects.
pytestmark = [
    pytest.mark.filterwarnings("ignore::planar_pushing.SceneWarning"),
]
TEE = np.array([(-0.6, 0), (-0.6, -0.3), (-0.15, -0.3), (-0.15, -1.2), (0.15, -1.2), (0.15, -0.3),
                (0.6, -0.3), (0.6, 0)])  # fmt: skip


def distance_to_polygon(point, corners):
    """Distance of a point (complex) from a polygon, negative inside, by the sum of angles."""
    start = corners - point
    end = np.roll(start, -1)
    part = np.clip(-(start / (end - start)).real, 0.0, 1.0)
    nearest = np.abs(start + part * (end - start)).min()
    around = np.angle(end / start).sum() if np.abs(start).min() > 0 else 0.0
    return -nearest if abs(around) > 3.0 else nearest


class Drawn:
    """A polygon whose convex corners are rounded: it is a smaller polygon, grown by the radius.

    With the radius 0 it is any polygon.
    """

    def __init__(self, corners, radius=0.0):
        self.radius, self.size = radius, np.ptp(corners, axis=0).max()
        self.outline = pp.rounded(corners, radius) if radius else pp.Outline(corners)
        self.support = pp.Polygon(corners)
        corners = corners @ (1, 1j)
        before, after = corners - np.roll(corners, 1), np.roll(corners, -1) - corners
        before, after = before / np.abs(before), after / np.abs(after)
        # The sides move inward by the radius; i u is inward of a side along u.
        half = np.angle(after / before) / 2
        self.corners = corners + radius * (1j * (before + after) / 2) / np.cos(half) ** 2

    def distance(self, point):
        return distance_to_polygon(point, self.corners) - self.radius

    def lowest(self, normal):
        """Smallest component along a normal."""
        return (self.corners / normal).real.min() - self.radius

    def place(self, random):
        """A point of a side, with its inward normal."""
        i = random.integers(len(self.corners))
        start, end = self.corners[i], self.corners[(i + 1) % len(self.corners)]
        inward = 1j * (end - start) / abs(end - start)
        return start + random.uniform(0.02, 0.98) * (end - start) - self.radius * inward, inward

    def lowest_point(self, normal):
        """A point at which a fence with this normal touches."""
        corner = self.corners[(self.corners / normal).real.argmin()]
        return corner - self.radius * normal


class Round(Drawn):
    """A disc."""

    size = 2.0

    def __init__(self):
        self.outline = self.support = pp.Disc(1.0)

    def distance(self, point):
        return abs(point) - 1.0

    def lowest(self, normal):
        return -1.0

    def place(self, random):
        normal = np.exp(1j * random.uniform(0, 2 * np.pi))
        return -normal, normal

    def lowest_point(self, normal):
        return -normal


def shape_of(random):
    """A random shape."""
    kind = random.integers(5)
    if kind == 0:
        return Drawn(TEE)
    if kind == 1:
        return Round()
    if kind == 2:
        box = np.array([(-1, -0.6), (1, -0.6), (1, 0.6), (-1, 0.6)])
        return Drawn(box, float(random.uniform(0.05, 0.5)))
    count = int(random.integers(3, 9))
    angles = 2 * np.pi * (np.arange(count) + random.uniform(-0.3, 0.3, count)) / count
    corners = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    return Drawn(corners, float(random.uniform(0.01, 0.05)) if kind == 3 else 0.0)


def poses(log):
    """Instants, and positions and rotations of the object as complex numbers."""
    position = log.object_position.values @ (1, 1j)
    return zip(
        log.time.values, position, np.exp(1j * np.deg2rad(log.object_angle.values)), strict=True
    )


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(60))
@pytest.mark.parametrize("massive", [False, True], ids=["friction", "both"])
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("shape", ["finger", "fence"])
def test_no_pusher_is_ever_inside_a_shape(shape, method, massive, seed):
    random = np.random.default_rng(seed)
    drawn, radius = shape_of(random), float(random.choice([0.0, 0.05, 0.2])) * (shape == "finger")
    if shape == "finger":
        point, normal = drawn.place(random)
        center = point - radius * normal
        if drawn.distance(center) < radius - 1e-9:
            pytest.skip("the finger begins in another side")
    else:
        normal = np.exp(1j * random.uniform(0, 2 * np.pi))
        point = drawn.lowest_point(normal)
    along = random.uniform(-1, 1) * -1j + random.uniform(0.2, 1)
    velocity = along * normal
    effects = (pp.SupportFriction(support=drawn.support),)
    if massive:
        effects += (pp.Inertia(mass=float(random.uniform(0.3, 3)), gyration_radius=0.5),)
    law = pp.Coulomb(float(random.choice([0.0, 0.1, 0.4, 1.0])))
    scene = pp.scene_at(
        (point.real, point.imag), (normal.real, normal.imag), effects=effects, contact=law,
        outline=drawn.outline,
    )  # fmt: skip
    given = {"shape": "finger", "radius": radius} if shape == "finger" else {}
    pusher = pp.Pusher(velocity=(velocity.real, velocity.imag), frame="world", **given)
    exact, step = method == "event-driven", 2e-3
    log = run(
        scene, pusher, float(random.uniform(0.5, 2.5)), object_pose=(0, 0, 0), method=method,
        **({} if exact else {"step": step}),
    )  # fmt: skip
    # A run ends where the overlap is a billionth of the size.
    allowed = (1.000001e-9 if exact else 2 * step) * drawn.size
    closest = np.inf
    for time, position, turn in poses(log):
        if shape == "finger":
            height = drawn.distance((center + time * velocity - position) / turn) - radius
        else:
            own = drawn.lowest(normal / turn) + (position / normal).real
            height = own - (point / normal).real - time * (velocity / normal).real
        assert height > -allowed
        closest = min(closest, abs(height))
    # Every run begins in contact: the own distance is 0 there.
    assert closest < 1e-9
