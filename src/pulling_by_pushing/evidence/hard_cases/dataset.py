"""The dataset of hard cases: each result in doubles compared with its reference.

References have 40 digits, but for motions over time: those on which two runs of their route agree.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, fields
from functools import lru_cache

import numpy as np
import xarray as xr
from flint import arb, ctx, fmpq

from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.evidence.hard_cases.case import QUANTITIES, Case
from pulling_by_pushing.evidence.hard_cases.cases import cases
from pulling_by_pushing.evidence.hard_cases.motions import LINE, ORACLE, RTOL, Outcome, outcomes
from pulling_by_pushing.oracle.balls import Number, Undecided, rational
from pulling_by_pushing.study.describe import describe
from pulling_by_pushing.study.running.build import Attributes, write_built

#: Working precision in bits, doubled until a reference has the digits that are stored, and the largest one.
FIRST_PRECISION, FINEST = 320, 5120
#: Decimal digits of a reference that are stored.
REFERENCE_DIGITS = 40
#: Relative change by rounding: half an ulp.
CHANGE = fmpq(1, 2**53)
EPS = float(np.finfo(float).eps)
#: At this condition number, rounding of the inputs alone causes a loss of six of the sixteen digits.
ILL_CONDITIONED = 1e6


@dataclass(frozen=True, slots=True, kw_only=True)
class Measure:
    """Result of a case.

    Attributes
    ----------
    reference : str
        40 digits, or those of a motion.
    reference_digits : int
    reference_route : str
        How it was computed.
    reference_high, reference_low : float
        The reference as the sum of two doubles.
    result : float
    error_ulp : float
        Error in units in the last place of the reference.
    condition : float
        Relative change of the reference per relative change of an input, summed over the inputs. A sum over
        the members of a support, such as feet, counts each of its terms as an input.
    """

    reference: str
    reference_digits: int
    reference_route: str
    reference_high: float
    reference_low: float
    result: float
    error_ulp: float
    condition: float

    @property
    def rounding_bound(self) -> float:
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
    Undecided
        If the reference is not known to the number of digits that are stored.
    """
    try:
        value, precision, condition = _reference(case.function.reference, case.inputs)
    except Undecided as error:
        raise Undecided(f"{case.label}: {error}") from None
    with ctx.workprec(precision):
        high = float(value.mid())
        low = float((value - high).mid())
        result = float(case.function.compute(*case.inputs))
        error_ulp = float(abs(value - result).mid() / arb(float(np.spacing(abs(high)))))
        text = value.mid().str(REFERENCE_DIGITS, radius=False)
    return Measure(
        reference=text, reference_digits=REFERENCE_DIGITS, reference_route=ORACLE,
        reference_high=high, reference_low=low,
        result=result, error_ulp=error_ulp, condition=condition,
    )  # fmt: skip


def measure_motion(outcome: Outcome) -> Measure:
    """Compare the result of a motion over time with its stored reference."""
    _, _, result, (text, digits, route, condition) = outcome
    with ctx.workprec(FIRST_PRECISION):
        value = arb(text).mid()
        high = float(value)
        low, error = float(value - high), float(abs(value - result))
    return Measure(
        reference=text, reference_digits=digits, reference_route=route,
        reference_high=high, reference_low=low, result=result,
        error_ulp=error / float(np.spacing(abs(high))), condition=condition,
    )  # fmt: skip


@lru_cache(maxsize=1024)
def _reference(
    function: Callable[..., Number], inputs: tuple[float, ...]
) -> tuple[arb, int, float]:
    """The reference, the precision at which it has its digits, and its condition number."""
    exact, precision, reason = [_exact(number) for number in inputs], FIRST_PRECISION, ""
    while precision <= FINEST:
        with ctx.workprec(precision):
            try:
                value = function(*exact)
                if (
                    value.ball == 0
                    or value.ball.rel_accuracy_bits() > REFERENCE_DIGITS / math.log10(2)
                ):
                    return value.ball, precision, _condition(function, exact, value)
                reason = f"{value.ball} has fewer than {REFERENCE_DIGITS} digits"
            except Undecided as error:
                reason = str(error)
        precision *= 2
    raise Undecided(reason)


def _exact(number: float) -> float | fmpq:
    return rational(number) if math.isfinite(number) else number


def _condition(function: Callable[..., Number], inputs: list[float | fmpq], value: Number) -> float:
    """Relative change of the value by its terms, and by each of its inputs from difference quotients."""
    if value.ball == 0:
        return 0.0
    total = value.rounding
    for i, number in enumerate(inputs):
        if isinstance(number, fmpq) and number != 0:
            changed_inputs = [*inputs[:i], number * (1 + CHANGE), *inputs[i + 1 :]]
            total += abs(function(*changed_inputs).ball - value.ball) / CHANGE
    return float((total / abs(value.ball)).mid())


def build() -> xr.Dataset:
    """Measure every case, and compare the motions over time.

    Returns
    -------
    xarray.Dataset
        Over `case`: the reference, the result, its error and the condition number.
    """
    table, motions = cases(), list(outcomes())
    measures = [*map(measure, table), *map(measure_motion, motions)]
    lines = [case.line for case in table] + [LINE] * len(motions)
    quantities = [case.function.quantity for case in table] + [each.quantity for each in motions]
    columns = {
        "line": np.array(lines, np.int8),
        "quantity": quantities,
        "quantity_unit": [QUANTITIES[quantity] for quantity in quantities],
        **{field.name: [getattr(m, field.name) for m in measures] for field in fields(Measure)},
        "reference_digits": np.array([m.reference_digits for m in measures], np.int8),
        "error_bound": [m.rounding_bound for m in measures],
        "ill_conditioned": np.array([m.ill_conditioned for m in measures]),
    }
    dataset = xr.Dataset(
        {name: ("case", column) for name, column in columns.items()},
        coords={"case": [case.label for case in table] + [each.label for each in motions]},
    )
    return describe(
        dataset,
        title="Hard cases: results in doubles against references",
        source="Eqs. (2)-(12)",
        parameters={
            "precision_bits": FIRST_PRECISION,
            "ill_conditioned_from": ILL_CONDITIONED,
            "rtol": RTOL,
        },
    )


def write(path: PathLike, *, marks: Attributes) -> None:
    """Write the dataset."""
    write_built(build(), path, "hard_cases", marks)
