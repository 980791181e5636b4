"""Estimates of the amounts of a family's columns from forces, motions, or both."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.fit.balance import Balance, Balanced, fit_balance, solve_balance
from planar_pushing.pushes.fit.candidates import Family
from planar_pushing.pushes.fit.friction import contact_friction
from planar_pushing.pushes.fit.motions import Linear, MotionProblem, fit_motions, resample
from planar_pushing.pushes.logs.measured import Index, Measured

#: Smallest number of slipping pushes of which the median is the friction coefficient.
FEWEST = 3
#: The force of a point at rest is inside its facet if it is below this fraction of the point's weight.
WITHIN = 0.999
#: Residual, in standard deviations, above which a push does not lie in a facet.
FAR = 3.0


@dataclass(frozen=True, slots=True, eq=False)
class Estimate:
    """Amounts of columns, for the pushes and for resampled pushes.

    Attributes
    ----------
    amounts : ndarray, shape (c,)
        Amounts in the unit of force; from motions alone, their sum is 1.
    draws : ndarray, shape (resamples, c)
        Amounts for resampled pushes.
    friction : float
        Friction coefficient of the contact.
    frictions : ndarray, shape (resamples,)
    residuals : ndarray, shape (n,)
        Errors of the pushes used.
    facet : ndarray of int, shape (n,)
        Place of the family about which the object turned, with less than full friction there, or -1.
    optimality : float
    signals : ndarray
        Singular values: changes of the residuals, in standard deviations, for combinations of amounts that
        change by an even share.
    doubts : tuple of str
    """

    amounts: Array
    draws: Array
    friction: float
    frictions: Array
    residuals: Array
    facet: Index
    optimality: float
    signals: Array
    doubts: tuple[str, ...]


def from_forces(
    pushes: Measured, family: Family, resamples: int, generator: np.random.Generator
) -> tuple[Estimate, Linear]:
    """Estimate from pushes with forces, and its residuals in linear form."""
    problem, balanced, errors = fit_balance(pushes, family)
    number, share = len(pushes), balanced.amounts.sum() / len(balanced.amounts)
    changes = np.einsum("nab,nbc->nac", problem.whitening, problem.loads) * share
    changes = changes.reshape(3 * number, -1)
    signals = _singular_values(changes)
    rows = [generator.integers(number, size=number) for _ in range(resamples)]
    # The draws omit the pull, which would reduce their spread.
    free = replace(problem, pull=0.0)
    drawn = np.array([solve_balance(free.part(sample)).amounts for sample in rows])
    friction, frictions, doubts = _friction(pushes, resamples, generator)
    estimate = Estimate(
        amounts=balanced.amounts, draws=_widen(drawn, balanced.amounts, number, signals), friction=friction,
        frictions=frictions, residuals=errors, facet=_facets(problem, balanced, errors),
        optimality=balanced.optimality, signals=signals, doubts=doubts,
    )  # fmt: skip
    return estimate, Linear(
        changes, changes @ balanced.amounts / share - balanced.residuals.ravel()
    )


def _friction(
    pushes: Measured, resamples: int, generator: np.random.Generator
) -> tuple[float, Array, tuple[str, ...]]:
    """Contact friction, its values for resampled pushes, and a warning if too few pushes slip."""
    ratios = contact_friction(pushes)
    slipping = ratios.slipping
    if len(slipping) >= FEWEST:
        again = generator.integers(len(slipping), size=(resamples, len(slipping)))
        return ratios.coefficient, np.median(slipping[again], axis=1), ()
    bound = float(ratios.sticking.max(initial=0.0))
    count = f"{len(slipping)} of the pushes" if len(slipping) else "none of the pushes"
    doubt = f"contact_friction: {count} with forces slip; {bound:.3g} is a lower bound"
    return bound, np.full(resamples, bound), (doubt,)


def _singular_values(matrix: Array) -> Array:
    return np.asarray(np.linalg.svd(matrix, compute_uv=False), dtype=float)


def _widen(drawn: Array, amounts: Array, pushes: int, signals: Array) -> Array:
    """Draws with a wider spread: a fit reduces the residuals below the errors through its free parameters.

    Some amounts then become negative; setting them to zero would make the weight too large.
    """
    free = min(int((signals > 1.0).sum()), pushes // 2)
    return np.asarray(amounts + np.sqrt(pushes / (pushes - free)) * (drawn - amounts))


def _facets(problem: Balance, balanced: Balanced, errors: Array) -> Index:
    """For each push, the place at rest with the largest weight among those with a smaller force; or -1."""
    facets = np.full(len(balanced.residuals), -1)
    weights = problem.columns[problem.pairs[:, 1]] @ balanced.amounts
    held = np.hypot(*balanced.forces.T) < WITHIN * weights
    for k in np.argsort(weights):
        push, candidate = problem.pairs[k]
        if held[k] and errors[push] < FAR:
            facets[push] = candidate
    return facets


def from_motions(
    pushes: Measured,
    family: Family,
    first: tuple[Estimate, Linear] | None,
    resamples: int,
    generator: np.random.Generator,
    progress: bool,
) -> Estimate:
    """Estimate from final poses of pushes at a side, and from forces of other pushes if there are any."""
    linear = None if first is None else first[1]
    fitted = fit_motions(MotionProblem.of(pushes, family), linear, progress)
    number, count = len(pushes), len(fitted.amounts)
    draws = np.array(
        [
            resample(fitted, linear, generator.integers(number, size=number))
            for _ in range(resamples)
        ]
    )
    unit = 1.0 / fitted.amounts.sum() if first is None else first[0].amounts.sum() / count
    units = 1.0 / draws[:, :-1].sum(axis=1, keepdims=True) if first is None else unit
    x, y, turn = fitted.residuals.T
    spread = float(np.sqrt(np.mean(np.minimum(fitted.residuals**2, fitted.scale**2))))
    changes = fitted.slopes[:, :-1] / max(spread, 1e-300)
    doubts = ("weight: no force was measured",) if first is None else ()
    return Estimate(
        amounts=fitted.amounts * unit, draws=draws[:, :-1] * units, friction=fitted.friction,
        frictions=draws[:, -1], residuals=np.hypot(x, y) + np.abs(turn), facet=np.full(number, -1),
        optimality=fitted.optimality, signals=_singular_values(changes), doubts=doubts,
    )  # fmt: skip
