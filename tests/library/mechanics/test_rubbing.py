"""The friction on any support in the dataset of a scene."""

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.entries import entry
from planar_pushing.mechanics.force.rubbing import place_friction, ring_friction, support_of
from planar_pushing.scenes.scene_model import SceneFile
from pulling_by_pushing.study.datasets.scenes import scene_dataset
from pulling_by_pushing.study.model import PushEntry

ROUGH = {"law": "perfectly_rough"}
TRIPOD = pp.Points([(1, 0), (-0.5, 0.8), (-0.5, -0.9)], [1, 2, 3])
SQUARE = pp.Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)])


def scene(contact, pusher_angle, effects):
    slider = {"rod_length": 2.0, "rod_angle": 45.0, "radius": 1.0}
    file = SceneFile.model_validate({"slider": slider, "contact": contact, "effects": effects})
    return scene_dataset(file, PushEntry(file="", pusher_angle=pusher_angle))


def coulomb(mu):
    return {"law": "coulomb", "friction_coefficient": mu}


def friction(support, **more):
    return {"type": "support_friction", "weight": 2.0, "support": entry(support)} | more


def sticking(data):
    return data.isel(solution=data["mode"].values == ContactMode.STICK).squeeze("solution")


def test_the_friction_of_points_balances_the_force_and_its_moment():
    data = sticking(scene(ROUGH, 110, effects=(friction(TRIPOD),)))
    pull = data.place_force.sum("place").values
    assert -pull == pytest.approx(data.force.values, rel=1e-12, abs=0)
    (x, y), (f_x, f_y) = data.place_position.values.T, data.place_force.values.T
    assert np.sum(x * f_y - y * f_x) == pytest.approx(0.0, abs=1e-12)
    assert data.place_share.values == pytest.approx([1 / 6, 2 / 6, 3 / 6])


def test_the_places_of_an_area_balance_the_force_nearly():
    data = sticking(scene(ROUGH, 110, effects=(friction(SQUARE),)))
    assert -data.place_force.sum("place").values == pytest.approx(data.force.values, abs=0.05)


def test_a_pivot_has_no_friction_of_its_own_direction():
    equal = pp.Points([(1, 0), (-0.5, np.sqrt(0.75)), (-0.5, -np.sqrt(0.75))], [1, 1, 1])
    data = scene(ROUGH, 45 + 90, effects=(friction(equal),))
    one = sticking(data)
    assert one.pivot == 0
    assert one.place_force.values[0].tolist() == [0.0, 0.0]
    assert np.hypot(*one.place_force.values[1:].T) == pytest.approx([2 / 3, 2 / 3])
    ends = one.force_end.values - one.force.values
    away = one.place_position.values[0]
    assert np.hypot(*ends) > 0.1
    assert ends[0] * away[1] == pytest.approx(ends[1] * away[0])


def test_a_ring_has_its_own_variables_and_any_other_support_its_places():
    plain, other = (scene(coulomb(2), 100, effects=(each,)) for each in (
        {"type": "ring_friction", "weight": 1}, friction(pp.Ring(0.5))
    ))  # fmt: skip
    assert "support_force" in plain
    assert "place_force" not in plain
    assert {"place_force", "pivot", "force_end"} <= set(other)
    assert "support_force" not in other
    arm = other.place_position.values - other.ring_center.values
    assert np.hypot(*arm.T) == pytest.approx(0.5)


def test_a_ring_moves_alike_on_both_ways():
    slider = pp.Slider(rod_length=2.0, rod_angle=0.7, radius=1.5)
    own = pp.Scene(slider=slider, contact=pp.Coulomb(1.0), effects=(pp.RingFriction(weight=3.0),))
    twist = np.array([[0.3, -0.2, 1.1], [0.0, 0.0, -1.0]])
    ring, any_one = ring_friction(own, twist), place_friction(own, twist)
    assert support_of(own) == pp.Ring(1.5)
    motions = [
        np.mean(each[1], axis=1) for each in (ring["support_motion"], any_one["place_motion"])
    ]
    assert motions[0] == pytest.approx(motions[1])
    pulls = np.sum(ring["support_force"][1], axis=1) * 2 * np.pi / 24
    assert pulls == pytest.approx(np.sum(any_one["place_force"][1], axis=1), abs=0.1)


def test_without_friction_nothing_rubs():
    mass = {"type": "inertia", "mass": 1, "gyration_radius": 1, "center": [0.2, 0.1]}
    data = scene(coulomb(2), 100, effects=(mass,))
    assert not data.place_force.values.any()
    assert data.place_motion.values.any()
