"""Slips of a slider with friction and inertia, whose motion under a force turns as it grows.

Under a force on an edge the spin ratio runs over the open segment between its friction and its inertia
value. There the centre's speed is ``v(k) = W (h f - t) / (m (rho^2 k - h))`` and the contact's normal
motion ``v (A - B k)``, which need not be monotone (Painleve): several motions may have one normal part.
They are the roots of::

    Phi(k) = W (h f - t) (A - B k) - m (rho^2 k - h) n.u

The segment is cut into cells until each holds no root, or Phi is monotone there. Bounds of Phi and of
its slope come from the ends of a cell alone: f falls, t rises, and t' has one sense on each side of k = 1.
"""

from __future__ import annotations

from math import copysign, inf, sqrt
from typing import Any, NamedTuple

from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.compiled import compiled, owning
from planar_pushing.mechanics.effects.base import response, spin_ratio_alone
from planar_pushing.mechanics.numerics.root import EPSILON, EQUATIONS, root
from planar_pushing.mechanics.plane import moment_arm
from planar_pushing.mechanics.reduced import isotropic
from planar_pushing.mechanics.reduced.isotropic import without_noise

#: Slips under one edge that are written down; a segment has had four at most.
SLIPS = 8
#: A normal motion is not smaller than this, so that its sign is not rounded away.
LEAST = 1e-200


class Edge(NamedTuple):
    """A line of force: h >= 0, and A and B of the contact's normal motion ``v (A - B k)``, k >= 0."""

    arm: float
    normal: float
    lever: float


class Node(NamedTuple):
    """A spin ratio with the torques about the contact that friction and inertia leave at unit speed.

    `bend` is t', which is infinite on the ring.
    """

    k: float
    friction: float
    inertia: float
    bend: float


@compiled
def _node(effects, edge, k):
    force, torque, _, _, bend = response(effects[:1], 1.0, k)
    mass = effects[1].mass
    return Node(
        k,
        torque - edge.arm * force,
        mass * (effects[1].gyration * k - edge.arm),
        inf if k == 1.0 else bend,
    )


@compiled
def _advance(edge, k):
    return without_noise(edge.normal, edge.lever * k)


@compiled
def _phi(edge, node, normal):
    return -node.friction * _advance(edge, node.k) - node.inertia * normal


@compiled
def _product(a, b, c, d):
    """Bounds of the product of numbers from a to b and from c to d; 0 times infinity is 0."""
    low, high = inf, -inf
    for x in (a, b):
        for y in (c, d):
            product = 0.0 if x == 0.0 or y == 0.0 else x * y
            low, high = min(low, product), max(high, product)
    return low, high


@compiled
def _holds_no_root(edge, normal, one, other):
    """Whether bounds of Phi over a cell exclude zero."""
    low, high = _product(
        -one.friction, -other.friction, _advance(edge, one.k), _advance(edge, other.k)
    )
    first, second = -one.inertia * normal, -other.inertia * normal
    return low + min(first, second) > 0.0 or high + max(first, second) < 0.0


@compiled
def _sense(edge, normal, stiffness, one, other):
    """1 or -1 where Phi rises or falls over a whole cell, 0 where bounds of its slope leave it open."""
    steep, steeper = min(one.bend, other.bend), max(one.bend, other.bend)
    steeper = inf if one.k < 1.0 < other.k else steeper
    steep, steeper = _product(steep, steeper, 1.0 + edge.arm * one.k, 1.0 + edge.arm * other.k)
    low, high = _product(-steeper, -steep, _advance(edge, one.k), _advance(edge, other.k))
    first, second = edge.lever * one.friction, edge.lever * other.friction
    low += min(first, second) - stiffness * normal
    high += max(first, second) - stiffness * normal
    return 1.0 if low > 0.0 else -1.0 if high < 0.0 else 0.0


class RisingPhi(NamedTuple):
    """Phi over the spin ratio, in the sense in which it rises."""

    effects: tuple[Any, ...]
    edge: Edge
    normal: float
    sense: float


@compiled
def _rising_phi(of, k):
    effects, edge, normal, sense = of
    node = _node(effects, edge, k)
    advance = edge.normal - edge.lever * k
    slope = -node.bend * (1.0 + edge.arm * k) * advance + edge.lever * node.friction
    slope -= effects[1].mass * effects[1].gyration * normal
    return sense * (-node.friction * advance - node.inertia * normal), sense * slope


