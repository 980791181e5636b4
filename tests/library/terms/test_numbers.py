"""The door of numbers: what becomes doubles, and what is refused."""

from __future__ import annotations

import array
import datetime
import math
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pandas as pd
import pytest
import xarray as xr

from planar_pushing.terms.errors import InvalidValue, as_float, as_floats, require_flag
from planar_pushing.terms.numbers import (
    as_array,
    as_numbers,
    in_radians,
    pair_of,
    require_array,
)

LABELED = xr.DataArray([1, 2], dims="case", coords={"case": [7, 8]}, attrs={"units": "m"})
#: Values, and the doubles that they are.
NUMBERS = [
    (2, 2.0), (2.5, 2.5), (2**70, 2.0**70), (math.inf, math.inf),
    ([1, 2.5], [1.0, 2.5]), (((1, 2), [3, 4.0]), [[1.0, 2.0], [3.0, 4.0]]), ([], []),
    ([2**70, 1], [2.0**70, 1.0]), ([np.float32(0.5), np.int8(-3)], [0.5, -3.0]),
    ([np.array([1, 2], "u1"), (3, 4)], [[1.0, 2.0], [3.0, 4.0]]),
    *((np.array([3, 120], dtype), [3.0, 120.0]) for dtype in ("i1", "u2", "i4", "u8", "f2", "f4", "f8")),
    (np.array([3, 4], ">i4"), [3.0, 4.0]), (np.longdouble(2.5), 2.5), (np.array(2.5), 2.5),
    (np.array([1, 2.5], dtype=object), [1.0, 2.5]), (np.float16(0.5), 0.5), (np.uint64(2**63), 2.0**63),
    (np.ma.masked_array([1, 2]), [1.0, 2.0]), (np.ma.masked_array([1, 2], [False, False]), [1.0, 2.0]),
    (pd.Series([1, 2], index=[1, 0]), [1.0, 2.0]), (pd.Series([1.0, 2.5], dtype="Float32"), [1.0, 2.5]),
    (pd.DataFrame({"x": [1, 2], "y": [0.5, 1.5]}), [[1.0, 0.5], [2.0, 1.5]]),
    (pd.Index([1, 2]), [1.0, 2.0]),
    (range(3), [0.0, 1.0, 2.0]), (array.array("h", [1, 2]), [1.0, 2.0]), (LABELED, [1.0, 2.0]),
    (LABELED.chunk(case=1), [1.0, 2.0]),
]  # fmt: skip
#: Values that are not plain numbers.
OTHERS = [
    None, "2", b"2", True, np.True_, 1j, np.complex64(1), Decimal(1), Fraction(1), 10**400, {1.0},
    {1.0: 2.0},
    np.datetime64("2020"), np.timedelta64(2, "s"), datetime.date(2020, 1, 1), pd.Timestamp("2020"),
    ["1", 2.0], [b"1", 2.0], [True, 2.0], (1.0, (True,)), [None, 1.0], [1j, 1.0], [10**400, 1.0],
    [[1.0], [1.0, 2.0]], [np.array([True, False]), [1.0, 2.0]], [Decimal(1)],
    *(np.ones(2, "i8").astype(dtype) for dtype in (bool, complex, str, bytes, "M8[D]", "m8[s]")),
    np.array([1.0, True], dtype=object), np.array([1.0, "2"], dtype=object), np.array(2.0, dtype=object),
    np.array([10**400, 1], dtype=object), np.zeros(2, [("x", float)]),
    np.ma.masked, np.ma.masked_array([1.0, 2.0], [True, False]), [np.ma.masked, 1.0],
    pd.Series([True, False]), pd.Series(["1", "2"]), pd.Series(pd.to_datetime(["2020", "2021"])),
    pd.Series([1.0, None], dtype=object), pd.DataFrame({"x": [1.0], "y": [True]}),
    xr.Dataset({"x": ("case", [1.0])}), xr.DataArray([True, False]), xr.DataArray(["1"]), iter([1.0]),
]  # fmt: skip


def kind(value):
    return f"{type(value).__name__}-{getattr(value, 'dtype', '')}"


