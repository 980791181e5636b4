"""The datasets: names, axes, and modes as `solve` has them."""

import numpy as np
import pytest
import xarray as xr
from study.conftest import OF_PAPER

import planar_pushing as pp
from planar_pushing.terms.netcdf import group_names
from pulling_by_pushing.study.catalog import DATASETS
from pulling_by_pushing.study.model import labeled_law
from pulling_by_pushing.study.running.build import build_dataset
from pulling_by_pushing.study.slices import study_slice
from pulling_by_pushing.study.study_file import load_study


def test_components_of_an_ellipsoid_have_the_units_that_are_stated(sliders):
    """A support that is ten times as large: the matrix changes by the lengths in its units."""
    dataset = pp.open_dataset("supports", sliders, study="sliders")
    powers = {"1": 0, "length": 1, "1/length": -1}
    exponent = np.subtract.outer(
        [powers[unit] for unit in dataset.twist_unit.values],
        [powers[unit] for unit in dataset.wrench_unit.values],
    )
    corners = np.array([(0.0, 0.0), (3.0, 0.0), (2.0, 1.0), (0.0, 2.0)])
    one, ten = (pp.fit_ellipsoid(pp.Polygon(size * corners)).matrix for size in (1.0, 10.0))
    np.testing.assert_allclose(ten, one * 10.0**exponent, rtol=1e-9, atol=1e-12)
    assert dataset.ellipsoid.attrs["component_units"] == "twist_unit/wrench_unit"
    assert "units" not in dataset.ellipsoid.attrs


def test_components_of_a_twist_have_the_units_that_are_stated(results):
    """The same scene in a unit of length a tenth as large, solved again."""
    dataset = pp.open_dataset(MODES, results)
    powers = {"motion": 1, "radian motion/length": 0}
    exponent = [powers[unit] for unit in dataset.twist_unit.values]
    contact, effects = pp.Coulomb(0.5), (pp.RingFriction(),)
    twists = [
        pp.solve(
            pp.Scene(
                slider=pp.Slider(rod_length=2 * size, rod_angle=0.8, radius=size),
                contact=contact, effects=effects,
            ),
            1.2, size,
        )[0].twist
        for size in (1.0, 10.0)
    ]  # fmt: skip
    np.testing.assert_allclose(twists[1], twists[0] * 10.0 ** np.array(exponent), rtol=1e-12)
    assert "units" not in dataset.twist.attrs


@pytest.mark.parametrize("name", OF_PAPER)
def test_axes_and_variables_are_those_that_are_declared(results, name):
    dataset, entry = pp.open_dataset(name, results), DATASETS[name]
    assert tuple(dataset.sizes) == (*entry.dims, *entry.inner)
    assert tuple(dataset.data_vars) == entry.variables


def test_scenes_have_a_group_each(results):
    figures = ["02", "03", "08", "09a", "09b", "11", "12"]
    assert group_names(results / "data/scenes.nc") == [f"figure_{each}" for each in figures]


#: Dataset of solutions: numbers behind the last solution have no value.
MODES = "contact_modes"


def test_no_nan(every):
    """But for the motion center of a slider at rest."""
    for name, dataset in every:
        for key, variable in dataset.data_vars.items():
            if variable.dtype.kind == "f" and name != MODES:
                nan = np.isnan(variable.values)
                if key == "center":
                    assert (nan == ~dataset.twist.values.any(axis=-1)[:, None]).all(), name
                elif key == "furthest_pull":  # perfectly rough contact has none
                    assert set(dataset.contact.values[nan.any((0, 2, 3))]) == {"perfectly_rough"}
                else:
                    assert not nan.any(), f"{name}: {key}"


def test_places_behind_the_last_solution_have_no_values(results):
    modes = pp.open_dataset(MODES, results).load()
    assert modes.sizes["solution"] == modes.solutions.max()
    held = xr.DataArray(np.arange(modes.sizes["solution"]), dims="solution") < modes.solutions
    assert (modes.consistent == held).all()
    assert ((modes["mode"] == -1) == ~held).all()
    assert modes["mode"].attrs["comment"] == "-1 after the last solution"
    for name in ("force", "twist", "contact_motion", "spin_ratio"):
        assert (modes[name].isnull() == ~held).all(), name
    rests = (modes.twist == 0).all("twist_component")
    assert (modes.center.isnull() == (~held | rests)).all()
    assert (modes.outcome == modes.solutions.clip(max=2)).all()


@pytest.mark.parametrize(
    ("name", "variable"),
    [("motion_cones", "pulls"), ("motion_cones", "slips_while_pushing"), ("scenes/figure_08", "adhesive"),
     ("simulations/slipping", "adhesive")],
)  # fmt: skip
def test_truth_values_are_bool(results, name, variable):
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


def test_centers_have_one_origin(results):
    centers = pp.open_dataset("acceleration_centers", results)
    here = centers.sel(rod_length=5, force_angle=60, inertia_share=0.5)
    slider = pp.Slider(rod_length=5, rod_angle=np.pi / 4)
    scene = pp.Scene(
        slider=slider, contact=pp.InfiniteFriction(), effects=(pp.RingFriction(), pp.Inertia())
    )
    expected = pp.motion_centers(scene, np.deg2rad(60), 0.5)
    np.testing.assert_allclose([here.center_x, here.center_y], expected, rtol=1e-14)


@pytest.mark.parametrize("contact", ["coulomb_1.4", "infinite_friction_none", "perfectly_rough"])
@pytest.mark.parametrize("effects", ["inertia", "support_friction+inertia"])
def test_modes_are_the_solutions_of_solve(results, effects, contact):
    modes = pp.open_dataset(MODES, results).load()
    here = modes.sel(effects=effects, contact=contact, rod_length=2, pusher_magnitude=1)
    kinds = {"support_friction": pp.RingFriction(), "inertia": pp.Inertia()}
    slider = pp.Slider(rod_length=2, rod_angle=np.pi / 4)
    listed = tuple(kinds[each] for each in effects.split("+"))
    scene = pp.Scene(slider=slider, contact=labeled_law(contact), effects=listed)
    for angle in (-165, -15, 0, 15, 90, 165, 180):
        found, one = pp.solve(scene, np.deg2rad(angle)), here.sel(pusher_angle=angle)
        assert int(one.outcome) == found.outcome
        assert int(one.status) == found.status
        assert int(one.solutions) == len(found)
        for i, solution in enumerate(found):
            row = one.isel(solution=i)
            assert row["mode"] == solution.mode
            for name in ("force", "force_end", "twist", "contact_motion", "center", "spin_ratio"):
                np.testing.assert_array_equal(row[name], getattr(solution, name), err_msg=name)


def test_the_study_of_the_paper_holds_two_slips_of_one_mode():
    study = load_study("workflow/config/paper.yaml")
    grid = {"contact": ["coulomb_1.4"], "rod_length": [2.0], "pusher_magnitude": [2.0]}
    values = study_slice(study, MODES)
    for name, chosen in grid.items():
        assert set(chosen) <= set(values["grid"][name])
    values["grid"] |= grid
    modes = build_dataset(MODES, values).sel(effects="support_friction+inertia").squeeze()
    twice = [(modes["mode"] == slip).sum("solution") > 1 for slip in (2, 3)]
    assert modes.pusher_angle[twice[0] | twice[1]].values.tolist() == [-1]
