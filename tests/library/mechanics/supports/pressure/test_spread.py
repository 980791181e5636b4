"""Second moments of supports, against quadrature."""

import numpy as np
import pytest
from mechanics.supports.cases import SUPPORTS
from mechanics.supports.quadrature import sampled

from planar_pushing.mechanics.pressure.table import table_of, table_of_pieces


@pytest.mark.parametrize("name", SUPPORTS)
def test_second_moments_are_means_over_the_support(name):
    support, _ = SUPPORTS[name]
    places, shares = sampled(support)
    x, y = (places - support.center_of_pressure).T
    expected = np.array([shares @ (x * x), shares @ (x * y), shares @ (y * y)])
    found = table_of_pieces(support.pieces(), 1.0).spreads[0]
    assert found == pytest.approx(expected, rel=1e-13, abs=1e-15 * support.extent**2)
    in_extents = table_of([support]).spreads[0]
    assert in_extents * support.extent**2 == pytest.approx(found, rel=1e-14, abs=0)
