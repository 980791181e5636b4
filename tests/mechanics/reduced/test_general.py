"""Any support: against the isotropic route, published numbers, and the conditions of each mode."""

from __future__ import annotations

import numba
import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.mechanics.plane import direction

SCENES = 20 if numba.config.DISABLE_JIT else 300
RANDOM = np.random.default_rng(14)
#: A ring that takes the general route.
RING = pp.Composite([(1.0, pp.Ring(1.0))])
TRIANGLE = np.array([direction(angle) for angle in (0, 2 * np.pi / 3, 4 * np.pi / 3)])
TRIPOD = pp.Points(TRIANGLE, [1 / 3] * 3)
SQUARE = pp.Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)])
L_SHAPE = pp.Polygon([(0, 0), (2, 0), (2, 1), (1, 1), (1, 3), (0, 3)])
GALLERY = {
    "tripod": TRIPOD,
    "square": SQUARE,
    "L": L_SHAPE,
    "segment across": pp.Segment((0, -1), (0, 1)),
    "disc off centre": pp.Disc(1.0, center=(0.3, -0.2)),
    "annulus": pp.Annulus(0.5, 1.0),
    "mixture": pp.Composite([(0.5, SQUARE), (0.3, TRIPOD), (0.2, pp.Ring(1.0))]),
}
MASS = pp.Inertia(mass=1.3, gyration_radius=0.8, center=(0.2, -0.3))


def scene(support, length=2.0, psi=np.pi / 2, contact=None, masses=(), radius=1.0):
    slider = pp.Slider(rod_length=length, rod_angle=psi, radius=radius)
    effects = (pp.SupportFriction(support=support), *masses)
    return pp.Scene(slider=slider, contact=contact or pp.PerfectlyRough(), effects=effects)


@pytest.mark.parametrize("masses", [(), (pp.Inertia(mass=0.7, gyration_radius=1.6),)])
@pytest.mark.parametrize("law", [pp.Coulomb(0.6), pp.InfiniteFriction(), pp.PerfectlyRough()])
def test_general_and_isotropic_route_agree(law, masses):
    length, psi = 10 ** RANDOM.uniform(-1, 1, SCENES), RANDOM.uniform(0.1, 3, SCENES)
    slider = pp.Slider(rod_length=length, rod_angle=psi, radius=1.0)
    push, size = RANDOM.uniform(-np.pi, np.pi, SCENES), 10 ** RANDOM.uniform(-2, 2, SCENES)
    found = []
    for friction in (pp.RingFriction(), pp.SupportFriction(support=RING)):
        each = pp.Scene(slider=slider, contact=law, effects=(friction, *masses))
        found.append(pp.solve(each, push, size))
    one, other = found
    assert np.array_equal(one.mode, other.mode)
    for name in ("force", "twist", "contact_motion"):
        mine, reference = getattr(other, name), getattr(one, name)
        error = np.linalg.norm(mine - reference, axis=-1)[one.consistent]
        assert np.all(error <= 1e-11 * np.linalg.norm(reference, axis=-1)[one.consistent])
    assert np.all(other.pivot == -1)


@pytest.mark.parametrize("share", [None, 0.0, 0.3, 0.9, 1.0])
def test_curves_and_cones_agree_with_the_isotropic_route(share):
    masses = () if share is None else (pp.Inertia(mass=0.7, gyration_radius=1.6),)
    phi = np.linspace(-3, 3, 25)
    ring = pp.Scene(
        slider=pp.Slider(rod_length=1.7, rod_angle=0.8, radius=1.0), contact=pp.Coulomb(0.7),
        effects=(pp.RingFriction(), *masses),
    )  # fmt: skip
    other = scene(RING, 1.7, 0.8, pp.Coulomb(0.7), masses)
    inner = np.clip(share, 1e-6, 1 - 1e-6) if share is not None else None
    assert np.allclose(
        pp.motion_angle(other, phi, inner), pp.motion_angle(ring, phi, inner), rtol=0, atol=1e-12
    )
    one, two = pp.limit_curve(ring, phi), pp.limit_curve(other, phi)
    assert np.allclose(two.magnitude, one.magnitude, rtol=1e-12, atol=0)
    assert np.allclose(two.motion_angle, one.motion_angle, rtol=0, atol=1e-12)
    assert np.isclose(pp.motion_cone(other).left, pp.motion_cone(ring).left, rtol=0, atol=1e-12)


