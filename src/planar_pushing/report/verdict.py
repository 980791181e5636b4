"""Summary of the golden verdicts of both studies: their counts, and one line for each dataset."""

from __future__ import annotations

from collections import defaultdict
from typing import Any

from planar_pushing.report.quantities import Quantity, significant
from planar_pushing.report.results import Results
from planar_pushing.terms.errors import InvalidFile

#: One comparison of a verdict.
Check = dict[str, Any]
SOURCE = "tables/golden_verdict.json"
#: Kinds of golden values, as named in verdicts.
KINDS = ("enclosed", "searched", "integrated", "plain")
#: The kind that is compared with stored values only.
STORED = "plain"


def _passed(results: Results) -> list[dict[str, Any]]:
    for found in results.verdicts:
        if not found["passed"]:
            raise InvalidFile(
                f"{results.folder}/{SOURCE}: the golden check did not pass; build it again"
            )
    return results.verdicts


def verdict_word() -> Quantity:
    """Quantity that says whether the checks passed."""
    return Quantity(
        read=lambda results: "passed" if _passed(results) else "",
        digits=0,
        unit="1",
        source=f"{SOURCE}: verdict",
    )


def kind_count(kind: str, part: str = "values") -> Quantity:
    """Number of compared values or variables of one kind of golden data."""
    return Quantity(
        read=lambda results: float(sum(each["kinds"][kind][part] for each in _passed(results))),
        digits=0,
        unit="1",
        source=f"{SOURCE} of both studies: {part} of the kind {kind}",
    )


def independent_share() -> Quantity:
    """Share of the compared numbers that have a reference from an independent computation."""

    def read(results: Results) -> float:
        counts = {
            kind: sum(int(each["kinds"][kind]["values"]) for each in _passed(results))
            for kind in KINDS
        }
        return 100 * (1 - counts[STORED] / sum(counts.values()))

    source = f"{SOURCE} of both studies: values of all kinds but {STORED}"
    return Quantity(read=read, digits=0, unit="percent", source=source)


def label_count() -> Quantity:
    """Number of entries that are not finite numbers."""
    return Quantity(
        read=lambda results: float(sum(each["labels"] for each in _passed(results))),
        digits=0,
        unit="1",
        source=f"{SOURCE} of both studies: labels",
    )


def mark_count(mark: str, join: Any) -> Quantity:
    """Number stored as an attribute in golden files."""

    def read(results: Results) -> float:
        return float(join(marks[mark] for marks in results.golden_marks() if mark in marks))

    return Quantity(read=read, digits=0, unit="1", source=f"golden data: {mark}")


def verdict_rows(results: Results) -> list[dict[str, str]]:
    """Number of variables and finite values, worst error and its tolerance, by dataset.

    Scenes, logs and figures are each counted together.
    """
    groups: dict[str, list[Check]] = defaultdict(list)
    for found in _passed(results):
        for check in found["checks"]:
            if check["count"]:
                groups[check["file"].partition("/")[0]].append(check)
    return [_row(name, groups[name]) for name in sorted(groups)]


def _row(name: str, checks: list[Check]) -> dict[str, str]:
    used = max(checks, key=_used)
    return {
        "compared": name.replace("_", " "),
        "variables": str(len(checks)),
        "values": str(sum(check["count"] for check in checks)),
        "worst difference": significant(used["error"]),
        "allowed there": significant(used["allowed"]),
    }


def _used(check: Check) -> float:
    return float(check["error"] / check["allowed"]) if check["allowed"] else 0.0
