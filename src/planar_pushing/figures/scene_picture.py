"""Picture of a scene file under a push."""

from __future__ import annotations

from planar_pushing.figures.parts.scene import draw_scene
from planar_pushing.figures.render import PathLike, draw_to_files
from planar_pushing.study.datasets.scenes import scene_dataset
from planar_pushing.study.figures.base import COLUMN_WIDTH
from planar_pushing.study.files.models import PushEntry
from planar_pushing.study.files.scene_model import SceneFile


def render_scene(file: SceneFile, push: PushEntry, path: PathLike) -> None:
    """Draw a scene file under a push, and save it as svg, pdf or png by the end of its name."""
    size = COLUMN_WIDTH, COLUMN_WIDTH
    draw_to_files(draw_scene, size, scene_dataset(file, push), [path])
