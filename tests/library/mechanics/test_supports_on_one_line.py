"""Supports on one line through the contact, pushed across it, and across the normal without friction.

The torque about the contact is a step function of the rotation, ``sum p x sgn(1 + omega x)`` for shares p
at x from the contact. It is evaluated here in plain Python, and the limit of pushes aside with more digits.
"""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import mpmath
import numpy as np
import pytest
import xarray
from mechanics.builders import names
from mechanics.checked import UPRIGHT, scene_of, solved
from mechanics.supports.exact import about

import planar_pushing as pp

ROUGH = pp.PerfectlyRough()
#: Places from the contact and loads.
BARS = {
    "one side": ([1.0, 2.0, 3.0], [1, 1, 1]),
    "other side": ([-1.0, -2.0, -3.0], [2, 2, 2]),
    "three": ([-0.91, 0.28, 0.63], [1, 1, 1]),
    "two, loads 1:2": ([-2 / 3, 4 / 3], [2, 1]),
    "two": ([-1.0, 1.0], [1, 1]),
    "a foot at the contact": ([-1.0, 0.0, 1.0], [1, 2, 1]),
    "a light foot": ([1, 2, 4], [4 + 2.0**-29, 2.0**-30, 1]),  # the limit is next to an end
    "five": ([-2.0, -1.0, 0.5, 1.0, 1.5], [1, 1, 2, 1, 2 / 3]),
}


def random_bars(count):
    """Places with the center of pressure at the contact, to rounding."""
    random = np.random.default_rng(21)
    for _ in range(count):
        places, loads = random.uniform(-1, 1, (2, random.integers(2, 6)))
        loads = abs(loads) + 0.1
        yield list(places - np.average(places, weights=loads)), list(loads)


def torque(places, loads, omega):
    """Torque about the contact, which moves across by 1."""
    return sum(p * x * math.copysign(1, 1 + omega * x) for x, p in zip(places, loads, strict=True))


def interval(places, loads):
    """The rotations without a torque; each end is a rotation about a place."""
    ends = sorted(-1 / x for x in places if abs(x) > 1e-12)
    gross = sum(abs(p * x) for x, p in zip(places, loads, strict=True))
    found = [
        (low, high) for low, high in pairwise(ends)
        if abs(torque(places, loads, (low + high) / 2)) < 1e-14 * gross
    ]  # fmt: skip
    assert len(found) == 1
    return found[0]


def limit(places, loads):
    """The root of ``sum p x s / (1 + omega x)^2`` in the interval, by bisection."""
    low, high = interval(places, loads)
    for _ in range(80):
        middle = (low + high) / 2
        terms = [
            p * x * math.copysign(1, 1 + middle * x) / (1 + middle * x) ** 2
            for x, p in zip(places, loads, strict=True)
        ]
        low, high = (middle, high) if sum(terms) > 0 else (low, middle)
    return low


def bar(places, loads, psi, law, *, beside=()):
    """A bar along the rod, which begins at the contact; its center of pressure need not be the origin."""
    feet = [(x - 2.0, y) for x, y in zip(places, beside or [0.0] * len(places), strict=True)]
    return scene_of(pp.Points(feet, loads), 2.0, psi, law)


def rounding(places):
    """Rounding error of a rotation, as the contact is at a distance of 2 from the origin of the places."""
    size = max(map(abs, places))
    return 1e-15 * (2 + size) / size**2


def assert_continuum(found, omega, blur=1e-14):
    assert found.status is pp.Status.CONTINUUM
    assert found.outcome is pp.Outcome.AMBIGUOUS
    assert found[-1].continuum
    assert found[-1].pivot == -1
    assert found[-1].twist[2] == pytest.approx(omega, rel=1e-12, abs=blur)


CASES = [*BARS.values(), *random_bars(20)]


