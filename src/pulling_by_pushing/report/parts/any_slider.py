"""The numbers of the part on any slider, from the ledger of claims."""

from __future__ import annotations

from pulling_by_pushing.report.quantities import Numbers, Quantity, claimed


def _constant(support: str, digits: int = 4) -> Quantity:
    """Integration constant of a support, in units of its weight and extent."""
    return claimed("integration-constants", support, digits=digits)


def _of_l(check: str) -> Quantity:
    """Angle for the L-shaped support."""
    return claimed("shape-of-an-l", check, digits=1, unit="degree")


CLAIMS: Numbers = {
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
