"""Contact modes of swept scenes one at a time: refused outside the domain, decided as certified inside."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import replace
from enum import Enum, auto
from typing import NamedTuple

import numpy as np
from flint import arb, ctx, fmpq

from planar_pushing.certified.balls import Undecided
from planar_pushing.certified.contact import modes as certified
from planar_pushing.certified.setting import Effects
from planar_pushing.certified.setting import Slider as ExactSlider
from planar_pushing.evidence.hard_cases.scenes import make_scene
from planar_pushing.evidence.hard_cases.sweep.adversarial import (
    SHORTEST,
    Generator,
    angles,
    coefficients,
    gyrations,
    lengths,
    mixed,
    powers,
    rod_angles,
)
from planar_pushing.evidence.hard_cases.sweep.conditions import Pushes, wrong
from planar_pushing.mechanics.cones import friction_cone, motion_angle, motion_cone
from planar_pushing.mechanics.contact.laws import friction_coefficient
from planar_pushing.mechanics.effects import Inertia
from planar_pushing.mechanics.modes import COINCIDENCE
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solve import solve
from planar_pushing.terms.domain import GYRATION, LONGEST, ROUGHEST, SHARES
from planar_pushing.terms.errors import InvalidValue

#: Relative change of an input within which a decision may hang on rounding.
NEXT_TO = (0.0, -(2.0**-44), 2.0**-44)
#: Share of inertia that stands for a set of effects in `make_scene`.
SHARE = {Effects.FRICTION: 0.0, Effects.INERTIA: 1.0, Effects.BOTH: 0.5}


class Wide(NamedTuple):
    """A scene with W = m = R = 1 and the size of a push, each number in the domain or far outside."""

    names: Effects
    length: float
    rho: float
    mu: float
    size: float

    @property
    def allowed(self) -> bool:
        """Whether the domain holds it."""
        inertial, both = self.names is not Effects.FRICTION, self.names is Effects.BOTH
        return (
            self.length <= LONGEST
            and self.mu <= ROUGHEST
            and (not inertial or GYRATION[0] <= self.rho <= GYRATION[1])
            and (not both or self.size == 0 or SHARES[0] <= self.size <= SHARES[1])
        )


def _wide(rng: Generator) -> Wide:
    sizes = mixed(rng, [0.0, *SHARES], powers(rng, *SHARES, 1))
    inside = np.concatenate([lengths(rng, 1), gyrations(rng, 1), coefficients(rng, 1), sizes])
    outside = powers(rng, SHORTEST, 1 / SHORTEST, 4)
    return Wide(
        list(Effects)[int(rng.integers(3))],
        *np.where(rng.random(4) < 0.1, outside, inside).tolist(),
    )


def scalar(rng: Generator) -> tuple[bool, bool]:
    """One scene, in the domain or out of it: whether it was refused, and whether the answer is wrong."""
    wide, psi = _wide(rng), float(rod_angles(rng, 1)[0])
    angle = float(rng.choice(angles(rng, 200, 0.0, np.pi)))
    try:
        scene = make_scene(wide.length, psi, share=SHARE[wide.names], mu=wide.mu, rho=wide.rho)
        found = solve(scene, angle, wide.size)
    except InvalidValue:
        return True, wide.allowed
    pushes = Pushes(scene, np.array([angle]), np.array([wide.size]))
    arrays = solve(*pushes)
    same = [int(mode) for mode in found.modes] == arrays.mode[arrays.consistent].tolist()
    return False, not (wide.allowed and same) or bool(wrong(pushes, arrays).any())


def _degrees(radians: float, nudge: float = 0.0) -> fmpq:
    """Rational degrees of an angle: exact at quarter turns, else within 1e-60 of it."""
    quarters = round(radians / (math.pi / 2))
    if nudge == 0 and quarters * (math.pi / 2) == radians:
        return fmpq(90 * quarters)
    with ctx.workprec(400):
        turned = (arb(radians) * (1 + arb(nudge)) * 180 / arb.pi()).mid()
        mantissa, exponent = turned.man_exp()
        return fmpq(mantissa) * fmpq(2) ** int(exponent)


def _certified(scene: Scene, names: Effects, size: float, pusher: fmpq) -> Counter[str]:
    mu = friction_coefficient(scene.contact)
    law = certified.coulomb(mu) if math.isfinite(mu) else certified.INFINITE_FREE
    rho = next((each.gyration_radius for each in scene.effects if isinstance(each, Inertia)), 1.0)
    slider = ExactSlider.of(scene.slider.rod_length, gyration_radius=rho)
    slider = replace(slider, rod_angle=_degrees(scene.slider.rod_angle))
    found = certified.contact_modes(slider, names, law, size, pusher)
    return Counter({mode.name: len(motions) for mode, motions in found.items() if motions})


def _drawn(rng: Generator) -> tuple[Scene, Effects, float, float]:
    """Scene with W = m = R = 1 and lengths in reach of the certified route, its effects, a push."""
    length, rho, mu, size = (float(10.0 ** rng.uniform(-reach, reach)) for reach in (3, 3, 3, 4))
    psi = float(rod_angles(rng, 1)[0] if rng.random() < 0.5 else rng.uniform(0.05, np.pi - 0.05))
    names = list(Effects)[int(rng.integers(3))]
    mu, rho = float(rng.choice([mu, 0.0, 1.0, math.inf])), float(rng.choice([rho, 1.0]))
    here = make_scene(length, psi, share=SHARE[names], mu=mu, rho=rho)
    cone = motion_cone(here)
    return here, names, float(rng.choice(angles(rng, 200, 0.0, np.pi, cone.right, cone.left))), size


def _on_an_edge(scene: Scene, pusher: float) -> bool:
    """Whether slip and stick differ by no more than what counts as one motion."""
    forces = friction_cone(scene)
    shares = (0.0, 1.0) if len(scene.effects) > 1 else (None,)
    edges = [
        motion_angle(scene, force, share)
        for force in (forces.right, forces.left)
        for share in shares
    ]
    nearest = min(abs(math.remainder(edge - pusher, math.tau)) for edge in edges)
    return nearest <= 2 * COINCIDENCE


class Decision(Enum):
    """How the modes found compare with the certified ones."""

    SAME = auto()
    TIE = auto()
    UNDECIDED = auto()
    WRONG = auto()


def decided(rng: Generator) -> Decision:
    """Compare one scene with the certified decisions.

    A tie hangs on rounding: a change of the pusher's angle by 2^-44 turns the certified modes into those
    found, or the pusher is so close to a cone's edge that the slip is below `COINCIDENCE`: a stick.
    """
    here, names, pusher, size = _drawn(rng)
    found = Counter(mode.name for mode in solve(here, pusher, size).modes)
    undecided = False
    for nudge in NEXT_TO:
        try:
            exact = _certified(here, names, size, _degrees(pusher, nudge))
        except Undecided:
            undecided = True
            continue
        if exact == found:
            return Decision.TIE if nudge else Decision.SAME
    if _on_an_edge(here, pusher):
        return Decision.TIE
    return Decision.UNDECIDED if undecided else Decision.WRONG
