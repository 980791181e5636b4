"""The dataset of pushes: its canonical copy, and one line for each way in which it can be wrong."""

import numpy as np
import pytest
from pushes.written import SQUARE, small

import planar_pushing as pp
from planar_pushing.pushes.logs.schema import outline_of, pad, require_pushes

MM = {"units": "mm"}


def test_the_copy_has_units_names_and_doubles():
    given = small(rotation=("push", np.array([-4, 0, 6], dtype="i2")))
    found = require_pushes(given)
    assert found["rotation"].dtype == found["contact"].dtype == np.float64
    assert found["rotation"].attrs == {
        "units": "degree", "long_name": "rotation of the object, counterclockwise",
    }  # fmt: skip
    assert found["displacement"].attrs["units"] == found["contact"].attrs["units"] == "mm"
    assert found["normal"].attrs["units"] == "1"
    assert all("long_name" in each.attrs for each in found.data_vars.values())
    assert given["rotation"].dtype == np.int16
    found["contact"][0, 0] = 7.0
    assert given["contact"].values[0, 0] == -0.5
    assert require_pushes(small()).identical(require_pushes(require_pushes(small())))


def test_dimensions_in_another_order_and_a_clockwise_outline():
    given = small(
        contact=(("xy", "push"), np.transpose([(-0.5, -1.0), (0.0, -1.0), (1.0, 0.5)]), MM),
        outline=(("xy", "object", "corner"), np.transpose([SQUARE[::-1]], (2, 0, 1)), MM),
    )
    found = require_pushes(given)
    assert found["contact"].equals(require_pushes(small())["contact"])
    x, y = np.array(outline_of(found, "square").corners).T
    assert np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)) == pytest.approx(8.0)


def test_other_variables_over_pushes_and_the_attributes_are_kept():
    given = small(predicted=("push", [1.0, 2.0, 3.0]))
    given.attrs |= {"source": "here", "position_noise": 0.5, "history": "long"}
    found = require_pushes(given)
    assert found["predicted"].values.tolist() == [1.0, 2.0, 3.0]
    assert found.attrs == {"source": "here", "position_noise": 0.5}


def test_padding():
    assert np.array_equal(
        pad([np.ones((1, 2)), np.zeros((2, 2))]), [[[1, 1], [np.nan] * 2], np.zeros((2, 2))],
        equal_nan=True,
    )  # fmt: skip
    given = small(outline=(("object", "corner", "xy"), [[*SQUARE, (np.nan, np.nan)]], MM))
    assert outline_of(require_pushes(given), "square") == pp.Outline(SQUARE)


def rows(*values, dims=("push", "xy"), units=MM):
    return dims, np.array(values, dtype=float), units


def corners(*values):
    return rows(values, dims=("object", "corner", "xy"))


def path(values, times=((0.0, 1.0),) * 3):
    return {
        "finger_path": (("push", "sample", "xy"), values),
        "path_time": (("push", "sample"), np.array(times)),
    }


def shares(*values):
    return {"foot_weight": (("object", "foot"), [values])}


CONTACTS = np.array([(-0.5, -1.0), (0.0, -1.0), (1.0, 0.5)])
PATH = np.array([[(0, 0), (0, 0.2)], [(0, 0), (0.1, 0.2)], [(0, 0), (-0.2, 0)]])
LENGTHS = ("outline", "contact", "finger_displacement", "finger_radius", "displacement")
NO_UNITS = {name: small()[name].drop_attrs() for name in LENGTHS}
FEET = {"feet": (("object", "foot", "xy"), [[(0, 0), (1, 0)]])}
SCALED = "lengths of square in one unit; check the units: these look like meters and millimeters"
TIMES = "times that increase; put the samples in order"


