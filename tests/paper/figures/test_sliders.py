"""What the figures on any slider show, from the small study of sliders."""

import numpy as np
import pytest
import xarray as xr
from mechanics.supports.cases import TRIPOD

import planar_pushing as pp
from pulling_by_pushing.figures.captions import words
from pulling_by_pushing.figures.parts import gallery
from pulling_by_pushing.figures.sliders import pivoting_tripod, slip_of_supports
from pulling_by_pushing.study.study_file import load_study

LOG, CURVES = pivoting_tripod.FIGURE.reads
QUADRUPED = pp.Points([(-0.8, -0.6), (0.8, -0.6), (0.8, 0.6), (-0.8, 0.6)], [1, 1, 1, 1])


def test_flats_are_the_parts_of_a_curve_with_one_pivot(plotted):
    one = plotted["support_limit_curves"]["support_curves"].sel(support="tripod")
    parts = gallery.flat_parts(one.pivot.values)
    assert [number for number, _ in parts] == [0, 0]
    for _, part in parts:
        x, y = gallery.curve(one.force)[part].T
        assert np.ptp((x - x[0]) * (y[-1] - y[0]) - (y - y[0]) * (x[-1] - x[0])) < 1e-12
    found = gallery.flat_parts(np.array([1, 1, -1, 2], np.int16))
    assert found == [(1, slice(0, 2)), (2, slice(3, 4))]


def test_the_shapes_are_the_supports_of_the_study(plotted):
    study = load_study("workflow/config/sliders_smoke.yaml")
    assert gallery.shapes(plotted["support_limit_curves"]["supports"]) == study.gallery()


def test_the_jump_of_the_tripod_at_the_upright_rod_is_drawn(plotted, pictures):
    rods, ax = (
        plotted["friction_for_pulling"]["support_rods"],
        pictures["friction_for_pulling"].axes[3],
    )
    never, limit = (line for line in ax.lines if line.get_marker() == "o")
    assert never.get_xdata() == limit.get_xdata() == [90.0]
    assert float(never.get_ydata()[0]) == pytest.approx(90.0)
    beside = rods.isel(rod=rods.rod_angle.values == 89.999).sel(support="tripod")
    height = beside.pulling_friction_angle.item()
    assert float(limit.get_ydata()[0]) == pytest.approx(height, abs=0.01)


def test_the_slipping_part_is_what_the_modes_say():
    slider = pp.Slider(rod_length=1.0, rod_angle=np.deg2rad(30.0))
    effects = (pp.SupportFriction(support=QUADRUPED),)
    scene = pp.Scene(slider=slider, contact=pp.InfiniteFriction(), effects=effects)
    cone = pp.motion_cone(scene)
    pushes = np.deg2rad(np.arange(0.05, 180.0, 0.1))
    sticks = (pp.solve(scene, pushes).mode == pp.ContactMode.STICK).any(axis=-1)
    edges = xr.DataArray(np.rad2deg([cone.right, cone.left]), {"edge": ["right", "left"]})
    part = slip_of_supports.slipping_percent(edges)
    assert part == pytest.approx(100 * (1 - sticks.mean()), abs=0.1)


def test_the_grids_cones_lie_on_the_curves_of_slip_as_dots(plotted, pictures):
    cones = plotted["slip_of_supports"]["support_cones"]
    for axis, ax in zip(
        ("rod_length", "rod_angle"), pictures["slip_of_supports"].axes, strict=True
    ):
        for name in ("box", "tripod"):
            (line,) = (line for line in ax.lines if line.get_label() == name)
            (dots,) = (
                dots
                for dots in ax.lines
                if dots.get_marker() == "o" and dots.get_color() == line.get_color()
            )
            assert np.array_equal(dots.get_xdata(), cones[axis])
            for x, y in zip(*dots.get_data(), strict=True):
                near = np.interp(x, *line.get_data())
                assert y == pytest.approx(near, abs=0.2), (name, axis, x)


def test_the_motion_center_of_the_tripod_comes_to_its_far_foot_and_stays(plotted):
    gap = pivoting_tripod.gaps(plotted["pivoting_tripod"][LOG])
    assert np.argmin(gap[:, -1]) == 0
    arrived = np.flatnonzero(gap[0] < 1e-9)
    assert gap.shape[1] // 4 < len(arrived) < gap.shape[1]
    assert (np.diff(arrived) == 1).all()


@pytest.mark.parametrize("time", [0, -1])
def test_the_curve_of_an_instant_is_that_of_its_scene(plotted, time):
    log, curves = (
        plotted["pivoting_tripod"][LOG].isel(time=time),
        plotted["pivoting_tripod"][CURVES],
    )
    shown = pivoting_tripod.instant(log, curves)
    slider = pp.Slider(rod_length=2.0, rod_angle=np.deg2rad(float(log.rod_angle)))
    effects = (pp.SupportFriction(support=TRIPOD),)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(0.25), effects=effects)
    x, y = shown.curve[::20].T
    np.testing.assert_allclose(
        pp.limit_curve(scene, np.arctan2(y, x)).force, shown.curve[::20], atol=1e-12
    )
    cone = pp.motion_cone(scene)
    np.testing.assert_allclose(shown.motions, np.rad2deg([cone.right, cone.left]), atol=0.05)
    assert np.ptp(shown.motions) < 1e-9 if time else np.ptp(shown.motions) > 10


def test_a_support_has_one_color_in_both_figures(pictures):
    found = [
        {line.get_label(): line.get_color() for ax in pictures[name].axes for line in ax.lines}
        for name in ("friction_for_pulling", "slip_of_supports")
    ]
    for name in ("ring", "box", "tripod"):
        assert found[0][name] == found[1][name]


@pytest.mark.parametrize(
    ("name", "said"),
    [("rectangle_2_1", "rectangle 2:1"), ("l_shape", "L shape"), ("segment_across", "segment across")],
)  # fmt: skip
def test_names_in_pictures_are_words(name, said):
    assert words(name) == said


def test_supports_on_areas_are_told_from_points_and_lines():
    half = pp.Composite([(0.5, pp.Disc(1.0)), (0.5, TRIPOD)])
    found = {"ring": pp.Ring(1.0), "a": half, "b": TRIPOD, "c": pp.Annulus(0.5, 1.0)}
    assert gallery.families(found, 1.0) == (["a", "c"], ["b"])
    assert gallery.families(found, 2.0)[1] == ["ring", "b"]
