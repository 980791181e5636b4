"""The balance of forces: its cone program against scipy, its certificate, pushes about a foot."""

from dataclasses import replace

import numpy as np
import pytest
from pushes.written import TRIANGLE, feet
from scipy.optimize import minimize, nnls

import planar_pushing as pp
from planar_pushing.pushes.fit.balance import _violation, balance, fit_balance, ridge, solve_balance
from planar_pushing.pushes.fit.candidates import Family, points, uniform_and_corners
from planar_pushing.pushes.logs.measured import measurements_of

NOISE = (0.5, 0.3, 0.05)


def pushed(count=20, **options):
    return measurements_of(
        pp.simulate_pushes(feet(), TRIANGLE, count, **{"noise": NOISE} | options)
    )


def weighed(problem, amounts, forces):
    """Residuals in standard deviations by plain loops."""
    found = []
    for k in range(len(problem.wrenches)):
        load = problem.loads[k] @ amounts - problem.wrenches[k]
        for (push, _), reach, force in zip(problem.pairs, problem.reaches, forces, strict=True):
            if push == k:
                load = load + reach @ force
        found.append(problem.whitening[k] @ load)
    return np.array(found)


def cost(problem, amounts, forces):
    pull = problem.pull * (amounts - problem.even)
    return 0.5 * ((weighed(problem, amounts, forces) ** 2).sum() + (pull**2).sum())


def test_without_places_at_rest_it_is_nonnegative_least_squares():
    """By scipy's nnls, with and without the pull towards even amounts, which is more rows."""
    family = points(pp.Outline(TRIANGLE), 30.0)
    pushes = replace(pushed(), noise=(0.0, 0.0, 0.05))
    problem = balance(pushes, family, np.full(len(family.places), 0.2))
    assert len(problem.pairs) == 0
    count = len(family.places)
    assert problem.even == pytest.approx(0.2)
    assert problem.pull == pytest.approx(ridge(60, count) / 0.2)
    matrix = np.concatenate(problem.whitening @ problem.loads)
    target = np.einsum("nab,nb->na", problem.whitening, problem.wrenches).ravel()
    expected = nnls(
        np.concatenate([matrix, problem.pull * np.eye(count)]),
        np.append(target, np.full(count, problem.pull * problem.even)),
    )[0]
    found = solve_balance(problem)
    assert found.amounts == pytest.approx(expected, abs=5e-5)
    assert (found.amounts > 1e-3).sum() >= 3
    free = solve_balance(replace(problem, pull=0.0))
    assert free.amounts == pytest.approx(nnls(matrix, target)[0], abs=1e-4)


def test_with_places_at_rest_it_is_a_cone_program():
    """By SLSQP over amounts and forces, each at most the weight of its place."""
    family = uniform_and_corners(pp.Outline(TRIANGLE), 30.0)
    pushes = replace(pushed(6), noise=(0.5, 0.005, 0.05))
    problem = balance(pushes, family, family.columns @ np.full(4, 1.25))
    count, pairs = 4, len(problem.pairs)
    assert 3 <= pairs <= 20
    weights = problem.columns[problem.pairs[:, 1]]

    def parts(x):
        return x[:count], x[count:].reshape(-1, 2)

    bound = {"type": "ineq", "fun": lambda x: (
        (weights @ x[:count]) ** 2 - (parts(x)[1] ** 2).sum(axis=1)
    )}  # fmt: skip
    start = np.append(np.full(count, 1.25), np.zeros(2 * pairs))
    other = minimize(
        lambda x: cost(problem, *parts(x)), start, method="SLSQP", constraints=[bound],
        bounds=[(0, None)] * count + [(None, None)] * 2 * pairs, options={"maxiter": 300, "ftol": 1e-12},
    )  # fmt: skip
    found = solve_balance(problem)
    assert cost(problem, found.amounts, found.forces) <= other.fun * (1 + 1e-6)
    assert found.amounts == pytest.approx(parts(other.x)[0], abs=0.02)
    sizes = np.hypot(*found.forces.T)
    assert (sizes <= weights @ found.amounts + 1e-7).all()
    assert found.residuals == pytest.approx(weighed(problem, found.amounts, found.forces), abs=1e-7)


