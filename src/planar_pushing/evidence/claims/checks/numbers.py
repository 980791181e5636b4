"""Numbers of the ring that the ledger can name; lengths in units of R, angles in degrees, W = m = R = 1."""

from __future__ import annotations

import math

from flint import arb, fmpq

from planar_pushing.certified import cones, ring
from planar_pushing.certified.balls import cosine_sine, rational
from planar_pushing.certified.contact.modes import (
    INFINITE_FREE,
    PERFECTLY_ROUGH,
    Law,
    Mode,
    contact_modes,
    cover,
)
from planar_pushing.certified.inverse import spin_of_arm
from planar_pushing.certified.line_of_force import motion_angle, spin_ratio
from planar_pushing.certified.roots import increasing_root
from planar_pushing.certified.setting import (
    FRICTION,
    Effects,
    Slider,
    heading,
    lean,
)
from planar_pushing.evidence.claims.registry import quantity
from planar_pushing.evidence.claims.verdicts import Fails

_FRICTION = str(Effects.FRICTION)
_START = arb(2) ** -20


@quantity(right="degree", left="degree", half_angle="degree")
def friction_cone(friction_coefficient: float) -> tuple[arb, arb, arb]:
    """Edges and half-angle of the friction cone.

    The edges are the directions $(mu, 1)$ and $(-mu, 1)$, or those of the fence for infinite friction.
    """
    cone = cones.friction_cone(friction_coefficient)
    return cone.right, cone.left, (cone.left - cone.right) / 2


@quantity(right="degree", left="degree")
def motion_cone(
    rod_length: float,
    friction_coefficient: float,
    effects: str = _FRICTION,
    rod_angle: float = 45.0,
) -> tuple[arb, arb]:
    """Edges of a motion cone.

    An edge is the direction of motion under the force of an edge of the friction cone, with the spin
    ratio enclosed by a change of sign. With both effects it is the outer one of the edges of the two
    pure cones.
    """
    slider = Slider.of(rod_length, rod_angle)
    cone = cones.motion_cone(slider, Effects(effects), friction_coefficient)
    return cone.right, cone.left


@quantity(right="degree", left="degree", right_gap="degree", left_gap="degree")
def bound_of_the_cases(rod_length: float) -> tuple[arb, arb, arb, arb]:
    """Fig. 12: the cone that the seven cases allow under infinite friction, and its gaps to the exact cone.

    Between two neighboring tangents of the ring $abs(k)$ lies in $[0, 1]$ or in $[1, oo]$. The
    direction of motion is monotone in the force angle and in the spin ratio, so that the ends of these
    sectors give the bound. A gap is the angle from an edge of the bound inward to the edge of the exact
    cone.
    """
    slider = Slider.of(rod_length)
    bound = cones.conservative_cone(slider)
    exact = cones.motion_cone(slider, Effects.BOTH, math.inf)
    gaps = exact.right - bound.right, bound.left - exact.left
    if not all(gap > 0 for gap in gaps):
        raise Fails("the bound does not contain the exact cone")
    return bound.right, bound.left, *gaps


@quantity("R")
def moment_arm(rod_length: float, force_angle: float) -> arb:
    """Moment arm of a force at the contact.

    The moment arm is $l sin(psi - phi)$, positive if the line of force passes the center on the right.
    """
    slider = Slider.of(rod_length)
    return slider.rod_length * lean(slider, heading(force_angle))[1]


@quantity(spin_ratio="1", angle="degree")
def motion(rod_length: float, force_angle: float) -> tuple[arb, arb]:
    """Motion under a force and support friction.

    The spin ratio is enclosed by a change of sign in the balance of torque; it determines the motion of
    the contact.
    """
    slider, force = Slider.of(rod_length), heading(force_angle)
    return spin_ratio(slider, force, FRICTION), motion_angle(slider, force, FRICTION)


@quantity("R")
def pulling_offset(rod_length: float) -> arb:
    """Offset on the right of the center beyond which the contact moves away, psi = 45 degrees.

    The normal velocity of the contact, $sin phi - k l cos psi$, vanishes at one force angle, since
    $theta_s$ increases with $phi$; a change of sign encloses the moment arm of this force. If the line
    of force passes closer to the center, the contact moves into the slider; if it passes farther away,
    the contact moves away from the slider.
    """
    length, (cosine, sine) = rational(rod_length), cosine_sine(fmpq(45))

    def drop(arm: arb) -> arb:
        """Return -n . v_s, with sin(phi) = sin(psi - asin(h / l))."""
        part = arm / length
        into = sine * (1 - part * part).sqrt() - cosine * part
        return spin_of_arm(arm, fmpq(1), FRICTION) * length * cosine - into

    return increasing_root(drop, _START, (length * sine).lower())


