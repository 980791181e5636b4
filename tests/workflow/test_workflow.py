"""The workflow on the smoke study, end to end."""

import os
import re
import shutil
import subprocess
import sys
from dataclasses import replace

import pytest
import xarray as xr

from planar_pushing.commands import main
from planar_pushing.study.catalog import DATASETS
from planar_pushing.study.figures import FIGURES
from planar_pushing.study.storage.store import read_attributes, read_dataset, write_dataset
from planar_pushing.study.studies import provenance
from workflow.conftest import PROJECT, copy_project


def jobs(said):
    """Numbers of jobs by rule, from the job table of a run or a dry run."""
    table = re.search(r"Job stats:\njob +count\n[- ]+\n(.*?)\ntotal", said, re.DOTALL)
    return {name: int(count) for name, count in re.findall(r"(\w+) +(\d+)", table[1])}


def test_everything_is_built(built):
    files = built.digests()
    assert {f"data/{name}.nc" for name in DATASETS} <= set(files)
    for kind in ("svg", "pdf", "png"):
        assert {f"figures/{name}.{kind}" for name in FIGURES} <= set(files)
    logs = {path.stem for path in (built.results / "logs").rglob("*.log")}
    assert set(DATASETS) | set(FIGURES) <= logs
    benchmarks = {path.stem for path in (built.results / "benchmarks").rglob("*.tsv")}
    assert set(DATASETS) | set(FIGURES) <= benchmarks


def test_nothing_is_left_to_do(built):
    assert "Nothing to be done" in built.snakemake("--dry-run")


def test_no_artefact_names_its_folder(built):
    for path in built.results.rglob("*"):
        if path.is_file() and path.suffix in (".nc", ".svg", ".pdf", ".png"):
            assert str(built.root).encode() not in path.read_bytes(), path


def test_lint(built):
    """The project's own environment, from the lock file, serves every rule: no rule names another."""
    said = built.snakemake("--lint", code=1)
    found = set(re.findall(r"^    \* (.*)$", said, re.MULTILINE))
    assert found == {"Specify a conda environment or container for each rule.:"}


def test_report(built):
    built.snakemake("--report", "report.html")
    text = (built.root / "report.html").read_text(encoding="utf-8")
    assert all(name in text for name in FIGURES)
    assert all(f'"{figure.section}": ' in text for figure in FIGURES.values())
    promised = [name for name, figure in FIGURES.items() if figure.promise]
    assert text.count("The paper's figure shows ") == len(promised)
    assert "Replication of Lynch and Mason" in text


@pytest.mark.parametrize(
    ("module", "stale"),
    [
        ("figures/paper/figure_06.py", {"figure": 1}),
        ("study/datasets/contact_modes.py", {"dataset": 1, "figure": 1}),
        ("mechanics/limit_curve.py", {"dataset": 3, "figure": 13, "claims_table": 1}),
        (
            "mechanics/modes.py",
            {
                "dataset": 2,
                "figure": 10,
                "simulation": 3,
                "simulation_figure": 3,
                "claims_table": 1,
            },
        ),
        ("figures/motion/trajectory.py", {"figure": 2, "simulation_figure": 3}),
        ("commands/query.py", {}),
    ],
)
def test_only_what_depends_on_a_module_reruns(built, module, stale):
    path = built.root / "src/planar_pushing" / module
    text = path.read_text(encoding="utf-8")
    times = path.stat().st_atime, path.stat().st_mtime
    path.write_text(text + "\n# an edit\n", encoding="utf-8")
    try:
        said = built.snakemake("--dry-run")
    finally:
        path.write_text(text, encoding="utf-8")
        os.utime(path, times)
    assert (jobs(said) if stale else {"all": 1}) == stale | {"all": 1}
    assert stale or "Nothing to be done" in said


