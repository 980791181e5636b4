"""The slips under an edge of the friction cone, as roots of the force across the edge.

The motions of the contact share the pusher's normal component. The variable s is their component along the
fence, in the sense of the edge's force. It runs from the slowest motion that this force can drive to the
pusher's motion, at which the contact sticks. The force there is evaluated once for the stick and the slips:
its sign across the edge decides on both.
"""

from __future__ import annotations

from math import asinh, ceil, fabs, sinh

from planar_pushing.core._record import Record, size_of
from planar_pushing.core.instant.path import (
    Path,
    Sample,
    end_of_flat,
    find_root,
    first_sample,
    hinge_on_edge,
    is_flat,
    keeps_direction,
    kink_of,
    motion_at,
    nearest_kink,
    sample_near,
    sample_path,
)
from planar_pushing.core.numbers import Numbers
from planar_pushing.core.supports.contact import is_held
from planar_pushing.core.supports.tolerances import BARELY, COINCIDENT, FLAT, SLOW, SLOWEST, TURN

#: Width of a cell in asinh(s / normal component), and minimum number of cells.
CELL_WIDTH = 0.5
FEWEST_CELLS = 3
#: Position on a path: at its start, outside a continuum, inside one.
AT_START, OUTSIDE, INSIDE = range(3)
#: Maximum number of times that a dip is halved.
HALVINGS = 60
#: Maximum number of slips under one edge.
SLIPS = 8


class Slip(Record):
    """A slip under an edge.

    Attributes
    ----------
    s, spin : float
        Position on the path, and rotation.
    continuum : bool
        Whether it is an end of a continuum.
    pivot : int
        Number of its pivot.
    """

    s: float
    spin: float
    continuum: bool
    pivot: int


SLIP = size_of(Slip)


def _count_cells(path: Path, unit: float, first: float, last: float) -> int:
    """Number of cells between two positions on a path: one if the force across the edge is monotone."""
    if keeps_direction(path):
        return 1
    return max(ceil((asinh(last / unit) - asinh(first / unit)) / CELL_WIDTH), FEWEST_CELLS)


def find_slips(
    path: Path, unit: float, first: float, stick: Sample, slips: Numbers
) -> tuple[int, bool]:
    """Write the roots from `first` to the stick, in this order.

    Parameters
    ----------
    path : Path
        Along the fence; `unit` is the magnitude of its normal component.
    unit, first : float
    stick : Sample
    slips : Numbers
        Room for `SLIPS` slips.

    Returns
    -------
    count : int
        Number of slips, -1 if an iteration has not converged or there are too many.
    flat : bool
        Whether the last motions belong to a continuum.
    """
    straight: bool = path.p_x == 0.0 and path.p_y == 0.0
    flat: bool = False
    last = stick.s
    unit = unit if unit > 0.0 else SLOWEST
    cells = _count_cells(path, unit, first, last)
    start, end = asinh(first / unit), asinh(last / unit)
    here, count, position, reached = first_sample(path, first), 0, AT_START, first
    for i in range(1, cells + 1):
        s = last if i == cells else unit * sinh(start + (end - start) * float(i) / float(cells))
        while reached < s:
            flat = _can_be_flat(path, straight, position)
            kink = nearest_kink(path, reached, s, reached)
            if kink.s == kink.s:
                reached, sample = kink.s, sample_path(path, kink.s, kink.spin, kink.point)
            else:
                reached, sample = s, stick if i == cells else sample_near(path, here, s)
            # The sign of a rounding error is meaningless, so the next sample decides.
            if flat or not sample.converged or reached == last or not _vanishes(sample):
                count, position = _write_slips_between(
                    path,
                    unit,
                    straight,
                    flat,
                    low=here,
                    high=sample,
                    slips=slips,
                    count=count,
                    position=position,
                )
                if _steps_across(flat, here, sample):
                    count = _write_slip(unit, sample, False, slips, count)
                here = sample
    return _insert_hinges(path, unit, first, last, slips, count), position == INSIDE