@quantity("1")
def pulling_coefficient(rod_length: float) -> arb:
    """Coefficient beyond which support friction lets the fence pull, psi = 45 degrees.

    Under the force of the right edge, $bold(n) dot bold(v)_s = 1 / sqrt(1 + mu^2) - k l / sqrt(2)$ per
    unit speed of the center. This vanishes at one coefficient, since the spin ratio increases with
    $mu$; a change of sign encloses this coefficient.
    """
    length, half = rational(rod_length), arb(2).rsqrt()

    def gap(mu: arb) -> arb:
        size = (1 + mu * mu).sqrt()
        arm = length * half * (mu - 1) / size
        return spin_of_arm(arm, fmpq(1), FRICTION) * length * half * size - 1

    return increasing_root(gap, arb(1) + _START, arb(1000))


@quantity("1")
def ellipse_shortfall(rod_length: float) -> arb:
    """Largest radial distance inside the ellipse with the same extrema, as a fraction of its radius.

    The ratio of the radius of the curve to that of the ellipse is $sqrt(f^2 + e t^2)$, with a constant
    $e$ for each $l$, and equals 1 at both ends of the range of spin ratios. Its derivative has the sign
    of $e H / k - 1$, which increases with $k$, since $t / k$ increases and $f$ decreases on $[0, 1]$,
    and by duality for $k > 1$. The largest distance is therefore at the only root, which a change of
    sign encloses.
    """
    length = arb(rational(rod_length))
    end = spin_of_arm(length, fmpq(1), FRICTION)
    squeeze = (1 / ring.profile(end)[0] ** 2 - 1) / length**2

    def place(size: arb) -> arb:
        """Spin ratio at which the slope vanishes, for an exact e; it decreases with e."""

        def steepness(k: arb) -> arb:
            force, torque = ring.profile(k)
            return size * torque / (k * force) - 1

        return increasing_root(steepness, _START, end.lower())

    lowest = place(squeeze.lower()).union(place(squeeze.upper()))
    force, torque = ring.profile(lowest)
    return 1 - (force**2 + squeeze * torque**2).sqrt()


@quantity("degree")
def rough_force_angle(rod_length: float, pusher_angle: float) -> arb:
    """The force angle of the motion that follows the pusher, enclosed by a change of sign in the torque."""
    return _force_angles(rod_length, pusher_angle, PERFECTLY_ROUGH, Mode.STICK)


@quantity("degree")
def slip_force_angle(rod_length: float, pusher_angle: float) -> arb:
    """The force angle of the only slip to the right under definition 1: exactly an edge of the cone."""
    return _force_angles(rod_length, pusher_angle, INFINITE_FREE, Mode.SLIP_RIGHT)


def _force_angles(rod_length: float, pusher_angle: float, law: Law, mode: Mode) -> arb:
    slider = Slider.of(rod_length)
    found = contact_modes(slider, Effects.FRICTION, law, 1.0, pusher_angle)[mode]
    if len(found) != 1:
        raise Fails(f"{len(found)} solutions of the mode {mode.name}")
    return found[0].force_angle


@quantity(least="W/m", force="W", return_force="W")
def normal_motion_dip(rod_length: float, friction_coefficient: float) -> tuple[arb, arb, arb]:
    """Minimum of n . u under the right edge with both effects, the force there, and the force at its zero.

    The spin ratios between those of friction and of inertia are covered by intervals on which ball
    arithmetic shows that $bold(n) dot bold(u)$ is monotone in the spin ratio, and by one gap, narrower
    than $10^(-12)$, that contains the minimum.
    """
    motions, parts = cover(Slider.of(rod_length), friction_coefficient, 1)
    gaps = [part.low.union(part.high) for part in parts if part.rise == 0]
    if not gaps:
        raise Fails("the normal motion is monotone")
    found = [(motions.normal_motion(gap), gap) for gap in gaps]
    found += [(part.start, part.low) for part in parts if part.start.is_finite()]
    found += [(part.end, part.high) for part in parts if part.end.is_finite()]
    least, spin = min(found, key=lambda each: float(each[0].lower()))
    back = motions.normal / motions.lever
    at_least, at_return = (ring.profile(k)[0] + motions.speed(k) for k in (spin, back))  # W f + m v
    return least, at_least, at_return


@quantity("a^2")
def offset_times_center_distance(spin_ratio: float) -> arb:
    """Product of the offset of a line of force and the distance of the center.

    The offset is $H(k) = f(1 / k) / t(1 / k)$, by duality, and the center is at the distance $1 / k$.
    """
    force, torque = ring.profile(1 / arb(rational(spin_ratio)))
    return force / torque / rational(spin_ratio)
