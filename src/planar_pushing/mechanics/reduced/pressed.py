"""Sticking, slipping and limit curve of any support and any centre of mass, as `base` asks for them."""

from __future__ import annotations

from collections.abc import Callable
from math import atan2, copysign, exp, hypot, inf
from typing import Any, NamedTuple

from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.compiled import compiled, generic
from planar_pushing.mechanics.effects.any_mass import MassAt
from planar_pushing.mechanics.numerics.bracket import bracketed
from planar_pushing.mechanics.numerics.root import EQUATIONS, excess
from planar_pushing.mechanics.plane import Direction, Rod
from planar_pushing.mechanics.reduced.corners import CONTINUUM, corner_under
from planar_pushing.mechanics.reduced.general import (
    Line,
    Motion,
    felt,
    motion_under,
    rough_motion,
    spin_of,
)
from planar_pushing.mechanics.reduced.pivots import NOWHERE, pivot_of, pivot_under
from planar_pushing.mechanics.reduced.sticking import Sustained

#: Range of the logarithm of a motion's part along its line of force, in units in which friction and inertia
#: are of one size, and the number of nodes on each side of the middle, where they are denser.
RANGE, NODES = 32.0, 24


class Amount(NamedTuple):
    """Of the motions under a line of force, over the logarithm of their part along it."""

    effects: tuple[Any, ...]
    own: Rod
    edge: Direction


class Speed(NamedTuple):
    """Logarithm of the origin's speed."""

    amount: Amount


class Energy(NamedTuple):
    """Kinetic energy over that of a unit translation, less 1."""

    amount: Amount


class Rise(NamedTuple):
    """The contact's normal motion less a given one."""

    amount: Amount
    normal: float


@compiled
def _sustained(own, motion, f_x, f_y, free_x, free_y, index):
    """A motion with its force, from the body frame."""
    v_y = motion.y + own.length * motion.spin
    return Sustained(
        motion.x * own.x - v_y * own.y, motion.x * own.y + v_y * own.x, motion.spin,
        f_x * own.x - f_y * own.y, f_x * own.y + f_y * own.x, f_x, -f_y, 1.0,
        free_x, -free_y, index,
    )  # fmt: skip


@compiled
def stick(effects, own, towards):
    """As `base.stick`."""
    x, y, length = towards.along, -towards.aside, own.length
    pivot = pivot_of(effects, length, x, y)
    if pivot.atom != NOWHERE:
        _, motion, f_x, f_y, free_x, free_y = pivot
        return _sustained(own, motion, f_x, f_y, free_x, free_y, pivot.atom)
    motion = Motion(x, y, spin_of(effects, length, x, y))
    now = felt(effects, length, motion)
    return _sustained(own, motion, now.f_x, now.f_y, 0.0, 0.0, NOWHERE)


@compiled
def _line(effects, own, edge, along):
    """The line of a force, of motions with a given part along it."""
    return Line(effects, own.length, edge.along, -edge.aside, along)


@compiled
def pushed(effects, own, edge, along):
    """The motion under a line of force that has a given part along it; of a corner the translation."""
    line = _line(effects, own, edge, along)
    if corner_under(effects, line).exists:
        motion = Motion(along * line.x, along * line.y, 0.0)
        return _of_line(effects, own, line, motion)
    pivot = pivot_under(effects, line)
    if pivot.atom != NOWHERE:
        return _sustained(own, pivot.motion, pivot.f_x, pivot.f_y, 0.0, 0.0, pivot.atom)
    return _of_line(effects, own, line, motion_under(line, rough_motion(line)))


@compiled
def _of_line(effects, own, line, motion):
    """A motion with its force, which is along a line."""
    now = felt(effects, own.length, motion)
    size = now.f_x * line.x + now.f_y * line.y
    return _sustained(own, motion, size * line.x, size * line.y, 0.0, 0.0, NOWHERE)


@compiled
def _contact(own, moved):
    """Motion of the contact along the fence and normal to it."""
    lever = own.length * moved.spin
    return moved.v_x + lever * own.y, moved.v_y - lever * own.x