@pytest.mark.parametrize(("places", "loads"), CASES)
def test_a_bar_pushed_across_has_an_interval_of_rotations(places, loads):
    low, high = interval(places, loads)
    omega = limit(places, loads)
    assert low < omega < high
    for psi in (math.pi / 4, UPRIGHT, 2.0, 0.3):
        scene = bar(places, loads, psi, ROUGH)
        found = solved(scene, psi + UPRIGHT)
        assert names(found)[-1] == "STICK"
        assert_continuum(found, omega, rounding(places))
        # The force of every rotation in the interval, by hand.
        size = sum(
            p * math.copysign(1, 1 + omega * x) for x, p in zip(places, loads, strict=True)
        ) / sum(loads)
        across = [-math.sin(psi), math.cos(psi)]
        assert found[-1].force == pytest.approx(np.multiply(size, across), abs=1e-14)


def test_the_literal_intervals_of_two_bars():
    assert interval([1, 2, 3], [1, 1, 1]) == pytest.approx((-1 / 2, -1 / 3))
    assert limit([1, 2, 3], [1, 1, 1]) == pytest.approx(-0.4072640, abs=5e-8)
    y = np.array([-0.6433333333333333, 0.2666666666666666, 0.3766666666666667])
    y -= y.mean()
    assert interval(-y, [1, 1, 1]) == pytest.approx((-1.554404, 2.654867), abs=5e-7)
    scene = scene_of(pp.Points([(0, each) for each in y], [1, 1, 1]), 0.0, UPRIGHT, pp.Coulomb(0.5))
    for angle in (UPRIGHT, np.float64(UPRIGHT), np.array([UPRIGHT])):
        found = pp.solve(scene, angle)
        assert_continuum(found if np.ndim(angle) == 0 else found[0], 0.0)


def test_one_push_of_an_array_has_a_continuum():
    scene = bar(*BARS["one side"], UPRIGHT, ROUGH)
    found = pp.solve(scene, np.array([2.0, math.pi, 3.0]))
    assert found.status.tolist() == [1, 3, 1]
    assert found.outcome.tolist() == [1, 2, 1]
    labeled = pp.solve(scene, xarray.DataArray([2.0, math.pi, 3.0], dims="push"))
    assert labeled.outcome.values.tolist() == [1, 2, 1]
    assert labeled.continuum.any("solution").values.tolist() == [False, True, False]


@pytest.mark.parametrize(("places", "loads"), CASES)
def test_a_force_across_a_bar_belongs_to_an_interval_of_rotations(places, loads):
    """A line of force does not determine the contact's sense; the bars that are pushed one way only."""
    omega = limit(places, loads)
    for psi in (math.pi / 4, UPRIGHT, 2.0):
        found = pp.motion_of_force(bar(places, loads, psi, ROUGH), psi + UPRIGHT)
        sense = found.contact_motion @ [-math.sin(psi), math.cos(psi)]
        assert abs(sense) == pytest.approx(1, abs=1e-14)
        assert found.status is pp.Status.CONTINUUM
        assert found.twist[2] == pytest.approx(sense * omega, rel=1e-12, abs=rounding(places))


def test_the_edges_of_a_motion_cone_across_a_bar():
    """The bar is on the fence, and the contact without friction: all of its forces are across the bar."""
    scene = bar([-0.5, 0.1, 0.4], [1, 1, 1], math.pi - 1e-9, pp.Coulomb(0.0))
    assert pp.motion_cone(scene).status == pp.Status.CONSISTENT
    feet = pp.Points([(0, y) for y in (-0.5, 0.1, 0.4)])
    scene = scene_of(feet, 0.0, UPRIGHT, pp.Coulomb(0.0))
    cone = pp.motion_cone(scene)
    assert cone.status == pp.Status.CONTINUUM
    assert [cone.right, cone.left] == pytest.approx([UPRIGHT, UPRIGHT])
    slip = solved(scene, 1.0)
    assert names(slip) == ["SLIP_LEFT"]
    assert_continuum(slip, 0.0)


# --- Beside the line -----------------------------------------------------------------------------


