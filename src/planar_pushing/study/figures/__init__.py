"""The figures, one entry each, and what a study needs for them.

The entries stand in the study, below the drawings: study files are checked against them, and the workflow
reads them at every start, without matplotlib.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from planar_pushing.study.figures.ours import OURS, SUBJECTS, SUPPLEMENT
from planar_pushing.study.figures.paper import BOTH, PAPER
from planar_pushing.study.figures.sliders import GALLERY

if TYPE_CHECKING:  # a job that draws a figure validates no file
    from planar_pushing.study.files.models import StudyFile
    from planar_pushing.study.files.sliders_model import SlidersFile

__all__ = ["ALL", "FIGURES", "GALLERY", "OURS", "SCENES", "SUPPLEMENT", "computes", "shows"]

#: Figures 1 to 15, in the order of the report.
FIGURES = PAPER | SUBJECTS
#: Every figure that is registered.
ALL = FIGURES | GALLERY | OURS | SUPPLEMENT

#: Figures by the scenes that they show.
SCENES = {scene: figure for figure in FIGURES.values() for scene in figure.groups("scenes")}


def computes(study: StudyFile, name: str) -> bool:
    """Whether a study has the effects and simulations that a dataset, scene or figure needs."""
    if name in ("acceleration_centers", "center_regions"):
        return BOTH in study.grid.effects
    figure = FIGURES.get(name, SCENES.get(name))
    if figure is None:
        return True
    simulated = set(figure.groups("simulations")) <= set(study.simulations)
    return simulated and (figure.needs is None or figure.needs in study.grid.effects)


def shows(study: SlidersFile, name: str) -> bool:
    """Whether a study of sliders has the simulations that a figure of its gallery needs."""
    return set(GALLERY[name].groups("simulations")) <= set(study.simulations)
