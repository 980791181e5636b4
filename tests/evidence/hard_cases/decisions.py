"""Contact modes of scenes one at a time, compared with certified decisions."""

import math
from collections import Counter
from dataclasses import replace
from enum import Enum, auto

import numpy as np
from flint import arb, ctx, fmpq

import planar_pushing as pp
from evidence.hard_cases.adversarial import angles, rod_angles
from planar_pushing.certified.balls import Undecided
from planar_pushing.certified.contact import modes as certified
from planar_pushing.certified.setting import Effects
from planar_pushing.certified.setting import Slider as ExactSlider
from planar_pushing.core.tolerances import COINCIDENT
from planar_pushing.evidence.hard_cases.cases import make_scene

#: Relative change of an input within which a decision may hang on rounding.
NEXT_TO = (0.0, -(2.0**-44), 2.0**-44)
#: Share of inertia that stands for a set of effects in `make_scene`.
SHARE = {Effects.FRICTION: 0.0, Effects.INERTIA: 1.0, Effects.BOTH: 0.5}


class Decision(Enum):
    """How the modes found compare with the certified ones."""

    SAME = auto()
    TIE = auto()
    UNDECIDED = auto()
    WRONG = auto()


def degrees(angle, nudge=0.0):
    """Rational degrees of an angle: exact at quarter turns, else within 1e-60 of it."""
    quarters = round(angle / (math.pi / 2))
    if nudge == 0 and quarters * (math.pi / 2) == angle:
        return fmpq(90 * quarters)
    with ctx.workprec(400):
        mantissa, exponent = (arb(angle) * (1 + arb(nudge)) * 180 / arb.pi()).mid().man_exp()
        return fmpq(mantissa) * fmpq(2) ** int(exponent)


def certified_modes(scene, effects, rho, mu, size, pusher):
    law = certified.coulomb(mu) if math.isfinite(mu) else certified.INFINITE_FREE
    slider = ExactSlider.of(scene.slider.rod_length, gyration_radius=rho)
    slider = replace(slider, rod_angle=degrees(scene.slider.rod_angle))
    found = certified.contact_modes(slider, effects, law, size, pusher)
    return Counter({mode.name: len(motions) for mode, motions in found.items() if motions})


def is_on_an_edge(scene, pusher):
    """Whether slip and stick differ by no more than what counts as one motion."""
    forces = pp.friction_cone(scene)
    shares = (0.0, 1.0) if len(scene.effects) > 1 else (None,)
    edges = [
        pp.motion_angle(scene, force, share)
        for force in (forces.right, forces.left)
        for share in shares
    ]
    nearest = min(abs(math.remainder(edge - pusher, math.tau)) for edge in edges)
    return nearest <= 2 * COINCIDENT


def decided(rng):
    """Compare one scene with the certified decisions.

    A tie hangs on rounding: a change of the pusher's angle by 2^-44 turns the certified modes into those
    found, or the pusher is so close to a cone's edge that the slip is below `COINCIDENT`: a stick.
    """
    length, rho, mu, size = (float(10.0 ** rng.uniform(-reach, reach)) for reach in (3, 3, 3, 4))
    anywhere = rng.uniform(0.05, np.pi - 0.05)
    psi = float(rod_angles(rng, 1)[0]) if rng.random() < 0.5 else anywhere
    effects = list(Effects)[int(rng.integers(3))]
    mu, rho = float(rng.choice([mu, 0.0, 1.0, math.inf])), float(rng.choice([rho, 1.0]))
    scene = make_scene(length, psi, share=SHARE[effects], mu=mu, rho=rho)
    cone = pp.motion_cone(scene)
    pusher = float(rng.choice(angles(rng, 200, 0.0, np.pi, cone.right, cone.left)))
    found = Counter(mode.name for mode in pp.solve(scene, pusher, size).modes)
    undecided = False
    for nudge in NEXT_TO:
        try:
            exact = certified_modes(scene, effects, rho, mu, size, degrees(pusher, nudge))
        except Undecided:
            undecided = True
            continue
        if exact == found:
            return Decision.TIE if nudge else Decision.SAME
    if is_on_an_edge(scene, pusher):
        return Decision.TIE
    return Decision.UNDECIDED if undecided else Decision.WRONG
