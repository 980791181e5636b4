"""The numbers of the part on evidence: the golden check and the claims, some of their values included."""

from __future__ import annotations

from planar_pushing.evidence.claims.proofs.verdicts import Verdict
from planar_pushing.report.quantities import Numbers, Quantity, claimed, counted
from planar_pushing.report.verdict import (
    KINDS,
    kind_count,
    label_count,
    mark_count,
    verdict_word,
)

#: Verdicts that the ledger can expect.
VERDICTS = [verdict for verdict in Verdict if verdict is not Verdict.UNDECIDED]


def _verdicts(verdict: Verdict) -> Quantity:
    return counted(verdict, lambda claim: bool(claim["verdict"] == verdict))


GOLDEN: Numbers = {
    "golden-verdict": verdict_word(),
    **{f"golden-{kind}": kind_count(kind) for kind in KINDS},
    "golden-variables": kind_count("enclosed", "variables"),
    "golden-labels": label_count(),
    "golden-by-integrals": mark_count("golden_checked_by_integrals", sum),
    "golden-precision": mark_count("golden_precision_bits", min),
}

CLAIMS: Numbers = {
    "claims": counted("claims", bool),
    "claims-ours": counted("claims of ours", lambda claim: bool(claim["origin"] == "ours")),
    **{f"claims-{verdict.replace(' ', '-')}": _verdicts(verdict) for verdict in VERDICTS},
    "threshold-inertia": claimed("inertia-threshold", "value", digits=1),
    "threshold-inertia-short-rod": claimed("inertia-threshold-figure-10", "value", digits=1),
    "threshold-friction": claimed("friction-threshold", "value", digits=4),
    "dip": claimed("normal-motion-dips", "value", digits=4, unit="W/m"),
    "dip-force": claimed("force-at-the-dip", "value", digits=3, unit="W"),
    "return-force": claimed("force-at-the-return", "value", digits=3, unit="W"),
}
