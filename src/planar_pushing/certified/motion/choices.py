"""Consistent contact modes of a slider with friction alone, and the mode that a policy selects."""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb, fmpq

from planar_pushing.certified import radians
from planar_pushing.certified.balls import Undecided, rational, sign
from planar_pushing.certified.contact.modes import Mode
from planar_pushing.certified.inverse import spin_of_arm
from planar_pushing.certified.motion.instants import File, Vector

#: The mode that a policy prefers; after it, sticking precedes slip, and separation comes last.
FIRST = {
    "keep-contact": Mode.STICK,
    "separate": Mode.SEPARATE,
    "stick": Mode.STICK,
    "slip-right": Mode.SLIP_RIGHT,
    "slip-left": Mode.SLIP_LEFT,
}
ORDER = [Mode.STICK, Mode.SLIP_RIGHT, Mode.SLIP_LEFT, Mode.SEPARATE]


def chosen(found: Sequence[Mode], policy: str) -> Mode:
    """The mode that a policy selects.

    Raises
    ------
    Undecided
        If no mode is consistent, or the policy is not in `FIRST`.
    """
    if policy not in FIRST or not found:
        raise Undecided(f"no mode under the policy {policy} of {len(found)} modes")
    return next(mode for mode in [FIRST[policy], *ORDER] if mode in found)


def friction_edges(file: File) -> tuple[arb, arb]:
    """Angles of the right and the left edge of a friction cone at which the contact slips."""
    contact = file["contact"]
    if contact["law"] == "coulomb":
        mu = arb(rational(contact["friction_coefficient"]))
    elif contact["law"] == "infinite_friction" and contact["at_zero_normal"] == "free":
        mu = arb.pos_inf()
    else:
        raise Undecided("certified motion requires a contact law that allows slip")
    return radians.friction_edge(mu, 1), radians.friction_edge(mu, -1)


def consistent(edges: tuple[Vector, Vector], pusher: Vector) -> list[Mode]:
    """Consistent modes of a slider on a moving fence, from the edges of its motion cone.

    Parameters
    ----------
    edges : tuple
        Motions of the contact under the forces at the right and at the left edge of the friction cone.
    pusher : tuple of arb
        Velocity of the fence.
    """
    right, left = edges
    past, short, rise = _cross(right, pusher), _cross(left, pusher), sign(pusher[1])
    found = [] if rise > 0 else [Mode.SEPARATE]
    if past > 0 and short < 0:
        found.append(Mode.STICK)
    if rise and sign(left[1]) == rise and sign(short) == rise:
        found.append(Mode.SLIP_RIGHT)
    if rise and sign(right[1]) == rise and sign(past) == -rise:
        found.append(Mode.SLIP_LEFT)
    if not (sign(past) and sign(short)):
        raise Undecided("the fence moves along an edge of the motion cone")
    return found


def _cross(a: Vector, b: Vector) -> arb:
    return a[0] * b[1] - a[1] * b[0]


def ring_modes(file: File, length: fmpq, angle: arb, pusher: Vector) -> list[Mode]:
    """Consistent modes of a slider on a ring, with R = 1, at a rod angle in radians."""
    right, left = (_edge(length, angle, each) for each in friction_edges(file))
    return consistent((right, left), pusher)


def _edge(length: fmpq, angle: arb, force: arb) -> Vector:
    """Motion of the contact under a force at an angle."""
    pull = length * spin_of_arm(length * (angle - force).sin(), arb(1), arb(0))
    return force.cos() + pull * angle.sin(), force.sin() - pull * angle.cos()
