"""Small linear equations by elimination with row exchanges."""

from __future__ import annotations

from planar_pushing.mechanics.compiled import compiled


@compiled
def factorise(matrix, count, order):
    """Turn the first `count` rows and columns of a matrix into its triangular factors."""
    for i in range(count):
        pivot = i
        for j in range(i + 1, count):
            if abs(matrix[j, i]) > abs(matrix[pivot, i]):
                pivot = j
        order[i] = pivot
        if pivot != i:
            for k in range(count):
                matrix[i, k], matrix[pivot, k] = matrix[pivot, k], matrix[i, k]
        for j in range(i + 1, count):
            if matrix[j, i] != 0.0:
                matrix[j, i] /= matrix[i, i]
                part = matrix[j, i]
                for k in range(i + 1, count):
                    matrix[j, k] -= part * matrix[i, k]


@compiled
def solve_factorised(matrix, count, order, vector):
    """Solve equations in place, given the factors of their matrix."""
    for i in range(count):
        vector[i], vector[order[i]] = vector[order[i]], vector[i]
    for i in range(count):
        for k in range(i):
            vector[i] -= matrix[i, k] * vector[k]
    for i in range(count - 1, -1, -1):
        for k in range(i + 1, count):
            vector[i] -= matrix[i, k] * vector[k]
        vector[i] /= matrix[i, i]
