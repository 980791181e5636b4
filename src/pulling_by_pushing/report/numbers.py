"""The numbers of the report's prose, by the keys that the prose uses."""

from __future__ import annotations

from pulling_by_pushing.report.parts import any_slider, costs, evidence, mechanics, pushes
from pulling_by_pushing.report.quantities import Numbers
from pulling_by_pushing.report.results import Results

#: All numbers of the prose; the numbers of a new part must be added here.
NUMBERS: Numbers = {
    **mechanics.SETTING,
    **mechanics.QUASI_STATIC,
    **mechanics.INFINITE_FRICTION,
    **mechanics.DYNAMIC,
    **mechanics.BOTH_EFFECTS,
    **mechanics.MODES,
    **mechanics.OVER_TIME,
    **any_slider.CLAIMS,
    **pushes.MEASURED,
    **costs.ACCURACY,
    **costs.TIMES,
    **costs.HARD_CASES,
    **costs.EFFECTS,
    **evidence.GOLDEN,
    **evidence.CLAIMS,
}


def numbers(results: Results) -> dict[str, dict[str, str]]:
    """Text, unit and source of every number.

    Raises
    ------
    InvalidFile
        If a file of the results is missing.
    """
    return {key: quantity.entry(results) for key, quantity in NUMBERS.items()}
