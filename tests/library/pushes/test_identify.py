"""Supports from simulated pushes: with forces, without, both; families; and one line for what is wrong."""

import numpy as np
import pytest
from pushes.written import TRIANGLE, feet, small

import planar_pushing as pp
from planar_pushing.pushes.identified import Identified

NOISE = (0.5, 0.3, 0.05)
PLACES = np.array([(10.0, 10.0), (130.0, 10.0), (10.0, 130.0)])
#: Of the three feet.
TRUTH = {
    "weight": 5.0, "contact_friction": 0.25, "center_of_pressure_x": 50.0, "center_of_pressure_y": 50.0,
    "spin_torque": np.hypot(*(PLACES - 50.0).T).mean(),
}  # fmt: skip
CORNERS = [(0.0, 0.0), (150.0, 0.0), (0.0, 150.0)]


def pushed(count, *, forces=True, **options):
    pushes = pp.simulate_pushes(feet(), TRIANGLE, count, **{"noise": NOISE} | options)
    return pushes if forces else pushes.drop_vars("force")


def weight_near(points, place, distance):
    """Fraction of the load within a distance of a place."""
    places, weights = np.array(points.positions), np.array(points.weights)
    return weights[np.hypot(*(places - place).T) <= distance].sum() / weights.sum()


@pytest.fixture(scope="module")
def noisy():
    return pushed(60, seed=7)


@pytest.fixture(scope="module")
def found(noisy):
    return pp.identify(noisy, resamples=60)


def test_exact_pushes_tell_the_feet():
    """Short ones, whose twist is that of an instant: the mean force is the load at the mean twist."""
    pushes = pushed(60, noise=(0.0, 0.0, 0.0), distance=1.5, seed=2)
    found = pp.identify(pushes, resamples=1)
    assert found.weight == pytest.approx(5.0, rel=0.02)
    assert found.center_of_pressure == pytest.approx([50.0, 50.0], abs=0.02 * 75)
    assert found.spin_torque == pytest.approx(TRUTH["spin_torque"], rel=0.02)
    assert found.contact_friction == pytest.approx(0.25, abs=0.005)
    for place in PLACES:
        assert weight_near(found.support, place, 10.5) == pytest.approx(1 / 3, abs=0.02)


def test_noisy_pushes_tell_the_feet_within_their_intervals(found, noisy):
    values = {
        "weight": found.weight, "contact_friction": found.contact_friction,
        "center_of_pressure_x": found.center_of_pressure[0],
        "center_of_pressure_y": found.center_of_pressure[1], "spin_torque": found.spin_torque,
    }  # fmt: skip
    assert found.intervals.keys() == TRUTH.keys()
    for name, (low, high) in found.intervals.items():
        assert low <= TRUTH[name] <= high, name
        assert low <= values[name] <= high, name
        assert high - low < 0.15 * values[name], name
    assert sum(found.support.weights) == pytest.approx(1.0)
    assert found.weight_intervals.shape == (len(found.support.weights), 2)
    assert (found.weight_intervals[:, 0] <= found.weight_intervals[:, 1]).all()
    assert found.optimality < 1e-6
    assert (found.length, found.spacing) == (75.0, 10.0)
    assert np.isfinite(found.residuals).all()
    assert np.median(found.residuals) < 1.5
    assert len(found.undetermined) == 1
    assert found.undetermined[0].startswith("weights of single points: the pushes determine ")


def test_feet_are_neighbors_that_are_joined(found):
    own = np.array(found.feet.positions)
    for place in PLACES:
        assert np.hypot(*(own - place).T).min() < found.spacing
        assert weight_near(found.feet, place, found.spacing) == pytest.approx(1 / 3, abs=0.05)


def test_a_push_about_a_foot_lies_in_its_facet(found, noisy):
    """The center of rotation of a push in a facet is near to the point of that facet."""
    places = np.array(found.support.positions)
    rows = np.flatnonzero(found.facet >= 0)
    assert 0 < len(rows) < 60
    for row in rows:
        place = places[found.facet[row]]
        d, angle = noisy["displacement"].values[row], np.deg2rad(noisy["rotation"].values[row])
        c, s = np.cos(angle) - 1.0, np.sin(angle)
        moved = d + np.array([[c, -s], [s, c]]) @ place
        assert np.hypot(*moved) < 3 * np.hypot(0.5, np.deg2rad(0.3) * 120)


def test_one_seed_makes_one_result(noisy):
    given = {"spacing": 20.0, "resamples": 5}
    one = pp.identify(noisy, seed=3, **given)
    assert pp.identify(noisy, seed=3, **given) == one
    other = pp.identify(noisy, seed=4, **given)
    assert other.support == one.support
    assert other.intervals != one.intervals
    assert repr(one).startswith(f"Identified({len(one.support.weights)} points, weight=")


