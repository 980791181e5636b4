"""What figures 1 to 15 plot."""

import numpy as np
import pytest
import xarray as xr
from numpy.testing import assert_allclose

import planar_pushing as pp
from planar_pushing.drawing.canvas.marks import Area, Arrow, Label
from planar_pushing.drawing.sketch import Sketch
from planar_pushing.mechanics.contact import ContactMode
from pulling_by_pushing.figures.figure_12 import sectors
from pulling_by_pushing.figures.figure_13 import mode_sets

SEPARATE, STICK, RIGHT, LEFT = (1 << mode for mode in ContactMode)


def angle(vector):
    return float(np.rad2deg(np.arctan2(*vector[::-1])))


def words(ax):
    return [text.get_text() for text in ax.texts]


def test_figure_01_slips_with_the_velocity_of_the_pusher_between_cone_and_fence(plotted):
    data = plotted["figure_01"]
    assert float(data.force_angle) == pytest.approx(90 + np.rad2deg(np.arctan(1.5)))
    assert float(data.slider_angle) < float(data.pusher_angle) < 180
    assert float(data.pusher_angle) == pytest.approx((float(data.slider_angle) + 180) / 2)


# -- scenes ------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "force", "up"), [("figure_02", 54, 1), ("figure_03", 36, -1), ("figure_04", 54, 1)]
)
def test_a_force_into_the_slider_pushes_or_pulls_it_and_sticks(plotted, name, force, up):
    data = plotted[name]
    assert data["mode"].values == [ContactMode.STICK]
    assert angle(data["force"].values[0]) == pytest.approx(force)
    assert np.sign(data["contact_motion"].values[0, 1]) == up
    pull = data["support_force"].isel(solution=0).mean("support_angle").values * 2 * np.pi
    assert -pull == pytest.approx(data["force"].values[0], abs=0.03)


def test_figures_02_and_03_have_one_scale(pictures):
    scales = [pictures[name].drawn[0][2].scale for name in ("figure_02", "figure_03")]
    assert scales[0] == scales[1]


def test_figure_08_slips_to_the_right_with_the_force_on_the_left_edge(plotted):
    data = plotted["figure_08"]
    assert data["mode"].values == [ContactMode.SLIP_RIGHT]
    force, motion = data["force"].values[0], data["contact_motion"].values[0]
    assert force[0] < 0
    assert force[1] == 0
    assert angle(motion) == pytest.approx(float(data["motion_cone_left"]))


def test_figure_09_has_the_duals_of_the_edges_on_one_line_of_centers(plotted):
    data = plotted["figure_09"]
    rod = np.array([np.cos(np.pi / 4), np.sin(np.pi / 4)])
    beyond = 2 + 1 / 2  # rod length, and squared radius of gyration over rod length
    for side in ("right", "left"):
        assert data[f"center_{side}"].values @ rod == pytest.approx([beyond, beyond])
    assert data["friction_coefficient"].values == pytest.approx([2, np.inf])
    pulls, slips = data.pusher_angle.values
    assert float(data.motion_cone_right[0]) < pulls < 0
    assert float(data.motion_cone_left[1]) < slips < 180


def test_figure_11_has_both_forces_along_one_line_tangent_to_the_ring(plotted):
    data = plotted["figure_11"]
    sketch = Sketch.of_dataset(data)
    one = sketch.solution
    heading = one.force / np.hypot(*one.force)
    foot = (heading @ sketch.center) * heading
    assert np.hypot(*(one.center - sketch.center)) == pytest.approx(1)
    assert foot - sketch.center == pytest.approx(sketch.center - one.center)
    assert one.contact_motion[1] < 0
    parts = [data[name].values[0] for name in ("friction_force", "inertial_force")]
    assert sum(parts) == pytest.approx(-one.force)
    pull = data["support_force"].isel(solution=0).mean("support_angle").values * 2 * np.pi
    assert pull == pytest.approx(parts[0], abs=0.03)
    for part in parts:
        assert part @ heading == pytest.approx(-np.hypot(*part))


# -- limit curves ------------------------------------------------------------------------------------


def test_without_a_rod_the_curve_is_a_circle(plotted):
    curve = plotted["figure_05"].sel(rod_length=0.0)
    assert_allclose(np.hypot(curve.force_x, curve.force_y), 1, rtol=1e-15)


