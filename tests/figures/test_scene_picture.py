"""Pictures of scene files."""

import pytest

from figures.parts.conftest import RING, ROUGH
from planar_pushing.figures.scene_picture import render_scene
from planar_pushing.study.files.scene_model import SceneFile
from planar_pushing.study.files.study_model import PushEntry


@pytest.mark.parametrize("kind", ["svg", "pdf", "png"])
def test_a_scene_file_is_drawn(tmp_path, kind):
    path = tmp_path / f"scene.{kind}"
    file = SceneFile.model_validate(
        {"slider": {"rod_length": 2, "rod_angle": 45}, "contact": ROUGH, "effects": [RING]}
    )
    render_scene(file, PushEntry(file="", pusher_angle=200), path)
    assert path.stat().st_size > 1000
