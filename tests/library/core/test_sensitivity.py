"""Derivatives of solutions from one linear system: closed forms, exact elimination, and many feet."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.core.instant import elimination, sensitivity
from planar_pushing.core.numbers import zeros
from planar_pushing.core.supports import rows
from planar_pushing.mechanics.kernels.calls import run
from planar_pushing.mechanics.kernels.columns import row_of
from planar_pushing.mechanics.pressure.table import joined_data

SIDE = elimination.SIDE
LEVERS = [0.0, 1e-3, 1.0, 1e3, 1e6]
GYRATION = 0.49
#: A mass of 2 at the origin.
MASS = row_of(rows.MassRow, mass=2.0, gyration=GYRATION, center_x=0.0, center_y=0.0)


def responses(kind, numbers, width, **solution):
    """A row of results for one effect and a solution without a pivot."""
    row = row_of(sensitivity.ResponseRow, pivot=-1, changes=0, place=0.0, held=0, **solution)
    data = joined_data([(kind, 0, None)], len(numbers))
    return run("responses", data, [[*numbers, *row]], width)[0]


def derivatives(condition, lever, twist, force, edge):
    """Status, and derivatives of the twist and the force of a mass whose rod is along the fence."""
    result = responses(
        rows.MASS, MASS, 1 + 5 * 6, length=lever, angle=0.0, twist=[*twist], force=[*force],
        edge=edge, condition=condition,
    )  # fmt: skip
    return int(result[0]), result[1:].reshape(5, 6)


@pytest.mark.parametrize("lever", LEVERS)
def test_a_mass_under_a_given_force_has_derivatives_in_closed_form(lever):
    """The force across the rod turns the mass by its lever, however long it is."""
    force = np.array([0.6, 0.8])
    twist = [*force / 2.0, -lever * force[1] / (2.0 * GYRATION)]
    edge = np.arctan2(0.8, 0.6)
    status, by = derivatives(sensitivity.FORCE_CASE, lever, twist, force, edge)
    assert status == sensitivity.SMOOTH
    turned = np.array([-0.8, 0.6])
    for k, (x, y) in ((0, force), (4, turned)):
        expected = [x / 2.0, y / 2.0, -lever * y / (2.0 * GYRATION), x, y]
        assert by[:, k] == pytest.approx(expected, rel=1e-15, abs=1e-300)
    # The force has the lever (lever, 0) - (x, y) after a shift of the contact by (x, y).
    assert by[:, 2] == pytest.approx([0, 0, 0.8 / (2.0 * GYRATION), 0, 0], rel=1e-15)
    assert by[:, 3] == pytest.approx([0, 0, -0.6 / (2.0 * GYRATION), 0, 0], rel=1e-15)
    assert by[:, 5] == pytest.approx([-twist[0], -twist[1], -twist[2], 0, 0], rel=1e-15)


@pytest.mark.parametrize("lever", LEVERS)
def test_a_mass_that_sticks_has_derivatives_in_closed_form(lever):
    """Across the rod, the contact of a mass moves as if it were lighter by its lever."""
    share = GYRATION / (GYRATION + lever**2)
    twist = [0.3, share, -share * lever / GYRATION]
    force = [0.6, 2.0 * share]
    status, by = derivatives(sensitivity.STICK_CASE, lever, twist, force, 0.0)
    assert status == sensitivity.SMOOTH
    across = [0.0, share, -share * lever / GYRATION, 0.0, 2.0 * share]
    assert by[:, 0] == pytest.approx([1, 0, 0, 2, 0], rel=1e-15)
    assert by[:, 1] == pytest.approx(across, rel=4e-15, abs=1e-300)
    # A shift of the contact along the rod shortens the lever; one across it turns a contact's motion.
    spin, square = -0.3 / (GYRATION + lever**2), (GYRATION + lever**2) ** 2
    nearer = 2.0 * lever * GYRATION / square
    shorter = [0.0, nearer, (GYRATION - lever**2) / square, 0.0, 2.0 * nearer]
    assert by[:, 2] == pytest.approx(shorter, rel=1e-14, abs=1e-300)
    aside = [twist[2], lever * spin, spin, 2.0 * twist[2], 2.0 * lever * spin]
    assert by[:, 3] == pytest.approx(aside, rel=1e-14, abs=1e-300)
    assert by[:, 4].tolist() == [0.0] * 5
    assert np.all(np.abs(by[:, 5] - [0, 0, 0, *force]) <= 4e-15 * np.abs([*twist, *force]))


def test_a_slip_whose_contact_moves_along_the_fence_has_no_derivatives():
    """Along the edge nothing determines the motion: the force is along the motion of the ring's center."""
    for condition, status in ((sensitivity.SLIP_CASE, 4), (sensitivity.STICK_CASE, 1)):
        result = responses(
            rows.RING, [1.0], 31, length=2.0, angle=0.0, twist=[1.0, 0.0, 0.0], force=[1.0, 0.0],
            edge=0.0, condition=condition,
        )  # fmt: skip
        assert result[0] == status
        assert np.isnan(result[1:]).all() == (status == sensitivity.CHANGE)


