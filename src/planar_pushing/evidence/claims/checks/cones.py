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
    """The power f . v_s >= 0, and |theta_s - phi| < 90 degrees.

    For a unit force and a unit speed of the center, $bold(f) dot bold(v)_s = 1 + k h$, an identity, and
    $k$ and $h$ have the same sign. On boxes that cover $[0, 1]$, $1 + k h$ is at least 1, and duality
    extends this to $k > 1$. The cosine of the angle between force and velocity is therefore positive,
    for every $l$ and $psi$.
    """
    floor = positive(lambda a, b: lemmas.least_work(a, b) - rational(above))
    return together(floor, lemmas.work(), lemmas.positive_work())


@proof
def motion_turns_with_force(above: float) -> Evidence:
    """theta_s increases with phi.

    For a unit speed of the center, $abs(bold(v)_s)^2 dif theta_s / dif phi = 1 + k h + l^2 cos^2(psi -
    phi) / H'$, an identity. On boxes that cover $[0, 1]$, $1 + k h$ is at least 1 and the derivative
    $H'$ of the moment arm is positive; duality extends both to $k > 1$. Therefore $theta_s$ increases
    with $phi$, for every $l$ and $psi$.
    """
    floor = positive(lambda a, b: lemmas.least_work(a, b) - rational(above))
    return together(floor, lemmas.rising_arm(), lemmas.turning())


@proof
def acceleration_turns_with_force() -> Evidence:
    """The angle of a_s increases with phi, and f . a_s > 0.

    Under inertia alone the spin ratio is $k = h R / rho^2$, by Eq. (10). Let $theta$ be the angle of
    $bold(a)_s$. For a unit force on a unit mass, $abs(bold(a)_s)^2 dif theta / dif phi = 1 + (l /
    rho)^2$ and $bold(f) dot bold(a)_s = 1 + (h / rho)^2$. Both are identities, and both values are at
    least 1, for every $l$, $psi$, and $rho$.
    """
    return lemmas.inertial_turning()


@proof
def left_force_pushes() -> Evidence:
    """The normal velocity is positive if the line of force passes the center on the left; here b is -k.

    A force into the slider that passes the center on the left has $h < 0$, and hence $k < 0$, a
    clockwise rotation: $t / k$ is at least $1 / 2$ on boxes that cover $[0, 1]$, and $t$ increases for
    $k > 1$. The normal velocity of the contact is $sin phi - k l cos psi$ per unit speed of the center.
    Its first term is not negative and its second term is positive, for every $l > 0$ and $psi < 90°$.
    """
    normal = ids.replaced(ids.MOTION[1], k=-ids.b)
    found = {"no negative term": all(term > 0 for term in normal.coeffs())}
    return together(facts(found), lemmas.same_sense())


def _lag() -> Evidence:
    """Identity: for motions u and w with the same normal component b, u x w = b (u_x - w_x)."""
    crossed = ids.cross((ids.a, ids.b), (ids.t, ids.b)) - ids.b * (ids.a - ids.t)
    return identity({"u x w": crossed})