def test_velocity_is_parallel_to_the_four_special_forces(plotted):
    data = plotted["figure_05"]
    assert data.parallel_angle.values.tolist() == [45, 135, 225, 315]
    angles = data.parallel_motion_angle.broadcast_like(data.parallel_force)
    assert_allclose(angles, data.parallel_angle.broadcast_like(angles), rtol=1e-13)


def test_infinite_rod_is_the_segment_along_it(plotted):
    half = np.sqrt(0.5)
    for name in ("infinite_rod_x", "infinite_rod_y"):
        assert_allclose(plotted["figure_05"][name], [half, -half], rtol=1e-14)


def test_the_line_is_finer_than_the_grid_and_passes_through_its_forces(plotted, sources):
    grid, curve = sources["limit_curves"], plotted["figure_05"]
    assert curve.sizes["force_angle"] == 361 > grid.sizes["force_angle"]
    stored = grid.sel(effects="support_friction", rod_angle=45, rod_length=curve.rod_length)
    for name in ("force_x", "force_y"):
        line = curve[name].sel(force_angle=grid.force_angle)
        assert_allclose(line, stored[name], rtol=1e-13, atol=1e-15)


def test_edges_of_the_cones_are_the_published_ones(plotted):
    data = plotted["figure_06"]
    forces = [90 - np.rad2deg(np.arctan(2)), 45, 90, 90 + np.rad2deg(np.arctan(2))]
    assert_allclose(data.mapped_force_angle, forces, rtol=1e-14)
    edges = data.mapped_motion_angle.isel(map=[0, -1])
    assert_allclose(edges, [-20.038457551638, 140.16416973393], rtol=1e-12)
    assert float(data.mapped_motion_angle[1]) == pytest.approx(
        45, rel=1e-14, abs=0
    )  # along the rod
    angles = np.rad2deg(np.arctan2(data.mapped_force_y, data.mapped_force_x))
    assert_allclose(angles, data.mapped_force_angle, rtol=1e-13)


def test_figure_07_cones_are_the_published_ones(plotted, pictures):
    data = plotted["figure_07"]
    published = {1.0: 158.70186040475, 2.0: 148.61039132208, 5.0: 138.83997216476}
    assert_allclose(data.motion_cone_left, [*published.values()], rtol=1e-12)
    assert_allclose(data.motion_cone_left - data.motion_cone_right, 180, rtol=1e-13)
    for ax in pictures["figure_07"].axes:
        assert {"slip", "pull", "$1$"} <= set(words(ax))


def test_ellipses_have_their_minor_axis_across_the_rod(plotted):
    data = plotted["figure_10"].sel(force_angle=[45.0, 135.0])
    lengths = data.rod_length.values
    size = np.hypot(data.force_x, data.force_y)
    assert_allclose(size.isel(force_angle=0), 1, rtol=1e-14)
    assert_allclose(size.isel(force_angle=1), 1 / np.sqrt(1 + lengths**2), rtol=1e-14)


def test_accelerations_are_those_of_the_equations(plotted):
    data = plotted["figure_10"]
    phi = np.deg2rad(data.mapped_force_angle.values)
    x, y = np.cos(phi), np.sin(phi)  # Eqs. (11) and (12) for l = 1, psi = 45 degrees
    found = np.rad2deg(np.arctan2(1.5 * y - 0.5 * x, 1.5 * x - 0.5 * y))
    assert_allclose(data.mapped_motion_angle, found, rtol=1e-12)


@pytest.mark.parametrize("name", ["figure_06", "figure_10", "figure_10_column"])
def test_labels_stand_on_the_side_of_the_fence_of_their_arrows(pictures, name):
    figure = pictures[name]
    for ax in (figure.axes[0], figure.axes[2]):  # both cones
        drawn = [(mark, sheet) for where, mark, sheet in figure.drawn if where is ax]
        tips = [mark.points[-1] for mark, _ in drawn if isinstance(mark, Arrow)]
        names = [each for each in drawn if isinstance(each[0], Label) and "mathbf" in each[0].text]
        assert len(tips) == len(names) >= 4
        for tip, (mark, sheet) in zip(tips, names, strict=True):
            if abs(tip[1]) > 1e-9:
                assert np.sign(mark.place[1] + mark.offset[1] * sheet.unit) == np.sign(tip[1])


# -- centers -----------------------------------------------------------------------------------------


def test_figure_12_cones_are_the_published_ones(plotted):
    data = plotted["figure_12"]
    exact = float(data.exact_cone_right), float(data.exact_cone_left)
    assert exact == pytest.approx((-42.797401838234, 138.83997216476), rel=1e-12, abs=0)
    bound = float(data.conservative_cone_right), float(data.conservative_cone_left)
    assert bound == pytest.approx((-45, 142.06), abs=0.01)


