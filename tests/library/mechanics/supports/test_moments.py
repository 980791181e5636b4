"""Moments of supports: published values, 1e-14 everywhere, derivatives, and the atom that is hit."""

from __future__ import annotations

import os
import subprocess
import sys

import numpy as np
import pytest
from mechanics.supports.cases import SQUARE, SUPPORTS, TRIPOD, hard_centers, rows_of
from mechanics.supports.exact import about, exact_moments
from mpmath import mp, mpf

from planar_pushing.core.supports.piece_rows import COLUMNS
from planar_pushing.mechanics.pressure.table import moments, table_of_pieces
from planar_pushing.mechanics.supports.disc import Disc
from planar_pushing.mechanics.supports.points import Points

#: Center of rotation, D, G_x, G_y and the torque, from numerical integrals.
PUBLISHED = [
    (
        SQUARE,
        (0.3, 0.2),
        0.822023641611253,
        -0.260676603222042,
        -0.172647824905904,
        0.70929109566346,
    ),
    (
        SQUARE,
        (1.0, 1.0),
        1.530391432928425,
        -0.647793574696319,
        -0.647793574696319,
        0.234804283535787,
    ),
    (SQUARE, (5.0, 0.0), 5.03357516526378, -0.993189332404797, 0.0, 0.067628503239797),
    (Disc(1.0), (0.5, 0.0), 0.789670232587264, -0.483843755630126, 0.0, 0.547748354772201),
    (Disc(1.0), (1.0, 0.0), 32 / 9 / np.pi, -8 / 3 / np.pi, 0.0, 8 / 9 / np.pi),
    (Disc(1.0), (100.0, 0.0), 100.0012500052084, -0.999987499843745, 0.0, 0.0025000208339193),
    (
        TRIPOD,
        (0.3, 0.2),
        1.033929193673725,
        -0.135743710409409,
        -0.144909039717126,
        0.964224272607477,
    ),
]


def at(support, c, radius=1.0):
    return moments(table_of_pieces(support.pieces(), radius), float(c[0]), float(c[1]))


@pytest.mark.parametrize(("support", "c", "distance", "unit_x", "unit_y", "torque"), PUBLISHED)
def test_published_values(support, c, distance, unit_x, unit_y, torque):
    found = at(support, c)
    assert found.distance == pytest.approx(distance, rel=1e-15, abs=0)
    assert found[1:4] == pytest.approx((unit_x, unit_y, torque), abs=1.5e-15)
    assert found.atom == -1


def test_the_torque_of_a_square_from_afar_has_all_its_digits():
    assert at(SQUARE, (1e6, 0.0)).torque == pytest.approx(3.333333333334556e-7, rel=1e-14, abs=0)


