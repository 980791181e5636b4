"""Figures of curves, cones and maps: the numbers they plot, and pictures of the smoke study."""

import contextlib
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from matplotlib.text import Text
from numpy.testing import assert_allclose

from planar_pushing.figures import render
from planar_pushing.figures.figure_12 import sectors
from planar_pushing.figures.figure_13 import LEFT, RIGHT, SEPARATE, STICK
from planar_pushing.figures.style import paper_style
from planar_pushing.study import builders, slices, store, study_file

ROOT = Path(__file__).parents[2]
NAMES = [f"figure_{number}" for number in ("05", "06", "07", "10", "12", "13")]
DATASETS = ("limit_curves", "motion_cones", "acceleration_centers", "contact_modes", "scenes")


@pytest.fixture(scope="module")
def study():
    with contextlib.chdir(ROOT):
        return study_file.load_study("workflow/config/smoke.yaml")


@pytest.fixture(scope="module")
def results(study, tmp_path_factory):
    folder = tmp_path_factory.mktemp("results")
    (folder / "data").mkdir()
    with contextlib.chdir(ROOT):
        for name in DATASETS:
            built = builders.build_dataset(name, slices.study_slice(study, name))
            store.write_dataset(built, folder / "data" / f"{name}.nc")
    return folder


@pytest.fixture(scope="module")
def plotted(study, results):
    return {name: render.select(name, results, study.figures[name]) for name in NAMES}


@pytest.fixture(scope="module")
def pictures(plotted):
    with paper_style():
        return {name: render.picture(name, data) for name, data in plotted.items()}


@pytest.mark.parametrize("name", NAMES)
def test_plotted_numbers_have_units_and_names_and_no_gaps(plotted, name):
    for key, variable in plotted[name].variables.items():
        assert variable.attrs["units"], key
        assert variable.attrs["long_name"], key
        if variable.dtype.kind == "f" and key != "friction_coefficient":
            assert np.isfinite(variable.values).all(), key
    assert plotted[name].attrs["title"]
    assert "Lynch and Mason" in plotted[name].attrs["source"]


@pytest.mark.parametrize("name", NAMES)
def test_plotted_numbers_survive_the_file(plotted, name, tmp_path):
    store.write_dataset(plotted[name], tmp_path / "data.nc")
    xr.testing.assert_identical(store.read_dataset(tmp_path / "data.nc"), plotted[name])


@pytest.mark.parametrize("name", NAMES)
def test_rendering_twice_gives_the_same_bytes(study, results, tmp_path, name):
    suffixes = {"data": "nc", "svg": "svg", "pdf": "pdf", "png": "png"}
    runs = []
    for run in ("first", "second"):
        (tmp_path / run).mkdir()
        paths = {key: tmp_path / run / f"{name}.{end}" for key, end in suffixes.items()}
        render.render(name, results, study.figures[name], **paths)
        runs.append([path.read_bytes() for path in paths.values()])
    assert runs[0] == runs[1]


@pytest.mark.parametrize("name", NAMES)
def test_no_text_is_clipped_or_covered_by_another(pictures, name):
    figure = pictures[name]
    with paper_style():
        figure.draw_without_rendering()
        texts = [each for each in figure.findobj(Text) if each.get_visible() and each.get_text()]
        boxes = [(each.get_text(), each.get_window_extent()) for each in texts]
    for text, box in boxes:
        assert figure.bbox.x0 <= box.x0, text
        assert box.x1 <= figure.bbox.x1, text
        assert figure.bbox.y0 <= box.y0, text
        assert box.y1 <= figure.bbox.y1, text
    for (one, first), (other, second) in combinations(boxes, 2):
        assert not first.padded(-1).overlaps(second.padded(-1)), (one, other)


@pytest.mark.parametrize("name", NAMES[:-1])
def test_pictures_keep_right_angles_and_circles(pictures, name):
    assert all(ax.get_aspect() == 1.0 for ax in pictures[name].axes)


class TestFigure05:
    def test_without_a_rod_the_curve_is_a_circle(self, plotted):
        curve = plotted["figure_05"].sel(rod_length=0.0)
        assert_allclose(np.hypot(curve.force_x, curve.force_y), 1, rtol=1e-15)

    def test_velocity_is_parallel_to_the_four_special_forces(self, plotted):
        data = plotted["figure_05"]
        assert data.parallel_angle.values.tolist() == [45, 135, 225, 315]
        angles = data.parallel_motion_angle.broadcast_like(data.parallel_force)
        assert_allclose(angles, data.parallel_angle.broadcast_like(angles), rtol=1e-13)

    def test_infinite_rod_is_the_segment_along_it(self, plotted):
        half = np.sqrt(0.5)
        assert_allclose(plotted["figure_05"].infinite_rod_x, [half, -half], rtol=1e-14)
        assert_allclose(plotted["figure_05"].infinite_rod_y, [half, -half], rtol=1e-14)


