"""Estimates, from the run without an effect, of what that effect changes; and the change of a pose.

An effect that is left out can matter in two ways. What the slider keeps of its speed, inertia spends on
friction: the *stopping length* is how far a slider with the largest speed and spin of the run would coast,
``S = v^2 m / (2 W) + r rho^2 omega^2 m / (2 T)``, with W the force and T the torque of the friction, and r
the distance of the farthest point of the outline from the center of mass. And along the way, the effect is
a share of friction: the *drift* D is the sum of its shares of force and torque, each times the way of the
farthest point. The pose changes by less than `FACTOR` times S + D.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.effects import Effect, Inertia, Load, Viscous
from planar_pushing.mechanics.force.wrench import wrench
from planar_pushing.mechanics.outline.chains import BETA0, BETA1, RHO, X, Y
from planar_pushing.mechanics.plane import Array, Frame, direction
from planar_pushing.mechanics.scene import Scene

if TYPE_CHECKING:
    from planar_pushing.simulation.pusher import Pusher

#: A log of `simulate`, or arrays of its variables, by name.
Log = Mapping[Any, Any]
#: Largest change of a pose divided by its estimate S + D, with a margin: in random pushes of boxes the
#: largest ratios were 3.6 for inertia, 6.7 for loads and 0.7 for viscous friction.
FACTOR = 8.0
#: Part of the intervals of a run whose shares of friction are at most the share that is told.
MOST = 0.95
#: Times this close, relative to the larger one, are the same.
SAME_TIME = 1e-9


class Estimate(NamedTuple):
    """What leaving out an effect may change, estimated from the run without it.

    Attributes
    ----------
    force_share, torque_share : float
        Force of the effect divided by that of friction, W, and its torque at the slider's center divided by
        that of friction in a rotation about this center; 95 percent of the run have at most this. NaN for
        friction itself, if no other friction is left, and without an interval in which they are known.
    stopping : float
        S, the stopping length, in the scene's unit of length; zero without inertia.
    drift : float
        D, in the scene's unit of length; infinite for friction, which has no estimate.
    """

    force_share: float
    torque_share: float
    stopping: float
    drift: float

    @property
    def total(self) -> float:
        """S + D, in the scene's unit of length."""
        return self.stopping + self.drift


#: Nothing is known: friction is left out, or nothing is left that resists.
UNKNOWN = Estimate(np.nan, np.nan, 0.0, np.inf)


class Shares(NamedTuple):
    """Shares of friction in the intervals of a run, shape (intervals,) each.

    Attributes
    ----------
    force, torque : ndarray
        As in `Estimate`.
    way : ndarray
        Way of the farthest point of the outline in the interval.
    is_smooth : ndarray of bool
        Whether the pusher's velocity does not jump in the interval.
    """

    force: Array
    torque: Array
    way: Array
    is_smooth: npt.NDArray[np.bool_]


def body_frame(scene: Scene) -> Frame:
    """The body frame at time 0, in the object's frame."""
    axis = direction(scene.slider.rod_angle)
    origin = scene.to_object(scene.slider.rod_length * axis, "point")
    (x, y), (a, b) = origin.tolist(), scene.to_object(axis, "vector").tolist()
    return Frame((x, y), (a, b))


def outline_circles(scene: Scene) -> Array:
    """Circles whose points are the farthest of an object: its corners, and the circles of its arcs.

    Parameters
    ----------
    scene : Scene
        One scene. Without an outline, the circle has the extent of the support, the slider's radius, about
        the slider's center.

    Returns
    -------
    ndarray, shape (circles, 3)
        Center in the object's frame, x and y, and radius, 0 for a corner.
    """
    body, slider = body_frame(scene), scene.slider
    outline = slider.outline_in_body()
    if outline is None:
        return np.array([[*body.origin, float(slider.radius)]])
    circles = [_farthest_circles(piece) for piece in outline.exterior.pieces]
    x, y, radius = np.concatenate(circles).T
    return np.column_stack([body.point_out(np.column_stack([x, y])), radius])


def _farthest_circles(piece: Array) -> Array:
    """Rows (x, y, radius) of a piece of an outline that can hold the farthest point.

    These are a corner, the circle of an arc of 180 degrees or more, and points 3 degrees apart on another
    arc. A side ends in one of these, and a hollow arc lies between them.
    """
    x, y, radius, start, end = piece[[X, Y, RHO, BETA0, BETA1]]
    if not 0.0 <= radius < np.inf or end < start:
        return np.empty((0, 3))
    if radius == 0.0 or end - start >= np.pi:
        return np.array([[x, y, radius]])
    beta = np.linspace(start, end, 2 + int((end - start) / np.deg2rad(3.0)))
    points = x + radius * np.sin(beta), y - radius * np.cos(beta)
    return np.column_stack([*points, np.zeros(len(beta))])


