"""The check of float solutions: those of the core hold, and wrong ones do not."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import planar_pushing as pp
from certified.effects.check import check
from certified.effects.scenes import faults, push_of
from mechanics.degenerate import (
    EFFECTS,
    RANDOM,
    SYMMETRIC,
    degenerate,
    generic_arrays,
    random_support,
    regular,
)
from mechanics.degenerate import _single as single

KINDS = ("feet", *SYMMETRIC)
SLIDER = pp.Slider(rod_length=2.0, rod_angle=np.pi / 4, radius=1.0)
RING, MASS = pp.RingFriction(), pp.Inertia(mass=0.5, center=(0.1, -0.2))
SQUARE = pp.Polygon([(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)])
FILM = pp.Viscous(support=SQUARE, coefficient=0.7)
LOAD = pp.Load(force=(0.1, -0.3))
#: A load that moves the slider on its own.
PULL = pp.Load(force=(0.4, 1.3), center=(0.2, 0.1))
MORE = {
    "friction, load": (RING, LOAD),
    "friction, film": (RING, FILM),
    "film": (FILM,),
    "friction, film, load": (RING, FILM, LOAD),
    "all": (RING, MASS, FILM, LOAD),
    "inertia, load": (MASS, LOAD),
    "both, strong load": (RING, MASS, PULL),
    "two frictions": (RING, pp.SupportFriction(support=SQUARE, weight=0.3), MASS),
}
LAWS = (pp.Coulomb(0.5), pp.Coulomb(2.0), pp.InfiniteFriction(), pp.PerfectlyRough())


def generic(seed, kind, effects):
    """One scene without symmetry, and its push."""
    support = random_support(np.random.default_rng([seed, 7]), kind)
    return single(*generic_arrays(seed, support, effects, 1))


def assert_holds(scenes):
    wrong = [each for given in scenes for each in faults(*given, pp.solve(*given))]
    assert not wrong, "\n".join(wrong[:20])


@pytest.mark.parametrize("effects", EFFECTS)
@pytest.mark.parametrize("kind", KINDS)
def test_solutions_of_degenerate_scenes_hold(kind, effects):
    assert_holds(degenerate(1, 4, effects, kind))


@pytest.mark.parametrize("effects", EFFECTS)
@pytest.mark.parametrize("kind", RANDOM)
def test_solutions_of_generic_scenes_hold(kind, effects):
    assert_holds(generic(seed, kind, effects) for seed in range(3))


@pytest.mark.slow
@pytest.mark.parametrize("effects", EFFECTS)
@pytest.mark.parametrize("kind", KINDS)
def test_solutions_of_many_degenerate_scenes_hold(kind, effects):
    assert_holds(degenerate([5, KINDS.index(kind)], 500, effects, kind))


@pytest.mark.slow
@pytest.mark.parametrize("effects", EFFECTS)
@pytest.mark.parametrize("kind", RANDOM)
def test_solutions_of_many_generic_scenes_hold(kind, effects):
    assert_holds(generic(seed, kind, effects) for seed in range(200))


@pytest.mark.parametrize("effects", MORE.values(), ids=MORE)
def test_solutions_of_more_effects_hold(effects):
    for law in LAWS:
        scene = pp.Scene(slider=SLIDER, contact=law, effects=effects)
        assert_holds((scene, angle, 0.7) for angle in (-2.0, -0.3, 0.0, 0.4, 1.9, 3.0))


# --- Wrong solutions -----------------------------------------------------------------------------

CHANGED = 1 + 1e-6


def rotated(force):
    """A force turned by a millionth of a radian."""
    return force + 1e-6 * np.array([-force[1], force[0]])


WRONG = {
    "larger force": lambda s: replace(s, force=CHANGED * s.force, force_end=CHANGED * s.force_end),
    "force turned": lambda s: replace(s, force=rotated(s.force), force_end=rotated(s.force_end)),
    "opposite force": lambda s: replace(s, force=-s.force, force_end=-s.force_end),
    "another rotation": lambda s: replace(s, twist=s.twist + np.array([0, 0, 1e-6])),
    "another motion": lambda s: replace(s, contact_motion=CHANGED * s.contact_motion),
    "not a number": lambda s: replace(s, twist=np.nan * s.twist),
    "a pivot": lambda s: replace(s, pivot=0),
    "no pushing": lambda s: replace(s, mode=pp.ContactMode.SEPARATE),
    "wrong mode": lambda s: replace(s, mode=_other(s.mode)),
    "slip to the other side": lambda s: replace(s, mode=_opposite(s.mode)),
}  # fmt: skip


def _other(mode):
    stick, slip = pp.ContactMode.STICK, pp.ContactMode.SLIP_LEFT
    return slip if mode == stick else stick


def _opposite(mode):
    left, right = pp.ContactMode.SLIP_LEFT, pp.ContactMode.SLIP_RIGHT
    return left if mode == right else right


def verdicts(scene, angle, magnitude, change):
    push = push_of(scene, angle, magnitude)
    pushed = [each for each in pp.solve(scene, angle, magnitude) if each.mode != 0]
    assert pushed
    return [check(*push, change(each)) for each in pushed]


@pytest.mark.parametrize("change", WRONG.values(), ids=WRONG)
@pytest.mark.parametrize("effects", [(RING,), (MASS,), (RING, MASS), (RING, FILM, LOAD)])
def test_a_wrong_solution_is_refused(effects, change):
    for law in LAWS[:2]:
        scene = pp.Scene(slider=SLIDER, contact=law, effects=effects)
        for angle in (0.3, 1.4, 2.9):
            assert all(each.fails for each in verdicts(scene, angle, 0.7, change))


TRIPOD = pp.SupportFriction(support=pp.Points(regular(3), [1, 1, 1]))


def test_an_interval_of_forces_ends_at_the_share_or_at_the_cone():
    slider = pp.Slider(rod_length=1.0, rod_angle=np.pi / 2)
    for law in (pp.PerfectlyRough(), pp.InfiniteFriction(), pp.Coulomb(3.0)):
        scene = pp.Scene(slider=slider, contact=law, effects=(TRIPOD,))
        push, held = push_of(scene, 0.0, 1.0), pp.solve(scene, 0.0)[-1]
        if law == pp.PerfectlyRough():
            assert held.pivot == 0
            assert not np.array_equal(held.force, held.force_end)
        assert check(*push, held).holds
        if held.pivot == 0:
            middle = (held.force + held.force_end) / 2
            further = held.force + 1e-6 * (held.force - held.force_end)
            for force in (0.999 * held.force + 0.001 * middle, further):
                assert check(*push, replace(held, force=force)).fails


def test_a_foot_that_barely_moves_carries_its_share_at_most():
    """The torque tells its force across the line to the contact, the share what is left along it."""
    feet = pp.SupportFriction(support=pp.Points([(-0.5, 0.0), (1.0, 0.0)], [3.0, 1.0]))
    slider = pp.Slider(rod_length=1.0, rod_angle=np.pi / 2)
    scene = pp.Scene(slider=slider, contact=pp.PerfectlyRough(), effects=(feet,))
    push = push_of(scene, 3.141592653579793, 1.0)
    twist, motion = np.array([-0.5, 1e-11, -0.5]), np.array([-1.0, 1e-11])
    part = np.array([-0.5625, (0.25**2 - 0.1875**2) ** 0.5])
    held = pp.solve(scene, 3.141592653579793)[-1]
    claim = replace(held, twist=twist, contact_motion=motion, force=part, force_end=part)
    assert check(*push, claim).holds
    wrong = part + np.array([0.0, 1e-6])
    assert check(*push, replace(claim, force=wrong, force_end=wrong)).fails
