"""Contact laws, and what the compiled core knows of them."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

import planar_pushing as pp
from planar_pushing.mechanics.contact import ContactLaw, as_numbers, friction_coefficient, is_law

LAWS = {
    pp.Coulomb(1.0): (np.pi / 4, 3 * np.pi / 4, True, True, False),
    pp.Coulomb(0.0): (np.pi / 2, np.pi / 2, True, True, False),
    pp.InfiniteFriction(): (0.0, np.pi, True, True, False),
    pp.InfiniteFriction("none"): (0.0, np.pi, False, False, False),
    pp.PerfectlyRough(): (-np.pi / 2, 3 * np.pi / 2, False, True, True),
}


@pytest.mark.parametrize("law", LAWS, ids=str)
def test_a_law_in_numbers(law):
    assert as_numbers(law) == pytest.approx(LAWS[law], rel=1e-16, abs=0)
    assert is_law(law)
    assert isinstance(law, ContactLaw)


def test_an_array_of_laws_in_numbers():
    laws = np.array([*LAWS, pp.Coulomb(3.0)], dtype=object).reshape(2, 3)
    found = as_numbers(laws)
    for i, law in enumerate(laws.ravel()):
        assert tuple(column.ravel()[i] for column in found) == as_numbers(law)
    labeled = as_numbers(xr.DataArray(laws, dims=("one", "other")))
    for column, expected in zip(labeled, found, strict=True):
        assert column.dims == ("one", "other")
        assert np.array_equal(column.values, expected)


def test_a_coefficient_may_be_an_array():
    mu = np.array([[0.0, 1.0], [2.0, 1e9]])
    found = as_numbers(pp.Coulomb(mu))
    assert np.array_equal(found.right, np.arctan2(1.0, mu))
    assert np.array_equal(found.left, np.pi - np.arctan2(1.0, mu))
    assert (found.slips, found.closed, found.rough) == (True, True, False)


def test_a_class_is_no_law():
    assert not is_law(pp.PerfectlyRough)
    assert not is_law(0.3)


def test_coefficient_of_every_law():
    assert friction_coefficient(pp.Coulomb(0.3)) == 0.3
    assert friction_coefficient(pp.InfiniteFriction()) == np.inf
    assert friction_coefficient(pp.PerfectlyRough()) == np.inf
