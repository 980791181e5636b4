"""Datasets come back as they were written, and as xarray itself reads them."""

import random

import h5py
import numpy as np
import pytest
import xarray as xr

import planar_pushing as pp
from planar_pushing.terms import netcdf
from planar_pushing.terms.errors import InvalidFile
from planar_pushing.terms.netcdf import group_names, read_attributes, write_dataset
from pulling_by_pushing.study.store import read_dataset

DATASET = xr.Dataset(
    {
        "angle": (("length", "side"), [[1.0, np.nan], [-0.0, np.inf]], {"units": "degrees"}),
        "count": (
            "length",
            np.array([3, -1], np.int8),
            {"flag_values": np.array([-1, 3], np.int8)},
        ),
        "mark": ("bare", ["a", "longer"]),
        "held": ("length", [True, False]),
        "alone": ((), 2.5),
        "word": ((), "one"),
        "long": ("many", np.arange(2000.0), {"flags": ["up", "dön"]}),
        "none": (("absent", "side"), np.zeros((0, 2))),
    },
    coords={
        "length": [0.5, 2.0],
        "side": ["right", "left"],
        "law": ("length", ["rough", "smooth"]),
    },
    attrs={"title": "of all kinds", "shares": [0.25, 0.5], "one": [4.0]},
)


@pytest.fixture
def path(tmp_path):
    return tmp_path / "data.nc"


@pytest.mark.parametrize("group", [None, "part"])
def test_reading_gives_what_xarray_gives(path, group):
    write_dataset({group: DATASET} if group else DATASET, path)
    with xr.open_dataset(path, engine="h5netcdf", group=group) as opened:
        expected = opened.load()
    found = read_dataset(path, group)
    xr.testing.assert_identical(found, expected)
    assert {name: each.dtype for name, each in found.variables.items()} == {
        name: each.dtype for name, each in expected.variables.items()
    }
    assert list(found.data_vars) == list(DATASET.data_vars)


@pytest.mark.parametrize(
    "options",
    [
        {"unlimited_dims": ["length"]},
        {"encoding": {"angle": {"_FillValue": -1.0}}},
        {"encoding": {"long": {"dtype": "int16", "scale_factor": 0.5, "_FillValue": -1}}},
    ],
)
def test_files_of_other_programs_are_read_as_xarray_reads_them(path, options):
    DATASET.to_netcdf(path, engine="h5netcdf", **options)
    with xr.open_dataset(path, engine="h5netcdf") as opened:
        expected = opened.load()
    found = read_dataset(path)
    xr.testing.assert_identical(found, expected)
    assert [found[name].dtype for name in expected] == [expected[name].dtype for name in expected]


@pytest.mark.parametrize("group", [None, "part"])
def test_a_file_is_what_xarray_writes(path, tmp_path, group):
    other = tmp_path / "other.nc"
    write_dataset({group: DATASET} if group else DATASET, path)
    DATASET.to_netcdf(other, engine="h5netcdf", group=group)
    ours, theirs = (xr.load_dataset(each, engine="h5netcdf", group=group) for each in (path, other))
    xr.testing.assert_identical(ours, theirs)
    for node, same in [(ours, theirs), *((ours[name], theirs[name]) for name in theirs.variables)]:
        assert list(node.attrs) == list(same.attrs)
    for name, variable in theirs.variables.items():
        assert ours[name].dtype == variable.dtype


@pytest.mark.parametrize("kind", [int, np.int32, np.int64])
def test_integer_attributes_have_32_bits_if_they_fit(path, kind):
    given = {"few": kind(-7), "truth": np.int8(1), "real": 2.0}
    write_dataset(DATASET.assign_attrs(given | {"many": 2**40}), path)
    with h5py.File(path) as file:
        types = {name: file.attrs.get_id(name).dtype for name in (*given, "many")}
        assert types == {"few": "i4", "truth": "i1", "real": "f8", "many": "i8"}
        assert (file.attrs["few"], file.attrs["many"]) == (-7, 2**40)


def test_only_what_is_large_is_compressed(path):
    write_dataset(DATASET, path)
    with h5py.File(path) as file:
        assert [name for name, node in file.items() if node.compression] == ["long"]


def open_files():
    return h5py.h5f.get_obj_count(h5py.h5f.OBJ_ALL, h5py.h5f.OBJ_FILE)


