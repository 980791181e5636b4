"""The boundary of the rotation centers of stable pushes."""

from dataclasses import replace

import numpy as np
import pytest
from stability.flush import SCENES, SQUARE, Flush, push, random_scene, rub, torqued

import planar_pushing as pp

#: Scenes whose pushes are stable within a set with an inside.
BOUNDED = [
    n for n, flush in SCENES.items() if flush.law not in (pp.Coulomb(0), pp.PerfectlyRough())
]
LEFT, RIGHT = pp.Sense.COUNTERCLOCKWISE, pp.Sense.CLOCKWISE


def unit(flush, twists):
    """Twists with speeds at the contact's origin, as unit vectors."""
    x, y = flush.point
    moved = twists + twists[..., 2:] * np.array([-y, x, 0.0])
    return moved / np.linalg.norm(moved, axis=-1, keepdims=True)


def back(flush, units):
    x, y = flush.point
    return units + units[..., 2:] * np.array([y, -x, 0.0])


def off(flush, curve):
    """How far the loads of a curve are from the limit that bounds it; about a foot, the nearest of them."""
    n = np.array(flush.normal) / np.linalg.norm(flush.normal)
    x, y = flush.point
    t, (start, end) = np.array([n[1], -n[0]]), flush.ends
    mu = getattr(flush.law, "friction_coefficient", np.inf)
    right, left = (t - mu * n, t + mu * n) if mu < np.inf else (n, n)
    row = {
        "right-edge": (*right / np.hypot(*right), 0.0), "left-edge": (*left / np.hypot(*left), 0.0),
        "start": moment(np.array([x, y]) + start * t), "end": moment(np.array([x, y]) + end * t),
    }[curve.bound]  # fmt: skip
    twists = curve.twists[1:-1]
    loads = [
        -torqued(np.array(each.center), np.array(each.force)) if isinstance(each, pp.Load)
        else pp.wrench(each, twists)
        for each in flush.effects
    ]  # fmt: skip
    apart = np.abs(sum(loads) @ row)
    for k in np.flatnonzero(foot_speeds(flush, twists) < 1e-6 * np.abs(twists[:, 2])):
        sets = pp.wrench_set(flush.effects, twists[k], tolerance=1e-9)
        reach = 0.0
        if sets.foot is not None:
            r_x, r_y = sets.foot
            reach = sets.radius * np.hypot(row[0] - row[2] * r_y, row[1] + row[2] * r_x)
        apart[k] = max(abs(sets.offset @ row) - reach, 0.0)
    return apart


def foot_speeds(flush, twists):
    """Speed of the slowest foot of each twist."""
    supports = [each.support for each in flush.effects if hasattr(each, "support")]
    feet = np.concatenate([getattr(each, "positions", np.empty((0, 2))) for each in supports])
    x = twists[:, :1] - twists[:, 2:] * feet[:, 1]
    y = twists[:, 1:2] + twists[:, 2:] * feet[:, 0]
    return np.hypot(x, y).min(axis=1, initial=np.inf)


def moment(place):
    """Torque about a place, of wrenches about the origin."""
    return np.array([place[1], -place[0], 1.0])


def check_reasons(flush, region):
    for curve in region.curves:
        senses = np.sign(curve.twists[:, 2])
        assert set(senses) <= {0.0, 1.0 if curve.sense is LEFT else -1.0}
        if curve.bound is pp.StableBound.PIVOT:
            (center,) = curve.centers
            supports = [each.support for each in flush.effects if hasattr(each, "support")]
            feet = np.concatenate(
                [getattr(each, "positions", np.empty((0, 2))) for each in supports]
            )
            assert np.hypot(*(feet - center).T).min() < 1e-9
            assert not region.contains(center, curve.sense)
            continue
        # The load of a foot next to the center is as rough as the place of the center.
        apart = off(flush, curve)
        assert not len(apart) or (np.median(apart) < 1e-9 and apart.max() < 1e-4)


