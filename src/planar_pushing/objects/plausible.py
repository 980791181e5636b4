"""Warnings about objects that are probably not meant as given: a support beside its outline, for instance.

A doubtful object has an answer, so it is not refused. Each check is a comparison of numbers, except that of
the support with the outline, whose result is kept for the next contact of the object.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from math import pi, sqrt
from typing import Any

import numpy as np

from planar_pushing.mechanics.effects import Effect, Inertia, SupportFriction, Viscous
from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.outline.places import nearest_place
from planar_pushing.mechanics.pressure.assembly import measure_support
from planar_pushing.mechanics.pressure.pieces import Array, Pieces
from planar_pushing.mechanics.supports import Polygon, Ring
from planar_pushing.objects.boundary import Sides, nearest, sides_between
from planar_pushing.terms.caches import cache_results
from planar_pushing.terms.errors import SceneWarning, warn_user
from planar_pushing.terms.numbers import is_lazy

#: Largest share of the pressure that can lie outside the outline, and the distance from which it counts as
#: outside, in sizes of the outline.
OUTSIDE, BESIDE = 0.01, 0.01
#: Range of a radius of gyration in those of the support and of the outline, of which the larger one counts.
GYRATION = 0.05, 2.0
#: Largest plausible coefficient of friction: rubber on rubber has less than 2.
ROUGH = 10.0
#: Number of points at which the pressure of a support is sampled, and the fewest for one piece.
SAMPLES, FEWEST = 4096, 16
#: Steps between the points of a sequence that fills a square evenly: inverse powers of the plastic number.
STEPS = 0.7548776662466927, 0.5698402909980532
#: Angle between successive points of a disc, the golden angle.
GOLDEN = pi * (3.0 - sqrt(5.0))
#: Number of objects whose comparison is kept.
KEPT = 64


def warn_of_doubts(effects: Sequence[Effect], contact: Any, outline: Outline | None = None) -> None:
    """Warn if an object is probably not meant as given.

    Parameters
    ----------
    effects : sequence of effects
        With supports and centers in the frame of the outline.
    contact : ContactLaw, or array of laws
    outline : Outline, optional

    Warns
    -----
    SceneWarning
        If more than a hundredth of a support's pressure lies outside the outline, a radius of gyration is
        far from those of support and outline, two effects are equal, or a friction coefficient exceeds 10.
    """
    for message in _doubts(tuple(effects), contact, outline):
        warn_user(SceneWarning(message))


@cache_results(KEPT)
def _doubts(effects: tuple[Effect, ...], contact: Any, outline: Outline | None) -> tuple[str, ...]:
    """The doubts about an object, each with its remedy; they are found once for all of its contacts."""
    return tuple(_find_doubts(effects, contact, outline))


def _find_doubts(effects: Sequence[Effect], contact: Any, outline: Outline | None) -> Iterator[str]:
    """The doubts about an object, one by one."""
    kinds = SupportFriction | Viscous
    supports = [effect.support for effect in effects if isinstance(effect, kinds)]
    supports = [support for support in supports if not _is_unknown(support)]
    if outline is not None:
        yield from _outside(supports, outline)
    yield from _masses(effects, supports, outline)
    for one, other in itertools.combinations(effects, 2):
        if one == other:
            yield (
                f"effects: two equal effects of the kind {one.kind}, which act twice; "
                "list each once, or give each support its own part of the weight"
            )
    yield from _rough(contact)


def _outside(supports: Sequence[Any], outline: Outline) -> Iterator[str]:
    """Supports that are not under the object."""
    for support in dict.fromkeys(map(_Same, supports)):
        share = share_outside(support.value, outline)
        if share:
            yield (
                f"support: {100.0 * share:.0f} % of the pressure lies outside the outline; give both in "
                "one unit of length and in one frame (Polygon.rectangle is centered at the origin)"
            )


class _Same:
    """A support that is compared by identity, since a user's own support need not be hashable."""

    def __init__(self, value: Any) -> None:
        self.value = value

    def __hash__(self) -> int:
        return id(self.value)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Same) and self.value is other.value


def _masses(
    effects: Sequence[Effect], supports: Sequence[Any], outline: Outline | None
) -> Iterator[str]:
    """Masses that reach much farther than the object, or not nearly as far."""
    masses = [effect for effect in effects if isinstance(effect, Inertia)]
    if not masses:
        return
    sizes = [spread_of(support) for support in supports]
    sizes += [] if outline is None else [spread_of_outline(outline)]
    radius = max(sizes, default=0.0)
    if not radius:
        return
    for mass in masses:
        gyration = mass.gyration_radius
        if gyration is None and outline is None:
            gyration = mass.with_gyration(None).gyration_radius
        if gyration is None or is_lazy(gyration):
            continue
        ratios = np.ravel(gyration) / radius
        doubtful = ratios[(ratios < GYRATION[0]) | (ratios > GYRATION[1])]
        if doubtful.size:
            yield (
                f"gyration_radius: {doubtful[0] * radius:.6g} beside a support and an outline with a "
                f"radius of gyration of {radius:.6g}; give both in one unit of length"
            )


