"""Numbers of the report that are computed from a dataset; all for the paper's rod angle."""

from __future__ import annotations

import json

import numpy as np
import xarray as xr
from scipy.optimize import brentq

from planar_pushing.mechanics.contact import (
    ContactLaw,
    ContactMode,
    InfiniteFriction,
    Outcome,
    PerfectlyRough,
)
from planar_pushing.mechanics.force.centers import conservative_motion_cone
from planar_pushing.mechanics.force.limit_curve import limit_curve
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solve import solve
from planar_pushing.scenes.scene_model import SceneFile
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.simulate import simulate
from planar_pushing.terms.options import EffectSet
from pulling_by_pushing.report.results import BOTH, FRICTION
from pulling_by_pushing.study.describe import parameters_of
from pulling_by_pushing.study.model import labeled_law

ROD_ANGLE = 45.0
#: Angles from the rod, in radians, at which the deviation of a curve from its ellipse is evaluated.
QUARTER = np.linspace(0.0, np.pi / 2, 901)


def _scene(dataset: xr.Dataset, effects: str, rod_length: float, contact: ContactLaw) -> Scene:
    """Scene with the study's slider on a rod of this length, with this law and these effects."""
    part = parameters_of(dataset)
    slider = part.ring(rod_length, ROD_ANGLE)
    return Scene(slider=slider, contact=contact, effects=part.effects(EffectSet(effects)))


def ellipse_deviation(curves: xr.Dataset, rod_length: float) -> float:
    """Largest deviation of the limit curve from the ellipse with the same axes, percent."""
    scene = _scene(curves, FRICTION, rod_length, InfiniteFriction())
    force = limit_curve(scene, np.deg2rad(ROD_ANGLE) + QUARTER).magnitude
    long, short = force[0], force[-1]
    ellipse = long * short / np.hypot(short * np.cos(QUARTER), long * np.sin(QUARTER))
    return 100 * float(np.max(np.abs(force / ellipse - 1)))


def bound_reach(centers: xr.Dataset) -> float:
    """Longest rod for which the conservative cone of infinite friction extends to 180 degrees.

    For a longer rod a force along the fence misses the ring, and the left edge drops by many degrees.
    """

    def reach(length: float) -> float:
        scene = _scene(centers, BOTH, length, InfiniteFriction())
        return float(conservative_motion_cone(scene).left) - (np.pi - 0.1)

    return float(brentq(reach, 1.0, 5.0))


def pull_end(log: xr.Dataset, variable: str) -> float:
    """Value at the instant at which the contact separates, from a run twice as long as the log's.

    It is NaN, which no report prints, if the contact is kept until the end of the longer run.
    """
    run = simulate(
        SceneFile.model_validate_json(log.attrs["scene"]).build(),
        pusher=Pusher(velocity=json.loads(log.attrs["pusher"])),
        duration=2 * float(log.attrs["duration"]),
        on_ambiguity=log.attrs["on_ambiguity"],
        until=ContactMode.SEPARATE,
    )
    end = run.isel(time=-1)
    return float(end[variable].where(end["mode"] == ContactMode.SEPARATE))


def slip_share(scene: xr.Dataset) -> float:
    """Slip speed, percent of the pusher's speed."""
    return 100 * float(abs(scene.slip.values[-1])) / float(scene.pusher_magnitude)


def motion_direction(scene: xr.Dataset) -> float:
    """Direction of the contact motion in the last solution."""
    x, y = scene.contact_motion.values[-1]
    return float(np.rad2deg(np.arctan2(y, x)))


def solutions(scene: xr.Dataset) -> float:
    """Number of consistent solutions."""
    return float(scene.sizes["solution"])


def pushes(modes: xr.Dataset) -> float:
    """Number of pushes."""
    return float(modes.outcome.size)


def outcomes(modes: xr.Dataset, outcome: Outcome) -> float:
    """Number of pushes with a given outcome."""
    return float((modes.outcome == int(outcome)).sum())


def sticking_pulls(modes: xr.Dataset) -> float:
    """Number of pushes under Coulomb's law in which the contact can stick while the fence retreats."""
    angle = modes.pusher_angle
    some = modes["mode"].isel(contact=modes.law.values == "coulomb")
    away = some.sel(pusher_angle=angle[(angle > -180) & (angle < 0)])
    return float((away == ContactMode.STICK).any("solution").sum())


def furthest_pull(modes: xr.Dataset, contact: str, magnitude: float) -> float:
    """Smallest pusher angle at which the contact can stick, with both effects.

    At this angle, the force of a perfectly rough contact, which sticks for every motion, is on the right
    edge of the friction cone.
    """
    edge = labeled_law(contact).force_angles.right
    scene = _scene(modes, BOTH, 2.0, PerfectlyRough())

    def inside(angle: float) -> float:
        found = solve(scene, angle, magnitude)
        x, y = next(each.force for each in found if each.mode is ContactMode.STICK)
        return float(np.arctan2(y, x) - edge)

    return float(np.rad2deg(brentq(inside, -np.pi / 2, np.pi / 2)))


def conservative_excess(centers: xr.Dataset, side: str) -> float:
    """Angle by which the conservative cone exceeds the exact one, for a rod of length 5."""
    one = centers.sel(rod_length=5.0)
    return float(abs(one[f"conservative_cone_{side}"] - one[f"exact_cone_{side}"]))