def check_flips(flush, region):
    """Stable inside, not stable outside, right next to the curve; its interior is on one side all along."""
    for curve in region.curves:
        one = unit(flush, curve.twists)
        steps = np.diff(one, axis=0)
        length = np.linalg.norm(steps, axis=-1)
        ways = steps / length[:, None]
        # Where the curve is smooth: not next to a foot.
        smooth = (ways[1:] * ways[:-1]).sum(axis=-1) > 0.99
        smooth &= np.minimum(length[1:], length[:-1]) > 2e-3
        # Where no other curve is near, as in a sharp corner.
        others = [unit(flush, each.twists) for each in region.curves if each is not curve]
        apart = np.concatenate([np.full((1, 3), np.inf), *others])
        smooth &= np.linalg.norm(one[1:-1, None] - apart, axis=-1).min(axis=1) > 0.02
        aside = 2e-4 * np.cross(one[1:-1], ways[1:] + ways[:-1])[smooth]
        inside, outside = one[1:-1][smooth] - aside, one[1:-1][smooth] + aside
        assert pp.stable(flush.scene, back(flush, inside)).all()
        assert not pp.stable(flush.scene, back(flush, outside)).any()


def check_closed(flush, region):
    for curve, after in zip(region.curves, (*region.curves[1:], region.curves[0]), strict=True):
        ends = unit(flush, np.array([curve.twists[-1], after.twists[0]]))
        assert np.allclose(*ends, atol=1e-8)
        gaps = np.linalg.norm(np.diff(unit(flush, curve.twists), axis=0), axis=-1)
        assert gaps.max(initial=0.0) < 0.5


@pytest.mark.parametrize("name", BOUNDED)
def test_curves(name):
    flush = SCENES[name]
    region = pp.stable_centers(flush.scene)
    assert region.curves
    check_reasons(flush, region)
    check_flips(flush, region)
    check_closed(flush, region)


@pytest.mark.parametrize("count", [8, pytest.param(100, marks=pytest.mark.slow)])
def test_curves_of_random_scenes(count):
    rng = np.random.default_rng(8)
    while count:
        flush = random_scene(rng)
        if any(isinstance(each, pp.Viscous) for each in flush.effects):
            continue
        region = pp.stable_centers(flush.scene)
        check_reasons(flush, region)
        check_flips(flush, region)
        check_closed(flush, region)
        count -= 1


@pytest.mark.parametrize("name", [n for n, flush in SCENES.items() if flush.law == pp.Coulomb(0)])
def test_without_friction_the_set_is_a_curve(name):
    flush = SCENES[name]
    region = pp.stable_centers(flush.scene)
    assert {curve.bound for curve in region.curves} <= {"right-edge", "pivot"}
    check_reasons(flush, region)
    for curve in region.curves:
        inside = curve.twists[1:-1]
        assert pp.stable(flush.scene, inside).all() or "feet" in name
        aside = back(flush, unit(flush, inside) + np.array([1e-4, 0.0, 0.0]))
        assert not pp.stable(flush.scene, aside).any()


def test_rough_contact_has_no_bounds():
    region = pp.stable_centers(SCENES["square, rough"].scene)
    assert region.curves == ()
    assert region.contains((0.3, 0.2), "clockwise")


def test_a_foot_that_takes_every_force():
    """The object turns about a foot that carries almost everything, and no push is stable."""
    feet = pp.Points([(0, 0), (3, 1), (-3, 1)], (100, 1, 1))
    region = pp.stable_centers(
        Flush(effects=(rub(feet),), ends=(-0.3, 0.3), point=(1.5, -1.0)).scene
    )
    (curve,) = region.curves
    assert (curve.bound, curve.sense) == ("pivot", LEFT)
    assert not region.contains(
        np.add(curve.centers, [[0, 0], [1e-3, 0], [0, 1e-3], [-1e-3, 0]]), LEFT
    ).any()


