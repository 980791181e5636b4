"""What leaving out inertia or friction changes in pushes of a box, over supports and speeds."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import Coulomb
from planar_pushing.mechanics.effects import Effect, Inertia, SupportFriction
from planar_pushing.mechanics.effects.support_friction import weight
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.supports import Polygon
from planar_pushing.objects.scene_at import scene_at
from planar_pushing.simulation.batch import simulate_batch
from planar_pushing.simulation.early_end import quietly
from planar_pushing.simulation.pusher import Pusher
from pulling_by_pushing.study.model import ModelErrors

#: Standard gravity, m/s^2.
GRAVITY = 9.80665
#: Instants of a run at which poses are compared.
SAMPLES = 101
#: Duration of a run after the finger has stopped, as a part of the time in which the box comes to rest.
REST = 1.5


def model_errors(part: ModelErrors) -> xr.Dataset:
    """Build the errors and the evaluations for the pushes of a study.

    A push has the same place and direction on each support and at each speed. A run ends when the finger
    has moved over the distance.
    """
    supports = {name: entry.build() for name, entry in part.supports.items()}
    place = xr.DataArray([push.place for push in part.pushes], dims="push")
    angle = xr.DataArray([push.pusher_angle for push in part.pushes], dims="push")
    dataset = xr.concat(
        [_errors(part, support, place, angle) for support in supports.values()],
        xr.Variable("support", list(supports)),
    )
    parameters = part.model_dump(exclude={"supports", "speed", "pushes"})
    described = {"place": place, "pusher_angle": angle, "gravity": GRAVITY}
    return dataset.assign_coords(parameters | described)


def effects_of(part: ModelErrors, support: Any) -> tuple[Effect, Effect]:
    """Friction and inertia of the box; its mass is uniform."""
    force = float(weight(part.mass, part.support_friction_coefficient, GRAVITY))
    gyration = float(np.hypot(part.length, part.width) / np.sqrt(12.0))
    friction = SupportFriction(support=support, weight=force)
    return friction, Inertia(mass=part.mass, gyration_radius=gyration)


def _errors(
    part: ModelErrors, support: Any, place: xr.DataArray, angle: xr.DataArray
) -> xr.Dataset:
    """Errors and evaluations of all pushes on a support."""
    friction, inertia = effects_of(part, support)
    speed = xr.DataArray(list(part.speed), dims="speed", coords={"speed": list(part.speed)})
    # With one effect alone, the box passes through the same poses at each speed.
    both = _push(part, (friction, inertia), place, angle, speed)
    others = [_push(part, (effect,), place, angle, part.distance) for effect in (friction, inertia)]
    left_out = xr.Variable("left_out", ["inertia", "friction"])
    return xr.Dataset(
        {
            "pose_error": xr.concat([_difference(part, both, run) for run in others], left_out),
            "evaluations": both["evaluations"].astype(float),
            "evaluations_alone": xr.concat(
                [run["evaluations"].astype(float) for run in others], left_out
            ),
            "coasting_error": ("speed", [_coasting_error(part, support, v) for v in part.speed]),
        },
        {"speed": speed},
    )


def _push(
    part: ModelErrors,
    effects: tuple[Effect, ...],
    place: xr.DataArray,
    angle: xr.DataArray,
    speed: Any,
) -> xr.Dataset:
    """Runs of pushes over the distance."""
    radians = np.deg2rad(angle)
    pusher = Pusher(velocity=(speed * np.cos(radians), speed * np.sin(radians)), shape="finger")
    point = xr.concat([place, xr.full_like(place, -part.width / 2.0)], "xy").transpose(..., "xy")
    return _run(_scene(part, effects, point), pusher, part.distance / speed)


def _coasting_error(part: ModelErrors, support: Any, speed: float) -> float:
    """Error without inertia of a push through the center by a finger that then stops."""
    friction, inertia = effects_of(part, support)
    stop = part.distance / speed
    pusher = Pusher(velocity=[(0.0, (0.0, speed)), (stop, (0.0, 0.0))], shape="finger")
    duration = stop + REST * speed / (part.support_friction_coefficient * GRAVITY)
    both, alone = (
        _run(_scene(part, effects, (0.0, -part.width / 2.0)), pusher, duration)
        for effects in ((friction, inertia), (friction,))
    )
    return float(_difference(part, both, alone).squeeze())


def _scene(part: ModelErrors, effects: tuple[Effect, ...], point: Any) -> Scene:
    """The box with a contact at one or more points of its side."""
    return scene_at(
        point,
        effects=effects,
        contact=Coulomb(part.friction_coefficient),
        outline=Polygon.rectangle(part.length, part.width),
    )


def _run(scene: Scene, pusher: Pusher, duration: Any) -> xr.Dataset:
    """Runs over parts of their duration, with the pose of the box, which is the world's at the start."""
    pose = (0.0, 0.0, 0.0)
    run: xr.Dataset = quietly(simulate_batch)(
        scene, pusher, duration=duration, samples=SAMPLES, object_pose=pose
    )
    return run.drop_vars(list(run.coords))


def _difference(part: ModelErrors, run: xr.Dataset, other: xr.Dataset) -> xr.DataArray:
    """Largest displacement of a corner of the box between two runs, over all instants."""
    away = _corners(part, run) - _corners(part, other)
    squares: xr.DataArray = (away**2).sum("xy").max(("corner", "part"))
    return squares**0.5


def _corners(part: ModelErrors, run: xr.Dataset) -> xr.DataArray:
    """Positions of the corners in the world."""
    signs: Array = np.array([(1, 1), (-1, 1), (-1, -1), (1, -1)])
    x, y = (xr.DataArray(size / 2.0 * side, dims="corner") for size, side in
            zip((part.length, part.width), signs.T, strict=True))  # fmt: skip
    angle = np.deg2rad(run["object_angle"])
    c, s = np.cos(angle), np.sin(angle)
    return run["object_position"] + xr.concat([x * c - y * s, x * s + y * c], "xy")
