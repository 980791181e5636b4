"""A hard case: double inputs, what the mechanics make of them, and the reference; and its measure."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from itertools import starmap

import numpy as np
from flint import arb, ctx

#: Working precision in bits, and the decimal digits of a reference that are stored.
PRECISION = 320
DIGITS = 40
#: Relative change of an input: half an ulp, what rounding the input does to it.
CHANGE = arb(2) ** -53
EPS = float(np.finfo(float).eps)
#: From this condition number on, rounding the inputs alone costs six of the sixteen digits.
ILL_CONDITIONED = 1e6


class Quantity(StrEnum):
    """What a case asks for."""

    FORCE = "force"
    TORQUE = "torque"
    SPIN_RATIO = "spin_ratio"
    MOTION_ANGLE = "motion_angle"

    @property
    def unit(self) -> str:
        """Unit of the number."""
        return "radian" if self is Quantity.MOTION_ANGLE else "1"


@dataclass(frozen=True, slots=True, kw_only=True)
class Case:
    """One number under test.

    Attributes
    ----------
    label : str
        What is asked, in words.
    line : int
        The line of the list of hard places that it belongs to, 1 to 7.
    quantity : Quantity
        What the number is.
    inputs : tuple of float
        Doubles, taken as exact.
    compute : callable
        The mechanics: doubles to a double.
    reference : callable
        Balls to a ball, on a route that shares nothing with the mechanics.
    """

    label: str
    line: int
    quantity: Quantity
    inputs: tuple[float, ...]
    compute: Callable[..., float]
    reference: Callable[..., arb]


@dataclass(frozen=True, slots=True, kw_only=True)
class Measure:
    """Result of a case.

    Attributes
    ----------
    reference : str
        40 digits.
    reference_high, reference_low : float
        The same as the sum of two doubles.
    result : float
    error_ulp : float
        In units in the last place of the reference.
    condition : float
        Relative change of the reference per relative change of the inputs, summed over them.
    """

    reference: str
    reference_high: float
    reference_low: float
    result: float
    error_ulp: float
    condition: float

    @property
    def bound(self) -> float:
        """Relative error that rounding the inputs causes, whatever the algorithm."""
        return self.condition * EPS

    @property
    def ill_conditioned(self) -> bool:
        return self.condition >= ILL_CONDITIONED


def _condition(case: Case, value: arb) -> float:
    """Sum over the inputs of the relative change of the value, by difference quotients."""
    if value == 0:
        return 0.0
    exact = [arb(x) for x in case.inputs]

    def change(place: int, x: arb) -> arb:
        if not x.is_finite() or x == 0:
            return arb(0)
        near = [each * (1 + CHANGE) if i == place else each for i, each in enumerate(exact)]
        return abs((case.reference(*[each.mid() for each in near]) - value) / value) / CHANGE

    return float(sum(starmap(change, enumerate(exact)), arb(0)).mid())


def measure(case: Case) -> Measure:
    """Evaluate a case on both routes.

    Raises
    ------
    ArithmeticError
        Where the reference is not known to the digits that are stored.
    """
    with ctx.workprec(PRECISION):
        value = case.reference(*map(arb, case.inputs))
        if value != 0 and value.rel_accuracy_bits() < DIGITS / math.log10(2):
            raise ArithmeticError(f"{case.label}: {value} has fewer than {DIGITS} digits")
        high = float(value.mid())
        low = float((value - high).mid())
        result = float(case.compute(*case.inputs))
        error = float(abs(value - result).mid() / arb(float(np.spacing(abs(high)))))
        text = value.mid().str(DIGITS, radius=False)
        condition = _condition(case, value)
    return Measure(
        reference=text, reference_high=high, reference_low=low,
        result=result, error_ulp=error, condition=condition,
    )  # fmt: skip