def test_the_certificate_tells_the_optimum():
    """Small at the solution; the cost of feasible points nearby is larger."""
    problem, found, _ = fit_balance(pushed(), points(pp.Outline(TRIANGLE), 25.0))
    assert len(problem.pairs) > 0
    assert found.optimality < 1e-7
    best, random = cost(problem, found.amounts, found.forces), np.random.default_rng(0)
    weights = problem.columns[problem.pairs[:, 1]]
    for _ in range(200):
        step = (
            0.05
            * random.normal(size=len(found.amounts))
            * (random.random(len(found.amounts)) < 0.2)
        )
        amounts = np.maximum(found.amounts + step, 0.0)
        forces = found.forces + 0.02 * random.normal(size=found.forces.shape)
        size, limit = np.hypot(*forces.T), weights @ amounts
        forces = forces * np.minimum(1.0, limit / np.maximum(size, 1e-300))[:, None]
        assert cost(problem, amounts, forces) > best - 1e-9 * best


def test_the_certificate_is_large_elsewhere():
    """Amounts that are larger, in another order, or none of which is zero."""
    problem, found, _ = fit_balance(pushed(), points(pp.Outline(TRIANGLE), 25.0))
    target = np.einsum("nab,nb->na", problem.whitening, problem.wrenches).ravel()
    for amounts in (1.05 * found.amounts, found.amounts[::-1], found.amounts + 0.01):
        residuals = weighed(problem, amounts, found.forces)
        assert _violation(problem, amounts, residuals, target) > 1e-3


def about(foot, angles, force):
    """Pushes that turn the triangle about a place by small angles, with forces in the object's axes."""
    count = len(angles)
    poses = []
    for angle in angles:
        c, s = np.cos(angle), np.sin(angle)
        poses.append([*(foot - np.array([[c, -s], [s, c]]) @ foot), angle])
    pushes = pp.pushes_from_poses(
        outline=TRIANGLE, poses_before=np.zeros((count, 3)), poses_after=poses,
        finger_start=[(120.0, 0.0)] * count, finger_end=[(120.0, 120.0 * a) for a in angles],
        finger_radius=0.0, force=[force] * count, units=("mm", "N"), noise=NOISE,
    )  # fmt: skip
    return measurements_of(pushes)


def test_a_push_exactly_about_a_foot():
    """The foot at rest carries any force up to its weight, against that of the finger and the others.

    The finger pushes at (120, 0) along +y and turns the object about (10, 10); feet at (130, 10) and
    (10, 130) resist by 2 N each along +y and -x.
    """
    places = np.array([(10.0, 10.0), (130.0, 10.0), (10.0, 130.0)])
    family = Family(places, np.eye(3))
    pushes = about(places[0], [0.02] * 4, (0.0, 4.5))
    problem = balance(pushes, family, np.full(3, 2.0))
    assert problem.pairs.tolist() == [[k, 0] for k in range(4)]
    assert problem.loads[:, :, 0] == pytest.approx(0.0)
    resisted = problem.loads[0] @ [0.0, 2.0, 2.0]
    assert resisted[:2] == pytest.approx([-2.0, 2.0], abs=0.05)
    # About the centroid (50, 50): both turn it at 120 mm from the foot.
    torque = 2 * (80.0 * 1.0) + 2 * (80.0 * 1.0)
    assert resisted[2] * pushes.length == pytest.approx(torque, rel=0.02)
    assert problem.reaches[0] == pytest.approx(np.array([(1, 0), (0, 1), (40 / 75, -40 / 75)]))
    # Any force of the foot is explained, and the torque about it tells the sum of the others.
    for force in ((1.5, 0.5), (-3.0, 0.0), (0.0, 0.0)):
        wrenches = np.array([resisted + problem.reaches[0] @ force] * 4)
        held = solve_balance(replace(problem, wrenches=wrenches, pull=0.0))
        assert held.optimality < 1e-6
        assert held.residuals == pytest.approx(0.0, abs=1e-4)
        assert held.amounts[1:].sum() == pytest.approx(4.0, abs=1e-3)
        assert np.hypot(*held.forces.T).max() <= held.amounts[0] + 1e-6


