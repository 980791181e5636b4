"""Each call of a kernel, compiled and as plain Python, compared to the last bit."""

from __future__ import annotations

from collections import defaultdict

import numpy as np

from planar_pushing.mechanics.kernels import calls as kernels


def same_bits(one, other):
    """Which numbers are the same, with their signs of zero; NaN is NaN."""
    return (one.view(np.int64) == other.view(np.int64)) | (np.isnan(one) & np.isnan(other))


class BothForms:
    """The compiled kernels by name, each of which compares its answers with those of the plain source.

    Attributes
    ----------
    results : dict of list
        What each kernel has written, one array a call.
    """

    def __init__(self, compiled):
        self.compiled, self.results = compiled, defaultdict(list)

    def __getitem__(self, name):
        def kernel(data, rows, count, columns, results, width):
            plain = results.copy()
            self.compiled[name](data, rows, count, columns, results, width)
            answer_plainly(name, data, rows, plain)
            wrong = np.argwhere(~same_bits(plain, results))
            if len(wrong):
                i, k = wrong[0]
                pair, row = (plain[i, k].item(), results[i, k].item()), min(i, len(rows) - 1)
                raise AssertionError(name, data.tolist(), rows[row].tolist(), int(k), pair)
            self.results[name].append(results)

        return kernel


def answer_plainly(name, data, rows, results):
    """Write results row by row, so that an error names its row; all at once if rows name their places."""
    kernel, shared = kernels.plain_kernel(name), memoryview(data.reshape(-1))
    if len(rows) != len(results):
        every, written = memoryview(rows.reshape(-1)), memoryview(results.reshape(-1))
        kernel(shared, every, *rows.shape, written, results.shape[1])
        return
    for row, result in zip(rows, results, strict=True):
        try:
            kernel(shared, memoryview(row), 1, row.size, memoryview(result), result.size)
        except (ArithmeticError, ValueError) as error:
            raise AssertionError(name, data.tolist(), row.tolist()) from error
