"""The numbers of the part on evidence: the golden check, the claims, and some of their values."""

from __future__ import annotations

from collections.abc import Collection

from pulling_by_pushing.evidence.proofs.verdicts import Verdict
from pulling_by_pushing.report.quantities import Numbers, Quantity, claimed, counted
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
    return counted(verdict, lambda claim: int(claim["verdict"] == verdict))


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
    return counted(
        f"statements of the paper, {what}",
        lambda claim: int(claim["origin"] == "paper" and claim["verdict"] in verdicts),
    )


CLAIMS: Numbers = {
    "claims": counted("claims", lambda claim: 1),
    "claims-paper": _of_the_paper("all", VERDICTS),
    **{
        f"claims-paper-{verdict}": _of_the_paper(verdict, (verdict,))
        for verdict in (Verdict.PROVED, Verdict.ENCLOSED, Verdict.OPEN)
    },
    "claims-ours": counted("claims of ours", lambda claim: int(claim["origin"] == "ours")),
    "claims-checks": counted("checks", lambda claim: len(claim["checks"])),
    **{f"claims-{verdict}": _verdicts(verdict) for verdict in VERDICTS},
    "threshold-inertia": claimed("pulling-condition", "threshold", digits=1),
    "threshold-inertia-short-rod": claimed("pulling-condition", "threshold-short-rod", digits=1),
    "threshold-friction": claimed("speed-decides-pulling", "threshold", digits=4),
    "pulling-offset": claimed("pulling-offset", "long-rod", digits=3, unit="R"),
    "pulling-offset-short-rod": claimed("pulling-offset", "short-rod", digits=3, unit="R"),
    "dip": claimed("normal-motion-dips", "least", digits=4, unit="W/m"),
    "dip-force": claimed("normal-motion-dips", "force", digits=3, unit="W"),
    "return-force": claimed("normal-motion-dips", "return-force", digits=3, unit="W"),
    "beyond-both": claimed("cones-beyond-the-pure-ones", "both", digits=2, unit="degree"),
}


def _constant(support: str, digits: int = 4) -> Quantity:
    """Integration constant of a support, in units of its weight and extent."""
    return claimed("integration-constants", support, digits=digits)


def _of_l(check: str) -> Quantity:
    """Angle for the L-shaped support."""
    return claimed("shape-of-an-l", check, digits=1, unit="degree")


ANY_SLIDER: Numbers = {
    "l-cone-right": _of_l("along-normal"),
    "l-leaning-right": _of_l("leaning"),
    "l-difference": claimed("shape-of-an-l", "difference", digits=3, unit="W"),
    "l-least-force": _of_l("least-force"),
    "pivot-span": claimed("pivots-of-a-tripod", "span", digits=1, unit="degree"),
    "pivot-offset": claimed("pivots-of-a-tripod", "farthest", digits=3),
    "corner-span": claimed("corner-of-a-line", "span", digits=1, unit="degree"),
    "foot-margin": claimed("foot-ahead-holds", "margin", digits=3, unit="W"),
    "center-product": claimed("center-beyond-bound", "product", digits=6),
    "constant-ring": _constant("ring", 0),
    **{f"constant-{name}": _constant(name) for name in ("square", "rectangle", "strip", "disc")},
}