@pytest.mark.parametrize(("given", "expected"), NUMBERS, ids=kind)
def test_numbers_become_doubles(given, expected):
    found = as_array(given)
    assert type(found) is np.ndarray
    assert found.dtype == np.float64
    assert found.shape == np.shape(expected)
    assert np.array_equal(found, expected)


@pytest.mark.parametrize("given", OTHERS, ids=kind)
def test_everything_else_is_refused_in_one_line(given):
    assert as_array(given) is None
    assert as_numbers(given) is None
    with pytest.raises(InvalidValue, match=r"^places: .* given; allowed: numbers; ") as caught:
        require_array("places", given, "numbers", "give floats")
    assert "\n" not in str(caught.value)
    masked = np.ma.is_masked(given)
    assert caught.value.remedy == (
        "fill the masked entries, or leave them out" if masked else "give floats"
    )


@pytest.mark.parametrize("given", [*OTHERS, *(each for each, _ in NUMBERS)], ids=kind)
def test_the_door_of_single_numbers_agrees(given):
    found = as_array(given)
    single = found is not None and found.ndim == 0
    assert as_float(given) == found if single else math.isnan(as_float(given))


@pytest.mark.parametrize(
    ("given", "kind"),
    [(2, float), (2.5, float), (np.float64(2.5), np.float64), (np.int8(2), np.float64),
     (np.array(2), np.float64), ([1, 2], np.ndarray), (pd.Series([1, 2]), np.ndarray)],
)  # fmt: skip
def test_a_number_stays_a_number(given, kind):
    assert type(as_numbers(given)) is kind


def test_labels_stay_and_lazy_arrays_stay_lazy():
    found = as_numbers(LABELED)
    assert found.dtype == np.float64
    xr.testing.assert_identical(found, LABELED.astype(float, keep_attrs=True))
    doubles = LABELED.astype(float).chunk(case=1)
    assert as_numbers(doubles) is doubles


@pytest.mark.parametrize(
    ("given", "found"),
    [((1, 2.5), (1.0, 2.5)), (np.array([1, 2], "i1"), (1.0, 2.0)), (np.array(1.0), ()), (3, ()),
     ({1.0: 2.0}, ()), ({1.0}, ())],
)  # fmt: skip
def test_entries_of_a_sequence(given, found):
    assert as_floats(given) == found


@pytest.mark.parametrize("given", [True, False, np.True_, np.array(False), 0, 1])
def test_flags(given):
    assert require_flag("cones", given) is bool(given)


@pytest.mark.parametrize("given", [None, "yes", 2, 0.5, [True], np.array([True, False])], ids=repr)
def test_what_is_no_flag(given):
    with pytest.raises(InvalidValue, match=r"^cones: .* given; allowed: True or False; "):
        require_flag("cones", given)


@pytest.mark.parametrize("degrees", [0.0, -90.0, 359.0, -720.0, 720.0])
def test_radians_within_two_turns_are_those_of_numpy(degrees):
    assert in_radians(degrees) == np.deg2rad(degrees)


@pytest.mark.parametrize(
    ("degrees", "less"), [(7290.0, 90.0), (-7290.0, -90.0), (1e6, 280.0), (721.0, 1.0)]
)
def test_radians_beyond_two_turns_lose_whole_turns(degrees, less):
    assert in_radians(degrees) == np.deg2rad(less)
    assert np.array_equal(in_radians(np.array([degrees, 30.0])), np.deg2rad([less, 30.0]))


@pytest.mark.parametrize(
    ("given", "pair"),
    [
        ((1, "b"), (1, "b")), ([1.0, None], (1.0, None)), (np.array([1, 2], "u1"), (1, 2)),
        (np.array([1.5, 2.5], "f4"), (1.5, 2.5)), (np.ones(3), None), (np.ones((2, 1)), None),
        (np.ones(()), None), ((1,), None), ("ab", None), ({1: 2, 3: 4}, None), (LABELED, None),
    ],
)  # fmt: skip
def test_pairs(given, pair):
    found = pair_of(given)
    assert found == pair
    assert pair is None or list(map(type, found)) == list(map(type, pair))
