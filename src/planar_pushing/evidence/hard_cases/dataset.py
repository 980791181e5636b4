"""The dataset of hard cases: each result in doubles compared with a reference of 40 digits."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from itertools import starmap

import numpy as np
import xarray as xr
from flint import arb, ctx

from planar_pushing.evidence.hard_cases.cases import QUANTITIES, Case, cases
from planar_pushing.study.describe import describe

#: Working precision in bits, and the number of decimal digits of a reference that are stored.
PRECISION, DIGITS = 320, 40
#: Relative change of an input by rounding: half an ulp.
CHANGE = arb(2) ** -53
EPS = float(np.finfo(float).eps)
#: At this condition number, rounding of the inputs alone causes a loss of six of the sixteen digits.
ILL_CONDITIONED = 1e6


@dataclass(frozen=True, slots=True, kw_only=True)
class Measure:
    """Result of a case.

    Attributes
    ----------
    reference : str
        40 digits.
    reference_high, reference_low : float
        The reference as the sum of two doubles.
    result : float
    error_ulp : float
        Error in units in the last place of the reference.
    condition : float
        Relative change of the reference per relative change of an input, summed over the inputs.
    """

    reference: str
    reference_high: float
    reference_low: float
    result: float
    error_ulp: float
    condition: float

    @property
    def bound(self) -> float:
        """Relative error due to rounding of the inputs, whatever the algorithm."""
        return self.condition * EPS

    @property
    def ill_conditioned(self) -> bool:
        """Whether double precision loses six digits whatever the algorithm."""
        return self.condition >= ILL_CONDITIONED


def measure(case: Case) -> Measure:
    """Evaluate a case on both routes.

    Raises
    ------
    ArithmeticError
        If the reference is not known to the number of digits that are stored.
    """
    with ctx.workprec(PRECISION):
        value = case.function.reference(*map(arb, case.inputs))
        if value != 0 and value.rel_accuracy_bits() < DIGITS / math.log10(2):
            raise ArithmeticError(f"{case.label}: {value} has fewer than {DIGITS} digits")
        high = float(value.mid())
        low = float((value - high).mid())
        result = float(case.function.compute(*case.inputs))
        error = float(abs(value - result).mid() / arb(float(np.spacing(abs(high)))))
        text = value.mid().str(DIGITS, radius=False)
        condition = _condition(case, value)
    return Measure(
        reference=text, reference_high=high, reference_low=low,
        result=result, error_ulp=error, condition=condition,
    )  # fmt: skip


def _condition(case: Case, value: arb) -> float:
    """Sum over the inputs of the relative change of the value, by difference quotients."""
    if value == 0:
        return 0.0
    exact = [arb(x) for x in case.inputs]

    def change(place: int, x: arb) -> arb:
        if not x.is_finite() or x == 0:
            return arb(0)
        near = [each * (1 + CHANGE) if i == place else each for i, each in enumerate(exact)]
        changed = case.function.reference(*[each.mid() for each in near])
        return abs((changed - value) / value) / CHANGE

    return float(sum(starmap(change, enumerate(exact)), arb(0)).mid())


def build() -> xr.Dataset:
    """Measure every case.

    Returns
    -------
    xarray.Dataset
        Over `case`: the reference, the result, its error and the condition number.
    """
    every = list(cases())
    found = [measure(case) for case in every]
    columns = {
        "line": np.array([case.line for case in every], np.int8),
        "quantity": [case.function.quantity for case in every],
        "quantity_unit": [QUANTITIES[case.function.quantity] for case in every],
        **{field.name: [getattr(each, field.name) for each in found] for field in fields(Measure)},
        "error_bound": [each.bound for each in found],
        "ill_conditioned": np.array([each.ill_conditioned for each in found]),
    }
    dataset = xr.Dataset(
        {name: ("case", column) for name, column in columns.items()},
        coords={"case": [case.label for case in every]},
    )
    return describe(
        dataset,
        title="Hard cases: results in doubles against references of 40 digits",
        source="Eqs. (2)-(12)",
        parameters={"precision_bits": PRECISION, "ill_conditioned_from": ILL_CONDITIONED},
    )
