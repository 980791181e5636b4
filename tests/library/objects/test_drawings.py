"""Drawn outlines: what is within a millionth of the size is one place, other vertices are corners."""

from __future__ import annotations

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.mechanics.outline import DRAWN, require_corners, size

pytestmark = [
    pytest.mark.filterwarnings("ignore::planar_pushing.EarlyEndWarning"),
    pytest.mark.filterwarnings("ignore:pusher:planar_pushing.SceneWarning"),
]

#: A box with one more vertex on its lower side, and feet whose center of pressure is near an end of it.
BOX = np.array([(-0.15, -0.1), (0, -0.1), (0.15, -0.1), (0.15, 0.1), (-0.15, 0.1)])
FEET = np.array([(-0.02, 0), (0.14, -0.05), (0.14, 0.05)])
ANGLES = np.random.default_rng(3).uniform(0, 2 * np.pi, 12)
SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
TILTED = (np.sin(np.deg2rad(20)), np.cos(np.deg2rad(20)))


def turned(points, angle):
    c, s = np.cos(angle), np.sin(angle)
    return points @ np.array([(c, s), (-s, c)])


def distances(points, corners):
    """Distances of points from a polygon, by complex numbers."""
    start = np.asarray(corners) @ (1, 1j)
    end, point = np.roll(start, -1), (np.asarray(points) @ (1, 1j))[:, None]
    part = np.clip(((point - start) / (end - start)).real, 0, 1)
    return np.abs(point - start - part * (end - start)).min(axis=1)


def friction(support):
    return (pp.SupportFriction(support=support),)


@pytest.mark.parametrize("digits", [15, 12, 11, 9, 7])
def test_a_side_that_a_drawing_divides_is_one_side(digits):
    """The force is 0.108 from the middle, inside the side, which lies on the fence; the push is stable."""
    for angle in ANGLES:
        outline = np.round(turned(BOX, angle), digits)
        feet = friction(pp.Points(turned(FEET, angle), [1, 2, 2]))
        for side in (0, 1):
            scene = pp.scene_at(side=side, effects=feet, contact=pp.Coulomb(0.5), outline=outline)
            assert scene.slider.side == pytest.approx((-0.15, 0.15), abs=2e-7)
            (solution,) = pp.solve(scene, np.pi / 2)
            assert solution.mode.name == "STICK"
            assert solution.flush
            assert solution.twist[2] == 0.0
            assert pp.stable(scene, scene.to_object((0, 1, 0), "twist"))


@pytest.mark.parametrize("digits", [15, 11, 7])
def test_the_stable_rotations_are_those_of_the_exact_box(digits):
    exact = friction(pp.Polygon(BOX[[0, 2, 3, 4]]))
    box = pp.scene_at(side=0, effects=exact, contact=pp.Coulomb(0.5), outline=BOX)
    rates = np.linspace(0.0, 20.0, 401)
    twists = np.column_stack([0 * rates, np.ones_like(rates), rates])  # about the middle of the box
    largest = rates[pp.stable(box, twists)].max()
    assert 11.0 < largest < 13.0
    for angle in ANGLES[:4]:
        outline = np.round(turned(BOX, angle), digits)
        effects = friction(pp.Polygon(turned(BOX, angle)))
        scene = pp.scene_at(side=0, effects=effects, contact=pp.Coulomb(0.5), outline=outline)
        along_normal = scene.to_object(twists, "twist")
        assert rates[pp.stable(scene, along_normal)].max() == largest


def test_a_finger_slides_past_a_vertex_inside_a_side():
    finger = pp.Pusher(velocity=(0.06, 0.03), shape="finger")
    for digits in (15, 9, 7):
        outline = np.round(turned(BOX, np.deg2rad(17)), digits)
        point = outline[0] + 0.35 * (outline[1] - outline[0])
        effects = friction(pp.Polygon(turned(BOX, np.deg2rad(17))))
        scene = pp.scene_at(point, effects=effects, contact=pp.Coulomb(0.1), outline=outline)
        log = pp.simulate(scene, finger, duration=3.0)
        assert log.attrs["stopped"] == ""
        assert log.contact_position[-1].item() == pytest.approx(0.1564, abs=5e-5)


@pytest.mark.parametrize("e", [0.0, 1e-12, 1e-9, 1e-7, 1e-6])
@pytest.mark.parametrize("which", [0, 1])
def test_a_chamfer_within_the_tolerance_is_a_corner(e, which):
    """A fence tilted by 20 degrees at the corner of a square, until a side lies on it: closed form."""
    chamfered = [(-1, -1 + e), (-1 + e, -1), *SQUARE[1:]]
    scene = pp.scene_at(
        chamfered[which], TILTED, effects=friction(pp.Polygon(SQUARE)), contact=pp.Coulomb(0.5),
        outline=chamfered,
    )  # fmt: skip
    assert scene.slider.side == (0.0, 0.0)
    log = pp.simulate(scene, pp.Pusher(velocity=(0, 1)), duration=6, object_pose=(0, 0, 0))
    assert log.object_angle[-1].item() == pytest.approx(-20.0, abs=1e-6)
    assert bool(log.flush[-1])


