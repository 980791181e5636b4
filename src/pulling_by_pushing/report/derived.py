"""Numbers of the report that are computed from a dataset; all for the paper's rod angle."""

from __future__ import annotations

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import ContactMode, Outcome
from pulling_by_pushing.report.results import FRICTION

ROD_ANGLE = 45.0


def ellipse_deviation(curves: xr.Dataset, rod_length: float) -> float:
    """Largest deviation of the limit curve from the ellipse with the same axes, percent."""
    force = curves.force.sel(effects=FRICTION, rod_length=rod_length)
    quarter = force.sel(force_angle=slice(ROD_ANGLE, ROD_ANGLE + 90.0))
    major, minor = quarter.values[0], quarter.values[-1]
    angle = np.deg2rad(quarter.force_angle.values - ROD_ANGLE)
    ellipse = major * minor / np.hypot(minor * np.cos(angle), major * np.sin(angle))
    return 100 * float(np.max(np.abs(quarter.values / ellipse - 1)))


def bound_reach(centers: xr.Dataset) -> float:
    """Longest rod for which the conservative cone of infinite friction extends to 180 degrees.

    For a longer rod a force along the fence misses the ring, and the left edge drops by many degrees.
    """
    return float(centers.radius / np.sin(np.deg2rad(centers.rod_angle)))


def pull_end(log: xr.Dataset, variable: str) -> float:
    """Value at the instant at which the contact separates.

    It is NaN, which no report prints, if the contact is kept until the end.
    """
    separate = np.flatnonzero(log["mode"] == ContactMode.SEPARATE)
    return float(log[variable][separate[0]]) if separate.size else np.nan


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


def conservative_excess(centers: xr.Dataset, side: str) -> float:
    """Angle by which the conservative cone exceeds the exact one, for a rod of length 5."""
    one = centers.sel(rod_length=5.0)
    return float(abs(one[f"conservative_cone_{side}"] - one[f"exact_cone_{side}"]))