def exact_rotation(feet, loads, motion, near):
    """Root of the torque about a contact at the origin, in 50 digits."""
    with mpmath.workdps(50):
        u_x, u_y = map(mpmath.mpf, motion)

        def torque(omega):
            total = mpmath.mpf(0)
            for (x, y), load in zip(feet, loads, strict=True):
                v_x, v_y = u_x - omega * mpmath.mpf(y), u_y + omega * mpmath.mpf(x)
                total += load * (x * v_y - y * v_x) / mpmath.sqrt(v_x**2 + v_y**2)
            return total

        low, high = near
        return float(mpmath.findroot(torque, (low, high), solver="anderson", tol=1e-45))


@pytest.mark.parametrize("aside", [*10.0 ** np.arange(-13, -1), 0.3])
@pytest.mark.parametrize("name", ["one side", "other side", "three", "five"])
def test_a_push_aside_is_near_the_limit(name, aside):
    """Smoothly, where the torque itself is rounding error."""
    places, loads = BARS[name]
    scene = bar(places, loads, UPRIGHT, ROUGH)
    omega = limit(places, loads)
    near = omega - 1e-3, omega + 1e-3
    found = solved(scene, math.pi + aside)[-1]
    assert not found.continuum
    if name in ("three", "five"):  # the center of pressure is at the contact, but for rounding
        assert found.twist[2] == pytest.approx(0.0, abs=1e-14)
    else:
        # Of the body frame, in which the bar is along x.
        exact = exact_rotation(
            [(x, 0.0) for x in places], loads, (-math.sin(aside), math.cos(aside)), near
        )
        assert found.twist[2] == pytest.approx(exact, rel=1e-12)


@pytest.mark.parametrize("size", 10.0 ** np.arange(-14.0, -2.0))
def test_feet_beside_a_line(size):
    """Feet with a center of pressure exactly at the contact, on a line but for some digits."""
    places, beside = [-2.0, 0.5, 1.5], [size, -2 * size, size]
    scene = bar(places, [1, 1, 1], UPRIGHT, ROUGH, beside=beside)
    for aside in (0.0, 1e-8, 1e-4):
        assert solved(scene, math.pi + aside)[-1].twist[2] == pytest.approx(0.0, abs=1e-14)
    # A contact aside of the center of pressure, as the feet are seen from there.
    shifted = [x + 0.25 for x in places[:2]] + [1.25]
    for aside in (3e-3, 1e-2):
        found = solved(bar(shifted, [1, 1, 1], UPRIGHT, ROUGH, beside=beside), math.pi + aside)[-1]
        feet = list(zip(shifted, beside, strict=True))
        motion, near = (
            (-math.sin(aside), math.cos(aside)),
            (found.twist[2] - 1e-3, found.twist[2] + 1e-3),
        )
        exact = exact_rotation(feet, [1, 1, 1], motion, near)
        assert found.twist[2] == pytest.approx(exact, abs=1e-14)


def mean_torque(piece, motion, omega):
    """Torque about the origin of an even segment or a point, from its moments about the motion center."""
    x, y = -motion[1] / omega, motion[0] / omega
    distance, g_x, g_y = about(piece, x, y)
    return mpmath.sign(omega) * (distance + x * g_x + y * g_y)


#: Ends and shares of segments and points, whose torques add up to zero exactly; the rotation, roughly.
PIECES = {
    "segments": ([((0.5, 0), (1.5, 0), 1.0), ((2.25, 0), (2.75, 0), 0.5), ((4.5, 0), (4.5, 0), 0.5)], -0.3),
    "astride": ([((-1.0, 0), (0.5, 0), 1.0), ((0.25, 0), (0.25, 0), 1.0)], 0.0),
    "short": ([((0.9375, 0), (1.0625, 0), 1.0), ((2, 0), (2, 0), 0.5), ((4, 0), (4, 0), 0.5)], -0.35),
}  # fmt: skip


def piece_of(a, b, back=0.0):
    """A segment or a point, as seen from a place behind."""
    start, end = (a[0] - back, a[1]), (b[0] - back, b[1])
    return pp.Segment(start, end) if a != b else pp.Points([start])


def bar_of(pieces):
    """A slider on segments and points, whose rod begins at the contact, and is upright."""
    parts = [(share, piece_of(a, b, 2.0)) for a, b, share in pieces]
    return scene_of(pp.Composite(parts), 2.0, UPRIGHT, ROUGH)