@pytest.mark.parametrize(
    ("support", "distances"),
    [
        (pp.Disc(1.0), (2.5820217533, 1.1927516849, 0.8269565546, 0.5471102677)),
        (RING, (5.0742673043, 2.1772547559, 1.3141186285, 1.0)),
        (SQUARE, (3.4805719766, 1.6035437776, 1.0015655201, 0.6766826421)),
    ],
    ids=["disc", "ring", "square"],
)
def test_published_centres_of_rotation(support, distances):
    for offset, distance in zip((0.1, 0.25, 0.5, 1.0), distances, strict=True):
        center = pp.motion_centers(scene(support, offset), 0.0, origin="ring-center")
        assert np.hypot(*center) == pytest.approx(distance, abs=2e-10)


@pytest.mark.parametrize(
    ("mu", "edge"), [(0.2, 0.7401183583), (0.5, 1.0591831566), (1.0, 1.2552928238)]
)
def test_published_motion_cone_of_a_disc(mu, edge):
    cone = pp.motion_cone(scene(pp.Disc(1.0), 1.0, contact=pp.Coulomb(mu)))
    assert cone.left - np.pi / 2 == pytest.approx(edge, abs=2e-10)
    assert np.pi / 2 - cone.right == pytest.approx(edge, abs=2e-10)


def test_a_tripod_pivots_for_offsets_between_the_published_ends():
    ends = np.array([2 - np.sqrt(3), 2 + np.sqrt(3)])
    shift = np.array([1e-9, -1e-9])
    within, beyond = ends + shift, ends - shift
    for offset in [*within, 0.5, 1.0, 2.0]:
        center = pp.motion_centers(scene(TRIPOD, offset), 0.0, origin="ring-center")
        assert np.abs(center - [0.0, 1.0]).max() <= 2e-15
    for offset in beyond:
        center = pp.motion_centers(scene(TRIPOD, offset), 0.0, origin="ring-center")
        assert np.abs(center - [0.0, 1.0]).max() > 1e-11


def test_a_pivot_belongs_to_an_interval_of_forces():
    pushes = pp.solve(scene(TRIPOD), 0.0)
    (stick,) = [each for each in pushes if each.mode == pp.ContactMode.STICK]
    assert stick.pivot == 0
    assert np.allclose(stick.center, [0.0, 3.0])
    one, other = (np.arctan2(*force[::-1]) for force in (stick.force, stick.force_end))
    inside = np.linspace(one, other, 9)[1:-1]
    assert np.allclose(pp.motion_angle(scene(TRIPOD), inside), 0.0, atol=1e-12)
    outside = np.array([one - 1e-3, other + 1e-3])
    assert np.all(np.abs(pp.motion_angle(scene(TRIPOD), outside)) > 1e-5)


def test_a_pivot_keeps_to_the_forces_of_the_law():
    (stick,) = [
        each for each in pp.solve(scene(TRIPOD, contact=pp.Coulomb(2.0)), 0.0)
        if each.mode == pp.ContactMode.STICK
    ]  # fmt: skip
    for force in (stick.force, stick.force_end):
        assert force[1] >= 0
        assert abs(force[0]) <= 2.0 * force[1] * (1 + 1e-12)


def check(each, push, size, found):
    """Motion, wrench and force of every solution meet their mode."""
    length, psi = each.slider.rod_length, each.slider.rod_angle
    x, y = direction(psi)
    for i in np.ndindex(found.mode.shape):
        mode = found.mode[i]
        if mode <= pp.ContactMode.SEPARATE:
            continue
        pusher = size[i[0]] * direction(push[i[0]])
        twist, force, motion = found.twist[i], found.force[i], found.contact_motion[i]
        scale = np.hypot(*twist[:2]) + length * abs(twist[2])
        gap = motion - pusher
        assert abs(gap[1]) <= 1e-11 * scale
        assert abs(gap[0]) <= 1e-11 * scale or mode != pp.ContactMode.STICK
        assert (mode == pp.ContactMode.SLIP_RIGHT) == (gap[0] > 1e-13 * scale)
        if found.pivot[i] >= 0:
            continue
        body = np.array([twist[0] * x + twist[1] * y, twist[1] * x - twist[0] * y, twist[2]])
        needed = sum(pp.wrench(effect, body, each.slider) for effect in each.effects)
        own = np.array([force[0] * x + force[1] * y, force[1] * x - force[0] * y])
        assert np.abs(needed[:2] - own).max() <= 1e-10 * np.hypot(*force)
        assert abs(needed[2] + length * own[1]) <= 1e-10 * (1 + length) * np.hypot(*force)


