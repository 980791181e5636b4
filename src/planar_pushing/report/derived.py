"""Numbers of the report that take a computation on a dataset; all for the paper's rod angle."""

from __future__ import annotations

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import ContactMode, Outcome
from planar_pushing.report.results import BOTH, FRICTION

ROD_ANGLE = 45.0
SLIPS = [ContactMode.SLIP_RIGHT.name, ContactMode.SLIP_LEFT.name]


def ellipse_deviation(curves: xr.Dataset, rod_length: float) -> float:
    """Largest distance of the limit curve from the ellipse of the same axes, percent of it."""
    force = curves.force.sel(effects=FRICTION, rod_length=rod_length, rod_angle=ROD_ANGLE)
    long, short = (force.sel(force_angle=ROD_ANGLE + turn).item() for turn in (0.0, 90.0))
    angle = np.deg2rad(force.force_angle - ROD_ANGLE)
    ellipse = long * short / np.hypot(short * np.cos(angle), long * np.sin(angle))
    return 100 * float(abs(force / ellipse - 1).max())


def cone_span(cones: xr.Dataset) -> float:
    """Width furthest from a half turn among the infinite friction cones of one effect."""
    one = cones.sel(effects=[name for name in cones.effects.values if name != BOTH])
    one = one.sel(friction_coefficient=np.inf)
    spans = (one.motion_cone_left - one.motion_cone_right).values.ravel()
    return float(spans[np.argmax(abs(spans - 180.0))])


def least_pulling(cones: xr.Dataset, effects: str, rod_length: float) -> float:
    """Least coefficient of friction of the grid that pulls."""
    pulls = cones.pulls.sel(effects=effects, rod_length=rod_length, rod_angle=ROD_ANGLE)
    return float(pulls.friction_coefficient[pulls.values > 0].min())


def slip_share(scene: xr.Dataset) -> float:
    """Speed of slip, percent of the pusher's."""
    return 100 * float(abs(scene.slip.values[-1])) / float(scene.pusher_magnitude)


def motion_direction(scene: xr.Dataset) -> float:
    """Angle of the contact motion of the last solution."""
    x, y = scene.contact_motion.values[-1]
    return float(np.rad2deg(np.arctan2(y, x)))


def solutions(scene: xr.Dataset) -> float:
    """Number of consistent solutions."""
    return float(scene.sizes["solution"])


def pushes(modes: xr.Dataset) -> float:
    """Number of pushes."""
    return float(modes.outcome.size)


def outcomes(modes: xr.Dataset, outcome: Outcome) -> float:
    """Number of pushes of one outcome."""
    return float((modes.outcome == int(outcome)).sum())


def inconsistent_definition_2(modes: xr.Dataset) -> float:
    """Number of pushes without solution under the second definition of infinite friction."""
    one = modes.outcome.sel(contact="infinite_friction_none")
    return float((one == int(Outcome.INCONSISTENT)).sum())


def _pulls(modes: xr.Dataset, law: str) -> xr.Dataset:
    """Solutions by mode of the pushes that stick while the fence moves away, under one law."""
    angle = modes.pusher_angle
    some = modes[["consistent"]].isel(contact=modes.law.values == law)
    away = some.sel(pusher_angle=angle[(angle > -180) & (angle < 0)])
    return away.where(away.consistent.sel(mode="STICK") > 0, 0)


def sticking_pulls(modes: xr.Dataset) -> float:
    """Number of pushes under Coulomb's law that are pulled sticking."""
    return float((_pulls(modes, "coulomb").consistent.sel(mode="STICK") > 0).sum())


def slipping_pulls(modes: xr.Dataset) -> float:
    """Number of these that are also pulled slipping."""
    slips = _pulls(modes, "coulomb").consistent.sel(mode=SLIPS).sum("mode")
    return float((slips > 0).sum())


def _without_solution(modes: xr.Dataset) -> xr.DataArray:
    """Directions of the pusher without solution: friction alone, rod of length 2, definition 2."""
    one = modes.outcome.sel(
        effects=FRICTION, contact="infinite_friction_none", rod_length=2.0
    ).isel(pusher_magnitude=0)
    angles: xr.DataArray = one.pusher_angle[one.values == int(Outcome.INCONSISTENT)]
    return angles


def first_without_solution(modes: xr.Dataset) -> float:
    """Least pusher angle of the grid without any solution."""
    return float(_without_solution(modes).min())


def last_without_solution(modes: xr.Dataset) -> float:
    """Largest pusher angle of the grid without any solution."""
    return float(_without_solution(modes).max())


def furthest_pull(modes: xr.Dataset, contact: str, magnitude: float) -> float:
    """Least pusher angle of the grid at which the contact can stick, with both effects."""
    one = modes.consistent.sel(effects=BOTH, contact=contact, rod_length=2.0)
    one = one.sel(pusher_magnitude=magnitude, mode="STICK")
    return float(one.pusher_angle[one.values > 0].min())


def conservative_excess(centers: xr.Dataset, side: str) -> float:
    """Angle that the conservative cone adds to the exact one, rod of length 5."""
    one = centers.sel(rod_length=5.0)
    return float(abs(one[f"conservative_cone_{side}"] - one[f"exact_cone_{side}"]))
