"""Places on outlines with arcs: the nearest of them, and contacts there."""

import math

import numpy as np
import pytest
from scipy.spatial import cKDTree

import planar_pushing as pp
from planar_pushing.mechanics.outline.places import nearest_place, places_with_normals

SQUARE = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
BOX = pp.rounded(SQUARE, 0.3)
OUTLINES = (
    BOX, pp.Outline(pp.Disc(1.0)), pp.Outline.ellipse(1.0, 0.6, 64),
    pp.Outline.from_bulges([(-1, -1, 0), (1, -1, 0), (1, 1, -0.5), (-1, 1, 0)]),
    pp.Outline(SQUARE, holes=[pp.Disc(0.5)]),
)  # fmt: skip
EFFECTS = (pp.SupportFriction(support=pp.Disc(0.9)),)


@pytest.mark.parametrize("outline", OUTLINES)
def test_nearest_places_are_those_of_many_samples(outline):
    points = np.random.default_rng(1).uniform(-1.5, 1.5, (300, 2))
    samples = []
    for x, y, rho, beta0, beta1, length, *_ in outline.pieces:
        whole = length if math.isinf(rho) else abs(rho * (beta1 - beta0))
        part = np.linspace(0.0, 1.0, 2 + math.ceil(whole / 5e-4))
        beta = beta0 + part * (beta1 - beta0)
        along = part * length if math.isinf(rho) else 0.0 * part
        rho = 0.0 if math.isinf(rho) else rho
        c, s = np.cos(beta), np.sin(beta)
        samples.append(np.stack([x + along * c + rho * s, y + along * s - rho * c], -1))
    spot = nearest_place(outline, points)
    brute, _ = cKDTree(np.concatenate(samples)).query(points)
    assert np.abs(spot.gap) == pytest.approx(brute, abs=1e-3)
    assert (np.abs(spot.gap) <= brute + 1e-12).all()
    assert np.hypot(*(points - spot.point).T) == pytest.approx(np.abs(spot.gap), abs=1e-12)
    # Inside by the winding of the exterior and the holes.
    turns = np.zeros(len(points))
    for each in samples:
        away = each @ (1, 1j) - points[:, :1] - 1j * points[:, 1:]
        turns += np.angle(away[:, 1:] / away[:, :-1]).sum(axis=1) / (2 * math.pi)
    clear = brute > 1e-3
    assert ((spot.gap < 0) == (np.round(turns) == 1))[clear].all()


@pytest.mark.parametrize("degrees", [-75.0, 0.0, 10.0, 90.0, 180.0])
def test_a_contact_on_a_wall_is_a_point_with_its_normal(degrees):
    point = 1.0 * np.array([math.cos(math.radians(degrees)), math.sin(math.radians(degrees))])
    given = {"effects": EFFECTS, "contact": pp.Coulomb(0.4)}
    wall = pp.scene_at(tuple(point), outline=pp.Disc(1.0), **given)
    free = pp.scene_at(tuple(point), tuple(-point), **given)
    assert wall.slider.side == (0.0, 0.0)
    for one, two in zip(pp.solve(wall, 1.2, 1.0), pp.solve(free, 1.2, 1.0), strict=True):
        assert one.twist == pytest.approx(two.twist, abs=1e-12)


def test_arrays_of_contacts_keep_their_outline():
    points = np.array(
        [(0, -1), (0.7, -1), (1, 0), (0.7 + 0.3 * math.sin(0.5), -0.7 - 0.3 * math.cos(0.5))]
    )
    given = {"effects": EFFECTS, "contact": pp.Coulomb(0.4), "outline": BOX}
    many = pp.scene_at(points, **given)
    assert many.slider.outline == BOX
    for i, point in enumerate(points):
        one = pp.scene_at(tuple(point), **given)
        assert one.placement.normal == tuple(float(part[i]) for part in many.placement.normal)
        assert one.slider.side == tuple(float(end[i]) for end in many.slider.side)
    spots = places_with_normals(BOX, points, np.stack(many.placement.normal, -1))
    assert spots.piece.tolist() == [0, 0, 2, 1]
    assert spots.beta == pytest.approx([0.0, 0.0, math.pi / 2, 0.5])


@pytest.mark.parametrize(
    "use",
    [
        lambda: pp.scene_at((0, -1), (0.5, 1), effects=EFFECTS, contact=pp.Coulomb(0.4), outline=BOX),
        lambda: pp.scene_at((0, -0.9), effects=EFFECTS, contact=pp.Coulomb(0.4), outline=BOX),
    ],
)  # fmt: skip
def test_what_is_not_possible_on_arcs_is_refused(use):
    with pytest.raises(pp.InvalidValue):
        use()
