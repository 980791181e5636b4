"""The force across an edge along a straight path of contact motions, and its roots.

A path is ``u = p + s d``. If p is the pusher's normal motion and d is along the fence, its roots are the
slips under an edge of the friction cone. If p is along a line of force and d across it, the only root is
the motion under that force. Psi is convex. The force across the edge is therefore monotone in the second
case, if p and d are parallel, or if the effects have one degree. Otherwise it can have a dip.

If the slider pivots about a support point, the force is in an interval, and the force across the edge
jumps: a root within the jump is the pivot. By symmetry, or with a support on one line, the force across the
edge can vanish to rounding on a whole stretch of the path, not only at a root: this stretch is a continuum.
"""

from __future__ import annotations

from math import copysign, fabs, sqrt
from typing import NamedTuple

from planar_pushing.core.numbers import EPSILON, INFINITY, UNKNOWN
from planar_pushing.core.supports.contact import Contact, is_at_contact, is_held
from planar_pushing.core.supports.potential import Psi
from planar_pushing.core.supports.psi import guess_spin, psi
from planar_pushing.core.supports.roots import is_last
from planar_pushing.core.supports.rows import NO_POINT, Effects, Position, foot_position, is_steady
from planar_pushing.core.supports.tolerances import ALIGNED, COINCIDENT, FLAT, UNDERFLOW

#: Maximum number of steps to a root.
STEPS = 200
#: Maximum length of a step, relative to the motion.
LONGEST_STEP = 8.0


class Path(NamedTuple):
    """Contact motions ``p + s d`` in the body frame, and the unit vector e of an edge."""

    effects: Effects
    contact: Contact
    e_x: float
    e_y: float
    p_x: float
    p_y: float
    d_x: float
    d_y: float


class Sample(NamedTuple):
    """The motion at one position on a path.

    Attributes
    ----------
    s : float
    before, after : float
        Force across the edge, ``e x f``, just before and after s; they differ only at a pivot.
    slope : float
        Derivative of this force with respect to s.
    noise : float
        Rounding error of this force.
    spin, swing : float
        Rotation, and its derivative with respect to s.
    point : int
        Number of the support point about which the slider pivots, -1 without one.
    converged : bool
    """

    s: float
    before: float
    after: float
    slope: float
    noise: float
    spin: float
    swing: float
    point: int
    converged: bool


class Kink(NamedTuple):
    """A motion of the contact across the line to a support point, the rotation about it, and its number."""

    s: float
    spin: float
    point: int


def motion_at(path: Path, s: float) -> Position:
    """The contact's motion."""
    return Position(path.p_x + s * path.d_x, path.p_y + s * path.d_y)


def keeps_direction(path: Path) -> bool:
    """Whether the direction of the force does not depend on the magnitude of the motion."""
    turns: bool = is_held(path.contact) and path.contact.spin != 0.0
    return is_steady(path.effects) and not turns


def sample_path(path: Path, s: float, spin: float, point: int) -> Sample:
    """The motion at s, from a guess of its rotation and, at a kink, the number of its point."""
    u = motion_at(path, s)
    return sample_of(
        path, s, psi(path.effects, path.contact, u.x, u.y, guess=spin, point=point, tolerance=0.0)
    )


