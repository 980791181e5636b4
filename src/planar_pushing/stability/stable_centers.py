"""The rotation centers of stable pushes, bounded by the motions under the extreme lines of force."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import groupby
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.contact import InfiniteFriction
from planar_pushing.mechanics.effects import Effect, Inertia
from planar_pushing.mechanics.force.force_motion import motion_of_force
from planar_pushing.mechanics.kernels.arrays import same
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene
from planar_pushing.objects.scene_at import scene_at
from planar_pushing.stability.stable import (
    FENCE,
    effects_in_fence,
    fence_in_body,
    require_flush,
    stable,
)
from planar_pushing.terms.errors import InvalidValue, require_option
from planar_pushing.terms.numbers import require_array
from planar_pushing.terms.options import Sense, StableBound

#: Number of lines of force on each side of the rectangle to begin with.
COARSE = 16
#: Largest distance between successive unit twists, with speeds in radii.
STEP = 0.01
#: Width of the interval of lines, the unit being a side of the rectangle, in which a corner of a curve is
#: found, and in which a jump is: where one line of force belongs to many motions.
CORNER, FINEST = 1e-9, 1e-15
#: Unit twists closer than this are the same motion: a slower rotation is a translation.
SAME = 1e-12
#: Sides of the rectangle of lines of force, in order.
SIDES = StableBound.RIGHT_EDGE, StableBound.END, StableBound.LEFT_EDGE, StableBound.START


@dataclass(frozen=True, slots=True, kw_only=True)
class StableCurve:
    """A part of the boundary of the stable pushes, of one sense and with one reason.

    Attributes
    ----------
    bound : StableBound
        The reason: which limit of the forces at the ends of the side the load is at.
    sense : Sense
    twists : ndarray, shape (n, 3)
        (v_x, v_y, omega) about the origin of the object's frame, in order along the curve; omega in radians
        per unit of time. Their sizes have no meaning. A curve that goes to infinity ends at a translation.
        A pivot is one twist, which is itself not stable.
    """

    bound: StableBound
    sense: Sense
    twists: Array

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    @property
    def centers(self) -> Array:
        """Rotation centers in the object's frame, shape (n, 2); infinite for a translation."""
        v_x, v_y, omega = self.twists.T
        sign = 1.0 if self.sense is Sense.COUNTERCLOCKWISE else -1.0
        with np.errstate(divide="ignore", invalid="ignore"):
            centers = np.stack([-v_y, v_x], axis=-1) / (sign * np.abs(omega))[:, None]
        return np.where(np.isnan(centers), 0.0, centers) + 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class StableCenters:
    """The set of rotation centers for which a push with a flat side is stable, for each sense of rotation.

    Attributes
    ----------
    scene : Scene
    curves : tuple of StableCurve
        The boundary, once around the set of stable twists with the set on the right: a curve begins where
        the one before it ends. Where a curve goes to infinity, the next one comes from there on the other
        side with the other sense, and the stable translations connect both sets. A pivot is a corner of the
        set, to which it does not belong; a pivot alone means that no push is stable, because the object
        turns about that foot under every force. Without friction at the contact the set is the curve. With
        `PerfectlyRough` every push is stable, and there are no curves.
    """

    scene: Scene
    curves: tuple[StableCurve, ...]

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    def contains(self, center: npt.ArrayLike, sense: Sense | str) -> Any:
        """Whether rotations about centers are stable.

        Parameters
        ----------
        center : array_like, shape S + (2,)
            In the object's frame.
        sense : Sense or {"counterclockwise", "clockwise"}

        Returns
        -------
        bool, or ndarray of bool of shape S

        Raises
        ------
        InvalidValue
            If a center is not two finite numbers, or there is no such sense.
        """
        allowed = "finite numbers of shape S + (2,)", "give x and y in the object's frame"
        centers = require_array("center", center, *allowed)
        if centers.shape[-1:] != (2,) or not np.isfinite(centers).all():
            raise InvalidValue("center", center, *allowed)
        turn = require_option("sense", sense, Sense, "name one of these")
        omega = np.full(centers.shape[:-1], 1.0 if turn is Sense.COUNTERCLOCKWISE else -1.0)
        twist = [omega * centers[..., 1], -omega * centers[..., 0], omega]
        return stable(self.scene, np.stack(twist, axis=-1))


