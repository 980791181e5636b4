"""The wrench that sustains a twist of an object, with or without the friction of one foot."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import pi
from typing import Any

import numpy as np

from planar_pushing.mechanics.contact import PerfectlyRough
from planar_pushing.mechanics.effects import Effect, Inertia, Load, SupportFriction, Viscous
from planar_pushing.mechanics.force.held import require_held
from planar_pushing.mechanics.force.wrench import wrench
from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.pressure.assembly import scale_shares
from planar_pushing.mechanics.pressure.pieces import ATOMS, Pieces
from planar_pushing.mechanics.rows import extents
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.slider import Slider
from planar_pushing.mechanics.supports import Polygon, Ring
from planar_pushing.mechanics.supports.base import InPieces
from planar_pushing.terms.caches import cache_results
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import Number

#: Number of supports that are cached without their feet.
KEPT = 16
#: A slider whose body frame has its origin at the contact and its x axis along the normal of the fence.
UPRIGHT = Slider(rod_length=0.0, rod_angle=pi / 2)


@dataclass(frozen=True, eq=False)
class Footless(InPieces):
    """A support without its feet; the shares of the rest add up to 1."""

    rest: Pieces

    def pieces(self) -> Pieces:
        return self.rest


@cache_results(KEPT)
def separate_feet(support: Any) -> tuple[Array, float, Any]:
    """Feet of a support (x, y, share), the share of the rest, and the rest, or None without one."""
    pieces = support.pieces()
    feet = pieces.atoms
    if not any(map(len, pieces[ATOMS + 1 :])):
        return feet, 0.0, None
    if not len(feet):
        return feet, 1.0, support
    share = 1.0 - float(feet[:, 2].sum())
    bare = pieces._replace(atoms=np.empty((0, 3)))
    return feet, share, Footless(scale_shares(bare, 1.0 / share))


def require_effects(value: Any, outline: Outline | None = None) -> tuple[Any, ...]:
    """Effects in an object's frame that act in a push from rest.

    An object with inertia has no velocity then, and therefore no viscous friction.

    Raises
    ------
    InvalidValue
        If an effect is of another type, a ring has no radius, nothing resists, or parameters are arrays.
    """
    effects = tuple(value) if isinstance(value, (tuple, list)) else ()
    resisting = SupportFriction | Viscous | Inertia
    known = all(isinstance(effect, resisting | Load) for effect in effects)
    if not known or not any(isinstance(effect, resisting) for effect in effects):
        raise InvalidValue(
            "effects", value,
            "a tuple of SupportFriction, Viscous, Inertia and Load, not of loads alone",
            "list what resists the motion of the object; in place of RingFriction give "
            "SupportFriction(support=Ring(radius))",
        )  # fmt: skip
    for effect in effects:
        _require_plain(effect)
    effects = complete_masses(effects, outline)
    moving = any(isinstance(effect, Inertia) for effect in effects)
    return tuple(effect for effect in effects if not (moving and isinstance(effect, Viscous)))


def _require_plain(effect: Any) -> None:
    """Refuse arrays of parameters, rings without a radius, and supports on one point."""
    support = getattr(effect, "support", None)
    if np.ndim(np.array(support, dtype=object)):
        raise InvalidValue("support", support, "one support", "give one support at a time")
    if isinstance(support, Ring) and support.radius is None:
        raise InvalidValue(
            "support", support, "a ring with a radius", "give the radius, as in Ring(1.0)"
        )
    if support is not None:
        extents(support)
    for name in ("weight", "coefficient", "mass", "gyration_radius", "center", "force"):
        value = getattr(effect, name, None)
        if any(map(np.ndim, value if isinstance(value, tuple) else (value,))):
            raise InvalidValue(name, value, "numbers", "give one entry of the array at a time")


def require_friction(effects: Sequence[Effect]) -> None:
    """Refuse loads that friction cannot hold, if there is no inertia; errors as in `require_held`."""
    if not any(isinstance(effect, Load) for effect in effects):
        return
    turned = tuple(
        _load_in_fence(effect, effects) if isinstance(effect, Load) else effect
        for effect in effects
    )
    require_held(Scene(slider=UPRIGHT, contact=PerfectlyRough(), effects=turned))


def _load_in_fence(load: Load, effects: Sequence[Effect]) -> Load:
    """The load in a scene whose body frame is the object's, with x along the normal of the fence."""
    (x, y), (at_x, at_y) = load.force, _load_center(load, effects)
    return Load(force=(-y, x), center=(float(at_x), float(at_y)))


def supports_of(effects: Sequence[Effect]) -> list[Any]:
    """The supports of effects."""
    return [effect.support for effect in effects if isinstance(effect, SupportFriction | Viscous)]


def feet_of(effects: Sequence[Effect]) -> Array:
    """The feet of an object with Coulomb friction, shape (n, 3): x, y, and the friction of each."""
    parts = [np.empty((0, 3))]
    for effect in effects:
        if isinstance(effect, SupportFriction):
            feet, _, _ = separate_feet(effect.support)
            parts.append(np.column_stack([feet[:, :2], feet[:, 2] * float(effect.weight)]))
    return np.concatenate(parts)


