"""The convex quartic as limit surface, against ellipsoids, polynomials written out, and known supports."""

from dataclasses import replace
from itertools import combinations_with_replacement

import numpy as np
import pytest
from pushes.test_ellipsoid import SKEW
from pushes.written import TRIANGLE, feet, touching

import planar_pushing as pp
from planar_pushing.pushes.fit.ellipsoid import Ellipsoid
from planar_pushing.pushes.fit.quartic import FEWEST, Quartic, fitted_quartic, quartic_tensor
from planar_pushing.pushes.fit.scores import angles
from planar_pushing.pushes.logs.measured import measurements_of

NOISE = (0.5, 0.3, 0.05)
SQUARE = pp.Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)])


def squared(matrix):
    """The quartic with the motions of an ellipsoid: ``H = (w . A w)^2``."""
    pairs = np.einsum("ij,kl->ijkl", matrix, matrix)
    return (pairs + pairs.transpose(0, 2, 1, 3) + pairs.transpose(0, 3, 2, 1)) / 3.0


def of_powers(directions):
    """A sum of fourth powers, which is convex: ``sum (d . w)^4``."""
    return np.einsum("ni,nj,nk,nl->ijkl", *[np.asarray(directions, dtype=float)] * 4)


def random_pairs(count, seed):
    """Wrenches and twists that have nothing to do with each other, except that their power is positive."""
    random = np.random.default_rng(seed)
    wrenches, twists = random.normal(size=(2, count, 3))
    return wrenches, twists * np.sign((wrenches * twists).sum(axis=1))[:, None]


def pushed(count, noise=NOISE, **options):
    return measurements_of(
        pp.simulate_pushes(feet(), TRIANGLE, count, noise=noise, seed=6, **options)
    )


#: Convex quartics: round, of an ellipsoid, any, nearly flat, stretched, and about another point in mm.
SURFACES = {
    "round": Quartic(squared(np.eye(3))),
    "ellipsoid": Quartic(squared(SKEW.matrix)),
    "general": Quartic(of_powers(np.random.default_rng(3).normal(size=(9, 3)))),
    "nearly flat": Quartic(of_powers([*np.eye(3), (0.1, 0.1, 0.1), (0.1, -0.1, 0.0)])),
    "stretched": Quartic(of_powers([(1, 0, 0), (0, 1e-2, 0), (0, 0, 30), (1, 1e-2, 30), (1, -1e-2, 9)])),
    "about another point": Quartic.about(
        np.array([300.0, -200.0]), 75.0, of_powers(np.random.default_rng(3).normal(size=(9, 3)))
    ),
}  # fmt: skip


# -- the surface -------------------------------------------------------------------------------------


@pytest.mark.parametrize("model", SURFACES.values(), ids=SURFACES)
def test_motions_are_gradients_and_wrenches_their_inverse(model):
    random = np.random.default_rng(1)
    wrenches = random.normal(size=(300, 3))
    # The polynomial, monomial by monomial, and its gradient by differences.
    powers = {
        key: sum(
            model.tensor[order] for order in np.ndindex(3, 3, 3, 3) if tuple(sorted(order)) == key
        )
        for key in combinations_with_replacement(range(3), 4)
    }

    def value(w):
        return sum(c * w[a] * w[b] * w[c_] * w[d] for (a, b, c_, d), c in powers.items())

    for w, motion in zip(wrenches[:20], model.motions(wrenches[:20]), strict=True):
        step = 1e-3
        slopes = [
            (
                8.0 * (value(w + step * e) - value(w - step * e))
                - value(w + 2 * step * e) + value(w - 2 * step * e)
            ) / (12.0 * step)
            for e in np.eye(3)
        ]  # fmt: skip
        assert motion * 4.0 * np.sqrt(value(w)) == pytest.approx(
            slopes, rel=1e-6, abs=1e-6 * max(map(abs, slopes))
        )
    again = model.wrenches(model.motions(wrenches))
    size = np.abs(wrenches).max(axis=1, keepdims=True)
    assert (np.abs(again - wrenches) / size).max() < 1e-4
    twists = random.normal(size=(300, 3)) * np.abs(model.motions(wrenches)).mean(axis=0)
    assert angles(model.motions(model.wrenches(twists)), twists).max() < 1e-6
    assert model.motions(-2.0 * wrenches) == pytest.approx(-2.0 * model.motions(wrenches))
    assert model.wrenches(-2.0 * twists) == pytest.approx(-2.0 * model.wrenches(twists))