def test_exact_centers_lie_in_the_papers_sectors(plotted):
    data = plotted["figure_12"]
    for _, centers in data[["exact_center_x", "exact_center_y"]].groupby("inertia_share"):
        x = centers.exact_center_x.squeeze() - float(data.ring_center[0])
        y = centers.exact_center_y.squeeze() - float(data.ring_center[1])
        turn, outside = np.rad2deg(np.arctan2(y, x)).values, (np.hypot(x, y) > 1).values
        held = np.zeros(len(turn), bool)
        for each in range(data.sizes["sector"]):
            one = data.isel(sector=each)
            inside = (turn > one.sector_start.item() - 1e-9) & (
                turn < one.sector_stop.item() + 1e-9
            )
            held |= inside & (outside == bool(one.sector_outside))
        assert held.all()


def test_the_boundaries_pass_through_the_centers_of_the_grid(plotted, sources):
    grid, data = sources["acceleration_centers"].sel(rod_length=5.0), plotted["figure_12"]
    assert data.sizes["force_angle"] == 180  # without the translation along the rod
    angles = grid.force_angle[grid.force_angle != 45]
    stored = grid.sel(inertia_share=[0.0, 1.0], force_angle=angles)
    for xy in "xy":
        here = data[f"exact_center_{xy}"].sel(force_angle=angles)
        assert_allclose(here, stored[f"center_{xy}"].transpose(*here.dims), rtol=1e-13, atol=1e-14)


@pytest.mark.parametrize(
    ("length", "start", "stop", "outside"),
    [
        (2.0, [90, 105, -45, -15], [105, 135, -15, 90], [1, 0, 0, 1]),
        (0.5, [90, -45], [135, 90], [1, 1]),
    ],
)
def test_sectors_meet_and_open_with_the_ring_seen_from_the_contact(length, start, stop, outside):
    found = sectors(length, 45.0, 1.0)
    assert_allclose(found.sector_start, start, rtol=1e-14)
    assert_allclose(found.sector_stop, stop, rtol=1e-14)
    assert sorted(found.sector_outside.values) == sorted(outside)


def test_figure_12_slips_for_a_pusher_just_below_180_degrees(plotted):
    data = plotted["figure_12"]
    assert float(data.conservative_cone_left) < float(data.pusher_angle) < 180
    assert float(data.contact_motion[0]) > float(data.pusher_motion[0])
    assert float(data.contact_motion[1]) == pytest.approx(float(data.pusher_motion[1]))


# -- contact modes -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("modes", "code"),
    [
        ([-1, -1, -1], 0),
        ([1, -1, -1], STICK),
        ([0, 1, 3], SEPARATE | STICK | LEFT),
        ([2, 2, -1], RIGHT),  # two slips of one mode
        ([0, 3, 3], SEPARATE | LEFT),
    ],
)
def test_the_code_of_a_set_of_modes(modes, code):
    found = mode_sets(xr.DataArray(np.array(modes, np.int8), dims="solution"))
    assert found.dtype == np.int8
    assert int(found) == code


def test_the_codes_of_an_array_are_those_of_each_push():
    slider = pp.Slider(rod_length=2.0, rod_angle=np.pi / 4)
    effects = (pp.RingFriction(), pp.Inertia())
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(1.4), effects=effects)
    pushes = xr.DataArray(np.deg2rad(np.arange(-5.0, 40.0)), dims="angle")
    found = pp.solve(scene, pushes, 2.0)
    codes = mode_sets(found["mode"])
    assert codes.dims == ("angle",)
    assert (found.solutions > 2).any()  # two slips of one mode, and no contact
    assert len(np.unique(codes)) > 2
    for given, code in zip(pushes.values, codes.values, strict=True):
        modes = set(pp.solve(scene, float(given), 2.0).modes)
        assert code == sum(1 << mode for mode in modes)


@pytest.mark.parametrize(
    ("contact", "pusher_angle", "modes"),
    [
        ("coulomb_2", -15, SEPARATE | STICK | LEFT),
        ("coulomb_2", -45, SEPARATE),
        ("coulomb_2", 90, STICK),
        ("coulomb_2", 150, RIGHT),
        ("coulomb_0.5", 45, LEFT),
        ("infinite_friction_free", 165, RIGHT),
        ("infinite_friction_none", 165, 0),
        ("perfectly_rough", 165, STICK),
        ("perfectly_rough", -165, SEPARATE | STICK),
    ],
)
def test_sets_of_modes(plotted, contact, pusher_angle, modes):
    here = plotted["figure_13"].modes.sel(contact=contact, pusher_angle=pusher_angle)
    assert int(here.sel(effects="support_friction")) == modes


