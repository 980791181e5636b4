"""Contact modes enclosed: published answers for symmetric scenes, and the modes of the core."""

from __future__ import annotations

import math

import numpy as np
import pytest
from flint import fmpq

import planar_pushing as pp
from certified.effects.scenes import faults, push_of
from mechanics.degenerate import EFFECTS, SYMMETRIC, degenerate
from planar_pushing.certified.balls import Undecided, rational
from planar_pushing.certified.contact.modes import INFINITE_FREE, Law, Mode
from planar_pushing.certified.effects.modes import modes
from planar_pushing.certified.potential import direction
from planar_pushing.certified.potential.resistance import Friction, Inertia, Load, Scene
from planar_pushing.certified.supports.pressure.pieces import pieces

TABLE = {
    "shape": "points", "positions": [(1, 1), (-1, 1), (-1, -1), (1, -1)], "weights": [1, 1, 1, 1]
}  # fmt: skip
SQUARE = {"shape": "polygon", "vertices": [(1, 1), (-1, 1), (-1, -1), (1, -1)]}
RING = {"shape": "ring"}
UPRIGHT = math.pi / 2


def scene(support, length, rod_angle=90, gyration=1, *more):
    """Friction and a mass, both of unit size."""
    effects = Friction(pieces(support), fmpq(1)), Inertia(fmpq(1), rational(gyration) ** 2)
    return Scene(fmpq(length), direction.degrees(fmpq(rod_angle)), (*effects, *more))


def found(scene, law, angle, magnitude=1.0):
    return modes(scene, law, direction.degrees(rational(angle)), rational(magnitude))


def names(solutions):
    return [each.mode.name for each in solutions]


def feet(places, weights=(2, 1, 1)):
    return {"shape": "points", "positions": places, "weights": weights}


# --- Symmetric scenes with their literal answers -------------------------------------------------


@pytest.mark.parametrize("support", [TABLE, SQUARE, RING], ids=["feet", "square", "ring"])
@pytest.mark.parametrize("gyration", [0.3, 1.0, 2.0])
@pytest.mark.parametrize("magnitude", [1e-3, 1.0, 1e3])
def test_a_symmetric_slider_pushed_along_the_fence_separates_or_sticks(
    support, gyration, magnitude
):
    """The force is along the fence at every speed: slips from rest to the stick are a continuum."""
    for angle in (0, 180):
        both = found(scene(support, 1, 90, gyration), INFINITE_FREE, angle, magnitude)
        assert names(both) == ["SEPARATE", "STICK"]
        assert both[1].continuum


def test_feet_beyond_the_contact_that_only_separate():
    beyond = scene(feet([(-1, 0), (-1, 1), (-1, -1)]), 3)
    assert names(found(beyond, Law(0.5), 0)) == ["SEPARATE"]


def test_a_pivot_about_the_foot_at_the_center_ends_a_continuum():
    """f_y = 2 f_x and f_x = (0.5 + u_x / 3) / 3, up to what the foot holds."""
    pivots = scene(feet([(0, 0), (0, 1), (0, -1)]), 3)
    separate, slip = found(pivots, Law(0.5), 0)
    assert (separate.mode, slip.mode) == (Mode.SEPARATE, Mode.SLIP_LEFT)
    assert float(slip.motion[0]) == pytest.approx(0.512461, abs=1e-6)
    assert list(map(float, slip.force)) == pytest.approx([0.223607, 0.447214], abs=1e-6)
    assert slip.pivot == 0
    assert slip.continuum


LITERAL = {
    "heavy feet beyond": (pp.Points([(-1, 0), (-1, 1), (-1, -1)], [2, 1, 1]), 3.0, pp.Coulomb(0.5)),
    "heavy foot at the center": (
        pp.Points([(0, 0), (0, 1), (0, -1)], [2, 1, 1]), 3.0, pp.Coulomb(0.5)
    ),
    "table": (pp.Points([(1, 1), (-1, 1), (-1, -1), (1, -1)], [1] * 4), 1.0, pp.InfiniteFriction()),
}  # fmt: skip


