"""The verdict of the check: as data, and as text that is rendered from them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import asdict
from typing import Any

from planar_pushing.evidence.golden.compare import Check
from planar_pushing.evidence.golden.rules import Rule

#: Whether all passed, counts of values, variables and failures, and every check, worst first.
Verdict = dict[str, Any]

#: What the check of values by a rule says.
RULES = {
    Rule.ENCLOSURE: "enclosed by the golden data",
    Rule.RESIDUAL: "verified by residual in their equations",
    Rule.EXACT: "compared exactly",
    Rule.DERIVED: "computed anew",
}
#: What the residuals do not decide.
NOTE = (
    "With friction and inertia together slip is not monotone: that a slip is absent, and how many there "
    "are, is certified by interval subdivision on the golden sample alone; every slip that is stored is "
    "verified by residual."
)


def verdict(checks: Iterable[Check]) -> Verdict:
    """Judge all checks; numbers that are infinite are null, as JSON has none.

    `values`, `variables` and `checks` are those of the golden data, `verified` holds the other checks and
    `rules` the counts by rule.
    """
    ranked = sorted(checks, key=lambda check: (check.passed, -check.badness, check.name))
    enclosed = [check for check in ranked if check.rule == Rule.ENCLOSURE]
    failed = sum(not check.passed for check in ranked)
    return {
        "passed": not failed,
        "failed": failed,
        "rules": {str(rule): _counts(ranked, rule) for rule in Rule},
        **_counts(ranked, Rule.ENCLOSURE),
        "note": NOTE,
        "checks": [_entry(check) for check in enclosed],
        "verified": [_entry(check) for check in ranked if check.rule != Rule.ENCLOSURE],
    }


def _counts(checks: list[Check], rule: Rule) -> dict[str, int]:
    found = [check for check in checks if check.rule == rule]
    return {"values": sum(check.count for check in found), "variables": len(found)}


def _entry(check: Check) -> dict[str, Any]:
    given = {"passed": check.passed} | asdict(check) | {"rule": str(check.rule)}
    infinite = {
        name for name, each in given.items() if isinstance(each, float) and math.isinf(each)
    }
    return given | dict.fromkeys(infinite)


def verdict_text(found: Verdict) -> str:
    """Readable verdict, worst first."""
    every = [*found["checks"], *found["verified"]]
    counts = {rule: found["rules"][str(rule)] for rule in Rule}
    failed = f"FAILED: {found['failed']} of {len(every)} checks"
    lines = [
        "passed: every value agrees" if found["passed"] else failed,
        *(
            f"  {count['values']} values of {count['variables']} variables {RULES[rule]}"
            for rule, count in counts.items()
        ),
    ]
    ordered = sorted(every, key=lambda check: check["passed"])
    return "\n".join([*lines, "", NOTE, "", *map(_line, ordered)]) + "\n"


def _line(check: Mapping[str, Any]) -> str:
    name = ": ".join(filter(None, (check["file"], check["variable"])))
    if check["problem"]:
        return f"FAIL {name} {check['problem']}"
    mark = "ok  " if check["passed"] else "FAIL"
    count, failed = check["count"], check["failed"]
    amount = f"{failed} of {count} differ" if failed else f"{count} agree"
    return f"{mark} {name} ({check['rule']}): {amount}{_worst(check)}"


def _worst(check: Mapping[str, Any]) -> str:
    """The worst difference, in units in the last place where that is a number, and where it is."""
    error, allowed = (
        math.inf if check[key] is None else check[key] for key in ("error", "allowed")
    )
    if not error and not allowed:
        return ""
    ulp = f" ({check['ulp']:.3g} ulp)" if check["ulp"] else ""
    place = f" at {check['where']}" if check["where"] and error else ""
    return f"; worst {error:.2g}{ulp}, allowed {allowed:.2g}{place}"
