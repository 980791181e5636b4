"""The study of sliders: its gallery, and its datasets against the public functions and known numbers."""

import json

import numpy as np
import pytest
from study.conftest import OF_SLIDERS

import planar_pushing as pp
from planar_pushing.scenes.scene_model import SupportFrictionEntry
from pulling_by_pushing.study.catalog import DATASETS
from pulling_by_pushing.study.running.build import build_dataset
from pulling_by_pushing.study.study_file import load_study

GALLERY = load_study("workflow/config/sliders.yaml")
SMOKE = load_study("workflow/config/sliders_smoke.yaml")


def opened(sliders, name):
    return pp.open_dataset(name, sliders, study="sliders")


def scene(support, length=2.0, angle=45.0, law=None):
    slider = pp.Slider(rod_length=length, rod_angle=np.deg2rad(angle))
    effects = (pp.SupportFriction(support=SMOKE.gallery()[support]),)
    return pp.Scene(slider=slider, contact=law or pp.InfiniteFriction(), effects=effects)


@pytest.mark.parametrize("name", GALLERY.supports)
def test_supports_of_the_gallery_are_about_their_center_of_pressure_and_of_one_size(name):
    support = GALLERY.gallery()[name]
    assert support.extent == pytest.approx(1.0, abs=2e-16)
    assert np.hypot(*support.center_of_pressure) < 2e-16


@pytest.mark.parametrize("name", OF_SLIDERS)
def test_axes_and_variables_are_those_that_are_declared(sliders, name):
    dataset, entry = opened(sliders, name), DATASETS[name]
    assert set(dataset.sizes) == {*entry.dims, *entry.inner}
    assert tuple(dataset.sizes)[: len(entry.dims)] == entry.dims
    assert tuple(dataset.data_vars) == entry.variables


def test_wrenches_of_a_box_are_the_known_ones():
    """A square of side 2, known from numerical integrals."""
    square = {"shape": "polygon", "vertices": [[-1, -1], [1, -1], [1, 1], [-1, 1]]}
    grid = {"support": ["square"], "center_x": [0.3], "center_y": [0.2]}
    values = {"slider": {"rod_angle": 45}, "supports": {"square": square}, "grid": grid}
    found = build_dataset("supports", values).squeeze()
    g_x, g_y = -0.260676603222042, -0.172647824905904
    assert found.mean_distance == pytest.approx(0.822023641611253, rel=1e-14, abs=0)
    assert found.force_x == pytest.approx(-g_y, rel=1e-14, abs=0)
    assert found.force_y == pytest.approx(g_x, rel=1e-14, abs=0)
    assert found.torque == pytest.approx(0.709291095663460, rel=1e-14, abs=0)
    assert found.integration_constant == pytest.approx(0.541075, rel=1e-6)


def test_supports_say_what_they_are(sliders):
    found = opened(sliders, "supports")
    for name, text in zip(found.support.values, found.description.values, strict=True):
        entry = SupportFrictionEntry(type="support_friction", support=json.loads(text))
        assert entry.build().support == SMOKE.gallery()[name]
    assert (found.extent == 1).all()
    fit = pp.fit_ellipsoid(SMOKE.gallery()["box"])
    box = found.sel(support="box")
    np.testing.assert_array_equal(box.ellipsoid, fit.matrix)
    assert box.worst_motion_error == np.rad2deg(fit.worst_motion_error)


@pytest.mark.parametrize("name", SMOKE.supports)
def test_cones_are_those_of_each_scene(sliders, name):
    cones = opened(sliders, "support_cones").sel(support=name, rod_length=2, rod_angle=175)
    for mu, law in ((0.25, pp.Coulomb(0.25)), (np.inf, pp.InfiniteFriction())):
        here, one = cones.sel(friction_coefficient=mu), scene(name, 2.0, 175.0, law)
        expected = pp.motion_cone(one)
        edges = np.rad2deg([expected.right, expected.left])
        np.testing.assert_allclose(here.motion_angle, edges, atol=1e-12)
        assert here.width == pytest.approx(float(np.diff(edges)[0]), abs=1e-12)
        assert bool(here.pulls) == bool(pp.can_pull(one))
        assert bool(here.slips_while_pushing) == bool(pp.slips_while_pushing(one))


def test_both_edges_of_a_cone_without_width_pivot_about_one_point(sliders):
    cones = opened(sliders, "support_cones").sel(support="tripod", rod_length=2, rod_angle=175)
    narrow = cones.sel(friction_coefficient=0.25)
    assert (narrow.pivot == 0).all()
    assert narrow.width == pytest.approx(0, abs=1e-12)
    areas = opened(sliders, "support_cones").sel(support=["ring", "box"])
    assert (areas.pivot == -1).all()


@pytest.mark.parametrize("name", SMOKE.supports)
@pytest.mark.parametrize("angle", [-45, 0, 45, 90, 180])
def test_modes_are_the_solutions_of_each_scene(sliders, name, angle):
    modes = opened(sliders, "support_modes").load()
    here = modes.sel(support=name, rod_length=2, rod_angle=175, friction_coefficient=2)
    one = pp.solve(scene(name, 2.0, 175.0, pp.Coulomb(2.0)), np.deg2rad(angle))
    found = here.sel(pusher_angle=angle)
    assert (int(found.outcome), int(found.status)) == (one.outcome, one.status)
    assert found["mode"].values[found.consistent.values].tolist() == list(one.modes)
    for i, solution in enumerate(one):
        row = found.isel(solution=i)
        assert row.pivot == solution.pivot
        for key in ("force", "force_end", "contact_motion", "twist"):
            np.testing.assert_allclose(row[key], getattr(solution, key), rtol=1e-12, atol=1e-14)


def test_places_behind_the_last_solution_have_no_values(sliders):
    modes = opened(sliders, "support_modes").load()
    assert modes.consistent.dtype == bool
    for name in ("force", "force_end", "contact_motion", "twist"):
        assert (modes[name].isnull() == ~modes.consistent).all(), name
    assert (modes.pivot.where(~modes.consistent, -1) == -1).all()
    assert (modes.outcome == modes.consistent.sum("solution").clip(max=2)).all()


def test_a_stick_that_pivots_leaves_an_interval_of_forces(sliders):
    modes = opened(sliders, "support_modes").load().sel(support="tripod")
    pivots = (modes.pivot >= 0) & (modes["mode"] == pp.ContactMode.STICK)
    assert pivots.any()
    apart = np.hypot(*(modes.force_end - modes.force).transpose("xy", ...)).values
    assert apart[pivots.values].max() > 0.01
    assert (apart[(modes.consistent & (modes.pivot < 0)).values] == 0).all()


def test_the_default_grid_has_no_coefficient_at_a_kink():
    """A foot of the quadruped takes its share to all digits at 0.5; edges are along rods at 0 and 1."""
    assert not {0, 0.5, 1} & set(GALLERY.grid.friction_coefficient)
    assert {-179, -1} <= {*GALLERY.grid.pusher_angle}
