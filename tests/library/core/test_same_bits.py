"""Compiled kernels and their plain source give the same numbers, to the last bit, on hard problems.

Python raises an error where C divides by zero, takes a root or a logarithm of a bad number, or rounds what
is no number to an integer: none of the problems may do so.
"""

from __future__ import annotations

import contextlib
import itertools
from dataclasses import replace

import numpy as np
import pytest
from core.hard_scenes import hard_pushes, hard_scene
from core.test_polygons import RINGS, rows_of
from mechanics.supports.cases import SUPPORTS, hard_centers

import planar_pushing as pp
from planar_pushing.core.instant.kernels import CONSISTENT, CONTINUA, NONE, NOT_SOLVED, PIVOTS
from planar_pushing.mechanics.force.limit_curve import curve_of_unit_motions
from planar_pushing.mechanics.kernels import calls as kernels
from planar_pushing.mechanics.pressure.table import extents_of, moments, table_of, table_of_pieces

#: Numbers at which functions of one number change their branch, and their neighbors.
NUMBERS = [0.0, 5e-324, 1e-300, 1e-9, 0.1, 0.7, 0.9, 1.0, 1.001, 30.0, 1e9, 1e160, 1e300, np.inf]
NUMBERS += [np.nextafter(x, x + side) for x in (0.7, 0.9, 1.0) for side in (-1, 1)]
NUMBERS = np.array([*NUMBERS, *np.negative(NUMBERS)])


def attempt(function, *arguments, **options):
    """Call a function of the mechanics, which refuses some of the scenes."""
    with contextlib.suppress(pp.InvalidValue):
        function(*arguments, **options)


def answer_everything(seed):
    """Pushes, cones, forces and derivatives of a scene."""
    scene, random = hard_scene(seed)
    steady = len({each.degree for each in scene.effects}) == 1
    # A cone over all magnitudes takes as long as hundreds of pushes.
    angle, magnitude = hard_pushes(scene, random, with_cone=steady or seed % 10 == 0)
    attempt(pp.solve, scene, angle, magnitude)
    attempt(pp.solve, scene, angle[-4:], magnitude[-4:], derivatives=True)
    force = np.array([0.0, np.pi / 2, random.uniform(-3, 3)])
    attempt(pp.motion_of_force, scene, force, derivatives=True)
    attempt(pp.motion_of_force, scene, force[1:], 10 ** random.uniform(-1, 3), derivatives=True)
    attempt(pp.spin_ratio, scene, force[2:])
    attempt(curve_of_unit_motions, scene, force[1:])


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
@pytest.mark.parametrize("part", [0, pytest.param(1, marks=pytest.mark.slow)])
def test_a_hundred_hard_scenes(both, part):
    for seed in range(60 * part, 60 * (part + 1)):
        answer_everything(seed)
    assert {*both.results} >= {"solve", "force_motions", "motion_cones", "load_ratios", "responses"}
    solved = np.concatenate([each[:, 0:2] for each in both.results["solve"]])
    assert len(solved) > 400
    # Every kind of answer occurs, and next to none is missing.
    status = solved[:, 1].tolist()
    assert {*status} >= {NONE, CONSISTENT, PIVOTS, CONTINUA}
    assert status.count(NOT_SOLVED) < 0.005 * len(status)
    assert {*solved[:, 0]} >= {0.0, 1.0, 2.0, 3.0}


