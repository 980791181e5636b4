"""Motion cones of the ring, Secs. 3.1, 3.2 and 4: pushing, pulling, and slip with infinite friction."""

from __future__ import annotations

from dataclasses import replace

from pulling_by_pushing.evidence.proofs import identities as ids
from pulling_by_pushing.evidence.proofs import lemmas
from pulling_by_pushing.evidence.proofs.boxes import positive
from pulling_by_pushing.evidence.proofs.mechanics import FRICTION, INERTIA, LAWS, Mechanics, Scene
from pulling_by_pushing.evidence.proofs.registry import proof
from pulling_by_pushing.evidence.proofs.verdicts import (
    Evidence,
    facts,
    identity,
    inequality,
    smallest,
    together,
)
from pulling_by_pushing.oracle.balls import rational, sign


@proof
def nonnegative_work(above: float) -> Evidence:
    """The power f . v_s >= 0, and |theta_s - phi| < 90 degrees."""
    floor = positive(lambda a, b: lemmas.least_work(a, b) - rational(above))
    return together(floor, lemmas.work(), lemmas.positive_work())


@proof
def motion_turns_with_force(above: float) -> Evidence:
    """theta_s increases with phi."""
    floor = positive(lambda a, b: lemmas.least_work(a, b) - rational(above))
    return together(floor, lemmas.rising_arm(), lemmas.turning())


@proof
def acceleration_turns_with_force() -> Evidence:
    """The angle of a_s increases with phi, and f . a_s > 0."""
    return lemmas.inertial_turning()


@proof
def left_force_pushes() -> Evidence:
    """The normal velocity is positive if the line of force passes the center on the left; here b is -k."""
    normal = ids.substitute(ids.MOTION[1], k=-ids.b)
    terms = {"no negative term": all(term > 0 for term in normal.coeffs())}
    return together(facts(terms), lemmas.same_sense())


def _lag() -> Evidence:
    """Identity: for motions u and w with the same normal component b, u x w = b (u_x - w_x)."""
    crossed = ids.cross((ids.a, ids.b), (ids.t, ids.b)) - ids.b * (ids.a - ids.t)
    return identity({"u x w": crossed})


@proof
def sticks_inside_slips_outside() -> Evidence:
    """Sec. 3.2: an approaching pusher sticks inside the cone and slips outside it."""
    return together(
        lemmas.positive_work(),
        lemmas.rising_arm(),
        lemmas.turning(),
        lemmas.inertial_turning(),
        _lag(),
    )


@proof
def infinite_cone_spans() -> Evidence:
    """A rotation of the force by 180 degrees rotates the motion by 180 degrees."""
    sums = {
        f"component {i} of the motion": part + ids.substitute(part, x=-ids.x, y=-ids.y, k=-ids.k)
        for i, part in enumerate(ids.MOTION)
    }
    sums["the arm"] = ids.ARM + ids.substitute(ids.ARM, x=-ids.x, y=-ids.y)
    return identity(sums)


@proof
def every_rod_pulls_and_slips() -> Evidence:
    """Normal motions under the forces at 0 and at 180 degrees."""
    differences = {}
    for sense in (1, -1):
        arm, normal = (
            ids.substitute(part, x=sense * ids.ONE, y=0 * ids.ONE)
            for part in (ids.ARM, ids.MOTION[1])
        )
        differences[f"the arm, {sense}"] = arm - sense * ids.l * ids.q
        differences[f"n . v_s, {sense}"] = normal + ids.k * ids.l * ids.p
    return together(identity(differences), lemmas.same_sense())


@proof
def aligned_without_rod() -> Evidence:
    """With l = 0 the motion is along the force."""
    motion = tuple(ids.substitute(part, l=0 * ids.ONE) for part in ids.MOTION)
    return identity({"v_s x f": ids.cross((motion[0], motion[1]), (ids.x, ids.y))})


def _beyond_left_edge(
    mechanics: Mechanics, rod_length: float, pusher_angle: float, effects: str
) -> Evidence:
    """Evidence that a pusher angle is beyond every sticking motion, and that the left edge approaches."""
    scene, pusher = Scene(rod_length=rod_length, effects=effects), rational(pusher_angle)
    rights, lefts = zip(*(mechanics.motion_cone(pure) for pure in scene.pure), strict=True)
    margin = smallest(pusher - left for left in lefts)
    beyond = inequality(margin, value=pusher - margin, unit="degree", claimed=pusher_angle)
    inside = inequality(smallest([*lefts, *(180 - left for left in lefts)]), unit="degree")
    below = inequality(smallest(pusher - right for right in rights), unit="degree")
    return together(beyond, inside, below, both_effects_lie_between())


@proof
def slips_beyond_edge(
    mechanics: Mechanics, rod_length: float, pusher_angle: float, effects: str
) -> Evidence:
    """From this pusher angle to below 180 degrees slip to the right is the only mode, definition 1."""
    return _beyond_left_edge(mechanics, rod_length, pusher_angle, effects)


@proof
def no_solution_beyond_edge(
    mechanics: Mechanics, rod_length: float, pusher_angle: float, effects: str
) -> Evidence:
    """From this pusher angle to below 180 degrees no mode is consistent, definition 2."""
    return _beyond_left_edge(mechanics, rod_length, pusher_angle, effects)


@proof
def both_effects_lie_between() -> Evidence:
    """The exact cone of the ring with both effects is the hull of the two pure cones."""
    rate = ids.l * ids.q, -ids.l * ids.p  # of the motion with k
    turning = ids.cross(ids.MOTION, rate) + ids.l * ids.ROD_COSINE
    return together(
        identity({"u x du/dk": ids.normal(turning)}),
        lemmas.rising_arm(),
        lemmas.turning(),
        lemmas.inertial_turning(),
    )


@proof
def slow_pulls_fast_does_not(
    mechanics: Mechanics, rod_length: float, above: float, below: float
) -> Evidence:
    """Between two coefficients the velocity cone is below the fence, the acceleration cone is not."""
    slow = Scene(rod_length=rod_length, law=above, effects=FRICTION)
    velocity, _ = mechanics.motion_cone(slow)
    acceleration, _ = mechanics.motion_cone(replace(slow, law=below, effects=INERTIA))
    exact = facts({"no pulling by inertia": sign(acceleration) >= 0})
    reach = inequality(-velocity, value=velocity, unit="degree")
    return together(reach, exact, lemmas.turning(), lemmas.inertial_turning())


@proof
def open_cone_inside_closed() -> Evidence:
    """The two laws have one friction cone, closed and open, and the open one does not slip."""
    first, second = LAWS["definition-1"], LAWS["definition-2"]
    return facts(
        {
            "one cone": first.friction_coefficient == second.friction_coefficient,
            "closed by definition 1": first.closed and not first.adhesive,
            "open by definition 2": not second.closed and not second.adhesive,
            "no slip by definition 2": not second.slips,
        }
    )
