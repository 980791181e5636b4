"""Simulations in one line, for the tests."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np

import planar_pushing as pp


def run_slow_uncompiled(file):
    """Run the slow tests of a file without the compiler; what pytest said of each.

    The compiler takes up to two minutes for the events of a set of effects, and a run without it a second:
    so the sets that `planar-pushing compile` leaves out are slow, and are run compiled by `make test-all`.
    """
    found = subprocess.run(
        [sys.executable, "-m", "pytest", "-vv", "-p", "no:cacheprovider", "-m", "slow", file],
        capture_output=True, text=True, check=False, cwd=Path(__file__).parents[2],
        env=os.environ | {"NUMBA_DISABLE_JIT": "1", "PYTHONPATH": os.pathsep.join(sys.path)},
    )  # fmt: skip
    assert found.returncode == 0, found.stdout[-3000:]
    return found.stdout


def heading(degrees, speed=1.0):
    """A velocity by its angle."""
    angle = np.deg2rad(degrees)
    return speed * np.cos(angle), speed * np.sin(angle)


def run(scene, velocity, duration, **options):
    """The log of a simulation; `velocity` is what `Pusher` takes, or a pusher."""
    pusher = velocity if isinstance(velocity, pp.Pusher) else pp.Pusher(velocity=velocity)
    return pp.simulate(scene, pusher=pusher, duration=duration, **options)


def final(log, name):
    """Last value of a variable."""
    return log[name].values[-1]


def pose_at_the_end(log):
    """Last pose of the object in the world: x, y, and the angle in radians."""
    return np.append(final(log, "object_position"), np.deg2rad(final(log, "object_angle")))


def imbalance(log):
    """Work of the fence and of loads less the energy gained and dissipated, at every instant."""
    lost = log.dissipated.sum("effect") + log.contact_dissipated
    gained = log.kinetic_energy - log.kinetic_energy[0]
    work = log.work + log.load_work if "load_work" in log else log.work
    return np.abs((work - work[0] - gained - (lost - lost[0])).values)


def check(log, tolerance=1e-9):
    """What holds of every log: finite numbers, no penetration, energy, and an end that is explained."""
    for name, variable in log.data_vars.items():
        if variable.dtype.kind == "f" and name != "spin_ratio":
            assert np.isfinite(variable).all(), name
    assert not np.isnan(log.spin_ratio).any()
    assert log.gap.min() >= -tolerance
    assert np.all(np.diff(log.time) >= 0)
    scale = 1 + float(np.abs(log.work).max()) + float(log.kinetic_energy.max())
    assert imbalance(log).max() <= tolerance * scale
    reached = log.time.values[-1] == log.attrs["duration"]
    assert reached != bool(log.attrs["stopped"])
    return log
