"""Each call of a kernel, compiled and as plain Python, compared to the last bit."""

from __future__ import annotations

from collections import Counter

import numpy as np

from planar_pushing.mechanics import kernels


def same_bits(one, other):
    """Whether numbers are the same, with their signs of zero; NaN is NaN."""
    return (one.view(np.int64) == other.view(np.int64)) | (np.isnan(one) & np.isnan(other))


class BothForms:
    """Compiled kernels, by name, that compare themselves with the plain source.

    Attributes
    ----------
    rows : Counter
        How many rows each kernel has answered.
    results : dict of list
        What the kernels wrote, for tests that ask whether the rows reach what they are to reach.
    """

    def __init__(self, compiled):
        self.compiled, self.rows, self.results = compiled, Counter(), {}

    def __getitem__(self, name):
        def kernel(data, rows, count, columns, results, width):
            plain = results.copy()
            self.compiled[name](data, rows, count, columns, results, width)
            self.answer_plainly(name, data, rows, plain)
            wrong = ~same_bits(plain, results)
            assert not wrong.any(), (name, *report(data, rows, plain, results, wrong))
            self.rows[name] += count
            self.results.setdefault(name, []).append(results)

        return kernel

    @staticmethod
    def answer_plainly(name, data, rows, results):
        """Fill results row by row, so that an error names the row."""
        kernel, numbers = kernels.plain_kernel(name), memoryview(data.reshape(-1))
        for row, result in zip(rows, results, strict=True):
            arrays = memoryview(row.reshape(-1)), memoryview(result.reshape(-1))
            try:
                kernel(numbers, arrays[0], 1, row.size, arrays[1], result.size)
            except ArithmeticError as error:
                raise AssertionError(name, numbers.tolist(), row.tolist()) from error


def report(data, rows, plain, results, wrong):
    """A row in which the forms differ: its inputs, the columns, and both answers."""
    i = int(np.argwhere(wrong)[0, 0])
    columns = np.flatnonzero(wrong[i])
    return data.tolist(), rows[i].tolist(), columns.tolist(), plain[i, columns], results[i, columns]
