"""Calls whose arguments do not fit: the sentence says what was given, what is allowed, and what to do."""

import inspect
import pickle

import pytest

import planar_pushing as pp

BOX = pp.Polygon.rectangle(0.3, 0.2)
SCENE = pp.scene_at(
    (0.1, -0.1), effects=(pp.SupportFriction(support=BOX),), contact=pp.Coulomb(0.5), outline=BOX
)
FENCE = pp.Pusher(velocity=(0.0, 0.05))
FINGER = pp.Pusher(velocity=(0.0, 0.05), shape="finger")
ONE = "name the rest, as in"
WRONG = {
    f"simulate: 3 arguments without a name given; allowed: scene, pusher; {ONE} duration=2": (
        lambda: pp.simulate(SCENE, FENCE, 2)
    ),
    "simulate: no duration given; allowed: scene, pusher, duration": (
        lambda: pp.simulate(SCENE, FENCE)
    ),
    "simulate: durations=2 given; allowed: scene, pusher, duration": (
        lambda: pp.simulate(SCENE, FENCE, durations=2)
    ),
    "did you mean duration?": lambda: pp.simulate(SCENE, FENCE, durations=2),
    "mass=1.2 given; allowed: support, weight; give weight=pp.weight(mass, support_friction)": (
        lambda: pp.SupportFriction(mass=1.2)
    ),
    f"2 arguments without a name given; allowed: none; {ONE} mass=2.0, gyration_radius=0.1": (
        lambda: pp.Inertia(2.0, 0.1)
    ),
    "Coulomb: no friction_coefficient given; allowed: friction_coefficient; give": pp.Coulomb,
    "2 arguments without a name given; allowed: friction_coefficient; leave out the rest": (
        lambda: pp.Coulomb(0.5, 0.5)
    ),
    f"4 arguments without a name given; allowed: scene, pusher_angle, pusher_magnitude; {ONE} der": (
        lambda: pp.solve(SCENE, 1.0, 0.1, True)
    ),
    "Polygon.rectangle: 5 arguments without a name given; allowed: width, height, center, angle; lea": (
        lambda: pp.Polygon.rectangle(0.3, 0.2, (0, 0), 0.1, 0.2)
    ),
    "Points.regular: corner=1 given; allowed: ": lambda: pp.Points.regular(3, 1.0, corner=1),
    "Outline.ellipse: no a given; allowed: a, b, arcs; give a=...": lambda: pp.Outline.ellipse(),
    "Outline: 3 arguments without a name given; allowed: ": lambda: pp.Outline([], [], []),
    "Pusher.velocity_at: no time given; allowed: time; give time=...": FENCE.velocity_at,
    "solve: scene given twice; allowed: once; leave out scene=": (
        lambda: pp.solve(SCENE, scene=SCENE)
    ),
}


@pytest.mark.parametrize("sentence", WRONG)
def test_a_wrong_call_says_what_to_do(sentence):
    with pytest.raises(pp.InvalidCall) as refused:
        WRONG[sentence]()
    assert sentence in str(refused.value)
    assert "\n" not in str(refused.value)
    assert isinstance(refused.value, TypeError)


def test_an_error_inside_of_a_right_call_is_left_as_it_is():
    def stops(instant):
        return instant + 1

    with pytest.raises(TypeError, match="unsupported operand") as raised:
        pp.simulate(SCENE, FINGER, duration=0.1, until=stops)
    assert not isinstance(raised.value, pp.InvalidCall)


def test_public_functions_keep_their_signatures_and_can_be_pickled():
    assert list(inspect.signature(pp.solve).parameters)[:2] == ["scene", "pusher_angle"]
    assert list(inspect.signature(pp.Inertia).parameters) == ["mass", "gyration_radius", "center"]
    assert pickle.loads(pickle.dumps(pp.solve)) is pp.solve
    assert pickle.loads(pickle.dumps(pp.Inertia(mass=2.0))) == pp.Inertia(mass=2.0)
