"""Any support against other routes: one number for round supports, sums over points, limits, section 7."""

from __future__ import annotations

import numba
import numpy as np
import pytest
from scipy.optimize import brentq, minimize

import planar_pushing as pp
from mechanics.supports.cases import SUPPORTS, regular
from mechanics.supports.quadrature import sampled
from planar_pushing.mechanics.supports.moments import moments
from planar_pushing.mechanics.supports.pressure.assembly import assembled

ROUND = {
    "disc": pp.Disc(1.0),
    "annulus": pp.Annulus(0.5, 1.0),
    "thin annulus": pp.Annulus(0.9, 1.0),
    "ring": pp.Composite([(1.0, pp.Ring(1.0))]),
    "bullseye": pp.Composite([(0.3, pp.Disc(0.4)), (0.7, pp.Annulus(0.6, 1.0))]),
}
#: A fit takes seconds without the compiler: there each kind of pressure, polygons in the composite.
PLAIN = ("points", "segment", "ring", "disc", "annulus", "composite")
FITTED = PLAIN if numba.config.DISABLE_JIT else tuple(SUPPORTS)


def scene(support, length, psi=np.pi / 2, contact=None):
    slider = pp.Slider(rod_length=length, rod_angle=psi, radius=1.0)
    effects = (pp.SupportFriction(support=support),)
    return pp.Scene(slider=slider, contact=contact or pp.PerfectlyRough(), effects=effects)


def along_force(support, arm):
    """Distance of the centre of rotation and size of the force, from the moment arm T / |G| alone."""
    record = assembled(support.pieces(), 1.0)

    def gap(c):
        found = moments(record, c, 0.0)
        return found.torque - arm * abs(found.unit_x)

    c = brentq(gap, 1e-9, 1e6, xtol=1e-15)
    return c, abs(moments(record, c, 0.0).unit_x)


@pytest.mark.parametrize("turn", [0.2, 0.8, 1.5, -0.6, 2.4])
@pytest.mark.parametrize("length", [0.3, 1.0, 4.0])
@pytest.mark.parametrize("support", ROUND.values(), ids=ROUND)
def test_round_supports_follow_from_one_number(support, length, turn):
    """Moment arm <-> spin ratio, which the ring's route is made of."""
    psi = 0.9
    phi = psi - turn
    arm = length * np.sin(turn)
    c, size = along_force(support, abs(arm))
    spin = np.sign(arm) / c
    motion = (
        np.cos(phi) + spin * length * np.sin(psi),
        np.sin(phi) - spin * length * np.cos(psi),
    )
    found = pp.limit_curve(scene(support, length, psi), phi)
    assert found.magnitude == pytest.approx(size, rel=1e-10)
    assert found.spin_ratio == pytest.approx(spin, rel=1e-9)
    off = found.motion_angle - np.arctan2(*motion[::-1])
    assert np.sin(off) == pytest.approx(0, abs=1e-10)


@pytest.mark.parametrize(
    "support", [*ROUND.values(), SUPPORTS["square"][0]], ids=[*ROUND, "square"]
)
def test_the_cone_of_a_symmetric_support_along_the_normal_is_the_half_turn(support):
    """Infinite friction puts the edges of its motion cone at right angles from the normal (section 7)."""
    cone = pp.motion_cone(scene(support, 1.0, contact=pp.InfiniteFriction()))
    assert cone.left - np.pi / 2 == pytest.approx(np.pi / 2, abs=1e-10)
    assert np.pi / 2 - cone.right == pytest.approx(np.pi / 2, abs=1e-10)


@pytest.mark.parametrize("turn", [-0.15, 0.1, 0.2])
@pytest.mark.parametrize("name", SUPPORTS)
def test_sticking_is_the_least_power_of_points(name, turn):
    """Psi by direct search, its slope by the sum of the points' friction; centres away from the support."""
    support, _ = SUPPORTS[name]
    length, psi = 6.0, 1.1
    places, shares = sampled(support)
    arms = places + np.array([length, 0.0])
    u = np.array([np.cos(turn), np.sin(turn)])

    def slides(spin):
        return np.column_stack([u[0] - spin * arms[:, 1], u[1] + spin * arms[:, 0]])

    def torque(spin):
        moves = slides(spin)
        across = arms[:, 0] * moves[:, 1] - arms[:, 1] * moves[:, 0]
        return shares @ (across / np.hypot(*moves.T))

    spin = brentq(torque, -1.0, 1.0, xtol=1e-15)
    assert minimize(
        lambda w: shares @ np.hypot(*slides(w[0]).T), [0.0], tol=1e-10
    ).x == pytest.approx([spin], abs=1e-4)
    moves = slides(spin)
    force = shares @ (moves / np.hypot(*moves.T)[:, None])
    (stick,) = [
        each for each in pp.solve(scene(support, length, psi), psi + turn)
        if each.mode is pp.ContactMode.STICK
    ]  # fmt: skip
    body = np.array([[np.cos(psi), np.sin(psi)], [-np.sin(psi), np.cos(psi)]]) @ stick.force
    assert stick.twist[2] == pytest.approx(spin, abs=1e-10)
    assert body == pytest.approx(force, abs=1e-10)


def order(make, limit, counts, length, phi):
    """Order at which the limit curve of a series of supports approaches another."""
    exact = pp.limit_curve(scene(limit, length), phi).magnitude
    gaps = [abs(pp.limit_curve(scene(make(n), length), phi).magnitude - exact) for n in counts]
    return np.log(gaps[0] / gaps[1]) / np.log(counts[1] / counts[0])


@pytest.mark.parametrize("length", [0.4, 2.0])
def test_polygons_move_like_the_disc_at_second_order(length):
    found = order(lambda n: pp.Polygon(regular(n)), pp.Disc(1.0), (40, 80), length, 0.5)
    assert found == pytest.approx(2, abs=0.05)


def test_points_move_like_the_ring_at_the_rate_of_the_centre_off_it():
    """As the power of the spin ratio that is their number, for a centre in line with a point."""
    exact = pp.limit_curve(scene(ROUND["ring"], 0.3), 0.0)
    gaps = [
        abs(pp.limit_curve(scene(pp.Points(regular(n), np.ones(n)), 0.3), 0.0).magnitude - exact.magnitude)
        for n in (16, 24)
    ]  # fmt: skip
    assert abs(exact.spin_ratio) < 0.7
    assert np.log(gaps[1] / gaps[0]) / np.log(abs(exact.spin_ratio)) == pytest.approx(8, rel=0.2)


@pytest.mark.parametrize("name", FITTED)
def test_far_from_the_contact_a_support_is_a_point(name):
    """Only a force along the rod moves it: the curve is a line whose width falls as one over the length."""
    support, _ = SUPPORTS[name]
    widths = []
    for length in (1e2, 1e4):
        across = pp.limit_curve(scene(support, length * support.extent), 0.0).magnitude
        widths.append(length * across)
        assert 0 < widths[-1] < 1.2
        along = pp.limit_curve(scene(support, length * support.extent), np.pi / 2).magnitude
        assert along < 1 + 1e-12
    constant = pp.fit_ellipsoid(support).integration_constant
    assert widths[1] == pytest.approx(widths[0], rel=0.05)
    assert widths[1] <= constant * (1 + 1e-3)
