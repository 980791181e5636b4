"""Motion cones of the ring, Secs. 3.1, 3.2 and 4: pushing, pulling, and slip with infinite friction."""

from __future__ import annotations

import math

from flint import arb

from planar_pushing.certified.balls import rational
from planar_pushing.certified.contact.modes import INFINITE_FREE, INFINITE_NONE
from planar_pushing.certified.line_of_force import motion_angle
from planar_pushing.certified.setting import Effects, Slider, edge
from planar_pushing.evidence.claims.proofs import identities as ids
from planar_pushing.evidence.claims.proofs import lemmas
from planar_pushing.evidence.claims.proofs.boxes import positive
from planar_pushing.evidence.claims.registry import proof
from planar_pushing.evidence.claims.verdicts import (
    Evidence,
    facts,
    identity,
    inequality,
    least,
    together,
)


@proof
def nonnegative_work(above: float) -> Evidence:
    """The work f . v_s >= 0, and |theta_s - phi| < 90 degrees.

    For a unit force and a unit speed of the center f . v_s = 1 + k h, an identity, and k and h have one
    sign: on boxes that cover [0, 1] the value 1 + k h has the lower bound 1, and duality extends this
    to k > 1. The cosine of the angle between force and velocity is therefore positive, for every l and
    psi.
    """
    floor = positive(lambda a, b: lemmas.least_work(a, b) - rational(above))
    return together(floor, lemmas.work(), lemmas.positive_work())


@proof
def motion_turns_with_force(above: float) -> Evidence:
    """theta_s rises with phi.

    |v_s|^2 d theta_s / d phi = 1 + k h + l^2 cos^2(psi - phi) / H', an identity. On boxes that cover
    [0, 1] 1 + k h is at least 1 and the slope H' of the moment arm is positive; duality extends both to
    k > 1. So theta_s rises with phi, for every l and psi.
    """
    floor = positive(lambda a, b: lemmas.least_work(a, b) - rational(above))
    return together(floor, lemmas.rising_arm(), lemmas.turning())


@proof
def acceleration_turns_with_force() -> Evidence:
    """The angle of a_s rises with phi, and f . a_s > 0.

    Under inertia alone k = h R / rho^2, by Eq. (10). With it |a_s|^2 d theta / d phi = 1 + (l / rho)^2
    and f . a_s = 1 + (h / rho)^2 for a unit force on a unit mass, both identities and both at least 1,
    for every l, psi and rho.
    """
    return lemmas.inertial_turning()


@proof
def left_force_pushes() -> Evidence:
    """The normal velocity is positive where the line of force passes on the left; here b is -k.

    A force into the slider that passes the center on the left has h < 0, and so k < 0: t / k is at
    least 1/2 on boxes of [0, 1], and t rises beyond. The normal velocity of the contact is sin(phi) - k
    l cos(psi), the sum of a term that is not negative and one that is positive, for every l > 0 and psi
    < 90 degrees.
    """
    normal = ids.replaced(ids.MOTION[1], k=-ids.b)
    found = {"no negative term": all(term > 0 for term in normal.coeffs())}
    return together(facts(found), lemmas.same_sense())


def _lag() -> Evidence:
    """Identity: for motions u and w with one normal part b, u x w = b (u_x - w_x)."""
    crossed = ids.cross((ids.a, ids.b), (ids.t, ids.b)) - ids.b * (ids.a - ids.t)
    return identity({"u x w": crossed})


@proof
def sticks_inside_slips_outside() -> Evidence:
    """Sec. 3.2: an approaching pusher sticks inside of the cone and slips outside of it.

    With one effect the direction of motion rises with the force angle and stays within 90 degrees of
    it, so that the friction cone maps one to one to the motion cone. Let the pusher approach, w_y > 0:
    separation is impossible. If w is in the cone, one force sticks. If u, on the left edge, has the
    normal part of w, then u x w = w_y (u_x - w_x), an identity: under this force the contact slips to
    the right, as the law requires, exactly if w is beyond the left edge; likewise on the right. So the
    contact sticks inside of the cone, slips beyond an edge under the force of that edge, and no other
    mode is consistent, for every l and psi, every coefficient of friction, and infinite friction by
    definition 1.
    """
    return together(
        lemmas.positive_work(),
        lemmas.rising_arm(),
        lemmas.turning(),
        lemmas.inertial_turning(),
        _lag(),
    )


@proof
def infinite_cone_spans() -> Evidence:
    """Turning the force by 180 degrees turns the motion by 180 degrees.

    The moment arm and the motion of the contact change their signs with the force, and k with them, by
    identities for every l and psi. So the forces along the fence, at 0 and at 180 degrees, have
    opposite motions.
    """
    sums = {
        f"part {i} of the motion": part + ids.replaced(part, x=-ids.x, y=-ids.y, k=-ids.k)
        for i, part in enumerate(ids.MOTION)
    }
    sums["the arm"] = ids.ARM + ids.replaced(ids.ARM, x=-ids.x, y=-ids.y)
    return identity(sums)


@proof
def every_rod_pulls_and_slips() -> Evidence:
    """Normal motions under the forces at 0 and at 180 degrees.

    Under a force along the fence h = l sin(psi) at 0 degrees and -l sin(psi) at 180 degrees, and n .
    v_s = -k l cos(psi), both identities. Since t / k is at least 1/2 on boxes of [0, 1] and t rises
    beyond, k has the sign of h: for 0 < psi < 90 degrees and l > 0 the right edge of the velocity cone
    is below the fence, where the pusher retreats, and the left edge is above it, where the pusher
    approaches.
    """
    found = {}
    for way in (1, -1):
        arm, normal = (
            ids.replaced(each, x=way * ids.ONE, y=0 * ids.ONE) for each in (ids.ARM, ids.MOTION[1])
        )
        found[f"the arm, {way}"] = arm - way * ids.l * ids.q
        found[f"n . v_s, {way}"] = normal + ids.k * ids.l * ids.p
    return together(identity(found), lemmas.same_sense())


