"""Several supports of one slider are one composite support: solutions, cones, curves, and derivatives."""

from __future__ import annotations

import numpy as np
import pytest
from mechanics.degenerate import LAWS, random_support, regular

import planar_pushing as pp
from planar_pushing.mechanics.force.limit_curve import curve_of_unit_motions

COUNT = 25
RANDOM = np.random.default_rng(4)
FEET = pp.Points(regular(3), [1.0, 2.0, 3.0])
PAIRS = {
    "feet": (FEET, random_support(RANDOM, "points")),
    "feet and a polygon": (FEET, random_support(RANDOM, "polygon")),
    "a map and feet": (random_support(RANDOM, "map"), FEET),
    "a disc and a segment": (random_support(RANDOM, "disc"), random_support(RANDOM, "segment")),
    "feet on a line": (pp.Points([(0, 0.2), (0, 1)]), pp.Points([(0, -0.7), (0, -1)], [1, 2])),
}  # fmt: skip
OTHERS = {
    "friction": (),
    "inertia": (pp.Inertia(mass=2.0, gyration_radius=0.7, center=(0.1, 0.2)),),
    "load": (pp.Load(force=(0.2, -0.3), center=(0.2, 0.1)),),
}
EVERY_SCENE = [
    pytest.mark.parametrize("pair", PAIRS.values(), ids=PAIRS),
    pytest.mark.parametrize("others", OTHERS.values(), ids=OTHERS),
]
WEIGHTS = 1.3, 0.6


def every_scene(test):
    for mark in EVERY_SCENE:
        test = mark(test)
    return test


def scenes_of(pair, others):
    """The scene with two supports, and with their composite, for arrays of sliders and laws."""
    random = np.random.default_rng(5)
    slider = pp.Slider(
        rod_length=10 ** random.uniform(-1, 1, COUNT), rod_angle=random.uniform(0.2, 2.9, COUNT),
        radius=1.5,
    )  # fmt: skip
    laws = np.array([LAWS[i % len(LAWS)] for i in range(COUNT)], dtype=object)
    apart = [
        pp.SupportFriction(support=each, weight=w) for each, w in zip(pair, WEIGHTS, strict=True)
    ]
    whole = pp.Composite([*zip(WEIGHTS, pair, strict=True)])
    together = [pp.SupportFriction(support=whole, weight=sum(WEIGHTS))]
    return [
        pp.Scene(slider=slider, contact=laws, effects=[*friction, *others])
        for friction in (apart, together)
    ]


def same(one, other, tolerance=1e-9, least=1e-6):
    """Whether two arrays are the same to rounding, relative to their largest numbers."""
    scale = np.abs(other[np.isfinite(other)]).max(initial=least)
    return np.allclose(one, other, rtol=tolerance, atol=tolerance * scale, equal_nan=True)


@every_scene
def test_pushes(pair, others):
    angle = np.random.default_rng(6).uniform(-np.pi, np.pi, COUNT)
    one, other = (pp.solve(scene, angle) for scene in scenes_of(pair, others))
    for name in ("mode", "status", "pivot", "continuum"):
        assert np.array_equal(getattr(one, name), getattr(other, name))
    for name in ("force", "force_end", "twist", "contact_motion"):
        assert same(getattr(one, name), getattr(other, name))


@every_scene
def test_cones_and_motions_under_forces(pair, others):
    one, other = scenes_of(pair, others)
    cones = pp.motion_cone(one), pp.motion_cone(other)
    assert cones[0].right == pytest.approx(cones[1].right, abs=1e-9)
    assert cones[0].left == pytest.approx(cones[1].left, abs=1e-9)
    assert np.array_equal(cones[0].closed, cones[1].closed)
    assert np.array_equal(cones[0].status, cones[1].status)
    assert np.all(cones[0].left >= cones[0].right)
    more = (1.7,) if len({each.degree for each in one.effects}) == 2 else ()
    phi = np.random.default_rng(7).uniform(-np.pi, np.pi, COUNT)
    motions = [pp.motion_of_force(scene, phi, *more) for scene in (one, other)]
    assert np.array_equal(motions[0].pivot, motions[1].pivot)
    for name in ("status", "twist", "force", "contact_motion"):
        assert same(getattr(motions[0], name), getattr(motions[1], name))
    centers = [
        pp.motion_centers(scene, phi, force_ratio=more[0] if more else None)
        for scene in (one, other)
    ]
    assert same(*centers, tolerance=1e-6)  # the center of a near-translation is ill-conditioned
    curves = [curve_of_unit_motions(scene, phi) for scene in (one, other)]
    assert same(curves[0].magnitude, curves[1].magnitude)
    assert same(curves[0].motion_angle, curves[1].motion_angle)


@every_scene
def test_derivatives(pair, others):
    """The composite's weight is a change of both weights in proportion."""
    angle = np.random.default_rng(6).uniform(-np.pi, np.pi, COUNT)
    one, other = (
        pp.solve(scene, angle, derivatives=True).derivatives for scene in scenes_of(pair, others)
    )
    assert np.array_equal(one.status, other.status)
    for name in ("motion", "point", "mu", "foot"):
        for of in ("twist", "force"):
            field = f"{of}_by_{name}"
            assert same(getattr(one, field), getattr(other, field), 1e-7), field
    shares = np.array(WEIGHTS) / sum(WEIGHTS)
    for field in ("twist_by_strength", "force_by_strength"):
        apart, together = getattr(one, field), getattr(other, field)
        assert same(apart[..., :2] @ shares, together[..., 0], 1e-7)
        assert same(apart[..., 2:], together[..., 1:], 1e-7)
    assert (one.status == pp.Smoothness.SMOOTH).sum() > 10


def test_each_support_can_be_an_array():
    """Of three and two kinds, which broadcast."""
    first = np.array([FEET, pp.Disc(0.8), pp.Ring(1.2)], dtype=object)[:, None]
    second = np.array([pp.Segment((0, 0), (1, 1)), FEET], dtype=object)
    slider = pp.Slider(rod_length=1.3, rod_angle=0.9, radius=1.0)

    def scene(one, other):
        effects = [pp.SupportFriction(support=each) for each in (one, other)]
        return pp.Scene(slider=slider, contact=pp.Coulomb(0.6), effects=effects)

    cones, found = pp.motion_cone(scene(first, second)), pp.solve(scene(first, second), 0.4)
    assert cones.right.shape == found.shape == (3, 2)
    for i, j in np.ndindex(3, 2):
        single = scene(first[i, 0], second[j])
        cone, solutions = pp.motion_cone(single), pp.solve(single, 0.4)
        assert (cones.right[i, j], cones.left[i, j]) == (cone.right, cone.left)
        assert np.array_equal(found[i, j][0].force, solutions[0].force)