def test_known_feet(noisy):
    for known in (PLACES, PLACES.tolist(), pp.Points(PLACES, [1, 1, 1])):
        found = pp.identify(noisy, known=known, resamples=20)
        assert np.array(found.support.positions) == pytest.approx(PLACES)
        assert found.support.weights == pytest.approx([1 / 3] * 3, abs=0.02)
        assert found.weight == pytest.approx(5.0, rel=0.02)
        assert found.undetermined == ()


@pytest.mark.parametrize("family", ["points", "uniform_and_corners", "ellipse", "map"])
def test_each_family_finds_an_even_plate(family):
    plate = pp.SupportFriction(support=pp.Polygon(TRIANGLE), weight=5.0)
    pushes = pp.simulate_pushes((plate,), TRIANGLE, 40, noise=NOISE, seed=3)
    found = pp.identify(pushes, family=family, resamples=1)
    assert found.weight == pytest.approx(5.0, rel=0.03)
    assert found.center_of_pressure == pytest.approx([50.0, 50.0], abs=2.5)
    x, y = np.random.default_rng(0).dirichlet([1, 1, 1], size=100000)[:, :2].T * 150
    assert found.spin_torque == pytest.approx(np.hypot(x - 50, y - 50).mean(), rel=0.06)


def test_weight_at_the_corners_is_told_from_an_even_pressure():
    support = pp.Composite([(2, pp.Polygon(TRIANGLE)), (1, pp.Points([CORNERS[1]], [1]))])
    effects = (pp.SupportFriction(support=support, weight=5.0),)
    pushes = pp.simulate_pushes(effects, TRIANGLE, 40, noise=NOISE, seed=3)
    found = pp.identify(pushes, family="uniform_and_corners", resamples=5)
    assert weight_near(found.support, CORNERS[1], 1e-6) == pytest.approx(1 / 3, abs=0.04)
    for corner in (CORNERS[0], CORNERS[2]):
        assert weight_near(found.support, corner, 1e-6) < 0.04


@pytest.mark.slow
def test_poses_alone_tell_center_and_friction():
    found = pp.identify(pushed(40, forces=False, distance=30.0, seed=1), resamples=30)
    assert found.center_of_pressure == pytest.approx([50.0, 50.0], abs=3.0)
    assert found.contact_friction == pytest.approx(0.25, abs=0.05)
    assert found.spin_torque == pytest.approx(TRUTH["spin_torque"], rel=0.15)
    assert np.isnan(found.weight)
    assert np.isnan(found.intervals["weight"]).all()
    assert "weight: no force was measured" in found.undetermined
    assert (found.facet == -1).all()
    assert np.median(found.residuals) < 2.5


def test_known_feet_from_poses_alone():
    found = pp.identify(pushed(15, forces=False, seed=2), known=PLACES, resamples=20)
    assert found.support.weights == pytest.approx([1 / 3] * 3, abs=0.06)
    assert found.contact_friction == pytest.approx(0.25, abs=0.05)
    low, high = found.intervals["center_of_pressure_x"]
    assert low < found.center_of_pressure[0] < high


def test_forces_of_some_pushes_only():
    """The weight comes from forces, and all residuals are there: of wrenches and of poses."""
    pushes = pushed(24, seed=2)
    force = pushes["force"].values.copy()
    force[::2] = np.nan
    mixed = pushes.assign(force=(("push", "xy"), force, {"units": "N"}))
    found = pp.identify(mixed, known=PLACES, resamples=20)
    assert found.weight == pytest.approx(5.0, rel=0.05)
    assert found.support.weights == pytest.approx([1 / 3] * 3, abs=0.05)
    assert found.contact_friction == pytest.approx(0.25, abs=0.05)
    assert np.isfinite(found.residuals).all()
    assert not any("weight:" in each for each in found.undetermined)


def corner_pushes(count=6, forces=False):
    """The square's corner (1, 1), along its bisector."""
    force = {"force": [(-1.0, -1.0)] * count} if forces else {}
    return pp.pushes_from_poses(
        outline=[(-1, -1), (1, -1), (1, 1), (-1, 1)], poses_before=np.zeros((count, 3)),
        poses_after=[(-0.2, -0.2, 0.0)] * count, finger_start=[(1, 1)] * count,
        finger_end=[(0.8, 0.8)] * count, finger_radius=0.0, units=("mm", "N"), **force,
    )  # fmt: skip


