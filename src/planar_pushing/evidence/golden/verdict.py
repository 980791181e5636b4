"""The verdict of the golden check: as data, and as text that is rendered from them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import asdict
from typing import Any

from planar_pushing.evidence.golden.compare import Check

#: Whether all passed, counts of values, variables and failures, and every check, worst first.
Verdict = dict[str, Any]


def verdict(checks: Iterable[Check]) -> Verdict:
    """Judge all comparisons; numbers that are infinite are null, as JSON has none."""
    ranked = sorted(checks, key=lambda check: (check.passed, -check.badness, check.name))
    failed = sum(not check.passed for check in ranked)
    return {
        "passed": not failed,
        "values": sum(check.count for check in ranked),
        "variables": len(ranked),
        "failed": failed,
        "checks": [_entry(check) for check in ranked],
    }


def _entry(check: Check) -> dict[str, Any]:
    given = {"passed": check.passed} | asdict(check)
    infinite = {
        name for name, each in given.items() if isinstance(each, float) and math.isinf(each)
    }
    return given | dict.fromkeys(infinite)


def verdict_text(found: Verdict) -> str:
    """Readable verdict, worst first."""
    head = (
        f"passed: {found['values']} values of {found['variables']} variables agree with the golden data"
        if found["passed"]
        else f"FAILED: {found['failed']} of {found['variables']} variables differ from the golden data"
    )
    return "\n".join([head, "", *map(_line, found["checks"])]) + "\n"


def _line(check: Mapping[str, Any]) -> str:
    name = ": ".join(filter(None, (check["file"], check["variable"])))
    if check["problem"]:
        return f"FAIL {name} {check['problem']}"
    mark = "ok  " if check["passed"] else "FAIL"
    count, failed = check["count"], check["failed"]
    amount = f"{failed} of {count} differ" if failed else f"{count} agree"
    error, ulp, allowed = (
        math.inf if check[each] is None else check[each] for each in ("error", "ulp", "allowed")
    )
    units = f" ({ulp:.3g} ulp)" if math.isfinite(ulp) else ""  # zero has no last place
    worst = f"; worst {error:.2g}{units}, allowed {allowed:.2g}"
    place = f" at {check['where']}" if check["where"] and error else ""
    return f"{mark} {name}: {amount}{worst}{place}"
