# What has to be computed: the studies, read and validated before any job starts, and for each job its values,
# its resources and the code that it runs. The Snakefile and the other files contain the rules.
import atexit
import fcntl
import os
import re
import sys
from functools import cache
from pathlib import Path

from snakemake.exceptions import WorkflowError

from planar_pushing.terms.errors import PlanarPushingError
from planar_pushing.terms.extras import require_extra
from pulling_by_pushing.evidence.golden.digests import DIGESTS
from pulling_by_pushing.evidence.measured import logs
from pulling_by_pushing.figures import figure as figures
from pulling_by_pushing.figures.measured import PUSHES_FILE
from pulling_by_pushing.figures.studies import (
    OURS,
    PUSHES,
    SECTIONS,
    cuts,
    load_drawn_study,
    study_figures,
)
from pulling_by_pushing.report.provenance import commit
from pulling_by_pushing.study import chunks
from pulling_by_pushing.study.catalog import COUNTS, DATASETS, TIMES, dataset_file
from pulling_by_pushing.study.provenance import provenance, whole_digest
from pulling_by_pushing.study.running import code
from pulling_by_pushing.study.running.jobs import failure_text
from pulling_by_pushing.study.slices import (
    computes,
    points,
    result_names,
    sizes,
    study_slice,
)
from pulling_by_pushing.study.studies import (
    chosen_data,
    chosen_results,
    chosen_studies,
    study_folder,
    study_name,
)

if any(" " in path for path in (sys.executable, workflow.basedir)):
    raise WorkflowError(
        f"{workflow.basedir}: Snakemake cannot run in a path with a space; move the project"
    )

# Digests of code are kept from one run to the next, and so are the declarations of the figures, because their
# modules import what draws.
atexit.register(code.keep_facts)
FIGURE_MODULES = [f"figures.{name}" for name in figures.modules()]
figures.DECLARED |= code.value_of_code(
    "figures", code.code_of("figures.figure", *FIGURE_MODULES), figures.declarations
)

# By results folder: the file of each study, the study, and the attributes that name it in a result.
try:
    FILES = {
        str(study_folder(study_name(file), chosen_results(config))): file
        for file in chosen_studies(config)
    }
    STUDIES = {folder: load_drawn_study(file) for folder, file in FILES.items()}
    MARKS = {folder: provenance(STUDIES[folder], FILES[folder]) for folder in FILES}
    if any(study.chunks for study in STUDIES.values()):
        require_extra("chunks")
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

# xarray imports dask, if it is installed, at the first sum of a job, which takes as long as all else that a
# small job imports. Only grids in blocks or chunks need it.
DIVIDED = any(
    study.chunks or chunks.in_blocks(study, name)
    for study in STUDIES.values()
    for name in DATASETS
    if computes(study, name)
)
os.environ.update(PLANAR_PUSHING_DASK="yes" if DIVIDED else "no")

#: The script of every job, in the words of a rule in any file.
RUN = f"{workflow.basedir}/workflow/scripts/run.py"
#: Priorities: a measurement that takes all cores begins the run, then long jobs, then those that others await.
TO_BEGIN, LONG, AWAITED = 10, 2, 1
#: File formats of every picture.
KINDS = ["svg", "pdf", "png"]
#: Scenes whose motions are computed with each accuracy.
MOTIONS = [f"workflow/scenes/{name}.yaml" for name in ("turning_fence", "slipping")]
#: The ledger of the paper's claims, in the project's folder; without it, no claim is checked.
LEDGER = "paper/claims.yaml"
#: Folder of the paper's study, which golden data certify as a whole and the report describes.
WHOLE = next(
    (
        folder
        for folder, study in STUDIES.items()
        if study.golden and "figure_01" in study.figures
    ),
    None,
)
#: The same folder in a list, which is empty without the paper's study.
CERTIFIED = [WHOLE] if WHOLE else []
#: Digests of the evaluated logs; `pushes` runs again if they are missing or the logs have changed.
DIGESTS = f"{WHOLE or chosen_results(config)}/tables/measured_pushes.txt"
#: Whether the report can be built: all of its figures are drawn by the studies of this run.
REPORTED = WHOLE is not None and set(study_figures()) == {
    name for study in STUDIES.values() for name in study.figures
}


def one_of(names):
    """Pattern of a wildcard that must be one of these names; without names, it matches nothing."""
    return "|".join(map(re.escape, names)) or "(?!)"


def over(pattern, names):
    """Expand a file pattern for every study, with the names that a function returns for the study."""
    return [
        path
        for folder, study in STUDIES.items()
        for path in expand(pattern, results=folder, name=names(study), kind=KINDS)
    ]


def computed_datasets(study):
    """Datasets that a study computes; only these have jobs."""
    return [name for name in DATASETS if computes(study, name)]


def undrawn(study):
    """Simulations of a study that are not shown in its figures."""
    shown = {source for name in study.figures for source in figures.entry(name).reads}
    return [name for name in study.simulations if f"simulations/{name}" not in shown]


def verdicts(*names):
    """Files of the golden verdicts, with these endings, of the studies that have golden data."""
    return over(
        "{results}/tables/golden_{name}",
        lambda study: list(names) if study.golden else [],
    )


