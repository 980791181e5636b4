"""Simulated pushes on a known support, with noise like that of measurements."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import ContactLaw, Coulomb
from planar_pushing.mechanics.effects import Effect, SupportFriction
from planar_pushing.mechanics.outline import Outline, require_outline
from planar_pushing.mechanics.outline.chains import RHO
from planar_pushing.mechanics.outline.places import nearest_place
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.supports import Points
from planar_pushing.objects.boundary import OutlineArc, sides_and_arcs
from planar_pushing.objects.scene_at import scene_at
from planar_pushing.pushes.logs.arguments import MOST, noise_attributes, not_negative, whole_number
from planar_pushing.pushes.logs.poses import pushes_from_poses, rotate
from planar_pushing.simulation.early_end import quietly
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.simulate import simulate
from planar_pushing.terms.errors import InvalidValue, require_positive
from planar_pushing.terms.options import Event

#: Fraction of a side at each end in which no push begins.
MARGIN = 0.05
#: Largest angle between a push and the normal of its side, in radians.
WIDEST = math.radians(60.0)
#: Default contact law, that of a smooth finger.
CONTACT = Coulomb(0.25)
#: Default distance of a push, in sizes of the outline.
DISTANCE = 0.1
#: Number of instants of a simulation, and the initial fraction of them that the mean force omits.
SAMPLES, SETTLING = 101, 0.3
#: Initial depth of a finger in the object attributed to rounding, in sizes of the outline; simulations
#: allow more.
ROUNDING = 1e-10
#: Average number of draws per push above which the finger leaves its side too often.
DRAWS = 50


class Drawn(NamedTuple):
    """A randomly drawn push: contact, inward normal of the side, and direction of the finger."""

    point: Array
    normal: Array
    direction: Array


class Pushed(NamedTuple):
    """A simulated push: start of the finger, final pose of the object, and mean force."""

    start: Array
    end: Array
    pose: Array
    force: Array


def simulate_pushes(
    effects: Sequence[Effect],
    outline: Any,
    n: int,
    *,
    noise: tuple[float, float, float] | None = None,
    seed: int = 0,
    contact: ContactLaw = CONTACT,
    distance: float | None = None,
    finger_radius: float = 0.0,
    units: tuple[str, str] = ("mm", "N"),
    name: str = "object",
) -> xr.Dataset:
    """Simulate straight pushes of an object on a known support, as an experiment would measure them.

    Parameters
    ----------
    effects : sequence of SupportFriction
        Support friction in the object's frame; the motion is quasi-static.
    outline : array_like, shape (corners, 2), Polygon, Disc, Outline, or a polygon of shapely
        Corners of the object in order, or its outline with arcs, in its frame. Its holes are not pushed.
    n : int
        Number of pushes, at most 1e7.
    noise : (float, float, float), optional
        Standard deviations of the noise added to each component of the displacement, to the rotation in
        degrees, and to each component of the force.
    seed : int
        The same seed gives the same dataset. Noise does not affect which pushes are drawn.
    contact : ContactLaw
        Contact law between the finger and the object.
    distance : float, optional
        Distance that the finger moves in contact; by default a tenth of the size of the outline.
    finger_radius : float
        Radius of the finger; 0 for a point.
    units : (str, str)
        Names of the units of lengths and forces.
    name : str
        Name of the object.

    Returns
    -------
    xarray.Dataset
        Dataset like that of `load_pushes`. If the support is `Points`, `feet` and `foot_weight` are the
        true values.

    Raises
    ------
    InvalidValue
        If an effect is not friction, a number is not allowed, or the finger reaches a corner too often.

    Notes
    -----
    Contacts are uniformly distributed over the outline except for 5 % at each end of each side and arc, and
    directions are uniformly distributed within 60 degrees of the normal. A push during which the finger
    reaches a corner or touches two places is drawn again; along arcs it goes on. The force is the mean over
    the last 70 % of the push, along the object's axes, which turn with the object.
    """
    friction = _required_friction(effects)
    count = whole_number("n", n, 1, MOST)
    whole = require_outline(outline)
    draws, errors = np.random.default_rng(whole_number("seed", seed, 0)).spawn(2)
    length = DISTANCE * whole.size if distance is None else distance
    reach = require_positive("distance", length, "give a length")
    radius = not_negative("finger_radius", finger_radius, "give 0 for a point")
    pushes: list[Pushed] = []
    for _ in range(DRAWS * count):
        pushed = _push(_draw(whole.exterior, draws), whole, friction, contact, reach, radius)
        pushes += [] if pushed is None else [pushed]
        if len(pushes) == count:
            return _measure(pushes, friction, whole, noise, errors, radius, units, name)
    raise InvalidValue(
        "distance", reach, f"one over which the finger reaches no corner; {len(pushes)} of {n} pushes do",
        "give a shorter distance",
    )  # fmt: skip


def _draw(outline: Outline, random: np.random.Generator) -> Drawn:
    """A random point of an outline and a random direction."""
    parts = sides_and_arcs(outline)
    lengths = np.array([
        abs(part.rho) * (part.high - part.low) if isinstance(part, OutlineArc) else part.length
        for part in parts
    ])  # fmt: skip
    part = parts[random.choice(len(parts), p=lengths / lengths.sum())]
    share = random.uniform(MARGIN, 1.0 - MARGIN)
    angle = random.uniform(-WIDEST, WIDEST)
    if isinstance(part, OutlineArc):
        point, _, normal = part.frame(part.low + share * (part.high - part.low))
    else:
        point, _, normal = part.frame(share * part.length)
    return Drawn(point, normal, rotate(normal, np.array(angle)))


def _push(
    drawn: Drawn,
    outline: Outline,
    effects: tuple[Effect, ...],
    contact: ContactLaw,
    distance: float,
    radius: float,
) -> Pushed | None:
    """Simulate a push at unit speed from the pose (0, 0, 0); None if it ends early."""
    start = drawn.point - radius * drawn.normal
    if nearest_place(outline, start[None]).gap[0] < radius - ROUNDING * outline.size:
        return None
    scene = scene_at(drawn.point, drawn.normal, effects=effects, contact=contact, outline=outline)
    round_tip: dict[str, Any] = {"radius": radius} if radius > 0.0 else {}
    velocity = (float(drawn.direction[0]), float(drawn.direction[1]))
    pusher = Pusher(velocity=velocity, shape="finger", frame="world", **round_tip)
    log = quietly(simulate)(
        scene, pusher=pusher, duration=distance, samples=SAMPLES, object_pose=(0.0, 0.0, 0.0)
    )
    if log.attrs["stopped"] or _reaches_corner(log, outline):
        return None
    position, angle = log["object_position"].values, np.deg2rad(log["object_angle"].values)
    force = _mean_force(log, distance, drawn, angle)
    end = start + log["time"].values[-1] * drawn.direction
    return Pushed(start, end, np.append(position[-1], angle[-1]), force)


def _reaches_corner(log: xr.Dataset, outline: Outline) -> bool:
    """Whether the finger reaches a corner, or a second place, and not only a piece that joins smoothly."""
    if (log["event"].values == Event.PENETRATES).any():
        return True
    pieces = log["contact_piece"].values[log["event"].values == Event.END_OF_SIDE]
    is_joint = (pieces >= 0) & (outline.pieces[pieces, RHO] != 0.0)
    return not bool(is_joint.all())


def _mean_force(log: xr.Dataset, duration: float, drawn: Drawn, angle: Array) -> Array:
    """Mean force over the last part of a push, at equal time steps, along the object's axes.

    It is converted to the world's axes with the object's orientation halfway through the push. Events are
    left out, since the force can jump there.
    """
    smooth = log["event"].values == Event.NONE
    times, force = log["time"].values[smooth], log["force"].values[smooth]
    # The +y axis of a log is the normal at the start; its +x axis is the normal rotated by -90 degrees.
    n_x, n_y = drawn.normal
    world = np.stack(
        [force[:, 0] * n_y + force[:, 1] * n_x, -force[:, 0] * n_x + force[:, 1] * n_y], axis=-1
    )
    even = np.linspace(SETTLING * duration, duration, SAMPLES)
    along_object = rotate(world, angle[-1] / 2.0 - angle[smooth])
    return np.array([np.interp(even, times, part).mean() for part in along_object.T])


def _measure(
    results: list[Pushed], effects: tuple[SupportFriction, ...], outline: Outline, noise: Any,
    random: np.random.Generator, radius: float, units: tuple[str, str], name: str,
) -> xr.Dataset:  # fmt: skip
    """Dataset of the simulated pushes with noise."""
    poses = np.array([push.pose for push in results])
    forces = np.array([push.force for push in results])
    position, angle, strength = (
        noise_attributes(noise).values() if noise is not None else (0.0, 0.0, 0.0)
    )
    poses = poses + random.normal(size=poses.shape) * (position, position, math.radians(angle))
    forces = forces + strength * random.normal(size=forces.shape)
    feet, loads = _truth(effects)
    pushes = pushes_from_poses(
        outline=outline, poses_before=np.zeros_like(poses), poses_after=poses,
        finger_start=[push.start for push in results], finger_end=[push.end for push in results],
        finger_radius=radius, force=forces, feet=feet, foot_weights=loads, units=units, name=name,
        source="simulated", noise=noise,
    )  # fmt: skip
    return pushes.assign_attrs(friction_noise=0.0)


def _required_friction(effects: Any) -> tuple[SupportFriction, ...]:
    """Return support friction, the only effect allowed, or raise `InvalidValue`."""
    friction = tuple(effects) if isinstance(effects, (list, tuple)) else ()
    if not friction or not all(isinstance(effect, SupportFriction) for effect in friction):
        raise InvalidValue(
            "effects",
            effects,
            "a sequence of SupportFriction",
            "leave out effects that are not quasi-static",
        )
    return friction


def _truth(effects: tuple[SupportFriction, ...]) -> tuple[Any, Any]:
    """Feet and their loads, if the object rests only on feet."""
    support = effects[0].support
    if len(effects) > 1 or not isinstance(support, Points):
        return None, None
    return support.positions, support.weights
