"""Scenes and pushes as flat arrays, read from the fields of the package's public dataclasses."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from mechanics.friction_transcription import Pressure, pressure_of

import planar_pushing as pp


@dataclass(frozen=True)
class Problem:
    """Scenes and pushes as flat arrays; edges of the cone and the pusher's motion are vectors.

    `load` is the wrench of all loads about the slider's origin, in the body frame.
    """

    pressure: Pressure | None
    length: Any
    psi: Any
    weight: Any
    mass: Any
    gyration: Any
    mass_center: Any
    load: Any
    right: Any
    left: Any
    slips: Any
    closed: Any
    rough: Any
    pusher: Any

    def __len__(self):
        return len(self.length)

    def __getitem__(self, rows):
        values = [getattr(self, each.name)[rows] for each in fields(self)[1:]]
        return Problem(self.pressure, *values)

    @property
    def extent(self):
        """Largest distance of what resists from the slider's origin, at least."""
        own = np.hypot(*self.mass_center.T) + np.where(self.mass > 0, self.gyration, 0.0)
        if self.pressure is None:
            return own
        return np.maximum(own, self.pressure.extent + np.hypot(*self.pressure.center))


def cross(one, other):
    return one[..., 0] * other[..., 1] - one[..., 1] * other[..., 0]


def size_of(vector):
    return np.hypot(vector[..., 0], vector[..., 1])


def unit(angle):
    """Cosine and sine; the double that is nearest to a multiple of 90 degrees stands for it."""
    c, s = np.cos(angle), np.sin(angle)
    right = np.isin(np.abs(angle), (0.0, np.pi / 2, np.pi))
    return np.where(right, np.rint(c), c), np.where(right, np.rint(s), s)


def turned(vector, angle):
    """Vectors turned by angles."""
    c, s = unit(angle)
    x, y = vector[..., 0], vector[..., 1]
    return np.stack([c * x - s * y, s * x + c * y], axis=-1)


def problem_of(scene, angle, magnitude=1.0):
    """A scene, or an array of scenes of one support, with its pushes; friction and inertia at most once."""
    loads = [each for each in scene.effects if isinstance(each, pp.Load)]
    friction = [each for each in scene.effects if not isinstance(each, pp.Inertia | pp.Load)]
    masses = [each for each in scene.effects if isinstance(each, pp.Inertia)] or [
        pp.Inertia(mass=1.0, gyration_radius=1.0, center=(0.0, 0.0))
    ]
    absent = 0.0 if len(masses) + len(friction) + len(loads) > len(scene.effects) else 1.0
    given = [
        scene.slider.rod_length, scene.slider.rod_angle,
        friction[0].weight if friction else 0.0, absent * np.asarray(masses[0].mass),
        masses[0].gyration_radius, *masses[0].center, angle, magnitude,
    ]  # fmt: skip
    for each in loads:
        given += [*each.force, *(each.center or masses[0].center)]
    laws = np.asarray(scene.contact, dtype=object)
    mu = laws.item().friction_coefficient if _is_one_coulomb(laws) else 0.0
    shape = np.broadcast_shapes(laws.shape, np.shape(mu), *map(np.shape, given))
    columns = [np.broadcast_to(each, shape).ravel().astype(float) for each in given]
    length, psi, weight, mass, gyration, x, y, angle, magnitude = columns[:9]
    wrench = np.zeros((len(length), 3))
    for i in range(9, len(columns), 4):
        g_x, g_y, place_x, place_y = columns[i : i + 4]
        g_x, g_y = turned(np.stack([g_x, g_y], axis=-1), -psi).T
        wrench += np.stack([g_x, g_y, place_x * g_y - place_y * g_x], axis=-1)
    pusher = magnitude[:, None] * np.stack(unit(angle), axis=-1)
    pressure = pressure_of(friction[0].support, scene.slider.radius) if friction else None
    law = _law_of(laws, shape, mu)
    return Problem(
        pressure,
        length,
        psi,
        weight,
        mass,
        gyration,
        np.stack([x, y], axis=-1),
        wrench,
        *law,
        pusher,
    )


def _is_one_coulomb(laws):
    return laws.ndim == 0 and isinstance(laws.item(), pp.Coulomb)


def _law_of(laws, shape, mu):
    """Edges of the cone, whether it slips at them, whether it is closed, and whether it is rough."""
    each = np.broadcast_to(laws, shape).ravel()
    coulomb = np.array([isinstance(law, pp.Coulomb) for law in each], dtype=bool)
    rough = np.array([isinstance(law, pp.PerfectlyRough) for law in each], dtype=bool)
    free = np.array([getattr(law, "at_zero_normal", "free") == "free" for law in each], dtype=bool)
    if _is_one_coulomb(laws):
        mu = np.broadcast_to(mu, shape).ravel()
    else:
        mu = np.array([getattr(law, "friction_coefficient", 0.0) for law in each])
    x, y = np.where(coulomb, mu, 1.0), np.where(coulomb, 1.0, 0.0)
    x, y = x / np.hypot(x, y), y / np.hypot(x, y)
    right, left = np.stack([x, y], axis=-1), np.stack([-x, y], axis=-1)
    return right, left, ~rough & free, ~rough & free, rough