def test_pushes_that_come_twice_weigh_twice():
    """The problem of some pushes is that of a dataset in which they come so often."""
    pushes, family = pushed(8), points(pp.Outline(TRIANGLE), 40.0)
    problem = balance(pushes, family, np.full(len(family.places), 0.3))
    assert len(problem.pairs) > 0
    rows = np.array([5, 0, 5, 3, 5])
    part = problem.part(rows)
    whole = balance(pushes.part(rows), family, np.full(len(family.places), 0.3))
    assert part.pairs.tolist() == whole.pairs.tolist()
    for name in ("loads", "wrenches", "reaches", "whitening"):
        assert getattr(part, name) == pytest.approx(getattr(whole, name)), name
    doubled = solve_balance(
        replace(problem.part(np.repeat(np.arange(8), 2)), pull=problem.pull * 2**0.5)
    )
    assert doubled.amounts == pytest.approx(solve_balance(problem).amounts, abs=1e-5)


def test_loads_are_those_of_the_support():
    """At twists under which no place rests, the sum of loads is the wrench of `pp.wrench`."""
    pushes = replace(pushed(10), noise=(0.0, 0.0, 0.05))
    places = np.array([(10.0, 10.0), (130.0, 10.0), (10.0, 130.0)])
    weights = np.array([1.0, 2.0, 3.0])
    problem = balance(pushes, Family(places, np.eye(3)), weights)
    friction = pp.SupportFriction(
        support=pp.Points(places - pushes.center, weights), weight=weights.sum()
    )
    expected = np.array([pp.wrench(friction, each) for each in pushes.centered_twists])
    assert problem.loads @ weights == pytest.approx(expected / [1, 1, pushes.length], abs=1e-9)


def test_residuals_are_weighed_by_their_standard_deviations():
    """Of simulated noise in twist and force, away from feet: the spread of whitened residuals is 1 at most.

    The weights are the truth; friction that differs by 5 % from push to push is allowed for.
    """
    quiet, places = pushed(1, noise=None, seed=3), np.array(feet()[0].support.positions)
    random, count = np.random.default_rng(1), 400
    many = replace(
        quiet.part(np.zeros(count, dtype=int)),
        noise=(0.5, np.deg2rad(0.3), 0.05),
        repeatability=0.05,
    )
    newtons = np.hypot(*quiet.force[0])
    noisy = replace(
        many,
        displacement=many.displacement + 0.5 * random.normal(size=(count, 2)),
        rotation=many.rotation + np.deg2rad(0.3) * random.normal(size=count),
        force=many.force + np.hypot(0.05, 0.05 * newtons) * random.normal(size=(count, 2)),
    )
    weights = np.full(3, 5.0 / 3.0)
    problem = balance(noisy, Family(places, np.eye(3)), weights)
    assert len(problem.pairs) < 4
    residuals = np.delete(
        weighed(problem, weights, np.zeros((4, 2))[: len(problem.pairs)]), problem.pairs[:, 0], 0
    )
    assert residuals.std(axis=0) == pytest.approx(np.ones(3), abs=0.45)


def test_a_wild_push_counts_little():
    """One push of 60 whose force has the wrong sign hardly changes the weights."""
    pushes, family = pushed(60, seed=5), Family(np.array(feet()[0].support.positions), np.eye(3))
    force = pushes.force.copy()
    force[7] *= -1.0
    fine, wild = (fit_balance(each, family)[1] for each in (pushes, replace(pushes, force=force)))
    assert fine.amounts == pytest.approx(np.full(3, 5 / 3), rel=0.05)
    assert wild.amounts == pytest.approx(fine.amounts, rel=0.03)
