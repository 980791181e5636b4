"""What the paper does not say: duality of the ring, and solutions beyond its pair."""

from __future__ import annotations

from flint import arb

from planar_pushing.claims import lemmas
from planar_pushing.claims.examples import METHOD, found_modes
from planar_pushing.claims.registry import check
from planar_pushing.claims.verdicts import (
    Evidence,
    facts,
    inequality,
    near,
    together,
)
from planar_pushing.golden import modes, ring, slips
from planar_pushing.golden.balls import Undecided, rational
from planar_pushing.golden.cones import motion_cone
from planar_pushing.golden.modes import Mode, coulomb
from planar_pushing.golden.reference import motion_angle
from planar_pushing.golden.setting import Effects, Slider, edge


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


def _dip(rod_length: float, friction_coefficient: float) -> tuple[slips.Edge, arb, arb]:
    """Motions under the right edge; least normal motion and the spin ratios of the gap around it."""
    edges, parts = modes.cover(Slider.of(rod_length), friction_coefficient, 1)
    gaps = [part.low.union(part.high) for part in parts if part.rise == 0]
    if not gaps:
        raise Undecided("the normal motion has no certified extremum")
    found = [(edges.normal_motion(gap), gap) for gap in gaps]
    found += [(part.start, part.low) for part in parts if part.start.is_finite()]
    found += [(part.end, part.high) for part in parts if part.end.is_finite()]
    lowest = min(found, key=lambda each: float(each[0].lower()))
    return edges, *lowest


@check
def normal_motion_dips(
    rod_length: float, friction_coefficient: float, least: float, within: float
) -> Evidence:
    """N . u over all motions under the right edge is least inside the segment, and negative."""
    _, lowest, _ = _dip(rod_length, friction_coefficient)
    method = "n . u on certified monotone parts of the spin ratio and on the gap between them"
    number = near(lowest, least, within, method, "W/m")
    return together(number, inequality(-lowest, method, unit="W/m"))


@check
def force_at_the_dip(
    rod_length: float, friction_coefficient: float, force: float, within: float
) -> Evidence:
    """Magnitude of the force at that minimum, W f + m v."""
    edges, _, k = _dip(rod_length, friction_coefficient)
    size = ring.profile(k)[0] + edges.speed(k)
    return near(size, force, within, "force on the gap that holds the minimum", "W")


@check
def force_at_the_return(
    rod_length: float, friction_coefficient: float, force: float, within: float
) -> Evidence:
    """Magnitude of the force beyond the minimum where n . u is zero again."""
    edges, _, _ = _dip(rod_length, friction_coefficient)
    k = edges.normal / edges.lever
    size = ring.profile(k)[0] + edges.speed(k)
    return near(size, force, within, "force at the spin ratio of a motion along the fence", "W")
