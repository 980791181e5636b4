"""The study of sliders in the workflow: beside the paper's, and alone."""

import os
import re
import signal
import subprocess
import sys
import time

import pytest

from planar_pushing.study.catalog import DATASETS, SLIDERS
from planar_pushing.study.figures import FIGURES, GALLERY
from planar_pushing.study.storage.store import read_attributes
from planar_pushing.study.studies import provenance
from workflow.conftest import Copy, copy_project
from workflow.test_workflow import jobs, outputs, targets

STUDY = "workflow/config/sliders_smoke.yaml"


@pytest.fixture(scope="module")
def sliders(tmp_path_factory):
    """A copy in which the smoke study of sliders is built."""
    copy = Copy(copy_project(tmp_path_factory.mktemp("sliders")).root, STUDY)
    copy.snakemake()
    return copy


def test_everything_is_built_into_a_folder_of_its_own(sliders):
    files = set(sliders.digests())
    assert {f"data/{name}.nc" for name in SLIDERS} | {"data/simulations/tripod.nc"} <= files
    assert {f"figures/data/{name}.nc" for name in GALLERY} <= files
    for kind in ("svg", "pdf", "png"):
        assert {f"figures/{name}.{kind}" for name in GALLERY} <= files
    assert not any(DATASETS.keys() & {path.stem for path in sliders.results.rglob("*.nc")})
    assert [path.name for path in (sliders.root / "results").iterdir()] == ["studies"]
    assert "Nothing to be done" in sliders.snakemake("--dry-run")


def test_every_output_is_a_target(sliders):
    assert outputs(sliders) == targets(sliders)


def test_a_killed_run_resumes_to_the_bytes_of_another_build(sliders, fresh):
    """Two clean builds, one of them in two runs, which share nothing, are identical."""
    fresh = Copy(fresh.root, STUDY)
    with subprocess.Popen(
        fresh.command(), cwd=fresh.root, env=fresh.environment, start_new_session=True,
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    ) as run:  # fmt: skip
        figures = fresh.results / "figures"
        while not any(path.is_file() for path in figures.rglob("*")):  # others come and go
            assert run.poll() is None, "the run ended before it could be killed"
            time.sleep(0.05)
        os.killpg(run.pid, signal.SIGKILL)
    partial = fresh.digests()
    assert len(partial) < len(sliders.digests())
    fresh.snakemake("--rerun-incomplete")
    assert fresh.digests() == sliders.digests()


def test_every_dataset_names_the_study_and_its_digest(sliders):
    marks = provenance(sliders.root / STUDY)
    for path in sliders.results.rglob("*.nc"):
        attrs = read_attributes(path)
        assert {name: attrs.get(name) for name in marks} == marks, path


@pytest.mark.parametrize(
    ("module", "stale"),
    [
        ("figures/sliders/figure_17.py", {"sliders_figure": 1}),
        ("study/datasets/sliders/support_modes.py", {"sliders_dataset": 1}),
        ("study/datasets/sliders/supports.py", {"sliders_dataset": 1, "sliders_figure": 4}),
        ("study/simulations.py", {"sliders_simulation": 1, "sliders_figure": 1}),
    ],
)
def test_only_what_depends_on_a_module_reruns(sliders, module, stale):
    path = sliders.root / "src/planar_pushing" / module
    text = path.read_text(encoding="utf-8")
    path.write_text(text + "\n# an edit\n", encoding="utf-8")
    try:
        said = sliders.snakemake("--dry-run")
    finally:
        path.write_text(text, encoding="utf-8")
    assert jobs(said) == stale | {"all": 1}


def dry(copy, *arguments):
    """What a dry run of a copy says; nothing is chosen unless the arguments choose it."""
    run = [sys.executable, "-m", "snakemake", "--dry-run", "--cores", "1", *arguments]
    done = subprocess.run(
        run, cwd=copy.root, env=copy.environment, capture_output=True, text=True, check=False
    )
    return done.returncode, done.stdout + done.stderr


def test_both_studies_are_built_and_nothing_twice(fresh):
    # Without the golden data, which the copy lacks, there is no verdict and no report.
    for name, golden in (("paper", "tests/golden"), ("sliders", "tests/golden/sliders")):
        file = fresh.root / f"workflow/config/{name}.yaml"
        text = file.read_text(encoding="utf-8").replace(f"golden: ../../{golden}\n", "")
        file.write_text(text, encoding="utf-8")
    code, said = dry(fresh, "--config", "study=workflow/config/sliders.yaml")
    assert code == 0, said
    alone = jobs(said)
    assert alone == {"sliders_dataset": 3, "sliders_simulation": 1, "sliders_figure": 5, "all": 1}
    code, said = dry(fresh)
    assert code == 0, said
    both = jobs(said)
    assert alone.items() <= both.items()
    assert both["dataset"] == len(DATASETS)
    assert both["figure"] == len(FIGURES)
    made = re.findall(r"^    output: (.*)$", said, re.MULTILINE)
    files = [file for line in made for file in line.split(", ")]
    assert len(files) == len(set(files))
    code, said = dry(fresh, "--config", "study=workflow/config/paper.yaml")
    assert code == 0, said
    assert not any(name.startswith("sliders") for name in jobs(said))


def test_a_wrong_study_of_sliders_stops_before_any_job(fresh):
    study = fresh.root / STUDY
    text = study.read_text(encoding="utf-8")
    study.write_text(text.replace("weights: [1, 1, 1]", "weights: [1, 1, -1]"), encoding="utf-8")
    code, said = dry(fresh, "--config", f"study={STUDY}")
    assert code == 1
    assert f"{STUDY}: supports.tripod.weights" in said
    assert "Traceback" not in said
    assert not (fresh.root / "results").exists()


def test_lint(fresh):
    code, said = dry(fresh, "--lint", "--config", f"study={STUDY}")
    assert code == 1
    found = set(re.findall(r"^    \* (.*)$", said, re.MULTILINE))
    assert found == {"Specify a conda environment or container for each rule.:"}