@pytest.mark.parametrize("sense", ["counterclockwise", LEFT])
def test_contains(sense):
    region = pp.stable_centers(SCENES["square"].scene)
    centers = np.random.default_rng(6).uniform(-4, 4, (5, 40, 2))
    inside = region.contains(centers, sense)
    assert inside.shape == (5, 40)
    assert 0 < inside.sum() < 200
    assert inside[2, 3] == region.contains(centers[2, 3], sense) == pp.stable(
        region.scene, push(centers[2, 3], 1.0)
    )  # fmt: skip
    assert region.contains((-0.67669, 0.0), sense)
    assert not region.contains((-0.67668, 0.0), sense)
    assert not region.contains((-2.0, 0.0), RIGHT)


@pytest.mark.parametrize(
    ("mu", "height", "first"), [(0.25, -1, 3.99601), (1, -1, 1.33934), (1, 0, 0.67668264)]
)
def test_curves_of_a_square_cross_lines(mu, height, first):
    region = pp.stable_centers(Flush(effects=(rub(SQUARE),), law=pp.Coulomb(mu)).scene)
    crossings = []
    for curve in region.curves:
        x, y = curve.centers[np.isfinite(curve.centers).all(axis=-1)].T
        for i in np.flatnonzero((y[:-1] - height) * (y[1:] - height) <= 0):
            x_at = x[i] + (height - y[i]) / (y[i + 1] - y[i]) * (x[i + 1] - x[i])
            crossings += [x_at] if curve.sense is RIGHT else []
    assert min(crossings) == pytest.approx(first, rel=2e-3)


def test_frames_and_units():
    """The set turns and grows with the object; without a placement it is in the body frame."""
    region = pp.stable_centers(SCENES["three feet"].scene)
    c, s, size = np.cos(0.7), np.sin(0.7), 1e-3
    turned = size * np.array([[c, -s], [s, c]])
    feet = SCENES["three feet"].effects[0].support
    support = pp.Points(np.array(feet.positions) @ turned.T + [3.0, 4.0], feet.weights)
    point, normal = turned @ [0.0, -1.0] + [3.0, 4.0], turned @ [0.0, 1.0]
    flush = Flush(
        effects=(rub(support, 80.0),), law=pp.Coulomb(0.8), point=tuple(point), normal=tuple(normal),
        ends=(-size, size),
    )  # fmt: skip
    other = pp.stable_centers(flush.scene)
    body = pp.stable_centers(replace(flush.scene, placement=None))
    assert len(other.curves) == len(region.curves) == len(body.curves)
    for one, two, three in zip(region.curves, other.curves, body.curves, strict=True):
        assert (one.bound, one.sense) == (two.bound, two.sense) == (three.bound, three.sense)
        ends, moved, in_body = (each.centers[[0, -1]] for each in (one, two, three))
        finite = np.isfinite(ends).all(axis=-1)
        assert np.allclose(ends[finite] @ turned.T + [3.0, 4.0], moved[finite], rtol=0, atol=1e-10)
        in_fence = body.scene.to_fence(in_body[finite], "point")
        assert np.allclose(
            flush.scene.to_object(in_fence, "point"), moved[finite], rtol=0, atol=1e-10
        )


def test_refused():
    both = (*SCENES["square"].effects, *SCENES["viscous"].effects)
    with pytest.raises(pp.InvalidValue, match="ask stable"):
        pp.stable_centers(Flush(effects=both).scene)
    scene = SCENES["square"].scene
    with pytest.raises(pp.InvalidValue, match="scene_at"):
        pp.stable_centers(replace(scene, slider=replace(scene.slider, flush=False)))
    region = pp.stable_centers(scene)
    for center, sense, words in [
        ((0, 1, 2), LEFT, "center"),
        ((0, np.inf), LEFT, "center"),
        ((0, 1), "left", "sense"),
    ]:
        with pytest.raises(pp.InvalidValue, match=words):
            region.contains(center, sense)


def test_equal_and_printed():
    region = pp.stable_centers(SCENES["square"].scene)
    assert (
        region
        == pp.stable_centers(SCENES["square"].scene)
        != pp.stable_centers(SCENES["ring"].scene)
    )
