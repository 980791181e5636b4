"""The numbers of the report's prose, by the keys under which it names them."""

from __future__ import annotations

from planar_pushing.report.parts import any_slider, costs, evidence, mechanics, pushes
from planar_pushing.report.quantities import Numbers
from planar_pushing.report.results import Results

#: Every number of the prose; a new part's are added here.
NUMBERS: Numbers = {
    **mechanics.SETTING,
    **mechanics.QUASI_STATIC,
    **mechanics.INFINITE_FRICTION,
    **mechanics.DYNAMIC,
    **mechanics.BOTH_EFFECTS,
    **mechanics.MODES,
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
        Where a file of the results is missing.
    """
    return {key: quantity.entry(results) for key, quantity in NUMBERS.items()}
