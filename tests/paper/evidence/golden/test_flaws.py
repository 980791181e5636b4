"""Golden data that cannot judge a result are failed checks: other kinds, wide radii, other digests."""

import shutil

import numpy as np
import pytest
import xarray as xr
from evidence.golden.goldens import FOLDER, dataset_name, golden, names, result

from planar_pushing.terms.netcdf import write_dataset
from pulling_by_pushing.evidence.golden import check, digests
from pulling_by_pushing.evidence.golden.compare import KIND, Kind, load_tolerances
from pulling_by_pushing.evidence.golden.enclosures import holds_radii
from pulling_by_pushing.evidence.golden.flaws import flaws, kind_of
from pulling_by_pushing.evidence.golden.grid import CELLS, dims_of
from pulling_by_pushing.study.catalog import DATASETS
from pulling_by_pushing.study.slices import result_names
from pulling_by_pushing.study.studies import FILES
from pulling_by_pushing.study.study_file import load_study

TOLERANCES = load_tolerances()


def test_stored_golden_data_have_no_flaws():
    for file, group in names():
        name = dataset_name(file)
        assert not list(flaws(f"{name}/{group}" if group else name, golden(file, group))), file


def test_the_catalog_says_which_datasets_have_cells():
    certified = {name for name, entry in DATASETS.items() if entry.certified}
    assert certified == {*CELLS, "scenes"}


def test_cells_take_the_axes_of_the_catalog():
    for name, cells in CELLS.items():
        dims = (*DATASETS[name].dims, *DATASETS[name].inner)
        for cell in cells:
            taken = dims_of(cell)
            assert taken == tuple(dim for dim in dims if dim in taken), f"{name}: {cell.__name__}"


def checked(file, of_golden=lambda data: data, of_result=lambda data: data):
    """Failed checks of a result against golden data after a change of either."""
    stored = golden(file)
    changed, against = of_result(result(stored)), of_golden(stored)
    checks = check.check_dataset(dataset_name(file), changed, against, TOLERANCES)
    return [each for each in checks if not each.passes]


def with_values(name, change):
    """A change of the values of a variable."""

    def changed(data):
        return data.assign({name: (data[name].dims, change(data[name].values), data[name].attrs)})

    return changed


def one_value(name, number, place=0):
    """A change of one value of a variable."""

    def changed(values):
        values = values.copy()
        values.flat[place] = number
        return values

    return with_values(name, changed)


def all_radii(exponent):
    """All radii as a power of two."""

    def changed(data):
        for name in (name for name in data.variables if holds_radii(name, data)):
            data = with_values(name, lambda values: np.full_like(values, exponent))(data)
        return data

    return changed


@pytest.mark.parametrize("file", ["mode_maps", "motion_cones", "sliders/support_curves"])
@pytest.mark.parametrize("exponent", [100, -20])
def test_wide_radii_are_refused(file, exponent):
    assert checked(file) == []
    failed = checked(file, of_golden=all_radii(exponent))
    assert failed
    assert all("golden radii of" in each.problem for each in failed)
    assert all("make golden WRITE=1" in each.problem for each in failed)


@pytest.mark.parametrize("exponent", [-20, 127])
def test_one_wide_radius_is_refused(exponent):
    place = int(np.argmin(np.abs(golden("limit_curves")["force"].values)))
    (failed,) = checked("limit_curves", one_value("force_radius", exponent, place))
    assert failed.problem.startswith("has 1 golden radii of force above 1e-09 of their numbers; ")


def test_small_numbers_do_not_count_as_infinite():
    place = int(np.flatnonzero(np.isinf(golden("contact_modes")["center"].values))[0])
    assert checked("contact_modes", one_value("center_radius", -128, place)) == []
    (failed,) = checked("contact_modes", one_value("center_radius", 3, place))
    assert "has 1 golden radii of center " in failed.problem


def test_a_component_beside_an_infinite_one_may_be_undetermined_and_another_one_not():
    center = golden("sliders/support_modes")["center"]
    infinite = np.isinf(center.values).any(axis=-1, keepdims=True)
    for beside, count in ((True, 0), (False, 1)):
        wanted = np.isfinite(center.values) & (infinite == beside)
        place = int(np.flatnonzero(wanted)[0])
        change = one_value("center_radius", 127, place)
        assert len(checked("sliders/support_modes", change)) == count


@pytest.mark.parametrize("factor", [0.5, 2.0])
def test_radii_by_condition_are_at_most_those_that_follow_from_the_condition(factor):
    change = with_values("result_radius", lambda values: factor * values)
    assert len(checked("hard_cases", change)) == (factor > 1)


@pytest.mark.parametrize("kind", [str(Kind.PLAIN), str(Kind.INTEGRATED), "anything", None])
def test_another_kind_is_refused(kind):
    assert kind_of("mode_maps") is Kind.ENCLOSED
    (failed,) = checked("mode_maps", lambda data: data.assign_attrs({KIND: kind or ""}))
    assert failed.problem.startswith(f"has golden data of the kind {kind or ''!r}, not 'enclosed'")
    assert "\n" not in failed.problem


