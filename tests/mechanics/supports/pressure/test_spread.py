"""Second moments of supports, against quadrature."""

import numpy as np
import pytest

from mechanics.supports.cases import SUPPORTS
from mechanics.supports.quadrature import sampled
from planar_pushing.mechanics.supports.pressure.assembly import assembled
from planar_pushing.mechanics.supports.pressure.table import pressure_of, table_of


@pytest.mark.parametrize("name", SUPPORTS)
def test_second_moments_are_means_over_the_support(name):
    support, _ = SUPPORTS[name]
    places, shares = sampled(support)
    x, y = (places - support.center_of_pressure).T
    expected = np.array([shares @ (x * x), shares @ (x * y), shares @ (y * y)])
    found = np.array(assembled(support.pieces(), 1.0).spread)
    assert found == pytest.approx(expected, rel=1e-13, abs=1e-15 * support.extent**2)
    in_extents = pressure_of(table_of([support]), 0).spread
    assert np.array(in_extents) * support.extent**2 == pytest.approx(found, rel=1e-14, abs=0)