@pytest.mark.parametrize("count", [18, pytest.param(36, marks=pytest.mark.slow)])
@pytest.mark.parametrize("name", SUPPORTS)
def test_moments_to_1e_14_wherever_the_slider_turns(name, count):
    support, aspect = SUPPORTS[name]
    table, size = table_of_pieces(support.pieces(), 1.0), support.extent
    allowed = 1e-14 * max(1.0, aspect / 20)
    pieces = (table.head.end[0] - table.head.atoms[0]) / COLUMNS
    for c in hard_centers(support, count // 3 if pieces > 20 else count):
        found = moments(table, *c)
        if found.atom < 0:
            exact = exact_moments(support, c)
            errors = np.array([abs(float(a - b)) for a, b in zip(found[:4], exact, strict=True)])
            assert (errors <= allowed * np.array([np.hypot(*c) + size, 1, 1, size])).all(), c


@pytest.mark.parametrize("name", SUPPORTS)
def test_derivatives_are_those_of_the_mean_distance(name):
    """G and the second derivatives, against differences in 50 digits; away from where they jump."""
    support, _ = SUPPORTS[name]
    middle, size = np.array(support.center_of_pressure), support.extent
    step = mpf(10) ** -18 * size
    for offset in ((0.137, 0.211), (1.03, -0.45), (2.6, 1.3), (31.0, 57.0)):
        c = middle + size * np.array(offset)
        found = at(support, c)
        with mp.workdps(50):
            x, y = map(mpf, c)
            ahead = [about(support, x + step, y), about(support, x, y + step)]
            behind = [about(support, x - step, y), about(support, x, y - step)]
            slopes = [
                [float((a - b) / (2 * step)) for a, b in zip(*pair, strict=True)]
                for pair in zip(ahead, behind, strict=True)
            ]
        assert found[1:3] == pytest.approx([-slopes[0][0], -slopes[1][0]], abs=5e-14)
        (_, xx, xy), (_, yx, yy) = slopes
        assert found[4:7] == pytest.approx([-xx, -xy, -yy], abs=2e-11 / size)
        assert xy == pytest.approx(yx, abs=1e-12)


@pytest.mark.parametrize("i", range(3))
def test_an_atom_that_is_hit_is_named_and_gives_no_force(i):
    support, _ = SUPPORTS["points"]
    table = table_of_pieces(support.pieces(), 1.0)
    place = np.array(support.positions[i])
    others = Points(
        [p for j, p in enumerate(support.positions) if j != i],
        [w for j, w in enumerate(support.weights) if j != i],
    )
    share = 1 - support.weights[i] / sum(support.weights)
    rest = at(others, place)
    for gap in (0.0, 2e-16):
        found = moments(table, place[0] + gap, place[1])
        assert found.atom == i
        assert np.array(found[:3]) == pytest.approx(share * np.array(rest[:3]), rel=1e-14, abs=0)
        assert np.isfinite(found).all()
    assert moments(table, place[0] + 1e-13, place[1]).atom == -1


@pytest.mark.parametrize("count", range(1, 20))
def test_any_number_of_points_adds_up(count):
    """The compiler adds several points at once, and those that are left one by one."""
    random_of = np.random.default_rng(count)
    places, loads = random_of.normal(size=(count, 2)), random_of.uniform(0.1, 1.0, count)
    support, shares = Points(places, loads), loads / loads.sum()
    for i, c in enumerate([*places, np.array([0.3, 0.2])]):
        found, offset = at(support, c), places - c
        distance = np.hypot(*offset.T)
        apart = distance > 0
        unit = (shares[:, None] * offset)[apart] / distance[apart, None]
        torque = ((places - shares @ places)[apart] * unit).sum()
        assert found.atom == (i if i < count else -1)
        assert found.distance == pytest.approx(shares @ distance, abs=1e-15 * count)
        assert found[1:4] == pytest.approx((*unit.sum(axis=0), torque), abs=1e-15 * count)


def test_calls_keep_no_reference_to_the_arrays():
    table = table_of_pieces(SUPPORTS["composite"][0].pieces(), 1.0)
    before = sys.getrefcount(table.data)
    for c in [(0.3, 0.2), (4.0, 3.0)] * 20:
        moments(table, *c)
    after = sys.getrefcount(table.data)
    assert after == before


def test_atoms_at_one_place_are_one():
    double = Points([(1.0, 0.0), (0.0, 0.0), (1.0, 0.0)], [1.0, 2.0, 3.0])
    table = table_of_pieces(double.pieces(), 1.0)
    assert rows_of(table, "atoms")[:, :3].tolist() == [[1.0, 0.0, 4 / 6], [0.0, 0.0, 2 / 6]]
    assert at(double, (1.0, 0.0)).atom == 0


def test_the_table_is_in_units_of_the_radius_and_its_array_is_contiguous():
    support, _ = SUPPORTS["composite"]
    one, other = table_of_pieces(support.pieces(), 1.0), table_of_pieces(support.pieces(), 2.5)
    assert one.data.flags.c_contiguous
    assert one.data.dtype == np.float64
    found, scaled = moments(one, 0.5, -0.7), moments(other, 0.2, -0.28)
    assert np.array(scaled[:4]) * [2.5, 1, 1, 2.5] == pytest.approx(found[:4], abs=3e-15)
    assert np.array(scaled[4:7]) == pytest.approx(2.5 * np.array(found[4:7]), rel=1e-12, abs=0)


PLAIN = """
from mechanics.supports.cases import SUPPORTS
from planar_pushing.mechanics.pressure.table import moments
from planar_pushing.mechanics.pressure.table import table_of_pieces
for support, _ in SUPPORTS.values():
    table = table_of_pieces(support.pieces(), 1.0)
    print(*(float(each) for c in ((0.3, 0.2), (4.0, 3.0)) for each in moments(table, *c)))
"""


def test_the_source_gives_the_same_numbers_without_the_compiler():
    found = subprocess.run(
        [sys.executable, "-c", PLAIN],
        env={**os.environ, "PLANAR_PUSHING_PLAIN": "1", "PYTHONPATH": os.pathsep.join(sys.path)},
        capture_output=True, text=True, check=True,
    ).stdout  # fmt: skip
    for line, (support, _) in zip(found.splitlines(), SUPPORTS.values(), strict=True):
        table = table_of_pieces(support.pieces(), 1.0)
        expected = [each for c in ((0.3, 0.2), (4.0, 3.0)) for each in moments(table, *c)]
        assert list(map(float, line.split())) == expected