class Poses(NamedTuple):
    """Poses of an object as complex numbers: a point p of its frame is at ``position + turn p``.

    Attributes
    ----------
    position, turn : ndarray of complex
    """

    position: npt.NDArray[np.complex128]
    turn: npt.NDArray[np.complex128]

    def __sub__(self, other: Poses) -> Poses:
        """The displacements, which are linear in the point, from other poses to these."""
        return Poses(self.position - other.position, self.turn - other.turn)

    def reach(self, circles: Array) -> Array:
        """The largest displacement over circles, as of `outline_circles`, for each of the displacements."""
        centers, radii = circles[:, :1] + 1j * circles[:, 1:2], circles[:, 2:]
        return np.asarray(
            (np.abs(self.position + centers * self.turn) + radii * np.abs(self.turn)).max(axis=0)
        )


def poses(log: Log, rows: Any) -> Poses:
    """The poses in rows of a log with an `object_pose`."""
    x, y = np.asarray(log["object_position"])[rows].T
    return Poses(x + 1j * y, np.exp(1j * np.deg2rad(np.asarray(log["object_angle"])[rows])))


def pose_change(log: Log, other: Log, circles: Array) -> float:
    """Largest displacement between two runs of an object, over its outline and over the common instants.

    Parameters
    ----------
    log, other : xarray.Dataset or mapping
        Logs of `simulate`, or their variables by name, with an `object_pose`; a displacement at a time is
        known if both have an entry.
    circles : ndarray, shape (circles, 3)
        Those of `outline_circles`.

    Returns
    -------
    float
        In the scene's unit of length: one number for displacement and rotation.
    """
    _, first, second = np.intersect1d(log["time"], other["time"], return_indices=True)
    return float((poses(other, second) - poses(log, first)).reach(circles).max())


def way_of(log: Log, circles: Array) -> Array:
    """Way of the farthest point of the outline in each interval of a log, shape (intervals,)."""
    places = poses(log, _first_entries(log))
    steps = Poses(np.diff(places.position), np.diff(places.turn))
    return steps.reach(circles)


def stopping_length(log: Log, scene: Scene, inertia: Inertia, circles: Array) -> float:
    """How far the slider would coast from the largest speed and spin of a run, on its friction.

    Parameters
    ----------
    log : xarray.Dataset or mapping
        Run without the inertia: a log of `simulate`, or its variables by name.
    scene : Scene
        The scene of the run, with friction.
    inertia : Inertia
        In the body frame, as in `Scene.effects`.
    circles : ndarray, shape (circles, 3)
        Those of `outline_circles`.

    Returns
    -------
    float
        S, in the scene's unit of length.
    """
    _, twists, angles = _motion(log)
    arm = _rotate(inertia.center, angles)
    speeds = np.hypot(*_velocities_at(twists, arm).T)
    moment = inertia.mass * inertia.gyration_radius**2
    center = body_frame(scene).point_out(inertia.center)
    reach = np.max(np.hypot(*(circles[:, :2] - center).T) + circles[:, 2])
    force, torque = _friction(scene)
    sliding = inertia.mass * np.max(speeds) ** 2 / (2.0 * force)
    return float(sliding + moment * np.max(twists[:, 2] ** 2) / (2.0 * torque) * reach)


def friction_shares(
    log: Log, scene: Scene, effect: Effect, circles: Array, jumps: Sequence[float] = ()
) -> Shares:
    """Force and torque of an effect in the intervals of a run without it, as shares of those of friction.

    Parameters
    ----------
    log, scene, effect, circles
        As in `stopping_length`; the effect is `Inertia`, `Viscous` or `Load`, and the log has an
        `object_pose`.
    jumps : sequence of float
        Times at which the velocity of the pusher jumps, as of `jump_times`.
    """
    times, twists, angles = _motion(log)
    force, torque = _wrenches(effect, scene, times, twists, angles)
    weight, hold = _friction(scene)
    is_smooth = np.ones(len(times) - 1, bool)
    for jump in jumps:
        before, after = times[:-1] <= jump * (1 + SAME_TIME), times[1:] >= jump * (1 - SAME_TIME)
        is_smooth &= ~(before & after)
    sizes = np.hypot(*force.T) / weight, np.abs(torque) / hold
    return Shares(*sizes, way_of(log, circles), is_smooth)


