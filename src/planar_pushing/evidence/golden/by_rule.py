"""Check a dataset by the rules of its variables."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import xarray as xr

from planar_pushing.evidence.golden import exact
from planar_pushing.evidence.golden.compare import Check, judged
from planar_pushing.evidence.golden.expected import Expectation
from planar_pushing.evidence.golden.rules import Rule


def check_dataset(file: str, found: xr.Dataset, expectation: Expectation) -> list[Check]:
    """Check every variable and coordinate of a dataset, and its attributes."""
    root = exact.root_problem(found, expectation)
    problems = exact.variable_problems(found, expectation)
    checks = [Check(file=file, rule=Rule.EXACT, problem=root)] if root else []
    for name, problem in problems.items():
        rule = expectation.rules.get(name, Rule.EXACT)
        check = Check(file=file, variable=name, rule=rule, problem=problem)
        if not problem and rule != Rule.RESIDUAL:
            check = judged(check, found[name], *exact.value_errors(name, found, expectation))
        if problem or rule != Rule.RESIDUAL:
            checks.append(check)
    sound = {
        name
        for name, problem in problems.items()
        if not problem and expectation.rules.get(name) == Rule.RESIDUAL
    }
    return checks + list(_by_residual(file, found, expectation, sound))


def _by_residual(
    file: str, found: xr.Dataset, expectation: Expectation, names: set[str]
) -> Iterator[Check]:
    """Put the variables into their equations; what is left over could not be verified."""
    left, reason = set(names), "no equation holds it"
    try:
        with np.errstate(all="ignore"):
            for name, error, allowed in expectation.residuals(found):
                if name in left:
                    left.remove(name)
                    check = Check(file=file, variable=name, rule=Rule.RESIDUAL)
                    yield judged(check, found[name], error, allowed)
    # What a damaged dataset lacks shows itself in any way: each is a line of the verdict.
    except Exception as error:
        reason = f"{type(error).__name__}: {str(error)[:100]}"
    for name in sorted(left):
        problem = f"cannot be put into its equation: {reason}"
        yield Check(file=file, variable=name, rule=Rule.RESIDUAL, problem=problem)
