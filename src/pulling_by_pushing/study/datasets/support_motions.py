"""Cones, solutions and limit curves of each support, for any pressure distribution (Secs. 2 and 3)."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, cast

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import (
    ContactLaw,
    ContactMode,
    InfiniteFriction,
    PerfectlyRough,
)
from planar_pushing.mechanics.effects import Inertia, SupportFriction
from planar_pushing.mechanics.force.cones import leaves_the_fence, motion_cone, omits_pushes
from planar_pushing.mechanics.force.limit_curve import limit_curve
from planar_pushing.mechanics.plane import direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.slider import Slider
from planar_pushing.mechanics.solve import solve
from planar_pushing.mechanics.supports import Ring
from pulling_by_pushing.study.datasets.base import (
    axis,
    friction_angle,
    friction_axis,
    labeled_radians,
    objects,
)
from pulling_by_pushing.study.model import Part

EDGES = ["right", "left"]
#: A force within this angle of the fence, radians, requires infinite friction.
ALONG_FENCE = 1e-12


# --- Scenes -------------------------------------------------------------------------------------------


def scene_of(support: Any, length: Any, angle: Any, contact: xr.DataArray | ContactLaw) -> Scene:
    """Scene of unit weight on one or more supports, with rods at angles in degrees."""
    slider = Slider(rod_length=length, rod_angle=np.deg2rad(angle))
    return Scene(slider=slider, contact=contact, effects=(SupportFriction(support=support),))


def on_grid(part: Part, contact: xr.DataArray | ContactLaw) -> Scene:
    """Scene with every support and rod of the grid."""
    return scene_of(support_axis(part), axis(part, "rod_length"), axis(part, "rod_angle"), contact)


def support_axis(part: Part) -> xr.DataArray:
    """The study's supports as objects, labeled with their names."""
    supports = part.gallery()
    return objects("support", supports, supports.values())


# --- Pivots and forces of a motion --------------------------------------------------------------------


def pivots(scene: Scene, angle: xr.DataArray) -> xr.DataArray:
    """Number of the support point about which the slider pivots if its contact moves at an angle, radians.

    The contact is perfectly rough, so that it sticks for every motion.
    """
    pivot: xr.DataArray = solve(replace(scene, contact=PerfectlyRough()), angle).pivot
    return pivot.max("solution").astype(np.int16)


def pulling_friction_angle(scene: Scene) -> xr.DataArray:
    """Smallest angle of friction at which the contact can pull, degrees; 90 if it never can.

    The motion direction increases with the force direction. The motion cone therefore reaches below the
    fence on the right as soon as the friction cone contains a force beyond all those that sustain motion
    along the fence to the right; similarly on the left. The angle is as accurate as the directions of
    these forces, whereas mu, its tangent, is not where it is large.
    """
    right, left = _sustaining_angles(scene, 0.0)[0], -_sustaining_angles(scene, np.pi)[1]
    steeper = right.where(right > left, left)
    angle = cast(xr.DataArray, 90.0 - np.rad2deg(steeper))
    return angle.where(steeper > ALONG_FENCE, 90.0)


def _sustaining_angles(scene: Scene, motion: float) -> tuple[xr.DataArray, xr.DataArray]:
    """Smallest and largest angle from a motion, radians, to the forces that sustain it.

    The two differ if the slider pivots.
    """
    rough = replace(scene, contact=PerfectlyRough())
    solutions = solve(rough, xr.DataArray(motion))
    sticks = solutions["mode"] == int(ContactMode.STICK)
    ends = [_turn(motion, solutions[name]).where(sticks) for name in ("force", "force_end")]
    angles, dims = xr.concat(ends, "end"), ("end", "solution")
    return angles.min(dims), angles.max(dims)


def _turn(heading: float, force: xr.DataArray) -> xr.DataArray:
    """Angle from a heading to a force, radians in (-pi, pi]."""
    c, s = direction(heading)
    x, y = (force.isel(xy=i, drop=True) for i in (0, 1))
    return cast(xr.DataArray, np.arctan2(c * y - s * x, c * x + s * y))


# --- Datasets -----------------------------------------------------------------------------------------


def support_cones(part: Part) -> xr.Dataset:
    """Build the motion cones of each support for part of a study."""
    scene = on_grid(part, friction_axis(part))
    cone = motion_cone(scene)
    edges = _edges(cone)
    angle = friction_angle(part.grid["friction_coefficient"])
    return xr.Dataset(
        {
            "motion_angle": np.rad2deg(edges),
            "pivot": pivots(scene, edges),
            "width": np.rad2deg(cone.left - cone.right),
            "pulls": leaves_the_fence(cone),
            "slips_while_pushing": scene.law.slips & omits_pushes(cone),
        },
        {"friction_angle": ("friction_coefficient", angle)},
    )


def _edges(cone: Any) -> xr.DataArray:
    """Both edges of cones along the axis `edge`, radians."""
    edges: list[xr.DataArray] = [cone.right, cone.left]
    return xr.concat(edges, xr.Variable("edge", EDGES))


def support_modes(part: Part) -> xr.Dataset:
    """Build the solutions of each support for part of a study, by `solve` on labeled arrays."""
    angles: xr.DataArray = labeled_radians(axis(part, "pusher_angle"))
    solutions = solve(on_grid(part, friction_axis(part)), angles)
    angle = friction_angle(part.grid["friction_coefficient"])
    return solutions.assign_coords(friction_angle=("friction_coefficient", angle))


def support_curves(part: Part) -> xr.Dataset:
    """Build the limit curves of each support, and of the study's ring, for the study's rod."""
    phi = labeled_radians(axis(part, "force_angle"))
    rod = part.slider.rod_length, part.slider.rod_angle, InfiniteFriction()
    scene = scene_of(support_axis(part), *rod)
    curve = limit_curve(scene, phi)
    return xr.Dataset(
        {
            "force": curve.magnitude,
            "motion_angle": np.rad2deg(curve.motion_angle),
            "pivot": pivots(scene, curve.motion_angle),
            "ring_force": limit_curve(scene_of(Ring(part.slider.radius), *rod), phi).magnitude,
        }
    )


def support_rods(part: Part) -> xr.Dataset:
    """Build what infinite friction holds and pulling needs, over rods, for each support and the ring."""
    lengths, angles = part.grid["rod_length"], part.grid["rod_angle"]
    sweep = ["rod_length"] * len(lengths) + ["rod_angle"] * len(angles)
    length = _rods([*lengths, *(part.slider.rod_length for _ in angles)])
    angle = _rods([*(part.slider.rod_angle for _ in lengths), *angles])
    scene = scene_of(support_axis(part), length, angle, InfiniteFriction())
    ring = scene_of(Ring(part.slider.radius), length, angle, InfiniteFriction())
    inertia = replace(ring, effects=(Inertia(gyration_radius=part.slider.radius),))
    return xr.Dataset(
        {
            "motion_angle": np.rad2deg(_edges(motion_cone(scene))),
            "pulling_friction_angle": pulling_friction_angle(scene),
            "ring_motion_angle": np.rad2deg(_edges(motion_cone(ring))),
            "ring_pulling_friction_angle": pulling_friction_angle(ring),
            "inertia_pulling_friction_angle": pulling_friction_angle(inertia),
        },
        {"rod_length": length, "rod_angle": angle, "sweep": ("rod", sweep)},
    )


def _rods(values: list[Any]) -> xr.DataArray:
    return xr.DataArray(np.array(values, float), dims="rod")
