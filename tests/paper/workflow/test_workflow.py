"""The workflow on the smoke study, end to end."""

import os
import re
import shutil
import signal
import subprocess
import time
from contextlib import ExitStack, contextmanager
from dataclasses import replace

import pytest
from workflow.conftest import PROJECT, copy_project, few_targets

from planar_pushing.commands import main
from planar_pushing.terms.netcdf import read_attributes, write_dataset
from pulling_by_pushing.evidence.golden.compare import KIND, Kind
from pulling_by_pushing.evidence.golden.digests import list_digests
from pulling_by_pushing.figures.figure import entry
from pulling_by_pushing.figures.studies import SECTIONS
from pulling_by_pushing.report.closing import closing_lines
from pulling_by_pushing.study.catalog import DATASETS
from pulling_by_pushing.study.store import read_dataset
from pulling_by_pushing.study.study_file import load_study

CONFIG = "workflow/config/smoke.yaml"
FIGURES = load_study(CONFIG).figures
#: Sections of figures of which the study draws none.
OTHER_SECTIONS = {section for section, names in SECTIONS.items() if not set(names) & set(FIGURES)}
#: Datasets of a study without supports.
OF_RING = [name for name, each in DATASETS.items() if "support" not in each.dims]


def jobs(said):
    """Numbers of jobs by rule, from the job table of a run or a dry run; none where nothing is left."""
    if "Nothing to be done" in said:
        return {"all": 1}
    table = re.search(r"Job stats:\njob +count\n[- ]+\n(.*?)\ntotal", said, re.DOTALL)
    return {name: int(count) for name, count in re.findall(r"(\w+) +(\d+)", table[1])}


def drawings(*sections, study="smoke"):
    """A job for each of these sections of figures of a study."""
    return {f"figures_{section}_{study}": 1 for section in sections}


@contextmanager
def edited(path, old="", new="\n# an edit\n"):
    """A file with another text, by default with a comment at its end, for a while."""
    text, status = path.read_text(encoding="utf-8"), path.stat()
    assert old in text
    path.write_text(text.replace(old, new) if old else text + new, encoding="utf-8")
    try:
        yield
    finally:
        path.write_text(text, encoding="utf-8")
        os.utime(path, (status.st_atime, status.st_mtime))


@pytest.mark.slow
def test_everything_is_built_and_nothing_is_left_to_do(built):
    files = built.digests()
    assert {f"data/{name}.nc" for name in OF_RING} <= set(files)
    for kind in ("svg", "pdf", "png"):
        assert {f"figures/{name}.{kind}" for name in FIGURES} <= set(files)
    for folder, kind in (("logs", "log"), ("benchmarks", "tsv")):
        found = {path.stem for path in (built.results / folder).rglob(f"*.{kind}")}
        assert set(OF_RING) | set(SECTIONS) - OTHER_SECTIONS <= found
    assert "Nothing to be done" in built.snakemake("--dry-run")
    lines = closing_lines(built.results)
    assert [line.split()[0] for line in lines] == ["Report", "Golden", "Claims", "Results"]
    assert "proved" in lines[2]
    for path in built.results.rglob("*"):
        if path.suffix in (".nc", ".svg", ".pdf", ".png"):
            assert str(built.root).encode() not in path.read_bytes(), path


#: A line that changes the code of a module.
CODE = ("", "\nEDITED = True\n")
#: Edits that change nothing that a job of `FEW_FILES` reads or runs.
WITHOUT_EFFECT = [
    (CONFIG, "rod_angle: [45, 90]", "rod_angle:  # degrees\n    - 45.0\n    - 90"),
    ("workflow/scenes/slipping.yaml",),
    ("src/planar_pushing/mechanics/solve.py",),  # with a comment
    ("src/pulling_by_pushing/study/datasets/center_regions.py", *CODE),
    ("src/pulling_by_pushing/figures/paper/figure_05.py", *CODE),
    ("src/pulling_by_pushing/commands/query.py", *CODE),
]
ADDED = "[0, 1.5, 2, inf]", "[0, 1.5, 2, 3, inf]"
PAPER = "src/pulling_by_pushing"


