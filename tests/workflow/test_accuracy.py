"""What accuracy costs is measured by its own target alone."""

import re
import shutil
from dataclasses import replace

from workflow.conftest import PROJECT


def jobs(said):
    """Numbers of jobs by rule, from the job table of a dry run."""
    table = re.search(r"Job stats:\njob +count\n[- ]+\n(.*?)\ntotal", said, re.DOTALL)
    return dict(re.findall(r"(\w+) +(\d+)", table[1]))


def test_the_target_measures_once_and_draws_its_figures(built):
    said = built.snakemake("--dry-run", "accuracy")
    assert jobs(said) == {
        "accuracy": "1",
        "accuracy_data": "1",
        "accuracy_figure": "4",
        "effects_data": "1",
        "effects_figure": "1",
        "evaluations": "1",
    }


def test_the_default_target_leaves_it_out(built):
    assert "accuracy" not in built.snakemake("--dry-run")


def test_the_supplement_belongs_to_the_target_and_the_counts_to_the_report(fresh):
    shutil.copytree(PROJECT / "tests/golden", fresh.root / "tests/golden")
    whole = replace(fresh, study="workflow/config/paper.yaml")
    measured, default = (jobs(whole.snakemake("--dry-run", name)) for name in ("accuracy", "all"))
    assert {"supplement_tables", "supplement_pdf"} <= set(measured)
    assert not {"paper_pdf", "report_tables"} & set(measured)
    counted = {"accuracy_errors", "evaluations", "evaluations_figure", "hard_cases_data"}
    assert counted | {"report_tables", "paper_pdf"} <= set(default)
    timed = {"accuracy_data", "accuracy_figure", "effects_data", "effects_figure"}
    assert not (timed | {"supplement_pdf"}) & set(default)