def stable_centers(scene: Scene) -> StableCenters:
    """The set of rotation centers, per sense, for which a side stays on a fence that moves and rotates.

    Parameters
    ----------
    scene : Scene
        Its side lies on the fence, as in ``scene_at(side=...)``. Without inertia, and with Coulomb friction
        or viscous friction alone.

    Returns
    -------
    StableCenters
        Its boundary as curves of rotation centers, each with its reason.

    Raises
    ------
    InvalidValue
        If the side is not on the fence, the scene has inertia or is an array of scenes, friction cannot
        hold a load, or the set depends on the speed: viscous friction beside Coulomb friction or a load.

    Notes
    -----
    The ends of the side exert the forces of a convex cone with four edges: the forces along an edge of the
    law's cone through an end (Lynch and Mason, "Stable pushing: mechanics, controllability, and planning",
    IJRR 15(6), 1996). Its faces consist of lines of force. A line crosses the side at x at the angle phi,
    and the lines on the faces are those on the boundary of the rectangle of all (x, phi). Each line is the
    load of one twist, the root that `motion_of_force` finds. There are two exceptions: about a foot the
    object turns under many lines of force, and with a support on one line a line of force can belong to
    many twists, those between the two that enclose it. A load has the direction that it has in the scene;
    in the object's frame it turns as the object moves on.
    """
    flush = require_flush(scene)
    if not flush.rows.is_steady:
        raise InvalidValue(
            "scene", "a scene with viscous friction and another effect",
            "Coulomb friction, with or without loads, or viscous friction alone",
            "ask stable(scene, twist) instead: which pushes are stable depends on the speed",
        )  # fmt: skip
    if flush.law.rough:
        return StableCenters(scene=flush, curves=())
    motions = _with_translations(_boundary(flush))
    radius = flush.slider.radius
    twists = flush.to_object(motions.twist * [radius, radius, 1.0], "twist")
    return StableCenters(scene=flush, curves=_curves(motions, twists))


class FaceMotions(NamedTuple):
    """Motions under lines of force on the faces of the cone.

    Attributes
    ----------
    position : ndarray, shape (n,)
        Where the line is on the boundary of the rectangle, from 0 to 4.
    twist : ndarray, shape (n, 3)
        Unit twists about the slider's center, in the fence frame, speeds in radii.
    pivots : ndarray of bool, shape (n,)
        Whether the object turns about a foot.
    """

    position: Array
    twist: Array
    pivots: npt.NDArray[np.bool_]

    @property
    def gaps(self) -> Array:
        """Distances between successive twists."""
        return np.asarray(np.linalg.norm(np.diff(self.twist, axis=0), axis=-1))

    def insert(self, before: npt.NDArray[np.intp], other: FaceMotions) -> FaceMotions:
        """These motions, with other ones inserted after those with the given numbers."""
        pairs = zip(self, other, strict=True)
        return FaceMotions(*(np.insert(array, before + 1, new, axis=0) for array, new in pairs))


def _boundary(scene: Scene) -> FaceMotions:
    """Motions once around the rectangle, as close as `STEP` except at jumps."""
    effects = _steady_effects(scene)
    # Without friction at the contact, two sides coincide and the others are points.
    sides = 1 if scene.law.right == scene.law.left else 4
    motions = _motions(scene, effects, np.linspace(0.0, sides, sides * COARSE + 1))
    while True:
        wide, turn = np.diff(motions.position), motions.twist[:, 2]
        jumps = (motions.gaps > STEP) | (turn[:-1] * turn[1:] < 0.0)
        corner = (np.diff(motions.pivots) != 0) & (wide > CORNER)
        open_gaps = np.flatnonzero((jumps | corner) & (wide > FINEST))
        if not len(open_gaps):
            return motions
        middle = (motions.position[:-1] + 0.5 * wide)[open_gaps]
        motions = motions.insert(open_gaps, _motions(scene, effects, middle))


