"""Rows of inputs: each number of a scene is where the core reads it, in the units of the core."""

import math
from dataclasses import replace

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.core.motion.kinematics import run
from planar_pushing.core.supports.rows import EFFECT, LAST, LOAD, MASS, RING, SUPPORT
from planar_pushing.mechanics.kernels.columns import Columns
from planar_pushing.mechanics.outline.places import DEPTH
from planar_pushing.simulation.inputs import Scenes, numbers_of
from planar_pushing.simulation.problem import Problem
from planar_pushing.terms.options import Method

BOX = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)]
EFFECTS = (
    pp.Load(force=(0.0, -0.3), center=(0.25, 0.5)),
    pp.RingFriction(weight=0.2),
    pp.Inertia(mass=3.0, gyration_radius=0.75, center=(0.1, -0.2)),
    pp.Viscous(support=pp.Ring(radius=0.25), coefficient=0.4),
    pp.SupportFriction(support=pp.Points(positions=[(1, 0), (-1, 0)]), weight=0.7),
)


def problem_of(effects=EFFECTS, **options):
    slider = pp.Slider(
        rod_length=1.0, rod_angle=np.pi / 2, radius=0.5, side=(-1.0, 0.75), outline=BOX
    )
    scene = pp.Scene(slider=slider, contact=pp.InfiniteFriction(), effects=effects)
    pusher = pp.Pusher(velocity=[(0, (0, 1)), (2, (3, 4))], shape="finger", radius=0.2)
    return Problem(scene=scene, pusher=pusher, duration=4.0, gap=0.3, rtol=1e-8, **options)


def inputs_of(problem, method=Method.EVENT_DRIVEN):
    data, numbers = numbers_of(problem, method)
    scenes = Scenes.of(problem, data, np.array([numbers], float))
    pieces, counts = scenes.pieces(slice(None))
    return data, scenes.rows(slice(None), pieces, counts, np.linspace(0, 4, 5)[None, None], True)[0]


def kinds_of(data):
    """Kinds of the effects, and their first columns."""
    # The pieces of the outline, with infinite radii, are behind them.
    places = range(0, np.flatnonzero(np.isinf(data))[0] - 1, EFFECT)
    entries = [data[place : place + 2].astype(int) for place in places]
    kinds = [int(kind) for kind, _ in entries]
    kinds = kinds[: kinds.index(LAST) + 1]
    return kinds, [int(column) for _, column in entries[: len(kinds)]]


def test_numbers_of_a_scene():
    data, row = inputs_of(problem_of(twist=(0.5, -1.0, 2.0)))
    kinds, columns = kinds_of(data)
    assert kinds == [SUPPORT, RING, MASS, MASS, LOAD, LAST]
    effects, scene = row[: columns[-1]], row[columns[-1] :]
    unit = 0.5  # a power of two, of the weight 0.7
    assert effects[columns[1]] == 0.2 / unit
    assert effects[columns[2] : columns[3]] == pytest.approx([0.4 * 0.5 / unit, 0.25, 0, 0])
    assert not effects[columns[3] :].any()
    chain = data[-88:].reshape(8, 11)
    sides = np.flatnonzero(np.isinf(chain[:, 2]))
    corners = chain[sides, :2] * 2 * DEPTH
    assert sorted(map(tuple, corners.round(9))) == sorted(BOX)
    # The contact is at the middle of the side that goes down from the upper left corner.
    wall = sides[np.hypot(*(corners - (-1, 1)).T).argmin()]
    first = chain[wall, 3]
    expected = {
        "weight": 0.9 / unit, "mass": 1.5 / unit, "gyration": 2.25, "center": [0.2, -0.4],
        "load": [-0.3 / unit, 0.0], "cross": 0.3 / unit, "dot": -0.15 / unit, "length": 2.0,
        "angle": np.pi / 2, "right": 0.0, "left": np.pi, "slips": 1.0, "closed": 1.0, "rough": 0.0,
        "twist": [1.0, -2.0, 2.0], "gap": 0.6, "finger": 1.0, "radius": 0.4, "side_start": -2.0,
        "side_end": 1.5, "fine": 0.5 / (2 * DEPTH), "chain": 8,
        "chain_place": len(data) - 88, "frame": [0.0, 0.0], "axis": [1.0, 0.0],
        "turn": first + np.pi / 2, "wall": wall, "place": 0.5 / DEPTH,
        "frictions": 2, "resisting": 3, "tolerance": 1e-8, "pieces": 2, "coefficients": 1,
        "times": 5, "logs_events": 1, "flush": 0,
    }  # fmt: skip
    assert {*expected} == {*run.Inputs.places}
    for name, number in expected.items():
        assert scene[run.Inputs.places[name]] == pytest.approx(number, rel=1e-14, abs=1e-16), name
    assert scene[run.INPUTS :][:5].tolist() == [0, 1, 2, 3, 4]


@pytest.mark.parametrize("effects", [EFFECTS[1:3], EFFECTS[3:4], EFFECTS[2:3]])
@pytest.mark.parametrize("factor", [1.0, 3.0, 1e-200, 1e200])
def test_forces_are_in_units_of_a_power_of_two(effects, factor):
    """Those of friction, otherwise of viscous friction, otherwise of the mass; others stay as they are."""
    slider = pp.Slider(rod_length=1.0, rod_angle=1.0)
    names = {pp.RingFriction: "weight", pp.Inertia: "mass", pp.Viscous: "coefficient"}
    scaled = tuple(
        replace(effect, **{name: factor * getattr(effect, name)})
        for effect in effects
        for name in [names[type(effect)]]
    )
    rows = []
    for each in (effects, scaled):
        scene = pp.Scene(slider=slider, contact=pp.Coulomb(0.5), effects=each)
        problem = Problem(scene=scene, pusher=pp.Pusher(velocity=(0, 1)), duration=1.0)
        data, numbers = numbers_of(problem)
        scenes = Scenes.of(problem, data, np.array([numbers], float))
        assert math.frexp(scenes.force[0])[0] == 0.5
        rows.append(scenes.inputs[0] * 1.0)
        first = next(number for number in rows[-1] if number)
        assert 1 <= first < 2
    if factor == 1.0:
        assert (rows[0] == rows[1]).all()


def test_pieces_follow_the_times():
    _, row = inputs_of(problem_of())
    width = run.PIECE + run.SERIES_OF_PIECE
    pieces = row[-2 * width :].reshape(2, width)
    columns = Columns(run.PusherPiece, pieces)
    assert columns.start.tolist() == [0, 2]
    assert columns.end.tolist() == [2, 4]
    assert columns.origin[1].tolist() == [0, 4]
    assert pieces[1, run.PIECE :].tolist() == [6, 8, 0, 0, 6, 8]


@pytest.mark.parametrize(("effects", "kinds"), [
    (EFFECTS[1:2], [RING, LAST]), (EFFECTS[2:3], [MASS, LOAD, LAST]),
    (EFFECTS[1:3], [RING, MASS, LOAD, LAST]), (EFFECTS[1:4:2], [RING, MASS, LAST]),
], ids=["friction", "inertia", "both", "viscous"])  # fmt: skip
def test_momentum_is_a_load_in_a_step(effects, kinds):
    data, _ = inputs_of(problem_of(effects), Method.TIME_STEPPING)
    assert kinds_of(data)[0] == kinds
    events = [kind for kind in kinds if kind != LOAD]
    assert kinds_of(inputs_of(problem_of(effects))[0])[0] == events
