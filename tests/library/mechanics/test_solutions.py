"""Solutions in a user's hands: indexed, compared, printed."""

import json
from dataclasses import replace

import numpy as np
import pytest
import xarray as xr
from mechanics.builders import make_scene

import planar_pushing as pp
from planar_pushing.mechanics.solutions import printed_numbers

PULL = np.deg2rad(-10)


@pytest.fixture
def three():
    """Separate, stick and slip-left are all consistent."""
    return pp.solve(make_scene(2.0, 2.0), PULL)


def test_indices_and_slices(three):
    assert [three[i].mode.name for i in (0, 1, -1)] == ["SEPARATE", "STICK", "SLIP_LEFT"]
    assert three[1:] == tuple(three)[1:]
    assert three[1] in three
    with pytest.raises(IndexError):
        three[3]


def test_a_mode_is_no_index(three):
    """It is a whole number, and would pick the solution that happens to have it as its place."""
    with pytest.raises(pp.InvalidValue, match=r"solutions\.of\(mode\)") as caught:
        three[pp.ContactMode.STICK]
    assert caught.value.name == "index"


def test_solutions_are_equal_where_every_number_is(three):
    assert three == pp.solve(make_scene(2.0, 2.0), PULL)
    assert three != pp.solve(make_scene(2.0, 2.0), 1.0)
    for name in ("force", "force_end", "contact_motion", "twist", "center"):
        last = getattr(three[2], name)
        other = replace(three[2], **{name: np.nextafter(last, [*last[:-1], np.inf])})
        assert three != replace(three, solutions=(*three[:2], other))
    for name, value in (("spin_ratio", 0.86), ("pivot", 0), ("continuum", True)):
        assert three[2] != replace(three[2], **{name: value})
    assert three[0] == three[0]
    assert three[1] != three[2]
    assert (three == 3, three[0] == 3) == (False, False)


def test_results_of_arrays_are_equal_or_not_as_a_whole():
    scene, angles = make_scene(2.0, 2.0), np.array([PULL, 1.0])
    assert pp.solve(scene, angles) == pp.solve(scene, angles)
    assert pp.solve(scene, angles) != pp.solve(scene, angles + 1e-9)
    assert pp.solve(scene, angles) != pp.solve(scene, angles[:1])
    assert pp.limit_curve(scene, angles) == pp.limit_curve(scene, angles)
    assert pp.limit_curve(scene, angles) != pp.limit_curve(scene, angles + 1e-9)


def test_printed_they_are_a_table_with_a_column_each(three):
    lines = repr(three).splitlines()
    assert lines[0] == "AMBIGUOUS: 3 consistent solutions"
    assert lines[1].split() == ["SEPARATE", "STICK", "SLIP_LEFT"]
    rows = {line[:12].strip(): line[12:].split() for line in lines[2:]}
    assert len(rows) == 10
    assert rows["force x"][0] == "0"
    assert rows["omega"] == [f"{each.twist[2]:.6g}" for each in three]
    assert rows["center y"][0] == "none"
    assert max(map(len, lines)) < 80


def test_the_table_of_a_notebook(three):
    html = three._repr_html_()
    assert html.startswith("<svg ")
    assert "</svg><p>AMBIGUOUS: 3 consistent solutions</p>\n<table" in html
    assert html.count("<tr") == 11
    assert html.count("<td>") == 30
    assert all(f"<th>{mode}</th>" in html for mode in three.modes)


def test_the_solutions_of_a_mode(three):
    assert three.of(pp.ContactMode.SLIP_LEFT) == (three[2],)
    assert three.of(pp.ContactMode.SLIP_RIGHT) == ()


def test_plain_values(three):
    found = three.to_dict()
    assert set(found) == {"outcome", "status", "solutions"}
    assert (found["outcome"], found["status"]) == ("AMBIGUOUS", "CONSISTENT")
    assert found["solutions"][1:] == [each.to_dict() for each in three[1:]]
    assert np.isnan(found["solutions"][0]["center"]).all()
    for plain, solution in zip(found["solutions"], three, strict=True):
        assert (plain["mode"], plain["adhesive"]) == (solution.mode.name, solution.adhesive)
        assert plain["twist"] == solution.twist.tolist()
        assert plain["pivot"] == -1
        assert plain["continuum"] is False
        types = {type(part) for each in plain.values() for part in np.atleast_1d(each).tolist()}
        assert types <= {float, int, bool, str}


def test_json_has_words_for_infinities_and_nan(three):
    separate, stick, _ = json.loads(three.to_json())["solutions"]
    assert separate["center"] == ["nan", "nan"]
    assert stick["force"] == three[1].force.tolist()
    assert json.loads(three[1].to_json()) == stick
    along = pp.solve(make_scene(2.0, 2.0), np.pi / 4)
    assert sorted(json.loads(along.to_json())["solutions"][0]["center"]) == ["-inf", "inf"]


@pytest.mark.parametrize("unit", [1e-9, 1.0, 1e9])
def test_printed_numbers_are_relative_to_the_scene(unit):
    """A rounding error prints as 0 in any units of length, force and motion; no small number does."""
    effects = (pp.RingFriction(weight=unit),)
    scene = make_scene(2 * unit, 2.0, effects, radius=unit)
    (stick,) = pp.solve(scene, np.deg2rad(90), unit)
    assert abs(stick.contact_motion[0]) < 1e-15 * unit
    noisy = replace(stick, contact_motion=stick.contact_motion + np.array([7e-17 * unit, 0.0]))
    rows = repr(pp.Solutions((noisy,), problem=(scene, np.pi / 2, unit))).splitlines()
    assert next(row for row in rows if row.startswith("motion x")).split()[-1] == "0"
    small = replace(stick, contact_motion=stick.contact_motion + np.array([7e-11 * unit, 0.0]))
    assert "motion x" in repr(pp.Solutions((small,)))
    (values,) = printed_numbers(pp.Solutions((small,), problem=(scene, np.pi / 2, unit)))
    assert values["contact_motion"] == pytest.approx(small.contact_motion, rel=1e-15, abs=0)
    for name in ("force", "twist", "center"):
        assert values[name] == pytest.approx(getattr(stick, name), rel=1e-11, abs=1e-11 * unit)


