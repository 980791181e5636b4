"""A study in chunks: only the chunks that hold a changed value are computed anew."""

import re
import subprocess
import sys

import pytest
import xarray as xr
from workflow.chunked import ENVIRONMENT, RESULTS, STUDY, copy_workflow, files, snakemake

import planar_pushing as pp
from pulling_by_pushing.study.describe import add_study_attributes
from pulling_by_pushing.study.provenance import provenance
from pulling_by_pushing.study.running.build import build_dataset
from pulling_by_pushing.study.slices import study_slice
from pulling_by_pushing.study.study_file import load_study

pytestmark = pytest.mark.slow

CHUNKS = """
chunks: {motion_cones: {friction_coefficient: 3}, acceleration_centers: {force_angle: 8}}
gather: {acceleration_centers: false}
"""
SMOKE = "workflow/config/smoke.yaml"
TARGETS = [f"{RESULTS}/data/{name}.nc" for name in ("motion_cones", "acceleration_centers")]


@pytest.fixture(scope="session")
def root(tmp_path_factory):
    """A folder in which the datasets in chunks are built."""
    found = copy_workflow(tmp_path_factory.mktemp("chunked"), CHUNKS)
    snakemake(found, *TARGETS)
    return found


def planned(root, *arguments):
    """The chunks that a run would compute."""
    said = snakemake(root, "--dry-run", *arguments, *TARGETS, "--quiet", "host")
    return set(re.findall(r"Computing (\S+) of \w+", said)), said


def change(root, written, instead):
    path = root / STUDY
    text = path.read_text(encoding="utf-8")
    assert written in text
    path.write_text(text.replace(written, instead), encoding="utf-8")


def test_each_chunk_is_a_file_and_nothing_is_left_to_do(root):
    chunks = {name for name in files(root) if name.startswith("chunks/")}
    assert chunks == {
        *(f"chunks/motion_cones/friction_coefficient_{start}.nc" for start in (0, 3)),
        *(f"chunks/acceleration_centers/force_angle_{start}.nc" for start in (0, 8)),
    }
    assert "Nothing to be done" in planned(root)[1]


def test_the_datasets_are_those_in_one_piece(root):
    for name in ("motion_cones", "acceleration_centers"):
        found = pp.open_dataset(name, root / "results", study="split")
        whole = build_dataset(name, study_slice(load_study(SMOKE), name))
        expected = add_study_attributes(
            whole, name, provenance(load_study(root / STUDY), root / STUDY)(name)
        )
        xr.testing.assert_identical(found.compute(), expected)
    assert found.chunks


@pytest.mark.parametrize(
    ("written", "instead", "chunks"),
    [
        ("[0, 1.5, 2, inf]", "[0.1, 1.5, 2, inf]", {"friction_coefficient_0"}),
        ("[0, 1.5, 2, inf]", "[0, 1.5, 2, 7, inf]", {"friction_coefficient_3"}),
        ("[0, 1.5, 2, inf]", "[0, 1.5, 2, 3, 4, 5, inf]",
         {"friction_coefficient_3", "friction_coefficient_6"}),
        ("figure_12: {rod_length: 5}", "figure_12: {rod_length: 2}", set()),
    ],
)  # fmt: skip
def test_a_change_computes_the_chunks_that_hold_it(root, written, instead, chunks):
    before = (root / STUDY).read_text(encoding="utf-8")
    change(root, written, instead)
    try:
        assert planned(root)[0] == chunks
    finally:
        (root / STUDY).write_text(before, encoding="utf-8")


WITHOUT_DASK = """
import sys
sys.modules["dask"] = None
from snakemake.cli import main
main(sys.argv[1:])
"""


def test_chunks_without_dask_are_refused_before_any_job(tmp_path):
    copy_workflow(tmp_path, CHUNKS)
    arguments = "--cores", "1", "data", "--config", f"study={STUDY}"
    done = subprocess.run(
        [sys.executable, "-c", WITHOUT_DASK, *arguments], cwd=tmp_path, env=ENVIRONMENT,
        capture_output=True, text=True, timeout=600, check=False,
    )  # fmt: skip
    assert done.returncode == 1
    assert (
        "dask: not installed; install the extra chunks: pip install '.[chunks]' in the project's folder"
        in done.stderr
    )
    assert not (tmp_path / "results").exists()