def test_coordinates_that_are_angles_are_compared_as_stored():
    later = with_values("rod_angle", lambda values: values + 360.0)
    for file in ("contact_modes", "simulations/pulling"):
        (failed,) = checked(file, of_result=later)
        assert (failed.variable, failed.error) == ("rod_angle", 360.0)


def test_directions_are_compared_up_to_turns():
    turned = with_values("sticking_force_angle", lambda values: values - 360.0)
    assert checked("mode_maps", of_result=turned) == []


@pytest.mark.parametrize(("variable", "width"), [("mode", np.int16), ("pivot", np.int64)])
def test_the_width_of_integers_is_compared(variable, width):
    (failed,) = checked("contact_modes", of_result=with_values(variable, lambda v: v.astype(width)))
    assert failed.problem.startswith(f"{variable} has the type {np.dtype(width)}, not int")


@pytest.mark.parametrize("change", [-1, 1])
def test_counts_of_effects_are_equal(change):
    counts = golden("effects")["evaluations"].values
    for place in (int(np.flatnonzero(counts)[0]), int(np.flatnonzero(counts == 0)[0])):
        number = counts.flat[place] + change
        (failed,) = checked("effects", of_result=one_value("evaluations", number, place))
        assert (failed.variable, failed.failed) == ("evaluations", 1)


@pytest.mark.parametrize("variable", ["evaluations", "evaluations_alone"])
class TestCountsOfRuns:
    """Rounding changes few counts of runs over time, and by little; a method changes all or one by much."""

    def test_a_few_may_differ(self, variable):
        assert (
            checked("model_errors", of_result=one_value(variable, self._counts(variable)[0] * 1.2))
            == []
        )

    def test_one_may_not_differ_by_much(self, variable):
        changed = one_value(variable, self._counts(variable)[0] * 1.3)
        (failed,) = checked("model_errors", of_result=changed)
        assert (failed.variable, failed.failed) == (variable, 1)

    def test_all_may_not_differ_by_one(self, variable):
        changed = with_values(variable, lambda values: values + 1)
        (failed,) = checked("model_errors", of_result=changed)
        size = self._counts(variable).size
        assert failed.problem.startswith(f"differs in {size} of {size} numbers; ")

    def _counts(self, variable):
        return golden("model_errors")[variable].values.ravel()


# --- Digests -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("file", FILES.values())
def test_stored_golden_files_are_those_of_the_list(file):
    study = load_study(file)
    folder = FOLDER if study.golden == str(FOLDER) else FOLDER / "sliders"
    listed = digests.read_digests(folder)
    assert set(listed) == set(result_names(study))
    assert not list(digests.changed_files(folder, listed))


@pytest.fixture
def folder(tmp_path):
    """Two golden files and their list."""
    for name in ("mode_maps", "simulations/pulling"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        shutil.copy(FOLDER / f"{name}.nc", tmp_path / f"{name}.nc")
    digests.list_digests(tmp_path, ["mode_maps", "simulations/pulling"])
    return tmp_path


def test_a_changed_golden_file_is_named(folder):
    file = folder / "mode_maps.nc"
    data = xr.load_dataset(file, engine="h5netcdf")
    write_dataset(all_radii(-45)(data), file)
    ((name, problem),) = digests.changed_files(folder, ["mode_maps", "simulations/pulling"])
    assert name == "mode_maps"
    assert problem.startswith(f"{file} is not the golden file of {folder / 'SHA256SUMS'}; take it ")
    assert "make golden WRITE=1" in problem


def test_a_golden_file_that_is_not_listed_is_named(folder):
    list_file = folder / digests.DIGESTS
    lines = list_file.read_text(encoding="utf-8").splitlines()
    list_file.write_text(f"{lines[1]}\n", encoding="utf-8")
    ((name, problem),) = digests.changed_files(folder, ["mode_maps", "simulations/pulling"])
    assert name == "mode_maps"
    assert "SHA256SUMS does not list" in problem


def test_other_digests_are_kept_and_those_of_no_file_are_not(folder):
    before = digests.read_digests(folder)
    (folder / "mode_maps.nc").write_bytes(b"other")
    digests.list_digests(folder, ["simulations/pulling"])
    assert digests.read_digests(folder) == before
    (folder / "mode_maps.nc").unlink()
    digests.list_digests(folder, ["simulations/pulling"])
    assert set(digests.read_digests(folder)) == {"simulations/pulling"}


@pytest.mark.parametrize("text", [None, "mode_maps.nc\n", f"{'a' * 64}  mode_maps\n"])
def test_a_list_that_is_missing_or_damaged_is_one_line(folder, text):
    file = folder / digests.DIGESTS
    file.unlink()
    if text:
        file.write_text(text, encoding="utf-8")
    with pytest.raises(check.InvalidFile, match=f"^{file}: .*make golden WRITE=1$"):
        digests.read_digests(folder)
