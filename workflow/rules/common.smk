# The studies, validated before any job starts, and what the rules look up in them.
import fcntl
import re
import sys
from pathlib import Path

from snakemake.exceptions import WorkflowError

from planar_pushing.figures.figure import drawing, entry
from planar_pushing.evidence.measured import logs
from planar_pushing.figures.parts.measured import PUSHES_FILE
from planar_pushing.figures.studies import (
    OURS,
    PUSHES,
    SUPPLEMENT,
    load_drawn_study,
    numbered,
    settings,
)
from planar_pushing.report.provenance import commit
from planar_pushing.study import chunks
from planar_pushing.study.catalog import DATASETS, dataset_file
from planar_pushing.study.provenance import provenance, whole_digest
from planar_pushing.study.running.code import builder, code_of
from planar_pushing.study.running.jobs import failure_text
from planar_pushing.study.slices import computes, points, sizes, study_slice
from planar_pushing.study.studies import (
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
        f"{workflow.basedir}: Snakemake runs in no folder with a space; move the project"
    )

# Each study by the folder that its results fill, its file, and the attributes that name it in a result.
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

#: Formats of every picture.
KINDS = ["svg", "pdf", "png"]
#: Datasets on how this work computes, and their figures; times of this machine are compared with nothing.
COUNTS, TIMES = ["hard_cases", "accuracy_errors", "evaluations"], ["accuracy_time"]
EVIDENCE_FIGURES = [name for name in (*OURS, *SUPPLEMENT) if name not in PUSHES]
#: Figures of datasets.
DRAWN = numbered()


def one_of(names):
    """Pattern of a wildcard that is one of these names; of none, one that nothing matches."""
    return "|".join(map(re.escape, names)) or "(?!)"


def computed(folder):
    """Datasets of a study: nothing else has a job."""
    return [name for name in DATASETS if computes(STUDIES[folder], name)]


def drawn(folder):
    """Figures of a study."""
    return list(STUDIES[folder].figures)


def columns(folder):
    """Figures of a study that have a variant for one column."""
    return [name for name in drawn(folder) if entry(name).column]


def undrawn(folder):
    """Simulations of a study that none of its figures shows."""
    shown = {source for name in drawn(folder) for source in entry(name).reads}
    return [
        name
        for name in STUDIES[folder].simulations
        if f"simulations/{name}" not in shown
    ]


#: The folder of the study that golden data certify as a whole; the report is about it.
WHOLE = next(
    (
        folder
        for folder, study in STUDIES.items()
        if study.golden and "figure_01" in study.figures
    ),
    None,
)
#: Its report shows every study that is built beside it.
REPORTED = WHOLE is not None and set(DRAWN) == set(sum(map(drawn, STUDIES), []))


def over(pattern, names):
    """Files of a pattern for every study and the names that a function gives for its folder."""
    return [
        path
        for folder in STUDIES
        for path in expand(pattern, results=folder, name=names(folder), kind=KINDS)
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
    """Code of a figure."""
    return code_of("figure", f"figures.{wildcards.figure}")


def chunked(wildcards):
    """The chunks of a dataset by name, none of one that is built in one piece."""
    study = study_of(wildcards)
    return (
        chunks.chunk_parts(study, wildcards.dataset)
        if wildcards.dataset in study.chunks
        else {}
    )


def job_slice(wildcards):
    """The values of the study from which a dataset or a chunk is computed."""
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
    """Chunks from which a dataset is gathered."""
    folder = f"{wildcards.results}/chunks/{wildcards.dataset}"
    files = [f"{folder}/{chunk}.nc" for chunk in chunked(wildcards)]
    return {"chunks": files} if files else {}


def job_call(wildcards):
    """The function that builds a dataset, gathers its chunks, or lists them."""
    if not chunked(wildcards):
        return "study.build:dataset"
    gathers = study_of(wildcards).gather.get(wildcards.dataset, True)
    return f"study.build:{'gather' if gathers else 'index'}"


def job_values(wildcards, threads):
    """The keywords of that function."""
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
    """The study's values for a figure."""
    return settings(study_of(wildcards), wildcards.figure)


def golden_results(wildcards):
    """The results of a study that golden data hold, and the golden files."""
    from planar_pushing.evidence.golden.check import result_names

    study = study_of(wildcards)
    files = [
        f"{wildcards.results}/{dataset_file(name)}" for name in result_names(study)
    ]
    return [*files, *sorted(map(str, Path(study.golden).rglob("*.nc")))]


def counted(wildcards, name):
    """The study whose effects are counted or timed."""
    names = ("evaluations", "effects")
    return {"study": FILES[wildcards.results]} if name in names else {}


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


#: Digests of the logs that were measured: without them, or with other logs, `pushes` measures.
DIGESTS = f"{WHOLE or chosen_results(config)}/tables/measured_pushes.txt"


def measured_files(wildcards):
    """The numbers of measured pushes, and the digests of the logs that are measured for them."""
    if DATA is None:
        raise WorkflowError(
            "data: not given; allowed: a folder with three_feet/*.txt and polygons/*.mat; "
            "run snakemake pushes --config data=FOLDER"
        )
    return [PUSHES_FILE, DIGESTS]