def motion_at(twist: Array, points: Array) -> Array:
    """Motion of points of the object; result and points have shape (..., 2)."""
    v_x, v_y, omega = twist
    return np.stack([v_x - omega * points[..., 1], v_y + omega * points[..., 0]], axis=-1)


def resistance(effects: Sequence[Effect], twist: Array, sliding: Array) -> Array:
    """Wrench about the object's origin that sustains a twist, with the friction of the given feet only."""
    total = _of_feet(twist, sliding)
    for effect in effects:
        total = total + without_feet(effect, effects, twist)
    return total


def _of_feet(twist: Array, feet: Array) -> Array:
    """Wrench of the friction of feet, none of which is at rest, along their motion."""
    motion = motion_at(twist, feet[:, :2])
    force = motion * (feet[:, 2] / np.hypot(motion[:, 0], motion[:, 1]))[:, None]
    torque = feet[:, 0] * force[:, 1] - feet[:, 1] * force[:, 0]
    return np.array([*force.sum(axis=0), torque.sum()])


def without_feet(effect: Any, effects: Sequence[Effect], twist: Array) -> Array:
    """Wrench of one effect at twists of shape S + (3,), without the Coulomb friction of feet."""
    if isinstance(effect, Load):
        (x, y), (at_x, at_y) = effect.force, _load_center(effect, effects)
        return -np.array([x, y, at_x * y - at_y * x], dtype=float)
    if isinstance(effect, Inertia):
        # Its radius of gyration is the unit of length, since the ratio to another one has a limited range.
        return wrench(effect, twist, replace(UPRIGHT, radius=effect.gyration_radius))
    if isinstance(effect, Viscous):
        return wrench(effect, twist)
    _, share, rest = separate_feet(effect.support)
    if rest is None:
        return np.zeros(3)
    return wrench(SupportFriction(support=rest, weight=share * effect.weight), twist)


def _load_center(load: Load, effects: Sequence[Effect]) -> Any:
    """Point at which a load acts: by default the center of mass, or of pressure without inertia."""
    if load.center is not None:
        return load.center
    if any(isinstance(effect, Inertia) for effect in effects):
        return mass_center(effects)
    return center_of_pressure(effects)


def center_of_pressure(effects: Sequence[Any]) -> tuple[Number, Number] | None:
    """Center of pressure of Coulomb friction, or else of viscous friction; None without friction."""
    friction = [effect for effect in effects if isinstance(effect, SupportFriction)]
    films = [effect for effect in effects if isinstance(effect, Viscous)]
    loads = [effect.weight for effect in friction] or [effect.coefficient for effect in films]
    points = [effect.support.center_of_pressure for effect in friction or films]
    return _mean_position(loads, points) if loads else None


def mass_center(effects: Sequence[Any]) -> tuple[Number, Number]:
    """Center of mass of effects with inertia, whose centers are known."""
    masses = [effect for effect in effects if isinstance(effect, Inertia)]
    return _mean_position([effect.mass for effect in masses], [effect.center for effect in masses])


def complete_masses(effects: Sequence[Any], outline: Outline | None = None) -> tuple[Any, ...]:
    """Effects in which a mass without a center is at the center of pressure.

    Without friction, it is at the centroid of the outline, or without one at the origin. A mass without a
    radius of gyration is a uniform plate in the shape of the outline; without one the radius is 1.
    """
    masses = [effect for effect in effects if isinstance(effect, Inertia)]
    if all(mass.center is not None and mass.gyration_radius is not None for mass in masses):
        return tuple(effects)
    center = center_of_pressure(effects)
    if center is None:
        center = (0.0, 0.0) if outline is None else centroid_of(outline)
    return tuple(
        (replace(effect, center=center) if effect.center is None else effect).with_gyration(outline)
        if isinstance(effect, Inertia)
        else effect
        for effect in effects
    )


def centroid_of(outline: Outline) -> tuple[float, float]:
    """Centroid of the area of an outline."""
    if outline.corners is None:
        return outline.centroid
    return Polygon(outline.corners).center_of_pressure


def _mean_position(
    loads: list[Number], points: list[tuple[Number, Number]]
) -> tuple[Number, Number]:
    """Mean of points, weighted by loads; numbers, or arrays that are broadcast against one another."""
    are_arrays = any(np.ndim(coordinate) for point in points for coordinate in point)
    if are_arrays or any(map(np.ndim, loads)):
        if not are_arrays and len(set(points)) == 1:
            return points[0]
        total = sum(loads)
        x, y = (
            sum(load * point[i] for load, point in zip(loads, points, strict=True)) / total
            for i in (0, 1)
        )
        return x, y
    sizes = np.array(loads, dtype=float)
    x, y = (sizes @ np.array(points, dtype=float) / sizes.sum()).tolist()
    return x, y
