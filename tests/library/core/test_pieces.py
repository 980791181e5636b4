"""Coefficients and sums of the pieces of a support, and centers of rotation that are hard for them."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from mechanics.supports.cases import FRAME, SQUARE, SUPPORTS, rectangle
from mpmath import mp, mpf

from planar_pushing.core.supports import circles, lines, multipole, pieces
from planar_pushing.mechanics.kernels.calls import run
from planar_pushing.mechanics.pressure.table import table_of
from planar_pushing.mechanics.supports.points import Points
from planar_pushing.mechanics.supports.polygon import Polygon

ORDER, TERMS, ROWS = multipole.ORDER, multipole.TERMS, multipole.ROWS
#: Places of a term with m = j - k in the terms of a plate.
FIRST = [sum((ORDER - each) // 2 + 1 for each in range(m)) for m in range(ORDER + 2)]


def test_coefficients_of_a_short_line_are_those_of_its_series():
    """``z / (1 - z^2)`` minus ``atanh z``, divided by z^3."""
    exact = [1 - Fraction(1, 2 * k + 3) for k in range(len(lines.LINE_TORQUE))]
    assert list(lines.LINE_TORQUE) == [float(each) for each in exact]


def test_coefficients_of_a_distant_disc_are_those_of_its_series():
    """``2F1(1/2, 1/2; 3; y) / 4``, and of the derivative of the torque."""
    exact = [Fraction(1, 4)]
    for j in range(len(circles.DISC_TORQUE) - 1):
        exact.append(exact[-1] * Fraction(2 * j + 1, 2) ** 2 / ((j + 3) * (j + 1)))
    slope = [(2 * j + 1) * each for j, each in enumerate(exact)]
    for found, series in ((circles.DISC_TORQUE, exact), (circles.DISC_SLOPE, slope)):
        assert list(found) == pytest.approx([float(each) for each in series], rel=1e-15, abs=0)
        assert float(series[-1]) / circles.DISC_SERIES ** (2 * len(series)) < 1e-16


def terms_of(vertices):
    """Terms of a polygon as complex numbers, and whether each m counts; its vertices in radii."""
    table = table_of([Polygon(vertices)])
    plate = int(table.head.plates[0])
    x, y, radius = table.data[plate : plate + 3]
    numbers = table.data[int(table.head.series[0]) :].reshape(ROWS, 2)
    size = Polygon(vertices).extent
    placed = (np.array(Polygon(vertices).vertices) / size - [x, y]) / radius
    return numbers @ [1, 1j], numbers[TERMS:, 0], placed


def moment(vertices, j, k):
    """Mean of z^j conj(z)^k over a polygon, by triangles from the origin and exact sums over them.

    Over a triangle (0, a, b) it is a double binomial sum of ``s^n (1 - t)^p t^q``.
    """
    total, area, n = mpf(0), mpf(0), j + k
    corners = [mp.mpc(*each) for each in vertices.tolist()]
    beta = [mp.beta(n - m + 1, m + 1) for m in range(n + 1)]
    for a, b in pairwise([*corners, corners[0]]):
        twice = (mp.conj(a) * b).imag
        ones = [mp.binomial(j, u) * a ** (j - u) * b**u for u in range(j + 1)]
        others = [mp.conj(mp.binomial(k, v) * a ** (k - v) * b**v) for v in range(k + 1)]
        mean = mpf(0)
        for u, one in enumerate(ones):
            mean += one * sum(other * beta[u + v] for v, other in enumerate(others))
        total += twice * mean / (n + 2)
        area += twice / 2
    return total / area


@pytest.mark.parametrize("name", ["triangle", "L", "star"])
def test_terms_of_a_plate_are_its_moments(name):
    terms, counts, vertices = terms_of(SUPPORTS[name][0].vertices)
    with mp.workdps(60):
        root = [mp.binomial(mpf(1) / 2, j) * (-1) ** j for j in range(ORDER + 1)]
        for j, k in ((0, 0), (1, 1), (2, 0), (3, 0), (2, 1), (5, 3), (9, 0), (13, 12), (40, 12)):
            exact = root[j] * root[k] * moment(vertices, j, k) * (2 if j > k else 1)
            found = terms[FIRST[j - k] + k]
            assert abs(found - complex(exact)) <= 4e-15 * abs(root[j] * root[k])
    assert terms[FIRST[1]] == 0
    assert counts[2] == 1
    assert FIRST[-1] == TERMS


@pytest.mark.parametrize(("half_width", "symmetry"), [(1.0, 4), (0.5, 2)])
def test_only_the_orders_of_a_symmetry_count(half_width, symmetry):
    _, counts, _ = terms_of(rectangle(1.0, half_width).vertices)
    orders = np.flatnonzero(counts)
    assert orders[:3].tolist() == [0, symmetry, 2 * symmetry]
    assert (orders % symmetry == 0).all()


def test_results_do_not_depend_on_what_was_in_their_memory():
    table = table_of([FRAME, SQUARE])
    plates = table.head.plates.astype(int)  # one for each support
    rows = table.data[plates[:, None] + [2, 4, 5]]
    results = np.full((2, 2 * ROWS), np.nan)
    multipole.plate_terms(
        memoryview(table.data),
        memoryview(rows.ravel()),
        2,
        3,
        memoryview(results.ravel()),
        2 * ROWS,
    )
    assert np.array_equal(results.ravel(), table.data[int(table.head.series[0]) :])


def pressure_of(support):
    return pieces.pressure_at(memoryview(table_of([support]).data), 0)


@pytest.mark.parametrize("name", SUPPORTS)
def test_the_center_of_pressure_is_that_of_the_support(name):
    support, _ = SUPPORTS[name]
    pressure = pressure_of(support)
    center = np.array(support.center_of_pressure) / support.extent
    assert (pressure.center_x, pressure.center_y) == pytest.approx(center, abs=1e-15)
    # About itself a support resists with D, whatever G is.
    found = pieces.pressure_moments(pressure, pressure.center_x, pressure.center_y, 0.0)
    assert found.torque == pytest.approx(found.distance, rel=1e-13, abs=0)


def test_a_blurred_center_is_on_every_atom_within_the_blur():
    support = Points([(0.0, 0.0), (1e-3, 0.0), (1.0, 0.0), (0.0, 1.0)])
    pressure, size = pressure_of(support), support.extent
    assert pieces.count_atoms(pressure) == 4
    for i, (x, y) in enumerate(support.positions):
        atom = pieces.atom_of(pressure, i)
        assert (atom.x, atom.y, atom.share) == pytest.approx(
            (x / size, y / size, 0.25), rel=1e-15, abs=0
        )
    offsets = np.array(support.positions) - [4e-4, 0.0]
    away = np.hypot(*offsets.T)
    # The last atom within the blur is named, and none of them has a direction.
    for blur, atom in ((0.0, -1), (5e-4, 0), (7e-4, 1)):
        found = pieces.pressure_moments(pressure, 4e-4 / size, 0.0, blur / size)
        units = (offsets / away[:, None])[away > blur].sum(axis=0) / 4
        assert found.atom == atom
        assert (found.unit_x, found.unit_y) == pytest.approx(units, rel=1e-13)
        assert found.distance == pytest.approx(away.mean() / size, rel=1e-14)


@pytest.mark.parametrize("name", SUPPORTS)
@pytest.mark.parametrize("c", [(np.nan, 0.0), (0.0, np.nan), (np.inf, np.nan), (0.0, -np.inf)])
def test_a_center_that_is_nowhere_gives_no_number(name, c):
    found = pieces.pressure_moments(pressure_of(SUPPORTS[name][0]), *c, 0.0)
    assert not np.isfinite(found.distance)


def test_the_kernel_writes_the_fields_in_order():
    table = table_of([SUPPORTS["points"][0]])
    x, y, share = table.atoms(0)[1]
    pressure = pieces.pressure_at(memoryview(table.data), 0)
    found = run("moments", table.data, [[0.0, x, y], [0.0, 0.4, -3.0]], 8)
    for row, c in zip(found.tolist(), ((x, y), (0.4, -3.0)), strict=True):
        assert row == list(pieces.pressure_moments(pressure, *map(float, c), 0.0))
    assert found[:, 7].tolist() == [1.0, -1.0]
    assert share == pytest.approx(1 / 3)
