"""The exception family, and the values that its checks let through."""

from decimal import Decimal
from enum import StrEnum
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import planar_pushing as pp
from planar_pushing.terms import errors


class Choice(StrEnum):
    ONE = "one"
    OTHER = "other"


def test_one_exception_family():
    assert issubclass(pp.InvalidValue, pp.PlanarPushingError)
    assert issubclass(pp.InvalidFile, pp.PlanarPushingError)
    assert issubclass(pp.InvalidValue, ValueError)
    assert issubclass(errors.MissingExtra, (pp.PlanarPushingError, ImportError))


def test_a_refusal_keeps_its_parts():
    error = pp.InvalidValue("weight", -1.0, "a finite number > 0", "leave the effect out")
    assert (error.name, error.given, error.allowed, error.remedy) == error.args
    assert str(error) == "weight: -1.0 given; allowed: a finite number > 0; leave the effect out"


@pytest.mark.parametrize("given", [
    10**400, 10**5000, [10**5000], "x" * 10_000, "two\nlines", list(range(10**6)), np.ones((99, 99)),
    {str(i): i for i in range(1000)}, xr.Dataset({"a": ("x", [1, 2])}),
], ids=lambda given: type(given).__name__)  # fmt: skip
def test_a_message_shows_at_most_a_line_of_the_value(given):
    shown = str(pp.InvalidValue("weight", given, "a number", "give one"))
    assert "\n" not in shown
    assert len(shown) < 250


@pytest.mark.parametrize("given", [
    "2", b"2", None, True, np.True_, Decimal(2), Fraction(1, 2), 2j, [2], np.array([2.0]), 10**400,
    float("nan"), np.float64("nan"), np.datetime64("2020"),
], ids=lambda given: type(given).__name__)  # fmt: skip
def test_what_is_no_number_is_refused_as_it_was_given(given):
    with pytest.raises(pp.InvalidValue) as caught:
        errors.require_positive("weight", given, "give one")
    assert caught.value.given is given or np.isnan(caught.value.given)


@pytest.mark.parametrize("given", [
    2, 2.0, np.float32(2), np.int8(2), np.uint64(2), np.array(2), xr.DataArray(2.0),
])  # fmt: skip
def test_numbers_of_any_type_become_floats(given):
    number = errors.require_positive("weight", given, "give one")
    assert (type(number), number) == (float, 2.0)


def test_sequences_of_numbers():
    assert errors.as_floats([1, np.float32(2)]) == (1.0, 2.0)
    assert errors.as_floats(5) == errors.as_floats(iter([1])) == ()
    assert np.isnan(errors.as_floats("12")).all()


@pytest.mark.parametrize(("given", "near"), [
    ("motioncone", "motion_cone"), ("Motion-Cone", "motion_cone"), ("motion cones", "motion_cone"),
    ("limitcurve", "LimitCurve"), ("vector", None), ("", None), ("x" * 10**6, None), (3, None),
    (None, None),
], ids=lambda given: str(given)[:12])  # fmt: skip
def test_a_similar_name_is_suggested_and_no_other(given, near):
    names = ("motion_cone", "LimitCurve", "None", "3")
    assert errors.similar_names(given, names) == ([] if near is None else [near])
    said = errors.suggestion(given, names, "choose one")
    assert said == ("choose one" if near is None else f"did you mean {near}?")


@pytest.mark.parametrize(("given", "said"), [
    ("--friction", "did you mean --friction-angle or --friction-coefficient?"),
    ("--rod", "did you mean --rod-angle, --rod-length or --rod-width?"),
    ("--rod-l", "did you mean --rod-length?"),
    ("rod_angle", "did you mean --rod-angle?"),
    ("--ro", "choose one"),
], ids=str)  # fmt: skip
def test_every_name_that_is_abbreviated_is_suggested(given, said):
    names = (
        "--friction-angle", "--friction-coefficient", "--rod-angle", "--rod-length", "--rod-width",
    )  # fmt: skip
    assert errors.suggestion(given, names, "choose one") == said


def test_a_text_stands_before_every_suggestion():
    said = errors.suggestion("pull", ("pulling", "pulling_lost"), "choose one", before="a/")
    assert said == "did you mean a/pulling or a/pulling_lost?"


@pytest.mark.parametrize("given", ["three", None, 1, ["one"], b"one"])
def test_an_option_is_refused_with_all_of_them(given):
    with pytest.raises(pp.InvalidValue, match="allowed: one, other; name one"):
        errors.require_option("choice", given, Choice, "name one")


def test_an_option_is_given_as_its_value_or_as_itself():
    for given in (Choice.ONE, "one", np.str_("one")):
        assert errors.require_option("choice", given, Choice, "name one") is Choice.ONE


@pytest.mark.parametrize("given", [5, None, b"scene.yaml", "sce\0ne.yaml"])
def test_a_path_is_text_or_a_path(given):
    assert errors.require_path("path", "a") == "a"
    assert errors.require_path("path", Path("a")) == Path("a")
    with pytest.raises(pp.InvalidValue, match="allowed: the path of a file"):
        errors.require_path("path", given)
