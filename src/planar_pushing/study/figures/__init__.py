"""The figures, one entry each, and what a study needs for them.

The entries stand in the study, below the drawings: study files are checked against them, and the workflow
reads them at every start, without matplotlib.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from planar_pushing.study.catalog import DATASETS
from planar_pushing.study.figures.ours import OURS, SUBJECTS, SUPPLEMENT
from planar_pushing.study.figures.paper import PAPER
from planar_pushing.study.figures.sliders import GALLERY

if TYPE_CHECKING:  # a job that draws a figure validates no file
    from planar_pushing.study.files.study_model import StudyFile

__all__ = ["ALL", "FIGURES", "GALLERY", "OURS", "SCENES", "SUPPLEMENT", "draws"]

#: Figures 1 to 15, in the order of the report.
FIGURES = PAPER | SUBJECTS
#: Every figure that is registered.
ALL = FIGURES | GALLERY | OURS | SUPPLEMENT

#: Figures by the scenes that they show.
SCENES = {scene: figure for figure in FIGURES.values() for scene in figure.groups("scenes")}


def draws(study: StudyFile, name: str) -> bool:
    """Whether a study has the datasets, effects and simulations that a scene or a figure needs.

    Those of the paper need an entry, of which a study has all or none.
    """
    from planar_pushing.study.slices import computes

    figure = ALL.get(name, SCENES.get(name))
    if figure is None:
        return True
    if figure.name in FIGURES and not (study.scenes or study.figures):
        return False
    for each in figure.datasets:
        stem, _, group = each.partition("/")
        if stem == "simulations" and group not in study.simulations:
            return False
        if stem in DATASETS and stem != "scenes" and not computes(study, stem):
            return False
    return figure.needs is None or figure.needs in study.grid.effects
