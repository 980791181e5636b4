"""Files for download: the scene, its picture, the log, and the lines of Python."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from planar_pushing.drawing.canvas.svg import to_svg
from planar_pushing.drawing.scene import scene_picture
from planar_pushing.explorer import several
from planar_pushing.explorer.pictures.following import follow
from planar_pushing.explorer.pictures.pictures import solve_push
from planar_pushing.explorer.python_lines import lines
from planar_pushing.explorer.state import Start, State
from planar_pushing.scenes.files import save_scene_file
from planar_pushing.scenes.scene_model import SceneFile
from planar_pushing.terms.netcdf import write_dataset

#: Size of the picture and of a point in pixels.
SIZE, POINT = (840.0, 760.0), 2.0


def scene_file(state: State) -> SceneFile:
    """Scene file of a state, without a pusher that accelerates from rest, which files cannot describe."""
    if state.start == Start.ACCELERATION:
        return state.file.model_copy(update={"simulate": None})
    return state.file


def _yaml(state: State, path: Path) -> None:
    save_scene_file(scene_file(state), path)


def _svg(state: State, path: Path) -> None:
    sketch = solve_push(replace(state, time=None)).sketch
    text = to_svg(scene_picture(sketch), sketch.box, SIZE, point=POINT)
    path.write_text(text, encoding="utf-8")


def _log(state: State, path: Path) -> None:
    write_dataset(follow(state).log, path)


def _python(state: State, path: Path) -> None:
    path.write_text(lines(state), encoding="utf-8")


#: Files for download, and their writers.
WRITERS: dict[str, Callable[[State, Path], None]] = {
    "scene.yaml": _yaml,
    "scene.svg": _svg,
    "log.nc": _log,
    "scene.py": _python,
}


def download(state: State, name: str) -> bytes:
    """Content of a file for download."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / name
        if state.several is not None:
            several.write(state.several, name, path, SIZE, POINT)
            return path.read_bytes()
        WRITERS[name](state, path)
        return path.read_bytes()
