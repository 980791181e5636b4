"""Files that the page offers: the scene, its picture, the log, and the lines of Python."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path

from planar_pushing.explore.following import followed
from planar_pushing.explore.python_lines import lines
from planar_pushing.explore.state import Start, State
from planar_pushing.figures.scene_picture import render_scene
from planar_pushing.study.files.scene_model import SceneFile
from planar_pushing.study.files.scenes import save_scene_file
from planar_pushing.study.files.study_model import PushEntry
from planar_pushing.study.store import write_dataset


def scene_file(state: State) -> SceneFile:
    """The scene file of a state.

    A file moves its pusher at given speeds, so it says nothing of one that accelerates from rest.
    """
    if state.start == Start.ACCELERATION:
        return state.file.model_copy(update={"simulate": None})
    return state.file


def _yaml(state: State, path: Path) -> None:
    save_scene_file(scene_file(state), path)


def _svg(state: State, path: Path) -> None:
    push = PushEntry(file=str(path), pusher_angle=state.angle, pusher_magnitude=state.magnitude)
    render_scene(state.file, push, path)


def _log(state: State, path: Path) -> None:
    write_dataset(followed(state).log, path)


def _python(state: State, path: Path) -> None:
    path.write_text(lines(state), encoding="utf-8")


#: Names of the files that the page offers, and what writes each.
WRITERS: dict[str, Callable[[State, Path], None]] = {
    "scene.yaml": _yaml,
    "scene.svg": _svg,
    "log.nc": _log,
    "scene.py": _python,
}


def written(state: State, name: str) -> bytes:
    """What a file holds."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / name
        WRITERS[name](state, path)
        return path.read_bytes()
