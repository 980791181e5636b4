"""Slips of any support with friction and inertia: against the ring's route, and against all magnitudes."""

from collections import namedtuple

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.mechanics.effects.base import COLUMNS, made
from planar_pushing.mechanics.plane import rod, toward
from planar_pushing.mechanics.reduced.base import MOTION, slips
from planar_pushing.mechanics.reduced.pressed.motions import Amount, contact_of, motion_of

Twist = namedtuple("Twist", "v_x v_y spin")
#: The normal motion of the contact falls to this over the size of the force, and rises again.
LEAST = -0.0400296
RING = pp.Composite([(1.0, pp.Ring(1.0))])


def found(support, part):
    """Slips under the right edge of mu = 1.4, at a part of the least normal motion."""
    slider = pp.Slider(rod_length=2.0, rod_angle=np.pi / 4, radius=1.0)
    effects = (pp.SupportFriction(support=support), pp.Inertia())
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(1.4), effects=effects)
    row = np.zeros(COLUMNS)
    row[:7] = scene.weight, *scene.inertia, *scene.placement
    own, motions = rod(2.0, np.pi / 4), np.empty((8, MOTION))
    edge = toward(own, np.arctan2(1.0, 1.4))
    count = slips(made(scene.kinds, row), own, edge, part * LEAST, np.inf, motions)
    return motions[:count]


@pytest.mark.parametrize("part", [0.5, 0.9, 0.99, 0.999, 1 - 1e-4, 1 - 1e-5])
def test_both_slips_of_a_pair_are_found_near_its_birth(part):
    """Two nodes of the search are further apart than the slips are."""
    general, ring = found(RING, part), found(pp.Ring(), part)
    assert len(ring) == len(general) == 2
    near = 1e-11 / np.sqrt(1 - part)
    assert general[:, :5] == pytest.approx(ring[:, :5], rel=near)
    assert np.hypot(*general[0, 3:5]) < 1.40897 < np.hypot(*general[1, 3:5])


def test_before_its_birth_there_is_no_pair():
    assert len(found(RING, 1 + 1e-5)) == len(found(pp.Ring(), 1 + 1e-5)) == 0


COUNT = 300


def solved(support, least, most):
    """Solutions of random pushes, half of them pulls, some of which have two slips."""
    rng = np.random.default_rng(3)
    slider = pp.Slider(
        rod_length=np.exp(rng.uniform(np.log(least), np.log(most), COUNT)),
        rod_angle=rng.uniform(0.75, 0.82, COUNT), radius=1.0,
    )  # fmt: skip
    contact = pp.Coulomb(rng.uniform(1.3, 1.5, COUNT))
    effects = (pp.SupportFriction(support=support), pp.Inertia())
    scene = pp.Scene(slider=slider, contact=contact, effects=effects)
    pull = np.arange(COUNT) < COUNT // 2
    angle = np.where(pull, rng.uniform(-0.04, 0.0, COUNT), rng.uniform(-np.pi, np.pi, COUNT))
    return pp.solve(scene, angle, np.where(pull, 1.5, 10 ** rng.uniform(-2, 1, COUNT)))


def test_all_solutions_of_random_pushes_are_those_of_the_rings_route():
    """The ring's route looks at bounds of cells, and leaves none out."""
    general, ring = solved(RING, 1.9, 2.1), solved(pp.Ring(), 1.9, 2.1)
    assert np.array_equal(general.mode, ring.mode)
    twice = (ring.mode[:, 1:] == ring.mode[:, :-1]) & (ring.mode[:, 1:] > pp.ContactMode.STICK)
    assert np.count_nonzero(twice.any(axis=1)) > 10  # pairs of slips are among them
    np.testing.assert_allclose(general.force, ring.force, rtol=1e-8, atol=1e-12)