def _rough(contact: Any) -> Iterator[str]:
    """Coefficients of friction that no materials have."""
    for law in np.ravel(np.asarray(contact, dtype=object)):
        coefficient = getattr(law, "friction_coefficient", 0.0)
        if is_lazy(coefficient):
            continue
        largest = np.max(np.asarray(coefficient), initial=0.0)
        if ROUGH < largest < np.inf:
            yield (
                f"friction_coefficient: {largest:.6g}; give the tangent of the friction angle, or "
                "InfiniteFriction() for a contact that is rougher than any"
            )
            return


def _is_unknown(support: Any) -> bool:
    """Whether a support is a ring of the slider's radius, which nobody has to give."""
    return isinstance(support, Ring) and support.radius is None


@cache_results(KEPT)
def spread_of(support: Any) -> float:
    """Radius of gyration of a support's pressure about its center."""
    xx, _, yy = measure_support(support).spreads[0]
    return sqrt(max(xx + yy, 0.0))


@cache_results(KEPT)
def spread_of_outline(outline: Outline) -> float:
    """Radius of gyration of the area of an outline."""
    if outline.corners is None:
        return outline.gyration_radius
    return spread_of(Polygon(outline.corners))


@cache_results(KEPT)
def share_outside(support: Any, outline: Outline) -> float:
    """Share of a support's pressure outside an outline; 0 if it is small or no farther outside than drawn.

    The pressure is sampled at points that fill each piece evenly, unless the whole support is inside a
    convex outline. The share of thousands of points is within about a thousandth of the exact one.
    """
    pieces, corners = support.pieces(), outline.exterior.corners
    if corners is not None and _is_inside(pieces, sides_between(corners)):
        return 0.0
    points, shares = sample_pressure(pieces)
    # Pressure under a hole is not beside the object.
    exterior = outline.exterior
    if corners is None:
        gap = nearest_place(exterior, points).gap
    else:
        gap = nearest(sides_between(corners), points).gap
    if shares[gap > BESIDE * exterior.size].sum() <= OUTSIDE:
        return 0.0
    return float(shares[gap > 0.0].sum())


def _is_inside(pieces: Pieces, sides: Sides) -> bool:
    """Whether a support is inside a convex outline, or at most a hundredth of its size outside."""
    if not sides.convex.all():
        return False
    lines = [pieces.segments, *pieces.plates]
    ends = [rows[:, column : column + 2] for rows in lines for column in (0, 2)]
    points = np.concatenate([pieces.atoms[:, :2], pieces.rings[:, :2], pieces.discs[:, :2], *ends])
    reach = np.zeros(len(points))
    first = len(pieces.atoms)
    for rows in (pieces.rings, pieces.discs):
        reach[first : first + len(rows)], first = rows[:, 2], first + len(rows)
    # Heights above the lines of all sides; those of a convex outline are all positive inside.
    heights = ((points[:, None] - sides.start) * sides.normal).sum(axis=-1) - reach[:, None]
    return bool((heights >= -BESIDE * sides.scale).all())


def sample_pressure(pieces: Pieces) -> tuple[Array, Array]:
    """Points that fill a support evenly, shape (n, 2), and their shares of the pressure, shape (n,)."""
    parts = [(pieces.atoms[:, :2], pieces.atoms[:, 2])]
    count = sum(len(kind) for kind in pieces[1:])
    number = max(FEWEST, SAMPLES // max(count, 1))
    middle = (np.arange(number) + 0.5) / number
    for start_x, start_y, end_x, end_y, share in pieces.segments:
        line = np.column_stack([end_x - start_x, end_y - start_y])
        parts.append(((start_x, start_y) + middle[:, None] * line, np.full(number, share / number)))
    for rows, angles, distances in (
        (pieces.rings, 2.0 * pi * middle, np.ones(number)),
        (pieces.discs, GOLDEN * np.arange(number), np.sqrt(middle)),
    ):
        around = distances[:, None] * np.column_stack([np.cos(angles), np.sin(angles)])
        for x, y, radius, share in rows:
            parts.append(((x, y) + radius * around, np.full(number, share / number)))
    parts += [_sample_plate(edges, number) for edges in pieces.plates]
    points, shares = zip(*parts, strict=True)
    return np.concatenate(points), np.concatenate(shares)


def _sample_plate(edges: Array, number: int) -> tuple[Array, Array]:
    """Points of the rectangle around a plate, and the share of the pressure of each; 0 beside the plate."""
    corners = np.concatenate([edges[:, :2], edges[:, 2:4]])
    low, high = corners.min(axis=0), corners.max(axis=0)
    points = low + np.mod(0.5 + np.outer(np.arange(1, number + 1), STEPS), 1.0) * (high - low)
    # The pressure at a point is the sum of the jumps across the edges that a ray along +x meets.
    x, y, (start_x, start_y, end_x, end_y, jump) = points[:, :1], points[:, 1:], edges.T
    crosses = (start_y > y) != (end_y > y)
    rise = np.where(end_y == start_y, 1.0, end_y - start_y)
    ahead = start_x + (y - start_y) / rise * (end_x - start_x) > x
    pressure = np.where(crosses & ahead, np.where(end_y > start_y, jump, -jump), 0.0).sum(axis=1)
    turn = edges[:, 0] * edges[:, 3] - edges[:, 1] * edges[:, 2]
    share = float((turn * jump).sum()) / 2.0
    total = pressure.sum()
    return points, pressure * (share / total) if total > 0.0 else np.zeros(number)
