"""Pictures of scene files, with what their section `simulate` places around the object."""

from __future__ import annotations

from typing import Any

from planar_pushing.drawing.contacts import ContactsPicture
from planar_pushing.drawing.sketch import Sketch
from planar_pushing.drawing.walls import walls_before, walls_of_object
from planar_pushing.mechanics.scene import Scene
from planar_pushing.scenes.contacts_model import ContactsFile
from planar_pushing.scenes.scene_model import SceneFile
from planar_pushing.scenes.simulate import arguments
from planar_pushing.terms.options import Shape


def contacts_picture(file: ContactsFile, chosen: int = 0) -> ContactsPicture:
    """The picture of one solution of a file with several contacts, with its walls at the start."""
    world = {} if file.simulate is None else file.simulate.world
    walls = walls_of_object(world["object_pose"], world["walls"]) if world else ()
    return ContactsPicture(**file.build(), chosen=chosen, walls=walls)


def sketch_of_file(file: SceneFile) -> Sketch:
    """The sketch of a scene under the push of its file."""
    scene = file.build()
    angle, magnitude = scene.push or (None, 1.0)
    return Sketch.of(scene, angle, magnitude, **surroundings(file, scene))


def surroundings(file: SceneFile, scene: Scene) -> dict[str, Any]:
    """Walls, and the side that a finger pushes and the finger's radius, as arguments of a sketch."""
    section = file.simulate
    if section is None:
        return {}
    walls = {"walls": walls_before(scene, arguments(section))}
    if section.pusher_shape != Shape.FINGER:
        return walls
    return walls | {"side": scene.slider.side, "finger_radius": section.pusher_radius or 0.0}
