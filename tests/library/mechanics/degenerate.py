"""Symmetric and degenerate scenes, which random numbers never hit, and random generic ones.

Everything follows from a seed. A scene and its push are a triple (scene, angle, magnitude); arrays of them
share one support, so that one call solves them.
"""

from __future__ import annotations

import math

import numpy as np

import planar_pushing as pp

LENGTHS = (0.0, 0.5, 1.0, 2.0, 3.0, 10.0, 100.0)
#: An edge of the cone of mu = 1 is along a rod at 45 or 135 degrees.
ROD_ANGLES = (math.pi / 4, math.pi / 2, 3 * math.pi / 4)
LAWS = (
    pp.Coulomb(0.0), pp.Coulomb(0.5), pp.Coulomb(1.0), pp.Coulomb(2.0),
    pp.InfiniteFriction(), pp.InfiniteFriction("none"), pp.PerfectlyRough(),
)  # fmt: skip
#: Along the fence and its normal.
PUSHES = (0.0, math.pi / 2, math.pi, -math.pi / 2, -math.pi)
#: Powers of ten by which a push is beside one of these.
BESIDE = (-14, -4)
RATIOS = (0.5, 1.0, 2.0)
SQUARE = ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0))
#: Supports without feet that have an axis of symmetry.
SYMMETRIC = {
    "ring": pp.Ring(1.0),
    "disc": pp.Disc(1.0),
    "disc aside": pp.Disc(0.5, (0.0, 1.0)),
    "square": pp.Polygon(SQUARE),
    "segment along": pp.Segment((-1.0, 0.0), (1.0, 0.0)),
    "segment across": pp.Segment((0.0, -1.0), (0.0, 1.0)),
    "map": pp.PressureMap((-1.0, 0.0, 1.0), (-1.0, 0.0, 1.0), ((1.0, 2.0), (1.0, 2.0))),
}
EFFECTS = ("friction", "inertia", "both")


# --- Supports ------------------------------------------------------------------------------------


def regular(count, phase=0.0):
    """Places at equal angles on the unit circle."""
    angles = phase + 2 * np.pi * np.arange(count) / count
    return np.column_stack([np.cos(angles), np.sin(angles)])


def normal_of(psi):
    """The fence's normal in the body frame; exactly along the rod where that is upright."""
    upright = np.asarray(psi) == math.pi / 2
    return np.where(upright, 1.0, np.sin(psi)), np.where(upright, 0.0, np.cos(psi))


def from_contact(length, psi, along, up):
    """Places in the body frame by their distances from the contact along the fence and above it."""
    n_x, n_y = normal_of(psi)
    along, up = np.asarray(along), np.asarray(up)
    return np.stack([up * n_x + along * n_y - length, up * n_y - along * n_x], axis=-1)


def symmetric_feet(random):
    """Equal feet at right angles, on regular polygons and on a line, their weights equal or whole."""
    count = random.choice([2, 3, 4, 6])
    places = [
        np.array(SQUARE),
        np.array(SQUARE) * (2.0, 1.0),
        regular(count),
        regular(count, np.pi / count),
        np.column_stack([np.arange(-1.0, 2.0), np.zeros(3)]),
        np.column_stack([np.zeros(3), np.arange(-1.0, 2.0)]),
        np.array([(-1.0, 0.0), (-1.0, 1.0), (-1.0, -1.0)]),
    ][random.integers(7)]
    return _points(random, places)


def feet_of_contact(random, length, psi):
    """Feet on the contact's normal, on its tangent, at the contact, and astride of the normal."""
    up = random.choice([0.0, 0.5, 1.0, 2.0, length], 2)
    feet = [
        ([0.0, 1.0, -1.0], [up[0], up[1], up[1]]),
        ([0.0, 0.0, 1.0], [1.0, 3.0, up[0]]),
        ([1.0, 2.0, -1.0], [0.0, 0.0, up[0] + 1.0]),
        ([0.0, 1.0, 0.0], [0.0, 1.0, 2.0]),
        ([0.0, 1.0], [0.0, up[0]]),
        ([0.0, 0.0], [0.5, 2.0]),
        ([-1.0, 2.0], [0.0, 0.0]),
    ][random.integers(7)]
    return _points(random, from_contact(length, psi, *feet))


