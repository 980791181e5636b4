"""The reduced potential of the contact's motion: its gradient and Hessian, from one root for the rotation.

With the rotation eliminated, ``Psi(u) = min over omega`` of the sum of the effects' potentials at the twist
whose contact moves by `u` (Secs. 3 and 4). Psi is convex. Its gradient is the force of the pusher, and the
torque about the contact is zero at the minimum. Everything is in the body frame, with lengths in radii.

The torque increases with the rotation. At a center of rotation on a support point it jumps by twice the
maximum torque of that point's friction. A root within the jump is a pivot, with an interval of forces.
"""

from __future__ import annotations

from math import copysign, fabs, sqrt

from planar_pushing.core.numbers import INFINITY, UNKNOWN
from planar_pushing.core.supports.contact import Contact, is_at_contact, is_held, resistance_about
from planar_pushing.core.supports.free import free_twist
from planar_pushing.core.supports.line import rotation_on_line
from planar_pushing.core.supports.pivot import pivot_psi, pivot_spin, refine_psi
from planar_pushing.core.supports.potential import Psi, held_potential, potential_at, unknown_psi
from planar_pushing.core.supports.resistance import (
    Resistance,
    constant_wrench,
    has_friction,
    kinetic_energy,
    load_wrench,
    rough_mass,
)
from planar_pushing.core.supports.roots import is_last
from planar_pushing.core.supports.rows import (
    NO_POINT,
    Effects,
    Vector,
    foot_position,
    scale_effects,
)
from planar_pushing.core.supports.tolerances import ALIGNED, BARELY, ROUNDING, SHARE

#: Maximum number of steps to a rotation, enough for bisection over 16 orders of magnitude to the last
#: digit.
ROTATIONS = 120
#: Factor by which an unbounded bracket grows, and the longest Newton step relative to the motion.
GROWTH = 8.0


def guess_spin(effects: Effects, contact: Contact, x: float, y: float) -> float:
    """A first guess of the rotation of a contact that moves by (x, y), exact for a mass."""
    if is_held(contact):
        return contact.spin
    if x == 0.0 and y == 0.0:
        return 0.0
    rough = rough_mass(effects, sqrt(x * x + y * y), contact.x, contact.y)
    return (rough.y * x - rough.x * y) / rough.inertia


def spin_at_rest(effects: Effects, contact: Contact) -> float:
    """The rotation about a contact at rest; NaN if nothing resists it.

    About a fixed contact the torque of friction is constant, and that of inertia is proportional to the
    rotation. The slider turns only if friction cannot hold the loads.
    """
    friction = scale_effects(effects, 1.0, 0.0)
    for i in range(2):
        sense = 1.0 if i == 0 else -1.0
        total = resistance_about(
            friction, contact, x=sense * contact.y, y=-sense * contact.x, spin=sense, blur=0.0
        )
        if sense * total.torque < 0.0:
            inertia = 2.0 * kinetic_energy(effects, contact.y, -contact.x, 1.0)
            return -total.torque / inertia if inertia > 0.0 else UNKNOWN
    return 0.0


def _psi_at_rest(effects: Effects, contact: Contact) -> Psi:
    """Psi of a contact at rest, with one of the forces in the gradient, which is a set there.

    If the slider rotates about the contact, it is the force without the friction of a point at the contact.
    If the slider is at rest, it is the opposite of the loads if friction holds the couple that then
    remains, and `_middle_force` otherwise.
    """
    spin, load = 0.0, load_wrench(effects)
    if not is_held(contact):
        spin = spin_at_rest(effects, contact)
    if spin == 0.0:
        force = Vector(-load.x, -load.y, 0.0)
        if not _holds_couple(effects, contact, load):
            force = _middle_force(effects, contact, load)
        total = constant_wrench(force.x, force.y, 0.0)
    else:
        blur = ALIGNED * contact.reach * fabs(spin)
        total = resistance_about(
            effects, contact, x=spin * contact.y, y=-spin * contact.x, spin=spin, blur=blur
        )
    v_x, v_y = spin * contact.y, -spin * contact.x
    return potential_at(
        total, contact, v_x, v_y, spin, step=0.0, x=0.0, y=0.0, size=0.0, converged=spin == spin
    )


