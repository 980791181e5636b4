"""Pivots of a tripod: the conditions of one, and the two ways to it."""

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.mechanics.effects.any_mass import MassAt
from planar_pushing.mechanics.effects.any_support import Supports
from planar_pushing.mechanics.effects.base import made
from planar_pushing.mechanics.reduced.line_of_force import Line
from planar_pushing.mechanics.reduced.pivots import NOWHERE, pivot_of, pivot_under
from planar_pushing.mechanics.supports.pressure.table import table_of

CORNERS = np.array(
    [(np.cos(a), np.sin(a)) for a in (np.pi / 2, 7 * np.pi / 6, 11 * np.pi / 6)]
)  # fmt: skip
TRIPOD = Supports(table_of([pp.Points(CORNERS, [1 / 3] * 3)]))
ROW = np.array([1.5, 0.8, 0.3, 0.1, -0.2, 0.0, 1.0])
FRICTION, LENGTH = made((TRIPOD,), ROW), 0.7
BOTH = made((TRIPOD, MassAt(1.0, 1.0, 0.0, 0.0)), ROW)
CONTACT = np.array([-LENGTH, 0.0])


def about(i, spin=1.0):
    """Motion of the contact in a rotation about a corner."""
    return spin * np.array([CORNERS[i, 1] - CONTACT[1], CONTACT[0] - CORNERS[i, 0]])


def of_the_others(i, spin):
    """Force of two points that slide about the third, and their torque about the contact."""
    apart = np.delete(CORNERS, i, axis=0)
    away = apart - CORNERS[i]
    forces = 0.5 * np.sign(spin) * np.column_stack([-away[:, 1], away[:, 0]])
    forces /= np.hypot(*away.T)[:, None]
    levers = apart - CONTACT
    return forces.sum(axis=0), (levers[:, 0] * forces[:, 1] - levers[:, 1] * forces[:, 0]).sum()


@pytest.mark.parametrize("spin", [1.0, -2.0])
@pytest.mark.parametrize("i", range(3))
def test_the_corner_takes_the_rest_of_the_force_up_to_its_share(i, spin):
    found = pivot_of(FRICTION, LENGTH, *about(i, spin))
    sliding, torque = of_the_others(i, spin)
    lever = CORNERS[i] - CONTACT
    part = -torque / np.hypot(*lever)  # across the lever, in the corner
    if abs(part) > 0.5:
        assert found.atom == NOWHERE
        return
    assert found.atom == i
    assert found.motion == pytest.approx((*about(i, spin), spin), rel=1e-14, abs=0)
    for end in (-1.0, 1.0):
        force = np.array([found.f_x + end * found.free_x, found.f_y + end * found.free_y])
        own = force - sliding
        assert np.hypot(*own) == pytest.approx(0.5, rel=1e-13, abs=0)
        assert lever[0] * own[1] - lever[1] * own[0] + torque == pytest.approx(0, abs=1e-14)


def test_some_corner_is_a_pivot():
    found = [pivot_of(FRICTION, LENGTH, *about(i)).atom for i in range(3)]
    assert any(atom != NOWHERE for atom in found)


@pytest.mark.parametrize("effects", [FRICTION, BOTH], ids=["friction", "both"])
def test_every_force_of_the_interval_leads_to_the_same_pivot(effects):
    """The line of force and the motion of the contact find each other."""
    (i,) = [i for i in range(3) if pivot_of(effects, LENGTH, *about(i, 0.3)).atom == i][:1]
    known = pivot_of(effects, LENGTH, *about(i, 0.3))
    for part in (-0.99, -0.3, 0.0, 0.5, 0.99):
        force = np.array([known.f_x + part * known.free_x, known.f_y + part * known.free_y])
        towards = force / np.hypot(*force)
        along = float(towards @ about(i, 0.3))
        found = pivot_under(effects, Line(effects, LENGTH, *towards, along))
        assert found.atom == i
        assert found.motion == pytest.approx(known.motion, rel=1e-12, abs=0)
        assert (found.f_x, found.f_y) == pytest.approx(tuple(force), rel=1e-12, abs=0)


def test_other_motions_and_lines_have_no_pivot():
    x, y = about(0)
    assert pivot_of(FRICTION, LENGTH, x + 1e-9, y + 1e-9).atom == NOWHERE
    beside = Line(FRICTION, LENGTH, 1.0, 0.0, 1.0)  # through the centre: a translation
    assert pivot_under(FRICTION, beside).atom == NOWHERE


def test_a_mass_has_no_points():
    mass = (MassAt(1.0, 1.0, 0.0, 0.0),)
    assert pivot_of(mass, LENGTH, *about(0)).atom == NOWHERE
    assert pivot_under(mass, Line(mass, LENGTH, 0.0, 1.0, 1.0)).atom == NOWHERE
