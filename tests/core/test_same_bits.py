"""The compiled core and its plain source give the same numbers to the last bit."""

import math

import numpy as np
import pytest

import planar_pushing as pp
from core.both_forms import BothForms
from mechanics import degenerate
from planar_pushing.mechanics import kernels
from planar_pushing.mechanics.limit_curve import curve_of_unit_motions
from planar_pushing.mechanics.supports.moments import moments
from planar_pushing.mechanics.supports.pressure.table import table_of
from planar_pushing.mechanics.wrench import ring_profile, ring_spin_ratios

pytestmark = pytest.mark.skipif(
    kernels.COMPILED is None, reason="the core is not compiled: make compiles it"
)

LENGTHS = (0.0, 1e-9, 0.5, 1.0, 2.0, 1e3, 1e6)
ROD_ANGLES = (
    math.pi / 4, math.pi / 2, 3 * math.pi / 4, 1.0, 1e-12, 1e-300, math.nextafter(math.pi, 0),
    math.nextafter(math.pi / 2, 0),
)  # fmt: skip
LAWS = (
    pp.Coulomb(0.0), pp.Coulomb(1e-12), pp.Coulomb(0.5), pp.Coulomb(1.0), pp.Coulomb(1e9),
    pp.InfiniteFriction(), pp.InfiniteFriction("none"), pp.PerfectlyRough(),
)  # fmt: skip
WITH_HOLE = pp.Polygon(
    [(-1, -1), (1.2, -1), (1, 1), (-0.9, 0.7)], [[(-0.7, -0.8), (0.2, -0.6), (-0.6, 0.3)]]
)
#: Directions along the fence, normal to it, and next to both.
FENCE = (
    0.0, math.pi, math.pi / 2, -math.pi / 2, -math.pi, 1e-300, -1e-300, 5e-324, -5e-324,
    math.nextafter(math.pi, 0), math.nextafter(-math.pi, 0),
)  # fmt: skip


def random_support(rng, length, psi):
    kind = rng.integers(12)
    if kind < 2:
        return degenerate.feet_of_contact(rng, min(length, 2.0), psi)
    if kind < 4:
        return degenerate.symmetric_feet(rng)
    if kind == 4:  # feet on one line through the contact
        turn, places = rng.uniform(0, 3.1), np.cumsum(rng.uniform(0.1, 1, rng.integers(2, 5))) - 1
        direction = np.array([math.cos(turn), math.sin(turn)])
        loads = rng.integers(1, 4, len(places))
        return pp.Points(np.array([-length, 0]) + places[:, None] * direction, loads)
    if kind == 5:  # feet at one place, or next to it
        places, gap = rng.normal(size=(3, 2)), rng.choice([0.0, 1e-300, 1e-16, 1e-9, 1e-5])
        places = np.concatenate([places, places[:1] + np.array([gap, 0.0])])
        return pp.Points(places, rng.uniform(0.2, 1, 4))
    if kind == 6:
        return degenerate.SYMMETRIC[rng.choice(list(degenerate.SYMMETRIC))]
    if kind == 7:
        return WITH_HOLE
    if kind == 8:
        return pp.Annulus(rng.choice([0.1, 0.999999]), 1.0, tuple(rng.choice([0.0, 1.0], 2)))
    if kind == 9:
        return pp.Segment((-length, 0.0), (1 - length, rng.choice([0.0, 1e-12, 1.0])))
    return degenerate.random_support(rng)


def random_effects(rng, length, psi):
    def friction():
        support = random_support(rng, length, psi)
        return pp.SupportFriction(support=support, weight=float(10 ** rng.uniform(-3, 3)))

    def inertia():
        center = rng.choice([0.0, 0.5, -length]), rng.choice([0.0, 0.5])
        radius = float(rng.choice([1.0, 1e-3, 10 ** rng.uniform(-3, 3)]))
        return pp.Inertia(
            mass=float(10 ** rng.uniform(-3, 3)), gyration_radius=radius, center=center
        )

    kinds = (
        (friction,), (friction,), (friction, friction), (friction, inertia), (inertia,),
        (pp.RingFriction,), (pp.RingFriction, inertia), (pp.RingFriction, friction),
    )  # fmt: skip
    effects = [make() for make in kinds[rng.integers(len(kinds))]]
    if rng.random() < 0.1:
        effects.append(pp.Viscous(support=random_support(rng, length, psi)))
    if rng.random() < 0.3:
        force = rng.choice([0.0, 0.3, -1.0, 1e-300], 2) * rng.choice([1.0, 10.0, 1e-6])
        effects.append(pp.Load(force=force, center=[None, (-length, 0.0)][rng.integers(2)]))
    return tuple(effects)


