"""First touch of a moving disc, against distances that are sampled along the fraction."""

import numpy as np
import pytest

import planar_pushing as pp

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
#: Its corner (0, 0) is reflex.
ELL = [(-1, -1), (1, -1), (1, 0), (0, 0), (0, 1), (-1, 1)]
ROOT = np.sqrt(0.5)


def distances(outline, points):
    """Signed distances of points from a polygon, negative inside: a side at a time, winding number."""
    corners, (x, y) = np.asarray(outline, dtype=float), np.transpose(points)
    best, turns = np.full(len(points), np.inf), np.zeros(len(points))
    for (a, b), (c, d) in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        along, up, right, over = c - a, d - b, x - a, y - b
        part = np.clip((right * along + over * up) / (along**2 + up**2), 0.0, 1.0)
        best = np.minimum(best, (right - part * along) ** 2 + (over - part * up) ** 2)
        # A ray along +x leaves through sides that go up, and enters through those that go down.
        if b != d:
            crosses = ((b > y) != (d > y)) & ((right * up < over * along) == (up > 0.0))
            turns += np.sign(up) * crosses
    return np.where(turns != 0, -1.0, 1.0) * np.sqrt(best)


def star(random, corners):
    """A random polygon around the origin, counterclockwise, with reflex corners."""
    angles = np.sort(random.uniform(0.0, 2.0 * np.pi, corners))
    sizes = random.uniform(0.4, 1.0, corners)
    return np.stack([sizes * np.cos(angles), sizes * np.sin(angles)], axis=-1)


@pytest.mark.parametrize(("position", "displacement", "radius", "contact", "normal", "side", "fraction"), [
    ((0.3, -3), (0, 4), 0.0, (0.3, -1), (0, 1), 0, 0.5),
    ((0.3, -3), (0, 4), 0.5, (0.3, -1), (0, 1), 0, 0.375),
    ((3, 0.2), (-4, 0), 0.5, (1, 0.2), (-1, 0), 1, 0.375),
    ((-3, -3), (4, 4), 0.0, (-1, -1), (ROOT, ROOT), 3, 0.5),
    ((-3, -3), (4, 4), ROOT, (-1, -1), (ROOT, ROOT), 3, 0.375),
    ((-1.3, -3), (0, 5), 0.5, (-1, -1), (0.6, 0.8), 3, 0.32),
    ((1.3, -3), (0, 5), 0.5, (1, -1), (-0.6, 0.8), 0, 0.32),
    ((0, -1), (0.1, 0.1), 0.0, (0, -1), (0, 1), 0, 0.0),
    ((0, -1.5), (0.1, 0.1), 0.5, (0, -1), (0, 1), 0, 0.0),
    ((0, -2), (0, 1), 0.0, (0, -1), (0, 1), 0, 1.0),
])  # fmt: skip
def test_the_square(position, displacement, radius, contact, normal, side, fraction):
    touch = pp.first_touch(SQUARE, position, displacement, radius)
    assert touch.contact == pytest.approx(contact, abs=1e-15)
    assert touch.normal == pytest.approx(normal, abs=1e-15)
    assert (int(touch.side), float(touch.fraction)) == (side, pytest.approx(fraction, abs=1e-15))
    assert bool(touch.corner) == (max(map(abs, contact)) == min(map(abs, contact)))


@pytest.mark.parametrize(("position", "displacement", "radius"), [
    ((0, -3), (0, 1), 0.5),  # too short
    ((0, -3), (0, -4), 0.5),  # away
    ((-3, -1.5), (6, 0), 0.5),  # along a side
    ((1.5, -3), (0, 6), 0.5),  # past a corner
    ((0, -1.5), (1, 0), 0.5),  # along the side that it touches
    ((0, -1.5), (0.1, -0.1), 0.5),  # off it
    ((0, -3), (0, 0), 0.5),  # nowhere
])  # fmt: skip
def test_one_that_misses_or_grazes_does_not_touch(position, displacement, radius):
    touch = pp.first_touch(SQUARE, position, displacement, radius)
    assert np.isnan([*touch.contact, *touch.normal, touch.fraction]).all()
    assert (int(touch.side), bool(touch.corner), float(touch.overlap)) == (-1, False, 0.0)


