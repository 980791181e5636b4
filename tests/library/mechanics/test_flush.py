"""A side on the fence: every mode against two forces at its ends, and a support of many points."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property

import numpy as np
import pytest
import xarray as xr

import planar_pushing as pp
from planar_pushing.core.instant.cone import Law
from planar_pushing.core.instant.directions import direction_at, rod_at
from planar_pushing.core.instant.flush import flush_modes
from planar_pushing.core.instant.flush_force import (
    MOST_FLUSH,
    FlatSide,
    FlushPush,
    resist_translation,
)
from planar_pushing.core.instant.solution import SOLUTION, Push, Solution
from planar_pushing.core.numbers import zeros
from planar_pushing.core.supports.contact import contact_at
from planar_pushing.core.supports.rows import read_effects

SEPARATE, STICK, RIGHT, LEFT = pp.ContactMode
LAWS = [
    pp.Coulomb(0.0), pp.Coulomb(0.3), pp.Coulomb(1.5), pp.InfiniteFriction(),
    pp.InfiniteFriction("none"), pp.PerfectlyRough(),
]  # fmt: skip
SQUARE = pp.Polygon.rectangle(2.0, 2.0)
FEET = pp.Points([(1, 1), (-1, 1), (-1, -1), (1, -1)])
MASS = pp.Inertia(gyration_radius=0.8)


def side(effects, contact, *, ends=(-1.0, 1.0), length=1.0, angle=np.pi / 2):
    """A scene whose side lies on the fence, `length` below the slider's center."""
    slider = pp.Slider(rod_length=length, rod_angle=angle, side=ends, flush=True)
    return pp.Scene(slider=slider, contact=contact, effects=effects)


class Brute:
    """The slider of a scene as points, in the fence frame, whose origin is that of the side.

    A rotation about the origin and the motion of the origin make a motion; shape S + (points,) within.
    """

    def __init__(self, scene):
        slider = scene.slider
        c, s = np.cos(slider.rod_angle), np.sin(slider.rod_angle)
        self.turn = np.array([[c, -s], [s, c]])
        self.center = slider.rod_length * np.array([c, s])
        self.a, self.b = slider.side
        self.points, self.loads = np.empty((0, 2)), np.empty(0)
        self.masses, self.films, self.load = [], [], np.zeros(3)
        inert = any(isinstance(each, pp.Inertia) for each in scene.effects)
        for each in scene.effects:
            if isinstance(each, pp.SupportFriction):
                points, shares = points_of(each.support)
                self.points = np.concatenate([self.points, self.place(points)])
                self.loads = np.concatenate([self.loads, each.weight * shares])
            elif isinstance(each, pp.Viscous) and not inert:
                points, shares = points_of(each.support)
                self.films.append((self.place(points), each.coefficient * shares))
            elif isinstance(each, pp.Inertia):
                self.masses.append((each.mass, self.place(each.center), each.gyration_radius))
            elif isinstance(each, pp.Load):
                masses = [m for m in scene.effects if isinstance(m, pp.Inertia)]
                center = each.center or (masses[0].center if masses else (0.0, 0.0))
                (x, y), (f_x, f_y) = self.place(center), each.force
                self.load += f_x, f_y, x * f_y - y * f_x
        self.weight = self.loads.sum()
        self.scale = max(1.0, self.weight, np.abs(self.load).max())

    def place(self, points):
        return self.center + np.asarray(points, dtype=float) @ self.turn.T

    def wrench(self, x, y, spin):
        """Force and torque about the origin that sustain motions, without friction of points at rest."""
        x, y, spin = np.broadcast_arrays(*map(np.asarray, (x, y, spin)))
        v_x = x[..., None] - spin[..., None] * self.points[:, 1]
        v_y = y[..., None] + spin[..., None] * self.points[:, 0]
        speed = np.hypot(v_x, v_y)
        part = np.divide(self.loads, speed, out=np.zeros_like(speed), where=speed > 0)
        f_x, f_y = part * v_x, part * v_y
        torque = (self.points[:, 0] * f_y - self.points[:, 1] * f_x).sum(-1) - self.load[2]
        f_x, f_y = f_x.sum(-1) - self.load[0], f_y.sum(-1) - self.load[1]
        for points, shares in self.films:
            for (r_x, r_y), share in zip(points, shares, strict=True):
                g_x, g_y = share * (x - spin * r_y), share * (y + spin * r_x)
                f_x, f_y, torque = f_x + g_x, f_y + g_y, torque + r_x * g_y - r_y * g_x
        for mass, (r_x, r_y), rho in self.masses:
            g_x, g_y = mass * (x - spin * r_y), mass * (y + spin * r_x)
            f_x, f_y = f_x + g_x, f_y + g_y
            torque = torque + r_x * g_y - r_y * g_x + mass * rho**2 * spin
        return f_x, f_y, torque

    def spin_at(self, place, x, y):
        """The rotations about a point of the fence that moves by (x, y): there the torque is zero."""
        x, y = np.broadcast_arrays(*map(np.asarray, (x, y)))
        size = 1e4 * (np.hypot(x, y) + np.abs(self.load).max())
        low, high = -size, size
        for _ in range(64):
            middle = (low + high) / 2
            _, f_y, torque = self.wrench(x, y - place * middle, middle)
            positive = torque - place * f_y > 0
            low, high = np.where(positive, low, middle), np.where(positive, middle, high)
        return (low + high) / 2, low, high

    def held(self, forces):
        """The largest power of the loads, relative to friction's, over twists that forces allow."""
        f_x, f_y, torque = np.array(forces).T if len(forces) else np.zeros((3, 0))
        twists = TWISTS[:, :3]
        f_x, f_y, torque = (each[None] for each in (f_x, f_y, torque))
        power = twists[:, :1] * f_x + twists[:, 1:2] * f_y + twists[:, 2:] * torque
        allowed = (power >= 0).all(1)
        ratio = (twists @ self.load) / self.friction
        return ratio[allowed].max(initial=-np.inf)

    @cached_property
    def friction(self):
        """Power of friction in each of the twists."""
        v_x = TWISTS[:, :1] - TWISTS[:, 2:] * self.points[:, 1]
        v_y = TWISTS[:, 1:2] + TWISTS[:, 2:] * self.points[:, 0]
        return np.maximum(np.hypot(v_x, v_y) @ self.loads, 1e-300)


