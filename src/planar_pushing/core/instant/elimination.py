"""Linear equations: five with bounds on the errors of their numbers, and any number, once factored."""

from __future__ import annotations

from math import fabs

from planar_pushing.core.numbers import Numbers, zeros

#: Number of unknowns and equations, and of numbers in a matrix.
SIDE = 5
SQUARE = SIDE * SIDE


def factor_matrix(matrix: Numbers, noise: Numbers, order: Numbers) -> bool:
    """Factor a matrix in place, write the order of its rows, and return whether it is regular.

    The pivot element of a column is the largest number, relative to the largest one in the same row of the
    matrix, among those that exceed their errors. If there is none, the matrix is singular to within its
    errors.

    Parameters
    ----------
    matrix, noise : Numbers
        Entries of the matrix and bounds on their errors, row by row; both are overwritten.
    order : Numbers
        Receives the indices of the rows in the order of elimination.
    """
    scales = zeros(SIDE)
    for i in range(SIDE):
        order[i] = float(i)
        for j in range(SIDE):
            scales[i] = max(scales[i], fabs(matrix[SIDE * i + j]))
    for k in range(SIDE):
        best, chosen = 0.0, -1
        for i in range(k, SIDE):
            size = fabs(matrix[SIDE * i + k])
            if size > noise[SIDE * i + k] and size > best * scales[i]:
                best, chosen = size / scales[i], i
        if chosen < 0:
            return False
        _swap_numbers(scales, k, chosen, 1)
        _swap_numbers(order, k, chosen, 1)
        _swap_numbers(matrix, SIDE * k, SIDE * chosen, SIDE)
        _swap_numbers(noise, SIDE * k, SIDE * chosen, SIDE)
        for i in range(k + 1, SIDE):
            _eliminate(
                top=matrix[SIDE * k :],
                top_noise=noise[SIDE * k :],
                row=matrix[SIDE * i :],
                noise=noise[SIDE * i :],
                k=k,
            )
    return True


def _swap_numbers(numbers: Numbers, one: int, other: int, count: int) -> None:
    """Exchange two parts of an array."""
    for j in range(count):
        left, right = numbers[one + j], numbers[other + j]
        numbers[one + j], numbers[other + j] = right, left


def _eliminate(top: Numbers, top_noise: Numbers, row: Numbers, noise: Numbers, k: int) -> None:
    """Subtract a multiple of one row from another, and store the factor in the eliminated column."""
    factor = row[k] / top[k]
    unsure = noise[k] + fabs(factor) * top_noise[k]
    row[k] = factor
    for j in range(k + 1, SIDE):
        row[j] -= factor * top[j]
        noise[j] += fabs(factor) * top_noise[j] + fabs(top[j] / top[k]) * unsure


def solve_factored(
    matrix: Numbers, order: Numbers, right: Numbers, solution: Numbers, count: int
) -> None:
    """Solve a number of equations with a factored matrix."""
    for i in range(count):
        total = right[int(order[i])]
        for j in range(i):
            total -= matrix[count * i + j] * solution[j]
        solution[i] = total
    for k in range(count):
        i = count - 1 - k
        total = solution[i]
        for j in range(i + 1, count):
            total -= matrix[count * i + j] * solution[j]
        solution[i] = total / matrix[count * i + i]