@proof
def sticks_inside_slips_outside() -> Evidence:
    """Sec. 3.2: an approaching pusher sticks inside the cone and slips outside it.

    With one effect the direction of the motion increases with the force angle and stays within 90
    degrees of it, so that the friction cone maps one-to-one onto the motion cone. Let the pusher
    approach with the motion $bold(w)$, $w_y > 0$; the contact then cannot separate. It sticks, under
    exactly one force, if and only if $bold(w)$ is in the motion cone. A slip to the right requires the
    force of the left edge and a motion $bold(u)$ on the left edge of the motion cone that has the
    normal component of $bold(w)$ and $u_x > w_x$. Since $bold(u) times bold(w) = w_y (u_x - w_x)$, an
    identity, this is possible if and only if $bold(w)$ lies beyond the left edge; if the left edge has
    no positive normal component, it is at 180 degrees or more, and no $bold(w)$ lies beyond it. The
    same argument applies to the right edge. Therefore the contact sticks inside the cone, slips outside
    it under the force of the nearer edge, and no other mode is consistent, for every $l$ and $psi$,
    every coefficient of friction, and infinite friction by definition 1.
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
    """A rotation of the force by 180 degrees rotates the motion by 180 degrees.

    If the force is reversed, its moment arm and $k$ change sign, and so does the motion of the contact,
    by identities for every $l$ and $psi$. The forces along the fence, at 0 and at 180 degrees,
    therefore have opposite motions, and these are the edges of the velocity cone.
    """
    sums = {
        f"component {i} of the motion": part + ids.replaced(part, x=-ids.x, y=-ids.y, k=-ids.k)
        for i, part in enumerate(ids.MOTION)
    }
    sums["the arm"] = ids.ARM + ids.replaced(ids.ARM, x=-ids.x, y=-ids.y)
    return identity(sums)


@proof
def every_rod_pulls_and_slips() -> Evidence:
    """Normal motions under the forces at 0 and at 180 degrees.

    Under a force along the fence the moment arm $h$ is $l sin psi$ at 0 degrees and $-l sin psi$ at 180
    degrees, and $bold(n) dot bold(v)_s = -k l cos psi$ per unit speed of the center, all by identities.
    Since $t / k$ is at least $1 / 2$ on boxes that cover $[0, 1]$ and $t$ increases for $k > 1$, $k$
    has the sign of $h$. Therefore, for $0 < psi < 90°$ and $l > 0$, the right edge of the velocity cone
    lies below the fence, where the pusher retreats, and the left edge lies above it, where the pusher
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

    With $l = 0$ the contact is the ring's center. Its motion has the direction of the force, an
    identity, so that the two cones are equal.
    """
    motion = tuple(ids.replaced(each, l=0 * ids.ONE) for each in ids.MOTION)
    return identity({"v_s x f": ids.cross((motion[0], motion[1]), (ids.x, ids.y))})


def _edges(effects: Effects, rod_length: float, mu: float, side: int) -> list[arb]:
    """Angles of the motions at an edge under each effect alone; those under both lie between them."""
    slider, force = Slider.of(rod_length), edge(mu, side)
    return [motion_angle(slider, force, share) for share in effects.shares]


def _beyond_left_edge(rod_length: float, pusher_angle: float, effects: str) -> Evidence:
    """Evidence that a pusher angle is beyond every sticking motion, and that the left edge approaches."""
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

    The direction of the pusher lies beyond the left edge of the cone of each effect, enclosed by a
    change of sign; under both effects every motion lies between the two pure ones, at any magnitude.
    Therefore the contact sticks under no force into the slider, and it cannot separate, since the
    pusher approaches. Under the force at 180 degrees, on the left edge, the normal motion takes every
    positive value as the force grows. The motion that has the normal component of the pusher lags
    behind the pusher, so that slip to the right is consistent. The direction of the pusher is also to
    the left of the right edge, so that slip to the left is not consistent.
    """
    return _beyond_left_edge(rod_length, pusher_angle, effects)


@proof
def no_solution_beyond_edge(rod_length: float, pusher_angle: float, effects: str) -> Evidence:
    """From this pusher angle to below 180 degrees no mode is consistent, definition 2.

    The direction of the pusher lies beyond the left edge of the cone of each effect, enclosed by a
    change of sign, so that the contact sticks under no force into the slider, at any magnitude. It
    cannot separate, since the pusher approaches. A slip would require a force along the fence, which
    definition 2 does not transmit.
    """
    return _beyond_left_edge(rod_length, pusher_angle, effects)


@proof
def both_effects_lie_between() -> Evidence:
    """The exact cone of the ring with both effects is the hull of the two pure cones.

    At a given force angle the balance of torque of both effects is a positive combination of $t - h f$
    and $(rho / R)^2 k - h$, which change sign from negative to positive at the spin ratios of friction
    and of inertia. Its root lies between these two and takes every value between them as the magnitude
    of the acceleration grows from zero. For any $k$, $bold(u) times dif bold(u) / dif k = -l cos(psi -
    phi)$, an identity; the direction of the motion is therefore monotone in $k$. Hence at each force
    angle it lies between the two pure motions. Both of these rotate with the force, so that the edges
    of the pure cones bound the cone of both effects.
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
    """Between two coefficients the velocity cone extends below the fence, the acceleration cone does not.

    The right edge of a motion cone decreases as the coefficient of friction increases, because the
    direction of motion increases with the force angle. At the smallest coefficient the velocity cone
    already extends below the fence, and at the largest the acceleration cone still does not, by
    enclosures of both edges. These two coefficients therefore decide for every coefficient between
    them.
    """
    (velocity,) = _edges(Effects.FRICTION, rod_length, above, 1)
    (acceleration,) = _edges(Effects.INERTIA, rod_length, below, 1)
    exact = facts({"no pulling by inertia": bool(acceleration >= 0)})
    reach = inequality(-velocity, value=velocity, unit="degree")
    return together(reach, exact, lemmas.turning(), lemmas.inertial_turning())


@proof
def open_cone_inside_closed() -> Evidence:
    """The two laws have one friction cone, closed and open, and the open one does not slip.

    The forces of definition 2, at angles in the open interval from 0 to 180 degrees, are among those of
    definition 1, in the closed interval. If no force of the closed interval sustains a motion, no force
    of the open interval sustains it either, for every slider and every effect.
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