GRID = np.linspace(-1, 1, 25)
TWISTS = np.array([
    each for x in GRID for y in GRID for s in GRID
    for each in ((x, y, s),) if max(abs(x), abs(y), abs(s)) == 1
])  # fmt: skip


def points_of(support):
    """Points and shares: feet exactly, other supports by equal cells."""
    if isinstance(support, pp.Points):
        weights = np.ones(len(support.positions)) if support.weights is None else support.weights
        return np.array(support.positions), np.array(weights) / np.sum(weights)
    n = 60
    middles = (np.arange(n) + 0.5) / n
    if isinstance(support, pp.Segment):
        start, end = np.array(support.start), np.array(support.end)
        points = start + (np.arange(800) + 0.5)[:, None] / 800 * (end - start)
    elif isinstance(support, pp.Ring):
        angles = 2 * np.pi * np.arange(800) / 800
        center = support.center or (0.0, 0.0)
        points = center + support.radius * np.column_stack([np.cos(angles), np.sin(angles)])
    elif isinstance(support, pp.Disc):
        radii, angles = np.meshgrid(np.sqrt(middles), 2 * np.pi * middles)
        unit = np.column_stack([(radii * np.cos(angles)).ravel(), (radii * np.sin(angles)).ravel()])
        points = np.array(support.center or (0.0, 0.0)) + support.radius * unit
    else:
        (x_0, y_0), (x_1, y_1) = np.min(support.vertices, 0), np.max(support.vertices, 0)
        x, y = np.meshgrid(x_0 + (x_1 - x_0) * middles, y_0 + (y_1 - y_0) * middles)
        points = np.column_stack([x.ravel(), y.ravel()])
    return points, np.full(len(points), 1 / len(points))


def edges_of(law):
    """Unit vectors of the right and the left edge."""
    if isinstance(law, pp.Coulomb):
        mu = law.friction_coefficient
        return np.array([mu, 1.0]) / np.hypot(mu, 1), np.array([-mu, 1.0]) / np.hypot(mu, 1)
    return np.array([1.0, 0.0]), np.array([-1.0, 0.0])


def depth_in_cone(law, f_x, f_y):
    """How far a force is within the cone, negative outside."""
    if isinstance(law, pp.PerfectlyRough):
        return np.inf
    right, left = edges_of(law)
    depth = min(right[0] * f_y - right[1] * f_x, left[1] * f_x - left[0] * f_y)
    return (
        min(depth, f_y)
        if not isinstance(law, pp.Coulomb) or not law.friction_coefficient
        else depth
    )


MAGNITUDES = np.concatenate([-np.logspace(3, -6, 140), np.logspace(-6, 3, 140)])


def enumerate_modes(scene, angle, magnitude):
    """Solutions (mode, place, x, spin, margin) by scans; place None for flush, x of the touching point.

    The margin is how far the conditions of the solution, or of its absence, are from equality.
    """
    body, law = Brute(scene), scene.contact
    w_x, w_y = magnitude * np.cos(angle), magnitude * np.sin(angle)
    a, b, rough = body.a, body.b, isinstance(law, pp.PerfectlyRough)
    found = []
    right, left = edges_of(law)
    slips = (
        [] if rough or law == pp.InfiniteFriction("none") else [(RIGHT, left, 1), (LEFT, right, -1)]
    )

    def at(place, x):
        """Force, torque about the origin, and rotation of a motion of the touching point."""
        if place is None:
            return *body.wrench(x, w_y, 0.0), 0.0
        spin, low, high = body.spin_at(place, x, w_y)
        one, other = (body.wrench(x, w_y - place * each, each) for each in (low, high))
        return *((p + q) / 2 for p, q in zip(one, other, strict=True)), spin

    for place in (None, a, b):
        lift = {None: lambda spin: np.inf, a: lambda spin: spin, b: lambda spin: -spin}[place]

        def ends(f_y, torque, place=place):
            if place is not None or rough:
                return np.inf
            return min(b * f_y - torque, torque - a * f_y) / (b - a)

        f_x, f_y, torque, spin = at(place, w_x)
        margin = min(depth_in_cone(law, f_x, f_y), ends(f_y, torque), lift(spin))
        found.append((STICK, place, w_x, float(spin), margin))
        for mode, edge, sense in slips:
            xs = np.sort(np.concatenate([MAGNITUDES, w_x + MAGNITUDES * 1e-3]))
            f_x, f_y, torque, spin = at(place, xs)
            across = edge[0] * f_y - edge[1] * f_x
            for i in np.flatnonzero((across[1:] > 0) != (across[:-1] > 0)):
                low, high = xs[i], xs[i + 1]
                for _ in range(50):
                    middle = (low + high) / 2
                    f_x, f_y, *_ = at(place, middle)
                    if (edge[0] * f_y - edge[1] * f_x > 0) == (across[i] > 0):
                        low = middle
                    else:
                        high = middle
                pairs = at(place, low), at(place, high)
                f_x, f_y, torque, spin = (np.mean(each) for each in zip(*pairs, strict=True))
                along = edge[0] * f_x + edge[1] * f_y
                margin = min(sense * (low - w_x), along, ends(f_y, torque), lift(spin))
                found.append((mode, place, low, float(spin), margin))
    return found