@pytest.mark.parametrize(
    ("edits", "stale"),
    [
        (WITHOUT_EFFECT, {"all": 1}),
        pytest.param(
            [(CONFIG, *ADDED)], {"motion_cones": 1} | drawings("contact_modes"), marks=pytest.mark.slow
        ),
        pytest.param(
            [(f"{PAPER}/figures/paper/figure_13.py", *CODE),
             ("src/planar_pushing/simulation/pusher.py", *CODE)],
            {"simulations_smoke": 1} | drawings("contact_modes"), marks=pytest.mark.slow,
        ),
    ],
)  # fmt: skip
def test_only_what_depends_on_edits_reruns(partly_built, edits, stale):
    with ExitStack() as every:
        for file, *change in edits:
            every.enter_context(edited(partly_built.root / file, *change))
        assert jobs(partly_built.snakemake("--dry-run", *few_targets())) == stale


AXIS = {"motion_cones": 1} | drawings("quasi_static", "dynamic", "contact_modes")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("file", "change", "stale"),
    [
        (CONFIG, (), {}),
        (CONFIG, ("rod_angle: [45, 90]", "rod_angle:\n    - 45.0\n    - 90"), {}),
        ("workflow/scenes/slipping.yaml", (), {}),
        (CONFIG, ADDED, AXIS),
        ("workflow/scenes/slipping.yaml", ("samples: 97", "samples: 9"),
         {"simulations_smoke": 1} | drawings("motion")),
        ("src/planar_pushing/mechanics/solve.py", (), {}),
        (f"{PAPER}/figures/paper/figure_05.py", CODE, drawings("quasi_static")),
        (f"{PAPER}/study/datasets/motion_cones.py", CODE, AXIS),
        (f"{PAPER}/study/datasets/center_regions.py", CODE, {"center_regions": 1}),
        ("src/planar_pushing/simulation/pusher.py", CODE,
         dict.fromkeys(("simulations_smoke", "model_errors", "model_estimates"), 1)
         | drawings("motion", "effects")),
        (f"{PAPER}/commands/query.py", CODE, {}),
    ],
)  # fmt: skip
def test_only_what_depends_on_a_change_reruns(built, file, change, stale):
    with edited(built.root / file, *change):
        assert jobs(built.snakemake("--dry-run")) == stale | {"all": 1}


#: Entries of the smoke study that show an effect.
SHOW = {
    "inertia": ("inertia:", *(f"figure_{n}:" for n in ("09", "09a", "09b", "10", "11", "12"))),
    "support_friction": (
        "support_friction:",
        *(f"figure_{n}:" for n in ("01", "02", "03", "04", "05", "06", "07", "08", "11", "12")),
    ),
}


def with_one_effect(smoke, kept, dropped):
    """The smoke study with one effect, and without the entries that others or this list need."""
    shown = [name for effect, names in SHOW.items() if effect != kept for name in names]
    lines = [line for line in smoke.splitlines() if not line.strip().startswith((*shown, *dropped))]
    every = "effects: [support_friction, inertia, support_friction+inertia]"
    assert every in smoke
    return "\n".join(lines).replace(every, f"effects: [{kept}]")


CONES = """title: Cones
slider: {radius: 1, rod_angle: 45}
inertia: {mass: 1, gyration_radius: 1}
grid:
  effects: [inertia]
  rod_length: [0, 1]
  rod_angle: [45]
  friction_coefficient: [0, 2]
golden: golden
"""


def write_golden(cones, path):
    """Golden data without radii, and the digest of their file."""
    write_dataset(cones.assign_attrs({KIND: str(Kind.ENCLOSED)}), path)
    list_digests(path.parent, [path.stem])


