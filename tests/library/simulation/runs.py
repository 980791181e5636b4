"""Simulations in one line, for the tests."""

from __future__ import annotations

import numpy as np

import planar_pushing as pp
from planar_pushing.simulation.early_end import quietly

#: l, mu, fence angle, psi0, T of a ring; published rod angle in degrees at the end, and slip.
REFERENCES = [
    (5, np.inf, 165, 45, 3, 33.49164319965058, 2.1514157444528927),
    (2, 2, 60, 45, 3, 6.511092064133266, -0.15251676648881093),
    (2, 2, 170, 45, 3, 29.673182764562068, 2.437240035590965),
    (1, 0.5, 20, 80, 2, 110.23885816124236, -1.0410568765402608),
]


def heading(degrees, speed=1.0):
    """A velocity by its angle."""
    angle = np.deg2rad(degrees)
    return speed * np.cos(angle), speed * np.sin(angle)


def run(scene, velocity, duration, **options):
    """The log of a simulation, also if it ends early; `velocity` is what `Pusher` takes, or a pusher."""
    pusher = velocity if isinstance(velocity, pp.Pusher) else pp.Pusher(velocity=velocity)
    return quietly(pp.simulate)(scene, pusher=pusher, duration=duration, **options)


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


def largest_energy(log):
    """The largest of the energies of a log that balance."""
    loads = float(np.abs(log.load_work).max()) if "load_work" in log else 0.0
    lost = float((log.dissipated.sum("effect") + log.contact_dissipated).max())
    return max(float(np.abs(log.work).max()), float(log.kinetic_energy.max()), lost, loads)


def check(log, tolerance=1e-9):
    """What holds of every log: finite numbers, no penetration, energy, and an end that is explained."""
    for name, variable in log.data_vars.items():
        if variable.dtype.kind == "f" and name != "spin_ratio":
            assert np.isfinite(variable).all(), name
    assert not np.isnan(log.spin_ratio).any()
    gap = log.gap.where(~log.parted, 0.0) if "parted" in log else log.gap
    assert gap.min() >= -tolerance
    assert np.all(np.diff(log.time) >= 0)
    scale = 1 + float(np.abs(log.work).max()) + float(log.kinetic_energy.max())
    assert imbalance(log).max() <= tolerance * scale
    reached = log.time.values[-1] == log.attrs["duration"]
    assert reached != bool(log.attrs["stopped"])
    return log