def test_a_reflex_corner_is_reached_by_its_sides():
    starts = [(0.5, 0.5), (0.6, 0.5), (0.5, 0.6)]
    touch = pp.first_touch(ELL, starts, [(-1, -1)] * 3, [0.2] * 3)
    assert not touch.corner.any()
    assert touch.side[1:].tolist() == [2, 3]
    assert touch.contact[1:] == pytest.approx(np.array([(0.3, 0.0), (0.0, 0.3)]), abs=1e-15)
    # Both at once: the contact is that of one of them.
    assert sorted(touch.contact[0].tolist()) == pytest.approx([0.0, 0.2], abs=1e-15)
    point = pp.first_touch(ELL, (0.5, 0.5), (-1, -1))
    assert (bool(point.corner), float(point.fraction)) == (False, pytest.approx(0.5, abs=1e-15))
    assert point.contact == pytest.approx((0, 0), abs=1e-15)


@pytest.mark.parametrize(("position", "displacement", "contact", "fraction"), [
    ((0.7, 0.2), (-1, 0), (0, 0.2), 0.5),  # along one side of the L to the other
    ((0.2, 0.2), (-1, 0.5), (0, 0.2), 0.0),  # in touch with both, and away from one
    ((0.2, 0.2), (0.5, -1), (0.2, 0), 0.0),
])  # fmt: skip
def test_one_that_leaves_a_side_that_it_touches_meets_another(
    position, displacement, contact, fraction
):
    touch = pp.first_touch(ELL, position, displacement, 0.2)
    assert touch.contact == pytest.approx(contact, abs=1e-15)
    assert touch.fraction == pytest.approx(fraction, abs=1e-15)


@pytest.mark.parametrize(("position", "radius", "contact", "normal"), [
    ((0.2, -0.97), 0.0, (0.2, -1), (0, 1)),
    ((0.2, -1.47), 0.5, (0.2, -1), (0, 1)),
    ((0.2, -0.99), 0.02, (0.2, -1), (0, 1)),
    ((-1.27, -1.36), 0.475, (-1, -1), (0.6, 0.8)),
])  # fmt: skip
def test_one_that_overlaps_a_little_touches_at_once(position, radius, contact, normal):
    touch = pp.first_touch(SQUARE, position, (0.1, 0.3), radius, tolerance=0.05)
    assert touch.contact == pytest.approx(contact, abs=1e-15)
    assert touch.normal == pytest.approx(normal, abs=1e-15)
    assert (float(touch.fraction), 0.0 < touch.overlap <= 0.05) == (0.0, True)
    deep = pp.first_touch(SQUARE, position, (0.1, 0.3), radius, tolerance=0.01)
    assert np.isnan(deep.fraction)
    assert deep.overlap == touch.overlap
    away = pp.first_touch(SQUARE, position, (-0.1, -0.3), radius, tolerance=0.05)
    assert np.isnan(away.fraction)


@pytest.mark.parametrize("radius", [0.0, 0.05, 0.4])
@pytest.mark.parametrize("corners", [3, 4, 9])
def test_random_outlines_against_sampled_distances(radius, corners):
    random = np.random.default_rng([corners, int(100 * radius)])
    outline = star(random, corners)
    start = random.normal(size=(300, 2)) * 1.5
    start = start[distances(outline, start) > radius]
    motion = random.normal(size=start.shape) - start
    touch = pp.first_touch(outline, start, motion, radius)
    assert 20 < np.isfinite(touch.fraction).sum() < len(start)
    ways = np.linspace(0.0, 1.0, 400)
    for k, fraction in enumerate(touch.fraction):
        nearest = distances(outline, start[k] + ways[:, None] * motion[k])
        if np.isnan(fraction):
            assert nearest.min() > radius - 1e-12
            continue
        center = start[k] + fraction * motion[k]
        assert distances(outline, center[None]) == pytest.approx(radius, abs=1e-12)
        assert distances(outline, touch.contact[None, k]) == pytest.approx(0.0, abs=1e-12)
        assert center + radius * touch.normal[k] == pytest.approx(touch.contact[k], abs=1e-12)
        assert np.hypot(*touch.normal[k]) == pytest.approx(1.0, abs=1e-14)
        assert (nearest[ways < fraction] > radius - 1e-12).all()
        assert touch.normal[k] @ motion[k] > 0.0


def test_shapes_are_those_of_the_pushes_and_the_sense_of_the_outline_does_not_count():
    starts = np.array([[(0.3, -3.0), (0.0, 3.0)], [(5.0, 5.0), (-3.0, 0.1)]])
    touch = pp.first_touch(SQUARE, starts, -0.9 * starts, np.array([0.1, 0.2]))
    assert (touch.contact.shape, touch.fraction.shape) == ((2, 2, 2), (2, 2))
    assert touch == pp.first_touch(SQUARE[::-1], starts, -0.9 * starts, np.array([0.1, 0.2]))
    one = pp.first_touch(SQUARE, starts[1, 1], -0.9 * starts[1, 1], 0.2)
    assert one.fraction == touch.fraction[1, 1]