def _points(random, places):
    weights = [np.ones(len(places)), random.integers(1, 4, len(places))][random.integers(2)]
    return pp.Points(places, weights)


def random_support(random, kind=None):
    """A support without symmetry, within some two units of the slider's origin."""
    kind = kind or random.choice(list(RANDOM))
    return RANDOM[kind](random)


def _scattered(random):
    count = random.integers(2, 6)
    return pp.Points(random.normal(size=(count, 2)), random.uniform(0.2, 1.0, count))


def _corners(random):
    """A polygon that is star-shaped about a place of its own."""
    angles = np.sort(random.uniform(0, 2 * np.pi, 5)) + 0.3 * np.arange(5)
    angles *= 2 * np.pi / (2 * np.pi + 1.5)
    rays = random.uniform(0.4, 1.5, 5)
    places = rays[:, None] * np.column_stack([np.cos(angles), np.sin(angles)])
    return pp.Polygon(places + 0.3 * random.normal(size=2))


RANDOM = {
    "points": _scattered,
    "segment": lambda r: pp.Segment(r.normal(size=2), r.normal(size=2)),
    "ring": lambda r: pp.Ring(r.uniform(0.3, 2.0)),
    "disc": lambda r: pp.Disc(r.uniform(0.3, 2.0), 0.5 * r.normal(size=2)),
    "annulus": lambda r: pp.Annulus(r.uniform(0.2, 0.7), 1.0, 0.5 * r.normal(size=2)),
    "polygon": _corners,
    "map": lambda r: pp.PressureMap(
        np.cumsum(r.uniform(0.2, 1.0, 4)) - 1.5, np.cumsum(r.uniform(0.2, 1.0, 3)) - 1.0,
        r.uniform(0, 1, (2, 3)),
    ),
    "composite": lambda r: pp.Composite(
        [(r.uniform(0.2, 1), pp.Disc(0.5, r.normal(size=2))), (1.0, pp.Points([r.normal(size=2)], [1]))]
    ),
}  # fmt: skip


# --- Scenes and pushes ---------------------------------------------------------------------------


def degenerate_arrays(seed, support, effects, count):
    """Arrays of scenes of one support, and their pushes."""
    random = np.random.default_rng(seed)
    length, psi = _rods(random, count)
    return _arrays(random, support, effects, length, psi)


def degenerate(seed, count, effects="both", kind="feet"):
    """Single scenes with their pushes, of feet or of one of `SYMMETRIC`."""
    random = np.random.default_rng(seed)
    for _ in range(count):
        length, psi = (each.item() for each in _rods(random, 1))
        support = SYMMETRIC.get(kind)
        if support is None and random.random() < 0.5:
            support = symmetric_feet(random)
        elif support is None:
            support = feet_of_contact(random, length, psi)
        yield _single(*_arrays(random, support, effects, np.array([length]), np.array([psi])))


def generic_arrays(seed, support, effects, count):
    """Arrays of scenes without any symmetry, and their pushes, half of them nearly along the fence."""
    random = np.random.default_rng(seed)
    ratio, aside = _spread(random, -1, 1, count), 0.3 * random.normal(size=(2, count))
    mass = pp.Inertia(
        mass=_spread(random, -1, 1, count), gyration_radius=ratio, center=tuple(aside)
    )
    friction = pp.SupportFriction(support=support, weight=_spread(random, -1, 1, count))
    slider = pp.Slider(
        rod_length=_spread(random, -1, 1.5, count), rod_angle=random.uniform(0.1, 3.0, count), radius=1.0
    )  # fmt: skip
    mu = _spread(random, -1, 0.5, count)
    laws = [pp.Coulomb(each) if each < 2 else LAWS[4 + i % 3] for i, each in enumerate(mu)]
    angle = random.uniform(-np.pi, np.pi, count)
    along = random.choice([0.0, np.pi], count) - _spread(random, -3, -0.5, count)
    angle = np.where(random.random(count) < 0.5, angle, along)
    scene = pp.Scene(
        slider=slider, contact=np.array(laws, dtype=object),
        effects=_chosen(effects, friction, mass),
    )  # fmt: skip
    return scene, angle, _spread(random, -3, 3, count)


