"""Sec. 3: pushing and pulling with support friction alone; cones of motion."""

from __future__ import annotations

from flint import arb, fmpq

from planar_pushing.certified.balls import rational
from planar_pushing.certified.cones import friction_cone, motion_cone
from planar_pushing.certified.contact.modes import Mode, coulomb
from planar_pushing.certified.inverse import spin_of_arm
from planar_pushing.certified.line_of_force import contact_motion, spin_ratio
from planar_pushing.certified.roots import increasing_root
from planar_pushing.certified.setting import FRICTION, Effects, Slider, heading
from planar_pushing.evidence.claims.proofs import lemmas
from planar_pushing.evidence.claims.proofs.cover import cover
from planar_pushing.evidence.claims.proofs.examples import modes_are
from planar_pushing.evidence.claims.proofs.registry import check
from planar_pushing.evidence.claims.proofs.verdicts import (
    Evidence,
    facts,
    inequality,
    near,
    together,
)

EDGES = "motion under the edge of the friction cone; the spin ratio enclosed by a change of sign"


@check
def friction_cone_edges(friction_coefficient: float, half_angle: float, within: float) -> Evidence:
    """Half the friction cone is arctan mu about the normal."""
    cone = friction_cone(friction_coefficient)
    return near((cone.left - cone.right) / 2, half_angle, within, "edges (+-mu, 1)", "degree")


@check
def nonnegative_work(above: float) -> Evidence:
    """The work f . v_s >= 0, for every force angle, rod length and rod angle."""
    floor = cover(lambda a, b: lemmas.least_work(a, b) - rational(above), arb(0), arb(1))
    method = "f . v_s = 1 + k h for a unit force and a unit speed of the centre; k h >= 0 on boxes"
    return together(floor.evidence(method), lemmas.work())


@check
def motion_turns_with_force(above: float) -> Evidence:
    """theta_s rises with phi: |v_s|^2 d theta_s / d phi = 1 + k h + l^2 cos^2 / H' > 0."""
    floor = cover(lambda a, b: lemmas.least_work(a, b) - rational(above), arb(0), arb(1))
    slope = lemmas.rising_arm("H' > 0 on boxes of [0, 1]")
    method = (
        "|v_s|^2 d theta_s / d phi = 1 + k h + l^2 cos^2(psi - phi) / H', an identity; its least "
        "value on boxes, H' > 0; every rod length and rod angle"
    )
    return together(floor.evidence(method), slope, lemmas.turning())


@check
def cone_within_90_degrees() -> Evidence:
    """|theta_s - phi| < 90 degrees: its cosine has the sign of f . v_s = 1 + k h >= 1."""
    return lemmas.positive_work(
        "|v_s| cos(theta_s - phi) = 1 + k h >= 1, an identity and boxes; every l and psi"
    )


@check
def velocity_cone(
    rod_length: float, friction_coefficient: float, right: float, left: float, within: float
) -> Evidence:
    """Both edges of a velocity cone, in degrees."""
    return cone_edges(Effects.FRICTION, rod_length, friction_coefficient, (right, left), within)


def cone_edges(
    effects: Effects, rod_length: float, mu: float, edges: tuple[float, float], within: float
) -> Evidence:
    """Evidence for both edges of a motion cone; the number is the right one."""
    cone = motion_cone(Slider.of(rod_length), effects, mu)
    return together(
        *(
            near(ball, claimed, within, EDGES, "degree")
            for ball, claimed in zip((cone.right, cone.left), edges, strict=True)
        )
    )


@check
def velocity_cone_reaches_away(
    rod_length: float, friction_coefficient: float, below: float
) -> Evidence:
    """The right edge of the velocity cone lies below the fence."""
    cone = motion_cone(Slider.of(rod_length), Effects.FRICTION, friction_coefficient)
    margin = rational(below) - cone.right
    return inequality(margin, EDGES, value=cone.right, unit="degree", claimed=below)


@check
def motion_under_force(rod_length: float, force_angle: float, side: float, spin: float) -> Evidence:
    """v_s points into (side 1) or away from (-1) the slider, and turns it with the sign `spin`."""
    slider, force = Slider.of(rod_length), heading(force_angle)
    k = spin_ratio(slider, force, FRICTION)
    normal = contact_motion(slider, force, k)[1]
    method = "n . v_s and the spin ratio under the force, per speed of the centre"
    turn = inequality(spin * k, method)
    away = inequality(rational(side) * normal, method, value=normal)
    return together(away, turn)


@check
def push_has_one_solution(
    rod_length: float, friction_coefficient: float, pusher_angle: float
) -> Evidence:
    """The contact sticks and nothing else is consistent."""
    law = coulomb(friction_coefficient)
    return modes_are((Mode.STICK,), rod_length, Effects.FRICTION, law, pusher_angle)


@check
def pull_is_ambiguous(
    rod_length: float, friction_coefficient: float, pusher_angle: float
) -> Evidence:
    """Breaking contact, sticking and slipping are consistent."""
    expected = (Mode.SEPARATE, Mode.STICK, Mode.SLIP_LEFT)
    law = coulomb(friction_coefficient)
    return modes_are(expected, rod_length, Effects.FRICTION, law, pusher_angle)


@check
def friction_threshold(rod_length: float, threshold: float, within: float) -> Evidence:
    """Coefficient beyond which support friction lets the fence pull, psi = 45 degrees.

    n . v_s under the right edge is (1 - k l sqrt(1 + mu^2) / sqrt 2) / sqrt(1 + mu^2): the root is
    unique since k rises with mu.
    """
    length, half = rational(rod_length), arb(2).rsqrt()

    def gap(mu: arb) -> arb:
        size = (1 + mu * mu).sqrt()
        arm = length * half * (mu - 1) / size
        return spin_of_arm(arm, fmpq(1), FRICTION) * length * half * size - 1

    root = increasing_root(gap, arb(1) + arb(2) ** -20, arb(1000))
    return near(root, threshold, within, "root of n . v_s under the right edge, a change of sign")


@check
def aligned_without_rod(friction_coefficient: float) -> Evidence:
    """With l = 0 the velocity cone is the friction cone: neither pulling nor slip."""
    motion = motion_cone(Slider.of(0.0), Effects.FRICTION, friction_coefficient)
    forces = friction_cone(friction_coefficient)
    found = {
        "right edges agree": bool(motion.right == forces.right),
        "left edges agree": bool(motion.left == forces.left),
    }
    return facts(found, "l = 0: every motion is along the force, exactly")
