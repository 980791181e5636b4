"""The numbers of the part on evidence: the golden check, the claims, and some of their values."""

from __future__ import annotations

from collections.abc import Collection

from pulling_by_pushing.evidence.proofs.verdicts import Verdict
from pulling_by_pushing.report.quantities import Numbers, Quantity, check_number, count_claims
from pulling_by_pushing.report.verdict import (
    KINDS,
    independent_share,
    kind_count,
    label_count,
    mark_count,
    verdict_word,
)

#: Verdicts that the ledger can specify.
VERDICTS = [verdict for verdict in Verdict if verdict is not Verdict.UNDECIDED]


def _verdicts(verdict: Verdict) -> Quantity:
    return count_claims(verdict, lambda claim: int(claim["verdict"] == verdict))


GOLDEN: Numbers = {
    "golden-verdict": verdict_word(),
    **{f"golden-{kind}": kind_count(kind) for kind in KINDS},
    "golden-variables": kind_count("enclosed", "variables"),
    "golden-share": independent_share(),
    "golden-labels": label_count(),
    "golden-by-integrals": mark_count("golden_checked_by_integrals", sum),
    "golden-precision": mark_count("golden_precision_bits", min),
    "golden-roundings": mark_count("golden_roundings", min),
}


def _of_the_paper(what: str, verdicts: Collection[Verdict]) -> Quantity:
    """Number of statements of the paper with one of these verdicts."""
    return count_claims(
        f"statements of the paper, {what}",
        lambda claim: int(claim["origin"] == "paper" and claim["verdict"] in verdicts),
    )


CLAIMS: Numbers = {
    "claims": count_claims("claims", lambda claim: 1),
    "claims-paper": _of_the_paper("all", VERDICTS),
    **{
        f"claims-paper-{verdict}": _of_the_paper(verdict, (verdict,))
        for verdict in (Verdict.PROVED, Verdict.ENCLOSED, Verdict.OPEN)
    },
    "claims-ours": count_claims("claims of ours", lambda claim: int(claim["origin"] == "ours")),
    "claims-checks": count_claims("checks", lambda claim: len(claim["checks"])),
    **{f"claims-{verdict}": _verdicts(verdict) for verdict in VERDICTS},
    "threshold-inertia": check_number("pulling-condition", "threshold", digits=1),
    "threshold-inertia-short-rod": check_number(
        "pulling-condition", "threshold-short-rod", digits=1
    ),
    "threshold-friction": check_number("speed-decides-pulling", "threshold", digits=4),
    "pulling-offset": check_number("pulling-offset", "long-rod", digits=3, unit="R"),
    "pulling-offset-short-rod": check_number("pulling-offset", "short-rod", digits=3, unit="R"),
    "dip": check_number("normal-motion-dips", "least", digits=4, unit="W/m"),
    "dip-force": check_number("normal-motion-dips", "force", digits=3, unit="W"),
    "return-force": check_number("normal-motion-dips", "return-force", digits=3, unit="W"),
    "beyond-both": check_number("cones-beyond-the-pure-ones", "both", digits=2, unit="degree"),
}


def _constant(support: str, digits: int = 4) -> Quantity:
    """Integration constant of a support, in units of its weight and extent."""
    return check_number("integration-constants", support, digits=digits)


def _of_l(check: str) -> Quantity:
    """Angle for the L-shaped support."""
    return check_number("shape-of-an-l", check, digits=1, unit="degree")


ANY_SLIDER: Numbers = {
    "l-cone-right": _of_l("along-normal"),
    "l-difference": check_number("shape-of-an-l", "difference", digits=3, unit="W"),
    "pivot-span": check_number("pivots-of-a-tripod", "span", digits=1, unit="degree"),
    "corner-span": check_number("corner-of-a-line", "span", digits=1, unit="degree"),
    "constant-ring": _constant("ring", 0),
    **{f"constant-{name}": _constant(name) for name in ("square", "rectangle", "strip", "disc")},
}