def test_slips_without_friction_are_those_of_the_rings_route():
    """The normal part of the pusher's motion then says which slip it is; there is none in a pull."""
    angle = np.deg2rad([-150.0, -60.0, 30.0, 60.0, 100.0, 160.0])
    general, ring = (
        pp.solve(
            pp.Scene(
                slider=pp.Slider(rod_length=2.0, rod_angle=np.pi / 4, radius=1.0),
                contact=pp.Coulomb(0.0),
                effects=(pp.SupportFriction(support=support), pp.Inertia()),
            ),
            angle,
        )
        for support in (RING, pp.Ring())
    )
    assert np.array_equal(general.mode, ring.mode)
    assert set(ring.mode[angle < 0].ravel()) == {pp.ContactMode.SEPARATE, -1}
    assert {pp.ContactMode.SLIP_RIGHT, pp.ContactMode.SLIP_LEFT} <= set(
        ring.mode[angle > 0].ravel()
    )
    np.testing.assert_allclose(general.twist, ring.twist, rtol=1e-12, atol=1e-14)
    np.testing.assert_allclose(general.force, ring.force, rtol=1e-12, atol=1e-14)


def test_slips_of_long_rods_are_those_of_the_rings_route():
    """A rounding of the inputs moves their small forces by the square of the length."""
    length = 1e5
    general, ring = solved(RING, 1e3, length), solved(pp.Ring(), 1e3, length)
    assert np.array_equal(general.mode, ring.mode)
    size, off = (np.linalg.norm(f, axis=-1) for f in (ring.force, general.force - ring.force))
    assert np.nanmax(off - length**2 * np.finfo(float).eps * size) <= 0


@pytest.mark.parametrize(
    "support", [pp.Segment((0, -1), (0.3, 1)), pp.Polygon([(1, 0), (-1, 1), (-1, -1)])]
)
def test_a_long_rod_is_pushed_and_never_pulled(support):
    """The centre of rotation is next to the support's centre, where a line's friction is steep."""
    found = solved(support, 1e3, 1e5)
    slips = found.mode > pp.ContactMode.STICK
    assert (found.force[slips][:, 1] > 0).all()
    assert slips.any()


def scanned(effects, own, edge, normal):
    """How often the contact's normal motion passes a value, over magnitudes close to one another."""
    amount = Amount(effects, own, edge)
    rises = [contact_of(own, motion_of(amount, z))[1] - normal for z in np.linspace(-9, 9, 400)]
    return int(np.count_nonzero(np.diff(np.sign(rises))))


@pytest.mark.parametrize("seed", range(12))
def test_slips_of_points_are_as_many_as_magnitudes_show(seed):
    """Where the slider may pivot as it slips, the force across the edge has steps."""
    rng = np.random.default_rng(seed)
    support = pp.Points(rng.normal(size=(3, 2)), rng.uniform(0.2, 1.0, 3))
    scene = pp.Scene(
        slider=pp.Slider(rod_length=rng.uniform(0.3, 3.0), rod_angle=0.9, radius=1.0),
        contact=pp.Coulomb(1.0), effects=(pp.SupportFriction(support=support), pp.Inertia()),
    )  # fmt: skip
    row = np.zeros(COLUMNS)
    row[:7] = scene.weight, *scene.inertia, *scene.placement
    effects, own, motions = (
        made(scene.kinds, row),
        rod(scene.slider.rod_length, 0.9),
        np.empty((8, MOTION)),
    )
    for angle in rng.uniform(0.1, 3.0, 6):
        edge = toward(own, angle)
        for normal in 10 ** rng.uniform(-2, 1, 2) * [1, -1]:
            count = slips(effects, own, edge, normal, np.copysign(np.inf, edge.x), motions)
            assert count == scanned(effects, own, edge, normal)
            for v_x, v_y, spin, f_x, f_y, *_ in motions[:count]:
                _, rise = contact_of(own, Twist(v_x, v_y, spin))
                assert rise == pytest.approx(normal, rel=1e-12, abs=0)
                assert np.sin(np.arctan2(f_y, f_x) - angle) == pytest.approx(0, abs=1e-14)