def sample_of(path: Path, s: float, root: Psi) -> Sample:
    """The motion at s, from Psi there."""
    e_x, e_y, d_x, d_y = path.e_x, path.e_y, path.d_x, path.d_y
    across = e_x * root.f_y - e_y * root.f_x
    bend_x, bend_y = root.xx * d_x + root.xy * d_y, root.xy * d_x + root.yy * d_y
    slope, swing = e_x * bend_y - e_y * bend_x, root.turn_x * d_x + root.turn_y * d_y
    half, before, after = e_x * root.half_y - e_y * root.half_x, across, across
    if root.point >= 0 and fabs(half) > ALIGNED * (fabs(root.half_x) + fabs(root.half_y)):
        ahead = root.half_x * d_x + root.half_y * d_y
        size = (fabs(root.half_x) + fabs(root.half_y)) * (fabs(d_x) + fabs(d_y))
        if fabs(ahead) > ALIGNED * size:
            # Psi is convex, so the force along d jumps up as s increases.
            jump = copysign(half, half * ahead)
            before, after = across - jump, across + jump
        else:
            # The whole path is across the line to the point; the point's friction can bring the force to
            # the edge.
            before = copysign(max(fabs(across) - fabs(half), 0.0), across)
            after, slope = before, 0.0
    noise = fabs(e_x) * root.noise_y + fabs(e_y) * root.noise_x + UNDERFLOW
    return Sample(
        s, before, after, slope, noise, root.spin, swing, root.point, root.converged
    )  # fmt: skip


def sample_near(path: Path, sample: Sample, s: float) -> Sample:
    """The motion at s, from a nearby motion."""
    return sample_path(path, s, sample.spin + sample.swing * (s - sample.s), NO_POINT)


def first_sample(path: Path, s: float) -> Sample:
    """The motion at s, from a first guess of its rotation."""
    u = motion_at(path, s)
    return sample_path(path, s, guess_spin(path.effects, path.contact, u.x, u.y), NO_POINT)


def kink_of(path: Path, point: int) -> Kink:
    """The kink of a support point; NaN if the whole path is across its line to the contact."""
    foot = foot_position(path.effects, point)
    r_x, r_y = foot.x - path.contact.x, foot.y - path.contact.y
    ahead = path.d_x * r_x + path.d_y * r_y
    size = (fabs(r_x) + fabs(r_y)) * (fabs(path.d_x) + fabs(path.d_y))
    if fabs(ahead) <= ALIGNED * size or is_at_contact(path.contact, foot.x, foot.y):
        return Kink(UNKNOWN, UNKNOWN, NO_POINT)
    s = -(path.p_x * r_x + path.p_y * r_y) / ahead
    u = motion_at(path, s)
    return Kink(s, (u.x * r_y - u.y * r_x) / (r_x * r_x + r_y * r_y), point)


def nearest_kink(path: Path, low: float, high: float, s: float) -> Kink:
    """The kink nearest to s between two positions; NaN if there is none."""
    nearest, distance = Kink(UNKNOWN, UNKNOWN, NO_POINT), INFINITY
    for i in range(0 if is_held(path.contact) else path.effects.feet):
        kink = kink_of(path, i)
        if low < kink.s < high and fabs(kink.s - s) < distance:
            nearest, distance = kink, fabs(kink.s - s)
    return nearest


def hinge_on_edge(path: Path, x: float, y: float, spin: float) -> int:
    """Number of a support point about which the slider pivots on the edge's line, -1 without one.

    The contact then moves across the edge, so only loads can cause this motion.
    """
    e_x, e_y, speed = path.e_x, path.e_y, fabs(x) + fabs(y)
    if is_held(path.contact) or fabs(e_x * x + e_y * y) > COINCIDENT * speed or speed == 0.0:
        return NO_POINT
    for i in range(path.effects.feet):
        foot = foot_position(path.effects, i)
        r_x, r_y = foot.x - path.contact.x, foot.y - path.contact.y
        beside = fabs(e_x * r_y - e_y * r_x)
        moves = fabs(x - spin * r_y) + fabs(y + spin * r_x)
        if moves <= COINCIDENT * speed and (
            beside <= ALIGNED * (fabs(r_x) + fabs(r_y) + path.contact.reach)
        ):
            return i
    return NO_POINT


def is_flat(path: Path, sample: Sample, scale: float) -> bool:
    """Whether the force stays along the edge near a motion, to rounding."""
    if max(fabs(sample.before), fabs(sample.after)) > sample.noise:
        return False
    return fabs(sample.slope) * FLAT * scale <= sample.noise