def random_scene(rng):
    length, psi = float(rng.choice(LENGTHS)), float(rng.choice(ROD_ANGLES))
    if rng.random() < 0.3:
        length, psi = float(10 ** rng.uniform(-2, 3)), float(rng.uniform(0.1, 3))
    slider = pp.Slider(rod_length=length, rod_angle=psi, radius=float(rng.choice([1.0, 1.7])))
    law = LAWS[rng.integers(len(LAWS))]
    return pp.Scene(slider=slider, contact=law, effects=random_effects(rng, length, psi))


def pushes_of(rng, scene):
    """Directions along the fence, at the edges of the motion cone, next to them, and anywhere."""
    cone = pp.motion_cone(scene)
    edges = [edge for edge in (cone.right, cone.left) if np.isfinite(edge)]
    beside = [edge + rng.choice([-1, 1]) * 10.0 ** rng.integers(-14, -3) for edge in edges]
    angles = [*rng.choice(FENCE, 2), *edges, *beside, rng.uniform(-np.pi, np.pi)]
    magnitudes = rng.choice([0.0, 1.0, 1.0, 10 ** rng.uniform(-6, 6)], len(angles))
    return np.array(angles), magnitudes


def ask_everything(seed):
    """Call all public functions of a scene; what is refused has not reached the core."""
    rng = np.random.default_rng([17, seed])
    try:
        scene = random_scene(rng)
        angles, magnitudes = pushes_of(rng, scene)
    except pp.InvalidValue:
        return
    phi = np.array([0.0, np.pi / 2, np.pi, rng.uniform(-3, 3)])
    for ask in (
        lambda: pp.solve(scene, angles, magnitudes, derivatives=True),
        lambda: curve_of_unit_motions(scene, phi),
        lambda: pp.spin_ratio(scene, phi),
        lambda: pp.motion_of_force(scene, phi, derivatives=True),
        lambda: pp.motion_of_force(scene, phi, float(10 ** rng.uniform(-1, 1)), derivatives=True),
    ):
        try:
            ask()
        except pp.InvalidValue:
            continue


@pytest.fixture
def both(monkeypatch):
    forms = BothForms(kernels.COMPILED)
    monkeypatch.setattr(kernels, "COMPILED", forms)
    return forms


@pytest.mark.parametrize(
    "seeds",
    [range(120), pytest.param(range(120, 1200), marks=pytest.mark.slow)],
    ids=["few", "all"],
)
def test_random_and_degenerate_scenes(both, seeds):
    for seed in seeds:
        ask_everything(seed)
    assert both.rows["solve"] > 4 * len(seeds)
    assert both.rows["responses"] > 4 * len(seeds)
    for name in ("force_motions", "motion_cones"):
        assert both.rows[name] > len(seeds) / 2
    # Every status is among them, and most pushes are solved.
    status = np.concatenate([results[:, 1] for results in both.results["solve"]]).astype(int)
    counts = np.bincount(status, minlength=5)
    assert (counts[:4] > 0).all()
    assert counts[4] < 0.01 * len(status)


def ask_about_supports(seed):
    """Call what takes a support, twists, or numbers of the ring."""
    rng = np.random.default_rng([3, seed])
    for support in degenerate.SYMMETRIC.values():
        table = table_of([support, pp.Polygon.rectangle(*rng.uniform(1, 2, 2))])
        centers = np.concatenate(
            [rng.normal(size=(20, 2)), 1e3 * rng.normal(size=(5, 2)), [[0, 0]]]
        )
        for number in (0, 1):
            moments(table, *centers.T, number)
        twists = np.concatenate([rng.normal(size=(9, 3)), np.eye(3), np.zeros((1, 3))])
        pp.wrench(pp.SupportFriction(support=support), twists)
    ring_profile(np.array([0.0, 1e-300, 0.3, 1.0, 1.0 + 1e-15, 7.0, np.inf, -np.inf, -1.0]))
    ring_spin_ratios(np.array([0.0, 1e-300, 0.3, 1.0, 1.0 + 1e-15, 7.0, 1e300, -1.0]))
    pp.Polygon([(0, 0), (3, 0), (0, 2), (0.1, 0.3)], [[(0.5, 0.5), (1, 0.5), (0.5, 1)]])
    with pytest.raises(pp.InvalidValue):
        pp.Polygon([(0, 0), (1, 1), (1, 0), (0, 1)])


def test_supports_wrenches_and_the_ring(both):
    ask_about_supports(0)
    names = {
        "moments", "plate_terms", "wrenches", "ring_profiles", "ring_spin_ratios", "polygon_area",
        "crossing_edges", "touching_edges",
    }  # fmt: skip
    assert names <= set(both.rows)


def test_every_kernel_is_compared(both):
    """A new kernel needs a call here."""
    held = pp.Load(force=(0.1, 0.0))
    slider = pp.Slider(rod_length=1.0, rod_angle=1.0)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(0.5), effects=(pp.RingFriction(), held))
    pp.solve(scene, 1.0)
    ask_about_supports(1)
    for seed in range(5):
        ask_everything(seed)
    assert set(both.rows) == set(both.compiled)
