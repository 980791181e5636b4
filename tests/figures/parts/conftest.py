"""Axes to draw on, and scenes to draw."""

import pytest
from matplotlib.figure import Figure

from planar_pushing.figures.parts import drawing
from planar_pushing.study.datasets import scenes
from planar_pushing.study.files.scene_model import SceneFile
from planar_pushing.study.files.study_model import PushEntry

RING = {"type": "ring_friction", "weight": 1}
INERTIA = {"type": "inertia", "mass": 1, "gyration_radius": 1}
ROUGH = {"law": "perfectly_rough"}
NO_ADHESION = {"law": "infinite_friction", "at_zero_normal": "none"}


@pytest.fixture
def ax():
    return drawing.schematic(Figure(figsize=(3, 3)), (-2, 2, -1, 3))


def scene(contact, pusher_angle, *, effects=(RING,), magnitude=1.0, **slider):
    slider = {"rod_length": 2.0, "rod_angle": 45.0, "radius": 1.0} | slider
    file = SceneFile.model_validate({"slider": slider, "contact": contact, "effects": effects})
    push = PushEntry(file="", pusher_angle=pusher_angle, pusher_magnitude=magnitude)
    return scenes.scene_dataset(file, push)


def coulomb(mu):
    return {"law": "coulomb", "friction_coefficient": mu}