def turn_about_contact(effects: Effects, contact: Contact) -> Psi:
    """Psi of a contact at rest about which loads turn the slider; not converged unless on a support point.

    The friction of that point adds any force up to its share, which is `half_x`, to the force.
    """
    spin = 0.0
    for i in range(0 if is_held(contact) else effects.feet):
        foot = foot_position(effects, i)
        if is_at_contact(contact, foot.x, foot.y):
            spin = spin_at_rest(effects, contact)
            break
    if spin == 0.0 or spin != spin:
        return unknown_psi()
    v_x, v_y = spin * contact.y, -spin * contact.x
    blur = ALIGNED * contact.reach * fabs(spin)
    total = resistance_about(effects, contact, x=v_x, y=v_y, spin=spin, blur=blur)
    root = potential_at(
        total,
        contact,
        v_x,
        v_y,
        spin,
        step=0.0,
        x=0.0,
        y=0.0,
        size=0.0,
        converged=total.limit > 0.0,
    )
    return Psi(
        v_x,
        v_y,
        spin,
        root.f_x,
        root.f_y,
        xx=0.0,
        xy=0.0,
        yy=0.0,
        turn_x=0.0,
        turn_y=0.0,
        half_x=total.limit,
        half_y=0.0,
        point=total.point,
        noise_x=root.noise_x,
        noise_y=root.noise_y,
        continuum=False,
        converged=root.converged,
    )


def _holds_couple(effects: Effects, contact: Contact, load: Vector) -> bool:
    """Whether friction holds the couple that remains if a force at the contact is opposite to the loads."""
    if not has_friction(effects) or (load.x == 0.0 and load.y == 0.0 and load.spin == 0.0):
        return True  # without friction, no torque is left
    torque = contact.y * load.x - contact.x * load.y
    twist = free_twist(effects, Vector(-load.x, -load.y, torque))
    return effects.massive and twist.x == 0.0 and twist.y == 0.0 and twist.spin == 0.0


def _middle_force(effects: Effects, contact: Contact, load: Vector) -> Vector:
    """The middle between the forces of the slowest motions along the loads and against them.

    Both belong to the convex set of forces under which friction holds a contact at rest.
    """
    friction, size = scale_effects(effects, 1.0, 0.0), sqrt(load.x * load.x + load.y * load.y)
    x, y = 1.0, 0.0
    if size > 0.0:
        x, y = load.x / size, load.y / size
    one = _psi_of_motion(
        friction,
        contact,
        x,
        y,
        guess=guess_spin(friction, contact, x, y),
        point=NO_POINT,
        tolerance=0.0,
    )
    other = _psi_of_motion(
        friction,
        contact,
        x=-x,
        y=-y,
        guess=guess_spin(friction, contact, -x, -y),
        point=NO_POINT,
        tolerance=0.0,
    )
    return Vector((one.f_x + other.f_x) / 2.0, (one.f_y + other.f_y) / 2.0, 0.0)


def _with_foot_at_contact(
    effects: Effects, contact: Contact, total: Resistance, x: float, y: float
) -> Resistance:
    """`Resistance` with the friction of a support point at the contact, if that is the one at rest.

    The point moves by (x, y), however slow that is relative to the rotation, and has no torque about the
    contact.
    """
    foot = foot_position(effects, total.point)
    if not is_at_contact(contact, foot.x, foot.y):
        return total
    speed = sqrt(x * x + y * y)
    u_x, u_y, part = x / speed, y / speed, total.limit / speed
    return Resistance(
        f_x=total.f_x + total.limit * u_x,
        f_y=total.f_y + total.limit * u_y,
        torque=total.torque,
        xx=total.xx + part * u_y * u_y,
        xy=total.xy - part * u_x * u_y,
        yy=total.yy + part * u_x * u_x,
        xs=total.xs,
        ys=total.ys,
        ss=total.ss,
        limit=0.0,
        point=NO_POINT,
        terms=total.terms + total.limit,
    )


def psi(
    effects: Effects, contact: Contact, x: float, y: float,
    guess: float, point: int, tolerance: float,
) -> Psi:  # fmt: skip
    """Psi at a motion (x, y) of the contact, from a guess of the rotation.

    For a long rod the unknown is the origin's motion, which is small, and the rotation follows from it; for
    a short rod it is the rotation. If `point` is the number of a support point, its line to the contact is
    taken to be exactly perpendicular to the motion. For other points this holds to rounding or, without
    `point`, to within `tolerance` relative to the motion. If all rotations of an interval are solutions,
    that of `rotation_on_line` is chosen.
    """
    if is_held(contact) and (x != 0.0 or y != 0.0 or contact.spin != 0.0):
        return held_potential(effects, contact, x, y)
    if x == 0.0 and y == 0.0:
        return _psi_at_rest(effects, contact)
    return _psi_of_motion(effects, contact, x, y, guess, point, tolerance)


