"""The datasets: names, axes, and modes as `solve` has them."""

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.study.catalog import AXES, DIMS
from planar_pushing.study.datasets.contact_modes import contacts
from planar_pushing.study.store import group_names
from planar_pushing.study.study_file import load_study

NAMED = {
    "limit_curves": {"force", "force_x", "force_y", "spin_ratio", "motion_angle"},
    "motion_cones": {
        "friction_cone_right", "friction_cone_left", "motion_cone_right", "motion_cone_left",
        "pulls", "slips_while_pushing",
    },
    "contact_modes": {"consistent", "outcome", "spin_ratio", "force_angle"},
    "acceleration_centers": {
        "center_x", "center_y", "motion_angle", "conservative_cone_right",
        "conservative_cone_left", "exact_cone_right", "exact_cone_left",
    },
    "center_regions": {"bound_x", "bound_y", "exact_x", "exact_y"},
}  # fmt: skip


@pytest.mark.parametrize("name", AXES)
def test_axes_and_variables(results, name):
    dataset = pp.open_dataset(name, results)
    assert tuple(dataset.sizes) == DIMS[name]
    assert set(dataset.data_vars) >= NAMED[name]


def test_scenes_have_a_group_each(results):
    figures = ["02", "03", "08", "09a", "09b", "11", "12"]
    assert group_names(results / "data/scenes.nc") == [f"figure_{each}" for each in figures]


#: What has no value where a mode has no solution.
OF_A_MODE = ("spin_ratio", "force_angle", "spin_ratio_fast", "force_angle_fast")


def test_no_nan(every):
    for name, dataset in every:
        for key, variable in dataset.data_vars.items():
            if variable.dtype.kind == "f" and (name, key) not in {
                ("contact_modes", each) for each in OF_A_MODE
            }:
                assert not np.isnan(variable.values).any(), f"{name}: {key}"


@pytest.mark.parametrize("name", OF_A_MODE)
def test_a_mode_without_a_solution_has_no_values(results, name):
    modes = pp.open_dataset("contact_modes", results)
    assert (modes[name].isnull() == (modes.consistent == 0)).all()
    assert "NaN where the mode is not consistent" in modes[name].attrs["comment"]
    rest = modes[name].sel(mode="SEPARATE")
    assert (rest.where(rest.notnull(), 0) == 0).all()


@pytest.mark.parametrize(
    ("name", "variable"),
    [("motion_cones", "pulls"), ("motion_cones", "slips_while_pushing"), ("scenes/figure_08", "adhesive"),
     ("simulations/figure_15", "adhesive")],
)  # fmt: skip
def test_what_is_true_or_false_is_bool(results, name, variable):
    found = pp.open_dataset(name, results)[variable]
    assert found.dtype == bool
    assert ((~found) == np.logical_not(found)).all()


def test_grids_have_a_finite_friction_angle(results):
    cones = pp.open_dataset("motion_cones", results)
    assert list(cones.friction_angle.sel(friction_coefficient=[0, np.inf])) == [0, 90]
    assert np.isfinite(cones.friction_angle).all()
    one = cones.motion_cone_left.isel(effects=0, rod_length=2, rod_angle=0)
    assert one.plot(x="friction_angle")


def test_perfect_roughness_is_no_infinite_friction(results):
    modes = pp.open_dataset("contact_modes", results).set_index(contact="law")
    for name in ("friction_coefficient", "friction_angle"):
        assert np.isnan(modes[name].sel(contact="perfectly_rough"))
    assert np.isinf(modes.friction_coefficient.sel(contact="infinite_friction")).all()
    assert (modes.friction_angle.sel(contact="infinite_friction") == 90).all()


def test_centres_have_one_origin(results):
    centers = pp.open_dataset("acceleration_centers", results)
    here = centers.sel(rod_length=5, force_angle=60, inertia_share=0.5)
    slider = pp.Slider(rod_length=5, rod_angle=np.pi / 4)
    scene = pp.Scene(
        slider=slider, contact=pp.InfiniteFriction(), effects=(pp.RingFriction(), pp.Inertia())
    )
    expected = pp.motion_centers(scene, np.deg2rad(60), 0.5)
    np.testing.assert_allclose([here.center_x, here.center_y], expected, rtol=1e-14)


def test_modes_agree_with_solve(results):
    modes = pp.open_dataset("contact_modes", results)
    laws = {"coulomb_1.4": pp.Coulomb(1.4), "infinite_friction_none": pp.InfiniteFriction("none")}
    effects = {
        "inertia": (pp.Inertia(),),
        "support_friction+inertia": (pp.RingFriction(), pp.Inertia()),
    }
    for contact, law in laws.items():
        for name, listed in effects.items():
            slider = pp.Slider(rod_length=2, rod_angle=np.pi / 4)
            scene = pp.Scene(slider=slider, contact=law, effects=listed)
            for angle in (-165, -15, 0, 15, 90, 165, 180):
                here = modes.sel(
                    effects=name,
                    contact=contact,
                    rod_length=2,
                    pusher_magnitude=1,
                    pusher_angle=angle,
                )
                found = pp.solve(scene, np.deg2rad(angle))
                assert int(here.outcome) == found.outcome
                for mode in pp.ContactMode:
                    count = int(here.consistent.sel(mode=mode.name))
                    assert count == found.modes.count(mode)


def test_laws_of_close_coefficients_have_labels_of_their_own():
    study = load_study("workflow/config/smoke.yaml")
    grid = study.grid.model_copy(update={"contact_friction_coefficient": (1.4, 1.4000001, 2.0)})
    labels = list(contacts(study.model_copy(update={"grid": grid})))
    assert labels[:3] == ["coulomb_1.4", "coulomb_1.4000001", "coulomb_2"]
