"""MATLAB files of pushed polygons, which the tests write in the published format."""

import h5py
import numpy as np
import pytest
import scipy.io
from pushes.written import write_mat

import planar_pushing as pp
from planar_pushing.mechanics.outline.plate import bounds
from planar_pushing.pushes.formats.mit import OUTLINES

SAME = ("contact", "normal", "finger_displacement", "finger_radius", "displacement", "rotation")


def test_a_file_gives_the_pushes_that_were_written(squares, tmp_path):
    file = tmp_path / "abs_rect1.mat"
    write_mat(file, squares, np.random.default_rng(5))
    found = pp.read_mit(file)
    for name in SAME:
        assert found[name].values == pytest.approx(squares[name].values, abs=1e-9), name
    assert found["outline"].values[0].tolist() == [[-45, -45], [45, -45], [45, 45], [-45, 45]]
    assert found["contact"].attrs["units"] == "mm"
    assert "force" not in found
    assert found.attrs == {
        "source": "Yu, Bauza, Fazeli and Rodriguez, IROS 2016, as filtered by Zhou, Hou and Mason",
        "left_out": 0,
    }  # fmt: skip


def test_one_push_alone(squares, tmp_path):
    file = tmp_path / "rect1.mat"
    write_mat(file, squares.isel(push=[2]), np.random.default_rng(5))
    found = pp.read_mit(file)
    assert found["rotation"].values == pytest.approx(squares["rotation"].values[2:3], abs=1e-9)


def test_a_tip_that_overlaps_begins_in_touch(squares, tmp_path):
    file = tmp_path / "abs_rect1.mat"
    write_mat(file, squares, np.random.default_rng(5), lead=-1.0)
    found = pp.read_mit(file)
    assert found.sizes["push"] == 6
    lengths = np.linalg.norm(found["finger_displacement"], axis=1)
    assert lengths == pytest.approx(np.full(6, 8.0), abs=1e-9)


def test_pushes_that_do_not_touch_are_counted(squares, tmp_path):
    file = tmp_path / "abs_rect1.mat"
    write_mat(file, squares, np.random.default_rng(5), lead=20.0)
    records = scipy.io.loadmat(file)["record_all"]
    ends = records["init_tip_pt"][3, 0], records["final_tip_pt"][3, 0]
    records["final_tip_pt"][3, 0] = (ends[0] + ends[1]) / 2  # 14.5 mm of 20
    scipy.io.savemat(file, {"record_all": records})
    found = pp.read_mit(file)
    assert (found.sizes["push"], found.attrs["left_out"]) == (5, 1)


def test_a_push_that_begins_deep_in_the_object_is_counted_too(squares, tmp_path):
    file = tmp_path / "abs_rect1.mat"
    write_mat(file, squares, np.random.default_rng(5))
    whole = pp.read_mit(file)
    records = scipy.io.loadmat(file)["record_all"]
    records["init_tip_pt"][3, 0] = records["init_pose_gt"][3, 0].ravel()[:2] + 0.02
    scipy.io.savemat(file, {"record_all": records})
    found = pp.read_mit(file)
    assert (found.sizes["push"], found.attrs["left_out"]) == (5, 1)
    rest = whole.isel(push=[0, 1, 2, 4, 5])
    for name in SAME:
        assert found[name].values == pytest.approx(rest[name].values, abs=1e-9), name
    for k in range(6):
        records["init_tip_pt"][k, 0] = records["init_pose_gt"][k, 0].ravel()[:2] + 0.02
    scipy.io.savemat(file, {"record_all": records})
    with pytest.raises(pp.InvalidFile, match=r"in the object, in pushes 0, 1, 2, 3, 4, 5"):
        pp.read_mit(file)


RAW = "motion_surface=abs_shape={}_a=0_v=20_i=0.000_s=0.100_t=0.000.h5"


@pytest.mark.parametrize("shape", ["rect1", "ellip1"])
def test_a_raw_log_in_hdf5_is_named_with_its_remedy(tmp_path, shape):
    """By its content, under any name; a file that only begins as one is not."""
    rows = np.array([(0.0, 0.1, 0.2, 0.3), (1.0, 0.1, 0.21, 0.3)])
    for file in (tmp_path / RAW.format(shape), tmp_path / "rect1.mat"):
        with h5py.File(file, "w") as log:
            for name in ("tip_pose", "object_pose", "ft_wrench"):
                log[name] = rows
        for read in (pp.read_mit, pp.load_pushes):
            with pytest.raises(pp.InvalidFile) as error:
                read(file)
            assert str(error.value).startswith(
                f"{file}: is a raw log of one push in HDF5, with tip_pose"
            )
            assert "make the dataset with pushes_from_poses, a row for each log" in str(error.value)
            assert "\n" not in str(error.value)
    other = tmp_path / "rect2.mat"
    with h5py.File(other, "w") as log:
        log["tip_pose"] = rows
    with pytest.raises(pp.InvalidFile, match=r"rect2.mat: is an HDF5 file; allowed: MATLAB files"):
        pp.read_mit(other)
    other.write_bytes(file.read_bytes()[:100])
    with pytest.raises(pp.InvalidFile, match=r"rect2.mat: is an HDF5 file; allowed: MATLAB files"):
        pp.read_mit(other)