def test_an_edited_module_is_rebuilt_once(built):
    path = built.root / "src/planar_pushing/figures/paper/figure_06.py"
    path.write_text(path.read_text(encoding="utf-8") + "\n# an edit\n", encoding="utf-8")
    before = built.digests()
    assert jobs(built.snakemake())["figure"] == 1
    assert built.digests() == before
    assert "Nothing to be done" in built.snakemake("--dry-run")


#: Entries of the smoke study that show an effect, and those that simulate.
SHOW = {
    "inertia": ("inertia:", *(f"figure_{n}:" for n in ("09a", "09b", "10", "11", "12"))),
    "support_friction": (
        "support_friction:",
        *(f"figure_{n}:" for n in ("01", "02", "03", "05", "06", "07", "08", "11", "12")),
    ),
}
SIMULATE = ("simulations:", "figure_14a:", "figure_14b:", "figure_15:")


def with_one_effect(smoke, kept, dropped):
    """The smoke study with one effect, and without the entries that others or this list need."""
    shown = [name for effect, names in SHOW.items() if effect != kept for name in names]
    lines = [line for line in smoke.splitlines() if not line.strip().startswith((*shown, *dropped))]
    every = "effects: [support_friction, inertia, support_friction+inertia]"
    assert every in smoke
    return "\n".join(lines).replace(every, f"effects: [{kept}]")


def test_golden_check_fails_the_run_and_says_why(fresh):
    """A study of few figures: the check reads all that is built."""
    smoke = fresh.root / fresh.study
    text = with_one_effect(smoke.read_text(encoding="utf-8"), "inertia", SIMULATE)
    smoke.write_text(f"{text}\ngolden: golden\n", encoding="utf-8")
    golden = smoke.parent / "golden/motion_cones.nc"
    write_dataset(xr.Dataset(), golden)
    target = f"{fresh.results.relative_to(fresh.root)}/data/motion_cones.nc"
    fresh.snakemake(target)
    cones = read_dataset(fresh.root / target)
    write_dataset(cones, golden)
    assert jobs(fresh.snakemake("golden"))["golden_verdict"] == 1
    verdict = fresh.results / "tables/golden_verdict.txt"
    assert verdict.read_text(encoding="utf-8").startswith("passed: ")
    assert not list((fresh.root / "results").glob("*.*"))
    cones["motion_cone_left"][0, 0, 0, 0] += 1e-9
    write_dataset(cones, golden)
    said = fresh.snakemake("golden", code=1)
    assert "FAILED: 1 of " in said
    assert "FAIL motion_cones: motion_cone_left (enclosure): 1 of 32 differ; worst 1e-09" in said
    assert "effects=inertia, rod_length=0.0, rod_angle=45.0" in said
    assert not verdict.exists()


def outputs(built):
    """Every file that the study's jobs write, by Snakemake's own account."""
    lines = built.snakemake("--summary").splitlines()
    rows = lines[next(i for i, line in enumerate(lines) if line.startswith("output_file")) + 1 :]
    return {line.split("\t")[0] for line in rows if line.startswith("results/")}


def targets(built):
    """Every file that the default target asks for."""
    said = built.snakemake("--dry-run", "--forcerun", "all")
    return set(re.search(r"rule all:\n +input: (.*)\n", said)[1].split(", "))


def test_every_output_is_a_target(built):
    """What no target asks for is not rebuilt when it is deleted."""
    found = outputs(built)
    assert found == targets(built)
    names = ("tables/claims.csv", "tables/claims.json", "figures/data/figure_04.nc")
    assert {f"results/studies/smoke/{name}" for name in names} <= found


def test_every_output_of_the_papers_study_is_a_target(fresh):
    shutil.copytree(PROJECT / "tests/golden", fresh.root / "tests/golden")
    whole = replace(fresh, study="workflow/config/paper.yaml")
    found = outputs(whole)
    assert found == targets(whole)
    others = {name.split("/")[2] for name in found if name.startswith("results/studies")}
    assert others == {"sliders"}  # which the report shows
    assert {"results/tables/claims.csv", "results/tables/numbers.json"} <= found