@compiled
def _rise(own, moved):
    """Normal motion of the contact, zero where nothing but rounding is left of it."""
    normal, lever = _contact(own, moved)[1], abs(own.length * moved.spin)
    noise = RESOLUTION * (hypot(moved.v_x, moved.v_y) + lever)
    return normal if abs(normal) > noise else 0.0


@compiled
def held_on_edge(effects, own, edge, moved):
    """As `base.held_on_edge`."""
    x, y = _contact(own, moved)
    return pushed(effects, own, edge, x * edge.x + y * edge.y)


@compiled
def _motion(amount, z):
    return pushed(amount.effects, amount.own, amount.edge, exp(z))


@compiled
def _speed(of, z):
    moved = _motion(of.amount, z)
    return hypot(moved.v_x, moved.v_y) - 1.0, 0.0


@compiled
def _energy(of, z):
    mass, moved = of.amount.effects[-1], _motion(of.amount, z)
    own = of.amount.own
    x, y = moved.v_x * own.x + moved.v_y * own.y, moved.v_y * own.x - moved.v_x * own.y
    x, y = x - moved.spin * mass.y, y + moved.spin * mass.x
    return x * x + y * y + mass.gyration * moved.spin * moved.spin - 1.0, 0.0


@compiled
def _lack(of, z):
    return _rise(of.amount.own, _motion(of.amount, z)) - of.normal, 0.0


EQUATIONS.update({Speed: _speed, Energy: _energy, Rise: _lack})


@generic
def _typical(kinds: Any) -> Callable[..., Any]:
    """The motion under a force in a direction, the centre at unit speed: effects, own, force."""
    return _of_unit_part if len(kinds) == 1 else _of_unit_speed


@compiled
def _of_unit_part(effects, own, force):
    return pushed(effects, own, force, 1.0)


@compiled
def _of_unit_speed(effects, own, force):
    amount = Amount(effects, own, force)
    return _motion(amount, _sought(Speed(amount)))


@compiled
def _angle(own, force, moved):
    """Angle of the contact's motion, on the branch within 90 degrees of the force."""
    x, y = _contact(own, moved)
    return force.angle + atan2(force.x * y - force.y * x, force.x * x + force.y * y)


@compiled
def _ratio(moved):
    """R omega / v; infinite for a rotation about the slider's centre."""
    speed = hypot(moved.v_x, moved.v_y)
    return moved.spin / speed if speed > 0.0 else copysign(inf, moved.spin)


@compiled
def spin_ratio(effects, own, force):
    """As `base.spin_ratio`."""
    moved = _typical(effects, own, force)
    return _ratio(moved)


@compiled
def motion_angle(effects, own, force):
    """As `base.motion_angle`."""
    return _angle(own, force, _typical(effects, own, force))


@compiled
def motion_angles(effects, own, force):
    """As `base.motion_angles`: between those of each effect alone, and the ends of a corner."""
    if len(effects) > 1:
        low, high = _angles_alone(effects[:1], own, force)
        other = _angle(own, force, pushed(effects[-1:], own, force, 1.0))
        # Of the motions of a corner, the slowest are the nearest to that of inertia.
        near = min(max(low, other), high)
        return min(near, other), max(near, other)
    return _angles_alone(effects, own, force)


@compiled
def _angles_alone(effects, own, force):
    """Least and greatest angle under a force, of one effect."""
    corner = corner_under(effects, _line(effects, own, force, 1.0))
    if corner.exists:
        one = _angle(own, force, _at_end(own, corner.first, 0.0, 0.0))
        other = _angle(own, force, _at_end(own, corner.last, 0.0, 0.0))
    else:
        one = _angle(own, force, pushed(effects, own, force, 1.0))
        other = one
    return min(one, other), max(one, other)


@compiled
def _at_end(own, motion, f_x, f_y):
    """A motion at an end of those that one force sustains."""
    return _sustained(own, motion, f_x, f_y, 0.0, 0.0, CONTINUUM)


@generic
def _on_curve(kinds: Any) -> Callable[..., Any]:
    """The motion of a force on the limit curve: effects, own, force."""
    return _of_unit_energy if MassAt in kinds else _of_unit_part


@compiled
def _of_unit_energy(effects, own, force):
    amount = Amount(effects, own, force)
    return _motion(amount, _sought(Energy(amount)))


