"""Picture of a scene file under a push."""

from __future__ import annotations

from functools import partial

from planar_pushing.figures.parts.forces import limit_curve
from planar_pushing.figures.parts.scene import LAYERS, draw_scene
from planar_pushing.figures.render import PathLike, draw_to_files
from planar_pushing.study.datasets.scenes import scene_dataset, with_limit_curve
from planar_pushing.study.figures.base import COLUMN_WIDTH
from planar_pushing.study.files.scene_model import SceneFile
from planar_pushing.study.files.study_model import PushEntry

#: A picture is as wide as a column, and square.
SIZE = COLUMN_WIDTH, COLUMN_WIDTH


def render_scene(file: SceneFile, push: PushEntry, path: PathLike) -> None:
    """Draw a scene file under a push, and save it as svg, pdf or png by the end of its name."""
    draw_to_files(draw_scene, SIZE, scene_dataset(file, push), [path])


def render_curve(file: SceneFile, push: PushEntry, path: PathLike) -> None:
    """The same with the limit curve around the contact; the scene has one effect."""
    data = with_limit_curve(scene_dataset(file, push), file.build())
    draw_to_files(partial(draw_scene, layers=(limit_curve, *LAYERS)), SIZE, data, [path])
