"""Scenes in one line, for the tests."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

import planar_pushing as pp

PSI = np.pi / 4
INFINITE = pp.InfiniteFriction()
DEFINITION_2 = pp.InfiniteFriction(at_zero_normal="none")
FRICTION = (pp.RingFriction(),)
INERTIA = (pp.Inertia(),)
BOTH = FRICTION + INERTIA
EFFECT_SETS = {"friction": FRICTION, "inertia": INERTIA, "both": BOTH}
EVERY_EFFECT = pytest.mark.parametrize("effects", EFFECT_SETS.values(), ids=EFFECT_SETS)


def make_scene(length, contact=INFINITE, effects=FRICTION, psi=PSI, radius=1.0):
    """A scene; a bare number as `contact` is a friction coefficient, inf included."""
    if np.asarray(contact).dtype != object:
        contact = INFINITE if np.isinf(contact) else pp.Coulomb(contact)
    slider = pp.Slider(rod_length=length, rod_angle=psi, radius=radius)
    return pp.Scene(slider=slider, contact=contact, effects=tuple(effects))


def names(solutions):
    """Names of the modes that were found."""
    return [mode.name for mode in solutions.modes]


def numbers(solutions):
    """Every number in the solutions but the centers, which are infinite for a translation."""
    return np.array(
        [[*s.force, *s.contact_motion, *s.twist, s.spin_ratio] for s in solutions], dtype=float
    )


def scaled(effect, factor):
    """The effect with its lengths multiplied by a factor."""
    if not isinstance(effect, pp.Inertia):
        return effect
    return dataclasses.replace(effect, gyration_radius=factor * effect.gyration_radius)