def _steady_effects(scene: Scene) -> tuple[Effect, ...]:
    """Effects in the fence frame; viscous friction as the inertia whose potential is the same.

    The body can have many contacts then.
    """
    if not scene.viscous:
        return effects_in_fence(scene)
    radius, masses = scene.slider.radius, []
    for entry in scene.rows.entries:
        body = entry.values
        coefficient, square = body["mass"], body["gyration"]
        x, y = body["center_x"], body["center_y"]
        mass = Inertia(
            mass=coefficient, gyration_radius=radius * square**0.5, center=(radius * x, radius * y)
        )
        masses.append(mass.in_frames(fence_in_body(scene), FENCE))
    return tuple(masses)


def _motions(scene: Scene, effects: tuple[Effect, ...], position: Array) -> FaceMotions:
    """Motions under the lines of force at places on the boundary of the rectangle."""
    (start, end), law = scene.slider.side, scene.law
    # Lines along the fence are the same wherever they cross it.
    crossing = np.interp(position, [0.0, 1.0, 2.0, 3.0, 4.0], [start, end, end, start, start])
    angle = np.interp(
        position, [0.0, 1.0, 2.0, 3.0, 4.0], [law.right, law.right, law.left, law.left, law.right]
    )
    points = np.stack([crossing, np.zeros_like(crossing)], axis=-1)
    many = scene_at(points, (0.0, 1.0), effects=effects, contact=InfiniteFriction())
    motion = motion_of_force(many, angle)
    twist = many.to_object(motion.twist, "twist")
    x, y = scene._center
    twist = twist + twist[:, 2:] * np.array([-y, x, 0.0])
    twist[:, :2] /= scene.slider.radius
    twist = twist / np.linalg.norm(twist, axis=-1, keepdims=True)
    twist[np.abs(twist[:, 2]) <= SAME, 2] = 0.0
    return FaceMotions(position, twist, np.asarray(motion.pivot) >= 0)


def _with_translations(motions: FaceMotions) -> FaceMotions:
    """The motions with those of a jump, which are on a line, and with the translations between senses."""
    turn = motions.twist[:, 2]
    crosses = turn[:-1] * turn[1:] < 0.0
    share = np.abs(turn[:-1] / np.where(crosses, turn[1:] - turn[:-1], np.inf))[crosses]
    before = np.flatnonzero(crosses)
    across = _motions_between(motions, before, share)
    across.twist[:, 2] = 0.0
    motions = motions.insert(before, across)
    jumps = np.flatnonzero(motions.gaps > STEP)
    counts = np.ceil(motions.gaps[jumps] / STEP).astype(int)
    shares = [np.arange(1, count) / count for count in counts]
    before = np.repeat(jumps, counts - 1)
    return motions.insert(before, _motions_between(motions, before, np.concatenate([[], *shares])))


def _motions_between(
    motions: FaceMotions, before: npt.NDArray[np.intp], share: Array
) -> FaceMotions:
    """Motions between some of the motions and the next ones, at their places."""
    one, other = motions.twist[before], motions.twist[before + 1]
    twist = one + share[:, None] * (other - one)
    twist = twist / np.linalg.norm(twist, axis=-1, keepdims=True)
    return FaceMotions(motions.position[before], twist, np.zeros(len(before), dtype=bool))


def _curves(motions: FaceMotions, twists: Array) -> tuple[StableCurve, ...]:
    """The motions as curves of one reason and one sense; lines with the same motion belong to none."""
    sides = np.minimum(0.5 * (motions.position[:-1] + motions.position[1:]), 3.0).astype(int)
    turn = motions.twist[:-1, 2] + motions.twist[1:, 2]
    stays = motions.gaps <= SAME
    pivots = motions.pivots[:-1] & motions.pivots[1:] & stays

    def key(i: int) -> tuple[StableBound, Sense]:
        sense = Sense.COUNTERCLOCKWISE if turn[i] > 0.0 else Sense.CLOCKWISE
        return StableBound.PIVOT if pivots[i] else SIDES[sides[i]], sense

    curves = []
    drawn = np.flatnonzero((pivots | ~stays) & (turn != 0.0)).tolist()
    for (bound, sense), members in groupby(drawn, key):
        part = [*members]
        rows = part[:1] if bound is StableBound.PIVOT else [*part, part[-1] + 1]
        curves.append(StableCurve(bound=bound, sense=sense, twists=twists[rows]))
    # The rectangle's first corner can be within the lines of a pivot.
    if len(curves) > 1 and curves[0].bound is curves[-1].bound is StableBound.PIVOT:
        curves.pop()
    return tuple(curves)