@pytest.mark.parametrize(("changed", "said"), [
    ({"position": (0, np.nan)}, "position: nan given; allowed: finite numbers"),
    ({"position": (0, 1, 2)}, "position: (3,) given; allowed: shape S + (2,)"),
    ({"displacement": "up"}, "displacement: 'up' given; allowed: finite numbers"),
    ({"radius": -0.1}, "radius: -0.1 given; allowed: numbers >= 0; give 0 for a point"),
    ({"tolerance": -1.0}, "tolerance: -1.0 given; allowed: numbers >= 0"),
    ({"tolerance": [1.0]}, "tolerance: [1.0] given; allowed: numbers >= 0"),
    ({"radius": True}, "radius: True given; allowed: finite numbers"),
    ({"radius": "2"}, "radius: '2' given; allowed: finite numbers"),
    ({"radius": np.timedelta64(2, "s")}, "radius: np.timedelta64(2,'s') given; allowed: finite numbers"),
    ({"position": (np.datetime64("2020"), 0)}, "position: (np.datetime64('2020'), 0) given"),
    ({"displacement": (10**400, 1)}, "displacement: (1000"),
    ({"position": np.ma.masked_array([0.0, -3.0], [True, False])}, "position: masked_array"),
    ({"outline": [(0, 0), (1e308, 0), (1e308, 1e308)]},
     "outline[1][0]: 1e+308 given; allowed: at most 1e+140; choose another unit of length"),
    ({"radius": [0.1, 0.2, 0.3], "position": [(0, 1)] * 2}, "position: ((2, 2), (2,), (3,)) given"),
    ({"outline": [(0, 0), (1, 1)]}, "outline: "),
])  # fmt: skip
def test_wrong_input(changed, said):
    given = {"outline": SQUARE, "position": (0, -3), "displacement": (0, 1)} | changed
    with pytest.raises(pp.InvalidValue) as error:
        pp.first_touch(**given)
    assert str(error.value).startswith(said)


#: Outlines with arcs, of which the largest hollow one has a radius of 1.25.
ROUND = (
    pp.Outline(pp.Disc(0.8, center=(0.1, -0.2))),
    pp.rounded(SQUARE, 0.3),
    pp.rounded(ELL, [0.2, 0.1, 0.0, 0.25, 0.3, 0.4]),
    pp.Outline.ellipse(1.0, 0.6, 32),
    pp.Outline.from_bulges([(-1, -1, 0), (1, -1, 0), (1, 1, -0.5), (-1, 1, 0.7)]),
    pp.Outline(SQUARE, holes=[pp.Disc(0.6)]),
)  # fmt: skip


@pytest.mark.parametrize("radius", [0.0, 0.25, 3.0])
@pytest.mark.parametrize("offset", [0.0, 0.3, -0.99])
def test_a_disc_meets_a_disc_at_the_sum_of_their_radii(radius, offset):
    # Along +x at the height h above the center, they meet at x = -sqrt(D^2 - h^2).
    reach = 0.8 + radius
    height = offset * reach
    away = np.array([-np.sqrt(reach**2 - height**2), height])
    touch = pp.first_touch(pp.Disc(0.8, center=(0.1, -0.2)), (-9.9, height - 0.2), (20, 0), radius)
    assert touch.fraction == pytest.approx((away[0] + 10.0) / 20.0, abs=1e-14)
    assert touch.normal == pytest.approx(-away / reach, abs=1e-13)
    assert touch.contact == pytest.approx((0.1, -0.2) + 0.8 * away / reach, abs=1e-13)
    assert (int(touch.side), bool(touch.corner), float(touch.overlap)) == (-1, False, 0.0)
    past = pp.first_touch(pp.Disc(0.8, center=(0.1, -0.2)), (-9.9, reach - 0.2), (20, 0), radius)
    assert np.isnan(past.fraction)


@pytest.mark.parametrize("radius", [0.0, 0.2, 0.59])
@pytest.mark.parametrize("start", [(0.0, 0.0), (-0.005, 0.007)])
def test_a_disc_in_a_round_hole_meets_its_wall_from_inside(radius, start):
    way = np.array([2.0, 1.0])
    touch = pp.first_touch(ROUND[5], start, way, radius)
    fraction = float(touch.fraction)
    # |start + fraction * way| = 0.6 - r
    roots = np.roots([way @ way, 2.0 * way @ start, np.dot(start, start) - (0.6 - radius) ** 2])
    assert fraction == pytest.approx(roots.max(), abs=1e-14)
    center = start + fraction * way
    assert touch.normal == pytest.approx(center / np.hypot(*center), abs=1e-12)
    assert touch.contact == pytest.approx(0.6 * center / np.hypot(*center), abs=1e-12)
    # From the wall across the hole to the other side of it.
    across = pp.first_touch(ROUND[5], center, -4.0 * center, radius)
    assert across.fraction == pytest.approx(0.5, abs=1e-9)
    again = pp.first_touch(ROUND[5], center, center, radius)
    assert (float(again.fraction), float(again.overlap)) == (0.0, 0.0)