@pytest.mark.parametrize(("support", "length", "law"), LITERAL.values(), ids=LITERAL)
def test_the_core_agrees_on_symmetric_scenes(support, length, law):
    slider = pp.Slider(rod_length=length, rod_angle=UPRIGHT)
    effects = pp.SupportFriction(support=support), pp.Inertia()
    one = pp.Scene(slider=slider, contact=law, effects=effects)
    for angle in (0.0, math.pi):
        solutions = pp.solve(one, angle)
        assert faults(one, angle, 1.0, solutions) == []
        assert [each.name for each in solutions.modes] == names(modes(*push_of(one, angle, 1.0)))


@pytest.mark.parametrize("center", [(0.25, -0.25), (0.0, 0.0)])
def test_feet_beside_the_contact_under_infinite_friction(center):
    support = pp.Points([(0, -0.94), (0, -0.71), (0, -0.93)], [1.25, 4.4, 0.1])
    mass = pp.Inertia(mass=0.0233, gyration_radius=0.0535, center=center)
    slider = pp.Slider(rod_length=0.0, rod_angle=UPRIGHT)
    effects = pp.SupportFriction(support=support, weight=9.83), mass
    one = pp.Scene(slider=slider, contact=pp.InfiniteFriction(), effects=effects)
    assert faults(one, -UPRIGHT, 1.0, pp.solve(one, -UPRIGHT)) == []


@pytest.mark.parametrize("psi", [math.pi / 4, 3 * math.pi / 4])
@pytest.mark.parametrize("mass", [0.0001534647824815597, 1.0])
def test_an_edge_of_the_cone_along_the_rod(psi, mass):
    """mu = 1, pushers next to the fence: every solution holds, and there is one."""
    support = pp.Points(
        [(0, 0), (-0.164137793662396, -0.4796726269281757)], [0.5180018750924412, 0.660162015113078]
    )
    effects = pp.SupportFriction(support=support), pp.Inertia(mass=mass, gyration_radius=0.5)
    slider = pp.Slider(rod_length=3.0, rod_angle=psi)
    one = pp.Scene(slider=slider, contact=pp.Coulomb(1.0), effects=effects)
    for beside in (7.687221475767577e-14, *10.0 ** np.arange(-14, -3)):
        for angle in (beside, -beside, math.pi - beside, beside - math.pi):
            solutions = pp.solve(one, angle)
            assert len(solutions) >= 1
            assert faults(one, angle, 1.0, solutions) == []


@pytest.mark.slow
def test_fast_pulling_has_two_slips_and_no_stick():
    """For mu = 1.4 n . u falls to -0.0400296 at |f| = 1.40897 and is back at 0 at 2.22518."""
    _, slow, fast = found(scene(RING, 2, 45), Law(1.4), -1, 2.0)
    assert (slow.mode, fast.mode) == (Mode.SLIP_LEFT, Mode.SLIP_LEFT)
    sizes = sorted(math.hypot(*map(float, each.force)) for each in (slow, fast))
    assert sizes[0] < 1.40897 < sizes[1] < 2.22518


# --- More effects, and the core ------------------------------------------------------------------


def test_with_a_load_the_slider_leaves_a_fence_that_is_slower():
    """Friction holds it against 0.3 and not against 1.5, which pulls it away at 0.5."""
    for pull, slow, fast in ((0.3, ["SEPARATE"], []), (1.5, ["SEPARATE"], ["SEPARATE"])):
        loaded = scene(RING, 2, 45, 1, Load((fmpq(0), rational(pull))))
        for magnitude, wanted in ((0.4, fast), (0.6, [])):
            separates = names(found(loaded, Law(0.5), 90, magnitude))[:1] == ["SEPARATE"]
            assert separates == bool(wanted)
        assert names(found(loaded, Law(0.5), -90, 0.4))[:1] == slow


@pytest.mark.parametrize("effects", EFFECTS)
@pytest.mark.parametrize("kind", ["feet", *SYMMETRIC])
def test_the_core_has_exactly_these_modes(kind, effects):
    """The first degenerate scenes; where balls decide."""
    decided = 0
    for one, angle, magnitude in degenerate(2, 2, effects, kind):
        try:
            wanted = names(modes(*push_of(one, angle, magnitude)))
        except Undecided:
            continue
        decided += 1
        assert [each.name for each in pp.solve(one, angle, magnitude).modes] == wanted
    assert decided
