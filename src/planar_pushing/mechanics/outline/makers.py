"""Rows of outlines with arcs: of polylines with bulges, of rounded polygons, and of ellipses as biarcs."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from planar_pushing.mechanics.outline.chains import (
    BETA0,
    BETA1,
    LENGTH,
    OWN,
    RHO,
    circle,
    has_needless,
    join_pieces,
    number_chains,
    points_at,
    polygon_chain,
    sample_chain,
    wrap,
)
from planar_pushing.mechanics.outline.drawing import DRAWN, Drawing, divide_chains, read_drawing
from planar_pushing.mechanics.outline.plate import bounds, plate_of
from planar_pushing.mechanics.supports.polygon import require_simple
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import Array, as_array

#: Deviation of the polygon that stands for arcs where crossings are looked for, in sizes of the outline.
CROSSING = 1e-5
#: Number of arcs of an ellipse, and the largest ratio of its half axes.
ARCS, SLENDER = (8, 1024), 100.0
#: Largest rounding error where two of its arcs join, in half axes.
ROUNDING = 1e-9
#: Length of a piece, or how far a corner bends its neighbors, up to which it is none, in sizes of the
#: chain. Those of an outline that was made are longer than the tolerance, in any frame, by which sizes
#: differ; the corners of a fine polygon can bend less. Arcs of one circle differ by rounding.
FAINT, FAINT_CORNER, SAME_CIRCLE = DRAWN / 2.0, DRAWN / 10.0, 1e-10
BULGES = (
    "at least two vertices (x, y, bulge) of finite numbers",
    "give the bulge 0 for a straight line to the next vertex, and tan(angle / 4) for an arc",
)


def bulge_pieces(vertices: Any, name: str = "vertices") -> Array:
    """Rows of `Outline.from_bulges`, with its errors, which have this name."""
    rows = as_array(vertices)
    if rows is None or rows.ndim != 2 or rows.shape[1] != 3 or len(rows) < 2:
        raise InvalidValue(name, vertices, *BULGES)
    if not np.isfinite(rows).all():
        raise InvalidValue(name, vertices, *BULGES)
    if (rows[0, :2] == rows[-1, :2]).all():
        rows = rows[:-1]
    if not len(rows) > 1:
        raise InvalidValue(name, vertices, *BULGES)
    drawn = _strokes(rows)
    low, high = bounds(number_chains([drawn]))
    tolerance = DRAWN * float((high - low).max())
    rows = _without_needless(rows, drawn, tolerance)
    if not rows[:, 2].any():
        corners = read_drawing(rows[:, :2], name).corners
        return number_chains([polygon_chain(np.array(corners))])
    pieces = number_chains([join_pieces(_strokes(rows), tolerance)])
    if plate_of(pieces).area < 0.0:
        behind = np.roll(rows, -1, axis=0)[::-1]
        rows = np.column_stack([behind[:, :2], -rows[::-1, 2]])
        pieces = number_chains([join_pieces(_strokes(rows), tolerance)])
    _require_no_crossing(pieces, name)
    return pieces


def has_faint_pieces(chain: Array) -> bool:
    """Whether some rows of a chain are no pieces, or are parts of one."""
    low, high = bounds(chain)
    size, rho = float((high - low).max()), chain[:, RHO]
    is_polygon = bool((np.isinf(rho) | (rho == 0.0)).all())
    faint = FAINT_CORNER if is_polygon else FAINT
    return has_needless(chain, faint * size, SAME_CIRCLE * size)


def bulges_of_chain(chain: Array) -> Array:
    """Vertices with bulges, shape (n, 3), of the sides and arcs of a chain; at most half a circle each."""
    rows = []
    for piece in chain[chain[:, RHO] != 0.0]:
        angle = float(piece[BETA1] - piece[BETA0])
        parts = 2 if abs(angle) > math.pi else 1
        beta = piece[BETA0] + angle / parts * np.arange(parts)
        starts = piece[None, :2] if math.isinf(piece[RHO]) else points_at(piece, beta)
        rows += [(x, y, math.tan(angle / parts / 4.0)) for x, y in starts.tolist()]
    return np.array(rows)


def _strokes(rows: Array) -> Array:
    """Own columns of the side or the arc from each vertex to the next, which are not joined yet."""
    x, y, bulge = rows.T
    along = np.roll(rows[:, :2], -1, axis=0) - rows[:, :2]
    chord, beta = np.hypot(along[:, 0], along[:, 1]), np.arctan2(along[:, 1], along[:, 0])
    strokes = np.zeros((len(rows), OWN))
    strokes[:, 0], strokes[:, 1], strokes[:, 2] = x, y, math.inf
    strokes[:, 3] = strokes[:, 4] = beta
    strokes[:, LENGTH] = chord
    arcs = np.flatnonzero((bulge != 0.0) & (chord > 0.0))
    b, c, angle = bulge[arcs], chord[arcs], 4.0 * np.arctan(bulge[arcs])
    normal = np.stack([-along[arcs, 1], along[arcs, 0]], axis=-1) / c[:, None]
    middle = rows[arcs, :2] + along[arcs] / 2.0
    strokes[arcs, :2] = middle + (c * (1.0 - b * b) / (4.0 * b))[:, None] * normal
    strokes[arcs, 2] = c * (1.0 + b * b) / (4.0 * b)
    strokes[arcs, 3], strokes[arcs, 4] = beta[arcs] - angle / 2.0, beta[arcs] + angle / 2.0
    strokes[arcs, LENGTH] = strokes[arcs, 2] * angle
    return strokes


def _without_needless(rows: Array, strokes: Array, tolerance: float) -> Array:
    """Vertices with bulges: flat and short arcs are straight, and straight lines have no inner vertices."""
    rows = rows.copy()
    chord = np.hypot(*(np.roll(rows[:, :2], -1, axis=0) - rows[:, :2]).T)
    is_flat = (np.abs(rows[:, 2]) * chord / 2.0 <= tolerance) & (np.abs(rows[:, 2]) <= 1.0)
    rows[is_flat | (strokes[:, LENGTH] <= tolerance), 2] = 0.0
    arcs = np.flatnonzero(rows[:, 2])
    if not len(arcs):
        return rows
    # From the end of an arc to the start of the next one the lines are straight.
    rows = np.roll(rows, -int(arcs[0]), axis=0)
    arcs = np.append(np.flatnonzero(rows[:, 2]), len(rows))
    ring = np.concatenate([rows, rows[:1]])
    corners: list[int] = []
    for arc, behind in zip(arcs[:-1].tolist(), arcs[1:].tolist(), strict=True):
        corners.append(arc)
        start, end = arc + 1, behind
        inner = divide_chains(ring[:, :2], [(start, end)], tolerance)
        if inner or np.hypot(*(ring[end, :2] - ring[start, :2])) > tolerance:
            corners += [start, *sorted(inner)]
    return np.asarray(ring[[k for k in corners if k < len(rows)]])


def _require_no_crossing(pieces: Array, name: str) -> None:
    """Refuse an outline that crosses or touches itself."""
    if len(pieces) == 1:
        return
    low, high = bounds(pieces)
    vertices = sample_chain(pieces, CROSSING * float((high - low).max()))
    try:
        require_simple(name, vertices)
    except InvalidValue as error:
        raise InvalidValue(
            name, error.given, "an outline that does not cross or touch itself",
            "order the vertices along the boundary, each once, and check the signs of the arcs",
        ) from None  # fmt: skip


def rounded_chain(drawing: Drawing, radius: Any, tolerance: float) -> Array:
    """Own columns of the exterior of `rounded`, with its errors."""
    corners = np.array(drawing.corners)
    along = np.roll(corners, -1, axis=0) - corners
    length, beta = np.hypot(along[:, 0], along[:, 1]), np.arctan2(along[:, 1], along[:, 0])
    turn = wrap(beta - np.roll(beta, 1))
    radii = _required_radii(radius, len(drawing.vertices))
    radii = radii[drawing.vertex] if radii.ndim else np.where(turn > 0.0, radii, 0.0)
    # An arc within the tolerance is a corner, up to which its sides go.
    radii = np.where(radii * np.abs(turn) > tolerance, radii, 0.0)
    cut = radii * np.abs(np.tan(turn / 2.0))
    rest = length - cut - np.roll(cut, -1)
    if rest.min() < -tolerance:
        i = int(rest.argmin())
        raise InvalidValue(
            "radius", radius, f"radii whose arcs take at most {length[i]:.6g} of the side from "
            f"({corners[i, 0]:.6g}, {corners[i, 1]:.6g})", "choose smaller radii",
        )  # fmt: skip
    tangent = along / length[:, None]
    smooth = np.zeros((2 * len(corners), OWN))
    smooth[0::2, :2] = corners + cut[:, None] * tangent
    smooth[0::2, 2], smooth[0::2, LENGTH] = math.inf, rest
    smooth[0::2, 3] = smooth[0::2, 4] = beta
    # The arc at the end of side k; an inner corner gets a hollow one.
    bend, rho = np.roll(turn, -1), np.roll(np.copysign(radii, turn), -1)
    normal = np.stack([-tangent[:, 1], tangent[:, 0]], axis=-1)
    ends = np.roll(corners, -1, axis=0) - np.roll(cut, -1)[:, None] * tangent
    smooth[1::2, :2], smooth[1::2, 2] = ends + rho[:, None] * normal, rho
    smooth[1::2, 3], smooth[1::2, 4], smooth[1::2, LENGTH] = beta, beta + bend, np.abs(rho * bend)
    chain = join_pieces(smooth, tolerance)
    _require_no_crossing(number_chains([chain]), "radius")
    return chain


def _required_radii(value: Any, count: int) -> Array:
    """One radius, or one for each of a number of vertices."""
    radii = as_array(value)
    if (
        radii is None
        or radii.shape not in ((), (count,))
        or not ((radii >= 0.0) & (radii < math.inf)).all()
    ):
        raise InvalidValue(
            "radius", value, f"a number >= 0, or {count} of them, one for each vertex",
            "give it in the unit of the corners",
        )  # fmt: skip
    return radii


def ellipse_pieces(a: Any, b: Any, arcs: Any) -> Array:
    """Rows of `Outline.ellipse`, with its errors."""
    for name, value in (("a", a), ("b", b)):
        is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
        if not is_number or not 0.0 < value < math.inf:
            raise InvalidValue(name, value, "a finite number > 0", "give half an axis")
    if not 1.0 / SLENDER <= a / b <= SLENDER:
        raise InvalidValue(
            "b", b, f"from {a / SLENDER:.6g} to {a * SLENDER:.6g} beside a={a}",
            "give a side by its corners instead",
        )  # fmt: skip
    is_count = isinstance(arcs, (int, np.integer)) and not isinstance(arcs, bool)
    if not is_count or not ARCS[0] <= arcs <= ARCS[1] or arcs % 2:
        raise InvalidValue(
            "arcs", arcs, f"an even whole number from {ARCS[0]} to {ARCS[1]}",
            "give more arcs for an outline that is closer to the ellipse",
        )  # fmt: skip
    if a == b:
        return number_chains([circle(0.0, 0.0, float(a))])
    u = 2.0 * math.pi * np.arange(arcs // 2) / (arcs // 2)
    points = np.stack([a * np.cos(u), b * np.sin(u)], axis=-1)
    smooth = _biarcs(points, np.arctan2(b * np.cos(u), -a * np.sin(u)))
    return number_chains([join_pieces(smooth, ROUNDING * float(max(a, b)))])


def _biarcs(points: Array, beta: Array) -> Array:
    """Own columns of two arcs from each point to the next, with given directions at the points."""
    following, after = np.roll(points, -1, axis=0), np.roll(beta, -1)
    after = beta + wrap(after - beta)
    t0 = np.stack([np.cos(beta), np.sin(beta)], axis=-1)
    t1 = np.stack([np.cos(after), np.sin(after)], axis=-1)
    v, t = following - points, t0 + t1
    # The arms d of both arcs are equal: A d^2 + 2 B d = C.
    a, b, c = 2.0 * (1.0 - (t0 * t1).sum(axis=1)), (v * t).sum(axis=1), (v * v).sum(axis=1)
    arm = c / (b + np.sqrt(b * b + a * c))
    joint = (points + arm[:, None] * t0 + following - arm[:, None] * t1) / 2.0
    chord = joint - points
    middle = 2.0 * np.arctan2(chord[:, 1], chord[:, 0]) - beta
    middle = beta + wrap(middle - beta)
    smooth = np.zeros((2 * len(points), OWN))
    for k, start, begin, end, line in (
        (0, points, beta, middle, chord), (1, joint, middle, after, following - joint),
    ):  # fmt: skip
        rho = np.hypot(line[:, 0], line[:, 1]) / (2.0 * np.sin((end - begin) / 2.0))
        normal = np.stack([-np.sin(begin), np.cos(begin)], axis=-1)
        smooth[k::2, :2], smooth[k::2, 2] = start + rho[:, None] * normal, rho
        smooth[k::2, 3], smooth[k::2, 4], smooth[k::2, LENGTH] = begin, end, rho * (end - begin)
    return smooth
