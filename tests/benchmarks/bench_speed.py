"""How fast: ratios of times in one run, against the bars of the project. Run by `make bench`.

The floor of an element is what its wrench cannot do without, SciPy's `ellipe` and `ellipkm1`, on an array
of as many spin ratios; that of one scene is the same pair of one number.
"""

from __future__ import annotations

import subprocess
import sys
import time

import numpy as np
import pytest
from scipy.special import ellipe, ellipkm1

import planar_pushing as pp
from planar_pushing.mechanics.force.wrench import ring_profile, ring_spin_ratios
from planar_pushing.mechanics.kernels.arrays import CORES
from planar_pushing.mechanics.pressure.table import moments, table_of_pieces

pytestmark = pytest.mark.benchmark(timer=time.process_time)
COUNT = 10**6
RANDOM = np.random.default_rng(0)
FRICTION = (pp.RingFriction(),)
INERTIA = (pp.Inertia(),)
EFFECT_SETS = {"friction": FRICTION, "inertia": INERTIA, "both": FRICTION + INERTIA}
#: Ratios that a call may take; beyond twice as much the bench fails.
WRENCH, INVERSE, EDGE, SOLVE = 1.2, 3.0, 6.0, 500.0
DIRECTIONS = {"spin_ratio": 6.0, "motion_angle": 8.0}
#: A simulation with 101 samples, and a scene of a batch of ten thousand, in scalar pairs; the time of
#: two cores as a part of that of one.
SIMULATE, BATCH, TWO_CORES = 16_000.0, 650.0, 1 / 1.8
#: Nanoseconds of an element of the floor where the bars of supports were set; an element of D, G and T may
#: take this many nanoseconds for each point, for each edge of a polygon near by, and of one far away.
FLOOR, POINT, SIDE, FAR = 24.0, 5.0, 40.0, 2000.0
#: Nanoseconds of a solve in an array, where an element of the floor takes its own: with the ring, on feet,
#: and with any other support; and 1e5 quadrilaterals, in seconds.
RING, FEET, OTHER, QUADRILATERALS = 12_000.0, 60_000.0, 200_000.0, 10.0
#: A new contact of a known object, in solves of a known scene; objects on a box that is their outline.
NEW_CONTACT = 10.0
#: Two contacts in an array, in solves of one of them.
PAIR = 4.0
BOX = [(-0.4, -0.25), (0.4, -0.25), (0.4, 0.25), (-0.4, 0.25)]
OBJECTS = {
    "box": pp.Polygon(BOX),
    "T": pp.Polygon([
        (-0.4, 0.1), (-0.1, 0.1), (-0.1, -0.25), (0.1, -0.25), (0.1, 0.1), (0.4, 0.1), (0.4, 0.25),
        (-0.4, 0.25),
    ]),
    "disc": pp.Disc(0.25),
    "ring": pp.Ring(0.25),
    "feet": pp.Points.rectangle(0.7, 0.4),
    "map": pp.PressureMap(
        np.linspace(-0.4, 0.4, 9), np.linspace(-0.25, 0.25, 7), RANDOM.uniform(1.0, 2.0, (6, 8))
    ),
}  # fmt: skip
ARRAYS = {
    "even in direction": np.tan(RANDOM.uniform(0, np.pi / 2, COUNT)),
    "uniform in [0, 2]": RANDOM.uniform(0, 2, COUNT),
    "logarithmic over six decades": 10 ** RANDOM.uniform(-3, 3, COUNT),
    "next to the ring": RANDOM.uniform(0.9, 1.1, COUNT),
}
#: In a new process, the package is imported and makes one call; the seconds of the processor for both.
FIRST_CALL = """
import time
import planar_pushing as pp
slider = pp.Slider(rod_length=2.0, rod_angle=0.8)
scene = pp.Scene(slider=slider, contact=pp.Coulomb(1.0), effects=(pp.RingFriction(),))
{call}
print(time.process_time())
"""
#: The calls, and the seconds that may be taken.
FIRST = {
    "solve": ("pp.solve(scene, 1.0)", 1.0),
    "simulate": ("pp.simulate(scene, pusher=pp.Pusher(velocity=(0.0, 1.0)), duration=1.0)", 1.6),
}