def _insert_hinges(
    path: Path, unit: float, first: float, last: float, slips: Numbers, count: int
) -> int:
    """Insert the pivots with an interval of forces on the edge, at which the force can just touch it."""
    for i in range(0 if is_held(path.contact) else path.effects.feet):
        kink = kink_of(path, i)
        if count < 0 or not first < kink.s < last:
            continue
        u = motion_at(path, kink.s)
        if hinge_on_edge(path, u.x, u.y, kink.spin) < 0:
            continue
        sample, place, kept, flat = sample_path(path, kink.s, kink.spin, i), 0, 0, False
        for k in range(count):
            slip = Slip(slips[SLIP * k :])
            flat = flat or (slip.continuum and _is_same_root(path, unit, sample, slip.s))
        if flat or not (sample.converged and _vanishes(sample)):
            continue
        for k in range(count):
            slip = Slip(slips[SLIP * k :])
            if _is_same_root(path, unit, sample, slip.s):
                continue
            place = kept + 1 if slip.s < kink.s else place
            _copy_slip(slips[SLIP * kept :], slips[SLIP * k :])
            kept += 1
        if kept == SLIPS:
            return -1
        for k in range(kept, place, -1):
            _copy_slip(slips[SLIP * k :], slips[SLIP * (k - 1) :])
        _write_slip(unit, sample, False, slips, place)
        count = kept + 1
    return count


def _is_same_root(path: Path, unit: float, kink: Sample, s: float) -> bool:
    """Whether a root is that at a kink: the force between them vanishes to rounding."""
    distance, size = fabs(kink.s - s), fabs(kink.s) + unit
    if distance <= COINCIDENT * size:
        return True
    return distance <= BARELY * size and _vanishes(sample_near(path, kink, (kink.s + s) / 2.0))


def _copy_slip(target: Numbers, source: Numbers) -> None:
    """Overwrite a slip with another one."""
    for k in range(SLIP):
        target[k] = source[k]


def _is_zero(sample: Sample, force: float) -> bool:
    return fabs(force) <= sample.noise


def _vanishes(sample: Sample) -> bool:
    return _is_zero(sample, sample.before) and _is_zero(sample, sample.after)


def _steps_across(flat: bool, here: Sample, kink: Sample) -> bool:
    """Whether the force jumps across the edge at a kink, or onto it; flat stretches count separately."""
    from_zero: bool = _is_zero(kink, kink.before)
    to_zero: bool = _is_zero(kink, kink.after)
    if flat:
        return kink.before * kink.after < 0.0 and not (from_zero or to_zero)
    if to_zero:
        return not from_zero
    return (here.after if from_zero else kink.before) * kink.after < 0.0


def _write_slip(unit: float, sample: Sample, continuum: bool, slips: Numbers, count: int) -> int:
    """Write a slip and return the number of slips, -1 if it was not found or does not fit.

    Two cells that meet at a kink can both find the same slip.
    """
    if count > 0:
        distance = fabs(sample.s - Slip(slips[SLIP * (count - 1) :]).s)
        if distance <= COINCIDENT * (fabs(sample.s) + unit):
            return count
    if count < 0 or count == SLIPS or not sample.converged:
        return -1
    slip = Slip(slips[SLIP * count :])
    slip.s, slip.spin = sample.s, sample.spin
    slip.continuum, slip.pivot = continuum, sample.point
    return count + 1


def _write_slips_between(
    path: Path, unit: float, straight: bool, flat: bool,
    low: Sample, high: Sample, slips: Numbers, count: int, position: int,
) -> tuple[int, int]:  # fmt: skip
    """Write the slips between two motions; return the number of slips, and the position on the path."""
    if count < 0 or not (low.converged and high.converged):
        return -1, position
    if flat and (_is_zero(low, low.after) or _is_zero(high, high.before)):
        return _write_touching_slips(path, unit, straight, low, high, slips, count, position)
    if _is_zero(low, low.after) or (high.point >= 0 and _is_zero(high, high.before)):
        return count, OUTSIDE
    if (low.after > 0.0) != (high.before > 0.0):
        return _write_root(path, unit, low, high, slips, count), OUTSIDE
    bottom = _bottom_of_dip(path, low, high)
    if _is_zero(bottom, bottom.after):
        return _write_slip(unit, bottom, False, slips, count), OUTSIDE
    if (bottom.after > 0.0) != (low.after > 0.0):
        count = _write_root(path, unit, low, bottom, slips, count)
        count = _write_root(path, unit, bottom, high, slips, count)
    return count, OUTSIDE


def _can_be_flat(path: Path, straight: bool, position: int) -> bool:
    """Whether a stretch of a path can be a continuum.

    With effects of one degree any stretch can be. Otherwise only a stretch along the fence that begins at
    rest can be: elsewhere inertia adds a force across the edge that is proportional to the motion.
    """
    return keeps_direction(path) or (straight and position != OUTSIDE)


