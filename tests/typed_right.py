"""A user's script that a type checker takes: the comments say which types it finds."""

import math
from collections.abc import Callable
from typing import reveal_type

import numpy as np
import xarray as xr

import planar_pushing as pp

scene = pp.Scene(
    slider=pp.Slider(rod_length=2, rod_angle=0.8),
    contact=pp.Coulomb(2.0),
    effects=(pp.RingFriction(weight=3), pp.Inertia()),
)
laws = np.array([pp.Coulomb(1.0), pp.PerfectlyRough()], dtype=object)
pp.Scene(slider=scene.slider, contact=laws, effects=scene.effects)
pp.Scene(slider=scene.slider, contact=xr.DataArray(laws, dims="law"), effects=scene.effects)
pp.InfiniteFriction("none")
pp.Coulomb(1), pp.Coulomb(np.float32(1.0)), pp.Coulomb([0.1, 0.2]), pp.Coulomb(np.ones(3))
pp.Coulomb(xr.DataArray(np.ones(3), dims="law"))
floats = np.linspace(0.0, 1.0, 3)
labeled = xr.DataArray(floats, dims="push")

reveal_type(pp.solve(scene, 1))  # Solutions
reveal_type(pp.solve(scene, np.float64(1.0)))  # Solutions
reveal_type(pp.solve(scene))  # Solutions
reveal_type(pp.solve(scene, 1.0, 2.0))  # Solutions
reveal_type(pp.solve(scene, math.radians(90), 0.05))  # Solutions
reveal_type(pp.solve(scene, floats))  # SolutionArrays
reveal_type(pp.solve(scene, np.array([1.0])))  # SolutionArrays
reveal_type(pp.solve(scene, [0.1, 1.0], 2.0))  # SolutionArrays
reveal_type(pp.solve(scene, 1.0, floats))  # SolutionArrays
reveal_type(pp.solve(scene, labeled))  # Dataset
reveal_type(pp.solve(scene, 1.0, labeled))  # Dataset
reveal_type(pp.solve(scene, labeled, floats))  # Dataset

found = pp.solve(scene, 1.0)
reveal_type(found[0])  # Solution
reveal_type(found[1:])  # tuple[Solution, ...]
reveal_type(found.of(pp.ContactMode.STICK))  # tuple[Solution, ...]
reveal_type(found.outcome)  # Outcome
reveal_type(found[0].mode)  # ContactMode
reveal_type(found[0].force)  # Array
reveal_type(found.to_json())  # str
reveal_type(pp.solve(scene, floats).to_dataset(["push"]))  # Dataset

reveal_type(pp.motion_angle(scene, 1.0, 0.5))  # float
reveal_type(pp.motion_angle(scene, floats, 0.5))  # Array
reveal_type(pp.motion_angle(scene, 1.0, [0.0, 0.5]))  # Array
reveal_type(pp.spin_ratio(scene, 1.0, force_ratio=2.0))  # float
reveal_type(pp.spin_ratio(scene, 1.0, force_ratio=floats))  # Array
reveal_type(pp.spin_ratio(scene, labeled, 0.5))  # DataArray
reveal_type(pp.spin_ratio(scene, floats, labeled))  # DataArray
reveal_type(pp.spin_ratio(scene, 1.0, force_ratio=labeled))  # DataArray
reveal_type(pp.motion_centers(scene, 1.0, 0.5))  # Array
reveal_type(pp.motion_centers(scene, 1.0, 0.5, "slider-center"))  # Array
reveal_type(pp.motion_centers(scene, labeled, 0.5))  # DataArray
reveal_type(pp.motion_centers(scene, 1.0, labeled))  # DataArray
reveal_type(pp.limit_curve(scene, 1.0))  # LimitCurve
reveal_type(pp.limit_curve(scene, floats))  # LimitCurve
reveal_type(pp.limit_curve(scene, labeled))  # Dataset

reveal_type(pp.motion_cone(scene))  # AngleInterval
reveal_type(pp.friction_cone(scene))  # AngleInterval
reveal_type(pp.conservative_motion_cone(scene))  # AngleInterval
reveal_type(pp.can_pull(scene))  # bool
reveal_type(pp.slips_while_pushing(scene))  # bool
reveal_type(pp.stable(scene, (0.0, 1, np.float64(0.0))))  # bool
reveal_type(pp.stable(scene, [0.0, 1.0, 0.0]))  # bool
reveal_type(pp.stable(scene, [(0.0, 1.0, 0.0)]))  # ndarray[tuple[Any, ...], dtype[bool[bool]]]
reveal_type(pp.stable(scene, floats))  # bool | ndarray[tuple[Any, ...], dtype[bool[bool]]]

pusher = pp.Pusher(velocity=(0.0, 1.0), shape="finger")
log = pp.simulate(scene, pusher=pusher, duration=1.0, method="time-stepping", on_ambiguity="stick")
reveal_type(log)  # Dataset
pp.simulate(scene, pusher=pusher, duration=1.0, on_ambiguity=[(0.0, "stick"), (1.0, "slip-left")])
pp.simulate_batch(scene, pusher, duration=floats, on_ambiguity="separate")
solver: Callable[[pp.Scene, float], pp.Solutions] = pp.solve
