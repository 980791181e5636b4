"""Whether a side stays on a fence that moves and rotates."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import brentq
from stability.flush import FEET, FREE, NONE, SCENES, SQUARE, Flush, push, random_scene, rub

import planar_pushing as pp

#: Radius of the twists around one that must all be as stable as it is for a comparison by trial, which
#: replaces an area by points.
BESIDE = 0.03
WAYS = np.concatenate([np.eye(3), -np.eye(3)])


@pytest.mark.parametrize(
    ("mu", "height", "first"),
    [(mu, 0.0, 0.67668264) for mu in (0.25, 0.5, 1.0)]
    + [(0.25, -1.0, 3.99601), (0.3, -1.0, 3.32718), (0.5, -1.0, 1.98471), (1.0, -1.0, 1.33934)],
)
def test_clockwise_centers_of_a_square(mu, height, first):
    scene = pp.scene_at(side=0, effects=(rub(SQUARE),), contact=pp.Coulomb(mu), outline=SQUARE)
    places = first + np.array([-1e-5, 1e-5, 1.0, 100.0])
    twists = np.array([push((x, height), -1.0) for x in places])
    assert pp.stable(scene, twists).tolist() == [False, True, True, True]


def clear(flush, twists):
    """The twists next to which stable pushes do not end, with their answers."""
    near = twists[:, None] + BESIDE * WAYS * np.linalg.norm(twists, axis=-1)[:, None, None]
    answer, around = pp.stable(flush.scene, twists), pp.stable(flush.scene, near)
    same = (around == answer[:, None]).all(axis=-1)
    return twists[same], answer[same]


@pytest.mark.parametrize("name", SCENES)
def test_stable_as_by_trial(name):
    rng, flush = np.random.default_rng(5), SCENES[name]
    grid = [push(c, s) for c in 3.0 * rng.uniform(-1, 1, (40, 2)) for s in (1.0, -1.0)]
    moves = [(np.cos(turn), np.sin(turn), 0.0) for turn in np.linspace(0.03, 6.25, 20)]
    twists, answers = clear(flush, np.array([*grid, *moves]))
    assert answers.tolist() == [flush.is_stable(each) for each in twists]
    few = "off the side" in name or flush.law in (pp.Coulomb(0), pp.PerfectlyRough())
    assert len(twists) > 40
    assert few or set(answers) == {True, False}


@pytest.mark.parametrize("scenes", [60, pytest.param(300, marks=pytest.mark.slow)])
def test_random_scenes_as_by_trial(scenes):
    rng, count = np.random.default_rng(1), 0
    for _ in range(scenes):
        flush = random_scene(rng)
        center, spin = np.array(flush.point), rng.normal(size=(8, 3))
        twists = np.array([push(center + c, 1.0) * s for *c, s in spin])
        twists, answers = clear(flush, twists)
        assert answers.tolist() == [flush.is_stable(each) for each in twists], flush
        count += answers.sum()
    assert count > scenes / 2


@pytest.mark.parametrize(
    "flush",
    [
        Flush(effects=(rub(FEET),), law=FREE),
        Flush(effects=(rub(FEET),), law=pp.Coulomb(3)),
        Flush(effects=(rub(FEET),), ends=(-3.0, 3.0), law=pp.Coulomb(2.0)),
        Flush(effects=(rub(pp.Points([(0, 0), (4, 3), (-4, 3), (3, 0)], (1, 1, 1, 1))),), ends=(-5, 5)),
        Flush(effects=(rub(pp.Points([(2, 0), (-1, 1), (-1, -1)], (0.1, 1, 1))),), law=pp.Coulomb(0.9)),
        Flush(effects=(rub(pp.Points([(2, 0), (-1, 1), (-1, -1)], (0.3, 1, 1))),), law=pp.Coulomb(0.9)),
        Flush(effects=(rub(pp.Points([(2, 0), (-1, 0), (1, 0)], (0.3, 1, 1))),)),
    ],
)  # fmt: skip
def test_about_a_foot_every_force_of_the_foot_must_be_in_the_cone(flush):
    support = flush.effects[0].support
    for foot in support.positions:
        for sense in (1.0, -1.0):
            twist = push(foot, sense)
            assert pp.stable(flush.scene, twist) == flush.is_stable(twist)
            # The motions next to it have the loads on the rim of the set.
            near = [push(np.add(foot, 1e-6 * way[:2]), sense) for way in WAYS[[0, 1, 3, 4]]]
            assert pp.stable(flush.scene, near).all() >= pp.stable(flush.scene, twist)


def test_a_light_foot_about_which_a_push_is_stable():
    feet = pp.Points([(2, 0), (-1, 1), (-1, -1)], (0.1, 1, 1))
    light = Flush(effects=(rub(feet),), law=pp.Coulomb(0.9), ends=(-2.0, 2.0))
    assert pp.stable(light.scene, push((2.0, 0.0), -1.0))
    assert not pp.stable(light.scene, push((2.0, 0.0), 1.0))


EXACT = {
    "straight ahead without friction": (pp.Coulomb(0), (0, 1, 0), True),
    "aside without friction": (pp.Coulomb(0), (1e-9, 1, 0), False),
    "at the edge of the cone": (pp.Coulomb(0.5), (0.5, 1, 0), True),
    "beyond the edge of the cone": (pp.Coulomb(0.5), (0.5 + 1e-9, 1, 0), False),
    "along the fence": (FREE, (1, 0, 0), False),
    "almost along the fence, beyond the end": (FREE, (1, 0.5, 0), False),
    "line of action through the end": (FREE, (-1, 1, 0), True),
    "line of action beyond the end": (FREE, (-1, 1 - 1e-9, 0), False),
    "through the end, definition 2": (NONE, (-1, 1, 0), True),
    "back": (FREE, (0, -1, 0), False),
    "back with adhesion": (pp.PerfectlyRough(), (0, -1, 0), True),
}


@pytest.mark.parametrize("name", EXACT)
@pytest.mark.parametrize("size", [1.0, 1e-150, 1e150])
@pytest.mark.parametrize("turn", [0.0, np.pi / 2, 0.3])
def test_on_an_edge(name, size, turn):
    law, twist, answer = EXACT[name]
    (c, s) = np.cos(turn), np.sin(turn)
    corners = [(c * x - s * y + 5, s * x + c * y) for x, y in SQUARE.vertices]
    flush = Flush(
        effects=(rub(pp.Polygon(corners), 7.0),), law=law, point=(5 + s, -c), normal=(-s, c)
    )
    x, y, omega = twist
    twist = size * np.array([c * x - s * y, s * x + c * y, omega])
    assert pp.stable(flush.scene, twist) is answer


def test_a_force_along_the_fence():
    """Both centers on the fence: definition 1 transmits it, definition 2 does not."""
    line = pp.Segment((-0.5, -1), (0.5, -1))
    for law, answer in ((FREE, True), (NONE, False)):
        assert pp.stable(Flush(effects=(rub(line),), law=law).scene, (1, 0, 0)) is answer


def test_viscous_friction_counts_by_its_speed():
    """Dry friction on the left and a film on the right: the line of action moves right with the speed."""
    dry, film = pp.Disc(0.5, (-2.0, 0.0)), pp.Disc(0.5, (2.0, 0.0))
    flush = Flush(effects=(rub(dry), pp.Viscous(support=film)), ends=(-1.0, 1.0))
    speeds = np.array([1e-3, 0.3, 0.5, 1.0, 2.0, 3.5, 1e3])
    answers = pp.stable(flush.scene, speeds[:, None] * [0.0, 1.0, 0.0])
    # The line of action is at (2 v - 2) / (v + 1).
    assert answers.tolist() == [abs(2 * v - 2) <= v + 1 for v in speeds]


def test_viscous_friction_alone_at_any_size():
    scene = SCENES["viscous"].scene
    twists = np.random.default_rng(2).normal(size=(200, 3))
    for size in (1e-200, 1e200):
        assert np.array_equal(pp.stable(scene, size * twists), pp.stable(scene, twists))


def test_a_ring_of_the_slider():
    """Without an object's frame, twists are about the slider's center, with x along the rod."""
    slider = pp.Slider(
        rod_length=2.0, rod_angle=np.pi / 3, radius=1.5, side=(-1.0, 3.0), flush=True
    )
    ring = pp.Scene(slider=slider, contact=pp.Coulomb(0.4), effects=(pp.RingFriction(weight=2.0),))
    same = replace(ring, effects=(rub(pp.Ring(1.5), 2.0),))
    away = pp.Scene(
        slider=slider, contact=pp.Coulomb(0.4), effects=(pp.SupportFriction(weight=2.0),)
    )
    twists = np.random.default_rng(3).normal(size=(500, 3))
    answers = pp.stable(ring, twists)
    assert 0 < answers.sum() < 500
    for other in (same, away):
        assert np.array_equal(pp.stable(other, twists), answers)

    loads = [pp.Load(force=(0.3, 0.5)), pp.Load(force=(0.3, 0.5), center=(0.0, 0.0))]
    loaded = [pp.stable(replace(ring, effects=(*ring.effects, each)), twists) for each in loads]
    assert np.array_equal(*loaded)
    assert not np.array_equal(loaded[0], answers)

    def first(x):
        twist = push((0.0, x), 1.0)
        return 1.0 if pp.stable(ring, twist) else -1.0

    # About a center on the body's y axis the force is along the rod, within the cone only for steep rods.
    assert first(3.0) == first(-3.0) == -1.0
    assert brentq(lambda mu: _steep(ring, mu), 0.5, 0.7) == pytest.approx(
        np.tan(np.pi / 6), abs=1e-9
    )


def _steep(scene, mu):
    return 1.0 if pp.stable(replace(scene, contact=pp.Coulomb(mu)), (1.0, 0.0, 0.0)) else -1.0


def test_shapes_and_numbers():
    scene = SCENES["square"].scene
    twists = np.random.default_rng(4).normal(size=(2, 3, 3))
    answers = pp.stable(scene, twists)
    assert answers.shape == (2, 3)
    assert answers.dtype == bool
    assert [[pp.stable(scene, each) for each in row] for row in twists] == answers.tolist()
    assert pp.stable(scene, np.float32([0, 1, 0])) is True
    assert pp.stable(scene, [np.int64(0), 1, 0]) is True
    assert pp.stable(scene, np.ones((0, 3))).shape == (0,)


BODY = pp.Slider(rod_length=1.0, rod_angle=1.0, side=(-1.0, 1.0))
ALONG = replace(BODY, flush=True)
SMALL = pp.SupportFriction(support=pp.Polygon.rectangle(1.2, 1.2))
WRONG = {
    "one point of contact": (
        pp.Scene(slider=BODY, contact=FREE, effects=(pp.RingFriction(),)), (0, 1, 0), "scene_at\\(side=",
    ),
    "an arc": (
        pp.scene_at((1, 0), effects=(SMALL,), contact=FREE, outline=pp.Disc(1.0)), (0, 1, 0),
        "scene_at\\(side=",
    ),
    "a corner": (
        pp.scene_at((-1, -1), (0.5, 1), effects=(rub(SQUARE),), contact=FREE, outline=SQUARE), (0, 1, 0),
        "scene_at\\(side=",
    ),
    "a straight place": (
        pp.scene_at((0, -1), effects=(SMALL,), contact=FREE, outline=pp.rounded(SQUARE, 0.3)),
        (0, 1, 0), "scene_at\\(side=",
    ),
    "inertia": (
        pp.Scene(slider=ALONG, contact=FREE, effects=(pp.RingFriction(), pp.Inertia())), (0, 1, 0),
        "leave Inertia out",
    ),
    "an array": (
        pp.Scene(slider=ALONG, contact=[FREE, NONE], effects=(pp.RingFriction(),)), (0, 1, 0), "one by one",
    ),
    "a heavy load": (
        pp.Scene(slider=ALONG, contact=FREE, effects=(pp.RingFriction(), pp.Load(force=(2, 0)))), (0, 1, 0),
        "what friction can hold",
    ),
    "no scene": (3, (0, 1, 0), "scene"),
    "rest": (SCENES["square"].scene, [(0, 1, 0), (0, 0, 0)], "twists that are not zero"),
    "rest, rough": (SCENES["square, rough"].scene, (0, 0, 0), "twists that are not zero"),
    "two numbers": (SCENES["square"].scene, (0, 1), "shape S \\+ \\(3,\\)"),
    "not finite": (SCENES["square"].scene, (0, np.nan, 1), "shape S \\+ \\(3,\\)"),
    "no numbers": (SCENES["square"].scene, "ahead", "shape S \\+ \\(3,\\)"),
}  # fmt: skip


@pytest.mark.parametrize("name", WRONG)
def test_refused_in_one_line(name):
    scene, twist, words = WRONG[name]
    with pytest.raises(pp.InvalidValue, match=words) as caught:
        pp.stable(scene, twist)
    assert "\n" not in str(caught.value)


def test_a_side_between_arcs_is_that_of_a_polygon_with_cut_corners():
    twists = np.random.default_rng(3).normal(size=(300, 3))
    law, effects = pp.Coulomb(0.4), (SMALL,)
    corners = [
        (-0.7, -1),
        (0.7, -1),
        (1, -0.7),
        (1, 0.7),
        (0.7, 1),
        (-0.7, 1),
        (-1, 0.7),
        (-1, -0.7),
    ]
    for number in range(4):
        one, other = (
            pp.scene_at(side=side, effects=effects, contact=law, outline=outline)
            for side, outline in ((number, pp.rounded(SQUARE, 0.3)), (2 * number, corners))
        )
        answer = pp.stable(one, twists)
        assert answer.tolist() == pp.stable(other, twists).tolist()
        assert 0 < answer.sum() < 300
        curves = [pp.stable_centers(scene).curves for scene in (one, other)]
        assert [curve.bound for curve in curves[0]] == [curve.bound for curve in curves[1]]


def test_an_outline_without_sides_has_none_on_a_fence():
    with pytest.raises(
        pp.InvalidValue, match="an outline with sides; push a round object at a point"
    ):
        pp.scene_at(side=0, effects=(SMALL,), contact=FREE, outline=pp.Disc(1.0))
    with pytest.raises(
        pp.InvalidValue, match="from 0 to 3; count the sides from 0, without the arcs"
    ):
        pp.scene_at(side=4, effects=(SMALL,), contact=FREE, outline=pp.rounded(SQUARE, 0.3))
