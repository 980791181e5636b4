"""The verdict of the check: as data, and as text rendered from the data."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.evidence.golden.check import check_results
from pulling_by_pushing.evidence.golden.compare import OTHER_STUDY, Check, Kind
from pulling_by_pushing.evidence.writing import json_text, write_text

#: Whether all passed, counts of values by kind, and every check, worst first.
Verdict = dict[str, Any]
#: Results that are not compared, and why.
UNCOMPARED_RESULTS = {"accuracy_time": "times"}


def write_verdict(data: PathLike, text: PathLike, *, study: str, results: str) -> None:
    """Compare the results of a study with its golden data, and write the verdict, passed or failed."""
    content = verdict(check_results(Path(results), study))
    write_text(verdict_text(content), text)
    write_text(json_text(content), data)


def verdict(checks: Iterable[Check], note: str = "") -> Verdict:
    """Judge all checks; infinite numbers become null, since JSON has none.

    `values` of a kind are finite numbers that were compared; `labels` are all other entries: infinite
    numbers, NaN, texts and flags.
    """
    ranked = sorted(checks, key=lambda check: (check.passes, -check.badness, check.name))
    failed = sum(not check.passes for check in ranked)
    return {
        "passed": not failed,
        "failed": failed,
        "kinds": {kind.name.lower(): _counts(ranked, kind) for kind in Kind},
        "labels": sum(check.labels for check in ranked),
        "used": _used_parts(map(_entry, ranked)),
        "note": note,
        "aside": UNCOMPARED_RESULTS,
        "checks": [_entry(check) for check in ranked],
    }


def _counts(checks: list[Check], kind: Kind) -> dict[str, int]:
    compared = [check for check in checks if check.kind is kind and check.count]
    return {"values": sum(check.count for check in compared), "variables": len(compared)}


def _entry(check: Check) -> dict[str, Any]:
    fields = {"passed": check.passes} | asdict(check) | {"kind": check.kind.name.lower()}
    infinite = {
        name for name, value in fields.items() if isinstance(value, float) and math.isinf(value)
    }
    return fields | dict.fromkeys(infinite)


def verdict_text(verdict: Verdict) -> str:
    """Readable verdict, worst first."""
    failed = f"FAILED: {verdict['failed']} of {len(verdict['checks'])} checks"
    counts = (
        f"  {count['values']} numbers of {count['variables']} variables {kind}"
        for kind in Kind
        if (count := verdict["kinds"][kind.name.lower()])["values"]
    )
    lines = [
        *_other_study(verdict["checks"]),
        "passed: every value agrees" if verdict["passed"] else failed,
        *counts,
        f"  {verdict['labels']} other entries are equal: infinite numbers, NaN, texts and flags",
        *([verdict["note"]] if verdict["note"] else []),
    ]
    used = [
        f"  {ratio:.2g} of the allowed difference is used in {name}"
        for name, ratio in verdict["used"].items()
    ]
    return "\n".join([*lines, *used, "", *map(_line, verdict["checks"])]) + "\n"


def _other_study(checks: list[Mapping[str, Any]]) -> list[str]:
    """Line that says that the study has changed, if it has."""
    files = [check["file"] for check in checks if check["problem"].startswith(OTHER_STUDY)]
    if not files:
        return []
    more = f" and {len(files) - 1} more" if len(files) > 1 else ""
    return [
        f"FAILED: the study differs from the one of the golden data ({files[0]}{more}); `make golden` "
        "shows the differences, `planar-pushing check --points N` certifies points of any study"
    ]


def _used_parts(checks: Iterable[Mapping[str, Any]]) -> dict[str, float]:
    """The largest part of an allowed difference that each dataset uses, without checks that failed."""
    used: dict[str, float] = {}
    for check in checks:
        ratio = used_tolerance(check)
        if math.isfinite(ratio):
            used[check["file"]] = max(used.get(check["file"], 0.0), ratio)
    return dict(sorted(used.items(), key=lambda item: (-item[1], item[0])))


def _line(check: Mapping[str, Any]) -> str:
    name = ": ".join(filter(None, (check["file"], check["variable"])))
    if check["problem"]:
        return f"FAIL {name} {check['problem']}"
    mark = "ok  " if check["passed"] else "FAIL"
    total, failed = check["count"] + check["labels"], check["failed"]
    amount = f"{failed} of {total} differ" if failed else f"{total} agree"
    return f"{mark} {name} ({Kind[check['kind'].upper()]}): {amount}{_worst(check)}"


def _worst(check: Mapping[str, Any]) -> str:
    """The worst difference, its value in units in the last place if that is a number, and its place."""
    error, allowed = (
        math.inf if check[key] is None else check[key] for key in ("error", "allowed")
    )
    if not error and not check["failed"]:
        return ""
    ulp = f" ({check['ulp']:.3g} ulp)" if check["ulp"] else ""
    location = f" at {check['where']}" if check["where"] else ""
    return f"; worst {error:.2g}{ulp}, allowed {allowed:.2g}{location}"


def used_tolerance(check: Mapping[str, Any]) -> float:
    """Worst difference of a check as a part of its tolerance; infinite if it could not be made."""
    if check["problem"] or check["error"] is None:
        return math.inf
    if not check["allowed"]:
        return math.inf if check["error"] else 0.0
    return float(check["error"] / check["allowed"])
