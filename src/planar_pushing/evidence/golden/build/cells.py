"""Records of the golden datasets: the named numbers at one point of a grid.

Parameters and coordinates are plain values, taken as exact.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from planar_pushing.certified import cones, line_of_force
from planar_pushing.certified.balls import rational
from planar_pushing.certified.contact import modes
from planar_pushing.certified.setting import Effects, Slider, edge, heading

#: Parameters of the slider; the paper's are all 1.
Parameters = Mapping[str, float]
UNIT: Parameters = {"weight": 1.0, "mass": 1.0, "radius": 1.0, "gyration_radius": 1.0}

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
        "pulls": int(cones.pulls(slider, resisting, mu)),
        "slips_while_pushing": int(cones.slips_while_pushing(slider, resisting, mu)),
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
    """Every contact mode: how many motions, the slowest and the fastest; 0 where there is none."""
    slider = Slider.of(length, rod_angle, **parameters)
    found = modes.contact_modes(slider, Effects(effects), laws[label], magnitude, pusher_angle)
    ends = [(motions or [modes.REST])[:: max(1, len(motions) - 1)] for motions in found.values()]
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
    """Acceleration centre and motion at a share of inertia."""
    slider, force = (Slider.of(length, rod_angle, **parameters), heading(rational(force_angle)))
    spin = line_of_force.spin_ratio(slider, force, rational(share))
    x, y = line_of_force.motion_center(slider, force, spin)
    size = rational(parameters["radius"])
    motion = line_of_force.motion_angle(slider, force, rational(share))
    return {"center_x": x * size, "center_y": y * size, "motion_angle": motion}


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
