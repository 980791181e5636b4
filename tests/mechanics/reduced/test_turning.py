"""Completeness: an independent scan over the magnitude finds no slip that `solve` misses."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.special import ellipe, ellipkm1, hyp2f1

import planar_pushing as pp
from mechanics.builders import make_scene
from mechanics.strategies import powers, rod_angles

FEW = settings(max_examples=30)


def friction_profile(k):
    """f and t of Eqs. (2)-(3) for k > 0, straight from their elliptic forms."""
    inner = np.minimum(k, 1 / k)
    force = 2 / np.pi * ellipe(inner**2)
    rest = np.maximum((1 - inner) * (1 + inner), 1e-300)
    exact = 2 / np.pi * (ellipe(inner**2) - rest * ellipkm1(rest)) / inner
    torque = np.where(inner < 0.1, inner / 2 * hyp2f1(0.5, 0.5, 2, inner**2), exact)
    return np.where(k <= 1, force, torque), np.where(k <= 1, torque, force)


class Scan:
    """Motions under a force on one edge, by brute force over the magnitude of the motion."""

    def __init__(self, length, psi, phi, rho):
        self.s = np.logspace(-6, 6, 2001)  # m a / W
        arm = length * np.sin(psi - phi)
        low, high = np.full_like(self.s, 1e-7), np.full_like(self.s, 1e7)
        for _ in range(50):
            k = np.sqrt(low * high)
            force, torque = friction_profile(k)
            below = torque + self.s * rho**2 * k < abs(arm) * (force + self.s)
            low, high = np.where(below, k, low), np.where(below, high, k)
        k = np.sign(arm) * np.sqrt(low * high)
        self.across = self.s * (np.sin(phi) - k * length * np.cos(psi))
        self.along = self.s * (np.cos(phi) + k * length * np.sin(psi))

    def crossings(self, level):
        """Indices before which n . u crosses a level."""
        side = np.sign(self.across - level)
        return np.nonzero(side[1:] * side[:-1] < 0)[0]

    def is_clear_of(self, level):
        """Whether the level is neither an extremum's nor out of the scan's reach."""
        rise = np.sign(np.diff(self.across))
        extrema = self.across[1:-1][rise[1:] != rise[:-1]]
        settled = abs(self.across[-1]) > 100 * abs(level) > 1e4 * abs(self.across[0])
        return settled and np.all(np.abs(extrema - level) > 1e-3 * abs(level))


def slip_count(scene, pusher, mode):
    found = pp.solve(scene, np.arctan2(*pusher[::-1]), np.hypot(*pusher))
    return sum(each is mode for each in found.modes)


def check_against_scan(length, psi, mu, weight, mass, rho, rightward, index, offset):
    """Aim the pusher at a motion of the scan; every crossing of its level must be found."""
    effects = pp.RingFriction(weight=weight), pp.Inertia(mass=mass, gyration_radius=rho)
    scene = make_scene(length, mu, effects, psi)
    cone = pp.friction_cone(scene)
    phi = cone.left if rightward else cone.right
    scan = Scan(length, psi, phi, rho)
    level = (scan.across[index] + scan.across[index + 1]) / 2
    assume(scan.is_clear_of(level))
    along = scan.along[scan.crossings(level)]
    sign = 1 if rightward else -1
    limit = along[offset % along.size] - sign * 0.02 * (abs(along).max() + abs(level))
    expected = int(np.sum(sign * (along - limit) > 0))
    assume(np.abs(along - limit).min() > 0.01 * (abs(along).max() + abs(level)))
    mode = pp.ContactMode.SLIP_RIGHT if rightward else pp.ContactMode.SLIP_LEFT
    pusher = weight / mass * np.array([limit, level])
    assert slip_count(scene, pusher, mode) == expected
    return expected


@FEW
@given(
    powers(-0.5, 1), rod_angles, st.one_of(st.just(np.inf), powers(-1, 2)), powers(-1, 1),
    powers(-1, 1), powers(-0.7, 0.7), st.booleans(), st.integers(400, 1600), st.integers(0, 2),
)  # fmt: skip
def test_scan_finds_no_slip_that_solve_misses(
    length, psi, mu, weight, mass, rho, rightward, index, offset
):
    assume(abs(length * np.sin(psi - np.pi / 2)) > 1e-3)
    check_against_scan(length, psi, mu, weight, mass, rho, rightward, index, offset)


@FEW
@given(
    powers(-0.3, 1), st.floats(0.2, 1.3), st.floats(0.05, 0.9), st.floats(-0.8, 3), powers(-1, 1),
    powers(-1, 1), st.booleans(), st.integers(400, 1600), st.integers(0, 2),
)  # fmt: skip
def test_scan_finds_no_slip_that_solve_misses_where_the_normal_motion_turns(
    length, psi, lean, beyond, weight, mass, mirrored, index, offset
):
    """rho puts the inertia end and the friction end on two sides of n . u = 0 (Painleve)."""
    phi = lean * psi
    slow = pp.spin_ratio(make_scene(length, 1.0, psi=psi), phi)
    along_fence = np.sin(phi) / (length * np.cos(psi))
    fast = along_fence + beyond * (along_fence - slow)
    assume(0.02 < fast / slow < 50)
    assume(abs(fast / along_fence - 1) > 1e-2)
    assume(abs(slow / along_fence - 1) > 1e-2)
    rho = float(np.sqrt(length * np.sin(psi - phi) / fast))
    rod = np.pi - psi if mirrored else psi
    check_against_scan(length, rod, 1 / np.tan(phi), weight, mass, rho, mirrored, index, offset)


def test_scan_sees_the_two_slips_of_the_published_example():
    """l = 2, mu = 1.4: the oracle itself is no worse than the table."""
    scan = Scan(2.0, np.pi / 4, np.pi / 2 - np.arctan(1.4), 1.0)
    assert scan.across.min() == pytest.approx(-0.0400296, abs=1e-6)
    assert scan.crossings(-0.03).size == 2
    assert scan.crossings(0.01).size == 1


def test_four_slips_while_the_motion_centre_crosses_the_ring():
    """Next to k = 1 the torque of friction changes fast enough for n . u to turn twice within 5e-5."""
    length, psi, phi, rho = (
        0.5130212627321971,
        2.1793295774327346,
        2.813831984976355,
        0.19392821393963708,
    )
    target, k = 0.0476228, np.array([0.54, 0.85, 1 - 2.3e-5, 1 + 2.3e-5, 8.0])
    arm, (force, torque) = abs(length * np.sin(psi - phi)), friction_profile(k)
    speed = (torque - arm * force) / (arm - rho**2 * k)
    above = speed * (np.sin(phi) + k * length * np.cos(psi)) > target
    assert above.tolist() == [False, True, False, True, False]
    effects = pp.RingFriction(), pp.Inertia(gyration_radius=rho)
    scene = make_scene(length, -1 / np.tan(phi), effects, psi)
    assert slip_count(scene, np.array([-10.0, target]), pp.ContactMode.SLIP_RIGHT) == 4
