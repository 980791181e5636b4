"""Enumeration of the contact modes, elementwise over the pusher's motions (Secs. 2-5)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.angles import RESOLUTION
from planar_pushing.mechanics.contact import ContactLaw, ContactMode, Outcome
from planar_pushing.mechanics.contact.laws import friction_coefficient
from planar_pushing.mechanics.errors import InvalidValue
from planar_pushing.mechanics.planar import Array, direction, moment_arm, parts_along_rod
from planar_pushing.mechanics.response import (
    Resistance,
    resistance,
    spin_ratio_of,
    sustained_twist,
)
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.slipping import slip_motions

#: Motions closer than this, relative to the pusher's, are one motion: a slip that vanishes is a stick.
COINCIDENCE = 1e-12


Found = npt.NDArray[np.bool_]


@dataclass(frozen=True, slots=True, kw_only=True)
class Candidates:
    """Motions that one contact mode admits, for pusher motions of shape S.

    Attributes
    ----------
    mode : ContactMode
    consistent : ndarray of bool, shape S + (branches,)
    twist : ndarray, shape S + (branches, 3)
        (v_x, v_y, R omega) at the ring centre, in units of the pusher's magnitude.
    force : ndarray, shape S + (branches, 2)
        Force of the pusher on the slider, in units of `force_unit`.
    spin_ratio : ndarray, shape S + (branches,)
        k = R omega / v with v along the force; 0 at rest.
    force_unit : ndarray, shape S
        The force of friction or, where it is larger, that of inertia in a translation as the pusher's.
    """

    mode: ContactMode
    consistent: Found
    twist: Array
    force: Array
    spin_ratio: Array
    force_unit: Array

    @property
    def force_angle(self) -> Array:
        """Force angle phi in (-pi, pi], shape S + (branches,)."""
        angle = np.arctan2(self.force[..., 1], self.force[..., 0])
        return np.where(angle <= -np.pi + RESOLUTION, np.pi, angle)


@dataclass(frozen=True, slots=True, kw_only=True)
class Push:
    """What every contact law has in common under the pusher's motions: the motion that sticks.

    Attributes
    ----------
    resisting : Resistance
    pusher : ndarray, shape S + (2,)
        Unit vectors; 0 where the pusher rests.
    moves : ndarray of bool, shape S + (1,)
    twist, force, spin_ratio : ndarray, shapes S + (3,), S + (2,), S
        Of the slider that follows the pusher; units as in `Candidates`.
    center_motion : ndarray, shape S + (2,)
        The centre's motion along the rod and along its right-hand normal, neither a difference.
    carried : ndarray, shape S
        Part of the pusher's motion across the rod that the centre takes, in (0, 1].
    """

    resisting: Resistance
    pusher: Array
    moves: Found
    twist: Array
    force: Array
    spin_ratio: Array
    center_motion: Array
    carried: Array


#: Candidates of separation, of sticking and, where the contact slips, of slips right and left.
Modes = tuple[Candidates, ...]
SLIPS = (ContactMode.SLIP_RIGHT, ContactMode.SLIP_LEFT)
#: A slip, and where one of its motions is the pusher's own: a stick.
Slip = tuple[Candidates, Found]


def slip_edge(law: ContactLaw, mode: ContactMode) -> float:
    """Angle of the force under which the contact slips, radians."""
    angles = law.force_angles
    return angles.left if mode is ContactMode.SLIP_RIGHT else angles.right


def contact_motion(scene: Scene, twist: Array) -> Array:
    """Contact motions, shape S + (2,), of twists (v_x, v_y, R omega) of shape S + (3,)."""
    arm = scene.slider.length_ratio * direction(scene.slider.rod_angle)
    turned = twist[..., 2:] * np.array([arm[1], -arm[0]])
    return np.asarray(twist[..., :2] + turned)


def _separate(given: Push) -> Candidates:
    rest = np.zeros((*given.pusher.shape[:-1], 1, 3))
    return Candidates(
        mode=ContactMode.SEPARATE,
        consistent=given.pusher[..., 1:] <= 0,
        twist=rest,
        force=rest[..., :2],
        spin_ratio=rest[..., 0],
        force_unit=given.resisting.force,
    )


def push(
    scene: Scene, pusher_direction: npt.ArrayLike, pusher_magnitude: npt.ArrayLike = 1.0
) -> Push:
    """Solve for the motion that sticks, whatever the contact law; arguments as for `candidates`."""
    slider = scene.slider
    towards, size = np.asarray(pusher_direction, dtype=float), np.asarray(pusher_magnitude)
    shape = np.broadcast_shapes(towards.shape[:-1], size.shape)
    moves = np.broadcast_to(size > 0, shape)[..., None]
    resisting = resistance(scene.scaled_effects, np.broadcast_to(size, shape))
    pusher = np.where(moves, towards, 0.0)
    parts = parts_along_rod(slider.rod_angle, pusher)
    along_rod, carried = sustained_twist(resisting, slider.length_ratio, *parts)
    e = direction(slider.rod_angle)
    axes = np.array([[e[0], e[1], 0.0], [e[1], -e[0], 0.0], [0.0, 0.0, 1.0]])
    return Push(
        resisting=resisting,
        pusher=pusher,
        moves=moves,
        twist=along_rod @ axes,
        force=resisting.wrench(along_rod)[..., :2] @ axes[:2, :2],
        spin_ratio=spin_ratio_of(along_rod),
        center_motion=along_rod[..., :2],
        carried=carried,
    )


def _transmits(scene: Scene, given: Push) -> tuple[Found, Found]:
    """Whether the contact transmits the force that sticks, shape S + (1,): inside its cone, or on an edge.

    The force is along the centre's motion, which is known as well as the pusher's direction, to
    `RESOLUTION`, of which a long rod carries a small part.
    """
    cone, rod_angle = scene.contact.force_angles, scene.slider.rod_angle
    bounds = [cone.right, cone.left, (cone.right + cone.left) / 2]
    (right, left, middle), _ = parts_along_rod(rod_angle, direction(bounds))
    below, above, beside = moment_arm(1.0, rod_angle, bounds)  # to the same rounding as in a slip
    # Turn of the force from the right edge, its turn to the left edge, its part along the middle.
    of_each = np.array([[below, -right], [-above, left], [middle, beside]]).T
    ahead, aside = of_each.reshape(2, 3, *(1 for _ in given.carried.shape))
    v, w = np.moveaxis(given.center_motion, -1, 0)
    noise = RESOLUTION * (np.abs(ahead) + given.carried * np.abs(aside))
    depth = v * ahead + w * aside
    inside, reached = depth > noise, depth >= -noise
    if cone.span > np.pi:
        inside, reached = inside[:2].any(axis=0), reached[:2].any(axis=0)
    else:
        inside, reached = inside.all(axis=0), reached.all(axis=0)
    return inside[..., None], reached[..., None]


def _stick(given: Push, consistent: Found) -> Candidates:
    return Candidates(
        mode=ContactMode.STICK,
        consistent=consistent & given.moves,
        twist=given.twist[..., None, :],
        force=given.force[..., None, :],
        spin_ratio=given.spin_ratio[..., None],
        force_unit=given.resisting.force,
    )


def _slips(scene: Scene, laws: Sequence[ContactLaw], given: Push) -> Iterator[tuple[Slip, Slip]]:
    """Motions under a force on each edge of each law, in the order of `SLIPS`, solved for together."""
    if not laws:
        return
    resisting, rod = given.resisting, (scene.slider.length_ratio, scene.slider.rod_angle)
    edges = np.array([[slip_edge(law, mode) for mode in SLIPS] for law in laws])
    speed, ratio, exists = slip_motions(resisting, *rod, edges, given.pusher[..., 1])
    over_pushes = *edges.shape, *(1 for _ in ratio.shape[2:])
    heading = np.broadcast_to(direction(edges.reshape(over_pushes)), (*ratio.shape, 2))
    with np.errstate(over="ignore", invalid="ignore"):
        twist = speed[..., None] * np.concatenate([heading, ratio[..., None]], axis=-1)
        motion = contact_motion(scene, twist)
        force = resisting.branches().profile(np.abs(ratio), speed)[0][..., None] * heading
    _require_doubles(laws, motion)
    side = np.array([1, -1]).reshape(2, *over_pushes[2:])
    slip = side * (motion[..., 0] - given.pusher[..., :1])
    consistent = exists & (slip > COINCIDENCE)
    at_edge = np.any(exists & (np.abs(slip) <= COINCIDENCE), axis=-1)
    for i in range(len(laws)):
        right, left = (
            Candidates(
                mode=mode,
                consistent=consistent[i, j],
                twist=twist[i, j],
                force=force[i, j],
                spin_ratio=ratio[i, j],
                force_unit=resisting.force,
            )
            for j, mode in enumerate(SLIPS)
        )
        yield (right, at_edge[i, 0]), (left, at_edge[i, 1])


def _require_doubles(laws: Sequence[ContactLaw], motions: Array) -> None:
    for law, motion in zip(laws, motions, strict=True):
        if not np.isfinite(motion).all():
            raise InvalidValue(
                "friction_coefficient", friction_coefficient(law),
                "one under which the slips are doubles", "use the law of infinite friction",
            )  # fmt: skip


def candidates(
    scene: Scene, pusher_direction: npt.ArrayLike, pusher_magnitude: npt.ArrayLike = 1.0
) -> Modes:
    """Enumerate the contact modes, elementwise over the pusher's motions.

    Parameters
    ----------
    scene : Scene
    pusher_direction : array_like, shape S + (2,)
        Unit vectors.
    pusher_magnitude : array_like
        >= 0, broadcast against S.

    Raises
    ------
    InvalidValue
        Where the doubles do not hold the force that the motion meets, or the motion of a slip.
    """
    given = push(scene, pusher_direction, pusher_magnitude)
    return modes_under(scene, [scene.contact], given)[0]


def modes_under(scene: Scene, laws: Sequence[ContactLaw], given: Push) -> list[Modes]:
    """Enumerate the contact modes of several laws under a push of the scene's slider and effects."""
    slips = _slips(scene, [law for law in laws if law.slips], given)
    return [
        _modes(replace(scene, contact=law), given, next(slips) if law.slips else None)
        for law in laws
    ]


