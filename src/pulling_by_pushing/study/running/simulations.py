"""Simulation logs of a study."""

from __future__ import annotations

from planar_pushing.scenes.files import load_scene_file
from planar_pushing.scenes.simulate import simulate_file
from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.study.running.build import Attributes, write_built


def simulation(path: PathLike, *, name: str, scene: str, marks: Attributes) -> None:
    """Simulate a scene file and write the log."""
    write_built(simulate_file(load_scene_file(scene)), path, name, marks)
