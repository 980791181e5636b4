"""Contacts that are refused: one line that says what was given, what is allowed, and what to do."""

from __future__ import annotations

import numpy as np
import pytest

import planar_pushing as pp

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
EFFECTS = [pp.SupportFriction(support=pp.Polygon(SQUARE))]
LAW = pp.Coulomb(0.5)
FINGER = pp.Contact((-1, 0.3), law=LAW, velocity=(1, 0))
TEE = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"point": (0, 0)}, "law: None given; allowed: Coulomb"),
        ({"law": LAW}, "point: None given; allowed: either a point or a side"),
        ({"point": (0, 0), "side": 1, "law": LAW}, "point: .* either a point or a side"),
        ({"side": 1, "normal": (0, 1), "law": LAW}, "normal: .* none together with a side"),
        (
            {"point": (0, 0), "law": LAW, "velocity": (1, 0), "twist": (1, 0, 0)},
            "twist: .* either a velocity or a twist",
        ),
        ({"point": (0, 0), "law": LAW, "velocity": (1, 0, 0)}, r"velocity: .* \(v_x, v_y\)"),
        ({"point": (0, 0), "law": LAW, "velocity": (np.nan, 0)}, "velocity: .* finite"),
        ({"point": (0, 0), "law": LAW, "twist": (1, 0)}, r"twist: .* \(v_x, v_y, omega\)"),
        ({"point": (np.nan, 0), "law": LAW}, "point: .* finite"),
        ({"point": [(0, 0), (1, 1)], "law": LAW}, "point: .* a Contact for each point"),
        ({"point": (0, 0), "normal": (0, 0), "law": LAW}, "normal: .* a nonzero vector"),
    ],
)
def test_contacts_that_are_wrong_by_themselves(arguments, message):
    with pytest.raises(pp.InvalidValue, match=message):
        pp.Contact(**arguments)


@pytest.mark.parametrize(
    ("contacts", "message"),
    [
        ([], "contacts: .* a list of one to four Contact"),
        (FINGER, "contacts: .* a list of one to four Contact"),
        ([(-1, 0.3)], "contacts: .* a list of one to four Contact"),
        ([FINGER] * 2, "contacts: .* one normal"),
        (
            [pp.Contact((-1, y), law=LAW) for y in (-0.4, -0.2, 0, 0.2, 0.4)],
            "contacts: .* at most 4; a side is two",
        ),
        ([pp.Contact((0, 0), law=LAW)], "point: .* a point on the outline"),
        ([pp.Contact((-1, 0), (-1, 0), law=LAW)], "normal: .* the inward normal of the side"),
        ([pp.Contact((-1, -1), law=LAW)], "normal: None given"),
        ([pp.Contact(side=4, law=LAW)], "side: 4 given; allowed: a whole number from 0 to 3"),
        (
            [FINGER, pp.Contact((1, 0.3), law=LAW, velocity=(1, 0))],
            "contacts: .a squeeze between .* off the other's normal",
        ),
    ],
)
def test_contacts_that_do_not_fit_the_object_or_one_another(contacts, message):
    with pytest.raises(pp.InvalidValue, match=message):
        pp.solve_contacts(contacts, effects=EFFECTS, outline=SQUARE)


@pytest.mark.parametrize(
    ("contact", "message"),
    [
        (pp.Contact((-1, 0.3), law=LAW), r"normal: None given; allowed: \(n_x, n_y\) without an"),
        (pp.Contact(side=0, law=LAW), "outline: None given"),
    ],
)
def test_contacts_that_need_an_outline(contact, message):
    with pytest.raises(pp.InvalidValue, match=message):
        pp.solve_contacts([contact], effects=EFFECTS)


def test_arrays_that_do_not_broadcast():
    fast = pp.Contact((-1, 0.3), (1, 0), law=LAW, velocity=(np.ones(3), 0.0))
    slow = pp.Contact((0, 1), (0, -1), law=pp.Coulomb(np.array([0.1, 0.2])))
    with pytest.raises(pp.InvalidValue, match=r"shapes: .* broadcast"):
        pp.solve_contacts([fast, slow], effects=EFFECTS)


def test_loads_that_friction_cannot_hold():
    load = pp.Load(force=(0, -2), center=(0, 0))
    with pytest.raises(pp.InvalidValue, match=r"force: .* what friction can hold"):
        pp.solve_contacts([FINGER], effects=[*EFFECTS, load], outline=SQUARE)


def test_an_array_of_points_of_scene_at_is_an_array_of_scenes_and_says_so():
    scene = pp.scene_at([(-1, 0.3), (1, 0.3)], effects=EFFECTS, contact=LAW, outline=SQUARE)
    assert pp.solve(scene, np.pi / 2).shape == (2,)
    assert "solve_contacts" in pp.scene_at.__doc__