@pytest.mark.parametrize(("name", "extents", "area"), [
    ("rect1", (90, 90), 8100), ("rect2", (89.91, 112.58), 89.91 * 112.58),
    ("rect3", (135.01, 89.94), 135.01 * 89.94), ("tri1", (125.87, 125.90), 125.87 * 125.9 / 2),
    ("tri2", (125.87, 151), 125.87 * 151 / 2), ("tri3", (125.61, 176.5), 125.61 * 176.5 / 2),
    ("hex", (121, 60.5 * np.sqrt(3)), 1.5 * np.sqrt(3) * 60.5**2),
    ("ellip1", (104.86, 104.86), np.pi * 52.43**2), ("ellip2", (104.86, 131.06), np.pi * 52.43 * 65.53),
    ("ellip3", (104.86, 157.28), np.pi * 52.43 * 78.64),
    # A polygon on the published mesh.
    ("butter", (95.5, 157.262), 11674.0),
])  # fmt: skip
def test_outlines(name, extents, area):
    outline = OUTLINES[name]
    assert sorted(np.subtract(*bounds(outline.pieces)[::-1])) == pytest.approx(
        sorted(extents), abs=0.2 if name == "butter" else 1e-9
    )
    assert outline.area == pytest.approx(area, rel={"e": 1e-4, "b": 2e-3}.get(name[0], 1e-9))
    # The frame of the triangles is at another point than the middle.
    assert "tri" in name or outline.centroid == pytest.approx((0.0, 0.0), abs=1e-6)


@pytest.mark.parametrize(("changed", "said"), [
    ({"init_tip_pt": np.ones(3)}, "push 2 holds no 2 finite numbers in init_tip_pt; export the file again"),
    ({"final_pose_gt": np.array([0, np.nan, 1])}, "push 2 holds no 3 finite numbers in final_pose_gt"),
    ({"final_pose_gt": np.array([9.0, 0, 0])}, "poses_after: 'an object that moves by "),
])  # fmt: skip
def test_wrong_values(squares, tmp_path, changed, said):
    file = tmp_path / "abs_rect1.mat"
    write_mat(file, squares, np.random.default_rng(5), **changed)
    with pytest.raises(pp.InvalidFile) as error:
        pp.read_mit(file)
    assert str(error.value).startswith(f"{file}: {said}"), str(error.value)


def test_wrong_files(squares, tmp_path):
    names = (
        "rect1.mat",
        "hex.mat",
        "tri1.mat",
        "tri2.mat",
        "abs_rect.mat",
        "pusher.mat",
        "rect1_hex.mat",
    )
    text, other, fields, cut, *unknown = (tmp_path / name for name in names)
    text.write_text("pushes")
    scipy.io.savemat(other, {"mu": 0.25})
    scipy.io.savemat(
        fields, {"record_all": {"init_pose_gt": np.ones(3), "final_pose_gt": np.ones(3)}}
    )
    write_mat(cut, squares, np.random.default_rng(5))
    cut.write_bytes(cut.read_bytes()[:900])
    shapes = (
        "a name without a known shape; allowed: one of rect1, rect2, rect3, tri1, tri2, tri3, hex, "
        "ellip1, ellip2, ellip3, butter; "
    )
    version = "is not a MATLAB file of version 5; save it with -v6 or -v7"
    for file, said in (
        (text, version),
        (cut, version),
        (other, "has no variable record_all; allowed: the pushes in record_all; export them"),
        (
            fields,
            "push 1 has no field init_tip_pt; allowed: init_pose_gt, final_pose_gt, ",
        ),
        (unknown[0], f"{shapes}did you mean rect"),
        (unknown[1], f"{shapes}rename the file by its shape"),
        (unknown[2], shapes),
        (tmp_path / "tri3.mat", "no such file; name a MATLAB file"),
    ):
        with pytest.raises(pp.InvalidFile) as error:
            pp.read_mit(file)
        assert str(error.value).startswith(f"{file}: {said}"), str(error.value)
