"""Sec. 3.2: cones under infinite friction, slip, and the normal push."""

from __future__ import annotations

import math

from flint import arb

from planar_pushing.certified.balls import rational
from planar_pushing.certified.cones import friction_cone, motion_cone
from planar_pushing.certified.contact.modes import INFINITE_FREE, Mode
from planar_pushing.certified.setting import Effects, Slider
from planar_pushing.evidence.claims.proofs import any_support, lemmas
from planar_pushing.evidence.claims.proofs import identities as ids
from planar_pushing.evidence.claims.proofs.examples import METHOD, found_modes, modes_are
from planar_pushing.evidence.claims.proofs.registry import check
from planar_pushing.evidence.claims.proofs.verdicts import (
    Evidence,
    equal,
    identity,
    inequality,
    near,
    on_grid,
    together,
)

#: Grid of the pushes into the slider: rod lengths in R, pusher angles in degrees.
_LENGTHS = (0.5, 1.0, 2.0, 5.0)
_ANGLES = tuple(range(1, 180, 2))

#: The span of a cone is known to this accuracy where balls add up.
_TIGHT = 1e-30


@check
def infinite_friction_cone(right: float, left: float) -> Evidence:
    """The forces into the slider, exactly."""
    cone = friction_cone(math.inf)
    method = "edges of the friction cone, exactly"
    return together(
        equal(cone.left, left, method, unit="degree"),
        equal(cone.right, right, method, unit="degree"),
    )


@check
def infinite_velocity_cone_spans(rod_length: float, span: float) -> Evidence:
    """Turning the force by 180 degrees turns the motion by 180 degrees: k is odd in the arm."""
    sums = {
        f"part {i} of the motion": part + ids.replaced(part, x=-ids.x, y=-ids.y, k=-ids.k)
        for i, part in enumerate(ids.MOTION)
    }
    sums["the arm"] = ids.ARM + ids.replaced(ids.ARM, x=-ids.x, y=-ids.y)
    method = "the motion is odd in the force, an identity for every l and psi; one span by balls"
    cone = motion_cone(Slider.of(rod_length), Effects.FRICTION, math.inf)
    return together(
        near(cone.left - cone.right, span, _TIGHT, method, "degree"), identity(sums, method)
    )


def _edge_motion(along: int) -> Evidence:
    """Identity: under a force along the fence the arm is +- l sin(psi) and n . v_s is -k l cos(psi)."""
    arm, normal = (
        ids.replaced(each, x=along * ids.ONE, y=0 * ids.ONE) for each in (ids.ARM, ids.MOTION[1])
    )
    return identity(
        {"the arm": arm - along * ids.l * ids.q, "n . v_s": normal + ids.k * ids.l * ids.p},
        "arm and normal motion under a force along the fence, exactly",
    )


@check
def slips_for_every_rod() -> Evidence:
    """A force at 180 degrees turns the slider clockwise and moves the contact into it."""
    method = (
        "n . v_s = -k l cos(psi) with k < 0 since the arm is -l sin(psi): above the fence for every "
        "l > 0 and 0 < psi < 90; least t / k > 0 on boxes"
    )
    return together(lemmas.same_sense(method), _edge_motion(-1))


@check
def pulls_for_every_rod() -> Evidence:
    """A force at 0 degrees turns the slider counter-clockwise and moves the contact away."""
    method = (
        "n . v_s = -k l cos(psi) with k > 0 since the arm is l sin(psi): below the fence for every "
        "l > 0 and 0 < psi < 90; least t / k > 0 on boxes"
    )
    return together(lemmas.same_sense(method), _edge_motion(1))


def slips_beyond_edge(effects: Effects, rod_length: float, pusher_angle: float) -> Evidence:
    """Evidence that every pusher motion from one angle up to 180 degrees slips to the right.

    Sticking is impossible outside the cone, separation where n . w > 0. Under a force on the left edge
    the contact moves along the cone's left edge at any speed; with equal normal parts it lags behind
    a pusher that is farther left.
    """
    cone = motion_cone(Slider.of(rod_length), effects, math.inf)
    method = "pusher angle minus the left edge of the cone, which lies within (0, 180) degrees"
    beyond = inequality(rational(pusher_angle) - cone.left, method, value=cone.left, unit="degree")
    inside = inequality(arb.min(cone.left, 180 - cone.left), method, unit="degree")
    slip = modes_are((Mode.SLIP_RIGHT,), rod_length, effects, INFINITE_FREE, pusher_angle)
    return together(beyond, inside, slip)


@check
def slip_with_infinite_friction(rod_length: float, pusher_angle: float) -> Evidence:
    """Slip to the right is the only solution from this pusher angle up to 180 degrees."""
    return slips_beyond_edge(Effects.FRICTION, rod_length, pusher_angle)


@check
def slip_exactly_outside_cone() -> Evidence:
    """Sec. 3.2: with v_py > 0 the contact sticks inside the cone and slips outside, on a grid."""
    wrong, points = [], 0
    for effects in (Effects.FRICTION, Effects.INERTIA):
        for length in _LENGTHS:
            cone = motion_cone(Slider.of(length), effects, math.inf)
            for angle in _ANGLES:
                mode = Mode.STICK if angle < cone.left else Mode.SLIP_RIGHT
                found = found_modes(length, effects, INFINITE_FREE, angle)
                points += 1
                wrong += [f"l = {length:g}, {angle}"] if found != {mode: 1} else []
    return on_grid(wrong, points, METHOD)


@check
def normal_push_sticks() -> Evidence:
    """u_x = f . u at phi = 0, and -f . u at phi = 180: the cone holds the normal."""
    return lemmas.positive_work(
        "f . u = 1 + k h >= 1 at both edges, so the right edge is below and the left edge above 90 "
        "degrees; every l, psi and share of inertia"
    )


@check
def normal_push_sticks_on_any_support() -> Evidence:
    """Slip by `a` under the force (-1, 0) or (1, 0) against it works -|a|: no support allows it.

    Sticking is there: its motion is (0, 1), so its force has the normal part f . v_s > 0.
    """
    work = {
        f"slip to the {side}": ids.dot((-turn * ids.ONE, 0 * ids.ONE), (turn * ids.a, ids.b))
        + ids.a
        for side, turn in (("right", 1), ("left", -1))
    }
    method = (
        "f . v_s is the power of friction, a sum of p |v| > 0. Sticking: it is f_n v_n, so f_n > 0, and "
        "infinite friction transmits the force. Slip: the force is along the fence against the slip, so "
        "f . v_s = -|f| |slip| < 0. Both by identities, exactly"
    )
    return together(identity(work, method), any_support.power())