def _flat_end_near(path: Path, straight: bool, sample: Sample, other: Sample) -> Sample:
    """The end of a flat stretch that begins at a motion, or the motion itself if it is an isolated root.

    Motions along the fence differ in magnitude, all others in direction.
    """
    if not _is_zero(sample, sample.after if other.s > sample.s else sample.before):
        return sample
    near = sample_near(path, sample, sample.s + FLAT * (other.s - sample.s))
    if max(fabs(near.before), fabs(near.after)) > near.noise:
        return sample
    end = end_of_flat(path, near, other)
    u, w = motion_at(path, sample.s), motion_at(path, end.s)
    size = (fabs(u.x) + fabs(u.y)) * (fabs(w.x) + fabs(w.y))
    return end if straight or fabs(u.x * w.y - u.y * w.x) > TURN * size else sample


def _write_touching_slips(
    path: Path, unit: float, straight: bool,
    low: Sample, high: Sample, slips: Numbers, count: int, position: int,
) -> tuple[int, int]:  # fmt: skip
    """Write the slips of a cell at whose end the force is along the edge: a root, or a continuum."""
    first = _flat_end_near(path, straight, low, high)
    last = _flat_end_near(path, straight, high, low)
    starts: bool = first.s > low.s
    ends: bool = last.s < high.s
    # A path along the fence begins at rest, where a force along the edge is no slip.
    rests: bool = straight and fabs(first.s) <= SLOW
    begins: bool = rests or (starts and position == AT_START)
    if _is_zero(low, low.after) and position != INSIDE and not begins:
        count = _write_slip(unit, low, starts, slips, count)
    if starts and ends:
        return count, INSIDE
    if starts and not rests:
        count = _write_slip(unit, first, True, slips, count)
    elif position == INSIDE and not rests:
        count = _write_slip(unit, low, True, slips, count)
    if ends:
        return _write_slip(unit, last, True, slips, count), INSIDE
    if _is_zero(high, high.before) and not _is_zero(high, high.after):
        count = _write_slip(unit, high, False, slips, count)
    return count, OUTSIDE


def _bottom_of_dip(path: Path, low: Sample, high: Sample) -> Sample:
    """A motion between two at which the force has the opposite sign, or the lower motion if there is none.

    The dip is halved while both slopes point into it and the tangents at its sides meet beyond zero. If the
    force at its bottom is zero to rounding, the bottom is a double root.
    """
    bottom, sign = low, 1.0 if low.after > 0.0 else -1.0
    at_low, at_high = fabs(low.after), fabs(high.before)
    for i in range(HALVINGS):
        width, low_slope, high_slope = high.s - low.s, sign * low.slope, sign * high.slope
        if not low_slope < 0.0 < high_slope:
            break
        part = (at_low - at_high + high_slope * width) / (high_slope - low_slope)
        if i > 0 and at_low + part * low_slope > 0.0:
            break
        middle = sample_near(path, low, low.s + width / 2.0)
        if _is_zero(middle, middle.after):
            bottom = middle
        elif sign * middle.after < 0.0:
            return middle
        if sign * middle.slope < 0.0:
            low, at_low = middle, fabs(middle.after)
        else:
            high, at_high = middle, fabs(middle.before)
    return bottom


def _write_root(
    path: Path, unit: float, low: Sample, high: Sample, slips: Numbers, count: int
) -> int:
    """Write the slip between two motions of opposite signs, or both ends of a continuum."""
    s = low.s + min(max(_part_of_bracket(low, high), 0.05), 0.95) * (high.s - low.s)
    root = find_root(path, low, high, sample_near(path, low, s))
    if keeps_direction(path) and is_flat(path, root, fabs(root.s) + unit):
        first = _flat_end_near(path, False, root, low)
        last = _flat_end_near(path, False, root, high)
        if first.s != root.s or last.s != root.s:
            count = _write_slip(unit, first, True, slips, count)
            return _write_slip(unit, last, True, slips, count)
    return _write_slip(unit, root, False, slips, count)


def _part_of_bracket(low: Sample, high: Sample) -> float:
    """Fraction of the path between two motions at which the inverse cubic through both is zero.

    The secant is used if the force across the edge is not monotone.
    """
    change, width = high.before - low.after, high.s - low.s
    if change == 0.0:
        return 0.5
    part, at_low, at_high = -low.after / change, width * low.slope, width * high.slope
    if at_low * change > 0.0 and at_high * change > 0.0:
        start, end, rest = change / at_low, change / at_high, 1.0 - part
        part *= part * (3.0 - 2.0 * part) + rest * (rest * start - part * end)
    return part
