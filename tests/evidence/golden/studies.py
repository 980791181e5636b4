"""Results of a study, written without the workflow."""

from planar_pushing.figures.render import select
from planar_pushing.study.build import build_dataset
from planar_pushing.study.catalog import DATASETS
from planar_pushing.study.describe import of_study
from planar_pushing.study.figures import FIGURES
from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.study.files.study_model import FigureEntry
from planar_pushing.study.provenance import provenance
from planar_pushing.study.simulations import simulate_file
from planar_pushing.study.slices import study_slice
from planar_pushing.study.store import write_dataset
from planar_pushing.study.study_file import load_study


def write_results(file, folder):
    """Write the datasets of a study, and the numbers of its figures."""
    study = load_study(file)
    marks = provenance(study, file)
    for name in DATASETS:
        built = build_dataset(name, study_slice(study, name))
        write_dataset(of_study(built, name, marks(name)), folder / f"data/{name}.nc")
    for name, scene in study.simulations.items():
        log = simulate_file(load_scene_file(scene))
        log = of_study(log, name, marks(f"simulations/{name}"))
        write_dataset(log, folder / f"data/simulations/{name}.nc")
    for name in FIGURES:
        settings = study.figures.get(name, FigureEntry())
        plotted = of_study(select(name, folder, settings), name, marks(name))
        write_dataset(plotted, folder / f"figures/data/{name}.nc")
    return folder
