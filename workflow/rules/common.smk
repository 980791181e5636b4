# Load and validate the studies before any job starts, and define functions that the rules use.
import fcntl
import re
import sys
from pathlib import Path

from snakemake.exceptions import WorkflowError

from pulling_by_pushing.figures.figure import drawing, entry
from pulling_by_pushing.evidence.measured import logs
from pulling_by_pushing.figures.parts.measured import PUSHES_FILE
from pulling_by_pushing.figures.studies import (
    OURS,
    PUSHES,
    load_drawn_study,
    numbered,
    settings,
)
from pulling_by_pushing.report.provenance import commit
from pulling_by_pushing.study import chunks
from pulling_by_pushing.study.catalog import DATASETS, dataset_file
from pulling_by_pushing.study.provenance import provenance, whole_digest
from pulling_by_pushing.study.running.code import code_of
from pulling_by_pushing.study.running.jobs import failure_text
from pulling_by_pushing.study.slices import computes, points, sizes, study_slice
from pulling_by_pushing.study.studies import (
    chosen_data,
    chosen_results,
    chosen_studies,
    study_folder,
    study_name,
)
from planar_pushing.terms.errors import PlanarPushingError
from planar_pushing.terms.extras import require_extra

if any(" " in path for path in (sys.executable, workflow.basedir)):
    raise WorkflowError(
        f"{workflow.basedir}: Snakemake cannot run in a path with a space; move the project"
    )

# By results folder: the file of each study, the study, and the attributes that name it in a result.
try:
    FILES = {
        str(study_folder(study_name(file), chosen_results(config))): file
        for file in chosen_studies(config)
    }
    STUDIES = {folder: load_drawn_study(file) for folder, file in FILES.items()}
    if any(study.chunks for study in STUDIES.values()):
        require_extra("chunks")
    MARKS = {folder: provenance(STUDIES[folder], FILES[folder]) for folder in FILES}
    DATA = chosen_data(config)
    LOGS = [] if DATA is None else logs(DATA)
except PlanarPushingError as error:
    raise WorkflowError(str(error)) from None

# Snakemake marks a run by lock files, which a killed run leaves behind. A lock of the operating system ends
# with its process. The run that holds this lock removes the files. Jobs of a run do not take it.
if workflow.is_main_process:
    Path(".snakemake").mkdir(exist_ok=True)
    OWNER = open(".snakemake/owner", "a")
    try:
        fcntl.flock(OWNER, fcntl.LOCK_EX | fcntl.LOCK_NB)
        for lock in Path(".snakemake/locks").glob("*.lock"):
            lock.unlink(missing_ok=True)
    except BlockingIOError:
        pass  # Snakemake reports that another run is in progress

#: File formats of every picture.
KINDS = ["svg", "pdf", "png"]
#: Datasets about the computation itself, the scenes that they simulate, and their figures; times of this
#: machine have no golden data.
COUNTS, TIMES = ["hard_cases", "accuracy"], ["accuracy_time", "effects"]
MOTIONS = [f"workflow/scenes/figure_{name}.yaml" for name in ("14a", "15")]
EVIDENCE_FIGURES = [name for name in OURS if name not in PUSHES]
#: Numbered figures, which are drawn from datasets.
DRAWN = numbered()


def one_of(names):
    """Pattern of a wildcard that must be one of these names; without names, it matches nothing."""
    return "|".join(map(re.escape, names)) or "(?!)"


def computed(folder):
    """Datasets that a study computes; only these have jobs."""
    return [name for name in DATASETS if computes(STUDIES[folder], name)]


def drawn(folder):
    """Figures of a study."""
    return list(STUDIES[folder].figures)


def columns(folder):
    """Figures of a study that have a single-column variant."""
    return [name for name in drawn(folder) if entry(name).column]


def undrawn(folder):
    """Simulations of a study that are not shown in its figures."""
    shown = {source for name in drawn(folder) for source in entry(name).reads}
    return [
        name
        for name in STUDIES[folder].simulations
        if f"simulations/{name}" not in shown
    ]


#: Folder of the paper's study, which golden data certify as a whole and the report describes.
WHOLE = next(
    (
        folder
        for folder, study in STUDIES.items()
        if study.golden and "figure_01" in study.figures
    ),
    None,
)
#: Whether the report can be built: all of its figures are drawn by the studies of this run.
REPORTED = WHOLE is not None and set(DRAWN) == set(sum(map(drawn, STUDIES), []))


def over(pattern, names):
    """Expand a file pattern for every study, with the names that a function returns for its folder."""
    return [
        path
        for folder in STUDIES
        for path in expand(pattern, results=folder, name=names(folder), kind=KINDS)
    ]


