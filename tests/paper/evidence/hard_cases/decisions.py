"""Contact modes of scenes one at a time, compared with those of the oracle."""

import math
from collections import Counter
from enum import Enum, auto

import numpy as np
from evidence.hard_cases.adversarial import angles, rod_angles

import planar_pushing as pp
from planar_pushing.core.supports.tolerances import COINCIDENT
from pulling_by_pushing.evidence.hard_cases.cases import make_scene
from pulling_by_pushing.evidence.hard_cases.references import direction, slider
from pulling_by_pushing.oracle.balls import Undecided, precise, rational
from pulling_by_pushing.oracle.modes import Law, contact_modes

#: Relative change of an input within which a decision may hang on rounding.
NEXT_TO = (0.0, -(2.0**-44), 2.0**-44)
#: Shares of inertia: friction, inertia, both.
SHARES = (0.0, 1.0, None)


class Decision(Enum):
    """How the modes of the library compare with those of the oracle."""

    SAME = auto()
    TIE = auto()
    UNDECIDED = auto()
    WRONG = auto()


@precise
def oracle_modes(scene, share, rho, mu, size, pusher):
    rod = slider(rational(scene.slider.rod_length), scene.slider.rod_angle, share, rho)
    modes = contact_modes(rod, Law(mu), direction(pusher), rational(size))
    return Counter(solution.mode.name for solution in modes)


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
    """Compare the modes of one scene with those of the oracle.

    A tie hangs on rounding: a change of the pusher's angle by 2^-44 turns the modes of the oracle into
    those of the library, or the pusher is so close to a cone's edge that the slip is below `COINCIDENT`: a
    stick.
    """
    length, rho, mu, size = (float(10.0 ** rng.uniform(-reach, reach)) for reach in (3, 3, 3, 4))
    anywhere = rng.uniform(0.05, np.pi - 0.05)
    psi = float(rod_angles(rng, 1)[0]) if rng.random() < 0.5 else anywhere
    share = SHARES[int(rng.integers(3))]
    mu, rho = float(rng.choice([mu, 0.0, 1.0, math.inf])), float(rng.choice([rho, 1.0]))
    scene = make_scene(length, psi, share=0.5 if share is None else share, mu=mu, rho=rho)
    cone = pp.motion_cone(scene)
    pusher = float(rng.choice(angles(rng, 200, 0.0, np.pi, cone.right, cone.left)))
    modes = Counter(mode.name for mode in pp.solve(scene, pusher, size).modes)
    undecided = False
    for nudge in NEXT_TO:
        angle = rational(pusher) * (1 + rational(nudge)) if nudge else pusher
        try:
            expected = oracle_modes(scene, share, rho, mu, size, angle)
        except Undecided:
            undecided = True
            continue
        if expected == modes:
            return Decision.TIE if nudge else Decision.SAME
    if is_on_an_edge(scene, pusher):
        return Decision.TIE
    return Decision.UNDECIDED if undecided else Decision.WRONG
