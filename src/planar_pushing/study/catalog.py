"""The datasets: what each holds, which grid axes it reads, and labels; read without importing xarray."""

from __future__ import annotations

#: What each dataset holds.
DATASETS = {
    "limit_curves": "force and motion along the limit curves",
    "motion_cones": "friction cones and motion cones",
    "contact_modes": "consistent contact modes over the pusher's motion",
    "acceleration_centers": "motion centres with friction and inertia, exact and conservative",
    "scenes": "the scenes of the figures, one group each",
}

#: Folder of the logs of motion over time.
SIMULATIONS = "simulations"

#: The dimensions of each.
DIMS: dict[str, tuple[str, ...]] = {
    "limit_curves": ("effects", "rod_length", "rod_angle", "force_angle"),
    "motion_cones": ("effects", "rod_length", "rod_angle", "friction_coefficient"),
    "contact_modes": (
        "effects", "contact", "rod_length", "pusher_magnitude", "pusher_angle", "mode",
    ),
    "acceleration_centers": ("rod_length", "force_angle", "inertia_share"),
}  # fmt: skip

#: The grid axis that a dimension without one of its name reads.
_GRID = {"contact": ("contact_friction_coefficient",), "mode": ()}
#: The grid axes that each reads.
AXES: dict[str, tuple[str, ...]] = {
    name: tuple(axis for dim in dims for axis in _GRID.get(dim, (dim,)))
    for name, dims in DIMS.items()
}


def dataset_file(name: str) -> str:
    """File in the results that holds a dataset: scenes share one file, simulations have one each."""
    stem = name if name.startswith(f"{SIMULATIONS}/") else name.partition("/")[0]
    return f"data/{stem}.nc"


def number_label(number: float) -> str:
    """The shortest text that no other double has: 1.4, 2 or 1.4000001."""
    return repr(float(number)).removesuffix(".0")