@proof
def aligned_without_rod() -> Evidence:
    """With l = 0 the motion is along the force.

    With l = 0 the contact is the ring's center, which moves along the force. Motion and force have one
    direction, an identity, and the two cones are the same.
    """
    motion = tuple(ids.replaced(each, l=0 * ids.ONE) for each in ids.MOTION)
    return identity({"v_s x f": ids.cross((motion[0], motion[1]), (ids.x, ids.y))})


def _edges(effects: Effects, rod_length: float, mu: float, side: int) -> list[arb]:
    """Angles of the motions at an edge under each effect alone; those under both lie between."""
    slider, force = Slider.of(rod_length), edge(mu, side)
    return [motion_angle(slider, force, share) for share in effects.shares]


def _beyond_left_edge(rod_length: float, pusher_angle: float, effects: str) -> Evidence:
    """Evidence that a pusher angle is beyond every sticking motion, and the left edge approaches."""
    lefts = _edges(Effects(effects), rod_length, math.inf, -1)
    rights = _edges(Effects(effects), rod_length, math.inf, 1)
    pusher = rational(pusher_angle)
    margin = least(pusher - left for left in lefts)
    beyond = inequality(margin, value=pusher - margin, unit="degree", claimed=pusher_angle)
    inside = inequality(least([*lefts, *(180 - left for left in lefts)]), unit="degree")
    below = inequality(least(pusher - right for right in rights), unit="degree")
    return together(beyond, inside, below, both_effects_lie_between())


@proof
def slips_beyond_edge(rod_length: float, pusher_angle: float, effects: str) -> Evidence:
    """From this pusher angle to below 180 degrees slip to the right is the only mode, definition 1.

    The pusher's direction is beyond the left edge of the cone of each effect, which a change of sign
    encloses; a motion under both effects lies between the two pure ones at any magnitude. So no force
    into the slider sticks, and the contact cannot break since the pusher approaches. Under the force at
    180 degrees, the left edge, the normal motion takes every positive value as the force grows; the
    motion with the pusher's normal part lags behind the pusher, and the slip to the right is
    consistent. The right edge is below the pusher's direction too, so that a slip to the left is not.
    """
    return _beyond_left_edge(rod_length, pusher_angle, effects)


@proof
def no_solution_beyond_edge(rod_length: float, pusher_angle: float, effects: str) -> Evidence:
    """From this pusher angle to below 180 degrees nothing is consistent under definition 2.

    The pusher's direction is beyond the left edge of the cone of each effect, which a change of sign
    encloses, so that no force into the slider sticks, at any magnitude. The contact cannot break since
    the pusher approaches, and there is no force along the fence under which it could slip.
    """
    return _beyond_left_edge(rod_length, pusher_angle, effects)


@proof
def both_effects_lie_between() -> Evidence:
    """The exact cone of the ring with both effects is the hull of the two pure cones.

    At one force angle the balance of torque of both effects is a positive combination of t - h f and
    (rho / R)^2 k - h, which rise through zero at the spin ratios of friction and of inertia: its root
    lies between them, and takes every value between as the magnitude grows from zero. The cross product
    of u and du/dk is -l cos(psi - phi), an identity, whatever k: the direction of motion is monotone in
    k. So at each force angle it lies between the two pure ones, which rise with the force angle, and
    the edges of the pure cones bound it.
    """
    rate = ids.l * ids.q, -ids.l * ids.p  # of the motion with k
    turning = ids.cross(ids.MOTION, rate) + ids.l * ids.LEAN
    return together(
        identity({"u x du/dk": ids.normal(turning)}),
        lemmas.rising_arm(),
        lemmas.turning(),
        lemmas.inertial_turning(),
    )


@proof
def slow_pulls_fast_does_not(rod_length: float, above: float, below: float) -> Evidence:
    """Between two coefficients the velocity cone reaches below the fence, the acceleration cone not.

    The right edge of a motion cone falls as the coefficient rises, since the direction of motion rises
    with the force angle. At the smallest coefficient the velocity cone already reaches below the fence,
    and at the largest the acceleration cone does not yet, by enclosures of both edges: the ends decide
    for every coefficient between.
    """
    (velocity,) = _edges(Effects.FRICTION, rod_length, above, 1)
    (acceleration,) = _edges(Effects.INERTIA, rod_length, below, 1)
    exact = facts({"no pulling by inertia": bool(acceleration >= 0)})
    reach = inequality(-velocity, value=velocity, unit="degree")
    return together(reach, exact, lemmas.turning(), lemmas.inertial_turning())


@proof
def open_cone_inside_closed() -> Evidence:
    """The two laws have one friction cone, closed and open, and the open one does not slip.

    The forces of definition 2, at angles in the open interval (0, 180) degrees, are among those of
    definition 1, in the closed interval. A motion for which no force of the closed interval balances
    has none in the open one, for every slider and every effect.
    """
    first, second = INFINITE_FREE, INFINITE_NONE
    return facts(
        {
            "one cone": first.friction_coefficient == second.friction_coefficient,
            "closed by definition 1": first.closed and not first.adhesive,
            "open by definition 2": not second.closed and not second.adhesive,
            "no slip by definition 2": not second.slips,
        }
    )
