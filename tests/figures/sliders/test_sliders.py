"""Figures 16 to 20: what they plot, and that their pictures are legible."""

from itertools import combinations

import numpy as np
import pytest
import xarray as xr
from matplotlib.text import Text

import planar_pushing as pp
from planar_pushing.figures.sliders import figure_17, figure_18, gallery
from planar_pushing.figures.sliders.flats import flats
from planar_pushing.figures.style import paper_style
from planar_pushing.study import store
from planar_pushing.study.datasets.base import words
from planar_pushing.study.figures import GALLERY

TRIPOD = pp.Points([(1, 0), (-0.5, 0.75**0.5), (-0.5, -(0.75**0.5))], [1, 1, 1])
QUADRUPED = pp.Points([(-0.8, -0.6), (0.8, -0.6), (0.8, 0.6), (-0.8, 0.6)], [1, 1, 1, 1])


@pytest.mark.parametrize("name", GALLERY)
def test_plotted_numbers_have_units_names_and_a_source_and_survive_the_file(
    plotted, tmp_path, name
):
    for key, variable in plotted[name].variables.items():
        assert variable.attrs["units"], key
        assert variable.attrs["long_name"], key
    assert "Lynch and Mason" in plotted[name].attrs["source"] or name == "figure_19"
    assert plotted[name].attrs["title"]
    store.write_dataset(plotted[name], tmp_path / "data.nc")
    xr.testing.assert_identical(store.read_dataset(tmp_path / "data.nc"), plotted[name])


@pytest.mark.parametrize("name", GALLERY)
def test_no_text_is_clipped_or_covered_by_another(pictures, name):
    frame = pictures[name].bbox
    with paper_style():
        texts = [each for each in pictures[name].findobj(Text) if each.get_visible()]
        boxes = [(each.get_text(), each.get_window_extent()) for each in texts if each.get_text()]
    assert boxes
    for text, box in boxes:
        assert frame.x0 <= box.x0 < box.x1 <= frame.x1, text
        assert frame.y0 <= box.y0 < box.y1 <= frame.y1, text
    for (one, first), (other, second) in combinations(boxes, 2):
        assert not first.padded(-1).overlaps(second.padded(-1)), (one, other)


def test_every_limit_curve_encloses_its_forces_and_the_rings_is_that_of_the_ring(plotted):
    data = plotted["figure_16"]
    np.testing.assert_allclose(data.force_x.sel(support="ring"), data.ring_force_x, atol=1e-12)
    np.testing.assert_allclose(data.force_y.sel(support="ring"), data.ring_force_y, atol=1e-12)
    for name in data.support.values:
        x, y = data.force_x.sel(support=name).values, data.force_y.sel(support=name).values
        turns = np.diff(x)[:-1] * np.diff(y)[1:] - np.diff(y)[:-1] * np.diff(x)[1:]
        assert (turns > -1e-12).all(), name  # convex


def test_a_flat_is_straight_and_has_one_pivot(plotted):
    one = plotted["figure_16"].sel(support="tripod")
    parts = list(flats(one.pivot.values))
    assert [number for number, _ in parts] == [0, 0]
    for _, part in parts:
        x, y = one.force_x.values[part], one.force_y.values[part]
        assert np.ptp((x - x[0]) * (y[-1] - y[0]) - (y - y[0]) * (x[-1] - x[0])) < 1e-12
    assert list(flats(np.array([1, 1, -1, 2], np.int16))) == [(1, slice(0, 2)), (2, slice(3, 4))]


def scene(support, length, angle, contact):
    return gallery.scene({"": support}, length, angle, contact)


@pytest.mark.parametrize(
    ("support", "length", "angle"),
    [(pp.Ring(1.0), 2.0, 45.0), (pp.Disc(1.0), 0.5, 120.0), (TRIPOD, 2.0, 88.0), (TRIPOD, 1.0, 45.0),
     (QUADRUPED, 2.0, 79.0), (QUADRUPED, 2.0, 77.0), (pp.Segment((-1, 0), (1, 0)), 3.0, 60.0)],
)  # fmt: skip
def test_pulling_begins_at_the_least_friction(support, length, angle):
    least = figure_17.pulling_friction(scene(support, length, angle, pp.PerfectlyRough())).item()
    for factor, pulls in ((1 - 1e-9, False), (1 + 1e-9, True)):
        assert bool(pp.can_pull(scene(support, length, angle, pp.Coulomb(factor * least)))) == pulls


