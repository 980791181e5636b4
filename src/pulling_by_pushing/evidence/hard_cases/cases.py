"""The table of hard cases: the quantity, its inputs, and its certified reference.

Each case belongs to a line of the list of hard inputs:

1. a center on the ring;
2. a translation, and a rotation about the ring's center;
3. short and long rods, radii of gyration far from the ring's, rods along fence and normal;
4. no friction, friction without bound, and pushers close to the fence or to a cone's edge;
5. slow and fast motions, where the combined solution approaches those of friction and of inertia;
6. rest, where the gradient of friction is a set, and the smallest motions around it;
7. a normal motion of the contact that has two slips, up to the point where they merge;
8. a center at or next to a foot, and feet that carry nearly all of their share;
9. a center on an edge of a plate, in a corner or far away;
10. a center on the rim of a disc, an annulus or a ring that lies off the slider's center;
11. a center on a segment or at its end, and pushes across and along it;
12. a very thin plate and a very thin annulus.

Line 13, motions over time, is in `motions`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cache, lru_cache, partial

import numpy as np
from flint import arb, ctx, fmpq

from planar_pushing.mechanics.contact import (
    ContactLaw,
    ContactMode,
    Coulomb,
    InfiniteFriction,
    PerfectlyRough,
)
from planar_pushing.mechanics.effects import Effect, Inertia, RingFriction
from planar_pushing.mechanics.force.cones import motion_angle, motion_cone, spin_ratio
from planar_pushing.mechanics.force.wrench import ring_profile, ring_spin_ratios, wrench
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.slider import Slider
from planar_pushing.mechanics.solve import solve
from pulling_by_pushing.evidence.hard_cases import references, supports
from pulling_by_pushing.evidence.hard_cases.case import PSI, Case, Function, spin_of_stick
from pulling_by_pushing.evidence.hard_cases.references import direction, slider
from pulling_by_pushing.oracle.balls import Number, cone_edge


def make_scene(
    length: float,
    psi: float,
    *,
    share: float = 0.5,
    mu: float = math.inf,
    rho: float = 1.0,
    law: ContactLaw | None = None,
) -> Scene:
    """Scene with W = m = R = 1: friction for a share of inertia of 0, inertia for 1, otherwise both."""
    contact = law or (InfiniteFriction() if math.isinf(mu) else Coulomb(mu))
    friction, inertia = RingFriction(), Inertia(gyration_radius=rho)
    ends: dict[float, tuple[Effect, ...]] = {0.0: (friction,), 1.0: (inertia,)}
    effects = ends.get(share, (friction, inertia))
    return Scene(slider=Slider(rod_length=length, rod_angle=psi), contact=contact, effects=effects)


@cache
def cases() -> tuple[Case, ...]:
    """Every hard case, by line."""
    ring = (_ring, _lengths, _contact, _speeds, _slow_motions, _painleve)
    families = (*ring, supports.rotations, supports.motions)
    table = (case for family in families for case in family())
    return tuple(sorted(table, key=lambda case: case.line))


# --- Lines 1 and 2: the ring --------------------------------------------------------------------------

FORCE = Function("force", lambda k: float(ring_profile(k)[0]), partial(references.ring_wrench, 0))
TORQUE = Function("torque", lambda k: float(ring_profile(k)[1]), partial(references.ring_wrench, 1))
INVERSE = Function("spin_ratio", lambda h: float(ring_spin_ratios(h)), references.ring_spin)
#: Distances from 1, in both directions if they are doubles, and magnitudes toward 0 and infinity.
GAPS = (0.0, 2.0**-53, 2.0**-52, 1e-12, 1e-9, 1e-6, 1e-3)
SIZES = (5e-324, 1e-300, 1e-160, 1e-8, 1e-3, 0.5)


def _ring() -> Iterator[Case]:
    near = sorted({1 - gap for gap in GAPS} | {1 + gap for gap in GAPS})
    ends = [x for size in SIZES for x in (size, 1 / size) if x < math.inf]
    for line, places in ((1, near), (2, ends)):
        for x in places:
            for function, name in ((FORCE, "k"), (TORQUE, "k"), (INVERSE, "h")):
                yield Case(f"{function.quantity} at {name} = {x!r}", line, function, (x,))


# --- Line 3: lengths ----------------------------------------------------------------------------------


def _motion_angle(length: float, psi: float, phi: float, share: float, rho: float) -> float:
    scene = make_scene(length, psi, share=share, rho=rho)
    return float(motion_angle(scene, phi, None if share in (0.0, 1.0) else share))


MOTION = Function(
    "motion_angle",
    _motion_angle,
    lambda length, psi, phi, share, rho: references.under_force(
        references.turn, slider(length, psi, share, rho), direction(phi)
    ),
)
KINDS = ((0.0, "friction"), (1.0, "inertia"))
LENGTHS = (1e-8, 1.0, 1e4, 1e6)
#: A force off the rod, and two nearly along it, where the motion of a long rod changes fastest.
FORCE_ANGLES = (0.2, PSI + 1e-6, float(np.nextafter(PSI, 9)))
GYRATION_RADII = (1e-4, 1e-2, 1e2, 1e4)
HALF_TURNS = (float(np.nextafter(np.pi / 2, 0)), float(np.nextafter(np.pi, 0)))
ROD_ANGLES = (1e-300, 1e-8, np.pi / 2, *HALF_TURNS)


def _lengths() -> Iterator[Case]:
    for share, name in KINDS:
        for length in LENGTHS:
            for phi in FORCE_ANGLES:
                label = f"{name}, l = {length:g}, phi = {phi!r}"
                yield Case(label, 3, MOTION, (length, PSI, phi, share, 1.0))
        for psi in ROD_ANGLES:
            yield Case(f"{name}, psi = {psi!r}", 3, MOTION, (2.0, psi, 2.6, share, 1.0))
    for rho in GYRATION_RADII:
        for share in (0.1, 1.0):
            label = f"rho = {rho:g}, share {share:g}"
            yield Case(label, 3, MOTION, (2.0, PSI, 0.2, share, rho))


# --- Line 4: contact ----------------------------------------------------------------------------------


def _edge(side: int, share: float, length: float, psi: float, mu: float) -> float:
    cone = motion_cone(make_scene(length, psi, share=share, mu=mu))
    return float(cone.right if side > 0 else cone.left)


def _exact_edge(side: int, share: float, length: fmpq, psi: fmpq, mu: float) -> Number:
    return references.under_force(references.turn, slider(length, psi, share), cone_edge(mu, side))


STUCK = Function(
    "spin_ratio",
    lambda length, psi, pusher: spin_of_stick(
        make_scene(length, psi, share=0.0, law=PerfectlyRough()), pusher
    ),
    lambda length, psi, pusher: references.sticking_value(
        references.spin, slider(length, psi, 0.0), direction(pusher)
    ),
)
COEFFICIENTS = (0.0, 1e-300, 1e-8, 1.0, 1e8, 1e9, math.inf)


def _contact() -> Iterator[Case]:
    for share, name in KINDS:
        for mu in COEFFICIENTS:
            for side, edge in ((1, "right"), (-1, "left")):
                routes = partial(_edge, side, share), partial(_exact_edge, side, share)
                label = f"{edge} edge, {name}, mu = {mu:g}"
                yield Case(label, 4, Function("motion_angle", *routes), (2.0, PSI, mu))
    cone = motion_cone(make_scene(2.0, PSI, share=0.0, mu=2.0))
    edges = {"0": 0.0, "pi": np.pi, "the right edge": cone.right, "the left edge": cone.left}
    for name, angle in edges.items():
        for towards in (-9.0, 9.0):
            pusher = float(np.nextafter(angle, towards))
            label = f"stick, pusher at {pusher!r}, an ulp off {name}"
            yield Case(label, 4, STUCK, (2.0, PSI, pusher))


# --- Line 5: speeds -----------------------------------------------------------------------------------

SHARED = Function(
    "spin_ratio",
    lambda length, psi, phi, share: float(spin_ratio(make_scene(length, psi, rho=0.7), phi, share)),
    lambda length, psi, phi, share: references.under_force(
        references.spin, slider(length, psi, share, 0.7), direction(phi)
    ),
)
PUSHED = Function(
    "spin_ratio",
    lambda length, psi, pusher, size: spin_of_stick(make_scene(length, psi), pusher, size),
    lambda length, psi, pusher, size: references.sticking_value(
        references.spin, slider(length, psi, None), direction(pusher), size
    ),
)
SHARES = (5e-324, 1e-300, 1e-16, 1e-8, 0.5, 1 - 1e-8, 1 - 2.0**-53)
MAGNITUDES = (1e-12, 1e-8, 1.0, 1e8, 1e12)
#: A moment arm equal to the ring's radius: friction and inertia agree, and H has an infinite slope.
TANGENT = float(PSI - np.arcsin(0.5))


def _speeds() -> Iterator[Case]:
    for phi in (0.2, TANGENT):
        for share in SHARES:
            yield Case(f"phi = {phi:.6g}, share {share!r}", 5, SHARED, (2.0, PSI, phi, share))
    for magnitude in MAGNITUDES:
        yield Case(f"stick at m a / W = {magnitude:g}", 5, PUSHED, (2.0, PSI, 1.0, magnitude))


# --- Line 6: rest -------------------------------------------------------------------------------------


def _wrench(component: int, speed: float, spin: float) -> float:
    return float(wrench(RingFriction(), [speed, 0.0, spin])[component])


def _exact_wrench(part: int, speed: fmpq, spin: fmpq) -> Number:
    """At rest the subgradient closest to zero."""
    if speed == 0:
        return Number(arb((spin > 0) - (spin < 0)) * part, arb(0))
    return references.ring_wrench(part, spin / speed)


RESTING = (
    Function("force", partial(_wrench, 0), partial(_exact_wrench, 0)),
    Function("torque", partial(_wrench, 2), partial(_exact_wrench, 1)),
)
TWISTS = (
    (0.0, 0.0),
    (-0.0, -0.0),
    (5e-324, 0.0),
    (0.0, 5e-324),
    (5e-324, 5e-324),
    (1e-300, -1e-308),
)


def _slow_motions() -> Iterator[Case]:
    for speed, spin in TWISTS:
        for function in RESTING:
            label = f"{function.quantity} at v = {speed:g}, R omega = {spin:g}"
            yield Case(label, 6, function, (speed, spin))


# --- Line 7: two slips --------------------------------------------------------------------------------

#: The published example: l = 2, psi = 45 degrees, mu = 1.4, W = m = rho = R = 1, force on the right edge.
LENGTH, COEFFICIENT = 2.0, 1.4
#: The minimum of n . u, at which the two slips merge.
MINIMUM = -0.04002960666599751
LEVELS = (-1e-8, -1e-4, -0.01, -0.03, -0.04, MINIMUM * (1 - 1e-8), MINIMUM * (1 - 1e-13))


def _slip_ratio(
    branch: int, mu: float, length: float, psi: float, push: float, size: float
) -> float:
    modes = solve(make_scene(length, psi, mu=mu), push, size)
    slips = [solution.spin_ratio for solution in modes if solution.mode is ContactMode.SLIP_LEFT]
    return float(sorted(slips)[branch])


def _exact_slip(branch: int, mu: fmpq, length: fmpq, psi: fmpq, push: fmpq, size: fmpq) -> Number:
    return _exact_slips(mu, length, psi, push, size, precision=ctx.prec)[branch]


@lru_cache(maxsize=32)
def _exact_slips(
    mu: fmpq, length: fmpq, psi: fmpq, push: fmpq, size: fmpq, *, precision: int
) -> list[Number]:
    """Both slips, found once for the cases of both, at the precision of the context in bits."""
    return references.slipping_spins(slider(length, psi, None), mu, direction(push), size)


def _painleve() -> Iterator[Case]:
    for level in LEVELS:
        # The pusher moves far to the right, so that every motion slips to the left.
        push = float(np.arctan2(level, 10.0)), float(np.hypot(level, 10.0))
        for branch, name in enumerate(("fast", "slow")):
            routes = partial(_slip_ratio, branch), partial(_exact_slip, branch)
            label = f"{name} slip at n . u = {level!r}"
            inputs = (COEFFICIENT, LENGTH, PSI, *push)
            yield Case(label, 7, Function("spin_ratio", *routes), inputs)