@pytest.mark.parametrize(("width", "count"), [
    (1.0, 36), (1.0, 2000), (0.3, 36), (0.3, 2000), (0.3, 20_000),
    pytest.param(1.0, 20_000, marks=pytest.mark.slow),
])  # fmt: skip
def test_fine_curves_keep_their_shape(count, width):
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
    drawn = np.column_stack([np.cos(angle), width * np.sin(angle)])
    corners = require_corners(drawn)
    assert len(corners) == count if count == 36 else 1000 < len(corners) <= 2100
    worst = max(
        distances(part, corners).max() for part in np.array_split(drawn, max(count // 500, 1))
    )
    assert worst <= DRAWN * size(drawn)


def test_vertices_of_random_drawings():
    """Doubled vertices and vertices on sides, all moved by rounding, leave the corners."""
    random = np.random.default_rng(8)
    for _ in range(200):
        count = random.integers(3, 9)
        angle = 2 * np.pi * (np.arange(count) + random.uniform(-0.3, 0.3, count)) / count
        corners = np.column_stack([np.cos(angle), np.sin(angle)])
        parts = [
            np.sort(random.choice([0, 1e-9, 0.3, 0.7, 1 - 1e-8], 3, replace=False)) for _ in corners
        ]
        drawn, sides = [], []
        for k, part in enumerate(parts):
            way = corners[(k + 1) % count] - corners[k]
            drawn += [corners[k], *(corners[k] + part[:, None] * way)]
            sides += [k] * (len(part) + 1)
        drawn = np.array(drawn) + 1e-8 * random.normal(size=(len(drawn), 2))
        way = random.choice([1, -1])
        kept = np.array(require_corners(drawn[::way]))
        assert len(kept) == count
        assert np.abs(kept[:, None] - corners).max(axis=2).min(axis=0).max() < 2e-7
        assert require_corners(kept) == tuple(map(tuple, kept.tolist()))


def test_sides_have_the_numbers_of_the_drawing():
    drawn = [(0, 0), (0, 0), (1, 0), (2, 0), (2, 1e-9), (2, 1), (0, 1), (0, 0.5), (1e-9, 0)]
    effects = friction(pp.Polygon([(0, 0), (2, 0), (2, 1), (0, 1)]))
    normals = {1: (0, 1), 2: (0, 1), 4: (-1, 0), 5: (0, -1), 6: (1, 0), 7: (1, 0)}
    for order in (1, -1):
        for side in range(9):
            number = side if order == 1 else (len(drawn) - 2 - side) % len(drawn)
            given = {"effects": effects, "contact": pp.Coulomb(0.5), "outline": drawn[::order]}
            if side not in normals:
                with pytest.raises(pp.InvalidValue, match="its ends are one corner"):
                    pp.scene_at(side=number, **given)
                continue
            scene = pp.scene_at(side=number, **given)
            assert scene.placement.normal == pytest.approx(normals[side], abs=1e-8)
            assert len(scene.slider.outline_in_body().corners) == 4


@pytest.mark.parametrize(("depth", "refused"), [(-9e-7, False), (9e-7, False), (-2e-6, True)])
def test_corners_near_the_line_of_a_fence_are_on_it(depth, refused):
    """A table on two legs, of which one is longer: with a leg on the fence, the other is on it, too."""
    legs = np.array(
        [(0, 0), (0.3, 0), (0.3, 0.5), (0.7, 0.5), (0.7, depth), (1, depth), (1, 1), (0, 1)]
    )
    given = {"effects": friction(pp.Polygon(legs)), "contact": pp.Coulomb(0.5), "outline": legs}
    if refused:
        with pytest.raises(pp.InvalidValue, match="the fence would pass through the object"):
            pp.scene_at(side=0, **given)
        return
    for given_place in ({"side": 0}, {"point": (0.1, 0)}, {"point": (0, 0), "normal": (0, 1)}):
        scene = pp.scene_at(**given_place, **given)
        log = pp.simulate(scene, pp.Pusher(velocity=(0, 0.1)), duration=1.0, object_pose=(0, 0, 0))
        assert log.attrs["stopped"] == ""
        assert log.flush.values[1:].all()
        assert log.object_angle[-1].item() == 0.0


@pytest.mark.parametrize(
    ("outline", "said"),
    [
        ([(0, 0), (1, 0), (1, 5e-7), (0, 5e-7)], "an outline is exact to a millionth of its size"),
        ([(0, 0), (0.5, 0), (1, 0), (0, 1), (1, 1)], "edges 2 and 4"),
    ],
)
def test_drawings_without_an_area_or_with_crossings_are_refused(outline, said):
    with pytest.raises(pp.InvalidValue, match=said):
        require_corners(outline)
