"""The datasets: what each holds and which grid axes it reads; read without importing xarray."""

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

#: The grid axes that each reads.
AXES: dict[str, tuple[str, ...]] = {
    "limit_curves": ("effects", "rod_length", "rod_angle", "force_angle"),
    "motion_cones": ("effects", "rod_length", "rod_angle", "friction_coefficient"),
    "contact_modes": (
        *("effects", "contact_friction_coefficient", "rod_length"),
        *("pusher_magnitude", "pusher_angle"),
    ),
    "acceleration_centers": ("rod_length", "force_angle", "inertia_share"),
}


def dataset_file(name: str) -> str:
    """File in the results that holds a dataset: scenes share one file, simulations have one each."""
    stem = name if name.startswith(f"{SIMULATIONS}/") else name.partition("/")[0]
    return f"data/{stem}.nc"