class TestFigure06:
    def test_edges_of_the_cones_are_the_published_ones(self, plotted):
        data = plotted["figure_06"]
        forces = [90 - np.rad2deg(np.arctan(2)), 45, 90, 90 + np.rad2deg(np.arctan(2))]
        assert_allclose(data.mapped_force_angle, forces, rtol=1e-14)
        edges = data.mapped_motion_angle.isel(map=[0, -1])
        assert_allclose(edges, [-20.038457551638, 140.16416973393], rtol=1e-12)

    def test_force_along_the_rod_translates_the_slider(self, plotted):
        assert float(plotted["figure_06"].mapped_motion_angle[1]) == pytest.approx(45, rel=1e-14)

    def test_mapped_forces_lie_at_their_angles(self, plotted):
        data = plotted["figure_06"]
        angles = np.rad2deg(np.arctan2(data.mapped_force_y, data.mapped_force_x))
        assert_allclose(angles, data.mapped_force_angle, rtol=1e-13)


def test_figure_07_cones_are_the_published_ones(plotted):
    data = plotted["figure_07"]
    published = {1.0: 158.70186040475, 2.0: 148.61039132208, 5.0: 138.83997216476}
    assert_allclose(data.motion_cone_left, [*published.values()], rtol=1e-12)
    assert_allclose(data.motion_cone_left - data.motion_cone_right, 180, rtol=1e-13)


class TestFigure10:
    def test_ellipses_have_their_minor_axis_across_the_rod(self, plotted):
        data = plotted["figure_10"].sel(force_angle=[45.0, 135.0])
        lengths = data.rod_length.values
        size = np.hypot(data.force_x, data.force_y)
        assert_allclose(size.isel(force_angle=0), 1, rtol=1e-14)
        assert_allclose(size.isel(force_angle=1), 1 / np.sqrt(1 + lengths**2), rtol=1e-14)

    def test_accelerations_are_those_of_the_equations(self, plotted):
        data = plotted["figure_10"]
        phi = np.deg2rad(data.mapped_force_angle.values)
        x, y = np.cos(phi), np.sin(phi)  # Eqs. (11) and (12) for l = 1, psi = 45 degrees
        angle = np.rad2deg(np.arctan2(1.5 * y - 0.5 * x, 1.5 * x - 0.5 * y))
        assert_allclose(data.mapped_motion_angle, angle, rtol=1e-12)


class TestFigure12:
    def test_cones_are_the_published_ones(self, plotted):
        data = plotted["figure_12"]
        exact = float(data.exact_cone_right), float(data.exact_cone_left)
        assert exact == pytest.approx((-42.797401838234, 138.83997216476), rel=1e-12)
        bound = float(data.conservative_cone_right), float(data.conservative_cone_left)
        assert bound == pytest.approx((-45, 142.06), abs=0.01)

    def test_exact_centers_lie_in_the_papers_sectors(self, plotted):
        data = plotted["figure_12"]
        for _, centers in data[["exact_center_x", "exact_center_y"]].groupby("inertia_share"):
            x = centers.exact_center_x.squeeze() - float(data.ring_center[0])
            y = centers.exact_center_y.squeeze() - float(data.ring_center[1])
            angle, outside = np.rad2deg(np.arctan2(y, x)).values, (np.hypot(x, y) > 1).values
            held = np.zeros(len(angle), bool)
            for each in range(data.sizes["sector"]):
                one = data.isel(sector=each)
                inside = (angle > one.sector_start.item() - 1e-9) & (
                    angle < one.sector_stop.item() + 1e-9
                )
                held |= inside & (outside == bool(one.sector_outside))
            assert held.all()

    def test_sectors_meet_and_open_with_the_ring_seen_from_the_contact(self):
        found = sectors(2.0, 45.0, 1.0)
        assert_allclose(found.sector_start, [90, 105, -45, -15], rtol=1e-14)
        assert_allclose(found.sector_stop, [105, 135, -15, 90], rtol=1e-14)

    def test_contact_inside_the_ring_leaves_sectors_outside_of_it_alone(self):
        found = sectors(0.5, 45.0, 1.0)
        assert found.sector_outside.values.tolist() == [1, 1]
        assert_allclose(found.sector_start, [90, -45], rtol=1e-14)
        assert_allclose(found.sector_stop, [135, 90], rtol=1e-14)

    def test_scene_slips_for_a_pusher_just_below_180_degrees(self, plotted):
        data = plotted["figure_12"]
        assert float(data.conservative_cone_left) < float(data.pusher_angle) < 180
        assert float(data.contact_motion[0]) > float(data.pusher_motion[0])
        assert float(data.contact_motion[1]) == pytest.approx(float(data.pusher_motion[1]))


class TestFigure13:
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
    def test_sets_of_modes(self, plotted, contact, pusher_angle, modes):
        here = plotted["figure_13"].modes.sel(contact=contact, pusher_angle=pusher_angle)
        assert int(here.sel(effects="support_friction")) == modes

    def test_friction_is_told_by_its_angle(self, plotted):
        data = plotted["figure_13"]
        angles = data.friction_angle.sel(contact=["coulomb_0", "infinite_friction_free"])
        assert angles.values.tolist() == [0, 90]