def test_pushes_at_a_corner_have_no_residual_without_forces():
    sides = small(
        displacement=(("push", "xy"), [(0, 0.15), (0, 0.2), (-0.17, 0.02)], {"units": "mm"})
    )
    pushes = pp.concat_pushes([sides, corner_pushes(2).assign_coords(object=["square"]).assign(
        pushed=("push", ["square"] * 2)
    )])  # fmt: skip
    found = pp.identify(pushes, family="ellipse", resamples=3)
    assert np.isfinite(found.residuals).tolist() == [True, True, True, False, False]


def test_too_few_pushes_slip_to_tell_the_friction():
    pushes = pushed(12, contact=pp.InfiniteFriction(), seed=4)
    found = pp.identify(pushes, spacing=30.0, resamples=3)
    said = [each for each in found.undetermined if each.startswith("contact_friction: ")]
    assert len(said) == 1
    assert "is a lower bound" in said[0]
    assert found.contact_friction > 0.5


def test_another_outline_replaces_that_of_the_dataset(noisy):
    larger = [(-1, -1), (152, -1), (-1, 152)]
    found = pp.identify(noisy.isel(push=slice(20)), larger, spacing=30.0, resamples=2)
    assert np.array(found.support.positions).min() == -1.0
    assert found.length == 76.5
    with pytest.raises(
        pp.InvalidValue, match=r"^contact: .* given; allowed: a point of the outline"
    ):
        pp.identify(noisy, [(5, 5), (140, 5), (5, 140)])


def two_objects():
    other = small(pushed=("push", ["other"] * 3)).assign_coords(object=["other"])
    return pp.concat_pushes([small(), other])


@pytest.mark.parametrize(("pushes", "options", "said"), [
    (two_objects, {}, "pushes: 'pushes of square, other' given; allowed: pushes of one object"),
    (small, {"spacing": 0.1}, "pushes: '3 pushes for 441 candidates' given; allowed: at most 7 candidates"),
    (small, {"spacing": 0.001}, "spacing: 0.001 given; allowed: a number from 0.02 to 2"),
    (small, {"spacing": 1e9, "known": [(0.0, 0.0)]}, "spacing: 1000000000.0 given; allowed: a number from"),
    (small, {"spacing": "wide"}, "spacing: 'wide' given; allowed: a number from 0.02 to 2"),
    (small, {"family": "point"},
     "family: 'point' given; allowed: points, uniform_and_corners, ellipse, map"),
    (small, {"family": "uniform_and_corners", "resamples": 0}, "resamples: 0 given; allowed: a whole"),
    *((small, {"family": family}, f"family: {family!r} given; allowed: points,")
      for family in ([], None)),
    (small, {"progress": [True]}, "progress: [True] given; allowed: True or False"),
    (small, {"resamples": 1e308}, "resamples: 1e+308 given; allowed: a whole number >= 1, at most 1e+07"),
    (small, {"seed": "a"}, "seed: 'a' given; allowed: a whole number >= 0"),
    (lambda: small().isel(push=slice(1)), {}, "pushes: '1 push for 4 candidates' given; allowed:"),
    (corner_pushes, {}, "pushes: 'pushes that touch a corner first' given; allowed: some that"),
    (small, {"outline": [(0, 0), (1, 1)]}, "outline: "),
    (small, {"known": [(0.0, np.nan)]}, "positions"),
])  # fmt: skip
def test_wrong_input(pushes, options, said):
    with pytest.raises(pp.InvalidValue) as error:
        pp.identify(pushes(), **options)
    assert str(error.value).startswith(said), str(error.value)
    assert "\n" not in str(error.value)


def identified(places, weights, spacing):
    none = np.zeros(0)
    return Identified(
        support=pp.Points(places, weights), weight=1.0, contact_friction=0.2,
        center_of_pressure=np.zeros(2), spin_torque=1.0, intervals={}, weight_intervals=none,
        residuals=none, facet=none.astype(int), length=1.0, spacing=spacing, optimality=0.0,
        undetermined=(),
    )  # fmt: skip


def test_feet_of_a_support():
    """Points next to each other, also diagonally, are one foot at their center of pressure."""
    found = identified(
        [(0, 0), (1, 1), (5, 5), (5, 7), (5, 6)], [0.1, 0.3, 0.2, 0.2, 0.2], 1.0
    ).feet
    order = np.argsort(np.array(found.positions)[:, 0])
    assert np.array(found.positions)[order] == pytest.approx(np.array([(0.75, 0.75), (5.0, 6.0)]))
    assert np.array(found.weights)[order] == pytest.approx([0.4, 0.6])
    assert len(identified([(0, 0), (0, 2.1)], [0.5, 0.5], 1.0).feet.weights) == 2
    one = identified([(1, 2)], [1.0], 1.0)
    assert one.feet == one.support
    assert one == identified([(1, 2)], [1.0], 1.0)
