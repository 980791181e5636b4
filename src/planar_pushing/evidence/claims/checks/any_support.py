"""Secs. 3.1 and 3.2 for any support: what is proved of every pressure, and where a statement ends."""

from __future__ import annotations

from flint import arb, fmpq

from planar_pushing.certified import ring
from planar_pushing.certified.balls import in_degrees, rational
from planar_pushing.evidence.claims.proofs import any_support
from planar_pushing.evidence.claims.proofs.registry import check
from planar_pushing.evidence.claims.proofs.verdicts import (
    Evidence,
    facts,
    inequality,
    near,
    together,
)

#: Share of a foot of a tripod on the unit circle, its distance from the others, and of the force of these
#: while the slider turns about it: size, along the tangent, and torque about the foot.
_FOOT = fmpq(1, 3)


def _tripod() -> tuple[arb, arb]:
    """Force of the two feet that slide about the third, along its tangent, and their torque about it."""
    apart = arb(3).sqrt()
    return 2 * _FOOT * (fmpq(3, 2) / apart), 2 * _FOOT * apart


@check
def power_of_any_support() -> Evidence:
    """The power f . v_s is the sum of p |v|, so the motion lies within 90 degrees of the force."""
    return any_support.power()


@check
def motion_never_turns_back() -> Evidence:
    """The motions of two forces on the limit curve turn as the forces do, or not at all."""
    return any_support.monotone()


@check
def cone_spans_half_turn_on_any_support() -> Evidence:
    """The motions of the forces at 0 and at 180 degrees are opposite."""
    return any_support.reversal()


@check
def pulls_where_it_slips() -> Evidence:
    """A cone from e to e + 180 degrees reaches below the fence, and leaves out pushes, unless e = 0."""
    return any_support.reversal()


@check
def aligned_where_symmetric() -> Evidence:
    """Mirror image and reversal of the force (1, 0) are one force: n . v_s = -n . v_s."""
    return together(any_support.mirror(), any_support.reversal())


@check
def corner_of_a_line(distance: float, half_length: float, span: float, within: float) -> Evidence:
    """A line of pressure at a distance, level with the contact, across the fence: one force, many motions.

    Every center on the line beyond its ends makes all points slide along the fence, so the force is W along
    the fence through the middle. The motion of the contact about an end is (half_length, -distance).
    """
    length, far = rational(half_length), rational(distance)
    edge = in_degrees(arb.atan2(arb(far), arb(length)))
    method = "centres on the line beyond its ends, exactly; the angle of the contact's motion about an end"
    spins = {
        f"centre at {turn}": all(turn * (turn * size * length - y) > 0 for y in (-length, length))
        for turn, size in ((1, 2), (1, 100), (-1, 2), (-1, 100))
    }
    return together(near(180 + 2 * edge, span, within, method, "degree"), facts(spins, method))


@check
def tripod_pivots(nearest: float, farthest: float, within: float) -> Evidence:
    """Offsets of a push across a foot's radius that turn a tripod about that foot.

    The push at the offset d has the torque F (1 + d) about the foot, which the other feet take; the foot
    takes the rest of F, at most its share.
    """
    force, torque = _tripod()
    ends = [torque / (force + side * _FOOT) - 1 for side in (1, -1)]
    method = "balance of torque about the foot, whose own force is its share at the ends"
    return together(near(ends[1], farthest, within, method, "a"),
                    near(ends[0], nearest, within, method, "a"))  # fmt: skip


@check
def one_pivot_for_many_forces(rod_length: float, span: float, within: float) -> Evidence:
    """Force angles that turn a tripod about the foot on the rod's line."""
    force, torque = _tripod()
    across = torque / (rational(rod_length) + 1)
    along = (_FOOT**2 - (across - force) ** 2).sqrt()
    method = "the foot's own force is its share at both ends of the interval"
    return near(2 * in_degrees((along / across).atan()), span, within, method, "degree")


@check
def foot_ahead_holds(distance: float, share: float, aside: float, beyond: float) -> Evidence:
    """A foot straight ahead of the contact is the pivot of every force along the fence.

    The others, of equal shares, stand at (aside, beyond) and (-2 aside, -beyond) from it.
    """
    own, x, y = rational(share), rational(aside), rational(beyond)
    rest, places = (1 - own) / 2, [(x, y), (-2 * x, -y)]
    sizes = [arb(x * x + y * y).sqrt() for x, y in places]
    push = rest * (sizes[0] + sizes[1]) / rational(distance)
    slides = [-y / size for (_, y), size in zip(places, sizes, strict=True)]
    aside_slides = [x / size for (x, _), size in zip(places, sizes, strict=True)]
    taken = _size(push - rest * sum(slides, arb(0)), rest * sum(aside_slides, arb(0)))
    method = (
        "share of the foot less the force that it takes; the motion about it is along the fence"
    )
    return inequality(own - taken, method, unit="W")


def _size(x: arb, y: arb) -> arb:
    return (x * x + y * y).sqrt()


@check
def center_within_bound() -> Evidence:
    """A center at c > a has c d <= a^2, so that d <= a gives c <= a^2 / d, and d > a gives c <= a."""
    return any_support.spread()


@check
def center_beyond_bound(spin_ratio: float, product: float, within: float) -> Evidence:
    """Offset times distance of the center, c d / a^2, of a ring under a force that misses it."""
    force, torque = ring.profile(1 / arb(rational(spin_ratio)))  # dual: H(k) = f(1/k) / t(1/k)
    found = force / torque / rational(spin_ratio)
    method = "offset times distance of the centre, H(k) / k, by duality"
    return together(near(found, product, within, method), inequality(found - 1, method))


@check
def integration_constant_of_rectangle(aspect: float, constant: float, within: float) -> Evidence:
    """Mean distance from the center, over the half diagonal, by the triangles over the edges."""
    long, short = arb(rational(aspect)), arb(1)
    diagonal = (long**2 + short**2).sqrt()
    mean = sum(
        one**3 * (other / one).asinh() + one * other * diagonal
        for one, other in ((long, short), (short, long))
    ) / (6 * long * short)
    return near(mean / diagonal, constant, within, "closed form of the mean distance")


@check
def integration_constant_of_annulus(hole: float, constant: float, within: float) -> Evidence:
    """Mean distance from the center over the outer radius: a disc without a hole, a ring with hole 1."""
    part = arb(rational(hole))
    mean = fmpq(2, 3) * (1 + part + part**2) / (1 + part)
    return near(mean, constant, within, "2/3 (1 + q + q^2) / (1 + q), q the hole's radius")