# Elimination


def solved(matrix, right):
    """The solution of a system; None if its matrix is singular."""
    flat, noise, order, solution, column = (
        zeros(each) for each in (SIDE * SIDE, SIDE * SIDE, SIDE, SIDE, SIDE)
    )
    for i, number in enumerate(np.ravel(matrix).tolist()):
        flat[i], noise[i] = number, 1e-14 * abs(number)
    for i, number in enumerate(right):
        column[i] = float(number)
    if not elimination.factor_matrix(flat, noise, order):
        return None
    elimination.solve_factored(flat, order, column, solution, SIDE)
    return [solution[i] for i in range(SIDE)]


def exact(matrix, right):
    """The solution in fractions, by Cramer's rule; None if the matrix is singular."""
    whole = determinant(matrix)
    if whole == 0:
        return None
    found = []
    for k in range(SIDE):
        replaced = [[*row[:k], b, *row[k + 1 :]] for row, b in zip(matrix, right, strict=True)]
        found.append(determinant(replaced) / whole)
    return found


def determinant(matrix):
    """The determinant by expansion along the first row."""
    if not matrix:
        return Fraction(1)
    minors = ([row[:j] + row[j + 1 :] for row in matrix[1:]] for j in range(len(matrix)))
    terms = (
        (-1) ** j * Fraction(number) * determinant(minor)
        for j, (number, minor) in enumerate(zip(matrix[0], minors, strict=True))
        if number
    )
    return sum(terms, Fraction(0))


@pytest.mark.parametrize("rank", [1, 2, 3, 4, 5])
def test_elimination_is_exact_to_rounding_and_sees_what_is_singular(rank):
    rng, regular = np.random.default_rng(rank), 0
    for _ in range(60):
        factors = rng.integers(-3, 4, (SIDE, rank)), rng.integers(-3, 4, (rank, SIDE))
        # Powers of two change the scale of each row and column, and round nothing.
        scales = 2.0 ** rng.integers(-20, 21, (2, SIDE))
        matrix = factors[0] @ factors[1] * scales[0][:, None] * scales[1]
        right = rng.integers(-5, 6, SIDE) * scales[0]
        expected = exact(matrix.tolist(), [Fraction(each) for each in right])
        found = solved(matrix, right)
        assert (found is None) == (expected is None)
        if found is not None:
            regular += 1
            size = max(abs(each) * scale for each, scale in zip(expected, scales[1], strict=True))
            error = np.abs(np.subtract(found, [float(each) for each in expected]) * scales[1])
            assert error.max() <= 1e-11 * float(size)
    assert (regular > 30) == (rank == SIDE)


