"""The paper's statements about the limit curve, pulling and slip, on a gallery of supports."""

from __future__ import annotations

from typing import Any

import numpy as np
from flint import arb
from scipy.optimize import minimize_scalar

from planar_pushing.evidence.claims.any_slider.supports import (
    GALLERY,
    L_SHAPE,
    SYMMETRIC,
    everywhere,
    stacked,
    touched,
)
from planar_pushing.evidence.claims.proofs.registry import check
from planar_pushing.evidence.claims.proofs.verdicts import Evidence, Verdict, near
from planar_pushing.mechanics.cones import can_pull, motion_cone, slips_while_pushing
from planar_pushing.mechanics.limit_curve import limit_curve
from planar_pushing.mechanics.plane import Array

#: Rods in units of the support's reach, and those whose contact is beyond the support.
RODS = np.array([0.2, 0.5, 1.0, 2.0, 5.0])
LONG_RODS = RODS[2:]
#: Angles from the rod, degrees.
TURNS = np.arange(1.0, 90.0)
#: Accuracy of a number of the mechanics, and what two that are equal may differ by.
ACCURACY, ROUNDING = 1e-10, 1e-12
ACROSS = np.pi / 2
METHOD = "by the mechanics in double precision"


def _measured(value: float, claimed: float, within: float, unit: str) -> Evidence:
    ball = arb(value, ACCURACY)
    return near(ball, claimed, within, METHOD, unit, holds=Verdict.VERIFIED)


def _forces(supports: Any, rods: Array, turns: Array) -> Array:
    """Force on the limit curve at angles from the rod, degrees: supports, rods and angles."""
    lengths = np.repeat(rods, len(turns))
    angles = np.tile(np.deg2rad(turns), len(rods))
    curve = limit_curve(touched(supports, lengths, ACROSS), ACROSS + angles)
    return np.asarray(curve.magnitude).reshape(-1, len(rods), len(turns))


@check
def curves_symmetric_about_rod() -> Evidence:
    """Forces at opposite angles from the rod are equal, for supports that the rod's line mirrors."""
    supports = stacked(SYMMETRIC.values())
    left, right = (_forces(supports, RODS, sign * TURNS) for sign in (1, -1))
    return everywhere(np.abs(left - right) <= ROUNDING, SYMMETRIC, METHOD)


@check
def curve_of_l_leans(rod_length: float, turn: float, difference: float, within: float) -> Evidence:
    """Force of the L to the right of its rod less that to the left, at an angle from the rod."""
    found = _forces(stacked([L_SHAPE]), np.array([rod_length]), np.array([-turn, turn]))
    right, left = found.ravel()
    return _measured(right - left, difference, within, "W")


@check
def greatest_force_along_rod() -> Evidence:
    """The force is W along the rod, through the center of pressure, and nowhere more."""
    centered = {name: each for name, each in GALLERY.items() if name != "pressure map"}
    turns = np.concatenate([-TURNS, [0.0], TURNS])
    force = _forces(stacked(centered.values()), RODS, turns)
    holds = (force <= 1 + ROUNDING) & ((turns != 0) | (np.abs(force - 1) <= ROUNDING))
    return everywhere(holds, centered, METHOD)


@check
def least_force_across_rod() -> Evidence:
    """The force is least across the rod, for supports that the rod's line mirrors."""
    supports = stacked(SYMMETRIC.values())
    least = _forces(supports, LONG_RODS, np.array([90.0]))
    return everywhere(_forces(supports, LONG_RODS, TURNS) >= least - ROUNDING, SYMMETRIC, METHOD)


@check
def least_force_of_l(rod_length: float, off: float, within: float) -> Evidence:
    """Angle from across the rod at which the force of the L is least, degrees."""
    supports, rods = stacked([L_SHAPE]), np.array([rod_length])

    def force(turn: float) -> float:
        return float(_forces(supports, rods, np.array([90.0 + turn])).item())

    found = minimize_scalar(force, bounds=(-30.0, 30.0), method="bounded", options={"xatol": 1e-9})
    ball = arb(
        abs(found.x), within / 10
    )  # the least is flat: its place is known to half the digits
    return near(ball, off, within, "least force, searched", "degree", holds=Verdict.VERIFIED)


@check
def gallery_pulls_and_slips(rod_angle: float) -> Evidence:
    """Under infinite friction every support can be pulled, and slips in a push just below 180 degrees."""
    scenes = touched(stacked(GALLERY.values()), RODS, np.deg2rad(rod_angle))
    holds = can_pull(scenes) & slips_while_pushing(scenes) & (motion_cone(scenes).left < np.pi)
    return everywhere(np.asarray(holds), GALLERY, METHOD)


@check
def gallery_aligned_along_normal() -> Evidence:
    """With the rod along the normal, supports that its line mirrors neither pull nor slip."""
    scenes = touched(stacked(SYMMETRIC.values()), RODS, ACROSS)
    holds = ~(can_pull(scenes) | slips_while_pushing(scenes))
    return everywhere(np.asarray(holds), SYMMETRIC, METHOD)


@check
def cone_of_l(rod_length: float, rod_angle: float, right: float, within: float) -> Evidence:
    """Right edge of the cone of the L under infinite friction, degrees."""
    cone = motion_cone(touched(stacked([L_SHAPE]), rod_length, np.deg2rad(rod_angle)))
    return _measured(float(np.rad2deg(cone.right.item())), right, within, "degree")