@pytest.mark.parametrize("masses", [(), (MASS,)], ids=["friction", "both"])
@pytest.mark.parametrize("support", GALLERY.values(), ids=GALLERY)
def test_every_solution_meets_its_mode(support, masses):
    for _ in range(3):
        length, psi = 10 ** RANDOM.uniform(-0.5, 0.7), RANDOM.uniform(0.2, 2.9)
        each = scene(support, length, psi, pp.Coulomb(10 ** RANDOM.uniform(-1, 1)), masses)
        push = RANDOM.uniform(-np.pi, np.pi, SCENES // 3)
        size = 10 ** RANDOM.uniform(-1, 1, push.size)
        check(each, push, size, pp.solve(each, push, size))


@pytest.mark.parametrize("support", GALLERY.values(), ids=GALLERY)
def test_the_map_from_force_to_motion_increases_and_takes_work(support):
    phi = np.linspace(-np.pi, np.pi, 181)
    theta = pp.motion_angle(scene(support, 1.3, 1.0), phi)
    assert np.all(np.diff(theta) >= -1e-9)
    assert np.all(np.abs(theta - phi) <= np.pi / 2 + 1e-9)


def test_arrays_of_supports():
    corners = [[(-1, -1), (1 + d, -1), (1, 1), (-1, 1 + d)] for d in (0.0, 0.3, 0.7)]
    supports = [pp.Polygon(each) for each in corners]
    stacked = np.array([*supports, None], dtype=object)[:-1]
    slider = pp.Slider(rod_length=2.0, rod_angle=1.0)
    together = pp.Scene(
        slider=slider, contact=pp.Coulomb(0.5), effects=(pp.SupportFriction(support=stacked),)
    )
    cone = pp.motion_cone(together)
    for i, support in enumerate(supports):
        one = pp.Scene(
            slider=slider, contact=pp.Coulomb(0.5), effects=(pp.SupportFriction(support=support),)
        )
        assert cone.left[i] == pp.motion_cone(one).left


def test_two_general_supports_are_refused_with_a_remedy():
    with pytest.raises(pp.InvalidValue, match="Composite"):
        pp.Scene(
            slider=pp.Slider(rod_length=2.0, rod_angle=1.0), contact=pp.Coulomb(0.5),
            effects=(pp.SupportFriction(support=SQUARE), pp.RingFriction()),
        )  # fmt: skip


@pytest.mark.parametrize("law", [pp.Coulomb(0.5), pp.InfiniteFriction()])
def test_a_centre_of_mass_far_from_the_support_is_inertias_own(law):
    """Without friction the motion is that of a free body pushed off its centre of mass."""
    mass = pp.Inertia(mass=2.0, gyration_radius=0.7, center=(0.4, 0.3))
    each = pp.Scene(slider=pp.Slider(rod_length=2.0, rod_angle=1.1), contact=law, effects=(mass,))
    (stick,) = [s for s in pp.solve(each, 1.4) if s.mode == pp.ContactMode.STICK]
    x, y = direction(1.1)
    arm = np.array([2.4 * x - 0.3 * y, 2.4 * y + 0.3 * x])  # from the contact to the centre of mass
    spin = stick.twist[2]
    acceleration = stick.contact_motion + spin * np.array([-arm[1], arm[0]])
    assert np.allclose(2.0 * acceleration, stick.force, rtol=1e-12)
    torque = -arm[0] * stick.force[1] + arm[1] * stick.force[0]
    assert torque == pytest.approx(2.0 * 0.49 * spin, rel=1e-11)
