"""The variables of each contact in a log of several contacts: mode, force, gap and normal."""

from __future__ import annotations

import math

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.simulation.several.run import Row, SeveralRun


def mode_of(row: Row, mover: int) -> int:
    """The mode of a mover's contact: of several, that with the largest force."""
    best, size = int(ContactMode.SEPARATE), -1.0
    for touch, mode, force in zip(row.touches, row.modes, row.forces, strict=True):
        if touch.mover == mover and mode != ContactMode.SEPARATE:
            strength = math.hypot(*force)
            if not strength <= size:
                best, size = mode, strength
    return best


def force_of(row: Row, mover: int) -> tuple[float, float]:
    """The force of a mover on the object, along the axes of the world."""
    c, s = math.cos(row.pose.angle), math.sin(row.pose.angle)
    x = y = 0.0
    for touch, (f_x, f_y) in zip(row.touches, row.forces, strict=True):
        if touch.mover == mover:
            x, y = x + c * f_x - s * f_y, y + s * f_x + c * f_y
    return x, y


def gap_of(run: SeveralRun, row: Row, mover: int) -> float:
    """Distance of the object from a mover."""
    if mode_of(row, mover) != ContactMode.SEPARATE:
        return 0.0
    touches = run.shape.touches(mover, run.movers[mover], row.pose, row.time, math.inf)
    return min((touch.gap for touch in touches), default=0.0)


def normal_of(run: SeveralRun, row: Row, mover: int) -> float:
    """Direction of the inward normal at a mover's nearest place, in degrees in the world, or NaN."""
    touches = [touch for touch in row.touches if touch.mover == mover]
    if not touches:
        touches = run.shape.touches(mover, run.movers[mover], row.pose, row.time, math.inf)
        touches = sorted(touches, key=lambda touch: touch.gap)[:1]
    if not touches:
        return math.nan
    n_x, n_y = touches[0].normal
    return math.degrees(row.pose.angle + math.atan2(n_y, n_x))