@pytest.mark.slow
def test_golden_check_fails_the_run_after_everything_else_and_says_why(fresh):
    study = fresh.root / fresh.study
    study.write_text(CONES, encoding="utf-8")
    golden = study.parent / "golden/motion_cones.nc"
    golden.parent.mkdir()
    target = f"{fresh.results.relative_to(fresh.root)}/data/motion_cones.nc"
    fresh.snakemake(target)
    cones = read_dataset(fresh.root / target)
    cones["motion_cone_left"][0, 0, 0, 0] += 1e-9
    write_golden(cones, golden)
    verdict, passed = (
        fresh.results / f"tables/golden_{name}.txt" for name in ("verdict", "passed")
    )
    for _ in range(2):  # a second run does nothing but fail again
        said = fresh.snakemake(code=1)
        assert "FAILED: golden_passed (Requiring that every value of results/studies/smoke" in said
        assert "FAILED: 1 of " in said
        assert "FAIL motion_cones: motion_cone_left (compared with stored values): 1 of 4" in said
        assert "effects=inertia, rod_length=0.0, rod_angle=45.0" in said
        assert verdict.read_text(encoding="utf-8").startswith("FAILED: 1 of ")
        assert not passed.exists()
    assert jobs(said) == {"golden_passed": 1, "all": 1}
    write_golden(read_dataset(fresh.root / target), golden)
    own = {"golden_verdict": 1, "golden_passed": 1}
    assert jobs(fresh.snakemake("golden")) == {**own, "golden": 1}
    assert verdict.read_text(encoding="utf-8").startswith("passed: ")
    assert passed.is_file()


@pytest.mark.slow
def test_a_killed_run_goes_on_without_a_word(partly_built, fresh):
    """What a killed run has left is finished by a plain one, to the bytes of another build."""
    targets = few_targets()
    with subprocess.Popen(
        fresh.command(*targets), cwd=fresh.root, env=fresh.environment, start_new_session=True,
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    ) as run:  # fmt: skip
        while not any((fresh.results / "data").glob("*.nc")):  # others come and go
            assert run.poll() is None, "the run ended before it could be killed"
            time.sleep(0.05)
        os.killpg(run.pid, signal.SIGKILL)
    assert list((fresh.root / ".snakemake/locks").iterdir())
    assert not (fresh.root / targets[-1]).exists()
    fresh.snakemake(*targets)
    assert fresh.digests() == partly_built.digests()


@pytest.mark.slow
def test_lint(built):
    """The project's own environment, from the lock file, serves every rule: no rule names another."""
    said = built.snakemake("--lint", code=1)
    found = set(re.findall(r"^    \* (.*)$", said, re.MULTILINE))
    assert found == {"Specify a conda environment or container for each rule.:"}


@pytest.mark.slow
def test_report(built):
    said = built.snakemake("--report", "report.html")
    text = (built.root / "report.html").read_text(encoding="utf-8")
    assert all(name in text for name in FIGURES)
    assert all(f'"{entry(name).section}": ' in text for name in FIGURES)
    captions = 0  # that of each picture describes all of its section
    for names in SECTIONS.values():
        drawn = [name for name in names if name in FIGURES]
        captions += len(drawn) * sum(bool(entry(name).promise) for name in drawn)
    assert text.count("The paper's figure shows ") == captions
    assert "WARNING" not in said
    assert "System Message" not in text
    assert "Replication of Lynch and Mason" in text


@pytest.mark.slow
def test_an_edited_module_is_rebuilt_once(built):
    with edited(built.root / "src/pulling_by_pushing/figures/paper/figure_05.py", *CODE):
        before = built.digests()
        assert jobs(built.snakemake()) == drawings("quasi_static") | {"all": 1}
        assert built.digests() == before
        assert "Nothing to be done" in built.snakemake("--dry-run")
    built.snakemake()


def outputs(built):
    """Every file that the study's jobs write, by Snakemake's own account."""
    lines = built.snakemake("--summary").splitlines()
    rows = lines[next(i for i, line in enumerate(lines) if line.startswith("output_file")) + 1 :]
    return {line.split("\t")[0] for line in rows if line.startswith("results/")}


def targets(built):
    """Every file that the default target asks for."""
    said = built.snakemake("--dry-run", "--forcerun", "all", "--quiet", "host")
    return set(re.search(r"rule all:\n +input: (.*)\n", said)[1].split(", "))


