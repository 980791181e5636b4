"""The solution of a scene that its picture shows, and what it shows of it."""

from __future__ import annotations

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import ContactMode

#: Variables of a scene dataset that its picture shows.
PLOTTED = (
    "rod_length",
    "rod_angle",
    "radius",
    "ring_center",
    "friction_cone_right",
    "friction_cone_left",
    "motion_cone_right",
    "motion_cone_left",
    "pusher_motion",
    "outcome",
    "mode",
    "adhesive",
    "force",
    "contact_motion",
    "spin_ratio",
    "center",
)
#: What else it shows: friction around the ring, or at places of any support, pivots, the limit curve.
MORE = (
    "support_force", "place_position", "place_force", "force_end", "pivot", "limit_force",
    "limit_motion_angle",
)  # fmt: skip


def shown(dataset: xr.Dataset) -> xr.Dataset:
    """Select the solution to draw: the sticking one, else the first that moves, else the first.

    Parameters
    ----------
    dataset : xarray.Dataset
        A scene's dataset, or what this function made of one.

    Returns
    -------
    xarray.Dataset
        The plotted variables; ``solution`` has one entry, or none where no solution is consistent.
    """
    modes = dataset["mode"].values
    ranks = np.select([modes == ContactMode.STICK, modes != ContactMode.SEPARATE], [0, 1], 2)
    best = np.argsort(ranks, kind="stable")[:1]
    more = [name for name in MORE if name in dataset]
    chosen = dataset[[*PLOTTED, *more, "effect"]].isel(solution=best)
    return chosen.assign_attrs(title=dataset.attrs.get("title", ""))
