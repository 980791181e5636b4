"""The datasets: what each holds, which grid axes it reads, and where; read without importing xarray."""

from __future__ import annotations

import re
from collections.abc import Iterable

from planar_pushing.terms.errors import InvalidValue

#: What each dataset of a study holds.
DATASETS = {
    "limit_curves": "force and motion along the limit curves",
    "motion_cones": "friction cones and motion cones",
    "contact_modes": "consistent contact modes over the pusher's motion",
    "acceleration_centers": "motion centres with friction and inertia, exact and conservative",
    "center_regions": "regions of acceleration centres, the paper's bound and the exact set",
    "scenes": "the scenes of the figures, one group each",
}

#: What each dataset of a study of sliders holds.
SLIDERS = {
    "supports": "wrench over centres of rotation, and the ellipsoid in the place of each support",
    "support_cones": "motion cones of each support, and what their edges pivot about",
    "support_modes": "consistent contact modes of each support over the pusher's motion",
}

#: Folder of the logs of motion over time.
SIMULATIONS = "simulations"
#: Folder of the numbers that the figures plot.
FIGURES = "figures"
#: The folders of both in the results: a file for each name.
FOLDERS = {SIMULATIONS: "data/simulations", FIGURES: "figures/data"}

#: Datasets on how this work computes: what each holds; `accuracy_time` differs from run to run.
EVIDENCE = {
    "accuracy_errors": "errors and evaluations of every method, a group for each quantity",
    "accuracy_time": "errors of the methods for the friction wrench and their times on one machine",
    "evaluations": "functions of each effect in machine code, and its evaluations over time",
    "hard_cases": "results in doubles against references of 40 digits, where numbers get hard",
}
#: Those that hold times of one machine and are written by `snakemake accuracy` alone.
TIMES = {
    "accuracy": "what accuracy costs: errors, evaluations and times, a group for each quantity",
    "effects": "times of each set of effects",
}

#: The tables beside them: what each file holds.
TABLES = {
    "golden_verdict.json": "the comparison with the golden data, every variable",
    "golden_verdict.txt": "the same to read, worst first",
    "golden_summary.csv": "the same in short, by dataset",
    "claims.json": "every claim of the ledger with its verdict, value and margin",
    "claims.csv": "the same as a table",
    "numbers.json": "the numbers of the report's prose, each with its unit and where it was read",
    "figures.json": "captions and margins of the figures",
    "infinite_friction_cones.csv": "motion cones of infinite friction by rod length, degrees",
    "provenance.csv": "the study and the versions of what computed the results",
    "accuracy_wrench.csv": "methods for the friction wrench: setting, calls and worst error",
    "accuracy_cone.csv": "methods for motion cones: setting, calls and largest error",
    "hard_places.csv": "hard cases by place, with their errors in units in the last place",
    "hard_ill.csv": "ill-conditioned cases: condition, digits left and error",
    "evaluations.csv": "functions of each effect in machine code, and its evaluations over time",
    "accuracy_numbers.json": "the numbers of the supplement on time, by `snakemake accuracy`",
    "times_effects.csv": "times of each set of effects, by `snakemake accuracy`",
    "times_scenes.csv": "times of each scene, by `snakemake accuracy`",
    "times_machine.csv": "the machine that they were measured on, by `snakemake accuracy`",
}

#: The dimensions of each.
DIMS: dict[str, tuple[str, ...]] = {
    "limit_curves": ("effects", "rod_length", "rod_angle", "force_angle"),
    "motion_cones": ("effects", "rod_length", "rod_angle", "friction_coefficient"),
    "contact_modes": (
        "effects", "contact", "rod_length", "pusher_magnitude", "pusher_angle", "mode",
    ),
    "acceleration_centers": ("rod_length", "force_angle", "inertia_share"),
    "center_regions": ("rod_length", "rod_angle", "force_angle", "bound_end", "exact_end"),
    "supports": ("support", "center_x", "center_y"),
    "support_cones": ("support", "rod_length", "rod_angle", "friction_coefficient", "edge"),
    "support_modes": (
        "support", "rod_length", "rod_angle", "friction_coefficient", "pusher_angle", "mode",
    ),
}  # fmt: skip

#: The grid axis that a dimension without one of its name reads.
_GRID = {
    "contact": ("contact_friction_coefficient",),
    **dict.fromkeys(("mode", "bound_end", "exact_end", "support", "edge"), ()),
}
#: Labels of the contact laws without a coefficient, behind those of Coulomb along `contact`.
CONTACT_LAWS = ("infinite_friction_free", "infinite_friction_none", "perfectly_rough")
#: The datasets that hold the force angles which push alone, those from 0 to 180 degrees.
PUSHES = ("acceleration_centers", "center_regions")


def _axes(names: Iterable[str]) -> dict[str, tuple[str, ...]]:
    return {
        name: tuple(axis for dim in DIMS[name] for axis in _GRID.get(dim, (dim,)))
        for name in names
        if name in DIMS
    }


#: The grid axes that each reads, of a study like the paper's and of a study of sliders.
AXES, SLIDERS_AXES = _axes(DATASETS), _axes(SLIDERS)
#: The dimensions of each along which it can be cut: those with an axis.
SPLIT: dict[str, tuple[str, ...]] = {
    name: tuple(dim for dim in DIMS[name] if _GRID.get(dim, (dim,))) for name in AXES
}
#: A name in a folder, or of a group or a study.
NAME = re.compile(r"[A-Za-z0-9_]+")


def dataset_place(name: str) -> tuple[str, str | None]:
    """File in the results that holds a dataset, and its group there.

    Parameters
    ----------
    name : str
        A dataset, "dataset/group", or a file of one of the folders, as "simulations/figure_15".

    Raises
    ------
    InvalidValue
        Where there is no dataset of this name.
    """
    stem, slash, part = name.partition("/") if isinstance(name, str) else ("", "", "")
    whole = DATASETS | SLIDERS | EVIDENCE | TIMES
    named = NAME.fullmatch(part) is not None
    if stem in FOLDERS and named:
        return f"{FOLDERS[stem]}/{part}.nc", None
    if stem in whole and (named or not slash):
        return f"data/{stem}.nc", part or None
    allowed = ", ".join([*whole, *(f"{folder}/NAME" for folder in FOLDERS)])
    raise InvalidValue("name", name, allowed, "name one of these datasets")


def dataset_file(name: str) -> str:
    """File in the results that holds a dataset; errors as in `dataset_place`."""
    return dataset_place(name)[0]


def contact_labels(coefficients: Iterable[float]) -> list[str]:
    """Labels along the axis `contact`: a law of Coulomb for each coefficient, then the others."""
    return [*(f"coulomb_{number_label(each)}" for each in coefficients), *CONTACT_LAWS]


def number_label(number: float) -> str:
    """The shortest text that no other double has: 1.4, 2 or 1.4000001."""
    return repr(float(number)).removesuffix(".0")
