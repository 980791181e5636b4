"""Every support, and the closed forms that it is tested against, against the defining sums over points."""

from __future__ import annotations

import numpy as np
import pytest
from mechanics.supports.cases import SUPPORTS
from mechanics.supports.exact import exact_moments
from mechanics.supports.quadrature import sampled

import planar_pushing as pp
from planar_pushing.mechanics.pressure.table import moments, table_of, table_of_pieces

#: Centers of rotation away from the supports, in reaches: the narrow ones on their long sides' axis.
PLACES = [(3.0, 0.4), (2.2, -2.6), (-9.0, 30.0)]


@pytest.mark.parametrize("name", SUPPORTS)
def test_the_rule_is_one_of_the_support(name):
    support, _ = SUPPORTS[name]
    places, shares = sampled(support)
    assert shares.sum() == pytest.approx(1, rel=1e-14, abs=0)
    assert shares @ places == pytest.approx(support.center_of_pressure, abs=1e-14)
    reach = np.hypot(*(places - support.center_of_pressure).T).max()
    assert 0.9 * support.extent < reach <= support.extent * (1 + 1e-14)


@pytest.mark.parametrize("place", PLACES, ids=str)
@pytest.mark.parametrize("name", SUPPORTS)
def test_moments_in_closed_form_are_sums_over_points(name, place):
    """Of the library, and in many digits."""
    support, _ = SUPPORTS[name]
    middle, size = np.array(support.center_of_pressure), support.extent
    c = middle + size * np.array(place)
    places, shares = sampled(support)
    away = places - c
    rho = np.hypot(*away.T)
    unit = away / rho[:, None]
    torque = shares @ ((places - middle) * unit).sum(axis=1)
    sums = np.array([shares @ rho / np.hypot(*c), *(shares @ unit), torque / size])
    for found in (
        moments(table_of_pieces(support.pieces(), 1.0), *c)[:4],
        exact_moments(support, c),
    ):
        own = np.array([float(each) for each in found]) / [np.hypot(*c), 1, 1, size]
        assert own == pytest.approx(sums, rel=1e-13, abs=1e-12)


@pytest.mark.parametrize("twist", [(1.0, 0.2, 0.05), (-0.3, 2.0, -0.2), (0.0, -1.0, 0.0)], ids=str)
@pytest.mark.parametrize("name", SUPPORTS)
def test_wrench_and_potential_are_sums_over_points(name, twist):
    """Coulomb friction at each point, about the slider's center; per unit of the support's reach."""
    support, _ = SUPPORTS[name]
    v_x, v_y, spin = np.array(twist) / (1, 1, support.extent)
    places, shares = sampled(support)
    slides = np.column_stack([v_x - spin * places[:, 1], v_y + spin * places[:, 0]])
    speeds = np.hypot(*slides.T)
    forces = 1.7 * shares[:, None] * slides / speeds[:, None]
    torque = places[:, 0] @ forces[:, 1] - places[:, 1] @ forces[:, 0]
    friction = pp.SupportFriction(support=support, weight=1.7)
    found = pp.wrench(friction, (v_x, v_y, spin))
    assert found == pytest.approx([*forces.sum(axis=0), torque], abs=2e-12)
    assert pp.potential(friction, (v_x, v_y, spin)) == pytest.approx(
        1.7 * shares @ speeds, rel=1e-12, abs=0
    )


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
