"""Datasets with a grid of their own: curves and maps of contact modes."""

import numpy as np
import pytest
import xarray as xr
from numpy.testing import assert_allclose

import planar_pushing as pp
from planar_pushing.mechanics.contact import ContactMode
from pulling_by_pushing.study.datasets.mode_maps import mode_sets
from pulling_by_pushing.study.model import Grid
from pulling_by_pushing.study.running.build import build_dataset
from pulling_by_pushing.study.slices import computes, study_slice
from pulling_by_pushing.study.study_file import load_study

STUDY = load_study("workflow/config/smoke.yaml")
SEPARATE, STICK, RIGHT, LEFT = (1 << mode for mode in ContactMode)
EFFECTS = {"support_friction": pp.RingFriction(), "inertia": pp.Inertia()}


@pytest.fixture(scope="module")
def maps(results):
    return pp.open_dataset("mode_maps", results)


def test_a_fine_grid_replaces_the_axes_that_it_gives_and_no_others():
    fine = {"curves": Grid(rod_length=(2.0,))}
    study = STUDY.model_copy(update={"fine_grids": fine})
    assert study.values("rod_length", "curves") == (2.0,)
    assert study.values("force_angle", "curves") == study.grid.force_angle
    assert study.values("rod_length", "limit_curves") == study.grid.rod_length
    assert study.axis_key("rod_length", "curves") == "fine_grids.curves.rod_length"
    assert study.axis_key("force_angle", "curves") == "grid.force_angle"
    assert computes(study, "curves")
    assert not computes(study, "mode_maps")


def test_curves_pass_through_the_limit_curves():
    grid, fine = (
        build_dataset(name, study_slice(STUDY, name)) for name in ("limit_curves", "curves")
    )
    stored = grid.sel(rod_angle=STUDY.slider.rod_angle)
    for name in fine.data_vars:
        line = fine[name].sel(force_angle=grid.force_angle)
        assert_allclose(line, stored[name].transpose(*line.dims), rtol=1e-13, atol=1e-15)


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
def test_sets_of_modes(maps, contact, pusher_angle, modes):
    here = maps.modes.sel(contact=contact, pusher_angle=pusher_angle, effects="support_friction")
    assert int(here.squeeze()) == modes


@pytest.mark.parametrize("contact", ["coulomb_0.5", "coulomb_1.4", "infinite_friction_free"])
@pytest.mark.parametrize("name", STUDY.grid.effects)
def test_sticking_ends_at_the_furthest_pull(maps, name, contact):
    edge = float(maps.furthest_pull.sel(effects=name, contact=contact).squeeze())
    law = pp.InfiniteFriction() if "infinite" in contact else pp.Coulomb(float(contact[8:]))
    scene = pp.Scene(
        slider=pp.Slider(rod_length=2.0, rod_angle=np.pi / 4), contact=law,
        effects=tuple(EFFECTS[each] for each in name.split("+")),
    )  # fmt: skip
    for beside, sticks in ((-1e-9, False), (1e-9, True)):
        modes = pp.solve(scene, np.deg2rad(edge) + beside, 1.0).modes
        assert (ContactMode.STICK in modes) == sticks


def test_perfect_roughness_has_no_furthest_pull(maps):
    rough = maps.furthest_pull.sel(contact="perfectly_rough")
    assert np.isnan(rough).all()
    assert np.isfinite(maps.furthest_pull).sum() == maps.furthest_pull.size - rough.size


def test_under_one_effect_the_furthest_pull_is_the_edge_of_the_motion_cone(maps):
    cones = build_dataset("motion_cones", study_slice(STUDY, "motion_cones"))
    cones = cones.sel(rod_length=2.0, rod_angle=45.0, friction_coefficient=2.0)
    for name in EFFECTS:
        pull = maps.furthest_pull.sel(effects=name, contact="coulomb_2").squeeze()
        edge = cones.motion_cone_right.sel(effects=name)
        assert float(pull) == pytest.approx(float(edge), rel=1e-13, abs=0)


def test_the_sticking_force_is_that_of_a_perfectly_rough_contact(maps):
    angle = maps.sticking_force_angle.sel(effects="inertia", pusher_angle=45.0).squeeze()
    assert float(angle) == pytest.approx(45.0, rel=1e-14)  # along the rod
