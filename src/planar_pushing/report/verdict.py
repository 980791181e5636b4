"""The golden verdicts of both studies in short: their counts, and one line for each dataset."""

from __future__ import annotations

from collections import defaultdict
from typing import Any

from planar_pushing.report.quantities import Quantity, significant
from planar_pushing.report.results import Results
from planar_pushing.terms.errors import InvalidFile

#: One comparison of a verdict.
Check = dict[str, Any]
SOURCE = "tables/golden_verdict.json"
#: How golden values are known, as verdicts have it.
KINDS = ("enclosed", "searched", "integrated", "plain")


def _passed(results: Results) -> list[dict[str, Any]]:
    for found in results.verdicts:
        if not found["passed"]:
            raise InvalidFile(
                f"{results.folder}/{SOURCE}: holds no verdict that passed; build it anew"
            )
    return results.verdicts


def verdict_word() -> Quantity:
    """Make the quantity that says whether the checks passed."""
    return Quantity(
        read=lambda results: "passed" if _passed(results) else "",
        digits=0,
        unit="1",
        source=f"{SOURCE}: verdict",
    )


def kind_count(kind: str, part: str = "values") -> Quantity:
    """Make the number of values, or of variables, of a kind of golden data that were compared."""
    return Quantity(
        read=lambda results: float(sum(each["kinds"][kind][part] for each in _passed(results))),
        digits=0,
        unit="1",
        source=f"{SOURCE} of both studies: {part} of the kind {kind}",
    )


def label_count() -> Quantity:
    """Make the number of entries that are no finite numbers."""
    return Quantity(
        read=lambda results: float(sum(each["labels"] for each in _passed(results))),
        digits=0,
        unit="1",
        source=f"{SOURCE} of both studies: labels",
    )


def mark_count(mark: str, join: Any) -> Quantity:
    """Make a number that golden files hold as an attribute."""

    def read(results: Results) -> float:
        return float(join(marks[mark] for marks in results.golden_marks() if mark in marks))

    return Quantity(read=read, digits=0, unit="1", source=f"golden data: {mark}")


def verdict_rows(results: Results) -> list[dict[str, str]]:
    """Variables, finite values and the worst error against the allowed one, by dataset.

    Scenes, logs and figures are counted together.
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