def golden_files(study):
    """Golden data of a study, with the lists of their digests."""
    golden = Path(study.golden) if study.golden else None
    names = ("*.nc", DIGESTS)
    return (
        sorted(str(path) for name in names for path in golden.rglob(name))
        if golden
        else []
    )


def all_golden_files():
    return sorted({path for study in STUDIES.values() for path in golden_files(study)})


def golden_results(wildcards):
    """Results of a study for which there are golden data, and the golden files."""
    study = STUDIES[wildcards.results]
    files = [
        f"{wildcards.results}/{dataset_file(name)}" for name in result_names(study)
    ]
    return [*files, *golden_files(study)]


@cache
def content(folder):
    """Digest of all values from which results of a study are computed."""
    return whole_digest(STUDIES[folder])


def contents(wildcards):
    """Digests of all studies, which the report describes."""
    return [content(folder) for folder in STUDIES]


def runs(call, *members, also=lambda wildcards: []):
    """Parameters of a job: the function that it calls, and the digest of the code that it runs.

    Members are modules that the function imports by name; `also` returns what else makes a result outdated.
    """

    def digest(wildcards):
        named = [member.format(**wildcards) for member in members]
        code_digest = code.code_of(call.partition(":")[0], *named)
        return [code_digest, *more] if (more := also(wildcards)) else code_digest

    return {"call": call, "code": digest}


def marks(name):
    """Attributes that name the study in a result."""
    return lambda wildcards: MARKS[wildcards.results](name.format(**wildcards))


def chunks_of(wildcards):
    """Chunks of a dataset by name; empty for a dataset that is built in one piece."""
    study, name = STUDIES[wildcards.results], wildcards.dataset
    return chunks.chunk_parts(study, name) if name in study.chunks else {}


def job_slice(wildcards):
    """Values of the study from which a dataset or a chunk is computed."""
    part = chunks_of(wildcards).get(wildcards.get("chunk"), {})
    return chunks.chunk_slice(STUDIES[wildcards.results], wildcards.dataset, part)


def job_points(wildcards):
    """Points of a dataset or a chunk, which determine the threads and the time limit of its job."""
    name = wildcards.dataset
    return points(name, job_slice(wildcards)) if DATASETS[name].dims else 0


def job_threads(wildcards):
    return chunks.threads(job_points(wildcards))


def job_minutes(wildcards):
    return chunks.minutes(job_points(wildcards))


def chunk_files(wildcards):
    """Chunk files that are combined into a dataset."""
    folder = f"{wildcards.results}/chunks/{wildcards.dataset}"
    files = [f"{folder}/{chunk}.nc" for chunk in chunks_of(wildcards)]
    return {"chunks": files} if files else {}


def dataset_code(wildcards):
    """Digest of the code of a dataset."""
    builder = DATASETS[wildcards.dataset].module
    return code.code_of("study.running.build", f"study.datasets.{builder}")


def figure_jobs():
    """Jobs that draw: results folder, section, figures, and simulations that no figure shows."""
    for folder, study in STUDIES.items():
        drawn = {*study.figures, *(OURS if folder == WHOLE else ())}
        for section, section_names in SECTIONS.items():
            names = [name for name in section_names if name in drawn]
            simulations = undrawn(study) if section == "motion" else []
            if names or simulations:
                yield folder, section, names, simulations


def figure_category(name):
    """Section in Snakemake's report of a figure, or of the drawing of a simulation."""
    if name in PUSHES:
        return "Measured pushes"
    if name in OURS:
        return "What accuracy costs"
    return (
        figures.entry(name).section if name in study_figures() else "Motion over time"
    )


def figure_captions(names):
    """Name, title and announced content of figures, for Snakemake's report."""
    entries = {name: figures.entry(name) for name in names}
    return [[name, entry.title, entry.promise] for name, entry in entries.items()]


def dataset_call(wildcards):
    """Name of the function that builds a dataset, combines its chunks, or writes their index."""
    gathers = STUDIES[wildcards.results].gather.get(wildcards.dataset, True)
    function = "gather" if gathers else "index"
    return f"study.running.build:{function if chunks_of(wildcards) else 'dataset'}"


def dataset_values(wildcards, threads):
    """Keyword arguments of the function that `dataset_call` names."""
    study, name = STUDIES[wildcards.results], wildcards.dataset
    values = study_slice(study, name)
    if not chunks_of(wildcards):
        return {"study": values, "threads": threads}
    steps = chunks.chunk_steps(study, name)
    return {"chunking": {"lengths": sizes(name, values), "steps": steps}}


def measured_files(wildcards):
    """Results for the measured pushes, and the digests of the logs from which they are computed."""
    if DATA is None:
        raise WorkflowError(
            "data: not given; allowed: a folder with three_feet/*.txt and polygons/*.mat; "
            "run snakemake pushes --config data=FOLDER"
        )
    return [PUSHES_FILE, DIGESTS]


def table(name):
    """A table of the report, with its title in Snakemake's report."""
    category, title, caption = TABLES[name]
    return report(
        f"{WHOLE}/tables/{name}.csv",
        category=category,
        labels={"table": title},
        caption=f"../report/{caption}.rst",
    )


wildcard_constraints:
    results=one_of(STUDIES),