def test_friction_is_told_by_its_angle(plotted):
    angles = plotted["figure_13"].friction_angle.sel(
        contact=["coulomb_0", "infinite_friction_free"]
    )
    assert angles.values.tolist() == [0, 90]


@pytest.mark.parametrize("place", range(3))
def test_sticking_ends_on_the_line_where_bands_meet(plotted, pictures, place):
    data, ax = plotted["figure_13"], pictures["figure_13"].axes[place]
    slider = pp.Slider(rod_length=float(data.rod_length), rod_angle=np.deg2rad(45))
    kinds = {"support_friction": pp.RingFriction(), "inertia": pp.Inertia()}
    effects = tuple(kinds[each] for each in str(data.effects.values[place]).split("+"))
    for line in ax.lines[:2]:
        for steep, turn in np.transpose(line.get_data())[1:-1]:
            for factor, sticks in ((1 - 1e-9, False), (1 + 1e-9, True)):
                law = pp.Coulomb(factor * np.tan(np.deg2rad(steep)))
                found = pp.solve(
                    pp.Scene(slider=slider, contact=law, effects=effects), np.deg2rad(turn)
                )
                assert (ContactMode.STICK in [each.mode for each in found]) == sticks
    steep, ends = ax.lines[1].get_data()
    corners = np.concatenate([p.vertices for each in ax.collections for p in each.get_paths()])
    for contact in ("coulomb_0.5", "coulomb_2"):
        here = float(data.friction_angle.sel(contact=contact))
        found = corners[np.isclose(corners[:, 0], here)][:, 1]
        assert np.abs(found - np.interp(here, steep, ends)).min() < 0.1


# -- motion over time --------------------------------------------------------------------------------


def test_only_a_slider_at_rest_has_no_motion_center(plotted):
    kept, lost = (plotted["figure_14"].isel(policy=number) for number in (0, 1))
    assert np.isfinite(kept.path_center).all()
    gone = lost.path_mode.values == ContactMode.SEPARATE
    assert (np.isnan(lost.path_center.values).all(axis=-1) == gone).all()


def test_the_contact_is_kept_and_lost(plotted):
    kept, lost = (plotted["figure_14"].isel(policy=number) for number in (0, 1))
    before = kept.time.values < 0.5
    assert (kept.path_mode == ContactMode.STICK).all()
    assert (kept.path_gap == 0).all()
    assert (lost.path_mode.values[~before] == ContactMode.SEPARATE).all()
    assert (np.diff(lost.path_gap.values[~before]) > 0).all()
    assert_allclose(kept.path_rod_angle[before], lost.path_rod_angle[before], rtol=0, atol=1e-12)
    assert (kept.path_solutions.values[~before] > 1).all()


def test_the_center_keeps_its_height_in_slip_with_infinite_friction(plotted):
    slip = plotted["figure_15"]
    height = slip.path_position.sel(xy="y")
    assert_allclose(height, 5 * np.sin(np.deg2rad(45)), rtol=0, atol=1e-11)
    expected = np.sin(np.deg2rad(45)) - slip.time * np.sin(np.deg2rad(165)) / 5
    assert_allclose(slip.sine, expected, rtol=0, atol=1e-12)
    assert_allclose(slip.sine, np.sin(np.deg2rad(slip.path_rod_angle)), rtol=1e-15)


@pytest.mark.parametrize(("name", "frames", "rings"), [("figure_14", 6, 1), ("figure_15", 1, 5)])
def test_the_slider_is_drawn_at_the_instants_inside_its_frame(pictures, name, frames, rings):
    figure = pictures[name]
    sketches = [ax for ax in figure.axes if not ax.axison]
    assert len(sketches) == frames
    for ax in sketches:
        marks = [mark for where, mark, _ in figure.drawn if where is ax]
        circles = [
            mark for mark in marks if len(getattr(mark, "points", ())) > 100 and mark.order == 3.0
        ]
        assert len({mark.color for mark in circles}) == len(circles) == rings
        assert not any(isinstance(mark, Area) for mark in marks)
        (left, right), (bottom, top) = ax.get_xlim(), ax.get_ylim()
        for circle in circles:
            assert ((circle.points > [left, bottom]) & (circle.points < [right, top])).all()
