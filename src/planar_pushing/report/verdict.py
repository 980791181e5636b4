"""The golden verdict in short: its counts, and one line for each dataset and figure."""

from __future__ import annotations

import re
from collections import defaultdict

from planar_pushing.mechanics.errors import InvalidFile
from planar_pushing.report.quantities import Quantity
from planar_pushing.report.results import Results

HEAD = re.compile(r"(?P<word>\w+): (?P<values>\d+) values of (?P<variables>\d+) variables agree")
LINE = re.compile(
    r"ok +(?P<name>[\w.]+): \w+: (?P<count>\d+) agree; "
    r"worst (?P<error>\S+) \((?P<ulp>\S+) ulp\), allowed (?P<allowed>\S+)"
)
SOURCE = "tables/golden_verdict.txt"


def _head(results: Results, part: str) -> str:
    found = HEAD.match(results.verdict)
    if not found:
        raise InvalidFile(f"{results.folder}/{SOURCE}: holds no verdict that passed; build it anew")
    return found[part]


def verdict_word() -> Quantity:
    """Make the number that is no number: whether the check passed."""
    return Quantity(
        read=lambda results: _head(results, "word"), digits=0, unit="1", source=f"{SOURCE}: verdict"
    )


def verdict_count(part: str) -> Quantity:
    """Make the number of values or of variables that were compared."""
    return Quantity(
        read=lambda results: float(_head(results, part)),
        digits=0,
        unit="1",
        source=f"{SOURCE}: {part} that agree",
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
    groups: dict[str, list[re.Match[str]]] = defaultdict(list)
    for line in LINE.finditer(results.verdict):
        groups[_group(line["name"])].append(line)
    return [_row(name, groups[name]) for name in sorted(groups)]


def _group(name: str) -> str:
    return "figures" if name.startswith("figure_") else name.partition(".")[0]


def _row(name: str, lines: list[re.Match[str]]) -> dict[str, str]:
    used = max(lines, key=_used)
    return {
        "compared": name.replace("_", " "),
        "variables": str(len(lines)),
        "values": str(sum(int(line["count"]) for line in lines)),
        "worst difference": used["error"],
        "allowed there": used["allowed"],
    }


def _used(line: re.Match[str]) -> float:
    allowed = float(line["allowed"])
    return float(line["error"]) / allowed if allowed else 0.0