def _psi_of_motion(
    effects: Effects, contact: Contact, x: float, y: float,
    guess: float, point: int, tolerance: float,
) -> Psi:  # fmt: skip
    """Psi at a motion of the contact that is not zero; arguments as in `psi`."""
    on_line = rotation_on_line(effects, contact, x, y, guess)
    if on_line.converged:
        return on_line
    along, speed = x * contact.a_x + y * contact.a_y, sqrt(x * x + y * y)
    blurred = ALIGNED if point >= 0 else tolerance
    if point >= 0:
        spin = pivot_spin(effects, contact, x, y, point)
        pivot = pivot_psi(effects, contact, x, y, point, spin, INFINITY)
        if pivot.converged:
            return pivot
    rough = rough_mass(effects, speed, contact.x, contact.y)
    start, rest = 0.0, along
    if 2.0 * rough.mass * contact.reach * contact.reach > rough.inertia:
        start, rest = -along / contact.reach, 0.0
    p_x, p_y = x - along * contact.a_x, y - along * contact.a_y
    q, low, high, last = guess - start, -INFINITY, INFINITY, INFINITY
    spin, v_x, v_y = start, x, y
    total = constant_wrench(0.0, 0.0, 0.0)
    for _ in range(ROTATIONS):
        spin, carried = start + q, rest + contact.reach * q
        v_x, v_y = p_x + carried * contact.a_x, p_y + carried * contact.a_y
        blur = ROUNDING * (speed + contact.reach * fabs(spin))
        total = resistance_about(effects, contact, x=v_x, y=v_y, spin=spin, blur=blur)
        if total.limit > 0.0:
            total = _with_foot_at_contact(effects, contact, total, x, y)
        torque = total.torque
        if total.limit > 0.0:
            hold = total.limit * speed / fabs(spin)
            if fabs(torque) <= hold * (1.0 + SHARE):
                spin = pivot_spin(effects, contact, x, y, total.point)
                return pivot_psi(effects, contact, x, y, total.point, spin, blurred)
            torque -= copysign(hold, torque)
        step = -torque / total.ss if total.ss > 0.0 else copysign(INFINITY, -torque)
        scale = (fabs(v_x) + fabs(v_y) + fabs(spin)) / (1.0 + contact.reach)
        size = fabs(step) / scale if torque != 0.0 else 0.0
        if is_last(size, last):
            step = step if torque != 0.0 else 0.0
            root = potential_at(total, contact, v_x, v_y, spin, step, x, y, fabs(q), True)
            root = refine_psi(effects, contact, x, y, root, blurred)
            if root.converged:
                return root
            step, size, last = copysign(GROWTH * BARELY * scale, -torque), 0.0, INFINITY
        if torque > 0.0:
            high = q
        else:
            low = q
        target = q + step
        if not (low < target < high) or size > last / 2.0:
            if high - low <= ROUNDING * scale:
                root = potential_at(
                    total, contact, v_x, v_y, spin, step=0.0, x=x, y=y, size=fabs(q), converged=True
                )
                return refine_psi(effects, contact, x, y, root, blurred)
            last, target = INFINITY, _next_trial(effects, contact, x, y, low, high, start, q, scale)
        elif not fabs(step) < GROWTH * (fabs(q) + scale):
            last, target = INFINITY, q + copysign(GROWTH * (fabs(q) + scale), step)
        else:
            last = size
        q = target
    return potential_at(
        total, contact, v_x, v_y, spin, step=0.0, x=x, y=y, size=fabs(q), converged=False
    )


def _next_trial(
    effects: Effects, contact: Contact, x: float, y: float,
    low: float, high: float, start: float, q: float, scale: float,
) -> float:  # fmt: skip
    """The next trial if Newton's method fails: beyond an open end of the bracket, or within it."""
    if low == -INFINITY:
        return q - GROWTH * (fabs(q) + scale)
    if high == INFINITY:
        return q + GROWTH * (fabs(q) + scale)
    return _cut_bracket(effects, contact, x, y, low, high, start)


def _cut_bracket(
    effects: Effects, contact: Contact, x: float, y: float, low: float, high: float, start: float
) -> float:
    """Where to cut a bracket: at the rotation about a point that is nearest its middle, or at the middle.

    The torque is steepest at rotations about a point. Rotations are relative to `start`.
    """
    middle, nearest = low + (high - low) / 2.0, (high - low) / 2.0
    cut = middle
    for i in range(effects.feet):
        foot = foot_position(effects, i)
        r_x, r_y = foot.x - contact.x, foot.y - contact.y
        square = r_x * r_x + r_y * r_y
        if not is_at_contact(contact, foot.x, foot.y):
            turn = (x * r_y - y * r_x) / square - start
            if low < turn < high and fabs(turn - middle) < nearest:
                cut, nearest = turn, fabs(turn - middle)
    return cut
