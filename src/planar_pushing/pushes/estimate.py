"""Estimates of amounts of a family's columns: from forces, from motions, or from both."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.balance import Balance, Balanced, fit_balance, solve_balance
from planar_pushing.pushes.candidates import Family
from planar_pushing.pushes.friction import contact_friction
from planar_pushing.pushes.measured import Measured
from planar_pushing.pushes.motions import Linear, MotionProblem, fit_motions, resampled

#: Slipping pushes from which their median is a friction coefficient.
FEWEST = 3
#: A force of a point at rest below this fraction of its weight is inside its facet.
WITHIN = 0.999
#: Residual, in standard deviations, from which on a push does not lie in a facet.
FAR = 3.0


@dataclass(frozen=True, slots=True, eq=False)
class Estimate:
    """Amounts of columns, and of draws of the pushes.

    Attributes
    ----------
    amounts : ndarray, shape (c,)
        In the unit of the force; of motions alone their sum is 1.
    draws : ndarray, shape (resamples, c)
        The same, of pushes drawn anew.
    friction : float
        Friction coefficient of the contact.
    frictions : ndarray, shape (resamples,)
    residuals : ndarray, shape (n,)
        Of the pushes of the estimate.
    facet : ndarray of int, shape (n,)
        Place of the family about which the object turned under less than its full friction, or -1.
    optimality : float
    told : ndarray
        Singular values: changes of the residuals, in standard deviations, by combinations of amounts that
        change by an even share.
    doubts : tuple of str
    """

    amounts: Array
    draws: Array
    friction: float
    frictions: Array
    residuals: Array
    facet: Array
    optimality: float
    told: Array
    doubts: tuple[str, ...]


def from_forces(
    pushes: Measured, family: Family, resamples: int, generator: np.random.Generator
) -> tuple[Estimate, Linear]:
    """The estimate of pushes with forces, and the residuals that it leaves, as linear ones."""
    problem, found = fit_balance(pushes, family)
    number = len(pushes)
    rows = [generator.integers(number, size=number) for _ in range(resamples)]
    draws = np.array([solve_balance(problem.part(each)).amounts for each in rows])
    ratios = contact_friction(pushes)
    slipping = ratios.slipping
    told = len(slipping) >= FEWEST
    friction = ratios.coefficient if told else float(ratios.sticking.max(initial=0.0))
    again = generator.integers(max(len(slipping), 1), size=(resamples, len(slipping)))
    frictions = np.median(slipping[again], axis=1) if told else np.full(resamples, friction)
    share = found.amounts.sum() / len(found.amounts)
    changes = (
        np.einsum("nab,nbc->nac", problem.whitening, problem.loads).reshape(3 * number, -1) * share
    )
    estimate = Estimate(
        amounts=found.amounts, draws=draws, friction=friction, frictions=frictions,
        residuals=np.sqrt((found.residuals**2).mean(axis=1)), facet=_facets(problem, found),
        optimality=found.optimality, told=np.linalg.svd(changes, compute_uv=False),
        doubts=() if told else (
            f"contact_friction: {len(slipping) or 'no'} pushes with forces slip; {friction:.3g} is a lower bound",
        ),
    )  # fmt: skip
    return estimate, Linear(changes, (changes @ found.amounts / share) - found.residuals.ravel())


def _facets(problem: Balance, found: Balanced) -> Array:
    """Of each push the place at rest that carries the largest weight, if its force is less than that."""
    facets = np.full(len(found.residuals), -1)
    weights = problem.columns[problem.pairs[:, 1]] @ found.amounts
    held = np.hypot(*found.forces.T) < WITHIN * weights
    for k in np.argsort(weights):
        push, place = problem.pairs[k]
        if held[k] and np.sqrt((found.residuals[push] ** 2).mean()) < FAR:
            facets[push] = place
    return facets


def from_motions(
    pushes: Measured,
    family: Family,
    first: tuple[Estimate, Linear] | None,
    resamples: int,
    generator: np.random.Generator,
    progress: bool,
) -> Estimate:
    """The estimate of final poses, of pushes that touch a side, and of the forces of others."""
    linear = None if first is None else first[1]
    fitted = fit_motions(MotionProblem.of(pushes, family), linear, progress)
    number, count = len(pushes), len(fitted.amounts)
    draws = np.array(
        [
            resampled(fitted, linear, generator.integers(number, size=number))
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
        optimality=fitted.optimality, told=np.linalg.svd(changes, compute_uv=False), doubts=doubts,
    )  # fmt: skip