def test_a_file_that_is_read_whole_is_closed(path):
    write_dataset(xr.Dataset({"grid": ("a", np.arange(9.0))}), path)
    before = open_files()
    dataset = read_dataset(path)
    assert open_files() == before
    assert dataset["grid"].values.tolist() == list(range(9))


def test_of_a_large_variable_only_what_is_used_is_read(path, tmp_path, monkeypatch):
    monkeypatch.setattr(netcdf, "LARGE", 2**23)
    values = np.arange(1_200_000.0).reshape(300, 4000)
    large = xr.Dataset({"grid": (("a", "b"), values)}, coords={"a": range(300)})
    write_dataset(large, path)
    monkeypatch.chdir(tmp_path)
    found = read_dataset(path.name)
    monkeypatch.chdir("/")
    assert not found["grid"].variable._in_memory
    np.testing.assert_array_equal(found["grid"].sel(a=[7, 3, 7]), values[[7, 3, 7]])
    np.testing.assert_array_equal(found["grid"][::-50, [5, 1]], values[::-50, [5, 1]])
    assert not found["grid"].variable._in_memory
    xr.testing.assert_identical(found.load(), large)


def test_a_large_dataset_takes_less_room_in_its_file(path):
    steps = np.repeat(np.arange(1500.0), 1000).reshape(3, 1000, 500)
    large = xr.Dataset({"grid": (("a", "b", "c"), steps)})
    write_dataset(large, path)
    assert path.stat().st_size < large.nbytes / 20
    xr.testing.assert_identical(read_dataset(path), large)


def test_groups_and_attributes_are_listed(path):
    write_dataset({"second": DATASET, "first": DATASET}, path)
    assert group_names(path) == ["first", "second"]
    write_dataset(DATASET, path)
    assert read_attributes(path)["title"] == "of all kinds"
    assert set(read_attributes(path)) == set(DATASET.attrs)


@pytest.mark.parametrize("group", ["angle", "absent"])
def test_a_group_that_is_none_is_named(path, group):
    write_dataset(DATASET, path)
    with pytest.raises(InvalidFile, match=f"has no group '{group}'; delete it and build it again"):
        read_dataset(path, group)


def test_a_file_that_names_no_dimensions_is_read(path):
    with h5py.File(path, "w") as file:
        file["square"] = np.eye(3)
    square = read_dataset(path)["square"]
    assert len(set(square.dims)) == 2
    np.testing.assert_array_equal(square, np.eye(3))


def test_a_file_read_and_written_again_has_the_same_bytes(path, tmp_path):
    write_dataset(DATASET, path)
    again = tmp_path / "again.nc"
    write_dataset(read_dataset(path), again)
    assert again.read_bytes() == path.read_bytes()


def test_open_unknown_dataset(results):
    with pytest.raises(pp.InvalidValue, match="name: 'cones' given; allowed: limit_curves, "):
        pp.open_dataset("cones", results)


def test_open_misspelled_dataset(results):
    with pytest.raises(
        pp.InvalidValue, match=r"'contact_mode' given; .*; did you mean contact_modes"
    ):
        pp.open_dataset("contact_mode", results)


@pytest.mark.parametrize("name", ["scenes", "scenes/figure_05"])
def test_open_unknown_scene(results, name):
    with pytest.raises(pp.InvalidValue, match=r"allowed: scenes/figure_02, .*; (name one|did)"):
        pp.open_dataset(name, results)


def test_open_part_of_a_dataset_that_has_none(results):
    with pytest.raises(
        pp.InvalidValue, match=r"allowed: contact_modes; did you mean contact_modes\?"
    ):
        pp.open_dataset("contact_modes/force", results)


@pytest.mark.parametrize(("folder", "said"), [
    ("nowhere", "nowhere: no such folder; name the folder of the results"),
    (".", "holds no folder data; name the folder of the results, or build them with make"),
])  # fmt: skip
def test_a_folder_without_results_is_named(tmp_path, folder, said):
    with pytest.raises(pp.InvalidFile, match=said):
        pp.open_dataset("motion_cones", tmp_path / folder)


def test_open_dataset_that_is_not_built(tmp_path):
    (tmp_path / "data").mkdir()
    said = r"data/motion_cones\.nc: no such dataset; build it with planar-pushing run, from a study that"
    with pytest.raises(pp.InvalidFile, match=said):
        pp.open_dataset("motion_cones", tmp_path)
    with pytest.raises(pp.InvalidFile, match="no such dataset; build it with make, in"):
        pp.open_dataset("accuracy/cone", tmp_path)


