# The studies, validated before any job starts, and what the rules look up in them.
import fcntl
import sys
from pathlib import Path

from snakemake.exceptions import WorkflowError

from planar_pushing.terms.errors import PlanarPushingError
from planar_pushing.terms.extras import require_extra
from planar_pushing.study.grids import effort
from planar_pushing.study.catalog import DATASETS, SLIDERS, dataset_file
from planar_pushing.study.grids.chunks import chunk_parts, chunk_slice, chunk_steps
from planar_pushing.study.provenance import provenance, whole_digest
from planar_pushing.study.running.code import builder, code_of
from planar_pushing.study.running.jobs import failure_text
from planar_pushing.study.figures import (
    FIGURES,
    GALLERY as GALLERY_FIGURES,
    OURS,
    SUPPLEMENT,
    computes,
    shows,
)
from planar_pushing.study.files.models import FigureEntry, StudyFile
from planar_pushing.study.storage.parts import points, sizes
from planar_pushing.study.slices import study_slice
from planar_pushing.study.files.sliders_model import SlidersFile
from planar_pushing.study.sliders_file import load_any
from planar_pushing.study.studies import (
    PAPER_FILE,
    SLIDERS_FILE,
    chosen_studies,
    study_folder,
    study_name,
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
    #: Gives the attributes that name each study in a result.
    MARKS = {file: provenance(study, file) for file, study in LOADED.items()}
except PlanarPushingError as error:
    raise WorkflowError(str(error)) from None


def file_of(kind):
    """File of the study of a kind, None where none is built."""
    return next((file for file, each in LOADED.items() if isinstance(each, kind)), None)


def folder_of(file):
    """The folder that a study fills, and no other."""
    return str(study_folder(study_name(file))) if file else "results"


STUDY_FILE, GALLERY_FILE = file_of(StudyFile), file_of(SlidersFile)
STUDY, GALLERY = LOADED.get(STUDY_FILE), LOADED.get(GALLERY_FILE)
RESULTS = folder_of(STUDY_FILE)

# Snakemake notes a run by files, which a killed run leaves; the lock of the operating system goes with the
# process. The run that holds it removes them. A job of a run is no run of its own.
if workflow.is_main_process:
    Path(".snakemake").mkdir(exist_ok=True)
    OWNER = open(".snakemake/owner", "a")
    try:
        fcntl.flock(OWNER, fcntl.LOCK_EX | fcntl.LOCK_NB)
        for lock in Path(".snakemake/locks").glob("*.lock"):
            lock.unlink(missing_ok=True)
    except BlockingIOError:
        pass  # Snakemake says that another run is at work

#: Priorities: first what the golden check waits for, and last what nothing waits for, to run beside the report.
FIRST, LAST = 1, -1

#: What the study's effects allow: nothing else has a job.
COMPUTED = [name for name in DATASETS if STUDY and computes(STUDY, name)]
DRAWN = [name for name in FIGURES if STUDY and computes(STUDY, name)]
#: Datasets in chunks, by the names of the chunks; those that become one file; and those in one piece.
CHUNKED = {name: chunk_parts(STUDY, name) for name in (STUDY.chunks if STUDY else ())}
GATHERED = [name for name in CHUNKED if STUDY.gather.get(name, True)]
WHOLE_DATASETS = [name for name in COMPUTED if name not in CHUNKED]


#: Formats of every picture.
KINDS = ["svg", "pdf", "png"]
#: Figures on how this work computes, and the datasets on it that are compared with golden data.
EVIDENCE_FIGURES = OURS | SUPPLEMENT
COUNTS = (
    ["hard_cases", "accuracy_errors", "evaluations"] if STUDY and STUDY.golden else []
)
#: Times that are measured on this machine, which nothing is compared with.
TIMES = ["accuracy_time"] if COUNTS else []
#: The datasets that are timed by effects.
GRIDS = ["limit_curves", "motion_cones", "contact_modes"]
#: What the report and its supplement are set from, beside the results.
SOURCES = sorted(
    str(part)
    for part in Path("paper").rglob("*")
    if part.suffix in (".typ", ".md", ".bib", ".json") and "manual" not in part.parts
)
#: Captions and sections of the figures, which the report prints.
REGISTRY = repr([FIGURES, OURS, GALLERY_FIGURES])


def golden_files(study):
    """Golden data and tolerances of a study."""
    folder = Path(study.golden) if study.golden else None
    return (
        sorted(map(str, [*folder.glob("*.nc"), *folder.glob("*.yaml")]))
        if folder
        else []
    )


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


def marks_of(file):
    """Attributes that name a study in a dataset, a simulation or a figure."""

    def marks(wildcards):
        if "simulation" in wildcards.keys():
            return MARKS[file](f"simulations/{wildcards.simulation}")
        return MARKS[file](wildcards.get("dataset") or wildcards.figure)

    return marks


def dataset_code(wildcards):
    return code_of("dataset", builder(wildcards.dataset))


def golden_code(datasets, entries, names):
    """Code that checks these datasets and figures: it builds parts of them anew."""
    drawings = sorted({entries[name].module for name in names})
    return code_of("golden", *map(builder, datasets), *drawings)


def figure_code(entries):
    """Code and entry of a figure, of one of these families."""

    def code(wildcards):
        entry = entries[wildcards.figure]
        return [code_of("figure", entry.module), repr(entry)]

    return code


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
