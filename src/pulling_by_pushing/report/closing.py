"""The end of a run: the golden check is required, and the last lines of `make` say what was built."""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from planar_pushing.terms.errors import InvalidResult
from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.evidence.writing import write_text
from pulling_by_pushing.study.running.jobs import run_command
from pulling_by_pushing.study.studies import (
    KEY,
    SLIDERS_FILE,
    chosen_study,
    study_folder,
    study_name,
)

#: Number of lines of a failed verdict that are shown, the worst first.
WORST = 8


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


def closing_lines(folder: Path, others: tuple[Path, ...] = ()) -> list[str]:
    """Four lines about a results folder, with the combined verdicts of this and other folders."""
    report = folder / "paper.pdf"
    rows = {
        "Report": _report(report) if report.is_file() else "none; only the paper's study has one",
        "Golden": _verdict([folder, *others]),
        "Claims": _claims(folder / "tables/claims.json"),
        "Results": f"{folder}/data and {folder}/figures; results/README.md describes them",
    }
    return [f"{name:<9}{text}" for name, text in rows.items()]


def _report(path: Path) -> str:
    """Path of the report; one from a tree that differs from its commit is not for others."""
    table = path.parent / "tables/provenance.csv"
    changed = table.is_file() and "with changes" in table.read_text(encoding="utf-8")
    note = "; not for publication, as the tree has changes: commit them and run make again"
    return f"{path}{note if changed else ''}"


def _read(path: Path) -> Any:
    return json.loads(path.read_text(encoding="utf-8")) if path.is_file() else None


def _verdict(folders: Sequence[Path]) -> str:
    """Combined golden verdict of several studies."""
    files = [folder / "tables/golden_verdict.json" for folder in folders]
    verdicts = [verdict for verdict in map(_read, files) if verdict]
    if not verdicts:
        return "not compared, as the study names no golden data"
    word = "passed" if all(verdict["passed"] for verdict in verdicts) else "FAILED"
    counts = {
        kind: sum(verdict["kinds"][kind]["values"] for verdict in verdicts)
        for kind in verdicts[0]["kinds"]
    }
    enclosed = counts.pop("enclosed")
    return f"{word}: {enclosed:,} numbers enclosed, {sum(counts.values()):,} compared otherwise"


def _claims(path: Path) -> str:
    table = _read(path)
    if table is None:
        return "not checked; they are about the paper's ring"
    return ", ".join(f"{count} {verdict}" for verdict, count in table["counts"].items())


def main() -> int:
    """Print the lines for the study on the command line, or for the two default studies."""
    arguments = sys.argv[1:]
    file = chosen_study({KEY: arguments[0]} if arguments else {})
    others = () if arguments else (study_folder(study_name(SLIDERS_FILE)),)
    print(*closing_lines(study_folder(study_name(file)), others), sep="\n")
    return 0


if __name__ == "__main__":
    sys.exit(run_command(main))