def test_a_log_that_is_not_there_is_answered_by_those_that_are(results, tmp_path):
    (tmp_path / "data").mkdir()
    with pytest.raises(
        pp.InvalidFile, match=r"no such dataset; .* lists it under simulations; make"
    ):
        pp.open_dataset("simulations/pull", tmp_path)
    write_dataset(pp.open_dataset("motion_cones", results), tmp_path / "data/simulations/push.nc")
    with pytest.raises(
        pp.InvalidValue,
        match="'simulations/pull' given; allowed: simulations/push; name one of these, or list it",
    ):
        pp.open_dataset("simulations/pull", tmp_path)


def test_open_damaged_dataset(tmp_path):
    (tmp_path / "data").mkdir()
    (tmp_path / "data/motion_cones.nc").write_bytes(b"not netCDF")
    with pytest.raises(
        pp.InvalidFile,
        match=r"cones\.nc: is not a netCDF4 file; give a dataset, or rebuild a damaged one",
    ):
        pp.open_dataset("motion_cones", tmp_path)


def flipped(content, rng):
    """The bytes with one to twenty bits turned over."""
    damaged = bytearray(content)
    for _ in range(rng.choice([1, 1, 2, 5, 20])):
        place = rng.randrange(8 * len(damaged))
        damaged[place // 8] ^= 1 << place % 8
    return bytes(damaged)


def complaint(read, path):
    """The message about a file that is refused; nothing for one that is read."""
    try:
        read(path)
    except pp.InvalidFile as error:
        return str(error)
    return ""


@pytest.mark.parametrize("count", [40, pytest.param(100, marks=pytest.mark.slow)])
def test_flipped_bits_end_in_one_line(path, tmp_path, count):
    write_dataset(DATASET[["angle", "mark"]], path)
    rng, content, refused = random.Random(13), path.read_bytes(), 0
    for i in range(count):
        damaged = tmp_path / f"{i}.nc"
        damaged.write_bytes(flipped(content, rng))
        for read in (read_dataset, group_names, read_attributes):
            said = complaint(read, damaged)
            assert not said or said.startswith(f"{damaged}: ")
            assert "\n" not in said
            refused += bool(said)
    assert refused > 10


@pytest.mark.parametrize("size", [0, 7, 100, 1000])
def test_a_cut_file_ends_in_one_line(path, size):
    write_dataset(DATASET, path)
    path.write_bytes(path.read_bytes()[:size])
    for read in (read_dataset, group_names, read_attributes):
        with pytest.raises(
            InvalidFile,
            match="is not a netCDF4 file; give a dataset, or rebuild a damaged one",
        ):
            read(path)


def test_bad_units_of_time_are_text_like_any_other(path):
    steps = ("step", [1, 2, 3], {"units": "days since never"})
    write_dataset(xr.Dataset(coords={"step": steps}), path)
    assert read_dataset(path).step.attrs["units"] == "days since never"


@pytest.mark.parametrize(
    "name", ["simulations/../limit_curves", "../limit_curves", "figures/../../x", "scenes/a/b",
             "simulations/", "simulations", "figures", 5, None, "limit_curves/", "a\0b"],
)  # fmt: skip
def test_a_name_does_not_leave_the_results(tmp_path, name):
    with pytest.raises(pp.InvalidValue, match="allowed: limit_curves, ") as caught:
        pp.open_dataset(name, tmp_path)
    assert "\n" not in str(caught.value)


def test_open_folder_in_place_of_a_dataset(tmp_path):
    (tmp_path / "data/motion_cones.nc").mkdir(parents=True)
    with pytest.raises(
        pp.InvalidFile, match=r"is not a netCDF4 file \(Is a directory\); give a dataset"
    ):
        pp.open_dataset("motion_cones", tmp_path)


def test_write_leaves_the_old_dataset_when_it_fails(tmp_path):
    write_dataset(xr.Dataset({"a": ("x", [1.0])}), tmp_path / "a.nc")
    before = (tmp_path / "a.nc").read_bytes()
    with pytest.raises(TypeError):
        write_dataset(xr.Dataset({"a": ("x", [1.0])}, attrs={"bad": object()}), tmp_path / "a.nc")
    assert (tmp_path / "a.nc").read_bytes() == before
    assert [path.name for path in tmp_path.iterdir()] == ["a.nc"]