@compiled
def _sought(equation):
    """Root of an equation that increases with the part of the motion along its line."""
    width, at = 1.0, excess(equation, 0.0)[0]
    while True:
        other = -width if at > 0.0 else width
        beyond = excess(equation, other)[0]
        if (beyond > 0.0) != (at > 0.0) or width >= RANGE:
            return bracketed(
                equation, min(0.0, other), max(0.0, other), min(at, beyond), max(at, beyond)
            )
        width *= 2.0


@compiled
def limit_motion(effects, own, force):
    """As `base.limit_motion`."""
    moved = _on_curve(effects, own, force)
    return hypot(moved.f_x, moved.f_y), _ratio(moved), _angle(own, force, moved)


@compiled
def _write(moved, scale, force, found):
    """Write down a motion times a scale, its force times another."""
    found[0], found[1], found[2] = scale * moved.v_x, scale * moved.v_y, scale * moved.spin
    found[3], found[4] = force * moved.f_x, force * moved.f_y
    found[5], found[6], found[7] = found[3], found[4], float(moved.pivot)


@compiled
def edge_motion(effects, own, edge):
    """As `base.edge_motion`."""
    moved = pushed(effects, own, edge, 1.0)
    scale = 1.0 / max(hypot(moved.v_x, moved.v_y), abs(moved.spin))
    force = _growth(effects, scale)
    twist = scale * moved.v_x, scale * moved.v_y, scale * moved.spin
    return *twist, force * moved.f_x, force * moved.f_y


@compiled
def steady_slips(effects, own, edge, normal, found):
    """As `base.slips`, for one effect, whose motion keeps its direction; of a corner both ends."""
    line = _line(effects, own, edge, 1.0)
    corner = corner_under(effects, line)
    if corner.exists:
        middle = pushed(effects, own, edge, 1.0)
        first = _at_end(own, corner.first, middle.along, -middle.aside)
        last = _at_end(own, corner.last, middle.along, -middle.aside)
        count = _grown(effects, own, first, normal, found[0])
        return count + _grown(effects, own, last, normal, found[count])
    return _grown(effects, own, pushed(effects, own, edge, 1.0), normal, found[0])


@compiled
def _grown(effects, own, moved, normal, found):
    """Write down a motion that has grown to a given normal part; how many can."""
    advance = _rise(own, moved)
    if not ((normal > 0.0 and advance > 0.0) or (normal < 0.0 and advance < 0.0)):
        return 0
    scale = normal / advance
    _write(moved, scale, _growth(effects, scale), found)
    return 1


@generic
def _growth(kinds: Any) -> Callable[..., Any]:
    """How a force grows with the motion."""
    return _in_proportion if MassAt in kinds else _not


@compiled
def _in_proportion(effects, scale):
    return scale


@compiled
def _not(effects, scale):
    return 1.0


@compiled
def slips(effects, own, edge, normal, found):
    """As `base.slips`, for friction and inertia: roots between nodes of the normal motion."""
    amount, count = Amount(effects, own, edge), 0
    low, last = 0.0, 0.0
    for i in range(-NODES, NODES + 1):
        z = RANGE * i * abs(i) / (NODES * NODES)
        lack = _rise(own, _motion(amount, z)) - normal
        if i > -NODES and count < len(found) and (last < 0.0) != (lack < 0.0):
            moved = _motion(amount, bracketed(Rise(amount, normal), low, z, last, lack))
            _write(moved, 1.0, 1.0, found[count])
            count += 1
        low, last = z, lack
    return count


@compiled
def _center(moved_x, moved_y, spin):
    """Motion centre from the origin of a motion."""
    if spin != 0.0:
        return -moved_y / spin, moved_x / spin
    x = -copysign(inf, moved_y) if moved_y != 0.0 else 0.0
    return x, copysign(inf, moved_x) if moved_x != 0.0 or x == 0.0 else 0.0


@compiled
def center_of(effects, own, motion):
    """As `base.center_of`."""
    x, y = _center(motion[0], motion[1], motion[2])
    return x + own.length * own.x, y + own.length * own.y


@compiled
def center_under(effects, own, force):
    """As `base.center_under`."""
    moved = _typical(effects, own, force)
    return _center(moved.v_x, moved.v_y, moved.spin)
