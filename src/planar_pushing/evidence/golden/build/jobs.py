"""The golden files of a study: what each is computed from, as jobs for one or several processes."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import xarray as xr

from planar_pushing.certified.contact import modes
from planar_pushing.evidence.golden.build import generate, pictures, plotted
from planar_pushing.evidence.golden.build.sliders import write as sliders

Study = plotted.Study
#: Builds a golden file on a number of processes.
Job = Callable[[int], xr.Dataset]

#: Step of the angles of the golden grid, degrees.
STEP = 15
#: Coefficients of friction of the certified contact modes, where the study has them.
COEFFICIENTS = (0.0, 0.5, 1.0, 1.25, 1.3, 1.4, 1.5, 2.0, 5.0, 100.0, float("inf"))


def contacts(coefficients: tuple[float, ...]) -> dict[str, tuple[str, modes.Law]]:
    """Contact laws by the labels of the datasets."""
    numbers = {mu: repr(float(mu)).removesuffix(".0") for mu in coefficients}
    coulomb = {f"coulomb_{n}": ("coulomb", modes.coulomb(mu)) for mu, n in numbers.items()}
    return coulomb | {
        "infinite_friction_free": ("infinite_friction", modes.INFINITE_FREE),
        "infinite_friction_none": ("infinite_friction", modes.INFINITE_NONE),
        "perfectly_rough": ("perfectly_rough", modes.PERFECTLY_ROUGH),
    }


def golden_jobs(study: Study) -> Iterator[tuple[str, Job]]:
    """Name and job of every golden file of a study of either kind, given as plain values."""
    if "supports" in study:
        yield from _slider_jobs(study).items()
        return
    for name, job in _dataset_jobs(study).items():
        yield name, job
    for name in study["scenes"]:
        yield f"scenes.{name}", partial(_alone, pictures.scene, name, study)
    for name in pictures.FIGURES:
        yield name, partial(_alone, pictures.figure, name, study)


def _alone(build: Callable[[str, Study], xr.Dataset], name: str, study: Study, _: int) -> Any:
    return build(name, study)


def _slider_jobs(study: Study) -> dict[str, Job]:
    return {
        "supports": partial(sliders.supports, study),
        "support_cones": partial(sliders.cones, study),
        "support_modes": partial(sliders.modes, study),
    }


def _dataset_jobs(study: Study) -> dict[str, Job]:
    grid, parameters = study["grid"], plotted.parameters(study)
    psi = study["slider"]["rod_angle"]
    coarse = {"force_angle": [phi for phi in grid["force_angle"] if phi % STEP == 0]}
    half = {"force_angle": [phi for phi in coarse["force_angle"] if 0 <= phi <= 180]}
    near = {
        "pusher_angle": [a for a in grid["pusher_angle"] if a % STEP == 0 or abs(a) in (1, 179)]
    }
    laws = {
        label: (kind, law)
        for label, (kind, law) in study["contacts"].items()
        if law.friction_coefficient in COEFFICIENTS
    }
    centers, pushes = (grid | half, psi, parameters), (grid | near, laws, psi, parameters)
    return {
        "limit_curves": partial(generate.limit_curves, grid | coarse, parameters),
        "motion_cones": partial(generate.motion_cones, grid, parameters),
        "acceleration_centers": partial(generate.acceleration_centers, *centers),
        "center_regions": partial(generate.center_regions, grid | half, parameters),
        "contact_modes": partial(generate.contact_modes, *pushes),
    }
