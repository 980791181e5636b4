"""The study of sliders: its gallery, and its datasets against the public functions and known numbers."""

import json

import numpy as np
import pytest
from planar_pushing.study.datasets.sliders import supports

import planar_pushing as pp
from planar_pushing.study.catalog import DIMS, SLIDERS
from planar_pushing.study.files.scene_model import SupportFrictionEntry
from planar_pushing.study.study_file import load_study

GALLERY = load_study("workflow/config/sliders.yaml")
SMOKE = load_study("workflow/config/sliders_smoke.yaml")


def opened(sliders, name):
    return pp.open_dataset(name, sliders, study="sliders")


def scene(support, length=2.0, angle=45.0, law=None):
    slider = pp.Slider(rod_length=length, rod_angle=np.deg2rad(angle))
    effects = (pp.SupportFriction(support=SMOKE.gallery()[support]),)
    return pp.Scene(slider=slider, contact=law or pp.InfiniteFriction(), effects=effects)


@pytest.mark.parametrize("name", GALLERY.supports)
def test_supports_of_the_gallery_are_about_their_centre_of_pressure_and_of_one_size(name):
    support = GALLERY.gallery()[name]
    assert support.extent == pytest.approx(1.0, abs=2e-16)
    assert np.hypot(*support.center_of_pressure) < 2e-16


@pytest.mark.parametrize("name", SLIDERS)
def test_axes(sliders, name):
    assert tuple(opened(sliders, name).sizes)[: len(DIMS[name])] == DIMS[name]


def test_wrenches_of_a_box_are_the_known_ones():
    """A square of side 2, known from numerical integrals."""
    square = {"shape": "polygon", "vertices": [[-1, -1], [1, -1], [1, 1], [-1, 1]]}
    study = SMOKE.model_validate(
        SMOKE.model_dump()
        | {"supports": {"square": square}}
        | {"grid": SMOKE.grid.model_dump() | {"center_x": [0.3], "center_y": [0.2]}}
    )
    found = supports.build(study).squeeze()
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
def test_modes_are_those_of_each_scene(sliders, name, angle):
    modes = opened(sliders, "support_modes").load()
    here = modes.sel(support=name, rod_length=2, rod_angle=175, friction_coefficient=2)
    one = pp.solve(scene(name, 2.0, 175.0, pp.Coulomb(2.0)), np.deg2rad(angle))
    found = here.sel(pusher_angle=angle)
    assert int(found.outcome) == one.outcome
    assert [str(each) for each in found.mode[found.consistent].values] == [
        m.name for m in one.modes
    ]
    for solution in one:
        row = found.sel(mode=solution.mode.name)
        assert row.pivot == solution.pivot
        assert row.spin == pytest.approx(solution.twist[2], abs=1e-15)
        if solution.mode is not pp.ContactMode.SEPARATE:
            for key, vector in (
                ("force_angle", solution.force),
                ("force_angle_end", solution.force_end),
                ("motion_angle", solution.contact_motion),
            ):
                turn = row[key] - np.rad2deg(np.arctan2(vector[1], vector[0]))
                assert abs((float(turn) + 180) % 360 - 180) < 1e-12, key


def test_a_mode_without_a_solution_has_no_values(sliders):
    modes = opened(sliders, "support_modes").load()
    assert modes.consistent.dtype == bool
    for name in ("force_angle", "force_angle_end", "motion_angle", "spin"):
        assert (modes[name].isnull() == ~modes.consistent).all()
        assert "NaN where the mode is not consistent" in modes[name].attrs["comment"]
    assert (modes.pivot.where(~modes.consistent, -1) == -1).all()
    assert (modes.outcome == modes.consistent.sum("mode").clip(max=2)).all()


def test_a_stick_that_pivots_leaves_an_interval_of_forces(sliders):
    modes = opened(sliders, "support_modes").load().sel(support="tripod", mode="STICK")
    pivots = modes.where(modes.pivot >= 0, drop=True)
    assert pivots.force_angle.notnull().any()
    open_ended = abs(pivots.force_angle_end - pivots.force_angle)
    assert (open_ended.where(pivots.force_angle.notnull()) > 1).any()
