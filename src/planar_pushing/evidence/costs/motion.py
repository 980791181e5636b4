"""Cost of accuracy over time: both integrators against certified motion, slipping and pulling."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, partial
from typing import Any

import numpy as np
from flint import fmpq

from planar_pushing.certified.balls import in_degrees, precise
from planar_pushing.certified.motion.trajectories import Instant, pulled, slipping
from planar_pushing.evidence.costs.timing import seconds
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene
from planar_pushing.simulation.simulate import simulate
from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.study.simulations import arguments
from planar_pushing.terms.errors import InvalidFile

#: Scene files, and what certifies their motion.
SCENES: dict[str, tuple[str, Callable[..., list[Instant]]]] = {
    "slipping": ("workflow/scenes/figure_15.yaml", slipping),
    "pulling": ("workflow/scenes/figure_14a.yaml", pulled),
}
#: Methods, and the argument of `simulate` that sets their accuracy: a tolerance, or steps in a run.
TOLERANCES = tuple(10.0 ** -np.arange(4, 13, 2))
STEPS = (10.0, 30.0, 100.0, 300.0, 1000.0, 3000.0)
SETTINGS = {"event-driven": TOLERANCES, "time-stepping": STEPS}
ROWS = [(name, setting) for name, settings in SETTINGS.items() for setting in settings]


@cache
@precise
def reference(scene: str) -> tuple[float, float]:
    """Certified rod angle at the end in degrees, in two parts whose sum it is."""
    path, certify = SCENES[scene]
    file = load_scene_file(path).model_dump()
    duration = fmpq(*float(file["simulate"]["duration"]).as_integer_ratio())
    angle = in_degrees(certify(file, [duration])[-1].angle)
    high = float(angle.mid())
    return high, float((angle - high).mid())


def run(scene: str, method: str, setting: float) -> Any:
    """Log of a scene under a method: its ends alone."""
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


def errors() -> tuple[Array, Array]:
    """Error of the last rod angle in degrees, and evaluations of the friction, shape (row, scene)."""
    error, count = np.empty((2, len(ROWS), len(SCENES)))
    for i, (method, setting) in enumerate(ROWS):
        for j, scene in enumerate(SCENES):
            log, (high, low) = run(scene, method, setting), reference(scene)
            error[i, j] = abs((float(log.rod_angle[-1]) - high) - low)
            count[i, j] = float(log.evaluations[-1].sum())
    return error, count


def times() -> Array:
    """Seconds for a run, shape (row, scene, repeat)."""
    calls = [partial(run, scene, *row) for row in ROWS for scene in SCENES]
    return seconds(calls, 5).reshape(len(ROWS), len(SCENES), -1)
