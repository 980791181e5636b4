"""Records of the golden datasets: the named numbers at one point of a grid.

Parameters and coordinates are plain values, taken as exact.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from flint import arb

from planar_pushing.certified import cones, line_of_force
from planar_pushing.certified.balls import cosine_sine, exact_sine, rational, sign
from planar_pushing.certified.contact import modes
from planar_pushing.certified.contact.sticking import Motion
from planar_pushing.certified.setting import Effects, Heading, Slider, edge, heading, lean

#: Parameters of the slider; the paper's are all 1.
Parameters = Mapping[str, float]
UNIT: Parameters = {"weight": 1.0, "mass": 1.0, "radius": 1.0, "gyration_radius": 1.0}

#: What a mode without a solution has in place of a motion.
NO_MOTION = Motion(arb.nan(), arb.nan())

#: Name: a ball or an integer, or a list of either.
Record = dict[str, Any]


def limit_point(
    parameters: Parameters, effects: str, length: float, angle: float, force_angle: float
) -> Record:
    """Point of the limit curve at a force angle."""
    slider, resisting = Slider.of(length, angle, **parameters), Effects(effects)
    force = heading(rational(force_angle))
    size, spin = line_of_force.limit_point(slider, resisting, force)
    if resisting is Effects.BOTH:
        motion = line_of_force.motion_degrees(slider, force, spin)
    else:
        motion = line_of_force.motion_angle(slider, force, resisting.shares[0])
    return {
        "force": size,
        "force_x": size * force.x,
        "force_y": size * force.y,
        "spin_ratio": spin,
        "motion_angle": motion,
    }


def motion_cone(
    parameters: Parameters, effects: str, length: float, angle: float, mu: float
) -> Record:
    """Friction cone, motion cone, and what follows from them."""
    slider, resisting = Slider.of(length, angle, **parameters), Effects(effects)
    forces, motions = cones.friction_cone(mu), cones.motion_cone(slider, resisting, mu)
    return {
        "friction_cone_right": forces.right,
        "friction_cone_left": forces.left,
        "motion_cone_right": motions.right,
        "motion_cone_left": motions.left,
        "limit_force_right": line_of_force.limit_point(slider, resisting, edge(mu, 1))[0],
        "limit_force_left": line_of_force.limit_point(slider, resisting, edge(mu, -1))[0],
        "pulls": cones.pulls(slider, resisting, mu),
        "slips_while_pushing": cones.slips_while_pushing(slider, resisting, mu),
    }


def contact_mode(
    parameters: Parameters,
    rod_angle: float,
    laws: Mapping[str, modes.Law],
    effects: str,
    label: str,
    length: float,
    magnitude: float,
    pusher_angle: float,
) -> Record:
    """Every contact mode: how many motions, the slowest and the fastest; NaN where there is none."""
    slider = Slider.of(length, rod_angle, **parameters)
    found = modes.contact_modes(slider, Effects(effects), laws[label], magnitude, pusher_angle)
    ends = [(motions or [NO_MOTION])[:: max(1, len(motions) - 1)] for motions in found.values()]
    return {
        "consistent": [len(motions) for motions in found.values()],
        "spin_ratio": [each[0].spin_ratio for each in ends],
        "force_angle": [each[0].force_angle for each in ends],
        "spin_ratio_fast": [each[-1].spin_ratio for each in ends],
        "force_angle_fast": [each[-1].force_angle for each in ends],
        "outcome": modes.outcome(found),
    }


def center(
    parameters: Parameters, rod_angle: float, length: float, force_angle: float, share: float
) -> Record:
    """Acceleration center, from the contact, and motion at a share of inertia."""
    slider, force = (Slider.of(length, rod_angle, **parameters), heading(rational(force_angle)))
    spin = line_of_force.spin_ratio(slider, force, rational(share))
    x, y = _from_contact(parameters, slider, line_of_force.motion_center(slider, force, spin))
    motion = line_of_force.motion_angle(slider, force, rational(share))
    return {"center_x": x, "center_y": y, "motion_angle": motion}


def exact_ends(parameters: Parameters, length: float, angle: float, force_angle: float) -> Record:
    """Acceleration centers under one line of force, from the contact: friction alone, inertia alone."""
    ends = [center(parameters, angle, length, force_angle, share) for share in (0.0, 1.0)]
    return {f"exact_{x}": [each[f"center_{x}"] for each in ends] for x in "xy"}


def bound_ends(parameters: Parameters, length: float, angle: float, force_angle: float) -> Record:
    """Ends of the paper's bound under one line of force, from the contact (Sec. 4).

    A line that misses the ring has its centers inside it, one that meets it outside.
    """
    slider, force = Slider.of(length, angle, **parameters), heading(rational(force_angle))
    _, sine = lean(slider, force)
    side = 0 if slider.rod_length == 0 else sign(sine)
    degrees = slider.rod_angle - rational(force_angle)
    misses = sign(
        slider.rod_length * abs(sine) - 1,
        lambda: side * slider.rod_length * exact_sine(degrees) - 1,
    )
    inner, outer = {1: (arb.pos_inf(), arb(1)), 0: (arb(1), arb(1)), -1: (arb(1), arb(0))}[misses]
    spins = [arb(0), arb(0)] if side == 0 else [side * inner, side * outer]
    ends = [_bound_end(parameters, slider, force, spin, side) for spin in spins]
    return {f"bound_{x}": [each[i] for each in ends] for i, x in enumerate("xy")}


def _bound_end(
    parameters: Parameters, slider: Slider, force: Heading, spin: arb, side: int
) -> tuple[arb, arb]:
    """Center at a spin ratio; at infinity it lies on the side that the region goes on to."""
    if spin.is_finite():
        x, y = line_of_force.motion_center(slider, force, spin)
        flip = -1 if spin == 0 and side < 0 else 1
        return _from_contact(parameters, slider, (flip * x, flip * y))
    return _from_contact(parameters, slider, (arb(0), arb(0)))


def _from_contact(
    parameters: Parameters, slider: Slider, centre: tuple[arb, arb]
) -> tuple[arb, arb]:
    """Place relative to the contact of one relative to the ring center in units of R."""
    c, s = cosine_sine(slider.rod_angle)
    size = rational(parameters["radius"])
    return (centre[0] + slider.rod_length * c) * size, (centre[1] + slider.rod_length * s) * size


def acceleration_cones(parameters: Parameters, rod_angle: float, length: float) -> Record:
    """The paper's bound and the exact cone under infinite friction."""
    slider = Slider.of(length, rod_angle, **parameters)
    bound = cones.conservative_cone(slider)
    exact = cones.motion_cone(slider, Effects.BOTH, modes.INFINITE_FREE.friction_coefficient)
    return {
        "conservative_cone_right": bound.right,
        "conservative_cone_left": bound.left,
        "exact_cone_right": exact.right,
        "exact_cone_left": exact.left,
    }
