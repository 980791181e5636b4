"""Findings beyond the paper: duality of the ring, and solutions beyond its pair."""

from __future__ import annotations

from dataclasses import dataclass

from flint import arb

from planar_pushing.certified import ring
from planar_pushing.certified.balls import rational
from planar_pushing.certified.cones import motion_cone
from planar_pushing.certified.contact import modes, slips
from planar_pushing.certified.contact.modes import Mode, coulomb
from planar_pushing.certified.line_of_force import motion_angle
from planar_pushing.certified.setting import Effects, Slider, edge
from planar_pushing.evidence.claims.proofs import lemmas
from planar_pushing.evidence.claims.proofs.examples import METHOD, found_modes
from planar_pushing.evidence.claims.proofs.registry import check
from planar_pushing.evidence.claims.proofs.verdicts import (
    Evidence,
    facts,
    inequality,
    near,
    together,
)


@check
def self_duality() -> Evidence:
    """Identity f(1 / k) = t(k) for k > 0."""
    return lemmas.duality()


@check
def force_with_center_on_ring(force: float, within: float) -> Evidence:
    """f(1) = t(1) = 2 / pi."""
    found, torque = ring.profile(arb(1))
    method = "closed forms at k = 1"
    return together(near(found, force, within, method, "W"), near(torque, force, within, method))


@check
def slow_pulls_fast_does_not(rod_length: float, above: float, below: float) -> Evidence:
    """Between two coefficients the velocity cone reaches below the fence, the acceleration cone not.

    The right edge falls as the coefficient rises: the ends decide for all between them. The left edge
    stays below 180 degrees even under infinite friction.
    """
    slider = Slider.of(rod_length)
    velocity = motion_angle(slider, edge(above, 1), rational(0.0))
    acceleration = motion_cone(slider, Effects.INERTIA, below).right
    method = (
        "right edge of the velocity cone at the least, of the acceleration cone at the greatest mu"
    )
    reach = inequality(-velocity, method, value=velocity, unit="degree")
    exact = facts({"no pulling by inertia": bool(acceleration >= 0)}, method)
    return together(reach, exact)


@check
def slow_sticks_fast_slips_off(
    rod_length: float, friction_coefficient: float, pusher_angle: float, slow: float, fast: float
) -> Evidence:
    """With both effects a slow retreat can stick and a fast one cannot."""
    law = coulomb(friction_coefficient)
    found = [
        found_modes(rod_length, Effects.BOTH, law, pusher_angle, size) for size in (slow, fast)
    ]
    names = {
        f"sticks at {slow:g}": Mode.STICK in found[0],
        f"does not stick at {fast:g}": Mode.STICK not in found[1],
    }
    return facts(names, METHOD)


@dataclass(frozen=True, slots=True)
class _Dip:
    """Motions under the right edge, their least normal motion, and the spin ratio of it."""

    edge: slips.Edge
    least: arb
    spin: arb

    def force(self, k: arb) -> arb:
        """Magnitude of the force, W f + m v."""
        return ring.profile(k)[0] + self.edge.speed(k)


def _dip(rod_length: float, friction_coefficient: float) -> _Dip | None:
    """Least normal motion inside the segment of spin ratios; None where there is no extremum."""
    motions, parts = modes.cover(Slider.of(rod_length), friction_coefficient, 1)
    gaps = [part.low.union(part.high) for part in parts if part.rise == 0]
    if not gaps:
        return None
    found = [(motions.normal_motion(gap), gap) for gap in gaps]
    found += [(part.start, part.low) for part in parts if part.start.is_finite()]
    found += [(part.end, part.high) for part in parts if part.end.is_finite()]
    return _Dip(motions, *min(found, key=lambda each: float(each[0].lower())))


_MONOTONE = facts({"a least value inside": False}, "certified monotone parts of the spin ratio")


@check
def normal_motion_dips(
    rod_length: float, friction_coefficient: float, least: float, within: float
) -> Evidence:
    """The least n . u over all motions under the right edge lies inside the segment, and is negative."""
    if (dip := _dip(rod_length, friction_coefficient)) is None:
        return _MONOTONE
    method = "n . u on certified monotone parts of the spin ratio and on the gap between them"
    number = near(dip.least, least, within, method, "W/m")
    return together(number, inequality(-dip.least, method, unit="W/m"))


@check
def force_at_the_dip(
    rod_length: float, friction_coefficient: float, force: float, within: float
) -> Evidence:
    """Magnitude of the force at that minimum."""
    if (dip := _dip(rod_length, friction_coefficient)) is None:
        return _MONOTONE
    method = "force on the gap that holds the minimum"
    return near(dip.force(dip.spin), force, within, method, "W")


@check
def force_at_the_return(
    rod_length: float, friction_coefficient: float, force: float, within: float
) -> Evidence:
    """Magnitude of the force beyond the minimum where n . u is zero again."""
    if (dip := _dip(rod_length, friction_coefficient)) is None:
        return _MONOTONE
    method = "force at the spin ratio of a motion along the fence"
    return near(dip.force(dip.edge.normal / dip.edge.lever), force, within, method, "W")