def random_scene(seed, feet=True):
    """Any law and effects; ends of the side in any place."""
    random = np.random.default_rng(seed)
    law = [*LAWS, pp.Coulomb(random.uniform(0.05, 2)), pp.Coulomb(random.uniform(0.05, 2))][
        seed % 8
    ]
    support = pp.Points(random.uniform(-1, 1, (random.integers(3, 7), 2)))
    if not feet:
        support = [
            pp.Segment((-1.0, 0.3), (0.8, -0.2)), SQUARE, pp.Disc(0.9), pp.Ring(1.1),
            pp.Polygon.rectangle(2.0, 0.5, center=(0.3, 0.2)),
        ][seed % 5]  # fmt: skip
    friction = pp.SupportFriction(support=support, weight=random.uniform(0.5, 2))
    mass = pp.Inertia(
        mass=random.uniform(0.5, 2), gyration_radius=random.uniform(0.3, 1),
        center=tuple(random.uniform(-0.5, 0.5, 2)),
    )  # fmt: skip
    film = pp.Viscous(support=support, coefficient=random.uniform(0.5, 2))
    load = pp.Load(force=tuple(random.uniform(-2, 2, 2)))
    weak = pp.Load(force=tuple(random.uniform(-0.2, 0.2, 2)))
    effects = [
        (friction,), (mass,), (friction, mass), (film,), (friction, film), (friction, mass, load),
        (mass, load), (friction, weak), (friction, film, load),
    ][(seed // 8) % 9]  # fmt: skip
    scene = side(
        effects, law, ends=(-random.uniform(0.05, 1.5), random.uniform(0.05, 1.5)),
        length=random.uniform(0.3, 2), angle=random.uniform(0.5, 2.6),
    )  # fmt: skip
    return scene, random.uniform(-np.pi, np.pi), 10 ** random.uniform(-1, 1)


def place_of(solution, scene):
    """Where a solution touches: None along the whole side."""
    return None if solution.flush else float(solution.force_position)


def same_place(one, other):
    return one is other or (None not in (one, other) and np.isclose(one, other))


@pytest.mark.parametrize(
    "part", [0, *(pytest.param(part, marks=pytest.mark.slow) for part in range(1, 15))]
)
def test_every_mode_of_random_scenes_on_feet(part):
    for seed in range(part, 150, 15):  # every law, and nearly all effects
        scene, angle, magnitude = random_scene(seed)
        try:
            solutions = pp.solve(scene, angle, magnitude)
        except pp.InvalidValue:  # a load that friction does not hold
            continue
        assert solutions.status != pp.Status.UNSOLVED
        scale = max(1.0, np.abs([each.contact_motion for each in solutions]).max(initial=0.0))
        expected = enumerate_modes(scene, angle, magnitude)
        listed = [
            (each.mode, place_of(each, scene), each.contact_motion[0], each.twist[2])
            for each in solutions if each.mode != SEPARATE
        ]  # fmt: skip

        def near(one, other, scale=scale):
            numbers = np.allclose(one[2:4], other[2:4], atol=1e-5 * scale)
            return one[0] == other[0] and same_place(one[1], other[1]) and numbers

        for one in expected:
            if one[4] > 1e-6:
                assert any(near(one, each) for each in listed), (seed, one, listed)
        for one in listed:
            assert any(near(each, one) and each[4] > -1e-6 for each in expected), (
                seed,
                one,
                expected,
            )


def generators(law, edges, a, b):
    """Forces at both ends, with torques about the origin, whose multiples the contact can add up."""
    if not isinstance(law, pp.Coulomb) and len(edges) == 2:
        edges = [*edges, np.array([0.0, 1.0])]
    return [(x, y, place * y) for x, y in edges for place in (a, b)]


@pytest.mark.parametrize(
    "part", [0, *(pytest.param(part, marks=pytest.mark.slow) for part in range(1, 8))]
)
def test_a_load_that_presses_a_resting_side(part):
    """Friction and contact hold a side if no motion that leaves the contact is driven by the load."""
    kinds = set()
    for seed in range(20 * part, 20 * (part + 1)):
        random = np.random.default_rng(seed)
        scene, *_ = random_scene(8 * 5 * 9 + seed, feet=seed % 2 == 0)
        law = [
            pp.Coulomb(0.0),
            pp.Coulomb(0.6),
            pp.InfiniteFriction(),
            pp.InfiniteFriction("none"),
        ][seed % 4]
        support = random_scene(seed, feet=seed % 2 == 0)[0].effects[0]
        support = support.support if hasattr(support, "support") else FEET
        load = pp.Load(
            force=tuple(random.uniform(-2.5, 2.5, 2)), center=tuple(random.uniform(-1, 1, 2))
        )
        effects = (pp.SupportFriction(support=support), MASS, load)
        scene = replace(scene, effects=effects, contact=law)
        body, (right, left) = Brute(scene), edges_of(law)
        a, b = scene.slider.side
        free = body.held([])
        for angle, magnitude, mode, edges in (
            (0.0, 0.0, STICK, [right, left]), (0.0, 1.0, LEFT, [right]), (np.pi, 1.0, RIGHT, [left]),
        ):  # fmt: skip
            if mode != STICK and law == pp.InfiniteFriction("none"):
                continue
            ratio = body.held(generators(law, edges, a, b))
            if min(abs(ratio - 1), abs(free - 1)) < 0.05:
                continue
            solutions = pp.solve(scene, angle, magnitude)
            resting = [each for each in solutions.of(mode) if not each.twist.any()]
            assert all(each.flush for each in resting)
            assert len(resting) == (free > 1 and ratio < 1), (seed, mode, ratio, free)
            kinds.add((mode, len(resting)))
            for each in resting:
                f_x, f_y = each.force
                torque = f_y * each.force_position if f_y > 0 else 0.0
                body.load += f_x, f_y, torque
                assert body.held([]) < 1.01
                body.load -= f_x, f_y, torque
                assert depth_in_cone(law, f_x, f_y) >= -1e-12
                assert f_y == 0 or a <= each.force_position <= b
                if mode != STICK:
                    assert abs(edges[0][0] * f_y - edges[0][1] * f_x) < 1e-12 * np.hypot(f_x, f_y)
    assert {count for _, count in kinds} == {0, 1}


AWAY = np.hypot(1.0, 1.0), np.pi / 4
#: Scene, direction of the push in degrees, and (mode, flush, force, x*) of each solution.
EXACT = {
    "center of pressure above the end, pushed normally": (
        side((pp.SupportFriction(support=SQUARE),), pp.Coulomb(0.5), length=AWAY[0], angle=AWAY[1]),
        90, [(STICK, True, (0, 1), 1)],
    ),
    "the same feet": (
        side((pp.SupportFriction(support=FEET),), pp.Coulomb(0.5), length=AWAY[0], angle=AWAY[1]),
        90, [(STICK, True, (0, 1), 1)],
    ),
    "the same without friction, pushed aside": (
        side((pp.SupportFriction(support=SQUARE),), pp.Coulomb(0), length=AWAY[0], angle=AWAY[1]),
        100, [(RIGHT, True, (0, 1), 1)],
    ),
    "a foot at an end, the others above it": (
        side((pp.SupportFriction(support=pp.Points([(0, -1), (0, 0), (0, 1)])),), pp.Coulomb(0.5),
             length=AWAY[0], angle=AWAY[1]),
        90, [(STICK, True, (0, 1), 1)],
    ),
    "force at the end of the cone": (
        side((pp.SupportFriction(support=SQUARE),), pp.Coulomb(0.5)),
        np.rad2deg(np.arctan2(1, 0.5)), [(STICK, True, (0.5 / 1.25**0.5, 1 / 1.25**0.5), -0.5)],
    ),
    "force at the end of cone and side": (
        side((pp.SupportFriction(support=SQUARE),), pp.Coulomb(1.0)), 45,
        [(STICK, True, (0.5**0.5, 0.5**0.5), -1)],
    ),
    "a slip whose force is at the end": (
        side((pp.SupportFriction(support=SQUARE),), pp.Coulomb(1.0)), 30,
        [(LEFT, True, (0.5**0.5, 0.5**0.5), -1)],
    ),
    "along itself": (
        side((pp.SupportFriction(support=SQUARE),), pp.Coulomb(0.5)), 0,
        [(SEPARATE, False, (0, 0), None)],
    ),
    "both centers on the fence, definition 1": (
        side((pp.SupportFriction(support=SQUARE), MASS), pp.InfiniteFriction(), length=0.0), 180,
        [(SEPARATE, False, (0, 0), None), (STICK, True, (-2, 0), None)],
    ),
    "the same, definition 2": (
        side((pp.SupportFriction(support=SQUARE), MASS), pp.InfiniteFriction("none"), length=0.0), 180,
        [(SEPARATE, False, (0, 0), None)],
    ),
    "retreating": (
        side((pp.SupportFriction(support=SQUARE), MASS), pp.Coulomb(3.0)), -80,
        [(SEPARATE, False, (0, 0), None)],
    ),
    "a rough fence that retreats": (
        side((pp.SupportFriction(support=SQUARE),), pp.PerfectlyRough()), -90,
        [(SEPARATE, False, (0, 0), None), (STICK, True, (0, -1), 0),
         (STICK, False, (-0.558042, -0.756825), -1), (STICK, False, (0.558042, -0.756825), 1)],
    ),
    "a tilted table": (
        side((pp.SupportFriction(support=SQUARE), MASS, pp.Load(force=(0.3, -2.0))), pp.Coulomb(0.5)), None,
        [(STICK, True, (-0.3, 2), 0.15)],
    ),
    "a tilted table, without friction on the fence": (
        side((pp.SupportFriction(support=SQUARE), MASS, pp.Load(force=(0.3, -2.0))), pp.Coulomb(0.0)), None,
        [(STICK, True, (0, 2), None)],
    ),
    "a load that slides along the fence": (
        side((pp.SupportFriction(support=SQUARE), MASS, pp.Load(force=(2.0, -0.5))), pp.Coulomb(0.5)), None,
        [(RIGHT, True, (-0.25, 0.5), 0.5 * 1)],
    ),
    "a load about to slide along the fence": (
        side((pp.SupportFriction(support=SQUARE), MASS, pp.Load(force=(1.0, -2.0))), pp.Coulomb(0.0)), None,
        [(STICK, True, (0, 2), 0)],
    ),
    "the same on feet, with friction": (
        side((pp.SupportFriction(support=FEET), MASS, pp.Load(force=(-2.0, -2.0))), pp.Coulomb(0.5)), None,
        [(STICK, True, (1.2, 2.4), None)],
    ),
    "nothing moves": (
        side((pp.SupportFriction(support=SQUARE), MASS, pp.Load(force=(0.3, 0.2))), pp.Coulomb(0.5)), None,
        [(SEPARATE, False, (0, 0), None)],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", EXACT)
def test_exact_ties_have_one_answer(name):
    scene, degrees, expected = EXACT[name]
    push = (0.0, 0.0) if degrees is None else (np.deg2rad(degrees), 1.0)
    solutions = pp.solve(scene, *push)
    assert [(each.mode, each.flush) for each in solutions] == [each[:2] for each in expected]
    for one, (_, _, force, place) in zip(solutions, expected, strict=True):
        assert one.force == pytest.approx(force, abs=1e-6)
        if place is not None:
            assert one.force_position == pytest.approx(place, abs=1e-12)
    continuum = "both centers" in name
    assert [each.continuum for each in solutions] == [False] * (len(expected) - 1) + [continuum]


def modes_in_rotation(scene, w_x, w_y, spin):
    """Mode, motion along the fence and force of the flush modes of a side that rotates, from the core."""
    rows, law = scene.rows, scene.rows.law
    rod = rod_at(scene.slider.rod_length, scene.slider.rod_angle)
    numbers = (
        memoryview(np.array(rows.data, dtype=float)),
        memoryview(np.array(rows.columns, dtype=float)),
    )
    push = Push(read_effects(*numbers), contact_at(-rod.length, 0.0), rod.x, -rod.y)
    edges = direction_at(rod, law.right), direction_at(rod, law.left)
    out = zeros(MOST_FLUSH * SOLUTION)
    flush = FlushPush(
        push, FlatSide(*scene.slider.side), Law(*edges, law.slips, law.closed, law.rough),
        w_x, w_y, spin, resist_translation(push),
    )  # fmt: skip
    count = flush_modes(flush, out)
    listed = [Solution(out[i * SOLUTION :]) for i in range(count)]
    return [(row.mode, row.motion.x, np.array([row.force.x, row.force.y])) for row in listed]


def test_a_side_that_rotates_onto_the_fence():
    """A step that closes a gap prescribes rotation and normal motion: slips by scans of the force."""
    modes = []
    for seed in range(250):
        scene, angle, _ = random_scene(seed)
        scene = replace(scene, slider=replace(scene.slider, radius=1.0))
        random, law, (a, b) = np.random.default_rng(seed), scene.contact, scene.slider.side
        w_x, w_y, spin = np.cos(angle), np.sin(angle), random.uniform(-1, 1)
        body, listed = Brute(scene), modes_in_rotation(scene, w_x, w_y, spin)
        modes += [one[0] for one in listed]

        def margin(x, depth, body=body, w_y=w_y, spin=spin, a=a, b=b):
            _, f_y, torque = body.wrench(x, w_y, spin)
            return min(depth, min(b * f_y - torque, torque - a * f_y) / (b - a))

        f_x, f_y, _ = body.wrench(w_x, w_y, spin)
        sticks = margin(w_x, depth_in_cone(law, f_x, f_y))
        rough = isinstance(law, pp.PerfectlyRough)
        sticking = [one for one in listed if one[0] == STICK]
        assert rough or abs(sticks) < 1e-9 or len(sticking) == (sticks > 0)
        for one in sticking:
            assert one[2] == pytest.approx((f_x, f_y), abs=1e-9 * body.scale)
        right, left = edges_of(law)
        slips = [one for one in listed if one[0] != STICK]
        assert not slips or scene.contact.slips
        xs = np.concatenate([MAGNITUDES, w_x + MAGNITUDES * 1e-3])
        for mode, edge, sense in (
            ((RIGHT, left, 1), (LEFT, right, -1)) if scene.contact.slips else ()
        ):
            grid = np.sort(np.append(xs, np.linspace(-3, 3, 600)))
            f_x, f_y, _ = body.wrench(grid, w_y, spin)
            across, along = edge[0] * f_y - edge[1] * f_x, edge[0] * f_x + edge[1] * f_y
            own = [x for each, x, _ in slips if each == mode]
            for x in own:
                f_x, f_y, _ = body.wrench(x, w_y, spin)
                assert abs(edge[0] * f_y - edge[1] * f_x) < 1e-9 * body.scale
                assert margin(x, sense * (x - w_x)) > -1e-9 * body.scale
            for i in np.flatnonzero((across[1:] > 0) != (across[:-1] > 0)):
                ends = [margin(x, sense * (x - w_x)) for x in grid[i : i + 2]]
                if min(*ends, *along[i : i + 2]) > 1e-3:
                    assert any(grid[i] <= x <= grid[i + 1] for x in own), (seed, mode, grid[i], own)
    assert min(modes.count(mode) for mode in (STICK, RIGHT, LEFT)) >= 8


def test_a_tie_within_rounding_has_one_answer_everywhere():
    """Objects in any pose whose force passes through an end or whose push is at the edge of the cone."""
    random = np.random.default_rng(5)
    for _ in range(200):
        turn, shift = random.uniform(-np.pi, np.pi), random.uniform(-1e3, 1e3, 2)
        c, s = np.cos(turn), np.sin(turn)
        corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) @ [[c, s], [-s, c]] + shift
        effects = [pp.SupportFriction(support=pp.Polygon(corners.tolist()))]
        scene = pp.scene_at(side=0, effects=effects, contact=pp.Coulomb(1.0), outline=corners)
        for degrees in (45, 44.9999, 135, 135.0001, 90, 150):
            (one,) = pp.solve(scene, np.deg2rad(degrees))
            assert one.flush
            assert one.mode == (
                STICK if degrees in (45, 135, 90) else LEFT if degrees < 90 else RIGHT
            )


@pytest.mark.parametrize("part", range(3))
def test_every_solution_balances_its_forces(part):
    """Any support by many points; the forces at the ends add up to the force, each in the cone."""
    for seed in range(90 * part, 90 * (part + 1)):
        scene, angle, magnitude = random_scene(seed, feet=False)
        body, law, w = (
            Brute(scene),
            scene.contact,
            magnitude * np.array([np.cos(angle), np.sin(angle)]),
        )
        try:
            solutions = pp.solve(scene, angle, magnitude)
        except pp.InvalidValue:
            continue
        assert list(solutions.modes) == sorted(solutions.modes)
        for one in solutions:
            spin = one.twist[2]
            u_x, u_y = one.twist[:2] - spin * np.array([-body.center[1], body.center[0]])
            size = body.scale * max(1.0, magnitude, abs(one.twist).max())
            at_rest = not one.twist.any()
            wrench = np.array(body.wrench(u_x, u_y, spin)) if not at_rest else np.zeros(3)
            (a, b), x = scene.slider.side, one.force_position
            low, high = one.end_forces[:, 0], one.end_forces[:, 1]
            if one.mode == SEPARATE:
                ends = u_y + spin * np.array([a, b])
                assert (ends >= w[1] - 1e-9 * size).all()
                assert at_rest or wrench == pytest.approx(0, abs=2e-2 * size)
                assert not one.flush
                assert np.isnan(x)
                assert not one.end_forces.any()
                continue
            exact = 1e-9 if one.flush or not (scene.friction or scene.viscous) else 2e-2
            torque = x * one.force[1] if one.force[1] else 0.0
            if not at_rest:
                assert wrench[:2] == pytest.approx(one.force, abs=exact * size)
            if not at_rest and not isinstance(law, pp.PerfectlyRough):
                assert wrench[2] == pytest.approx(torque, abs=exact * size * 3)
            assert one.flush == (spin == 0.0)
            assert one.flush or x == pytest.approx(a if spin > 0 else b)
            place = 0.0 if one.flush else x
            assert u_y + place * spin == pytest.approx(w[1], abs=1e-9 * size)
            slip = u_x - w[0]
            assert {STICK: abs(slip) < 1e-9 * size, RIGHT: slip > 0, LEFT: slip < 0}[one.mode]
            assert low[:, 1] == pytest.approx(high[:, 1])
            assert (low <= high).all()
            assert low[:, 1].sum() == pytest.approx(one.force[1], abs=1e-9 * size)
            assert (np.array([a, b]) * low[:, 1]).sum() == pytest.approx(torque, abs=1e-9 * size)
            assert one.adhesive == bool((low[:, 1] < -1e-12 * size).any())
            if isinstance(law, pp.Coulomb):
                mu = law.friction_coefficient
                assert low[0, 0] + high[1, 0] == pytest.approx(one.force[0], abs=1e-9 * size)
                assert (
                    abs(one.end_forces[..., 0]) <= mu * one.end_forces[..., 1] + 1e-9 * size
                ).all()
                if one.mode != STICK:
                    assert (low[:, 0] == high[:, 0]).all()
            if not isinstance(law, pp.PerfectlyRough):
                assert (low[:, 1] >= 0).all()
                assert depth_in_cone(law, *one.force) >= -1e-9 * size


def test_a_flush_pull_needs_adhesion_or_a_load():
    """Without a load, friction and inertia are along the motion, so a fence cannot pull a flush side."""
    for seed in range(200):
        scene, angle, magnitude = random_scene(seed, feet=seed % 2 == 0)
        if scene.loads or isinstance(scene.contact, pp.PerfectlyRough):
            continue
        assert not [each for each in pp.solve(scene, -abs(angle), magnitude) if each.flush]
    load = pp.Load(force=(0.0, -2.0))
    scene = side((pp.SupportFriction(support=SQUARE), MASS, load), pp.Coulomb(0.5))
    (one,) = pp.solve(scene, -np.pi / 2, 0.2)
    assert (one.mode, one.flush) == (STICK, True)
    assert one.force == pytest.approx((0.0, 2.0 - 0.2 - 1.0))


#: The fields of a solution along a side.
FIELDS = (
    "mode", "force", "force_end", "twist", "contact_motion", "spin_ratio", "center", "pivot", "continuum",
    "flush", "force_position", "end_forces",
)  # fmt: skip


@pytest.mark.parametrize("angle", [0.0, 0.4, np.pi / 2, 2.5, np.pi, 4.0])
@pytest.mark.parametrize("magnitude", [0.0, 0.05])
@pytest.mark.parametrize("more", [
    (), (pp.Inertia(mass=1.3, gyration_radius=0.1, center=(0.02, 0.01)),), (pp.Load(force=(0.1, -0.4)),),
], ids=["friction", "inertia", "load"])  # fmt: skip
def test_a_push_of_numbers_answers_as_an_array_to_the_last_bit(angle, magnitude, more):
    box = pp.Polygon.rectangle(0.3, 0.2)
    for law in (pp.Coulomb(0.0), pp.Coulomb(0.5), pp.InfiniteFriction(), pp.PerfectlyRough()):
        effects = (pp.SupportFriction(support=box, weight=3.3), *more)
        scene = pp.scene_at(side=0, effects=effects, contact=law, outline=box)
        array = pp.solve(scene, np.array([angle]), magnitude)
        for push in ((angle, magnitude), (np.float64(angle), np.float64(magnitude))):
            found = pp.solve(scene, *push)
            assert (len(found), int(found.status)) == (array.solutions[0], array.status[0])
            for j, solution in enumerate(found):
                for name in FIELDS:
                    expected = getattr(array, name)[0, j]
                    np.testing.assert_array_equal(getattr(solution, name), expected)
                assert type(solution.force_position) is type(solution.spin_ratio) is float
                assert type(solution.flush) is type(solution.continuum) is bool


def test_arrays_labels_and_scalars_agree():
    random = np.random.default_rng(2)
    lengths, starts = random.uniform(0.5, 2, 5), -random.uniform(0.2, 1.5, 5)
    angles, magnitudes = random.uniform(-np.pi, np.pi, 7), np.array([0.0, 1.0])
    laws = np.array([*LAWS[:5]], dtype=object)
    effects = (pp.SupportFriction(support=SQUARE, weight=2.0), MASS, pp.Load(force=(0.3, -1.0)))

    def scenes(length, start, law):
        slider = pp.Slider(rod_length=length, rod_angle=1.2, side=(start, 0.8), flush=True)
        return pp.Scene(slider=slider, contact=law, effects=effects)

    arrays = pp.solve(
        scenes(lengths[:, None, None], starts[:, None, None], laws[:, None, None]),
        angles[:, None], magnitudes,
    )  # fmt: skip
    assert arrays.shape == (5, 7, 2)
    labeled = pp.solve(
        scenes(xr.DataArray(lengths, dims="scene"), xr.DataArray(starts, dims="scene"),
               xr.DataArray(laws, dims="scene")),
        xr.DataArray(angles, dims="push"), xr.DataArray(magnitudes, dims="size"),
    )  # fmt: skip
    assert labeled.end_forces.dims[-3:] == ("end", "bound", "xy")
    assert labeled.flush.attrs["long_name"].startswith("whether the side")
    assert arrays.to_dataset(["scene", "push", "size"]).equals(labeled)
    for i, j, k in np.ndindex(5, 7, 2):
        scene = scenes(float(lengths[i]), float(starts[i]), laws[i])
        assert pp.solve(scene, np.float64(angles[j]), np.float32(magnitudes[k])) == arrays[i, j, k]
        assert pp.solve(scene, float(angles[j]), int(magnitudes[k])) == arrays[i, j, k]


def test_what_is_printed_and_written():
    scene = side((pp.SupportFriction(support=SQUARE),), pp.InfiniteFriction())
    solutions = pp.solve(scene, np.deg2rad(80))
    assert all(word in repr(solutions) for word in ("flush", "-inf to inf"))
    (one,) = solutions.to_dict()["solutions"]
    assert one["flush"] is True
    assert one["end_forces"][0][0][0] == -np.inf
    point = replace(scene, slider=replace(scene.slider, flush=False))
    (one,) = pp.solve(point, np.deg2rad(80)).to_dict()["solutions"]
    assert {"flush", "force_position", "end_forces"}.isdisjoint(one)
    dataset = pp.solve(point, xr.DataArray([1.0], dims="push"))
    assert {"flush", "force_position", "end_forces"}.isdisjoint(dataset)


REFUSED = {
    "motion_cone": lambda scene: pp.motion_cone(scene),
    "can_pull": lambda scene: pp.can_pull(scene),
    "slips_while_pushing": lambda scene: pp.slips_while_pushing(scene),
    "conservative_motion_cone": lambda scene: pp.conservative_motion_cone(scene),
    "limit_curve": lambda scene: pp.limit_curve(scene, 1.0),
    "motion_of_force": lambda scene: pp.motion_of_force(scene, 1.0),
    "motion_centers": lambda scene: pp.motion_centers(scene, 1.0),
    "motion_angle": lambda scene: pp.motion_angle(scene, 1.0),
    "spin_ratio": lambda scene: pp.spin_ratio(scene, 1.0),
    "pusher": lambda scene: pp.to_mjcf(
        replace(
            scene, effects=(*scene.effects, pp.Inertia()),
            slider=replace(scene.slider, outline=[(-1, -1), (1, -1), (0, 1)]),
        ),
        pusher="finger",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_functions_about_one_point_refuse_a_side(name):
    slider = pp.Slider(rod_length=1.0, rod_angle=1.0, side=(-1.0, 1.0), flush=True)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(0.5), effects=(pp.RingFriction(),))
    with pytest.raises(
        pp.InvalidValue, match="a side that lies on the fence' given; allowed: a scene with"
    ):
        REFUSED[name](scene)


def changed(scene, number, factor):
    """The scene with the strength of an effect, or the coefficient of friction for -1, times a factor."""
    if number < 0:
        return replace(scene, contact=pp.Coulomb(factor * scene.contact.friction_coefficient))
    effects = list(scene.effects)
    effect = effects[number]
    if isinstance(effect, pp.Load):
        effects[number] = replace(effect, force=tuple(factor * part for part in effect.force))
    else:
        name = next(
            name
            for name in ("weight", "mass", "coefficient")
            if getattr(effect, name, None) is not None
        )
        effects[number] = replace(effect, **{name: factor * getattr(effect, name)})
    return replace(scene, effects=tuple(effects))


def strength_of(effect):
    return next(
        getattr(effect, name)
        for name in ("weight", "mass", "coefficient")
        if getattr(effect, name, None) is not None
    )


def difference(scenes, angles, sizes, solution, step):
    """Half the change of twist and force between two problems, per step; None where the mode is another."""
    values = []
    for scene, angle, size in zip(scenes, angles, sizes, strict=True):
        near = [
            each for each in pp.solve(scene, angle, size)
            if (each.mode, each.flush) == (solution.mode, solution.flush)
            and np.abs(each.twist - solution.twist).max() < 1e-3
        ]  # fmt: skip
        if len(near) != 1:
            return None
        values.append(np.concatenate([near[0].twist, near[0].force]))
    return (values[1] - values[0]) / (2 * step)


def test_derivatives_are_differences():
    """Of every smooth solution of random sides, on the fence and about an end."""
    step, compared = 1e-6, {True: 0, False: 0}
    for seed in range(400):
        scene, angle, size = random_scene(seed, feet=seed % 2 == 0)
        if (seed // 8) % 9 == 8:
            continue  # friction cannot hold its load
        motion = size * np.array([np.cos(angle), np.sin(angle)])
        for solution in pp.solve(scene, angle, size, derivatives=True):
            by = solution.derivatives
            if by.status not in (pp.Smoothness.SMOOTH, pp.Smoothness.PIVOT):
                continue
            columns = []
            for k in range(2):
                pushes = [motion + sign * step * np.eye(2)[k] for sign in (-1, 1)]
                angles, sizes = (
                    [np.arctan2(*push[::-1]) for push in pushes],
                    map(np.hypot, *zip(*pushes, strict=True)),
                )
                expected = difference([scene] * 2, angles, list(sizes), solution, step)
                columns.append((expected, by.twist_by_motion[:, k], by.force_by_motion[:, k]))
            for number, effect in enumerate(scene.effects):
                scenes = [changed(scene, number, 1 + sign * step) for sign in (-1, 1)]
                expected = difference(scenes, [angle] * 2, [size] * 2, solution, step)
                unit = 1.0 if isinstance(effect, pp.Load) else strength_of(effect)
                columns.append(
                    (
                        expected,
                        unit * by.twist_by_strength[:, number],
                        unit * by.force_by_strength[:, number],
                    )
                )
            if isinstance(scene.contact, pp.Coulomb) and scene.contact.friction_coefficient > 0:
                scenes = [changed(scene, -1, 1 + sign * step) for sign in (-1, 1)]
                expected = difference(scenes, [angle] * 2, [size] * 2, solution, step)
                mu = scene.contact.friction_coefficient
                columns.append((expected, mu * by.twist_by_mu, mu * by.force_by_mu))
            for expected, twist, force in columns:
                if expected is not None:
                    compared[solution.flush] += 1
                    largest = 1 + np.abs(expected).max()
                    assert np.concatenate([twist, force]) == pytest.approx(
                        expected, abs=1e-5 * largest
                    ), seed
    assert min(compared.values()) > 400


def test_a_side_without_a_force_at_one_end_changes_its_mode():
    """Pushed through its end, the table turns about it or not, whichever way the push turns."""
    scene = side((pp.SupportFriction(support=SQUARE),), pp.Coulomb(1.0), ends=(0.0, 1.0))
    (stick,) = pp.solve(scene, np.pi / 2, derivatives=True)
    assert stick.flush
    assert stick.end_forces[1, 0, 1] == 0.0
    assert stick.derivatives.status is pp.Smoothness.CHANGE


@pytest.mark.parametrize("magnitude", [0.01, 0.3, 1.0, 3.0])
def test_a_force_along_the_fence_that_rubs_at_rest_is_no_slip(magnitude):
    """Feet on the fence's line under infinite friction, and a mass above, which no slip could turn."""
    feet = pp.SupportFriction(support=pp.Points([(-1, 0), (0, 0), (1, 0)]))
    scene = pp.scene_at(
        side=0, effects=(feet, pp.Inertia(center=(0, 1))), contact=pp.InfiniteFriction(),
        outline=[(-1, 0), (1, 0), (1, 2), (-1, 2)],
    )  # fmt: skip
    solutions = pp.solve(scene, 0.0, magnitude)
    assert [(each.mode, each.flush) for each in solutions] == [(SEPARATE, False), (STICK, False)]
