"""The motion under a line of force, as the only root of the force across the line.

Psi is convex along a path across the line of force. The force across the line therefore increases, and
there is exactly one motion with a given component along the line. With effects of one degree, the motions
for all components have the same direction.
"""

from __future__ import annotations

from math import inf
from typing import NamedTuple

from planar_pushing.simulation.legacy.base import moment
from planar_pushing.simulation.legacy.compiled import compiled
from planar_pushing.simulation.legacy.motion import NOWHERE, ROUNDING
from planar_pushing.simulation.legacy.psi import psi
from planar_pushing.simulation.legacy.way import (
    FLAT,
    Way,
    at_infinity,
    beside,
    crossing,
    first_node,
    flat_end,
    is_flat,
    motion,
    node,
)

#: Number of Newton steps that polish a root within the rounding of its motion, and their largest size
#: relative to the motion.
POLISHES, POLISHED = 2, 1e-12


class Moved(NamedTuple):
    """A motion of the slider and the force at the contact that sustains it, in the body frame.

    Attributes
    ----------
    u_x, u_y : float
        Motion of the contact.
    v_x, v_y, spin : float
        Twist of the origin.
    f_x, f_y : float
        Force; for a pivot with an undetermined force, the midpoint of its interval.
    free_x, free_y : float
        Half of that interval, otherwise zero.
    point : int
        Number of the support point about which the slider pivots, -1 without one.
    continuum : bool
        Whether the motion is an end of a continuum, or its rotation is one of an interval.
    noise_x, noise_y : float
        Rounding errors of the force.
    found : bool
        Whether the iterations have converged.
    """

    u_x: float
    u_y: float
    v_x: float
    v_y: float
    spin: float
    f_x: float
    f_y: float
    free_x: float
    free_y: float
    point: int
    continuum: bool
    noise_x: float
    noise_y: float
    found: bool


@compiled
def with_force(moved, f_x, f_y, free_x, free_y):
    """A motion with another force."""
    return Moved(
        moved.u_x, moved.u_y, moved.v_x, moved.v_y, moved.spin, f_x, f_y, free_x, free_y,
        moved.point, moved.continuum, moved.noise_x, moved.noise_y, moved.found,
    )  # fmt: skip


@compiled
def sticking(effects, at, x, y, guess):
    """The motion of a contact that moves by (x, y), to rounding, from a guess of the rotation."""
    now = psi(effects, at, x, y, guess, NOWHERE, ROUNDING)
    return Moved(
        x, y, now.v_x, now.v_y, now.spin, now.f_x, now.f_y, now.free_x, now.free_y,
        now.point, now.continuum, now.noise_x, now.noise_y, now.found,
    )  # fmt: skip


@compiled
def _polished(way, s, spin, point):
    """The motion and rotation at a root of a path, corrected by less than the rounding of the motion.

    The force on a long rod depends on small components of a motion that the sum ``p + s d`` rounds away.
    """
    x, y = motion(way, s)
    for _ in range(POLISHES if point < 0 else 0):
        from_here = Way(way.effects, way.at, way.e_x, way.e_y, x, y, way.d_x, way.d_y)
        here = node(from_here, 0.0, spin, NOWHERE)
        step = -here.before / here.slope if here.slope != 0.0 else 0.0
        small = abs(step) * (abs(way.d_x) + abs(way.d_y)) <= POLISHED * (abs(x) + abs(y))
        if here.before != here.after or not small:
            break
        x, y, spin = x + step * way.d_x, y + step * way.d_y, here.spin + step * here.swing
    return x, y, spin


@compiled
def moved_at(way, s, spin, continuum, point):
    """The motion at a root of a path, or at the kink of a point, with its force along the edge."""
    x, y, spin = _polished(way, s, spin, point)
    now = psi(way.effects, way.at, x, y, spin, point, 0.0)
    part = 0.0
    half = way.e_x * now.free_y - way.e_y * now.free_x
    if half != 0.0:
        part = -(way.e_x * now.f_y - way.e_y * now.f_x) / half
        part = min(max(part, -1.0), 1.0)
    size = way.e_x * (now.f_x + part * now.free_x) + way.e_y * (now.f_y + part * now.free_y)
    return Moved(
        x, y, now.v_x, now.v_y, now.spin, size * way.e_x, size * way.e_y, 0.0, 0.0,
        now.point, continuum or now.continuum, now.noise_x, now.noise_y, now.found,
    )  # fmt: skip


@compiled
def across_force(effects, at, e_x, e_y, along):
    """The path of motions with a given component along a line of force."""
    return Way(effects, at, e_x, e_y, along * e_x, along * e_y, -e_y, e_x)


@compiled
def _start(way, along):
    """A first guess of the root, that of a mass that roughly matches the effects.

    Motions against the force, or without a component along it, are caused by loads: their guess is zero.
    """
    if not along > 0.0:
        return 0.0
    m, x, y, whole = moment(way.effects, along, way.at.x, way.at.y)
    # The force of a motion (u, spin) without torque is M u, so u is M^-1 e up to a factor.
    u_x = (m - x * x / whole) * way.e_x - x * y / whole * way.e_y
    u_y = (m - y * y / whole) * way.e_y - x * y / whole * way.e_x
    across, ahead = way.e_x * u_y - way.e_y * u_x, way.e_x * u_x + way.e_y * u_y
    return along * across / ahead if ahead > 0.0 else 0.0


@compiled
def _root(way, along):
    here = first_node(way, _start(way, along))
    return crossing(way, at_infinity(-inf, -1.0), at_infinity(inf, 1.0), here)


@compiled
def pushed(effects, at, e_x, e_y, along):
    """The motion under a line of force with a given component along it; any motion of a continuum."""
    way = across_force(effects, at, e_x, e_y, along)
    root = _root(way, along)
    return moved_at(way, root.s, root.spin, False, root.point)


@compiled
def pushed_ends(effects, at, e_x, e_y, along):
    """The first and the last motion under a line of force with a given component along it."""
    way = across_force(effects, at, e_x, e_y, along)
    root = _root(way, along)
    low, high = root, root
    jumps, scale = root.before != root.after, abs(root.s) + along
    touches = jumps and min(abs(root.before), abs(root.after)) <= root.noise
    if root.found and (touches or is_flat(way, root, scale) or _is_at_end(way, root, scale)):
        low, high = _end(way, root, -1.0), _end(way, root, 1.0)
    continuum = low.s < high.s
    first = moved_at(way, low.s, low.spin, continuum, low.point)
    return first, moved_at(way, high.s, high.spin, continuum, high.point) if continuum else first


@compiled
def _is_at_end(way, root, scale):
    """Whether the root of a force that is along the line but for rounding is the end of a continuum."""
    right = beside(way, root, root.s - FLAT * scale)
    return is_flat(way, right, scale) or is_flat(
        way, beside(way, root, root.s + FLAT * scale), scale
    )


@compiled
def _end(way, root, sense):
    """The end of a continuum around a root, in one sense."""
    scale, inside = abs(root.s) + abs(way.p_x) + abs(way.p_y), root
    step = 1e-3 * scale
    while step < 1e20 * scale:
        there = beside(way, inside, root.s + sense * step)
        if max(abs(there.before), abs(there.after)) > there.noise:
            return flat_end(way, inside, there) if inside.s != root.s else root
        inside, step = there, 2.0 * step
    return inside