@pytest.mark.parametrize(("changes", "given", "allowed"), [
    ({"contact": None, "rotation": None}, "pushes: 'a dataset without contact, rotation'",
     "one with every"),
    ({"rotation": (("push", "xy"), np.ones((3, 2)))}, "rotation: \"dimensions ('push', 'xy')\"",
     "dimensions"),
    ({"pushed": ("push", ["square", "circle", "square"])}, "pushed: 'circle'", "square; name an object"),
    ({"rotation": ("push", [0, np.nan, 0])}, "rotation: 'nan of push 1'", "finite numbers; leave out"),
    ({"rotation": ("push", ["a", "b", "c"])}, "rotation: '<U1'", "numbers; give floats"),
    ({"rotation": ("push", [0, 0, 0], {"units": "radian"})}, "units: 'rotation in radian'",
     "degree; convert"),
    ({"displacement": rows(*CONTACTS, units={"units": "m"})}, "units: 'displacement in m, outline in mm'",
     "one"),
    (NO_UNITS, "units: None", "a name such as mm; set the attribute units of the variable outline"),
    ({"outline": corners((0, 0), (2, 2), (2, 0), (0, 2))},
     "outline of square: 'edges 0 and 2, from (0, 0) to (2, 2) and from (2, 0) to (0, 2)'", "a simple"),
    ({"contact": rows((-0.5, -1), (0, 0), (1, 0.5))}, "contact: '[0., 0.] of push 1'",
     "a point of the outline of square, within 2 % of its size 2; check frame and units"),
    ({"contact": rows(*CONTACTS / 1e3)},
     "contact: 'a typical length of 0.001118, where the outline reaches to 1'", SCALED),
    ({"finger_displacement": rows((0, 2e-4), (0, 2e-4), (-2e-4, 0))},
     "finger_displacement: \"a typical length of 0.0002, where the outline's size is 2\"", SCALED),
    ({"displacement": rows((0, 1.5e-4), (0, 2e-4), (-2e-4, 0))},
     "displacement: 'a typical length of 0.0002, where the finger moves by 0.2'", SCALED),
    ({"normal": rows((0, 1), (0, 2), (-1, 0))}, "normal: '[0., 2.] of push 1'",
     "a vector of length 1; divide"),
    ({"normal": rows((0, 1), (0, -1), (1, 0))}, "normal: '[ 0., -1.] of push 1 and 1 more'",
     "a vector into the object; reverse it"),
    ({"displacement": rows((0, 9), (0, 0.2), (0, 0.2))}, "displacement: '9. of push 0'",
     "at most 3 times the size 2 of square; the pose jumps: leave the push out"),
    ({"finger_displacement": rows((0, 0.2), (0, -0.2), (-0.2, 0))},
     "finger_displacement: '[ 0. , -0.2] of push 1'", "a motion into the object, along the normal"),
    ({"finger_radius": ("push", [0.0, -1.0, 0.0])}, "finger_radius: '-1. of push 1'", "numbers >= 0"),
    ({"force": (("push", "xy"), [(1, np.nan), (1, 1), (np.nan, np.nan)])}, "force: '[ 1., nan] of push 0'",
     "both"),
    ({"finger_path": path(PATH)["finger_path"]}, "pushes: 'a dataset without path_time'",
     "one with every"),
    (path(PATH + 0.1), "finger_path: '[[0.1, 0.1], [0.1, 0.3]] of push 0 and 2 more'",
     "displacements since the first touch"),
    (path(PATH, np.ones((3, 2))), "path_time: '[1., 1.] of push 0 and 2 more'", TIMES),
    (path(np.where(PATH < 0, np.nan, PATH)), "finger_path: '[[ 0., 0.], [nan, 0.]] of push 2'",
     "at least two samples with NaN only after"),
    (shares(0.5, 0.5), "foot_weight: 'without feet'", "weights of feet; add the places of the feet"),
    (FEET | shares(0.5, 0.6), "foot_weight: '[0.5, 0.6] of object 0'", "fractions >= 0 whose sum is 1"),
    (FEET | shares(1.5, -0.5), "foot_weight: '[ 1.5, -0.5] of object 0'",
     "fractions >= 0 whose sum is 1"),
])  # fmt: skip
def test_what_is_wrong_is_said_in_a_line(changes, given, allowed):
    with pytest.raises(pp.InvalidValue) as error:
        require_pushes(small(**changes))
    assert str(error.value).startswith(f"{given} given; allowed: {allowed}"), str(error.value)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(("given", "said"), [
    ("pushes.nc", "pushes: 'str' given; allowed: a dataset of pushes; read one with load_pushes"),
    (small().isel(push=[]), "pushes: 'no push' given; allowed: at least one push"),
    (small().isel(xy=[0]), "xy: ['x'] given; allowed: x, y"),
    (small().drop_vars("object"), "object: [] given; allowed: a name for each object"),
])  # fmt: skip
def test_other_things_than_pushes(given, said):
    with pytest.raises(pp.InvalidValue) as error:
        require_pushes(given)
    assert str(error.value).startswith(said), str(error.value)
