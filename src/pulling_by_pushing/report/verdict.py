"""Summary of the golden verdicts of both studies: their counts, one line for each dataset, and failures."""

from __future__ import annotations

from collections import defaultdict
from itertools import islice
from typing import Any

from pulling_by_pushing.evidence.golden.verdict import used_tolerance
from pulling_by_pushing.report.quantities import Quantity, significant
from pulling_by_pushing.report.results import Results

#: One comparison of a verdict.
Check = dict[str, Any]
SOURCE = "tables/golden_verdict.json"
#: Kinds of golden values, as named in verdicts.
KINDS = ("enclosed", "integrated", "plain")
#: The kind that is compared with stored values only.
STORED = "plain"
#: Maximum number of failed comparisons that the report lists, the worst of each study first.
SHOWN = 12


def verdict_word() -> Quantity:
    """Quantity that says whether the checks passed."""
    return Quantity(
        read=lambda results: (
            "passed" if all(verdict["passed"] for verdict in results.verdicts) else "failed"
        ),
        digits=0,
        unit="1",
        source=f"{SOURCE}: verdict",
    )


def kind_count(kind: str, part: str = "values") -> Quantity:
    """Number of compared values or variables of one kind of golden data."""
    return Quantity(
        read=lambda results: float(
            sum(verdict["kinds"][kind][part] for verdict in results.verdicts)
        ),
        digits=0,
        unit="1",
        source=f"{SOURCE} of both studies: {part} of the kind {kind}",
    )


def independent_share() -> Quantity:
    """Share of the compared numbers that have a reference from an independent computation."""

    def read(results: Results) -> float:
        counts = {
            kind: sum(int(verdict["kinds"][kind]["values"]) for verdict in results.verdicts)
            for kind in KINDS
        }
        return 100 * (1 - counts[STORED] / sum(counts.values()))

    source = f"{SOURCE} of both studies: values of all kinds but {STORED}"
    return Quantity(read=read, digits=1, unit="percent", source=source)


def label_count() -> Quantity:
    """Number of entries that are not finite numbers."""
    return Quantity(
        read=lambda results: float(sum(verdict["labels"] for verdict in results.verdicts)),
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

    Scenes and logs are each counted together.
    """
    groups: dict[str, list[Check]] = defaultdict(list)
    for verdict in results.verdicts:
        for check in verdict["checks"]:
            if check["count"]:
                groups[check["file"].partition("/")[0]].append(check)
    return [_row(name, groups[name]) for name in sorted(groups)]


def failure_rows(results: Results) -> list[dict[str, str]]:
    """The worst failed comparisons of both studies, at most `SHOWN` of each."""
    return [
        _failure(check)
        for verdict in results.verdicts
        for check in islice((check for check in verdict["checks"] if not check["passed"]), SHOWN)
    ]


def _failure(check: Check) -> dict[str, str]:
    amount = f"{check['failed']} of {check['count'] + check['labels']}"
    differs = {
        "differ": amount,
        "worst difference": _size(check["error"]),
        "allowed there": _size(check["allowed"]),
    }
    name = ": ".join(filter(None, (check["file"], check["variable"])))
    if check["problem"]:
        return {"compared": f"{name} {check['problem']}"} | dict.fromkeys(differs, "")
    return {"compared": name} | differs


def _size(value: float | None) -> str:
    """A difference; JSON has null for an infinite one."""
    return "infinite" if value is None else significant(value)


def _row(name: str, checks: list[Check]) -> dict[str, str]:
    used = max(checks, key=used_tolerance)
    return {
        "compared": name.replace("_", " "),
        "variables": str(len(checks)),
        "values": str(sum(check["count"] for check in checks)),
        "worst difference": _size(used["error"]),
        "allowed there": _size(used["allowed"]),
    }
