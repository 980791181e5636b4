"""Entry points of the jobs on evidence; each imports only the extras that it needs."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from planar_pushing.terms.errors import InvalidResult
from planar_pushing.terms.netcdf import write_dataset
from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.evidence.writing import json_text, write_text
from pulling_by_pushing.study.describe import of_study

Attributes = Mapping[str, str]
#: Number of lines of a failed verdict that are shown, the worst first.
WORST = 8


def golden(data: PathLike, text: PathLike, *, study: str, results: str) -> None:
    """Compare the results of a study with its golden data, and write the verdict, passed or failed."""
    from pulling_by_pushing.evidence.golden.check import check_results
    from pulling_by_pushing.evidence.golden.verdict import verdict, verdict_text

    found = verdict(check_results(Path(results), study))
    write_text(verdict_text(found), text)
    write_text(json_text(found), data)


def require_golden(verdict: PathLike, passed: PathLike) -> None:
    """Write a file that says that the golden check has passed; this job runs after all others.

    Raises
    ------
    InvalidResult
        If a value differs; the message contains the worst differences, and nothing is written.
    """
    lines = Path(verdict).read_text(encoding="utf-8").splitlines()
    failed = [line for line in lines if line.startswith("FAIL")]
    if failed:
        rest = [f"and {len(failed) - 1 - WORST} more"] if len(failed) - 1 > WORST else []
        where = f"{verdict} lists all; everything else is built, and the report names the failures"
        raise InvalidResult("\n".join([*failed[: WORST + 1], *rest, where]))
    write_text(f"{lines[0]}\n", passed)


def claims(json: PathLike, csv: PathLike, *, ledger: str) -> None:
    """Judge the claims of the ledger, and write the table.

    Raises
    ------
    InvalidResult
        If a verdict is not the one that the ledger expects; nothing is written.
    """
    from pulling_by_pushing.evidence.claims import table
    from pulling_by_pushing.evidence.claims.ledger import judge_all, load_ledger

    listed = load_ledger(ledger)
    judged = judge_all(listed)
    if problem := table.complaint(judged):
        raise InvalidResult(problem)
    rows = table.rows(listed, judged)
    write_text(table.json_text(rows), json)
    write_text(table.csv_text(rows), csv)


def hard_cases(path: PathLike, *, marks: Attributes) -> None:
    """Compute the hard cases and compare them with their references."""
    from pulling_by_pushing.evidence.hard_cases.dataset import build

    write_dataset(of_study(build(), "hard_cases", marks), path)


def accuracy(path: PathLike, *, marks: Attributes) -> None:
    """Compute errors and evaluations of every method."""
    from pulling_by_pushing.evidence.costs.measure import accuracy

    write_dataset(of_study(accuracy(), "accuracy", marks), path)


def accuracy_time(path: PathLike, *, marks: Attributes) -> None:
    """Measure the times of every method on this machine."""
    from pulling_by_pushing.evidence.costs.measure import accuracy_time

    write_dataset(of_study(accuracy_time(), "accuracy_time", marks), path)


def effects(path: PathLike, *, study: str, marks: Attributes) -> None:
    """Count the evaluations of each effect, and measure times on this machine."""
    from pulling_by_pushing.evidence.costs.effects import effects
    from pulling_by_pushing.study.study_file import load_study

    write_dataset(of_study(effects(load_study(study)), "effects", marks), path)