def test_nothing_moves_without_a_wrench():
    rows = np.array([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0)])
    for model in SURFACES.values():
        assert (model.motions(rows)[0] == 0.0).all()
        assert (model.wrenches(rows)[0] == 0.0).all()
        assert np.isfinite([model.motions(rows), model.wrenches(rows)]).all()


@pytest.mark.parametrize("path", [
    (0.0, 0.2), (0.2, 0.2), (-0.2, 0.1), (0.3, 0.0), (0.1, -0.2), (0.0, 0.0),
    [(0.0, 0.1), (0.0, 0.0), (0.1, 0.1)],
])  # fmt: skip
def test_a_squared_ellipsoid_moves_like_the_ellipsoid(path):
    """In every contact mode: it sticks, slips to either side, separates, or the finger rests."""
    places, mu = np.meshgrid([0.0, 0.4, -1.0], [0.0, 0.2, 1.5, 1e6])
    points, mu = np.column_stack([places.ravel(), np.full(places.size, -1.0)]), mu.ravel()
    pushes = touching(SQUARE.vertices, points, (0.0, 1.0), path, 0.1)
    one, other = (each.poses(pushes, mu) for each in (SKEW, Quartic(squared(SKEW.matrix))))
    assert other == pytest.approx(one, abs=1e-9)


@pytest.mark.parametrize("mu", [0.1, 0.6])
@pytest.mark.parametrize("name", ["nearly flat", "general"])
def test_contacts_obey_coulombs_law(name, mu):
    """The twists of short pushes, and the wrenches for these twists, which act at the contacts."""
    random, count = np.random.default_rng(2), 60
    place, ways = random.uniform(-1, 1, size=count), random.normal(size=(count, 2))
    ways *= np.sign(ways[:, 1:])
    points = np.column_stack([place, np.full(count, -1.0)])
    pushes = touching(SQUARE.vertices, points, (0.0, 1.0), 1e-8 * ways[:, None])
    twists = 1e8 * SURFACES[name].poses(pushes, mu)
    f_x, f_y, torque = SURFACES[name].wrenches(twists).T
    slip, gap = (ways - twists[:, :2] - twists[:, 2:] * np.column_stack([np.ones(count), place])).T
    assert gap == pytest.approx(0.0, abs=1e-6)
    assert torque == pytest.approx(place * f_y + f_x, abs=1e-3 * np.hypot(f_x, f_y).max())
    assert (f_y > 0.0).all()
    mode = np.where(np.abs(slip) > 1e-6, np.sign(slip), 0.0)
    assert set(mode) == {-1.0, 0.0, 1.0}
    ratio = f_x / f_y
    assert ratio[mode != 0.0] == pytest.approx(mu * mode[mode != 0.0], abs=1e-3)
    assert (np.abs(ratio) <= mu + 1e-3).all()


# -- the fit -----------------------------------------------------------------------------------------


def test_the_quartic_of_an_ellipsoid_is_fitted_again():
    wrenches = np.random.default_rng(0).normal(size=(40, 3))
    wrenches /= np.sqrt((wrenches * SKEW.motions(wrenches)).sum(axis=1))[:, None]
    tensor = quartic_tensor(wrenches, SKEW.motions(wrenches))
    others = np.random.default_rng(1).normal(size=(500, 3))
    assert angles(Quartic(tensor).motions(others), SKEW.motions(others)).max() < 0.1
    expected = squared(SKEW.matrix)
    assert tensor / tensor[0, 0, 0, 0] == pytest.approx(expected / expected[0, 0, 0, 0], abs=2e-3)


@pytest.mark.parametrize(("support", "degrees"), [
    (SQUARE, 1.0), (pp.Disc(1.0), 1.0), (pp.Ring(1.0), 0.3),
    (pp.Polygon([(2 * np.cos(t), 2 * np.sin(t)) for t in np.arange(6) * np.pi / 3]), 1.0),
])  # fmt: skip
def test_a_dense_support_is_approximated_better_than_by_its_ellipsoid(support, degrees):
    random = np.random.default_rng(0)
    friction = pp.SupportFriction(support=support)
    twists = random.normal(size=(400, 3))
    wrenches = pp.wrench(friction, twists)
    tensor = quartic_tensor(wrenches[:200], twists[:200])
    fit = pp.fit_ellipsoid(support)
    ellipsoid = Ellipsoid.about(np.array(fit.center), fit.matrix)
    error, other = (
        np.median(angles(model.motions(wrenches[200:]), twists[200:]))
        for model in (Quartic(tensor), ellipsoid)
    )
    assert error < degrees < 0.2 * other