def verdicts(*names):
    """Files of the golden verdicts, with these endings, of the studies that have golden data."""
    return [
        f"{folder}/tables/golden_{name}"
        for folder, study in STUDIES.items()
        if study.golden
        for name in names
    ]


wildcard_constraints:
    results=one_of(STUDIES),


def study_of(wildcards):
    return STUDIES[wildcards.results]


def marks_of(wildcards):
    """Attributes that name the study in a dataset, a simulation or a figure."""
    if "simulation" in wildcards.keys():
        return MARKS[wildcards.results](f"simulations/{wildcards.simulation}")
    return MARKS[wildcards.results](wildcards.get("dataset") or wildcards.figure)


def figure_code(wildcards):
    """Digest of the code of a figure."""
    return code_of("figures.render", f"figures.{wildcards.figure}")


def dataset_code(wildcards):
    """Digest of the code of a dataset."""
    name = DATASETS[wildcards.dataset].module
    return code_of("study.running.build", f"study.datasets.{name}")


def chunked(wildcards):
    """Chunks of a dataset by name; empty for a dataset that is built in one piece."""
    study = study_of(wildcards)
    return (
        chunks.chunk_parts(study, wildcards.dataset)
        if wildcards.dataset in study.chunks
        else {}
    )


def job_slice(wildcards):
    """Values of the study from which a dataset or a chunk is computed."""
    study, name = study_of(wildcards), wildcards.dataset
    part = chunked(wildcards).get(wildcards.get("chunk"), {})
    return chunks.chunk_slice(study, name, part)


def job_points(wildcards):
    if wildcards.dataset == "scenes":
        return 0
    return points(wildcards.dataset, job_slice(wildcards))


def job_threads(wildcards):
    return chunks.threads(job_points(wildcards))


def job_minutes(wildcards):
    return chunks.minutes(job_points(wildcards))


def chunk_files(wildcards):
    """Chunk files that are combined into a dataset."""
    folder = f"{wildcards.results}/chunks/{wildcards.dataset}"
    files = [f"{folder}/{chunk}.nc" for chunk in chunked(wildcards)]
    return {"chunks": files} if files else {}


def job_call(wildcards):
    """Name of the function that builds a dataset, combines its chunks, or writes their index."""
    if not chunked(wildcards):
        return "study.running.build:dataset"
    gathers = study_of(wildcards).gather.get(wildcards.dataset, True)
    return f"study.running.build:{'gather' if gathers else 'index'}"


def job_values(wildcards, threads):
    """Keyword arguments of the function that `job_call` names."""
    study, name = study_of(wildcards), wildcards.dataset
    if not chunked(wildcards):
        return {"study": study_slice(study, name), "threads": threads}
    lengths, steps = (
        sizes(name, study_slice(study, name)),
        chunks.chunk_steps(study, name),
    )
    return {"whole": {"lengths": lengths, "steps": steps}}


def figure_files(wildcards):
    """Datasets from which a figure is drawn."""
    sources = entry(wildcards.figure).reads
    return sorted({f"{wildcards.results}/{dataset_file(source)}" for source in sources})


def figure_settings(wildcards):
    """Values of the study for a figure."""
    return settings(study_of(wildcards), wildcards.figure)


def golden_results(wildcards):
    """Results of a study for which there are golden data, and the golden files."""
    from pulling_by_pushing.evidence.golden.check import result_names

    study = study_of(wildcards)
    files = [
        f"{wildcards.results}/{dataset_file(name)}" for name in result_names(study)
    ]
    return [*files, *sorted(map(str, Path(study.golden).rglob("*.nc")))]


def timed_study(wildcards):
    """Study from which a dataset of times is computed, if any."""
    reads = wildcards.times == "effects"
    return {"study": FILES[wildcards.results]} if reads else {}


def table(name):
    category, title, caption = TABLES[name]
    return report(
        f"{WHOLE}/tables/{name}.csv",
        category=category,
        labels={"table": title},
        caption=f"../report/{caption}.rst",
    )


def golden_files():
    """Golden data of all studies that are built."""
    folders = [Path(study.golden) for study in STUDIES.values() if study.golden]
    return sorted({str(path) for folder in folders for path in folder.rglob("*.nc")})


#: Digests of the evaluated logs; `pushes` runs again if they are missing or the logs have changed.
DIGESTS = f"{WHOLE or chosen_results(config)}/tables/measured_pushes.txt"


def measured_files(wildcards):
    """Results for the measured pushes, and the digests of the logs from which they are computed."""
    if DATA is None:
        raise WorkflowError(
            "data: not given; allowed: a folder with three_feet/*.txt and polygons/*.mat; "
            "run snakemake pushes --config data=FOLDER"
        )
    return [PUSHES_FILE, DIGESTS]
