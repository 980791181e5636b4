"""The solution of a scene that its picture shows, and what it shows of it."""

from __future__ import annotations

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import ContactMode, Outcome

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
#: What the contact does.
NAMES = {
    ContactMode.SEPARATE: "the contact breaks",
    ContactMode.STICK: "the contact sticks",
    ContactMode.SLIP_RIGHT: "slips to the right",
    ContactMode.SLIP_LEFT: "slips to the left",
}


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


def status(data: xr.Dataset) -> str:
    """Contact mode of the solution, whether the slider pivots, and whether others are consistent too."""
    if not data.sizes["solution"]:
        return "no consistent solution"
    mode = NAMES[ContactMode(int(data["mode"].values[0]))]
    pivots = ", the slider pivots" if "pivot" in data and data["pivot"].values[0] >= 0 else ""
    several = int(data["outcome"]) == Outcome.AMBIGUOUS
    return f"{mode}{pivots} (one of several solutions)" if several else f"{mode}{pivots}"