def exact_rotation_of(pieces, aside, near):
    """Root of the torque about the contact that moves across, and aside by an angle, in 80 digits."""
    parts = [(share, piece_of(a, b)) for a, b, share in pieces]
    with mpmath.workdps(80):
        motion = -mpmath.sin(aside), mpmath.cos(aside)
        ends = near - 0.01 + mpmath.mpf("1e-30"), near + 0.01  # no motion is a translation

        def torque(omega):
            return sum(share * mean_torque(piece, motion, omega) for share, piece in parts)

        return float(mpmath.findroot(torque, ends, solver="anderson", tol=1e-55))


@pytest.mark.parametrize("aside", [0.0, 1e-9, 1e-3, 0.3])
@pytest.mark.parametrize("name", PIECES)
def test_segments_on_a_line(name, aside):
    """The limit is that of a push 1e-8 aside, for which 50 digits are enough."""
    pieces, guess = PIECES[name]
    found = solved(bar_of(pieces), math.pi + aside)[-1]
    assert found.continuum == (aside == 0.0)
    exact = exact_rotation_of(pieces, mpmath.mpf(aside or "1e-8"), found.twist[2])
    assert guess - 0.1 < exact < guess + 0.1
    assert found.twist[2] == pytest.approx(exact, rel=1e-12, abs=1e-14)


@pytest.mark.parametrize("aside", [0.0, 1e-8, 1e-5, -3e-5])
@pytest.mark.parametrize("lean", [1e-5, -3e-5, 1e-7])
@pytest.mark.parametrize("name", PIECES)
def test_segments_that_lean_beside_a_line(name, lean, aside):
    """A rounding error of the places turns the slider by its ratio to the square of the lean, 1e-6 here."""
    pieces = [
        ((a, i * lean * a), (b, i * lean * a if a == b else -lean * b), share)
        for i, ((a, _), (b, _), share) in enumerate(PIECES[name][0])
    ]
    found = solved(bar_of(pieces), math.pi + aside)[-1]
    exact = exact_rotation_of(pieces, mpmath.mpf(aside), found.twist[2])
    assert found.twist[2] == pytest.approx(exact, abs=2e-5)


def test_two_supports_on_one_line():
    """The feet at 1, 2 and 3, of which two effects share the last."""
    slider = pp.Slider(rod_length=2.0, rod_angle=UPRIGHT, radius=1.0)
    halves = [pp.Points([(x, 0), (1, 0)], [2, 1]) for x in (-1, 0)]
    effects = tuple(pp.SupportFriction(support=each, weight=1.5) for each in halves)
    scene = pp.Scene(slider=slider, contact=ROUGH, effects=effects)
    assert_continuum(pp.solve(scene, math.pi), limit(*BARS["one side"]))


def test_a_load_that_balances_the_feet():
    """Feet that are out of balance by p3 / 32 of the third, and a load at 2 that makes up for it."""
    places, loads = [1.0, 2.0, 3.0], [1.0, 1.0, 1.0625]
    lack = (3 * loads[2] - 3.0) / sum(loads)
    friction = bar(places, loads, UPRIGHT, ROUGH)
    load = pp.Load(force=(lack / 2, 0.0), center=(0.0, 0.0))
    scene = replace(friction, effects=(*friction.effects, load))
    low, high, terms = -1 / 2, -1 / 3, list(zip(places, loads, (1, 1, -1), strict=True))
    for _ in range(60):
        omega = (low + high) / 2
        rises = sum(p * x * s / (1 + omega * x) ** 2 for x, p, s in terms) > 0
        low, high = (omega, high) if rises else (low, omega)
    assert_continuum(pp.solve(scene, math.pi), low)
    assert not pp.solve(friction, math.pi)[-1].continuum


@pytest.mark.parametrize(("places", "loads"), [([1, 2, 3], [1, 1, 1.5]), ([-1, 1.1], [1, 1])])
def test_a_bar_without_an_interval_pivots(places, loads):
    found = solved(bar(places, loads, UPRIGHT, ROUGH), math.pi)[-1]
    assert found.pivot >= 0
    assert not found.continuum
    assert found.twist[2] == pytest.approx(-1 / places[found.pivot])


