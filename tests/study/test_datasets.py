"""The datasets: names, axes, units, provenance, and bytes that depend on their content alone."""

import json
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import planar_pushing as pp
from planar_pushing.mechanics.quantities import DATASET
from planar_pushing.simulation.scene_file import simulate_file
from planar_pushing.study.builders import build_dataset
from planar_pushing.study.catalog import DATASETS
from planar_pushing.study.datasets.contact_modes import contacts
from planar_pushing.study.dictionary import dictionary_text
from planar_pushing.study.files import load_scene_file
from planar_pushing.study.slices import study_slice
from planar_pushing.study.store import group_names, write_dataset
from planar_pushing.study.study_file import load_study

DIMS = {
    "limit_curves": ("effects", "rod_length", "rod_angle", "force_angle"),
    "motion_cones": ("effects", "rod_length", "rod_angle", "friction_coefficient"),
    "contact_modes": (
        "effects", "contact", "rod_length", "pusher_magnitude", "pusher_angle", "mode",
    ),
    "acceleration_centers": ("rod_length", "force_angle", "inertia_share"),
}  # fmt: skip
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
}  # fmt: skip


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    """Folder of results with the datasets of the smoke study."""
    folder = tmp_path_factory.mktemp("results")
    study = load_study("workflow/config/smoke.yaml")
    for name in DATASETS:
        write_dataset(build_dataset(name, study_slice(study, name)), folder / f"data/{name}.nc")
    log = simulate_file(load_scene_file(study.simulations["figure_15"]))
    write_dataset(log, folder / "data/simulations/figure_15.nc")
    return folder


def every(results):
    for name in DIMS:
        yield name, pp.open_dataset(name, results)
    for group in group_names(results / "data/scenes.nc"):
        yield f"scenes/{group}", pp.open_dataset(f"scenes/{group}", results)


@pytest.mark.parametrize("name", DIMS)
def test_axes_and_variables(results, name):
    dataset = pp.open_dataset(name, results)
    assert tuple(dataset.sizes) == DIMS[name]
    assert set(dataset.data_vars) >= NAMED[name]


def test_scenes_have_a_group_each(results):
    figures = ["02", "03", "08", "09a", "09b", "11", "12"]
    assert group_names(results / "data/scenes.nc") == [f"figure_{each}" for each in figures]


def test_every_variable_has_its_unit_and_name(results):
    for name, dataset in every(results):
        for key, variable in dataset.variables.items():
            described = variable.attrs["units"], variable.attrs["long_name"]
            assert described == DATASET[key], f"{name}: {key}"


def test_no_nan(results):
    for name, dataset in every(results):
        for key, variable in dataset.data_vars.items():
            if variable.dtype.kind == "f":
                assert not np.isnan(variable.values).any(), f"{name}: {key}"


def test_provenance(results):
    for name, dataset in every(results):
        assert set(dataset.attrs) >= {"title", "source", "parameters", "versions"}, name
        assert "Sec" in dataset.attrs["source"]
        assert json.loads(dataset.attrs["parameters"])
        assert "numpy" in json.loads(dataset.attrs["versions"])


def test_flags_follow_cf(results):
    outcome = pp.open_dataset("contact_modes", results).outcome
    assert list(outcome.attrs["flag_values"]) == [0, 1, 2]
    assert outcome.attrs["flag_meanings"] == "INCONSISTENT UNIQUE AMBIGUOUS"


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


@pytest.mark.parametrize("name", DATASETS)
def test_bytes_depend_on_the_content_alone(results, tmp_path, name):
    study = load_study("workflow/config/smoke.yaml")
    write_dataset(build_dataset(name, study_slice(study, name)), tmp_path / "again.nc")
    assert (tmp_path / "again.nc").read_bytes() == (results / f"data/{name}.nc").read_bytes()


def test_a_builder_reads_nothing_outside_its_slice():
    study = load_study("workflow/config/smoke.yaml")
    values = study_slice(study, "motion_cones")
    del values["grid"]["rod_angle"]
    with pytest.raises(AttributeError, match="rod_angle"):
        build_dataset("motion_cones", values)


def test_data_dictionary_is_that_of_the_datasets(results):
    stored = Path("results/README.md").read_text(encoding="utf-8")
    assert stored == dictionary_text(str(results)), "run make dictionary"


def test_open_unknown_dataset(results):
    with pytest.raises(pp.InvalidValue, match="name: 'cones' given; allowed: limit_curves, "):
        pp.open_dataset("cones", results)


@pytest.mark.parametrize("name", ["scenes", "scenes/figure_05"])
def test_open_unknown_scene(results, name):
    with pytest.raises(pp.InvalidValue, match=r"allowed: scenes/figure_02, .*name one of these"):
        pp.open_dataset(name, results)


def test_open_part_of_a_dataset_that_has_none(results):
    with pytest.raises(pp.InvalidValue, match="allowed: contact_modes; name one of these"):
        pp.open_dataset("contact_modes/force", results)


def test_open_dataset_that_is_not_built(tmp_path):
    with pytest.raises(pp.InvalidFile, match="no such dataset; build it with make or snakemake"):
        pp.open_dataset("motion_cones", tmp_path)


def test_open_damaged_dataset(tmp_path):
    (tmp_path / "data").mkdir()
    (tmp_path / "data/motion_cones.nc").write_bytes(b"not netCDF")
    with pytest.raises(pp.InvalidFile, match=r"cones\.nc: is not a netCDF4 file; build it anew"):
        pp.open_dataset("motion_cones", tmp_path)


def test_open_folder_in_place_of_a_dataset(tmp_path):
    (tmp_path / "data/motion_cones.nc").mkdir(parents=True)
    with pytest.raises(pp.InvalidFile, match=r"is not a netCDF4 file \(Is a directory\); build it"):
        pp.open_dataset("motion_cones", tmp_path)


def test_write_leaves_the_old_dataset_when_it_fails(tmp_path):
    write_dataset(xr.Dataset({"a": ("x", [1.0])}), tmp_path / "a.nc")
    before = (tmp_path / "a.nc").read_bytes()
    with pytest.raises(TypeError):
        write_dataset(xr.Dataset({"a": ("x", [1.0])}, attrs={"bad": object()}), tmp_path / "a.nc")
    assert (tmp_path / "a.nc").read_bytes() == before
    assert [path.name for path in tmp_path.iterdir()] == ["a.nc"]