def test_a_deleted_output_is_rebuilt(built):
    path = built.results / "tables/claims.csv"
    before = path.read_bytes()
    path.unlink()
    built.snakemake()
    assert path.read_bytes() == before


def test_every_dataset_names_the_study_and_its_digest(built):
    marks = provenance(built.root / built.study)
    for path in built.results.rglob("*.nc"):
        attrs = read_attributes(path)
        assert {name: attrs.get(name) for name in marks} == marks, path
        assert attrs["Conventions"] == "CF-1.11"


def test_a_started_study_runs_from_its_own_folder(fresh, tmp_path):
    assert main(["init", str(tmp_path / "elsewhere")]) == 0
    mine = replace(fresh, study=str(tmp_path / "elsewhere/my_study.yaml"))
    target = mine.results.relative_to(mine.root)
    mine.snakemake(f"{target}/data/motion_cones.nc", f"{target}/data/simulations/push_and_pull.nc")
    assert read_attributes(mine.results / "data/motion_cones.nc")["study"] == "my_study"
    assert str(tmp_path).encode() not in (mine.results / "data/motion_cones.nc").read_bytes()


@pytest.mark.parametrize(
    ("config", "said"),
    [
        ("studdy=x", "config: 'studdy' given; allowed: the key study; did you mean study?"),
        ("study=5", "study: 5 given; allowed: the path of a study file"),
        ("study=", "given; allowed: the path of a study file"),
    ],
)
def test_a_wrong_configuration_stops_before_any_job(fresh, config, said):
    run = [sys.executable, "-m", "snakemake", "--dry-run", "--config", config]
    done = subprocess.run(
        run, cwd=fresh.root, env=fresh.environment, capture_output=True, text=True, check=False
    )
    told = done.stdout + done.stderr
    assert done.returncode == 1
    assert said in told
    assert "Traceback" not in told


def test_a_folder_with_a_space_is_refused_before_any_job(tmp_path):
    (tmp_path / "a folder").mkdir()
    said = copy_project(tmp_path / "a folder").snakemake("--dry-run", code=1)
    assert "a folder: Snakemake runs in no folder with a space; move the project" in said
    assert "Traceback" not in said


def test_a_wrong_study_stops_before_any_job(fresh):
    study = fresh.root / "workflow/config/smoke.yaml"
    text = study.read_text(encoding="utf-8")
    study.write_text(text.replace("rod_length: [0, 1, 2, 5]", "rod_length: [-1]"), encoding="utf-8")
    said = fresh.snakemake(code=1)
    assert (
        "workflow/config/smoke.yaml: grid.rod_length[0]: -1 given; "
        "allowed: a finite number >= 0; change the value" in said
    )
    assert "Traceback" not in said
    assert not (fresh.root / "results").exists()


def test_a_missing_study_stops_before_any_job(fresh):
    (fresh.root / "workflow/config/smoke.yaml").unlink()
    said = fresh.snakemake(code=1)
    assert "workflow/config/smoke.yaml: no such file; give the path of a YAML file" in said


def test_a_study_without_an_effect_has_no_job_for_it(fresh):
    study = fresh.root / "workflow/config/smoke.yaml"
    text = with_one_effect(study.read_text(encoding="utf-8"), "support_friction", ())
    study.write_text(text, encoding="utf-8")
    said = fresh.snakemake("--dry-run", "--printshellcmds", "all")
    jobs = said[: said.index("Reasons:")] if "Reasons:" in said else said
    assert "acceleration_centers" not in jobs
    assert not any(f"figure_{n}" in jobs for n in ("09", "10", "11", "12"))
    folder = fresh.results.relative_to(fresh.root)
    fresh.snakemake(f"{folder}/figures/figure_13.svg", f"{folder}/data/scenes.nc")
    modes = read_dataset(fresh.results / "data/contact_modes.nc")
    assert list(modes.effects.values) == ["support_friction"]
    assert "inertia" not in modes.attrs["parameters"]