def estimate_pose_change(
    log: Log, scene: Scene, effect: Effect, circles: Array, jumps: Sequence[float] = ()
) -> Estimate:
    """Estimate what an effect changes that a run leaves out; parameters as in `friction_shares`.

    Friction that is left out has no estimate but its weight over that of the rest.
    """
    if not scene.friction:
        return UNKNOWN
    if not isinstance(effect, (Inertia, Viscous, Load)):
        weight: Any = effect.weight  # type: ignore[attr-defined]
        return UNKNOWN._replace(force_share=float(weight / scene.weight))
    stopping = 0.0
    if isinstance(effect, Inertia):
        stopping = stopping_length(log, scene, effect, circles)
    shares = friction_shares(log, scene, effect, circles, jumps)
    known = shares.is_smooth
    if not known.any():
        return UNKNOWN._replace(stopping=stopping, drift=0.0)
    force, torque = shares.force[known], shares.torque[known]
    return Estimate(
        force_share=float(np.quantile(force, MOST)),
        torque_share=float(np.quantile(torque, MOST)),
        stopping=stopping,
        drift=float(((force + torque) * shares.way[known]).sum()),
    )


def jump_times(pusher: Pusher) -> list[float]:
    """Times after the start at which the velocity of a pusher jumps, or is not smooth."""
    starts = [start for start, _ in pusher.velocities]
    return [*starts[1:], *pusher.breakpoints]


def _friction(scene: Scene) -> tuple[float, float]:
    """W, and the torque of friction in a rotation about the slider's center."""
    twist = (0.0, 0.0, 1.0)
    torques = [abs(wrench(effect, twist, scene.slider)[2]) for effect in scene.friction]
    return float(scene.weight), float(sum(torques))


def _wrenches(
    effect: Effect, scene: Scene, times: Array, twists: Array, angles: Array
) -> tuple[Array, Array]:
    """Forces, shape (intervals, 2), and torques of an effect along a motion, in the fence's axes."""
    steps, middles = np.diff(times), (angles[1:] + angles[:-1]) / 2.0
    if isinstance(effect, Inertia):
        velocities = _velocities_at(twists, _rotate(effect.center, angles))
        force = effect.mass * np.diff(velocities, axis=0) / steps[:, None]
        moment = effect.mass * effect.gyration_radius**2
        spin = moment * np.diff(twists[:, 2]) / steps
        return force, spin + _torque(_rotate(effect.center, middles), force)
    if isinstance(effect, Load):
        force = np.tile(np.array(effect.force, dtype=float), (len(steps), 1))
        center = (0.0, 0.0) if effect.center is None else effect.center
        return force, _torque(_rotate(center, middles), force)
    twist = (twists[1:] + twists[:-1]) / 2.0
    body = _rotate(twist[:, :2].T, -middles)
    wrenches = wrench(effect, np.column_stack([body, twist[:, 2]]), scene.slider)
    return _rotate(wrenches[:, :2].T, middles), wrenches[:, 2]


def _first_entries(log: Log) -> npt.NDArray[np.int64]:
    """Rows of the first entry of each instant; an event has two at its time."""
    times = np.asarray(log["time"])
    later = np.diff(times) > 1e-12 * times[-1]
    return np.flatnonzero(np.concatenate([[True], later]))


def _motion(log: Log) -> tuple[Array, Array, Array]:
    """Times, twists at the slider's center and angles of the body in radians, in the fence's axes."""
    rows = _first_entries(log)
    times, twists, angles = (np.asarray(log[name])[rows] for name in ("time", "twist", "rod_angle"))
    return times, twists, np.deg2rad(angles)


def _rotate(vector: Any, angle: Array) -> Array:
    """Rotate pairs of components by angles; both components come last."""
    x, y = (np.asarray(component, dtype=float) for component in vector)
    c, s = np.cos(angle), np.sin(angle)
    return np.stack([x * c - y * s, x * s + y * c], axis=-1)


def _velocities_at(twists: Array, arms: Array) -> Array:
    """Velocities of points at arms from the slider's center."""
    spin = twists[:, 2:]
    return twists[:, :2] + spin * np.stack([-arms[:, 1], arms[:, 0]], axis=-1)


def _torque(arms: Array, forces: Array) -> Array:
    """Torques of forces at arms from the slider's center."""
    return arms[:, 0] * forces[:, 1] - arms[:, 1] * forces[:, 0]
