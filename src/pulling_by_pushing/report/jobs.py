"""Functions that the workflow's jobs for the report call."""

from __future__ import annotations

from pathlib import Path

from pulling_by_pushing.evidence.writing import write_text
from pulling_by_pushing.report import tables
from pulling_by_pushing.report.costs.tables import COST_TABLES
from pulling_by_pushing.report.provenance import provenance_text
from pulling_by_pushing.report.results import Results

TABLES = {
    "numbers": tables.numbers_text,
    "figures": tables.figures_text,
    "infinite_friction_cones": tables.cones_text,
    "ellipsoids": tables.ellipsoids_text,
    "golden_summary": tables.verdict_text,
    "golden_failures": tables.failures_text,
    **COST_TABLES,
}


def report_tables(*, results: str, golden: str, **paths: str) -> None:
    """Write the tables of the report, each to the path given under its name."""
    found = Results(Path(results), Path(golden))
    texts = {name: text(found) for name, text in TABLES.items()}
    for name, path in paths.items():
        write_text(texts[name], path)


def report_provenance(output: str, *, study: str, results: str, golden: str, state: str) -> None:
    """Write the table that identifies the code, the state of the repository, and the study."""
    write_text(provenance_text(Results(Path(results), Path(golden)), study, state), output)