@pytest.mark.parametrize(
    "law", [pp.InfiniteFriction("none"), pp.InfiniteFriction(), pp.Coulomb(0.0)]
)
def test_a_load_along_the_fence_without_friction(both, law):
    """The contact holds the slider by one force only, on the edge of the cone or next to it."""
    mass = pp.Inertia(center=(-0.5, 0.3), gyration_radius=0.5)
    for psi in (1e-300, np.pi / 2, 1.0):
        slider = pp.Slider(rod_length=1.0, rod_angle=psi)
        for force in [(1.0, 0.0), (-1.0, 0.0), (0.0, -1.0)]:
            load = pp.Load(force=force, center=(-1.0, 0.0))
            scene = pp.Scene(slider=slider, contact=law, effects=(mass, load))
            pp.solve(scene, np.array([0.0, np.pi / 2, -np.pi / 2, np.pi]), np.array([[1.0], [0.0]]))
    assert "solve" in both.results


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
@pytest.mark.parametrize(("seeds", "kinds"), [
    (range(1, 30, 3), {NONE, CONSISTENT, PIVOTS}),
    pytest.param([*range(0, 30, 3), *range(2, 30, 3)], {CONSISTENT}, marks=pytest.mark.slow),
], ids=["few", "others"])  # fmt: skip
def test_sides_on_the_fence(both, seeds, kinds):
    for seed in seeds:
        scene, random = hard_scene(seed)
        ends = -float(random.uniform(0.01, 2)), float(random.uniform(0.01, 2))
        slider = replace(scene.slider, side=ends, flush=True)
        angle, magnitude = hard_pushes(scene, random, with_cone=False)
        attempt(pp.solve, replace(scene, slider=slider), angle, magnitude)
        attempt(
            pp.solve,
            replace(scene, slider=slider),
            np.array([0.0, np.pi]),
            np.array([[0.0], [1.0]]),
        )
    solved = np.concatenate([each[:, 0:2] for each in both.results["solve_flush"]])
    status = solved[:, 1].tolist()
    assert {*status} >= kinds
    assert status.count(NOT_SOLVED) < 0.01 * len(status)


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::RuntimeWarning")
@pytest.mark.parametrize("part", range(5))
def test_five_hundred_hard_scenes(both, part):
    for seed in range(1000 + 100 * part, 1000 + 100 * (part + 1)):
        answer_everything(seed)


@pytest.mark.parametrize("name", SUPPORTS)
def test_moments_and_terms_of_every_support(both, name):
    support, _ = SUPPORTS[name]
    table = table_of_pieces(support.pieces(), support.extent)
    for c in hard_centers(support, 12) / support.extent:
        moments(table, *c)
    assert "moments" in both.results
    assert {"measure_supports", "store_pressures"} <= {*both.results}
    for kernel in ("plate_loads", "plate_terms"):
        assert (kernel in both.results) == bool(len(support.pieces().plates))


def test_pressures_of_many_supports(both):
    extents_of([support for support, _ in SUPPORTS.values()])
    table_of([support for support, _ in SUPPORTS.values()])
    assert {"plate_loads", "measure_supports", "store_pressures"} <= {*both.results}


def test_wrenches_at_twists_of_every_size(both):
    slider = pp.Slider(rod_length=1.0, rod_angle=1.0, radius=2.0)
    parts = (0.0, -0.0, 1.0, -0.3, 1e-9, 1e-160, 1e-300)
    twists = np.array([*itertools.product(parts, parts, parts)])
    effects = [pp.RingFriction(), pp.Inertia(center=(0.3, 0.1)), pp.Load(force=(0.3, -1.0))]
    effects += [pp.SupportFriction(support=each) for each, _ in SUPPORTS.values()]
    for effect in effects:
        pp.wrench(effect, twists, slider)
    assert "wrenches" in both.results


@pytest.mark.parametrize("name", ["ring_profiles", "ring_spin_ratios", "unit_vectors"])
def test_functions_of_one_number(both, name):
    random = np.random.default_rng(1)
    values = np.concatenate([NUMBERS, 10 ** random.uniform(-3, 3, 500), random.uniform(0, 1, 500)])
    if name == "unit_vectors":
        quarters = np.arange(-8, 9) * (np.pi / 2)
        values = np.concatenate([*(np.nextafter(quarters, x) for x in (-99, 99)), quarters, values])
        values = values[np.abs(values) < 1e9]
    kernels.run(name, (), values[:, None], 2 if name != "ring_spin_ratios" else 1)


def test_polygons(both):
    data, rows = np.concatenate(RINGS), rows_of(RINGS)
    kernels.run("polygon_area", data, rows, 1)
    kernels.run("crossing_edges", data, rows, 2)
    kernels.run("touching_edges", data, np.column_stack([rows[1:], rows[:-1]]), 2)
    assert len(both.results) == 3


def test_every_kernel_is_compared():
    """A new kernel needs a test here."""
    if kernels.COMPILED is None:
        pytest.skip("the core is not compiled, or PLANAR_PUSHING_PLAIN is set")
    assert {*kernels.COMPILED} == {
        "solve", "solve_flush", "force_motions", "motion_cones", "load_ratios", "responses", "wrenches",
        "unit_vectors", "moments", "plate_terms", "plate_loads",
        "measure_supports", "store_pressures", "ring_profiles", "ring_spin_ratios",
        "polygon_area", "crossing_edges", "touching_edges", "stretches_of_pieces",
        "run_events", "run_steps", "solve_contacts", "solve_gripped",
    }  # fmt: skip
