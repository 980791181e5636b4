"""Contact modes on swept scenes: the conditions of every mode, and the certified decisions."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import replace
from enum import Enum, auto

import numpy as np
import numpy.typing as npt
from flint import arb, ctx, fmpq

from planar_pushing.certified.balls import Undecided
from planar_pushing.certified.contact import modes as certified
from planar_pushing.certified.setting import Effects
from planar_pushing.certified.setting import Slider as ExactSlider
from planar_pushing.evidence.hard_cases.scenes import make_scene
from planar_pushing.evidence.hard_cases.sweep.adversarial import (
    Generator,
    angles,
    powers,
    rod_angle,
    scene,
)
from planar_pushing.evidence.internals import (
    COINCIDENCE,
    Array,
    Candidates,
    candidates,
    contact_motion,
    direction,
    edge_motions,
    friction_coefficient,
    is_homogeneous,
)
from planar_pushing.mechanics.cones import friction_cone, motion_cone
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.effects import Inertia
from planar_pushing.mechanics.errors import InvalidValue
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.solve import Solutions, solve

Wrong = npt.NDArray[np.bool_]
#: Relative accuracy of the conditions of a mode, in the unit of the motion or of the force.
CLOSE = 1e-9
#: Relative change of an input within which a decision may hang on rounding.
NEXT_TO = (0.0, -(2.0**-44), 2.0**-44)


def _largest_part(scene: Scene, twist: Array) -> Array:
    """Largest of what adds up to the contact's motion: the centre's motion, the rotation about it."""
    parts = [twist[..., 0], twist[..., 1], twist[..., 2] * scene.slider.length_ratio]
    return np.asarray(np.abs(parts).max(axis=0))


def _breaks_its_conditions(scene: Scene, found: Candidates, pusher: Array) -> Wrong:
    """Consistent motions, in units of the pusher's, that do not do what their mode says."""
    motion, force = contact_motion(scene, found.twist), found.force
    size = np.hypot(force[..., 0], force[..., 1])
    scale = 1 + np.hypot(motion[..., 0], motion[..., 1])
    gap = motion - pusher[..., None, :]
    wrong = ~np.isfinite(motion).all(axis=-1) | ~np.isfinite(size) | np.isnan(found.spin_ratio)
    if found.mode is ContactMode.SEPARATE:
        return np.asarray(found.consistent & (wrong | (pusher[..., 1:] > 0)))
    if found.mode is ContactMode.STICK:
        wrong |= ~(np.abs(gap).max(axis=-1) <= CLOSE * scale)
    else:
        side = 1 if found.mode is ContactMode.SLIP_RIGHT else -1
        reach = 1 + _largest_part(scene, found.twist)
        wrong |= ~(np.abs(gap[..., 1]) <= CLOSE * reach) | ~(side * gap[..., 0] > 0)
        wrong |= ~(side * force[..., 0] <= CLOSE * size)
    along = np.divide(force, size[..., None], out=np.zeros_like(force), where=size[..., None] > 0)
    power = (along * (motion / scale[..., None])).sum(axis=-1)
    return np.asarray(found.consistent & (wrong | ~(power >= -CLOSE)))


def _count(scene: Scene, found: tuple[Candidates, ...], pusher: Array) -> Wrong:
    """Pusher motions with too few or too many solutions."""
    counts = np.sum([each.consistent.sum(axis=-1) for each in found], axis=0)
    pushing, separate = pusher[:, 1] > 0, found[0].consistent[:, 0]
    wrong = separate != (pusher[:, 1] <= 0)
    if scene.contact.force_angles.closed:
        wrong |= pushing & (counts < 1)
    if is_homogeneous(scene.effects):
        wrong |= pushing & (counts > 1)
    return np.asarray(wrong)


def vectorised(rng: Generator, pushers: int) -> Wrong | None:
    """A scene over its whole reach, and many pushers at once; None where it is refused."""
    here = scene(rng, 290)
    cone = motion_cone(here)
    pusher = direction(angles(rng, pushers, 0.0, cone.right, cone.left))
    try:
        found = candidates(here, pusher, powers(rng, 10, pushers))
    except InvalidValue:
        return None
    wrong = [_breaks_its_conditions(here, each, pusher).any(axis=-1) for each in found]
    return np.asarray(np.any(wrong, axis=0) | _count(here, found, pusher))


def scalar(rng: Generator) -> tuple[bool, bool]:
    """One scene over its whole reach through `solve`: whether it was refused, and whether it is wrong."""
    here = scene(rng, 300)
    angle = float(rng.choice(angles(rng, 200, 0.0, np.pi)))
    magnitude = float(rng.choice([0.0, 5e-324, 1.0, *powers(rng, 300, 4)]))
    try:
        found = solve(here, angle, magnitude)
    except InvalidValue:
        return True, False
    return False, _is_wrong(here, found, direction(angle), magnitude)


def _is_wrong(scene: Scene, found: Solutions, pusher: Array, magnitude: float) -> bool:
    numbers = [[*s.force, *s.contact_motion, *s.twist] for s in found]
    some = magnitude == 0 or pusher[1] <= 0 or not scene.contact.force_angles.closed or len(found)
    return bool(np.isnan(np.array(numbers)).any() or not some)


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
    psi = rod_angle(rng) if rng.random() < 0.5 else float(rng.uniform(0.05, np.pi - 0.05))
    names = list(Effects)[int(rng.integers(3))]
    share = {Effects.FRICTION: 0.0, Effects.INERTIA: 1.0, Effects.BOTH: 0.5}[names]
    mu, rho = float(rng.choice([mu, 0.0, 1.0, math.inf])), float(rng.choice([rho, 1.0]))
    here = make_scene(length, psi, share=share, mu=mu, rho=rho)
    cone = motion_cone(here)
    return here, names, float(rng.choice(angles(rng, 200, 0.0, np.pi, cone.right, cone.left))), size


def _on_an_edge(scene: Scene, pusher: float) -> bool:
    """Whether slip and stick differ by no more than what counts as one motion."""
    forces = friction_cone(scene)
    edges = edge_motions(scene, [forces.right, forces.left]).ravel().tolist()
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