def _spread(random, low, high, count):
    return 10 ** random.uniform(low, high, count)


def _some(random, values, others):
    """For most entries one of some values, for the rest what is given."""
    return np.where(random.random(len(others)) < 0.8, random.choice(values, len(others)), others)


def _rods(random, count):
    length = _some(random, LENGTHS, _spread(random, -1, 1, count))
    return length, _some(random, ROD_ANGLES, random.uniform(0.1, 3.0, count))


def _chosen(effects, friction, mass):
    return {"friction": (friction,), "inertia": (mass,), "both": (friction, mass)}[effects]


def _arrays(random, support, effects, length, psi):
    count = len(length)
    laws = np.array([LAWS[i] for i in random.integers(len(LAWS), size=count)], dtype=object)
    weight = _some(random, [1.0], _spread(random, -1, 1, count))
    mass = pp.Inertia(
        mass=_some(random, [1.0], _spread(random, -3, 3, count)),
        gyration_radius=_some(random, RATIOS, _spread(random, -1, 1, count)),
        center=mass_centers(random, length, psi),
    )
    friction = pp.SupportFriction(support=support, weight=weight)
    slider = pp.Slider(rod_length=length, rod_angle=psi)
    scene = pp.Scene(slider=slider, contact=laws, effects=_chosen(effects, friction, mass))
    return scene, pushes(random, count), 10.0 ** random.integers(-3, 4, count)


def mass_centers(random, length, psi):
    """At the origin, on the rod's line, on the contact's normal, at the contact, and off all of these."""
    count = len(length)
    up = random.choice([0.0, 0.5, 1.0, 2.0], count)
    places = np.stack([
        np.zeros((count, 2)),
        np.column_stack([random.choice([-0.5, 0.5], count), np.zeros(count)]),
        from_contact(length, psi, np.zeros(count), up),
        np.column_stack([np.zeros(count), random.choice([-0.5, 0.5], count)]),
        0.3 * random.normal(size=(count, 2)),
    ])  # fmt: skip
    return tuple(places[random.integers(len(places), size=count), np.arange(count)].T)


def pushes(random, count):
    """Angles along the fence and its normal, exactly, one ulp beside and up to 1e-4 beside, and others."""
    angle = _some(random, PUSHES, random.uniform(-np.pi, np.pi, count))
    side, kind = random.choice([-1.0, 1.0], count), random.integers(3, size=count)
    ulp = np.where(angle == 0, angle, np.nextafter(angle, side * 9.0))
    beside = angle + side * 10.0 ** random.integers(BESIDE[0], BESIDE[1] + 1, count)
    return np.select([kind == 0, kind == 1], [angle, ulp], beside)


def _single(scene, angle, magnitude):
    """The scene of arrays with one entry."""
    law, slider = scene.contact[0], scene.slider
    effects = tuple(_entry(each) for each in scene.effects)
    slider = pp.Slider(rod_length=slider.rod_length.item(), rod_angle=slider.rod_angle.item())
    return pp.Scene(slider=slider, contact=law, effects=effects), angle.item(), magnitude.item()


def _entry(effect):
    if isinstance(effect, pp.SupportFriction):
        return pp.SupportFriction(support=effect.support, weight=effect.weight.item())
    return pp.Inertia(
        mass=effect.mass.item(), gyration_radius=effect.gyration_radius.item(),
        center=tuple(each.item() for each in effect.center),
    )  # fmt: skip
