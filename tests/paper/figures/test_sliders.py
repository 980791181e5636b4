"""What figures 16 to 19 plot, from the small study of sliders."""

import numpy as np
import pytest
from mechanics.supports.cases import TRIPOD

import planar_pushing as pp
from pulling_by_pushing.figures import figure_17, figure_18
from pulling_by_pushing.figures.parts import gallery
from pulling_by_pushing.study.datasets.base import words

QUADRUPED = pp.Points([(-0.8, -0.6), (0.8, -0.6), (0.8, 0.6), (-0.8, 0.6)], [1, 1, 1, 1])


def test_every_limit_curve_is_convex_and_the_rings_is_that_of_the_ring(plotted):
    data = plotted["figure_16"]
    for xy in "xy":
        ring = data[f"force_{xy}"].sel(support="ring")
        np.testing.assert_allclose(ring, data[f"ring_force_{xy}"], atol=1e-12)
    for name in data.support.values:
        x, y = data.force_x.sel(support=name).values, data.force_y.sel(support=name).values
        turns = np.diff(x)[:-1] * np.diff(y)[1:] - np.diff(y)[:-1] * np.diff(x)[1:]
        assert (turns > -1e-12).all(), name


def test_a_flat_is_straight_and_has_one_pivot(plotted):
    one = plotted["figure_16"].sel(support="tripod")
    parts = gallery.flat_parts(one.pivot.values)
    assert [number for number, _ in parts] == [0, 0]
    for _, part in parts:
        x, y = one.force_x.values[part], one.force_y.values[part]
        assert np.ptp((x - x[0]) * (y[-1] - y[0]) - (y - y[0]) * (x[-1] - x[0])) < 1e-12
    found = gallery.flat_parts(np.array([1, 1, -1, 2], np.int16))
    assert found == [(1, slice(0, 2)), (2, slice(3, 4))]


def scene(support, length, angle, contact):
    return gallery.scene({"": support}, length, angle, contact)


def least_friction(scenes):
    return np.tan(np.deg2rad(figure_17.pulling_friction_angle(scenes).item()))


@pytest.mark.parametrize(
    ("support", "length", "angle"),
    [(pp.Ring(1.0), 2.0, 45.0), (pp.Disc(1.0), 0.5, 120.0), (TRIPOD, 2.0, 88.0), (TRIPOD, 1.0, 45.0),
     (QUADRUPED, 2.0, 79.0), (QUADRUPED, 2.0, 77.0), (pp.Segment((-1, 0), (1, 0)), 3.0, 60.0)],
)  # fmt: skip
def test_pulling_begins_at_the_least_friction(support, length, angle):
    least = least_friction(scene(support, length, angle, pp.PerfectlyRough()))
    for factor, pulls in ((1 - 1e-9, False), (1 + 1e-9, True)):
        assert bool(pp.can_pull(scene(support, length, angle, pp.Coulomb(factor * least)))) == pulls


def test_the_least_friction_of_the_ring_is_known(plotted):
    least = least_friction(scene(pp.Ring(1.0), 2.0, 45.0, pp.PerfectlyRough()))
    assert least == pytest.approx(1.26987543, rel=1e-8)
    over = plotted["figure_17"].ring_over_rod_angle
    assert np.tan(np.deg2rad(float(over.sel(rod_angle=45.0)))) == pytest.approx(
        1.26987543, rel=1e-8
    )
    lengths = np.array([0.5, 1.0, 2.0, 5.0])
    law = np.tan(np.deg2rad(figure_17.inertia_friction_angle(lengths, np.array(45.0))))
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
    assert figure_17.pulling_friction_angle(upright).item() == 90.0
    assert not bool(pp.can_pull(scene(support, 2.0, 90.0, pp.InfiniteFriction())))


def test_the_jump_of_the_tripod_at_the_upright_rod_is_drawn(plotted, pictures):
    data, ax = plotted["figure_17"], pictures["figure_17"].axes[3]
    never, limit = (line for line in ax.lines if line.get_marker() == "o")
    assert never.get_xdata() == limit.get_xdata() == [90.0]
    assert float(never.get_ydata()[0]) == pytest.approx(0)
    beside = data.over_rod_angle.sel(support="tripod").sel(rod_angle=slice(89.9, 89.9999))[-1]
    assert float(limit.get_ydata()[0]) == pytest.approx(float(beside) - 90.0, abs=0.01)


def test_the_friction_angle_is_accurate_where_its_tangent_is_not():
    angles = np.array([89.999, 90.001])
    left, right = figure_17.inertia_friction_angle(np.array(2.0), angles)
    assert left == pytest.approx(right, abs=1e-13)
    exact = 90.0 - np.rad2deg(4 * np.deg2rad(0.001))  # cot of the angle is 4 e / (1 + 4 e^2)
    assert left == pytest.approx(exact, rel=0, abs=1e-9)


def test_the_slipping_part_is_what_the_modes_say():
    one = scene(QUADRUPED, 1.0, 30.0, pp.InfiniteFriction())
    cone = pp.motion_cone(one)
    part = figure_18.slipping_part(np.rad2deg(cone.right), np.rad2deg(cone.left)).item()
    pushes = np.deg2rad(np.arange(0.05, 180.0, 0.1))
    single = pp.Scene(
        slider=pp.Slider(rod_length=1.0, rod_angle=np.deg2rad(30.0)), contact=pp.InfiniteFriction(),
        effects=(pp.SupportFriction(support=QUADRUPED),),
    )  # fmt: skip
    sticks = (pp.solve(single, pushes).mode == pp.ContactMode.STICK).any(axis=-1)
    assert part == pytest.approx(1 - sticks.mean(), abs=1e-3)


def test_the_grids_cones_lie_on_the_curves_of_slip_and_are_its_dots(plotted, pictures):
    data = plotted["figure_18"]
    ring = data.sel(support="ring")
    for axis in ("rod_length", "rod_angle"):
        found = np.interp(ring[f"grid_{axis}"], ring[axis], ring[f"over_{axis}"])
        np.testing.assert_allclose(found, ring[f"grid_over_{axis}"], atol=2e-3)
    for number, ax in enumerate(pictures["figure_18"].axes):
        one = data.sel(support=["box", "tripod"][number // 2])
        axis = ("rod_length", "rod_angle")[number % 2]
        (dots,) = (line for line in ax.lines if line.get_marker() == "o")
        assert np.array_equal(dots.get_xdata(), data[f"grid_{axis}"])
        assert np.array_equal(dots.get_ydata(), 100 * one[f"grid_over_{axis}"])


def test_the_motion_center_of_the_tripod_comes_to_its_far_foot_and_stays(plotted):
    data = plotted["figure_19"]
    assert int(data.pivot_point) == 0
    gap = data.center_distance.values
    arrived = np.flatnonzero(gap < 1e-9)
    assert len(gap) // 4 < len(arrived) < len(gap)
    assert (np.diff(arrived) == 1).all()
    assert np.ptp(data.motion_edge.isel(instant=1).values) < 1e-9
    assert np.ptp(data.motion_edge.isel(instant=0).values) > 10


def test_a_support_has_one_color_in_both_figures(pictures):
    found = [
        {line.get_label(): line.get_color() for ax in pictures[name].axes for line in ax.lines}
        for name in ("figure_17", "figure_18")
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
    assert gallery.families(found) == (["a", "c"], ["b"])