def find_root(path: Path, low: Sample, high: Sample, sample: Sample) -> Sample:
    """The root between two motions of opposite signs, from a motion between them.

    Parameters
    ----------
    path : Path
    low, high, sample : Sample
        `low` and `high` can be at infinity.

    Returns
    -------
    Sample
        Its `converged` tells whether the iteration has converged.
    """
    sense, last = 1.0 if high.before > low.after else -1.0, INFINITY
    d_size, p_size = fabs(path.d_x) + fabs(path.d_y), fabs(path.p_x) + fabs(path.p_y)
    offset = p_size / d_size if p_size > 0.0 else EPSILON
    for _ in range(STEPS):
        before, after = sense * sample.before, sense * sample.after
        if before <= 0.0 <= after:
            return sample
        force = after if after < 0.0 else before
        if after < 0.0:
            low = sample
        else:
            high = sample
        scale, slope = fabs(sample.s) + offset, sense * sample.slope
        step = -force / slope if slope > 0.0 else copysign(INFINITY, -force)
        size, target = fabs(step) / scale, sample.s + step
        settled: bool = is_last(size, last) and low.s <= target <= high.s
        if settled:
            last = size
        elif not low.s < target < high.s or size > last / 2.0:
            if high.s - low.s <= 4.0 * EPSILON * scale:
                return sample
            last, target = INFINITY, _middle_of(low.s, high.s, scale, EPSILON * offset)
        elif size > LONGEST_STEP:
            last, target = INFINITY, sample.s + copysign(LONGEST_STEP * scale, step)
        else:
            last = size
        kink = nearest_kink(path, low.s, high.s, target)
        between: bool = sample.s < kink.s < target or target < kink.s < sample.s
        if between or fabs(kink.s - target) <= ALIGNED * scale:
            last, sample = INFINITY, sample_path(path, kink.s, kink.spin, kink.point)
            continue
        sample = sample_near(path, sample, target)
        if settled:
            return sample
    return mark_unsettled(sample)


def mark_unsettled(sample: Sample) -> Sample:
    """The same motion, marked as not converged."""
    return Sample(
        sample.s, sample.before, sample.after, sample.slope, sample.noise,
        sample.spin, sample.swing, sample.point, False,
    )  # fmt: skip


def sample_at_infinity(s: float, force: float) -> Sample:
    """An end of an unbounded path."""
    return Sample(
        s,
        before=force,
        after=force,
        slope=0.0,
        noise=0.0,
        spin=0.0,
        swing=0.0,
        point=NO_POINT,
        converged=True,
    )


def _middle_of(low: float, high: float, scale: float, smallest: float) -> float:
    """Midpoint of a bracket; the geometric mean if it spans several orders of magnitude."""
    if low == -INFINITY:
        return high - LONGEST_STEP * scale
    if high == INFINITY:
        return low + LONGEST_STEP * scale
    from_low, from_high = max(fabs(low), smallest), max(fabs(high), smallest)
    if high > 4.0 * from_low and from_low > 0.0:
        return sqrt(from_low) * sqrt(high)
    if -low > 4.0 * from_high and from_high > 0.0:
        return -sqrt(from_high) * sqrt(-low)
    return low + (high - low) / 2.0


def end_of_flat(path: Path, inside: Sample, outside: Sample) -> Sample:
    """The end of a flat stretch, to the last digits, between a motion inside it and one outside."""
    for _ in range(STEPS):
        scale = fabs(inside.s) + fabs(outside.s)
        if fabs(inside.s - outside.s) <= EPSILON * scale:
            break
        low, high = min(inside.s, outside.s), max(inside.s, outside.s)
        middle = sample_near(path, inside, _middle_of(low, high, scale, 0.0))
        if max(fabs(middle.before), fabs(middle.after)) <= middle.noise:
            inside = middle
        else:
            outside = middle
    return inside
