"""Datasets of several objects, and files."""

import numpy as np
import pytest
import xarray as xr
from pushes.written import SQUARE, small

import planar_pushing as pp
from planar_pushing.pushes.logs.combine import of_object
from planar_pushing.pushes.logs.schema import require_pushes


def house():
    """Two pushes of a pentagon on two feet, with forces, paths and noise."""
    given = small().isel(push=slice(2)).assign_coords(object=["house"])
    path = [[(0, 0), (0, 0.1), (0, 0.2)], [(0, 0), (0.1, 0.2), (np.nan, np.nan)]]
    return given.assign(
        pushed=("push", ["house"] * 2),
        outline=(("object", "corner", "xy"), [[*SQUARE[:3], (0.0, 2.0), SQUARE[3]]], {"units": "mm"}),
        feet=(("object", "foot", "xy"), [[(-1, 0), (1, 0)]]),
        foot_weight=(("object", "foot"), [[0.25, 0.75]]),
        force=(("push", "xy"), [(0, 1), (np.nan, np.nan)]),
        finger_path=(("push", "sample", "xy"), path),
        path_time=(("push", "sample"), [[0, 1, 2], [0, 1, np.nan]]),
    ).assign_attrs(source="there", position_noise=0.2, left_out=3)  # fmt: skip


def square():
    return small().assign_attrs(source="here", position_noise=0.5, force_noise=0.1, left_out=1)


def test_two_objects_and_each_again():
    found = pp.concat_pushes([square(), house()])
    assert dict(found.sizes) == {
        "push": 5, "object": 2, "corner": 5, "xy": 2, "foot": 2, "sample": 3,
    }  # fmt: skip
    assert found["pushed"].values.tolist() == ["square"] * 3 + ["house"] * 2
    assert found.attrs == {
        "source": "here; there", "position_noise": 0.5, "force_noise": 0.1, "left_out": 4,
    }  # fmt: skip
    assert np.isnan(found["feet"].sel(object="square")).all()
    again = of_object(found, "house")
    expected = require_pushes(house())
    assert again.drop_attrs(deep=False).identical(expected.drop_attrs(deep=False))
    square_again = of_object(found, "square")
    assert (square_again.sizes["corner"], "foot" in square_again.dims) == (4, False)


def test_one_object_in_two_datasets():
    found = pp.concat_pushes([square(), house(), square()])
    assert found.sizes["object"] == 2
    assert of_object(found, "square").sizes["push"] == 6


def in_centimeters(pushes):
    found = pushes.copy(deep=True)
    for each in found.data_vars.values():
        each.attrs.update({"units": "cm"} if each.attrs.get("units") == "mm" else {})
    return found


@pytest.mark.parametrize(("given", "said"), [
    ([], "pushes: [] given; allowed: a list of at least one dataset"),
    (small(), "pushes: <xarray.Dataset>"),
    ([square(), square().assign(center_of_mass=(("object", "xy"), [[0.0, 0.0]]))],
     "object: 'square' given; allowed: a different name for each object"),
    ([house(), house().assign(outline=house()["outline"] * 1.01)], "object: 'house' given"),
    ([square(), in_centimeters(house())], "units: 'outline in cm and mm' given; allowed: one unit"),
], ids=range(5))  # fmt: skip
def test_what_does_not_go_together(given, said):
    with pytest.raises(pp.InvalidValue) as error:
        pp.concat_pushes(given)
    assert str(error.value).startswith(said), str(error.value)


def test_an_object_that_is_not_there():
    with pytest.raises(
        pp.InvalidValue, match="object: 'squares' given; allowed: square; did you mean square"
    ):
        of_object(require_pushes(small()), "squares")
    both = pp.concat_pushes([square(), house()]).isel(push=slice(3))
    with pytest.raises(
        pp.InvalidValue, match="object: 'house' given; allowed: an object that is pushed"
    ):
        of_object(both, "house")


def test_a_file_holds_the_same(tmp_path):
    found, file = pp.concat_pushes([square(), house()]), tmp_path / "pushes.nc"
    pp.save_pushes(found, file)
    assert pp.load_pushes(file).identical(found)
    first = file.read_bytes()
    pp.save_pushes(pp.load_pushes(file), file)
    assert file.read_bytes() == first


def test_nothing_is_written_of_what_is_wrong(tmp_path):
    file = tmp_path / "pushes.nc"
    with pytest.raises(pp.InvalidValue, match="without contact"):
        pp.save_pushes(small(contact=None), file)
    assert not list(tmp_path.iterdir())


def test_files_that_hold_no_pushes(tmp_path):
    missing, text, other = (tmp_path / name for name in ("missing.nc", "text.nc", "other.nc"))
    text.write_text("pushes")
    xr.Dataset({"a": 1.0}).to_netcdf(other, engine="h5netcdf")
    for file, said in (
        (missing, "no such file; write one with save_pushes or planar-pushing convert"),
        (
            text,
            "is not a netCDF4 file of pushes; write one with save_pushes or planar-pushing convert",
        ),
        (other, "pushes: 'a dataset without pushed, outline, contact, normal, "),
    ):
        with pytest.raises(pp.InvalidFile) as error:
            pp.load_pushes(file)
        assert str(error.value).startswith(f"{file}: {said}"), str(error.value)
