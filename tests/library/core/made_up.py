"""A small core with every construct of the language, in modules whose order is not that of their use."""

MODULES = {
    "apex": '''
"""Kernels."""

from __future__ import annotations

from math import asin, asinh, atan2, ceil, copysign, cos, exp, fabs, floor, log, sin, sinh, sqrt

from planar_pushing.core.middle import (
    LONG, SHORT, Body, Long, Pair, Short, far_pair, fill, larger_body, roots, weigh,
)
from planar_pushing.core.numbers import EPSILON, Coefficients, Numbers, zeros
from planar_pushing.core.floor.zenith import (
    CODES, FAR, FEW, NONE, ONE, SERIES, THIRD, THREE, TWO, WEIGHTS, ZERO,
)

HALF_SIZE = FEW * 2


def answer(
    data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int
) -> None:
    """Every construct, for each row."""
    for i in range(count):
        answer_row(data, rows[i * columns :], results[i * width :])


def answer_row(data: Numbers, row: Numbers, result: Numbers) -> None:
    x, y, k = row[0], row[1], int(row[2])
    result[0], result[1] = elementary(x, y), arithmetic(x, y, k)
    result[2] = k * k - 3 * k + CODES - ONE - TWO + 100 * ((k - FEW) // 2) + (k - 1) // THREE
    result[3] = min(x, y)
    result[4] = max(x, y)
    result[5] = min(k, 1) - max(k, -FEW)
    result[6] = floor(10.0 * x) + ceil(10.0 * y)
    result[7] = x < y
    body = Body(x, Pair(y, k, x > y), row, data)
    result[8] = weigh(body) + body.pair.linux + body.row[1] + body.data[k * k :][1]
    chosen = larger_body(body, Body(y, Pair(x, k + 1, y > x), data, row))
    result[9], result[10] = chosen.mass, chosen.pair.code
    result[11], result[12], real = roots(x, y)
    result[13] = real
    sums: Numbers = zeros(HALF_SIZE)
    for j in range(HALF_SIZE):
        sums[j] = x * j
    count, total = fill(sums[2:], THREE, x)
    result[14], result[15] = count, total
    for j in range(3):
        first, second = zeros(4), zeros(FEW + 1)
        first[j] += x
        second[j] -= y
        result[16 + j] = first[0] + first[1] + first[2] + second[j] * 2.0
    result[19] = polynomial(SERIES, len(SERIES), x) + polynomial(row, 2, x) + WEIGHTS[ZERO]
    result[20] = walk(x, y, k)
    result[21] = FAR if x == 0.0 else 1.0 / x
    result[22] = NONE if not x >= y else THIRD
    result[23] = far_pair(x, y).linux
    result[24] = float(x < y < 2.0 or not (k == 2 and x != y) and (x < y) == (k > 0))
    result[25], result[26] = result[24], -x
    result[25] += EPSILON
    result[26] *= y
    result[27] = named(row, x, k)
    return


def named(row: Numbers, x: float, k: int) -> float:
    room = zeros(LONG + SHORT)
    long = Long(room)
    long.code, long.end.here = k, x > 0.0
    long.code += 2
    long.end.x, long.weight = x, 0.25
    long.end[1] -= 3.0
    short = Short(room[LONG:])
    short.code = long.code - 1
    if long.end.here and Short(row).code == k:
        short.weight = 1.0
    return short.code + long.weight + tail(long) + long.row[0] + short.weight + first_code(long)


def tail(long: Long) -> float:
    return long.end.x * long.code


def first_code(short: Short) -> int:
    return short.code if short[1] != 0.0 else -short.code


def elementary(x: float, y: float) -> float:
    total = sin(x) + cos(y) * exp(-fabs(x)) - sinh(y / 4.0) + asinh(x)
    total += log(1.0 + fabs(y)) + sqrt(x * x + y * y) + atan2(y, x) + copysign(x, y)
    return total + asin(sin(x) * 0.99)


def arithmetic(x: float, y: float, k: int) -> float:
    # A compiler that fuses multiplication and addition would round the next line once less.
    fused = x * y + x * x - y * y
    z = fused * k / 3.0 - 2 * x + (k + 1) * THIRD
    z -= x / 7.0
    z = -z if z > 0.0 else z
    return z


def polynomial(coefficients: Coefficients, count: int, x: float) -> float:
    value, i = 0.0, count - 1
    while i >= 0:
        value = value * x + coefficients[i]
        i -= 1
    return value


def walk(x: float, y: float, k: int) -> float:
    low, high, steps = min(x, y) - 1.0, max(x, y) + 1.0, 0
    for i in range(40, 0, -1):
        if i == 33:
            continue
        middle = (low + high) / 2.0
        if middle * middle > fabs(x) + k:
            high = middle
        elif middle > x:
            low = middle
            steps += 1
        else:
            low = middle
        if high - low < 1e-9:
            break
    for i in range(2, 9, 3):
        steps += i
    return low + steps
''',
    "middle": '''
from __future__ import annotations

from math import fabs, sqrt
from typing import NamedTuple

from planar_pushing.core._record import Record, size_of
from planar_pushing.core.numbers import Numbers
from planar_pushing.core.floor.zenith import FAR


class Point(Record):
    """A record within another one."""

    x: float
    y: float
    here: bool


class Short(Record):
    code: int
    weight: float


class Long(Short):
    """A record after another one, with a record in it."""

    end: Point


LONG, SHORT = size_of(Long), size_of(Short)


class Body(NamedTuple):
    """A named tuple in another one, and arrays."""

    mass: float
    pair: Pair
    row: Numbers
    data: Numbers


class Pair(NamedTuple):
    linux: float
    code: int
    unix: bool


def far_pair(x: float, y: float) -> Pair:
    near: bool
    near = fabs(x - y) < 1.0
    return Pair(x, 1, near) if near else Pair(FAR, 2, near)


def weigh(body: Body) -> float:
    """Weight."""
    if body.pair.unix and body.pair.code > 0:
        return body.mass * body.pair.code
    elif not body.pair.unix:
        return -body.mass
    return 0.0


def larger_body(one: Body, other: Body) -> Body:
    if one.mass > other.mass:
        return one
    one = other
    return one if one.pair.code > 2 else Body(one.mass, one.pair, other.row, one.data)


def roots(x: float, y: float) -> tuple[float, float, bool]:
    square = x * x - y
    if square < 0.0:
        return 0.0, -0.0, False
    root = sqrt(square)
    low, high = x - root, x + root
    low, high = high, low
    return high, low, square > 0.0


def fill(row: Numbers, count: int, x: float) -> tuple[int, float]:
    total = 0.0
    for i in range(count):
        row[i + 1] = row[i] * x + 1.0
        total += row[i + 1]
    return count, total
''',
    "floor/zenith": """
from __future__ import annotations

from planar_pushing.core.numbers import INFINITY, UNKNOWN

WEIGHTS = (0.5, -1.5e-300, 1e22)
FEW = len(WEIGHTS)
ZERO, ONE, TWO, THREE = range(4)
CODES = 4
THIRD = 1.0 / 3.0
FAR = -INFINITY
NONE = UNKNOWN
SERIES = (1.0, 1.0, 0.5, THIRD / 2.0, 0.1 + 0.2)
""",
}
