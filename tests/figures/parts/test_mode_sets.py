"""Codes of sets of contact modes."""

import numpy as np
import pytest
import xarray as xr

import planar_pushing as pp
from planar_pushing.figures.parts.mode_sets import LEFT, RIGHT, SEPARATE, STICK, mode_sets


@pytest.mark.parametrize(
    ("modes", "code"),
    [
        ([-1, -1, -1], 0),
        ([1, -1, -1], STICK),
        ([0, 1, 3], SEPARATE | STICK | LEFT),
        ([2, 2, -1], RIGHT),  # two slips of one mode
        ([0, 3, 3], SEPARATE | LEFT),
    ],
)
def test_the_code_of_a_set_of_modes(modes, code):
    found = mode_sets(xr.DataArray(np.array(modes, np.int8), dims="solution"))
    assert found.dtype == np.int8
    assert int(found) == code


def test_the_codes_of_an_array_are_those_of_each_push():
    slider = pp.Slider(rod_length=2.0, rod_angle=np.pi / 4)
    effects = (pp.RingFriction(), pp.Inertia())
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(1.4), effects=effects)
    angle = xr.DataArray(np.deg2rad(np.arange(-5.0, 40.0)), dims="angle")
    found = pp.solve(scene, angle, 2.0)
    codes = mode_sets(found["mode"])
    assert codes.dims == ("angle",)
    assert (found.solutions > 2).any()  # two slips of one mode, and no contact
    assert len(np.unique(codes)) > 2
    for given, code in zip(angle.values, codes.values, strict=True):
        modes = set(pp.solve(scene, float(given), 2.0).modes)
        assert code == sum(1 << mode for mode in modes)
