# The study, validated before any job starts, and what the rules look up in it.
import sys

from snakemake.exceptions import WorkflowError

from planar_pushing.terms.errors import PlanarPushingError
from planar_pushing.study.catalog import DATASETS, dataset_file
from planar_pushing.study.dependencies import code_of
from planar_pushing.study.figures import FIGURES, OURS, SUPPLEMENT, computes
from planar_pushing.study.files.models import FigureEntry
from planar_pushing.study.locks import own_the_folder
from planar_pushing.study.slices import study_slice
from planar_pushing.study.studies import chosen_study, provenance, study_folder
from planar_pushing.study.study_file import load_study

if any(" " in path for path in (sys.executable, workflow.basedir)):
    raise WorkflowError(
        f"{workflow.basedir}: Snakemake runs in no folder with a space; move the project"
    )

try:
    STUDY_FILE = chosen_study(config)
    STUDY = load_study(STUDY_FILE)
    #: Name of the study and digest of its file, which every dataset holds.
    PROVENANCE = provenance(STUDY_FILE)
except PlanarPushingError as error:
    raise WorkflowError(str(error)) from None

#: The folder that this study fills, and no other.
RESULTS = str(study_folder(PROVENANCE["study"]))

own_the_folder(".snakemake")

#: Priorities: first what the golden check waits for, and last what nothing waits for, to run beside the report.
FIRST, LAST = 1, -1

#: What the study's effects allow: nothing else has a job.
COMPUTED = [name for name in DATASETS if computes(STUDY, name)]
DRAWN = [name for name in FIGURES if computes(STUDY, name)]


def scene_files(wildcards):
    """Scene files that a dataset reads."""
    return (
        [push.file for push in STUDY.scenes.values()]
        if wildcards.dataset == "scenes"
        else []
    )


def dataset_files(wildcards):
    """Datasets that a figure is drawn from."""
    sources = FIGURES[wildcards.figure].datasets
    return sorted({f"<results>/{dataset_file(source)}" for source in sources})


def figure_settings(wildcards):
    """The study's values for a figure."""
    return STUDY.figures.get(wildcards.figure, FigureEntry()).model_dump()