@pytest.fixture(autouse=True)
def one_core():
    use(1)


def use(cores):
    """Let calls run on as many cores."""
    CORES.set(cores)


def two_integrals(k):
    inner = np.minimum(k, 1 / k) ** 2
    return lambda: (ellipe(inner), ellipkm1(inner))


def scalar_pairs(count):
    def floor():
        for _ in range(count):
            ellipe(0.3), ellipkm1(0.7)

    return floor


def scenes(effects, count):
    """As many scenes, every one another."""
    found = []
    if effects != INERTIA:
        found.append(pp.RingFriction(weight=10 ** RANDOM.uniform(-1, 1, count)))
    if effects != FRICTION:
        found.append(pp.Inertia(gyration_radius=10 ** RANDOM.uniform(-1, 1, count)))
    slider = pp.Slider(
        rod_length=10 ** RANDOM.uniform(-1, 1, count), rod_angle=RANDOM.uniform(0.1, 3.0, count)
    )
    law = pp.Coulomb(10 ** RANDOM.uniform(-1, 1, count))
    return pp.Scene(slider=slider, contact=law, effects=tuple(found))


@pytest.mark.parametrize("name", ARRAYS)
def test_wrench(ratio, name):
    k = ARRAYS[name]
    ratio(lambda: ring_profile(k), two_integrals(k), WRENCH)


@pytest.mark.parametrize("name", ARRAYS)
def test_inverse_of_the_moment_arm(ratio, name):
    force, torque = ring_profile(ARRAYS[name])
    arm = torque / force
    ratio(lambda: ring_spin_ratios(arm), two_integrals(ARRAYS[name]), INVERSE, rounds=15)


@pytest.mark.parametrize("name", DIRECTIONS)
def test_directions_of_a_million_forces(ratio, name):
    scene = pp.Scene(
        slider=pp.Slider(rod_length=2.0, rod_angle=0.8),
        contact=pp.PerfectlyRough(),
        effects=FRICTION,
    )
    angle, function = RANDOM.uniform(-np.pi, np.pi, COUNT), getattr(pp, name)
    floor = two_integrals(ARRAYS["even in direction"])
    ratio(lambda: function(scene, angle), floor, DIRECTIONS[name], rounds=10)


@pytest.mark.parametrize("effects", ["friction", "inertia"])
def test_edge_of_a_motion_cone(ratio, effects):
    """Both edges of half a million cones."""
    every = scenes(EFFECT_SETS[effects], COUNT // 2)
    floor = two_integrals(ARRAYS["even in direction"])
    ratio(lambda: pp.motion_cone(every), floor, EDGE, rounds=10)


@pytest.mark.parametrize("effects", EFFECT_SETS)
def test_solve_one_scene(ratio, effects):
    slider = pp.Slider(rod_length=2.0, rod_angle=np.pi / 4)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(1.4), effects=EFFECT_SETS[effects])
    angles = np.linspace(-0.3, 3.0, 200).tolist()

    def candidate():
        for angle in angles:
            pp.solve(scene, angle)

    ratio(candidate, scalar_pairs(20_000), SOLVE, scale=20_000 / len(angles), rounds=10)


@pytest.mark.parametrize("effects", ["friction", "both"])
@pytest.mark.parametrize("outline", [None, BOX])
@pytest.mark.parametrize("name", OBJECTS)
def test_new_contact_of_an_object(ratio, name, outline, effects):
    """`scene_at` and the first `solve`, as a multiple of a `solve` of a scene that was solved before."""
    count, y = 200, BOX[0][1]
    acting = [pp.SupportFriction(support=OBJECTS[name], weight=2.0)]
    acting += [pp.Inertia(gyration_radius=0.2)] if effects == "both" else []
    law, normal = pp.Coulomb(0.3), None if outline else (0.0, 1.0)
    fresh = iter(RANDOM.uniform(-0.38, 0.38, 100 * count).tolist())

    def contact(x):
        scene = pp.scene_at((x, y), normal, effects=acting, contact=law, outline=outline)
        pp.solve(scene, 1.3, 0.5)
        return scene

    known = [contact(next(fresh)) for _ in range(count)]
    ratio(
        lambda: [contact(next(fresh)) for _ in range(count)],
        lambda: [pp.solve(scene, 1.3, 0.5) for scene in known],
        NEW_CONTACT,
        rounds=10,
    )