# --- Across the normal ---------------------------------------------------------------------------

ACROSS = {
    "segment": (pp.Segment((0, -1), (0, 1)), 1.0),
    "two": (pp.Points([(0, -1), (0, 1)]), 1.0),
    "three": (pp.Points([(0, -0.5), (0, 0), (0, 0.5)]), 0.5),
}


@pytest.mark.parametrize(("support", "reach"), ACROSS.values(), ids=ACROSS)
@pytest.mark.parametrize("degrees", [80.0, 90.0, 100.0, 135.0, 45.0])
def test_a_corner_on_the_normal_of_a_frictionless_contact(support, reach, degrees):
    """By hand: the force is along the normal for abs(u_x) <= 3 u_y / reach."""
    scene = scene_of(support, 3.0, UPRIGHT, pp.Coulomb(0.0))
    for angle in (math.radians(degrees), np.float64(math.radians(degrees))):
        found = solved(scene, angle)
        assert names(found) == ["STICK", "SLIP_RIGHT", "SLIP_LEFT"]
        x, y = math.cos(angle), math.sin(angle)
        ends = [[x, y], [3 * y / reach, y], [-3 * y / reach, y]]
        assert found.status is pp.Status.CONTINUUM
        for each, motion in zip(found, ends, strict=True):
            assert each.continuum
            assert each.contact_motion == pytest.approx(motion, abs=1e-12)
            assert each.force == pytest.approx([0, 1], abs=1e-12)
            assert each.twist[2] == pytest.approx(each.contact_motion[0] / 3, abs=1e-12)


@pytest.mark.parametrize("name", ["segment", "two"])
def test_a_continuum_of_slips_in_one_sense(name):
    """The stick is farther than the corner."""
    scene = scene_of(ACROSS[name][0], 3.0, UPRIGHT, pp.Coulomb(0.0))
    for degrees, mode in ((165.0, "SLIP_RIGHT"), (15.0, "SLIP_LEFT")):
        found = solved(scene, math.radians(degrees))
        assert names(found) == [mode, mode]
        far = 3 * math.sin(math.radians(degrees))
        assert [each.contact_motion[0] for each in found] == pytest.approx([far, -far])
        assert all(each.continuum for each in found)


def test_a_frictionless_contact_beside_the_normal_has_no_corner():
    """A rod 1e-6 rad aside, and inertia, leave one motion."""
    for psi, *masses in ((UPRIGHT + 1e-6,), (UPRIGHT, pp.Inertia())):
        scene = scene_of(ACROSS["three"][0], 3.0, psi, pp.Coulomb(0.0), *masses)
        found = solved(scene, math.radians(135))
        assert names(found) == ["SLIP_RIGHT"]
        assert found.status is not pp.Status.CONTINUUM


@pytest.mark.parametrize("degrees", [10, 20, 30, 35, 40, 45, 50, 60, 70])
@pytest.mark.parametrize("ulps", range(-2, 3))
def test_an_edge_of_the_cone_along_the_rod_has_all_of_the_corner(degrees, ulps):
    """Of a segment across the rod, to a few units in the last place of mu; `solve` agrees."""
    edge = math.radians(90 - degrees)
    mu = math.tan(math.radians(degrees))
    mu += ulps * np.spacing(mu)
    scene = scene_of(ACROSS["segment"][0], 3.0, edge, pp.Coulomb(mu))
    cone = pp.motion_cone(scene)
    assert cone.status == pp.Status.CONTINUUM
    assert cone.closed
    assert cone.right == pytest.approx(edge - math.atan(3), abs=1e-9)
    assert pp.motion_of_force(scene, math.pi / 2 - math.atan(mu)).status is pp.Status.CONTINUUM
    found = solved(scene, edge)
    assert names(found) == ["STICK", "SLIP_LEFT"]
    assert found.status is pp.Status.CONTINUUM
