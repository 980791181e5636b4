"""Cost of accuracy over time: both integrators compared with certified motion, for slipping and pulling."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import xarray as xr
from flint import fmpq

from planar_pushing.certified.balls import in_degrees, precise
from planar_pushing.certified.motion.instants import Instant
from planar_pushing.certified.motion.trajectories import pulled, slipping
from planar_pushing.evidence.costs.tables import labeled
from planar_pushing.mechanics.scene import Scene
from planar_pushing.simulation.simulate import simulate
from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.study.simulations import arguments
from planar_pushing.terms.errors import InvalidFile

#: Scene files, and the functions that certify their motion.
SCENES: dict[str, tuple[str, Callable[..., list[Instant]]]] = {
    "slipping": ("workflow/scenes/figure_15.yaml", slipping),
    "pulling": ("workflow/scenes/figure_14a.yaml", pulled),
}
#: Methods, and the settings of their accuracy: a tolerance, or the number of steps in a run.
SETTINGS = {
    "event-driven": tuple(10.0 ** -np.arange(4, 13, 2)),
    "time-stepping": (10.0, 30.0, 100.0, 300.0, 1000.0, 3000.0),
}
ROWS = [(name, float(setting)) for name, settings in SETTINGS.items() for setting in settings]


@cache
@precise
def reference(scene: str) -> tuple[float, float]:
    """Certified rod angle at the end in degrees, as the sum of two doubles."""
    path, certify = SCENES[scene]
    file = load_scene_file(path).model_dump()
    duration = fmpq(*float(file["simulate"]["duration"]).as_integer_ratio())
    angle = in_degrees(certify(file, [duration])[-1].angle)
    high = float(angle.mid())
    return high, float((angle - high).mid())


def run(scene: str, method: str, setting: float) -> Any:
    """Log of a scene by a method, with only its first and last instant."""
    built, given = _problem(scene)
    tolerance = {"rtol": setting} if method == "event-driven" else {}
    step = {"step": given["duration"] / setting} if method == "time-stepping" else {}
    return simulate(built, **{**given, "method": method, **tolerance, **step})


@cache
def _problem(scene: str) -> tuple[Scene, dict[str, Any]]:
    """Scene and arguments of `simulate` from a scene file."""
    file = load_scene_file(SCENES[scene][0])
    if file.simulate is None:
        raise InvalidFile(f"{SCENES[scene][0]}: has no section simulate; add it")
    return file.build(), {**arguments(file.simulate), "samples": 2}


def motion_errors() -> xr.Dataset:
    """Error of the last rod angle and evaluations of the motion, over `point` and `scene`.

    Each point is a setting of an integrator, given by the coordinates along it.
    """
    error, count = np.empty((2, len(ROWS), len(SCENES)))
    for i, row in enumerate(ROWS):
        for j, scene in enumerate(SCENES):
            log, (high, low) = run(scene, *row), reference(scene)
            error[i, j] = abs((float(log.rod_angle[-1]) - high) - low)
            count[i, j] = float(log.evaluations[-1].sum())
    names, settings = map(list, zip(*ROWS, strict=True))
    return labeled(
        {
            "motion_error": (("point", "scene"), error),
            "evaluations": (("point", "scene"), count),
        },
        {
            "method": ("point", names),
            "setting": ("point", settings),
            "counted": ("point", ["motion"] * len(ROWS)),
            "scene": list(SCENES),
        },
        "Motion over time",
    )
