"""The slider of a picture: each kind of support in its place, the rod, the centers, and what pushes it."""

import numpy as np
import pytest
import xarray as xr
from drawing.scenes import ASIDE, INERTIA, RING, coulomb, dataset, scene, supported
from mechanics.supports.cases import SUPPORTS

import planar_pushing as pp
from planar_pushing.drawing.body import (
    NAMES,
    RIM,
    Body,
    add_body,
    add_fence,
    add_finger,
    body_in,
    body_of,
    name_centers,
)
from planar_pushing.drawing.canvas.colors import SLIDER, tint
from planar_pushing.drawing.canvas.marks import Area, Dot, Hatch, Label, Line, Picture
from planar_pushing.drawing.supports import (
    BAR,
    BELOW,
    DRAWERS,
    EVEN,
    HEAVIEST,
    HIGHEST,
    OUTLINE,
    Ink,
    Pose,
    add_support,
    extents,
)
from planar_pushing.mechanics.supports import SHAPES

UPRIGHT, HERE = Pose((1.0, 2.0), np.pi / 2), Pose((0.0, 0.0), 0.0)
CORNERS = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
BOX = pp.Polygon([(-1, -1), (3, -1), (3, 1), (-1, 1)])


def drawn(support, pose=UPRIGHT, ink=None):
    """Marks of a support, by kind."""
    picture = Picture()
    add_support(picture, support, pose, ink or Ink())
    return {kind: [m for m in picture.marks if isinstance(m, kind)] for kind in (Area, Line, Dot)}


def test_every_shape_is_drawn():
    assert set(DRAWERS) == set(SHAPES.values())


def test_a_pose_turns_moves_and_scales_about_its_origin():
    assert UPRIGHT.to_plane((1.0, 0.5)) == pytest.approx([0.5, 3.0])
    assert UPRIGHT.to_plane([[0, 0], [0, 1]]) == pytest.approx(np.array([[1, 2], [0, 2]]))
    assert UPRIGHT._replace(scale=0.5).to_plane((2.0, 1.0)) == pytest.approx([0.5, 3.0])


@pytest.mark.parametrize("name", SUPPORTS)
def test_the_extents_are_those_of_what_is_drawn(name):
    support, pose = SUPPORTS[name][0], Pose((0.3, -0.2), 0.7, 0.5)
    marks, (low, high) = drawn(support, pose), extents(support, pose)
    points = [ring for area in marks[Area] for ring in area.rings]
    points = np.vstack(
        [*points, *(line.points for line in marks[Line]), *(d.position for d in marks[Dot])]
    )
    slack = 0.03 * pose.scale * support.extent  # circles are drawn as polygons
    assert (points.min(axis=0) <= low + slack).all()
    assert (points.max(axis=0) >= high - slack).all()
    if name != "peak":  # maps are drawn with their empty cells
        assert points.min(axis=0) == pytest.approx(low, abs=slack)
        assert points.max(axis=0) == pytest.approx(high, abs=slack)


@pytest.mark.parametrize(
    ("support", "radii", "center"),
    [(pp.Ring(0.7), [0.7], (1, 2)), (pp.Disc(0.5, (1.0, 0.0)), [0.5], (1, 3)),
     (pp.Annulus(0.5, 1.0), [1.0, 0.5], (1, 2))],
)  # fmt: skip
def test_circles_have_their_radii_about_their_center(support, radii, center):
    marks = drawn(support)
    assert [np.hypot(*(line.points - center).T) for line in marks[Line]] == [
        pytest.approx(radius, rel=1e-3) for radius in radii
    ]
    assert len(marks[Area]) == (0 if isinstance(support, pp.Ring) else 1)
    for area in marks[Area]:  # an annulus has a hole
        assert [np.hypot(*(ring - center).T)[0] for ring in area.rings] == pytest.approx(radii)
        assert (area.color, area.order) == (tint(SLIDER, EVEN), BELOW)
    assert {line.order for line in marks[Line]} == {OUTLINE}


def test_a_polygon_is_a_shaded_area_with_an_outline():
    marks = drawn(pp.Polygon(CORNERS), ink=Ink(width=1.5))
    ((area,), (line,)) = marks[Area], marks[Line]
    assert area.rings[0] == pytest.approx(UPRIGHT.to_plane(CORNERS))
    assert line.points[1:-1] == pytest.approx(UPRIGHT.to_plane(CORNERS))
    assert line.points[0] == pytest.approx(line.points[-1])
    assert line.width == 1.5


def test_a_hole_is_left_out_of_the_area_and_has_an_outline():
    hole = [(0, 0), (0.5, 0), (0, 0.5)]
    marks = drawn(pp.Polygon(CORNERS, [hole]))
    ((area,), lines) = marks[Area], marks[Line]
    for ring, line, corners in zip(area.rings, lines, (CORNERS, hole), strict=True):
        assert ring == pytest.approx(UPRIGHT.to_plane(corners))
        assert line.points[1:-1] == pytest.approx(UPRIGHT.to_plane(corners))


@pytest.mark.parametrize("pressure", [[[1, 4]], [[0, 4]]])
def test_a_pressure_is_the_shade_of_its_cell_and_a_cell_without_is_left_out(pressure):
    cells = drawn(pp.PressureMap([0, 1, 3], [0, 2], pressure), HERE)[Area]
    colors = [tint(SLIDER, HIGHEST * each / 4) for each in pressure[0] if each]
    assert [cell.color for cell in cells] == colors
    assert np.ptp(cells[-1].rings[0], axis=0) == pytest.approx([2, 2])