@pytest.mark.slow
def test_every_output_is_a_target(built):
    """What no target asks for is not rebuilt when it is deleted."""
    found = outputs(built)
    assert found == targets(built)
    names = ("tables/claims.csv", "tables/claims.json", "figures/figure_04.svg")
    assert {f"results/studies/smoke/{name}" for name in names} <= found


@pytest.mark.slow
def test_every_output_of_the_papers_study_is_a_target(fresh):
    shutil.copytree(PROJECT / "tests/golden", fresh.root / "tests/golden")
    whole = replace(fresh, study="workflow/config/paper.yaml")
    found = outputs(whole)
    assert found == targets(whole)
    others = {name.split("/")[2] for name in found if name.startswith("results/studies")}
    assert others == {"sliders"}  # which the report shows
    assert {"results/tables/claims.csv", "results/tables/numbers.json"} <= found


@pytest.mark.slow
def test_a_deleted_output_is_rebuilt(built):
    path = built.results / "tables/claims.csv"
    before = path.read_bytes()
    path.unlink()
    built.snakemake()
    assert path.read_bytes() == before


@pytest.mark.slow
def test_a_started_study_runs_from_its_own_folder(fresh, tmp_path):
    assert main(["init", str(tmp_path / "elsewhere")]) == 0
    mine = replace(fresh, study=str(tmp_path / "elsewhere/my_study.yaml"))
    target = mine.results.relative_to(mine.root)
    mine.snakemake(f"{target}/data/motion_cones.nc", f"{target}/data/simulations/push_and_pull.nc")
    assert read_attributes(mine.results / "data/motion_cones.nc")["study"] == "my_study"
    assert str(tmp_path).encode() not in (mine.results / "data/motion_cones.nc").read_bytes()


WRONG = [
    (CONFIG, "rod_length: [0, 1, 2, 5]", "rod_length: [-1]",
     f"{CONFIG}: grid.rod_length[0]: -1 given; allowed: a finite number >= 0; change the value"),
    ("workflow/config/sliders_smoke.yaml", "weights: [1, 1, 1]", "weights: [1, 1, -1]",
     "workflow/config/sliders_smoke.yaml: supports.tripod.weights"),
]  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize(("file", "old", "new", "message"), WRONG)
def test_a_wrong_study_stops_before_any_job(fresh, file, old, new, message):
    with edited(fresh.root / file, old, new):
        said = fresh.dry("--config", f"study={file}", code=1)
    assert message in said
    assert "Traceback" not in said
    assert not (fresh.root / "results").exists()


@pytest.mark.slow
def test_a_wrong_configuration_stops_before_any_job(fresh):
    said = fresh.dry("--config", "studdy=x", code=1)
    assert (
        "config: 'studdy' given; allowed: the keys study, results and data; did you mean study?"
        in said
    )
    assert "Traceback" not in said


@pytest.mark.slow
def test_a_folder_with_a_space_is_refused_before_any_job(tmp_path):
    (tmp_path / "a folder").mkdir()
    said = copy_project(tmp_path / "a folder").snakemake("--dry-run", code=1)
    assert "a folder: Snakemake cannot run in a path with a space; move the project" in said
    assert "Traceback" not in said


@pytest.mark.slow
def test_a_study_without_an_effect_has_no_job_for_it(fresh):
    study = fresh.root / "workflow/config/smoke.yaml"
    text = with_one_effect(study.read_text(encoding="utf-8"), "support_friction", ())
    study.write_text(text, encoding="utf-8")
    said = fresh.snakemake("--dry-run", "--printshellcmds", "all")
    jobs = said[: said.index("Reasons:")] if "Reasons:" in said else said
    assert "acceleration_centers" not in jobs
    assert not any(f"figure_{n}" in jobs for n in ("09", "10", "11", "12"))
    folder = fresh.results.relative_to(fresh.root)
    built = ("figures/figure_13.svg", "data/scenes.nc", "data/contact_modes.nc")
    fresh.snakemake(*(f"{folder}/{name}" for name in built))
    modes = read_dataset(fresh.results / "data/contact_modes.nc")
    assert list(modes.effects.values) == ["support_friction"]
    assert "inertia" not in modes.attrs["parameters"]
