"""The numbers of the part on any slider, from the ledger."""

from __future__ import annotations

from planar_pushing.report.quantities import Numbers, Quantity, claimed


def _constant(support: str, digits: int = 4) -> Quantity:
    """Make the integration constant of a support, in units of its weight and reach."""
    return claimed(f"integration-constant-of-{support}", "value", digits=digits)


def _points(claim: str) -> Quantity:
    """Make the number of supports and contacts on which a claim was checked."""
    return claimed(claim, "points", digits=0)


def _degrees(claim: str, digits: int = 1) -> Quantity:
    return claimed(claim, "value", digits=digits, unit="degree")


CLAIMS: Numbers = {
    "random-normal-pushes": _points("normal-push-on-random-supports"),
    "random-cones": _points("cones-of-random-supports"),
    "random-centers": _points("centers-of-random-supports"),
    "l-cone-right": _degrees("l-pulls-along-normal"),
    "l-leaning-right": _degrees("l-leans-against-its-rod"),
    "l-difference": claimed("curve-of-l-leans", "value", digits=3, unit="W"),
    "l-least-force": _degrees("least-force-of-l"),
    "pivot-span": _degrees("one-pivot-for-many-forces"),
    "pivot-offset": claimed("tripod-pivots", "value", digits=3),
    "corner-span": _degrees("corner-of-a-line"),
    "foot-margin": claimed("foot-ahead-holds", "value", digits=3, unit="W"),
    "center-product": claimed("center-beyond-bound", "value", digits=6),
    "constant-ring": _constant("ring", 0),
    **{f"constant-{name}": _constant(name) for name in ("square", "rectangle", "strip", "disc")},
}