def test_a_rotation_is_small_beside_the_motion_over_the_reach():
    scene = make_scene(2.0, 2.0)
    (stick,) = pp.solve(scene, np.deg2rad(90))
    turning = [replace(stick, twist=np.array([0.0, 1.0, spin])) for spin in (1e-13, 1e-11)]
    problem = (scene, np.pi / 2, 1.0)
    found = [
        printed_numbers(pp.Solutions((each,), problem=problem))[0]["twist"][2] for each in turning
    ]
    assert found == [0.0, 1e-11]
    assert printed_numbers(pp.Solutions((turning[0],)))[0]["twist"][2] == 1e-13


@pytest.fixture
def arrays():
    """Problems of shape (2, 3), of which one has three solutions and two have none."""
    angles = np.deg2rad([[-90.0, -10.0, 165.0], [20.0, 90.0, 160.0]])
    laws = np.array([[pp.Coulomb(2.0)] * 2 + [pp.InfiniteFriction("none")]] * 2, dtype=object)
    return pp.solve(make_scene(2.0, laws), angles)


def test_arrays_print_in_a_few_lines(arrays):
    assert repr(arrays).splitlines() == [
        "SolutionArrays of shape (2, 3)",
        "outcomes: 2 INCONSISTENT, 3 UNIQUE, 1 AMBIGUOUS",
        "modes: 2 SEPARATE, 3 STICK, 1 SLIP_LEFT",
        "status: 2 NONE, 4 CONSISTENT",
    ]
    assert "outcomes: none" in repr(arrays[:, :0])


def test_a_full_index_gives_solutions(arrays, three):
    assert arrays[0, 1] == arrays[-2, -2] == arrays[0, 1, ...] == arrays[0][1] == three
    assert isinstance(arrays[0, 1], pp.Solutions)
    assert len(arrays[0, 2]) == 0
    assert [len(each) for each in arrays[0]] == [1, 3, 0]
    with pytest.raises(IndexError):
        arrays[2, 0]
    with pytest.raises(pp.InvalidValue, match=r"arrays\.mode == mode"):
        arrays[pp.ContactMode.STICK]


@pytest.mark.parametrize(
    "index", [0, slice(1, None), (slice(None), 1), (..., slice(None, None, 2)), [1, 0, 1], (0, [2, 1])],
    ids=repr,
)  # fmt: skip
def test_a_partial_index_gives_arrays(arrays, index):
    found = arrays[index]
    assert isinstance(found, pp.SolutionArrays)
    assert found.shape == arrays.solutions[index].shape
    rows, columns = (each[index] for each in np.indices(arrays.shape))
    for at in np.ndindex(found.shape):
        assert found[at] == arrays[rows[at], columns[at]]


def test_a_mask_picks_problems(arrays):
    assert arrays[arrays.solutions == 3].shape == (1,)
    assert arrays[arrays.solutions == 3][0] == arrays[0, 1]
    assert len(arrays) == 2


def test_arrays_become_the_dataset_of_labeled_arrays():
    angles = np.deg2rad([[-90.0, -10.0], [20.0, 90.0]])
    scene = make_scene(2.0, 2.0)
    labeled = pp.solve(scene, xr.DataArray(angles, dims=["row", "push"]))
    xr.testing.assert_identical(pp.solve(scene, angles).to_dataset(["row", "push"]), labeled)
    assert pp.solve(scene, angles).to_dataset().mode.dims == ("dim_0", "dim_1", "solution")
    for name, members in (
        ("mode", pp.ContactMode), ("outcome", pp.Outcome), ("status", pp.Status),
    ):  # fmt: skip
        attrs = labeled[name].attrs
        assert attrs["flag_meanings"].split() == [each.name for each in members]
        assert attrs["flag_values"].tolist() == list(members)
        assert attrs["flag_values"].dtype == labeled[name].dtype


@pytest.mark.parametrize(
    "dims", [["row"], "rp", ["row", "row"], ["xy", "row"], ["row", "solution"], []], ids=repr
)
def test_names_that_are_no_axes_are_refused(dims):
    arrays = pp.solve(make_scene(2.0, 2.0), np.ones((2, 2)))
    with pytest.raises(pp.InvalidValue, match=r"dims: .* given; allowed: 2 names") as caught:
        arrays.to_dataset(dims)
    assert caught.value.remedy == "name each axis of the shape (2, 2)"


def test_one_solution_and_none_in_words():
    one = pp.solve(make_scene(2.0, 2.0), 1.0)
    none = pp.solve(make_scene(2.0, pp.InfiniteFriction("none")), np.deg2rad(165))
    assert repr(one).startswith("UNIQUE: 1 consistent solution\n")
    assert repr(none) == "INCONSISTENT: 0 consistent solutions"
    assert none._repr_html_().endswith("</svg><p>INCONSISTENT: 0 consistent solutions</p>")
    assert (
        replace(none, problem=None)._repr_html_() == "<p>INCONSISTENT: 0 consistent solutions</p>"
    )
