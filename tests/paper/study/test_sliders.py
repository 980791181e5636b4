"""The study of sliders: its gallery, and its datasets against the public functions and known numbers."""

import json

import numpy as np
import pytest
from mechanics.supports.cases import TRIPOD
from pydantic import TypeAdapter
from study.conftest import OF_SLIDERS

import planar_pushing as pp
from planar_pushing.scenes.entries import SupportEntry
from pulling_by_pushing.study.catalog import DATASETS
from pulling_by_pushing.study.datasets.support_motions import pulling_friction_angle, scene_of
from pulling_by_pushing.study.running.build import build_dataset
from pulling_by_pushing.study.study_file import load_study

GALLERY = load_study("workflow/config/sliders.yaml")
SMOKE = load_study("workflow/config/sliders_smoke.yaml")
QUADRUPED = GALLERY.gallery()["quadruped"]


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
        entry = TypeAdapter(SupportEntry).validate_python(json.loads(text))
        assert entry.build() == SMOKE.gallery()[name]
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


def test_limit_curves_are_those_of_each_scene(sliders):
    curves = opened(sliders, "support_curves")
    assert (curves.rod_length, curves.rod_angle, curves.radius) == (2, 45, 1)
    np.testing.assert_allclose(curves.force.sel(support="ring"), curves.ring_force, rtol=1e-14)
    for name in SMOKE.supports:
        here, one = curves.sel(support=name, force_angle=[30, 100, 260]), scene(name)
        expected = pp.limit_curve(one, np.deg2rad(here.force_angle.values))
        np.testing.assert_allclose(here.force, expected.magnitude, rtol=1e-13)
        np.testing.assert_allclose(here.motion_angle, np.rad2deg(expected.motion_angle), rtol=1e-13)


def test_limit_curves_are_convex_and_straight_where_the_slider_pivots(sliders):
    curves = opened(sliders, "support_curves")
    angle = np.deg2rad(curves.force_angle.values)
    for name in SMOKE.supports:
        one = curves.sel(support=name)
        x, y = np.diff(one.force.values * [np.cos(angle), np.sin(angle)])
        turns, pivot = x[:-1] * y[1:] - y[:-1] * x[1:], one.pivot.values
        assert (turns > -1e-12).all(), name
        flat = (pivot[:-2] >= 0) & (pivot[:-2] == pivot[2:])
        assert (np.abs(turns[flat]) < 1e-12).all()
        assert flat.any() == (name == "tripod")
        assert np.diff(one.motion_angle)[1:][flat] == pytest.approx(0, abs=1e-11)


def test_rods_are_those_of_two_sweeps(sliders):
    rods = opened(sliders, "support_rods")
    grid = SMOKE.fine_grids["support_rods"]
    for sweep, other, value in (("rod_length", "rod_angle", 45), ("rod_angle", "rod_length", 2)):
        part = rods.isel(rod=rods.sweep.values == sweep)
        assert tuple(part[sweep].values) == getattr(grid, sweep)
        assert (part[other] == value).all()


@pytest.mark.parametrize("name", SMOKE.supports)
def test_cones_of_the_rods_are_those_of_each_scene(sliders, name):
    rods = opened(sliders, "support_rods").sel(support=name)
    for index in (0, 5, 40, 150):
        one = rods.isel(rod=index)
        expected = pp.motion_cone(scene(name, float(one.rod_length), float(one.rod_angle)))
        edges = np.rad2deg([expected.right, expected.left])
        np.testing.assert_allclose(one.motion_angle, edges, atol=1e-12)


def least_friction(support, length, angle):
    rod = length, angle, pp.PerfectlyRough()
    friction = pulling_friction_angle(scene_of(support, *rod))
    return float(np.tan(np.deg2rad(friction)))


def can_pull(support, length, angle, mu):
    return bool(pp.can_pull(scene_of(support, length, angle, pp.Coulomb(mu))))


@pytest.mark.parametrize(
    ("support", "length", "angle"),
    [(pp.Ring(1.0), 2.0, 45.0), (pp.Disc(1.0), 0.5, 120.0), (TRIPOD, 2.0, 88.0), (TRIPOD, 1.0, 45.0),
     (QUADRUPED, 2.0, 79.0), (QUADRUPED, 2.0, 77.0), (pp.Segment((-1, 0), (1, 0)), 3.0, 60.0)],
)  # fmt: skip
def test_pulling_begins_at_the_least_friction(support, length, angle):
    least = least_friction(support, length, angle)
    assert not can_pull(support, length, angle, (1 - 1e-9) * least)
    assert can_pull(support, length, angle, (1 + 1e-9) * least)


@pytest.mark.parametrize("support", [pp.Ring(1.0), TRIPOD, QUADRUPED, pp.Segment((0, -1), (0, 1))])
def test_about_an_upright_rod_a_support_that_mirrors_itself_is_never_pulled(support):
    upright = scene_of(support, 2.0, 90.0, pp.InfiniteFriction())
    assert pulling_friction_angle(upright) == 90.0
    assert not bool(pp.can_pull(upright))


def test_the_least_friction_of_the_ring_is_known(sliders):
    rods = opened(sliders, "support_rods")
    at_45 = rods.isel(rod=(rods.rod_angle.values == 45) & (rods.rod_length.values == 2))
    friction = np.tan(np.deg2rad(at_45.ring_pulling_friction_angle))
    assert friction.values == pytest.approx([1.26987543] * 2, rel=1e-8)


def test_inertia_alone_needs_the_friction_of_a_closed_form(sliders):
    """Eqs. (11)-(13) give the force that moves the contact along the fence; rho is the radius, 1."""
    rods = opened(sliders, "support_rods")
    length, angle = rods.rod_length.values, np.deg2rad(rods.rod_angle.values)
    c, s = np.cos(angle), np.sin(angle)
    expected = np.rad2deg(np.arctan2(1 + (length * c) ** 2, np.abs(length**2 * s * c)))
    np.testing.assert_allclose(rods.inertia_pulling_friction_angle, expected, atol=1e-12)


def test_the_default_grid_has_no_coefficient_at_a_kink():
    """A foot of the quadruped takes its share to all digits at 0.5; edges are along rods at 0 and 1."""
    assert not {0, 0.5, 1} & set(GALLERY.grid.friction_coefficient)
    assert {-179, -1} <= {*GALLERY.grid.pusher_angle}
