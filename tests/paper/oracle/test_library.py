"""Each solution of the library is a root that the oracle proves, in symmetric and in random scenes.

This does not need a list of all modes, and thus covers any support with friction and inertia together.
"""

import numpy as np
import pytest
from mechanics.degenerate import (
    EFFECTS,
    RANDOM,
    SYMMETRIC,
    degenerate,
    generic_arrays,
    random_support,
)
from mechanics.degenerate import _single as single
from oracle.library import differences, slider_of

import planar_pushing as pp
from pulling_by_pushing.evidence.hard_cases.references import in_exact_degrees
from pulling_by_pushing.oracle.balls import Undecided, at_degrees, precise, rational
from pulling_by_pushing.oracle.modes import (
    INFINITE_FREE,
    INFINITE_NONE,
    PERFECTLY_ROUGH,
    Law,
    contact_modes,
)

KINDS = ("feet", *SYMMETRIC)
SQUARE = pp.Polygon([(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)])
SLIDER = pp.Slider(rod_length=2.0, rod_angle=np.pi / 4, radius=1.0)
RING, MASS, LOAD = (
    pp.RingFriction(),
    pp.Inertia(mass=0.5, center=(0.1, -0.2)),
    pp.Load(force=(0.1, -0.3)),
)
FILM = pp.Viscous(support=SQUARE, coefficient=0.7)
MORE = {
    "friction, load": (RING, LOAD),
    "film": (FILM,),
    "all": (RING, MASS, FILM, LOAD),
    "inertia, load": (MASS, LOAD),
    "two frictions": (RING, pp.SupportFriction(support=SQUARE, weight=0.3), MASS),
}  # fmt: skip
LAWS = (pp.Coulomb(0.5), pp.Coulomb(2.0), pp.InfiniteFriction(), pp.PerfectlyRough())
#: Largest difference, over what roundings of terms and inputs allow.
MOST = 4.0


def compare(scenes):
    """Numbers of solutions that are proved and undecided; all proved ones agree."""
    counts, wrong = [0, 0], []
    for scene, angle, magnitude in scenes:
        for solution in pp.solve(scene, angle, magnitude):
            try:
                off = differences(scene, angle, magnitude, solution)
            except Undecided:
                counts[1] += 1
                continue
            counts[0] += 1
            if off and max(off) > MOST:
                wrong.append((solution.mode.name, off, scene, angle, magnitude))
    assert not wrong, wrong[:3]
    return counts


def generic(seed, kind, effects):
    """One scene without symmetry, and its push."""
    support = random_support(np.random.default_rng([seed, 7]), kind)
    return single(*generic_arrays(seed, support, effects, 1))


@pytest.mark.parametrize("effects", EFFECTS)
@pytest.mark.parametrize("kind", KINDS)
def test_solutions_of_degenerate_scenes_are_proved(kind, effects):
    proved, _ = compare(degenerate(1, 6, effects, kind))
    assert proved


@pytest.mark.parametrize("effects", EFFECTS)
@pytest.mark.parametrize("kind", RANDOM)
def test_solutions_of_random_scenes_are_proved(kind, effects):
    proved, undecided = compare(generic(seed, kind, effects) for seed in range(4))
    assert proved > undecided


@pytest.mark.slow
@pytest.mark.parametrize("effects", EFFECTS)
@pytest.mark.parametrize("kind", [*KINDS, *RANDOM])
def test_solutions_of_many_scenes_are_proved(kind, effects):
    if kind in KINDS:
        compare(degenerate([5, KINDS.index(kind)], 300, effects, kind))
    else:
        compare(generic(seed, kind, effects) for seed in range(100))


@pytest.mark.parametrize("law", LAWS, ids=lambda law: type(law).__name__)
@pytest.mark.parametrize("effects", MORE.values(), ids=MORE)
def test_solutions_with_more_effects_are_proved(effects, law):
    scene = pp.Scene(slider=SLIDER, contact=law, effects=effects)
    angles = np.linspace(-3.0, 3.0, 7)
    proved, undecided = compare((scene, float(angle), 1.3) for angle in angles)
    assert proved > undecided


def test_a_wrong_solution_is_seen():
    scene = pp.Scene(slider=SLIDER, contact=pp.Coulomb(2.0), effects=(RING, MASS))
    (stick,) = (each for each in pp.solve(scene, 1.2) if each.mode.name == "STICK")
    assert max(differences(scene, 1.2, 1.0, stick)) < MOST
    assert max(differences(scene, 1.2, 1.0 + 1e-12, stick)) > MOST


def law_of(contact):
    if isinstance(contact, pp.Coulomb):
        return Law(float(contact.friction_coefficient))
    if isinstance(contact, pp.PerfectlyRough):
        return PERFECTLY_ROUGH
    return INFINITE_FREE if contact.at_zero_normal == "free" else INFINITE_NONE


@precise
def oracle_modes(scene, angle, magnitude):
    pusher = at_degrees(in_exact_degrees(angle))
    return [
        solution.mode.name
        for solution in contact_modes(
            slider_of(scene), law_of(scene.contact), pusher, rational(magnitude)
        )
    ]


@pytest.mark.parametrize("effects", EFFECTS)
@pytest.mark.parametrize("kind", KINDS)
def test_the_library_has_exactly_the_modes_of_the_oracle(kind, effects):
    """Degenerate scenes, where the oracle decides; with both effects only the ring."""
    decided = 0
    for scene, angle, magnitude in degenerate(2, 6, effects, kind):
        try:
            expected = oracle_modes(scene, angle, magnitude)
        except Undecided:
            continue
        decided += 1
        modes = [solution.mode.name for solution in pp.solve(scene, angle, magnitude)]
        assert modes == expected, (scene, angle, magnitude)
    assert decided or (effects == "both" and kind != "ring")