@pytest.mark.parametrize("effects", ["friction", "both"])
@pytest.mark.parametrize("name", ["box", "T", "disc", "feet"])
def test_two_contacts_in_an_array(ratio, name, effects):
    """A finger and a wall, as a multiple of `solve` for the finger alone."""
    angle = RANDOM.uniform(-1.3, 1.3, 4000)
    acting = [pp.SupportFriction(support=OBJECTS[name], weight=2.0)]
    acting += [pp.Inertia(gyration_radius=0.2)] if effects == "both" else []
    law, velocity = pp.Coulomb(0.3), (np.cos(angle), np.sin(angle))
    finger = pp.Contact((-0.4, 0.15), (1.0, 0.0), law=law, velocity=velocity)
    wall = pp.Contact((0.1, -0.25), (0.0, 1.0), law=law)
    scene = pp.scene_at((-0.4, 0.15), (1.0, 0.0), effects=acting, contact=law)
    ratio(
        lambda: pp.solve_contacts([finger, wall], effects=acting),
        lambda: pp.solve(scene, np.pi / 2 - angle),
        PAIR,
        rounds=10,
    )


@pytest.mark.parametrize("effects", EFFECT_SETS)
def test_modes_of_a_million_scenes(ratio, effects):
    every = scenes(EFFECT_SETS[effects], COUNT)
    angle, size = RANDOM.uniform(-np.pi, np.pi, COUNT), 10 ** RANDOM.uniform(-1, 1, COUNT)
    floor = two_integrals(ARRAYS["even in direction"])
    ratio(lambda: pp.solve(every, angle, size), floor, RING / FLOOR, rounds=3)


@pytest.mark.parametrize("effects", ["friction", "inertia"])
def test_simulate_a_scene(ratio, effects):
    slider = pp.Slider(rod_length=2.0, rod_angle=np.pi / 4)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(1.4), effects=EFFECT_SETS[effects])
    pusher = pp.Pusher(velocity=(0.3, 1.0))
    floor = scalar_pairs(20_000)
    ratio(
        lambda: pp.simulate(scene, pusher=pusher, duration=2.0),
        floor,
        SIMULATE,
        scale=20_000,
        rounds=10,
    )


def around(count):
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
    return np.stack([np.cos(angle), np.sin(angle)], axis=-1)


ELEMENTS = {
    **{
        f"{n} points": (pp.Points(around(n), np.ones(n)), (0.0, 1.2), n * POINT)
        for n in (8, 64, 512)
    },
    **{f"{n} edges near by": (pp.Polygon(around(n)), (0.0, 1.2), n * SIDE) for n in (4, 16, 64)},
    **{f"{n} edges far away": (pp.Polygon(around(n)), (1.8, 6.0), FAR) for n in (4, 64)},
}


@pytest.mark.parametrize("name", ELEMENTS)
def test_element_of_a_support(ratio, name):
    support, (nearest, farthest), bar = ELEMENTS[name]
    count, table = COUNT // 10, table_of_pieces(support.pieces(), 1.0)
    angle, away = RANDOM.uniform(0, 2 * np.pi, count), RANDOM.uniform(nearest, farthest, count)
    x, y = away * np.cos(angle), away * np.sin(angle)
    floor = two_integrals(ARRAYS["even in direction"])
    ratio(lambda: moments(table, x, y), floor, bar / FLOOR, scale=COUNT / count, rounds=10)


SOLVED = {
    "square": pp.Polygon(around(4)),
    "tripod": pp.Points(around(3), np.ones(3)),
    "disc": pp.Disc(1.0, (0.2, 0.1)),
    "L": pp.Polygon(
        [(-0.7, -0.7), (0.7, -0.7), (0.7, -0.2), (-0.2, -0.2), (-0.2, 0.7), (-0.7, 0.7)]
    ),
    "hexagon without symmetry": pp.Polygon(
        [(1.0, 0.1), (0.4, 0.8), (-0.6, 0.9), (-0.9, -0.2), (-0.3, -0.8), (0.5, -0.6)]
    ),
}