@pytest.mark.parametrize("radius", [0.2, 0.5])
def test_a_hollow_wall_is_met_by_discs_that_fit_into_it(radius):
    # The wall is a circle of radius 1.25 about (0, 1.75), from (1, 1) to (-1, 1) through (0, 0.5).
    hollow = pp.Outline.from_bulges([(-1, -1, 0), (1, -1, 0), (1, 1, -0.5), (-1, 1, 0)])
    touch = pp.first_touch(hollow, (0.3, 3.0), (0, -3.0), radius)
    depth = 1.75 - np.sqrt((1.25 - radius) ** 2 - 0.09)
    assert touch.fraction == pytest.approx((3.0 - depth) / 3.0, abs=1e-14)
    assert touch.normal == pytest.approx(np.array([0.3, depth - 1.75]) / (1.25 - radius), abs=1e-13)
    # A larger one is stopped by both corners.
    large = pp.first_touch(hollow, (0.0, 5.0), (0, -5.0), 1.3)
    assert large.fraction == pytest.approx((4.0 - np.sqrt(0.69)) / 5.0, abs=1e-14)
    assert bool(large.corner)


@pytest.mark.parametrize(
    "radius", [0.0, 0.4, *(pytest.param(each, marks=pytest.mark.slow) for each in (0.05, 5.0))]
)
@pytest.mark.parametrize("outline", ROUND[:5])
def test_round_outlines_against_sampled_distances_from_polygons(outline, radius):
    polygon = outline.vertices(1e-4)
    random = np.random.default_rng(int(100 * radius))
    start = random.normal(size=(60, 2)) * (1.5 + radius)
    start = start[distances(polygon, start) > radius + 1e-3]
    motion = random.normal(size=start.shape) - start
    touch = pp.first_touch(outline, start, motion, radius)
    assert np.isfinite(touch.fraction).sum() > 5
    ways, fraction = np.linspace(0.0, 1.0, 60), touch.fraction[:, None]
    along = start[:, None] + ways[:, None] * motion[:, None]
    nearest = distances(polygon, along.reshape(-1, 2)).reshape(along.shape[:2])
    assert (nearest[np.isnan(fraction) | (ways < fraction)] > radius - 2e-4).all()
    hit = np.isfinite(touch.fraction)
    center, normal = (start + fraction * motion)[hit], touch.normal[hit]
    contact = touch.contact[hit]
    assert distances(polygon, center) == pytest.approx(radius, abs=2e-4)
    assert distances(polygon, contact) == pytest.approx(0.0, abs=2e-4)
    assert center + radius * normal == pytest.approx(contact, abs=1e-12)
    assert ((normal * motion[hit]).sum(axis=1) > 0.0).all()


def test_sides_of_round_outlines_are_numbered_in_order():
    box = pp.rounded(SQUARE, 0.3)
    starts = np.array([[(0, -3), (3, 0)], [(0, 3), (-3, 0)]])
    touch = pp.first_touch(box, starts, -0.9 * starts, [[0.1, 0.2], [0.0, 0.5]])
    assert touch.side.tolist() == [[0, 1], [2, 3]]
    # Where a side joins its arc, as one or the other: no disc passes between them.
    joints = np.column_stack([np.full(41, -0.7) + np.linspace(-1e-12, 1e-12, 41), np.full(41, -3)])
    touch = pp.first_touch(box, joints, (0, 4), 0.5)
    assert touch.fraction == pytest.approx(np.full(41, 0.375), abs=1e-12)


@pytest.mark.parametrize(("position", "radius", "contact"), [
    ((0.0, -0.77), 0.0, (0.0, -0.8)), ((0.0, -1.03), 0.25, (0.0, -0.8)),
])  # fmt: skip
def test_one_that_overlaps_an_arc_a_little_touches_it_at_once(position, radius, contact):
    touch = pp.first_touch(pp.Disc(0.8), position, (0.1, 0.3), radius, tolerance=0.05)
    assert touch.contact == pytest.approx(contact, abs=1e-15)
    assert touch.normal == pytest.approx((0, 1), abs=1e-15)
    assert float(touch.fraction) == 0.0
    assert np.isnan(pp.first_touch(pp.Disc(0.8), position, (0.1, 0.3), radius).fraction)