EQUATIONS[RisingPhi] = _rising_phi


@compiled
def _cut(low, high):
    """Where a cell is cut: on the ring, else in the middle, of its sizes where it spans sizes."""
    if low < 1.0 < high:
        return 1.0
    return sqrt(low) * sqrt(high) if high > 4.0 * low else low + (high - low) / 2


@owning
def _roots(effects, edge, normal, low, high, roots):
    """Write down the spin ratios between low and high at which Phi is zero; how many there are.

    A root at an end is the limit of rest, or of a motion without bound, and no motion: Phi counts as
    positive where it is zero inside, and as without a sign at an end.
    """
    cells = [(low, high)]
    stiffness = effects[1].mass * effects[1].gyration
    count = 0
    while len(cells) > 0:
        one, other = cells.pop()
        if _holds_no_root(edge, normal, one, other):
            continue
        sense = _sense(edge, normal, stiffness, one, other)
        middle = _cut(one.k, other.k)
        narrow = other.k - one.k <= 4.0 * EPSILON * other.k or not one.k < middle < other.k
        if sense == 0.0 and not narrow:
            node = _node(effects, edge, middle)
            cells.append((node, other))
            cells.append((one, node))
            continue
        first, last = _phi(edge, one, normal), _phi(edge, other, normal)
        end = (first == 0.0 and one.k == low.k) or (last == 0.0 and other.k == high.k)
        if end or (first >= 0.0) == (last >= 0.0) or count == SLIPS:
            continue
        rising = RisingPhi(effects, edge, normal, 1.0 if last >= 0.0 else -1.0)
        roots[count] = root(rising, one.k, other.k, middle)[0]
        count += 1
    return count


@compiled
def _speed(effects, edge, normal, k):
    """Centre speed of the motion with a normal part, from whichever equation rounding hurts less."""
    node, advance = _node(effects, edge, k), _advance(edge, k)
    size = abs(edge.normal) + abs(edge.lever * k)
    force = response(effects[:1], 1.0, k)[0]
    pull = edge.arm * max(force * abs(node.inertia), effects[1].mass * abs(node.friction))
    if abs(advance) * pull >= size * abs(node.friction * node.inertia):
        return normal / advance
    return -node.friction / node.inertia


@compiled
def slips(effects, own, towards, normal, start, found):
    """Motions under a force towards an edge, slow ones first; parameters as in `base.slips`."""
    arm = moment_arm(own, towards)
    edge = Edge(abs(arm), towards.y, copysign(own.length, arm) * own.x)
    slow = spin_ratio_alone(effects[0], edge.arm)
    fast = spin_ratio_alone(effects[1], edge.arm)
    if abs(fast - slow) <= RESOLUTION * max(slow, fast):
        return isotropic.steady_slips(effects, own, towards, normal, start, found)
    low, high = _ends(effects, edge, slow, fast)
    roots = found[:, 2]  # where their rotations will be
    if normal != 0.0:
        least = copysign(max(abs(normal), LEAST), normal)
        count = _roots(effects, edge, least, low, high, roots)
    else:  # along the fence, with any speed but rest
        roots[0] = edge.normal / edge.lever if edge.lever != 0.0 else -1.0
        count = 1 if low.k * (1.0 + RESOLUTION) < roots[0] < high.k * (1.0 - RESOLUTION) else 0
    if fast < slow:
        for i in range(count // 2):
            roots[i], roots[count - 1 - i] = roots[count - 1 - i], roots[i]
    for i in range(count):
        k = roots[i]
        speed = _speed(effects, edge, normal, k)
        isotropic.write_slip(effects, towards, speed, copysign(k, arm), found[i])
    return count


@compiled
def _ends(effects, edge, slow, fast):
    """Nodes at the ends of the segment, the torque that vanishes at each being zero, the lower first."""
    rest, flight = _node(effects, edge, slow), _node(effects, edge, fast)
    rest = Node(slow, 0.0, rest.inertia, rest.bend)
    flight = Node(fast, flight.friction, 0.0, flight.bend)
    return (rest, flight) if slow < fast else (flight, rest)