@pytest.mark.parametrize("name", SOLVED)
@pytest.mark.parametrize("effects", ["friction", "both"])
def test_modes_with_any_support(ratio, effects, name):
    count, support = COUNT // 100, SOLVED[name]
    every = scenes(EFFECT_SETS[effects], count)
    friction = pp.SupportFriction(support=support, weight=every.effects[0].weight)
    slider = pp.Slider(
        rod_length=every.slider.rod_length, rod_angle=every.slider.rod_angle, radius=1.0
    )
    other = pp.Scene(slider=slider, contact=every.contact, effects=(friction, *every.effects[1:]))
    angle, size = RANDOM.uniform(-np.pi, np.pi, count), 10 ** RANDOM.uniform(-1, 1, count)
    bar, floor = FEET if name == "tripod" else OTHER, two_integrals(ARRAYS["even in direction"])
    ratio(lambda: pp.solve(other, angle, size), floor, bar / FLOOR, scale=COUNT / count, rounds=3)


def quadrilaterals(count):
    """Solutions of scenes with a quadrilateral each, the making of the scenes included."""
    angle = (np.arange(4) + RANDOM.uniform(0, 0.8, (count, 4))) * np.pi / 2
    away = RANDOM.uniform(0.4, 1.0, (count, 4))
    supports = np.empty(count, dtype=object)
    corners = np.stack([away * np.cos(angle), away * np.sin(angle)], axis=-1)
    supports[:] = [pp.Polygon(each) for each in corners]
    slider = pp.Slider(rod_length=1.0, rod_angle=RANDOM.uniform(0.5, 2.5, count))
    effects = (pp.SupportFriction(support=supports),)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(0.5), effects=effects)
    return pp.solve(scene, RANDOM.uniform(0, np.pi, count))


def test_quadrilaterals_in_seconds(ratio):
    """The time of 1e5 of them on two cores, as a ratio to one second."""
    use(2)
    quadrilaterals(10)
    start = time.perf_counter()
    ratio.benchmark.pedantic(lambda: quadrilaterals(100_000), rounds=1)
    ratio.write(time.perf_counter() - start, QUADRILATERALS)


def batch():
    """Ten thousand scenes of friction, each another."""
    count = 10_000
    angle = RANDOM.uniform(0.3, np.pi - 0.3, count)
    slider = pp.Slider(
        rod_length=RANDOM.uniform(0.5, 3.0, count), rod_angle=RANDOM.uniform(0.5, 2.5, count)
    )
    law = pp.Coulomb(RANDOM.uniform(0.2, 2.0, count))
    scenes = pp.Scene(slider=slider, contact=law, effects=(pp.RingFriction(),))
    pusher = pp.Pusher(velocity=(np.cos(angle), np.sin(angle)))
    return pp.simulate_batch(scenes, pusher, duration=2.0)


def test_batch_of_scenes(ratio):
    ratio(batch, scalar_pairs(20_000), BATCH, scale=2.0, rounds=3)


def test_batch_on_two_cores(ratio):
    def run(cores):
        use(cores)
        start = time.perf_counter()
        batch()
        return time.perf_counter() - start

    run(1)
    ratio.benchmark.pedantic(lambda: run(2), rounds=1)
    ratio.write(min(run(2) for _ in range(3)) / min(run(1) for _ in range(3)), TWO_CORES)


@pytest.mark.parametrize("name", FIRST)
def test_import_and_first_call(ratio, name):
    """The ratio is to one second."""
    call, bar = FIRST[name]

    def run():
        code = FIRST_CALL.format(call=call)
        found = subprocess.run(
            [sys.executable, "-c", code], check=True, capture_output=True, text=True
        )
        return float(found.stdout)

    run()
    ratio.benchmark.pedantic(run, rounds=3)
    ratio.write(min(run() for _ in range(3)), bar)