def test_the_least_friction_of_the_ring_is_known():
    least = figure_17.pulling_friction(scene(pp.Ring(1.0), 2.0, 45.0, pp.PerfectlyRough()))
    assert least == pytest.approx(1.26987543, rel=1e-8)
    lengths = np.array([0.5, 1.0, 2.0, 5.0])
    law = figure_17.inertia_friction(lengths, np.array(45.0))
    np.testing.assert_allclose(law, 1 + 2 / lengths**2, rtol=1e-14)
    for length, mu in zip(lengths, law, strict=True):
        slider = pp.Slider(rod_length=length, rod_angle=np.pi / 4)
        for factor, pulls in ((1 - 1e-9, False), (1 + 1e-9, True)):
            contact = pp.Coulomb(factor * mu)
            one = pp.Scene(slider=slider, contact=contact, effects=(pp.Inertia(),))
            assert pp.can_pull(one) == pulls


@pytest.mark.parametrize("support", [pp.Ring(1.0), TRIPOD, QUADRUPED, pp.Segment((0, -1), (0, 1))])
def test_about_an_upright_rod_a_support_that_mirrors_itself_is_never_pulled(support):
    upright = scene(support, 2.0, 90.0, pp.PerfectlyRough())
    assert np.isinf(figure_17.pulling_friction(upright))
    assert not bool(pp.can_pull(scene(support, 2.0, 90.0, pp.InfiniteFriction())))


def test_the_slipping_part_is_what_the_modes_say():
    cone = pp.motion_cone(scene(QUADRUPED, 1.0, 30.0, pp.InfiniteFriction()))
    part = figure_18.slipping_part(np.rad2deg(cone.right), np.rad2deg(cone.left)).item()
    pushes = np.deg2rad(np.arange(0.05, 180.0, 0.1))
    one = pp.Scene(
        slider=pp.Slider(rod_length=1.0, rod_angle=np.deg2rad(30.0)),
        contact=pp.InfiniteFriction(),
        effects=(pp.SupportFriction(support=QUADRUPED),),
    )
    sticks = (pp.solve(one, pushes).mode == pp.ContactMode.STICK).any(axis=-1)
    assert part == pytest.approx(1 - sticks.mean(), abs=1e-3)


def test_the_grids_cones_lie_on_the_curves_of_slip(plotted):
    data = plotted["figure_18"]
    ring = data.sel(support="ring")
    for axis in ("rod_length", "rod_angle"):
        found = np.interp(data[f"grid_{axis}"], data[axis], ring[f"over_{axis}"])
        np.testing.assert_allclose(found, ring[f"grid_over_{axis}"], atol=2e-3)


def test_the_motion_centre_of_the_tripod_comes_to_its_far_foot_and_stays(plotted):
    data = plotted["figure_19"]
    assert int(data.pivot_point) == 0
    gap = data.center_distance.values
    arrived = np.flatnonzero(gap < 1e-9)
    assert len(gap) // 4 < len(arrived) < len(gap)
    assert (np.diff(arrived) == 1).all()
    assert np.ptp(data.motion_edge.isel(instant=1).values) < 1e-9
    assert np.ptp(data.motion_edge.isel(instant=0).values) > 10


@pytest.mark.parametrize(
    ("name", "said"),
    [("rectangle_2_1", "rectangle 2:1"), ("l_shape", "L shape"), ("segment_across", "segment across")],
)  # fmt: skip
def test_names_in_pictures_are_words(name, said):
    assert words(name) == said


def test_supports_on_areas_are_told_from_points_and_lines():
    half = pp.Composite([(0.5, pp.Disc(1.0)), (0.5, TRIPOD)])
    found = {"ring": pp.Ring(1.0), "a": half, "b": TRIPOD, "c": pp.Annulus(0.5, 1.0)}
    assert gallery.families(found) == (["a", "c"], ["b"])