@pytest.mark.parametrize(
    "seed", [*range(2), *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(2, 4))]
)
@pytest.mark.parametrize("count", [5, 8, 25, 60])
def test_fits_are_convex_even_to_nonsense(count, seed):
    tensor = quartic_tensor(*random_pairs(count, seed))
    loads = np.random.default_rng(9).normal(size=(2000, 3))
    curvature = np.linalg.eigvalsh(np.einsum("ijkl,ni,nj->nkl", tensor, loads, loads))[:, 0]
    assert (curvature > 1e-5 * (loads**2).sum(axis=1)).all()
    for order in ((1, 0, 2, 3), (0, 2, 1, 3), (3, 1, 2, 0)):
        assert tensor == pytest.approx(tensor.transpose(order), abs=1e-12)


def test_noisy_pushes_of_three_feet():
    """The fit in the object's frame, in millimeters, beats the ellipsoid of the known feet."""
    train, test = pushed(60), pushed(60, distance=10.0)
    model, friction = fitted_quartic(train)
    scale = [1, 1, 75]
    error = np.median(angles(model.motions(test.wrenches) * scale, test.twists * scale))
    fit = pp.fit_ellipsoid(feet()[0].support)
    ellipsoid = Ellipsoid.about(np.array(fit.center), fit.matrix)
    other = np.median(angles(ellipsoid.motions(test.wrenches) * scale, test.twists * scale))
    assert error < other
    assert 0.2 < friction < 0.3
    # Nothing depends on chance.
    assert (fitted_quartic(train)[0].tensor == model.tensor).all()


@pytest.fixture(scope="module")
def fitted():
    """Pushes, and what a quartic that is fitted to them says of their motions."""
    pushes = pushed(30)
    return pushes, motions_of(pushes)


def motions_of(pushes):
    return fitted_quartic(pushes)[0].motions(pushes.wrenches) * [1, 1, pushes.length]


@pytest.mark.parametrize("unit", [1e-3, 1.0, 25.4])
def test_units_and_the_frame_do_not_matter(fitted, unit):
    pushes, motions = fitted
    scaled = replace(
        pushes, outline=pp.Outline(unit * np.array(TRIANGLE)), contact=unit * pushes.contact,
        finger=unit * pushes.finger,
        displacement=unit * pushes.displacement, radius=unit * pushes.radius, path=unit * pushes.path,
        noise=(unit * pushes.noise[0], *pushes.noise[1:]), force=4.448 * pushes.force,
    )  # fmt: skip
    assert angles(motions, motions_of(scaled)).max() < 1e-3


def test_too_few_pushes_and_pushes_without_forces_have_no_quartic():
    pushes = pushed(12)
    assert fitted_quartic(replace(pushes, force=np.full((12, 2), np.nan))) is None
    assert fitted_quartic(pushes.part(np.arange(FEWEST - 1))) is None
    some = pushes.force.copy()
    some[FEWEST - 1 :] = np.nan
    assert fitted_quartic(replace(pushes, force=some)) is None
    assert fitted_quartic(pushes.part(np.arange(FEWEST))) is not None


def test_pushes_that_are_all_alike():
    """They determine one motion, which the fit predicts; the rest is some convex form."""
    one = pushed(8, noise=None)
    for row in range(3):
        alike = one.part(np.full(10, row))
        model, _ = fitted_quartic(alike)
        scale = [1, 1, alike.length]
        assert angles(model.motions(alike.wrenches) * scale, alike.twists * scale).max() < 2.0
        assert np.isfinite(model.wrenches(one.twists)).all()
        assert np.isfinite(model.motions(one.wrenches)).all()


def test_pushes_without_torque():
    pushes = pushed(8, noise=None)
    ways = 1e-6 * (pushes.center - pushes.contact)
    still = replace(pushes, displacement=ways, finger=ways, rotation=np.zeros(8))
    straight = replace(still, force=still.center - still.points)
    assert np.abs(straight.centered_wrenches[:, 2]).max() < 1e-9
    model, _ = fitted_quartic(straight)
    scale = [1, 1, 75]
    assert angles(model.motions(straight.wrenches) * scale, straight.twists * scale).max() < 5.0


def test_compare_fits_it_where_forces_are_known():
    pushes = pp.simulate_pushes(feet(), TRIANGLE, 40, noise=NOISE, seed=6)
    found = pp.compare(pushes, ["fitted_quartic", "known_feet"], resamples=20)
    assert found["model"].values.tolist() == ["fitted_quartic", "known_feet", "fitted_ellipsoid"]
    motion = found["median"].sel(quantity="motion")
    assert motion.sel(model="known_feet") < motion.sel(model="fitted_quartic")
    assert motion.sel(model="fitted_quartic") < motion.sel(model="fitted_ellipsoid")
    assert np.isfinite(found["error"]).all()
