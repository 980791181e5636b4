"""Simulation logs of a study."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import xarray as xr

from planar_pushing.scenes.files import load_scene_file
from planar_pushing.scenes.scene_model import SceneFile
from planar_pushing.scenes.simulate import simulate_file
from planar_pushing.simulation.early_end import quietly
from planar_pushing.terms.quantities import LOG, attributes
from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.study.describe import scene_scalars
from pulling_by_pushing.study.running.build import Attributes, write_built


def simulations(
    paths: Sequence[PathLike], *, scenes: Mapping[str, str], marks: Sequence[Attributes]
) -> None:
    """Simulate scene files and write the logs.

    Parameters
    ----------
    paths : sequence of path
        The logs.
    scenes : mapping
        Scene file of each log, by the name of the simulation.
    marks : sequence of mapping
        Attributes that identify the study in each log.
    """
    for path, (name, scene), origin in zip(paths, scenes.items(), marks, strict=True):
        write_built(study_log(load_scene_file(scene)), path, name, origin)


def study_log(file: SceneFile) -> xr.Dataset:
    """Log of a scene file, with the parameters of the scene as scalar coordinates."""
    log = quietly(simulate_file)(file)
    scalars = scene_scalars(file.build())
    coords = {name: ((), value, attributes(LOG, name)) for name, value in scalars.items()}
    return log.assign_coords(coords)
