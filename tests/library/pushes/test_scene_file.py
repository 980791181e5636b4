"""Scene files of supports that were identified: the contact, and supports that make no scene."""

from dataclasses import replace

import numpy as np
import pytest
from pushes.written import SQUARE, small

import planar_pushing as pp
from planar_pushing.pushes.scene_file import object_entry, save_support


@pytest.fixture
def found():
    return pp.Identified(
        support=pp.Points(SQUARE, [1, 1, 1, 1]), weight=2.0, contact_friction=0.3,
        center_of_pressure=np.zeros(2), spin_torque=2**0.5, intervals={},
        weight_intervals=np.zeros((4, 2)), residuals=np.zeros(3), facet=np.full(3, -1), length=0.8,
        spacing=0.5, optimality=0.0, undetermined=(),
    )  # fmt: skip


@pytest.mark.parametrize(("contact", "normal", "middle"), [
    ((-0.5, -1.0), (0.0, 1.0), (0.0, -1.0)),
    ((1.0, 0.5), (-1.0, 0.0), (1.0, 0.0)),
    ((0.3, 1.0), (0.0, -1.0), (0.0, 1.0)),
])  # fmt: skip
def test_the_contact_is_in_the_middle_of_the_side_of_the_first_push(found, contact, normal, middle):
    units = {"units": "mm"}
    pushes = small(
        contact=(("push", "xy"), [contact] * 3, units), normal=(("push", "xy"), [normal] * 3),
        finger_displacement=(("push", "xy"), [np.array(normal) / 5] * 3, units),
        displacement=(("push", "xy"), [np.array(normal) / 5] * 3, units),
    )  # fmt: skip
    place = object_entry(found, pp.concat_pushes([pushes]))["object"]["contact"]
    assert place == {"point": list(middle)}


def test_a_push_at_a_corner_is_that_of_one_of_its_sides(found):
    pushes = pp.concat_pushes([small()])
    pushes["contact"].values[0] = 1.0
    point = object_entry(found, pushes)["object"]["contact"]["point"]
    assert point in ([1.0, 0.0], [0.0, 1.0])


def test_it_reads_back_as_the_scene_of_the_support(found, tmp_path):
    path = tmp_path / "support.yaml"
    save_support(found, pp.concat_pushes([small()]), path)
    scene = pp.load_scene(path)
    friction = pp.SupportFriction(support=found.support, weight=2.0)
    expected = pp.scene_at(
        (0, -1), effects=(friction,), contact=pp.Coulomb(0.3), outline=SQUARE, units=pp.Units(length="mm")
    )  # fmt: skip
    assert scene == expected


def test_a_single_point_and_too_many_are_refused_and_nothing_is_written(found, tmp_path):
    pushes, path = pp.concat_pushes([small()]), tmp_path / "support.yaml"
    single = replace(found, support=pp.Points([(0.0, 0.0)], [1.0]))
    with pytest.raises(pp.InvalidFile, match=r"allowed: at least two points of support, "):
        save_support(single, pushes, path)
    places = np.random.default_rng(1).uniform(-1, 1, (3501, 2))
    with pytest.raises(
        pp.InvalidValue, match=r"^support: '3501 points' given; allowed: at most 3500 "
    ):
        save_support(replace(found, support=pp.Points(places, np.ones(3501))), pushes, path)
    assert not list(tmp_path.iterdir())


@pytest.mark.slow
def test_as_many_points_as_are_allowed_make_a_scene(found, tmp_path):
    pushes, path = pp.concat_pushes([small()]), tmp_path / "support.yaml"
    places = np.random.default_rng(1).uniform(-1, 1, (3500, 2))
    save_support(replace(found, support=pp.Points(places, np.ones(3500))), pushes, path)
    assert len(pp.load_scene(path).effects[0].support.positions) == 3500
