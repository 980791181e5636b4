"""Scenes to draw, from the entries of scene files."""

from planar_pushing.mechanics.entries import entry
from planar_pushing.scenes.scene_model import SceneFile
from pulling_by_pushing.study.datasets.scenes import scene_dataset
from pulling_by_pushing.study.model import PushEntry

RING = {"type": "ring_friction", "weight": 1}
INERTIA = {"type": "inertia", "mass": 1, "gyration_radius": 1}
ASIDE = INERTIA | {"center": [0.4, 0.3]}
ROUGH = {"law": "perfectly_rough"}
NO_ADHESION = {"law": "infinite_friction", "at_zero_normal": "none"}


def coulomb(mu):
    return {"law": "coulomb", "friction_coefficient": mu}


def supported(support):
    return {"type": "support_friction", "support": entry(support)}


def scene_file(contact, effects=(RING,), **slider):
    slider = {"rod_length": 2.0, "rod_angle": 45.0} | slider
    return SceneFile.model_validate({"slider": slider, "contact": contact, "effects": effects})


def scene(contact, effects=(RING,), **slider):
    return scene_file(contact, effects, **slider).build()


def dataset(contact, angle, effects=(RING,), magnitude=1.0, **slider):
    push = PushEntry(file="", pusher_angle=angle, pusher_magnitude=magnitude)
    return scene_dataset(scene_file(contact, effects, **slider), push)