def _modes(scene: Scene, given: Push, slips: tuple[Slip, Slip] | None) -> Modes:
    """Enumerate the contact modes; `slips` holds the motions under a force on each edge, if it slips.

    Notes
    -----
    At an edge of the motion cone stick and slip are one solution. Rounding moves the force and the
    motion of that edge apart by the cone's condition number, so there a stick counts where no slip does,
    and a slip that vanishes counts as the stick.
    """
    inside, reached = _transmits(scene, given)
    if slips is None:
        held = reached if scene.contact.force_angles.closed else inside
        return _separate(given), _stick(given, held)
    (right, left_edge), (left, right_edge) = slips
    slides = right.consistent.any(axis=-1) | left.consistent.any(axis=-1)
    # Both edges of a cone narrower than rounding: beside one that slips the other does not stick.
    left_edge &= ~left.consistent.any(axis=-1)
    right_edge &= ~right.consistent.any(axis=-1)
    at_edge = np.asarray(left_edge | right_edge)[..., None]
    held = inside | (reached & ~np.asarray(slides)[..., None]) | at_edge
    return _separate(given), _stick(given, held), right, left


def outcomes(found: Modes) -> npt.NDArray[np.int8]:
    """Outcome (values of `Outcome`) for each pusher motion, shape S."""
    count = np.sum([each.consistent.sum(axis=-1) for each in found], axis=0)
    return np.asarray(np.minimum(count, Outcome.AMBIGUOUS), dtype=np.int8)
