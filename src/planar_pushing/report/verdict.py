"""The golden verdict in short: its counts, and one line for each dataset and figure."""

from __future__ import annotations

from collections import defaultdict
from typing import Any

from planar_pushing.report.quantities import Quantity, significant
from planar_pushing.report.results import Results
from planar_pushing.terms.errors import InvalidFile

#: One comparison of the verdict.
Check = dict[str, Any]
SOURCE = "tables/golden_verdict.json"


def _passed(results: Results) -> dict[str, Any]:
    found = results.verdict
    if not found["passed"]:
        raise InvalidFile(f"{results.folder}/{SOURCE}: holds no verdict that passed; build it anew")
    return found


def verdict_word() -> Quantity:
    """Make the quantity that says whether the check passed."""
    return Quantity(
        read=lambda results: "passed" if _passed(results) else "",
        digits=0,
        unit="1",
        source=f"{SOURCE}: verdict",
    )


def verdict_count(part: str) -> Quantity:
    """Make the number of values or of variables that were compared."""
    return Quantity(
        read=lambda results: float(_passed(results)[part]),
        digits=0,
        unit="1",
        source=f"{SOURCE}: {part} that agree",
    )


def rule_count(rule: str) -> Quantity:
    """Make the number of values that a rule of the check has verified."""
    return Quantity(
        read=lambda results: float(_passed(results)["rules"][rule]["values"]),
        digits=0,
        unit="1",
        source=f"{SOURCE}: values verified by the rule {rule}",
    )


def _by_integrals(results: Results) -> float:
    return float(sum(marks["checked_by_integrals"] for marks in results.golden_marks()))


def _precision(results: Results) -> float:
    return float(min(marks["precision_bits"] for marks in results.golden_marks()))


def golden_numbers() -> dict[str, Quantity]:
    """Make the numbers that the golden files themselves hold."""
    reads = {"by-integrals": _by_integrals, "precision": _precision}
    return {
        f"golden-{name}": Quantity(read=read, digits=0, unit="1", source=f"golden data: {name}")
        for name, read in reads.items()
    }


def verdict_rows(results: Results) -> list[dict[str, str]]:
    """Variables, values and the worst error against what is allowed, by golden file.

    Scenes are counted as one, and so are figures.
    """
    groups: dict[str, list[Check]] = defaultdict(list)
    for check in _passed(results)["checks"]:
        groups[_group(check["file"])].append(check)
    return [_row(name, groups[name]) for name in sorted(groups)]


def _group(file: str) -> str:
    return "figures" if file.startswith("figure_") else file.partition(".")[0]


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
