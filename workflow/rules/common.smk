# The studies, validated before any job starts, and what the rules look up in them.
import sys

from snakemake.exceptions import WorkflowError

from planar_pushing.terms.errors import PlanarPushingError
from planar_pushing.terms.extras import require_extra
from planar_pushing.study.grids import effort
from planar_pushing.study.catalog import DATASETS, SLIDERS, dataset_file
from planar_pushing.study.grids.chunks import chunk_parts, chunk_slice, chunk_steps
from planar_pushing.study.running.dependencies import code_of
from planar_pushing.study.figures import (
    FIGURES,
    GALLERY as GALLERY_FIGURES,
    OURS,
    SUPPLEMENT,
    computes,
    shows,
)
from planar_pushing.study.files.models import FigureEntry, StudyFile
from planar_pushing.study.running.locks import own_the_folder
from planar_pushing.study.storage.parts import points, sizes
from planar_pushing.study.slices import study_slice
from planar_pushing.study.files.sliders_model import SlidersFile
from planar_pushing.study.sliders_file import load_any
from planar_pushing.study.studies import (
    PAPER_FILE,
    SLIDERS_FILE,
    chosen_studies,
    provenance,
    study_folder,
)

if any(" " in path for path in (sys.executable, workflow.basedir)):
    raise WorkflowError(
        f"{workflow.basedir}: Snakemake runs in no folder with a space; move the project"
    )

try:
    LOADED = {file: load_any(file) for file in chosen_studies(config)}
    # The report of the paper's study shows the study of sliders as well.
    if getattr(LOADED.get(PAPER_FILE), "golden", None):
        LOADED |= {SLIDERS_FILE: load_any(SLIDERS_FILE)}
    if any(getattr(study, "chunks", {}) for study in LOADED.values()):
        require_extra("chunks")
    #: Name of each study and digest of its file, which every dataset holds.
    MARKS = {file: provenance(file) for file in LOADED}
except PlanarPushingError as error:
    raise WorkflowError(str(error)) from None


def file_of(kind):
    """File of the study of a kind, None where none is built."""
    return next((file for file, each in LOADED.items() if isinstance(each, kind)), None)


def folder_of(file):
    """The folder that a study fills, and no other."""
    return str(study_folder(MARKS[file]["study"])) if file else "results"


STUDY_FILE, GALLERY_FILE = file_of(StudyFile), file_of(SlidersFile)
STUDY, GALLERY = LOADED.get(STUDY_FILE), LOADED.get(GALLERY_FILE)
PROVENANCE, RESULTS = MARKS.get(STUDY_FILE), folder_of(STUDY_FILE)

# Not a job of another run, which may outlive the process that submitted it.
if workflow.is_main_process:
    own_the_folder(".snakemake")

#: Priorities: first what the golden check waits for, and last what nothing waits for, to run beside the report.
FIRST, LAST = 1, -1

#: What the study's effects allow: nothing else has a job.
COMPUTED = [name for name in DATASETS if STUDY and computes(STUDY, name)]
DRAWN = [name for name in FIGURES if STUDY and computes(STUDY, name)]
#: Datasets in chunks, by the names of the chunks; those that become one file; and those in one piece.
CHUNKED = {name: chunk_parts(STUDY, name) for name in (STUDY.chunks if STUDY else ())}
GATHERED = [name for name in CHUNKED if STUDY.gather.get(name, True)]
WHOLE_DATASETS = [name for name in COMPUTED if name not in CHUNKED]


def one_of(names):
    """Pattern of a wildcard that is one of these names; of none, one that nothing matches."""
    return "|".join(names) or "(?!)"


def job_slice(wildcards):
    """The study's values that a dataset or a chunk is computed from."""
    part = CHUNKED.get(wildcards.dataset, {}).get(wildcards.get("chunk"), {})
    return chunk_slice(STUDY, wildcards.dataset, part)


def job_points(wildcards):
    """Points that a job of a dataset computes."""
    return points(sizes(wildcards.dataset, job_slice(wildcards)))


def job_threads(wildcards):
    return effort.threads(job_points(wildcards))


def job_memory(wildcards, threads):
    return effort.memory(job_points(wildcards), threads)


def job_minutes(wildcards):
    return effort.minutes(job_points(wildcards))


def chunk_files(wildcards):
    """Chunks of a dataset."""
    folder = f"<results>/chunks/{wildcards.dataset}"
    return [f"{folder}/{chunk}.nc" for chunk in CHUNKED[wildcards.dataset]]


def gathering(wildcards):
    """Lengths of a dataset and of its chunks along the dimensions that are cut."""
    name = wildcards.dataset
    return {
        "lengths": sizes(name, study_slice(STUDY, name)),
        "steps": chunk_steps(STUDY, name),
    }


SHOWN = [name for name in GALLERY_FIGURES if GALLERY and shows(GALLERY, name)]


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


def gallery_files(wildcards):
    """Datasets that a figure of sliders is drawn from."""
    sources = GALLERY_FIGURES[wildcards.figure].datasets
    return sorted({f"<sliders>/{dataset_file(source)}" for source in sources})


def figure_settings(wildcards):
    """The study's values for a figure."""
    return STUDY.figures.get(wildcards.figure, FigureEntry()).model_dump()