def test_a_segment_is_a_bar():
    (bar,) = drawn(pp.Segment((0, -1), (0, 1)))[Line]
    assert bar.points == pytest.approx(np.array([[2, 2], [0, 2]]))
    assert bar.width == BAR


def test_areas_of_dots_are_in_the_ratio_of_the_weights():
    marks = drawn(pp.Points([(1, 0), (0, 1), (-1, 0)], [1, 2, 4]))
    sizes = np.array([dot.size for dot in marks[Dot]])
    assert sizes**2 == pytest.approx(HEAVIEST**2 * np.array([0.25, 0.5, 1.0]))
    assert marks[Dot][0].position == pytest.approx(UPRIGHT.to_plane((1, 0)))
    assert [leg.points[1] for leg in marks[Line]] == [pytest.approx(d.position) for d in marks[Dot]]


def test_a_composite_is_its_parts():
    marks = drawn(pp.Composite([(1, pp.Disc(1.0)), (1, pp.Segment((2, 0), (3, 0)))]))
    assert len(marks[Area]) == 1
    assert BAR in [line.width for line in marks[Line]]


# -- bodies ------------------------------------------------------------------------------------------


def body(*effects, **slider):
    """The body of a scene, which its dataset describes too."""
    given = coulomb(2), effects
    found = body_of(scene(*given, **slider))
    stored = body_in(dataset(given[0], 100, effects, **slider))
    assert found.support == stored.support
    assert {k: pytest.approx(v) for k, v in found.centers} == dict(stored.centers)
    return found


def test_the_body_is_that_of_the_scene():
    found = body(supported(BOX))
    assert found.support == BOX
    assert dict(found.centers) == {"pressure": (1.0, 0.0)}
    assert (found.half, found.middle.tolist(), found.is_ring) == (2.0, [1.0, 0.0], False)
    assert body_in(xr.Dataset({"radius": 1.5})) == Body(support=pp.Ring(1.5))


def test_centers_are_marked_where_they_are_off_the_center():
    assert body(RING, radius=2.0) == Body(support=pp.Ring(2.0))
    assert body(RING, INERTIA).centers == ()
    aside = pytest.approx((0.4, 0.3))
    assert dict(body(RING, ASIDE).centers) == {"pressure": (0.0, 0.0), "mass": aside}
    assert [name for name, _ in body(ASIDE).centers] == ["mass"]


def test_the_box_holds_support_and_centers():
    far = body(supported(BOX), INERTIA | {"center": [5.0, 0.0]})
    rim = RIM * far.half
    assert far.box(HERE) == pytest.approx(np.array([[-1 - rim, -1 - rim], [5 + rim, 1 + rim]]))


def test_signs_rod_and_contact_are_drawn_and_the_signs_are_named():
    found, picture = body(supported(BOX), ASIDE), Picture()
    add_body(picture, found, UPRIGHT, contact=(0, 0))
    name_centers(picture, found, UPRIGHT)
    places = {name: UPRIGHT.to_plane(place) for name, place in found.centers}
    signs = {mark.shape: mark.position for mark in picture.marks if isinstance(mark, Dot)}
    assert signs.pop("o") == pytest.approx([0, 0])
    assert signs == {name: pytest.approx(place) for name, place in places.items()}
    labels = {mark.text: mark.position for mark in picture.marks if isinstance(mark, Label)}
    assert labels == {NAMES[name]: pytest.approx(place) for name, place in places.items()}
    assert any(
        np.array_equal(m.points, [(0, 0), (1, 2)]) for m in picture.marks if isinstance(m, Line)
    )


def test_a_fence_is_hatched_below_its_edge_and_a_finger_is_on_its_side():
    picture = Picture()
    add_fence(picture, -1, 2, y=0.5, depth=0.1)
    line, hatch = picture.marks
    assert line.points.tolist() == [[-1, 0.5], [2, 0.5]]
    assert isinstance(hatch, Hatch)
    assert hatch.strokes[:, 0, 1] == pytest.approx(0.5)
    assert hatch.strokes[:, 1, 1] == pytest.approx(0.4)
    assert -1 - 1e-12 <= hatch.strokes[..., 0].min() < hatch.strokes[..., 0].max() <= 2 + 1e-9
    picture = Picture()
    add_finger(picture, np.array([(-1, 0), (2, 0)]), (0.5, 0))
    side, finger = picture.marks
    assert side.points.tolist() == [[-1, 0], [2, 0]]
    assert finger.position.tolist() == [0.5, 0]


def test_a_finger_of_finite_radius_is_a_disc_that_touches_the_side():
    picture = Picture()
    add_finger(picture, np.array([(-1, 0), (2, 0)]), (0.5, 0), center=(0.5, -0.4))
    _, disc, rim = picture.marks
    (points,) = disc.rings
    assert np.array_equal(points, rim.points)
    assert np.hypot(*(points - (0.5, -0.4)).T) == pytest.approx(0.4)
    assert points.max(axis=0)[1] == pytest.approx(0.0, abs=1e-15)
    assert points[[0, -1]] == pytest.approx(np.array([(0.5, 0)] * 2))