def test_elimination_loses_no_digits_to_numbers_that_are_small_in_their_rows():
    """Rows of the identity, but for 1e-10, in any order and of any scale: the ones are to be chosen."""
    rng = np.random.default_rng(6)
    for _ in range(60):
        rows, scales = rng.permutation(SIDE), 2.0 ** rng.integers(-50, 51, SIDE)
        matrix = np.eye(SIDE) + 2.0**-33 * rng.integers(-3, 4, (SIDE, SIDE))
        matrix, right = (matrix * scales[:, None])[rows], (rng.integers(1, 6, SIDE) * scales)[rows]
        expected = exact(matrix.tolist(), [Fraction(each) for each in right])
        found = solved(matrix, right)
        assert found == pytest.approx([float(each) for each in expected], rel=1e-15, abs=0)


# Feet


def feet_scene(feet, law, *others):
    slider = pp.Slider(rod_length=1.3, rod_angle=0.9)
    supports = (pp.SupportFriction(support=pp.Points(*each), weight=w) for each, w in feet)
    return pp.Scene(slider=slider, contact=law, effects=(*supports, *others))


@pytest.mark.parametrize("law", [pp.Coulomb(0.2), pp.PerfectlyRough()], ids=["slip", "stick"])
def test_the_weights_on_hundreds_of_feet_add_up_to_that_of_the_support(law):
    """A change of all weights in proportion is a change of the whole weight."""
    rng = np.random.default_rng(3)
    shares = rng.uniform(0.5, 1, 300)
    scene = feet_scene([((rng.uniform(-1, 1, (300, 2)), shares), 2.0)], law)
    for each in pp.solve(scene, 0.7, derivatives=True):
        by = each.derivatives
        assert by.status is pp.Smoothness.SMOOTH
        for feet, whole in (
            (by.twist_by_foot, by.twist_by_strength),
            (by.force_by_foot, by.force_by_strength),
        ):
            assert np.abs(feet).max() > 0.1
            assert feet @ (shares / shares.sum()) == pytest.approx(whole[:, 0], abs=1e-12)


def test_feet_of_two_supports_at_the_place_of_the_pivot_change_nothing():
    """Their friction is below its limit, whichever of them is called the pivot."""
    thirds = [(np.cos(a), np.sin(a)) for a in np.deg2rad([0, 120, 240])]
    scene = feet_scene(
        [((thirds, [9, 1, 1]), 2.0), (([thirds[0], (0, 0)], [3, 1]), 1.0)], pp.Coulomb(0.1)
    )
    found = pp.solve(scene, np.linspace(0.1, 3, 30), derivatives=True)
    pivots = found.derivatives.status == pp.Smoothness.PIVOT
    assert pivots.sum() > 3
    by = found.derivatives[pivots]
    for k in (0, 3):
        assert not by.twist_by_foot[..., k].any()
        assert not by.force_by_foot[..., k].any()
    assert np.all(np.abs(by.force_by_foot[..., [1, 2, 4]]).max(axis=-2) > 1e-3)


def test_derivatives_by_feet_that_a_support_lacks_are_not_numbers():
    """Also of the force of a slider that moves away, and of the twist about a pivot."""
    thirds = [(np.cos(a), np.sin(a)) for a in np.deg2rad([0, 120, 240])]
    supports = np.array([pp.Points(thirds, [9, 1, 1]), pp.Points([*thirds, (0, 0)], [1, 2, 3, 4])])
    scene = pp.Scene(
        slider=pp.Slider(rod_length=1.3, rod_angle=0.9), contact=pp.Coulomb(0.2),
        effects=(pp.SupportFriction(support=supports, weight=2.0), pp.Inertia()),
    )  # fmt: skip
    by = pp.motion_of_force(scene, np.linspace(0, 3, 9)[:, None], 3.0, derivatives=True).derivatives
    assert np.isnan(by.twist_by_foot[:, 0, :, 3]).all()
    assert np.isnan(by.force_by_foot[:, 0, :, 3]).all()
    assert np.isfinite(by.twist_by_foot[:, 1]).all()
